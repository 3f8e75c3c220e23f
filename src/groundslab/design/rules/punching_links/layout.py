"""Where the legs of links are around what punches a slab, and with which diameter they need the least steel.

On each perimeter legs are equally far apart along each part that counts: not farther than the code allows, nor than the
required area allows, so that n = ceil(l / s) of them are on a part l long, the outer ones half a spacing from its ends.
What an opening takes off, and what is closer to an edge than the cover, is no such part: no leg is there.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.punching_links.demand import Arrangement, LinkDemand, LinkLimit, LinkRow
from groundslab.errors import InputError
from groundslab.messages import Message
from groundslab.model.design.laid_bars import DENSITY
from groundslab.model.design.punching_links import PunchingLinks

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Legs are at least so far apart along a perimeter [m], so that concrete gets between them.
LEAST_APART = 0.1
#: The legs of so many perimeters are counted one by one in words.
MOST_COUNTS = 5
#: What counts as rounding, relative.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class LinkPerimeter:
    """The legs on one perimeter.

    Attributes
    ----------
    distance : float
        From the face [m].
    length : float
        Of the parts on which legs are [m].
    required, provided : float
        Area of all legs [m2].
    spacing, most_spacing : float
        The largest distance of legs along it, and what the code allows [m].
    places : array (k, 2)
        Where the legs are [m].
    """

    distance: float
    length: float
    required: float
    provided: float
    spacing: float
    most_spacing: float
    places: Array = field(repr=False)


@dataclass(frozen=True, slots=True)
class LinkLayout:
    """The links around a column, pile, thicker zone or end of a wall, or why there are none.

    Attributes
    ----------
    support, name : str
        "column", "pile", "zone" or "wall end", and which.
    place : tuple of float
        Where it is [m].
    combination : str
        The combination that needs most.
    clauses : str
        What the layout follows.
    diameter : float
        Of the legs [m].
    leg : float
        Length of each [m].
    perimeters : tuple of LinkPerimeter
        From the inner to the outer one; none where no links can be laid.
    why : str
        The reason why there are none; else empty.
    limits : tuple of LinkLimit
        Of links that are given: what the code asks of them. None of those that are proposed.
    unknown : bool
        Whether the reason is that the code's rules for the layout are not known here.
    """

    support: Support
    name: str
    place: tuple[float, float]
    combination: str
    clauses: str
    diameter: float = 0.0
    leg: float = 0.0
    perimeters: tuple[LinkPerimeter, ...] = ()
    why: str = ""
    limits: tuple[LinkLimit, ...] = ()
    unknown: bool = False

    @property
    def where(self) -> str:
        """Return what it is around, in words."""
        return self.name if self.support == "zone" else f"{self.support} {self.name}"

    @property
    def number(self) -> int:
        """Return the number of legs."""
        return sum(len(perimeter.places) for perimeter in self.perimeters)

    @property
    def total(self) -> float:
        """Return the length of all legs [m]."""
        return self.number * self.leg

    @property
    def leg_mass(self) -> float:
        """Return the mass of one leg [kg]."""
        return DENSITY * math.pi * self.diameter**2 / 4 * self.leg

    @property
    def mass(self) -> float:
        """Return the mass of all legs [kg]."""
        return self.number * self.leg_mass

    @property
    def counts(self) -> str:
        """Return how many legs there are from the inner to the outer perimeter, in words."""
        counts = [len(perimeter.places) for perimeter in self.perimeters]
        if len(set(counts)) == 1:
            return f"{len(counts)} x {counts[0]}"
        if len(counts) > MOST_COUNTS:
            return Message("{number} perimeters, {legs}", number=len(counts), legs=sum(counts))
        return " + ".join(map(str, counts))

    @property
    def radial(self) -> float | None:
        """Return the distance of the perimeters from each other [m], None of a single one."""
        if len(self.perimeters) < 2:
            return None
        return self.perimeters[1].distance - self.perimeters[0].distance


def lay_links(demand: LinkDemand, diameters: Sequence[float], covers: tuple[float, float]) -> LinkLayout:
    """Return the links of those diameters [m] that need the least steel, with covers [m] at the bottom and the top."""
    arrangement = demand.arrangement
    start = demand.support, demand.name, demand.place, demand.combination, demand.clauses
    if isinstance(arrangement, str):
        return LinkLayout(*start, why=arrangement, unknown=demand.unknown)
    lines = cache(arrangement.lines)
    layouts: list[LinkLayout] = []
    problems: list[str] = []
    leg = arrangement.thickness - sum(covers)
    for diameter in diameters:
        inner = _inner(arrangement, covers, diameter)
        for rows in arrangement.options(diameter):
            try:
                perimeters = [_perimeter(row, _chains(lines(row.distance), inner), diameter) for row in rows]
            except InputError as error:
                problems.append(str(error))
                continue
            if all(perimeter is not None for perimeter in perimeters):
                laid = tuple(perimeter for perimeter in perimeters if perimeter is not None)
                layouts.append(LinkLayout(*start, diameter, leg, laid))
    if not layouts:
        return LinkLayout(*start, why=problems[0] if problems else _no_room(arrangement, diameters))
    return min(layouts, key=lambda layout: (layout.mass, layout.number))


def lay_given_links(demand: LinkDemand, laid: PunchingLinks, covers: tuple[float, float]) -> LinkLayout:
    """Return links that are given, with what the code asks of them, with covers [m] at the bottom and the top.

    Legs are shared out to the parts of a perimeter that count so that they are as near to each other as they can be.
    """
    arrangement = demand.arrangement
    start = demand.support, demand.name, demand.place, demand.combination, demand.clauses
    if isinstance(arrangement, str):
        return LinkLayout(*start, why=arrangement, unknown=demand.unknown)
    inner = _inner(arrangement, covers, laid.diameter)
    limits, perimeters = [*arrangement.limits(laid)], list[LinkPerimeter]()
    for row, count in zip(arrangement.rows(laid), laid.counts, strict=True):
        try:
            parts = _chains(arrangement.lines(row.distance), inner)
        except InputError as error:
            return LinkLayout(*start, why=str(error))
        perimeter = _given_perimeter(row, parts, count, laid.leg_area)
        perimeters.append(perimeter)
        if row.area:
            limits.append(LinkLimit(
                Message("legs {distance:.4g m} from the face", distance=row.distance), perimeter.provided * 1e4,
                row.area * 1e4, "cm2", demand.clauses, least=True,
            ))  # fmt: skip
        what = Message("distance of legs along the perimeter {distance:.4g m} from the face", distance=row.distance)
        limits.append(
            LinkLimit(what, perimeter.spacing * 1e3, row.spacing * 1e3, "mm", demand.clauses, steps=row.steps)
        )
    leg = arrangement.thickness - sum(covers)
    return LinkLayout(*start, laid.diameter, leg, tuple(perimeters), limits=tuple(limits))


def _inner(arrangement: Arrangement, covers: tuple[float, float], diameter: float) -> BaseGeometry:
    """Return where legs of a diameter [m] may stand: as far from edges as the larger cover [m] asks."""
    inner: BaseGeometry = arrangement.plan.buffer(-(max(covers) + diameter / 2))
    return inner


def _given_perimeter(row: LinkRow, parts: list[Array], count: int, of_leg: float) -> LinkPerimeter:
    """Return a perimeter with so many legs on parts of it, each places (k, 2)."""
    lengths = np.array([_length(part) for part in parts])
    counts = np.zeros(len(parts), dtype=int)
    for _ in range(count if len(parts) else 0):
        counts[np.argmax(np.divide(lengths, counts, out=np.full(len(parts), np.inf), where=counts > 0))] += 1
    spacing = max((length / n if n else math.inf for length, n in zip(lengths, counts, strict=True)), default=math.inf)
    places = [_along(part, int(n)) for part, n in zip(parts, counts, strict=True) if n]
    of_all = np.concatenate(places) if places else np.empty((0, 2))
    return LinkPerimeter(
        row.distance, float(lengths.sum()), row.area, of_leg * len(of_all), float(spacing), row.spacing, of_all
    )


def _no_room(arrangement: Arrangement, diameters: Sequence[float]) -> str:
    """Return why no diameter fits."""
    if not any(True for diameter in diameters for _ in arrangement.options(diameter)):
        return "none of reinforcement.proposal.link_diameters may be used in so thin a slab"
    return Message(
        "legs of reinforcement.proposal.link_diameters would be closer than {least_apart:g mm}: allow "
        "thicker ones, or choose a thicker slab",
        least_apart=1e3 * LEAST_APART,
    )


def _perimeter(row: LinkRow, parts: list[Array], diameter: float) -> LinkPerimeter | None:
    """Return a perimeter with legs on parts of it, each places (k, 2); None where they would be too close."""
    lengths = [_length(part) for part in parts]
    length, of_leg = sum(lengths), math.pi * diameter**2 / 4
    if not length:
        return None
    apart = min(row.spacing, length * of_leg / row.area if row.area else math.inf)
    if apart < LEAST_APART:
        return None
    counts = [max(1, math.ceil(part_length / apart * (1 - ROUNDING))) for part_length in lengths]
    spacings = [part_length / count for part_length, count in zip(lengths, counts, strict=True)]
    places = np.concatenate([_along(part, count) for part, count in zip(parts, counts, strict=True)])
    provided = of_leg * len(places)
    return LinkPerimeter(row.distance, length, row.area, provided, max(spacings), row.spacing, places)


def _chains(legs: Array, inner: BaseGeometry) -> list[Array]:
    """Return the connected parts, each places (k, 2), of pieces (l, 2, 2) [m] within a region, the short ones not."""
    from shapely import (
        covers,
        get_coordinates,
        get_parts,
        intersection,
        line_merge,
        linestrings,
        multilinestrings,
        prepare,
    )

    lines = linestrings(legs)
    prepare(inner)
    # few lie in part within it, and only these take long to cut
    cut = ~covers(inner, lines)
    lines[cut] = intersection(lines[cut], inner)
    pieces = get_parts(lines)
    pieces = [piece for piece in pieces if piece.geom_type == "LineString" and piece.length > 0]
    if not pieces:
        return []
    merged = [get_coordinates(part) for part in get_parts(line_merge(multilinestrings(pieces)))]
    return [part for part in merged if _length(part) >= LEAST_APART / 2]


def _right_end(places: Array) -> float:
    """Return how far along a line through places (k, 2) [m] it comes to the middle of its right side."""
    from shapely import LineString, Point

    (_, low), (right, high) = places.min(axis=0), places.max(axis=0)
    return float(LineString(places).project(Point(right, (low + high) / 2)))


def _length(places: Array) -> float:
    """Return the length of a line through places (k, 2) [m]."""
    return float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum())


def _along(places: Array, count: int) -> Array:
    """Return so many places (count, 2) along a line, as far from each other, half of that from its ends.

    Of a closed line they begin in the middle of its right side.
    """
    steps = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(places, axis=0), axis=1))])
    wanted = (np.arange(count) + 0.5) / count * steps[-1]
    if (places[0] == places[-1]).all():
        wanted = (wanted + _right_end(places)) % steps[-1]
    return np.column_stack([np.interp(wanted, steps, places[:, axis]) for axis in (0, 1)])
