"""What of walls with a height is judged: struts that bear their shear forces, and their least bars, by the case's code.

Walls are deep beams of the concrete and steel of the case. Ties, forces along and across them, their ends, openings and
joints are not designed here.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.demand_errors import error_along
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.structure.beams import RectangularSection
from groundslab.results.results import CombinationResult, Results


@dataclass(frozen=True, slots=True)
class WallNeed:
    """A part of a wall with the shear force that uses most of its struts, of all ultimate combinations."""

    wall: str
    force: float  # shear force [N]
    borne: float  # the largest that struts bear [N]
    upright: float | None  # least bars, both faces together [m2/m]; None where they are not known
    level: float | None
    way: float  # where, from the part's start [m]
    place: tuple[float, float]  # [m]
    combination: str
    member: int  # the number of the part among all members
    away: float  # so far from its ends shear forces count [m]
    thickness: float  # [m]
    height: float  # that counts [m]

    @property
    def used(self) -> float:
        """Return the share used of what struts bear."""
        return abs(self.force) / self.borne


def error_of_force(combined: Results, need: WallNeed) -> float | None:
    """Return the estimated error of the shear force of a part of a wall [N]; None without a coarser mesh."""

    def course(mesh: CombinationResult) -> tuple[Array, Array]:
        part = mesh.beams[need.member].between_ends(need.away)
        return part.way, np.abs(part.shear)

    return error_along(combined.results[need.combination], course, 0.0)


def wall_needs(combined: Results, steel: Reinforcement) -> list[WallNeed]:
    """Return what each part of a wall with a height needs; none where the code has no rule for walls.

    Shear forces count from one thickness of the plate from its ends on, where forces pass into the plate. Of a wall
    that is higher than it is long, as much of the height counts.
    """
    rule, model = code_of(steel).walls, combined.model
    if rule is None:
        return []
    away = max(plate.thickness for plate in model.every_plate)
    lengths = [wall.length for wall in model.placed_walls if wall.height is not None]
    governing = []
    for number, (member, wall) in enumerate(zip(model.members, model.wall_of_members, strict=True)):
        section = member.section
        if wall < 0 or not isinstance(section, RectangularSection):
            continue
        needs = []
        for results in ultimate_results(combined):
            part = results.beams[number].between_ends(away)
            most = int(np.argmax(np.abs(part.shear)))
            t, height = section.width, min(section.height, lengths[wall])
            borne = rule.most(steel, results.limit_state, t, height)
            place = float(part.nodes[most, 0]), float(part.nodes[most, 1])
            upright, level = (None, None) if rule.least is None else rule.least(t)
            needs.append(WallNeed(member.name, float(part.shear[most]), borne, upright, level, float(part.way[most]),
                                  place, results.combination, number, away, t, height))  # fmt: skip
        governing += [max(needs, key=lambda need: need.used)] if needs else []
    return governing
