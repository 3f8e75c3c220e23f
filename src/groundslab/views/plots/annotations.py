"""Words on panels: the title above, labels of columns and zones, the extremes; each label where it covers least."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from groundslab.geometry.plan import DRAWN_CHORD
from groundslab.messages import Message, Name
from groundslab.results.contact_zone import goes_below_zero
from groundslab.views.plots.panels import Panel, find_extremes
from groundslab.views.plots.style import (
    BASE,
    FOOT,
    GREY,
    INK,
    PT,
    SMALL,
    plain_text,
    text_width,
    white_outline,
)
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from groundslab.arrays import Array
    from groundslab.languages import Translator
    from groundslab.model.model import Model

Point = tuple[float, float]

#: The eight sides of a place, the better ones first: as multiples of half a word's size beyond it.
AROUND: tuple[Point, ...] = ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (-1, 1), (1, -1), (-1, -1))
#: What it costs to leave the drawing by a millimeter, in square millimeters that are covered.
OUTSIDE = 8.0
#: Of a line or another word so much may be covered [mm2].
COVERED = 0.3
#: So much better is each side than the next one, where all else is equal.
ORDER = 1e-3


@dataclass(slots=True)
class LabelPlacement:
    """What is taken on a drawing: boxes by their middles and half sides, within limits x0, x1, y0, y1."""

    limits: tuple[float, float, float, float]
    taken: list[tuple[float, float, float, float]] = field(default_factory=list)

    def reserve(self, middle: Point, half: Point) -> None:
        """Let nothing else stand in a box, if that can be helped."""
        self.taken.append((*middle, *half))

    def place_beside(self, place: Point, half: Point, distance: float, sides: Sequence[Point] = AROUND) -> Point:
        """Return the middle of a box of some half size beside a place, and take it."""
        (x, y), (across, along) = place, (half[0] + distance, half[1] + distance)
        return self.place_best(((x + right * across, y + up * along) for right, up in sides), half)

    def place_free(self, place: Point, half: Point, distance: float, sides: Sequence[Point] = AROUND) -> Point | None:
        """Return the middle of a box beside a place and take it; None if on no side of it there is space."""
        (x, y), (across, along) = place, (half[0] + distance, half[1] + distance)
        for right, up in sides:
            middle = x + right * across, y + up * along
            if self._cost(middle, half) <= COVERED:
                self.reserve(middle, half)
                return middle
        return None

    def reserve_line(self, line: Array, half: float) -> None:
        """Let nothing stand on a line through places (k, 2), as wide as twice half, if that can be helped."""
        for start, end in pairwise(line):
            pieces = max(1, int(np.ceil(np.hypot(*(end - start)) / (4 * half))))
            for x, y in start + (np.arange(pieces)[:, None] + 0.5) / pieces * (end - start):
                self.reserve((float(x), float(y)), (half, half))

    def place_best(self, middles: Iterable[Point], half: Point) -> Point:
        """Return the middle of those given whose box covers least, and take it; of equal ones the first."""
        best = min(enumerate(middles), key=lambda numbered: self._cost(numbered[1], half) + ORDER * numbered[0])[1]
        self.reserve(best, half)
        return best

    def _cost(self, middle: Point, half: Point) -> float:
        """Return how much a box covers [mm2], with a high price for what leaves the drawing."""
        x0, x1, y0, y1 = self.limits
        (x, y), (wide, high) = middle, half
        cost = OUTSIDE * max(x0 + wide - x, x + wide - x1, y0 + high - y, y + high - y1, 0.0)
        for other_x, other_y, other_wide, other_high in self.taken:
            over_x, over_y = wide + other_wide - abs(x - other_x), high + other_high - abs(y - other_y)
            if over_x > 0 and over_y > 0:
                cost += over_x * over_y
        return cost


class TitleLine(NamedTuple):
    """A line of words and how it is written."""

    text: str
    size: float
    color: str
    weight: str


def panel_title(panel: Panel, model: Model, width: float, *, with_source: bool) -> list[TitleLine]:
    """Return the lines above a plan: of what it is if that is to be facts, what it shows, its extremes, the contact.

    They are in the units and the language of the model.
    """
    say = words_of(model)
    uplift = panel.quantity.name == "settlement" and goes_below_zero(panel.values) and not panel.difference
    facts: list[str] = []
    for word, value, where, whose in find_extremes(panel):
        called, shown = ("uplift", -value) if uplift and word == "smallest" else (word, value)
        said = Message(
            f"{called} {{value:number {panel.quantity.field.unit}}} at {{place:place m}}", value=shown, place=where
        )
        facts.append(said_of(said, plain_text(whose, 40)))
    if not facts:
        facts.append("zero everywhere")
    if panel.line_force is not None:
        force, where = panel.line_force
        facts.append(Message("edge line force up to {force:number kN/m} at {place:place m}", force=force, place=where))
    if panel.quantity.name in ("pressure", "gap") and panel.share is not None:
        facts.append(Message("{share:number} % of the plate in contact", share=100 * panel.share))
    source = _wrapped(say(panel.source), width) if with_source else []
    lines = [TitleLine(text, BASE, GREY, "bold") for text in source]
    lines += [TitleLine(text, BASE, INK, "bold") for text in _wrapped(say(panel.quantity.title), width)]
    return [*lines, *(TitleLine(text, SMALL, GREY, "normal") for text in _joined([*map(say, facts)], width))]


def said_of(fact: str, combination: str) -> str:
    """Return a fact with the combination that it comes from, where there are several."""
    return Message("{fact} ({combination})", fact=fact, combination=Name(combination)) if combination else fact


def title_height(head: Sequence[TitleLine]) -> float:
    """Return the height [mm] of the lines above a plan."""
    return 3.0 + sum(1.3 * line.size * PT for line in head)


def draw_title(axes: Axes, head: Sequence[TitleLine]) -> None:
    """Write lines above a plan."""
    height = 1.6
    for line in reversed(head):
        axes.annotate(
            line.text, (0, 1), xycoords="axes fraction", xytext=(0, height / PT), textcoords="offset points",
            fontsize=line.size, color=line.color, fontweight=line.weight, va="baseline", parse_math=False,
        )  # fmt: skip
        height += 1.3 * line.size * PT


def _wrapped(words: str, width: float) -> list[str]:
    """Return bold words in at most two lines that are not wider than a width [mm]."""
    clean = plain_text(words, 500)
    letters = int(len(clean) * min(1.0, width / max(text_width(clean, BASE, "bold"), 1e-9))) + 1
    lines: list[str] = [*map(Name, clean.splitlines())]
    while letters > 8 and any(text_width(line, BASE, "bold") > width for line in lines):
        lines = [*map(Name, plain_text(clean, letters, 2).splitlines())]
        letters -= 1
    return lines


def _joined(parts: Sequence[str], width: float) -> list[str]:
    """Return parts joined on as few lines as they need in a width [mm]."""
    lines = [parts[0]]
    for part in parts[1:]:
        longer = Name(f"{lines[-1]};  {part}")
        if text_width(longer, SMALL) <= width:
            lines[-1] = longer
        else:
            lines.append(part)
    return lines


#: More columns than this are not named, nor those of plans with fewer millimeters for a meter.
MOST_NAMES, LEAST_SCALE = 60, 2.0
#: Where the name of a column stands beside it, and the thickness of a zone within it; the better places first.
BESIDE: tuple[Point, ...] = ((1, 1), (-1, 1), (1, -1), (-1, -1))
INSIDE: tuple[Point, ...] = ((-1, -1), (1, -1), (-1, 1), (1, 1), (0, -1), (0, 1), (-1, 0), (1, 0), (0, 0))


class Label(NamedTuple):
    """Words about a place on a plan [mm]."""

    text: str
    middle: Point
    size: float  # of the letters [pt]
    boxed: bool = False


def draw_labels(axes: Axes, model: Model, panel: Panel, per_meter: float) -> None:
    """Name the columns, write the thickness of zones, mark the extremes by rings with their values."""
    for extreme in find_extremes(panel):
        (ring,) = axes.plot(*extreme.place, "o", markersize=3.6, markeredgecolor=INK, zorder=7, clip_on=False)
        ring.set(markerfacecolor="white", markeredgewidth=0.9)
    for label in place_labels(model, panel, per_meter):
        _write_label(axes, label, per_meter)


def place_labels(model: Model, panel: Panel, per_meter: float, *, numbered: bool = False) -> list[Label]:
    """Return the values of the extremes, the names of columns and the thickness of zones, each where it is written.

    The words cover neither each other nor the columns, as far as there is space. Where space is left, numbers say how
    large the values are if they are wanted.
    """
    x0, x1, y0, y1 = (per_meter * bound for bound in model.bounds)
    placement, say = LabelPlacement((x0, x1, y0, y1)), words_of(model)
    labels = []
    extremes = find_extremes(panel)
    for extreme in extremes:
        placement.reserve((extreme.place[0] * per_meter, extreme.place[1] * per_meter), (1.0, 1.0))
    named = per_meter >= LEAST_SCALE and len(model.columns) <= MOST_NAMES
    boxes = [_bounding_box(np.array(column.ring().flat(np.inf)) * per_meter) for column in model.columns]
    for middle, half in boxes:
        placement.reserve(middle, half)
    for line, wide in _lines_on_plan(model):
        placement.reserve_line(line * per_meter, max(wide * per_meter / 2, 0.3))
    for word, value, (x, y), _ in extremes:
        words = say(Message("max {value:number}" if word == "largest" else "min {value:number}", value=value))
        half = text_width(words, SMALL - 0.5) / 2 + 0.5, 0.6 * SMALL * PT
        middle = placement.place_beside((x * per_meter, y * per_meter), half, 1.6)
        labels.append(Label(words, middle, SMALL - 0.5, boxed=True))
    for column, ((x, y), half) in zip(model.columns if named else (), boxes, strict=False):
        words = plain_text(Name(column.name), 12)
        size = text_width(words, FOOT) / 2 + 0.2, 0.55 * FOOT * PT
        corners = [(x + i * (half[0] + size[0]), y + j * (half[1] + size[1])) for i, j in BESIDE]
        labels.append(Label(words, placement.place_best(corners, size), FOOT))
    for plate, zone in [(slab, zone) for slab in model.every_plate for zone in slab.zones]:
        if zone.thickness is not None or zone.level is not None:
            words = say(zone_label(zone.thickness or plate.thickness, zone.level))
            size = text_width(words, FOOT + 0.5) / 2 + 0.4, 0.6 * (FOOT + 0.5) * PT
            (x, y), half = _bounding_box(np.array(zone.shape.ring().flat(np.inf)) * per_meter)
            inner = half[0] - size[0] - 0.6, half[1] - size[1] - 0.6
            corners = [(x + i * inner[0], y + j * inner[1]) for i, j in INSIDE]
            labels.append(Label(words, placement.place_best(corners, size), FOOT + 0.5))
    return [*labels, *(_place_numbers(panel, per_meter, placement.taken, say) if numbered else ())]


def _lines_on_plan(model: Model) -> Iterator[tuple[Array, float]]:
    """Yield axes of walls and borders of openings (k, 2) [m], each with its width [m]."""
    chord = DRAWN_CHORD * max(model.sides)
    for wall in model.placed_walls:
        for piece in wall.pieces:
            yield np.array(piece.to_shapely(chord).coords), wall.thickness
    for plate in model.every_plate:
        for hole in plate.openings:
            border = np.array(hole.ring().flat(chord))
            yield np.vstack([border, border[:1]]), 0.0


def zone_label(thickness: float, level: float | None) -> Message:
    """Return what stands in a zone: its thickness [m], and of a pit the level of its top side [m]."""
    if level is None:
        return Message("t = {thickness:.6g m}", thickness=thickness)
    return Message("t = {thickness:.6g m}, z = {level:.6g m}", thickness=thickness, level=level)


#: Numbers stand so far apart at least [mm], and have so many digits.
APART, DIGITS = (9.0, 6.0), 3


def _place_numbers(
    panel: Panel, per_meter: float, taken: Sequence[tuple[float, float, float, float]], say: Translator
) -> Iterator[Label]:
    """Yield values of a panel at their nodes where nothing stands, the largest in size first."""
    places, sizes = panel.nodes * per_meter, np.abs(panel.values)
    half = np.array(APART) / 2
    low, high = places.min(axis=0) + half / 2, places.max(axis=0) - half / 2
    free = (sizes > 1e-6 * sizes.max(initial=0)) & ((places >= low) & (places <= high)).all(axis=1)
    for *middle, wide, tall in taken:
        free &= (np.abs(places - middle) > half + np.array([wide, tall])).any(axis=1)
    left = np.flatnonzero(free)
    left = left[np.argsort(-sizes[left], kind="stable")]
    while len(left):
        node, others = left[0], left[1:]
        value = float(panel.values[node])
        words = f"{value:.{DIGITS}g}" if abs(value) < 10**DIGITS else f"{value:.0f}"
        x, y = places[node]
        yield Label(say(words.replace("-", "\N{MINUS SIGN}")), (float(x), float(y)), FOOT)
        left = others[(np.abs(places[others] - places[node]) > 2 * half).any(axis=1)]


def _bounding_box(places: Array) -> tuple[Point, Point]:
    """Return middle and half sides of the box around places (k, 2)."""
    low, high = places.min(axis=0), places.max(axis=0)
    (x, y), (wide, high_) = (low + high) / 2, (high - low) / 2
    return (float(x), float(y)), (float(wide), float(high_))


def _write_label(axes: Axes, label: Label, per_meter: float) -> None:
    """Write words about a place [mm]."""
    look: dict[str, Any] = {"path_effects": white_outline(1.5)}
    if label.boxed:
        look = {"bbox": {"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 0.6}}
    axes.text(
        label.middle[0] / per_meter, label.middle[1] / per_meter, label.text, fontsize=label.size, ha="center",
        va="center", color=INK, parse_math=False, zorder=8, **look,
    )  # fmt: skip
