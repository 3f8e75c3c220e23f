"""What straight pieces of a perimeter amount to: length, center, moduli, second moments, and how they run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple

import numpy as np

from groundslab.arrays import Array, made_once

#: Places [m] and directions closer than this are the same.
SAME = 1e-6
#: A part of a perimeter that turns by no more cuts a strip [degrees].
STRIP = 90.0
#: How a perimeter runs, by the angle in degrees that it turns at least.
Shape = Literal["closed", "edge", "corner", "cut"]
TURNED: Mapping[Shape, float] = {"closed": 225.0, "edge": 135.0, "corner": 45.0, "cut": -1.0}


class Course(NamedTuple):
    """How a perimeter runs."""

    shape: Shape
    frame: Array  # (2, 2): unit vectors from end to end and across; the own axes of what a closed one is around
    inward: Array  # (k, 2): unit vectors from the plate's edges inwards, where its two ends are; none of a closed one


def lengths(legs: Array) -> Array:
    """Return the length of each piece (l,) [m] of legs (l, 2, 2) [m]."""
    return np.asarray(np.linalg.norm(legs[:, 1] - legs[:, 0], axis=1))


def total_length(legs: Array) -> float:
    """Return the length [m] of legs (l, 2, 2) [m]."""
    return float(lengths(legs).sum())


def centroid(legs: Array) -> Array:
    """Return the centroid (2,) [m] of straight pieces (l, 2, 2) of a perimeter."""
    length = lengths(legs)
    return np.asarray(length @ legs.mean(axis=1) / length.sum())


def moduli(legs: Array, axes: Array) -> Array:
    """Return W_1 = int |e| dl (2,) [m2] of a perimeter, e along x and along y from axes (2,) [m], by 6.40."""
    length = lengths(legs)[:, None]
    start, end = legs[:, 0] - axes, legs[:, 1] - axes
    size = np.abs(start) + np.abs(end)
    crossing = np.divide(start**2 + end**2, 2 * size, out=np.zeros_like(size), where=size > 0)
    return np.asarray((length * np.where(start * end >= 0, size / 2, crossing)).sum(axis=0))


def dashed(legs: Array, share: float, longest: float) -> Array:
    """Return dashes (k, 2, 2) that are a share of legs (l, 2, 2), no farther from each other than a length [m]."""
    if share <= 0:
        return legs[:0]
    run = legs[:, 1] - legs[:, 0]
    counts = np.maximum(1, np.ceil(np.linalg.norm(run, axis=1) / longest)).astype(int)
    leg = np.repeat(np.arange(len(legs)), counts)
    number = np.arange(len(leg)) - np.repeat(np.cumsum(counts) - counts, counts)
    middle = ((number + 0.5) / counts[leg])[:, None]
    half = (share / 2 / counts[leg])[:, None]
    start = legs[leg, 0]
    return np.stack([start + (middle - half) * run[leg], start + (middle + half) * run[leg]], axis=1)


def straight(legs: Array) -> bool:
    """Return whether straight pieces (l, 2, 2) [m] all lie on one line."""
    places = legs.reshape(-1, 2)
    return bool(np.linalg.svd(places - places.mean(axis=0), compute_uv=False)[-1] < SAME * total_length(legs))


def second_moments(legs: Array, center: Array) -> Array:
    """Return int e e^T dl (2, 2) [m3] of straight pieces (l, 2, 2) [m] about a center (2,) [m]."""
    length = lengths(legs)
    start, end = legs[:, 0] - center, legs[:, 1] - center
    middle, half = (start + end) / 2, (end - start) / 2
    of_middles = np.einsum("l,li,lj->ij", length, middle, middle)
    return np.asarray(of_middles + np.einsum("l,li,lj->ij", length, half, half) / 3)


def directions(legs: Array) -> Array:
    """Return int t t^T dl (2, 2) [m] of straight pieces (l, 2, 2) [m], t along them."""
    length, run = lengths(legs), legs[:, 1] - legs[:, 0]
    return np.asarray(np.einsum("l,li,lj->ij", 1 / length, run, run))


def limited_straights(legs: Array, most: float) -> Array:
    """Return what counts of legs (l, 2, 2) [m] where straight parts count up to a length [m], half of it at each end.

    Legs that follow each other in the same direction are one straight part; they start and end where any other does.
    """
    if len(legs) == 0:
        return legs
    run = (legs[:, 1] - legs[:, 0]) / lengths(legs)[:, None]
    # where a leg goes on as the one before it does, of the first one the last
    gap, turn = legs[:, 0] - np.roll(legs[:, 1], 1, axis=0), run - np.roll(run, 1, axis=0)
    goes_on = (np.abs(gap) + np.abs(turn) <= SAME).all(axis=1)
    first = int(np.argmin(goes_on))
    order, starts = np.roll(np.arange(len(legs)), -first), np.roll(~goes_on, -first)
    parts = np.split(order, np.flatnonzero(starts)[1:])
    counted = []
    for part in parts:
        start, end = legs[part[0], 0], legs[part[-1], 1]
        length = float(np.linalg.norm(end - start))
        if length <= most:
            counted.append(legs[part])
            continue
        half = most / 2 / length * (end - start)
        counted.append(np.array([[start, start + half], [end - half, end]]))
    return np.concatenate(counted)


@made_once
def shape_of(legs: Array) -> Shape:
    """Return how a perimeter of legs (l, 2, 2) runs.

    It is told by the angle that it turns: all around the column, half around at an edge, a quarter at a corner. One
    that hardly turns cuts the slab from edge to edge, which is one-way shear and no punching.
    """
    turned = sum(map(_turn, chains(legs)))
    return next(name for name, least in TURNED.items() if turned > least)


def cuts_strips(legs: Array) -> bool:
    """Return whether a perimeter of legs (l, 2, 2) consists of several parts, each of which cuts from edge to edge.

    Together they do not turn all around, as those between small openings do.
    """
    turns = [_turn(part) for part in chains(legs)]
    return len(turns) > 1 and max(turns) <= STRIP and sum(turns) <= TURNED["closed"]


def _turn(chain: Array) -> float:
    """Return by what angle places (k, 2) along a connected part turn [degrees]."""
    steps = np.diff(chain, axis=0)
    if (chain[0] == chain[-1]).all():
        steps = np.vstack([steps, steps[:1]])
    angles = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    return abs(float(np.degrees(angles[-1] - angles[0])))


def course(legs: Array, axes: Array) -> Course:
    """Return how a perimeter of legs (l, 2, 2) runs around what has own axes (2, 2), with its directions."""
    shape = shape_of(legs)
    longest = max(chains(legs), key=len)
    chord = longest[-1] - longest[0]
    if shape == "closed" or not chord.any():
        return Course(shape, axes, np.empty((0, 2)))
    along = chord / np.linalg.norm(chord)
    ends = np.array([longest[1] - longest[0], longest[-2] - longest[-1]])
    inward = ends / np.linalg.norm(ends, axis=1, keepdims=True)
    return Course(shape, np.array([along, [-along[1], along[0]]]), inward)


@made_once
def chains(legs: Array) -> list[Array]:
    """Return the places (k, 2) along each connected part of legs (l, 2, 2)."""
    from shapely import get_coordinates, get_parts, line_merge, linestrings, multilinestrings

    return [get_coordinates(chain) for chain in get_parts(line_merge(multilinestrings(linestrings(legs))))]
