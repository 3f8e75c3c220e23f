"""Walls of every kind, and what stands on them: mirrored, turned and scaled slabs have such results."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from groundslab.analysis.driver import solve
from groundslab.arrays import Array
from groundslab.errors import InputError
from groundslab.model.loads.acting import LineForce
from groundslab.model.loads.clipping import integral
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.load_types import UniformLoad
from groundslab.model.loads.spreading import spread_line
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.settings import Contact, Mesh
from groundslab.model.shapes import AnyShape, Circle, Polygon, Rectangle
from groundslab.model.structure.walls import Wall
from groundslab.results.results import CombinationResult
from helpers.examples import examples
from helpers.similar import rescale
from helpers.strategies import load_on_wall, walls

PLATE = Plate(length_x=6.0, length_y=4.0, thickness=0.25, E=30e9, nu=0.2)
FEW = settings(derandomize=True, deadline=None, database=None, suppress_health_check=list(HealthCheck))
Place = tuple[float, float]
SAME = 1e-6  # of the largest value


def model(stand: list[Wall], loads: list[Any], plate: Plate = PLATE, counts: tuple[int, int] = (6, 4)) -> Model:
    """Return a slab on ground that can pull, so that there is a result whatever acts, with a weight."""
    return Model(
        plate=plate,
        ground={"kind": "pasternak", "k0": 30e6, "k1": 20e6},
        contact=Contact(tensionless=False),
        walls=stand,
        loads=[UniformLoad(q=1e3), *loads],
        mesh=Mesh(counts=counts),
    )


@st.composite
def loaded_walls(draw: st.DrawFn) -> tuple[list[Wall], list[LineLoad | LineMoment]]:
    """Return one or two walls, each with a force or a moment along it."""
    stand = draw(walls(PLATE, ["A", "B"][: draw(st.integers(1, 2))]))
    sizes = st.floats(1e3, 2e5) | st.floats(-2e5, -1e3)
    return stand, [draw(load_on_wall(wall, draw(sizes), draw(st.none() | sizes))) for wall in stand]


def mirrored_shape(shape: AnyShape) -> AnyShape:
    """Return a shape with x turned round."""
    if isinstance(shape, Rectangle):
        return Rectangle(x=(-shape.x[1], -shape.x[0]), y=shape.y)
    if isinstance(shape, Circle):
        return Circle(centre=(-shape.centre[0], shape.centre[1]), radius=shape.radius)
    return Polygon(points=[(-x, y) for x, y in shape.points], bulges=[-bulge for bulge in shape.bulges])


def mirrored(wall: Wall, load: LineLoad | LineMoment) -> tuple[Wall, LineLoad | LineMoment]:
    """Return a wall with x turned round, and the load with what stands on it then.

    Along edges walls run counterclockwise in the image, too: their ends are swapped. Lines keep theirs, and have to the
    left what was to the right; rectangles and circles have the inside to the left in any case.
    """
    value, end = ("m", "m_end") if isinstance(load, LineMoment) else ("q", "q_end")
    start, last = getattr(load, value), getattr(load, end)
    if wall.edge is not None:
        words = {"left": "right", "right": "left", 2: "left", 4: "right", 1: "bottom", 3: "top"}
        image = wall.replace(edge=words.get(wall.edge, wall.edge))
        return image, load if last is None else load.replace(**{value: last, end: start})
    if wall.shape is not None:
        image = wall.replace(shape=mirrored_shape(wall.shape))
        turns = isinstance(wall.shape, Polygon)
    else:
        image = wall.replace(points=[(-x, y) for x, y in wall.points], bulges=[-bulge for bulge in wall.bulges])
        turns = True
    if isinstance(load, LineMoment) and turns:
        return image, load.replace(m=-start, m_end=None if last is None else -last)
    return image, load


def turned_shape(shape: AnyShape) -> AnyShape:
    """Return a shape turned by 90 degrees."""
    if isinstance(shape, Rectangle):
        return Rectangle(x=(-shape.y[1], -shape.y[0]), y=shape.x)
    if isinstance(shape, Circle):
        return Circle(centre=(-shape.centre[1], shape.centre[0]), radius=shape.radius)
    return Polygon(points=[(-y, x) for x, y in shape.points], bulges=shape.bulges)


def turned(wall: Wall) -> Wall:
    """Return a wall turned by 90 degrees, (x, y) -> (-y, x)."""
    if wall.edge is not None:
        words = {"left": "bottom", "bottom": "right", "right": "top", "top": "left", 1: 2, 2: 3, 3: 4, 4: 1}
        return wall.replace(edge=words.get(wall.edge, wall.edge))
    if wall.shape is not None:
        return wall.replace(shape=turned_shape(wall.shape))
    return wall.replace(points=[(-y, x) for x, y in wall.points])


def at(results: CombinationResult, places: Array, field: str) -> Array:
    """Return a field of the plate at its nodes that lie at places (p, 2)."""
    distance = np.linalg.norm(results.plate.nodes[None] - places[:, None], axis=2)
    assert distance.min(axis=1).max() < 1e-9
    values: Array = getattr(results.plate, field)[distance.argmin(axis=1)]
    return values


def assert_same(one: Array, other: Array) -> None:
    """Hold two fields to each other, measured by the larger one."""
    np.testing.assert_allclose(one, other, atol=SAME * max(np.abs(one).max(), np.abs(other).max(), 1e-12))


@pytest.mark.slow
@settings(FEW, max_examples=examples(14))
@given(loaded_walls())
def test_mirror_image(loaded: tuple[list[Wall], list[Any]]) -> None:
    """The mirror image of walls and loads has the mirror image as solution."""
    images = [mirrored(wall, load) for wall, load in zip(*loaded, strict=True)]
    one = solve(model(*loaded)).only
    image = solve(model([wall for wall, _ in images], [load for _, load in images])).only
    there = one.plate.nodes * [-1.0, 1.0]
    odd = {"rotation_x", "shear_x", "moment_xy"}
    for field in ("settlement", "rotation_x", "rotation_y", "moment_x", "moment_y", "moment_xy", "shear_x"):
        assert_same(getattr(one.plate, field), (-1.0 if field in odd else 1.0) * at(image, there, field))


@pytest.mark.slow
@settings(FEW, max_examples=examples(14))
@given(loaded_walls())
def test_quarter_turn(loaded: tuple[list[Wall], list[Any]]) -> None:
    """Turned by 90 degrees plate, walls and mesh have the turned solution; the loads stay as they are."""
    plate = PLATE.model_copy(update={"length_x": 4.0, "length_y": 6.0})
    one = solve(model(*loaded)).only
    image = solve(model([turned(wall) for wall in loaded[0]], loaded[1], plate, (4, 6))).only
    there = np.column_stack([-one.plate.nodes[:, 1], one.plate.nodes[:, 0]])
    pairs = {
        "settlement": ("settlement", 1), "rotation_x": ("rotation_y", 1), "rotation_y": ("rotation_x", -1),
        "moment_x": ("moment_y", 1), "moment_y": ("moment_x", 1), "moment_xy": ("moment_xy", -1),
        "shear_x": ("shear_y", 1),
    }  # fmt: skip
    for field, (other, sign) in pairs.items():
        assert_same(getattr(one.plate, field), sign * at(image, there, other))


@pytest.mark.slow
@settings(FEW, max_examples=examples(8))
@given(loaded_walls(), st.sampled_from([0.1, 30.0]), st.sampled_from([0.01, 1e3]))
def test_other_units(loaded: tuple[list[Wall], list[Any]], lengths: float, forces: float) -> None:
    """Lengths and forces times numbers give settlements times that of lengths, moments times that of forces."""
    one = solve(model(*loaded)).only
    other = solve(rescale(model(*loaded), lengths, forces)).only
    assert_same(lengths * one.plate.settlement, other.plate.settlement)
    assert_same(forces * one.plate.moment_x, other.plate.moment_x)


@settings(FEW, max_examples=examples(200))
@given(loaded_walls())
def test_nothing_of_what_stands_on_a_wall_is_lost(loaded: tuple[list[Wall], list[Any]]) -> None:
    """Spread over its thickness or along its axis, the force is what its load per length makes on its length."""
    try:
        m = model(*loaded)
    except InputError as error:
        raise AssertionError(loaded) from error
    for load, wall in zip(m.loads[1:], m.placed_walls, strict=True):
        if not isinstance(load, LineLoad):
            continue
        force = 0.0
        for shape in (shape for acting, shape in m.acting if acting is load):  # beside doors several
            assert isinstance(shape, LineForce)
            along, areas = spread_line(m.plate, shape)
            force += sum(piece.force for piece in along) + sum(integral(area, pressure) for area, pressure in areas)
        ends = load.q, load.q if load.q_end is None else load.q_end
        scale = max(map(abs, ends)) * wall.length
        assert force == pytest.approx(sum(ends) / 2 * wall.length, abs=1e-9 * scale)
