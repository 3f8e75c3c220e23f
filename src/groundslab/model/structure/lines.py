"""Lines in plan on which something stands: straight pieces and arcs one after the other, or the edge of a shape."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated

import numpy as np

from groundslab.geometry.plan import LARGEST_BULGE, Segment, make_segments
from groundslab.model.shapes import BULGE, AnyShape, Place, Shape
from groundslab.schema.fields import ListOf
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.section_fields import Table

if TYPE_CHECKING:
    from shapely import LineString, Polygon

#: Lines shorter than this [m] go nowhere.
NO_LENGTH = 1e-9
#: Places along a line closer than this share of its length are one.
SAME = 1e-9

Points = tuple[tuple[float, float], ...]
#: A line: its points, and the bulges of its pieces, which are straight where they lack one.
Path = tuple[Points, tuple[float, ...]]

LinePoints = Annotated[Points | None, ListOf(Place, "x, y", "the line's points, in order")]
LineBulges = Annotated[
    tuple[float, ...],
    ListOf(
        BULGE,
        "b",
        "for the piece after each point, tan of a quarter of its arc's angle, positive if counterclockwise; 0 for a "
        "straight piece",
        least=0,
    ),
]
LineShape = Annotated[Shape | None, Table("closed curve along which it runs, such as a circle; not with points")]


def check_line(
    points: Points | None, shape: AnyShape | None, along: Mapping[str, object], hint: str, edge: str = "loaded"
) -> Iterator[RelativeIssue]:
    """Find a line that is given by neither points nor a shape, or by both; `along` holds what only points can have."""
    if points is None and shape is None:
        yield RelativeIssue(("points",), "nothing", f"the line's points, or a shape whose edge is {edge}")
    if shape is None:
        return
    for name, values in {"points": points, **along}.items():
        if values is not None:
            yield RelativeIssue((name,), f"{name} together with a shape", "one of them", hint)


def check_line_length(points: Points | None, bulges: tuple[float, ...]) -> Iterator[RelativeIssue]:
    """Find lines of less than two points, pieces without length, and more bulges than pieces."""
    if points is None:
        return
    if len(points) < 2:
        yield RelativeIssue(("points",), f"{len(points)} point", "at least two")
    elif len(bulges) >= len(points):
        expected = f"at most {len(points) - 1}, one for each of the line's pieces"
        yield RelativeIssue(("bulges",), f"{len(bulges)} bulges", expected)
    for position, (a, b) in enumerate(itertools.pairwise(points), start=1):
        if math.dist(a, b) < NO_LENGTH:
            repeated = f"({b[0]!r}, {b[1]!r}) m twice"
            yield RelativeIssue(("points", position), repeated, "another place than the one before")


def flat_line(edges: tuple[Segment, ...], chord: float) -> LineString:
    """Return a line of straight pieces and arcs, arcs as chords at most so far off [m]."""
    from shapely import LineString

    places = [edge.at(np.arange(edge.chords(chord)) / edge.chords(chord)) for edge in edges]
    return LineString(np.concatenate([*places, [edges[-1].end]]))


def line_area(axis: LineString, width: float, *, closed: bool) -> Polygon:
    """Return the area of a width [m] about an axis, its corners mitered."""
    from shapely import LinearRing

    line = LinearRing(axis.coords) if closed else axis
    area: Polygon = line.buffer(width / 2, cap_style="flat", join_style="mitre")
    return area


def line_segments(points: Points | None, bulges: tuple[float, ...], shape: AnyShape | None) -> tuple[Segment, ...]:
    """Return the straight pieces and arcs of a line, one after the other."""
    if shape is not None:
        return shape.ring().segments()
    assert points is not None
    return make_segments(points, bulges)


def part_of_line(edges: tuple[Segment, ...], start: float, end: float) -> Path:
    """Return the part of a line between two ways along it [m]: its points, and the bulges of its pieces."""
    points, bulges, low = list[tuple[float, float]](), list[float](), 0.0
    for edge in edges:
        a, b = np.clip((np.array([start, end]) - low) / edge.length, 0.0, 1.0)
        low += edge.length
        # its own ends exactly
        a, b = 0.0 if a < SAME else a, 1.0 if b > 1 - SAME else b
        if b - a <= SAME:
            continue
        places = [(float(x), float(y)) for x, y in edge.at(np.array([a, b]))]
        points += places if not points else places[1:]
        bulge = math.tan((b - a) * edge.sweep / 4)
        bulges.append(min(max(bulge, -LARGEST_BULGE), LARGEST_BULGE))
    return tuple(points), tuple(bulges) if any(bulges) else ()
