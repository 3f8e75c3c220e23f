"""Drawings made to cost more than they say: short texts of DXF that unfold, crowd or reach too far."""

from __future__ import annotations

import math
from collections.abc import Callable

Pairs = list[tuple[int, object]]

#: What stands before the pairs of an entity, by its name.
SUBCLASSES = {
    "LWPOLYLINE": "AcDbPolyline", "LINE": "AcDbLine", "CIRCLE": "AcDbCircle", "POINT": "AcDbPoint",
    "TEXT": "AcDbText", "MTEXT": "AcDbMText", "INSERT": "AcDbBlockReference", "SPLINE": "AcDbSpline",
    "ELLIPSE": "AcDbEllipse", "BLOCK": "AcDbBlockBegin", "ENDBLK": "AcDbBlockEnd",
}  # fmt: skip


def document(entities: Pairs, blocks: Pairs | None = None, outline: bool = True) -> str:
    """Return the text of a drawing in metres, with a square of 2 km for the outline."""
    head = [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"), (70, 6), (0, "ENDSEC")]
    inside = [(0, "SECTION"), (2, "BLOCKS"), *blocks, (0, "ENDSEC")] if blocks else []
    square = polyline([(-1e3, -1e3, 0), (1e3, -1e3, 0), (1e3, 1e3, 0), (-1e3, 1e3, 0)]) if outline else []
    lines, kind = [], None
    for code, value in (
        *head, *inside, (0, "SECTION"), (2, "ENTITIES"), *square, *entities, (0, "ENDSEC"), (0, "EOF")
    ):  # fmt: skip
        if code == 0:
            kind = SUBCLASSES.get(str(value))
        lines.append(f"{code}\n{value}\n")
        if code == 8 and kind is not None:  # the layer is the first of an entity's pairs
            lines.append(f"100\nAcDbEntity\n100\n{kind}\n")
    return "".join(lines)


def block(name: str, entities: Pairs) -> Pairs:
    """Return a block."""
    return [(0, "BLOCK"), (8, "0"), (2, name), (70, 0), (10, 0), (20, 0), *entities, (0, "ENDBLK"), (8, "0")]


def insert(name: str, layer: str = "0", rows: int = 1, columns: int = 1) -> Pairs:
    """Return a reference to a block, in rows and columns."""
    return [(0, "INSERT"), (8, layer), (2, name), (10, 0), (20, 0), (70, columns), (71, rows), (44, 1), (45, 1)]


def line(x: float, y: float, u: float, v: float, layer: str = "OUTLINE") -> Pairs:
    """Return a straight line."""
    return [(0, "LINE"), (8, layer), (10, x), (20, y), (11, u), (21, v)]


def circle(x: float, y: float, r: float, layer: str = "OPENINGS") -> Pairs:
    """Return a circle."""
    return [(0, "CIRCLE"), (8, layer), (10, x), (20, y), (40, r)]


def point(x: float, y: float, layer: str = "LOADS") -> Pairs:
    """Return a point."""
    return [(0, "POINT"), (8, layer), (10, x), (20, y)]


def text(x: float, y: float, words: str, height: float = 0.1, layer: str = "LOADS") -> Pairs:
    """Return a text."""
    return [(0, "TEXT"), (8, layer), (10, x), (20, y), (40, height), (1, words)]


def long_text(words: str) -> Pairs:
    """Return a text of any length beside a load."""
    return [*point(0, 0), (0, "MTEXT"), (8, "LOADS"), (10, 0), (20, 0), (40, 1), (1, words)]


def polyline(points: list[tuple[float, float, float]], layer: str = "OUTLINE", closed: bool = True) -> Pairs:
    """Return a polyline of points with bulges."""
    start: Pairs = [(0, "LWPOLYLINE"), (8, layer), (90, len(points)), (70, int(closed))]
    return start + [pair for x, y, bulge in points for pair in ((10, x), (20, y), (42, bulge))]


def ellipse(length: float, ratio: float, layer: str = "OUTLINE") -> Pairs:
    """Return a whole ellipse."""
    ends = [(10, 0), (20, 0), (30, 0), (11, length), (21, 0), (31, 0), (40, ratio), (41, 0), (42, 2 * math.pi)]
    return [(0, "ELLIPSE"), (8, layer), *ends]


def spline(points: list[tuple[float, float]], degree: int = 3, layer: str = "ZONES") -> Pairs:
    """Return a clamped spline by its control points."""
    n, p = len(points), degree
    knots = [0.0] * (p + 1) + [float(k) for k in range(1, n - p)] + [float(n - p)] * (p + 1)
    pairs: Pairs = [(0, "SPLINE"), (8, layer), (70, 8), (71, p), (72, len(knots)), (73, n), (74, 0)]
    pairs += [(40, knot) for knot in knots]
    return pairs + [pair for x, y in points for pair in ((10, x), (20, y), (30, 0.0))]


def many(count: int, one: Callable[[int, int], Pairs]) -> Pairs:
    """Return things in rows and columns."""
    side = math.isqrt(count - 1) + 1
    return [pair for k in range(count) for pair in one(k % side, k // side)]


def circles(count: int, layer: str) -> str:
    """Return a drawing of circles beside each other."""
    return document(many(count, lambda x, y: circle(x - 150.0, y - 150.0, 0.3, layer)))


def loads(count: int, height: float = 0.1) -> str:
    """Return a drawing of loads a metre apart, a text beside each."""
    return document(many(count, lambda x, y: point(x - 99.0, y - 99.0) + text(x - 98.9, y - 98.9, "10 kN", height)))


def nested(levels: int, width: int, content: Pairs) -> str:
    """Return a drawing of blocks in blocks, each of which holds the one below so many times."""
    blocks = block("B0", content)
    for level in range(1, levels + 1):
        blocks += block(f"B{level}", insert(f"B{level - 1}") * width)
    return document(insert(f"B{levels}"), blocks)


def nested_rows(levels: int, side: int, content: Pairs) -> str:
    """Return a drawing of blocks in blocks, each of which holds the one below in rows and columns."""
    blocks = block("B0", content)
    for level in range(1, levels + 1):
        blocks += block(f"B{level}", insert(f"B{level - 1}", "OPENINGS", side, side))
    return document(insert(f"B{levels}", "OPENINGS", side, side), blocks)


def comb(count: int) -> str:
    """Return an outline of slanting teeth, the boxes around all of which overlap."""
    teeth = [(k + (400.0 if k % 2 else 0.0), 400.0 if k % 2 else 0.0, 0.0) for k in range(count)]
    return document(polyline([*teeth, (count + 500.0, 500.0, 0.0), (-500.0, 500.0, 0.0)]), outline=False)


FAR = line(0, 0, 1, 1, "NOTHING")
ROUND = circle(0, 0, 1)
FULL = many(1000, lambda x, y: line(x, y, x + 1, y, "NOTHING")) + ROUND

#: Text, and what is said of it; empty where it is read.
SMALL: dict[str, tuple[str, str]] = {
    "nested blocks of nothing": (nested(12, 12, FAR), ""),
    "nested blocks": (nested(12, 12, ROUND), r"found 8,916,100,448,25\d entities on the layers"),
    "nested rows of nothing": (nested_rows(3, 300, FAR), ""),
    "nested rows": (nested_rows(3, 300, ROUND), r"found more than 1,000,000,000,000,000 entities"),
    "rows of a block full of other things": (
        document(insert("B0", "OPENINGS", 200, 200), block("B0", FULL)),
        r"found 40,080,000 entities of blocks to be placed",
    ),
    "rows of loads": (
        document(insert("B0", "LOADS", 300, 300), block("B0", point(0, 0))),
        r"found 90,001 entities on the layers",
    ),
    "blocks in a circle": (
        document(insert("A", "OPENINGS"), block("A", insert("B") * 60) + block("B", insert("A") * 60 + ROUND)),
        r'a block that holds itself: "(a" in "b" in "a|b" in "a" in "b)"',
    ),
    "a long chain of blocks": (nested(1000, 1, ROUND), "too many blocks in blocks"),
    "huge bulges": (
        document(polyline([(0, 0, 1e8), (1, 0, 1e8)]), outline=False), r"a bulge of 1e\+08, expected at most 100"
    ),
    "huge coordinates": (
        document(polyline([(1e300, 0, 0), (1e301, 0, 0), (1e301, 1e301, 0)]), outline=False),
        r"farther away than 1e\+09 m",
    ),
    "large coordinates": (
        document(polyline([(-9e8, -9e8, 0), (9e8, -9e8, 0), (9e8, 9e8, 0.5)]), outline=False), "",
    ),
    "a huge ellipse": (document(ellipse(8e8, 0.5), outline=False), ""),
    "a spline of many points": (
        document(spline([(0.02 * k, 5.0 * (k % 2)) for k in range(5000)])), "10,000 lines that splines",
    ),
    "a spline of high degree": (document(spline([(0.1 * k, k % 7) for k in range(1000)], 900)), ""),
    "a long text": (document(long_text("= " * 50_000)), ""),
    "many layers with wrong values": (
        document([pair for k in range(500) for pair in line(k, 0, k, 1, f"LOAD_LINE_{k} kN")]), r"400 more issues"
    ),
}  # fmt: skip
