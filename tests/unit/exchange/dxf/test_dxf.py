"""Drawings: what is taken from which layer, in metres, and what is said about the rest."""

from __future__ import annotations

import math
import re
import tempfile
import tomllib
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import ezdxf
import numpy as np
import pytest
from ezdxf.document import Drawing as Document
from ezdxf.layouts import Modelspace
from ezdxf.math import Matrix44
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab import units
from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.exchange import dxf
from groundslab.exchange.dxf.document import Layers
from groundslab.exchange.dxf.drawing import Drawing
from groundslab.exchange.dxf.loads.labelling import find_quantity
from groundslab.geometry.plan import Ring
from groundslab.model.loads.lines import LineLoad
from groundslab.model.loads.load_types import AreaLoad, PointLoad, UniformLoad
from groundslab.model.shapes import Circle, Polygon
from helpers.examples import examples

SQUARE = [(0, 0), (4, 0), (4, 3), (0, 3)]
Draw = Callable[[Modelspace], object]


@pytest.fixture
def drawn(tmp_path: Path) -> Callable[..., Drawing]:
    """Return a function that draws, saves and reads."""

    def make(draw: Draw, units: int = 6, layers: Layers | None = None, unit: str | None = None) -> Drawing:
        return dxf.read(save(draw, tmp_path, units), layers, unit)

    return make


def save(draw: Draw, folder: Path, units: int = 6) -> Path:
    """Draw, and return the file."""
    document = ezdxf.new("R2010", units=units)
    draw(document.modelspace())
    path = folder / "plan.dxf"
    document.saveas(path)
    return path


def on(layer: str, **more: Any) -> dict[str, Any]:
    """Return the attributes of an entity on a layer."""
    return {"layer": layer, **more}


def outline(space: Modelspace, points: Any = SQUARE, layer: str = "OUTLINE", **more: Any) -> Any:
    """Draw a closed polyline."""
    return space.add_lwpolyline(points, close=True, dxfattribs=on(layer, **more))


def square(space: Modelspace, x: float, y: float, side: float, layer: str) -> Any:
    """Draw a square by its lower left corner."""
    return outline(space, [(x, y), (x + side, y), (x + side, y + side), (x, y + side)], layer)


def document_of(space: Modelspace) -> Document:
    """Return the document that a space belongs to."""
    assert space.doc is not None
    return space.doc


def issues(draw: Draw, folder: Path, units: int = 6, layers: Layers | None = None, unit: str | None = None) -> str:
    """Return the issues of a drawing."""
    with pytest.raises(InputError) as caught:
        dxf.read(save(draw, folder, units), layers, unit)
    assert caught.value.issues
    return str(caught.value)


def said(drawing: Drawing, entity: str) -> list[tuple[bool, str]]:
    """Return what the report says about entities of a kind."""
    return [(line.taken, line.why) for line in drawing.report if line.entity == entity]


def same(one: Ring, points: Any, bulges: Any = None, tolerance: float = 1e-9) -> None:
    """Assert that a curve is the given one, wherever it begins."""
    points = [tuple(map(float, point)) for point in points]
    bulges = [0.0] * len(points) if bulges is None else bulges
    assert len(one.points) == len(points)
    first = min(range(len(points)), key=lambda i: math.dist(points[i], one.points[0]))
    for i, (point, bulge) in enumerate(zip(one.points, one.bulges, strict=True)):
        j = (first + i) % len(points)
        assert math.dist(point, points[j]) <= tolerance
        assert bulge == pytest.approx(bulges[j], abs=1e-9)


class TestOutline:
    """Closed curves, drawn in every way."""

    def test_rectangle(self, drawn: Any) -> None:
        """A closed polyline is taken as it stands, and the report says so."""
        drawing = drawn(outline)
        assert drawing.outline == Ring(tuple((float(x), float(y)) for x, y in SQUARE), (0.0,) * 4)
        assert drawing.outline.area == 12
        assert said(drawing, "LWPOLYLINE") == [(True, "the outline")]
        assert (drawing.unit, drawing.scale) == ("m", 1.0)

    def test_clockwise_is_turned(self, drawn: Any) -> None:
        """All curves run anticlockwise; bulges change their sign with the direction."""
        points = [(0, 0, 0.0), (0, 3, -0.5), (4, 3, 0.0), (4, 0, 0.0)]
        drawing = drawn(lambda space: space.add_lwpolyline(points, "xyb", close=True, dxfattribs=on("OUTLINE")))
        same(drawing.outline, SQUARE, [0, 0, 0.5, 0])
        assert drawing.outline.area > 12

    @pytest.mark.parametrize("kind", ["LWPOLYLINE", "POLYLINE"])
    def test_l_with_a_round_corner(self, drawn: Any, kind: str) -> None:
        """Bulges are kept; the area of a quarter circle is exact."""
        bulge = math.tan(math.pi / 8)
        points = [(0, 0, 0), (6, 0, 0), (6, 2, 0), (3, 2, -bulge), (2, 3, 0), (2, 5, 0), (0, 5, 0)]

        def draw(space: Modelspace) -> None:
            if kind == "LWPOLYLINE":
                space.add_lwpolyline(points, "xyb", close=True, dxfattribs=on("outline"))
            else:
                space.add_polyline2d(points, "xyb", close=True, dxfattribs=on("outline"))

        drawing = drawn(draw)
        same(drawing.outline, [point[:2] for point in points], [point[2] for point in points])
        assert drawing.outline.area == pytest.approx(12 + 6 + (1 - math.pi / 4), rel=1e-12)

    def test_lines_and_arcs_in_any_order(self, drawn: Any) -> None:
        """A slot of two lines and two half circles, and an open polyline, close end to end in any direction."""

        def draw(space: Modelspace) -> None:
            space.add_line((4, 2), (0, 2), on("OUTLINE"))
            space.add_arc((0, 1), 1, 90, 270, dxfattribs=on("OUTLINE"))
            space.add_lwpolyline([(4, 0), (2, 0), (0, 0)], dxfattribs=on("OUTLINE"))
            space.add_arc((4, 1), 1, 270, 90, dxfattribs=on("OUTLINE"))

        drawing = drawn(draw)
        same(drawing.outline, [(0, 0), (2, 0), (4, 0), (4, 2), (0, 2)], [0, 0, 1, 0, 1])
        assert drawing.outline.area == pytest.approx(8 + math.pi, rel=1e-12)
        assert {why for _, why in said(drawing, "LINE") + said(drawing, "ARC")} == {"part of the outline"}

    def test_long_arc(self, drawn: Any) -> None:
        """An arc of more than a half circle becomes two."""

        def draw(space: Modelspace) -> None:
            space.add_arc((0, 0), 2, 0, 270, dxfattribs=on("OUTLINE"))
            space.add_line((0, -2), (2, 0), on("OUTLINE"))

        drawing = drawn(draw)
        assert drawing.outline.area == pytest.approx(3 * math.pi + 2, rel=1e-12)
        assert len(drawing.outline.points) == 3

    def test_circle(self, drawn: Any) -> None:
        """A circle is two half circles."""
        drawing = drawn(lambda space: space.add_circle((5, 1), 2, on("OUTLINE")))
        same(drawing.outline, [(3, 1), (7, 1)], [1, 1])
        assert drawing.outline.area == pytest.approx(4 * math.pi)

    def test_ellipse_and_spline_become_lines(self, drawn: Any) -> None:
        """Both are made into lines within a millimetre, and the report says so."""

        def draw(space: Modelspace) -> None:
            space.add_ellipse((0, 0), (5000, 0), 0.6, dxfattribs=on("OUTLINE"))
            points = [(1000, 0), (0, 1000), (-1000, 0), (0, -1000), (1000, 0)]
            space.add_spline(points, dxfattribs=on("OPENINGS"))

        drawing = drawn(draw, units=4)
        assert drawing.outline.area == pytest.approx(15 * math.pi, rel=1e-3)
        for a, b in zip(drawing.outline.points, (*drawing.outline.points[1:], drawing.outline.points[0]), strict=True):
            x, y = (a[0] + b[0]) / 2 / 5, (a[1] + b[1]) / 2 / 3
            assert 0 <= 1 - math.hypot(x, y) <= 1e-3 / 3
        assert "lines within 1 mm" in said(drawing, "ELLIPSE")[0][1]
        assert "lines within 1 mm" in said(drawing, "SPLINE")[0][1]
        assert len(drawing.openings) == 1

    @pytest.mark.slow
    def test_a_closed_spline(self, drawn: Any) -> None:
        """A spline with the flag of closed ones needs no equal ends, and its lines are as near as promised."""

        def draw(space: Modelspace) -> None:
            spline = space.add_spline(dxfattribs=on("OUTLINE"))
            spline.set_closed([(0, 0, 0), (9, 0, 0), (9, 7, 0), (4, 2, 0), (0, 7, 0)])
            tool = spline.construction_tool()
            exact.extend(tool.points(tool.params(999)))

        exact: list[Any] = []
        edges = drawn(draw).outline.segments()
        places = np.array([(p.x, p.y) for p in exact])
        assert (np.min([edge.distance(places) for edge in edges], axis=0) <= 1e-3).all()

    def test_doubles_count_once(self, drawn: Any) -> None:
        """The same curve begun elsewhere and run backwards, and a line on its edge, are reported and left."""

        def draw(space: Modelspace) -> None:
            outline(space)
            outline(space, [(4, 3), (4, 0), (0, 0), (0, 3)])
            space.add_line((4, 0), (0, 0), on("OUTLINE"))
            space.add_circle((2, 1), 0.5, on("OPENINGS"))
            space.add_circle((2, 1), 0.5, on("OPENINGS", extrusion=(0, 0, 1)))

        drawing = drawn(draw)
        same(drawing.outline, SQUARE)
        assert len(drawing.openings) == 1
        assert [taken for taken, _ in said(drawing, "LWPOLYLINE")].count(True) == 1
        assert [taken for taken, _ in said(drawing, "CIRCLE")].count(True) == 1
        assert "on top of" in said(drawing, "LINE")[0][1]

    def test_seen_from_below(self, drawn: Any) -> None:
        """An extrusion downwards mirrors x; arcs and bulges are turned round."""
        down = (0, 0, -1)

        def draw(space: Modelspace) -> None:
            points = [(0, 0, 0.0), (4, 0, 0.5), (4, 3, 0.0), (0, 3, 0.0)]
            space.add_lwpolyline(points, "xyb", close=True, dxfattribs=on("OUTLINE", extrusion=down))
            space.add_circle((1, 1), 0.5, on("OPENINGS", extrusion=down))
            space.add_arc((3, 1), 0.5, 0, 180, dxfattribs=on("OPENINGS", extrusion=down))
            space.add_line((-3.5, 1), (-2.5, 1), on("OPENINGS"))

        drawing = drawn(draw)
        same(drawing.outline, [(0, 0), (0, 3), (-4, 3), (-4, 0)], [0, 0, 0.5, 0])
        same(drawing.openings[0], [(-1.5, 1), (-0.5, 1)], [1, 1])
        same(drawing.openings[1], [(-3.5, 1), (-2.5, 1)], [0, 1])

    def test_what_is_no_flat_line_is_ignored(self, drawn: Any) -> None:
        """Slopes, tilted planes, fillings, text and meshes are reported with the reason; a height is remarked on."""

        def draw(space: Modelspace) -> None:
            outline(space, elevation=3)
            space.add_line((0, 0, 0), (1, 1, 1), on("OUTLINE"))
            space.add_circle((0, 0), 1, on("OUTLINE", extrusion=(0, 1, 1)))
            space.add_hatch(dxfattribs=on("OUTLINE")).paths.add_polyline_path(SQUARE, is_closed=True)
            space.add_text("plan", dxfattribs=on("OUTLINE"))
            space.add_polyline3d([(0, 0, 0), (1, 0, 0), (1, 1, 5)], dxfattribs=on("OUTLINE"))
            space.add_line((1, 1), (1, 1), on("OUTLINE"))

        drawing = drawn(draw)
        assert said(drawing, "LWPOLYLINE") == [(True, "the outline, at z = 3 m, taken as 0")]
        ignored = {line.entity: line.why for line in drawing.report if not line.taken}
        assert "horizontal" in ignored["CIRCLE"]
        assert "horizontal" in ignored["POLYLINE"]
        assert "filling" in ignored["HATCH"]
        assert "text" in ignored["TEXT"]
        assert [why for _, why in said(drawing, "LINE")] == [
            "it does not lie in a horizontal plane",
            "it has no length",
        ]

    def test_a_fillet_is_no_crossing(self, drawn: Any) -> None:
        """Arcs that leave lines as tangents, with coordinates rounded to three digits, pass."""
        r, bulge = 1000.0, round(math.tan(math.pi / 8), 5)
        points = [(r, 0, 0), (5e3, 0, 0), (5e3, 3e3, 0), (0, 3e3, 0), (0, r + 0.001, bulge)]
        drawing = drawn(lambda s: s.add_lwpolyline(points, "xyb", close=True, dxfattribs=on("OUTLINE")), units=4)
        assert drawing.outline.area == pytest.approx(15 - (1 - math.pi / 4), rel=1e-5)


@pytest.mark.parametrize("x", [-1.5, -1.0, 0.0, 1.0, 2.0])
def test_a_circle_in_a_circle(drawn: Any, x: float) -> None:
    """A round opening in a round plate is found wherever it lies on the diameter that both are drawn from."""

    def draw(space: Modelspace) -> None:
        space.add_circle((0, 0), 3, on("OUTLINE"))
        space.add_circle((x, 0), 0.5, on("OUTLINE"))

    (opening,) = drawn(draw).openings
    assert opening.area == pytest.approx(math.pi / 4)


class TestUnits:
    """The drawing's unit."""

    @pytest.mark.parametrize(("code", "scale"), [(4, 1e-3), (5, 1e-2), (6, 1.0), (1, 0.0254), (2, 0.3048)])
    def test_from_the_header(self, drawn: Any, code: int, scale: float) -> None:
        """Coordinates come out in metres."""
        drawing = drawn(outline, units=code)
        assert drawing.scale == scale
        same(drawing.outline, [(x * scale, y * scale) for x, y in SQUARE])

    def test_rounded_once(self, drawn: Any) -> None:
        """700 mm is 0.7 m to the last digit."""
        drawing = drawn(lambda space: outline(space, [(0, 0), (700, 0), (700, 300), (0, 300)]), units=4)
        assert drawing.outline.points == ((0, 0), (0.7, 0), (0.7, 0.3), (0, 0.3))

    @pytest.mark.parametrize(("unit", "scale"), [("mm", 1e-3), ("in", 0.0254), ("ft", 0.3048)])
    def test_given(self, drawn: Any, unit: str, scale: float) -> None:
        """A given unit is taken if the drawing has none, and wins over another with a note."""
        assert drawn(outline, units=0, unit=unit).scale == pytest.approx(scale)
        drawing = drawn(outline, units=6, unit=unit)
        assert drawing.scale == pytest.approx(scale)
        assert "its unit is m" in said(drawing, "HEADER")[0][1]
        assert not any("its unit is" in why for _, why in said(drawn(outline, units=4, unit="mm"), "HEADER"))

    def test_unknown(self, tmp_path: Path) -> None:
        """A drawing without a unit, and a name that is none, are issues, together with the others."""
        assert "$INSUNITS: found no unit" in issues(outline, tmp_path, units=0)
        assert "unit number 11" in issues(outline, tmp_path, units=11)
        text = issues(lambda space: space.add_line((0, 0), (1, 0), on("OUTLINE")), tmp_path, unit="kN")
        assert 'found "kN"' in text
        assert "a gap" in text


class TestBlocks:
    """References to blocks."""

    @staticmethod
    def block(space: Modelspace, name: str = "SHAFT") -> Any:
        """Make a block: a right angle with a round long side, on layer 0."""
        block = document_of(space).blocks.new(name)
        points = [(0, 0, 0.0), (2, 0, 0.3), (0, 1, 0.0)]
        block.add_lwpolyline(points, "xyb", close=True, dxfattribs=on("0"))
        block.add_line((0, 0), (9, 9), on("OTHER"))
        return block

    def test_turned_and_mirrored(self, drawn: Any) -> None:
        """Content on layer 0 lies on the reference's layer; rotation and mirrored scale are followed."""

        def draw(space: Modelspace) -> None:
            outline(space, [(-9, -9), (9, -9), (9, 9), (-9, 9)])
            self.block(space)
            space.add_blockref("SHAFT", (1, 1), on("OPENINGS", rotation=90))
            space.add_blockref("SHAFT", (-1, 1), on("OPENINGS", xscale=-2, yscale=2))

        drawing = drawn(draw)
        same(drawing.openings[0], [(1, 1), (1, 3), (0, 1)], [0, 0.3, 0])
        same(drawing.openings[1], [(-1, 1), (-1, 3), (-5, 1)], [0, 0.3, 0])
        assert said(drawing, 'LWPOLYLINE in block "SHAFT"') == [(True, "opening 1"), (True, "opening 2")]
        handles = {line.handle for line in drawing.report if "block" in line.entity}
        assert len(handles) == 2
        assert "" not in handles

    def test_stretched(self, drawn: Any) -> None:
        """Arcs in a block of unequal scales become elliptic, and close all the same."""

        def draw(space: Modelspace) -> None:
            outline(space, [(-9, -9), (9, -9), (9, 9), (-9, 9)])
            self.block(space)
            space.add_blockref("SHAFT", (0, 0), on("OPENINGS", xscale=2))

        one, other = drawn(draw).openings[0].area, drawn(lambda s: self.stretched(s)).openings[0].area
        assert one == pytest.approx(2 * other, rel=1e-3)

    def stretched(self, space: Modelspace) -> None:
        """Draw the same without stretching."""
        outline(space, [(-9, -9), (9, -9), (9, 9), (-9, 9)])
        self.block(space)
        space.add_blockref("SHAFT", (0, 0), on("OPENINGS"))

    @pytest.mark.slow
    def test_nested_and_in_rows(self, drawn: Any) -> None:
        """Blocks in blocks, and rows of a block, are resolved; a layer inside a block counts."""

        def draw(space: Modelspace) -> None:
            outline(space, [(-20, -20), (20, -20), (20, 20), (-20, 20)])
            inner = document_of(space).blocks.new("INNER")
            square(inner, 0, 0, 1, "columns")
            outer = document_of(space).blocks.new("OUTER")
            outer.add_blockref("INNER", (1, 0))
            reference = space.add_blockref("OUTER", (0, 0), on("ANY"))
            reference.grid((2, 3), (5, 4))

        drawing = drawn(draw)
        corners = {column.points[0] for column in drawing.columns}
        assert corners == {(1 + 4 * i, 5 * j) for i in range(3) for j in range(2)}

    def test_blocks_that_cannot_be_resolved(self, drawn: Any, tmp_path: Path) -> None:
        """A missing block and one of nothing are reported; one in a circle is a issue."""

        def draw(space: Modelspace) -> None:
            outline(space)
            document_of(space).blocks.new("EMPTY").add_line((0, 0), (1, 1), on("OTHER"))
            space.add_blockref("EMPTY", (0, 0), on("ZONES"))
            space.add_blockref("MISSING", (0, 0), on("ZONES"))

        drawing = drawn(draw)
        assert 'INSERT block "EMPTY"' in dxf.report_text(drawing)
        whys = [line.why for line in drawing.report if line.entity.startswith("INSERT")]
        assert whys == [
            "its block has nothing on the layers that are read",
            "its block is an external file or is missing",
        ]

        def circular(space: Modelspace) -> None:
            outline(space)
            document_of(space).blocks.new("A").add_blockref("B", (0, 0))
            document_of(space).blocks.new("B").add_blockref("A", (0, 0))
            space.add_blockref("A", (0, 0), on("ZONES"))

        assert "holds itself" in issues(circular, tmp_path)


class TestRoles:
    """Which curve is what."""

    def test_each_layer(self, drawn: Any) -> None:
        """Openings, zones and columns come from their layers; a column may be a point."""

        def draw(space: Modelspace) -> None:
            outline(space)
            square(space, 1, 1, 0.5, "Openings")
            square(space, 2, 1, 1, "ZONES")
            square(space, 3, 2, 0.3, "COLUMNS")
            space.add_point((0.5, 2), on("COLUMNS"))
            space.add_point((0.5, 2), on("COLUMNS"))

        drawing = drawn(draw)
        assert [len(drawing.openings), len(drawing.zones), len(drawing.columns)] == [1, 1, 2]
        assert drawing.columns[1] == (0.5, 2.0)
        assert said(drawing, "POINT")[0] == (True, "column 2, a point")
        assert said(drawing, "POINT")[1][0] is False

    def test_own_names(self, drawn: Any) -> None:
        """Layers can be named; an empty name takes none."""

        def draw(space: Modelspace) -> None:
            square(space, 0, 0, 5, "Umriß")
            square(space, 1, 1, 1, "OPENINGS")

        drawing = drawn(draw, layers=Layers(outline="UMRIß", openings=""))
        assert drawing.outline.area == 25
        assert drawing.openings == ()

    def test_curves_inside_the_outline_on_its_layer(self, drawn: Any) -> None:
        """They are openings if the openings' layer is empty, else ignored; both is reported."""

        def draw(space: Modelspace) -> None:
            square(space, 3, 1, 1, "OUTLINE")
            square(space, 3.2, 1.2, 0.2, "OUTLINE")
            outline(space, [(0, 0), (9, 0), (9, 9), (0, 9)])

        drawing = drawn(draw)
        assert len(drawing.openings) == 1
        assert [taken for taken, _ in said(drawing, "LWPOLYLINE")].count(False) == 1

        def both(space: Modelspace) -> None:
            draw(space)
            square(space, 5, 5, 1, "OPENINGS")

        drawing = drawn(both)
        assert drawing.openings[0].points[0] == (5, 5)
        assert any("their own layer" in why for _, why in said(drawing, "LWPOLYLINE"))

    def test_hidden_layers_are_read_and_mentioned(self, drawn: Any) -> None:
        """Frozen layers and layers that are off count; the report says so."""

        def draw(space: Modelspace) -> None:
            document_of(space).layers.add("OUTLINE").freeze()
            document_of(space).layers.add("ZONES").off()
            outline(space)
            square(space, 1, 1, 1, "ZONES")

        drawing = drawn(draw)
        assert len(drawing.zones) == 1
        words = " ".join(why for _, why in said(drawing, "LAYER"))
        assert "frozen" in words
        assert "off" in words


class TestFaults:
    """What is wrong, with file, layer, entity and place."""

    def test_no_drawing(self, tmp_path: Path) -> None:
        """Missing files, folders, DWG files, text and damaged files are named."""
        (tmp_path / "a.dxf").write_text("hello\n")
        (tmp_path / "b.dxf").write_bytes(b"AC1032" + bytes(50))
        (tmp_path / "c.dxf").write_bytes(bytes(range(256)))
        whole = save(outline, tmp_path).read_text()
        (tmp_path / "d.dxf").write_text(whole[: len(whole) // 2])
        for name, words in (
            ("none.dxf", "no file"), (".", "directory"), ("a.dxf", "not DXF"), ("b.dxf", "DWG"), ("c.dxf", "not DXF"),
            ("d.dxf", "damaged"),
        ):  # fmt: skip
            with pytest.raises(InputError, match=words):
                dxf.read(tmp_path / name)

    def test_empty_layers(self, tmp_path: Path) -> None:
        """An empty outline layer is a issue with the layers that there are, and so is one asked for by name."""
        text = issues(lambda space: square(space, 0, 0, 1, "OUTLINER"), tmp_path, layers=Layers(zones="soft"))
        assert "" in text
        faults_of = text.splitlines()
        assert 'layer "OUTLINE"' in faults_of[0]
        assert "nothing on it" in faults_of[0]
        assert 'layer "soft"' in faults_of[1]

    def test_a_layer_twice_or_nameless(self, tmp_path: Path) -> None:
        """Each layer has one meaning, and the outline needs one."""
        assert "as for outline" in issues(outline, tmp_path, layers=Layers(zones="outline"))
        assert "no name" in issues(outline, tmp_path, layers=Layers(outline=""))

    def test_only_what_cannot_be_taken(self, tmp_path: Path) -> None:
        """An outline layer of text says what lies there."""
        text = issues(lambda space: space.add_text("slab", dxfattribs=on("OUTLINE")), tmp_path, units=0)
        assert "only what cannot be taken: 1 TEXT" in text
        assert "$INSUNITS" in text

    def test_gap(self, tmp_path: Path) -> None:
        """A gap is reported with its place and size in the drawing's unit, and both entities."""
        handles: list[str] = []

        def draw(space: Modelspace) -> None:
            ends = [(0, 0), (4000, 0), (4000, 3000), (0, 3000), (0, 3)]
            handles.extend(space.add_line(*pair, on("OUTLINE")).dxf.handle for pair in pairwise(ends))

        text = issues(draw, tmp_path, units=4)
        assert "plan.dxf" in text
        assert 'layer "OUTLINE"' in text
        assert f"LINE {handles[0]} and LINE {handles[3]} at (0, 0) mm: found a gap of 3 mm, to (0, 3) mm" in text

    def test_a_gap_within_the_tolerance_closes(self, drawn: Any) -> None:
        """Ends nearer than a millionth of the drawing's size are one."""

        def draw(space: Modelspace) -> None:
            space.add_lwpolyline([*SQUARE, (3e-6, 1e-6)], dxfattribs=on("OUTLINE"))

        assert len(drawn(draw).outline.points) == 4

    def test_branch_and_gaps_come_together(self, tmp_path: Path) -> None:
        """Three lines in a point, and an open opening, are reported at once."""

        def draw(space: Modelspace) -> None:
            space.add_lwpolyline([*SQUARE, (0, 0)], dxfattribs=on("OUTLINE"))
            space.add_line((0, 0), (0, -1), on("OUTLINE"))
            space.add_line((1, 1), (2, 1), on("OPENINGS"))
            space.add_arc((4, 3), 1, 0, 90, dxfattribs=on("OUTLINE"))

        text = issues(draw, tmp_path)
        assert 'layer "OPENINGS"' in text
        assert text.count("a gap of") + text.count("an open end") == 3

    def test_branch(self, tmp_path: Path) -> None:
        """Loose lines that fork are named with the place."""

        def draw(space: Modelspace) -> None:
            ends = [*SQUARE, SQUARE[0]]
            for pair in pairwise(ends):
                space.add_line(*pair, on("OUTLINE"))
            space.add_line(SQUARE[0], SQUARE[2], on("OUTLINE"))

        text = issues(draw, tmp_path)
        assert text.count("3 lines that meet in one point") == 2
        assert "(4, 3) m" in text

    def test_outlines_side_by_side(self, tmp_path: Path) -> None:
        """Two plates, and two that overlap, are distinguished."""
        text = issues(lambda space: [outline(space), square(space, 10, 0, 1, "OUTLINE")], tmp_path)
        assert "next to the outline" in text
        assert "(10, 0) m" in text
        text = issues(lambda space: [outline(space), space.add_circle((4, 1), 0.5, on("OUTLINE"))], tmp_path)
        assert "crosses or touches the outline" in text

    @pytest.mark.parametrize(
        "points",
        [
            [(0, 0, 0), (4, 3, 0), (4, 0, 0), (0, 2, 0)],  # lines cross
            [(0, 0, 0), (4, 0, 0), (4, 3, 1.0), (2, 3, 0), (0, 3, -1.5)],  # an arc crosses lines
            [(0, 0, 0), (4, 0, 0), (4, 3, 0), (2, 0, 0), (0, 3, 0)],  # a corner on an edge
            [(0, 0, 0), (6, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0)],  # a spike
            [(0, 0, 0), (2, 1, 0), (4, 0, 0), (4, 3, 0), (2, 1, 0), (0, 3, 0)],  # a corner twice
            [(0, 0, -1.0), (4, 0, 0), (4, 1.5, 0), (0, 1.5, 0)],  # an arc over the opposite edge
        ],
    )
    def test_self_crossing(self, tmp_path: Path, points: Any) -> None:
        """Curves that cross or touch themselves are reported with the place."""
        text = issues(lambda s: s.add_lwpolyline(points, "xyb", close=True, dxfattribs=on("OUTLINE")), tmp_path)
        assert "crosses or touches itself" in text
        assert " at (" in text

    def test_senseless_numbers(self, tmp_path: Path) -> None:
        """Coordinates beyond all plates are not taken."""
        text = issues(lambda space: outline(space, [(0, 0), (1e300, 0), (1e300, 1), (0, 1)]), tmp_path)
        assert "farther away" in text


class TestLoads:
    """Points, circles and blocks on the loads' layer, and what is written beside them."""

    def test_values_beside_marks(self, drawn: Any) -> None:
        """Each text goes to the nearest mark; names are kept."""

        def draw(space: Modelspace) -> None:
            outline(space)
            space.add_point((1, 1), on("LOADS"))
            space.add_circle((3, 1), 0.1, on("LOADS"))
            space.add_point((2, 2.5), on("LOADS"))
            space.add_text("250 kN", height=0.1, dxfattribs=on("LOADS", insert=(1.1, 1.1)))
            space.add_mtext("C2\\P0.1 MN", dxfattribs=on("LOADS", insert=(3.1, 1.2), char_height=0.1))
            space.add_line((1, 1), (1.1, 1.1), on("LOADS"))
            space.add_text("plan of loads", height=0.1, dxfattribs=on("LOADS", insert=(30, 30)))

        drawing = drawn(draw)
        assert [(mark.x, mark.y, mark.value, mark.text) for mark in drawing.point_loads] == [
            (1.0, 1.0, 250e3, "250 kN"),
            (3.0, 1.0, 0.1e6, "C2 0.1 MN"),
            (2.0, 2.5, None, ""),
        ]
        assert said(drawing, "LINE") == [(False, "a point load is a POINT, a CIRCLE or a block")]
        assert [taken for taken, _ in said(drawing, "TEXT")] == [True, False]
        assert said(drawing, "POINT")[1] == (True, "point load, no value")

    def test_the_end_of_a_text_may_be_nearer(self, drawn: Any) -> None:
        """Text to the left of a mark, aligned left or right, belongs to it."""

        def draw(space: Modelspace) -> None:
            outline(space, [(0, 0), (40, 0), (40, 30), (0, 30)])
            for x in (10, 16):
                space.add_point((x, 5), on("LOADS"))
            space.add_text("1200 kN", height=1, dxfattribs=on("LOADS", insert=(11, 5)))
            text = space.add_text("300 kN", height=1, dxfattribs=on("LOADS"))
            text.set_placement((9.5, 5), align=ezdxf.enums.TextEntityAlignment.RIGHT)

        assert [mark.value for mark in drawn(draw).point_loads] == [300e3, 1200e3]

    def test_attributes(self, drawn: Any) -> None:
        """The attribute that is a force is the value; a number without a unit beside it is a name."""

        def draw(space: Modelspace) -> None:
            outline(space)
            document_of(space).blocks.new("LOAD").add_circle((0, 0), 0.1)
            reference = space.add_blockref("LOAD", (1, 2), on("LOADS", rotation=30))
            reference.add_attrib("NO", "12", (1, 2))
            reference.add_attrib("P", "60 kip", (1, 2))
            space.add_point((1, 2), on("LOADS"))

        drawing = drawn(draw)
        (mark,) = drawing.point_loads
        assert (mark.x, mark.y) == (1, 2)
        assert mark.value == pytest.approx(266893.3, rel=1e-6)
        assert said(drawing, "POINT")[0][0] is False

    @pytest.mark.parametrize(
        ("text", "value"),
        [
            ("250 kN", 250e3), ("P = -2.5 MN", -2.5e6), ("C1: 10kN", 10e3), ("Load 3 250 kN", 250e3), ("C1", None),
            ("Load 3", None), ("", None), ("C1\n5 kN", 5e3),
        ],
    )  # fmt: skip
    def test_words(self, text: str, value: float | None) -> None:
        """A value may stand behind a name."""
        assert find_quantity(text) == value

    @pytest.mark.parametrize(
        "text",
        [
            "250",
            "2,500 kN",
            "P = 12",
            "250 kN/m",
            "C1 10 kN/m",
            "C1 2,500 kN",
            "100 kN + 50 kN",
            "G = 1 kN\nQ = 2 kN",
            "3 m",
        ],
    )
    def test_wrong_words(self, text: str, tmp_path: Path) -> None:
        """What is meant as a value, and is not a force, is a issue with its place."""

        def draw(space: Modelspace) -> None:
            outline(space)
            space.add_point((1, 1), on("LOADS"))
            mtext = text.replace("\n", "\\P")
            space.add_mtext(mtext, dxfattribs=on("LOADS", insert=(1.25, 1), char_height=0.1))

        found = issues(draw, tmp_path)
        assert "a force such as" in found
        assert "(1.25, 1) m" in found

    def test_values_that_fit_nowhere(self, tmp_path: Path) -> None:
        """A second value at a mark, one beside no mark, and two at the same place are issues, all at once."""

        def draw(space: Modelspace) -> None:
            outline(space)
            document_of(space).blocks.new("LOAD")
            space.add_point((1, 1), on("LOADS"))
            for x, words in ((1, "10 kN"), (1.2, "20 kN"), (30, "30 kN")):
                space.add_text(words, height=0.1, dxfattribs=on("LOADS", insert=(x, 1)))
            for words in ("40 kN", "50 kN"):
                space.add_blockref("LOAD", (3, 2), on("LOADS")).add_attrib("P", words)
            space.add_blockref("LOAD", (2, 2), on("LOADS")).add_attrib("P", "60")

        text = issues(draw, tmp_path)
        assert '"20 kN", a second value' in text
        assert '"30 kN", expected a point load' in text
        assert "40 kN and 50 kN" in text
        assert 'P = "60"' in text


def beside(space: Modelspace, layer: str, x: float, y: float, words: str) -> None:
    """Write a text on a layer."""
    space.add_text(words, height=0.1, dxfattribs=on(layer, insert=(x, y)))


class TestSpreadLoads:
    """Lines and closed curves on the layers of line and area loads, with values beside them or in the layers' names."""

    def test_line_loads(self, drawn: Any) -> None:
        """Lines, polylines, arcs and circles are line loads; each takes the text beside it, wherever along the line."""

        def draw(space: Modelspace) -> None:
            outline(space, [(-9, -9), (9, -9), (9, 9), (-9, 9)])
            space.add_line((0, 0), (4, 0), on("LOAD_LINE"))
            beside(space, "LOAD_LINE", 3, 0.1, "wall A 20 kN/m")
            space.add_lwpolyline([(-5, 0, 0.5), (-3, 0, 0.0), (-3, 3, 0.0)], "xyb", dxfattribs=on("load_line"))
            beside(space, "LOAD_LINE", -2.9, 2, "15 kN/m")
            space.add_arc((0, -4), 2, 0, 90, dxfattribs=on("LOAD_LINE"))
            beside(space, "LOAD_LINE", 1.5, -2.5, "q = 7.5 kN/m")
            space.add_circle((5, 5), 2, on("LOAD_LINE"))
            beside(space, "LOAD_LINE", 5, 7.1, "10 kN/m")
            space.add_line((7, -8), (8, -8), on("LOAD_LINE"))
            space.add_line((4, 0), (0, 0), on("LOAD_LINE"))

        drawing = drawn(draw)
        assert [(load.value, load.text) for load in drawing.line_loads] == [
            (20e3, "wall A 20 kN/m"), (15e3, "15 kN/m"), (7.5e3, "q = 7.5 kN/m"), (10e3, "10 kN/m"), (None, ""),
        ]  # fmt: skip
        assert [taken for taken, _ in said(drawing, "LINE")] == [False, True, True]
        assert (True, "line load, no value") in said(drawing, "LINE")
        assert (True, "line load of 10 kN/m") in said(drawing, "CIRCLE")
        model = casefile.loads(filled(dxf.to_case(drawing)))
        lines = [load for load in model.loads if isinstance(load, LineLoad)]
        assert [load.q for load in lines] == [20e3, 15e3, 7.5e3, 10e3, 20e3]
        lengths = [sum(edge.length for edge in load.acts[0].edges) for load in lines]
        sweep = 4 * math.atan(0.5)
        arc = 2 / (2 * math.sin(sweep / 2)) * sweep
        assert lengths == pytest.approx([4, arc + 3, math.pi, 4 * math.pi, 1])
        assert lines[3].shape == Circle(centre=(5, 5), radius=2)
        total = 80e3 + 15e3 * (arc + 3) + 7.5e3 * math.pi + 40e3 * math.pi
        assert f"line loads: 5 (sum {units.show(total, 'force')}, 1 without a value)" in dxf.report_text(drawing)

    def test_walls(self, drawn: Any) -> None:
        """Axes with the thickness beside them or in the layer's name; one without is there to be filled in."""

        def draw(space: Modelspace) -> None:
            outline(space, [(-9, -9), (9, -9), (9, 9), (-9, 9)])
            space.add_lwpolyline([(-5, -5), (5, -5), (5, 5)], dxfattribs=on("WALLS"))
            beside(space, "WALLS", 0, -4.8, "core t = 300 mm")
            space.add_circle((0, 0), 2, on("WALLS 25 cm"))
            space.add_line((7, -8), (8, -8), on("walls"))
            space.add_line((-8, 8), (8, 8), on("LOAD_LINE"))
            beside(space, "LOAD_LINE", 0, 8.1, "20 kN/m")

        drawing = drawn(draw)
        assert [(wall.value, wall.text) for wall in drawing.walls] == [
            (0.3, "core t = 300 mm"), (0.25, ""), (None, ""),
        ]  # fmt: skip
        assert (True, "wall of 250 mm, by the name of its layer") in said(drawing, "CIRCLE")
        assert "walls: 3, " in dxf.report_text(drawing)
        text = dxf.to_case(drawing)
        assert '# thickness = "250 mm"  # fill in' in text
        model = casefile.loads(filled(text))
        assert [(wall.name, wall.thickness) for wall in model.walls] == [("W1", 0.3), ("W2", 0.25), ("W3", 0.25)]
        assert model.walls[0].points == ((-5, -5), (5, -5), (5, 5))
        assert model.walls[1].shape == Circle(centre=(0, 0), radius=2)

    def test_beams(self, drawn: Any) -> None:
        """Axes with width and height beside them, along arcs too; without them they are there to be seen."""

        def draw(space: Modelspace) -> None:
            outline(space, [(-9, -9), (9, -9), (9, 9), (-9, 9)])
            space.add_line((-5, -5), (5, -5), on("BEAMS"))
            beside(space, "BEAMS", 0, -4.8, "rib 40x80 cm")
            space.add_circle((0, 0), 2, on("BEAMS"))
            beside(space, "BEAMS", 1.5, 1.5, "b/h = 0,3/0,6 m")
            space.add_line((-8, 8), (8, 8), on("beams"))
            space.add_arc((5, 5), 1, 0, 90, dxfattribs=on("BEAMS"))
            beside(space, "BEAMS", 5.8, 5.8, "30x60 cm")

        drawing = drawn(draw)
        assert "beams: 4, " in dxf.report_text(drawing)
        assert len([taken for taken, _ in said(drawing, "TEXT") if taken]) == 3
        assert (True, "beam") in said(drawing, "CIRCLE")
        text = dxf.to_case(drawing)
        assert '# section = { kind = "rectangle", width = "400 mm", height = "800 mm" }  # fill in' in text
        one, two, third, arc = casefile.loads(filled(text)).beams
        assert third.name == "B3"
        assert (one.section.width, one.section.height) == pytest.approx((0.4, 0.8))
        assert (two.section.width, two.section.height) == pytest.approx((0.3, 0.6))
        assert one.points == ((-5, -5), (5, -5))
        assert two.shape == Circle(centre=(0, 0), radius=2)
        assert arc.length == pytest.approx(math.pi / 2)

    def test_area_loads(self, drawn: Any) -> None:
        """Closed curves are area loads; one inside another is a hole, or a load of its own if it has a value."""

        def draw(space: Modelspace) -> None:
            outline(space, [(-9, -9), (9, -9), (9, 9), (-9, 9)])
            space.add_circle((0, 0), 3, on("LOAD_AREA"))
            space.add_circle((0, 0), 1, on("LOAD_AREA"))
            beside(space, "LOAD_AREA", -2, 1.5, "tank 30 kPa")
            square(space, 4, 4, 4, "LOAD_AREA")
            beside(space, "LOAD_AREA", 7, 7, "5 kN/m2")
            square(space, 5, 5, 1, "LOAD_AREA")
            beside(space, "LOAD_AREA", 5.4, 5.4, "20 kPa")
            for a, b in pairwise([(-8, -8), (-6, -8), (-6, -7), (-8, -8)]):
                space.add_line(a, b, on("LOAD_AREA"))

        drawing = drawn(draw)
        assert [(load.value, len(load.holes)) for load in drawing.area_loads] == [
            (30e3, 1), (5e3, 0), (20e3, 0), (None, 0),
        ]  # fmt: skip
        assert said(drawing, "CIRCLE") == [
            (True, "area load 1 of 30 kPa"), (True, "hole in area load 1, as it has no value"),
        ]  # fmt: skip
        assert said(drawing, "LINE") == [(True, "part of area load 4, no value")] * 3
        model = casefile.loads(filled(dxf.to_case(drawing)))
        areas = [load for load in model.loads if isinstance(load, AreaLoad)]
        assert [load.q for load in areas] == [30e3, 5e3, 20e3, 10e3]
        assert [load.acts[0].to_shapely().area for load in areas] == pytest.approx([8 * math.pi, 16, 1, 1])
        assert areas[0].holes == (Circle(radius=1),)
        assert "area loads: 4 (sum" in dxf.report_text(drawing)

    def test_values_in_the_names_of_layers(self, drawn: Any) -> None:
        """What stands behind the layer's name is the value of what has none beside it; kN_m stands for kN/m."""

        def draw(space: Modelspace) -> None:
            outline(space, [(-9, -9), (9, -9), (9, 9), (-9, 9)])
            for y, layer in enumerate(
                ("LOAD_LINE_25 kN_m", "Load_Line 25kN-m", "LOAD_LINE WALLS 25 kN_m", "LOAD_LINE_AXIS 1")
            ):
                space.add_line((0, y), (4, y), on(layer))
            space.add_line((0, 8), (4, 8), on("LOAD_LINE_25 kN_m"))
            beside(space, "LOAD_LINE_25 kN_m", 1, 8.1, "30 kN/m")
            space.add_line((0, -8), (4, -8), on("LOAD_LINEAR"))
            square(space, -8, -8, 2, "LOAD_AREA_2.5 kPa")
            square(space, -4, -8, 2, "LOAD_AREA 2.5 kN_m2")

        drawing = drawn(draw)
        assert [load.value for load in drawing.line_loads] == [25e3, 25e3, 25e3, None, 30e3]
        assert [load.value for load in drawing.area_loads] == [2.5e3, 2.5e3]
        assert said(drawing, "LINE")[0] == (True, "line load of 25 kN/m, by the name of its layer")
        assert drawing.line_loads[0].points == ((0, 0), (4, 0))

    def test_other_layers(self, drawn: Any) -> None:
        """The layers of line and area loads can be called otherwise, and must hold something then."""

        def draw(space: Modelspace) -> None:
            outline(space)
            space.add_line((1, 1), (2, 1), on("WALLS"))
            beside(space, "WALLS", 1, 1, "5 kN/m")

        (load,) = drawn(draw, layers=Layers(line_loads="walls")).line_loads
        assert load.value == 5e3
        with pytest.raises(InputError, match="entities for area loads"):
            drawn(draw, layers=Layers(area_loads="FLOOR"))

    @pytest.mark.parametrize(
        ("layer", "words", "found"),
        [
            ("LOAD_LINE", "20 kN", '"20 kN", expected a force per length such as "20 kN/m"'),
            ("LOAD_LINE", "wall 20 kPa", "it is no force per length"),
            ("LOAD_LINE", "20", '"20", expected a force per length'),
            ("LOAD_AREA", "5 kN/m", '"5 kN/m", expected a pressure'),
            ("LOAD_AREA", "5 kPa\n2 kPa", "more than one pressure"),
            ("LOAD_LINE_20", "", 'layer "LOAD_LINE_20": found "20", expected a force per length'),
            ("LOAD_AREA_5 kN", "", 'layer "LOAD_AREA_5 kN": found "5 kN", expected a pressure'),
        ],
    )
    def test_wrong_values(self, layer: str, words: str, found: str, tmp_path: Path) -> None:
        """What is meant as a value and is none of the dimension is a issue, with its text or its layer."""

        def draw(space: Modelspace) -> None:
            outline(space)
            square(space, 1, 1, 1, layer)
            if words:
                text = words.replace("\n", "\\P")
                space.add_mtext(text, dxfattribs=on(layer, insert=(1.1, 1.1), char_height=0.05))

        assert found in issues(draw, tmp_path)

    def test_values_that_fit_nowhere(self, tmp_path: Path) -> None:
        """A value beside no load, a second one, an open area and one that crosses itself are issues, all at once."""

        def draw(space: Modelspace) -> None:
            outline(space, [(-99, -99), (99, -99), (99, 99), (-99, 99)])
            space.add_line((0, 0), (1, 0), on("LOAD_LINE"))
            for x, words in ((0, "1 kN/m"), (0.1, "2 kN/m"), (50, "3 kN/m")):
                beside(space, "LOAD_LINE", x, 0.1, words)
            space.add_line((0, 9), (1, 9), on("LOAD_AREA"))
            outline(space, [(0, 20), (9, 29), (9, 20), (0, 29)], "LOAD_AREA")
            beside(space, "LOAD_AREA", 60, 60, "4 kPa")

        text = issues(draw, tmp_path)
        assert '"2 kN/m", a second value' in text or '"1 kN/m", a second value' in text
        assert '"3 kN/m", expected a line load beside the value' in text
        assert '"4 kPa", expected an area load beside the value' in text
        assert "a gap of 1 m" in text
        assert "a curve that crosses or touches itself" in text


def everything(space: Modelspace) -> None:
    """Draw something of each kind."""
    outline(space, [(0, 0, 0, 0, 0), (8, 0, 0, 0, 0.3), (8, 6, 0, 0, 0), (0, 6, 0, 0, 0)])
    space.add_circle((2, 2), 0.5, on("OPENINGS"))
    space.add_ellipse((6, 2), (1, 0.2), 0.5, dxfattribs=on("ZONES"))
    space.add_arc((5, 4), 0.4, 30, 210, dxfattribs=on("COLUMNS"))
    a, b = ((5 + 0.4 * math.cos(angle), 4 + 0.4 * math.sin(angle)) for angle in (math.radians(30), math.radians(210)))
    space.add_line(a, b, on("COLUMNS"))
    space.add_point((1, 5), on("COLUMNS"))
    block = document_of(space).blocks.new("LOAD")
    block.add_circle((0, 0), 0.1)
    space.add_blockref("LOAD", (3, 4), on("LOADS")).add_attrib("P", "70 kN", (3, 4))
    space.add_point((6, 5), on("LOADS"))
    space.add_text("250 kN", height=0.1, dxfattribs=on("LOADS", insert=(6.1, 5)))


@pytest.mark.slow
@given(
    turn=st.floats(-math.pi, math.pi),
    x=st.floats(-1000, 1000),
    y=st.floats(-1000, 1000),
    mirrored=st.booleans(),
)
@settings(max_examples=examples(15), deadline=None, derandomize=True)
def test_moving_the_drawing_moves_the_result(turn: float, x: float, y: float, mirrored: bool) -> None:
    """A drawing that is moved, turned or mirrored gives the same shapes and loads at the places moved so."""
    moved = Matrix44.scale(-1 if mirrored else 1, 1, 1) @ Matrix44.z_rotate(turn) @ Matrix44.translate(x, y, 0)

    def draw(space: Modelspace) -> None:
        everything(space)
        for entity in space:
            entity.transform(moved)

    def image(point: tuple[float, float]) -> tuple[float, float]:
        vector = moved.transform((*point, 0))
        return vector.x, vector.y

    with tempfile.TemporaryDirectory() as folder:
        before = dxf.read(save(everything, Path(folder)))
        after = dxf.read(save(draw, Path(folder)))
    assert after.outline.area == pytest.approx(before.outline.area, rel=1e-9)
    column, its_column = before.columns[0], after.columns[0]
    assert isinstance(column, Ring)
    assert isinstance(its_column, Ring)
    openings = zip(before.openings, after.openings, strict=True)
    curves = [(before.outline, after.outline), *openings, (column, its_column)]
    for one, other in curves:
        points = [image(point) for point in one.points]
        if len(points) == 2 and all(one.bulges):  # a circle may begin anywhere
            middle = [sum(values) / 2 for values in zip(*points, strict=True)]
            assert [sum(values) / 2 for values in zip(*other.points, strict=True)] == pytest.approx(middle, abs=1e-8)
            continue
        if mirrored:
            same(other, points[::-1], [*one.bulges[-2::-1], one.bulges[-1]], 1e-5)
        else:
            same(other, points, one.bulges, 1e-5)
    assert after.zones[0].area == pytest.approx(before.zones[0].area, rel=1e-2)
    for mark, its in zip(before.point_loads, after.point_loads, strict=True):
        assert (its.x, its.y) == pytest.approx(image((mark.x, mark.y)), abs=1e-8)
        assert its.value == mark.value


def filled(text: str) -> str:
    """Return a case as it is once the marks before what is to be filled in, and before all of its section, are gone."""
    return re.sub(r"^# (?=\w+ = |\[|\]|  \[)", "", text, flags=re.MULTILINE)


class TestOutput:
    """The report and the case file."""

    def test_report(self, drawn: Any) -> None:
        """Counts stand first, then what was ignored with the reason, then what was taken."""

        def draw(space: Modelspace) -> None:
            everything(space)
            space.add_text("a \x1b[31m", dxfattribs=on("ZONES"))

        text = dxf.report_text(drawn(draw))
        assert text.startswith("unit: m (1 m)\noutline: 8.9 m x 6 m")
        assert "openings: 1, zones: 1, columns: 2, walls: 0, beams: 0, point loads: 2 (sum 320 kN)" in text
        assert text.index("layer ") < text.index("ignored:") < text.index("taken:")
        assert "  ZONES     1      1\n" in text
        assert "text is read only next to point loads" in text
        assert "\x1b" not in text

    def test_case(self, drawn: Any) -> None:
        """The case is TOML with the geometry to the last digit; the rest is to be filled in."""

        def draw(space: Modelspace) -> None:
            everything(space)
            space.add_point((7, 1), on("LOADS"))

        drawing = drawn(draw)
        text = dxf.to_case(drawing, 'a "slab"\n')
        case = tomllib.loads(text)
        assert case["title"] == 'a "slab"\n'
        assert case["plate"]["outline"] == {
            "kind": "polygon",
            "points": [["0 m", "0 m"], ["8 m", "0 m"], ["8 m", "6 m"], ["0 m", "6 m"]],
            "bulges": [0.0, 0.3, 0.0, 0.0],
        }
        # the circle that is drawn
        assert case["plate"]["openings"] == [{"kind": "circle", "centre": ["2 m", "2 m"], "radius": "0.5 m"}]
        assert case["loads"] == [
            {"kind": "point", "name": "70 kN", "P": "70 kN", "x": "3 m", "y": "4 m"},
            {"kind": "point", "name": "250 kN", "P": "250 kN", "x": "6 m", "y": "5 m"},
        ]
        for words in ("# thickness", "# E", "# nu", "# [ground]", "# Zone 1", "# Column 2", '# x = "7 m"'):
            assert words in text

    def test_case_filled_in(self, drawn: Any) -> None:
        """A rectangle is a whole case once the marks before what is to be filled in are taken away."""
        text = dxf.to_case(drawn(outline), "slab")
        assert "bulges" not in text
        model = casefile.loads(filled(text))
        assert model.plate.thickness == 0.25
        assert model.plate.sides == (4.0, 3.0)
        assert model.ground.kind == "vlasov"
        (load,) = model.loads
        assert isinstance(load, UniformLoad)
        assert load.q == 6250

    def test_all_in_a_case_filled_in(self, drawn: Any) -> None:
        """Outline, openings, zones and loads of the model are the drawing's, to the nanometer, arcs included."""

        def draw(space: Modelspace) -> None:
            everything(space)
            square(space, 6, 3, 0.5, "OPENINGS")
            square(space, 4, 1, 0.5, "ZONES")
            space.add_point((7, 1), on("LOADS"))

        drawing = drawn(draw, units=5, unit="m")
        model = casefile.loads(filled(dxf.to_case(drawing, "a slab")))
        plate = model.plate
        assert plate.outline is not None
        curves = (drawing.outline, *drawing.openings, *drawing.zones)
        assert [len(drawing.openings), len(drawing.zones)] == [2, 2]
        for shape, curve in zip((plate.outline, *plate.openings, *(z.shape for z in plate.zones)), curves, strict=True):
            if isinstance(shape, Polygon):
                assert np.array(shape.points) == pytest.approx(np.array(curve.points), abs=1e-9)
                assert (shape.bulges or (0.0,) * len(curve.points)) == curve.bulges
            assert shape.ring().area == pytest.approx(curve.area, rel=1e-8)
        assert [each.kind for each in plate.openings] == ["circle", "polygon"]
        assert [zone.thickness for zone in plate.zones] == [0.4, 0.4]
        assert [(load.name, load.P, load.x, load.y) for load in model.loads if isinstance(load, PointLoad)] == [
            ("70 kN", 70e3, 3, 4),
            ("250 kN", 250e3, 6, 5),
            ("", 50e3, 7, 1),
        ]

    def test_columns_become_columns(self, drawn: Any) -> None:
        """Rectangles along x and y and circles are columns of the case; loads on them name them, moments kept."""

        def draw(space: Modelspace) -> None:
            outline(space, [(0, 0), (8, 0), (8, 6), (0, 6)])
            square(space, 4, 4, 1, "OPENINGS")
            square(space, 1.1, 1.1, 0.3, "COLUMNS")
            space.add_circle((6, 2), 0.25, on("COLUMNS"))
            turned = [(3, 1), (3.2, 1.2), (3, 1.4), (2.8, 1.2)]
            space.add_lwpolyline(turned, close=True, dxfattribs=on("COLUMNS"))
            space.add_arc((5, 1), 0.2, 0, 90, dxfattribs=on("COLUMNS"))
            space.add_lwpolyline([(5.2, 1), (5, 1), (5, 1.2)], dxfattribs=on("COLUMNS"))
            square(space, 4.3, 4.3, 0.2, "COLUMNS")
            square(space, 9, 1, 0.2, "COLUMNS")
            space.add_point((7, 5), on("COLUMNS"))
            for x, y, text in (
                (1.25, 1.25, "100 kN"),
                (6.1, 1.95, "200 kN"),
                (3, 1.2, "300 kN"),
                (6.0, 2.3, "400 kN"),
                (1.35, 1.25, ""),
                (6.0, 2.0, ""),
            ):
                space.add_point((x, y), on("LOADS"))
                if text:
                    space.add_text(text, height=0.005, dxfattribs=on("LOADS", insert=(x, y)))

        text = dxf.to_case(drawn(draw), "a slab")
        model = casefile.loads(filled(text))
        first, second, third, fourth = model.columns
        assert (first.name, first.x, first.y, first.width_x, first.width_y) == ("C1", 1.25, 1.25, 0.3, 0.3)
        assert (second.name, second.x, second.y, second.diameter) == ("C2", 6, 2, 0.5)
        assert 'width_x = "0.3 m"' in text
        loads = {load.P: load for load in model.loads if isinstance(load, PointLoad) and load.name}
        assert (loads[100e3].column, loads[100e3].M_x, loads[100e3].M_y) == ("C1", 0, 0)
        assert loads[200e3].column == "C2"
        assert (loads[200e3].M_x, loads[200e3].M_y) == pytest.approx((20e3, -10e3))
        # a square at 45 degrees, 0.2 m x 0.4 m / 2 x 2, its load at its center
        assert (third.name, third.x, third.y) == ("C3", pytest.approx(3), pytest.approx(1.2))
        assert (third.width_x, third.width_y) == pytest.approx((math.sqrt(0.08), math.sqrt(0.08)))
        assert abs(third.angle) == pytest.approx(45)
        assert fourth.diameter == pytest.approx(0.2)  # a quarter of a circle with a radius of 0.2 m
        assert (loads[300e3].column, loads[300e3].M_x, loads[300e3].M_y) == ("C3", 0, 0)
        assert (loads[400e3].column, loads[400e3].x, loads[400e3].y) == ("", 6, 2.3)
        unknown = [load for load in model.loads if isinstance(load, PointLoad) and not load.name]
        assert [(load.column, load.x) for load in unknown] == [("", 1.35), ("C2", None)]
        assert text.count("as a circle of the same area: it is no rectangle.") == 1
        assert text.count("for information only: it is not on the plate.") == 2
        assert "# Column 7 of the drawing, for information only: a point has no size." in text

    @pytest.mark.slow
    @given(turn=st.sampled_from([0, 1, 2, 3]), x=st.floats(-100, 100), y=st.floats(-100, 100))
    @settings(max_examples=examples(15), deadline=None, derandomize=True)
    def test_columns_of_a_drawing_turned_by_right_angles(self, turn: int, x: float, y: float) -> None:
        """Rectangles stay rectangles and circles circles, wherever they are drawn; widths change places."""
        moved = Matrix44.z_rotate(turn * math.pi / 2) @ Matrix44.translate(x, y, 0)

        def draw(space: Modelspace) -> None:
            outline(space, [(-5, -5), (5, -5), (5, 5), (-5, 5)])
            corners = [(1, 1), (1.4, 1), (1.4, 1.2), (1, 1.2)]
            space.add_lwpolyline(corners, close=True, dxfattribs=on("COLUMNS"))
            space.add_circle((-1, 2), 0.3, on("COLUMNS"))
            for entity in space:
                entity.transform(moved)

        with tempfile.TemporaryDirectory() as folder:
            case = tomllib.loads(dxf.to_case(dxf.read(save(draw, Path(folder)))))
        metres = [
            {key: float(value.removesuffix(" m")) for key, value in each.items() if key != "name"}
            for each in case["columns"]
        ]
        one, other = (moved.transform(place) for place in ((1.2, 1.1, 0), (-1, 2, 0)))
        widths = (0.4, 0.2) if turn % 2 == 0 else (0.2, 0.4)
        assert metres[0] == pytest.approx({"x": one.x, "y": one.y, "width_x": widths[0], "width_y": widths[1]})
        assert metres[1] == pytest.approx({"x": other.x, "y": other.y, "diameter": 0.6})
