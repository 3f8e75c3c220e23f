"""Pictures for paper, which need no script: the governing settlement, pressure and moments, as PNG within the page."""

from __future__ import annotations

import base64
import io
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab._version import __version__
from groundslab.results.fields import PLATE_FIELDS

if TYPE_CHECKING:
    from groundslab.results.results import Combined, Results

#: Resolution of the pictures [1/in]: enough for paper, little enough for a mail.
DPI = 110
#: Which field shows what governs, and what that is called.
FIELDS = {
    "settlement": "settlement", "uplift": "settlement", "pressure": "pressure", "moment_x": "moment_x",
    "moment_y": "moment_y",
}  # fmt: skip
GOVERNS = {
    "settlement": "largest settlement", "uplift": "largest uplift", "pressure": "largest contact pressure",
    "moment_x": "largest moment along x", "moment_y": "largest moment along y",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Picture:
    """A picture as the address of its data, what it shows, and its size [px]."""

    source: str
    caption: str
    width: int
    height: int


def governing(combined: Combined) -> dict[str, str]:
    """Return which certified combination has the largest settlement, uplift, pressure and moments, by what governs.

    Uplift only if the plate lifts somewhere. Of a moment its size counts.
    """
    wanted: dict[str, Callable[[Results], float]] = {
        "settlement": lambda results: float(results.plate.settlement.max()),
        "uplift": lambda results: float(-results.plate.settlement.min()),
        "pressure": lambda results: float(results.plate.pressure.max()),
        "moment_x": lambda results: float(np.abs(results.plate.moment_x).max()),
        "moment_y": lambda results: float(np.abs(results.plate.moment_y).max()),
    }
    if not combined.results:
        return {}
    found = {
        what: max(combined.results, key=lambda name: size(combined.results[name])) for what, size in wanted.items()
    }
    if all(results.plate.in_contact.all() for results in combined.results.values()):
        del found["uplift"]
    return found


def pictures_of(combined: Combined) -> list[Picture]:
    """Return the governing settlement, contact pressure and moments; where the plate lifts, its settlement then too."""
    found = governing(combined)
    drawn: dict[tuple[str, str], list[str]] = {}
    for what, name in found.items():
        drawn.setdefault((FIELDS[what], name), []).append(what)
    several = len(combined.combinations) > 1
    pictures = []
    for (field, name), why in drawn.items():
        about = PLATE_FIELDS[field]
        words = " and ".join(GOVERNS[each] for each in why)
        governs = f"; this combination governs the {words}" if several else ""
        of = f", {name}" if several else ""
        caption = f"{about.meaning[0].upper()}{about.meaning[1:]}, {about.symbol} [{about.unit}]{of}{governs}."
        pictures.append(_picture(combined.results[name], field, caption))
    return pictures


def _picture(results: Results, field: str, caption: str) -> Picture:
    """Return one field of one combination as a picture within the page."""
    from groundslab.views.plots import plot

    figure = plot(results, field)
    content = io.BytesIO()
    figure.savefig(content, format="png", dpi=DPI, metadata={"Software": f"groundslab {__version__}"})
    png = content.getvalue()
    # width and height stand at fixed places of a PNG's head
    width, height = (int.from_bytes(png[start : start + 4], "big") for start in (16, 20))
    return Picture(f"data:image/png;base64,{base64.b64encode(png).decode()}", caption, width, height)
