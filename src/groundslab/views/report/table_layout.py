"""What the report prints in rows and columns: every cell a text by now, with what it is."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from itertools import pairwise, takewhile
from operator import itemgetter
from typing import ClassVar, Literal

from groundslab.messages import Message
from groundslab.units import format_number
from groundslab.views.summary.terminal import error_text
from groundslab.views.tables.table import Cell as RawCell
from groundslab.views.tables.table import Table

Kind = Literal["", "number", "good", "bad", "muted", "symbol", "words"]

#: More columns than these do not fit on paper.
MOST_COLUMNS = 14
#: Of the tables in LONG those with more rows are whole in the appendix alone, and folded there on the screen.
MOST_ROWS = 24
LONG = {
    "acting", "extremes", "envelope", "points", "soil", "lines", "strips", "supports", "columns", "pile_punching",
    "wall_punching", "zone_punching", "shear_reinforcement", "support_moments", "bending_schedule",
}  # fmt: skip
#: Tables that have no extremes, or whose extremes are in other parts of the report.
ELSEWHERE = {"acting", "extremes", "envelope", "columns", "shear_reinforcement", "support_moments"}
#: Of these the sums stand there instead: rows without what the first column names.
SUMMED = {"bending_schedule"}
#: Rows of a grid that are printed into a file at all; a table of more is read from its CSV file.
MOST_IN_FILE = 3000

#: What is said of the errors in a table.
ERRORS = "Below each value: its estimated discretization error, as a share of it."

#: So many columns at the left of a table say which row it is, where numbers are among them or words are not.
KEYS = {
    "combinations": 1, "points": 4, "soil": 5, "lines": 6, "strips": 5, "columns": 2, "column_envelope": 2,
    "reinforcement": 1, "support_moments": 2,
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class TableHeader:
    """What stands above a column: words, a symbol, a unit; numbers stand at the right.

    Underscores in words make subscripts, but not in plain ones, which are a user's.
    """

    text: str
    unit: str = ""
    number: bool = False
    symbol: str = ""
    plain: bool = False


def headers(*texts: str) -> tuple[TableHeader, ...]:
    """Return headers of words alone; those of numbers are marked by "#" before the words."""
    return tuple(TableHeader(text.removeprefix("#"), number=text.startswith("#")) for text in texts)


@dataclass(frozen=True, slots=True)
class Cell:
    """A text and what it is: a number, a verdict, an aside, a symbol, or words of ours that hold symbols.

    What is under it stands small on a line below.
    """

    text: str
    kind: Kind = ""
    under: str = ""


@dataclass(frozen=True, slots=True)
class TableLayout:
    """Rows under heads; the notes say what a reader must know."""

    title: str
    heads: tuple[TableHeader, ...]
    rows: tuple[tuple[Cell, ...], ...]
    notes: tuple[str, ...] = ()
    folded: bool = False  # whether it is too long to stand open on the screen
    block: ClassVar = "table"

    @property
    def length(self) -> str:
        """Return how many rows it has, in words."""
        return Message("{count} rows", count=len(self.rows))


def drop_empty_columns(grid: TableLayout) -> TableLayout:
    """Return a grid without the columns in which nothing stands."""
    return _select_columns(grid, [i for i in range(len(grid.heads)) if any(row[i].text for row in grid.rows)])


def _select_columns(grid: TableLayout, at: list[int]) -> TableLayout:
    """Return a grid with the columns at some places alone."""
    rows = tuple(tuple(row[i] for i in at) for row in grid.rows)
    return replace(grid, heads=tuple(grid.heads[i] for i in at), rows=rows)


def layout_table(table: Table) -> TableLayout:
    """Return a table with its numbers as the summary prints them, discretization errors under their values."""
    shown, errors = [column for column in table.columns if not column.error_of], errors_of(table)
    heads = tuple(
        TableHeader(column.name, column.unit, any(isinstance(value, int | float) for value in column.values))
        for column in shown
    )
    columns = [
        [_cell(*pair, column.name) for pair in zip(column.values, errors[column.name], strict=True)] for column in shown
    ]
    rows = tuple(zip(*columns, strict=True))
    notes = (*table.notes, ERRORS) if len(shown) < len(table.columns) else table.notes
    return TableLayout(table.title, heads, rows, notes, folded=is_long(table))


def is_long(table: Table) -> bool:
    """Return whether a table is too long for the text."""
    return table.name in LONG and len(table) > MOST_ROWS


def errors_of(table: Table) -> dict[str, tuple[RawCell, ...]]:
    """Return the discretization errors of each column's values by its name; None where there is none."""
    nothing: tuple[RawCell, ...] = (None,) * len(table)
    errors = {column.error_of: column.values for column in table.columns if column.error_of}
    return {column.name: errors.get(column.name, nothing) for column in table.columns}


def summarize_table(table: Table) -> TableLayout | None:
    """Return the extremes of each quantity along what a long table lists, over all combinations.

    The second column says of what a row is; what stands at the left of the quantities, such as a place, is no quantity,
    and a direction has no extremes.
    """
    keys = keys_of(table)
    if table.name in ELSEWHERE or not is_long(table):
        return None
    if table.name in SUMMED:
        return _sums_of(table)
    combination = table.columns[0].values
    name = table.columns[1].values
    errors = errors_of(table)
    along = next((column for column in table.columns[2:keys] if column.name == "s"), None)
    rows = []
    for item in dict.fromkeys(name):
        at = [i for i, row_name in enumerate(name) if row_name == item]
        for column in (column for column in table.columns[keys:] if column.unit != "deg" and not column.error_of):
            entries = [(value, i) for i in at if isinstance(value := column.values[i], float)]
            if not entries:
                continue
            row = [Cell(str(item)), Cell(column.name, "words"), Cell(column.unit)]
            for value, i in (min(entries, key=itemgetter(0)), max(entries, key=itemgetter(0))):
                place = [] if along is None else [_cell(along.values[i])]
                row += [_cell(value, errors[column.name][i]), *place, Cell(str(combination[i]))]
            rows.append(tuple(row))
    s = [] if along is None else [TableHeader("s", along.unit, number=True)]
    (least, greatest), (combined,) = headers("#least", "#greatest"), headers("combination")
    heads = headers(table.columns[1].name, "quantity", "unit")
    heads = (*heads, least, *s, combined, greatest, *s, combined)
    return TableLayout("", heads, tuple(rows), ("Extremes over all combinations.",))


def _sums_of(table: Table) -> TableLayout:
    """Return the rows of sums of a table."""
    at = [i for i, first in enumerate(table.columns[0].values) if first is None]
    columns = tuple(replace(column, values=tuple(column.values[i] for i in at)) for column in table.columns)
    return drop_empty_columns(layout_table(replace(table, title="", columns=columns, notes=())))


def keys_of(table: Table) -> int:
    """Return how many columns at the left say which row it is: all of words up to the first one of numbers."""
    words = (not any(isinstance(value, int | float) for value in column.values) for column in table.columns)
    return KEYS.get(table.name) or sum(1 for _ in takewhile(bool, words))


def split_columns(grid: TableLayout, keys: int) -> list[TableLayout]:
    """Return a grid cut into such as fit on paper; the columns at the left that say which row it is stand in each."""
    others = len(grid.heads) - keys
    count = -(-others // max(1, MOST_COLUMNS - keys))
    cuts = [keys + others * n // count for n in range(count + 1)] if count else []
    parts = []
    for n, (first, last) in enumerate(pairwise(cuts)):
        at = [*range(keys), *range(first, last)]
        title, notes = grid.title if n == 0 else "", grid.notes if n == count - 1 else ()
        parts.append(replace(_select_columns(grid, at), title=title, notes=notes))
    return parts or [grid]


def _cell(value: RawCell, error: RawCell = None, column: str = "") -> Cell:
    """Return a cell with its discretization error, if it has one, under it."""
    if isinstance(value, str):
        # names of quantities and symbols are ours, all other words may be the case's
        return Cell(value, "words" if column in ("quantity", "symbol") else "")
    if value is None:
        return Cell("")
    under = error_text(error, value) if isinstance(error, float) else ""
    return Cell(str(value) if isinstance(value, int) else format_number(value), "number", under)


GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "eta": "η", "kappa": "κ", "nu": "ν", "psi": "ψ", "phi": "φ", "rho": "ρ",
    "mu": "μ", "omega": "ω", "sigma": "σ", "lambda": "λ", "delta": "δ", "eps": "ε", "epsilon": "ε", "theta": "θ",
    "tau": "τ", "dT": "ΔT", "Delta": "Δ",
}  # fmt: skip
_SYMBOL = re.compile(r"(?<![\w])([A-Za-z]+)(?:_([A-Za-z0-9]+))?(?![\w])")


def split_symbol(symbol: str) -> list[tuple[str, str]]:
    """Return a symbol such as "gamma_c" or "q_x, q_y" as pairs of text and subscript, Greek letters as such."""
    pieces: list[tuple[str, str]] = []
    end = 0
    for match in _SYMBOL.finditer(symbol):
        pieces.append((symbol[end : match.start()] + GREEK.get(match[1], match[1]), match[2] or ""))
        end = match.end()
    return [*pieces, (symbol[end:], "")] if symbol[end:] else pieces


def split_words(words: str) -> list[tuple[str, str]]:
    """Return words in which symbols have an underscore, such as "moment m_x", as pairs of text and subscript."""
    pieces: list[tuple[str, str]] = []
    for word in re.split(r"(\s+)", words):
        plain = re.fullmatch(r"([|(]?)([A-Za-z]+)_([A-Za-z0-9]+(?:,[A-Za-z0-9]+)?)([|),;:.]?)", word)
        if plain is None:
            pieces.append((word, ""))
        else:
            pieces += [(plain[1] + GREEK.get(plain[2], plain[2]), plain[3]), (plain[4], "")]
    return pieces
