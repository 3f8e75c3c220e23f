"""Limits of settlements, tilt and pressures: each by a made-up field with a known answer, and what governs."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.design.checks import DesignCheck, check_design
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.tables.result_tables import table_makers
from helpers import synthetic
from helpers.calculations import follow, follow_steps
from helpers.synthetic import LENGTH_X, LENGTH_Y

STATES = {"ULS": "ultimate", "SLS 1": "characteristic", "SLS 2": "quasi-permanent"}


def model_with(loads: tuple[dict[str, Any], ...] = (), **limits: float) -> Model:
    """Return a slab with two columns along x, one ultimate and two other combinations, and limits."""
    half = LENGTH_X / 4
    return Model(
        plate={"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.4, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        columns=[{"name": "A", "x": -half, "y": 0, "diameter": 0.3}, {"name": "B", "x": half, "y": 0, "diameter": 0.3}],
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "q": 1e4, "case": "G"}, *loads],
        combinations=[{"name": name, "limit_state": state, "factors": {"G": 1.0}} for name, state in STATES.items()],
        limits=limits,
    )


def solved(model: Model, **fields: dict[str, Any]) -> Results:
    """Return made-up results: of each combination, by its name with _ for a blank, a field by its name over x."""
    made = {}
    for each in model.combinations:
        one = synthetic.results(6, model=model, combination=each.name, limit_state=each.limit_state,
                                factors=each.factors)  # fmt: skip
        x = one.plate.nodes[:, 0]
        own = {name: make(x) for name, make in fields.get(each.name.replace(" ", "_"), {}).items()}
        flat = {"settlement": np.zeros(len(x)), "pressure": np.zeros(len(x))}
        made[each.name] = replace(one, plate=replace(one.plate, **flat | own))
    return Results(model, model.combinations, made, {})


def only(combined: Results) -> DesignCheck:
    """Return the one check there is."""
    (check,) = check_design(combined).checks
    return check


def test_settlement_of_the_worst_combination_counts_but_no_ultimate_one() -> None:
    """30 mm in an ultimate combination are no matter; of 12 and 20 mm the larger is, in its own combination."""
    fields = {
        "ULS": {"settlement": lambda x: 0.030 + 0 * x},
        "SLS_1": {"settlement": lambda x: 0.012 + 0 * x},
        "SLS_2": {"settlement": lambda x: 0.020 + 0 * x},
    }
    check = only(solved(model_with(settlement=0.025), **fields))
    assert (check.status, check.combination) == ("no failure found", "SLS 2")
    assert (check.demand, check.resistance, check.unit) == pytest.approx((20.0, 25.0, "mm"))
    assert check.utilization == pytest.approx(0.8)
    failing = only(solved(model_with(settlement=0.016), **fields))
    assert failing.status == "fails"
    assert failing.words.startswith("20 > 16 mm at (")


def test_tilt_and_differences_of_an_inclined_plate() -> None:
    """A slope of 1/500 along x: the tilt; its difference over the length; no distortion without it."""
    fields = {"SLS_1": {"settlement": lambda x: 0.02 + 0.002 * x}}
    found = {each.name: each for each in check_design(solved(
        model_with(tilt=0.003, differential_settlement=0.1, angular_distortion=0.002), **fields)).checks}  # fmt: skip
    assert found["tilt"].demand == pytest.approx(2.0)
    assert found["differential settlement"].demand == pytest.approx(2.0 * LENGTH_X)
    assert found["angular distortion"].demand == pytest.approx(0.0, abs=1e-9)


def test_pressure_and_uplift() -> None:
    """The largest pressure at its place, the largest uplift as a positive length."""
    fields = {
        "SLS_1": {"settlement": lambda x: -0.001 - 0 * x, "pressure": lambda x: 1e5 * (x == x.max())},
    }
    found = {each.name: each for each in check_design(solved(model_with(pressure=9e4, uplift=2e-3), **fields)).checks}
    assert found["pressure"].status == "fails"
    assert found["pressure"].demand == pytest.approx(100.0)
    assert found["pressure"].place is not None
    assert found["pressure"].place[0] == pytest.approx(LENGTH_X / 2)
    assert found["uplift"].demand == pytest.approx(1.0)


def test_a_pressure_whose_error_is_not_known_says_so() -> None:
    """On ground with shear pressures at the end of a line have no limit; on springs they follow the settlement."""
    line = {"kind": "line", "points": [(-1.0, 0.0), (1.0, 0.0)], "q": 3e5, "case": "G"}
    model = model_with((line,), pressure=1e3).replace(mesh={"size": 1.0})
    on_springs, with_shear = (
        next(each for each in check_design(gs.solve(model.replace(ground=ground))).checks if each.name == "pressure")
        for ground in (model.ground, {"kind": "pasternak", "k0": 20e6, "k1": 20e6})
    )
    assert on_springs.error is not None
    assert not on_springs.words.startswith("where pressures jump")
    assert with_shear.words.startswith("where pressures jump or grow with finer meshes, without a known error: ")
    assert with_shear.error is None


def test_the_plane_of_an_inclined_plate_by_hand() -> None:
    """Over a rectangle S_xx is l_x^2 / 12, and S_xw of a slope of 2 mm/m twice that; across there is none."""
    fields = {"SLS_1": {"settlement": lambda x: 0.02 + 0.002 * x}}
    (check,) = check_design(solved(model_with(tilt=0.004), **fields)).checks
    known = follow_steps(check.steps)
    assert (known["omega_x"], known["omega_y"]) == pytest.approx((2.0, 0.0), abs=1e-9)
    # nodes are weighed by their share of the area, whose quadrature of x^2 is exact on Q9
    assert (known["S_xx"], known["S_xw"]) == pytest.approx((LENGTH_X**2 / 12, LENGTH_X**2 / 6), rel=0.03)
    assert known["S_xw"] == pytest.approx(2.0 * known["S_xx"])
    assert (known["omega_lim"], known["eta"]) == pytest.approx((4.0, 0.5))


def test_two_columns_by_hand() -> None:
    """On w = 0.02 + c x^2 columns at -l / 4 and l / 4 settle the same; the middle is c l^2 / 16 off their chord."""
    c = 1e-4
    fields = {"SLS_1": {"settlement": lambda x: 0.02 + c * x**2}}
    combined = solved(model_with(deflection=0.01, angular_distortion=0.002, differential_settlement=0.1), **fields)
    found = {each.name: follow_steps(each.steps) for each in check_design(combined).checks}
    sag, ends = found["deflection between columns"], c * LENGTH_X**2 / 16 * 1e3
    assert (sag["w_1"], sag["w_2"], sag["l"]) == pytest.approx((20 + ends, 20 + ends, LENGTH_X / 2))
    assert (sag["xi"], sag["w"], sag["Delta_l"]) == pytest.approx((0.5, 20.0, 2 * ends / LENGTH_X))
    apart = found["angular distortion"]
    assert (apart["x_1"], apart["x_2"], apart["l"]) == pytest.approx((-LENGTH_X / 4, LENGTH_X / 4, LENGTH_X / 2))
    assert (apart["w_1"], apart["beta"]) == pytest.approx((20 + ends, 0.0), abs=1e-9)
    assert found["differential settlement"]["Delta_w"] == pytest.approx(4 * ends)


def test_limits_are_followed() -> None:
    """On a solved slab each value from those above it, the shares those of the checks, with the error where known."""
    limits = {"settlement": 5e-3, "uplift": 1e-3, "differential_settlement": 5e-3, "tilt": 2e-3, "deflection": 1e-3,
              "angular_distortion": 2e-3, "pressure": 2e5, "mean_pressure": 1e5, "contact_share": 0.9}  # fmt: skip
    loads = {"kind": "point", "column": "B", "P": 400e3, "case": "G"}
    combined = gs.solve(model_with(loads=(loads,), **limits))
    checks = {each.name: each for each in check_design(combined).checks if each.clause == "limits of the case"}
    assert len(checks) == len(limits)
    for check in checks.values():
        known = follow_steps(check.steps)
        assert known["eta"] == pytest.approx(check.utilization)
        assert ("eta_e" in known) == (check.error is not None)
        if check.between is not None:
            assert known["eta_e"] == pytest.approx(check.between[1])
    assert follow(table_makers(combined)["calculations"]()) > 10


def test_what_must_not_be_less() -> None:
    """An area in contact below its limit fails, and is used by more than 1."""
    combined = solved(model_with(contact_share=0.5))
    share = min(each.plate.contact_share for each in combined.values() if each.limit_state != "ultimate")
    check = only(combined)
    assert check.least
    assert check.demand == pytest.approx(100 * share)
    assert check.utilization == pytest.approx(0.5 / share)
    assert check.status == ("no failure found" if share >= 0.5 else "fails")


def test_limits_without_results_need_attention() -> None:
    """Where no serviceability combination is solved, nothing is said to hold."""
    combined = solved(model_with(settlement=0.01))
    alone = replace(combined, results={"ULS": combined.results["ULS"]}, refused={
        name: InputError([]) for name in ("SLS 1", "SLS 2")})  # fmt: skip
    design = check_design(alone)
    assert [each.status for each in design.checks] == ["attention", "attention"]
    assert design.checks[0].words.startswith('not judged: no certified result of "SLS 1", "SLS 2"')
    none = replace(alone, combinations=combined.combinations[:1], refused={})
    words = [each.words for each in check_design(none).checks]
    assert "not judged: the case has no serviceability combination; add such a combination" in words


def test_no_limit_is_an_error() -> None:
    """An empty section says nothing."""
    with pytest.raises(InputError, match="at least one"):
        model_with()
