"""The workbench in a real browser: drawing, typing, solving, saving, and losing nothing."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from helpers.browsing import Bench, Server, free_port

pytestmark = pytest.mark.slow


def test_a_drawn_slab_is_solved_saved_and_undone(server: Server, bench: Bench, tmp_path: Path) -> None:
    """A user who starts with nothing draws a slab and a loaded column, sees the settlement, saves, reloads, undoes."""
    bench.open(server.start(None))
    page = bench.page
    bench.tool("slab")
    bench.drag((-2.5, -1.5), (2.5, 1.5))
    bench.wait_text('outline = {kind = "rectangle", x = ["-2.5 m", "2.5 m"], y = ["-1.5 m", "1.5 m"]}')
    bench.tool("column")
    bench.click(1.0, 0.5)
    bench.wait_text("[[columns]]", 'name = "C1"', 'x = "1 m"', 'y = "0.5 m"')
    bench.tool("point load")
    bench.click(1.0, 0.5)
    bench.wait_text('column = "C1"')
    page.keyboard.press("Escape")
    bench.tab("Form")
    page.locator('[data-section="mesh"] > summary').click()
    bench.fill("0.5 m", "mesh", "size")
    bench.wait_text('size = "0.5 m"')
    bench.tab("Plan")
    bench.wait_solved()
    settlement = bench.largest("largest settlement")
    assert settlement > 0

    page.keyboard.press("Control+s")
    dialog = page.get_by_role("dialog")
    folder = dialog.get_by_label("folder", exact=True)
    bench.until(lambda: folder.input_value() != "")  # else its first content comes between selecting and typing
    folder.fill(str(tmp_path))
    folder.press("Enter")
    bench.until(lambda: folder.input_value() == str(tmp_path), lambda: f"{folder.input_value()}: {dialog.inner_text()}")
    dialog.get_by_label("Name").fill("drawn")
    dialog.get_by_role("button", name="Save").click()
    page.wait_for_selector(".file-title:has-text('drawn.toml')")
    bench.until(lambda: bench.seen(".unsaved") == "")
    saved = (tmp_path / "drawn.toml").read_text()
    assert 'name = "C1"' in saved

    page.reload()
    page.wait_for_selector(".drawing[data-view]")
    bench.until(lambda: bench.text() == saved)
    bench.wait_solved()
    assert bench.largest("largest settlement") == settlement

    undo = page.get_by_role("button", name="undo")
    while 'column = "C1"' in bench.text():
        before = bench.text()
        undo.click()
        bench.until(lambda before=before: bench.text() != before)
    bench.wait_text('name = "C1"')
    bench.until(lambda: bench.seen(".unsaved") == "● unsaved")


def test_a_drag_is_one_edit_in_the_unit_that_stood_there(server: Server, bench: Bench, case: Path) -> None:
    """Dragging a column, and an edge of the slab, changes these numbers only; each is one step of undo."""
    case.write_text(case.read_text().replace('x = "-2 m"', 'x = "-200 cm"  # axis 1'))
    bench.open(server.start(case, by_itself=False))
    before = bench.text()
    bench.drag((-2.0, 1.0), (-1.0, 0.5))
    bench.wait_text('x = "-100 cm"  # axis 1', 'y = "0.5 m"')
    bench.wait_seen(".last-edit", "move column A1")
    bench.page.keyboard.press("Escape")
    bench.click(2.9, 1.9)  # the slab
    bench.drag((3.0, 0.0), (3.5, 0.3))
    bench.wait_text('length_x = "7 m"')
    after = bench.text()
    expected = before.replace('"-200 cm"', '"-100 cm"').replace('y = "1 m"', 'y = "0.5 m"')
    assert after == expected.replace('length_x = "6 m"', 'length_x = "7 m"')
    for _ in range(2):
        bench.page.keyboard.press("Control+z")
    bench.until(lambda: bench.text() == before)


def test_corners_are_drawn_dragged_added_and_removed(server: Server, bench: Bench, case: Path) -> None:
    """A polygon is drawn corner by corner; its corners can be dragged, added on an edge and removed."""
    bench.open(server.start(case, by_itself=False))
    bench.tool("zone")
    for corner in ((0.5, -1.0), (2.5, -1.0), (2.5, 1.0)):
        bench.click(*corner)
    bench.page.keyboard.press("Enter")
    bench.wait_text('points = [["0.5 m", "-1 m"], ["2.5 m", "-1 m"], ["2.5 m", "1 m"]]', 'thickness = "400 mm"')
    bench.wait_seen(".properties h3", "zone 1")
    bench.drag((2.5, 1.0), (2.0, 1.5))
    bench.wait_text('["2 m", "1.5 m"]]')
    bench.drag((1.5, -1.0), (1.5, -1.5))
    bench.wait_text('["0.5 m", "-1 m"], ["1.5 m", "-1.5 m"], ["2.5 m", "-1 m"]')
    bench.click(1.5, -1.5)
    bench.page.keyboard.press("Delete")
    bench.wait_text('["0.5 m", "-1 m"], ["2.5 m", "-1 m"], ["2 m", "1.5 m"]]')
    bench.wait_seen(".last-edit", "remove a corner of zone 1")
    bench.page.keyboard.press("Delete")
    bench.until(lambda: "zones" not in bench.text())


def test_the_keyboard_alone_moves_and_removes(server: Server, bench: Bench, case: Path) -> None:
    """Things are selected, moved by steps and removed by keys; a row of steps is one edit."""
    bench.open(server.start(case, by_itself=False))
    drawing = bench.page.locator(".drawing")
    bench.step("n", "olumn A1")
    # one after the other without a pause, however busy the machine is
    drawing.evaluate(
        """(drawing) => {
          for (let i = 0; i < 3; i++) {
            drawing.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true, cancelable: true }));
          }
        }"""
    )
    bench.until(lambda: bench.seen(".last-edit") == "move column A1")
    moved = re.search(r'name = "A1"\nx = "(.*) m"', bench.text())
    assert moved is not None
    assert -2.0 < float(moved[1]) < 0.0
    drawing.press("Control+z")
    bench.wait_text('x = "-2 m"')
    bench.step("n", "olumn A1")
    drawing.press("Delete")
    bench.until(lambda: "[[columns]]" not in bench.text(), lambda: bench.seen(".properties h3"))
    bench.wait_seen(".last-edit", "remove column A1 and its load")


def test_a_wrong_unit_is_reported_at_its_field(server: Server, bench: Bench, case: Path) -> None:
    """What was typed stays in the text to the letter; field and list of errors say what is wrong and how to fix it."""
    bench.open(server.start(case))
    bench.wait_solved()
    bench.tab("Form")
    bench.fill("250 MPa", "plate", "thickness")
    message = bench.field("plate", "thickness").locator(".messages")
    message.filter(has_text="expected a length").wait_for()
    bench.until(lambda: '"MPa" is no unit of a length' in message.inner_text(), message.inner_text)
    bench.wait_text('thickness = "250 MPa"  # as on the drawing')
    bench.wait_seen(".issue-count", "1 error")
    bench.wait_seen(".status-words", "earlier version of the model")
    # from another view the list leads back to the field
    bench.tab("Text")
    bench.wait_seen(".line-issue", "expected a length")
    bench.tab("Plan")
    bench.page.locator(".issue-list summary").click()
    bench.page.locator(".issue-list li button").click()
    bench.fill("300 mm", "plate", "thickness")
    bench.wait_text('thickness = "300 mm"  # as on the drawing')
    bench.wait_solved()
    # all that was typed into one field in one go is one step
    bench.wait_seen(".issue-count", "No errors")


def test_broken_text_can_be_fixed_where_it_is_broken(server: Server, bench: Bench, case: Path) -> None:
    """While the text is no TOML, all else shows the last one that is, and says why, also once it is loaded again."""
    bench.open(server.start(case, by_itself=False))
    bench.tab("Text")
    area = bench.page.locator(".code-input")
    whole = area.input_value()
    area.fill(whole.replace("nu = 0.2", "nu = 0.2 0"))
    bench.page.wait_for_selector(".line-issue")
    bench.wait_seen(".code-gutter .bad", "8")
    for _ in range(2):
        bench.page.wait_for_selector(".broken:not([hidden])")
        assert bench.seen(".broken").startswith("The text cannot be read (line 8). All else shows the last text")
        bench.wait_equal(bench.page.locator('.drawing [data-kind="slab"]').count, 1)
        bench.wait_equal(bench.page.locator('.drawing [data-kind="column"]').count, 1)
        bench.page.reload()
    bench.tab("Text")
    area.fill(whole)
    bench.page.wait_for_selector(".broken", state="hidden")
    bench.wait_seen(".issue-count", "No errors")


def test_nothing_is_lost_when_the_server_dies(own_server: Server, tabs: Any, case: Path) -> None:
    """Killed while solving: edits made before are offered by a new server, edits made since are sent to it."""
    bench = tabs().open(own_server.start(case, free_port()))
    bench.wait_solved()
    bench.tab("Form")
    bench.page.locator('[data-section="mesh"] > summary').click()
    bench.fill("0.05 m", "mesh", "size")
    bench.page.wait_for_selector('.result-status[data-state="solving"]')
    own_server.kill()
    bench.page.wait_for_selector(".banner:not([hidden])")
    bench.fill("275 mm", "plate", "thickness")
    bench.until(lambda: "1 edit is kept here" in bench.seen(".banner"))
    assert 'size = "0.05 m"' not in case.read_text()

    port = own_server.port
    other = tabs()
    other.page.goto(own_server.start(case, port))
    for each in (bench, other):
        each.page.get_by_role("dialog").get_by_text("Restore unsaved work?").wait_for()
    bench.page.get_by_role("button", name="Restore").click()
    bench.wait_text('size = "0.05 m"', 'thickness = "275 mm"  # as on the drawing')
    bench.page.wait_for_selector(".banner", state="hidden")
    other.page.get_by_role("button", name="Restore").click()
    other.page.wait_for_selector(".drawing[data-view]")
    other.wait_text('size = "0.05 m"', 'thickness = "275 mm"  # as on the drawing')
    bench.page.locator(".solve.solving").click()
    bench.page.keyboard.press("Control+s")
    bench.until(lambda: bench.seen(".unsaved") == "")
    assert 'thickness = "275 mm"  # as on the drawing' in case.read_text()


def test_a_file_changed_by_others_is_replaced_only_when_asked(server: Server, bench: Bench, case: Path) -> None:
    """Saving over what another program has written needs a yes."""
    bench.open(server.start(case, by_itself=False))
    bench.fill("260 mm", "plate", "thickness")
    bench.wait_text('thickness = "260 mm"')
    case.write_text(case.read_text() + "# a colleague was here\n")
    theirs = case.read_text()
    bench.page.keyboard.press("Control+s")
    dialog = bench.page.get_by_role("dialog")
    dialog.get_by_role("button", name="Cancel").click()
    assert case.read_text() == theirs
    bench.page.keyboard.press("Control+s")
    dialog.get_by_role("button", name="Replace the file").click()
    bench.until(lambda: bench.seen(".unsaved") == "")
    assert 'thickness = "260 mm"' in case.read_text()


def test_two_tabs_show_the_same(server: Server, tabs: Any, case: Path) -> None:
    """An edit in one tab appears in the other, whose own edit of something else is not lost."""
    url = server.start(case, by_itself=False)
    one, two = tabs().open(url), tabs().open(url)
    one.fill("260 mm", "plate", "thickness")
    two.wait_text('thickness = "260 mm"')
    two.fill("31 GPa", "plate", "E")
    one.wait_text('E = "31 GPa"', 'thickness = "260 mm"')


def test_the_result_is_read_at_places_and_along_lines(server: Server, bench: Bench, case: Path) -> None:
    """Pick and section show values; zoom, field and combination stay when the model is solved again."""
    bench.open(server.start(case))
    bench.wait_solved()
    page = bench.page
    page.locator(".field-choice").select_option("moment_x")
    plan = page.locator(".gs-plan")
    plan.focus()
    plan.press("+")
    box = plan.bounding_box()
    page.mouse.click(box["x"] + box["width"] * 0.5, box["y"] + box["height"] * 0.45)
    page.locator(".value-box .gs-values-at").wait_for()
    page.locator(".stage-bar").get_by_role("button", name="Section").click()
    for share in (0.3, 0.7):
        page.mouse.click(box["x"] + box["width"] * share, box["y"] + box["height"] * 0.5)
    bench.wait_seen(".gs-chart-title", "along")
    page.locator(".section-box canvas").first.wait_for()
    place = page.locator(".value-box .gs-values-at").text_content()
    with page.expect_response(lambda answer: "/scene" in answer.url):
        bench.fill("400 mm", "plate", "thickness")
    bench.wait_solved()
    bench.wait_equal(page.locator(".field-choice").input_value, "moment_x")
    bench.wait_equal(page.locator(".value-box .gs-values-at").text_content, place)
    page.locator(".stage-bar").get_by_role("button", name="3-D").click()
    page.locator(".gs-space canvas").wait_for()


def test_the_plan_is_read_before_the_browser_has_told_its_size(server: Server, bench: Bench, case: Path) -> None:
    """On a busy machine a key and a click come before the browser reports the size of the plan; they miss nothing."""
    late = "super((...seen) => setTimeout(() => notify(...seen), 3000))"
    observer = f"class extends ResizeObserver {{ constructor(notify) {{ {late}; }} }}"
    bench.page.add_init_script(f"window.ResizeObserver = {observer};")
    bench.open(server.start(case))
    bench.wait_solved()
    plan = bench.page.locator(".gs-plan")
    plan.press("+")
    plan.click()
    bench.wait_seen(".value-box", "all loads")
    assert "not on the plate" not in bench.seen(".value-box")


def test_the_mesh_is_drawn_over_the_field(server: Server, bench: Bench, case: Path) -> None:
    """One button draws the elements in plan and in space; the discretization error is among the fields."""
    bench.open(server.start(case))
    page = bench.page
    bench.wait_solved()
    scale = bench.seen(".gs-scale")
    page.locator(".field-choice").select_option("discretization_error")
    bench.until(lambda: bench.seen(".gs-scale") != scale)
    toggle = page.locator(".stage-bar").get_by_role("button", name="Mesh")
    for mode, view in (("Plan", ".gs-plan"), ("3-D", ".gs-space")):
        page.locator(".stage-bar").get_by_role("button", name=mode).click()
        picture = page.locator(f"{view} canvas")
        picture.wait_for()
        without = bench.still(picture)
        toggle.click()
        bench.wait_equal(lambda: toggle.get_attribute("aria-pressed"), "true")
        bench.until(lambda picture=picture, without=without: picture.screenshot() != without)
        toggle.click()
        bench.until(lambda picture=picture, without=without: picture.screenshot() == without)


def test_the_ground_becomes_a_continuum(server: Server, bench: Bench, case: Path) -> None:
    """Another kind is chosen, filled in and solved, a value of it changed; springs with their zone come back."""
    zone = '[[soil_zones]]\nshape = {kind = "rectangle", x = ["0 m", "3 m"], y = ["-2 m", "2 m"]}\n'
    case.write_text(case.read_text() + zone + 'ground = {kind = "winkler", k = "30 MPa/m"}\n')
    bench.open(server.start(case))
    bench.wait_solved()
    springs = bench.largest("largest settlement")
    bench.tab("Form")
    choice = bench.field("ground", "kind").locator("select")
    choice.select_option(label="continuum")
    bench.wait_text('kind = "continuum"', 'half_space = {E = "60 MPa", nu = 0.3}')
    assert "soil_zones" not in bench.text()
    bench.wait_equal(bench.page.locator(".layers rect").count, 2)
    bench.wait_solved()
    bench.until(lambda: bench.largest("largest settlement") != springs)
    summary = bench.page.locator(".result")
    for words in ("bonded elastic layers", "half-space", "cells of pressure under the plate"):
        summary.get_by_text(words).first.wait_for()
    settlement = bench.largest("largest settlement")
    bench.fill("600 MPa", "ground", "half_space", "E")
    bench.wait_text('E = "600 MPa"')
    bench.wait_solved()
    bench.until(lambda: bench.largest("largest settlement") < settlement)
    choice.select_option(label="winkler")
    bench.wait_text('k = "20 MPa/m"', "[[soil_zones]]", 'k = "30 MPa/m"')
    bench.wait_solved()
    bench.until(lambda: bench.largest("largest settlement") == springs)


def test_a_refused_combination_tells_why(server: Server, bench: Bench, case: Path) -> None:
    """A plate that is pulled off the ground has no solution: its reason stands in place of a picture."""
    case.write_text(case.read_text().replace('P = "200 kN"', 'P = "-200 kN"'))
    bench.open(server.start(case))
    bench.page.wait_for_selector(".refused-over:not([hidden])")
    bench.wait_seen(".refused-over", "do not press the plate down")


def test_the_report_is_saved_and_its_tools_work(own_server: Server, bench: Bench, case: Path, tmp_path: Path) -> None:
    """The report is one file that shows values at picked points and along sections without a server."""
    bench.open(own_server.start(case))
    bench.wait_solved()
    report = bench.export("report.html", tmp_path)
    own_server.stop()
    page = bench.page
    page.goto(report.as_uri())
    plan = page.locator(".gs-plan")
    plan.scroll_into_view_if_needed()
    box = plan.bounding_box()
    page.locator(".gs-viewer").get_by_role("button", name="Pick").click()
    page.mouse.click(box["x"] + box["width"] * 0.45, box["y"] + box["height"] * 0.4)
    page.locator(".gs-values-at").wait_for()
    page.locator(".gs-viewer").get_by_role("button", name="Section", exact=True).click()
    plan.scroll_into_view_if_needed()
    box = plan.bounding_box()
    for share in (0.3, 0.7):
        page.mouse.click(box["x"] + box["width"] * share, box["y"] + box["height"] * 0.5)
    page.locator(".gs-chart canvas").first.wait_for()


def test_autosolve_is_switched_once(server: Server, bench: Bench, case: Path) -> None:
    """A click on the switch is one request, although commands send first what the field with the focus holds."""
    bench.open(server.start(case))
    requests: list[str] = []
    bench.page.on("request", lambda request: requests.append(request.url) if "autosolve" in request.url else None)
    with bench.page.expect_response("**/api/autosolve"):
        bench.page.locator(".switch").click()
    bench.page.wait_for_function("() => !document.querySelector('.switch input').checked")
    with bench.page.expect_response("**/api/autosolve"):
        bench.page.locator(".switch").click()
    assert len(requests) == 2


def test_closed_lines_are_no_areas(server: Server, bench: Bench, case: Path) -> None:
    """A line load and a line support that end where they begin are drawn as lines; an area load is filled."""
    square = '[["0 m", "-1 m"], ["1 m", "-1 m"], ["1 m", "0 m"], ["0 m", "-1 m"]]'
    wall = f'[[loads]]\nkind = "line"\nq = "20 kN/m"\npoints = {square}\n'
    support = f'[[supports]]\nkind = "line"\nname = "W"\nstiffness = "10 MN/m^2"\npoints = {square}\n'
    area = '[[loads]]\nkind = "patch"\nq = "5 kPa"\nx = ["1 m", "2 m"]\ny = ["0 m", "1 m"]\n'
    case.write_text(f"{case.read_text()}\n{wall}\n{area}\n{support}")
    bench.open(server.start(case, by_itself=False))
    paths = ['["loads",1]', '["supports",0]', '["loads",2]']
    symbols = [f".drawing .symbol[data-path='{path}'] path" for path in paths]
    bench.page.locator(symbols[-1]).wait_for(state="attached")
    # all at once: a symbol that the next frame draws anew has no style any more
    fills = "symbols => symbols.map(symbol => getComputedStyle(document.querySelector(symbol)).fill)"
    drawn = bench.page.evaluate(fills, symbols)
    assert drawn[:2] == ["none", "none"]
    assert drawn[2] != "none"
