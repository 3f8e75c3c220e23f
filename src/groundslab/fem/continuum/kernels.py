"""How far the surface of layered ground settles under a unit force on a cell: closed forms and a radial table.

T(k) is split into 2 (1 - nu^2) / (E k) of the top layer, whose 1 / r is integrated over cells in closed form; into
images (c_{i+1} - c_i) / k exp(-2 k z_i) of the layers' borders at depths z_i, with 1 / sqrt(r^2 + 4 z_i^2); and into a
rest that vanishes for small and for large k and is transformed by FFTLog (Hamilton 2000, as SciPy has it).
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.continuum.transfer import ElasticLayer, surface_compliance

#: A function of the distance r (...) [m].
Radial = Callable[[Array], Array]
#: Steps of the table of the transform for each factor of e in k and r, and how far it reaches beyond what is used.
STEPS, REACH = 50, 1e6
#: Distances of the table reach from this share of the first border's depth to so many times the last one's.
SMALLEST, LARGEST = 1e-3, 1e5
#: Cells so many cells apart have the mean of 1 / r by its Taylor series, nearer ones in closed form.
FAR = 30
#: Within so many cells the smooth part of the kernel is integrated by more than two points each way:
NEAR = 6
#: by so many for each ratio of the cell to the top layer's thickness, but no more than this.
POINTS, MOST_POINTS = 8, 64
#: What differs by less than this share of the cell is the same place.
ROUNDING = 1e-12


@dataclass(frozen=True, slots=True)
class SurfaceKernel:
    """Settlement of the surface by a vertical unit force at a distance r: c / (2 pi r) and a smooth rest [m/N]."""

    half_space: float  # c = 2 (1 - nu^2) / E [1/Pa] of the top layer
    smooth: Radial
    scale: float  # [m]: over which the rest varies near r = 0; infinite if there is none


@functools.lru_cache(maxsize=64)
def layered_kernel(layers: tuple[ElasticLayer, ...]) -> SurfaceKernel:
    """Return the settlement of layered ground by a unit force; kept for all grids.

    Parameters
    ----------
    layers : tuple of ElasticLayer
        From the top downwards, on a rigid base or with a half-space as the last one.

    Returns
    -------
    SurfaceKernel
        Its closed and its smooth part.
    """
    c = [layer.half_space for layer in layers]
    if np.isinf(layers[-1].thickness):
        depths = np.cumsum([layer.thickness for layer in layers[:-1]])
    else:
        depths, c = np.cumsum([layer.thickness for layer in layers]), [*c, 0.0]
    if not len(depths):
        return SurfaceKernel(c[0], np.zeros_like, np.inf)
    steps = np.diff(c)

    def rest(k: Array) -> Array:
        remainder: Array = surface_compliance(layers, k) * k - c[0]
        for step, z in zip(steps, depths, strict=True):
            remainder = remainder - step * np.exp(-2 * k * z)
        return remainder

    of_rest = hankel(rest, SMALLEST * float(depths[0]), LARGEST * float(depths[-1]))

    def smooth(r: Array) -> Array:
        settlement = of_rest(r)
        for step, z in zip(steps, depths, strict=True):
            settlement = settlement + step / (2 * np.pi * np.hypot(r, 2 * z))
        return settlement

    return SurfaceKernel(c[0], smooth, float(depths[0]))


def hankel(kR: Callable[[Array], Array], smallest: float, largest: float) -> Radial:
    """Return 1 / (2 pi) int R(k) J_0(k r) k dk as a function of r, from k R(k), which vanishes at both ends.

    It is tabulated between two distances [m] and interpolated by a cubic spline over log r; below the smaller one it is
    constant.
    """
    from scipy.interpolate import CubicSpline

    r, values = hankel_table(kR, smallest, largest)
    spline = CubicSpline(np.log(r), values)

    def at(distance: Array) -> Array:
        values: Array = spline(np.log(np.maximum(distance, smallest)))
        return values

    return at


def hankel_table(kR: Callable[[Array], Array], smallest: float, largest: float) -> tuple[Array, Array]:
    """Return distances r (n,) [m] around two, and 1 / (2 pi) int R(k) J_0(k r) k dk there (..., n), from k R(k)."""
    from scipy.fft import fht, fhtoffset

    step = 1 / STEPS
    n = 2 * int(np.ceil(np.log(REACH * np.sqrt(largest / smallest)) / step))
    offset = fhtoffset(step, mu=0, initial=0.0)
    ln = (np.arange(n) - (n - 1) / 2) * step
    middle = np.sqrt(smallest * largest)
    r = middle * np.exp(ln)
    k = np.exp(ln + offset) / middle
    values = fht(kR(k), step, mu=0, offset=offset) / (2 * np.pi * r)
    used = (r > smallest / 3) & (r < 3 * largest)
    return r[used], values[..., used]


def mean_inverse_distance(x: Array, y: Array, dx: float, dy: float) -> Array:
    """Return the mean of 1 / r between the points of two cells dx by dy [m] whose centers are x and y apart, (...).

    Closed form: the fourfold integral of 1 / r is a second difference each way of f(u, v) = u v (u ln(v + r) +
    v ln(u + r)) / 2 - r^3 / 6, whose fourth mixed derivative it is. Far away, where these cancel, a Taylor series.
    """
    x, y = np.broadcast_arrays(np.abs(x), np.abs(y))
    far = np.maximum(x / dx, y / dy) > FAR
    mean = np.empty(x.shape)
    r2 = x[far] ** 2 + y[far] ** 2
    # variances of the distance between two points of two cells are dx^2 / 6 and dy^2 / 6
    second = dx**2 * (3 * x[far] ** 2 / r2 - 1) + dy**2 * (3 * y[far] ** 2 / r2 - 1)
    mean[far] = (1 + second / (12 * r2)) / np.sqrt(r2)
    u, v = x[~far], y[~far]
    total = np.zeros(u.shape)
    for a, of_x in ((-1, 1), (0, -2), (1, 1)):
        for b, of_y in ((-1, 1), (0, -2), (1, 1)):
            total += of_x * of_y * _fourfold(u + a * dx, v + b * dy)
    mean[~far] = total / (dx * dy) ** 2
    return mean


def _fourfold(u: Array, v: Array) -> Array:
    """Return the function whose second derivatives by u and by v make 1 / r."""
    r = np.hypot(u, v)
    tiny = ROUNDING * r.max(initial=1.0)

    def log(a: Array, b: Array) -> Array:
        """Return ln(a + r), without cancellation where a is negative; 0 where it is multiplied with 0."""
        sum_ = np.where(a >= 0, a + r, b**2 / np.maximum(r - a, tiny))
        return np.log(np.where(np.abs(b) > tiny, np.maximum(sum_, 1e-300), 1.0))

    integral: Array = u * v * (u * log(v, u) + v * log(u, v)) / 2 - r**3 / 6
    return integral


def cell_means(kernel: SurfaceKernel, x: Array, y: Array, dx: float, dy: float) -> Array:
    """Return the mean settlement of a cell by a unit force spread evenly over another one, (...) [m/N].

    x and y (...) [m] are the distances of their centers, dx and dy [m] their sides.
    """
    mean = kernel.half_space / (2 * np.pi) * mean_inverse_distance(x, y, dx, dy)
    if np.isinf(kernel.scale):
        return mean
    near = (np.abs(x) < NEAR * dx) & (np.abs(y) < NEAR * dy)
    points = int(min(max(np.ceil(POINTS * max(dx, dy) / kernel.scale), 4), MOST_POINTS))
    mean[near] += _mean_smooth(kernel.smooth, x[near], y[near], dx, dy, points)
    mean[~near] += _mean_smooth(kernel.smooth, x[~near], y[~near], dx, dy, 2)
    return mean


def _mean_smooth(smooth: Radial, x: Array, y: Array, dx: float, dy: float, points: int) -> Array:
    """Return the mean of a smooth function of the distance between the points of two cells, (...).

    The difference of two places in a cell has a triangular density; two points each way have its variance.
    """
    s, weight = (np.array([-1.0, 1.0]) / np.sqrt(6), np.full(2, 0.5)) if points == 2 else _triangular(points)
    mean = np.zeros(x.shape)
    for a, wa in zip(s, weight, strict=True):
        for b, wb in zip(s, weight, strict=True):
            mean += wa * wb * smooth(np.hypot(x + a * dx, y + b * dy))
    return mean


def _triangular(points: int) -> tuple[Array, Array]:
    """Return places and weights of Gauss's rule on both halves of the density 1 - |s| between -1 and 1."""
    s, weight = np.polynomial.legendre.leggauss((points + 1) // 2)
    s, weight = (s + 1) / 2, weight / 2 * (1 - (s + 1) / 2)
    return np.concatenate([-s, s]), np.concatenate([weight, weight])
