"""A sheet of paper: a figure whose parts are placed in millimetres from its upper left corner."""

from __future__ import annotations

import io
from functools import cache
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.views.plots.style import BAD, BASE, FOOT, GREY, INK, MM, PT, SMALL, TITLE, free, styled, width_of

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.text import Text

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
        """A figure that a notebook shows without Matplotlib being told to."""

        def _repr_png_(self) -> bytes:
            """Return the picture."""
            stream = io.BytesIO()
            with styled():
                self.savefig(stream, format="png", dpi=self.dpi)
            return stream.getvalue()

    return Sheet


class Paper:
    """A figure of some width [mm] in the making; how high it is comes out at the end."""

    def __init__(self, width: float) -> None:
        self.figure = _sheet()()
        self.width = width
        self._axes: list[tuple[Axes, float, float, float, float]] = []
        self._texts: list[tuple[Text, float, float]] = []

    def axes(self, left: float, top: float, width: float, height: float, **options: Any) -> Axes:
        """Return axes in a box [mm]."""
        made: Axes = self.figure.add_axes((0.0, 0.0, 1.0, 1.0), **options)
        self._axes.append((made, left, top, width, height))
        return made

    def text(self, left: float, top: float, text: str, **look: Any) -> None:
        """Write a text, free of formulas, whose upper left corner (or what `ha` says) is at a place [mm]."""
        written = self.figure.text(0, 0, text, va="top", parse_math=False, **look)
        self._texts.append((written, left, top))

    def head(self, title: str, lines: Sequence[str] = (), warning: str = "") -> float:
        """Write the title, lines below it and a warning; return how far down [mm] they reach."""
        top, room = MARGIN, self.width - 2 * MARGIN
        letters = int(room / width_of("n", TITLE))
        if free(title):
            words = free(title, letters, 2)
            written = self.figure.suptitle(words, fontsize=TITLE, fontweight="bold", ha="left", va="top", color=INK)
            written.set_parse_math(False)
            self._texts.append((written, MARGIN, top))
            top += LINE * TITLE * PT * (words.count("\n") + 1) + 0.8
        for line in filter(None, lines):
            words = free(line, int(room / width_of("n", BASE)), 2)
            self.text(MARGIN, top, words, fontsize=BASE, color=GREY)
            top += LINE * BASE * PT * (words.count("\n") + 1) + 0.4
        if warning:
            self.text(MARGIN, top, warning, fontsize=BASE, fontweight="bold", color=BAD)
            top += LINE * BASE * PT + 0.4
        return top + 1.5

    def finish(self, bottom: float, legend: Mapping[str, Any] | None = None) -> Figure:
        """Return the figure: all that was placed reaches down to the bottom [mm], below it comes the legend."""
        words = list(legend or {})
        widths = [SAMPLE + width_of(each, SMALL) for each in words]
        columns = next(
            (k for k in range(len(words), 1, -1) if sum(_widest(widths, k)) <= self.width - 2 * MARGIN), 1
        )  # fmt: skip
        rows = -(-len(words) // columns)
        height = bottom + rows * ROW + (1.5 if rows else 0.0) + FOOT * PT + MARGIN
        self.figure.set_size_inches(self.width * MM, height * MM)
        for made, left, top, wide, high in self._axes:
            made.set_position((left / self.width, 1 - (top + high) / height, wide / self.width, high / height))
        self.text(
            self.width - MARGIN, height - MARGIN - FOOT * PT, f"groundslab {__version__}", fontsize=FOOT, color=GREY,
            ha="right",
        )  # fmt: skip
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
    rows, more = divmod(len(widths), columns)
    found, first = [], 0
    for column in range(columns):
        count = rows + (column < more)
        found.append(max(widths[first : first + count], default=0.0))
        first += count
    return found
