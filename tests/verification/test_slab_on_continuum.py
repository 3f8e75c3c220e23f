"""Slabs on an elastic continuum against an independent solution: polynomials, full matrices, a set of cells.

The oracle has the same cells of pressure but none of the methods: no finite elements, Fourier transforms, factors of
the plate alone, or conjugate gradients.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import CombinationResult, Model, solve
from helpers.dense_continuum import Raft, half_space, layered, press
from helpers.layered_ground import on_rigid_base

#: Settlements may be off by this share of the largest.
TOLERANCE = 1e-3
E_S, NU = 20e6, 0.3


def solved(raft: Raft, ground: dict[str, Any], loads: list[dict[str, Any]], **more: Any) -> CombinationResult:
    """Return the results of a slab with two cells a side of each element."""
    return solve(
        Model(
            plate={"length_x": raft.a, "length_y": raft.b, "thickness": raft.t, "E": raft.E, "nu": raft.nu},
            ground={"kind": "continuum", **ground},
            loads=loads,
            mesh={"counts": (raft.cells[0] // 2, raft.cells[1] // 2)},
            **more,
        )
    ).only


def load(raft: Raft, q: float, patch: tuple[float, float, float, float, float] | None = None) -> np.ndarray:
    """Return the loads of the polynomials by a pressure everywhere and another one on a patch x0, x1, y0, y1."""

    def of(x0: float, x1: float, y0: float, y1: float, p: float) -> np.ndarray:
        sides = (np.array([x0]), np.array([x1])), (np.array([y0]), np.array([y1]))
        return p * (x1 - x0) * (y1 - y0) * raft.means(*sides)[0]

    f = of(-raft.a / 2, raft.a / 2, -raft.b / 2, raft.b / 2, q)
    return f if patch is None else f + of(*patch)


def compare(raft: Raft, results: CombinationResult, u: np.ndarray, places: list[tuple[float, float]]) -> None:
    """Compare settlements at places."""
    expected = np.array([raft.at(*place) @ u for place in places])
    found = np.array([results.plate.value_at("settlement", *place) for place in places])
    assert np.abs(found - expected).max() < TOLERANCE * np.abs(expected).max()


@pytest.mark.slow
@pytest.mark.parametrize("t", [0.25, 1.25])
def test_the_plate_of_table_3_on_a_layer(t):
    """Center and corner of the paper's square plate on 10 m of soil over a rigid base, 32 x 32 cells."""
    raft, h, E = Raft(5.0, 5.0, t, 21e9, 0.167, (32, 32)), 10.0, 38.22e6
    T = np.vectorize(lambda k: on_rigid_base(E, 0.3, h, k))
    u, _ = press(raft, layered(raft, E, 0.3, T, h), load(raft, 1e5))
    ground = {"layers": [{"E": E, "nu": 0.3, "thickness": h}]}
    results = solved(raft, ground, [{"kind": "uniform", "q": 1e5}])
    compare(raft, results, u, [(0.0, 0.0), (2.5, 2.5), (2.5, 0.0), (1.0, 1.5)])


@pytest.mark.slow
def test_a_slab_that_lifts_off_around_its_load():
    """A patch in the middle lifts the corners; settlements, what touches and what each cell carries."""
    raft = Raft(6.0, 4.0, 0.15, 30e9, 0.2, (36, 24))
    q, patch = 1e3, (-0.5, 0.5, -0.5, 0.5, 5e5)
    u, x = press(raft, half_space(raft, E_S, NU), load(raft, q, patch))
    results = solved(
        raft,
        {"half_space": {"E": E_S, "nu": NU}},
        [{"kind": "uniform", "q": q}, {"kind": "patch", "q": 5e5, "x": (-0.5, 0.5), "y": (-0.5, 0.5)}],
    )
    compare(raft, results, u, [(0.0, 0.0), (3.0, 2.0), (3.0, 0.0), (0.0, 2.0), (1.5, 1.0), (-2.5, 1.5)])
    assert 0.2 < (x > 0).mean() < 0.95
    assert results.plate.contact_share == pytest.approx((x > 0).mean(), abs=0.003)
    middle = x.reshape(36, 24)[17:19, 11:13].mean() / np.prod(raft.size)
    assert results.plate.value_at("pressure", 0.0, 0.0) == pytest.approx(middle, rel=1e-2)


@pytest.mark.slow
def test_a_slab_under_a_load_at_its_corner():
    """The far corner lifts off; without tension the near one sinks deeper than a glued slab's."""
    raft = Raft(6.0, 4.0, 0.4, 30e9, 0.2, (36, 24))
    q, patch = 2e3, (1.5, 2.5, 0.5, 1.5, 3e5)
    F, f = half_space(raft, E_S, NU), load(raft, q, patch)
    ground = {"half_space": {"E": E_S, "nu": NU}}
    loads = [{"kind": "uniform", "q": q}, {"kind": "patch", "q": 3e5, "x": (1.5, 2.5), "y": (0.5, 1.5)}]
    places = [(2.0, 1.0), (3.0, 2.0), (-3.0, -2.0), (-3.0, 2.0), (0.0, 0.0)]
    for tensionless in (True, False):
        u, x = press(raft, F, f, tensionless)
        results = solved(raft, ground, loads, contact={"tensionless": tensionless})
        compare(raft, results, u, places)
        assert (x.min() < 0) is not tensionless
    assert raft.at(-3.0, -2.0) @ u > -1e-2


@pytest.mark.slow
def test_a_rigid_footing_beyond_its_kern():
    """A force a third of the side from the middle lifts off a part of a rigid square; statics hold its moments."""
    raft = Raft(3.0, 3.0, 2.0, 30e12, 0.2, (30, 30), n=4)
    patch = (0.9, 1.1, -0.1, 0.1, 1e6 / 0.04)
    u, x = press(raft, half_space(raft, E_S, NU), load(raft, 0.0, patch))
    results = solved(
        raft,
        {"half_space": {"E": E_S, "nu": NU}},
        [{"kind": "patch", "q": 1e6 / 0.04, "x": (0.9, 1.1), "y": (-0.1, 0.1)}],
    )
    assert x @ raft.centers[0] == pytest.approx(1e6 * 1.0, rel=1e-6)
    assert (x > 0).mean() < 0.75
    compare(raft, results, u, [(-1.5, 0.0), (0.0, 0.0), (1.0, 0.0), (1.5, 1.5)])
    assert results.plate.contact_share == pytest.approx((x > 0).mean(), abs=0.003)
