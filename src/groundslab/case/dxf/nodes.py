"""Points that are one within a tolerance."""

from __future__ import annotations

import math
from collections import defaultdict

from groundslab.geometry.bulges import Point


class Nodes:
    """Points that are one within a tolerance: the first of them stands for all."""

    def __init__(self, tolerance: float) -> None:
        self.points: list[Point] = []
        self._tolerance = tolerance
        self._cells: dict[tuple[int, int], list[int]] = defaultdict(list)

    def number(self, point: Point) -> int:
        """Return the number of a point, a new one if none is near."""
        column, row = (math.floor(value / self._tolerance) for value in point)
        for cell in ((column + i, row + j) for i in (0, -1, 1) for j in (0, -1, 1)):
            for known in self._cells.get(cell, ()):
                if math.dist(self.points[known], point) <= self._tolerance:
                    return known
        self.points.append(point)
        self._cells[column, row].append(len(self.points) - 1)
        return len(self.points) - 1
