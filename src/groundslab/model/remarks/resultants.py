"""Resultants of loads: the vertical force of each load case on the plates, by its geometry."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import TYPE_CHECKING, assert_never

from groundslab.geometry.areas import equal_area_polygon
from groundslab.model.loads.acting import (
    Acting,
    AreaPressure,
    LineForce,
    PlateAction,
    PointForce,
    SupportSettlement,
)
from groundslab.model.loads.clipping import clip_line, integral, pieces_on_spans
from groundslab.model.plates.region import PlateRegion, get_plate_region

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

    from groundslab.geometry.plan import Segment
    from groundslab.model.model import Model
    from groundslab.model.plates.further import AnyPlate

#: A sum of forces below this, relative to the sum of their sizes, is nothing but rounding.
BALANCED = 1e-6


def case_forces(model: Model) -> dict[str, float]:
    """Return the sum of the vertical loads of each case on the plates [N], downwards positive, without factors.

    What lies off the plates, and off members over openings, does not act. Patterns do not count unless they are placed.
    A sum that is rounding is 0.
    """
    region = get_plate_region(model.plate, model.plates)
    total: dict[str, float] = defaultdict(float)
    size: dict[str, float] = defaultdict(float)
    for load, shape in model.acting:
        force = vertical_force(shape, region, model.spans)
        total[load.case] += force
        size[load.case] += abs(force)
    return {case: force if abs(force) > BALANCED * size[case] else 0.0 for case, force in total.items()}


def vertical_force(shape: Acting, region: PlateRegion, spans: Sequence[Segment] = ()) -> float:
    """Return the vertical force of a shape on the plates and on spans of members [N], downwards positive."""
    if isinstance(shape, PointForce):
        return shape.P
    if isinstance(shape, LineForce):
        on_plates = clip_line(region.plate, shape, region.plates)
        return sum(piece.force for piece in (*on_plates, *(piece for _, piece in pieces_on_spans(shape, spans))))
    if isinstance(shape, AreaPressure):
        return 0.0 if shape.on == "ground" else integral(shape.to_shapely().intersection(region.area), shape.pressure)
    if isinstance(shape, PlateAction):
        return sum(
            integral(area, shape.pressure) + shape.unit_weight * _volume(plate, area)
            for plate, area in zip(region.every, region.areas, strict=True)
            if shape.plate in ("", plate.name)
        )
    if not isinstance(shape, SupportSettlement):
        assert_never(shape)
    return 0.0


def _volume(plate: AnyPlate, area: BaseGeometry) -> float:
    """Return the volume of a plate [m3]; where zones overlap, the last one counts."""
    volume, rest = 0.0, area
    for zone in reversed(plate.zones):
        shape = equal_area_polygon(zone.shape.ring())
        volume += (zone.thickness or plate.thickness) * rest.intersection(shape).area
        rest = rest.difference(shape)
    return float(volume + plate.thickness * rest.area)
