"""The bundled cases: every row of every published and analytic case holds, and a wrong number would be noticed."""

from __future__ import annotations

import dataclasses

import pytest

from groundslab.verification import runner

CASES = runner.case_names()
#: Where only the plan's mesh is off: the layers of a stack have errors of their own.
EXACT_CASES = (
    "circular_plates", "curling_slab", "edge_decay", "lifting_circle", "part_loaded_circles", "plate_on_a_column",
    "plate_on_pasternak", "point_load", "rigid_circles_on_continuum", "rigid_rectangles_on_half_space",
    "ring_loaded_circles", "spring_mat", "varying_ground",
)  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_every_row_of_a_case_passes(name):
    """Each row agrees with its source within its tolerance, deviates as explained, or is refuted by its proof.

    Where an answer is exact the error that is told is right, too.
    """
    case = runner.load(name)
    if not runner.can_run(case):
        pytest.skip(f"{name} needs {case.needs}, which cannot be imported here")
    outcomes = list(runner.outcomes_of(case))
    assert outcomes
    assert [o for o in outcomes if not o.ok] == []
    if name in EXACT_CASES:
        assert_errors_told_are_true(case, outcomes)


def assert_errors_told_are_true(case, outcomes):
    """Hold errors: none above 3 in 10,000 is underestimated by more than half; these small ones are below 1 %."""
    known = 0
    for row, outcome in zip(case.rows, outcomes, strict=True):
        if "exact" not in row or outcome.error is None:
            continue
        known += 1
        exact = runner._exact(row) / runner._unit(row)
        true = abs(outcome.computed - exact)
        assert outcome.error < 0.01 * abs(exact), outcome.label
        if true > 3e-4 * abs(exact):
            assert outcome.error > 0.5 * true, outcome.label
    assert known


def test_the_paper_is_there_in_full():
    """Tables 1 to 4 are held row by row: 27 settlements, then Table 2's, 3's and 4's numbers with k0, k1 and gamma."""
    rows = {name: runner.load(name).rows for name in ("table1", "table2", "table3", "table4")}
    settlements = [r for r in rows["table1"] if r["quantity"] == "settlement"]
    assert len(settlements) == 27
    wanted = {"table2": {"k0": 5, "k1": 5, "gamma": 4}, "table3": {"k0": 8, "k1": 4, "gamma": 4}}
    for name, quantities in wanted.items():
        for quantity, count in quantities.items():
            assert len([r for r in rows[name] if r["quantity"] == quantity]) == count
    assert len([r for r in rows["table4"] if r["label"] in ("w at A (fitted)", "w at B")]) == 2


def _with_row(name, number, **changes):
    case = runner.load(name)
    row = {**case.rows[number], **changes}
    return dataclasses.replace(case, rows=[row])


def test_a_wrong_published_number_fails():
    """A row whose published number is off by one per cent is reported as failed."""
    case = _with_row("compression", 0)
    exact = next(runner.outcomes_of(case))
    assert exact.ok
    wrong = _with_row("compression", 0, published=f"{exact.computed * 1.01:.6f}")
    assert not next(runner.outcomes_of(wrong)).ok


def test_an_explained_deviation_that_changes_fails():
    """A deviation that no longer has the size that its reason explains is reported as failed."""
    exact = next(runner.outcomes_of(_with_row("compression", 0)))
    published = f"{exact.computed / 1.05:.9f}"
    explained = _with_row("compression", 0, published=published, differs="5.0", why="of this test")
    assert next(runner.outcomes_of(explained)).ok
    changed = _with_row("compression", 0, published=published, differs="4.0", why="of this test")
    assert not next(runner.outcomes_of(changed)).ok


@pytest.mark.parametrize(("told", "ok"), [([0.7, 8.0], True), ([1.5, 8.0], False), ([0.1, 0.7], False)])
def test_a_told_error_is_held_to_the_true_one(told, ok):
    """A told error that is too small or too large for the true one is reported as failed."""
    outcome = next(runner.outcomes_of(_with_row("told_continuum", 0, told=told)))
    assert outcome.ok is ok
    assert outcome.difference.startswith("true 0.77 %, told ")


def test_a_tolerance_wider_than_the_value_is_an_error():
    """A row that could not fail is refused."""
    case = _with_row("compression", 0, tolerance="100 mm")
    with pytest.raises(ValueError, match="checks nothing"):
        next(runner.outcomes_of(case))


@pytest.mark.parametrize(("drift", "ok"), [(0.9e-5, True), (1.1e-5, False)])
def test_a_value_that_has_changed_fails_within_its_tolerance_too(monkeypatch, drift, ok):
    """A row that agrees with its source fails where our own number is not the pinned one."""
    case = _with_row("compression", 0)
    label, value = case.rows[0]["label"], next(runner.outcomes_of(case)).computed
    monkeypatch.setattr(runner, "pinned", lambda: {"compression": {label: value * (1 + drift)}})
    outcome = next(runner.outcomes_of(case))
    assert outcome.ok is ok
    assert outcome.reason.startswith("our own number was") is not ok


def test_a_row_without_a_pinned_value_fails(monkeypatch):
    """A new row needs its value pinned."""
    monkeypatch.setattr(runner, "pinned", dict)
    outcome = next(runner.outcomes_of(_with_row("compression", 0)))
    assert not outcome.ok
    assert outcome.reason.startswith("no value is pinned")


def test_pinned_values_are_those_of_rows():
    """No case or row is pinned that is not there, and all labels of a case differ."""
    for name, values in runner.pinned().items():
        labels = [row["label"] for row in runner.load(name).rows]
        assert len(set(labels)) == len(labels)
        assert list(values) == labels


@pytest.mark.slow
def test_a_proof_that_does_not_hold_fails():
    """Calling a right number impossible is reported as failed: 13.59 mm is in equilibrium."""
    case = runner.load("table1")
    number = next(i for i, row in enumerate(case.rows) if "gamma 1.1316, x = 0.0" in row["label"])
    proof = case.rows[number]["proof"]
    x = proof["x"]
    from groundslab.analysis import driver

    plate = driver.solve(runner.model_of(case, "gamma 1.1316")).plate
    ours = [plate.value_at("settlement", place, 0.0) * 1e3 for place in x]
    row = {**case.rows[number], "proof": {**proof, "published_mm": ours}}
    assert not next(runner.outcomes_of(dataclasses.replace(case, rows=[row]))).ok
