"""A grid of grade beams, a plate with one large opening, against a frame of beams on springs.

The frame is independent of the plate: Timoshenko's beams along the axes of the grid, with the torsion of rectangles
(Roark 10.7), on springs k b. Where two of them cross, the plate's corner is four times as much as half a beam, so that
its springs are counted once, and within half a beam's width from an axis what both models mean by a moment differs:
they are compared between the corners.
"""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy import sparse
from scipy.sparse.linalg import spsolve

import groundslab as gs
from groundslab.arrays import Array
from groundslab.design.bars.members import strip_forces
from groundslab.results.records import BeamResult

E, NU, K = 33e9, 0.2, 40e6
B, H = 0.8, 0.6
#: Half the distances of axes [m].
A_X, A_Y = 4.0, 3.0
#: Forces at the corners: P [N], M_x and M_y [N m], the latter as the plate's: M_x bends along x.
CORNERS: dict[tuple[float, float], tuple[float, float, float]] = {
    (-A_X, -A_Y): (300e3, -60e3, 20e3),
    (A_X, -A_Y): (450e3, 60e3, 20e3),
    (-A_X, A_Y): (300e3, -60e3, -20e3),
    (A_X, A_Y): (450e3, 60e3, -20e3),
}
STRIPS = {
    "south": ((-A_X - B / 2, -A_Y), (A_X + B / 2, -A_Y)),
    "north": ((-A_X - B / 2, A_Y), (A_X + B / 2, A_Y)),
    "west": ((-A_X, -A_Y - B / 2), (-A_X, A_Y + B / 2)),
    "east": ((A_X, -A_Y - B / 2), (A_X, A_Y + B / 2)),
}
#: Pieces of the frame's beams are so long [m].
PIECE = 0.1


@cache
def plate() -> gs.Results:
    """Return the results of the plate."""
    return gs.solve(gs.Model(
        plate={"length_x": 2 * A_X + B, "length_y": 2 * A_Y + B, "thickness": H, "E": E, "nu": NU, "openings": [
            {"kind": "rectangle", "x": (B / 2 - A_X, A_X - B / 2), "y": (B / 2 - A_Y, A_Y - B / 2)}]},
        ground={"kind": "winkler", "k": K},
        loads=[{"kind": "point", "x": x, "y": y, "P": P, "M_x": M_x, "M_y": M_y, "width_x": 0.4, "width_y": 0.4}
               for (x, y), (P, M_x, M_y) in CORNERS.items()],
        output={"strips": [{"name": name, "start": start, "end": end, "width": B, "design": "beam"}
                           for name, (start, end) in STRIPS.items()]},
    ))  # fmt: skip


def _beam(length: float) -> Array:
    """Return the stiffness of a piece for w, slope, twist at both ends."""
    G, bending = E / (2 * (1 + NU)), E * B * H**3 / 12
    phi = 12 * bending / (G * 5 / 6 * B * H * length**2)
    J = B * H**3 * (1 / 3 - 0.21 * H / B * (1 - (H / B) ** 4 / 12))
    stiffness = np.zeros((6, 6))
    stiffness[np.ix_([0, 1, 3, 4], [0, 1, 3, 4])] = bending / (length**3 * (1 + phi)) * np.array([
        [12, 6 * length, -12, 6 * length],
        [6 * length, (4 + phi) * length**2, -6 * length, (2 - phi) * length**2],
        [-12, -6 * length, 12, -6 * length],
        [6 * length, (2 - phi) * length**2, -6 * length, (4 + phi) * length**2],
    ])  # fmt: skip
    stiffness[np.ix_([2, 5], [2, 5])] = G * J / length * np.array([[1, -1], [-1, 1]])
    return stiffness


@cache
def frame() -> dict[str, tuple[Array, Array, Array]]:
    """Return ways [m], moments (sagging positive) and torsional moments in size [N m] along each beam of the frame."""
    number: dict[tuple[float, float], int] = {}
    beams = {}
    for name, (start, end) in STRIPS.items():
        count = round(float(np.hypot(*np.subtract(end, start))) / PIECE)
        places = np.array(start) + np.linspace(0, 1, count + 1)[:, None] * np.subtract(end, start)
        beams[name] = [number.setdefault((round(x, 6), round(y, 6)), len(number)) for x, y in places], places
    stiffness = sparse.lil_matrix((3 * len(number), 3 * len(number)))
    turns = {}
    for name, (nodes, places) in beams.items():
        t = (places[1] - places[0]) / PIECE
        turn = np.eye(6)
        for at in (0, 3):
            turn[at + 1, at + 1 : at + 3], turn[at + 2, at + 1 : at + 3] = t, (-t[1], t[0])
        turns[name] = turn
        for i, j, middle in zip(nodes[:-1], nodes[1:], (places[1:] + places[:-1]) / 2, strict=True):
            unknowns = [3 * i, 3 * i + 1, 3 * i + 2, 3 * j, 3 * j + 1, 3 * j + 2]
            stiffness[np.ix_(unknowns, unknowns)] += turn.T @ _beam(PIECE) @ turn
            # each beam has half of a corner's springs
            in_corner = (np.abs(np.abs(middle) - (A_X, A_Y)) < B / 2).all()
            for node in (i, j):
                own = K * B * PIECE / 2 * (0.5 if in_corner else 1.0)
                stiffness[3 * node, 3 * node] += own
                # springs over the width resist the twist
                across = np.outer([-t[1], t[0]], [-t[1], t[0]]) * own * B**2 / 12
                stiffness[3 * node + 1 : 3 * node + 3, 3 * node + 1 : 3 * node + 3] += across
    forces = np.zeros(3 * len(number))
    for place, acting in CORNERS.items():
        forces[3 * number[place] + np.arange(3)] = acting
    moved = spsolve(stiffness.tocsc(), forces)
    found = {}
    for name, (nodes, _) in beams.items():
        ends = [_beam(PIECE) @ turns[name] @ moved[[3 * i, 3 * i + 1, 3 * i + 2, 3 * j, 3 * j + 1, 3 * j + 2]]
                for i, j in pairwise(nodes)]  # fmt: skip
        moments = np.array([[end[1], -end[4]] for end in ends]).mean(axis=1)
        ways = PIECE * (np.arange(len(ends)) + 0.5)
        found[name] = ways, moments, np.abs([end[5] for end in ends])
    return found


def strip(name: str) -> BeamResult:
    """Return the section forces of a strip of the plate."""
    results = plate()
    asked = next(each for each in results.model.output.strips if each.name == name)
    return strip_forces(results.only, asked)


def between(way: Array, length: float, away: float = 0.0) -> Any:
    """Return which places are between the faces of both corners, and so far [m] away from them."""
    return (way > B + away) & (way < length - B - away)


@pytest.mark.parametrize("name", list(STRIPS))
def test_moments_are_those_of_a_frame(name: str) -> None:
    """Within 3 % of the largest moment of a beam from a quarter of its width beside the corners on, 3.4 % at these."""
    ways, moments, _ = frame()[name]
    own = strip(name)
    inside = between(ways, own.way[-1], B / 4)
    found = np.interp(ways, own.way, own.moment)[inside]
    assert found == pytest.approx(moments[inside], abs=0.03 * np.abs(moments[inside]).max())


@pytest.mark.parametrize("name", list(STRIPS))
def test_torsion_is_that_of_a_frame(name: str) -> None:
    """Half a width away from the corners, within a tenth of the largest one."""
    ways, _, torsion = frame()[name]
    own = strip(name)
    inside = between(ways, own.way[-1], B / 2)
    found = np.interp(ways, own.way, np.abs(own.torsion))[inside]
    assert found == pytest.approx(torsion[inside], abs=0.1 * torsion[inside].max())
