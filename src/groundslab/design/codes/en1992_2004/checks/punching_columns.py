"""What the tables of columns, piles and thicker zones have of punching by EN 1992-1-1."""

from __future__ import annotations

from groundslab.design.codes.en1992_2004.checks.governing_perimeters import demands, pile_demands, zone_demands
from groundslab.design.codes.en1992_2004.checks.punching_demand import Demand, Demands
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.design.codes.en1992_2004.punching import max_resistance
from groundslab.design.rules.combinations import solved_results
from groundslab.design.rules.punching import (
    AROUND,
    BEAMS,
    DEPTH,
    INSIDE,
    RELIEF,
    THINNER,
    Heads,
    PunchingColumns,
    cells_inside,
    edge_note,
    effective_note,
    missing_notes,
    pulled_notes,
)
from groundslab.messages import Message, joined
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

_HEADS: Heads = (
    ("d", "mm"), ("V_Ed", "kN"), ("u", "m"), ("beta", ""), ("v_Ed", "MPa"), *INSIDE,
    ("a", "m"), ("v_Ed at a", "MPa"), ("v_Rd at a", "MPa"), ("v_Ed / v_Rd", ""),
    ("u_0", "m"), ("v_Ed at the face", "MPa"), ("v_Rd,max", "MPa"),
)  # fmt: skip
#: So many of them, the last ones, are about the face.
_AT_FACE = 3


def at_columns(combined: Results, steel: Reinforcement) -> PunchingColumns:
    """Return the punching checks at columns."""
    return _columns(combined, steel, demands(combined), "column")


def over_piles(combined: Results, steel: Reinforcement) -> PunchingColumns:
    """Return the punching checks over piles."""
    return _columns(combined, steel, pile_demands(combined), "pile")


def around_zones(combined: Results, steel: Reinforcement) -> PunchingColumns:
    """Return the punching checks around thicker zones with columns."""
    return _columns(combined, steel, zone_demands(combined), "zone")


def _columns(combined: Results, steel: Reinforcement, punched: Demands, support: str) -> PunchingColumns:
    """Return the columns of demands, and their notes."""
    states = {result.combination: result.limit_state for result in solved_results(combined)}

    at_zone = support == "zone"
    heads = _HEADS[:-_AT_FACE] if at_zone else _HEADS

    def cells(combination: str, name: str) -> list[float | None]:
        v_Rd_max = max_resistance(materials(steel, states[combination])[0])
        return _cells(punched.found.get((combination, name)), v_Rd_max)[: len(heads)]

    at_face = (
        "At the face v_Ed is that of 6.4.5(3) on u_0, with the same beta and the remaining force there. Above "
        "v_Rd,max no reinforcement helps; some annexes have none."
    )
    notes = (
        Message(
            "Punching by EN 1992-1-1 6.4.4(2), in ultimate combinations: V_Ed = {relief}, on the perimeter "
            "at 2 d. v_Ed = beta V_Ed / (u d), beta from the moments of all forces inside about the "
            "perimeter's center, 6.51. Other supports inside are not counted.",
            relief=RELIEF[support],
        ),
        "a is the distance from the face, up to 2 d, at which v_Ed / v_Rd is largest, v_Rd = v_Rd,c 2 d / a with the "
        "bars provided or the largest ratio that counts.",
        effective_note("W"),
        edge_note(steel, support),
        AROUND if at_zone else at_face,
        joined((DEPTH[support], THINNER), " "),
        *pulled_notes(punched.found.values()),
    )
    of_beams = (BEAMS,) if combined.model.beams else ()
    return PunchingColumns(heads, cells, (*notes, *of_beams, *missing_notes(punched.missing, support)))


def _cells(demand: Demand | None, v_Rd_max: float | None) -> list[float | None]:
    """Return the figures of a demand, in the order of the table; nothing where nothing punches."""
    if demand is None:
        return [None] * len(_HEADS)
    cells: list[float | None] = [demand.d * 1e3, *[None] * 8]
    if (far := demand.at_2d) is not None:
        inside = cells_inside(demand.force, far.pressure, far.edge, far.others)
        cells[1:] = [far.V_Ed / 1e3, far.u, far.beta, far.v_Ed / 1e6, *inside]
    worst: list[float | None] = [None] * 4
    if (stress := demand.governing) is not None:
        worst = [stress.distance, stress.v_Ed / 1e6, demand.resistance(stress) / 1e6, demand.used(stress)]
    face: list[float | None] = [None, None] if demand.face is None else [demand.face.u, demand.face.v_Ed / 1e6]
    return [*cells, *worst, *face, None if v_Rd_max is None else v_Rd_max / 1e6]
