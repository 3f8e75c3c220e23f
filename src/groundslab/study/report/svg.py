"""Matplotlib figures as SVG that stands in a page: the page's letters and colours, no text taken for markup."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import escape, quoteattr

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Colours of a figure, each replaced by the page's own, so that they follow it from light to dark.
INK, FAINT, ACCENT, SECOND, WARN = "#010203", "#040506", "#070809", "#0a0b0c", "#0d0e0f"
VARIABLES = {
    INK: "--gs-ink", FAINT: "--gs-line", ACCENT: "--gs-accent", SECOND: "--second", WARN: "--gs-bad",
}  # fmt: skip
#: Figures are drawn so wide [in]; the page gives them what room there is.
WIDTH = 7.2

_STYLE: Any = {
    "svg.fonttype": "none",
    "text.parse_math": False,
    "font.size": 8.5,
    "font.family": "sans-serif",
    "text.color": INK,
    "axes.facecolor": "none",
    "axes.edgecolor": FAINT,
    "axes.labelcolor": INK,
    "axes.titlesize": 8.5,
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": FAINT,
    "grid.linewidth": 0.5,
    "xtick.color": INK,
    "ytick.color": INK,
    "legend.frameon": False,
    "figure.facecolor": "none",
    "axes.unicode_minus": True,
}


@contextmanager
def style(salt: str) -> Iterator[None]:
    """Draw in the page's manner; the ids within figures of different salts differ."""
    from matplotlib import rc_context

    with rc_context(rc={**_STYLE, "svg.hashsalt": salt}):
        yield


def figure(height: float, width: float = WIDTH) -> Figure:
    """Return an empty figure of a height and a width [in] that needs no display."""
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


def drawn(name: str, label: str, draw: Callable[[], Figure]) -> str:
    """Return what `draw` draws as an SVG element; the label is read out to who cannot see it."""
    text = io.StringIO()
    with style(name):
        draw().savefig(text, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    return inline(text.getvalue(), name, label)


def inline(text: str, name: str, label: str) -> str:
    """Return an SVG file's element for a page: no head, no metadata, no fixed size, the page's colours and letters."""
    element = text[text.index("<svg") :]
    element = re.sub(r"<metadata>.*?</metadata>\s*", "", element, flags=re.DOTALL)
    head, rest = element.split(">", 1)
    box = re.search(r'viewBox="([^"]*)"', head)
    assert box is not None
    for colour, variable in VARIABLES.items():
        rest = rest.replace(colour, f"var({variable})")
    # ids and what refers to them stay within the figure
    rest = re.sub(r'\bid="', f'id="{name}-', rest)
    rest = re.sub(r'(xlink:href="#|url\(#)', rf"\g<1>{name}-", rest)
    rest = re.sub(r"font: ([\d.]+)px [^;\"]*", r"font-size: \1px", rest)
    opening = f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="{box[1]}"'
    return f'{opening} role="img" aria-label={quoteattr(label)}><title>{escape(label)}</title>{rest.strip()}'
