"""Reactions as a table states them: by support and load case, in the table's own units, signs and axes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path

from groundslab.case.numbers import find_decimals, parse_number
from groundslab.errors import InputError, Issue
from groundslab.exchange.reactions.cells import Cell, Grid, read_grids
from groundslab.exchange.reactions.headings import BY_CASE, DIMENSIONS, Headings, Role, find_headings, unit_of
from groundslab.model.reactions import Decimals, Reactions
from groundslab.schema.fields import MOST_ISSUES
from groundslab.schema.wording import describe, listed, quote

#: What the first cell of a row with sums begins with.
_SUMS = re.compile(r"\s*(?:sum|total|check|precision|minimum|maximum|max|min|summe|somme|σ|Σ)\b", re.IGNORECASE)
#: Kinds of cases that are combinations or envelopes of others, by the column that says so or by their usual names.
_COMBINED = re.compile(r".*comb|.*envelope|.*spec(?:trum)?\b", re.IGNORECASE)
#: Of these kinds of cases each value is the largest of its own: it has no sign, and no others that act with it.
_UNSIGNED = re.compile(r".*(?:envelope|spec(?:trum|tra)?\b|mod(?:al)?hist|time ?hist|moving)", re.IGNORECASE)
_COMBINED_NAME = re.compile(
    r"(?:comb\w*|envelope|env|uls|sls|gzt|gzg|co|rc|lk|ek)[\s_:.-]*[0-9]*(?:[\s_:.-].*)?", re.IGNORECASE
)
#: What a table has units of, besides coordinates.
KINDS = ("force", "moment")
ZERO = Decimal(0)
#: No force or moment has more.
LARGEST = Decimal("1e15")


@dataclass(frozen=True, slots=True)
class Reaction:
    """What a table states of one support in one load case, 0 where it states nothing.

    Attributes
    ----------
    row : int
        Its row in the file, from 1.
    place : tuple of Decimal or None
        Coordinates in the table's unit, if it has any.
    F_z, M_x, M_y : Decimal
        Vertical force and moments in the table's units, with its signs and names.
    F_x, F_y : Decimal
        Horizontal forces.
    """

    row: int
    support: str
    case: str
    place: tuple[Decimal, Decimal] | None
    F_z: Decimal
    M_x: Decimal = ZERO
    M_y: Decimal = ZERO
    F_x: Decimal = ZERO
    F_y: Decimal = ZERO


@dataclass(frozen=True, slots=True)
class ReactionTable:
    """A table of reactions.

    Attributes
    ----------
    reactions : tuple of Reaction
        In the order of the file.
    combined : frozenset of str
        Cases that are combinations or envelopes of others, which are not loads.
    unsigned : mapping of str to str
        Of cases with largest values, as of response spectra and envelopes, what says so.
    types : mapping of str to str
        What the table says of the type of cases, by their names.
    force, moment, length : str
        The units as they are written here; of what the table does not have, nothing.
    per : str
        Unit of length of forces and moments per length of line supports; nothing if they are resultants.
    name, sheet : str
        File and sheet, the first one for messages.
    remarks : tuple of str
        What was passed over.
    """

    reactions: tuple[Reaction, ...]
    combined: frozenset[str]
    unsigned: Mapping[str, str]
    types: Mapping[str, str]
    force: str
    moment: str
    length: str
    per: str
    name: str
    sheet: str
    remarks: tuple[str, ...]


def read_table(path: str | Path, reading: Reactions) -> ReactionTable:
    """Return the reactions in a file.

    Parameters
    ----------
    path : str or pathlib.Path
        A CSV file or a workbook, one row for each support and case, or one column for each case.
    reading : Reactions
        What the table itself leaves open: sheet, headings, units, the case of a table that names none.

    Raises
    ------
    InputError
        If there is no such table, or if a number in it cannot be read; it lists all issues.
    """
    grids = read_grids(path)
    if reading.sheet and len(grids) > 1:
        sheets = [grid.sheet for grid in grids]
        grids = tuple(grid for grid in grids if grid.sheet == reading.sheet)
        if not grids:
            raise InputError(
                [Issue("sheet", describe(reading.sheet), f"a sheet of {path}: {listed(map(quote, sheets))}")]
            )
    tables = [(grid, headings) for grid in grids if (headings := find_headings(grid, reading.headings, reading.case))]
    if not tables:
        expected = "headings of supports, of load cases and of vertical forces, such as Joint, Case, FZ"
        hint = 'name them: headings = {support = "...", case = "...", F_z = "..."}'
        raise InputError([Issue(str(path), "no table of reactions", expected, hint)])
    if len(tables) > 1:
        names = listed((quote(grid.sheet) for grid, _ in tables), "and")
        raise InputError(
            [Issue(str(path), f"reactions on the sheets {names}", "one of them", 'name it: sheet = "..."')]
        )
    return _read(*tables[0], reading)


def _read(grid: Grid, headings: Headings, reading: Reactions) -> ReactionTable:
    """Return the reactions below headings."""
    used, remarks = _units(grid, headings, reading)
    body = [(number, row) for number, row in enumerate(grid.rows, start=1) if number > headings.first and any(row)]
    numeric = [heading.column for heading in headings.columns if heading.role in DIMENSIONS]
    cells = (row[column] for _, row in body for column in numeric if column < len(row))
    decimals = reading.decimals or find_decimals(cells, grid.commas)
    if decimals is None:
        ambiguous, hint = "numbers whose commas or points may group digits", 'say it: decimals = "point" or "comma"'
        raise InputError([Issue(grid.name, ambiguous, "one way to read them", hint)])
    reader = _RowReader(grid, headings, decimals, reading.case)
    reactions = tuple(reaction for number, row in body for reaction in reader.read(number, row))
    if reader.issues:
        raise InputError(reader.issues[:MOST_ISSUES])
    if not reactions:
        raise InputError([Issue(grid.name, "headings without reactions below", "at least one")])
    if reader.passed:
        remarks.append(f"rows {_numbers(reader.passed)} are sums or have no support, and are left out")
    combined = frozenset(reader.combined)
    return ReactionTable(
        reactions, combined, reader.unsigned, reader.types, *used, grid.name, grid.sheet, tuple(remarks)
    )


def _numbers(rows: Sequence[int]) -> str:
    """Return the first numbers of rows."""
    return ", ".join(map(str, rows[:10])) + (f" and {len(rows) - 10} more" if len(rows) > 10 else "")


def _units(grid: Grid, headings: Headings, reading: Reactions) -> tuple[tuple[str, str, str, str], list[str]]:
    """Return the units of forces, moments and coordinates, of the table or given, and of what length they are per.

    Also remarks on units that differ from what was given or from each other.
    """
    chosen, issues, remarks = list[str](), list[Issue](), list[str]()
    for dimension, reading_unit in (("force", reading.force), ("moment", reading.moment), ("length", reading.length)):
        columns = [heading for heading in headings.columns if DIMENSIONS.get(heading.role) == dimension]
        if dimension == "force":
            columns = list(headings.of(*(("F_z",) if reading.horizontal == "left out" else ("F_x", "F_y", "F_z"))))
        stated = list(dict.fromkeys(heading.unit for heading in columns if heading.unit))
        if len(stated) > 1:
            issues.append(Issue(grid.name, f"{dimension}s in {listed(stated, 'and')}", "one unit"))
        elif columns and not stated and not reading_unit:
            expected = f"units in the headings or below them, such as {headings_example(dimension)}"
            issues.append(Issue(grid.name, f"no unit of {dimension}s", expected, f'give it: {dimension} = "..."'))
        chosen.append((stated or [_given(reading_unit, dimension)])[0] if columns else "")
        if stated and reading_unit and _given(reading_unit, dimension) != stated[0]:
            remarks.append(f"{dimension}s are in {stated[0]}, as the table says, not in {reading_unit}")
    force, per = _split_unit(chosen[0], "force")
    moment, of_moment = _split_unit(chosen[1], "moment")
    if moment and per != of_moment:
        found_units = f"forces in {chosen[0]} and moments in {chosen[1]}"
        issues.append(Issue(grid.name, found_units, "both per length of line supports, or both resultants"))
    if issues:
        raise InputError(issues)
    systems = [unit for unit in (force, moment) if unit]
    if len(systems) == 2 and force not in moment.replace("kNm", "kN m").replace("Nm", "N m").split():
        remarks.append(f"forces are in {force} and moments in {moment}")
    return (force, moment, chosen[2], per), remarks


def _split_unit(unit: str, dimension: str) -> tuple[str, str]:
    """Return a unit of a force or moment, and what it is per: nothing if it is none per length."""
    whole, _, per = unit.rpartition("/")
    return (whole, per) if whole and unit_of(unit, f"{dimension} per length") else (unit, "")


def _given(text: str, dimension: str) -> str:
    """Return a unit that was given, which may be one per length."""
    return unit_of(text, dimension) or (unit_of(text, f"{dimension} per length") if dimension in KINDS else "")


def headings_example(dimension: str) -> str:
    """Return what a heading with a unit looks like."""
    return {"force": "Fz [kN]", "moment": "Mx [kNm]"}.get(dimension, "x [m]")


class _RowReader:
    """Reads row after row; collects issues, rows that were passed over, and cases that are combinations."""

    def __init__(self, grid: Grid, headings: Headings, decimals: Decimals, single: str) -> None:
        """Begin above the first row, of a table of a single case perhaps."""
        self.name, self.decimals, self.single = grid.name, decimals, single
        self.issues: list[Issue] = []
        self.passed: list[int] = []
        self.combined: set[str] = set()
        self.unsigned: dict[str, str] = {}
        self.types: dict[str, str] = {}
        self._support = ""
        self._columns = {heading.role: heading.column for heading in headings.columns}
        self._values = headings.of(*BY_CASE)
        cases = dict.fromkeys(heading.case for heading in self._values)
        sideways = headings.of("F_x", "F_y")
        self._of_case = {
            case: [*(heading for heading in self._values if heading.case == case), *sideways] for case in cases
        }

    def read(self, number: int, row: Sequence[Cell]) -> Iterator[Reaction]:
        """Yield the reactions of a row, several if cases are in columns."""
        support, case = self._names(row)
        filled = any(heading.column < len(row) and row[heading.column] != "" for heading in self._values)
        if not support or any(_SUMS.match(str(cell)) for cell in row[:2]) or not (filled or case):
            self.passed.append(number)
            return
        place = self._place(number, row)
        for name, columns in self._of_case.items():
            if not (whole := name or case):
                hint = 'name the case of the table: case = "..."'
                self._refuse(number, "no load case", "a column with load cases", hint)
                return
            numbers = {heading.role: self._number(number, row, heading.column) for heading in columns}
            if "F_z" not in numbers or not (name or filled):
                self._refuse(number, f"no vertical force of {quote(whole)}", "a number")
            self._note_combined(number, row, whole)
            yield Reaction(number, support, whole, place, numbers.pop("F_z", ZERO), **numbers)

    def _names(self, row: Sequence[Cell]) -> tuple[str, str]:
        """Return support and case; a blank support is that of the row above, as in joined cells."""
        if "support and case" in self._columns:
            support, slash, case = _name(self._cell(row, "support and case")).partition("/")
            return (support.strip(), case.strip()) if slash else ("", "")
        support = _name(self._cell(row, "support"))
        self._support = support or self._support
        case = _name(self._cell(row, "case"))
        return (self._support if support or case else ""), (case or self.single)

    def _place(self, number: int, row: Sequence[Cell]) -> tuple[Decimal, Decimal] | None:
        if self._cell(row, "x") == "" or self._cell(row, "y") == "":
            return None
        return self._number(number, row, self._columns["x"]), self._number(number, row, self._columns["y"])

    def _number(self, number: int, row: Sequence[Cell], column: int) -> Decimal:
        """Return the number in a cell, 0 if there is none, which is an issue unless the cell is blank."""
        cell = row[column] if column < len(row) else ""
        if cell in ("", "-", "—"):
            return ZERO
        value = parse_number(cell, self.decimals)
        if value is None or abs(value) > LARGEST:
            self._refuse(number, describe(cell), "a number", column=column)
            return ZERO
        return value

    def _refuse(self, number: int, found: str, expected: str, hint: str = "", column: int | None = None) -> None:
        where = f"{self.name}, row {number}" + ("" if column is None else f", column {column + 1}")
        self.issues.append(Issue(where, found, expected, hint))

    def _note_combined(self, number: int, row: Sequence[Cell], case: str) -> None:
        kind, step = (str(self._cell(row, role)).strip() for role in ("type", "step"))
        self.types.setdefault(case, kind)
        # envelopes have a step, the largest or the smallest value, of each of which the others are unknown
        stepped = step.lower() in ("max", "min")
        if stepped or _COMBINED.match(kind) or _UNSIGNED.match(kind) or (not kind and _COMBINED_NAME.fullmatch(case)):
            self.combined.add(case)
        if stepped or _UNSIGNED.match(kind):
            said = " ".join(describe(word) for word in (kind, step) if word)
            self.unsigned.setdefault(case, f"row {number}, {said}")

    def _cell(self, row: Sequence[Cell], role: Role) -> Cell:
        column = self._columns.get(role, len(row))
        return row[column] if column < len(row) else ""


def _name(cell: Cell) -> str:
    """Return a name, of a number in a workbook as it is shown, without repeated spaces."""
    if isinstance(cell, float):
        return f"{cell:.12g}"
    return " ".join(cell.split())


def cases_of(reactions: Iterable[Reaction]) -> tuple[str, ...]:
    """Return the load cases of reactions in their order."""
    return tuple(dict.fromkeys(reaction.case for reaction in reactions))
