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
    for each in check_design(combined).checks:
        x, y = each.place or (None, None)
        numbers = each.demand, each.resistance, each.unit or None, each.utilisation
        rows.append([each.name, each.of or None, each.status, *numbers, each.combination or None, x, y,
                     each.clause or None, each.words])  # fmt: skip
    notes = ["The utilisation is demand over limit; of an area in contact, which must not be less, limit over demand."]
    return table_of("checks", "Checks of the design", heads, rows, notes)
