"""One-way shear by EN 1992-1-1 6.2 or ACI 318-19 22.5: where a slab needs links away from columns, where none help.

The shear force is the largest of any direction at a node, the bars that count are those of the face that is in tension
in that direction: those that are laid, or those that bending needs. Left out are places where it is not this that is
checked: near columns as far as punching is, which is 2 d unless that perimeter cuts the slab from edge to edge, and
within 2 d of supports and of the forces on a floor whose punching is checked by TR34; within a thickness of free edges
(a quarter of the width of a narrow slab), where the shear force along the edge is what the twisting moment has become;
and near singular places. Beside line loads and footprints that are no columns it begins at d from them (`faces`), up
to which no struts may fail. Nearer to columns ACI 318 asks for means across the slab (`wide_beam`).

On ground with shear the line force along the slab's edge takes off shear forces beside it. The worse of both counts:
with it at the edge, and with it as pressure over a strip (`edge_strip`), unless the case lets it relieve.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.design.aci318 import case_materials as aci318_case
from groundslab.design.aci318 import shear as aci318
from groundslab.design.aci318.materials import PHI_SHEAR
from groundslab.design.basis.check import DesignCheck, Status
from groundslab.design.basis.combinations import ultimate_results
from groundslab.design.checks.ground.edge_strip import spread_edge_force
from groundslab.design.checks.one_way_shear.faces import bearers
from groundslab.design.checks.one_way_shear.places import Places, ShearPlaces, near_forces, nodes_of
from groundslab.design.checks.one_way_shear.wide_beam import cuts
from groundslab.design.en1992 import shear
from groundslab.design.en1992.case_materials import materials
from groundslab.design.en1992.checks.governing_perimeters import demands
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.contact_zone import has_line_force
from groundslab.results.fields import place_of
from groundslab.results.mesh_results import PlateResult
from groundslab.results.results import CombinationResult, Results

#: A slab with links is at least so thick [m] (9.3.2(1)).
LEAST_WITH_LINKS = 0.2


@dataclass(frozen=True, slots=True)
class _Worst:
    """Where a combination's shear force is largest against what needs no links."""

    results: CombinationResult
    place: tuple[float, float]  # [m]
    v: float  # [N/m]
    without_links: float  # [N/m]
    d: float  # [m]
    thickness: float  # [m]
    spread: bool = False  # whether the line force along the edge is spread over a strip
    at_support: bool = False  # whether it is nearer than d to what presses there

    @property
    def used(self) -> float:
        """Return the force over what needs no links."""
        return self.v / self.without_links

    @property
    def where(self) -> str:
        """Return place and combination in words."""
        edge = ", the line force along the edge as pressure on a strip" if self.spread else ""
        return f'({self.place[0]:.3f}, {self.place[1]:.3f}) m in "{self.results.combination}"{edge}'

    def check(self, status: Status, words: str, clause: str) -> DesignCheck:
        """Return the check of this place."""
        return DesignCheck(
            "one-way shear", status, words, demand=self.v / 1e3, resistance=self.without_links / 1e3, unit="kN/m",
            clause=clause, combination=self.results.combination, place=self.place,
        )  # fmt: skip


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the check of one-way shear over all ultimate combinations."""
    steel, results = combined.model.reinforcement, ultimate_results(combined)
    if steel is None or not results:
        return
    aci = steel.code == "ACI 318"
    reach = {} if aci else demands(combined).reach
    places = ShearPlaces(nodes_of(steel, results, reach), bearers(combined.solved_model), reach)
    found = [worst for each in results for worst in _of_combination(each, places, steel)]
    if aci:
        found += _across(results, places.nodes, steel)
    if found:
        worst = max(found, key=lambda one: one.used)
        yield (_by_aci318 if aci else _by_en1992)(steel, worst)


def _of_combination(results: CombinationResult, places: ShearPlaces, steel: Reinforcement) -> Iterator[_Worst]:
    """Yield the worst of the places of a combination, with the edge's line force where it acts and spread."""
    sorted_places = places.of(results)
    for plate in _plates(results, steel):
        for some in sorted_places.beyond:
            yield from _worst(results, plate, some, steel)
        if steel.code == "EN 1992-1-1":
            yield from (worst for worst in _worst(results, plate, sorted_places.within, steel, at_support=True)
                        if _no_links_help(worst, steel))  # fmt: skip


def _plates(results: CombinationResult, steel: Reinforcement) -> tuple[PlateResult, ...]:
    """Return the plate as it is and, unless the line force along its edge may relieve it, with that force spread."""
    if steel.line_force_relieves or not has_line_force(results):
        return (results.plate,)
    return results.plate, spread_edge_force(results)


def _worst(
    results: CombinationResult, plate: PlateResult, places: Places, steel: Reinforcement, *, at_support: bool = False
) -> Iterator[_Worst]:
    """Yield the place that counts with the largest share of what needs no links, if any counts."""
    v, without_links = _demand(results, plate, places, steel)
    counts = places.counts & ~near_forces(results, places.xy, places.d)
    if counts.any():
        k = int(np.argmax(np.where(counts, v / without_links, -1.0)))
        at, spread = place_of(places.xy, k), plate is not results.plate
        sizes = float(v[k]), float(without_links[k]), float(places.d[k]), float(places.thickness[k])
        yield _Worst(results, at, *sizes, spread, at_support)


def _no_links_help(worst: _Worst, steel: Reinforcement) -> bool:
    """Return whether struts fail by EN 1992-1-1."""
    concrete, bars = materials(steel, worst.results.limit_state)
    return bool(shear.required_links(np.array([worst.v]), np.array([worst.d]), concrete, bars).fails[0])


def _across(results: list[CombinationResult], nodes: Places, steel: Reinforcement) -> Iterator[_Worst]:
    """Yield the means over the cuts beside columns by ACI 318, in every combination."""
    concrete, _ = aci318_case.materials(steel)
    v_c = {layer: PHI_SHEAR * aci318.without_links(concrete, nodes.d, rho) for layer, rho in nodes.ratios.items()}
    plates = [(each, plate) for each in results for plate in _plates(each, steel)]
    for cut in cuts(results[0], steel):
        d, thickness = cut.mean(nodes.d), cut.mean(nodes.thickness)
        for each, plate in plates:
            yield _Worst(each, cut.place, *cut.forces(plate, v_c), d, thickness, plate is not each.plate)


def _by_en1992(steel: Reinforcement, worst: _Worst) -> DesignCheck:
    """Return the check at the place that governs by EN 1992-1-1."""
    which = "laid" if steel.laid else "needed in bending"
    words = (
        f"v_Ed {worst.v / 1e3:.4g} kN/m at {worst.where} is {worst.used:.3g} times v_Rd,c "
        f"{worst.without_links / 1e3:.4g} kN/m with the bars that are {which} (6.2.2)"
    )
    status: Status = "no failure found"
    if worst.used > 1:
        concrete, bars = materials(steel, worst.results.limit_state)
        links = shear.required_links(np.array([worst.v]), np.array([worst.d]), concrete, bars)
        area = max(float(links.area[0]), shear.minimum_links(concrete, bars))
        thin = worst.thickness < LEAST_WITH_LINKS
        status = "fails" if np.isinf(area) or thin else "attention"
        words += (
            "; no links help at what presses there (6.2.1(8))" if worst.at_support
            else "; no links help (6.2.3(3))" if np.isinf(area)
            else "; too thin for links (9.3.2(1))" if thin
            else f"; links of {area * 1e4:.3g} cm2/m2 are needed there (6.2.3)"
        )  # fmt: skip
    return worst.check(status, words, "EN 1992-1-1 6.2.2, 6.2.3")


def _by_aci318(steel: Reinforcement, worst: _Worst) -> DesignCheck:
    """Return the check at the place that governs by ACI 318-19."""
    which = "laid" if steel.laid else "needed in bending"
    words = (
        f"v_u {worst.v / 1e3:.4g} kN/m at {worst.where} is {worst.used:.3g} times phi v_c "
        f"{worst.without_links / 1e3:.4g} kN/m with the bars that are {which} (22.5.5.1)"
    )
    status: Status = "no failure found"
    if worst.used > 1:
        area = aci318.links(worst.v, worst.d, *aci318_case.materials(steel))
        status = "fails" if np.isinf(area) else "attention"
        words += (
            "; no links help (22.5.1.2)" if np.isinf(area)
            else f"; links of {area * 1e4:.3g} cm2/m2 are needed there (22.5.8.5.3)"
        )  # fmt: skip
    return worst.check(status, words, "ACI 318-19 22.5.5.1")


def _demand(
    results: CombinationResult, plate: PlateResult, places: Places, steel: Reinforcement
) -> tuple[Array, Array]:
    """Return the largest shear force of any direction and what needs no links (k,) [N/m]."""
    f = places.forces(plate, results.elements)
    v, along = shear.principal_shear(f["shear_x"], f["shear_y"])
    twist = 2 * np.sqrt(along * (1 - along)) * np.sign(f["shear_x"] * f["shear_y"])
    bottom = f["moment_x"] * along + f["moment_y"] * (1 - along) + f["moment_xy"] * twist > 0
    rho_x, rho_y = (
        np.where(bottom, places.ratios[f"bottom_{axis}"], places.ratios[f"top_{axis}"]) for axis in ("x", "y")
    )
    rho = shear.ratio_along(along, rho_x, rho_y)
    if steel.code == "ACI 318":
        return v, PHI_SHEAR * aci318.without_links(aci318_case.materials(steel)[0], places.d, rho)
    return v, shear.resistance_without_links(materials(steel, results.limit_state)[0], places.d, rho)
