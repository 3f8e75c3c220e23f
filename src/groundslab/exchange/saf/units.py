"""Units of the Structural Analysis Format: one of its two systems for each kind of quantity, with factors to SI."""

from __future__ import annotations

import math
import re

#: Standard gravity [m/s2] (CGPM 1901), which turns the format's mass per volume into weight.
GRAVITY = 9.80665
_INCH, _FOOT, _POUND = 0.0254, 0.3048, 0.45359237
_KIP = 1000 * _POUND * GRAVITY
_DEGREE = math.radians(1.0)

#: Units of quantities, metric and imperial, as the annex on units of the format's documentation lists them.
UNITS: dict[str, tuple[str, str]] = {
    "length": ("m", "ft"),
    "size": ("mm", "in"),
    "area": ("m2", "ft2"),
    "second moment": ("m4", "ft4"),
    "angle": ("deg", "deg"),
    "modulus": ("MPa", "ksi"),
    "mass": ("kg/m3", "lb/ft3"),
    "expansion": ("1/K", "1/°F"),
    "force": ("kN", "kip"),
    "line force": ("kN/m", "kip/ft"),
    "pressure": ("kN/m2", "kip/ft2"),
    "moment": ("kNm", "kipft"),
    "line moment": ("kNm/m", "kipft/ft"),
    "point stiffness": ("MN/m", "kip/ft"),
    "line stiffness": ("MN/m2", "kip/ft2"),
    "surface stiffness": ("MN/m3", "kip/ft3"),
    "shear stiffness": ("MN/m", "kip/ft"),
    "rotational stiffness": ("MNm/rad", "kipft/deg"),
    "temperature": ("°C", "°F"),
    "number": ("", ""),
}

#: Units by those of the metric system; of stiffnesses per length none is ever given.
IMPERIAL = {metric: imperial for metric, imperial in UNITS.values() if metric}
_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")

_SIZES: dict[str, float] = {
    "m": 1.0, "mm": 1e-3, "ft": _FOOT, "in": _INCH, "m2": 1.0, "ft2": _FOOT**2, "m4": 1.0, "ft4": _FOOT**4,
    "deg": _DEGREE, "MPa": 1e6, "ksi": _KIP / _INCH**2, "kg/m3": 1.0, "lb/ft3": _POUND / _FOOT**3,
    "1/K": 1.0, "1/°F": 1.8, "kN": 1e3, "kip": _KIP, "kN/m": 1e3, "kip/ft": _KIP / _FOOT,
    "kN/m2": 1e3, "kip/ft2": _KIP / _FOOT**2, "kNm": 1e3, "kipft": _KIP * _FOOT, "kNm/m": 1e3, "kipft/ft": _KIP,
    "MN/m": 1e6, "MN/m2": 1e6, "MN/m3": 1e6, "kip/ft3": _KIP / _FOOT**3,
    "MNm/rad": 1e6, "kipft/deg": _KIP * _FOOT / _DEGREE, "°C": 1.0, "°F": 1 / 1.8, "": 1.0,
}  # fmt: skip

_KNOWN = {unit.lower() for unit in _SIZES if unit}
_SIGNS = str.maketrans({"²": "2", "³": "3", "⁴": "4", "^": "", " ": "", "\\": "", "*": "", "·": "", "º": "°"})


def unit_of(quantity: str, imperial: bool) -> str:
    """Return the unit of a quantity in one of the two systems."""
    return UNITS[quantity][imperial]


def to_si(value: float, quantity: str, imperial: bool) -> float:
    """Return a value of a file in SI units, rounded to the digits that a file can mean."""
    return float(f"{value * _SIZES[unit_of(quantity, imperial)]:.14g}")


def from_si(value: float, quantity: str) -> float:
    """Return a value in SI units in the metric unit of a file, freed of what rounding has left."""
    return float(f"{value / _SIZES[unit_of(quantity, imperial=False)]:.14g}")


def to_imperial(value: object, unit: str) -> object:
    """Return what stands below a heading with a metric unit in the imperial one: a number, or all numbers of a text."""
    share = _SIZES[unit] / _SIZES[IMPERIAL[unit]]
    if isinstance(value, int | float):
        return float(f"{value * share:.14g}")
    # numbers of corners, such as C1, are none
    return re.sub(_NUMBER, lambda match: f"{float(match[0]) * share:.14g}", value) if isinstance(value, str) else value


def heading_key(heading: object) -> str:
    """Return a column's heading without its unit, case, blanks and signs, which differ from program to program."""
    return re.sub(r"[^a-z0-9]", "", str(heading)[: _unit_start(heading)].lower())


def heading_unit(heading: object) -> str:
    """Return the unit in the brackets of a column's heading, nothing if there are none."""
    return str(heading)[_unit_start(heading) :].strip("[]()\\ ").translate(_SIGNS)


def _unit_start(heading: object) -> int:
    """Return where the unit of a heading begins: in square brackets, or at its end in round ones if it is known."""
    said = str(heading)
    bracket = re.search(r"\\?\[.*", said) or re.search(r"\(([^()]*)\)\s*$", said)
    round_one = bracket is not None and bracket[0].startswith("(")
    if bracket is None or (round_one and bracket[1].translate(_SIGNS).lower() not in _KNOWN):
        return len(said)
    return bracket.start()
