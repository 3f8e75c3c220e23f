"""MUMPS through PETSc, for a problem that does not fit one machine: its factor is distributed over processes.

Every process of an MPI run does the same analysis, mesh and matrix included; only the factor, by far the largest part,
is distributed. Each process receives the complete solution, so that all take the same decisions. They must run on
machines of one kind: where two processes round differently, one may decide otherwise and wait forever.

pip cannot install PETSc and petsc4py with this package: see docs/large.md.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from groundslab.arrays import Array, Indices
from groundslab.errors import SingularMatrix

#: Numbers of MUMPS's control and information parameters (its Users' guide, sections 6 and 8).
PARALLEL_ROOT, MEMORY_MARGIN = 13, 14
OUTCOME, NEGATIVE_PIVOTS = 1, 12
#: Percentage by which the working memory may exceed the estimate.
MARGIN = 50


def _petsc() -> Any:
    """Import petsc4py, which starts MPI; raises ImportError where it is not installed."""
    import petsc4py

    petsc4py.init()
    from petsc4py import PETSc

    return PETSc


def is_root_process() -> bool:
    """Return whether this process is the one of an MPI run that prints and writes files."""
    return bool(_petsc().COMM_WORLD.getRank() == 0)


class Mumps:
    """A pattern whose rows are distributed over the processes of an MPI run, factorized by MUMPS."""

    def __init__(self, indptr: Indices, indices: Indices) -> None:
        PETSc = _petsc()
        n, index = len(indptr) - 1, PETSc.IntType
        vector = PETSc.Vec().createMPI(n, comm=PETSc.COMM_WORLD)
        self.b, self.x = vector, vector.duplicate()
        self.begin, self.end = vector.getOwnershipRange()
        self.entries = slice(int(indptr[self.begin]), int(indptr[self.end]))
        self.indptr = (indptr[self.begin : self.end + 1] - indptr[self.begin]).astype(index)
        self.indices = indices[self.entries].astype(index)
        self.to_all, self.gathered = PETSc.Scatter.toAll(self.x)
        self.matrix = PETSc.Mat().create(PETSc.COMM_WORLD)
        self.matrix.setSizes(((self.end - self.begin, n), (self.end - self.begin, n)))
        self.matrix.setType("sbaij")
        self.matrix.setPreallocationCSR((self.indptr, self.indices, np.zeros(len(self.indices))))
        self.matrix.setOption(PETSc.Mat.Option.SPD, True)
        self.ksp = PETSc.KSP().create(PETSc.COMM_WORLD)
        self.ksp.setOperators(self.matrix)
        self.ksp.setType("preonly")
        self.pc = self.ksp.getPC()
        self.pc.setType("cholesky")
        self.pc.setFactorSolverType("mumps")
        self.pc.setFactorSetUpSolverType()
        factor = self.pc.getFactorMatrix()
        # no parallel dense solver for the root, which would not count its negative pivots
        factor.setMumpsIcntl(PARALLEL_ROOT, 1)
        factor.setMumpsIcntl(MEMORY_MARGIN, MARGIN)

    def factor(self, data: Array) -> Mumps:
        """Return the factor of the matrix whose upper half has these entries; raise SingularMatrix if there is none."""
        if not np.isfinite(data).all():
            raise SingularMatrix("the matrix holds entries that are not finite numbers")
        self.matrix.setValuesCSR(self.indptr, self.indices, data[self.entries])
        self.matrix.assemble()
        self.ksp.setUp()
        factor = self.pc.getFactorMatrix()
        outcome = factor.getMumpsInfog(OUTCOME)
        if outcome == -10 or factor.getMumpsInfog(NEGATIVE_PIVOTS):
            raise SingularMatrix("the stiffness matrix is not positive definite")
        if outcome < 0:
            raise MemoryError(f"MUMPS stopped with error {outcome} on {self.matrix.getSize()[0]} unknowns")
        return self

    def solve(self, b: Array) -> Array:
        """Return x with A x = b, for b (n,) or (n, k), on every process."""
        if b.ndim == 2:
            return np.column_stack([self.solve(column) for column in b.T])
        self.b.setArray(b[self.begin : self.end])
        self.ksp.solve(self.b, self.x)
        self.to_all.scatter(self.x, self.gathered)
        solution: Array = self.gathered.getArray().copy()
        return solution
