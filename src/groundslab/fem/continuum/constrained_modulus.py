"""Settlement by constrained moduli: stresses of the homogeneous half-space, strains of each layer confined.

    w = sum over layers of 1 / E_s int_layer sigma_z dz

sigma_z is that of `boussinesq`: layers do not spread the load. This is how DIN 4019 and EN 1997-1, annex F
(stress-strain method), calculate settlements. Neither text was at hand: what is said of them here follows manuals of
programs that apply them (GGU-Settle, GGU-Cantilever, D.I.E. XSETZ, ELPLA), and clauses are given from memory. By an
excerpt of DIN 4019 of 2014 its 8.4 calls the modulus E* and allows E_s for it.

Reloading: the ground under an excavation was compressed by what was dug out, p_v = gamma d. Up to p_v the pressure
compresses it with E_s,reload, what exceeds p_v with E_s (GGU-Settle's manual; ELPLA calls the moduli W_s and E_s and
p_v the overburden pressure q_v). The settlement counts from the bottom of the excavation after its heave. Some
programs take p_v off the pressure instead (GGU-Cantilever's manual): that is E_s,reload = infinity.

Limit depth: settlements are summed to where the load's stress is 20 % of the effective overburden stress (EN 1997-1,
6.6.2, from memory; DIN 4019 at the characteristic point, by GGU-Cantilever's and XSETZ's manuals).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from groundslab.arrays import Array
from groundslab.fem.continuum.boussinesq import compression

#: Share of the effective overburden stress at which the load's stress no longer counts (EN 1997-1, 6.6.2).
LIMIT_RATIO = 0.2
#: Characteristic point of a rectangle, in sides from its centre along both: flexible or rigid, it settles alike
#: (Grasshoff and Kany; 0.74 of half the side, from memory).
CHARACTERISTIC_POINT = 0.37
#: Depths at which a stress is compared with the overburden before the limit depth is searched between two of them.
SCANNED_DEPTHS = 200


@dataclass(frozen=True, slots=True)
class Columns:
    """Layers with constrained moduli under the loaded surface, from the top, in c columns of soil."""

    thickness: Array  # (c, L) [m]; 0 where a column lacks a layer, the last one may be infinite
    E_s: Array  # (c, L) [Pa]: for loading
    E_reload: Array | None = None  # (c, L) [Pa]: up to the relief by excavation; None where it is E_s

    @property
    def bottoms(self) -> Array:
        """Return the depths of the layers' bottoms [m], (c, L)."""
        depths: Array = np.cumsum(self.thickness, axis=1)
        return depths

    def cut(self, depth: ArrayLike) -> Columns:
        """Return the columns down to a depth [m], one for all or (c,): what lies below is not compressed."""
        bottoms = np.minimum(self.bottoms, np.reshape(depth, (-1, 1)))
        return Columns(np.diff(bottoms, axis=1, prepend=0.0), self.E_s, self.E_reload)


def settlement_kernels(
    x: ArrayLike, y: ArrayLike, sides: tuple[float, float], columns: Columns, reload: bool = False, mean: bool = False
) -> Array:
    """Return the settlement of points on columns of soil by a unit pressure on one cell.

    Parameters
    ----------
    x, y : array_like
        Offsets of the points from the loaded cell's centre [m], such as (nx, 1) and (ny,) for a grid.
    sides : tuple of float
        Sides of the cell along x and along y [m].
    columns : Columns
        Layers under the points, c columns.
    reload : bool
        Whether the moduli are those for reloading.
    mean : bool
        Average over an equal cell around each point instead of the value at the point.

    Returns
    -------
    ndarray
        Settlement by 1 Pa [m/Pa], (c, ...) with the shape to which x and y broadcast.

    Notes
    -----
    A point settles by its own column's kernel, wherever the load stands. Between points on different columns the
    settlements are therefore not reciprocal: the flexibility matrix of several columns is not symmetric.
    """
    moduli = columns.E_reload if reload and columns.E_reload is not None else columns.E_s
    x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
    kernels = np.zeros((len(moduli), *x.shape))
    layer = cache(lambda top, bottom: compression(x, y, top, bottom, sides, mean))
    for c, (bottoms, E) in enumerate(zip(columns.bottoms, moduli, strict=True)):
        tops = np.concatenate([[0.0], bottoms[:-1]])
        for top, bottom, modulus in zip(tops, bottoms, E, strict=True):
            if bottom > top:
                kernels[c] += layer(top, bottom) / modulus
    return kernels


def split_by_relief(p: ArrayLike, relief: ArrayLike) -> tuple[Array, Array]:
    """Return the parts of a pressure that reload the ground and that load it beyond the relief by excavation.

    Parameters
    ----------
    p : array_like
        Pressure on cells [Pa], >= 0.
    relief : array_like
        Stress that the excavation took off at the level of the foundation [Pa], >= 0; both broadcast.

    Returns
    -------
    tuple of ndarray
        min(p, relief) and max(p - relief, 0) [Pa]: the first with the kernel for reloading and the second with that
        for loading give the settlement.
    """
    p, relief = np.asarray(p, float), np.asarray(relief, float)
    return np.minimum(p, relief), np.maximum(p - relief, 0.0)


def effective_overburden(
    z: ArrayLike, thickness: Array, gamma: Array, submerged: Array, water: float = math.inf, surcharge: float = 0.0
) -> Array:
    """Return the effective vertical stress by the soil's own weight.

    Parameters
    ----------
    z : array_like
        Depth below the loaded surface [m], >= 0, of any shape.
    thickness : ndarray
        Thickness of the layers from the top [m], (L,); the last one goes on downwards.
    gamma, submerged : ndarray
        Unit weight above groundwater and effective unit weight under it [N/m3], (L,).
    water : float
        Depth of the groundwater below the loaded surface [m], negative where it stands above.
    surcharge : float
        Effective stress at the loaded surface [Pa], by soil above it.

    Returns
    -------
    ndarray
        Effective stress [Pa], in the shape of z.
    """
    depth = np.asarray(z, float)[..., None]
    bottom = np.append(np.cumsum(thickness)[:-1], np.inf)
    top = np.concatenate([[0.0], bottom[:-1]])
    moist = np.clip(np.minimum(depth, water), top, bottom) - top
    wet = np.clip(depth, top, bottom) - top - moist
    stress: Array = surcharge + moist @ gamma + wet @ submerged
    return stress


def limit_depth(
    stress: Callable[[Array], Array], overburden: Callable[[Array], Array], deepest: float, ratio: float = LIMIT_RATIO
) -> float:
    """Return the depth below which the load's stress stays under a share of the effective overburden stress.

    Parameters
    ----------
    stress : callable
        Vertical stress by the load [Pa] at depths (k,) [m], under the characteristic point, or on average.
    overburden : callable
        Effective overburden stress [Pa] at depths (k,) [m].
    deepest : float
        Depth down to which to search [m], finite, such as that of the lowest known layer's bottom.
    ratio : float
        The share, 0.2.

    Returns
    -------
    float
        Limit depth [m]: 0 where the stress exceeds the share nowhere, infinity where it does at the deepest place.
    """
    from scipy.optimize import brentq

    def excess(z: float) -> float:
        at = np.array([z])
        return float(stress(at)[0] - ratio * overburden(at)[0])

    z = np.linspace(0.0, deepest, SCANNED_DEPTHS + 1)
    above = np.flatnonzero(stress(z) > ratio * overburden(z))
    if not above.size:
        return 0.0
    last = int(above[-1])
    return math.inf if last == SCANNED_DEPTHS else float(brentq(excess, z[last], z[last + 1], xtol=1e-10))
