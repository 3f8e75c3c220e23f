"""Where words can stand on a drawing so that they cover as little as possible; all lengths in millimetres of paper."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

Spot = tuple[float, float]

#: The eight sides of a place, the better ones first: as multiples of half a word's size beyond it.
AROUND: tuple[Spot, ...] = ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (-1, 1), (1, -1), (-1, -1))
#: What it costs to leave the drawing by a millimetre, in square millimetres that are covered.
OUTSIDE = 8.0
#: So much better is each side than the next one, where all else is equal.
ORDER = 1e-3


@dataclass(slots=True)
class Spots:
    """What is taken on a drawing: boxes by their middles and half sides, within limits x0, x1, y0, y1."""

    limits: tuple[float, float, float, float]
    taken: list[tuple[float, float, float, float]] = field(default_factory=list)

    def take(self, middle: Spot, half: Spot) -> None:
        """Let nothing else stand in a box, if that can be helped."""
        self.taken.append((*middle, *half))

    def beside(self, place: Spot, half: Spot, distance: float, sides: Sequence[Spot] = AROUND) -> Spot:
        """Return the middle of a box of some half size beside a place, and take it."""
        return self.best(
            ((place[0] + right * (half[0] + distance), place[1] + up * (half[1] + distance)) for right, up in sides),
            half,
        )

    def best(self, middles: Iterable[Spot], half: Spot) -> Spot:
        """Return the middle of those given whose box covers least, and take it; of equal ones the first."""
        found = min(enumerate(middles), key=lambda each: self._cost(each[1], half) + ORDER * each[0])[1]
        self.take(found, half)
        return found

    def _cost(self, middle: Spot, half: Spot) -> float:
        """Return how much a box covers [mm2], with a high price for what leaves the drawing."""
        x0, x1, y0, y1 = self.limits
        (x, y), (wide, high) = middle, half
        cost = OUTSIDE * max(x0 + wide - x, x + wide - x1, y0 + high - y, y + high - y1, 0.0)
        for other_x, other_y, other_wide, other_high in self.taken:
            over_x, over_y = wide + other_wide - abs(x - other_x), high + other_high - abs(y - other_y)
            if over_x > 0 and over_y > 0:
                cost += over_x * over_y
        return cost
