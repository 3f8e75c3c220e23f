"""Forces of loads: by their directions or as vectors, collected by case and place."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from groundslab.exchange.saf.reading.context import ReadContext, RowFault, Vector, text, word
from groundslab.exchange.saf.reading.geometry import CLOSE, to_circle
from groundslab.exchange.saf.reading.ground import Path
from groundslab.exchange.saf.reading.slab import Slab
from groundslab.exchange.saf.reading.workbook import Row
from groundslab.geometry.plan import Place, make_segments
from groundslab.model.loads.lines import LineLoad
from groundslab.model.loads.load_types import AnyLoad, PointLoad
from groundslab.model.structure.columns import Column
from groundslab.model.structure.lines import flat_line
from groundslab.schema.wording import describe

#: Components below this share of a vector are nothing but rounding.
ROUNDING = 1e-9
#: Arcs of lines as chords so far off [m], to find what of them lies on the slab; so far beside it they still do.
CHORD = 1e-6
#: Local axes of a load in plan x, plan y and up.
Axes = tuple[Vector, Vector, Vector]


@dataclass(slots=True)
class Loads:
    """Loads as they are read, the forces and moments at a place by case and place, horizontal forces by case [N]."""

    loads: list[AnyLoad] = field(default_factory=list)
    points: dict[tuple[str, Place], dict[str, Any]] = field(default_factory=dict)
    horizontal: dict[str, list[float]] = field(default_factory=lambda: defaultdict(lambda: [0.0, 0.0]))

    def push(self, case: str, x: float, y: float) -> None:
        """Add a horizontal force to a case [N]."""
        self.horizontal[case][0] += x
        self.horizontal[case][1] += y

    def finish(self, columns: Sequence[Column]) -> list[AnyLoad]:
        """Return all loads, those at points last, on the columns that stand there."""
        names = {(column.x, column.y): column.name for column in columns}
        return [*self.loads, *(_make_point_load(*key, values, names) for key, values in self.points.items())]


def _make_point_load(case: str, place: Place, values: dict[str, Any], columns: dict[Place, str]) -> PointLoad:
    """Return the load at a place, on the column that stands there if one does."""
    column = columns.get(place)
    where = {"column": column} if column in values["columns"] else {"x": place[0], "y": place[1]}
    moments = {name: values[name] for name in ("M_x", "M_y")}
    return PointLoad(name=values["name"], case=case, P=values["P"], **moments, **where)


def add_at_point(
    loads: Loads, case: str, place: Place, name: str, columns: Sequence[str] = (), **values: float
) -> None:
    """Add force or moments at a place to those of the same case there, which keep the name of the first."""
    nothing = {"P": 0.0, "M_x": 0.0, "M_y": 0.0, "name": name, "columns": set()}
    at_place = loads.points.setdefault((case, place), nothing)
    at_place["columns"] |= set(columns)
    for key, value in values.items():
        at_place[key] += value


def read_vector(
    context: ReadContext, row: Row, quantity: str, local: Axes, number: str = "", value: str = "value"
) -> Vector:
    """Return the force of a row in plan x, plan y and up, by its direction or as a vector.

    ``local`` are the axes that count if the row says that its own are meant.
    """
    direction = word(row, "direction", ("x", "y", "z", "vector"))
    if direction == "vector":
        key = f"vector{number}xyz"
        parts = text(row, key).strip("()[] ").split(";")
        bare = [Row(row.sheet, row.number, {key: part}, row.units) for part in parts]
        if len(parts) != 3:
            raise RowFault(key, describe(text(row, key)), "three numbers such as (10;10;0)")
        x, y, z = (context.number(component, key, quantity) for component in bare)
    else:
        size = context.number(row, f"{value}{number}", quantity)
        x, y, z = (size if direction == axis else 0.0 for axis in "xyz")
    if word(row, "coordinatesystem", default="global") in ("local", "member lcs"):
        parts_of = [x * local[0][i] + y * local[1][i] + z * local[2][i] + 0.0 for i in range(3)]
        return parts_of[0], parts_of[1], parts_of[2]
    return context.turned((x, y, z))


def words_of(what: str, x: float, y: float, up: float) -> str:
    """Return as what a load was taken: what acts, and horizontal forces of the case."""
    flat = math.hypot(x, y) > ROUNDING * abs(up)
    return " and ".join([what] * (up != 0) + ["horizontal forces of its case"] * flat) or "a load of 0"


def line_values(context: ReadContext, row: Row, local: Axes) -> tuple[Vector, Vector]:
    """Return the force per length at the start and at the end of a line load."""
    start = read_vector(context, row, "line force", local, "1")
    trapez = word(row, "distribution", default="uniform").startswith("trapez")
    return start, read_vector(context, row, "line force", local, "2") if trapez else start


def add_line(loads: Loads, row: Row, path: Path, start: Vector, end: Vector, slab: Slab, wall: str = "") -> None:
    """Add a line load, and its horizontal part on the slab to its case."""
    points, bulges = path
    case = text(row, "loadcase")
    length, way = _on_slab(slab, path)
    x, y = (length * (start[axis] + way * (end[axis] - start[axis])) for axis in (0, 1))
    loads.push(case, x, y)
    if not start[2] and not end[2]:
        return
    varies = {"q_end": -end[2]} if end[2] != start[2] else {}
    where: dict[str, Any] = {"wall": wall} if wall else {"points": points, "bulges": bulges}
    if not wall and not varies and (circle := to_circle(points, bulges)) is not None:
        where = {"shape": circle}
    loads.loads.append(LineLoad(name=row.name, case=case, q=-start[2], **varies, **where))


def _on_slab(slab: Slab, path: Path) -> tuple[float, float]:
    """Return how much of a line lies on the slab [m], and the middle of it on its way from start to end, 0 to 1."""
    points, bulges = path
    line = flat_line(make_segments(points, bulges), CHORD)
    part = line.intersection(slab.area.buffer(2 * CHORD))
    if part.is_empty:
        return 0.0, 0.0
    if part.length >= line.length - 4 * CHORD:
        return sum(edge.length for edge in make_segments(points, bulges)), 0.5
    return part.length, float(line.project(part.centroid, normalized=True))


def on_slab(slab: Slab, path: Path) -> bool:
    """Return whether any of a line lies on the slab."""
    return _on_slab(slab, path)[0] > CLOSE
