"""Frames in space, condensed to what stands on the plate: Timoshenko beams, rigid floors, bases that settle and turn.

x and y are those of the plan, z points down. A node has displacements u, v, w and a rotation vector (p, q, r), so that
a place at (X, Y, Z) from it moves by (p, q, r) x (X, Y, Z): the slopes of a base along x and y are -q and p.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers

if TYPE_CHECKING:
    from scipy.sparse import csr_array

#: Displacements and rotations of a node.
MOTIONS = 6
#: w, and the slopes along x and y, of a base from its u, v, w, p, q, r.
TO_BASE = np.array([[0, 0, 1, 0, 0, 0], [0, 0, 0, 0, -1, 0], [0, 0, 0, 1, 0, 0]], dtype=float)


@dataclass(frozen=True, slots=True)
class Members:
    """Straight members of a frame, m together."""

    nodes: Integers  # (m, 2): where they start and end
    arms: Array  # (m, 2, 3) [m]: rigid, from these nodes to where the member itself starts and ends
    across: Array  # (m, 3): unit vectors at right angles to them, of their second axis
    EA: Array  # (m,) [N]
    EI: Array  # (m, 2) [N m2]: for displacements along the second and the third axis
    GJ: Array  # (m,) [N m2]
    GA: Array  # (m,) [N], inf where shear strains nothing


def condense(places: Array, members: Members, bases: Integers, floors: list[Integers]) -> Array:
    """Return the stiffness between bases (3 b, 3 b): w and slopes along x and y of each in turn, in N and m.

    Parameters
    ----------
    places : (n, 3) array of float
        The frame's nodes [m].
    members : Members
        Its members.
    bases : (b,) array of int
        Nodes that stand on the plate, which holds them sideways and about the vertical.
    floors : list of (k,) array of int
        Nodes whose u, v and r follow those of one rigid floor each.

    Returns
    -------
    (3 b, 3 b) array of float
        The stiffness, exactly symmetric.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.linalg import splu

    n = len(places)
    K_e = _stiffness(places, members)
    unknown = (MOTIONS * members.nodes[:, :, None] + np.arange(MOTIONS)).reshape(len(K_e), -1)
    rows, columns = (np.repeat(unknown, 12, axis=1), np.tile(unknown, (1, 12)))
    K = coo_array((K_e.ravel(), (rows.ravel(), columns.ravel())), shape=(MOTIONS * n, MOTIONS * n)).tocsc()
    T = _follow_floors(places, floors)
    at_bases = (MOTIONS * bases[:, None] + np.arange(MOTIONS)).ravel()
    inner = np.ones(MOTIONS * n, dtype=bool)
    inner[at_bases] = False
    T = T[inner]
    T = T[:, np.flatnonzero(np.abs(T).sum(axis=0))]
    base = np.kron(np.eye(len(bases)), TO_BASE)
    of_bases = K[:, at_bases] @ base.T
    coupled = T.T @ of_bases[inner]
    K_ii = (T.T @ K[inner][:, inner] @ T).tocsc()
    moved = splu(K_ii).solve(np.asarray(coupled)) if K_ii.shape[0] else np.zeros((0, len(base)))
    matrix = base @ of_bases[at_bases] - coupled.T @ moved
    symmetric: Array = (matrix + matrix.T) / 2
    return symmetric


def _follow_floors(places: Array, floors: list[Integers]) -> csr_array:
    """Return what takes the unknowns of rigid floors, and those that nodes have for themselves, to all of nodes'."""
    from scipy.sparse import coo_array

    size = MOTIONS * len(places)
    free = np.ones(size, dtype=bool)
    rows, columns, values = [], [], []
    for number, nodes in enumerate(floors):
        x, y = (places[nodes] - places[nodes].mean(axis=0))[:, :2].T
        ones, first = np.ones(len(nodes)), size + 3 * number
        for field, follows in ((0, {0: ones, 2: -y}), (1, {1: ones, 2: x}), (5, {2: ones})):
            free[MOTIONS * nodes + field] = False
            for motion, value in follows.items():
                rows.append(MOTIONS * nodes + field)
                columns.append(np.full(len(nodes), first + motion))
                values.append(value)
    alone = np.flatnonzero(free)
    rows, columns, values = [alone, *rows], [alone, *columns], [np.ones(len(alone)), *values]
    shape = (size, size + 3 * len(floors))
    return coo_array((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape=shape).tocsr()


def _stiffness(places: Array, members: Members) -> Array:
    """Return the stiffness matrices (m, 12, 12) of members between the unknowns of their nodes."""
    m = members
    ends = places[m.nodes] + m.arms
    way = ends[:, 1] - ends[:, 0]
    L = np.linalg.norm(way, axis=1)
    e1, e2 = way / L[:, None], m.across
    R = np.stack([e1, e2, np.cross(e1, e2)], axis=1)
    local = np.zeros((len(L), 12, 12))
    for field, value in ((0, m.EA / L), (3, m.GJ / L)):
        local[:, field, field] = local[:, field + 6, field + 6] = value
        local[:, field, field + 6] = local[:, field + 6, field] = -value
    # v with its rotation r = v', and w with q = -w'
    for EI, (shift, turn), sign in ((m.EI[:, 0], (1, 5), 1.0), (m.EI[:, 1], (2, 4), -1.0)):
        phi = 12 * EI / (m.GA * L**2)
        k = EI / (L**3 * (1 + phi))
        fields = [shift, turn, shift + 6, turn + 6]
        block = np.empty((len(L), 4, 4))
        ones, half = np.ones_like(L), sign * L / 2
        near, far = (4 + phi) * L**2 / 12, (2 - phi) * L**2 / 12
        block[:, 0] = np.stack([ones, half, -ones, half], axis=1)
        block[:, 1] = np.stack([half, near, -half, far], axis=1)
        block[:, 2] = -block[:, 0]
        block[:, 3] = np.stack([half, far, -half, near], axis=1)
        local[:, np.array(fields)[:, None], fields] = 12 * k[:, None, None] * block
    turned = np.zeros((len(L), 12, 12))
    for end in (0, 1):
        shifts, turns = slice(6 * end, 6 * end + 3), slice(6 * end + 3, 6 * end + 6)
        turned[:, shifts, shifts] = turned[:, turns, turns] = R
        # the end of a rigid arm moves with the rotation of its node
        turned[:, shifts, turns] = np.einsum("mij,mjk->mik", R, -_cross(m.arms[:, end]))
    matrices: Array = np.einsum("mki,mkl,mlj->mij", turned, local, turned)
    return matrices


def _cross(arms: Array) -> Array:
    """Return the matrices (m, 3, 3) of arms (m, 3) that take a vector a to arm x a."""
    x, y, z = arms.T
    none = np.zeros_like(x)
    return np.stack(
        [np.stack([none, -z, y], axis=1), np.stack([z, none, -x], axis=1), np.stack([-y, x, none], axis=1)], axis=1
    )
