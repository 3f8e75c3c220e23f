"""The examples: each can be solved, and the sums that their comments work out by hand come out."""

from __future__ import annotations

from pathlib import Path

import pytest

from groundslab.analysis import solve
from groundslab.casefile import load

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.toml"))


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_examples_are_solved(path: Path) -> None:
    """Every example has a certified result."""
    assert solve(load(path)).certificate.holds


def test_the_raft_weighs_what_its_comment_says() -> None:
    """Own weight 5340, floor 2070, columns 9600 and walls 2400 kN: together 19410 kN on 414 m2."""
    results = solve(load(EXAMPLES[0].parent / "l_raft.toml"))
    assert results.certificate.load == pytest.approx(5340e3 + 2070e3 + 9600e3 + 2400e3, rel=1e-12)
    assert results.plate.area.sum() == pytest.approx(414, rel=1e-12)
