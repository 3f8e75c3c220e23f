"""Drawings of the report: the case in plan, its loads, the ground in section, governing fields; all as inline SVG."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from groundslab.results.fields import PLATE_FIELDS
from groundslab.views.plots import beams, plot
from groundslab.views.plots.export import to_inline_svg
from groundslab.views.plots.ground.soil import draw_columns, soil_columns
from groundslab.views.plots.plan import draw_mesh
from groundslab.views.plots.request import PlottedCombination, parse_request
from groundslab.views.report import load_plan
from groundslab.views.report.case_plan import describe_omissions, draw_case_plan

if TYPE_CHECKING:
    from markupsafe import Markup

    from groundslab.arrays import Array
    from groundslab.model.model import Model
    from groundslab.results.results import CombinationResult, Results

#: More columns of soil than these are not drawn.
MOST_COLUMNS = 6
#: What governs: the field that shows it, what it is called, and its size at each node.
GOVERNS: dict[str, tuple[str, str, Callable[[Array], Array]]] = {
    "settlement": ("settlement", "largest settlement", np.positive),
    "uplift": ("settlement", "largest uplift", np.negative),
    "pressure": ("pressure", "largest contact pressure", np.positive),
    "moment_x": ("moment_x", "largest moment along x", np.abs),
    "moment_y": ("moment_y", "largest moment along y", np.abs),
}


@dataclass(frozen=True, slots=True)
class Drawing:
    """A drawing within the page, and its caption."""

    svg: Markup
    caption: str


def draw_case(model: Model, placed: Model) -> Drawing:
    """Return the plan of a case as written, with the loads of the case as solved."""
    caption = " ".join(("Plan.", *describe_omissions(model)))
    return Drawing(to_inline_svg(lambda: draw_case_plan(model, placed), "plan", "Plan of the plate"), caption)


def draw_loads(model: Model, placed: Model) -> Iterator[Drawing]:
    """Yield the plan of each load case's loads, without factors; of all loads where there are no cases."""
    for number, case in enumerate(model.cases or (None,), 1):
        if any(map(load_plan.takes_part(model, case), placed.loads)):
            caption = load_plan.describe_loads(model, placed, case)
            draw = partial(load_plan.draw_load_plan, model, placed, case)
            yield Drawing(to_inline_svg(draw, f"loads{number}", caption), caption)


def draw_mesh_plan(results: CombinationResult) -> Drawing:
    """Return the plan of the elements."""
    caption = "Mesh: the elements of the plate."
    return Drawing(to_inline_svg(partial(draw_mesh, results, titled=False), "mesh", caption), caption)


def draw_soil(results: CombinationResult) -> Drawing | None:
    """Return the ground in section with the constants of one combination, of many columns the first."""
    combination = PlottedCombination(results.combination, results.limit_state, results, certified=True)
    columns = soil_columns(results.model, [combination])
    known = [column for column in columns if column.depth is not None][:MOST_COLUMNS]
    if not known:
        return None
    return Drawing(to_inline_svg(lambda: draw_columns(results.model, known), "soil", "Columns of soil"), "")


def draw_stress(results: CombinationResult) -> Drawing | None:
    """Return the vertical stress of one combination in sections through a continuum, None of other ground."""
    if results.ground.cells is None or results.ground.cells.piled:
        return None
    caption = f"Vertical stress in the ground, without the soil's own weight, of the combination {results.combination}."
    return Drawing(to_inline_svg(partial(plot, results, kind="stress"), "stress", caption), caption)


def draw_beams(combined: Results) -> Iterator[Drawing]:
    """Yield moments and shear forces along the beams, some beams together."""
    if not (combined.model.members and combined.results):
        return
    request = parse_request(combined, (), "beams", None, None, None)
    for number, part in enumerate(beams.batches(beams.curves_along(request)), 1):
        names = ", ".join(curves.name for curves in part)
        forces = "shear force, and axial force" if any("axial" in beam.values for beam in part) else "and shear force"
        caption = f"Bending moment, positive downwards where the beam sags, {forces} along {names}."
        draw = partial(beams.draw_curves, request, part, titled=False)
        yield Drawing(to_inline_svg(draw, f"beams{number}", caption), caption)


def find_governing(combined: Results) -> dict[str, str]:
    """Return which certified combination has the largest settlement, uplift, pressure and moments, by what governs.

    Uplift only if the plate lifts somewhere. Of a moment its size counts.
    """
    if not combined.results:
        return {}
    governing = {}
    for what, (field, _, size) in GOVERNS.items():
        largest = {name: size(getattr(results.plate, field)).max() for name, results in combined.results.items()}
        governing[what] = max(largest, key=largest.__getitem__)
    if all(results.plate.in_contact.all() for results in combined.results.values()):
        del governing["uplift"]
    return governing


def draw_pictures(combined: Results) -> Iterator[Drawing]:
    """Yield the governing settlement, contact pressure and moments; where the plate lifts, its settlement then too."""
    drawn: dict[tuple[str, str], list[str]] = {}
    for what, name in find_governing(combined).items():
        drawn.setdefault((GOVERNS[what][0], name), []).append(GOVERNS[what][1])
    several = len(combined.combinations) > 1
    for number, ((field, name), reasons) in enumerate(drawn.items(), 1):
        about = PLATE_FIELDS[field]
        governs = f", {name}; this combination governs the {' and '.join(reasons)}" if several else ""
        caption = f"{about.meaning[0].upper()}{about.meaning[1:]}, {about.symbol} [{about.unit}]{governs}."
        svg = to_inline_svg(partial(plot, combined.results[name], field), f"picture{number}", caption)
        yield Drawing(svg, caption)
