"""Closed-form and series solutions that the analytic cases are held against."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np


def navier(
    x: float, y: float, a: float, b: float, t: float, E: float, nu: float, factor: float, q: float, k0: float, k1: float
) -> dict[str, float]:
    """Return settlement [m] and moments [N m/m] of a simply supported Mindlin plate on Pasternak ground.

    Uniform pressure q [Pa] on a x b, x and y from the centre. In a mode alpha, beta with l2 = alpha^2 + beta^2 the
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
    """Return settlement [m] and radial moment [N m/m] of a Mindlin plate under uniform pressure, r [m] from its centre.

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


def rigid_strip(distance: float, width: float, q: float, k0: float, k1: float) -> float:
    """Return the settlement [m] of Pasternak ground a distance beyond a rigid strip under the pressure q [Pa].

    The strip settles by q b / (k0 b + 2 sqrt(k0 k1)); beyond it the ground follows exp(-sqrt(k0/k1) d).
    """
    strip = q * width / (k0 * width + 2 * math.sqrt(k0 * k1))
    return strip * math.exp(-math.sqrt(k0 / k1) * distance)


def confined_compression(q: float, h: float, E_top: float, E_bottom: float, nu: float) -> float:
    """Return the settlement [m] of a layer under a uniform pressure q [Pa], q times the integral of 1 / Ec."""
    constrained = (1 - nu) / ((1 + nu) * (1 - 2 * nu))
    if E_bottom == E_top:
        return q * h / (constrained * E_top)
    return q * h * math.log(E_bottom / E_top) / (constrained * (E_bottom - E_top))


#: What a case file may name as `exact`: quantity-valued functions of the row's and the case's arguments.
FORMULAS: dict[str, Callable[..., float]] = {
    "navier settlement": lambda **given: navier(**given)["settlement"],
    "navier moment_x": lambda **given: navier(**given)["moment_x"],
    "point load on infinite plate": point_load_on_infinite_plate,
    "circular plate settlement": lambda **given: circular_plate(**given)["settlement"],
    "circular plate moment": lambda **given: circular_plate(**given)["moment"],
    "rigid strip": rigid_strip,
    "confined compression": confined_compression,
}
