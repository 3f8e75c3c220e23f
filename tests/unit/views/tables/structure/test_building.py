"""Tables of the building above, its loads in the design, and results that are kept and read back."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.case.casefile import to_toml
from groundslab.cli.main import main
from groundslab.design.demands.loads.column_loads import sum_of_others
from groundslab.design.demands.loads.wall_loads import loads_on_wall
from groundslab.design.demands.perimeters import outline
from groundslab.views.files import archive, results_folder
from groundslab.views.report.html import render_report
from groundslab.views.tables.structure.building import storeys_that_matter

PLACES = {"A": (-5.0, 2.5), "B": (5.0, 2.5), "C": (5.0, -2.5), "D": (-5.0, -2.5)}


def model(**changes: Any) -> gs.Model:
    """Return a raft under four columns and a wall, two cases and two combinations, and a building of two storeys."""
    parts: dict[str, Any] = {
        "plate": {"outline": {"kind": "rectangle", "x": [100.0, 112.0], "y": [50.0, 58.0]}, "thickness": 0.4, "E": 30e9,
                  "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "columns": [{"name": name, "x": x + 106, "y": y + 54, "width_x": 0.4, "width_y": 0.4}
                    for name, (x, y) in PLACES.items()],
        "walls": [{"name": "W", "thickness": 0.3, "points": [(104.0, 54.0), (108.0, 54.0)]}],
        "building": {
            "storeys": [4.0, 3.0],
            "E": 30e9,
            "beams": [{"through": line, "section": {"kind": "rectangle", "width": 0.3, "height": 0.6}}
                      for line in (["A", "B", "C", "D", "A"], ["A", "W", "C"])],
        },
        "cases": [{"name": "G"}, {"name": "Q", "action": "variable"}],
        "loads": [
            *({"kind": "point", "column": name, "P": 300e3, "case": "G"} for name in PLACES),
            {"kind": "point", "column": "B", "P": 200e3, "case": "Q"},
            {"kind": "line", "wall": "W", "q": 250e3, "case": "G"},
        ],
        "combinations": [
            {"name": "SLS", "limit_state": "characteristic", "factors": {"G": 1.0, "Q": 1.0}},
            {"name": "ULS", "factors": {"G": 1.35, "Q": 1.5}},
        ],
        "reinforcement": {"concrete": "C30/37", "steel": "B500B", "bottom": [0.05, 0.06], "top": [0.05, 0.06]},
        "mesh": {"size": 0.5},
    }  # fmt: skip
    return gs.Model(**parts | changes)


@pytest.fixture(scope="module")
def results() -> gs.Results:
    """Results of the raft."""
    return gs.solve(model())


def tables(results: gs.Results) -> dict[str, dict[str, tuple[Any, ...]]]:
    """Return tables by name, and columns by theirs."""
    return {table.name: {column.name: column.values for column in table.columns} for table in gs.tables_of(results)}


def test_loads_and_changes(results: gs.Results) -> None:
    """Loads on a rigid base are those of the case; changes balance each other, and settle what settles less."""
    found = tables(results)
    building, columns, walls = found["building"], found["columns"], found["walls"]
    assert building["base"] == ("A", "B", "C", "D", "W") * 2
    assert building["load on a rigid base"] == pytest.approx((300, 500, 300, 300, 1000, 405, 705, 405, 405, 1350))
    for rows in (slice(0, 5), slice(5, 10)):
        change, given, load = (
            np.array(building[name][rows]) for name in ("change of load", "load on a rigid base", "load")
        )
        assert load == pytest.approx(given + change)
        assert change.sum() == pytest.approx(0.0, abs=1e-6 * given.sum())
        # what settles most is relieved most
        assert np.argmin(change) == np.argmax(building["settlement"][rows])
        assert change.min() < -5.0
    assert columns["load"] == pytest.approx(np.delete(building["load"], [4, 9]))
    assert walls["load"] == pytest.approx(np.take(building["load"], [4, 9]))
    assert "error of load" in building


def test_storeys(results: gs.Results) -> None:
    """Changes by all storeys are those of the table of the building."""
    found = tables(results)
    assert found["storeys"]["change by 2 storeys"] == pytest.approx(found["building"]["change of load"])
    assert set(found["storeys"]["storeys that matter"]) <= {1, 2}


def test_storeys_that_matter() -> None:
    """Until all changes are within 5 % of the largest one."""
    assert storeys_that_matter(np.array([[80.0, 96.0, 100.0], [-10.0, -10.0, -10.0]])) == 2
    assert storeys_that_matter(np.array([[80.0, 94.0, 100.0]])) == 3
    assert storeys_that_matter(np.array([[100.0, 94.0, 100.0]])) == 3
    assert storeys_that_matter(np.array([[100.0, 101.0]])) == 1
    assert storeys_that_matter(np.zeros((2, 3))) == 1


def test_all_loads_on_the_slab_stay_what_they_are(results: gs.Results) -> None:
    """What the building adds is in equilibrium, in every combination by itself."""
    for one in results.values():
        others = sum_of_others(one, outline(one.plate), ())
        factors = {f"\0{part} of {base.name}": float(getattr(base, part)[0])
                   for base in one.bases for part in ("force", "moment_x", "moment_y")}  # fmt: skip
        added = sum(factors[case] * force for case, force in others.items() if case in factors)
        assert added == pytest.approx(0.0, abs=1e-6 * one.certificate.load)


def test_moments_at_the_foot_of_a_wall_are_loads_along_it(results: gs.Results) -> None:
    """A couple along the wall is a load that grows from end to end, one across it a couple per length."""
    one = results["ULS"]
    base = one.bases[4]
    (wall,) = one.model.placed_walls
    (force,), (couple,) = loads_on_wall(one.model, wall).in_combination(one)
    L = wall.length
    assert force.mean() * L == pytest.approx(1350e3 + base.force[0])
    assert (force[1] - force[0]) / 2 * L**2 / 6 == pytest.approx(base.moment_x[0])
    assert couple * L == pytest.approx([base.moment_y[0]] * 2)


def test_results_are_kept(results: gs.Results, tmp_path: Path) -> None:
    """An archive has the bases, at their places in the plan that was given, and of the coarser mesh, too."""
    (tmp_path / "raft.zip").write_bytes(archive.pack_results(results, to_toml(results.model), "<p>report</p>"))
    archive.unpack_results(tmp_path / "raft.zip", tmp_path / "raft")
    read = results_folder.load_results(tmp_path / "raft")
    for name, one in results.results.items():
        for before, after in zip(one.bases, read[name].bases, strict=True):
            assert after.name == before.name
            assert after.nodes == pytest.approx(before.nodes)
            np.testing.assert_array_equal(after.by_storeys, before.by_storeys)
        comparison = read[name].comparison
        assert comparison is not None
        assert len(comparison.bases) == 5
    assert results["SLS"].bases[0].nodes == pytest.approx(np.array([[101.0, 56.5]]))


def test_report_and_commands_say_it(results: gs.Results, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The report lists the building, its table and what is assumed; a matrix, too; `check` names it."""
    text = render_report(results)
    assert "Building above" in text
    assert "on a base that does not move" in text
    case = tmp_path / "case.toml"
    case.write_text(to_toml(results.model), encoding="utf-8")
    assert main(["check", str(case)]) == 0
    assert "building: 2 storeys, 7 m high, on 5 columns and walls" in capsys.readouterr().out
    assert gs.load(case) == results.model


def test_a_matrix_is_reported() -> None:
    """A report with a matrix says so, and what it changes."""
    K = 50e3 * np.outer([1.0, -1.0, 1.0, -1.0], [1.0, -1.0, 1.0, -1.0])
    building = {"nodes": [*PLACES], "matrix": K.tolist(), "unit": "kN"}
    results = gs.solve(model(building=building))
    assert "storeys" not in tables(results)
    assert "50000" in render_report(results).replace(",", "")
    # settlements alone: couples of the building are none
    assert set(tables(results)["building"]["change of M_x"]) == {0.0}
