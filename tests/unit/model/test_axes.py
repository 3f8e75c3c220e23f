"""Axes of a building: where they are and cross, what is attached to them, and which references are refused."""

from __future__ import annotations

import math
from typing import Any

import pytest

from groundslab import (
    Column,
    InputError,
    LineLoad,
    Model,
    Plate,
    PointLoad,
    PointSupport,
    Wall,
    Winkler,
)
from groundslab.analysis.driver import solve
from groundslab.case import casefile
from groundslab.model.axes.crossings import name_of_crossing
from groundslab.model.axes.drawn import drawn_axes
from groundslab.model.axes.families import RayAxes, RingAxes, StraightAxes, count_on, crossings
from groundslab.model.plan_origin import move_to_center
from groundslab.schema.base import Section
from groundslab.views.tables.structure.columns import column_table

LETTERS = {"kind": "straight", "first": "A", "distances": "2 x 6 m, 4.5 m"}
NUMBERS = {"kind": "straight", "first": "1", "distances": "5 m, 7 m", "angle": 90}
SIZE = {"width_x": "400 mm", "width_y": "400 mm"}


def tables(**parts: Any) -> dict[str, Any]:
    """Return the tables of a raft with axes A to D and 1 to 3, as a file has them."""
    usual = {
        "plate": {
            "outline": {"kind": "rectangle", "x": ["-1 m", "18 m"], "y": ["-1 m", "13 m"]},
            "thickness": "500 mm",
            "E": "30 GPa",
            "nu": 0.2,
        },
        "axes": [LETTERS, NUMBERS],
        "ground": {"kind": "winkler", "k": "20 MPa/m"},
        "loads": [{"kind": "uniform", "q": "5 kPa"}],
    }
    return usual | parts


def read(**parts: Any) -> Model:
    """Return the raft as it is read from a file."""
    return casefile.from_table(tables(**parts))


@pytest.mark.parametrize(
    ("first", "names"),
    [
        ("A", ("A", "B", "C")),
        ("Y", ("Y", "Z", "AA")),
        ("a", ("a", "b", "c")),
        ("9", ("9", "10", "11")),
        ("R1", ("R1", "R2", "R3")),
        ("N'", ("N'", "N'2", "N'3")),
    ],
)
def test_names_count_on(first: str, names: tuple[str, ...]) -> None:
    """Letters go on after Z with AA, numbers grow, and a name that is neither gets a number."""
    assert count_on(first, 3) == names


def test_distances_are_read_as_people_write_them() -> None:
    """A number and x repeat a distance; equal ones in a row are written so again."""
    family = StraightAxes(distances="2 x 6 m, 450 cm; 1x3 m")
    assert family.distances == (6.0, 6.0, 4.5, 3.0)
    assert 'distances = "2 x 6.0 m, 4.5 m, 3.0 m"' in casefile.to_toml(family)


def test_axes_cross_where_geometry_says() -> None:
    """Turned axes cross at the place of the law of sines; a ray and a ring once, in the ray's direction."""
    level = StraightAxes(distances="1 m", angle=90).axes[0]
    turned = StraightAxes(distances="1 m", origin=(2.0, 1.0), angle=-60).axes[0]  # rises by 30 degrees through (2, 1)
    assert crossings(level, turned)[0] == pytest.approx((2 - math.sqrt(3), 0.0), abs=1e-9)
    ring = RingAxes(centre=(1.0, 1.0), distances=(2.0, 3.0)).axes[1]
    (ray,) = RayAxes(centre=(1.0, 1.0), angles=(210.0,)).axes
    (place,) = crossings(ring, ray)
    assert place == pytest.approx((1 - 5 * math.cos(math.pi / 6), 1 - 5 / 2), abs=1e-9)
    assert crossings(level, StraightAxes(distances="1 m", angle=90, first="1").axes[1]) == ()


def test_what_hangs_on_axes_is_where_they_cross() -> None:
    """Columns, supports, forces, lines and walls lie at crossings, and move with the axes that are moved."""
    model = read(
        columns=[{"name": "C1", "at": "B/2", **SIZE}],
        supports=[{"kind": "point", "at": "3/D", "stiffness": "10 MN/m"}],
        walls=[{"name": "W1", "thickness": "250 mm", "at": ["A/1", "A/3", "B/3"]}],
        loads=[{"kind": "point", "at": "C/1", "P": "10 kN"}, {"kind": "line", "at": ["A/2", "D/2"], "q": "1 kN/m"}],
    )
    assert (model.columns[0].x, model.columns[0].y) == (6.0, 5.0)
    assert model.supports[0].points == ((16.5, 12.0),)
    assert model.walls[0].points == ((0.0, 0.0), (0.0, 12.0), (6.0, 12.0))
    assert model.acting[0][1].place == (12.0, 0.0)
    assert model.acting[1][1].length == pytest.approx(16.5)
    moved = model.replace(axes=[LETTERS | {"distances": "5 m, 6 m, 5 m"}, NUMBERS])
    assert (moved.columns[0].x, moved.columns[0].y) == (5.0, 5.0)
    assert moved.walls[0].points == ((0.0, 0.0), (0.0, 12.0), (5.0, 12.0))


def test_written_cases_keep_what_hangs_on_axes() -> None:
    """A case that is written has the axes' names instead of places, and is read as the same model."""
    model = read(columns=[{"name": "C1", "at": "B/2", **SIZE}])
    text = casefile.to_toml(model)
    assert 'at = "B/2"' in text
    assert "\nx = " not in text.split("[[columns]]")[1]
    assert casefile.loads(text) == model


def test_a_moved_plan_takes_its_axes_along() -> None:
    """About its own center a model has columns and axes at the same places against each other."""
    local = move_to_center(read(columns=[{"name": "C1", "at": "B/2", **SIZE}]))
    column = local.columns[0]
    assert (column.x, column.y) != (6.0, 5.0)
    assert name_of_crossing((column.x, column.y), local.axes) == "B/2"


REFUSED: dict[str, tuple[dict[str, Any], str, str]] = {
    "no such axis": ({"columns": [{"name": "C1", "at": "B/9", **SIZE}]}, "columns[1].at", 'no axis "9"'),
    "no axes": ({"axes": [], "columns": [{"name": "C1", "at": "B/2", **SIZE}]}, "columns[1].at", "no axis"),
    "parallel": ({"columns": [{"name": "C1", "at": "A/B", **SIZE}]}, "columns[1].at", "do not cross"),
    "one axis": ({"columns": [{"name": "C1", "at": "B", **SIZE}]}, "columns[1].at", '"B"'),
    "another place": ({"columns": [{"name": "C1", "at": "B/2", "x": "7 m", **SIZE}]}, "columns[1].at", "with x"),
    "no list": ({"loads": [{"kind": "line", "at": "A/1", "q": "1 kN/m"}]}, "loads[1].at", '"A/1"'),
    "one point": ({"loads": [{"kind": "line", "at": ["A/1"], "q": "1 kN/m"}]}, "loads[1].points", "1 point"),
    "all over": ({"loads": [{"kind": "uniform", "at": "A/1", "q": "1 kPa"}]}, "loads[1].at", "unknown key"),
    "twice": ({"axes": [LETTERS, LETTERS]}, "axes[2].first", 'second axis "A"'),
    "slash": ({"axes": [LETTERS | {"names": ["A", "B/C", "D", "E"]}]}, "axes[1].names[2]", '"B/C"'),
    "names": ({"axes": [LETTERS | {"names": ["A", "B"]}]}, "axes[1].names", "2 names"),
    "no unit": ({"axes": [LETTERS | {"distances": "2 x 6"}]}, "axes[1].distances", "2 x 6"),
    "no kind": (
        {"axes": [{"first": "A", "distances": "6 m"}, NUMBERS], "columns": [{"name": "C1", "at": "A/1", **SIZE}]},
        "axes[1].kind",
        "nothing",
    ),
    "nothing": ({"axes": [LETTERS | {"distances": "0 m"}]}, "axes[1].distances", "0 m"),
}


@pytest.mark.parametrize(("parts", "where", "found"), REFUSED.values(), ids=REFUSED)
def test_references_and_axes_that_are_wrong_are_refused(parts: dict[str, Any], where: str, found: str) -> None:
    """Each fault is reported at its key, alone."""
    with pytest.raises(InputError) as refused:
        read(**parts)
    (issue,) = refused.value.issues
    assert issue.location == where
    assert found in issue.found


@pytest.mark.parametrize(
    ("part", "keys"),
    [
        (Column, {"name": "C1", "at": "B/2", "diameter": 0.4}),
        (PointLoad, {"P": 1e3, "at": "B/2"}),
        (PointSupport, {"at": "B/2"}),
        (Wall, {"name": "W1", "at": ["A/1", "B/1"], "thickness": 0.2}),
        (LineLoad, {"q": 1e3, "at": ["A/1", "B/1"]}),
    ],
    ids=lambda each: getattr(each, "__name__", ""),
)
def test_a_part_by_itself_finds_no_crossing(part: type[Section], keys: dict[str, Any]) -> None:
    """It knows no axes: that is said once, at the key, with other faults; a model takes the same keys as a dict."""
    with pytest.raises(InputError) as refused:
        part(**keys, nonsense=1)
    (unknown, issue) = refused.value.issues
    assert (unknown.location, issue.location) == (f"{part.__name__}.nonsense", f"{part.__name__}.at")
    assert "without a model" in issue.found
    assert issue.expected == ("points" if isinstance(keys["at"], list) else "x and y")
    assert f"instead of a {part.__name__}" in issue.hint


def test_a_model_in_python_places_parts_on_axes() -> None:
    """Dicts among sections are placed on axes in SI units, and move with these when the model is made anew."""
    bay = StraightAxes(first="A", distances=[6.0, 6.0])
    model = Model(
        plate=Plate(length_x=16, length_y=12, thickness=0.3, E=30e9, nu=0.2),
        ground=Winkler(k=20e6),
        axes=[bay, StraightAxes(first="1", distances=[5.0], angle=90)],
        columns=[{"name": "C1", "at": "B/2", "diameter": 0.4}, Column(name="C2", x=-1.0, y=-1.0, diameter=0.4)],
        loads=[PointLoad(P=1e6, column="C1"), {"kind": "line", "q": 1e4, "at": ["A/1", "B/1"]}],
    )
    wider = model.replace(axes=[bay.replace(distances=[7.0, 6.0]), model.axes[1]])
    assert [(each.columns[0].x, each.columns[0].y) for each in (model, wider)] == [(6.0, 5.0), (7.0, 5.0)]
    assert wider.loads[1].points == ((0.0, 0.0), (7.0, 0.0))


def test_a_ring_crossed_twice_is_no_place() -> None:
    """A straight axis crosses a ring at two places, which is said."""
    rings = {"kind": "ring", "first": "R1", "centre": ["6 m", "5 m"], "distances": "2 m"}
    with pytest.raises(InputError, match="two places"):
        read(axes=[LETTERS, NUMBERS, rings], columns=[{"name": "C1", "at": "B/R1", **SIZE}])


def test_other_faults_are_reported_beside_wrong_references() -> None:
    """All faults of a file are reported at once."""
    with pytest.raises(InputError) as refused:
        read(
            columns=[{"name": "C1", "at": "B/9", **SIZE}, {"name": "C2", "at": "A/1", "diameter": "-1 m"}],
            loads=[{"kind": "point", "at": "Z/1", "P": "1 kN"}],
        )
    assert [issue.location for issue in refused.value.issues] == ["columns[1].at", "columns[2].diameter", "loads[1].at"]


def test_a_place_that_is_changed_follows_no_axes() -> None:
    """A column that gets another place stays there, also in a model that is made anew."""
    model = read(columns=[{"name": "C1", "at": "B/2", **SIZE}])
    moved = model.columns[0].replace(x=7.0)
    assert (moved.x, moved.at) == (7.0, "")
    assert model.replace(columns=[moved]).columns[0].x == 7.0
    assert model.columns[0].replace(width_x=0.5).at == "B/2"


def test_removing_axes_that_something_hangs_on_is_refused() -> None:
    """Sections that are there already are found, too."""
    model = read(columns=[{"name": "C1", "at": "B/2", **SIZE}])
    with pytest.raises(InputError, match="no axis"):
        model.replace(axes=())


def test_axes_are_drawn_over_the_plates() -> None:
    """Lines reach beyond the plates on both sides, and bubbles are above and on the right."""
    model = read()
    drawn = {axis.name: axis for axis in drawn_axes(model.axes, model.bounds)}
    assert drawn["B"].points[:, 0].tolist() == pytest.approx([6.0, 6.0])
    assert drawn["B"].points[:, 1].min() < -1 < 13 < drawn["B"].points[:, 1].max() < drawn["B"].bubble[1]
    assert drawn["2"].bubble[0] > 18
    assert drawn["2"].bubble[1] == pytest.approx(5.0)


def test_results_do_not_depend_on_how_a_column_is_placed() -> None:
    """A column on axes gives the settlements of one at the same place, and its table names the axes."""
    loads = [{"kind": "point", "column": "C1", "P": "500 kN"}]
    mesh = {"size": "2 m"}
    plain = {"name": "C1", "x": "6 m", "y": "5 m", **SIZE}
    attached = solve(read(columns=[{"name": "C1", "at": "B/2", **SIZE}], loads=loads, mesh=mesh))
    free = solve(read(columns=[plain], loads=loads, mesh=mesh, axes=[]))
    (one,), (other,) = attached.results.values(), free.results.values()
    assert one.plate.settlement.tolist() == other.plate.settlement.tolist()
    assert column_table(attached)["axes"] == ("B/2",)
