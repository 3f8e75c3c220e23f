"""The line force along the plate's edge: what the ground's shear hands over there, beside the pressure under the plate.

At an edge the ground's surface has a kink. The shear force A1 grad w of its top surface, across the edge, is larger
inside than outside by the line force f on the plate (docs/theory.md, edge line force).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.assembly import scatter
from groundslab.fem.foundation import Column
from groundslab.fem.hanging import collect
from groundslab.fem.mesh import SIDES
from groundslab.fem.problem import Problem
from groundslab.fem.shape_functions import gauss, gauss_line, inverse_jacobian, lagrange, q9
from groundslab.fem.system import System, surface_settlement
from groundslab.results.balance.forces import apply


@dataclass(frozen=True, slots=True)
class EdgeSides:
    """The sides of elements along the plate's edge, b of them, with three nodes (end, end, middle) each."""

    element: Integers  # (b,): among the plate's elements
    local: Integers  # (b, 3): numbers of the nodes in the element
    length: Array  # (b, 3) [m]: int N ds
    flux: Array  # (b, 3, 3, 2) [m]: int N_a N_b n ds, n being the normal outwards


def edge_sides(problem: Problem) -> EdgeSides:
    """Return the sides along the plate's edge; a line of symmetry is none."""
    elements = problem.mesh.elements[problem.plate.elements]
    is_middle = np.zeros(len(problem.mesh.nodes), dtype=bool)
    is_middle[problem.plate.edges[:, 2]] = True
    element, side = np.nonzero(is_middle[elements[:, SIDES[:, 2]]])
    local = SIDES[side]
    places, weights = gauss_line(3)
    N, dN = (values[:, [0, 2, 1]] for values in lagrange(places))
    tangent = np.einsum("pa,bax->bpx", dN, problem.mesh.nodes[elements[element[:, None], local]])
    # the element lies to the left of its sides
    normal = np.stack([tangent[..., 1], -tangent[..., 0]], axis=-1)
    length = np.einsum("p,pa,bp->ba", weights, N, np.linalg.norm(tangent, axis=-1))
    flux = np.einsum("p,pa,pc,bpx->bacx", weights, N, N, normal, optimize=True)
    return EdgeSides(element, local, length, flux)


def edge_lengths(sides: EdgeSides, elements: Integers, n: int) -> Array:
    """Return each node's share of the edge's length (n,) [m]; elements (mp, 9) are the plate's."""
    return scatter(elements[sides.element[:, None], sides.local], sides.length, n)


def ground_shear(s: System, U: Array, column: Column) -> Array:
    """Return the shear force A1 grad w [N/m] of the ground's top surface at the plate's Gauss points, (mp, 4, 2)."""
    problem = s.problem
    under = problem.plate.elements
    elements = problem.mesh.elements[under]
    w = surface_settlement(s, U)
    A1 = column.at(under).A1[..., 0, :]
    acting = np.einsum("...j,jea->ea" if A1.ndim == 1 else "ej,jea->ea", A1, w[:, elements])
    _, dN = q9(gauss(2)[0])
    inverse, _ = inverse_jacobian(dN, problem.mesh.xy[under])
    shear: Array = np.einsum("epxi,pia,ea->epx", inverse, dN, acting, optimize=True)
    return shear


def pressure_forces(s: System, U: Array, column: Column, sides: EdgeSides, shear: Array) -> Array:
    """Return the nodal forces (n,) [N] of the pressure under the plate alone, line forces left out.

    It is int p N dA with p = A0 w - div A1 grad w of the top surface, by parts: the ground's forces in the plate's
    elements less its shear force across the edge. shear (mp, 9, 2) [N/m] is that at the nodes of these elements.
    """
    problem, b = s.problem, s.blocks
    under = problem.plate.elements
    elements, n = problem.mesh.elements[under], len(problem.mesh.nodes)
    w, column = surface_settlement(s, U), column.at(under)
    forces = np.zeros((len(under), 9))
    for j in range(column.surfaces):
        A0, A1 = column.A0[..., 0, j, None], column.A1[..., 0, j, None]
        forces += A0 * apply(b.mass, b.kind[under], w[j][elements])
        forces += A1 * apply(b.slope, b.kind[under], w[j][elements])
    at_sides = shear[sides.element[:, None], sides.local]
    across = np.einsum("bacx,bcx->ba", sides.flux, at_sides)
    inner = collect(problem.mesh.elements, scatter(elements, forces, n))
    return inner - scatter(elements[sides.element[:, None], sides.local], across, n)


def split_contact_force(
    force: Array, pressed_by: Array, area: Array, length: Array, limit: float, tensionless: bool
) -> tuple[Array, Array]:
    """Return pressure (k,) [Pa] and line force (k,) [N/m] of nodes on the edge whose contact force is `force` (k,) [N].

    Both together are this force, whatever the pressure's share `pressed_by` (k,) is; where the ground cannot pull
    neither of them does, and the pressure stays below the limit.
    """
    share = np.clip(pressed_by, 0.0, np.minimum(np.maximum(force, 0.0), limit * area)) if tensionless else pressed_by
    return share / area, (force - share) / length
