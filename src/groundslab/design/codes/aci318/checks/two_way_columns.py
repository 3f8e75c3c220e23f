"""What tables have of two-way shear by ACI 318-19."""

from __future__ import annotations

from groundslab.design.codes.aci318.checks.two_way_demand import TwoWay, strength, used
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.punching import INSIDE, RELIEF, Heads, cells_inside, effective_note
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement

_STRESS: Heads = (("d", "mm"), ("V_u", "kN"), ("b_o", "m"), ("v_u", "MPa"))
_AT_WALLS = (
    "Two-way shear by ACI 318-19 22.6.5.2, in ultimate combinations: V_u is the shear force of the slab across "
    "the critical section at d / 2 from the wall's faces. v_u = beta V_u / (b_o d).",
    "ACI 318-19 has no figure for ends of walls: as much of them as by DIN EN 1992-1-1/NA, Figure NA.6.12.1, "
    "counts, and beta is that of its Figure NA.6.21.1, 1.35 at ends and 1.20 at corners.",
)


def heads(support: Support) -> Heads:
    """Return the columns."""
    at_wall = support == "wall end"
    return (*_STRESS, ("phi v_c", "MPa"), ("v_u / phi v_c", "")) if at_wall else (*_STRESS, *INSIDE, ("phi v_c", "MPa"))


def cells(demand: TwoWay, steel: Reinforcement, support: Support) -> list[float | None]:
    """Return the figures of a demand."""
    of_stress = [demand.d * 1e3, demand.V_u / 1e3, demand.b_o, demand.v_u / 1e6]
    resists = strength(demand, steel) / 1e6
    if support == "wall end":
        return [*of_stress, resists, used(demand, steel)]
    return [*of_stress, *cells_inside(demand.force, demand.pressure, demand.edge, demand.others), resists]


def notes(support: Support, _: Reinforcement) -> tuple[str, ...]:
    """Return what a reader must know."""
    if support == "wall end":
        return _AT_WALLS
    return (
        Message(
            "Two-way shear by ACI 318-19 22.6.5.2 and 8.4.4.2, in ultimate combinations: V_u = {relief}, on "
            "the critical section at d / 2, v_u with the moments of all forces inside about its center, on "
            "principal axes. Other supports inside are not counted.",
            relief=RELIEF[support],
        ),
        effective_note("J_c"),
    )
