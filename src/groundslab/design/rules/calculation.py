"""Steps of a calculation that can be followed by hand: a formula, the numbers in it, what comes out, the clause."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from groundslab.design.demands.perimeter_loads import MomentParts
from groundslab.design.rules.punching_links.demand import Support
from groundslab.messages import Message

MEGA = 1e6
#: What pushes at a zone, and what pulls at it.
ZONE = "force of the columns on the zone, less that of piles below it"
ZONE_PULLS = "pull of the columns on the zone and push of the piles below it"
#: What the sums inside a perimeter are called.
SUMS = {"N_o": "other loads inside the perimeter", "N_p": "pressure of the ground inside"}
#: Forces inside this close to each other, over the force that punches, are the same.
SAME = 1e-9
#: By how much chords may be shorter than arcs.
BY_CHORDS = 5e-5
#: A symbol in a formula, such as v_Rd,c: a comma that belongs to it is followed by no space.
SYMBOL = re.compile(r"[A-Za-z]\w*(?:,\w+)*'?")
#: What formulas call, angles being in radians, and numbers with a name; the rest are symbols.
FUNCTIONS = ("max", "min", "sqrt", "abs", "ceil", "floor", "exp", "sin", "tan", "atan")
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


def depth_steps(d: float, axes: tuple[float, float], symbol: str = "d", clause: str = "") -> Iterator[Step]:
    """Yield the effective depth d [m] to the mean of the axes of bars along x and along y [m] from their face."""
    a_x, a_y = axes
    yield Step("thickness of the slab", "h", d + (a_x + a_y) / 2, "m")
    yield Step("distance of the axes of bars along x from their face", "a_x", a_x, "m")
    yield Step("distance of the axes of bars along y from their face", "a_y", a_y, "m")
    yield Step("effective depth", symbol, d, "m", "h - (a_x + a_y) / 2", clause)


def from_below(what: tuple[Support, bool]) -> bool:
    """Return whether a column, pile, zone or wall, and whether it pulls, punches upwards, with tension at the top."""
    support, pulls = what
    return (support == "pile") != pulls


def punching_force(
    what: tuple[Support, bool],
    symbols: tuple[str, str],
    parts: tuple[float, float, float, float],
    inside: float,
    V: float,
    clause: str,
    *,
    relieves: bool,
) -> Iterator[Step]:
    """Yield what pushes on a perimeter or pulls at it, from above or below, and what relieves it inside.

    It is a column, a pile or a zone, and whether it pulls. The symbols are those of its force and of the one that
    punches, V [N]; parts are its force, other loads, pressure and line force along the plate's edge inside [N], and
    inside is the area [m2]. The line force counts where it relieves or adds, other supports where they add.
    """
    own_symbol, punching = symbols
    (support, pulls), (force, others, pressure, edge) = what, parts
    way, with_loads, with_ground = (-1.0, "-", "+") if from_below(what) else (1.0, "+", "-")
    of_zone = ZONE_PULLS if pulls else ZONE
    yield Step(
        of_zone if support == "zone" else f"{'pull' if pulls else 'force'} of the {support}",
        own_symbol,
        force / MEGA,
        "MN",
    )
    yield Step("area of the plate inside the perimeter", "A_i", inside, "m2")
    for words, symbol, name, sum_inside in (
        ("other loads inside, over the area", "q_o", "N_o", others),
        ("pressure of the ground inside, its mean", "p_m", "N_p", pressure),
    ):
        yield Step(words, symbol, sum_inside / inside / 1e3, "kPa")
        yield Step(SUMS[name], name, sum_inside / MEGA, "MN", f"{symbol} * A_i / 1000")
    formula, without = f"{own_symbol} {with_loads} N_o {with_ground} N_p", force + way * (others - pressure)
    counted = edge if relieves or way * edge < 0 else 0.0
    if counted:
        yield Step("line force of the ground along the plate's edge inside", "N_e", counted / MEGA, "MN")
        formula += f" {with_ground} N_e"
    adding = V - (without - way * counted)
    if abs(adding) > SAME * max(map(abs, parts)):
        yield Step("force of other supports inside that adds", "N_s", adding / MEGA, "MN")
        formula += " + N_s"
    yield Step("force that punches", punching, V / MEGA, "MN", formula, clause)


def moment_steps(
    n: int, parts: MomentParts, force: tuple[str, float], moment: float, what: tuple[Support, bool], of: str = ""
) -> Iterator[Step]:
    """Yield what the moment [N m] along axis n = 1 or 2 of all forces about a perimeter's center is made of.

    The parts are along the perimeter's axes, the force [N] has a symbol, and `of` ends the symbols of others.
    """
    support, _ = what
    own, away, others, pressure, edge, supports = (float(part[n - 1]) for part in parts)
    with_loads, with_ground = ("-", "+") if from_below(what) else ("+", "-")
    symbol, value = force
    least = SAME * max(abs(value), abs(moment))
    yield Step(Message("moment of the {support} itself along axis {n}", support=support, n=n), f"M_c,{n}", own / MEGA,
               "MNm")  # fmt: skip
    words = Message("center of the {support} from that of what counts of the perimeter, along axis {n}",
                    support=support, n=n)  # fmt: skip
    yield Step(words, f"e_{n}{of}", some(away), "m")
    formula = f"M_c,{n} + {symbol} * e_{n}{of}"
    for words, letter, sign, part, always in (
        (Message("moment of the other loads inside along axis {n}", n=n), "o", with_loads, others, not of),
        (Message("moment of the pressure inside along axis {n}", n=n), "p", with_ground, pressure, not of),
        (Message("moment of the line force inside along axis {n}", n=n), "e", with_ground, edge, False),
        (Message("moment of other supports inside along axis {n}", n=n), "s", "+", supports, False),
    ):
        if always or abs(part) > least:
            yield Step(words, f"M_{letter},{n}{of}", some(part, least) / MEGA, "MNm")
            formula += f" {sign} M_{letter},{n}{of}"
    words = Message("moment of all forces by their places along axis {n}", n=n)
    yield Step(words, f"M_{n}{of}", some(moment, least) / MEGA, "MNm", formula)


def some(value: float, least: float = SAME) -> float:
    """Return a value, or 0 where it is rounding."""
    return value if abs(value) > least else 0.0


def width_steps(widths: tuple[float, float], setbacks: tuple[float, ...], letter: str = "c") -> Iterator[Step]:
    """Yield the widths along axes 1 and 2 of what is loaded [m], and how far it is from edges that count [m]."""
    for n, width in enumerate(widths, 1):
        yield Step(Message("extent of what is loaded along axis {n}", n=n), f"{letter}_{n}", width, "m")
    for n, setback in enumerate(setbacks, 1):
        words = Message("distance of its face from edge {n} of the slab, to which the perimeter runs out", n=n)
        yield Step(words, f"s_{n}", max(setback, 0.0), "m")


def length_by_figures(
    widths: tuple[float, float],
    setbacks: tuple[float, ...],
    at: tuple[str, float],
    whole: float,
    *,
    square: bool = False,
    symbols: tuple[str, str] = ("c_1", "c_2"),
) -> str:
    """Return the formula of a perimeter's length [m] around a rectangle or circle, if one has it.

    It runs all around, out to an edge along axis 1, or out to two edges; `at` is the symbol and size of its distance.
    """
    (first, second), (c_1, c_2), (a, distance) = symbols, widths, at
    s = sum(max(setback, 0.0) for setback in setbacks)
    quarter, by = (2 * distance, 2.0) if square else (math.pi / 2 * distance, 0.0)
    times = {1: "pi / 2", 2: "pi", 4: "2 * pi"}
    around = {n: f"{by * n:g} * {a}" if square else f"{times[n]} * {a}" for n in (1, 2, 4)}
    candidates = {
        0: {
            f"2 * ({first} + {second}) + {around[4]}": 2 * (c_1 + c_2) + 4 * quarter,
            f"pi * ({first} + 2 * {a})": math.pi * (c_1 + 2 * distance),
        },
        1: {f"{first} + 2 * ({second} + s_1) + {around[2]}": c_1 + 2 * (c_2 + s) + 2 * quarter},
        2: {f"{first} + {second} + s_1 + s_2 + {around[1]}": c_1 + c_2 + s + quarter},
    }
    of_these = candidates.get(len(setbacks), {}).items()
    return next((formula for formula, length in of_these if math.isclose(length, whole, rel_tol=BY_CHORDS)), "")


def counted_length(whole: float, formula: str, counted: tuple[str, float], clause: str) -> Iterator[Step]:
    """Yield a perimeter's length on the slab [m] by a formula, what does not count, and what counts by its symbol."""
    symbol, length = counted
    if whole - length <= BY_CHORDS * whole:
        yield Step("length of the perimeter on the slab", symbol, length, "m", formula, clause)
        return
    yield Step("length of the perimeter on the slab", "u_w", whole, "m", formula, clause)
    off = "what does not count: behind openings, of long straight parts, in thinner slab"
    yield Step(off, "u_o", whole - length, "m", clause=clause)
    yield Step("what counts of it", symbol, length, "m", "u_w - u_o", clause)
