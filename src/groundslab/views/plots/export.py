"""Figures as files and as SVG within pages: text stays text; the same results give the same bytes."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab._version import __version__
from groundslab.errors import InputError, Issue
from groundslab.schema.wording import listed, quote
from groundslab.storage import atomic
from groundslab.storage.ownership import is_figure, require_replaceable
from groundslab.views.plots.style import apply_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: What a file's name may end with.
FORMATS = (".pdf", ".svg", ".png")
#: Pixels per inch, of PNG files and of colors that are pixels in the others.
DPI = 300


def file_format(path: str | Path) -> str:
    """Return the format that a file's name asks for: "pdf", "svg" or "png"."""
    ending = Path(path).suffix.lower()
    if ending not in FORMATS:
        raise InputError([Issue(str(path), f"a name that ends with {quote(ending)}", f"{listed(FORMATS)} at its end")])
    return ending[1:]


def check(path: str | Path) -> Path:
    """Return the full path if figures may be written there; else raise InputError saying why not."""
    file_format(path)
    return require_replaceable(path, is_figure, "a figure that groundslab drew")


def save(figures: Sequence[Figure], path: str | Path, *, dpi: float = DPI) -> None:
    """Write figures into a file, whole or not at all: into a PDF as pages, into another one a single figure.

    An existing file is replaced only if groundslab drew it. Nothing in the file tells when it was written.
    """
    target = check(path)
    content = to_bytes(figures, file_format(path), dpi)
    try:
        atomic.write(target, content)
    except OSError as error:
        hint = "make room or choose another place; what was there is as it was"
        found = error.strerror or str(error)
        raise InputError([Issue(str(path), found, "a file that can be written", hint)]) from error


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
    return file.getvalue()
