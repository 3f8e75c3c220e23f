"""What punches at columns, piles and zones in ultimate combinations by ACI 318-19 22.6 and 8.4.4.2, at d / 2."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from groundslab.arrays import Array, made_once, made_once_by
from groundslab.design.codes.aci318 import punching as aci318
from groundslab.design.codes.aci318.materials import PHI_SHEAR
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.demands import line_properties, perimeter_loads
from groundslab.design.demands.by_plate import plate_under
from groundslab.design.demands.perimeter_loads import (
    CaseInside,
    MomentParts,
    PerimeterLoads,
    Places,
    PunchingForce,
    PunchingShear,
)
from groundslab.design.demands.perimeter_pieces import WeightedLegs, what_counts
from groundslab.design.demands.perimeters import Openings, Perimeter, SketchedPerimeter, perimeter_at, surroundings
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.demands.zones.thinner_slab import depth_share, thinner_parts, weighted
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.demand_errors import error_of
from groundslab.design.rules.punching import Demands
from groundslab.design.rules.wall_ends import WallSite
from groundslab.errors import InputError
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult, Results

#: Why there is no critical section.
CUT = "its critical section cuts the slab from edge to edge, which is one-way shear"
#: So many edges end a critical section.
EDGES = {"edge": 1, "corner": 2}
#: An opening counts if it is closer than this to the column, over the slab's thickness (22.6.4.3).
OPENING_REACH = 4.0


@dataclass(frozen=True, slots=True)
class TwoWay:
    """The demand on the critical section of a column or pile that pushes in one combination."""

    name: str
    combination: str
    force: float  # that pushes [N]
    d: float  # effective depth [m]
    b_o: float  # length of the critical section that counts [m]
    beta: float  # long side of the column over the short one
    alpha_s: float
    V_u: float  # force that punches, less what relieves it inside [N]
    v_u: float  # with the moments that shear transfers [Pa]
    pressure: float  # contact pressure inside [N]
    edge: float  # line force along the plate's edge inside [N]
    others: float  # other loads inside [N]
    supported: bool  # whether another support acts inside: in V_u is what it adds, not what it takes off
    place: tuple[float, float]  # of the column [m]
    error: Callable[[], float | None] = field(repr=False, compare=False)  # of v_u [Pa]
    transfer: aci318.Transfer | None = field(default=None, repr=False, compare=False)  # of a column or pile
    beta_e: float | None = None  # by what v_u at an end of a wall is larger than its mean
    line: Perimeter | None = field(default=None, repr=False, compare=False)  # of a column or pile
    counted: tuple[WeightedLegs, ...] = field(default=(), repr=False, compare=False)  # what counts of it
    pulls: bool = False  # whether a column pulls up, or a pile down
    parts: MomentParts | None = field(default=None, repr=False, compare=False)  # of the transfer's moments
    inside: float = 0.0  # area inside [m2]
    cases: tuple[CaseInside, ...] = field(default=(), repr=False, compare=False)  # what load cases have there
    widths: tuple[float, float] | None = None  # of a column or pile, along an edge and across [m]
    setbacks: tuple[float, ...] = ()  # of the edges that the section ends at [m]
    wall: WallSite | None = field(default=None, repr=False, compare=False)  # of an end or a corner of walls

    @property
    def sketch(self) -> SketchedPerimeter | None:
        """Return the critical section."""
        if self.wall is not None:
            return self.wall.sketch(self.d / 2)
        if self.line is None or self.transfer is None:
            return None
        place = np.array(self.place)
        return SketchedPerimeter(self.line, self.counted, place, self.transfer.axes, place)


@dataclass(frozen=True, slots=True)
class CriticalSection:
    """The critical section of a column or pile."""

    d: float  # effective depth [m]
    line: Perimeter
    parts: tuple[WeightedLegs, ...]  # of its sides that count, in thinner slab by the depth there
    center: Array  # (2,): of the sides that count [m]
    axes: Array  # (2, 2): unit vectors of the column's own axes
    beta: float
    alpha_s: float
    loads: PerimeterLoads
    widths: tuple[float, float]  # of what is loaded, along an edge and across, else along its own axes [m]
    setbacks: tuple[float, ...]  # of the edges that it ends at [m]

    @property
    def legs(self) -> Array:
        """Return what counts of its sides (l, 2, 2) [m]."""
        return what_counts(self.parts)


@made_once_by(lambda results, model: (results.plate.nodes, model))
def _sections(results: CombinationResult, model: Model) -> Places[CriticalSection | str]:  # noqa: ARG001
    """Return those of the columns and piles of a model, or why there is none, as they are added."""
    return {}


@made_once
def two_way(combined: Results) -> Demands[TwoWay]:
    """Return the demands by combination and column, and why columns have none."""
    return _two_way(combined, perimeter_loads.punching_columns(combined.solved_model))


@made_once
def pile_two_way(combined: Results) -> Demands[TwoWay]:
    """Return the demands by combination and pile, and why piles have none."""
    return _two_way(combined, perimeter_loads.punching_piles(combined.model))


@made_once
def zone_two_way(combined: Results) -> Demands[TwoWay]:
    """Return the demands by combination and thicker zone with columns on it (22.6.4.1(b)), and why zones have none."""
    return _two_way(combined, zone_forces(combined))


def _two_way(combined: Results, forces: tuple[PunchingForce, ...]) -> Demands[TwoWay]:
    """Return the demands of forces that punch the plate by combination and name, and why some have none."""
    model, steel = combined.model, combined.model.reinforcement
    demands: dict[tuple[str, str], TwoWay] = {}
    missing: dict[str, str] = {}
    if steel is None:
        return Demands()
    results = ultimate_results(combined)
    make = partial(critical_section, steel=steel)

    for punching, section, pushing in perimeter_loads.pushing_forces(results, forces, model, (_sections, make)):
        if isinstance(section, str):
            missing[punching.name] = section
            continue
        for result in pushing:
            demand = demand_on(result, section, punching, steel)
            perimeter_loads.add_worse(demands, (result.combination, punching.name), demand, partial(used, steel=steel))
    return Demands(demands, missing)


def critical_section(
    results: CombinationResult, punching: PunchingForce, steel: Reinforcement
) -> CriticalSection | str:
    """Return the critical section at d / 2 from a column's or pile's faces, or why there is none."""
    d = punching.depth(results, steel)
    return section_at(results, punching, d, d / 2)


def section_at(
    results: CombinationResult, punching: PunchingForce, d: float, distance: float, *, square: bool = True
) -> CriticalSection | str:
    """Return the section at a distance from a column's or pile's faces, d deep [m], or why there is none.

    Its corners are square (22.6.4.1), or those of the shortest one around legs of stirrups (22.6.4.2).
    """
    from shapely import get_coordinates

    footprint = punching.footprint
    openings = openings_of(results, punching)
    try:
        around = surroundings(plate_under(results, *punching.place), footprint, distance, openings)
        line = perimeter_at(around, distance, square=square, near=punching.edges_within(d))
    except InputError as error:
        return str(error)
    if line.cut:
        return CUT
    shape = line_properties.shape_of(line.whole)
    column = punching.column
    sides = column.width_x or 1.0, column.width_y or 1.0  # a round column has none, and beta = 1
    reach = perimeter_loads.reach_of(line, distance)
    near = perimeter_loads.loads_near(results, punching, reach)
    loads = near.inside(results, punching.area_inside(line, distance))
    thinner = thinner_parts(results, footprint.footprint(), punching.thickness(results), reach)
    parts = weighted(line.legs, thinner, depth_share, distance, d)
    legs = what_counts(parts)
    center = line_properties.centroid(legs)
    # alpha_s d / b_o with the mean depth, over the whole length
    alpha_s = aci318.ALPHA_S[shape] * (line_properties.total_length(legs) / line.u) ** 2
    course = line_properties.course(line.ring, footprint.axes)
    frame = course.frame if shape == "edge" else footprint.axes
    along, across = np.ptp(get_coordinates(footprint.footprint()) @ frame.T, axis=0)
    ratio, widths = max(sides) / min(sides), (float(along), float(across))
    # square corners end at an edge where legs that run straight out to it do
    setbacks = tuple(edge.setback for edge in around.edges[: EDGES.get(shape, 0)])
    return CriticalSection(d, line, parts, center, footprint.axes, ratio, alpha_s, loads, widths, setbacks)


def openings_of(results: CombinationResult, punching: PunchingForce) -> Openings:
    """Return which openings shorten the sections around a column or pile (22.6.4.3)."""
    return Openings(OPENING_REACH * punching.thickness(results))


def demand_on(
    results: CombinationResult, section: CriticalSection, punching: PunchingForce, steel: Reinforcement
) -> TwoWay:
    """Return the demand on a critical section in a combination."""
    shear = _shear(results, section, punching, steel)
    transfer = _transfer(shear, section)
    return TwoWay(
        punching.name,
        results.combination,
        float(punching.pushing(results)[0]),
        section.d,
        line_properties.total_length(section.legs),
        section.beta,
        section.alpha_s,
        shear.V,
        transfer.v_u,
        shear.pressure,
        shear.edge,
        shear.others,
        shear.supported,
        punching.place,
        lambda: error_of(results, lambda mesh: _transfer(_shear(mesh, section, punching, steel), section).v_u),
        transfer,
        parts=shear.parts.along(transfer.axes),
        inside=section.loads.size,
        cases=shear.cases,
        widths=section.widths,
        setbacks=section.setbacks,
        line=section.line,
        counted=section.parts,
        pulls=punching.pulls,
    )


def _shear(
    results: CombinationResult, section: CriticalSection, punching: PunchingForce, steel: Reinforcement
) -> PunchingShear:
    """Return what punches on a critical section in a combination."""
    return perimeter_loads.punching_shear(
        results, section.loads, punching, section.center, edge_relieves=steel.line_force_relieves
    )


def _transfer(shear: PunchingShear, section: CriticalSection) -> aci318.Transfer:
    """Return what makes v_u on a critical section."""
    return aci318.transfer(shear.V, shear.moments, section.legs, section.d, section.line.whole, section.axes)


def strength(demand: TwoWay, steel: Reinforcement) -> float:
    """Return phi v_c [Pa] of a critical section without shear reinforcement."""
    concrete, _ = materials(steel)
    v_c = aci318.without_links(concrete, demand.d, demand.b_o, demand.beta, demand.alpha_s)
    return PHI_SHEAR * v_c


def used(demand: TwoWay, steel: Reinforcement) -> float:
    """Return v_u over phi v_c."""
    return demand.v_u / strength(demand, steel)
