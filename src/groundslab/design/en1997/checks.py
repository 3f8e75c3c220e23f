"""Bearing resistance and sliding by EN 1997-1 6.5, annex D: the ground's force and where it acts come from the contact.

The effective area is the one about the resultant of the ground's pressure and line forces. Horizontal forces are those
of the load cases, with the combination's factors.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.design.basis.check import DesignCheck
from groundslab.design.basis.combinations import ultimate_results
from groundslab.design.basis.demand_errors import error_of, scaled
from groundslab.design.demands.perimeters import outline
from groundslab.design.en1997 import bearing
from groundslab.model.design.limits import SoilStrength
from groundslab.results.results import CombinationResult, Results

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon


@dataclass(frozen=True, slots=True)
class _Forces:
    """What a combination presses on the ground with: V and H [N], and where V acts [m]."""

    V: float
    H: float
    place: tuple[float, float]
    results: CombinationResult

    @property
    def combination(self) -> str:
        """Return the name of the combination."""
        return self.results.combination


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the checks of bearing resistance and of sliding over all ultimate combinations."""
    strength = combined.model.soil_strength
    results = ultimate_results(combined)
    if strength is None:
        return
    if not results:
        words = "not checked: no ultimate combination has a certified result"
        yield DesignCheck("bearing resistance", "attention", words, clause="EN 1997-1 6.5.2")
        return
    soil = _design_soil(strength)
    base = outline(results[0].plate)
    forces = [_forces(result) for result in results]
    kind = "D.4, drained" if soil.c_u is None else "D.3, undrained"
    vertical = f"EN 1997-1 6.5.2, annex {kind}"

    def bearing_resistance(force: _Forces, area: bearing.EffectiveArea) -> float:
        return bearing.bearing_resistance(area, soil, force.V, force.H) / strength.gamma_Rv

    yield _worst("bearing resistance", forces, base, lambda force: force.V, bearing_resistance, vertical)
    if any(force.H for force in forces):
        delta = math.radians(strength.delta if strength.delta is not None else strength.phi or 0.0)
        delta = math.atan(math.tan(delta) / strength.gamma_phi)

        def sliding_resistance(force: _Forces, area: bearing.EffectiveArea) -> float:
            return bearing.sliding_resistance(area, soil.c_u, delta, force.V) / strength.gamma_Rh

        yield _worst("sliding", forces, base, lambda force: force.H, sliding_resistance, "EN 1997-1 6.5.3")


def _design_soil(strength: SoilStrength) -> bearing.Soil:
    """Return the design values of the soil."""
    phi = math.atan(math.tan(math.radians(strength.phi or 0.0)) / strength.gamma_phi)
    c_u = None if strength.c_u is None else strength.c_u / strength.gamma_cu
    return bearing.Soil(phi, strength.c / strength.gamma_c, c_u, strength.unit_weight, strength.overburden)


def _forces(results: CombinationResult) -> _Forces:
    """Return the forces on the ground of a combination."""
    plate = results.plate
    V = float(plate.contact_force.sum())
    place = plate.nodes.T @ plate.contact_force / V if V > 0 else np.zeros(2)
    cases = {case.name: case for case in results.solved_model.cases}
    acting = [(factor, cases[name]) for name, factor in results.factors if name in cases]
    H = math.hypot(*(sum(factor * getattr(case, axis) for factor, case in acting) for axis in ("H_x", "H_y")))
    return _Forces(V, H, (float(place[0]), float(place[1])), results)


def _worst(
    name: str,
    forces: list[_Forces],
    base: Polygon | MultiPolygon,
    demand: Callable[[_Forces], float],
    resistance: Callable[[_Forces, bearing.EffectiveArea], float],
    clause: str,
) -> DesignCheck:
    """Return the check of the combination that uses most."""

    def ratio(force: _Forces) -> tuple[float, float, _Forces, bearing.EffectiveArea | None]:
        area = bearing.effective_area(base, *force.place)
        R = resistance(force, area) if area is not None else 0.0
        return demand(force) / R if R > 0 else math.inf, R, force, area

    used, R, force, area = max(map(ratio, forces), key=lambda ratio: ratio[0])
    # the resistance, too, follows from where the force acts
    error = error_of(force.results, lambda mesh: ratio(_forces(mesh))[0])
    size = "" if area is None else f" on A' = {area.area:.3g} m2 ({area.width:.3g} x {area.length:.3g} m)"
    words = f'{demand(force) / 1e3:.0f} kN is {used:.3g} times {R / 1e3:.0f} kN{size} in "{force.combination}"'
    return DesignCheck(
        name,
        "fails" if used > 1 else "no failure found",
        words,
        demand=demand(force) / 1e3,
        resistance=R / 1e3,
        unit="kN",
        clause=clause,
        combination=force.combination,
        place=force.place,
        foundation=True,
        error=scaled(error, R / 1e3),
    )
