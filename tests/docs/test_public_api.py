"""The public names: each is documented in numpydoc's sections, and their examples run."""

from __future__ import annotations

import doctest
import inspect
from dataclasses import fields, is_dataclass
from functools import cache
from operator import attrgetter
from pathlib import Path
from typing import Any

import pytest
from numpydoc.docscrape import ClassDoc
from numpydoc.validate import validate

import groundslab
from groundslab.case import casefile
from groundslab.results import plate_result, records
from groundslab.results import results as results_module
from groundslab.schema.base import Section

#: numpydoc's checks: sections and their order, summaries, all parameters with types and descriptions, returns.
CHECKS = {
    "GL07", "GL08", "SS01", "SS02", "SS03", "SS04", "SS06", "PR01", "PR02", "PR03", "PR04", "PR06", "PR07", "PR08",
    "PR09", "RT01", "RT03", "RT04", "RT05", "YD01",
}  # fmt: skip
#: Classes that public functions return, beside those that have public names.
RETURNED = (
    *(getattr(plate_result, name) for name in ("PlateResult", "ElementResult", "GroundResult")),
    *(getattr(records, name) for name in ("Constants", "Step", "Certificate")),
    *(getattr(results_module, name) for name in ("SupportResult", "Increment")),
    groundslab.errors.Issue,
)
MODEL = """
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "0.3 m"
E = "30 GPa"
nu = 0.2

[ground]
kind = "winkler"
k = "10 MPa/m"

[[loads]]
kind = "uniform"
q = "30 kPa"

[mesh]
counts = [6, 4]
"""


def public() -> list[tuple[str, object]]:
    """Return the public names of the package and of its studies, with what they stand for."""
    names = [*groundslab.__all__, *(f"study.{name}" for name in groundslab.study.__all__)]
    return [(name, attrgetter(name)(groundslab)) for name in names]


def classes() -> list[type]:
    """Return the classes that are documented by hand.

    The parts of a model are documented by their table of fields, of which docs/input.md is made.
    """
    named = [each for _, each in public()]
    own = [each for each in named if inspect.isclass(each) and not issubclass(each, Section)]
    return [*own, *RETURNED]


def documented() -> list[str]:
    """Return the full names of public functions, classes and their public methods."""
    functions = [name for name, each in public() if inspect.isfunction(each)]
    found = [f"groundslab.{name}" for name in functions]
    for each in classes():
        own = [name for name in vars(each) if not name.startswith("_") and callable(getattr(each, name))]
        name = f"{each.__module__}.{each.__qualname__}"
        found += [name, *(f"{name}.{method}" for method in own)]
    return found


def test_docstrings_are_complete() -> None:
    """Every parameter has a type and a description, and so has what is returned; fields of data stand as attributes."""
    for name in documented():
        errors = [(code, text) for code, text in validate(name)["errors"] if code in CHECKS]
        found = next((each for each in classes() if f"{each.__module__}.{each.__qualname__}" == name), None)
        if found is not None and is_dataclass(found) and "Attributes" in (found.__doc__ or ""):
            errors = [(code, text) for code, text in errors if code != "PR01"]
            described = {part for each in ClassDoc(found)["Attributes"] for part in each.name.split(", ")}
            assert {each.name for each in fields(found)} <= described
        assert not errors


@cache
def solved() -> Any:
    """Return the results that the examples speak of."""
    return groundslab.solve(casefile.loads(MODEL))


EXAMPLES = [
    groundslab.load, groundslab.check, groundslab.solve, groundslab.save_results, groundslab.load_results,
    groundslab.tables_of, groundslab.Results, plate_result.PlateResult.value_at, plate_result.PlateResult.element_at,
    plate_result.GroundResult.value_at,
]  # fmt: skip


@pytest.mark.parametrize("of", EXAMPLES, ids=lambda of: of.__qualname__)
def test_examples_run(of: Any, tmp_path: Path) -> None:
    """The most used names have examples that hold, with `model`, its `results` and a `folder` at hand."""
    (tmp_path / "case.toml").write_text(MODEL, encoding="utf-8")
    results = solved()
    parts = doctest.DocTestFinder(recurse=False).find(of, of.__qualname__)
    (test,) = [part for part in parts if part.examples]
    test.globs |= {"model": results.model, "results": results, "folder": tmp_path}
    assert doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(test).failed == 0
