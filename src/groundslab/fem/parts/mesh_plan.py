"""What the mesher decided on a model, for whoever reads fields on the mesh."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class MeshPlan:
    """What the mesher decided on a model.

    Attributes
    ----------
    symmetry : tuple of bool
        Whether symmetry along x, and along y, is used: then only the part beyond x = 0, or y = 0, is meshed.
    followed_zones, followed_voids : tuple of int
        Numbers, from 0, of the soil zones and voids whose whole borders, as drawn, a mesh that is no grid follows.
    has_coarser : bool
        Whether a mesh of elements twice as large has clearly fewer of them, so that it shows discretization errors.
    """

    symmetry: tuple[bool, bool]
    followed_zones: tuple[int, ...]
    followed_voids: tuple[int, ...]
    has_coarser: bool
