"""Strips that a slab consists of are found as the beams that an engineer would write."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

import groundslab as gs
from groundslab.case import casefile
from groundslab.model.model import Model
from groundslab.model.remarks.grade_beams import as_toml, find_strips
from groundslab.model.remarks.remarks import find_remarks

EXAMPLE = Path(__file__).parents[4] / "examples" / "grade_beams.toml"
STEEL = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.05, 0.066), "top": (0.05, 0.066)}


def slab(points: list[tuple[float, float]], *, thickness: float = 0.5, **changes: Any) -> Model:
    """Return a slab with an outline."""
    return Model(
        plate={"outline": {"kind": "polygon", "points": points}, "thickness": thickness, "E": 33e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "case": "G", "q": 1e4}],
        combinations=[{"name": "U", "factors": {"G": 1.35}}],
        reinforcement=STEEL,
        **changes,
    )


def found(model: Model) -> set[tuple[Any, ...]]:
    """Return what is found: start, end and width."""
    return {(*strip.start, *strip.end, strip.width) for strip in find_strips(model)}


def test_a_ring_of_beams_is_that_of_the_example() -> None:
    """With its strips left out, the same four are found."""
    model = gs.load(EXAMPLE)
    bare = model.model_copy(update={"output": model.output.model_copy(update={"strips": ()})})
    assert found(bare) == {(*strip.start, *strip.end, strip.width) for strip in model.output.strips}
    assert find_strips(model) == ()  # they lie on those that are there


def test_t_and_cross_go_to_their_far_edges() -> None:
    """A T has two beams, a cross two, one of which ends at neither edge of the other."""
    tee = [(0.0, 0.0), (10.0, 0.0), (10.0, 1.0), (5.5, 1.0), (5.5, 6.0), (4.5, 6.0), (4.5, 1.0), (0.0, 1.0)]
    assert found(slab(tee)) == {(0, 0.5, 10, 0.5, 1), (5, 0, 5, 6, 1)}
    cross = [(4.0, 0.0), (5.0, 0.0), (5.0, 3.0), (8.0, 3.0), (8.0, 4.0), (5.0, 4.0), (5.0, 8.0), (4.0, 8.0),
             (4.0, 4.0), (0.0, 4.0), (0.0, 3.0), (4.0, 3.0)]  # fmt: skip
    assert found(slab(cross)) == {(0, 3.5, 8, 3.5, 1), (4.5, 0, 4.5, 8, 1)}


@pytest.mark.parametrize(
    "points",
    [
        [(0.0, 0.0), (10.0, 0.0), (10.0, 3.0), (0.0, 3.0)],  # wider than 2.5 m
        [(0.0, 0.0), (10.0, 1.0), (10.0, 2.0), (0.0, 1.0)],  # at an angle
        [(0.0, 0.0), (10.0, 0.0), (10.0, 2.0), (5.0, 2.0), (5.0, 1.0), (0.0, 1.0)],  # becomes wider
    ],
    ids=["wide", "oblique", "widening"],
)
def test_what_is_no_grid_of_strips_has_none(points: list[tuple[float, float]]) -> None:
    """Nothing is guessed where strips do not cover the plan or lie on each other."""
    assert find_strips(slab(points)) == ()


def test_entries_of_the_remark_can_be_pasted() -> None:
    """The case with them has the beams, and the remark no more."""
    text = EXAMPLE.read_text(encoding="utf-8")
    bare = re.sub(r"\[\[output\.strips\]\]\n(?:[^\[\n].*\n)*", "", text)
    bare = re.sub(r"\[\[reinforcement\.beam_links\]\]\n(?:[^\[\n].*\n)*", "", bare)
    (remark,) = [each for each in find_remarks(casefile.loads(bare)) if "nowhere wider" in each.words]
    entries = str(remark.words).partition("\n\n")[2]
    assert entries == as_toml(find_strips(casefile.loads(bare)))
    model = casefile.loads(f"{bare}\n{entries}")
    assert [strip.design for strip in model.output.strips] == ["beam"] * 4
    assert not any("nowhere wider" in each.words for each in find_remarks(model))
