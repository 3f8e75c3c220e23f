"""A first look at one combination on a mesh of few elements."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab import Model, solve
from groundslab.analysis.driver import PREVIEW_ELEMENTS, solve_preview
from groundslab.model.combinations import list_combinations


def model(**parts: Any) -> Model:
    """Return a raft under two load cases and their combinations."""
    given: dict[str, Any] = {
        "plate": {"length_x": 12.0, "length_y": 8.0, "thickness": 0.5, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "pasternak", "k0": 20e6, "k1": 10e6},
        "beyond": {"kind": "infinite"},
        "cases": [{"name": "G", "action": "permanent"}, {"name": "Q", "action": "variable"}],
        "loads": [
            {"kind": "uniform", "q": 5e3, "case": "G"},
            {"kind": "patch", "q": 5e4, "x": (-4.0, -2.0), "y": (-1.0, 1.0), "case": "Q"},
        ],
        "combine": {"sets": ["ultimate", "characteristic"]},
        "mesh": {"size": 0.25},
    }
    return Model.model_validate(given | parts)


def test_one_combination_near_its_results() -> None:
    """Its settlement is within 2 % of that on a mesh of 1,536 elements; it has about as many elements as meant."""
    raft = model()
    name = list_combinations(raft)[1].name
    found, truth = solve_preview(raft, name), solve(raft)[name]
    assert list(found.results) == [name]
    plate = found.only.plate
    assert plate.settlement.max() == pytest.approx(truth.plate.settlement.max(), rel=0.02)
    assert plate.settlement.max() != truth.plate.settlement.max()
    assert PREVIEW_ELEMENTS / 2 <= len(plate.elements) <= 2 * PREVIEW_ELEMENTS


def test_a_name_of_no_combination_means_the_first_one() -> None:
    """As before the first result is there."""
    raft = model()
    assert list(solve_preview(raft, "").results) == [list_combinations(raft)[0].name]


def test_further_plates_count() -> None:
    """The mesh of a large plate is not as fine as the first one, which is small, would have it."""
    large = {"kind": "rectangle", "x": (7.0, 47.0), "y": (-10.0, 10.0)}
    further = [{"name": "hall", "outline": large, "thickness": 0.5, "E": 30e9, "nu": 0.2}]
    found = solve_preview(model(plates=further, beyond={"kind": "none"}), "")
    assert len(found.only.plate.elements) <= 3 * PREVIEW_ELEMENTS


def test_a_limit_of_unknowns_is_of_meshes_that_are_refined() -> None:
    """It is left out, as the preview's mesh is given, which has no such limit."""
    limited, free = (solve_preview(model(mesh=mesh), "") for mesh in ({"max_unknowns": 100_000}, {}))
    assert limited.only.plate.settlement.max() == free.only.plate.settlement.max()


def test_no_equilibrium_is_no_error() -> None:
    """The combination is refused, and the run that follows says why."""
    lifted = model(loads=[{"kind": "uniform", "q": -5e3, "case": "G"}])
    assert len(solve_preview(lifted, "")) == 0
