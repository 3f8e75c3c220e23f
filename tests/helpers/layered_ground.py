"""Elastic layers in exact arithmetic and in closed forms, with none of the package's own formulas."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from decimal import Decimal, localcontext

import numpy as np

#: E, nu and thickness of a layer; the last one may be a half-space, of infinite thickness.
Layer = tuple[float, float, float]


def settlement(layers: Sequence[Layer], k: float, digits: int = 120) -> float:
    """Return the settlement of the surface under the pressure cos(k x), from one system of equations for all layers.

    Each layer has the solutions U = e, W = s e and U = k z e, W = (s kappa + k z) e with e = exp(-s k z), s = 1 and -1,
    kappa = 3 - 4 nu (plane strain, u = U sin kx, w = W cos kx), as they are, growing ones too: digits make up for that.
    """
    with localcontext() as context:
        context.prec = digits
        k_ = Decimal(k)
        sizes = [2 if math.isinf(layer[2]) else 4 for layer in layers]
        n = sum(sizes)
        A, b = [[Decimal(0)] * n for _ in range(n)], [Decimal(0)] * n
        row = at = 0
        for i, layer in enumerate(layers):
            top = _solutions(layer, k_, Decimal(0))[: sizes[i]]
            for j, state in enumerate(top):
                for r, value in enumerate(state[2:] if i == 0 else state):
                    A[row + r][at + j] = value if i == 0 else -value
            row += 2 if i == 0 else 4
            if sizes[i] == 4:
                for j, state in enumerate(_solutions(layer, k_, Decimal(layer[2]))):
                    for r, value in enumerate(state if i + 1 < len(layers) else state[:2]):
                        A[row + r][at + j] = value
            at += sizes[i]
        b[1] = Decimal(-1)
        x = _solve(A, b)
        return float(sum(a * state[1] for a, state in zip(x, _solutions(layers[0], k_, Decimal(0)), strict=False)))


def _solutions(layer: Layer, k: Decimal, z: Decimal) -> list[tuple[Decimal, ...]]:
    """Return (U, W, tau, sigma) at a depth of the four solutions of a layer; the two that decay are the first."""
    E, nu = Decimal(layer[0]), Decimal(layer[1])
    mu, lame, kappa = E / (2 + 2 * nu), E * nu / ((1 + nu) * (1 - 2 * nu)), 3 - 4 * nu
    found = []
    for s in (1, -1):
        e = (-s * k * z).exp()
        for U, W, dU, dW in (
            (Decimal(1), Decimal(s), -s * k, -k),
            (k * z, kappa + s * k * z, k - s * k * k * z, -s * k * kappa + s * k - k * k * z),
        ):
            tau, sigma = mu * (dU - k * W), (lame + 2 * mu) * dW + lame * k * U
            found.append((U * e, W * e, tau * e, sigma * e))
    return found


def _solve(A: list[list[Decimal]], b: list[Decimal]) -> list[Decimal]:
    """Return x with A x = b by elimination with pivots."""
    rows = [[*row, value] for row, value in zip(A, b, strict=True)]
    n = len(rows)
    for i in range(n):
        best = max(range(i, n), key=lambda r: abs(rows[r][i]))
        rows[i], rows[best] = rows[best], rows[i]
        for r in range(i + 1, n):
            factor = rows[r][i] / rows[i][i]
            if factor:
                rows[r] = [a - factor * c for a, c in zip(rows[r], rows[i], strict=True)]
    x = [Decimal(0)] * n
    for i in reversed(range(n)):
        x[i] = (rows[i][n] - sum(rows[i][j] * x[j] for j in range(i + 1, n))) / rows[i][i]
    return x


def on_rigid_base(E: float, nu: float, h: float, k: float) -> float:
    """Return T(k) of one layer bonded to a rigid base (closed form; derived here, limits h / Ec and half-space)."""
    kappa, x = 3 - 4 * nu, k * h
    top = 2 * kappa * math.sinh(2 * x) - 4 * x
    return 2 * (1 - nu**2) / (E * k) * top / (2 * kappa * math.cosh(2 * x) + 1 + kappa**2 + 4 * x**2)


def burmister(ratio: float, E: float, h: float) -> Callable[[np.ndarray], np.ndarray]:
    """Return T(k) of an incompressible layer of E, h on an incompressible half-space of E / ratio (Burmister 1943).

    From memory; 1 for ratio 1, and a free or a fixed lower surface for ratios without bound, to be tested where used.
    """
    N = (ratio - 1) / (ratio + 1)

    def T(k: np.ndarray) -> np.ndarray:
        e, x = np.exp(-2 * k * h), k * h
        top = 1 + 4 * N * x * e - (N * e) ** 2
        return 1.5 / (E * k) * top / (1 - 2 * N * (1 + 2 * x**2) * e + (N * e) ** 2)

    return T


def by_distance(T: Callable[[np.ndarray], np.ndarray], c: float, h: float) -> Callable[[float], float]:
    """Return r K(r), K the settlement at r by a unit force: (c + int (k T - c) r J0(k r) dk) / 2 pi, by quadrature.

    c is the limit of k T, from which k T differs by exp(-2 k h) times a polynomial.
    """
    from scipy.special import j0

    def at(r: float) -> float:
        edges = np.linspace(0.0, 22 / h, max(8, math.ceil(22 * r / h / 3)))
        s, weight = np.polynomial.legendre.leggauss(24)
        k = ((edges[1:] + edges[:-1])[:, None] + np.diff(edges)[:, None] * s) / 2
        values = (k * T(k) - c) * r * j0(k * r)
        return float((c + (np.diff(edges)[:, None] / 2 * weight * values).sum()) / (2 * math.pi))

    return at


def mean_over_rectangle(rK: Callable[[float], float], a: float, b: float) -> float:
    """Return the mean settlement of a rectangle a x b under a unit force spread over it.

    4 / (a b)^2 int int (a - x)(b - y) K dx dy over it, in polar coordinates about a corner, by Gauss's rule.
    """
    s, weight = np.polynomial.legendre.leggauss(24)
    corner, total = math.atan2(b, a), 0.0
    for low, high in ((0.0, corner), (corner, math.pi / 2)):
        for angle, share in zip((high + low + (high - low) * s) / 2, weight * (high - low) / 2, strict=True):
            c, e = math.cos(angle), math.sin(angle)
            reach = min(a / c, b / e)
            r = reach * (s + 1) / 2
            values = (a - r * c) * (b - r * e) * [rK(float(each)) for each in r]
            total += share * reach / 2 * float(weight @ values)
    return 4 / (a * b) ** 2 * total
