"""Beams and strips on springs and on Pasternak ground, and infinite plates on it, in closed form."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

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


def joined_beams(x: float, P: float, a: float, EI: float, k: float, s: float = math.inf) -> dict[str, float]:
    """Return settlement [m], moment [N m] at x and the force [N] of a joint at x = 0 between two beams on springs.

    Two semi-infinite Bernoulli beams of stiffness EI [N m2] on springs k [N/m2], a force P [N] at x = -a. The joint
    hands on V = s (w_left - w_right) [N] without a moment; a hinge has s = inf. With b = (k / 4 EI)^(1/4) a force F at
    the end settles a semi-infinite beam by 2 F b / k exp(-b x) cos(b x), and its moment is -F / b exp(-b x) sin(b x)
    (Hetenyi 1946). By reciprocity P alone settles the end by 2 P b / k D, D = exp(-b a) cos(b a), so that

        V / s = 2 b / k (P D - 2 V),   V = P D / (2 + k / (2 b s)).

    The left beam follows from one under P with a free end, so long that its other end is not felt, less V at its end.
    """
    b = (k / (4 * EI)) ** 0.25
    V = P * math.exp(-b * a) * math.cos(b * a) / (2 + k / (2 * b * s))
    far = 20 / b
    beam = beam_on_springs(-x, far, P, a, EI, k) if x < 0 else {"settlement": 0.0, "moment": 0.0}
    sign = -1.0 if x < 0 else 1.0
    wave = math.exp(-b * abs(x))
    return {
        "settlement": beam["settlement"] + sign * 2 * V * b / k * wave * math.cos(b * x),
        "moment": beam["moment"] - sign * V / b * wave * math.sin(b * abs(x)),
        "force": V,
    }


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


def supported_beam_on_springs(
    x: float, length: float, EI: float, k: float, q: float, P: float = 0.0
) -> dict[str, float]:
    """Return settlement [m] and moment [N m] at x of a beam on springs k [N/m2] that is simply supported at both ends.

    Bernoulli's beam under q [N/m] and a force P [N] in its middle, x from its left end: a sine series (Hetenyi 1946).
    """
    n = np.arange(1, 4000, 2)
    wave = n * math.pi / length
    load = 4 * q / (n * math.pi) + 2 * P / length * np.sin(n * math.pi / 2)
    amplitude = load / (EI * wave**4 + k) * np.sin(wave * x)
    return {"settlement": float(amplitude.sum()), "moment": float((EI * wave**2 * amplitude).sum())}


def strip_on_pasternak(
    x: float, length: float, P: float, EI: float, k0: float, k1: float, beyond: bool
) -> dict[str, float]:
    """Return settlement [m] and moment [N m/m] of a free strip on Pasternak ground under a line load in its middle.

    A thin strip of stiffness EI [N m] under P [N/m], x from its middle. EI w'''' - k1 w'' + k0 w = 0 on each half; at
    the end there is no moment, and -EI w''' + k1 w' is what ground that goes on takes, -sqrt(k0 k1) w, or nothing
    (Hetenyi 1946, with the shear of the ground).
    """
    taken = math.sqrt(k0 * k1) if beyond else 0.0
    end = [(EI, 2), (-EI, 3, k1, 1, taken, 0)]
    return _half_strip(abs(x), length / 2, P, EI, k0, k1, end)


def lifting_strip_on_pasternak(x: float, P: float, EI: float, k0: float, k1: float) -> dict[str, float]:
    """Return settlement [m], moment [N m/m] and half the contact length [m] of a strip lifting from Pasternak ground.

    A long thin strip without weight under a line load P [N/m] at x = 0. Where it has lifted it is straight and free of
    forces: w'' = w''' = 0 at the end of contact, where the ground goes on with its slope, w' = -sqrt(k0 / k1) w, as
    exp(-sqrt(k0 / k1) s). Contact ends where all three hold (Weitsman 1970 has the strip on springs).
    """
    from scipy.optimize import brentq

    end = [(EI, 2), (EI, 3)]

    def misfit(c: float) -> float:
        edge = _half_strip(c, c, P, EI, k0, k1, end)
        return edge["slope"] + math.sqrt(k0 / k1) * edge["settlement"]

    length = (4 * EI / k0) ** 0.25
    c = float(brentq(misfit, 0.2 * length, math.pi / 2 * length, xtol=1e-12))
    x = abs(x)
    if x <= c:
        return {**_half_strip(x, c, P, EI, k0, k1, end), "contact": c}
    edge = _half_strip(c, c, P, EI, k0, k1, end)
    return {"settlement": edge["settlement"] + edge["slope"] * (x - c), "moment": 0.0, "contact": c}


def _half_strip(
    x: float, c: float, P: float, EI: float, k0: float, k1: float, end: Sequence[Sequence[float]]
) -> dict[str, float]:
    """Return settlement, slope and moment at 0 <= x <= c, half of P at x = 0; `end` has factors, derivatives at c."""
    root = cmath.sqrt(complex(k1**2 - 4 * EI * k0))
    r = [sign * cmath.sqrt((k1 + other * root) / (2 * EI)) for sign in (1, -1) for other in (1, -1)]

    def waves(n: int, x: float) -> np.ndarray:
        # those that grow with x are of size 1 at c
        return np.array([root**n * cmath.exp(root * (x - c if root.real > 0 else x)) for root in r])

    lines = [waves(1, 0.0), EI * waves(3, 0.0)]
    for terms in end:
        pairs = zip(terms[::2], terms[1::2], strict=True)
        lines.append(np.sum([factor * waves(int(n), c) for factor, n in pairs], axis=0))
    a = np.linalg.solve(np.array(lines), [0.0, P / 2, 0.0, 0.0])
    w, slope, bent = (float((waves(n, x) @ a).real) for n in range(3))
    return {"settlement": w, "slope": slope, "moment": -EI * bent}
