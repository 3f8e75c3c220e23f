"""Discretization errors of what checks demand: their size, whether a verdict hangs on them, and where they are told."""

from __future__ import annotations

import io
import json
import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from groundslab import Model, solve
from groundslab.design.checks import check_design
from groundslab.design.codes.en1992_2004.checks import punching
from groundslab.design.codes.en1992_2004.checks.punching_demand import Demand
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.demand_errors import error_of_greatest
from groundslab.design.rules.punching import Demands
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import CombinationResult, Results
from groundslab.views.report.html import render_report
from groundslab.views.summary.discretization import coarse_words
from groundslab.views.summary.json_summary import json_text
from groundslab.views.summary.terminal import between_text, print_summary
from groundslab.views.tables.result_tables import tables_of
from helpers import synthetic
from helpers.pages import page
from helpers.solve_once import solve_once

STEEL = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.03, 0.045)}
SERVICE = {"name": "SLS", "limit_state": "characteristic", "factors": {"G": 1.0}}


def settled(most: float, limit: float, **changes: Any) -> Results:
    """Return made-up results that settle as given [m] against a limit, by 0.4 mm less on a coarser mesh, error halved.

    They tilt by 2 mm, and by 0.4 mm less on the coarser mesh.
    """
    model = synthetic.model().replace(
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "q": 1e4, "case": "G"}],
        combinations=[SERVICE],
        **{"limits": {"settlement": limit}} | changes,
    )
    one = synthetic.in_contact(synthetic.results(4, model=model, combination="SLS", limit_state="characteristic"))
    x = one.plate.nodes[:, 0] / synthetic.LENGTH_X
    plate = replace(one.plate, settlement=most - 1e-3 + 2e-3 * x)
    found = synthetic.compared(replace(one, plate=plate), replace(plate, settlement=most - 1.2e-3 + 1.6e-3 * x))
    return Results(model, model.combinations, {"SLS": found}, {})


def only(combined: Results) -> DesignCheck:
    """Return the one check there is."""
    (check,) = check_design(combined).checks
    return check


def on_terminal(combined: Results) -> str:
    """Return the summary on the terminal on one line."""
    console = Console(file=io.StringIO(), width=80)
    print_summary(combined, console)
    return " ".join(console.file.getvalue().split())  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("limit", "verdict"),
    [
        (21e-3, "no failure found"),
        (20.3e-3, "no failure found, but within the error"),
        (19.7e-3, "fails, but within the error"),
        (19e-3, "fails"),
    ],
)
def test_a_verdict_hangs_where_the_limit_lies_within_the_error(limit: float, verdict: str) -> None:
    """20 mm +- 0.4 mm against limits on both sides; what fails is the demand alone, as ever."""
    check = only(settled(20e-3, limit))
    assert check.error == pytest.approx(0.4)
    assert check.between == pytest.approx((19.6e-3 / limit, 20.4e-3 / limit))
    assert check.utilization_error == pytest.approx(0.4e-3 / limit)
    assert check.verdict == verdict
    assert check.status == ("fails" if limit < 20e-3 else "no failure found")
    assert check.hangs == ("within" in verdict)


def test_a_least_value_hangs_the_other_way_round() -> None:
    """Of 96 +- 2 % in contact, 95 % asked for: 95 / 98 to 95 / 94; an error as large as the value has no end."""
    about = {"demand": 96.0, "resistance": 95.0, "least": True}
    check = DesignCheck("area in contact", "no failure found", "", error=2.0, **about)
    assert check.between == pytest.approx((95 / 98, 95 / 94))
    assert check.hangs
    assert not replace(check, error=0.5).hangs
    assert replace(check, error=96.0).between == (95 / 192, math.inf)


def test_what_is_exact_or_rounded_does_not_hang() -> None:
    """A pile at its limit on both meshes carries just that; errors that are rounding decide nothing."""
    at_limit = DesignCheck("pile", "fails", "", demand=1.0, resistance=1.0, error=0.0)
    assert not at_limit.hangs
    assert not replace(at_limit, error=1e-9).hangs
    assert replace(at_limit, error=1e-3).hangs


def test_without_a_coarser_mesh_no_error_is_told() -> None:
    """Nothing is None, not zero: no interval, no column in the table, no words."""
    combined = settled(20e-3, 20.3e-3)
    alone = replace(combined, results={"SLS": replace(combined["SLS"], comparison=None)})
    check = only(alone)
    assert (check.error, check.between, check.verdict) == (None, None, "no failure found")
    (table,) = (each for each in tables_of(alone) if each.name == "checks")
    assert not [column.name for column in table.columns if "error" in column.name]
    assert between_text(check) == ""
    assert json.loads(json_text(alone))["design"]["checks"][0]["between"] is None
    assert "within the error" not in on_terminal(alone)


def test_it_is_told_everywhere() -> None:
    """Headline, terminal, JSON, table and report have the interval, and say that the verdict hangs on it."""
    combined = settled(20e-3, 20.3e-3)
    headline = "No failure found in 1 check, 1 hangs on the discretization error; "
    assert check_design(combined).headline.startswith(headline)
    assert "0.99 (0.97 to 1.00) settlement: 20 <= 20.3 mm" in on_terminal(combined)
    assert "[no failure found, but within the error]" in on_terminal(combined)
    (listed,) = json.loads(json_text(combined))["design"]["checks"]
    assert listed["between"] == pytest.approx([19.6 / 20.3, 20.4 / 20.3])
    assert (listed["error"], listed["verdict"]) == (pytest.approx(0.4), "no failure found, but within the error")
    (table,) = (each for each in tables_of(combined) if each.name == "checks")
    assert table["verdict"] == ("no failure found, but within the error",)
    assert table["error of demand"] == (pytest.approx(0.4),)
    assert table["error of utilization"] == (pytest.approx(0.4 / 20.3),)
    first = page(render_report(combined, chapters=[])).one("table", class_="table checks").text
    assert "0.97 to 1.00" in first
    assert "±2.0 %" in first
    assert "but within the error" in first


@pytest.mark.parametrize(("least", "error"), [(18e-3, 0.0), (0.1e-3, 0.3), (-0.1e-3, 0.4)])
def test_what_is_no_demand_has_no_error(least: float, error: float) -> None:
    """Known to 0.4 mm, settlements of at least 18 mm are no uplift; of at least 0.1 mm they may be one of 0.3 mm."""
    combined = settled(20e-3, 1.0, limits={"uplift": 1e-3})
    one = combined["SLS"]
    plate = replace(one.plate, settlement=np.linspace(least, least + 1e-3, len(one.plate.nodes)))
    other = replace(plate, settlement=plate.settlement - 0.4e-3)
    found = synthetic.compared(replace(one, plate=plate), other)
    check = only(replace(combined, results={"SLS": found}))
    assert check.demand == pytest.approx(max(-1e3 * least, 0.0))
    assert check.error == pytest.approx(error)


def test_a_mesh_too_coarse_for_a_check() -> None:
    """Settlement is known to 2 %, a difference of settlements to 20 %: too coarse only where a verdict hangs on it."""
    words = "too coarse for a check: differential settlement is 0.95 +- 0.19 times its limit"
    limits = {"differential_settlement": 2.1e-3}
    assert words in coarse_words(settled(20e-3, 1.0, limits=limits))
    assert words not in coarse_words(settled(20e-3, 1.0, limits=limits, mesh={"accuracy": 0.2}))
    assert coarse_words(settled(20e-3, 1.0, limits={"differential_settlement": 4e-3})) == ""


def test_equal_extremes_at_different_places_are_no_agreement() -> None:
    """Where the coarser mesh has the same largest value elsewhere, what grew since decides, not the difference."""
    found = synthetic.compared(synthetic.results(4))
    values = {id(mesh): np.zeros(len(found.plate.nodes)) for mesh in (found.plate, found.comparison)}
    now, before = values.values()
    now[:2], before[:2] = (98.0, 100.0), (100.0, 97.0)
    meshes = {True: now, False: before}

    def of(mesh: CombinationResult) -> np.ndarray:
        return meshes[mesh.comparison is not None]

    half = np.full(len(now), 0.5)
    assert error_of_greatest(found, of, lambda: half) == pytest.approx(3.0)
    assert error_of_greatest(replace(found, comparison=None), of, lambda: half) is None


def test_links_that_may_not_suffice() -> None:
    """Where links are needed, the row says too whether what they can carry lies within the error."""
    steel = Reinforcement(**STEEL)

    def words(error: float) -> str:
        stress: Any = SimpleNamespace(
            v_Ed=1.48e6,
            u=4.0,
            beta=1.15,
            distance=0.5,
            supported=False,
            error=lambda: error * 1e6,
            way="code",
            outward=None,
        )
        demand = Demand("K1", "ULS", "ultimate", 1e6, 0.25, 1e6, None, (stress,))
        *_, within = punching.aspects("column", Demands({("ULS", "K1"): demand}), steel)
        within = within.worst(list(within.demands))
        assert within.status == "fails"
        assert within.error == pytest.approx(error)
        return within.words

    assert "0.973 to 1 times 1.5 v_Rd,c with the largest ratio that counts, within the error" in words(0.021)
    assert "within the error" not in words(0.01)


def test_pressure_under_a_line_load_on_springs() -> None:
    """A line load across a long strip, a Timoshenko beam on springs: the true ratio lies within what is told.

    EI w_xxxx - (k EI / S) w_xx + k w = q (delta - EI / S delta_xx) has w(0) in closed form, by its Fourier integral.
    """
    E, t, k, q, even = 30e9, 0.2, 20e6, 100e3, 20e3
    EI, S = E * t**3 / 12, 5 / 6 * E / 2 * t
    w = q / 2 * (1 / k**0.5 + EI**0.5 / S) / (k * EI / S + 2 * (EI * k) ** 0.5) ** 0.5
    true, limit = k * w + even, 1.0003 * (k * w + even)
    model = Model(
        plate={"length_x": 16, "length_y": 1, "thickness": t, "E": E, "nu": 0},
        ground={"kind": "winkler", "k": k},
        cases=[{"name": "G"}],
        loads=[
            {"kind": "line", "points": [(0, -0.5), (0, 0.5)], "q": q, "case": "G"},
            {"kind": "uniform", "q": even, "case": "G"},
        ],
        combinations=[SERVICE],
        limits={"pressure": limit},
        mesh={"size": 0.5},
    )
    check = next(each for each in check_design(solve(model)).checks if each.name == "pressure")
    low, high = check.between or (0.0, 0.0)
    assert check.verdict == "fails, but within the error"
    assert low < true / limit < high
    assert high - low < 0.05


LAID = {f"{face}_{axis}": {"diameter": 0.016, "spacing": 0.15} for face in ("bottom", "top") for axis in "xy"}
STATES = {"ULS": "ultimate", "SLS": "characteristic", "QP": "quasi-permanent"}
PUSHES = {"acts": "in compression"}
#: Rows whose demands are loads, distances or covers.
GIVEN = {
    "cover", "distance of bars", "distance of bars where bent most", "distance of bars for cracks",
    "clear distance of bars", "least bars for cracks", "bars for shrinkage and temperature", "uplift by actions",
}  # fmt: skip


def raft(size: float, **changes: Any) -> Model:
    """Return a raft with columns, a pile with a limit, a wall, and all limits of a case."""
    rows = [("A", -2.0, -1.2), ("B", 2.0, -1.2), ("C", -2.0, 1.2), ("D", 2.2, 1.2)]
    return Model(
        **{
            "plate": {"length_x": 8, "length_y": 6, "thickness": 0.4, "E": 30e9, "nu": 0.2},
            "ground": {"kind": "winkler", "k": 20e6},
            "columns": [{"name": name, "x": x, "y": y, "width_x": 0.4, "width_y": 0.4} for name, x, y in rows],
            "cases": [{"name": "G", "H_x": 5e4}],
            "loads": [
                *({"kind": "point", "column": name, "P": 5e5, "case": "G"} for name, _, _ in rows),
                {"kind": "line", "points": [(-3, 0.1), (3, 0.1)], "q": 5e4, "case": "G"},
            ],
            "supports": [
                {"kind": "point", "x": 0.5, "y": -2.5, "diameter": 0.3, "stiffness": 1e7, "limit": 4e5, **PUSHES},
            ],
            "combinations": [
                {"name": name, "limit_state": state, "factors": {"G": 1.35 if name == "ULS" else 1.0}}
                for name, state in STATES.items()
            ],
            "reinforcement": {**STEEL, **LAID, "w_max": 0.3e-3},
            "limits": {
                "settlement": 0.02, "uplift": 0.005, "differential_settlement": 0.01, "tilt": 0.002,
                "angular_distortion": 0.002, "deflection": 0.002, "pressure": 150e3, "mean_pressure": 100e3,
                "contact_share": 0.9,
            },
            "soil_strength": {"phi": 30, "unit_weight": 18e3},
            "mesh": {"size": size},
        }
        | changes
    )  # fmt: skip


ACI = {"reinforcement": {**STEEL, **LAID, "code": "ACI 318"}}
SECOND = {"reinforcement": {**{key: value for key, value in STEEL.items() if key != "exposure"}, **LAID,
                            "code": "EN 1992-1-1:2023"}}  # fmt: skip
FLOOR = {"reinforcement": None, "floor": {"kind": "ACI 360", "f_r": 4e6, "safety_factor": 2.0}}


def row(check: DesignCheck) -> tuple[str, str, str]:
    """Return which row a check is, wherever it governs."""
    return check.name, check.clause, check.of if check.name == "flexural stress" else ""


@pytest.mark.slow
@pytest.mark.parametrize("changes", [{}, ACI, SECOND, FLOOR], ids=["EN 1992", "ACI 318", "2023", "floor"])
def test_every_row_has_an_error_that_holds(changes: dict[str, Any]) -> None:
    """Each demand of the results has an error, and a mesh of an eighth of the size lies within it."""
    coarse, truth = (check_design(solve_once(raft(size, **changes))).checks for size in (0.5, 0.125))
    true = {row(check): check.utilization for check in truth}
    told = [check for check in coarse if check.demand is not None and check.name not in GIVEN]
    assert {check.name for check in told if check.error is None} == set()
    assert len(told) > 8
    for check in told:
        used, error = check.utilization, check.utilization_error
        assert used is not None
        assert error is not None
        exact = true[row(check)] or 0.0
        assert abs(used - exact) <= error + 2e-4, (check, exact)
