"""Closed-form solutions of circular plates without ground, under loads on a part of them."""

from __future__ import annotations

import math


def partly_loaded_circular_plate(
    r: float,
    radius: float,
    b: float,
    t: float,
    E: float,
    nu: float,
    factor: float,
    clamped: bool,
    q: float = 0.0,
    ring: float = 0.0,
) -> dict[str, float]:
    """Return settlement [m], radial and tangential moment [N m/m] of a circular Mindlin plate, r [m] from its center.

    It carries the pressure q [Pa] on the concentric disc of radius b [m] and the line load ring [N/m] on its border;
    the plate's edge is clamped or simply supported. The shear force follows from statics alone, Q = S (w' - beta), so
    the rotation beta is the thin plate's slope and the shear adds its own settlement (Timoshenko and Woinowsky-Krieger
    1959, sections 16 to 19).
    """
    if not 0 < b <= radius or r < 0 or r > radius:
        raise ValueError(f"0 < b <= radius and 0 <= r <= radius are needed, not b = {b}, r = {r}, radius = {radius}")
    D, S = E * t**3 / (12 * (1 - nu**2)), factor * E / (2 * (1 + nu)) * t
    h, h_over_r, dh = _loaded(r, b, q, ring)
    at_edge = _loaded(radius, b, q, ring)
    # beta = h / D + A r; A follows from beta = 0 or m_r = 0 at the edge
    A = -at_edge[1] / D if clamped else -(at_edge[2] + nu * at_edge[1]) / (D * (1 + nu))
    bent = (h - at_edge[0]) / D - A * (radius**2 - r**2) / 2
    beyond = max(r, b)
    sheared = (q * b**2 / 2 + ring * b) * math.log(radius / beyond) + q * (b**2 - min(r, b) ** 2) / 4
    return {
        "settlement": bent + sheared / S,
        "moment_r": -D * ((dh + nu * h_over_r) / D + A * (1 + nu)),
        "moment_t": -D * ((h_over_r + nu * dh) / D + A * (1 + nu)),
    }


def _loaded(r: float, b: float, q: float, ring: float) -> tuple[float, float, float]:
    """Return the integral from 0 to r of h [N m], h / r [N] and h' [N], where h = D beta carries the load.

    ((r h)' / r)' = -Q with h = h' = 0 at the center: Q = -q r / 2 within b, Q = -V / r beyond, V = q b^2 / 2 + ring b
    (Timoshenko and Woinowsky-Krieger 1959, section 16).
    """
    if r <= b:
        return q * r**4 / 64, q * r**2 / 16, 3 * q * r**2 / 16
    V, log, grown = q * b**2 / 2 + ring * b, math.log(r / b), r**2 - b**2
    h = (
        q * b**4 / 64
        + q * b**2 / 16 * (grown - b**2 * log)
        + V / 4 * ((r**2 + b**2) * log - grown)
    )  # fmt: skip
    h_over_r = q * b**2 / 16 * (b**2 + 2 * grown) / r**2 + V / 4 * (2 * log - grown / r**2)
    dh = q * b**2 / 4 + V * log - h_over_r
    return h, h_over_r, dh
