"""Every output of a case is the same number in SI units and in US customary units."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from groundslab.analysis.driver import solve
from groundslab.case.casefile import load, loads
from groundslab.design.checks import check_design
from groundslab.results.results import Results
from groundslab.unit_systems import CUSTOMARY
from groundslab.units import DIMENSIONS, NUMBER, QuantityError, parse
from groundslab.views.plots import plot
from groundslab.views.report.html import render_report
from groundslab.views.scene.fields import scene_of
from groundslab.views.summary.json_summary import json_text
from groundslab.views.summary.terminal import print_summary
from groundslab.views.tables.result_tables import tables_of
from groundslab.views.tables.table import Table
from groundslab.workbench.solver.summary import build_summary
from helpers.combinations import few

EXAMPLES = Path(__file__).parents[3] / "examples"
_UNITS = "|".join(sorted({*CUSTOMARY, *(name for name, _ in CUSTOMARY.values())}, key=len, reverse=True))
#: A number with its unit, if it has one, as texts have them.
QUANTITY = re.compile(rf"(?<![\w.^]){NUMBER}[)\]]?(?: (?P<unit>{_UNITS})(?![\w/^]))?")
#: Units of the one system, which a text in the other does not have but in names and in what a code defines.
SI = re.compile(
    r"(?<=[\d)] )(?<! at \d\.\d\d )(?:kN|MN|kPa|MPa|GPa|mm|cm2|m2|kNm|MNm|m)\b(?! \(EN 14651\))"
    r"|\[(?:m|mm|kN|kPa|MPa|kNm|kNm/m|kN/m|cm2/m)\]"
)


@pytest.fixture(scope="module", params=["house_raft", "industrial_floor"])
def both(request: pytest.FixtureRequest) -> tuple[Results, Results]:
    """Return the results of an example on a coarse mesh, shown in SI and in US customary units."""
    model = few(load(EXAMPLES / f"{request.param}.toml"))
    solved = solve(model.replace(mesh={"size": max(model.sides) / 8}))
    customary = solved.model.replace(project={"units": "US"})
    as_solved = solved.solved_model.replace(project={"units": "US"})
    results = {
        name: replace(result, model=customary, solved_model=as_solved) for name, result in solved.results.items()
    }
    return solved, replace(solved, model=customary, results=results)


def size(unit: str) -> float:
    """Return the size of a unit in SI units; of one that both systems have, 1."""
    for dimension in DIMENSIONS:
        try:
            return parse(f"1 {unit}", dimension)
        except QuantityError:
            continue
    return {"lb": 0.45359237, "lb/ft2": 0.45359237 / 0.3048**2, "ft3": 0.3048**3}.get(unit, 1.0)


def in_si(table: Table) -> Iterator[list[Any]]:
    """Yield the columns of a table with their numbers in SI units."""
    of_rows = [size(str(unit)) for unit in table["unit"]] if table.by_row else []
    for column in table.columns:
        by_row = column.name in table.by_row or column.error_of in table.by_row
        sizes = of_rows if by_row else [size(column.unit)] * len(table)
        yield [
            value * factor if isinstance(value, float) else value
            for value, factor in zip(column.values, sizes, strict=True)
        ]


def test_tables(both: tuple[Results, Results]) -> None:
    """Each number is the same, to the last digits; words are but for the quantities in them."""
    for one, other in zip(*map(tables_of, both), strict=True):
        if one.name in ("bars", "bending_schedule"):
            continue  # bars are cut to the inch there, to the millimeter here
        assert [column.name for column in one.columns] == [column.name for column in other.columns]
        for column, here, there in zip(one.columns, in_si(one), in_si(other), strict=True):
            if column.name in ("unit", "in words", "outcome", "demand", "limit", "error of demand"):
                continue  # the checks' own numbers and words are compared below
            for a, b in zip(here, there, strict=True):
                assert b == (pytest.approx(a, rel=1e-12) if isinstance(a, float) else a), (one.name, column.name)


def test_checks(both: tuple[Results, Results]) -> None:
    """Demand and resistance are the same, and so are all quantities in the words, to their digits."""
    for one, other in zip(*(check_design(combined).checks for combined in both), strict=True):
        assert (one.name, one.of, one.status, one.place) == (other.name, other.of, other.status, other.place)
        for a, b in ((one.demand, other.demand), (one.resistance, other.resistance), (one.error, other.error)):
            assert (a is None) == (b is None)
            assert a is None or a * size(one.unit) == pytest.approx(b * size(other.unit), rel=1e-12)
        assert_same_words(one.words, other.words)


def assert_same_words(one: str, other: str) -> None:
    """Assert that texts differ by the units of quantities alone, which are the same to three digits."""
    assert QUANTITY.sub("#", one) == QUANTITY.sub("#", other)
    assert not SI.search(re.sub(r'"[^"]*"', '""', other)), other
    here, there = ([*QUANTITY.finditer(text)] for text in (one, other))
    units = [(a["unit"], b["unit"]) for a, b in zip(here, there, strict=True)]
    for position, (a, b) in enumerate(zip(here, there, strict=True)):
        value, shown = (float(re.match(NUMBER, found[0])[0]) for found in (a, b))  # type: ignore[index]
        # a number that shares its unit with others stands before them
        unit, customary = next((pair for pair in units[position:] if pair[0]), ("", ""))
        converted = shown * size(customary) == pytest.approx(value * size(unit), rel=5e-3, abs=1e-9)
        assert value == shown or converted, (one, other)


def printed(combined: Results) -> str:
    """Return the summary as the terminal shows it."""
    from rich.console import Console

    console = Console(file=io.StringIO(), width=400)
    print_summary(combined, console)
    return console.file.getvalue()  # type: ignore[attr-defined, no-any-return]


def test_summary(both: tuple[Results, Results]) -> None:
    """The summary on the terminal has the same lines, without units of the other system; figures are the same."""
    texts = [printed(combined) for combined in both]
    assert not SI.search(re.sub(r'"[^"]*"', '""', texts[1]))
    figures = [json.loads(json.dumps(build_summary(combined)))["combinations"] for combined in both]
    compared = 0
    for one, other in zip(*figures, strict=True):
        for section, customary in zip(one["sections"], other["sections"], strict=True):
            for row, shown in zip(section["rows"], customary["rows"], strict=True):
                assert (row["key"], row["label"]) == (shown["key"], shown["label"])
                if row["unit"] != shown["unit"]:
                    expected = float(row["value"]) * size(row["unit"])
                    assert float(shown["value"]) * size(shown["unit"]) == pytest.approx(expected, rel=1e-4, abs=1e-9)
                    compared += 1
    assert compared > 20


def test_files_for_programs_stay_in_si_units(both: tuple[Results, Results]) -> None:
    """The JSON summary has the same numbers, but for the checks, which name their units."""
    documents = [json.loads(json_text(combined)) for combined in both]
    for document in documents:
        for key in ("design", "model", "case", "remarks", "cases"):
            document.pop(key, None)
        for each in (document, *document.get("combinations", ())):
            for section in each.values():
                if isinstance(section, dict):
                    section.pop("notes", None)
    assert documents[0] == documents[1]


def test_report(both: tuple[Results, Results]) -> None:
    """No chapter but that of calculations names units of the other system, and these give each value in both."""
    page = render_report(
        both[1], chapters=["extremes", "pictures", "drawings", "loads", "assumptions", "tables", "case"]
    )
    words = re.sub(r"<(script|style).*?</\1>", "", page, flags=re.DOTALL)
    words = re.sub(r'"[^"]*"|&#34;.*?&#34;', "", re.sub(r"<[^>]+>", "", words))
    found = [words[match.start() - 60 : match.end() + 20] for match in SI.finditer(words)]
    assert not found
    sheets = render_report(both[1], chapters=["calculations"])
    pairs = re.findall(
        r'class="number">= ([\d.]+)<small>([\d.]+)</small></td><td class="unit">([^<]+)<small>([^<]+)</small>', sheets
    )
    assert bool(pairs) == any(table.name == "calculations" for table in tables_of(both[1]))
    for value, other, unit, customary in pairs:
        plain = unit.replace("²", "2").replace("³", "3")
        assert float(value) * size(plain) == pytest.approx(float(other) * size(customary.replace("²", "2")), rel=1e-3)


def test_figures(both: tuple[Results, Results]) -> None:
    """Axes are in feet at the same places; the values on the color bar, and those of the extremes, are the same."""
    name = both[0].combinations[0].name
    for one, other in zip(*(plot(combined, "m_x", combination=name).axes for combined in both), strict=True):
        assert one.get_xlabel().replace("[m]", "[ft]") == other.get_xlabel()
        if one.get_xlabel() == "x [m]":
            ticks = zip(other.get_xticks(), other.get_xticklabels(), strict=True)
            for place, label in ticks:
                assert float(label.get_text().replace("\N{MINUS SIGN}", "-")) * 0.3048 == pytest.approx(place, abs=1e-6)
        titles = [[text.get_text() for text in axes.texts if " at (" in text.get_text()] for axes in (one, other)]
        for text, customary in zip(*titles, strict=True):
            plain = [words.replace("\N{MINUS SIGN}", "-") for words in (text, customary)]
            assert_same_words(*plain)


def test_scene(both: tuple[Results, Results]) -> None:
    """Fields of the viewer and their extremes are the same; lengths come with their unit."""
    heads = [scene_of(combined).head for combined in both]
    assert heads[1]["plan"]["lengths"]["unit"] == "ft"
    units = [{field["name"]: field["unit"] for field in head["fields"]} for head in heads]
    for one, other in zip(*(head["combinations"] for head in heads), strict=True):
        for field, ends in one["extremes"].items():
            for end, (value, *place) in ends.items():
                shown, *there = other["extremes"][field][end]
                assert there == place
                expected = value * size(units[0][field])
                assert shown * size(units[1][field]) == pytest.approx(expected, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("example", ["piled_raft", "ribbed_raft"])
def test_names_that_look_like_quantities_stay(example: str) -> None:
    """Every thing of an example is called "... 12.25 m"; nowhere is it "... 40.19 ft", which is as much."""
    text = (EXAMPLES / f"{example}.toml").read_text(encoding="utf-8")
    for name in set(re.findall(r'^name = "([^"]+)"', text, re.MULTILINE)):
        text = re.sub(rf'(?<==) "{re.escape(name)}"$', f' "{name} 12.25 m"', text, flags=re.MULTILINE)
    factors = re.compile(r"(?<=factors = \{).*(?=\}$)", re.MULTILINE)
    text = factors.sub(lambda found: re.sub(r'"?([\w ]+?)"? =', r'"\1 12.25 m" =', found[0]), text)
    model = few(loads(text).replace(project={"units": "US"}))
    combined = solve(model.replace(mesh={"size": max(model.sides) / 5}))
    shown = [*printed(combined).splitlines(), render_report(combined, chapters=["extremes", "loads", "tables"])]
    for table in tables_of(combined):
        shown += [str(value) for column in table.columns for value in (column.name, *column.values)] + [*table.notes]
    assert sum(" 12.25 m" in words for words in shown) > 20
    assert [words for words in shown if re.search(r"\b40\.[12]\d* ft", words)] == []
