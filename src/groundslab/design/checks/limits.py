"""Settlements, tilt and pressures against the limits of a case, over all combinations of serviceability.

Tilt and angular distortion are those of `design/tilt`; the limits are the engineer's, such as those of EN 1997-1
Annex H: an angular distortion (relative rotation) of 1/500 is acceptable for many structures.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from groundslab.accuracy.singularities import find_limits
from groundslab.accuracy.values import error_of_contact_share
from groundslab.design.basis.check import DesignCheck
from groundslab.design.basis.combinations import solved_results, why_none
from groundslab.design.basis.demand_errors import error_at_nodes, error_of, scaled
from groundslab.design.by_plate import results_by_plate
from groundslab.design.demands.edge_strip import spread_edge_force, strip_width
from groundslab.design.tilt import deflections_between, settlement_differences, tilt
from groundslab.model.loads.load_cases import SERVICEABILITY
from groundslab.model.plates.region import PlateRegion
from groundslab.results.fields import extreme
from groundslab.results.mesh_results import PlateResult
from groundslab.results.results import CombinationResult, Results

#: What a combination demands: the value in SI units, what it is about, and its place [m].
Demand = tuple[float, str, tuple[float, float] | None]


@dataclass(frozen=True, slots=True)
class Limit:
    """How a limit of the case is checked: its name, unit and scale of display, and the demand of a combination.

    The error of the demand is that of a value of the whole slab, unless another function gives it.
    """

    name: str
    unit: str
    scale: float
    demand: Callable[[CombinationResult], Demand | None]
    least: bool = False
    error: Callable[[CombinationResult], float | None] | None = None

    def error_of(self, results: CombinationResult) -> float | None:
        """Return the discretization error of the demand of a combination [SI]."""
        if self.error is not None:
            return self.error(results)
        return error_of(results, lambda mesh: (self.demand(mesh) or (math.nan,))[0])


def _extreme(field: str, sign: int) -> Callable[[CombinationResult], Demand]:
    """Return a function that finds the largest value of a nodal field, or of its negative."""

    def find(results: CombinationResult) -> Demand:
        value, place = extreme(results.plate.nodes, getattr(results.plate, field), sign)
        return max(sign * value, 0.0), "", place

    return find


def _error_of_extreme(field: str, sign: int) -> Callable[[CombinationResult], float | None]:
    """Return a function that finds the error of the largest value of a nodal field, or of its negative."""

    def find(results: CombinationResult) -> float | None:
        error = error_at_nodes(results, field, lambda mesh: sign * getattr(mesh.plate, field))
        # what is below zero is no demand
        most = float((sign * getattr(results.plate, field)).max())
        return None if error is None else max(most + error, 0.0) - max(most, 0.0)

    return find


def _difference(results: CombinationResult) -> Demand:
    """Return the largest less the smallest settlement of a plate."""
    return max((float(np.ptp(plate.settlement)), name, None) for name, plate in results_by_plate(results).items())


def _tilt(results: CombinationResult) -> Demand:
    """Return the slope of the plane that fits the settlements best."""
    return max((tilt(plate).tilt, name, None) for name, plate in results_by_plate(results).items())


def _distortion(results: CombinationResult) -> Demand | None:
    """Return the largest angular distortion without tilt between two columns on a plate, None of fewer."""
    demands: list[Demand] = []
    for plate, columns in _columns_by_plate(results):
        differences = settlement_differences(plate, columns)
        worst = int(np.argmax(differences.relative))
        first, second = differences.names[differences.first[worst]], differences.names[differences.second[worst]]
        demands.append((float(differences.relative[worst]), f"{first} - {second}", columns[second]))
    return max(demands, key=lambda demand: demand[0], default=None)


def _deflection(results: CombinationResult) -> Demand | None:
    """Return the largest sag between two neighboring columns over their distance, None of fewer."""
    demands: list[Demand] = []
    for plate, columns in _columns_by_plate(results):
        first, second, ratio = max(deflections_between(plate, columns), key=lambda deflection: deflection[2])
        (x0, y0), (x1, y1) = columns[first], columns[second]
        demands.append((ratio, f"{first} - {second}", ((x0 + x1) / 2, (y0 + y1) / 2)))
    return max(demands, key=lambda demand: demand[0], default=None)


def _columns_by_plate(results: CombinationResult) -> Iterator[tuple[PlateResult, dict[str, tuple[float, float]]]]:
    """Yield each plate with two columns and more, and their places [m]; columns at one place are one point."""
    model = results.model
    names = {(column.x, column.y): column.name for column in model.columns}
    region = PlateRegion(model.plate, model.plates)
    on = {place: region.plate_at(place) for place in names}
    for number, plate in enumerate(results_by_plate(results).values()):
        columns = {name: place for place, name in names.items() if on[place] == number}
        if len(columns) > 1:
            yield plate, columns


def _pressure(results: CombinationResult) -> Demand:
    """Return the largest pressure, the line force along the plate's edge spread over a strip beside it."""
    spread = spread_edge_force(results)
    value, place = extreme(spread.nodes, spread.pressure, 1)
    node = int(np.argmax((spread.nodes == place).all(axis=1) & (spread.pressure == value)))
    by_edge = spread.pressure[node] - results.plate.pressure[node]
    if by_edge <= 0:
        return value, "", place
    return value, f"with {by_edge / 1e3:.4g} kPa of the edge's line force over {strip_width(results):.3g} m", place


def _error_of_pressure(results: CombinationResult) -> float | None:
    """Return the error of the largest pressure, None where it has no limit as the mesh is refined."""
    judged = find_limits(results.solved_model, results.plate).pressures
    if not judged[np.argmax(spread_edge_force(results).pressure)]:
        return None
    return error_at_nodes(results, "pressure", lambda mesh: spread_edge_force(mesh).pressure[judged], judged)


def _mean_pressure(results: CombinationResult) -> Demand:
    """Return the ground's force over the area in contact, of several plates the largest."""
    pressures = []
    for name, plate in results_by_plate(results).items():
        area = plate.contact_share * plate.area.sum()
        pressures.append((float(plate.contact_force.sum() / area) if area else 0.0, name, None))
    return max(pressures)


def _contact(results: CombinationResult) -> Demand:
    """Return the share of a plate's area that is in contact, of several plates the least."""
    return min((plate.contact_share, name, None) for name, plate in results_by_plate(results).items())


def _error_of_contact(results: CombinationResult) -> float | None:
    """Return the error of the share that is in contact; of several plates all of it may be that of one."""
    least = min(results_by_plate(results).values(), key=lambda plate: plate.contact_share)
    return scaled(error_of_contact_share(results), float(results.plate.area.sum() / least.area.sum()))


#: By the keys of [limits].
LIMITS = {
    "settlement": Limit("settlement", "mm", 1e3, _extreme("settlement", 1), error=_error_of_extreme("settlement", 1)),
    "uplift": Limit("uplift", "mm", 1e3, _extreme("settlement", -1), error=_error_of_extreme("settlement", -1)),
    "differential_settlement": Limit("differential settlement", "mm", 1e3, _difference),
    "tilt": Limit("tilt", "mm/m", 1e3, _tilt),
    "angular_distortion": Limit("angular distortion", "mm/m", 1e3, _distortion),
    "deflection": Limit("deflection between columns", "mm/m", 1e3, _deflection),
    "pressure": Limit("pressure", "kPa", 1e-3, _pressure, error=_error_of_pressure),
    "mean_pressure": Limit("mean pressure", "kPa", 1e-3, _mean_pressure),
    "contact_share": Limit("area in contact", "%", 1e2, _contact, least=True, error=_error_of_contact),
}


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the check of each limit of the case, with the combination that governs it."""
    limits = combined.model.limits
    if limits is None:
        return
    results = [result for result in solved_results(combined) if result.limit_state in SERVICEABILITY]
    for key, limit in LIMITS.items():
        allowed: float | None = getattr(limits, key)
        if allowed is not None:
            missing = why_none(combined, SERVICEABILITY, "serviceability combination")
            yield _check(limit, allowed * limit.scale, results, missing)


def _check(limit: Limit, allowed: float, results: list[CombinationResult], missing: str) -> DesignCheck:
    """Return the check of one limit in its unit of display; `missing` says why there are no results, if so."""
    demands = [(demand, result) for result in results if (demand := limit.demand(result)) is not None]
    if not demands:
        what = "there are no two columns" if results else missing
        return DesignCheck(limit.name, "attention", f"not checked: {what}", resistance=allowed, unit=limit.unit)
    (value, of, place), governing = (min if limit.least else max)(demands, key=lambda entry: entry[0][0])
    value *= limit.scale
    holds = value >= allowed if limit.least else value <= allowed
    sign = (">=" if holds else "<") if limit.least else ("<=" if holds else ">")
    where = f" at ({place[0]:.3f}, {place[1]:.3f}) m" if place is not None else ""
    about = f"{of}: " if of else ""
    return DesignCheck(
        limit.name,
        "no failure found" if holds else "fails",
        f'{about}{value:.4g} {sign} {allowed:.4g} {limit.unit}{where} in "{governing.combination}"',
        of=of,
        demand=value,
        resistance=allowed,
        unit=limit.unit,
        least=limit.least,
        clause="limits of the case",
        combination=governing.combination,
        place=place,
        error=scaled(limit.error_of(governing), limit.scale),
    )
