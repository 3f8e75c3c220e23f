"""The homogeneous elastic half-space under a uniformly loaded rectangle: vertical stress, its integral, settlement.

A vertical force P on the surface causes at the distance r and the depth z (Boussinesq 1885), with s^2 = r^2 + z^2,

    sigma_z = 3 P z^3 / (2 pi s^5),     int_z^inf sigma_z dz = P (3 - r^2 / s^2) / (2 pi s)

At z = 0 the second is P / (pi r), and the surface settles by (1 - nu^2) / (pi E) P / r: by (1 - nu^2) / E times the
integral of sigma_z over all depths. Integrated over the rectangle from the corner (0, 0) to (x, y) under the pressure
q = 1 (stress: Steinbrenner 1934, in the form of Holl 1940; settlement: Love 1929), with
L_x = arsinh(x / sqrt(y^2 + z^2)), L_y = arsinh(y / sqrt(x^2 + z^2)), T = arctan(x y / (z s)), s^2 = x^2 + y^2 + z^2:

    2 pi sigma_z              = T + x y z / s (1 / (x^2 + z^2) + 1 / (y^2 + z^2)) = T - z dT/dz
    2 pi int_z^inf sigma_z dz = 2 x L_y + 2 y L_x - z T

The same averaged over a second rectangle follows from the functions of which these are the mixed derivatives d2/dxdy:

    x y T + z s     and     x^2 y L_y + y^2 x L_x - x y z T - s^3 / 3

All of them are taken at the corners, as first differences for a point and as second differences for an average. They
cancel where the point is far, so that there the force's formulas are integrated by Gauss's rule. The integrals of
sigma_z were derived here and are tested against quadrature; the sources were not at hand.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import product

import numpy as np
from numpy.typing import ArrayLike

from groundslab.arrays import Array

#: Beyond this distance, in diagonals of what is integrated over, Gauss's rule takes the corners' place.
FAR = 2.5
#: Points of Gauss's rule along each side of a rectangle.
POINTS = 8


def vertical_stress(x: ArrayLike, y: ArrayLike, z: ArrayLike, sides: tuple[float, float], mean: bool = False) -> Array:
    """Return the vertical stress in the half-space under a rectangle that is loaded by a unit pressure.

    Parameters
    ----------
    x, y : array_like
        Where, from the rectangle's centre [m].
    z : array_like
        Depth [m], >= 0; x, y and z broadcast against each other.
    sides : tuple of float
        Length of the rectangle along x and along y [m].
    mean : bool
        Average over a rectangle of the same sides around (x, y) instead of the value at the point.

    Returns
    -------
    ndarray
        sigma_z / q [-], compression positive, in the shape to which x, y and z broadcast. On the surface it is 1
        inside the rectangle, 1/2 on its edges, 1/4 at its corners.

    Notes
    -----
    The error is below 1e-14 near the rectangle and below 1e-12 of the value beyond FAR diagonals.
    """
    near = _stress_mean if mean else _stress
    return _integrate(near, _force_stress, np.broadcast_arrays(x, y, z), sides, mean)


def compression(
    x: ArrayLike, y: ArrayLike, top: ArrayLike, bottom: ArrayLike, sides: tuple[float, float], mean: bool = False
) -> Array:
    """Return the integral of the vertical stress over a layer under a rectangle that is loaded by a unit pressure.

    Divided by a modulus it is how much the layer is compressed.

    Parameters
    ----------
    x, y : array_like
        Where, from the rectangle's centre [m].
    top, bottom : array_like
        Depths between which to integrate [m], 0 <= top <= bottom, which may be infinite; all four broadcast.
    sides : tuple of float
        Length of the rectangle along x and along y [m].
    mean : bool
        Average over a rectangle of the same sides around (x, y) instead of the value at the point.

    Returns
    -------
    ndarray
        int sigma_z / q dz [m], in the shape to which x, y, top and bottom broadcast.

    Notes
    -----
    The error is below 1e-14 of the longer side near the rectangle (1e-13 of a mean) and below 1e-11 of the value
    beyond FAR diagonals, but for layers that are thinner than a hundredth of their depth.
    """

    def near(x: Array, y: Array, top: Array, bottom: Array) -> Array:
        below = _compression_below_mean if mean else _compression_below
        return below(x, y, top) - below(x, y, bottom)

    return _integrate(near, _force_compression, np.broadcast_arrays(x, y, top, bottom), sides, mean)


def surface_settlement(
    x: ArrayLike, y: ArrayLike, sides: tuple[float, float], E: float, nu: float, mean: bool = False
) -> Array:
    """Return the settlement of the half-space's surface by a unit pressure on a rectangle (Love 1929).

    Parameters
    ----------
    x, y : array_like
        Where, from the rectangle's centre [m]; both broadcast.
    sides : tuple of float
        Length of the rectangle along x and along y [m].
    E, nu : float
        Young's modulus [Pa] and Poisson's ratio of the half-space.
    mean : bool
        Average over a rectangle of the same sides around (x, y) instead of the value at the point.

    Returns
    -------
    ndarray
        w / q [m/Pa], in the shape to which x and y broadcast.
    """
    return (1 - nu**2) / E * compression(x, y, 0.0, np.inf, sides, mean)


def _integrate(
    near: Callable[..., Array],
    force: Callable[..., Array],
    at: tuple[Array, ...],
    sides: tuple[float, float],
    mean: bool,
) -> Array:
    """Return the integral of a force's field over the rectangle, at x, y and depths, from corners or by Gauss's rule.

    A mean is the integral over all differences of places in two rectangles, weighted by how often they occur.
    """
    x, y, *depths = (np.asarray(each, float) for each in at)
    a, b = sides
    far = np.sqrt(x**2 + y**2 + depths[0] ** 2) > FAR * (1 + mean) * math.hypot(a, b)
    result = np.zeros(x.shape)
    for mask, function, rule, scale in (
        (~far, near, _corners(mean), 1 / (a * b) if mean else 1.0),
        (far, force, _gauss(mean), a * b),
    ):
        x_in, y_in, *depths_in = (each[mask] for each in (x, y, *depths))
        terms = (u * v * function(x_in + s * a, y_in + t * b, *depths_in) for (s, u), (t, v) in product(rule, rule))
        result[mask] = scale * sum(terms, start=np.zeros(x_in.shape))
    return result


def _corners(mean: bool) -> list[tuple[float, float]]:
    """Return the offsets, in sides, and weights of first differences, or of second ones."""
    return [(-1.0, 1.0), (0.0, -2.0), (1.0, 1.0)] if mean else [(-0.5, -1.0), (0.5, 1.0)]


def _gauss(mean: bool) -> list[tuple[float, float]]:
    """Return the offsets, in sides, and weights of Gauss's rule over a side, or over differences between two."""
    points, weights = np.polynomial.legendre.leggauss(POINTS)
    points, weights = points / 2, weights / 2
    if mean:  # the weight 1 - |offset|, a rule for each sign
        points = np.concatenate([points - 0.5, points + 0.5])
        weights = np.tile(weights, 2) * (1 - abs(points))
    return list(zip(points.tolist(), weights.tolist(), strict=True))


def _force_stress(x: Array, y: Array, z: Array) -> Array:
    """Return the stress by a unit force [1/m2]."""
    return 3 * z**3 / (2 * math.pi * (x**2 + y**2 + z**2) ** 2.5)


def _force_compression(x: Array, y: Array, top: Array, bottom: Array) -> Array:
    """Return the integral of the stress by a unit force over a layer [1/m]: from below, or from above where shallow."""
    r = np.hypot(x, y)

    def below(z: Array) -> Array:
        s = np.hypot(r, z)
        return (3 - (r / s) ** 2) / (2 * math.pi * s)

    def above(z: Array) -> Array:  # 1 / (pi r) less what is below, without cancellation
        z = np.minimum(z, r)
        s = np.hypot(r, z)
        return np.divide(z**4 * (2 * s + r), 2 * math.pi * r * s**3 * (s + r) ** 2, out=np.zeros(r.shape), where=r > 0)

    return np.where(bottom < r, above(bottom) - above(top), below(top) - below(bottom))


def _arsinh(x: Array, y: Array, z: Array) -> Array:
    """Return L_x, 0 where its factors vanish."""
    radius = np.hypot(y, z)
    return np.arcsinh(np.divide(x, radius, out=np.zeros(radius.shape), where=radius > 0))


def _angle(x: Array, y: Array, z: Array) -> Array:
    """Return T."""
    return np.arctan2(x * y, z * np.sqrt(x**2 + y**2 + z**2))


def _stress(x: Array, y: Array, z: Array) -> Array:
    """Return the stress under the corner of a rectangle, odd in x and in y."""
    s2, x2, y2 = x**2 + y**2 + z**2, x**2 + z**2, y**2 + z**2
    rest = np.divide(x * y * z * (x2 + y2), np.sqrt(s2) * x2 * y2, out=np.zeros(s2.shape), where=z > 0)
    return (_angle(x, y, z) + rest) / (2 * math.pi)


def _stress_mean(x: Array, y: Array, z: Array) -> Array:
    """Return the function of which the corner's stress is the mixed derivative."""
    return (x * y * _angle(x, y, z) + z * np.sqrt(x**2 + y**2 + z**2)) / (2 * math.pi)


def _finite(below: Callable[[Array, Array, Array], Array]) -> Callable[[Array, Array, Array], Array]:
    """Return a function of x, y and z that is 0 where z is infinite."""

    def function(x: Array, y: Array, z: Array) -> Array:
        finite = np.isfinite(z)
        return np.where(finite, below(x, y, np.where(finite, z, 0.0)), 0.0)

    return function


@_finite
def _compression_below(x: Array, y: Array, z: Array) -> Array:
    """Return the integral of the stress from z downwards under the corner of a rectangle, odd in x and in y."""
    return (2 * x * _arsinh(y, x, z) + 2 * y * _arsinh(x, y, z) - z * _angle(x, y, z)) / (2 * math.pi)


@_finite
def _compression_below_mean(x: Array, y: Array, z: Array) -> Array:
    """Return the function of which the integral from z downwards is the mixed derivative, even in x and in y."""
    s3 = (x**2 + y**2 + z**2) ** 1.5
    volume = x**2 * y * _arsinh(y, x, z) + y**2 * x * _arsinh(x, y, z) - x * y * z * _angle(x, y, z)
    return (volume - s3 / 3) / (2 * math.pi)
