"""Meshes of plans with several plates: each covered, ground between them, and one line of nodes where they touch."""

from __future__ import annotations

import math

import numpy as np
import pytest

from groundslab.fem.mesh import sides_on_boundary
from groundslab.geometry.plan import Plan, Ring, circle, rectangle
from groundslab.meshing import unstructured
from groundslab.meshing.backends import Maker
from groundslab.meshing.grid import rectilinear
from helpers.plans import MAKERS, areas

QUARTER = math.tan(math.pi / 8)
#: Two plates that share a quarter circle of 4 m chord.
LEFT = Ring(((-4, -2), (0, -2), (0, 2), (-4, 2)), (0.0, -QUARTER, 0.0, 0.0))
RIGHT = Ring(((0, -2), (4, -2), (4, 2), (0, 2)), (0.0, 0.0, 0.0, QUARTER))


@pytest.mark.parametrize("make", MAKERS)
@pytest.mark.parametrize("beyond", [None, rectangle(-6, 6, -4, 4)])
def test_plates_that_share_an_arc(make: Maker, beyond: Ring | None) -> None:
    """Sides along the shared arc belong to an element of either plate, whether or not ground is meshed around them."""
    plan = Plan(LEFT, beyond=beyond, others=((RIGHT, 1),))
    found = unstructured(plan, 0.4, maker=make)
    parts = areas(found)
    for section, ring in ((0, LEFT), (1, RIGHT)):
        assert parts[found.section == section].sum() == pytest.approx(ring.area, rel=1e-4)
    edges = [set(sides_on_boundary(found.elements[found.section == section])[:, 2].tolist()) for section in (0, 1)]
    ends = np.array([side for side in sides_on_boundary(found.elements[found.section == 0]) if side[2] in edges[1]])
    length = np.linalg.norm(np.diff(found.nodes[ends][:, [0, 2, 1]], axis=1), axis=2).sum()
    assert length == pytest.approx(math.pi / 2 * 2 * math.sqrt(2), rel=1e-3)


@pytest.mark.parametrize("make", MAKERS)
def test_plates_apart(make: Maker) -> None:
    """Round plates apart from each other are meshed with nothing between them, or with ground."""
    rings = circle((0, 0), 2.0), circle((5, 0), 1.5)
    for beyond in (None, rectangle(-4, 8, -4, 4)):
        found = unstructured(Plan(rings[0], beyond=beyond, others=((rings[1], 3),)), 0.4, maker=make)
        parts = areas(found)
        assert set(found.section.tolist()) == ({0, 3} if beyond is None else {-1, 0, 3})
        for section, ring in ((0, rings[0]), (3, rings[1])):
            assert parts[found.section == section].sum() == pytest.approx(ring.area, rel=1e-4)


def test_grids_of_rectangles() -> None:
    """Rectangles that share a part of a line, and one apart, are a grid without what lies between them."""
    plan = Plan(rectangle(0, 4, 0, 3), others=((rectangle(4, 8, 1, 4), 1), (rectangle(10, 12, 0, 3), 2)))
    found = rectilinear(plan, 0.5)
    parts = areas(found)
    assert [parts[found.section == section].sum() for section in range(3)] == pytest.approx([12, 12, 6])
    assert parts.sum() == pytest.approx(30)
