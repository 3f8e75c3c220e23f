"""What the tables of columns and piles have of two-way shear by ACI 318-19."""

from __future__ import annotations

from collections.abc import Mapping

from groundslab.design.codes.aci318.checks.two_way_demand import (
    TwoWay,
    pile_two_way,
    strength,
    two_way,
    zone_two_way,
)
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

_HEADS: Heads = (("d", "mm"), ("V_u", "kN"), ("b_o", "m"), ("v_u", "MPa"), *INSIDE, ("phi v_c", "MPa"))


def at_columns(combined: Results, steel: Reinforcement) -> PunchingColumns:
    """Return two-way shear at columns."""
    return _columns(combined, steel, two_way(combined), "column")


def over_piles(combined: Results, steel: Reinforcement) -> PunchingColumns:
    """Return two-way shear of the plate over piles."""
    return _columns(combined, steel, pile_two_way(combined), "pile")


def around_zones(combined: Results, steel: Reinforcement) -> PunchingColumns:
    """Return two-way shear around thicker zones with columns."""
    return _columns(combined, steel, zone_two_way(combined), "zone")


def _columns(
    combined: Results,
    steel: Reinforcement,
    demands: tuple[Mapping[tuple[str, str], TwoWay], Mapping[str, str]],
    support: str,
) -> PunchingColumns:
    """Return the columns of demands, and their notes."""
    known, missing = demands
    notes = (
        Message(
            "Two-way shear by ACI 318-19 22.6.5.2 and 8.4.4.2, in ultimate combinations: V_u = {relief}, on "
            "the critical section at d / 2, v_u with the moments of all forces inside about its center, on "
            "principal axes. Other supports inside are not counted.",
            relief=RELIEF[support],
        ),
        effective_note("J_c"),
        edge_note(steel, support),
        joined((DEPTH[support], THINNER), " "),
        *pulled_notes(known.values()),
        *((AROUND,) if support == "zone" else ()),
        *((BEAMS,) if combined.model.beams else ()),
    )
    return PunchingColumns(
        _HEADS,
        lambda combination, name: _cells(known.get((combination, name)), steel),
        (*notes, *missing_notes(missing, support)),
    )


def _cells(demand: TwoWay | None, steel: Reinforcement) -> list[float | None]:
    """Return the figures of a demand, in the order of the table; nothing where nothing punches."""
    if demand is None:
        return [None] * len(_HEADS)
    inside = cells_inside(demand.force, demand.pressure, demand.edge, demand.others)
    return [
        demand.d * 1e3, demand.V_u / 1e3, demand.b_o, demand.v_u / 1e6, *inside, strength(demand, steel) / 1e6,
    ]  # fmt: skip
