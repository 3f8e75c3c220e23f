"""Rigid plates on springs, on Pasternak ground and on piles, by statics."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np


def rigid_plate_on_springs(y: float, width: float, force: float, arm: float, k: float) -> float:
    """Return the settlement [m] of a rigid plate on springs k [Pa/m] that only press, y [m] from its edge.

    The force [N/m], per length of the plate, acts arm [m] from that edge, nearer to it than to the other. Within the
    middle third the pressure is linear over the whole width, beyond it is a triangle of length 3 arm whose centroid is
    under the force (statics; the plate on a mat of springs of Code_Aster V6.02.130 is a plate of width 2 m under
    40/3 N/m at 0.5 m). A negative settlement is uplift.
    """
    if not 0 < arm <= width / 2:
        raise ValueError(f"0 < arm <= width / 2 is needed, not {arm} of {width}")
    if arm < width / 3:
        return 2 * force / (3 * arm * k) * (1 - y / (3 * arm))
    return force / (width * k) * (1 + 12 * (width / 2 - arm) * (width / 2 - y) / width**2)


def rigid_plate_by_its_corner(x: float, y: float, P: float, arm_x: float, arm_y: float, k: float) -> float:
    """Return the settlement [m] of a rigid plate on springs k [Pa/m] that only press, x and y [m] from its corner.

    A force P [N] so near to the corner, arm_x and arm_y [m] from it, that contact is a triangle: of legs 4 arm_x and
    4 arm_y, as the centroid of a pyramid is a quarter of its height from each face (statics). A negative settlement is
    uplift.
    """
    p = 3 * P / (8 * arm_x * arm_y)
    return p / k * (1 - x / (4 * arm_x) - y / (4 * arm_y))


def rigid_plate_on_yielding_springs(y: float, force: float, arm: float, k: float, p_max: float) -> float:
    """Return the settlement [m] of a rigid plate on springs k [Pa/m] that only press, up to p_max [Pa].

    The force [N/m] acts arm [m] from the edge that y [m] counts from. The pressure is p_max over a length and falls to
    zero over another, c; equilibrium has c^2 = 24 P (arm - P / 2) with P = force / p_max (statics).
    """
    P = force / p_max
    c = math.sqrt(24 * P * (arm - P / 2))
    yielding = P - c / 2
    if yielding < 0:
        raise ValueError(f"the springs do not yield under {force} N/m, {arm} m from the edge")
    return p_max / k * (1 + (yielding - y) / c)


def rigid_circle_on_springs(s: float, radius: float, P: float, e: float, k: float) -> float:
    """Return the settlement [m] of a rigid circular plate on springs k [Pa/m] that only press, s [m] from its middle.

    A force P [N] acts e [m] from the middle, outside the kern, s towards it. The pressure is linear beyond a chord that
    is found so that its resultant is under the force (statics).
    """
    from scipy.integrate import quad
    from scipy.optimize import brentq

    def resultant(chord: float, power: int) -> float:
        def pressure(angle: float) -> float:
            at = radius * math.cos(angle)
            return (at - chord) * at**power * 2 * (radius * math.sin(angle)) ** 2

        return float(quad(pressure, 0.0, math.acos(chord / radius), epsabs=0.0, epsrel=1e-12)[0])

    chord = brentq(lambda c: resultant(c, 1) / resultant(c, 0) - e, -radius * (1 - 1e-9), radius * (1 - 1e-3))
    return float(P / (k * resultant(chord, 0)) * (s - chord))


def rigid_strip(
    distance: float, width: float, q: float, k0: float, k1: float, margin: float = math.inf, fixed: bool = False
) -> float:
    """Return the settlement [m] of Pasternak ground a distance beyond a rigid strip under the pressure q [Pa].

    The ground beyond takes sqrt(k0 k1) times the strip's settlement on each side, and follows exp(-sqrt(k0/k1) d); if
    it ends after a margin [m] it takes that times tanh, or coth where its end is fixed.
    """
    a = math.sqrt(k0 / k1)
    end = math.tanh(a * margin)
    taken = math.sqrt(k0 * k1) * (1 / end if fixed else end)
    strip = q * width / (k0 * width + 2 * taken)
    if math.isinf(margin):
        return strip * math.exp(-a * distance)
    wave = math.sinh if fixed else math.cosh
    return strip * wave(a * (margin - distance)) / wave(a * margin)


def rigid_circle_on_pasternak(distance: float, radius: float, P: float, k0: float, k1: float) -> float:
    """Return the settlement [m] of Pasternak ground without end a distance beyond a rigid circle under P [N].

    Beyond the circle w = w_e K0(a r) / K0(a R) with a = sqrt(k0 / k1); at its edge the ground beyond takes
    2 pi R k1 w_e a K1(a R) / K0(a R).
    """
    from scipy.special import kv

    a = math.sqrt(k0 / k1)
    taken = 2 * math.pi * radius * k1 * a * kv(1, a * radius) / kv(0, a * radius)
    edge = P / (math.pi * radius**2 * k0 + taken)
    return float(edge * kv(0, a * (radius + distance)) / kv(0, a * radius))


def rigid_cap_on_piles(
    pile: int, P: float, at: Sequence[float], piles: Sequence[Sequence[float]], yielding: Mapping[str, float] = {}
) -> float:
    """Return the force [N] of a pile under a rigid cap with a force P [N] at a place.

    `piles` has x, y [m] and stiffness [N/m] of each; `yielding` the forces [N] of those, counted from 1, that yield.
    Equilibrium of the forces and of their moments about both axes (statics).
    """
    if str(pile) in yielding:
        return yielding[str(pile)]
    K, f = np.zeros((3, 3)), P * np.array([1.0, *at])
    for i, (x, y, stiffness) in enumerate(piles, start=1):
        arms = np.array([1.0, x, y])
        if str(i) in yielding:
            f -= yielding[str(i)] * arms
        else:
            K += stiffness * np.outer(arms, arms)
    x, y, stiffness = piles[pile - 1]
    return float(stiffness * (np.linalg.solve(K, f) @ [1.0, x, y]))
