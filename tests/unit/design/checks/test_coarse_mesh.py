"""A design is not passed on a mesh that is known not to tell moments and shear forces."""

from __future__ import annotations

from typing import Any

import pytest

import groundslab as gs
from groundslab.design.checks import Design, check_design
from groundslab.model.model import Model

BARS = {"diameter": "20 mm", "spacing": "150 mm"}
LAYERS = ("bottom_x", "bottom_y", "top_x", "top_y")


def pad(loads: list[dict[str, Any]], **mesh: Any) -> Design:
    """Return the design of a pad of 4 m by 4 m by 0.5 m on springs, that passes all other checks."""
    model = Model(
        plate={"length_x": 4.0, "length_y": 4.0, "thickness": 0.5, "E": 33e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        columns=[{"name": "C", "x": 0, "y": 0, "width_x": 0.4, "width_y": 0.4}],
        cases=[{"name": "G"}],
        loads=loads,
        combinations=[{"name": "U", "factors": {"G": 1.35}}],
        reinforcement={
            "f_ck": 30e6,
            "f_yk": 500e6,
            "bottom": (0.05, 0.07),
            "top": (0.05, 0.07),
            "averaging": {"at_columns": "peak"},
        }
        | dict.fromkeys(LAYERS, BARS),
        mesh=mesh,
    )
    return check_design(gs.solve(model))


def test_elements_larger_than_a_footprint() -> None:
    """One element of 4 m below 1 MN gives a third of the moment: bars pass that 0.2 m elements ask twice as many of.

    The design needs attention; on elements of 0.4 m, as long as the column, nothing is said of them.
    """
    force = [{"kind": "point", "case": "G", "column": "C", "P": 1e6}]
    coarse, fine = pad(force, counts=(1, 1)), pad(force, counts=(10, 10))
    (check,) = [each for each in coarse.checks if each.name == "size of elements"]
    assert check.words.startswith("a footprint of 0.4 m in elements of 4 m")
    assert coarse.status == "attention"
    assert "size of elements" not in [each.name for each in fine.checks]
    needed = [
        max(each.demand or 0.0 for each in one.checks if each.name == "bars at the bottom y") for one in (coarse, fine)
    ]
    assert needed[1] > 1.5 * needed[0]


@pytest.mark.parametrize(("counts", "known"), [((1, 1), False), ((4, 4), True)])
def test_an_error_that_is_not_known(counts: tuple[int, int], known: bool) -> None:
    """One element has none twice as large to be compared with, whatever the loads; sixteen have."""
    names = [each.name for each in pad([{"kind": "uniform", "case": "G", "q": 50e3}], counts=counts).checks]
    assert ("size of elements" not in names) == known
