"""One variant: the case with its values, solved, and what is kept of it."""

from __future__ import annotations

import hashlib
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.errors import (
    GroundslabError,
    IllConditioned,
    InputError,
    Issue,
    NeutralEquilibrium,
    NoEquilibrium,
    NotCertified,
    NotConverged,
    SingularMatrix,
)
from groundslab.fem.mesh import Mesh
from groundslab.model.combinations import combinations_of
from groundslab.model.loads.load_cases import Combination, has_ultimate
from groundslab.solvers import factorization, pardiso
from groundslab.study.definition import case_paths, outputs
from groundslab.study.sampling import random_fields

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.model.model import Model
    from groundslab.results.results import Combined
    from groundslab.study.definition.outputs import Output
    from groundslab.study.definition.setup import Setup
    from groundslab.study.sampling.designs import Variant

SOLVED, FAILED = "solved", "failed"

#: What a variant can fail for, again and again: the row says so and is not computed anew.
REASONS: dict[type[GroundslabError], str] = {
    InputError: "input",
    IllConditioned: "IllConditioned",
    NeutralEquilibrium: "NeutralEquilibrium",
    NoEquilibrium: "NoEquilibrium",
    NotConverged: "NotConverged",
    NotCertified: "NotCertified",
    SingularMatrix: "SingularMatrix",
}
LONGEST_MESSAGE = 2000  # characters


def key_of(mesh: Mesh) -> str:
    """Return what tells a mesh from others: the SHA-256 of its nodes and elements."""
    nodes, elements = np.ascontiguousarray(mesh.nodes, dtype="<f8"), np.ascontiguousarray(mesh.elements, dtype="<i8")
    return hashlib.sha256(nodes.tobytes() + elements.tobytes()).hexdigest()


@dataclass(frozen=True, eq=False)
class Row:
    """What is kept of a variant; all in SI units. A failed one says why, and has None where there is no result."""

    number: int
    status: str
    reason: str
    message: str
    seconds: float
    inputs: tuple[Any, ...]  # values of the variables, then seeds of the random fields
    results: tuple[float | None, ...]  # in the order of the outputs that are one number
    fields: tuple[Array | None, ...] = ()  # (n,) each, in the order of those that are kept everywhere
    mesh: str = ""  # key of the mesh that the fields are given on
    meshes: tuple[Mesh, ...] = field(default=(), repr=False)  # that mesh, where it is not known yet


class Worker:
    """Solves variants of one study in this process, keeping what they have in common.

    All start from the case as it is, not from one another, so that a row does not depend on those before it.
    """

    def __init__(self, setup: Setup) -> None:
        pardiso.repeatable()
        self._setup = setup
        self._names = tuple(each.name for each in combinations_of(setup.model))
        named = {output.combination for output in setup.outputs}
        #: Combinations of the case that are solved, by their positions.
        self._solved = [n for n, name in enumerate(self._names) if "" in named or name in named]
        self._all = [self._names[n] for n in self._solved]
        self._ultimate = {each.name for each in combinations_of(setup.model) if each.limit_state == "ultimate"}
        # as many threads as there are workers are at work already, and sums of one thread come out the same everywhere
        with factorization.one_thread():
            self._solve = self._solver()

    def row(self, variant: Variant, known_meshes: Sequence[str] = ()) -> Row:
        """Return the row of a variant; errors that lie in the variant are rows too, others are raised."""
        began = time.perf_counter()
        status, reason, message = SOLVED, "", ""
        combined, names = None, dict[str, str]()
        try:
            model, names = self._model(variant.values)
            with factorization.one_thread():
                combined = self._solve(model, self._factors(variant.seeds))
            refused = list(combined.refused.values())
            if refused:
                status, reason, message = FAILED, *_why(refused[0])
        except GroundslabError as error:
            status, reason, message = FAILED, *_why(error)
        numbers, whole = split(self._setup.outputs)
        results: list[float | None] = [None] * len(numbers)
        arrays: list[Array | None] = [None] * len(whole)
        mesh, meshes = "", tuple[Mesh, ...]()
        if combined is not None:
            results = [outputs.figure_of(each, combined, self._wanted(each, names)) for each in numbers]
            arrays = [outputs.whole_of(each, combined, self._wanted(each, names)) for each in whole]
        if combined is not None and any(array is not None for array in arrays):
            plate = next(iter(combined.results.values())).plate
            made = Mesh(plate.nodes, plate.elements)
            mesh = key_of(made)
            meshes = () if mesh in known_meshes else (made,)
        return Row(
            variant.number, status, reason, message, time.perf_counter() - began, (*variant.values, *variant.seeds),
            tuple(results), tuple(arrays), mesh, meshes,
        )  # fmt: skip

    def _wanted(self, output: Output, names: dict[str, str]) -> list[str]:
        """Return the combinations of a variant that an output is of."""
        own = [output.combination] if output.combination else self._all
        return [names[each] for each in own if each in self._ultimate or not output.is_steel]

    def _model(self, values: Sequence[Any]) -> tuple[Model, dict[str, str]]:
        """Return the case with the variables' values, and what its combinations that count are called in it by name.

        Names that EN 1990 makes hold factors, which may vary; then a combination is that of the same position.
        """
        model = model_of(self._setup, values)
        there = combinations_of(model)
        if len(there) != len(self._names):
            expected = f"{len(self._names)}, as the case has"
            raise InputError([Issue("combinations", f"{len(there)} combinations", expected)])
        chosen = [there[n] for n in self._solved]
        if len(chosen) < len(there):
            model = _only(model, chosen)
        return model, {self._names[n]: each.name for n, each in zip(self._solved, chosen, strict=True)}

    def _factors(self, seeds: Sequence[int]) -> dict[str, Any]:
        """Return the random fields of a variant by the constants of the ground that they multiply."""
        return {
            each.path: random_fields.factors(each, seed) for each, seed in zip(self._setup.fields, seeds, strict=True)
        }

    def _solver(self) -> Callable[[Model, dict[str, Any]], Combined]:
        """Return what solves a variant of the case."""
        from groundslab.analysis.driver import Variants, solve_combinations

        base = self._setup.model
        try:
            if len(self._solved) < len(self._names):
                there = combinations_of(base)
                base = _only(base, [there[n] for n in self._solved])
            if self._setup.fields:
                base = base.replace(mesh=base.mesh.replace(symmetry="off"))
            return Variants(base).solve_combinations
        except InputError:
            # a case that cannot be solved, as one without any load, may have variants that can
            if self._setup.fields:
                raise
            return lambda model, factors: solve_combinations(model)  # noqa: ARG005


def _only(model: Model, combinations: Sequence[Combination]) -> Model:
    """Return a model with some of its combinations; without an ultimate one nothing is designed."""
    ultimate = has_ultimate(tuple(combinations), None)
    reinforcement = model.reinforcement if ultimate else None
    return model.replace(combinations=tuple(combinations), combine=None, reinforcement=reinforcement)


def split(kept: Sequence[Output]) -> tuple[list[Output], list[Output]]:
    """Return the outputs that are one number, and those that are whole fields."""
    return [each for each in kept if not each.everywhere], [each for each in kept if each.everywhere]


def model_of(setup: Setup, values: Sequence[Any]) -> Model:
    """Return the case with the variables' values; raises InputError."""
    pairs = zip(setup.variables, values, strict=True)
    return case_paths.changed(setup.model, {variable.place: variable.put(value) for variable, value in pairs})


def _why(error: GroundslabError) -> tuple[str, str]:
    """Return reason and message of a refusal."""
    reason = next((word for kind, word in REASONS.items() if isinstance(error, kind)), type(error).__name__)
    message = str(error)
    return reason, message if len(message) <= LONGEST_MESSAGE else message[: LONGEST_MESSAGE - 3] + "..."
