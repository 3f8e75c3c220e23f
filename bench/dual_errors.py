"""Errors of values by dual solutions and by two meshes, over the true ones: the figures of decision 0019.

    python bench/dual_errors.py

A slab of 12 m x 8 m and 0.3 m on springs under a patch, glued. The error of a linear figure is about the energy product
of the recovered-minus-raw fields of the solution and of a dual one, loaded by the figure itself (Prudhomme and Oden
1999). The product of errors is a fourth of the difference between the squared errors of sum and difference.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from groundslab.accuracy.energy import energy_errors
from groundslab.accuracy.values import estimate_error
from groundslab.analysis import driver, nested
from groundslab.analysis.mesh_hierarchy import MeshHierarchy
from groundslab.analysis.tasks.task import task_of
from groundslab.arrays import Array
from groundslab.fem import plate
from groundslab.fem.problem import BETA_X, BETA_Y, W
from groundslab.fem.shape_functions import gauss, jacobian, q9
from groundslab.fem.system import nodal_table, stiffness
from groundslab.model.combinations import list_combinations
from groundslab.model.model import Model
from groundslab.results.mirroring import make_result_mesh
from groundslab.results.recovery import recover_fields
from groundslab.results.results import CombinationResult
from groundslab.solvers import factorization
from groundslab.solvers.solution import Solution

#: Sides of the elements [m], the last one for the truth.
SIZES = (1.0, 0.5, 0.25, 0.125)
CORNER = (6.0, 4.0)
#: Rectangles x0, x1, y0, y1 [m] over which m_x is averaged: under the load, and beside it.
AREAS = {"mean moment under the load": (-1.0, 2.0, -1.0, 1.0), "mean moment beside it": (3.0, 5.0, -1.0, 1.0)}


def slab(size: float) -> Model:
    """Return the slab."""
    return Model(
        plate={"length_x": 2 * CORNER[0], "length_y": 2 * CORNER[1], "thickness": 0.3, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        contact={"tensionless": False},
        loads=[{"kind": "patch", "x": (-1.0, 2.0), "y": (-1.0, 1.0), "q": 1e5}],
        mesh={"counts": (round(2 * CORNER[0] / size), round(2 * CORNER[1] / size)), "symmetry": "off"},
    )


def solve(model: Model) -> Solution:
    """Return the solution on the finest mesh."""
    hierarchy = MeshHierarchy(model, factorization.choose("auto")[1], 0, 1.0, False)
    (combination,) = list_combinations(model)
    factors = np.array(task_of(model, combination).factors)
    return nested.solve_nested(hierarchy, combination.name, factors, lambda _: None)[0][-1]


def figures(solution: Solution) -> dict[str, Array]:
    """Return the linear figures of a solution as tables (n, F): their values are sums over those times U."""
    problem = solution.system.problem
    found = {name: np.zeros(solution.U.shape) for name in ("settlement of a corner", *AREAS)}
    found["settlement of a corner"][np.abs(problem.mesh.nodes - CORNER).sum(axis=1).argmin(), W] = 1.0
    points, weights = gauss(3)
    xy = problem.mesh.xy
    sheet = problem.plate
    D, S = sheet.bending[sheet.section], sheet.shear[sheet.section]
    matrices = plate.section_matrices(sheet.element, points, xy, D, S)
    moment = np.einsum("ep,epu->eu", jacobian(q9(points)[1], xy)[2] * weights, matrices[:, :, 0])
    for name, (x0, x1, y0, y1) in AREAS.items():
        x, y = xy[:, 8].T
        inside = (x > x0) & (x < x1) & (y > y0) & (y < y1)
        nodes = problem.mesh.elements[inside]
        for number, field in enumerate((W, BETA_X, BETA_Y)):
            part = moment[inside, 9 * number : 9 * number + 9] / ((x1 - x0) * (y1 - y0))
            np.add.at(found[name][:, field], nodes, part)
    return found


def dual(solution: Solution, load: Array) -> Array:
    """Return the unknowns (n, F) under a load (n, F), with a factor of the same matrix."""
    s = solution.system
    A, has = stiffness(s, solution.column), s.problem.unknown >= 0
    f = np.zeros(A.size)
    f[s.problem.unknown[has]] = load[has]
    factor = factorization.choose("auto")[1](A.indptr, A.indices).factor(A.data)
    return nodal_table(s.problem, factor.solve(f))


def product_of_errors(model: Model, solution: Solution, Z: Array) -> float:
    """Return the energy product of the errors of a solution and of a dual one."""
    frame = make_result_mesh(model, solution.system.problem)
    scale = np.abs(solution.U).max() / np.abs(Z).max()
    squares = []
    for sign in (1, -1):
        together = replace(solution, U=solution.U + sign * scale * Z)
        squares.append(energy_errors(together, frame, recover_fields(together, frame)).sum())
    return float(squares[0] - squares[1]) / (4 * scale)


def reported(results: CombinationResult) -> dict[str, float]:
    """Return the same figures as they are reported, moments recovered."""
    p = results.plate
    found = {"settlement of a corner": float(p.value_at("settlement", *CORNER))}
    for name, (x0, x1, y0, y1) in AREAS.items():
        x, y = (a + (b - a) * (np.arange(24) + 0.5) / 24 for a, b in ((x0, x1), (y0, y1)))
        X, Y = np.meshgrid(x, y)
        found[name] = float(p.value_at("moment_x", X.ravel(), Y.ravel()).mean())
    return found


def main() -> None:
    """Print estimates over true errors on each mesh."""
    finest = solve(slab(SIZES[-1]))
    exact = {name: float((b * finest.U).sum()) for name, b in figures(finest).items()}
    told = reported(driver.solve(slab(SIZES[-1])).only)
    for size in SIZES[:-1]:
        model = slab(size)
        solution, results = solve(model), driver.solve(model).only
        assert results.coarser is not None
        assert results.comparison is not None
        now, before = reported(results), reported(results.coarser)
        for name, b in figures(solution).items():
            true = exact[name] - float((b * solution.U).sum())
            estimate = product_of_errors(model, solution, dual(solution, b))
            of_two = estimate_error(now[name], before[name], results.comparison)
            print(
                f"{size} m, {name}: dual / true {estimate / true:.2f}, two meshes / true of what is reported "
                f"{of_two / abs(told[name] - now[name]):.2f}"
            )


if __name__ == "__main__":
    main()
