"""Industrial floors: yield lines by TR34, flexural stresses by ACI 360R-10 and PCA, the restraint of shrinkage.

The formulas are those of `design/codes/floors`; they know the ground as springs, k being the pressure on it over its
settlement; that of an elastic continuum is the equivalent one of `discretize.ground.subgrade_modulus`. Stresses by ACI
360R are those of the contact analysis. Of zones the thinnest counts in the formulas, at stresses each node's own
thickness. Of several plates each is checked by itself, its edges at joints too.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004 import perimeter_demand
from groundslab.design.codes.en1992_2004 import punching as punching_resistance
from groundslab.design.codes.en1992_2004.materials import CONCRETE_CLASSES, Concrete, Steel
from groundslab.design.codes.en1992_2004.perimeters import face_length, openings
from groundslab.design.codes.floors import acting_loads, resistance, strips, yield_lines
from groundslab.design.codes.floors.acting_loads import Borders, Force
from groundslab.design.codes.floors.yield_lines import Location, YieldSlab
from groundslab.design.demands.by_plate import split_by_plate
from groundslab.design.demands.design_moments import principal_moments
from groundslab.design.demands.perimeters import surroundings
from groundslab.design.rules.check import NO_COMBINATION, NO_PERIMETER, DesignCheck, not_judged
from groundslab.design.rules.combinations import solved_results, ultimate_results, why_none
from groundslab.design.rules.demand_errors import MOMENT, error_at_nodes, error_of, scaled
from groundslab.discretize.ground import grounds_of
from groundslab.errors import InputError
from groundslab.fem.foundation import Column
from groundslab.messages import Message, Name, joined, quantity
from groundslab.model.design.floors import ACI360Floor, AnyFloor, TR34Floor
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.load_cases import SERVICEABILITY, STRENGTH
from groundslab.model.model import Model
from groundslab.results.fields import extreme
from groundslab.results.results import CombinationResult, Results

#: Effective depth over thickness where there is no mesh, as TR34 has it.
FIBER_DEPTH = 0.75
#: Within so many radii of relative stiffness loads may fail together.
REACH = 7.0
#: Results of combinations, with the forces in each.
Standing = list[tuple[CombinationResult, list[Force]]]
NAMES = {1: "point load", 2: "dual point load", 4: "quadruple point load"}


@dataclass(frozen=True, slots=True)
class Slab:
    """What the formulas know of a floor: E [Pa], h [m], nu, k [Pa/m]; whether k stands for an elastic continuum."""

    E: float
    h: float
    nu: float
    k: float
    equivalent: bool = False

    @property
    def l(self) -> float:  # noqa: E743  the field's letter
        """Return the radius of relative stiffness [m]."""
        return yield_lines.relative_stiffness_radius(self.E, self.h, self.nu, self.k)

    @property
    def springs(self) -> str:
        """Return the note on k after a clause, empty where the ground itself has a k."""
        return (
            Message(", with k = {k:.3g MPa/m} equivalent to the continuum", k=self.k / 1e6) if self.equivalent else ""
        )

    @property
    def lam(self) -> float:
        """Return lambda [1/m] of a strip."""
        return strips.characteristic(self.E, self.h, self.k)


@dataclass(frozen=True, slots=True)
class Use:
    """A demand and what resists it, in SI units, with its place [m], combination and discretization error."""

    demand: float
    resistance: float
    place: tuple[float, float]
    combination: str
    error: float | None = None  # of the demand; none of loads that are given

    @property
    def share(self) -> float:
        """Return demand over resistance."""
        return self.demand / self.resistance


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the checks of the floor by the method of the case."""
    floor = combined.model.floor
    if floor is None:
        return
    by_tr34 = isinstance(floor, TR34Floor)
    decisive = ultimate_results(combined) if by_tr34 else _serviceable(combined)
    if not decisive:
        states = (STRENGTH, "ultimate combination") if by_tr34 else (SERVICEABILITY, "serviceability combination")
        yield not_judged("floor", NO_COMBINATION, why_none(combined, *states))
        return
    transfers = []
    for name, results in _split_by_plate(decisive).items():
        slab = slab_of(results[0].model)
        standing = _standing(floor, slab, results)
        transfers.append(_largest_transfer(standing))
        rows = _by_tr34(floor, slab, standing) if isinstance(floor, TR34Floor) else _by_aci(floor, slab, standing)
        for check in rows:
            yield _of_plate(name, check) if name else check
    yield from _joints(max(transfers))
    yield from _restraint(floor)


def _split_by_plate(results: list[CombinationResult]) -> dict[str, list[CombinationResult]]:
    """Return the results of combinations plate by plate."""
    split = [split_by_plate(result) for result in results]
    return {name: [plates[name] for plates in split] for name in split[0]}


def _of_plate(name: str, check: DesignCheck) -> DesignCheck:
    """Return a check with the name of its plate."""
    if check.of:  # which the words begin with
        return replace(check, of=joined((Name(name), check.of)), words=joined((Name(name), check.words)))
    return replace(check, of=Name(name), words=Message("{name}: {text}", name=Name(name), text=check.words))


def _serviceable(combined: Results) -> list[CombinationResult]:
    """Return the results of the combinations of serviceability, which have no partial factors."""
    return [result for result in solved_results(combined) if result.limit_state in SERVICEABILITY]


def slab_of(model: Model) -> Slab:
    """Return the slab that the formulas use for a model: its thinnest part on its softest ground."""
    plate = model.plate
    h = min([plate.thickness, *(zone.thickness for zone in plate.zones if zone.thickness is not None)])
    grounds = [ground if isinstance(ground, Column) else ground.first_column() for ground in grounds_of(model)]
    k = min(1 / float(np.linalg.inv(column.A0)[0, 0]) for column in grounds)
    return Slab(plate.E, h, plate.nu, k, isinstance(model.ground, ContinuousGround))


def _by_tr34(floor: TR34Floor, slab: Slab, standing: Standing) -> Iterator[DesignCheck]:
    """Yield point loads, line loads and pressures on a plate by TR34 in the ultimate combinations."""
    concrete = concrete_of(floor)
    results = [result for result, _ in standing]
    M_n = resistance.plain_moment(concrete, slab.h)
    lines = YieldSlab(slab.l, sagging_moment(floor, concrete, slab.h), M_n)

    def fails(loads: tuple[Force, ...], distances: float, location: Location) -> float:
        a = min(load.a for load in loads)
        alone = sum(yield_lines.single(lines, load.a, location) for load in loads)
        return alone if len(loads) == 1 else min(alone, yield_lines.group(lines, a, distances, location))

    clause = Message("TR34 yield lines, Meyerhof 1962{springs}", springs=slab.springs)
    yield from _point_loads(slab, standing, fails, dict.fromkeys(NAMES, clause))
    yield from _punching(floor, concrete, slab, standing)
    yield from _line_loads(slab, M_n, results, Message("TR34, Hetenyi 1946{springs}", springs=slab.springs))
    yield from _pressures(slab, M_n, results, Message("TR34, Hetenyi 1946{springs}", springs=slab.springs))


def concrete_of(floor: TR34Floor) -> Concrete:
    """Return the concrete of a floor by TR34."""
    f_ck = floor.f_ck if floor.concrete is None else CONCRETE_CLASSES[floor.concrete] * 1e6
    assert f_ck is not None
    return Concrete(f_ck, floor.gamma_c)


def sagging_moment(floor: TR34Floor, concrete: Concrete, h: float) -> float:
    """Return M_p [N m/m]: of fibers or a mesh; plain concrete has none once it has cracked."""
    if floor.f_R1 is not None and floor.f_R4 is not None:
        return resistance.fiber_moment(floor.f_R1, floor.f_R4, h, concrete.gamma_c)
    if floor.mesh_area is not None and floor.mesh_axis is not None:
        return resistance.mesh_moment(floor.mesh_area, h - floor.mesh_axis, Steel(floor.f_yk, floor.gamma_s))
    return 0.0


def _punching(floor: TR34Floor, concrete: Concrete, slab: Slab, standing: Standing) -> Iterator[DesignCheck]:
    """Yield punching by the largest force inside, at an edge and at a corner: at its footprint and 2 d from it."""
    largest = dict[Location, tuple[Force, CombinationResult]]()
    for result, loads in standing:
        for load in loads:
            before = largest.get(load.location)
            if load.a and (before is None or load.share * load.P > before[0].share * before[0].P):
                largest[load.location] = load, result
    d = FIBER_DEPTH * slab.h if floor.mesh_axis is None else slab.h - floor.mesh_axis
    rho = 0.0 if floor.mesh_area is None else floor.mesh_area / d
    at_footprint = punching_resistance.max_resistance(concrete)
    assert at_footprint is not None  # the recommended values have it
    limits = (
        at_footprint,
        punching_resistance.resistance_without_links(concrete, d, rho),
    )
    for location, (load, result) in sorted(largest.items()):
        column = acting_loads.as_column(load)
        P = load.share * load.P
        try:
            at_face = P / (face_length(surroundings(result.plate, column, 0.0, openings(d)), d) * d)
            around = perimeter_demand.demand(result.plate, column, d, P).v_Ed
        except InputError as error:
            yield not_judged("punching", NO_PERIMETER, joined((location, str(error))), of=location)
            continue
        change = error_of(result, lambda mesh: perimeter_demand.demand(mesh.plate, column, d, P).v_Ed)  # noqa: B023  made at once
        rows = (("punching at the footprint", at_face, None), ("punching", around, change))
        for (name, v_Ed, its_own), v_Rd in zip(rows, limits, strict=True):
            use = Use(max(v_Ed, 0.0), v_Rd, load.place, result.combination, its_own)
            yield _check(name, location, use, "MPa", 1e-6, "TR34, EN 1992-1-1 6.4")


def _by_aci(floor: ACI360Floor, slab: Slab, standing: Standing) -> Iterator[DesignCheck]:
    """Yield stresses, pressures and, of fiber concrete, yield lines by ACI 360R in combinations of serviceability."""
    results = [result for result, _ in standing]
    allowed = allowed_stress(floor)
    drag = _drag(floor)
    for face, sign in (("bottom", 1), ("top", -1)):
        uses = [_stress(result, sign, drag, allowed) for result in results]
        clause = "ACI 360R-10 7.2, 5.9, table 5.3"
        worst = max(range(len(uses)), key=lambda number: uses[number].share)
        use = replace(uses[worst], error=_error_of_stress(results[worst], sign))
        yield _check("flexural stress", face, use, "MPa", 1e-6, clause)
    yield from _pressures(
        slab, (allowed - drag) * slab.h**2 / 6, results, Message("PCA, ACI 360R-10 A1{springs}", springs=slab.springs)
    )
    if floor.R_e3 is not None:
        M_0 = floor.f_r * (1 + floor.R_e3) * slab.h**2 / 6

        def fails(loads: tuple[Force, ...], distances: float, location: Location) -> float:  # noqa: ARG001
            (load,) = loads
            return yield_lines.meyerhof(M_0, load.a, slab.l, location) / floor.safety_factor

        clause = Message("ACI 360R-10 11.3.3.3, Meyerhof 1962{springs}", springs=slab.springs)
        yield from _point_loads(slab, standing, fails, {1: clause})


def allowed_stress(floor: ACI360Floor) -> float:
    """Return the allowed flexural stress [Pa]: f_r / SF, or as repetitions allow; f_r R_e,3 of fiber concrete."""
    ratio = max(1 / floor.safety_factor, floor.R_e3 or 0.0)
    if floor.repetitions is not None:
        ratio = min(ratio, resistance.allowed_ratio(floor.repetitions))
    return floor.f_r * min(ratio, 1.0)


def _stress(results: CombinationResult, sign: int, drag: float, allowed: float) -> Use:
    """Return the largest tension at a face, 6 m / h^2 of principal moments and what friction adds, against a stress."""
    stress, place = extreme(results.plate.nodes, _tension(results, sign), 1)
    return Use(max(stress, 0.0) + drag, allowed, place, results.combination)


def _tension(results: CombinationResult, sign: int) -> Array:
    """Return the tension 6 m / h^2 (n,) [Pa] of principal moments at the nodes, at the bottom (sign 1) or the top."""
    plate = results.plate
    h, _ = results.elements.at_nodes(plate)
    principal = principal_moments(plate.moment_x, plate.moment_y, plate.moment_xy)
    return np.asarray(6 * (principal.m_1 if sign > 0 else -principal.m_2) / h**2)


def _error_of_stress(results: CombinationResult, sign: int) -> float | None:
    """Return the error of the largest tension at a face [Pa]."""
    return error_at_nodes(results, MOMENT, lambda mesh: _tension(mesh, sign))


#: What a group of forces fails at [N]: the forces, the sum of their distances [m], where they are.
Fails = Callable[[tuple[Force, ...], float, Location], float]


def _standing(floor: AnyFloor, slab: Slab, results: list[CombinationResult]) -> Standing:
    """Return the results of combinations with the forces in each."""
    borders = Borders(results[0].model)
    return [(result, acting_loads.forces(result, borders, slab.h, slab.l, floor.joint_transfer)) for result in results]


def _point_loads(slab: Slab, standing: Standing, fails: Fails, clauses: dict[int, str]) -> Iterator[DesignCheck]:
    """Yield the worst of single forces, of two and of four, each inside, at edges and at corners."""
    worst = dict[tuple[int, Location], Use]()
    for result, loads in standing:
        groups: Iterable[tuple[tuple[Force, ...], float]] = [((load,), 0.0) for load in loads]
        if 2 in clauses:
            groups = [*groups, *acting_loads.groups(loads, REACH * slab.l)]
        for members, distances in groups:
            location = acting_loads.worst_location(members)
            demand = sum(load.share * load.P for load in members)
            use = Use(demand, fails(members, distances, location), _middle(members), result.combination)
            key = len(members), location
            if key not in worst or use.share > worst[key].share:
                worst[key] = use
    for (count, location), use in sorted(worst.items()):
        yield _check(NAMES[count], location, use, "kN", 1e-3, clauses[count])


def _largest_transfer(standing: Standing) -> float:
    """Return the most that joints carry over of a force [N]."""
    return max(((1 - load.share) * load.P for _, loads in standing for load in loads), default=0.0)


def _joints(most: float) -> Iterator[DesignCheck]:
    """Yield what joints are relied on for, the most that they carry over of a force [N], which nothing checks."""
    if most > 0:
        words = Message("the transfer of up to {most:.4g kN} of a force across joints is not checked", most=most / 1e3)
        yield DesignCheck("load transfer at joints", "not checked", words)


def _middle(members: tuple[Force, ...]) -> tuple[float, float]:
    """Return where the resultant of forces acts [m]."""
    P = np.array([load.P for load in members])
    x, y = P @ np.array([load.place for load in members]) / P.sum()
    return float(x), float(y)


def _line_loads(slab: Slab, M: float, results: list[CombinationResult], clause: str) -> Iterator[DesignCheck]:
    """Yield the worst line load."""
    borders = Borders(results[0].model)
    near = strips.NEAR_EDGE / slab.lam
    uses = [
        Use(q, strips.line_load(M, slab.lam, away < near), place, result.combination)
        for result in results
        for q, away, place in acting_loads.line_loads(result, borders)
    ]
    if uses:
        yield _check("line load", "", max(uses, key=lambda use: use.share), "kN/m", 1e-3, clause)


def _pressures(slab: Slab, M: float, results: list[CombinationResult], clause: str) -> Iterator[DesignCheck]:
    """Yield the largest pressure against the one that may stand beside any aisle."""
    allowed = strips.aisle_load(max(M, math.ulp(1.0)), slab.lam)
    uses = [
        Use(q, allowed, place, result.combination) for result in results for q, place in acting_loads.pressures(result)
    ]
    if uses:
        yield _check("pressure beside aisles", "", max(uses, key=lambda use: use.share), "kPa", 1e-3, clause)


def _drag(floor: AnyFloor) -> float:
    """Return the tension [Pa] that friction adds where shrinkage is restrained."""
    if floor.friction is None or floor.joint_spacing is None:
        return 0.0
    return resistance.restraint_stress(floor.friction, floor.unit_weight, floor.joint_spacing)


def _restraint(floor: AnyFloor) -> Iterator[DesignCheck]:
    """Yield the tension by friction against the concrete's strength, if there is any."""
    if drag := _drag(floor):
        if isinstance(floor, TR34Floor):
            strength = resistance.tensile_strength(concrete_of(floor))
            clause = "mu gamma L / 2 against f_ctd, EN 1992-1-1 3.1.6(2)P"
        else:
            strength = allowed_stress(floor)
            clause = "mu gamma L / 2 against the allowed stress, ACI 360R-10 10.3.2"
        yield _check("restraint of shrinkage", "", Use(drag, strength, (0.0, 0.0), ""), "MPa", 1e-6, clause)


def _check(name: str, of: str, use: Use, unit: str, scale: float, clause: str) -> DesignCheck:
    """Return a check of a demand at its place."""
    holds = use.demand <= use.resistance
    values = Message(
        "{demand} {sign} {resistance}",
        demand=quantity(use.demand * scale, f"({unit})"),
        sign="<=" if holds else ">",
        resistance=quantity(use.resistance * scale, unit),
    )
    where = (
        Message(' at {place:.3f m} in "{combination}"', place=use.place, combination=Name(use.combination))
        if use.combination
        else ""
    )
    return DesignCheck(
        name,
        "no failure found" if holds else "fails",
        Message(
            "{of}: {values}{where} ({clause})" if of else "{values}{where} ({clause})",
            **({"of": of} if of else {}),
            values=values,
            where=where,
            clause=clause,
        ),
        of=of,
        demand=use.demand * scale,
        resistance=use.resistance * scale,
        unit=unit,
        clause=clause,
        combination=use.combination,
        place=use.place if use.combination else None,
        error=scaled(use.error, scale),
    )
