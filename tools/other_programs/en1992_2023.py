"""Formulas of EN 1992-1-1:2023 by Blueprints and structuralcodes at random; it prints what tests hold ours against.

Needs a Python of its own with blue-prints 0.8.0 and structuralcodes 0.7.2; nothing of groundslab is used:

    python tools/other_programs/en1992_2023.py > tests/data/en1992_2023_by_others.json

Lengths in mm, stresses in MPa. structuralcodes takes k_w as an argument: 1.7.
"""

from __future__ import annotations

import importlib
import json
import math
import random
from typing import Any

from structuralcodes.codes import ec2_2023

PACKAGE = "blueprints.codes.eurocode.fpr_en_1992_1_1_2023.chapter_8_ultimate_limit_states"
COUNT, K_W = 20, 1.7


def blueprints(number: str, name: str) -> Any:
    """Return the class of a formula."""
    return getattr(importlib.import_module(f"{PACKAGE}.formula_{number}"), name)


def shear(draw: random.Random) -> dict[str, float]:
    """Return a section and a column, with what resists."""
    f_ck, lower, d = draw.uniform(12, 90), draw.uniform(8, 40), draw.uniform(120, 1500)
    rho, c, gamma_v = draw.uniform(1e-3, 0.02), draw.uniform(150, 1200), draw.uniform(1.15, 1.5)
    # 8.2.1(4); Blueprints has no object of it
    d_dg = min(40, 16 + lower * (1 if f_ck <= 60 else (60 / f_ck) ** 2))
    b_0, b_05 = 4 * c, 4 * c + math.pi * d
    a_p = draw.uniform(1, 7.9) * d
    least = blueprints("8_20", "Form8Dot20MinimumShearStressResistance")(
        gamma_v=gamma_v, f_ck=f_ck, f_yd=500 / 1.15, d_dg=d_dg, d=d
    )
    one_way = blueprints("8_27", "Form8Dot27DesignShearStressResistance")(
        gamma_v=gamma_v, rho_l=rho, f_ck=f_ck, d_dg=d_dg, d=d, tau_rdc_min=least
    )
    k_pb = blueprints("8_96", "Form8Dot96PunchingShearGradientEnhancementCoefficient")(b_0=b_0, b_0_5=b_05)
    a_pd = blueprints("8_97", "Form8Dot97ReplacementEffectiveDepth")(a_p=a_p, d_v=d)
    punching = blueprints("8_94", "Form8Dot94PunchingShearStressResistance")(
        gamma_v=gamma_v, k_pb=k_pb, rho_l=rho, f_ck=f_ck, d_dg=d_dg, d_v=a_pd
    )
    system = blueprints("8_110_111", "Form8Dot110To111CoefficientForPunchingShearReinforcingSystem")(
        b_0=b_0, d_v=d, is_link_or_stirrup=True
    )
    given = {"f_ck": f_ck, "D_lower": lower, "d": d, "rho_l": rho, "c": c, "gamma_V": gamma_v, "a_p": a_p}
    found = {"tau_min": least, "one_way": one_way, "k_pb": k_pb, "a_pd": a_pd, "punching": punching, "eta_sys": system}
    return given | {name: float(value) for name, value in found.items()}


def cracks(draw: random.Random) -> dict[str, float]:
    """Return a section with bars closer than 10 phi, with materials and the width of its cracks."""
    f_ck, h, phi, cover = draw.uniform(12, 90), draw.uniform(200, 1500), draw.uniform(8, 32), draw.uniform(20, 60)
    spacing, sigma_s = phi * draw.uniform(3, 9.9), draw.uniform(80, 400)
    x, a_y = draw.uniform(0.1, 0.4) * h, cover + phi / 2
    # Figure 9.3; structuralcodes takes it as given
    h_c = min(a_y + 5 * phi, 10 * phi, 3.5 * a_y, h - x, h / 2)
    rho = math.pi * phi**2 / 4 / spacing / h_c
    f_ctm, E_cm = ec2_2023.fctm(f_ck), ec2_2023.Ecm(ec2_2023.fcm(f_ck))
    width, k_r, s_r, strain = ec2_2023.wk_cal(
        K_W, h, h / 2, h_c, cover, 0.9, phi, rho, x, sigma_s, 0.4, f_ctm, 200e3 / E_cm, 200e3
    )
    f_cd = ec2_2023.fcd(f_ck, ec2_2023.eta_cc(f_ck), 0.85, 1.5)
    least, _ = ec2_2023.As_min_y(0, 1e3, h / 1e3, f_ctm, 500)  # of a section 1000 m wide [cm2]
    given = {"f_ck": f_ck, "h": h, "phi": phi, "c": cover, "s": spacing, "sigma_s": sigma_s, "x": x}
    found = {"f_ctm": f_ctm, "E_cm": E_cm, "f_cd": f_cd, "w": width, "k_r": k_r, "s_r": s_r, "strain": strain}
    return given | found | {"least": least / 10}  # mm2/m


if __name__ == "__main__":
    rng = random.Random(1992)
    made = {"shear": [shear(rng) for _ in range(COUNT)], "cracks": [cracks(rng) for _ in range(COUNT)]}
    print(json.dumps(made, indent=1))
