"""What comes out of a drawing, in metres, and what became of each of its entities."""

from __future__ import annotations

from dataclasses import dataclass

from groundslab.geometry.bulges import Curve, Point


@dataclass(frozen=True, slots=True)
class PointMark:
    """A point load: place [m], value [N] (None if the drawing has none), and what is written beside it."""

    x: float
    y: float
    value: float | None
    text: str


@dataclass(frozen=True, slots=True)
class LineMark:
    """A line load: points [m] and the bulge of the edge after each, value [N/m] or None, what is written beside it."""

    points: tuple[Point, ...]
    bulges: tuple[float, ...]  # one less than points if it is open
    value: float | None
    text: str

    @property
    def closed(self) -> bool:
        """Return whether the last point is joined to the first."""
        return len(self.bulges) == len(self.points)


@dataclass(frozen=True, slots=True)
class AreaMark:
    """An area load: its edge, the edges of its holes, value [Pa] or None, what is written beside it."""

    curve: Curve
    holes: tuple[Curve, ...]
    value: float | None
    text: str


@dataclass(frozen=True, slots=True)
class ReportLine:
    """What became of one entity; a note on a whole layer or on the header has LAYER or HEADER for its entity."""

    layer: str
    entity: str
    handle: str
    taken: bool
    why: str


@dataclass(frozen=True, slots=True)
class Drawing:
    """What was taken from a drawing, in metres; ``scale`` is the size of its ``unit`` in metres."""

    outline: Curve
    openings: tuple[Curve, ...]
    zones: tuple[Curve, ...]
    columns: tuple[Curve | Point, ...]
    point_loads: tuple[PointMark, ...]
    line_loads: tuple[LineMark, ...]
    area_loads: tuple[AreaMark, ...]
    report: tuple[ReportLine, ...]
    unit: str
    scale: float
