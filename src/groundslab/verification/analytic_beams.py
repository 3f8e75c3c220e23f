"""Beams on springs, and infinite plates on Pasternak ground, in closed form."""

from __future__ import annotations

import cmath

import numpy as np


def beam_on_springs(x: float, length: float, P: float, at: float, EI: float, k: float) -> dict[str, float]:
    """Return settlement [m] and moment [N m] at x of a free beam on springs k [N/m2] under a force P [N].

    Bernoulli's beam of stiffness EI [N m2], x and `at` from its left end. The solution for an infinite beam, and waves
    that die out from both ends, such that there is neither moment nor shear force there (Hetenyi 1946).
    """
    wave = (-1 + 1j) * (k / (4 * EI)) ** 0.25

    def waves(n: int, x: float) -> list[float]:
        left, right = wave**n * cmath.exp(wave * x), (-wave) ** n * cmath.exp(wave * (length - x))
        return [left.real, left.imag, right.real, right.imag]

    def infinite(n: int, x: float) -> float:
        # w = P b / 2 k exp(-b s) (cos b s + sin b s), s = |x - at|
        turned = (-1.0) ** n if x < at else 1.0
        amplitude = P * wave.imag / (2 * k) * (1 - 1j)
        return turned * float((amplitude * wave**n * cmath.exp(wave * abs(x - at))).real)

    ends = [(2, 0.0), (3, 0.0), (2, length), (3, length)]
    c = np.linalg.solve([waves(*end) for end in ends], [-infinite(*end) for end in ends])
    w, bent = (float(np.dot(waves(n, x), c)) + infinite(n, x) for n in (0, 2))
    return {"settlement": w, "moment": -EI * bent}


def disk_on_infinite_plate(r: float, a: float, q: float, D: float, nu: float, k0: float, k1: float) -> dict[str, float]:
    """Return settlement [m] and radial moment [N m/m] of an infinite thin plate on Pasternak ground under a disk.

    A pressure q [Pa] within a radius a [m], at r [m] from its middle. With D s^4 + k1 s^2 + k0 = D (s^2 + y^2)(s^2 +
    z^2) the Hankel integral of J1(a s) J0(r s) over that is one of Bessel functions (Sneddon 1951).
    """
    from scipy.special import iv, kv

    root = cmath.sqrt(complex(k1**2 - 4 * D * k0))
    y, z = (cmath.sqrt((k1 + sign * root) / (2 * D)) for sign in (1, -1))

    def integrals(z: complex) -> tuple[complex, complex, complex]:
        # of J1(a s) J0(r s) / (s^2 + z^2), its slope over r, and its second derivative
        if r >= a:
            outside = iv(1, a * z)
            slope = -outside * kv(1, r * z)
            return outside * kv(0, r * z) / z, slope / r, outside * kv(0, r * z) * z - slope / r
        inside = -kv(1, a * z)
        slope_over_r = inside * z * (iv(1, r * z) / (r * z) if r else 0.5)
        return 1 / (a * z**2) + inside * iv(0, r * z) / z, slope_over_r, inside * z * iv(0, r * z) - slope_over_r

    w, slope_over_r, bent = (
        float((q * a / (D * (z**2 - y**2)) * (one - other)).real)
        for one, other in zip(integrals(y), integrals(z), strict=True)
    )
    return {"settlement": w, "moment": -D * (bent + nu * slope_over_r)}
