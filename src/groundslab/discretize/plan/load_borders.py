"""Places and borders of loads that a mesh follows, so that what jumps or has a kink there does so between elements."""

from __future__ import annotations

import functools
import math
import re
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from groundslab.discretize.plan.borders import MOST_BORDERS, add_borders
from groundslab.geometry.places import same_place_in
from groundslab.geometry.plan import FLAT, Place, Plan, Ring, Segment, flatten
from groundslab.geometry.validity import find_issues
from groundslab.model.loads.acting import LineForce, rings_of
from groundslab.model.model import Model
from groundslab.model.remarks.singular_places import kinks_of_loads

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from shapely import LineString, Point

#: A border or line that passes another one this close is not followed: by this share of the plate's thickness, of
#: twice the thickness for a border, or of the border's shorter side if that is less.
CLEAR = 0.25
#: A flattened curve that turns by more than this has a corner; curves that cross at a smaller angle than STEEP graze.
CORNER, STEEP = math.radians(15), math.radians(30)

#: A straight line from one place to another.
Line = tuple[Place, Place]


def follow_kinks(plan: Plan, model: Model, axes: list[Segment]) -> Plan:
    """Return a plan with the places on axes of members where their shear forces jump or have a kink, by loads.

    A place that is not clear of what the mesh follows already is left out.
    """
    import shapely

    kinks = dict.fromkeys(kinks_of_loads(model) if axes else ())
    if not kinks:
        return plan
    chord, same = FLAT * plan.extent, same_place_in(plan)
    on_axes = shapely.union_all(flatten(axes, chord)).buffer(max(same, 2 * chord))
    drawn = [ring.polygon(chord).exterior for ring in plan.rings().values()] + flatten(plan.line_segments(), chord)
    drawn += [shapely.Point(point) for point in plan.points]
    near = CLEAR * min(plate.thickness for plate in model.every_plate)
    corners = shapely.multipoints(shapely.get_coordinates(drawn))
    kept: list[Place] = []
    for place in kinks:
        kink = shapely.Point(place)
        new = on_axes.covers(kink) and kink.distance(corners) > same
        if new and len(kept) < MOST_BORDERS and all(_clear(kink, shape, same, near) for shape in drawn):
            kept.append(place)
            drawn.append(kink)
    return replace(plan, points=(*plan.points, *kept))


def follow_loads(plan: Plan, model: Model) -> Plan:
    """Return a plan with the borders of loads, and the straight lines that loads stand on, that a mesh can follow.

    A grid would have lines through the whole plate for each: where nothing but grids can be made there are none.
    """
    from groundslab import meshing

    if not meshing.available():
        return plan
    shapes = [shape for _, shape in model.acting]
    loaded = [shape for shape in shapes if isinstance(shape, LineForce)]
    around = [shape.ring for shape in loaded if shape.closed and not shape.straight]
    rings = dict.fromkeys([*(ring for shape in shapes for ring in rings_of(shape)), *around])
    lines = dict.fromkeys((edge.start, edge.end) for shape in loaded for edge in shape.edges if edge.straight)
    thinnest = min(plate.thickness for plate in model.every_plate)
    return _follow(plan, tuple(rings)[:MOST_BORDERS], tuple(lines)[:MOST_BORDERS], thinnest)


@functools.lru_cache(maxsize=64)
def _follow(plan: Plan, rings: tuple[Ring, ...], lines: tuple[Line, ...], thickness: float) -> Plan:
    """Return a plan with those rings and lines that are clear of all before them, or meet them."""
    from shapely import LineString

    chord = FLAT * plan.extent
    drawn = [ring.polygon(chord).exterior for ring in plan.rings().values()] + flatten(plan.line_segments(), chord)
    same = same_place_in(plan)

    def is_clear(curve: LineString, near: float) -> bool:
        clear = all(_clear(curve, other, same, near) for other in drawn)
        if clear:
            drawn.append(curve)
        return clear

    followed = [
        ring for ring in rings if is_clear(ring.polygon(chord).exterior, CLEAR * min(*ring.sides, 2 * thickness))
    ]
    straight = [line for line in lines if is_clear(LineString(line), CLEAR * thickness)]
    return _add_lines(add_borders(plan, (*plan.borders, *followed)), tuple(straight))


def _clear(curve: LineString | Point, other: LineString | Point, same: float, near: float) -> bool:
    """Return whether either of two curves meets the other nowhere, at its own corners, or across it; else `near` [m].

    At a corner they have the same place, or are at least so far apart. Along smooth parts they are closer than that
    only about places where they cross, as far as curves do that cross at STEEP or more.
    """
    import shapely

    if shapely.distance(curve, other) >= near:
        return True
    crossings = shapely.intersection(curve, other)
    for a, b in ((curve, other), (other, curve)):
        places, corner = _corners(a)
        apart = shapely.distance(places, b)
        between = (apart > same) & (apart < near)
        # without a crossing the distance is none
        far = ~(shapely.distance(places, crossings) <= near / math.sin(STEEP))
        if (between & (corner | far)).any():
            return False
    return True


def _corners(curve: LineString | Point) -> tuple[NDArray[np.object_], NDArray[np.bool_]]:
    """Return the points of a flattened curve (p,), and whether each is a corner or an end (p,), not on an arc."""
    import shapely

    places = shapely.get_coordinates(curve)
    corner = np.ones(len(places), dtype=bool)
    if len(places) > 2:
        along = np.diff(places, axis=0)
        direction = np.arctan2(along[:, 1], along[:, 0])
        if shapely.is_closed(curve):
            before, after, turning = np.roll(direction, 1), direction, slice(0, -1)
        else:
            before, after, turning = direction[:-1], direction[1:], slice(1, -1)
        turn = np.abs(np.angle(np.exp(1j * (after - before))))
        corner[turning] = turn > CORNER
        if shapely.is_closed(curve):
            corner[-1] = corner[0]
    return shapely.points(places), corner


def _add_lines(plan: Plan, lines: tuple[Line, ...]) -> Plan:
    """Return a plan with those straight lines that a mesh can follow, cut off where there is no plate.

    A line is left out where borders are, too: see `borders.add_borders`.
    """
    import shapely

    chord = FLAT * plan.extent
    openings = shapely.union_all([ring.polygon(chord) for ring in plan.openings])
    plate = plan.plate_polygon(chord).difference(openings)
    pieces = shapely.get_parts([shapely.LineString(line).intersection(plate) for line in lines])
    ends = [shapely.get_coordinates(piece)[[0, -1]] for piece in pieces if piece.geom_type == "LineString"]
    kept: list[Line] = [((float(ax), float(ay)), (float(bx), float(by))) for (ax, ay), (bx, by) in ends]
    while kept:
        trial = replace(plan, lines=(*plan.lines, *kept))
        issues = " ".join(f"{issue.location} {issue.found}" for issue in find_issues(trial))
        refused = {int(number) - len(plan.lines) for number in re.findall(r"plate\.lines\[(\d+)\]", issues)}
        if not refused:
            return trial
        kept = [line for number, line in enumerate(kept, start=1) if number not in refused]
    return plan
