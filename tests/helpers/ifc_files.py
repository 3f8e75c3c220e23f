"""IFC files of known geometry, built with ifcopenshell's own interface."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

Point = tuple[float, float]
#: A slab of 6 m by 4 m.
SLAB: tuple[Point, ...] = ((0, 0), (6, 0), (6, 4), (0, 4))
#: Size of a unit in meters, and how ifcopenshell calls it.
UNITS: dict[str, tuple[float, dict[str, Any]]] = {
    "m": (1.0, {"is_metric": True, "raw": "METERS"}),
    "mm": (1e-3, {"is_metric": True, "raw": "MILLIMETERS"}),
    "ft": (0.3048, {"is_metric": False, "raw": "FEET"}),
}


def turned(angle: float, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> np.ndarray:
    """Return the placement that turns about z by an angle [degrees] and then moves by x, y, z [m]."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return np.array([[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, z], [0, 0, 0, 1.0]])


class Building:
    """A project with one storey; lengths are given in meters, whatever the unit of the file is."""

    def __init__(
        self, unit: str = "m", version: str = "IFC4", storey: np.ndarray | None = None, site: np.ndarray | None = None
    ) -> None:
        """``storey`` is placed relative to the building, and this relative to ``site``, which is in the world."""
        from ifcopenshell.api import aggregate, context, project, root
        from ifcopenshell.api import unit as units

        self.file = project.create_file(version=version)
        if version == "IFC2X3":
            # which wants to know who made each thing
            create = self.file.create_entity
            firm = create("IfcOrganization", Name="Firm")
            create("IfcPersonAndOrganization", create("IfcPerson", FamilyName="Somebody"), firm)
            create("IfcApplication", firm, "1", "tests", "tests")
        self.size, about = UNITS.get(unit, (1.0, {}))
        self.project = root.create_entity(self.file, ifc_class="IfcProject", name="Project")
        if about:
            units.assign_unit(self.file, length=about)
        model = context.add_context(self.file, context_type="Model")
        self.body = context.add_context(
            self.file, context_type="Model", context_identifier="Body", target_view="MODEL_VIEW", parent=model
        )
        above = self.project
        for kind, name, place in (("IfcSite", "Site", site), ("IfcBuilding", "House", None),
                                  ("IfcBuildingStorey", "Ground floor", storey)):  # fmt: skip
            part = root.create_entity(self.file, ifc_class=kind, name=name)
            aggregate.assign_object(self.file, products=[part], relating_object=above)
            self.place(part, np.eye(4) if place is None else place, above if above is not self.project else None)
            above = part
        self.storey = above

    def length(self, value: float) -> float:
        """Return a length [m] in the file's unit."""
        return value / self.size

    def place(self, element: Any, matrix: np.ndarray, relative_to: Any = None) -> None:
        """Give an element a placement relative to another one, or in the world."""

        def triple(kind: str, values: Sequence[float]) -> Any:
            return self.file.create_entity(kind, tuple(map(float, values)))

        place = self.file.create_entity(
            "IfcAxis2Placement3D",
            triple("IfcCartesianPoint", matrix[:3, 3] / self.size),
            triple("IfcDirection", matrix[:3, 2]),
            triple("IfcDirection", matrix[:3, 0]),
        )
        above = None if relative_to is None else relative_to.ObjectPlacement
        element.ObjectPlacement = self.file.create_entity("IfcLocalPlacement", above, place)

    def polygon(self, points: Sequence[Point], holes: Sequence[Sequence[Point]] = ()) -> Any:
        """Return a profile through points [m]."""

        def curve(corners: Sequence[Point]) -> Any:
            places = [
                self.file.create_entity("IfcCartesianPoint", (self.length(x), self.length(y)))
                for x, y in (*corners, corners[0])
            ]
            return self.file.create_entity("IfcPolyline", places)

        if holes:
            inner = list(map(curve, holes))
            return self.file.create_entity("IfcArbitraryProfileDefWithVoids", "AREA", None, curve(points), inner)
        return self.file.create_entity("IfcArbitraryClosedProfileDef", "AREA", None, curve(points))

    def profile(self, kind: str, **sizes: float) -> Any:
        """Return a profile of a class with its sizes [m]."""
        return self.file.create_entity(kind, ProfileType="AREA", **{k: self.length(v) for k, v in sizes.items()})

    def add(
        self, kind: str, name: str | None, profile: Any, height: float, place: np.ndarray | None = None,
        voids: Any = None,
    ) -> Any:  # fmt: skip
        """Add an element: a profile in its own x and y, extruded upwards, placed relative to the storey."""
        from ifcopenshell.api import root, spatial
        from ifcopenshell.api.feature import add_feature

        element = root.create_entity(self.file, ifc_class=kind, name=name)
        up = self.file.create_entity("IfcDirection", (0.0, 0.0, 1.0))
        origin = self.file.create_entity("IfcCartesianPoint", (0.0, 0.0, 0.0))
        own = self.file.create_entity("IfcAxis2Placement3D", origin)
        solid = self.file.create_entity("IfcExtrudedAreaSolid", profile, own, up, self.length(height))
        shape = self.file.create_entity("IfcShapeRepresentation", self.body, "Body", "SweptSolid", [solid])
        element.Representation = self.file.create_entity("IfcProductDefinitionShape", None, None, [shape])
        if voids is None:
            spatial.assign_container(self.file, products=[element], relating_structure=self.storey)
        else:
            add_feature(self.file, feature=element, element=voids)
        self.place(element, np.eye(4) if place is None else place, self.storey if voids is None else voids)
        return element

    def tessellate(self, element: Any, cells: Sequence[Sequence[float]], kind: str) -> None:
        """Give an element a body of faces in place of its own: boxes (x0, x1, y0, y1, z0, z1) [m] side by side.

        ``kind`` is IfcTriangulatedFaceSet, IfcPolygonalFaceSet or IfcFacetedBrep; coordinates are the element's own.
        """
        corners, quads = dict[tuple[float, ...], int](), dict[frozenset[int], list[int]]()
        for x0, x1, y0, y1, z0, z1 in cells:
            numbers = [
                corners.setdefault(each, len(corners) + 1)
                for z in (z0, z1)
                for each in ((x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z))
            ]
            for side in ((3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):
                quad = [numbers[n] for n in side]
                # a side that two boxes share lies within
                if quads.pop(frozenset(quad), None) is None:
                    quads[frozenset(quad)] = quad
        places = [tuple(map(self.length, each)) for each in corners]
        create = self.file.create_entity
        if kind == "IfcFacetedBrep":
            points = [create("IfcCartesianPoint", place) for place in places]
            loops = [create("IfcPolyLoop", [points[n - 1] for n in quad]) for quad in quads.values()]
            faces = [create("IfcFace", [create("IfcFaceOuterBound", loop, True)]) for loop in loops]
            body = create(kind, create("IfcClosedShell", faces))
        elif kind == "IfcPolygonalFaceSet":
            faces = [create("IfcIndexedPolygonalFace", quad) for quad in quads.values()]
            body = create(kind, create("IfcCartesianPointList3D", places), True, faces)
        else:
            triangles = [part for a, b, c, d in quads.values() for part in ((a, b, c), (a, c, d))]
            body = create(kind, Coordinates=create("IfcCartesianPointList3D", places), CoordIndex=triangles)
        (shape,) = element.Representation.Representations
        shape.RepresentationType = "Brep" if kind == "IfcFacetedBrep" else "Tessellation"
        shape.Items = [body]

    def slab(
        self, name: str = "Raft", points: Sequence[Point] = SLAB, thickness: float = 0.3,
        place: np.ndarray | None = None,
    ) -> Any:  # fmt: skip
        """Add a slab whose top is at the height of its placement."""
        top = np.eye(4) if place is None else place
        return self.add("IfcSlab", name, self.polygon(points), thickness, top @ turned(0, z=-thickness))

    def write(self, path: Path) -> Path:
        """Write the file."""
        self.file.write(str(path))
        return path
