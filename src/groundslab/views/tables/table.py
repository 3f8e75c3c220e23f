"""A light table: named columns with units, as CSV text and as a pandas.DataFrame."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from groundslab.messages import Message, Name, words_in
from groundslab.optional import import_optional
from groundslab.schema.wording import as_cell
from groundslab.unit_systems import System, unit_in
from groundslab.units import coordinate

if TYPE_CHECKING:
    import pandas as pd

#: What a table holds: words, numbers, or None where there is nothing to say.
Cell = str | float | int | None
#: Name and unit of a column; no unit for words, counts and ratios.
Head = tuple[str, str]

#: Columns of sentences, in which quantities may stand.
WORDS = ("in words", "outcome", "remark")
#: Significant digits of numbers in CSV files.
DIGITS = 7
#: Decimals of lengths in meters, at least.
DECIMALS = 4


@dataclass(frozen=True, slots=True)
class Column:
    """A column of a table: its name, the unit of its values (may be empty), the values from the top downwards.

    One of discretization errors names the column whose values have them.
    """

    name: str
    unit: str
    values: tuple[Cell, ...]
    error_of: str = ""

    @property
    def header(self) -> str:
        """Return name and unit, as in "settlement w [mm]"."""
        return Message("{name} [{unit}]", name=Name(self.name), unit=self.unit) if self.unit else self.name


@dataclass(frozen=True, slots=True)
class Table:
    """Columns of one length under names of their own; the notes say what a reader must know about them.

    Values `by_row`, columns by their names, and errors of these are in the unit that the column "unit" names.
    """

    name: str
    title: str
    columns: tuple[Column, ...]
    notes: tuple[str, ...] = ()
    by_row: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Refuse columns of different lengths and names that stand twice."""
        if len({len(column.values) for column in self.columns}) > 1:
            raise ValueError(f"the columns of {self.name} differ in length")
        if len({column.name for column in self.columns}) < len(self.columns):
            raise ValueError(f"a column's name appears twice in {self.name}")

    def __len__(self) -> int:
        """Return the number of rows."""
        return len(self.columns[0].values) if self.columns else 0

    def __getitem__(self, name: str) -> tuple[Cell, ...]:
        """Return the values of a column by its name without unit; KeyError if there is none."""
        for column in self.columns:
            if column.name == name:
                return column.values
        raise KeyError(name)

    def rows(self) -> list[tuple[Cell, ...]]:
        """Return the values row by row."""
        return list(zip(*(column.values for column in self.columns), strict=True))

    def csv(self) -> str:
        """Return the table as CSV: a header line with units, then one line a row.

        Numbers have seven digits, coordinates of national grids more, to tenths of millimeters.
        """
        header, units = [column.header for column in self.columns], [column.unit for column in self.columns]
        rows = ([_written(*cell) for cell in zip(row, units, strict=True)] for row in self.rows())
        return "".join(map(_line, [header, *rows]))

    def frame(self) -> pd.DataFrame:
        """Return the table as a pandas.DataFrame with all digits, in the units of the table, which are not SI.

        Its columns are called by name and unit, as in "settlement [mm]"; `attrs["units"]` has the unit of each.
        """
        pd = import_optional("pandas", "which makes a DataFrame of a table", "tables", ".csv() does without it")
        frame = pd.DataFrame({column.header: pd.Series(_alike(column.values)) for column in self.columns})
        frame.attrs["units"] = {column.header: column.unit for column in self.columns}
        return frame


def table_of(
    name: str,
    title: str,
    heads: Sequence[Head],
    rows: Iterable[Sequence[Any]],
    notes: Sequence[str] = (),
    by_row: Sequence[str] = (),
) -> Table:
    """Return a table from its rows; NumPy's numbers become Python's, lengths in meters are rounded to nanometers."""
    plain = [[_plain(value, unit) for value, (_, unit) in zip(row, heads, strict=True)] for row in rows]
    columns = list(zip(*plain, strict=True)) if plain else [()] * len(heads)
    named_columns = (Column(name, unit, values) for (name, unit), values in zip(heads, columns, strict=True))
    return Table(name, title, tuple(named_columns), tuple(notes), tuple(by_row))


def in_units(table: Table, system: System) -> Table:
    """Return a table with its values, the words in its cells and its notes in the units of a system.

    Names, formulas and what stands in the unit of its row without being told `by_row` stay as they are.
    """
    if system == "SI":
        return table
    factors = [unit_in(str(unit), system)[1] for unit in table["unit"]] if table.by_row else []
    columns = []
    for column in table.columns:
        unit, factor = unit_in(column.unit, system)
        values: tuple[Cell, ...]
        if column.name in table.by_row or column.error_of in table.by_row:
            values = tuple(map(_times, column.values, factors))
        elif column.name == "unit" and table.by_row:
            values = tuple(unit_in(str(value), system)[0] if value else value for value in column.values)
        elif column.name in WORDS:
            values = tuple(words_in(value, system) if isinstance(value, str) else value for value in column.values)
        else:
            values = tuple(_times(value, factor) for value in column.values)
        columns.append(replace(column, unit=unit, values=values))
    notes = tuple(words_in(note, system) for note in table.notes)
    return replace(table, columns=tuple(columns), notes=notes)


def _times(value: Cell, factor: float) -> Cell:
    """Return a number times a factor; words and gaps stay."""
    return value * factor if isinstance(value, float) and factor != 1.0 else value


def _plain(value: Any, unit: str) -> Cell:
    """Return a cell as one of Python's own types, no zero of it negative."""
    plain: Cell = value.item() if hasattr(value, "item") else value
    if not isinstance(plain, float):
        return plain
    return coordinate(plain) if unit == "m" else plain + 0.0


def _written(value: Cell, unit: str) -> str:
    """Return a cell as text for a CSV file."""
    if value is None:
        return ""
    if not isinstance(value, float):
        return as_cell(value) if isinstance(value, str) else str(value)
    whole = len(str(int(abs(value)))) if unit in ("m", "ft") else 0
    return f"{value:.{max(DIGITS, whole + DECIMALS)}g}"


def _line(cells: list[str]) -> str:
    """Return a line of a CSV file."""
    text = io.StringIO()
    # with this end of lines the writer quotes both of its letters, of which readers take either for an end
    end = "\r\n"
    csv.writer(text, lineterminator=end).writerow(cells)
    return text.getvalue().removesuffix(end) + "\n"


def _alike(values: tuple[Cell, ...]) -> Any:
    """Return values for pandas: numbers with gaps as floats, a gap being no number; all else as it is."""
    gaps = any(value is None for value in values)
    if gaps and not any(isinstance(value, str) for value in values):
        return [float("nan") if value is None else value for value in values]
    return list(values)
