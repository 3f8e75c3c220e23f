"""The frame of a model's building: its columns and beams as members, storey by storey, condensed to its bases."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.parts.frame import Members, condense
from groundslab.geometry.rectangles import direction_at
from groundslab.model.structure.building import Base, Building, BuildingBeams
from groundslab.model.structure.frame_members import CircularMember, MemberProperties, RectangularMember


@dataclass(frozen=True, slots=True)
class _Member:
    """A member between two nodes."""

    nodes: tuple[int, int]
    across: Array  # (3,): direction of the width of its section
    properties: MemberProperties
    arms: Array  # (2, 3) [m]: rigid, from its nodes to its ends


@dataclass(frozen=True, slots=True)
class _Nodes:
    """The nodes of a frame: its bases, then those of each of its columns from the lowest storey upwards."""

    top: Integers  # (b,): the highest storey in which beams join each base's column

    def at(self, base: int, storey: int) -> int:
        """Return the node on top of a storey above a base; of storey 0 the base itself."""
        return base if storey == 0 else len(self.top) + int(self.top[:base].sum()) + storey - 1

    def on_floor(self, storey: int) -> Integers:
        """Return the nodes on top of a storey."""
        return np.array([self.at(base, storey) for base in np.flatnonzero(self.top >= storey).tolist()])

    def places(self, bases: tuple[Base, ...], heights: Array) -> Array:
        """Return where they are (n, 3) [m], z downwards; heights (s + 1,) are those of floors above the bases [m]."""
        places = np.zeros((len(self.top) + int(self.top.sum()), 3))
        for i, base in enumerate(bases):
            for storey in range(int(self.top[i]) + 1):
                places[self.at(i, storey)] = [*base.place, -heights[storey]]
        return places


@lru_cache(maxsize=32)
def condensed(building: Building, bases: tuple[Base, ...], storeys: int) -> Array:
    """Return the stiffness (3 b, 3 b) of the lowest storeys of a frame between its bases, in N and m."""
    assert building.E is not None
    number = {base.name: k for k, base in enumerate(bases)}
    beams = [(storey, beam) for storey in range(1, storeys + 1) for beam in building.beams if _lies_on(beam, storey)]
    top = np.zeros(len(bases), dtype=np.int64)
    for storey, beam in beams:
        for name in beam.through:
            top[number[name]] = max(top[number[name]], storey)
    nodes = _Nodes(top)
    every = list(_columns(building, bases, nodes))
    for storey, beam in beams:
        every += _beams(beam, bases, [number[name] for name in beam.through], nodes, storey)
    places = nodes.places(bases, np.concatenate([[0.0], np.cumsum(building.storeys)]))
    floors = [nodes.on_floor(storey) for storey in range(1, storeys + 1)] if building.rigid_floors else []
    members = _as_members(every, building.E, building.E / (2 * (1 + building.nu)))
    return condense(places, members, np.arange(len(bases)), [floor for floor in floors if len(floor) > 1])


def _lies_on(beam: BuildingBeams, storey: int) -> bool:
    """Return whether a beam lies on top of a storey."""
    return beam.storeys is None or storey in beam.storeys


def _columns(building: Building, bases: tuple[Base, ...], nodes: _Nodes) -> Iterator[_Member]:
    """Yield the columns of a frame and its walls, storey by storey up to where beams join them."""
    for i, base in enumerate(bases):
        for storey in range(1, int(nodes.top[i]) + 1):
            across, properties = _section_of(building, base, storey)
            yield _Member((nodes.at(i, storey - 1), nodes.at(i, storey)), across, properties, np.zeros((2, 3)))


def _beams(
    beam: BuildingBeams, bases: tuple[Base, ...], through: list[int], nodes: _Nodes, storey: int
) -> Iterator[_Member]:
    """Yield the parts of a beam on top of a storey, through bases of some numbers."""
    for start, end in pairwise(through):
        way = np.subtract(bases[end].place, bases[start].place)
        arms = np.zeros((2, 3))
        arms[:, :2] = bases[start].arm(way), bases[end].arm(-way)
        free = way + arms[1, :2] - arms[0, :2]
        across = np.array([-free[1], free[0], 0.0]) / np.linalg.norm(free)
        yield _Member((nodes.at(start, storey), nodes.at(end, storey)), across, beam.section.properties, arms)


def _section_of(building: Building, base: Base, storey: int) -> tuple[Array, MemberProperties]:
    """Return the direction of the width, and the properties, of what stands on a base in a storey."""
    if base.wall is not None:
        edge = base.wall.edges[0]
        along = np.subtract(edge.end, edge.start) / edge.length
        wall = RectangularMember(width=edge.length, height=base.wall.thickness)
        return np.array([*along, 0.0]), wall.properties
    column = base.column
    assert column is not None
    x = np.array([*direction_at(column.angle), 0.0])
    for group in building.columns:
        if base.name in group.names and (group.storeys is None or storey in group.storeys):
            return x, group.section.properties
    if column.diameter is not None:
        return x, CircularMember(diameter=column.diameter).properties
    assert column.width_x is not None
    assert column.width_y is not None
    return x, RectangularMember(width=column.width_x, height=column.width_y).properties


def _as_members(every: list[_Member], E: float, G: float) -> Members:
    """Return members as arrays, for E and G [Pa]."""
    properties = [member.properties for member in every]
    return Members(
        nodes=np.array([member.nodes for member in every], dtype=np.int64).reshape(-1, 2),
        arms=np.array([member.arms for member in every]).reshape(-1, 2, 3),
        across=np.array([member.across for member in every]).reshape(-1, 3),
        EA=E * np.array([section.A for section in properties]),
        EI=E * np.array([section.I for section in properties]).reshape(-1, 2),
        GJ=G * np.array([section.J for section in properties]),
        GA=G * np.array([section.A_v for section in properties]),
    )
