"""A vertical force within the half-space (Mindlin 1936, as a public program for tunnels has it, TUBEURB)."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from groundslab.arrays import Array

#: Points of Gauss's rule along a shaft, in a variable that is dense beside the point that settles.
SHAFT_POINTS = 60


def settlement_by_force(r: ArrayLike, z: ArrayLike, c: ArrayLike, G: float, nu: float) -> Array:
    """Return the settlement of points of the half-space by a vertical unit force within it (Mindlin 1936).

    Parameters
    ----------
    r : array_like
        Distances of the points from the force's line [m].
    z, c : array_like
        Depths of the points and of the force [m], >= 0; all three broadcast.
    G, nu : float
        Shear modulus [Pa] and Poisson's ratio.

    Returns
    -------
    ndarray
        Settlement [m/N].
    """
    r, z, c = (np.asarray(each, float) for each in (r, z, c))
    R1, R2 = np.hypot(r, z - c), np.hypot(r, z + c)
    k = 3 - 4 * nu
    w = k / R1 + (8 * (1 - nu) ** 2 - k) / R2 + (z - c) ** 2 / R1**3
    w += (k * (z + c) ** 2 - 2 * c * z) / R2**3 + 6 * c * z * (z + c) ** 2 / R2**5
    settlement: Array = w / (16 * math.pi * G * (1 - nu))
    return settlement


def settlement_by_shaft(r: ArrayLike, z: ArrayLike, top: float, bottom: float, G: float, nu: float) -> Array:
    """Return the settlement of points of the half-space by a unit force spread evenly along a vertical line.

    Parameters
    ----------
    r : array_like
        Distances of the points from the line [m], > 0: the shaft's radius for the pile itself.
    z : array_like
        Depths of the points [m], >= 0; both broadcast.
    top, bottom : float
        Depths of the line's ends [m].
    G, nu : float
        Shear modulus [Pa] and Poisson's ratio.

    Returns
    -------
    ndarray
        Settlement [m/N]: Mindlin's integrated by Gauss's rule over u of c = z + r sinh u, which takes 1 / R1 out.
    """
    points, weights = np.polynomial.legendre.leggauss(SHAFT_POINTS)
    r, z = (np.asarray(each, float)[..., None] for each in (r, z))
    first, last = np.arcsinh((top - z) / r), np.arcsinh((bottom - z) / r)
    u = (first + last) / 2 + (last - first) / 2 * points
    settlement = settlement_by_force(r, z, np.maximum(z + r * np.sinh(u), 0.0), G, nu) * r * np.cosh(u)
    integral: Array = (settlement * weights).sum(axis=-1) * ((last - first) / 2)[..., 0] / (bottom - top)
    return integral


def surface_settlement_by_shaft(r: ArrayLike, length: float, G: float, nu: float) -> Array:
    """Return the settlement of the surface by a unit force spread evenly along a pile's axis.

    Parameters
    ----------
    r : array_like
        Distances from the axis [m], > 0.
    length : float
        Length of the pile, from the surface [m].
    G, nu : float
        Shear modulus [Pa] and Poisson's ratio.

    Returns
    -------
    ndarray
        Settlement [m/N], the integral of Mindlin's (2 (1 - nu) / R + c^2 / R^3) / (4 pi G) over the depth c.
    """
    ratio = length / np.asarray(r, float)
    w = (3 - 2 * nu) * np.arcsinh(ratio) - ratio / np.sqrt(1 + ratio**2)
    settlement: Array = w / (4 * math.pi * G * length)
    return settlement
