"""The tables of solved combinations as the page shows them: those of results, of ground, mesh and steps of a report.

Cells are formatted as in the report. Heads name the columns whose cells say where a value is and which combination it
is of, so that a click on it can show both.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from groundslab.messages import Label
from groundslab.results.fields import LAYERS, RANGED_FIELDS
from groundslab.views.report import content, table_layout
from groundslab.views.report.table_layout import Cell, TableHeader, TableLayout
from groundslab.views.summary import combinations
from groundslab.views.summary.discretization import discretization_section
from groundslab.views.tables.errors import EXTREMES
from groundslab.views.tables.result_tables import table_makers

if TYPE_CHECKING:
    from groundslab.results.results import Results
    from groundslab.views.tables.table import Table

#: Columns whose cells name an item of the case, and the list that it stands in.
ITEMS = {
    "column": "columns", "support": "supports", "strip": "output.strips", "line": "output.lines",
    "point": "output.points", "wall": "walls", "beam": "beams", "core": "cores",
}  # fmt: skip
#: Fields of the plate by what tables call them; a layer of bars stands for what it requires.
FIELDS = {about.label: name for name, about in RANGED_FIELDS.items()} | {
    layer.replace("_", " "): f"required_{layer}" for layer in LAYERS
}
#: Fields of the plate by the columns that hold their values.
FIELDS_OF_HEADS = FIELDS | {head: FIELDS[label] for head, (_, label) in EXTREMES.items()}
#: Columns whose cells name a field.
FIELD_COLUMNS = ("quantity", "layer")

Maker = Callable[[], TableLayout]


def layout_makers(combined: Results) -> dict[str, Maker]:
    """Return the function for each table by the table's name, in the order of the report."""
    makers: dict[str, Maker] = {name: partial(_layout_table, make) for name, make in table_makers(combined).items()}
    entries = combinations.entries(combined)
    solved = [entry.results for entry in entries if entry.results is not None]
    if any(results.constants.k0 for results in solved):
        makers["constants"] = lambda: replace(
            content.list_constants(entries, combined.model.units), title="Constants of the ground"
        )
    if solved:
        makers["mesh"] = lambda: content.layout_section(content.list_sections(combined)[1], combined.model.units)
        makers["steps"] = lambda: replace(content.list_steps(entries), title="Steps of the analysis")
    if any(results.comparison is not None for results in solved):
        makers["errors"] = partial(_list_errors, combined)
    return makers


def table_to_json(name: str, layout: TableLayout) -> dict[str, Any]:
    """Return a table as data for the page; its words are labels and messages, but for names."""
    texts = [head.text for head in layout.heads]
    items = [at for at, text in enumerate(texts) if text in ITEMS]
    named = next((texts.index(text) for text in FIELD_COLUMNS if text in texts), None)
    return {
        "name": name,
        "title": Label(layout.title),
        "heads": [_head_to_json(head, at, texts) for at, head in enumerate(layout.heads)],
        "rows": [[_cell_to_json(*pair) for pair in zip(row, texts, strict=True)] for row in layout.rows],
        "fields": None if named is None else [FIELDS.get(row[named].text) for row in layout.rows],
        "item": {"list": ITEMS[texts[items[0]]], "column": items[0]} if items else None,
        "notes": [Label(note) for note in layout.notes],
    }


def _layout_table(make: Callable[[], Table]) -> TableLayout:
    """Return a table of results as the report prints it, uncut."""
    return table_layout.layout_table(make())


def _list_errors(combined: Results) -> TableLayout:
    """Return the discretization errors of all combinations."""
    parts = {
        results.combination: discretization_section(results) for results in combined.values() if results.comparison
    }
    rows = tuple(
        (Cell(name), *content.layout_row(row, combined.model.units)[:-1])
        for name, section in parts.items()
        for row in section.rows
    )
    heads = table_layout.headers("combination", "value", "symbol", "#error", "unit")
    notes = dict.fromkeys(note for section in parts.values() for note in section.notes)
    layout = TableLayout("Discretization errors", heads, rows, tuple(notes))
    return table_layout.drop_empty_columns(layout)


def _head_to_json(head: TableHeader, at: int, texts: Sequence[str]) -> dict[str, Any]:
    """Return the header of a column, and which columns give the place and the combination of its values."""
    stem = texts[at]
    for start in ("x of the ", "y of the ", "combination of the "):
        stem = stem.removeprefix(start)
    positions = {text: position for position, text in enumerate(texts)}
    return {
        "text": head.text if head.plain else Label(head.text),
        "unit": head.unit,
        "number": head.number,
        "symbol": head.symbol,
        "place": _find_place(stem, positions),
        "combination": positions.get(f"combination of the {stem}", positions.get("combination")),
        "field": FIELDS_OF_HEADS.get(head.text),
    }


def _find_place(stem: str, positions: Mapping[str, int]) -> list[int] | None:
    """Return the columns of x and y of what a column holds: its own, those of the row, or the last ones there are."""
    x_columns = [f"x of the {text.removeprefix('x of the ')}" for text in positions if text.startswith("x of the ")]
    for x in (f"x of the {stem}", "x", "x of it", *reversed(x_columns)):
        y = "y" + x[1:]
        if x in positions and y in positions:
            return [positions[x], positions[y]]
    return None


def _cell_to_json(cell: Cell, head: str) -> str | list[str]:
    """Return a cell: its text alone, or with what is under it and what it is.

    A page reads numbers, and combinations by their names.
    """
    stays = cell.kind == "number" or head.startswith("combination")
    text = cell.text if stays else Label(cell.text)
    plain = cell.kind in ("", "number") and not cell.under
    return text if plain else [text, Label(cell.under), cell.kind]
