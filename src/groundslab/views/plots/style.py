"""How all figures look: sizes in millimetres of paper, one type, colours that colour-blind readers can tell apart."""

from __future__ import annotations

import textwrap
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any

#: Sizes of letters in points, for a figure that is placed as large as it is.
FOOT, SMALL, BASE, TITLE = 5.5, 7.0, 8.0, 9.5
MM = 1 / 25.4  # of an inch
PT = 25.4 / 72  # of a millimetre

INK, GREY, FAINT, LOAD, SUPPORT, GROUND, BAD = (
    "#111111", "#5a5a5a", "#c8c8c8", "#b5127b", "#14703a", "#7a5230", "#b30000",
)  # fmt: skip
#: Colours of curves after Okabe and Ito 2008, black and the dark ones first, and the strokes that go with them.
CYCLE = ("#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#7f7f7f")
STROKES = ("-", "--", "-.", (0, (1, 1)), (0, (5, 1, 1, 1, 1, 1)), (0, (8, 2)), (0, (3, 1)), (0, (2, 2)))

RC: dict[str, Any] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": BASE,
    "axes.titlesize": BASE,
    "axes.labelsize": BASE,
    "axes.linewidth": 0.6,
    "axes.formatter.use_mathtext": True,
    "xtick.labelsize": SMALL,
    "ytick.labelsize": SMALL,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 2.5,
    "ytick.major.size": 2.5,
    "legend.fontsize": SMALL,
    "legend.frameon": False,
    "hatch.linewidth": 0.35,
    "lines.linewidth": 1.2,
    "mathtext.fontset": "dejavusans",
    "figure.dpi": 150,
    "savefig.dpi": 300,
    # text stays text, and two runs give the same bytes
    "svg.fonttype": "none",
    "svg.hashsalt": "groundslab",
    "pdf.fonttype": 42,
}


@contextmanager
def styled() -> Iterator[None]:
    """Draw and write in this style, whatever style the reader has set up for figures of his own."""
    import matplotlib

    with matplotlib.rc_context(), warnings.catch_warnings():
        matplotlib.rcdefaults()
        shared: Any = matplotlib.rcParams
        shared.update(RC)
        # letters that the font lacks are shown as boxes, or as themselves where text stays text
        warnings.filterwarnings("ignore", message=".*missing from font")
        yield


def free(text: str, width: int = 200, lines: int = 1) -> str:
    """Return a text of the user in at most so many lines of so many letters, without what files could not hold.

    It is shown with parse_math=False, so that a dollar sign in it is no formula.
    """
    clean = "".join(letter if letter.isprintable() else " " for letter in text)
    return "\n".join(textwrap.wrap(clean, width, max_lines=lines, placeholder=" ..."))


def number(value: float) -> str:
    """Return a number with four significant digits and a true minus sign."""
    return f"{value + 0.0:.4g}".replace("-", "\N{MINUS SIGN}")


def at(place: tuple[float, float]) -> str:
    """Return a place [m] in words."""
    x, y = (number(round(coordinate, 3)) for coordinate in place)
    return f"({x}, {y}) m"


def symbol(name: str) -> str:
    """Return a symbol such as m_xy or beta_x as a formula."""
    letter, _, index = name.partition("_")
    greek = rf"\{letter}" if len(letter) > 1 else letter
    return f"${greek}_{{{index}}}$" if index else f"${greek}$"


@cache
def width_of(text: str, size: float, weight: str = "normal") -> float:
    """Return the width of a line of text in letters of some size [pt] and weight, in millimetres."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    if not text.strip():
        return 0.0
    font = FontProperties(family=RC["font.sans-serif"], weight=weight)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message=".*missing from font")
        path = TextPath((0, 0), text.replace("$", "S"), size=size, prop=font)
    return float(path.get_extents().width) * PT
