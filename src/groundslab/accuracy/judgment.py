"""The largest discretization error of the values that are judged: extremes of the fields, and what supports carry.

Where moments and shear forces have no limit as the mesh is refined, their means are judged (`singular_places`); where
other values have none, they are not (`singularities`).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from groundslab.accuracy.values import add_errors, estimate_error
from groundslab.arrays import Array, Memo
from groundslab.results.fields import PLATE_FIELDS, extreme_node, place_of

if TYPE_CHECKING:
    from groundslab.results.results import CombinationResult

#: Fields of which the largest and the smallest value are judged, or the largest size.
BOTH_SIGNS = ("settlement", "pressure", "moment_x", "moment_y")
SIZES = ("gap", "moment_xy", "shear_x", "shear_y")
#: Of these, fields that are not judged everywhere, see `singularities.Limits`.
LIMITED = {"shear_x": "shear_forces", "shear_y": "shear_forces", "pressure": "pressures"}
#: Values below this share of the largest of their unit are rounding.
NOTHING = 1e-9


@dataclass(frozen=True, slots=True)
class JudgedValue:
    """An error as a share of the largest value of its quantity, the value [SI], its name and place [m].

    Around are the places (p, 2) of all nodal values that may exceed it by at least half as much, none of other values.
    """

    share: float
    value: float
    label: str
    place: tuple[float, float] | None
    around: Array = field(default_factory=lambda: np.zeros((0, 2)), compare=False, repr=False)


def judge(results: CombinationResult) -> list[JudgedValue]:
    """Return the judged values with their errors, the largest first; none without a coarser mesh to compare.

    Of what nearly vanishes no share is told: each is one of the largest value of the same quantity.
    """
    if results.coarser is None:
        return []
    return _JUDGED.get(results.plate.settlement, results.comparison, lambda: _judge(results))


def _judge(results: CombinationResult) -> list[JudgedValue]:
    """Return the judged values with their errors, the largest first."""
    of_quantity, of_unit = defaultdict[str, float](float), defaultdict[str, float](float)
    found = [*judged_values(results)]
    for unit, each in found:
        of_quantity[each.label] = max(of_quantity[each.label], abs(each.value))
        of_unit[unit] = max(of_unit[unit], abs(each.value))
    judged = [
        replace(each, share=each.share / of_quantity[each.label])
        for unit, each in found
        if of_quantity[each.label] > NOTHING * of_unit[unit]
    ]
    return sorted(judged, key=lambda each: -each.share)


def judged_values(results: CombinationResult) -> Iterator[tuple[str, JudgedValue]]:
    """Yield the unit and each judged value of results with a coarser mesh, with its error [SI] as the share.

    The places of extremes are those where they may lie if nodal values have their errors, see `error_of_largest`.
    """
    from groundslab.accuracy.singularities import find_limits

    plate, coarser, comparison = results.plate, results.coarser, results.comparison
    assert coarser is not None
    assert comparison is not None
    nodes = plate.nodes
    limits = find_limits(results.solved_model, nodes, plate.in_contact)
    for name in (*BOTH_SIGNS, *SIZES):
        about, field = PLATE_FIELDS[name], getattr(plate, name)
        judged = getattr(limits, LIMITED[name]) if name in LIMITED else np.ones(len(nodes), dtype=bool)
        if not judged.any():
            continue
        own, other, at = field[judged], getattr(coarser.plate, name)[judged], nodes[judged]
        for sign in (1, -1) if name in BOTH_SIGNS else (1,):
            values, before = (np.abs(own), np.abs(other)) if name in SIZES else (sign * own, sign * other)
            most = add_errors(values, before, comparison)
            node, value = extreme_node(at, most, 1), float(values.max())
            error = float(most[node]) - value
            around = at[most >= value + error / 2]
            yield about.dimension, JudgedValue(error, sign * value, about.label, place_of(at, node), around)
    share = plate.contact_share
    error = estimate_error(share, coarser.plate.contact_share, comparison)
    yield "share", JudgedValue(error, share, "area in contact", None)
    for support, before_it in zip(results.supports, coarser.supports, strict=True):
        error = estimate_error(support.total, before_it.total, comparison)
        middle = place_of(support.nodes.mean(axis=0)[None], 0) if len(support.nodes) else None
        yield "force", JudgedValue(error, support.total, "force of supports", middle)


#: Judged values of results, which are asked for more than once.
_JUDGED: Memo[list[JudgedValue]] = Memo()
