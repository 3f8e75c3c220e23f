"""Edits of a case file: layout kept, lengths in their units, items moved, issues with paths."""

from __future__ import annotations

import difflib
import tomllib
from typing import Any

import pytest

from groundslab.case import casefile
from groundslab.case.editing import lengths
from groundslab.case.editing.toml_positions import read_statements
from groundslab.errors import InputError, Issue
from groundslab.workbench.editing import diagnostics
from groundslab.workbench.editing.document import Document
from groundslab.workbench.editing.undo import MAX_LENGTH, MAX_STEPS, History
from helpers.paths import EXAMPLES

RAFT = (EXAMPLES / "l_raft.toml").read_text(encoding="utf-8")


def edited(text: str, op: str, path: list[str | int], value: Any = None, **more: Any) -> str:
    """Return a text after one edit."""
    given = {} if value is None else {"value": value}
    return Document(text).apply([{"op": op, "path": path, **given, **more}]).text


def changes(before: str, after: str) -> list[str]:
    """Return the lines taken away and added, marked - and +."""
    lines = list(difflib.unified_diff(before.splitlines(), after.splitlines(), n=0, lineterm=""))
    return [line for line in lines[2:] if not line.startswith("@@")]


STRANGE = '''\
title = """two
lines # no comment
[x]"""   # a comment
path = 'C:\\x'  # literal
more = \'\'\'it's "so" = 1\'\'\'\'
when = 1979-05-27 07:32:00  # a date
"quoted key".'dotted'.plain = [1, 2,  # one and two
  3]
big = {a = [{b = 1}, {b = 2}], "c d" = 'x, }'}

[[ list ]]   # spaces in the header
k = +1_000

[ list . "in ner" ]
k = inf
[[list]]
[list.inner.deep]
k = nan
[[list.more]]
k = 0x_1
[[list.more]]
'''.replace("0x_1", "0x1").replace("''''", "'''")


def test_every_statement_is_found_with_its_path_and_value() -> None:
    """The places of all values, cut out and read by tomllib, give the data that tomllib reads from the whole."""
    data = tomllib.loads(STRANGE)
    found = [each for each in read_statements(STRANGE) if each.value is not None]
    assert len(found) == 10
    for each in found:
        assert each.value is not None
        value: Any = data
        for step in each.path:
            value = value[step]
        assert repr(tomllib.loads(f"k = {STRANGE[each.value.start : each.value.end]}")["k"]) == repr(value)
    headers = [each.path for each in read_statements(STRANGE) if each.value is None]
    assert headers == [
        ("list", 0), ("list", 0, "in ner"), ("list", 1), ("list", 1, "inner", "deep"),
        ("list", 1, "more", 0), ("list", 1, "more", 1),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("path", "value", "lines"),
    [
        (["title"], 1, ['-title = """two', "-lines # no comment", '-[x]"""   # a comment', "+title = 1   # a comment"]),
        (["when"], 1, ["-when = 1979-05-27 07:32:00  # a date", "+when = 1  # a date"]),
        (["quoted key", "dotted", "plain", 2], 4, ["-  3]", "+  4]"]),
        (["list", 0, "k"], 2.5, ["-k = +1_000", "+k = 2.5"]),
        (["list", 1, "more", 1, "a"], True, ["+a = true"]),
        (["list", 0, "in ner", "a.b"], 'q"\\', ['+"a.b" = "q\\"\\\\"']),
        (["quoted key", "dotted", "new"], [1], ['+"quoted key".dotted.new = [1]']),
        (["big", "a", 1, "b"], {"x": 1}, None),
    ],
)
def test_only_what_is_set_changes(path: list[str | int], value: Any, lines: list[str] | None) -> None:
    """A value is replaced or added where it belongs in strange TOML; the comment behind it and all else stay."""
    found = changes(STRANGE, edited(STRANGE, "set", path, value))
    if lines is None:
        assert len(found) == 2
    else:
        assert found == lines


def test_layout_of_lists_is_kept() -> None:
    """Items added, changed and removed keep the list's broken lines and the comments of the others."""
    text = "p = [\n  [1, 2],  # a\n  # about b\n  [3, 4],  # b\n]  # end\n"
    assert edited(text, "add", ["p"], [5, 6]) == (
        "p = [\n  [1, 2],  # a\n  # about b\n  [3, 4],  # b\n  [5, 6],\n]  # end\n"
    )
    assert edited(text, "add", ["p"], [5, 6], at=1) == (
        "p = [\n  [1, 2],  # a\n  [5, 6],\n  # about b\n  [3, 4],  # b\n]  # end\n"
    )
    assert edited(text, "remove", ["p", 0]) == "p = [\n  # about b\n  [3, 4],  # b\n]  # end\n"
    assert edited(text, "remove", ["p", 1]) == "p = [\n  [1, 2],  # a\n]  # end\n"
    assert edited(text, "set", ["p", 1, 0], 9) == text.replace("3", "9")
    assert edited("p = [1, 2] # x", "add", ["p"], 3) == "p = [1, 2, 3] # x"
    assert edited("p = [] # x", "add", ["p"], 3) == "p = [3] # x"


def test_tables_are_added_where_they_belong() -> None:
    """A further column follows the last one, a first one what comes before columns; the order of the file is kept."""
    column = {"name": "Z", "x": "1 m"}
    block = ["+[[columns]]", '+name = "Z"', '+x = "1 m"', "+"]
    text = edited(RAFT, "add", ["columns"], column)
    assert changes(RAFT, text) == block
    assert text.index('name = "Z"') == text.index("[[cases]]") - len('name = "Z"\nx = "1 m"\n\n')
    text = edited(casefile.starter(), "add", ["columns"], column)
    assert sorted(changes(casefile.starter(), text)) == sorted(block)
    assert text.index("[contact]") < text.index('name = "Z"') < text.index("# Columns on the plate")
    nested = edited(RAFT, "add", ["plate", "openings"], {"kind": "circle", "radius": "1 m"})
    assert nested.index("radius") < nested.index("[[plate.zones]]")
    first = edited(RAFT, "add", ["plate", "openings"], {"kind": "circle", "radius": "1 m"}, at=0)
    assert tomllib.loads(first)["plate"]["openings"][0]["kind"] == "circle"
    # after a last line that is not ended
    assert edited('[plate]\nE = "1 MPa"', "add", ["loads"], {"kind": "uniform"}) == (
        '[plate]\nE = "1 MPa"\n\n[[loads]]\nkind = "uniform"\n'
    )


def test_a_table_of_a_list_becomes_no_table() -> None:
    """A list with headers is one within brackets then; it is for the model to say what is wrong with that."""
    text = '[[loads]]\nkind = "uniform"\n\n[[loads]]\nkind = "point"\n\n[ground]\nk = 1\n'
    after = edited(text, "set", ["loads", 1], ["a", 2])
    assert tomllib.loads(after) == {"loads": [{"kind": "uniform"}, ["a", 2]], "ground": {"k": 1}}


def test_tables_on_the_way_are_made() -> None:
    """Setting a key of a section that is not there makes the section; a short table in a table stands on one line."""
    text = edited(casefile.starter(), "set", ["mesh", "size"], "0.2 m")
    assert [line for line in changes(casefile.starter(), text) if line != "+"] == ["+[mesh]", '+size = "0.2 m"']
    text = edited(casefile.starter(), "set", ["plate", "edges", "left"], "hinged")
    assert changes(casefile.starter(), text) == ['+edges = {left = "hinged"}']
    text = edited(text, "set", ["plate", "edges", "top"], "soft")
    assert changes(casefile.starter(), text) == ['+edges = {left = "hinged", top = "soft"}']
    voids = edited(RAFT, "add", ["contact", "voids"], {"depth": "5 mm"})
    assert [line for line in changes(RAFT, voids) if line != "+"] == ["+[[contact.voids]]", '+depth = "5 mm"']


def test_what_is_removed_takes_its_own_comments_only() -> None:
    """A removed load takes the comments within it; the heading of the list and what follows stay."""
    machine = """
[[loads]]
kind = "patch"                 # on a rectangle
# case = "imposed"
q = "200 kPa"
x = ["1 m", "2.5 m"]
y = ["-0.5 m", "1 m"]
"""
    given = casefile.starter() + machine
    text = edited(given, "remove", ["loads", 1])
    lost = changes(given, text)
    assert all(line.startswith("-") for line in lost)
    noted = [line for line in lost if "#" in line]
    assert noted == ['-kind = "patch"                 # on a rectangle', '-# case = "imposed"']
    text = edited(RAFT, "remove", ["loads", 0])
    assert "# The loads, case by case.\n[[loads]]" in text
    text = edited(RAFT, "remove", ["output", "strips", 0])
    assert "# The loads, case by case." in text
    assert "strips" not in tomllib.loads(text)["output"]
    assert edited("a = 1\nb = 2 # x\nc = 3\n", "remove", ["b"]) == "a = 1\nc = 3\n"
    assert edited("[a]\nb = {c = 1, d = 2}\n", "remove", ["a", "b", "c"]) == "[a]\nb = {d = 2}\n"
    wind = "[[l]]\na = 1\n\n# wind\n[[l]]\na = 2\n\n[m]\n"
    assert edited(wind, "remove", ["l", 1]) == "[[l]]\na = 1\n\n[m]\n"
    # nothing there: nothing happens
    assert edited(RAFT, "remove", ["mesh", "counts"]) == RAFT
    assert edited(RAFT, "remove", ["loads", 99]) == RAFT


def test_ground_of_another_kind() -> None:
    """A table that is replaced keeps its header and comments; lists of tables within it go."""
    text = edited(casefile.starter(), "set", ["ground"], {"kind": "winkler", "k": "20 MPa/m"})
    assert tomllib.loads(text)["ground"] == {"kind": "winkler", "k": "20 MPa/m"}
    assert "# The ground under the plate." in text
    assert '# gamma = "iterate"' in text
    assert "# Other kinds of ground" in text
    back = edited(text, "set", ["ground"], tomllib.loads(casefile.starter())["ground"])
    assert casefile.loads(back) == casefile.loads(casefile.starter())


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("300 mm", 0.25, "250 mm"),
        ("300mm", 0.2504, "250mm"),
        ("0.3 m", 1.23456, "1.235 m"),
        ("12 in", 0.3302, "13 in"),
        ("1 ft", 0.6096, "2 ft"),
        ("-2.50 m", -2.5, "-2.50 m"),
        ("1 m", -0.0001, "0 m"),
        (None, 1.5, "1.5 m"),
        ("nonsense", 1.5, "1.5 m"),
        (["300 mm", "1 m"], [0.3, 2.0], ["300 mm", "2 m"]),
        ([["300 mm", "1 m"]], [[0.3, 1.0], [0.4, 2.0]], [["300 mm", "1 m"], ["400 mm", "2000 mm"]]),
    ],
)
def test_lengths_keep_their_units(old: Any, new: Any, expected: Any) -> None:
    """Meters are written in the unit of the old text, to the millimeter; what did not move keeps its digits."""
    assert lengths.format_lengths(old, new, 1e-3) == expected


def test_steps_suit_the_plate() -> None:
    """A drag has a resolution of millimeters on a raft, less on a small plate."""
    assert lengths.choose_resolution(tomllib.loads(RAFT)) == 1e-3
    assert lengths.choose_resolution({"plate": {"length_x": "50 cm", "length_y": "40 cm"}}) == pytest.approx(1e-4)
    assert lengths.choose_resolution({"plate": 1}) == 1e-3


def test_lengths_in_the_file() -> None:
    """Through the document: outline dragged at one corner, a zone's side; one line changes."""
    points = [[0, 0], [30, 0], [30.5, 10.2], [12, 10], [12, 20], [0, 20]]
    found = changes(RAFT, edited(RAFT, "length", ["plate", "outline", "points"], points))
    assert len(found) == 2
    assert '["30 m", "0 m"], ["30.5 m", "10.2 m"], ["12 m", "10 m"]' in found[1]
    found = changes(RAFT, edited(RAFT, "length", ["reinforcement", "top", 1], 0.07))
    assert found == ['-top = ["50 mm", "66 mm"]', '+top = ["50 mm", "70 mm"]']


@pytest.mark.parametrize(
    ("thing", "expected"),
    [
        ({"x": "1 m", "y": "200 cm"}, {"x": "1.5 m", "y": "175 cm"}),
        ({"x": ["1 m", "2.0 m"], "y": ["0 m", "1 m"]}, {"x": ["1.5 m", "2.5 m"], "y": ["-0.25 m", "0.75 m"]}),
        ({"points": [["0 m", "0 m"], ["1 m", "1 m"]]}, {"points": [["0.5 m", "-0.25 m"], ["1.5 m", "0.75 m"]]}),
        ({"start": ["0 m", "0 m"], "end": ["1 m", "1 m"], "width": "1 m"},
         {"start": ["0.5 m", "-0.25 m"], "end": ["1.5 m", "0.75 m"], "width": "1 m"}),
        ({"shape": {"kind": "circle", "radius": "900 mm"}, "thickness": "1 m"},
         {"shape": {"kind": "circle", "radius": "900 mm", "centre": ["500 mm", "-250 mm"]}, "thickness": "1 m"}),
        ({"kind": "patch", "x": ["1 m", "2 m"], "y": ["1 m", "2 m"], "slope": ["1 kPa/m", "0 kPa/m"]},
         {"kind": "patch", "x": ["1.5 m", "2.5 m"], "y": ["0.75 m", "1.75 m"], "slope": ["1 kPa/m", "0 kPa/m"],
          "about": ["0.5 m", "-0.25 m"]}),
        ({"shape": {"kind": "circle", "radius": "1 m", "centre": ["0 m", "0 m"]}, "holes": [{"x": ["0 m", "1 m"]}]},
         {"shape": {"kind": "circle", "radius": "1 m", "centre": ["0.5 m", "-0.25 m"]},
          "holes": [{"x": ["0.5 m", "1.5 m"]}]}),
        ({"shape": {"kind": "polygon", "points": [["0 m", "0.333333 m"]], "bulges": [0.5]}},
         {"shape": {"kind": "polygon", "points": [["0.5 m", "0.083333 m"]], "bulges": [0.5]}}),
    ],
)  # fmt: skip
def test_things_move_as_a_whole(thing: dict[str, Any], expected: dict[str, Any]) -> None:
    """All coordinates of a thing move by the same way and keep unit and digits; sizes stay."""
    assert lengths.translate(thing, (0.5, -0.25), 1e-3, "loads[1]") == expected
    back = lengths.translate(expected, (-0.5, 0.25), 1e-3, "loads[1]")
    assert all(back[name] == value or name == "x" for name, value in thing.items() if name != "shape")


def test_what_cannot_be_moved_says_why() -> None:
    """A load on a column, a load everywhere, a coordinate that is not a length: refused, and nothing changes."""
    for thing in ({"column": "A1", "P": "1 kN"}, {"kind": "uniform", "q": "1 kPa"}, {"x": "1 kN", "y": "1 m"}):
        with pytest.raises(InputError):
            lengths.translate(thing, (1.0, 0.0), 1e-3, "loads[1]")
    with pytest.raises(InputError, match='move the column "A1"'):
        edited(RAFT, "move", ["loads", 4], by=[1, 1])


@pytest.mark.parametrize(
    "edit",
    [
        {"op": "jump", "path": []},
        {"op": "set", "path": "plate", "value": 1},
        {"op": "set", "path": ["columns", -1], "value": 1},
        {"op": "set", "path": ["columns", True], "value": 1},
        {"op": "set", "path": ["columns", 12], "value": {}},
        {"op": "set", "path": ["title", "x"], "value": 1},
        {"op": "set", "path": ["plate"]},
        {"op": "set", "path": [], "value": 1},
        {"op": "set", "path": ["title"], "value": "\ud800"},
        {"op": "length", "path": ["plate", "thickness"], "value": "1 m"},
        {"op": "length", "path": ["plate", "thickness"], "value": float("nan")},
        {"op": "length", "path": ["plate", "thickness"], "value": [1.0, 1e308]},
        {"op": "length", "path": ["plate", "thickness"], "value": 10**400},
        {"op": "add", "path": ["plate"], "value": {}},
        {"op": "add", "path": ["columns"], "value": {}, "at": 13},
        {"op": "add", "path": ["mesh", "size", "x"], "value": 1},
        {"op": "move", "path": ["columns", 0], "by": [1]},
        {"op": "move", "path": ["columns", 0], "by": [1, float("inf")]},
        {"op": "move", "path": ["columns", 0], "by": [float("nan"), 1]},
        {"op": "move", "path": ["columns", 0], "by": [10**400, 1]},
        {"op": "move", "path": ["columns", 99], "by": [1, 1]},
        {"op": "text", "value": 1},
        {"op": "text", "value": "\udc80"},
    ],
)
def test_wrong_edits_are_refused(edit: dict[str, Any]) -> None:
    """Invalid edits are refused, whatever the page sends."""
    with pytest.raises(InputError):
        Document(RAFT).apply([edit])


def test_endless_nesting_is_refused() -> None:
    """A value nested too deeply for anything is refused, as is a text of that kind."""
    value: Any = []
    for _ in range(5000):
        value = [value]
    with pytest.raises(InputError, match="nested too deeply"):
        Document(RAFT).apply([{"op": "set", "path": ["x"], "value": value}])
    document = Document("a = " + "[" * 5000 + "]" * 5000)
    assert (document.data, document.layout) == (None, None)


@pytest.mark.slow
def test_all_edits_or_none() -> None:
    """A list of edits of which the last is wrong gives no document at all."""
    document = Document(RAFT)
    with pytest.raises(InputError):
        document.apply([{"op": "set", "path": ["title"], "value": "x"}, {"op": "jump"}])
    assert document.text == RAFT


def test_text_that_is_not_toml_can_only_be_edited_as_text() -> None:
    """Broken text is kept as it is and says so; a text edit corrects it."""
    broken = Document(RAFT).apply([{"op": "text", "value": RAFT + "\nx = = 1"}])
    assert broken.data is None
    assert broken.layout is None
    with pytest.raises(InputError, match="not TOML"):
        broken.apply([{"op": "set", "path": ["title"], "value": "x"}])
    assert broken.apply([{"op": "text", "value": RAFT}]).text == RAFT


@pytest.mark.parametrize("content", [b"\xef\xbb\xbf# x\r\na = 1\r\n", b"a = 1\r\nb = 2\nc = 3", b"", b"\n# only\n"])
def test_bytes_come_back(content: bytes) -> None:
    """Line ends of Windows, mixed ones, a mark at the start: a file that is read and written has the same bytes."""
    document = Document.from_bytes(content, "x")
    assert document.to_bytes() == content
    if document.newline == "\r\n":
        added = document.apply([{"op": "set", "path": ["b"], "value": 2}])
        assert added.to_bytes() == content + b"b = 2\r\n"


def test_files_that_are_no_text() -> None:
    """Bytes that are not UTF-8, and files that are too large, are refused."""
    with pytest.raises(InputError, match="line 2"):
        Document.from_bytes(b"a = 1\nb = \xff", "x")
    with pytest.raises(InputError, match="larger"):
        Document.from_bytes(b" " * (casefile.LARGEST + 1), "x")


@pytest.mark.parametrize(
    ("location", "path"),
    [
        ("loads[2].x", ("loads", 1, "x")),
        ("plate.outline.points[3][1]", ("plate", "outline", "points", 2, 0)),
        ('combinations[1].factors."own weight"', ("combinations", 0, "factors", "own weight")),
        ('"a\\"b".c', ('a"b', "c")),
        ("the description", ()),
        ("the text, line 3, column 5", ()),
    ],
)
def test_paths_of_issues(location: str, path: tuple[str | int, ...]) -> None:
    """The location of an issue becomes the path of keys and indices from 0, and back."""
    assert diagnostics.parse_path(location) == path
    if path:
        assert diagnostics.format_path(path) == location


def test_every_issue_of_a_wrong_case_leads_to_its_line() -> None:
    """Issues of a raft with wrong values name paths that are there, and the lines in which they stand."""
    text = RAFT
    for path, value in [(["columns", 3, "x"], "1 kN"), (["plate", "openings", 0, "x"], "no"), (["loads", 7, "P"], 3)]:
        text = edited(text, "set", path, value)
    document = Document(text)
    with pytest.raises(InputError) as caught:
        casefile.loads(text, diagnostics.NAME)
    data = diagnostics.text_issues_to_json(caught.value.issues, document.layout, True)
    lines = text.splitlines()
    found = {tuple(each["path"]): lines[each["line"] - 1] for each in data}
    assert found[("columns", 3, "x")] == 'x = "1 kN"'
    assert found[("plate", "openings", 0, "x")] == 'x = "no"'
    assert found[("loads", 7, "P")] == "P = 3"


def test_broken_toml_names_line_and_column() -> None:
    """A syntax error has no path, but a position in the text."""
    with pytest.raises(InputError) as caught:
        casefile.loads("a = 1\nb = = 2\n", diagnostics.NAME)
    (data,) = diagnostics.text_issues_to_json(caught.value.issues, None, False)
    assert (data["path"], data["line"], data["column"]) == ([], 2, 5)
    (data,) = diagnostics.text_issues_to_json([Issue("the text", "lists nested too deeply", "TOML")], None, False)
    assert data["line"] == 1


def test_history_merges_what_belongs_together() -> None:
    """Typing on in a field is one step; an undo, a save or another label ends it; a change drops what was undone."""
    history = History()
    history.record("0", "thickness")
    history.record("1", "thickness", merges=True)
    history.record("2", "title", merges=True)
    history.close_step()
    history.record("3", "title", merges=True)
    assert history.undo("4") == "3"
    assert (history.undo_label, history.redo_label) == ("title", "title")
    assert history.undo("3") == "2"
    assert history.redo("2") == "3"
    history.record("3", "title", merges=True)
    assert not history.undone
    assert [history.undo("x") for _ in range(4)] == ["3", "2", "0", None]
    assert history.redo("0") == "x"


def test_history_is_bounded() -> None:
    """Neither many steps nor long texts fill the memory; the latest ones are kept."""
    history = History()
    for number in range(MAX_STEPS + 10):
        history.record(str(number), "edit")
    undone = 0
    while history.undo("x") is not None:
        undone += 1
    assert undone == MAX_STEPS
    history = History()
    for number in range(5):
        history.record(str(number) * (MAX_LENGTH // 3), "edit")
    assert history.undo("") == "4" * (MAX_LENGTH // 3)
    history.undo("")
    history.undo("")
    assert not history.done


CASES = """\
# the cases
[[cases]]
name = "G"  # dead

# what comes and goes
[[cases]]
name = "Q"
action = "variable"

[[cases]]
name = "W"

[[loads]]
kind = "uniform"
"""


@pytest.mark.parametrize(("n", "to"), [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1), (1, 1)])
def test_items_change_places_with_their_comments(n: int, to: int) -> None:
    """An item goes to another position in a list of tables, and in one in brackets; back it is the list of before."""
    names = ["G", "Q", "W"]
    names.insert(to, names.pop(n))
    for text in (CASES, 'cases = [{ name = "G" }, { name = "Q" }, { name = "W" }]\n'):
        document = Document(text)
        moved = document.apply([{"op": "reorder", "path": ["cases", n], "value": to}])
        assert moved.data is not None
        assert [case["name"] for case in moved.data["cases"]] == names
        assert moved.apply([{"op": "reorder", "path": ["cases", to], "value": n}]).data == document.data
    moved = Document(CASES).apply([{"op": "reorder", "path": ["cases", n], "value": to}])
    assert '# what comes and goes\n[[cases]]\nname = "Q"' in moved.text
    assert 'name = "G"  # dead' in moved.text


@pytest.mark.parametrize(
    ("path", "value"), [(["cases", 0], 3), (["cases", 3], 0), (["cases"], 0), (["cases", 0], "1"), ([], 0)]
)
def test_items_go_to_no_other_places(path: list[str | int], value: object) -> None:
    """Only items of lists are moved, to positions that there are."""
    with pytest.raises(InputError):
        Document(CASES).apply([{"op": "reorder", "path": path, "value": value}])
