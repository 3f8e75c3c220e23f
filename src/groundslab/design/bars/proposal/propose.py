"""Bars proposed for a slab by what its results require, in the form of the case's own bars."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.bars.beam_bars import strip_areas
from groundslab.design.bars.proposal.beam_links import beam_links
from groundslab.design.bars.proposal.layer_bars import LayerProposal, LayerTask, propose_layer
from groundslab.design.bars.proposal.links import needs_of_links, punching_links
from groundslab.design.bars.proposal.plan_grid import CellValues, locate_cells, make_grid, symmetric_axes
from groundslab.design.bars.required_bars import largest_areas, required_areas
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.check import some
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.demand_errors import moment_errors
from groundslab.design.rules.design_code import DesignCode
from groundslab.design.rules.detailing_rule import DetailingRule
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.errors import GroundslabError, InputError, Issue
from groundslab.messages import Message
from groundslab.model.design.bars import BarZone
from groundslab.model.design.beam_links import BeamLinks
from groundslab.model.design.detailing import Detailing, allowed_bars
from groundslab.model.design.laid_bars import axis_of, bar_area, laid_bars, polygon_of
from groundslab.model.design.punching_links import PunchingLinks
from groundslab.model.design.reinforcement import Reinforcement, axes_by_cover
from groundslab.model.model import Model
from groundslab.model.plates.region import get_plate_region
from groundslab.results.fields import LAYERS, place_of
from groundslab.results.results import CombinationResult, Results
from groundslab.schema.issues import require

#: Proposals one after the other, as bars lie deeper than was counted on.
MOST_ROUNDS = 10
#: A face may be in tension where its moment is less than this share of the largest one on the other side of none.
NEAR_TENSION = 0.02
#: The checks at columns that links are for, by the codes.
PUNCHING = ("punching within 2 d", "punching", "two-way shear")
#: What counts as rounding, relative.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class BarProposal:
    """Bars that are proposed for a slab.

    Attributes
    ----------
    model : Model
        The case with these bars in place of its own, and with detailing.
    required : dict of str to float
        By layer, what is required at the points of the mesh over the plan, without minimum where a face is surely
        never in tension [m3].
    with_least : dict of str to float
        By layer, the same with the code's least area at every point, in tension or not [m3].
    laid : dict of str to float
        By layer, the steel of base and zones over the plan, anchorage of zones included, laps not [m3].
    links : tuple of LinkLayout
        Links against punching that these bars leave necessary, as the case gives them; with the reason where none can
        be laid.
    remarks : tuple of str
        What a proposal could not keep to, or what was not looked at.
    """

    model: Model
    required: dict[str, float]
    with_least: dict[str, float]
    laid: dict[str, float]
    links: tuple[LinkLayout, ...] = ()
    remarks: tuple[str, ...] = ()

    @property
    def reinforcement(self) -> Reinforcement:
        """Return the reinforcement of the case with these bars."""
        assert self.model.reinforcement is not None
        return self.model.reinforcement


def propose_in_layers(results: Results) -> BarProposal:
    """Propose bars in all layers, links against punching, and links of beams; InputError if none are enough."""
    require(results, Results, name="results")
    steel, code = _steel_and_code(results)
    rule, plate = code.detailing, ultimate_results(results)[0].plate
    assert rule is not None
    plan = get_plate_region(results.model.plate, results.model.plates).area
    cells_of = cache(lambda folded: locate_cells(make_grid(plan, steel.proposal.rounding, folded), plate))
    needs = _requirements(results, steel)
    axes = {layer: axis_of(steel, layer) for layer in LAYERS}
    with_fewer, for_links = None, list[str]()
    for _ in range(MOST_ROUNDS):
        layers, remarks = dict[str, LayerProposal](), list[str]()
        folded = _symmetric(results, steel, needs)
        for layer in LAYERS:
            task = _task(results, steel, layer, needs[layer], rule, cells_of(folded[layer]))
            task = replace(task, farthest=partial(_farthest, steel, rule, axes[layer]))
            proposed, missed = _propose(task, layer, steel, rule)
            remarks += missed
            if proposed is None and with_fewer is not None:
                return with_fewer
            layers[layer] = proposed or _refuse(layer, needs[layer], plate.nodes, steel, rule)
        reinforcement = _with_bars(steel, layers)
        more = _requirements(results, reinforcement)
        deeper = {layer: max(axes[layer], axis_of(reinforcement, layer)) for layer in LAYERS}
        if _enough(reinforcement, more, plate.nodes) and (_near(reinforcement, rule) or deeper == axes):
            laid = _laid(results, reinforcement)
            proposal = _proposal(laid, reinforcement, more, [*remarks, *_remarks(results, rule), *for_links])
            # what punches depends on bars, not on links: it is found once for both
            if with_fewer is not None or not (asked := needs_of_links(laid)).of:
                return proposal
            template = "bars at {names} are more than bending needs, so that links suffice there against punching"
            with_fewer, for_links = proposal, [Message(template, names=some(asked.of))]
            more = {layer: np.maximum(more[layer], asked.areas[layer]) for layer in LAYERS}
        # bars lie deeper than those whose depths were counted on, or links take more of them
        needs, axes = {layer: np.maximum(needs[layer], more[layer]) for layer in LAYERS}, deeper
    raise GroundslabError(f"no bars were found whose depths are those counted on, in {MOST_ROUNDS} proposals")


def _symmetric(results: Results, steel: Reinforcement, needs: dict[str, Array]) -> dict[str, tuple[bool, bool]]:
    """Return about the middle of which axes what is needed (n,) [m2/m] by layer mirrors itself.

    What any base has, the least area of the thinnest part of the slab, is of no account.
    """
    plan, first = get_plate_region(results.model.plate, results.model.plates).area, ultimate_results(results)[0]
    least = _least_areas(first, steel)
    beyond = {layer: np.maximum(needs[layer], least[layer].min()) for layer in LAYERS}
    return symmetric_axes(plan, first.plate, beyond)


def _propose(
    task: LayerTask, layer: str, steel: Reinforcement, rule: DetailingRule
) -> tuple[LayerProposal | None, Sequence[str]]:
    """Return the bars of a layer, None if none are enough, and what they could not keep to."""
    name, every = layer.replace("_", " "), _diameters(steel, layer, rule, crossing=True)
    thick, far = replace(task, diameters=every), replace(task, farthest=_no_limit)
    crossing = Message("{name}: the axes leave no room for bars so thick to cross others", name=name)
    apart = Message(
        "{name}: bars are farther apart than cracks allow, as none of those that may be proposed are near enough",
        name=name,
    )
    for attempt, missed in (
        (task, []), (thick, [crossing]), (far, [apart]), (replace(far, diameters=every), [crossing, apart])
    ):  # fmt: skip
        proposed = propose_layer(attempt, steel, rule)
        if proposed is not None:
            return proposed, missed
    return None, []


def _farthest(steel: Reinforcement, rule: DetailingRule, axis: float, diameter: float) -> float:
    """Return the largest distance of bars for cracks [m], their axis [m] being that far from the face."""
    return math.inf if rule.crack_spacing is None else rule.crack_spacing(steel, axis - diameter / 2)


def _no_limit(_: float) -> float:
    """Return that bars may be as far apart as they like."""
    return math.inf


def _enough(reinforcement: Reinforcement, needs: dict[str, Array], nodes: Array) -> bool:
    """Return whether bars are as much as is needed (n,) [m2/m] by layer."""
    laid = {layer: laid_bars(reinforcement, layer, nodes) for layer in LAYERS}
    return all((needs[layer] <= laid[layer].area * (1 + ROUNDING)).all() for layer in LAYERS)


def _near(reinforcement: Reinforcement, rule: DetailingRule) -> bool:
    """Return whether the bars of all bases are near enough for cracks where they lie."""
    bases = {layer: reinforcement.base_bars(layer) for layer in LAYERS}
    return all(
        bars is None
        or bars.spacing <= _farthest(reinforcement, rule, axis_of(reinforcement, layer), bars.diameter) + ROUNDING
        for layer, bars in bases.items()
    )


def _steel_and_code(results: Results) -> tuple[Reinforcement, DesignCode]:
    """Return the reinforcement of a case and its code, if bars can be proposed by them."""
    steel = results.model.reinforcement
    if steel is None:
        raise InputError([Issue("reinforcement", "nothing", "[reinforcement] with concrete, steel and axes or cover")])
    if not ultimate_results(results):
        hint = 'such as combine.sets = ["ultimate"]'
        raise InputError([Issue("combinations", "no ultimate one with results", "one at least", hint)])
    code = code_of(steel)
    if code.detailing is None:
        raise InputError([Issue("reinforcement.code", code.name, "a code with rules for anchorage")])
    return steel.replace(proposal=allowed_bars(steel.proposal, results.model.units)), code


def _requirements(results: Results, steel: Reinforcement) -> dict[str, Array]:
    """Return what bending and the minimum require (n,) [m2/m] by layer over the ultimate combinations.

    The minimum is required where a face may be in tension, as on another mesh it may be.
    """
    required = required_areas(steel, ultimate_results(results))
    plate = ultimate_results(results)[0].plate
    rule = code_of(steel).detailing
    assert rule is not None
    of_strips = strip_areas(results, steel, plate.nodes)
    needs = {}
    for layer in LAYERS:
        needs[layer] = np.maximum(largest_areas(required, layer)[0], of_strips[layer])
        if np.isinf(needs[layer]).any():
            _refuse(layer, needs[layer], plate.nodes, steel, rule)
    for result in ultimate_results(results):
        least, tension = _least_areas(result, steel), _may_be_in_tension(result)
        for layer in LAYERS:
            needs[layer] = np.maximum(needs[layer], np.where(tension[layer], least[layer], 0.0))
    return needs


def _least_areas(result: CombinationResult, steel: Reinforcement) -> dict[str, Array]:
    """Return the minimum (n,) [m2/m] by layer."""
    thickness, _ = result.elements.at_nodes(result.plate)
    minimum = code_of(steel).bending(steel, result.limit_state).minimum
    return {layer: minimum(thickness - axis_of(steel, layer), thickness) for layer in LAYERS}


def _may_be_in_tension(result: CombinationResult) -> dict[str, Flags]:
    """Return where moments of a face, or their errors, may put it in tension (n,), by layer."""
    plate, errors = result.plate, moment_errors(result)
    where = {}
    for layer in LAYERS:
        name = f"moment_{layer[-1]}"
        moment, twist = getattr(plate, name), np.abs(plate.moment_xy)
        tension = (moment if layer.startswith("bottom") else -moment) + twist
        margin = errors[name] + NEAR_TENSION * float((np.abs(moment) + twist).max())
        where[layer] = np.asarray(tension + margin > 0)
    return where


def _refuse(layer: str, needs: Array, nodes: Array, steel: Reinforcement, rule: DetailingRule) -> LayerProposal:
    """Raise InputError for a layer that no bars are enough for."""
    node = int(np.argmax(needs))
    x, y = place_of(nodes, node)
    where = f"{layer.replace('_', ' ')} at ({x:.3f}, {y:.3f}) m"
    if np.isinf(needs[node]):
        raise InputError([Issue(where, "concrete too weak for any bars", "a thicker slab, or stronger concrete")])
    most = max(_diameters(steel, layer, rule, crossing=True)) * 1e3
    hint = Message(
        "cover and axes leave room for {most:g mm}; allow smaller spacings or more zones in reinforcement.proposal",
        most=most,
    )
    area = Message("{needs:.4g cm2/m} required", needs=needs[node] * 1e4)
    raise InputError([Issue(where, area, "bars of reinforcement.proposal that are as much", hint)])


def _task(
    results: Results,
    steel: Reinforcement,
    layer: str,
    needs: Array,
    rule: DetailingRule,
    cells: CellValues,
) -> LayerTask:
    """Return what the bars of a layer are chosen for, with what they need (n,) [m2/m] at the nodes without cracks."""
    first = ultimate_results(results)[0]
    thickness = first.elements.at_nodes(cells.plate)[0]
    farthest = rule.spacing(steel, float(thickness.min()))
    spacings = tuple(s for s in steel.proposal.spacings if s <= farthest + ROUNDING)
    if not spacings:
        hint = Message("at most {spacing:.4g mm} is allowed", spacing=farthest * 1e3)
        raise InputError([Issue("reinforcement.proposal.spacings", "none that the code allows", "smaller ones", hint)])
    axis = "xy".index(layer[-1])

    def along(of_nodes: Array) -> Array:
        largest = cells.largest(of_nodes, axis)
        return largest if axis == 0 else largest.T

    without_cracks = along(needs)

    @cache
    def of_cells(diameter: float, spacing: float) -> Array:
        if rule.crack_area is None:
            return without_cracks
        of_cracks = rule.crack_area(results, steel, layer, diameter, spacing)
        return along(np.maximum(needs, of_cracks)) if (of_cracks > needs).any() else without_cracks

    return LayerTask(
        grid=cells.grid,
        needs=of_cells,
        thickness=along(thickness),
        axis=axis,
        distance=axis_of(steel, layer),
        at_top=layer.startswith("top"),
        diameters=_diameters(steel, layer, rule),
        spacings=spacings,
        # of the thinnest part, so that zones are few
        least=float(_least_areas(first, steel)[layer].min()) if needs.any() else 0.0,
    )


def _diameters(steel: Reinforcement, layer: str, rule: DetailingRule, *, crossing: bool = False) -> tuple[float, ...]:
    """Return the diameters of the proposal that fit a layer: with their cover, and between both layers of the face.

    If the axes leave no room for any, the least one. `crossing` is whether bars may be too thick for both layers.
    """
    face = layer.split("_")[0]
    axes: tuple[float, float] | None = getattr(steel, face)
    diameters = steel.proposal.diameters
    allowed = []
    for diameter in diameters:
        least = rule.least_cover(steel, layer, diameter) or 0.0
        if axes is None:
            assert steel.cover is not None
            fits = steel.cover[face == "top"] >= least - ROUNDING
        else:
            axis = axes["xy".index(layer[-1])]
            # the bars of both layers of a face cross: half of each lies between their axes
            room = crossing or diameter <= abs(axes[0] - axes[1]) + ROUNDING
            fits = axis - diameter / 2 >= least - ROUNDING and room
        if fits:
            allowed.append(diameter)
    return tuple(allowed) or diameters[:1]


def _with_bars(steel: Reinforcement, layers: dict[str, LayerProposal]) -> Reinforcement:
    """Return the reinforcement with proposed bars in place of its own, at the depth that the thickest of them have."""
    zones = []
    for layer, proposed in layers.items():
        for name, (bars, (x, y)) in proposed.rectangles(layer).items():
            zones.append(
                BarZone(
                    name=name,
                    shape={"kind": "rectangle", "x": x, "y": y},
                    layers=(layer,),
                    diameter=bars.diameter,
                    spacing=bars.spacing,
                )
            )
    changes: dict[str, object] = {layer: proposed.base for layer, proposed in layers.items()}
    for face in ("bottom", "top"):
        if getattr(steel, face) is None:
            thickest = [layers[layer].thickest for layer in (f"{face}_x", f"{face}_y")]
            assert steel.cover is not None
            changes[face] = axes_by_cover(steel.cover[face == "top"], steel.outer, *thickest)
    detailing = steel.detailing or Detailing()
    cleared = {"bottom_mesh": None, "top_mesh": None, "zones": tuple(zones), "links": (), "detailing": detailing,
               "beam_links": (), "shear_links": ()}  # fmt: skip
    return steel.model_copy(update=changes | cleared)


def _laid(results: Results, reinforcement: Reinforcement) -> Results:
    """Return results with the bars that were found, and with what the case allows as it is written."""
    steel = results.model.reinforcement
    assert steel is not None
    changed = {"reinforcement": reinforcement.replace(proposal=steel.proposal)}
    return replace(results, model=results.model.model_copy(update=changed))


def _proposal(
    results: Results, reinforcement: Reinforcement, needs: dict[str, Array], remarks: list[str]
) -> BarProposal:
    """Return the proposal with its steel, from results with the bars that were found."""
    plate, model = ultimate_results(results)[0].plate, results.model
    steel = model.reinforcement
    assert steel is not None
    region = get_plate_region(model.plate, model.plates)
    laid = {}
    for layer in LAYERS:
        base = reinforcement.base_bars(layer)
        assert base is not None
        laid[layer] = bar_area(base) * float(region.area.area)
        for zone in reinforcement.zones:
            if layer in zone.layers:
                laid[layer] += bar_area(zone.bars) * float(polygon_of(zone.shape.ring()).intersection(region.area).area)
    required = {layer: float((needs[layer] * plate.area).sum()) for layer in LAYERS}
    least = _least_areas(ultimate_results(results)[0], reinforcement)
    with_least = {layer: float((np.maximum(needs[layer], least[layer]) * plate.area).sum()) for layer in LAYERS}
    off = [check for check in model.checks.off if any(check.covers(name, check.of) for name in PUNCHING)]
    links = [layout for layout in punching_links(results) if not any(check.of in ("", layout.name) for check in off)]
    around = [
        PunchingLinks(
            of=layout.name,
            diameter=layout.diameter,
            distances=tuple(round(perimeter.distance, 6) for perimeter in layout.perimeters),
            legs=_one_if_alike(tuple(len(perimeter.places) for perimeter in layout.perimeters)),
        )
        for layout in links
        if layout.perimeters
    ]
    along = list(beam_links(results, reinforcement.proposal.link_diameters))
    remarks = remarks + [why for why in along if isinstance(why, Message)]
    of_beams = tuple(links for links in along if isinstance(links, BeamLinks))
    with_links = reinforcement.replace(links=tuple(around), beam_links=of_beams, proposal=steel.proposal)
    model = model.model_copy(update={"reinforcement": with_links})
    return BarProposal(model, required, with_least, laid, tuple(links), tuple(remarks))


def _one_if_alike(legs: tuple[int, ...]) -> tuple[int, ...]:
    """Return the legs on each perimeter, one number if all have as many."""
    return legs[:1] if len(set(legs)) == 1 else legs


def _remarks(results: Results, rule: DetailingRule) -> Iterator[str]:
    """Yield what was not looked at."""
    if rule.crack_area is None:
        alone = "" if rule.crack_spacing is None else ", how far apart bars may be for cracks alone"
        yield Message(
            "crack widths are not looked at: the code of the case has no rule of them here{alone}", alone=alone
        )
    steel = results.model.reinforcement
    if steel is not None and steel.detailing is not None and not steel.detailing.edge_bars:
        yield "bars at edges of the slab count as held there, though detailing.edge_bars is false: hook them"
    if results.model.cracking is not None:
        yield "[cracking]: bars change the stiffness; solve the case again with them"
    yield "one-way shear asks for no more bars here; solve the case with the bars and links"
