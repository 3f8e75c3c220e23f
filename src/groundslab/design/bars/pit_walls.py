"""What the walls of pits need where the slab steps down: upright bars for what floor and slab hand over, by the code.

The slab is analyzed as if its parts were at one level, with no force in its plane. So each wall hands the moment m_n of
the floor to the slab around, the same over its height, with the twist m_nt beside it and the force q_n along it, above
zero where the floor hangs on the wall. Its upright bars are for

    m_Ed = |m_n| + |m_nt| + max(q_n, 0) d / 2

at either face: the twist adds to the moment as it does in a slab (Wood 1968), and a pull n is half a pull at each face,
n / 2 <= (n d / 2) / z, as z <= d. What presses the wall upright is left out, and so is pressure from the side.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.by_plate import nodes_at
from groundslab.design.demands.cuts.section_cuts import rotate_to_cut
from groundslab.design.rules.bending_steps import BarsNeeded
from groundslab.design.rules.combinations import ultimate_results
from groundslab.geometry.offsets import counterclockwise
from groundslab.geometry.plan import Segment
from groundslab.messages import Message, Name
from groundslab.model.design.laid_bars import axis_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.plates.pits import Pit, chord_of, pits_of
from groundslab.results.fields import LAYERS
from groundslab.results.results import CombinationResult, Results


@dataclass(frozen=True, slots=True)
class PitWallNeed:
    """What the walls of a pit need where it is most, over all ultimate combinations."""

    name: str  # of the pit's zone
    wall: float  # thickness [m]
    axis: float  # distance of the upright bars' axes from either face [m]
    moment: float  # m_n, positive with tension at the bottom of the slab [N m/m]
    twist: float  # m_nt [N m/m]
    pull: float  # q_n with which the floor hangs on the wall, else below 0 [N/m]
    area: float  # upright bars at either face [m2/m]; inf where the concrete is too weak
    minimum: float  # the least ones [m2/m]
    place: tuple[float, float]  # [m]
    combination: str
    limit_state: str

    @property
    def d(self) -> float:
        """Return the effective depth [m], not above 0 where the wall is too thin for its bars."""
        return self.wall - self.axis

    @property
    def bars(self) -> BarsNeeded:
        """Return the upright bars as those of a slab as thick."""
        return BarsNeeded(self.design_moment, self.wall, self.axis, self.area, self.minimum)

    @property
    def design_moment(self) -> float:
        """Return m_Ed [N m/m]."""
        return abs(self.moment) + abs(self.twist) + max(self.pull, 0.0) * self.d / 2


def pit_names(combined: Results) -> tuple[tuple[str, Pit, float], ...]:
    """Return all pits with what checks call them, and how far chords may lie off arcs [m]."""
    return tuple(
        (_name(pit.number, plate.name if combined.model.plates else ""), pit, chord_of(plate))
        for plate in combined.model.every_plate
        for pit in pits_of(plate)
    )


def _name(number: int, plate: str) -> str:
    zone = Message("zone {number}", number=number)
    return Message("{zone} of {plate}", zone=zone, plate=Name(plate)) if plate else zone


def pit_wall_needs(combined: Results, steel: Reinforcement) -> list[PitWallNeed]:
    """Return what the walls of each pit need, none without ultimate combinations.

    Bars lie as far from the faces of walls as those of the slab that lie farthest.
    """
    results, needs = ultimate_results(combined), list[PitWallNeed]()
    for pit in pit_names(combined) if results else ():
        of_pit = [need for result in results for need in _needs(result, steel, pit)]
        needs += [max(of_pit, key=lambda need: (need.area, need.design_moment))] if of_pit else []
    return needs


def _needs(result: CombinationResult, steel: Reinforcement, of: tuple[str, Pit, float]) -> Iterator[PitWallNeed]:
    """Yield what a pit's walls need in a combination along each edge of its border, where it is most."""
    name, pit, chord = of
    axis = max(axis_of(steel, layer) for layer in LAYERS)
    d = pit.wall - axis
    for edge in counterclockwise(pit.ring):
        nodes, m_n, m_nt, q_n = _along(result, edge, pit, chord)
        if not len(nodes):
            continue
        m_Ed = np.abs(m_n) + np.abs(m_nt) + np.maximum(q_n, 0.0) * max(d, 0.0) / 2
        most = int(np.argmax(m_Ed))
        x, y = result.plate.nodes[nodes[most]].tolist()
        area = minimum = np.inf
        if d > 0:
            rule = code_of(steel).bending(steel, result.limit_state)
            needed = rule.required(m_Ed[[most]], d, thickness=pit.wall)
            area, minimum = float(needed.area[0]), float(needed.minimum[0])
        yield PitWallNeed(
            name, pit.wall, axis, float(m_n[most]), float(m_nt[most]), float(q_n[most]), area, minimum, (x, y),
            result.combination, result.limit_state,
        )  # fmt: skip


def _along(result: CombinationResult, edge: Segment, pit: Pit, chord: float) -> tuple[Integers, Array, Array, Array]:
    """Return the nodes of both sides along an edge of a border, the pit to its left: m_n, m_nt and q_n there.

    n points into the pit. The shear force counts on the floor's side alone, where what stands on the wall adds nothing.
    """
    plate, near = result.plate, 2 * chord
    nodes = np.flatnonzero(edge.distance(plate.nodes) <= near)
    inward = edge.left(np.array([edge.part((float(x), float(y))) for x, y in plate.nodes[nodes]]))
    fields = ("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
    along = np.column_stack([-inward[:, 1], inward[:, 0]])  # n is to its right
    m_x, m_y, m_xy, q_x, q_y = (getattr(plate, field)[nodes] for field in fields)
    m_n, _, m_nt, q_n = rotate_to_cut(m_x, m_y, m_xy, q_x, q_y, along)
    floor = nodes_at(result, pit.area(chord))[nodes]
    return nodes, m_n, m_nt, np.where(floor, q_n, 0.0)
