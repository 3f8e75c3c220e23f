"""What bars the layers of a slab need in bending over all ultimate combinations, where, and why, by the case's code."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.design_moments import DesignMoments, design_moments
from groundslab.design.demands.envelope import Envelope, envelope
from groundslab.design.demands.support_moments import bar_moments
from groundslab.design.rules.bending import Axes, BendingRule, SlabReinforcement, slab
from groundslab.design.rules.combinations import ultimate_results
from groundslab.messages import Message
from groundslab.model.design.laid_bars import axis_of, laid_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import BAR_FIELDS, LAYERS, extreme_node, place_of
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult, Results


def required_areas(steel: Reinforcement, results: list[CombinationResult]) -> dict[str, SlabReinforcement]:
    """Return the reinforcement needs at the plate's nodes in each combination, by its name."""
    if not results:
        return {}
    t, _ = results[0].elements.at_nodes(results[0].plate)
    return {
        result.combination: areas_for(bar_moments(result, steel), t, steel, result.limit_state) for result in results
    }


def areas_for(moments: DesignMoments, thickness: Array, steel: Reinforcement, limit_state: str) -> SlabReinforcement:
    """Return the reinforcement needs for design moments at nodes (n,) of a slab of thickness (n,) [m]."""
    axes = Axes(*steel.bottom_axes, *steel.top_axes)
    return slab(moments, thickness, axes, code_of(steel).bending(steel, limit_state).required)


def largest_areas(required: dict[str, SlabReinforcement], layer: str) -> tuple[Array, Envelope]:
    """Return the largest area (n,) [m2/m] of a layer over the combinations, inf where it fails, and its envelope.

    The envelope is that of areas with a number larger than any in place of inf.
    """
    areas = {name: getattr(reinforcement, layer) for name, reinforcement in required.items()}
    finite = {name: np.where(np.isinf(area), np.finfo(float).max, area) for name, area in areas.items()}
    return np.max(list(areas.values()), axis=0), envelope(finite)


def bar_fields(combined: Results) -> dict[str, Array]:
    """Return the fields of BAR_FIELDS (n,) at the plate's nodes that there are, in SI units.

    Areas are inf where the concrete is too weak for any reinforcement. Without bars that are laid there is only what is
    required, without ultimate combinations nothing.
    """
    steel = combined.model.reinforcement
    results = ultimate_results(combined)
    if steel is None or not results:
        return {}
    needed = required_areas(steel, results)
    fields = dict[str, Array]()
    for layer in LAYERS:
        required = fields[f"required_{layer}"] = largest_areas(needed, layer)[0]
        if steel.laid:
            provided = fields[f"provided_{layer}"] = laid_bars(steel, layer, results[0].plate.nodes).area
            fields[f"utilization_{layer}"] = required / provided
            fields[f"missing_{layer}"] = np.maximum(required - provided, 0.0)
    return {name: fields[name] for name in BAR_FIELDS if name in fields}


def needs_links(required: dict[str, SlabReinforcement]) -> Flags:
    """Return where bars in compression are counted in any combination (n,), which links must hold."""
    counted: Flags = np.any([reinforcement.links for reinforcement in required.values()], axis=0)
    return counted


#: What an area can be governed by.
MOMENT, MINIMUM, COMPRESSION, TOO_WEAK = "moment", "minimum", "bars in compression", "concrete too weak"


@dataclass(frozen=True, slots=True)
class Need:
    """What a layer of bars needs in one section of the plate, and the moment that governs it.

    The moment [N m/m] is a design moment of its own face or, where the bars serve in compression or the concrete is too
    weak for it, that of the other face: positive with tension at the bottom. Where the minimum governs it is the
    largest one. Without a moment there is no place.
    """

    layer: str
    section: int  # 0 outside all zones, else the number of the zone
    area: float  # [m2/m]; inf where the concrete is too weak
    governed_by: str  # MOMENT, MINIMUM, COMPRESSION, TOO_WEAK or nothing
    moment: float | None
    place: tuple[float, float] | None  # [m]
    combination: str | None
    thickness: float  # [m]
    minimum: float  # [m2/m]
    fails: float  # share of the plate's area where the concrete is too weak
    links: float  # share of the plate's area where bars in compression are counted on, in any layer
    peak: float | None  # the largest moment of that face at a node, of the section and not averaged [N m/m]
    laid: float | None = None  # area of the bars provided there, where needs depend on it [m2/m]


def governing_needs(combined: Results, steel: Reinforcement, laid: Mapping[str, Array] | None = None) -> list[Need]:
    """Return the needs of each layer in each section of the plate, over all ultimate combinations.

    Within a section the depth is one, so that the largest moment of each face governs in each limit state: all that a
    layer needs grows with them. With areas that are laid (n,) [m2/m], by layer, a section is divided by them.
    """
    return _needs(combined, steel) if laid is None else _governing(combined, steel, laid)


@made_once
def _needs(combined: Results, steel: Reinforcement) -> list[Need]:
    """Return the needs without areas that are laid, which checks, tables and calculations ask for."""
    return _governing(combined, steel, None)


def _governing(combined: Results, steel: Reinforcement, laid: Mapping[str, Array] | None) -> list[Need]:
    """Return the needs, with areas that are laid if there are any."""
    results = ultimate_results(combined)
    required = required_areas(steel, results)
    if not required:
        return []
    plate = results[0].plate
    linked = needs_links(required)
    thickness, section = results[0].elements.at_nodes(plate)
    designs: dict[str, dict[str, DesignMoments]] = {}
    for result in results:
        designs.setdefault(result.limit_state, {})[result.combination] = bar_moments(result, steel)
    largest = {state: {layer: _largest(moments, layer) for layer in LAYERS} for state, moments in designs.items()}
    peaks = [design_moments(result.plate) for result in results]
    highest = {layer: np.max([np.abs(getattr(moments, layer)) for moments in peaks], axis=0) for layer in LAYERS}
    rows = []
    for layer in LAYERS:
        area = largest_areas(required, layer)[0]
        provided = np.zeros(len(section)) if laid is None else laid[layer]
        for number, own_area in _pairs(section, provided):
            nodes = np.flatnonzero((section == number) & (provided == own_area))
            shares = [_share(plate, nodes[flags[nodes]]) for flags in (np.isinf(area), linked)]
            needs = []
            for state, by_layer in largest.items():
                moments = [_peak(plate, nodes, *by_layer[face_layer]) for face_layer in (layer, _OTHER[layer])]
                t = float(thickness[nodes[0]])
                at_nodes = [float(highest[face_layer][nodes].max()) for face_layer in (layer, _OTHER[layer])]
                rule = code_of(steel).bending(steel, state)
                needs.append(_need(layer, int(number), t, steel, rule, moments, at_nodes, shares))
            worst = max(needs, key=lambda need: (need.area, abs(need.moment or 0.0)))
            rows.append(worst if laid is None else replace(worst, laid=float(own_area)))
    return rows


def _pairs(section: Integers, provided: Array) -> list[tuple[float, float]]:
    """Return the pairs of section (n,) and area (n,) [m2/m] that there are at nodes, in ascending order."""
    areas, which = np.unique(provided, return_inverse=True)
    pairs = np.unique(section * len(areas) + which.reshape(-1))
    return [(float(pair // len(areas)), float(areas[int(pair % len(areas))])) for pair in pairs]


_OTHER = {"bottom_x": "top_x", "bottom_y": "top_y", "top_x": "bottom_x", "top_y": "bottom_y"}

#: The largest design moment of a face somewhere [N m/m], its place [m], its combination.
_Peak = tuple[float, tuple[float, float], str]


def _largest(designs: dict[str, DesignMoments], layer: str) -> tuple[Array, Envelope]:
    """Return the largest size (n,) [N m/m] of a layer's design moments over the combinations, and its envelope."""
    sizes = envelope({name: np.abs(getattr(moments, layer)) for name, moments in designs.items()})
    return sizes.greatest, sizes


def _peak(plate: PlateResult, nodes: Integers, sizes: Array, by: Envelope) -> _Peak:
    """Return the largest of design moments (n,) on some nodes."""
    node = nodes[extreme_node(plate.nodes[nodes], sizes[nodes], 1)]
    return float(sizes[node]), place_of(plate.nodes, int(node)), by.names[by.greatest_by[node]]


def _need(
    layer: str,
    section: int,
    t: float,
    steel: Reinforcement,
    rule: BendingRule,
    moments: list[_Peak],
    at_nodes: list[float],
    shares: list[float],
) -> Need:
    """Return a layer's needs by a code's rule for the largest moments of its own face and of the other one.

    Those at nodes, which are not averaged, are named beside.
    """
    here, crossing = axis_of(steel, layer), axis_of(steel, _OTHER[layer])
    depths = t - here, t - crossing
    near, other = (
        rule.required(np.array(peak[0]), d, d_2=d_2, thickness=t)
        for peak, d, d_2 in zip(moments, depths, (crossing, here), strict=True)
    )
    areas = {MINIMUM: near.minimum, MOMENT: near.tension, COMPRESSION: other.compression}
    area, governed_by = max(((float(value), name) for name, value in areas.items()), key=lambda cause: cause[0])
    face = 1 if governed_by == COMPRESSION else 0
    if np.isinf(area):
        # of two faces that are both too weak, the one that is so by more is named
        loads = [
            peak[0] / d**2 * reinforcement.fails
            for peak, d, reinforcement in zip(moments, depths, (near, other), strict=True)
        ]
        governed_by = TOO_WEAK
        face = int(np.argmax(loads))
    size, where, name = moments[face]
    sign = -1 if layer.startswith("top") != (face == 1) else 1
    least = float(rule.minimum(np.array(depths[0]), t))
    needed = area > 0
    return Need(
        layer=layer,
        section=section,
        area=area,
        governed_by=governed_by if needed else "",
        moment=sign * size if needed else None,
        place=where if needed else None,
        combination=name if needed else None,
        thickness=t,
        minimum=least,
        fails=shares[0],
        links=shares[1],
        peak=sign * at_nodes[face] if needed else None,
    )


def section_name(section: int) -> str:
    """Return the name of a section of the plate: the plate's own, or a zone by its number."""
    return Message("zone {section}", section=section) if section else "plate"


def _share(plate: PlateResult, nodes: Integers) -> float:
    """Return the share of the plate's area that some nodes have."""
    return float(plate.area[nodes].sum() / plate.area.sum())
