"""Fields of bars in pictures: one panel over all ultimate combinations; what cannot be drawn is refused."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from matplotlib.text import Text

from groundslab.design.bars.required_bars import bar_fields
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.results.fields import BAR_FIELDS
from groundslab.results.results import Results
from groundslab.views import plots
from groundslab.views.plots.panels import build_panels
from groundslab.views.plots.request import parse_request
from groundslab.views.scene.fields import scene_of
from helpers import synthetic
from helpers.scenes import values_of

BARS = {"diameter": 0.012, "spacing": 0.15}
LAID: dict[str, Any] = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), BARS)


def results(**steel: Any) -> Results:
    """Return results of two ultimate combinations, one of which has twice the moments, and a characteristic one."""
    model = Model(
        plate={"length_x": synthetic.LENGTH_X, "length_y": synthetic.LENGTH_Y, "thickness": 0.4, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "q": 1e4, "case": "G"}],
        combinations=[
            {"name": "one", "factors": {"G": 1.0}},
            {"name": "two", "factors": {"G": 2.0}},
            {"name": "SLS", "limit_state": "characteristic", "factors": {"G": 9.0}},
        ],
        reinforcement={"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.046, 0.058), "top": (0.046, 0.058), **steel},
    )
    made = {}
    for each in model.combinations:
        one = synthetic.results(4, model=model, combination=each.name, limit_state=each.limit_state,
                                factors=each.factors)  # fmt: skip
        times = dict(each.factors)["G"]
        moments = {name: times * getattr(one.plate, name) for name in ("moment_x", "moment_y", "moment_xy")}
        made[each.name] = replace(one, plate=replace(one.plate, **moments))
    return Results(model, model.combinations, made, {})


def request(of: Results, *fields: str, **options: Any) -> Any:
    """Return a request to plot fields."""
    given = {"kind": None, "combination": None, "envelope": None, "line": None} | options
    return parse_request(of, fields, **given)


def words_of(figure: Any) -> str:
    """Return all that is written in a figure."""
    return "\n".join(text.get_text() for text in figure.findobj(Text))


def test_one_panel_over_all_ultimate_combinations() -> None:
    """Beside a settlement for each combination there is one panel of each field of bars, with its values and unit."""
    of = results(**LAID)
    wanted = request(of, "settlement", "required_bottom_x", "utilization_bottom_x")
    panels = build_panels(wanted)
    assert [panel.quantity.name for panel in panels] == ["settlement"] * 3 + [
        "required_bottom_x",
        "utilization_bottom_x",
    ]
    assert panels[3].source == "All 2 ultimate combinations"
    assert panels[3].values == pytest.approx(bar_fields(of)["required_bottom_x"] * 1e4)
    assert wanted.panel_count == 5
    # of the combination with twice the moments alone it is the same, of the other one less
    alone = bar_fields(replace(of, results={"two": of.results["two"]}))
    assert np.array_equal(alone["required_bottom_x"], bar_fields(of)["required_bottom_x"])
    assert "zone of further bars" not in words_of(plots.plot(of, "provided_bottom_x"))
    shape = {"kind": "circle", "radius": 1}
    zone = {"name": "Z", "shape": shape, "layers": ["bottom_x"], "diameter": 0.02, "spacing": 0.1}
    figure = plots.plot(results(**LAID, zones=[zone]), "utilization_bottom_x", "missing_top_y")
    words = words_of(figure)
    assert words.count("zone of further bars") == 1
    assert "Utilization bottom x" in words
    assert "Missing area top y" in words


@pytest.mark.slow
def test_each_field_has_a_panel_with_its_unit() -> None:
    """All of them are drawn, with the layer beside the symbol and the unit, and a bar that covers the values."""
    of = results(**LAID)
    figure, fields = plots.plot(of, *BAR_FIELDS), bar_fields(of)
    boxes = [axes for axes in figure.axes if axes.axison]
    assert len(boxes) == len(BAR_FIELDS)
    for axes, (name, about) in zip(boxes, BAR_FIELDS.items(), strict=True):
        _, face, axis = name.split("_")
        (bar,) = axes.child_axes
        assert bar.get_ylabel().endswith(f"{face} {axis} [{about.unit}]")
        low, high = bar.get_ylim()
        values = fields[name] * about.scale
        assert low <= values.min() + 1e-9
        assert high >= values.max() - 1e-9


@pytest.mark.parametrize(
    ("steel", "fields", "options", "found"),
    [
        ({}, ["provided_bottom_x"], {}, "a field that these results have"),
        (LAID, ["required_top_x"], {"envelope": "ultimate"}, "none chosen, as it is over all ultimate combinations"),
        (LAID, ["required_top_x"], {"combination": "one"}, "none chosen, as it is over all ultimate combinations"),
        (LAID, ["required_top_x"], {"kind": "deformed"}, 'a field of combinations, as kind is "deformed"'),
        ({**LAID, "f_ck": 12e6}, ["utilization_bottom_x"], {}, "finite areas; somewhere no reinforcement is enough"),
    ],
)
def test_what_is_refused(steel: dict[str, Any], fields: list[str], options: dict[str, Any], found: str) -> None:
    """Bars that are not laid, chosen combinations, other kinds, and concrete that is too weak."""
    of = results(**steel)
    if "f_ck" in steel:
        one = of.results["two"]
        too_much = replace(one, plate=replace(one.plate, moment_x=one.plate.moment_x * 100))
        of = replace(of, results={**of.results, "two": too_much})
    with pytest.raises(InputError) as error:
        request(of, *fields, **options)
    assert found in [issue.expected for issue in error.value.issues]


def test_scene_has_them_in_every_combination() -> None:
    """What is told of bars has one block, which all combinations refer to; weak concrete leaves it out."""
    of = results(**LAID)
    scene = scene_of(of)
    names = [field["name"] for field in scene.head["fields"]]
    assert [name for name in names if name in BAR_FIELDS] == list(BAR_FIELDS)
    blocks = [each["values"]["utilization_bottom_x"] for each in scene.head["combinations"]]
    assert blocks[0] == blocks[1] == blocks[2]
    wanted = bar_fields(of)["utilization_bottom_x"] * 100
    assert values_of(scene, blocks[0]) == pytest.approx(wanted, abs=np.ptp(wanted) / 1e4)
    one = of.results["two"]
    weak = replace(one, plate=replace(one.plate, moment_x=one.plate.moment_x * 1000))
    left = [field["name"] for field in scene_of(replace(of, results={**of.results, "two": weak})).head["fields"]]
    assert "required_bottom_x" not in left
