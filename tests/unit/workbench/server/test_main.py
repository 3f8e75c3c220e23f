"""The command `groundslab app`: a real server in a process of its own, spoken with over a socket."""

from __future__ import annotations

import http.client
import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import pytest

from groundslab.case import casefile
from groundslab.cli import main
from helpers.scenes import unpack

pytestmark = pytest.mark.slow

pytest.importorskip("fastapi")
pytest.importorskip("uvicorn")

PATIENCE = 120.0
CASE = """\
# A plate that lifts off at its corners.
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "250 mm"  # to be changed
E = "30 GPa"
nu = 0.2

[ground]
kind = "pasternak"
k0 = "20 MPa/m"
k1 = "5 MN/m"

[[loads]]
kind = "patch"
q = "200 kPa"
x = ["-0.5 m", "0.5 m"]
y = ["-0.5 m", "0.5 m"]

[mesh]
counts = [12, 8]
"""


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the system has no named pipes")
def test_a_pipe_is_no_case(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """The command refuses a pipe instead of waiting until somebody writes to it."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    os.mkfifo(tmp_path / "pipe.toml")
    assert main.main(["app", "--no-browser", str(tmp_path / "pipe.toml")]) == 2
    assert "a pipe, a device or the like" in capsys.readouterr().err


class App:
    """A server in a process of its own."""

    def __init__(self, arguments: list[str], environment: dict[str, str]) -> None:
        command = [sys.executable, "-m", "groundslab", "app", *arguments]
        pipes: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
        self.process = subprocess.Popen(command, env=environment, **pipes)
        assert self.process.stdout is not None
        self.url = self.process.stdout.readline().strip()
        parts = urlsplit(self.url)
        self.host, self.port = parts.hostname, parts.port
        self.token = parse_qs(parts.query).get("token", [""])[0]
        self.events: list[tuple[str, dict[str, Any]]] = []
        self.more = threading.Condition()

    def connection(self) -> http.client.HTTPConnection:
        """Return a new connection."""
        assert self.host is not None
        return http.client.HTTPConnection(self.host, self.port, timeout=PATIENCE)

    def ask(self, method: str, path: str, body: Any = None, **headers: str) -> tuple[int, bytes]:
        """Return status and content of an answer."""
        headers = {"X-Groundslab-Token": self.token, "Content-Type": "application/json"} | headers
        connection = self.connection()
        try:
            connection.request(method, path, None if body is None else json.dumps(body), headers)
            answer = connection.getresponse()
            return answer.status, answer.read()
        finally:
            connection.close()

    def post(self, path: str, body: Any = None) -> Any:
        """Return the data of an answer."""
        status, content = self.ask("POST", path, {} if body is None else body)
        assert status == 200, content
        return json.loads(content)

    def get(self, path: str) -> Any:
        """Return the data of an answer."""
        status, content = self.ask("GET", path)
        assert status == 200, content
        return json.loads(content)

    def set(self, path: list[str | int], value: Any) -> Any:
        """Set a value, and return the state."""
        return self.post("/api/edits", {"edits": [{"op": "set", "path": path, "value": value}], "text": "Set"})

    def listen(self) -> threading.Thread:
        """Collect events from now on; the thread ends with the stream."""
        started = threading.Event()

        def receive() -> None:
            connection = self.connection()
            connection.request("GET", f"/api/events?token={self.token}")
            answer = connection.getresponse()
            started.set()
            name = ""
            try:
                while line := answer.readline().decode().strip("\n\r") or answer.readline().decode().strip("\n\r"):
                    word, _, rest = line.partition(": ")
                    name = rest if word == "event" else name
                    if word == "data":
                        with self.more:
                            self.events.append((name, json.loads(rest)))
                            self.more.notify_all()
            except (OSError, http.client.HTTPException):
                pass
            connection.close()

        thread = threading.Thread(target=receive, daemon=True)
        thread.start()
        assert started.wait(PATIENCE)
        return thread

    def wait(self, name: str, **wanted: Any) -> dict[str, Any]:
        """Return the first event of that name with these values."""

        def found() -> list[dict[str, Any]]:
            return [about for word, about in self.events if word == name and wanted.items() <= about.items()]

        with self.more:
            assert self.more.wait_for(found, PATIENCE), self.events
            return found()[0]

    def end(self, how: int) -> tuple[int, str]:
        """Send a signal; return exit code and messages, once the process and those it started are gone."""
        self.process.send_signal(how)
        # the solver's process has the same standard streams, so that they end when both have
        _, messages = self.process.communicate(timeout=PATIENCE)
        return self.process.returncode, messages


Start = Callable[..., App]


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """Return a case file."""
    path = tmp_path / "plate.toml"
    path.write_text(CASE, encoding="utf-8")
    return path


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Start]:
    """Return what starts a server, whose state folder is its own; all are ended in the end."""
    variables = ("XDG_STATE_HOME", "WIN_PD_OVERRIDE_LOCAL_APPDATA")
    state = {"HOME": str(tmp_path)} | dict.fromkeys(variables, str(tmp_path / "state"))
    source = str(Path(main.__file__).parents[2])
    environment = {**os.environ, **state, "PYTHONPATH": source, "PYTHONUNBUFFERED": "1"}
    started: list[App] = []

    def app(*arguments: object, **more: str) -> App:
        shown = [] if "BROWSER" in more else ["--no-browser"]
        started.append(App([*map(str, arguments), *shown], environment | more))
        return started[-1]

    yield app
    for each in started:
        if each.process.poll() is None:
            each.process.kill()
            each.process.communicate()
        for stream in (each.process.stdout, each.process.stderr):
            if stream is not None:
                stream.close()


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGINT for another process")
def test_a_case_is_edited_solved_saved(start: Start, case: Path, tmp_path: Path) -> None:
    """Over a socket: page, edit, events up to the result, scene, summary, save, a second start, Ctrl-C."""
    app = start(case)
    assert app.host == "127.0.0.1"
    assert app.url.startswith("http://127.0.0.1:")
    assert len(app.token) >= 40
    status, page = app.ask("GET", "/")
    assert (status, page[:15].lower()) == (200, b"<!doctype html>")
    for headers in ({"Host": "evil.example"}, {"Origin": "http://evil.example"}, {"X-Groundslab-Token": "wrong"}):
        assert app.ask("GET", "/api/state", **headers)[0] == 403
    stream = app.listen()
    first = app.get("/api/state")
    assert app.wait("state", version=first["version"])
    app.wait("solved", version=first["version"])

    state = app.set(["plate", "thickness"], "300 mm")
    reported = app.wait("solved", version=state["version"])
    assert reported["refused"] == {}
    # a preview comes where the machine is slow
    on_the_way = ("progress", "preview")
    names = [name for name, about in app.events if about.get("run") == reported["run"] and name not in on_the_way]
    assert names == ["solving", "solved"]
    scene = unpack(app.ask("GET", f"/api/results/{reported['run']}/scene")[1])
    assert scene.head["plan"]["bounds"] == state["plan"]["bounds"] == [-3, -2, 3, 2]
    (combination,) = app.get(f"/api/results/{reported['run']}/summary")["combinations"]
    assert combination["certificate"]["holds"] is True
    rows = {row["key"]: row for section in combination["sections"] for row in section["rows"]}
    assert rows["thickness"]["value"] == "0.30000"
    assert (rows["load"]["value"], rows["load"]["unit"]) == ("200.00", "kN")

    assert app.post("/api/save")["dirty"] is False
    assert case.read_text(encoding="utf-8") == CASE.replace("250 mm", "300 mm")

    asked = tmp_path / "asked.txt"
    writer = "import sys, pathlib; pathlib.Path(sys.argv[1]).write_text(sys.argv[2])"
    second = start(case, BROWSER=f"{sys.executable} -c '{writer}' {asked} %s")
    assert second.url == app.url
    code, messages = second.process.wait(PATIENCE), second.process.stderr
    assert messages is not None
    assert (code, messages.read()) == (0, f"{case} is open already, in process {app.process.pid}\n")

    shown = urlsplit(asked.read_text(encoding="utf-8"))
    assert app.token not in shown.geturl()
    connection = app.connection()
    for status, place in ((303, f"/?token={app.token}"), (403, None)):
        connection.request("GET", f"{shown.path}?{shown.query}")
        answer = connection.getresponse()
        answer.read()
        assert (answer.status, answer.getheader("location")) == (status, place)
    connection.close()

    app.set(["plate", "nu"], 0.25)
    code, words = app.end(signal.SIGINT)
    assert code == 0
    assert words == f"unsaved work is kept in {case.with_name('.plate.toml.unsaved')}; the next start offers it\n"
    stream.join(PATIENCE)
    assert not stream.is_alive()


@pytest.mark.skipif(os.name == "nt", reason="the signal is called otherwise there")
def test_nothing_is_lost_when_the_server_is_killed(start: Start, case: Path) -> None:
    """Killed in the middle of solving a large mesh: the solver's process ends too, the next start has the work."""
    app = start(case)
    app.listen()
    app.wait("solved")
    app.set(["title"], "ä work of hours")
    state = app.set(["mesh"], {"counts": [400, 300]})
    app.wait("progress")
    begun = time.monotonic()
    code, _ = app.end(signal.SIGKILL)
    assert code == -signal.SIGKILL
    assert time.monotonic() - begun < PATIENCE / 2
    assert case.read_text(encoding="utf-8") == CASE

    again = start(case)
    assert again.port is not None
    offered = again.get("/api/state")
    assert offered["text"] == CASE
    assert offered["offer"]["file"] == str(case)
    assert again.post("/api/autosolve", {"on": False}) == {}
    restored = again.post("/api/restore", {"take": True})
    assert restored["text"] == state["text"]
    assert casefile.loads(restored["text"]).title == "ä work of hours"
    assert again.post("/api/undo")["text"] == CASE


def test_work_without_a_name_is_found_after_a_kill(start: Start) -> None:
    """A document that was never saved anywhere is offered by the next start without a case."""
    app = start()
    state = app.set(["title"], "never saved")
    app.process.kill()
    app.process.communicate()
    again = start()
    assert again.get("/api/state")["offer"]["file"] is None
    assert again.post("/api/restore", {"take": True})["text"] == state["text"]


def test_what_cannot_be_served(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """No such case, a port out of range, packages that are missing: exit code 2, and what to do."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.setenv("WIN_PD_OVERRIDE_LOCAL_APPDATA", str(tmp_path))
    monkeypatch.setenv("HOME", str(tmp_path))
    assert main.main(["app", str(tmp_path / "none.toml"), "--no-browser"]) == 2
    assert "no file of that name" in capsys.readouterr().err
    assert main.main(["app", "--port", "70000", "--no-browser"]) == 2
    assert "a port that is free" in capsys.readouterr().err
    monkeypatch.setitem(sys.modules, "uvicorn", None)
    assert main.main(["app"]) == 2
    assert 'pip install ".[app]"' in capsys.readouterr().err
