"""What punches at each column in each ultimate combination, at its face and around it (EN 1992-1-1 6.4.3 to 6.4.5).

Foundations are checked on all perimeters within 2 d (6.4.4(2)): on those of DISTANCES here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array, Memo
from groundslab.design import punching
from groundslab.design.by_plate import plate_under
from groundslab.design.en1992 import punching as en1992
from groundslab.design.punching import OPENING_REACH, Perimeter, RectangularColumn, RoundColumn, Shape
from groundslab.design.tables import column_loads, reinforcement
from groundslab.errors import InputError
from groundslab.fem import load_vectors
from groundslab.fem.assembly import scatter
from groundslab.fem.mesh import Mesh
from groundslab.model.columns import Column
from groundslab.model.design.reinforcement import Reinforcement
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
    center: Array  # (2,): of the perimeter [m]
    middle: Array  # (2,): of the area inside [m]
    shape: Shape
    frame: Array  # (2, 2): unit vectors along the edge and across it; x and y of a closed one
    moduli: Array  # (2,): W of places along both, about the center [m2]
    shares: Array  # (2,): k of Table 6.1 for moments of forces along both
    reduced: float  # u_1* / u_1 of a perimeter at an edge, else 1


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
    limit_state: str
    d: float  # effective depth [m]
    face: Stress | None
    around: tuple[Stress, ...]  # at DISTANCES; fewer, as at the face, where there is no such perimeter on the plate

    @property
    def at_2d(self) -> Stress | None:
        """Return the demand at 2 d, None where that perimeter cuts the slab from edge to edge or leaves the plate."""
        return self.around[-1] if len(self.around) == len(DISTANCES) else None


@dataclass(frozen=True, slots=True)
class Demands:
    """The demands at all columns: by combination and column, and why some have none at 2 d, by column."""

    found: Mapping[tuple[str, str], Demand]
    missing: Mapping[str, str]
    places: Mapping[str, tuple[float, float]]  # of all columns [m]
    reach: Mapping[str, float]  # how far from the face of a column punching is checked, the rest is one-way shear [m]


def demands(combined: Results) -> Demands:
    """Return the demands of punching in all ultimate combinations, if bars are given; at columns that push down."""
    model, steel = combined.model, combined.model.reinforcement
    results = reinforcement.ultimate_results(combined)
    found: dict[tuple[str, str], Demand] = {}
    missing: dict[str, str] = {}
    reach: dict[str, float] = {}
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
        # beyond d from the face, where uniform loads are, one-way shear is checked in any case (6.2.1(8))
        reach[column.name] = max(place.d, *(part.distance for part in place.around), 0.0)
        for each, force in pushing:
            stresses = [_stress(each, part, column, force, place.d) for part in place.around]
            outer = place.around[-1] if place.around else None
            face = None if place.face is None else _face_stress(each, place.face, outer, column, force, place.d)
            found[each.combination, column.name] = Demand(
                column.name, each.combination, each.limit_state, place.d, face, tuple(stresses)
            )
    return Demands(found, missing, {column.name: (column.x, column.y) for column in model.columns}, reach)


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
    plate, shape, around = plate_under(results, column.x, column.y), shape_of_column(column), list[Around]()
    d, face, why = depth_under(results, shape, steel), None, ""
    try:
        u = punching.face_length(plate, shape, d)
        face = around_column(results, column, punching.perimeter(plate, shape, 0.0, 0.0), 0.0, u, d)
        for ratio in DISTANCES:
            line = punching.perimeter(plate, shape, ratio * d, OPENING_REACH * d)
            if punching.shape_of(line.legs)[0] == "cut":
                why = "" if around else "its control perimeters cut the slab from edge to edge, which is one-way shear"
                break
            around.append(around_column(results, column, line, ratio * d, line.u, d))
    except InputError as error:
        why = str(error)
    return _Place(d, face, tuple(around), why)


def shape_of_column(column: Column) -> RectangularColumn | RoundColumn:
    """Return a column's footprint for punching."""
    if column.diameter is not None:
        return RoundColumn(column.x, column.y, column.diameter)
    assert column.width_x is not None
    assert column.width_y is not None
    return RectangularColumn(column.x, column.y, column.width_x, column.width_y)


def depth_under(results: CombinationResult, shape: RectangularColumn | RoundColumn, steel: Reinforcement) -> float:
    """Return the least thickness under a column less the mean distance of the bottom bars' axes [m]."""
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    elements = load_vectors.find_elements_near(mesh, shape.footprint())
    covered = load_vectors.integrate_over_polygon(mesh, elements, shape.footprint()).sum(axis=1)
    under = elements[covered > 1e-9 * covered.max()]
    return float(results.elements.thickness[under].min()) - sum(steel.bottom_axes) / 2


def around_column(
    results: CombinationResult, column: Column, line: Perimeter, distance: float, u: float, d: float
) -> Around:
    """Return a perimeter around a column with what is inside it."""
    from shapely import LineString, Point, get_coordinates

    part, mesh = line.inside, Mesh(results.plate.nodes, results.plate.elements)
    elements = load_vectors.find_elements_near(mesh, part)
    area = scatter(mesh.elements[elements], load_vectors.integrate_over_polygon(mesh, elements, part), len(mesh.nodes))
    supports = (
        LineString(each.points) if isinstance(each, LineSupport) else Point(each.x, each.y)
        for each in results.model.supports
    )
    center = punching.centroid(line.legs)
    shape, along = punching.shape_of(line.legs)
    frame = np.array([along, [-along[1], along[0]]])
    moduli = punching.moduli(line.legs @ frame.T, frame @ center)
    footprint = shape_of_column(column).footprint()
    extents = np.ptp(get_coordinates(footprint) @ frame.T, axis=0)
    shares = np.array([en1992.transfer_share(extents[0] / extents[1]), en1992.transfer_share(extents[1] / extents[0])])
    reduced = punching.reduced_share(line.legs, footprint, along, d) if shape == "edge" else 1.0
    others = column_loads.sum_of_others(results, part, column.name)
    supported = any(map(part.intersects, supports))
    middle = np.array([part.centroid.x, part.centroid.y])
    return Around(distance, u, area, others, supported, center, middle, shape, frame, moduli, shares, reduced)


def forces_inside(
    results: CombinationResult, around: Around, column: Column, force: float
) -> tuple[float, Array, float, float]:
    """Return V_Ed [N], the moments (2,) [N m] of all forces inside about the perimeter's center, pressure, other loads.

    The column's force [N] and its moments, loads and pressure [N] inside; other loads act in the middle of the area.
    """
    others = column_loads.factored_sum(results, around.others)
    carried = around.area * (results.plate.contact_force / results.plate.area)
    pressure = float(carried.sum())
    place = np.array([column.x, column.y])
    moments = _moments_of_column(results, column) + force * (place - around.center)
    moments = moments + others * (around.middle - around.center) - carried @ (results.plate.nodes - around.center)
    return force + others - pressure, moments, pressure, others


def _stress(results: CombinationResult, around: Around, column: Column, force: float, d: float) -> Stress:
    """Return the demand of a column's force [N] on a perimeter in a combination (see punching.demand).

    beta is that of the moments of all forces inside about the perimeter's center, of loads and pressure.
    """
    V_Ed, moments, pressure, others = forces_inside(results, around, column, force)
    beta = _beta(around, moments, V_Ed) if V_Ed > 0 else 1.0
    v_Ed = beta * V_Ed / (around.u * d)
    return Stress(around.distance, V_Ed, beta, v_Ed, around.u, pressure, others, around.supported)


def _face_stress(
    results: CombinationResult, face: Around, outer: Around | None, column: Column, force: float, d: float
) -> Stress:
    """Return the demand at the column's face (6.4.5(3)).

    beta is that of the column's own force and moments on the outermost perimeter; without any, on the face itself.
    """
    stress = _stress(results, face, column, force, d)
    beta = _beta(outer or face, _moments_of_column(results, column), force)
    return replace(stress, beta=beta, v_Ed=beta * stress.V_Ed / (face.u * d))


def _moments_of_column(results: CombinationResult, column: Column) -> Array:
    """Return the moments (2,) [N m] that a column brings about its center, of forces along x and along y."""
    own = column_loads.moments_of_column(results.solved_model, column.name)
    return np.array([column_loads.factored_sum(results, own[axis]) for axis in (0, 1)])


def _beta(around: Around, moments: Array, force: float) -> float:
    """Return beta of moments (2,) [N m] of forces along x and y about a perimeter's center (6.4.3, 6.4.4(2))."""
    if around.shape == "corner":
        return en1992.CORNER
    turned = around.frame @ moments
    if around.shape == "edge":
        along, share, W = float(turned[0]), float(around.shares[0]), float(around.moduli[0])
        return en1992.beta_at_an_edge(around.reduced, along, share, force, around.u, W)
    return en1992.beta(list(turned), list(around.shares), force, around.u, list(around.moduli))
