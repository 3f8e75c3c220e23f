"""The cells through which a plate presses on an elastic continuum, and what follows from them in its depth."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.errors import InputError, Issue
from groundslab.fem.continuum.depth import LoadedCells, base_of, settle_below
from groundslab.fem.continuum.transfer import ElasticLayer

if TYPE_CHECKING:
    from groundslab.solvers.solution import Solution

#: At most so many depths are computed at a time.
DEPTHS = 64
#: A depth is that of the base but for this share.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class PressedCells:
    """The c cells of a grid on which the pressure of a plate is constant, and the elastic layers below.

    Attributes
    ----------
    center : (c, 2) array of float
        Centers of the cells [m].
    size : (2,) array of float
        Their sides along x and y [m].
    force : (c,) array of float
        Force of the plate on each [N]; where the plate covers a cell in part, it counts as spread over all of it.
    layers : (L, 3) array of float
        Young's modulus [Pa], Poisson's ratio and thickness [m] of the homogeneous layers as analyzed, from the top
        downwards. The thickness of a half-space is infinite; without one a rigid base follows.
    """

    center: Array
    size: Array
    force: Array
    layers: Array

    @property
    def base(self) -> float:
        """The depth of the rigid base [m], infinite on a half-space."""
        return base_of(self._elastic_layers())

    def below(self, places: Array, depth: Array) -> tuple[Array, Array]:
        """Return settlement [m] and vertical stress [Pa] below places (p, 2) at depths (z,) [m], (p, z) each."""
        dx, dy = map(float, self.size)
        cells = LoadedCells(self.center, (dx, dy), self.force)
        return settle_below(self._elastic_layers(), cells, places, depth)

    def at_points(self, points: Array) -> tuple[Array, Array]:
        """Return settlement [m] and vertical stress [Pa] at points (p, 3) of x, y and depth [m], (p,) each.

        Raises InputError for points that are not in the ground.
        """
        _require_within(points, self.base)
        settlement, stress = np.empty(len(points)), np.empty(len(points))
        depths, which = np.unique(points[:, 2], return_inverse=True)
        for start in range(0, len(depths), DEPTHS):
            own = np.flatnonzero((which >= start) & (which < start + DEPTHS))
            places, place = np.unique(points[own, :2], axis=0, return_inverse=True)
            w, sigma = self.below(places, depths[start : start + DEPTHS])
            settlement[own], stress[own] = (each[place.ravel(), which[own] - start] for each in (w, sigma))
        return settlement, stress

    def _elastic_layers(self) -> tuple[ElasticLayer, ...]:
        """Return the layers of the kernels."""
        return tuple(ElasticLayer(float(E), float(nu), float(h)) for E, nu, h in self.layers)


def pressed_cells(solution: Solution) -> PressedCells | None:
    """Return the cells of a solution on an elastic continuum, None on other ground."""
    elastic, pressed = solution.system.problem.elastic, solution.pressed
    if elastic is None or pressed is None:
        return None
    grid = elastic.cells.grid
    x, y = (each.ravel() for each in np.meshgrid(*grid.centers, indexing="ij"))
    center = np.column_stack([x, y])[elastic.cells.number]
    layers = np.array([(layer.E, layer.nu, layer.thickness) for layer in elastic.layers])
    return PressedCells(center, np.array([grid.dx, grid.dy]), pressed.force, layers)


def _require_within(points: Array, base: float) -> None:
    """Raise InputError unless points (p, 3) are numbers, with depths between surface and base."""
    issues = []
    if not np.isfinite(points).all():
        issues.append(Issue("x, y, z", "numbers that are not finite", "coordinates in meters"))
    wrong = points[(points[:, 2] < 0) | (points[:, 2] > base * (1 + ROUNDING)), 2]
    if len(wrong):
        depths = f"depths from 0 m to {base:g} m, where the rigid base is" if base < inf else "depths of 0 m or more"
        issues.append(Issue("z", f"{wrong[0]:g} m", depths, "z is measured downwards from the base of the plate"))
    if issues:
        raise InputError(issues)
