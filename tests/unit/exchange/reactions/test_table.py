"""Tables of reactions are read as programs and people write them, and nothing in them is guessed."""

from __future__ import annotations

import random
import time
import zipfile
from decimal import Decimal
from pathlib import Path

import pytest

from groundslab import units
from groundslab.case.numbers import find_decimals, format_number, parse_number
from groundslab.errors import InputError
from groundslab.exchange.reactions import cells
from groundslab.exchange.reactions.headings import unit_of
from groundslab.exchange.reactions.table import ReactionTable, read_table
from groundslab.model.reactions import Reactions
from helpers.reactions import BY_HAND, ETABS, RFEM, write_table, write_workbook

#: What the tables of the helpers state, by support and load case.
STATED = {
    ("A", "G"): ("1812.4", "10", "-20"),
    ("A", "Q"): ("300", "1", "2"),
    ("B", "G"): ("500", "0", "0"),
    ("B", "Q"): ("-50", "0", "0"),
}


def values(table: ReactionTable) -> dict[tuple[str, str], tuple[Decimal, ...]]:
    """Return force and moments by support and load case, but those of combinations."""
    taken = (each for each in table.reactions if each.case not in table.combined)
    return {(each.support, each.case): (each.F_z, each.M_x, each.M_y) for each in taken}


def stated(names: dict[str, str] | None = None) -> dict[tuple[str, str], tuple[Decimal, ...]]:
    """Return what should be read, supports under other names."""
    return {((names or {}).get(s, s), case): tuple(map(Decimal, each)) for (s, case), each in STATED.items()}


@pytest.mark.parametrize("text", [RFEM, BY_HAND], ids=["RFEM", "by hand"])
def test_tables_of_different_layouts_state_the_same(text: str, tmp_path: Path) -> None:
    """Rows by support and case with joined cells and decimal commas, and columns by case, are read alike."""
    table = read_table(write_table(tmp_path, text), Reactions())
    assert values(table) == stated()
    assert (table.force, table.moment) == ("kN", "kNm")


def test_etabs_has_units_below_its_headings_and_unique_names(tmp_path: Path) -> None:
    """Its title is passed over, unique names go before labels, and combinations are told from load cases."""
    table = read_table(write_table(tmp_path, ETABS), Reactions())
    assert values(table) == stated({"A": "101", "B": "102"})
    assert (table.force, table.moment) == ("kN", "kNm")
    assert table.combined == {"ULS1"}
    by_label = read_table(write_table(tmp_path, ETABS), Reactions(headings={"support": "Label"}))
    assert values(by_label) == stated()


def test_node_and_case_may_share_a_column(tmp_path: Path) -> None:
    """Robot writes both in one cell; its sums are passed over and named."""
    text = "Node/Case;FX (kip);FZ (kip);MX (kip-ft)\n 1/        2;0.1;182.5;1.5\nCase 2;DL;;\nSum of val.;0.1;182.5;\n"
    table = read_table(write_table(tmp_path, text), Reactions())
    assert values(table) == {("1", "2"): (Decimal("182.5"), Decimal("1.5"), Decimal(0))}
    assert (table.force, table.moment) == ("kip", "kip ft")
    assert "rows 3, 4" in table.remarks[0]


def test_one_column_a_case_without_moments(tmp_path: Path) -> None:
    """Headings that are no values are load cases; a column of words is none."""
    text = "Column;x [m];y [m];G [kN];Wind left [kN];Remark\nC1;1,5;-2;100,5;20;corner\nC2;1;2;7;;\n"
    table = read_table(write_table(tmp_path, text), Reactions())
    assert {key: each[0] for key, each in values(table).items()} == {
        ("C1", "G"): Decimal("100.5"), ("C1", "Wind left"): Decimal(20),
        ("C2", "G"): Decimal(7), ("C2", "Wind left"): Decimal(0),
    }  # fmt: skip
    assert table.reactions[0].place == (Decimal("1.5"), Decimal(-2))


def test_headings_with_value_and_case(tmp_path: Path) -> None:
    """Value and case may stand in one heading; what is of no use here is passed over."""
    text = 'Column,Fz (G) [kN],Mx (G) [kNm],Mz (G),Fz (Q) [kN]\nC1,"1,234.5",2,3,4\n'
    table = read_table(write_table(tmp_path, text), Reactions())
    assert values(table) == {
        ("C1", "G"): (Decimal("1234.5"), Decimal(2), Decimal(0)),
        ("C1", "Q"): (Decimal(4), Decimal(0), Decimal(0)),
    }


def test_a_table_of_one_case(tmp_path: Path) -> None:
    """It names no case, which must be given; so must a unit that is not stated."""
    path = write_table(tmp_path, "Node,Fz\n1,100\n2,200\n")
    with pytest.raises(InputError) as caught:
        read_table(path, Reactions())
    assert "no unit of forces" in str(caught.value)
    with pytest.raises(InputError) as caught:
        read_table(path, Reactions(force="kN"))
    assert "no load case" in str(caught.value)
    table = read_table(path, Reactions(force="kN", case="G"))
    assert {each.case for each in table.reactions} == {"G"}


@pytest.mark.parametrize(
    ("text", "decimals", "number"),
    [
        ("812.4", "point", "812.4"),
        ("1,812.4", "point", "1812.4"),
        ("1.812,4", "comma", "1812.4"),
        ("1 812,4", "comma", "1812.4"),
        ("−12,5", "comma", "-12.5"),
        ("1'812.40", "point", "1812.40"),
        ("1.5E+03", "point", "1500"),
        ("1,5", "point", None),
        ("12,34,567", "point", None),
        ("=A1*2", "point", None),
        ("", "point", None),
        ("nan", "point", None),
    ],
)  # fmt: skip
def test_numbers_are_read_exactly(text: str, decimals: str, number: str | None) -> None:
    """Digits may be grouped in threes only."""
    expected = None if number is None else Decimal(number)
    assert parse_number(text, decimals) == expected  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("found", "commas", "decimals"),
    [
        (["1.5", "2"], True, "point"),
        (["1,5", "2"], False, "comma"),
        (["1.812,4", "1.5"], False, "comma"),
        (["1,812.4", "1,500"], True, "point"),
        (["812,400", "12,000"], False, "comma"),  # three decimals, as RFEM prints them
        (["812.400"], False, "point"),
        (["1,812"], True, None),  # a quoted cell between commas
        (["1,5", "2.5"], False, None),
        (["1.812", "12,5"], False, "comma"),
        ([1.5, 2.0], False, "point"),
    ],
)  # fmt: skip
def test_decimals_follow_from_the_numbers_or_are_asked_for(
    found: list[str | float], commas: bool, decimals: str | None
) -> None:
    """What could be both is not guessed."""
    assert find_decimals(found, commas) == decimals


def test_open_decimals_are_refused(tmp_path: Path) -> None:
    """The message says what to state; then they are read."""
    path = write_table(tmp_path, 'Node,Case,Fz [kN]\n1,G,"1,812"\n')
    with pytest.raises(InputError) as caught:
        read_table(path, Reactions())
    assert "decimals" in str(caught.value)
    assert read_table(path, Reactions(decimals="comma")).reactions[0].F_z == Decimal("1.812")
    assert read_table(path, Reactions(decimals="point")).reactions[0].F_z == Decimal(1812)


@pytest.mark.parametrize(
    ("text", "unit"),
    [("kN-m", "kNm"), ("kip-ft", "kip ft"), ("lb", "lbf"), ("tonf-m", "tf m"), ("kN·m", "kNm"), ("KN", "kN"),
     ("m", "m"), ("rad", ""), ("furlongs per fortnight", ""), ("", ""), ("-", "")],
)  # fmt: skip
def test_units_in_the_words_of_programs(text: str, unit: str) -> None:
    """They are written as groundslab reads them; what is no unit of these is none."""
    assert unit_of(text) == unit


def test_numbers_are_written_without_exponents() -> None:
    """As people write them, and 0 without a sign."""
    assert [format_number(Decimal(text)) for text in ("1.50E+3", "-0", "0.100", "100")] == ["1500", "0", "0.1", "100"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "no table of reactions"),
        ("a,b\n1,2\n", "no table of reactions"),
        ("Node,Case,Fz [kN]\n", "headings without reactions"),
        ("Node,Case,Fz [kN]\n1,G,many\n2,G,1\n3,G,few\n", '"few"'),
        ("Node,Case,Fz [kN]\n1,G,=A1\n", '"=A1"'),
        ("Node,Case,Fz [kN]\n1,G,\n", "no vertical force"),
        ("No.,Case,pz [kN/m],Mx [kNm]\n1,G,5,6\n", "both per length of line supports, or both resultants"),
        ("Node,Case,Fz [kN],FZ [kN]\n1,G,5,6\n", "two columns with F_z"),
        ("Node,Case,Fz [kN],x [kN]\n1,G,5,6\n", "no unit of lengths"),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_said(text: str, said: str, tmp_path: Path) -> None:
    """Each with its place; all numbers that are none at once."""
    with pytest.raises(InputError) as caught:
        read_table(write_table(tmp_path, text), Reactions())
    assert said in str(caught.value)


ROWS = [
    ["TABLE: Joint Reactions"],
    ["Unique Name", "Output Case", "FZ", "MX"],
    [None, None, "kN", "kN-m"],
    [1, "G", 812.4000000000001, -3],
]


def test_workbooks_are_read(tmp_path: Path) -> None:
    """Numbers come with the digits that are shown; the sheet with reactions is found among others."""
    path = write_workbook(tmp_path / "reactions.xlsx", {"Program Control": [["Version", 22]], "Joint Reactions": ROWS})
    table = read_table(path, Reactions())
    assert values(table) == {("1", "G"): (Decimal("812.4"), Decimal(-3), Decimal(0))}
    assert table.sheet == "Joint Reactions"


def test_of_two_sheets_one_must_be_named(tmp_path: Path) -> None:
    """Both have reactions; an unknown name is refused."""
    path = write_workbook(tmp_path / "reactions.xlsx", {"Base": ROWS, "Roof": [*ROWS[:3], [2, "G", 5, 0]]})
    with pytest.raises(InputError, match="Base"):
        read_table(path, Reactions())
    assert read_table(path, Reactions(sheet="Roof")).reactions[0].support == "2"
    with pytest.raises(InputError, match="Base"):
        read_table(path, Reactions(sheet="Cellar"))


def test_formulas_are_not_computed(tmp_path: Path) -> None:
    """A formula whose value was not saved, and a link to another file, are no numbers."""
    rows = [*ROWS, [2, "G", "=SUM(C4:C4)", 0], [3, "G", "='[other.xlsx]Sheet1'!A1", 0]]
    with pytest.raises(InputError) as caught:
        read_table(write_workbook(tmp_path / "reactions.xlsx", {"Base": rows}), Reactions())
    assert len(caught.value.issues) == 2
    assert "=SUM" in str(caught.value)


def test_large_files_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Rows, bytes, and what a workbook holds once it is unpacked have limits."""
    many = write_table(tmp_path, "Node,Case,Fz [kN]\n" + "1,G,5\n" * cells.MOST_ROWS)
    wide = write_table(tmp_path, "Node,Case,Fz [kN]\n" + "1," * 1000 + "\n", "wide.csv")
    bomb = tmp_path / "bomb.xlsx"
    monkeypatch.setattr(cells, "UNPACKED", 1_000_000)
    with zipfile.ZipFile(bomb, "w", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr("xl/worksheets/sheet1.xml", bytes(1_000_001))
    for path in (many, wide, bomb):
        with pytest.raises(InputError, match="at most"):
            read_table(path, Reactions())
    monkeypatch.setattr(cells, "LARGEST", 1000)
    with pytest.raises(InputError, match="at most"):
        read_table(many, Reactions())


@pytest.mark.slow
def test_a_hundred_thousand_rows_are_read(tmp_path: Path) -> None:
    """As many as are allowed."""
    text = "Node,Case,Fz [kN]\n" + "".join(f"{n // 10},LC{n % 10},{n}.5\n" for n in range(cells.MOST_ROWS - 1))
    table = read_table(write_table(tmp_path, text), Reactions())
    assert len(table.reactions) == cells.MOST_ROWS - 1
    assert sum(each.F_z for each in table.reactions) == Decimal(99_999 * 99_998 // 2) + Decimal(99_999) / 2


def test_other_files_are_refused(tmp_path: Path) -> None:
    """By their ending, if they are not there, and if they are no text."""
    binary = tmp_path / "binary.csv"
    binary.write_bytes(b"\x00\x01\x02\xff" * 100)
    for path in (tmp_path / "reactions.pdf", tmp_path / "missing.csv", tmp_path, binary):
        with pytest.raises(InputError):
            read_table(path, Reactions())


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "cp1252"])
def test_encodings(encoding: str, tmp_path: Path) -> None:
    """Files of Windows programs are read, too."""
    path = tmp_path / "reactions.csv"
    path.write_bytes("Stütze;Lastfall;Fz [kN]\nÄ;G;1,5\n".encode(encoding))
    assert read_table(path, Reactions()).reactions[0].support == "Ä"


def test_rows_beyond_the_stated_extent_count(tmp_path: Path) -> None:
    """Programs state the extent of a sheet wrongly; no row is lost, and a giant extent costs nothing."""
    rows = [["Joint", "Case", "FZ [kN]"], ["A", "G", 1], ["B", "G", 2]]
    whole = write_workbook(tmp_path / "whole.xlsx", {"Reactions": rows})
    for extent in ("A1:C2", "A1", "A1:XFD1048576"):
        path = tmp_path / "other.xlsx"
        with zipfile.ZipFile(whole) as parts, zipfile.ZipFile(path, "w") as others:
            for name in parts.namelist():
                others.writestr(name, parts.read(name).replace(b'ref="A1:C3"', f'ref="{extent}"'.encode()))
        assert path.read_bytes() != whole.read_bytes()
        start = time.monotonic()
        assert [reaction.support for reaction in read_table(path, Reactions()).reactions] == ["A", "B"]
        assert time.monotonic() - start < 5


def test_very_many_cells_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Those of all sheets together."""
    monkeypatch.setattr(cells, "MOST_CELLS", 10)
    rows = [["Joint", "Case", "FZ [kN]"], ["A", "G", 1]]
    path = write_workbook(tmp_path / "many.xlsx", {"Reactions": rows, "More": rows})
    with pytest.raises(InputError, match="more than 10 cells"):
        read_table(path, Reactions())


@pytest.mark.parametrize(
    ("force", "moment", "read"),
    [
        ("kN", "kN-m", ("kN", "kNm")), ("KN", "KN-m", ("kN", "kNm")), ("Tonf", "Tonf-m", ("tf", "tf m")),
        ("TONF", "TONF·M", ("tf", "tf m")), ("tonf", "tonf m", ("tf", "tf m")), ("Kip", "Kip-ft", ("kip", "kip ft")),
        ("KIPS", "kip-FT", ("kip", "kip ft")), ("Kgf", "Kgf-cm", ("kgf", "kgf cm")), ("KGF", "kgf.m", ("kgf", "kgf m")),
        ("Lb", "lb-in", ("lbf", "lbf in")), ("N", "N-mm", ("N", "N mm")), ("MN", "MNm", ("MN", "MNm")),
        ("kn", "KNM", ("kN", "kNm")),
    ],
)  # fmt: skip
def test_units_in_any_case_of_letters(force: str, moment: str, read: tuple[str, str], tmp_path: Path) -> None:
    """In a row below the headings that says of the others that they are text, in brackets, and as they are given."""
    row = f"Joint,OutputCase,F3,M1\nText,Text,{force},{moment}\nA,G,25,3\n"
    in_brackets = f"Joint,OutputCase,F3 ({force}),M1 [{moment}]\nA,G,25,3\n"
    for text in (row, in_brackets):
        table = read_table(write_table(tmp_path, text), Reactions())
        assert (table.force, table.moment, len(table.reactions)) == (*read, 1)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Node,Case,Fz [kN]\n,,kip\nA,G,1\n", r'"Fz \[kN\]" in kN and below it kip'),
        ("Node,Case,x [m],x [m],y [m],Fz [kN]\nA,G,1,2,0,5\n", r"two columns with x: x \[m\] and x \[m\]"),
        ("Node,Case,Fx,Fx,Fz\n,,kN,kN,kN\nA,G,1,2,5\n", "two columns with F_x"),
        ("Node,Case,Fz,Fz\n,,kN,kN\nA,G,1,2\n", "two columns with F_z"),
        ("Node,Case,Fz [kN]\nA,G,5 kip\n", '"5 kip", expected a number'),
    ],
)
def test_what_headings_say_twice_is_refused(text: str, said: str, tmp_path: Path) -> None:
    """A unit in the heading and another one below it, two columns of one heading."""
    with pytest.raises(InputError, match=said):
        read_table(write_table(tmp_path, text), Reactions())


@pytest.mark.parametrize("seed", range(40))
def test_headings_and_units_spelled_in_other_ways(seed: int, tmp_path: Path) -> None:
    """Capitals, spaces, signs, brackets and plurals: always A with 25 kN and 3 kNm in G."""
    chance = random.Random(seed)
    words = {
        "support": ("joint", "support", "column", "unique name", "node"), "case": ("output case", "load case", "LC"),
        "F": ("Fz", "F3", "Global FZ", "Pz"), "M": ("Mx", "M1", "Global MX"),
    }  # fmt: skip
    names = {key: chance.choice(spellings) for key, spellings in words.items()}
    for key in ("support", "case"):
        names[key] += chance.choice(("", "s"))
    for key, name in names.items():
        spaced = name.replace(" ", chance.choice((" ", "", "_", "-")))
        names[key] = chance.choice((str.upper, str.lower, str.title, str))(spaced)
    force = chance.choice(("kN", "KN", "kn", "Kn"))
    moment = force + chance.choice(("m", "-m", " m", "·m", "-M", " M", "*m"))
    pad, (left, right) = chance.choice(("", " ")), chance.choice(("[]", "()", "{}"))
    below = ""
    if chance.random() < 0.5:
        names["F"] += f"{pad}{left}{force}{right}"
        names["M"] += f" {left}{moment}{right}"
    else:
        none = chance.choice(("", "Text", "text", "-", "Unitless"))
        below = f"{none};{none};{left}{force}{right};{moment}\n"
    table = read_table(write_table(tmp_path, f"{';'.join(names.values())}\n{below}A;G;25;3\n"), Reactions())
    (one,) = table.reactions
    assert (one.support, one.case, one.F_z, one.M_x) == ("A", "G", 25, 3)
    assert units.parse(f"1 {table.force}", "force") == 1e3
    assert units.parse(f"1 {table.moment}", "moment") == 1e3


def test_columns_of_one_heading_that_agree_are_one(tmp_path: Path) -> None:
    """As a table of places that was joined to one of forces."""
    text = "Node,Case,x [m],x [m],y [m],Fz [kN]\nA,G,1,1,0,5\n"
    assert read_table(write_table(tmp_path, text), Reactions()).reactions[0].place == (1, 0)
