"""The rules of axe-core on a page, in light and in dark."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

from helpers.paths import ROOT

AXE = ROOT / "web" / "node_modules" / "axe-core" / "axe.min.js"
needs_axe = pytest.mark.skipif(not AXE.is_file(), reason="axe-core is not installed (npm ci in web/)")
#: Themes differ in their colors alone.
RUN = """async ([part, theme]) => {
  const rules = theme === "dark" ? { runOnly: ["color-contrast", "link-in-text-block"] } : {};
  const { violations } = await axe.run(part, { resultTypes: ["violations"], ...rules });
  return violations.filter(({ impact }) => ["moderate", "serious", "critical"].includes(impact))
    .flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.target.join(" ")}: ${node.failureSummary}`));
}"""


def find_violations(page: Any, part: str = "html", themes: Sequence[str] = ("light", "dark")) -> list[str]:
    """Return the violations that are moderate or worse of a page, or a part of it, in light and in dark."""
    if not page.evaluate("() => 'axe' in window"):
        page.evaluate(AXE.read_text())
    found = []
    for theme in themes:
        page.evaluate("(theme) => { document.documentElement.dataset.theme = theme; }", theme)
        # colours that still change would be those of neither theme
        page.evaluate("() => Promise.all(document.getAnimations().map((each) => each.finished.catch(() => null)))")
        found += [f"{theme}: {each}" for each in page.evaluate(RUN, [part, theme])]
    return found
