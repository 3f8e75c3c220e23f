"""A comparison of alternatives on the terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from groundslab.study.alternatives.rows import notes, rows

if TYPE_CHECKING:
    from rich.console import Console

    from groundslab.study.alternatives.comparison import DesignComparison


def print_designs(comparison: DesignComparison, console: Console) -> None:
    """Print quantities and utilizations of all alternatives side by side."""
    from rich.padding import Padding
    from rich.table import Table
    from rich.text import Text

    console.print(Text(comparison.model.title or "(no title)", style="bold"), soft_wrap=True)
    table = Table(box=None, padding=(0, 1, 0, 0), pad_edge=False, header_style="bold cyan")
    table.add_column("", no_wrap=True)
    for alternative in comparison.alternatives:
        table.add_column(alternative.name.replace(", ", ",\n").replace(" ", "\n", 2), justify="right")
    table.add_column("", style="dim")
    for row in rows(comparison):
        cells = (Text(cell, style="bold red" if bad else "") for cell, bad in zip(row.cells, row.bad, strict=True))
        table.add_row(Text(row.label), *cells, row.unit)
    console.print()
    console.print(table)
    console.print()
    for note in notes(comparison):
        console.print(Padding(Text(note, style="dim"), (0, 0, 0, 2)))
