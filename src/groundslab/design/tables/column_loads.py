"""The loads that act on a part of the plate, case by case."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from typing import TYPE_CHECKING, assert_never

import numpy as np

from groundslab.arrays import Integers
from groundslab.fem import load_vectors
from groundslab.fem.mesh import Mesh
from groundslab.geometry.plan import FLAT
from groundslab.model.loads import load_types
from groundslab.model.loads.clipping import clip_line_load
from groundslab.model.model import Model
from groundslab.model.plates.further import first_sections
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely import Polygon
    from shapely.geometry.base import BaseGeometry


def sum_of_column(model: Model, name: str) -> dict[str, float]:
    """Return the sum of the point loads that name a column [N], by load case."""
    force: dict[str, float] = defaultdict(float)
    for load in model.loads:
        if isinstance(load, load_types.PointLoad) and load.column == name:
            force[load.case] += load.P
    return force


def moments_of_column(model: Model, name: str) -> tuple[dict[str, float], dict[str, float]]:
    """Return the sums of the moments M_x and M_y of the point loads that name a column [N m], by load case."""
    sums: tuple[dict[str, float], dict[str, float]] = defaultdict(float), defaultdict(float)
    for load in model.loads:
        if isinstance(load, load_types.PointLoad) and load.column == name:
            sums[0][load.case] += load.M_x
            sums[1][load.case] += load.M_y
    return sums


def sum_of_others(results: CombinationResult, part: Polygon, column: str | None) -> dict[str, float]:
    """Return the sum of all loads on a part of the plate but those that name a column [N], by load case.

    Without a column it is that of all loads.
    """
    model, plate = results.solved_model, results.plate
    mesh, chord = Mesh(plate.nodes, plate.elements), FLAT * max(model.sides)
    elements = load_vectors.find_elements_near(mesh, part)
    force: dict[str, float] = defaultdict(float)
    for load in model.loads:
        if load_types.presses_ground(load):
            continue
        if isinstance(load, load_types.UniformLoad):
            own = _of_plate(results, elements, load.plate)
            force[load.case] += float(
                load_vectors.integrate_over_polygon(mesh, own, part, load_types.pressure_function(load)).sum()
            )
        elif isinstance(load, load_types.PatchLoad | load_types.AreaLoad):
            for piece in _pieces(part, load.to_shapely(chord)):
                force[load.case] += float(
                    load_vectors.integrate_over_polygon(mesh, elements, piece, load_types.pressure_function(load)).sum()
                )
        elif isinstance(load, load_types.SelfWeight):
            own = _of_plate(results, elements, load.plate)
            area = load_vectors.integrate_over_polygon(mesh, own, part).sum(axis=1)
            force[load.case] += float(load.unit_weight * (area @ results.elements.thickness[own]))
        elif isinstance(load, load_types.LineLoad):
            force[load.case] += _on_line(load, model, part, chord)
        elif isinstance(load, load_types.PointLoad):
            if load.column != column and _may_meet(load, model, part):
                force[load.case] += _on_footprint(load.on(model.columns), part, chord)
        elif not isinstance(load, load_types.TemperatureLoad | load_types.ShrinkageLoad | load_types.SettlementLoad):
            assert_never(load)
    return force


def _of_plate(results: CombinationResult, elements: Integers, name: str) -> Integers:
    """Return those of some elements that belong to the plate of a name, all of them if there is none."""
    plates = results.model.every_plate
    number = np.searchsorted(first_sections(plates), results.elements.section[elements], side="right") - 1
    return elements if not name else elements[np.array([each.name for each in plates])[number] == name]


def factored_sum(results: CombinationResult, force: Mapping[str, float]) -> float:
    """Return the sum of forces by load case [N], each with the factor of its case in a combination."""
    factors = dict(results.factors) if results.solved_model.cases else {"": 1.0}
    return sum(factors.get(case, 0.0) * each for case, each in force.items())


def _pieces(part: Polygon, area: BaseGeometry) -> list[Polygon]:
    """Return the polygons that two areas have in common."""
    from shapely import get_parts, intersection

    return [piece for piece in get_parts(intersection(part, area)) if piece.geom_type == "Polygon" and piece.area > 0]


def _on_line(load: load_types.LineLoad, model: Model, part: Polygon, chord: float) -> float:
    """Return the force [N] of a line load on a part of the plate."""
    from shapely import LineString, Point, get_coordinates, get_parts, intersection

    force = 0.0
    for piece in clip_line_load(model.plate, load, model.plates):
        n = piece.edge.chords(chord)
        places = np.arange(n + 1) / n
        flat = LineString(piece.edge.at(places))
        for inside in get_parts(intersection(flat, part)):
            if inside.length > 0:
                # the force of a linear q is that in the middle of the way times the length
                ways = [flat.project(Point(end)) / flat.length for end in get_coordinates(inside)[[0, -1]]]
                q = piece.q[0] + (piece.q[1] - piece.q[0]) * sum(ways) / 2
                force += q * inside.length / flat.length * piece.edge.length
    return float(force)


def _may_meet(load: load_types.PointLoad, model: Model, part: Polygon) -> bool:
    """Return whether a load that names a column may stand on a part of the plate, by the column's place."""
    named = [each for each in model.columns if each.name == load.column]
    return not named or bool(named[0].to_shapely(FLAT * max(model.sides)).intersects(part))


def _on_footprint(load: load_types.PointLoad, part: Polygon, chord: float) -> float:
    """Return the force [N] of a point load on a part of the plate, by its pressure where it has a footprint."""
    place = load.to_shapely(chord)
    if place.geom_type == "Point":
        return load.P if part.covers(place) else 0.0
    center, inertia = load_vectors.inertia(place)
    slope = np.array([load.M_x, load.M_y]) @ np.linalg.inv(inertia)
    force = 0.0
    for piece in _pieces(part, place):
        lever = np.array(piece.centroid.coords[0]) - center
        force += float((load.P / place.area + lever @ slope) * piece.area)
    return force
