"""The results of several plates, plate by plate."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.design.punching import outline
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


def distances_to_edges(results: CombinationResult, places: Array) -> Array:
    """Return how far places (k, 2) [m] are from the edges of all plates (k,) [m]."""
    from shapely import STRtree, get_coordinates, get_parts, linestrings, points

    rings = [get_coordinates(part) for part in get_parts(edges_of(results))]
    sides = np.concatenate([np.stack([ring[:-1], ring[1:]], axis=1) for ring in rings])
    nearest = STRtree(linestrings(sides)).query_nearest(points(places), return_distance=True, all_matches=False)
    distances: Array = nearest[1]
    return distances
