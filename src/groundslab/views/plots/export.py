"""Figures as files and as SVG within pages: text stays text; the same results give the same bytes."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from io import BytesIO
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from groundslab._version import __version__
from groundslab.errors import InputError, Issue
from groundslab.schema.wording import listed, quote
from groundslab.storage import atomic, checksums
from groundslab.storage.ownership import check_replaceable, is_figure
from groundslab.views.drawing import dxf
from groundslab.views.plots.style import PAGE_COLORS, apply_style, show_in, translate_figure

if TYPE_CHECKING:
    from markupsafe import Markup
    from matplotlib.figure import Figure

    from groundslab.languages import Translator
    from groundslab.unit_systems import System
    from groundslab.views.drawing.shapes import Layer, Shape

#: What a file's name may end with.
FORMATS = (".pdf", ".svg", ".png")
#: What that of a drawing ends with.
DRAWING = ".dxf"
#: Namespaces in SVG files.
SVG, XLINK = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/1999/xlink}"
#: Pixels per inch, of PNG files and of colors that are pixels in the others.
DPI = 300


def is_drawing(path: str | Path) -> bool:
    """Return whether a file's name asks for a drawing."""
    return Path(path).suffix.lower() == DRAWING


def file_format(path: str | Path) -> str:
    """Return the format that a file's name asks for: "pdf", "svg" or "png"."""
    ending = Path(path).suffix.lower()
    if ending not in FORMATS:
        expected = f"{listed((*FORMATS, DRAWING))} at its end"
        raise InputError([Issue(str(path), f"a name that ends with {quote(ending)}", expected)])
    return ending[1:]


def check(path: str | Path) -> Path:
    """Return the full path if figures, or a drawing, may be written there; else raise InputError saying why not."""
    if is_drawing(path):
        return dxf.check(path)
    file_format(path)
    return check_replaceable(path, is_figure, "a figure that groundslab drew")


def save(figures: Sequence[Figure], path: str | Path, *, dpi: float = DPI) -> None:
    """Write figures into a file, completely or not at all: into a PDF as pages, else a single figure.

    An existing file is replaced only if groundslab drew it. The file holds no date.
    """
    target = check(path)
    content = to_bytes(figures, file_format(path), dpi)
    if target.suffix.lower() == ".svg":
        checksums.keep_file(target, checksums.is_sealed)
    write_file(path, target, content)


def save_drawing(
    shapes: Sequence[Shape], layers: Mapping[str, Layer], subject: str, path: str | Path, system: System = "SI"
) -> None:
    """Write a drawing into a DXF file, completely or not at all; an existing one only if groundslab drew it."""
    target = dxf.check(path)
    content = dxf.to_bytes(shapes, layers, subject, system)
    checksums.keep_file(target, dxf.is_unchanged)
    write_file(path, target, content)


def write_file(path: str | Path, target: Path, content: bytes) -> None:
    """Write a file completely or not at all; raises InputError, which calls it by the path that was given."""
    try:
        atomic.write(target, content)
    except OSError as error:
        hint = "free some space or choose another place; the earlier file is unchanged"
        reason = error.strerror or str(error)
        raise InputError([Issue(str(path), reason, "a file that can be written", hint)]) from error


def to_inline_svg(
    draw: Callable[[], Figure],
    name: str,
    label: str,
    changes: Mapping[str, Any] = MappingProxyType({}),
    units: System = "SI",
    translate: Translator = str,
) -> Markup:
    """Return a figure as an SVG element for an HTML page; the label is its title for screen readers.

    Its words are translated before they are placed, as legends are as wide as their words.

    Colors of the palette become those of the page, in light and dark; letters become those of the page; ids begin with
    the name. There is neither a style element nor a style attribute, so that a Content Security Policy may forbid them.
    """
    from markupsafe import Markup

    file = BytesIO()
    with apply_style(changes):
        figure = show_in(draw(), units)
        if translate is not str:
            translate_figure(figure, translate)
            label = translate(label)
        figure.savefig(file, format="svg", metadata=dict.fromkeys(("Creator", "Date", "Format", "Type")))
    root = ElementTree.fromstring(file.getvalue())
    for parent in [*root.iter()]:
        for child in [*parent]:
            if child.tag in (f"{SVG}metadata", f"{SVG}style"):
                parent.remove(child)
        parent.tail = None
        if parent.text and not parent.text.strip() and parent.tag != f"{SVG}tspan":
            parent.text = None
    box = root.attrib["viewBox"]
    for element in root.iter():
        element.attrib = dict(_page_attributes(element, name))
        element.tag = element.tag.removeprefix(SVG)
    width, height = (f"{float(length) / 0.75:.0f}" for length in box.split()[2:])
    root.attrib = {
        "class": "drawing", "viewBox": box, "width": width, "height": height, "role": "img", "aria-label": label,
        "stroke-linejoin": "round",
    }  # fmt: skip
    title = ElementTree.Element("title")
    title.text = label
    root.insert(0, title)
    return Markup(ElementTree.tostring(root, encoding="unicode"))


def _page_attributes(element: ElementTree.Element, name: str) -> Iterator[tuple[str, str]]:
    """Yield the attributes of an element within a page, its style as attributes of their own."""
    for key, value in element.items():
        if key == "style":
            for declaration in filter(None, value.split(";")):
                part, _, setting = (text.strip() for text in declaration.partition(":"))
                if part == "font":
                    yield from _font_attributes(setting)
                elif part != "font-family":
                    yield part, _page_value(setting, name)
        elif key == "id":
            yield key, f"{name}-{value}"
        elif key == f"{XLINK}href":
            yield "href", f"#{name}-{value[1:]}" if value.startswith("#") else value
        elif key == "d":
            yield key, re.sub(r"\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", value)
        else:
            yield key, _page_value(value, name)


def _page_value(value: str, name: str) -> str:
    """Return a color of the palette as that of the page, and a reference to an id as one within the page."""
    return f"var({PAGE_COLORS[value]})" if value in PAGE_COLORS else value.replace("url(#", f"url(#{name}-")


def _font_attributes(font: str) -> Iterator[tuple[str, str]]:
    """Yield slope, weight and size of a font such as "italic 700 8px 'DejaVu Sans'", as Matplotlib 3.9 writes it."""
    for word in font.split():
        if word.endswith("px"):
            yield "font-size", word
            return
        yield "font-style" if word in ("italic", "oblique") else "font-weight", word


def to_bytes(figures: Sequence[Figure], kind: str, dpi: float = DPI) -> bytes:
    """Return a file of figures as its bytes, whose kind is "pdf", "svg" or "png"."""
    file = BytesIO()
    made_by = f"groundslab {__version__}"
    with apply_style():
        if kind == "pdf":
            from matplotlib.backends.backend_pdf import PdfPages

            with PdfPages(file, metadata={"Creator": made_by, "CreationDate": None}) as pages:
                for figure in figures:
                    figure.savefig(pages, format="pdf", dpi=dpi)
            return file.getvalue()
        (figure,) = figures
        about = {"Software": made_by} if kind == "png" else {"Creator": made_by, "Date": None}
        figure.savefig(file, format=kind, dpi=dpi, metadata=about)
    return checksums.seal(file.getvalue()) if kind == "svg" else file.getvalue()
