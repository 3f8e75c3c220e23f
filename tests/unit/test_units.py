"""Text to quantities and back."""

from __future__ import annotations

import contextlib
import math
import pickle
import subprocess
import sys
import time
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab import units
from groundslab.units import DIMENSIONS, QuantityError, parse, show, write
from helpers.examples import examples

KIP = 4448.2216152605
FOOT = 0.3048


def test_units_are_understood() -> None:
    """Units of engineers on both sides of the ocean give the value of their definition."""
    for text, dimension, value in [
        ("9.6 m", "length", 9.6),
        ("200 mm", "length", 0.2),
        ("700 mm", "length", 0.7),
        ("20cm", "length", 0.2),
        ("10 ft", "length", 3.048),
        ("12 inch", "length", FOOT),
        ("-1.5e-3 km", "length", -1.5),
        ("5 µm", "length", 5e-6),
        ("30 MPa", "pressure", 30e6),
        ("23 GPa", "pressure", 23e9),
        ("5 kN/m^2", "pressure", 5e3),
        ("5 kN/m**2", "pressure", 5e3),
        ("5 kN/m²", "pressure", 5e3),
        ("5 kN/m2", "pressure", 5e3),
        ("5 kN m^-2", "pressure", 5e3),
        ("5 kN·m⁻²", "pressure", 5e3),
        ("3 N/mm^2", "pressure", 3e6),
        ("1 bar", "pressure", 1e5),
        ("1 psi", "pressure", KIP / 1e3 / (FOOT / 12) ** 2),
        ("1 ksi", "pressure", KIP / (FOOT / 12) ** 2),
        ("1 psf", "pressure", KIP / 1e3 / FOOT**2),
        ("1 ksf", "pressure", KIP / FOOT**2),
        ("20 kPa/m", "pressure per length", 20e3),
        ("20 kN/m³", "pressure per length", 20e3),
        ("0.02 N/mm³", "pressure per length", 20e6),
        ("100 pci", "pressure per length", 100 * KIP / 1e3 / (FOOT / 12) ** 3),
        ("1 kcf", "pressure per length", KIP / FOOT**3),
        ("5 MN/m", "pressure times length", 5e6),
        ("20.660 MPa m", "pressure times length", 20.66e6),
        ("20.660 MPa*m", "pressure times length", 20.66e6),
        ("1 kip/ft", "pressure times length", KIP / FOOT),
        ("50 kN", "force", 50e3),
        ("1 kip", "force", KIP),
        ("1 tf", "force", 9806.65),
        (" +.5  MN ", "force", 0.5e6),
        ("80 kNm", "moment", 80e3),
        ("80 kN m", "moment", 80e3),
        ("80 kN·m", "moment", 80e3),
        ("-2 MNm", "moment", -2e6),
        ("1 kip ft", "moment", KIP * FOOT),
        ("50 MNm/rad", "moment per angle", 50e6),
        ("50 kN m/rad", "moment per angle", 50e3),
        ("50 kNm", "moment per angle", 50e3),
        ("15 K", "temperature difference", 15.0),
        ("-15 K", "temperature difference", -15.0),
        ("18 delta_degF", "temperature difference", 10.0),
        ("1e-5 1/K", "strain per temperature", 1e-5),
        ("0.00001 1/K", "strain per temperature", 1e-5),
        ("12e-6 K^-1", "strain per temperature", 12e-6),
        ("200 MN/m", "stiffness", 200e6),
        ("200 kN/mm", "stiffness", 200e6),
        ("50 MN/m^2", "stiffness per length", 50e6),
        ("50 MN/m/m", "stiffness per length", 50e6),
        ("2 kPa/m^2", "pressure per area", 2e3),
        ("25 kN/m^3", "weight per volume", 25e3),
    ]:
        assert parse(text, dimension) == pytest.approx(value, rel=1e-14, abs=0)


@pytest.mark.parametrize("digits", ["0.7", "9.6", "123.456", "0.001", "20.660"])
def test_decimal_units_are_exact(digits: str) -> None:
    """A decimal unit does not add rounding errors: 700 mm is the float 0.7."""
    assert parse(f"{digits}e3 mm", "length") == float(digits)
    assert parse(f"{digits} N/mm^2", "pressure") == float(f"{digits}e6")


def test_nonsense_is_refused() -> None:
    """What is no pressure is refused with an example and the reason, and nothing is ever evaluated."""
    for text, reason in [
        ("30", "unit is missing"),
        ("1e5", "unit is missing"),
        ("MPa", "not a number"),
        ("", "not a number"),
        ("   ", "not a number"),
        ("nan MPa", "not a number"),
        ("inf MPa", "not a number"),
        ("-Infinity MPa", "not a number"),
        ("0x10 MPa", "no unit"),
        ("1,000 MPa", "not written as a unit"),
        ("1_000 MPa", "no unit"),
        ("٣ MPa", "not a number"),
        ("30 m", "no unit of a pressure"),
        ("30 MPa/m", "no unit of a pressure"),
        ("30 MN", "no unit of a pressure"),
        ("30 quux", "no unit that fits"),
        ("30 Mpa", "no unit that fits"),
        ("30 rad", "is no unit of a pressure"),
        ("30 pi Pa", "no unit that fits"),
        ("20 degC", "no unit that fits"),
        ("20 delta_degC", "is no unit of a pressure"),
        ("20 K Pa", "is no unit of a pressure"),
        ("20 dBm/m*s", "no unit that fits"),
        ("1e999 MPa", "too large"),
        ("1e308 GPa", "too large"),
        ("1e9999 MPa", "not written as a unit"),
        ("9**9**9 Pa", "not written as a unit"),
        ("9 Pa**9**9**9", "not written as a unit"),
        ("9 Pa^99999999", "not written as a unit"),
        ("(1+1) Pa", "not a number"),
        ("1 (Pa)", "not written as a unit"),
        ("1 Pa//m", "not written as a unit"),
        ("1 Pa/", "not written as a unit"),
        ("1 /Pa", "not written as a unit"),
        ("1 __import__('os')", "no unit"),
        ("1" * 50 + " Pa", "not written as a unit"),
        ("1 Pa" + " " * 100, "104 characters"),
        ("1 " + "m" * 90, "no unit that fits"),
    ]:
        with pytest.raises(ValueError, match=r'expected a pressure such as "30 MPa"') as error:
            parse(text, "pressure")
        assert reason in str(error.value)


@pytest.mark.parametrize(
    ("text", "dimension"),
    [
        ("80 kN", "moment"),
        ("80 kN/m", "moment"),
        ("80", "moment"),
        ("50 kNm/K", "moment per angle"),
        ("0.1 rad", "moment per angle"),
        ("15 degC", "temperature difference"),
        ("15", "temperature difference"),
        ("15 1/K", "temperature difference"),
        ("1e-5 K", "strain per temperature"),
        ("1e-5", "strain per temperature"),
        ("1e-5 1/", "strain per temperature"),
        ("1e-5 /K", "strain per temperature"),
        ("1e-5 1/1/K", "strain per temperature"),
        ("1e-5 1//K", "strain per temperature"),
        ("200 MPa", "stiffness"),
        ("200 MN/m", "stiffness per length"),
        ("2 kPa/m", "pressure per area"),
        ("1/m", "length"),
        ("2 1/m", "length"),
    ],
)
def test_nonsense_of_other_dimensions_is_refused(text: str, dimension: str) -> None:
    """Moments are no forces, stiffnesses of points none of lines, degrees no differences, and 1/ stands once."""
    with pytest.raises(QuantityError) as error:
        parse(text, dimension)
    assert error.value.expected == units.expectation(dimension)


def test_error_can_be_pickled() -> None:
    """The error crosses the border between processes."""
    error = QuantityError("a length", "why not")
    assert str(pickle.loads(pickle.dumps(error))) == str(error) == "expected a length: why not"


@pytest.mark.parametrize(("name", "dimension"), list(DIMENSIONS.items()))
def test_own_examples(name: str, dimension: units.Dimension) -> None:
    """Every dimension's example, its SI unit and its units for people are units of it, of the stated size."""
    assert parse(dimension.example, name) > 0
    assert parse(units.write(1.0, name), name) == 1.0
    for size, unit in dimension.steps:
        assert parse(f"1 {unit}", name) == size


@pytest.mark.parametrize("name", list(units._EVERYDAY))
def test_everyday_units_agree_with_pint(name: str) -> None:
    """The units that are known without pint have the size and the dimension that pint gives them."""
    assert units._ask_pint(name) == units._EVERYDAY[name]


@pytest.mark.parametrize(
    ("value", "dimension", "text"),
    [
        (0.2, "length", "200 mm"),
        (9.6, "length", "9.6 m"),
        (-0.01359, "length", "-13.59 mm"),
        (0, "length", "0 m"),
        (23e9, "pressure", "23 GPa"),
        (1e6, "pressure", "1 MPa"),
        (999.9999, "pressure", "1 kPa"),
        (0.5, "pressure", "0.5 Pa"),
        (32.7862e6, "pressure per length", "32.786 MPa/m"),
        (20.66e6, "pressure times length", "20.66 MN/m"),
        (5.76e6, "force", "5.76 MN"),
        (0.0, "share", "0 %"),
        (0.0, "area per length", "0 cm^2/m"),
    ],
)
def test_show(value: float, dimension: str, text: str) -> None:
    """People see a fitting unit and no more digits than they can use."""
    assert show(value, dimension) == text


@pytest.mark.slow
@settings(derandomize=True, max_examples=examples(300), deadline=None, database=None)
@given(st.floats(allow_nan=False, allow_infinity=False), st.sampled_from(list(DIMENSIONS)))
def test_written_is_read_back(value: float, dimension: str) -> None:
    """Every finite float survives writing and reading, to the last bit; shown, it is still the same to 1e-4."""
    back = parse(write(value, dimension), dimension)
    assert back == value
    assert math.copysign(1, back) == math.copysign(1, value)
    shown = parse(show(value, dimension), dimension) if abs(value) < 1e300 else value
    assert shown == pytest.approx(value, rel=1e-4, abs=1e-300)


@pytest.mark.slow
@settings(derandomize=True, max_examples=examples(300), deadline=None, database=None)
@given(st.text(max_size=120) | st.from_regex(units.NUMBER + r"\s?[A-Za-z*/^ 0-9]{0,12}", fullmatch=True))
def test_any_text(text: str) -> None:
    """Whatever the text, the answer is a finite float or a QuantityError, at once."""
    start = time.process_time()
    with contextlib.suppress(QuantityError):
        assert math.isfinite(parse(text, "length"))
    assert time.process_time() - start < 5.0  # pint's first start included


@pytest.mark.slow
def test_pint_only_when_needed() -> None:
    """Everyday units do not wait for pint to be imported; others do import it."""
    code = (
        "import sys; from groundslab.units import parse; parse('5 kN/m^2', 'pressure');"
        "assert 'pint' not in sys.modules; parse('1 ft', 'length'); assert 'pint' in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.slow
def test_registry_without_cache_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where pint's cache folder cannot be used, units work all the same."""
    import pint

    real = pint.UnitRegistry

    def broken(**options: object) -> object:
        if options:
            raise PermissionError("read-only")
        return real()

    monkeypatch.setattr(pint, "UnitRegistry", broken)
    assert units._registry.__wrapped__().Quantity(1, "ft").to("m").magnitude == pytest.approx(FOOT)


@pytest.mark.parametrize(
    ("value", "options", "text"),
    [
        (13.5, {}, "13.500"),
        (1234567.8, {}, "1234568"),
        (-0.0, {}, "0"),
        (13.5, {"trim": True}, "13.5"),
        (2e-5, {"trim": True}, "2e-05"),
        (12345.6, {"digits": 4, "trim": True}, "12350"),
        (12345.6, {"digits": 4, "trim": True, "fixed": (1e-4, 1e4)}, "1.235e+04"),
        (-2.5e-9, {"digits": 4, "trim": True, "minus": "−"}, "−2.5e−09"),
    ],
)
def test_numbers_as_text(value: float, options: dict[str, Any], text: str) -> None:
    """Significant digits, zeros at the end kept or not, an exponent outside a range, the minus sign of print."""
    assert units.format_number(value, **options) == text
