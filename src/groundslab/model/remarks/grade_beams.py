"""Strips along x and y that a slab consists of, as the entries of `output.strips` that design them as beams."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.model.outputs import WIDEST, OutputStrip, check_output
from groundslab.model.plates.region import get_plate_region

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: A plan with more lines than this along an axis is no grid of strips.
MOST_LINES = 100
#: A strip is at least so many times as long as it is wide.
LONG = 2.0
#: What counts as rounding, over the longer side of the plan.
ROUNDING = 1e-6

#: Ways along x and along y: x0, x1, y0, y1 [m].
Rectangle = tuple[float, float, float, float]


def find_strips(model: Model) -> tuple[OutputStrip, ...]:
    """Return the strips along x and y that a plan of such edges consists of, from edge to edge, as beams.

    They cover all of the plan, and cross each other. Empty where it is no such grid: edges at an angle or curved, parts
    wider than five times the thickness, or strips that become wider.
    """
    region = get_plate_region(model.plate, model.plates)
    rectangles = _rectangles(region.area, WIDEST * max(plate.thickness for plate in model.every_plate))
    taken = {strip.name for strip in model.output.strips}
    strips = list[OutputStrip]()
    for along in (0, 1):
        names = (name for n in itertools.count(1) if (name := f"{'xy'[along]} {n}") not in taken)
        strips += [_strip(next(names), rectangle, along) for rectangle in rectangles[along]]
    if not strips or not _covers(region.area, strips):
        return ()
    output = model.output.model_copy(update={"strips": (*model.output.strips, *strips)})
    try:
        doubts = list(check_output(model.plate, model.plates, model.ground, output))
    except InputError:
        return ()
    return () if doubts else tuple(strips)


def as_toml(strips: Sequence[OutputStrip]) -> str:
    """Return strips as entries of a case file, to be pasted at its end."""

    def place(at: tuple[float, float]) -> str:
        return "[" + ", ".join(f'"{way:.9g} m"' for way in at) + "]"

    return "\n".join(
        f'[[output.strips]]\nname = "{strip.name}"\nstart = {place(strip.start)}\nend = {place(strip.end)}\n'
        f'width = "{strip.width:.9g} m"\ndesign = "{strip.design}"\n'
        for strip in strips
    )


def _strip(name: str, rectangle: Rectangle, along: int) -> OutputStrip:
    """Return a rectangle along x (0) or y (1) as a strip that is a beam."""
    x0, x1, y0, y1 = rectangle
    start, end = (((x0, (y0 + y1) / 2), (x1, (y0 + y1) / 2)), (((x0 + x1) / 2, y0), ((x0 + x1) / 2, y1)))[along]
    width = x1 - x0 if along else y1 - y0
    rounded = [tuple(round(way, 6) for way in place) for place in (start, end)]
    return OutputStrip.model_validate(
        {"name": name, "start": rounded[0], "end": rounded[1], "width": round(width, 6), "design": "beam"}
    )


def _covers(area: BaseGeometry, strips: Sequence[OutputStrip]) -> bool:
    """Return whether strips cover all of an area."""
    from shapely import union_all

    return bool(area.difference(union_all([strip.area() for strip in strips])).area <= ROUNDING * area.area)


def _rectangles(area: BaseGeometry, widest: float) -> tuple[list[Rectangle], list[Rectangle]]:
    """Return the largest rectangles in an area that are long along x, and along y, and no wider than so much [m]."""
    from shapely import box, get_coordinates, intersection

    lines = [np.unique(np.round(ways, 6)) for ways in get_coordinates(area).T]
    if max(map(len, lines)) > MOST_LINES:
        return [], []
    x, y = lines
    low_x, low_y = np.meshgrid(x[:-1], y[:-1], indexing="ij")
    high_x, high_y = np.meshgrid(x[1:], y[1:], indexing="ij")
    cells = box(low_x, low_y, high_x, high_y)
    share = np.vectorize(lambda shape: shape.area)(intersection(cells, area)) / ((high_x - low_x) * (high_y - low_y))
    inside = share > 1 - ROUNDING
    along_x = [(x0, x1, y0, y1) for x0, x1, y0, y1 in _runs(inside, x, y, widest)]
    along_y = [(x0, x1, y0, y1) for y0, y1, x0, x1 in _runs(inside.T, y, x, widest)]
    return along_x, along_y


def _runs(inside: Flags, along: Array, across: Array, widest: float) -> Iterator[Rectangle]:
    """Yield rectangles of cells (m, w) that none contains, as their ways along and across [m]."""
    w = inside.shape[1]
    for j0, j1 in itertools.combinations(range(w + 1), 2):
        width = float(across[j1] - across[j0])
        if width > widest:
            continue
        full = np.concatenate([[False], inside[:, j0:j1].all(axis=1), [False]])
        edges = np.flatnonzero(full[1:] != full[:-1])
        for i0, i1 in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
            wider = (j0 > 0 and inside[i0:i1, j0 - 1].all()) or (j1 < w and inside[i0:i1, j1].all())
            if not wider and along[i1] - along[i0] >= LONG * width:
                yield float(along[i0]), float(along[i1]), float(across[j0]), float(across[j1])
