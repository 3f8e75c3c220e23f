"""Slabs that crack in an analysis: zones and ground that vary, what is told of it, files, failure to converge."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from groundslab import plot
from groundslab.analysis import cracking_iteration
from groundslab.analysis.driver import solve
from groundslab.case import casefile
from groundslab.design.checks import check_design
from groundslab.errors import NotConverged
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.files.results_folder import load_results, save_results
from groundslab.views.summary.sections import summary

CASE = """
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "0.25 m"
E = "33 GPa"
nu = 0.2
[[plate.zones]]
thickness = "0.4 m"
shape = { kind = "rectangle", x = ["-1 m", "1 m"], y = ["-1 m", "1 m"] }
[ground]
kind = "vlasov"
[[ground.layers]]
E = "20 MPa"
nu = 0.3
thickness = "4 m"
[beyond]
kind = "infinite"
[[boreholes]]
x = "-3 m"
y = "0 m"
layers = [{ E = "15 MPa", nu = 0.3, thickness = "4 m" }]
[[boreholes]]
x = "3 m"
y = "0 m"
layers = [{ E = "8 MPa", nu = 0.3, thickness = "5 m" }]
[[columns]]
name = "A"
x = "-2 m"
y = "0 m"
width_x = "0.4 m"
width_y = "0.4 m"
[[columns]]
name = "B"
x = "2 m"
y = "0 m"
width_x = "0.4 m"
width_y = "0.4 m"
[[cases]]
name = "G"
[[loads]]
kind = "point"
case = "G"
column = "A"
P = "500 kN"
[[loads]]
kind = "point"
case = "G"
column = "B"
P = "500 kN"
[[combinations]]
name = "Ed"
factors = { G = 1.0 }
[[combinations]]
name = "qp"
limit_state = "quasi-permanent"
factors = { G = 1.0 }
[reinforcement]
concrete = "C30/37"
steel = "B500B"
bottom = ["45 mm", "60 mm"]
top = ["45 mm", "60 mm"]
bottom_x = { diameter = "14 mm", spacing = "100 mm" }
bottom_y = { diameter = "14 mm", spacing = "100 mm" }
top_x = { diameter = "12 mm", spacing = "150 mm" }
top_y = { diameter = "12 mm", spacing = "150 mm" }
[cracking]
creep = 2.0
shrinkage = 0.0002
[limits]
deflection = 0.004
[mesh]
size = "0.4 m"
"""


@pytest.fixture(scope="module")
def results() -> Results:
    """Return the results of the case, elastic and cracked."""
    return solve(casefile.loads(CASE))


def test_zones_have_sections_of_their_own(results: Results) -> None:
    """Only the thin part cracks; moments leave it, and the result is certified, its coarser mesh compared."""
    elastic, cracked = results["Ed"], results["qp"]
    ratio, zone = cracked.elements.stiffness_ratio, cracked.elements.section
    assert ratio is not None
    assert ratio[zone == 1].min() > ratio[zone == 0].min()
    assert ratio.min() < 0.7
    assert cracked.plate.moment_x.max() < elastic.plate.moment_x.max()
    assert cracked.plate.settlement.max() > elastic.plate.settlement.max()
    assert cracked.certificate.holds
    assert cracked.comparison is not None
    assert cracked.comparison.energy_error < 0.1


def test_what_is_told(results: Results) -> None:
    """The summary of the cracked combination says so, that of the other does not; deflection is checked."""
    told = {name: {section.key for section in summary(results[name])} for name in ("Ed", "qp")}
    assert "cracking" in told["qp"]
    assert "cracking" not in told["Ed"]
    found = {check.name: check for check in check_design(results).checks}["deflection between columns"]
    assert found.combination == "qp"
    assert found.of == "A - B"
    w = results["qp"].plate
    chord = (w.value_at("settlement", -2.0, 0.0) + w.value_at("settlement", 2.0, 0.0)) / 2
    assert found.demand is not None
    assert found.demand / 1e3 >= abs(w.value_at("settlement", 0.0, 0.0) - chord) / 4 * (1 - 1e-9)


def test_files_and_pictures(results: Results, tmp_path: Path) -> None:
    """The archive gives back stiffness and certificate, and the stiffness is drawn."""
    again = load_results(save_results(results, tmp_path / "out"))
    assert isinstance(again, Results)
    assert again["qp"].certificate == results["qp"].certificate
    np.testing.assert_array_equal(again["qp"].elements.stiffness_ratio, results["qp"].elements.stiffness_ratio)
    plot(results, "stiffness_ratio", combination="qp", to=tmp_path / "ratio.png")
    assert (tmp_path / "ratio.png").stat().st_size > 10_000


def test_a_stiffness_that_does_not_settle_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without steps enough the combination is refused with the history of its errors, and the other is solved."""
    monkeypatch.setattr(cracking_iteration, "MAX_ITERATIONS", 2)
    found = solve(casefile.loads(CASE))
    assert set(found.results) == {"Ed"}
    refusal = found.refused["qp"]
    assert isinstance(refusal, NotConverged)
    assert refusal.what == "the cracked stiffness"
    assert len(refusal.history) == 2


def test_combinations_of_the_same_factors_crack_apart() -> None:
    """Combinations of the same loads are solved apart where only one of them cracks."""
    model: Model = casefile.loads(CASE)
    model = model.replace(
        combinations=(*model.combinations, model.combinations[1].replace(name="ch", limit_state="characteristic")),
        cracking=model.cracking and model.cracking.replace(limit_states=("quasi-permanent",)),
        mesh=model.mesh.replace(size=1.0),
    )
    found = solve(model)
    np.testing.assert_array_equal(found["ch"].plate.settlement, found["Ed"].plate.settlement)
    assert found["qp"].plate.settlement.max() > 1.01 * found["ch"].plate.settlement.max()
