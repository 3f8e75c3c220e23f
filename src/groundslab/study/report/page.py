"""One page of a study: all that it tells, in one file that needs no other and no network."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.study.evaluation import tables as evaluation
from groundslab.study.evaluation.statistics import LEVEL
from groundslab.study.report import figures
from groundslab.units import format_number
from groundslab.views.report.html import render_page
from groundslab.views.report.table_layout import Cell, TableHeader, TableLayout, headers
from groundslab.views.summary.terminal import error_text

if TYPE_CHECKING:
    from groundslab.arrays import Array, Integers
    from groundslab.study.evaluation.form import Reliability
    from groundslab.study.evaluation.samples import Samples
    from groundslab.units import Unit
    from groundslab.views.tables.table import Cell as RawCell
    from groundslab.views.tables.table import Table

HERE = Path(__file__).parent
#: Of a longer table the page shows the first rows, the CSV file has all; and of one with more rows than the other
#: number none before it is opened.
MOST_ROWS, MOST_OPEN = 200, 40
#: Significant digits of numbers on the page.
DIGITS = 4
#: What the kinds of sampling are called in a sentence.
KINDS = {
    "monte carlo": "Monte Carlo",
    "latin hypercube": "Latin hypercube",
    "sobol": "Sobol sequence",
    "saltelli": "Saltelli's sample for Sobol indices",
    "tornado": "one input at a time",
}


@dataclass(frozen=True, slots=True)
class Map:
    """A field over the plan: nodes (k, 2), elements (m, 9), values (k,) in units of display."""

    title: str
    nodes: Array
    elements: Integers
    values: Array
    unit: Unit


@dataclass(frozen=True, slots=True)
class Origin:
    """Where a study comes from: its title, and what makes it repeatable, by name."""

    title: str
    facts: tuple[tuple[str, str], ...]  # seed, versions, checksums


def html(
    sample: Samples,
    origin: Origin,
    maps: Sequence[Map] = (),
    reliability: Sequence[Reliability] = (),
    level: float = LEVEL,
) -> str:
    """Return the page; every text of the study is escaped, nothing is loaded from elsewhere."""
    from markupsafe import Markup

    return render_page(
        HERE / "page.html",
        version=__version__,
        title=origin.title or "Study",
        css=Markup((HERE / "page.css").read_text(encoding="utf-8")),
        lead=_lead(sample),
        warnings=_warnings(sample),
        parts=_parts(sample, origin, maps, reliability, level),
    )


def _lead(sample: Samples) -> str:
    """Return in a sentence what was done."""
    n, solved = len(sample.number), int(sample.solved.sum())
    of = f" of {sample.planned} planned" if n != sample.planned else ""
    designs = f" for each of {len(sample.groups)} designs" if len(sample.groups) > 1 else ""
    kind = KINDS.get(sample.kind, sample.kind)
    return f"Sampling: {kind}{designs}. {n} variants{of}, {solved} with a result. Seed {sample.seed}."


def _warnings(sample: Samples) -> list[str]:
    """Return the warnings that come before any figure."""
    n, collapsed = len(sample.number), int(sample.collapsed.sum())
    lost = n - int(sample.solved.sum()) - collapsed
    notes = []
    if n < sample.planned:
        notes.append(f"The study is not finished: {sample.planned - n} variants are still to be computed.")
    if collapsed:
        notes.append(
            f"The foundation of {collapsed} of {n} variants fails: nothing can balance the loads. They count as failed "
            "in the limit states, and are left out of statistics and pictures of values."
        )
    if lost:
        notes.append(f"{lost} of {n} variants have no result, and are left out of all figures.")
    return notes


def _parts(
    sample: Samples, origin: Origin, maps: Sequence[Map], reliability: Sequence[Reliability], level: float
) -> list[dict[str, Any]]:
    """Return the sections of the page in their order, those that the study has something for."""
    from groundslab.study.evaluation import form

    # the table of exceedance is left to its file, as the page has the curves
    tables = {table.name: _layout(table) for table in evaluation.tables_of(sample, level)}
    parts: list[dict[str, Any]] = []

    def add(
        key: str, title: str, drawn: Sequence[str] = (), shown: Sequence[TableLayout] = (), words: Sequence[str] = ()
    ) -> None:
        if drawn or shown or words:
            parts.append({"key": key, "title": title, "words": words, "figures": drawn, "tables": shown})

    def named(name: str) -> list[TableLayout]:
        return [tables[name]] if name in tables else []

    results = bool(sample.outputs) and bool(sample.solved.any())
    if sample.limits and (results or sample.collapsed.any()):
        chosen = sample.random and any(entry.chosen for entry in sample.inputs)
        add("limit-states", "Limit states", [figures.designs(sample, level)] if chosen else [], named("limit_states"))
    if reliability:
        add("reliability", "First-order reliability", (), [_layout(table) for table in form.tables(reliability)])
    if results:
        drawn = [figures.outputs(sample)] if sample.random else []
        add("outputs", "Outputs", drawn, named("statistics") + named("discretization"))
        if sample.random:
            add("exceedance", "Probability of exceedance", [figures.exceedance(sample, level)])
        if sample.kind == "saltelli":
            add("sobol", "Sobol indices", [figures.sobol(sample, level)], named("sobol"))
        if "tornado" in tables:
            chart = [figures.tornado(sample, level)]
            words = _first_only(sample)
            add("tornado", "Influence of the inputs", chart, named("tornado"), words)
        if sample.varied:
            add("scatter", "Outputs over inputs", [figures.scatter(sample)], named("correlations"), _shown(sample))
    pictures = [
        figures.plan_map(
            f"map{number}", field_map.title, field_map.nodes, field_map.elements, field_map.values, field_map.unit.name
        )
        for number, field_map in enumerate(maps)
    ]
    add("maps", "Maps", pictures)
    if sample.varied:
        words = ["Bars: the samples. Line: the density that they were drawn from."] if sample.random else []
        add("inputs", "Inputs", [figures.inputs(sample)], (), words)
    add("missing", "Variants without a result", (), named("missing"))
    add("variants", "Variants", (), named("variants"))
    facts = tuple((Cell(name), Cell(value)) for name, value in origin.facts)
    add("origin", "Seed, versions, checksums", (), [TableLayout("Origin", headers("", ""), facts)])
    return parts


def _first_only(sample: Samples) -> list[str]:
    """Return a remark if the chart shows one design of several."""
    several = len(sample.groups) > 1 and sample.kind != "tornado"
    return [f"The chart is of the design {sample.groups[0].label}; the table has all."] if several else []


def _shown(sample: Samples) -> list[str]:
    """Return a remark if the scatter plots show less than all."""
    notes, drawn = [], int(sample.by_chance.sum())
    if drawn > figures.MOST_POINTS:
        notes.append(f"Of {drawn} variants the first {figures.MOST_POINTS} are shown.")
    if max(len(sample.varied), len(sample.outputs)) > figures.MOST_PANELS:
        notes.append(f"The first {figures.MOST_PANELS} inputs and outputs are shown.")
    return notes


def _layout(table: Table) -> TableLayout:
    """Return a table as the page shows it; a long one folded and cut."""
    names = [column.name for column in table.columns]
    # an estimate and its ends stand in one column
    ends = {
        at + k
        for at, name in enumerate(names)
        if names[at + 1 : at + 3] == [f"{name}, low", f"{name}, high"]
        for k in (1, 2)
    }
    # a column of units stands with that of the names before it
    units = {at for at, name in enumerate(names) if name == "unit" and at > 0}
    errors = {names.index(column.error_of): at for at, column in enumerate(table.columns) if column.error_of}
    kept = [at for at in range(len(names)) if at not in ends | units | {*errors.values()}]
    heads = tuple(TableHeader(table.columns[at].name, table.columns[at].unit, plain=True) for at in kept)
    notes = table.notes
    if len(table) > MOST_ROWS:
        notes += (f"The first {MOST_ROWS} of {len(table)} rows; {table.name}.csv has all.",)

    def cell(row: Sequence[RawCell], at: int) -> Cell:
        if at + 1 in ends:
            return _estimate(row[at : at + 3])
        shown = _cell(row[at], row[at + 1] if at + 1 in units else None)
        value, error = row[at], row[errors[at]] if at in errors else None
        if not isinstance(value, float) or not isinstance(error, float):
            return shown
        return replace(shown, under=error_text(error, value))

    rows = tuple(tuple(cell(row, at) for at in kept) for row in table.rows()[:MOST_ROWS])
    return TableLayout(table.title, heads, rows, notes, folded=len(table) > MOST_OPEN)


def _cell(value: RawCell, unit: RawCell = None) -> Cell:
    """Return a cell of a table; a number is followed by its unit if there is one, a name by that in brackets."""
    if value is None or value == "":
        return Cell("")
    if isinstance(value, str):
        return Cell(f"{value} [{unit}]" if unit else value)
    text = str(value) if isinstance(value, int) else format_number(value, DIGITS, trim=True, fixed=(1e-4, 1e9))
    return Cell(f"{text} {unit}" if unit else text, "number")


def _estimate(values: Sequence[RawCell]) -> Cell:
    """Return an estimate with its interval below it: "0.05 to 0.09"; an end that is not known is a dot."""
    if values[0] is None:
        return Cell("")
    value, low, high = (_cell(value).text or "\u00b7" for value in values)
    return Cell(value, "number", f"{low} to {high}")
