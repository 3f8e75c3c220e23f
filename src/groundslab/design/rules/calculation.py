"""Steps of a calculation that can be followed by hand: a formula, the numbers in it, what comes out, the clause."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from groundslab.design.rules.punching_links.demand import Support

MEGA = 1e6
#: What pushes at a zone, and what pulls at it.
ZONE = "force of the columns on the zone, less that of piles below it"
ZONE_PULLS = "pull of the columns on the zone and push of the piles below it"
#: Forces inside this close to each other, over the force that punches, are the same.
SAME = 1e-9
#: A symbol in a formula, such as v_Rd,c: a comma that belongs to it is followed by no space.
SYMBOL = re.compile(r"[A-Za-z]\w*(?:,\w+)*'?")
#: What formulas call, angles being in radians, and numbers with a name; the rest are symbols.
FUNCTIONS = ("max", "min", "sqrt", "abs", "ceil", "exp", "sin", "tan", "atan")
CONSTANTS = ("pi",)


@dataclass(frozen=True, slots=True)
class Step:
    """One quantity: given, or what a formula makes of others before it.

    Formulas are sums, products by *, quotients, powers by ^ and the FUNCTIONS of numbers, CONSTANTS and symbols.
    """

    words: str
    symbol: str
    value: float
    unit: str = ""
    formula: str = ""
    clause: str = ""


def with_numbers(step: Step, known: Mapping[str, float]) -> str:
    """Return the formula of a step with the values of its symbols in their places, with six digits."""

    def number(match: re.Match[str]) -> str:
        name = match[0]
        if name in FUNCTIONS + CONSTANTS:
            return name
        return f"{known[name]:.6g}" if known[name] >= 0 else f"({known[name]:.6g})"

    return SYMBOL.sub(number, step.formula)


def punching_force(
    what: tuple[Support, bool],
    symbols: tuple[str, str],
    parts: tuple[float, float, float, float],
    V: float,
    clause: str,
) -> Iterator[Step]:
    """Yield what pushes on a perimeter or pulls at it, from above or below, and what relieves it inside.

    It is a column, a pile or a zone, and whether it pulls. The symbols are those of its force and of the one that
    punches, V [N]; parts are its force, other loads, pressure and line force along the plate's edge inside [N]. The
    line force counts where that makes V.
    """
    own_symbol, punching = symbols
    (support, pulls), (force, others, pressure, edge) = what, parts
    way, with_loads, with_ground = (-1.0, "-", "+") if (support == "pile") != pulls else (1.0, "+", "-")
    of_zone = ZONE_PULLS if pulls else ZONE
    yield Step(
        of_zone if support == "zone" else f"{'pull' if pulls else 'force'} of the {support}",
        own_symbol,
        force / MEGA,
        "MN",
    )
    yield Step("other loads inside the perimeter", "N_o", others / MEGA, "MN")
    yield Step("pressure of the ground inside", "N_p", pressure / MEGA, "MN")
    formula = f"{own_symbol} {with_loads} N_o {with_ground} N_p"
    if edge and abs(V - (force + way * (others - pressure - edge))) <= SAME * max(map(abs, parts)):
        yield Step("line force of the ground along the plate's edge inside", "N_e", edge / MEGA, "MN")
        formula += f" {with_ground} N_e"
    yield Step("force that punches", punching, V / MEGA, "MN", formula, clause)
