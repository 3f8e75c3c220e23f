"""The picture of `solve --plot`: settlement and contact pressure in plan, with all that lies on the plate."""

from __future__ import annotations

from typing import TYPE_CHECKING

from groundslab.results.results import alone
from groundslab.views.plots import files, plan
from groundslab.views.plots.request import wish_of
from groundslab.views.plots.style import styled

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.figure import Figure

    from groundslab.results.results import Results

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
