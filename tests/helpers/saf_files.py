"""Files in the Structural Analysis Format, made by hand with openpyxl: a building with columns and walls on a slab."""

from __future__ import annotations

from pathlib import Path
from typing import Any

Sheets = dict[str, list[list[Any]]]

_STIFF = ["Stiffness X [MN/m2]", "Stiffness Y [MN/m2]", "Stiffness Z [MN/m2]"]
_ON = ["Coordinate definition", "Origin", "Start point [m]", "End point [m]"]
_WHOLE = ["Relative", "From start", 0, 1]


def write(path: Path, sheets: Sheets) -> Path:
    """Write sheets to a file and return its path."""
    import openpyxl

    book = openpyxl.Workbook()
    book.remove(book.active)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        for row in rows:
            sheet.append(row)
    book.save(path)
    return path


def model_sheet(units: str = "Metric", vertical: str = "Z vertical") -> list[list[Any]]:
    """Return the sheet Model."""
    return [
        ["Name", "House"],
        ["SAF Version", "2.2.0"],
        ["Global coordinate system", vertical],
        ["LCS of cross-section", "ZYX"],
        ["System of units", units],
        ["National code", "EC-Standard-EN"],
    ]


def _plates(rows: list[tuple[str, str, float, str, str]]) -> list[list[Any]]:
    """Return surface members by name, material, thickness [mm], nodes and edges."""
    head = [
        "Name",
        "Material",
        "Type",
        "Thickness type",
        "Thickness [mm]",
        "System plane at",
        "Nodes",
        "Edges",
        "LCS Type",
        "Coordinate X [m]",
        "Coordinate Y [m]",
        "Coordinate Z [m]",
        "LCS Rotation [deg]",
    ]
    return [
        head,
        *(
            [name, material, "Plate", "Constant", str(thickness), "Centre", nodes, edges, "x by vector", 1, 0, 0, 0]
            for name, material, thickness, nodes, edges in rows
        ),
    ]


def house() -> Sheets:
    """Return a house: eleven surface members, of which S6 is the slab on ground, and one of everything that is read."""
    square = "Line; Line; Line; Line"
    nodes = {
        # corners of the slab, of the floor above, of the roof
        "N1": (0, 0, 0),
        "N2": (5, 0, 0),
        "N3": (5, 12, 0),
        "N4": (0, 12, 0),
        "N5": (0, 0, 3.6),
        "N6": (5, 0, 3.6),
        "N7": (5, 12, 3.6),
        "N8": (0, 12, 3.6),
        "N9": (0, 0, 7.2),
        "N10": (5, 0, 7.2),
        "N11": (5, 12, 7.2),
        "N12": (0, 12, 7.2),
        # openings of the slab, and of others
        "O1": (1, 1, 0),
        "O2": (2, 1, 0),
        "O3": (2, 2, 0),
        "O4": (1, 2, 0),
        "O5": (3.5, 3, 0),
        "O6": (4, 3, 0),
        "P1": (1, 1, 3.6),
        "P2": (2, 1, 3.6),
        "P3": (2, 2, 3.6),
        "P4": (1, 2, 3.6),
        # regions
        "R1": (0, 11, 0),
        "R2": (5, 11, 0),
        "R3": (1, 5, 0),
        "R4": (2, 5, 0),
        "R5": (2, 6, 0),
        "R6": (1, 6, 0),
        "R7": (3, 5, 0),
        "R8": (4, 5, 0),
        "R9": (4, 6, 0),
        "R10": (3, 6, 0),
        "R11": (0, 9, 0),
        "R12": (5, 9, 0),
        # rib, internal edge, columns
        "B1": (2.5, 7, 0),
        "B2": (2.5, 10, 0),
        "E1": (0.5, 8, 0),
        "E2": (4.5, 8, 0),
        "C1": (1, 4, 0),
        "C2": (1, 4, 3.6),
        "C3": (4, 4, 0),
        "C4": (4, 4, 3.6),
        "C5": (4, 10.5, 0),
        "C6": (4, 10.5, 3.6),
    }
    part = [
        "Name",
        "Material",
        "Thickness [mm]",
        "System plane at",
        "2D Member",
        "Nodes",
        "Edges",
        "Eccentricity ez [mm]",
    ]
    opening = ["Name", "2D Member", "Nodes", "Edges"]
    member = [
        "Name",
        "Type",
        "Cross section",
        "Nodes",
        "Segments",
        "LCS",
        "LCS Rotation [deg]",
        "Coordinate X [m]",
        "Coordinate Y [m]",
        "Coordinate Z [m]",
        "System line",
    ]
    by_y = ["y by vector", 0, 0, 1, 0, "Centre"]
    return {
        "Project": [["Name", "Houses"], ["Project nr", "12-3"]],
        "Model": model_sheet(),
        "StructuralMaterial": [
            [
                "Name",
                "Type",
                "Quality",
                "Unit mass [kg/m3]",
                "E modulus [MPa]",
                "G modulus [MPa]",
                "Poisson Coefficient",
            ],
            ["MAT1", "Concrete", "C20/25", 2500, 30000, 12500, 0.2],
            ["MAT2", "Concrete", "C30/37", None, None, None, None],
        ],
        "StructuralCrossSection": [
            ["Name", "Material", "Cross-section type", "Shape", "Parameters [mm]", "Profile"],
            ["CS1", "MAT1", "Parametric", "Rectangle", "400; 250", None],
            ["CS2", "MAT1", "Parametric", "Circle", "350", None],
            ["CS3", "MAT1", "Manufactured", None, None, "HEB180"],
        ],
        "StructuralPointConnection": [
            ["Name", "Coordinate X [m]", "Coordinate Y [m]", "Coordinate Z [m]"],
            *([name, *place] for name, place in nodes.items()),
        ],
        "StructuralSurfaceMember": _plates(
            [
                ("S1", "MAT1", 200, "N1; N2; N6; N5", square),
                ("S2", "MAT1", 240, "N4; N3; N7; N8", square),
                ("S3", "MAT1", 200, "N1; N4; N8; N5", square),
                ("S4", "MAT1", 200, "N2; N3; N7; N6", square),
                ("S5", "MAT1", 200, "N5; N6; N7; N8", square),
                ("S6", "MAT1", 250, "N1; N2; N3; N4", square),
                ("S7", "MAT1", 200, "N9; N10; N11; N12", square),
                ("S8", "MAT1", 200, "N5; N6; N10; N9", square),
                ("S9", "MAT1", 200, "N8; N7; N11; N12", square),
                ("S10", "MAT1", 200, "N5; N8; N12; N9", square),
                ("S11", "MAT1", 200, "N6; N7; N11; N10", square),
            ]
        ),
        "StructuralSurfaceMemberOpening": [
            opening,
            ["O1", "S6", "O1; O2; O3; O4", square],
            ["O2", "S6", "O5; O6", "Circle and Point"],
            *([f"O{n}", f"S{n}", "P1; P2; P3; P4", square] for n in (3, 4, 5, 7, 8)),
        ],
        "StructuralSurfaceMemberRegion": [
            part,
            ["R1", "MAT1", 400, "Centre", "S6", "R3; R4; R5; R6", square, 0],
            ["R2", "MAT1", 400, "Centre", "S6", "R7; R8; R9; R10", square, 0],
            ["R3", "MAT1", 250, "Centre", "S6", "R1; R2; N3; N4", square, 0],
            ["R4", "MAT2", 250, "Centre", "S6", "R11; R12; R2; R1", square, 0],
        ],
        "StructuralCurveMember": [
            member,
            ["B1", "Column", "CS1", "C1; C2", "Line", *by_y],
            ["B2", "Column", "CS2", "C4; C3", "Line", *by_y],
            ["B3", "Column", "CS3", "C5; C6", "Line", *by_y],
            ["B4", "Beam", "CS1", "N5; N6", "Line", *by_y],
        ],
        "StructuralCurveMemberRib": [
            [
                "Name",
                "2D member",
                "Cross section",
                "Nodes",
                "Segments",
                "Alignment",
                "Eccentricity ez [mm]",
                "Type of connection",
                "Effective width",
                "Width left for internal forces [mm]",
                "Width right for internal forces [mm]",
            ],
            ["B37", "S6", "CS1", "B1; B2", "Line", "Bottom", 0, "Partial shear connection", "Width", 500, 400],
        ],
        "StructuralCurveEdge": [["Name", "2D member", "Nodes", "Segments"], ["ES1", "S6", "E1; E2", "Line"]],
        "StructuralPointSupport": [
            ["Name", "Type", "Boundary condition", "Node", "ux", "uy", "uz", "fix", "fiy", "fiz", "Stiffness Z [MN/m]"],
            [
                "Sn1",
                "Custom",
                "In node",
                "C1",
                "Free",
                "Free",
                "Flexible compression only",
                "Free",
                "Free",
                "Free",
                100,
            ],
            ["Sn2", "Fixed", "In node", "N9", "Rigid", "Rigid", "Rigid", "Rigid", "Rigid", "Rigid", None],
        ],
        "StructuralEdgeConnection": [
            [
                "Name",
                "Boundary condition",
                "2D Member",
                "Edge",
                "Internal edge",
                "ux",
                "uy",
                "uz",
                "fix",
                "fiy",
                "fiz",
                *_STIFF,
                "Coordinate system",
                *_ON,
            ],
            [
                "Sle1",
                "On edge",
                "S6",
                2,
                None,
                "Free",
                "Free",
                "Rigid",
                "Rigid",
                "Free",
                "Free",
                *[None] * 3,
                "Local",
                "Absolute",
                "From end",
                1,
                4,
            ],
        ],
        "StructuralSurfaceConnection": [
            [
                "Name",
                "2D Member",
                "2D Member Region",
                "Subsoil",
                "C1x [MN/m3]",
                "C1y [MN/m3]",
                "C1z Spring",
                "C1z [MN/m3]",
                "C2x [MN/m]",
                "C2y [MN/m]",
            ],
            ["SS1", "S6", None, "Gravel", 120, 100, "Flexible", 160, 120, 125],
            ["SS2", "S6", "R3", "Sand", 100, 90, "Linear", 80, 70, 60],
        ],
        **_loads(),
    }


def _loads() -> Sheets:
    """Return three load cases, two combinations, and loads of all kinds."""
    along = ["Load case", "Coordinate system", "Location", *_ON]
    return {
        "StructuralLoadGroup": [
            ["Name", "Load group type", "Relation", "Load type"],
            ["LG1", "Permanent", "Standard", None],
            ["LG2", "Variable", "Exclusive", "Offices"],
        ],
        "StructuralLoadCase": [
            ["Name", "Description", "Action type", "Load group", "Load type", "Duration"],
            ["LC1", None, "Permanent", "LG1", "Self weight", None],
            ["LC2", None, "Permanent", "LG1", "Others", None],
            ["LC3", None, "Variable", "LG2", "Static", "Short"],
        ],
        "StructuralLoadCombination": [
            [
                "Name",
                "Description",
                "Category",
                "National standard",
                "Load Factor 1",
                "Multiplier 1",
                "Load Case name 1",
                "Load Factor 2",
                "Load Multiplier 2",
                "Load Case name 2",
            ],
            ["CO1", "words", "ULS (Ultimate Limit State)", None, 1.35, 1, "LC1", 1.5, 0.7, "LC3"],
            ["CO2", None, "According national standard", "EN-SLS Quasi-permanent", None, 1, "LC1", None, 1, "LC3"],
        ],
        "StructuralPointAction": [
            [
                "Name",
                "Type",
                "Direction",
                "Force action",
                "Reference node",
                "Reference member",
                "Value [kN]",
                "Vector (X;Y;Z) [kN]",
                "Load case",
                "Coordinate system",
            ],
            ["F1", "Standard", "Z", "In node", "C1", None, -100, None, "LC2", "Global"],
            ["F2", "Standard", "Vector", "In node", "C3", None, None, "(10; -20; -50)", "LC3", "Global"],
            ["F3", "Standard", "Z", "In node", "N9", None, -3, None, "LC2", "Global"],
            ["F4", "Standard", "Z", "On beam", None, "B1", -3, None, "LC2", "Global"],
        ],
        "StructuralPointActionFree": [
            [
                "Name",
                "Direction",
                "Value [kN]",
                "Load case",
                "Coordinate X [m]",
                "Coordinate Y [m]",
                "Coordinate Z [m]",
                "Coordinate system",
            ],
            ["FF1", "Z", -8, "LC2", 4.5, 11.5, 0, "Global"],
            ["FF2", "Z", -8, "LC2", 4.5, 17, 0, "Global"],
        ],
        "StructuralPointMoment": [
            ["Name", "Direction", "Force action", "Reference node", "Value [kNm]", "Load case", "Coordinate system"],
            ["M1", "Mx", "In node", "C1", 5, "LC2", "Global"],
            ["M2", "My", "In node", "C1", 7, "LC2", "Global"],
        ],
        "StructuralCurveAction": [
            [
                "Name",
                "Force action",
                "Distribution",
                "Direction",
                "Value 1 [kN/m]",
                "Value 2 [kN/m]",
                "Member Rib",
                "2D Member",
                "2D Member Region",
                "2D Member Opening",
                "Edge",
                "Internal edge",
                *along,
            ],
            [
                "LF1",
                "On internal edge",
                "Trapez",
                "Z",
                -10,
                -20,
                None,
                "S6",
                None,
                None,
                None,
                "ES1",
                "LC2",
                "Global",
                "Length",
                "Absolute",
                "From end",
                1,
                3,
            ],
            [
                "LF2",
                "On edge",
                "Uniform",
                "Z",
                -15,
                None,
                None,
                "S1",
                None,
                None,
                1,
                None,
                "LC2",
                "Global",
                "Length",
                *_WHOLE,
            ],
            [
                "LF3",
                "On opening edge",
                "Uniform",
                "Z",
                -1,
                None,
                None,
                None,
                None,
                "O1",
                3,
                None,
                "LC2",
                "Local",
                "Length",
                *_WHOLE,
            ],
            [
                "LF4",
                "On rib",
                "Uniform",
                "Z",
                -2,
                None,
                "B37",
                None,
                None,
                None,
                None,
                None,
                "LC3",
                "Global",
                "Length",
                *_WHOLE,
            ],
            [
                "LF5",
                "On edge",
                "Uniform",
                "Z",
                -9,
                None,
                None,
                "S5",
                None,
                None,
                1,
                None,
                "LC2",
                "Global",
                "Length",
                *_WHOLE,
            ],
        ],
        "StructuralCurveActionFree": [
            [
                "Name",
                "Distribution",
                "Direction",
                "Value 1 [kN/m]",
                "Load case",
                "Coordinate X [m]",
                "Coordinate Y [m]",
                "Coordinate Z [m]",
                "Segments",
                "Coordinate system",
                "Location",
            ],
            ["LFF1", "Uniform", "Z", -2, "LC2", "2; 3; 2", "3; 4; 5", "0; 0; 0", "Circular Arc", "Global", "Length"],
        ],
        "StructuralCurveMoment": [
            [
                "Name",
                "Force action",
                "Distribution",
                "Direction",
                "Value 1 [kNm/m]",
                "2D Member",
                "Edge",
                "Internal edge",
                *along,
            ],
            ["LM1", "On internal edge", "Uniform", "Mx", 3, "S6", None, "ES1", "LC2", "Local", "Length", *_WHOLE],
        ],
        "StructuralSurfaceAction": [
            [
                "Name",
                "Direction",
                "Force action",
                "Value [kN/m2]",
                "2D Member",
                "2D Member Region",
                "Load case",
                "Coordinate system",
                "Location",
            ],
            ["SF1", "Z", "On 2D member", -2.5, "S6", None, "LC2", "Local", "Length"],
            ["SF2", "Z", "On 2D member region", -3, "S6", "R4", "LC3", "Global", "Length"],
            ["SF3", "Z", "On 2D member", -4, "S5", None, "LC3", "Global", "Length"],
        ],
        "StructuralSurfaceActionFree": [
            [
                "Name",
                "Direction",
                "Distribution",
                "q [kN/m2]",
                "Load case",
                "Coordinate X [m]",
                "Coordinate Y [m]",
                "Coordinate Z [m]",
                "Edges",
                "Coordinate system",
                "Location",
            ],
            [
                "SFF1",
                "Z",
                "DirectionXY",
                "C1:-3; C2:-5; C4:-3",
                "LC3",
                "0; 2; 2; 0; 0",
                "9; 9; 10; 10; 9",
                "0; 0; 0; 0; 0",
                "Line; Line; Line; Line",
                "Global",
                "Length",
            ],
        ],
        "StructuralSurfaceActionThermal": [
            ["Name", "Variation", "TempT [°C]", "TempB [°C]", "2D Member", "2D Member Region", "Load case"],
            ["LT1", "Linear", 30, 10, "S6", None, "LC3"],
        ],
        "StructuralStorey": [["Name", "Height level [m]"], ["Ground floor", 0]],
    }
