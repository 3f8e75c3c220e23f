"""Pictures in a browser while they move: milliseconds a frame with 500 loads and 200 columns, and sizes of the pages.

    python bench/frames.py                     # into bench/frames.json
    python bench/frames.py --print             # printed alone

A raft with 200 columns and 500 loads is solved on a coarse mesh. The picture of its result, and the drawing in the
editor, are dragged and zoomed by the pointer's events, one for each frame; in the editor a load is dragged, too. Of
each frame there is what the page itself takes (script, styles and layout, by Chromium's counters) and what passes until
the next one, in which the picture is painted too: there is no graphics card, the browser paints by the processor. Of
the pages there are the bytes, as they are and packed by gzip.
"""

from __future__ import annotations

import gzip
import json
import sys
import tempfile
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
sys.path.append(str(HERE.parent / "tests"))
from helpers.browsing import STATIC, Server, chromium, missing  # noqa: E402

RESULTS = HERE / "frames.json"
REPORT = STATIC.parent.parent / "views" / "report" / "static"
#: Columns and loads along x and y; the slab reaches one distance beyond the columns [m].
COLUMNS, LOADS, APART = (20, 10), (25, 20), 4.0
FRAMES = 60
SIZE = {"width": 1920, "height": 1080}
#: Moves what is seen, a step for each frame, and returns the distances of the frames [ms].
MOVE = """async ([selector, how, frames]) => {
  const element = document.querySelector(selector);
  const box = element.getBoundingClientRect();
  const drags = how === "drag";
  const held = drags ? document.querySelector(".symbol.load .head").getBoundingClientRect() : box;
  const [x, y] = drags ? [held.right, held.bottom] : [box.left + box.width / 2, box.top + box.height / 2];
  const send = (type, dx) => element.dispatchEvent(new PointerEvent(type, {
    bubbles: true, pointerId: 1, isPrimary: true, clientX: x + dx, clientY: y + dx / 2,
    button: type === "pointermove" ? -1 : how === "pan" ? 1 : 0, buttons: how === "pan" ? 4 : 1 }));
  const turn = (by) => element.dispatchEvent(new WheelEvent("wheel",
    { bubbles: true, cancelable: true, clientX: x, clientY: y, deltaY: by }));
  element.setPointerCapture = () => {};
  if (how !== "zoom") send("pointerdown", 0);
  const times = [await new Promise(requestAnimationFrame)];
  for (let n = 1; n <= frames; n += 1) {
    if (how !== "zoom") send("pointermove", 150 * Math.sin(n / 8));
    else turn(n % 40 < 20 ? -40 : 40);
    times.push(await new Promise(requestAnimationFrame));
  }
  if (how !== "zoom") send("pointercancel", 0);
  return times.slice(1).map((time, n) => time - times[n]);
}"""
#: Chromium's counters of what the page itself takes [s].
COUNTERS = ("ScriptDuration", "RecalcStyleDuration", "LayoutDuration")

Row = dict[str, Any]


def case_text() -> str:
    """Return the case file of the raft."""
    (nx, ny), (mx, my) = COLUMNS, LOADS
    length, width = APART * (nx + 1), APART * (ny + 1)
    parts = [
        f'[plate]\nlength_x = "{length} m"\nlength_y = "{width} m"\nthickness = "600 mm"\nE = "30 GPa"\nnu = 0.2\n\n'
        '[ground]\nkind = "winkler"\nk = "20 MPa/m"\n\n[mesh]\nsize = "2 m"\n'
    ]
    for n in range(nx * ny):
        x, y = APART * (n % nx - (nx - 1) / 2), APART * (n // nx - (ny - 1) / 2)
        parts.append(
            f'[[columns]]\nname = "C{n + 1}"\nx = "{x} m"\ny = "{y} m"\nwidth_x = "0.4 m"\nwidth_y = "0.4 m"\n'
        )
    for n in range(mx * my):
        x, y = length * ((n % mx + 0.7) / mx - 0.5), width * ((n // mx + 0.4) / my - 0.5)
        parts.append(f'[[loads]]\nkind = "point"\nx = "{x:.3f} m"\ny = "{y:.3f} m"\nP = "{200 + 7 * n % 331} kN"\n')
    return "\n".join(parts)


def measure(page: Any, selector: str, picture: str) -> list[Row]:
    """Return the times of a picture that is dragged and zoomed."""
    rows = []
    client = page.context.new_cdp_session(page)
    client.send("Performance.enable")

    def counters() -> list[float]:
        values = {each["name"]: each["value"] for each in client.send("Performance.getMetrics")["metrics"]}
        return [values[name] for name in COUNTERS]

    for how in ("pan", "zoom", "drag") if picture == "editor" else ("pan", "zoom"):
        page.wait_for_timeout(500)
        before = counters()
        times = sorted(page.evaluate(MOVE, [selector, how, FRAMES]))
        own = [1e3 * (now - then) / FRAMES for then, now in zip(before, counters(), strict=True)]
        middle, late = times[FRAMES // 2], times[int(0.95 * FRAMES)]
        rows.append(
            {
                "picture": picture,
                "move": how,
                "script": round(own[0], 1),
                "styles and layout": round(sum(own[1:]), 1),
                "frame": round(middle, 1),
                "slow frame": round(late, 1),
            }
        )
    return rows


def pictures() -> list[Row]:
    """Return the times of the result's picture and of the drawing in the editor."""
    from playwright.sync_api import sync_playwright

    import groundslab

    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        case = Path(folder) / "raft.toml"
        case.write_text(case_text(), encoding="utf-8")
        results = groundslab.save_results(groundslab.solve(groundslab.load(case)), Path(folder) / "raft-results")
        # the tests' browser emulates a graphics card, which takes longer than painting without one
        browser = playwright.chromium.launch(executable_path=chromium(), args=["--no-sandbox", "--disable-gpu"])
        shown = (("view", results, ".gs-plan", "result"), ("app", case, ".drawing", "editor"))
        for command, path, selector, picture in shown:
            server = Server(Path(folder) / command)
            page = browser.new_page(viewport=SIZE)
            page.add_init_script("localStorage.setItem('groundslab-tour', 'taken')")
            page.set_default_timeout(120_000)
            try:
                page.goto(server.start(path, command=command))
                page.locator(selector).first.wait_for()
                page.wait_for_function("document.querySelectorAll('.gs-symbols .symbol, .gs-symbols path').length > 5")
                page.wait_for_timeout(1500)
                rows += measure(page, selector, picture)
            finally:
                page.close()
                server.stop()
        browser.close()
    return rows


def sizes() -> Row:
    """Return the bytes of the pages' scripts and styles, and of what is sent of them."""
    files = [STATIC / "index.js", STATIC / "index.css", REPORT / "report.js", REPORT / "report.css"]
    return {path.name: [path.stat().st_size, len(gzip.compress(path.read_bytes()))] for path in files}


def main() -> None:
    """Measure, print, and write the file unless asked to print alone."""
    if missing():
        sys.exit(f"nothing was tried: {missing()}")
    found = {"pictures": pictures(), "bytes, packed": sizes()}
    for row in found["pictures"]:
        print(" ".join(f"{name} {value}" for name, value in row.items()))
    print(found["bytes, packed"])
    if "--print" not in sys.argv[1:]:
        RESULTS.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
