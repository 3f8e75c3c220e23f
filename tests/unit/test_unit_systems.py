"""US customary units: each against the definitions that pint has, and how texts are converted."""

from __future__ import annotations

import pytest

from groundslab.unit_systems import (
    BAR_SIZES,
    CUSTOMARY,
    CUSTOMARY_STEPS,
    bar_size,
    bars_at,
    in_system,
    together,
    unit_in,
)
from groundslab.units import DIMENSIONS, UNITS, QuantityError, parse

#: Sizes of the customary units of what no quantity of a case is: masses, volumes, roots, inverses.
OTHERS = {
    "kg": 0.45359237, "kg/m2": 0.45359237 / 0.3048**2, "kg/m3": 0.45359237 / 0.3048**3, "m3": 0.3048**3,
    "MPa^0.5": 0.006894757293168361**0.5, "1/m": 1 / 0.3048,
}  # fmt: skip


def sizes_of(*units: str) -> list[float]:
    """Return the sizes of units of one dimension in SI units, as the reader of quantities knows them."""
    for dimension in DIMENSIONS:
        try:
            return [parse(f"1 {unit}", dimension) for unit in units]
        except QuantityError:
            continue
    raise AssertionError(f"no dimension has {units}")


def test_customary_unit_is_as_large_as_what_it_stands_for() -> None:
    """The factor is that of the two units as the reader of quantities, which asks pint, knows them."""
    for unit in [unit for unit in CUSTOMARY if unit not in OTHERS]:
        name, factor = CUSTOMARY[unit]
        size, customary = sizes_of(unit, name)
        assert size / customary == pytest.approx(factor, rel=1e-12)


@pytest.mark.parametrize(("unit", "size"), OTHERS.items())
def test_masses_and_volumes(unit: str, size: float) -> None:
    """A pound is 0.45359237 kg, a foot is 0.3048 m, and a psi is 0.0068948 MPa."""
    assert CUSTOMARY[unit][1] == pytest.approx(1 / size, rel=1e-12)


@pytest.mark.parametrize("dimension", CUSTOMARY_STEPS)
def test_steps_have_their_size(dimension: str) -> None:
    """Each unit for people is as large as the reader of quantities says, and the next one is larger."""
    steps = CUSTOMARY_STEPS[dimension]
    assert [size for size, _ in steps] == [pytest.approx(parse(f"1 {name}", dimension), rel=1e-12) for _, name in steps]
    assert [*steps] == sorted(steps)


def test_si_units_stay() -> None:
    """Without the wish for others nothing changes; angles and shares never do."""
    assert in_system(UNITS["kN"], "SI").name == "kN"
    assert unit_in("%", "US") == ("%", 1.0)
    assert unit_in("mrad", "US") == ("mrad", 1.0)


def test_roots_of_strengths_have_the_root_of_their_unit() -> None:
    """The root of 4000 psi, 27.579 MPa, is 63.25 psi^0.5, not 5.2516 MPa in psi, 762."""
    name, factor = unit_in("MPa^0.5", "US")
    assert (name, 27.579**0.5 * factor) == ("psi^0.5", pytest.approx(63.25, abs=0.005))


def test_quantities_share_a_customary_unit() -> None:
    """The unit fits the middle one."""
    assert together([0.1524, 0.3048, 3.048], "length", "US") == (["0.5", "1", "10"], "ft")
    assert together([30e6], "pressure", "US") == (["4.3511"], "ksi")
    assert together([30e6], "pressure", "SI") == (["30"], "MPa")


def test_bars_are_called_by_their_number() -> None:
    """A diameter of ASTM A615 has its number, another one is given in inches, and in SI units in millimeters."""
    assert bar_size(0.625 * 0.0254, "US") == "#5"
    assert bar_size(BAR_SIZES["#9"], "US") == "#9"
    assert bar_size(0.016, "US") == "0.6299 in"
    assert bar_size(0.016, "SI") == "ø16"
    assert bars_at(0.016, 0.15, "SI") == "ø16 / 150"
    assert bars_at(BAR_SIZES["#5"], 0.1524, "US") == "#5 @ 6 in"
