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
    quantities_in,
    together,
    unit_in,
)
from groundslab.units import DIMENSIONS, UNITS, QuantityError, parse

#: Sizes of the customary units of what no quantity of a case is: masses, volumes, roots.
OTHERS = {
    "kg": 0.45359237, "kg/m2": 0.45359237 / 0.3048**2, "kg/m3": 0.45359237 / 0.3048**3, "m3": 0.3048**3,
    "MPa^0.5": 0.006894757293168361**0.5,
}  # fmt: skip


def sizes_of(*units: str) -> list[float]:
    """Return the sizes of units of one dimension in SI units, as the reader of quantities knows them."""
    for dimension in DIMENSIONS:
        try:
            return [parse(f"1 {unit}", dimension) for unit in units]
        except QuantityError:
            continue
    raise AssertionError(f"no dimension has {units}")


@pytest.mark.parametrize("unit", [unit for unit in CUSTOMARY if unit not in OTHERS])
def test_customary_unit_is_as_large_as_what_it_stands_for(unit: str) -> None:
    """The factor is that of the two units as the reader of quantities, which asks pint, knows them."""
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
    assert quantities_in("12 kN at (1, 2) m", "SI") == "12 kN at (1, 2) m"
    assert unit_in("%", "US") == ("%", 1.0)
    assert unit_in("mrad", "US") == ("mrad", 1.0)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("v_Ed 120 kN/m at (3.048, 6.096) m", "v_Ed 8.22 kip/ft at (10, 20) ft"),
        ("3.048 <= 6.096 m", "10 <= 20 ft"),
        ("a plate of 3.048 x 6.096 m", "a plate of 10 x 20 ft"),
        ("0 m to 3.048 m", "0 ft to 10 ft"),
        ("\N{MINUS SIGN}25.4 mm, 98 %", "\N{MINUS SIGN}1 in, 98 %"),
        ("unit weight 25 kN/m³ or 25 kN/m^3", "unit weight 159 pcf or 159 pcf"),
        ("6.8948 MPa (6.2.2)", "1000 psi (6.2.2)"),
        ("10 cm2/m2 of links", "0.144 in2/ft2 of links"),
        ("2272 <= 143.6 kPa, sigma_s 275.8 MPa", "47500 <= 3000 psf, sigma_s 40000 psi"),
        ("truck at 3.05 m (ultimate)", "truck at 3.05 m (ultimate)"),
        ("the ground yields at 143.64 kPa under 3 %", "the ground yields at 3000 psf under 3 %"),
        ('in "truck at 3.05 m" with 4.448 kN', 'in "truck at 3.05 m" with 1 kip'),
        ("on A' = 9.29 m2 (3.048 x 3.048 m)", "on A' = 100 ft2 (10 x 10 ft)"),
        ("M15 m, 2 d, 3 meters, x_1 m", "M15 m, 2 d, 3 meters, x_1 m"),
    ],
)
def test_quantities_in_words(text: str, shown: str) -> None:
    """Numbers change with their unit, all that share it; names in quotes and numbers without a unit do not."""
    assert quantities_in(text, "US") == shown
    assert quantities_in(shown, "US") == shown


def test_names_keep_their_quantities() -> None:
    """What a case calls "pile 12 m" is called so in feet, too, also without quotes; what stands beside is converted."""
    names = ("pile 12 m", "pile 12 m deep", "A")
    assert quantities_in("pile 12 m deep, 3.048 m off", "US", names) == "pile 12 m deep, 10 ft off"
    assert quantities_in("pile 12 m, 3.048 m", "US", names) == "pile 12 m, 10 ft"
    assert quantities_in("pile 12 m", "US") == "pile 39.4 ft"


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
