"""Forces in columns and walls where they stand on the slab, by load case, from the results in a file."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Mapping
from itertools import pairwise

from groundslab.errors import Issue
from groundslab.exchange.saf.reading.context import ReadContext, RowFault, Vector, text, texts, word
from groundslab.exchange.saf.reading.geometry import CLOSE, Edge
from groundslab.exchange.saf.reading.loads.forces import Loads, add_at_point
from groundslab.exchange.saf.reading.slab import Slab
from groundslab.exchange.saf.reading.structure import member_axes
from groundslab.exchange.saf.reading.workbook import Row, difference
from groundslab.geometry.plan import make_segments
from groundslab.model.loads.lines import LineLoad
from groundslab.model.loads.load_cases import Kind
from groundslab.model.structure.lines import part_of_line

#: An axis within this of a direction is along it.
ALONG = 1e-6

COLUMNS, WALLS = "ResultInternalForce1D", "ResultInternalForce2DEdge"


def read_forces(context: ReadContext, slab: Slab, cases: Mapping[str, Kind], loads: Loads) -> None:
    """Add the forces at the feet of columns, and normal forces at those of walls, as loads of their cases.

    ``cases`` are the kinds of load cases by their names.
    """
    _read_columns(context, slab, cases, loads)
    _read_walls(context, slab, cases, loads)
    standing = len(slab.columns) + len(slab.walls)
    if standing and not context.rows(COLUMNS) and not context.rows(WALLS):
        why = f"not in the file: loads are those of the slab itself, without what its {standing} columns and walls bear"
        context.note(None, why, COLUMNS)


def _of_cases(
    context: ReadContext, sheet: str, key: str, names: Mapping[str, object], cases: Mapping[str, Kind]
) -> dict[tuple[str, str], list[Row]]:
    """Return the rows of results of load cases by member and case; those of others are counted."""
    rows: dict[tuple[str, str], list[Row]] = defaultdict(list)
    left = Counter[str]()
    places: dict[tuple[str, ...], Row] = {}
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
            place = (member, case, *(text(row, column) for column in ("edge", "sectionat", "index")))
            if (other := places.setdefault(place, row)).cells != row.cells:
                repetition = f"{member} in {case} again, as in row {other.number}, {difference(other, row)}"
                context.add(Issue(context.where(row), repetition, "each section once"))
    for why, count in left.items():
        context.note(None, f"{count:,} rows {why}, not read", sheet)
    return rows


def _read_columns(context: ReadContext, slab: Slab, cases: Mapping[str, Kind], loads: Loads) -> None:
    """Add forces and moments at the foot of each column, compression negative in the file."""
    members = {row.name: row for row in context.rows("StructuralCurveMember") if row.name in slab.columns}
    values: dict[str, list[float]] = {}
    for (member, case), rows in _of_cases(context, COLUMNS, "member", members, cases).items():
        with context.reading(rows[0]):
            nodes = [context.node(name) for name in texts(members[member], "nodes")]
            upwards = abs(nodes[0][2] - slab.height) <= CLOSE
            at = [
                (context.number(row, "sectionat", "length"), context.number(row, "index", "number", 0.0), row)
                for row in rows
            ]
            length = abs(nodes[1][2] - nodes[0][2])
            section, _, foot = (min if upwards else max)(at, key=lambda entry: entry[:2])
            if abs(section - (0.0 if upwards else length)) > CLOSE:
                context.note(None, f"{member} in {case}: no section at its foot, not read", COLUMNS)
                continue
            N = context.number(foot, "n", "force")
            values.setdefault(case, []).append(N)
            axes = member_axes(context, members[member], (nodes[0], nodes[1]))
            moments, shear, left = _bent(context, foot, axes, upwards)
            add_at_point(loads, case, slab.columns[member], f"{member}, N", [member], P=-N + 0.0, **moments)
            loads.push(case, *shear)
            taken = " with its moments and shear forces" if any(moments.values()) or any(shear) else ""
            why = f"{member} in {case}: N = {N / 1e3:.6g} kN as a load{taken}{left}"
            context.note(None, why, COLUMNS)
    for case, forces in values.items():
        if cases[case] == "seismic" and min(forces) >= 0 < max(forces):
            why = "presses no column: forces of a response spectrum have no signs and are no load"
            context.note(None, f"{case} is seismic and {why}", COLUMNS)


def _bent(
    context: ReadContext, foot: Row, axes: tuple[Vector, Vector, Vector], upwards: bool
) -> tuple[dict[str, float], tuple[float, float], str]:
    """Return the moments [N m] and the horizontal force [N] on the slab of a section at a foot, and what is left out.

    The documentation of SAF 2.1.0 shows a beam with its local axes, loads and results (page ResultInternalForce1D): by
    these M_y = -int z sigma dA and M_z = -int y sigma dA, and V_y, V_z are along y and z what acts on the face to which
    x is inward. The slab is pressed by -sigma: its moments do not depend on which end of the member is the foot.
    """
    _, z, y = axes
    M_y, M_z = (context.number(foot, key, "moment", 0.0) for key in ("my", "mz"))
    V_y, V_z = (context.number(foot, key, "force", 0.0) for key in ("vy", "vz"))
    left = ", without its torsional moment" if context.number(foot, "mx", "moment", 0.0) else ""
    on = -1.0 if upwards else 1.0
    moments = {"M_x": M_y * z[0] + M_z * y[0] + 0.0, "M_y": M_y * z[1] + M_z * y[1] + 0.0}
    return moments, (on * (V_y * y[0] + V_z * z[0]), on * (V_y * y[1] + V_z * z[1])), left


def _read_walls(context: ReadContext, slab: Slab, cases: Mapping[str, Kind], loads: Loads) -> None:
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
                    loads.loads.append(LineLoad(name=name, case=case, q=q, **varies, points=points, bulges=bulges))
                    count += 1
            context.note(None, f"{member} in {case}: n across its lower edge as {count} line loads", WALLS)


def _upright_axis(context: ReadContext, row: Row, edge: Edge) -> str:
    """Return which local axis of a plane wall goes up or down, "x" or "y"; raises RowFault where neither does."""
    kind = word(row, "lcstype", ("x by vector", "y by vector"))
    if any(edge.bulges):
        raise RowFault("edges", "forces of a curved wall", "a plane wall")
    bare = Row(row.sheet, row.number, row.cells, {})
    vector = (context.number(bare, f"coordinate{axis}", "number", 0.0) for axis in "xyz")
    x, y, up = context.turned(tuple(vector))  # type: ignore[arg-type]
    quarters = context.number(row, "lcsrotation", "angle", 0.0) / (math.pi / 2)
    level, upright = abs(up) <= ALONG * math.hypot(x, y), math.hypot(x, y) <= ALONG * abs(up)
    if level == upright or abs(quarters - round(quarters)) > ALONG:
        raise RowFault("lcstype", "local axes that are inclined", "local axes along the wall and up")
    turns = int(upright) + round(quarters) + (kind[0] == "y")
    return "x" if turns % 2 else "y"
