"""The variants of a study as arrays, read from its rows: inputs, outputs, limit states, grouped by design."""

from __future__ import annotations

import numbers
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.schema.fields import Quantity
from groundslab.study.execution.variant import SOLVED, WITHOUT_EQUILIBRIUM
from groundslab.units import DIMENSIONS, Unit

if TYPE_CHECKING:
    from groundslab.arrays import Array, Flags, Integers
    from groundslab.study.definition.outputs import RequestedOutput
    from groundslab.study.definition.setup import Limit, Setup, Variable
    from groundslab.study.evaluation.study import Study

#: Kinds of sampling whose variants follow the distributions of the inputs.
RANDOM = ("monte carlo", "latin hypercube", "sobol", "saltelli")

PURE = Unit("", "", 1.0)


@dataclass(frozen=True, slots=True)
class Input:
    """A quantity that varies: by chance, with a density over values in SI if it has one, or by choice of the designer.

    What is not a number (a word, a list, a random field) has labels; its values are their numbers.
    """

    name: str
    unit: Unit
    values: Array  # (n,), SI
    density: Callable[[Array], Array] | None = None
    chosen: bool = False
    labels: tuple[str, ...] = ()  # (n,)

    def cell(self, row: int) -> str | float:
        """Return the value of a variant in the unit of display, or its label."""
        return self.labels[row] if self.labels else float(self.values[row] * self.unit.scale)

    def text(self, row: int) -> str:
        """Return the value of a variant with its unit, "200 mm", or its label."""
        return self.labels[row] if self.labels else show_value(self.values[row], self.unit)


@dataclass(frozen=True, slots=True)
class Output:
    """A result of each variant, nan where there is none; infinite where no finite one suffices, as of reinforcement."""

    name: str
    unit: Unit
    values: Array  # (n,), SI


@dataclass(frozen=True, slots=True)
class Group:
    """The variants of one design: their rows, and what the designer chose."""

    label: str
    rows: Integers
    chosen: tuple[tuple[str, float], ...]  # input and its value, SI


@dataclass(frozen=True)
class Samples:
    """All variants of a study as arrays of one length n, in the order of their numbers."""

    kind: str
    seed: int
    number: Integers  # from 0
    reason: tuple[str, ...]  # why there is no result, empty where there is one
    seconds: Array
    inputs: tuple[Input, ...]
    outputs: tuple[Output, ...]
    limits: tuple[Limit, ...]
    planned: int
    #: By output its value in the case as it is and the discretization error of that, SI.
    errors: Mapping[str, tuple[float, float]] = field(default_factory=dict)

    @property
    def solved(self) -> Flags:
        """Which variants have a result, (n,)."""
        return np.array([not why for why in self.reason], dtype=bool)

    @cached_property
    def collapsed(self) -> Flags:
        """Which variants (n,) have no equilibrium: their foundation fails."""
        return np.array([why.partition(":")[0] in WITHOUT_EQUILIBRIUM for why in self.reason], dtype=bool)

    @property
    def random(self) -> bool:
        """Whether shares of the variants are estimates of probabilities."""
        return self.kind in RANDOM

    @property
    def varied(self) -> tuple[Input, ...]:
        """The inputs that are numbers and vary by chance, or are listed."""
        return tuple(entry for entry in self.inputs if not entry.chosen and not entry.labels)

    @property
    def base(self) -> int:
        """How many variants make A, and B, and each mixture of Saltelli's sample."""
        return self.planned // (len(self.inputs) + 2)

    @cached_property
    def by_chance(self) -> Flags:
        """Which rows (n,) follow the inputs' distributions: of Saltelli's sample A and B, else all."""
        if self.kind != "saltelli":
            return np.ones(len(self.number), dtype=bool)
        return self.number < 2 * self.base

    def mixed(self, output: Output) -> tuple[Array, Array, Array]:
        """Return A and B (base,) and their mixtures AB (d, base) of an output of Saltelli's sample; nan is missing."""
        y = np.full(self.planned, np.nan)
        y[self.number] = output.values
        A, B, *AB = y.reshape(-1, self.base)
        return A, B, np.array(AB)

    @cached_property
    def groups(self) -> tuple[Group, ...]:
        """The designs in rising order of what was chosen; one without a label if nothing was."""
        chosen = [entry for entry in self.inputs if entry.chosen]
        every = np.arange(len(self.number))
        if not chosen:
            return (Group("", every, ()),)
        table = np.column_stack([entry.values for entry in chosen])
        designs, which = np.unique(table, axis=0, return_inverse=True)
        groups = []
        for number, design in enumerate(designs):
            pairs = tuple((entry.name, float(value)) for entry, value in zip(chosen, design, strict=True))
            rows = every[which.ravel() == number]
            label = ", ".join(f"{entry.name} = {entry.text(int(rows[0]))}" for entry in chosen)
            groups.append(Group(label, rows, pairs))
        return tuple(groups)

    def falls(self, output: Output) -> bool:
        """Whether low values of an output are the bad ones: all its limit states say at least."""
        senses = {limit.sense for limit in self.limits if limit.output == output.name}
        return senses == {"at least"}

    def output(self, name: str) -> Output:
        """Return the output of a name; KeyError if there is none."""
        return {output.name: output for output in self.outputs}[name]

    def there(self, output: Output, group: Group, least: bool | None = None) -> Array:
        """Return the values of an output in one design that follow the inputs' distributions and are not missing.

        Where the foundation fails the output is infinite, on the bad side: below if low values are the bad ones, as
        `least` or the limit states say.
        """
        rows = group.rows[self.by_chance[group.rows]]
        bad = -np.inf if (self.falls(output) if least is None else least) else np.inf
        values = np.where(self.collapsed[rows] & np.isnan(output.values[rows]), bad, output.values[rows])
        return values[~np.isnan(values)]

    def of(self, output: Output, group: Group) -> Array:
        """Return the finite ones of these values."""
        values = self.there(output, group)
        return values[np.isfinite(values)]


def show_value(value: float, unit: Unit, digits: int = 6) -> str:
    """Return a value (SI) with its unit of display: "25 mm"."""
    return f"{value * unit.scale:.{digits}g} {unit.name}".rstrip()


def condition(limit: Limit, output: Output) -> str:
    """Return a limit state in words: "largest settlement at most 25 mm"."""
    return f"{limit.output} {limit.sense} {show_value(limit.bound, output.unit)}"


def choose_unit(dimension: str | None, values: Array) -> Unit:
    """Return a fitting unit of display for values in SI of one dimension; none for pure numbers."""
    if not dimension:
        return PURE
    quantity = DIMENSIONS[dimension]
    finite = np.abs(values[np.isfinite(values)])
    size = float(np.median(finite)) if len(finite) else 0.0
    scale, name = next((step for step in reversed(quantity.steps) if size >= step[0]), quantity.steps[0])
    return Unit(name, quantity.si, 1 / scale)


def read_samples(study: Study) -> Samples:
    """Return all rows of a study that are there; of one that still runs, those that it has so far."""
    setup = study.setup
    with study.open_rows() as kept:
        names = kept.columns.scalars
        rows = kept.rows(names)
        errors = kept.discretization()
    table = [list(column) for column in zip(*rows, strict=True)] or [[] for _ in names]
    number, status, reason, message, seconds, *columns = table
    remaining = iter(columns)
    return Samples(
        kind=setup.sampling.kind,
        seed=setup.seed,
        number=np.array(number, dtype=np.int64) - 1,
        reason=tuple(map(_failure_reason, status, reason, message)),
        seconds=np.array(seconds, dtype=float),
        inputs=(
            *(_input(variable, next(remaining), setup) for variable in setup.variables),
            *(_label(field.name, next(remaining)) for field in setup.fields),
        ),
        outputs=tuple(_output(output, next(remaining)) for output in setup.scalar_outputs),
        limits=setup.limits,
        planned=study.count,
        errors=errors,
    )


def _failure_reason(status: str, reason: str, message: str) -> str:
    """Return why a variant has no result, empty if it has one: the reason and the first line of the message."""
    if status == SOLVED:
        return ""
    return ": ".join(filter(None, (reason, message.partition("\n")[0]))) or status


def _input(variable: Variable, values: Sequence[Any], setup: Setup) -> Input:
    """Return a variable with its values."""
    if any(isinstance(value, bool) or not isinstance(value, numbers.Real) for value in values):
        return _label(variable.name, values, variable.chosen)
    key, numeric = variable.place.key, np.array(values, dtype=float)
    dimension = key.dimension if isinstance(key, Quantity) and not variable.times else None
    density = None
    if variable.distribution is not None and setup.sampling.kind in RANDOM:
        density = variable.distribution.pdf
    return Input(variable.name, choose_unit(dimension, numeric), numeric, density, variable.chosen)


def _label(name: str, values: Sequence[Any], chosen: bool = False) -> Input:
    """Return an input that is not a number, numbered in the order in which its values first occur."""
    labels = tuple(map(str, values))
    number = {label: place for place, label in enumerate(dict.fromkeys(labels))}
    return Input(name, PURE, np.array([number[label] for label in labels], dtype=float), None, chosen, labels)


def _output(output: RequestedOutput, values: Sequence[float | None]) -> Output:
    """Return an output with its values; what is missing is nan."""
    numeric = np.array(values, dtype=float)  # None becomes nan
    return Output(output.name, choose_unit(output.dimension, numeric), numeric)
