"""A comparison of grounds on the terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from groundslab._version import __version__
from groundslab.views.ground_comparison.rows import constant_rows, figure_rows, headings, notes

if TYPE_CHECKING:
    from rich.console import Console

    from groundslab.analysis.ground_comparison.comparison import GroundComparison


def print_comparison(comparison: GroundComparison, console: Console) -> None:
    """Print figures and constants of all grounds side by side, under each figure its difference to the continuum."""
    from rich.padding import Padding
    from rich.table import Table
    from rich.text import Text

    console.print(Text(comparison.model.title or "(no title)", style="bold"), soft_wrap=True)
    console.print(Text(f"groundslab {__version__}", style="dim"))
    table = Table(box=None, padding=(0, 1, 0, 0), pad_edge=False, header_style="bold cyan")
    table.add_column("")
    for heading in headings(comparison):
        table.add_column(heading.replace(" ", "\n"), justify="right")
    table.add_column("", style="dim")
    for row in (*figure_rows(comparison), *constant_rows(comparison)):
        cells = [
            Text(f"{value}\n", end="").append(difference, style="dim") if difference else Text(value)
            for value, difference in row.texts()
        ]
        table.add_row(Text(row.label), *cells, row.unit)
    console.print()
    console.print(table)
    console.print()
    for note in notes(comparison):
        console.print(Padding(Text(note, style="dim"), (0, 0, 0, 2)))
