"""What punches at columns, piles and zones in ultimate combinations, at faces and around them (EN 1992-1-1 6.4).

Foundations are checked on all perimeters within 2 d (6.4.4(2)): what counts is the largest v_Ed / v_Rd over the
distance a from the face, v_Rd = v_Rd,c 2 d / a. It is looked for from STEPS on, which all combinations have, at further
distances where a parabola through the three largest has its top.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cache, partial
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np

from groundslab.arrays import Array, made_once, made_once_by
from groundslab.design.codes.en1992_2004 import punching as en1992
from groundslab.design.codes.en1992_2004.checks.punching_demand import (
    REACH,
    SAME_DISTANCE,
    ControlPerimeter,
    Demand,
    Stress,
    limited_outermost,
)
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.design.codes.en1992_2004.perimeters import face_length, openings, share_of_thinner
from groundslab.design.demands import line_properties, perimeter_loads
from groundslab.design.demands.by_plate import plate_under
from groundslab.design.demands.line_properties import Course
from groundslab.design.demands.perimeter_loads import (
    LoadsNear,
    MomentParts,
    PerimeterLoads,
    Places,
    PunchingForce,
    PunchingShear,
)
from groundslab.design.demands.perimeter_pieces import WeightedLegs, what_counts
from groundslab.design.demands.perimeter_shear import PerimeterShear
from groundslab.design.demands.perimeters import (
    Perimeter,
    SketchedPerimeter,
    Surroundings,
    perimeter_at,
    surroundings,
    within,
)
from groundslab.design.demands.zones.thicker_zones import ZoneForce, zone_forces
from groundslab.design.demands.zones.thinner_slab import ThinnerPart, thinner_parts, weighted
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.demand_errors import error_of
from groundslab.design.rules.punching import Demands
from groundslab.design.rules.punching_beta import beta_by_sectors, beta_of, betas_by_sectors, sector_pieces
from groundslab.errors import InputError
from groundslab.model.design.laid_bars import PunchingBars, punching_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult, Results

#: Distances of the perimeters that are looked at first, over the effective depth.
STEPS = np.arange(1, 9) / 4
#: So many halvings find the last perimeter before those that cut the slab, or run out to other edges.
HALVINGS = 7
#: So many further distances are tried at most for the largest v_Ed / v_Rd; a gain of this share is none.
MOST_TRIALS, GAIN = 10, 1e-4
#: An eccentricity [m] smaller than this points nowhere.
NO_ECCENTRICITY = 1e-9


@made_once
def column_demands(combined: Results) -> Demands[Demand]:
    """Return the demands of punching in all ultimate combinations, if bars are given; at columns."""
    around = {name for (_, name), demand in zone_demands(combined).found.items() if demand.around}
    zones = tuple(zone for zone in zone_forces(combined) if zone.name in around)
    return _demands(combined, perimeter_loads.punching_columns(combined.solved_model), zones)


@made_once
def pile_demands(combined: Results) -> Demands[Demand]:
    """Return the demands of punching in all ultimate combinations, if bars are given; at piles."""
    return _demands(combined, perimeter_loads.punching_piles(combined.model))


def _demands(
    combined: Results, forces: tuple[PunchingForce, ...], zones: tuple[ZoneForce, ...] = ()
) -> Demands[Demand]:
    """Return the demands of forces that punch the plate; zones with demands of their own take over beyond them."""
    model, steel = combined.model, combined.model.reinforcement
    results = ultimate_results(combined)
    governing: dict[tuple[str, str], Demand] = {}
    missing: dict[str, str] = {}
    reach: dict[tuple[bool, str], float] = {}
    if steel is None:
        return Demands()
    make = partial(_site, steel=steel, zones=zones)
    for punching, site, pushing in perimeter_loads.pushing_forces(results, forces, model, (_sites, make)):
        of_combinations, why = _largest(pushing, site)
        if why and not (punching.at_zone and any(demand.around for demand in of_combinations)):
            missing[punching.name] = why
        # beyond d from the face, where uniform loads are, one-way shear is checked in any case (6.2.1(8))
        last = max((stress.distance for demand in of_combinations for stress in demand.around), default=0.0)
        reach[punching.key] = min(max(site.d, last), reach.get(punching.key, math.inf))
        for demand in of_combinations:
            perimeter_loads.add_worse(governing, (demand.combination, punching.name), demand, _most_used)
    return Demands(governing, missing, reach)


def _most_used(demand: Demand) -> float:
    """Return the largest v_Ed / v_Rd around, or v_Ed at the face where nothing is around."""
    stress = demand.governing
    return demand.used(stress) if stress is not None else 0.0 if demand.face is None else demand.face.v_Ed


@made_once
def zone_demands(combined: Results) -> Demands[Demand]:
    """Return the demands around thicker zones with columns on them (6.4.2(8) to (11)), at none of their faces."""
    return _demands(combined, zone_forces(combined))


@dataclass(frozen=True, slots=True)
class _Site:
    """A column or pile on its plate, and the perimeters around it that are known, by their distance."""

    punching: PunchingForce
    steel: Reinforcement
    bars: PunchingBars | None  # in tension that count, None if none are laid
    d: float  # effective depth [m]
    around: Surroundings | None
    near: LoadsNear | None
    thinner: tuple[ThinnerPart, ...]  # parts of the plate that perimeters may reach
    u_0: float  # [m]
    why: str  # it does not lie on the plate; else empty
    zone: ZoneForce | None = None  # on which it stands, and whose perimeters are judged
    lines: dict[float, Perimeter | str] = field(default_factory=dict)
    controls: dict[float, ControlPerimeter | str] = field(default_factory=dict)

    def line(self, distance: float) -> Perimeter | str:
        """Return how the perimeter at a distance [m] from the face runs, or why there is none."""
        if distance not in self.lines:
            self.lines[distance] = self._line(distance)
        return self.lines[distance]

    def _line(self, distance: float) -> Perimeter | str:
        if self.around is None:
            return self.why
        try:
            line = perimeter_at(self.around, distance)
        except InputError as error:
            return str(error)
        if distance > 0 and line.cut:
            return CUT
        if line_properties.straight(line.legs):
            return STRAIGHT
        return BEYOND if self._leaves_zone(line, distance) else line

    def _leaves_zone(self, line: Perimeter, distance: float) -> bool:
        """Return whether a perimeter, but for the first one, lies wholly outside of the zone."""
        if self.zone is None or distance <= STEPS[0] * self.d:
            return False
        inside = line_properties.total_length(within(line.legs, self.zone.footprint.region))
        return inside < SAME_DISTANCE * self.d

    def control(self, results: CombinationResult, distance: float) -> ControlPerimeter | str:
        """Return the perimeter at a distance [m] from the face with what is inside, or why there is none."""
        (control,) = self.controls_at(results, [distance])
        return control

    def controls_at(self, results: CombinationResult, distances: list[float]) -> list[ControlPerimeter | str]:
        """Return the perimeters at distances [m] from the face with what is inside, or why there are none."""
        lines: dict[float, Perimeter] = {}
        for distance in (missing for missing in distances if missing not in self.controls):
            line = self.line(distance)
            if isinstance(line, str):
                self.controls[distance] = line
            else:
                lines[distance] = line
        if lines and self.around is not None and self.near is not None:
            parts = [self.punching.area_inside(line, distance) for distance, line in lines.items()]
            loads = self.near.inside_each(results, parts)
            for (distance, line), inside in zip(lines.items(), loads, strict=True):
                counted = weighted(line.legs, self.thinner, share_of_thinner, distance, self.d)
                control = _control((line, counted), distance, self.punching, self.d, self.around, inside)
                self.controls[distance] = control if distance > 0 else replace(control, u=self.u_0)
        return [self.controls[distance] for distance in distances]


#: Why there is no perimeter at some distance.
STRAIGHT = "what openings leave of its perimeter is straight and resists no moment"
CUT = "its control perimeters cut the slab from edge to edge, which is one-way shear"

#: Why a perimeter is none of a column on a thicker zone.
BEYOND = "the perimeters around its zone are judged instead"


@made_once_by(lambda results, model: (results.plate.nodes, model))
def _sites(results: CombinationResult, model: Model) -> Places[_Site]:  # noqa: ARG001
    """Return those of the columns and piles of a model, as they are added."""
    return {}


def _site(
    results: CombinationResult, punching: PunchingForce, steel: Reinforcement, zones: tuple[ZoneForce, ...]
) -> _Site:
    """Return a column or pile on its plate, which may be on one of the thicker zones."""
    plate, footprint, model = plate_under(results, *punching.place), punching.footprint, results.model
    d = punching.depth(results, steel)
    bars = _bars(model, punching, steel, d)
    try:
        around = surroundings(plate, footprint, REACH * d, openings(d))
    except InputError as error:
        return _Site(punching, steel, bars, d, None, None, (), 0.0, str(error))
    near = perimeter_loads.loads_near(results, punching, REACH * d)
    thinner = thinner_parts(results, around.footprint, punching.thickness(results), REACH * d)
    on = [zone for zone in zones if set(punching.columns) & set(zone.columns)]
    zone = min(on, key=lambda zone_force: zone_force.footprint.region.area, default=None)
    return _Site(punching, steel, bars, d, around, near, thinner, face_length(around, d), "", zone)


def _bars(model: Model, punching: PunchingForce, steel: Reinforcement, d: float) -> PunchingBars | None:
    """Return the bars provided in tension at a column or pile (6.4.4(1)), if any are."""
    if not steel.laid:
        return None
    face: Literal["bottom", "top"] = "top" if punching.from_below else "bottom"
    return punching_bars(model.plate, steel, punching.column, d, model.plates, face)


def _control(
    lines: tuple[Perimeter, tuple[WeightedLegs, ...]],
    distance: float,
    punching: PunchingForce,
    d: float,
    around: Surroundings,
    loads: PerimeterLoads,
) -> ControlPerimeter:
    """Return a perimeter and the parts of it that count with what EN 1992-1-1 needs of it."""
    from shapely import get_coordinates

    line, parts = lines
    legs = what_counts(parts)
    course = line_properties.course(line.ring, around.axes)
    # at the face of a column in a notch nothing may be left
    center = line_properties.centroid(legs) if len(legs) else np.array(around.center)
    frame = course.frame
    points = get_coordinates(around.footprint)
    c_1, c_2 = np.ptp(points @ frame.T, axis=0)
    reduced = reduced_share(legs, points, course, d) if course.shape == "edge" else 1.0
    return ControlPerimeter(
        distance,
        line_properties.total_length(legs),
        center,
        course,
        line_properties.moduli(legs @ frame.T, frame @ center) if len(legs) else np.full(2, np.inf),
        np.array([en1992.transfer_share(c_1 / c_2), en1992.transfer_share(c_2 / c_1)]),
        reduced,
        line.opened or legs is not line.legs,
        loads,
        SketchedPerimeter(line, parts, around.center, frame, np.array(punching.place)),
        line.legs,
        d,
        (float(c_1), float(c_2)),
        tuple(np.ptp(points @ course.inward.T, axis=0).tolist()),
    )


def reduced_share(legs: Array, footprint: Array, course: Course, d: float) -> float:
    """Return u_1* / u_1 of legs (l, 2, 2) at an edge around a footprint's points (k, 2), by Figure 6.20a.

    Of legs at a right angle to the edge the least of 1.5 d and half of the column's side counts, from its inner face.
    """
    inward = course.frame[1] * (np.sign(course.frame[1] @ course.inward.sum(axis=0)) or 1.0)
    across = footprint @ inward
    least = across.max() - min(1.5 * d, 0.5 * np.ptp(across))
    start, end = legs[:, 0] @ inward - least, legs[:, 1] @ inward - least
    length = line_properties.lengths(legs)
    size = np.abs(start) + np.abs(end)
    # of a leg that crosses the limit, the part beyond it
    beyond = np.divide(np.maximum(start, 0) + np.maximum(end, 0), size, out=np.zeros_like(size), where=size > 0)
    return float(length @ beyond / length.sum())


def _largest(results: list[CombinationResult], site: _Site) -> tuple[list[Demand], str]:
    """Return the demands of combinations on perimeters so chosen that the largest v_Ed / v_Rd of all is among them.

    With the reason why there is none at all; farther out they may cut the slab, or leave a pad.
    """
    first = results[0]
    face = "no column" if site.punching.at_zone else site.control(first, 0.0)
    distances, why = _first_distances(site)
    demands = [_demand(result, site, face, distances) for result in results]
    for _ in range(MOST_TRIALS):
        distance = _next_distance(demands, site.d)
        if distance is None or isinstance(control := site.control(first, distance), str):
            break
        demands = [
            _with_perimeter(demand, result, site, control) for demand, result in zip(demands, results, strict=True)
        ]
    return demands, why


def _first_distances(site: _Site) -> tuple[list[float], str]:
    """Return the distances [m] of perimeters that there are, up to the last one, and why there are none.

    Where perimeters begin to run out to an edge the part inside jumps: the distances on both sides are among them.
    """
    good: list[float] = []
    steps = [float(distance) for distance in STEPS * site.d]
    for before, distance in pairwise([0.0, *steps]):
        line, line_before = site.line(distance), site.line(before)
        if isinstance(line, str):
            last, _ = _halved(before, distance, lambda a: not isinstance(site.line(a), str))
            good += [last] if last > before else []
            return [*dict.fromkeys(good)], "" if good else line
        if good and not isinstance(line_before, str) and line_before.setbacks != line.setbacks:
            good += _halved(before, distance, partial(_runs_out_to, site, line_before.setbacks))
        good.append(distance)
    return [*dict.fromkeys(good)], ""


def _runs_out_to(site: _Site, setbacks: tuple[float, ...], distance: float) -> bool:
    """Return whether the perimeter at a distance [m] runs out to edges of these setbacks [m] and no others."""
    line = site.line(distance)
    return not isinstance(line, str) and line.setbacks == setbacks


def _halved(low: float, high: float, holds: Callable[[float], bool]) -> tuple[float, float]:
    """Return two distances [m] closer to each other, at the lower of which something still holds."""
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low, high


def _next_distance(demands: list[Demand], d: float) -> float | None:
    """Return where v_Ed / v_Rd may be larger than at all distances tried yet [m], None if nowhere."""
    governing = [(demand, stress) for demand in demands if (stress := demand.governing) is not None]
    if not governing:
        return None
    demand, top = max(governing, key=lambda pair: pair[0].used(pair[1]))
    a = np.array([0.0, *(stress.distance for stress in demand.around)])
    y = np.array([0.0, *map(demand.used, demand.around)])
    i = int(np.argmax(y))
    if y[i] <= 0:
        return None
    middle = min(i, len(a) - 2)
    three = slice(middle - 1, middle + 2) if middle > 0 else slice(0, 0)
    highest, gain = _top(a[three], y[three])
    if gain > GAIN * y[i] and abs(a - highest).min() > SAME_DISTANCE * d:
        return highest
    # a kink looks like a flat top to a parabola whose points are far apart
    wide = max(((high - low, (low + high) / 2) for low, high in pairwise(a[max(i - 1, 0) : i + 2])), default=(0.0, 0.0))
    return wide[1] if wide[0] > d / 6 and top.distance < a[-1] else None


def _top(a: Array, y: Array) -> tuple[float, float]:
    """Return where a parabola through three points (3,) is highest between them, and by how much above them."""
    if len(a) < 3:
        return float(a[-1]) if len(a) else 0.0, 0.0
    slopes = np.diff(y) / np.diff(a)
    second = float((slopes[1] - slopes[0]) / (a[2] - a[0]))  # y = y_0 + slope (a - a_0) + second (a - a_0) (a - a_1)
    if second >= 0:
        return float(a[1]), 0.0
    at = float(np.clip((a[0] + a[1]) / 2 - slopes[0] / (2 * second), a[0], a[-1]))
    return at, float(y[0] + (at - a[0]) * (slopes[0] + second * (at - a[1]))) - float(y.max())


def _demand(results: CombinationResult, site: _Site, face: ControlPerimeter | str, distances: list[float]) -> Demand:
    """Return the demand of a combination on perimeters at distances [m] and at the face."""
    controls = [control for control in site.controls_at(results, distances) if not isinstance(control, str)]
    stresses = tuple(_stress(results, site, control) for control in controls)
    concrete, bars = materials(site.steel, results.limit_state)
    most = en1992.most_bars(concrete, bars)
    ratio = most if site.bars is None else min(site.bars.ratio(site.d), most)
    v_Rd_c = en1992.resistance_without_links(concrete, site.d, ratio)
    force = float(site.punching.pushing(results)[0])
    at_face = None
    if not isinstance(face, str) and np.isfinite((outer := controls[-1] if controls else face).moduli).all():
        at_face = _face_stress(results, site, face, outer)
    about = site.punching.name, results.combination, results.limit_state, force, site.d
    return Demand(
        *about, v_Rd_c, at_face, stresses, ratio=ratio, bars=site.bars, pulls=site.punching.pulls,
        place=site.punching.place, thickness=site.punching.thickness(results),
        changed=cache(partial(_changed, results, site)),
    )  # fmt: skip


@dataclass(frozen=True)
class _InThickerSlab(PunchingForce):
    """A column or pile where the slab is thicker."""

    thicker: float = 0.0  # [m]

    def thickness(self, results: CombinationResult) -> float:
        """Return the thickness of the plate that it punches [m]."""
        return super().thickness(results) + self.thicker


def _changed(results: CombinationResult, site: _Site, thicker: float, wider: float) -> Demand | None:
    """Return the demand of a column or pile where the slab is thicker and it is wider [m]; None where there is none.

    On all perimeters on which links are limited.
    """
    punching = site.punching
    if punching.at_zone:
        return None
    sides = {
        name: value + wider
        for name in ("width_x", "width_y", "diameter")
        if (value := getattr(punching.column, name)) is not None
    }
    column = punching.column.model_copy(update=sides)
    other = _InThickerSlab(column, punching.by_case, punching.support, punching.pulls, thicker)
    changed_site = _site(results, other, site.steel, () if site.zone is None else (site.zone,))
    demand = None
    if limited_outermost(materials(site.steel)[0].annex, at_face=True):
        distances, _ = _first_distances(changed_site)
        demand = _demand(results, changed_site, changed_site.control(results, 0.0), distances[-1:])
    if demand is None or demand.face is None:
        (demand,), _ = _largest([results], changed_site)
    return demand if demand.around else None


def _with_perimeter(demand: Demand, results: CombinationResult, site: _Site, control: ControlPerimeter) -> Demand:
    """Return a demand with one more perimeter."""
    around = sorted([*demand.around, _stress(results, site, control)], key=lambda stress: stress.distance)
    return replace(demand, around=tuple(around))


def _stress(results: CombinationResult, site: _Site, control: ControlPerimeter) -> Stress:
    """Return the demand on a perimeter in a combination.

    beta is that of the moments of all forces inside about the perimeter's center, of loads and pressure.
    """
    shear = perimeter_loads.punching_shear(
        results, control.loads, site.punching, control.center, edge_relieves=site.steel.line_force_relieves
    )
    pushing = site.punching.pushing(results)
    alone = shear.V <= 0 or perimeter_loads.only_turns(pushing)
    raised = _raised(results, site, control, shear.moments, shear.V, None if alone else pushing[1:])
    beta = None if alone else raised.force / shear.V
    turned = control.course.frame @ shear.moments
    v_Ed = raised.force / (control.u * site.d)
    return Stress(
        control.distance,
        control.u,
        shear.V,
        beta,
        v_Ed,
        shear.supported,
        shear.pressure,
        shear.edge,
        shear.others,
        lambda: error_of(results, lambda mesh: _stress(mesh, site, control).v_Ed),
        control,
        (float(turned[0]), float(turned[1])),
        shear.parts.along(control.course.frame),
        way=raised.way,
        outward=raised.outward,
        both=raised.both,
        cases=shear.cases,
        other_betas=lambda: {} if alone else _other_ways(results, site, control, shear, pushing[1:]),
    )


def _face_stress(results: CombinationResult, site: _Site, face: ControlPerimeter, outer: ControlPerimeter) -> Stress:
    """Return the demand at the face (6.4.5(3)), beta that of the own force and moments on the outermost perimeter.

    Where no force acts, or none is left, what the moments add there counts.
    """
    stress = _stress(results, site, face)
    pushing = site.punching.pushing(results)
    force, applied = float(pushing[0]), pushing[1:]
    moments = applied + force * (np.array(site.punching.place) - outer.center)
    alone = stress.V_Ed <= 0 or perimeter_loads.only_turns(pushing)
    by_moments = _raised(results, site, outer, moments, 0.0 if alone else force, None if alone else applied)
    beta = None if alone else by_moments.force / force
    raised = stress.V_Ed + by_moments.force if beta is None else beta * stress.V_Ed
    turned = outer.course.frame @ moments
    nothing = np.zeros(2)
    parts = MomentParts(applied, np.array(site.punching.place) - outer.center, *[nothing] * 4)
    return replace(
        stress,
        beta=beta,
        v_Ed=raised / (face.u * site.d),
        moments=(float(turned[0]), float(turned[1])),
        parts=parts.along(outer.course.frame),
        outer=outer,
        way=by_moments.way,
        both=by_moments.both,
        error=lambda: error_of(results, lambda mesh: _face_stress(mesh, site, face, outer).v_Ed),
    )


class _Raised(NamedTuple):
    """Beta times a force, and how it was found."""

    force: float  # [N]
    way: str = "code"
    outward: float | None = None  # a moment of the column that bends it outwards and decides [N m]
    both: bool = False  # whether at an edge or corner the larger one of 6.39 and the simpler value counts


def _raised(
    results: CombinationResult,
    site: _Site,
    control: ControlPerimeter,
    moments: Array,
    force: float,
    applied: Array | None,
) -> _Raised:
    """Return beta times a force [N] as the case asks for it; by moments where nothing pushes, or no sector is known."""
    asked = beta_of(results.solved_model, site.steel, site.punching) if applied is not None else "code"
    if asked == "constant":
        return _Raised(_constant(site, control) * force, asked)
    if asked == "sectors":
        sign = -1.0 if site.punching.from_below else 1.0
        beta = beta_by_sectors(*_sectors(results, site, control), sign=sign)
        if beta is not None:
            return _Raised(max(beta, materials(site.steel)[0].annex.least_beta) * force, asked)
    elif asked != "code":
        return _Raised(asked * force, "given")
    return _raised_by_moments(site, control, moments, force, applied)


def _constant(site: _Site, control: ControlPerimeter) -> float:
    """Return the constant beta of a perimeter by how it runs."""
    inside, edge, corner = materials(site.steel)[0].annex.constant_beta
    return {"closed": inside, "edge": edge}.get(control.course.shape, corner)


def _sectors(
    results: CombinationResult, site: _Site, control: ControlPerimeter
) -> tuple[tuple[PerimeterShear, ...], PlateResult, Array, Array]:
    """Return what shear forces in sectors of a perimeter are read from: its pieces, the plate, its center and axis."""
    plate, center = plate_under(results, *site.punching.place), np.array(site.punching.place)
    if not control.sectors:
        control.sectors.append(sector_pieces(plate, control.legs, center, site.d))
    return control.sectors[0], plate, center, control.course.frame[0]


def _other_ways(
    results: CombinationResult, site: _Site, control: ControlPerimeter, shear: PunchingShear, applied: Array
) -> dict[str, float]:
    """Return beta by moments, constant, and by numbers of sectors."""
    by_moments = _raised_by_moments(site, control, shear.moments, shear.V, applied)
    sign = -1.0 if site.punching.from_below else 1.0
    by_sectors = betas_by_sectors(*_sectors(results, site, control), sign=sign)
    return {"code": by_moments.force / shear.V, "constant": _constant(site, control), **by_sectors}


def _raised_by_moments(
    site: _Site, control: ControlPerimeter, moments: Array, force: float, applied: Array | None
) -> _Raised:
    """Return beta times a force [N] of moments (2,) [N m] along x and y about a perimeter's center (6.4.3, 6.4.4(2)).

    Values for edges and corners (6.4.3(4) and (5), Figure 6.21N) are for perimeters without openings and for moments
    `applied` (2,) [N m] of the column that do not bend it outwards; else 6.39 counts, if it is larger, and without them
    it counts alone, as no force pushes. None is less than that of the annex.
    """
    least = materials(site.steel)[0].annex.least_beta * force
    turned, shape = control.course.frame @ moments, control.course.shape
    general = en1992.raised(list(turned), list(control.shares), force, control.u, list(control.moduli))
    if applied is None:
        return _Raised(general)
    if shape == "closed":
        return _Raised(max(least, general))
    simple = en1992.CORNER * force
    if shape == "edge":
        share = en1992.transfer_share(en1992.edge_ratio(*control.widths))
        along, W = float(turned[0]), float(control.moduli[0])
        simple = en1992.raised_at_an_edge(control.reduced, along, share, force, control.u, W)
    outward = -float((control.course.inward @ applied).min(initial=0.0))
    if not (control.opened or outward > NO_ECCENTRICITY * force):
        return _Raised(max(least, simple))
    decides = general > max(least, simple) and not control.opened
    return _Raised(max(least, simple, general), outward=outward if decides else None, both=True)
