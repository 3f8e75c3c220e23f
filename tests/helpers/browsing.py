"""A real browser before a real server: the workbench's page and what a user does with it."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit
from urllib.request import Request, urlopen

from helpers.paths import ROOT

PATIENCE = 120_000  # ms that anything may take on a busy machine
#: Box of the plan on the screen and the view that it is drawn in, after the next frame.
VIEW = """async (drawing) => {
  await new Promise(requestAnimationFrame);
  const { left, top, width, height } = drawing.getBoundingClientRect();
  return [left, top, width, height, drawing.dataset.view];
}"""
#: What Chromium does for its own windows and for pages to come, which takes time; what Playwright leaves out as well.
LEFT_OUT = (
    "PreloadTopChromeWebUI,InitialWebUI,TabSearch,ReadAnything,WebUIOmniboxPopup,Glic,SpareRendererForSitePerProcess,"
    "OnDeviceModelService,OptimizationGuideOnDeviceModel,OptimizationGuideModelExecution,OptimizationHints,"
    "AvoidUnnecessaryBeforeUnloadCheckSync,DestroyProfileOnBrowserClose,HttpsUpgrades,HttpsFirstBalancedModeAutoEnable,"
    "LensOverlay,MediaRouter,PaintHolding,ThirdPartyStoragePartitioning,NetworkTimeServiceQuerying,PreconnectToSearch"
)
#: The page is drawn without a GPU; only pictures in three dimensions need one, which is imitated. All tabs of the
#: workbench share a process.
ARGUMENTS = [
    "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing",
    "--disable-gpu-rasterization", "--process-per-site", f"--disable-features={LEFT_OUT}",
]  # fmt: skip
STATIC = ROOT / "src" / "groundslab" / "workbench" / "static"

SMALL = """\
title = "A small slab"

[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "250 mm"  # as on the drawing
E = "30 GPa"
nu = 0.2

[ground]
kind = "winkler"
k = "20 MPa/m"

[[columns]]
name = "A1"
x = "-2 m"
y = "1 m"
width_x = "400 mm"
width_y = "400 mm"

[[loads]]
kind = "point"
column = "A1"
P = "200 kN"

[mesh]
size = "0.5 m"
"""


def chromium() -> str | None:
    """Return the path of the browser, None if there is none."""
    names = ("chromium", "chromium-browser", "google-chrome")
    return os.environ.get("GROUNDSLAB_CHROMIUM") or next(filter(None, map(shutil.which, names)), None)


def missing() -> str:
    """Return what keeps the tests from running, empty if nothing does."""
    packages = [name for name in ("playwright", "fastapi", "uvicorn") if find_spec(name) is None]
    if packages:
        return f"no package {', '.join(packages)}"
    if chromium() is None:
        return "no Chromium on this machine"
    if not (STATIC / "index.js").is_file() or (STATIC / "index.js").stat().st_size < 10_000:
        return "the page is not built (npm run build in web/)"
    return ""


@dataclass
class Server:
    """groundslab app, or view, as a process of its own."""

    state: Path
    process: subprocess.Popen[str] | None = None
    url: str = ""

    def start(self, case: Path | None, port: int = 0, command: str = "app") -> str:
        """Start the server on a case, or with another command on results; returns the address of its page."""
        words = [sys.executable, "-m", "groundslab", command, "--port", str(port), "--no-browser"]
        environment = {**os.environ, "XDG_STATE_HOME": str(self.state), "OMP_NUM_THREADS": "1"}
        self.process = subprocess.Popen(
            [*words, *([] if case is None else [str(case)])], stdout=subprocess.PIPE, text=True, env=environment
        )
        assert self.process.stdout is not None
        self.url = self.process.stdout.readline().strip()
        assert self.url.startswith("http://127.0.0.1:"), self.url
        return self.url

    @property
    def port(self) -> int:
        """The port that it listens on."""
        return int(self.url.split(":")[2].split("/")[0])

    def kill(self) -> None:
        """End it without giving it time for anything."""
        assert self.process is not None
        self.process.kill()
        self.process.wait()
        self._close()

    def stop(self) -> None:
        """End it as Ctrl-C does."""
        if self.process is not None and self.process.poll() is None:
            self.process.terminate()
            try:
                self.process.wait(20)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        self._close()

    def _close(self) -> None:
        if self.process is not None and self.process.stdout is not None:
            self.process.stdout.close()


class SharedServer(Server):
    """One workbench for many tests; each of them begins with a document of its own, as after a start."""

    def start(self, case: Path | None, port: int = 0, command: str = "app", by_itself: bool = True) -> str:
        """Show a case, or a new one, in place of the document of the test before; returns the address of the page.

        It is solved by itself, or when that is asked for.
        """
        assert (port, command) == (0, "app"), "that takes a server of its own"
        if self.process is None or self.process.poll() is not None:
            super().start(None)
        # lets go of the unsaved work of the test before, which would be offered to the next one
        self._post("new")
        for path in self.state.rglob("unsaved/*"):
            path.unlink()
        self._post("autosolve", on=by_itself)
        self._post("new") if case is None else self._post("open", file=str(case))
        return self.url

    def _post(self, name: str, **body: object) -> None:
        parts = urlsplit(self.url)
        headers = {"X-Groundslab-Token": parse_qs(parts.query)["token"][0], "Content-Type": "application/json"}
        request = Request(f"http://{parts.netloc}/api/{name}", json.dumps(body).encode(), headers)
        with urlopen(request, timeout=PATIENCE / 1000) as answer:
            answer.read()


@dataclass
class Bench:
    """The page in a tab, and what a user does with it."""

    page: Any
    errors: list[str] = field(default_factory=list)

    def open(self, url: str) -> Bench:
        """Open the page and wait until it can be used."""
        self.page.goto(url)
        self.page.wait_for_selector(".drawing[data-view]")
        return self

    def tab(self, name: str) -> None:
        """Choose one of the views of the model."""
        self.page.locator(".model").get_by_role("tab", name=name).click()

    def pixel(self, x: float, y: float) -> tuple[float, float]:
        """Return where a place of the plan [m] is on the screen."""
        [pixel] = self.pixels((x, y))
        return pixel

    def pixels(self, *places: tuple[float, float]) -> list[tuple[float, float]]:
        """Return where places of the plan [m] are on the screen, in the view that the next frame shows."""
        left, top, width, height, view = self.page.locator(".drawing").evaluate(VIEW)
        cx, cy, scale = map(float, view.split())
        return [(left + width / 2 + (x - cx) * scale, top + height / 2 - (y - cy) * scale) for x, y in places]

    def click(self, x: float, y: float) -> None:
        """Click on a place of the plan [m]."""
        self.page.mouse.click(*self.pixel(x, y))

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Drag from one place of the plan to another [m]."""
        (x, y), (x2, y2) = start, end
        first, *others = self.pixels(*((x + share * (x2 - x), y + share * (y2 - y)) for share in (0.0, 0.3, 0.7, 1.0)))
        self.page.mouse.move(*first)
        self.page.mouse.down()
        for pixel in others:
            self.page.mouse.move(*pixel)
        self.page.mouse.up()

    def tool(self, name: str) -> None:
        """Choose a tool of the drawing."""
        self.page.locator(f'.tool[data-tool="{name}"]').click()

    def field(self, *path: str | int) -> Any:
        """Return the row of a key, in the form or in the properties, whichever is seen."""
        key = "[" + ",".join(f'"{step}"' if isinstance(step, str) else str(step) for step in path) + "]"
        return self.page.locator(f"[data-path='{key}']").locator("visible=true").first

    def fill(self, value: str, *path: str | int) -> None:
        """Type a value into the field of a key."""
        self.field(*path).locator("input").first.fill(value)

    def export(self, file: str, folder: Path) -> Path:
        """Export one of the files that the dialog offers; returns where it was saved, under the name that it got."""
        self.page.get_by_role("button", name="Export …").click()
        dialog = self.page.locator(".export-dialog")
        dialog.locator("select", has=self.page.locator(f'option[value="{file}"]')).select_option(file)
        with self.page.expect_download() as download:
            dialog.get_by_role("button", name="Export", exact=True).click()
        path = folder / download.value.suggested_filename
        download.value.save_as(path)
        return path

    def text(self) -> str:
        """Return the case file as the page shows it under Text."""
        return str(self.page.locator(".code-input").input_value())

    def until(self, holds: Callable[[], bool], what: Callable[[], str] = str) -> None:
        """Wait until something holds; ``what`` says how things stand if it never does."""
        end = time.monotonic() + PATIENCE / 1000
        while not holds():
            assert time.monotonic() < end, f"waited in vain: {what()}"
            self.page.wait_for_timeout(50)

    def wait_equal(self, read: Callable[[], Any], expected: Any) -> None:
        """Wait until what is read from the page is as expected."""
        self.until(lambda: read() == expected, lambda: f"{read()!r}, not {expected!r}")

    def still(self, picture: Any) -> bytes:
        """Return a picture once it no longer changes from one look to the next."""
        looks = [b""]

        def is_still() -> bool:
            looks.append(picture.screenshot())
            return looks[-3:] == [looks[-1]] * 3

        self.until(is_still)
        return looks[-1]

    def step(self, key: str, words: str) -> None:
        """Press a key of the drawing until what it selects is called so; each time the next frame shows it."""
        for _ in range(9):
            self.page.locator(".drawing").press(key)
            self.page.evaluate("() => new Promise(requestAnimationFrame)")
            if words in self.seen(".properties h3"):
                return
        raise AssertionError(f"{key} never selects {words}")

    def wait_text(self, *words: str) -> None:
        """Wait until the case file holds some words."""
        self.until(lambda: all(each in self.text() for each in words), lambda: f"{words} in\n{self.text()}")

    def seen(self, selector: str) -> str:
        """Return the words of an element."""
        return str(self.page.locator(selector).first.text_content())

    def wait_seen(self, selector: str, words: str) -> None:
        """Wait until an element says some words."""
        self.until(lambda: words in self.seen(selector), lambda: f"{words!r} in {self.seen(selector)!r}")

    def wait_solved(self) -> None:
        """Wait until a result of the present model is shown, also of a design that fails or needs attention."""
        self.page.wait_for_selector('.result-status:is([data-state="fresh"], [data-state="failing"])')
        self.page.wait_for_selector('.result[aria-busy="false"] .result-full:not([hidden])')

    def solve(self) -> None:
        """Solve the present model when it is finished, where each change is not solved by itself."""
        self.page.keyboard.press("F9")
        self.wait_solved()

    def largest(self, label: str) -> float:
        """Return a figure of the summary by the start of its label."""
        self.page.locator(".result").get_by_role("tab", name="Summary").click()
        row = self.page.locator(".figures tr", has_text=label).first
        return float(row.locator("td").first.inner_text().replace("\N{MINUS SIGN}", "-"))


def free_port() -> int:
    """Return a port that nobody listens on."""
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return int(listener.getsockname()[1])
