"""Point loads on floors, step by step: what acts together, yield lines of one, two and four, punching.

Every value is that of the check; formulas stand beside the functions that compute it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from groundslab.design.codes.en1992_2004 import punching
from groundslab.design.codes.en1992_2004.perimeter_demand import Punching
from groundslab.design.codes.floors import resistance, yield_lines
from groundslab.design.codes.floors.acting_loads import Force, as_column, worst_location
from groundslab.design.codes.floors.slab import FIBER_DEPTH, Slab, concrete_of, effective_depth, sagging_moment
from groundslab.design.codes.floors.slab_steps import SHARE, hogging, mesh_depth, radius, sagging
from groundslab.design.codes.floors.yield_lines import FORMULAS, LARGE, MEYERHOF, Location, YieldSlab
from groundslab.design.demands.perimeters import NearEdge, RectangularColumn, Surroundings
from groundslab.design.rules.calculation import BY_CHORDS, MEGA, Step, length_by_figures, width_steps
from groundslab.messages import Message, Name
from groundslab.model.design.floors import ACI360Floor, TR34Floor

_CLAUSE, _PUNCHING = "TR34", "EN 1992-1-1 6.4"
#: Numbers of forces that differ by a smaller share are equal.
_DIGITS = 9


@dataclass(frozen=True, slots=True)
class Kind:
    """Forces of a group that are equal, how many there are, and what ends their symbols."""

    force: Force
    count: int
    end: str  # empty of the only kind

    def named(self, symbol: str) -> str:
        """Return the symbol of one of them."""
        return f"{symbol}_{self.end}" if self.end and "_" not in symbol else symbol + (self.end and f",{self.end}")


def kinds_of(members: tuple[Force, ...]) -> list[Kind]:
    """Return the kinds of forces of a group."""
    kinds: dict[tuple[object, ...], list[Force]] = {}
    for force in members:
        loads = tuple((case, factor, _rounded(P)) for case, factor, P in force.cases)
        kinds.setdefault((loads, force.share, _rounded(force.a)), []).append(force)
    ends = [""] if len(kinds) == 1 else [str(n) for n in range(1, 1 + len(kinds))]
    return [Kind(alike[0], len(alike), end) for end, alike in zip(ends, kinds.values(), strict=True)]


def _rounded(value: float) -> float:
    """Return a number to nine digits."""
    return float(f"{value:.{_DIGITS}g}")


def by_tr34(
    floor: TR34Floor, slab: Slab, members: tuple[Force, ...], distances: float, location: Location
) -> Iterator[Step]:
    """Yield forces that act together against those at which yield lines form; distances [m] as of `yield_lines`."""
    concrete = concrete_of(floor)
    yield from radius(slab)
    yield from hogging(concrete, slab.h)
    yield from sagging(floor, slab.h)
    M_n = resistance.plain_moment(concrete, slab.h)
    lines = YieldSlab(slab.l, sagging_moment(floor, concrete, slab.h), M_n)
    kinds = kinds_of(members)
    for kind in kinds:
        yield from _acting(kind, floor.joint_transfer)
        yield from _circle(kind)
    yield from _place(members, slab.l)
    for kind in kinds:
        yield from _single(lines, kind.force.a, location, [kind.named(symbol) for symbol in ("a", "P_u", "P_a", "P_b")])
    demand = "P"
    if len(members) > 1:
        demand = "P_s"
        yield from _together(lines, kinds, members, distances, location)
    total = sum(force.share * force.P for force in members)
    resists = yield_lines.together(lines, [force.a for force in members], distances, location)
    R = "P_u" if len(members) == 1 else "P_R"
    yield Step(SHARE, "eta", total / resists, "", f"{demand} / {R}")


def _acting(kind: Kind, transfer: float) -> Iterator[Step]:
    """Yield a force by its load cases, and what joints carry over of it."""
    force, named = kind.force, kind.named
    if kind.end:
        yield Step("number of such forces", named("n"), kind.count)
    terms = []
    for k, (case, factor, P) in enumerate(force.cases, 1):
        words = Message("loads of {case} that act as one", case=Name(case))
        yield Step(words, named(f"F_{k}"), P / MEGA, "MN")
        yield Step(Message("factor of {case}", case=Name(case)), named(f"gamma_{k}"), factor)
        terms.append(f"{named(f'gamma_{k}')} * {named(f'F_{k}')}")
    formula = " + ".join(terms)
    if force.share != 1:
        yield Step("share of a load at the plate's edge that joints transfer to the next bay", named("t_j"), transfer)
        formula = f"(1 - {named('t_j')}) * ({formula})"
    yield Step("force on the slab", named("P"), force.share * force.P / MEGA, "MN", formula)


def _circle(kind: Kind) -> Iterator[Step]:
    """Yield the circle that a force stands on."""
    force, named = kind.force, kind.named
    yield Step("area that the loads stand on or enclose", named("A"), force.shape.area, "m2")
    yield Step("radius of a circle of this area", named("a"), force.a, "m", f"sqrt({named('A')} / pi)")


def _place(members: tuple[Force, ...], l: float) -> Iterator[Step]:  # noqa: E741  the field's letter
    """Yield why forces are inside, at an edge or at a corner: by the one that is nearest to either."""
    location = worst_location(members)
    force = min((each for each in members if each.location == location), key=lambda each: each.away)
    words = "distance from the nearest corner" if location == "corner" else "distance from the nearest edge"
    yield Step(words, "e", force.away, "m")
    words = "distance within which it is at the edge or at the corner"
    a = next(kind.named("a") for kind in kinds_of(members) if math.isclose(kind.force.a, force.a, rel_tol=1e-8))
    yield Step(words, "e_lim", l + force.a, "m", f"l + {a}", _CLAUSE)


def _single(lines: YieldSlab, a: float, location: Location, symbols: Sequence[str]) -> Iterator[Step]:
    """Yield the force on a circle of radius a [m] at which yield lines form.

    The symbols are those of the radius, the force, and of what it lies between.
    """
    of_a, of_force, *between = symbols
    force, r = yield_lines.single(lines, a, location), f"({of_a} / l)"
    if a / lines.l >= LARGE:
        yield Step(_fails(location), of_force, force / MEGA, "MN", FORMULAS[f"large_{location}"].format(r=r), _CLAUSE)
        return
    bounds = yield_lines.bounds_of_single(lines, location)
    yield from _between(bounds, location, between, _fails(location))
    yield _linear(force, of_force, between, of_a, _fails(location))


def _fails(location: Location) -> str:
    """Return what a force at which yield lines form is called."""
    return {
        "internal": "force inside at which yield lines form",
        "edge": "force at an edge at which yield lines form",
        "corner": "force at a corner at which yield lines form",
    }[location]


def _between(bounds: tuple[float, float], of: str, symbols: Sequence[str], words: str) -> Iterator[Step]:
    """Yield the loads [N] for a / l = 0 and 0.2."""
    for size, share, value, symbol in zip(("small", "large"), (0.0, LARGE), bounds, symbols, strict=True):
        of_circle = Message("{text}, of a circle with a / l = {share:g}", text=words, share=share)
        formula = FORMULAS[f"{size}_{of}"].format(r=f"{LARGE:g}")
        yield Step(of_circle, symbol, value / MEGA, "MN", formula, _CLAUSE)


def _linear(value: float, symbol: str, between: Sequence[str], a: str, words: str) -> Step:
    """Return the load [N] between those for a / l = 0 and 0.2."""
    small, large = between
    formula = f"{small} + {a} / l / {LARGE:g} * ({large} - {small})"
    return Step(words, symbol, value / MEGA, "MN", formula, _CLAUSE)


def _together(
    lines: YieldSlab, kinds: list[Kind], members: tuple[Force, ...], distances: float, location: Location
) -> Iterator[Step]:
    """Yield the sum of forces of a group, of those that each bears alone and of those that all bear together."""
    count = {kind.end: kind.named("n") if kind.end else f"{kind.count:g}" for kind in kinds}

    def sum_of(symbol: str) -> str:
        return " + ".join(f"{count[kind.end]} * {kind.named(symbol)}" for kind in kinds)

    total = sum(force.share * force.P for force in members)
    yield Step("sum of the forces", "P_s", total / MEGA, "MN", sum_of("P"))
    alone = sum(yield_lines.single(lines, force.a, location) for force in members)
    yield Step("what they bear each by itself", "P_0", alone / MEGA, "MN", sum_of("P_u"), _CLAUSE)
    words = "distance of both forces" if len(members) == 2 else "sum of both sides of the rectangle between the forces"
    yield Step(words, "x", distances, "m")
    least = min(members, key=lambda force: force.a)
    a, r = "a", "(a / l)"
    if len(kinds) > 1:
        yield Step("smallest of the radii", "a", least.a, "m", f"min({', '.join(kind.named('a') for kind in kinds)})")
    inside = yield_lines.group(lines, least.a, distances, "internal")
    words = "sum of forces inside at which yield lines form around all of them"
    if least.a / lines.l >= LARGE:
        yield Step(words, "P_g", inside / MEGA, "MN", FORMULAS["large_group"].format(r=r), _CLAUSE)
    else:
        between = ("P_c", "P_d")
        yield from _between(yield_lines.bounds_of_group(lines, distances), "group", between, words)
        yield _linear(inside, "P_g", between, a, words)
    formula = "min(P_0, P_g)"
    if location != "internal":
        here = next(kind for kind in kinds if math.isclose(kind.force.a, least.a, rel_tol=1e-8))
        yield from _single(lines, least.a, "internal", (a, "P_i", "P_e", "P_f"))
        formula = f"min(P_0, P_g * {here.named('P_u')} / P_i)"
    words = "sum of forces at which the slab fails, less at edges and corners as that of single ones"
    resists = yield_lines.together(lines, [force.a for force in members], distances, location)
    yield Step(words, "P_R", resists / MEGA, "MN", formula, _CLAUSE)


def by_meyerhof(floor: ACI360Floor, slab: Slab, force: Force) -> Iterator[Step]:
    """Yield a force on fiber concrete against that at which yield lines form, over the factor of safety."""
    yield from radius(slab)
    yield Step("modulus of rupture of the concrete", "f_r", floor.f_r / MEGA, "MPa")
    yield Step("residual strength of fiber concrete over f_r, for yield lines", "R_e,3", floor.R_e3 or 0.0)
    M_0 = cracked_moment(floor, slab.h)
    words, clause = "moments that the slab resists at both faces together", "ACI 360R-10 11.3.3.3"
    yield Step(words, "M_0", M_0 / MEGA, "MNm/m", "f_r * (1 + R_e,3) * h^2 / 6", clause)
    (kind,) = kinds_of((force,))
    yield from _acting(kind, floor.joint_transfer)
    yield from _circle(kind)
    yield from _place((force,), slab.l)
    factor, growth = MEYERHOF[force.location]
    P_u = yield_lines.meyerhof(M_0, force.a, slab.l, force.location)
    formula = f"{factor:g} * (1 + {growth:g} * a / l) * M_0"
    yield Step(_fails(force.location), "P_u", P_u / MEGA, "MN", formula, "Meyerhof 1962")
    yield Step("factor of safety", "SF", floor.safety_factor)
    yield Step(SHARE, "eta", force.share * force.P * floor.safety_factor / P_u, "", "P * SF / P_u", clause)


def cracked_moment(floor: ACI360Floor, h: float) -> float:
    """Return M_0 [N m/m] of fiber concrete h [m] thick, f_r (1 + R_e,3) h^2 / 6."""
    return floor.f_r * (1 + (floor.R_e3 or 0.0)) * h**2 / 6


def _depth(floor: TR34Floor, slab: Slab) -> Iterator[Step]:
    """Yield the effective depth of a floor for punching."""
    yield Step("thickness, where it is least", "h", slab.h, "m")
    if floor.mesh_axis is not None:
        yield from mesh_depth(floor, slab.h)
        return
    words = "effective depth, where there is no mesh"
    yield Step(words, "d", effective_depth(floor, slab.h), "m", f"{FIBER_DEPTH:g} * h", _CLAUSE)


def at_footprint(floor: TR34Floor, slab: Slab, force: Force, around: Surroundings, u_0: float) -> Iterator[Step]:
    """Yield the stress at a footprint, u_0 [m] of whose perimeter counts, against what struts bear there."""
    (kind,), concrete, d = kinds_of((force,)), concrete_of(floor), effective_depth(floor, slab.h)
    yield from _depth(floor, slab)
    yield from _acting(kind, floor.joint_transfer)
    yield from _face(force, around, u_0, d)
    v_Ed = force.share * force.P / (u_0 * d)
    yield Step("stress at the face", "v_Ed,0", v_Ed / MEGA, "MPa", "P / (u_0 * d)", f"{_PUNCHING}.5(3)")
    yield Step("strength of the concrete", "f_ck", concrete.f_ck / MEGA, "MPa")
    yield Step("partial factor", "gamma_C", concrete.gamma_c)
    (a, b, c), most = concrete.annex.nu, punching.max_resistance(concrete)
    assert most is not None  # the recommended values have it
    formula = f"{concrete.annex.face:g} * {a:g} * min(1, {b:g} - f_ck / {c:g}) * f_ck / gamma_C"
    yield Step("largest resistance", "v_Rd,max", most / MEGA, "MPa", formula, "EN 1992-1-1 6.4.5(3), 6.2.2(6)")
    yield Step("share used at the face", "eta_0", v_Ed / most, "", "v_Ed,0 / v_Rd,max")


def _extents(force: Force, edges: Sequence[NearEdge]) -> tuple[float, float]:
    """Return the extents of a footprint [m], the first one along the edge if one counts."""
    from shapely import get_coordinates

    column = as_column(force)
    if not isinstance(column, RectangularColumn):
        return 2 * force.a, 2 * force.a
    if not edges:
        return column.width_x, column.width_y
    places, outward = get_coordinates(column.footprint()), edges[0].outward
    along = np.array([-outward[1], outward[0]])
    return float(np.ptp(places @ along)), float(np.ptp(places @ outward))


def _face(force: Force, around: Surroundings, u_0: float, d: float) -> Iterator[Step]:
    """Yield u_0 [m] by the extents of a footprint, and by its distances from edges where these count."""
    formulas: list[tuple[str, int, Callable[[float, float, float], float]]] = [
        ("2 * (c_1 + c_2)", 0, lambda c_1, c_2, _: 2 * (c_1 + c_2)),
        ("pi * c_1", 0, lambda c_1, *_: math.pi * c_1),
        ("c_1 + 2 * s_1 + min(3 * d, 2 * c_2)", 1, lambda c_1, c_2, s: c_1 + 2 * s + min(3 * d, 2 * c_2)),
        ("s_1 + s_2 + min(3 * d, c_1 + c_2)", 2, lambda c_1, c_2, s: s + min(3 * d, c_1 + c_2)),
    ]
    clause = f"{_PUNCHING}.5(3)"
    for formula, count, length in formulas:
        edges = around.edges[:count]
        setbacks, widths = tuple(edge.setback for edge in edges), _extents(force, edges)
        if math.isclose(length(*widths, sum(setbacks)), u_0, rel_tol=BY_CHORDS):
            yield from width_steps(widths, setbacks)
            yield Step("perimeter of the face that counts", "u_0", u_0, "m", formula, clause)
            return
    yield Step("perimeter of the face that counts, less what lies between the tangents to openings", "u_0", u_0, "m",
               clause=clause)  # fmt: skip


def around_it(floor: TR34Floor, slab: Slab, force: Force, around: Surroundings, found: Punching) -> Iterator[Step]:
    """Yield the stress 2 d from a footprint against what the slab resists without links."""
    (kind,), concrete, d = kinds_of((force,)), concrete_of(floor), effective_depth(floor, slab.h)
    yield from _depth(floor, slab)
    yield from _acting(kind, floor.joint_transfer)
    yield Step("distance of the perimeter from the face", "a", 2 * d, "m", "2 * d", f"{_PUNCHING}.2(1)")
    yield from _length(force, around, found, 2 * d)
    yield from _reduced(found)
    v_Ed = max(found.v_Ed, 0.0)
    yield Step("stress", "v_Ed", v_Ed / MEGA, "MPa", "max(V_Ed, 0) / (u * d)", f"{_PUNCHING}.3")
    yield Step("strength of the concrete", "f_ck", concrete.f_ck / MEGA, "MPa")
    yield Step("partial factor", "gamma_C", concrete.gamma_c)
    rho = 0.0 if floor.mesh_area is None else floor.mesh_area / d
    formula = "" if floor.mesh_area is None else f"min({punching.MOST_BARS:g}, A_s / (10000 * d))"
    words = "ratio of bars in tension that counts"
    yield Step(words, "rho_l", min(rho, punching.MOST_BARS), "", formula, f"{_PUNCHING}.4(1)")
    yield Step("factor of size", "k", punching.size_factor(d), "", punching.FORMULAS["k"], f"{_PUNCHING}.4(1)")
    yield Step("C_Rd,c gamma_C of the annex", "C", concrete.annex.c_rd_c_punching, clause=f"{_PUNCHING}.4(1)")
    clause = "EN 1992-1-1 6.2.2(1), 6.3N"
    yield Step("least factor of the annex", "v_min", punching.least_factor(concrete, d), clause=clause)
    v_Rd_c = punching.resistance_without_links(concrete, d, rho)
    formula = punching.FORMULAS["v_Rd,c"]
    yield Step("resistance at 2 d", "v_Rd,c", v_Rd_c / MEGA, "MPa", formula, f"{_PUNCHING}.4(1), 6.47")
    yield Step(SHARE, "eta", v_Ed / v_Rd_c, "", "v_Ed / v_Rd,c")


def _length(force: Force, around: Surroundings, found: Punching, distance: float) -> Iterator[Step]:
    """Yield what the length of the perimeter at a distance [m] is made of."""
    line, clause = found.perimeter, "EN 1992-1-1 6.4.2"
    edges = [edge for edge in around.edges if edge.setback in line.setbacks]
    widths = _extents(force, edges)
    yield from width_steps(widths, line.setbacks)
    formula = length_by_figures(widths, line.setbacks, ("a", distance), line.length)
    opened = line.length - found.u > BY_CHORDS * line.length
    yield Step("length of the perimeter on the slab", "u_w" if opened else "u", line.length if opened else found.u,
               "m", formula, clause)  # fmt: skip
    if opened:
        words = "what lies between the tangents to openings"
        yield Step(words, "u_o", line.length - found.u, "m", clause=f"{clause}(3)")
        yield Step("what counts of it", "u", found.u, "m", "u_w - u_o", clause)


def _reduced(found: Punching) -> Iterator[Step]:
    """Yield the force that punches less the pressure inside, and less a pull of the edge's line force."""
    clause = "EN 1992-1-1 6.4.4(2), 6.48"
    yield Step("area of the plate inside", "A_i", found.area, "m2")
    words = "pressure of the ground inside, its mean by integration over the area"
    yield Step(words, "p_m", found.pressure_inside / found.area / 1e3, "kPa")
    yield Step("pressure of the ground inside", "N_p", found.pressure_inside / MEGA, "MN", "p_m * A_i / 1000")
    formula = "P - N_p"
    if found.edge_inside < 0:
        words = "line force of the ground along the plate's edge inside"
        yield Step(words, "N_e", found.edge_inside / MEGA, "MN")
        formula += " - N_e"
    yield Step("force that punches", "V_Ed", found.V_Ed / MEGA, "MN", formula, clause)
