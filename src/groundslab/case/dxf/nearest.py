"""Which loads are nearest to which texts, in time that grows with their number and not with its square."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab.case.dxf.sheet import Sheet

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

    from groundslab.case.dxf.labels import Label

NEAR = 10  # heights of a text between it and the load that it belongs to
NEAREST = 8  # loads of which one may be that of a text
MOST_BESIDE = 20_000_000  # pairs of texts and loads that are looked at
HALVINGS = 12  # of the distance within which loads are sought first
AT_ONCE = 256  # texts


def nearest(
    texts: Sequence[Label], shapes: Sequence[BaseGeometry | None], sheet: Sheet
) -> Iterator[tuple[float, int, int]]:
    """Yield distance [m], text and shape of the few shapes that are nearest to each text and near enough to be its."""
    import shapely

    if not texts or not shapes:
        return
    lines = shapely.linestrings([(text.start, text.end) for text in texts])
    reach = NEAR * np.array([text.height for text in texts])
    every = np.array(shapes, dtype=object)
    tree = shapely.STRtree(every)
    left = np.arange(len(texts))
    for halvings in range(HALVINGS, -1, -1):
        # in twice the distance at a time: of many shapes within reach only the nearest are ever met
        within = reach * 0.5**halvings
        again = []
        for first in range(0, len(left), AT_ONCE):
            some = left[first : first + AT_ONCE]
            t, s = tree.query(lines[some], predicate="dwithin", distance=within[some])
            sheet.spend(len(t), MOST_BESIDE, "pairs of texts and loads near each other", "write smaller texts")
            count = np.bincount(t, minlength=len(some))
            done = (count >= NEAREST) | (halvings == 0)
            again.append(some[~done])
            keep = done[t]
            t, s = some[t[keep]], s[keep]
            yield from _first(shapely.distance(lines[t], every[s]), t, s)
        left = np.concatenate(again)
        if not len(left):
            return


def _first(gap: np.ndarray, text: np.ndarray, shape: np.ndarray) -> Iterator[tuple[float, int, int]]:
    """Yield the first few of each text, the smallest distances first."""
    order = np.lexsort((shape, gap, text))
    gap, text, shape = gap[order], text[order], shape[order]
    starts = np.flatnonzero(np.diff(text, prepend=-1))
    rank = np.arange(len(text)) - np.repeat(starts, np.diff(np.append(starts, len(text))))
    few = rank < NEAREST
    yield from zip(gap[few].tolist(), text[few].tolist(), shape[few].tolist(), strict=True)
