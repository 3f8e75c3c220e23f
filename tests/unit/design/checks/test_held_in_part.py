"""Edges and lines that hold a slab down in part while they push in all: no design passes on that."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.design.checks import Design, check_design
from groundslab.design.demands.support_forces import pull_in_part, thirds
from groundslab.model.model import Model


def line(start: tuple[float, float], end: tuple[float, float], q: float) -> dict[str, Any]:
    """Return a line load [N/m]."""
    return {"kind": "line", "points": [start, end], "q": q, "case": "G"}


def area(x: tuple[float, float], q: float) -> dict[str, Any]:
    """Return a pressure [Pa] from edge to edge along y."""
    return {"kind": "area", "shape": {"kind": "rectangle", "x": x, "y": (-4, 4)}, "q": q, "case": "G"}


def design(edges: dict[str, str], loads: list[dict[str, Any]], **changes: Any) -> Design:
    """Return the design of a slab of 8 x 8 x 0.4 m on springs, some edges of which are supported."""
    parts: dict[str, Any] = {
        "plate": {"length_x": 8, "length_y": 8, "thickness": 0.4, "E": 31e9, "nu": 0.2, "edges": edges},
        "ground": {"kind": "winkler", "k": 20e6},
        "cases": [{"name": "G"}],
        "combinations": [{"name": "ULS", "factors": {"G": 1.01}}],
        "loads": loads,
        "mesh": {"size": 1.0},
    }
    return check_design(solve(Model(**parts | changes)))


ALL = dict.fromkeys(("left", "right", "bottom", "top"), "hinged")
#: 100 kN/m upwards on one half of the edge at the bottom, and 300 kN/m downwards on the other one.
HALVES = [line((-4, -4), (0, -4), -100e3), line((0, -4), (4, -4), 300e3), area((-4, 4), 5e3)]
BOTTOM = {"kind": "line", "points": [(-4, -4), (4, -4)]}
UPLIFT = {
    "one side lifted, the other pressed": (
        {"left": "hinged", "right": "hinged"}, [line((-3.5, -4), (-3.5, 4), 500e3), area((0, 4), -18e3)], {}
    ),
    "the middle lifted, two sides pressed": (
        ALL, [line((-3.5, -4), (-3.5, 4), 300e3), line((3.5, -4), (3.5, 4), 300e3), area((-2, 2), -50e3)], {}
    ),
    "half of one edge lifted": ({"bottom": "hinged"}, HALVES, {}),
    "half of a line support lifted": ({}, HALVES, {"supports": [BOTTOM]}),
}  # fmt: skip


@pytest.mark.parametrize("name", UPLIFT)
def test_uplift_that_is_held_in_part_does_not_pass(name: str) -> None:
    """All loads together press, over the slab, and so do all edges or the line; parts of them hold the slab down."""
    edges, loads, changes = UPLIFT[name]
    found = design(edges, loads, **changes)
    held = [check for check in found.checks if check.name in ("edges that hold down", "supports that hold down")]
    assert [check.unjudged is not None for check in held] == [True]
    assert found.status == "attention"


@pytest.mark.parametrize(("edges", "changes"), [
    (ALL, {}), (ALL, {"ground": {"kind": "winkler", "k": 1e3}}), ({}, {"supports": [BOTTOM]}),
    ({"left": "hinged"}, {"ground": {"kind": "winkler", "k": 1e6}}),
])  # fmt: skip
def test_edges_that_push_alone_are_no_reason(edges: dict[str, str], changes: dict[str, Any]) -> None:
    """Under 20 kPa all edges push; at corners, where rigid ones pull a little, that is within what pushes."""
    found = design(edges, [area((-4, 4), 20e3)], **changes)
    assert not [check for check in found.checks if "hold down" in check.name]


def test_thirds_that_pull() -> None:
    """-6, 1 + 2 and 5 N on the thirds of 3 m pull by 6 N; 4 N that come at once leave 2 N."""
    parts = thirds(np.array([[[0.0, 0.0], [3.0, 0.0]]]))
    places, forces = np.array([[0.5, 0.0], [1.2, 0.0], [1.8, 0.0], [2.9, 0.0]]), np.array([-6.0, 1.0, 2.0, 5.0])
    assert pull_in_part(parts, places, forces) == pytest.approx(6)
    assert pull_in_part(parts, places, forces, np.array([4.0, 0, 0])) == pytest.approx(2)
    assert pull_in_part(parts, places, np.abs(forces)) == 0
