"""Settlement and vertical stress in the depth of layered ground under forces on cells of its surface.

What layers carry down is smooth over the plan: W(k, z) and sigma(k, z) of `transfer.carry_down`, transformed by FFTLog
like the surface's settlement. Only near the surface, in the top layer, it is not: there the half-space of that soil
under a rectangle is split off in closed form, and what the other layers add is smooth. Layers that settle by the
stresses of a homogeneous half-space (`media.StressedLayers`) are said by their constrained moduli, with nu = 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.continuum.kernels import NEAR, POINTS, STEPS, hankel_table
from groundslab.fem.continuum.transfer import ElasticLayer, carry_down

#: Within so many sides of a cell below it the half-space is split off.
SHALLOW = 2.0
#: Kernels are constant within this share of the length over which they vary.
FLAT = 1e-3
#: Depths that differ by this share of the largest are the same; the base is reached but for it.
SAME = 1e-9
#: Takes the place of a distance of zero [m], where it is multiplied with zero.
TINY = 1e-100
#: At most so many points each way in a cell, and so many pairs of places and cells at a time.
MOST_POINTS, PAIRS = 32, 1_000_000


@dataclass(frozen=True, slots=True)
class LoadedCells:
    """Rectangles of one size on the surface, each under a vertical force spread evenly over it."""

    center: Array  # (c, 2) [m]
    size: tuple[float, float]  # [m]
    force: Array  # (c,) [N]


@dataclass(frozen=True, slots=True)
class DepthKernels:
    """Settlement [m/N] and stress [1/m2] at z depths by a unit force at a distance r, less what is split off."""

    coefficients: Array  # (2 z, n): of cubic B-splines over log r, STEPS of them for each factor of e
    first: float  # log of the first r [m]
    smallest: float  # [m]: what is nearer is as near
    split: Flags  # (z,): where the half-space of the top layer is split off
    scale: float  # [m]: over which they vary at least


def base_of(layers: Sequence[ElasticLayer]) -> float:
    """Return the depth of the rigid base [m], infinite if there is none."""
    return float(sum(layer.thickness for layer in layers))


def settle_below(
    layers: tuple[ElasticLayer, ...], cells: LoadedCells, places: Array, depth: Array, bonded: bool = True
) -> tuple[Array, Array]:
    """Return settlement [m] and vertical stress [Pa] below places (p, 2) [m] at depths (z,) [m], (p, z) each.

    Parameters
    ----------
    layers : tuple of ElasticLayer
        From the top downwards, on a rigid base or with a half-space as the last one.
    cells : LoadedCells
        What presses on the surface.
    places : (p, 2) array of float
        Places in plan, anywhere [m].
    depth : (z,) array of float
        Depths from the surface, of bonded layers down to the base [m].
    bonded : bool
        Whether layers are bonded; else they are compressed by the stresses of a homogeneous half-space.

    Returns
    -------
    settlement, stress : (p, z) array of float
        Settlement, and vertical stress, compression positive; at the surface the pressure of the cell.

    References
    ----------
    Boussinesq 1885; Holl 1940 for the stress below a loaded rectangle (docs/bibliography.md).
    """
    far = float(np.linalg.norm(np.ptp(np.vstack([cells.center, places]), axis=0))) + 2 * max(cells.size)
    # rounded up, so that other places have the same kernels
    kernels = _kernels(layers, bonded, tuple(map(float, depth)), max(cells.size), 2.0 ** np.ceil(np.log2(far)))
    sums = _sum_smooth(kernels, cells, places)
    settlement, stress = np.split(sums, 2, axis=1)
    for index in np.flatnonzero(kernels.split):
        w, sigma = _sum_half_space(layers[0], cells, places, float(depth[index]))
        settlement[:, index] += w
        stress[:, index] += sigma
    return settlement, stress


@lru_cache(maxsize=16)
def _kernels(
    layers: tuple[ElasticLayer, ...], bonded: bool, depth: tuple[float, ...], side: float, far: float
) -> DepthKernels:
    """Return what carries the surface's forces down to some depths, for cells of a side and distances up to far."""
    from scipy.ndimage import spline_filter1d

    z, top = np.array(depth), layers[0].thickness
    split = (z < SHALLOW * side) & (z <= top)
    # an image below the first border gives the rest the settlement of the lowest soil far away
    image = np.where(split, np.abs(top - z) + top, z)
    image = np.where(np.isinf(image), 1.0, image)
    lowest = layers[-1].half_space if np.isinf(layers[-1].thickness) else 0.0
    far_away = np.where(split, lowest - layers[0].half_space, lowest)
    scale = float(min(image.min(), top)) if split.any() else float(image.min())
    carry = _carry_bonded if bonded else _carry_stressed

    def k_times(k: Array) -> Array:
        W, sigma = carry(layers, z, k)
        kz = k * z[:, None]
        decay = np.where(split[:, None], np.exp(-kz), 0.0)
        W = k * W - decay * layers[0].half_space * (1 + kz / (2 * (1 - layers[0].nu)))
        W = W - far_away[:, None] * np.exp(-k * image[:, None])
        return np.concatenate([W, k * (sigma - decay * (1 + kz))])

    r, values = hankel_table(k_times, FLAT * scale, max(far, float(image.max())))
    values[: len(z)] += far_away[:, None] / (2 * np.pi * np.hypot(r, image[:, None]))
    return DepthKernels(spline_filter1d(values), float(np.log(r[0])), FLAT * scale, split, scale)


def _carry_bonded(layers: tuple[ElasticLayer, ...], z: Array, k: Array) -> tuple[Array, Array]:
    """Return W [m/Pa] and sigma at depths of bonded layers, (z, n) each."""
    cut, at = _cut(layers, z)
    W, sigma = carry_down(cut, k)
    return W[at], sigma[at]


def _carry_stressed(layers: tuple[ElasticLayer, ...], z: Array, k: Array) -> tuple[Array, Array]:
    """Return the same of layers of constrained moduli E: sigma = (1 + k z) exp(-k z), W its integral from z over E."""
    bottoms = np.cumsum([layer.thickness for layer in layers])
    tops = np.concatenate([[0.0], bottoms[:-1]])

    def k_times_below(depth: Array) -> Array:
        kz: Array = k * depth[:, None]
        return (2 + kz) * np.exp(-kz)

    kW = sum(
        (k_times_below(np.maximum(z, top)) - k_times_below(np.maximum(z, bottom))) / layer.E
        for layer, top, bottom in zip(layers, tops, bottoms, strict=True)
    )
    kz = k * z[:, None]
    return kW / k, (1 + kz) * np.exp(-kz)


def _cut(layers: tuple[ElasticLayer, ...], z: Array) -> tuple[list[ElasticLayer], Integers]:
    """Return the layers, cut so that one begins at each depth (z,), and which one does."""
    base = base_of(layers)
    tops = np.concatenate([[0.0], np.cumsum([layer.thickness for layer in layers[:-1]])])
    same = SAME * max(float(tops[-1]), float(z.max()), 0.0 if np.isinf(base) else base)
    z = np.minimum(z, base - same)
    new = [depth for depth in np.unique(z) if np.abs(tops - depth).min() > same]
    all_ = np.sort(np.concatenate([tops, new]))
    all_ = all_[np.diff(all_, prepend=-np.inf) > same / 2]
    of = np.searchsorted(tops, all_ + same / 2, side="right") - 1
    thickness = np.diff(all_, append=base)
    cut = [replace(layers[i], thickness=float(h)) for i, h in zip(of, thickness, strict=True)]
    return cut, np.abs(all_ - z[:, None]).argmin(axis=1)


def _sum_smooth(kernels: DepthKernels, cells: LoadedCells, places: Array) -> Array:
    """Return the sums (p, 2 z) of the kernels over all cells, each integrated by points.

    As splines are linear in their coefficients, what the cells give to each coefficient is the same for all depths.
    """
    points = int(np.clip(np.ceil(POINTS * max(cells.size) / kernels.scale), 2, MOST_POINTS))
    shares = np.zeros((len(places), kernels.coefficients.shape[1]))
    for start in range(0, len(places), step := max(1, PAIRS // len(cells.force))):
        apart = places[start : start + step, None] - cells.center
        near = (np.abs(apart) < NEAR * np.array(cells.size)).all(axis=2)
        for chosen, each_way in ((near, points), (~near, 2)):
            place, cell = np.nonzero(chosen)
            pressed = LoadedCells(apart[place, cell], cells.size, cells.force[cell])
            shares[start : start + step] += _shares(kernels, pressed, place, len(apart), each_way)
    sums: Array = shares @ kernels.coefficients.T
    return sums


def _shares(kernels: DepthKernels, cells: LoadedCells, place: Integers, places: int, points: int) -> Array:
    """Return what k cells, whose centers are seen from some places, give to each coefficient, (places, n)."""
    n = kernels.coefficients.shape[1]
    sums = np.zeros(places * n)
    x, y = cells.center.T
    s, weight = np.polynomial.legendre.leggauss(points)
    for a, wa in zip(s, weight / 2, strict=True):
        for b, wb in zip(s, weight / 2, strict=True):
            r = np.hypot(x + a * cells.size[0] / 2, y + b * cells.size[1] / 2)
            at = (np.log(np.maximum(r, kernels.smallest)) - kernels.first) * STEPS
            whole = at.astype(np.int64)
            for i, basis in enumerate(_cubic(at - whole)):
                sums += np.bincount(place * n + whole - 1 + i, wa * wb * basis * cells.force, len(sums))
    return sums.reshape(places, n)


def _cubic(f: Array) -> tuple[Array, ...]:
    """Return the four cubic B-splines over equal steps that are not zero at a share f of a step."""
    g = 1 - f
    return g**3 / 6, (3 * f**3 - 6 * f**2 + 4) / 6, (3 * g**3 - 6 * g**2 + 4) / 6, f**3 / 6


def _sum_half_space(soil: ElasticLayer, cells: LoadedCells, places: Array, z: float) -> tuple[Array, Array]:
    """Return settlement [m] and vertical stress [Pa] of a half-space at a depth below places (p, 2), (p,) each.

    The integrals of Boussinesq's settlement (1 + nu) / (2 pi E) (2 (1 - nu) / R + z^2 / R^3) and stress
    3 z^3 / (2 pi R^5) (1885) over rectangles, as differences over their corners.
    """
    settlement, stress = np.zeros(len(places)), np.zeros(len(places))
    pressure = cells.force / (cells.size[0] * cells.size[1])
    half = np.array(cells.size) / 2
    for start in range(0, len(places), step := max(1, PAIRS // len(pressure))):
        part = slice(start, start + step)
        apart = places[part, None] - cells.center
        for a, b in ((1, 1), (-1, -1), (1, -1), (-1, 1)):
            u, v = np.moveaxis(apart + half * [a, b], 2, 0)
            inverse, cubed, sigma = _of_corner(u, v, z)
            bent = 2 * (1 - soil.nu) * inverse + cubed
            settlement[part] += a * b * (1 + soil.nu) / (2 * np.pi * soil.E) * (bent @ pressure)
            stress[part] += a * b / (2 * np.pi) * (sigma @ pressure)
    return settlement, stress


def _of_corner(u: Array, v: Array, z: float) -> tuple[Array, Array, Array]:
    """Return the integrals over 0 to u and 0 to v of 1 / R, z^2 / R^3 and 3 z^3 / R^5 (Holl 1940)."""
    of_u, of_v = np.maximum(np.hypot(u, z), TINY), np.maximum(np.hypot(v, z), TINY)
    R = np.maximum(np.sqrt(u**2 + v**2 + z**2), TINY)
    angle = np.arctan2(u * v, z * R)
    # arsinh(v / of_u) is ln(v + R) - ln(of_u), without cancellation
    inverse = u * np.arcsinh(v / of_u) + v * np.arcsinh(u / of_v) - z * angle
    return inverse, z * angle, angle + (u / of_u) * (v / of_v) * z / R * (of_u / of_v + of_v / of_u)
