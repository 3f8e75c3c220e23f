"""One variant: the case with its values, solved, and what is kept of it."""

from __future__ import annotations

import hashlib
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.errors import (
    GroundslabError,
    InputError,
    NoEquilibrium,
    NotCertified,
    NotConverged,
    SingularMatrix,
)
from groundslab.loadcases import combinations_of
from groundslab.mesh import Mesh
from groundslab.study import fields, outputs, paths

if TYPE_CHECKING:
    from groundslab.model import Model
    from groundslab.results import Combined
    from groundslab.shape import Array
    from groundslab.study.outputs import Output
    from groundslab.study.sampling import Variant
    from groundslab.study.setup import Setup

SOLVED, FAILED = "solved", "failed"

#: What a variant can fail for, again and again: the row says so and is not computed anew.
REASONS: dict[type[GroundslabError], str] = {
    InputError: "input",
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
    """Solves variants of one study in this process, keeping what they have in common."""

    def __init__(self, setup: Setup) -> None:
        self._setup = setup
        self._solve = _solver()

    def row(self, variant: Variant, known_meshes: Sequence[str] = ()) -> Row:
        """Return the row of a variant; errors that lie in the variant are rows too, others are raised."""
        began = time.perf_counter()
        setup = self._setup
        numbers, whole = split(setup.outputs)
        status, reason, message = SOLVED, "", ""
        combined, names = None, tuple[str, ...]()
        try:
            combined, names = self._solved(variant)
            refused = [combined.refused[name] for name in names if name in combined.refused]
            if refused:
                status, reason, message = FAILED, *_why(refused[0])
        except InputError as error:
            status, reason, message = FAILED, *_why(error)
        results: list[float | None] = [None] * len(numbers)
        arrays: list[Array | None] = [None] * len(whole)
        mesh, meshes = "", tuple[Mesh, ...]()
        if combined is not None:
            of = {output.name: _wanted(output, names) for output in setup.outputs}
            results = [outputs.taken(output, combined, of[output.name]) for output in numbers]  # type: ignore[misc]
            arrays = [outputs.taken(output, combined, of[output.name]) for output in whole]  # type: ignore[misc]
            if any(array is not None for array in arrays):
                plate = next(iter(combined.results.values())).plate
                made = Mesh(plate.nodes, plate.elements)
                mesh = key_of(made)
                meshes = () if mesh in known_meshes else (made,)
        return Row(
            variant.number, status, reason, message, time.perf_counter() - began, (*variant.values, *variant.seeds),
            tuple(results), tuple(arrays), mesh, meshes,
        )  # fmt: skip

    def _solved(self, variant: Variant) -> tuple[Combined, tuple[str, ...]]:
        """Return the results of a variant, and the names of the combinations that count, in the base case's order."""
        setup = self._setup
        model = model_of(setup, variant.values)
        over_plan = {
            each.path: fields.factors(each, seed) for each, seed in zip(setup.fields, variant.seeds, strict=True)
        }
        return self._solve(model, over_plan)


def split(kept: Sequence[Output]) -> tuple[list[Output], list[Output]]:
    """Return the outputs that are one number, and those that are whole fields."""
    return [each for each in kept if not each.everywhere], [each for each in kept if each.everywhere]


def model_of(setup: Setup, values: Sequence[Any]) -> Model:
    """Return the case with the variables' values; raises InputError."""
    pairs = zip(setup.variables, values, strict=True)
    return paths.changed(setup.model, {variable.place: variable.put(value) for variable, value in pairs})


Solve = Callable[["Model", Mapping[str, Any]], tuple["Combined", tuple[str, ...]]]


def _solver() -> Solve:
    """Return what solves a variant of the case."""
    from groundslab.analysis import solve_combinations

    def solve(model: Model, over_plan: Mapping[str, Any]) -> tuple[Combined, tuple[str, ...]]:
        if over_plan:
            raise GroundslabError("random fields cannot be solved yet")
        return solve_combinations(model), tuple(each.name for each in combinations_of(model))

    return solve


def _wanted(output: Output, names: tuple[str, ...]) -> tuple[str, ...]:
    """Return the combinations that an output is of."""
    return (output.combination,) if output.combination else names


def _why(error: GroundslabError) -> tuple[str, str]:
    """Return reason and message of a refusal."""
    reason = next((word for kind, word in REASONS.items() if isinstance(error, kind)), type(error).__name__)
    message = str(error)
    return reason, message if len(message) <= LONGEST_MESSAGE else message[: LONGEST_MESSAGE - 3] + "..."
