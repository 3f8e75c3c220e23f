"""Units of output: SI units, or those customary in the United States, for figures, columns and words."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Literal

from groundslab import units
from groundslab.units import UNITS, Step, Unit, format_number

#: In what units results are shown.
System = Literal["SI", "US"]

INCH, FOOT, POUND_FORCE, POUND = 0.0254, 0.3048, 4.4482216152605, 0.45359237  # [m], [m], [N], [kg], exact
KIP = 1000 * POUND_FORCE


def _customary(name: str, size: float) -> tuple[str, float]:
    """Return a unit's name and the factor from the unit that it stands for, of a size in that unit."""
    return name, 1 / size


#: What stands for units of display in the United States, and the factor from the one to the other.
CUSTOMARY: Mapping[str, tuple[str, float]] = MappingProxyType(
    {
        "m": _customary("ft", FOOT),
        "1/m": _customary("1/ft", 1 / FOOT),
        "mm": _customary("in", INCH * 1e3),
        "m2": _customary("ft2", FOOT**2),
        "cm2": _customary("in2", INCH**2 * 1e4),
        "mm2": _customary("in2", INCH**2 * 1e6),
        "m3": _customary("ft3", FOOT**3),
        "m4": _customary("ft4", FOOT**4),
        "mm/m": _customary("in/ft", INCH * 1e3 / FOOT),
        "cm2/m": _customary("in2/ft", INCH**2 * 1e4 / FOOT),
        "cm2/m2": _customary("in2/ft2", INCH**2 * 1e4 / FOOT**2),
        "kg": _customary("lb", POUND),
        "kg/m2": _customary("lb/ft2", POUND / FOOT**2),
        "kg/m3": _customary("pcf", POUND / FOOT**3),
        "N": _customary("lbf", POUND_FORCE),
        "kN": _customary("kip", KIP / 1e3),
        "MN": _customary("kip", KIP / 1e6),
        "kN/m": _customary("kip/ft", KIP / FOOT / 1e3),
        "MN/m": _customary("kip/ft", KIP / FOOT / 1e6),
        "GN/m": _customary("kip/in", KIP / INCH / 1e9),
        "kNm": _customary("kip ft", KIP * FOOT / 1e3),
        "MNm": _customary("kip ft", KIP * FOOT / 1e6),
        "kNm/m": _customary("kip ft/ft", KIP / 1e3),
        "MNm/m": _customary("kip ft/ft", KIP / 1e6),
        "kNm/rad": _customary("kip ft/rad", KIP * FOOT / 1e3),
        "MNm/rad": _customary("kip ft/rad", KIP * FOOT / 1e6),
        "Pa": _customary("psf", POUND_FORCE / FOOT**2),
        "kPa": _customary("psf", POUND_FORCE / FOOT**2 / 1e3),
        "kN/m2": _customary("psf", POUND_FORCE / FOOT**2 / 1e3),
        "MPa": _customary("psi", POUND_FORCE / INCH**2 / 1e6),
        "MPa^0.5": _customary("psi^0.5", math.sqrt(POUND_FORCE / INCH**2 / 1e6)),
        "GPa": _customary("ksi", KIP / INCH**2 / 1e9),
        "kPa/m": _customary("pci", POUND_FORCE / INCH**3 / 1e3),
        "MPa/m": _customary("pci", POUND_FORCE / INCH**3 / 1e6),
        "MPa m": _customary("kip/in", KIP / INCH / 1e6),
        "kN/m3": _customary("pcf", POUND_FORCE / FOOT**3 / 1e3),
        "kPa/m2": _customary("psf/ft2", POUND_FORCE / FOOT**4 / 1e3),
        "MN/m2": _customary("ksf", KIP / FOOT**2 / 1e6),
    }
)

_POUND_PER_FOOT, _KIP_PER_FOOT = (POUND_FORCE / FOOT, "lbf/ft"), (KIP / FOOT, "kip/ft")
_FOOT_POUND, _FOOT_KIP = POUND_FORCE * FOOT, KIP * FOOT
#: Units for people in the United States by the names of dimensions, as `units.Dimension.steps`; the others keep theirs.
CUSTOMARY_STEPS: Mapping[str, tuple[Step, ...]] = MappingProxyType(
    {
        "length": ((INCH, "in"), (FOOT, "ft")),
        "pressure": ((POUND_FORCE / FOOT**2, "psf"), (KIP / FOOT**2, "ksf"), (KIP / INCH**2, "ksi")),
        "pressure per length": ((POUND_FORCE / INCH**3, "pci"),),
        "pressure times length": ((POUND_FORCE / INCH, "lbf/in"), (KIP / INCH, "kip/in")),
        "force per length": (_POUND_PER_FOOT, _KIP_PER_FOOT),
        "weight per volume": ((POUND_FORCE / FOOT**3, "pcf"),),
        "force": ((POUND_FORCE, "lbf"), (KIP, "kip")),
        "moment": ((_FOOT_POUND, "lbf ft"), (_FOOT_KIP, "kip ft")),
        "moment per angle": ((_FOOT_POUND, "lbf ft/rad"), (_FOOT_KIP, "kip ft/rad")),
        "stiffness": ((POUND_FORCE / INCH, "lbf/in"), (KIP / INCH, "kip/in")),
        "stiffness per length": ((POUND_FORCE / FOOT**2, "psf"), (KIP / FOOT**2, "ksf")),
        "pressure per area": ((POUND_FORCE / FOOT**4, "psf/ft^2"),),
        "moment per length": ((POUND_FORCE, "lbf ft/ft"), (KIP, "kip ft/ft")),
        "area per length": ((INCH**2 / FOOT, "in^2/ft"),),
        "area": ((INCH**2, "in^2"), (FOOT**2, "ft^2")),
        "second moment of area": ((INCH**4, "in^4"), (FOOT**4, "ft^4")),
        "slope": ((INCH / FOOT, "in/ft"),),
    }
)

#: Bars of ASTM A615: the number of a size, and its nominal diameter [m].
BAR_SIZES: Mapping[str, float] = MappingProxyType(
    {
        f"#{number}": round(inches * INCH, 7)
        for number, inches in (
            (3, 0.375), (4, 0.5), (5, 0.625), (6, 0.75), (7, 0.875), (8, 1.0), (9, 1.128), (10, 1.27), (11, 1.41),
            (14, 1.693), (18, 2.257),
        )
    }
)  # fmt: skip
#: Pressures from here on [Pa] are strengths and stiffnesses.
LEAST_STRENGTH = 1e6
#: Numbers that are round: these, times a power of ten.
_ROUND = (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10)
#: A diameter within this of a size [m] has its name.
NEAR = 5e-5

_RAISED = str.maketrans("234", "²³⁴")
#: The same with powers as they are written elsewhere, such as m^2 and m².
_AS_WRITTEN = {
    write(name): (write(other), factor)
    for write in (str, lambda name: re.sub(r"(\d)", r"^\1", name), lambda name: name.translate(_RAISED))
    for name, (other, factor) in CUSTOMARY.items()
}


def unit_in(name: str, system: System) -> tuple[str, float]:
    """Return the name of what stands for a unit of display in a system, and the factor from the one to the other."""
    return (name, 1.0) if system == "SI" else _AS_WRITTEN.get(name, (name, 1.0))


def in_system(unit: Unit, system: System) -> Unit:
    """Return what stands for a unit of display in a system: itself in SI units, and where there is nothing else."""
    name, factor = unit_in(unit.name, system)
    return replace(unit, name=name, scale=unit.scale * factor)


#: All units of display, of both systems, by name.
DISPLAYED: Mapping[str, Unit] = MappingProxyType(
    UNITS | {unit.name: unit for unit in (in_system(each, "US") for each in UNITS.values())}
)


def together(values: Sequence[float], dimension: str, system: System) -> tuple[list[str], str]:
    """Return quantities given in SI units with five digits each, and their unit in a system; see `units.together`."""
    return units.together(values, dimension, () if system == "SI" else CUSTOMARY_STEPS.get(dimension, ()))


def customary_example(text: str, dimension: str) -> str:
    """Return a round quantity of about the size of another one in units customary in the United States.

    Those of a dimension that keeps its units stay as they are. Lengths below a meter are in inches, strengths in psi.
    """
    value = units.parse(text, dimension)
    steps: Sequence[Step] = CUSTOMARY_STEPS.get(dimension, ())
    if not steps or value == 0:
        return text
    if value < 0:
        return f"-{customary_example(text.replace('-', '', 1), dimension)}"
    if dimension == "length" and value < 1:
        steps = steps[:1]
    elif dimension == "pressure" and value >= LEAST_STRENGTH:
        steps = ((POUND_FORCE / INCH**2, "psi"), *steps[2:])
    size, unit = next((step for step in reversed(steps) if value >= step[0]), steps[0])
    power = 10.0 ** math.floor(math.log10(value / size))
    rounded = min((each * power for each in _ROUND), key=lambda each: abs(math.log(each * size / value)))
    return f"{format_number(rounded, 2, trim=True)} {unit}"


def bar_size(diameter: float, system: System) -> str:
    """Return what bars of a diameter [m] are called: "ø16" in millimeters, "#5", or their diameter in inches."""
    if system == "SI":
        return f"\N{LATIN SMALL LETTER O WITH STROKE}{format_number(diameter * 1e3, 4, trim=True)}"
    named = next((name for name, known in BAR_SIZES.items() if abs(known - diameter) < NEAR), None)
    return named or f"{format_number(diameter / INCH, 4, trim=True)} in"


def bars_at(diameter: float, spacing: float, system: System) -> str:
    """Return what bars of a diameter at a spacing [m] are called, such as "ø16 / 150" and "#5 @ 6 in"."""
    unit = in_system(UNITS["mm"], system)
    distance = format_number(spacing * unit.scale, 4, trim=True)
    size = bar_size(diameter, system)
    return f"{size} / {distance}" if system == "SI" else f"{size} @ {distance} {unit.name}"
