"""The look of all figures: sizes, type, colors for color-blind readers, and the page."""

from __future__ import annotations

import io
import math
import textwrap
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from groundslab._version import __version__
from groundslab.languages import Translator
from groundslab.messages import Message, Name, words_in
from groundslab.unit_systems import unit_in
from groundslab.units import WHOLE, format_coordinate
from groundslab.views.translation import translator_of

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure
    from matplotlib.text import Text

    from groundslab.languages import Translator
    from groundslab.results.results import Results
    from groundslab.unit_systems import System

Item = TypeVar("Item")

#: Sizes of letters in points, for a figure that is placed as large as it is.
FOOT, SMALL, BASE, TITLE = 5.5, 7.0, 8.0, 9.5
MM = 1 / 25.4  # of an inch
PT = 25.4 / 72  # of a millimeter
KILOMETER = 1000

INK, GREY, FAINT, PANEL, LOAD, SUPPORT, GROUND, ACCENT, SECOND, BAD = (
    "#1b1f23", "#545c66", "#d3d8dd", "#f5f6f7", "#b3135f", "#16703a", "#7a5a1e", "#0b5fa5", "#c2540a", "#b3261e",
)  # fmt: skip
#: The same colors by their names on pages, which has them in light and dark.
PAGE_COLORS = {
    INK: "--gs-ink", GREY: "--gs-ink-2", FAINT: "--gs-line", PANEL: "--gs-panel", LOAD: "--gs-load",
    SUPPORT: "--gs-support", GROUND: "--gs-soil", ACCENT: "--gs-accent", SECOND: "--second", BAD: "--gs-bad",
    "#ffffff": "--gs-paper", "#000000": "--gs-ink",
}  # fmt: skip
#: Colors of curves after Okabe and Ito 2008, black and the dark ones first, and the strokes that go with them.
CYCLE = (INK, "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#7f7f7f")
STROKES = ("-", "--", "-.", (0, (1, 1)), (0, (5, 1, 1, 1, 1, 1)), (0, (8, 2)), (0, (3, 1)), (0, (2, 2)))

RC: dict[str, Any] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": BASE,
    "text.color": INK,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.titlesize": BASE,
    "axes.labelsize": BASE,
    "axes.linewidth": 0.6,
    "axes.formatter.use_mathtext": False,
    **{
        f"{axis}tick.{name}": value
        for axis in "xy"
        for name, value in {"color": INK, "labelsize": SMALL, "major.width": 0.6, "major.size": 2.5}.items()
    },
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
def apply_style(changes: Mapping[str, Any] = MappingProxyType({})) -> Iterator[None]:
    """Draw and write in this style, with some changes, whatever style the user has set up for other figures."""
    import matplotlib

    with matplotlib.rc_context(), warnings.catch_warnings():
        shared: Any = matplotlib.rcParams
        # they were checked once, which takes longer than to draw
        dict.update(shared, _settings())
        shared.update(dict(changes))
        # letters that the font lacks are shown as boxes, or as themselves where text stays text
        warnings.filterwarnings("ignore", message=".*missing from font")
        yield


@cache
def _settings() -> dict[str, Any]:
    """Return Matplotlib's own settings with those of this style, checked."""
    import matplotlib

    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        shared: Any = matplotlib.rcParams
        shared.update(RC)
        # what shows figures on a screen is not ours to choose
        return {name: dict.__getitem__(shared, name) for name in shared if name != "backend"}


def plain_text(text: str, width: int = 200, lines: int = 1) -> str:
    """Return a text of the user in at most so many lines of so many letters, without what files could not hold.

    It is shown with parse_math=False, so that a dollar sign in it is no formula.
    """
    clean = "".join(letter if letter.isprintable() else " " for letter in text)
    wrapped = "\n".join(textwrap.wrap(clean, width, max_lines=lines, placeholder=" ..."))
    return text if wrapped == text else Name(wrapped)


def batch(items: Sequence[Item], size: int) -> list[Sequence[Item]]:
    """Return items in parts of some size, for rows and pages; the last one may be smaller."""
    return [items[first : first + size] for first in range(0, len(items), size)]


def label_of_length(name: str) -> str:
    """Return the label of an axis of lengths in meters."""
    return Message("{name} [{unit}]", name=name, unit="m")


def label_of_axis(axis: Axis, name: str, low: float) -> str:
    """Return the label of an axis of coordinates from low [m] on; in national grids ticks count from a kilometer."""
    from matplotlib.ticker import FuncFormatter

    if abs(low) < WHOLE:
        return f"{name} [m]"
    start = KILOMETER * math.floor(low / KILOMETER)
    axis.set_major_formatter(FuncFormatter(lambda value, _: format_coordinate(round(value - start, 6))))
    return f"{name} \N{MINUS SIGN} {start} [m]"


def show_for(figure: Figure, results: Results) -> Figure:
    """Return a figure in the units and the language of a case."""
    show_in(figure, results.model.units)
    if results.model.language != "en":
        translate_figure(figure, translator_of(results))
    return figure


def translate_figure(figure: Figure, translate: Translator) -> None:
    """Put the words of a figure, and the numbers at its axes, into another language."""
    from matplotlib.text import Text
    from matplotlib.ticker import FixedFormatter

    figure.draw_without_rendering()
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            places = [place for place in axis.get_majorticklocs() if low <= place <= high]  # others would widen it
            labels = axis.get_major_formatter().format_ticks([float(place) for place in places])
            axis.set_ticks(places)
            axis.set_major_formatter(FixedFormatter([translate(label) for label in labels]))
    for text in figure.findobj(Text):
        assert isinstance(text, Text)
        text.set_text(translate(text.get_text()))


def show_in(figure: Figure, units: System) -> Figure:
    """Return a figure whose axes of lengths in meters, and the words on it but names, are in the units of a system."""
    from matplotlib.text import Text

    if units == "SI":
        return figure
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            if axis.get_label_text().endswith("[m]"):
                _show_lengths_in(axis, units)
    for text in figure.findobj(Text):
        assert isinstance(text, Text)
        words = text.get_text()
        if isinstance(words, Message) or "[" not in words:  # what labels an axis has been converted with it
            text.set_text(words_in(words, units))
    return figure


def _show_lengths_in(axis: Axis, units: System) -> None:
    """Give an axis of lengths in meters round ticks in the units of a system, and a label that says so."""
    from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator

    unit, per_meter = unit_in("m", units)
    label = axis.get_label_text()
    name = label.removesuffix("[m]").partition("\N{MINUS SIGN}")[0].rstrip()
    low, high = sorted(end * per_meter for end in axis.get_view_interval())
    count = max(2, len(axis.get_majorticklocs()))
    ticks = MaxNLocator(nbins=count, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    start = KILOMETER * math.floor(low / KILOMETER) if abs(low) >= WHOLE else 0
    axis.set_major_locator(FixedLocator([tick / per_meter for tick in ticks if low - 1e-9 <= tick <= high + 1e-9]))
    axis.set_major_formatter(FuncFormatter(lambda value, _: format_coordinate(round(value * per_meter - start, 6))))
    if isinstance(label, Message):
        axis.set_label_text(words_in(Message(label.template, **{**label.values, "unit": unit}), units))
    else:
        axis.set_label_text(f"{name} \N{MINUS SIGN} {start} [{unit}]" if start else f"{name} [{unit}]")


def math_symbol(name: str) -> str:
    """Return a symbol such as m_xy or beta_x as a formula."""
    letter, _, index = name.partition("_")
    greek = rf"\{letter}" if len(letter) > 1 else letter
    return f"${greek}_{{{index}}}$" if index else f"${greek}$"


def white_outline(width: float) -> list[Any]:
    """Return the effect that sets lines and letters off from the colors around them."""
    from matplotlib.patheffects import withStroke

    return [withStroke(linewidth=width, foreground="white")]


#: Letters are measured so many times as large, at which hinting does not count.
FINER = 10


@cache
def text_width(text: str, size: float, weight: str = "normal") -> float:
    """Return the width of a line of text in letters of some size [pt] and weight, in millimeters."""
    from matplotlib.font_manager import FontProperties, findfont, get_font

    if not text.strip():
        return 0.0
    font = get_font(findfont(FontProperties(family=RC["font.sans-serif"], weight=weight)))
    font.set_size(size, 72 * FINER)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message=".*missing from font")
        font.set_text(text.replace("$", "S"))
    return float(font.get_width_height()[0]) / (64 * FINER) * PT


#: Text width of a page of A4, and the most that stands above each other on it [mm].
PAGE_WIDTH, PAGE_HEIGHT = 180.0, 248.0
#: The same of a page that lies on its side.
WIDE = 260.0
MARGIN = 2.0  # around a sheet [mm]
LINE = 1.25  # from line to line, relative to the size of the letters
#: Sample and gaps beside the words of an entry of the legend [mm].
SAMPLE = 12.0
ROW = 4.2  # of a legend [mm]


@cache
def _sheet() -> type[Figure]:
    """Return the class of figures that a notebook shows as they are."""
    from matplotlib.figure import Figure

    class Sheet(Figure):
        """A figure that a notebook shows without calling Matplotlib."""

        def _repr_png_(self) -> bytes:
            """Return the picture."""
            stream = io.BytesIO()
            with apply_style():
                self.savefig(stream, format="png", dpi=self.dpi)
            return stream.getvalue()

    return Sheet


class Page:
    """A figure of some width [mm] in the making, in the words of a case; how high it is comes out at the end."""

    def __init__(self, width: float, say: Translator = str) -> None:
        self.figure = _sheet()()
        self.width, self.say = width, say
        self._axes: list[tuple[Axes, float, float, float, float]] = []
        self._texts: list[tuple[Text, float, float]] = []

    def add_axes(self, left: float, top: float, width: float, height: float, **options: Any) -> Axes:
        """Return axes in a box [mm]."""
        axes: Axes = self.figure.add_axes((0.0, 0.0, 1.0, 1.0), **options)
        self._axes.append((axes, left, top, width, height))
        return axes

    def write(self, left: float, top: float, text: str, **look: Any) -> None:
        """Write a text, free of formulas, whose upper left corner (or what `ha` says) is at a place [mm]."""
        written = self.figure.text(0, 0, self.say(text), va="top", parse_math=False, **look)
        self._texts.append((written, left, top))

    def write_heading(self, title: str, lines: Sequence[str] = (), warning: str = "") -> float:
        """Write the title, lines below it and a warning; return how far down [mm] they reach."""
        top, space = MARGIN, self.width - 2 * MARGIN
        letters = int(space / text_width("n", TITLE))
        if plain_text(title):
            words = plain_text(title, letters, 2)
            written = self.figure.suptitle(words, fontsize=TITLE, fontweight="bold", ha="left", va="top", color=INK)
            written.set_parse_math(False)
            self._texts.append((written, MARGIN, top))
            top += LINE * TITLE * PT * (words.count("\n") + 1) + 0.8
        for line in filter(None, lines):
            words = plain_text(self.say(line), int(space / text_width("n", BASE)), 2)
            self.write(MARGIN, top, words, fontsize=BASE, color=GREY)
            top += LINE * BASE * PT * (words.count("\n") + 1) + 0.4
        if warning:
            self.write(MARGIN, top, warning, fontsize=BASE, fontweight="bold", color=BAD)
            top += LINE * BASE * PT + 0.4
        return top + 1.5

    def finish(self, bottom: float, legend: Mapping[str, Any] | None = None, *, signed: bool = True) -> Figure:
        """Return the figure: all that was placed reaches down to the bottom [mm], below it comes the legend.

        Signed figures name the program and its version at the lower right.
        """
        words = list(map(self.say, legend or {}))
        widths = [SAMPLE + text_width(word, SMALL) for word in words]
        space = self.width - 2 * MARGIN
        columns = next((k for k in range(len(words), 1, -1) if sum(_widest(widths, k)) <= space), 1)
        rows = -(-len(words) // columns)
        height = bottom + rows * ROW + (1.5 if rows else 0.0) + FOOT * PT + MARGIN
        self.figure.set_size_inches(self.width * MM, height * MM)
        for axes, left, top, wide, high in self._axes:
            axes.set_position((left / self.width, 1 - (top + high) / height, wide / self.width, high / height))
        if signed:
            corner = (self.width - MARGIN, height - MARGIN - FOOT * PT)
            self.write(*corner, Name(f"groundslab {__version__}"), fontsize=FOOT, color=GREY, ha="right")
        for written, left, top in self._texts:
            written.set_position((left / self.width, 1 - top / height))
        if legend:
            drawn = self.figure.legend(
                legend.values(), words, loc="upper left", bbox_to_anchor=(MARGIN / self.width, 1 - bottom / height),
                ncols=columns, borderaxespad=0.0, borderpad=0.0, handlelength=2.4, columnspacing=1.6,
            )  # fmt: skip
            for text in drawn.get_texts():
                text.set_parse_math(False)
        return self.figure


def _widest(widths: Sequence[float], columns: int) -> list[float]:
    """Return how wide each column of a legend is, whose entries run down the columns."""
    return [max(column, default=0.0) for column in np.array_split(widths, columns)]
