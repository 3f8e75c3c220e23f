"""Direct solvers of symmetric positive definite systems, by name: pattern -> analysis -> factor -> solution.

Patterns are upper CSR, numbered in an order of elimination that is already good (fem/sparse/elimination).
"""

from __future__ import annotations

import platform
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec

from groundslab.errors import InputError, Issue
from groundslab.optional import import_pardiso
from groundslab.solvers.direct.cholmod import Cholmod
from groundslab.solvers.direct.mumps import Mumps
from groundslab.solvers.direct.pardiso import Pardiso, load_in_background, pardiso_import_error
from groundslab.solvers.direct.protocols import Solver
from groundslab.solvers.direct.superlu import SuperLU

SOLVERS: dict[str, Solver] = {"pardiso": Pardiso, "cholmod": Cholmod, "superlu": SuperLU, "mumps": Mumps}
#: What solvers need that does not come with groundslab, and how to get it.
PACKAGES = {
    "cholmod": ("cvxopt", "pip install groundslab[cholmod]"),
    "mumps": ("petsc4py", "docs/large.md explains how to install it"),
}


def warm_up(solver: Solver) -> None:
    """Have a solver's library loaded in the background, while meshes and matrices are made."""
    if solver is Pardiso:
        load_in_background()


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


def automatic() -> str:
    """Return the name of the solver that "auto" takes: PARDISO where it can be imported, else CHOLMOD, else SuperLU."""
    if platform.machine().lower() in ("x86_64", "amd64") and not pardiso_import_error():
        return "pardiso"
    return "cholmod" if find_spec("cvxopt") else "superlu"


def choose(name: str) -> tuple[str, Solver]:
    """Return name and solver for a name or "auto"."""
    if name == "auto":
        name = automatic()
    elif name == "pardiso" and pardiso_import_error():
        hint = 'solver = "auto" takes it if it is installed'
        not_loaded = f'"pardiso", which cannot be loaded ({pardiso_import_error()})'
        raise InputError([Issue("analysis.solver", not_loaded, '"cholmod", "superlu" or "auto"', hint)])
    elif name in PACKAGES and find_spec(PACKAGES[name][0]) is None:
        package, hint = PACKAGES[name]
        not_installed = f'"{name}", which needs {package}, and that is not there'
        raise InputError([Issue("analysis.solver", not_installed, '"auto"', hint)])
    return name, SOLVERS[name]
