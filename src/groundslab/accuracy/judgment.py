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

from groundslab.accuracy.values import estimate_error
from groundslab.results.fields import PLATE_FIELDS, extreme_node

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
    coarser, comparison = results.coarser, results.comparison
    if coarser is None or comparison is None:
        return []
    of_quantity, of_unit = defaultdict[str, float](float), defaultdict[str, float](float)
    found = []
    for (quantity, unit, value, place), (*_, before, _) in zip(
        judged_values(results), judged_values(coarser), strict=True
    ):
        of_quantity[quantity] = max(of_quantity[quantity], abs(value))
        of_unit[unit] = max(of_unit[unit], abs(value))
        found.append((quantity, unit, value, estimate_error(value, before, comparison), place))
    judged = [
        JudgedValue(error / of_quantity[quantity], value, quantity, place)
        for quantity, unit, value, error, place in found
        if of_quantity[quantity] > NOTHING * of_unit[unit]
    ]
    return sorted(judged, key=lambda each: -each.share)


def judged_values(results: CombinationResult) -> Iterator[tuple[str, str, float, tuple[float, float] | None]]:
    """Yield quantity, unit, value and place of each judged value."""
    plate = results.plate
    nodes = plate.nodes
    limited = finite_section_forces(results.model, nodes)
    for name in (*BOTH_SIGNS, *SIZES):
        about, field = PLATE_FIELDS[name], getattr(plate, name)
        judged = limited if name in LIMITED_AWAY else np.ones(len(nodes), dtype=bool)
        if not judged.any():
            continue
        own, at = field[judged], nodes[judged]
        for sign in (1, -1) if name in BOTH_SIGNS else (1,):
            values = np.abs(own) if name in SIZES else own
            node = extreme_node(at, values, sign)
            yield about.label, about.dimension, float(values[node]), (float(at[node, 0]), float(at[node, 1]))
    yield "area in contact", "share", plate.contact_share, None
    for support in results.supports:
        place = support.nodes.mean(axis=0).tolist() if len(support.nodes) else None
        yield "force of supports", "force", support.total, None if place is None else (place[0], place[1])


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
