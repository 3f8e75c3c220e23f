"""A slab from an IFC file: its plan, and the columns and walls that stand on it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from groundslab.errors import InputError
from groundslab.exchange import dxf
from groundslab.exchange.ifc.body import SAME_AREA, Body, to_ring
from groundslab.exchange.ifc.file import IfcFile, map_note, open_file
from groundslab.exchange.ifc.slab import (
    Slab,
    SlabInFile,
    choose_slab,
    contradictions,
    find_slabs,
    name_of,
    read_slab,
    storey_name,
    storey_of,
)
from groundslab.exchange.report import ReportLine, report_lines
from groundslab.geometry.plan import Place, Ring
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from shapely import Polygon

#: A foot so near the slab's top [m], or within the slab, stands on it.
ON_TOP = 0.05
#: Parts of a wall's axis on the slab are this long at least [m].
SHORTEST = 0.05
#: Classes that a foundation may hold, and that are not read.
NOT_READ = ("IfcBeam", "IfcPile", "IfcReinforcingElement", "IfcStair", "IfcRamp", "IfcStructuralActivity")
ONLY = (
    "The outline, openings and thickness of one slab are read, and the columns and walls that stand on it; materials, "
    "loads, supports and ground are not."
)


@dataclass(frozen=True, slots=True)
class IfcCase:
    """A slab that was read from an IFC file.

    Attributes
    ----------
    slab : str
        The name of the slab.
    text : str
        The text of a case file; what the file lacks is there to be filled in.
    report : tuple of ReportLine
        What became of the elements of the file.
    notes : tuple of str
        Unit, storey, origin and place on the map, in words.
    origin : tuple of float
        The point (x, y) of the file [m] from which coordinates are measured.
    """

    slab: str
    text: str = field(repr=False)
    report: tuple[ReportLine, ...] = field(repr=False)
    notes: tuple[str, ...] = field(repr=False)
    origin: tuple[float, float] = (0.0, 0.0)

    def report_text(self) -> str:
        """Return the report on the file: counts by class, then what was taken and left out, with the reasons.

        Returns
        -------
        str
            The report, line by line, for people.
        """
        lines = [f"slab: {describe(self.slab)}", *self.notes, ONLY, "", *report_lines(self.report, "class")]
        return "\n".join(lines) + "\n"


def read_ifc(
    path: str | Path, slab: str = "", origin: Literal["own", "center"] = "own", align: bool = False
) -> IfcCase:
    """Read a slab from an IFC 2x3 or IFC 4 file: geometry alone.

    Taken are its outline, the openings through it, its thickness if it is a plate, and the columns and walls whose feet
    are on its top, or within it. Curves become chords at most 1 mm off them, but circles stay circles.

    Parameters
    ----------
    path : str or pathlib.Path
        The file.
    slab : str, default: ""
        Name or GlobalId of the slab, an IfcSlab or an IfcFooting. By default the only one of the file.
    origin : {"own", "center"}, default: "own"
        Where coordinates are measured from: the file's own origin, or the middle of the slab's extents.
    align : bool, default: False
        Whether the plan is turned so that the slab's longest edge runs along x or y.

    Returns
    -------
    IfcCase
        The text of a case file, in which what the file lacks is to be filled in, and a report.

    Raises
    ------
    InputError
        If the file cannot be read, holds several slabs, which are listed, or the slab's top is not level; or if
        ifcopenshell is missing (extra `ifc`).

    Examples
    --------
    >>> import groundslab
    >>> case = groundslab.read_ifc("building.ifc", "Raft")
    >>> print(case.text)
    """
    file = open_file(str(path))
    element = choose_slab(file, slab)
    report: list[ReportLine] = []
    chosen = read_slab(file, element, report)
    columns = list(_columns(file, chosen, report))
    walls = list(_walls(file, chosen, report))
    _report_others(file, element, report)
    drawing = _to_drawing(file, chosen, columns, walls)
    if origin == "center":
        drawing = dxf.center(drawing)
    if align:
        drawing = dxf.align(drawing)
    _remark_on_columns(drawing, report)
    if size := drawing.remark_on_size:
        report.append(ReportLine("IfcProject", "", None, size))
    place = f"unit: {file.unit} ({file.scale:.6g} m); {storey_of(file, element)}; top of the slab at {chosen.top:.6g} m"
    on_map = map_note(file)
    notes = (place, *([on_map] if on_map else []))
    text = dxf.to_case(drawing, chosen.name, "IFC file", [f"The slab is {describe(chosen.name)}. {ONLY}", *notes])
    return IfcCase(chosen.name, text, tuple(report), notes, drawing.origin)


def list_slabs(path: str | Path) -> tuple[SlabInFile, ...]:
    """Return the slabs of an IFC 2x3 or IFC 4 file, the lowest first and those that cannot be read last.

    Parameters
    ----------
    path : str or pathlib.Path
        The file.

    Raises
    ------
    InputError
        If the file cannot be read or holds no slab; or if ifcopenshell is missing (extra `ifc`).
    """
    file = open_file(str(path))
    slabs = [_survey_slab(file, element) for element in find_slabs(file)]
    return tuple(sorted(slabs, key=lambda slab: (bool(slab.problem), slab.height or 0.0)))


def _survey_slab(file: IfcFile, element: Any) -> SlabInFile:
    """Return what is said of a slab where one is chosen; counted is what its case would have."""
    about = (str(element.GlobalId), name_of(element), storey_name(file, element))
    try:
        slab = read_slab(file, element, [])
    except InputError as error:
        return SlabInFile(*about, problem="; ".join(issue.found for issue in error.issues))
    x0, y0, x1, y1 = slab.plan.bounds
    columns, walls = (sum(1 for _ in reader(file, slab, [])) for reader in (_columns, _walls))
    return SlabInFile(*about, slab.top, (x1 - x0, y1 - y0), columns, walls)


def _to_drawing(
    file: IfcFile, slab: Slab, columns: Sequence[tuple[str, Ring]], walls: Sequence[tuple[str, dxf.LineMark]]
) -> dxf.Drawing:
    """Return the plan of a slab with what stands on it, of which cases are made."""
    return dxf.Drawing(
        outline=to_ring(np.asarray(slab.plan.exterior.coords)),
        openings=tuple(to_ring(np.asarray(hole.coords)) for hole in slab.plan.interiors),
        zones=(),
        columns=tuple(ring for _, ring in columns),
        walls=tuple(wall for _, wall in walls),
        beams=(),
        point_loads=(),
        line_loads=(),
        area_loads=(),
        report=(),
        unit=file.unit,
        scale=file.scale,
        thickness=slab.thickness,
        column_names=_distinct([name for name, _ in columns]),
        wall_names=_distinct([name for name, _ in walls]),
    )


def _columns(file: IfcFile, slab: Slab, report: list[ReportLine]) -> Iterator[tuple[str, Ring]]:
    """Yield name and footprint of each column on the slab."""
    for element, pieces in _standing(file, "IfcColumn", slab, report):
        if len(pieces) > 1:
            report.append(ReportLine("IfcColumn", name_of(element), False, f"its foot is in {len(pieces)} pieces"))
            continue
        foot = pieces[0]
        if not slab.plan.covers(foot.centroid):
            report.append(ReportLine("IfcColumn", name_of(element), False, "beside the slab, or over an opening"))
            continue
        shape = foot.convex_hull
        remark = ""
        if shape.area > (1 + SAME_AREA) * foot.area:
            remark = ", the shape around it: it is hollow or has reentrant corners, and base plates are not read"
        ring = to_ring(np.asarray(shape.exterior.coords))
        report.append(ReportLine("IfcColumn", name_of(element), True, f"column{remark}"))
        yield name_of(element), ring


def _remark_on_columns(drawing: dxf.Drawing, report: list[ReportLine]) -> None:
    """Report columns that are not taken as they are."""
    for name, column in zip(drawing.column_names, drawing.columns, strict=True):
        if isinstance(column, Ring) and (remark := dxf.remark_on_column(column)):
            report.append(ReportLine("IfcColumn", name, None, remark))


def _walls(file: IfcFile, slab: Slab, report: list[ReportLine]) -> Iterator[tuple[str, dxf.LineMark]]:
    """Yield name, axis and thickness of each wall on the slab; one that leaves it has a part for each piece on it.

    So has one whose foot is in pieces, as between doors that are cut into its body.
    """
    for element, pieces in _standing(file, "IfcWall", slab, report):
        strips = [strip for piece in pieces if (strip := dxf.strip_of(piece)) is not None]
        if len(strips) < len(pieces):
            why = "its foot is not a straight strip, as of curved walls and of corners"
            report.append(ReportLine("IfcWall", name_of(element), False, why))
            continue
        width = max(width for _, width in strips)
        placed = [_on_slab(axis, slab) for axis, _ in strips]
        if not any(parts for parts, _ in placed):
            report.append(ReportLine("IfcWall", name_of(element), False, "its axis is beside the slab"))
            continue
        cut = f", in {len(strips)} pieces as between doors" if len(strips) > 1 else ""
        cut += "" if all(whole for _, whole in placed) else ", as far as its axis is on the slab"
        doors = ", its openings are not read" if element.HasOpenings else ""
        report.append(ReportLine("IfcWall", name_of(element), True, f"wall, {width:.6g} m thick{cut}{doors}"))
        report += contradictions(file, element, width)
        for (parts, _), (_, thickness) in zip(placed, strips, strict=True):
            for ends in parts:
                yield name_of(element), dxf.LineMark(ends, (0.0,) * (len(ends) - 1), round(thickness, 9), "")


def _on_slab(ends: tuple[Place, Place], slab: Slab) -> tuple[list[tuple[Place, ...]], bool]:
    """Return the parts of an axis on the slab, and whether they are all of it."""
    from shapely import LineString

    axis = LineString(ends)
    on_slab = axis.intersection(slab.plan.buffer(1e-6))
    parts = [part for part in getattr(on_slab, "geoms", [on_slab]) if part.length >= SHORTEST]
    whole = sum(part.length for part in parts) > axis.length - 1e-5
    lines = [axis] if whole else parts
    return [tuple((round(x, 9) + 0.0, round(y, 9) + 0.0) for x, y in line.coords) for line in lines], whole


def _standing(file: IfcFile, kind: str, slab: Slab, report: list[ReportLine]) -> Iterator[tuple[Any, list[Polygon]]]:
    """Yield the elements of a class whose feet are on the slab, with their feet in plan, which may be in pieces."""
    for element in file.by_type(kind):
        body = file.body(element)
        why = body if isinstance(body, str) else _why_not_on(slab, body)
        pieces: list[Polygon] = []
        if not why and isinstance(body, Body):
            foot = body.face(body.bottom)
            pieces = [piece for piece in getattr(foot, "geoms", [foot]) if piece.geom_type == "Polygon" and piece.area]
            why = "" if pieces else "its foot is not level"
        if why:
            report.append(ReportLine(kind, name_of(element), False, why))
        else:
            yield element, pieces


def _why_not_on(slab: Slab, body: Body) -> str:
    """Return why an element does not stand on the slab by its height, nothing if it does."""
    if body.top <= slab.top + ON_TOP:
        return "it ends below the slab's top"
    if body.bottom > slab.top + ON_TOP:
        return "it begins above the slab's top, such as on another storey"
    if body.bottom < slab.bottom - ON_TOP:
        return "it goes through the slab"
    return ""


def _report_others(file: IfcFile, chosen: Any, report: list[ReportLine]) -> None:
    """Report how many elements there are of classes that are not read."""
    counts = Counter({kind: len(file.by_type(kind)) for kind in NOT_READ})
    slabs = [element for kind in ("IfcSlab", "IfcFooting") for element in file.by_type(kind) if element != chosen]
    report += [ReportLine(element.is_a(), name_of(element), False, "another slab") for element in slabs]
    for kind, count in counts.items():
        if count:
            report.append(ReportLine(kind, "", None, f"{count:,} of them, not read"))


def _distinct(names: list[str]) -> tuple[str, ...]:
    """Return names, those that occur before with a number behind them."""
    taken: set[str] = set()
    distinct = []
    for name in names:
        number, free = 1, name
        while free in taken:
            number += 1
            free = f"{name} ({number})"
        taken.add(free)
        distinct.append(free)
    return tuple(distinct)
