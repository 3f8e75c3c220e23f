"""Drawings as they come: gaps between ends of lines, hatches, turned columns, commas in numbers."""

from __future__ import annotations

import math
import random
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import ezdxf
import pytest
from ezdxf.entities.boundary_paths import EdgePath
from ezdxf.layouts import Modelspace
from ezdxf.math import Matrix44

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.exchange import dxf
from groundslab.exchange.dxf.drawing import Drawing
from groundslab.exchange.dxf.loads.labelling import find_quantity
from groundslab.model.loads.load_types import AreaLoad, PointLoad

Draw = Callable[[Modelspace], object]


def read(draw: Draw, folder: Path, unit: int = 6, gap: float = 1e-3) -> Drawing:
    """Draw, save and read."""
    document = ezdxf.new("R2010", units=unit)
    draw(document.modelspace())
    document.saveas(folder / "plan.dxf")
    return dxf.read(folder / "plan.dxf", gap=gap)


def remarks(drawing: Drawing, words: str) -> list[str]:
    """Return what the report says of layers with certain words."""
    return [line.why for line in drawing.report if line.entity == "LAYER" and words in line.why]


def on(layer: str) -> dict[str, Any]:
    """Return the attributes of an entity on a layer."""
    return {"layer": layer}


def lines(space: Modelspace, *corners: tuple[float, ...]) -> None:
    """Draw the edges of an outline, each by its start and end."""
    for x, y, u, v in corners:
        space.add_line((x, y), (u, v), on("OUTLINE"))


def frame(space: Modelspace, shift: float = 0.0) -> None:
    """Draw an outline of 10 m x 6 m whose first edge ends so far off the corner."""
    lines(space, (0, 0, 10, shift), (10, 0, 10, 6), (10, 6, 0, 6), (0, 6, 0, 0))


class TestGaps:
    """Ends of lines that nearly meet."""

    @pytest.mark.parametrize("gap", [1e-5, 1e-4, 9.9e-4])
    def test_a_small_gap_is_closed_and_told(self, gap: float, tmp_path: Path) -> None:
        """Of 0.01 mm to 1 mm: the slab has its area, and the report says where the gap was and how wide."""
        drawing = read(lambda space: frame(space, gap), tmp_path)
        assert drawing.outline.area == pytest.approx(60, abs=10 * gap)
        assert len(drawing.outline.points) == 4
        told = remarks(drawing, "a gap of")
        assert len(told) == 1
        assert f"a gap of {gap:.6g} m was closed at (10, {gap:.10g}) m, LINE " in told[0]
        assert told[0] in dxf.report_text(drawing)

    def test_straight_edges_meet_where_they_would(self, tmp_path: Path) -> None:
        """In millimeters: a corner that is cut short on one side, one on both, one that is overshot; 10 m by 6 m."""
        drawing = read(
            lambda space: lines(space, (0, 0, 9999.5, 0), (10000, 0.3, 10000, 6000.4), (10000.2, 6000, 0, 6000),
                                (0, 5999.6, 0, 0)),
            tmp_path,
            unit=4,
        )  # fmt: skip
        assert sorted((round(x, 9), round(y, 9)) for x, y in drawing.outline.points) == [
            (0, 0),
            (0, 6),
            (10, 0),
            (10, 6),
        ]
        assert len(remarks(drawing, "was closed")) == 3
        written = re.findall(r'"(\S+) m"', dxf.to_case(drawing))
        assert {"0", "6", "10"} <= set(written)
        assert all(len(each) < 12 for each in written)

    def test_ends_that_would_meet_far_away_meet_midway(self, tmp_path: Path) -> None:
        """Two halves of an edge, 0.4 mm off each other, that are nearly parallel; an arc and an edge."""
        drawing = read(
            lambda space: lines(space, (0, 0, 5000, 0), (5000, 0.4, 10000, 0), (10000, 0, 10000, 6000),
                                (10000, 6000, 0, 6000), (0, 6000, 0, 0)),
            tmp_path,
            unit=4,
        )  # fmt: skip
        assert (5, 0.0002) in {(round(x, 9), round(y, 9)) for x, y in drawing.outline.points}

    def test_a_wider_gap_is_closed_on_demand(self, tmp_path: Path) -> None:
        """3 mm are an issue, which says what to do, unless gaps up to 5 mm may be closed; 0 closes none."""
        with pytest.raises(InputError, match=r"a gap of 0\.003 m.*\n?.*wider gaps to be closed"):
            read(lambda space: frame(space, 3e-3), tmp_path)
        assert len(remarks(read(lambda space: frame(space, 3e-3), tmp_path, gap=5e-3), "was closed")) == 1
        with pytest.raises(InputError, match=r"a gap of 0\.0005 m"):
            read(lambda space: frame(space, 5e-4), tmp_path, gap=0.0)

    def test_no_edge_is_swallowed(self, tmp_path: Path) -> None:
        """A gap wider than a tenth of an edge that ends there stays open: the edge may be what is missing."""

        def draw(space: Modelspace) -> None:
            lines(space, (0, 0, 10, 0), (10, 0, 10, 6), (10, 6, 0, 6), (0, 6, 0, 0.005), (0, 0.005, -0.004, 0.0005))

        with pytest.raises(InputError, match="a gap of"):
            read(draw, tmp_path, gap=5e-3)

    def test_of_three_ends_the_two_nearest_are_joined(self, tmp_path: Path) -> None:
        """What remains is an open end, which is an issue and never joined at random."""

        def draw(space: Modelspace) -> None:
            frame(space, 2e-4)
            space.add_line((10, -6e-4), (12, -2), on("OUTLINE"))

        with pytest.raises(InputError) as caught:
            read(draw, tmp_path)
        assert "(12, -2)" in str(caught.value)

    def test_many_gaps_are_summed_up(self, tmp_path: Path) -> None:
        """Of a circle of 100 arcs with a gap at each the first forty are listed, then how many more."""

        def draw(space: Modelspace) -> None:
            for n in range(100):
                space.add_arc((0, 0), 10, 3.6 * n + 0.001, 3.6 * (n + 1), dxfattribs=on("OUTLINE"))

        drawing = read(draw, tmp_path)
        assert len(remarks(drawing, "was closed")) == 40
        assert len(remarks(drawing, "60 more gaps were closed, the widest of 0.0001745")) == 1
        assert drawing.outline.area == pytest.approx(math.pi * 100, rel=1e-5)

    @pytest.mark.parametrize(
        ("text", "words"), [("1", "length"), ("1 kN", "length"), ("-1 mm", "0 mm"), ("1 m", "100 mm")]
    )
    def test_a_width_that_is_none(self, text: str, words: str) -> None:
        """A width without a unit, negative or as wide as a wall is refused."""
        assert dxf.parse_gap("2 mm") == 2e-3
        with pytest.raises(InputError, match=words):
            dxf.parse_gap(text)


class TestHatches:
    """Fillings as areas."""

    def test_the_value_of_its_layer(self, tmp_path: Path) -> None:
        """A hatch of 3 m x 3 m on the layer of 5 kPa is an area load."""

        def draw(space: Modelspace) -> None:
            frame(space)
            space.add_hatch(dxfattribs=on("LOAD_AREA 5 kPa")).paths.add_polyline_path([(1, 1), (4, 1), (4, 4), (1, 4)])

        (area,) = read(draw, tmp_path).area_loads
        assert (area.curve.area, area.value, area.holes) == (9, 5000, ())

    def test_inner_paths_are_openings_and_arcs_stay(self, tmp_path: Path) -> None:
        """A slab as a hatch of edges in any direction with a half circle, and a round opening: areas are exact."""

        def draw(space: Modelspace) -> None:
            hatch = space.add_hatch(dxfattribs=on("OUTLINE"))
            edges: EdgePath = hatch.paths.add_edge_path(flags=1)
            edges.add_line((0, 0), (10, 0))
            edges.add_arc((10, 3), 3, -90, 90)
            edges.add_line((0, 6), (10, 6))  # drawn the other way round
            edges.add_line((0, 6), (0, 0))
            inner: EdgePath = hatch.paths.add_edge_path(flags=0)
            inner.add_arc((5, 3), 1, 0, 360)

        drawing = read(draw, tmp_path)
        assert drawing.outline.area == pytest.approx(60 + math.pi * 9 / 2, rel=1e-12)
        assert [opening.area for opening in drawing.openings] == pytest.approx([math.pi], rel=1e-12)

    @pytest.mark.parametrize("ccw", [True, False])
    def test_arcs_drawn_clockwise_and_mirrored(self, ccw: bool, tmp_path: Path) -> None:
        """Arcs of either direction, and a hatch seen from below, enclose the same area."""

        def draw(space: Modelspace) -> None:
            frame(space)
            hatch = space.add_hatch(dxfattribs=on("LOAD_AREA 5 kPa"))
            path: EdgePath = hatch.paths.add_edge_path(flags=1)
            path.add_line((2, 2), (2, 4))
            path.add_arc((2, 3), 1, -90, 90, ccw=ccw)
            hatch.transform(Matrix44.scale(-1, 1, 1) @ Matrix44.translate(8, 0, 0))

        (area,) = read(draw, tmp_path).area_loads
        assert area.curve.area == pytest.approx(math.pi / 2, rel=1e-12)
        assert min(x for x, _ in area.curve.points) == pytest.approx(6)
        assert area.curve.bounds[0] == pytest.approx(5)

    def test_a_hole_in_a_load(self, tmp_path: Path) -> None:
        """The inner path of a load's hatch takes away; an ellipse and a spline become lines within 1 mm."""

        def draw(space: Modelspace) -> None:
            frame(space)
            hatch = space.add_hatch(dxfattribs=on("LOAD_AREA 5 kPa"))
            hatch.paths.add_polyline_path([(1, 1, 0), (5, 1, 0), (5, 5, 0), (1, 5, 0)], flags=1)
            inner: EdgePath = hatch.paths.add_edge_path(flags=16)
            inner.add_ellipse((3, 3), (1, 0), 0.5, 0, 360)

        (area,) = read(draw, tmp_path).area_loads
        assert [hole.area for hole in area.holes] == pytest.approx([math.pi / 2], rel=2e-3)

    def test_a_filling_of_a_drawn_outline_is_no_opening(self, tmp_path: Path) -> None:
        """Beside an outline of lines a hatch on its layer is left, and the report says so."""

        def draw(space: Modelspace) -> None:
            frame(space)
            space.add_hatch(dxfattribs=on("OUTLINE")).paths.add_polyline_path([(1, 1), (4, 1), (4, 4)])

        drawing = read(draw, tmp_path)
        assert drawing.openings == ()
        (line,) = (line for line in drawing.report if line.entity == "HATCH")
        assert not line.taken
        assert "only where the layer has nothing else" in line.why

    def test_what_is_no_boundary(self, tmp_path: Path) -> None:
        """Edges that do not close, and a hatch without any, are ignored with the reason."""

        def draw(space: Modelspace) -> None:
            frame(space)
            path: EdgePath = space.add_hatch(dxfattribs=on("ZONES")).paths.add_edge_path(flags=1)
            path.add_line((1, 1), (2, 1))
            path.add_line((2, 2), (1, 2))
            space.add_hatch(dxfattribs=on("ZONES"))

        drawing = read(draw, tmp_path)
        assert [line.why for line in drawing.report if line.entity == "HATCH"] == [
            "its boundary is not closed",
            "it has no boundary",
        ]

    def test_they_are_shown_before_anything_is_chosen(self, tmp_path: Path) -> None:
        """The survey shows the edges of hatches."""
        from groundslab.exchange.dxf.survey import survey

        document = ezdxf.new("R2010", units=6)
        hatch = document.modelspace().add_hatch(dxfattribs=on("SLAB"))
        hatch.paths.add_polyline_path([(1, 1), (4, 1), (4, 4)])
        document.saveas(tmp_path / "plan.dxf")
        (layer,) = survey(tmp_path / "plan.dxf").layers
        assert layer.lines == [[(1, 1), (4, 1), (4, 4), (1, 1)]]


def turned(width: float, depth: float, angle: float, x: float, y: float) -> list[tuple[float, float]]:
    """Return the corners of a rectangle turned about its center by an angle [degrees]."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    halves = [(-width / 2, -depth / 2), (width / 2, -depth / 2), (width / 2, depth / 2), (-width / 2, depth / 2)]
    return [(x + c * u - s * v, y + s * u + c * v) for u, v in halves]


def with_column(corners: list[tuple[float, float]], folder: Path) -> Drawing:
    """Return a drawing of a column with 600.5 kN in its center, (5, 3) m."""

    def draw(space: Modelspace) -> None:
        frame(space)
        space.add_lwpolyline(corners, close=True, dxfattribs=on("COLUMNS"))
        space.add_point((5, 3), on("LOADS"))
        space.add_text("600,5 kN", height=0.01, dxfattribs={**on("LOADS"), "insert": (5, 3)})

    return read(draw, folder)


def case_of(drawing: Drawing) -> Any:
    """Return the case of a drawing with what no drawing says."""
    head = "[plate]\nthickness = '0.5 m'\nE = '30 GPa'\nnu = 0.2\n"
    ground = "[ground]\nkind = 'winkler'\nk = '50 MPa/m'\n"
    return casefile.loads(dxf.to_case(drawing).replace("[plate]\n", head) + ground)


class TestColumns:
    """Columns whose sides do not run along x and y."""

    @pytest.mark.parametrize(("width", "depth"), [(0.4, 0.4), (0.3, 0.6)])
    def test_a_turned_rectangle_is_a_column_at_its_angle(self, width: float, depth: float, tmp_path: Path) -> None:
        """It is read with its sides and its angle, and has its load."""
        drawing = with_column(turned(width, depth, 30, 5, 3), tmp_path)
        model = case_of(drawing)
        (column,) = model.columns
        assert (column.width_x, column.width_y, column.angle) == pytest.approx((width, depth, 30), abs=1e-9)
        assert (column.x, column.y) == pytest.approx((5, 3))
        (load,) = (load for load in model.loads if isinstance(load, PointLoad))
        assert (load.P, load.column, load.M_x, load.M_y) == (600.5e3, "C1", 0, 0)
        assert not remarks(drawing, "circle")

    def test_a_hexagon_is_a_circle_of_its_area(self, tmp_path: Path) -> None:
        """What is compact and no rectangle has a circle's perimeters, shorter than its own: on the safe side."""
        corners = [(5 + 0.2 * math.cos(n * math.pi / 3), 3 + 0.2 * math.sin(n * math.pi / 3)) for n in range(6)]
        drawing = with_column(corners, tmp_path)
        (column,) = case_of(drawing).columns
        assert column.diameter == pytest.approx(math.sqrt(4 * 6 * math.sqrt(3) / 4 * 0.04 / math.pi))
        assert len(remarks(drawing, "taken as a circle of the same area")) == 1

    def test_a_long_rectangle_is_a_column_whichever_way_it_runs(self, tmp_path: Path) -> None:
        """0.2 m x 1.5 m is a column along x and y, and so it is at 30 degrees, of its widths the first closest to x."""
        (column,) = case_of(with_column(turned(0.2, 1.5, -60, 5, 3), tmp_path)).columns
        assert (column.width_x, column.width_y, column.angle) == pytest.approx((1.5, 0.2, 30), abs=1e-9)

    def test_a_long_parallelogram_spreads_its_load(self, tmp_path: Path) -> None:
        """It is no rectangle, and too long for a circle: the load is spread over it, which is not punched."""
        drawing = with_column([(4.2, 2.9), (5.6, 2.9), (5.8, 3.1), (4.4, 3.1)], tmp_path)
        model = case_of(drawing)
        assert model.columns == ()
        (load,) = model.loads
        assert isinstance(load, AreaLoad)
        assert load.q * 0.28 == pytest.approx(600.5e3, rel=1e-12)
        assert len(remarks(drawing, "punching is not checked")) == 1

    def test_corners_that_are_off_by_less_than_a_millimeter(self, tmp_path: Path) -> None:
        """A rectangle drawn by hand stays one: 0.4 m x 0.3 m with corners 0.2 mm off."""
        corners = [(4.8, 2.85), (5.2, 2.8502), (5.2, 3.15), (4.8001, 3.15)]
        (column,) = case_of(with_column(corners, tmp_path)).columns
        assert (column.width_x, column.width_y) == pytest.approx((0.4, 0.3))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("600,5 kN", 600.5e3),
        ("N = 12,25 kN", 12.25e3),
        ("0,125 kN", 125.0),
        ("1.234,5 kN", 1234.5e3),
        ("1,234.5 kN", 1234.5e3),
        ("1,234,567 N", 1234567.0),
        ("C3 -2,5 kN", -2.5e3),
        ("1234,567 kN", 1234567.0),
    ],
)
def test_commas(text: str, value: float) -> None:
    """A comma is the decimal point, or stands between thousands where it cannot be one."""
    assert find_quantity(text) == pytest.approx(value, rel=1e-12)


def test_a_comma_that_may_be_both() -> None:
    """1,500 kN are 1.5 kN or 1500 kN: the value is not taken, and the reason names both."""
    assert find_quantity("1,500 kN") == "1,500 may be 1500 or 1.5; write it without a comma"
    assert find_quantity("axis 1,500") is None


def rectangle(space: Modelspace, x: float, y: float, width: float, height: float, layer: str = "OUTLINE") -> None:
    """Draw a rectangle as one closed polyline."""
    corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
    space.add_lwpolyline(corners, close=True, dxfattribs=on(layer))


class TestUnion:
    """Outlines side by side."""

    def house(self, space: Modelspace) -> None:
        """Draw a house of 10 m x 8 m, a porch with an arc below it, and a garage 0.5 mm to its right."""
        rectangle(space, 0, 0, 10, 8)
        space.add_lwpolyline([(3, 0, 0, 0, 0), (3, -2, 0, 0, 1), (5, -2, 0, 0, 0), (5, 0, 0, 0, 0)], close=True,
                             dxfattribs=on("OUTLINE"))  # fmt: skip
        rectangle(space, 10.0005, 2, 3, 5)

    def test_adjoining_outlines_are_one_if_that_is_wanted(self, tmp_path: Path) -> None:
        """80 + 4 + pi / 2 + 15 m2; else they are refused, with the choice."""
        document = ezdxf.new("R2010", units=6)
        self.house(document.modelspace())
        document.saveas(tmp_path / "plan.dxf")
        with pytest.raises(InputError, match="--union"):
            dxf.read(tmp_path / "plan.dxf")
        drawing = dxf.read(tmp_path / "plan.dxf", union=True)
        assert drawing.outline.area == pytest.approx(80 + 4 + math.pi / 2 + 15, abs=0.01)
        assert any(drawing.outline.bulges)
        assert not drawing.openings
        assert remarks(drawing, "3 outlines were joined")
        assert sum(line.entity == "LWPOLYLINE" and line.taken for line in drawing.report) == 3

    def test_a_courtyard_between_outlines_is_an_opening(self, tmp_path: Path) -> None:
        """Four wings around a court of 4 m x 3 m: 10 x 8 less 12 m2."""

        def draw(space: Modelspace) -> None:
            for wing in ((0, 0, 10, 2), (0, 5, 10, 3), (0, 2, 3, 3), (7, 2, 3, 3)):
                rectangle(space, *wing)

        document = ezdxf.new("R2010", units=6)
        draw(document.modelspace())
        document.saveas(tmp_path / "plan.dxf")
        drawing = dxf.read(tmp_path / "plan.dxf", union=True)
        assert (drawing.outline.area, [opening.area for opening in drawing.openings]) == (80, [12])

    @pytest.mark.parametrize("other", [(5, 2, 8, 3), (12, 0, 3, 3), (0, 0, 10, 4)], ids=["across", "apart", "within"])
    def test_outlines_that_do_not_adjoin_are_refused(self, other: tuple[float, ...], tmp_path: Path) -> None:
        """One that lies partly on the other, one apart from it, one within it along three edges."""
        document = ezdxf.new("R2010", units=6)
        rectangle(document.modelspace(), 0, 0, 10, 8)
        rectangle(document.modelspace(), *other)
        document.saveas(tmp_path / "plan.dxf")
        with pytest.raises(InputError):
            dxf.read(tmp_path / "plan.dxf", union=True)


class TestValuesBesideColumns:
    """Forces that stand beside a column without a point."""

    def draw(self, space: Modelspace, text: str, x: float = 3.3) -> None:
        """Draw a slab with a column of 0.4 m at (3, 3), and a text beside it."""
        rectangle(space, 0, 0, 10, 6)
        rectangle(space, 2.8, 2.8, 0.4, 0.4, "COLUMNS")
        space.add_text(text, height=0.2, dxfattribs=on("LOADS")).set_placement((x, 3.1))

    def test_a_force_beside_a_column_is_a_load_on_it(self, tmp_path: Path) -> None:
        """860,5 kN in its middle, by the column's name in the case."""
        drawing = read(lambda space: self.draw(space, "860,5 kN"), tmp_path)
        (load,) = drawing.point_loads
        assert (round(load.x, 9), round(load.y, 9), load.value) == (3, 3, 860.5e3)
        assert 'P = "860.5 kN"\ncolumn = "C1"' in dxf.to_case(drawing)
        assert any("beside column 1" in line.why for line in drawing.report)

    def test_a_name_beside_a_column_is_no_load(self, tmp_path: Path) -> None:
        """It is ignored, as before."""
        assert read(lambda space: self.draw(space, "S1"), tmp_path).point_loads == ()

    @pytest.mark.parametrize("text", ["860,500 kN", "860 m"])
    def test_what_cannot_be_read_is_an_issue(self, text: str, tmp_path: Path) -> None:
        """A comma that may group digits, another unit."""
        with pytest.raises(InputError, match=text):
            read(lambda space: self.draw(space, text), tmp_path)

    def test_a_load_goes_before_a_column(self, tmp_path: Path) -> None:
        """A point 1 m off takes its value though the column is nearer; a second value stays an issue."""

        def draw(space: Modelspace) -> None:
            self.draw(space, "860 kN")
            space.add_point((4.3, 3), dxfattribs=on("LOADS"))

        (load,) = read(draw, tmp_path).point_loads
        assert (load.x, load.y, load.value) == (4.3, 3, 860e3)

        def twice(space: Modelspace) -> None:
            draw(space)
            space.add_text("300 kN", height=0.2, dxfattribs=on("LOADS")).set_placement((3.3, 2.8))

        with pytest.raises(InputError, match="a second value"):
            read(twice, tmp_path)


class TestUnits:
    """The unit of a drawing against what it holds."""

    def test_a_house_in_inches_that_says_millimeters(self, tmp_path: Path) -> None:
        """700 by 380 are 0.7 m by 0.38 m in millimeters, 17.8 m by 9.65 m in inches, 7 m by 3.8 m in centimeters."""
        drawing = read(lambda space: rectangle(space, 0, 0, 700, 380), tmp_path, unit=4)
        (said,) = (line.why for line in drawing.report if line.entity == "HEADER")
        assert said == (
            "the unit is mm, which makes it a slab of 0.7 m x 0.38 m; it would be 7 m x 3.8 m in cm, "
            "17.8 m x 9.65 m in in or 213 m x 116 m in ft"
        )
        assert said in dxf.report_text(drawing)
        assert "# Check the unit: the unit is mm" in dxf.to_case(drawing)

    def test_columns_tell_as_well(self, tmp_path: Path) -> None:
        """A slab of 30 m x 20 m in millimeters that says inches has columns of 10 m; as it is, nothing is said."""

        def draw(space: Modelspace) -> None:
            rectangle(space, 0, 0, 15000, 9000)
            rectangle(space, 2000, 2000, 400, 400, "COLUMNS")

        wrong, right = (read(draw, tmp_path, unit=unit) for unit in (1, 4))
        (said,) = (line.why for line in wrong.report if line.entity == "HEADER")
        assert "381 m x 229 m with columns up to 10.2 m wide; it would be 15 m x 9 m in mm" in said
        assert not any(line.entity == "HEADER" for line in right.report)

    @pytest.mark.parametrize(("written", "told"), [(2, False), (4, True), (3, True)])
    def test_feet_and_inches_in_a_metric_drawing(self, written: int, told: bool, tmp_path: Path) -> None:
        """A header that says millimeters and writes lengths as architects in inches do."""

        def draw(space: Modelspace) -> None:
            rectangle(space, 0, 0, 15000, 9000)
            assert space.doc is not None
            space.doc.header["$LUNITS"] = written

        drawing = read(draw, tmp_path, unit=4)
        assert any("feet and inches" in line.why for line in drawing.report) == told


@pytest.mark.parametrize("seed", range(25))
def test_layers_and_units_spelled_in_other_ways(seed: int, tmp_path: Path) -> None:
    """Capitals, spaces, signs, singular and plural of layers, spaces and commas of values: always the same slab."""
    chance = random.Random(seed)

    def spelled(name: str) -> str:
        one = name.removesuffix("S")
        name = chance.choice([one, one + "S"]).replace("_", chance.choice("_ -"))
        return chance.choice([str.upper, str.lower, str.title])(name)

    def draw(space: Modelspace) -> None:
        rectangle(space, 0, 0, 10, 6, spelled("OUTLINE"))
        rectangle(space, 4, 2, 1, 1, spelled("OPENINGS"))
        rectangle(space, 2, 2, 0.4, 0.4, spelled("COLUMNS"))
        value = chance.choice(["860.5 kN", "860,5 kN", "860,5kN", "F = 860.5 kN", "P: 860,5 kN"])
        space.add_text(value, height=0.2, dxfattribs=on(spelled("LOADS"))).set_placement((2.5, 2.2))
        thick = f"{spelled('WALLS')}{chance.choice('_ -')}{chance.choice(['25 cm', '250 mm', '0,25 m'])}"
        space.add_line((1, 5), (9, 5), on(thick))
        space.add_line(
            (1, 1), (9, 1), on(f"{spelled('LOAD_LINE')} {chance.choice(['20 kN_m', '20,0 kN-m', '20.0 kN_m'])}")
        )

    drawing = read(draw, tmp_path)
    assert (drawing.outline.area, [opening.area for opening in drawing.openings]) == (60, [1])
    assert [load.value for load in drawing.point_loads] == [860.5e3]
    assert [wall.value for wall in drawing.walls] == [0.25]
    assert [load.value for load in drawing.line_loads] == [20e3]


@pytest.mark.parametrize(
    ("text", "section"),
    [("B1 40x80 cm", 'width = "40 cm", height = "80 cm" }'), ("40,5x80 cm", 'width = "40.5 cm", height = "80 cm" }'),
     ("400x1,200 mm", 'width = "400 mm", height = "800 mm" }  # fill in')],
)  # fmt: skip
def test_sections_of_beams_with_commas(text: str, section: str, tmp_path: Path) -> None:
    """A height of 1,200 mm may be 1.2 mm or 1200 mm: it is to be filled in."""

    def draw(space: Modelspace) -> None:
        rectangle(space, 0, 0, 10, 6)
        space.add_line((1, 3), (9, 3), on("BEAMS"))
        space.add_text(text, height=0.2, dxfattribs=on("BEAMS")).set_placement((3, 3.1))

    assert section in dxf.to_case(read(draw, tmp_path))


@pytest.mark.parametrize(
    ("text", "thickness", "points", "told"),
    [("", 0.25, 2, False), ("25 cm", 0.25, 2, False), ("30 cm", 0.3, 2, True), ("8 cm", 0.08, 4, True)],
)
def test_the_thickness_of_a_wall_and_its_faces(
    text: str, thickness: float, points: int, told: bool, tmp_path: Path
) -> None:
    """A strip of 0.25 m is a wall along its middle whose text counts, with a remark; 80 mm are walls along edges."""

    def draw(space: Modelspace) -> None:
        rectangle(space, 0, 0, 10, 6)
        rectangle(space, 2, 3, 5, 0.25, "WALLS")
        if text:
            space.add_text(text, height=0.2, dxfattribs=on("WALLS")).set_placement((3, 3.4))

    drawing = read(draw, tmp_path)
    (wall,) = drawing.walls
    assert (wall.value, len(wall.points)) == (pytest.approx(thickness), points)
    assert bool(remarks(drawing, "a wall of")) == (told and points == 2)
