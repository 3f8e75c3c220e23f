"""Values along section lines: curves of several combinations in one axes, broken where the section changes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.design.demands.cuts.section_cuts import SectionCut, cut_along
from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import DRAWN_CHORD
from groundslab.messages import Message, Name, counted, joined
from groundslab.results.fields import POINT_FIELDS
from groundslab.views.plots import style, symbols
from groundslab.views.plots.annotations import TitleLine, draw_title, said_of
from groundslab.views.plots.panels import NOT_CERTIFIED
from groundslab.views.plots.request import DOWNWARDS, PlotQuantity
from groundslab.views.tables.quantities import point_values
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.arrays import Array
    from groundslab.languages import Translator
    from groundslab.views.plots.request import PlotRequest, SectionLine

#: Boxes of the curves [mm].
LEFT, HIGH, ABOVE, BELOW = 17.0, 40.0, 9.5, 3.0
#: Key plan beside the words of a line [mm].
KEY_WIDTH, KEY_HEIGHT = 34.0, 20.0
#: Space for the axis below the last box of a line [mm].
AXIS = 9.0


@dataclass(frozen=True, slots=True)
class LineCurves:
    """What is drawn along one line: where samples stand, and values by quantity, one row for each curve."""

    line: SectionLine
    section: SectionCut
    names: tuple[str, ...]  # of the curves
    band: bool  # whether the curves are the largest and the smallest of many
    values: Mapping[str, Array]  # (curves, samples) by name, in units of display


def sample_lines(request: PlotRequest) -> list[LineCurves]:
    """Return the curves along each line; of more combinations than can be facts apart the largest and the smallest.

    Lines that do not meet the plate, but run in an opening, are left out; raises InputError if all of them do.
    """
    curves: list[LineCurves] = []
    missed: list[Issue] = []
    for line in request.lines:
        ends = np.array([line.start, line.end])
        try:
            sections = [cut_along(combination.results.plate, ends) for combination in request.combinations]
        except InputError as error:
            missed += [replace(issue, location=f"line {line.name}".rstrip()) for issue in error.issues]
            continue
        values = [dict(zip(POINT_FIELDS, point_values(section.values), strict=True)) for section in sections]
        names: tuple[str, ...] = tuple(Name(combination.name) for combination in request.combinations)
        rows = {
            quantity.name: quantity.factor * np.stack([value[quantity.name] for value in values])
            for quantity in request.quantities
        }
        band = bool(request.envelope) or len(names) > len(style.CYCLE)
        if band:
            rows = {name: np.stack([values.max(axis=0), values.min(axis=0)]) for name, values in rows.items()}
            names = tuple(_of_several(word, len(names), request.envelope) for word in ("largest", "smallest"))
        curves.append(LineCurves(line, sections[0], names, band, rows))
    if not curves:
        raise InputError(missed)
    return curves


def _of_several(word: str, count: int, state: str) -> str:
    """Return what the largest or the smallest values are taken over."""
    if not state:
        return Message(f"{word} of {{count}} combinations", count=count)
    singular, plural = (f"{word} of {{count}} {{state}} combination{s}" for s in ("", "s"))
    return counted(count, singular, plural, state=state)


def draw_sheet(request: PlotRequest) -> Figure:
    """Return all lines on one sheet."""
    return _figure(request, sample_lines(request))


def draw_pages(request: PlotRequest) -> list[Figure]:
    """Return each line on a page of its own, on several if it has many amounts."""
    rows = max(1, int((style.PAGE_HEIGHT - 50 - KEY_HEIGHT) // (HIGH + ABOVE + BELOW)))
    return [
        _figure(request, [line], quantities)
        for line in sample_lines(request)
        for quantities in style.batch(request.quantities, rows)
    ]


def _figure(
    request: PlotRequest, curves: Sequence[LineCurves], quantities: Sequence[PlotQuantity] | None = None
) -> Figure:
    """Return lines one below the other, of each some amounts."""
    say = words_of(request.combined.model)
    page = style.Page(style.PAGE_WIDTH, say)
    certified = all(combination.certified for combination in request.combinations)
    first = request.combinations[0]
    source = first.words if len(curves[0].names) == 1 and request.names_combinations else ""
    top = page.write_heading(request.combined.model.title, [source], "" if certified else NOT_CERTIFIED)
    legend: dict[str, Any] = {}
    width = style.PAGE_WIDTH - LEFT - style.MARGIN - 3
    for curve in curves:
        top = _draw_key_plan(page, request, curve.line, top)
        shown = quantities or request.quantities
        for row, quantity in enumerate(shown):
            axes = page.add_axes(LEFT, top + ABOVE, width, HIGH)
            legend |= _draw_curves(axes, quantity, curve, say, last=row == len(shown) - 1)
            top += ABOVE + HIGH + BELOW
        top += AXIS - BELOW + 3
    return page.finish(top, legend if len(curves[0].names) > 1 else {})


def _draw_key_plan(page: style.Page, request: PlotRequest, line: SectionLine, top: float) -> float:
    """Write which line it is, and draw a small plan with it on the right; return how far down they reach."""
    model = request.combined.model
    words = style.plain_text(Name(line.name), 80) or "Section line"
    page.write(style.MARGIN, top + 4, words, fontsize=style.BASE + 0.5, fontweight="bold", color=style.INK)
    ends = Message("from {start:place m} to {end:place m}", start=line.start, end=line.end)
    page.write(style.MARGIN, top + 8.2, ends, fontsize=style.SMALL, color=style.GREY)
    axes = page.add_axes(style.PAGE_WIDTH - style.MARGIN - 3 - KEY_WIDTH, top, KEY_WIDTH, KEY_HEIGHT)
    axes.set_axis_off()
    chord = DRAWN_CHORD * max(model.sides)
    for ring in (curve for plate in model.every_plate for curve in plate.rings()):
        symbols.draw_ring(axes, np.array(ring.flat(chord)), edgecolor=style.FAINT, linewidth=0.8)
    axes.annotate(
        "", line.end, line.start, arrowprops={"arrowstyle": "-|>,head_width=0.15,head_length=0.3", "color": style.INK,
                                              "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0},
        annotation_clip=False,
    )  # fmt: skip
    a, b, c, d = model.bounds
    around = 0.04 * max(model.sides)
    axes.set(xlim=(a - around, b + around), ylim=(c - around, d + around), aspect="equal", anchor="NE")
    return top + KEY_HEIGHT - 7.5


def _draw_curves(
    axes: Axes, quantity: PlotQuantity, curves: LineCurves, say: Translator, *, last: bool
) -> dict[str, Any]:
    """Draw one quantity along a line; return the entries in the legend."""
    s, values = curves.section.s, curves.values[quantity.name]
    axes.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=1)
    entries: dict[str, Any] = {}
    parts = curves.section.parts()
    looks = [(style.INK, "-"), (style.INK, "--")] if curves.band else zip(style.CYCLE, style.STROKES, strict=True)
    for name, row, (color, stroke) in zip(curves.names, values, looks, strict=False):
        for part in parts:
            (line,) = axes.plot(s[part], row[part], color=color, linestyle=stroke, linewidth=1.1)
            entries.setdefault(style.plain_text(name, 60), line)
    if curves.band:
        for part in parts:
            axes.fill_between(s[part], values[0, part], values[1, part], color=style.FAINT, linewidth=0, zorder=0.5)
    letters = int((style.PAGE_WIDTH - LEFT) / style.text_width("n", style.SMALL))
    facts = style.plain_text(say(_describe_extremes(quantity, curves)), letters)
    title = TitleLine(quantity.title, style.BASE, style.INK, "bold")
    draw_title(axes, [title, TitleLine(facts, style.SMALL, style.GREY, "normal")])
    axes.set(xlim=(0.0, float(np.hypot(*np.subtract(curves.line.end, curves.line.start)))), ylabel=quantity.label)
    axes.margins(y=0.08)
    if quantity.name in DOWNWARDS:
        axes.invert_yaxis()
    axes.grid(color=style.FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    axes.tick_params(labelbottom=last)
    if last:
        axes.set_xlabel(style.label_of_length("distance s along the line"))
    axes.spines[["top", "right"]].set_visible(False)
    return entries


def _describe_extremes(quantity: PlotQuantity, curves: LineCurves) -> str:
    """Return the extremes over all curves in words, with where along the line they are and whose."""
    values = curves.values[quantity.name]
    facts = []
    for word, where in (("largest", int(values.argmax())), ("smallest", int(values.argmin()))):
        curve, sample = divmod(where, values.shape[1])
        fact = Message(
            f"{word} {{value:number {quantity.field.unit}}} at s = {{s:number m}}",
            value=values[curve, sample], s=curves.section.s[sample],
        )  # fmt: skip
        facts.append(said_of(fact, curves.names[curve] if len(curves.names) > 1 and not curves.band else ""))
    return joined(facts, ";  ")
