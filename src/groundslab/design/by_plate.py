"""The results of several plates, plate by plate."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.design.perimeters import outline
from groundslab.fem.mesh import sides_on_boundary
from groundslab.model.plates.further import first_sections
from groundslab.model.plates.region import PlateRegion
from groundslab.results.mesh_results import PlateResult
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry


def results_by_plate(results: CombinationResult) -> dict[str, PlateResult]:
    """Return the results of each plate by its name, or its number from 1; of a single plate with an empty name."""
    plates = results.model.every_plate
    if len(plates) == 1:
        return {"": results.plate}
    number = np.searchsorted(first_sections(plates), results.elements.section, side="right") - 1
    return {each.name or f"plate {n + 1}": results.plate.part(number == n) for n, each in enumerate(plates)}


def plate_under(results: CombinationResult, x: float, y: float) -> PlateResult:
    """Return the results of the plate that a place [m] lies on, as if there were no other."""
    model = results.model
    number = PlateRegion(model.plate, model.plates).plate_at((x, y)) if model.plates else 0
    return list(results_by_plate(results).values())[number]


def edges_of(results: CombinationResult) -> BaseGeometry:
    """Return the edges of all plates in plan, those along joints too."""
    from shapely import union_all

    return union_all([outline(plate).boundary for plate in results_by_plate(results).values()])


def steps_across(results: CombinationResult, between: tuple[str, str]) -> tuple[Array, Array, Array]:
    """Return places (k, 2) [m] along the line that two plates share, the length of each (k,) and the step there [m].

    The step is the first plate's settlement less the second one's.
    """
    by_name = results_by_plate(results)
    one, other = (by_name[name] for name in between)
    beside = dict(zip(map(tuple, (other.nodes + 0.0).tolist()), other.settlement.tolist(), strict=True))
    across = np.array([beside.get(place, np.nan) for place in map(tuple, (one.nodes + 0.0).tolist())])
    sides = sides_on_boundary(one.elements)
    sides = sides[~np.isnan(across[sides]).any(axis=1)]
    a, b, middle = (one.nodes[sides[:, k]] for k in range(3))
    length = np.linalg.norm(middle - a, axis=1) + np.linalg.norm(b - middle, axis=1)
    lengths = np.zeros(len(one.nodes))
    np.add.at(lengths, sides, length[:, None] * np.array([1, 1, 4]) / 6)
    at = np.flatnonzero(lengths)
    return one.nodes[at], lengths[at], one.settlement[at] - across[at]
