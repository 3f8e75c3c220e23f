"""Beams over openings under forces and couples along parts of them: what acts at both ends, and within.

Both ends are taken as fixed. Forces q act downwards; couples m turn the beam about its axis, what lies to its left
down, so that V' = -q, M' = V, T' = m. Each load begins somewhere, grows linearly and goes on to the end of the span;
what ends before is one that begins there and acts against it. With Q_1, Q_2 its first and second integrals along s,

    M = M_0 + V_0 s - Q_2,   V = V_0 - Q_1,   M_0 L + V_0 L^2 / 2 = int Q_2,
    V_0 (L^3 / 12) (1 + phi) = int s Q_2 - L / 2 int Q_2 + (E I / G A_v) int Q_1,   phi = 12 E I / (G A_v L^2),

since neither end turns or settles; integrals are over the span.
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.parts.beams import Beams

#: Of a load on spans: which span, where it begins [m] along it, q [N/m] and its growth [N/m2], m [N] and its growth.
COLUMNS = 6


def from_to(span: int, start: float, end: float, q: tuple[float, float], m: tuple[float, float]) -> Array:
    """Return a load from a way along a span to another [m], q and m being those there, as rows (2, 6)."""
    q_growth, m_growth = ((b - a) / (end - start) for a, b in (q, m))
    return np.array([[span, start, q[0], q_growth, m[0], m_growth], [span, end, -q[1], -q_growth, -m[1], -m_growth]])


def forces_within(beams: Beams, loads: Array, part: Array) -> Array:
    """Return M, T [N m], V and N [N] of spans with fixed ends, (k, p, 4), after parts (p,) of their length.

    loads (l, 6) are those on all spans, see COLUMNS.
    """
    number, L, rigidity = _spans(beams, loads)
    a, q, q_growth, m, m_growth = (column[:, None] for column in loads.T[1:])
    e = rigidity[:, :1] / rigidity[:, 2:3]
    rest = L - a
    of_Q1 = q * rest**2 / 2 + q_growth * rest**3 / 6
    of_Q2 = q * rest**3 / 6 + q_growth * rest**4 / 24
    of_sQ2 = q * rest**4 / 8 + q_growth * rest**5 / 30 + a * of_Q2
    V_0 = (of_sQ2 - L * of_Q2 / 2 + e * of_Q1) / (L**3 / 12 + e * L)
    M_0 = of_Q2 / L - V_0 * L / 2
    s = part * L
    u = np.maximum(s - a, 0.0)
    V = V_0 - q * u - q_growth * u**2 / 2
    M = M_0 + V_0 * s - q * u**2 / 2 - q_growth * u**3 / 6
    T = m * u + m_growth * u**2 / 2 - (m * rest**2 / 2 + m_growth * rest**3 / 6) / L
    forces = np.zeros((np.count_nonzero(beams.spans), len(part), 4))
    np.add.at(forces, number, np.stack([M, T, V, np.zeros_like(M)], axis=-1))
    return forces


def end_forces(beams: Beams, loads: Array) -> tuple[Array, Array, Array]:
    """Return what loads (l, 6) on spans bring to both ends: forces [N] and couples [N m], (k, 2) each.

    The first couples work on the slope along the span, from its start to its end, the others on that to its left.
    """
    M, T, V, _ = np.moveaxis(forces_within(beams, loads, np.array([0.0, 1.0])), 2, 0)
    outwards = np.array([-1.0, 1.0])
    return -outwards * V, outwards * M, outwards * T


def settlements_within(beams: Beams, loads: Array, start: Array, at_start: Array, part: Array) -> Array:
    """Return w of spans (k, p) [m] after parts (p,) of their length.

    start (k, 2) are w and the slope of their sections at the start, at_start (k, 4) M, T, V and N there under the loads
    (l, 6).
    """
    EI, _, GA, _ = (column[:, None] for column in beams.rigidity[beams.spans].T)
    w, beta = (column[:, None] for column in start.T)
    M, V = at_start[:, :1], at_start[:, 2:3]
    s = part * beams.length[beams.spans, None]
    settlement: Array = w + beta * s - (M * s**2 / 2 + V * s**3 / 6) / EI + V * s / GA
    number, L, rigidity = _spans(beams, loads)
    a, q, q_growth = (column[:, None] for column in loads.T[1:4])
    u = np.maximum(part * L - a, 0.0)
    bent = (q * u**4 / 24 + q_growth * u**5 / 120) / rigidity[:, :1]
    np.add.at(settlement, number, bent - (q * u**2 / 2 + q_growth * u**3 / 6) / rigidity[:, 2:3])
    return settlement


def _spans(beams: Beams, loads: Array) -> tuple[Integers, Array, Array]:
    """Return of each load (l, 6) the number of its span (l,), the span's length (l, 1) [m], and rigidities (l, 4)."""
    number = loads[:, 0].astype(np.int64)
    return number, beams.length[beams.spans, None][number], beams.rigidity[beams.spans][number]
