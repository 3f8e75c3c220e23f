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
from groundslab.model.loads.acting import (
    Acting,
    AreaPressure,
    LineForce,
    PlateAction,
    PointForce,
    Pressure,
    SupportSettlement,
)
from groundslab.model.loads.clipping import clip_line
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
    model = results.solved_model
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    elements = load_vectors.find_elements_near(mesh, part)
    force: dict[str, float] = defaultdict(float)
    for load in model.loads:
        on_column = getattr(load, "column", "")
        if not on_column or (on_column != column and _stands_near(on_column, model, part)):
            for shape in model.shapes(load):
                force[load.case] += _force_on(shape, part, results, mesh, elements)
    return force


def _force_on(shape: Acting, part: Polygon, results: CombinationResult, mesh: Mesh, elements: Integers) -> float:
    """Return the force [N] of a shape on a part of the plate, near which some elements of the mesh lie."""
    chord = FLAT * max(results.model.sides)
    if isinstance(shape, AreaPressure):
        pieces = [] if shape.on == "ground" else _pieces(part, shape.to_shapely())
        return sum(_pressure_force(mesh, elements, piece, shape.pressure) for piece in pieces)
    if isinstance(shape, LineForce):
        return _on_line(shape, results.model, part, chord)
    if isinstance(shape, PointForce):
        return _on_footprint(shape, part, chord)
    if isinstance(shape, PlateAction):
        loaded = _of_plate(results, elements, shape.plate)
        area = load_vectors.integrate_over_polygon(mesh, loaded, part).sum(axis=1)
        weight = shape.unit_weight * float(area @ results.elements.thickness[loaded])
        return weight + (_pressure_force(mesh, loaded, part, shape.pressure) if shape.presses else 0.0)
    if not isinstance(shape, SupportSettlement):
        assert_never(shape)
    return 0.0


def _pressure_force(mesh: Mesh, elements: Integers, part: Polygon, pressure: Pressure) -> float:
    """Return the force [N] of a pressure on the part of some elements that lies in a polygon."""
    return float(load_vectors.integrate_over_polygon(mesh, elements, part, pressure).sum())


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


def _on_line(line: LineForce, model: Model, part: Polygon, chord: float) -> float:
    """Return the force [N] of a line force on a part of the plate."""
    from shapely import LineString, Point, get_coordinates, get_parts, intersection

    force = 0.0
    for piece in clip_line(model.plate, line, model.plates):
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


def _stands_near(name: str, model: Model, part: Polygon) -> bool:
    """Return whether a column stands on a part of the plate."""
    column = next(column for column in model.columns if column.name == name)
    return bool(column.to_shapely(FLAT * max(model.sides)).intersects(part))


def _on_footprint(point: PointForce, part: Polygon, chord: float) -> float:
    """Return the force [N] of a point force on a part of the plate, by its pressure where it has a footprint."""
    place = point.to_shapely(chord)
    if point.ring is None:
        return point.P if part.covers(place) else 0.0
    pressure = point.pressure(place)
    # a linear pressure is that at the center times the area
    forces = [pressure(np.array(piece.centroid.coords[0])) * piece.area for piece in _pieces(part, place)]
    return float(sum(forces))
