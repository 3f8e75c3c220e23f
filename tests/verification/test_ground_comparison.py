"""Grounds compared with the elastic continuum where the answer is known."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from groundslab import GroundComparison, Model, Pasternak, Winkler, compare_grounds, solve
from groundslab.analysis.ground_comparison.figures import gauss_points, rms_differences
from helpers.solve_once import solve_once

pytestmark = pytest.mark.slow

E_S, NU_S = 38.22e6, 0.3


def slab(**changes: Any) -> Model:
    """Return the plate of the paper's Table 3 on one layer of 10 m."""
    given: dict[str, Any] = {
        "plate": {"length_x": 5, "length_y": 5, "thickness": 0.25, "E": 21e9, "nu": 0.167},
        "ground": {"kind": "continuum", "layers": [{"E": E_S, "nu": NU_S, "thickness": 10.0}]},
        "loads": [{"kind": "uniform", "q": 1e5}],
        "mesh": {"counts": (16, 16)},
    }
    return Model(**given | changes)


@cache
def table3() -> GroundComparison:
    """Return the comparison of the thin plate of Table 3."""
    return compare_grounds(slab())


def springs(name: str, comparison: GroundComparison) -> Winkler | Pasternak:
    """Return the springs that were fitted."""
    found = comparison[name].ground
    assert isinstance(found, Winkler | Pasternak)
    return found


class TestTable3:
    """The thin plate of the paper's Table 3, 5 x 5 m under 0.1 MPa."""

    def test_continuum(self) -> None:
        """Settlements of center and corner are those of a dense program of its own with as many elements and cells.

        It gave 9.787 and 5.930 mm. At the corner pressures have no limit, and cells are joined to elements otherwise.
        """
        figures = table3()["continuum"].figures
        assert 1e3 * figures["largest_settlement"] == pytest.approx(9.787, abs=5e-4)
        assert 1e3 * figures["smallest_settlement"] == pytest.approx(5.930, rel=2e-3)
        assert table3().place == (0, 0)

    def test_vlasov_is_that_of_the_layers(self) -> None:
        """It is the analysis of the same case with that ground, going on beyond the plate."""
        layers = [{"E": E_S, "nu": NU_S, "thickness": 10.0}]
        alone = solve(slab(ground={"kind": "vlasov", "layers": layers}, beyond={"kind": "infinite"}))
        figures = table3()["vlasov"].figures
        assert figures["largest_settlement"] == pytest.approx(alone.plate.settlement.max(), rel=1e-8)
        assert table3()["vlasov"].constants["gamma"] == pytest.approx(alone.constants.gamma, rel=1e-8)

    def test_springs_settle_by_the_mean(self) -> None:
        """Springs settle evenly under an even load: the best k is the load over the continuum's mean settlement."""
        mean = table3()["continuum"].figures["mean_settlement"]
        k = springs("winkler", table3())
        assert isinstance(k, Winkler)
        assert k.k == pytest.approx(1e5 / mean, rel=1e-5)

    def test_pasternak_is_nearer_than_springs(self) -> None:
        """Springs are Pasternak's ground without shear, which can only be as near as the best of all."""
        assert table3()["pasternak"].rms["settlement"] < table3()["winkler"].rms["settlement"]

    @pytest.mark.parametrize("factors", [(1.03, 1), (0.97, 1), (1, 1.03), (1, 0.97)])
    def test_no_neighboring_constants_are_better(self, factors: tuple[float, float]) -> None:
        """With either constant of Pasternak's ground changed by 3 % settlements are farther from the continuum's."""
        best = springs("pasternak", table3())
        assert isinstance(best, Pasternak)
        ground = Pasternak(k0=factors[0] * best.k0, k1=factors[1] * best.k1)
        changed = solve(slab(ground=ground, beyond={"kind": "infinite"})).plate
        continuum = solve_once(slab()).plate
        further = rms_differences(changed, continuum, gauss_points(continuum))["settlement"]
        assert further > table3()["pasternak"].rms["settlement"]


def test_a_rigid_slab() -> None:
    """It settles evenly on any ground: k is load over area and settlement, and nothing remains but its bending."""
    rigid = {"length_x": 5, "length_y": 4, "thickness": 1.0, "E": 1e13, "nu": 0.2}
    found = compare_grounds(slab(plate=rigid, mesh={"size": 0.5}))
    w = found["continuum"].figures["mean_settlement"]
    bending = found["continuum"].figures["differential_settlement"] / w
    assert bending < 1e-4
    k = springs("winkler", found)
    assert isinstance(k, Winkler)
    assert k.k == pytest.approx(1e5 / w, rel=1e-6)
    for name in ("winkler", "pasternak"):
        assert found[name].rms["settlement"] < 2 * bending
    assert found["vlasov"].rms["settlement"] > 0.1
    # a plate that stays flat feels the sum of all that Pasternak's ground pushes, and not by which constant
    assert any("Pasternak: others fit nearly as well" in note for note in found.notes)
    assert not any("others fit nearly as well" in note for note in table3().notes)


def test_a_thin_layer_is_springs() -> None:
    """Confined between plate and base, a layer is springs with k = Ec / h, but for the square of h over a wave length.

    The plate bends over its radius of relative stiffness l = (D / k)^(1/4).
    """
    h, E, nu = 0.1, 1e7, 0.3
    Ec = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu))
    plate = {"length_x": 10, "length_y": 10, "thickness": 0.3, "E": 31e9, "nu": 0.2}
    D = 31e9 * 0.3**3 / (12 * (1 - 0.2**2))
    l_squared = (D * h / Ec) ** 0.5
    found = compare_grounds(
        slab(
            plate=plate,
            ground={"kind": "continuum", "layers": [{"E": E, "nu": nu, "thickness": h}]},
            contact={"tensionless": False},
            loads=[{"kind": "patch", "q": 1e5, "x": (-1, 1), "y": (-1, 1)}],
            mesh={"size": 1.0},
        )
    )
    k = springs("winkler", found)
    assert isinstance(k, Winkler)
    assert k.k == pytest.approx(Ec / h, rel=h**2 / l_squared)
    assert found["winkler"].rms["settlement"] < h**2 / l_squared


def test_the_combination_with_the_largest_settlement_is_compared() -> None:
    """Unless another one is named; both carry their loads on all grounds."""
    cases = [{"name": "G"}, {"name": "Q", "action": "variable"}]
    loads = [{"kind": "uniform", "q": 2e4, "case": "G"}, {"kind": "uniform", "q": 6e4, "case": "Q"}]
    model = slab(cases=cases, loads=loads, mesh={"counts": (4, 4)})
    largest, named = compare_grounds(model), compare_grounds(model, "G")
    assert (largest.combination, named.combination) == ("Q", "G")
    for each, other in zip(largest.grounds, named.grounds, strict=True):
        # all of this is linear, as nothing lifts
        np.testing.assert_allclose(each.figures["mean_settlement"], 3 * other.figures["mean_settlement"], rtol=1e-5)


def test_constants_under_loads_that_last_are_those_of_the_description() -> None:
    """Where all ground is 0.4 times as stiff, springs and Vlasov's constants are told as the case describes soil.

    The combination is one of a design, whose other combinations and checks do not take part.
    """
    states = {"ultimate": 1.35, "quasi-permanent": 1.0}
    combinations = [{"name": s[0], "limit_state": s, "factors": {"G": factor}} for s, factor in states.items()]
    lasting = slab(
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "q": 1e5, "case": "G"}],
        combinations=combinations,
        long_term={"stiffness": 0.4},
        mesh={"counts": (4, 4)},
        reinforcement={"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)},
    )
    found = compare_grounds(lasting)
    assert found.combination == "q"
    k = springs("winkler", found)
    assert isinstance(k, Winkler)
    assert 0.4 * k.k == pytest.approx(1e5 / found["continuum"].figures["mean_settlement"], rel=1e-5)
    vlasov = found["vlasov"]
    alone = solve(lasting.replace(ground=vlasov.ground, beyond={"kind": "infinite"}))["q"].constants
    assert 0.4 * vlasov.constants["k0"] == pytest.approx(alone.k0[0], rel=1e-8)
    assert any("0.4 times as stiff" in note for note in found.notes)


def test_combinations_without_a_result_are_named() -> None:
    """One that the ground cannot balance is left aside, and a note says so."""
    cases = [{"name": "down"}, {"name": "up"}]
    loads = [{"kind": "uniform", "q": 2e4, "case": "down"}, {"kind": "uniform", "q": -2e4, "case": "up"}]
    found = compare_grounds(slab(cases=cases, loads=loads, mesh={"counts": (4, 4)}))
    assert found.combination == "down"
    assert any('no equilibrium on the continuum in "up"' in note for note in found.notes)
    assert found.without_equilibrium == ("up",)
