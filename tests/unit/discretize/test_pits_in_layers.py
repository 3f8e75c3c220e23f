"""Layers of soil under pits: what of them is left, by hand and as a zone of soil with that much less of it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import Model, solve
from groundslab.discretize.discretize import discretize
from groundslab.discretize.ground import cut_off, medium_of
from groundslab.fem.continuum.media import StressedLayers
from groundslab.model.ground import ConstrainedModulus

PIT = {"kind": "rectangle", "x": (1, 3), "y": (-1, 1)}
SOFT, STIFF = {"E": 10e6, "nu": 0.3, "thickness": 2.0}, {"E": 40e6, "E_bottom": 60e6, "nu": 0.25, "thickness": 4.0}


def test_the_modulus_below_a_pit_is_that_at_its_depth() -> None:
    """E = 10 + 8 s + 4 s^2 over 3 m, cut at 1 m, and a layer above it that is gone; below nothing changes."""
    table = np.array([[[0.5, 7.0, 0.0, 0.0, 0.1], [3.0, 10.0, 8.0, 4.0, 0.2], [2.0, 30.0, 6.0, 0.0, 0.3]]])
    (cut,) = cut_off(table, np.array([1.5]))
    assert cut[0, 0] == 0.0
    h, c0, c1, c2, nu = cut[1]
    assert (h, nu) == (2.0, 0.2)
    for depth in (0.0, 0.7, 2.0):
        s = (1.0 + depth) / 3.0
        r = depth / 2.0
        assert c0 + c1 * r + c2 * r**2 == pytest.approx(10 + 8 * s + 4 * s**2)
    assert cut[2].tolist() == table[0, 2].tolist()
    assert np.array_equal(cut_off(table, np.zeros(1)), table)


def model(kind: dict[str, Any], zone: dict[str, Any], **parts: Any) -> Model:
    """Return a raft with a zone on two layers of soil under a load off its middle, without weight."""
    return Model.model_validate(
        {
            "plate": {"length_x": 8, "length_y": 6, "thickness": 0.5, "E": 30e9, "nu": 0.2,
                      "zones": [{"shape": PIT, "thickness": 0.6} | zone]},
            "ground": {**kind, "layers": [SOFT, STIFF]},
            "loads": [{"kind": "patch", "q": 8e4, "x": (0, 2), "y": (-1, 2)}],
            "mesh": {"size": 1.0},
        } | parts
    )  # fmt: skip


SUNK = {"level": -1.4, "wall": 0.3}  # 1.5 m deeper than the slab's underside
LESS = [SOFT | {"thickness": 0.5}, STIFF]


@pytest.mark.parametrize(
    "kind", [{"kind": "vlasov", "gamma": 1.2}, {"kind": "layered", "coupling": "consistent"}], ids=["vlasov", "layered"]
)
def test_a_pit_in_layers_is_a_zone_of_soil_with_less_of_them(kind: dict[str, Any]) -> None:
    """1.5 m of 2 m of the soft layer are gone under the pit, and the raft settles as on such a zone of soil."""
    zone = {"soil_zones": [{"shape": PIT, "ground": {**kind, "layers": LESS}}]}
    pit, same, without = solve(model(kind, SUNK)), solve(model(kind, {}, **zone)), solve(model(kind, {}))
    w = [next(iter(each.results.values())).plate.settlement for each in (pit, same, without)]
    assert w[0] == pytest.approx(w[1], rel=1e-9)
    assert w[0].max() < 0.99 * w[2].max()


def test_boreholes_give_the_layers_below_a_pit() -> None:
    """With one borehole of the layers that [ground] has, all is as without any."""
    kind = {"kind": "vlasov", "gamma": 1.2}
    hole = {"boreholes": [{"x": 0, "y": 0, "layers": [SOFT, STIFF]}]}
    w = [next(iter(solve(model(kind, SUNK, **parts)).results.values())).plate.settlement for parts in ({}, hole)]
    assert w[0] == pytest.approx(w[1], rel=1e-9)


def test_layers_of_constrained_moduli_begin_at_the_underside_of_a_pit() -> None:
    """Of 2 m and 4 m, 2.5 m off the top leave 3.5 m; the slab settles less over a pit than over a zone as thick."""
    ground = ConstrainedModulus.model_validate({"layers": [SOFT, STIFF | {"E_bottom": 40e6}]})
    cut = medium_of(ground, ground.layers, above=2.5)
    ratio = 0.75 / (1.25 * 0.5)
    assert isinstance(cut, StressedLayers)
    assert cut.modulus == pytest.approx((ratio * 40e6,))
    assert cut.thickness == pytest.approx((3.5,))
    limited = medium_of(ground, ground.layers, depth=1.0, above=2.5)
    assert isinstance(limited, StressedLayers)
    assert limited.thickness == pytest.approx((1.0,))
    kind = {"kind": "constrained modulus"}
    pit, flat = (next(iter(solve(model(kind, zone)).results.values())).plate for zone in (SUNK, {}))
    assert pit.settlement.max() < 0.95 * flat.settlement.max()


def test_an_excavation_takes_more_off_under_a_pit() -> None:
    """40 kPa under the slab are 40 + 19 * 0.5 + 10 * 1.0 kPa 1.5 m deeper, with water 0.5 m below the slab."""
    weight = {"unit_weight": 19e3, "groundwater": 0.5, "unit_weight_below_water": 10e3, "limit_ratio": 0.2}
    kind = {"kind": "constrained modulus", "relief": 40e3, "reloading": 4.0} | weight
    ground = discretize(model(kind, SUNK)).elastic
    assert ground is not None
    assert ground.relief is not None
    pressure = ground.relief.force / ground.cells.area
    x, y = ground.cells.center.T
    inside = (x > 1) & (x < 3) & (y > -1) & (y < 1)
    assert inside.any()
    assert pressure[inside] == pytest.approx(59.5e3)
    assert pressure[~inside] == pytest.approx(40e3)
