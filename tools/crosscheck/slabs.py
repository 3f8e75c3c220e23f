"""Random slabs for the cross-check, each decided by its number alone, written in the words of the input file."""

from __future__ import annotations

from typing import Any

import numpy as np

#: Points at which values are compared keep so far [m] from edges, openings, zones and loads, where moments are regular.
CLEARANCE = 0.5


def random_slab(seed: int) -> dict[str, Any]:
    """Return a slab as a table of the input file, all in base units, and under "points" the places to compare.

    Outlines with and without reentrant corners, openings, thicker parts, pressures on rectangles, slabs so light that
    they lift; springs, or ground that carries shear and ends with the slab or goes on without end.
    """
    rng = np.random.default_rng(seed)
    a, b = rng.uniform(8, 16), rng.uniform(6, 12)
    u, v = rng.uniform(0.35, 0.65, 2)
    outlines = {
        "rectangle": [(0, 0), (a, 0), (a, b), (0, b)],
        "L": [(0, 0), (a, 0), (a, v * b), (u * a, v * b), (u * a, b), (0, b)],
        "oblique": [(0, 0), (a, 0), (a, v * b), (u * a, b), (0, b)],
    }
    points = outlines[str(rng.choice(list(outlines)))]
    thickness = float(rng.choice([0.2, 0.3, 0.5, 0.8]))
    plate: dict[str, Any] = {
        "outline": {"kind": "polygon", "points": [_meters(*point) for point in points]},
        "thickness": f"{thickness} m",
        "E": "30e9 Pa",
        "nu": 0.2,
    }
    taken = []
    if rng.random() < 0.4:
        taken.append(_rectangle(0.12 * a, 0.15 * b, 0.1 * a, 0.12 * b))
        plate["openings"] = [{"kind": "rectangle", **taken[0]}]
    if rng.random() < 0.4:
        taken.append(_rectangle(0.15 * u * a, 0.4 * v * b, 0.3 * u * a, 0.5 * v * b))
        plate["zones"] = [{"shape": {"kind": "rectangle", **taken[-1]}, "thickness": f"{1.6 * thickness:.6g} m"}]
    k = float(rng.uniform(10e6, 60e6))
    ground: dict[str, Any] = {"kind": "winkler", "k": f"{k:.6g} Pa/m"}
    beyond = "none"
    if rng.random() < 0.6:
        ground = {"kind": "pasternak", "k0": f"{k:.6g} Pa/m", "k1": f"{rng.uniform(2e6, 20e6):.6g} Pa m"}
        beyond = str(rng.choice(["none", "infinite"]))
    loads: list[dict[str, Any]] = [{"kind": "uniform", "q": f"{rng.uniform(2e3, 12e3):.6g} Pa"}]
    wanted = int(rng.integers(1, 4))
    for _ in range(40):
        if len(loads) > wanted:
            break
        width = rng.uniform(0.6, 1.5)
        x, y = rng.uniform(0.3, a - width - 0.3), rng.uniform(0.3, b * v - width - 0.3)
        place = _rectangle(x, y, width, width)
        if not any(_overlap(place, other, 0.2) for other in taken):
            taken.append(place)
            loads.append({"kind": "patch", "q": f"{rng.uniform(50e3, 400e3):.6g} Pa", **place})
    case = {
        "title": f"random slab {seed}",
        "plate": plate,
        "ground": ground,
        "beyond": {"kind": beyond},
        "loads": loads,
    }
    return {**case, "points": _regular_points(rng, points, taken)}


def _meters(*numbers: float) -> list[str]:
    return [f"{number:.6f} m" for number in numbers]


def _rectangle(x: float, y: float, width: float, height: float) -> dict[str, list[str]]:
    return {"x": _meters(x, x + width), "y": _meters(y, y + height)}


def numbers(place: dict[str, list[str]]) -> tuple[float, float, float, float]:
    """Return x0, x1, y0, y1 [m] of a rectangle of the input file."""
    x0, x1, y0, y1 = (float(text.split()[0]) for text in (*place["x"], *place["y"]))
    return x0, x1, y0, y1


def _overlap(one: dict[str, list[str]], other: dict[str, list[str]], margin: float) -> bool:
    x0, x1, y0, y1 = numbers(one)
    u0, u1, v0, v1 = numbers(other)
    return x0 < u1 + margin and u0 < x1 + margin and y0 < v1 + margin and v0 < y1 + margin


def _regular_points(
    rng: np.random.Generator, outline: list[tuple[float, float]], places: list[dict[str, list[str]]]
) -> list[list[float]]:
    """Return up to 20 points in the slab that are clear of everything at which moments are not smooth."""
    corners = np.array(outline)
    found: list[list[float]] = []
    for point in rng.uniform(corners.min(axis=0), corners.max(axis=0), (400, 2)):
        sides = list(zip(corners, np.roll(corners, -1, axis=0), strict=True))
        crossed = sum((p[1] > point[1]) != (q[1] > point[1]) and _right_of(point, p, q) for p, q in sides)
        clear = all(_distance(point, p, q) > CLEARANCE for p, q in sides)
        if crossed % 2 and clear and not any(_near_border(point, place) for place in places):
            found.append([float(x) for x in point])
    return found[:20]


def _right_of(point: np.ndarray, p: np.ndarray, q: np.ndarray) -> bool:
    return bool(point[0] < p[0] + (point[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0]))


def _distance(point: np.ndarray, p: np.ndarray, q: np.ndarray) -> float:
    s = np.clip((point - p) @ (q - p) / ((q - p) @ (q - p)), 0.0, 1.0)
    return float(np.hypot(*(point - p - s * (q - p))))


def _near_border(point: np.ndarray, place: dict[str, list[str]]) -> bool:
    x0, x1, y0, y1 = numbers(place)
    outer = x0 - CLEARANCE < point[0] < x1 + CLEARANCE and y0 - CLEARANCE < point[1] < y1 + CLEARANCE
    inner = x0 + CLEARANCE < point[0] < x1 - CLEARANCE and y0 + CLEARANCE < point[1] < y1 - CLEARANCE
    return outer and not inner
