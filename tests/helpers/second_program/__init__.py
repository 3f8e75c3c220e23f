"""A second program that follows a design on paper: what it prints, recomputed from what it prints.

It shares no code with groundslab and reads nothing but the table of calculations as JSON (`groundslab tables --json`).
Every number is either an input (INPUTS: of the analysis, of the case), or is computed anew by the clauses, each written
here in its own way: blocks of stress by the equilibrium of forces, perimeters and moduli by points on them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from helpers.second_program.bending import anchorage, bending, cover, cracks, distances, least_for_cracks
from helpers.second_program.limits import limits
from helpers.second_program.materials import ACI, DE, EN, SECOND, Rule
from helpers.second_program.punching import punching, wall_ends
from helpers.second_program.shear import one_way, walls

__all__ = ["ACI", "DE", "EN", "SECOND", "Line", "follow"]

#: What comes out of the analysis: forces, moments, pressures, settlements and sums of them over the plan.
ANALYSIS = {
    "q_x", "q_y", "m_x", "m_y", "m_xy", "m", "N_Ed", "N_u", "p_m", "A_i", "M_c,1", "M_c,2", "e_o,1", "e_o,2", "e_p,1",
    "e_p,2", "p_m,0", "A_i,0", "p_m,l", "A_i,l", "h_i", "h_i,0", "h_i,l", "theta_1", "v_m", "a_p", "v_l", "V", "A_req",
    "beta_s", "beta_e_s",
    "u_l", "u_i", "a_l", "a_i", "w", "w_1", "w_2", "p", "f", "e", "S_xx", "S_yy", "S_xy", "S_xw", "S_yw", "m_a",
    "m_b", "b", "A_l", "N_b",
}  # fmt: skip
#: What the case says: sizes, bars, places and limits.
CASE = {
    "h", "a_x", "a_y", "a_1", "c_1", "c_2", "s_1", "s_2", "phi", "s", "c", "a", "A_x", "A_y", "A_s", "phi_1", "phi_2",
    "x_2", "phi_w", "d_w", "n_w", "a_F", "w_max", "w_max,lim", "c_s", "p_max,lim", "omega_lim", "beta_lim", "x_1",
    "y_1", "y_2", "f_ck", "f_c'", "f_yk", "f_y", "f_y'", "gamma_C", "gamma_S", "gamma_V", "D_lower", "k_tc",
    "b_1", "L_1", "t", "alpha", "c_c", "beta_1", "cot_max", "Delta_c,dev", "c_nom", "beta", "s_r",
} | {
    f"{name}{k}{of}" for name in ("gamma_", "gamma_s,", "F_") for k in range(1, 5) for of in ("", ",0", ",l")
}  # fmt: skip


class Line(NamedTuple):
    """A number on paper, what is computed for it, and where it comes from."""

    check: str
    of: str
    symbol: str
    printed: float
    computed: float | None
    origin: str  # "input", "computed", "sketch", or "" if nobody knows

    @property
    def agrees(self) -> bool:
        """Return whether it is an input, or computed to the printed digits (chords of arcs: to 1 / 5000)."""
        if self.computed is None:
            return bool(self.origin)
        by = 2e-4 if self.symbol in DRAWN else 2e-6
        return math.isclose(self.printed, self.computed, rel_tol=by, abs_tol=1e-9)


#: Lengths, centers and moduli of perimeters, drawn with chords on one side and computed by points on the other; where
#: openings take off a part they are read from the sketch.
DRAWN = {
    "u", "u_w", "u_o", "u_R", "u_0", "b_05", "b_o", "b_w", "b_0", "b_g", "u_r", "u_r_R", "W_1", "W_2", "W_1,R", "W_2,R",
    "e_1", "e_2", "e_1,R", "e_2,R", "x_1", "x_2", "I_1", "I_2", "I_12", "l_1", "l_2", "l_12", "c_1", "c_2", "b_1",
    "b_2", "u_w,l", "u_w,i", "u_o,l", "u_o,i",
}  # fmt: skip


#: The rules of sheets by how their names begin.
SHEETS: dict[str, Callable[[str], dict[str, Rule]]] = {
    "punching at walls": wall_ends,
    "punching": punching,
    "one-way shear": one_way,
    "bending": bending,
    "crack": cracks,
    "stress of the bars": cracks,
    "least bars for cracks": least_for_cracks,
    "anchorage": anchorage,
    "walls": walls,
    "cover": cover,
    "distance": distances,
    "clear distance": distances,
    "bars for shrinkage": distances,
    "settlement": limits,
    "tilt": limits,
    "angular": limits,
    "pressure": limits,
}


def follow(document: Mapping[str, Any], code: str) -> Iterator[Line]:
    """Yield each number of a document of tables with what it should be."""
    (table,) = (each for each in document["tables"] if each["name"] == "calculations")
    columns = {column["name"]: column["values"] for column in table["columns"]}
    sheets: dict[tuple[str, str], list[tuple[str, float]]] = {}
    for check, of, symbol, value in zip(*(columns[name] for name in ("check", "of", "symbol", "value")), strict=True):
        sheets.setdefault((check, of), []).append((symbol, float(value)))
    for (check, of), lines in sheets.items():
        yield from _sheet(check, of, lines, code)


def _sheet(check: str, of: str, lines: list[tuple[str, float]], code: str) -> Iterator[Line]:
    """Yield the numbers of one sheet; of a symbol that comes twice the later one counts from there on."""
    rules = rules_of(check, code)
    known = {"top": float("top" in of), "bent most": float("bent most" in check)}  # the sheet's title
    for symbol, printed in lines:
        rule = rules.get(symbol)
        computed = rule if isinstance(rule, float) else None
        if callable(rule):
            try:
                computed = rule(known)
            except KeyError as error:
                raise AssertionError(f"{check}, {of}: {symbol} needs {error}, which is not on paper") from None
        origin = "computed" if computed is not None else "input" if symbol in ANALYSIS | CASE else ""
        origin = origin or ("sketch" if symbol in DRAWN else "")
        yield Line(check, of, symbol, printed, computed, origin)
        known[symbol] = printed


def rules_of(check: str, code: str) -> dict[str, Rule]:
    """Return how the numbers of a sheet are computed, by their symbols."""
    for begin, rules in SHEETS.items():
        if check.startswith(begin):
            return rules(code)
    return {}
