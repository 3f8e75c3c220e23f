"""Quantities with units: text such as "30 MPa" to floats in SI units, and back to text."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Context, Decimal
from functools import cache, lru_cache
from typing import Any

#: A unit for people: its size in SI units, and its name.
Step = tuple[float, str]


@dataclass(frozen=True, slots=True)
class Dimension:
    """What a group of quantities has in common: powers of length, mass, time, temperature; how it is written.

    Sizes below `smallest` and above `largest`, in SI units, make no physical sense: they are mistakes.
    """

    phrase: str
    example: str
    si: str
    powers: tuple[int, int, int, int]
    steps: tuple[Step, ...]  # units for people, the smallest first
    smallest: float = 1e-6
    largest: float = 1e18


def _steps(unit: str, prefixes: str, si: str = "") -> tuple[tuple[float, str], ...]:
    """Return a unit with and without prefixes, its name in SI units without any."""
    return ((1.0, si or unit), *(({"k": 1e3, "M": 1e6, "G": 1e9}[prefix], prefix + unit) for prefix in prefixes))


#: All dimensions that the input knows, by name.
DIMENSIONS: dict[str, Dimension] = {
    # coordinates of national grids have up to seven digits before the point
    "length": Dimension("a length", "0.2 m", "m", (1, 0, 0, 0), ((1e-3, "mm"), (1.0, "m")), 1e-9, 1e7),
    "pressure": Dimension("a pressure", "30 MPa", "Pa", (-1, 1, -2, 0), _steps("Pa", "kMG")),
    "pressure per length": Dimension(
        "a pressure per length", "20 MPa/m", "Pa/m", (-2, 1, -2, 0), _steps("Pa/m", "kMG")
    ),
    "pressure times length": Dimension(
        "a pressure times length", "5 MN/m", "Pa m", (0, 1, -2, 0), _steps("N/m", "kMG")
    ),
    "force per length": Dimension("a force per length", "20 kN/m", "N/m", (0, 1, -2, 0), _steps("N/m", "kM")),
    "weight per volume": Dimension("a weight per volume", "25 kN/m^3", "N/m^3", (-2, 1, -2, 0), _steps("N/m^3", "k")),
    "force": Dimension("a force", "50 kN", "N", (1, 1, -2, 0), _steps("N", "kM")),
    "moment": Dimension("a moment", "80 kNm", "N m", (2, 1, -2, 0), _steps("Nm", "kM", "N m")),
    "moment per angle": Dimension(
        "a moment per angle", "50 MNm/rad", "N m/rad", (2, 1, -2, 0), _steps("Nm/rad", "kM", "N m/rad")
    ),
    "stiffness": Dimension("a force per settlement", "200 MN/m", "N/m", (0, 1, -2, 0), _steps("N/m", "kMG")),
    "stiffness per length": Dimension(
        "a force per length and settlement", "50 MN/m^2", "N/m^2", (-1, 1, -2, 0), _steps("N/m^2", "kMG")
    ),
    "pressure per area": Dimension("a pressure per area", "2 kPa/m^2", "Pa/m^2", (-3, 1, -2, 0), _steps("Pa/m^2", "k")),
    "moment per length": Dimension(
        "a moment per length", "25 kNm/m", "N m/m", (1, 1, -2, 0), _steps("Nm/m", "kM", "N m/m")
    ),
    "share": Dimension("a share", "5 %", "%", (0, 0, 0, 0), ((0.01, "%"),), 1e-6, 1.0),
    "area per length": Dimension("an area per length", "5 cm^2/m", "m^2/m", (1, 0, 0, 0), ((1e-4, "cm^2/m"),)),
    "area": Dimension("an area", "60 cm^2", "m^2", (2, 0, 0, 0), ((1e-4, "cm^2"), (1.0, "m^2")), 1e-9),
    "second moment of area": Dimension(
        "a second moment of area", "8000 cm^4", "m^4", (4, 0, 0, 0), ((1e-8, "cm^4"), (1.0, "m^4")), 1e-14
    ),
    "slope": Dimension("a slope", "2 mm/m", "m/m", (0, 0, 0, 0), ((1e-3, "mm/m"), (1.0, "m/m"))),
    "temperature difference": Dimension(
        "a temperature difference", "15 K", "K", (0, 0, 0, 1), ((1.0, "K"),), largest=1e6
    ),
    "strain per temperature": Dimension(
        "a strain per temperature", "1e-5 1/K", "1/K", (0, 0, 0, -1), ((1.0, "1/K"),), smallest=1e-12, largest=1.0
    ),
}


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit of display, the SI unit that it stands for, and the factor from SI to it."""

    name: str
    si: str
    scale: float


#: Units of display, by name.
UNITS: dict[str, Unit] = {
    unit.name: unit
    for unit in (
        Unit("m", "m", 1.0), Unit("m2", "m2", 1.0), Unit("mm", "m", 1e3), Unit("mrad", "rad", 1e3),
        Unit("deg", "rad", math.degrees(1)), Unit("kPa", "Pa", 1e-3), Unit("MPa", "Pa", 1e-6),
        Unit("MPa/m", "Pa/m", 1e-6), Unit("MPa m", "Pa m", 1e-6), Unit("kN", "N", 1e-3), Unit("kN/m", "N/m", 1e-3),
        Unit("kNm", "N m", 1e-3), Unit("kNm/m", "N m/m", 1e-3), Unit("cm2/m", "m2/m", 1e4), Unit("%", "1", 1e2),
    )
}  # fmt: skip


#: Coordinates from here on [m] are printed in millimeters, as six digits would not tell where they are.
WHOLE = 1e5
LONGEST = 100  # characters of a quantity
NUMBER = r"[+-]?(?:[0-9]{1,40}(?:\.[0-9]{0,40})?|\.[0-9]{1,40})(?:[eE][+-]?[0-9]{1,3})?"
_QUANTITY = re.compile(rf"\s*(?P<number>{NUMBER})\s*(?P<unit>\S.*?)?\s*")
_UNIT = re.compile(
    r"(?P<operator>\s*[*/·]\s*|\s+)?"
    r"(?P<name>[A-Za-zµμ_]{1,30}|%)"
    r"(?P<power>(?:\^|\*\*)-?[1-9]|[1-9]|⁻?[¹²³⁴])?"
)
_PLAIN = str.maketrans("⁻¹²³⁴", "-1234", "^*")

# Everyday units, exact and without waiting for pint: size in SI units and powers of length, mass, time, temperature.
_EVERYDAY: dict[str, tuple[Decimal, tuple[int, int, int, int]]] = {
    prefix + name: (Decimal(size), powers)
    for name, prefixes, powers in (
        ("m", {"": "1", "c": "0.01", "m": "0.001"}, (1, 0, 0, 0)),
        ("Pa", {"": "1", "k": "1e3", "M": "1e6", "G": "1e9"}, (-1, 1, -2, 0)),
        ("N", {"": "1", "k": "1e3", "M": "1e6", "G": "1e9"}, (1, 1, -2, 0)),
        ("K", {"": "1"}, (0, 0, 0, 1)),
    )
    for prefix, size in prefixes.items()
}
# What engineers write and pint does not know (or takes for something else).
_ALIASES = {
    "psf": "lbf/ft^2", "ksf": "kip/ft^2", "pci": "lbf/in^3", "pcf": "lbf/ft^3", "kcf": "kip/ft^3",
    "Nm": "N m", "kNm": "kN m", "MNm": "MN m", "rad": "",
}  # fmt: skip
_EXACT = Context(prec=60)
_BASES = ("[length]", "[mass]", "[time]", "[temperature]")


class QuantityError(ValueError):
    """A text is no quantity of a dimension; ``expected`` says what would be."""

    def __init__(self, expected: str, reason: str) -> None:
        """Keep both parts, so that a message can be put together from them."""
        super().__init__(expected, reason)
        self.expected = expected
        self.reason = reason

    def __str__(self) -> str:
        """Return both parts on one line."""
        return f"expected {self.expected}: {self.reason}"


def expectation(dimension: str) -> str:
    """Return what a quantity looks like, for messages: ``a pressure such as "30 MPa"``."""
    known = DIMENSIONS[dimension]
    return f'{known.phrase} such as "{known.example}"'


def parse(text: str, dimension: str) -> float:
    """Return the quantity in ``text`` in SI units; the unit is mandatory.

    Raises QuantityError (a ValueError) if the text is anything but a number and a unit of the dimension.
    """
    expected = expectation(dimension)
    if len(text) > LONGEST:
        raise QuantityError(expected, f"a text of {len(text)} characters is no quantity")
    match = _QUANTITY.fullmatch(text)
    if not match:
        raise QuantityError(expected, "it is not a number followed by a unit")
    if match["unit"] is None:
        raise QuantityError(expected, "the unit is missing")
    size, powers = _unit(match["unit"], expected)
    if powers != DIMENSIONS[dimension].powers:
        raise QuantityError(expected, f'"{match["unit"]}" is no unit of {DIMENSIONS[dimension].phrase}')
    # Decimal, so that "700 mm" is the float nearest to 0.7 and not 700 * 0.001
    number = Decimal(match["number"])
    value = float(_EXACT.multiply(number, size))
    if not math.isfinite(value):
        raise QuantityError(expected, "the number is too large")
    if value == 0 and number != 0:
        raise QuantityError(expected, "the number is too near to zero")
    return value


def coordinate(value: float) -> float:
    """Return a coordinate [m] for printing: rounded to nanometers, so that rounding errors around zero vanish."""
    return round(value, 9) + 0.0


def format_coordinate(value: float) -> str:
    """Return a coordinate [m] in six digits, one of a national grid in millimeters."""
    if abs(value) < WHOLE:
        return f"{coordinate(value):.6g}"
    return f"{coordinate(value):.3f}".rstrip("0").rstrip(".")


def format_number(
    value: float, digits: int = 5, *, trim: bool = False, fixed: tuple[float, float] = (1e-3, 1e7), minus: str = "-"
) -> str:
    """Return a number with so many significant digits, without an exponent where its size is within `fixed`.

    Numbers with more digits before the point keep them. `trim` rounds those, too, and leaves out zeros at the end.
    """
    rounded = float(f"{value:.{digits - 1}e}")
    if rounded == 0:
        return "0"
    if not fixed[0] <= abs(rounded) < fixed[1]:
        mantissa, _, exponent = f"{value:.{digits - 1}e}".partition("e")
        text, tail = mantissa, f"e{exponent}"
    else:
        decimals = max(0, digits - 1 - math.floor(math.log10(abs(rounded))))
        text, tail = f"{rounded if trim else value:.{decimals}f}", ""
    if trim and "." in text:
        text = text.rstrip("0").rstrip(".")
    return (text + tail).replace("-", minus)


def format_drawn(value: float) -> str:
    """Return a number as figures have it: four significant digits and a true minus sign."""
    return format_number(value, 4, trim=True, fixed=(1e-4, 1e7), minus="\N{MINUS SIGN}")


def format_drawn_coordinate(value: float) -> str:
    """Return a coordinate as figures have it: three decimals at most and a true minus sign."""
    return format_coordinate(round(value, 3)).replace("-", "\N{MINUS SIGN}")


def show(value: float, dimension: str) -> str:
    """Return a quantity given in SI units as people write it, with five digits and a fitting unit."""
    (text,), unit = together([value], dimension)
    return f"{text} {unit}"


def together(values: Sequence[float], dimension: str, steps: Sequence[Step] = ()) -> tuple[list[str], str]:
    """Return quantities given in SI units with five digits each, and their unit: that which fits the middle one.

    Those that are 0 do not count for it. The units to choose from are the dimension's own, unless they are given.
    """
    known = sorted(abs(value) for value in values if value)
    size, unit = _fitting(known[len(known) // 2] if known else 0.0, steps or DIMENSIONS[dimension].steps)
    return [f"{value / size + 0.0:.5g}" for value in values], unit


def _fitting(value: float, steps: Sequence[Step]) -> Step:
    """Return size and name of the unit in which a quantity given in SI units is at least 1, if there is one."""
    if value == 0:
        return next((step for step in steps if step[0] == 1.0), steps[0])
    # the rounded number decides, so that 999.9999 Pa becomes 1 kPa
    fitting = [step for step in steps if abs(float(f"{value / step[0]:.5g}")) >= 1.0]
    return fitting[-1] if fitting else steps[0]


def write(value: float, dimension: str) -> str:
    """Return a quantity given in SI units with all its digits: ``parse`` gives back the same float."""
    unit = DIMENSIONS[dimension].si
    number = Decimal(repr(value)).scaleb(2) if unit == "%" else repr(value)
    return f"{number} {unit}"


@lru_cache(maxsize=1024)
def _unit(text: str, expected: str) -> tuple[Decimal, tuple[int, ...]]:
    """Return size in SI units and the powers of length, mass, time and temperature of a unit such as kN/m^2 or 1/K."""
    size, powers, position = Decimal(1), (0, 0, 0, 0), 0
    start = -1 if text.startswith("1/") else 0
    position -= start
    while position < len(text):
        match = _UNIT.match(text, position)
        if not match or (match["operator"] is None) != (position == start):
            raise QuantityError(expected, f'"{text}" is not written as a unit')
        position = match.end()
        power = int((match["power"] or "1").translate(_PLAIN))
        if (match["operator"] or "").strip() == "/":
            power = -power
        factor, own = _name(match["name"], expected)
        size = _EXACT.multiply(size, _EXACT.power(factor, power))
        powers = tuple(total + power * each for total, each in zip(powers, own, strict=True))  # type: ignore[assignment]
    return size, powers


def _name(name: str, expected: str) -> tuple[Decimal, tuple[int, ...]]:
    """Return size in SI units and powers of a unit's name."""
    if name in _EVERYDAY:
        return _EVERYDAY[name]
    if name == "%":
        return Decimal("0.01"), (0, 0, 0, 0)
    if name in _ALIASES:
        return _unit(_ALIASES[name], expected)
    found = _ask_pint(name)
    if found is None:
        raise QuantityError(expected, f'"{name}" is no unit that fits')
    return found


@lru_cache(maxsize=256)
def _ask_pint(name: str) -> tuple[Decimal, tuple[int, ...]] | None:
    """Return size and powers of a unit that pint knows, None if it is not made of what our dimensions are made of."""
    import pint

    registry = _registry()
    try:
        dimensions = dict(registry.get_dimensionality(name))
        if not dimensions or not dimensions.keys() <= set(_BASES):
            return None
        raw = [dimensions.get(each, 0) for each in _BASES]
        nothing, size, twice = (float(registry.Quantity(n, name).to_base_units().magnitude) for n in (0.0, 1.0, 2.0))
    except (pint.errors.PintError, AttributeError, ArithmeticError, LookupError, TypeError, ValueError):
        return None
    # a scale that does not start at zero, or a logarithmic one, is no unit to multiply with
    powers = tuple(int(each) for each in raw)
    if nothing != 0.0 or twice != 2.0 * size or not 0.0 < size < math.inf or list(powers) != raw:
        return None
    return Decimal(_without_noise(size)), powers


def _without_noise(size: float) -> str:
    """Return the digits of a unit's size without the rounding errors of its computation."""
    short = f"{size:.12g}"
    return short if math.isclose(float(short), size, rel_tol=1e-15) else repr(size)


@cache
def _registry() -> Any:
    """Return pint's registry, kept in pint's cache folder where that can be written."""
    import pint

    try:
        return pint.UnitRegistry(cache_folder=":auto:")
    except Exception:  # a full disk, a read-only home, a damaged cache: the cache only saves time
        return pint.UnitRegistry()
