"""Closed-form and series solutions that the analytic cases are held against."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from groundslab.verification.analytic_beams import (
    beam_on_springs,
    beam_on_two_supports,
    disk_on_infinite_plate,
    joined_beams,
    lifting_strip_on_pasternak,
    line_on_mindlin_strip,
    load_on_mindlin_plate,
    strip_on_pasternak,
    supported_beam_on_springs,
)
from groundslab.verification.analytic_continuum import (
    flexible_circle,
    flexible_rectangle,
    rigid_circle_on_half_space,
    rigid_circle_on_layer,
    rigid_rectangle_on_half_space,
    stress_below_rectangle,
)
from groundslab.verification.analytic_ground import confined_compression, sinh_mode, wedge
from groundslab.verification.analytic_members import (
    wall_by_aci318,
    wall_by_en1992_2004,
    web_by_aci318,
    web_by_en1992_2004,
    web_by_en1992_2023,
)
from groundslab.verification.analytic_pads import pad_by_aci318, pad_by_en1992_2004, pad_by_en1992_2023
from groundslab.verification.analytic_plates import (
    circle_under_linear_pressure,
    clamped_ellipse,
    clamped_plate,
    rings,
    wood_armer,
)
from groundslab.verification.analytic_rigid import (
    rigid_cap_on_piles,
    rigid_circle_on_pasternak,
    rigid_circle_on_springs,
    rigid_plate_by_its_corner,
    rigid_plate_on_springs,
    rigid_plate_on_yielding_springs,
    rigid_strip,
)
from groundslab.verification.analytic_series import levy_plate, partly_loaded_plate, patch_at_an_edge
from groundslab.verification.analytic_springs import curling_strip, lifting_circular_plate


def navier(
    x: float, y: float, a: float, b: float, t: float, E: float, nu: float, factor: float, q: float, k0: float, k1: float
) -> dict[str, float]:
    """Return settlement [m] and moments [N m/m] of a simply supported Mindlin plate on Pasternak ground.

    Uniform pressure q [Pa] on a x b, x and y from the center. In a mode alpha, beta with l2 = alpha^2 + beta^2 the
    plate answers with D l2^2 / (1 + D l2 / S), the ground with k0 + k1 l2 (Navier's series, with the shear flexibility
    of Mindlin's plate; Timoshenko and Woinowsky-Krieger 1959, section 28).
    """
    D, S = E * t**3 / (12 * (1 - nu**2)), factor * E / (2 * (1 + nu)) * t
    m = np.arange(1, 400, 2)[:, None]
    n = np.arange(1, 400, 2)[None, :]
    alpha, beta = m * math.pi / a, n * math.pi / b
    l2 = alpha**2 + beta**2
    load = 16 * q / (math.pi**2 * m * n)
    bent = 1 + D * l2 / S
    amplitude = load / (D * l2**2 / bent + k0 + k1 * l2)
    shape = np.sin(alpha * (x + a / 2)) * np.sin(beta * (y + b / 2))
    return {
        "settlement": float((amplitude * shape).sum()),
        "moment_x": float((D * (alpha**2 + nu * beta**2) / bent * amplitude * shape).sum()),
        "moment_y": float((D * (beta**2 + nu * alpha**2) / bent * amplitude * shape).sum()),
    }


def plate_on_a_column(
    x: float,
    y: float,
    a: float,
    b: float,
    t: float,
    E: float,
    nu: float,
    factor: float,
    q: float,
    K: float,
    u: float,
    v: float,
    mean: bool = False,
) -> dict[str, float]:
    """Return settlement [m] and the column's force [N] of a simply supported Mindlin plate on an elastic column.

    Uniform pressure q [Pa] on a x b; the column of stiffness K [N/m] stands under the center, x and y count from
    there. Its force is spread evenly over u x v [m] and is K times the settlement of the center, or the mean
    settlement over u x v. Force method with Navier's series for both loads (Timoshenko and Woinowsky-Krieger 1959,
    sections 28 and 29).
    """
    D, S = E * t**3 / (12 * (1 - nu**2)), factor * E / (2 * (1 + nu)) * t
    m = np.arange(1, 2000, 2)[:, None]
    n = np.arange(1, 2000, 2)[None, :]
    alpha, beta = m * math.pi / a, n * math.pi / b
    l2 = alpha**2 + beta**2
    flexibility = 1 / (D * l2**2) + 1 / (S * l2)
    spread = np.sinc(alpha * u / (2 * math.pi)) * np.sinc(beta * v / (2 * math.pi))
    center = (-1.0) ** ((m + n) // 2 - 1)  # sin(m pi / 2) sin(n pi / 2)
    under_q = 16 * q / (math.pi**2 * m * n) * flexibility
    under_1 = 4 / (a * b) * center * spread * flexibility
    felt = center * spread if mean else center
    force = K * float((under_q * felt).sum()) / (1 + K * float((under_1 * felt).sum()))
    shape = np.cos(alpha * x) * np.cos(beta * y) * center
    return {"settlement": float(((under_q - force * under_1) * shape).sum()), "force": force}


def point_load_on_infinite_plate(r: float, P: float, D: float, k: float) -> float:
    """Return the settlement [m] of an infinite thin plate on springs k [Pa/m], a distance r [m] from a force P [N].

    w = -P l^2 / (2 pi D) kei(r / l) with l = (D / k)^(1/4), so that w = P / (8 sqrt(k D)) under the force
    (Timoshenko and Woinowsky-Krieger 1959, section 57).
    """
    from scipy.special import kei

    length = (D / k) ** 0.25
    return float(-P * length**2 / (2 * math.pi * D) * kei(r / length))


def circular_plate(
    r: float, radius: float, t: float, E: float, nu: float, factor: float, q: float, clamped: bool
) -> dict[str, float]:
    """Return settlement [m] and radial moment [N m/m] of a Mindlin plate under uniform pressure, r [m] from its center.

    The thin plate's polynomial (Timoshenko and Woinowsky-Krieger 1959, sections 16 and 17) and the shear's share
    q (R^2 - r^2) / 4 S, which is exact as the shear force q r / 2 is statically determinate.
    """
    D, S = E * t**3 / (12 * (1 - nu**2)), factor * E / (2 * (1 + nu)) * t
    inside = radius**2 - r**2
    outer = radius**2 if clamped else (5 + nu) / (1 + nu) * radius**2
    moment = radius**2 * (1 + nu) if clamped else radius**2 * (3 + nu)
    return {
        "settlement": q * inside * (outer - r**2) / (64 * D) + q * inside / (4 * S),
        "moment": q / 16 * (moment - r**2 * (3 + nu)),
    }


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


def strip_on_two_springs(
    x: float, t: float, E: float, factor: float, q: float, k_left: float, k_right: float
) -> dict[str, float]:
    """Return settlement [m] and moment [N m/m] of an endless Mindlin strip with nu = 0 on springs that change at x = 0.

    Far off w = q / k. In the rest w = a exp(r x), D r^4 - (D k / S) r^2 + k = 0, beta = r w - k w / (S r),
    M = -D r beta and Q = k w / r, with the two roots that die out on each side; w, beta, M and Q are the same at x = 0.
    """
    D, S = E * t**3 / 12, factor * E / 2 * t

    def modes(k: float, side: float) -> tuple[np.ndarray, np.ndarray]:
        root = np.sqrt(np.roots([D, -D * k / S, k]).astype(complex))
        r = -side * root * np.sign(root.real)
        beta = r - k / (S * r)
        return r, np.array([np.ones(2), beta, -D * r * beta, k / r])

    (r_left, left), (r_right, right) = modes(k_left, -1.0), modes(k_right, 1.0)
    step = np.array([q / k_right - q / k_left, 0.0, 0.0, 0.0])
    a = np.linalg.solve(np.hstack([left, -right]), step)
    r, all_of, a, k = (r_left, left, a[:2], k_left) if x < 0 else (r_right, right, a[2:], k_right)
    w, _, M, _ = (all_of @ (a * np.exp(r * x))).real
    return {"settlement": float(q / k + w), "moment": float(M)}


#: Formulas of several quantities, and those of them that a case file may name.
_QUANTITIES: dict[Callable[..., dict[str, float]], tuple[str, ...]] = {
    navier: ("settlement", "moment_x"),
    circular_plate: ("settlement", "moment"),
    partly_loaded_circular_plate: ("settlement", "moment_r", "moment_t"),
    lifting_circular_plate: ("settlement", "moment"),
    plate_on_a_column: ("settlement", "force"),
    curling_strip: ("settlement", "moment across", "moment along"),
    strip_on_two_springs: ("settlement", "moment"),
    beam_on_two_supports: ("moment", "shear"),
    beam_on_springs: ("settlement", "moment"),
    joined_beams: ("settlement", "moment", "force"),
    clamped_plate: ("settlement", "moment"),
    rings: ("settlement", "moment"),
    disk_on_infinite_plate: ("settlement", "moment"),
    load_on_mindlin_plate: ("settlement", "moment", "shear"),
    line_on_mindlin_strip: ("settlement", "moment", "shear"),
    supported_beam_on_springs: ("settlement", "moment"),
    strip_on_pasternak: ("settlement", "moment"),
    lifting_strip_on_pasternak: ("settlement", "moment"),
    circle_under_linear_pressure: ("settlement", "moment"),
    clamped_ellipse: ("settlement", "moment"),
    levy_plate: ("settlement", "moment_x", "moment_y"),
    partly_loaded_plate: ("settlement", "moment_x", "moment_y"),
    patch_at_an_edge: ("settlement", "moment"),
    sinh_mode: ("k0", "k1"),
    pad_by_en1992_2004: ("used", "at the face"),
    pad_by_en1992_2023: ("tau_Ed",),
    pad_by_aci318: ("v_u", "phi v_c"),
    web_by_en1992_2004: ("links", "bars", "used"),
    web_by_en1992_2023: ("links", "bars", "used"),
    web_by_aci318: ("links", "bars", "used"),
    wall_by_en1992_2004: ("borne", "upright", "level"),
    wall_by_aci318: ("borne", "upright", "level"),
    wood_armer: ("bottom_x", "bottom_y", "top_x", "top_y"),
}
_SINGLE = (
    point_load_on_infinite_plate,
    rigid_plate_on_springs,
    rigid_plate_by_its_corner,
    rigid_plate_on_yielding_springs,
    rigid_circle_on_springs,
    rigid_circle_on_pasternak,
    rigid_cap_on_piles,
    rigid_strip,
    flexible_rectangle,
    stress_below_rectangle,
    flexible_circle,
    rigid_rectangle_on_half_space,
    rigid_circle_on_half_space,
    rigid_circle_on_layer,
    confined_compression,
    wedge,
)


def _take(formula: Callable[..., dict[str, float]], quantity: str) -> Callable[..., float]:
    return lambda **arguments: formula(**arguments)[quantity]


#: What a case file may name as `exact`: functions of the row's and the case's arguments, by their name and quantity.
FORMULAS: dict[str, Callable[..., float]] = {formula.__name__.replace("_", " "): formula for formula in _SINGLE} | {
    f"{formula.__name__.replace('_', ' ')} {quantity}": _take(formula, quantity)
    for formula, quantities in _QUANTITIES.items()
    for quantity in quantities
}
