"""A refinement that goes on from provisional results, and ends where it would have ended without a break."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from groundslab import InputError, Mesh, Model, load_results, save_results, solve
from groundslab.accuracy.judgment import JudgedValue
from groundslab.analysis import adaptivity
from groundslab.arrays import Array
from groundslab.fem.shape_functions import areas
from groundslab.model.loads.load_cases import Combination
from groundslab.results.results import CombinationResult, Results

PLATE = {"thickness": 0.15, "E": 30e9, "nu": 0.2}
WHEEL = {"kind": "point", "P": 400e3, "width_x": 0.3, "width_y": 0.3}


def slab(accuracy: float, **parts: Any) -> Model:
    """Return a floor of 8 x 6 m under a wheel, which lifts off around it."""
    parts = {"plate": PLATE | {"length_x": 8.0, "length_y": 6.0}, "loads": [WHEEL | {"x": 0.9, "y": 0.4}]} | parts
    return Model.model_validate({"ground": {"kind": "winkler", "k": 20e6}, "mesh": {"accuracy": accuracy}, **parts})


def far_away() -> Model:
    """Return an L of a floor in a national grid, under a wheel here or there."""
    x, y = 3_567_890.0, 5_432_100.0
    corners = [(0, 0), (8, 0), (8, 3), (4, 3), (4, 6), (0, 6)]
    outline = {"kind": "polygon", "points": [(x + a, y + b) for a, b in corners]}
    places = {"here": (2.9, 3.4), "there": (5.1, 1.2)}
    loads = [WHEEL | {"x": x + a, "y": y + b, "case": name} for name, (a, b) in places.items()]
    return slab(0.04, plate=PLATE | {"outline": outline}, loads=loads, cases=[{"name": name} for name in places])


def solve_in_steps(model: Model, folder: Path) -> tuple[Results, list[Results]]:
    """Return results, and those on the meshes before, read back from folders."""
    before: list[Results] = []

    def keep(results: Results) -> None:
        before.append(load_results(save_results(results, folder / str(len(before)))))

    return solve(model, on_mesh=keep), before


def meshes_of(results: Results) -> tuple[int, ...]:
    """Return the unknowns of the meshes that were made for results."""
    history = next(iter(results.values())).mesh_history
    assert history is not None
    return history.unknowns


@pytest.mark.slow
@pytest.mark.parametrize(("model", "least"), [(slab(0.002), 3), (far_away(), 1)], ids=["four meshes", "far away"])
def test_the_same_end_from_any_mesh(model: Model, least: int, tmp_path: Path) -> None:
    """From results on the first or third mesh as a folder has them come the same results; no mesh is solved twice."""
    whole, before = solve_in_steps(model, tmp_path)
    assert len(before) >= least
    for start in before[::2]:
        begun: list[Combination] = []
        resumed = solve(model, on_combination=begun.append, start=start)
        assert list(resumed) == list(whole)
        for name, found in resumed.items():
            expected = whole[name]
            assert found.mesh_history is not None
            assert expected.mesh_history is not None
            made = expected.mesh_history.unknowns
            assert (found.mesh_history.unknowns, found.mesh_history.end) == (made, expected.mesh_history.end)
            assert len(begun) == len(resumed) * (len(made) - len(meshes_of(start)))
            np.testing.assert_array_equal(found.plate.elements, expected.plate.elements)
            # a coordinate in a national grid has a nanometer
            np.testing.assert_allclose(found.plate.nodes, expected.plate.nodes, rtol=0.0, atol=2e-9)
            for field in ("settlement", "moment_x", "shear_y", "pressure"):
                own, other = getattr(found.plate, field), getattr(expected.plate, field)
                np.testing.assert_allclose(own, other, rtol=0.0, atol=1e-8 * np.abs(other).max())


@pytest.mark.slow
def test_errors_that_fell_no_more_stay_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """What did not fall from the second mesh to the third does not make elements smaller after a break either."""
    shares = {1: (0.5, 0.5), 2: (0.3, 0.5), 3: (0.1, 0.5), 4: (0.005, 0.5)}
    number = iter([1, 2, 3, 4, 3, 4])
    demanded: list[list[str]] = []

    def judged(_: CombinationResult) -> list[JudgedValue]:
        falls, stays = shares[next(number)]
        return [JudgedValue(stays, 1.0, "stays", None), JudgedValue(falls, 1.0, "falls", None)]

    def demand(results: CombinationResult, judged: list[JudgedValue], _: float) -> Array:
        demanded.append([each.label for each in judged])
        sizes: Array = 0.9 * np.sqrt(areas(results.plate.nodes[results.plate.elements]))
        return sizes

    monkeypatch.setattr(adaptivity, "judge", judged)
    monkeypatch.setattr(adaptivity, "_demand", demand)
    before: list[Results] = []
    whole = solve(slab(0.01), on_mesh=before.append)
    assert demanded == [["stays", "falls"], ["stays", "falls"], ["falls"]]
    resumed = solve(slab(0.01), start=before[-1])
    assert demanded[3:] == [["falls"]]
    assert resumed.only.mesh_history == whole.only.mesh_history
    assert whole.only.mesh_history is not None
    assert whole.only.mesh_history.end == "no progress"
    assert whole.only.mesh_history.before == (("falls", 0.1), ("stays", 0.5))


@pytest.mark.slow
def test_results_of_another_case_or_without_a_next_mesh_are_refused(tmp_path: Path) -> None:
    """Another load makes another case; final results have nothing that goes on."""
    model = slab(0.01)
    whole, (first, *_) = solve_in_steps(model, tmp_path)
    with pytest.raises(InputError, match="start: found results of another case, expected provisional results"):
        solve(model.replace(title="another"), start=first)
    with pytest.raises(InputError, match="start: found results of another case"):
        solve(model.replace(mesh=Mesh(accuracy=0.02)), start=first)
    with pytest.raises(InputError, match="start: found results that are not provisional"):
        solve(model, start=whole)
    nothing = replace(first, results={}, refused={})
    with pytest.raises(InputError, match="start: found results that are not provisional"):
        solve(model, start=nothing)
