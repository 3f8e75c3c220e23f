"""Discretization errors of a study's outputs: those of the case as it is, in rows, tables and on the page."""

from __future__ import annotations

import csv
import sqlite3
from dataclasses import replace
from pathlib import Path

import pytest

import groundslab
from groundslab.accuracy.values import estimate_error
from groundslab.case import casefile
from groundslab.study.definition import outputs
from groundslab.study.evaluation.samples import read_samples
from groundslab.study.evaluation.study import Study
from groundslab.study.evaluation.tables import tabulate_discretization
from helpers.studies import CASE, run

pytestmark = pytest.mark.slow

#: Two variants of the slab, with outputs of every sort.
STUDY = """
case = "slab.toml"
[sampling]
kind = "list"
[[vary]]
path = "ground.k"
values = ["15 MPa/m", "25 MPa/m"]
[[keep]]
of = "settlement"
take = "largest"
[[keep]]
of = "moment x"
take = "at"
x = "1.5 m"
y = "0 m"
combination = "service"
[[keep]]
of = "tilt x"
[[keep]]
of = "load"
[[keep]]
of = "settlement"
take = "everywhere"
"""


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Study:
    """Return the study on 8 by 6 elements."""
    return run(tmp_path_factory.mktemp("study"), STUDY)


def test_errors_are_those_of_the_case(study: Study) -> None:
    """Value and error are those of solving the case itself, of the worst combination; loads and fields have none."""
    found = study.discretization_errors()
    combined = groundslab.solve(casefile.loads(CASE))
    w = {name: each.plate.settlement.max() for name, each in combined.items()}
    worst = max(w, key=lambda name: w[name])
    results = combined[worst]
    assert results.coarser is not None
    assert results.comparison is not None
    error = estimate_error(w[worst], results.coarser.plate.settlement.max(), results.comparison)
    assert found["largest settlement"] == pytest.approx((w[worst], error), rel=1e-4)
    assert list(found) == ["largest settlement", "moment x at (1.5, 0) m under service", "tilt x"]
    assert all(0 < error < 0.5 * abs(value) for value, error in found.values())


def test_errors_fall_with_the_size_of_elements(tmp_path: Path) -> None:
    """On elements half as large each of them is smaller, and the value within the error that was told before."""
    found = []
    for counts in ("[16, 12]", "[32, 24]"):
        folder = tmp_path / counts
        folder.mkdir()
        found.append(run(folder, STUDY, CASE.replace("[8, 6]", counts)).discretization_errors())
    before, after = found
    assert before.keys() == after.keys()
    for name, (value, error) in after.items():
        assert error < 0.8 * before[name][1], name
        assert abs(value - before[name][0]) < before[name][1], name


def test_no_coarser_mesh_no_errors(tmp_path: Path) -> None:
    """On one element each way nothing is told: no row of errors, no table of them; the rows are as ever."""
    found = run(tmp_path, STUDY, CASE.replace("[8, 6]", "[1, 1]"))
    assert len(found) == 2
    assert found.discretization_errors() == {}
    assert tabulate_discretization(read_samples(found)) is None


def test_a_case_that_cannot_be_solved(tmp_path: Path) -> None:
    """Where only the variants have equilibrium, they have rows and no errors."""
    study = STUDY.replace("ground.k", "loads[1].q").replace("15 MPa/m", "2 kPa").replace("25 MPa/m", "3 kPa")
    found = run(tmp_path, study, CASE.replace('q = "2 kPa"', 'q = "-300 kPa"'))
    assert found.counts() == {"solved": 2}
    assert found.discretization_errors() == {}


def test_deflections_are_compared_by_size() -> None:
    """A largest deflection that is as far up on the coarser mesh as it is down on the finer one has no error."""
    combined = groundslab.solve(casefile.loads(CASE))
    results = combined["design"]
    assert results.comparison is not None
    turned = replace(results.comparison.plate, settlement=-results.plate.settlement)
    changed = replace(results, comparison=replace(results.comparison, plate=turned))
    found = {
        of: outputs.error_of(
            outputs.RequestedOutput(name=of, of=of), replace(combined, results={"design": changed}), ["design"]
        )
        for of in ("deflection", "tilt x")
    }
    assert found["deflection"] is not None
    assert found["deflection"][1] == pytest.approx(0, abs=1e-12)
    assert found["tilt x"] is not None
    assert found["tilt x"][1] > 0.01 * abs(found["tilt x"][0])


def test_page_and_files(study: Study) -> None:
    """In the table in the unit of display, on the page in percent under the value, in the store in SI units."""
    pytest.importorskip("jinja2")
    value, error = study.discretization_errors()["largest settlement"]
    paths = {path.name: path for path in groundslab.study.evaluate(study)}
    with paths["discretization.csv"].open(encoding="utf-8", newline="") as file:
        first = next(csv.DictReader(file))
    assert (first["output"], first["unit"]) == ("largest settlement", "mm")
    assert float(first["value in the case"]) == pytest.approx(1e3 * value)
    assert float(first["discretization error"]) == pytest.approx(1e3 * error)
    text = paths["report.html"].read_text(encoding="utf-8")
    assert "Discretization errors of the case" in text
    share = 100 * error / value
    shown = "±&lt;0.1 %" if share < 0.1 else f"±{share:.1f} %"
    assert f"<small>{shown}</small>" in text
    assert "discretization error</th>" not in text
    with sqlite3.connect(study.folder / "rows.sqlite") as kept:
        assert kept.execute("SELECT value, error FROM discretization").fetchone() == (value, error)
