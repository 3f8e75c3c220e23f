"""A raft from an empty case to its report without a mouse; the focus is seen after every key, and never lost."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from helpers.browsing import Bench, Server
from helpers.keyboard import Keys

pytestmark = pytest.mark.slow

OUTLINE = ("0;0", "12;0", "12;6", "6;6", "6;12", "0;12")
SOLVED = '.result-status:is([data-state="fresh"], [data-state="failing"])'
MOST = 500


def _field(path: str, tag: str = "input") -> str:
    """Return the selector of a field by the keys of its value."""
    keys = ",".join(key if key.isdigit() else f'"{key}"' for key in path.split("."))
    return f"[data-path='[{keys}]'] {tag}"


def _data(bench: Bench) -> dict[str, Any]:
    return tomllib.loads(bench.text())


def _tab(keys: Keys, name: str) -> None:
    """Go to another view of the model."""
    while not keys.has(".model *"):
        keys.press("Shift+F6")
    keys.to('.model [role="tab"]', "Shift+Tab")
    labels = keys.bench.page.locator('.model [role="tab"]').all_text_contents()
    now = keys.bench.page.locator('.model [role="tab"][aria-selected="true"]').text_content()
    steps = labels.index(name) - labels.index(str(now))
    keys.press(*(["ArrowRight"] * steps or ["ArrowLeft"] * -steps))


def _unfold(keys: Keys, section: str, control: str) -> None:
    """Open a section of the form, and go to a control in it."""
    keys.to(f'[data-section="{section}"] > summary')
    keys.press("Enter")
    keys.bench.page.locator(control).first.wait_for()
    keys.to(control)


def _wait_solved(bench: Bench) -> None:
    """Wait until a result of the present model is shown, whatever its checks say."""
    bench.page.wait_for_selector(SOLVED)
    bench.page.wait_for_selector('.result[aria-busy="false"] .result-full:not([hidden])')


def _draw_outline(keys: Keys) -> None:
    keys.to(".drawing")
    keys.press("b")
    for corner in OUTLINE:
        keys.type(corner)
        keys.press("Enter")
    keys.press("Enter")
    keys.bench.until(lambda: len(_data(keys.bench)["plate"].get("outline", {}).get("points", [])) == len(OUTLINE))
    keys.to(_field("plate.thickness"))
    keys.enter("500 mm")
    keys.to(_field("plate.E"))
    keys.enter("33 GPa")


def _choose_ground(keys: Keys) -> None:
    _tab(keys, "Form")
    keys.choose(_field("ground.kind", "select"), "Winkler")
    _unfold(keys, "mesh", _field("mesh.size"))
    keys.enter("1 m")


def _add_cases(keys: Keys) -> None:
    _tab(keys, "Load cases")
    name, kind = '[aria-label="name of a new case"]', '[aria-label="type of a new case"]'
    keys.to(name)
    keys.type("dead")
    keys.press("Enter")
    keys.choose(kind, "B")
    keys.to(name, "Shift+Tab")
    keys.type("live")
    keys.press("Enter")
    keys.choose('[aria-label="how combinations are made"]', "6.10")
    keys.bench.until(lambda: [each["name"] for each in _data(keys.bench)["cases"]] == ["dead", "live"])


def _add_columns_and_load(keys: Keys) -> None:
    _tab(keys, "Plan")
    keys.to(".drawing")
    keys.press("d")
    for name, value in {"x": "1", "y": "1", "spacing_x": "2x4.5", "spacing_y": "2x4.5", "P": "800"}.items():
        keys.to(f"[name={name}]")
        keys.type(value)
    keys.press("Enter")
    assert keys.has(".drawing")  # after the dialog
    keys.choose('[aria-label="highlighted load case"]', "live")
    keys.to(".drawing", "Shift+Tab")
    keys.press("l")
    for end in ("0.5;3", "11.5;3"):
        keys.type(end)
        keys.press("Enter")
    keys.press("Enter")
    keys.to(_field("loads.9.q"))
    keys.enter("60 kN/m")


def _add_reinforcement_and_solve(keys: Keys) -> None:
    _tab(keys, "Form")
    _unfold(keys, "reinforcement", '[data-section="reinforcement"] button:not([hidden])')
    keys.press("Enter")
    assert keys.has('[data-section="reinforcement"] .section-body :is(input, select)')  # the button is gone
    keys.bench.until(lambda: "reinforcement" in _data(keys.bench))
    keys.press("F9")
    _wait_solved(keys.bench)


def _read_results(keys: Keys) -> None:
    keys.press("F6")
    keys.to('.result [role="tab"]')
    while not keys.bench.page.evaluate("() => document.activeElement.textContent.startsWith('Checks')"):
        keys.press("ArrowRight")
    rows = keys.bench.page.locator(".table-box:not([hidden]) tr[data-place]")
    rows.first.wait_for()
    keys.to(".table-box:not([hidden]) .table-scroller")
    keys.press("ArrowDown", "ArrowDown")
    assert rows.nth(1).get_attribute("aria-selected") == "true"


def _move_a_column(keys: Keys) -> None:
    """Select the first column, move it to the right, undo and redo that, and solve."""
    bench = keys.bench
    _tab(keys, "Plan")
    keys.to(".drawing")
    while "A1" not in bench.seen(".properties h3"):
        keys.press("n")
    before = _data(bench)
    keys.press("ArrowRight", "ArrowRight")
    bench.until(lambda: _data(bench) != before)
    moved = _data(bench)
    assert [each["name"] for old, each in zip(before["columns"], moved["columns"], strict=True) if old != each] == [
        "A1"
    ]
    keys.press("Control+z")
    bench.until(lambda: _data(bench) == before)
    keys.press("Control+y")
    bench.until(lambda: _data(bench) == moved)
    keys.press("F9")


def _export(keys: Keys, folder: Path) -> Path:
    bench = keys.bench
    _wait_solved(bench)
    keys.press("Shift+F6")
    keys.to("button.export", "Shift+Tab")
    keys.press("Enter")
    bench.page.get_by_role("dialog", name="Export").wait_for()
    with bench.page.expect_download() as download:
        keys.press("Enter")  # the report is what is offered first
    path = folder / download.value.suggested_filename
    download.value.save_as(path)
    assert keys.has("button.export")
    return path


def test_a_focus_that_is_not_seen_is_found(bench: Bench) -> None:
    """A focus that looks like none, is covered or is lost counts as a fault, so that finding none means something."""
    bench.page.set_content("""<button style="outline: none">plain</button><button id="under">under</button>
        <div style="position: fixed; inset: 0"></div><button id="last" onclick="this.remove()">last</button>""")
    keys = Keys(bench)
    keys.press("Tab", "Tab", "Tab", "Enter")
    faults = "\n".join(keys.faults)
    assert "the focus of button.  plain is not seen" in faults
    assert "button.  under has the focus out of view" in faults
    assert "nothing has the focus, before that button.  last" in faults


def test_a_raft_by_keys(server: Server, bench: Bench, tmp_path: Path) -> None:
    """An L on springs, columns, a line load, two cases, bars: drawn, solved, read, changed and exported by keys."""
    bench.open(server.start(None))
    keys = Keys(bench)
    keys.to("#autosolve")
    keys.press("Space")
    _draw_outline(keys)
    _choose_ground(keys)
    _add_cases(keys)
    _add_columns_and_load(keys)
    _add_reinforcement_and_solve(keys)
    _read_results(keys)
    _move_a_column(keys)
    report = _export(keys, tmp_path)
    print(f"keys pressed for a raft: {keys.presses}")
    assert keys.faults == []
    assert keys.presses <= MOST
    data = _data(bench)
    assert (data["plate"]["thickness"], data["plate"]["E"]) == ("500 mm", "33 GPa")
    assert [(load["case"], load.get("q")) for load in data["loads"]] == [*[("dead", None)] * 9, ("live", "60 kN/m")]
    assert len(data["columns"]) == 8
    assert "A1" in report.read_text(encoding="utf-8")
