"""Whatever a case describes, its report tells all of it, draws it, and lets none of its words out of their place."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.cli import main
from groundslab.errors import CertificateWithdrawn, InputError
from groundslab.model.combinations import as_solved, list_combinations
from groundslab.model.model import Model
from groundslab.model.shapes import Circle, Polygon, Rectangle
from groundslab.schema.base import Section
from groundslab.schema.fields import Quantity, Text
from groundslab.schema.wording import quote
from groundslab.units import QuantityError, parse
from groundslab.views.files import results_folder
from groundslab.views.plots.style import plain_text
from groundslab.views.report.drawings.drawings import draw_case
from groundslab.views.report.input_tables import InputTable, input_tables
from groundslab.views.scene.plan import plan_of
from helpers import damage, synthetic
from helpers.examples import examples
from helpers.pages import page
from helpers.strategies import models, rich_models

pytestmark = pytest.mark.slow


def leaves(part: Section) -> Iterator[tuple[Any, Any]]:
    """Yield the kinds and values of all keys that a case gives; of shapes none, as they are reported in words."""
    for name, field in type(part).model_fields.items():
        value, key = getattr(part, name), field.type
        if isinstance(value, Section):
            yield from () if isinstance(value, Rectangle | Circle | Polygon) else leaves(value)
        elif key is None and isinstance(value, tuple):
            for each in value:
                yield from leaves(each)
        elif key is not None and value is not None and (field.required or value != field.default):
            yield key, value


def reported(sections: list[InputTable]) -> tuple[set[str], dict[str, list[float]]]:
    """Return all texts of an echo, and its numbers with units in SI by the unit's text."""
    texts: set[str] = set()
    numbers: dict[str, list[float]] = {}
    for section in sections:
        for grid in section.grids:
            for row in grid.rows:
                for head, cell in zip(grid.heads, row, strict=True):
                    texts.add(cell.text)
                    number, _, unit = cell.text.partition(" ") if not head.unit else (cell.text, "", head.unit)
                    if unit and cell.text:
                        numbers.setdefault(unit, []).append(number)  # type: ignore[arg-type]
    return texts, numbers


def in_si(numbers: dict[str, list[Any]], dimension: str) -> list[float]:
    """Return the numbers whose units are of a dimension, in SI units."""
    found = []
    for unit, values in numbers.items():
        for value in values:
            try:
                found.append(parse(f"{value} {unit}", dimension))
            except QuantityError:
                continue
    return found


@settings(derandomize=True, max_examples=examples(12), deadline=None, database=None)
@given(rich_models(whole=True))
def test_all_that_a_case_says_is_told(model: Model) -> None:
    """Each quantity stands in the echo to five digits, and each name as it is; nothing is left out."""
    texts, numbers = reported(input_tables(model, list_combinations(model)))
    known: dict[str, list[float]] = {}
    for key, value in leaves(model):
        if isinstance(key, Quantity):
            values = known.setdefault(key.dimension, in_si(numbers, key.dimension))
            assert any(abs(each - value) <= 6e-5 * abs(value) for each in values), (key, value)
        elif isinstance(key, Text) and value != model.title:
            assert value in texts, quote(value)


@settings(derandomize=True, max_examples=examples(12), deadline=None, database=None)
@given(rich_models(whole=True) | models())
def test_every_plan_can_be_drawn(model: Model) -> None:
    """The plan is data for JSON; its drawing is well formed and stays within its frame."""
    plan = plan_of(model)
    assert json.loads(json.dumps(plan, allow_nan=False)) == plan
    drawing = page(draw_case(model, as_solved(model)).svg).one("svg")
    width, height = (float(drawing.attributes[name]) for name in ("width", "height"))
    assert 0 < width < 1200
    assert 0 < height < 1200
    _, _, width, height = (float(length) for length in drawing.attributes["viewbox"].split())
    texts = [each.text for each in drawing.all("text")]
    for name in (plain_text(column.name) for column in model.columns):
        # its sides stand after it; nothing is seen of blanks
        assert any(text.startswith(name) for text in texts) or not name.strip()
    for text in drawing.all("text"):
        moved = re.match(r"translate\(([-\d.]+) ([-\d.]+)\)", text.attributes.get("transform", ""))
        x, y = moved.groups() if moved else (text.attributes["x"], text.attributes["y"])
        assert -20 <= float(x) <= width + 20
        assert -20 <= float(y) <= height + 20


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder of results."""
    return results_folder.save_results(synthetic.results(shear=True), tmp_path_factory.mktemp("whole") / "raft")


@settings(derandomize=True, max_examples=examples(25), deadline=None, database=None)
@given(data=st.data())
def test_damaged_results_are_reported_as_they_are_or_refused(folder: Path, data: st.DataObject) -> None:
    """Whatever is damaged in a folder, it is read as sound results that a report can be made of, or refused."""
    damaged = folder.with_name("damaged")
    shutil.rmtree(damaged, ignore_errors=True)
    shutil.copytree(folder, damaged)
    archive = damaged / "results.npz"
    names = sorted(damage.arrays(archive))
    kind = data.draw(st.sampled_from(["array", "about", "bytes", "file"]))
    if kind == "array":
        change = damage.ARRAYS[data.draw(st.sampled_from(sorted(damage.ARRAYS)))]
        damage.with_array(
            archive, data.draw(st.sampled_from([n for n in names if n not in ("about", "model")])), change
        )
    elif kind == "about":
        about = json.loads(str(damage.arrays(archive)["about"]))
        place = data.draw(st.sampled_from(list(damage.places(about))))
        damage.with_about(archive, place, data.draw(st.sampled_from(damage.VALUES)))
    else:
        path = archive if kind == "bytes" else damaged / "summary.json"
        content = path.read_bytes()
        at = data.draw(st.integers(0, len(content) - 1))
        path.write_bytes(
            content[:at] + data.draw(st.binary(max_size=20)) + content[at + data.draw(st.integers(0, 50)) :]
        )
    try:
        results_folder.load_results(damaged)
    except (InputError, CertificateWithdrawn) as error:
        # what is sound, but not what was written, has lost its certificate
        code = 2 if isinstance(error, InputError) else 1
        assert main.main(["report", str(damaged), "--out", str(folder.with_name("none.html"))]) == code
        return
    out = folder.with_name("a.html")
    assert main.main(["report", str(damaged), "--out", str(out)]) == 0
    assert main.main(["plot", str(damaged), "--out", str(out.with_suffix(".svg"))]) == 0
