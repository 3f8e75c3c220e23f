"""Joints between plates against beams of two parts on springs and on Pasternak ground, solved by themselves."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
import pytest

from groundslab import Model, NoEquilibrium, solve
from groundslab.analysis.driver import solve_combinations
from groundslab.design.demands.by_plate import results_by_plate
from groundslab.results.results import CombinationResult, Results, results_of
from groundslab.views.tables.result_tables import tables_of
from helpers.solve_once import solve_once

SOIL = [{"thickness": 3.0, "E": 20e6, "nu": 0.3}, {"thickness": 4.0, "E": 50e6, "nu": 0.25}]
WEIGHT = {"kind": "self weight", "unit_weight": 25e3}
T, E, L = 0.25, 30e9, 6.0


@dataclass(frozen=True)
class JoinedBeam:
    """A Timoshenko beam of two parts, joined at 0, from -L to L on k0 and k1, under P at x < 0; per width.

    With Q' = k0 w - k1 w'', M' = Q, M = -D beta' and Q = S (w' - beta) each part is a sum of exponentials of the roots
    of D (1 + k1 / S) r^4 - (k1 + D k0 / S) r^2 + k0 = 0. At outer ends the ground's tail carries k1 (a w + |w'|).
    """

    k0: float
    k1: float
    P: float
    x: float
    k_j: float  # of the joint; infinite for a hinge
    gap: float = 0.0  # [m] of w_A - w_B before the joint carries, which must be reached

    def solved(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the roots, and amplitudes (3, 4) on both sides of the load and beyond the joint."""
        D, S = E * T**3 / 12, 5 / 6 * E / 2 * T
        r = np.roots([D * (1 + self.k1 / S), 0.0, -(self.k1 + D * self.k0 / S), 0.0, self.k0]).astype(complex)
        Q = self.k0 / r - self.k1 * r
        beta = r - Q / S
        rows, right = [], []

        def state(part: int, x: float) -> dict[str, np.ndarray]:
            found = {}
            for name, factor in {"w": 1 + 0 * r, "slope": r, "beta": beta, "M": -D * r * beta, "Q": Q}.items():
                row = np.zeros((3, 4), dtype=complex)
                row[part] = factor * np.exp(r * x)
                found[name] = row.ravel()
            return found

        def demand(row: np.ndarray, value: float = 0.0) -> None:
            rows.append(row)
            right.append(value)

        tail = np.sqrt(self.k0 * self.k1)
        left, before, after = state(0, -L), state(0, self.x), state(1, self.x)
        near, beyond, end = state(1, 0.0), state(2, 0.0), state(2, L)
        demand(left["M"])
        demand(left["Q"] - tail * left["w"] + self.k1 * left["slope"])
        demand(end["M"])
        demand(end["Q"] + tail * end["w"] + self.k1 * end["slope"])
        for name in ("w", "beta", "M"):
            demand(after[name] - before[name])
        demand(after["Q"] - before["Q"] + self.k1 * (after["slope"] - before["slope"]), -self.P)
        demand(near["M"])
        demand(beyond["M"])
        demand(beyond["Q"] - near["Q"] + self.k1 * (beyond["slope"] - near["slope"]))
        if self.k_j == 0:
            demand(near["Q"])
        else:
            demand(near["w"] - beyond["w"] + near["Q"] / self.k_j, self.gap)
        return r, np.linalg.solve(np.array(rows), np.array(right, dtype=complex)).reshape(3, 4)

    def w(self, x: float, beyond: bool = False) -> float:
        """Return the settlement at x; at 0 that of the loaded part, or of the one beyond the joint."""
        r, c = self.solved()
        part = 2 if x > 0 or beyond else 1 if x > self.x else 0
        return float((c[part] @ np.exp(r * x)).real)


def joined(joint: dict[str, Any], loads: list[dict[str, Any]], **parts: Any) -> CombinationResult:
    """Return the results of two strips, 1 m wide, joined at x = 0."""
    strip = {"thickness": T, "E": E, "nu": 0.0}
    usual: dict[str, Any] = {
        "plate": {"name": "A", "outline": {"kind": "rectangle", "x": (-L, 0), "y": (0, 1)}, **strip},
        "plates": [{"name": "B", "outline": {"kind": "rectangle", "x": (0, L), "y": (0, 1)}, **strip}],
        "joints": [{"between": ("A", "B"), **joint}],
        "ground": {"kind": "winkler", "k": 2e7},
        "beyond": {"kind": "infinite", "sides": ["left", "right"]},
        "contact": {"tensionless": False},
        "loads": loads,
        "mesh": {"size": 0.125},
    }
    return solve_once(Model.model_validate(usual | parts)).only


def across(results: CombinationResult, y: float = 0.5) -> tuple[float, float]:
    """Return the settlements of both plates at the joint [m]."""
    plate = results.plate
    at = (np.abs(plate.nodes[:, 0]) < 1e-9) & (np.abs(plate.nodes[:, 1] - y) < 1e-9)
    of = {0: np.nan, 1: np.nan}
    for node in np.flatnonzero(at):
        of[int(results.elements.section[(plate.elements == node).any(axis=1)][0])] = plate.settlement[node]
    return of[0], of[1]


def line(x: float, P: float = 50e3) -> dict[str, Any]:
    """Return a force on a line across the strip."""
    return {"kind": "line", "q": P, "points": [(x, 0), (x, 1)]}


JOINTS = {"hinge": np.inf, "dowels": 8e7, "loose dowels": 5e6, "nothing": 0.0}


def keys_of(k_j: float) -> dict[str, Any]:
    """Return the keys of a joint."""
    return {"kind": "hinge"} if np.isinf(k_j) else {"kind": "elastic", "stiffness": k_j}


@pytest.mark.parametrize("kind", JOINTS)
def test_strips_on_springs(kind: str) -> None:
    """Two strips on springs, a line force 1 m before the joint: settlements on both sides and away from it."""
    exact, results = JoinedBeam(2e7, 0.0, 50e3, -1.0, JOINTS[kind]), joined(keys_of(JOINTS[kind]), [line(-1.0)])
    largest = exact.w(-1.0)
    assert across(results) == pytest.approx((exact.w(0.0), exact.w(0.0, beyond=True)), abs=2e-5 * largest)
    for x in (-3.0, -1.0, 1.0, 3.0):
        assert results.plate.value_at("settlement", x, 0.5) == pytest.approx(exact.w(x), abs=2e-5 * largest)
    assert results.certificate.holds


@pytest.mark.parametrize("kind", JOINTS)
def test_shear_along_the_joint(kind: str) -> None:
    """The table gives the force that passes the joint, Q of the beam there, and what settles beyond carries it."""
    exact, results = JoinedBeam(2e7, 0.0, 50e3, -1.0, JOINTS[kind]), joined(keys_of(JOINTS[kind]), [line(-1.0)])
    r, c = exact.solved()
    passed = -float((c[2] @ (exact.k0 / r)).real)
    (table,) = (each for each in tables_of(results_of(results)) if each.name == "joints")
    row = {column.name: column.values[0] for column in table.columns}
    assert row["joint"] == "A - B"
    assert (row["length"], row["x of it"]) == pytest.approx((1.0, 0.0))
    assert (row["force"], row["greatest force per length"]) == pytest.approx((passed / 1e3,) * 2, rel=2e-4, abs=1e-3)
    assert row["greatest step"] == pytest.approx(1e3 * (exact.w(0.0) - exact.w(0.0, beyond=True)), abs=1e-5)
    carried = results_by_plate(results)["B"].contact_force.sum()
    assert carried == pytest.approx(passed, rel=1e-3, abs=1)


def test_glued_strips_on_pasternak_ground() -> None:
    """On ground with shear the surface goes on under the joint: a hinge, tails at both ends, a kink at the joint."""
    ground = {"kind": "pasternak", "k0": 2e7, "k1": 3e7}
    exact = JoinedBeam(2e7, 3e7, 50e3, -1.0, np.inf)
    results = joined({"kind": "hinge"}, [line(-1.0)], ground=ground)
    largest = exact.w(-1.0)
    assert across(results) == pytest.approx((exact.w(0.0), exact.w(0.0)), abs=2e-5 * largest)
    for x in (-6.0, -3.0, -1.0, 1.0, 3.0, 6.0):
        assert results.plate.value_at("settlement", x, 0.5) == pytest.approx(exact.w(x), abs=2e-5 * largest)
    assert results.certificate.holds


def test_load_transfer_efficiency() -> None:
    """A force at the joint of long slabs: w_B / w_A = b / (1 + b) with b = k_j over what one side's end resists.

    Nothing passes a joint that carries nothing, and both sides of a hinge share alike.
    """
    end = JoinedBeam(2e7, 0.0, 1.0, -1e-6, 0.0).w(0.0)  # of one end under a force of 1 N
    for k_j in (0.0, 1e6, 5e7, 1e9):
        loaded, other = across(joined(keys_of(k_j), [line(0.0)]))
        # a force on the line that both share is that of one plate alone
        w_A, w_B = max(loaded, other), min(loaded, other)
        b = k_j * end
        assert w_B / w_A == pytest.approx(b / (1 + b), abs=1e-3)
        assert w_A + w_B == pytest.approx(50e3 * end, rel=1e-3)
    assert np.ptp(across(joined({"kind": "hinge"}, [line(0.0)]))) < 1e-5 * 50e3 * end


GROUNDS: dict[str, dict[str, Any]] = {
    "pasternak": {"kind": "pasternak", "k0": 2e7, "k1": 3e7},
    "vlasov": {"kind": "vlasov", "layers": SOIL},
    "consistent": {"kind": "layered", "coupling": "consistent", "layers": SOIL},
}


@pytest.mark.parametrize("kind", GROUNDS)
@pytest.mark.parametrize("joint", ["hinge", "dowels"])
def test_one_sided_contact_on_ground_with_shear(kind: str, joint: str) -> None:
    """The ground's surface goes on under slabs that may lift off, and a joint carries less than a stiffer one."""
    parts: dict[str, Any] = {"ground": GROUNDS[kind], "contact": {"tensionless": True}, "mesh": {"size": 0.5}}
    loads = [WEIGHT, line(-1.0)]
    results, stiff, loose = (joined(keys_of(k), loads, **parts) for k in (JOINTS[joint], np.inf, 0.0))
    assert results.certificate.holds
    assert results.certificate.joint_mismatch is not None
    assert results.certificate.joint_mismatch < 1e-5
    steps = [a - b for a, b in map(across, (stiff, results, loose))]
    assert steps[0] == pytest.approx(0.0, abs=1e-6 * loose.plate.settlement.max())
    assert steps[0] - 1e-9 <= steps[1] <= steps[2]
    assert results.plate.contact_force.sum() == pytest.approx(50e3 + 25e3 * T * 2 * L, rel=1e-6)


def test_a_joint_holds_a_plate_that_would_lift_alone() -> None:
    """Uplift of more than its weight near a hinge does not lift a slab off, as the other one holds it there."""
    uplift = {"kind": "patch", "q": -100e3, "x": (0.0, 0.4), "y": (0.0, 1.0)}
    parts = {"contact": {"tensionless": True}, "mesh": {"size": 0.5}}
    more = {"kind": "uniform", "q": 10e3, "plate": "A"}
    held = joined({"kind": "hinge"}, [WEIGHT, more, uplift], **parts)
    assert held.certificate.holds
    assert held.certificate.load == pytest.approx(25e3 * T * 2 * L + 60e3 - 40e3)
    with pytest.raises(NoEquilibrium, match="B: the loads do not press the plate down"):
        joined({"kind": "elastic", "stiffness": 0.0}, [WEIGHT, more, uplift], **parts)
    with pytest.raises(NoEquilibrium, match="A and B: the loads on these joined plates cannot be balanced"):
        joined({"kind": "hinge"}, [WEIGHT | {"plate": "A"}], **parts)
    with pytest.raises(NoEquilibrium, match="cannot be balanced"):
        joined({"kind": "hinge"}, [WEIGHT, more, uplift | {"x": (3.6, 4.0)}], **parts)


@pytest.mark.parametrize("sign", [1, -1])
def test_play(sign: int) -> None:
    """Nothing passes a joint within its play, and beyond it only what the rest of the step makes, either way."""
    free = JoinedBeam(2e7, 0.0, 50e3, -1.0, 0.0)
    step = free.w(0.0)
    wide, narrow = (joined(keys_of(8e7) | {"gap": share * step}, [line(-1.0, sign * 50e3)]) for share in (1.01, 0.4))
    assert across(wide) == pytest.approx((sign * step, 0.0), abs=1e-5 * step)
    exact = JoinedBeam(2e7, 0.0, 50e3, -1.0, 8e7, 0.4 * step)
    expected = sign * exact.w(0.0), sign * exact.w(0.0, beyond=True)
    assert across(narrow) == pytest.approx(expected, abs=2e-5 * exact.w(-1.0))
    assert narrow.certificate.holds
    assert wide.certificate.holds


def slabs_at_a_hinge(size: float) -> Results:
    """Return two slabs of 3 m x 4 m joined by a hinge, on Pasternak ground, with 50 kN on its middle."""
    sides = [{"x": (-3, 0), "y": (-2, 2)}, {"x": (0, 3), "y": (-2, 2)}]
    slabs = [
        {"name": name, "thickness": 0.2, "E": 30e9, "nu": 0.2, "outline": {"kind": "rectangle"} | side}
        for name, side in zip("ab", sides, strict=True)
    ]
    return solve_combinations(
        Model(
            plate=slabs[0],
            plates=slabs[1:],
            joints=[{"kind": "hinge", "between": ("a", "b")}],
            ground={"kind": "pasternak", "k0": 20e6, "k1": 5e6},
            contact={"tensionless": False},
            loads=[{"kind": "point", "P": 50e3, "x": 0.0, "y": 0.0}],
            mesh={"size": size},
        )
    )


@pytest.mark.slow
def test_moments_under_a_force_on_a_hinge() -> None:
    """No moment bends or twists the slab across it, where means over discs are told, too; half a disc has 3 kNm/m.

    The largest and least moments are the same on any mesh, within the sum of both told errors.
    """
    told = []
    for size in (0.1, 0.13, 0.2):
        results = slabs_at_a_hinge(size)
        plate = results.only.plate
        across = (np.hypot(*plate.nodes.T) < 0.2) & (np.abs(plate.nodes[:, 0]) < 1e-9)
        assert across.sum() > 2
        assert np.abs(plate.moment_x[across]).max() < 1.0  # N m/m
        assert np.abs(plate.moment_xy[across]).max() < 1.0
        extremes = next(table for table in tables_of(results) if table.name == "extremes")
        moments = [str(quantity).startswith("moment m_") for quantity in extremes["quantity"]]
        columns = ("least", "greatest", "error of the least", "error of the greatest")
        told.append(np.array([extremes[column] for column in columns], dtype=float)[:, moments].reshape(2, 2, -1))
    for one, other in combinations(told, 2):
        assert (np.abs(one[0] - other[0]) <= one[1] + other[1]).all()


def test_play_on_tensionless_ground_with_shear() -> None:
    """With play slabs that may lift off step by more than without, and by no more than where nothing is carried."""
    parts: dict[str, Any] = {"ground": GROUNDS["pasternak"], "contact": {"tensionless": True}, "mesh": {"size": 0.5}}
    loads = [WEIGHT, line(-1.0)]
    joints = (keys_of(1e9), keys_of(1e9) | {"gap": 2e-5}, keys_of(0.0))
    tight, play, loose = (joined(joint, loads, **parts) for joint in joints)
    assert play.certificate.holds
    steps = [a - b for a, b in map(across, (tight, play, loose))]
    assert steps[0] < 1e-5 < 2e-5 < steps[1] < steps[2]


def test_four_slabs_that_meet_at_a_point() -> None:
    """Four slabs joined to their neighbors, with play in two joints, are alike under a force on all of them."""
    corners = {"A": (-1, -1), "B": (1, -1), "C": (1, 1), "D": (-1, 1)}
    slabs = [
        {
            "name": name,
            "outline": {"kind": "rectangle", "x": sorted((0, 3 * x)), "y": sorted((0, 3 * y))},
            "thickness": T,
            "E": E,
            "nu": 0.2,
        }
        for name, (x, y) in corners.items()
    ]
    joints = [
        {"kind": "elastic", "stiffness": 1e8, "between": pair, "gap": 1e-5 * (n % 2)}
        for n, pair in enumerate((("A", "B"), ("B", "C"), ("C", "D"), ("D", "A")))
    ]
    press = {"kind": "patch", "q": 200e3, "x": (-0.25, 0.25), "y": (-0.25, 0.25)}
    results = solve(
        Model.model_validate(
            {
                "plate": slabs[0],
                "plates": slabs[1:],
                "joints": joints,
                "ground": GROUNDS["pasternak"],
                "beyond": {"kind": "infinite"},
                "loads": [WEIGHT, press],
                "mesh": {"size": 0.5},
            }
        )
    ).only
    assert results.certificate.holds
    assert results.certificate.load == pytest.approx(25e3 * T * 36 + 200e3 * 0.25)
    corner = [results.plate.value_at("settlement", x, y) for x in (-3.0, 3.0) for y in (-3.0, 3.0)]
    assert corner == pytest.approx([corner[0]] * 4, rel=1e-6)


ON: dict[str, dict[str, Any]] = {
    "springs": {"kind": "winkler", "k": 3e8},
    "pasternak": {"kind": "pasternak", "k0": 2e7, "k1": 3e7},
    "vlasov": {"kind": "vlasov", "layers": [{"thickness": 3.0, "E": 50e6, "nu": 0.3}]},
    "continuum": {"kind": "continuum", "layers": [{"thickness": 4.0, "E": 20e6, "nu": 0.3}]},
}


def bays(ground: str, contrast: float, size: float, tensionless: bool) -> CombinationResult:
    """Return two bays that a hinge joins, the second one stiffer by a factor, under a force beside the hinge."""
    bay = {"thickness": 0.2, "nu": 0.2}
    first = bay | {"name": "A", "E": 30e9, "outline": {"kind": "rectangle", "x": (-3, 0), "y": (-1.5, 1.5)}}
    second = bay | {"name": "B", "E": contrast * 30e9, "outline": {"kind": "rectangle", "x": (0, 3), "y": (-1.5, 1.5)}}
    return solve(
        Model.model_validate(
            {
                "plate": first,
                "plates": [second],
                "joints": [{"kind": "hinge", "between": ("A", "B")}],
                "ground": ON[ground],
                "beyond": {"kind": "infinite"},
                "contact": {"tensionless": tensionless},
                "loads": [{"kind": "uniform", "q": 5e3}, {"kind": "point", "P": 100e3, "x": -0.5, "y": 0.0}],
                "mesh": {"size": size},
            }
        )
    ).only


@pytest.mark.slow
@pytest.mark.parametrize(("contrast", "tensionless"), [(1e-6, True), (1e6, False), (1e6, True)])
@pytest.mark.parametrize("ground", ON)
def test_a_hinge_is_exact_at_any_contrast(ground: str, contrast: float, tensionless: bool) -> None:
    """Both sides settle alike to the last digit, and the hinge's force is what the second plate's ground carries."""
    # on a continuum a plate of 3e16 Pa leaves more to rounding than a certificate allows
    stiffer = min(contrast, 1e5) if ground == "continuum" else contrast
    results = bays(ground, stiffer, 0.5, tensionless)
    (joint,) = results.joints
    assert results.certificate.holds
    assert not joint.step.any()
    cells = results.ground.cells
    if cells is None:
        carried = results_by_plate(results)["B"].contact_force.sum()
    else:
        carried = cells.force[cells.center[:, 0] > 0].sum()
    assert joint.total == pytest.approx(carried - 5e3 * 9, abs=1e-6 * 190e3)


@pytest.mark.slow
@pytest.mark.parametrize("size", [1.25, 0.1])
def test_a_hinge_is_exact_on_any_mesh(size: float) -> None:
    """On elements of 1.25 m and of 0.1 m nothing steps across a hinge, and half of the force passes it by symmetry.

    The force stands on the hinge, half of it on each plate: together they settle as one half does, whose moment at the
    hinge is zero.
    """
    ground = {"kind": "winkler", "k": 3e8}
    results = joined({"kind": "hinge"}, [line(0.0)], ground=ground, mesh={"size": size})
    (joint,) = results.joints
    assert results.certificate.holds
    assert results.certificate.joint_mismatch == 0.0
    assert not joint.step.any()
    for plate in results_by_plate(results).values():
        assert plate.contact_force.sum() == pytest.approx(25e3, rel=1e-8)


def test_hinges_of_four_slabs_at_a_point() -> None:
    """Four slabs in a ring of hinges settle alike at their corner, where three of the four forces balance the rest.

    By symmetry every hinge carries nothing in all, under a force of which a quarter stands on each slab.
    """
    corners = {"A": (-1, -1), "B": (1, -1), "C": (1, 1), "D": (-1, 1)}
    slabs = [
        {
            "name": name,
            "outline": {"kind": "rectangle", "x": sorted((0, 2 * x)), "y": sorted((0, 2 * y))},
            "thickness": T,
            "E": E,
            "nu": 0.2,
        }
        for name, (x, y) in corners.items()
    ]
    joints = [{"kind": "hinge", "between": pair} for pair in (("A", "B"), ("B", "C"), ("C", "D"), ("D", "A"))]
    press = {"kind": "patch", "q": 200e3, "x": (-0.25, 0.25), "y": (-0.25, 0.25)}
    parts = {"ground": {"kind": "winkler", "k": 2e7}, "loads": [WEIGHT, press], "mesh": {"size": 0.5}}
    results = solve(Model.model_validate({"plate": slabs[0], "plates": slabs[1:], "joints": joints, **parts})).only
    assert results.certificate.holds
    for joint in results.joints:
        assert not joint.step.any()
        assert joint.total == pytest.approx(0.0, abs=1e-6 * 200e3 * 0.25)
