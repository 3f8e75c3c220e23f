"""Settlements, tilt and pressures against the limits of a case, over all combinations of serviceability.

Tilt and angular distortion are those of `design/demands/tilt`; the limits are the engineer's, such as those of
EN 1997-1 Annex H: an angular distortion (relative rotation) of 1/500 is acceptable for many structures.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from groundslab.accuracy.singularities import find_limits
from groundslab.accuracy.values import error_of_contact_share
from groundslab.design.checks import limit_steps
from groundslab.design.demands.by_plate import results_by_plate
from groundslab.design.demands.edge_strip import spread_edge_force, strip_of
from groundslab.design.demands.tilt import area_means, deflections_between, settlement_differences, tilt
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import NO_COMBINATION, ONE_COLUMN, DesignCheck, not_judged
from groundslab.design.rules.combinations import solved_results, why_none
from groundslab.design.rules.demand_errors import error_at_nodes, error_of, scaled
from groundslab.messages import Message, Name, quantity
from groundslab.model.loads.load_cases import SERVICEABILITY
from groundslab.model.plates.region import PlateRegion
from groundslab.results.fields import extreme, extreme_node, place_of
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult, Results

#: What is said of a largest pressure whose error is not known.
NOT_JUDGED = "where pressures jump or grow with finer meshes, without a known error"


class Demand(NamedTuple):
    """What a combination demands: the value in SI units, what it is about, its place [m], its calculation, an aside."""

    value: float
    of: str
    place: tuple[float, float] | None
    steps: Callable[[], Iterator[Step]]
    aside: str = ""


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


def _of_settlement(sign: int, steps: Callable[[float], Iterator[Step]]) -> Callable[[CombinationResult], Demand]:
    """Return a function that finds the largest settlement, or the largest uplift, a negative one."""

    def find(results: CombinationResult) -> Demand:
        value, place = extreme(results.plate.nodes, results.plate.settlement, sign)
        return Demand(max(sign * value, 0.0), "", place, partial(steps, value))

    return find


def _error_of_settlement(sign: int) -> Callable[[CombinationResult], float | None]:
    """Return a function that finds the error of the largest settlement, or uplift."""

    def find(results: CombinationResult) -> float | None:
        error = error_at_nodes(results, "settlement", lambda mesh: sign * mesh.plate.settlement)
        # what is below zero is no demand
        most = float((sign * results.plate.settlement).max())
        return None if error is None else max(most + error, 0.0) - max(most, 0.0)

    return find


def _greatest(demands: Iterable[Demand]) -> Demand | None:
    """Return the greatest of several plates' demands, None of none."""
    return max(demands, key=lambda demand: (demand.value, demand.of), default=None)


def _difference(results: CombinationResult) -> Demand | None:
    """Return the largest less the smallest settlement of a plate."""
    return _greatest(
        Demand(float(np.ptp(plate.settlement)), name, None, partial(limit_steps.of_difference, plate))
        for name, plate in results_by_plate(results).items()
    )


def _tilt(results: CombinationResult) -> Demand | None:
    """Return the tilt of the plate that tilts most."""
    return _greatest(
        Demand(plane.tilt, name, None, partial(_tilt_steps, plate))
        for name, plate in results_by_plate(results).items()
        for plane in [tilt(plate)]
    )


def _tilt_steps(plate: PlateResult) -> Iterator[Step]:
    """Return the calculation of a plate's tilt."""
    return limit_steps.of_tilt(area_means(plate), tilt(plate).slope)


def _distortion(results: CombinationResult) -> Demand | None:
    """Return the largest angular distortion without tilt between two columns on a plate, None of fewer."""
    demands = []
    for plate, columns in _columns_by_plate(results):
        differences = settlement_differences(plate, columns)
        worst = int(np.argmax(differences.relative))
        ends = {
            differences.names[end]: (*columns[differences.names[end]], float(differences.settlement[end]))
            for end in (differences.first[worst], differences.second[worst])
        }
        first, second = ends
        steps = partial(_distortion_steps, plate, ends)
        demands.append(Demand(float(differences.relative[worst]), Name(f"{first} - {second}"), columns[second], steps))
    return _greatest(demands)


def _distortion_steps(plate: PlateResult, ends: dict[str, tuple[float, float, float]]) -> Iterator[Step]:
    """Return the calculation of the angular distortion between two columns on a plate."""
    return limit_steps.of_distortion(area_means(plate), tilt(plate).slope, ends)


def _deflection(results: CombinationResult) -> Demand | None:
    """Return the largest sag between two neighboring columns over their distance, None of fewer."""
    demands = []
    for plate, columns in _columns_by_plate(results):
        sag = max(deflections_between(plate, columns), key=lambda deflection: deflection.ratio)
        (x0, y0), (x1, y1) = (columns[name] for name in sag.names)
        middle = (x0 + x1) / 2, (y0 + y1) / 2
        demands.append(Demand(sag.ratio, Name(" - ".join(sag.names)), middle, partial(limit_steps.of_sag, sag)))
    return _greatest(demands)


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
    node = extreme_node(spread.nodes, spread.pressure, 1)
    value, place = float(spread.pressure[node]), place_of(spread.nodes, node)
    alone = float(results.plate.pressure[node])
    by_edge = value - alone
    if by_edge <= 0:
        judged = find_limits(results.solved_model, results.plate).pressures[node]
        return Demand(value, "", place, partial(limit_steps.of_pressure, value), "" if judged else NOT_JUDGED)
    strip = strip_of(results)
    b = strip.width
    aside = Message("with {by_edge:.4g kPa} of the edge's line force over {b:.3g m}", by_edge=by_edge / 1e3, b=b)
    return Demand(value, "", place, partial(limit_steps.of_pressure, alone, (by_edge * b, strip)), aside)


def _error_of_pressure(results: CombinationResult) -> float | None:
    """Return the error of the largest pressure, None where it has no limit as the mesh is refined."""
    judged = find_limits(results.solved_model, results.plate).pressures
    if not judged[np.argmax(spread_edge_force(results).pressure)]:
        return None
    return error_at_nodes(results, "pressure", lambda mesh: spread_edge_force(mesh).pressure[judged], judged)


def _mean_pressure(results: CombinationResult) -> Demand | None:
    """Return the ground's force over the area in contact, of several plates the largest."""
    demands = []
    for name, plate in results_by_plate(results).items():
        R, area, share = float(plate.contact_force.sum()), float(plate.area.sum()), plate.contact_share
        steps = partial(limit_steps.of_mean_pressure, R, area, share)
        demands.append(Demand(R / (share * area) if share else 0.0, name, None, steps))
    return _greatest(demands)


def _contact(results: CombinationResult) -> Demand:
    """Return the share of a plate's area that is in contact, of several plates the least."""
    demands = [
        Demand(plate.contact_share, name, None, partial(limit_steps.of_contact, *areas))
        for name, plate in results_by_plate(results).items()
        for areas in [(float(plate.area.sum()), float(plate.contact_area.sum()))]
    ]
    return min(demands, key=lambda demand: (demand.value, demand.of))


def _error_of_contact(results: CombinationResult) -> float | None:
    """Return the error of the share that is in contact; of several plates all of it may be that of one."""
    least = min(results_by_plate(results).values(), key=lambda plate: plate.contact_share)
    return scaled(error_of_contact_share(results), float(results.plate.area.sum() / least.area.sum()))


#: By the keys of [limits].
LIMITS = {
    "settlement": Limit(
        "settlement", "mm", 1e3, _of_settlement(1, limit_steps.of_settlement), error=_error_of_settlement(1)
    ),
    "uplift": Limit("uplift", "mm", 1e3, _of_settlement(-1, limit_steps.of_uplift), error=_error_of_settlement(-1)),
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
            yield _check(key, allowed * limit.scale, results, missing)


def _check(key: str, allowed: float, results: list[CombinationResult], missing: str) -> DesignCheck:
    """Return the check of one limit in its unit of display; `missing` says why there are no results, if so."""
    limit = LIMITS[key]
    demands = [(demand, result) for result in results if (demand := limit.demand(result)) is not None]
    if not demands:
        why, what = (ONE_COLUMN, "there are no two columns") if results else (NO_COMBINATION, missing)
        return not_judged(limit.name, why, what, resistance=allowed, unit=limit.unit)
    demand, governing = (min if limit.least else max)(demands, key=lambda entry: entry[0].value)
    value, of, place = demand.value * limit.scale, demand.of, demand.place
    holds = value >= allowed if limit.least else value <= allowed
    sign = (">=" if holds else "<") if limit.least else ("<=" if holds else ">")
    where = Message(" at {place:.3f m}", place=place) if place is not None else ""
    about = Message("{of}: ", of=of or demand.aside) if of or demand.aside else ""
    error = scaled(limit.error_of(governing), limit.scale)
    compared = limit_steps.against(key, value, (allowed, limit.unit), error, least=limit.least)
    return DesignCheck(
        limit.name,
        "no failure found" if holds else "fails",
        Message(
            '{about}{value} {sign} {allowed}{where} in "{combination}"',
            about=about,
            value=quantity(value, f"({limit.unit})" if limit.unit else ""),
            sign=sign,
            allowed=quantity(allowed, limit.unit),
            where=where,
            combination=Name(governing.combination),
        ),
        of=of,
        demand=value,
        resistance=allowed,
        unit=limit.unit,
        least=limit.least,
        clause="limits of the case",
        combination=governing.combination,
        place=place,
        error=error,
        steps=(*demand.steps(), *compared),
    )
