"""What cannot act now says why, on every tab of the page; what can act, does."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from helpers.browsing import SMALL, Bench, Server

pytestmark = pytest.mark.slow

#: What is disabled and seen, by its words, with the reason that it gives.
DISABLED = """() => [...document.querySelectorAll("button, input, select")]
  .filter((each) => (each.disabled || each.ariaDisabled === "true") && each.checkVisibility())
  .map((each) => [(each.getAttribute("aria-label") ?? each.textContent).trim(), each.title])"""


def refused(bench: Bench) -> dict[str, str]:
    """Return the controls that are disabled, with their reasons."""
    found: list[tuple[str, str]] = bench.page.evaluate(DISABLED)
    return dict(found)


def test_a_case_without_a_slab_says_what_comes_first(server: Server, bench: Bench, tmp_path: Path) -> None:
    """Tools wait for the slab, all else for what it needs; no control on any tab is disabled without a reason."""
    case = tmp_path / "empty.toml"
    case.write_text('title = "nothing yet"\n')
    bench.open(server.start(case, by_itself=False))
    bench.page.wait_for_selector('.tool[data-tool="column"]:disabled')
    for tab in ("Plan", "Form", "Tables", "Load cases", "Text"):
        bench.tab(tab)
        assert [words for words, reason in refused(bench).items() if not reason] == []
    bench.tab("Plan")
    reasons = refused(bench)
    assert "Draw the slab first" in reasons["ColumnC"]
    assert reasons["undo"] == "Nothing to undo"
    assert reasons["Export …"] == "There is nothing to export: fix the errors first."
    assert "Slab" not in " ".join(reasons)
    bench.page.locator(".drawing").press("c")
    bench.wait_seen(".drawing-hint", "Draw the slab first.")
    bench.tab("Load cases")
    assert refused(bench)["+ combination"] == "Add a load case first."
    bench.tab("Tables")
    assert refused(bench)["Copy table"] == "The table has no rows."


def test_a_load_on_the_entire_slab_can_be_removed_where_it_is(server: Server, bench: Bench, case: Path) -> None:
    """Delete on its chip and the button remove it; what needs a position on the plan says so."""
    case.write_text(SMALL + '\n[[loads]]\nkind = "uniform"\nq = "10 kPa"\n')
    bench.open(server.start(case, by_itself=False))
    chip = bench.page.locator(".unplaced .chip:not(.add)")
    chip.click()
    bench.page.wait_for_selector(".property-acts button:disabled")
    assert set(refused(bench)) >= {"Move …", "Array …"}
    assert refused(bench)["Move …"] == "It acts on the entire slab, without a position on the plan."
    assert bench.page.get_by_role("button", name="Remove", exact=True).is_enabled()
    chip.press("Delete")
    bench.wait_equal(chip.count, 0)
    bench.until(lambda: "uniform" not in bench.text(), bench.text)
    bench.page.locator(".drawing").press("n")  # the first item is the slab
    bench.until(lambda: "Remove" in refused(bench))
    assert "cannot be removed" in refused(bench)["Remove"]


def test_nothing_is_drawn_while_the_text_cannot_be_read(server: Server, bench: Bench, case: Path) -> None:
    """Tools are put down and say so, until the text is one again."""
    bench.open(server.start(case, by_itself=False))
    bench.tool("column")
    bench.tab("Text")
    area: Any = bench.page.locator(".code-input")
    whole = area.input_value()
    area.fill(whole + "x = = 1")
    bench.page.wait_for_selector(".broken:not([hidden])")
    bench.tab("Plan")
    assert refused(bench)["ColumnC"] == "Column (C). Correct the text first."
    assert refused(bench)["+ case"] == "Correct the text first."
    bench.tab("Text")
    area.fill(whole)
    bench.page.wait_for_selector(".broken", state="hidden")
    bench.tab("Plan")
    assert "ColumnC" not in refused(bench)
