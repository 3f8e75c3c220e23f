"""Section forces along beams of several combinations: moments, shear, torsion, and axial forces where there are any."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.design.bars.members import member_forces
from groundslab.messages import Message, Name
from groundslab.unit_systems import System, in_system, unit_in
from groundslab.units import UNITS
from groundslab.views.plots import style
from groundslab.views.plots.annotations import TitleLine, draw_title
from groundslab.views.plots.panels import NOT_CERTIFIED
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.arrays import Array
    from groundslab.views.plots.request import PlotRequest

#: Boxes of the curves [mm].
LEFT, HIGH, ABOVE, BETWEEN, BELOW = 19.0, 30.0, 12.0, 4.0, 13.0
#: So many beams are on a page, and so many with more than moments and shear forces.
ON_PAGE, ON_PAGE_WITH_MORE = 3, 2
#: What is drawn of each beam: its attribute, its symbol, its unit, and whether positive values point down.
Shown = tuple[str, str, str, bool]
DRAWN: tuple[Shown, ...] = (
    ("moment", "M", "kNm", True), ("shear", "V", "kN", False), ("torsion", "T", "kNm", False),
    ("axial", "N", "kN", False),
)  # fmt: skip
#: Torsion that is less than this share of the moment is not drawn.
LITTLE = 0.02


@dataclass(frozen=True, slots=True)
class BeamCurves:
    """What is drawn of one beam: places along it, and values by what is drawn, one row for each curve."""

    name: str
    way: Array  # (k,) [m]
    values: dict[str, Array]  # (curves, k), in units of display
    names: tuple[str, ...]  # of the curves
    band: bool  # whether the curves are the largest and the smallest of many


def draw_sheet(request: PlotRequest) -> Figure:
    """Return all beams on one sheet."""
    return draw_curves(request, curves_along(request))


def draw_pages(request: PlotRequest) -> list[Figure]:
    """Return the beams on pages."""
    return [draw_curves(request, part) for part in batches(curves_along(request))]


def batches(curves: Sequence[BeamCurves]) -> list[Sequence[BeamCurves]]:
    """Return the beams page by page."""
    return style.batch(curves, ON_PAGE_WITH_MORE if any(len(beam.values) > 2 for beam in curves) else ON_PAGE)


def curves_along(request: PlotRequest) -> list[BeamCurves]:
    """Return the curves of each beam; of more combinations than can be told apart the largest and the smallest."""
    names = tuple(Name(combination.name) for combination in request.combinations)
    band = bool(request.envelope) or len(names) > len(style.CYCLE)
    curves, units = [], request.combined.model.units
    for beams in zip(*(member_forces(combination.results) for combination in request.combinations), strict=True):
        values = {
            name: np.stack([getattr(beam, name) for beam in beams]) * in_system(UNITS[unit], units).scale
            for name, _, unit, _ in DRAWN
        }
        if not values["axial"].any():
            del values["axial"]
        if np.abs(values["torsion"]).max() < LITTLE * np.abs(values["moment"]).max():
            del values["torsion"]
        if band:
            values = {name: np.stack([rows.max(axis=0), rows.min(axis=0)]) for name, rows in values.items()}
        words = (Message("largest of {count} combinations", count=len(names)), "smallest") if band else names
        curves.append(BeamCurves(Name(beams[0].name), beams[0].way, values, words, band))
    return curves


def draw_curves(request: PlotRequest, curves: Sequence[BeamCurves], *, titled: bool = True) -> Figure:
    """Return beams one below the other."""
    page = style.Page(style.PAGE_WIDTH, words_of(request.combined.model))
    top = 0.0
    if titled:
        certified = all(combination.certified for combination in request.combinations)
        top = page.write_heading(request.combined.model.title, ["Beams"], "" if certified else NOT_CERTIFIED)
    return draw_below(page, top, curves, request.combined.model.units, DRAWN, "distance s along the beam")


def draw_below(
    page: style.Page, top: float, curves: Sequence[BeamCurves], units: System, shown: Sequence[Shown], distance: str
) -> Figure:
    """Return curves one below the other, from some way [mm] below the top of a page on."""
    width = style.PAGE_WIDTH - LEFT - style.MARGIN - 3
    legend: dict[str, Any] = {}
    for beam in curves:
        top += ABOVE
        drawn = [quantity for quantity in shown if quantity[0] in beam.values]
        for row, (what, symbol, unit, downwards) in enumerate(drawn):
            label = f"{symbol} [{unit_in(unit, units)[0]}]"
            axes = page.add_axes(LEFT, top, width, HIGH)
            legend |= _draw(axes, beam, what)
            axes.set(xlim=(0.0, float(beam.way[-1])), ylabel=label)
            axes.margins(y=0.08)
            if downwards:
                axes.invert_yaxis()
            if row == 0:
                draw_title(axes, [TitleLine(style.plain_text(beam.name, 80), style.BASE, style.INK, "bold")])
            axes.tick_params(labelbottom=row == len(drawn) - 1)
            top += HIGH + BETWEEN
        axes.set_xlabel(style.label_of_length(distance))
        top += BELOW - BETWEEN
    return page.finish(top, legend if any(len(beam.names) > 1 for beam in curves) else {})


def _draw(axes: Axes, beam: BeamCurves, what: str) -> dict[str, Any]:
    """Draw one section force along a beam; return the entries in the legend."""
    axes.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=1)
    looks = [(style.INK, "-"), (style.INK, "--")] if beam.band else zip(style.CYCLE, style.STROKES, strict=True)
    entries: dict[str, Any] = {}
    for name, values, (color, stroke) in zip(beam.names, beam.values[what], looks, strict=False):
        # where a value jumps both stand at one place, so that the line goes straight from one to the other
        (line,) = axes.plot(beam.way, values, color=color, linestyle=stroke, linewidth=1.1)
        entries[style.plain_text(name, 60)] = line
    if beam.band:
        axes.fill_between(beam.way, *beam.values[what], color=style.FAINT, linewidth=0, zorder=0.5)
    axes.grid(color=style.FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    return entries
