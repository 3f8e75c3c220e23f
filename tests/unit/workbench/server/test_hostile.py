"""A client that means no good: whatever it sends, the server says no, and goes on."""

from __future__ import annotations

import http.client
import json
import random
import re
import socket
import threading
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlencode, urlsplit

import pytest

from groundslab import workbench
from helpers.browsing import SMALL, Server
from helpers.examples import examples

pytestmark = pytest.mark.slow

PATIENCE = 60  # s
JUNK: list[Any] = [
    *(None, True, -1, 1e308, 10**30, "", "\0", "\ud800", "x" * 100_000, "../../etc/passwd", "1e999 m", "1 m; rm"),
    *([], {}, [[]], {"a": {"b": [1]}}, ["plate"], ["loads", -1], ["loads", 10**18], ["loads", 0.5], ["plate"] * 500),
]
FILES = ["/dev/zero", "/proc/self/mem", "/etc/passwd", "..", "/dev/stdin", "\0", "x" * 5000, "none/case.toml"]
PARTS = ["1", "0", "-1", "9" * 20, "..%2f..%2fetc", "%2e%2e", "%00", "x", "summary", "a" * 2000]
FIELDS = ["file", "over", "layers", "unit", "gap", "slab", "take", "on", "combination", "base", "edits", "reading"]
BODIES = [b"", b"{", b"[]", b"null", b"\xff\xfe", b'{"edits":' + b"[" * 100_000, b'{"a":1e99999}', b"NaN", b'"x"']


class Client:
    """Sends what it likes, and counts on an answer that is no error of the server."""

    def __init__(self, url: str) -> None:
        parts = urlsplit(url)
        assert parts.hostname is not None
        assert parts.port is not None
        self.address = (parts.hostname, parts.port)
        self.token = parse_qs(parts.query)["token"][0]
        self.random = random.Random(7)

    def ask(self, method: str, path: str, body: bytes | None = None) -> tuple[int, bytes]:
        """Return status and content of an answer."""
        connection = http.client.HTTPConnection(*self.address, timeout=PATIENCE)
        headers = {"X-Groundslab-Token": self.token, "Content-Type": "application/json"}
        try:
            connection.request(method, path, body, headers)
            answer = connection.getresponse()
            content = answer.read()
        finally:
            connection.close()
        assert answer.status < 500, (method, path[:200], body and body[:500])
        return answer.status, content

    def post(self, path: str, body: Any) -> int:
        """Return the status of an answer to data."""
        return self.ask("POST", path, json.dumps(body).encode())[0]

    def state(self) -> dict[str, Any]:
        """Return the present state, which the server has still."""
        status, content = self.ask("GET", "/api/state")
        assert status == 200
        state: dict[str, Any] = json.loads(content)
        return state

    def send(self, content: bytes) -> socket.socket:
        """Return a connection on which bytes were sent."""
        connection = socket.create_connection(self.address, timeout=PATIENCE)
        connection.sendall(content)
        return connection

    def anything(self, depth: int = 0) -> Any:
        """Return anything."""
        kind = self.random.random()
        if depth < 3 and kind < 0.2:
            return {str(self.random.choice(JUNK))[:20]: self.anything(depth + 1) for _ in range(3)}
        if depth < 3 and kind < 0.35:
            return [self.anything(depth + 1) for _ in range(3)]
        return self.random.choice(JUNK)


@pytest.fixture
def client(tmp_path: Path) -> Iterator[Client]:
    """A client of a server on a small slab."""
    case = tmp_path / "slab.toml"
    case.write_text(SMALL, encoding="utf-8")
    server = Server(tmp_path / "state")
    yield Client(server.start(case))
    server.stop()


def test_edits_of_anything(client: Client) -> None:
    """Operations, paths and values of all sorts: each is refused or undone, in the end the text is as it was."""
    text = client.state()["text"]
    choose = client.random.choice
    taken = 0
    for _ in range(examples(300)):
        edit = {"op": choose(["set", "length", "add", "remove", "rename", "reorder", "text", "move", "", 5])}
        edit["path"] = choose([["plate", "E"], ["loads", 0], ["columns", 0, "name"], ["loads"], client.anything()])
        edit |= {name: client.anything() for name in ("value", "name", "at", "by") if choose([True, False])}
        if client.post("/api/edits", {"edits": [edit]}) == 200:
            taken += 1
            client.post("/api/undo", {})
            assert client.state()["text"] == text
    assert taken > 6, "some have a meaning"


def test_every_route_with_anything(client: Client) -> None:
    """Routes, files, numbers and names that are none, bodies that are no data, methods that there are not."""
    sources = "".join(path.read_text(encoding="utf-8") for path in Path(workbench.__file__).parent.rglob("*.py"))
    # the stream of events never ends
    routes = sorted(set(re.findall(r'"(/api/[a-z][^"]*)"', sources)) - {"/api/events"})
    assert len(routes) > 30
    choose, sample = client.random.choice, client.random.sample
    for route in routes:
        for _ in range(2):
            path = re.sub(r"\{[^}]*\}", lambda _: choose(PARTS), route)
            body = {name: client.anything() for name in sample(FIELDS, 4)}
            client.post(path, body | ({"file": choose(FILES)} if "file" in body else {}))
            query = {name: choose([*FILES, *PARTS])[:3000] for name in sample(FIELDS, 3)}
            client.ask("GET", f"{path}?{urlencode(query)}")
        for content in BODIES:
            client.ask("POST", path, content)
        for method in ("PUT", "DELETE", "OPTIONS", "PATCH", "HEAD"):
            client.ask(method, path)
    assert client.post("/api/edits", {"edits": [{"op": "text", "value": SMALL}]}) == 200
    assert client.state()["text"] == SMALL


def test_connections_that_lead_to_nothing(client: Client) -> None:
    """No HTTP, heads without an end, bodies that never come, streams that nobody reads: others are answered."""
    host = "{}:{}".format(*client.address)
    head = f"Host: {host}\r\nX-Groundslab-Token: {client.token}\r\n".encode()
    body = head + b"Content-Type: application/json\r\nContent-Length: 100\r\n\r\n{"
    for content in (b"\x16\x03\x01" + bytes(500), b"GET /api/state HTTP/1.1\r\nX: " + b"a" * 200_000 + b"\r\n\r\n"):
        with client.send(content) as connection:
            assert connection.recv(100).startswith(b"HTTP/1.1 400")
    for place in (b"/../../etc/passwd", b"/%2e%2e/%2e%2e/etc/passwd", b"//etc/passwd"):
        with client.send(b"GET " + place + b" HTTP/1.1\r\n" + head + b"\r\n") as connection:
            assert connection.recv(100).startswith(b"HTTP/1.1 404")
    slow = [client.send(b"POST /api/edits HTTP/1.1\r\n" + body) for _ in range(100)]
    streams = [client.send(b"GET /api/events HTTP/1.1\r\n" + head + b"\r\n") for _ in range(100)]
    assert client.state()["text"] == SMALL
    for connection in [*slow, *streams]:
        connection.close()
    assert client.state()["text"] == SMALL


def test_many_at_once(client: Client) -> None:
    """Edits, runs, ends of runs and undoing from eight sides at once: one of the texts is there in the end."""

    def press(n: int) -> None:
        for k in range(12):
            client.post("/api/edits", {"edits": [{"op": "set", "path": ["title"], "value": f"{n} {k}"}]})
            client.post(["/api/solve", "/api/cancel", "/api/undo", "/api/redo"][k % 4], {})

    threads = [threading.Thread(target=press, args=(n,)) for n in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    state = client.state()
    assert state["issues"] == []
    title = tomllib.loads(state["text"])["title"]
    assert title in {f"{n} {k}" for n in range(8) for k in range(12)} | {"A small slab"}
