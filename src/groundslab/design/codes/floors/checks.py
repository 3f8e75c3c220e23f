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
from functools import partial

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004 import perimeter_demand
from groundslab.design.codes.en1992_2004 import punching as punching_resistance
from groundslab.design.codes.en1992_2004.materials import Concrete
from groundslab.design.codes.en1992_2004.perimeters import face_length, openings
from groundslab.design.codes.floors import acting_loads, force_steps, resistance, slab_steps, strips, yield_lines
from groundslab.design.codes.floors.acting_loads import Borders, Force
from groundslab.design.codes.floors.slab import (
    Slab,
    allowed_stress,
    concrete_of,
    effective_depth,
    friction_stress,
    sagging_moment,
    slab_of,
)
from groundslab.design.codes.floors.yield_lines import Location, YieldSlab
from groundslab.design.demands.by_plate import split_by_plate
from groundslab.design.demands.design_moments import principal_moments
from groundslab.design.demands.perimeters import RectangularColumn, RoundColumn, surroundings
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import NO_COMBINATION, NO_FOOTPRINT, NO_PERIMETER, DesignCheck, not_judged
from groundslab.design.rules.combinations import solved_results, ultimate_results, why_none
from groundslab.design.rules.demand_errors import MOMENT, error_at_nodes, error_of, scaled
from groundslab.errors import InputError
from groundslab.messages import Message, Name, joined, quantity
from groundslab.model.design.floors import ACI360Floor, AnyFloor, TR34Floor
from groundslab.model.loads.load_cases import SERVICEABILITY, STRENGTH
from groundslab.results.fields import extreme_node, place_of
from groundslab.results.results import CombinationResult, Results

#: Within so many radii of relative stiffness loads may fail together.
REACH = 7.0
#: Results of combinations, with the forces in each.
Standing = list[tuple[CombinationResult, list[Force]]]
#: Faces of the slab, and the sign of moments that make tension there.
FACES = {"bottom": 1, "top": -1}
NAMES = {1: "point load", 2: "dual point load", 4: "quadruple point load"}


@dataclass(frozen=True, slots=True)
class Use:
    """A demand and what resists it, in SI units, with its place [m], combination and discretization error."""

    demand: float
    resistance: float
    place: tuple[float, float]
    combination: str
    error: float | None = None  # of the demand; none of loads that are given
    steps: Callable[[], Iterable[Step]] = tuple  # its calculation, which is made of what governs alone

    @property
    def share(self) -> float:
        """Return demand over resistance; infinite where nothing resists."""
        return self.demand / self.resistance if self.resistance else math.inf


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


def _by_tr34(floor: TR34Floor, slab: Slab, standing: Standing) -> Iterator[DesignCheck]:
    """Yield point loads, line loads and pressures on a plate by TR34 in the ultimate combinations."""
    concrete = concrete_of(floor)
    results = [result for result, _ in standing]
    M_n = resistance.plain_moment(concrete, slab.h)
    lines = YieldSlab(slab.l, sagging_moment(floor, concrete, slab.h), M_n)

    def fails(loads: tuple[Force, ...], distances: float, location: Location) -> float:
        return yield_lines.together(lines, [load.a for load in loads], distances, location)

    clause = Message("TR34 yield lines, Meyerhof 1962{springs}", springs=slab.springs)
    yield from _point_loads(
        slab, standing, (fails, partial(force_steps.by_tr34, floor, slab)), dict.fromkeys(NAMES, clause)
    )
    yield from _punching(floor, concrete, slab, standing)
    yield from _line_loads(floor, slab, results, Message("TR34, Hetenyi 1946{springs}", springs=slab.springs))
    yield from _pressures(floor, slab, M_n, results, Message("TR34, Hetenyi 1946{springs}", springs=slab.springs))


def _punching(floor: TR34Floor, concrete: Concrete, slab: Slab, standing: Standing) -> Iterator[DesignCheck]:
    """Yield punching where it uses most inside, at an edge and at a corner: at footprints, and 2 d from them."""
    largest = dict[tuple[Location, bytes], tuple[Force, CombinationResult]]()
    bare = dict[Location, Force]()
    for result, loads in standing:
        for load in loads:
            if not load.a:
                bare.setdefault(load.location, load)
                continue
            place = load.location, load.shape.wkb
            before = largest.get(place)
            if before is None or load.share * load.P > before[0].share * before[0].P:
                largest[place] = load, result
    by_location = dict[Location, list[tuple[Force, CombinationResult]]]()
    for (location, _), loaded in largest.items():
        by_location.setdefault(location, []).append(loaded)
    for location, loaded_places in sorted(by_location.items()):
        yield from _punching_at(location, floor, concrete, slab, loaded_places)
    for location, load in sorted(bare.items()):
        why = Message("a force without a footprint stands at {place:.3f m}", place=load.place)
        yield not_judged("punching", NO_FOOTPRINT, joined((location, why)), of=location)


def _punching_at(
    location: Location,
    floor: TR34Floor,
    concrete: Concrete,
    slab: Slab,
    loaded: list[tuple[Force, CombinationResult]],
) -> Iterator[DesignCheck]:
    """Yield the worst punching by forces at places that are alike, each with the combination in which it is largest."""
    d = effective_depth(floor, slab.h)
    rho = 0.0 if floor.mesh_area is None else floor.mesh_area / d
    v_Rd_max = punching_resistance.max_resistance(concrete)
    assert v_Rd_max is not None  # the recommended values have it
    v_Rd_c = punching_resistance.resistance_without_links(concrete, d, rho)
    at_faces, around_them = list[Use](), list[tuple[Use, Callable[[], float | None]]]()
    why = ""
    for load, result in loaded:
        column, force = acting_loads.as_column(load), load.share * load.P
        try:
            around = surroundings(result.plate, column, 0.0, openings(d))
            u_0, found = face_length(around, d), perimeter_demand.demand(result.plate, column, d, force)
        except InputError as error:
            why = why or str(error)
            continue
        steps = partial(force_steps.at_footprint, floor, slab, load, around, u_0)
        at_faces.append(Use(force / (u_0 * d), v_Rd_max, load.place, result.combination, steps=steps))
        steps = partial(force_steps.around_it, floor, slab, load, around, found)
        use = Use(max(found.v_Ed, 0.0), v_Rd_c, load.place, result.combination, steps=steps)
        around_them.append((use, partial(_error_of_punching, result, column, d, force)))
    clause = "TR34, EN 1992-1-1 6.4"
    if why:
        yield not_judged("punching", NO_PERIMETER, joined((location, why)), of=location)
    if at_faces:
        at_face = max(at_faces, key=lambda each: each.share)
        yield _check("punching at the footprint", location, at_face, "MPa", 1e-6, clause)
        use, error_of_use = max(around_them, key=lambda each: each[0].share)
        yield _check("punching", location, replace(use, error=error_of_use()), "MPa", 1e-6, clause)


def _error_of_punching(
    results: CombinationResult, column: RectangularColumn | RoundColumn, d: float, force: float
) -> float | None:
    """Return the error of v_Ed [Pa] at 2 d from a footprint under a force [N]."""
    return error_of(results, lambda mesh: perimeter_demand.demand(mesh.plate, column, d, force).v_Ed)


def _by_aci(floor: ACI360Floor, slab: Slab, standing: Standing) -> Iterator[DesignCheck]:
    """Yield stresses, pressures and, of fiber concrete, yield lines by ACI 360R in combinations of serviceability."""
    results = [result for result, _ in standing]
    allowed = allowed_stress(floor)
    drag = friction_stress(floor)
    for face, sign in FACES.items():
        uses = [_stress(floor, result, face, sign) for result in results]
        clause = "ACI 360R-10 7.2, 5.9, table 5.3"
        worst = max(range(len(uses)), key=lambda number: uses[number].share)
        use = replace(uses[worst], error=_error_of_stress(results[worst], sign))
        yield _check("flexural stress", face, use, "MPa", 1e-6, clause)
    clause = Message("PCA, ACI 360R-10 A1{springs}", springs=slab.springs)
    yield from _pressures(floor, slab, (allowed - drag) * slab.h**2 / 6, results, clause)
    if floor.R_e3 is not None:
        M_0 = force_steps.cracked_moment(floor, slab.h)

        def fails(loads: tuple[Force, ...], distances: float, location: Location) -> float:  # noqa: ARG001
            (load,) = loads
            return yield_lines.meyerhof(M_0, load.a, slab.l, location) / floor.safety_factor

        def steps(loads: tuple[Force, ...], distances: float, location: Location) -> Iterable[Step]:  # noqa: ARG001
            return force_steps.by_meyerhof(floor, slab, loads[0])

        clause = Message("ACI 360R-10 11.3.3.3, Meyerhof 1962{springs}", springs=slab.springs)
        yield from _point_loads(slab, standing, (fails, steps), {1: clause})


def _stress(floor: ACI360Floor, results: CombinationResult, face: str, sign: int) -> Use:
    """Return the largest tension at a face, 6 m / h^2 of principal moments and what friction adds, against a stress."""
    plate, tension = results.plate, _tension(results, sign)
    node = extreme_node(plate.nodes, tension, 1)
    stress, h = max(float(tension[node]), 0.0) + friction_stress(floor), results.elements.at_nodes(plate)[0]
    moments = float(plate.moment_x[node]), float(plate.moment_y[node]), float(plate.moment_xy[node])
    steps = partial(slab_steps.stress, floor, moments, float(h[node]), stress, face)
    return Use(stress, allowed_stress(floor), place_of(plate.nodes, node), results.combination, steps=steps)


def _tension(results: CombinationResult, sign: int) -> Array:
    """Return the tension 6 m / h^2 (n,) [Pa] of principal moments at the nodes, at the bottom (sign 1) or the top."""
    plate = results.plate
    h, _ = results.elements.at_nodes(plate)
    principal = principal_moments(plate.moment_x, plate.moment_y, plate.moment_xy)
    return np.asarray(6 * (principal.m_1 if sign > 0 else -principal.m_2) / h**2)


def _error_of_stress(results: CombinationResult, sign: int) -> float | None:
    """Return the error of the largest tension at a face [Pa]."""
    return error_at_nodes(results, MOMENT, lambda mesh: _tension(mesh, sign))


#: What a group of forces fails at [N], and its steps: by the forces, the sum of their distances [m], where they are.
Resists = Callable[[tuple[Force, ...], float, Location], float]
Followed = Callable[[tuple[Force, ...], float, Location], Iterable[Step]]


def _standing(floor: AnyFloor, slab: Slab, results: list[CombinationResult]) -> Standing:
    """Return the results of combinations with the forces in each."""
    borders = Borders(results[0].model)
    return [(result, acting_loads.forces(result, borders, slab.h, slab.l, floor.joint_transfer)) for result in results]


def _point_loads(
    slab: Slab, standing: Standing, fails: tuple[Resists, Followed], clauses: dict[int, str]
) -> Iterator[DesignCheck]:
    """Yield the worst of single forces, of two and of four, each inside, at edges and at corners."""
    worst = dict[tuple[int, Location], Use]()
    fails_at, steps = fails
    for result, loads in standing:
        groups: Iterable[tuple[tuple[Force, ...], float]] = [((load,), 0.0) for load in loads]
        if 2 in clauses:
            groups = [*groups, *acting_loads.groups(loads, REACH * slab.l)]
        for members, distances in groups:
            location = acting_loads.worst_location(members)
            demand = sum(load.share * load.P for load in members)
            follow = partial(steps, members, distances, location)
            resists = fails_at(members, distances, location)
            use = Use(demand, resists, _middle(members), result.combination, steps=follow)
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


def _line_loads(floor: TR34Floor, slab: Slab, results: list[CombinationResult], clause: str) -> Iterator[DesignCheck]:
    """Yield the worst line load."""
    borders, M_n = Borders(results[0].model), resistance.plain_moment(concrete_of(floor), slab.h)
    near = strips.NEAR_EDGE / slab.lam
    uses = []
    for result in results:
        for line in acting_loads.line_loads(result, borders):
            at_edge = line.away < near
            steps = partial(slab_steps.line_load, floor, slab, line, at_edge=at_edge)
            most = strips.line_load(M_n, slab.lam, at_edge)
            uses.append(Use(line.factor * line.q, most, line.place, result.combination, steps=steps))
    if uses:
        yield _check("line load", "", max(uses, key=lambda use: use.share), "kN/m", 1e-3, clause)


def _pressures(
    floor: AnyFloor, slab: Slab, M: float, results: list[CombinationResult], clause: str
) -> Iterator[DesignCheck]:
    """Yield the largest pressure against the one that may stand beside any aisle."""
    allowed = strips.aisle_load(max(M, 0.0), slab.lam)
    uses = [
        Use(each.total, allowed, each.place, result.combination,
            steps=partial(slab_steps.pressure, floor, slab, each, allowed))
        for result in results
        for each in acting_loads.pressures(result)
    ]  # fmt: skip
    if uses:
        yield _check("pressure beside aisles", "", max(uses, key=lambda use: use.share), "kPa", 1e-3, clause)


def _restraint(floor: AnyFloor) -> Iterator[DesignCheck]:
    """Yield the tension by friction against the concrete's strength, if there is any."""
    if drag := friction_stress(floor):
        if isinstance(floor, TR34Floor):
            strength = resistance.tensile_strength(concrete_of(floor))
            clause = "mu gamma L / 2 against f_ctd, EN 1992-1-1 3.1.6(2)P"
        else:
            strength = allowed_stress(floor)
            clause = "mu gamma L / 2 against the allowed stress, ACI 360R-10 10.3.2"
        use = Use(drag, strength, (0.0, 0.0), "", steps=partial(slab_steps.restraint, floor))
        yield _check("restraint of shrinkage", "", use, "MPa", 1e-6, clause)


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
        steps=tuple(use.steps()),
    )
