"""Webs of beams under shear and torsion, and walls as deep beams, by the clauses of three codes.

Annexes have their recommended values. Nothing here shares code with the design. Forces in MN and MN m, lengths in m,
strengths in MPa; links and bars are in cm2/m and cm2. `a` is the distance of the bars' axes from the faces.
"""

from __future__ import annotations

import math

CM2 = 1e4
#: Partial factors of concrete and steel, and the factor of shear and torsion by ACI 318-19, Table 21.2.1.
GAMMA_C, GAMMA_S, PHI = 1.5, 1.15, 0.75
#: A pound-force per square inch in MPa, and the square root of one.
PSI = 4.4482216152605 / 25.4**2
ROOT_PSI = math.sqrt(PSI)


def web_by_en1992_2004(
    *, b: float, h: float, a: float, V: float, T: float, f_ck: float, f_yk: float
) -> dict[str, float]:
    """Return closed links, bars along the beam, and the share that struts of 45 degrees use of their strength.

    Clauses 6.2.3(3) (6.8, 6.9), 6.3.2(1) to (4) (6.26 to 6.30), 6.2.2(6), 9.2.2(5), with struts as flat as 6.29 and
    cot theta <= 2.5 allow: both terms of 6.29 are those of 45 degrees over sin(2 theta).
    """
    z, f_yd = 0.9 * (h - a), f_yk / GAMMA_S
    nu_f_cd = 0.6 * (1 - f_ck / 250) * f_ck / GAMMA_C
    t, A_k, u_k = _tube(b, h, a)
    used = T / (nu_f_cd * A_k * t) + V / (b * z * nu_f_cd / 2)
    cot = _flattest(used)
    least = 0.08 * math.sqrt(f_ck) / f_yk * b
    return {
        "links": CM2 * max((V / z + T / A_k) / (f_yd * cot), least),
        "bars": CM2 * T * u_k * cot / (2 * A_k * f_yd),
        "used": used,
    }


def web_by_en1992_2023(
    *, b: float, h: float, a: float, V: float, T: float, f_ck: float, f_yk: float, k_tc: float
) -> dict[str, float]:
    """Return closed links, bars along the beam, and the share that struts of 45 degrees use of their strength.

    Clauses 8.2.3 (8.42 to 8.44, nu = 0.5, cot theta <= 2.5), 8.3.3 to 8.3.6 (8.79, 8.82 to 8.86), 5.1.6(1), 12.2(4);
    f_ck up to 40 MPa. Torsion has 45 degrees, shear what torsion leaves of the concrete: sin(2 theta) is the share.
    """
    z, f_yd = 0.9 * (h - a), f_yk / GAMMA_S
    nu_f_cd = 0.5 * k_tc * f_ck / GAMMA_C
    t, A_k, u_k = _tube(b, h, a)
    by_torsion, by_shear = T / (2 * A_k * t) / (nu_f_cd / 2), V / (b * z) / (nu_f_cd / 2)
    cot = _flattest(by_shear / (1 - by_torsion))
    least = 0.08 * math.sqrt(f_ck) / f_yk * b
    return {
        "links": CM2 * max(V / (z * cot * f_yd) + T / (A_k * f_yd), least),
        "bars": CM2 * T * u_k / (2 * A_k * f_yd),
        "used": by_torsion + by_shear,
    }


def web_by_aci318(*, b: float, h: float, a: float, V: float, T: float, f_ck: float, f_yk: float) -> dict[str, float]:
    """Return closed links, bars along the beam, and the share used of the concrete, by ACI 318-19.

    Of 318-19 in psi and 318M-19 what is stricter: 22.5.8.5.3 with V_c = 2 (f'c)^(1/2) b d, 22.7.1.1, 22.7.4.1,
    22.7.6.1, 22.7.7.1, 9.6.4.2 and 9.6.4.3, f'c up to 69 MPa and f_y at most 60,000 psi (20.2.2.4); A_oh ends at the
    bars' axes.
    """
    d, root, f_y = h - a, math.sqrt(f_ck), min(f_yk, 60e3 * PSI)
    A_cp, p_cp = b * h, 2 * (b + h)
    A_oh, p_h = (b - 2 * a) * (h - 2 * a), 2 * (b + h - 4 * a)
    if PHI * 0.083 * root * A_cp**2 / p_cp > T:
        T = 0.0
    A_t = T / (PHI * 2 * 0.85 * A_oh * f_y)
    A_v = max(V / PHI - 2 * ROOT_PSI * root * b * d, 0.0) / (f_y * d)
    least = 0.42 * root * A_cp / f_y - max(A_t, 25 * PSI * b / f_y) * p_h if T else 0.0
    return {
        "links": CM2 * max(A_v + 2 * A_t, max(0.75 * ROOT_PSI * root, 0.35) * b / f_y),
        "bars": CM2 * max(A_t * p_h, least),
        "used": math.hypot(V / (b * d), T * p_h / (1.7 * A_oh**2)) / (PHI * (2 * ROOT_PSI + 0.66) * root),
    }


def wall_by_en1992_2004(*, t: float, h: float, L: float, f_ck: float) -> dict[str, float]:
    """Return the force that struts bear [MN], and the least bars of both faces, of a wall h high and L long.

    6.2.3(3), expression 6.9, at 45 degrees with z = 0.6 of the height that counts; 9.6.2(1), 9.6.3(1) and, of deep
    beams, 9.7(1).
    """
    upright = max(0.002 * t, 2 * max(0.001 * t, 1.5e-4))
    return {
        "borne": t * 0.6 * min(h, L) * 0.6 * (1 - f_ck / 250) * f_ck / GAMMA_C / 2,
        "upright": CM2 * upright,
        "level": CM2 * max(0.25 * upright, 0.001 * t, 2 * max(0.001 * t, 1.5e-4)),
    }


def wall_by_aci318(*, t: float, h: float, L: float, f_ck: float) -> dict[str, float]:
    """Return the largest shear force [MN], and the distributed bars, of a wall h high and L long, by ACI 318M-19.

    9.9.2.1 with d = 0.9 of the height that counts, and 9.9.3.1.
    """
    return {
        "borne": PHI * 0.83 * math.sqrt(f_ck) * t * 0.9 * min(h, L),
        "upright": CM2 * 0.0025 * t,
        "level": CM2 * 0.0025 * t,
    }


def _flattest(share: float) -> float:
    """Return cot theta <= 2.5 of the flattest struts that bear a share of what those of 45 degrees do: sin(2 theta)."""
    return 2.5 if share <= math.sin(2 * math.atan(1 / 2.5)) else 1 / math.tan(math.asin(share) / 2)


def _tube(b: float, h: float, a: float) -> tuple[float, float, float]:
    """Return thickness, area and length of the tube that carries torsion (EN 1992-1-1 6.3.2(1); 2023: 8.3.3)."""
    t = max(b * h / (2 * (b + h)), 2 * a)
    return t, (b - t) * (h - t), 2 * (b - t + h - t)
