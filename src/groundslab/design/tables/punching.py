"""What punches at each column in each ultimate combination, at its face and around it (EN 1992-1-1 6.4.3 to 6.4.5).

Foundations are checked on all perimeters within 2 d (6.4.4(2)): on those of DISTANCES here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from groundslab.arrays import Array, Memo
from groundslab.design import punching
from groundslab.design.en1992 import punching as en1992
from groundslab.design.punching import OPENING_REACH, Perimeter, RectangularColumn, RoundColumn
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

#: Where perimeters run, from the column's face, over the effective depth.
DISTANCES = (0.5, 1.0, 1.5, 2.0)


@dataclass(frozen=True, slots=True)
class Around:
    """A perimeter around a column, and what is the same inside it in every combination."""

    distance: float  # from the column's face [m]
    u: float  # its length that counts [m]
    area: Array  # (n,): each node's share of the area inside it [m2]
    others: Mapping[str, float]  # other loads inside [N], by load case
    supported: bool  # whether a support stands inside, which is not counted
    center: tuple[float, float]  # of the perimeter [m]
    moduli: tuple[float, float]  # W along x and along y, about the center [m2]
    middle: tuple[float, float]  # of the area inside [m]


@dataclass(frozen=True, slots=True)
class Stress:
    """The demand on a perimeter."""

    distance: float  # from the column's face [m]
    V_Ed: float  # load + others - pressure [N]
    beta: float  # by the moments about the perimeter's center (expression 6.51)
    v_Ed: float  # beta V_Ed / (u d) [Pa]
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
    around: tuple[Stress, ...]  # at DISTANCES; fewer, as at the face, where there is no such perimeter on the plate

    @property
    def at_2d(self) -> Stress | None:
        """Return the demand at 2 d."""
        return self.around[-1] if len(self.around) == len(DISTANCES) else None


@dataclass(frozen=True, slots=True)
class Demands:
    """The demands at all columns: by combination and column, and why some have none at 2 d, by column."""

    found: Mapping[tuple[str, str], Demand]
    missing: Mapping[str, str]
    places: Mapping[str, tuple[float, float]]  # of all columns [m]


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
            stresses = [_stress(each, part, column, force, place.d) for part in place.around]
            # the beta of the perimeter at 2 d holds at the face, too
            face = None if place.face is None else _stress(each, place.face, column, force, place.d, stresses[-1:])
            found[each.combination, column.name] = Demand(column.name, each.combination, place.d, face, tuple(stresses))
    return Demands(found, missing, {column.name: (column.x, column.y) for column in model.columns})


@dataclass(frozen=True, slots=True)
class _Place:
    """What punching of a column needs that is the same in every combination."""

    d: float  # effective depth [m]
    face: Around | None
    around: tuple[Around, ...]
    why: str  # one of them is missing; else empty


#: Those of the columns of a model, by its mesh.
_PLACES: Memo[dict[str, _Place]] = Memo()


def _place(results: CombinationResult, column: Column, steel: Reinforcement) -> _Place:
    """Return the perimeters around a column, or why there are none."""
    plate, shape, around = results.plate, _shape(column), list[Around]()
    d, face, why = _depth(results, shape, steel), None, ""
    try:
        u = punching.face_length(plate, shape, d)
        face = _around(results, column, punching.perimeter(plate, shape, 0.0, 0.0), 0.0, u)
        for ratio in DISTANCES:
            line = punching.perimeter(plate, shape, ratio * d, OPENING_REACH * d)
            around.append(_around(results, column, line, ratio * d, line.u))
    except InputError as error:
        why = str(error)
    return _Place(d, face, tuple(around), why)


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


def _around(results: CombinationResult, column: Column, line: Perimeter, distance: float, u: float) -> Around:
    """Return a perimeter around a column with what is inside it."""
    from shapely import LineString, Point

    part, mesh = line.inside, Mesh(results.plate.nodes, results.plate.elements)
    elements = load_vectors.find_elements_near(mesh, part)
    area = scatter(mesh.elements[elements], load_vectors.integrate_over_polygon(mesh, elements, part), len(mesh.nodes))
    supports = (
        LineString(each.points) if isinstance(each, LineSupport) else Point(each.x, each.y)
        for each in results.model.supports
    )
    center = punching.centroid(line.legs)
    W_x, W_y = punching.moduli(line.legs, center)
    others = column_loads.sum_of_others(results, part, column.name)
    supported = any(map(part.intersects, supports))
    middle = part.centroid.x, part.centroid.y
    return Around(distance, u, area, others, supported, (center[0], center[1]), (W_x, W_y), middle)


def _stress(
    results: CombinationResult, around: Around, column: Column, force: float, d: float, like: Sequence[Stress] = ()
) -> Stress:
    """Return the demand of a column's force [N] on a perimeter in a combination (see punching.demand).

    The moments are those of all forces inside about the perimeter's center, of loads and pressure; other loads act in
    the middle of the area inside. `like` holds a demand whose beta is taken instead, if any.
    """
    others = column_loads.factored_sum(results, around.others)
    carried = around.area * (results.plate.contact_force / results.plate.area)
    pressure = float(carried.sum())
    V_Ed = force + others - pressure
    own = column_loads.moments_of_column(results.model, column.name)
    moments = [
        column_loads.factored_sum(results, own[axis])
        + force * (place - around.center[axis])
        + others * (around.middle[axis] - around.center[axis])
        - float(carried @ (results.plate.nodes[:, axis] - around.center[axis]))
        for axis, place in enumerate((column.x, column.y))
    ]
    c_x, c_y = (column.width_x, column.width_y) if column.diameter is None else (1.0, 1.0)
    assert c_x is not None
    assert c_y is not None
    shares = en1992.transfer_share(c_x / c_y), en1992.transfer_share(c_y / c_x)
    beta = en1992.beta(moments, shares, V_Ed, around.u, around.moduli) if V_Ed > 0 else 1.0
    beta = like[0].beta if like else beta
    v_Ed = beta * V_Ed / (around.u * d)
    return Stress(around.distance, V_Ed, beta, v_Ed, around.u, pressure, others, around.supported)
