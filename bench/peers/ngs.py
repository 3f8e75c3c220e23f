"""NGSolve: quadrilaterals of any order, springs at the integration points, sparse Cholesky factorizations.

    python bench/peers/ngs.py 25000        # order 2
    python bench/peers/ngs.py 25000 4      # order 4

Order 2 is kept from locking in NGSolve's own way, by interpolating the rotations into edge elements; the plate's matrix
is then assembled once and the ground's in each step. Order 4 does not lock in this plate; what belongs to one element
only is condensed, which takes one assembly of everything in each step. Of each order this was the quicker way.
Newton's method on the contact: all springs push at first, and the steps end when none changes.
"""

from __future__ import annotations

import ngsolve as ng
from first_plate import LIMIT, LOADED, NU, SHEAR, A, B, D, Job, K, Q, divisions, run
from ngsolve.meshes import MakeStructured2DMesh


def main(unknowns: int, order: str = "2") -> None:
    """Solve the plate and print the figures."""
    p = int(order)
    job = Job()
    with ng.TaskManager():
        with job.phase("mesh"):
            nx, ny = divisions(unknowns, p)
            mesh = MakeStructured2DMesh(quads=True, nx=nx, ny=ny, mapping=lambda x, y: (A * x, B * y))
        found, free, iterations = solve(job, mesh, p, p == 2)
        settled, rotated = found.components
        centre, corner = settled(mesh(0, 0)), settled(mesh(A, B))
        along_x, _, _, along_y = ng.Grad(rotated)(mesh(0, 0))
    job.report(
        program="NGSolve",
        version=ng.__version__,
        element=f"quadrilaterals of order {p}" + (", rotations interpolated into edge elements" if p == 2 else ""),
        solver="sparse Cholesky",
        unknowns=free,
        iterations=iterations,
        centre=centre,
        corner=corner,
        moment=D * (along_x + NU * along_y),
    )


def solve(job: Job, mesh: ng.Mesh, p: int, low: bool) -> tuple[ng.GridFunction, int, int]:
    """Return settlement and rotations, the number of unknowns and of steps; `low` is for orders that would lock."""
    with job.phase("assembly"):
        V = ng.H1(mesh, order=p) * ng.VectorH1(mesh, order=p, dirichletx="left", dirichlety="bottom")
        (w, beta), (v, eta) = V.TnT()
        kappa, other = ng.Sym(ng.Grad(beta)), ng.Sym(ng.Grad(eta))
        bending = D * ((1 - NU) * ng.InnerProduct(kappa, other) + NU * ng.Trace(kappa) * ng.Trace(other))
        if low:
            edges = ng.HCurl(mesh, order=p - 1)
            beta, eta = ng.Interpolate(beta, edges), ng.Interpolate(eta, edges)
        shear = SHEAR * (ng.grad(w) - beta) * (ng.grad(v) - eta)
        # one rule for springs and for the count of what changes, so that none changes unseen
        at = ng.dx(intrules={ng.ET.QUAD: ng.IntegrationRule(ng.ET.QUAD, 2 * p + 1)})
        found, before = ng.GridFunction(V), ng.GridFunction(V)
        settled, pushing = found.components[0], ng.IfPos(before.components[0], 1, 0)
        before.components[0].Set(1)
        springs = K * pushing * w * v * at
        plate = ng.BilinearForm(V, symmetric=True, condense=not low)
        plate += bending * ng.dx + shear * ng.dx
        ground = plate
        if low:
            plate.Assemble()
            ground = ng.BilinearForm(V, symmetric=True)
        ground += springs
        f = ng.LinearForm(V)
        f += Q * ng.IfPos(LOADED - ng.x, 1, 0) * ng.IfPos(LOADED - ng.y, 1, 0) * v * ng.dx
        f.Assemble()
    matrix = inverse = None
    for iteration in range(1, LIMIT + 1):
        with job.phase("assembly"):
            ground.Assemble()
            if matrix is None:
                matrix = plate.mat.CreateMatrix() if low else plate.mat
            if low:
                matrix.AsVector().data = plate.mat.AsVector() + ground.mat.AsVector()
        with job.phase("solution"):
            if inverse is None:
                inverse = matrix.Inverse(V.FreeDofs(not low), "sparsecholesky")
            else:
                inverse.Update()  # the same pattern again
            if low:
                found.vec.data = inverse * f.vec
            else:
                rest = f.vec.CreateVector()
                rest.data = f.vec + plate.harmonic_extension_trans * f.vec
                found.vec.data = inverse * rest
                found.vec.data += plate.harmonic_extension * found.vec
                found.vec.data += plate.inner_solve * f.vec
        with job.phase("contact"):
            changed = (ng.IfPos(settled, 1, 0) - pushing) ** 2
            if ng.Integrate(changed * at, mesh) == 0:
                return found, sum(V.FreeDofs()), iteration
            before.vec.data = found.vec
    raise SystemExit("the springs do not come to rest")


if __name__ == "__main__":
    run(main)
