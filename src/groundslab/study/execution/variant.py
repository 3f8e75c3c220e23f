"""Solves one variant and makes its row."""

from __future__ import annotations

import hashlib
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from groundslab import errors
from groundslab.errors import GroundslabError, InputError, Issue
from groundslab.fem.mesh import Mesh
from groundslab.model.combinations import list_combinations
from groundslab.model.loads.load_cases import has_ultimate_combination
from groundslab.solvers import factorization
from groundslab.solvers.direct import pardiso
from groundslab.study.definition import case_paths, outputs
from groundslab.study.sampling import random_fields

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.model.model import Model
    from groundslab.results.results import Results
    from groundslab.study.definition.outputs import RequestedOutput
    from groundslab.study.definition.setup import Setup
    from groundslab.study.sampling.designs import Variant

T = TypeVar("T")

#: How a variant ended; of one whose foundation fails that is the result.
SOLVED, FOUNDATION_FAILS, FAILED = "solved", "foundation fails", "failed"

#: Errors that a variant fails with whenever it is solved: its row has the reason and is final.
REASONS: dict[type[GroundslabError], str] = {InputError: "input"} | {
    kind: kind.__name__
    for kind in (
        errors.IllConditioned, errors.NeutralEquilibrium, errors.NoEquilibrium, errors.NotConverged,
        errors.NotCertified, errors.SingularMatrix,
    )
}  # fmt: skip
#: The reasons that are failures of the foundation.
WITHOUT_EQUILIBRIUM = tuple(word for kind, word in REASONS.items() if issubclass(kind, errors.NoEquilibrium))
MAX_MESSAGE_LENGTH = 2000  # characters


def key_of(mesh: Mesh) -> str:
    """Return the key of a mesh: the SHA-256 of its nodes and elements."""
    nodes, elements = np.ascontiguousarray(mesh.nodes, dtype="<f8"), np.ascontiguousarray(mesh.elements, dtype="<i8")
    return hashlib.sha256(nodes.tobytes() + elements.tobytes()).hexdigest()


@dataclass(frozen=True, eq=False)
class Row:
    """The results of a variant, in SI units. One that is not solved has a reason, and None where there is no result."""

    number: int
    status: str
    reason: str
    message: str
    seconds: float
    inputs: tuple[Any, ...]  # values of the variables, then seeds of the random fields
    results: tuple[float | None, ...]  # in the order of `Setup.scalar_outputs`
    fields: tuple[Array | None, ...] = ()  # (n,) each, in the order of `Setup.nodal_outputs`
    mesh: str = ""  # key of the mesh that the fields are given on
    meshes: tuple[Mesh, ...] = field(default=(), repr=False)  # that mesh, where it is not known yet
    #: Of each result its value in the case as it is and the discretization error of that, None where it has none.
    base: tuple[tuple[float, float] | None, ...] = ()


@dataclass(frozen=True, slots=True)
class WorkerFailure:
    """A variant without a row, because of the machine or a defect of the program, not of the variant's values."""

    number: int
    message: str


class Worker:
    """Solves variants of one study in this process, reusing what they have in common.

    All start from the case as it is, not from one another, so that a row does not depend on those before it.
    """

    def __init__(self, setup: Setup) -> None:
        pardiso.make_reproducible()
        self._setup = setup
        combinations = list_combinations(setup.model)
        self._names = tuple(combination.name for combination in combinations)
        self._ultimate = {combination.name for combination in combinations if combination.limit_state == "ultimate"}
        named = {output.combination for output in setup.outputs}
        #: Combinations of the case that are solved, by their positions.
        self._solved = [n for n, name in enumerate(self._names) if "" in named or name in named]
        # as many threads as there are workers are at work already, and sums of one thread come out the same everywhere
        with factorization.one_thread():
            self._solve, base = self._solver()
        names = {name: name for name in self._names}
        self._base = tuple(
            None if base is None else outputs.error_of(output, base, self._names_for(output, names))
            for output in setup.scalar_outputs
        )

    def outcome(self, variant: Variant, known_meshes: Sequence[str] = ()) -> Row | WorkerFailure:
        """Return the row of a variant, or why it has none; raises MemoryError, as others may hold the memory."""
        try:
            return self.row(variant, known_meshes)
        except MemoryError:
            raise
        except Exception as error:
            return WorkerFailure(variant.number, describe_error(error))

    def row(self, variant: Variant, known_meshes: Sequence[str] = ()) -> Row:
        """Return the row of a variant; errors of REASONS make rows too, others are raised."""
        began = time.perf_counter()
        combined: Results | None = None
        names: dict[str, str] = {}
        try:
            model, names = self._model(variant.values)
            with factorization.one_thread():
                fields = zip(self._setup.fields, variant.seeds, strict=True)
                factors = {
                    random_field.path: random_fields.factors(random_field, seed) for random_field, seed in fields
                }
                combined = self._solve(model, factors)
            # a foundation that fails counts more than what was not solved
            failure = next(iter([*combined.without_equilibrium.values(), *combined.refused.values()]), None)
        except GroundslabError as error:
            failure = error
        status, reason, message = (SOLVED, "", "") if failure is None else _outcome_of(failure)

        def take(what: Callable[[RequestedOutput, Results, Sequence[str]], T], output: RequestedOutput) -> T | None:
            return None if combined is None else what(output, combined, self._names_for(output, names))

        results = tuple(take(outputs.scalar_of, output) for output in self._setup.scalar_outputs)
        arrays = tuple(take(outputs.nodal_values_of, output) for output in self._setup.nodal_outputs)
        mesh = ""
        meshes = tuple[Mesh, ...]()
        if combined is not None and any(array is not None for array in arrays):
            plate = next(iter(combined.results.values())).plate
            plate_mesh = Mesh(plate.nodes, plate.elements)
            mesh = key_of(plate_mesh)
            meshes = () if mesh in known_meshes else (plate_mesh,)
        inputs = (*variant.values, *variant.seeds)
        seconds = time.perf_counter() - began
        return Row(variant.number, status, reason, message, seconds, inputs, results, arrays, mesh, meshes, self._base)

    def _names_for(self, output: RequestedOutput, names: dict[str, str]) -> list[str]:
        """Return the names of the combinations of a variant that an output is of."""
        wanted = [output.combination] if output.combination else [self._names[n] for n in self._solved]
        return [names[name] for name in wanted if name in self._ultimate or not output.is_steel]

    def _model(self, values: Sequence[Any]) -> tuple[Model, dict[str, str]]:
        """Return the case with the variables' values, and the names there of the combinations that are solved.

        Names made by EN 1990 contain factors, which may vary: combinations are matched by position.
        """
        pairs = zip(self._setup.variables, values, strict=True)
        values_in_case = {variable.place: variable.value_in_case(value) for variable, value in pairs}
        model = case_paths.with_values(self._setup.model, values_in_case)
        combinations = list_combinations(model)
        if len(combinations) != len(self._names):
            expected = f"{len(self._names)}, as the case has"
            raise InputError([Issue("combinations", f"{len(combinations)} combinations", expected)])
        return self._only_solved(model), {self._names[n]: combinations[n].name for n in self._solved}

    def _only_solved(self, model: Model) -> Model:
        """Return a case with the combinations that are solved; without an ultimate one no reinforcement is designed."""
        combinations = list_combinations(model)
        if len(self._solved) == len(combinations):
            return model
        chosen = tuple(combinations[n] for n in self._solved)
        reinforcement = model.reinforcement if has_ultimate_combination(chosen, None) else None
        return model.replace(combinations=chosen, combine=None, reinforcement=reinforcement)

    def _solver(self) -> tuple[Callable[[Model, dict[str, Any]], Results], Results | None]:
        """Return the function that solves a variant of the case, and the results of the case as it is, if it has any.

        Variants start from these and have no coarser mesh, which the case has.
        """
        from groundslab.analysis.driver import Variants, solve_combinations

        try:
            base = self._only_solved(self._setup.model)
            if self._setup.fields:
                base = base.replace(mesh=base.mesh.replace(symmetry="off"))
            variants = Variants(base)
        except InputError:
            # a case that cannot be solved, as one without any load, may have variants that can
            if self._setup.fields:
                raise
            return lambda model, factors: solve_combinations(model), None  # noqa: ARG005
        return variants.solve_combinations, variants.base


def describe_error(error: BaseException) -> str:
    """Return an error with the name of its kind."""
    return f"{type(error).__name__}: {error}"


def _outcome_of(error: GroundslabError) -> tuple[str, str, str]:
    """Return status, reason and message of an error."""
    status = FOUNDATION_FAILS if isinstance(error, errors.NoEquilibrium) else FAILED
    reason = next((word for kind, word in REASONS.items() if isinstance(error, kind)), type(error).__name__)
    message = str(error)
    return status, reason, message if len(message) <= MAX_MESSAGE_LENGTH else message[: MAX_MESSAGE_LENGTH - 3] + "..."
