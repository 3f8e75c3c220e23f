"""The nested meshes of an analysis with all that its combinations of loads, and models like it, have in common."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from groundslab.arrays import Array
from groundslab.discretize.discretize import discretise
from groundslab.discretize.ground import Factors
from groundslab.discretize.plan_layout import Meshes
from groundslab.fem.foundation import Column
from groundslab.fem.sparse import Symmetric
from groundslab.fem.system import System, stiffness, system
from groundslab.model.model import Model
from groundslab.results.certificate import moved_as_a_whole
from groundslab.results.result_mesh import Frame, frame
from groundslab.solvers import warm_start
from groundslab.solvers.conditioning import NEARLY_RIGID, stiffness_ratio
from groundslab.solvers.equilibrium import rigid_motions
from groundslab.solvers.factor_reuse import CachedFactorization
from groundslab.solvers.protocols import Solver
from groundslab.solvers.solution import Solution

#: Parts of a model on which the frame of its results depends.
FRAMING = ("plate", "supports", "columns", "loads")


@dataclass(slots=True)
class Level:
    """One of the nested meshes with all that the combinations have in common on it."""

    model: Model
    system: System
    solver: Solver
    factorization: CachedFactorization
    matrix: tuple[float | None, Symmetric] | None = None  # the latest one, and the gamma that it belongs to
    places: warm_start.NodeLocations | None = None  # of its nodes in the mesh before
    rigid: Array | None = None  # the plate's rigid motions
    framed: tuple[Model, Frame] | None = None  # the frame of results, and a model that has it

    def stiffness(self, column: Column, gamma: float | None) -> Symmetric:
        """Return the matrix for the column that belongs to a gamma, the same one when asked for it again."""
        if self.matrix is None or self.matrix[0] != gamma:
            A = stiffness(self.system, column)
            if stiffness_ratio(self.system, column) > NEARLY_RIGID:
                A = replace(A, exact_products=moved_as_a_whole(self.system, column))
            self.matrix = gamma, A
        return self.matrix[1]

    @property
    def motions(self) -> Array:
        """Return the plate's rigid motions against which only one-sided bearings hold it, as unknowns (size, m)."""
        if self.rigid is None:
            self.rigid = rigid_motions(self.system.problem)
        return self.rigid

    def frame(self, model: Model) -> Frame:
        """Return the frame of a model's results, the same one for a model with the same plate, supports and loads.

        And with voids under the same elements.
        """
        problem = self.system.problem
        if (
            self.framed is None
            or any(getattr(model, name) != getattr(self.framed[0], name) for name in FRAMING)
            or not np.array_equal(problem.depths.most, self.framed[1].depth[self.framed[1].mesh.elements[:, 0]])
        ):
            self.framed = model, frame(model, problem)
        return self.framed[1]

    def beside(self) -> Level:
        """Return the same level with an analysis and a factor of its own, to be used at the same time."""
        pattern = self.system.pattern
        return replace(self, factorization=CachedFactorization(self.solver(pattern.indptr, pattern.indices)))


@dataclass(slots=True)
class Known:
    """What is known of a model that others are like: meshes, levels, and solutions on the finest mesh of a ladder.

    By coarsening and margin; the solutions, one for each load increment, by the combination too.
    """

    meshes: Meshes = field(default_factory=Meshes)
    levels: dict[tuple[int, float], Level] = field(default_factory=dict)
    solutions: dict[tuple[str, int, float], list[Solution]] = field(default_factory=dict)
    closed: bool = False  # whether nothing more is taken in

    def close(self) -> None:
        """Take nothing more in."""
        self.closed = self.meshes.closed = True


@dataclass(slots=True)
class Ladder:
    """The nested meshes of a model up to one of them, kept while there are further combinations to solve."""

    model: Model
    solver: Solver
    finest: int  # how often the mesh that is asked for is coarsened
    margin: float  # by which the meshed strip of ground beyond is widened
    keep: bool
    factors: Factors | None = None  # of constants of the ground
    known: Known | None = None  # of a model like this one
    levels: dict[int, Level] = field(default_factory=dict)

    def level(self, coarsening: int) -> Level:
        """Return one of the meshes with its system.

        Of a model like this one the mesh, the pattern and its analysis are taken over where they are the same.
        """
        level = self.levels.get(coarsening)
        if level is not None:
            return level
        known = self.known or Known()
        like = known.levels.get((coarsening, self.margin))
        earlier = None if like is None else (like.model, like.system.problem)
        problem = discretise(self.model, coarsening, self.margin, known.meshes, self.factors, earlier)
        s = system(problem, None if like is None else like.system)
        if like is not None and s.pattern is like.system.pattern:
            level = Level(self.model, s, self.solver, like.factorization, places=like.places, framed=like.framed)
        else:
            level = Level(
                self.model, s, self.solver, CachedFactorization(self.solver(s.pattern.indptr, s.pattern.indices))
            )
        if self.keep:
            self.levels[coarsening] = level
        if self.known is not None and not self.known.closed:
            self.known.levels[coarsening, self.margin] = level
        return level

    def beside(self) -> Ladder:
        """Return the same ladder with factors of its own, to be climbed at the same time."""
        return replace(self, levels={number: level.beside() for number, level in self.levels.items()})

    def frame(self, solution: Solution) -> Frame:
        """Return the frame of the results of a solution on the finest mesh."""
        level = self.levels.get(self.finest)
        return frame(self.model, solution.system.problem) if level is None else level.frame(self.model)

    def remember(self, combination: str, solutions: list[Solution]) -> None:
        """Keep the solutions of a combination, of each load increment, for models like this one."""
        if self.known is not None and not self.known.closed:
            self.known.solutions[combination, self.finest, self.margin] = solutions

    def knows(self, combination: str) -> bool:
        """Return whether a model like this one has solutions of a combination."""
        return self.known is not None and (combination, self.finest, self.margin) in self.known.solutions

    def like(self, combination: str, s: System) -> list[Solution]:
        """Return the solutions of a model like this one, if they are on the same mesh with the same bearings."""
        assert self.known is not None
        found = self.known.solutions[combination, self.finest, self.margin]
        bearings = len(s.problem.bearing.law)
        alike = all(
            each.system.problem.mesh is s.problem.mesh and len(each.contact.state) == bearings for each in found
        )
        return found if alike and len(found) == self.model.analysis.increments else []
