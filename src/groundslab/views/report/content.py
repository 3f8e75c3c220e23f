"""What the report says, gathered from a solved model: one value that the template prints."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.case import casefile
from groundslab.design.checks import check_design
from groundslab.errors import InputError, Issue
from groundslab.messages import Listed, Message, Name, joined
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.load_cases import SERVICEABILITY, STRENGTH
from groundslab.results.results import refusal_words
from groundslab.results.soil_profile import list_columns
from groundslab.schema.wording import listed, printable
from groundslab.unit_systems import unit_in
from groundslab.views.report import table_layout
from groundslab.views.report.assumptions import list_assumptions
from groundslab.views.report.calculations import draw_sheets
from groundslab.views.report.certificates import list_certificates
from groundslab.views.report.drawings import drawings
from groundslab.views.report.ground_models import build_chapter
from groundslab.views.report.input_tables import input_tables
from groundslab.views.report.table_layout import Cell, TableHeader, TableLayout, drop_empty_columns, headers
from groundslab.views.summary import combinations, sections
from groundslab.views.summary.discretization import coarse_words, is_unknown, provisional_words
from groundslab.views.summary.rows import SummarySection
from groundslab.views.summary.terminal import between_text, error_text, shown_row, step_texts
from groundslab.views.tables.result_tables import table_makers, tables_of
from groundslab.views.translation import translator_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence

    from groundslab.analysis.ground_comparison.comparison import GroundComparison
    from groundslab.model.outputs import Chapter, Project
    from groundslab.results.results import CombinationResult, Results
    from groundslab.unit_systems import System
    from groundslab.views.summary.combinations import Entry, Extreme
    from groundslab.views.summary.rows import Row
    from groundslab.views.tables.table import Table


_VALUE = ("", "symbol", "#value", "unit", "#error")
#: Titles of the chapters, in their order.
TITLES: dict[Chapter, str] = {
    "extremes": "Extreme values", "pictures": "Pictures", "drawings": "Drawings", "loads": "Loads",
    "grounds": "Ground models compared", "assumptions": "Assumptions and signs", "tables": "Tables",
    "calculations": "Calculations", "viewer": "Viewer",
    "case": "Case, key by key", "certificate": "Certificate", "convergence": "Convergence",
    "long_tables": "Long tables",
}  # fmt: skip
#: Those of the appendix.
APPENDIX: tuple[Chapter, ...] = ("case", "certificate", "convergence", "long_tables")
#: Limit states whose extremes stand side by side.
GROUPS: dict[str, Sequence[str]] = {
    "ultimate": STRENGTH, "serviceability": SERVICEABILITY, "stability": ("equilibrium", "uplift"),
}  # fmt: skip


def build_page(
    combined: Results,
    text: str | None = None,
    file: str = "case.toml",
    chapters: Sequence[str] | None = None,
    comparison: GroundComparison | None = None,
    told: Callable[[str, float], None] = lambda _, __: None,
) -> dict[str, Any]:
    """Return the content of the report of a solved model, for the template; text and file are those of its input.

    The chapters are those that the case asks for, unless given; that of ground models is there with a comparison only.
    Before each it is told which one is made, and what share of all is.
    """
    combinations.require_finite(combined)
    entries = combinations.entries(combined)
    text = casefile.to_toml(combined.model) if text is None else text
    wanted = combined.model.report.chapters if chapters is None else chapters
    if unknown := [name for name in wanted if name not in TITLES]:
        expected = f"chapters among {listed(TITLES)}"
        raise InputError([Issue("chapters", f'"{name}"', expected) for name in unknown])
    if comparison is not None and comparison.model != combined.model:
        raise InputError([Issue("comparison", "one of another model", "one of the model of the results")])
    missing = {"grounds"} if comparison is None else set()
    missing |= set() if "calculations" in table_makers(combined) else {"calculations"}
    shown = [name for name in TITLES if name in wanted and name not in missing]
    makers = _chapters(combined, entries, comparison, in_appendix="long_tables" in shown)
    contents: dict[str, Any] = {}
    for number, name in enumerate(shown):
        told(TITLES[name], number / len(shown))
        contents |= {key: make() for key, make in makers.get(name, {}).items()}
    return {
        "chapters": {name: TITLES[name] for name in shown},
        "appendix": [name for name in shown if name in APPENDIX],
        "title": combined.model.title,
        "project": _title_block(combined.model.project),
        "version": __version__,
        "file": printable(file),
        "text": printable(text, keep="\n\t"),
        "sha256": hashlib.sha256(text.encode()).hexdigest(),
        "facts": list(_facts(combined)),
        "verdict": dict(zip(("status", "words"), _verdict(combined, entries), strict=True)),
        "design": check_design(combined),
        "within": [
            (error_text(check.error or 0.0, check.demand or 0.0), between_text(check))
            for check in check_design(combined).checks
        ],
        "refused": [(name, refusal_words(error, combined.model.units)) for name, error in combined.refused.items()],
        **contents,
    }


def _chapters(
    combined: Results, entries: Sequence[Entry], comparison: GroundComparison | None, *, in_appendix: bool
) -> dict[Chapter, dict[str, Callable[[], Any]]]:
    """Return what makes the parts of each chapter, so that only those wanted are made."""
    model = combined.model
    there = [entry.results for entry in entries if entry.results is not None]
    governing = drawings.find_governing(combined).get("settlement", "")
    leading = combined.results.get(governing) or (there[0] if there else None)
    constants = any(results.constants.k0 for results in there)
    tables = cache(lambda: tables_of(combined))
    return {
        "extremes": {"extremes": lambda: list(_extremes(combined, entries))},
        "pictures": {
            "pictures": lambda: list(drawings.draw_pictures(combined)),
            "beams": lambda: list(drawings.draw_beams(combined)),
        },
        "drawings": {"drawings": lambda: list(_drawings(combined, leading))},
        "loads": {"loads": lambda: list(drawings.draw_loads(model, combined.solved_model, translator_of(combined)))},
        "grounds": {"grounds": lambda: None if comparison is None else build_chapter(comparison)},
        "assumptions": {"assumptions": lambda: list_assumptions(combined)},
        "tables": {
            "tables": lambda: [layout_in_text(table, in_appendix) for table in tables() if table.name != "calculations"]
        },
        "calculations": {
            "calculations": lambda: [table for table in tables() if table.name == "calculations"],
            "sheets": lambda: [
                sheet for table in tables() if table.name == "calculations" for sheet in draw_sheets(combined, table)
            ],
        },
        "case": {
            "case": lambda: input_tables(model, combined.combinations),
            "analysed": lambda: [
                layout_section(section, model.units) for section in (list_sections(combined) if there else ())
            ],
        },
        "certificate": {"certificates": lambda: list_certificates(combined, entries)},
        "convergence": {
            "constants": lambda: list_constants(entries, model.units) if constants else None,
            "history": lambda: list_steps(entries),
        },
        "long_tables": {
            "long_tables": lambda: [layout_whole(table) for table in tables() if table_layout.is_long(table)]
        },
    }


def _title_block(project: Project | None) -> list[tuple[str, str]]:
    """Return the entries of a project that are given, each with its heading."""
    entries = (
        []
        if project is None
        else [(key.capitalize(), str(value)) for key, value in project if key not in ("units", "language")]
    )
    return [(name if name != "Name" else "Project", value) for name, value in entries if value]


def _facts(combined: Results) -> Iterator[tuple[str, str]]:
    """Yield what stands in the title block beside title, program and file."""
    counts = {"without equilibrium": len(combined.without_equilibrium), "not solved": len(combined.unsolved)}
    parts = [Message("{count} {what}", count=count, what=what) for what, count in counts.items() if count]
    total = len(combined.combinations)
    which = Message("{total}, of which {parts}", total=total, parts=joined(parts, " and "))
    yield "Combinations", which if parts else str(total)


def _verdict(combined: Results, entries: Sequence[Entry]) -> tuple[str, str]:
    """Return how good the results of all combinations are (good, doubtful, bad), and that in words."""
    if not combined.refused:
        certified = sections.certified_words(len(entries))
        coarse = coarse_words(combined)
        if is_unknown(combined):
            return "bad", coarse
        return ("doubtful", joined((certified, coarse), " ")) if coarse else ("good", certified)
    others = ["The results of the others are certified."] if combined.results else []
    words = [*combinations.refusal_sentences(combined), *others, provisional_words(combined)]
    return ("bad", joined(filter(None, words), " "))


def list_sections(combined: Results) -> list[SummarySection]:
    """Return plate and mesh as analyzed, and ground without constants, which has no table of them."""
    plate, mesh, ground, *_ = combinations.description(combined)
    return [plate, mesh, *([ground] if isinstance(combined.model.ground, ContinuousGround) else [])]


def layout_section(section: SummarySection, units: System) -> TableLayout:
    """Return a section of the summary."""
    rows = tuple(layout_row(row, units) for row in section.rows)
    return drop_empty_columns(TableLayout(section.title, headers(*_VALUE), rows, section.notes))


def layout_row(row: Row, units: System) -> tuple[Cell, ...]:
    """Return a row of the summary without its place."""
    shown = shown_row(row, units)
    words = Cell(row.label, "words"), Cell(row.symbol, "symbol")
    return (*words, Cell(shown.figure, "number"), Cell(shown.unit), Cell(shown.error, "number"))


def _extremes(combined: Results, entries: Sequence[Entry]) -> Iterator[TableLayout]:
    """Yield the extremes over all certified combinations with their places, those of GROUPS side by side."""
    names = {entry.number: entry.combination.name for entry in entries} if len(entries) > 1 else {}
    units = combined.model.units
    groups = {
        name: {section.key: (section, {row.row.key: row for row in rows}) for section, rows in extremes}
        for name, states in GROUPS.items()
        if (extremes := combinations.extremes(combined, states))
    }
    for key in dict.fromkeys(key for group in groups.values() for key in group):
        sides = [group[key][1] if key in group else {} for group in groups.values()]
        there = [group[key][0] for group in groups.values() if key in group]
        keys = dict.fromkeys(key for side in sides for key in side)
        rows = [_shared_label([side[key].row for side in sides if key in side]) for key in keys]
        heads = headers("", "symbol", "unit")
        for name in groups:
            heads += (
                *headers(f"#{name if names else 'value'}"),
                TableHeader("at (x, y)", unit_in("m", units)[0], number=True),
            )
            heads += headers("combination")
        cells = tuple(
            (
                *_words_of(row, units),
                *(cell for side in sides for cell in _extreme(side.get(row.key), names, row.label, units)),
            )
            for row in rows
        )
        notes = tuple(dict.fromkeys(note for section in there for note in section.notes))
        yield drop_empty_columns(TableLayout(there[0].title, heads, cells, notes))


def _shared_label(rows: Sequence[Row]) -> Row:
    """Return a row for those of one key: by its label, without the quantity after the comma where they differ in it."""
    same = len({row.label for row in rows}) == 1
    return rows[0] if same else replace(rows[0], label=_parts(rows[0].label)[0])


def _parts(label: str) -> tuple[str, str]:
    """Return a label without the quantity after the comma, and that."""
    return (label.parts[0], joined(label.parts[1:])) if isinstance(label, Listed) else (label, "")


def _words_of(row: Row, units: System) -> tuple[Cell, ...]:
    """Return a row's name, symbol and unit."""
    return Cell(row.label, "words"), Cell(row.symbol, "symbol"), Cell(shown_row(row, units).unit)


def _extreme(extreme: Extreme | None, names: Mapping[int, str], label: str, units: System) -> tuple[Cell, ...]:
    """Return an extreme, under it its error or what the label leaves out, its place, its combination of several."""
    if extreme is None:
        return (Cell(""),) * 3
    shown = shown_row(extreme.row, units)
    under = shown.error or ("" if extreme.row.label == label else _parts(extreme.row.label)[1])
    return (
        Cell(shown.figure, "number", under),
        Cell(shown.place, "number"),
        Cell(names.get(extreme.number, "")),
    )


def layout_in_text(table: Table, in_appendix: bool) -> dict[str, Any]:
    """Return a table as the text has it: whole, or of a long one its extremes and where it is whole."""
    if not table_layout.is_long(table):
        return layout_whole(table) | {"whole": ""}
    rows, digest = len(table), table_layout.summarize_table(table)
    template = "All {rows} rows: tables/{table}.csv of the results and the workbook that groundslab tables writes."
    whole = Message(template, rows=rows, table=Name(table.name))
    if in_appendix and rows <= table_layout.MOST_IN_FILE:
        whole = Message("All {rows} rows: the appendix.", rows=rows)
    grids = [] if digest is None else [replace(digest, notes=(*digest.notes, *table.notes))]
    return {"name": table.name, "title": table.title, "grids": grids, "whole": whole}


def layout_whole(table: Table) -> dict[str, Any]:
    """Return a table cut so that it fits on paper; without rows if it has too many for one file."""
    fits = len(table) <= table_layout.MOST_IN_FILE
    grids = table_layout.split_columns(table_layout.layout_table(table), table_layout.keys_of(table))
    template = "{rows} rows are too many for this file: see tables/{table}.csv."
    too_many = Message(template, rows=len(table), table=Name(table.name))
    about = {"name": table.name, "title": table.title, "length": len(table), "too_many": too_many}
    return about | {"grids": grids if fits and len(table) else [], "notes": table.notes}


def list_constants(entries: Sequence[Entry], units: System) -> TableLayout:
    """Return the constants of the ground that the combinations ended with; those with the same ones share a row."""
    heads: list[TableHeader] = []
    names: dict[tuple[Cell, ...], list[str]] = {}
    for entry in entries:
        if entry.results is None:
            continue
        shown = [(row, shown_row(row, units)) for row in sections.description_of_ground(entry.results).rows[1:]]
        heads = heads or [TableHeader(row.label, text.unit, True, row.symbol) for row, text in shown]
        cells = tuple(Cell(text.figure, "number") for _, text in shown)
        names.setdefault(cells, []).append(entry.combination.name)
    if len(names) == 1:
        return TableLayout("", tuple(heads), tuple(names))
    rows = tuple((Cell(joined(map(Name, those))), *cells) for cells, those in names.items())
    return TableLayout("", (TableHeader("combination"), *heads), rows)


def _drawings(combined: Results, leading: CombinationResult | None) -> Iterator[drawings.Drawing]:
    """Yield the plan of the case, the mesh, stresses in the ground if they are known, and the ground in section."""
    yield drawings.draw_case(combined.model, combined.solved_model, translator_of(combined))
    if leading is not None:
        yield drawings.draw_mesh_plan(leading)
    soil = None if leading is None else drawings.draw_soil(leading)
    if soil is None or leading is None:
        return
    if (stress := drawings.draw_stress(leading)) is not None:
        yield stress
    notes = ["Ground below the plate, to scale in depth."]
    if leading.constants.gamma is not None:
        template = (
            "γ, k0, k1 and ψ(z) are those of the combination {name}; other combinations have their own, see the table."
        )
        several = len(combined.combinations) > 1
        notes.append(
            Message(template, name=Name(leading.combination))
            if several
            else "γ, k0, k1 and ψ(z) at the end of the analysis."
        )
    if combined.model.boreholes or combined.model.soil_zones:
        notes.append("The table's constants are means over the plate's area.")
    count = len(list_columns(combined.model))
    if count > drawings.MOST_COLUMNS:
        notes.append(
            Message("The first {drawn} of {count} columns are drawn.", drawn=drawings.MOST_COLUMNS, count=count)
        )
    yield replace(soil, caption=joined(notes, " "))


def list_steps(entries: Sequence[Entry]) -> TableLayout:
    """Return all steps of all combinations that have results."""
    numbers = ("#unknowns of the mesh", "#load increment", "#gamma", "#contact iteration", "#in contact")
    heads = headers("combination", *numbers, "#changed", "")
    rows = tuple(
        (Cell(Name(results.combination)), *(Cell(text, "number") for text in step_texts(step)), Cell("*" * step.finest))
        for results in (entry.results for entry in entries if entry.results is not None)
        for step in results.steps
    )
    return TableLayout(
        "",
        heads,
        rows,
        ("* on the final mesh. Contact is counted in nodes, on an elastic continuum in cells.",),
        folded=len(rows) > table_layout.MOST_ROWS,
    )
