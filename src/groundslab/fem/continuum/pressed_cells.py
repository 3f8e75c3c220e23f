"""The cells through which a plate presses on an elastic continuum, and what follows from them in its depth."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf

import numpy as np

from groundslab.arrays import Array
from groundslab.errors import InputError, Issue
from groundslab.fem.continuum.depth import LoadedCells, base_of, settle_below
from groundslab.fem.continuum.elastic_ground import ElasticGround
from groundslab.fem.continuum.media import BondedLayers, StressedLayers
from groundslab.fem.continuum.transfer import ElasticLayer

#: All homogeneous half-spaces have the same stresses.
ANY_HALF_SPACE = ElasticLayer(1.0, 0.0, inf)
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
    settling : (c,) array of float
        What of it settles the ground as under first loading [N]: all, where no excavation has relieved the ground.
    layers : (L, 3) array of float
        Young's modulus [Pa], Poisson's ratio and thickness [m] of the homogeneous layers as analyzed, from the top
        downwards. The thickness of a half-space is infinite; without one a rigid base follows. Of layers that are not
        bonded the constrained modulus, and 0 for the ratio. None if layers differ from place to place.
    bonded : bool
        Whether the layers are bonded; else the stresses of a homogeneous half-space compress them.
    beside : (f, 3) array of float
        Places x, y [m] and forces [N] of loads beside the plate, each spread over an area as large as a cell.
    piled : bool
        Whether piles carry a part of the load down, so that nothing is known of the depth.
    """

    center: Array
    size: Array
    force: Array
    settling: Array
    layers: Array
    bonded: bool
    beside: Array
    piled: bool = False

    @property
    def base(self) -> float:
        """The depth of the rigid base [m], infinite on a half-space and where stresses are those of a half-space."""
        return base_of(self._elastic_layers()) if self.bonded else inf

    @property
    def settles_alike(self) -> bool:
        """Whether the layers are the same everywhere, so that settlements in their depth are known."""
        return len(self.layers) > 0

    def below(self, places: Array, depth: Array) -> tuple[Array, Array]:
        """Return settlement [m] and vertical stress [Pa] below places (p, 2) at depths (z,) [m], (p, z) each.

        Settlements between boreholes are NaN.
        """
        dx, dy = map(float, self.size)
        centers = np.vstack([self.center, self.beside[:, :2]])
        cells = LoadedCells(centers, (dx, dy), np.append(self.force, self.beside[:, 2]))
        if not self.settles_alike:
            _, stress = settle_below((ANY_HALF_SPACE,), cells, places, depth)
            return np.full(stress.shape, np.nan), stress
        settlement, stress = settle_below(self._elastic_layers(), cells, places, depth, self.bonded)
        if not np.array_equal(self.settling, self.force):
            cells = replace(cells, force=np.append(self.settling, self.beside[:, 2]))
            settlement, _ = settle_below(self._elastic_layers(), cells, places, depth, self.bonded)
        return settlement, stress

    def at_points(self, points: Array) -> tuple[Array, Array]:
        """Return settlement [m] and vertical stress [Pa] at points (p, 3) of x, y and depth [m], (p,) each.

        Raises InputError for points that are not in the ground, and where piles carry loads into it.
        """
        if self.piled:
            raise InputError([Issue("supports", "piles, which carry loads into the depth", "a plate without piles")])
        _require_within(points, self.base)
        settlement, stress = np.empty(len(points)), np.empty(len(points))
        depths, which = np.unique(points[:, 2], return_inverse=True)
        for start in range(0, len(depths), DEPTHS):
            chunk = np.flatnonzero((which >= start) & (which < start + DEPTHS))
            places, place = np.unique(points[chunk, :2], axis=0, return_inverse=True)
            w, sigma = self.below(places, depths[start : start + DEPTHS])
            settlement[chunk], stress[chunk] = (values[place.ravel(), which[chunk] - start] for values in (w, sigma))
        return settlement, stress

    def _elastic_layers(self) -> tuple[ElasticLayer, ...]:
        """Return the layers of the kernels."""
        return tuple(ElasticLayer(float(E), float(nu), float(h)) for E, nu, h in self.layers)


def press(ground: ElasticGround, force: Array, beside: Array) -> PressedCells:
    """Return the cells of a ground under forces (c,) [N], and those beside at places, (f, 3)."""
    grid, medium = ground.cells.grid, ground.medium
    x, y = (coordinate.ravel() for coordinate in np.meshgrid(*grid.centers, indexing="ij"))
    center = np.column_stack([x, y])[ground.cells.number]
    if isinstance(medium, BondedLayers):
        layers = [(layer.E, layer.nu, layer.thickness) for layer in medium.layers]
    else:
        assert isinstance(medium, StressedLayers)
        layers = [(M, 0.0, h) for M, h in zip(medium.modulus, medium.thickness, strict=True)]
    table = np.array(layers if ground.columns is None else []).reshape(-1, 3)
    size = np.array([grid.dx, grid.dy])
    bonded, piled = isinstance(medium, BondedLayers), ground.piles is not None
    return PressedCells(center, size, force, ground.settling(force), table, bonded, beside, piled)


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
