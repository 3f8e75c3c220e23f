"""Scenes of differences: the values that a plot of the same difference has, what is subtracted, and errors."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.arrays import Array
from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.views.plots.panels import build_panels, subtract
from groundslab.views.plots.request import parse_request
from groundslab.views.scene.binary import TYPES, Scene
from groundslab.views.scene.difference import difference_of
from helpers.small_case import TEXT

CASE = (
    TEXT.replace('q = "10 kPa"', 'q = "10 kPa"\ncase = "G"')
    + """
[[cases]]
name = "G"

[[cases]]
name = "Q"

[[loads]]
kind = "point"
case = "Q"
P = "100 kN"
x = "1 m"
y = "0.5 m"

[[combinations]]
name = "dead"
factors = {G = 1.0}

[[combinations]]
name = "all"
factors = {G = 1.0, Q = 1.0}
"""
)


@pytest.fixture(scope="module")
def solved() -> gs.Results:
    """Results of two combinations."""
    return gs.solve(casefile.loads(CASE))


def values_of(scene: Scene, combination: str, field: str) -> Array:
    """Return the values of a field that a scene has."""
    found: dict[str, Any] = next(each for each in scene.head["combinations"] if each["name"] == combination)
    block = found["values"][field]
    raw = np.frombuffer(scene.data, TYPES[block["type"]], np.prod(block["shape"]), block["offset"])
    return block["scale"] * raw.astype(float) + block["shift"]


@pytest.mark.parametrize("field", ["settlement", "moment_x", "m_1", "bottom_x"])
def test_a_combination_is_subtracted_as_a_plot_does(solved: gs.Results, field: str) -> None:
    """The values are those of the panel, but for the 2^16 levels; a combination minus itself is zero."""
    scene = difference_of(solved, solved["dead"])
    (panel,) = build_panels(subtract(parse_request(solved, [field], None, "all", None, None), solved["dead"]))
    level = np.ptp(panel.values) / 2**16
    assert values_of(scene, "all", field) == pytest.approx(panel.values, abs=level)
    assert not values_of(scene, "dead", field).any()
    assert [each["minus"] for each in scene.head["combinations"]] == ["dead", "dead"]
    assert scene.head["difference"] == "combination"
    assert all(about["signed"] for about in scene.head["fields"])


@pytest.mark.slow
def test_other_results_on_another_mesh_are_subtracted_by_the_names_of_combinations(solved: gs.Results) -> None:
    """The values are those of the panel; a combination that the others lack has none, no common one is an error."""
    text = CASE.replace('name = "dead"', 'name = "own"').replace("[4, 3]", "[5, 5]")
    other = gs.solve(casefile.loads(text))
    assert len(other["all"].plate.nodes) != len(solved["all"].plate.nodes)
    scene = difference_of(solved, other)
    (panel,) = build_panels(subtract(parse_request(solved, ["moment_y"], None, "all", None, None), other))
    level = np.ptp(panel.values) / 2**16
    assert values_of(scene, "all", "moment_y") == pytest.approx(panel.values, abs=level)
    lacking = scene.head["combinations"][0]
    assert (lacking["name"], lacking["values"], lacking["minus"]) == ("dead", None, None)
    assert scene.head["difference"] == "reference"
    renamed = gs.solve(casefile.loads(text.replace('name = "all"', 'name = "both"')))
    with pytest.raises(InputError, match="a combination that both have"):
        difference_of(solved, renamed)


def test_every_field_of_a_difference_has_a_symbol(solved: gs.Results) -> None:
    """Design moments too, which tables name without one; pictures have nothing else to call them by."""
    symbols = {field["name"]: field["symbol"] for field in difference_of(solved, solved["dead"]).head["fields"]}
    assert all(symbols.values())
    assert symbols["bottom_x"] == "m_x bottom"
