"""One-way shear by EN 1992-1-1 6.2: where a slab needs links away from columns, and where no links help.

The shear force is the largest of any direction at a node, the bars that count are those of the face that is in tension
in that direction: those that are laid, or those that bending needs. Left out are places where it is not this that is
checked: near columns as far as punching is, which is 2 d unless that perimeter cuts the slab from edge to edge, and
within 2 d of supports; within a thickness of free edges (a quarter of the width of a narrow slab), where the shear
force along the edge is what the twisting moment has become; and near singular places.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.checks.check import DesignCheck, Status
from groundslab.design.en1992 import shear
from groundslab.design.laid_bars import laid_bars
from groundslab.design.punching import outline
from groundslab.design.tables import reinforcement
from groundslab.design.tables.punching import demands
from groundslab.discretize.singular_places import near_singular
from groundslab.model.outputs import Reinforcement
from groundslab.model.supports import LineSupport
from groundslab.results.fields import LAYERS, place_of
from groundslab.results.results import CombinationResult, Results

#: A slab with links is at least so thick [m] (9.3.2(1)).
LEAST_WITH_LINKS = 0.2


@dataclass(frozen=True, slots=True)
class _Section:
    """What the plate's nodes have in every combination."""

    d: Array  # (n,): effective depth, the lesser of both faces [m]
    thickness: Array  # (n,) [m]
    ratios: dict[str, Array]  # (n,): bars over the depth, by layer
    counts: Flags  # (n,): whether one-way shear is checked there


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the check of one-way shear over all ultimate combinations."""
    steel, results = combined.model.reinforcement, reinforcement.ultimate_results(combined)
    if steel is None or not results:
        return
    section = _section(steel, results, demands(combined).reach)
    if not section.counts.any():
        return
    found = []
    for each in results:
        v, v_Rd_c = _demand(each, section, steel)
        node = int(np.argmax(np.where(section.counts, v / v_Rd_c, -1.0)))
        found.append((float(v[node] / v_Rd_c[node]), node, float(v[node]), float(v_Rd_c[node]), each))
    used, node, v_Ed, resistance, worst = max(found, key=lambda one: one[0])
    x, y = place_of(worst.plate.nodes, node)
    which = "laid" if steel.laid else "needed in bending"
    words = (
        f'v_Ed {v_Ed / 1e3:.4g} kN/m at ({x:.3f}, {y:.3f}) m in "{worst.combination}" is {used:.3g} times v_Rd,c '
        f"{resistance / 1e3:.4g} kN/m with the bars that are {which} (6.2.2)"
    )
    status: Status = "no failure found"
    if used > 1:
        concrete, bars = reinforcement.materials(steel, worst.limit_state)
        links = shear.required_links(np.array([v_Ed]), section.d[[node]], concrete, bars)
        area = max(float(links.area[0]), shear.minimum_links(concrete, bars))
        thin = section.thickness[node] < LEAST_WITH_LINKS
        status = "fails" if np.isinf(area) or thin else "attention"
        words += (
            "; no links help (6.2.3(3))" if np.isinf(area)
            else "; too thin for links (9.3.2(1))" if thin
            else f"; links of {area * 1e4:.3g} cm2/m2 are needed there (6.2.3)"
        )  # fmt: skip
    yield DesignCheck(
        "one-way shear", status, words, demand=v_Ed / 1e3, resistance=resistance / 1e3, unit="kN/m",
        clause="EN 1992-1-1 6.2.2, 6.2.3", combination=worst.combination, place=(x, y),
    )  # fmt: skip


def _section(steel: Reinforcement, results: list[CombinationResult], reach: Mapping[str, float]) -> _Section:
    """Return depths, bars and what counts at the plate's nodes."""
    plate = results[0].plate
    thickness = results[0].elements.at_nodes(plate)[0]
    d = thickness - max(sum(steel.bottom), sum(steel.top)) / 2
    if steel.laid:
        areas = {layer: laid_bars(steel, layer, plate.nodes).area for layer in LAYERS}
    else:
        found = reinforcement.required_areas(steel, results)
        areas = {layer: reinforcement.largest_areas(found, layer)[0] for layer in LAYERS}
    ratios = {layer: np.minimum(area / d, shear.MOST_BARS) for layer, area in areas.items()}
    return _Section(d, thickness, ratios, _counts(results[0], d, thickness, reach))


def _counts(results: CombinationResult, d: Array, thickness: Array, reach: Mapping[str, float]) -> Flags:
    """Return at which nodes one-way shear is checked; `reach` is how far from columns punching is [m]."""
    from shapely import LineString, Point, distance, points, union_all

    model, nodes = results.model, points(results.plate.nodes)
    chord = 1e-3 * max(model.plate.sides)
    nearer = [distance(nodes, column.to_shapely(chord)) <= reach.get(column.name, 2 * d) for column in model.columns]
    stands = [LineString(each.points) if isinstance(each, LineSupport) else Point(each.x, each.y)
               for each in model.supports]  # fmt: skip
    far = distance(nodes, union_all(stands)) > 2 * d if stands else np.ones(len(nodes), dtype=bool)
    far = far & ~np.any(nearer, axis=0) if nearer else far
    from_edges = distance(nodes, outline(results.plate).boundary)
    # of a narrow slab the middle half counts in any case
    inner = from_edges > np.minimum(thickness, from_edges.max() / 2)
    return np.asarray(far & inner & ~near_singular(model, results.plate.nodes, thickness))


def _demand(results: CombinationResult, section: _Section, steel: Reinforcement) -> tuple[Array, Array]:
    """Return the largest shear force of any direction and what needs no links (n,) [N/m]."""
    plate = results.plate
    v, along = shear.principal_shear(plate.shear_x, plate.shear_y)
    twist = 2 * np.sqrt(along * (1 - along)) * np.sign(plate.shear_x * plate.shear_y)
    bottom = plate.moment_x * along + plate.moment_y * (1 - along) + plate.moment_xy * twist > 0
    rho_x, rho_y = (
        np.where(bottom, section.ratios[f"bottom_{axis}"], section.ratios[f"top_{axis}"]) for axis in ("x", "y")
    )
    rho = shear.ratio_along(along, rho_x, rho_y)
    return v, shear.resistance_without_links(reinforcement.materials(steel, results.limit_state)[0], section.d, rho)
