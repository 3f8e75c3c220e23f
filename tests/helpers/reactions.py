"""A slab and tables of reactions as programs write them, for tests of their import."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

#: A slab under columns A and B and a wall W of 2 m; the comments are to stay where they are.
CASE = """\
# The raft of house 7
title = "Raft"

[plate]
length_x = "8 m"  # from wall to wall
length_y = "5 m"
thickness = "0.5 m"
E = "33 GPa"
nu = 0.2

[ground]
kind = "winkler"
k = "20 MPa/m"

# from the drawing
[[columns]]
name = "A"
x = "-2 m"
y = "0 m"
width_x = "0.4 m"
width_y = "0.4 m"

[[columns]]
name = "B"
x = "2 m"
y = "0 m"
width_x = "0.4 m"
width_y = "0.4 m"

[[walls]]
name = "W"
thickness = "0.3 m"
points = [["-1 m", "2 m"], ["1 m", "2 m"]]

[[cases]]
name = "G"

[[cases]]
name = "Q"
action = "variable"
category = "B"

# concrete
[[loads]]
kind = "self weight"
unit_weight = "25 kN/m^3"  # with bars
case = "G"

[mesh]
size = "0.5 m"  # enough
"""

ETABS = """\
TABLE:  Joint Reactions
Story,Label,Unique Name,Output Case,Case Type,Step Type,Step Number,FX,FY,FZ,MX,MY,MZ
,,,,,,,kN,kN,kN,kN-m,kN-m,kN-m
Base,A,101,G,LinStatic,,,0,0,"1,812.4",10,-20,0
Base,A,101,Q,LinStatic,,,0,0,300,1,2,0
Base,A,101,ULS1,Combination,,,0,0,2896.7,15,-24,0
Base,B,102,G,LinStatic,,,0,0,500,0,0,0
Base,B,102,Q,LinStatic,,,0,0,-50,0,0,0
Base,B,102,ULS1,Combination,,,0,0,600,0,0,0
"""

RFEM = """\
Node;;Support Forces [kN];;;Support Moments [kNm];;;
No.;LC;PX;PY;PZ;MX;MY;MZ;Comment
A;G;0,000;0,000;1.812,400;10,000;-20,000;0,000;
;Q;0,000;0,000;300,000;1,000;2,000;0,000;
B;G;0,000;0,000;500,000;0,000;0,000;0,000;
;Q;0,000;0,000;-50,000;0,000;0,000;0,000;
Sum;G;;;2.312,400;;;;
"""

BY_HAND = """\
Column\tG\t\t\tQ\t\t
\tFz\tMx\tMy\tFz\tMx\tMy
\tkN\tkNm\tkNm\tkN\tkNm\tkNm
A\t1812,4\t10\t-20\t300\t1\t2
B\t500\t\t\t-50\t\t
"""


def write_case(folder: Path, text: str = CASE) -> Path:
    """Write the slab into a folder."""
    path = folder / "raft.toml"
    path.write_text(text, encoding="utf-8")
    return path


def write_table(folder: Path, text: str, name: str = "reactions.csv") -> Path:
    """Write a table into a folder."""
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def write_workbook(path: Path, sheets: dict[str, Sequence[Sequence[Any]]]) -> Path:
    """Write sheets of rows into a workbook, formulas without values."""
    import openpyxl

    book = openpyxl.Workbook()
    book.remove(book.active)
    for title, rows in sheets.items():
        sheet = book.create_sheet(title)
        for row in rows:
            sheet.append(list(row))
    book.save(path)
    return path
