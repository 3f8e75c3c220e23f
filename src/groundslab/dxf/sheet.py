"""The sheet: path, unit, faults and report while a drawing is read."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, NoReturn

from groundslab.dxf.curves import Point
from groundslab.dxf.drawing import ReportLine
from groundslab.dxf.words import named
from groundslab.errors import Fault, InputError

if TYPE_CHECKING:
    from ezdxf.math import Vec3

CLOSE = 1e-6  # ends so near, as a part of the drawing's size, are one point
LARGEST = 100_000  # entities
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
    faults: list[Fault] = field(default_factory=list)
    report: list[ReportLine] = field(default_factory=list)

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

    def fault(self, sources: Sequence[Source], point: Point | None, got: str, expected: str, mend: str = "") -> None:
        """Add a fault with file, layer, entities and place."""
        names = " and ".join(dict.fromkeys(f"{source.entity} {source.handle}".strip() for source in sources[:3]))
        where = f"{self.path}, layer {named(sources[0].layer)}, {names}"
        if len(sources) > 3:
            where += f" and {len(sources) - 3} more"
        self.faults.append(Fault(f"{where} at {self.place(point)}" if point else where, got, expected, mend))


def stop(sheet: Sheet, got: str, expected: str, mend: str = "") -> NoReturn:
    """Raise the error that ends the reading at once."""
    raise InputError([*sheet.faults, Fault(sheet.path, got, expected, mend)])
