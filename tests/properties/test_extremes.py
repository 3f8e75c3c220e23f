"""Numbers of any size and files of any length end in an answer within seconds: a result, or what is wrong."""

from __future__ import annotations

import contextlib
import re
import time
import tomllib
from collections.abc import Iterator
from copy import deepcopy
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from groundslab.analysis.check import check
from groundslab.analysis.driver import solve_combinations
from groundslab.case.casefile import from_table, loads, starter
from groundslab.errors import GroundslabError, InputError, Issue
from groundslab.geometry.plan import MOST_CHORDS
from groundslab.model.consistency import estimate_elements
from groundslab.model.model import Model
from groundslab.model.shapes import Polygon
from groundslab.views.tables.result_tables import tables_of
from helpers.examples import examples

pytestmark = pytest.mark.slow

FUZZ = settings(deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck))
CASE = """
mesh = {size = "2.5 m"}
[plate]
length_x = "9 m"
length_y = "7 m"
thickness = "20 cm"
E = "23 GPa"
nu = 0.2
thermal_expansion = "1.2e-5 1/K"
openings = [{kind = "circle", centre = ["-1 m", "1 m"], radius = "0.5 m"}]
zones = [{shape = {kind = "rectangle", x = ["1 m", "3 m"], y = ["-2 m", "1 m"]}, thickness = "40 cm"}]
[ground]
kind = "vlasov"
layers = [{E = "20 MPa", E_bottom = "30 MPa", nu = 0.3, thickness = "2 m"}, {E = "60 MPa", nu = 0.3, thickness = "4 m"}]
[beyond]
kind = "infinite"
[contact]
gap = "1 mm"
limit_pressure = "600 kPa"
[[supports]]
kind = "point"
name = "pile"
x = "-2 m"
y = "-1 m"
stiffness = "50 MN/m"
acts = "in compression"
gap = "1 mm"
limit = "500 kN"
[[columns]]
name = "A"
x = "2 m"
y = "2 m"
diameter = "40 cm"
[[loads]]
kind = "self weight"
unit_weight = "25 kN/m^3"
[[loads]]
kind = "point"
P = "200 kN"
M_x = "10 kNm"
column = "A"
[[loads]]
kind = "line"
q = "5 kN/m"
q_end = "9 kN/m"
points = [["-4 m", "-3 m"], ["4 m", "-3 m"]]
[[loads]]
kind = "temperature"
difference = "5 K"
[[output.strips]]
name = "strip"
start = ["-4 m", "0 m"]
end = ["4 m", "0 m"]
width = "1 m"
stations = 5
[reinforcement]
f_ck = "30 MPa"
f_yk = "500 MPa"
bottom = ["40 mm", "50 mm"]
top = ["40 mm", "50 mm"]
"""
LAYERED = """
mesh = {counts = [4, 3]}
analysis = {increments = 2, max_iterations = 50}
beyond = {kind = "margin", width = "5 m", edge = "fixed"}
plate = {length_x = "9 m", length_y = "7 m", thickness = "20 cm", E = "23 GPa", nu = 0.2}
contact = {voids = [{depth = "5 mm", x = ["0 m", "4 m"], y = ["-1 m", "1 m"]}]}
[ground]
kind = "layered"
coupling = "interface"
layers = [{k0 = "20 MPa/m", k1 = "5 MN/m"}, {k0 = "40 kN/m^3", k1 = "0 N/m"}]
[[loads]]
kind = "uniform"
q = "5 kPa"
slope = ["1 kPa/m", "0 kPa/m"]
"""
DATA = [tomllib.loads(text) for text in (CASE, LAYERED)]
QUANTITY = re.compile(r"(-?[0-9.]+(?:e-?[0-9]+)?) (.*)")
SENSELESS = ["1e100", "-1e100", "1e300", "1e19", "1e-310", "5e-324", "-1e-200"]


def numbers(data: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], Any]]:
    """Yield the places of all numbers and quantities, and what stands there."""
    if isinstance(data, dict | list):
        for step, below in data.items() if isinstance(data, dict) else enumerate(data):
            yield from numbers(below, (*path, step))
    elif (isinstance(data, str) and QUANTITY.fullmatch(data)) or isinstance(data, int | float):
        yield path, data


def changed(data: Any, path: tuple[Any, ...], value: Any) -> Any:
    """Return the description with another value at a place."""
    data = deepcopy(data)
    holder = data
    for step in path[:-1]:
        holder = holder[step]
    holder[path[-1]] = value
    return data


def scaled(value: Any, factor: float) -> Any:
    """Return a number or a quantity so many times as large; one that is zero becomes the factor itself."""
    if isinstance(value, str):
        number, unit = QUANTITY.fullmatch(value).groups()  # type: ignore[union-attr]
        return f"{(float(number) or 1.0) * factor!r} {unit}"
    return max(1, min(int(value * abs(factor)), 10**9)) if isinstance(value, int) else value * factor


@pytest.mark.parametrize("data", DATA, ids=["vlasov", "layered"])
def test_senseless_numbers_are_faults_where_they_stand(data: Any) -> None:
    """Each number in turn made astronomical, denormal or a huge count: a issue at that key, and no other end."""
    for number, (path, value) in enumerate(numbers(data)):
        unit = f" {QUANTITY.fullmatch(value)[2]}" if isinstance(value, str) else None  # type: ignore[index]
        for wrong in (SENSELESS[number % 7], SENSELESS[(3 * number + 1) % 7]):
            other = 10**9 + number if isinstance(value, int) else f"{wrong}{unit}" if unit else float(wrong)
            with pytest.raises(InputError) as error:
                from_table(changed(data, path, other))
            named = [issue.location for issue in error.value.issues]
            assert any(str(path[-1]) in where or f"[{path[-1]}" in where or path[0] in where for where in named)


@settings(FUZZ, max_examples=examples(10))
@given(st.sampled_from(DATA), st.data())
def test_sizes_far_off_end_well(data: Any, draw: st.DataObject) -> None:
    """A number or two made larger or smaller by up to sixteen digits: a certified result or an error raised on purpose.

    And what check lets pass, solve does not refuse as an input.
    """
    places = list(numbers(data))
    for _ in range(draw.draw(st.integers(1, 2))):
        path, value = draw.draw(st.sampled_from(places))
        data = changed(data, path, scaled(value, 10.0 ** draw.draw(st.integers(-16, 16))))
    with contextlib.suppress(InputError):
        model = from_table(data)
        check(model)
        if estimate_elements(model.plate, model.plates, model.mesh) < 200 and model.analysis.increments < 5:
            solved(model)


def solved(model: Model) -> None:
    """Solve what was checked: no input is refused now."""
    refused: GroundslabError | None = None
    try:
        combined = solve_combinations(model)
    except GroundslabError as error:
        refused = error
    if refused is None:
        assert tables_of(combined) or not combined.results
    assert not isinstance(refused, InputError), refused


@settings(FUZZ, max_examples=examples(25))
@given(
    st.lists(st.tuples(st.integers(-3, 3), st.integers(-3, 3)), min_size=2, max_size=5),
    st.lists(st.sampled_from([1e12, -1e9, 1e3, 101, 100, -100, 99.5, 10, 1, 0.5, -1, 1e-6, 1e-9, -1e-17, 1e-40, 0]),
             max_size=5),
    st.sampled_from(["outline", "openings", "zones", "soil_zones", "voids", "area"]),
)  # fmt: skip
def test_bulges_of_any_size(points: list[tuple[int, int]], bulges: list[float], kind: str) -> None:
    """Arcs of nearly a whole turn, of hardly any, and senseless ones: a bounded number of chords, or a issue."""
    shape = {"kind": "polygon", "points": [[f"{x} m", f"{y} m"] for x, y in points], "bulges": bulges}
    data = deepcopy(DATA[1])
    data["mesh"] = {"size": "1 m"}
    ground = {"ground": deepcopy(data["ground"]), "shape": shape}
    if kind == "outline":
        data["plate"] = {"outline": shape, "thickness": "20 cm", "E": "23 GPa", "nu": 0.2}
        del data["contact"]
    elif kind == "openings":
        data["plate"]["openings"] = [shape]
    elif kind == "zones":
        data["plate"]["zones"] = [{"shape": shape, "thickness": "30 cm"}]
    elif kind == "soil_zones":
        data["soil_zones"] = [ground]
    elif kind == "voids":
        data["contact"]["voids"] = [{"shape": shape}]
    else:
        data["loads"].append({"kind": "area", "q": "1 kPa", "shape": shape})
    start = time.process_time()
    with contextlib.suppress(InputError):
        from_table(data)
        ring = Polygon(points=points, bulges=bulges).ring()
        assert len(ring.flat(1e-12)) <= len(points) * MOST_CHORDS
    assert time.process_time() - start < 5


@pytest.mark.parametrize(
    "text",
    [
        f"[{'.'.join(['a'] * 100_000)}]",
        f"[[{' . '.join(['a'] * 100_000)}]]",
        f"x = {{{'.'.join(['a'] * 100_000)} = 1}}",
        f"{'.'.join(['a', chr(34) + 'b' + chr(34)] * 50_000)} = 1",
        "x = " + "[" * 100_000 + "]" * 100_000,
        "x = " + "{a = " * 100_000 + "1" + "}" * 100_000,
        "x = " + "[" * 900 + "]" * 900,
        '"' * 1_000_000,
        "a" * 1_000_000,
        "\n".join(f"a{i} = 1" for i in range(50_000)),
        "\n".join(f"[a{i}]" for i in range(50_000)),
        "loads = [" + "{}," * 500_000 + "]",
    ],
    ids=["header", "list", "inline", "quoted", "arrays", "tables", "900", "quotes", "word", "keys", "headers", "loads"],
)
def test_texts_that_are_nested_or_long_without_end(text: str) -> None:
    """Tables and arrays nested by the thousand, keys of very many parts, keys without number: a issue in seconds."""
    start = time.process_time()
    with pytest.raises(InputError) as error:
        loads(text)
    assert len(str(error.value)) < 30_000
    assert time.process_time() - start < 5


def test_dots_in_texts_are_no_keys() -> None:
    """Dots in names, in comments and in places do not count as keys, however a file is written."""
    text = starter().replace('# title = "A slab of 6 x 4 m on two layers"', 'title = "1.2.3.4.5 see a.b.c.d.e.f"')
    assert loads(text + "# 1.2.3.4.5.6.7.8.9\n").title == "1.2.3.4.5 see a.b.c.d.e.f"


def many(part: str, entries: Iterator[str], plate: str = 'length_x = "600 m"\nlength_y = "400 m"') -> str:
    """Return a case with very many entries of a list."""
    load = "" if part == "loads" else '[[loads]]\nkind = "uniform"\nq = "10 kPa"\n'
    head = f'[plate]\n{plate}\nthickness = "20 cm"\nE = "30 GPa"\nnu = 0.2\n'
    inside = f"{part} = [{', '.join(entries)}]\n"
    before, within = ("", inside) if part in ("openings", "zones") else (inside, "")
    return f'{before}{head}{within}[ground]\nkind = "winkler"\nk = "20 MPa/m"\n{load}'


def box(x: float, y: float, size: float) -> str:
    """Return a square with one corner at a place [m]."""
    return f'{{kind = "rectangle", x = ["{x} m", "{x + size} m"], y = ["{y} m", "{y + size} m"]}}'


def on_grid(i: int) -> tuple[float, float]:
    """Return the place [m] of entry i, 100 in a row."""
    return -250 + 5.0 * (i % 100), -190 + 3.0 * (i // 100)


POINT = 'kind = "point", P = "1 kN", '
ROUND = 'outline = {kind = "circle", radius = "600 m"}'
LONG = {
    "loads on a circle": many("loads", (f'{{{POINT}x = "{x} m", y = "{y} m"}}' for i in range(12_000)
                                        for x, y in [on_grid(i)]), ROUND),
    "openings": many("openings", (box(*on_grid(i), 1.0) for i in range(900))),
    "too many openings": many("openings", (box(*on_grid(i), 1.0) for i in range(13_000))),
    "overlapping zones": many("zones", (f'{{thickness = "30 cm", shape = {box(i / 10 - 250, i / 10 - 150, 90.0)}}}'
                                        for i in range(900))),
    "columns": many("columns", (f'{{name = "{i}", x = "{x} m", y = "{y} m", diameter = "1 m"}}' for i in range(5000)
                                for x, y in [on_grid(i)])),
    "cases": many("cases", (f'{{name = "case {i}"}}' for i in range(1000))),
}  # fmt: skip


@pytest.mark.parametrize("name", LONG)
def test_long_lists_are_checked_in_seconds(name: str) -> None:
    """Lists of thousands, on plain plates and round ones: an answer in time that grows with their length."""
    start = time.process_time()
    issues: tuple[Issue, ...] = ()
    try:
        assert loads(LONG[name])
    except InputError as error:
        issues = error.issues
    assert len(issues) <= 101
    assert time.process_time() - start < 8
