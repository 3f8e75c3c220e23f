"""scikit-fem: nine-node quadrilaterals, springs at the nodes, PARDISO or SuperLU.

    python bench/peers/scikit_fem.py 25000 pardiso
    python bench/peers/scikit_fem.py 25000 superlu

The shear strain is integrated with 2 x 2 points, which keeps the plate from locking. The plate's matrix is assembled
once; a step changes only the diagonal, where the springs stand. PARDISO analyses the pattern once, takes the upper
triangle and computes a Cholesky factor; SuperLU runs in its symmetric mode, which starts from the beginning each time.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import skfem
from first_plate import LIMIT, LOADED, NU, SHEAR, A, B, D, Job, K, Q, divisions, run
from scipy.sparse import csr_matrix, triu
from scipy.sparse.linalg import splu
from skfem.helpers import ddot, div, dot, grad, sym_grad


@skfem.BilinearForm
def bending(_w, beta, _v, eta, _):  # type: ignore[no-untyped-def]
    """Return the virtual work of the moments."""
    return D * ((1 - NU) * ddot(sym_grad(beta), sym_grad(eta)) + NU * div(beta) * div(eta))


@skfem.BilinearForm
def shear(w, beta, v, eta, _):  # type: ignore[no-untyped-def]
    """Return the virtual work of the shear forces."""
    return SHEAR * dot(grad(w) - beta, grad(v) - eta)


@skfem.LinearForm
def area(v, _eta, _):  # type: ignore[no-untyped-def]
    """Return each node's share of the area."""
    return v


@skfem.LinearForm
def load(v, _eta, at):  # type: ignore[no-untyped-def]
    """Return the virtual work of the load."""
    x, y = at.x
    return Q * ((x < LOADED) & (y < LOADED)) * v


Solve = Callable[[np.ndarray, np.ndarray], np.ndarray]


def pardiso(matrix: csr_matrix) -> Solve:
    """Return what adds a diagonal to a matrix and solves; the pattern is analysed when it is called first."""
    from pypardiso import PyPardisoSolver

    upper = triu(matrix, format="csr")
    upper.sort_indices()
    first, values = upper.indptr[:-1], upper.data.copy()
    solver = PyPardisoSolver(mtype=2)
    solver.set_phase(13)  # analysis, factorization, solution

    def solve(diagonal: np.ndarray, f: np.ndarray) -> np.ndarray:
        upper.data[:] = values
        upper.data[first] += diagonal  # the first entry of each row of a sorted upper triangle
        u = solver._call_pardiso(upper, f)
        solver.set_phase(23)  # the same pattern again
        return u

    return solve


def superlu(matrix: csr_matrix) -> Solve:
    """Return what adds a diagonal to a matrix and solves."""
    columns = matrix.tocsc()
    size = columns.shape[0]
    values, own = columns.data.copy(), columns.indices == np.repeat(np.arange(size), np.diff(columns.indptr))

    def solve(diagonal: np.ndarray, f: np.ndarray) -> np.ndarray:
        columns.data[:] = values
        columns.data[own] += diagonal
        how = {"permc_spec": "MMD_AT_PLUS_A", "diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
        return splu(columns, **how).solve(f)

    return solve


SOLVERS = {
    "pardiso": (pardiso, "MKL PARDISO, Cholesky"),
    "superlu": (superlu, "SuperLU, symmetric mode, minimum degree"),
}


def main(unknowns: int, name: str = "pardiso") -> None:
    """Solve the plate and print the figures."""
    prepare, solver = SOLVERS[name]
    if name == "pardiso":
        import pypardiso  # noqa: F401  # the clock starts after all imports
    job = Job()
    with job.phase("mesh"):
        nx, ny = divisions(unknowns, 2)
        mesh = skfem.MeshQuad.init_tensor(np.linspace(0, A, nx + 1), np.linspace(0, B, ny + 1))
        element = skfem.ElementQuad2() * skfem.ElementVector(skfem.ElementQuad2())
        basis, fewer = (skfem.Basis(mesh, element, intorder=order) for order in (5, 3))
    with job.phase("assembly"):
        matrix = bending.assemble(basis) + shear.assemble(fewer)
        f, share = load.assemble(basis), area.assemble(basis)
        fixed = np.concatenate(
            [
                basis.get_dofs(lambda x: x[0] == 0).all("u^1^2"),  # beta_x
                basis.get_dofs(lambda x: x[1] == 0).all("u^2^2"),  # beta_y
            ]
        )
        matrix, f, _, free = skfem.condense(matrix, f, D=fixed)
        springs = K * share[free]
    with job.phase("solution"):
        solve = prepare(matrix)
    pushing = np.ones(len(free), dtype=bool)
    steps, settled = 0, False
    while not settled:
        steps += 1
        with job.phase("solution"):
            u = solve(np.where(pushing, springs, 0.0), f)
        # other unknowns have springs of no stiffness, which may push or not
        before, pushing = pushing, (u > 0) | (springs == 0)
        settled = bool((before == pushing).all())
        if steps > LIMIT:
            raise SystemExit("the springs do not come to rest")
    whole = np.zeros(basis.N)
    whole[free] = u
    x, y = mesh.p
    centre, corner = (whole[basis.nodal_dofs[0, node]] for node in ((x + y).argmin(), (x + y).argmax()))
    first = mesh.element_finder()(np.zeros(1), np.zeros(1))
    there = skfem.Basis(
        mesh, element, elements=first, quadrature=(mesh.mapping().invF(np.zeros((2, 1, 1)), first)[:, 0], np.ones(1))
    )
    (along_x, _), (_, along_y) = there.interpolate(whole)[1].grad[:, :, 0, 0]
    job.report(
        program="scikit-fem",
        version=skfem.__version__,
        element="nine nodes, shear with 2 x 2 points",
        solver=solver,
        unknowns=len(free),
        iterations=steps,
        centre=float(centre),
        corner=float(corner),
        moment=float(D * (along_x + NU * along_y)),
    )


if __name__ == "__main__":
    run(main)
