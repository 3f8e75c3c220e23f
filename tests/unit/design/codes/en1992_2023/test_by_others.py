"""EN 1992-1-1:2023 as Blueprints 0.8.0 and structuralcodes 0.7.2 compute it, at random.

Their numbers are those of tools/other_programs/en1992_2023.py.
"""

from __future__ import annotations

import json

import numpy as np
import pytest

from groundslab.design.codes.en1992_2023 import cracking, punching, shear
from groundslab.design.codes.en1992_2023.materials import Concrete, Steel
from groundslab.design.codes.eurocode2.cracked_sections import Bars
from helpers.paths import DATA

OTHERS = json.loads((DATA / "en1992_2023_by_others.json").read_text(encoding="utf-8"))
B500 = Steel(500e6)


@pytest.mark.parametrize("row", OTHERS["shear"])
def test_shear_and_punching(row: dict[str, float]) -> None:
    """By Blueprints: 8.20, 8.27, 8.94, 8.96, 8.97, 8.111."""
    d, b_0 = row["d"] / 1e3, 4 * row["c"] / 1e3
    concrete = Concrete(row["f_ck"] * 1e6, gamma_v=row["gamma_V"], d_lower=row["D_lower"] / 1e3)
    k_pb = punching.gradient(b_0, b_0 + np.pi * d)
    a_pd = punching.depth_by_contraflexure(row["a_p"] / 1e3, d)
    found = {
        "tau_min": float(shear.minimum_resistance(concrete, B500, d)) / 1e6,
        "one_way": float(shear.stress_without_links(concrete, B500, d, row["rho_l"])) / 1e6,
        "k_pb": k_pb,
        "a_pd": a_pd * 1e3,
        "punching": punching.resistance_without_links(concrete, k_pb, row["rho_l"], a_pd) / 1e6,
        "eta_sys": punching.system_factor(concrete, b_0, d),
    }
    assert found == pytest.approx({name: row[name] for name in found}, rel=1e-9)


@pytest.mark.parametrize("row", OTHERS["cracks"])
def test_materials_and_cracks(row: dict[str, float]) -> None:
    """By structuralcodes: Table 5.1, 5.1, 5.3, 9.2, 9.8, 9.9, 9.11, 9.15, with h_c,eff of Figure 9.3 and k_w = 1.7."""
    concrete = Concrete(row["f_ck"] * 1e6)
    bars = Bars(row["phi"] / 1e3, row["s"] / 1e3, row["c"] / 1e3)
    h, x, sigma = (np.array([row[name]]) for name in ("h", "x", "sigma_s"))
    h, x = h / 1e3, x / 1e3
    h_c = cracking.effective_depth(h, x, bars)
    rho = cracking.effective_ratio(h_c, bars)
    found = {
        "f_ctm": concrete.f_ctm / 1e6,
        "E_cm": concrete.E_cm / 1e6,
        "f_cd": concrete.f_cd / 1e6,
        "w": cracking.width_of_stress(sigma * 1e6, h, x, bars, (concrete, B500, 0.9))[0] * 1e3,
        "k_r": cracking.curvature_factor(h, x, bars)[0],
        "s_r": cracking.mean_spacing(bars, h, x, rho, (h - h_c) / h, (0.9, 1.7))[0] * 1e3,
        "strain": cracking.mean_strain(sigma * 1e6, rho, concrete, B500)[0],
        "least": cracking.minimum_area(h, concrete, 500e6)[0] * 1e6,
    }
    assert found == pytest.approx({name: row[name] for name in found}, rel=1e-9)
