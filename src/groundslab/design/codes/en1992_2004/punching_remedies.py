"""What helps where links do not suffice against punching: bars in tension, a thicker slab, or a larger loaded area.

Thickness and area are tried with the forces of the same results, on the same ground: a slab that is solved again with
them has others, mostly a little larger ones under a thicker part.
"""

from __future__ import annotations

from collections.abc import Callable

from groundslab.design.codes.en1992_2004 import punching as en1992
from groundslab.design.codes.en1992_2004.checks.punching_demand import REACH, Demand
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement

#: Thicknesses and sides are larger by multiples of this, and at most by so many of them [m].
STEP, MOST_STEPS = 0.05, 64

#: The largest stress of a demand over the most that links can help against.
Beyond = Callable[[Demand], float]


def ratio_for_links(steel: Reinforcement, demand: Demand, beyond: float) -> float | None:
    """Return the ratio of bars with which v_Rd,c is so many times larger, None if more than those that count."""
    concrete, bars = materials(steel, demand.limit_state)
    ratio = en1992.required_ratio(concrete, demand.d, demand.v_Rd_c * beyond)
    return ratio if ratio <= en1992.most_bars(concrete, bars) else None


def other_remedies(demand: Demand, beyond: Beyond) -> str:
    """Return in words which thickness and which loaded area would do, with the same bars; empty if none is known."""
    thicker = _least(lambda more: demand.changed(more, 0.0), beyond)
    wider = _least(lambda more: demand.changed(0.0, more), beyond)
    sides = wider.around[0].control.widths if wider is not None and wider.around[0].control is not None else None
    if thicker is not None and sides is not None:
        return Message(
            "with the same forces and bars a slab of {thickness:.2f m} as far as {reach:g} d around it would do, or a "
            "loaded area of {a:.2f (m)} x {b:.2f m}",
            thickness=thicker.thickness, reach=REACH, a=sides[0], b=sides[1],
        )  # fmt: skip
    if thicker is not None:
        return Message(
            "with the same forces and bars a slab of {thickness:.2f m} as far as {reach:g} d around it would do",
            thickness=thicker.thickness, reach=REACH,
        )  # fmt: skip
    if sides is not None:
        return Message(
            "with the same forces and bars a loaded area of {a:.2f (m)} x {b:.2f m} would do", a=sides[0], b=sides[1]
        )
    return ""


def _least(change: Callable[[float], Demand | None], beyond: Beyond) -> Demand | None:
    """Return the demand with the least change [m] that links suffice with, None if none does."""

    def tried(steps: int) -> Demand | None:
        changed = change(steps * STEP)
        return changed if changed is not None and beyond(changed) <= 1 else None

    low, high = 0, 1
    while (found := tried(high)) is None:
        low, high = high, 2 * high
        if high > MOST_STEPS:
            return None
    while high - low > 1:
        middle = (low + high) // 2
        better = tried(middle)
        low, high, found = (low, middle, better) if better is not None else (middle, high, found)
    return found
