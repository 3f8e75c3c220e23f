"""Plans in Gmsh's geometry, and the cells that Gmsh makes of them at twice the wanted size."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.mesh import GRADING
from groundslab.geometry.plan import FLAT, Place, Plan, Ring, Segment
from groundslab.meshing.cells import Cells, Drawn, onto
from groundslab.meshing.sizing import Sources, along

#: Extent of what Gmsh is given: its geometry takes places 1e-7 apart for one, whatever the extent.
SCALED_EXTENT = 100.0


def cells_of(gmsh: Any, plan: Plan, size: float, smaller: Sources, scale: float) -> Cells:
    """Return Gmsh's mesh of twice the wanted sizes: mostly quadrilaterals, some triangles."""
    drawing = Drawing(gmsh, plan)
    _sizes(drawing, plan, size, smaller, scale)
    unwanted = [part for part in gmsh.model.getEntities(2) if part[1] not in drawing.faces]
    gmsh.model.removeEntities(unwanted, recursive=True)
    gmsh.model.mesh.generate(2)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    nodes = coordinates.reshape(-1, 3)[:, :2] / drawing.scale + drawing.middle
    index = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    index[tags.astype(np.int64)] = np.arange(len(tags))

    def elements(tag: int, kind: int, corners: int) -> Integers:
        found = gmsh.model.mesh.getElementsByType(kind, tag)[1].astype(np.int64)
        result: Integers = index[found].reshape(-1, corners)
        return result

    triangles, quadrilaterals = [], []
    for tag in sorted(drawing.faces):
        three, four = elements(tag, 2, 3), elements(tag, 3, 4)
        turn = -1 if _clockwise(nodes, three, four) else 1
        triangles.append(three[:, ::turn])
        quadrilaterals.append(four[:, ::turn])
    points = np.concatenate([gmsh.model.mesh.getNodes(0, tag)[0] for _, tag in gmsh.model.getEntities(0)])
    points = index[points.astype(np.int64)]
    _snap(plan, nodes, points)
    drawn = _drawn(drawing, plan, nodes, points, lambda tag: elements(tag, 1, 2))
    return Cells(nodes, np.concatenate(triangles), np.concatenate(quadrilaterals), drawn)


class Drawing:
    """A plan drawn in Gmsh's geometry, centred and scaled: its domain cut up by all that meshes must meet."""

    def __init__(self, gmsh: Any, plan: Plan) -> None:
        self.gmsh = gmsh
        x0, y0, x1, y1 = plan.bounds
        self.middle = np.array([(x0 + x1) / 2, (y0 + y1) / 2])
        self.scale = SCALED_EXTENT / plan.extent
        occ = gmsh.model.occ
        outline = (2, self.face(plan.outline))
        openings = [(2, self.face(ring)) for ring in plan.openings]
        keep = {"removeObject": False, "removeTool": False}
        plate = occ.cut([outline], openings, **keep)[0] if openings else [outline]
        zones = []
        for ring, _ in plan.zones:
            zones += occ.intersect([(2, self.face(ring))], plate, removeObject=True, removeTool=False)[0]
        domain = plate if plan.beyond is None else [(2, self.face(plan.beyond))]
        borders = []
        for ring in plan.borders:
            borders += occ.intersect([(2, self.face(ring))], domain, removeObject=True, removeTool=False)[0]
        lines = [(1, self.curve(edge, self.point(edge.start), self.point(edge.end))) for edge in plan.line_segments()]
        points = [(0, self.point(point)) for point in plan.points]
        tools = [part for part in [outline, *openings, *zones, *borders, *lines, *points] if part not in domain]
        self.faces = {tag for _, tag in domain}
        self.inside = set(self.faces)
        if tools:
            _, origin = occ.fragment(domain, tools)
            whole = domain + tools
            self.faces = {tag for part in origin[: len(domain)] for _, tag in part}
            self.inside = {tag for _, tag in origin[whole.index(outline)]} if outline in whole else set(self.faces)
            self.inside &= self.faces

    def scaled(self, places: Array) -> Array:
        """Return places as Gmsh is given them."""
        result: Array = (places - self.middle) * self.scale
        return result

    def point(self, place: Place) -> int:
        """Add a point and return its tag."""
        x, y = self.scaled(np.array(place))
        return int(self.gmsh.model.occ.addPoint(x, y, 0.0))

    def curve(self, edge: Segment, start: int, end: int) -> int:
        """Add an edge between two points and return its tag."""
        occ = self.gmsh.model.occ
        if edge.straight:
            return int(occ.addLine(start, end))
        x, y = edge.at(np.array([0.5]))[0]
        return int(occ.addCircleArc(start, self.point((x, y)), end, center=False))

    def face(self, ring: Ring) -> int:
        """Add what a ring encloses and return its tag."""
        occ = self.gmsh.model.occ
        tags = [self.point(point) for point in ring.points]
        curves = map(self.curve, ring.segments(), tags, tags[1:] + tags[:1])
        return int(occ.addPlaneSurface([occ.addCurveLoop(list(curves))]))


def _sizes(drawing: Drawing, plan: Plan, size: float, smaller: Sources, scale: float) -> None:
    """Tell Gmsh how large elements may be: twice what is wanted, since they are halved afterwards."""
    gmsh = drawing.gmsh
    coarse = float(2 * size * drawing.scale)
    field, far = gmsh.model.mesh.field, 4 * SCALED_EXTENT
    asked: dict[int, list[int]] = {}
    places, sizes = smaller
    level = np.ceil(2 * np.log2(size / sizes)).astype(np.int64)
    for k, place in sorted({(int(k), (x, y)) for k, (x, y) in zip(level, places, strict=True)}):
        asked.setdefault(k, []).append(drawing.point(place))
    around = [drawing.point((x, y)) for x, y in along(plan.outline, size)] if plan.beyond is not None else []
    gmsh.model.occ.synchronize()

    def near(points: list[int], least: float, slope: float) -> int:
        distance = field.add("Distance")
        field.setNumbers(distance, "PointsList", points)
        threshold = field.add("Threshold")
        field.setNumber(threshold, "InField", distance)
        field.setNumber(threshold, "SizeMin", least)
        field.setNumber(threshold, "SizeMax", least + slope * far)
        field.setNumber(threshold, "DistMin", 0.0)
        field.setNumber(threshold, "DistMax", far)
        return int(threshold)

    plate = field.add("MathEval")
    field.setString(plate, "F", f"{coarse!r}")
    limits = [near(points, coarse * 2 ** (-k / 2), GRADING) for k, points in asked.items()]
    if around:
        only = field.add("Restrict")
        field.setNumber(only, "InField", plate)
        field.setNumbers(only, "SurfacesList", sorted(drawing.inside))
        limits += [only, near(around, coarse, coarse / (scale * drawing.scale))]
    else:
        limits.append(plate)
    least = field.add("Min")
    field.setNumbers(least, "FieldsList", limits)
    field.setAsBackgroundMesh(least)


def _clockwise(nodes: Array, *kinds: Integers) -> bool:
    """Return whether cells of a face run clockwise, all together: one may be turned inside out, and is mended later."""
    twice = 0.0
    for cells in kinds:
        x, y = np.moveaxis(nodes[cells], 2, 0)
        twice += float((x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y).sum())
    return twice < 0


def _snap(plan: Plan, nodes: Array, corners: Integers) -> None:
    """Put the nodes at corners and points of a plan where they are, to the last bit."""
    wanted = [point for ring in plan.rings().values() for point in ring.points]
    wanted += [*plan.points, *(point for line in plan.lines for point in line)]
    for place in np.array(wanted):
        distance = np.abs(nodes[corners] - place).max(axis=1)
        nodes[corners[distance <= FLAT * plan.extent]] = place


def _drawn(drawing: Drawing, plan: Plan, nodes: Array, points: Integers, sides_on: Callable[[int], Integers]) -> Drawn:
    """Return the sides on edges of the plan, after putting the nodes on arcs exactly there."""
    gmsh = drawing.gmsh
    arcs = [edge for ring in plan.rings().values() for edge in ring.segments() if not edge.straight]
    ends, centre, radius = [np.zeros((0, 2), dtype=np.int64)], [np.zeros((0, 2))], [np.zeros(0)]
    for _, tag in gmsh.model.getEntities(1):
        own = sides_on(tag)
        if not len(own):
            continue
        edge = Segment((0.0, 0.0), (0.0, 0.0))
        if gmsh.model.getType(1, tag) != "Line":
            (low,), (high,) = gmsh.model.getParametrizationBounds(1, tag)
            on_it = gmsh.model.getValue(1, tag, np.linspace(low, high, 5)).reshape(-1, 3)[:, :2]
            on_it = on_it / drawing.scale + drawing.middle
            edge = arcs[int(np.argmin([arc.distance(on_it).max() for arc in arcs]))]
            inner = np.setdiff1d(own, points)
            nodes[inner] = onto(nodes[inner], np.array(edge.centre), edge.radius)
        ends.append(own)
        centre.append(np.tile(edge.centre, (len(own), 1)))
        radius.append(np.full(len(own), edge.radius))
    return Drawn(np.concatenate(ends), np.concatenate(centre), np.concatenate(radius), points)
