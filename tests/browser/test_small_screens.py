"""The workbench on the screens of laptops: rows in view, nothing cut, nothing covered, dialogs that fit."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from groundslab.languages.catalogue import messages
from helpers.browsing import Bench, Server, free_port
from helpers.paths import ROOT
from helpers.reactions import ETABS, write_case, write_table

pytestmark = pytest.mark.slow
LAPTOP = (1366, 768)
LOW = (1280, 650)
LARGE = (1920, 1080)

#: The rows of the table that are wholly in view and covered by nothing.
WHOLE_ROWS = """() => {
  const scroller = [...document.querySelectorAll(".table-scroller")].find((each) => each.checkVisibility());
  const { left, bottom } = scroller.getBoundingClientRect();
  const top = scroller.querySelector("thead").getBoundingClientRect().bottom;
  return [...scroller.querySelectorAll("tbody tr[data-place]")].filter((row) => {
    const box = row.getBoundingClientRect();
    const middle = left + scroller.clientWidth / 2;
    const seen = [box.top + 1, box.bottom - 1].map((y) => document.elementFromPoint(middle, y));
    return box.top >= top && box.bottom <= Math.min(bottom, innerHeight) && seen.every((each) => row.contains(each));
  }).length;
}"""
#: Words that are cut: of an element that hides what is beyond it, of lists of choices; a title says all of them.
CUT = """() => {
  const cut = [];
  const isHidden = (each) =>
    !each.checkVisibility({ visibilityProperty: true }) || each.closest("svg, .unseen, .code, dialog");
  const choices = [...document.querySelectorAll("select")].filter((each) => !isHidden(each));
  const copies = choices.map((each) => {
    const copy = each.cloneNode(false);
    copy.append(each.selectedOptions[0]?.cloneNode(true) ?? "");
    for (const [name, value] of Object.entries({ position: "absolute", width: "max-content", "min-width": "0",
      "max-width": "none" })) copy.style.setProperty(name, value, "important");
    return copy;
  });
  // all at once, so that the page is laid out once
  choices.forEach((each, n) => each.after(copies[n]));
  choices.forEach((each, n) => {
    if (copies[n].offsetWidth > each.offsetWidth + 1) cut.push(`select: ${copies[n].textContent}`);
  });
  for (const copy of copies) copy.remove();
  for (const each of document.querySelectorAll("body *:not(option)")) {
    if (isHidden(each)) continue;
    const range = document.createRange();
    for (const node of each.childNodes) {
      if (node.nodeType !== Node.TEXT_NODE || !node.data.trim()) continue;
      range.selectNodeContents(node);
      const words = range.getBoundingClientRect();
      for (let box = each; words.width > 0 && box; box = box.parentElement) {
        const { overflowX, clipPath } = getComputedStyle(box);
        if (["auto", "scroll"].includes(overflowX) || clipPath !== "none") break;
        if (overflowX === "visible") continue;
        const { left, top, right, bottom } = box.getBoundingClientRect();
        const [isWide, isHigh] = [words.left < left - 1 || words.right > right + 1, words.bottom > bottom + 2];
        const isTitled = each.closest("[title]") && !each.closest(BARS);
        if ((isWide || isHigh) && !isTitled) cut.push(`${each.className}: ${node.data}`);
        break;
      }
    }
  }
  for (const bar of document.querySelectorAll(BARS))
    if (bar.scrollWidth > bar.clientWidth) cut.push(`${bar.className} is too wide`);
  return cut;
}""".replace("BARS", '".accuracy, .stage-bar, .banner, .top button, .switch"')
#: What of the tabs is not as it should be: the chosen one in view, arrows at the ends beyond which there are more.
TABS = """(bar) => {
  const list = bar.querySelector("[role=tablist]");
  const [view, tab] = [list, list.querySelector("[aria-selected=true]")].map((each) => each.getBoundingClientRect());
  const arrows = [".start", ".end"].map((name) => bar.querySelector(name));
  const [start, end] = arrows.map((each) => (each.hidden ? 0 : each.getBoundingClientRect().width));
  const wrong = [];
  if (tab.left < view.left + start - 1 || tab.right > view.right - end + 1) wrong.push("the chosen tab is not in view");
  if (start > 0 !== list.scrollLeft >= 1) wrong.push("start");
  if (end > 0 !== list.scrollLeft + list.clientWidth < list.scrollWidth - 1) wrong.push("end");
  return wrong;
}"""
#: How far the tabs are scrolled, after all that has brought this about.
SETTLED = """async (list) => {
  for (let n = 0; n < 3; n++) await new Promise(requestAnimationFrame);
  return list.scrollLeft;
}"""
#: Elements that overlap some others, as pairs.
OVERLAPS = """([over, under]) => {
  const seen = (selector) => [...document.querySelectorAll(selector)].filter((each) => each.checkVisibility());
  const meet = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
  return seen(over).flatMap((each) => seen(under)
    .filter((other) => meet(each.getBoundingClientRect(), other.getBoundingClientRect()))
    .map((other) => `${each.className} over ${other.className?.baseVal ?? other.className} ${other.textContent}`));
}"""
#: What is wrong with the dialog that is open: too large, buttons out of reach, and in dark what is light.
DIALOG = """(dialog) => {
  const wrong = [];
  const paint = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  const lightness = (element) => {
    paint.fillStyle = "white"; // where nothing has a color
    paint.fillRect(0, 0, 1, 1);
    const around = [];
    for (let each = element; each; each = each.parentElement) around.unshift(each);
    for (const each of around) {
      paint.fillStyle = getComputedStyle(each).backgroundColor;
      paint.fillRect(0, 0, 1, 1);
    }
    return Math.max(...paint.getImageData(0, 0, 1, 1).data.slice(0, 3));
  };
  const { left, top, right, bottom } = dialog.getBoundingClientRect();
  const isOut = left < 0 || top < 0 || right > innerWidth || bottom > innerHeight;
  if (isOut && dialog.localName === "dialog") wrong.push("too large"); // those of tools scroll among the properties
  for (const each of [dialog, ...dialog.querySelectorAll("input[type=text], select, textarea, button:not(.main)")])
    if (each.checkVisibility() && lightness(each) > 80) wrong.push(`light: ${each.outerHTML.slice(0, 80)}`);
  for (const each of dialog.querySelectorAll(".answers button")) {
    const box = each.getBoundingClientRect();
    const seen = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
    if (!each.contains(seen)) wrong.push(`out of reach: ${each.textContent}`);
  }
  return wrong;
}"""


@pytest.fixture
def pad(tmp_path: Path) -> Path:
    """The case file of the pad."""
    return write_pad(tmp_path)


def write_pad(folder: Path) -> Path:
    """Write the example of a pad with bars and limits, on a coarse mesh."""
    path = folder / "pad.toml"
    text = (ROOT / "examples" / "pad.toml").read_text(encoding="utf-8")
    path.write_text(text.replace('size = "0.1 m"', 'size = "0.5 m"'), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def solved_pad(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a page on the pad, which is solved once and which no test changes."""
    folder = tmp_path_factory.mktemp("pad")
    server = Server(folder / "state")
    yield server.start(write_pad(folder))
    server.stop()


def open_pad(bench: Bench, url: str, size: tuple[int, int], language: str = "en") -> None:
    """Open the pad in a language in a window, with its checks, one needing attention."""
    if language != "en":
        bench.page.add_init_script(f"localStorage.setItem('groundslab-language', '{language}')")
    resize(bench, size)
    bench.open(url)
    wait_checked(bench)


def resize(bench: Bench, size: tuple[int, int]) -> None:
    """Give the window a size."""
    bench.page.set_viewport_size({"width": size[0], "height": size[1]})


def wait_checked(bench: Bench) -> None:
    """Wait until the results with their checks are shown, and until it is told what solving takes."""
    bench.page.wait_for_selector('.result-status[data-state="failing"]')
    bench.page.wait_for_selector('.result[aria-busy="false"] .result-full:not([hidden])')
    bench.until(lambda: bench.seen(".cost") != "")


def test_rows_of_checks_in_view(solved_pad: str, bench: Bench) -> None:
    """The tab of checks shows twelve whole rows on a laptop, nine where the window is low."""
    open_pad(bench, solved_pad, LAPTOP)
    bench.page.locator(".lower").get_by_role("tab", name="Checks").click()
    bench.page.locator(".result-table:visible tbody tr[data-place]").first.wait_for()
    for least, size in ((12, LAPTOP), (9, LOW)):
        resize(bench, size)
        bench.until(
            lambda least=least: bench.page.evaluate(WHOLE_ROWS) >= least, lambda: str(bench.page.evaluate(WHOLE_ROWS))
        )
        picture = bench.page.locator(".stage-place").bounding_box()
        assert picture["height"] > 150, "the picture is still seen"


@pytest.mark.parametrize(("language", "size"), [("en", LARGE), ("de", LOW)], ids=["en", "de"])
def test_nothing_is_cut(solved_pad: str, bench: Bench, language: str, size: tuple[int, int]) -> None:
    """In every view of the model and every tab of results no words are cut, or a title has them.

    The longest words in the smallest window, and others in the largest, which is laid out in another way.
    """
    open_pad(bench, solved_pad, size, language)
    for tab in bench.page.get_by_role("tab").all():
        tab.click()
        bench.wait_equal(lambda: bench.page.evaluate(CUT), [])


def test_what_is_cut_is_found(bench: Bench) -> None:
    """Words that end in an ellipsis, beyond a box and in a list of choices are found, and a title excuses the first."""
    bench.page.set_content(
        """<p class="a" style="width:40px;overflow:hidden;white-space:nowrap">words that are cut</p>
        <p title="all" style="width:40px;overflow:hidden;white-space:nowrap">words that are cut</p>
        <div style="height:20px;overflow:hidden"><b class="b" style="display:block;margin-top:19px">below</b></div>
        <select style="width:50px"><option>one of several choices</option></select><p>words</p>"""
    )
    assert bench.page.evaluate(CUT) == ["select: one of several choices", "a: words that are cut", "b: below"]


def test_what_solving_takes_is_told_in_full(server: Server, bench: Bench, pad: Path) -> None:
    """Accuracy, time, unknowns and combinations are not cut in any language, nor is the name of the file."""
    text = pad.read_text(encoding="utf-8")
    pad.write_text(text[: text.index("[mesh]")] + '[mesh]\naccuracy = "draft"\n', encoding="utf-8")
    resize(bench, LAPTOP)
    url = server.start(pad, by_itself=False)
    bench.open(url)
    for language in ("de", "es", "fr", "pl"):
        bench.page.evaluate(f"localStorage.setItem('groundslab-language', '{language}')")
        bench.open(url)
        bench.until(lambda: bench.seen(".cost") != "")
        bench.wait_equal(lambda: bench.page.evaluate(CUT), [])
        assert bench.page.locator(".file-title").evaluate("(each) => each.scrollWidth <= each.clientWidth")
        draft = bench.page.locator(".accuracy option").first.inner_text()
        assert draft.startswith(messages(language)["Draft (15 %)"])


@pytest.mark.parametrize(("size", "language"), [(LAPTOP, "en"), (LOW, "de")], ids=["1366x768", "1280x650"])
def test_tabs_are_all_reached(solved_pad: str, bench: Bench, size: tuple[int, int], language: str) -> None:
    """By keys and by the arrows at the ends every tab comes into view, and stays; arrows say where there are more."""
    open_pad(bench, solved_pad, size, language)
    for part in (".model", ".lower"):
        bar = bench.page.locator(f"{part} > .scrolling-bar")
        tabs = bar.get_by_role("tab").all()
        tabs[0].click()
        for _ in tabs:
            bench.wait_equal(lambda bar=bar: bar.evaluate(TABS), [])
            bench.page.keyboard.press("ArrowRight")
    tabs = bench.page.locator(".lower .tabs")
    for side, sign in (("end", 1), ("start", -1)):
        arrow = bench.page.locator(f".lower .bar-arrow.{side}")
        bench.until(arrow.is_visible)
        at = tabs.evaluate(SETTLED)
        while arrow.is_visible():
            arrow.click()
            before, at = at, tabs.evaluate(SETTLED)
            assert sign * (at - before) > 0, "the bar stays where an arrow has brought it"


def test_words_over_a_picture_leave_its_scales(own_server: Server, bench: Bench, pad: Path) -> None:
    """What is said of an outdated result covers no scale; a banner moves what is below it."""
    bench.open(own_server.start(pad, free_port()))
    wait_checked(bench)
    own_server.kill()
    bench.tab("Form")
    bench.fill("0.7 m", "plate", "thickness")
    bench.page.keyboard.press("Tab")
    bench.page.wait_for_selector(".banner:not([hidden])")
    bench.page.wait_for_selector('.result[data-standing="outdated"]')
    bench.wait_equal(lambda: bench.page.evaluate(OVERLAPS, [".banner", ".top, .page"]), [])
    assert bench.page.evaluate(OVERLAPS, [".outdated-over", ".gs-scale, .gs-everywhere, .gs-overlay .figure"]) == []
    assert bench.page.evaluate(CUT) == []


def test_help_covers_no_field_and_little_of_the_plan(solved_pad: str, bench: Bench) -> None:
    """The meaning of a field covers no field that has the focus, nor the loads on the entire slab or the properties."""
    open_pad(bench, solved_pad, LOW)
    bench.click(0, 0)
    bench.wait_seen(".properties h3", "olumn C1")
    bench.page.locator(".properties input").first.focus()
    help_ = bench.page.locator(".field-help:visible")
    help_.wait_for()
    assert bench.page.evaluate(OVERLAPS, [".field-help", ".unplaced, .properties, .tools"]) == []
    drawn, covered = bench.page.locator(".drawing-box").bounding_box(), help_.bounding_box()
    assert drawn["y"] + drawn["height"] - covered["y"] < 60
    bench.tab("Form")
    for field in bench.page.locator(".form :is(input[type=text], select):visible").all():
        field.focus()
        bench.wait_equal(lambda field=field: field.evaluate(IS_SEEN), True)


#: Whether the middle of an element is seen.
IS_SEEN = """(each) => {
  const { left, top, width, height } = each.getBoundingClientRect();
  return document.elementFromPoint(left + width / 2, top + height / 2) === each;
}"""


def test_dialogs_fit_and_are_dark(server: Server, bench: Bench, tmp_path: Path) -> None:
    """Dialogs of files, imports, exports, keys and generators fit into a low window, their buttons seen, all dark."""
    case = write_case(tmp_path)
    write_table(tmp_path, ETABS)
    bench.page.add_init_script("localStorage.setItem('groundslab-theme', 'dark')")
    page, wrong = bench.page, {}
    resize(bench, LOW)
    bench.open(server.start(case, by_itself=False))
    assert page.locator("html").get_attribute("data-theme") == "dark"
    for name, dialog in _dialogs(bench):
        dialog.wait_for()
        wrong[name] = dialog.evaluate(DIALOG)
        page.keyboard.press("Escape")
        dialog.wait_for(state="hidden")
    assert {name: found for name, found in wrong.items() if found} == {}
    assert len(wrong) == 9


def _dialogs(bench: Bench) -> Any:
    """Open one dialog after the other."""
    page = bench.page
    drawing, shown = page.locator(".drawing"), page.locator("dialog[open]")
    drawing.press("?")
    yield "keys", shown
    for name in ("New", "Save as …", "Export …", "Open …"):
        page.get_by_role("button", name=name, exact=True).click()
        yield name, shown
    page.keyboard.press("Control+o")
    page.get_by_role("option", name="reactions.csv").dblclick()
    page.locator(".reactions-dialog").wait_for()
    yield "reactions", shown
    for tool in ("racks", "vehicle", "columns"):
        bench.tool(tool)
        yield tool, page.locator(".action-dialog")
