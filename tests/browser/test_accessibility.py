"""Accessibility: the rules of axe-core on every page, and a whole session with the keyboard alone."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from helpers.browsing import Bench, Server
from helpers.paths import ROOT

AXE = ROOT / "web" / "node_modules" / "axe-core" / "axe.min.js"
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not AXE.is_file(), reason="axe-core is not installed (npm ci in web/)"),
]
RUN = """async () => {
  const { violations } = await axe.run(document, { resultTypes: ["violations"] });
  return violations.filter(({ impact }) => ["serious", "critical"].includes(impact))
    .flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.target.join(" ")}: ${node.failureSummary}`));
}"""


def find_violations(page: Any) -> list[str]:
    """Return the serious and critical violations of a page, in light and in dark."""
    if not page.evaluate("() => 'axe' in window"):
        page.evaluate(AXE.read_text())
    found = []
    for theme in ("light", "dark"):
        page.evaluate("(theme) => { document.documentElement.dataset.theme = theme; }", theme)
        # colours that still change would be those of neither theme
        page.evaluate("() => Promise.all(document.getAnimations().map((each) => each.finished.catch(() => null)))")
        found += [f"{theme}: {each}" for each in page.evaluate(RUN)]
    return found


def test_axe_finds_what_is_wrong(bench: Bench) -> None:
    """A button without a name and text that is too faint are found, so that finding nothing means something."""
    bench.page.set_content(
        '<html lang="en"><title>x</title><main><button></button><p style="color:#ccc">faint words</main>'
    )
    found = "\n".join(find_violations(bench.page))
    assert "button-name" in found
    assert "color-contrast" in found


def test_no_violations_from_an_empty_case_to_a_result(server: Server, bench: Bench, case: Path) -> None:
    """Plan, form and text, with and without a result, the dialogs, and the tabs of the result have no violation."""
    bench.open(server.start(None))
    assert find_violations(bench.page) == []
    bench.page.keyboard.press("Control+o")
    bench.page.get_by_role("dialog").wait_for()
    assert find_violations(bench.page) == []
    server.stop()
    bench.open(server.start(case))
    bench.wait_solved()
    for tab in ("Form", "Text", "Plan"):
        bench.tab(tab)
        assert find_violations(bench.page) == []
    for tab in bench.page.locator(".result").get_by_role("tab").all():
        tab.click()
        assert find_violations(bench.page) == []


def test_no_violations_in_the_report(server: Server, bench: Bench, case: Path, tmp_path: Path) -> None:
    """The report's page has no violation."""
    bench.open(server.start(case))
    bench.wait_solved()
    with bench.page.expect_download() as download:
        bench.page.get_by_role("button", name="Report").click()
    download.value.save_as(tmp_path / "report.html")
    bench.page.goto((tmp_path / "report.html").as_uri())
    bench.page.locator(".gs-viewer").first.wait_for()
    assert find_violations(bench.page) == []
