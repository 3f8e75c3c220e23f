"""What an elastic continuum may be, and that each broken rule is reported with its place, all at once."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab.errors import InputError
from groundslab.model.model import Model

LAYER = {"E": "20 MPa", "nu": 0.3, "thickness": "2 m"}
HALF_SPACE = {"E": "60 MPa", "nu": 0.3}
PLATE = {"length_x": "6 m", "length_y": "4 m", "thickness": "0.25 m", "E": "30 GPa", "nu": 0.2}
UNIFORM = {"kind": "uniform", "q": "10 kPa"}


def model_of(ground: dict[str, Any], **changes: Any) -> Model:
    """Return the Model of a file with a continuum."""
    data = {"plate": PLATE, "ground": {"kind": "continuum", **ground}, "loads": [UNIFORM], **changes}
    return Model.model_validate(data, from_file=True)


def issues(ground: dict[str, Any], **changes: Any) -> list[tuple[str, str, str]]:
    """Return where issues are, what was found and what is expected."""
    with pytest.raises(InputError) as error:
        model_of(ground, **changes)
    return [(issue.location, issue.found, issue.expected) for issue in error.value.issues]


@pytest.mark.parametrize(
    "ground",
    [
        {"layers": [LAYER]},
        {"half_space": HALF_SPACE},
        {"layers": [LAYER, {**LAYER, "nu": 0.0}], "half_space": HALF_SPACE},
        {"layers": [{**LAYER, "E_bottom": "40 MPa", "variation": "quadratic"}]},
        {"layers": [LAYER, {**LAYER, "thickness": "2001 mm"}, {**LAYER, "thickness": "4.1 mm"}]},
        {"layers": [{**LAYER, "E": "0.0601 MPa"}], "half_space": {"E": "60000 MPa", "nu": 0.499}},
    ],
)
def test_what_a_continuum_may_be(ground):
    """Layers, a half-space or both; up to the limits of contrast, thickness and Poisson's ratio."""
    assert model_of(ground).ground.kind == "continuum"


@pytest.mark.parametrize("nu", [0.5, 0.7, -0.1])
def test_poisson_ratio(nu):
    """Incompressible soil has no finite constrained modulus; both places are named."""
    found = issues({"layers": [{**LAYER, "nu": nu}], "half_space": {**HALF_SPACE, "nu": nu}})
    assert [each[0] for each in found] == ["ground.layers[1].nu", "ground.half_space.nu"]
    assert [each[1] for each in found] == [str(nu)] * 2


def test_nothing_below():
    """Neither layers nor half-space."""
    assert issues({}) == [("ground", "neither layers nor half_space", "at least one of them")]
    assert issues({"layers": []}) == [("ground", "neither layers nor half_space", "at least one of them")]


def test_a_layer_like_a_sheet():
    """Thinner than a thousandth of all layers."""
    thin = {**LAYER, "thickness": "3.9 mm"}
    found = issues({"layers": [LAYER, thin, LAYER]})
    assert found == [
        ("ground.layers[2].thickness", "0.0039 m", "at least 0.004 m, a thousandth of the depth of all layers")
    ]


@pytest.mark.parametrize(
    "ground",
    [
        {"layers": [{**LAYER, "E": "0.05 MPa"}], "half_space": {"E": "60000 MPa", "nu": 0.3}},
        {"layers": [{**LAYER, "E": "0.05 MPa", "E_bottom": "60000 MPa"}]},
        {"layers": [{**LAYER, "E": "60000 MPa"}, LAYER, {**LAYER, "E": "0.05 MPa"}]},
    ],
)
def test_a_contrast_above_a_million(ground):
    """Wherever the stiffest and the softest soil are."""
    ((place, found, expected),) = issues(ground)
    assert (place, found) == ("ground", "moduli from 5e+04 to 6e+10 Pa")
    assert expected == "moduli that differ by a factor of at most 1e+06"


def test_moduli_and_thicknesses_are_above_zero():
    """All issues of all layers at once."""
    found = issues({"layers": [{**LAYER, "E": "0 MPa"}, {**LAYER, "thickness": "-1 m"}], "cell": "0 m"})
    assert {each[0] for each in found} == {"ground.layers[1].E", "ground.layers[2].thickness", "ground.cell"}


def test_sublayers():
    """Only consistent coupling has them."""
    assert [each[0] for each in issues({"layers": [{**LAYER, "sublayers": 2}]})] == ["ground.layers[1].sublayers"]


@pytest.mark.parametrize(
    ("beyond", "found"),
    [
        ({"kind": "margin", "width": "2 m", "edge": "fixed"}, "a margin that ends"),
        ({"kind": "margin", "width": "2 m", "sides": ["left"]}, "ground beyond some sides"),
    ],
)
def test_ground_that_ends(beyond, found):
    """A continuum goes on without an end on all sides."""
    ((place, what, expected),) = issues({"half_space": HALF_SPACE}, beyond=beyond)
    assert (place, what) == ("beyond", found)
    assert 'kind = "infinite"' in expected


def test_a_margin_says_how_much_is_shown():
    """A free margin on all sides, or an infinite one, is no more than a picture of the ground."""
    for kind in ("margin", "infinite"):
        assert model_of({"half_space": HALF_SPACE}, beyond={"kind": kind, "width": "2 m"}).beyond.width == 2.0


def test_ground_that_varies_over_the_plan():
    """Zones of other soil and boreholes are refused, both at once."""
    ground = {"kind": "continuum", "layers": [LAYER]}
    zone = {"shape": {"kind": "rectangle", "x": ["0 m", "1 m"], "y": ["0 m", "1 m"]}, "ground": ground}
    hole = {"x": "0 m", "y": "0 m", "layers": [LAYER]}
    found = issues({"layers": [LAYER]}, soil_zones=[zone], boreholes=[hole, {**hole, "x": "1 m"}])
    assert [(place, expected) for place, _, expected in found] == [
        ("soil_zones", "no such"),
        ("boreholes", "no such"),
    ]
