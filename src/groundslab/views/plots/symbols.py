"""Marks on a plan: outline, openings, zones, border of contact, loads, columns, supports, extremes.

Each function that makes entries for the legend returns them by their words.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.design.bars.bar_layout import bar_sets
from groundslab.fem.mesh import SIDES
from groundslab.geometry.plan import DRAWN_CHORD
from groundslab.model.axes.drawn import drawn_axes
from groundslab.model.loads.acting import AreaPressure, LineForce, PlateAction, PointForce
from groundslab.model.plates.pits import pits_of
from groundslab.views.plots.contours import MOST_ELEMENTS
from groundslab.views.plots.style import GREY, GROUND, INK, LOAD, SMALL, SUPPORT, white_outline

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.patches import Polygon
    from matplotlib.tri import Triangulation
    from shapely.geometry.base import BaseGeometry

    from groundslab.arrays import Array, Integers
    from groundslab.model.loads.load_types import AnyLoad
    from groundslab.model.model import Model
    from groundslab.model.plates.other_plates import AnyPlate

    Entries = dict[str, Any]

#: Width of the sides of elements [pt]: a share of their length on paper [mm], within limits.
LINE_SHARE, LINE_WIDTHS = 0.12, (0.05, 0.4)


def draw_plate(axes: Axes, model: Model, fill: str = "none") -> Entries:
    """Draw the outlines, filled if a color is given, the openings crossed out, and the zones."""
    chord = DRAWN_CHORD * max(model.sides)
    entries: Entries = {}
    for plate in model.every_plate:
        entries |= _draw_one_plate(axes, plate, chord, fill)
    return entries


def _draw_one_plate(axes: Axes, plate: AnyPlate, chord: float, fill: str) -> Entries:
    """Draw the outline of a plate, its openings crossed out, its zones and pits; return the entries in the legend."""
    import shapely

    outline = plate.ring().polygon(chord)
    around = np.asarray(outline.exterior.coords)
    draw_ring(axes, around, edgecolor=INK, linewidth=1.2, zorder=4)
    if fill != "none":
        draw_ring(axes, around, facecolor=fill, edgecolor="none", zorder=1)
    entries: Entries = {}
    for opening in plate.openings:
        hole = opening.ring().polygon(chord)
        draw_ring(axes, np.asarray(hole.exterior.coords), edgecolor=INK, facecolor="white", linewidth=0.8, zorder=4)
        for a, b in _diagonals(np.asarray(hole.exterior.coords)):
            axes.plot(*zip(a, b, strict=True), color=INK, linewidth=0.4, zorder=4.1)
    for zone in plate.zones:
        part = zone.shape.ring().polygon(chord).intersection(outline)
        for piece in (piece for piece in shapely.get_parts(part) if piece.geom_type == "Polygon"):
            look = {"edgecolor": GREY, "linewidth": 0.8, "linestyle": (0, (6, 2, 1, 2)), "zorder": 3.5}
            entries["zone"] = draw_ring(axes, np.asarray(piece.exterior.coords), **look)
    for pit in pits_of(plate):
        for face in pit.faces(chord):
            entries["wall of a pit"] = draw_ring(axes, face, edgecolor=INK, linewidth=0.6, zorder=3.6)
    return entries


def draw_bar_zones(axes: Axes, model: Model, layer: str) -> Entries:
    """Outline the zones of further bars of a layer, as far as the plate reaches."""
    import shapely

    entries: Entries = {}
    for bar_set in bar_sets(model):
        for piece in shapely.get_parts(bar_set.region) if bar_set.zone and bar_set.layer == layer else ():
            if piece.geom_type == "Polygon":
                look = {"edgecolor": LOAD, "linewidth": 0.9, "linestyle": (0, (4, 2)), "zorder": 3.6}
                entries["zone of further bars"] = draw_ring(axes, np.asarray(piece.exterior.coords), **look)
    return entries


def draw_elements(axes: Axes, nodes: Array, elements: Integers, per_meter: float, color: str = INK) -> Entries:
    """Draw the sides of nine-node elements (m, 9), each once, on a drawing of so many millimeters for a meter."""
    side = per_meter * float(np.sqrt(np.prod(np.ptp(nodes, axis=0)) / len(elements)))
    sides = elements[:, SIDES].reshape(-1, 3)[:, [0, 2, 1]]
    _, first = np.unique(sides[:, 1], return_index=True)
    ends = np.full((len(first), 1, 2), np.nan)  # where the pen is lifted
    path = np.concatenate([nodes[sides[first]], ends], axis=1).reshape(-1, 2)
    width = float(np.clip(LINE_SHARE * side, *LINE_WIDTHS))
    (lines,) = axes.plot(*path.T, color=color, linewidth=width, zorder=2.5, solid_capstyle="butt")
    lines.set_rasterized(len(elements) > MOST_ELEMENTS)
    return {"element": lines}


def draw_contact_boundary(axes: Axes, triangles: Triangulation, contact: Array | None) -> Entries:
    """Draw the line where the contact function (n,) is zero, if it is anywhere."""
    from matplotlib.lines import Line2D

    if contact is None or not (contact > 0).any() or not (contact < 0).any():
        return {}
    line = axes.tricontour(triangles, contact, levels=[0.0], colors=INK, linewidths=1.3, zorder=3)
    line.set(path_effects=white_outline(2.8))
    return {"contact boundary": Line2D([], [], color=INK, linewidth=1.3)}


def hatch_uplift(axes: Axes, triangles: Triangulation, contact: Array | None) -> Entries:
    """Hatch in white where the plate has lifted."""
    from matplotlib.patches import Patch

    if contact is None or not (contact > 0).any():
        return {}
    area = axes.tricontourf(triangles, contact, levels=[0.0, np.inf], colors=["white"], zorder=2)
    area.set(hatch="////", edgecolor=GREY, linewidth=0.0)
    return {"no contact": Patch(facecolor="white", edgecolor=GREY, hatch="////", linewidth=0.0)}


def draw_voids(axes: Axes, model: Model) -> Entries:
    """Outline the parts where the ground lies deeper or is missing."""
    entries: Entries = {}
    for void in model.contact.voids:
        around = np.asarray(void.to_shapely(DRAWN_CHORD * max(model.sides)).exterior.coords)
        look = {"edgecolor": GROUND, "linewidth": 0.9, "linestyle": (0, (1.5, 1.5)), "zorder": 3.2}
        entries["void in the ground"] = draw_ring(axes, around, **look)
    return entries


def draw_loads(
    axes: Axes, model: Model, takes_part: Callable[[AnyLoad], bool] = lambda _: True, everywhere: bool = True
) -> Entries:
    """Outline the loaded areas, draw line loads and mark point loads beside columns, those that take part.

    With `everywhere` a plate that is loaded all over is outlined, too.
    """
    entries: Entries = {}
    chord = DRAWN_CHORD * max(model.sides)
    for load, shape in model.acting:
        if not takes_part(load):
            continue
        if isinstance(shape, PointForce) and not getattr(load, "column", ""):
            (mark,) = axes.plot(*shape.place, "v", color=LOAD, markeredgecolor="white", markersize=6.5, zorder=5.5)
            mark.set(linestyle="none", clip_on=False, markeredgewidth=0.5)
            entries["point load"] = mark
        elif isinstance(shape, LineForce) and not shape.wall:
            (line,) = axes.plot(*shape.flat(chord).T, color=LOAD, linewidth=1.6, clip_on=False, zorder=5)
            line.set(path_effects=white_outline(2.6))
            entries["line load" if any(shape.q) else "line moment"] = line
        elif isinstance(shape, PlateAction) and shape.presses and everywhere:
            look = {"edgecolor": LOAD, "linewidth": 0.9, "linestyle": (0, (3, 5)), "zorder": 4.5}
            for plate in (plate for plate in model.every_plate if shape.plate in ("", plate.name)):
                entries["load on the entire plate"] = draw_ring(axes, np.array(plate.ring().flat(chord)), **look)
        elif isinstance(shape, AreaPressure):
            # on the ground, which may reach far, as much as there is room for
            look = {"edgecolor": LOAD, "linewidth": 1.2, "linestyle": (0, (4, 2)), "zorder": 4.5}
            look |= {"edgecolor": GROUND, "clip_on": True} if shape.on == "ground" else {}
            for ring in _borders(shape.to_shapely()):
                words = "load on the ground" if shape.on == "ground" else "loaded area"
                entries[words] = draw_ring(axes, ring, **look)
    return entries


def _borders(area: BaseGeometry) -> list[Array]:
    """Return the curves (k, 2) around the polygons of an area and around their holes."""
    from shapely import get_coordinates, get_parts

    return [get_coordinates(ring) for part in get_parts(area) for ring in (part.exterior, *part.interiors)]


def load_filter(factors: Iterable[tuple[str, float]]) -> Callable[[AnyLoad], bool]:
    """Return whether a load takes part where its case has a factor that is not 0; all do where there are no cases."""
    by_case = dict(factors)
    return lambda load: not by_case or bool(by_case.get(load.case))


def draw_columns(axes: Axes, model: Model, takes_part: Callable[[AnyLoad], bool]) -> Entries:
    """Draw the columns, those filled that bring a load."""
    entries: Entries = {}
    loaded = {load.column for load in model.loads if load.kind == "point" and load.column and takes_part(load)}
    for column in model.columns:
        around = np.array(column.ring().flat(DRAWN_CHORD * max(model.sides)))
        brings = column.name in loaded
        drawn = draw_ring(axes, around, edgecolor=INK, facecolor=LOAD if brings else "white", linewidth=0.6, zorder=5)
        entries["column with load" if brings else "column"] = drawn
    return entries


def draw_walls(axes: Axes, model: Model, takes_part: Callable[[AnyLoad], bool]) -> Entries:
    """Draw the walls, those filled that bring a load."""
    entries: Entries = {}
    loaded = {shape.wall for load, shape in model.acting if isinstance(shape, LineForce) and takes_part(load)}
    for wall in model.placed_walls:
        brings = wall.name in loaded
        look = {"edgecolor": INK, "facecolor": LOAD if brings else "white", "linewidth": 0.6, "zorder": 4.8}
        for piece in wall.pieces:
            area = piece.area(DRAWN_CHORD * max(model.sides))
            entries["wall with load" if brings else "wall"] = _draw_area(axes, area, **look)
    return entries


def draw_axes(axes: Axes, model: Model) -> None:
    """Draw the axes of the building, each with its name in a bubble."""
    from matplotlib.patches import Circle

    for axis in drawn_axes(model.axes, model.bounds):
        look: dict[str, Any] = {"color": GREY, "linewidth": 0.4, "clip_on": False}
        axes.plot(*axis.points.T, linestyle=(0, (12, 2, 2, 2)), zorder=3.4, **look)
        bubble = Circle(axis.bubble, axis.radius, edgecolor=GREY, facecolor="white", linewidth=0.4, zorder=6)
        axes.add_patch(bubble).set_clip_on(False)
        letters: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": SMALL, "color": INK, "zorder": 6.1}
        axes.text(*axis.bubble, axis.name, parse_math=False, **letters)


def draw_beams(axes: Axes, model: Model) -> Entries:
    """Draw the beams by their broken edges; those without a width by their axes."""
    entries: Entries = {}
    look = {"edgecolor": INK, "facecolor": "none", "linewidth": 0.6, "linestyle": (0, (5, 2)), "zorder": 4.6}
    for beam in model.beams:
        entries["beam"] = _draw_area(axes, beam.area(DRAWN_CHORD * max(model.sides)), **look)
    return entries


def draw_building(axes: Axes, model: Model) -> Entries:
    """Draw the beams of the building above by dotted lines from base to base."""
    entries: Entries = {}
    for line in model.building_lines:
        (entries["beam of the building"],) = axes.plot(
            *np.transpose(line), color=INK, linewidth=0.8, linestyle=(0, (1, 2)), zorder=4.5, clip_on=False
        )
    return entries


def _draw_area(axes: Axes, area: BaseGeometry, **look: Any) -> Any:
    """Draw an area with its holes."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    curves = [Path(around, closed=True) for around in _borders(area)]
    patch = PathPatch(Path.make_compound_path(*curves), clip_on=False, joinstyle="miter", **look)
    axes.add_patch(patch)
    return patch


def draw_supports(axes: Axes, model: Model) -> Entries:
    """Mark supports at points by triangles, those along lines and held edges by thick lines."""
    entries: Entries = {}
    for support in model.supports:
        if not support.edges:
            (mark,) = axes.plot(*support.points[0], "^", color=SUPPORT, markeredgecolor="white", markersize=6.5)
            mark.set(linestyle="none", clip_on=False, zorder=5.4, markeredgewidth=0.5)
            entries["support"] = mark
        else:
            entries["line support"] = _draw_supported_line(axes, np.array(support.points))
    for edge in supported_edges(model):
        entries["supported edge"] = _draw_supported_line(axes, edge)
    return entries


def _draw_supported_line(axes: Axes, places: Array) -> Any:
    """Draw a line (k, 2) along which the plate is held."""
    (line,) = axes.plot(*places.T, color=SUPPORT, linewidth=2.4, clip_on=False, zorder=4.4)
    line.set(path_effects=white_outline(3.6))
    return line


def supported_edges(model: Model) -> list[Array]:
    """Return the parts (k, 2) of the outline that are held: all of it, or what lies on a side that is held."""
    flat = model.plate.ring().flat(DRAWN_CHORD * max(model.sides))
    closed = np.vstack([flat, flat[:1]])
    if model.plate.support != "free":
        return [closed]
    x0, x1, y0, y1 = model.plate.bounds
    near = 1e-9 * max(model.sides)
    sides = {"left": (0, x0), "right": (0, x1), "bottom": (1, y0), "top": (1, y1)}
    supported = [line for side, line in sides.items() if getattr(model.plate.edges, side) != "free"]
    return [
        np.array([a, b])
        for axis, where in supported
        for a, b in pairwise(closed)
        if abs(a[axis] - where) <= near and abs(b[axis] - where) <= near
    ]


def draw_ring(axes: Axes, around: Array, **look: Any) -> Polygon:
    """Draw a closed curve (k, 2), not filled unless a color is given."""
    from matplotlib.patches import Polygon

    usual: dict[str, Any] = {"facecolor": "none", "clip_on": False, "joinstyle": "miter"}
    drawn = Polygon(around, **(usual | look))
    axes.add_patch(drawn)
    return drawn


def _diagonals(around: Array) -> list[tuple[Array, Array]]:
    """Return the two lines that cross out an opening: through its outermost corners."""
    if len(around) != 5:
        low, high = around.min(axis=0), around.max(axis=0)
        middle, half = (low + high) / 2, (high - low) / np.sqrt(8)
        around = middle + half * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    return [(around[0], around[2]), (around[1], around[3])]
