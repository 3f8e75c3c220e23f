"""The pieces that a perimeter is made of, straight or round, so that its sums can be added up by hand.

A perimeter is computed from legs, short chords where it is round (`line_properties`). Here legs that go on in one
direction, or turn by little and each time as much, are one piece. What a piece adds is the sum over its own legs, so
that the pieces add up to what the checks use of the whole.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.design.demands.line_properties import (
    SAME,
    centroid,
    dashed,
    directions,
    moduli,
    second_moments,
    total_length,
)

#: Chords of one arc turn by less than this [rad]; a quarter of a circle has 64.
MOST_BEND = np.radians(6.0)
#: Where an arc meets a straight part it turns by half as much as between two chords, whose turns are equal.
TANGENT = 0.75
#: An arc turns at least so many times; what turns less is straight pieces.
LEAST_BENDS = 3
#: Places farther off a circle than this share of its radius are on none.
OFF_CIRCLE = 1e-3


class WeightedLegs(NamedTuple):
    """Legs of a perimeter of which a share counts, as dashes no farther from each other than a length."""

    legs: Array  # (l, 2, 2) [m]
    share: float = 1.0
    longest: float = np.inf  # [m]
    shear: Array | None = None  # (l,): of the slab across each of them [N], if it is known
    thinner: tuple[float, float] | None = None  # by how much the slab is thinner, and how far from the face that is [m]

    @property
    def counted(self) -> Array:
        """Return what counts of them (k, 2, 2) [m]."""
        return self.legs if self.share == 1 else dashed(self.legs, self.share, self.longest)


def what_counts(parts: Sequence[WeightedLegs]) -> Array:
    """Return what counts of all parts of a perimeter (k, 2, 2) [m]; the legs themselves if they all count."""
    return parts[0].counted if len(parts) == 1 else np.concatenate([part.counted for part in parts])


class Piece(NamedTuple):
    """A piece of a perimeter, its places along some axes from some origin, and what it adds to the sums of the whole.

    e is the distance from the center of what counts of the whole perimeter.
    """

    start: Array  # (2,) [m]
    end: Array  # (2,) [m]
    radius: float | None  # of an arc [m]; None of a straight piece; nan of a curve that is no arc
    share: float  # of its length that counts
    length: float  # what counts of it [m]
    middle: Array  # (2,): centroid of what counts of it [m]
    moduli: Array  # (2,): int |e| dl [m2]
    second: Array  # (2, 2): int e e^T dl [m3]
    along: Array  # (2, 2): int t t^T dl, t along the piece [m]
    legs: Array  # (l, 2, 2): all of it on the plan [m]
    shear: float | None = None  # of the slab across it [N], if it is known


def pieces_of(parts: Sequence[WeightedLegs], axes: Array, origin: Array) -> list[Piece]:
    """Return the pieces of a perimeter, one after the other.

    Parameters
    ----------
    parts : sequence of WeightedLegs
        What counts of it.
    axes : (2, 2) array of float
        Unit vectors of the axes that places are along.
    origin : (2,) array of float
        Where places are measured from [m].
    """
    whole = what_counts(parts)
    if len(whole) == 0:
        return []
    center = centroid(whole)
    return [
        _piece(_in_order(part, order), axes, origin, center)
        for part in parts
        if len(part.counted)
        for order in _orders(part.legs)
    ]


def _in_order(part: WeightedLegs, order: Integers) -> WeightedLegs:
    """Return some of the legs of a part, in an order."""
    return part._replace(legs=part.legs[order], shear=None if part.shear is None else part.shear[order])


def _piece(part: WeightedLegs, axes: Array, origin: Array, center: Array) -> Piece:
    """Return a piece of a perimeter about its center (2,) [m]."""
    legs, counted = part.legs, part.counted
    return Piece(
        axes @ (legs[0, 0] - origin),
        axes @ (legs[-1, 1] - origin),
        _radius(legs) if np.abs(_turns(legs)[1:]).max(initial=0.0) > SAME else None,
        part.share,
        total_length(counted),
        axes @ (centroid(counted) - origin),
        moduli(counted @ axes.T, axes @ center),
        axes @ second_moments(counted, center) @ axes.T,
        axes @ directions(counted) @ axes.T,
        legs,
        None if part.shear is None else float(part.shear.sum()),
    )


def _turns(legs: Array) -> Array:
    """Return by what angle each leg turns from the one before it (l,) [rad], the first one from the last."""
    run = legs[:, 1] - legs[:, 0]
    before = np.roll(run, 1, axis=0)
    cross = before[:, 0] * run[:, 1] - before[:, 1] * run[:, 0]
    return np.asarray(np.arctan2(cross, (before * run).sum(axis=1)))


def _orders(legs: Array) -> list[Integers]:
    """Return which legs each piece has, in their order around."""
    turns = _turns(legs)
    near = np.linalg.norm(legs[:, 0] - np.roll(legs[:, 1], 1, axis=0), axis=1) <= SAME
    size = np.where(near & (np.abs(turns) > SAME) & (np.abs(turns) <= MOST_BEND), np.abs(turns), 0.0)
    at_tangent = size < TANGENT * np.maximum(np.roll(size, 1), np.roll(size, -1))
    joined = (near & (np.abs(turns) <= SAME)) | _several((size > 0) & ~at_tangent)
    first = int(np.argmin(joined))
    order, goes_on = np.roll(np.arange(len(legs)), -first), np.roll(joined, -first)
    return np.split(order, np.flatnonzero(~goes_on[1:]) + 1)


def _several(bends: Flags) -> Flags:
    """Return which bends (l,) are among LEAST_BENDS or more that follow each other, all around."""
    if bends.all():
        return bends
    first = int(np.argmin(bends))
    turned = np.roll(bends, -first)
    run = np.cumsum(~turned)
    counts = np.bincount(run[turned], minlength=run[-1] + 1)
    return np.asarray(np.roll(turned & (counts[run] >= LEAST_BENDS), first))


def _radius(legs: Array) -> float:
    """Return the radius [m] of the circle that legs (l, 2, 2) run along; nan if they run along none."""
    places = legs[1:, 0]  # the ends may lie on chords that are cut
    if len(places) <= LEAST_BENDS:
        places = np.vstack([legs[:, 0], legs[-1:, 1]])
    x, y = (places - places.mean(axis=0)).T
    solved = np.linalg.lstsq(np.column_stack([2 * x, 2 * y, np.ones_like(x)]), x**2 + y**2, rcond=None)[0]
    radius = float(np.sqrt(solved[2] + solved[0] ** 2 + solved[1] ** 2))
    off = np.abs(np.hypot(x - solved[0], y - solved[1]) - radius).max()
    return radius if off <= OFF_CIRCLE * radius else float("nan")
