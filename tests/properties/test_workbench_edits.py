"""Edits of a case file change what they are to change and nothing else, whatever the file looks like."""

from __future__ import annotations

import copy
import re
import tomllib
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.case import casefile
from groundslab.schema import toml_writer
from groundslab.workbench.editing.document import Document
from groundslab.workbench.editing.undo import History
from helpers.examples import examples
from helpers.paths import ROOT

pytestmark = pytest.mark.slow

EXAMPLES = {"starter": casefile.starter(), "raft": (ROOT / "examples" / "l_raft.toml").read_text(encoding="utf-8")}
KEYS = st.sampled_from(["a", "b", "c", "d e", "x-y", "", "ä", 'q"q'])
WORDS = st.sampled_from(["", "m", "30 MPa", "# no comment", 'a "quote"', "two\nlines", "[x]", "a = 1, b", "\\", "ß\t"])
SCALARS = WORDS | st.integers(-5, 5) | st.floats(-2, 2, width=16) | st.booleans()
BLANKS = st.sampled_from(["", "\n", "# comment\n", "\n# apart\n\n", "# [not.a.header]\n", "  # k = 1\n"])
TAILS = st.sampled_from(["", "  # why", " #", "\t# a = [1, 2]"])


def tables(inner: st.SearchStrategy[Any]) -> st.SearchStrategy[dict[str, Any]]:
    """Return tables of such values."""
    return st.dictionaries(KEYS, inner, min_size=1, max_size=4)


LISTS = st.lists(SCALARS, max_size=4) | st.lists(st.lists(WORDS, min_size=2, max_size=2), min_size=1, max_size=3)
FLAT = tables(SCALARS | LISTS)
DATA = tables(
    SCALARS
    | LISTS
    | FLAT
    | st.lists(FLAT, min_size=1, max_size=3)
    | tables(FLAT | st.lists(FLAT, min_size=1, max_size=2))
)


@st.composite
def layouts(draw: st.DrawFn) -> str:
    """Return a TOML text in a style of its own: tables inline, dotted or with headers, lists broken, comments."""
    lines: list[str] = [draw(BLANKS)]

    def value(what: Any) -> str:
        if isinstance(what, dict):
            pad = draw(st.sampled_from(["", " "]))
            return "{" + pad + ", ".join(f"{toml_writer.key(k)} = {value(v)}" for k, v in what.items()) + pad + "}"
        if isinstance(what, list):
            style = draw(st.sampled_from(["flat", "wide", "broken", "noted"]))
            items = [value(each) for each in what]
            if style == "flat" or not items:
                return f"[{', '.join(items)}]"
            if style == "wide":
                return f"[ {' , '.join(items)} ]"
            comma = draw(st.sampled_from(["", ","]))
            if style == "broken":
                return "[\n  " + ",\n  ".join(items) + comma + "\n]"
            return "[  # noted\n    " + ",  # one\n    ".join(items) + comma + "  # last\n  ]"
        if isinstance(what, str) and "'" not in what and "\n" not in what and draw(st.booleans()):
            return f"'{what}'"
        return toml_writer.value(what)

    def pairs(table: dict[str, Any], path: tuple[str, ...], prefix: str, deferred: list[Any]) -> None:
        for name, each in table.items():
            key = prefix + toml_writer.key(name)
            style = draw(st.sampled_from(["inline", "header", "header", "dotted"]))
            tabled = isinstance(each, dict) or toml_writer.is_list_of_tables(each)
            if tabled and style == "header" and not prefix:
                deferred.append(((*path, name), each))
            elif isinstance(each, dict) and style == "dotted":
                pairs(each, (*path, name), f"{key}.", deferred)
            else:
                lines.append(draw(st.sampled_from(["", "  "])) + f"{key} = {value(each)}{draw(TAILS)}\n{draw(BLANKS)}")

    def sections(deferred: list[Any]) -> None:
        for path, each in deferred:
            name = ".".join(map(toml_writer.key, path))
            for table in each if isinstance(each, list) else [each]:
                header = f"[[{name}]]" if isinstance(each, list) else f"[{name}]"
                inner: list[Any] = []
                lines.append(f"{header}{draw(TAILS)}\n{draw(BLANKS)}")
                pairs(table, path, "", inner)
                sections(inner)

    top: list[Any] = []
    pairs(draw(DATA), (), "", top)
    sections(top)
    text = "".join(lines)
    return text if draw(st.booleans()) else text.rstrip("\n")


def paths(data: Any, path: tuple[str | int, ...] = ()) -> list[tuple[str | int, ...]]:
    """Return the paths of all that is in the data."""
    found = [path] if path else []
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for step, each in items:
        found += paths(each, (*path, step))
    return found


def at(data: Any, path: tuple[str | int, ...]) -> Any:
    """Return what stands at a path."""
    for step in path:
        data = data[step]
    return data


@st.composite
def edits(draw: st.DrawFn, data: dict[str, Any]) -> dict[str, Any]:
    """Return an edit of data: set, a new key, add, remove."""
    path = draw(st.sampled_from(paths(data)))
    there = at(data, path)
    choices = ["set", "remove"]
    choices += ["new"] if isinstance(there, dict) else []
    choices += ["add", "add", "add"] if isinstance(there, list) else []
    op = draw(st.sampled_from(choices))
    if op == "new":
        return {"op": "set", "path": [*path, draw(KEYS)], "value": draw(SCALARS | LISTS | FLAT)}
    if op == "add":
        value = draw(FLAT | SCALARS)
        return {"op": "add", "path": list(path), "value": value, "at": draw(st.integers(0, len(there)))}
    if op == "set":
        return {"op": "set", "path": list(path), "value": draw(DATA | SCALARS | LISTS)}
    return {"op": "remove", "path": list(path)}


def naively(data: dict[str, Any], edit: dict[str, Any]) -> dict[str, Any]:
    """Return the data after an edit, by plain assignment."""
    data = copy.deepcopy(data)
    *above, step = edit["path"]
    around = at(data, tuple(above))
    if edit["op"] == "set":
        around[step] = edit["value"]
    elif edit["op"] == "add":
        around[step].insert(edit["at"], edit["value"])
    else:
        del around[step]
    return data


def full(value: Any) -> Any:
    """Return data without empty tables and lists, which leave nothing in a file of headers."""
    if isinstance(value, dict):
        return {
            name: each for name, each in ((name, full(each)) for name, each in value.items()) if each not in ({}, [])
        }
    return [full(each) for each in value] if isinstance(value, list) else value


def comments(text: str) -> list[str]:
    """Return the comments of a text, those within texts in quotes left out."""
    plain = re.sub(r'"(?:[^"\\\n]|\\.)*"|\'[^\'\n]*\'', "", text)
    return sorted(re.findall(r"#[^\n]*", plain))


@settings(deadline=None, derandomize=True, max_examples=examples(60))
@given(data=st.data())
def test_an_edit_changes_what_it_says_and_undo_brings_every_byte_back(data: st.DataObject) -> None:
    """Random texts, random edits one after the other: data as by plain assignment; undone, the very same text."""
    document = Document(data.draw(layouts(), label="text"))
    assert document.layout is not None
    original, history = document.text, History()
    for _ in range(data.draw(st.integers(1, 4))):
        assert document.data is not None
        if not document.data:
            break
        edit = data.draw(edits(document.data), label="edit")
        after = document.apply([edit])
        assert full(after.data) == full(naively(document.data, edit))
        if edit["op"] == "add" or (edit["op"] == "set" and isinstance(edit["value"], str | int | float)):
            old = at(document.data, tuple(edit["path"])) if tuple(edit["path"]) in paths(document.data) else ""
            # what is no table turns a list with headers into one within brackets
            fits = toml_writer.is_list_of_tables(old) == isinstance(edit["value"], dict)
            if (edit["op"] == "add" and old and fits) or isinstance(old, str | int | float):
                assert comments(after.text) == comments(document.text)
        history.record(document.text, "edit")
        document = after
    text: str | None = document.text
    while history.done:
        assert text is not None
        text = history.undo(text)
    assert text == original


@pytest.mark.parametrize("name", EXAMPLES)
@settings(deadline=None, derandomize=True, max_examples=examples(10))
@given(data=st.data())
def test_comments_of_the_examples_survive(name: str, data: st.DataObject) -> None:
    """Values set, things added and moved at random: not a comment is lost, and undoing all gives the same bytes."""
    original = EXAMPLES[name]
    document, history = Document(original), History()
    for _ in range(data.draw(st.integers(1, 6))):
        assert document.data is not None
        known = document.data
        leaves = [path for path in paths(known) if isinstance(at(known, path), str | int | float)]
        lists = [path for path in paths(known) if toml_writer.is_list_of_tables(at(known, path))]
        lengths = [path for path in leaves if re.fullmatch(r"-?[\d.]+ m", str(at(known, path)))]
        op = data.draw(st.sampled_from(["set", "length", "add", "move", "new"]))
        edit: dict[str, Any] = {"op": op}
        if op == "set":
            edit |= {"path": data.draw(st.sampled_from(leaves)), "value": data.draw(SCALARS)}
        elif op == "length":
            edit |= {"path": data.draw(st.sampled_from(lengths)), "value": data.draw(st.floats(-50, 50))}
        elif op == "add":
            path = data.draw(st.sampled_from([*lists, ("columns",), ("output", "points"), ("contact", "voids")]))
            edit |= {"path": path, "value": {"name": "new", "x": "1 m", "y": "2 m"}}
        elif op == "move":
            path = data.draw(st.sampled_from([path[:-1] for path in lengths if path[-1] in ("x", "y")] or [()]))
            if not path:
                continue
            edit |= {"path": path, "by": [data.draw(st.floats(-5, 5)), 0.5]}
        else:
            edit = {"op": "set", "path": data.draw(st.sampled_from([("mesh", "size"), ("plate", "edges", "left")]))}
            edit["value"] = "w"
        after = document.apply([{**edit, "path": list(edit["path"])}])
        assert comments(after.text) == comments(original)
        tomllib.loads(after.text)
        history.record(document.text, "edit")
        document = after
    text = document.text
    while history.done:
        before = history.undo(text)
        assert before is not None
        text = before
    assert text.encode() == original.encode()
    while history.undone:
        again = history.redo(text)
        assert again is not None
        text = again
    assert text == document.text
