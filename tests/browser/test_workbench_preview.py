"""A picture on a coarse mesh while the results are on their way, marked as that."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.browsing import SMALL, Bench, Server

pytestmark = pytest.mark.slow

#: Notes what the label over the picture says.
RECORD = """
window.previews = [];
new MutationObserver(() => {
  const label = document.querySelector(".preview-over");
  if (label && !label.hidden && window.previews.at(-1) !== label.textContent) window.previews.push(label.textContent);
}).observe(document, { subtree: true, attributes: true, childList: true, characterData: true });
"""


def test_a_preview_comes_before_the_result(server: Server, bench: Bench, tmp_path: Path) -> None:
    """It is of one combination on a coarse mesh; then all are there while the mesh is refined, and then no label is."""
    case = tmp_path / "adaptive.toml"
    case.write_text(SMALL.replace('size = "0.5 m"', 'accuracy = "0.5 %"'), encoding="utf-8")
    bench.page.add_init_script(RECORD)
    bench.open(server.start(case))
    bench.wait_solved()
    seen = bench.page.evaluate("window.previews")
    # one that is overtaken by the next while it is fetched is not shown
    first = "Preview on a coarse mesh, of this combination only"
    assert seen
    assert all(each == first or "being refined" in each for each in seen)
    assert first not in seen[1:]
    bench.wait_equal(bench.page.locator(".preview-over:visible").count, 0)
    assert bench.largest("largest settlement") > 0
