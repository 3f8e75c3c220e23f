"""The nested meshes of an analysis, with everything that combinations of loads and similar models share."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from groundslab.accuracy.prolongation import Prolongation, make_prolongation
from groundslab.arrays import Array, Integers
from groundslab.discretize.discretize import discretize
from groundslab.discretize.ground import Factors
from groundslab.discretize.plan_layout import Meshes
from groundslab.fem.foundation import Column
from groundslab.fem.mesh import Mesh
from groundslab.fem.problem import Problem
from groundslab.fem.sparse.symmetric import Symmetric
from groundslab.fem.system import System, build_system, stiffness
from groundslab.model.model import Model
from groundslab.model.settings import Mesh as Wanted
from groundslab.results.balance.forces import exact_rigid_products
from groundslab.results.mirroring import ResultMesh, make_result_mesh
from groundslab.solvers import warm_start
from groundslab.solvers.coarser_plate import CoarserPlate
from groundslab.solvers.conditioning import NEARLY_RIGID, stiffness_ratio
from groundslab.solvers.direct.protocols import Solver
from groundslab.solvers.equilibrium import rigid_motions
from groundslab.solvers.factor_reuse import CachedFactorization
from groundslab.solvers.plate_on_continuum import PlateOnContinuum
from groundslab.solvers.solution import Solution

#: Contact zones that differ at so few nodes of the coarser mesh differ little on the finer one, too.
ALIKE = 6
#: A draft with more elements is made coarser once more: it is to be seen soon, and tells no errors.
LARGE_DRAFT = 2500

#: A combination that is unlike those before starts from a mesh with about so many elements of one size.
UNIFORM_ELEMENTS = 300
#: Factors are multiples of each other to so many digits.
DIGITS = 12

#: Sections of a model on which the mesh of its results depends.
RESULT_MESH_SECTIONS = ("plate", "plates", "supports", "columns", "loads")


@dataclass(frozen=True, slots=True)
class Solved:
    """Solutions of a combination on one mesh, one for each load increment."""

    factors: Array  # (cases,)
    solutions: list[Solution]


def uniform_mesh(model: Model, elements: int) -> Wanted:
    """Return what asks for elements of one size, about so many on all plates."""
    area = sum(math.prod(plate.sides) for plate in model.every_plate)
    return model.mesh.replace(size=math.sqrt(area / elements), counts=None, max_unknowns=None, refine=())


def direction(factors: Array) -> bytes:
    """Return what is the same for factors (cases,) that are multiples of each other, but for rounding."""
    return np.round(factors / (np.abs(factors).max(initial=0.0) or 1.0), DIGITS).tobytes()


@dataclass(slots=True)
class Level:
    """One of the nested meshes, with everything that the combinations share on it."""

    model: Model
    system: System
    solver: Solver
    factorization: CachedFactorization
    matrix: tuple[float | None, Symmetric] | None = None  # the latest one, and the gamma that it belongs to
    located: tuple[Mesh, warm_start.NodeLocations] | None = None  # its nodes in another mesh, which is given first
    rigid: Array | None = None  # the plate's rigid motions
    column: Column | None = None  # of the ground, for the first gamma
    on_continuum: PlateOnContinuum | None = None  # with its factor, on an elastic continuum
    coarser_plate: CoarserPlate | None = None  # the same on a coarser mesh, under the cells of this one
    cached: tuple[Model, ResultMesh] | None = None  # the mesh of results, and a model that has it
    prolongation: Prolongation | None = None  # from the mesh of results of the next coarser mesh to its own
    zones: list[tuple[Integers, Integers]] = field(default_factory=list)  # found: states on the coarser mesh, and here
    #: What was solved on the coarsest mesh by this thread, from which it starts others, and by all threads together.
    starts: list[Solved] = field(default_factory=list)
    solved: dict[bytes, Solved] = field(default_factory=dict)
    multiples: dict[bytes, Solved] = field(default_factory=dict)  # what bears and yields, by the loads' direction

    def stiffness(self, column: Column, gamma: float | None) -> Symmetric:
        """Return the matrix for the column that belongs to a gamma; the latest one is cached."""
        if self.matrix is None or self.matrix[0] != gamma:
            A = stiffness(self.system, column)
            if column.A0.any() and stiffness_ratio(self.system, column) > NEARLY_RIGID:
                A = replace(A, exact_products=exact_rigid_products(self.system, column))
            self.matrix = gamma, A
        return self.matrix[1]

    @property
    def first_column(self) -> Column:
        """Return the column of the ground, for the gamma that is given, or from which it is iterated."""
        if self.column is None:
            ground = self.system.problem.ground
            self.column = ground if isinstance(ground, Column) else ground.first_column()
        return self.column

    @property
    def motions(self) -> Array:
        """Return the plate's rigid motions against which only one-sided bearings hold it, as unknowns (size, m)."""
        if self.rigid is None:
            self.rigid = rigid_motions(self.system.problem)
        return self.rigid

    def result_mesh(self, model: Model) -> ResultMesh:
        """Return the mesh of a model's results, cached for models with the same plate, supports, loads and voids."""
        problem = self.system.problem
        if (
            self.cached is None
            or any(getattr(model, name) != getattr(self.cached[0], name) for name in RESULT_MESH_SECTIONS)
            or not np.array_equal(
                problem.contact.depths.dominant, self.cached[1].depth[self.cached[1].mesh.elements[:, 0]]
            )
        ):
            self.cached = model, make_result_mesh(model, problem)
        return self.cached[1]

    def zone_like(self, coarser: Integers) -> Integers | None:
        """Return the states (c,) found for a combination whose states on the coarser mesh hardly differ, if any."""
        alike = [(before, after) for before, after in self.zones if len(before) == len(coarser)]
        counts = [(np.count_nonzero(before != coarser), after) for before, after in alike]
        rank, state = min(counts, key=lambda counted: counted[0], default=(np.inf, None))
        return None if state is None or rank > ALIKE else state.astype(np.int64)

    def multiple(self, factors: Array) -> list[Solution]:
        """Return what was solved on this mesh for a multiple of some factors (cases,), by the ratio, if anything was.

        Bearings, forces and gamma alone. Where a gap, play or limit sets a scale, none are given.
        """
        solved = self.multiples.get(direction(factors))
        law = self.system.problem.contact.bearing.law
        if (
            solved is None
            or not factors.any()
            or law.offset.any()
            or (np.isfinite(law.limit_force) & (law.limit_force > 0)).any()
        ):
            return []
        ratio = np.abs(factors).max() / np.abs(solved.factors).max()
        return [solution.scale_forces(ratio) for solution in solved.solutions]

    def keep_for_multiples(self, solved: Solved) -> None:
        """Keep what multiples of these loads start from on this mesh."""
        bare = [solution.without_unknowns(self.system) for solution in solved.solutions]
        self.multiples.setdefault(direction(solved.factors), Solved(solved.factors, bare))

    def add(self, solved: Solved) -> None:
        """Keep what was solved on the coarsest mesh."""
        self.starts.append(solved)
        self.solved[solved.factors.tobytes()] = solved

    def locations_in(self, other: Problem) -> warm_start.NodeLocations:
        """Return where its nodes lie in the mesh of another problem."""
        if self.located is None or self.located[0] is not other.mesh:
            self.located = other.mesh, warm_start.locate_nodes(other, self.system.problem)
        return self.located[1]

    def clone(self) -> Level:
        """Return the same level with an analysis and a factor of its own, for use on another thread."""
        factorization = make_factorization(self.solver, self.system)
        on_continuum = None if self.on_continuum is None else replace(self.on_continuum, factorization=factorization)
        copied = replace(self, zones=[*self.zones], starts=[*self.starts])
        return replace(copied, factorization=factorization, on_continuum=on_continuum, coarser_plate=None)


def make_factorization(solver: Solver, s: System) -> CachedFactorization:
    """Return the analyzed pattern of a system, which keeps several factors."""
    analyze = partial(solver, s.pattern.indptr, s.pattern.indices)
    return CachedFactorization(analyze(), analyze)


@dataclass(slots=True)
class ReferenceSolutions:
    """Meshes, levels and solutions of a base case from which similar models start.

    Levels by coarsening and margin; solutions, one for each load increment, by the combination too.
    """

    meshes: Meshes = field(default_factory=Meshes)
    levels: dict[tuple[int, float], Level] = field(default_factory=dict)
    solutions: dict[tuple[str, int, float], list[Solution]] = field(default_factory=dict)
    closed: bool = False  # whether nothing more is stored

    def close(self) -> None:
        """Store nothing more."""
        self.closed = self.meshes.closed = True


@dataclass(slots=True)
class MeshHierarchy:
    """The nested meshes of a model up to its finest one, kept while there are further combinations to solve."""

    model: Model
    solver: Solver
    finest: int  # how often the finest of these meshes is coarsened
    margin: float  # factor on the width of the meshed ground beyond the plate
    keep: bool
    meshes: Meshes = field(default_factory=Meshes)
    factors: Factors | None = None  # on constants of the ground
    reference: ReferenceSolutions | None = None  # of a similar model
    levels: dict[int, Level] = field(default_factory=dict)
    coarsenings: list[int] | None = None  # how often each of the meshes is coarsened, once that is known
    earlier: Sequence[Solved] = ()  # on the coarsest of the meshes before these
    uniform: MeshHierarchy | None = None  # of few elements, from which combinations unlike all others start

    def start(self, level: Level, factors: Array) -> list[Solution]:
        """Return the solutions from which a combination of some factors (cases,) starts on the coarsest level.

        Its own ones on a draft, else those of the nearest combination.
        """
        for drafted in self.levels.values():
            if factors.tobytes() in drafted.solved:
                return drafted.solved[factors.tobytes()].solutions
        starts = [*self.earlier, *level.starts]
        nearest = min(starts, key=lambda solved: float(np.abs(solved.factors - factors).sum()), default=None)
        return [] if nearest is None else nearest.solutions

    def solved(self) -> list[Solved]:
        """Return what was solved on the coarsest mesh and on a draft, in an order that no thread changes."""
        by_factors: dict[bytes, Solved] = {}
        for coarsening in sorted(self.levels, reverse=True):
            by_factors |= self.levels[coarsening].solved
        return [by_factors[key] for key in sorted(by_factors)]

    def level(self, coarsening: int) -> Level:
        """Return one of the meshes with its system.

        Mesh, pattern and analysis of the reference are reused where they are the same.
        """
        level = self.levels.get(coarsening)
        if level is not None:
            return level
        reference = self.reference or ReferenceSolutions()
        like = reference.levels.get((coarsening, self.margin))
        earlier = None if like is None else (like.model, like.system.problem)
        problem = discretize(self.model, coarsening, self.margin, self.meshes, self.factors, earlier)
        s = build_system(problem, None if like is None else like.system)
        if like is not None and s.pattern is like.system.pattern:
            level = Level(self.model, s, self.solver, like.factorization, located=like.located, cached=like.cached)
        else:
            level = Level(self.model, s, self.solver, make_factorization(self.solver, s))
        if self.keep:
            self.levels[coarsening] = level
        if self.reference is not None and not self.reference.closed:
            self.reference.levels[coarsening, self.margin] = level
        return level

    def draft(self) -> MeshHierarchy:
        """Return the same meshes up to the next coarser one, or the one before if that is large."""
        elements = len(self.level(self.finest + 1).system.problem.mesh.elements)
        return replace(self, finest=self.finest + (2 if elements > LARGE_DRAFT else 1), coarsenings=None)

    def make_uniform(self) -> MeshHierarchy:
        """Return nested meshes of the same model with few elements of one size; made once."""
        if self.uniform is None:
            model = self.model.model_copy(update={"mesh": uniform_mesh(self.model, UNIFORM_ELEMENTS)})
            self.uniform = MeshHierarchy(model, self.solver, 0, self.margin, keep=True, factors=self.factors)
        return self.uniform

    def clone(self) -> MeshHierarchy:
        """Return the same hierarchy with factors of its own, for use on another thread."""
        levels = {number: level.clone() for number, level in self.levels.items()}
        return replace(self, levels=levels, uniform=self.uniform and self.uniform.clone())

    def result_mesh(self, solution: Solution, coarsening: int) -> ResultMesh:
        """Return the mesh of the results of a solution on one of the meshes."""
        level = self.levels.get(coarsening)
        return make_result_mesh(self.model, solution.system.problem) if level is None else level.result_mesh(self.model)

    def prolongation(self, coarser: Solution, finer: Solution, frame: ResultMesh) -> Prolongation:
        """Return what takes fields from the next coarser mesh to the finest one, whose mesh of results is `frame`."""
        level, before = self.levels.get(self.finest), self.result_mesh(coarser, self.finest + 1)
        prolongation = None if level is None else level.prolongation
        if (
            prolongation is None
            or prolongation.coarser.mesh is not before.mesh
            or prolongation.finer.mesh is not frame.mesh
        ):
            prolongation = make_prolongation(before, frame, (coarser.system.problem.mesh, finer.system.problem.mesh))
        if level is not None:
            level.prolongation = prolongation
        return prolongation

    def store(self, combination: str, solutions: list[Solution]) -> None:
        """Store the solutions of a combination, one for each load increment, for similar models."""
        if self.reference is not None and not self.reference.closed:
            self.reference.solutions[combination, self.finest, self.margin] = solutions

    def has_reference(self, combination: str) -> bool:
        """Return whether a similar model has solutions of a combination."""
        return self.reference is not None and (combination, self.finest, self.margin) in self.reference.solutions

    def matching(self, combination: str, s: System) -> list[Solution]:
        """Return the solutions of a similar model, if they are on the same mesh with the same bearings."""
        assert self.reference is not None
        solutions = self.reference.solutions[combination, self.finest, self.margin]
        bearings = len(s.problem.contact.bearing.law)
        alike = all(
            solution.system.problem.mesh is s.problem.mesh and len(solution.contact.state) == bearings
            for solution in solutions
        )
        return solutions if alike and len(solutions) == self.model.analysis.increments else []
