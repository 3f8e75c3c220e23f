"""Something at once and of the present model, what it will cost, and a file that another program changes."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from helpers.browsing import SMALL, Bench, Server

pytestmark = pytest.mark.slow

FLOOR = Path(__file__).parents[2] / "bench" / "slabs" / "floor_forklift.toml"
CHANGES = "dialog.changes"


def standing(bench: Bench) -> str:
    """Return how the picture stands to the model."""
    return str(bench.page.locator(".result").get_attribute("data-standing"))


def type_text(bench: Bench, text: str) -> None:
    """Replace the text of the case."""
    bench.tab("Text")
    bench.page.locator(".code-input").fill(text)


def test_what_is_shown_is_of_the_present_model(server: Server, bench: Bench, case: Path) -> None:
    """Where no combination is left that was there, a preview of a new one takes the place of the old slab.

    Until it is there, and while the text is broken, the result before is crossed out; a new case has none.
    """
    bench.open(server.start(case))
    bench.wait_solved()
    assert standing(bench) == "current"
    # a mesh that is made soon, on which 44 combinations take long
    type_text(bench, f'{FLOOR.read_text(encoding="utf-8")}\n[mesh]\nsize = "0.2 m"\n')
    bench.wait_equal(lambda: standing(bench), "preview")
    bench.wait_seen(".preview-over:visible", "of this combination only")
    type_text(bench, "[plate")
    bench.wait_equal(lambda: standing(bench), "outdated")
    bench.wait_seen(".outdated-over:visible", "Result of an earlier model")
    bench.page.get_by_role("button", name="New", exact=True).click()
    bench.page.get_by_role("button", name="Empty").click()
    bench.page.get_by_role("button", name="Don't save").click()
    bench.wait_equal(lambda: standing(bench) in ("empty", "current"), True)


def test_the_cost_is_told_before(server: Server, bench: Bench, case: Path) -> None:
    """Of each accuracy; another one is solved for without a word in the file; a mesh that is given leaves no choice."""
    case.write_text(SMALL.replace('\n[mesh]\nsize = "0.5 m"\n', ""), encoding="utf-8")
    bench.open(server.start(case))
    bench.wait_solved()
    choice = bench.page.get_by_label("Accuracy")
    bench.until(lambda: "about" in choice.inner_text(), choice.inner_text)
    options = choice.locator("option").all_inner_texts()
    assert [option.partition(" ")[0] for option in options] == ["Draft", "Normal", "Strict"]
    assert all(re.search(r": about \d+ s$", option) for option in options)
    told = bench.page.get_by_label("What solving takes")
    assert re.fullmatch(r"[\d,]+ unknowns, 1 combination", told.inner_text())
    assert re.match(r"about \d+ s, [\d,]+ unknowns, 1 combination, \d mesh", str(told.get_attribute("title")))
    choice.select_option("strict")
    bench.wait_seen(".result-status", "Solved")
    bench.wait_equal(lambda: choice.input_value(), "strict")
    bench.tab("Text")
    assert "accuracy" not in bench.text()
    type_text(bench, SMALL)
    bench.wait_equal(choice.is_disabled, True)
    assert "The case gives the size" in str(choice.get_attribute("title"))


def test_a_conflict_is_settled_in_three_ways(server: Server, bench: Bench, case: Path) -> None:
    """At a save: the file's text, this page's, or both merged, each after a look at the difference."""
    bench.open(server.start(case, by_itself=False))
    theirs = SMALL.replace('k = "20 MPa/m"', 'k = "30 MPa/m"')
    for label, k, thickness in (("Reload", 30, 250), ("Replace the file", 20, 300), ("Merge", 30, 300)):
        type_text(bench, SMALL.replace("250 mm", "300 mm"))
        bench.wait_equal(lambda: bench.seen(".unsaved"), "● unsaved")
        case.write_text(theirs, encoding="utf-8")
        bench.page.get_by_role("button", name="Save", exact=True).click()
        bench.page.locator(CHANGES).wait_for()
        assert '+k = "30 MPa/m"' in bench.seen(f"{CHANGES} .difference")
        bench.page.locator(CHANGES).get_by_role("button", name=label).click()
        expected = SMALL.replace("20 MPa/m", f"{k} MPa/m").replace("250 mm", f"{thickness} mm")
        bench.wait_equal(bench.text, expected)
        bench.wait_equal(lambda: case.read_text(encoding="utf-8"), expected)
        case.write_text(SMALL, encoding="utf-8")
        bench.page.locator(".changed-file:visible").get_by_role("button", name="Reload").click()
        bench.wait_equal(bench.text, SMALL)


def test_a_file_that_was_changed_is_reloaded(server: Server, bench: Bench, case: Path) -> None:
    """A banner says so without any edit; undo brings this page's text back; what both changed cannot be merged."""
    bench.open(server.start(case, by_itself=False))
    bench.tab("Text")
    bench.wait_equal(bench.text, SMALL)
    case.write_text(SMALL.replace("250 mm", "400 mm"), encoding="utf-8")
    bench.wait_seen(".changed-file:visible", "Another program has changed the file.")
    bench.page.get_by_role("button", name="Reload").click()
    bench.wait_text("400 mm")
    bench.wait_equal(bench.page.locator(".changed-file:visible").count, 0)
    bench.page.get_by_label("undo").click()
    bench.wait_text("250 mm")
    type_text(bench, SMALL.replace("250 mm", "260 mm"))
    case.write_text(SMALL.replace("250 mm", "500 mm"), encoding="utf-8")
    bench.page.get_by_role("button", name="Show difference").click()
    bench.page.locator(CHANGES).wait_for()
    assert bench.page.locator(CHANGES).get_by_role("button", name="Merge").is_disabled()
    bench.page.locator(CHANGES).get_by_role("button", name="Keep mine").click()
    bench.wait_equal(bench.page.locator(".changed-file:visible").count, 0)
    bench.wait_text("260 mm")
    assert "500 mm" in case.read_text(encoding="utf-8")
