"""Accessibility: the rules of axe-core on every page, and a whole session with the keyboard alone."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from helpers.accessibility import find_violations, needs_axe
from helpers.browsing import Bench, Server

pytestmark = [pytest.mark.slow, needs_axe]


def test_axe_finds_what_is_wrong(bench: Bench) -> None:
    """A button without a name and text that is too faint are found, so that finding nothing means something."""
    bench.page.set_content(
        '<html lang="en"><title>x</title><main><button></button><p style="color:#ccc">faint words</main>'
    )
    found = "\n".join(find_violations(bench.page))
    assert "button-name" in found
    assert "color-contrast" in found


def test_no_violations_from_an_empty_case_to_a_result(server: Server, bench: Bench, case: Path) -> None:
    """Plan, form, tables, text, with and without a result, the dialogs, the tabs of the result have no violation.

    The entire page is judged without and with a result, then the part that changes.
    """
    bench.open(server.start(None))
    assert find_violations(bench.page) == []
    bench.page.keyboard.press("Control+o")
    bench.page.get_by_role("dialog").wait_for()
    assert find_violations(bench.page, "dialog[open]") == []
    bench.open(server.start(case))
    bench.wait_solved()
    assert find_violations(bench.page) == []
    for tab in ("Form", "Tables", "Load cases", "Text"):
        bench.tab(tab)
        assert find_violations(bench.page, ".model") == []
    bench.tab("Plan")
    bench.page.locator(".drawing").press("?")
    bench.page.get_by_role("dialog", name="Keyboard shortcuts").wait_for()
    assert find_violations(bench.page, "dialog[open]") == []
    bench.page.keyboard.press("Escape")
    bench.page.get_by_role("button", name="Export …").click()
    bench.page.get_by_role("dialog", name="Export").wait_for()
    assert find_violations(bench.page, "dialog[open]") == []
    bench.page.keyboard.press("Escape")
    for tab in bench.page.locator(".result").get_by_role("tab").all():
        tab.click()
        assert find_violations(bench.page, ".lower") == []


def test_no_violations_in_lists_of_the_form(server: Server, bench: Bench, case: Path) -> None:
    """The form's loads, folded and open, have no violation: no button is inside of another one."""
    bench.open(server.start(case, by_itself=False))
    bench.tab("Form")
    bench.page.locator('[data-section="loads"] > summary').click()
    items = bench.page.locator('[data-section="loads"] .item')
    items.first.wait_for()
    assert find_violations(bench.page, ".form") == []
    items.first.locator("> summary").click()
    assert find_violations(bench.page, ".form") == []


def test_no_violations_in_the_report(server: Server, bench: Bench, case: Path, tmp_path: Path) -> None:
    """The report's page has no violation."""
    bench.open(server.start(case))
    bench.wait_solved()
    bench.page.goto(bench.export("report.html", tmp_path).as_uri())
    bench.page.locator(".gs-viewer").first.wait_for()
    assert find_violations(bench.page) == []


def press_until(page: Any, key: str, selector: str) -> None:
    """Press a key until an element has the focus."""
    for _ in range(200):
        if page.evaluate("(selector) => document.activeElement?.matches(selector) ?? false", selector):
            return
        page.keyboard.press(key)
    raise AssertionError(f"{key} never reaches {selector}")


def test_a_session_with_the_keyboard_alone(server: Server, bench: Bench, case: Path) -> None:
    """A case is opened, a load is added and solved, and its settlement is read, without a mouse."""
    bench.open(server.start(None))
    page, keys = bench.page, bench.page.keyboard
    keys.press("Control+o")
    dialog = page.get_by_role("dialog")
    bench.until(lambda: dialog.locator(".path").input_value() != "")
    press_until(page, "Shift+Tab", ".path")
    keys.press("Control+a")
    keys.type(str(case.parent))
    keys.press("Enter")
    dialog.get_by_role("option", name="slab.toml").wait_for()
    press_until(page, "Tab", ".file-name input")
    keys.type("slab.toml")
    keys.press("Enter")
    bench.wait_text('name = "A1"')
    bench.wait_solved()
    before = page.locator(".figures tr", has_text="largest settlement").first.text_content()

    press_until(page, "Tab", ".drawing")
    bench.step("n", "load")
    keys.press("Control+d")
    bench.until(lambda: bench.text().count("[[loads]]") == 2)
    keys.press("F9")
    bench.until(
        lambda: page.locator(".figures tr", has_text="largest settlement").first.text_content() != before,
        lambda: f"{before} in\n{bench.text()}",
    )
    bench.wait_solved()
    press_until(page, "Tab", '.result [role="tab"]')
    keys.press("Tab")
    focused = page.evaluate("() => document.activeElement.textContent")
    assert "largest settlement" in focused
