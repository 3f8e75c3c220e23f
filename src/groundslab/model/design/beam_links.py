"""Links of beams, and of strips that are beams, that are given."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, ClassVar

from groundslab.model.design.bars import Diameter
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Integer, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range

#: At one place.
MOST_LEGS = 100
#: From one link to the next [m].
SPACING = Range(above=0, at_most=2.0)
#: Along a beam [m].
WAY = Range(at_least=0, at_most=1e4)


def _check_part(start: float, end: float | None) -> Iterator[RelativeIssue]:
    if end is not None and end <= start:
        yield RelativeIssue(("end",), f"{end!r} m", f"more than start, {start!r} m")


class BeamLinks(Section):
    """Closed links at even distances along a beam, or along a part of it."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_part,)

    of: Annotated[str, Text("the beam, or the strip that is designed as one")]
    diameter: Annotated[float, Diameter(symbol="phi_w", meaning="diameter of the links", example="10 mm")]
    legs: Annotated[int, Integer("legs of a link, upright", at_least=2, at_most=MOST_LEGS)] = 2
    spacing: Annotated[
        float, Quantity("length", "s", "distance from one link to the next along the beam", SPACING, example="200 mm")
    ]
    start: Annotated[
        float, Quantity("length", "", "how far from the beam's start they begin", WAY, example="1.2 m")
    ] = 0.0
    end: Annotated[
        float | None,
        Quantity("length", "", "how far from its start they end, by default where it ends", WAY, example="3 m"),
    ] = None

    @property
    def area(self) -> float:
        """Return the area of all legs over the distance [m2/m]."""
        return self.legs * math.pi * self.diameter**2 / 4 / self.spacing
