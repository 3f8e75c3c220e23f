"""Forces in columns and walls where they stand on the slab, by load case, from the results in a file."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Mapping
from itertools import pairwise

from groundslab.case.saf.reading.context import ReadContext, RowFault, text, texts, word
from groundslab.case.saf.reading.geometry import CLOSE, Edge
from groundslab.case.saf.reading.loads.forces import Loads, add_at_point
from groundslab.case.saf.reading.slab import Slab
from groundslab.case.saf.reading.workbook import Row
from groundslab.geometry.plan import make_segments
from groundslab.model.loads.lines import LineLoad
from groundslab.model.structure.lines import part_of_line

#: An axis within this of a direction is along it.
ALONG = 1e-6

COLUMNS, WALLS = "ResultInternalForce1D", "ResultInternalForce2DEdge"


def read_forces(context: ReadContext, slab: Slab, cases: set[str], found: Loads) -> None:
    """Add the normal forces at the feet of columns and walls as loads of their cases."""
    _read_columns(context, slab, cases, found)
    _read_walls(context, slab, cases, found)
    standing = len(slab.columns) + len(slab.walls)
    if standing and not context.rows(COLUMNS) and not context.rows(WALLS):
        why = f"not in the file: loads are those of the slab itself, without what its {standing} columns and walls bear"
        context.note(None, why, COLUMNS)


def _of_cases(
    context: ReadContext, sheet: str, key: str, names: Mapping[str, object], cases: set[str]
) -> dict[tuple[str, str], list[Row]]:
    """Return the rows of results of load cases by member and case; those of others are counted."""
    rows: dict[tuple[str, str], list[Row]] = defaultdict(list)
    left = Counter[str]()
    for row in context.rows(sheet):
        member, case = text(row, key), text(row, "loadcase")
        if member not in names:
            left["of members that do not stand on the slab"] += 1
        elif word(row, "resultfor", default="load case") != "load case":
            left["of combinations"] += 1
        elif case not in cases:
            left["of load cases that are not in the file"] += 1
        else:
            rows[member, case].append(row)
    for why, count in left.items():
        context.note(None, f"{count:,} rows {why}, not read", sheet)
    return rows


def _read_columns(context: ReadContext, slab: Slab, cases: set[str], found: Loads) -> None:
    """Add the normal force at the foot of each column, compression negative in the file."""
    members = {row.name: row for row in context.rows("StructuralCurveMember") if row.name in slab.columns}
    for (member, case), rows in _of_cases(context, COLUMNS, "member", members, cases).items():
        with context.reading(rows[0]):
            nodes = [context.node(name) for name in texts(members[member], "nodes")]
            upwards = abs(nodes[0][2] - slab.height) <= CLOSE
            at = [
                (context.number(row, "sectionat", "length"), context.number(row, "index", "number", 0.0), row)
                for row in rows
            ]
            length = abs(nodes[1][2] - nodes[0][2])
            section, _, foot = (min if upwards else max)(at, key=lambda each: each[:2])
            if abs(section - (0.0 if upwards else length)) > CLOSE:
                context.note(None, f"{member} in {case}: no section at its foot, not read", COLUMNS)
                continue
            N = context.number(foot, "n", "force")
            others = [context.number(foot, key, "moment", 0.0) for key in ("my", "mz")]
            shear = [context.number(foot, key, "force", 0.0) for key in ("vy", "vz")]
            add_at_point(found, case, slab.columns[member], f"{member}, N", [member], P=-N + 0.0)
            left = ", without its moments and shear forces, of which the format does not state the signs"
            why = f"{member} in {case}: N = {N / 1e3:.6g} kN as a load{left if any(others) or any(shear) else ''}"
            context.note(None, why, COLUMNS)


def _read_walls(context: ReadContext, slab: Slab, cases: set[str], found: Loads) -> None:
    """Add the normal force per length across the lower edge of each wall, compression negative in the file."""
    members = {row.name: row for row in context.rows("StructuralSurfaceMember") if row.name in slab.walls}
    for (member, case), rows in _of_cases(context, WALLS, "2dmember", members, cases).items():
        with context.reading(rows[0]):
            number, edge = slab.walls[member]
            along = [row for row in rows if text(row, "edge") == str(number)]
            n = f"n{_upright_axis(context, members[member], edge)}"
            values = sorted(
                (context.number(row, "sectionat", "length"), context.number(row, "index", "number", 0.0),
                 -context.number(row, n, "line force", 0.0) + 0.0) for row in along
            )  # fmt: skip
            line = make_segments(edge.points, edge.bulges)
            count = 0
            for (start, _, q), (end, _, q_end) in pairwise(values):
                if end - start > CLOSE and (q or q_end):
                    points, bulges = part_of_line(line, start, end)
                    name = f"{member}, n"
                    varies = {"q_end": q_end} if q_end != q else {}
                    found.loads.append(LineLoad(name=name, case=case, q=q, **varies, points=points, bulges=bulges))
                    count += 1
            context.note(None, f"{member} in {case}: n across its lower edge as {count} line loads", WALLS)


def _upright_axis(context: ReadContext, row: Row, edge: Edge) -> str:
    """Return which local axis of a plane wall goes up or down, "x" or "y"; raises RowFault where neither does."""
    kind = word(row, "lcstype", ("x by vector", "y by vector"))
    if any(edge.bulges):
        raise RowFault("edges", "forces of a curved wall", "a plane wall")
    bare = Row(row.sheet, row.number, row.cells, {})
    given = (context.number(bare, f"coordinate{axis}", "number", 0.0) for axis in "xyz")
    x, y, up = context.turned(tuple(given))  # type: ignore[arg-type]
    quarters = context.number(row, "lcsrotation", "angle", 0.0) / (math.pi / 2)
    level, upright = abs(up) <= ALONG * math.hypot(x, y), math.hypot(x, y) <= ALONG * abs(up)
    if level == upright or abs(quarters - round(quarters)) > ALONG:
        raise RowFault("lcstype", "local axes that are inclined", "local axes along the wall and up")
    turns = int(upright) + round(quarters) + (kind[0] == "y")
    return "x" if turns % 2 else "y"
