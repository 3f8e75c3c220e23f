"""docs/results.md is held to the tables: every column with its unit, no other."""

from __future__ import annotations

import ast
import re

import pytest

from groundslab.model.combinations import list_combinations
from groundslab.model.model import Model
from groundslab.results.fields import BAR_FIELDS, PLATE_FIELDS, POINT_FIELDS, RANGED_FIELDS
from groundslab.results.results import Results
from groundslab.study.definition.outputs import FIELDS as STUDIED
from groundslab.views.plots.request import QUANTITIES as DRAWN
from groundslab.views.tables.bending_schedule import bending_schedule
from groundslab.views.tables.result_tables import tables_of
from groundslab.views.tables.structure.cores import core_load_table, core_table
from groundslab.views.tables.structure.walls import wall_limit_table
from helpers.paths import DOCS, PACKAGE

PAGE = (DOCS / "results.md").read_text(encoding="utf-8")
ROW = re.compile(r"^\| ([^|]+?) \|(?: ([^|]*?) ?)?\| ", re.MULTILINE)
QUANTITIES = [about.head for about in POINT_FIELDS.values()]
#: The same with what has extremes only.
EXPLAINED = [about.head for about in (PLATE_FIELDS | POINT_FIELDS).values()]


SLAB = {
    "plate": {"length_x": 4, "length_y": 4, "thickness": 0.3, "E": 30e9, "nu": 0.2},
    "ground": {"kind": "winkler", "k": 20e6},
    "loads": [{"kind": "uniform", "q": 1e3}],
}


def explained(heading: str) -> list[tuple[str, str]]:
    """Return name and unit of each column that a section explains, in its order."""
    (section,) = re.findall(rf"^## {heading}\n(.*?)(?=^## |\Z)", PAGE, re.MULTILINE | re.DOTALL)
    rows = [(name, unit.strip()) for name, unit in ROW.findall(section)]
    return [row for row in rows if row != ("column", "unit") and set(row[0]) != {"-"}]


def test_every_column_is_explained() -> None:
    """Each table's section lists its columns in order with their units; quantities have a section of their own."""
    model = Model(
        plate={"length_x": 4, "length_y": 4, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        loads=[{"kind": "uniform", "q": 1e3, "case": "G"}],
        cases=[{"name": "G"}],
        combinations=[{"name": "ULS", "factors": {"G": 1.35}}],
        supports=[{"kind": "point", "x": 0, "y": 0}],
        columns=[{"name": "A", "x": 0, "y": 0, "diameter": 0.4}],
        beams=[
            {
                "name": "B",
                "points": [(-1, 1), (1, 1)],
                "section": {"kind": "rib", "width": 0.3, "height": 0.3, "eccentric": True},
            }
        ],
        output={
            "points": [{"name": "P", "x": 0, "y": 0}],
            "lines": [{"name": "L", "start": (0, 0), "end": (1, 0)}],
            "strips": [{"name": "S", "start": (0, 0), "end": (1, 0), "width": 1}],
        },
        reinforcement={
            "f_ck": 30e6,
            "f_yk": 500e6,
            "bottom": (0.04, 0.05),
            "top": (0.04, 0.05),
            "bottom_mesh": "Q335A",
            "top_mesh": "A393",
        },
    )
    tables = tables_of(Results(model, list_combinations(model), {}, {"ULS": Exception("not solved")}))
    assert len(tables) == 18
    assert explained("Quantities") == EXPLAINED
    for table in tables:
        columns = [(column.name, column.unit) for column in table.columns]
        if table.name in ("points", "lines"):
            assert columns[-len(QUANTITIES) :] == QUANTITIES
            columns = columns[: -len(QUANTITIES)]
        assert explained(table.name) == columns, table.name
    for code in ("ACI 318", "EN 1992-1-1:2023"):
        steel = model.reinforcement.replace(code=code)
        other = model.replace(reinforcement=steel)
        found = {
            each.name: each
            for each in tables_of(Results(other, list_combinations(other), {}, {"ULS": Exception("no")}))
        }
        own = explained(f"columns, by {code}")
        assert [(column.name, column.unit) for column in found["columns"].columns][-len(own) :] == own


def test_columns_of_the_bending_schedule_are_explained() -> None:
    """The table of bars that are not meshes."""
    columns = bending_schedule(Model(**SLAB)).columns
    assert explained("bending_schedule") == [(column.name, column.unit) for column in columns]


def test_columns_of_limits_of_walls_are_explained() -> None:
    """The table that a key asks for has a section, too."""
    columns = wall_limit_table(Results(Model(**SLAB), [], {}, {})).columns
    assert explained("wall_limits") == [(column.name, column.unit) for column in columns]


def test_columns_of_cores_are_explained() -> None:
    """Their section and what their walls bring."""
    wall = {"name": "W", "thickness": 0.3, "points": [(-1, 0), (1, 0), (1, 1)]}
    load = {"kind": "core", "core": "K", "P": 1e6}
    model = Model(**SLAB | {"walls": [wall], "cores": [{"name": "K", "walls": ["W"]}], "loads": [load]})
    for table in (core_table(Results(model, [], {}, {})), core_load_table(Results(model, [], {}, {}))):
        assert explained(table.name) == [(column.name, column.unit) for column in table.columns]


def test_columns_of_joints_are_explained() -> None:
    """The table of joints of a model that has some has a section, too."""
    strip = {"thickness": 0.3, "E": 30e9, "nu": 0.2}
    model = Model(
        plate={"name": "A", "outline": {"kind": "rectangle", "x": (0, 4), "y": (0, 4)}, **strip},
        plates=[{"name": "B", "outline": {"kind": "rectangle", "x": (4, 8), "y": (0, 4)}, **strip}],
        joints=[{"kind": "hinge", "between": ("A", "B")}],
        ground={"kind": "winkler", "k": 20e6},
        loads=[{"kind": "uniform", "q": 1e3}],
    )
    tables = tables_of(Results(model, list_combinations(model), {}, {"all loads": Exception("not solved")}))
    (table,) = (each for each in tables if each.name == "joints")
    assert explained("joints") == [(column.name, column.unit) for column in table.columns]


@pytest.mark.parametrize(
    ("code", "heading"),
    [("EN 1992-1-1", ""), ("ACI 318", ", by ACI 318"), ("EN 1992-1-1:2023", ", by EN 1992-1-1:2023")],
)
def test_columns_of_walls_that_punch_are_explained(code: str, heading: str) -> None:
    """The table of ends and corners of walls has a section for each code."""
    model = Model(
        plate={"length_x": 4, "length_y": 4, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        walls=[{"name": "W", "thickness": 0.2, "points": [(0, 0), (1, 0)]}],
        loads=[{"kind": "line", "q": 1e3, "wall": "W", "case": "G"}],
        cases=[{"name": "G"}],
        combinations=[{"name": "ULS", "factors": {"G": 1.35}}],
        reinforcement={"code": code, "f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)},
    )
    tables = tables_of(Results(model, list_combinations(model), {}, {"ULS": Exception("not solved")}))
    (table,) = (each for each in tables if each.name == "wall_punching")
    own = explained(f"wall_punching{heading}")
    assert [(column.name, column.unit) for column in table.columns][-len(own) :] == own


def names_of_checks() -> set[str]:
    """Return what checks are called that give a verdict, in the sources; not those put together of several words."""
    calls = (
        node
        for file in sorted((PACKAGE / "design").rglob("*.py"))
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("DesignCheck", "not_judged") and node.args
    )
    texts = [[part.value for part in call.args[:2] if isinstance(part, ast.Constant)] for call in calls
             if isinstance(call.args[0], ast.Constant)]  # fmt: skip
    return {str(name) for name, *status in texts if status != ["not checked"]}


def test_every_check_is_explained() -> None:
    """A row of the table of checks, or of the one on floors, names each; a check that nobody knows helps nobody."""
    rows = re.findall(r"^\| ([^|]+) \|", PAGE, re.MULTILINE)
    explained = {re.sub(r" \(.*\)$", "", name) for row in rows for name in row.split(", ")}
    names = names_of_checks() - {"floor"}  # without a combination, as what is unjudged says
    assert len(names) > 20
    assert sorted(name for name in names if not any(each.startswith(name) for each in explained)) == []


def test_every_field_is_named_where_it_is_asked_for() -> None:
    """The help of plot, the page on plots and the fields of studies have each nodal field."""
    page = (DOCS / "plots.md").read_text(encoding="utf-8")
    command = (PACKAGE / "cli" / "plot.py").read_text(encoding="utf-8")
    for name in DRAWN:
        assert re.search(rf"\b{name}\b", command), name
        assert name in BAR_FIELDS or f"`{name}`" in page, name
    assert {about.meaning for about in RANGED_FIELDS.values()} <= {about.meaning for about in STUDIED.values()}
