"""Reactions in a real browser: a table is read with what is said of it, shown, and taken in one step of undo."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.browsing import Bench, Server
from helpers.reactions import ETABS, write_case, write_table

pytestmark = pytest.mark.slow


def test_reactions_are_shown_and_taken(server: Server, bench: Bench, tmp_path: Path) -> None:
    """What the table leaves open is listed; once it is said, the changes are; undo takes the loads back."""
    case = write_case(tmp_path)
    write_table(tmp_path, ETABS.replace(",Q,", ",LIVE,"))
    bench.open(server.start(case, by_itself=False))
    bench.page.keyboard.press("Control+o")
    bench.page.get_by_role("option", name="reactions.csv").dblclick()
    dialog = bench.page.locator(".reactions-dialog")
    bench.wait_seen(".reactions-dialog .messages", 'load case "LIVE"')
    bench.wait_seen(".reactions-dialog .messages", 'support "102"')
    take = dialog.get_by_role("button", name="Import", exact=True)
    assert take.is_disabled()
    dialog.get_by_label("new load cases").fill("LIVE = B")
    dialog.get_by_label("supports with another name").fill("101 = A\n102 = B")
    dialog.get_by_role("button", name="Show changes").click()
    bench.wait_seen(".reactions-found", "new: A in G: P 1.8124 MN, M_x 20 kNm, M_y 10 kNm")
    bench.wait_seen(".reactions-found", "signs: P = F_z")
    dialog.get_by_label("positive vertical force").select_option("lifts")
    assert take.is_disabled()
    dialog.get_by_role("button", name="Show changes").click()
    bench.wait_seen(".reactions-found", "new: A in G: P -1.8124 MN")
    take.click()
    dialog.wait_for(state="detached")
    bench.wait_text('P = "-1812.4 kN"', 'positive = "lifts"', "# with bars")
    bench.page.get_by_role("button", name="undo").click()
    bench.wait_equal(lambda: "1812.4" in bench.text(), False)
