"""The plan of a case as a drawing: plate, what is cut out, what stands, bears and loads, with dimensions in metres."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from groundslab.views.report import svg
from groundslab.views.report.svg import Labels, Point
from groundslab.views.scene.plan import plan_of

if TYPE_CHECKING:
    from groundslab.model.model import Model

#: Largest width and height of what is drawn [px], and what dimensions and axes take beside it.
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 760.0, 620.0, 74.0, 26.0, 26.0, 70.0
#: What lies further off the plate than so many times its longer side is named, not drawn.
REACH = 0.5
#: Dimensions closer than this [px] are left out.
ROOM = 30.0
#: Of more curves of loads than these none is labelled.
MOST_LABELS = 60

Data = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Sheet:
    """From metres to pixels: y upwards becomes y downwards."""

    x0: float
    y1: float
    scale: float

    def at(self, x: float, y: float) -> Point:
        """Return where a place is drawn."""
        return LEFT + (x - self.x0) * self.scale, TOP + (self.y1 - y) * self.scale

    def all(self, places: Sequence[Sequence[float]]) -> list[Point]:
        """Return where places are drawn."""
        return [self.at(x, y) for x, y in places]


@dataclass(frozen=True, slots=True)
class PlanDrawing:
    """The drawing, and what it cannot show, in words."""

    svg: Markup
    notes: tuple[str, ...]


def plan_drawing(model: Model) -> PlanDrawing:
    """Return the plan of a model."""
    plan = plan_of(model)
    x0, y0, x1, y1 = plan["bounds"]
    far = REACH * max(x1 - x0, y1 - y0)
    near = [(x, y) for x, y in _places(plan) if x0 - far <= x <= x1 + far and y0 - far <= y <= y1 + far]
    left, right = (pick([x0, x1, *(x for x, _ in near)]) for pick in (min, max))
    low, high = (pick([y0, y1, *(y for _, y in near)]) for pick in (min, max))
    sheet = Sheet(left, high, min(WIDTH / (right - left), HEIGHT / (high - low)))
    width, height = LEFT + (right - left) * sheet.scale + RIGHT, TOP + (high - low) * sheet.scale + BOTTOM
    labels = Labels((4, 4, width - 4, height - BOTTOM + 16))
    for column in plan["columns"]:
        labels.keep(sheet.at(column["x"], column["y"]), 5)
    ground = _ground(plan, sheet, labels)
    marks = [*_standing(plan, sheet, labels), *_loads(plan, sheet, labels), *_wanted(plan, sheet, labels)]
    drawn = svg.drawing(
        width,
        height,
        "Plan of the plate",
        *ground,
        *marks,
        *_dimensions(model, plan["bounds"], sheet, high - low),
        *_axes(sheet, height),
    )
    return PlanDrawing(drawn, tuple(_notes(plan, near)))


def _places(plan: Data) -> Iterator[Point]:
    """Yield places beside the outline that the drawing should reach."""
    for name in ("boreholes", "points"):
        yield from ((each["x"], each["y"]) for each in plan[name])
    for name in ("lines", "strips"):
        yield from ((x, y) for each in plan[name] for x, y in (each["start"], each["end"]))
    for each in plan["supports"]:
        yield from ((x, y) for x, y in each["points"])
    for each in plan["loads"]:
        yield from ((x, y) for x, y in each.get("ring") or each.get("points", ()))


def _ground(plan: Data, sheet: Sheet, labels: Labels) -> Iterator[Markup]:
    """Yield the plate, its zones and openings, the zones of soil and the voids below it."""
    openings = [sheet.all(each["ring"]) for each in plan["openings"]]
    for zone in plan["soil_zones"]:
        yield svg.path(sheet.all(zone["ring"]), "d-soil", closed=True)
    yield svg.area([sheet.all(plan["outline"]), *openings], "d-plate")
    for zone in plan["zones"]:
        ring = sheet.all(zone["ring"])
        yield svg.path(ring, "d-zone", closed=True)
        yield labels.beside(_top_left(ring), f"t = {_metres(zone['thickness'])}", "d-text d-muted", reach=4.0)
    for ring in openings:
        (left, top), (right, bottom) = _box(ring)
        yield svg.path(ring, "d-opening", closed=True)
        yield svg.path([(left, top), (right, bottom)], "d-thin")
        yield svg.path([(left, bottom), (right, top)], "d-thin")
    for void in plan["voids"]:
        yield svg.path(sheet.all(void["ring"]), "d-void", closed=True)
    for hole in plan["boreholes"]:
        x, y = sheet.at(hole["x"], hole["y"])
        yield svg.element("circle", cx=x, cy=y, r=5.0, class_="d-borehole")
        yield svg.path([(x - 8, y), (x + 8, y)], "d-thin-soil")
        yield svg.path([(x, y - 8), (x, y + 8)], "d-thin-soil")
        yield labels.beside((x, y), hole["name"], "d-text d-of-soil")


def _standing(plan: Data, sheet: Sheet, labels: Labels) -> Iterator[Markup]:
    """Yield columns and supports with their names."""
    for support in plan["supports"]:
        places = sheet.all(support["points"])
        if support["kind"] == "point":
            ((x, y),) = places
            yield svg.path([(x, y), (x - 6, y + 10), (x + 6, y + 10)], "d-support", closed=True)
        else:
            yield svg.path(places, "d-support-line")
            x, y = _middle(places)
        yield labels.beside((x, y + 4), support["name"], "d-text d-of-support")
    for column in plan["columns"]:
        yield svg.path(sheet.all(column["ring"]), "d-column", closed=True)
    for column in plan["columns"]:
        yield labels.beside(sheet.at(column["x"], column["y"]), column["name"], "d-text")


def _loads(plan: Data, sheet: Sheet, labels: Labels) -> Iterator[Markup]:
    """Yield loads with their numbers; those at one place share a label, those on a column have none."""
    groups: dict[tuple[Any, ...], list[int]] = {}
    columns = {(each["x"], each["y"]) for each in plan["columns"]}
    for number, load in enumerate(plan["loads"], 1):
        if load["kind"] in ("point", "line", "patch", "area"):
            curves = [load.get("ring") or load["points"], *load.get("holes", ())]
            key = (load["kind"], *(tuple(tuple(place) for place in curve) for curve in curves))
            groups.setdefault(key, []).append(number)
    labelled = len(groups) <= MOST_LABELS
    for (kind, places, *holes), numbers in groups.items():
        drawn = sheet.all(places)
        name = ", ".join(f"L{number}" for number in numbers[:3]) + (" ..." if len(numbers) > 3 else "")
        if kind == "point":
            ((x, y),) = drawn
            for number in numbers:
                if "footprint" in plan["loads"][number - 1]:
                    yield svg.path(sheet.all(plan["loads"][number - 1]["footprint"]), "d-load-area", closed=True)
            yield svg.path([(x, y), (x - 4.5, y - 9), (x + 4.5, y - 9)], "d-load", closed=True)
            if tuple(places[0]) in columns:
                continue
            at = (x, y)
        elif kind == "line":
            yield svg.path(drawn, "d-load-line")
            at = _middle(drawn)
        else:
            yield svg.area([drawn, *map(sheet.all, holes)], "d-load-area")
            at = _top_left(drawn)
        if labelled:
            yield labels.beside(at, name, "d-text d-of-load", reach=5.0)


def _wanted(plan: Data, sheet: Sheet, labels: Labels) -> Iterator[Markup]:
    """Yield points, section lines and strips with their names."""
    for strip in plan["strips"]:
        a, b = sheet.at(*strip["start"]), sheet.at(*strip["end"])
        yield svg.path(_band(a, b, strip["width"] * sheet.scale), "d-strip", closed=True)
        yield svg.line(a, b, "d-section")
        yield labels.beside(_middle([a, b]), strip["name"], "d-text d-of-section")
    for each in plan["lines"]:
        a, b = sheet.at(*each["start"]), sheet.at(*each["end"])
        yield svg.line(a, b, "d-section")
        yield labels.beside(a, each["name"], "d-text d-of-section")
    for point in plan["points"]:
        x, y = sheet.at(point["x"], point["y"])
        yield svg.path([(x - 4, y - 4), (x + 4, y + 4)], "d-point")
        yield svg.path([(x - 4, y + 4), (x + 4, y - 4)], "d-point")
        yield labels.beside((x, y), point["name"], "d-text d-of-section")


def _band(a: Point, b: Point, width: float) -> list[Point]:
    """Return the corners of a strip about an axis."""
    length = max(((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5, 1e-9)
    u, v = -(b[1] - a[1]) / length * width / 2, (b[0] - a[0]) / length * width / 2
    return [(a[0] + u, a[1] + v), (b[0] + u, b[1] + v), (b[0] - u, b[1] - v), (a[0] - u, a[1] - v)]


def _dimensions(model: Model, bounds: Sequence[float], sheet: Sheet, tall: float) -> Iterator[Markup]:
    """Yield dimension lines below and at the left: from corner to corner where there is room, and of the whole."""
    x0, y0, x1, y1 = bounds
    ring = model.plate.ring()
    corners = ring.points if ring.straight else ()
    bottom = TOP + tall * sheet.scale
    for axis, ends in enumerate(((x0, x1), (y0, y1))):
        stops = sorted({round(place[axis], 6) for place in corners} | {round(end, 6) for end in ends})
        rows = [stops] if len(stops) > 2 and min(b - a for a, b in pairwise(stops)) * sheet.scale >= ROOM else []
        for n, row in enumerate([*rows, [ends[0], ends[1]]]):
            for a, b in pairwise(row):
                if axis == 0:
                    y = bottom + 20 + 20 * n
                    yield from _dimension((sheet.at(a, 0)[0], y), (sheet.at(b, 0)[0], y), _metres(b - a))
                else:
                    x = LEFT - 20 - 20 * n
                    yield from _dimension((x, sheet.at(0, a)[1]), (x, sheet.at(0, b)[1]), _metres(b - a))


def _dimension(a: Point, b: Point, words: str) -> Iterator[Markup]:
    """Yield a dimension line with its ticks and its length."""
    yield svg.line(a, b, "d-dimension")
    for x, y in (a, b):
        yield svg.line((x - 3, y + 3), (x + 3, y - 3), "d-dimension")
    x, y = (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
    turned = f"rotate(-90 {x - 4:.1f} {y:.1f})" if a[0] == b[0] else None
    yield svg.text((x - 4, y) if turned else (x, y - 4), words, "d-text", "middle", transform=turned)


def _axes(sheet: Sheet, height: float) -> Iterator[Markup]:
    """Yield the directions of x and y, and the origin if it is within the drawing."""
    x, y = 14.0, height - 14.0
    yield svg.path([(x, y - 26), (x, y), (x + 26, y)], "d-axis")
    yield svg.path([(x - 3, y - 22), (x, y - 28), (x + 3, y - 22)], "d-axis")
    yield svg.path([(x + 22, y - 3), (x + 28, y), (x + 22, y + 3)], "d-axis")
    yield svg.text((x + 32, y + 4), "x")
    yield svg.text((x - 3, y - 32), "y")
    u, v = sheet.at(0.0, 0.0)
    if u >= LEFT - 1 and TOP - 1 <= v <= height - BOTTOM + 1:
        yield svg.element("circle", cx=u, cy=v, r=3.0, class_="d-origin")


def _notes(plan: Data, near: Sequence[Point]) -> Iterator[str]:
    """Yield what the drawing does not show."""
    whole = [
        f"L{number} ({load['kind']})"
        for number, load in enumerate(plan["loads"], 1)
        if load["kind"] in ("uniform", "self weight", "temperature", "settlement")
    ]
    yield "Dimensions in metres. L and a number: the load of that number in the case; loads on columns have no label."
    if whole:
        yield f"Not drawn, as they act on the whole plate or on a support: {', '.join(whole)}."
    far = [hole for hole in plan["boreholes"] if (hole["x"], hole["y"]) not in near]
    if far:
        names = ", ".join(f"{hole['name']} at ({_metres(hole['x'])}, {_metres(hole['y'])})" for hole in far)
        yield f"Too far away to be drawn: {names}."


def _metres(value: float) -> str:
    """Return a length in metres."""
    return f"{value + 0.0:.6g}"


def _middle(points: Sequence[Point]) -> Point:
    """Return the middle of the longest piece of a line."""
    a, b = max(pairwise(points), key=lambda ends: (ends[1][0] - ends[0][0]) ** 2 + (ends[1][1] - ends[0][1]) ** 2)
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def _box(ring: Sequence[Point]) -> tuple[Point, Point]:
    """Return the upper left and the lower right corner of the rectangle around a curve."""
    x, y = zip(*ring, strict=True)
    return (min(x), min(y)), (max(x), max(y))


def _top_left(ring: Sequence[Point]) -> Point:
    """Return a place just inside the upper left corner of the rectangle around a curve."""
    (x, y), _ = _box(ring)
    return x, y + 12
