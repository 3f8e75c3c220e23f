"""The picture of `solve --plot`: settlement and contact pressure in plan, with all that lies on the plate."""

from __future__ import annotations

from typing import TYPE_CHECKING

from groundslab.plots import files, plan
from groundslab.plots.style import styled
from groundslab.plots.wish import wish_of
from groundslab.results import alone

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.figure import Figure

    from groundslab.results import Results

#: Pixels per inch: enough for a screen, in a file that is not large.
DPI = 140


def write(results: Results, path: Path) -> None:
    """Write the picture as a PNG file."""
    files.save([draw(results)], path, dpi=DPI)


def draw(results: Results) -> Figure:
    """Return the picture as a Matplotlib figure that needs no display."""
    wish = wish_of(alone(results), ("settlement", "pressure"), "plan", None, None, None)
    with styled():
        return plan.sheet(wish)
