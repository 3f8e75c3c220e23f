"""The building above: stiffness between motions of its bases, each a mean over the nodes of a footprint.

A base settles and turns as its footprint does on average: motions q = G^T u, where the columns of G are the nodal
forces of a unit force, and of unit couples, that press the footprint. The building resists with K q, thus G K G^T joins
all nodes of all footprints. In the matrix it takes fewer entries with unknowns p of its own, behind a joint of
stiffness S: 1/2 (p - G^T u) . S (p - G^T u) + 1/2 p . K' p, which is 1/2 q . K q exactly with

    K' = K (1 - S^-1 K)^-1,    S diagonal and S - K positive.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.assembly import Pattern

if TYPE_CHECKING:
    from scipy.sparse import csr_array

#: w, beta_x, beta_y of the plate, in which footprints move.
FIELDS = 3
#: The joint of a motion that nothing resists, over the stiffest one.
LEAST_JOINT = 1e-6


@dataclass(frozen=True, slots=True)
class Building:
    """The building above on a mesh: k motions of its bases. A slope counts by what it settles at `length`."""

    bases: tuple[str, ...]  # what it stands on
    base: Integers  # (k,): which base moves
    way: Integers  # (k,): 0 for settlement, 1 and 2 for slopes along x and y
    spread: csr_array  # (3 n, k): nodal forces of unit forces on w, beta_x, beta_y of each node in turn
    stiffness: Array  # (k, k) [N/m]
    host: Integers  # (k,): node among whose fields each p stands
    field: Integers  # (k,): which of them
    length: float  # [m]

    def motions(self, U: Array) -> Array:
        """Return the motions q (k,) [m] of bases in a table of unknowns (n, F)."""
        motions: Array = self.spread.T @ U[:, :FIELDS].ravel()
        return motions

    def forces(self, U: Array) -> Array:
        """Return the forces (k,) [N] with which the building resists, upwards on the plate."""
        forces: Array = self.stiffness @ self.motions(U)
        return forces

    def on_nodes(self, U: Array) -> Array:
        """Return the forces (n, 3) with which the building resists on w, beta_x, beta_y of each node."""
        forces: Array = (self.spread @ self.forces(U)).reshape(len(U), FIELDS)
        return forces

    def with_own(self, U: Array) -> Array:
        """Return a table of unknowns (n, F) in which the building's own follow the plate's."""
        table = U.copy()
        table[self.host, self.field] = self._share_of_p() @ self.motions(U)
        return table

    @property
    def joint(self) -> Array:
        """Return S (k,) [N/m]: twice what all motions together can raise in a row, so that S - K is positive.

        A motion that nothing resists needs a little, too, to have a p.
        """
        most = 2 * np.abs(self.stiffness).sum(axis=1)
        joint: Array = np.maximum(most, LEAST_JOINT * most.max())
        return joint

    @property
    def behind_joint(self) -> Array:
        """Return K' (k, k) [N/m]."""
        root = np.sqrt(self.joint)
        share, V = np.linalg.eigh(self.stiffness / np.outer(root, root))
        matrix: Array = (root[:, None] * V) @ ((share / (1 - share))[:, None] * (root[:, None] * V).T)
        return matrix

    def _share_of_p(self) -> Array:
        """Return what takes q to p (k, k): p = q - S^-1 K q."""
        return np.eye(len(self.joint)) - self.stiffness / self.joint[:, None]

    def pairs(self) -> Integers:
        """Return the pairs of nodes (t, 2) that it joins: those of one footprint, with their hosts, and all hosts."""
        pairs = [np.stack(np.meshgrid(self.host, self.host), axis=-1).reshape(-1, 2)]
        for number in range(len(self.bases)):
            nodes, hosts = self._nodes_of(number), self.host[self.base == number]
            for rows, columns in ((nodes, nodes), (hosts, nodes)):
                pairs.append(np.stack(np.meshgrid(rows, columns), axis=-1).reshape(-1, 2))
        return np.unique(np.sort(np.concatenate(pairs), axis=1), axis=0)

    def _nodes_of(self, number: int) -> Integers:
        """Return the nodes of a base's footprint."""
        return np.unique(self.spread[:, np.flatnonzero(self.base == number)].nonzero()[0] // FIELDS)


def blocks(b: Building, p: Pattern) -> tuple[Integers, Array]:
    """Return the node pairs (t,) of a building, ascending, and their blocks (t, F, F).

    Rows of a block are of the node that is eliminated first.
    """
    F = p.unknown.shape[1]
    pairs, matrices = [], []

    def add(rows: Integers, columns: Integers, block: Array) -> None:
        """Add blocks (t, F, F) whose rows are of nodes `rows`."""
        turned = (p.rank[rows] > p.rank[columns])[:, None, None]
        pairs.append(p.pairs(rows, columns))
        matrices.append(np.where(turned, block.transpose(0, 2, 1), block))

    S, K = b.joint, b.behind_joint + np.diag(b.joint)
    i, j = np.triu_indices(len(b.host))
    addends = np.zeros((len(i), F, F))
    addends[np.arange(len(i)), b.field[i], b.field[j]] = K[i, j]
    # fields of one node stand in the same block, both above and below its diagonal
    same = np.flatnonzero((b.host[i] == b.host[j]) & (i != j))
    addends[same, b.field[j[same]], b.field[i[same]]] = K[i[same], j[same]]
    add(b.host[i], b.host[j], addends)
    for number in range(len(b.bases)):
        nodes, motions = b._nodes_of(number), np.flatnonzero(b.base == number)
        G = np.asarray(b.spread[:, motions].todense()).reshape(-1, FIELDS, len(motions))[nodes]
        i, j = np.triu_indices(len(nodes))
        addends = np.zeros((len(i), F, F))
        addends[:, :FIELDS, :FIELDS] = np.einsum("tik,k,tjk->tij", G[i], S[motions], G[j])
        add(nodes[i], nodes[j], addends)
        for k, motion in enumerate(motions):
            addends = np.zeros((len(nodes), F, F))
            addends[:, b.field[motion], :FIELDS] = -S[motion] * G[:, :, k]
            on_host = np.flatnonzero(nodes == b.host[motion])
            addends[on_host] += addends[on_host].transpose(0, 2, 1)
            add(np.full(len(nodes), b.host[motion]), nodes, addends)
    return sum_by_pair(pairs, matrices)


def sum_by_pair(pairs: list[Integers], blocks: list[Array]) -> tuple[Integers, Array]:
    """Return the node pairs (t,) of several lists, each once and ascending, and the sums of their blocks (t, F, F)."""
    from scipy.sparse import csr_array

    every, which = np.unique(np.concatenate(pairs), return_inverse=True)
    many = np.concatenate(blocks)
    k = len(many)
    summing = csr_array((np.ones(k), (which, np.arange(k))), shape=(len(every), k))
    return every, (summing @ many.reshape(k, -1)).reshape(-1, *many.shape[1:])
