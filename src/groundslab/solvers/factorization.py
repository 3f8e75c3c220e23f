"""Direct solvers of symmetric positive definite systems, by name: pattern -> analysis -> factor -> solution.

Patterns are upper CSR, numbered in an order of elimination that is already good (mesh.elimination_order).
"""

from __future__ import annotations

import platform
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec

from groundslab.errors import InputError, Issue
from groundslab.solvers.mumps import Mumps
from groundslab.solvers.pardiso import Pardiso, import_pardiso, pardiso_import_error
from groundslab.solvers.protocols import Solver
from groundslab.solvers.superlu import SuperLU


def threads(solver: Solver) -> int:
    """Return the number of threads of a solver's factorizations."""
    if solver is not Pardiso:
        return 1
    library = import_pardiso().PyPardisoSolver().libmkl
    return int(library.MKL_Get_Max_Threads())


def use_threads(solver: Solver, count: int) -> None:
    """Set the number of threads (0: all) for the factorizations that the calling thread starts."""
    if solver is Pardiso:
        import_pardiso().PyPardisoSolver().libmkl.MKL_Set_Num_Threads_Local(count)


@contextmanager
def one_thread() -> Iterator[None]:
    """Limit factorizations to one thread within a with statement."""
    solver = choose("auto")[1]
    use_threads(solver, 1)
    try:
        yield
    finally:
        use_threads(solver, 0)


def choose(name: str) -> tuple[str, Solver]:
    """Return name and solver for "pardiso", "superlu" or "mumps"; for "auto" PARDISO where it can be imported."""
    solvers: dict[str, Solver] = {"pardiso": Pardiso, "superlu": SuperLU, "mumps": Mumps}
    if name != "auto":
        if name == "pardiso" and pardiso_import_error():
            hint = 'solver = "auto" takes it where it is there'
            found = f'"pardiso", which cannot be loaded ({pardiso_import_error()})'
            raise InputError([Issue("analysis.solver", found, '"superlu" or "auto"', hint)])
        if name == "mumps" and find_spec("petsc4py") is None:
            found = '"mumps", which needs petsc4py, and that is not there'
            hint = "docs/large.md tells how to install it"
            raise InputError([Issue("analysis.solver", found, '"auto"', hint)])
        return name, solvers[name]
    if platform.machine().lower() in ("x86_64", "amd64") and not pardiso_import_error():
        return "pardiso", Pardiso
    return "superlu", SuperLU
