"""Thin plates by Fourier's series and integrals: two edges simply supported, loads on parts, loads at an edge."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

#: Of an edge y = const: what the derivatives of w over y, by their order, add up to, is zero. nu, a^2, k1 / D given.
Edge = list[list[float]]


def levy_plate(
    x: float,
    y: float,
    a: float,
    b: float,
    q: float,
    D: float,
    nu: float,
    bottom: str,
    top: str,
    k0: float,
    k1: float = 0.0,
) -> dict[str, float]:
    """Return settlement [m] and moments [N m/m] of a thin plate a x b, simply supported at x = +-a/2, under q [Pa].

    The edges y = -b/2 and y = b/2 are "clamped", "hinged" or "free"; x and y count from the middle. The ground k0
    [Pa/m] > 0, k1 [Pa m] ends with the plate. Sines along x; of each D (w'''' - 2 a^2 w'' + a^4 w) + k0 w -
    k1 (w'' - a^2 w) = q_m along y, with four constants (Levy's method; Timoshenko and Woinowsky-Krieger 1959, sections
    41 to 48).
    """
    root = np.sqrt(complex(k1**2 - 4 * D * k0))
    splits = np.array([k1 + root, k1 - root]) / (2 * D)
    w = m_x = m_y = 0.0
    for m in range(1, 200, 2):
        wave = m * math.pi / a
        load = 4 * q / (m * math.pi)
        even = load / (D * wave**4 + k0 + k1 * wave**2)
        r = np.sqrt(wave**2 + splits)

        def waves(n: int, y: float, r: np.ndarray = r) -> np.ndarray:
            return np.concatenate([(-r) ** n * np.exp(-r * (y + b / 2)), r**n * np.exp(r * (y - b / 2))])

        lines, right_side = [], []
        for at, edge in ((-b / 2, bottom), (b / 2, top)):
            for terms in _edge(edge, nu, wave, k1 / D):
                lines.append(sum(factor * waves(n, at) for n, factor in enumerate(terms)))
                right_side.append(-terms[0] * even)
        c = np.linalg.solve(np.array(lines), np.array(right_side, dtype=complex))
        along = math.sin(wave * (x + a / 2))
        value = float((waves(0, y) @ c).real) + even
        bent = float((waves(2, y) @ c).real)
        w += value * along
        m_x += D * (wave**2 * value - nu * bent) * along
        m_y += D * (nu * wave**2 * value - bent) * along
    return {"settlement": w, "moment_x": m_x, "moment_y": m_y}


def _edge(kind: str, nu: float, wave: float, k1_over_D: float) -> Edge:
    """Return the two conditions of an edge as factors of w, w', w'' and w'''."""
    moment, shear = [-nu * wave**2, 0.0, 1.0], [0.0, -(2 - nu) * wave**2 - k1_over_D, 0.0, 1.0]
    return {"clamped": [[1.0], [0.0, 1.0]], "hinged": [[1.0], moment], "free": [moment, shear]}[kind]


def partly_loaded_plate(
    x: float,
    y: float,
    a: float,
    b: float,
    D: float,
    nu: float,
    q: Sequence[float],
    load_x: Sequence[float],
    load_y: Sequence[float],
    k0: float = 0.0,
    k1: float = 0.0,
) -> dict[str, float]:
    """Return settlement [m] and moments [N m/m] of a simply supported thin plate a x b with pressure on a rectangle.

    `q` has the pressure [Pa] at the rectangle's left and right side, linear between; places count from the plate's
    middle. Navier's series, on ground k0 [Pa/m], k1 [Pa m] (Timoshenko and Woinowsky-Krieger 1959, sections 28 to 33).
    """
    m, n = np.arange(1, 801)[:, None], np.arange(1, 801)[None, :]
    alpha, beta = m * math.pi / a, n * math.pi / b
    (x0, x1), (y0, y1) = [side + a / 2 for side in load_x], [side + b / 2 for side in load_y]
    slope = (q[1] - q[0]) / (x1 - x0)
    # integrals of (q + slope (x - x0)) sin(alpha x) and of sin(beta y) over the rectangle
    along_x = (q[0] * np.cos(alpha * x0) - q[1] * np.cos(alpha * x1)) / alpha
    along_x = along_x + slope * (np.sin(alpha * x1) - np.sin(alpha * x0)) / alpha**2
    along_y = (np.cos(beta * y0) - np.cos(beta * y1)) / beta
    l2 = alpha**2 + beta**2
    amplitude = 4 / (a * b) * along_x * along_y / (D * l2**2 + k0 + k1 * l2)
    shape = np.sin(alpha * (x + a / 2)) * np.sin(beta * (y + b / 2))
    return {
        "settlement": float((amplitude * shape).sum()),
        "moment_x": float((D * (alpha**2 + nu * beta**2) * amplitude * shape).sum()),
        "moment_y": float((D * (beta**2 + nu * alpha**2) * amplitude * shape).sum()),
    }


def patch_at_an_edge(x: float, q: float, u: float, v: float, D: float, nu: float, k: float) -> dict[str, float]:
    """Return settlement [m] and moment m_x [N m/m] at the edge of a half-infinite thin plate on springs k [Pa/m].

    A pressure q [Pa] on u along the edge, -u/2 < x < u/2, times v into the plate, 0 < y < v. A cosine integral along
    the edge; of each wave a particular solution under the load and waves that die out, such that the edge is free and
    w to w''' are continuous at y = v (Westergaard 1926 has the case in closed, approximate form).
    """
    length = (D / k) ** 0.25
    s, weight = np.polynomial.legendre.leggauss(20)
    most = 60 * math.pi / min(u, v, length)
    # 200 intervals, shorter ones for long waves
    t = ((np.arange(200)[:, None] + (s + 1) / 2) / 200).ravel()
    alpha, weight = most * t**2, np.tile(weight, 200) / 200 * most * t
    even = 2 * q / math.pi * np.sin(alpha * u / 2) / alpha / (D * alpha**4 + k)
    r = np.sqrt(np.stack([alpha**2 + 1j / length**2, alpha**2 - 1j / length**2], axis=-1))[:, None, :]
    orders = np.arange(4)[:, None]
    falling, rising, back = (-r) ** orders, r**orders, np.exp(-r * v)
    # unknowns of each wave: two that fall from y = 0, two that rise to y = v, two that fall from y = v
    on = np.zeros((len(alpha), 6, 6), dtype=complex)
    edge, a2 = np.concatenate([falling, rising * back], axis=2), alpha[:, None] ** 2
    on[:, 0, :4] = edge[:, 2] - nu * a2 * edge[:, 0]
    on[:, 1, :4] = edge[:, 3] - (2 - nu) * a2 * edge[:, 1]
    on[:, 2:, :2], on[:, 2:, 2:4], on[:, 2:, 4:] = falling * back, rising, -falling
    right_side = np.zeros((len(alpha), 6, 1), dtype=complex)
    right_side[:, 0, 0], right_side[:, 2, 0] = nu * alpha**2 * even, -even
    c = np.linalg.solve(on, right_side)[:, :4, 0]
    value, bent = even + (edge[:, 0] * c).sum(axis=1).real, (edge[:, 2] * c).sum(axis=1).real
    along = weight * np.cos(alpha * x)
    return {"settlement": float(along @ value), "moment": float(along @ (D * (alpha**2 * value - nu * bent)))}
