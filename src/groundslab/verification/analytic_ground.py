"""Layers of soil: in one dimension, of varying thickness, and with a given decay over the depth."""

from __future__ import annotations

import math

import numpy as np


def confined_compression(q: float, h: float, E_top: float, E_bottom: float, nu: float) -> float:
    """Return the settlement [m] of a layer under a uniform pressure q [Pa], q times the integral of 1 / Ec."""
    constrained = (1 - nu) / ((1 + nu) * (1 - 2 * nu))
    if E_bottom == E_top:
        return q * h / (constrained * E_top)
    return q * h * math.log(E_bottom / E_top) / (constrained * (E_bottom - E_top))


def wedge(x: float, length: float, q: float, h_left: float, h_right: float, E: float, nu: float) -> float:
    """Return the settlement [m] of a layer whose thickness h grows evenly over a length, x from its middle.

    Under a pressure q [Pa] the settlement falls evenly over the depth, so that k0 = Ec / h and k1 = G h / 3. Then
    Ec w / h - (G h w' / 3)' = q is an Euler-Cauchy equation in h: w = c h + A h^p + B h^-p with c = q / (Ec - G s^2/3),
    s = h' and p^2 = 3 Ec / (G s^2); at both ends the ground is free, w' = 0.
    """
    slope = (h_right - h_left) / length
    Ec, G = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))
    c, p = q / (Ec - G * slope**2 / 3), math.sqrt(3 * Ec / G) / abs(slope)

    def powers(h: float) -> tuple[float, float]:
        return (h / h_right) ** p, (h_left / h) ** p

    slopes = [[p / h * powers(h)[0], -p / h * powers(h)[1]] for h in (h_left, h_right)]
    amplitudes = np.linalg.solve(np.array(slopes), [-c, -c])
    h = (h_left + h_right) / 2 + slope * x
    return float(c * h + amplitudes @ powers(h))


def sinh_mode(gamma: float, h: float, E_top: float, E_bottom: float, nu: float, power: int) -> dict[str, float]:
    """Return k0 [Pa/m] and k1 [Pa m] of a layer whose settlement falls as sinh(gamma (1 - z / h)) / sinh(gamma).

    k0 is the integral of Ec phi'^2 over the depth, k1 that of G phi^2, by adaptive quadrature; the modulus goes from
    E_top to E_bottom with the first or second power of z / h (Vallabhan and Das 1991).
    """
    from scipy.integrate import quad

    constrained, shear = (1 - nu) / ((1 + nu) * (1 - 2 * nu)), 1 / (2 * (1 + nu))

    def E(z: float) -> float:
        return E_top + (E_bottom - E_top) * (z / h) ** power

    def slope(z: float) -> float:
        return gamma / h * math.cosh(gamma * (1 - z / h)) / math.sinh(gamma)

    def mode(z: float) -> float:
        return math.sinh(gamma * (1 - z / h)) / math.sinh(gamma)

    k0 = quad(lambda z: constrained * E(z) * slope(z) ** 2, 0.0, h, epsabs=0.0, epsrel=1e-12)[0]
    k1 = quad(lambda z: shear * E(z) * mode(z) ** 2, 0.0, h, epsabs=0.0, epsrel=1e-12)[0]
    return {"k0": float(k0), "k1": float(k1)}
