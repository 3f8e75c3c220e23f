"""Punching at ends and corners of walls by EN 1992-1-1 6.4.4(2): the demands within 2 d.

EN 1992-1-1 has no figure for them. Perimeters and beta are those of DIN EN 1992-1-1/NA (Figures NA.6.12.1, NA.6.21.1)
with every annex. At the face nothing is judged: what presses there on the slab goes straight down in part.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from groundslab.arrays import made_once
from groundslab.design.codes.en1992_2004 import punching as en1992
from groundslab.design.codes.en1992_2004.checks.punching_demand import Demand, Stress
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.design.codes.en1992_2004.perimeters import openings, share_of_thinner
from groundslab.design.rules.punching import Demands
from groundslab.design.rules.wall_ends import WallPunching, punching_walls
from groundslab.model.design.laid_bars import PunchingBars, punching_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

#: Distances of the perimeters over the effective depth. Nearer to a wall than half of it the shear force of a plate is
#: not that of a slab.
STEPS = np.arange(4, 17) / 8


def at_ends(combined: Results, steel: Reinforcement) -> Iterator[WallPunching]:
    """Yield what punches at ends and corners of walls in all ultimate combinations."""
    return punching_walls(combined, steel, STEPS, lambda _, d: openings(d), share=share_of_thinner)


@made_once
def wall_demands(combined: Results) -> Demands[Demand]:
    """Return the demands of punching at ends and corners of walls in all ultimate combinations, if bars are given."""
    steel = combined.model.reinforcement
    if steel is None:
        return Demands()
    model = combined.model
    punching = [*at_ends(combined, steel)]
    sites = {(at_end.site.end.name, at_end.site.pulls): at_end.site for at_end in punching}
    bars = {
        key: punching_bars(model.plate, steel, site.column, site.d, model.plates, site.face) if steel.laid else None
        for key, site in sites.items()
    }
    demands = [_demand(at_end, steel, bars[at_end.site.end.name, at_end.site.pulls]) for at_end in punching]
    return Demands({(demand.combination, demand.name): demand for demand in demands})


def _demand(punching: WallPunching, steel: Reinforcement, laid: PunchingBars | None) -> Demand:
    """Return the demand at an end or a corner in a combination, with the bars that are laid there."""
    site, results = punching.site, punching.results
    concrete, bars = materials(steel, results.limit_state)
    most = en1992.most_bars(concrete, bars)
    ratio = most if laid is None else min(laid.ratio(site.d), most)
    v_Rd_c = en1992.resistance_without_links(concrete, site.d, ratio)
    lines, v = site.perimeters, punching.v
    around = tuple(
        Stress(
            float(lines.distances[k]), float(lines.u[k]), float(punching.V[k]), site.beta, float(v[k]),
            supported=False, pressure=0.0, edge=0.0, others=0.0, error=partial(punching.error_of_stress, k),
        )
        for k in range(len(v))
    )  # fmt: skip
    force = float(punching.V[-1])
    about = site.end.name, results.combination, results.limit_state, force, site.d
    return Demand(
        *about, v_Rd_c, None, around, ratio=ratio, bars=laid, pulls=site.pulls, place=site.end.place,
        wall=site,
    )  # fmt: skip
