"""What tables have of punching by EN 1992-1-1:2023."""

from __future__ import annotations

from groundslab.design.codes.en1992_2023.checks.punching_demand import Punching
from groundslab.design.codes.en1992_2023.checks.remarks import SECOND_HAND
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.punching import INSIDE, RELIEF, Heads, cells_inside
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement

_STRESS: Heads = (("d_v", "mm"), ("V_Ed", "kN"), ("b_0.5", "m"), ("beta_e", ""), ("tau_Ed", "MPa"))
_RESISTANCE: Heads = (("tau_Rdc,min", "MPa"), ("tau_Rd,c", "MPa"), ("tau_Ed / tau_Rd,c", ""))
_BETWEEN: Heads = (*INSIDE, ("tau_Ed by 8.93", "MPa"), ("b_0", "m"), ("k_pb", ""), ("a_pd", "mm"))


def heads(support: Support) -> Heads:
    """Return the columns."""
    return (*_STRESS, *((("k_pb", ""),) if support == "wall end" else _BETWEEN), *_RESISTANCE)


def cells(demand: Punching, _: Reinforcement, support: Support) -> list[float | None]:
    """Return the figures of a demand."""
    of_stress = [demand.d * 1e3, demand.V_Ed / 1e3, demand.b_05, demand.beta_e, demand.tau_Ed / 1e6]
    resistance = demand.tau_min / 1e6, demand.tau_Rd_c / 1e6, demand.used
    if support == "wall end":
        return [*of_stress, demand.k_pb, *resistance]
    inside = cells_inside(demand.force, demand.pressure, demand.edge, demand.others)
    of_analysis = None if demand.of_analysis is None else demand.of_analysis / 1e6
    return [*of_stress, *inside, of_analysis, demand.b_0, demand.k_pb, demand.a_pd * 1e3, *resistance]


def notes(support: Support, _: Reinforcement) -> tuple[str, ...]:
    """Return what a reader must know."""
    second_hand = Message("{second_hand}.", second_hand=SECOND_HAND)
    if support == "wall end":
        return (
            "Punching by EN 1992-1-1:2023 8.4, in ultimate combinations: V_Ed is the shear force of the slab across "
            "the perimeter at d_v / 2 from the wall's faces, tau_Ed = beta_e V_Ed / (b_0.5 d_v), beta_e of Table 8.3, "
            "1.4 at ends and 1.2 at corners. tau_Ed / tau_Rd,c is over tau_Rdc,min where that is larger (8.4.1(2)).",
            "Of walls as much counts as by DIN EN 1992-1-1/NA, Figure NA.6.12.1, but no more than 1.5 d_v along a "
            "side.",
            second_hand,
        )
    return (
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
        second_hand,
    )
