"""Differences of two results in plan: hand values on other meshes, a scale with zero in its middle, errors."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.text import Text

import groundslab
from groundslab.errors import InputError
from groundslab.results.results import Results
from groundslab.views.plots.panels import build_panels, shared_scales, subtract
from groundslab.views.plots.request import PlotRequest, parse_request

CASE = """
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "300 mm"
E = "30 GPa"
nu = 0.2

[ground]
kind = "winkler"
k = "20 MPa/m"

[[cases]]
name = "G"

[[cases]]
name = "Q"

[[loads]]
kind = "uniform"
case = "G"
q = "10 kPa"

[[loads]]
kind = "uniform"
case = "Q"
q = "4 kPa"

[[combinations]]
name = "dead"
limit_state = "characteristic"
factors = {G = 1.0}

[[combinations]]
name = "all"
limit_state = "characteristic"
factors = {G = 1.0, Q = 1.0}

[mesh]
size = "1 m"
"""


def solved(tmp_path: Path, *changes: tuple[str, str]) -> Results:
    """Return the results of the case with some words replaced."""
    text = CASE
    for old, new in changes:
        text = text.replace(old, new)
    path = tmp_path / "case.toml"
    path.write_text(text)
    return groundslab.solve(groundslab.load(path))


def request_of(results: Results, *fields: str, combination: str | None = "dead") -> PlotRequest:
    """Return a request for plans of some fields."""
    return parse_request(results, fields, None, combination, None, None)


def test_a_uniform_load_settles_by_q_over_k_on_any_two_meshes(tmp_path: Path) -> None:
    """W = q / k: 10 kPa on 20 MPa/m is 0.5 mm, on 40 MPa/m of another mesh 0.25 mm; the difference is 0.25 mm."""
    soft = solved(tmp_path)
    stiff = solved(tmp_path, ('"20 MPa/m"', '"40 MPa/m"'), ('size = "1 m"', 'size = "0.7 m"'))
    (panel,) = build_panels(subtract(request_of(soft, "settlement"), stiff))
    assert panel.values == pytest.approx(np.full(len(panel.nodes), 0.25), abs=1e-9)
    assert panel.source == "dead minus dead"


def test_combinations_of_one_run_are_subtracted(tmp_path: Path) -> None:
    """4 kPa more on 20 MPa/m settle 0.2 mm more and press 4 kPa more; levels are symmetric about zero."""
    results = solved(tmp_path)
    request = subtract(request_of(results, "settlement", "pressure", combination="all"), results["dead"])
    settlement, pressure = build_panels(request)
    assert settlement.values == pytest.approx(np.full(len(settlement.nodes), 0.2), abs=1e-9)
    assert pressure.values == pytest.approx(np.full(len(pressure.nodes), 4.0), abs=1e-7)
    for scale in shared_scales([settlement, pressure]).values():
        assert scale.levels == pytest.approx(-scale.levels[::-1])
        assert scale.parts_at == 0


def test_a_field_that_is_quadratic_in_each_direction_is_met_on_the_other_mesh(tmp_path: Path) -> None:
    """A settlement of x^2 y / 1000 put at the other mesh's nodes is subtracted as it is: nine nodes hold it exactly."""
    results = solved(tmp_path)
    other = solved(tmp_path, ('size = "1 m"', 'size = "0.7 m"'))["dead"]
    x, y = other.plate.nodes.T
    shaped = replace(other, plate=replace(other.plate, settlement=x**2 * y / 1000))
    (panel,) = build_panels(subtract(request_of(results, "settlement"), shaped))
    x, y = panel.nodes.T
    assert panel.values == pytest.approx(0.5 - x**2 * y, abs=1e-9)


def test_what_cannot_be_subtracted_is_said(tmp_path: Path) -> None:
    """A smaller plate, another kind, an envelope, and a combination that the other results do not have."""
    results = solved(tmp_path)
    small = solved(tmp_path, ('length_x = "6 m"', 'length_x = "5 m"'))
    with pytest.raises(InputError, match="a point on the plate to be subtracted"):
        build_panels(subtract(request_of(results, "settlement"), small))
    with pytest.raises(InputError, match='kind is "deformed"'):
        subtract(parse_request(results, ["settlement"], "deformed", None, None, None), small)
    with pytest.raises(InputError, match="an envelope is drawn"):
        subtract(parse_request(results, ["settlement"], None, None, "characteristic", None), small)
    renamed = solved(tmp_path, ('name = "dead"', 'name = "own"'))
    with pytest.raises(InputError, match='no results of "dead"'):
        subtract(request_of(results, "settlement"), renamed)


def test_a_difference_is_drawn(tmp_path: Path) -> None:
    """The figure says what is subtracted from what."""
    results = solved(tmp_path)
    figure = results.plot("settlement", combination="all", minus=results["dead"], to=tmp_path / "difference.svg")
    words = [text.get_text() for text in figure.findobj(Text)]
    assert any("all minus dead" in each for each in words)
