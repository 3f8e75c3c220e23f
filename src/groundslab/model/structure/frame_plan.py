"""The beams of the building above in plan, for drawings."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from groundslab.geometry.plan import Place
from groundslab.model.structure.building import Base, Building


def frame_lines(building: Building | None, bases: Sequence[Base]) -> tuple[tuple[Place, ...], ...]:
    """Return the places [m] that each of the building's beams runs through in plan, from base to base.

    A beam begins on a wall where a frame has it.
    """
    known = {base.name: base for base in bases}
    lines = []
    for beams in building.beams if building else ():
        line: list[Place] = []
        for one, other in pairwise(known[name] for name in beams.through):
            way = np.subtract(other.place, one.place)
            ends = (one.place + one.arm(way), other.place + other.arm(-way))
            line += [(float(x), float(y)) for x, y in ends]
        lines.append(tuple(dict.fromkeys(line)))
    return tuple(lines)
