"""Constants of springs are found again from the settlements that they give."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import solve
from groundslab.analysis.driver import Variants
from groundslab.analysis.ground_comparison.figures import gauss_points, sample
from groundslab.analysis.ground_comparison.fit import fit
from groundslab.model.ground import Pasternak, Winkler
from groundslab.model.model import Model

pytestmark = pytest.mark.slow


def model(ground: dict[str, Any], **changes: Any) -> Model:
    """Return a slab that lifts off at one end."""
    given: dict[str, Any] = {
        "plate": {"length_x": 6, "length_y": 4, "thickness": 0.2, "E": 30e9, "nu": 0.2},
        "ground": ground,
        "beyond": {"kind": "infinite"},
        "loads": [
            {"kind": "uniform", "q": 5e2},
            {"kind": "point", "P": 2e5, "x": -2.5, "y": 0, "width_x": 0.5, "width_y": 0.5},
        ],
        "mesh": {"size": 0.5},
    }
    return Model(**given | changes)


def test_pasternak() -> None:
    """From a start that is off by factors of 2 and 3 both constants come out, on a slab that partly lifts."""
    solved = solve(model({"kind": "pasternak", "k0": 1e7, "k1": 8e6})).only
    assert solved.plate.contact_share < 0.95
    points = gauss_points(solved.plate)
    found, determined = fit(
        "pasternak", solved.model, (2e7, 2.4e7), points, sample(solved.plate, "settlement", points.places)
    )
    assert isinstance(found, Pasternak)
    assert determined
    # the search ends when a step changes the constants by 1e-6; its mesh differs from that of the settlements
    assert found.k0 == pytest.approx(1e7, rel=1e-3)
    assert found.k1 == pytest.approx(8e6, rel=1e-3)


@pytest.mark.parametrize("mesh", [{"size": 0.5}, {"accuracy": 0.2}], ids=["given", "adaptive"])
def test_winkler(mesh: dict[str, Any]) -> None:
    """The modulus of subgrade reaction comes out, where the mesh is adaptive on a coarser one."""
    solved = solve(model({"kind": "winkler", "k": 3e7}, mesh=mesh)).only
    points = gauss_points(solved.plate)
    found, determined = fit(
        "winkler", solved.model, (1e7, 1e7), points, sample(solved.plate, "settlement", points.places)
    )
    assert isinstance(found, Winkler)
    assert determined
    assert found.k == pytest.approx(3e7, rel=1e-6 if "size" in mesh else 2e-3)


def test_trials_have_the_settlements_of_whole_results() -> None:
    """Down to the last digit, on a slab that lies away from the origin: only what a fit does not need is left out."""
    corners = [(0.7, -3.2), (6.7, -3.2), (6.7, 0.8), (0.7, 0.8)]
    plate = {"outline": {"kind": "polygon", "points": corners}, "thickness": 0.2, "E": 30e9, "nu": 0.2}
    loads = [{"kind": "uniform", "q": 5e2}, {"kind": "point", "P": 2e5, "x": 1.2, "y": -1.2}]
    ground = {"kind": "pasternak", "k0": 1e7, "k1": 8e6}
    variants = Variants(model(ground, plate=plate, loads=loads, mesh={"size": 0.5, "symmetry": "off"}))
    factors = {"ground.k0": lambda x, _: np.full(len(x), 1.3)}
    mesh, settlement = variants.solve_settlement(variants.base.model, factors)
    whole = variants.solve_combinations(variants.base.model, factors).only.plate
    np.testing.assert_array_equal(mesh.nodes, whole.nodes)
    np.testing.assert_array_equal(mesh.elements, whole.elements)
    np.testing.assert_array_equal(settlement, whole.settlement)
