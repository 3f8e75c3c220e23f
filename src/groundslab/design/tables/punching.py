"""What punches at each column in each ultimate combination, at its face and at 2 d (EN 1992-1-1 6.4.3 to 6.4.5)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from groundslab.arrays import Array, Memo
from groundslab.design import punching
from groundslab.design.punching import OPENING_REACH, RectangularColumn, RoundColumn
from groundslab.design.tables import column_loads
from groundslab.design.tables.quantities import solved_results
from groundslab.errors import InputError
from groundslab.fem import load_vectors
from groundslab.fem.assembly import scatter
from groundslab.fem.mesh import Mesh
from groundslab.model.columns import Column
from groundslab.model.outputs import Reinforcement
from groundslab.model.supports import LineSupport
from groundslab.results.results import CombinationResult, Results

if TYPE_CHECKING:
    from shapely import Polygon


@dataclass(frozen=True, slots=True)
class Around:
    """A perimeter around a column, and what is the same inside it in every combination."""

    u: float  # its length that counts [m]
    area: Array  # (n,): each node's share of the area inside it [m2]
    others: Mapping[str, float]  # other loads inside [N], by load case
    supported: bool  # whether a support stands inside, which is not counted


@dataclass(frozen=True, slots=True)
class Stress:
    """The demand on a perimeter: beta for eccentric forces is not in it."""

    V_Ed: float  # load + others - pressure [N]
    v_Ed: float  # V_Ed / (u d) [Pa]
    u: float  # [m]
    pressure: float  # contact pressure inside [N]
    others: float  # other loads inside [N]
    supported: bool  # whether a support stands inside, whose force is not in V_Ed


@dataclass(frozen=True, slots=True)
class Demand:
    """What punches at a column that pushes down in one combination."""

    column: str
    combination: str
    d: float  # effective depth [m]
    face: Stress | None
    at_2d: Stress | None  # None, as at the face, where there is no such perimeter on the plate


@dataclass(frozen=True, slots=True)
class Demands:
    """The demands at all columns: by combination and column, and why some have none at 2 d, by column."""

    found: Mapping[tuple[str, str], Demand]
    missing: Mapping[str, str]


def demands(combined: Results) -> Demands:
    """Return the demands of punching in all ultimate combinations, if bars are given; at columns that push down."""
    model, steel = combined.model, combined.model.reinforcement
    results = [each for each in solved_results(combined) if each.limit_state == "ultimate"]
    found: dict[tuple[str, str], Demand] = {}
    missing: dict[str, str] = {}
    for column in model.columns if steel is not None else ():
        own = column_loads.sum_of_column(model, column.name)
        pushing = [(each, force) for each in results if (force := column_loads.factored_sum(each, own)) > 0]
        if not pushing:
            continue
        assert steel is not None
        first = pushing[0][0]
        known = _PLACES.get(first.plate.nodes, model, dict)
        if column.name not in known:
            known[column.name] = _place(first, column, steel)
        place = known[column.name]
        if place.why:
            missing[column.name] = place.why
        for each, force in pushing:
            around = place.face, place.at_2d
            stresses = [None if part is None else _stress(each, part, force, place.d) for part in around]
            found[each.combination, column.name] = Demand(column.name, each.combination, place.d, *stresses)
    return Demands(found, missing)


@dataclass(frozen=True, slots=True)
class _Place:
    """What punching of a column needs that is the same in every combination."""

    d: float  # effective depth [m]
    face: Around | None
    at_2d: Around | None
    why: str  # one of them is missing; else empty


#: Those of the columns of a model, by its mesh.
_PLACES: Memo[dict[str, _Place]] = Memo()


def _place(results: CombinationResult, column: Column, steel: Reinforcement) -> _Place:
    """Return the perimeters around a column, or why there are none."""
    plate, shape, around = results.plate, _shape(column), list[Around]()
    d = _depth(results, shape, steel)
    why = ""
    try:
        u = punching.face_length(plate, shape, d)
        around.append(_around(results, column, shape.footprint(), u))
        line = punching.perimeter(plate, shape, 2 * d, OPENING_REACH * d)
        around.append(_around(results, column, line.inside, line.u))
    except InputError as error:
        why = str(error)
    face, at_2d, *_ = [*around, None, None]
    return _Place(d, face, at_2d, why)


def _shape(column: Column) -> RectangularColumn | RoundColumn:
    """Return a column's footprint for punching."""
    if column.diameter is not None:
        return RoundColumn(column.x, column.y, column.diameter)
    assert column.width_x is not None
    assert column.width_y is not None
    return RectangularColumn(column.x, column.y, column.width_x, column.width_y)


def _depth(results: CombinationResult, shape: RectangularColumn | RoundColumn, steel: Reinforcement) -> float:
    """Return the least thickness under a column less the mean distance of the bottom bars' axes [m]."""
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    elements = load_vectors.find_elements_near(mesh, shape.footprint())
    covered = load_vectors.integrate_over_polygon(mesh, elements, shape.footprint()).sum(axis=1)
    under = elements[covered > 1e-9 * covered.max()]
    return float(results.elements.thickness[under].min()) - sum(steel.bottom) / 2


def _around(results: CombinationResult, column: Column, part: Polygon, u: float) -> Around:
    """Return a perimeter around a part of the plate with what is inside it."""
    from shapely import LineString, Point

    mesh = Mesh(results.plate.nodes, results.plate.elements)
    elements = load_vectors.find_elements_near(mesh, part)
    area = scatter(mesh.elements[elements], load_vectors.integrate_over_polygon(mesh, elements, part), len(mesh.nodes))
    supports = (
        LineString(each.points) if isinstance(each, LineSupport) else Point(each.x, each.y)
        for each in results.model.supports
    )
    return Around(u, area, column_loads.sum_of_others(results, part, column.name), any(map(part.intersects, supports)))


def _stress(results: CombinationResult, around: Around, force: float, d: float) -> Stress:
    """Return the demand of a column's force [N] on a perimeter in a combination (see punching.demand)."""
    others = column_loads.factored_sum(results, around.others)
    pressure = float(around.area @ (results.plate.contact_force / results.plate.area))
    V_Ed = force + others - pressure
    return Stress(V_Ed, V_Ed / (around.u * d), around.u, pressure, others, around.supported)
