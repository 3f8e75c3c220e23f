"""The rows of a study as arrays: what went in, what came out, what must not happen, in groups of one design each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Literal

import numpy as np

from groundslab import units

if TYPE_CHECKING:
    from groundslab.arrays import Array, Flags, Integers

#: Kinds of sampling whose variants follow the distributions of the inputs.
RANDOM = ("monte carlo", "latin hypercube", "sobol", "saltelli")


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit of display and the factor from SI to it; no name for pure numbers."""

    name: str
    scale: float


PURE = Unit("", 1.0)


@dataclass(frozen=True, slots=True)
class Input:
    """A quantity that varies: by chance, with a density over values in SI if it has one, or by choice of the designer.

    What is no number (a word, a list, a random field) has labels, and its values count through them.
    """

    name: str
    unit: Unit
    values: Array  # (n,), SI
    density: Callable[[Array], Array] | None = None
    chosen: bool = False
    labels: tuple[str, ...] = ()  # (n,)

    def shown(self, row: int) -> str | float:
        """Return the value of a variant in the unit of display, or its label."""
        return self.labels[row] if self.labels else float(self.values[row] * self.unit.scale)


@dataclass(frozen=True, slots=True)
class Output:
    """A figure of each variant, nan where there is none; infinite where no finite one would do, as of reinforcement."""

    name: str
    unit: Unit
    values: Array  # (n,), SI


@dataclass(frozen=True, slots=True)
class Limit:
    """A limit state: an output that must be at most, or at least, a bound (SI); the probability aimed at, if any."""

    name: str
    output: str
    sense: Literal["at most", "at least"]
    bound: float
    target: float | None = None

    def fails(self, values: Array) -> Flags:
        """Return which values (n,) are beyond the bound; a missing one is not."""
        beyond: Flags = values > self.bound if self.sense == "at most" else values < self.bound
        return beyond

    def margin(self, value: float) -> float:
        """Return how far a value is on the safe side, negative where it fails."""
        return self.bound - value if self.sense == "at most" else value - self.bound


@dataclass(frozen=True, slots=True)
class Group:
    """The variants of one design: which rows they are, and what the designer chose."""

    label: str
    rows: Integers
    chosen: tuple[tuple[str, float], ...]  # input and its value, SI


@dataclass(frozen=True)
class Gathered:
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

    @property
    def solved(self) -> Flags:
        """Which variants have a result, (n,)."""
        return np.array([not why for why in self.reason], dtype=bool)

    @property
    def random(self) -> bool:
        """Whether shares of the variants are estimates of probabilities."""
        return self.kind in RANDOM

    @property
    def varied(self) -> tuple[Input, ...]:
        """The inputs that are numbers and vary by chance, or are listed."""
        return tuple(each for each in self.inputs if not each.chosen and not each.labels)

    @property
    def base(self) -> int:
        """How many variants make A, and B, and each mixture of Saltelli's sample."""
        return self.planned // (len(self.inputs) + 2)

    @cached_property
    def drawn(self) -> Flags:
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
        chosen = [each for each in self.inputs if each.chosen]
        every = np.arange(len(self.number))
        if not chosen:
            return (Group("", every, ()),)
        table = np.column_stack([each.values for each in chosen])
        designs, which = np.unique(table, axis=0, return_inverse=True)
        found = []
        for number, design in enumerate(designs):
            pairs = tuple((each.name, float(value)) for each, value in zip(chosen, design, strict=True))
            rows = every[which.ravel() == number]
            found.append(
                Group(", ".join(f"{each.name} = {_words(each, int(rows[0]))}" for each in chosen), rows, pairs)
            )
        return tuple(found)

    def falls(self, output: Output) -> bool:
        """Whether low values of an output are the bad ones: all its limit states say at least."""
        senses = {limit.sense for limit in self.limits if limit.output == output.name}
        return senses == {"at least"}

    def output(self, name: str) -> Output:
        """Return the output of a name; KeyError if there is none."""
        for each in self.outputs:
            if each.name == name:
                return each
        raise KeyError(name)

    def there(self, output: Output, group: Group) -> Array:
        """Return the values of an output that follow the inputs' distributions and are there, in one design."""
        values = output.values[group.rows[self.drawn[group.rows]]]
        return values[~np.isnan(values)]

    def of(self, output: Output, group: Group) -> Array:
        """Return those of them that are finite."""
        values = self.there(output, group)
        return values[np.isfinite(values)]


def _words(each: Input, row: int) -> str:
    """Return the value of a variant with its unit: "200 mm"."""
    shown = each.shown(row)
    return shown if isinstance(shown, str) else f"{shown:.6g} {each.unit.name}".rstrip()


def unit_for(dimension: str | None, values: Array) -> Unit:
    """Return a fitting unit of display for values in SI of one dimension; none for pure numbers."""
    if dimension is None:
        return PURE
    steps = units.DIMENSIONS[dimension].steps
    finite = values[np.isfinite(values)]
    size = float(np.median(np.abs(finite))) if len(finite) else 0.0
    fitting = [step for step in steps if size >= step[0]] or list(steps[:1])
    scale, name = fitting[-1]
    return Unit(name, 1 / scale)
