"""Soil and zones of soil that reach out of proportion to the plate."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab.errors import InputError
from groundslab.model.model import Model

PLATE = {"length_x": 6, "length_y": 4, "thickness": 0.25, "E": 30e9, "nu": 0.2}
SOIL = {"E": 2e7, "nu": 0.3, "thickness": 7000}


def model(**changes: Any) -> Model:
    """Return a model of a plate on springs with some parts changed."""
    return Model(**{"plate": PLATE, "ground": {"kind": "winkler", "k": 2e7}, "loads": [{"kind": "uniform", "q": 1}],
                    **changes})  # fmt: skip


def test_soil_deep_beside_the_plate() -> None:
    """A base 14 km below a plate of 6 m is a mistake; 7 km below it is not refused, nor is a larger plate."""
    deep = {"kind": "vlasov", "layers": [SOIL, SOIL]}
    with pytest.raises(InputError, match=r"ground.layers: found layers of 14000 m, expected at most 12000 m"):
        model(ground=deep)
    assert model(ground={**deep, "layers": [SOIL]})
    assert model(ground=deep, plate={**PLATE, "length_x": 12})


def test_soil_zones_far_beyond_the_plate() -> None:
    """A zone may reach a thousand plates far, so that half planes can be drawn; further it is refused."""
    ground = {"kind": "winkler", "k": 1e7}
    near, far = ({"shape": {"kind": "circle", "centre": (r, 0), "radius": r}, "ground": ground} for r in (2e3, 1e6))
    assert model(soil_zones=[near])
    with pytest.raises(InputError, match=r"soil_zones\[1\].shape: found a zone that reaches 2e\+06 m from the plate"):
        model(soil_zones=[far])
