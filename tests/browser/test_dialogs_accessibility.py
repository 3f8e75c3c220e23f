"""The rules of axe-core on what opens over the workbench's page or in it: tools, actions, dialogs, banners, lists."""

from __future__ import annotations

from pathlib import Path

import ezdxf
import pytest

from helpers.accessibility import find_violations, needs_axe
from helpers.browsing import SMALL, Bench, Server
from helpers.reactions import ETABS, write_case, write_table

pytestmark = [pytest.mark.slow, needs_axe]

DESIGN = """
[[cases]]
name = "dead"

[[cases]]
name = "live"
action = "variable"

[[combinations]]
name = "by hand"
limit_state = "ultimate"
factors = { dead = 1.35 }

[[loads]]
kind = "uniform"
case = "live"
q = "2 kPa"

[reinforcement]
concrete = "C30/37"
steel = "B500B"
bottom = ["40 mm", "50 mm"]
top = ["40 mm", "50 mm"]
"""
CASED = SMALL.replace('column = "A1"', 'column = "A1"\ncase = "dead"') + DESIGN
KINDS = ".action-dialog select:visible"


def _check_choices(bench: Bench) -> None:
    """Check the dialog of an action or a generator, with each of its choices, which have the colors of the first."""
    found = find_violations(bench.page, ".properties")
    for select in bench.page.locator(KINDS).all():
        for value in select.locator("option").evaluate_all("(all) => all.map(({ value }) => value)")[1:]:
            select.select_option(value)
            found += find_violations(bench.page, ".action-dialog", themes=["light"])
    assert found == []


def _open(bench: Bench, name: str) -> None:
    """Choose a file in the dialog for opening."""
    bench.page.keyboard.press("Control+o")
    bench.page.get_by_role("option", name=name).dblclick()


def _check_dialog(bench: Bench) -> None:
    """Check the dialog that is open."""
    bench.page.locator("dialog[open]").wait_for()
    assert find_violations(bench.page, "dialog[open]") == []


def test_tools_and_generators(server: Server, bench: Bench, case: Path) -> None:
    """The tools, and whatever dialog one of them opens, with each of its choices."""
    bench.open(server.start(case, by_itself=False))
    names = bench.page.locator(".tool[data-tool]").evaluate_all("(all) => all.map((each) => each.dataset.tool)")
    dialogs = []
    for name in names:
        if bench.page.locator(f'.tool[data-tool="{name}"]').is_disabled():
            continue
        bench.tool(name)
        if bench.page.locator(".action-dialog").is_visible():
            dialogs.append(name)
            _check_choices(bench)
            bench.page.keyboard.press("Escape")
    assert find_violations(bench.page, ".plan-editor") == []
    assert len(names) > len(dialogs) > 3


def test_actions_on_a_selection(server: Server, bench: Bench, case: Path) -> None:
    """The properties of each item, of all at once, and every dialog of an action, with each of its choices."""
    bench.open(server.start(case, by_itself=False))
    drawing = bench.page.locator(".drawing")
    for words in ("load", "column"):
        bench.step("n", words)
        assert find_violations(bench.page, ".properties") == []
    names = bench.page.locator(".property-acts button:enabled", has_text="…").all_inner_texts()
    assert len(names) > 3
    for name in names:
        bench.page.locator(".property-acts").get_by_role("button", name=name).click()
        bench.page.locator(".action-dialog").wait_for()
        _check_choices(bench)
        bench.page.keyboard.press("Escape")
    drawing.press("Control+a")
    bench.wait_seen(".properties h3", "selected")
    assert find_violations(bench.page, ".properties") == []
    bench.page.get_by_role("button", name="+ case").click()
    assert find_violations(bench.page, ".drawing-corner") == []


def test_files_that_are_opened(server: Server, bench: Bench, tmp_path: Path) -> None:
    """The dialogs of a drawing, a table of reactions, and what is reported then."""
    case = write_case(tmp_path)
    write_table(tmp_path, ETABS.replace(",Q,", ",LIVE,"))
    document = ezdxf.new("R2010", units=4)
    document.modelspace().add_lwpolyline([(0, 0), (9000, 0), (9000, 6000), (0, 6000)], close=True)
    document.saveas(tmp_path / "floor.dxf")
    bench.open(server.start(case, by_itself=False))
    _open(bench, "reactions.csv")
    bench.wait_seen(".reactions-dialog .messages", 'load case "LIVE"')
    _check_dialog(bench)
    bench.page.locator(".reactions-dialog").get_by_label("new load cases").fill("LIVE = B")
    bench.page.locator(".reactions-dialog").get_by_label("supports with another name").fill("101 = A\n102 = B")
    bench.page.locator(".reactions-dialog").get_by_role("button", name="Show changes").click()
    bench.wait_seen(".reactions-found", "new: A in G")
    _check_dialog(bench)
    bench.page.keyboard.press("Escape")
    _open(bench, "floor.dxf")
    bench.page.locator(".drawing-dialog").wait_for()
    _check_dialog(bench)
    bench.page.get_by_label("content of layer 0").select_option("outline")
    bench.page.locator(".drawing-dialog").get_by_role("button", name="Create case").click()
    bench.page.locator(".drawing-report").wait_for()
    _check_dialog(bench)


def test_slabs_of_other_programs(server: Server, bench: Bench, case: Path, tmp_path: Path) -> None:
    """The dialogs that choose a slab of a building and of a SAF file."""
    pytest.importorskip("ifcopenshell")
    pytest.importorskip("openpyxl")
    from helpers.ifc_files import Building, turned

    house = Building("mm")
    for name, height in (("Raft", 0), ("Floor", 3.3)):
        house.slab(name, place=turned(0, z=height))
    house.write(tmp_path / "house.ifc")
    bench.open(server.start(case, by_itself=False))
    _open(bench, "house.ifc")
    bench.page.locator(".slab-dialog").wait_for()
    _check_dialog(bench)
    bench.page.keyboard.press("Escape")
    bench.page.locator(".slab-dialog").wait_for(state="detached")
    bench.export("saf.xlsx", tmp_path)
    _check_dialog(bench)  # what the file does not hold
    bench.page.keyboard.press("Escape")
    (saf,) = tmp_path.glob("*saf.xlsx")
    _open(bench, saf.name)
    bench.page.locator(".slab-dialog").wait_for()
    _check_dialog(bench)


def test_dialogs_of_the_top_bar(server: Server, bench: Bench, case: Path) -> None:
    """New, save as and the question before a file is replaced; the tour, whose steps differ in their words alone."""
    bench.open(server.start(case, by_itself=False))
    (case.parent / "other.toml").write_text(SMALL)
    bench.page.keyboard.press("Control+Shift+S")
    _check_dialog(bench)
    bench.page.locator(".file-name input").fill("other.toml")
    bench.until(lambda: bench.page.get_by_role("option", name="other.toml").count() == 1)
    bench.page.locator(".file-dialog").get_by_role("button", name="Save").click()
    bench.page.locator("dialog.ask").wait_for()
    assert find_violations(bench.page, "dialog.ask") == []
    bench.page.keyboard.press("Escape")
    bench.page.keyboard.press("Escape")
    bench.page.get_by_role("button", name="New", exact=True).click()
    _check_dialog(bench)
    bench.page.keyboard.press("Escape")
    bench.page.locator(".drawing").press("?")
    bench.page.get_by_role("button", name="Tour").click()
    _check_dialog(bench)
    steps = 0
    while bench.page.locator("dialog.tour[open]").count() > 0:
        bench.page.locator("dialog.tour .answers .main").click()
        steps += 1
    assert steps == 5


def test_a_file_changed_elsewhere(server: Server, bench: Bench, case: Path) -> None:
    """The banner that says so, the difference of both texts, and errors with their repairs."""
    bench.open(server.start(case, by_itself=False))
    case.write_text(SMALL.replace("250 mm", "400 mm"))
    bench.wait_seen(".changed-file:visible", "Another program has changed the file.")
    assert find_violations(bench.page, ".changed-file") == []
    bench.page.get_by_role("button", name="Show difference").click()
    _check_dialog(bench)
    bench.page.keyboard.press("Escape")
    bench.page.locator(".changed-file:visible").get_by_role("button", name="Keep mine").click()
    bench.tab("Text")
    bench.page.locator(".code-input").fill(SMALL.replace("length_x", "lenght_x"))
    bench.page.locator(".issue-list.bad > summary").click()
    bench.page.locator(".issue-list .repairs button").first.wait_for()
    assert find_violations(bench.page, ".model") == []


def test_cases_combinations_and_alternatives(server: Server, bench: Bench, case: Path) -> None:
    """Load cases with a fault, the matrix of combinations, the help on a field, and the tab of alternatives."""
    case.write_text(CASED)
    bench.open(server.start(case))
    bench.tab("Load cases")
    bench.page.locator(".case-notes.flagged").first.wait_for()
    bench.page.get_by_label("limit state shown").select_option("ultimate")
    bench.page.get_by_label("name of combination 1").wait_for()
    assert find_violations(bench.page, ".model") == []
    bench.tab("Plan")
    bench.field("plate", "thickness").locator("input").focus()
    bench.page.locator(".field-help:visible").wait_for()
    assert find_violations(bench.page, ".model") == []
    bench.page.wait_for_selector('.result[aria-busy="false"] .result-full:not([hidden])')
    bench.page.locator(".result").get_by_role("tab", name="Alternatives").click()
    assert find_violations(bench.page, ".result") == []
