"""The table of checks: demand, limit and utilization of each, where they govern."""

from __future__ import annotations

from dataclasses import replace
from math import isfinite
from operator import attrgetter

from groundslab.design.checks import check_design
from groundslab.design.rules.check import DesignCheck
from groundslab.messages import Clause, Message
from groundslab.results.results import Results
from groundslab.views.tables.table import Column, Table, table_of

#: What is said where demands have errors.
HANGS = (
    'A verdict "but within the error" hangs on the discretization error: less or more by it, the demand is on the '
    "other side of the limit."
)
_ERROR = attrgetter("utilization_error")


def checks_table(combined: Results) -> Table:
    """Return all checks of the design, the failures first."""
    heads = [
        ("check", ""), ("of", ""), ("utilization", ""), ("verdict", ""), ("demand", ""), ("limit", ""), ("unit", ""),
        ("combination", ""), ("x", "m"), ("y", "m"), ("clause", ""), ("in words", ""),
    ]  # fmt: skip
    rows = []
    checks = check_design(combined).checks
    for check in checks:
        x, y = check.place or (None, None)
        sizes = check.demand, check.resistance, check.unit or None
        rows.append([check.name, check.of or None, check.utilization, check.verdict, *sizes, check.combination or None,
                     x, y, _clause(check) or None, check.words])  # fmt: skip
    notes = ["The utilization is demand over limit; of an area in contact, which must not be less, limit over demand."]
    table = table_of("checks", "Checks of the design", heads, rows, notes)
    if all(check.error is None for check in checks):
        return table
    of_ratios = [error if error is None or isfinite(error) else None for error in map(_ERROR, checks)]
    errors = {"demand": [check.error for check in checks], "utilization": of_ratios}
    columns = (
        Column(Message("error of {name}", name=name), "", tuple(values), error_of=name)
        for name, values in errors.items()
    )
    return replace(table, columns=(*table.columns, *columns), notes=(*table.notes, HANGS))


def _clause(check: DesignCheck) -> str:
    """Return where a check is ruled."""
    return check.clause if isinstance(check.clause, Message) else Clause(check.clause)
