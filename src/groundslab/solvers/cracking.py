"""A plate whose elements have cracked: its system for given stiffnesses, and how well these satisfy the section's law.

Each element has the stiffnesses B (mp, 2) [N m2/m] in both directions, and with them rigidities of its own; its moments
are means over 2 x 2 points, those that the results give for its center.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from groundslab.arrays import Array
from groundslab.fem import plate
from groundslab.fem.assembly import find_congruent, scatter
from groundslab.fem.cracked_section import (
    CrackedSections,
    law_error,
    orthotropic_rigidity,
    secant_stiffness,
)
from groundslab.fem.element_blocks import blocks
from groundslab.fem.hanging import collect
from groundslab.fem.problem import BETA_X, BETA_Y, Problem, plate_unknowns
from groundslab.fem.shape_functions import gauss
from groundslab.fem.system import System


def laws(problem: Problem) -> CrackedSections:
    """Return the law of each plate element."""
    assert problem.plate.cracking is not None
    return problem.plate.cracking


def with_stiffness(s: System, B: Array) -> System:
    """Return the system of an uncracked plate with elements that have cracked, of stiffness B (mp, 2).

    Curvatures that elements would take freely, by temperature or shrinkage, then load the plate by their new rigidity.
    """
    problem, law = s.problem, laws(s.problem)
    elements = problem.mesh.elements[problem.plate.elements]
    D, before = orthotropic_rigidity(B, law.B_I, law.nu), problem.plate.bending[problem.plate.rigidity]
    # by signs of rotations, sagging is a negative curvature
    free = problem.loading.free_curvature - law.shrinkage_I
    load = problem.load.copy()
    if free.any():
        xy = problem.mesh.nodes[elements]
        couples = plate.free_couples(xy, D, free) - plate.free_couples(xy, before, problem.loading.free_curvature)
        for field, couple in zip((BETA_X, BETA_Y), couples, strict=True):
            load[:, field] += collect(problem.mesh.elements, scatter(elements, couple, len(load)))
    cracked = replace(
        problem,
        plate=replace(problem.plate, bending=D, shear=law.shear, rigidity=np.arange(len(elements)), stiffness=B),
        loading=replace(problem.loading, load=load, free_curvature=free),
    )
    return System(cracked, s.pattern, blocks(cracked), s.beams, s.building)


def mean_moments(problem: Problem, U: Array) -> Array:
    """Return the mean moments m_x, m_y, m_xy of each plate element (mp, 3) [N m/m] from U (n, F)."""
    shapes, kind = find_congruent(problem.mesh.nodes[problem.mesh.elements[problem.plate.elements]])
    xy = problem.mesh.nodes[problem.mesh.elements[problem.plate.elements[shapes]]]
    mean = plate.bending_strain(gauss(2)[0], xy).mean(axis=1)
    elastic = np.einsum("eiu,eu->ei", mean[kind], plate_unknowns(problem, U))
    elastic[:, :2] -= problem.loading.free_curvature
    moments: Array = -np.einsum("eij,ej->ei", problem.plate.bending[problem.plate.rigidity], elastic)
    return moments


def error_of_law(problem: Problem, U: Array) -> float:
    """Return by how much the moments of a cracked plate are off its sections' law, over the largest moment."""
    assert problem.plate.stiffness is not None
    secant, M = secant_stiffness(laws(problem), problem.plate.stiffness, mean_moments(problem, U))
    return law_error(secant, M, problem.plate.stiffness)
