"""Plans that are turned or far away, and walls drawn by their faces or with a width."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import ezdxf
import numpy as np
import pytest

from groundslab.cli import main
from groundslab.exchange import dxf

if TYPE_CHECKING:
    from ezdxf.layouts import Modelspace

Draw = Callable[["Modelspace"], object]
Point = tuple[float, float]
SLAB: list[Point] = [(0, 0), (6, 0), (6, 4), (0, 4)]
COLUMN: list[Point] = [(1, 1), (1.4, 1), (1.4, 1.3), (1, 1.3)]


def save(draw: Draw, folder: Path, units: int = 6) -> Path:
    """Return the path of a drawing."""
    document = ezdxf.new(units=units)
    draw(document.modelspace())
    document.saveas(folder / "plan.dxf")
    return folder / "plan.dxf"


def turned(points: list[Point], angle: float, origin: Point = (0.0, 0.0)) -> list[Point]:
    """Return points turned by an angle [degrees] about zero, then moved."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return [(origin[0] + c * x - s * y, origin[1] + s * x + c * y) for x, y in points]


def plan(angle: float, origin: Point = (0.0, 0.0)) -> Draw:
    """Return what draws a slab with a column and a wall, all turned."""

    def draw(space: Modelspace) -> None:
        space.add_lwpolyline(turned(SLAB, angle, origin), close=True, dxfattribs={"layer": "OUTLINE"})
        space.add_lwpolyline(turned(COLUMN, angle, origin), close=True, dxfattribs={"layer": "COLUMNS"})
        space.add_line(*turned([(3, 1), (3, 3)], angle, origin), dxfattribs={"layer": "WALLS 20 cm"})

    return draw


@pytest.mark.parametrize("angle", [30.0, -17.3, 44.9])
def test_a_plan_that_is_turned_is_turned_back(angle: float, tmp_path: Path) -> None:
    """Turned and far away, slab, column and wall are along x and y again, about the slab's middle."""
    path = save(plan(angle, (691_000.25, 5_334_000.5)), tmp_path)
    drawing = dxf.align(dxf.center(dxf.read(path)))
    middle = np.array([3.0, 2.0])
    np.testing.assert_allclose(drawing.outline.points, np.array(SLAB) - middle, atol=2e-8)
    np.testing.assert_allclose(drawing.columns[0].points, np.array(COLUMN) - middle, atol=2e-8)
    np.testing.assert_allclose(drawing.walls[0].points, [(0, -1), (0, 1)], atol=2e-8)
    assert drawing.turned == pytest.approx(angle)
    text = dxf.to_case(drawing)
    (column,) = tomllib.loads(text)["columns"]
    widths = [float(column[key].removesuffix(" m")) for key in ("width_x", "width_y")]
    assert widths == pytest.approx([0.4, 0.3], abs=1e-7)
    assert f"turned by {angle:.6g}"[:14] in text
    assert "angle" not in column
    # without that, or beside a slab of another direction, the column has the angle
    (column,) = tomllib.loads(dxf.to_case(dxf.center(dxf.read(path))))["columns"]
    assert column["angle"] == pytest.approx(angle, abs=1e-6)


def test_a_plan_along_x_and_y_is_left(tmp_path: Path) -> None:
    """What runs along x and y is not turned, nor is a round slab."""
    drawing = dxf.read(save(plan(0.0), tmp_path))
    assert dxf.align(drawing) is drawing

    def draw_circle(space: Modelspace) -> None:
        space.add_circle((0, 0), 3, {"layer": "OUTLINE"})

    drawing = dxf.read(save(draw_circle, tmp_path))
    assert dxf.align(drawing) is drawing


def test_the_command_centers_and_aligns(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """`groundslab dxf --origin center --align` says in the case from where and along what coordinates are measured."""
    path = save(plan(30.0, (100.0, 50.0)), tmp_path)
    assert main.main(["dxf", str(path), "--origin", "center", "--align"]) == 0
    text = capsys.readouterr().out
    assert "The x axis is turned by 30 degrees from the drawing's." in text
    assert "width_x" in text


@pytest.mark.parametrize("angle", [0.0, 25.0])
def test_walls_drawn_by_their_faces(angle: float, tmp_path: Path) -> None:
    """A closed strip without a thickness is a wall along its middle; a core is left as a line."""

    def draw(space: Modelspace) -> None:
        on = {"layer": "WALLS"}
        space.add_lwpolyline(turned([(-9, -9), (9, -9), (9, 9), (-9, 9)], angle), close=True,
                             dxfattribs={"layer": "OUTLINE"})  # fmt: skip
        space.add_lwpolyline(turned([(1, 1), (5, 1), (5, 1.25), (1, 1.25)], angle), close=True, dxfattribs=on)
        space.add_lwpolyline(turned([(-5, -5), (-2, -5), (-2, -1), (-5, -1)], angle), close=True, dxfattribs=on)

    strip, core = dxf.read(save(draw, tmp_path)).walls
    np.testing.assert_allclose(sorted(strip.points), sorted(turned([(1, 1.125), (5, 1.125)], angle)), atol=1e-12)
    assert strip.value == pytest.approx(0.25, abs=1e-12)
    assert (len(core.points), core.value) == (4, None)


def test_a_hatch_may_be_the_faces_of_a_wall(tmp_path: Path) -> None:
    """A filled strip is a wall along its middle, too."""

    def draw(space: Modelspace) -> None:
        space.add_lwpolyline(SLAB, close=True, dxfattribs={"layer": "OUTLINE"})
        hatch = space.add_hatch(dxfattribs={"layer": "WALLS"})
        hatch.paths.add_polyline_path([(1, 1), (1.2, 1), (1.2, 3), (1, 3)], is_closed=True)

    (wall,) = dxf.read(save(draw, tmp_path)).walls
    assert sorted(wall.points) == [pytest.approx((1.1, 1)), pytest.approx((1.1, 3))]
    assert wall.value == pytest.approx(0.2)


@pytest.mark.parametrize("kind", ["LWPOLYLINE", "widths of points", "POLYLINE", "block"])
def test_walls_drawn_with_a_width(kind: str, tmp_path: Path) -> None:
    """The width of a polyline is the thickness, in the drawing's unit; a text next to it would win."""

    def add(space: Any, size: float) -> None:
        points = [(1000 * size, 1000 * size), (3000 * size, 1000 * size)]
        if kind == "POLYLINE":
            wall = {"layer": "WALLS", "default_start_width": 240 * size, "default_end_width": 240 * size}
            space.add_polyline2d(points, dxfattribs=wall)
        elif kind == "widths of points":
            space.add_lwpolyline([(x, y, 240, 240) for x, y in points], "xyse", dxfattribs={"layer": "WALLS"})
        else:
            wall = {"layer": "WALLS", "const_width": 240 * size}
            space.add_lwpolyline(points, dxfattribs=wall)

    def draw(space: Modelspace) -> None:
        corners = [(1000 * x, 1000 * y) for x, y in SLAB]
        space.add_lwpolyline(corners, close=True, dxfattribs={"layer": "OUTLINE"})
        if kind == "block":
            add(space.doc.blocks.new("WALL"), 0.5)
            space.add_blockref("WALL", (0, 0), {"xscale": 2, "yscale": 2, "zscale": 2})
        else:
            add(space, 1.0)

    (wall,) = dxf.read(save(draw, tmp_path, units=4)).walls
    assert wall.points == ((1, 1), (3, 1))
    assert wall.value == pytest.approx(0.24)


def test_columns_in_turned_blocks_keep_their_place_and_size(tmp_path: Path) -> None:
    """A block turned by 90 degrees is a rectangle with its sides exchanged, one turned by 30 has that angle."""

    def draw(space: Modelspace) -> None:
        space.add_lwpolyline(SLAB, close=True, dxfattribs={"layer": "OUTLINE"})
        block = space.doc.blocks.new("C")
        block.add_lwpolyline([(-0.2, -0.15), (0.2, -0.15), (0.2, 0.15), (-0.2, 0.15)], close=True,
                             dxfattribs={"layer": "COLUMNS"})  # fmt: skip
        for x, angle in ((1.0, 90.0), (3.0, 30.0)):
            space.add_blockref("C", (x, 2.0), {"rotation": angle})

    text = dxf.to_case(dxf.read(save(draw, tmp_path)))
    first, second = tomllib.loads(text)["columns"]
    assert [float(first[key].removesuffix(" m")) for key in ("x", "y", "width_x", "width_y")] == pytest.approx(
        [1, 2, 0.3, 0.4]
    )
    widths = [float(second[key].removesuffix(" m")) for key in ("width_x", "width_y")]
    assert (*widths, second["angle"]) == pytest.approx((0.4, 0.3, 30))
