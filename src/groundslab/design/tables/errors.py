"""Discretization errors of the values in tables, each in a column of its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import isfinite

from groundslab.accuracy.values import estimate_error
from groundslab.design.tables.table import Cell, Column, Table
from groundslab.results.fields import POINT_FIELDS
from groundslab.results.results import Results

_QUANTITIES = tuple(about.head[0] for about in POINT_FIELDS.values() if about.head[1] != "deg")
#: The columns whose values have discretization errors, by table. Loads, lengths and directions have none.
VALUES: dict[str, tuple[str, ...]] = {
    "combinations": (
        "largest settlement", "largest uplift", "area in contact", "largest pressure", "largest edge line force",
    ),
    "extremes": ("least", "greatest"),
    "envelope": ("least", "greatest"),
    "tilt": ("mean settlement", "tilt along x", "tilt along y", "tilt", "largest deflection"),
    "points": _QUANTITIES,
    "lines": _QUANTITIES,
    "strips": (
        "moment", "shear", "mean moment", "mean shear", "greatest moment", "least moment",
        "design moment bottom along", "design moment top along", "design moment bottom across",
        "design moment top across",
    ),
    "supports": (
        "force", "least force per length", "greatest force per length", "least settlement", "greatest settlement",
        "moment M_x", "moment M_y",
    ),
    "columns": (
        "settlement", "settlement difference", "angular distortion", "angular distortion without tilt", "V_Ed", "v_Ed",
        "pressure inside", "v_Ed at the face",
    ),
    "reinforcement": ("required area", "design moment"),
}  # fmt: skip
#: Values that are compared only where another column says the same on both meshes.
_ALIKE = {
    "settlement difference": "worst neighbour",
    "angular distortion without tilt": "worst neighbour",
    "design moment": "governed by",
}
#: Values of the largest size, whose signs may differ between both meshes.
_SIZES = {"largest deflection"}


def with_errors(make: Callable[[Results], Table], combined: Results) -> Table:
    """Return a table of all combinations with the errors of its values, each row by the results of its combination."""
    table = make(combined)
    return _with_errors(table, make(_coarser(combined)), table["combination"], combined)


def with_errors_of_extremes(envelope: Table, extremes: Table) -> Table:
    """Return the envelope with the errors of its values: those of the extremes of the combinations that govern."""
    if not any(column.error_of for column in extremes.columns):
        return envelope
    columns = []
    for name in VALUES["envelope"]:
        keys = zip(extremes["combination"], extremes["quantity"], strict=True)
        known = dict(zip(keys, extremes[_name(name)], strict=True))
        governing = zip(envelope[f"combination of the {name}"], envelope["quantity"], strict=True)
        columns.append(Column(_name(name), "", tuple(map(known.get, governing)), error_of=name))
    return replace(envelope, columns=(*envelope.columns, *columns))


def with_errors_of_governing(make: Callable[[Results], Table], combined: Results) -> Table:
    """Return a table whose rows are governed by combinations with errors, by these combinations alone."""
    table, coarser = make(combined), _coarser(combined)
    names = {str(name) for name in table["combination"] if name in coarser.results}
    alone = {name: make(replace(coarser, results={name: coarser.results[name]})).rows() for name in names}
    nothing = (None,) * len(table.columns)
    rows = [alone[str(name)][i] if name in alone else nothing for i, name in enumerate(table["combination"])]
    columns = zip(*rows, strict=True) if rows else [()] * len(table.columns)
    other = [replace(column, values=values) for column, values in zip(table.columns, columns, strict=True)]
    return _with_errors(table, replace(table, columns=tuple(other)), table["combination"], combined)


def _coarser(combined: Results) -> Results:
    """Return the results on elements twice as large; of a combination that has none there, those that it has."""
    return replace(combined, results={name: each.coarser or each for name, each in combined.results.items()})


def _with_errors(table: Table, coarser: Table, combination: Sequence[Cell], combined: Results) -> Table:
    """Return a table with the errors of its values at its right, or as it is where no combination has any.

    The rows of `coarser` are those of the table, as the coarser mesh's fields stand at the same nodes.
    """
    compared = {name: each.comparison for name, each in combined.results.items() if each.comparison is not None}
    if not compared:
        return table
    columns = []
    for column in (each for each in table.columns if each.name in VALUES[table.name]):
        alike = _ALIKE.get(column.name, "combination")
        errors: list[Cell] = []
        rows = column.values, coarser[column.name], table[alike], coarser[alike], combination
        for value, other, one, two, name in zip(*rows, strict=True):
            comparison = compared.get(str(name))
            error = None
            if comparison is not None and one == two and isinstance(value, float) and isinstance(other, float):
                sizes = (abs(value), abs(other)) if column.name in _SIZES else (value, other)
                error = estimate_error(*sizes, comparison) if all(map(isfinite, sizes)) else None
            errors.append(error)
        columns.append(Column(_name(column.name), column.unit, tuple(errors), error_of=column.name))
    return replace(table, columns=(*table.columns, *columns))


def _name(name: str) -> str:
    """Return the name of the column with the errors of another one."""
    return f"error of the {name}" if name in ("least", "greatest") else f"error of {name}"
