"""Cores: force and moments over walls by N / A + M y / I, by hand, by symmetry and by their sums."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from groundslab.case import casefile
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.model.loads.acting import LineForce
from groundslab.model.model import Model
from groundslab.model.remarks.remarks import find_remarks
from groundslab.model.remarks.resultants import case_resultants
from groundslab.model.structure.cores import section_of
from groundslab.views.tables.result_tables import table_makers
from groundslab.views.tables.table import Table
from helpers.solve_once import solve_once

PLATE = {"length_x": 14.0, "length_y": 12.0, "thickness": 0.6, "E": 33e9, "nu": 0.2}
#: A U of a web along y and two flanges along x, as thick everywhere, b wide and a high.
T, B, A = 0.3, 4.0, 6.0
U = {"name": "U", "thickness": T, "points": [(B, A / 2), (0, A / 2), (0, -A / 2), (B, -A / 2)]}
#: Area, center and moments of inertia of the U by hand.
AREA = T * (A + 2 * B)
X_0 = T * B**2 / AREA
I_XX = T * (2 * B**3 / 12 + 2 * B * (B / 2 - X_0) ** 2 + A * X_0**2)
I_YY = T * (A**3 / 12 + 2 * B * (A / 2) ** 2)
BOX = {"name": "box", "thickness": T, "shape": {"kind": "rectangle", "x": (-2, 2), "y": (-3, 3)}}


def model(walls: list[dict[str, Any]], *loads: dict[str, Any], **changes: Any) -> Model:
    """Return a slab with walls that are all one core K, with loads of it."""
    parts: dict[str, Any] = {
        "plate": PLATE,
        "ground": {"kind": "winkler", "k": 30e6},
        "walls": walls,
        "cores": [{"name": "K", "walls": [wall["name"] for wall in walls]}],
        "loads": [{"kind": "core", "core": "K", "P": 0.0, **load} for load in loads],
    }
    return Model(**parts | changes)


def ends(m: Model) -> dict[tuple[Any, ...], tuple[float, float]]:
    """Return the force per length at both ends of each piece by its places."""
    lines = [shape for _, shape in m.acting if isinstance(shape, LineForce)]
    return {(line.edges[0].start, line.edges[0].end): line.q for line in lines}


def sums(m: Model, about: tuple[float, float]) -> list[float]:
    """Return force and moments about a place, by the resultant of all that acts about the middle of the plan."""
    (of_case,) = case_resultants(m).values()
    return [of_case.F, of_case.M_x - about[0] * of_case.F, of_case.M_y - about[1] * of_case.F]


def test_a_u_by_hand() -> None:
    """A channel of 0.3 m: sigma = P / A + M_x (x - x_0) / I_xx + M_y y / I_yy at its corners and tips."""
    P, M_x, M_y = 9e6, 2.5e6, -4e6
    m = model([U], {"P": P, "M_x": M_x, "M_y": M_y})
    section = section_of(m.cores[0], m.walls, m.every_plate)
    assert section.area == pytest.approx(AREA)
    assert section.center == pytest.approx((X_0, 0))
    assert np.array(section.inertia) == pytest.approx(np.diag([I_XX, I_YY]))

    def q(x: float, y: float) -> float:
        return T * (P / AREA + M_x * (x - X_0) / I_XX + M_y * y / I_YY)

    for (start, end), found in ends(m).items():
        assert found == pytest.approx((q(*start), q(*end)))
    assert sums(m, section.center) == pytest.approx([P, M_x, M_y])


@pytest.mark.parametrize("load", [{"P": 5e6}, {"M_x": 2e6}, {"M_y": 2e6}], ids=["P", "M_x", "M_y"])
def test_symmetric_cores_bear_symmetric_loads(load: dict[str, float]) -> None:
    """A box on the axes: the same at mirrored places; of moments the opposite on the other side."""
    m = model([BOX], load)
    at = {place: value for places, q in ends(m).items() for place, value in zip(places, q, strict=True)}
    for (x, y), value in at.items():
        assert at[-x, y] == pytest.approx(-value if "M_x" in load else value)
        assert at[x, -y] == pytest.approx(-value if "M_y" in load else value)
    assert sums(m, (0, 0)) == pytest.approx([load.get(key, 0.0) for key in ("P", "M_x", "M_y")], abs=1e-3)


def test_an_angle_has_products_of_inertia() -> None:
    """Of an L with legs of a and b by hand: I_xy bends it across a moment about one axis; its sums are exact."""
    a, b = 5.0, 3.0
    legs = [{"name": "long", "thickness": T, "points": [(0, 0), (a, 0)]},
            {"name": "short", "thickness": T, "points": [(0, 0), (0, b)]}]  # fmt: skip
    m = model(legs, {"M_x": 1e6})
    section = section_of(m.cores[0], m.walls, m.every_plate)
    x_0, y_0 = a**2 / 2 / (a + b), b**2 / 2 / (a + b)
    assert section.center == pytest.approx((x_0, y_0))
    xy = T * (-a * y_0 * (a / 2 - x_0) - b * x_0 * (b / 2 - y_0))
    (xx, found), (_, yy) = section.inertia
    assert found == pytest.approx(xy)
    # by Cramer's rule for the growth of stress along x and y
    along_x, along_y = yy * 1e6 / (xx * yy - xy**2), -xy * 1e6 / (xx * yy - xy**2)
    q = ends(m)[(0, 0), (a, 0)]
    assert q == pytest.approx((T * (-x_0 * along_x - y_0 * along_y), T * ((a - x_0) * along_x - y_0 * along_y)))
    assert along_y != 0
    assert sums(m, section.center) == pytest.approx([0, 1e6, 0], abs=1e-3)


@pytest.mark.parametrize("turn", [0.3, 1.2])
def test_a_core_that_is_turned_bears_the_same(turn: float) -> None:
    """Walls and moments turned together in plan, about no axis of the core, leave the forces per length as they are."""
    c, s = np.cos(turn), np.sin(turn)

    def turned(x: float, y: float) -> tuple[float, float]:
        return float(c * x - s * y), float(s * x + c * y)

    M = (3e6, 1e6)
    wall = {**U, "points": [turned(*place) for place in U["points"]]}  # type: ignore[misc,attr-defined]
    M_x, M_y = turned(*M)
    one, other = (list(ends(m).values()) for m in (
        model([U], {"P": 4e6, "M_x": M[0], "M_y": M[1]}), model([wall], {"P": 4e6, "M_x": M_x, "M_y": M_y})
    ))  # fmt: skip
    assert np.array(other) == pytest.approx(np.array(one))


@pytest.mark.parametrize("height", [None, 3.0], ids=["on the slab", "stiff"])
def test_openings_are_cut_out(height: float | None) -> None:
    """A door in the middle of a wall of 6 m leaves twice 2.4 m: P / A of these, I = 2 (2.4^3 / 12 + 2.4 1.8^2) t."""
    wall = {"name": "W", "thickness": T, "points": [(0, -3), (0, 3)], "height": height,
            "openings": [{"start": 2.4, "end": 3.6, "height": 2.1}]}  # fmt: skip
    m = model([wall], {"P": 3e6, "M_y": 1e6})
    I_yy = T * 2 * (2.4**3 / 12 + 2.4 * 1.8**2)
    expected = {
        ((0.0, low), (0.0, high)): tuple(3e6 / 4.8 + T * 1e6 * y / I_yy for y in (low, high))
        for low, high in ((-3.0, -0.6), (0.6, 3.0))
    }
    found = ends(m)
    assert np.array([*found]) == pytest.approx(np.array([*expected]))
    assert np.array([*found.values()]) == pytest.approx(np.array([*expected.values()]))


LINE = {"name": "W", "thickness": 0.2, "points": [(0, 0), (4, 0)]}
GO_ON = {"name": "V", "thickness": 0.2, "points": [(5, 0), (6, 0)]}
ACROSS = {"name": "V", "thickness": 0.2, "points": [(0, 0), (0, 4)]}


def test_walls_in_one_line_carry_moments_along_it() -> None:
    """M x / I of both together, with I = t (5^3 - 1 ...) by the differences of cubes about their center."""
    m = model([LINE, GO_ON], {"P": 1e6, "M_x": 1e6})
    x_0 = (4 * 2 + 1 * 5.5) / 5
    I = 0.2 * sum((high - x_0) ** 3 - (low - x_0) ** 3 for low, high in ((0, 4), (5, 6))) / 3  # noqa: E741
    q = ends(m)[(5, 0), (6, 0)]
    assert q == pytest.approx(tuple(1e6 / 5 + 0.2 * 1e6 * (x - x_0) / I for x in (5, 6)))


@pytest.mark.parametrize(
    ("walls", "changes", "place", "found"),
    [
        ([LINE], {"loads": [{"M_y": 1e6}]}, "loads[1].M_y", '1 MNm across core "K", whose walls stand in one line'),
        ([LINE, GO_ON], {"loads": [{"M_x": 1e6, "M_y": 1e5}]}, "loads[1].M_y", '100 kNm across core "K"'),
        ([LINE, {**GO_ON, "points": [(5, 0.01), (6, 0.01)]}], {"loads": [{"M_y": 1e6}]}, "loads[1].M_y",
         "1 MNm across"),
        ([LINE], {"loads": [{"core": "L"}]}, "loads[1].core", '"L"'),
        ([LINE], {"cores": [{"name": "K", "walls": ["V"]}]}, "cores[1].walls[1]", '"V"'),
        ([LINE], {"cores": [{"name": "K", "walls": ["W", "W"]}]}, "cores[1].walls[2]",
         'wall "W", which is in core "K"'),
        ([LINE], {"cores": [{"name": "K", "walls": ["W"]}, {"name": "L", "walls": ["W"]}]}, "cores[2].walls[1]",
         'wall "W", which is in core "K"'),
        ([LINE], {"cores": [{"name": "K", "walls": []}]}, "cores[1].walls", "an empty list"),
        ([LINE], {"cores": [{"name": "K", "walls": ["W"]}] * 2}, "cores[2].name", '"K" again'),
        ([{**LINE, "bulges": [0.3]}], {}, "cores[1].walls[1]", 'wall "W", which has arcs'),
        ([LINE, {**GO_ON, "points": [(3, 0), (6, 0)]}], {}, "cores[1].walls[2]",
         'wall "V", of which 1 m lie on wall "W"'),
        ([{**LINE, "height": 3.0, "openings": [{"start": 0, "end": 4, "height": 2}]}, ACROSS], {},
         "cores[1].walls[1]", 'wall "W", which is open all along'),
    ],
)  # fmt: skip
def test_what_is_refused(walls: list[dict[str, Any]], changes: dict[str, Any], place: str, found: str) -> None:
    """Each says where it is and what was found, and nothing else does."""
    loads = [{"kind": "core", "core": "K", "P": 1e6, **load} for load in changes.get("loads", [{}])]
    with pytest.raises(InputError) as refused:
        model(walls, **changes | {"loads": loads})
    issues = {issue.location: issue.found for issue in refused.value.issues}
    assert issues[place].startswith(found), issues


def table(m: Model, name: str) -> Table:
    """Return a table of the results."""
    return table_makers(solve_once(m))[name]()


CASES = {
    "cases": [{"name": "G"}, {"name": "W", "action": "variable", "category": "wind"}],
    "combinations": [{"name": "ULS", "factors": {"G": 1.0, "W": 1.5}}, {"name": "G alone", "factors": {"G": 1.0}}],
    "mesh": {"size": 1.5},
}


def test_from_the_file_to_the_tables(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Loads by case, their sums, the section, and what the walls bear in combinations; the ground bears it, too."""
    m = model([U], {"P": 9e6, "case": "G"}, {"M_y": 12e6, "case": "W"}, **CASES)
    path = tmp_path / "case.toml"
    path.write_text(casefile.to_toml(m), encoding="utf-8")
    read = casefile.load(path)
    assert read == m
    assert main.main(["check", str(path)]) == 0
    assert f"core K: {AREA:.4g} m2 in plan about ({X_0:.6g}, 0) m" in capsys.readouterr().out
    loads = table(read, "core_loads")
    rows = [dict(zip([column.name for column in loads.columns], row, strict=True)) for row in loads.rows()]
    assert [(row["case"], row["wall"]) for row in rows] == [(case, wall) for case in "GW" for wall in
                                                             ("U", "U", "U", "all walls")]  # fmt: skip
    totals = [[row[key] for key in ("force", "M_x", "M_y")] for row in rows if row["wall"] == "all walls"]
    assert totals == [pytest.approx([9e3, 0, 0]), pytest.approx([0, 0, 12e3])]
    assert rows[0]["load per length at the start"] == pytest.approx(9e3 * T / AREA)
    assert rows[4]["load per length at the start"] == pytest.approx(T * 12e3 * A / 2 / I_YY)
    assert table(read, "cores")["area"] == pytest.approx((AREA,))
    assert table(read, "walls")["load"] == pytest.approx((9e3, 9e3))
    one = solve_once(read)["G alone"]
    carried = one.plate.contact_force
    assert [carried.sum(), carried @ one.plate.nodes[:, 0]] == pytest.approx([9e6, 9e6 * X_0])


def test_uplift_is_remarked_on() -> None:
    """At the tip of a flange 1.5 M y / I is more than P / A where M is large enough, by hand; not before that."""
    at_zero = 9e6 / AREA * I_YY / (A / 2) / 1.5
    for M, pulls in ((0.99 * at_zero, False), (1.2 * at_zero, True)):
        m = model([U], {"P": 9e6, "case": "G"}, {"M_y": M, "case": "W"}, **CASES)
        words = [str(remark.words) for remark in find_remarks(m) if remark.path == ("cores", 0)]
        assert bool(words) == pulls
    q = 0.2 * 9e3 * T / AREA
    assert words == [
        'core "K" pulls at the slab in 1 of 2 combinations by its own loads: in ULS with '
        f'{q:.5g} kN/m at an end of wall "U"'
    ]
