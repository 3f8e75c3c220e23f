"""The sheet: path, unit, faults and report while a drawing is read."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, NoReturn

from groundslab.case.dxf.drawing import ReportLine
from groundslab.case.dxf.words import named
from groundslab.errors import InputError, Issue
from groundslab.geometry.bulges import Point

if TYPE_CHECKING:
    from ezdxf.math import Vec3

CLOSE = 1e-6  # ends so near, as a part of the drawing's size, are one point
LARGEST = 50_000  # entities on the layers that are read
MOST_FAULTS = 100  # that are told
MOST_EDGES = 50_000  # of all curves
MOST_PAIRS = 250_000  # of edges that are compared
MOST_BESIDE = 2_000_000  # edges that are looked at to see what lies inside what
FARTHEST = 1e9  # m
DOUBLE = "it lies on top of what was taken already"


@dataclass(frozen=True, slots=True)
class Source:
    """Where something comes from: layer and name as drawn, handle (of the outermost block reference)."""

    layer: str
    entity: str
    handle: str


@dataclass(slots=True)
class Sheet:
    """What is known and found while a drawing is read."""

    path: str
    unit: str = "units"
    scale: Fraction = Fraction(1, 1000)
    issues: list[Issue] = field(default_factory=list)
    report: list[ReportLine] = field(default_factory=list)
    more: int = 0  # faults that are not told
    spent: Counter[str] = field(default_factory=Counter)  # work done so far, by what it was

    def metres(self, value: float) -> float:
        """Return a length of the drawing in metres, rounded once if it can be."""
        return value * self.scale.numerator / self.scale.denominator

    def point(self, vector: Vec3) -> Point:
        """Return a point of the drawing in metres."""
        return self.metres(vector.x), self.metres(vector.y)

    def shown(self, length: float) -> str:
        """Return a length in the drawing's unit, as it is seen there."""
        return f"{float(length / self.scale):.6g} {self.unit}"

    def place(self, point: Point) -> str:
        """Return a place as it is seen in the drawing."""
        x, y = (f"{round(float(value / self.scale), 10) + 0.0:.10g}" for value in point)
        return f"({x}, {y}) {self.unit}"

    def tell(self, source: Source, taken: bool, why: str) -> None:
        """Add a line to the report."""
        self.report.append(ReportLine(source.layer, source.entity, source.handle, taken, why))

    def issue(self, sources: Sequence[Source], point: Point | None, found: str, expected: str, hint: str = "") -> None:
        """Add a fault with file, layer, entities and place."""
        names = " and ".join(dict.fromkeys(f"{source.entity} {source.handle}".strip() for source in sources[:3]))
        where = f"{self.path}, layer {named(sources[0].layer)}, {names}"
        if len(sources) > 3:
            where += f" and {len(sources) - 3} more"
        self.add(Issue(f"{where} at {self.place(point)}" if point else where, found, expected, hint))

    def add(self, issue: Issue) -> None:
        """Add a fault; of very many only the first are kept."""
        if len(self.issues) < MOST_FAULTS:
            self.issues.append(issue)
        else:
            self.more += 1

    def spend(self, count: int, limit: int, what: str, hint: str = "") -> None:
        """Count work before it is done; raises InputError where a drawing wants more of one kind than the limit."""
        self.spent[what] += count
        if self.spent[what] > limit:
            stop(self, f"more than {limit:,} {what}", "fewer", hint or "leave only what is needed on these layers")

    def near(self, count: int) -> None:
        """Count pairs of edges that are about to be compared."""
        self.spend(count, MOST_PAIRS, "pairs of edges near each other", "draw curves with fewer edges")

    def beside(self, count: int) -> None:
        """Count edges beside points, of which is about to be seen what lies inside them."""
        self.spend(count, MOST_BESIDE, "edges beside points", "draw fewer curves, or curves with fewer edges")

    def refused(self) -> InputError:
        """Return the error with all faults."""
        more = [Issue(self.path, f"{self.more:,} more faults", "none")] if self.more else []
        return InputError([*self.issues, *more])


def stop(sheet: Sheet, found: str, expected: str, hint: str = "") -> NoReturn:
    """Raise the error that ends the reading at once."""
    raise InputError([*sheet.issues, Issue(sheet.path, found, expected, hint)])
