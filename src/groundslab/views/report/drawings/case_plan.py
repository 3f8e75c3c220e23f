"""The plan of a case before it is solved: plate, ground, structure, supports, loads and outputs, with dimensions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.messages import Message, Name, joined
from groundslab.model.axes.drawn import drawn_axes
from groundslab.unit_systems import in_system
from groundslab.units import UNITS
from groundslab.views.plots import style, symbols
from groundslab.views.plots.annotations import LabelPlacement, Point, zone_label
from groundslab.views.scene.plan import plan_of
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.languages import Translator
    from groundslab.model.model import Model
    from groundslab.model.structure.columns import Column
    from groundslab.model.structure.walls import WallPiece
    from groundslab.unit_systems import System

    Data = dict[str, Any]

#: Largest width and height of what is drawn, space beside it, for the directions of x and y, and the least width [mm].
WIDTH, HEIGHT, RIGHT, TOP, DIRECTIONS, NARROW = 148.0, 88.0, 7.0, 7.0, 11.0, 100.0
#: What lies further off the plate than so many times its longer side is named, not drawn.
REACH = 0.5
#: Stops of a chain of dimensions are this far apart at least, and chains from one another [mm].
LEAST_DIMENSION, CHAIN = 5.0, 5.0
#: Of more loads than these none is labeled, and of more columns none has its sides.
MOST_LABELS, MOST_SIZES = 60, 60
#: A line that leaves an axis by less of its length runs along it.
SAME = 1e-6
#: The sides of the lower left corner of a plate on which its thickness may stand.
WITHIN: tuple[Point, ...] = ((1, 1), (1, 3), (3, 1), (3, 3), (1, 6), (6, 1))
#: The same of the upper left corner of a zone.
BELOW: tuple[Point, ...] = ((1, -1), (1, -3), (1, 1), (-1, -1), (-1, 1))
#: The sides of a place on which its label may stand, the better ones first.
SIDES: tuple[Point, ...] = ((1, 0), (-1, 0), (1, -1), (-1, -1), (1, 1), (-1, 1), (0, 1), (0, -1))


def draw_case_plan(model: Model, placed: Model) -> Figure:
    """Return the plan of a case as written, with the loads of the case as solved; what lies far away is left out."""
    plan = plan_of(model)
    near = nearby(plan)
    (x0, y0), (x1, y1) = near.min(axis=0), near.max(axis=0)
    per_meter = min(WIDTH / (x1 - x0), HEIGHT / (y1 - y0))
    width, height = (x1 - x0) * per_meter, (y1 - y0) * per_meter
    chains = [_chains(model, axis, per_meter) for axis in (0, 1)]
    below, left = (CHAIN * len(rows) + DIRECTIONS for rows in chains)
    page = style.Page(max(left + width + RIGHT, NARROW), words_of(model))
    axes = page.add_axes(left, TOP, width, height)
    axes.set(xlim=(x0, x1), ylim=(y0, y1))
    axes.set_axis_off()
    labels = Labels(axes, per_meter, (x0, x1, y0, y1), page.say)
    for column in plan["columns"]:
        labels.reserve((column["x"], column["y"]), _reach(column["ring"], per_meter))
    labels.reserve(((x0 + x1) / 2, y0 - (below - DIRECTIONS) / 2 / per_meter), (width / 2, (below - DIRECTIONS) / 2))
    labels.reserve((x0 - (left - DIRECTIONS) / 2 / per_meter, (y0 + y1) / 2), ((left - DIRECTIONS) / 2, height / 2))
    for line in (plan["outline"], *(part["ring"] for name in ("plates", "openings", "zones") for part in plan[name])):
        labels.reserve_line([*line, line[0]], 0.2)
    for load in plan["loads"]:
        if stands_in_plan(load) and "points" in load:
            labels.reserve_line(load["points"], 0.3)
    for wall in plan["walls"]:
        for piece in wall.get("pieces", [wall["points"]]):
            labels.reserve_line(piece, wall["thickness"] * per_meter / 2 + 0.2)
    legend = _draw_ground(axes, plan, labels) | symbols.draw_plate(axes, model, fill=style.PANEL)
    legend |= symbols.draw_voids(axes, model) | symbols.draw_supports(axes, model)
    legend |= symbols.draw_columns(axes, model, lambda _: True) | symbols.draw_walls(axes, model, lambda _: True)
    legend |= symbols.draw_beams(axes, model)
    symbols.draw_axes(axes, model)
    legend |= symbols.draw_loads(axes, placed, everywhere=False)
    legend |= _draw_outputs(axes, plan, labels)
    _label_parts(model, plan, labels)
    _label_loads(axes, plan, labels)
    for axis, rows in enumerate(chains):
        _draw_dimensions(axes, axis, rows, (x0, y0), (per_meter, model.units))
    _draw_axes(axes, (x0 - (left - 4) / per_meter, y0 - (below - 4) / per_meter), per_meter)
    return page.finish(TOP + height + below, legend)


def describe_omissions(model: Model) -> tuple[str, ...]:
    """Return how to read the plan of a model, and what it does not show, in sentences."""
    plan = plan_of(model)
    labels = "L and a number: the load of that number in the case; loads on columns and walls have no label."
    notes = [f"Dimensions in {'meters' if model.units == 'SI' else 'feet'}.", labels]
    if 0 < len(model.columns) <= MOST_SIZES or plan["walls"]:
        small = "millimeters" if model.units == "SI" else "inches"
        notes.append(f"After the name of a column or wall come its sides or its thickness in {small}.")
    everywhere = [
        Message("L{n} ({kind})", n=n, kind=load["kind"])
        for n, load in enumerate(plan["loads"], 1)
        if not stands_in_plan(load)
    ]
    if model.moves:
        notes.append("Forces of patterns have no label; those on a path are drawn at all of its positions.")
    if everywhere:
        all_over = joined(everywhere)
        notes.append(Message("Not drawn, as they act on the entire plate or on a support: {loads}.", loads=all_over))
    near = {tuple(place) for place in nearby(plan).tolist()}
    far = [hole for hole in plan["boreholes"] if (hole["x"], hole["y"]) not in near]
    if far:
        names = joined(
            Message("{name} at {place:.6g (m)}", name=Name(hole["name"]), place=(hole["x"] + 0.0, hole["y"] + 0.0))
            for hole in far
        )
        notes.append(Message("Too far away to be drawn: {names}.", names=names))
    return tuple(notes)


def stands_in_plan(load: Data) -> bool:
    """Return whether a load of a plan acts at a place of its own, not all over a plate or at a support."""
    return "everywhere" not in load and "support" not in load


def nearby(plan: Data) -> Any:
    """Return the plate's corners and what lies near the plate (k, 2) [m]."""
    x0, y0, x1, y1 = plan["bounds"]
    places = [(point["x"], point["y"]) for name in ("boreholes", "points") for point in plan[name]]
    places += [end for name in ("lines", "strips") for line in plan[name] for end in (line["start"], line["end"])]
    places += [place for support in plan["supports"] for place in support["points"]]
    places += [place for load in plan["loads"] for place in load.get("ring") or load.get("points", ())]
    places += [axis["bubble"] for axis in plan["axes"]]
    far = REACH * max(x1 - x0, y1 - y0)
    on_ground = np.array([place for load in plan["loads"] if "on" in load for place in load["ring"]]).reshape(-1, 2)
    places += np.clip(on_ground, (x0 - far, y0 - far), (x1 + far, y1 + far)).tolist()
    near = np.array([(x0, y0), (x1, y1), *places], dtype=float)
    inside = (near >= (x0 - far, y0 - far)) & (near <= (x1 + far, y1 + far))
    return near[inside.all(axis=1)]


class Labels:
    """Labels in millimeters beside places in meters."""

    def __init__(
        self, axes: Axes, per_meter: float, limits: tuple[float, float, float, float], say: Translator
    ) -> None:
        self._say = say
        x0, x1, y0, y1 = self._limits = [per_meter * limit for limit in limits]
        self._axes, self.per_meter = axes, per_meter
        self._placement = LabelPlacement((x0 - 4, x1 + 4, y0 - 4, y1 + 4))

    def reserve(self, place: Sequence[float], half: Point) -> None:
        """Keep labels off a box of some half sides [mm]."""
        self._placement.reserve((place[0] * self.per_meter, place[1] * self.per_meter), half)

    def reserve_line(self, line: Sequence[Sequence[float]], reach: float) -> None:
        """Keep labels off a line through places (k, 2) as far as it reaches to each side [mm]."""
        self._placement.reserve_line(np.array(line, dtype=float) * self.per_meter, reach)

    def add(
        self, place: Sequence[float], text: str, color: str, distance: float = 2.0, sides: Sequence[Point] = SIDES
    ) -> None:
        """Write a text beside a place, or at the border of the drawing beside one outside."""
        x0, x1, y0, y1 = self._limits
        x, y = (self.per_meter * coordinate for coordinate in place)
        text = style.plain_text(self._say(text))
        half = style.text_width(text, style.SMALL) / 2, 0.6 * style.SMALL * style.PT
        inside = min(max(x, x0), x1), min(max(y, y0), y1)
        u, v = (
            coordinate / self.per_meter for coordinate in self._placement.place_beside(inside, half, distance, sides)
        )
        self._axes.text(
            u, v, text, fontsize=style.SMALL, ha="center", va="center", color=color, parse_math=False, zorder=8,
            bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.4},
        )  # fmt: skip


def _draw_ground(axes: Axes, plan: Data, labels: Labels) -> dict[str, Any]:
    """Draw zones of soil and boreholes; return the entries in the legend."""
    entries: dict[str, Any] = {}
    for zone in plan["soil_zones"]:
        ring = symbols.draw_ring(axes, np.array(zone["ring"]), edgecolor=style.GROUND, linewidth=0.8, zorder=0.5)
        ring.set(linestyle=(0, (6, 3)), clip_on=True)
        entries["zone of soil"] = ring
    for hole in plan["boreholes"]:
        place, color = (hole["x"], hole["y"]), style.GROUND
        (mark,) = axes.plot(*place, "o", markersize=6, markerfacecolor="white", markeredgecolor=color, zorder=6)
        axes.plot(*place, "+", markersize=9, color=color, zorder=6)
        entries["borehole"] = mark
        labels.add(place, Name(hole["name"]), color)
    return entries


def _draw_outputs(axes: Axes, plan: Data, labels: Labels) -> dict[str, Any]:
    """Draw points, section lines and strips with their names; return the entries in the legend."""
    entries: dict[str, Any] = {}
    for output in (*plan["lines"], *plan["strips"]):
        ends = np.array([output["start"], output["end"]])
        (line,) = axes.plot(*ends.T, color=style.ACCENT, linewidth=0.9, linestyle=(0, (9, 3, 2, 3)), zorder=6)
        if "width" in output:
            u = (ends[1] - ends[0]) / max(float(np.hypot(*(ends[1] - ends[0]))), 1e-9)
            across = np.array([-u[1], u[0]]) * output["width"] / 2
            corners = np.array([ends[0] + across, ends[1] + across, ends[1] - across, ends[0] - across])
            symbols.draw_ring(axes, corners, edgecolor=style.ACCENT, linewidth=0.5, linestyle=(0, (3, 3)), zorder=6)
        entries["strip" if "width" in output else "section line"] = line
        labels.add(ends.mean(axis=0) if "width" in output else ends[0], Name(output["name"]), style.ACCENT)
    for point in plan["points"]:
        (entries["point"],) = axes.plot(point["x"], point["y"], "x", markersize=6, color=style.ACCENT, zorder=6)
        labels.add((point["x"], point["y"]), Name(point["name"]), style.ACCENT)
    return entries


def _label_parts(model: Model, plan: Data, labels: Labels) -> None:
    """Name columns and walls with their sizes, beams and supports; write thicknesses, and levels where there are pits.

    A plate with pits has its top side at level 0.
    """
    for column, drawn in zip(model.columns, plan["columns"], strict=True):
        sized = f"{column.name} {_sides(column, model.units)}" if len(model.columns) <= MOST_SIZES else column.name
        labels.add((column.x, column.y), Name(sized), style.INK, max(_reach(drawn["ring"], labels.per_meter)) + 0.6)
    for wall in plan["walls"]:
        sized = Name(f"{wall['name']} {_length(wall['thickness'], model.units, 'mm')}")
        labels.add(middle(wall["points"]), sized, style.INK, wall["thickness"] * labels.per_meter / 2 + 1.0)
    for part in plan["beams"]:
        labels.add(middle(part["points"]), Name(part["name"]), style.INK, 3.0)
    level = 0.0 if any("level" in zone for zone in plan["zones"]) else None
    plates = [(plan["outline"], plan["thickness"]), *((other["ring"], other["thickness"]) for other in plan["plates"])]
    for ring, thickness in plates:
        labels.add(lower_left(ring), zone_label(thickness, level), style.GREY, 1.0, WITHIN)
    for support in plan["supports"]:
        labels.add(middle(support["points"]), Name(support["name"]), style.SUPPORT, 3.0)
    for zone in plan["zones"]:
        labels.add(upper_left(zone["ring"]), zone_label(zone["thickness"], zone.get("level")), style.GREY, 0.8, BELOW)


def _label_loads(axes: Axes, plan: Data, labels: Labels) -> None:
    """Write the numbers of the loads; those at one place share a label, those on a column or a wall have none."""
    groups: dict[tuple[Any, ...], list[int]] = {}
    columns = {(column["x"], column["y"]) for column in plan["columns"]}
    for number, load in enumerate(plan["loads"], 1):
        if "footprint" in load:
            symbols.draw_ring(axes, np.array(load["footprint"]), edgecolor=style.LOAD, linewidth=0.6, zorder=5)
        if stands_in_plan(load) and not load.get("wall"):
            curves = [load.get("ring") or load["points"], *load.get("holes", ())]
            key = ("ring" in load, *(tuple(tuple(place) for place in curve) for curve in curves))
            groups.setdefault(key, []).append(number)
    if len(groups) > MOST_LABELS:
        return
    for (is_area, places, *_), numbers in groups.items():
        if len(places) > 1 or places[0] not in columns:
            name = Name(", ".join(f"L{number}" for number in numbers[:3]) + (" ..." if len(numbers) > 3 else ""))
            labels.add(upper_left(places) if is_area else middle(places), name, style.LOAD)


def _sides(column: Column, units: System) -> str:
    """Return the sides or the diameter of a column without their unit."""
    if column.diameter is not None:
        return f"\N{DIAMETER SIGN}{_length(column.diameter, units, 'mm')}"
    return "/".join(_length(side, units, "mm") for side in (column.width_x, column.width_y) if side is not None)


def _chains(model: Model, axis: int, per_meter: float) -> list[list[float]]:
    """Return the stops [m] of chains of dimensions along x (axis 0) or y (1), the innermost first.

    They stop at axes of the building, else at columns and ends of walls; at the plates' corners; at the ends of all.
    """
    ends = [model.bounds[2 * axis], model.bounds[2 * axis + 1]]
    lines = [line.points for line in drawn_axes(model.axes, model.bounds)]
    inner = [float(line[0][axis]) for line in lines if np.ptp(line[:, axis]) < SAME * np.ptp(line)]
    if not inner:
        inner = [(column.x, column.y)[axis] for column in model.columns]
        inner += [end[axis] for wall in model.placed_walls for piece in wall.pieces for end in _ends(piece)]
    rings = [plate.ring() for plate in model.every_plate]
    corners = [place[axis] for ring in rings if ring.straight for place in ring.points]
    chains = [_spaced(stops, ends, LEAST_DIMENSION / per_meter) for stops in (inner, corners)] + [ends]
    return [chain for n, chain in enumerate(chains) if chain not in chains[n + 1 :]]


def _ends(piece: WallPiece) -> Iterator[Point]:
    """Yield both ends of a piece of a wall [m]."""
    yield piece.edges[0].start
    yield piece.edges[-1].end


def _spaced(stops: Sequence[float], ends: Sequence[float], least: float) -> list[float]:
    """Return stops between ends that are so far apart at least; those that most of them share come first."""
    kept = list(ends)
    places = {round(stop, 3): stop for stop in stops}
    for stop in (places[near] for near, _ in Counter(round(stop, 3) for stop in stops).most_common()):
        if ends[0] < stop < ends[1] and all(abs(stop - other) >= least for other in kept):
            kept.append(stop)
    return sorted(kept)


def _draw_dimensions(
    axes: Axes, axis: int, chains: Sequence[Sequence[float]], corner: Point, scale: tuple[float, System]
) -> None:
    """Draw chains of dimensions along x below the plan (axis 0), or along y to its left (1)."""
    per_meter, units = scale
    for row, chain in enumerate(chains, 1):
        level = corner[1 - axis] - row * CHAIN / per_meter
        for ends in pairwise(chain):
            _draw_dimension(axes, axis, ends, level, per_meter, units)


def _draw_dimension(
    axes: Axes, axis: int, ends: tuple[float, float], level: float, per_meter: float, units: System
) -> None:
    """Draw a dimension line along x (axis 0) or y (1) with ticks at its ends and its length."""
    look: dict[str, Any] = {"color": style.GREY, "linewidth": 0.6, "clip_on": False}
    length, middle, tick = _length(ends[1] - ends[0], units), (ends[0] + ends[1]) / 2, 0.8 / per_meter
    line = np.array([ends, (level, level)])[:: -1 if axis else 1]
    axes.plot(*line, **look)
    for x, y in line.T:
        axes.plot((x - tick, x + tick), (y - tick, y + tick), **look)
    font: dict[str, Any] = {"fontsize": style.SMALL, "color": style.INK, "parse_math": False}
    if axis:
        axes.text(level - 0.5 / per_meter, middle, length, ha="right", va="center", rotation=90, **font)
    else:
        axes.text(middle, level + 0.3 / per_meter, length, ha="center", va="bottom", **font)


def _draw_axes(axes: Axes, place: Point, per_meter: float) -> None:
    """Draw the directions of x and y at a place, and the origin."""
    x, y = place
    arrow = {"arrowstyle": "->", "color": style.GREY, "linewidth": 0.7, "shrinkA": 0, "shrinkB": 0}
    for name, (u, v) in (("x", (1, 0)), ("y", (0, 1))):
        tip = x + u * 8 / per_meter, y + v * 8 / per_meter
        axes.annotate("", tip, (x, y), arrowprops=arrow, annotation_clip=False)
        place = tip[0] + u / per_meter, tip[1] + v / per_meter
        axes.text(*place, name, fontsize=style.SMALL, ha="left" if u else "center")
    axes.plot(0.0, 0.0, "o", markersize=3, markerfacecolor="none", markeredgecolor=style.GREY, zorder=3)


def _length(value: float, units: System, unit: str = "m") -> str:
    """Return a length [m] in meters or feet, or in millimeters or inches, without its unit."""
    return f"{round(value * in_system(UNITS[unit], units).scale, 4) + 0.0:.6g}"


def _reach(ring: Sequence[Sequence[float]], per_meter: float) -> Point:
    """Return half the sides [mm] of the box around a curve."""
    across, along = np.ptp(np.array(ring, dtype=float), axis=0) * per_meter / 2
    return float(across), float(along)


def middle(places: Sequence[Sequence[float]]) -> Point:
    """Return the middle of the longest piece of a line, or the only place there is."""
    pieces = [*pairwise(places)] or [(places[0], places[0])]
    a, b = max(pieces, key=lambda ends: (ends[1][0] - ends[0][0]) ** 2 + (ends[1][1] - ends[0][1]) ** 2)
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def upper_left(ring: Sequence[Sequence[float]]) -> Point:
    """Return the upper left corner of the rectangle around a curve."""
    x, y = zip(*ring, strict=True)
    return min(x), max(y)


def lower_left(ring: Sequence[Sequence[float]]) -> Point:
    """Return the place of a curve that lies farthest to the lower left."""
    x, y = min(ring, key=lambda place: (place[0] + place[1], place[0]))
    return x, y
