"""Comparisons beside the solver: their messages, their end, and their rows, which are those of the commands."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest

from groundslab.analysis.ground_comparison.comparison import compare_grounds
from groundslab.case import casefile
from groundslab.errors import GroundslabError
from groundslab.study.alternatives.comparison import compare_texts
from groundslab.study.alternatives.rows import rows
from groundslab.views.ground_comparison.rows import constant_rows, figure_rows
from groundslab.workbench.solver import comparer as comparers
from groundslab.workbench.solver.comparer import Compared, Comparer, OnBegin

PATIENCE = 120.0
SOFT = """
[plate]
length_x = "4 m"
length_y = "3 m"
thickness = "300 mm"
E = "30 GPa"
nu = 0.2
[ground]
kind = "continuum"
half_space = {E = "20 MPa", nu = 0.3}
[mesh]
size = "1 m"
[[loads]]
kind = "uniform"
q = "50 kPa"
"""


def obey(text: str, folder: Path, on_begin: OnBegin) -> Compared:
    """Do what the text says instead of comparing."""
    on_begin("continuum", 0.25)
    if text == "refuse":
        raise GroundslabError("no layers")
    if text == "wait":
        time.sleep(PATIENCE)
    return Compared({"text": text}, {"as drawn": str(folder)})


def wait_for(events: list[tuple[str, dict[str, Any]]], name: str) -> dict[str, Any]:
    """Return the first event of a name."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        for word, about in list(events):
            if word == name:
                return about
        time.sleep(0.01)
    raise AssertionError(events)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "event", "message"), [("go", "compared", ""), ("refuse", "not compared", "no layers")]
)
def test_a_comparison_is_kept_or_refused(text: str, event: str, message: str) -> None:
    """Progress is told, and then the end; only what was compared is kept."""
    events: list[tuple[str, dict[str, Any]]] = []
    comparer = Comparer(lambda name, about: events.append((name, about)), {"alternatives": obey})
    comparer.start("alternatives", 7, text, Path("there"))
    about = wait_for(events, event)
    assert (about["kind"], about["run"], about.get("message", "")) == ("alternatives", 7, message)
    progress = {"kind": "alternatives", "run": 7, "text": "continuum", "share": 0.25}
    assert ("comparing", progress) in events
    compared = Compared({"text": "go"}, {"as drawn": "there"}) if text == "go" else None
    assert comparer.get("alternatives", 7) == compared
    assert comparer.list_kinds(7) == (["alternatives"] if compared else [])


@pytest.mark.slow
def test_a_comparison_is_cancelled_at_once() -> None:
    """A cancelled one is announced without a reason and leaves nothing behind."""
    events: list[tuple[str, dict[str, Any]]] = []
    comparer = Comparer(lambda name, about: events.append((name, about)), {"comparison": obey})
    comparer.start("comparison", 1, "wait", Path())
    begun = time.monotonic()
    comparer.cancel()
    assert events[-1] == ("not compared", {"kind": "comparison", "run": 1, "message": ""})
    assert time.monotonic() - begun < PATIENCE / 2
    assert comparer.get("comparison", 1) is None


@pytest.mark.slow
def test_its_rows_are_those_of_the_command_line() -> None:
    """Labels, values, differences and units are those which the command prints."""
    begun: list[tuple[str, float]] = []
    compared = comparers.compare_grounds(SOFT, Path(), lambda *told: begun.append(told))
    found = compared.table
    assert [share for _, share in begun] == [n / comparers.GROUNDS for n in range(comparers.GROUNDS)]
    comparison = compare_grounds(casefile.loads(SOFT))
    ground_rows = [*figure_rows(comparison), *constant_rows(comparison)]
    assert len(found["rows"]) == len(ground_rows)
    for (label, unit, *cells), row in zip(found["rows"], ground_rows, strict=True):
        assert (label[0], unit) == (row.label, row.unit)
        texts = [(cell, "") if isinstance(cell, str) else tuple(cell[:2]) for cell in cells]
        assert texts == list(row.texts())


@pytest.mark.slow
def test_alternatives_are_those_of_the_command_line() -> None:
    """Names, cells and cases are those which the command prints and writes; progress ends with the last."""
    begun: list[tuple[str, float]] = []
    compared = comparers.compare_designs(SOFT, Path(), lambda *told: begun.append(told))
    comparison = compare_texts(SOFT, None)
    found = compared.table
    assert [head["text"] for head in found["heads"][2:]] == [each.name for each in comparison.alternatives]
    for (_, _, *cells), row in zip(found["rows"], rows(comparison), strict=True):
        assert tuple(cell if isinstance(cell, str) else cell[0] for cell in cells) == row.cells
    assert compared.cases == {each.name: each.text for each in comparison.alternatives}
    assert begun[0][1] == 0
    assert [share for _, share in begun] == sorted(share for _, share in begun)
