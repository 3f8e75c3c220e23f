"""Loads that reach over the plate's edge or over openings: what acts, and what is said of the rest."""

from __future__ import annotations

import html
import json
import math
from pathlib import Path
from typing import Any

import pytest
import shapely
from matplotlib import pyplot

from groundslab import (
    AreaLoad,
    Circle,
    InputError,
    LineLoad,
    Mesh,
    Model,
    PatchLoad,
    Plate,
    PointLoad,
    Polygon,
    Rectangle,
    Winkler,
    solve,
)
from groundslab.case.casefile import loads
from groundslab.cli import main
from groundslab.design.demands.loads import column_loads
from groundslab.model.loads.clipping import Clipped, clip_line, find_clipped_loads
from groundslab.views.plots import symbols
from groundslab.views.scene.plan import plan_of
from groundslab.views.summary import sections

PLAIN = Plate(length_x=6, length_y=4, thickness=0.25, E=30e9, nu=0.2)
HOLED = Plate(length_x=6, length_y=4, openings=[Rectangle(x=(-1, 1), y=(-1, 1))], thickness=0.25, E=30e9, nu=0.2)
ROUND = Plate(outline=Circle(radius=3), thickness=0.25, E=30e9, nu=0.2)

#: half a lens of two circles of radius 1 whose centres are 1 apart: 2 pi / 3 - sqrt(3) / 2 is the whole of it
LENS = 2 * math.pi / 3 - math.sqrt(3) / 2

#: Plate, load, and what of it acts [N].
ACTS = {
    "patch over a side": (PLAIN, PatchLoad(q=1e3, x=(2, 5), y=(-1, 1)), 2e3),
    "patch around the plate": (PLAIN, PatchLoad(q=1e3, x=(-5, 5), y=(-5, 5)), 24e3),
    "patch over an opening": (HOLED, PatchLoad(q=1e3, x=(-2, 0.5), y=(-2, 0)), 2.5 * 2e3 - 1.5e3),
    # int of 1000 + 100 x over 2 .. 3 times 2
    "varying patch over a side": (PLAIN, PatchLoad(q=1e3, slope=(1e2, 0), x=(2, 5), y=(-1, 1)), 2 * (1e3 + 250)),
    # int of 500 x^2 over 2 .. 3 times 2
    "quadratic patch over a side": (PLAIN, PatchLoad(q=0, bend=(1e3, 0, 0), x=(2, 5), y=(-1, 1)), 1e3 * 19 / 3),
    "circle on a side": (PLAIN, AreaLoad(q=1e3, shape=Circle(centre=(3, 0), radius=1)), 500 * math.pi),
    "circle on a corner": (PLAIN, AreaLoad(q=1e3, shape=Circle(centre=(3, 2), radius=1)), 250 * math.pi),
    # the segment beyond x = 3 of a circle about 2.5: arccos(1/2) - sqrt(3)/4
    "circle over a side": (
        PLAIN,
        AreaLoad(q=1e3, shape=Circle(centre=(2.5, 0), radius=1)),
        1e3 * (math.pi - math.pi / 3 + math.sqrt(3) / 4),
    ),
    "ring on a side": (
        PLAIN,
        AreaLoad(q=1e3, shape=Circle(centre=(3, 0), radius=1.5), holes=[Circle(centre=(3, 0), radius=1)]),
        500 * math.pi * 1.25,
    ),
    "line over a side": (PLAIN, LineLoad(q=1e3, points=[(0, 0), (4, 3)]), 1e3 * 4 / 3 * math.sqrt(1 + 9 / 16) * 2),
    "varying line over a side": (PLAIN, LineLoad(q=0, q_end=1e3, points=[(1, 0), (5, 0)]), 500.0),
    "line over an opening": (HOLED, LineLoad(q=1e3, q_end=2e3, points=[(-3, 0), (3, 0)]), 4 * 1.5e3),
    "line that comes and goes": (PLAIN, LineLoad(q=1e3, points=[(0, 1), (0, 3), (1, 3), (1, 1)]), 2e3),
    # a circle about (3, 0): half of it; about (2.5, 0): less the arc of 2 arccos(1/2) beyond x = 3
    "circle line on a side": (PLAIN, LineLoad(q=1e3, shape=Circle(centre=(3, 0), radius=1)), 1e3 * math.pi),
    "circle line over a side": (
        PLAIN,
        LineLoad(q=1e3, shape=Circle(centre=(2.5, 0), radius=1)),
        1e3 * 4 * math.pi / 3,
    ),
    # an arc from (2, 0) over (3, 1) to (4, 0), q from 0 to 1000: the first half of it
    "varying arc over a side": (
        PLAIN,
        LineLoad(q=0, q_end=1e3, points=[(2, 0), (4, 0)], bulges=[-1.0]),
        math.pi / 2 * 250,
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize(("plate", "load", "acts"), ACTS.values(), ids=ACTS.keys())
def test_what_lies_on_the_plate_acts_and_the_rest_is_told(plate: Plate, load: Any, acts: float) -> None:
    """The sum of the loads of a solved plate is the part on the plate in closed form; the remark says the rest."""
    model = Model(plate=plate, ground=Winkler(k=20e6), loads=[load], contact={"tensionless": False}, mesh=Mesh(size=1))
    assert solve(model).certificate.load == pytest.approx(acts, rel=1e-6)
    (clipped,) = find_clipped_loads(plate, model.loads)
    assert clipped.drawn - clipped.force == pytest.approx(acts, rel=1e-6)
    assert 0 < clipped.share < 1


def test_circles_that_cross_a_round_plate() -> None:
    """A circle of 3 m on the edge of a round plate of 3 m: the lens of both by the formula; a third of its line."""
    circle = Circle(centre=(3, 0), radius=3)
    area, line = AreaLoad(q=1e3, shape=circle), LineLoad(q=1e3, shape=circle)
    one, two = find_clipped_loads(ROUND, (area, line))
    assert one.drawn - one.force == pytest.approx(9e3 * LENS, rel=1e-6)
    assert two.drawn - two.force == pytest.approx(1e3 * 2 * math.pi, rel=1e-9)
    model = Model(plate=ROUND, ground=Winkler(k=20e6), loads=[area, line], contact={"tensionless": False},
                  mesh=Mesh(size=0.5))  # fmt: skip
    # the elements' sides are parabolas, which miss the circle
    assert solve(model).certificate.load == pytest.approx(9e3 * LENS + 2e3 * math.pi, rel=3e-6)


@pytest.mark.parametrize(
    ("plate", "load"),
    [
        (PLAIN, PatchLoad(q=1, x=(-3, 3), y=(-2, 2))),
        (PLAIN, PatchLoad(q=1, x=(-3 - 1e-10, 3), y=(-2, 2))),
        (PLAIN, LineLoad(q=1, points=[(-3, -2), (3, -2), (3, 2)])),
        (HOLED, LineLoad(q=1, points=[(-1, -1), (1, -1), (1, 1), (-1, 1)])),
        (HOLED, LineLoad(q=1, shape=Rectangle(x=(-1, 1), y=(-1, 1)))),
        (ROUND, LineLoad(q=1, shape=Circle(radius=3))),
        (ROUND, LineLoad(q=1, points=[(-3, 0), (3, 0)])),
        (ROUND, LineLoad(q=1, points=[(-3, 0), (3, 0)], bulges=[1.0])),
        (ROUND, AreaLoad(q=1, shape=Polygon(points=[(-3, 0), (3, 0)], bulges=[1.0, 1.0]))),
    ],
)
def test_what_ends_at_the_edge_is_whole(plate: Plate, load: Any) -> None:
    """Loads up to the edge, along it, and along that of an opening are not cut; nothing is said of them."""
    assert find_clipped_loads(plate, (load,)) == ()


@pytest.mark.slow
def test_a_ring_on_the_edge_of_a_round_plate_acts_whole() -> None:
    """A wall on the edge of a tank's slab bears 2 pi R q, though elements' curved sides miss the circle a little."""
    for size in (0.3, 1.5):
        model = Model(plate=ROUND, ground=Winkler(k=20e6), loads=[LineLoad(q=1e3, shape=Circle(radius=3))],
                      mesh=Mesh(size=size))  # fmt: skip
        assert solve(model).certificate.load == pytest.approx(6e3 * math.pi, rel=1e-9)


@pytest.mark.parametrize(
    "load",
    [
        PatchLoad(q=1, x=(-0.9, 0.9), y=(-1, 1)),
        PatchLoad(q=1, x=(3, 4), y=(-1, 1)),
        AreaLoad(q=1, shape=Circle(radius=0.9)),
        AreaLoad(q=1, shape=Circle(radius=1e7)),
        LineLoad(q=1, points=[(-0.9, 0), (0.9, 0.5)]),
        LineLoad(q=1, points=[(4, 0), (4, 1)]),
        LineLoad(q=1, shape=Circle(radius=0.9)),
        LineLoad(q=1, shape=Circle(radius=20)),
    ],
)
def test_what_lies_off_the_plate_is_refused(load: Any) -> None:
    """A load wholly over an opening or beside the plate is a issue with its place; so is one far too large."""
    with pytest.raises(InputError, match=r"^loads\[1\]: found a load .*off the plate"):
        Model(plate=HOLED, ground=Winkler(k=20e6), loads=[load])


def test_a_footprint_over_the_edge_is_refused() -> None:
    """Of a force nothing may be lost, and no place on the plate is its own: the footprint must lie on the plate."""
    with pytest.raises(InputError, match=r"^loads\[1\]: found a footprint of which 25 % lies off the plate"):
        Model(plate=PLAIN, ground=Winkler(k=20e6), loads=[PointLoad(P=1, x=2.9, y=0, width_x=0.4, width_y=0.4)])


def test_remarks_name_the_load_the_share_and_the_force() -> None:
    """The remark counts loads from 1, names them, and gives share and forces in kN."""
    (clipped,) = find_clipped_loads(
        PLAIN, (PatchLoad(q=1e3, x=(0, 1), y=(0, 1)), LineLoad(name="wall", q=1e4, points=[(0, 0), (4, 0)]))
    )
    assert clipped.words() == 'loads[2] "wall": 25 % of it lies off the plate; 10 kN of 40 kN do not act'
    assert [piece.edge.end for piece in clip_line(PLAIN, LineLoad(q=1e4, points=[(0, 0), (4, 0)]).acts[0])] == [
        (3.0, 0.0)
    ]


CASE = """
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "250 mm"
E = "30 GPa"
nu = 0.2
[ground]
kind = "winkler"
k = "20 MPa/m"
[mesh]
size = "1 m"
[[loads]]
kind = "uniform"
q = "10 kPa"
[[loads]]
kind = "patch"
name = "rack"
q = "10 kPa"
x = ["2 m", "4 m"]
y = ["-1 m", "1 m"]
"""


def test_words_have_one_unit() -> None:
    """A little of much is told in the unit of both: 0.25 of 30 kNm, not 250 N m."""
    clipped = Clipped(2, "", "", 0.25 / 30, 250.0, 30e3, "off the plate", "moment")
    assert clipped.words() == "loads[2]: 0.833 % of it lies off the plate; 0.25 kNm of 30 kNm do not act"


REMARK = 'loads[2] "rack": 50 % of it lies off the plate; 20 kN of 40 kN do not act'


def test_check_tells_what_does_not_act(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Check calls the case fine and remarks how much of the load is cut off."""
    file = tmp_path / "case.toml"
    file.write_text(CASE)
    assert main.main(["check", str(file)]) == 0
    assert f"  remark: {REMARK}" in capsys.readouterr().out.splitlines()


@pytest.mark.slow
@pytest.mark.parametrize("combinations", [1, 2])
def test_summary_and_report_tell_what_does_not_act(tmp_path: Path, combinations: int) -> None:
    """Text, JSON and report give share and force of what is cut off; the sum of the loads is what acts, 240 + 20 kN."""
    text = CASE
    if combinations == 2:
        text = text.replace("[[loads]]\n", '[[loads]]\ncase = "G"\n') + (
            '[[cases]]\nname = "G"\naction = "permanent"\n'
            '[[combinations]]\nname = "one"\nfactors = {G = 1.0}\n[[combinations]]\nname = "two"\nfactors = {G = 1.5}\n'
        )
    (tmp_path / "case.toml").write_text(text)
    assert main.main(["solve", str(tmp_path / "case.toml"), "--out", str(tmp_path / "out"), "--quiet"]) == 0
    reported = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert reported["cut_loads"]["share_2"] == pytest.approx(0.5)
    assert reported["cut_loads"]["force_2"] == {"value": pytest.approx(20e3), "unit": "N"}
    assert reported["cut_loads"]["sum_of_forces"]["value"] == pytest.approx(20e3)
    if combinations == 1:
        assert reported["certificate"]["load"]["value"] == pytest.approx(260e3)
        table = (tmp_path / "out" / "tables" / "combinations.csv").read_text()
        assert ",260" in table.splitlines()[-1]
    assert main.main(["report", str(tmp_path / "out")]) == 0
    assert REMARK in html.unescape((tmp_path / "out.html").read_text())


def test_the_summary_on_the_terminal_has_a_section_of_what_is_cut_off() -> None:
    """The lines give share and force of each load; without any such load there is no section."""
    model = loads(CASE)
    section = next(each for each in sections.summary(solve(model).only) if each.key == "cut_loads")
    assert [(row.label, row.value) for row in section.rows] == [
        ("loads[2] rack, off the plate", pytest.approx(0.5)),
        ("loads[2] rack, without effect", pytest.approx(20e3)),
        ("total without effect", pytest.approx(20e3)),
    ]
    assert sections.cut_loads(model.replace(loads=model.loads[:1])) == []


CURVED = Model(
    plate=Plate(length_x=6, length_y=4, thickness=0.25, E=30e9, nu=0.2),
    ground=Winkler(k=20e6),
    loads=[
        LineLoad(q=1e4, points=[(-1, 0), (1, 0)], bulges=[-1.0]),
        LineLoad(q=1e4, shape=Circle(radius=1.5)),
        AreaLoad(q=1e4, shape=Circle(radius=1.5), holes=[Circle(radius=1)]),
    ],
)


def test_arcs_and_holes_are_drawn() -> None:
    """The plan for browsers and reports follows arcs, closes rings and cuts holes; figures draw them, too."""
    arc, ring, area = plan_of(CURVED)["loads"]
    assert max(y for _, y in arc["points"]) == pytest.approx(1, abs=0.02)
    assert ring["points"][0] == ring["points"][-1] == [1.5, 0.0]
    assert max(y for _, y in area["holes"][0]) == pytest.approx(1, abs=0.02)
    _, axes = pyplot.subplots()
    entries = symbols.draw_loads(axes, CURVED, lambda _: True)
    assert set(entries) == {"line load", "loaded area"}
    assert max(line.get_ydata().max() for line in axes.lines) == pytest.approx(1.5, abs=0.02)
    assert len(axes.patches) == 2
    pyplot.close()


def test_loads_around_a_column_are_those_on_the_plate() -> None:
    """Of a ring on the edge, that inside a circle of 1 m about the edge: the chord's arc and lens in closed form."""
    loaded = CURVED.replace(
        loads=[
            LineLoad(q=1e3, shape=Circle(centre=(3, 0), radius=1)),
            AreaLoad(q=1e3, shape=Circle(centre=(3, 0), radius=1)),
        ]
    )
    results = solve(loaded.replace(mesh=Mesh(size=0.5), contact={"tensionless": False})).only
    part = shapely.box(2, 0, 3, 2)
    force = column_loads.sum_of_others(results, part, ())
    assert force[""] == pytest.approx(1e3 * (math.pi / 2 + math.pi / 4), rel=1e-6)
