"""Kept results in a real browser: looked at, not edited, from a folder and from the one file of the workbench."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

import groundslab
from helpers.browsing import Bench, Server

pytestmark = pytest.mark.slow


def test_results_saved_as_one_file_are_looked_at(
    server: Server, own_server: Server, bench: Bench, case: Path, tmp_path: Path
) -> None:
    """The workbench saves one file with the case to the byte; the viewer shows the same settlement of it."""
    bench.open(server.start(case))
    bench.wait_solved()
    settlement = bench.largest("largest settlement")
    path = bench.export("archive.zip", tmp_path)
    assert path.name == "slab-results.zip"
    with zipfile.ZipFile(path) as packed:
        assert packed.read("case.toml") == case.read_bytes()
        assert b"<html" in packed.read("report.html")[:400]
    bench.page.goto(own_server.start(path, command="view"))
    bench.wait_solved()
    assert bench.largest("largest settlement") == settlement
    bench.wait_seen(".result-status", "read-only")
    bench.wait_seen(".file-title", "slab-results.zip")
    assert bench.page.locator("button, a.button", has_text="Solve").count() == 0
    assert bench.page.locator(".model, .tool, textarea").count() == 0
    assert bench.export("report.html", tmp_path).name == "slab-results-report.html"
    assert bench.export("plan.dxf", tmp_path).name == "slab-results-settlement.dxf"


def test_a_folder_of_results_is_looked_at(own_server: Server, bench: Bench, case: Path, tmp_path: Path) -> None:
    """A folder shows picture, summary, certificate, values and section as the workbench does."""
    folder = groundslab.save_results(groundslab.solve(groundslab.load(case)), tmp_path / "slab-results")
    bench.page.goto(own_server.start(folder, command="view"))
    bench.wait_solved()
    tabs = bench.page.locator(".result").get_by_role("tab")
    assert {"Summary", "Values", "Section"} <= {each.split("\n")[0] for each in tabs.all_inner_texts()}
    tabs.filter(has_text="Certificate").click()
    bench.page.locator(".result .lower-panel:not([hidden])", has_text="certified").wait_for()
