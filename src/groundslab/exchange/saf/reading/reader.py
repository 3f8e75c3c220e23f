"""A slab from a file in the Structural Analysis Format, as the parts of a case with a report."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from groundslab.case import casefile
from groundslab.case.numbers import find_decimals
from groundslab.errors import InputError, Issue
from groundslab.exchange import blanks
from groundslab.exchange.report import ReportLine, report_lines
from groundslab.exchange.saf.reading.cases import read_cases, read_combinations
from groundslab.exchange.saf.reading.context import AXES, ReadContext, RowFault, text, word
from groundslab.exchange.saf.reading.ground import read_ground, read_supports
from groundslab.exchange.saf.reading.loads.column_forces import read_forces
from groundslab.exchange.saf.reading.loads.forces import Loads
from groundslab.exchange.saf.reading.loads.on_members import read_loads, read_settlements
from groundslab.exchange.saf.reading.slab import Slab, SlabInFile, choose_slab, find_slabs
from groundslab.exchange.saf.reading.structure import read_beams, read_columns, read_plate, read_walls
from groundslab.exchange.saf.reading.workbook import Row, find_doubles, read_sheets
from groundslab.exchange.saf.units import to_si, unit_of
from groundslab.exchange.size import remark_on_size
from groundslab.model.model import Model
from groundslab.model.outputs import Project
from groundslab.model.reactions import Decimals
from groundslab.model.structure.columns import Column
from groundslab.schema.wording import describe, quote

#: The sheets that are read.
SHEETS = frozenset({
    "Project", "Model", "StructuralMaterial", "StructuralCrossSection", "StructuralPointConnection",
    "StructuralCurveMember", "StructuralCurveMemberRib", "StructuralCurveEdge", "StructuralSurfaceMember",
    "StructuralSurfaceMemberOpening", "StructuralSurfaceMemberRegion", "StructuralPointSupport",
    "StructuralEdgeConnection", "StructuralCurveConnection", "StructuralSurfaceConnection", "StructuralLoadGroup",
    "StructuralLoadCase", "StructuralLoadCombination", "StructuralPointAction", "StructuralPointActionFree",
    "StructuralPointMoment", "StructuralCurveAction", "StructuralCurveActionFree", "StructuralCurveMoment",
    "StructuralSurfaceAction", "StructuralSurfaceActionFree", "StructuralSurfaceActionThermal",
    "StructuralPointSupportDeformation", "ResultInternalForce1D", "ResultInternalForce2DEdge",
})  # fmt: skip

_GROUND = ("", "# The file has no ground under the slab; groundslab new shows all kinds.", *blanks.GROUND)
_LOADS = ("", "# The file has no loads on the slab.", *blanks.LOADS)


@dataclass(frozen=True, slots=True)
class SafCase:
    """A slab that was read from a file in the Structural Analysis Format.

    Attributes
    ----------
    slab : str
        The name of the slab.
    parts : mapping of str to object
        What the file says of it, by the keys of a Model.
    report : tuple of ReportLine
        What became of each object of the file.
    """

    slab: str
    parts: Mapping[str, Any] = field(repr=False)
    report: tuple[ReportLine, ...] = field(repr=False)

    @property
    def model(self) -> Model:
        """The model; raises InputError if the file lacks ground or loads, or what it says does not fit together."""
        return Model(**self.parts)

    @property
    def text(self) -> str:
        """The text of a case file; what the file lacks is there to be filled in."""
        head = [
            "# Input file of groundslab, made from a file in the Structural Analysis Format (SAF).",
            f"# The slab is {quote(self.slab)}. Coordinates are the file's own.",
            "# Loads and settlements are positive downwards. The slab may lift off the ground; springs of SAF act both",
            "# ways, as they do here with tensionless = false in [contact].",
        ]
        lacking = [*(_GROUND if "ground" not in self.parts else ()), *(_LOADS if not self.parts["loads"] else ())]
        return "\n".join([*head, "", *casefile.lines_of(self.parts, Model), *lacking]) + "\n"

    def report_text(self) -> str:
        """Return the report on the file: counts by sheet, then what was taken and left out, with the reasons.

        Returns
        -------
        str
            The report, line by line, for people.
        """
        return "\n".join([f"slab: {describe(self.slab)}", *report_lines(self.report, "sheet")]) + "\n"


def read_saf(path: str | Path, slab: str = "") -> SafCase:
    """Read a slab from a file in the Structural Analysis Format (SAF), versions 2.0 to 2.2.

    Parameters
    ----------
    path : str or pathlib.Path
        The file, a workbook (XLSX).
    slab : str, default: ""
        The name of the slab, a horizontal surface member. By default the only one with a surface support, or else the
        only one at the lowest height.

    Returns
    -------
    SafCase
        What the file says of the slab, as a model, as the text of a case file, and with a report.

    Raises
    ------
    InputError
        If the file cannot be read, holds several such slabs, or its rows on the slab are wrong; it lists all issues.
    """
    sheets, others = read_sheets(str(path), SHEETS)
    context = _begin(path, sheets)
    chosen = choose_slab(context, slab)
    parts = _read_parts(context, chosen)
    for sheet, count in others.items():
        if count > 0:
            context.note(None, f"about {count:,} rows, a sheet that is not read", sheet)
    if context.issues:
        raise InputError(context.issues)
    return SafCase(chosen.name, parts, tuple(dict.fromkeys(context.report)))


def list_slabs(path: str | Path) -> tuple[SlabInFile, ...]:
    """Return the slabs of a file in the Structural Analysis Format, none of another workbook.

    Parameters
    ----------
    path : str or pathlib.Path
        The file, a workbook (XLSX).

    Raises
    ------
    InputError
        If the file cannot be read.
    """
    sheets, _ = read_sheets(str(path), SHEETS)
    if not {"Model", "StructuralPointConnection", "StructuralSurfaceMember"} <= sheets.keys():
        return ()
    context = _begin(path, sheets)
    slabs = find_slabs(context)
    if context.issues:
        raise InputError(context.issues)
    return slabs


def _begin(path: str | Path, sheets: dict[str, list[Row]]) -> ReadContext:
    """Return what is known of a file before its slab is read; raises InputError."""
    context = ReadContext(str(path), sheets, decimals=_find_decimals(sheets))
    for issue in find_doubles(str(path), sheets):
        context.add(issue)
    _read_model_sheet(context)
    context.node_rows = {row.name: row for row in context.rows("StructuralPointConnection")}
    return context


def _find_decimals(sheets: Mapping[str, list[Row]]) -> Decimals | None:
    """Return what stands before decimals in cells that are texts, by all of those below headings with a unit."""
    cells = (row.cells[key] for rows in sheets.values() for row in rows for key, unit in row.units.items() if unit)
    parts = (part for cell in cells if isinstance(cell, str) for part in cell.split(";"))
    numbers = (part.rpartition(":")[2].strip("()[] ") for part in parts)
    return find_decimals(numbers, commas=True)


def _read_model_sheet(context: ReadContext) -> None:
    """Take axes and units from the sheet Model; raises InputError."""
    rows = context.rows("Model")
    if not rows:
        missing_sheet, expected = "no sheet Model", "a file in the Structural Analysis Format"
        raise InputError([Issue(context.path, missing_sheet, expected, "its sheet Model states units and axes")])
    with context.reading(rows[0]):
        context.imperial = _is_imperial(rows[0])
        if not (version := text(rows[0], "safversion")).startswith(("2.0", "2.1", "2.2")):
            context.note(None, f"version {version or 'not given'}, read as one of 2.0 to 2.2", "Model")
        vertical = " ".join(text(rows[0], "globalcoordinatesystem").lower().replace("-", "minus ").split())
        if vertical not in AXES:
            expected = "one of " + ", ".join(AXES)
            context.add(Issue(f"{context.path}, sheet Model, Global coordinate system", describe(vertical), expected))
        context.axes = AXES.get(vertical, context.axes)
    if context.issues:
        raise InputError(context.issues)


def _is_imperial(row: Row) -> bool:
    """Return whether the file's units are imperial: the first word of what it says; raises RowFault for any other."""
    said = word(row, "systemofunits", default="metric")
    first = said.split()[0]
    if first not in ("metric", "imperial"):
        raise RowFault("systemofunits", describe(said), "Metric or Imperial")
    return first == "imperial"


def _read_parts(context: ReadContext, slab: Slab) -> dict[str, Any]:
    """Return the parts of the case; issues are the context's."""
    plate = read_plate(context, slab)
    beams, columns, walls = read_beams(context, slab), read_columns(context, slab), read_walls(context, slab)
    if size := _remark_on_size(context, slab, columns):
        context.note(slab.row, size)
    ground, zones = read_ground(context, slab)
    supports, cases = read_supports(context, slab), read_cases(context)
    combinations, combine = read_combinations(context, cases)
    gathered = read_loads(context, slab, cases, bool(beams)) if cases else Loads()
    read_forces(context, slab, {case.name: case.action for case in cases}, gathered)
    loads = [*gathered.finish(columns), *read_settlements(context, supports, cases)]
    cases = [
        case.model_copy(update={"H_x": H[0], "H_y": H[1]})
        if any(H := gathered.horizontal.get(case.name, [0.0, 0.0]))
        else case
        for case in cases
    ]
    if slab.material.quality:
        quality = f"of quality {describe(slab.material.quality)}, to be given as concrete in [reinforcement]"
        context.note(slab.row, quality)
    parts: dict[str, Any] = {
        "title": _title(context),
        **_read_project(context),
        "plate": plate,
        "ground": ground,
        "soil_zones": zones if ground is not None else (),
        "supports": tuple(supports),
        "columns": tuple(columns),
        "walls": tuple(walls),
        "beams": tuple(beams),
        "cases": tuple(cases),
        "loads": tuple(loads),
        "combinations": tuple(combinations),
        "combine": combine,
    }
    if zones and ground is None:
        context.note(
            None, "ground of regions, left out: there is none under the rest of the slab", "StructuralSurfaceConnection"
        )
    return {name: part for name, part in parts.items() if part is not None}


def _remark_on_size(context: ReadContext, slab: Slab, columns: Sequence[Column]) -> str:
    """Return what of the size of a slab and its columns contradicts the unit of coordinates, nothing if they agree."""
    x, y = zip(*(place for edge in slab.edges for place in edge.points), strict=True)
    widths = [
        width for column in columns for width in (column.width_x, column.width_y, column.diameter) if width is not None
    ]
    unit = unit_of("length", context.imperial)
    return remark_on_size((max(x) - min(x), max(y) - min(y)), widths, unit, to_si(1.0, "length", context.imperial))


def _title(context: ReadContext) -> str:
    """Return the name of the model, or else that of the project."""
    rows = [*context.rows("Model"), *context.rows("Project")]
    return next((row.name for row in rows if row.name), "")


def _read_project(context: ReadContext) -> dict[str, Project]:
    """Return the title block and the units of output, nothing if the file has no words for it."""
    said: dict[str, Any] = {"units": "US"} if context.imperial else {}
    if rows := context.rows("Project"):
        model = context.rows("Model")[0]
        words = {"name": rows[0].name, "number": text(rows[0], "projectnr"), "author": text(model, "owner"),
                 "revision": text(model, "revisionnumber")}  # fmt: skip
        said |= {name: value for name, value in words.items() if value}
    return {"project": Project(**said)} if said else {}
