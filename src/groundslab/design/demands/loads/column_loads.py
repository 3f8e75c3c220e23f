"""The loads that act on a part of the plate, case by case."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial
from typing import TYPE_CHECKING, assert_never

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once
from groundslab.design.demands.loads.building_loads import building_factors, unit_loads
from groundslab.fem import load_vectors
from groundslab.fem.mesh import Mesh
from groundslab.geometry.plan import FLAT
from groundslab.model.loads.acting import (
    Acting,
    AreaPressure,
    LineForce,
    PlateAction,
    PointForce,
    Pressure,
    SupportSettlement,
)
from groundslab.model.loads.clipping import LinePiece
from groundslab.model.loads.load_types import AnyLoad, PointLoad
from groundslab.model.loads.spreading import spread_line
from groundslab.model.model import Model
from groundslab.model.plates.other_plates import first_sections
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely import Polygon
    from shapely.geometry.base import BaseGeometry

#: What acts, each shape with its load case.
Shapes = Sequence[tuple[str, Acting]]


def sum_of_column(model: Model, name: str) -> dict[str, float]:
    """Return the sum of the point loads on a column [N], and of what the building adds, by load case."""
    return {case: float(sums[0]) for case, sums in by_column(model, name).items()}


def column_of(model: Model, load: AnyLoad) -> str:
    """Return the column on which a load stands: the one that it names, or on whose footprint its center is."""
    return getattr(load, "column", "") or _on_footprints(model).get(id(load), "")


@made_once
def _on_footprints(model: Model) -> dict[int, str]:
    """Return the columns on whose footprints forces stand that name none, by the identity of their loads."""
    from shapely import STRtree, points

    loads = [load for load in model.loads if isinstance(load, PointLoad) and not load.column]
    if not loads or not model.columns:
        return {}
    tree = STRtree([column.to_shapely(FLAT * max(model.sides)) for column in model.columns])
    pairs = tree.query(points([(load.x, load.y) for load in loads]), predicate="intersects")
    return {id(loads[load]): model.columns[column].name for load, column in reversed(pairs.T.tolist())}


def by_column(model: Model, name: str) -> dict[str, Array]:
    """Return the sums of P [N], M_x and M_y [N m] (3,) of the point loads on a column about its center, by load case.

    The building above has cases of its own, see `building_loads`.
    """
    sums: dict[str, Array] = defaultdict(lambda: np.zeros(3))
    places = {column.name: (column.x, column.y) for column in model.columns}
    for load in model.loads:
        if isinstance(load, PointLoad) and column_of(model, load) == name:
            x, y = places[name]
            off = (0.0 if load.x is None else load.x - x, 0.0 if load.y is None else load.y - y)
            sums[load.case] += (load.P, load.M_x + load.P * off[0], load.M_y + load.P * off[1])
    for number, (case, _) in enumerate(unit_loads(model).get(name, ())):
        sums[case] += np.eye(3)[number]
    return dict(sums)


def sum_of_others(results: CombinationResult, part: Polygon, columns: Collection[str]) -> dict[str, float]:
    """Return the sum of all loads on a part of the plate but those on some columns [N], by load case."""
    return {case: float(sums[0]) for case, sums in acting_inside(results, part, columns).items()}


def shapes_around(model: Model, part: Polygon, columns: Collection[str]) -> Shapes:
    """Return the loads that may act on a part of the plate, without those on some columns."""
    stands_near = cache(partial(_stands_near, model=model, part=part))
    shapes: list[tuple[str, Acting]] = []
    for load in model.loads:
        on_column = column_of(model, load)
        if on_column and (on_column in columns or not stands_near(on_column)):
            continue
        shapes += [(load.case, shape) for shape in model.shapes(load)]
    for name, units in unit_loads(model).items():
        if name not in columns and units[0][1].to_shapely().intersects(part):
            shapes += units
    chord = FLAT * max(model.sides)
    return [
        (case, shape)
        for case, shape in shapes
        if getattr(shape, "on", "plate") == "plate" and _may_act(shape, part, chord)
    ]


def _may_act(shape: Acting, part: Polygon, chord: float) -> bool:
    """Return whether a shape may act on a part of the plate; arcs are chords at most so far off [m]."""
    from shapely import box

    if isinstance(shape, PlateAction | SupportSettlement):
        return True  # they have no place
    reach = shape.width if isinstance(shape, LineForce) else 0.0
    return bool(shape.to_shapely(chord).distance(box(*part.bounds)) <= reach + chord)


def acting_inside(
    results: CombinationResult,
    part: Polygon,
    columns: Collection[str],
    shapes: Shapes | None = None,
    shares: tuple[Integers, Array] | None = None,
) -> dict[str, Array]:
    """Return force [N] and first moments int q x dA, int q y dA [N m] (3,) of loads on a part, by load case.

    Parameters
    ----------
    results : CombinationResult
        The results whose mesh and model are meant.
    part : shapely.Polygon
        Part of the plate.
    columns : collection of str
        Loads on these columns are left out.
    shapes : sequence of (str, Acting), optional
        What may press the part (see `shapes_around`), with its load case; all of the model by default.
    shares : ((k,) array of int, (k, 9) array), optional
        Elements that may meet the part and int N dA over it [m2], if they are known.

    Returns
    -------
    dict of str to (3,) array
        The sums by load case.
    """
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    if shares is None:
        near = load_vectors.find_elements_near(mesh, part)
        shares = near, load_vectors.integrate_over_polygon(mesh, near, part)
    inside = _Inside(results, mesh, part, *shares)
    if shapes is None:
        shapes = shapes_around(results.solved_model, part, columns)
    sums: dict[str, Array] = defaultdict(lambda: np.zeros(3))
    for case, shape in shapes:
        sums[case] += inside.of(shape)
    return dict(sums)


def weights_inside(
    results: CombinationResult, shapes: Shapes, shares: tuple[Integers, Array]
) -> dict[str, tuple[float, float]]:
    """Return the unit weight [N/m3] of the slab on a part, and its volume there [m3], by the load case that has it.

    The part is given by elements that may meet it and int N dA over it (see `acting_inside`). Of a case with several
    unit weights the weight over the volume is meant.
    """
    elements, areas = shares
    weights: dict[str, tuple[float, float]] = {}
    for case, shape in shapes:
        if isinstance(shape, PlateAction) and shape.unit_weight:
            on_plate = _of_plate(results, elements, shape.plate)
            volume = float((results.elements.thickness[elements[on_plate], None] * areas[on_plate]).sum())
            weight, before = weights.get(case, (0.0, 0.0))
            if volume:
                weights[case] = (weight * before + shape.unit_weight * volume) / (before + volume), before + volume
    return weights


@dataclass(frozen=True, slots=True)
class _Inside:
    """A part of the plate, and what its elements have inside it."""

    results: CombinationResult
    mesh: Mesh
    part: Polygon
    elements: Integers
    shares: Array  # (k, 9): int N dA over the part [m2]

    def of(self, shape: Acting) -> Array:
        """Return force and first moments (3,) of a shape inside."""
        model = self.results.solved_model
        chord = FLAT * max(model.sides)
        if isinstance(shape, AreaPressure):
            pieces = _pieces(self.part, shape.to_shapely())
            return sum((self.pressed(self.elements, piece, shape.pressure) for piece in pieces), np.zeros(3))
        if isinstance(shape, LineForce):
            along, areas = spread_line(model.plate, shape, model.plates)
            pieces = [(piece, pressure) for area, pressure in areas for piece in _pieces(self.part, area)]
            pressed = sum((self.pressed(self.elements, *pressed_piece) for pressed_piece in pieces), np.zeros(3))
            return pressed + _on_line(along, self.part, chord)
        if isinstance(shape, PointForce):
            return _on_footprint(shape, self.part, chord)
        if isinstance(shape, PlateAction):
            return self.all_over(shape)
        if not isinstance(shape, SupportSettlement):
            assert_never(shape)
        return np.zeros(3)

    def sums(self, elements: Integers, forces: Array) -> Array:
        """Return force and first moments (3,) of nodal forces (k, 9) [N] of elements (k,)."""
        first = np.einsum("ea,eax->x", forces, self.mesh.nodes[self.mesh.elements[elements]])
        return np.array([forces.sum(), *first])

    def pressed(self, elements: Integers, piece: Polygon, pressure: Pressure) -> Array:
        """Return force and first moments (3,) of a pressure on a piece."""
        return self.sums(elements, load_vectors.integrate_over_polygon(self.mesh, elements, piece, pressure))

    def all_over(self, action: PlateAction) -> Array:
        """Return force and first moments (3,) of what acts all over a plate."""
        of_plate = _of_plate(self.results, self.elements, action.plate)
        elements = self.elements[of_plate]
        thickness = self.results.elements.thickness[elements, None]
        uniform = action.pressure.q if action.pressure.constant else 0.0
        sums = self.sums(elements, (uniform + action.unit_weight * thickness) * self.shares[of_plate])
        return sums if action.pressure.constant else sums + self.pressed(elements, self.part, action.pressure)


def _of_plate(results: CombinationResult, elements: Integers, name: str) -> Flags:
    """Return which of some elements belong to the plate of a name; all of them if there is none."""
    if not name:
        return np.ones(len(elements), dtype=bool)
    plates = results.model.every_plate
    number = np.searchsorted(first_sections(plates), results.elements.section[elements], side="right") - 1
    return np.asarray(np.array([plate.name for plate in plates])[number] == name)


def factored_sum(results: CombinationResult, force: Mapping[str, float]) -> float:
    """Return the sum of forces by load case [N], each with the factor of its case in a combination."""
    factors = factors_of(results)
    return sum(factors.get(case, 0.0) * of_case for case, of_case in force.items())


def factored_sums(results: CombinationResult, sums: Mapping[str, Array]) -> Array:
    """Return the sum of values (3,) by load case, those of each case with its factor in a combination."""
    factors = factors_of(results)
    return sum((factors.get(case, 0.0) * of_case for case, of_case in sums.items()), np.zeros(3))


def factors_of(results: CombinationResult) -> dict[str, float]:
    """Return the factors of the load cases in a combination, those of the building above among them."""
    factors = dict(results.factors) if results.solved_model.cases else {"": 1.0}
    return factors | building_factors(results)


def _pieces(part: Polygon, area: BaseGeometry) -> list[Polygon]:
    """Return the polygons that two areas have in common."""
    from shapely import get_parts, intersection

    return [piece for piece in get_parts(intersection(part, area)) if piece.geom_type == "Polygon" and piece.area > 0]


def _on_line(line: Sequence[LinePiece], part: Polygon, chord: float) -> Array:
    """Return force and first moments (3,) of the pieces of a line force on a part of the plate."""
    from shapely import LineString, Point, get_coordinates, get_parts, intersection

    sums = np.zeros(3)
    for piece in line:
        n = piece.edge.chords(chord)
        places = np.arange(n + 1) / n
        flat = LineString(piece.edge.at(places))
        for inside in get_parts(intersection(flat, part)):
            if inside.length > 0:
                # the force of a linear q is that in the middle of the way times the length
                ways = [flat.project(Point(end)) / flat.length for end in get_coordinates(inside)[[0, -1]]]
                q = piece.q[0] + (piece.q[1] - piece.q[0]) * sum(ways) / 2
                force = q * inside.length / flat.length * piece.edge.length
                sums += force * np.array([1.0, inside.centroid.x, inside.centroid.y])
    return sums


def _stands_near(name: str, model: Model, part: Polygon) -> bool:
    """Return whether a column stands on a part of the plate."""
    column = next(column for column in model.columns if column.name == name)
    return bool(column.to_shapely(FLAT * max(model.sides)).intersects(part))


def _on_footprint(point: PointForce, part: Polygon, chord: float) -> Array:
    """Return force and first moments (3,) of a point force on a part, by its pressure where it has a footprint."""
    place = point.to_shapely(chord)
    if point.ring is None:
        return point.P * np.array([1.0, *point.place]) if part.covers(place) else np.zeros(3)
    pressure = point.pressure(place)
    sums = np.zeros(3)
    for piece in _pieces(part, place):
        middle = np.array(piece.centroid.coords[0])
        # a linear pressure is that at the center times the area
        sums += float(pressure(middle) * piece.area) * np.array([1.0, *middle])
    return sums
