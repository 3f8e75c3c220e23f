"""Punching at ends and corners of walls by EN 1992-1-1:2023 8.4, at d_v / 2 from their faces.

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
from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.design.codes.en1992_2023.shear import minimum_resistance
from groundslab.design.demands.line_properties import total_length
from groundslab.design.demands.perimeters import Openings
from groundslab.design.demands.wall_perimeters import course
from groundslab.design.rules.punching import Demands
from groundslab.design.rules.wall_ends import WallPunching, punching_walls
from groundslab.model.design.laid_bars import punching_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results


@made_once
def wall_demands(combined: Results) -> Demands[Punching]:
    """Return the demands by combination and end or corner of walls, if bars are given."""
    steel = combined.model.reinforcement
    if steel is None:
        return Demands()
    punching = punching_walls(
        combined,
        steel,
        np.array([en1992.DISTANCE]),
        lambda _, d: Openings(OPENING_REACH * d, widened=True),
        en1992.STRAIGHT / 2,
    )
    return Demands(
        {(at_end.results.combination, at_end.site.end.name): _demand(at_end, steel, combined) for at_end in punching}
    )


def _demand(punching: WallPunching, steel: Reinforcement, combined: Results) -> Punching:
    """Return the demand at an end or a corner in a combination."""
    site, V, state = punching.site, float(punching.V[0]), punching.results.limit_state
    model, d, concrete = combined.model, site.d, materials(steel, state)[0]
    # gradients are those of the whole perimeter, without openings
    b_0, whole = (total_length(course(site.area, distance).legs) for distance in (0.0, en1992.DISTANCE * d))
    k_pb, b_05 = en1992.gradient(b_0, whole), float(site.perimeters.u[0])
    bars = punching_bars(model.plate, steel, site.column, d, model.plates, site.face) if steel.laid else None
    ratio = en1992.MOST_BARS if bars is None else min(bars.ratio(d), en1992.MOST_BARS)
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
        bars=bars,
        wall=site,
        gradient_length=whole,
    )


def _error(punching: WallPunching, of_force: float) -> float | None:
    """Return the error of the stress [Pa]."""
    error = punching.error(0)
    return None if error is None else error * of_force
