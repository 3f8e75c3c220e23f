"""Rectangles at an angle, exact where they run along x and y."""

from __future__ import annotations

import math

from groundslab.geometry.plan import Place, Ring, rectangle


def direction_at(angle: float) -> Place:
    """Return the unit vector at an angle [degrees] from x, exact at right angles."""
    quarters = round(angle / 90)
    rest = math.radians(angle - 90 * quarters)
    c, s = math.cos(rest), math.sin(rest)
    return ((c, s), (-s, c), (-c, -s), (s, -c))[quarters % 4]


def extents_at(sides: tuple[float, float], angle: float) -> tuple[float, float]:
    """Return how far a rectangle whose first side runs at an angle [degrees] from x extends along x and along y."""
    c, s = map(abs, direction_at(angle))
    return c * sides[0] + s * sides[1], s * sides[0] + c * sides[1]


def rectangle_at(centre: Place, sides: tuple[float, float], angle: float) -> Ring:
    """Return the rectangle about a center whose first side runs at an angle [degrees] from x.

    At right angles it is exactly the one along x and y.
    """
    quarters = round(angle / 90)
    a, b = sides if quarters % 2 == 0 else sides[::-1]
    (x, y), (c, s) = centre, direction_at(angle - 90 * quarters)
    if s == 0:
        return rectangle(x - a / 2, x + a / 2, y - b / 2, y + b / 2)
    corners = ((-a, -b), (a, -b), (a, b), (-a, b))
    return Ring(tuple((x + (c * u - s * v) / 2, y + (s * u + c * v) / 2) for u, v in corners))
