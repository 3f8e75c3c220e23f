"""Figures as files: SVG and PDF with text as text, or PNG; the same bytes from the same results."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab import __version__
from groundslab.errors import Fault, InputError
from groundslab.findings import listed, quote
from groundslab.plots.style import styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: What a file's name may end with.
FORMATS = (".pdf", ".svg", ".png")
#: Pixels per inch, of PNG files and of colours that are pixels in the others.
DPI = 300


def format_of(path: str | Path) -> str:
    """Return the format that a file's name asks for: "pdf", "svg" or "png"."""
    ending = Path(path).suffix.lower()
    if ending not in FORMATS:
        raise InputError([Fault(str(path), f"a name that ends with {quote(ending)}", f"{listed(FORMATS)} at its end")])
    return ending[1:]


def save(figures: Sequence[Figure], path: str | Path, *, dpi: float = DPI) -> None:
    """Write figures into a file: into a PDF as pages, into another one a single figure.

    Nothing in the file tells when it was written.
    """
    kind = format_of(path)
    made_by = f"groundslab {__version__}"
    with styled():
        if kind == "pdf":
            from matplotlib.backends.backend_pdf import PdfPages

            with PdfPages(path, metadata={"Creator": made_by, "CreationDate": None}) as pages:
                for figure in figures:
                    figure.savefig(pages, format="pdf", dpi=dpi)
            return
        (figure,) = figures
        about = {"Software": made_by} if kind == "png" else {"Creator": made_by, "Date": None}
        figure.savefig(path, format=kind, dpi=dpi, metadata=about)
