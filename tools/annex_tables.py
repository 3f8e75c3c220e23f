"""Writes the national parameters as tables: what EN 1992-1-1 recommends, what annexes say, sources, tests."""

from __future__ import annotations

from typing import Any

from groundslab.design.codes.en1992_2004.annex import ANNEXES, file_of
from groundslab.design.codes.eurocode2.annex_files import Table
from groundslab.model.loads.annexes import action_parameters

#: Those looked through, which have columns of the first table.
WHOLE = ("Germany", "United Kingdom")
#: Sources that are enough.
ENOUGH = 2


def tables() -> str:
    """Return the tables of all annexes."""
    recommended = file_of("recommended").parameters
    national = {name: file_of(name) for name in ANNEXES if name != "recommended"}
    heads = ["clause", "what", "recommended", *WHOLE, "sources", "tests"]
    rows = [_row(key, each, {name: national[name].parameters for name in WHOLE}) for key, each in recommended.items()]
    parts = ["## Germany and the United Kingdom", "", _table(heads, rows)]
    for name, file in national.items():
        parts += ["", f"## {name}", "", f"{file.title}."]
        if name not in WHOLE:
            own = [
                [each["clause"], recommended[key]["quantity"], _value(recommended[key]["value"]), _value(each["value"]),
                 _sources(each["sources"])] for key, each in file.parameters.items()
            ]  # fmt: skip
            parts += ["", _table(["clause", "what", "recommended", name, "sources"], own)]
        if file.left_out:
            parts += ["", "Not followed:", "", *(f"- {each}" for each in file.left_out)]
    return "\n".join(parts) + "\n"


def table_of_actions() -> str:
    """Return the table of what EN 1990 and EN 1997-1 leave to nations, and what is not taken from annexes."""
    rows, left_out = action_parameters()["rows"], action_parameters()["left_out"]
    nations = sorted({name for row in rows for name in row.get("national", {})})
    heads = ["clause", "what", "key", "recommended", *nations, "sources", "tests"]
    lines = []
    for row in rows:
        own, sources = row.get("national", {}), row["sources"]
        national = [_value(own[name]) if name in own else "" for name in nations]
        found = [_sources(sources["recommended"]), *(f"{name}: {_sources(sources[name])}" for name in own)]
        key, value = f"`{row['key']}`", _value(row["recommended"])
        lines.append([row["clause"], row["quantity"], key, value, *national, "<br>".join(found), _tests(row)])
    parts = [_table(heads, lines), "", "Not followed:", ""]
    parts += [f"- {name}, {each}" for name, all_of in left_out.items() for each in all_of]
    return "\n".join(parts) + "\n"


def _row(key: str, each: dict[str, Any], national: dict[str, Table]) -> list[str]:
    """Return a parameter's row."""
    own = {name: table[key] for name, table in national.items() if key in table}
    clauses = dict.fromkeys([each["clause"], *(other["clause"] for other in own.values())])
    sources = [_sources(each["sources"]), *(f"{name}: {_sources(other['sources'])}" for name, other in own.items())]
    values = [_value(own[name]["value"]) if name in own else "" for name in national]
    return ["; ".join(clauses), each["quantity"], _value(each["value"]), *values, "<br>".join(sources), _tests(each)]


def _tests(row: dict[str, Any]) -> str:
    """Return the tests that hold a row."""
    return ", ".join(f"`{test.removeprefix('test_')}`" for test in row["tests"])


def _sources(sources: list[str]) -> str:
    """Return sources in words, and that there are less than enough."""
    few = "" if len(sources) >= ENOUGH else "**one source**: " if sources else "**none found**, from memory"
    return few + "; ".join(sources)


def _value(value: Any) -> str:
    """Return a value as text; by exposure class equal ones together."""
    if isinstance(value, dict):
        by_value: dict[float, list[str]] = {}
        for name, each in value.items():
            by_value.setdefault(each, []).append(name)
        return "<br>".join(f"{', '.join(names)}: {each:g}" for each, names in by_value.items()) or "not judged"
    if isinstance(value, str):
        return value
    if isinstance(value, list):
        return ", ".join(map(_value, value))
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.4g}" if value != float("inf") else "none"


def _table(heads: list[str], rows: list[list[str]]) -> str:
    """Return a table in Markdown."""
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)
