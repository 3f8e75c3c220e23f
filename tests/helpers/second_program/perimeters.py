"""Perimeters of punching by points on them."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from helpers.second_program.materials import Points, Values


class Drawn(NamedTuple):
    """A perimeter as points: length, centers and moduli along its axes, of the column's center from its own."""

    u: float
    W: tuple[float, float]
    e: tuple[float, float]


def drawn(v: Values, a: float) -> list[Drawn]:
    """Return the perimeters at a distance from what may be loaded: a rectangle of c_1 by c_2, or a circle of c_1."""
    if "s_2" in v:
        return [_quarter(v, a)]
    if "s_1" in v:
        return [_half(v, a)]
    r = v["c_1"] / 2 + a
    circle = Drawn(2 * math.pi * r, (4 * r * r, 4 * r * r), (0.0, 0.0))
    c_1, c_2 = v["c_1"], v["c_2"]
    W = tuple(
        c**2 / 2 + c * other + 2 * other * a + 4 * a**2 + math.pi * c * a for c, other in ((c_1, c_2), (c_2, c_1))
    )
    return [Drawn(2 * (c_1 + c_2) + 2 * math.pi * a, W, (0.0, 0.0)), circle]


def _half(v: Values, a: float) -> Drawn:
    """Return the perimeter that ends at an edge along axis 1, y being the way to it."""
    x, y = v["c_1"] / 2, v["c_2"] / 2
    end = y + v["s_1"]
    pieces = [
        _straight((-x, -y - a), (x, -y - a)),
        _straight((x + a, -y), (x + a, end)),
        _straight((-x - a, end), (-x - a, -y)),
        _arc((x, -y), a, -90),
        _arc((-x, -y), a, 180),
    ]
    return _sums(np.concatenate(pieces), 0.0)


def _quarter(v: Values, a: float) -> Drawn:
    """Return the perimeter that ends at two edges, axis 1 from one of its ends to the other."""
    x, y = v.get("w_2", v["c_2"]) / 2, v.get("w_1", v["c_1"]) / 2
    right, top = x + v["s_2"], y + v["s_1"]
    pieces = [_straight((-x, -y - a), (right, -y - a)), _straight((-x - a, top), (-x - a, -y)), _arc((-x, -y), a, 180)]
    chord = math.atan2(top + y + a, -x - a - right)
    return _sums(np.concatenate(pieces), chord)


def _straight(start: tuple[float, float], end: tuple[float, float]) -> Points:
    t = ((np.arange(4000) + 0.5) / 4000)[:, None]
    ds = np.full((4000, 1), math.dist(start, end) / 4000)
    return np.hstack([np.array(start) + t * (np.array(end) - start), ds])


def _arc(center: tuple[float, float], a: float, begin: float) -> Points:
    t = np.radians(begin + 90 * (np.arange(4000) + 0.5) / 4000)
    ds = np.full((4000, 1), a * math.pi / 2 / 4000)
    return np.hstack([np.array(center) + a * np.column_stack([np.cos(t), np.sin(t)]), ds])


def _sums(points: Points, angle: float) -> Drawn:
    """Return length, moduli and the column's place along axes at an angle."""
    xy, ds = points[:, :2], points[:, 2]
    axes = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    center = ds @ xy / ds.sum()
    W = np.abs((xy - center) @ axes.T).T @ ds
    e = axes @ -center
    return Drawn(float(ds.sum()), (float(W[0]), float(W[1])), (float(e[0]), float(e[1])))


def perimeter(symbols: str, of: Callable[[Drawn], float], at: str = "a") -> Callable[[Values], float | None]:
    """Return the rule of what is drawn; None where openings take off a part, as the sketch shows."""

    def rule(v: Values) -> float | None:
        if symbols in ("W", "e") and "u_o" in v:
            return None
        a = v[at] if at in v else v["d_v"] / 2
        found = [of(each) for each in drawn(v, a)]
        if symbols != "u":
            round_one = len(found) > 1 and math.isclose(v["u"], math.pi * (v["c_1"] + 2 * v["a"]), rel_tol=1e-4)
            return found[1] if round_one else found[0]
        return found[0] if len(found) == 1 else None

    return rule
