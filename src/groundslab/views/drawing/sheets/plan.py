"""The plan that bars are drawn in: outlines, columns, walls, axes with bubbles, dimensions around it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.languages import Translator
from groundslab.model.axes.drawn import drawn_axes
from groundslab.model.model import Model
from groundslab.views.drawing.shapes import Circle, Line, Shape, Text, plan_shapes, scaled
from groundslab.views.drawing.sheets.dimensions import chain, depth_of, points_of
from groundslab.views.drawing.sheets.paper import LETTERS, Margins, Sheet, plan_area
from groundslab.views.drawing.sheets.placing import Candidate, Taken, box_of, shortened, thin_box, width_of

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Radius of the bubbles of axes, and from the slab to the first chain of dimensions and between chains [mm].
BUBBLE, FIRST, BETWEEN = 4.5, 9.0, 2.5
#: Chains along x and along y, from the inner to the outer one, each the places of its points [m].
Chains = tuple[list[list[float]], list[list[float]]]


def chains_of(model: Model, zones: Sequence[BaseGeometry]) -> Chains:
    """Return the chains of dimensions: zones between the edges of the slab, columns, and all of the slab."""
    x0, x1, y0, y1 = model.bounds
    bounds = np.array([zone.bounds for zone in zones]).reshape(-1, 4)
    columns = np.array([(column.x, column.y) for column in model.columns]).reshape(-1, 2)
    chains: Chains = ([], [])
    for axis, (low, high) in enumerate(((x0, x1), (y0, y1))):
        within = [float(place) for place in columns[:, axis] if low <= place <= high]
        for inner in (bounds[:, [axis, axis + 2]].ravel().tolist(), within):
            if inner and len(points := points_of([low, *inner, high])) > 2:
                chains[axis].append(points)
        chains[axis].append([low, high])
    return chains


def margins_of(model: Model, chains: Chains, per_meter: float) -> Margins:
    """Return what stands around the plan at a scale [mm]."""
    below, left = (
        FIRST + sum(depth_of(points, per_meter, model.units) + BETWEEN for points in chains[axis]) for axis in (0, 1)
    )
    right, above = 4.0, 4.0
    for axis in drawn_axes(model.axes, model.bounds):
        x, y = axis.points[-1]
        right = max(right, (x - model.bounds[1]) * per_meter + 2 * BUBBLE + 2.0)
        above = max(above, (y - model.bounds[3]) * per_meter + 2 * BUBBLE + 2.0)
    return Margins(left, below, right, above)


def draw_plan(model: Model, sheet: Sheet, chains: Chains, say: Translator) -> Taken:
    """Add the plan with its dimensions to a sheet; return what is taken there."""
    shapes = [
        scaled(shape, sheet.per_meter, sheet.origin) for shape in plan_shapes(model) if shape.layer != "AXES_NAMES"
    ]
    sheet.shapes.extend(shapes)
    taken = Taken(plan_area(sheet.paper), _lines_of(shapes))
    for shape in _bubbles(model, sheet):
        sheet.shapes.append(shape)
        if isinstance(shape, Text):
            x, y = shape.place
            taken.labels.append((x - BUBBLE, y - BUBBLE, x + BUBBLE, y + BUBBLE))
    for shape in _dimensions(model, sheet, chains, say):
        sheet.shapes.append(shape)
        if isinstance(shape, Text):
            taken.labels.append(box_of(shape))
        elif isinstance(shape, Line):
            taken.lines.append(thin_box(shape.points))
    for column in model.columns:
        points = scaled(Line("COLUMNS", column.ring().flat(0.05)), sheet.per_meter, sheet.origin)
        assert isinstance(points, Line)
        taken.columns.append(thin_box(points.points))
    corners, taken.columns = taken.columns, []
    for column, around in zip(model.columns, corners, strict=True):
        sheet.shapes.extend(taken.place(_around(shortened(column.name), around)))
    taken.columns = corners
    return taken


def _lines_of(shapes: Sequence[Shape]) -> BaseGeometry:
    """Return the lines of shapes as one geometry."""
    from shapely import MultiLineString

    lines = [
        np.vstack([shape.points, shape.points[:1]]) if shape.closed else shape.points
        for shape in shapes
        if isinstance(shape, Line)
    ]
    return MultiLineString(lines)


def _bubbles(model: Model, sheet: Sheet) -> Iterator[Shape]:
    """Yield the bubbles of axes at the ends of their lines, with names."""
    for axis in drawn_axes(model.axes, model.bounds):
        end = axis.points[-1] * sheet.per_meter + sheet.origin
        way: Array = np.array(axis.bubble) - axis.points[-1]
        size = float(np.hypot(*way))
        center = end + BUBBLE * (way / size if size else np.array([1.0, 0.0]))
        place = (float(center[0]), float(center[1]))
        yield Circle("AXES_NAMES", place, BUBBLE)
        name = shortened(axis.name)
        yield Text("AXES_NAMES", place, min(LETTERS, 1.7 * BUBBLE / width_of(name, 1.0)), name, centered=True)


def _dimensions(model: Model, sheet: Sheet, chains: Chains, say: Translator) -> Iterator[Shape]:
    """Yield the chains of dimensions below the plan and at its left."""
    x0, _, y0, _ = model.bounds
    for axis, low in ((0, y0), (1, x0)):
        at = sheet.origin[1 - axis] + low * sheet.per_meter - FIRST
        for points in chains[axis]:
            at -= depth_of(points, sheet.per_meter, model.units) if axis == 0 else 0.0
            yield from chain(points, axis, at, sheet.origin, sheet.per_meter, model.units, say)
            at -= BETWEEN + (depth_of(points, sheet.per_meter, model.units) if axis == 1 else 0.0)


def _around(name: str, of: tuple[float, float, float, float]) -> list[Candidate]:
    """Return where the name of something may stand: within it if there is space, and at its corners."""
    x0, y0, x1, y1 = of
    width, off = width_of(name, LETTERS), 0.8
    inside = [((x0 + x1 - width) / 2, (y0 + y1 - LETTERS) / 2)] if width + off < x1 - x0 and y1 - y0 > LETTERS else []
    places = [
        *inside, (x1 + off, y1 + off), (x0 - off - width, y1 + off), (x1 + off, y0 - off - LETTERS),
        (x0 - off - width, y0 - off - LETTERS),
    ]  # fmt: skip
    texts = [Text("LABELS", place, LETTERS, name) for place in places]
    return [Candidate((text,), box_of(text), (), number) for number, text in enumerate(texts)]
