"""One page of a study: all that it tells, in one file that needs no other and no network."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.study.evaluation import tables as evaluation
from groundslab.study.evaluation.statistics import LEVEL
from groundslab.study.report import figures
from groundslab.units import format_number

if TYPE_CHECKING:
    from groundslab.arrays import Array, Integers
    from groundslab.design.tables.table import Cell, Table
    from groundslab.study.evaluation.form import Reliability
    from groundslab.study.evaluation.samples import Samples
    from groundslab.units import Unit

#: Of a longer table the page shows the first rows; the CSV file has all.
MOST_ROWS = 200
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
class FormattedCell:
    """A cell of a table as the page shows it: its text, what stands small below it, whether it is a number."""

    text: str
    under: str = ""
    number: bool = False


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
    from importlib.resources import files

    import jinja2
    from markupsafe import Markup

    tables = {table.name: table for table in evaluation.tables_of(sample, level)}
    folder = files("groundslab.study.report")
    template = jinja2.Environment(
        autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True
    ).from_string((folder / "page.html").read_text(encoding="utf-8"))
    text: str = template.render(
        version=__version__,
        title=origin.title or "Study",
        css=Markup((folder / "page.css").read_text(encoding="utf-8")),
        lead=_lead(sample),
        warnings=_warnings(sample),
        parts=_parts(sample, tables, origin, maps, reliability, level),
        foot=f"Made by groundslab {__version__}.",
    )
    return text


def _lead(sample: Samples) -> str:
    """Return in a sentence what was done."""
    n, solved = len(sample.number), int(sample.solved.sum())
    of = f" of {sample.planned} planned" if n != sample.planned else ""
    designs = f" for each of {len(sample.groups)} designs" if len(sample.groups) > 1 else ""
    kind = KINDS.get(sample.kind, sample.kind)
    return f"Sampling: {kind}{designs}. {n} variants{of}, {solved} with a result. Seed {sample.seed}."


def _warnings(sample: Samples) -> list[str]:
    """Return what a reader must know before any figure."""
    lost, n = int((~sample.solved).sum()), len(sample.number)
    notes = []
    if n < sample.planned:
        notes.append(f"The study is not finished: {sample.planned - n} variants are still to be computed.")
    if lost:
        notes.append(
            f"{lost} of {n} variants have no result. They are left out of all figures; if they failed because the "
            "plate has no equilibrium, they belong to the worst ones."
        )
    return notes


def _parts(
    sample: Samples,
    tables: Mapping[str, Table],
    origin: Origin,
    maps: Sequence[Map],
    reliability: Sequence[Reliability],
    level: float,
) -> list[dict[str, Any]]:
    """Return the sections of the page in their order, those that the study has something for."""
    # the table of exceedance is left to its file, as the page has the curves
    parts: list[dict[str, Any]] = []

    def add(
        key: str, title: str, drawn: Sequence[str] = (), names: Sequence[str] = (), words: Sequence[str] = ()
    ) -> None:
        shown = [_table(tables[name]) for name in names if name in tables]
        if drawn or shown or words:
            part = {"key": key, "title": title, "words": words, "figures": list(drawn)}
            parts.append({**part, "tables": shown})

    results = bool(sample.outputs) and bool(sample.solved.any())
    if results and sample.limits:
        chosen = sample.random and any(each.chosen for each in sample.inputs)
        add("limit-states", "Limit states", [figures.designs(sample, level)] if chosen else [], ["limit_states"])
    if reliability:
        parts.append(_reliability(reliability))
    if results:
        drawn = [figures.outputs(sample)] if sample.random else []
        add("outputs", "Outputs", drawn, ["statistics"])
        if sample.random:
            add("exceedance", "Probability of exceedance", [figures.exceedance(sample, level)])
        if sample.kind == "saltelli":
            add("sobol", "Sobol indices", [figures.sobol(sample, level)], ["sobol"])
        if "tornado" in tables:
            add(
                "tornado", "Influence of the inputs", [figures.tornado(sample, level)], ["tornado"], _first_only(sample)
            )
        if sample.varied:
            add("scatter", "Outputs over inputs", [figures.scatter(sample)], ["correlations"], _shown(sample))
    pictures = [
        figures.plan_map(f"map{number}", each.title, each.nodes, each.elements, each.values, each.unit.name)
        for number, each in enumerate(maps)
    ]
    add("maps", "Maps", pictures)
    if sample.varied:
        words = ["Bars: the samples. Line: the density that they were drawn from."] if sample.random else []
        add("inputs", "Inputs", [figures.inputs(sample)], (), words)
    add("missing", "Variants without a result", (), ["missing"])
    add("variants", "Variants", (), ["variants"])
    facts = {"title": "Origin", "heads": ["", ""], "notes": [], "folded": False}
    facts["rows"] = [[FormattedCell(text) for text in pair] for pair in origin.facts]
    parts.append({"key": "origin", "title": "Seed, versions, checksums", "words": [], "figures": [], "tables": [facts]})
    return parts


def _first_only(sample: Samples) -> list[str]:
    """Return a remark if the chart shows one design of several."""
    several = len(sample.groups) > 1 and sample.kind != "tornado"
    return [f"The chart is of the design {sample.groups[0].label}; the table has all."] if several else []


def _shown(sample: Samples) -> list[str]:
    """Return a remark if the scatter plots show less than all."""
    notes, drawn = [], int(sample.drawn.sum())
    if drawn > figures.MOST_POINTS:
        notes.append(f"Of {drawn} variants the first {figures.MOST_POINTS} are shown.")
    if max(len(sample.varied), len(sample.outputs)) > figures.MOST_PANELS:
        notes.append(f"The first {figures.MOST_PANELS} inputs and outputs are shown.")
    return notes


def _reliability(found: Sequence[Reliability]) -> dict[str, Any]:
    """Return the section on first-order reliability."""
    from groundslab.study.evaluation.form import tables

    shown = [_table(table) for table in tables(found)]
    return {"key": "reliability", "title": "First-order reliability", "words": [], "figures": [], "tables": shown}


def _table(table: Table) -> dict[str, Any]:
    """Return a table as the template wants it; a long one folded and cut."""
    columns = table.columns
    names = [column.name for column in columns]
    # an estimate and its ends stand in one column
    ends = {
        at + k
        for at, name in enumerate(names)
        if names[at + 1 : at + 3] == [f"{name}, low", f"{name}, high"]
        for k in (1, 2)
    }
    # a column of units stands with that of the names before it
    units = {at for at, name in enumerate(names) if name == "unit" and at > 0}
    kept = [at for at in range(len(names)) if at not in ends | units]
    rows = table.rows()
    notes = list(table.notes)
    if len(rows) > MOST_ROWS:
        notes.append(f"The first {MOST_ROWS} of {len(rows)} rows; {table.name}.csv has all.")
    return {
        "title": table.title,
        "heads": [columns[at].header for at in kept],
        "rows": [
            [
                _estimate(row[at : at + 3])
                if at + 1 in ends
                else _named(row[at], row[at + 1])
                if at + 1 in units
                else _cell(row[at])
                for at in kept
            ]
            for row in rows[:MOST_ROWS]
        ],
        "notes": notes,
        "folded": len(rows) > 40,
    }


def _cell(cell: Cell) -> FormattedCell:
    """Return a cell of a table."""
    if cell is None:
        return FormattedCell("")
    if isinstance(cell, float):
        return FormattedCell(format_number(cell, DIGITS, trim=True, fixed=(1e-4, 1e9)), number=True)
    return FormattedCell(str(cell), number=isinstance(cell, int))


def _estimate(cells: Sequence[Cell]) -> FormattedCell:
    """Return an estimate with its interval below it: "0.05 to 0.09"; an end that is not known is a dot."""
    if cells[0] is None:
        return FormattedCell("")
    value, low, high = (_cell(cell).text or "\u00b7" for cell in cells)
    return FormattedCell(value, f"{low} to {high}", number=True)


def _named(name: Cell, unit: Cell) -> FormattedCell:
    """Return a name or a number with its unit as a cell."""
    cell = _cell(name)
    if not unit or not cell.text:
        return cell
    return FormattedCell(f"{cell.text} {unit}" if cell.number else f"{cell.text} [{unit}]", number=cell.number)
