"""One-way shear, and what punching shares with it."""

from __future__ import annotations

import math

from helpers.second_program.materials import ACI, DE, SECOND, Rule, Values, f_ctm, struts


def without_links(v: Values, code: str, d: str = "d") -> float:
    """Return the stress that needs no links [MPa], of C by the bars and at least by the concrete (6.2 and 6.47)."""
    root = 1 + math.sqrt(0.2 / v[d])
    k, C = min(root, 2.0), 0.15 if code == DE or v.get("C") == 0.15 else 0.18
    least = (0.0525 / v["gamma_C"] if code == DE else 0.035) * k**1.5 * math.sqrt(v["f_ck"])
    return max(C / v["gamma_C"] * k * (100 * v["rho_l"] * v["f_ck"]) ** (1 / 3), least)


def bond_of_cracks(v: Values) -> float:
    """Return tau_Rdc,min [MPa] of the second generation (8.20)."""
    return 11 / v["gamma_V"] * math.sqrt(v["f_ck"] / v["f_yd"] * v["d_dg"] / (1e3 * v.get("d", v.get("d_v", 0.0))))


def one_way(code: str) -> dict[str, Rule]:
    """Return one-way shear: 6.2.2, 8.2.2 or 22.5.5.1, with links by struts where they are needed."""
    force, ratio = ("v_u", "rho_w") if code == ACI else ("v_Ed", "rho_l")
    rules: dict[str, Rule] = {
        force: lambda v: math.hypot(v["q_x"], v["q_y"]),
        "d": lambda v: v["h"] - v["a_x"] / 2 - v["a_y"] / 2,
        "s": lambda v: math.cos(math.atan2(v["q_y"], v["q_x"])) ** 2,
        "m_n": lambda v: _along(v),
        "rho_x": lambda v: v["A_x"] / v["d"] / 1e4,
        "rho_y": lambda v: v["A_y"] / v["d"] / 1e4,
        ratio: lambda v: v["rho_x"] * v["s"] ** 2 + v["rho_y"] * (1 - v["s"]) ** 2,
        "k": lambda v: 1 + math.sqrt(200 / (1e3 * v["d"])),
        "C": 0.15 if code == DE else 0.18,
        "v_min": 0.0525 / 1.5 if code == DE else 0.035,
        "v_Rd,c": lambda v: v["d"] * without_links(v, code),
        "eta": lambda v: v[force] / v["v_Rd,c"],
        "z": lambda v: (
            0.9 * v["d"] if code != DE else min(0.9 * v["d"], max(v["d"] - 2 * v["c"], v["d"] - v["c"] - 0.03))
        ),
        "f_ywd": 500 / 1.15,
        "f_yd": 500 / 1.15,
        "alpha_cc": 0.85 if code == DE else 1.0,
        "nu_f_cd": struts(code),
        "w": lambda v: v["v_Ed"] / (v["z"] * v["nu_f_cd"] * 0.5),
        "v_cc": lambda v: 0.24 * v["f_ck"] ** (1 / 3) * v["z"],
        "cot": _flattest,
        "a_sw": lambda v: 1e4 * v["v_Ed"] / v["z"] / v["f_ywd"] / v["cot"],
        "f_ctm": f_ctm,
        "a_sw,min": lambda v: 1e4 * (0.6 * 0.16 * f_ctm(v) if code == DE else 0.08 * math.sqrt(v["f_ck"])) / v["f_yk"],
    }
    if code == SECOND:
        rules |= {
            "d_dg": lambda v: 16 + v["D_lower"],
            "tau_min": bond_of_cracks,
            "z": lambda v: 0.9 * v["d"],
            "tau_Rd,c": lambda v: max(
                v["tau_min"], 0.66 / v["gamma_V"] * (100 * v["rho_l"] * v["f_ck"] * v["d_dg"] / v["d"] / 1e3) ** (1 / 3)
            ),
            "v_Rd,c": lambda v: v["tau_Rd,c"] * 0.9 * v["d"],
        }
    if code == ACI:
        rules |= concrete_by_aci() | {
            "v_c": lambda v: v["d"] * math.sqrt(v["f_c'"]) * min(0.66 * v["lambda_s"] * v["rho_w"] ** (1 / 3), 0.415),
            "eta": lambda v: v["v_u"] / 0.75 / v["v_c"],
            "f_yt": 413.6,
            "a_v": lambda v: 1e4 * max(v["v_u"] / 0.75 / v["d"] - 0.166 * v["r"], 0.0623 * v["r"], 0.35) / 413.6,
        }
    return rules


def _along(v: Values) -> float:
    """Return the moment along the shear force, by the angle of the force."""
    angle = math.atan2(v["q_y"], v["q_x"])
    c, s = math.cos(angle), math.sin(angle)
    return v["m_x"] * c * c + v["m_y"] * s * s + 2 * v["m_xy"] * c * s


def _flattest(v: Values) -> float:
    """Return cot theta: the flattest of struts that bear the force, v = z nu f_cd / (cot + tan), by bisection."""
    low, high = 1.0, v["cot_max"]
    if v["z"] * v["nu_f_cd"] / (high + 1 / high) >= v["v_Ed"]:
        return high
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if v["z"] * v["nu_f_cd"] / (middle + 1 / middle) > v["v_Ed"] else (low, middle)
    return low


def concrete_by_aci() -> dict[str, Rule]:
    """Return the root of f'c, the size effect and phi of shear by ACI 318-19."""
    return {
        "r": lambda v: min(8.3, v["f_c'"] ** 0.5),
        "phi": 0.75,
        "lambda_s": lambda v: min(1.0, (2 / (1 + 0.004 * 1e3 * v["d"])) ** 0.5),
    }


def walls(code: str) -> dict[str, Rule]:
    """Return what struts of a wall bear."""
    return concrete_by_aci() | {
        "alpha_cc": 0.85 if code == DE else 1.0,
        "nu_f_cd": struts(code),
        "z": lambda v: 0.6 * v["h"],
        "eta_cc": 1.0,
        "f_cd": lambda v: 0.85 * v["f_ck"] / 1.5,
        "d": lambda v: 0.9 * v["h"],
        "V_max": lambda v: (
            0.75 * 0.83 * v["r"] * v["t"] * 0.9 * v["h"] if code == ACI else 0.3 * v["h"] * v["t"] * v["nu_f_cd"]
        ),
        "eta": lambda v: v["V"] / v["V_max"],
    }
