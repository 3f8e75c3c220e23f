"""The loads that act on a part of the plate, case by case."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, assert_never

import numpy as np

from groundslab.arrays import Array, Flags, Integers
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


def by_column(model: Model, name: str) -> dict[str, Array]:
    """Return the sums of P [N], M_x and M_y [N m] (3,) of the point loads that name a column, by load case."""
    sums: dict[str, Array] = defaultdict(lambda: np.zeros(3))
    for load in model.loads:
        if isinstance(load, load_types.PointLoad) and load.column == name:
            sums[load.case] += (load.P, load.M_x, load.M_y)
    return dict(sums)


def sum_of_others(results: CombinationResult, part: Polygon, column: str) -> dict[str, float]:
    """Return the sum of all loads on a part of the plate but those that name a column [N], by load case."""
    return {case: float(sums[0]) for case, sums in acting_inside(results, part, column).items()}


def loads_around(model: Model, part: Polygon, column: str) -> tuple[load_types.AnyLoad, ...]:
    """Return the loads of a model that may press a part of the plate, without those that name a column."""
    return tuple(
        load
        for load in model.loads
        if not load_types.presses_ground(load)
        and not (isinstance(load, load_types.PointLoad) and (load.column == column or not _may_meet(load, model, part)))
    )


def acting_inside(
    results: CombinationResult,
    part: Polygon,
    column: str,
    loads: Sequence[load_types.AnyLoad] | None = None,
    shares: tuple[Integers, Array] | None = None,
) -> dict[str, Array]:
    """Return force [N] and first moments int q x dA, int q y dA [N m] (3,) of loads on a part, by load case.

    Parameters
    ----------
    results : CombinationResult
        The results whose mesh and model are meant.
    part : shapely.Polygon
        Part of the plate.
    column : str
        Loads that name this column are left out.
    loads : sequence of loads, optional
        Those that may press the part (see `loads_around`); all of the model by default.
    shares : ((k,) array of int, (k, 9) array), optional
        Elements that may meet the part and int N dA over it [m2], if they are known.

    Returns
    -------
    dict of str to (3,) array
        The sums by load case.
    """
    model, mesh = results.model, Mesh(results.plate.nodes, results.plate.elements)
    chord = FLAT * max(model.sides)
    if shares is None:
        near = load_vectors.find_elements_near(mesh, part)
        shares = near, load_vectors.integrate_over_polygon(mesh, near, part)
    inside = _Inside(results, mesh, part, *shares)
    sums: dict[str, Array] = defaultdict(lambda: np.zeros(3))
    for load in loads_around(model, part, column) if loads is None else loads:
        if isinstance(load, load_types.UniformLoad):
            sums[load.case] += inside.uniform(load)
        elif isinstance(load, load_types.PatchLoad | load_types.AreaLoad):
            for piece in _pieces(part, load.to_shapely(chord)):
                sums[load.case] += inside.pressed(inside.elements, piece, load_types.pressure_function(load))
        elif isinstance(load, load_types.SelfWeight):
            sums[load.case] += inside.weight(load)
        elif isinstance(load, load_types.LineLoad):
            sums[load.case] += _on_line(load, model, part, chord)
        elif isinstance(load, load_types.PointLoad):
            sums[load.case] += _on_footprint(load.on(model.columns), part, chord)
        elif not isinstance(load, load_types.TemperatureLoad | load_types.ShrinkageLoad | load_types.SettlementLoad):
            assert_never(load)
    return dict(sums)


@dataclass(frozen=True, slots=True)
class _Inside:
    """A part of the plate, and what its elements have inside it."""

    results: CombinationResult
    mesh: Mesh
    part: Polygon
    elements: Integers
    shares: Array  # (k, 9): int N dA over the part [m2]

    def sums(self, elements: Integers, forces: Array) -> Array:
        """Return force and first moments (3,) of nodal forces (k, 9) [N] of elements (k,)."""
        first = np.einsum("ea,eax->x", forces, self.mesh.nodes[self.mesh.elements[elements]])
        return np.array([forces.sum(), *first])

    def pressed(self, elements: Integers, piece: Polygon, pressure: load_vectors.Pressure) -> Array:
        """Return force and first moments (3,) of a pressure on a piece."""
        return self.sums(elements, load_vectors.integrate_over_polygon(self.mesh, elements, piece, pressure))

    def uniform(self, load: load_types.UniformLoad) -> Array:
        """Return force and first moments (3,) of a pressure all over a plate."""
        of_plate = _of_plate(self.results, self.elements, load.plate)
        if load.slope == load_types.NO_SLOPE and load.bend == load_types.NO_BEND:
            return self.sums(self.elements[of_plate], load.q * self.shares[of_plate])
        return self.pressed(self.elements[of_plate], self.part, load_types.pressure_function(load))

    def weight(self, load: load_types.SelfWeight) -> Array:
        """Return force and first moments (3,) of a plate's weight."""
        of_plate = _of_plate(self.results, self.elements, load.plate)
        thickness = self.results.elements.thickness[self.elements[of_plate], None]
        return self.sums(self.elements[of_plate], load.unit_weight * thickness * self.shares[of_plate])


def _of_plate(results: CombinationResult, elements: Integers, name: str) -> Flags:
    """Return which of some elements belong to the plate of a name; all of them if there is none."""
    if not name:
        return np.ones(len(elements), dtype=bool)
    plates = results.model.every_plate
    number = np.searchsorted(first_sections(plates), results.elements.section[elements], side="right") - 1
    return np.asarray(np.array([plate.name for plate in plates])[number] == name)


def factored_sum(results: CombinationResult, force: Mapping[str, float]) -> float:
    """Return the sum of forces by load case [N], each with the factor of its case in a combination."""
    factors = dict(results.factors) if results.model.cases else {"": 1.0}
    return sum(factors.get(case, 0.0) * of_case for case, of_case in force.items())


def factored_sums(results: CombinationResult, sums: Mapping[str, Array]) -> Array:
    """Return the sum of values (3,) by load case, those of each case with its factor in a combination."""
    factors = dict(results.factors) if results.model.cases else {"": 1.0}
    return sum((factors.get(case, 0.0) * of_case for case, of_case in sums.items()), np.zeros(3))


def _pieces(part: Polygon, area: BaseGeometry) -> list[Polygon]:
    """Return the polygons that two areas have in common."""
    from shapely import get_parts, intersection

    return [piece for piece in get_parts(intersection(part, area)) if piece.geom_type == "Polygon" and piece.area > 0]


def _on_line(load: load_types.LineLoad, model: Model, part: Polygon, chord: float) -> Array:
    """Return force and first moments (3,) of a line load on a part of the plate."""
    from shapely import LineString, Point, get_coordinates, get_parts, intersection

    sums = np.zeros(3)
    for piece in clip_line_load(model.plate, load, model.plates):
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


def _may_meet(load: load_types.PointLoad, model: Model, part: Polygon) -> bool:
    """Return whether a load that names a column may stand on a part of the plate, by the column's place."""
    named = [each for each in model.columns if each.name == load.column]
    return not named or bool(named[0].to_shapely(FLAT * max(model.sides)).intersects(part))


def _on_footprint(load: load_types.PointLoad, part: Polygon, chord: float) -> Array:
    """Return force and first moments (3,) of a point load on a part, by its pressure where it has a footprint."""
    place = load.to_shapely(chord)
    if place.geom_type == "Point":
        return load.P * np.array([1.0, place.x, place.y]) if part.covers(place) else np.zeros(3)
    center, inertia = load_vectors.inertia(place)
    slope = np.array([load.M_x, load.M_y]) @ np.linalg.inv(inertia)
    sums = np.zeros(3)
    for piece in _pieces(part, place):
        middle = np.array(piece.centroid.coords[0])
        force = float((load.P / place.area + (middle - center) @ slope) * piece.area)
        sums += force * np.array([1.0, *middle])
    return sums
