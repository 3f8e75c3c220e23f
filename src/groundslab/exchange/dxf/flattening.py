"""Curves as lines and arcs: splines and ellipses within a distance, arcs by their bulges."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING

import numpy as np

from groundslab.exchange.dxf.drawing import ReadContext
from groundslab.geometry.plan import Segment

if TYPE_CHECKING:
    from ezdxf.entities import Ellipse
    from ezdxf.math import BSpline, ConstructionEllipse, Vec3

#: Lines may miss an ellipse or a spline by this [m], or by this part of its size if that is more.
SAG, SAG_OF_SIZE = 1e-3, 1e-5
MOST_LINES = 10_000  # that splines are made into
HIGHEST = 25  # degree of a spline
MOST_HALVINGS = 16  # of a spline's span
LINES_MADE = "lines that splines are made into"
# Directions without the rounding of sines.
_QUARTERS = {0.0: (1, 0), 90.0: (0, 1), 180.0: (-1, 0), 270.0: (0, -1)}

#: Corners (in the drawing's units), the bulge of each edge between them, and remarks for the report.
Corners = tuple[list["Vec3"], list[float], list[str]]


def flatten_ellipse(ellipse: Ellipse | ConstructionEllipse, size: float, context: ReadContext) -> Corners:
    """Return an ellipse of a major radius as lines."""
    from ezdxf.math import Vec3

    sag = _sag(size, context)
    return _as_lines([Vec3(point) for point in ellipse.flattening(sag)], sag, context)


def flatten_spline(tool: BSpline, closed: bool, context: ReadContext) -> Corners | str:
    """Return a spline as lines, or why it is ignored."""
    if tool.degree > HIGHEST:
        return f"its degree is {tool.degree}, expected at most {HIGHEST}"
    return _as_lines(*_follow_spline(tool, closed, context), context)


def _as_lines(corners: list[Vec3], sag: float, context: ReadContext) -> Corners:
    """Return lines with the remark what they were."""
    within = f"{context.to_meters(sag) * 1e3:.3g} mm"
    return corners, [0.0] * (len(corners) - 1), [f"made into {len(corners) - 1} lines within {within}"]


def _sag(size: float, context: ReadContext) -> float:
    """Return by how much lines may miss a curve of a size, both in the drawing's units."""
    return max(SAG / float(context.scale), SAG_OF_SIZE * size)


def _follow_spline(tool: BSpline, closed: bool, context: ReadContext) -> tuple[list[Vec3], float]:
    """Return corners of lines along a spline, and within which distance of it (in the drawing's units)."""
    knots = [float(knot) for knot in tool.knots()]
    # Knots before and after these only shape the curve's ends; closed splines have them.
    inner = sorted(set(knots[tool.order - 1 : tool.count + 1]))
    context.count_work(4 * (len(inner) - 1), MOST_LINES, LINES_MADE)
    steering = [(point.x, point.y) for point in tool.control_points]
    sag = _sag(max(max(values) - min(values) for values in zip(*steering, strict=True)), context)
    corners = [tool.point(inner[0])]

    def follow(start: float, end: float, a: Vec3, b: Vec3, depth: int) -> None:
        between = [tool.point(start + (end - start) * part / 4) for part in (1, 2, 3)]
        # An S crosses its chord half way, so that quarters are looked at too.
        off = Segment((a.x, a.y), (b.x, b.y)).distance(np.array([(p.x, p.y) for p in between])).max()
        if depth < 2 or (off > sag / 2 and depth < MOST_HALVINGS):
            if depth >= 2:
                context.count_work(1, MOST_LINES, LINES_MADE)
            middle = (start + end) / 2
            follow(start, middle, a, between[1], depth + 1)
            follow(middle, end, between[1], b, depth + 1)
        else:
            corners.append(b)

    for start, end in itertools.pairwise(inner):
        follow(start, end, corners[-1], tool.point(end), 0)
    if closed and not corners[0].isclose(corners[-1]):
        corners.append(corners[0])
    return corners, sag


def divide_arc(centre: Vec3, radius: float, start: float, angle: float) -> tuple[list[Vec3], list[float]]:
    """Return corners and bulges of an arc [degrees], in two parts if it is more than a half circle."""
    from ezdxf.math import Vec3

    parts = 1 if angle <= 180.0 + 1e-9 else 2
    turns = [(start + angle * part / parts) % 360.0 for part in range(parts + 1)]
    corners = [centre + Vec3(_QUARTERS.get(turn) or Vec3.from_deg_angle(turn)) * radius for turn in turns]
    return corners, [1.0 if angle in {180.0, 360.0} else math.tan(math.radians(angle / parts) / 4)] * parts
