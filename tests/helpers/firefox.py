"""Firefox without a window, driven by WebDriver BiDi (W3C), which it speaks by itself."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import Any

PATIENCE = 120  # s that anything may take on a busy machine
ADDRESS = re.compile(r"WebDriver BiDi listening on (ws://\S+)")
#: Preferences of a new profile: nothing is fetched, asked or shown by itself.
PREFERENCES = """\
user_pref("app.update.enabled", false);
user_pref("browser.shell.checkDefaultBrowser", false);
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("network.captive-portal-service.enabled", false);
user_pref("network.connectivity-service.enabled", false);
user_pref("services.settings.server", "http://127.0.0.1:9/");
user_pref("toolkit.telemetry.server", "http://127.0.0.1:9/");
"""
#: Values of the keys that are no characters, by their names.
KEYS = {"Enter": "\ue007", "Tab": "\ue004", "Control": "\ue009"}


def firefox() -> str | None:
    """Return the path of the browser, None if there is none."""
    return os.environ.get("GROUNDSLAB_FIREFOX") or next(
        filter(None, map(shutil.which, ("firefox-esr", "firefox"))), None
    )


def missing_firefox() -> str:
    """Return what keeps the tests in Firefox from running, empty if nothing does."""
    if find_spec("websockets") is None:
        return "no package websockets"
    return "" if firefox() else "no Firefox on this machine"


@contextmanager
def run_firefox(profile: Path) -> Iterator[Firefox]:
    """Run the browser with a new profile in a folder, and end it afterwards."""
    from websockets.sync.client import connect

    (profile / "user.js").write_text(PREFERENCES)
    log = profile / "firefox.log"
    path = firefox()
    assert path is not None
    words = [path, "--headless", "--no-remote", "--profile", str(profile), "--remote-debugging-port", "0"]
    environment = {**os.environ, "HOME": str(profile)}
    with (
        log.open("w") as output,
        subprocess.Popen(words, stdout=output, stderr=subprocess.STDOUT, env=environment) as process,
    ):
        try:
            with connect(f"{_wait_address(log, process)}/session", max_size=None) as socket:
                yield Firefox(socket)
        finally:
            process.terminate()


def _wait_address(log: Path, process: subprocess.Popen[bytes]) -> str:
    """Return the address that the browser prints once it listens."""
    end = time.monotonic() + PATIENCE
    while not (found := ADDRESS.search(log.read_text())):
        assert process.poll() is None, log.read_text()
        assert time.monotonic() < end, log.read_text()
        time.sleep(0.05)
    return found[1]


class Firefox:
    """One tab of 1366 x 768 pixels; ``errors`` collects those that the console shows."""

    def __init__(self, socket: Any) -> None:
        self.errors: list[str] = []
        self._socket = socket
        self._count = 0
        self._send("session.new", capabilities={})
        self._send("session.subscribe", events=["log.entryAdded"])
        self._tab = self._send("browsingContext.getTree")["contexts"][0]["context"]
        self._send("browsingContext.setViewport", context=self._tab, viewport={"width": 1366, "height": 768})

    def _send(self, method: str, **params: object) -> dict[str, Any]:
        """Send a command and return its result; what the console shows meanwhile is kept."""
        self._count += 1
        self._socket.send(json.dumps({"id": self._count, "method": method, "params": params}))
        while True:
            answer = json.loads(self._socket.recv(timeout=PATIENCE))
            if answer.get("method") == "log.entryAdded" and answer["params"]["level"] == "error":
                self.errors.append(answer["params"]["text"])
            if answer.get("id") == self._count:
                assert answer["type"] == "success", answer
                result: dict[str, Any] = answer["result"]
                return result

    def open(self, url: str) -> None:
        """Open a page."""
        self._send("browsingContext.navigate", context=self._tab, url=url, wait="complete")

    def read(self, expression: str) -> Any:
        """Return the value of an expression, or of what it promises, on the page."""
        text = f"(async () => JSON.stringify(await ({expression}) ?? null))()"
        target = {"context": self._tab}
        answer = self._send("script.evaluate", expression=text, target=target, awaitPromise=True)
        assert answer["type"] == "success", answer
        return json.loads(answer["result"]["value"])

    def until(self, expression: str) -> Any:
        """Wait until an expression is true, something that is not empty; returns its value."""
        end = time.monotonic() + PATIENCE
        while not (value := self.read(expression)):
            assert time.monotonic() < end, f"waited in vain: {expression}"
            time.sleep(0.05)
        return value

    def click(self, selector: str) -> None:
        """Click on the middle of the first element that is seen of a selector."""
        find = f"[...document.querySelectorAll({json.dumps(selector)})].find((each) => each.checkVisibility())"
        self.until(f"{find} !== undefined")
        box = f"(it => (it.scrollIntoView({{ block: 'nearest' }}), it.getBoundingClientRect()))({find})"
        x, y = self.read(f"(({{ x, y, width, height }}) => [x + width / 2, y + height / 2])({box})")
        self.click_at(x, y)

    def click_at(self, x: float, y: float) -> None:
        """Click on a place of the page [px]."""
        press = [{"type": kind, "button": 0} for kind in ("pointerDown", "pointerUp")]
        move = {"type": "pointerMove", "x": round(x), "y": round(y)}
        mouse = {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": [move, *press]}
        self._send("input.performActions", context=self._tab, actions=[mouse])

    def press(self, *keys: str) -> None:
        """Press keys, one after the other; of ``Control+a`` both at once."""
        actions = []
        for key in keys:
            held = [KEYS.get(each, each) for each in key.split("+")]
            actions += [{"type": "keyDown", "value": each} for each in held]
            actions += [{"type": "keyUp", "value": each} for each in reversed(held)]
        self._send(
            "input.performActions", context=self._tab, actions=[{"type": "key", "id": "keys", "actions": actions}]
        )
