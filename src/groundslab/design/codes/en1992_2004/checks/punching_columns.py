"""What tables have of punching by EN 1992-1-1."""

from __future__ import annotations

from groundslab.design.codes.en1992_2004.checks.punching_demand import Demand
from groundslab.design.codes.en1992_2004.checks.wall_ends import STEPS
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.design.codes.en1992_2004.punching import max_resistance
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.punching import INSIDE, RELIEF, Heads, cells_inside, effective_note
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement

_STRESS: Heads = (
    ("d", "mm"), ("V_Ed", "kN"), ("u", "m"), ("beta", ""), ("v_Ed", "MPa"), *INSIDE,
    ("a", "m"), ("v_Ed at a", "MPa"), ("v_Rd at a", "MPa"), ("v_Ed / v_Rd", ""),
)  # fmt: skip
_FACE: Heads = (("u_0", "m"), ("v_Ed at the face", "MPa"), ("v_Rd,max", "MPa"))
_AT_WALLS: Heads = (
    ("d", "mm"), ("a", "m"), ("V_Ed at a", "kN"), ("u at a", "m"), ("beta", ""), ("v_Ed at a", "MPa"),
    ("v_Rd at a", "MPa"), ("v_Ed / v_Rd", ""),
)  # fmt: skip


def heads(support: Support) -> Heads:
    """Return the columns."""
    return _AT_WALLS if support == "wall end" else _STRESS if support == "zone" else (*_STRESS, *_FACE)


def cells(demand: Demand, steel: Reinforcement, support: Support) -> list[float | None]:
    """Return the figures of a demand."""
    if support == "wall end":
        return _at_wall(demand)
    cells: list[float | None] = [demand.d * 1e3, *[None] * 8]
    if (far := demand.at_2d) is not None:
        inside = cells_inside(demand.force, far.pressure, far.edge, far.others)
        cells[1:] = [far.V_Ed / 1e3, far.u, far.beta, far.v_Ed / 1e6, *inside]
    worst: list[float | None] = [None] * 4
    if (stress := demand.governing) is not None:
        worst = [stress.distance, stress.v_Ed / 1e6, demand.resistance(stress) / 1e6, demand.used(stress)]
    if support == "zone":
        return [*cells, *worst]
    face: list[float | None] = [None, None] if demand.face is None else [demand.face.u, demand.face.v_Ed / 1e6]
    v_Rd_max = max_resistance(materials(steel, demand.limit_state)[0])
    return [*cells, *worst, *face, None if v_Rd_max is None else v_Rd_max / 1e6]


def _at_wall(demand: Demand) -> list[float | None]:
    """Return the figures of a demand at an end or a corner of walls."""
    stress = demand.governing
    if stress is None:
        return [None] * len(_AT_WALLS)
    return [
        demand.d * 1e3, stress.distance, stress.V_Ed / 1e3, stress.u, stress.beta, stress.v_Ed / 1e6,
        demand.resistance(stress) / 1e6, demand.used(stress),
    ]  # fmt: skip


def notes(support: Support, _: Reinforcement) -> tuple[str, ...]:
    """Return what a reader must know."""
    if support == "wall end":
        return (
            Message(
                "Punching by EN 1992-1-1 6.4.4(2), in ultimate combinations: V_Ed is the shear force of the slab "
                "across the perimeter at the distance a from the wall's faces, {steps:g} d to 2 d, at which v_Ed "
                "/ v_Rd is largest. v_Ed = beta V_Ed / (u d), v_Rd = v_Rd,c 2 d / a with the bars provided or "
                "the largest ratio that counts.",
                steps=STEPS[0],
            ),
            "Perimeters and beta, 1.35 at ends and 1.20 at corners, are those of DIN EN 1992-1-1/NA, Figures NA.6.12.1 "
            "and NA.6.21.1, with every annex: quarter circles, straight pieces across the end and a_1 / 2 along both "
            "sides; at corners those along the outer faces.",
        )
    at_face = (
        "At the face v_Ed is that of 6.4.5(3) on u_0, with the same beta and the remaining force there. Above "
        "v_Rd,max no reinforcement helps; some annexes have none."
    )
    return (
        Message(
            "Punching by EN 1992-1-1 6.4.4(2), in ultimate combinations: V_Ed = {relief}, on the perimeter "
            "at 2 d. v_Ed = beta V_Ed / (u d), beta from the moments of all forces inside about the "
            "perimeter's center, 6.51. Other supports inside are not counted.",
            relief=RELIEF[support],
        ),
        "a is the distance from the face, up to 2 d, at which v_Ed / v_Rd is largest, v_Rd = v_Rd,c 2 d / a with the "
        "bars provided or the largest ratio that counts.",
        effective_note("W"),
        *(() if support == "zone" else (at_face,)),
    )
