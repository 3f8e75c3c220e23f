"""Mean moments along design strips, and the bars along them that they need, over the ultimate combinations."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.design.bars.required_bars import areas_for
from groundslab.design.demands.cuts.section_cuts import StripResult, strip
from groundslab.design.demands.design_moments import DesignMoments
from groundslab.design.rules.combinations import ultimate_results
from groundslab.errors import InputError
from groundslab.messages import Message, Name
from groundslab.model.design.averaging import along_axis
from groundslab.unit_systems import in_system
from groundslab.units import UNITS
from groundslab.views.plots import style
from groundslab.views.plots.beams import BeamCurves, Shown, draw_below
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from groundslab.arrays import Array
    from groundslab.model.model import Model
    from groundslab.model.outputs import OutputStrip
    from groundslab.results.results import CombinationResult, Results

#: What is drawn of each strip: its name among the values, its symbol, its unit, and that positive values point down.
DRAWN: tuple[Shown, ...] = (("moment", "m", "kNm/m", True), ("bars", "A_s", "cm2/m", True))


def curves_of_strips(combined: Results) -> list[BeamCurves]:
    """Return the largest and smallest mean moment along each strip of a plate, and its bars where the case has steel.

    Bars at the bottom are positive, those at the top negative; of strips at an angle to x and y they are not known.
    """
    results = ultimate_results(combined)
    curves = list[BeamCurves]()
    for output in combined.model.output.strips if results else ():
        if output.design == "beam":
            continue
        try:
            cuts = [
                strip(solved.plate, output.start, output.end, output.width, output.stations) for solved in results
            ]  # fmt: skip
        except InputError:
            continue  # it does not cross the plate
        means = np.stack([cut.mean_moment for cut in cuts])
        values = {"moment": np.stack([means.max(axis=0), means.min(axis=0)])}
        bars = _bars(combined, results, output, cuts)
        if bars is not None and np.isfinite(bars).all():
            values["bars"] = bars
        units = {name: in_system(UNITS[unit], combined.model.units).scale for name, _, unit, _ in DRAWN}
        words = (Message("largest of {count} combinations", count=len(results)), "smallest")
        shown = {name: rows * units[name] for name, rows in values.items()}
        curves.append(BeamCurves(Name(output.name), cuts[0].s, shown, words, band=True))
    return curves


def draw_strips(model: Model, curves: Sequence[BeamCurves]) -> Figure:
    """Return strips one below the other."""
    page = style.Page(style.PAGE_WIDTH, words_of(model))
    return draw_below(page, 0.0, curves, model.units, DRAWN, "distance s along the strip")


def _bars(
    combined: Results, results: list[CombinationResult], output: OutputStrip, cuts: list[StripResult]
) -> Array | None:
    """Return the bars along a strip at the bottom, and those at the top as negative (2, c) [m2/m]."""
    from scipy.spatial import cKDTree

    steel = combined.model.reinforcement
    axis = along_axis(output)
    if steel is None or axis is None:
        return None
    along, across = ("x", "y") if axis == 0 else ("y", "x")
    areas = []
    for solved, cut in zip(results, cuts, strict=True):
        node = cKDTree(solved.plate.nodes).query(np.column_stack([cut.x, cut.y]))[1]
        thickness = solved.elements.at_nodes(solved.plate)[0][node]
        moments = DesignMoments(
            **{f"bottom_{along}": cut.bottom, f"top_{along}": cut.top},
            **{f"bottom_{across}": cut.bottom_across, f"top_{across}": cut.top_across},
        )
        needed = areas_for(moments, thickness, steel, solved.limit_state)
        areas.append([getattr(needed, f"bottom_{along}"), -getattr(needed, f"top_{along}")])
    bottom, top = np.swapaxes(np.array(areas), 0, 1)
    return np.stack([bottom.max(axis=0), top.min(axis=0)])
