"""Checks with zones of further bars: where zones cover all, as with closer bars; else with what lies at the place."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from groundslab.design.bars.required_bars import bar_fields, largest_areas, required_areas
from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.codes.en1992_2004 import cracking
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.rules.combinations import ultimate_results
from groundslab.model.model import Model
from groundslab.results.fields import BAR_FIELDS
from groundslab.results.results import Results
from groundslab.views.tables.envelopes import fields_of_envelope
from helpers import synthetic
from helpers.synthetic import LENGTH_X, LENGTH_Y

LAYERS = ("bottom_x", "bottom_y", "top_x", "top_y")
ALL = {"kind": "rectangle", "x": (-5, 5), "y": (-4, 4)}
RIGHT = {"kind": "rectangle", "x": (0, 5), "y": (-4, 4)}
AREA = np.pi * 0.012**2 / 4 / 0.15


def results(m_x: float, spacing: float = 0.15, zones: Any = (), diameter: float = 0.012, **changes: Any) -> Results:
    """Return results of a slab of 300 mm under one even moment m_x [N m/m], with a column and shear forces."""
    bars = {"diameter": diameter, "spacing": spacing}
    model = Model(
        plate={"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        columns=[{"name": "C1", "x": 0, "y": 0, "width_x": 0.3, "width_y": 0.3}],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "P": 400e3, "column": "C1", "case": "G"}],
        combinations=[
            {"name": "ULS", "factors": {"G": 1.35}},
            {"name": "QP", "limit_state": "quasi-permanent", "factors": {"G": 1.0}},
        ],
        reinforcement={"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.046, 0.058), "top": (0.046, 0.058), "w_max": 3e-4,
                       **dict.fromkeys(LAYERS, bars), "zones": zones, **changes},
    )  # fmt: skip
    made = {}
    for each in model.combinations:
        one = synthetic.results(6, model=model, combination=each.name, limit_state=each.limit_state,
                                factors=each.factors)  # fmt: skip
        flat = np.zeros(len(one.plate.nodes))
        fields = {"moment_x": flat + m_x, "moment_y": flat, "moment_xy": flat, "pressure": flat, "shear_x": flat + 5e4}
        thickness = np.full_like(one.elements.thickness, 0.3)
        made[each.name] = replace(
            one, plate=replace(one.plate, **fields), elements=replace(one.elements, thickness=thickness)
        )
    return Results(model, model.combinations, made, {})


def zone(shape: dict[str, Any], diameter: float = 0.012, layers: Any = LAYERS) -> dict[str, Any]:
    """Return a zone of bars 150 mm apart."""
    return {"name": "Z", "shape": shape, "layers": layers, "diameter": diameter, "spacing": 0.15}


def checks(of: Results) -> dict[str, DesignCheck]:
    """Return the checks by name."""
    return {each.name: each for each in check_design(of).checks}


def test_a_zone_over_all_is_as_closer_bars() -> None:
    """20/150 and 20/150 between them are 20/75: bending, shear, punching, cracks are the same, not as without."""
    twice = checks(results(60e3, zones=[zone(ALL, 0.02)], diameter=0.02))
    closer = checks(results(60e3, spacing=0.075, diameter=0.02))
    assert set(twice) - {"anchorage of bars"} == set(closer)
    assert {"one-way shear", "punching within 2 d", "bars at the bottom x", "crack width at the bottom x"} <= set(twice)
    for name in set(closer) - {"distance of bars", "distance of bars where bent most"}:
        for part in ("demand", "resistance"):
            wanted = getattr(closer[name], part)
            assert getattr(twice[name], part) == (None if wanted is None else pytest.approx(wanted)), name
    once = checks(results(60e3, diameter=0.02))
    for name in ("one-way shear", "punching within 2 d", "bars at the bottom x"):
        assert once[name].resistance < twice[name].resistance  # type: ignore[operator]


def test_bars_fail_where_the_zone_is_not() -> None:
    """Under a moment that needs 1.5 times the base's bars all over, the half with as many again holds, the other fails.

    The worst place and what lies there are told, in the half without further bars.
    """
    of = results(115e3, zones=[zone(RIGHT)])
    check = checks(of)["bars at the bottom x"]
    assert check.status == "fails"
    assert check.resistance == pytest.approx(AREA * 1e4)
    assert check.place is not None
    assert check.place[0] < 0
    used = bar_fields(of)["utilization_bottom_x"]
    right = of.results["ULS"].plate.nodes[:, 0] >= 0
    assert used[right].max() < 1 < used[~right].min()
    assert checks(results(115e3, zones=[zone(ALL)]))["bars at the bottom x"].status == "no failure found"


def test_cracks_between_bars_of_two_diameters() -> None:
    """12/150 and 16/150: one diameter 7.12, the area of both, the cover of that diameter; as crack_width has it."""
    phi = (0.012**2 + 0.016**2) / (0.012 + 0.016)
    both = AREA + np.pi * 0.016**2 / 4 / 0.15
    bars = cracking.Bars(phi, 0.15, 0.046 - phi / 2, np.array([both]))
    width = float(cracking.crack_width(np.array([60e3]), np.array([0.3]), bars, Concrete(30e6), Steel(500e6))[0])
    found = checks(results(60e3, zones=[zone(ALL, 0.016)]))["crack width at the bottom x"]
    assert found.demand == pytest.approx(1e3 * width)
    # by hand: sigma_s of the cracked section, s_r,max = 3.4 c + 0.17 phi / rho
    d, alpha = 0.254, 200e9 / Concrete(30e6).E_cm
    x = -alpha * both + np.sqrt((alpha * both) ** 2 + 2 * alpha * both * d)
    sigma = 60e3 / (both * (d - x / 3))
    rho = both / min(2.5 * 0.046, (0.3 - x) / 3, 0.15)
    strain = max(sigma - 0.4 * Concrete(30e6).f_ctm / rho * (1 + alpha * rho), 0.6 * sigma) / 200e9
    assert width == pytest.approx((3.4 * (0.046 - phi / 2) + 0.17 * phi / rho) * strain)


def test_distance_of_bars_where_zones_lie_between() -> None:
    """500 mm apart fails (9.3.1.1(3)); with a zone of 150 mm over all it holds, over half of it not."""
    for shape, status in ((None, "fails"), (RIGHT, "fails"), (ALL, "no failure found")):
        zones = [] if shape is None else [zone(shape)]
        assert checks(results(1e3, spacing=0.5, zones=zones))["distance of bars"].status == status


def test_fields_of_bars() -> None:
    """Required is the table's, provided as laid, utilization their ratio, missing the difference, not below zero."""
    of = results(115e3, zones=[zone(RIGHT, layers=["bottom_x"])])
    fields = bar_fields(of)
    assert set(fields) == set(BAR_FIELDS)
    steel = of.model.reinforcement
    assert steel is not None
    right = of.results["ULS"].plate.nodes[:, 0] >= 0
    required = largest_areas(required_areas(steel, ultimate_results(of)), "bottom_x")[0]
    assert np.array_equal(fields["required_bottom_x"], required)
    assert fields["provided_bottom_x"] == pytest.approx(np.where(right, 2 * AREA, AREA))
    assert fields["utilization_bottom_x"] * fields["provided_bottom_x"] == pytest.approx(required)
    assert fields["missing_bottom_x"] == pytest.approx(np.where(right, 0.0, required - AREA))
    assert fields["provided_top_y"] == pytest.approx(AREA)
    shown = fields_of_envelope(of)
    assert shown["provided area bottom x [cm2/m]"] == pytest.approx(fields["provided_bottom_x"] * 1e4)
    assert shown["utilization bottom x [%]"] == pytest.approx(fields["utilization_bottom_x"] * 100)
    assert shown["missing area top y [cm2/m]"] == pytest.approx(0.0)


def test_fields_without_bars_that_are_laid() -> None:
    """Only what is required is there; in a model without reinforcement nothing."""
    of = results(60e3, **dict.fromkeys(LAYERS), w_max=None)
    assert set(bar_fields(of)) == {f"required_{layer}" for layer in LAYERS}
    assert bar_fields(replace(of, model=of.model.replace(reinforcement=None))) == {}


def test_cover_of_thicker_bars_in_zones() -> None:
    """Cover of 35 mm to bars of 12 mm: their axis at 41 mm; bars of 25 mm there have 28.5 mm, 25 + 10 mm are due."""
    given = {"bottom": None, "top": None, "cover": (0.035, 0.035), "exposure": "XC1"}
    found = checks(results(1e3, **given))["cover"]
    assert (found.status, found.demand, found.resistance) == ("no failure found", pytest.approx(35), pytest.approx(25))
    thick = checks(results(1e3, zones=[zone(RIGHT, 0.025, ["bottom_x"])], **given))["cover"]
    assert (thick.status, thick.of) == ("fails", "bottom x")
    assert (thick.demand, thick.resistance) == (pytest.approx(28.5), pytest.approx(35))


def test_axes_by_cover_and_a_mesh() -> None:
    """Q335A, 8 mm, outer along x with 35 mm of cover: axes at 39 and 47 mm."""
    bare = dict.fromkeys(LAYERS)
    meshes = {"bottom_mesh": "Q335A", "top_mesh": "Q335A", "bottom": None, "top": None, "cover": (0.035, 0.035)}
    steel = results(1e3, **bare, **meshes).model.reinforcement
    assert steel is not None
    assert steel.bottom_axes == pytest.approx((0.039, 0.047))
