"""Loaded areas and rigid plates on an elastic half-space, and on an elastic layer bonded to a rigid base."""

from __future__ import annotations

import math
from itertools import product

import numpy as np

from groundslab.arrays import Array
from groundslab.verification.analytic_half_space import surface_settlement, vertical_stress

#: Points of Gauss's rule over a plate, and over a half wave of a Bessel function.
POINTS = 24
#: The layer's transfer function differs from a half-space's by exp(-2 k h) times a polynomial: none is left beyond.
FADED = 22.0
#: Cells of a rigid rectangle, from its middle to an edge.
CELLS = 28


def flexible_rectangle(x: float, y: float, a: float, b: float, q: float, E: float, nu: float) -> float:
    """Return the settlement [m] of a half-space at x and y from the center of a x b under q [Pa] (Love 1929)."""
    return q * float(surface_settlement(x, y, (a, b), E, nu))


def stress_below_rectangle(x: float, y: float, z: float, a: float, b: float, q: float) -> float:
    """Return the vertical stress [Pa] in a half-space at z below such an area (Steinbrenner 1934, Holl 1940)."""
    return q * float(vertical_stress(x, y, z, (a, b)))


def flexible_circle(r: float, radius: float, q: float, E: float, nu: float, h: float = math.inf) -> float:
    """Return the settlement [m] of ground at r from the middle of a circle under the pressure q [Pa].

    On a half-space 4 q a (1 - nu^2) / (pi E) times E(r / a) within the circle, and with its complement beyond (Love
    1929); a layer of depth h [m] adds int (T - 2 (1 - nu^2) / (E k)) q a J1(k a) J0(k r) dk.
    """
    from scipy.special import ellipe, ellipk, j0, j1

    m = (r / radius) ** 2
    shape = ellipe(m) if m <= 1 else math.sqrt(m) * (ellipe(1 / m) - (1 - 1 / m) * ellipk(1 / m))
    settlement = 4 * q * radius * (1 - nu**2) / (math.pi * E) * float(shape)
    if math.isinf(h):
        return settlement
    k, weight = _waves(radius + r, h)
    lacks = 2 * (1 - nu**2) / E * (_layer(k * h, nu) - 1) / k
    return settlement + float(weight @ (lacks * q * radius * j1(k * radius) * j0(k * r)))


def rigid_circle_on_half_space(x: float, radius: float, P: float, E: float, nu: float, e: float = 0.0) -> float:
    """Return the settlement [m] on the axis through a rigid circle, x from its middle, under P [N] at e [m].

    P (1 - nu^2) / (2 a E), a tilt of 3 P e (1 - nu^2) / (4 a^3 E), all of the circle in contact for e <= a / 3; beyond
    the circle 2 / pi times arcsin(a / x), and arcsin(a / x) - a / x sqrt(1 - a^2 / x^2), of both (Sneddon 1951).
    """
    if abs(e) > radius / 3:
        raise ValueError(f"a circle of {radius} m lifts off under a force {e} m from its middle")
    down = P * (1 - nu**2) / (2 * radius * E)
    tilt = 3 * P * e * (1 - nu**2) / (4 * radius**3 * E)
    if abs(x) <= radius:
        return down + tilt * x
    s = radius / abs(x)
    beyond = math.asin(s) - s * math.sqrt(1 - s**2)
    return 2 / math.pi * (down * math.asin(s) + tilt * x * beyond)


def rigid_circle_on_layer(radius: float, P: float, E: float, nu: float, h: float) -> float:
    """Return the settlement [m] of a rigid circle under P [N] on a layer of depth h [m].

    The pressure's transform is int phi(t) cos(k t) dt over 0 .. a. With 2 (1 - nu^2) / E L(k h) for k T and
    M(t, s) = 2 / pi int (1 - L) cos(k t) cos(k s) dk, phi - int M phi ds is the same at all t, and P is 2 pi int phi
    (Lebedev and Ufliand 1958).
    """
    t, weight = np.polynomial.legendre.leggauss(POINTS)
    t, weight = radius * (t + 1) / 2, radius * weight / 2
    k, share = _waves(2 * radius, h)
    waves = np.cos(np.outer(t, k))
    M = 2 / math.pi * (waves * share * (1 - _layer(k * h, nu))) @ waves.T
    phi = np.linalg.solve(np.eye(POINTS) - M * weight, np.ones(POINTS))
    # of the settlement 2 (1 - nu^2) / E pi / 2
    return math.pi * (1 - nu**2) / E * P / (2 * math.pi * float(weight @ phi))


def rigid_rectangle_on_half_space(x: float, a: float, b: float, P: float, E: float, nu: float, e: float = 0.0) -> float:
    """Return the settlement [m] at x on the axis along a of a rigid rectangle a x b under P [N] at e [m], in contact.

    Cells of constant pressure that are finer and finer towards the edges, settled at their centers by Love's closed
    form; extrapolated from two such grids, as their errors fall with the square of the number of cells. For a square
    P / a settles 1 / (pi 0.36679) times (1 - nu^2) / E, by the capacitance of a square plate (Read 1997).
    """
    coarse, fine = (_rigid_rectangle(cells, x, a, b, P, E, nu, e) for cells in (CELLS // 2, CELLS))
    return fine + (fine - coarse) / 3


def _rigid_rectangle(cells: int, x: float, a: float, b: float, P: float, E: float, nu: float, e: float) -> float:
    """Return the same by one grid of so many cells from the middle to an edge, for a quarter of the rectangle."""
    edge = np.sin(np.linspace(0, math.pi / 2, cells + 1))
    (u, du), (v, dv) = ((side / 4 * (edge[1:] + edge[:-1]), side / 2 * np.diff(edge)) for side in (a, b))
    U, V = (grid.ravel() for grid in np.meshgrid(u, v, indexing="ij"))
    DU, DV = (grid.ravel() for grid in np.meshgrid(du, dv, indexing="ij"))

    def pressures(settled: Array, odd: float) -> Array:
        """Return pressures for settlements that are the same, or opposite, on both sides."""
        F = np.zeros((len(U), len(U)))
        for i, j in product((1, -1), repeat=2):
            F += (odd if i < 0 else 1.0) * _love(U[:, None] - i * U, V[:, None] - j * V, DU, DV)
        return np.asarray(np.linalg.solve(F * (1 - nu**2) / (math.pi * E), settled), dtype=float)

    settlement = P / (4 * float(pressures(np.ones(len(U)), 1.0) @ (DU * DV)))
    if e:
        settlement += x * P * e / (4 * float(pressures(U, -1.0) @ (DU * DV * U)))
    return settlement


def _love(x: Array, y: Array, a: Array, b: Array) -> Array:
    """Return int dA / r over rectangles a x b from places x and y off their centers [m]."""

    def corner(u: Array, v: Array) -> Array:
        return u * np.arcsinh(v / np.abs(u)) + v * np.arcsinh(u / np.abs(v))

    integral = np.zeros(np.broadcast_shapes(x.shape, a.shape))
    for i, j in product((-1, 1), repeat=2):
        integral += corner(a / 2 + i * x, b / 2 + j * y)
    return integral


def _layer(x: Array, nu: float) -> Array:
    """Return how much a layer settles of what a half-space does, at x = k h.

    (2 kappa sinh 2x - 4x) / (2 kappa cosh 2x + 1 + kappa^2 + 4 x^2) with kappa = 3 - 4 nu.
    """
    kappa, e = 3 - 4 * nu, np.exp(-2 * x)
    top = kappa * (1 - e**2) - 4 * x * e
    settled: Array = top / (kappa * (1 + e**2) + (1 + kappa**2 + 4 * x**2) * e)
    return settled


def _waves(reach: float, h: float) -> tuple[Array, Array]:
    """Return wave numbers k [1/m] and weights that integrate what waves of a reach [m] along a layer h add up to."""
    s, weight = np.polynomial.legendre.leggauss(POINTS)
    edges = np.linspace(0.0, FADED / h, max(4, math.ceil(FADED * reach / h / math.pi)) + 1)
    half = np.diff(edges)[:, None] / 2
    return ((edges[1:] + edges[:-1])[:, None] / 2 + half * s).ravel(), (half * weight).ravel()
