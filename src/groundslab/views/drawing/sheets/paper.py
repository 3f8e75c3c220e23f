"""Sheets of paper: their sizes, frames, the column of the title block, and the scale at which a plan fits."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Literal, get_args

from groundslab.errors import InputError, Issue
from groundslab.unit_systems import System
from groundslab.views.drawing.shapes import Shape

Paper = Literal["a1", "a2", "a3"]
PAPERS: tuple[Paper, ...] = get_args(Paper)
#: Width and height across [mm] (ISO 216).
SIZES: dict[Paper, tuple[float, float]] = {"a1": (841.0, 594.0), "a2": (594.0, 420.0), "a3": (420.0, 297.0)}
#: From the trimmed edge to the frame: at the left, where sheets are filed, and elsewhere [mm] (ISO 5457).
FILED, EDGE = 20.0, 10.0
#: Width of the column at the right with the list and the title block [mm]: 180 is that of ISO 7200.
COLUMN: dict[Paper, float] = {"a1": 180.0, "a2": 180.0, "a3": 130.0}
#: Scales that may be chosen, 1 : n, the largest first: in US units 1/2, 3/8, 1/4, 3/16, 1/8, 3/32 and 1/16 in for 1 ft.
SCALES: dict[System, tuple[int, ...]] = {"SI": (25, 50, 75, 100, 200), "US": (24, 32, 48, 64, 96, 128, 192)}
#: Heights of letters [mm] (ISO 3098).
SMALL, LETTERS, LARGE = 1.8, 2.5, 5.0

#: A rectangle x0, y0, x1, y1 [mm].
Box = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Margins:
    """What stands around a plan [mm]: dimensions at the left and below, axes above and at the right."""

    left: float
    below: float
    right: float
    above: float


@dataclass(frozen=True, slots=True)
class Sheet:
    """A sheet with its shapes in millimeters of paper, from its lower left corner.

    A place x, y of the case [m] is at origin + 1000 (x, y) / scale.
    """

    title: str
    paper: Paper
    scale: int
    origin: tuple[float, float]
    shapes: list[Shape] = field(default_factory=list)

    @property
    def per_meter(self) -> float:
        """Return the millimeters of paper for a meter."""
        return 1000.0 / self.scale


def plan_area(paper: Paper) -> Box:
    """Return the rectangle for the plan: the frame without the column at the right [mm]."""
    width, height = SIZES[paper]
    return (FILED, EDGE, width - EDGE - COLUMN[paper], height - EDGE)


def scale_words(scale: int, units: System) -> str:
    """Return a scale 1 : n as drawings have it, in US units as inches of paper for a foot."""
    return f"1 : {scale}" if units == "SI" else f'{Fraction(12, scale)}" = 1\'-0"'


def choose_scale(
    paper: Paper,
    bounds: tuple[float, float, float, float],
    margins: Callable[[float], Margins],
    least: int = 0,
    units: System = "SI",
) -> tuple[int, tuple[float, float]]:
    """Return the largest scale at which a plan fits, and where its origin is on paper [mm]; raises InputError.

    Bounds are x0, x1, y0, y1 [m]; margins depend on the millimeters for a meter. Of the scale 1 : n n is not less than
    a least one.
    """
    x0, x1, y0, y1 = bounds
    left, low, right, high = plan_area(paper)
    for scale in (scale for scale in SCALES[units] if scale >= least):
        per_meter = 1000.0 / scale
        around = margins(per_meter)
        width, height = (x1 - x0) * per_meter, (y1 - y0) * per_meter
        spare_x = right - left - around.left - width - around.right
        spare_y = high - low - around.below - height - around.above
        if spare_x >= 0 and spare_y >= 0:
            x = left + around.left + spare_x / 2 - x0 * per_meter
            y = low + around.below + spare_y / 2 - y0 * per_meter
            return scale, (x, y)
    slab_size = f"a slab of {x1 - x0:.4g} m by {y1 - y0:.4g} m"
    expected = f"one that fits on {paper.upper()} at {scale_words(SCALES[units][-1], units).replace(' : ', ':')}"
    raise InputError([Issue("paper", slab_size, expected, "choose larger paper, or draw it without a size of paper")])
