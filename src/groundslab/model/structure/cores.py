"""Cores of a building: walls that bend together, each cross-section of all of them staying plane.

A core's section is thin-walled: the axes of its walls with their thicknesses, without their openings. Over it a force P
and moments M about its center make the stress

    sigma = P / A + (r - r_0) I^-1 M,    A = sum of t L,    A r_0 = integral of t r ds,
    I = integral of t (r - r_0) (r - r_0)' ds,    M = integral of t sigma (r - r_0) ds,

so that products of inertia count, and axes of the core need not be those of the plan. Its walls press on the slab by
sigma t, which is linear along each straight piece and pulls where it is negative. Warping of the section, and the
moments of walls about their own axes, are left out, as usual for thin walls.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import Place, Segment
from groundslab.model.plates.other_plates import AnyPlate
from groundslab.model.structure.lines import NO_LENGTH, line_segments, part_of_line
from groundslab.model.structure.walls import Wall, place_walls
from groundslab.model.supports import check_names
from groundslab.schema.base import Section
from groundslab.schema.fields import ListOf, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.repairs import use_nearest
from groundslab.schema.wording import describe, one_of, quote, suggestion

#: Of principal moments of inertia that are less than this part of the larger one nothing is carried.
IN_A_LINE = 1e-9
#: Moments whose part across walls in about one line is no larger than this part of them are along these walls.
ALONG = 1e-2
#: Walls that share less than this part of their thickness meet at a place.
MEETING = 1e-3


class Core(Section):
    """A core of the building: walls that bend together, as a cross-section that stays plane."""

    name: Annotated[str, Text("name of the core, used by loads")]
    walls: Annotated[
        tuple[str, ...],
        ListOf(Text(""), "", "walls that it consists of, straight ones or polygons; openings are cut out of them"),
    ]


@dataclass(frozen=True, slots=True)
class CorePart:
    """A straight piece of a core's walls."""

    wall: str
    edge: Segment
    start: float  # how far along the wall it begins [m]
    thickness: float  # [m]


@dataclass(frozen=True, slots=True)
class CoreSection:
    """The thin-walled section of a core."""

    parts: tuple[CorePart, ...]
    area: float  # [m2]
    center: Place  # [m]
    inertia: tuple[tuple[float, float], tuple[float, float]]  # I_xx, I_xy, I_xy, I_yy [m4]: of t x x ds, t x y ds

    def growth(self, M: Sequence[float]) -> Array:
        """Return how the stress by moments about the center (2,) [N m] grows along x and y (2,) [Pa/m].

        Across walls in one line it does not grow.
        """
        moments, directions = self._principal
        carried = moments > IN_A_LINE * moments.max()
        growth: Array = directions[:, carried] @ ((directions[:, carried].T @ np.asarray(M)) / moments[carried])
        return growth

    def not_carried(self, M: Sequence[float]) -> Array:
        """Return what walls do not carry of moments (2,) [N m]: those in one line carry none across it.

        They stand in one line if their axes are off it by less than walls are thick. Where they are, a moment along
        the line has a small part across their principal axes.
        """
        moments, directions = self._principal
        across = directions.T @ np.asarray(M)
        least = self.area * max(part.thickness for part in self.parts) ** 2 / 12
        allowed = np.where(moments > IN_A_LINE * moments.max(), ALONG, IN_A_LINE) * math.hypot(*M)
        left: Array = directions @ np.where((moments > least) | (np.abs(across) <= allowed), 0.0, across)
        return left

    @property
    def _principal(self) -> tuple[Array, Array]:
        """Return the principal moments of inertia (2,) [m4] and their directions, the columns of (2, 2)."""
        moments, directions = np.linalg.eigh(np.array(self.inertia))
        return moments, directions

    def line_forces(self, P: float, M: Sequence[float]) -> Iterator[tuple[CorePart, tuple[float, float]]]:
        """Yield each part, and how much per length a force [N] and moments (2,) [N m] press at both of its ends."""
        growth = self.growth(M)
        for part in self.parts:
            off = np.array([part.edge.start, part.edge.end]) - self.center
            start, end = part.thickness * (P / self.area + off @ growth)
            yield part, (float(start), float(end))


@lru_cache(maxsize=256)
def section_of(core: Core, walls: tuple[Wall, ...], plates: tuple[AnyPlate, ...]) -> CoreSection:
    """Return the section of a core whose walls are among some, on plates."""
    named = place_walls([wall for wall in walls if wall.name in core.walls], plates)
    parts = tuple(part for wall in named for part in _parts(wall))
    t = np.array([part.thickness * part.edge.length for part in parts])
    a, b = (np.array([getattr(part.edge, end) for part in parts]) for end in ("start", "end"))
    center = t @ (a + b) / 2 / t.sum()
    middle, way = (a + b) / 2 - center, b - a
    of_parts, of_middles = (np.einsum("e,ei,ej->ij", area, arm, arm) for area, arm in ((t / 12, way), (t, middle)))
    (xx, xy), (_, yy) = (of_parts + of_middles).tolist()
    return CoreSection(parts, float(t.sum()), (float(center[0]), float(center[1])), ((xx, xy), (xy, yy)))


def _parts(wall: Wall) -> Iterator[CorePart]:
    """Yield the straight pieces of a wall that has its axis, without its openings."""
    low = 0.0
    length = wall.length
    openings = sorted((opening.start, opening.end) for opening in wall.openings)
    for start, end in (*openings, (length, length)):
        if min(start, length) - low > NO_LENGTH:
            way = low
            for edge in line_segments(*part_of_line(wall.edges, low, min(start, length)), None):
                yield CorePart(wall.name, edge, way, wall.thickness)
                way += edge.length
        low = max(low, end)


def check_cores(
    cores: tuple[Core, ...], walls: tuple[Wall, ...], plates: tuple[AnyPlate, ...]
) -> Iterator[RelativeIssue]:
    """Find cores of unknown walls, of walls that bend in arcs or lie on each other, or that are in another core."""
    yield from check_names("cores", [core.name for core in cores], needed=True)
    placed = {wall.name: wall for wall in place_walls(walls, plates)}
    owners = dict[str, str]()
    for number, core in enumerate(cores):
        for position, name in enumerate(core.walls):
            place = ("cores", number, "walls", position)
            if name not in placed:
                names = list(placed)
                expected = one_of(names) if names else "a wall, and [[walls]] that says where it is"
                yield RelativeIssue(place, describe(name), expected, suggestion(name, names),
                                    use_nearest(place, name, names))  # fmt: skip
            elif name in owners:
                owned_wall = f"wall {quote(name)}, which is in core {quote(owners[name])}"
                yield RelativeIssue(place, owned_wall, "a wall that is once in one core", "make one core of both")
            elif placed[name].curved:
                hint = "draw its arcs by straight pieces"
                yield RelativeIssue(place, f"wall {quote(name)}, which has arcs", "a wall of straight pieces", hint)
            elif not any(_parts(placed[name])):
                yield RelativeIssue(place, f"wall {quote(name)}, which is open all along", "a wall that stands there")
            else:
                owners[name] = core.name
    yield from _check_apart(cores, placed, owners)


def _check_apart(
    cores: tuple[Core, ...], placed: Mapping[str, Wall], owners: Mapping[str, str]
) -> Iterator[RelativeIssue]:
    """Find walls of cores that lie on each other, whose area would count twice."""
    axes = {name: placed[name].to_shapely(NO_LENGTH) for name in owners}
    for first, other in itertools.combinations(axes, 2):
        t = min(placed[first].thickness, placed[other].thickness)
        shared = axes[other].intersection(axes[first].buffer(MEETING * t, cap_style="flat")).length
        if shared > t:
            number = next(number for number, core in enumerate(cores) if core.name == owners[other])
            place = ("cores", number, "walls", cores[number].walls.index(other))
            overlap = f"wall {quote(other)}, of which {shared:.3g} m lie on wall {quote(first)}"
            yield RelativeIssue(place, overlap, "one wall at each place", "its area would count twice")
