"""The lists of the model as tables in a real browser: pasting from a spreadsheet, typing, faults, selection."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from helpers.browsing import Bench, Server

pytestmark = pytest.mark.slow

#: Paste as the browser does: with an event where the focus is.
PASTE = """(text) => {
  const clipboardData = new DataTransfer();
  clipboardData.setData("text/plain", text);
  const options = { clipboardData, bubbles: true, cancelable: true };
  document.activeElement.dispatchEvent(new ClipboardEvent("paste", options));
}"""
COPY = """() => {
  const clipboardData = new DataTransfer();
  document.activeElement.dispatchEvent(new ClipboardEvent("copy", { clipboardData, bubbles: true, cancelable: true }));
  return clipboardData.getData("text/plain");
}"""
COLUMNS = "name\tx [m]\ty [m]\twidth x [mm]\twidth y [mm]\tremark\n" + "\n".join(
    f"B{n}\t{-2.75 + 0.5 * n:.2f}\t-1,5\t200\t200\tas drawn".replace(".", ",") for n in range(12)
)
LOADS = "column;P [kN];M_x [kNm]\n" + "\n".join(f"B{n};{100 + n};{n},5" for n in range(12))


def _data(bench: Bench) -> dict[str, Any]:
    return tomllib.loads(bench.text())


def _open_table(bench: Bench, table: str) -> None:
    """Show a table, and go to its first cell."""
    bench.tab("Tables")
    bench.page.get_by_label("table", exact=True).select_option(table)
    bench.page.locator("table.sheet").focus()
    bench.page.keyboard.press("Control+Home")


def _cells(bench: Bench, selector: str) -> list[str]:
    """Return the words of the cells that a selector finds."""
    return list(bench.page.eval_on_selector_all(f"table.sheet {selector}", "all => all.map(each => each.textContent)"))


def _tab_to(page: Any, selector: str) -> None:
    """Press Tab until an element has the focus."""
    for _ in range(60):
        page.keyboard.press("Tab")
        if page.evaluate("(selector) => document.activeElement.matches(selector)", selector):
            return
    raise AssertionError(f"Tab never reaches {selector}")


def test_columns_and_loads_come_from_a_spreadsheet(server: Server, bench: Bench, case: Path) -> None:
    """A paste adds all rows by the names and units of its head, in one step of undo; the result is of all of them."""
    bench.open(server.start(case, by_itself=False))
    before = bench.text()
    _open_table(bench, "columns")
    bench.page.keyboard.press("ArrowDown")
    bench.page.evaluate(PASTE, COLUMNS)
    bench.wait_seen(".sheet-status", "12 rows added. Skipped: remark.")
    bench.until(lambda: len(_data(bench)["columns"]) == 13)
    assert _data(bench)["columns"][12] == {
        "name": "B11",
        "x": "2.75 m",
        "y": "-1.5 m",
        "width_x": "200 mm",
        "width_y": "200 mm",
    }
    _open_table(bench, "loads point")
    bench.page.keyboard.press("ArrowDown")
    bench.page.evaluate(PASTE, LOADS)
    bench.until(lambda: len(_data(bench)["loads"]) == 13)
    assert _data(bench)["loads"][12] == {"kind": "point", "column": "B11", "P": "111 kN", "M_x": "11.5 kNm"}
    bench.solve()
    bench.wait_equal(lambda: _cells(bench, "tr.selected th"), [str(n) for n in range(2, 14)])
    assert bench.page.evaluate(COPY).splitlines()[0] == "100 kN\t0.5 kNm\t\t\t\t\t\t\t\tB0"

    bench.page.keyboard.press("Control+z")
    bench.until(lambda: len(_data(bench)["loads"]) == 1 and len(_data(bench)["columns"]) == 13)
    bench.page.keyboard.press("Control+z")
    bench.until(lambda: bench.text() == before)
    bench.wait_equal(lambda: bench.page.locator("table.sheet").get_attribute("aria-rowcount"), "3")


def test_a_wrong_cell_is_marked_and_put_right(server: Server, bench: Bench, case: Path) -> None:
    """What cannot be a value stays in the file; its cell is marked and says why, and an issue leads to it."""
    bench.open(server.start(case, by_itself=False))
    _open_table(bench, "loads point")
    bench.page.evaluate(PASTE, "column\tP\nA1\t1,500\nA9\t80\n")
    bench.wait_equal(lambda: _cells(bench, "td.faulty"), ["1,500"])
    assert [each["P"] for each in _data(bench)["loads"]] == ["1,500", "80 kN"]
    bench.wait_equal(lambda: _cells(bench, "tr.faulty th"), ["1"])
    bench.wait_seen(".sheet-status", "1 row changed, 1 row added. 1 error in row 1.")
    assert 'ound "1,500"' in bench.page.locator("td.faulty").get_attribute("title")

    bench.page.locator(".issue-list summary").click()
    bench.page.locator(".issue-list li button", has_text="1,500").click()
    bench.wait_seen(".sheet-status", 'Found "1,500"')
    bench.wait_equal(lambda: _cells(bench, "td.active"), ["1,500"])
    bench.page.keyboard.type("1500 kN")
    bench.page.keyboard.press("Enter")
    # that no column has this name is found when all values can be read
    bench.wait_equal(lambda: _cells(bench, "td.faulty"), ["A9"])
    bench.wait_equal(lambda: _cells(bench, "td.active"), ["80 kN"])
    bench.page.keyboard.press("Control+-")
    bench.until(lambda: [each["P"] for each in _data(bench)["loads"]] == ["1500 kN"])
    bench.solve()


def test_rows_are_edited_with_the_keyboard_alone(server: Server, bench: Bench, case: Path) -> None:
    """Tab reaches the table; letters replace, F2 edits, Escape drops, Delete empties; rows are duplicated, selected."""
    bench.open(server.start(case))
    page, keys = bench.page, bench.page.keyboard
    _tab_to(page, '.model [role="tab"]')
    keys.press("ArrowRight")
    keys.press("ArrowRight")
    _tab_to(page, "table.sheet")
    bench.wait_equal(lambda: page.locator("table.sheet").get_attribute("aria-label"), "Columns")
    for _ in range(3):
        keys.press("Tab")
    keys.type("0,35 m")
    keys.press("Tab")
    bench.wait_text('width_x = "0.35 m"')
    keys.press("F2")
    bench.wait_equal(page.locator(".cell-editor").input_value, "400 mm")
    keys.type("1")
    keys.press("Escape")
    keys.type("300")
    keys.press("Enter")
    bench.wait_text('width_y = "300 mm"')
    keys.press("ArrowUp")
    keys.press("Control+d")
    bench.until(lambda: [each["name"] for each in _data(bench)["columns"]] == ["A1", "A2"])
    keys.press("Delete")
    bench.until(lambda: "width_y" not in _data(bench)["columns"][1])
    bench.until(lambda: _cells(bench, "tr.faulty th") == ["2"])
    keys.press("Control+z")
    bench.wait_solved()
    keys.press("Escape")
    keys.press("Tab")
    bench.until(lambda: not page.evaluate("() => document.activeElement.matches('table.sheet')"))
    bench.tab("Plan")
    bench.wait_seen(".properties h3", "column A2")
