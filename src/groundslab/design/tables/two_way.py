"""What punches at each column in each ultimate combination by ACI 318-19 22.6 and 8.4.4.2, at d / 2 from its faces."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from groundslab.arrays import Array, Memo
from groundslab.design import punching
from groundslab.design.aci318 import punching as aci318
from groundslab.design.aci318.materials import PHI_SHEAR
from groundslab.design.by_plate import plate_under
from groundslab.design.punching import OPENING_REACH
from groundslab.design.tables import column_loads, reinforcement
from groundslab.design.tables.punching import Around, around_column, depth_under, forces_inside, shape_of_column
from groundslab.errors import InputError
from groundslab.model.columns import Column
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult, Results


@dataclass(frozen=True, slots=True)
class TwoWay:
    """The demand on the critical section of a column that pushes down in one combination."""

    column: str
    combination: str
    d: float  # effective depth [m]
    b_o: float  # length of the critical section that counts [m]
    beta: float  # long side of the column over the short one
    alpha_s: float
    V_u: float  # load + others - pressure [N]
    v_u: float  # with the moments that shear transfers [Pa]
    pressure: float  # contact pressure inside [N]
    others: float  # other loads inside [N]
    supported: bool  # whether a support stands inside, whose force is not in V_u
    place: tuple[float, float]  # of the column [m]


@dataclass(frozen=True, slots=True)
class _Section:
    """The critical section of a column."""

    d: float
    around: Around
    legs: Array  # (l, 2, 2): its sides along the edge and across it, about their centroid [m]
    beta: float


#: Those of the columns of a model, or why there is none, by its mesh.
_SECTIONS: Memo[dict[str, _Section | str]] = Memo()


def two_way(combined: Results) -> tuple[dict[tuple[str, str], TwoWay], Mapping[str, str]]:
    """Return the demands by combination and column, at columns that push down, and why columns have none."""
    model, steel = combined.model, combined.model.reinforcement
    found: dict[tuple[str, str], TwoWay] = {}
    missing: dict[str, str] = {}
    if steel is None:
        return found, missing
    results = reinforcement.ultimate_results(combined)
    for column in model.columns:
        own = column_loads.sum_of_column(model, column.name)
        pushing = [(each, force) for each in results if (force := column_loads.factored_sum(each, own)) > 0]
        if not pushing:
            continue
        section = _section(pushing[0][0], column, model, steel)
        if isinstance(section, str):
            missing[column.name] = section
            continue
        for each, force in pushing:
            found[each.combination, column.name] = _demand(each, section, column, force)
    return found, missing


def _section(results: CombinationResult, column: Column, model: Model, steel: Reinforcement) -> _Section | str:
    """Return the critical section of a column, or why there is none."""
    known = _SECTIONS.get(results.plate.nodes, model, dict)
    if column.name not in known:
        known[column.name] = _made(results, column, steel)
    return known[column.name]


def _made(results: CombinationResult, column: Column, steel: Reinforcement) -> _Section | str:
    """Return the critical section at d / 2 from a column's faces, or why there is none."""
    shape = shape_of_column(column)
    d = depth_under(results, shape, steel)
    try:
        plate = plate_under(results, column.x, column.y)
        line = punching.perimeter(plate, shape, d / 2, OPENING_REACH * d, square=True)
        if punching.shape_of(line.legs)[0] == "cut":
            return "its critical section cuts the slab from edge to edge, which is one-way shear"
        around = around_column(results, column, line, d / 2, line.u, d)
    except InputError as error:
        return str(error)
    sides = column.width_x or 1.0, column.width_y or 1.0  # a round column has none, and beta = 1
    return _Section(d, around, (line.legs - around.center) @ around.frame.T, max(sides) / min(sides))


def _demand(results: CombinationResult, section: _Section, column: Column, force: float) -> TwoWay:
    """Return the demand of a column's force [N] on its critical section."""
    around, d = section.around, section.d
    V_u, moments, pressure, others = forces_inside(results, around, column, force)
    v_u = aci318.stress(V_u, list(around.frame @ moments), section.legs, around.u, d)
    return TwoWay(
        column.name, results.combination, d, around.u, section.beta, aci318.ALPHA_S[around.shape], V_u, v_u, pressure,
        others, around.supported, (column.x, column.y),
    )  # fmt: skip


def strength(demand: TwoWay, steel: Reinforcement) -> float:
    """Return phi v_c [Pa] of a critical section without shear reinforcement."""
    concrete, _ = reinforcement.aci318_materials(steel)
    v_c = aci318.without_links(concrete, demand.d, demand.b_o, demand.beta, demand.alpha_s)
    return PHI_SHEAR * v_c
