"""What the report says, gathered from a solved model: one value that page and paper print."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

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
from groundslab.views.report.calculations import PIECES, draw_sheets
from groundslab.views.report.certificates import list_certificates
from groundslab.views.report.document import (
    Bullets,
    ChapterOfReport,
    CheckLine,
    Columns,
    Figures,
    Paragraph,
    Part,
    Report,
    SourceText,
    Viewer,
)
from groundslab.views.report.drawings import drawings
from groundslab.views.report.drawings.signs import draw_signs
from groundslab.views.report.ground_models import build_chapter
from groundslab.views.report.input_tables import input_tables
from groundslab.views.report.length import CHAPTERS as SHORT_CHAPTERS
from groundslab.views.report.length import governing_sheets, shorten_input, shorten_tables
from groundslab.views.report.table_layout import Cell, TableHeader, TableLayout, drop_empty_columns, headers
from groundslab.views.summary import combinations, sections
from groundslab.views.summary.discretization import coarse_words, is_unknown, provisional_words
from groundslab.views.summary.rows import SummarySection
from groundslab.views.summary.terminal import between_text, error_text, shown_row, step_texts
from groundslab.views.tables.result_tables import table_makers
from groundslab.views.translation import translator_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

    from groundslab.analysis.ground_comparison.comparison import GroundComparison
    from groundslab.design.rules.check import DesignCheck
    from groundslab.model.outputs import Chapter, Length, Project
    from groundslab.results.results import CombinationResult, Results
    from groundslab.unit_systems import System
    from groundslab.views.report.document import Block, Verdict
    from groundslab.views.summary.combinations import Entry, Extreme
    from groundslab.views.summary.rows import Row
    from groundslab.views.tables.table import Table


_VALUE = ("", "symbol", "#value", "unit", "#error")
NOTHING = "No combination has a certified result."
#: What is said above the tables, and above the keys of the case.
IN_TEXT = (
    "Numbers have five significant digits; the files tables/*.csv of the results have seven. Of long tables the "
    "extremes are here."
)
KEYS = (
    "Each key of the case with its value. Quantities are shown with five significant digits in a unit that fits; the "
    "case's text, folded below and not printed, has all digits."
)
#: Titles of the chapters, in their order.
TITLES: dict[Chapter, str] = {
    "drawings": "Drawings", "loads": "Loads", "extremes": "Extreme values", "pictures": "Pictures",
    "grounds": "Ground models compared", "assumptions": "Assumptions and signs", "calculations": "Calculations",
    "tables": "Tables", "viewer": "Viewer",
    "case": "Case, key by key", "certificate": "Certificate", "convergence": "Convergence",
    "long_tables": "Long tables",
}  # fmt: skip
#: Those of the appendix.
APPENDIX: tuple[Chapter, ...] = ("case", "certificate", "convergence", "long_tables")
#: Limit states whose extremes stand side by side.
GROUPS: dict[str, Sequence[str]] = {
    "ultimate": STRENGTH, "serviceability": SERVICEABILITY, "stability": ("equilibrium", "uplift"),
}  # fmt: skip


def build_report(
    combined: Results,
    text: str | None = None,
    file: str = "case.toml",
    chapters: Sequence[str] | None = None,
    comparison: GroundComparison | None = None,
    told: Callable[[str, float], None] = lambda _, __: None,
    length: Length = "full",
) -> Report:
    """Return the report of a solved model; text and file are those of its input.

    The chapters are those that the case asks for, unless given, else those of a length; that of ground models is there
    with a comparison only.
    Before each it is told which one is made, and what share of all is.
    """
    combinations.require_finite(combined)
    entries = combinations.entries(combined)
    text = casefile.to_toml(combined.model) if text is None else text
    shown = _chosen(combined, chapters, comparison, length)
    short, source = length == "short", SourceText(printable(file), printable(text, keep="\n\t"))
    makers = _chapters(combined, entries, comparison, source, short=short, in_appendix="long_tables" in shown)
    finished: list[ChapterOfReport] = []
    for number, name in enumerate(shown):
        told(TITLES[name], number / len(shown))
        finished.append(ChapterOfReport(name, TITLES[name], tuple(makers[name]()), name in APPENDIX))
    if combined.refused:
        first = next((at for at, chapter in enumerate(finished) if chapter.in_appendix), len(finished))
        finished.insert(first, ChapterOfReport("refused", "Combinations without results", tuple(_refused(combined))))
    design, digest = check_design(combined), hashlib.sha256(text.encode()).hexdigest()
    return Report(
        title=combined.model.title,
        project=tuple(_title_block(combined.model.project)),
        version=__version__,
        file=source.file,
        sha256=digest,
        facts=(
            ("Program", joined((Name(f"groundslab {__version__}"), "thick plates on layered, tensionless ground"))),
            ("Input file", Name(source.file)),
            ("SHA-256 of its text", Name(digest)),
            *_facts(combined),
        ),
        design=("bad" if design.open else "doubtful" if design.hanging else "", design.headline),
        unchecked=design.unchecked,
        checks=tuple(_check_line(check, short=short) for check in design.checks),
        analysis=_verdict(combined, entries),
        chapters=tuple(finished),
    )


def _chosen(
    combined: Results, chapters: Sequence[str] | None, comparison: GroundComparison | None, length: Length
) -> list[Chapter]:
    """Return the chapters that there are to be, in their order; raises InputError."""
    if chapters is None:
        asked = combined.model.report
        chapters = SHORT_CHAPTERS if length == "short" and "chapters" not in asked.model_fields_set else asked.chapters
    if unknown := [name for name in chapters if name not in TITLES]:
        expected = f"chapters among {listed(TITLES)}"
        raise InputError([Issue("chapters", f'"{name}"', expected) for name in unknown])
    if comparison is not None and comparison.model != combined.model:
        raise InputError([Issue("comparison", "one of another model", "one of the model of the results")])
    missing = {"grounds"} if comparison is None else set()
    missing |= set() if "calculations" in table_makers(combined) else {"calculations"}
    return [name for name in TITLES if name in chapters and name not in missing]


def _refused(combined: Results) -> Iterator[Part]:
    """Yield why combinations have no results, each under its name."""
    for name, error in combined.refused.items():
        yield Part(Name(name), (Paragraph(refusal_words(error, combined.model.units), "bad reason"),), keep=True)


def _check_line(check: DesignCheck, *, short: bool) -> CheckLine:
    """Return a check as the first page has it; of a short report's only those that are open are explained."""
    demand = limit = used = ""
    if check.demand is not None and check.resistance is not None:
        demand, limit = (f"{_figure(value)} {check.unit}" for value in (check.demand, check.resistance))
        used = f"{check.utilization:.2f}"
    verdicts: dict[str, Verdict] = {"fails": "bad", "attention": "doubtful", "switched off": "doubtful"}
    verdict = verdicts.get(check.status, "doubtful" if check.hangs else "good")
    brief = short and verdict == "good"
    return CheckLine(
        name=check.name,
        demand=demand,
        demand_error="" if brief else error_text(check.error or 0.0, check.demand or 0.0),
        limit=limit,
        used=used,
        between="" if brief else between_text(check),
        words="" if brief else check.words,
        status=check.status,
        within="but within the error" if check.hangs else "",
        verdict=verdict,
    )


def _figure(value: float) -> str:
    """Return a number as the first page has it."""
    return f"{value:.4g}" if abs(value) < 10000 else f"{value:.0f}"


def _chapters(
    combined: Results,
    entries: Sequence[Entry],
    comparison: GroundComparison | None,
    source: SourceText,
    *,
    short: bool,
    in_appendix: bool,
) -> dict[Chapter, Callable[[], Iterable[Block]]]:
    """Return what makes the blocks of each chapter, so that only those wanted are made."""
    model = combined.model
    solved = [entry.results for entry in entries if entry.results is not None]
    governing = drawings.find_governing(combined).get("settlement", "")
    leading = combined.results.get(governing) or (solved[0] if solved else None)
    makers = table_makers(combined)
    made = cache(lambda name: makers[name]())
    translate, beside = translator_of(combined), 3 if short else 2
    return {
        "extremes": lambda: (
            [Part(grid.title, (grid,), keep=True) for grid in _extremes(combined, entries)]
            or [Paragraph(NOTHING, "bad")]
        ),
        "pictures": lambda: _pictures(combined, beside, beams=2 if short else 1),
        "drawings": lambda: tuple(_drawings(combined, leading, short=short)),
        "loads": lambda: (
            Paragraph("Each load case by itself, values without factors."),
            Figures(tuple(drawings.draw_loads(model, combined.solved_model, translate)), beside),
        ),
        "grounds": lambda: () if comparison is None else build_chapter(comparison),
        "assumptions": lambda: _assumptions(combined, short=short),
        "tables": lambda: (
            Paragraph(IN_TEXT),
            *(
                _table_part(table, in_appendix)
                for table in (shorten_tables(makers, made) if short else map(made, makers))
                if table.name != "calculations"
            ),
        ),
        "calculations": lambda: _calculations(combined, made("calculations"), short=short),
        "viewer": lambda: (Viewer(),),
        "case": lambda: _case(combined, source, list_sections(combined) if solved else ()),
        "certificate": lambda: list_certificates(combined, entries),
        "convergence": lambda: _convergence(entries, model.units),
        "long_tables": lambda: (
            [
                Part(table.title, _whole(table), f"whole-{table.name}")
                for table in map(made, makers)
                if table_layout.is_long(table)
            ]
            or [Paragraph("There are none.")]
        ),
    }


def _assumptions(combined: Results, *, short: bool) -> Iterator[Block]:
    """Yield the assumptions, in short as one paragraph behind what is given, without the drawing of signs."""
    said = tuple(list_assumptions(combined))
    if short:
        yield Columns(tuple(shorten_input(input_tables(combined.model, combined.combinations))), beside=True)
        yield Paragraph(joined(said, " "))
    else:
        yield Figures((draw_signs(translator_of(combined)),))
        yield Bullets(said)


def _calculations(combined: Results, table: Table, *, short: bool) -> Iterator[Block]:
    """Yield the notes on calculations, and a sheet for each, in short for one of each kind."""
    yield from map(Paragraph, table.notes)
    sheets = draw_sheets(combined, table)
    if any(sheet.pieces for sheet in sheets):
        yield Paragraph(PIECES)
    yield from governing_sheets(sheets, check_design(combined).checks) if short else sheets


def _pictures(combined: Results, beside: int, beams: int) -> Iterator[Block]:
    """Yield the governing fields as small plans, and the forces along beams, each so many beside each other."""
    if pictures := tuple(drawings.draw_pictures(combined)):
        yield Figures(pictures, beside)
    else:
        yield Paragraph(NOTHING)
    yield Figures(tuple(drawings.draw_beams(combined)), beams)


def _case(combined: Results, source: SourceText, analyzed: Sequence[SummarySection]) -> Iterator[Block]:
    """Yield each key of the case with its value, the case's text, plate and mesh as analyzed."""
    model = combined.model
    yield Paragraph(KEYS)
    yield Columns(
        tuple(Part(section.title, _titled(section.grids)) for section in input_tables(model, combined.combinations))
    )
    yield source
    if analyzed:
        sections_of = [layout_section(section, model.units) for section in analyzed]
        yield Part("As analysed", _titled(sections_of), keep=True)


def _titled(grids: Iterable[TableLayout]) -> tuple[Block, ...]:
    """Return tables, those with a title under it as a heading."""
    return tuple(Part(grid.title, (grid,), level=4) if grid.title else grid for grid in grids)


def _table_part(table: Table, in_appendix: bool) -> Part:
    """Return a table under its title as the text has it: whole, or of a long one its extremes and where it is whole."""
    blocks = _extremes_of(table, in_appendix) if table_layout.is_long(table) else _whole(table)
    return Part(table.title, blocks, f"table-{table.name}", on_paper=table.name != "checks")


def _extremes_of(table: Table, in_appendix: bool) -> tuple[Block, ...]:
    """Return the extremes of a long table, and where it is whole."""
    rows, digest = len(table), table_layout.summarize_table(table)
    template = "All {rows} rows: tables/{table}.csv of the results and the workbook that groundslab tables writes."
    whole = Message(template, rows=rows, table=Name(table.name))
    if in_appendix and rows <= table_layout.MOST_IN_FILE:
        whole = Message("All {rows} rows: the appendix.", rows=rows)
    return (*([] if digest is None else [replace(digest, notes=(*digest.notes, *table.notes))]), Paragraph(whole))


def _whole(table: Table) -> tuple[Block, ...]:
    """Return a table cut so that it fits on paper, or that it has no rows, or too many for one file."""
    if not len(table):
        return (Paragraph("Nothing to list."), *map(Paragraph, table.notes))
    if len(table) > table_layout.MOST_IN_FILE:
        template = "{rows} rows are too many for this file: see tables/{table}.csv."
        return (Paragraph(Message(template, rows=len(table), table=Name(table.name))),)
    return tuple(table_layout.split_columns(table_layout.layout_table(table), table_layout.keys_of(table)))


def _convergence(entries: Sequence[Entry], units: System) -> Iterator[Block]:
    """Yield the constants of the ground, if it has any, and the steps of all combinations."""
    steps = list_steps(entries)
    if any(entry.results.constants.k0 for entry in entries if entry.results is not None):
        yield Part("Constants of the ground", (list_constants(entries, units),))
        yield Part("Iterations", (steps,))
    else:
        yield steps


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


def _verdict(combined: Results, entries: Sequence[Entry]) -> tuple[Verdict, str]:
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
        of_key = [group[key][0] for group in groups.values() if key in group]
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
        notes = tuple(dict.fromkeys(note for section in of_key for note in section.notes))
        yield drop_empty_columns(TableLayout(of_key[0].title, heads, cells, notes))


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


def _drawings(combined: Results, leading: CombinationResult | None, *, short: bool) -> Iterator[Figures]:
    """Yield the plan of the case, in full the mesh, stresses in the ground if known, and the ground in section."""
    yield Figures((drawings.draw_case(combined.model, combined.solved_model, translator_of(combined)),))
    if leading is None:
        return
    soil = drawings.draw_soil(leading)
    stress = None if soil is None else drawings.draw_stress(leading)
    beside = [None if short else drawings.draw_mesh_plan(leading), stress]
    yield Figures(tuple(drawing for drawing in beside if drawing is not None), columns=2)
    if soil is None:
        return
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
    yield Figures((replace(soil, caption=joined(notes, " ")),))


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
