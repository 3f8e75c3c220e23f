"""What helps where links do not suffice against punching: bars in tension, a thicker slab, or a larger loaded area.

Thickness and area are tried with the forces of the same results, on the same ground: a slab that is solved again with
them has others, mostly a little larger ones under a thicker part.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from groundslab.design.codes.en1992_2004 import punching as en1992
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.messages import Message

#: Thicknesses and sides are larger by multiples of this, and at most by so many of them [m].
STEP, MOST_STEPS = 0.05, 64

Demand = TypeVar("Demand")


def ratio_for_links(concrete: Concrete, bars: Steel, d: float, v_Rd_c: float) -> float | None:
    """Return the ratio of bars with which v_Rd,c is so large [Pa], None if more than those that count."""
    ratio = en1992.required_ratio(concrete, d, v_Rd_c)
    return ratio if ratio <= en1992.most_bars(concrete, bars) else None


def least_change(change: Callable[[float], Demand | None], beyond: Callable[[Demand], float]) -> Demand | None:
    """Return the demand with the least change [m] that links suffice with, None if none does.

    Parameters
    ----------
    change : callable
        Of a change [m]: the demand with it, None where there is none.
    beyond : callable
        Of a demand: its largest stress over the most that links can help against.
    """

    def tried(steps: int) -> Demand | None:
        changed = change(steps * STEP)
        return changed if changed is not None and beyond(changed) <= 1 else None

    low, high = 0, 1
    while (demand := tried(high)) is None:
        low, high = high, 2 * high
        if high > MOST_STEPS:
            return None
    while high - low > 1:
        middle = (low + high) // 2
        better = tried(middle)
        low, high, demand = (low, middle, better) if better is not None else (middle, high, demand)
    return demand


def in_words(thickness: float | None, sides: tuple[float, float] | None, reach: float) -> str:
    """Return which thickness [m], as far as so many d around, and which sides of a loaded area [m] would do."""
    if thickness is not None and sides is not None:
        return Message(
            "with the same forces and bars a slab of {thickness:.2f m} as far as {reach:g} d around it would do, or a "
            "loaded area of {a:.2f (m)} x {b:.2f m}",
            thickness=thickness, reach=reach, a=sides[0], b=sides[1],
        )  # fmt: skip
    if thickness is not None:
        return Message(
            "with the same forces and bars a slab of {thickness:.2f m} as far as {reach:g} d around it would do",
            thickness=thickness, reach=reach,
        )  # fmt: skip
    if sides is not None:
        return Message(
            "with the same forces and bars a loaded area of {a:.2f (m)} x {b:.2f m} would do", a=sides[0], b=sides[1]
        )
    return ""
