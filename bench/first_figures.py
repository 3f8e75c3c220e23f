"""The workbench in a browser: seconds to the first picture and figures, to those of a finished mesh, and to the end.

    python bench/first_figures.py                      # four slabs of bench/slabs, into bench/first_figures.json
    python bench/first_figures.py CASE.toml ...        # some cases, printed alone

Size, counts and refinements are taken out of each case. It is opened in a workbench that solves by itself, on one
thread; time runs from that moment. What the page shows is looked at every few milliseconds: a picture and figures, both
of a preview of one combination if that comes first; figures of all combinations on the first mesh, checks with them,
and results whose mesh is refined no more. Then the same case is opened in a workbench that does not solve by itself:
`solve` is from F9 to the first figures. `cpu` and `cpu_solve` are the seconds of processor time that the processes of
the server take until the first figures, which do not depend on what else the machine does.
"""

from __future__ import annotations

import json
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
sys.path.append(str(HERE.parent / "tests"))
from helpers.browsing import ARGUMENTS, Bench, SharedServer, chromium, missing  # noqa: E402

SLABS, RESULTS = HERE / "slabs", HERE / "first_figures.json"
#: Foundations that engineers built by mouse.
BUILT = ("l_raft_ten_columns", "floor_forklift", "tank_ring", "core_raft")
#: A case is given up after so many seconds.
LIMIT = 580.0
#: Processes that take less in a second do nothing [s].
IDLE = 0.05
#: What is seen of a run, in the page.
SEEN = """() => {
  const shown = (selector) => { const e = document.querySelector(selector); return e !== null && e.checkVisibility(); };
  const first = shown(".result-full") && document.querySelectorAll(".figures tr").length > 0;
  const figures = first && !(document.querySelector(".preview-over").textContent.startsWith("Preview"));
  return {
    picture: shown(".preview-over") || shown(".result-full"),
    first,
    figures,
    checks: figures && [...document.querySelectorAll("[role=tab]")].some((e) =>
      e.textContent.startsWith("Checks") && e.checkVisibility() && e.getAttribute("aria-disabled") !== "true"),
    end: figures && document.querySelector(".result-status").dataset.state !== "solving"
      && shown(".result[aria-busy=false]"),
  };
}"""

Row = dict[str, Any]


def examine(path: Path) -> Row:
    """Return the seconds of one case, each None where nothing was seen in time."""
    import groundslab
    from groundslab.case.casefile import to_toml

    model = groundslab.load(path)
    mesh = model.mesh.model_copy(update={"size": None, "counts": None, "refine": ()})
    found: Row = {"slab": path.stem, "picture": None, "first": None, "figures": None, "checks": None, "end": None}
    with tempfile.TemporaryDirectory() as folder:
        case = Path(folder) / path.name
        case.write_text(to_toml(model.model_copy(update={"mesh": mesh})), encoding="utf-8")
        server = SharedServer(Path(folder) / "state")
        try:
            watch(server, case, found)
        finally:
            server.stop()
    return found


def watch(server: SharedServer, case: Path, found: Row) -> None:
    """Note when what appears in the page."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium(), args=ARGUMENTS)
        bench = Bench(browser.new_page(viewport={"width": 1366, "height": 768}))
        bench.page.add_init_script("localStorage.setItem('groundslab-tour', 'taken')")
        bench.open(server.start(None))
        wait_until_idle(server, bench)
        start, before = time.perf_counter(), processor_time(server)
        server.start(case)
        while found["end"] is None and time.perf_counter() - start < LIMIT:
            seen = bench.page.evaluate(SEEN)
            for name in seen:
                if seen[name] and found[name] is None:
                    found[name] = round(time.perf_counter() - start, 1)
                    if name == "first":
                        found["cpu"] = round(processor_time(server) - before, 1)
            bench.page.wait_for_timeout(20)
        found["solve"], found["cpu_solve"] = press_solve(server, bench, case)
        browser.close()


def press_solve(server: SharedServer, bench: Bench, case: Path) -> tuple[float, float]:
    """Return the seconds from F9 to the first figures of a case that is not solved by itself, and processor time."""
    server.start(case, by_itself=False)
    wait_until_idle(server, bench)
    start, before = time.perf_counter(), processor_time(server)
    bench.page.keyboard.press("F9")
    bench.until(lambda: bench.page.evaluate(SEEN)["first"])
    return round(time.perf_counter() - start, 1), round(processor_time(server) - before, 1)


def wait_until_idle(server: SharedServer, bench: Bench) -> None:
    """Wait until the processes of the server do nothing: they have warmed up, and the text is checked."""
    before = -1.0
    while processor_time(server) - before > IDLE:
        before = processor_time(server)
        bench.page.wait_for_timeout(1000)


def processor_time(server: SharedServer) -> float:
    """Return the processor time of the server and of the processes that it started [s]."""
    import psutil

    assert server.process is not None
    parent = psutil.Process(server.process.pid)
    times = [process.cpu_times() for process in (parent, *parent.children(recursive=True))]
    return sum(each.user + each.system for each in times)


def main() -> None:
    """Examine the cases that are named, or those that were built by mouse, and print a line for each."""
    if missing():
        sys.exit(f"nothing was tried: {missing()}")
    paths = [Path(word) for word in sys.argv[1:]] or [SLABS / f"{name}.toml" for name in BUILT]
    rows = []
    for path in paths:
        rows.append(examine(path))
        print(" ".join(f"{name} {value}" for name, value in rows[-1].items()), flush=True)
        if not sys.argv[1:]:
            RESULTS.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
