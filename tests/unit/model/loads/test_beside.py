"""Loads on the ground beside the plate: which are refused, and what of them acts."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab import InputError, Model
from groundslab.case import casefile
from groundslab.model.loads.beside import distances_beyond
from groundslab.model.loads.clipping import find_clipped_loads

PASTERNAK = {"kind": "pasternak", "k0": 2e7, "k1": 1e7}
NO_SHEAR = {
    "winkler": {"kind": "winkler", "k": 2e7},
    "pasternak": {"kind": "pasternak", "k0": 2e7, "k1": 0.0},
    "layered": {"kind": "layered", "coupling": "interface", "layers": [{"k0": 2e7, "k1": 0.0}] * 2},
}


def model(*loads: dict[str, Any], **changes: object) -> Model:
    """Return a plate of 6 m by 4 m on infinite ground, with its weight and loads on the ground."""
    parts = {
        "plate": {"length_x": 6.0, "length_y": 4.0, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        "ground": PASTERNAK,
        "beyond": {"kind": "infinite"},
        "loads": [
            {"kind": "self weight", "unit_weight": 25e3},
            *({"on": "ground", "q": 1e4, **each} for each in loads),
        ],
    }
    return Model.model_validate(parts | changes)


def patch(x: tuple[float, float], y: tuple[float, float] = (-1, 1)) -> dict[str, Any]:
    """Return a pressure on a rectangle."""
    return {"kind": "patch", "x": x, "y": y}


CIRCLE = {"kind": "area", "shape": {"kind": "circle", "centre": (5, 0), "radius": 1}}


@pytest.mark.parametrize("kind", NO_SHEAR)
def test_no_effect_without_shear(kind: str) -> None:
    """A load beside the plate on ground that carries no shear is an error, on each of two loads."""
    with pytest.raises(InputError) as refused:
        model(patch((4, 5)), CIRCLE, ground=NO_SHEAR[kind])
    assert [issue.location for issue in refused.value.issues] == ["loads[2].on", "loads[3].on"]
    assert refused.value.issues[0].found == '"ground" on ground without shear'
    assert "no effect" in refused.value.issues[0].hint


@pytest.mark.parametrize(
    ("load", "beyond", "location", "words"),
    [
        (patch((4, 5)), {"kind": "none"}, "loads[2].on", "ends with the plate"),
        (patch((4, 5)), {"kind": "margin", "width": 1.5}, "loads[2]", "2 m beyond the plate's right side"),
        (patch((4, 5)), {"kind": "infinite", "sides": ["left"]}, "loads[2]", "at most 0 m, where the ground ends"),
        (patch((4, 200)), {"kind": "infinite"}, "loads[2]", "at most 120 m"),
        (patch((-1, 1), (-300, 0)), {"kind": "infinite"}, "loads[2]", "298 m beyond the plate's bottom side"),
        (patch((-3, 3), (-2, 2)), {"kind": "infinite"}, "loads[2]", "lies under the plate"),
    ],
)
def test_where_there_is_no_ground(load: dict[str, Any], beyond: dict[str, Any], location: str, words: str) -> None:
    """A load on ground that ends before it, that is far away, or under the plate is an error."""
    with pytest.raises(InputError) as refused:
        model(load, beyond=beyond)
    (issue,) = refused.value.issues
    assert issue.location == location
    assert words in str(issue)


@pytest.mark.parametrize("load", [patch((4, 5)), patch((3, 4.5)), CIRCLE])
def test_accepted_and_written(load: dict[str, Any]) -> None:
    """A load on a margin that reaches as far is accepted, and written to a file that says the same."""
    accepted = model(load, beyond={"kind": "margin", "width": 3.0})
    assert casefile.loads(casefile.to_toml(accepted)) == accepted
    assert 'on = "ground"' in casefile.to_toml(accepted)


def test_what_lies_under_the_plate_does_not_act() -> None:
    """Of a load from 2 m on the plate to 2 m beside it a half does not act, and is reported."""
    (clipped,) = find_clipped_loads(*[getattr(model(patch((1, 5))), name) for name in ("plate", "loads")])
    assert (clipped.share, clipped.force, clipped.drawn) == pytest.approx((0.5, 4e4, 8e4))
    assert clipped.words() == "loads[2]: 50 % of it lies under the plate; 40 kN of 80 kN do not act"


def test_distances() -> None:
    """How far loads on the ground reach beyond each side; those on the plate do not count."""
    found = model(patch((4, 5), (-7, 1)), CIRCLE)
    assert distances_beyond(found.plate, found.loads) == {"left": -7.0, "right": 3.0, "bottom": 5.0, "top": -1.0}
    assert set(distances_beyond(found.plate, found.loads[:1]).values()) == {0.0}
