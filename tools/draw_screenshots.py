"""Draw the pictures of the README: the workbench, the report's viewer, and a figure.

    python tools/draw_screenshots.py

It takes Chromium, and minutes.
"""

from __future__ import annotations

import io
import sys
import tempfile
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from helpers.browsing import ARGUMENTS, PATIENCE, Bench, Server, chromium
from helpers.paths import EXAMPLES, ROOT

IMAGES = ROOT / "docs" / "images"
CASE = EXAMPLES / "l_raft.toml"


def save(picture: bytes | Path, name: str) -> None:
    """Write a picture with a palette of its own: small, and sharp where it has text."""
    from PIL import Image

    image = Image.open(io.BytesIO(picture) if isinstance(picture, bytes) else picture).convert("RGB")
    image.quantize(255, dither=Image.Dither.NONE).save(IMAGES / name, optimize=True)


def choose(page: Page, option: str) -> None:
    """Choose an option, by the beginning of its words, wherever there is a list that has it."""
    for each in page.locator("select:visible").all():
        for text in each.locator("option").all_inner_texts():
            if text.startswith(option):
                each.select_option(label=text)
                return
    raise LookupError(option)


def draw_workbench(page: Page, folder: Path) -> None:
    """Draw the workbench with the L-shaped raft under flood."""
    case = folder / "l_raft.toml"
    case.write_text(CASE.read_text(encoding="utf-8").replace('size = "0.5 m"', 'size = "0.75 m"'), encoding="utf-8")
    server = Server(folder / "state")
    try:
        Bench(page).open(server.start(case)).wait_solved()
        choose(page, "5 ULS flood")
        page.wait_for_timeout(3000)
        save(page.screenshot(), "workbench.png")
    finally:
        server.stop()


def draw_report(page: Page, folder: Path) -> None:
    """Draw the viewer of the report with moments and a section."""
    import groundslab

    results = groundslab.solve(groundslab.load(CASE))
    path = groundslab.write_report(results, folder / "report.html")
    page.goto(path.as_uri())
    viewer = page.locator("#explore").first
    viewer.scroll_into_view_if_needed()
    page.wait_for_timeout(3000)
    choose(page, "mx ")
    choose(page, "axis 1")
    page.wait_for_timeout(3000)
    page.evaluate(
        "window.scrollTo(0, document.querySelector('#explore select').getBoundingClientRect().top + scrollY - 20)"
    )
    page.wait_for_timeout(1000)
    save(page.screenshot(), "report.png")
    figure = results["ULS flood"].plot("settlement", kind="deformed")
    figure.savefig(folder / "deformed.png", dpi=150)
    save(folder / "deformed.png", "deformed.png")


def main() -> None:
    """Draw all pictures."""
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium(), args=ARGUMENTS)
        page = browser.new_page(viewport={"width": 1366, "height": 768})
        page.set_default_timeout(PATIENCE)
        draw_workbench(page, Path(folder))
        draw_report(page, Path(folder))
        browser.close()


if __name__ == "__main__":
    main()
