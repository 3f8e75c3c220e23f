"""How many digits plate and ground leave each other: what rounding does where one is much stiffer than the other.

Numbers have 16 digits. Where a plate moves as a whole, products with its stiffness cancel to what the ground resists;
where a thin plate lifts far, products with the ground's stiffness cancel to what the plate resists.
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Flags
from groundslab.errors import IllConditioned
from groundslab.fem.foundation import Column
from groundslab.fem.problem import Problem, free_motions, single_plates
from groundslab.fem.system import System

#: Stiffness of the plate over that of the ground from which products with rigid motions are made apart.
NEARLY_RIGID = 1e6
#: And from which nothing helps: what the plate's elements resist is then known to a few digits at most.
TOO_RIGID = 5e9
#: Stiffness of the ground over that of the bending plate at which too few digits of the plate's resistance are left.
TOO_THIN = 5e12


def stiffness_ratio(s: System, column: Column) -> float:
    """Return by how much the stiffest element of the plate is stiffer than that of the ground."""
    return plate_stiffness(s) / _ground(s, column)


def plate_stiffness(s: System) -> float:
    """Return the largest stiffness of the plate's elements, of beams, or of the building against settlements [N/m]."""
    deep = s.problem.beams.deep
    return float(max(np.abs(s.blocks.plate[:, :9, :9]).max(), _of_beams(s, deep), _of_beams(s, ~deep), _of_building(s)))


def _of_beams(s: System, mask: Flags) -> float:
    """Return the largest stiffness of some pieces of beams (b,) against settlements [N/m]."""
    return float(np.abs(s.beams[mask][..., 0, 0]).max(initial=0.0))


def _of_building(s: System) -> float:
    """Return the largest stiffness of the building above against settlements of its bases [N/m]."""
    above = s.problem.building
    return 0.0 if above is None else float(np.diag(above.stiffness).max(initial=0.0))


def require_digits(s: System, column: Column) -> None:
    """Raise IllConditioned if plate and ground differ so much in stiffness that no result can be certified."""
    ratio = stiffness_ratio(s, column)
    carried = s.problem.loading.size.any() and free_motions(s.problem).shape[1] > 0
    if ratio > TOO_RIGID and carried:
        deep = s.problem.beams.deep
        kinds = {
            "plate.E": ("the plate", 0.0),
            "beams.E": ("a beam", _of_beams(s, ~deep)),
            "walls.E": ("a wall", _of_beams(s, deep)),
            "building.stiffness": ("the building", _of_building(s)),
        }
        key, (what, _) = max(kinds.items(), key=lambda kind: kind[1][1] * 2 > plate_stiffness(s))
        raise IllConditioned(
            f"{what} is {ratio:.1e} times as stiff as the ground, beyond what numbers of 16 digits can tell (about "
            f"{TOO_RIGID:.0e}); a {key} a thousand times smaller is as rigid"
        )
    if not s.problem.contact.tensionless:
        return
    ground = max(_ground(s, column), np.abs(column.A1).max() * np.abs(s.blocks.slope).max())
    softness = ground * _size(s.problem) ** 2 / s.problem.plate.bending[:, 0, 0].min()
    if softness > TOO_THIN:
        raise IllConditioned(
            f"the plate's thinnest part is {softness:.1e} times softer than the ground, beyond what numbers of 16 "
            f"digits can tell where it lifts off (about {TOO_THIN:.0e}); make it thicker, or glue it to the ground "
            "with contact.tensionless = false"
        )


def _ground(s: System, column: Column) -> float:
    """Return what the ground under the largest element resists when it settles as a whole [N/m]."""
    return float(np.abs(column.A0).max() * s.blocks.mass.sum(axis=(1, 2)).max())


def _size(problem: Problem) -> float:
    """Return the length of the meshed part of the longest plate [m]."""
    return max(float(np.ptp(problem.mesh.nodes[part.plate.nodes], axis=0).max()) for part, _ in single_plates(problem))
