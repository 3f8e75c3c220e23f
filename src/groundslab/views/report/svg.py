"""Drawings as text: elements of SVG whose texts and values are escaped, and labels that keep out of each other's way.

No element has a style of its own: the page forbids it. Classes begin with d- and are styled in page.css.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from markupsafe import Markup, escape

Point = tuple[float, float]

#: Width of a letter in a label, as a part of its size; of an average one, on the safe side.
LETTER = 0.56
#: Size of labels [px].
SIZE = 11.0


def element(name: str, *content: str | Markup, **attributes: object) -> Markup:
    """Return an element; underscores in names of attributes become hyphens, those that are None are left out."""
    told = Markup("").join(
        Markup(' {}="{}"').format(key.rstrip("_").replace("_", "-"), _value(value))
        for key, value in attributes.items()
        if value is not None
    )
    inside = Markup("").join(map(escape, content))
    opened = Markup("<") + Markup(name) + told
    return opened + Markup(">") + inside + Markup(f"</{name}>") if content else opened + Markup("/>")


def drawing(width: float, height: float, label: str, *content: Markup) -> Markup:
    """Return a drawing that fits the page, with words for those who cannot see it."""
    return element(
        "svg",
        *content,
        class_="drawing",
        viewBox=f"0 0 {width:.0f} {height:.0f}",
        width=f"{width:.0f}",
        height=f"{height:.0f}",
        role="img",
        aria_label=label,
    )


def path(points: Iterable[Point], class_: str, closed: bool = False, **attributes: object) -> Markup:
    """Return a line through points."""
    d = "M" + "L".join(f"{_value(x)} {_value(y)}" for x, y in points) + ("Z" if closed else "")
    return element("path", d=d, class_=class_, **attributes)


def area(rings: Sequence[Sequence[Point]], class_: str) -> Markup:
    """Return the area in the first curve less those in the others."""
    d = "".join("M" + "L".join(f"{_value(x)} {_value(y)}" for x, y in ring) + "Z" for ring in rings)
    return element("path", d=d, class_=class_, fill_rule="evenodd")


def line(a: Point, b: Point, class_: str, **attributes: object) -> Markup:
    """Return a straight line."""
    return element("line", x1=a[0], y1=a[1], x2=b[0], y2=b[1], class_=class_, **attributes)


def text(at: Point, words: str, class_: str = "d-text", anchor: str = "start", **attributes: object) -> Markup:
    """Return words at a place, which is their start, middle or end on the base line."""
    return element("text", words, x=at[0], y=at[1], class_=class_, text_anchor=anchor, **attributes)


def width_of(words: str, size: float = SIZE) -> float:
    """Return about how wide words are [px]."""
    return LETTER * size * len(words)


@dataclass
class Labels:
    """Words beside places, none over another as far as there is room: boxes (x0, y0, x1, y1) that are taken."""

    within: tuple[float, float, float, float]
    taken: list[tuple[float, float, float, float]] = field(default_factory=list)

    def beside(self, at: Point, words: str, class_: str, reach: float = 7.0) -> Markup:
        """Return words beside a place, or beside the edge for one outside, where there is room, else upper right."""
        wide, (x0, y0, x1, y1) = width_of(words), self.within
        x, y = min(max(at[0], x0), x1), min(max(at[1], y0), y1)
        right, left, middle = x + reach, x - reach - wide, x - wide / 2
        above, level, below = (y - 0.3 * SIZE + 1.25 * SIZE * row for row in (-1, 0, 1))
        offered = [
            (right, level), (left, level), (right, below), (left, below),
            (middle, y - reach - 2), (middle, y + reach + SIZE), (right, above), (left, above),
        ]  # fmt: skip
        boxes = [(left, base - SIZE, left + wide, base + 2) for left, base in offered]
        free = [n for n, box in enumerate(boxes) if self._free(box)]
        n = free[0] if free else 0
        self.taken.append(boxes[n])
        return text(offered[n], words, class_)

    def keep(self, at: Point, reach: float) -> None:
        """Keep words off a mark that reaches so far."""
        self.taken.append((at[0] - reach, at[1] - reach, at[0] + reach, at[1] + reach))

    def _free(self, box: tuple[float, float, float, float]) -> bool:
        x0, y0, x1, y1 = self.within
        inside = x0 <= box[0] and y0 <= box[1] and box[2] <= x1 and box[3] <= y1
        return inside and not any(
            box[0] < other[2] and other[0] < box[2] and box[1] < other[3] and other[1] < box[3] for other in self.taken
        )


def _value(value: object) -> str:
    """Return an attribute's value; lengths to a hundredth of a pixel."""
    return f"{round(value, 2) + 0.0:g}" if isinstance(value, float) else str(value)
