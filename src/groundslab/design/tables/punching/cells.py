"""What tables tell of punching, by the code of the case: at columns, and of the plate over piles."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from groundslab.design.basis.combinations import solved_results, ultimate_results
from groundslab.design.demands.perimeter_loads import punching_piles
from groundslab.design.en1992.case_materials import materials
from groundslab.design.en1992.punching import max_resistance
from groundslab.design.tables.punching.aci318 import TwoWay, pile_two_way, strength, two_way
from groundslab.design.tables.punching.en1992 import demands, pile_demands
from groundslab.design.tables.punching.en1992_demand import Demand, Demands
from groundslab.design.tables.table import Cell, Table, table_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

Heads = tuple[tuple[str, str], ...]

#: What acts inside a perimeter.
_INSIDE: Heads = (
    ("pressure inside", "kN"), ("pressure inside / load", "%"), ("edge line force inside", "kN"),
    ("other loads inside", "kN"),
)  # fmt: skip
_EN1992: Heads = (
    ("d", "mm"), ("V_Ed", "kN"), ("u", "m"), ("beta", ""), ("v_Ed", "MPa"), *_INSIDE,
    ("a", "m"), ("v_Ed at a", "MPa"), ("v_Rd at a", "MPa"), ("v_Ed / v_Rd", ""),
    ("u_0", "m"), ("v_Ed at the face", "MPa"), ("v_Rd,max", "MPa"),
)  # fmt: skip
_ACI318: Heads = (("d", "mm"), ("V_u", "kN"), ("b_o", "m"), ("v_u", "MPa"), *_INSIDE, ("phi v_c", "MPa"))

_ONE_EDGE = (
    "The line force of the ground along the plate's edge inside is no pressure: it does not relieve punching, unless "
    "the case says line_force_relieves; where it pulls, it is added."
)
_RELIEVES = (
    "The line force of the ground along the plate's edge inside is taken off as the pressure inside is, as the case "
    "says line_force_relieves."
)
_OVER_EDGE = "The line force of the ground along the plate's edge inside adds to what punches, as the pressure does."
_EFFECTIVE = (
    "What lies between the tangents to an opening does not count; center, moments and {} are those of the part that is "
    "left."
)


@dataclass(frozen=True, slots=True)
class PunchingCells:
    """The columns that a table has of punching, their cells by combination and name, and what a reader must know."""

    heads: Heads
    cells: Callable[[str, str], list[Cell]]
    notes: tuple[str, ...]


def punching_at_columns(combined: Results) -> PunchingCells:
    """Return what the table of columns tells of punching; nothing without reinforcement."""
    steel = combined.model.reinforcement
    if steel is None:
        return PunchingCells((), lambda _, __: [], ())
    if steel.code == "ACI 318":
        return _by_aci318(steel, two_way(combined), "column")
    return _by_en1992(combined, steel, demands(combined), "column")


def pile_punching(combined: Results) -> Table:
    """Return each pile's force and the demand of punching of the plate over it in each ultimate combination."""
    steel = combined.model.reinforcement
    assert steel is not None
    if steel.code == "ACI 318":
        punched = _by_aci318(steel, pile_two_way(combined), "pile")
    else:
        punched = _by_en1992(combined, steel, pile_demands(combined), "pile")
    rows = [
        [
            result.combination,
            pile.name,
            float(pile.pushing(result)[0]) / 1e3,
            *punched.cells(result.combination, pile.name),
        ]
        for result in ultimate_results(combined)
        for pile in punching_piles(combined.model)
    ]
    heads = [("combination", ""), ("pile", ""), ("force", "kN"), *punched.heads]
    return table_of("pile_punching", "Punching over piles", heads, rows, punched.notes)


def _by_en1992(combined: Results, steel: Reinforcement, punched: Demands, one: str) -> PunchingCells:
    """Return the columns of punching by EN 1992-1-1."""
    states = {result.combination: result.limit_state for result in solved_results(combined)}

    def cells(combination: str, name: str) -> list[Cell]:
        v_Rd_max = max_resistance(materials(steel, states[combination])[0])
        return _en1992_cells(punched.found.get((combination, name)), v_Rd_max)

    relief = "load + other loads inside - pressure inside" if one == "column" else _OVER_PILE
    notes = (
        f"Punching by EN 1992-1-1 6.4.4(2), in ultimate combinations: V_Ed = {relief}, on the perimeter at 2 d. v_Ed = "
        "beta V_Ed / (u d), beta by the moments of all forces inside about the perimeter's center, 6.51. Other "
        "supports inside are not counted.",
        "a is the distance from the face, up to 2 d, at which v_Ed / v_Rd is largest, v_Rd = v_Rd,c 2 d / a with the "
        "bars that are laid or the most that count.",
        _EFFECTIVE.format("W"),
        _edge_note(steel, one),
        "At the face v_Ed is that of 6.4.5(3) on u_0, with the same beta, on what is left of the force there. Above "
        "v_Rd,max no reinforcement helps; some annexes have none.",
        _DEPTH[one] + " Where the plate gets thinner within 2 d or a little farther out, that place needs a check of "
        "its own.",
    )
    return PunchingCells(_EN1992, cells, (*notes, *_missing(punched.missing, one)))


def _by_aci318(
    steel: Reinforcement, demands_and_missing: tuple[Mapping[tuple[str, str], TwoWay], Mapping[str, str]], one: str
) -> PunchingCells:
    """Return the columns of two-way shear by ACI 318."""
    known, missing = demands_and_missing
    relief = "load + other loads inside - pressure inside" if one == "column" else _OVER_PILE
    notes = (
        f"Two-way shear by ACI 318-19 22.6.5.2 and 8.4.4.2, in ultimate combinations: V_u = {relief}, on the critical "
        "section at d / 2, v_u with the moments of all forces inside about its center, on principal axes. Other "
        "supports inside are not counted.",
        _EFFECTIVE.format("J_c"),
        _edge_note(steel, one),
        _DEPTH[one],
    )
    return PunchingCells(
        _ACI318,
        lambda combination, name: _aci318_cells(known.get((combination, name)), steel),
        (*notes, *_missing(missing, one)),
    )


#: What of a pile's force punches.
_OVER_PILE = "force + pressure inside + edge line force inside - other loads inside"
#: The effective depth of columns and of piles.
_DEPTH = {
    "column": "d is the least thickness under the column less the mean distance of the bottom bars' axes.",
    "pile": "d is the least thickness over the pile less the mean distance of the top bars' axes.",
}


def _edge_note(steel: Reinforcement, one: str) -> str:
    """Return what the line force along the plate's edge does."""
    if one == "pile":
        return _OVER_EDGE
    return _RELIEVES if steel.line_force_relieves else _ONE_EDGE


def _missing(missing: Mapping[str, str], one: str) -> tuple[str, ...]:
    """Return why some have none, as notes."""
    return tuple(f"no punching of {one} {name}: {why}" for name, why in missing.items())


def _en1992_cells(demand: Demand | None, v_Rd_max: float | None) -> list[Cell]:
    """Return the figures of punching by EN 1992-1-1, in the order of the table; nothing where nothing punches."""
    if demand is None:
        return [None] * len(_EN1992)
    cells: list[Cell] = [demand.d * 1e3, *[None] * 8]
    if (far := demand.at_2d) is not None:
        inside = _inside(demand.force, far.pressure, far.edge, far.others)
        cells[1:] = [far.V_Ed / 1e3, far.u, far.beta, far.v_Ed / 1e6, *inside]
    worst: list[Cell] = [None] * 4
    if (stress := demand.governing) is not None:
        worst = [stress.distance, stress.v_Ed / 1e6, demand.resistance(stress) / 1e6, demand.used(stress)]
    face: list[Cell] = [None, None] if demand.face is None else [demand.face.u, demand.face.v_Ed / 1e6]
    return [*cells, *worst, *face, None if v_Rd_max is None else v_Rd_max / 1e6]


def _aci318_cells(demand: TwoWay | None, steel: Reinforcement) -> list[Cell]:
    """Return the figures of two-way shear by ACI 318, in the order of the table; nothing where nothing punches."""
    if demand is None:
        return [None] * len(_ACI318)
    inside = _inside(demand.force, demand.pressure, demand.edge, demand.others)
    return [
        demand.d * 1e3, demand.V_u / 1e3, demand.b_o, demand.v_u / 1e6, *inside, strength(demand, steel) / 1e6,
    ]  # fmt: skip


def _inside(force: float, pressure: float, edge: float, others: float) -> list[Cell]:
    """Return what acts inside, in the order of the table, of forces [N]."""
    return [pressure / 1e3, 100 * pressure / force, edge / 1e3, others / 1e3]
