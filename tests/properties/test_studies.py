"""Whatever a case holds can be reached by its path and put back; whatever a study file holds, the answer is clear."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.schema.base import Section
from groundslab.schema.fields import Factors
from groundslab.schema.issues import FieldError
from groundslab.study.definition import case_paths
from groundslab.study.definition.schema import StudyFile
from helpers.examples import examples
from helpers.strategies import rich_models
from helpers.studies import CASE, STUDY

pytestmark = pytest.mark.slow


def all_paths(part: Section, path: str) -> Iterator[tuple[str, Any]]:
    """Yield the path of every key below a part with what it holds."""
    for name, field in type(part).model_fields.items():
        below = f"{path}.{name}" if path else name
        held = getattr(part, name)
        key = field.type
        if isinstance(key, Factors):
            yield from ((f'{below}."{each.replace(chr(92), chr(92) * 2).replace(chr(34), chr(92) + chr(34))}"', value)
                        for each, value in held)  # fmt: skip
        elif key is not None:
            yield below, held
            if isinstance(held, tuple):
                yield from ((f"{below}[{n}]", item) for n, item in enumerate(held, start=1))
        elif field.sections.many:
            for n, item in enumerate(held, start=1):
                yield from all_paths(item, f"{below}[{n}]")
        elif field.sections.parts and held is not None:
            yield from all_paths(held, below)


@settings(max_examples=examples(20), derandomize=True, deadline=None)
@given(model=rich_models(), number=st.integers(0, 10**6))
def test_every_key_can_be_reached(model: Model, number: int) -> None:
    """Each key of a case is found by its path, and the case with its own values put in is the same case."""
    places = {}
    for path, held in all_paths(model, ""):
        place = case_paths.place_of(model, path)
        assert place.value == held
        places[place] = held
    one = list(places)[number % len(places)]
    assert case_paths.with_values(model, {one: places[one]}) == model
    whole = {place: held for place, held in places.items() if not isinstance(place.steps[-1], int)}
    assert case_paths.with_values(model, whole) == model


@settings(max_examples=examples(200), derandomize=True, deadline=None)
@given(path=st.text(alphabet='abk.[]01"\\gq-', max_size=12))
def test_paths_are_refused_in_words(path: str) -> None:
    """Any text is a path to a key, or is refused with what was expected."""
    model = casefile.loads(CASE)
    try:
        place = case_paths.place_of(model, path)
    except FieldError as error:
        message = error.relative_issues[0].expected
    else:
        message = str(place.value)
    assert message


SCRAPS = st.recursive(
    st.none() | st.booleans() | st.integers(-2, 10**12) | st.floats() | st.text(max_size=5)
    | st.sampled_from(["grid", "sobol", "normal", "k", "settlement", "at", "largest", "1 m", "2 MPa", "ground.k"]),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=4), inner, max_size=3),
    max_leaves=5,
)  # fmt: skip


@settings(max_examples=examples(300), derandomize=True, deadline=None)
@given(data=st.data())
def test_spoilt_study_files(data: st.DataObject) -> None:
    """A study file with anything put anywhere is a study or an InputError, and what is a study can be written."""
    tables: Any = tomllib.loads(STUDY)
    held = tables
    while True:
        keys = list(held) if isinstance(held, dict) else list(range(len(held)))
        step = data.draw(st.sampled_from(keys))
        below = held[step]
        if not isinstance(below, dict | list) or not below or data.draw(st.integers(0, 2)) == 0:
            break
        held = below
    held[step] = data.draw(SCRAPS)
    try:
        study = StudyFile.model_validate(tables, from_file=True)
    except InputError:
        return
    assert StudyFile.model_validate(tomllib.loads(casefile.to_toml(study)), from_file=True) == study


@pytest.mark.parametrize("text", [STUDY])
def test_study_survives_being_written(text: str) -> None:
    """A study file that is read, written and read again is the same study."""
    study = StudyFile.model_validate(tomllib.loads(text), from_file=True)
    assert StudyFile.model_validate(tomllib.loads(casefile.to_toml(study)), from_file=True) == study
