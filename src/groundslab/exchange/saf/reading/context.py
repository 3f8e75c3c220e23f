"""What is known and found while a file is read: units, axes, nodes, issues, and what became of each object."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from decimal import Decimal

from groundslab.case.numbers import parse_number, readings, why_unclear
from groundslab.errors import InputError, Issue
from groundslab.exchange.report import ReportLine
from groundslab.exchange.saf.reading.workbook import Row, cell_text
from groundslab.exchange.saf.units import to_si, unit_of
from groundslab.model.reactions import Decimals
from groundslab.schema.wording import describe, listed

Vector = tuple[float, float, float]

MOST_ISSUES = 100  # that are listed
#: Numbers of a file are smaller than this, whatever they mean.
LARGEST = 1e15
#: Places of the structure lie no further off than this [m].
FARTHEST = 1e9


class RowFault(Exception):
    """A row cannot be read: what is wrong in which column."""

    def __init__(self, column: str, found: str, expected: str, hint: str = "") -> None:
        super().__init__(column, found, expected, hint)
        self.column, self.found, self.expected, self.hint = column, found, expected, hint


#: Plan x, plan y and up in the axes of a file, by its vertical axis; all are right-handed.
AXES: dict[str, tuple[Vector, Vector, Vector]] = {
    "z vertical": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "minus z vertical": ((1, 0, 0), (0, -1, 0), (0, 0, -1)),
    "x vertical": ((0, 1, 0), (0, 0, 1), (1, 0, 0)),
    "minus x vertical": ((0, 1, 0), (0, 0, -1), (-1, 0, 0)),
    "y vertical": ((0, 0, 1), (1, 0, 0), (0, 1, 0)),
    "minus y vertical": ((0, 0, 1), (-1, 0, 0), (0, -1, 0)),
}


def dot(a: Vector, b: Vector) -> float:
    """Return a . b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Return a x b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@dataclass(slots=True)
class ReadContext:
    """What is known and found while a file is read."""

    path: str
    sheets: dict[str, list[Row]]
    imperial: bool = False
    axes: tuple[Vector, Vector, Vector] = AXES["z vertical"]
    issues: list[Issue] = field(default_factory=list)
    report: list[ReportLine] = field(default_factory=list)
    node_rows: dict[str, Row] = field(default_factory=dict)
    decimals: Decimals | None = None

    def rows(self, sheet: str) -> list[Row]:
        """Return the rows of a sheet, none if there is no such sheet."""
        return self.sheets.get(sheet, [])

    @contextmanager
    def reading(self, row: Row) -> Iterator[None]:
        """Turn what is wrong in a row into issues, and go on."""
        try:
            yield
        except RowFault as fault:
            column = f", {fault.column}" if fault.column else ""
            self.add(Issue(f"{self.where(row)}{column}", fault.found, fault.expected, fault.hint))
        except InputError as error:
            for issue in error.issues:
                self.add(Issue(f"{self.where(row)}, {issue.location}", issue.found, issue.expected, issue.hint))

    def where(self, row: Row) -> str:
        """Return the place of a row for messages."""
        name = f" ({describe(row.name)})" if row.name else ""
        return f"{self.path}, sheet {row.sheet}, row {row.number}{name}"

    def add(self, issue: Issue) -> None:
        """Add an issue; of very many only the first are kept."""
        if len(self.issues) < MOST_ISSUES:
            self.issues.append(issue)

    def take(self, row: Row, what: str) -> None:
        """Report a row as taken."""
        self.report.append(ReportLine(row.sheet, row.name or f"row {row.number}", True, what))

    def leave(self, row: Row, why: str) -> None:
        """Report a row as left out."""
        self.report.append(ReportLine(row.sheet, row.name or f"row {row.number}", False, why))

    def note(self, row: Row | None, why: str, sheet: str = "") -> None:
        """Report a note on a row, or on a whole sheet."""
        name = "" if row is None else row.name or f"row {row.number}"
        self.report.append(ReportLine(sheet if row is None else row.sheet, name, None, why))

    def number(self, row: Row, column: str, quantity: str, default: float | None = None) -> float:
        """Return the number in a column in SI units; without one the default, or a fault if there is none."""
        value = row.cells.get(column)
        if value is None or cell_text(value) == "":
            if default is None:
                raise RowFault(column, "nothing", f"a number in {unit_of(quantity, self.imperial) or 'figures'}")
            return default
        self._require_unit(row, column, quantity)
        return to_si(self._parse(value, column), quantity, self.imperial)

    def numbers(self, row: Row, column: str, quantity: str) -> list[float]:
        """Return the numbers in a column, divided by semicolons, in SI units."""
        self._require_unit(row, column, quantity)
        return [to_si(self._parse(part, column), quantity, self.imperial) for part in texts(row, column)]

    def _parse(self, value: object, column: str) -> float:
        """Return the number that a cell says; raises RowFault."""
        said = str(value)
        number: float | Decimal | None
        if isinstance(value, int | float) and not isinstance(value, bool):
            number = value
        else:
            number = parse_number(said, self.decimals) if self.decimals else None
            if number is None and (unclear := why_unclear(said)):
                hint = f"{unclear}: make the cell a number"
                raise RowFault(column, describe(said), "one way to read it", hint)
            number = next(iter(readings(said)), None) if number is None else number
        if number is None or not -LARGEST <= number <= LARGEST:
            raise RowFault(column, describe(said), "a number")
        return float(number)

    def _require_unit(self, row: Row, column: str, quantity: str) -> None:
        """Raise RowFault where a heading names a unit of the other system, or any other one."""
        unit, expected = row.units.get(column, ""), unit_of(quantity, self.imperial)
        if unit and expected and unit.lower() != expected.lower():
            system = "Imperial" if self.imperial else "Metric"
            raise RowFault(column, f"the unit {describe(unit)}", f"{expected}, as the system of units is {system}")

    def node(self, name: str) -> Vector:
        """Return the place of a node: x and y in plan, and its height [m]; raises RowFault."""
        row = self.node_rows.get(name)
        if row is None:
            raise RowFault("nodes", f"the node {describe(name)}", "a node of sheet StructuralPointConnection")
        place = tuple(self.number(row, f"coordinate{axis}", "length") for axis in "xyz")
        return self.turned((place[0], place[1], place[2]))

    def turned(self, vector: Vector) -> Vector:
        """Return a place or vector of the file as x and y in plan, and up."""
        x, y, up = (dot(vector, axis) + 0.0 for axis in self.axes)
        if max(abs(x), abs(y), abs(up)) > FARTHEST:
            raise RowFault("", "a place further off than a million kilometers", "coordinates of a structure")
        return x, y, up

    @property
    def upwards(self) -> float:
        """Return 1 if the vertical axis of the file goes up, -1 if it goes down."""
        return sum(self.axes[2])


def texts(row: Row, column: str) -> list[str]:
    """Return the texts in a column, divided by semicolons."""
    return [part.strip() for part in text(row, column).split(";") if part.strip()]


def text(row: Row, column: str) -> str:
    """Return the text in a column, nothing if there is none."""
    return cell_text(row.cells.get(column))


def word(row: Row, column: str, allowed: tuple[str, ...] = (), default: str = "") -> str:
    """Return the word in a column in lower case; raises RowFault for any other than those known."""
    said = " ".join(text(row, column).lower().replace("-", " ").split()) or default
    if allowed and said not in allowed:
        raise RowFault(column, describe(said) if said else "nothing", listed(list(allowed)))
    return said
