"""Slabs that crack: what one row of cracked elements more or less would change."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers, made_once_by
from groundslab.fem.hanging import find_hanging
from groundslab.fem.shape_functions import areas

if TYPE_CHECKING:
    from groundslab.results.results import CombinationResult

#: An element whose stiffness is below this share of the uncracked one has cracked.
CRACKED = 0.999
#: A row of elements at the border is cracked too much or too little by half at most, on either side, and the plate has
#: about half of the energy.
OF_A_ROW = 1 / 8


def error_of_cracks(results: CombinationResult) -> float:
    """Return the error of values by the border of what has cracked, as a share of the largest, 0 without cracks.

    An element has cracked or not, and where it does, its stiffness may jump. The share is that of the energy of bending
    in which the elements on both sides of the border differ.
    """
    if results.comparison is None or results.elements.stiffness_ratio is None:
        return 0.0
    return _error_of_cracks(results)


@made_once_by(lambda results: (results.comparison,))
def _error_of_cracks(results: CombinationResult) -> float:
    """Return the same of results with cracks."""
    e, elements = results.elements, results.plate.elements
    ratio = e.stiffness_ratio
    assert ratio is not None
    cracked = ratio < CRACKED
    if not cracked.any() or cracked.all():
        return 0.0
    area = areas(results.plate.nodes[elements])
    moment: Array = np.abs((e.moment_x + e.moment_y) / 2) + np.hypot((e.moment_x - e.moment_y) / 2, e.moment_xy)
    first, other = _pairs(elements)
    border = cracked[first] != cracked[other]
    first, other = first[border], other[border]
    softer = np.abs(1 / ratio[first] - 1 / ratio[other])
    differing = (moment[first] * moment[other] * softer * (area[first] + area[other]) / 4).sum()
    return float(OF_A_ROW * differing / (moment**2 / ratio * area).sum())


def _pairs(elements: Integers) -> tuple[Integers, Integers]:
    """Return the elements (s,) on the one and on the other side of each side (s,), of halves of longer sides, too."""
    side = elements[:, 4:8].ravel()
    order = np.argsort(side, kind="stable")
    element = order // 4
    same = np.flatnonzero(side[order][1:] == side[order][:-1])
    owner = np.zeros(int(elements.max()) + 1, dtype=np.int64)
    owner[side] = np.repeat(np.arange(len(elements)), 4)
    node, _, middle, _ = find_hanging(elements).T
    return np.append(element[same], owner[node]), np.append(element[same + 1], owner[middle])
