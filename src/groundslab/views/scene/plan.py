"""What a model says in plan, as data that JSON can hold: curves as closed polylines, names, paths, texts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.geometry.plan import DRAWN_CHORD
from groundslab.model.loads.load_types import SettlementLoad, presses_ground

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.geometry.plan import Place, Ring
    from groundslab.model.columns import Column
    from groundslab.model.loads.load_types import AnyLoad
    from groundslab.model.model import Model
    from groundslab.model.outputs import OutputLine, OutputPoint, OutputStrip
    from groundslab.model.plate import Zone
    from groundslab.model.plates.further import AnyPlate, FurtherPlate
    from groundslab.model.supports import AnySupport
    from groundslab.model.varying_ground import Borehole, Void

#: Digits after the point of a length in meters.
DIGITS = 9

Data = dict[str, Any]


def plan_of(model: Model) -> Data:
    """Return what stands in plan [m]: each item with its path in the case file, which counts from 1."""
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
            return {"ring": ring(zone.shape.ring()), "thickness": thickness}

        return listed(path, of.zones, describe)

    def further(number: int, plate: FurtherPlate) -> Data:
        path = f"plates[{number}]"
        openings = listed(f"{path}.openings", plate.openings, lambda hole: {"ring": ring(hole.ring())})
        return {"path": path, "name": plate.name, "thickness": plate.thickness, "ring": ring(plate.ring()),
                "openings": openings, "zones": zones(f"{path}.zones", plate)}  # fmt: skip

    output = model.output
    return {
        "bounds": [value for place in _rounded([(x0, y0), (x1, y1)]) for value in place],
        "thickness": plate.thickness,
        "outline": ring(plate.ring()),
        "openings": listed("plate.openings", plate.openings, lambda hole: {"ring": ring(hole.ring())}),
        "zones": zones("plate.zones", plate),
        "plates": [further(number, each) for number, each in enumerate(model.plates, 1)],
        "columns": listed("columns", model.columns, lambda each: _place(each) | {"ring": ring(each.ring())}),
        "supports": listed("supports", model.supports, _support),
        "loads": listed("loads", model.loads, lambda load: _load(load, model, chord)),
        "boreholes": listed("boreholes", model.boreholes, _place),
        "soil_zones": listed("soil_zones", model.soil_zones, lambda zone: {"ring": ring(zone.shape.ring())}),
        "voids": listed("contact.voids", model.contact.voids, lambda void: {"ring": ring(_void(void))}),
        "lines": listed("output.lines", output.lines, _ends),
        "strips": listed("output.strips", output.strips, lambda strip: _ends(strip) | {"width": strip.width}),
        "points": listed("output.points", output.points, _place),
    }


def load_parts(load: AnyLoad) -> list[list[Any]]:
    """Return how large a load is, without factors: symbol, value and unit of each of its parts."""
    if load.kind == "point":
        return [["P", _kilo(load.P), "kN"], ["M_x", _kilo(load.M_x), "kNm"], ["M_y", _kilo(load.M_y), "kNm"]]
    if load.kind == "line":
        end = load.q if load.q_end is None else load.q_end
        return [["q", _kilo(load.q), "kN/m"], ["q_end", _kilo(end), "kN/m"]]
    if load.kind == "self weight":
        return [["gamma_c", _kilo(load.unit_weight), "kN/m^3"]]
    if load.kind == "temperature":
        return [["dT", load.difference, "K"]]
    if load.kind == "shrinkage":
        return [["eps_top", load.top, ""], ["eps_bottom", load.bottom, ""]]
    if load.kind == "settlement":
        return [["w_s", _tidied(load.w * 1e3), "mm"]]
    return [["q", _kilo(load.q), "kPa"]]


def _kilo(value: float) -> float:
    return _tidied(value / 1e3)


def _tidied(value: float) -> float:
    """Return a value without the rounding of its unit."""
    return float(f"{value:.12g}") + 0.0


def _support(support: AnySupport) -> Data:
    """Return a support; one without stiffness is rigid."""
    return {
        "name": support.name,
        "kind": support.kind,
        "points": _rounded(_places(support)),
        "acts": support.acts,
        "elastic": support.elastic,
    }


def _places(support: AnySupport) -> Sequence[Place]:
    """Return the points of a support."""
    return ((support.x, support.y),) if support.kind != "line" else support.points


def _load(load: AnyLoad, model: Model, chord: float) -> Data:
    """Return a load with points or a ring, whichever it has; self-weight and temperature have neither."""
    about: Data = {"name": load.name, "kind": load.kind, "case": load.case}
    if load.kind == "point":
        placed = load.on(model.columns)
        assert placed.x is not None
        assert placed.y is not None
        about["points"] = _rounded([(placed.x, placed.y)])
        own = _footprint(load)
        if own is not None:
            about["footprint"] = _rounded(own.flat(chord))
    elif load.kind == "line":
        about["points"] = _rounded(load.flat(chord))
    elif isinstance(load, SettlementLoad):
        support = next(each for each in model.supports if each.name == load.support)
        about["points"] = _rounded(_places(support))
    elif load.kind == "uniform":
        about["ring"] = _rounded(model.plate.ring().flat(chord))
    elif load.kind == "patch":
        about["ring"] = _rounded(_box(load.x, load.y).flat(chord))
    elif load.kind == "area":
        about["ring"] = _rounded(load.shape.ring().flat(chord))
        if load.holes:
            about["holes"] = [_rounded(hole.ring().flat(chord)) for hole in load.holes]
    if presses_ground(load):
        about["on"] = "ground"
    if any(getattr(load, "slope", ())) or any(getattr(load, "bend", ())):
        about["varies"] = True
    return about | {"parts": load_parts(load)}


def _footprint(load: Any) -> Ring | None:
    """Return the curve around a point load's own footprint; one on a column has the column's."""
    from groundslab.model.columns import footprint

    return None if load.column else footprint(load.x, load.y, load.width_x, load.width_y, load.diameter)


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
    found: list[list[float]] = (np.round(np.asarray(places, dtype=float), DIGITS) + 0.0).tolist()
    return found
