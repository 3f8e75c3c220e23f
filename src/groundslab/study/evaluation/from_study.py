"""Reads the rows of a study into arrays."""

from __future__ import annotations

import numbers
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.schema.fields import Quantity
from groundslab.study.evaluation.samples import PURE, RANDOM, Input, Output, Samples, choose_unit
from groundslab.study.execution.variant import SOLVED

if TYPE_CHECKING:
    from collections.abc import Sequence

    from groundslab.study.definition.outputs import RequestedOutput
    from groundslab.study.definition.setup import Setup, Variable
    from groundslab.study.evaluation.study import Study


def read_samples(study: Study) -> Samples:
    """Return all rows of a study that are there; of one that still runs, those that it has so far."""
    setup = study.setup
    with study.open_rows() as kept:
        names = kept.columns.scalars
        rows = kept.rows(names)
    table = [list(column) for column in zip(*rows, strict=True)] or [[] for _ in names]
    number, status, reason, message, seconds, *columns = table
    own = iter(columns)
    return Samples(
        kind=setup.sampling.kind,
        seed=setup.seed,
        number=np.array(number, dtype=np.int64) - 1,
        reason=tuple(map(_failure_reason, status, reason, message)),
        seconds=np.array(seconds, dtype=float),
        inputs=(
            *(_input(variable, next(own), setup) for variable in setup.variables),
            *(_label(field.name, next(own)) for field in setup.fields),
        ),
        outputs=tuple(_output(each, next(own)) for each in setup.scalar_outputs),
        limits=setup.limits,
        planned=study.count,
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
