"""Drawings of the report: the case in plan, the ground in section, governing fields, convergence; all as inline SVG."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from groundslab.results.fields import PLATE_FIELDS
from groundslab.views.plots import plot
from groundslab.views.plots.convergence import draw_thumbnail
from groundslab.views.plots.export import to_inline_svg
from groundslab.views.plots.request import PlottedCombination
from groundslab.views.plots.soil import draw_columns, soil_columns
from groundslab.views.report.case_plan import describe_omissions, draw_case_plan

if TYPE_CHECKING:
    from markupsafe import Markup

    from groundslab.model.model import Model
    from groundslab.results.results import CombinationResult, Results

#: More columns of soil and more histories than these are not drawn.
MOST_COLUMNS, MOST_HISTORIES = 6, 12
#: Which field shows what governs, and what that is called.
FIELDS = {
    "settlement": "settlement", "uplift": "settlement", "pressure": "pressure", "moment_x": "moment_x",
    "moment_y": "moment_y",
}  # fmt: skip
GOVERNS = {
    "settlement": "largest settlement", "uplift": "largest uplift", "pressure": "largest contact pressure",
    "moment_x": "largest moment along x", "moment_y": "largest moment along y",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Drawing:
    """A drawing within the page, and its caption."""

    svg: Markup
    caption: str


def draw_case(model: Model) -> Drawing:
    """Return the plan of a case."""
    caption = " ".join(("Plan.", *describe_omissions(model)))
    return Drawing(to_inline_svg(lambda: draw_case_plan(model), "plan", "Plan of the plate"), caption)


def draw_soil(results: CombinationResult) -> Drawing | None:
    """Return the ground in section with the constants of one combination, of many columns the first."""
    combination = PlottedCombination(results.combination, results.limit_state, results, certified=True)
    columns = soil_columns(results.model, [combination])
    known = [column for column in columns if column.depth is not None][:MOST_COLUMNS]
    if not known:
        return None
    return Drawing(to_inline_svg(lambda: draw_columns(results.model, known), "soil", "Columns of soil"), "")


def draw_histories(several: Sequence[CombinationResult]) -> Iterator[Drawing]:
    """Yield how the iteration went for the first combinations."""
    for number, results in enumerate(several[:MOST_HISTORIES], 1):
        draw = partial(draw_thumbnail, results.steps)
        svg = to_inline_svg(draw, f"history{number}", "Nodes that change sides in each step")
        yield Drawing(svg, results.combination)


def find_governing(combined: Results) -> dict[str, str]:
    """Return which certified combination has the largest settlement, uplift, pressure and moments, by what governs.

    Uplift only if the plate lifts somewhere. Of a moment its size counts.
    """
    wanted: dict[str, Callable[[CombinationResult], float]] = {
        "settlement": lambda results: float(results.plate.settlement.max()),
        "uplift": lambda results: float(-results.plate.settlement.min()),
        "pressure": lambda results: float(results.plate.pressure.max()),
        "moment_x": lambda results: float(np.abs(results.plate.moment_x).max()),
        "moment_y": lambda results: float(np.abs(results.plate.moment_y).max()),
    }
    if not combined.results:
        return {}
    found = {
        what: max(combined.results, key=lambda name: size(combined.results[name])) for what, size in wanted.items()
    }
    if all(results.plate.in_contact.all() for results in combined.results.values()):
        del found["uplift"]
    return found


def draw_pictures(combined: Results) -> Iterator[Drawing]:
    """Yield the governing settlement, contact pressure and moments; where the plate lifts, its settlement then too."""
    drawn: dict[tuple[str, str], list[str]] = {}
    for what, name in find_governing(combined).items():
        drawn.setdefault((FIELDS[what], name), []).append(what)
    several = len(combined.combinations) > 1
    for number, ((field, name), reasons) in enumerate(drawn.items(), 1):
        about = PLATE_FIELDS[field]
        words = " and ".join(GOVERNS[each] for each in reasons)
        governs = f", {name}; this combination governs the {words}" if several else ""
        caption = f"{about.meaning[0].upper()}{about.meaning[1:]}, {about.symbol} [{about.unit}]{governs}."
        svg = to_inline_svg(partial(plot, combined.results[name], field), f"picture{number}", caption)
        yield Drawing(svg, caption)
