"""At which moments bars and cracks are judged at columns, piles, ends of walls and across walls."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from groundslab.model.outputs import OutputStrip
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Choice, Quantity
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range

AtColumns = Literal["width", "face", "peak"]
AtWalls = Literal["face", "quarter", "peak"]
Basis = Literal["element", "strip"]
#: Widths that grow with the support c, the effective depth d, and the thickness h.
WidthRule = Literal["c + 2 d", "c + 3 h"]
WIDTH = Range(at_least=0.05, at_most=20.0)
#: A strip runs along an axis if it leaves it by less than this share of its length.
ALONG = 1e-6


def _check_width(at_columns: AtColumns, given: set[str]) -> Iterator[RelativeIssue]:
    if "width" in given and at_columns != "width":
        expected = 'no width, or at_columns = "width"'
        yield RelativeIssue(("width",), f'a width with at_columns = "{at_columns}"', expected)


class Averaging(Section):
    """Where moments at supports are taken, and over which width their mean counts.

    What a slab's theory gives at the node under a column grows as the mesh gets finer, and bars there share it.
    """

    constraints: ClassVar[tuple[Check, ...]] = (_check_width,)

    at_columns: Annotated[
        AtColumns,
        Choice(
            AtColumns,
            "moments at columns, piles and ends of walls: the mean over a width of those at the face, those at the "
            "face (EN 1992-1-1 5.3.2.2(3), ACI 318-19 13.2.7.1), or the peaks at nodes",
        ),
    ] = "width"
    width: Annotated[
        WidthRule | float,
        Quantity(
            "length",
            "b",
            "width of that mean, across the bars: the support and d, or 1.5 h (ACI 318-19 8.4.2.2.3), on each side, "
            "or a length",
            WIDTH,
            words=("c + 2 d", "c + 3 h"),
            example="1.5 m",
        ),
    ] = "c + 2 d"
    at_walls: Annotated[
        AtWalls,
        Choice(
            AtWalls,
            "moments across walls: at the face, as of concrete walls, half way from the axis to it, as of masonry "
            "(ACI 318-19 13.2.7.1), or the peaks at nodes",
        ),
    ] = "face"
    by: Annotated[
        Basis,
        Choice(
            Basis,
            "bars along a strip of output.strips by the moments of each place, or by their mean over the strip's width",
        ),
    ] = "element"


def along_axis(strip: OutputStrip) -> int | None:
    """Return whether a strip runs along x (0) or y (1); None if along neither."""
    run = [abs(b - a) for a, b in zip(strip.start, strip.end, strict=True)]
    axis = int(run[1] > run[0])
    return axis if run[1 - axis] <= ALONG * run[axis] else None
