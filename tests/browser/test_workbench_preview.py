"""What there is before the last results, marked as that: a preview on a coarse mesh, provisional results."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.browsing import SMALL, Bench, Server

pytestmark = pytest.mark.slow

#: A floor whose 44 combinations take long.
FLOOR = Path(__file__).parents[2] / "bench" / "slabs" / "floor_forklift.toml"

#: Notes what the label over the picture says.
RECORD = """
window.previews = [];
new MutationObserver(() => {
  const label = document.querySelector(".preview-over");
  if (label && !label.hidden && window.previews.at(-1) !== label.textContent) window.previews.push(label.textContent);
}).observe(document, { subtree: true, attributes: true, childList: true, characterData: true });
"""


def test_a_preview_has_figures(server: Server, bench: Bench, tmp_path: Path) -> None:
    """Those of the combination in the picture, on a coarse mesh, which is said beside them; there are no checks yet."""
    case = tmp_path / "floor.toml"
    case.write_text(FLOOR.read_text(encoding="utf-8"), encoding="utf-8")
    bench.open(server.start(case))
    words = "Preview on a coarse mesh, of this combination only"
    bench.wait_seen(".preview-over:visible", words)
    bench.wait_seen(".lower .verdict.doubtful", words)
    assert bench.largest("largest settlement") > 0
    assert bench.page.locator('.result-status[data-state="solving"]').count() == 1
    assert bench.page.get_by_role("tab", name="Checks").and_(bench.page.locator(":visible")).count() == 0


def test_provisional_results_come_before_the_last(server: Server, bench: Bench, tmp_path: Path) -> None:
    """While the mesh is refined there are figures, checks and tables, and over the picture how far they are off.

    It is refined for an accuracy that is out of reach, until that is canceled for a mesh that is given.
    """
    case = tmp_path / "adaptive.toml"
    endless = 'accuracy = "0.01 %"\nmax_unknowns = 1_000_000'
    case.write_text(SMALL.replace('size = "0.5 m"', endless), encoding="utf-8")
    bench.page.add_init_script(RECORD)
    bench.open(server.start(case))
    bench.wait_seen(".preview-over:visible", "Provisional: mesh ")
    first = bench.largest("largest settlement")
    assert first > 0
    bench.page.locator(".result").get_by_role("tab", name="Mesh and errors").click()
    bench.wait_seen(".table-box:visible", "largest error")
    assert bench.page.locator('.result-status[data-state="solving"]').count() == 1
    bench.page.get_by_role("button", name="Cancel", exact=True).click()
    bench.page.locator('.result-status[data-state="solving"]').wait_for(state="detached")
    seen = bench.page.evaluate("window.previews")
    assert all(each.startswith(("Preview on a coarse mesh", "Provisional: mesh ")) for each in seen)
    bench.tab("Text")
    bench.page.locator(".code-input").fill(SMALL)
    bench.wait_solved()
    bench.wait_equal(bench.page.locator(".preview-over:visible").count, 0)
    assert bench.largest("largest settlement") == pytest.approx(first, rel=0.01)
