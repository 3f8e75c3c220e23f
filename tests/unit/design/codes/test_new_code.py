"""A made-up third code, of one clause, goes through tables and checks; what it has no rule for stays open."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import Any, get_args

import numpy as np
import pytest

from groundslab.arrays import Array
from groundslab.design.checks import check_design
from groundslab.design.codes.registry import CODES
from groundslab.design.rules import bending
from groundslab.design.rules.bending import BendingRule, Block
from groundslab.design.rules.check import NO_RULE
from groundslab.design.rules.design_code import Clauses, DesignCode
from groundslab.model.design.reinforcement import KEYS_OF_CODES, Code, Reinforcement
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.tables.result_tables import tables_of
from helpers import synthetic
from helpers.synthetic import LENGTH_X, LENGTH_Y

THICKNESS, AXIS, M = 0.4, 0.05, 80e3
F_C, F_Y = 12e6, 300e6
#: A of M = A f_y (d - A f_y / (2 f_c)), 7.84 cm2/m.
NEEDED = F_C / F_Y * (THICKNESS - AXIS - math.sqrt((THICKNESS - AXIS) ** 2 - 2 * M / F_C))


# the code: a block of the whole depth above the axis, bars that yield, and one per mille of the section at least
def least(d: Array, thickness: Array | float | None = None) -> Array:
    """Return one per mille of the section [m2/m]."""
    assert thickness is not None
    return 1e-3 * np.asarray(thickness) + np.zeros(np.shape(d))


def bending_of(_: Reinforcement, __: str) -> BendingRule:
    """Return the only rule."""
    block = Block(stress=F_C, depth=1.0, eps_cu=3e-3, f_y=F_Y, E_s=200e9, xi=0.4, most=np.inf)
    return BendingRule(partial(bending.required, block, minimum=least), least)


THIRD = DesignCode("Third", Clauses(bars="1", least_bars="1.1", held_bars="1.2"), bending_of)


@pytest.fixture
def third(monkeypatch: pytest.MonkeyPatch) -> Results:
    """Return results of a slab under one even moment along x, of a case that is designed by the third code."""
    monkeypatch.setitem(CODES, "Third", THIRD)
    bar = {"diameter": 0.012, "spacing": 0.15}
    steel: dict[str, Any] = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (AXIS, AXIS), "top": (AXIS, AXIS)}
    model = Model(
        plate={"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": THICKNESS, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        columns=[{"name": "C1", "x": 0, "y": 0, "width_x": 0.3, "width_y": 0.3}],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "P": 100e3, "column": "C1", "case": "G"}],
        combinations=[{"name": "ULS", "factors": {"G": 1.2}}],
        reinforcement=steel | dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), bar),
    )  # fmt: skip
    assert model.reinforcement is not None
    by_third = model.reinforcement.model_copy(update={"code": "Third"})
    model = model.model_copy(update={"reinforcement": by_third})
    one = synthetic.results(6, model=model, combination="ULS", limit_state="ultimate", factors=(("G", 1.2),))
    flat = np.zeros(len(one.plate.nodes))
    plate = replace(one.plate, moment_x=flat + M, moment_y=flat, moment_xy=flat)
    return Results(model, model.combinations, {"ULS": replace(one, plate=plate)}, {})


def test_tables_arrange_what_a_third_code_finds(third: Results) -> None:
    """The area is that of a rectangular block by hand; notes name the code."""
    tables = {table.name: table for table in tables_of(third)}
    table = tables["reinforcement"]
    by_layer = dict(zip(table["layer"], table["required area"], strict=True))
    assert by_layer["bottom x"] == pytest.approx(NEEDED * 1e4)
    assert table["minimum area"][0] == pytest.approx(1e-3 * THICKNESS * 1e4)
    assert table.notes[0].startswith("By Third for Wood's design moments")
    assert not [column.name for column in tables["columns"].columns if "v_" in column.name]


def test_checks_follow_a_third_code_and_leave_the_rest_open(third: Results) -> None:
    """Laid bars are held against its clause; shear, punching and detailing, of which it has no rule, need attention."""
    checks = {check.name: check for check in check_design(third).checks}
    bars = checks["bars at the bottom x"]
    assert (bars.status, bars.clause) == ("fails", "Third 1")
    assert bars.demand == pytest.approx(NEEDED * 1e4)
    assert bars.resistance == pytest.approx(math.pi * 1.2**2 / 4 / 0.15)
    for name in ("one-way shear", "punching", "distance and cover of bars"):
        assert checks[name].status == "attention"
        assert checks[name].unjudged is NO_RULE
        assert checks[name].words.startswith("not judged: Third has no rule for it here; ")


def test_the_key_offers_what_the_registry_has() -> None:
    """Each word of `code` has an entry, and its own keys."""
    assert get_args(Code) == tuple(CODES) == tuple(KEYS_OF_CODES)
