"""Descriptions changed from Python: keys taken away, another ground put in, what lies beyond without effect."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.analysis.check import check
from groundslab.analysis.driver import solve
from groundslab.case.casefile import loads, to_toml
from groundslab.errors import InputError
from groundslab.model.ground import Layered, Pasternak, Vlasov, Winkler
from groundslab.model.loads.load_types import PointLoad
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.settings import Beyond, Contact
from groundslab.model.structure.columns import Column
from groundslab.views.summary.sections import description_of_ground

PLATE = {"length_x": 6, "length_y": 4, "thickness": 0.25, "E": 30e9, "nu": 0.2}
LAYER = {"k0": 2e7, "k1": 0}


def model(**changes: Any) -> Model:
    """Return a sound model with some parts changed."""
    parts = {
        "plate": PLATE,
        "ground": {"kind": "pasternak", "k0": 2e7, "k1": 1e7},
        "loads": [{"kind": "uniform", "q": 1e4}, {"kind": "point", "P": 1e5, "x": 2, "y": 1}],
        "mesh": {"counts": (8, 6)},
    }
    return Model(**{**parts, **changes})


def test_optional_keys_can_be_taken_away() -> None:
    """None takes away what a key holds, of text too, in every part; what is left is as if it had never been given."""
    load = PointLoad(P=1, x=0, y=0, name="n", case="a", width_x=1, width_y=1)
    assert load.replace(name=None, case=None, width_x=None, width_y=None) == PointLoad(P=1, x=0, y=0)
    assert load.replace(x=None, y=None, width_x=None, width_y=None, column="C", P=2).column == "C"
    assert Contact(gap=1e-3, limit_pressure=1e5).replace(gap=None, limit_pressure=None) == Contact()
    given = model(
        title="t", mesh={"size": 0.5}, cases=[{"name": "a"}], loads=[{"kind": "uniform", "q": 1, "case": "a"}]
    )
    bare = given.replace(title=None, mesh=None, cases=None, loads=[given.loads[0].replace(case=None)])
    assert bare == Model(plate=PLATE, ground=given.ground, loads=[{"kind": "uniform", "q": 1}])
    column = Column(name="C", x=0, y=0, diameter=1)
    assert column.replace(diameter=None, width_x=1, width_y=2) == Column(name="C", x=0, y=0, width_x=1, width_y=2)


def test_needed_keys_cannot_be_taken_away() -> None:
    """What a part needs is missing then, and said to be."""
    with pytest.raises(InputError, match=r"Plate\.thickness: found nothing"):
        Plate(**PLATE).replace(thickness=None)


WITHOUT_SHEAR = [
    Winkler(k=2e7),
    Pasternak(k0=2e7, k1=0),
    Layered(coupling="interface", layers=[{"k0": 4e7, "k1": 0}, {"k0": 4e7, "k1": 0}]),
]


@pytest.mark.slow
@pytest.mark.parametrize("ground", WITHOUT_SHEAR)
@pytest.mark.parametrize("beyond", [
    {"kind": "infinite"}, {"kind": "infinite", "width": 3}, {"kind": "margin", "width": 3},
    {"kind": "margin", "width": 3, "edge": "fixed", "sides": ["left"]},
])  # fmt: skip
def test_ground_beyond_without_shear_has_no_effect(ground: Any, beyond: dict[str, Any]) -> None:
    """Springs in rows and columns, each by itself, do not feel what lies beside them: k1 = 0 is the limit k1 -> 0."""
    known = model(ground=ground)
    changed = known.replace(beyond=beyond)
    check(changed)
    assert loads(to_toml(changed)) == changed
    found = solve(changed)
    assert found.certificate.holds
    assert np.allclose(found.plate.settlement, solve(model(ground=Winkler(k=2e7))).plate.settlement, rtol=1e-9, atol=0)
    rows = {row.key: row.value for row in description_of_ground(found.only).rows}
    assert rows["beyond"] == "no effect, as the ground carries no shear"


@pytest.mark.slow
def test_infinite_ground_tends_to_that_without_shear() -> None:
    """The smaller k1, the nearer infinite ground comes to none: what is said of k1 = 0 is the limit, not a rule."""
    wanted = solve(model(ground=Winkler(k=2e7))).plate.settlement
    off = []
    for k1 in (1e6, 1e4, 1e2):
        found = solve(model(ground=Pasternak(k0=2e7, k1=k1), beyond=Beyond(kind="infinite"))).plate.settlement
        off.append(float(np.abs(found - wanted).max() / wanted.max()))
    assert off[2] < off[1] < off[0]
    assert off[2] < 0.01


def test_another_ground_is_one_change() -> None:
    """From soil to springs and back: what lies beyond need not be changed along with the ground."""
    soil = Vlasov(layers=[{"E": 2e7, "nu": 0.3, "thickness": 3}])
    given = model(ground=soil, beyond={"kind": "infinite"})
    springs = given.replace(ground=Winkler(k=2e7))
    assert springs.replace(ground=soil) == given
    assert not springs.ground_reaches
    assert given.ground_reaches


def test_some_layers_without_shear_are_refused() -> None:
    """Beneath or beside ground that carries shear no tail is known of ground that does not."""
    layers = [{"k0": 4e7, "k1": 1e6}, {"k0": 4e7, "k1": 0}]
    with pytest.raises(InputError, match=r"ground.layers\[2\].k1: found 0 N/m"):
        model(ground={"kind": "layered", "coupling": "interface", "layers": layers}, beyond={"kind": "infinite"})
    zone = {"shape": {"kind": "circle", "radius": 1}, "ground": {"kind": "pasternak", "k0": 1e7, "k1": 0}}
    with pytest.raises(InputError, match=r"soil_zones\[1\].ground.k1: found 0 N/m"):
        model(soil_zones=[zone], beyond={"kind": "infinite"})
