"""Comparing ground models beside the solver: its messages, its end, and its rows, which are those of the command."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from typing import Any

import pytest

from groundslab.analysis.ground_comparison.comparison import compare_grounds
from groundslab.case import casefile
from groundslab.errors import GroundslabError
from groundslab.views.ground_comparison.rows import constant_rows, figure_rows
from groundslab.workbench.solver import ground_comparison
from groundslab.workbench.solver.ground_comparison import GroundComparer

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
size = "0.5 m"
[[loads]]
kind = "uniform"
q = "50 kPa"
"""


def obey(text: str, on_begin: Callable[[str], None]) -> bytes:
    """Do what the text says instead of comparing."""
    on_begin("continuum")
    if text == "refuse":
        raise GroundslabError("no layers")
    if text == "wait":
        time.sleep(PATIENCE)
    return text.encode()


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
    comparer = GroundComparer(lambda name, about: events.append((name, about)), obey)
    comparer.start(7, text)
    about = wait_for(events, event)
    assert (about["run"], about.get("message", "")) == (7, message)
    assert ("comparing", {"run": 7, "text": "1 of 5, continuum", "share": 0.0}) in events
    assert comparer.get(7) == (b"go" if text == "go" else None)


@pytest.mark.slow
def test_a_comparison_is_cancelled_at_once() -> None:
    """A cancelled one is announced without a reason and leaves nothing behind."""
    events: list[tuple[str, dict[str, Any]]] = []
    comparer = GroundComparer(lambda name, about: events.append((name, about)), obey)
    comparer.start(1, "wait")
    begun = time.monotonic()
    comparer.cancel()
    assert events[-1] == ("not compared", {"run": 1, "message": ""})
    assert time.monotonic() - begun < PATIENCE / 2
    assert comparer.get(1) is None


@pytest.mark.slow
def test_its_rows_are_those_of_the_command_line() -> None:
    """Labels, values, differences and units are those which the command prints."""
    begun: list[str] = []
    found = json.loads(ground_comparison.compare(SOFT, begun.append))
    assert len(begun) == ground_comparison.GROUNDS
    comparison = compare_grounds(casefile.loads(SOFT))
    rows = [*figure_rows(comparison), *constant_rows(comparison)]
    assert len(found["rows"]) == len(rows)
    for (label, unit, *cells), row in zip(found["rows"], rows, strict=True):
        assert (label[0], unit) == (row.label, row.unit)
        texts = [(cell, "") if isinstance(cell, str) else tuple(cell[:2]) for cell in cells]
        assert texts == list(row.texts())
