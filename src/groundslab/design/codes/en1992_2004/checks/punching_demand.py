"""Demands of punching by EN 1992-1-1 6.4: perimeters, the stress on each, and which of them governs."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004.annex import Annex
from groundslab.design.codes.en1992_2004.punching import outer_perimeter
from groundslab.design.demands.line_properties import Course
from groundslab.design.demands.perimeter_loads import CaseInside, MomentParts, PerimeterLoads
from groundslab.design.demands.perimeter_shear import PerimeterShear
from groundslab.design.demands.perimeters import SketchedPerimeter
from groundslab.design.rules.wall_ends import WallSite
from groundslab.messages import Message
from groundslab.model.design.laid_bars import PunchingBars

#: How far from the face perimeters reach, over the effective depth.
REACH = 2.0
#: What symbols of the outermost perimeter end with where it is not the one that governs.
OUTERMOST = ",R"
#: Distances closer than this are one, over the effective depth.
SAME_DISTANCE = 1e-2
#: Perimeters that do not grow with their distance are taken to do so by this, so that none is infinitely far.
LEAST_GROWTH = 1e-3
#: How far inside the outer perimeter the outermost links are at most, over the effective depth (6.4.5(4)).
LAST_LINKS = 1.5
#: No links are farther from the face than this over the effective depth.
FARTHEST = 10.0
TOO_FAR = Message(
    "links would go on beyond {farthest:g} d from the face, as perimeters hardly grow outwards", farthest=FARTHEST
)
#: Lengths that differ by a smaller share are the same.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class ControlPerimeter:
    """A perimeter around a column or pile, and what is the same about it in every combination."""

    distance: float  # from the face [m]
    u: float  # its length that counts [m]
    center: Array  # (2,): of what counts [m]
    course: Course
    moduli: Array  # (2,): W of places along the course's frame, about the center [m2]
    shares: Array  # (2,): k of Table 6.1 for moments of forces along both
    reduced: float  # u_1* / u_1 of a perimeter at an edge, else 1
    opened: bool  # whether openings take off a part of it
    loads: PerimeterLoads
    sketch: SketchedPerimeter = field(repr=False, compare=False)
    legs: Array = field(repr=False, compare=False)  # (l, 2, 2): what counts of it [m]
    depth: float  # effective [m]
    widths: tuple[float, float]  # of the column or pile along the course's frame [m]
    sides: tuple[float, ...]  # of it across the edges that a perimeter at a corner runs out to [m]
    sectors: list[tuple[PerimeterShear, ...]] = field(default_factory=list, repr=False, compare=False)

    @property
    def thinned(self) -> bool:
        """Return whether a part of it counts less, as it is in thinner slab."""
        return self.u < (1 - ROUNDING) * self.sketch.line.u


@dataclass(frozen=True, slots=True)
class Stress:
    """The demand on a perimeter."""

    distance: float  # from the face [m]
    u: float  # its length that counts [m]
    V_Ed: float  # force that punches, less what relieves it inside [N]
    beta: float | None  # by the moments about the perimeter's center (expression 6.51); None where nothing pushes
    v_Ed: float  # beta V_Ed / (u d) [Pa]
    supported: bool  # whether another support acts inside: in V_Ed is what it adds, not what it takes off
    pressure: float  # contact pressure inside [N]
    edge: float  # line force along the plate's edge inside [N]
    others: float  # other loads inside [N]
    error: Callable[[], float | None] = field(repr=False, compare=False)  # of v_Ed [Pa]
    control: ControlPerimeter | None = None  # of a column or pile
    moments: tuple[float, float] = (0.0, 0.0)  # of forces along the perimeter's frame about its center [N m]
    parts: MomentParts | None = field(default=None, repr=False, compare=False)  # of these moments
    outer: ControlPerimeter | None = field(default=None, repr=False, compare=False)  # that beta at the face is of
    way: str = "code"  # how beta is found
    outward: float | None = None  # a moment of the column that bends it outwards and decides beta by moments [N m]
    both: bool = False  # whether at an edge or corner beta is the larger one of 6.39 and the simpler value
    other_betas: Callable[[], Mapping[str, float]] = field(
        default=dict, repr=False, compare=False
    )  # beta by other ways
    cases: tuple[CaseInside, ...] = field(default=(), repr=False, compare=False)  # what load cases have inside


@dataclass(frozen=True, slots=True)
class Demand:
    """What punches at a column, a pile or the end of a wall that pushes in one combination."""

    name: str
    combination: str
    limit_state: str
    force: float  # that pushes [N]
    d: float  # effective depth [m]
    v_Rd_c: float  # at 2 d, with the bars provided or the most that count [Pa]
    face: Stress | None
    around: tuple[Stress, ...]  # from the face outwards; none where there is no such perimeter on the plate
    ratio: float = 0.0  # of the bars that count
    bars: PunchingBars | None = None  # that are laid
    pulls: bool = False  # whether a column pulls up, or a pile down
    place: tuple[float, float] = (0.0, 0.0)  # [m]
    wall: WallSite | None = field(default=None, repr=False, compare=False)  # of an end or a corner of walls
    thickness: float = 0.0  # of the slab there [m]
    changed: Callable[[float, float], Demand | None] = field(
        default=lambda *_: None, repr=False, compare=False
    )  # the same where the slab is thicker, and a column or pile wider, by so much [m]; None where that is not known

    @property
    def sketch(self) -> SketchedPerimeter | None:
        """Return the governing perimeter of a column or pile, and the outermost one, of which beta at the face is."""
        if self.wall is not None and self.governing is not None:
            return self.wall.sketch(self.governing.distance)
        control = None if self.governing is None else self.governing.control
        if control is None:
            return None
        outermost = None if self.face is None else self.face.outer
        if outermost is None or outermost is control:
            return control.sketch
        return control.sketch._replace(further=((OUTERMOST, outermost.sketch),))

    @property
    def at_2d(self) -> Stress | None:
        """Return the demand at 2 d, None where that perimeter cuts the slab from edge to edge or leaves the plate."""
        reaches = self.around and self.around[-1].distance > (REACH - SAME_DISTANCE) * self.d
        return self.around[-1] if reaches else None

    @property
    def governing(self) -> Stress | None:
        """Return the demand where v_Ed / v_Rd is largest, None where there is no perimeter."""
        return max(self.around, key=self.used, default=None)

    def resistance(self, stress: Stress) -> float:
        """Return v_Rd [Pa] on a perimeter around (6.4.4(2))."""
        return self.v_Rd_c * REACH * self.d / stress.distance

    def used(self, stress: Stress) -> float:
        """Return v_Ed / v_Rd on a perimeter around."""
        return stress.v_Ed / self.resistance(stress)


class Outer(NamedTuple):
    """The perimeter beyond which links are needed no more (6.4.5(4))."""

    u: float  # its length [m]
    distance: float  # from the face [m]
    last: Stress | None = None  # the outermost perimeter that is followed where u is by 6.54, beyond it
    inner: Stress | None = None  # the one before it, if there is one
    grows: float = 0.0  # by how much perimeters are longer there, over their distance

    def last_links(self, d: float) -> float:
        """Return how far from the face the outermost links are at least, for an effective depth d [m]."""
        return self.distance - LAST_LINKS * d

    def is_too_far(self, d: float) -> bool:
        """Return whether links cannot end anywhere, as perimeters hardly grow outwards, as on strips."""
        return self.last_links(d) > FARTHEST * d


def limited_outermost(annex: Annex, *, at_face: bool) -> bool:
    """Return whether links are limited by k_max v_Rd,c on the outermost perimeter alone (6.4.5(1)).

    They are where the face has a limit of its own, by the annex, and not at ends of walls.
    """
    return bool(annex.face) and at_face


def outer(demand: Demand) -> Outer:
    """Return the perimeter beyond which a demand needs no links; somewhere it must need some.

    Beyond the outermost one that is followed it is by 6.54, its length growing as it does between the two last ones.
    """
    around = demand.around
    needing = max(number for number, stress in enumerate(around) if demand.used(stress) > 1)
    if needing + 1 < len(around):
        return Outer(around[needing + 1].u, around[needing + 1].distance)
    last, inner = around[-1], around[-2] if len(around) > 1 else None
    u = outer_perimeter(last.v_Ed, demand.v_Rd_c, last.u)
    grows = (last.u - inner.u) / (last.distance - inner.distance) if inner is not None else 2 * math.pi
    grows = max(grows, LEAST_GROWTH)
    return Outer(u, last.distance + max(u - last.u, 0.0) / grows, last, inner, grows)
