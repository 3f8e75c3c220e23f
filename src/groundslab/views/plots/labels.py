"""The words on a plan: names of columns, thickness of zones, the extremes; each where it covers least."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.views.plots.panels import View, extremes_of
from groundslab.views.plots.spots import Spot, Spots
from groundslab.views.plots.style import FOOT, INK, PT, SMALL, free, number, width_of
from groundslab.views.plots.symbols import white_edge

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from groundslab.arrays import Array
    from groundslab.model.model import Model

#: More columns than this are not named, nor those of plans with fewer millimetres for a metre.
MOST_NAMES, LEAST_SCALE = 60, 2.0
#: Where the name of a column stands beside it, and the thickness of a zone within it; the better places first.
BESIDE: tuple[Spot, ...] = ((1, 1), (-1, 1), (1, -1), (-1, -1))
INSIDE: tuple[Spot, ...] = ((-1, -1), (1, -1), (-1, 1), (1, 1), (0, -1), (0, 1), (-1, 0), (1, 0), (0, 0))


def label(axes: Axes, model: Model, view: View, per_metre: float) -> None:
    """Name the columns, tell the thickness of zones, mark the extremes by rings with their values.

    The words cover neither each other nor the columns, as far as there is room.
    """
    x0, x1, y0, y1 = (per_metre * bound for bound in model.plate.bounds)
    spots = Spots((x0, x1, y0, y1))
    extremes = extremes_of(view)
    for each in extremes:
        spots.take((each.place[0] * per_metre, each.place[1] * per_metre), (1.0, 1.0))
    named = model.columns if per_metre >= LEAST_SCALE and len(model.columns) <= MOST_NAMES else ()
    for column in model.columns:
        (x, y), half = _middle(np.array(column.ring().flat(np.inf)) * per_metre)
        spots.take((x, y), half)
    for word, value, (x, y), _ in extremes:
        axes.plot(
            x, y, "o", markersize=3.6, markerfacecolor="white", markeredgecolor=INK, markeredgewidth=0.9, zorder=7,
            clip_on=False,
        )  # fmt: skip
        words = f"{'max' if word == 'largest' else 'min'} {number(value)}"
        half = width_of(words, SMALL - 0.5) / 2 + 0.5, 0.6 * SMALL * PT
        middle = spots.beside((x * per_metre, y * per_metre), half, 1.6)
        _put(axes, words, middle, per_metre, SMALL - 0.5, boxed=True)
    for column in named:
        (x, y), half = _middle(np.array(column.ring().flat(np.inf)) * per_metre)
        words = free(column.name, 12)
        own = width_of(words, FOOT) / 2 + 0.2, 0.55 * FOOT * PT
        corners = [(x + i * (half[0] + own[0]), y + j * (half[1] + own[1])) for i, j in BESIDE]
        _put(axes, words, spots.best(corners, own), per_metre, FOOT, boxed=False)
    for zone in model.plate.zones:
        if zone.thickness is not None:
            words = f"t = {zone.thickness:g} m"
            own = width_of(words, FOOT + 0.5) / 2 + 0.4, 0.6 * (FOOT + 0.5) * PT
            (x, y), half = _middle(np.array(zone.shape.ring().flat(np.inf)) * per_metre)
            inner = half[0] - own[0] - 0.6, half[1] - own[1] - 0.6
            corners = [(x + i * inner[0], y + j * inner[1]) for i, j in INSIDE]
            _put(axes, words, spots.best(corners, own), per_metre, FOOT + 0.5, boxed=False)


def _middle(places: Array) -> tuple[Spot, Spot]:
    """Return middle and half sides of the box around places (k, 2)."""
    low, high = places.min(axis=0), places.max(axis=0)
    (x, y), (wide, high_) = (low + high) / 2, (high - low) / 2
    return (float(x), float(y)), (float(wide), float(high_))


def _put(axes: Axes, words: str, middle: Spot, per_metre: float, size: float, *, boxed: bool) -> None:
    """Write words about a place [mm]."""
    look: dict[str, Any] = {"path_effects": white_edge(1.5)}
    if boxed:
        look = {"bbox": {"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 0.6}}
    axes.text(
        middle[0] / per_metre, middle[1] / per_metre, words, fontsize=size, ha="center", va="center", color=INK,
        parse_math=False, zorder=8, **look,
    )  # fmt: skip
