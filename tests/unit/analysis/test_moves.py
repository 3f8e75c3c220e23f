"""Moving loads: each position has the results that it has by itself, and the envelope is that of all of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.case.casefile import to_toml
from groundslab.cli.main import main
from groundslab.model.combinations import place_patterns
from groundslab.model.model import Model
from groundslab.views.files.results_folder import load_results, save_results
from groundslab.views.scene.fields import scene_of
from groundslab.views.tables.result_tables import tables_of

pytestmark = pytest.mark.slow

WHEELS = [{"P": 40e3, "y": side, "width_x": 0.2, "width_y": 0.2} for side in (-0.5, 0.5)]
BASE: dict[str, Any] = {
    "plate": {"length_x": 6, "length_y": 4, "thickness": 0.16, "E": 30e9, "nu": 0.2},
    "ground": {"kind": "winkler", "k": 40e6},
    "cases": [{"name": "G"}, {"name": "truck", "action": "variable"}],
    "mesh": {"counts": (12, 8)},
    "combinations": [{"name": "ULS", "factors": {"G": 1.35, "truck": 1.5}}],
}
LOADS = [
    {"kind": "self weight", "unit_weight": 25e3, "case": "G"},
    {"kind": "temperature", "difference": 8.0, "case": "G"},
    {"kind": "patch", "q": 6e3, "x": (-3.0, -1.5), "y": (-2.0, 2.5), "case": "truck"},
]
PLACES = (-2.9, -1.4, 0.1, 1.6)


def moving(tensionless: bool) -> Model:
    """Return a slab that curls with an axle that moves along it in four positions."""
    return Model(
        **BASE,
        loads=LOADS,
        contact={"tensionless": tensionless},
        patterns=[{"kind": "vehicle", "name": "axle", "wheels": WHEELS}],
        moves=[{"pattern": "axle", "case": "truck", "points": [(PLACES[0], 0.3), (PLACES[-1], 0.3)], "step": 1.5}],
    )


def fixed(x: float, tensionless: bool) -> Model:
    """Return the same slab with the axle as two point loads at a place."""
    wheels = [{"kind": "point", "case": "truck", "P": 40e3, "x": x, "y": 0.3 + side, "width_x": 0.2, "width_y": 0.2}
              for side in (-0.5, 0.5)]  # fmt: skip
    return Model(**BASE, loads=LOADS + wheels, contact={"tensionless": tensionless})


@pytest.mark.parametrize("tensionless", [True, False])
def test_the_envelope_is_that_of_separate_analyses(tensionless: bool) -> None:
    """Brute force: four slabs with the axle at fixed places, each by itself, with contact and without."""
    found = solve(moving(tensionless))
    apart = {x: solve(fixed(x, tensionless)) for x in PLACES}
    assert [each.name for each in found.combinations] == [f"ULS, truck at {x - PLACES[0]:.2f} m" for x in PLACES]
    for (name, one), other in zip(found.items(), apart.values(), strict=True):
        assert one.certificate.holds, name
        for field in ("settlement", "moment_x", "moment_y", "pressure"):
            ours, wanted = getattr(one.plate, field), getattr(other.plate, field)
            np.testing.assert_allclose(ours, wanted, rtol=0, atol=1e-7 * np.abs(wanted).max())
    moments = {x: each.plate.moment_x.max() / 1e3 for x, each in apart.items()}
    worst = max(moments, key=moments.__getitem__)
    envelope = next(table for table in tables_of(found) if table.name == "envelope")
    row = envelope["quantity"].index("moment m_x")
    assert envelope["greatest"][row] == pytest.approx(moments[worst], rel=1e-7)
    assert envelope["combination of the greatest"][row] == f"ULS, truck at {worst - PLACES[0]:.2f} m"


def test_results_of_moving_loads_come_back_from_their_folder(tmp_path: Path) -> None:
    """`model` is the case with its path and `solved_model` the one with the axle at each position, in every result."""
    model = moving(tensionless=True)
    solved = solve(model)
    loaded = load_results(save_results(solved, tmp_path / "found", plot=False))
    assert len(loaded) == len(PLACES)
    for results in (solved, *solved.values(), loaded, *loaded.values()):
        assert results.model == model
        assert results.solved_model == place_patterns(model)
    assert (len(loaded.model.cases), len(loaded.solved_model.cases)) == (2, 2 + len(PLACES))
    assert (len(loaded.model.loads), len(loaded.solved_model.loads)) == (3, 3 + 2 * len(PLACES))


def test_a_fixed_pattern_is_the_loads_that_it_stands_for(tmp_path: Path) -> None:
    """A vehicle at one place is two point loads; its folder gives back the case with the pattern."""
    given = moving(tensionless=True)
    model = given.replace(moves=[{"pattern": "axle", "case": "truck", "points": [(0.1, 0.3)]}])
    found, wanted = solve(model), solve(fixed(0.1, tensionless=True))
    np.testing.assert_allclose(found.plate.settlement, wanted.plate.settlement, rtol=0, atol=1e-12)
    assert load_results(save_results(found, tmp_path / "found", plot=False)).model == model


def test_shrinkage_bends_as_a_colder_top() -> None:
    """A top that shortens by more acts as one that is colder by the difference over 1e-5 1/K: the corners lift."""
    shrunk = [LOADS[0], {"kind": "shrinkage", "top": 2.5e-4, "bottom": 1.7e-4, "case": "G"}]
    cases = {"cases": [{"name": "G"}], "combinations": [{"name": "SLS", "factors": {"G": 1.0}}]}
    found = solve(Model(**BASE | cases, loads=shrunk))
    wanted = solve(Model(**BASE | cases, loads=LOADS[:2]))
    np.testing.assert_allclose(found.plate.moment_x, wanted.plate.moment_x, rtol=0, atol=1e-3)
    assert found.plate.value_at("settlement", 3.0, 2.0) < -1e-5 < found.plate.value_at("settlement", 0.0, 0.0)


def test_a_viewer_shows_the_load_where_each_combination_has_it() -> None:
    """The plan of results has the wheels of each position in a case of its own, which the combination names."""
    found = solve(moving(tensionless=True))
    head = scene_of(found).head
    wheels = {(each["case"], *each["points"][0]) for each in head["plan"]["loads"] if each["kind"] == "point"}
    assert wheels == {
        (f"truck at {x - PLACES[0]:.2f} m", round(x, 9), 0.3 + side) for x in PLACES for side in (-0.5, 0.5)
    }
    assert [name for name, factor in found.combinations[1].factors if factor == 1.5] == ["truck", "truck at 1.50 m"]


def test_check_says_what_is_solved_and_what_stands_beside_the_plate(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Each position is listed, and that of the axle, turned across, one wheel is off at 4.0 and 4.3 m."""
    given = moving(tensionless=True)
    move = {"pattern": "axle", "case": "truck", "points": [(0, 0), (2.4, 0), (2.4, 1.9)], "step": 2.0, "turn": 90}
    path = tmp_path / "case.toml"
    path.write_text(to_toml(given.replace(moves=[move])))
    assert main(["check", str(path)]) == 0
    told = capsys.readouterr().out
    assert "combination ULS, truck at 2.00 m (ultimate): 1.35 G + 1.5 truck + 1.5 truck at 2.00 m" in told
    assert "remark: moves[1]: up to 1 of 2 forces are off the plate at 2 of 4 positions" in told
