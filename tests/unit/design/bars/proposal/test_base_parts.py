"""More bars of the base in a part of the slab: where they save most, and what of them is developed."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.design.bars.proposal.base_parts import BasePart, best_part
from groundslab.design.bars.proposal.covering import Field
from groundslab.design.checks import check_design
from groundslab.design.proposal import propose_bars
from groundslab.design.rules.combinations import ultimate_results
from groundslab.model.design.bars import Bars
from groundslab.model.design.laid_bars import laid_bars
from groundslab.model.model import Model
from groundslab.results.fields import LAYERS
from helpers.examples import examples
from helpers.solve_once import solve_once

#: 4 cm2/m.
BARS = Bars(diameter=0.01, spacing=math.pi * 0.005**2 / 4e-4)
AREA = 4e-4


@settings(max_examples=examples(60), deadline=None)
@given(
    values=st.lists(st.integers(0, 9), min_size=30, max_size=30), over=st.sampled_from([1.5, 2.0, 3.0]),
    hole=st.tuples(st.integers(0, 5), st.integers(0, 4)),
)  # fmt: skip
def test_no_rectangle_saves_more(values: list[int], over: float, hole: tuple[int, int]) -> None:
    """Of all rectangles, tried one by one, none saves more of what zones would have than it has itself."""
    area = np.ones((6, 5))
    area[hole] = 0
    excess = 1e-4 * np.array(values, dtype=float).reshape(6, 5) * area
    field = Field(excess, area)

    def saved(i0: int, i1: int, j0: int, j1: int) -> float:
        there = np.s_[i0:i1, j0:j1]
        return float((over * np.minimum(excess[there], AREA) * area[there]).sum() - AREA * area[there].sum())

    most = max(
        saved(i0, i1, j0, j1)
        for i0, i1 in itertools.combinations(range(7), 2)
        for j0, j1 in itertools.combinations(range(6), 2)
    )
    part = best_part(field, BARS, 1e-9, (1, 1), over)
    assert (part is not None) == (most > 1e-15)
    if part is not None:
        assert saved(*part.cells) == pytest.approx(most)
        i0, i1, j0, j1 = part.cells
        assert part.steel(field) == pytest.approx(AREA * area[i0:i1, j0:j1].sum())


def test_bars_are_developed_from_their_ends() -> None:
    """In proportion to the way to the nearer end, in full at an edge of the plan, at an opening, and over a middle."""
    area = np.ones((12, 2))
    area[6, 1] = 0
    field = Field(np.zeros((12, 2)), area)
    inside = BasePart(BARS, (2, 10, 0, 2), 4.0).developed(field) / AREA
    assert inside[:, 0] == pytest.approx([0, 0, 0, 0.25, 0.5, 0.75, 0.75, 0.5, 0.25, 0, 0, 0])
    assert inside[[2, 3, 4, 5, 7, 8, 9], 1] == pytest.approx([0, 0.25, 0.5, 0.75, 0.5, 0.25, 0])
    at_edge = BasePart(BARS, (0, 5, 0, 1), 4.0).developed(field) / AREA
    assert at_edge[:, 0] == pytest.approx([1, 0.75, 0.5, 0.25, 0, 0, 0, 0, 0, 0, 0, 0])
    assert not at_edge[:, 1].any()


def test_ends_lie_as_far_out_as_bars_are_needed() -> None:
    """Half of the bars is needed in four cells: they go on by half of what develops them, six cells."""
    excess = np.zeros((30, 3))
    excess[12:16, 1] = AREA / 2
    part = best_part(Field(excess, np.ones((30, 3))), BARS, 6.0, (1, 1), 3.0)
    assert part is not None
    assert part.cells == (9, 19, 1, 2)
    assert (part.developed(Field(excess, np.ones((30, 3)))) >= excess - 1e-12).all()


def slab() -> Model:
    """Return a slab with a heavy middle: a hill of moments that one base and even zones take much steel for."""
    steel: dict[str, Any] = {"concrete": "C30/37", "steel": "B500B", "bottom": (0.05, 0.066), "top": (0.05, 0.066)}
    return Model(
        plate={"length_x": 16, "length_y": 12, "thickness": 0.7, "E": 33e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        cases=[{"name": "G"}],
        loads=[{"kind": "patch", "q": 700e3, "x": (-3, 3), "y": (-2.5, 2.5), "case": "G"}],
        combinations=[{"name": "U", "factors": {"G": 1.35}}],
        reinforcement=steel,
        mesh={"size": 1.0},
    )


@pytest.mark.slow
def test_a_heavy_middle_has_a_base_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    """With less steel than without it; at no place lies more than one zone beside it, and all bars are enough."""
    results = solve_once(slab())
    proposal = propose_bars(results)
    zones = proposal.reinforcement.zones
    parts = [zone for zone in zones if "base" in zone.name]
    assert parts
    nodes = ultimate_results(results)[0].plate.nodes
    for layer in LAYERS:
        of_layer = [zone for zone in zones if layer in zone.layers and zone not in parts]
        sides = [zone.shape.ring().bounds for zone in of_layer]
        for (a0, a1, b0, b1), (c0, c1, d0, d1) in itertools.combinations(sides, 2):
            assert min(a1, c1) <= max(a0, c0) + 1e-9 or min(b1, d1) <= max(b0, d0) + 1e-9
        # three sets of bars in a gap of the base fit as the code asks, 21 mm or their diameter
        laid = laid_bars(proposal.reinforcement, layer, nodes)
        assert (laid.clear >= np.maximum(laid.thickest, 0.021) - 1e-9).all()
    judged = {check.name: check for check in check_design(replace(results, model=proposal.model)).checks}
    for name in (*(f"bars at the {layer.replace('_', ' ')}" for layer in LAYERS), "anchorage of bars"):
        assert judged[name].status == "no failure found", judged[name].words
    monkeypatch.setattr("groundslab.design.bars.proposal.layer_bars.OVER", ())
    assert sum(proposal.laid.values()) < 0.97 * sum(propose_bars(results).laid.values())
