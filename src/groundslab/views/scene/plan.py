"""What a model says in plan, as data that JSON can hold: curves as closed polylines, names, paths, texts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.geometry.plan import DRAWN_CHORD
from groundslab.model.axes.drawn import drawn_axes
from groundslab.model.loads.acting import AreaPressure, LineForce, PlateAction, PointForce
from groundslab.unit_systems import in_system
from groundslab.units import UNITS, Unit

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.geometry.plan import Place, Ring
    from groundslab.model.loads.acting import Acting, Pressure
    from groundslab.model.loads.load_types import AnyLoad
    from groundslab.model.model import Model
    from groundslab.model.outputs import OutputLine, OutputPoint, OutputStrip
    from groundslab.model.plate import Zone
    from groundslab.model.plates.other_plates import AnyPlate, FurtherPlate
    from groundslab.model.structure.beams import Beam
    from groundslab.model.structure.columns import Column
    from groundslab.model.structure.walls import Wall
    from groundslab.model.supports import AnySupport
    from groundslab.model.varying_ground import Borehole, Void
    from groundslab.unit_systems import System

#: Digits after the point of a length in meters.
DIGITS = 9

#: The units that loads are shown in.
MAGNITUDES = {
    "force": Unit("kN", "N", 1e-3),
    "moment": Unit("kNm", "N m", 1e-3),
    "force per length": Unit("kN/m", "N/m", 1e-3),
    "moment per length": Unit("kNm/m", "N m/m", 1e-3),
    "pressure": Unit("kPa", "Pa", 1e-3),
    "weight per volume": Unit("kN/m^3", "N/m^3", 1e-3),
    "temperature difference": Unit("K", "K", 1.0),
    "strain": Unit("", "", 1.0),
    "length": Unit("mm", "m", 1e3),
}

Data = dict[str, Any]


def plan_of(model: Model) -> Data:
    """Return the items in plan [m], each with its path in the case file, which counts from 1."""
    plate = model.plate
    x0, x1, y0, y1 = model.bounds
    chord = DRAWN_CHORD * max(model.sides)

    def ring(curve: Ring) -> list[list[float]]:
        return _rounded(curve.flat(chord))

    def listed(path: str, parts: Iterable[Any], describe: Callable[[Any], Data]) -> list[Data]:
        return [{"path": f"{path}[{number}]", **describe(part)} for number, part in enumerate(parts, 1)]

    def zones(path: str, of: AnyPlate) -> list[Data]:
        def describe(zone: Zone) -> Data:
            thickness = of.thickness if zone.thickness is None else zone.thickness
            level = {} if zone.level is None else {"level": zone.level, "wall": zone.wall}
            return {"ring": ring(zone.shape.ring()), "thickness": thickness} | level

        return listed(path, of.zones, describe)

    def further(number: int, plate: FurtherPlate) -> Data:
        path = f"plates[{number}]"
        openings = listed(f"{path}.openings", plate.openings, lambda hole: {"ring": ring(hole.ring())})
        return {"path": path, "name": plate.name, "thickness": plate.thickness, "ring": ring(plate.ring()),
                "openings": openings, "zones": zones(f"{path}.zones", plate)}  # fmt: skip

    output = model.output
    return {
        "lengths": lengths_in(model.units),
        "bounds": [value for place in _rounded([(x0, y0), (x1, y1)]) for value in place],
        "thickness": plate.thickness,
        "outline": ring(plate.ring()),
        "openings": listed("plate.openings", plate.openings, lambda hole: {"ring": ring(hole.ring())}),
        "zones": zones("plate.zones", plate),
        "plates": [further(number, other) for number, other in enumerate(model.plates, 1)],
        "axes": list(_axes(model)),
        "columns": listed("columns", model.columns, lambda column: _place(column) | {"ring": ring(column.ring())}),
        "walls": listed("walls", model.placed_walls, lambda wall: _wall(wall, chord)),
        "beams": listed("beams", model.beams, lambda beam: _beam(beam, chord)),
        "building": listed("building.beams", model.building_lines, lambda line: {"points": _rounded(line)}),
        "supports": listed("supports", model.supports, _support),
        "loads": listed("loads", model.loads, lambda load: _load(load, model, chord)),
        "boreholes": listed("boreholes", model.boreholes, _place),
        "soil_zones": listed("soil_zones", model.soil_zones, lambda zone: {"ring": ring(zone.shape.ring())}),
        "voids": listed("contact.voids", model.contact.voids, lambda void: {"ring": ring(_void(void))}),
        "lines": listed("output.lines", output.lines, _ends),
        "strips": listed("output.strips", output.strips, lambda strip: _ends(strip) | {"width": strip.width}),
        "points": listed("output.points", output.points, _place),
    }


def _axes(model: Model) -> Iterator[Data]:
    """Yield the name of each axis, the points of its line, and where its bubble is."""
    numbers = [number for number, family in enumerate(model.axes, 1) for _ in family.axes]
    for number, axis in zip(numbers, drawn_axes(model.axes, model.bounds), strict=True):
        (bubble,) = _rounded([axis.bubble])
        yield {"path": f"axes[{number}]", "name": axis.name, "points": _rounded(axis.points), "bubble": bubble}


def _wall(wall: Wall, chord: float) -> Data:
    """Return the name of a wall, its thickness and its axis, and of one with doors its pieces between them."""
    from shapely import get_coordinates

    axis = get_coordinates(wall.to_shapely(chord))
    about: Data = {"name": wall.name, "thickness": wall.thickness, "points": _rounded(axis)}
    if wall.doors:
        about["pieces"] = [_rounded(get_coordinates(piece.to_shapely(chord))) for piece in wall.pieces]
    return about


def _beam(beam: Beam, chord: float) -> Data:
    """Return the name of a beam, its width, 0 without one, and its axis."""
    from shapely import get_coordinates

    axis = get_coordinates(beam.to_shapely(chord))
    return {"name": beam.name, "width": beam.width, "points": _rounded(axis)}


def lengths_in(units: System) -> Data:
    """Return how lengths on pictures are shown: the unit of places, that of thicknesses and settlements, factors."""
    long, short = in_system(UNITS["m"], units), in_system(UNITS["mm"], units)
    return {"unit": long.name, "per_meter": long.scale, "small": short.name, "small_per_meter": short.scale}


def load_parts(load: AnyLoad, units: System) -> list[list[Any]]:
    """Return how large a load is, without factors: symbol, value and unit of each of its parts."""
    shown = [(symbol, value, in_system(MAGNITUDES[name], units)) for symbol, value, name in load.magnitudes]
    return [[symbol, _tidied(value * unit.scale), unit.name] for symbol, value, unit in shown]


def _tidied(value: float) -> float:
    """Return a value without the rounding of its unit."""
    return float(f"{value:.12g}") + 0.0


def _support(support: AnySupport) -> Data:
    """Return a support; one without stiffness is rigid."""
    return {
        "name": support.name,
        "kind": support.kind,
        "points": _rounded(support.points),
        "acts": support.acts,
        "elastic": support.elastic,
    }


def _load(load: AnyLoad, model: Model, chord: float) -> Data:
    """Return a load with what it acts on: points, a ring, or nothing where it acts on all of a plate.

    Of what acts through parts of walls the points are those of the longest one, and all of them are pieces.
    """
    about: Data = {"name": load.name, "kind": load.kind, "case": load.case}
    shapes = model.shapes(load)
    for shape in shapes:
        about |= _place_of(shape, model, chord)
    on_walls = [shape for shape in shapes if isinstance(shape, LineForce) and shape.wall]
    if on_walls:
        longest = max(on_walls, key=lambda line: line.length)
        about |= {"wall": longest.wall, "points": _rounded(longest.flat(chord))}
    if len(on_walls) > 1:
        about["pieces"] = [_rounded(line.flat(chord)) for line in on_walls]
    if getattr(load, "column", ""):
        # the column is drawn
        about.pop("footprint", None)
    return about | {"parts": load_parts(load, model.units)}


def _place_of(shape: Acting, model: Model, chord: float) -> Data:
    """Return the points, line or area that a load acts on."""
    if isinstance(shape, PointForce):
        footprint = {} if shape.ring is None else {"footprint": _rounded(shape.ring.flat(chord))}
        return {"points": _rounded([shape.place])} | footprint
    if isinstance(shape, LineForce):
        return {"points": _rounded(shape.flat(chord))}
    if isinstance(shape, AreaPressure):
        around, *holes = [_rounded(ring.flat(chord)) for ring in shape.rings]
        about: Data = {"ring": around}
        if holes:
            about["holes"] = holes
        if shape.on == "ground":
            about["on"] = "ground"
        return about | _varies(shape.pressure)
    if isinstance(shape, PlateAction):
        around_plate = {"ring": _rounded(model.plate.ring().flat(chord))} if shape.presses else {}
        return {"everywhere": True} | around_plate | _varies(shape.pressure)
    support = next(support for support in model.supports if support.name == shape.support)
    return {"support": support.name, "points": _rounded(support.points)}


def _varies(pressure: Pressure) -> Data:
    """Return the mark of a pressure that varies."""
    return {} if pressure.constant else {"varies": True}


def _void(void: Void) -> Ring:
    """Return the curve around a void."""
    if void.shape is not None:
        return void.shape.ring()
    assert void.x is not None
    assert void.y is not None
    return _box(void.x, void.y)


def _box(x: tuple[float, float], y: tuple[float, float]) -> Ring:
    """Return the curve around a rectangle."""
    from groundslab.geometry.plan import rectangle

    return rectangle(*x, *y)


def _place(part: Column | Borehole | OutputPoint) -> Data:
    """Return the name of a part and where it is."""
    ((x, y),) = _rounded([(part.x, part.y)])
    return {"name": part.name, "x": x, "y": y}


def _ends(line: OutputLine | OutputStrip) -> Data:
    """Return the name of a line and its ends."""
    start, end = _rounded([line.start, line.end])
    return {"name": line.name, "start": start, "end": end}


def _rounded(places: Sequence[Place] | Array) -> list[list[float]]:
    """Return places as lists, rounded to nanometers, no zero of them negative."""
    rounded: list[list[float]] = (np.round(np.asarray(places, dtype=float), DIGITS) + 0.0).tolist()
    return rounded
