"""Punching at columns and ends of walls."""

from __future__ import annotations

import math

import numpy as np

from helpers.second_program.materials import ACI, DE, SECOND, Rule, Values
from helpers.second_program.perimeters import perimeter
from helpers.second_program.shear import bond_of_cracks, concrete_by_aci, without_links


def forces(code: str) -> dict[str, Rule]:
    """Return what punches, with the moments of all forces about the perimeter's center."""
    N, V = ("N_u", "V_u") if code == ACI else ("N_Ed", "V_Ed")
    depth = "d_v" if code == SECOND else "d"
    rules: dict[str, Rule] = {
        depth: lambda v: v["h"] - (v["a_x"] + v["a_y"]) / 2,
        V: lambda v: v[N] + v["N_o"] - v["N_p"],
    }
    for of in ("", ",0", ",l"):
        rules[f"N_p{of}"] = lambda v, of=of: v[f"p_m{of}"] * v[f"A_i{of}"] * 1e-3
        rules[f"N_o{of}"] = lambda v, of=of: _loads(v, of)
        for k in CASES:
            rules[f"G_{k}{of}"] = lambda v, of=of, k=k: v[f"gamma_s,{k}{of}"] * v[f"h_i{of}"] * v[f"A_i{of}"] * 1e-3
    for n in ("1", "2"):
        rules[f"M_{n}"] = lambda v, n=n: _turns(v, N, n)
        for letter in "op":
            rules[f"M_{letter},{n}"] = lambda v, n=n, of=letter: v[f"N_{of}"] * v[f"e_{of},{n}"]
    return rules


#: Numbers of the load cases that are told apart inside a perimeter.
CASES = range(1, 5)


def _loads(v: Values, of: str) -> float:
    """Return the loads inside a perimeter: each case's weight of the slab and further loads, with its factor."""
    parts = [v[f"gamma_{k}{of}"] * (v.get(f"G_{k}{of}", 0.0) + v.get(f"F_{k}{of}", 0.0)) for k in CASES
             if f"gamma_{k}{of}" in v]  # fmt: skip
    return sum(parts) + v.get(f"N_f{of}", 0.0) + v.get(f"N_b{of}", 0.0)


def _turns(v: Values, N: str, n: str) -> float:
    """Return the moment of all forces inside along an axis."""
    own = v[f"M_c,{n}"] + v[N] * v[f"e_{n}"]
    return own + v.get(f"M_o,{n}", 0.0) - v.get(f"M_p,{n}", 0.0)


def table_6_1(ratio: float) -> float:
    """Return k of Table 6.1, straight between its columns."""
    return float(np.interp(ratio, (0.5, 1.0, 2.0, 3.0), (0.45, 0.60, 0.70, 0.80)))


def punching(code: str) -> dict[str, Rule]:
    """Return the sheet of a column by EN 1992-1-1 6.4, with its German annex."""
    if code == ACI:
        return punching_by_aci()
    if code == SECOND:
        return punching_of_2023()
    rules = forces(code)
    for n, (first, second) in {"1": "12", "2": "21"}.items():
        position = int(n) - 1
        for of in ("", ",R"):
            rules[f"k_{n}{of}"] = lambda v, f=first, s=second: table_6_1(v[f"c_{f}"] / v[f"c_{s}"])
            at = "a" if not of else "a_R"
            rules[f"W_{n}{of}"] = perimeter("W", lambda each, i=position: each.W[i], at)
            rules[f"c_r{of}"] = lambda v: max(v["c_1"], v["c_2"]) / (2 * min(v["c_1"], v["c_2"]))
            rules[f"k_e{of}"] = lambda v, r=f"c_r{of}": table_6_1(v[r])
        rules[f"M_{n},R"] = lambda v, n=n: v[f"M_c,{n}"] + v["N_Ed"] * v[f"e_{n},R"]
    rules |= {
        "u": lambda v: v["u_w"] - v["u_o"] if "u_w" in v else perimeter("u", lambda each: each.u)(v),
        "beta_min": 1.1,
        "beta_g": by_moments,
        "beta_e": lambda v: along_edge(v) if "s" in v else 1.5,
        "s_R": lambda v: v["u_r_R"] / v["u_R"],
        "beta_g,R": at_face,
        "beta_e,R": lambda v: face_along_edge(v) if "s_R" in v else 1.5,
        "beta": lambda v: beta(v, code),
        "beta_c": lambda v: 1.5 if "s_2" in v else 1.4 if "s_1" in v else 1.1 if code == DE else 1.15,
        "a_R": lambda v: 2 * v["d"],
        "v_Ed": lambda v: v["beta"] * v["V_Ed"] / v["u"] / v["d"],
        "f_cd": lambda v: 0.85 * v["f_ck"] / v["gamma_C"],
        "f_yd": 500 / 1.15,
        "rho_max": min(0.02, 0.5 * 17 / (500 / 1.15)) if code == DE else 0.02,
        "rho_l": lambda v: min(v["rho_max"], math.sqrt(v["A_x"] * v["A_y"]) / v["d"] / 1e4),
        "k": lambda v: min(2.0, 1 + math.sqrt(0.2 / v["d"])),
        "C": 0.15 if code == DE else 0.18,
        "v_min": 0.0525 / 1.5 if code == DE else 0.035,
        "v_Rd,c": lambda v: without_links(v, code),
        "v_Rd": lambda v: v["v_Rd,c"] / (v["a"] / (2 * v["d"])),
        "eta": lambda v: v["v_Ed"] / v["v_Rd"],
        "v_Rd,m": lambda v: (1.4 if code == DE else 1.5) * v["v_Rd"],
        "eta_m": lambda v: v["v_Ed"] / v["v_Rd,m"],
        "f_ywd": 500 / 1.15,
        "f_ywd,ef": lambda v: min(250 + 250 * v["d"], v["f_ywd"]),
        "A_sw": lambda v: _links(v, code),
        "n_s": _rows,
        "s_r": lambda v: None if "n_w" in v else _apart(code) * v["d"],
        "a_F": lambda v: None if "n_w" in v else 0.3 * v["d"],
        "u_out": lambda v: v["v_l"] * v["u_l"] / v["v_Rd,c"],
        "g": lambda v: (v["u_l"] - v["u_i"]) / (v["a_l"] - v["a_i"]),
        "a_out": lambda v: v["a_l"] + max(0.0, v["u_out"] - v["u_l"]) / v["g"],
        "a_L": lambda v: v["a_out"] - 1.5 * v["d"],
        "n_L": lambda v: max(2.0, 1.0 + math.ceil((v["a_L"] - v["a_F"]) / v["s_r"])),
        "v_Rd,cs": lambda v: (
            (0.0 if code == DE else 0.75 * v["v_Rd"])
            + v.get("n_s", 1.0) * v["A_sw"] / 1e4 * v["f_ywd,ef"] / v["u"] / v["d"]
        ),
        "eta_s": lambda v: v["v_Ed"] / v["v_Rd,cs"],
        "V_Ed,0": lambda v: v["N_Ed"] + v["N_o,0"] - v["N_p,0"],
        "u_0": _face,
        "alpha_cc": 1.0,
        "beta_0": lambda v: max(v["beta_g,R"], v["beta_e,R"]) if "beta_g,R" in v else at_face(v),
        "v_Ed,0": lambda v: v["beta_0"] * v["V_Ed,0"] / v["u_0"] / v["d"],
        "v_Rd,max": lambda v: 0.4 * 0.6 * (1 - v["f_ck"] / 250) * v["f_ck"] / v["gamma_C"],
        "eta_0": lambda v: v["v_Ed,0"] / v["v_Rd,max"],
    }
    return rules


def beta(v: Values, code: str) -> float:
    """Return beta by 6.39 and 6.51, in Germany 1.1 at least; at a corner without moments 1.5; of two the larger."""
    least = 1.1 if code == DE else 1.0
    if "beta_g" in v:
        return max(least, v["beta_g"], v["beta_e"])
    if "M_1" not in v:
        return 1.5
    return max(least, by_moments(v) if "M_2" in v else along_edge(v))


def by_moments(v: Values) -> float:
    """Return beta by 6.39 and 6.51."""
    x, y = (v[f"k_{n}"] * v[f"M_{n}"] / v["V_Ed"] * v["u"] / v[f"W_{n}"] for n in (1, 2))
    return 1 + math.sqrt(x * x + y * y)


def at_face(v: Values) -> float:
    """Return the same of the column's own force and moments on the outermost perimeter."""
    return 1 + math.hypot(*(v[f"k_{n},R"] * v[f"M_{n},R"] * v["u_R"] / v["N_Ed"] / v[f"W_{n},R"] for n in (1, 2)))


def face_along_edge(v: Values) -> float:
    """Return beta by 6.44 of them."""
    return 1 / v["s_R"] + v["k_e,R"] * abs(v["M_1,R"]) * v["u_R"] / (v["N_Ed"] * v["W_1,R"])


def along_edge(v: Values) -> float:
    """Return beta by 6.44."""
    return 1 / v["s"] + v["k_e"] * abs(v["M_1"]) * v["u"] / (v["V_Ed"] * v["W_1"])


def _apart(code: str) -> float:
    """Return the radial distance of links over d: 0.75, in foundations by the German annex 0.5."""
    return 0.5 if code == DE else 0.75


def _links(v: Values, code: str) -> float:
    """Return the area of the links that are given [cm2], or that are needed by 6.52; in Germany links carry all."""
    if "n_w" in v:
        return v["n_w"] * math.pi * (50 * v["phi_w"]) ** 2
    left = v["v_Ed"] - (0.0 if code == DE else 0.75 * v["v_Rd"])
    return 1e4 * left * v["u"] * v["d"] / v["f_ywd,ef"] / v.get("n_s", 1.0)


def _rows(v: Values) -> float:
    """Return how many perimeters of links cross the cone up to a, at most 1.5 d / s_r (6.52)."""
    rows = 0
    while v["a_F"] + rows * v["s_r"] <= v["a"] + 1e-6 * v["s_r"]:
        rows += 1
    return min(1.5 * v["d"] / v["s_r"], max(rows, 1))


def _face(v: Values) -> float | None:
    """Return u_0 by 6.4.5(3); None beside openings, as the sketch shows, and of round columns pi times the diameter."""
    if "u_o" in v:
        return None
    c_1, c_2, d = v["c_1"], v["c_2"], v["d"]
    if "s_2" in v:
        return v["s_1"] + v["s_2"] + min(3 * d, v["w_1"] + v["w_2"])
    if "s_1" in v:
        return c_1 + 2 * v["s_1"] + min(3 * d, 2 * c_2)
    return math.pi * c_1 if math.isclose(v["u"], math.pi * (c_1 + 2 * v["a"]), rel_tol=1e-4) else 2 * (c_1 + c_2)


def punching_of_2023() -> dict[str, Rule]:
    """Return the sheet of a column, or the end of a wall, by EN 1992-1-1:2023 8.4."""
    rules = forces(SECOND)
    for n in ("1", "2"):
        rules[f"e_b,{n}"] = lambda v, n=n: v[f"x_{n}"] + v[f"M_c,{n}"] / v["N_Ed"]
    return rules | {
        "a": lambda v: v["d_v"] / 2,
        "e_b": _eccentricity,
        "beta_e": lambda v: max(1.05, 1 + 1.1 * v["e_b"] / math.sqrt(v["b_1"] * v["b_2"])) if "e_b" in v else 1.4,
        "V_l": lambda v: v["N_Ed"] + v["N_o,l"] - v["N_p,l"],
        "tau_Ed": lambda v: v["beta_e"] * v.get("V_l", v["V_Ed"]) / v["b_05"] / v["d_v"],
        "d_dg": lambda v: min(40.0, 16 + v["D_lower"]),
        "f_yd": 500 / 1.15,
        "tau_min": bond_of_cracks,
        "k_pb": lambda v: max(1.0, min(2.5, 3.6 * math.sqrt(1 - v["b_0"] / v.get("b_g", v["b_05"])))),
        "rho_l": lambda v: min(0.02, math.sqrt(v["A_x"] * v["A_y"]) / v["d_v"] / 1e4),
        "a_pd": lambda v: math.sqrt(v["a_p"] / 8 * v["d_v"]) if "a_p" in v else v["d_v"],
        "tau_Rd,c": lambda v: min(
            0.6 / v["gamma_V"] * v["k_pb"] * (100 * v["rho_l"] * v["f_ck"] * v["d_dg"] / v["a_pd"] / 1e3) ** (1 / 3),
            0.5 / v["gamma_V"] * math.sqrt(v["f_ck"]),
        ),
        "eta": lambda v: v["tau_Ed"] / max(v["tau_Rd,c"], v["tau_min"]),
        "eta_c": lambda v: min(1.0, v["tau_Rd,c"] / v["tau_Ed"]),
        "f_ywd": 500 / 1.15,
        "A_sw": lambda v: v["n_w"] * math.pi * (v["phi_w"] / 20) ** 2,
        "eta_s": lambda v: min(
            0.8,
            v["d_v"] * 1e3 / 150 / v["phi_w"]
            + math.sqrt(15 * v["d_dg"] / 1e3 / v["d_v"]) / (v["eta_c"] * v["k_pb"]) ** 1.5,
        ),
        "rho_w": lambda v: v["A_sw"] / 1e4 / v["s_r"] / v["b_05"],
        "tau_cs": lambda v: max(
            v["rho_w"] * v["f_ywd"], v["eta_c"] * v["tau_Rd,c"] + v["eta_s"] * v["rho_w"] * v["f_ywd"]
        ),
        "eta_sys": lambda v: max(1.0, 0.5 + 0.63 * (v["b_0"] / v["d_v"]) ** 0.25),
        "tau_max": lambda v: v["eta_sys"] * v["tau_Rd,c"],
        "eta_l": lambda v: v["tau_Ed"] / min(v["tau_cs"], v["tau_max"]),
    }


def _eccentricity(v: Values) -> float:
    """Return e_b (Table 8.3): inside by Pythagoras, at an edge half of that across, at a corner 0.27 of both."""
    along, across = abs(v["e_b,1"]), abs(v["e_b,2"])
    return 0.27 * (along + across) if "s_2" in v else along + across / 2 if "s_1" in v else math.hypot(along, across)


def punching_by_aci() -> dict[str, Rule]:
    """Return the sheet of a column by ACI 318-19 22.6 and 8.4.4.2."""
    rules = forces(ACI) | concrete_by_aci()
    for n, (first, second) in {"1": "12", "2": "21"}.items():
        rules[f"gamma_v{n}"] = lambda v, f=first, s=second: 1 - 1 / (1 + 2 / 3 * (v[f"b_{f}"] / v[f"b_{s}"]) ** 0.5)
        rules[f"J_{n}"] = lambda v, n=n: v["d"] ** 3 * v[f"l_{n}"] / 12 + v["d"] * v[f"I_{n}"]
    return rules | {
        "a": lambda v: v["d"] / 2,
        "J_12": lambda v: round(v["d"] * v["I_12"] + v["d"] ** 3 * v["l_12"] / 12, 9) + 0.0,
        "b_o": lambda v: v["u_w"] - v["u_o"] if "u_w" in v else None,
        "v_u": lambda v: (
            v["V_u"] / v["b_o"] / v["d"]
            + sum(v[f"gamma_v{n}"] * v[f"M_{n}"] * v[f"c_{n}"] / v[f"J_{n}"] for n in (1, 2))
        ),
        "alpha_s": lambda v: 20.0 if "s_2" in v else 30.0 if "s_1" in v else 40.0,
        "v_c": lambda v: _two_way(v, 0.33) * v["lambda_s"] * v["r"],
        "eta": lambda v: v["v_u"] / 0.75 / v["v_c"],
        "v_max": lambda v: 0.498 * v["r"],
        "eta_m": lambda v: v["v_u"] / 0.75 / v["v_max"],
        "v_cs": lambda v: 0.166 * v["lambda_s"] * v["r"],
        "f_yt": 413.6,
        "A_vs": lambda v: 1e4 * (v["v_u"] / 0.75 - v["v_cs"]) * v["b_o"] / v["f_yt"],
        "s": lambda v: None if "d_w" in v else v["d"] / 2,
        "A_v": lambda v: v["n_w"] * math.pi * (50 * v["d_w"]) ** 2 if "d_w" in v else v["A_vs"] * v["s"],
        "v_s": lambda v: v["A_v"] / 1e4 * v["f_yt"] / v["s"] / v["b_o"],
        "v_n": lambda v: min(v["v_max"], v["v_cs"] + v["v_s"]),
        "eta_s": lambda v: v["v_u"] / 0.75 / v["v_n"],
    }


def _two_way(v: Values, most: float) -> float:
    """Return the factor of Table 22.6.5.2."""
    return min(most, 0.166 + 0.332 / v["beta"], 0.166 + 0.083 * v["alpha_s"] * v["d"] / v["b_o"])


def wall_ends(code: str) -> dict[str, Rule]:
    """Return the sheet of the end of a wall: DIN EN 1992-1-1/NA Figures NA.6.12.1 and NA.6.21.1."""
    d, u = ("d_v", "b_05") if code == SECOND else ("d", "b_o" if code == ACI else "u")
    V = "V_u" if code == ACI else "V_Ed"
    whole = {"u": "u_w", "b_05": "b_w", "b_o": "b_w"}[u]
    rules = punching(code) | {
        "b_e": lambda v: min(v["b_1"], 2.8 * v[d]),
        "l_1": lambda v: _side(v, d),
        u: lambda v: None if whole in v else v["b_e"] + 2 * v["l_1"] + math.pi * v["a"],
        whole: lambda v: v["b_e"] + 2 * v["l_1"] + math.pi * v["a"],
        "alpha": math.pi,
        V: lambda v: v["v_m"] * v.get(whole, v.get(u, 0.0)) / 1e3,
        "beta_e": 1.4 if code == SECOND else 1.35,
        "v_u": lambda v: v["beta_e"] * v["V_u"] / v["b_o"] / v["d"],
        "alpha_s": 30.0,
        "beta": 1.35,
        "tau_Ed": lambda v: v["beta_e"] * v["V_Ed"] / v["b_05"] / v["d_v"],
    }
    if code == ACI:  # of the rectangle around what counts
        rules["beta"] = lambda v: max(v["l_1"], v["b_1"]) / min(v["l_1"], v["b_1"])
    return rules


def _side(v: Values, d: str) -> float:
    """Return a_1 / 2: half of the wall's length, of twice its thickness, of 5.6 d - b_1, whichever is least."""
    return min(v["L_1"] / 2, v["b_1"], 2.8 * v[d] - min(v["b_1"], 2.8 * v[d]) / 2)
