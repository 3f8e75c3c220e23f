"""Bars as a building model: IFC4, each an IfcReinforcingBar with a swept disk, those of a mark in one group."""

from __future__ import annotations

import math
import uuid
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab._version import __version__
from groundslab.arrays import Array
from groundslab.design.bars.bending import LEG, STUD, BentBar, grade_of
from groundslab.design.bars.placed import PlacedBar
from groundslab.design.bars.positions import U_SHAPE
from groundslab.optional import import_optional
from groundslab.schema.wording import printable
from groundslab.storage.ownership import check_replaceable

if TYPE_CHECKING:
    from groundslab.model.model import Model

#: What a file says of itself, by which it is known, and within how many bytes of its beginning.
MARK, LOOK = "groundslab bars", 4096
#: What bars are for, in the words of IfcReinforcingBarTypeEnum.
ROLES = {U_SHAPE: "EDGE", LEG: "PUNCHING", STUD: "STUD"}
#: From which names identifiers are made: the same bars have the same ones.
NAMESPACE = uuid.UUID("5a3c8f1e-6a0b-4a66-9a51-7d0f2f5a9c11")


def check(path: str | Path) -> Path:
    """Return the full path if a building model can be written there; else raise InputError saying why not."""
    _import_ifc()
    return check_replaceable(path, is_ours, "a building model of bars by groundslab")


def is_ours(path: Path) -> bool:
    """Return whether a file is a building model of bars that groundslab wrote."""
    with path.open("rb") as file:
        return MARK.encode() in file.read(LOOK)


def to_bytes(model: Model, placed: Sequence[PlacedBar]) -> bytes:
    """Return bars as the content of an IFC file; the same bars give the same bytes."""
    writer = _Writer(model)
    by_mark: dict[str, list[Any]] = {}
    for number, placed_bar in enumerate(placed):
        by_mark.setdefault(placed_bar.bar.mark.partition("-")[0], []).append(writer.add_bar(placed_bar, number))
    writer.add_to_storey([bar for bars in by_mark.values() for bar in bars])
    for mark, bars in by_mark.items():
        writer.add_group(mark, bars)
    content: str = writer.file.to_string()
    return content.encode()


def _import_ifc() -> Any:
    return import_optional("ifcopenshell", "which writes building models", "ifc")


class _Writer:
    """Writes entities into a file of its own."""

    def __init__(self, model: Model) -> None:
        ifcopenshell = _import_ifc()
        self.file = ifcopenshell.file(schema="IFC4")
        header = self.file.header
        header.file_name.name = ""
        header.file_name.time_stamp = "1970-01-01T00:00:00"
        header.file_name.preprocessor_version = header.file_name.originating_system = f"{MARK} {__version__}"
        self.create = self.file.create_entity
        self.compress = import_optional("ifcopenshell.guid", "which writes building models", "ifc").compress
        self.steel = model.reinforcement
        about = () if model.project is None else (model.project.number, model.project.name, model.project.part)
        self.namespace = uuid.uuid5(NAMESPACE, "|".join((*about, model.title)))
        self.representations: dict[tuple[Any, ...], Any] = {}
        origin = self.create("IfcCartesianPoint", (0.0, 0.0, 0.0))
        self.world = self.create("IfcAxis2Placement3D", origin)
        self.context = self.create("IfcGeometricRepresentationContext", None, "Model", 3, 1e-6, self.world)
        self.body = self.create(
            "IfcGeometricRepresentationSubContext", "Body", "Model", ParentContext=self.context, TargetView="MODEL_VIEW"
        )
        length = self.create("IfcSIUnit", UnitType="LENGTHUNIT", Name="METRE")
        area = self.create("IfcSIUnit", UnitType="AREAUNIT", Name="SQUARE_METRE")
        units = self.create("IfcUnitAssignment", (length, area))
        named = model.project.name if model.project is not None and model.project.name else model.title
        self.project = self.create(
            "IfcProject", self.identifier("project"), Name=printable(named) or "groundslab",
            RepresentationContexts=(self.context,), UnitsInContext=units,
        )  # fmt: skip
        above, self.storey = self.project, None
        for kind, name in (
            ("IfcSite", "Site"),
            ("IfcBuilding", "Building"),
            ("IfcBuildingStorey", printable(model.title)),
        ):
            part = self.create(kind, self.identifier(kind), Name=name, ObjectPlacement=self.placement())
            self.create("IfcRelAggregates", self.identifier(f"{kind} in"), None, None, None, above, (part,))
            above = part
        self.storey = above

    def identifier(self, name: str) -> str:
        """Return the identifier of something by its name, another one in each project."""
        guid: str = self.compress(uuid.uuid5(self.namespace, name).hex)
        return guid

    def placement(self, place: Sequence[float] = (0.0, 0.0, 0.0)) -> Any:
        """Return a placement in the world [m]."""
        at = self.create("IfcCartesianPoint", tuple(float(x) for x in place))
        return self.create("IfcLocalPlacement", None, self.create("IfcAxis2Placement3D", at))

    def add_bar(self, placed: PlacedBar, number: int) -> Any:
        """Return a bar that was added."""
        bar, start = placed.bar, placed.corners[0]
        return self.create(
            "IfcReinforcingBar",
            self.identifier(f"bar {number}"),
            Name=bar.mark,
            Description=bar.layer,
            ObjectPlacement=self.placement(start.tolist()),
            Representation=self.shape(bar, placed.corners - start),
            SteelGrade=None if self.steel is None else grade_of(self.steel),
            NominalDiameter=bar.diameter,
            CrossSectionArea=math.pi * bar.diameter**2 / 4,
            BarLength=bar.length,
            PredefinedType="LIGATURE" if placed.of_beam else ROLES.get(bar.shape, "MAIN"),
            BarSurface="TEXTURED",
        )

    def shape(self, bar: BentBar, corners: Array) -> Any:
        """Return the shape of a bar from its first corner; bars that are alike share their solid."""
        key = (bar.diameter, bar.mandrel, *np.round(corners, 6).ravel().tolist())
        if key not in self.representations:
            curve = self.curve(corners, None if bar.mandrel is None else (bar.mandrel + bar.diameter) / 2)
            solid = self.create("IfcSweptDiskSolid", curve, bar.diameter / 2)
            mapped = self.create("IfcShapeRepresentation", self.body, "Body", "AdvancedSweptSolid", (solid,))
            self.representations[key] = self.create("IfcRepresentationMap", self.world, mapped)
        origin = self.create("IfcCartesianPoint", (0.0, 0.0, 0.0))
        target = self.create("IfcCartesianTransformationOperator3D", LocalOrigin=origin)
        item = self.create("IfcMappedItem", self.representations[key], target)
        representation = self.create("IfcShapeRepresentation", self.body, "Body", "MappedRepresentation", (item,))
        return self.create("IfcProductDefinitionShape", Representations=(representation,))

    def curve(self, corners: Array, radius: float | None) -> Any:
        """Return the axis of a bar, straight between its bends, which are arcs of a radius [m]."""
        points, segments = axis_points(corners, radius)
        kinds = {2: "IfcLineIndex", 3: "IfcArcIndex"}
        listed = self.create("IfcCartesianPointList3D", [tuple(map(float, point)) for point in points])
        indices = [self.create(kinds[len(at)], at) for at in segments]
        return self.create("IfcIndexedPolyCurve", listed, indices, False)

    def add_to_storey(self, bars: Sequence[Any]) -> None:
        """Put bars into the storey."""
        if bars:
            self.create(
                "IfcRelContainedInSpatialStructure", self.identifier("contained"), None, None, None, tuple(bars),
                self.storey,
            )  # fmt: skip

    def add_group(self, mark: str, bars: Sequence[Any]) -> None:
        """Put the bars of a mark into a group of their own."""
        group = self.create("IfcGroup", self.identifier(f"group {mark}"), Name=mark, ObjectType="bars of a mark")
        self.create(
            "IfcRelAssignsToGroup", self.identifier(f"in group {mark}"), None, None, None, tuple(bars), None, group
        )


def axis_points(corners: Array, radius: float | None) -> tuple[list[Array], list[tuple[int, ...]]]:
    """Return points along an axis with its corners rounded, and from which to which lines and arcs run, from 1."""
    points, segments = [corners[0]], list[tuple[int, ...]]()
    for before, corner, after in zip(corners, corners[1:], corners[2:], strict=False):
        back, ahead = before - corner, after - corner
        back, ahead = back / np.linalg.norm(back), ahead / np.linalg.norm(ahead)
        if radius is None:
            points.append(corner)
            segments.append((len(points) - 1, len(points)))
            continue
        half = math.acos(float(np.clip(back @ ahead, -1.0, 1.0))) / 2  # between the sides
        middle = corner + (back + ahead) / np.linalg.norm(back + ahead) * (radius / math.sin(half) - radius)
        reach = radius / math.tan(half)
        points += [corner + reach * back, middle, corner + reach * ahead]
        last = len(points)
        segments += [(last - 3, last - 2), (last - 2, last - 1, last)]
    points.append(corners[-1])
    return points, [*segments, (len(points) - 1, len(points))]
