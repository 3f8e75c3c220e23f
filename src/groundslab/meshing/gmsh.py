"""Gmsh: its session, plans in its geometry, and the cells that it makes at twice the required size."""

from __future__ import annotations

import ctypes
import os
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import FLAT, Place, Plan, Ring, Segment
from groundslab.meshing.cells import Cells, FixedSides, project_onto
from groundslab.meshing.sizing import Sources, along

#: Cells grow by so much of the distance from what the plan requires to be small; elements are a half of them, or a
#: quarter. Where elements turn inside out, cells that grow by less are looked at.
SLOPE, GENTLE = 0.8, 0.4
#: Gmsh's algorithm for triangles; the one in its options makes such as become quadrilaterals.
FRONTAL_DELAUNAY = 6
#: Gmsh's geometry merges places less than 1e-7 apart, whatever the extent: plans are scaled to this extent.
SCALED_EXTENT = 100.0
#: Libraries that Gmsh's wheel needs on a bare Debian or Ubuntu.
SYSTEM_LIBRARIES = "libglu1-mesa libopengl0 libgl1 libxrender1 libxcursor1 libxft2 libxinerama1 libgomp1"
#: Gmsh's options during a session.
OPTIONS = {
    "General.Terminal": 0,
    "General.AbortOnError": 2,
    "General.NumThreads": 1,
    "Geometry.OCCBoundsUseStl": 0,
    "Mesh.Algorithm": 8,
    "Mesh.ElementOrder": 1,
    "Mesh.MeshSizeExtendFromBoundary": 0,
    "Mesh.MeshSizeFromCurvature": 0,
    "Mesh.MeshSizeFromPoints": 0,
    "Mesh.MeshSizeMax": 1e22,
    "Mesh.MeshSizeMin": 0,
    "Mesh.RandomSeed": 1,
    "Mesh.RecombinationAlgorithm": 1,
    "Mesh.RecombineAll": 1,
    "Mesh.SubdivisionAlgorithm": 0,
}


@contextmanager
def session() -> Iterator[Any]:
    """Yield Gmsh with an empty model of our own; on exit Gmsh's previous state is restored."""
    gmsh = load()
    ours = not gmsh.isInitialized()
    if ours:
        gmsh.initialize([], readConfigFiles=False, run=False, interruptible=False)
    _ignore_broken_pipes()
    before = {} if ours else {name: gmsh.option.getNumber(name) for name in OPTIONS}
    current = "" if ours else gmsh.model.getCurrent()
    views = set() if ours else set(gmsh.view.getTags())
    try:
        for name, value in OPTIONS.items():
            gmsh.option.setNumber(name, value)
        gmsh.model.add("groundslab")
        yield gmsh
    except InputError:
        raise
    except Exception as refused:
        # Gmsh raises no other exception; its text is for people
        raise InputError([Issue("plan", f"a plan that Gmsh refuses ({refused})", "one that can be meshed")]) from None
    finally:
        if ours:
            gmsh.finalize()
        else:
            gmsh.model.setCurrent("groundslab")
            gmsh.model.remove()
            for view in set(gmsh.view.getTags()) - views:
                gmsh.view.remove(view)
            gmsh.model.setCurrent(current)
            for name, value in before.items():
                gmsh.option.setNumber(name, value)


def _ignore_broken_pipes() -> None:
    """Make a broken pipe an error again, as everywhere in Python: Gmsh lets it end the process silently.

    Python still assumes that it ignores the signal, and only its main thread may set one: hence the C library.
    """
    if os.name == "posix" and signal.getsignal(signal.SIGPIPE) == signal.SIG_IGN:
        ctypes.CDLL(None).signal(signal.SIGPIPE, int(signal.SIG_IGN))


def load() -> Any:
    """Import gmsh; raises ImportError or OSError where it cannot be loaded."""
    import gmsh  # type: ignore[import-untyped,unused-ignore]

    return gmsh


@session()
def cells_of(
    plan: Plan,
    size: float,
    smaller: Sources,
    scale: float,
    slope: float = SLOPE,
    triangles_alone: bool = False,
) -> Cells:
    """Return Gmsh's mesh of twice the required sizes: mostly quadrilaterals, or triangles alone.

    Cells grow by `slope` of the distance from smaller ones.
    """
    gmsh = load()
    if triangles_alone:
        gmsh.option.setNumber("Mesh.Algorithm", FRONTAL_DELAUNAY)
        gmsh.option.setNumber("Mesh.RecombineAll", 0)
    geometry = PlanGeometry(gmsh, plan)
    _set_sizes(geometry, plan, size, smaller, scale, slope)
    unwanted = [part for part in gmsh.model.getEntities(2) if part[1] not in geometry.faces]
    gmsh.model.removeEntities(unwanted, recursive=True)
    gmsh.model.mesh.generate(2)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    nodes = coordinates.reshape(-1, 3)[:, :2] / geometry.scale + geometry.middle
    index = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    index[tags.astype(np.int64)] = np.arange(len(tags))

    def elements(tag: int, kind: int, corners: int) -> Integers:
        node_tags = gmsh.model.mesh.getElementsByType(kind, tag)[1].astype(np.int64)
        result: Integers = index[node_tags].reshape(-1, corners)
        return result

    triangles, quadrilaterals = [], []
    for tag in sorted(geometry.faces):
        three, four = elements(tag, 2, 3), elements(tag, 3, 4)
        turn = -1 if _clockwise(nodes, three, four) else 1
        triangles.append(three[:, ::turn])
        quadrilaterals.append(four[:, ::turn])
    points = np.concatenate([gmsh.model.mesh.getNodes(0, tag)[0] for _, tag in gmsh.model.getEntities(0)])
    points = index[points.astype(np.int64)]
    _snap_corners(plan, nodes, points)
    drawn = _fixed_sides(geometry, plan, nodes, points, lambda tag: elements(tag, 1, 2))
    return Cells(nodes, np.concatenate(triangles), np.concatenate(quadrilaterals), drawn)


class PlanGeometry:
    """A plan in Gmsh's geometry, centered and scaled: its domain cut along everything that meshes must follow."""

    def __init__(self, gmsh: Any, plan: Plan) -> None:
        self.gmsh = gmsh
        x0, y0, x1, y1 = plan.bounds
        self.middle = np.array([(x0 + x1) / 2, (y0 + y1) / 2])
        self.scale = SCALED_EXTENT / plan.extent
        occ = gmsh.model.occ
        outlines = [(2, self.face(ring)) for ring in plan.outlines]
        openings = [(2, self.face(ring)) for ring in plan.openings]
        keep = {"removeObject": False, "removeTool": False}
        plate = occ.cut(outlines, openings, **keep)[0] if openings else outlines
        zones = []
        for ring, _ in plan.zones:
            zones += occ.intersect([(2, self.face(ring))], plate, removeObject=True, removeTool=False)[0]
        domain = plate if plan.beyond is None else [(2, self.face(plan.beyond))]
        borders = []
        for ring in plan.borders:
            borders += occ.intersect([(2, self.face(ring))], domain, removeObject=True, removeTool=False)[0]
        lines = [(1, self.curve(edge, self.point(edge.start), self.point(edge.end))) for edge in plan.line_segments()]
        points = [(0, self.point(point)) for point in plan.points]
        tools = [part for part in [*outlines, *openings, *zones, *borders, *lines, *points] if part not in domain]
        self.faces = {tag for _, tag in domain}
        self.inside = set(self.faces)
        if tools or len(domain) > 1:  # several plates may share a line
            _, origin = occ.fragment(domain, tools)
            parts = domain + tools
            self.faces = {tag for part in origin[: len(domain)] for _, tag in part}
            fragments = [origin[parts.index(outline)] for outline in outlines if outline in parts]
            self.inside = {tag for fragment in fragments for _, tag in fragment} if fragments else set(self.faces)
            self.inside &= self.faces

    def point(self, place: Place) -> int:
        """Add a point and return its tag."""
        x, y = (np.array(place) - self.middle) * self.scale
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


def _set_sizes(geometry: PlanGeometry, plan: Plan, size: float, smaller: Sources, scale: float, slope: float) -> None:
    """Set the size field: twice the required sizes, since elements are halved afterwards."""
    gmsh = geometry.gmsh
    coarse = float(2 * size * geometry.scale)
    field, far = gmsh.model.mesh.field, 4 * SCALED_EXTENT
    requested: dict[int, list[int]] = {}
    places, sizes = smaller
    level = np.floor(8 * np.log2(size / sizes)).astype(np.int64)
    for k, place in sorted({(int(k), (x, y)) for k, (x, y) in zip(level, places, strict=True)}):
        requested.setdefault(k, []).append(geometry.point(place))
    outlines = plan.outlines if plan.beyond is not None else ()
    around = [geometry.point((x, y)) for ring in outlines for x, y in along(ring, size)]
    gmsh.model.occ.synchronize()

    def near(points: list[int], least: float, growth: float) -> int:
        distance = field.add("Distance")
        field.setNumbers(distance, "PointsList", points)
        threshold = field.add("Threshold")
        field.setNumber(threshold, "InField", distance)
        field.setNumber(threshold, "SizeMin", least)
        field.setNumber(threshold, "SizeMax", least + growth * far)
        field.setNumber(threshold, "DistMin", 0.0)
        field.setNumber(threshold, "DistMax", far)
        return int(threshold)

    plate = field.add("MathEval")
    field.setString(plate, "F", f"{coarse!r}")
    limits = [near(points, coarse * 2 ** (-k / 8), slope) for k, points in requested.items()]
    if around:
        only = field.add("Restrict")
        field.setNumber(only, "InField", plate)
        field.setNumbers(only, "SurfacesList", sorted(geometry.inside))
        limits += [only, near(around, coarse, coarse / (scale * geometry.scale))]
    else:
        limits.append(plate)
    least = field.add("Min")
    field.setNumbers(least, "FieldsList", limits)
    field.setAsBackgroundMesh(least)


def _clockwise(nodes: Array, *kinds: Integers) -> bool:
    """Return whether the cells of a face run clockwise on the whole: a single one may be inverted until smoothing."""
    twice = 0.0
    for cells in kinds:
        x, y = np.moveaxis(nodes[cells], 2, 0)
        twice += float((x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y).sum())
    return twice < 0


def _snap_corners(plan: Plan, nodes: Array, corners: Integers) -> None:
    """Move the nodes at corners and points of a plan exactly onto them."""
    places = [point for ring in plan.rings().values() for point in ring.points]
    places += [*plan.points, *(point for line in plan.lines for point in line)]
    for place in np.array(places):
        distance = np.abs(nodes[corners] - place).max(axis=1)
        nodes[corners[distance <= FLAT * plan.extent]] = place


def _fixed_sides(
    geometry: PlanGeometry, plan: Plan, nodes: Array, points: Integers, sides_on: Callable[[int], Integers]
) -> FixedSides:
    """Return the sides on edges of the plan, after moving the nodes on arcs exactly onto these."""
    gmsh = geometry.gmsh
    arcs = plan.arcs()
    ends, centre, radius = [np.zeros((0, 2), dtype=np.int64)], [np.zeros((0, 2))], [np.zeros(0)]
    for _, tag in gmsh.model.getEntities(1):
        sides = sides_on(tag)
        if not len(sides):
            continue
        edge = Segment((0.0, 0.0), (0.0, 0.0))
        if gmsh.model.getType(1, tag) != "Line":
            (low,), (high,) = gmsh.model.getParametrizationBounds(1, tag)
            on_it = gmsh.model.getValue(1, tag, np.linspace(low, high, 5)).reshape(-1, 3)[:, :2]
            on_it = on_it / geometry.scale + geometry.middle
            edge = arcs[int(np.argmin([arc.distance(on_it).max() for arc in arcs]))]
            inner = np.setdiff1d(sides, points)
            nodes[inner] = project_onto(nodes[inner], np.array(edge.centre), edge.radius)
        ends.append(sides)
        centre.append(np.tile(edge.centre, (len(sides), 1)))
        radius.append(np.full(len(sides), edge.radius))
    return FixedSides(np.concatenate(ends), np.concatenate(centre), np.concatenate(radius), points)
