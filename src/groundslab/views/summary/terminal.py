"""The summary and the convergence history on the terminal, readable at 80 columns."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from groundslab._version import __version__
from groundslab.results.results import alone
from groundslab.units import format_number
from groundslab.views.summary import combinations
from groundslab.views.summary.single import Row, SummarySection, certified_words, summary

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from rich.console import Console
    from rich.text import Text

    from groundslab.design.tables.design_checks import Design, Status
    from groundslab.results.record import Step
    from groundslab.results.results import Combined, Results
    from groundslab.views.summary.combinations import Entry, Extreme

#: Widths of the columns of words and of values; unit and place follow, 78 in all.
LABEL, VALUE = 36, 12


def print_summary(results: Results, console: Console) -> None:
    """Print everything that ``summary`` returns, the convergence history and the verdict."""
    from rich.text import Text

    from groundslab.design.tables.design_checks import design_of

    sections, design = summary(results), design_of(alone(results))
    _head(results.model.title, design, console)
    console.print(Text(f"{results.combination} ({results.limit_state})", style="dim"))
    for section in sections:
        _section(section, [_line(row) for row in section.rows], console)
    console.print()
    print_history(results.steps, console)
    console.print()
    if results.certificate.holds:
        _certified(1, design, console)
    else:
        console.print(Text("FAILED: the certificate does not hold; do not use the result.", style="bold red"))


def print_overview(combined: Combined, console: Console) -> None:
    """Print what all combinations have in common, each on its lines, the extremes over all, and the verdict."""
    from rich.text import Text

    from groundslab.design.tables.design_checks import design_of

    combinations.require_finite(combined)
    design = design_of(combined)
    _head(combined.model.title, design, console)
    for section in combinations.description(combined):
        _section(section, [_line(row) for row in section.rows], console)
    found = combinations.entries(combined)
    console.print()
    console.print(Text("Combinations", style="bold cyan"))
    for heading in (("load", "settlement", "uplift", "contact", "iteration"), ("kN", "mm", "mm", "%", "steps")):
        console.print(Text("   " + "".join(f"{word:>12}" for word in heading), style="dim"))
    for entry in found:
        for line in _entry(entry):
            console.print(line, soft_wrap=True)
    for section, rows in combinations.extremes(combined):
        _section(replace(section, title=f"{section.title}: extremes"), [_extreme(row) for row in rows], console)
    worst = SummarySection("certificate", "Certificate: the worst of each figure", ())
    _section(worst, [_extreme(row) for row in combinations.worst(combined)], console)
    console.print(Text("  The number before each line is that of the combination that governs.", style="dim"))
    console.print()
    if not combined.refused:
        _certified(len(found), design, console)
        return
    numbers = ", ".join(str(entry.number) for entry in found if entry.refused is not None)
    words = f"FAILED: {len(combined.refused)} of {len(found)} combinations have no certified result: {numbers}."
    console.print(Text(words, style="bold red"), soft_wrap=True)


def _entry(entry: Entry) -> Iterator[Text]:
    """Yield the lines of one combination: name and factors, figures, and why it is refused."""
    from rich.text import Text

    about = (
        f"{entry.combination.name} ({entry.combination.limit_state}): {combinations.factors_text(entry.combination)}"
    )
    name, *more = textwrap.wrap(about, 74)
    yield Text(f"{entry.number:>3} {name}", style="bold")
    yield from (Text(f"    {line}", style="bold") for line in more)
    if entry.results is not None:
        f = combinations.figures(entry.results)
        figures = (f.load / 1e3, f.settlement * 1e3, f.uplift * 1e3, f.contact * 100)
        line = Text("   " + "".join(f"{value:>12}" for value in (*map(format_number, figures), f.iterations)))
        if entry.refused is None:
            line.append("  ok", style="green")
        yield line
    if entry.refused is not None:
        reason = " ".join(str(entry.refused).split())
        shown = textwrap.wrap(f"REFUSED: {reason}", 74, max_lines=6, placeholder=" ...")
        yield from (Text(f"    {line}", style="bold red") for line in shown)


def _extreme(extreme: Extreme) -> Text:
    """Return a row as one line that begins with the number of its combination."""
    from rich.text import Text

    return Text(f"{extreme.number:>2} ") + _line(extreme.row, 1)


def _head(title: str, design: Design, console: Console) -> None:
    """Print the title, who says it, and what fails in the design."""
    from rich.text import Text

    console.print(Text(title or "(no title)", style="bold"))
    console.print(Text(f"groundslab {__version__}", style="dim"))
    for line in textwrap.wrap(design.headline, 78):
        console.print(Text(line, style=_STYLES[design.status]), soft_wrap=True)
    for check in design.open:
        for line in textwrap.wrap(f"- {check.name}: {check.words}", 76, subsequent_indent="  "):
            console.print(Text(f"  {line}", style=_STYLES[check.status]), soft_wrap=True)


_STYLES: dict[Status, str] = {
    "fails": "bold red", "attention": "bold yellow", "no failure found": "dim", "not checked": "dim",
}  # fmt: skip


def _certified(count: int, design: Design, console: Console) -> None:
    """Print what the certificate of so many results says, and again what fails in the design."""
    from rich.text import Text

    for line in textwrap.wrap(certified_words(count), 78):
        console.print(Text(line, style="green"), soft_wrap=True)
    if design.open:
        for line in textwrap.wrap(f"{design.headline} See the first lines.", 78):
            console.print(Text(line, style=_STYLES[design.status]), soft_wrap=True)


def _section(section: SummarySection, lines: Sequence[Text], console: Console) -> None:
    """Print lines under their heading, and the notes below."""
    from rich.padding import Padding
    from rich.text import Text

    console.print()
    console.print(Text(section.title, style="bold cyan"))
    for line in lines:
        console.print(line, soft_wrap=True)
    for note in section.notes:
        console.print(Padding(Text(note, style="dim"), (0, 2)))


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
        gamma = "-" if step.gamma is None else format_number(step.gamma)
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


def _line(row: Row, taken: int = 0) -> Text:
    """Return a row of the summary as one line; long words wrap under themselves. So many columns are taken before."""
    from rich.text import Text

    symbol = f" {row.symbol}" if row.symbol else ""
    line = Text(("" if taken else "  ") + (row.label + symbol).ljust(LABEL - taken))
    shown = shown_row(row)
    if row.ok is not None:
        line.append(f"{shown.figure:>{VALUE}} ")
        line.append("ok" if row.ok else "FAILED", style="green" if row.ok else "bold red")
        line.append(f" (limit {row.tolerance:.0e})", style="dim")
    elif isinstance(row.value, str):
        pieces = textwrap.wrap(row.value, 78 - LABEL - 2)
        line.append(row.value.rjust(VALUE) if len(row.value) <= VALUE else f"\n{' ' * (LABEL + 2)}".join(pieces))
    else:
        place = f"at {shown.place}" if shown.place else ""
        line.append(f"{shown.figure:>{VALUE}} {shown.unit:<6} {place}".rstrip())
    return line


@dataclass(frozen=True, slots=True)
class Shown:
    """A row of the summary as text: figure or words, unit of display, place [m]."""

    figure: str
    unit: str = ""
    place: str = ""


def shown_row(row: Row) -> Shown:
    """Return the texts of a row: figures that must vanish with two digits, others with five, places to a millimetre."""
    if isinstance(row.value, str):
        return Shown(row.value)
    if row.ok is not None:
        return Shown(f"{row.value:.1e}")
    scale, unit = (1.0, "") if row.unit is None else (row.unit.scale, row.unit.name)
    figure = str(row.value) if isinstance(row.value, int) else format_number(row.value * scale)
    place = "" if row.place is None else "({:.3f}, {:.3f})".format(*(round(x, 3) + 0.0 for x in row.place))
    return Shown(figure, unit, place)
