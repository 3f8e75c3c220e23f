"""What the tables of columns and piles have of punching by EN 1992-1-1:2023."""

from __future__ import annotations

from groundslab.design.codes.en1992_2023.checks.punching_demand import (
    Demands,
    Punching,
    column_demands,
    pile_demands,
    zone_demands,
)
from groundslab.design.codes.en1992_2023.checks.remarks import SECOND_HAND
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
    missing_notes,
    pulled_notes,
)
from groundslab.messages import Message, joined
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

_HEADS: Heads = (
    ("d_v", "mm"), ("V_Ed", "kN"), ("b_0.5", "m"), ("beta_e", ""), ("tau_Ed", "MPa"), *INSIDE,
    ("tau_Ed by 8.93", "MPa"), ("b_0", "m"), ("k_pb", ""), ("a_pd", "mm"), ("tau_Rdc,min", "MPa"), ("tau_Rd,c", "MPa"),
    ("tau_Ed / tau_Rd,c", ""),
)  # fmt: skip


def at_columns(combined: Results, steel: Reinforcement) -> PunchingColumns:
    """Return punching at columns."""
    return _columns(combined, steel, column_demands(combined), "column")


def over_piles(combined: Results, steel: Reinforcement) -> PunchingColumns:
    """Return punching of the plate over piles."""
    return _columns(combined, steel, pile_demands(combined), "pile")


def around_zones(combined: Results, steel: Reinforcement) -> PunchingColumns:
    """Return punching around thicker zones with columns."""
    return _columns(combined, steel, zone_demands(combined), "zone")


def _columns(combined: Results, steel: Reinforcement, demands: Demands, support: str) -> PunchingColumns:
    """Return the columns of demands, and their notes."""
    known, missing = demands
    notes = (
        Message(
            "Punching by EN 1992-1-1:2023 8.4, in ultimate combinations: V_Ed = {relief}, of what acts up to "
            "0.67 d_v from the face, as without links; tau_Ed = beta_e V_Ed / (b_0.5 d_v) on b_0.5 at d_v / "
            "2, beta_e of Table 8.3, refined, by the support's own force and moments. Other supports inside "
            "are not counted.",
            relief=RELIEF[support],
        ),
        "tau_Ed by 8.93 is the largest mean over 2 d_v of the plate's shear forces along b_0.5, over d_v. It counts "
        "where another column with a fifth of V_Ed or more is closer than 3 d_v (8.4.2(8)).",
        "Of straight parts of b_0.5 and of b_0 at the face 3 d_v count (8.4.2(3)), and nothing between the tangents to "
        "openings up to 6 d_v away, which is the reach of the first generation.",
        "tau_Rd,c has the bars provided or 2 %, and, away from edges, a_pd instead of d_v where moments are zero "
        "nearer than 8 d_v (8.4.3(2)). tau_Ed / tau_Rd,c is over tau_Rdc,min where that is larger (8.4.1(2)).",
        edge_note(steel, support),
        joined((DEPTH[support].replace("d is", "d_v is"), THINNER), " "),
        *pulled_notes(known.values()),
        *((AROUND,) if support == "zone" else ()),
        Message("{second_hand}.", second_hand=SECOND_HAND),
        *((BEAMS,) if combined.model.beams else ()),
    )
    return PunchingColumns(
        _HEADS,
        lambda combination, name: _cells(known.get((combination, name))),
        (*notes, *missing_notes(missing, support)),
    )


def _cells(demand: Punching | None) -> list[float | None]:
    """Return the figures of a demand, in the order of the table; nothing where nothing punches."""
    if demand is None:
        return [None] * len(_HEADS)
    inside = cells_inside(demand.force, demand.pressure, demand.edge, demand.others)
    return [
        demand.d * 1e3, demand.V_Ed / 1e3, demand.b_05, demand.beta_e, demand.tau_Ed / 1e6, *inside,
        None if demand.of_analysis is None else demand.of_analysis / 1e6,
        demand.b_0, demand.k_pb, demand.a_pd * 1e3, demand.tau_min / 1e6, demand.tau_Rd_c / 1e6, demand.used,
    ]  # fmt: skip
