"""Resultants of loads: the vertical force of each load case on the plates, by its geometry."""

from __future__ import annotations

from collections import defaultdict
from typing import TYPE_CHECKING, assert_never

from groundslab.geometry.plan import equal_area_polygon
from groundslab.model.loads.clipping import clip_line_load, get_plate_region, integral
from groundslab.model.loads.load_types import (
    AnyLoad,
    AreaLoad,
    LineLoad,
    PatchLoad,
    PointLoad,
    SelfWeight,
    SettlementLoad,
    ShrinkageLoad,
    TemperatureLoad,
    UniformLoad,
    presses_ground,
    pressure_function,
)
from groundslab.model.plates.region import PlateRegion
from groundslab.model.shapes import CHORD

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

    from groundslab.model.model import Model
    from groundslab.model.plates.further import AnyPlate

#: A sum of forces below this, relative to the sum of their sizes, is nothing but rounding.
BALANCED = 1e-6


def case_forces(model: Model) -> dict[str, float]:
    """Return the sum of the vertical loads of each case on the plates [N], downwards positive, without factors.

    What lies off the plates does not act. Patterns do not count unless they are placed. A sum that is rounding is 0.
    """
    region = get_plate_region(model.plate, model.plates)
    total: dict[str, float] = defaultdict(float)
    size: dict[str, float] = defaultdict(float)
    for load in model.loads:
        force = vertical_force(load, region)
        total[load.case] += force
        size[load.case] += abs(force)
    return {case: force if abs(force) > BALANCED * size[case] else 0.0 for case, force in total.items()}


def vertical_force(load: AnyLoad, region: PlateRegion) -> float:
    """Return the vertical force of a load on the plates [N], downwards positive."""
    if isinstance(load, PointLoad):
        return load.P
    if isinstance(load, LineLoad):
        return sum(piece.force for piece in clip_line_load(region.plate, load, region.plates))
    if isinstance(load, UniformLoad):
        return sum(integral(area, pressure_function(load)) for _, area in _loaded_plates(load, region))
    if isinstance(load, PatchLoad | AreaLoad):
        if presses_ground(load):
            return 0.0
        return integral(load.to_shapely(CHORD * region.size).intersection(region.area), pressure_function(load))
    if isinstance(load, SelfWeight):
        return load.unit_weight * sum(_volume(plate, area) for plate, area in _loaded_plates(load, region))
    if not isinstance(load, TemperatureLoad | ShrinkageLoad | SettlementLoad):
        assert_never(load)
    return 0.0


def _loaded_plates(load: UniformLoad | SelfWeight, region: PlateRegion) -> list[tuple[AnyPlate, BaseGeometry]]:
    """Return the plates that a load acts on, the one that it names or all, each with what it covers."""
    plates = zip(region.every, region.areas, strict=True)
    return [(plate, area) for plate, area in plates if not load.plate or plate.name == load.plate]


def _volume(plate: AnyPlate, area: BaseGeometry) -> float:
    """Return the volume of a plate [m3]; where zones overlap, the last one counts."""
    volume, rest = 0.0, area
    for zone in reversed(plate.zones):
        shape = equal_area_polygon(zone.shape.ring())
        volume += (zone.thickness or plate.thickness) * rest.intersection(shape).area
        rest = rest.difference(shape)
    return float(volume + plate.thickness * rest.area)
