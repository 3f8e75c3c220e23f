"""Two-way shear by ACI 318-19 22.6 at ends and corners of walls, at d / 2 from their faces.

ACI 318-19 has no figure for them. As much of the walls counts as by DIN EN 1992-1-1/NA, and instead of gamma_v M c /
J_c of a moment that is not known its factors beta. alpha_s is that of three sides at an end and of two at a corner
(22.6.5.3); the ratio of the long side to the short one is that of a rectangle around what counts.
"""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from groundslab.arrays import Array, made_once
from groundslab.design.codes.aci318 import punching as aci318
from groundslab.design.codes.aci318.checks.two_way_demand import OPENING_REACH, TwoWay
from groundslab.design.demands.perimeters import Openings
from groundslab.design.rules.punching import Demands
from groundslab.design.rules.wall_ends import WallPunching, punching_walls
from groundslab.results.results import Results

#: Distance of the critical section over the effective depth (22.6.4.1).
DISTANCE = np.array([0.5])
#: v_u there, with forces in MN, stresses in MPa and lengths in m.
WALL_STRESS = "beta_e * V_u / (b_o * d)"
#: How critical sections run, for alpha_s.
SHAPES = {"end": "edge", "corner": "corner"}


@made_once
def wall_two_way(combined: Results) -> Demands[TwoWay]:
    """Return the demands by combination and end or corner of walls, if bars are given."""
    steel = combined.model.reinforcement
    if steel is None:
        return Demands()
    punching = punching_walls(combined, steel, DISTANCE, lambda thickness, _: Openings(OPENING_REACH * thickness))
    return Demands({(at_end.results.combination, at_end.site.end.name): _demand(at_end) for at_end in punching})


def _demand(punching: WallPunching) -> TwoWay:
    """Return the demand at an end or a corner in a combination."""
    site, V = punching.site, float(punching.V[0])
    return TwoWay(
        site.end.name,
        punching.results.combination,
        V,
        site.d,
        float(site.perimeters.u[0]),
        _side_ratio(site.area.points),
        aci318.ALPHA_S[SHAPES[site.end.kind]],
        V,
        float(punching.v[0]),
        pressure=0.0,
        edge=0.0,
        others=0.0,
        supported=False,
        place=site.end.place,
        error=partial(punching.error_of_stress, 0),
        beta_e=site.beta,
        pulls=site.pulls,
        wall=site,
    )


def _side_ratio(points: Array) -> float:
    """Return the long side over the short one of the smallest rectangle around places (p, 2)."""
    from shapely import MultiPoint, get_coordinates

    corners = get_coordinates(MultiPoint(points).minimum_rotated_rectangle)
    sides = sorted(math.dist(corners[i], corners[i + 1]) for i in (0, 1))
    return sides[1] / sides[0]
