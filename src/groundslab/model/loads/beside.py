"""Loads on the ground beside the plate: where the ground carries them, and how far they reach."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from groundslab.model.ground import AnyGround, carry_shear
from groundslab.model.loads.load_types import AnyLoad, OnGround, presses_ground
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import AnyPlate, FurtherPlate, bounds_of
from groundslab.model.plates.region import NO_PART, PlateRegion, get_plate_region
from groundslab.model.settings import Beyond, Side
from groundslab.model.varying_ground import SoilZone
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.repairs import set_value

#: A load on the ground reaches no further off the plate than so many times its longer side, as all of it is meshed.
FARTHEST = 20.0


def distances_beyond(
    plate: AnyPlate, loads: Sequence[AnyLoad], plates: tuple[FurtherPlate, ...] = ()
) -> dict[Side, float]:
    """Return how far loads on the ground reach beyond each side of the rectangle around the plates [m]."""
    x0, x1, y0, y1 = bounds_of(plate, plates)
    boxes = [load.acts[0].rings[0].bounds for load in loads if presses_ground(load)]
    return {
        "left": max((x0 - box[0] for box in boxes), default=0.0),
        "right": max((box[1] - x1 for box in boxes), default=0.0),
        "bottom": max((y0 - box[2] for box in boxes), default=0.0),
        "top": max((box[3] - y1 for box in boxes), default=0.0),
    }


def check_ground_loads(
    plate: Plate,
    plates: tuple[FurtherPlate, ...],
    ground: AnyGround,
    soil_zones: tuple[SoilZone, ...],
    beyond: Beyond,
    loads: tuple[AnyLoad, ...],
) -> Iterator[RelativeIssue]:
    """Find loads beside the plate that have no effect, or that press on no ground."""
    carries_shear = any(any(carry_shear(soil)) for soil in (ground, *(zone.ground for zone in soil_zones)))
    for position, load in enumerate(loads):
        if presses_ground(load):
            place, on = ("loads", position), ("loads", position, "on")
            if not carries_shear:
                hint = "loads on springs off the plate have no effect on it"
                yield RelativeIssue(on, '"ground" on ground without shear', "ground that carries shear", hint)
            elif beyond.kind == "none":
                hint = 'beyond.kind = "infinite", or "margin" with a width'
                ground_end = '"ground", which ends with the plate'
                repairs = (set_value(("beyond", "kind"), "infinite"),)
                yield RelativeIssue(on, ground_end, "ground beyond the plate", hint, repairs)
            else:
                yield from _check_reach(get_plate_region(plate, plates), beyond, load, place)


def _check_reach(
    region: PlateRegion, beyond: Beyond, load: OnGround, place: tuple[str | int, ...]
) -> Iterator[RelativeIssue]:
    """Find a load that lies under the plate entirely, or reaches to where there is no ground."""
    size = region.size
    for side, distance in distances_beyond(region.plate, [load], region.plates).items():
        reach = FARTHEST * size
        if side not in beyond.sides:
            reach = 0.0
        elif beyond.kind == "margin":
            assert beyond.width is not None
            reach = beyond.width
        if distance > reach + region.rounding:
            far_load = f"a load that reaches {distance:.6g} m beyond the plate's {side} side"
            ends = reach < FARTHEST * size
            expected = f"at most {reach:g} m, where the ground ends" if ends else f"at most {reach:g} m"
            hint = "beyond says how far the ground goes" if ends else "a load so far away has no effect"
            yield RelativeIssue(place, far_load, expected, hint)
            return
    shape = load.acts[0].to_shapely()
    if shape.difference(region.grown).area <= NO_PART * shape.area:
        yield RelativeIssue(place, "a load on the ground that lies under the plate", "some of it off the plate")
