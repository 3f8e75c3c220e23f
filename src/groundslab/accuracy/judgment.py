"""The largest discretization error of the values that are judged: extremes of the fields, and what supports carry.

What has no limit as the mesh is refined is not judged: moments, shear forces and pressures at forces and supports
without a footprint, and at corners that point into the plate.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.accuracy.values import add_errors, estimate_error
from groundslab.results.fields import PLATE_FIELDS, extreme_node, place_of

if TYPE_CHECKING:
    from groundslab.arrays import Array, Flags
    from groundslab.geometry.plan import Ring
    from groundslab.model.model import Model
    from groundslab.results.results import CombinationResult

#: Fields of which the largest and the smallest value are judged, or the largest size.
BOTH_SIGNS = ("settlement", "pressure", "moment_x", "moment_y")
SIZES = ("gap", "moment_xy", "shear_x", "shear_y")
#: Of these, fields that have no limit at some places.
LIMITED_AWAY = ("pressure", "moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
#: Values below this share of the largest of their unit are rounding.
NOTHING = 1e-9
#: They are judged so many thicknesses away from there.
AWAY = 1.0


@dataclass(frozen=True, slots=True)
class JudgedValue:
    """An error as a share of the largest value of its quantity, the value [SI], its name and place [m]."""

    share: float
    value: float
    label: str
    place: tuple[float, float] | None


def judge(results: CombinationResult) -> list[JudgedValue]:
    """Return the judged values with their errors, the largest first; none without a coarser mesh to compare.

    Of what nearly vanishes no share is told: each is one of the largest value of the same quantity.
    """
    if results.coarser is None:
        return []
    of_quantity, of_unit = defaultdict[str, float](float), defaultdict[str, float](float)
    found = [*judged_values(results)]
    for quantity, unit, value, *_ in found:
        of_quantity[quantity] = max(of_quantity[quantity], abs(value))
        of_unit[unit] = max(of_unit[unit], abs(value))
    judged = [
        JudgedValue(error / of_quantity[quantity], value, quantity, place)
        for quantity, unit, value, place, error in found
        if of_quantity[quantity] > NOTHING * of_unit[unit]
    ]
    return sorted(judged, key=lambda each: -each.share)


def judged_values(results: CombinationResult) -> Iterator[tuple[str, str, float, tuple[float, float] | None, float]]:
    """Yield quantity, unit, value, place and error of each judged value of results with a coarser mesh.

    The places of extremes are those where they may lie if nodal values have their errors, see `error_of_largest`.
    """
    plate, coarser, comparison = results.plate, results.coarser, results.comparison
    assert coarser is not None
    assert comparison is not None
    nodes = plate.nodes
    limited = finite_section_forces(results.model, nodes)
    for name in (*BOTH_SIGNS, *SIZES):
        about, field = PLATE_FIELDS[name], getattr(plate, name)
        judged = limited if name in LIMITED_AWAY else np.ones(len(nodes), dtype=bool)
        if not judged.any():
            continue
        own, other, at = field[judged], getattr(coarser.plate, name)[judged], nodes[judged]
        for sign in (1, -1) if name in BOTH_SIGNS else (1,):
            values, before = (np.abs(own), np.abs(other)) if name in SIZES else (sign * own, sign * other)
            most = add_errors(values, before, comparison)
            node, value = extreme_node(at, most, 1), float(values.max())
            yield about.label, about.dimension, sign * value, place_of(at, node), float(most[node]) - value
    share = plate.contact_share
    yield "area in contact", "share", share, None, estimate_error(share, coarser.plate.contact_share, comparison)
    for support, before_it in zip(results.supports, coarser.supports, strict=True):
        error = estimate_error(support.total, before_it.total, comparison)
        middle = place_of(support.nodes.mean(axis=0)[None], 0) if len(support.nodes) else None
        yield "force of supports", "force", support.total, middle, error


def finite_section_forces(model: Model, nodes: Array) -> Flags:
    """Return at which nodes (n, 2) moments and shear forces have a limit as the mesh is refined, (n,)."""
    from scipy.spatial import KDTree

    places = np.array([*_singular_places(model)]).reshape(-1, 2)
    if not len(places):
        return np.ones(len(nodes), dtype=bool)
    far: Flags = KDTree(places).query(nodes)[0] > AWAY * model.plate.thickness
    return far


def _singular_places(model: Model) -> Iterator[tuple[float, float]]:
    """Yield the places at which moments and shear forces have no limit."""
    for load in model.loads:
        if load.kind == "point":
            own = load.on(model.columns)
            if own.width_x is None and own.diameter is None:
                assert own.x is not None
                assert own.y is not None
                yield own.x, own.y
    yield from ((each.x, each.y) for each in model.supports if each.kind == "point")
    yield from _corners_into(model.plate.ring(), 1)
    for opening in model.plate.openings:
        yield from _corners_into(opening.ring(), -1)


def _corners_into(ring: Ring, side: int) -> Iterator[tuple[float, float]]:
    """Yield the corners between straight edges that point into the plate, which lies inside (1) or outside (-1)."""
    edges = ring.segments()
    turn = side * np.sign(ring.signed_area)
    for before, after in zip((edges[-1], *edges[:-1]), edges, strict=True):
        if before.straight and after.straight:
            (ax, ay), (bx, by) = (np.subtract(each.end, each.start) for each in (before, after))
            if turn * (ax * by - ay * bx) < -1e-9 * np.hypot(ax, ay) * np.hypot(bx, by):
                yield after.start
