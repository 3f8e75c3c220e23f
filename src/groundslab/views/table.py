"""The summary and the convergence history on the terminal, readable at 80 columns."""

from __future__ import annotations

import math
import textwrap
from typing import TYPE_CHECKING

from groundslab import __version__
from groundslab.views.summary import Row, summary

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console
    from rich.text import Text

    from groundslab.results import Results, Step

#: Widths of the columns of words and of values; unit and place follow, 78 in all.
LABEL, VALUE = 36, 12


def print_summary(results: Results, console: Console) -> None:
    """Print everything that ``summary`` returns, the convergence history and the verdict."""
    from rich.padding import Padding
    from rich.text import Text

    sections = summary(results)
    console.print(Text(results.model.title or "(no title)", style="bold"))
    console.print(Text(f"groundslab {__version__}", style="dim"))
    for section in sections:
        console.print()
        console.print(Text(section.title, style="bold cyan"))
        for row in section.rows:
            console.print(_line(row), soft_wrap=True)
        for note in section.notes:
            console.print(Padding(Text(note, style="dim"), (0, 2)))
    console.print()
    print_history(results.steps, console)
    console.print()
    if results.certificate.holds:
        console.print(Text("The result fulfils the equations.", style="bold green"))
    else:
        console.print(Text("FAILED: the result does not fulfil the equations; do not use it.", style="bold red"))


def print_history(steps: Sequence[Step], console: Console) -> None:
    """Print one line for each step of the iteration; steps on the mesh that was asked for carry a star."""
    from rich.padding import Padding
    from rich.table import Table
    from rich.text import Text

    console.print(Text("Convergence history", style="bold cyan"))
    table = Table(box=None, padding=(0, 2, 0, 0), pad_edge=False, header_style="dim")
    for heading in (
        "mesh\nunknowns",
        "load\nincrement",
        "\ngamma",
        "contact\niteration",
        "nodes in\ncontact",
    ):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("nodes\nchanged", justify="right", no_wrap=True)
    table.add_column("", no_wrap=True)
    for step in steps:
        gamma = "-" if step.gamma is None else number(step.gamma)
        counts = (step.iteration, step.in_contact, step.changed)
        cells = (
            str(step.unknowns),
            str(step.increment),
            gamma,
            *map(str, counts),
            "*" if step.finest else "",
        )
        table.add_row(*(Text(cell) for cell in cells))
    console.print(Padding(table, (0, 0, 0, 2)))
    if any(step.finest for step in steps):
        console.print(Text("  * on the mesh that was asked for", style="dim"))


def number(value: float) -> str:
    """Return a number with five significant digits, without an exponent where that is readable."""
    if value == 0:
        return "0"
    if not 1e-3 <= abs(value) < 1e7:
        return f"{value:.4e}"
    decimals = max(0, 4 - math.floor(math.log10(abs(value))))
    return f"{value:.{decimals}f}"


def _line(row: Row) -> Text:
    """Return a row of the summary as one line; long words wrap under themselves."""
    from rich.text import Text

    symbol = "" if row.symbol in row.label else f" {row.symbol}"
    line = Text("  " + (row.label + symbol).ljust(LABEL))
    if row.ok is not None:
        line.append(f"{row.value:{VALUE}.1e} ")
        line.append("ok" if row.ok else "FAILED", style="green" if row.ok else "bold red")
        line.append(f" (limit {row.tolerance:.0e})", style="dim")
    elif isinstance(row.value, str):
        pieces = textwrap.wrap(row.value, 78 - LABEL - 2)
        line.append(row.value.rjust(VALUE) if len(row.value) <= VALUE else f"\n{' ' * (LABEL + 2)}".join(pieces))
    else:
        scale, shown = (1.0, "") if row.unit is None else (row.unit.scale, row.unit.shown)
        figure = str(row.value) if isinstance(row.value, int) else number(row.value * scale)
        place = "" if row.place is None else "at ({:.3f}, {:.3f})".format(*(round(x, 3) + 0.0 for x in row.place))
        line.append(f"{figure:>{VALUE}} {shown:<6} {place}".rstrip())
    return line
