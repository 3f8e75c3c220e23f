"""Sheets as PDF: each a page of its size, to scale, set by Typst from a drawing of lines and texts."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.schema.wording import printable
from groundslab.views.bars.figure import ALONG_X, ALONG_Y, CAPITALS, LOOKS
from groundslab.views.drawing.shapes import Circle, Line, Shape, Text
from groundslab.views.drawing.sheets.paper import SIZES, Sheet
from groundslab.views.drawing.sheets.placing import width_of
from groundslab.views.plots import style
from groundslab.views.report.pdf import STANDARDS, report_fonts

if TYPE_CHECKING:
    from groundslab.languages import Language, Translator

#: What a PDF says of itself, by which it is known.
MARK = "Bars drawn by groundslab"
#: Color and width [mm] of lines on layers that figures of bars do not have, or draw as bars.
SHEET_LOOKS = {
    "FRAME": (style.INK, 0.5), "DIMENSIONS": (style.INK, 0.18), "TITLE": (style.INK, 0.18),
    "AXES": (style.GREY, 0.18), "AXES_NAMES": (style.GREY, 0.25), "PITS": (style.INK, 0.25),
}  # fmt: skip
#: Lines on these layers are broken: dash and gap [mm].
BROKEN = {"BAR_ZONES": "2.5 1.2", "AXES": "6 1.2 0.8 1.2"}
#: Dots without a hole are not larger [mm].
FILLED = 1.0
TEMPLATE = """#let about = json("about.json")
#set document(title: about.title, keywords: (about.mark,), date: datetime(year: 1970, month: 1, day: 1))
#set text(font: ("Inter", "DejaVu Sans"), lang: about.language)
#set page(width: about.width * 1mm, height: about.height * 1mm, margin: 0mm)
#for (number, label) in about.sheets.enumerate() {
  if number > 0 { pagebreak() }
  figure(image(str(number) + ".svg", width: 100%, alt: label))
}
"""


def to_pdf(title: str, sheets: Sequence[Sheet], language: Language, say: Translator) -> bytes:
    """Return sheets of one size as the pages of a PDF; the same sheets give the same bytes."""
    import typst

    width, height = SIZES[sheets[0].paper]
    about = {
        "title": printable(title) or "groundslab", "mark": f"{MARK} {__version__}", "language": language,
        "width": width, "height": height, "sheets": [say(sheet.title) for sheet in sheets],
    }  # fmt: skip
    files: Any = {"main.typ": TEMPLATE.encode(), "about.json": json.dumps(about).encode()}
    files |= {f"{number}.svg": to_svg(sheet).encode() for number, sheet in enumerate(sheets)}
    pdf: bytes = typst.compile(files, font_paths=report_fonts(), pdf_standards=list(STANDARDS))
    return pdf


def is_ours(path: Path) -> bool:
    """Return whether a file is a PDF of sheets that groundslab drew."""
    content = path.read_bytes()
    return content.startswith(b"%PDF-") and f"{MARK} ".encode() in content


def to_svg(sheet: Sheet) -> str:
    """Return a sheet as SVG, in millimeters: lines below, texts on white above."""
    width, height = SIZES[sheet.paper]
    parts = [line for shape in sheet.shapes for line in _drawn(shape, height)]
    parts += [text for shape in sheet.shapes if isinstance(shape, Text) for text in _written(shape, height)]
    size = f'width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="Inter">{"".join(parts)}</svg>'


def _look(layer: str) -> tuple[str, float]:
    """Return color and width [mm] of the lines of a layer."""
    if layer in SHEET_LOOKS:
        return SHEET_LOOKS[layer]
    color, points = LOOKS.get(layer, ALONG_X if layer.endswith("X") else ALONG_Y)
    return color, points * style.PT * (1.3 if layer.startswith("BARS") else 0.8)


def _drawn(shape: Shape, height: float) -> Iterator[str]:
    """Yield a line or a circle as elements; a small circle is a dot."""
    color, width = _look(shape.layer)
    pen = f'stroke="{color}" stroke-width="{width:.2f}"'
    if isinstance(shape, Line):
        dashes = f' stroke-dasharray="{BROKEN[shape.layer]}"' if shape.layer in BROKEN else ""
        points = " ".join(f"{x:.2f},{height - y:.2f}" for x, y in shape.points)
        name = "polygon" if shape.closed else "polyline"
        yield f'<{name} points="{points}" fill="none" {pen}{dashes}/>'
    elif isinstance(shape, Circle):
        x, y = shape.center
        fill = color if shape.radius <= FILLED else "none"
        yield f'<circle cx="{x:.2f}" cy="{height - y:.2f}" r="{shape.radius:.2f}" fill="{fill}" {pen}/>'


def _written(text: Text, height: float) -> Iterator[str]:
    """Yield a text on white."""
    color, _ = _look(text.layer)
    x, y = text.place
    size, wide = text.height / CAPITALS, width_of(text.words, text.height)
    turn = f'transform="translate({x:.2f} {height - y:.2f}) rotate({-text.turned:g})"'
    left, up, anchor = (-wide / 2, text.height / 2, "middle") if text.centered else (0.0, 0.0, "start")
    box = f'x="{left:.2f}" y="{up - text.height:.2f}" width="{wide:.2f}" height="{1.1 * text.height:.2f}"'
    words = (
        f'<text y="{up:.2f}" font-size="{size:.2f}" text-anchor="{anchor}" fill="{color}">{escape(text.words)}</text>'
    )
    paper = "" if text.centered else f'<rect {box} fill="#ffffff" fill-opacity="0.7"/>'
    yield f"<g {turn}>{paper}{words}</g>"
