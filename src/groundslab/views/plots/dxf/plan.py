"""A plan of results as lines, circles and texts on layers: contours with their values, what lies on the plate, bars.

All lies where the case has it. Each field has layers of its own; those of the first one are shown, the others are off.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.positions import positions
from groundslab.geometry.plan import DRAWN_CHORD
from groundslab.model.loads.acting import AreaPressure, LineForce, PointForce
from groundslab.schema.wording import printable
from groundslab.unit_systems import together
from groundslab.units import format_drawn
from groundslab.views.drawing.bars import BAR_LAYERS, face_bars
from groundslab.views.drawing.shapes import (
    LETTERS,
    PLAN_LAYERS,
    Circle,
    Layer,
    Line,
    Shape,
    Text,
    closed,
    plan_shapes,
    rings,
)
from groundslab.views.plots.annotations import Label, panel_title, place_labels
from groundslab.views.plots.contours import ColorScale, contour_lines, levels_with_lines, triangulation
from groundslab.views.plots.panels import NOT_CERTIFIED, Panel, build_panels, find_extremes, shared_scales
from groundslab.views.plots.style import PT, SMALL
from groundslab.views.plots.symbols import supported_edges
from groundslab.views.reactions import support_reactions
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from groundslab.model.loads.load_types import AnyLoad
    from groundslab.model.model import Model
    from groundslab.views.plots.request import PlotRequest

#: Colors of fields in turn, numbers of AutoCAD's palette that are seen on black and on white.
COLORS = (5, 1, 3, 6, 30, 4, 12, 94)
#: A contour has its value this many heights of letters apart, and at all if it is so many long.
APART, SHORT = 60.0, 8.0
#: Ends of pieces of a contour are joined if they are so many heights apart at most.
NEAR = 0.1
#: Height of capitals over the size of letters.
CAPITALS = 0.73
#: Letters that names of layers may not have, and the most that they have.
FORBIDDEN, LONGEST = re.compile(r'[<>/\\":;?*|=`,\x00-\x1f]+'), 200


def draw_plan(request: PlotRequest) -> tuple[list[Shape], dict[str, Layer]]:
    """Return the shapes of a plan of results, and the layers that they are on."""
    model = request.combined.solved_model
    h = LETTERS * max(model.sides)
    panels = build_panels(request)
    scales = shared_scales(panels)
    names = _layer_names(panels)
    layers = dict(PLAN_LAYERS)
    shapes: list[Shape] = [*plan_shapes(model), *_zones(model), *_supports(model, h)]
    per_meter = SMALL * PT * CAPITALS / h
    for order, (panel, name) in enumerate(zip(panels, names, strict=True)):
        color, off = COLORS[order % len(COLORS)], order > 0
        drawn = list(_field(panel, scales[panel.quantity.name], name, h))
        drawn += _words(model, panel, name, h, per_meter)
        for part in dict.fromkeys(shape.layer for shape in drawn):
            layers[part] = Layer(color, part.endswith(" CONTACT"), off or part.endswith(" NUMBERS"))
        shapes += drawn
    names_and_zones = (label for label in place_labels(model, panels[0], per_meter) if not label.boxed)
    shapes += [_to_text("NAMES", label, per_meter) for label in names_and_zones]
    shapes += _loads(model, panels[0].takes_part, h)
    for order, (layer, texts) in enumerate(_reactions(request, model, h).items()):
        layers[layer] = Layer(7, off=order > 0)
        shapes += texts
    if model.reinforcement is not None and model.reinforcement.laid:
        listed = positions(model)
        shapes += [shape for face in ("bottom", "top") for shape in face_bars(model, face, h, listed)]
        layers |= {name: look._replace(off=True) for name, look in BAR_LAYERS.items()}
    others = {"ZONES": Layer(8, broken=True), "SUPPORTS": Layer(3), "NAMES": Layer(7), "LOADS_POINT": Layer(1),
              "LOADS_LINE": Layer(1), "LOADS_AREA": Layer(1, broken=True)}  # fmt: skip
    used = {shape.layer for shape in shapes} | {"OUTLINE"}
    return shapes, {name: look for name, look in (layers | others).items() if name in used}


def _layer_names(panels: Sequence[Panel]) -> list[str]:
    """Return the name of the layer of each panel: its quantity, and where that has several panels whose it is."""
    counts = [sum(other.quantity.name == panel.quantity.name for other in panels) for panel in panels]
    names: list[str] = []
    for panel, count in zip(panels, counts, strict=True):
        words = panel.quantity.name.upper() + (f" {panel.source}" if count > 1 else "")
        name, copies = _layer_name(words), 1
        while name.lower() in {other.lower() for other in names}:
            copies += 1
            name = f"{_layer_name(words)} ({copies})"
        names.append(name)
    return names


def _layer_name(words: str) -> str:
    """Return words as the name of a layer."""
    return FORBIDDEN.sub("_", printable(words))[:LONGEST].strip()


def _field(panel: Panel, scale: ColorScale, layer: str, h: float) -> Iterator[Shape]:
    """Yield the contours of a field with their values, and the boundary of the contact zone."""
    triangles = triangulation(panel.nodes, panel.elements)
    unit = panel.quantity.field.unit
    pieces: dict[float, list[Array]] = {}
    for value, points in contour_lines(triangles, panel.values, levels_with_lines(panel.values, scale)):
        pieces.setdefault(value, []).append(points)
    for value, points in ((value, line) for value, lines in pieces.items() for line in _joined(lines, NEAR * h)):
        is_closed = len(points) > 3 and bool((points[0] == points[-1]).all())
        yield Line(layer, points[:-1] if is_closed else points, is_closed, (panel.quantity.name, value, unit))
        yield from _values_along(points, format_drawn(value), f"{layer} VALUES", h)
    if panel.contact is not None and (panel.contact > 0).any() and (panel.contact < 0).any():
        boundary = [points for _, points in contour_lines(triangles, panel.contact, np.zeros(1))]
        yield from (Line(f"{layer} CONTACT", points) for points in _joined(boundary, NEAR * h))


def _joined(lines: Sequence[Array], near: float) -> list[Array]:
    """Return lines (k, 2) with ends that are near each other joined, the nearest first.

    Contours break off where small elements meet large ones, whose sides do not have the same nodes.
    """
    import shapely
    from scipy.spatial import KDTree

    ends = np.array([end for line in lines for end in (line[0], line[-1])])
    pairs = KDTree(ends).query_pairs(near, output_type="ndarray")
    pairs = pairs[np.argsort(np.hypot(*(ends[pairs[:, 0]] - ends[pairs[:, 1]]).T), kind="stable")]
    moved, taken = [line.copy() for line in lines], set[int]()
    for i, j in pairs.tolist():
        if i in taken or j in taken or (i // 2 == j // 2 and len(lines[i // 2]) < 4):
            continue
        taken |= {i, j}
        for end in (i, j):
            moved[end // 2][-(end % 2)] = (ends[i] + ends[j]) / 2
    merged = shapely.line_merge(shapely.multilinestrings([shapely.linestrings(line) for line in moved]))
    return [np.asarray(part.coords) for part in shapely.get_parts(merged)]


def _values_along(points: Array, words: str, layer: str, h: float) -> Iterator[Text]:
    """Yield the value of a contour at intervals along it, beside the line and never upside down."""
    steps = np.hypot(*np.diff(points, axis=0).T)
    length = steps.sum()
    if length < SHORT * h:
        return
    count = max(1, round(length / (APART * h)))
    reached = np.concatenate([[0.0], np.cumsum(steps)])
    for where in (np.arange(count) + 0.5) / count * length:
        # the direction over the length of the words, as pieces of a contour are short
        before, middle, after = (
            np.array([np.interp(s, reached, points[:, k]) for k in (0, 1)])
            for s in (where - len(words) * h / 2, where, where + len(words) * h / 2)
        )
        along = after - before
        if along[0] < -1e-9 * h or (abs(along[0]) <= 1e-9 * h and along[1] < 0):
            along = -along
        angle = float(np.degrees(np.arctan2(along[1], along[0])))
        beside = np.array([-along[1], along[0]]) / max(float(np.hypot(*along)), 1e-300)
        x, y = middle + 0.8 * h * beside
        yield Text(layer, (float(x), float(y)), h, words, angle, centered=True)


def _words(model: Model, panel: Panel, layer: str, h: float, per_meter: float) -> Iterator[Shape]:
    """Yield the title of a field above the plan, its extremes with rings, and numbers where there is space."""
    x0, x1, _, y1 = model.bounds
    lines = [line.text for line in panel_title(panel, model, per_meter * (x1 - x0), with_source=bool(panel.source))]
    lines[:0] = ([model.title] if model.title else []) + ([] if panel.certified else [words_of(model)(NOT_CERTIFIED)])
    for row, words in enumerate(reversed(lines)):
        yield Text(f"{layer} TITLE", (x0, y1 + (2.0 + 1.9 * row) * h), 1.2 * h, printable(words))
    for extreme in find_extremes(panel):
        yield Circle(f"{layer} EXTREMES", extreme.place, 0.3 * h)
    plain = place_labels(model, panel, per_meter)
    for label in place_labels(model, panel, per_meter, numbered=True):
        if label.boxed:
            yield _to_text(f"{layer} EXTREMES", label, per_meter)
        elif label not in plain:
            yield _to_text(f"{layer} NUMBERS", label, per_meter)


def _to_text(layer: str, label: Label, per_meter: float) -> Text:
    """Return a label [mm] of a plan as text."""
    place = label.middle[0] / per_meter, label.middle[1] / per_meter
    return Text(layer, place, label.size * PT * CAPITALS / per_meter, printable(label.text), centered=True)


def _zones(model: Model) -> Iterator[Shape]:
    """Yield the zones of plates, as they are given."""
    chord = DRAWN_CHORD * max(model.sides)
    for zone in (zone for plate in model.every_plate for zone in plate.zones):
        yield closed("ZONES", zone.shape.ring(), chord)


def _supports(model: Model, h: float) -> Iterator[Shape]:
    """Yield supports at points as circles, those along lines and held edges as lines."""
    for support in model.supports:
        if support.edges:
            yield Line("SUPPORTS", np.array(support.points))
        else:
            yield Circle("SUPPORTS", support.points[0], 0.5 * h)
    yield from (Line("SUPPORTS", edge) for edge in supported_edges(model))


def _loads(model: Model, takes_part: Callable[[AnyLoad], bool], h: float) -> Iterator[Shape]:
    """Yield the loads that take part: points beside columns with their forces, lines, edges of loaded areas."""
    import shapely

    chord = DRAWN_CHORD * max(model.sides)
    for load, shape in model.acting:
        if not takes_part(load):
            continue
        if isinstance(shape, PointForce) and not getattr(load, "column", ""):
            x, y = shape.place
            for arm in (np.array([0.5, 0.5]), np.array([0.5, -0.5])):
                yield Line("LOADS_POINT", np.array(shape.place) + h * np.array([-arm, arm]))
            if shape.P:
                (force,), unit = together([shape.P], "force", model.units)
                yield Text("LOADS_POINT", (x + 0.8 * h, y - 0.5 * h), h, f"{force} {unit}")
        elif isinstance(shape, LineForce) and not shape.wall:
            yield Line("LOADS_LINE", shape.flat(chord))
        elif isinstance(shape, AreaPressure):
            for part in shapely.get_parts(shape.to_shapely()):
                yield from (Line("LOADS_AREA", np.asarray(ring.coords)[:-1], closed=True) for ring in rings(part))


def _reactions(request: PlotRequest, model: Model, h: float) -> dict[str, list[Shape]]:
    """Return what supports bear in each combination that is drawn by itself, by layer."""
    if request.envelope or request.minus:
        return {}
    texts: dict[str, list[Shape]] = {}
    for combination in request.combinations:
        layer = _layer_name("REACTIONS" + (f" {combination.name}" if len(request.combinations) > 1 else ""))
        for reaction in support_reactions(combination.results):
            x, y = reaction.place
            words = printable(f"{reaction.name}: {reaction.words(model.units)}")
            texts.setdefault(layer, []).append(Text(layer, (x + 0.8 * h, y - 1.5 * h), h, words))
    return texts
