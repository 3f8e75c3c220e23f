"""Punching at ends and corners of walls by EN 1992-1-1:2023 8.4, at d_v / 2 from their faces, and its table.

beta_e is that of Table 8.3. Figure 8.19, how much of the walls counts, was not read: of DIN EN 1992-1-1/NA, Figure
NA.6.12.1, and of 8.4.2(3), 3 d_v of a straight part and half of it at each end, the shorter one is taken.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from groundslab.arrays import made_once
from groundslab.design.codes.en1992_2023 import punching as en1992
from groundslab.design.codes.en1992_2023.checks.critical_sections import OPENING_REACH
from groundslab.design.codes.en1992_2023.checks.punching_demand import Punching
from groundslab.design.codes.en1992_2023.checks.remarks import SECOND_HAND
from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.design.codes.en1992_2023.shear import minimum_resistance
from groundslab.design.demands.line_properties import total_length
from groundslab.design.demands.perimeters import Openings
from groundslab.design.demands.wall_perimeters import course
from groundslab.design.rules.punching import Heads, PunchingColumns
from groundslab.design.rules.wall_ends import WallPunching, punching_walls
from groundslab.messages import Message
from groundslab.model.design.laid_bars import punching_ratio
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

_HEADS: Heads = (
    ("d_v", "mm"), ("V_Ed", "kN"), ("b_0.5", "m"), ("beta_e", ""), ("tau_Ed", "MPa"), ("k_pb", ""),
    ("tau_Rdc,min", "MPa"), ("tau_Rd,c", "MPa"), ("tau_Ed / tau_Rd,c", ""),
)  # fmt: skip


@made_once
def wall_demands(combined: Results) -> dict[tuple[str, str], Punching]:
    """Return the demands by combination and end or corner of walls, if bars are given."""
    steel = combined.model.reinforcement
    if steel is None:
        return {}
    some = punching_walls(
        combined,
        steel,
        np.array([en1992.DISTANCE]),
        lambda _, d: Openings(OPENING_REACH * d, widened=True),
        en1992.STRAIGHT / 2,
    )
    return {(each.results.combination, each.site.end.name): _demand(each, steel, combined) for each in some}


def _demand(punching: WallPunching, steel: Reinforcement, combined: Results) -> Punching:
    """Return the demand at an end or a corner in a combination."""
    site, V, state = punching.site, float(punching.V[0]), punching.results.limit_state
    model, d, concrete = combined.model, site.d, materials(steel, state)[0]
    # gradients are those of the whole perimeter, without openings
    b_0, whole = (total_length(course(site.area, distance).legs) for distance in (0.0, en1992.DISTANCE * d))
    k_pb, b_05 = en1992.gradient(b_0, whole), float(site.perimeters.u[0])
    ratio = en1992.MOST_BARS
    if steel.laid:
        ratio = min(ratio, punching_ratio(model.plate, steel, site.column, d, model.plates, site.face))
    beta_e = en1992.WALLS[site.end.kind]
    of_force = beta_e / (b_05 * d)
    return Punching(
        name=site.end.name,
        combination=punching.results.combination,
        limit_state=state,
        force=V,
        d=d,
        b_05=b_05,
        b_0=b_0,
        k_pb=k_pb,
        ratio=ratio,
        a_pd=d,
        a_p=np.inf,
        V_Ed=V,
        V_links=V,
        beta_e=beta_e,
        tau_Ed=of_force * V,
        of_analysis=None,
        tau_Rd_c=en1992.resistance_without_links(concrete, k_pb, ratio, d),
        tau_min=float(minimum_resistance(concrete, materials(steel, state)[1], d)),
        pressure=0.0,
        edge=0.0,
        others=0.0,
        supported=False,
        place=site.end.place,
        error=partial(_error, punching, of_force),
        pulls=site.pulls,
    )


def _error(punching: WallPunching, of_force: float) -> float | None:
    """Return the error of the stress [Pa]."""
    error = punching.error(0)
    return None if error is None else error * of_force


def at_walls(combined: Results, _: Reinforcement) -> PunchingColumns:
    """Return what the table of punching at ends and corners of walls has."""
    known = wall_demands(combined)
    return PunchingColumns(
        _HEADS,
        lambda combination, name: _cells(known.get((combination, name))),
        (
            "Punching by EN 1992-1-1:2023 8.4, in ultimate combinations: V_Ed is the shear force of the slab across "
            "the perimeter at d_v / 2 from the wall's faces, tau_Ed = beta_e V_Ed / (b_0.5 d_v), beta_e of Table 8.3, "
            "1.4 at ends and 1.2 at corners. tau_Ed / tau_Rd,c is over tau_Rdc,min where that is larger (8.4.1(2)).",
            "Of walls as much counts as by DIN EN 1992-1-1/NA, Figure NA.6.12.1, but no more than 1.5 d_v along a "
            "side.",
            Message("{second_hand}.", second_hand=SECOND_HAND),
        ),
    )


def _cells(demand: Punching | None) -> list[float | None]:
    """Return the figures of a demand, in the order of the table; nothing where nothing punches."""
    if demand is None:
        return [None] * len(_HEADS)
    return [
        demand.d * 1e3, demand.V_Ed / 1e3, demand.b_05, demand.beta_e, demand.tau_Ed / 1e6, demand.k_pb,
        demand.tau_min / 1e6, demand.tau_Rd_c / 1e6, demand.used,
    ]  # fmt: skip
