"""Discretization errors of the values in tables, each in a column of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import repeat
from math import isfinite

from groundslab.accuracy.values import error_of_contact_share, errors_of_extremes, estimate_error
from groundslab.design.codes.registry import CODES
from groundslab.messages import Message
from groundslab.results.fields import LINE_FORCE, POINT_FIELDS, RANGED_FIELDS
from groundslab.results.results import CombinationResult, Results
from groundslab.views.tables.quantities import ranged_fields, ranged_values
from groundslab.views.tables.table import Cell, Column, Table

_QUANTITIES = tuple(about.head[0] for about in POINT_FIELDS.values() if about.head[1] != "deg")
_PUNCHING = (
    "pressure inside",
    "edge line force inside",
    *(name for code in CODES.values() if code.punching is not None for name in code.punching.with_errors),
)
#: The columns whose values have discretization errors, by table. Loads, lengths and directions have none.
VALUES: dict[str, tuple[str, ...]] = {
    "combinations": ("area in contact",),
    "tilt": ("mean settlement", "tilt along x", "tilt along y", "tilt", "largest deflection"),
    "points": _QUANTITIES,
    "soil": ("settlement w", "vertical stress sigma_z"),
    "lines": _QUANTITIES,
    "strips": (
        "moment", "shear", "torsional moment", "mean moment", "mean shear", "greatest moment", "least moment",
        "design moment bottom along", "design moment top along", "design moment bottom across",
        "design moment top across", "moment of beams", "shear of beams",
    ),
    "supports": (
        "force", "least force per length", "greatest force per length", "least settlement", "greatest settlement",
        "moment M_x", "moment M_y",
    ),
    "walls": (
        "settlement at the start", "settlement at the end", "least settlement", "greatest settlement", "deflection",
        "deflection over length",
    ),
    "beams": (
        "greatest moment", "least moment", "largest shear force", "largest torsional moment", "least settlement",
        "greatest settlement", "greatest axial force", "least axial force",
    ),
    "building": (
        "load", "change of load", "change of M_x", "change of M_y", "settlement", "slope along x", "slope along y",
    ),
    "joints": ("force", "greatest force per length", "greatest step"),
    "columns": (
        "settlement", "settlement difference", "angular distortion", "angular distortion without tilt", *_PUNCHING,
    ),
    "pile_punching": ("force", *_PUNCHING),
    "wall_punching": _PUNCHING,
    "zone_punching": ("load", *_PUNCHING),
    "reinforcement": ("required area", "design moment"),
    "support_moments": ("moment at the support", "peak moment"),
    "wall_reinforcement": ("shear force", "share used"),
    "beam_reinforcement": ("required area", "required links", "moment", "shear force", "torsional moment"),
}  # fmt: skip
#: Extremes in the table of combinations: which of which quantity.
EXTREMES = {
    "largest settlement": ("greatest", RANGED_FIELDS["settlement"].label),
    "largest uplift": ("least", RANGED_FIELDS["settlement"].label),
    "largest pressure": ("greatest", RANGED_FIELDS["pressure"].label),
    "largest edge line force": ("greatest", RANGED_FIELDS[LINE_FORCE].label),
}
#: Values that are compared only where another column says the same on both meshes.
_ALIKE = {
    "settlement difference": "worst neighbour",
    "angular distortion without tilt": "worst neighbour",
    "design moment": "governed by",
    "moment at the support": "bars",
    "peak moment": "bars",
}
#: Values of the largest size, whose signs may differ between both meshes.
_SIZES = {"largest deflection", "largest shear force", "largest torsional moment", "shear force", "torsional moment"}


def with_errors(make: Callable[[Results], Table], combined: Results) -> Table:
    """Return a table of all combinations with the errors of its values, each row by the results of its combination."""
    table = make(combined)
    return _with_errors(table, make(_coarser(combined)), table["combination"], combined)


def with_errors_of_extremes(extremes: Table, combined: Results) -> Table:
    """Return the table of extremes with the errors of the least and greatest values, if any result has them."""
    if all(result.comparison is None for result in combined.results.values()):
        return extremes
    errors = {
        (name, label): of_both for name, result in combined.results.items() for label, of_both in _of_extremes(result)
    }
    keys = [*zip(map(str, extremes["combination"]), map(str, extremes["quantity"]), strict=True)]
    columns = [
        Column(_name(name), "", tuple(errors[key][n] for key in keys), error_of=name)
        for n, name in enumerate(("least", "greatest"))
    ]
    return replace(extremes, columns=(*extremes.columns, *columns))


def _of_extremes(results: CombinationResult) -> Iterator[tuple[str, tuple[float, float] | tuple[None, None]]]:
    """Yield the label of each quantity that has extremes, and the errors of its least and its greatest value."""
    fields = ranged_fields(results)
    if results.coarser is None or results.comparison is None:
        yield from ((about.label, (None, None)) for about, _, _ in fields)
        return
    values, coarser = ranged_values(results), ranged_values(results.coarser)
    for about, name, where in fields:
        yield about.label, errors_of_extremes(results, name, values[name][where], coarser[name][where], where)


def with_errors_of_envelope(envelope: Table, extremes: Table) -> Table:
    """Return the envelope with the errors of its values: those of the extremes of the combinations that govern."""
    columns = {}
    for name in ("least", "greatest"):
        columns[name] = zip(
            envelope[Message("combination of the {name}", name=name)], envelope["quantity"], repeat(name)
        )
    return _with_known(envelope, extremes, columns)


def with_errors_of_figures(combinations: Table, extremes: Table) -> Table:
    """Return the table of combinations with the errors of the extremes in it."""
    columns = {}
    for name, (which, quantity) in EXTREMES.items():
        named = zip(combinations["combination"], combinations[name], strict=True)
        governing = [combination if value else None for combination, value in named]
        columns[name] = zip(governing, repeat(quantity), repeat(which))
    return _with_known(combinations, extremes, columns)


def _with_known(table: Table, extremes: Table, columns: Mapping[str, Iterable[tuple[Cell, Cell, str]]]) -> Table:
    """Return a table with the errors of some columns: those of combination, quantity and extreme, row by row."""
    if not any(column.error_of for column in extremes.columns):
        return table
    keys = [*zip(extremes["combination"], extremes["quantity"], strict=True)]
    by_extreme = {
        (*key, name): error
        for name in ("least", "greatest")
        for key, error in zip(keys, extremes[_name(name)], strict=True)
    }
    unit = {column.name: column.unit for column in table.columns}
    errors = [
        Column(_name(name), unit[name], tuple(map(by_extreme.get, rows)), error_of=name)
        for name, rows in columns.items()
    ]
    return replace(table, columns=(*table.columns, *errors))


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
    return replace(combined, results={name: result.coarser or result for name, result in combined.results.items()})


def _with_errors(table: Table, coarser: Table, combination: Sequence[Cell], combined: Results) -> Table:
    """Return a table with the errors of its values at its right, or as it is where no combination has any.

    The rows of `coarser` are those of the table, as the coarser mesh's fields stand at the same nodes.
    """
    compared = {name: result.comparison for name, result in combined.results.items() if result.comparison is not None}
    if not compared:
        return table
    columns = []
    for column in (column for column in table.columns if column.name in VALUES[table.name]):
        alike = _ALIKE.get(column.name, "combination")
        errors: list[Cell] = []
        rows = column.values, coarser[column.name], table[alike], coarser[alike], combination
        for value, other, fine, rough, name in zip(*rows, strict=True):
            comparison = compared.get(str(name))
            error = None
            if column.name == "area in contact":
                share = error_of_contact_share(combined.results[str(name)]) if comparison is not None else None
                error = None if share is None else 100 * share
            elif comparison is not None and fine == rough and isinstance(value, float) and isinstance(other, float):
                sizes = (abs(value), abs(other)) if column.name in _SIZES else (value, other)
                error = estimate_error(*sizes, comparison) if all(map(isfinite, sizes)) else None
            errors.append(error)
        columns.append(Column(_name(column.name), column.unit, tuple(errors), error_of=column.name))
    return replace(table, columns=(*table.columns, *columns))


def _name(name: str) -> str:
    """Return the name of the column with the errors of another one."""
    return (
        Message("error of the {name}", name=name)
        if name in ("least", "greatest")
        else Message("error of {name}", name=name)
    )
