"""A made-up third code, of one clause, goes through tables and checks; what it has no rule for stays open."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple, get_args

import numpy as np
import pytest

from groundslab.arrays import Array
from groundslab.design.checks import check_design
from groundslab.design.codes.registry import CODES
from groundslab.design.rules import bending
from groundslab.design.rules.bending import BendingRule, Block
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import NO_RULE, DesignCheck
from groundslab.design.rules.design_code import Clauses, DesignCode, PunchingRule
from groundslab.design.rules.punching import Aspect, Demands
from groundslab.model.design.reinforcement import KEYS_OF_CODES, Code, Reinforcement
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.report.html import render_report
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


class Pushed(NamedTuple):
    """What punches: the force of a column."""

    name: str
    combination: str
    force: float
    pulls: bool = False
    supported: bool = False
    sketch: None = None


RESISTS = 100e3
PUNCHING_RULE = PunchingRule(
    demands={"column": lambda _: Demands({("ULS", "C1"): Pushed("C1", "ULS", 120e3)})},
    used=lambda demand, _: demand.force / RESISTS,
    aspects=lambda _, demands, __: [Aspect("punching", demands.found.values(), lambda _: 1.2, judge)],
    steps=lambda demand, *_: [Step("force that punches", "V", demand.force / 1e6, "MN", clause="2")],
    heads=lambda _: (("V", "kN"),),
    cells=lambda demand, *_: [demand.force / 1e3],
)
THIRD = DesignCode("Third", Clauses("1", "1.1", "1.2"), bending_of, punching=PUNCHING_RULE)


def judge(judged: list[Pushed]) -> DesignCheck:
    """Return the only check."""
    return DesignCheck("punching", "fails", "too much", of=judged[0].name, combination=judged[0].combination)


@pytest.fixture
def third(monkeypatch: pytest.MonkeyPatch) -> Results:
    """Return results of a slab under one even moment along x, of a case that is designed by the third code."""
    monkeypatch.setitem(CODES, "Third", THIRD)
    monkeypatch.setitem(KEYS_OF_CODES, "Third", ())
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
    assert tables["columns"]["V"] == (120.0,)
    assert "force that punches" in tables["calculations"]["quantity"]
    page = render_report(third)
    assert "force that punches" in page
    assert "Third" in page


def test_checks_follow_a_third_code_and_leave_the_rest_open(third: Results) -> None:
    """Laid bars are held against its clause; shear and detailing, of which it has no rule, need attention."""
    checks = {check.name: check for check in check_design(third).checks}
    bars = checks["bars at the bottom x"]
    assert (bars.status, bars.clause) == ("fails", "Third 1")
    assert bars.demand == pytest.approx(NEEDED * 1e4)
    assert bars.resistance == pytest.approx(math.pi * 1.2**2 / 4 / 0.15)
    assert (checks["punching"].status, checks["punching"].words) == ("fails", "too much")
    for name in ("one-way shear", "distance and cover of bars"):
        assert checks[name].status == "attention"
        assert checks[name].unjudged is NO_RULE
        assert checks[name].words.startswith("not judged: Third has no rule for it here; ")


def test_the_key_offers_what_the_registry_has() -> None:
    """Each word of `code` has an entry, and its own keys."""
    assert get_args(Code) == tuple(CODES) == tuple(KEYS_OF_CODES)
