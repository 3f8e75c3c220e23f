"""Equilibrium of a plate that cracks: the secant stiffness of its elements, iterated around contact and gamma."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

import numpy as np

from groundslab.analysis.extrapolation import Extrapolation
from groundslab.analysis.gamma_iteration import solve_load_step
from groundslab.analysis.load_step import LoadStep, OnStep
from groundslab.analysis.mesh_hierarchy import Level, MeshHierarchy
from groundslab.errors import NoEquilibrium, NotConverged, SingularMatrix
from groundslab.fem.cracked_section import decisive_moments, effective_stiffness, law_error, secant_stiffness
from groundslab.results.records import Certificate
from groundslab.solvers.cracking import laws, mean_moments, with_stiffness
from groundslab.solvers.solution import Solution

#: The stiffness is iterated until moments are off the law by less than this share of the largest.
TOLERANCE = Certificate.LAW_TOLERANCE / 2
MAX_ITERATIONS = 300
#: An error that grows by more than this begins the extrapolation anew.
GROWTH = 2.0


def solve_cracked_meshes(
    hierarchy: MeshHierarchy, finest: Solution, coarser: Solution | None, report: OnStep
) -> tuple[Solution, Solution | None]:
    """Return the solutions of a plate that cracks on the finest mesh and on the next coarser one, if there is one.

    Started from those of the uncracked plate. Where the coarser mesh does not converge there is none to compare with.
    """
    before = None
    if coarser is not None:
        with suppress(NotConverged, NoEquilibrium, SingularMatrix):
            before = _solve_cracked(hierarchy.level(hierarchy.finest + 1), coarser, report, False)
    return _solve_cracked(hierarchy.level(hierarchy.finest), finest, report, True), before


def _solve_cracked(level: Level, start: Solution, report: OnStep, finest: bool) -> Solution:
    """Return the solution of a plate that cracks on one mesh, started from that of the uncracked one.

    Each step solves contact and gamma for secant stiffnesses, and takes new ones from the curvatures found. Raises
    NotConverged if these do not settle.
    """
    uncracked, limit = start.system, level.model.analysis.max_iterations
    law = laws(uncracked.problem)
    slip = np.zeros(len(uncracked.problem.contact.bearing.law))
    M = decisive_moments(mean_moments(uncracked.problem, start.U))
    B = effective_stiffness(M, *law.curve).min(axis=2)
    extrapolation, solution = Extrapolation(), start
    history: list[dict[str, float]] = []
    while len(history) < MAX_ITERATIONS:
        s = with_stiffness(uncracked, B)
        cracked_level = replace(level, system=s, matrix=None)
        solution = solve_load_step(LoadStep(s, cracked_level, 1.0, slip, finest, limit, report), solution)
        stiffness, moments = secant_stiffness(law, B, mean_moments(s.problem, solution.U))
        history.append({"iteration": len(history) + 1, "error": law_error(stiffness, moments, B)})
        if history[-1]["error"] <= TOLERANCE:
            return solution
        if len(history) > 1 and history[-1]["error"] > GROWTH * history[-2]["error"]:
            extrapolation = Extrapolation()
        tried = extrapolation.next(np.log(B), np.log(stiffness))
        B = np.exp(np.clip(tried, np.log(law.least), np.log(law.B_I)))
    raise NotConverged("the cracked stiffness", history, {"U": solution.U, "stiffness": B})
