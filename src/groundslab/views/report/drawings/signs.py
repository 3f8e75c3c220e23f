"""The drawing of signs: axes, loads and pressure, and moments and shear forces on a piece of the plate."""

from __future__ import annotations

from typing import TYPE_CHECKING

from groundslab.views.plots.style import ACCENT, FAINT, GREY, GROUND, INK, LOAD, PAGE_COLORS
from groundslab.views.report.drawings.drawings import Drawing

if TYPE_CHECKING:
    from groundslab.languages import Translator

LABEL = (
    "Signs: x to the right, z and settlement downwards; loads downwards, pressure upwards on the plate; a sagging "
    "moment is positive"
)
CAPTION = (
    "Signs. m_x bends strips along x and q_x acts on sections x = const; m_y and q_y likewise along y. The moments M_x "
    "of point loads and supports press the side of larger x down: they turn about the y axis, and M_y about the x "
    "axis, where other programs name them after the axis they turn about. In plan x points to the right and y up the "
    "page. The gap is positive where it is open; a negative settlement is uplift; forces of supports are positive "
    "upwards."
)
#: Arrows and what they are drawn on, by color and width of the stroke.
STROKES = (
    (INK, 1.3, "M40 60 L100 60 M94 56 L100 60 L94 64"),
    (INK, 1.3, "M40 60 L40 120 M36 114 L40 120 L44 114"),
    (INK, 1.3, "M36.5 56.5 L43.5 63.5 M36.5 63.5 L43.5 56.5"),
    (LOAD, 1.3, "M190 44 L190 76 M186 70 L190 76 L194 70 M230 44 L230 76 M226 70 L230 76 L234 70 M270 44 L270 76 "
     "M266 70 L270 76 L274 70 M310 44 L310 76 M306 70 L310 76 L314 70 M190 44 L310 44"),
    (GROUND, 1.3, "M190 140 L190 106 M186 112 L190 106 L194 112 M230 140 L230 106 M226 112 L230 106 L234 112 "
     "M270 140 L270 106 M266 112 L270 106 L274 112 M310 140 L310 106 M306 112 L310 106 L314 112 M190 140 L310 140"),
    (ACCENT, 1.5, "M428 112 A 24 24 0 0 1 428 70 M424 77 L428 70 L435 73 M542 112 A 24 24 0 0 0 542 70 "
     "M546 77 L542 70 L535 73"),
    (ACCENT, 1.5, "M434 128 L434 108 M430 114 L434 108 L438 114 M536 108 L536 128 M532 122 L536 128 L540 122"),
)  # fmt: skip
#: Pieces of the plate: left, top, width and height.
PIECES = ((170, 80, 180, 22), (440, 80, 90, 22))
#: Where a text begins, its color, and it.
TEXTS = (
    (105, 64, INK, "x"), (36, 136, INK, "z, w"), (12, 52, INK, "y, into the page"),
    (190, 36, LOAD, "loads q, P positive downwards"),
    (190, 156, GROUND, "pressure p positive where the ground"), (190, 170, GROUND, "is compressed"),
    (398, 94, ACCENT, "m"), (566, 94, ACCENT, "m"), (416, 126, ACCENT, "q"), (546, 126, ACCENT, "q"),
    (420, 48, ACCENT, "moments positive if the bottom face"), (420, 62, ACCENT, "is in tension (sagging)"),
    (440, 150, GREY, "positive shear force on a section"), (440, 164, GREY, "x = const (or y = const)"),
)  # fmt: skip


def draw_signs(translate: Translator = str) -> Drawing:
    """Return the drawing of signs."""
    from markupsafe import Markup, escape

    ink, faint, accent = (f"var({PAGE_COLORS[color]})" for color in (INK, FAINT, ACCENT))
    pieces = "".join(
        f'<rect x="{x}" y="{y}" width="{width}" height="{height}" fill="{faint}" stroke="{ink}" stroke-width="1.4"/>'
        for x, y, width, height in PIECES
    )
    circle = f'<circle cx="40" cy="60" r="5" fill="none" stroke="{accent}" stroke-width="1.2"/>'
    strokes = "".join(
        f'<path fill="none" stroke="var({PAGE_COLORS[color]})" stroke-width="{width}" d="{d}"/>'
        for color, width, d in STROKES
    )
    texts = "".join(
        f'<text x="{x}" y="{y}" font-size="11" fill="var({PAGE_COLORS[color]})">{escape(translate(text))}</text>'
        for x, y, color, text in TEXTS
    )
    label = escape(translate(LABEL))
    svg = (
        '<svg class="drawing" viewBox="0 0 640 190" width="640" height="190" role="img" stroke-linejoin="round" '
        f'aria-label="{label}"><title>{label}</title>{pieces}{circle}{strokes}{texts}</svg>'
    )
    return Drawing(Markup(svg), CAPTION, symbols=True)
