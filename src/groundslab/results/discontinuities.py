"""Lines along which moments kink or shear forces jump, as far as the mesh follows them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from groundslab.arrays import Integers
from groundslab.fem.mesh import SIDES, Place, sides_along
from groundslab.fem.problem import Problem
from groundslab.geometry.plan import Ring, rectangle
from groundslab.model.columns import footprint
from groundslab.model.loads.load_types import AreaLoad, LineLoad, PatchLoad, PointLoad
from groundslab.model.model import Model
from groundslab.model.supports import LineSupport


def walls(model: Model, problem: Problem) -> Integers:
    """Return the sides (k, 3: end, end, middle node) of plate elements along line supports."""
    lines = [piece for each in model.supports if isinstance(each, LineSupport) for piece in pairwise(each.points)]
    return sides_along(problem.mesh, problem.mesh.elements[problem.plate_elements], lines)


def loaded(model: Model, problem: Problem) -> Integers:
    """Return the sides (k, 3) of plate elements along line loads and straight edges of loaded areas."""
    lines = [line for load in model.loads for line in _lines(load, model)]
    return sides_along(problem.mesh, problem.mesh.elements[problem.plate_elements], lines)


def _lines(load: object, model: Model) -> Iterator[tuple[Place, Place]]:
    """Yield the straight lines along which a load begins, ends or stands."""
    rings: list[Ring] = []
    if isinstance(load, LineLoad):
        yield from ((edge.start, edge.end) for edge in load.segments() if edge.straight)
    elif isinstance(load, PatchLoad):
        rings = [rectangle(*load.x, *load.y)]
    elif isinstance(load, AreaLoad):
        rings = [shape.ring() for shape in (load.shape, *load.holes)]
    elif isinstance(load, PointLoad):
        own = load.on(model.columns)
        assert own.x is not None
        assert own.y is not None
        own_ring = footprint(own.x, own.y, own.width_x, own.width_y, own.diameter)
        rings = [] if own_ring is None else [own_ring]
    yield from ((edge.start, edge.end) for ring in rings for edge in ring.segments() if edge.straight)


def apart(elements: Integers, creases: Integers, n: int) -> Integers:
    """Return a number (m, 9) that tells apart, at each node on a crease (k, 3), the elements on its different sides.

    Elements round such a node belong together if one comes from one to the other without crossing a crease; elsewhere
    the number is 0. n is the number of nodes.
    """
    on_crease = np.zeros(n, dtype=bool)
    on_crease[creases] = True
    meets = on_crease[elements]
    count = int(meets.sum())
    number = np.full(elements.shape, -1)
    number[meets] = np.arange(count)
    sides = elements[:, SIDES]  # (m, 4, 3)
    owner, which = np.nonzero(on_crease[sides].any(axis=2) & ~np.isin(sides[..., 2], creases[:, 2]))
    order = np.argsort(sides[owner, which, 2], kind="stable")
    owner, which = owner[order], which[order]
    one = np.flatnonzero(np.diff(sides[owner, which, 2]) == 0)
    other = one + 1
    links = [np.zeros((2, 0), dtype=np.int64)]
    # two neighbours run along their common side in opposite directions
    for here, there in ((0, 1), (1, 0), (2, 2)):
        pair = np.vstack(
            [number[owner[one], SIDES[which[one], here]], number[owner[other], SIDES[which[other], there]]]
        )
        links.append(pair[:, pair[0] >= 0])
    row, column = np.concatenate(links, axis=1)
    # linked ones take the smallest of their numbers, until none changes; at a node there are but a few
    label, before = np.arange(count), np.full(count, -1)
    while (label != before).any():
        before = label.copy()
        least = np.minimum(label[row], label[column])
        np.minimum.at(label, row, least)
        np.minimum.at(label, column, least)
    result = np.zeros(elements.shape, dtype=np.int64)
    result[meets] = label
    return result
