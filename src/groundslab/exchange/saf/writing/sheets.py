"""The sheets of a file that is written: their headings in the order of the format's documentation, and their rows."""

from __future__ import annotations

import io
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from groundslab.exchange.saf.units import IMPERIAL, from_si, heading_key, heading_unit, to_imperial
from groundslab.geometry.plan import Place
from groundslab.optional import import_optional

_PART = "Name; Material; Thickness [mm]; System plane at; 2D Member; Nodes; Edges; Eccentricity ez [mm]; Area [m2]"
_UNITS_OF_SUPPORTS = "Stiffness X [MN/m]; Stiffness Y [MN/m]; Stiffness Z [MN/m]; Stiffness Fix [MNm/rad]; " \
    "Stiffness Fiy [MNm/rad]; Stiffness Fiz [MNm/rad]"  # fmt: skip
_UNITS_OF_LINES = "Stiffness X [MN/m2]; Stiffness Y [MN/m2]; Stiffness Z [MN/m2]; Stiffness Fix [MNm/rad/m]; " \
    "Stiffness Fiy [MNm/rad/m]; Stiffness Fiz [MNm/rad/m]"  # fmt: skip
_ON_EDGES = "Member; Member Rib; 2D Member; 2D Member Region; 2D Member Opening; Edge; Internal edge; Load case; " \
    "Coordinate system; Location; Coordinate definition; Origin; Extent; Start point [m]; End point [m]"  # fmt: skip
_PLACES = "Coordinate X [m]; Coordinate Y [m]; Coordinate Z [m]"

#: Headings of the sheets, as version 2.2 names them.
HEADINGS: dict[str, str] = {
    "StructuralMaterial": "Name; Type; Subtype; Quality; Unit mass [kg/m3]; E modulus [MPa]; G modulus [MPa]; "
    "Poisson Coefficient; Thermal expansion [1/K]",
    "StructuralCrossSection": "Name; Material; Cross-section type; Shape; Parameters [mm]",
    "StructuralPointConnection": f"Name; {_PLACES}",
    "StructuralCurveMember": "Name; Type; Cross section; Nodes; Segments; Length [m]; Geometrical shape; LCS; "
    f"LCS Rotation [deg]; {_PLACES}; System line; Analysis Y Eccentricity of Beg Node [mm]; Analysis Z Eccentricity of "
    "Beg Node [mm]; Analysis Y Eccentricity of End Node [mm]; Analysis Z Eccentricity of End Node [mm]; Behaviour in "
    "analysis",
    "StructuralCurveMemberRib": "Name; 2D member; Cross section; Nodes; Segments; Geometrical shape; Alignment; "
    "Eccentricity ez [mm]; Type of connection; Shape of the rib; Behaviour in analysis; Effective width; "
    "Width left for check [mm]; Width right for check [mm]; Width left for internal forces [mm]; "
    "Width right for internal forces [mm]",
    "StructuralCurveEdge": "Name; 2D member; Nodes; Segments",
    "StructuralSurfaceMember": "Name; Type; Material; Thickness type; Thickness [mm]; System plane at; Nodes; "
    f"Internal nodes; Edges; LCS Type; {_PLACES}; LCS Rotation [deg]; Structural Z Eccentricity [mm]; "
    "Analysis Z Eccentricity [mm]; Shape; Behavior in analysis",
    "StructuralSurfaceMemberOpening": "Name; 2D Member; Nodes; Edges; Area [m2]",
    "StructuralSurfaceMemberRegion": _PART,
    "StructuralPointSupport": "Name; Type; Boundary condition; Node; ux; uy; uz; fix; fiy; fiz; " + _UNITS_OF_SUPPORTS,
    "StructuralEdgeConnection": "Name; Type; Boundary condition; 2D Member; Edge; Internal edge; ux; uy; uz; fix; fiy; "
    f"fiz; {_UNITS_OF_LINES}; Coordinate system; Coordinate definition; Origin; Start point [m]; End point [m]",
    "StructuralSurfaceConnection": "Name; 2D Member; 2D Member Region; Subsoil; Description; C1x [MN/m3]; C1y [MN/m3]; "
    "C1z Spring; C1z [MN/m3]; C2x [MN/m]; C2y [MN/m]",
    "StructuralLoadGroup": "Name; Load group type; Relation; Load type",
    "StructuralLoadCase": "Name; Description; Action type; Load group; Load type; Duration",
    "StructuralPointAction": "Name; Type; Direction; Force action; Reference node; Reference member; Value [kN]; "
    "Load case; Coordinate system",
    "StructuralPointActionFree": f"Name; Type; Direction; Value [kN]; Load case; {_PLACES}; Coordinate system",
    "StructuralPointMoment": "Name; Type; Direction; Force action; Reference node; Value [kNm]; Load case; "
    "Coordinate system",
    "StructuralCurveAction": f"Name; Type; Force action; Distribution; Direction; Value 1 [kN/m]; Value 2 [kN/m]; "
    f"{_ON_EDGES}; Eccentricity ey [mm]; Eccentricity ez [mm]",
    "StructuralCurveActionFree": "Name; Type; Distribution; Direction; Value 1 [kN/m]; Value 2 [kN/m]; Load case; "
    f"{_PLACES}; Segments; Coordinate system; Location",
    "StructuralCurveMoment": "Name; Type; Force action; Distribution; Direction; Value 1 [kNm/m]; Value 2 [kNm/m]; "
    f"{_ON_EDGES}",
    "StructuralSurfaceAction": "Name; Direction; Type; Force action; Value [kN/m2]; 2D Member; 2D Member Region; "
    "Load case; Coordinate system; Location",
    "StructuralSurfaceActionFree": "Name; Direction; Type; Distribution; q [kN/m2]; Load case; Validity; "
    f"Local Z direction; {_PLACES}; Edges; Coordinate system; Location",
    "StructuralSurfaceActionThermal": "Name; Variation; TempT [°C]; TempB [°C]; 2D Member; 2D Member Region; Load case",
    "StructuralPointSupportDeformation": "Name; Point support; Direction; Translation value [mm]; Load case",
    "ResultInternalForce2DEdge": "Result on; 2D member; Edge; Result for; Load case; Load combination; Section at [m]; "
    "Index; mx [kNm/m]; my [kNm/m]; mxy [kNm/m]; vx [kN/m]; vy [kN/m]; nx [kN/m]; ny [kN/m]; nxy [kN/m]",
}

#: The sheets in their order in the file, between Project and Model and the loads.
ORDER = ("Project", "Model", "StructuralMaterial", "StructuralCrossSection", "StructuralPointConnection",
         "StructuralSurfaceMember", "StructuralSurfaceMemberOpening", "StructuralSurfaceMemberRegion",
         "StructuralCurveMember", "StructuralCurveMemberRib", "StructuralCurveEdge", "StructuralPointSupport",
         "StructuralEdgeConnection", "StructuralSurfaceConnection", "StructuralLoadGroup", "StructuralLoadCase",
         "StructuralLoadCombination", "StructuralPointAction", "StructuralPointActionFree", "StructuralPointMoment",
         "StructuralCurveAction", "StructuralCurveActionFree", "StructuralCurveMoment", "StructuralSurfaceAction",
         "StructuralSurfaceActionFree", "StructuralSurfaceActionThermal", "StructuralPointSupportDeformation",
         "ResultInternalForce2DEdge")  # fmt: skip

#: What is written relative to lengths, although headings have a unit.
_RELATIVE = ("Start point", "End point")
#: Names of objects have no more letters.
LONGEST_NAME = 100
#: Letters of a sheet's name that Excel keeps.
LONGEST_SHEET_NAME = 31


@dataclass(slots=True)
class Sheets:
    """The rows that are written so far, by sheet, and what could not be written.

    Rows have their values by the keys of headings (`heading_key`).
    """

    rows: dict[str, list[dict[str, Any]]] = field(default_factory=lambda: defaultdict(list))
    left: list[str] = field(default_factory=list)
    nodes: dict[tuple[float, float, float], str] = field(default_factory=dict)
    names: dict[str, set[str]] = field(default_factory=lambda: defaultdict(set))

    def add(self, sheet: str, name: str, prefix: str, **cells: Any) -> str:
        """Add a row and return its name: the one wanted, or a free one like it."""
        wanted = name[:LONGEST_NAME].strip() or f"{prefix}{len(self.rows[sheet]) + 1}"
        chosen, number = wanted, 1
        while chosen in self.names[sheet]:
            number += 1
            chosen = f"{wanted} ({number})"
        self.names[sheet].add(chosen)
        self.rows[sheet].append({"name": chosen, **cells})
        return chosen

    def leave(self, what: str, why: str) -> None:
        """Note what is not in the file, or there in another way."""
        self.left.append(f"{what}: {why}")

    def node(self, place: Place, height: float = 0.0) -> str:
        """Return the name of the node at a place."""
        x, y, z = (from_si(value, "length") + 0.0 for value in (*place, height))
        if (x, y, z) not in self.nodes:
            name = self.add("StructuralPointConnection", "", "N", coordinatex=x, coordinatey=y, coordinatez=z)
            self.nodes[x, y, z] = name
        return self.nodes[x, y, z]

    def to_bytes(self, project: Mapping[str, str], model: Mapping[str, str]) -> bytes:
        """Return the file, in the system of units that the sheet Model names."""
        writer = import_optional("openpyxl", "which reads and writes workbooks", "exchange")
        book = writer.Workbook()
        book.remove(book.active)
        for name in ORDER:
            if name in ("Project", "Model"):
                lines: list[list[Any]] = [list(pair) for pair in (project if name == "Project" else model).items()]
            elif self.rows.get(name):
                headings = [heading.strip() for heading in self._headings(name).split(";")]
                keys = [heading_key(heading) for heading in headings]
                lines = [headings, *([row.get(key) for key in keys] for row in self.rows[name])]
                if model["System of units"] == "Imperial":
                    lines = _in_imperial_units(lines)
            else:
                continue
            _fill(book.create_sheet(name[:LONGEST_SHEET_NAME]), lines)
        content = io.BytesIO()
        book.save(content)
        return content.getvalue()

    def _headings(self, sheet: str) -> str:
        """Return the headings of a sheet, those of combinations for as many cases as there are."""
        if sheet != "StructuralLoadCombination":
            return HEADINGS[sheet]
        most = max(sum(key.startswith("loadcasename") for key in row) for row in self.rows[sheet])
        of_cases = (f"Load factor {n}; Multiplier {n}; Load case name {n}" for n in range(1, most + 1))
        return "; ".join(["Name", "Description", "Category", "National standard", "Type", *of_cases])


def _in_imperial_units(lines: list[list[Any]]) -> list[list[Any]]:
    """Return a table with the units of its headings and all that stands below them in the imperial system."""
    units = [heading_unit(heading) for heading in lines[0]]
    headings = [
        heading.replace(f"[{unit}]", f"[{IMPERIAL[unit]}]") if unit in IMPERIAL else heading
        for heading, unit in zip(lines[0], units, strict=True)
    ]
    # of edges, parts are given relative to their lengths
    metric = [u in IMPERIAL and not heading.startswith(_RELATIVE) for heading, u in zip(lines[0], units, strict=True)]
    rows = (zip(row, units, metric, strict=True) for row in lines[1:])
    return [headings, *([to_imperial(value, unit) if has else value for value, unit, has in row] for row in rows)]


def _fill(sheet: Any, lines: list[list[Any]]) -> None:
    """Write lines into a sheet; texts are never formulas."""
    from openpyxl.cell.cell import ILLEGAL_CHARACTERS_RE

    for number, line in enumerate(lines, start=1):
        for column, value in enumerate(line, start=1):
            if value is None:
                continue
            cell = sheet.cell(number, column)
            cell.value = ILLEGAL_CHARACTERS_RE.sub(" ", value) if isinstance(value, str) else value
            if isinstance(value, str):
                cell.data_type = "s"
