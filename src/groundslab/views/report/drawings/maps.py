"""Small plans of fields for the page, with numbers all over: contours as SVG, what lies on the plate drawn once.

A picture of Matplotlib takes most of its time for words and for what is the same in all of them. So only the frame is
one; the maps after the first refer to it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from groundslab.messages import Name
from groundslab.units import format_drawn
from groundslab.views.plots.annotations import Label, place_labels
from groundslab.views.plots.contours import LABEL, ColorScale, bands, triangulation
from groundslab.views.plots.export import to_inline_svg
from groundslab.views.plots.panels import Panel, find_extremes
from groundslab.views.plots.plan import BAR, GAP, MapFrame, draw_frame
from groundslab.views.plots.style import INK, PAGE_COLORS, PT, SMALL, apply_style
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from markupsafe import Markup
    from matplotlib.axes import Axes
    from matplotlib.path import Path

    from groundslab.arrays import Array, Integers
    from groundslab.languages import Translator
    from groundslab.model.model import Model

#: Width of a map and its largest height [mm]: two stand beside each other.
WIDTH, HEIGHT = 86.0, 100.0
#: Coordinates of contours are whole numbers of so many to a millimeter.
FINENESS = 25
#: The id of what all maps share.
FRAME = "frame-of-maps"


def draw_maps(
    model: Model, panels: Sequence[Panel], scales: dict[str, ColorScale], labels: Sequence[str]
) -> Iterator[Markup]:
    """Yield each panel as an SVG element for an HTML page; its label is its title for screen readers."""
    from markupsafe import Markup, escape
    from matplotlib.figure import Figure

    with apply_style():
        frame = draw_frame(model, WIDTH, HEIGHT)
    axes, say = Figure().add_axes((0.0, 0.0, 1.0, 1.0)), words_of(model)
    width, height = (25.4 * float(inches) for inches in frame.figure.get_size_inches())
    drawn = to_inline_svg(lambda: frame.figure, FRAME, Name("frame"), translate=say)
    for first, (panel, label) in enumerate(zip(panels, labels, strict=True)):
        shared = f'<use href="#{FRAME}"/>' if first else f'<g id="{FRAME}">{_nested(drawn, width, height)}</g>'
        words = escape(say(label))
        yield Markup(
            f'<svg class="drawing" viewBox="0 0 {width:.2f} {height:.2f}" width="{width / 25.4 * 96:.0f}" '
            f'height="{height / 25.4 * 96:.0f}" role="img" aria-label="{words}"><title>{words}</title>'
            f"{''.join(_fields(axes, panel, scales[panel.quantity.name], frame, say))}{shared}"
            f"{''.join(_labels(model, panel, frame))}</svg>"
        )


def _nested(drawn: str, width: float, height: float) -> str:
    """Return an SVG element as a part of a map, in millimeters and without a title."""
    box = drawn.index("viewBox=")
    size = drawn[box : drawn.index('"', box + 9) + 1]
    inner = drawn[drawn.index("</title>") + len("</title>") :]
    return f'<svg width="{width:.2f}" height="{height:.2f}" {size} stroke-linejoin="round">{inner}'


def _fields(axes: Axes, panel: Panel, scale: ColorScale, frame: MapFrame, say: Translator) -> Iterator[str]:
    """Yield the colors of a panel, found in some axes, the border of the contact and the color bar."""
    from matplotlib.colors import to_hex

    levels = scale.levels
    colors = [to_hex(color) for color in scale.colors_at((levels[:-1] + levels[1:]) / 2)]
    triangles = triangulation(panel.nodes, panel.elements)
    x0, x1, _, y1 = frame.limits
    per_meter = frame.width / (x1 - x0)
    origin = np.array([frame.left - x0 * per_meter, frame.top + y1 * per_meter])

    def d(path: Path) -> str:
        places, codes = np.asarray(path.vertices, dtype=float), np.asarray(path.codes)
        return _path_data(places * np.array([per_meter, -per_meter]) + origin, codes)

    small = f'transform="scale({1 / FINENESS:g})" stroke-width="{0.07 * FINENESS:g}"'
    yield f'<g {small} stroke="{_color(INK)}" stroke-opacity="0.55" fill-rule="evenodd">'
    for color, path in zip(colors, bands(axes, triangles, panel.values, levels), strict=True):
        if data := d(path):
            yield f'<path fill="{color}" d="{data}"/>'
    yield "</g>"
    if panel.contact is not None and (panel.contact > 0).any():
        _, path = bands(axes, triangles, panel.contact, np.array([-1.0, 0.0, 1.0]) * np.abs(panel.contact).max())
        yield f'<path {small} fill="none" stroke="{_color(INK)}" stroke-dasharray="40 20" d="{d(path)}"/>'
    yield from _color_bar(levels, colors, frame, say)


def _path_data(places: Array, codes: Integers) -> str:
    """Return polygons (n, 2) [mm] as the data of a path in whole numbers; places that fall together count once."""
    from matplotlib.path import Path

    if not places.size:
        return ""
    drawn = codes != Path.CLOSEPOLY
    whole, start = np.rint(places[drawn] * FINENESS).astype(int), codes[drawn] == Path.MOVETO
    kept = start | np.any(whole != np.roll(whole, 1, axis=0), axis=1)
    whole, start = whole[kept], start[kept]
    steps = np.diff(whole, axis=0, prepend=0)
    steps[start] = whole[start]
    texts = [f"{x} {y}" for x, y in steps.tolist()]
    begins = np.flatnonzero(start).tolist()
    rings = [
        f"M{texts[begin]}l{' '.join(texts[begin + 1 : end])}z"
        for begin, end in zip(begins, [*begins[1:], len(texts)], strict=True)
        if end > begin + 2
    ]
    return "".join(rings)


def _color_bar(levels: Array, colors: Sequence[str], frame: MapFrame, say: Translator) -> Iterator[str]:
    """Yield the bands of color beside the plan, with as many levels as can be read."""
    left, bottom = frame.left + frame.width + GAP, frame.top + frame.height
    heights = (levels - levels[0]) / (levels[-1] - levels[0]) * frame.height
    for color, (low, high) in zip(colors, pairwise(heights.tolist()), strict=True):
        yield (
            f'<rect x="{left:.2f}" y="{bottom - high:.2f}" width="{BAR:g}" height="{high - low:.2f}" fill="{color}"/>'
        )
    every = max(1, int(np.ceil(len(levels) * LABEL / frame.height)))
    for level, height in list(zip(levels, heights, strict=True))[int(np.argmin(np.abs(levels))) % every :: every]:
        yield _text(
            Label(say(format_drawn(float(level))), (left + BAR + 1.0, bottom - float(height)), SMALL), anchor="start"
        )


def _labels(model: Model, panel: Panel, frame: MapFrame) -> Iterator[str]:
    """Yield rings at the extremes, and all words on the plan."""
    x0, x1, _, y1 = frame.limits
    per_meter = frame.width / (x1 - x0)
    left, top = frame.left - x0 * per_meter, frame.top + y1 * per_meter
    for extreme in find_extremes(panel):
        x, y = left + extreme.place[0] * per_meter, top - extreme.place[1] * per_meter
        yield f'<circle cx="{x:.2f}" cy="{y:.2f}" r="0.65" fill="white" stroke="{_color(INK)}" stroke-width="0.3"/>'
    for label in place_labels(model, panel, per_meter, numbered=True):
        x, y = label.middle
        yield _text(label._replace(middle=(left + x, top - y)))


def _text(label: Label, anchor: str = "middle") -> str:
    """Return words, set off from the colors around them."""
    from markupsafe import escape

    size = label.size * PT
    x, y = label.middle
    outline = f' paint-order="stroke" stroke="white" stroke-width="{0.9 if label.boxed else 0.5:g}"'
    return (
        f'<text x="{x:.2f}" y="{y + 0.36 * size:.2f}" font-size="{size:.2f}" text-anchor="{anchor}" '
        f'fill="{_color(INK)}"{"" if anchor == "start" else outline}>{escape(label.text)}</text>'
    )


def _color(name: str) -> str:
    """Return a color of the palette as that of the page."""
    return f"var({PAGE_COLORS[name]})" if name in PAGE_COLORS else name
