"""The column of soil that grounds are compared on."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab.analysis.ground_comparison.soil_column import FROM_SOIL, find_soil, on_continuum, on_ground
from groundslab.errors import InputError
from groundslab.model.ground import Continuum, Vlasov, Winkler
from groundslab.model.model import Model

SOFT = {"E": 10e6, "nu": 0.3, "thickness": 3.0}
STIFF = {"E": 50e6, "nu": 0.25, "thickness": 5.0}
VLASOV = {"kind": "vlasov", "layers": [SOFT, STIFF]}


def model(**changes: Any) -> Model:
    """Return a slab of 12 x 8 m on two layers."""
    given: dict[str, Any] = {
        "plate": {"length_x": 12, "length_y": 8, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        "ground": VLASOV,
        "loads": [{"kind": "uniform", "q": 1e4}],
    }
    return Model(**given | changes)


@pytest.mark.parametrize(
    "ground",
    [
        VLASOV,
        {"kind": "layered", "coupling": "consistent", "layers": [SOFT | {"sublayers": 4}, STIFF]},
        {"kind": "continuum", "layers": [SOFT, STIFF]},
        {"kind": "constrained modulus", "layers": [SOFT, STIFF]},
    ],
)
def test_layers_are_the_same_whatever_the_kind(ground: dict[str, Any]) -> None:
    """All kinds that have layers of soil give the same continuum and the same ground of Vlasov's."""
    soil = find_soil(model(ground=ground))
    assert on_continuum(model(ground=ground), soil).ground == Continuum(layers=[SOFT, STIFF])
    assert FROM_SOIL["vlasov"](soil) == Vlasov(layers=[SOFT, STIFF])


def test_ground_of_constrained_moduli_keeps_its_rules() -> None:
    """Relief and reloading of the case stand in the ground of that kind, not in the others."""
    given = model(ground={"kind": "constrained modulus", "layers": [SOFT], "relief": 2e4, "reloading": 4.0})
    assert FROM_SOIL["constrained modulus"](find_soil(given)) == given.ground
    assert on_continuum(given, find_soil(given)).ground == Continuum(layers=[SOFT])


def test_a_half_space_is_cut_off_where_a_base_is_needed() -> None:
    """Vlasov's ground ends twice the shorter side, 16 m, below the layers; a note says so."""
    given = model(ground={"kind": "continuum", "layers": [SOFT], "half_space": {"E": 80e6, "nu": 0.2}})
    soil = find_soil(given)
    assert FROM_SOIL["vlasov"](soil) == Vlasov(layers=[SOFT, {"E": 80e6, "nu": 0.2, "thickness": 16.0}])
    assert on_continuum(given, soil).ground == given.ground
    assert any("16 m" in note for note in soil.notes)


def test_of_boreholes_the_nearest_to_the_middle_counts() -> None:
    """Its layers are everywhere, and a note names it."""
    holes = [{"name": "B1", "x": -6, "y": 0, "layers": [SOFT, STIFF]}, {"x": 1, "y": 1, "layers": [STIFF, SOFT]}]
    soil = find_soil(model(boreholes=holes))
    assert [layer.E for layer in soil.layers] == [50e6, 10e6]
    assert "boreholes[2]" in soil.notes[0]
    assert on_continuum(model(boreholes=holes), soil).boreholes == ()


@pytest.mark.parametrize(
    "ground",
    [
        {"kind": "winkler", "k": 2e7},
        {"kind": "pasternak", "k0": 2e7, "k1": 1e7},
        {"kind": "layered", "coupling": "interface", "layers": [{"k0": 2e7, "k1": 1e7}]},
    ],
)
def test_ground_without_layers_of_soil_is_refused(ground: dict[str, Any]) -> None:
    """From springs no continuum follows."""
    with pytest.raises(InputError, match="layers given by E, nu and thickness"):
        find_soil(model(ground=ground))


def test_zones_of_soil_are_refused() -> None:
    """A continuum has the same layers everywhere."""
    zone = {"shape": {"kind": "rectangle", "x": (0, 6), "y": (-4, 4)}, "ground": VLASOV}
    with pytest.raises(InputError, match="soil_zones"):
        find_soil(model(soil_zones=[zone]))


def test_a_layer_too_thin_for_a_continuum_is_named_as_in_the_case() -> None:
    """The issue has the place that the layer has in the file."""
    given = model(ground={"kind": "vlasov", "layers": [SOFT | {"thickness": 0.001}, STIFF]})
    with pytest.raises(InputError, match=r"ground\.layers\[1\]\.thickness"):
        on_continuum(given, find_soil(given))


def test_loads_beside_the_plate_are_left_out_on_springs() -> None:
    """They have no effect there; a note says so."""
    beside = {"kind": "patch", "q": 5e4, "x": (7, 10), "y": (-4, 4), "on": "ground"}
    given = model(loads=[{"kind": "uniform", "q": 1e4}, beside], beyond={"kind": "infinite"})
    assert any("Loads off the plate" in note for note in find_soil(given).notes)
    assert len(on_ground(given, Winkler(k=2e7)).loads) == 1
    assert len(on_ground(given, Vlasov(layers=[SOFT])).loads) == 2
