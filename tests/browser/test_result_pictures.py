"""Pictures of results in a real browser: differences, and what is written beside supports, walls and bars."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.browsing import Bench, Server
from helpers.two_combinations import open_two

pytestmark = pytest.mark.slow

#: A load on the entire slab, in the case of both combinations.
WEIGHT = """
[[loads]]
case = "G"
kind = "uniform"
q = "100 kPa"
"""


def test_a_combination_and_a_reference_are_subtracted(server: Server, bench: Bench, case: Path, tmp_path: Path) -> None:
    """10 kPa on 20 MPa/m settle 0.5 mm; the picture says what minus what, is exported, and follows edits."""
    open_two(server, bench, case, WEIGHT)
    page = bench.page
    minus, label = page.get_by_label("Minus", exact=True), page.locator(".difference-over")
    assert label.is_hidden()
    minus.select_option("combination light")
    bench.wait_equal(label.inner_text, "1 heavy minus 2 light")
    notes = page.locator(".gs-legend-notes").first
    bench.until(lambda: "max 0.500" in notes.inner_text(), notes.inner_text)
    assert "[mm]" in page.locator(".gs-legend-title").first.inner_text()
    drawn = bench.export("plan.svg", tmp_path)
    assert drawn.name.endswith("-settlement-difference.svg")
    page.get_by_role("button", name="Keep as reference").click()
    minus.locator("option", has_text="minus the reference").wait_for(state="attached")
    minus.select_option("reference")
    bench.wait_equal(label.inner_text, "1 heavy minus the reference")
    bench.until(lambda: "max 0\n" in notes.inner_text(), notes.inner_text)
    bench.tab("Text")
    page.locator(".code-input").fill(bench.text().replace('k = "20 MPa/m"', 'k = "40 MPa/m"'))
    bench.until(lambda: "min \N{MINUS SIGN}" in notes.inner_text(), notes.inner_text)
    assert label.inner_text() == "1 heavy minus the reference"
    minus.select_option("")
    bench.until(label.is_hidden)


MORE = """
[[loads]]
case = "G"
kind = "uniform"
q = "20 kPa"

[[supports]]
kind = "point"
name = "P1"
x = "1 m"
y = "-1 m"
stiffness = "30 MN/m"

[[supports]]
kind = "line"
name = "W"
points = [["-2.5 m", "-1.5 m"], ["0 m", "-1.5 m"]]
stiffness = "20 MN/m^2"

[[walls]]
name = "inner"
points = [["0 m", "1.5 m"], ["2.5 m", "1.5 m"]]
thickness = "200 mm"

[[loads]]
case = "G"
kind = "line"
wall = "inner"
q = "80 kN/m"

[[cases]]
name = "G"

[[combinations]]
name = "ULS"
limit_state = "ultimate"
factors = {G = 1.5}

[[combinations]]
name = "SLS"
limit_state = "characteristic"
factors = {G = 1.0}

[reinforcement]
f_ck = "30 MPa"
f_yk = "500 MPa"
bottom = ["46 mm", "58 mm"]
top = ["46 mm", "58 mm"]
bottom_x = { diameter = "12 mm", spacing = "150 mm" }
bottom_y = { diameter = "12 mm", spacing = "150 mm" }
top_x = { diameter = "12 mm", spacing = "150 mm" }
top_y = { diameter = "12 mm", spacing = "150 mm" }

[[reinforcement.zones]]
name = "Z1"
layers = ["bottom_x"]
diameter = "16 mm"
spacing = "100 mm"
shape = { kind = "rectangle", x = ["-2.6 m", "-1.2 m"], y = ["0.3 m", "1.8 m"] }
"""


def test_reactions_and_bars_are_written_where_they_belong(server: Server, bench: Bench, case: Path) -> None:
    """A wall of 2.5 m presses with 1.5 and 1.0 times 80 kN/m; bars are written over fields of their layer."""
    case.write_text(case.read_text().replace('column = "A1"\nP', 'case = "G"\ncolumn = "A1"\nP') + MORE)
    bench.open(server.start(case))
    bench.wait_solved()
    page = bench.page
    reactions = page.locator(".result .gs-overlay .reaction .label")
    bars = page.locator(".result .gs-overlay .symbol.bars .label")
    wall = "\N{DOWNWARDS ARROW} 300 kN, max 120 kN/m"
    bench.until(lambda: wall in reactions.all_text_contents(), lambda: str(reactions.all_text_contents()))
    assert [text[0] for text in reactions.all_text_contents()].count("\N{UPWARDS ARROW}") == 2
    choice = page.locator(".stage-bar .combination-choice")
    choice.select_option(label="2 SLS")
    wall = "\N{DOWNWARDS ARROW} 200 kN, max 80 kN/m"
    bench.until(lambda: wall in reactions.all_text_contents(), lambda: str(reactions.all_text_contents()))
    switches = page.locator(".stage-bar")
    assert switches.get_by_role("button", name="Bars").is_disabled()
    fields = page.locator(".stage-bar .field-choice")
    fields.select_option("required_bottom_x")
    bench.wait_equal(lambda: sorted(bars.all_text_contents()), ["ø12 / 150", "ø16 / 100"])
    fields.select_option("required_top_y")
    bench.wait_equal(bars.all_text_contents, ["ø12 / 150"])
    switches.get_by_role("button", name="Bars").click()
    bench.wait_equal(bars.count, 0)
    switches.get_by_role("button", name="Reactions").click()
    bench.wait_equal(reactions.count, 0)


def test_a_section_that_is_dragged_sideways_is_a_strip(server: Server, bench: Bench, case: Path) -> None:
    """The chart is of the mean over the width, which the strip that is added to the case has."""
    bench.open(server.start(case))
    bench.wait_solved()
    page = bench.page
    page.locator(".stage-bar").get_by_role("button", name="Section", exact=True).click()
    box = page.locator(".result .gs-plan").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    title = page.locator(".chart-bar .gs-chart-title")
    page.mouse.move(x - 60, y)
    page.mouse.down()
    page.mouse.move(x, y, steps=3)
    page.mouse.move(x + 60, y, steps=3)
    page.mouse.up()
    bench.until(lambda: " to (" in title.inner_text(), title.inner_text)
    page.mouse.move(x + 10, y)
    page.mouse.down()
    page.mouse.move(x + 12, y + 15, steps=3)
    page.mouse.move(x + 14, y + 30, steps=3)
    page.mouse.up()
    bench.until(lambda: "mean over a width of" in title.inner_text(), title.inner_text)
    assert page.locator(".gs-overlay .cut > .area").count() == 1
    width = title.inner_text().split("width of ")[1]
    assert page.get_by_label("Width of the strip").input_value() == width
    page.get_by_role("button", name="Add strip").click()
    bench.tab("Text")
    bench.wait_text("[[output.strips]]", f'width = "{width}"')
