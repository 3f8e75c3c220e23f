"""Links against punching that are given: perimeters around a column, pile, thicker zone or end of a wall."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from groundslab.model.design.bars import Diameter
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Choice, Integer, ListOf, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range

LinkKind = Literal["links", "studs"]
#: Of a perimeter, at most.
MOST_LEGS = 1000
#: How far from the face perimeters are [m].
DISTANCE = Range(above=0, at_most=50.0)


def _check_legs(legs: tuple[int, ...], distances: tuple[float, ...]) -> Iterator[RelativeIssue]:
    if len(legs) not in (1, len(distances)):
        counts = f"{len(legs)} numbers for {len(distances)} perimeters"
        yield RelativeIssue(("legs",), counts, "one for each perimeter, or one for all of them")


class PunchingLinks(Section):
    """Vertical legs in perimeters around what punches the slab, which punching is checked with."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_legs,)

    of: Annotated[
        str, Text('what they are around: the name of a column, pile or support, "zone 1", or "end of" and a wall')
    ]
    diameter: Annotated[float, Diameter(symbol="phi_w", meaning="diameter of the legs", example="10 mm")]
    distances: Annotated[
        tuple[float, ...],
        ListOf(
            Quantity("length", "s", "", DISTANCE, example="150 mm"),
            "s",
            "distances of the perimeters from the face, the inner one first",
            rising=True,
        ),
    ]
    legs: Annotated[
        tuple[int, ...],
        ListOf(Integer("", at_least=1, at_most=MOST_LEGS), "n", "legs on each perimeter, or on every one"),
    ]
    kind: Annotated[
        LinkKind, Choice(LinkKind, "links, or headed studs by ACI 318-19; by EN 1992-1-1 studs follow their approval")
    ] = "links"

    @property
    def counts(self) -> tuple[int, ...]:
        """Return the legs on each perimeter."""
        return self.legs if len(self.legs) > 1 else self.legs * len(self.distances)

    @property
    def leg_area(self) -> float:
        """Return the area of one leg [m2]."""
        return math.pi * self.diameter**2 / 4

    @property
    def areas(self) -> tuple[float, ...]:
        """Return the area of all legs on each perimeter [m2]."""
        return tuple(count * self.leg_area for count in self.counts)

    @property
    def apart(self) -> float | None:
        """Return the largest distance from a perimeter to the next [m]; None of a single one."""
        return max((b - a for a, b in zip(self.distances, self.distances[1:], strict=False)), default=None)
