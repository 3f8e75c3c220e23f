"""Reactions are taken into a case, with its comments; imported again they show what has changed."""

from __future__ import annotations

import zipfile
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.exchange.reactions import ImportedReactions, read_reactions
from groundslab.model.loads.load_types import PointLoad
from helpers.reactions import BY_HAND, CASE, ETABS, RFEM, write_case, write_table, write_workbook

LAYOUTS = ["ETABS", "RFEM", "by hand"]
NAMES = {"101": "A", "102": "B"}


def imported(folder: Path, text: str = BY_HAND, case: str = CASE, **given: Any) -> ImportedReactions:
    """Return a case with a table."""
    return read_reactions(write_table(folder, text), write_case(folder, case), **given)


def points(result: ImportedReactions) -> dict[tuple[str, str], tuple[float, float, float]]:
    """Return the imported point loads by column and case [kN, kNm]."""
    loads = (load for load in result.model.loads if isinstance(load, PointLoad) and load.source)
    return {
        (load.column, load.case): (round(load.P / 1e3, 9), round(load.M_x / 1e3, 9), round(load.M_y / 1e3, 9))
        for load in loads
    }


#: Of all tables of the helpers, by the signs of right-handed axes: P = F_z, M_x = -M_y, M_y = M_x of the table.
TAKEN = {("A", "G"): (1812.4, 20, 10), ("A", "Q"): (300, -2, 1), ("B", "G"): (500, 0, 0), ("B", "Q"): (-50, 0, 0)}


@pytest.mark.parametrize(("text", "given"), [(ETABS, {"supports": NAMES}), (RFEM, {}), (BY_HAND, {})], ids=LAYOUTS)
def test_loads_by_hand(text: str, given: dict[str, Any], tmp_path: Path) -> None:
    """Tables of all layouts give the same loads; sums by case are those of an adding machine."""
    result = imported(tmp_path, text, **given)
    assert points(result) == TAKEN
    dead, live = result.sums
    assert (dead.case, dead.before.P, dead.after.P) == ("G", 0.0, pytest.approx(2312.4e3))
    # columns at x = -2 m and x = 2 m
    assert dead.after.M_x == pytest.approx(-2 * 1812.4e3 + 20e3 + 2 * 500e3)
    assert (live.after.P, live.after.M_x, live.after.M_y) == pytest.approx((250e3, -702e3, 1e3))
    assert [change.kind for change in result.changes] == ["new"] * 4


def test_everything_else_keeps_its_characters(tmp_path: Path) -> None:
    """The text is that of the case with lines inserted, none changed; it describes the model."""
    result = imported(tmp_path)
    lines = iter(result.text.splitlines())
    assert all(line in lines for line in CASE.splitlines())
    assert casefile.loads(result.text) == result.model


@pytest.mark.parametrize("text", [ETABS, RFEM, BY_HAND], ids=LAYOUTS)
def test_the_same_table_again_changes_nothing(text: str, tmp_path: Path) -> None:
    """Not a character, and it needs no word about how it is read."""
    first = imported(tmp_path, text, supports=NAMES if text == ETABS else {}, tolerance="50 mm")
    again = imported(tmp_path, text, first.text)
    assert again.text == first.text
    assert again.changes == ()
    assert all(each.before == each.after for each in again.sums)


def test_what_has_changed_is_shown(tmp_path: Path) -> None:
    """New, gone, changed by more than the threshold, or by less, with sums before and after."""
    first = imported(tmp_path, RFEM)
    later = RFEM.replace("1.812,400", "1.900,000").replace("500,000", "501,000")
    later = later.replace(";Q;0,000;0,000;-50,000", ";G2;0,000;0,000;9,000")
    again = imported(tmp_path, later, first.text, new_cases={"G2": "permanent"})
    found = {(change.kind, change.name, change.case) for change in again.changes}
    assert found == {("changed", "A", "G"), ("less", "B", "G"), ("new", "B", "G2"), ("gone", "B", "Q")}
    assert [(each.before.P, each.after.P) for each in again.sums if each.case == "G"] == [
        (pytest.approx(2312.4e3), pytest.approx(2401e3))
    ]
    finer = imported(tmp_path, later, first.text, new_cases={"G2": "permanent"}, threshold=0.001)
    assert {change.kind for change in finer.changes} == {"changed", "new", "gone"}
    assert 'P = "1900 kN"' in again.text
    assert "changed: A in G: P 1.8124 -> 1.9 MN" in "\n".join(map(str, again.changes))


def test_notes_of_people_stay(tmp_path: Path) -> None:
    """Comments and names that somebody gave to imported loads stay with them while others go."""
    first = imported(tmp_path, RFEM).text
    mine = first.replace('P = "500 kN"', 'P = "500 kN"  # with the stair\nname = "stair"')
    later = RFEM.replace("A;G;0,000;0,000;1.812,400;10,000;-20,000;0,000;\n;Q", "A;Q").replace("500,000", "510,000")
    text = imported(tmp_path, later, mine).text
    assert 'P = "510 kN"  # with the stair\nname = "stair"' in text
    assert "1812.4" not in text
    assert "# concrete\n[[loads]]\nkind = \"self weight\"" in text  # fmt: skip


def test_loads_of_people_are_left_alone(tmp_path: Path) -> None:
    """A load on the same column without a source is none of the table's."""
    own = CASE + '\n[[loads]]\nkind = "point"\ncase = "G"\ncolumn = "A"\nP = "1 kN"\n'
    first = imported(tmp_path, RFEM, own)
    again = imported(tmp_path, "Node,Case,Fz [kN]\nB,G,7\n", first.text)
    assert [load.P for load in again.model.loads if isinstance(load, PointLoad)] == [1e3, 7e3]


def test_supports_by_place(tmp_path: Path) -> None:
    """The nearest column within the tolerance; what is farther away is listed with all others, or gets a column."""
    text = "Node,x [m],y [m],Case,Fz [kN]\n1,-2.05,0,G,100\n2,2.3,0.1,G,50\n3,3,1.5,G,70\n"
    with pytest.raises(InputError) as caught:
        imported(tmp_path, text)
    assert [issue.found.split(",")[0] for issue in caught.value.issues] == ['support "2" at (2.3', 'support "3" at (3']
    assert "the nearest one is B, 0.316 m off" in str(caught.value)
    wide = imported(tmp_path, text, tolerance="0.4 m", footprint=("300 mm", "40 cm"))
    assert points(wide) == {("A", "G"): (100, 0, 0), ("B", "G"): (50, 0, 0), ("3", "G"): (70, 0, 0)}
    made = wide.model.columns[-1]
    assert (made.name, made.x, made.y, made.width_x, made.width_y) == ("3", 3.0, 1.5, 0.3, 0.4)
    left = imported(tmp_path, text, tolerance="0.4 m", without_supports=("3",))
    assert set(points(left)) == {("A", "G"), ("B", "G")}


def test_another_origin_and_a_mirrored_plan(tmp_path: Path) -> None:
    """Places of the table are moved, and turned over where its y points down the page."""
    text = "Node,x [m],y [m],Case,Fz [kN],Mx [kNm]\n1,8,-3,G,100,5\n2,13,-2,G,7,0\n"
    result = imported(tmp_path, text, origin=("-10 m", "-3 m"), mirrored=True, footprint=("0.3 m", "0.3 m"))
    assert points(result)["A", "G"] == (100, 0, -5)
    assert (result.model.columns[-1].x, result.model.columns[-1].y) == (3.0, -1.0)
    assert imported(tmp_path, text, result.text).text == result.text


def test_moved_columns(tmp_path: Path) -> None:
    """A column by name that stands elsewhere in the table is told, and moved there if that is asked for."""
    text = "Node,x [m],y [m],Case,Fz [kN]\nA,-1.5,0.25,G,100\n"
    stays = imported(tmp_path, text)
    assert str(stays.changes[0]) == "moved: A from (-2, 0) m to (-1.5, 0.25) m"
    assert stays.model.columns[0].x == -2.0
    goes = imported(tmp_path, text, move_columns=True)
    assert (goes.model.columns[0].x, goes.model.columns[0].y) == (-1.5, 0.25)
    assert [change.kind for change in imported(tmp_path, text, goes.text).changes] == []


def test_load_cases_are_not_guessed(tmp_path: Path) -> None:
    """New ones need an action; combinations are left out, unless they are wanted."""
    text = "Node,Case,Fz [kN]\nA,Dead,1\nA,Live,2\nA,COMB1,3\nA,G,4\n"
    with pytest.raises(InputError) as caught:
        imported(tmp_path, text)
    assert [issue.found for issue in caught.value.issues] == ['load case "Dead"', 'load case "Live"']
    given = {"cases": {"Dead": "G"}, "new_cases": {"Live": "C"}, "without_cases": ("G",)}
    result = imported(tmp_path, text, **given)
    assert points(result) == {("A", "G"): (1, 0, 0), ("A", "Live"): (2, 0, 0)}
    new = result.model.cases[-1]
    assert (new.name, new.action, new.category) == ("Live", "variable", "C")
    assert any("COMB1" in remark for remark in result.remarks)
    assert imported(tmp_path, text, result.text).text == result.text
    wanted = imported(tmp_path, text, **given | {"new_cases": {"Live": "wind", "COMB1": "permanent"}})
    assert points(wanted)["A", "COMB1"] == (3, 0, 0)
    with pytest.raises(InputError, match="category of variable"):
        imported(tmp_path, text, **given | {"new_cases": {"Live": "heavy"}})
    with pytest.raises(InputError, match="Snow"):
        imported(tmp_path, text, **given | {"new_cases": {"Live": "C", "Snow": "snow"}})


UNITS_ROW = """TABLE:  Joint Reactions
Joint\tOutputCase\tCaseType\tStepType\tF1\tF2\tF3\tM1\tM2\tM3
Text\tText\tText\tText\tkN\tkN\tkN\tkN-m\tkN-m\tkN-m
A\tG\tLinStatic\t\t0.5\t0\t25.0\t0\t3.2\t0
A\tSX\tLinRespSpec\tMax\t1.2\t0\t6.0\t0\t5.0\t0
A\tENVOL\tCombination\tMax\t1.2\t0\t30.0\t0\t5.0\t0
"""


@pytest.mark.parametrize("given", [{"new_cases": {"SX": "seismic"}}, {"cases": {"SX": "Q"}}])
def test_values_without_signs_are_no_load(given: dict[str, Any], tmp_path: Path) -> None:
    """Neither as a new case nor as one that is there: the largest values of a response spectrum do not act together."""
    with pytest.raises(InputError, match=r'"SX".*LinRespSpec.*without signs'):
        imported(tmp_path, UNITS_ROW, **given)
    left = imported(tmp_path, UNITS_ROW.replace("ENVOL\tCombination\tMax", "COMB1\tCombination\t"))
    assert points(left) == {("A", "G"): (25, -3.2, 0)}
    said = "\n".join(left.remarks)
    assert 'cases of largest values without signs are left out: SX (row 5, "LinRespSpec" "Max")' in said
    assert "combinations are left out, as only load cases are loads: COMB1" in said


@pytest.mark.parametrize("kind", ["LinMoving", "Moving Load", "Response Spectrum", "LinModHist", "Time History"])
def test_other_cases_of_largest_values_are_no_combinations(kind: str, tmp_path: Path) -> None:
    """Moving loads, spectra and histories are left out under their own name."""
    said = "\n".join(imported(tmp_path, f"Node,Case,Case Type,Fz [kN]\nA,G,LinStatic,1\nA,MOV,{kind},5\n").remarks)
    assert f'cases of largest values without signs are left out: MOV (row 3, "{kind}")' in said
    assert "combinations" not in said


def test_an_envelope_is_no_load_either(tmp_path: Path) -> None:
    """Also if it has the name of a load case, or its largest values alone are in the table."""
    with pytest.raises(InputError, match=r'"ENVOL".*"Max"'):
        imported(tmp_path, UNITS_ROW, new_cases={"ENVOL": "variable"})
    with pytest.raises(InputError, match=r'"Q".*"Max"'):
        imported(tmp_path, UNITS_ROW.replace("ENVOL\tCombination", "Q\tLinStatic"))


def test_what_contradicts_the_action_of_a_case_is_said(tmp_path: Path) -> None:
    """A type of the table, and a seismic case without a negative value; neither where they agree."""
    text = "Node,Case,Load type,Fz [kN],Mx [kNm]\nA,G,Live,10,1\nA,EX,Quake,5,2\nB,EX,Quake,6,2\n"
    said = "\n".join(imported(tmp_path, text, new_cases={"EX": "seismic"}).remarks)
    assert 'load case "G" has the type "Live" in the table and is permanent here' in said
    assert 'load case "EX" is seismic and none of its values is negative' in said
    right = text.replace("Live", "Dead").replace("B,EX,Quake,6", "B,EX,Quake,-6")
    assert imported(tmp_path, right, new_cases={"EX": "seismic"}).remarks[1:] == ()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Node,Case,Fz [kN],Mx [kip ft]\nA,G,10,1\n", "forces are in kN and moments in kip ft"),
        ("Node,Case,Fz [kN],Mx [kNm]\nA,G,10,1\n", ""),
    ],
)
def test_units_that_contradict_are_remarks(text: str, said: str, tmp_path: Path) -> None:
    """Forces and moments of two systems; a unit that was given and another one in the table."""
    assert said in "\n".join(imported(tmp_path, text).remarks)
    assert ("forces are in kN and" in "\n".join(imported(tmp_path, text).remarks)) == bool(said)
    given = imported(tmp_path, text, force="kip")
    assert "forces are in kN, as the table says, not in kip" in given.remarks


def test_two_rows_of_a_support_are_refused(tmp_path: Path) -> None:
    """As of several stories or steps, of which one alone stands on the slab."""
    with pytest.raises(InputError, match="as in row 2"):
        imported(tmp_path, "Node,Case,Fz [kN]\nA,G,1\nA,G,2\n")


def test_horizontal_forces_are_told(tmp_path: Path) -> None:
    """They are not taken, and their sums are in a remark."""
    result = imported(tmp_path, "Node,Case,Fx [kN],Fy [kN],Fz [kN]\nA,G,1.5,0,7\nB,G,2,-1,7\n")
    assert any("G 3.5 and -1" in remark for remark in result.remarks)


def test_a_case_without_loads_and_a_model(tmp_path: Path) -> None:
    """The first loads of a case may be those of the table; a model is as good as a file."""
    bare = CASE[: CASE.index("# concrete")] + CASE[CASE.index("[mesh]") :]
    result = imported(tmp_path, BY_HAND, bare)
    assert points(result) == TAKEN
    of_model = read_reactions(write_table(tmp_path, BY_HAND), casefile.loads(CASE))
    assert points(of_model) == TAKEN


def test_tables_in_a_line_and_line_ends_of_windows(tmp_path: Path) -> None:
    """Any layout of the case is edited or rewritten so that it means the same."""
    inline = CASE.replace('[[cases]]\nname = "G"\n\n[[cases]]\nname = "Q"\naction = "variable"\ncategory = "B"\n', "")
    inline = 'cases = [{name = "G"}, {name = "Q", action = "variable", category = "B"}]\n' + inline
    loads = CASE[CASE.index("[[loads]]") : CASE.index("[mesh]")]
    inline = 'loads = [{kind = "self weight", unit_weight = "25 kN/m^3", case = "G"}]\n' + inline.replace(loads, "")
    result = imported(tmp_path, BY_HAND, inline)
    assert points(result) == TAKEN
    later = imported(tmp_path, "Node,Case,Fz [kN]\nB,G,7\n", result.text)
    assert points(later) == {("B", "G"): (7, 0, 0)}
    path = tmp_path / "windows.toml"
    path.write_bytes(CASE.replace("\n", "\r\n").encode())
    text = read_reactions(write_table(tmp_path, BY_HAND), path).text
    assert text.count("\n") == text.count("\r\n")


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"positive": "down"}, "positive"),
        ({"force": "m"}, "force"),
        ({"sign": 1}, "sign"),
        ({"cases": {"X": "nothing"}}, "nothing"),
        ({"supports": {"A": "nothing"}}, "nothing"),
        ({"without_cases": ("G", "Q")}, "at least one"),
    ],
)
def test_wrong_choices_are_refused(given: dict[str, Any], said: str, tmp_path: Path) -> None:
    """With their keys."""
    with pytest.raises(InputError, match=said):
        imported(tmp_path, **given)


def test_damaged_tables_are_read_or_refused(tmp_path: Path) -> None:
    """Bytes deleted, doubled, replaced: each file gives a case that can be read back, or a list of issues."""
    for seed in range(200):
        rng = np.random.default_rng(seed)
        content = bytearray((ETABS, RFEM, BY_HAND)[seed % 3].encode())
        for _ in range(rng.integers(1, 8)):
            at, what = int(rng.integers(len(content))), rng.integers(5)
            if what == 0:
                del content[at : at + int(rng.integers(1, 30))]
            elif what == 1:
                content[at:at] = content[at : at + int(rng.integers(1, 60))]
            elif what == 2:
                content[at] = int(rng.integers(256))
            elif what == 3:
                content[at:at] = bytes(rng.choice([*b'",;\t\n\r=-+.[](){}0e9'], 3).tolist())
            else:
                content[at:at] = rng.choice([b"9" * 400, b"1e999", b'"', b"\xff\xfe", b"kN", b"\x85", b"nan"])
        path = tmp_path / "damaged.csv"
        path.write_bytes(bytes(content))
        with suppress(InputError):
            result = read_reactions(path, write_case(tmp_path), supports=NAMES)
            assert casefile.loads(result.text) == result.model


def test_damaged_workbooks_are_read_or_refused(tmp_path: Path) -> None:
    """Also where what is packed in them is damaged, not the archive around it."""
    for seed in range(60):
        rng = np.random.default_rng(seed)
        rows = [["Joint", "Case", "FZ"], [None, None, "kN"], ["A", "G", 1.5], ["B", "G", 2]]
        path = write_workbook(tmp_path / "table.xlsx", {"Base": rows})
        with zipfile.ZipFile(path) as archive:
            parts = {name: bytearray(archive.read(name)) for name in archive.namelist()}
        content = parts[sorted(parts)[seed % len(parts)]]
        for _ in range(rng.integers(1, 6)):
            at = int(rng.integers(len(content)))
            content[at : at + int(rng.integers(0, 3))] = rng.choice([b"", b"<", b"&lol;", b"9" * 50, b"\xff", b'"'])
        with zipfile.ZipFile(path, "w") as archive:
            for name, part in parts.items():
                archive.writestr(name, bytes(part))
        if seed % 4 == 0:
            whole = bytearray(path.read_bytes())
            whole[int(rng.integers(len(whole)))] ^= 255
            path.write_bytes(bytes(whole))
        with suppress(InputError):
            result = read_reactions(path, write_case(tmp_path))
            assert casefile.loads(result.text) == result.model
