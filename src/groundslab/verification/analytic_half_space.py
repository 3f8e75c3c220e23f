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

from groundslab.arrays import Array, Flags

#: Distance from which Gauss's rule takes the corners' place, in diagonals of the area that is integrated over.
FAR = 1.5
#: Points of Gauss's rule along each side of a rectangle, and those that suffice beyond some distance in diagonals.
POINTS, REMOTE, REMOTE_POINTS = 9, 8.0, 5


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
    The error is below 1e-13 up to FAR diagonals from the centre (of the mean, of two diagonals each), and below 1e-10
    of the value further away; measured with 60 digits, sides in the ratio of up to 30.
    """
    at = _broadcast(x, y, z)
    near = _distance(at, sides, mean) <= FAR
    corner = _stress_mean if mean else _stress
    return _corners(corner, near, at, sides, mean) + _gauss(_force_stress, ~near, at, sides, mean)


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
    The error is below 1e-12 of the longer side up to FAR diagonals from the centre, and below 1e-10 of the value
    further away; measured with 60 digits, sides in the ratio of up to 30, layers thicker than 1 % of their depth.
    """
    x, y, top, bottom = _broadcast(x, y, top, bottom)
    far = FAR * (1 + mean) * math.hypot(*sides)
    middle = np.clip(np.sqrt(np.maximum(far**2 - x**2 - y**2, 0.0)), top, bottom)
    below = _compression_below_mean if mean else _compression_below

    def corner(x: Array, y: Array, top: Array, bottom: Array) -> Array:
        return below(x, y, top) - below(x, y, bottom)

    near = _corners(corner, middle > top, (x, y, top, middle), sides, mean)
    return near + _gauss(_force_compression, bottom > middle, (x, y, middle, bottom), sides, mean)


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


def _broadcast(*arrays: ArrayLike) -> tuple[Array, ...]:
    """Return arrays of one shape."""
    return np.broadcast_arrays(*(np.asarray(array, float) for array in arrays))


def _distance(at: tuple[Array, ...], sides: tuple[float, float], mean: bool) -> Array:
    """Return how far points are from the centre, in diagonals of the area over which offsets from them spread."""
    x, y, z, *_ = at
    distance: Array = np.sqrt(x**2 + y**2 + z**2) / ((1 + mean) * math.hypot(*sides))
    return distance


def _corners(
    corner: Callable[..., Array], mask: Flags, at: tuple[Array, ...], sides: tuple[float, float], mean: bool
) -> Array:
    """Return the differences of a function of x, y and depths at the corners, 0 outside the mask."""
    rule = [(-1.0, 1.0), (0.0, -2.0), (1.0, 1.0)] if mean else [(-0.5, -1.0), (0.5, 1.0)]
    total = _sum(corner, rule, mask, at, sides)
    return total / (sides[0] * sides[1]) if mean else total


def _gauss(
    force: Callable[..., Array], mask: Flags, at: tuple[Array, ...], sides: tuple[float, float], mean: bool
) -> Array:
    """Return the integral of a force's field over the rectangle by Gauss's rule, 0 outside the mask."""
    remote = _distance(at, sides, mean) > REMOTE
    near = _sum(force, _gauss_rule(POINTS, mean), mask & ~remote, at, sides)
    return sides[0] * sides[1] * (near + _sum(force, _gauss_rule(REMOTE_POINTS, mean), mask & remote, at, sides))


def _gauss_rule(n: int, mean: bool) -> list[tuple[float, float]]:
    """Return offsets and weights of Gauss's rule over a side; over offsets between two, weighted by 1 - |offset|."""
    points, weights = np.polynomial.legendre.leggauss(n)
    points, weights = points / 2, weights / 2
    if mean:
        points = np.concatenate([points - 0.5, points + 0.5])
        weights = np.tile(weights, 2) * (1 - abs(points))
    return list(zip(points.tolist(), weights.tolist(), strict=True))


def _sum(
    function: Callable[..., Array],
    rule: list[tuple[float, float]],
    mask: Flags,
    at: tuple[Array, ...],
    sides: tuple[float, float],
) -> Array:
    """Return the weighted sum of a function over offsets in both directions, given in sides; 0 outside the mask."""
    x, y, *depths = (values[mask] for values in at)
    total: Array = np.zeros(mask.shape)
    for (s, u), (t, v) in product(rule, rule):
        total[mask] += u * v * function(x + s * sides[0], y + t * sides[1], *depths)
    return total


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
        s, integral = np.hypot(r, z), np.zeros(r.shape)
        np.divide(z**4 * (2 * s + r), 2 * math.pi * r * s**3 * (s + r) ** 2, out=integral, where=r > 0)
        return integral

    stress: Array = np.where(bottom < r, above(bottom) - above(top), below(top) - below(bottom))
    return stress


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
    stress: Array = (_angle(x, y, z) + rest) / (2 * math.pi)
    return stress


def _stress_mean(x: Array, y: Array, z: Array) -> Array:
    """Return the function of which the corner's stress is the mixed derivative."""
    return (x * y * _angle(x, y, z) + z * np.sqrt(x**2 + y**2 + z**2)) / (2 * math.pi)


def _compression_below(x: Array, y: Array, z: Array) -> Array:
    """Return the integral of the stress from z downwards under the corner of a rectangle, odd in x and in y."""
    return (2 * x * _arsinh(y, x, z) + 2 * y * _arsinh(x, y, z) - z * _angle(x, y, z)) / (2 * math.pi)


def _compression_below_mean(x: Array, y: Array, z: Array) -> Array:
    """Return the function of which the integral from z downwards is the mixed derivative, even in x and in y."""
    s3 = (x**2 + y**2 + z**2) ** 1.5
    volume = x**2 * y * _arsinh(y, x, z) + y**2 * x * _arsinh(x, y, z) - x * y * z * _angle(x, y, z)
    return (volume - s3 / 3) / (2 * math.pi)
