"""Quantities far off what they usually are, as where a unit was mistaken: 1 mm for 1 m, 25 N/m^3 for 25 kN/m^3."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from groundslab.messages import Message
from groundslab.schema.base import Section
from groundslab.schema.fields import Quantity
from groundslab.schema.issues import RelativeIssue
from groundslab.units import show

if TYPE_CHECKING:
    from groundslab.model.model import Model
    from groundslab.model.plate import Zone

#: So many times below or above the usual range a quantity is remarked on.
FAR = 10.0
#: A zone so many times thicker or thinner than its plate is remarked on.
FAR_FROM_PLATE = 10.0

_CONCRETE, _MODULUS, _FOUNDATION = (5e9, 50e9), (1e6, 5e9), (1e6, 300e6)
_THICKNESS, _WIDTH, _HEIGHT = (0.1, 3.0), (0.1, 3.0), (0.2, 20.0)
_PRESSURE, _FOOTPRINT, _FORCE, _WHEEL, _LINE = (0.5e3, 500e3), (0.5e3, 5e6), (1e3, 20e6), (1e3, 500e3), (1e3, 2e6)
_WEIGHT, _SOIL_WEIGHT = (10e3, 30e3), (5e3, 30e3)

#: Usual ranges by class of section and key, from and to, in SI units; of loads they are those of their size.
USUAL: dict[str, dict[str, tuple[float, float]]] = {
    "Plate": {"length_x": (0.5, 300.0), "length_y": (0.5, 300.0), "thickness": _THICKNESS, "E": _CONCRETE},
    "FurtherPlate": {"thickness": _THICKNESS, "E": _CONCRETE},
    "Zone": {"thickness": _THICKNESS, "E": _CONCRETE},
    "Column": {"width_x": _WIDTH, "width_y": _WIDTH, "diameter": _WIDTH},
    "Wall": {"thickness": _WIDTH, "height": (0.3, 100.0), "E": _CONCRETE},
    "Beam": {"E": _CONCRETE},
    "RectangularSection": {"width": _WIDTH, "height": _HEIGHT},
    "RibSection": {"width": _WIDTH, "height": _HEIGHT},
    "Winkler": {"k": _FOUNDATION},
    "Pasternak": {"k0": _FOUNDATION},
    "InterfaceLayer": {"k0": _FOUNDATION},
    "Selvadurai": {"E": _MODULUS},
    "HalfSpace": {"E": _MODULUS},
    "SoilLayer": {"E": _MODULUS, "E_bottom": _MODULUS, "thickness": (0.1, 100.0)},
    "ConstrainedModulus": {"unit_weight": _SOIL_WEIGHT, "unit_weight_below_water": _SOIL_WEIGHT},
    "SoilStrength": {"unit_weight": _SOIL_WEIGHT, "c_u": (5e3, 1e6)},
    "Pile": {"length": (1.0, 80.0), "diameter": _WIDTH, "E": _CONCRETE},
    "UniformLoad": {"q": _PRESSURE},
    "PatchLoad": {"q": _FOOTPRINT},
    "AreaLoad": {"q": _FOOTPRINT},
    "LineLoad": {"q": _LINE, "q_end": _LINE},
    "PointLoad": {"P": _FORCE},
    "CoreLoad": {"P": _FORCE},
    "SelfWeight": {"unit_weight": _WEIGHT},
    "TemperatureLoad": {"difference": (1.0, 80.0)},
    "SettlementLoad": {"w": (1e-3, 0.3)},
    "Wheel": {"P": _WHEEL},
    "Rack": {"P": _WHEEL},
    "Limits": {"settlement": (5e-3, 0.3), "pressure": (20e3, 2e6), "mean_pressure": (20e3, 2e6)},
}


class Unusual(NamedTuple):
    """Where a quantity is far off what is usual, words on it, and whether no design should pass before it is looked at.

    What is far too stiff may be so on purpose, to be rigid.
    """

    path: tuple[str | int, ...]
    words: str
    doubtful: bool = True


class _Quantity(NamedTuple):
    """A quantity of a model: where it stands, its size, its dimension, and between what it usually is."""

    path: tuple[str | int, ...]
    size: float
    dimension: str
    usual: tuple[float, float]


def unusual_quantities(model: Model) -> Iterator[Unusual]:
    """Yield the quantities far off what is usual, one for each key and side, and zones far from their plate's."""
    unusual = dict[tuple[str, bool], list[_Quantity]]()
    for kind, quantity in _quantities(model, ()):
        low, high = quantity.usual
        # 0 is no load, or nothing that a unit could have been mistaken for
        if 0 < quantity.size < low / FAR or quantity.size > high * FAR:
            unusual.setdefault((kind, quantity.size < low), []).append(quantity)
    for (_, below), same in unusual.items():
        yield _unusual(same, below)
    seen = {quantity.path for same in unusual.values() for quantity in same}
    plates: tuple[tuple[tuple[str | int, ...], float, tuple[Zone, ...]], ...] = (
        (("plate",), model.plate.thickness, model.plate.zones),
        *((("plates", number), plate.thickness, plate.zones) for number, plate in enumerate(model.plates)),
    )
    for path, thickness, zones in plates:
        for number, zone in enumerate(zones):
            place = (*path, "zones", number, "thickness")
            if zone.thickness is None or place in seen:
                continue
            ratio = zone.thickness / thickness
            if not 1 / FAR_FROM_PLATE <= ratio <= FAR_FROM_PLATE:
                where, of_zone, slab = _location(place), show(zone.thickness, "length"), show(thickness, "length")
                yield Unusual(
                    place,
                    Message(
                        "{where}: {own} in a plate of {slab}; is the unit right?", where=where, own=of_zone, slab=slab
                    ),
                )


def _unusual(same: list[_Quantity], below: bool) -> Unusual:
    """Return words on the quantities of a key that are too small or too large, on the first of them."""
    path, size, dimension, limits = same[0]
    where, value, (low, high) = _location(path), show(size, dimension), (show(limit, dimension) for limit in limits)
    if len(same) > 1:
        where = Message("{where}, one of {number}", where=where, number=len(same))
    if below:
        return Unusual(
            path,
            Message(
                "{where}: {value} is far below the usual {low} to {high}; is the unit right?",
                where=where,
                value=value,
                low=low,
                high=high,
            ),
        )
    words = Message(
        "{where}: {value} is far above the usual {low} to {high}; is the unit right?",
        where=where,
        value=value,
        low=low,
        high=high,
    )
    return Unusual(path, words, doubtful=path[-1] != "E")


def _location(path: tuple[str | int, ...]) -> str:
    """Return a place as errors write it, positions counted from 1."""
    return RelativeIssue(path, "", "").issue("").location


def _quantities(section: Section, path: tuple[str | int, ...]) -> Iterator[tuple[str, _Quantity]]:
    """Yield the quantities of a section and of those in it whose usual range is known, by class and key."""
    name = type(section).__name__
    usual = USUAL.get(name, {})
    for key, field in type(section).model_fields.items():
        value = getattr(section, key)
        if key in usual and isinstance(field.type, Quantity) and isinstance(value, int | float):
            yield f"{name}.{key}", _Quantity((*path, key), abs(value), field.type.dimension, usual[key])
        elif field.sections.parts:
            yield from _within(value, (*path, key))


def _within(value: Any, path: tuple[str | int, ...]) -> Iterator[tuple[str, _Quantity]]:
    """Yield the quantities of the sections in a value of a section."""
    if isinstance(value, Section):
        yield from _quantities(value, path)
    elif isinstance(value, tuple):
        for position, item in enumerate(value):
            yield from _within(item, (*path, position))
