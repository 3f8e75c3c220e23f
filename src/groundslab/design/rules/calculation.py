"""Steps of a calculation that can be followed by hand: a formula, the numbers in it, what comes out, the clause."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from groundslab.arrays import Array
from groundslab.design.demands.loads.building_loads import BUILDING
from groundslab.design.demands.perimeter_loads import CaseInside, MomentParts
from groundslab.design.demands.perimeter_pieces import WeightedLegs
from groundslab.messages import Message, Name

MEGA = 1e6
#: What punches a slab.
Support = Literal["column", "pile", "zone", "wall end"]
#: What pushes at a zone, and what pulls at it.
ZONE = "force of the columns on the zone, less that of piles below it"
ZONE_PULLS = "pull of the columns on the zone and push of the piles below it"
#: So many load cases are told apart inside a perimeter, those that have most there.
MOST_CASES = 4
#: Forces inside this close to each other, over the force that punches, are the same.
SAME = 1e-9
#: By how much chords may be shorter than arcs.
BY_CHORDS = 5e-5
#: A symbol in a formula, such as v_Rd,c: a comma that belongs to it is followed by no space.
SYMBOL = re.compile(r"[A-Za-z]\w*(?:,\w+)*'?")
#: What is negative in a sum or a difference, but is raised to no power.
_NEGATIVE = re.compile(r"([+-]) \(-([\d.]+(?:e[+-]?\d+)?)\)(?!\^)")
#: What formulas call, angles being in radians, and numbers with a name; the rest are symbols.
FUNCTIONS = ("max", "min", "sqrt", "abs", "ceil", "floor", "exp", "log10", "sin", "cos", "tan", "atan")
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


def with_numbers(step: Step, values: Mapping[str, float]) -> str:
    """Return the formula of a step with the values of its symbols in their places, with six digits.

    A sum with what is negative is written as a difference.
    """

    def number(match: re.Match[str]) -> str:
        name = match[0]
        if name in FUNCTIONS + CONSTANTS:
            return name
        return f"{values[name]:.6g}" if values[name] >= 0 else f"({values[name]:.6g})"

    def turned(match: re.Match[str]) -> str:
        return f"{'-' if match[1] == '+' else '+'} {match[2]}"

    return _NEGATIVE.sub(turned, SYMBOL.sub(number, step.formula))


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


def inside_steps(sums: tuple[float, float], inside: float, cases: Sequence[CaseInside], of: str = "") -> Iterator[Step]:
    """Yield what acts on an area [m2]: other loads by their cases, and the ground's pressure, both [N].

    `of` is what ends the symbols.
    """
    others, pressure = sums
    yield Step("area of the plate inside", f"A_i{of}", inside, "m2")
    yield from _loads_inside(others, inside, cases, of)
    words = "pressure of the ground inside, its mean by integration over the area"
    yield Step(words, f"p_m{of}", pressure / inside / 1e3, "kPa")
    yield Step("pressure of the ground inside", f"N_p{of}", pressure / MEGA, "MN", f"p_m{of} * A_i{of} / 1000")


def _loads_inside(others: float, inside: float, cases: Sequence[CaseInside], of: str) -> Iterator[Step]:
    """Yield what other loads inside are made of: of each case the weight of the slab, further loads, and its factor."""
    of_cases = [case for case in cases if case.case != BUILDING]
    largest = sorted(of_cases, key=lambda case: -abs(case.factor * case.force))[:MOST_CASES]
    told = [case for case in of_cases if case in largest]
    terms = []
    for k, (name, factor, force, unit_weight, volume) in enumerate(told, 1):
        case = Name(name) if name else "all loads"
        weight, parts = unit_weight * volume, []
        if weight:
            yield Step("thickness of the slab inside, its mean", f"h_i{of}", volume / inside, "m")
            of_weight, gamma = Message("unit weight of the slab in {case}", case=case), f"gamma_s,{k}{of}"
            yield Step(of_weight, gamma, unit_weight / 1e3, "kN/m3")
            inside_it = Message("weight of the slab inside, in {case}", case=case)
            yield Step(inside_it, f"G_{k}{of}", weight / MEGA, "MN", f"{gamma} * h_i{of} * A_i{of} / 1000")
            parts.append(f"G_{k}{of}")
        if abs(force - weight) > SAME * max(abs(force), abs(weight)):
            further = Message("further loads of {case} inside, by their places", case=case)
            yield Step(further, f"F_{k}{of}", (force - weight) / MEGA, "MN")
            parts.append(f"F_{k}{of}")
        yield Step(Message("factor of {case}", case=case), f"gamma_{k}{of}", factor)
        terms.append(f"gamma_{k}{of} * {parts[0]}" if len(parts) == 1 else f"gamma_{k}{of} * ({' + '.join(parts)})")
    above = next((case.force for case in cases if case.case == BUILDING), 0.0)
    if above:
        yield Step("what the building above puts on the slab inside", f"N_b{of}", above / MEGA, "MN")
        terms.append(f"N_b{of}")
    rest = others - above - sum(case.factor * case.force for case in told)
    if abs(rest) > SAME * max(abs(others), abs(above), *(abs(case.factor * case.force) for case in told), 1.0):
        others_there = "further cases, beams across the perimeter and joints inside, with their factors"
        yield Step(others_there, f"N_f{of}", rest / MEGA, "MN")
        terms.append(f"N_f{of}")
    yield Step("other loads inside the perimeter", f"N_o{of}", others / MEGA, "MN", " + ".join(terms))


def punching_force(
    what: tuple[Support, bool],
    symbols: tuple[str, str],
    parts: tuple[float, float, float, float],
    inside: tuple[float, Sequence[CaseInside]],
    V: float,
    clause: str,
    *,
    relieves: bool,
) -> Iterator[Step]:
    """Yield what pushes on a perimeter or pulls at it, from above or below, and what relieves it inside.

    It is a column, a pile or a zone, and whether it pulls. The symbols are those of its force and of the one that
    punches, V [N]; parts are its force, other loads, pressure and line force along the plate's edge inside [N], and
    inside is the area [m2], with what load cases have there. The line force counts where it relieves or adds, other
    supports where they add.
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
    yield from inside_steps((others, pressure), *inside)
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
    n: int,
    parts: MomentParts,
    force: tuple[str, float],
    moment: float,
    what: tuple[Support, bool],
    of: str = "",
    sums: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> Iterator[Step]:
    """Yield what the moment [N m] along axis n = 1 or 2 of all forces about a perimeter's center is made of.

    The parts are along the perimeter's axes, the force [N] has a symbol, and `of` ends the symbols of others. Sums are
    those of other loads, pressure and line force inside [N], where the sheet has them as N_o, N_p and N_e.
    """
    support, _ = what
    M_c, away, others, pressure, edge, supports = (float(part[n - 1]) for part in parts)
    with_loads, with_ground = ("-", "+") if from_below(what) else ("+", "-")
    symbol, value = force
    least = SAME * max(abs(value), abs(moment))
    yield Step(Message("moment of the {support} itself along axis {n}", support=support, n=n), f"M_c,{n}", M_c / MEGA,
               "MNm")  # fmt: skip
    words = Message("center of the {support} from that of what counts of the perimeter, along axis {n}",
                    support=support, n=n)  # fmt: skip
    yield Step(words, f"e_{n}{of}", some(away), "m")
    formula = f"M_c,{n} + {symbol} * e_{n}{of}"
    of_loads, of_ground, of_edge = sums
    for letter, sign, part, total in (
        ("o", with_loads, others, of_loads),
        ("p", with_ground, pressure, of_ground),
        ("e", with_ground, edge, of_edge),
        ("s", "+", supports, 0.0),
    ):
        if abs(part) > least:
            yield from _part_of_moment(n, (letter, of), part, total, least)
            formula += f" {sign} M_{letter},{n}{of}"
    words = Message("moment of all forces by their places along axis {n}", n=n)
    yield Step(words, f"M_{n}{of}", some(moment, least) / MEGA, "MNm", formula)


def _part_of_moment(n: int, symbols: tuple[str, str], part: float, total: float, least: float) -> Iterator[Step]:
    """Yield what a sum inside [N] adds to the moment along axis n [N m], by its resultant's place if it has one."""
    letter, of = symbols
    moments = {
        "o": Message("moment of the other loads inside along axis {n}", n=n),
        "p": Message("moment of the pressure inside along axis {n}", n=n),
        "e": Message("moment of the line force inside along axis {n}", n=n),
        "s": Message("moment of other supports inside along axis {n}", n=n),
    }
    resultants = {
        "o": Message("resultant of the other loads inside from that center, by integration, along axis {n}", n=n),
        "p": Message("resultant of the pressure inside from that center, by integration, along axis {n}", n=n),
        "e": Message("resultant of the line force inside from that center, by integration, along axis {n}", n=n),
    }
    formula = ""
    if abs(total) > least:
        yield Step(resultants[letter], f"e_{letter},{n}{of}", part / total, "m")
        formula = f"N_{letter} * e_{letter},{n}{of}"
    yield Step(moments[letter], f"M_{letter},{n}{of}", part / MEGA, "MNm", formula)


def axis_step(axes: Array) -> Step:
    """Return the direction of axis 1 of unit vectors (2, 2) in plan."""
    angle = math.degrees(math.atan2(axes[0, 1], axes[0, 0]))
    return Step("angle of axis 1 from x, counterclockwise", "theta_1", some(angle, 1e-6), "degrees")


def some(value: float, least: float = SAME) -> float:
    """Return a value, or 0 where it is rounding."""
    return value if abs(value) > least else 0.0


def width_steps(
    widths: tuple[float, ...],
    setbacks: tuple[float, ...],
    letter: str = "c",
    formulas: tuple[str, str] = ("", ""),
) -> Iterator[Step]:
    """Yield the widths along axes 1 and 2 of what is loaded [m], and how far it is from edges that count [m]."""
    for n, width in enumerate(widths, 1):
        words = Message("extent of what is loaded along axis {n}", n=n)
        yield Step(words, f"{letter}_{n}", width, "m", formulas[n - 1])
    for n, setback in enumerate(setbacks, 1):
        words = Message("distance of its face from edge {n} of the slab, to which the perimeter runs out", n=n)
        yield Step(words, f"s_{n}", max(setback, 0.0), "m")


def thinner_steps(
    parts: Sequence[WeightedLegs], formula: Callable[[int], str], clause: str, *, away: bool = False
) -> Iterator[Step]:
    """Yield the share of a perimeter's length that counts in parts of thinner slab, by a formula of their number n.

    Parts that count wholly are left out.
    The formula has t_n, by how much the slab is thinner, and if it asks for that b_n, how far from the face it begins.
    """
    thinner = [part for part in parts if part.thinner is not None and part.share < 1]
    for n, part in enumerate(thinner, 1):
        assert part.thinner is not None
        by, far = part.thinner
        yield Step(Message("by how much the slab is thinner in part {n} of it", n=n), f"t_{n}", by, "m")
        if away:
            yield Step(Message("where part {n} begins, from the face", n=n), f"b_{n}", far, "m")
        words = Message("share of a length that counts in part {n}", n=n)
        yield Step(words, f"k_t,{n}", part.share, "", formula(n), clause)


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
