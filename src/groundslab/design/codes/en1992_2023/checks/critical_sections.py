"""Critical sections of punching by EN 1992-1-1:2023 8.4.2: perimeters b_0.5 and b_0, and what acts inside."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2023 import punching as en1992
from groundslab.design.demands import line_properties, perimeter_loads
from groundslab.design.demands.by_plate import plate_under
from groundslab.design.demands.line_properties import Course, limited_straights, total_length
from groundslab.design.demands.perimeter_loads import LoadsNear, PerimeterLoads, PunchingForce
from groundslab.design.demands.perimeter_pieces import WeightedLegs, what_counts
from groundslab.design.demands.perimeter_shear import MomentLine, PerimeterShear, moment_lines, perimeter_shear
from groundslab.design.demands.perimeters import (
    Openings,
    Perimeter,
    SketchedPerimeter,
    Surroundings,
    outside,
    perimeter_at,
    surroundings,
    way_around,
)
from groundslab.design.demands.zones.thinner_slab import (
    ThinnerPart,
    depth_share,
    shares_at,
    thinner_parts,
    weighted,
)
from groundslab.errors import InputError
from groundslab.model.design.laid_bars import PunchingBars, punching_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult

#: An opening counts up to this distance from the column, in effective depths: the first generation's 6.4.2(3), as that
#: of the second was not read.
OPENING_REACH = 6.0
#: Shear forces along the perimeter are averaged over so many d_v (8.4.2(7), 8.2.1(6)).
AVERAGED = 2.0
#: Contraflexure is looked for so much farther in one direction, as the mean of both counts.
REACH = 3.0
#: Why there is no perimeter.
CUT = "its control perimeter cuts the slab from edge to edge, which is one-way shear"


@dataclass(frozen=True, slots=True)
class CriticalSection:
    """The critical section of a column or pile, the same in every combination."""

    place: Array  # (2,) of the middle of what is loaded [m]
    origin: Array  # (2,) of the column or pile [m]
    d: float  # d_v [m]
    out: float  # d_v,out of the outermost links [m]
    thickness: float  # [m]
    bars: PunchingBars | None  # in tension that count, None if none are laid
    footprint: Array  # (k, 2): places around what is loaded [m]
    line: Perimeter
    legs: Array  # (l, 2, 2): what counts at d_v / 2, wholly in thinner slab too [m]
    parts: tuple[WeightedLegs, ...]  # what counts there, in thinner slab by the depth
    b_05: float  # length that counts there, in thinner slab by the depth [m]
    b_0: float  # that at the face [m]
    center: Array  # (2,) of what counts at d_v / 2 [m]
    course: Course
    relieved: PerimeterLoads  # what acts up to where pressure relieves without links
    inside: PerimeterLoads  # what acts inside the perimeter
    thinner: tuple[ThinnerPart, ...]  # parts of the plate that the perimeter may reach
    chain: Array  # (p, 2): places along the perimeter [m]
    nodes: int  # of the plate that shear forces and moments are read from
    shear: PerimeterShear | None
    lines: tuple[MomentLine, ...]

    @property
    def ratio(self) -> float:
        """Return the ratio of bars in tension that counts."""
        return en1992.MOST_BARS if self.bars is None else min(self.bars.ratio(self.d), en1992.MOST_BARS)

    @property
    def sketch(self) -> SketchedPerimeter:
        """Return what a sketch of it shows."""
        return SketchedPerimeter(self.line, self.parts, self.place, self.axes, self.origin)

    @property
    def axes(self) -> Array:
        """Return the axes (2, 2) of eccentricities: along and across an edge; at a corner across both edges."""
        corner = self.course.shape == "corner" and len(self.course.inward) == 2
        return self.course.inward if corner else self.course.frame

    @property
    def sides(self) -> tuple[float, float]:
        """Return the widths of what is loaded along its axes [m]."""
        along, across = np.ptp(self.footprint @ self.axes.T, axis=0)
        return float(along), float(across)

    @property
    def widths(self) -> tuple[float, float]:
        """Return the overall widths of the perimeter along its axes [m], not reduced by long sides or openings."""
        along, across = np.ptp(self.line.ring.reshape(-1, 2) @ self.axes.T, axis=0)
        return float(along), float(across)

    def shear_on(self, plate: PlateResult) -> PerimeterShear | None:
        """Return how shear forces across the perimeter are read from a plate, on another mesh, too."""
        if len(plate.nodes) == self.nodes:
            return self.shear
        return _shear(plate, self.chain, self.line_center, self.thinner, self.d)

    def lines_on(self, plate: PlateResult) -> tuple[MomentLine, ...]:
        """Return how moments along both axes of bars are read from a plate, on another mesh, too."""
        if len(plate.nodes) == self.nodes:
            return self.lines
        return moment_lines(plate, self.place, en1992.FAR_CONTRAFLEXURE * self.d * REACH)

    @property
    def line_center(self) -> Array:
        """Return a place (2,) inside the perimeter [m]."""
        return np.array(self.line.loaded.centroid.coords[0])

    @property
    def k_pb(self) -> float:
        """Return the gradient enhancement (formula 8.96)."""
        return en1992.gradient(self.b_0, total_length(self.legs))


def critical_section(
    results: CombinationResult, punching: PunchingForce, steel: Reinforcement
) -> CriticalSection | str:
    """Return the critical section at d_v / 2 from a column's or pile's faces, or why there is none."""
    from shapely import get_coordinates

    plate, footprint, model = plate_under(results, *punching.place), punching.footprint, results.model
    d = punching.depth(results, steel)
    try:
        around = surroundings(plate, footprint, d, Openings(OPENING_REACH * d, widened=True))
        line = perimeter_at(around, en1992.DISTANCE * d, near=punching.edges_within(d))
    except InputError as error:
        return str(error)
    if line.cut:
        return CUT
    legs = _counted(line.whole, around, d)
    face = _counted(way_around(around, line.loaded), around, d)
    if not total_length(legs) > around.rounding:
        return "nothing of its control perimeter is left between openings"
    reach = perimeter_loads.reach_of(line, d)
    thinner = thinner_parts(results, around.footprint, punching.thickness(results), reach)
    parts = weighted(legs, thinner, depth_share, en1992.DISTANCE * d, d)
    counted = what_counts(parts)
    bars = None
    if steel.laid:
        side: Literal["bottom", "top"] = "top" if punching.from_below else "bottom"
        bars = punching_bars(model.plate, steel, punching.column, d, model.plates, side)
    near = perimeter_loads.loads_near(results, punching, reach)
    course, center = line_properties.course(line.ring, around.axes), line_properties.centroid(counted)
    chain = max(line_properties.chains(line.whole), key=len)
    compressed = steel.bottom_axes if punching.from_below else steel.top_axes
    return CriticalSection(
        place=around.center,
        origin=np.array(punching.place),
        d=d,
        out=d - sum(compressed) / 2,
        thickness=punching.thickness(results),
        bars=bars,
        footprint=get_coordinates(around.footprint),
        line=line,
        legs=legs,
        parts=parts,
        b_05=total_length(counted),
        b_0=total_length(face),
        center=center,
        course=course,
        relieved=_relieved(results, around, near, line, (d, punching)),
        inside=near.inside(results, punching.area_inside(line, en1992.DISTANCE * d)),
        thinner=thinner,
        chain=chain,
        nodes=len(plate.nodes),
        shear=_shear(plate, chain, around.center, thinner, d),
        lines=moment_lines(plate, around.center, en1992.FAR_CONTRAFLEXURE * d * REACH),
    )


def _shear(
    plate: PlateResult, chain: Array, center: Array, thinner: tuple[ThinnerPart, ...], d: float
) -> PerimeterShear | None:
    """Return how shear forces along a chain are read, in thinner slab as large as they are over its depth times d."""

    def factors(places: Array) -> Array:
        return 1 / shares_at(places, en1992.DISTANCE * d, thinner, depth_share, d)

    return perimeter_shear(plate, chain, center, AVERAGED * d, factors if thinner else None)


def _counted(legs: Array, around: Surroundings, d: float) -> Array:
    """Return what counts of the legs (l, 2, 2) of a perimeter: of straight parts 3 d_v, and nothing behind openings."""
    return outside(limited_straights(legs, en1992.STRAIGHT * d), around.shadow)


def _relieved(
    results: CombinationResult, around: Surroundings, near: LoadsNear, line: Perimeter, of: tuple[float, PunchingForce]
) -> PerimeterLoads:
    """Return what acts up to 0.67 d_v from the face, or inside the control perimeter if there is no such line."""
    d, punching = of
    closer = punching.area_inside(line, en1992.DISTANCE * d)
    try:
        farther = perimeter_at(around, en1992.RELIEVED * d, near=punching.edges_within(d))
    except InputError:
        return near.inside(results, closer)
    # one that begins to run out to an edge, or cuts the slab, has another shape
    same = farther.setbacks == line.setbacks and not farther.cut
    return near.inside(results, punching.area_inside(farther, en1992.RELIEVED * d) if same else closer)
