"""Whatever the input, the answer is a Model or an InputError; and a Model survives being written and read."""

from __future__ import annotations

import datetime
import pickle
import tomllib
from collections.abc import Mapping
from copy import deepcopy
from functools import cache
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.case.casefile import load, loads, starter, to_toml
from groundslab.errors import InputError
from groundslab.model.model import Model, docs_table
from helpers.examples import examples
from helpers.strategies import models, rich_models

SECOND = """
title = "everything at once"
mesh = {counts = [8, 6], symmetry = "off"}
analysis = {increments = 2, solver = "superlu", nested = false, max_iterations = 50}
beyond = {kind = "margin", width = "5 m", edge = "fixed", sides = ["left", "top"]}
[plate]
length_x = "9 m"
length_y = "7 m"
thickness = "20 cm"
E = "23 GPa"
nu = 0
element = "heterosis"
edges = {left = "hinged"}
[ground]
kind = "layered"
coupling = "interface"
layers = [{k0 = "20 MPa/m", k1 = "5 MN/m"}, {k0 = "40 kN/m^3", k1 = "0 N/m"}]
[contact]
gap = "1 mm"
voids = [{depth = "5 mm", x = ["0 m", "1 ft"], y = ["-1 m", "1 m"]}]
[[loads]]
kind = "point"
P = "10 kip"
x = "1 m"
y = "1 m"
[[loads]]
kind = "uniform"
q = "100 psf"
"""
THIRD = """
title = "supports, columns, cases"
[plate]
length_x = "9 m"
length_y = "7 m"
thickness = "20 cm"
E = "23 GPa"
nu = 0.2
thermal_expansion = "1.2e-5 1/K"
[ground]
kind = "vlasov"
layers = [{E = "20 MPa", nu = 0.3, thickness = "2 m"}]
[contact]
voids = [{shape = {kind = "circle", radius = "0.5 m"}}]
gaps = [{x = "1 m", y = "0 m", gap = "-1 mm"}]
limit_pressure = "300 kPa"
[[boreholes]]
x = "0 m"
y = "20 m"
layers = [{E = "10 MPa", nu = 0.3, thickness = "3 m"}]
[[supports]]
kind = "point"
name = "pile"
x = "4 m"
y = "3 m"
stiffness = "100 MN/m"
acts = "in compression"
limit = "500 kN"
[[supports]]
kind = "line"
name = "wall"
points = [["-4.5 m", "-3 m"], ["-4.5 m", "3 m"]]
[[columns]]
name = "A1"
x = "2 m"
y = "1 m"
width_x = "0.4 m"
width_y = "0.3 m"
[[cases]]
name = "dead"
[[cases]]
name = "live"
action = "variable"
psi_2 = 0.2
[[loads]]
kind = "point"
case = "dead"
P = "900 kN"
M_x = "5 kNm"
column = "A1"
[[loads]]
kind = "settlement"
case = "live"
support = "wall"
w = "2 mm"
[[loads]]
kind = "line"
case = "live"
q = "5 kN/m"
q_end = "0 kN/m"
points = [["0 m", "0 m"], ["1 m", "2 m"]]
[[combinations]]
name = "mine"
limit_state = "frequent"
factors = {dead = 1.0, live = 0.5}
[combine]
sets = ["ultimate"]
permanent = [1.35, 1.0]
[output]
points = [{name = "P", x = "0 m", y = "0 m"}]
strips = [{name = "S", start = ["-4 m", "0 m"], end = ["4 m", "0 m"], width = "1 m"}]
[reinforcement]
f_ck = "30 MPa"
f_yk = "500 MPa"
bottom = ["40 mm", "50 mm"]
top = ["40 mm", "50 mm"]
"""
FILES = {"starter": starter(), "second": SECOND, "third": THIRD}
DATA = {name: tomllib.loads(text) for name, text in FILES.items()}

#: Every word of the schema, so that a wrong value is often nearly right.
WORDS = sorted({word for text in (docs_table(), *FILES.values()) for word in text.replace('"', " ").split()})

QUICK = settings(derandomize=True, deadline=None, database=None)


def answer(description: Any, **options: Any) -> None:
    """Make a Model of the description, or make sure that the refusal says something."""
    try:
        model = Model.model_validate(description, **options)
    except InputError as error:
        check(error)
    else:
        assert isinstance(model, Model)


def check(error: InputError) -> None:
    """Make sure that a refusal has issues that can be printed and pickled."""
    assert error.issues
    for issue in error.issues:
        assert issue.location
        assert issue.found
        assert issue.expected
        assert len(str(issue)) < 1000
    str(error).encode()
    pickle.dumps(error)


@cache
def texts() -> st.SearchStrategy[str]:
    """Return text of all sorts: words of the schema, quantities, anything, with lone surrogates too."""
    number = st.sampled_from(["0", "-1", "30", "1e9", "1e999", "nan", "inf", ".5", "9**9", "１"])
    unit = st.sampled_from(["", "m", "mm", "MPa", "MPa/m", "MN/m", "kN", "psf", "degC", "parsec", "m^9", "°", "\0"])
    quantity = st.builds("{} {}".format, number, unit)
    return st.sampled_from(WORDS) | quantity | st.text(max_size=20) | st.text(min_size=120, max_size=200)


@cache
def scalars() -> st.SearchStrategy[Any]:
    """Return values that a TOML file can hold."""
    return (
        texts()
        | st.integers()
        | st.sampled_from([0, 1, -1, 10**400, 0.5, float("nan"), float("inf"), -0.0])
        | st.floats()
        | st.booleans()
        | st.just(datetime.datetime(2026, 1, 1, tzinfo=datetime.UTC))
        | st.just(datetime.time(1, 2))
    )


@cache
def values() -> st.SearchStrategy[Any]:
    """Return nested values that a TOML file can hold."""
    return st.recursive(
        scalars(), lambda inner: st.lists(inner, max_size=3) | st.dictionaries(texts(), inner, max_size=3), max_leaves=6
    )


def places(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Return the paths of the values in nested tables and lists, down to a depth of eight."""
    if len(path) == 8:
        return []
    inner = data.items() if isinstance(data, Mapping) else enumerate(data) if isinstance(data, list) else ()
    return [found for key, value in inner for found in ((*path, key), *places(value, (*path, key)))]


def mutate(draw: st.DrawFn, data: Any) -> None:
    """Change the data at one place: drop, replace, move, rename, repeat, or wrap what is there."""
    path = draw(st.sampled_from(places(data) or [()]))
    if not path:
        return
    holder = data
    for step in path[:-1]:
        holder = holder[step]
    last = path[-1]
    change = draw(st.sampled_from(["drop", "replace", "replace", "copy", "add", "list", "table", "deep"]))
    if change == "drop":
        del holder[last]
    elif change == "replace":
        holder[last] = draw(values())
    elif change == "copy":
        source = data
        for step in draw(st.sampled_from(places(data))):
            source = source[step]
        holder[last] = deepcopy(source)
    elif change == "add" and isinstance(holder, dict):
        holder[draw(texts())] = draw(values())
    elif change == "list":
        holder[last] = [holder[last]] * draw(st.integers(0, 3))
    elif change == "table":
        holder[last] = {draw(texts()): holder[last]}
    elif change == "deep":
        for _ in range(20):
            holder[last] = [holder[last]]


@st.composite
def descriptions(draw: st.DrawFn) -> Any:
    """Return a sound description with one to four changes."""
    data = deepcopy(DATA[draw(st.sampled_from(sorted(DATA)))])
    for _ in range(draw(st.integers(1, 4))):
        mutate(draw, data)
    return data


@pytest.mark.parametrize("name", FILES)
def test_fuzzed_files_are_sound(name: str) -> None:
    """The descriptions that the tests below damage are sound to begin with."""
    assert Model.model_validate(DATA[name], from_file=True) == loads(FILES[name])


@pytest.mark.slow
@settings(QUICK, max_examples=examples(400))
@given(descriptions())
def test_damaged_structure(data: Any) -> None:
    """Dropped, moved, renamed and replaced keys, wrong types and deep nesting: a Model or an InputError."""
    answer(data, from_file=True)
    answer(data)


@pytest.mark.parametrize("kind", [list, dict])
def test_deep_nesting(kind: type) -> None:
    """A value nested two thousand deep, at any place of the description: an InputError, and nothing on the side."""
    for place in places(DATA["starter"]):
        data = deepcopy(DATA["starter"])
        holder = data
        for step in place[:-1]:
            holder = holder[step]
        for _ in range(2000):
            holder[place[-1]] = [holder[place[-1]]] if kind is list else {"kind": holder[place[-1]]}
        with pytest.raises(InputError) as error:
            Model.model_validate(data, from_file=True)
        check(error.value)


@pytest.mark.slow
@settings(QUICK, max_examples=examples(150))
@given(values() | st.binary() | st.dictionaries(st.integers() | st.none() | st.binary(), st.integers(), max_size=3))
def test_any_object(data: Any) -> None:
    """What is no description at all, in Python too, is an InputError."""
    answer(data, from_file=True)
    answer({"plate": data, "ground": data, "loads": data, "beyond": data, "contact": data, "mesh": data})
    answer(
        {**DATA["starter"], "loads": [data], "ground": {"kind": "layered", "coupling": "interface", "layers": [data]}}
    )


@pytest.mark.slow
@settings(QUICK, max_examples=examples(200))
@given(st.data())
def test_damaged_text(data: st.DataObject) -> None:
    """A piece of the file's text replaced by another: a Model or an InputError."""
    text = FILES[data.draw(st.sampled_from(sorted(FILES)))]
    start = data.draw(st.integers(0, len(text)))
    end = start + data.draw(st.integers(0, 20))
    piece = data.draw(texts() | st.sampled_from(["\n", "[", "]]", "=", '"', '"""', "{", "}", "#", "\\", "\r", "\0"]))
    try:
        loads(text[:start] + piece + text[end:])
    except InputError as error:
        check(error)


@settings(QUICK, max_examples=examples(100))
@given(st.data())
def test_damaged_bytes(tmp_path_factory: pytest.TempPathFactory, data: st.DataObject) -> None:
    """Any bytes put into the file: a Model or an InputError."""
    content = starter().encode()
    start = data.draw(st.integers(0, len(content)))
    path = tmp_path_factory.getbasetemp() / "damaged.toml"
    path.write_bytes(content[:start] + data.draw(st.binary(max_size=20)) + content[start:])
    try:
        load(path)
    except InputError as error:
        check(error)


@pytest.mark.slow
@settings(QUICK, max_examples=examples(120))
@given(models() | rich_models(whole=True))
def test_written_model_is_read_back(model: Model) -> None:
    """Every Model, written as a file and read, or dumped and rebuilt, or pickled, is the same to the last bit."""
    assert loads(to_toml(model)) == model
    assert Model(**model.model_dump()) == model
    assert pickle.loads(pickle.dumps(model)) == model
