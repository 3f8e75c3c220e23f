"""Beams over openings under forces and couples that grow linearly along them: what acts at both ends, and within.

Both ends are taken as fixed. Forces q act downwards; couples m turn the beam about its axis, what lies to its left
down, so that V' = -q, M' = V, T' = m. With q = q_0 + a (2 s / L - 1) and phi = 12 E I / (G A_v L^2):

    V(0) = q_0 L / 2 - a L (1/5 + phi/6) / (1 + phi),   M(0) = -q_0 L^2 / 12 - (V(0) - q_0 L / 2) L / 2 - a L^2 / 12.
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.parts.beams import Beams


def forces_within(beams: Beams, loads: Array, part: Array) -> Array:
    """Return M, T [N m], V and N [N] of spans with fixed ends, (k, p, 4), after parts (p,) of their length.

    loads (k, 4) are q [N/m] at start and end of each, and m [N] there.
    """
    some = beams.spans
    L, rigidity = beams.length[some, None], beams.rigidity[some]
    q_0, m_0 = (loads[:, k : k + 2].mean(axis=1)[:, None] for k in (0, 2))
    a, b = ((loads[:, k + 1] - loads[:, k])[:, None] / 2 for k in (0, 2))
    phi = 12 * rigidity[:, :1] / (rigidity[:, 2:3] * L**2)
    V_a = -a * L * (1 / 5 + phi / 6) / (1 + phi)
    M_a = -V_a * L / 2 - a * L**2 / 12
    x = part[None]
    V = q_0 * L * (0.5 - x) + V_a - a * L * (x**2 - x)
    M = q_0 * L**2 * (-1 / 12 + x / 2 - x**2 / 2) + M_a + V_a * L * x - a * L**2 * (x**3 / 3 - x**2 / 2)
    T = m_0 * L * (x - 0.5) + b * L * (x**2 - x + 1 / 6)
    return np.stack([M, T, V, np.zeros_like(M)], axis=-1)


def end_forces(beams: Beams, loads: Array) -> tuple[Array, Array, Array]:
    """Return what loads (k, 4) of spans bring to both ends: forces [N] and couples [N m], (k, 2) each.

    The first couples work on the slope along the span, from its start to its end, the others on that to its left.
    """
    M, T, V, _ = np.moveaxis(forces_within(beams, loads, np.array([0.0, 1.0])), 2, 0)
    outwards = np.array([-1.0, 1.0])
    return -outwards * V, outwards * M, outwards * T


def settlements_within(beams: Beams, loads: Array, start: Array, at_start: Array, part: Array) -> Array:
    """Return w of spans (k, p) [m] after parts (p,) of their length.

    start (k, 2) are w and the slope of their sections at the start, at_start (k, 4) M, T, V and N there under the loads
    (k, 4).
    """
    some = beams.spans
    L = beams.length[some, None]
    EI, _, GA, _ = (each[:, None] for each in beams.rigidity[some].T)
    w, beta = (each[:, None] for each in start.T)
    M, V = at_start[:, :1], at_start[:, 2:3]
    q, growth = loads[:, :1], (loads[:, 1:2] - loads[:, :1]) / L
    x = part[None] * L
    bent = -M * x**2 / 2 - V * x**3 / 6 + q * x**4 / 24 + growth * x**5 / 120
    sheared = V * x - q * x**2 / 2 - growth * x**3 / 6
    found: Array = w + beta * x + bent / EI + sheared / GA
    return found
