"""Forces and moments on the slab are those that statics demands, whatever the axes and signs of the table."""

from __future__ import annotations

from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest

import groundslab
from groundslab.exchange.reactions import read_reactions
from groundslab.exchange.reactions.forces import signs_in_words, to_force
from groundslab.exchange.reactions.table import Reaction
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.load_types import PointLoad
from groundslab.model.reactions import Reactions
from helpers.reactions import CASE, write_case, write_table

#: A weight of 7 kN, 3 m to the right of a column and 2 m up the page: by definition P = 7, M_x = 21, M_y = 14 kNm.
WEIGHT, DX, DY = 7.0, 3.0, 2.0
#: Axes of programs as rows in x to the right, y up the page, z up; right-handed all of them.
AXES = {"z up": np.diag([1.0, 1.0, 1.0]), "z down": np.diag([1.0, -1.0, -1.0])}


@pytest.mark.parametrize("axes", AXES)
@pytest.mark.parametrize("on", ["the structure", "the slab"])
def test_signs_by_equilibrium(axes: str, on: str) -> None:
    """The reaction is found by equilibrium in space with vectors, then read with the signs that fit."""
    weight = np.array([0.0, 0.0, -WEIGHT])
    moment = np.cross([DX, DY, 5.0], weight)
    sign = -1.0 if on == "the structure" else 1.0
    force, moment = sign * AXES[axes] @ weight, sign * AXES[axes] @ moment
    row = Reaction(1, "A", "G", None, *(Decimal(str(each)) for each in (force[2], moment[0], moment[1])))
    reading = Reactions(positive="presses" if force[2] > 0 else "lifts", mirrored=axes == "z down")
    found = to_force(row, reading)
    assert (found.P, found.M_x, found.M_y) == (7, 21, 14)


def test_etabs_and_rfem_by_default() -> None:
    """ETABS states what acts on the structure, z up; RFEM what acts on the slab, z down, y down the page."""
    etabs = Reaction(1, "A", "G", None, Decimal(7), Decimal(14), Decimal(-21))  # as (0, 0, 7) at (3, 2) would have
    assert to_force(etabs, Reactions()).M_x == 21
    assert to_force(etabs, Reactions()).M_y == 14
    rfem = Reaction(1, "A", "G", None, Decimal(7), Decimal(-14), Decimal(-21))  # the same at (3, -2)
    assert to_force(rfem, Reactions(mirrored=True)) == to_force(etabs, Reactions())


def test_other_moments() -> None:
    """By the left-hand rule they have the other sign; those that mean the same as here stay."""
    row = Reaction(1, "A", "G", None, Decimal(-7), Decimal(21), Decimal(14))
    here = to_force(row, Reactions(positive="lifts", moments="as here"))
    assert (here.P, here.M_x, here.M_y) == (7, 21, 14)
    right = to_force(row, Reactions(positive="lifts"))
    left = to_force(row, Reactions(positive="lifts", moments="about axes, left-handed"))
    assert (left.M_x, left.M_y) == (-right.M_x, -right.M_y)


def test_signs_are_told() -> None:
    """In a line that a person can compare with the other program's manual."""
    assert signs_in_words(Reactions()) == "P = F_z, M_x = -M_y of the table, M_y = M_x of the table"
    assert signs_in_words(Reactions(positive="lifts", moments="as here")) == (
        "P = -F_z, M_x = M_x of the table, M_y = M_y of the table"
    )


def sums(model: groundslab.Model, case: str) -> tuple[float, float, float]:
    """Return P, M_x and M_y about x = y = 0 of the imported loads of a case, lines summed up in small pieces."""
    total = np.zeros(3)
    for load in model.loads:
        if load.case != case:
            continue
        if isinstance(load, PointLoad) and load.source:
            column = next(each for each in model.columns if each.name == load.column)
            total += [load.P, load.M_x + load.P * column.x, load.M_y + load.P * column.y]
        elif isinstance(load, LineLoad | LineMoment) and load.source:
            (x0, y0), (x1, y1) = next(each.line for each in model.placed_walls if each.name == load.wall)
            s = (np.arange(1000) + 0.5) / 1000
            L = np.hypot(x1 - x0, y1 - y0)
            if isinstance(load, LineLoad):
                P = (load.q + s * ((load.q if load.q_end is None else load.q_end) - load.q)) * L / 1000
                total += [P.sum(), (P * (x0 + s * (x1 - x0))).sum(), (P * (y0 + s * (y1 - y0))).sum()]
            else:
                total += [0.0, -load.m * (y1 - y0), load.m * (x1 - x0)]
    return tuple(total.tolist())


ON_WALL = """\
Joint;x [m];y [m];Case;FZ [kN];MX [kNm];MY [kNm]
1;-0,8;{y};G;100;3;-4
2;0,5;{y};G;250;0;0
3;1,0;{y};G;-20;1;2
"""


def test_supports_of_a_wall_by_hand(tmp_path: Path) -> None:
    """P = 330 kN; about the middle M_x = -80 + 125 - 20 + 4 - 2 = 27 kNm, across M_y = 3 + 1 = 4 kNm, L = 2 m."""
    table = write_table(tmp_path, ON_WALL.format(y="2"))
    model = read_reactions(table, write_case(tmp_path)).model
    line, moment = (load for load in model.loads if isinstance(load, LineLoad | LineMoment))
    assert isinstance(line, LineLoad)
    assert isinstance(moment, LineMoment)
    assert (line.q, line.q_end) == pytest.approx((165e3 - 6 * 27e3 / 4, 165e3 + 6 * 27e3 / 4), rel=1e-8)
    assert moment.m == pytest.approx(4e3 / 2)
    assert line.source == "1, 2, 3"
    # about x = y = 0, with the wall at y = 2 m
    assert sums(model, "G") == pytest.approx((330e3, 27e3, 4e3 + 2 * 330e3), rel=1e-5)


PER_LENGTH = """\
Wall,Case,Fx [kN/m],Fy [kN/m],pz [kN/m],Mx [kNm/m],My [kNm/m]
W,G,1.5,-2,30,5,0
"""


def test_forces_per_length_of_a_wall(tmp_path: Path) -> None:
    """On 2 m along x, 30 kN/m and 5 kNm/m about the wall's axis are loads as they are; 1.5 kN/m sideways are 3 kN."""
    table = write_table(tmp_path, PER_LENGTH)
    imported = read_reactions(table, write_case(tmp_path), horizontal="on the structure")
    line, moment = (load for load in imported.model.loads if isinstance(load, LineLoad | LineMoment))
    assert (line.wall, line.magnitudes[0][1], line.q_end) == ("W", 30e3, None)
    # M_x of the table turns about x: by its signs it presses what lies up the page, left of the wall, down
    assert (moment.wall, moment.magnitudes[0][1]) == ("W", 5e3)
    case = next(each for each in imported.model.cases if each.name == "G")
    assert (case.H_x, case.H_y) == (-3e3, 4e3)
    assert 'q = "30 kN/m"' in imported.text


def test_forces_per_length_are_of_one_wall_each(tmp_path: Path) -> None:
    """A column has no length, and two line supports on one wall have lengths that the table does not say."""
    rows = "1,G,0,0,10,0,0\n2,G,0,0,10,0,0\n3,G,0,0,10,0,0\n"
    table = write_table(tmp_path, PER_LENGTH.splitlines()[0] + "\n" + rows)
    with pytest.raises(groundslab.InputError) as caught:
        read_reactions(table, write_case(tmp_path), supports={"1": "A", "2": "W", "3": "W"})
    assert [issue.found for issue in caught.value.issues] == [
        'forces per m of "1" on A',
        'forces per m of "2" and "3" on W',
    ]


def test_horizontal_forces(tmp_path: Path) -> None:
    """Reactions on the structure act on the slab with the other sign; y that points the other way changes its own."""
    text = "Joint,Case,FX,FY,FZ\n,,kN,kN,kN\nA,G,5,2,100\nB,G,-1,4,50\nA,Q,7,0,10\n"
    table, case = write_table(tmp_path, text), write_case(tmp_path)
    left = read_reactions(table, case)
    assert any("G 4 and 6, Q 7 and 0" in remark for remark in left.remarks)
    assert all(each.H_x == each.H_y == 0 for each in left.model.cases)
    taken = read_reactions(table, case, horizontal="on the structure")
    assert [(each.H_x, each.H_y) for each in taken.model.cases] == [(-4e3, -6e3), (-7e3, 0)]
    assert "changed: G: H_x 0 -> -4 kN, H_y 0 -> -6 kN" in map(str, taken.changes)
    mirrored = read_reactions(table, case, horizontal="on the slab", mirrored=True)
    assert [(each.H_x, each.H_y) for each in mirrored.model.cases] == [(4e3, -6e3), (7e3, 0)]
    # how they were taken is kept, so the same table changes nothing
    assert read_reactions(table, taken.model).changes == ()


def test_an_inclined_wall_has_the_resultant_of_its_supports(tmp_path: Path) -> None:
    """Its sums about x = y = 0 are those of the table's rows, added by hand in a loop."""
    points = 'points = [["-2 m", "-2 m"], ["1 m", "2 m"]]'
    case = write_case(tmp_path, CASE.replace('points = [["-1 m", "2 m"], ["1 m", "2 m"]]', points))
    places = [(-2 + 3 * t, -2 + 4 * t) for t in (0.1, 0.5, 0.9)]
    rows = [(x, y, P, Mx, My) for (x, y), P, Mx, My in zip(places, (100, 50, 7), (3, 0, -5), (-2, 8, 1), strict=True)]
    text = "Joint,X,Y,Case,FZ,MX,MY\n,m,m,,kN,kN-m,kN-m\n" + "".join(
        f"{n},{x},{y},G,{P},{Mx},{My}\n" for n, (x, y, P, Mx, My) in enumerate(rows)
    )
    imported = read_reactions(write_table(tmp_path, text), case)
    P = sum(row[2] for row in rows)
    M_x = sum(row[2] * row[0] - row[4] for row in rows)
    M_y = sum(row[2] * row[1] + row[3] for row in rows)
    assert sums(imported.model, "G") == pytest.approx((1e3 * P, 1e3 * M_x, 1e3 * M_y), rel=1e-5)
    (told,) = imported.sums
    assert (told.after.P, told.after.M_x, told.after.M_y) == pytest.approx((1e3 * P, 1e3 * M_x, 1e3 * M_y), rel=1e-8)


def test_a_bent_wall_bears_the_force_alone(tmp_path: Path) -> None:
    """Evenly; that its moments are left out is said."""
    points = 'points = [["-1 m", "1 m"], ["1 m", "1 m"], ["1 m", "2 m"]]'
    case = write_case(tmp_path, CASE.replace('points = [["-1 m", "2 m"], ["1 m", "2 m"]]', points))
    table = write_table(tmp_path, "Wall,Case,Fz [kN],Mx [kNm]\nW,G,300,5\n")
    imported = read_reactions(table, case)
    (line,) = (load for load in imported.model.loads if isinstance(load, LineLoad | LineMoment))
    assert isinstance(line, LineLoad)
    assert (line.q, line.q_end) == (pytest.approx(100e3), None)
    assert any("not straight" in remark for remark in imported.remarks)


def test_kips_and_feet(tmp_path: Path) -> None:
    """Loads keep the table's units, exactly: 1 kip = 4448.2216152605 N, 1 kip ft = 1355.8179483314 N m."""
    text = "Joint,X,Y,Case,FZ,MX\n,ft,ft,,kip,kip-ft\n7,6.5617,0,G,100.1,2\nW,,,G,65.617,\n"
    imported = read_reactions(write_table(tmp_path, text), write_case(tmp_path))
    point, line = (load for load in imported.model.loads if isinstance(load, PointLoad | LineLoad))
    assert isinstance(point, PointLoad)
    assert isinstance(line, LineLoad)
    assert point.column == "B"
    assert pytest.approx(100.1 * 4448.2216152605, rel=1e-12) == point.P
    assert point.M_y == pytest.approx(2 * 1355.8179483314, rel=1e-12)
    assert 'P = "100.1 kip"' in imported.text
    assert line.q == pytest.approx(65.617 * 4448.2216152605 / 2, rel=1e-8)
    assert "kip/ft" in imported.text
