"""The plan of a case before it is solved: plate, ground, structure, supports, loads and outputs, with dimensions."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.messages import Message, Name, joined
from groundslab.unit_systems import unit_in
from groundslab.views.plots import style, symbols
from groundslab.views.plots.annotations import LabelPlacement, Point, zone_label
from groundslab.views.scene.plan import plan_of
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.languages import Translator
    from groundslab.model.model import Model
    from groundslab.unit_systems import System

    Data = dict[str, Any]

#: Largest width and height of what is drawn, what dimensions and axes take beside it, and the least width [mm].
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM, NARROW = 154.0, 150.0, 18.0, 7.0, 7.0, 17.0, 100.0
#: What lies further off the plate than so many times its longer side is named, not drawn.
REACH = 0.5
#: Chains of dimensions closer than this are left out, and dimension lines are this far apart [mm].
LEAST_DIMENSION, CHAIN = 8.0, 5.0
#: Of more loads than these none is labeled.
MOST_LABELS = 60
#: The sides of a place on which its label may stand, the better ones first.
SIDES: tuple[Point, ...] = ((1, 0), (-1, 0), (1, -1), (-1, -1), (1, 1), (-1, 1), (0, 1), (0, -1))


def draw_case_plan(model: Model, placed: Model) -> Figure:
    """Return the plan of a case as written, with the loads of the case as solved; what lies far away is left out."""
    plan = plan_of(model)
    near = nearby(plan)
    (x0, y0), (x1, y1) = near.min(axis=0), near.max(axis=0)
    per_meter = min(WIDTH / (x1 - x0), HEIGHT / (y1 - y0))
    width, height = (x1 - x0) * per_meter, (y1 - y0) * per_meter
    page = style.Page(max(LEFT + width + RIGHT, NARROW), words_of(model))
    axes = page.add_axes(LEFT, TOP, width, height)
    axes.set(xlim=(x0, x1), ylim=(y0, y1))
    axes.set_axis_off()
    labels = Labels(axes, per_meter, (x0, x1, y0, y1), page.say)
    for column in plan["columns"]:
        labels.reserve((column["x"], column["y"]), 1.3)
    legend = _draw_ground(axes, plan, labels) | symbols.draw_plate(axes, model, fill=style.PANEL)
    legend |= symbols.draw_voids(axes, model) | symbols.draw_supports(axes, model)
    legend |= symbols.draw_columns(axes, model, lambda _: True) | symbols.draw_walls(axes, model, lambda _: True)
    legend |= symbols.draw_beams(axes, model)
    symbols.draw_axes(axes, model)
    legend |= symbols.draw_loads(axes, placed, everywhere=False)
    legend |= _draw_outputs(axes, plan, labels)
    _label_parts(plan, labels)
    _label_loads(axes, plan, labels)
    _draw_dimensions(axes, model, (x0, y0), per_meter)
    _draw_axes(axes, (x0, y0), per_meter)
    return page.finish(TOP + height + BOTTOM, legend)


def describe_omissions(model: Model) -> tuple[str, ...]:
    """Return how to read the plan of a model, and what it does not show, in sentences."""
    plan = plan_of(model)
    labels = "L and a number: the load of that number in the case; loads on columns and walls have no label."
    notes = [f"Dimensions in {'meters' if model.units == 'SI' else 'feet'}.", labels]
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
        self._axes, self._per_meter = axes, per_meter
        self._placement = LabelPlacement((x0 - 4, x1 + 4, y0 - 4, y1 + 4))

    def reserve(self, place: Sequence[float], reach: float) -> None:
        """Keep labels off a mark that reaches so far [mm]."""
        self._placement.reserve((place[0] * self._per_meter, place[1] * self._per_meter), (reach, reach))

    def add(self, place: Sequence[float], text: str, color: str, distance: float = 2.0) -> None:
        """Write a text beside a place, or at the border of the drawing beside one outside."""
        x0, x1, y0, y1 = self._limits
        x, y = (self._per_meter * coordinate for coordinate in place)
        text = style.plain_text(self._say(text))
        half = style.text_width(text, style.SMALL) / 2, 0.6 * style.SMALL * style.PT
        inside = min(max(x, x0), x1), min(max(y, y0), y1)
        u, v = (
            coordinate / self._per_meter for coordinate in self._placement.place_beside(inside, half, distance, SIDES)
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


def _label_parts(plan: Data, labels: Labels) -> None:
    """Name columns, walls, beams and supports, and write the thickness of zones and the level of pits."""
    for column in plan["columns"]:
        labels.add((column["x"], column["y"]), Name(column["name"]), style.INK)
    for part in (*plan["walls"], *plan["beams"]):
        labels.add(middle(part["points"]), Name(part["name"]), style.INK, 3.0)
    for support in plan["supports"]:
        labels.add(middle(support["points"]), Name(support["name"]), style.SUPPORT, 3.0)
    for zone in plan["zones"]:
        labels.add(upper_left(zone["ring"]), zone_label(zone["thickness"], zone.get("level")), style.GREY, 1.0)


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


def _draw_dimensions(axes: Axes, model: Model, corner: Point, per_meter: float) -> None:
    """Draw dimension lines below and at the left: from corner to corner where there is space, and of the plate."""
    x0, x1, y0, y1 = model.bounds
    rings = [plate.ring() for plate in model.every_plate]
    corners = [place for ring in rings if ring.straight for place in ring.points]
    for axis, ends in enumerate(((x0, x1), (y0, y1))):
        stops = sorted({round(place[axis], 6) for place in corners} | {round(end, 6) for end in ends})
        chains = [[ends[0], ends[1]]]
        if len(stops) > 2 and min(b - a for a, b in pairwise(stops)) * per_meter >= LEAST_DIMENSION:
            chains.insert(0, stops)
        for row, chain in enumerate(chains, 1):
            level = corner[1 - axis] - row * CHAIN / per_meter
            for ends_of_one in pairwise(chain):
                _draw_dimension(axes, axis, ends_of_one, level, per_meter, model.units)


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


def _draw_axes(axes: Axes, corner: Point, per_meter: float) -> None:
    """Draw the directions of x and y at the lower left, and the origin."""
    x, y = corner[0] - (LEFT - 4) / per_meter, corner[1] - (BOTTOM - 4) / per_meter
    arrow = {"arrowstyle": "->", "color": style.GREY, "linewidth": 0.7, "shrinkA": 0, "shrinkB": 0}
    for name, (u, v) in (("x", (1, 0)), ("y", (0, 1))):
        tip = x + u * 8 / per_meter, y + v * 8 / per_meter
        axes.annotate("", tip, (x, y), arrowprops=arrow, annotation_clip=False)
        place = tip[0] + u / per_meter, tip[1] + v / per_meter
        axes.text(*place, name, fontsize=style.SMALL, ha="left" if u else "center")
    axes.plot(0.0, 0.0, "o", markersize=3, markerfacecolor="none", markeredgecolor=style.GREY, zorder=3)


def _length(value: float, units: System) -> str:
    """Return a length [m] in meters or feet without its unit."""
    _, per_meter = unit_in("m", units)
    return f"{value * per_meter + 0.0:.6g}"


def middle(places: Sequence[Sequence[float]]) -> Point:
    """Return the middle of the longest piece of a line, or the only place there is."""
    pieces = [*pairwise(places)] or [(places[0], places[0])]
    a, b = max(pieces, key=lambda ends: (ends[1][0] - ends[0][0]) ** 2 + (ends[1][1] - ends[0][1]) ** 2)
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def upper_left(ring: Sequence[Sequence[float]]) -> Point:
    """Return the upper left corner of the rectangle around a curve."""
    x, y = zip(*ring, strict=True)
    return min(x), max(y)
