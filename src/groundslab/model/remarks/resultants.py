"""Resultants of loads: force and moments of each load case on the plates, by its geometry."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, assert_never

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.areas import equal_area_polygon
from groundslab.model.combinations import place_patterns
from groundslab.model.loads.acting import (
    Acting,
    AreaPressure,
    LineForce,
    PlateAction,
    PointForce,
    Pressure,
    SupportSettlement,
)
from groundslab.model.loads.clipping import LinePiece, clip_line, integral, pieces_on_spans
from groundslab.model.loads.patterns import position_names
from groundslab.model.plates.region import PlateRegion, get_plate_region

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

    from groundslab.geometry.plan import Place, Segment
    from groundslab.model.model import Model
    from groundslab.model.plates.other_plates import AnyPlate

#: A sum of forces below this, relative to the sum of their sizes, is nothing but rounding.
BALANCED = 1e-6
#: Places along an edge, which may be an arc, with which forces on it are summed.
_AT, _SHARES = np.polynomial.legendre.leggauss(12)


@dataclass(frozen=True, slots=True)
class Resultant:
    """A vertical force [N], downwards positive, and moments about a place [N m], of forces at larger x, y positive."""

    F: float = 0.0
    M_x: float = 0.0
    M_y: float = 0.0


def case_sums(model: Model) -> dict[str, Resultant]:
    """Return the resultant of each case as written, about the middle of the plan, without factors.

    A case that moves is at its position with the largest force, beside what stands in the case.

    Parameters
    ----------
    model : Model
        The case as written.

    Returns
    -------
    dict of str to Resultant
        Force [N] and moments [N m] by the names of the cases.
    """
    placed = case_resultants(place_patterns(model))
    moving = position_names(model.moves)
    sums: dict[str, Resultant] = {}
    for case in model.cases:
        fixed = placed.get(case.name, Resultant())
        positions = [placed.get(name, Resultant()) for name in moving.get(case.name, ())]
        most = max(positions, key=lambda at: abs(at.F), default=Resultant())
        sums[case.name] = Resultant(fixed.F + most.F, fixed.M_x + most.M_x, fixed.M_y + most.M_y)
    return sums


def case_forces(model: Model) -> dict[str, float]:
    """Return the sum of the vertical loads of each case on the plates [N], downwards positive, without factors.

    What lies off the plates, and off members over openings, does not act. Patterns do not count unless they are placed.
    A sum that is rounding is 0.
    """
    return {case: resultant.F for case, resultant in case_resultants(model).items()}


def case_resultants(model: Model) -> dict[str, Resultant]:
    """Return the resultant of each case about the middle of the plan, as `case_forces` does the force."""
    region = get_plate_region(model.plate, model.plates)
    about = middle(model)
    total: dict[str, Array] = defaultdict(lambda: np.zeros(3))
    size: dict[str, Array] = defaultdict(lambda: np.zeros(3))
    for load, shape in model.acting:
        sums = resultant(shape, region, model.spans, about)
        total[load.case] += sums
        size[load.case] += np.abs(sums)
    # a moment is rounding also where it is so little beside the force at the end of the plan
    reach = np.array([0.0, 1.0, 1.0]) * max(model.sides)
    return {
        case: Resultant(*np.where(np.abs(sums) > BALANCED * (size[case] + reach * size[case][0]), sums, 0.0).tolist())
        for case, sums in total.items()
    }


def middle(model: Model) -> Place:
    """Return the middle of the plan [m], about which moments are."""
    x0, x1, y0, y1 = model.bounds
    return (x0 + x1) / 2, (y0 + y1) / 2


def resultant(shape: Acting, region: PlateRegion, spans: Sequence[Segment] = (), about: Place = (0.0, 0.0)) -> Array:
    """Return force [N] and moments [N m] about a place, (3,), of a shape on the plates and on spans of members."""
    if isinstance(shape, PointForce):
        return np.array([shape.P, *(np.subtract(shape.place, about) * shape.P + shape.M)])
    if isinstance(shape, LineForce):
        on_plates = clip_line(region.plate, shape, region.plates)
        pieces = (*on_plates, *(piece for _, piece in pieces_on_spans(shape, spans)))
        return sum((_of_piece(piece, about) for piece in pieces), np.zeros(3))
    if isinstance(shape, AreaPressure):
        loaded = shape.to_shapely().intersection(region.area)
        return np.zeros(3) if shape.on == "ground" else _of_pressure(loaded, shape.pressure, about)
    if isinstance(shape, PlateAction):
        pressures = (
            (part, pressure)
            for plate, area in zip(region.every, region.areas, strict=True)
            if shape.plate in ("", plate.name)
            for part, pressure in ((area, shape.pressure), *_weights(plate, area, shape.unit_weight))
        )
        return sum((_of_pressure(part, pressure, about) for part, pressure in pressures), np.zeros(3))
    if not isinstance(shape, SupportSettlement):
        assert_never(shape)
    return np.zeros(3)


def _of_pressure(area: BaseGeometry, pressure: Pressure, about: Place) -> Array:
    """Return force and moments of a pressure on an area."""

    def moment(axis: int) -> float:
        return integral(area, lambda places: pressure(places) * (places[..., axis] - about[axis]))

    if pressure == Pressure(0.0):
        return np.zeros(3)
    return np.array([integral(area, pressure), moment(0), moment(1)])


def _of_piece(piece: LinePiece, about: Place) -> Array:
    """Return force and moments of a part of a line force: of its forces, and of couples towards its left."""
    part = (1 + _AT) / 2
    lengths = _SHARES / 2 * piece.edge.length
    forces = lengths * (piece.q[0] + part * (piece.q[1] - piece.q[0]))
    couples = lengths * (piece.m[0] + part * (piece.m[1] - piece.m[0]))
    moments = forces @ (piece.edge.at(part) - np.array(about)) + couples @ piece.edge.left(part)
    return np.array([forces.sum(), *moments])


def _weights(plate: AnyPlate, area: BaseGeometry, unit_weight: float) -> Iterator[tuple[BaseGeometry, Pressure]]:
    """Yield the parts of a plate of one thickness with their weight; where zones overlap, the last one counts."""
    if not unit_weight:
        return
    rest = area
    for zone in reversed(plate.zones):
        shape = equal_area_polygon(zone.shape.ring())
        yield rest.intersection(shape), Pressure(unit_weight * (zone.thickness or plate.thickness))
        rest = rest.difference(shape)
    yield rest, Pressure(unit_weight * plate.thickness)
