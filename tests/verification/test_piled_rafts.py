"""Piles under a plate on ground of elastic layers."""

from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab import CombinationResult
from groundslab.fem.continuum.piles import Pile, base_interaction, shaft_interaction

E_SOIL, NU = 26e6, 0.3
PLACES = [(x, y) for x in (-1.5, 1.5) for y in (-1.5, 1.5)]


def solve_on_piles(load: float, gap: float = 0.0, E: float = 30e9, **limits: float) -> CombinationResult:
    """Return the results of a square raft on four piles in one deep layer."""
    piles = [
        {"kind": "pile", "name": f"P{n}", "x": x, "y": y, "length": 10.0, "diameter": 0.5, **limits}
        for n, (x, y) in enumerate(PLACES, start=1)
    ]
    case: dict[str, Any] = {
        "plate": {"length_x": 5.0, "length_y": 5.0, "thickness": 1.0, "E": E, "nu": 0.2},
        "ground": {"kind": "continuum", "half_space": {"E": E_SOIL, "nu": NU}},
        "contact": {"gap": gap},
        "supports": piles,
        "loads": [{"kind": "uniform", "q": load / 25.0}],
        "mesh": {"size": 0.5},
    }
    return groundslab.solve(groundslab.Model.model_validate(case)).only


def test_a_group_clear_of_the_ground_settles_by_its_factors() -> None:
    """Each of four piles carries a quarter: w = P / 4 (1 + 2 alpha(3 m) + alpha(4.24 m)) / K."""
    pile = Pile(10.0, 0.25, 30e9, E_SOIL / (2 * (1 + NU)), NU)

    def alpha(s: float) -> float:
        base = pile.base_share
        return float((1 - base) * shaft_interaction(pile, s) + base * base_interaction(pile, s))

    found = solve_on_piles(1e6, gap=1.0, E=3e13)
    expected = 0.25e6 / pile.head_stiffness * (1 + 2 * alpha(3.0) + alpha(3.0 * np.sqrt(2)))
    assert found.certificate.holds
    assert found.plate.settlement == pytest.approx(np.full(len(found.plate.settlement), expected), rel=1e-4)
    assert [each.total for each in found.supports] == pytest.approx([0.25e6] * 4, rel=1e-9)


def test_raft_and_piles_share_the_load() -> None:
    """Together they settle less than either alone, and carry all of it."""
    together, piles = solve_on_piles(1e6), solve_on_piles(1e6, gap=1.0)
    on_piles = sum(each.total for each in together.supports)
    assert 0.3e6 < on_piles < 0.95e6
    assert on_piles + together.plate.contact_force.sum() == pytest.approx(1e6, rel=1e-6)
    assert together.plate.settlement.max() < piles.plate.settlement.max()


def test_piles_yield_at_their_limit() -> None:
    """What they do not carry the raft does."""
    found = solve_on_piles(2e6, limit=100e3)
    assert [each.total for each in found.supports] == pytest.approx([100e3] * 4, rel=1e-9)
    assert found.plate.contact_force.sum() == pytest.approx(1.6e6, rel=1e-6)
    assert found.certificate.holds


def test_piles_hold_a_raft_down() -> None:
    """Under uplift all of the load is in them, unless they only push."""
    found = solve_on_piles(-0.4e6)
    assert [each.total for each in found.supports] == pytest.approx([-0.1e6] * 4, rel=1e-6)
    assert found.plate.contact_share == 0.0


@pytest.mark.parametrize(
    ("pile", "ground", "where", "found"),
    [
        ({}, {"kind": "winkler", "k": 20e6}, "supports[1].kind", '"pile" in "winkler" ground'),
        ({"length": 1.0}, None, "supports[1].length", "1 m"),
        (
            {"length": 12.0},
            {"kind": "continuum", "layers": [{"E": E_SOIL, "nu": NU, "thickness": 11.0}]},
            "supports[1].length",
            "12 m, with layers of 11 m",
        ),
    ],
)
def test_piles_that_cannot_be(pile: dict[str, Any], ground: dict[str, Any] | None, where: str, found: str) -> None:
    """Springs give no stiffness, a short pile is a footing, one on the rigid base a support."""
    case = {
        "plate": {"length_x": 5.0, "length_y": 5.0, "thickness": 1.0, "E": 30e9, "nu": 0.2},
        "ground": ground or {"kind": "continuum", "half_space": {"E": E_SOIL, "nu": NU}},
        "supports": [{"kind": "pile", "x": 0.0, "y": 0.0, "length": 10.0, "diameter": 0.5} | pile],
        "loads": [{"kind": "uniform", "q": 1e4}],
    }
    with pytest.raises(groundslab.InputError) as caught:
        groundslab.Model.model_validate(case)
    (issue,) = caught.value.issues
    assert (issue.location, issue.found) == (where, found)
