"""Punching of rigid pads under one column inside them by the clauses of three codes, by statics alone.

The pressure below a rigid pad on springs is linear. Nothing here shares code with the design: perimeters are closed
formulas, and what lies inside them has its area and second moment by hand. Stresses in MPa, forces in MN, lengths in m.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

#: The square root of a pound-force per square inch, in MPa^(1/2).
ROOT_PSI = math.sqrt(4.4482216152605 / 25.4**2)


@dataclass(frozen=True, slots=True)
class _Pad:
    """A pad of L_x by L_y [m] and its column of c_x by c_y, or of a diameter c_x, e [m] from the middle along x."""

    L_x: float
    L_y: float
    c_x: float
    c_y: float  # 0 where it is round
    e: float
    P: float  # [MN]

    @property
    def p(self) -> float:
        """Return the pressure under the column's middle [MPa]."""
        return self.P / (self.L_x * self.L_y) * (1 + 12 * self.e**2 / self.L_x**2)

    @property
    def slope(self) -> float:
        """Return by how much the pressure grows along x [MPa/m]."""
        return self.P / (self.L_x * self.L_y) * 12 * self.e / self.L_x**2

    @property
    def perimeter(self) -> float:
        """Return the length around the column [m]."""
        return 2 * (self.c_x + self.c_y) if self.c_y else math.pi * self.c_x

    def area(self, a: float) -> float:
        """Return the area within a of the column [m2], of rounded corners."""
        if not self.c_y:
            return math.pi * (self.c_x / 2 + a) ** 2
        return self.c_x * self.c_y + self.perimeter * a + math.pi * a**2

    def second_moment(self, a: float) -> float:
        """Return that area's second moment about the column's middle, of places along x [m4]."""
        if not self.c_y:
            return math.pi * (self.c_x / 2 + a) ** 4 / 4
        center = self.c_x**3 * (self.c_y + 2 * a) / 12
        sides = 2 * (a**3 * self.c_y / 12 + a * self.c_y * ((self.c_x + a) / 2) ** 2)
        corner = (math.pi / 16 - 4 / (9 * math.pi)) * a**4
        corner += math.pi * a**2 / 4 * (self.c_x / 2 + 4 * a / (3 * math.pi)) ** 2
        return center + sides + 4 * corner

    def W(self, a: float) -> float:
        """Return int |x| dl of the line at a from the column [m2] (EN 1992-1-1 6.40, 6.41)."""
        if not self.c_y:
            return 4 * (self.c_x / 2 + a) ** 2
        return self.c_x**2 / 2 + self.c_x * self.c_y + 2 * self.c_y * a + 4 * a**2 + math.pi * a * self.c_x

    @property
    def room(self) -> float:
        """Return how far the pad reaches beyond the column at least [m]."""
        return min((self.L_x - self.c_x) / 2 - abs(self.e), (self.L_y - (self.c_y or self.c_x)) / 2)


def pad_by_en1992_2004(*, d: float, f_ck: float, rho: float, **pad: float) -> dict[str, float]:
    """Return v_Ed and v_Rd where v_Ed / v_Rd is largest within 2 d, and v_Ed and v_Rd,max at the face [MPa].

    Clauses 6.4.3(3) (6.39, 6.40), 6.4.4(1), (2) (6.47, 6.50, 6.51) and 6.4.5(3), expression 6.53, with recommended
    values; k of Table 6.1 between its values; 6.51 has the moment of all that acts inside the perimeter.
    """
    of = _Pad(**pad)
    ratio = of.c_x / of.c_y if of.c_y else 1.0
    table = ((0.5, 0.45), (1.0, 0.6), (2.0, 0.7), (3.0, 0.8))
    k_M = table[0][1] if ratio <= table[0][0] else table[-1][1]
    for (low, k_low), (high, k_high) in pairwise(table):
        if low <= ratio <= high:
            k_M = k_low + (k_high - k_low) * (ratio - low) / (high - low)
    k = min(2.0, 1 + math.sqrt(0.2 / d))
    v_Rd_c = max(0.18 / 1.5 * k * math.cbrt(100 * rho * f_ck), 0.035 * k**1.5 * math.sqrt(f_ck))

    def stress(a: float, W: float, u: float) -> float:
        V = of.P - of.p * of.area(a)
        M = abs(of.slope * of.second_moment(a))
        return (V + k_M * M * u / W) / (u * d)

    def used(a: float) -> float:
        v_Ed: float = stress(a, of.W(a), of.perimeter + 2 * math.pi * a)
        v_Rd: float = v_Rd_c * 2 * d / a
        return v_Ed / v_Rd

    a = _largest(used, min(2 * d, of.room))
    u = of.perimeter + 2 * math.pi * a
    return {
        "v_Ed": stress(a, of.W(a), u),
        "v_Rd": v_Rd_c * 2 * d / a,
        "used": used(a),
        "at the face": (of.P - of.p * of.area(0.0)) / (of.perimeter * d),
        "v_Rd,max": 0.4 * 0.6 * (1 - f_ck / 250) * f_ck / 1.5,
    }


def pad_by_en1992_2023(*, d: float, f_ck: float, rho: float, a_p: float = math.inf, **pad: float) -> dict[str, float]:
    """Return tau_Ed and tau_Rd [MPa] at d / 2 by EN 1992-1-1:2023 8.4, with d_dg of 32 mm and gamma_V of 1.4.

    Clauses 8.4.2(2), (3), (6) with the pressure within 0.67 d, 8.4.3 (8.94 to 8.98), 8.2.1(4) (formula 8.20), f_yd of
    500 / 1.15. The column's force acts in the perimeter's center, so that beta_e is 1.05. Where moments are zero, a_p,
    is that of an analysis: on the column's axes they change their sign before the edge.
    """
    of = _Pad(**pad)
    straight = sum(2 * min(c, 3 * d) for c in (of.c_x, of.c_y)) if of.c_y else math.pi * of.c_x
    b_05 = straight + math.pi * d
    k_pb = min(2.5, max(1.0, 3.6 * math.sqrt(1 - straight / b_05)))
    a_pd = math.sqrt(max(a_p, d) * d / 8) if a_p < 8 * d else d
    tau_Rd_c = min(0.6 * k_pb * math.cbrt(100 * rho * f_ck * 0.032 / a_pd), 0.5 * math.sqrt(f_ck)) / 1.4
    tau_min = 11 / 1.4 * math.sqrt(f_ck / (500 / 1.15) * 0.032 / d)
    V = of.P - of.p * of.area(0.67 * d)
    tau_Ed, tau_Rd = 1.05 * V / (b_05 * d), max(tau_Rd_c, tau_min)
    return {"tau_Ed": tau_Ed, "tau_Rd": tau_Rd, "used": tau_Ed / tau_Rd}


def pad_by_aci318(*, d: float, f_ck: float, rho: float = 0.0, **pad: float) -> dict[str, float]:
    """Return v_u and phi v_c [MPa] at d / 2 by ACI 318-19 22.6.4.1, 22.6.5.2, 8.4.4.2.2, 8.4.4.2.3, R8.4.4.2.3.

    Of 318-19 and 318M-19 the edition that gives less counts. The ratio of bars does not count.
    """
    del rho
    of = _Pad(**pad)
    b_1, b_2 = of.c_x + d, (of.c_y or of.c_x) + d
    if of.c_y:
        b_o, area, second = 2 * (b_1 + b_2), b_1 * b_2, b_1**3 * b_2 / 12
        J = d * b_1**3 / 6 + b_1 * d**3 / 6 + d * b_2 * b_1**2 / 2
        ratio = max(of.c_x, of.c_y) / min(of.c_x, of.c_y)
    else:
        b_o, area, second, ratio = math.pi * b_1, math.pi * b_1**2 / 4, math.pi * b_1**4 / 64, 1.0
        J = d * math.pi * b_1**3 / 8 + d**3 / 12 * math.pi * b_1 / 2
    V, M = of.P - of.p * area, abs(of.slope * second)
    gamma_v = 1 - 1 / (1 + 2 / 3 * math.sqrt(b_1 / b_2))
    v_u = V / (b_o * d) + gamma_v * M * b_1 / 2 / J
    lambda_s = min(1.0, math.sqrt(2 / (1 + 4 * d)))
    factor = min(0.33, 2 * ROOT_PSI * (1 + 2 / ratio), 0.083 * (2 + 40 * d / b_o))
    v_c = 0.75 * factor * lambda_s * min(8.3, math.sqrt(f_ck))
    return {"v_u": v_u, "phi v_c": v_c, "used": v_u / v_c}


def _largest(function: Callable[[float], float], most: float) -> float:
    """Return where a function is largest from most / 1000 to most."""
    from scipy.optimize import minimize_scalar

    steps = [most * number / 200 for number in range(1, 201)]
    best = max(range(200), key=lambda number: function(steps[number]))
    low, high = steps[max(best - 1, 0)], steps[min(best + 1, 199)]
    optimum = minimize_scalar(lambda a: -function(a), bounds=(low, high), method="bounded", options={"xatol": 1e-9})
    return max((float(optimum.x), high, low), key=function)
