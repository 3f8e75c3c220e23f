"""Drawings of the report: the case in plan, its loads, the ground in section, governing fields; all as inline SVG."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from groundslab.design.bars.required_bars import bar_fields
from groundslab.design.rules.combinations import ultimate_results
from groundslab.messages import Message, Name, capitalized, joined, words_in
from groundslab.results.results import results_of
from groundslab.views.plots import beams, strips
from groundslab.views.plots.annotations import said_of
from groundslab.views.plots.export import to_inline_svg
from groundslab.views.plots.ground.soil import draw_columns, soil_columns
from groundslab.views.plots.ground.stress import draw_sheet
from groundslab.views.plots.panels import Panel, build_panels, find_extremes, shared_scales
from groundslab.views.plots.plan import draw_mesh
from groundslab.views.plots.request import PlottedCombination, parse_request
from groundslab.views.report.drawings.case_plan import describe_omissions, draw_case_plan
from groundslab.views.report.drawings.load_plan import LoadPlan, plan_base
from groundslab.views.report.drawings.maps import draw_maps
from groundslab.views.translation import translator_of

if TYPE_CHECKING:
    from markupsafe import Markup

    from groundslab.arrays import Array
    from groundslab.languages import Translator
    from groundslab.model.model import Model
    from groundslab.results.results import CombinationResult, Results

#: More columns of soil than these are not drawn.
MOST_COLUMNS = 6
#: Fields of which pictures show the envelopes.
ENVELOPES = ("moment_x", "moment_y")
#: What governs: the field that shows it, what it is called, and its size at each node.
GOVERNS: dict[str, tuple[str, str, Callable[[Array], Array]]] = {
    "settlement": ("settlement", "largest settlement", np.positive),
    "uplift": ("settlement", "largest uplift", np.negative),
    "pressure": ("pressure", "largest contact pressure", np.positive),
    "moment_x": ("moment_x", "largest moment along x", np.abs),
    "moment_y": ("moment_y", "largest moment along y", np.abs),
}

#: What the section forces of beams are called.
FORCES = {
    "moment": "bending moment M", "shear": "shear force V", "torsion": "torsional moment T", "axial": "axial force N",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Drawing:
    """A drawing within the page, and its caption."""

    svg: Markup
    caption: str
    symbols: bool = False  # whether underscores in the caption make subscripts


def draw_case(model: Model, placed: Model, translate: Translator = str) -> Drawing:
    """Return the plan of a case as written, with the loads of the case as solved."""
    caption = joined(("Plan.", *describe_omissions(model)), " ")
    draw = partial(draw_case_plan, model, placed)
    svg = to_inline_svg(draw, "plan", "Plan of the plate", units=model.units, translate=translate)
    return Drawing(svg, words_in(caption, model.units))


def draw_loads(model: Model, placed: Model, translate: Translator = str) -> Iterator[Drawing]:
    """Yield the plan of each load case's loads, without factors; of all loads where there are no cases."""
    base = plan_base(model, placed)
    for number, case in enumerate(model.cases or (None,), 1):
        plan = LoadPlan(base, case)
        if plan.has_loads:
            caption = words_in(plan.describe(), model.units)
            svg = to_inline_svg(plan.draw, f"loads{number}", caption, units=model.units, translate=translate)
            yield Drawing(svg, caption)


def draw_mesh_plan(results: CombinationResult) -> Drawing:
    """Return the plan of the elements."""
    caption = "Mesh: the elements of the plate."
    draw, units = partial(draw_mesh, results, titled=False), results.model.units
    return Drawing(to_inline_svg(draw, "mesh", caption, units=units, translate=translator_of(results)), caption)


def draw_soil(results: CombinationResult) -> Drawing | None:
    """Return the ground in section with the constants of one combination, of many columns the first."""
    combination = PlottedCombination(results.combination, results.limit_state, results, certified=True)
    columns = soil_columns(results.model, [combination])
    known = [column for column in columns if column.depth is not None][:MOST_COLUMNS]
    if not known:
        return None
    draw, units = partial(draw_columns, results.model, known), results.model.units
    return Drawing(to_inline_svg(draw, "soil", "Columns of soil", units=units, translate=translator_of(results)), "")


def draw_stress(results: CombinationResult) -> Drawing | None:
    """Return the vertical stress of one combination in sections through a continuum, None of other ground."""
    if results.ground.cells is None or results.ground.cells.piled:
        return None
    caption = Message(
        "Vertical stress in the ground, without the soil's own weight, of the combination {combination}.",
        combination=Name(results.combination),
    )
    request = parse_request(results_of(results), (), "stress", None, None, None)
    draw, units = partial(draw_sheet, request), results.model.units
    return Drawing(to_inline_svg(draw, "stress", caption, units=units, translate=translator_of(results)), caption)


def draw_beams(combined: Results) -> Iterator[Drawing]:
    """Yield moments and shear forces along the beams, then moments and bars along design strips, some together."""
    if combined.results:
        yield from _draw_members(combined)
        yield from _draw_strips(combined)


def _draw_members(combined: Results) -> Iterator[Drawing]:
    """Yield moments and shear forces along the beams, some beams together."""
    if not (combined.model.members or combined.model.output.beams):
        return
    request = parse_request(combined, (), "beams", None, None, None)
    for number, part in enumerate(beams.batches(beams.curves_along(request)), 1):
        drawn = [words for name, words in FORCES.items() if any(name in beam.values for beam in part)]
        caption = Message(
            "Along {names}: {forces}. The moment is positive, downwards, where the beam sags.",
            names=joined(Name(curves.name) for curves in part),
            forces=joined(drawn),
        )
        draw = partial(beams.draw_curves, request, part, titled=False)
        units, translate = combined.model.units, translator_of(combined)
        yield Drawing(to_inline_svg(draw, f"beams{number}", caption, units=units, translate=translate), caption)


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
    """Yield the governing settlement and contact pressure, moments, and the fields of bars, as small plans.

    Where the plate lifts, its settlement then too. Of several ultimate combinations the moments are their envelopes,
    else those that govern.
    """
    shown, units = [*_governing_panels(combined), *_bar_panels(combined)], combined.model.units
    panels, captions = [panel for panel, _ in shown], [words_in(caption, units) for _, caption in shown]
    maps = draw_maps(combined.solved_model, panels, shared_scales(panels), captions)
    yield from map(Drawing, maps, captions)


def _draw_strips(combined: Results) -> Iterator[Drawing]:
    """Yield mean moments and bars along the design strips of plates, some strips together."""
    for number, part in enumerate(beams.batches(strips.curves_of_strips(combined)), 1):
        template = (
            "Along the strips {names}: mean moment m, and bars A_s along the strip that its mean design moments need, "
            "those at the bottom positive, downwards, over the ultimate combinations."
        )
        caption = Message(template, names=joined(Name(curves.name) for curves in part))
        draw = partial(strips.draw_strips, combined.model, part)
        units, translate = combined.model.units, translator_of(combined)
        yield Drawing(to_inline_svg(draw, f"strips{number}", caption, units=units, translate=translate), caption)


def _governing_panels(combined: Results) -> Iterator[tuple[Panel, str]]:
    """Yield the panels of single combinations and of envelopes, each with its caption."""
    drawn: dict[tuple[str, str], list[str]] = {}
    for what, name in find_governing(combined).items():
        drawn.setdefault((GOVERNS[what][0], name), []).append(GOVERNS[what][1])
    ultimate = [results for results in ultimate_results(combined) if results.combination in combined.results]
    several = len(combined.combinations) > 1
    for (field, name), reasons in drawn.items():
        if field in ENVELOPES and len(ultimate) > 1:
            continue
        (panel,) = build_panels(parse_request(combined, (field,), "plan", name, None, None))
        about = _about(panel)
        if several:
            template = "{about}, {combination}; this combination governs the {reasons}"
            about = Message(template, about=about, combination=Name(name), reasons=joined(reasons, " and "))
        yield panel, _caption(panel, about)
    if len(ultimate) > 1:
        for panel in build_panels(parse_request(combined, ENVELOPES, "plan", None, "ultimate", None)):
            yield panel, _caption(panel, joined((_about(panel), capitalized(panel.source, str.lower)), ": "))


def _bar_panels(combined: Results) -> Iterator[tuple[Panel, str]]:
    """Yield the panels of bars: required, laid if not alike everywhere, used, missing if any are."""
    fields = {name: values for name, values in bar_fields(combined).items() if np.isfinite(values).all()}
    wanted = [
        name
        for name, values in fields.items()
        if not (
            (name.startswith("provided") and np.ptp(values) == 0) or (name.startswith("missing") and not values.any())
        )
    ]
    if wanted:
        for panel in build_panels(parse_request(combined, wanted, "plan", None, None, None)):
            yield panel, _caption(panel, _about(panel))


def _about(panel: Panel) -> str:
    """Return what a panel shows and in which unit."""
    return Message("{title} [{unit}]", title=panel.quantity.title, unit=panel.quantity.field.unit)


def _caption(panel: Panel, about: str) -> str:
    """Return what a panel is about, and its extremes with their places."""
    extremes = [
        said_of(Message(f"{word} {{value:.5g}} at {{place:place m}}", value=value, place=place), whose)
        for word, value, place, whose in find_extremes(panel)
    ]
    facts = capitalized(joined(extremes or ["zero"], "; "))
    return Message("{about}. {facts}.", about=about, facts=facts)
