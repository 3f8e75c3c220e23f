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

from groundslab.design.codes.en1997 import bearing
from groundslab.design.codes.en1997.bearing_steps import bearing_steps, sliding_steps
from groundslab.design.demands.loads.column_loads import factors_of
from groundslab.design.demands.perimeters import outline
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import NO_COMBINATION, NO_LIMIT, DesignCheck, not_judged
from groundslab.design.rules.combinations import ultimate_results, why_none
from groundslab.design.rules.demand_errors import error_of, scaled
from groundslab.messages import Message, Name
from groundslab.model.design.limits import SoilStrength
from groundslab.model.loads.load_cases import STRENGTH
from groundslab.results.results import CombinationResult, Results

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon

#: Where sliding is ruled.
SLIDING = "EN 1997-1 6.5.3"


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


@dataclass(frozen=True, slots=True)
class _Rule:
    """What is checked by which clause: its demand and resistance [N], and the calculation."""

    name: str
    clause: str
    demand: Callable[[_Forces], float]
    resistance: Callable[[_Forces, bearing.EffectiveArea], float]
    steps: Callable[[_Forces, bearing.EffectiveArea], Iterator[Step]]


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the checks of bearing resistance and of sliding over all ultimate combinations."""
    strength = combined.model.soil_strength
    results = ultimate_results(combined)
    if strength is None:
        most = max(results, key=_horizontal, default=None)
        if most is not None and (H := _horizontal(most)):
            words: str = Message(
                '{H:.4g kN} act horizontally in "{combination}", and the case has no [soil_strength]',
                H=H / 1e3,
                combination=Name(most.combination),
            )
            yield not_judged("sliding", NO_LIMIT, words, combination=most.combination, clause=SLIDING)
        return
    if not results:
        words = why_none(combined, STRENGTH, "ultimate combination")
        yield not_judged("bearing resistance", NO_COMBINATION, words, clause="EN 1997-1 6.5.2")
        return
    soil = _design_soil(strength)
    base = outline(results[0].plate)
    forces = [_forces(result) for result in results]
    kind = "D.4, drained" if soil.c_u is None else "D.3, undrained"
    vertical = Message("EN 1997-1 6.5.2, annex {kind}", kind=kind)

    def bearing_resistance(force: _Forces, area: bearing.EffectiveArea) -> float:
        return bearing.bearing_resistance(area, soil, force.V, force.H) / strength.gamma_Rv

    def steps(force: _Forces, area: bearing.EffectiveArea) -> Iterator[Step]:
        return bearing_steps(strength, area, soil, force.V, force.H)

    yield _eccentricity(forces, base)
    of_bearing = _Rule("bearing resistance", vertical, lambda force: force.V, bearing_resistance, steps)
    yield _worst(of_bearing, forces, base)
    if any(force.H for force in forces):
        yield _worst(_sliding(strength, soil.c_u), forces, base)


def _sliding(strength: SoilStrength, c_u: float | None) -> _Rule:
    """Return how sliding is checked, c_u [Pa] being the design value of an undrained soil."""
    delta = math.atan(math.tan(math.radians(strength.sliding_angle)) / strength.gamma_phi)

    def resistance(force: _Forces, area: bearing.EffectiveArea) -> float:
        return bearing.sliding_resistance(area, c_u, delta, force.V, strength.gamma_Rh)

    def steps(force: _Forces, area: bearing.EffectiveArea) -> Iterator[Step]:
        return sliding_steps(strength, area, c_u, delta, force.V, force.H)

    return _Rule("sliding", SLIDING, lambda force: force.H, resistance, steps)


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
    return _Forces(V, _horizontal(results), (float(place[0]), float(place[1])), results)


def _horizontal(results: CombinationResult) -> float:
    """Return the horizontal force on the slab in a combination [N]."""
    factors = factors_of(results)
    acting = [(factors.get(case.name, 0.0), case) for case in results.solved_model.cases]
    return math.hypot(*(sum(factor * getattr(case, axis) for factor, case in acting) for axis in ("H_x", "H_y")))


def _eccentricity(forces: list[_Forces], base: Polygon | MultiPolygon) -> DesignCheck:
    """Return whether the resultant is so far out that special precautions are asked for (6.5.4)."""

    def share(force: _Forces) -> float:
        e, edge, most = bearing.eccentricity(base, *force.place)
        return e / (edge * most)

    force = max(forces, key=share)
    e, edge, most = bearing.eccentricity(base, *force.place)
    used, asked = share(force), ""
    if used > 1:
        asked = ": loads are to be reviewed and the edge's place with its tolerance, 0.1 m (6.5.4)"
    words = Message(
        'e {e:.3g m} is {e_2:.3g} of the way to the edge in "{combination}", {most:.3g} may be{asked}',
        e=e,
        e_2=e / edge,
        combination=Name(force.combination),
        most=most,
        asked=asked,
    )
    return DesignCheck(
        "eccentricity on the ground", "attention" if used > 1 else "no failure found", words, demand=e,
        resistance=edge * most, unit="m", clause="EN 1997-1 6.5.4(1)", combination=force.combination,
        place=force.place, foundation=True, error=scaled(error_of(force.results, lambda mesh: share(_forces(mesh))),
        edge * most),
        steps=(
            Step("eccentricity of the resultant", "e", e, "m"),
            Step("from the center to the edge in its direction", "r", edge, "m"),
            Step("share that may be", "s", most, clause="6.5.4(1)"),
            Step("share used", "eta", used, "", "e / (s * r)", "6.5.4(1)"),
        ),
    )  # fmt: skip


def _worst(rule: _Rule, forces: list[_Forces], base: Polygon | MultiPolygon) -> DesignCheck:
    """Return the check of the combination that uses most."""

    def ratio(force: _Forces) -> tuple[float, float, _Forces, bearing.EffectiveArea | None]:
        area = bearing.effective_area(base, *force.place)
        R = max(rule.resistance(force, area), 0.0) if area is not None else 0.0
        return rule.demand(force) / R if R > 0 else math.inf, R, force, area

    used, R, force, area = max(map(ratio, forces), key=lambda ratio: ratio[0])
    # the resistance, too, follows from where the force acts
    error = error_of(force.results, lambda mesh: ratio(_forces(mesh))[0])
    size = (
        ""
        if area is None
        else Message(
            " on A' = {area:.3g m2} ({width:.3g (m)} x {length:.3g m})",
            area=area.area,
            width=area.width,
            length=area.length,
        )
    )
    words = Message(
        '{demand:.0f kN} is {used:.3g} times {R:.0f kN}{size} in "{combination}"',
        demand=rule.demand(force) / 1e3,
        used=used,
        R=R / 1e3,
        size=size,
        combination=Name(force.combination),
    )
    return DesignCheck(
        rule.name,
        "fails" if used > 1 else "no failure found",
        words,
        demand=rule.demand(force) / 1e3,
        resistance=R / 1e3,
        unit="kN",
        clause=rule.clause,
        combination=force.combination,
        place=force.place,
        foundation=True,
        error=scaled(error, R / 1e3),
        steps=tuple(rule.steps(force, area)) if area is not None and R > 0 else (),
    )
