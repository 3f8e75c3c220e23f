"""Bars that moments need, cracks, and where bars end and lie."""

from __future__ import annotations

import math

from helpers.second_program.materials import ACI, DE, EN, SECOND, E_cm, Rule, Values, f_ctm


def block(v: Values, f_c: float) -> float:
    """Return how deep a block of stress f_c [MPa] is [m] whose force at its lever arm makes the moment."""
    return v["d"] - math.sqrt(v["d"] ** 2 - 2 * v["m"] / f_c)


def bending(code: str) -> dict[str, Rule]:
    """Return the bars that a moment needs: forces in equilibrium; least areas by 9.2.1.1, 12.2(2) and 24.4.3.2."""
    strength: dict[str, Rule] = {
        "f_cd": lambda v: v["k_tc"] * min(1.0, (40 / v["f_ck"]) ** (1 / 3)) * v["f_ck"] / v["gamma_C"],
        "f_c": lambda v: v["alpha_cc"] * v["f_ck"] / v["gamma_C"],
        "f_y": lambda v: v["f_yk"] / v["gamma_S"],
        "alpha_cc": 0.85 if code == DE else 1.0,
        "eta": 1.0,
    }
    if code == SECOND:  # the parabola up to 0.002 of 0.0035: its force and its place give the block's stress
        share, center = 1 - 4 / 21, (0.5 - 4 / 21 + (4 / 7) ** 2 / 12) / (1 - 4 / 21)
        strength |= {"f_c": lambda v: share / (2 * center) * v["f_cd"], "eta_cc": 1.0, "r": 4 / 7}
    if code == ACI:
        strength = {"phi": 0.9, "f_c": lambda v: 0.9 * 0.85 * v["f_c'"], "f_y": lambda v: 0.9 * v["f_y'"]}
    least = {
        ACI: lambda v: 18 * v["h"],
    }.get(code, lambda v: 1e4 * f_ctm(v) * v["h"] ** 2 / 6 / (0.9 * v["d"] * v["f_yk"]))
    if code == EN:
        least = lambda v: 1e4 * max(0.26 * f_ctm(v) / v["f_yk"], 0.0013) * v["d"]  # noqa: E731
    return strength | {
        "d": lambda v: v["h"] - v["a_1"],
        "mu": lambda v: v["m"] / (v["d"] ** 2 * v["f_c"]),
        "omega": lambda v: block(v, v["f_c"]) / v["d"],
        "A_s": lambda v: 1e4 * block(v, v["f_c"]) * v["f_c"] / v["f_y"],
        "f_ctm": f_ctm,
        "A_min": least,
        "A_req": lambda v: max(v["A_s"], v["A_min"]),
        "m": design_moment,
        "m_c": lambda v: abs(v["m_xy"]) + (-v["m_b"] if v["top"] else v["m_b"]),
        "m_t": lambda v: (design_moment(v) or 0.0) + (v["m_a"] if v["top"] else -v["m_a"]),
        "eta_A": lambda v: v["A_req"] / v["A_l"],
    }


def design_moment(v: Values) -> float | None:
    """Return Wood's moment, as much as it twists in the direction of the bars; None of a mean, which is given."""
    if "m_a" not in v:
        return None
    a, b = (-v[name] if v["top"] else v[name] for name in ("m_a", "m_b"))
    # strips across that would need a negative area leave all of the twist to those along
    return a + (v["m_xy"] ** 2 / -b if b < -abs(v["m_xy"]) else abs(v["m_xy"]))


def neutral_axis(v: Values) -> float:
    """Return the depth of the cracked section's neutral axis [m], where areas times distances balance, by bisection."""
    low, high = 0.0, v["d"]
    for _ in range(60):
        x = (low + high) / 2
        low, high = (x, high) if x**2 / 2 < v["E_s"] / v["E_cm"] * v["A_s"] * (v["d"] - x) else (low, x)
    return (low + high) / 2


def cracks(code: str) -> dict[str, Rule]:
    """Return the stress of bars and the width of cracks by 7.3.4, its German annex, or the later 9.2.3."""
    axis = (lambda v: v["h"] - v["a_y"]) if code == SECOND else (lambda v: v["h"] - v["c"] - v["phi"] / 2)
    rules: dict[str, Rule] = {
        "E_s": 2e5,
        "E_cm": E_cm(code),
        "alpha_e": lambda v: v["E_s"] / v["E_cm"],
        "d": axis,
        "a_y": lambda v: v["c"] + v["phi"] / 2,
        "x": neutral_axis,
        "sigma_s": lambda v: v["m"] / v["A_s"] / (v["d"] - v["x"] / 3),
        "sigma_max": lambda v: 0.8 * v["f_yk"],
        "f_ctm": f_ctm({}),
        "k_t": 0.4,
        "eps": lambda v: strain(v, 0.6),
        "k_1": 0.8,
        "k_2": 0.5,
        "k_3": 0.0 if code == DE else 3.4,
        "k_4": 1 / (3.6 * 0.8 * 0.5) if code == DE else 0.425,
        "k_h": 0.05,
        "h_c,ef": lambda v: depth_by_germany(v["h"], v["h"] - v["d"]),
        "rho": lambda v: v["A_s"] / tension(v, code),
        "s_r": lambda v: crack_distance(v, code),
        "w_k": lambda v: 1e3 * v["s_r"] * v["eps"],
        "eta": lambda v: v["w_k"] / v["w_max"] if "w_max" in v else v["sigma_s"] / v["sigma_max"],
    }
    if code == SECOND:
        rules |= {
            "h_c": lambda v: min(v["a_y"] + 5 * v["phi"], 10 * v["phi"], 3.5 * v["a_y"], v["h"] - v["x"], v["h"] / 2),
            "rho": lambda v: v["A_s"] / v["h_c"] / min(1.0, 10 * v["phi"] / v["s"]),
            "k_fl": lambda v: 1 - v["h_c"] / v["h"],
            "k_b": lambda v: 1.2 if v["top"] and v["h"] > 0.3 else 0.9,
            "k_w": 1.7,
            "s_r": lambda v: min(
                1.5 * v["c"] + v["k_fl"] * v["k_b"] * v["phi"] / (7.2 * v["rho"]), 1.3 / 1.7 * (v["h"] - v["x"])
            ),
            "k_r": lambda v: (v["h"] - v["x"]) / (v["d"] - v["x"]),
            "w_k,cal": lambda v: 1e3 * 1.7 * v["k_r"] * v["s_r"] * v["eps"],
            "eta": lambda v: v["w_k,cal"] / v["w_max"] if "w_max" in v else v["sigma_s"] / v["sigma_max"],
        }
    return rules


def strain(v: Values, least: float) -> float:
    """Return eps_sm - eps_cm (7.9): what concrete between the cracks takes off, at least a share of sigma_s."""
    taken = 0.4 * v["f_ctm"] * (1 / v["rho"] + v["E_s"] / v["E_cm"])
    return max(v["sigma_s"] - taken, least * v["sigma_s"]) / v["E_s"]


def depth_by_germany(h: float, d_1: float) -> float:
    """Return h_c,ef in bending (Figure 7.1DE d): 2.5 d_1, and 0.05 h + 2 d_1 from h = 10 d_1 to 60 d_1."""
    return 2.5 * d_1 if h <= 10 * d_1 else min(0.05 * h + 2 * d_1, 5 * d_1)


def tension(v: Values, code: str) -> float:
    """Return the depth of the concrete that is in tension around the bars [m] (7.3.2(3))."""
    own = v["h_c,ef"] if code == DE else 2.5 * (v["h"] - v["d"])
    return min(own, (v["h"] - v["x"]) / 3, v["h"] / 2)


def crack_distance(v: Values, code: str) -> float | None:
    """Return s_r,max [m] by 7.11, by 7.14 where bars are too far apart, and in Germany at most by the bars' stress."""
    if "s_r" in v:
        return min(v["s_r"], v["sigma_s"] * v["phi"] / (3.6 * v["f_ctm"]))
    if v["s"] > 5 * (v["c"] + v["phi"] / 2):
        return 1.3 * (v["h"] - v["x"])
    if code == DE:
        return v["phi"] / 3.6 / v["rho"]
    return 3.4 * v["c"] + 0.425 * 0.8 * 0.5 * v["phi"] / v["rho"]


def least_for_cracks(code: str) -> dict[str, Rule]:
    """Return A_s,min of 7.1 for bending, and of 9.2 of the second generation."""
    strength = 3.0 if code == DE else f_ctm({})
    if code == SECOND:
        return {
            "k_h": lambda v: min(0.8, max(0.5, 0.98 - 0.6 * v["h"])),
            "f_ctm": strength,
            "A_min": lambda v: 1e4 * 0.2 * v["k_h"] * strength * v["h"] / v["f_yk"],
            "eta": _least,
        }
    return {
        "k": lambda v: max(0.65, min(1.0, 1.21 - 0.7 * v["h"])),
        "f_ct": strength,
        "A_min": lambda v: 1e4 * 0.4 * v["k"] * strength * v["h"] / 2 / v["f_yk"],
        "eta": _least,
    }


def _least(v: Values) -> float:
    return v["A_min"] / v["A_s"]


def anchorage(_: str) -> dict[str, Rule]:
    """Return how much of bars is developed where they are needed."""
    rules: dict[str, Rule] = {
        f"A_{n}": lambda v, n=n: 1e4 * math.pi * v[f"phi_{n}"] ** 2 / 4 / v[f"s_{n}"] for n in (1, 2)
    }
    return rules | {"A_d": lambda v: v["A_1"], "eta": lambda v: v["A_req"] / v["A_d"]}


def cover(code: str) -> dict[str, Rule]:
    """Return the cover of bars against what bond and durability ask for; none is given but that of bond here."""
    return {
        "c": lambda v: v["a"] - v["phi"] / 2,
        "c_min,b": lambda v: v["phi"],
        "c_min": lambda v: max(v["phi"], 10.0),
        "c_nom": lambda v: None if code == ACI else v["c_min"] + v["Delta_c,dev"],
        "eta": lambda v: v["c_nom"] / v["c"],
    }


def distances(code: str) -> dict[str, Rule]:
    """Return clear and largest distances of bars."""
    most = {
        ACI: lambda v: min(2 * v["h"], 450.0) if "h" in v else min(380 - 2500 * v["c_c"], 300.0) * 280 / v["f_s"],
        DE: lambda v: min(250.0, max(150.0, v["h"])),
        SECOND: lambda v: min(3 * v["h"], 400.0),
        EN: lambda v: min(2 * v["h"], 250.0) if v["bent most"] else min(3 * v["h"], 400.0),
    }
    return {
        "s_c": lambda v: v["s"] - v["phi"],
        "s_min": lambda v: max(v["phi"], 25.0 if code == ACI else 20.0),
        "s_max": most[code],
        "f_s": lambda v: 2 / 3 * v["f_y"],
        "A_min": lambda v: 18 * v["h"],
        "eta": lambda v: (
            v["A_min"] / v["A_s"] if "A_min" in v else (v["s_min"] / v["s_c"] if "s_c" in v else v["s"] / v["s_max"])
        ),
    }
