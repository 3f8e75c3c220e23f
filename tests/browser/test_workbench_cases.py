"""Load cases and combinations in a real browser: cases of a raft made from none, their sums and factors by hand."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from helpers.browsing import Bench, Server

pytestmark = pytest.mark.slow


def _cells(bench: Bench, table: str) -> list[list[str]]:
    """Return the words of the rows of a table, of fields their values."""
    read = """rows => rows.map((row) => [...row.cells].map((cell) =>
      cell.querySelector("input[type=text], select")?.value ?? cell.textContent))"""
    found: list[list[str]] = bench.page.locator(f"{table} tbody tr:not(.space, .case-notes)").evaluate_all(read)
    return found


def _data(bench: Bench) -> dict[str, Any]:
    return tomllib.loads(bench.text())


def _add(bench: Bench, name: str, kind: str) -> None:
    bench.page.get_by_label("type of a new case").select_option(kind)
    bench.page.get_by_label("name of a new case").fill(name)
    bench.page.get_by_label("name of a new case").press("Enter")


def test_cases_of_a_raft_from_none(server: Server, bench: Bench, case: Path) -> None:
    """200 kN at (-2, 1) m; 25 kN/m3 on 6 m x 4 m x 0.25 m; by 6.10 and with psi_2 = 0.3 of offices, as by hand."""
    bench.open(server.start(case, by_itself=False))
    bench.tab("Load cases")
    _add(bench, "live", "B")
    bench.until(lambda: "live" in bench.text())
    _add(bench, "dead", "permanent")
    bench.wait_seen(".case-notes:not(.flagged) .invitation", "No loads yet")
    bench.page.get_by_label("self-weight in case 2").check()
    bench.wait_equal(
        lambda: [row[5:9] for row in _cells(bench, ".case-list")],
        [["1", "200", "\N{MINUS SIGN}400", "200"], ["1", "150", "0", "0"]],
    )
    bench.page.get_by_label("how combinations are made").select_option("6.10")
    bench.page.get_by_label("limit state shown").select_option("ultimate")
    rule = "EN 1990 6.10"
    bench.wait_equal(
        lambda: [row[2:] for row in _cells(bench, ".matrix")],
        [["1.5", "1.35", rule], ["", "1.35", rule], ["1.5", "1", rule], ["", "1", rule]],
    )
    bench.page.get_by_label("limit state shown").select_option("quasi-permanent")
    bench.wait_equal(
        lambda: [row[2:] for row in _cells(bench, ".matrix")],
        [["0.3", "1", "EN 1990 6.16b"], ["", "1", "EN 1990 6.16b"]],
    )


def test_keys_rename_move_and_undo(server: Server, bench: Bench, case: Path) -> None:
    """By keys a case gets another name wherever it is called, goes up, and each is undone in one step."""
    text = case.read_text().replace("[[loads]]", '# the offices\n[[cases]]\nname = "live"\n\n[[loads]]\ncase = "live"')
    text += '\n[[cases]]\nname = "dead"\n[[combinations]]\nname = "all"\nfactors = { live = 1.5, dead = 1.35 }\n'
    case.write_text(text)
    bench.open(server.start(case, by_itself=False))
    bench.tab("Load cases")
    name = bench.page.get_by_label("name of case 1")
    name.fill("offices")
    name.press("Enter")
    bench.until(lambda: _data(bench)["combinations"][0]["factors"] == {"offices": 1.5, "dead": 1.35})
    assert _data(bench)["loads"][0]["case"] == "offices"
    assert "# the offices" in bench.text()
    bench.page.get_by_label("move case dead", exact=True).focus()
    bench.page.keyboard.press("Alt+ArrowUp")
    bench.until(lambda: [each["name"] for each in _data(bench)["cases"]] == ["dead", "offices"])
    bench.wait_equal(lambda: bench.page.evaluate("document.activeElement.dataset.key"), "handle-0")
    bench.page.keyboard.press("Control+z")
    bench.until(lambda: [each["name"] for each in _data(bench)["cases"]] == ["offices", "dead"])
    bench.page.keyboard.press("Control+z")
    bench.until(lambda: bench.text() == text)

    factor = bench.page.get_by_label("factor of live in all")
    factor.fill("1,35")
    factor.press("Tab")
    bench.page.keyboard.type("1.2")  # into the next field, in place of what is there
    bench.page.keyboard.press("Enter")
    bench.until(lambda: _data(bench)["combinations"][0]["factors"] == {"live": 1.35, "dead": 1.2})
    bench.page.get_by_label("remove case live").click()
    dialog = bench.page.get_by_role("dialog", name="Remove load case live?")
    dialog.get_by_role("button", name="Move its loads to dead").click()
    bench.until(lambda: _data(bench)["cases"] == [{"name": "dead"}] and _data(bench)["loads"][0]["case"] == "dead")
    assert _data(bench)["combinations"][0]["factors"] == {"dead": 1.2}
