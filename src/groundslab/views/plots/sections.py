"""Values along section lines: curves of several combinations in one axes, broken where the section changes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.design.envelope import envelope
from groundslab.design.section_cuts import SectionCut, along
from groundslab.design.tables.quantities import listed
from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import DRAWN_CHORD
from groundslab.results.fields import POINT_FIELDS
from groundslab.views.plots import symbols
from groundslab.views.plots.amounts import DOWNWARDS, Amount
from groundslab.views.plots.heads import Words, write_above
from groundslab.views.plots.panels import NOT_CERTIFIED
from groundslab.views.plots.paper import MARGIN, PAGE_HEIGHT, PAGE_WIDTH, Paper
from groundslab.views.plots.style import BASE, CYCLE, FAINT, GREY, INK, SMALL, STROKES, at, free, number, width_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.arrays import Array
    from groundslab.views.plots.request import Cut, Drawn, Wish

#: Boxes of the curves [mm].
LEFT, HIGH, ABOVE, BELOW = 17.0, 40.0, 9.5, 3.0
#: Key plan beside the words of a line [mm].
KEY_WIDTH, KEY_HEIGHT = 34.0, 20.0
#: Room for the axis below the last box of a line [mm].
AXIS = 9.0


@dataclass(frozen=True, slots=True)
class Curves:
    """What is drawn along one line: where samples stand, and values by amount, one row for each curve."""

    cut: Cut
    section: SectionCut
    names: tuple[str, ...]  # of the curves
    band: bool  # whether the curves are the largest and the smallest of many
    values: Mapping[str, Array]  # (curves, samples) by name, in units of display


def curves_of(wish: Wish) -> list[Curves]:
    """Return the curves along each line; of more combinations than can be told apart the largest and the smallest.

    Lines that do not meet the plate, but run in an opening, are left out; raises InputError if all of them do.
    """
    found: list[Curves] = []
    missed: list[Issue] = []
    for cut in wish.cuts:
        try:
            sections = [along(each.results.plate, np.array([cut.start, cut.end])) for each in wish.drawn]
        except InputError as error:
            missed += [replace(issue, location=f"line {cut.name}".rstrip()) for issue in error.issues]
            continue
        values = [dict(zip(POINT_FIELDS, listed(section.values), strict=True)) for section in sections]
        names = tuple(each.name for each in wish.drawn)
        rows = {amount.name: np.stack([each[amount.name] for each in values]) for amount in wish.amounts}
        band = bool(wish.envelope) or len(names) > len(CYCLE)
        if band:
            rows = {name: _extremes(names, each) for name, each in rows.items()}
            names = tuple(f"{word} of {_many(wish.drawn, wish.envelope)}" for word in ("largest", "smallest"))
        found.append(Curves(cut, sections[0], names, band, rows))
    if not found:
        raise InputError(missed)
    return found


def _extremes(names: Sequence[str], rows: Array) -> Array:
    """Return the largest and the smallest value of each sample, (2, samples), from (combinations, samples)."""
    found = envelope(dict(zip(names, rows, strict=True)))
    return np.stack([found.greatest, found.least])


def _many(drawn: Sequence[Drawn], state: str) -> str:
    return f"{len(drawn)} {state + ' ' if state else ''}combination{'s' if len(drawn) > 1 else ''}"


def sheet(wish: Wish) -> Figure:
    """Return all lines on one sheet."""
    return _figure(wish, curves_of(wish))


def pages(wish: Wish) -> list[Figure]:
    """Return each line on a page of its own, on several if it has many amounts."""
    rows = max(1, int((PAGE_HEIGHT - 50 - KEY_HEIGHT) // (HIGH + ABOVE + BELOW)))
    return [
        _figure(wish, [each], wish.amounts[first : first + rows])
        for each in curves_of(wish)
        for first in range(0, len(wish.amounts), rows)
    ]


def _figure(wish: Wish, curves: Sequence[Curves], amounts: Sequence[Amount] | None = None) -> Figure:
    """Return lines one below the other, of each some amounts."""
    paper = Paper(PAGE_WIDTH)
    certified = all(each.certified for each in wish.drawn)
    of = "" if len(curves[0].names) > 1 or not wish.several else f"{wish.drawn[0].name} ({wish.drawn[0].limit_state})"
    top = paper.head(wish.combined.model.title, [of], "" if certified else NOT_CERTIFIED)
    legend: dict[str, Any] = {}
    width = PAGE_WIDTH - LEFT - MARGIN - 3
    for each in curves:
        top = _key(paper, wish, each.cut, top)
        shown = amounts or wish.amounts
        for row, amount in enumerate(shown):
            axes = paper.axes(LEFT, top + ABOVE, width, HIGH)
            legend |= _panel(axes, amount, each, last=row == len(shown) - 1)
            top += ABOVE + HIGH + BELOW
        top += AXIS - BELOW + 3
    return paper.finish(top, legend if len(curves[0].names) > 1 else {})


def _key(paper: Paper, wish: Wish, cut: Cut, top: float) -> float:
    """Write which line it is, and draw a small plan with it on the right; return how far down they reach."""
    model = wish.combined.model
    words = free(cut.name, 80) or "Section line"
    paper.text(MARGIN, top + 4, words, fontsize=BASE + 0.5, fontweight="bold", color=INK)
    paper.text(MARGIN, top + 8.2, f"from {at(cut.start)} to {at(cut.end)}", fontsize=SMALL, color=GREY)
    axes = paper.axes(PAGE_WIDTH - MARGIN - 3 - KEY_WIDTH, top, KEY_WIDTH, KEY_HEIGHT)
    axes.set_axis_off()
    chord = DRAWN_CHORD * max(model.plate.sides)
    for ring in (model.plate.ring(), *(opening.ring() for opening in model.plate.openings)):
        symbols.ghost(axes, ring, chord)
    (x0, y0), (x1, y1) = cut.start, cut.end
    axes.annotate(
        "", (x1, y1), (x0, y0), arrowprops={"arrowstyle": "-|>,head_width=0.15,head_length=0.3", "color": INK,
                                            "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0},
        annotation_clip=False,
    )  # fmt: skip
    a, b, c, d = model.plate.bounds
    around = 0.04 * max(model.plate.sides)
    axes.set(xlim=(a - around, b + around), ylim=(c - around, d + around), aspect="equal", anchor="NE")
    return top + KEY_HEIGHT - 7.5


def _panel(axes: Axes, amount: Amount, curves: Curves, *, last: bool) -> dict[str, Any]:
    """Draw one amount along a line; return the entries in the legend."""
    s, values = curves.section.s, curves.values[amount.name]
    axes.axhline(0.0, color=GREY, linewidth=0.6, zorder=1)
    entries: dict[str, Any] = {}
    parts = curves.section.parts()
    for number_, name in enumerate(curves.names):
        colour, stroke = (INK, ("-", "--")[number_]) if curves.band else (CYCLE[number_], STROKES[number_])
        for part in parts:
            (line,) = axes.plot(s[part], values[number_, part], color=colour, linestyle=stroke, linewidth=1.1)
            entries.setdefault(free(name, 60), line)
    if curves.band:
        for part in parts:
            axes.fill_between(s[part], values[0, part], values[1, part], color=FAINT, linewidth=0, zorder=0.5)
    title = amount.meaning[0].upper() + amount.meaning[1:]
    told = free(_told(amount, curves), int((PAGE_WIDTH - LEFT) / width_of("n", SMALL)))
    write_above(axes, [Words(title, BASE, INK, "bold"), Words(told, SMALL, GREY, "normal")])
    axes.set(xlim=(0.0, float(np.hypot(*np.subtract(curves.cut.end, curves.cut.start)))), ylabel=amount.label)
    axes.margins(y=0.08)
    if amount.name in DOWNWARDS:
        axes.invert_yaxis()
    axes.grid(color=FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    axes.tick_params(labelbottom=last)
    if last:
        axes.set_xlabel("distance s along the line [m]")
    for spine in ("top", "right"):
        axes.spines[spine].set_visible(False)
    return entries


def _told(amount: Amount, curves: Curves) -> str:
    """Return the extremes over all curves in words, with where along the line they are and whose."""
    values = curves.values[amount.name]
    told = []
    for word, where in (("largest", int(values.argmax())), ("smallest", int(values.argmin()))):
        curve, sample = divmod(where, values.shape[1])
        place = f"at s = {number(curves.section.s[sample])} m"
        whose = f" ({curves.names[curve]})" if len(curves.names) > 1 and not curves.band else ""
        told.append(f"{word} {number(values[curve, sample])} {amount.unit} {place}{whose}")
    return ";  ".join(told)
