"""Supports, loads and limits of contact against statics and closed solutions, none of them from our own output."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import fsolve

from groundslab.analysis.driver import solve, solve_combinations
from groundslab.errors import NoEquilibrium
from groundslab.model.loads.load_cases import Combination
from groundslab.model.model import Model
from groundslab.results.records import Step
from groundslab.results.results import CombinationResult
from groundslab.solvers import factorization

#: A plate that does not bend to speak of, and one that does.
RIGID, FLEXIBLE = 3e16, 30e9
#: Ground that carries next to nothing, so that supports do.
AIR = {"kind": "winkler", "k": 1.0}


def raft(E: float = FLEXIBLE, **parts: Any) -> Model:
    """Return a plate of 6 x 4 x 0.25 m with the given parts."""
    plate = {"length_x": 6.0, "length_y": 4.0, "thickness": 0.25, "E": E, "nu": 0.2} | parts.pop("plate", {})
    wanted = {"ground": {"kind": "winkler", "k": 20e6}, "loads": [{"kind": "uniform", "q": 1e4}], "mesh": {"size": 0.5}}
    return Model(plate=plate, **(wanted | parts))


def pile(x: float, y: float, **keys: Any) -> dict[str, Any]:
    """Return a point support."""
    return {"kind": "point", "x": x, "y": y, **keys}


def certified(results: CombinationResult) -> CombinationResult:
    """Return results after a look at their certificate."""
    assert results.certificate.holds
    return results


def test_three_rigid_points_carry_what_statics_says() -> None:
    """On three rigid supports and no ground a point force goes to them as to a three-legged table."""
    legs = [(-2.0, -1.5), (2.0, -1.5), (0.0, 1.5)]
    force = np.array([1.0, -0.5])
    load = [{"kind": "point", "P": 60e3, "x": force[0], "y": force[1]}]
    model = raft(ground=AIR, loads=load, supports=[pile(*leg) for leg in legs], contact={"tensionless": False})
    wanted = np.linalg.solve(np.array([[1, *leg] for leg in legs]).T, 60e3 * np.array([1, *force]))
    found = [support.total for support in certified(solve(model)).supports]
    np.testing.assert_allclose(found, wanted, rtol=1e-6)


def test_settled_supports_tilt_a_statically_determinate_plate_without_bending_it() -> None:
    """Settlements forced on three rigid points move the plate as a plane; no moment arises."""
    legs = [(-2.0, -1.5, 0.004), (2.0, -1.5, 0.001), (0.0, 1.5, 0.0)]
    supports = [pile(x, y, name=f"leg {n}") for n, (x, y, _) in enumerate(legs)]
    loads = [{"kind": "settlement", "support": f"leg {n}", "w": w} for n, (_, _, w) in enumerate(legs)]
    ground = {"kind": "winkler", "k": 100.0}
    plate = certified(solve(raft(ground=ground, loads=loads, supports=supports, contact={"tensionless": False}))).plate
    a, b, c = np.linalg.solve(np.array([[1, x, y] for x, y, _ in legs]), [w for *_, w in legs])
    np.testing.assert_allclose(plate.settlement, a + plate.nodes @ [b, c], atol=1e-7)
    bent = 30e9 * 0.25**3 / 12 * 0.004 / 16
    assert np.abs(plate.moment_x).max() < 1e-4 * bent


@pytest.mark.parametrize("acts", ["both ways", "in compression"])
def test_a_pile_under_a_rigid_plate_shares_with_the_ground(acts: str) -> None:
    """A rigid plate under a central force settles by P / (k A + K); the pile carries K w."""
    K, P = 3e8, 1e6
    model = raft(
        E=RIGID, loads=[{"kind": "point", "P": P, "x": 0.0, "y": 0.0}], supports=[pile(0, 0, stiffness=K, acts=acts)]
    )
    w = P / (20e6 * 24 + K)
    results = certified(solve(model))
    assert results.supports[0].total == pytest.approx(K * w, rel=1e-5)
    assert results.plate.value_at("settlement", 2.0, 1.0) == pytest.approx(w, rel=1e-5)


def test_gap_and_limit_of_a_pile() -> None:
    """It bears K (w - gap) after its gap, and no more than its limit."""
    P, kA, K = 1e6, 20e6 * 24, 3e8

    def total(**keys: Any) -> float:
        load = [{"kind": "point", "P": P, "x": 0.0, "y": 0.0}]
        support = pile(0, 0, stiffness=K, acts="in compression", **keys)
        return certified(solve(raft(E=RIGID, loads=load, supports=[support]))).supports[0].total

    gap = 0.0005
    assert total(gap=gap) == pytest.approx(K * ((P + K * gap) / (kA + K) - gap), rel=1e-5)
    assert total(gap=0.01) == 0.0
    assert total(limit=1e5) == pytest.approx(1e5, rel=1e-12)


def test_an_anchor_holds_what_would_topple() -> None:
    """A rigid plate pulled up at one edge lifts off; an anchor there makes it possible, with the force of statics.

    Own weight 240 kN at x = 0, 200 kN upwards at x = 2: the resultant of 40 kN acts at x = -10, off the plate.  With a
    rigid anchor at x = 2 the ground and it share: the anchor pulls back, and the resultant of the ground's pressure
    has to lie where a triangle of pressure under a rigid plate that turns about the anchor puts it.
    """
    loads = [{"kind": "uniform", "q": 1e4}, {"kind": "line", "q": -50e3, "points": [(2.0, -2.0), (2.0, 2.0)]}]
    with pytest.raises(NoEquilibrium):
        solve(raft(E=RIGID, loads=loads))
    anchor = {"kind": "line", "points": [(2.0, -2.0), (2.0, 2.0)], "acts": "in tension"}
    results = certified(solve(raft(E=RIGID, loads=loads, supports=[anchor])))
    # w = theta (2 - x) under -3 <= x <= 2: pressure k theta (2 - x), zero at the anchor, none beyond
    reach = 5.0
    moment_about_anchor = 240e3 * 2.0
    theta = moment_about_anchor / (20e6 * 4.0 * reach**3 / 3)
    ground = 20e6 * 4.0 * theta * reach**2 / 2
    assert results.plate.value_at("settlement", -3.0, 0.0) == pytest.approx(theta * reach, rel=2e-3)
    assert results.supports[0].total == pytest.approx(240e3 - 200e3 - ground, rel=2e-3)
    assert results.supports[0].total < 0


def test_a_clamping_wall_within_the_plate() -> None:
    """Strips cantilever from a line that holds w and the rotations: w = q l^4 / 8 D + q l^2 / 2 S, M = -q l^2 / 2."""
    wall = {"kind": "line", "points": [(0.0, -2.0), (0.0, 2.0)], "rotation": "fixed"}
    model = raft(plate={"nu": 0.0}, ground=AIR, supports=[wall], contact={"tensionless": False}, mesh={"size": 0.25})
    plate = certified(solve(model)).plate
    D, S = 30e9 * 0.25**3 / 12, 5 / 6 * 30e9 / 2 * 0.25
    assert plate.value_at("settlement", 3.0, 0.0) == pytest.approx(1e4 * (81 / (8 * D) + 9 / (2 * S)), rel=1e-4)
    assert plate.value_at("moment_x", 0.0, 0.0) == pytest.approx(-1e4 * 9 / 2, rel=1e-3)


def test_an_elastic_restraint_turns_by_its_moment() -> None:
    """A rigid plate on one point that resists turning: beta = M / K_r, w there = P / K."""
    K, K_r = 1e8, 5e7
    support = pile(0.0, 0.0, stiffness=K, rotational_stiffness=K_r)
    load = [{"kind": "point", "P": 1e5, "M_x": 2e4, "M_y": -1e4, "x": 0.0, "y": 0.0}]
    results = certified(solve(raft(E=1e13, ground=AIR, loads=load, supports=[support], contact={"tensionless": False})))
    w = 1e5 / K + results.plate.nodes @ (np.array([2e4, -1e4]) / K_r)
    np.testing.assert_allclose(results.plate.settlement, w, rtol=1e-3, atol=1e-7)
    np.testing.assert_allclose(
        [results.supports[0].moment_x[0], results.supports[0].moment_y[0]], [-2e4, 1e4], rtol=1e-4
    )


@pytest.mark.parametrize("element", ["mitc9", "q9", "heterosis"])
def test_a_free_plate_curls_to_a_paraboloid(element: str) -> None:
    """A difference of temperature bends a free plate to the curvature alpha dT / t without any moment."""
    loads = [{"kind": "temperature", "difference": 10.0}]
    model = raft(plate={"element": element}, ground=AIR, loads=loads, contact={"tensionless": False})
    plate = certified(solve(model)).plate
    kappa = 1e-5 * 10.0 / 0.25
    r2 = (plate.nodes**2).sum(axis=1)
    centre = plate.value_at("settlement", 0.0, 0.0)
    # warmer at the bottom: the middle hangs down
    np.testing.assert_allclose(plate.settlement, centre - kappa * r2 / 2, atol=1e-6 * kappa * r2.max())
    assert np.abs(plate.moment_x).max() < 1e-5 * 30e9 * 0.25**3 / 12 * kappa


def test_a_clamped_plate_does_not_curl() -> None:
    """Held all round it stays flat and carries M = -(1 + nu) D alpha dT / t everywhere."""
    loads = [{"kind": "temperature", "difference": 10.0}]
    model = raft(plate={"support": "clamped"}, ground=AIR, loads=loads, contact={"tensionless": False})
    plate = certified(solve(model)).plate
    D = 30e9 * 0.25**3 / (12 * (1 - 0.2**2))
    np.testing.assert_allclose(plate.moment_x, -(1 + 0.2) * D * 1e-5 * 10.0 / 0.25, rtol=1e-6)
    assert np.abs(plate.settlement).max() < 1e-12


def rigid_on_yielding_springs(P: float, M: float, limit: float) -> tuple[float, float]:
    """Return settlement and slope of a rigid strip of 6 m on springs of 20 MPa/m that yield, by its two equilibria."""
    x = (np.arange(60_000) + 0.5) / 60_000 * 6 - 3

    def missing(state: np.ndarray) -> list[float]:
        p = np.clip(20e6 * (state[0] + state[1] * x), 0, limit)
        return [p.mean() * 6 * 4 / P - 1, (p * x).mean() * 6 * 4 / P - M / P]

    found, _, flag, _ = fsolve(missing, [P / 24 / 20e6, 1e-4], full_output=True, xtol=1e-12)
    assert flag == 1
    return found[0], found[1]


@pytest.mark.slow
@pytest.mark.parametrize("increments", [1, 5])
def test_a_rigid_plate_on_ground_that_yields(increments: int) -> None:
    """An eccentric force on a rigid plate makes one end yield and the other lift off, as the two equilibria say.

    For a load that grows in proportion the increments lead to the same end.
    """
    P, limit = 1e6, 80e3
    load = [{"kind": "point", "P": P, "x": 1.2, "y": 0.0}]
    model = raft(
        E=1e14, loads=load, contact={"limit_pressure": limit}, mesh={"size": 0.125, "symmetry": "off"},
        analysis={"increments": increments},
    )  # fmt: skip
    results = certified(solve(model))
    w, slope = rigid_on_yielding_springs(P, P * 1.2, limit)
    plate = results.plate
    assert plate.value_at("settlement", 0.0, 0.0) == pytest.approx(w, rel=2e-3)
    assert plate.value_at("settlement", 3.0, 0.0) == pytest.approx(w + 3 * slope, rel=2e-3)
    assert plate.pressure.max() == pytest.approx(limit, rel=1e-9)
    assert (plate.gap > 0).any()
    sunk = w + 3 * slope - limit / 20e6
    assert sunk > 0
    assert plate.penetration.max() == pytest.approx(sunk, rel=5e-3)


def test_more_than_the_ground_can_carry_is_refused() -> None:
    """A load above limit times area has no equilibrium, and the message says both."""
    with pytest.raises(NoEquilibrium, match=r"240 kN are more than .* 216 kN"):
        solve(raft(contact={"limit_pressure": 9e3}))
    certified(solve(raft(contact={"limit_pressure": 11e3})))


@pytest.mark.slow
def test_a_cavity_carries_nothing() -> None:
    """Over a cavity no pressure arises however far the plate settles, and the rest of the ground carries all."""
    void = {"shape": {"kind": "circle", "centre": (1.0, 0.5), "radius": 0.8}}
    plate = certified(solve(raft(contact={"voids": [void]}, mesh={"size": 0.2}))).plate
    inside = np.hypot(*(plate.nodes - [1.0, 0.5]).T) < 0.8 - 1e-9
    assert inside.sum() > 50
    assert not plate.pressure[inside].any()
    assert (plate.pressure * plate.area).sum() == pytest.approx(240e3, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(("threads", "beyond"), [(3, "none"), (1, "infinite")])
def test_combinations_are_solved_by_themselves(threads: int, beyond: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each is what its factors give as a model of their own, side by side as well as one after the other.

    Uplift alone is refused, in a combination it is not.
    """
    monkeypatch.setattr(factorization, "threads", lambda _: threads)
    parts: dict[str, Any] = {
        "ground": {"kind": "pasternak", "k0": 20e6, "k1": 10e6},
        "beyond": {"kind": beyond, **({"width": 2.0} if beyond == "infinite" else {})},
        "cases": [{"name": "G"}, {"name": "Q"}, {"name": "W"}],
        "loads": [
            {"kind": "uniform", "q": 1e4, "case": "G"},
            {"kind": "patch", "q": 2e5, "x": (1.5, 2.5), "y": (0, 1), "case": "Q"},
            {"kind": "patch", "q": -2e4, "x": (-3, -1), "y": (-2, 2), "case": "W"},
        ],
    }
    factors = {
        "a": {"G": 1.35, "Q": 1.5},
        "b": {"W": 1.0},
        "c": {"G": 1.0, "W": 0.8},
        "d": {"G": 1.0, "Q": 1.0, "W": 0.7},
    }
    combinations = [{"name": name, "factors": each} for name, each in factors.items()]
    reported: list[str] = []
    steps: dict[str, list[Step]] = {}

    def begin(combination: Combination) -> None:
        reported.append(combination.name)

    found = solve_combinations(
        raft(**parts, combinations=combinations), lambda step: steps.setdefault(reported[-1], []).append(step), begin
    )
    assert reported == list(factors)
    assert list(found.refused) == ["b"]
    assert {name: tuple(each) for name, each in steps.items()} == {n: each.steps for n, each in found.results.items()}
    with pytest.raises(NoEquilibrium, match="do not press the plate down"):
        found["b"]
    for name in found.results:
        alone = solve(raft(**parts, combinations=[{"name": name, "factors": factors[name]}]))
        np.testing.assert_allclose(found[name].plate.settlement, alone.plate.settlement, atol=1e-12)
        np.testing.assert_array_equal(found[name].plate.in_contact, alone.plate.in_contact)
    lifted = [int((~results.plate.in_contact).sum()) for results in found.results.values()]
    assert len(set(lifted)) == 3, "the combinations should differ in their contact zone"
