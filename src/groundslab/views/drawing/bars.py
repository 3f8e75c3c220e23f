"""The drawing of bars: a plan of each face with one bar of each set, and the table of quantities.

The plan of the bottom face lies where the case has it, that of the top face beside or below it, the table below both.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.bar_layout import BarSet, bar_sets
from groundslab.design.bars.bending import marked_further_links, marked_links
from groundslab.design.bars.further_links import LaidLinks
from groundslab.design.bars.positions import U_SHAPE, Position, cut_bars, inside_of, positions, to_cut
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.messages import Label, Message, Name
from groundslab.model.model import Model
from groundslab.unit_systems import System, bar_size, bars_at, in_system, unit_in
from groundslab.units import UNITS, format_number
from groundslab.views.drawing.shapes import (
    LETTERS,
    PLAN_LAYERS,
    Circle,
    Layer,
    Line,
    Shape,
    Text,
    moved,
    plan_shapes,
    rings,
)
from groundslab.views.tables.bar_quantities import bars as bars_table
from groundslab.views.tables.table import Table, in_units

#: The layer with broken lines.
BROKEN = "BAR_ZONES"
#: The layers of bars.
BAR_LAYERS = {
    BROKEN: Layer(6, broken=True), "BARS_BOTTOM_X": Layer(5), "BARS_BOTTOM_Y": Layer(3), "BARS_TOP_X": Layer(1),
    "BARS_TOP_Y": Layer(30), "BARS_EDGES": Layer(4), "LINKS": Layer(2),
}  # fmt: skip
LAYERS = PLAN_LAYERS | BAR_LAYERS | {"LABELS": Layer(7), "TABLE": Layer(7)}
#: Distances in heights of letters.
GAP, LINE = 6.0, 1.9
#: The headings of plans are so many heights of letters further up where bubbles of axes are above the slab.
BUBBLES = 4.5
#: Width of a letter on average, over its height.
WIDE = 0.85
#: Where the bar that is drawn stands among its set, and where along it the line of distribution crosses: for the bars
#: all over the slab, and for the zones in turn.
PLACES = ((0.36, 0.7), (0.5, 0.35), (0.62, 0.55), (0.42, 0.45))
#: Radius of the dot of a leg over the height of letters, and at most [m].
DOT, MOST_DOT = 0.2, 0.025
#: It is at least so long, over the longest.
LONG = 0.6
#: Columns of the table of quantities that the drawing has, and what stands above them.
COLUMNS = {
    "mark": "mark", "layer": "layer", "zone": "zone", "welded mesh": "welded mesh", "shape": "shape",
    "diameter": "diameter", "spacing": "spacing", "number": "number", "least length": "length", "greatest length": "to",
    "lap": "lap", "total length": "total", "mass": "mass", "mass per area": "per area",
}  # fmt: skip
#: What is written below the table, and what of the quantities without detailing and with it.
NOTE = {
    "SI": "Lengths in meters, diameters and spacings in millimeters, masses in kilograms. ",
    "US": "Lengths in feet, diameters and spacings in inches, masses in pounds. ",
}
BETWEEN = "Further bars of zones lie between those of the layer."
PLAIN = "Laps, hooks and edge bars are not in the quantities, and the cover at the ends of bars is not taken off."
DETAILED = "Bars end the cover before edges; pieces lap, and bars of U shape at edges have legs, as long as lap says."


def draw(model: Model, links: Sequence[LinkLayout] = ()) -> list[Shape]:
    """Return the drawing of the bars that a model lays, and of links against punching in the plan of the bottom."""
    x0, x1, y0, y1 = model.bounds
    h = LETTERS * max(model.sides)
    flat = x1 - x0 > y1 - y0
    step = (0.0, -(y1 - y0) - 2 * GAP * h) if flat else (x1 - x0 + 2 * GAP * h, 0.0)
    shapes: list[Shape] = []
    listed = positions(model)
    for face, shift in (("bottom", (0.0, 0.0)), ("top", step)):
        shapes += [moved(shape, shift) for shape in _face(model, face, h, listed)]
    shapes += [shape for position in listed if position.shape == U_SHAPE for shape in _edge_bars(model, position, h)]
    shapes += [
        shape
        for mark, layout in marked_links(links, listed).items()
        for shape in _links(layout, mark, (x0, x1), h, model.units)
    ]
    for mark, laid in marked_further_links(model, links, listed).items():
        shapes += _further_links(laid, mark, h, model.units)
    low = y0 + min(step[1], 0.0) - GAP * h
    return shapes + list(_table(in_units(bars_table(model, links), model.units), model, (x0, low), h))


def _face(model: Model, face: str, h: float, listed: Sequence[Position]) -> Iterator[Shape]:
    """Yield the plan of one face, where the case has it, with letters of a height [m]."""
    x0, _, _, y1 = model.bounds
    above = (1.5 + (BUBBLES if model.axes else 0.0)) * h
    yield Text("LABELS", (x0, y1 + above), 1.4 * h, Label(f"{face.capitalize()} bars"))
    yield from plan_shapes(model)
    for column in model.columns:
        yield Text("LABELS", (column.x + 0.6 * h, column.y + 0.6 * h), h, column.name)
    yield from face_bars(model, face, h, listed)


def face_bars(model: Model, face: str, h: float, listed: Sequence[Position]) -> Iterator[Shape]:
    """Yield the bars of one face and the zones where further ones lie, with letters of a height [m]."""
    sets = [bar_set for bar_set in bar_sets(model) if bar_set.layer.startswith(face)]
    for name, region in {bar_set.zone: bar_set.region for bar_set in sets if bar_set.zone}.items():
        pieces = getattr(region, "geoms", [region])
        for piece in (piece for piece in pieces if piece.geom_type == "Polygon"):
            yield from (Line(BROKEN, np.asarray(ring.coords)[:-1], closed=True) for ring in rings(piece))
        left, _, _, top = region.bounds
        yield Text("LABELS", (left + 0.4 * h, top - 1.4 * h), h, name)
    turn = {name: number for number, name in enumerate(dict.fromkeys(bar_set.zone for bar_set in sets))}
    for bar_set in sets:
        of_set = [bar for bar in listed if (bar.layer, bar.zone) == (bar_set.layer, bar_set.zone)]
        place = PLACES[min(turn[bar_set.zone], 1 + (turn[bar_set.zone] - 1) % (len(PLACES) - 1))]
        yield from _bar_set(_as_laid(model, bar_set), place, h, label_of(of_set, model.units))


def _as_laid(model: Model, bar_set: BarSet) -> BarSet:
    """Return a set with the ends of its bars where they are laid, covers taken off."""
    assert model.reinforcement is not None
    ends = [bar.ends for bar in cut_bars(model, model.reinforcement, bar_set)]
    return replace(bar_set, ends=np.reshape(ends, (-1, 2, 2)))


def _bar_set(bar_set: BarSet, place: tuple[float, float], h: float, label: str) -> Iterator[Shape]:
    """Yield one bar of a set, what it says, and the line across over which all of them are distributed."""
    if not len(bar_set.ends):
        return
    layer = f"BARS_{bar_set.layer.upper()}"
    axis = bar_set.axis
    bar = bar_set.ends[shown_bar(bar_set, place[0])]
    yield Line(layer, bar)
    crossing = bar[0] + place[1] * (bar[1] - bar[0])
    across = line_across(bar_set, crossing)
    yield Line(layer, across)
    yield Circle(layer, (float(crossing[0]), float(crossing[1])), 0.3 * h)
    slash = 0.5 * h * np.array([1.0, 1.0])
    for end in across:
        yield Line(layer, np.array([end - slash, end + slash]))
    # above the bar, read from the right where it runs upwards
    off = np.array([0.6 * h, 0.5 * h]) if axis == 0 else np.array([-0.5 * h, 0.6 * h])
    start = bar[0] + off
    yield Text(layer, (float(start[0]), float(start[1])), h, label, 90.0 * axis)


def label_of(of_set: Sequence[Position], units: System) -> str:
    """Return the label of a set of bars: marks, number, diameter, spacing, length and lap, or the welded mesh."""
    if not of_set:
        return ""
    first, last = of_set[0], of_set[-1]
    marks = Name(f"{first.mark}" if first is last else f"{first.mark}-{last.mark}")
    unit, per_meter = unit_in("m", units)
    shortest, longest = (
        f"{find(find(to_cut(bar.lengths, units)) for bar in of_set) * per_meter:.2f}" for find in (min, max)
    )
    long = longest if shortest == longest else Message("{low} to {high}", low=shortest, high=longest)
    mesh = Name(f"{first.mesh}: " if first.mesh else "")
    lap: str = ""
    if first.lap is not None and first.shape != U_SHAPE:
        lap = Message(", lap {lap:.2f m}", lap=first.lap).in_units(units)
    count = sum(len(bar.lengths) for bar in of_set)
    u = "U " if first.shape == U_SHAPE else ""
    bars = Name(u + bars_at(first.bars.diameter, first.bars.spacing, units))
    return Message(
        "({marks}) {mesh}{count} {bars}, l = {long} {unit}{lap}",
        marks=marks, mesh=mesh, count=count, bars=bars, long=long, unit=unit, lap=lap,
    )  # fmt: skip


def _edge_bars(model: Model, position: Position, h: float) -> Iterator[Shape]:
    """Yield bars of U shape in the plan of the bottom: one leg at each edge where they are, and what they say once."""
    assert position.places is not None
    assert position.lap is not None
    axis = "xy".index(position.layer[-1])
    at = np.round(position.places, 3)
    inside = inside_of(model)
    for number, where in enumerate(np.unique(at[:, axis])):
        on_edge = at[at[:, axis] == where]
        place = on_edge[np.argsort(on_edge[:, 1 - axis], kind="stable")[len(on_edge) // 2]]
        inward = np.zeros(2)
        inward[axis] = 1.0 if inside(place, axis, 1e-3) else -1.0
        end = place + inward * position.lap
        yield Line("BARS_EDGES", np.array([place, end]))
        yield Circle("BARS_EDGES", (float(place[0]), float(place[1])), 0.3 * h)
        if number == 0:
            off = np.array([0.4 * h, -1.4 * h]) if axis == 0 else np.array([1.4 * h, 0.4 * h])
            start = np.minimum(place, end) + off
            yield Text(
                "BARS_EDGES", (float(start[0]), float(start[1])), h, label_of([position], model.units), 90.0 * axis
            )


def shown_bar(bar_set: BarSet, part: float) -> int:
    """Return the number of the bar of a set that is drawn: of the long ones that nearest to a part of all."""
    across = bar_set.ends[:, 0, 1 - bar_set.axis]
    long = np.flatnonzero(bar_set.lengths >= LONG * bar_set.lengths.max())
    wanted = across.min() + part * np.ptp(across)
    return int(long[np.argmin(np.abs(across[long] - wanted))])


def line_across(bar_set: BarSet, place: Array) -> Array:
    """Return the ends (2, 2) of the line across the bars through a place, from the first to the last bar there."""
    axis = bar_set.axis
    meets = (bar_set.ends[:, 0, axis] <= place[axis]) & (bar_set.ends[:, 1, axis] >= place[axis])
    across = bar_set.ends[meets, 0, 1 - axis]
    ends = np.tile(place, (2, 1))
    ends[:, 1 - axis] = across.min(), across.max()
    return ends


def _links(layout: LinkLayout, mark: int, within: tuple[float, float], h: float, units: System) -> Iterator[Shape]:
    """Yield the legs of links as dots, with their label above them, within two places along x [m] if it fits."""
    for place in (place for perimeter in layout.perimeters for place in perimeter.places):
        yield Circle("LINKS", (float(place[0]), float(place[1])), min(DOT * h, MOST_DOT))
    places = np.concatenate([perimeter.places for perimeter in layout.perimeters])
    label = label_of_links(layout, mark, units)
    left = max(within[0], min(float(places[:, 0].min()), within[1] - WIDE * h * len(label)))
    yield Text("LINKS", (left, float(places[:, 1].max()) + 0.8 * h), h, label)


def _further_links(laid: LaidLinks, mark: int, h: float, units: System) -> Iterator[Shape]:
    """Yield where links against one-way shear stand, and what links there or of a beam are."""
    if laid.corners is not None:
        x0, y0, x1, y1 = laid.corners
        yield Line("LINKS", np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]), closed=True)
    label = Message("({mark}) links {bars}", mark=mark, bars=bars_at(laid.diameter, laid.spacing, units))
    yield Text("LINKS", (laid.place[0], laid.place[1] + 0.4 * h), h, label)


def label_of_links(layout: LinkLayout, mark: int, units: System) -> str:
    """Return the label of links: mark, legs by perimeters, diameter, and the perimeters' distance [mm, in]."""
    unit = in_system(UNITS["mm"], units)
    radial = "" if layout.radial is None else f", s_r {format_number(unit.scale * layout.radial, 4, trim=True)}"
    first = format_number(unit.scale * layout.perimeters[0].distance, 4, trim=True)
    return Message(
        "({mark}) {counts} links {size}, s_0 {first}{radial}",
        mark=mark, counts=str(layout.counts), size=Name(bar_size(layout.diameter, units)), first=first, radial=radial,
    )  # fmt: skip


def _table(table: Table, model: Model, corner: tuple[float, float], h: float) -> Iterator[Shape]:
    """Yield the table of quantities as texts, its upper left corner at a place [m]."""
    columns = [[head, *map(_cell, table[name])] for name, head in COLUMNS.items()]
    columns = [column for column in columns if any(column[1:])]
    x, y = corner
    for column in columns:
        for number, words in enumerate(column):
            if words:
                yield Text("TABLE", (x, y - (number + 1) * LINE * h), h, words)
        x += (max(map(len, column)) * WIDE + 2) * h
    below = y - (len(columns[0]) + 1.5) * LINE * h
    detailed = model.reinforcement is not None and model.reinforcement.detailing is not None
    for number, words in enumerate((NOTE[model.units] + BETWEEN, DETAILED if detailed else PLAIN)):
        yield Text("TABLE", (corner[0], below - number * LINE * h), h, words)


def _cell(value: str | float | int | None) -> str:
    """Return a cell as it is written."""
    if isinstance(value, float):
        return format_number(value, 4, trim=True)
    return "" if value is None else str(value)
