"""The words above a panel: what it shows, its extremes with their places, how much of the plate is in contact."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from groundslab.results.contact_zone import goes_below_zero
from groundslab.views.plots.panels import View, extremes_of
from groundslab.views.plots.style import BASE, GREY, INK, PT, SMALL, at, free, number, width_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Words(NamedTuple):
    """A line of words and how it is written."""

    text: str
    size: float
    colour: str
    weight: str


def head_of(view: View, width: float, *, tell: bool) -> list[Words]:
    """Return the lines above a plan: of what it is if that is to be told, what it shows, its extremes, the contact."""
    uplift = view.amount.name == "settlement" and goes_below_zero(view.values)
    told = []
    for word, value, where, whose in extremes_of(view):
        called, shown = ("uplift", -value) if uplift and word == "smallest" else (word, value)
        governs = f" ({free(whose, 40)})" if whose else ""
        told.append(f"{called} {number(shown)} {view.amount.unit} at {at(where)}{governs}")
    if not told:
        told.append("zero everywhere")
    if view.line_force is not None:
        told.append(f"edge line force up to {number(view.line_force[0])} kN/m at {at(view.line_force[1])}")
    if view.amount.name in ("pressure", "gap") and view.share is not None:
        told.append(f"{number(100 * view.share)} % of the plate in contact")
    title = view.amount.meaning[0].upper() + view.amount.meaning[1:]
    lines = [Words(each, BASE, GREY, "bold") for each in (_wrapped(view.of, width) if tell else [])]
    lines += [Words(each, BASE, INK, "bold") for each in _wrapped(title, width)]
    return [*lines, *(Words(each, SMALL, GREY, "normal") for each in _joined(told, width))]


def room_above(head: Sequence[Words]) -> float:
    """Return how much room [mm] lines above a plan take."""
    return 3.0 + sum(1.3 * line.size * PT for line in head)


def write_above(axes: Axes, head: Sequence[Words]) -> None:
    """Write lines above a plan."""
    height = 1.6
    for line in reversed(head):
        axes.annotate(
            line.text, (0, 1), xycoords="axes fraction", xytext=(0, height / PT), textcoords="offset points",
            fontsize=line.size, color=line.colour, fontweight=line.weight, va="baseline", parse_math=False,
        )  # fmt: skip
        height += 1.3 * line.size * PT


def _wrapped(words: str, width: float) -> list[str]:
    """Return bold words in at most two lines that are not wider than a width [mm]."""
    clean = free(words, 500)
    letters = int(len(clean) * min(1.0, width / max(width_of(clean, BASE, "bold"), 1e-9))) + 1
    lines = clean.splitlines()
    while letters > 8 and any(width_of(line, BASE, "bold") > width for line in lines):
        lines = free(clean, letters, 2).splitlines()
        letters -= 1
    return lines


def _joined(parts: Sequence[str], width: float) -> list[str]:
    """Return parts joined on as few lines as they need in a width [mm]."""
    lines = [parts[0]]
    for part in parts[1:]:
        longer = f"{lines[-1]};  {part}"
        if width_of(longer, SMALL) <= width:
            lines[-1] = longer
        else:
            lines.append(part)
    return lines
