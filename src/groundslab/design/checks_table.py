"""The table of checks: demand, limit and utilisation of each, where they govern."""

from __future__ import annotations

from groundslab.design.checks import check_design
from groundslab.design.tables.table import Table, table_of
from groundslab.results.results import Results


def checks_table(combined: Results) -> Table:
    """Return all checks of the design, the failures first."""
    heads = [
        ("check", ""), ("of", ""), ("verdict", ""), ("demand", ""), ("limit", ""), ("unit", ""), ("utilisation", ""),
        ("combination", ""), ("x", "m"), ("y", "m"), ("clause", ""), ("in words", ""),
    ]  # fmt: skip
    rows = []
    for check in check_design(combined).checks:
        x, y = check.place or (None, None)
        numbers = check.demand, check.resistance, check.unit or None, check.utilisation
        rows.append([check.name, check.of or None, check.status, *numbers, check.combination or None, x, y,
                     check.clause or None, check.words])  # fmt: skip
    notes = ["The utilisation is demand over limit; of an area in contact, which must not be less, limit over demand."]
    return table_of("checks", "Checks of the design", heads, rows, notes)
