"""How many elements a mesh has, how large they are and how good."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.fem.shape_functions import areas
from groundslab.meshing.quality import scaled_jacobians
from groundslab.results.fields import SAME_VALUE, extreme

if TYPE_CHECKING:
    from groundslab.geometry.plan import Place
    from groundslab.results.results import CombinationResult

#: An element whose scaled Jacobian is smaller is so crooked that its results are doubtful.
POOR = 0.2


@dataclass(frozen=True, slots=True)
class MeshStatistics:
    """The elements of the plate: their number, sides (the root of the area) and scaled Jacobians, 1 for a rectangle."""

    elements: int
    smallest: float  # [m]
    largest: float  # [m]
    worst_quality: float
    mean_quality: float
    unknowns: int  # of plate and ground
    smallest_place: Place | None  # [m]; None if all elements are equal
    largest_place: Place | None
    worst_place: Place | None


def mesh_statistics(results: CombinationResult) -> MeshStatistics:
    """Return the statistics of the mesh that results stand on.

    Parameters
    ----------
    results : CombinationResult
        Results of one combination.

    Returns
    -------
    MeshStatistics
        Number, sides [m] and quality of the plate's elements, and the unknowns that were solved for.
    """
    xy = results.plate.nodes[results.plate.elements]
    centers, sides, quality = xy[:, 8], np.sqrt(areas(xy)), scaled_jacobians(xy)
    (smallest, at_smallest), (largest, at_largest) = (extreme(centers, sides, sign) for sign in (-1, 1))
    worst, at_worst = extreme(centers, quality, -1)
    differ, crooked = largest - smallest > SAME_VALUE * largest, worst < 1 - SAME_VALUE
    return MeshStatistics(
        elements=len(xy),
        smallest=smallest,
        largest=largest,
        worst_quality=worst,
        mean_quality=float(quality.mean()),
        unknowns=results.unknowns,
        smallest_place=at_smallest if differ else None,
        largest_place=at_largest if differ else None,
        worst_place=at_worst if crooked else None,
    )
