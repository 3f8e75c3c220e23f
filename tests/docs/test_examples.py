"""The examples: each can be solved, and the sums that their comments work out by hand come out."""

from __future__ import annotations

import pytest

from groundslab.analysis.driver import solve
from groundslab.case.casefile import load
from groundslab.design.checks import check_design
from groundslab.design.codes.en1992_2023.checks.punching_demand import column_demands
from groundslab.views.tables.result_tables import tables_of
from helpers.paths import EXAMPLES, TAKE_LONG

#: The others are held to the same on large elements, where they are solved for their reports.
CASES = sorted({path.stem for path in EXAMPLES.glob("*.toml")} - TAKE_LONG)


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_examples_are_solved(name: str) -> None:
    """Every combination of an example as it is has a certified result, and its design does not fail."""
    results = solve(load(EXAMPLES / f"{name}.toml"))
    assert not results.refused
    assert all(each.certificate.holds for each in results.results.values())
    assert check_design(results).status != "fails"


def test_what_stands_on_the_bearing_walls_is_what_their_comment_says() -> None:
    """Both cases together, and the permanent one, sum up to the numbers worked out by hand; nothing is cut off."""
    model = load(EXAMPLES / "bearing_walls.toml")
    coarse = solve(model.replace(ground={"kind": "winkler", "k": 15e6}, reinforcement=None, mesh={"size": 1.0}))
    found = {name: results.certificate.load for name, results in coarse.results.items()}
    assert found["characteristic 1"] == pytest.approx(8683.4e3, rel=1e-12)
    assert found["ULS 4"] == pytest.approx(6923.2e3, rel=1e-12)
    comment = (EXAMPLES / "bearing_walls.toml").read_text(encoding="utf-8")
    assert "G = 6923.2 kN" in comment
    assert "G + Q = 8683.4 kN" in comment


def test_the_ribbed_raft_weighs_what_its_comment_says() -> None:
    """Slab, screed, ribs and columns, worked out by hand."""
    model = load(EXAMPLES / "ribbed_raft.toml")
    coarse = solve(model.replace(ground={"kind": "winkler", "k": 15e6}, reinforcement=None, mesh={"size": 1.0}))
    assert coarse["characteristic 2"].certificate.load == pytest.approx(3526.75e3, rel=1e-12)
    assert "= 3526.75 kN" in (EXAMPLES / "ribbed_raft.toml").read_text(encoding="utf-8")


def test_the_mat_in_customary_units_weighs_what_its_comment_says() -> None:
    """1.2 D + 1.6 L in kip, worked out by hand, is the sum of the loads that the table shows."""
    model = load(EXAMPLES / "us_mat.toml")
    coarse = solve(
        model.replace(reinforcement=None, combine={"expression": "ACI 318", "sets": ["ultimate"]}, mesh={"size": 1.0})
    )
    table = next(table for table in tables_of(coarse) if table.name == "combinations")
    (column,) = (column for column in table.columns if column.name == "sum of loads")
    assert column.unit == "kip"
    assert column.values[table["loads"].index("1.2 D + 1.6 L")] == pytest.approx(2913.76, rel=1e-12)
    assert "= 2913.8 kip" in (EXAMPLES / "us_mat.toml").read_text(encoding="utf-8")


def test_punching_by_the_second_generation_is_what_its_comment_says() -> None:
    """b_0.5 and k_pb of a column, worked out by hand."""
    model = load(EXAMPLES / "second_generation.toml")
    comment = (EXAMPLES / "second_generation.toml").read_text(encoding="utf-8")
    results = solve(model.replace(mesh={"size": 1.0}, combine=model.combine.replace(sets=("ultimate",))))
    demand = next(iter(column_demands(results).found.values()))
    assert f"is\n# 1.6 + pi x {demand.d:.3f} = {demand.b_05:.3f} m" in comment
    assert f"= {demand.k_pb:.3f}." in comment


@pytest.mark.slow
def test_the_raft_weighs_what_its_comment_says() -> None:
    """All eight combinations are solved, with the sums of loads that the comment works out by hand; the flood lifts."""
    model = load(EXAMPLES / "l_raft.toml")
    coarse = solve(model.replace(mesh=model.mesh.replace(size=1.0)))
    assert not coarse.refused
    permanent, live, flood = 5340e3 + 8628e3, 5442e3, -6624e3
    wanted = {
        "ULS live": 1.35 * permanent + 1.5 * live,
        "ULS live and wind": 1.35 * permanent + 1.5 * live,
        "ULS wind": 1.35 * permanent + 1.05 * live,
        "ULS wind on the empty building": permanent,
        "ULS flood": 0.9 * permanent + 1.1 * flood,
        "characteristic": permanent + live,
        "frequent": permanent + 0.5 * live,
        "quasi-permanent": permanent + 0.3 * live,
    }
    found = {name: results.certificate.load for name, results in coarse.results.items()}
    assert found == pytest.approx(wanted, rel=1e-12)
    comment = (EXAMPLES / "l_raft.toml").read_text(encoding="utf-8")
    for name, sum_of_loads in wanted.items():
        assert f"{sum_of_loads / 1e3:.1f}".removesuffix(".0") in comment, name
    assert coarse["ULS live"].plate.area.sum() == pytest.approx(414, rel=1e-12)
    lifted = {name for name, results in coarse.results.items() if not results.plate.in_contact.all()}
    assert lifted == {"ULS flood"}
