"""A client of the Model Context Protocol uses every tool, and reaches nothing outside the folder."""

from __future__ import annotations

import base64
import json
import os
import subprocess
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest

from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.views.files import results_folder
from helpers import asgi, small_case, workers
from helpers.paths import DOCS, ROOT

pytest.importorskip("mcp")
import anyio
import anyio.lowlevel
from mcp import Client, MCPError
from mcp.client.stdio import StdioServerParameters

from groundslab.workbench.assistants import server, tasks
from groundslab.workbench.assistants.process import TaskRefused, outcome_of, run

#: A slab that takes long enough to be cancelled: a fine mesh, of which the first step is told early.
LARGE = small_case.TEXT.replace("counts = [4, 3]", "counts = [160, 120]")


def converse(root: Path, talk: Callable[[Client], Awaitable[Any]]) -> Any:
    """Start a server for a folder in a process of its own and return what a conversation comes to."""
    path = os.pathsep.join(filter(None, [str(ROOT / "src"), os.environ.get("PYTHONPATH", "")]))
    arguments = ["-m", "groundslab", "mcp", str(root)]
    parameters = StdioServerParameters(command=sys.executable, args=arguments, env={"PYTHONPATH": path})

    async def talk_to_it() -> Any:
        async with Client(parameters) as client:
            return await talk(client)

    return asgi.run(talk_to_it())


def converse_here(root: Path, talk: Callable[[Client], Awaitable[Any]]) -> Any:
    """Return what a conversation comes to with a server for a folder in this process, where it also does its tasks."""

    async def do_here(task: Callable[..., Any], *arguments: Any, **_: Any) -> Any:
        kind, content = outcome_of(task, lambda _: None, *arguments)
        if kind == "refused":
            raise TaskRefused(content)
        return content

    async def talk_to_it() -> Any:
        async with Client(server.create_server(root)) as client:
            return await talk(client)

    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(server, "run", do_here)
        return asgi.run(talk_to_it())


def document(answer: Any) -> dict[str, Any]:
    """Return the document of an answer, which is its text."""
    return dict(json.loads(answer.content[0].text))


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """Return the folder that is served, with a case."""
    folder = tmp_path / "served"
    folder.mkdir()
    (folder / "slab.toml").write_text(small_case.TEXT, encoding="utf-8")
    return folder


@pytest.mark.slow
def test_every_tool(root: Path) -> None:
    """Check, solve, checks, tables and plot of a case: documents with the published shapes, files in the folder."""
    jsonschema = pytest.importorskip("jsonschema")
    told: list[str] = []

    async def progress(_number: float, _total: float | None, words: str | None) -> None:
        told.append(str(words))

    async def talk(client: Client) -> dict[str, Any]:
        listed = await client.list_tools()
        assert {tool.name for tool in listed.tools} == {"check", "solve", "checks", "tables", "plot"}
        assert all(tool.description and tool.input_schema["properties"] for tool in listed.tools)
        return {
            "check": await client.call_tool("check", {"case": "slab.toml"}),
            "summary": await client.call_tool("solve", {"case": "slab.toml"}, progress_callback=progress),
            "design": await client.call_tool("checks", {"results": "slab-results"}),
            "tables": await client.call_tool("tables", {"results": "slab-results", "names": ["tilt", "extremes"]}),
            "plot": await client.call_tool("plot", {"results": "slab-results", "file": "w.png", "fields": ["w"]}),
        }

    answers = converse(root, talk)
    assert not any(answer.is_error for answer in answers.values())
    picture = answers.pop("plot").content[1]
    assert base64.b64decode(picture.data) == (root / "w.png").read_bytes()
    for name, answer in answers.items():
        assert answer.structured_content == document(answer)
        schema = json.loads((DOCS / "interface" / f"{name}.schema.json").read_text(encoding="utf-8"))
        jsonschema.validate(document(answer), schema)
    assert document(answers["summary"])["certified"] is True
    assert [table["name"] for table in document(answers["tables"])["tables"]] == ["extremes", "tilt"]
    assert told[0].endswith("begins")
    assert sorted(path.name for path in root.iterdir()) == ["slab-results", "slab.toml", "w.png"]


def test_edited_results_are_kept_and_told(root: Path) -> None:
    """The summary says in its remarks where a file is kept that somebody had edited."""
    assert tasks.solve(lambda _: None, root, "slab.toml", "", False)["remarks"] == []
    with (root / "slab-results" / "case.toml").open("a", encoding="utf-8") as file:
        file.write("# a note\n")
    (remark,) = tasks.solve(lambda _: None, root, "slab.toml", "", False)["remarks"]
    assert "slab-results-edited" in remark


@pytest.mark.slow
def test_wrong_input(root: Path) -> None:
    """A wrong case is an answer with its issues; what else cannot be done is an error with its issues."""
    (root / "wrong.toml").write_text(small_case.TEXT.replace("0.2", "0.7"), encoding="utf-8")
    calls: list[tuple[str, dict[str, Any]]] = [
        ("check", {"case": "wrong.toml"}),
        ("solve", {"case": "wrong.toml"}),
        ("check", {"case": "other.toml"}),
        ("tables", {"results": "slab-results", "names": ["tilt"]}),
        ("plot", {"results": "slab.toml", "file": "w.png"}),
    ]

    async def talk(client: Client) -> list[Any]:
        return [await client.call_tool(name, arguments) for name, arguments in calls]

    checked, *errors = converse_here(root, talk)
    assert not checked.is_error
    assert [issue["location"] for issue in document(checked)["issues"]] == ["plate.nu"]
    assert all(error.is_error for error in errors)
    locations = [[issue["location"] for issue in document(error)["error"]["issues"]] for error in errors]
    assert locations == [["plate.nu"], ["case"], ["results"], ["results"]]
    assert "slab.toml or wrong.toml" in document(errors[1])["error"]["message"]


@pytest.mark.slow
def test_hostile_paths(root: Path, tmp_path: Path) -> None:
    """Whatever a path is called and whatever links there are, nothing outside the folder is read, written or named."""
    outside = tmp_path / "outside"
    outside.mkdir()
    (outside / "secret.toml").write_text(small_case.TEXT, encoding="utf-8")
    assert main.main(["solve", str(outside / "secret.toml"), "--quiet"]) == 0
    (root / "link.toml").symlink_to(outside / "secret.toml")
    (root / "far").symlink_to(outside)
    (root / "mixed").mkdir()
    (root / "mixed" / "summary.json").symlink_to(outside / "secret-results" / "summary.json")
    (root / "frame.csv").symlink_to(outside / "secret.toml")
    (root / "frame.toml").write_text('[building]\nfile = "frame.csv"\n' + small_case.TEXT, encoding="utf-8")
    before = sorted(outside.rglob("*"))
    calls: list[tuple[str, dict[str, Any]]] = [
        *(
            ("check", {"case": name})
            for name in ("../outside/secret.toml", str(outside / "secret.toml"), "link.toml", "far/secret.toml", "a\0b")
        ),
        ("check", {"case": "frame.toml"}),
        ("solve", {"case": "slab.toml", "out": "../outside/new"}),
        ("solve", {"case": "slab.toml", "out": "far/new"}),
        ("solve", {"case": "slab.toml", "out": "."}),
        ("checks", {"results": "far/secret-results"}),
        ("tables", {"results": "mixed", "names": ["tilt"]}),
        ("checks", {"results": "../outside/secret-results"}),
    ]

    async def talk(client: Client) -> list[Any]:
        return [await client.call_tool(name, arguments) for name, arguments in calls]

    answers = converse_here(root, talk)
    refused = [answer.is_error or document(answer)["status"] == "wrong input" for answer in answers]
    assert refused == [True] * len(calls)
    assert '"issues": [{' in answers[5].content[0].text
    assert "secret" not in document(answers[5])["issues"][0]["found"]
    assert sorted(outside.rglob("*")) == before


@pytest.mark.slow
def test_a_link_that_is_put_into_a_path_meanwhile(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where a folder becomes a link that leads out while a case is solved or drawn, nothing is written."""
    outside = tmp_path / "outside"
    outside.mkdir()

    def swap(name: str) -> None:
        if (root / name).is_dir() and not (root / name).is_symlink():
            (root / name).rename(root / f"{name}-before")
            (root / name).symlink_to(outside)

    (root / "deep").mkdir()
    with pytest.raises(InputError, match="out: found"):
        tasks.solve(lambda _: swap("deep"), root, "slab.toml", "deep/results", False)
    tasks.solve(lambda _: None, root, "slab.toml", "", False)
    (root / "figures").mkdir()
    load = results_folder.load_results

    def load_slowly(folder: Path) -> Any:
        swap("figures")
        return load(folder)

    monkeypatch.setattr(results_folder, "load_results", load_slowly)
    request = dict.fromkeys(("kind", "envelope", "line"), None) | {"fields": ["w"], "combination": [], "mesh": False}
    with pytest.raises(InputError, match="file: found"):
        tasks.plot(lambda _: None, root, "slab-results", "figures/w.png", request)
    assert list(outside.iterdir()) == []


@pytest.mark.slow
def test_a_request_with_half_a_letter_is_answered(root: Path) -> None:
    """A lone surrogate in a request, which no JSON may hold, is an error with the number of the request."""
    path = os.pathsep.join(filter(None, [str(ROOT / "src"), os.environ.get("PYTHONPATH", "")]))
    about = {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}}
    requests = [
        json.dumps({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": about}),
        json.dumps({"jsonrpc": "2.0", "method": "notifications/initialized"}),
        r'{"jsonrpc": "2.0", "id": 2, "method": "tools/call", "params": '
        r'{"name": "check", "arguments": {"case": "\ud800.toml"}}}',
        json.dumps({"jsonrpc": "2.0", "id": 3, "method": "tools/list"}),
    ]
    command = [sys.executable, "-m", "groundslab", "mcp", str(root)]
    environment = os.environ | {"PYTHONPATH": path}
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8", env=environment
    ) as server:
        assert server.stdin is not None
        assert server.stdout is not None
        answers: dict[int, dict[str, Any]] = {}
        server.stdin.write("".join(f"{request}\n" for request in requests))
        server.stdin.flush()
        while len(answers) < 3:
            answer = json.loads(server.stdout.readline())
            answers[answer["id"]] = answer
        server.stdin.close()
    assert answers[2]["error"]["code"] == -32700
    assert "half of a letter" in answers[2]["error"]["message"]
    assert len(answers[3]["result"]["tools"]) == 5


def test_few_processes_run_at_once(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a dozen calls four run, and the others wait; none is lost."""
    now = most = done = 0

    async def count(*_: object, **__: object) -> str:
        nonlocal now, most, done
        now += 1
        most = max(most, now)
        for _turn in range(5):
            await anyio.lowlevel.checkpoint()
        now, done = now - 1, done + 1
        return "done"

    monkeypatch.setattr(server, "run", count)

    async def call() -> None:
        tools = server.Tools(root)
        async with anyio.create_task_group() as group:
            for _ in range(12):
                group.start_soon(tools._run, None, print)

    asgi.run(call())
    assert (most, done) == (server.MOST_PROCESSES, 12)


@pytest.mark.slow
def test_solves_that_are_given_up_make_room_for_the_next(root: Path) -> None:
    """Cancelled at its first message, it writes nothing; nor does one whose client does not wait. The server goes on.

    The next case is solved then.
    """
    (root / "large.toml").write_text(LARGE, encoding="utf-8")

    async def talk(client: Client) -> Any:
        with anyio.CancelScope() as scope:

            async def cancel(*_: object) -> None:
                scope.cancel()

            await client.call_tool("solve", {"case": "large.toml"}, progress_callback=cancel)
        assert scope.cancelled_caught
        with pytest.raises(MCPError, match="timed out"):
            await client.call_tool("solve", {"case": "large.toml"}, read_timeout_seconds=0.5)
        return await client.call_tool("solve", {"case": "slab.toml"})

    assert not converse(root, talk).is_error
    assert sorted(path.name for path in root.iterdir()) == ["large.toml", "slab-results", "slab.toml"]


@pytest.mark.skipif(sys.platform == "win32", reason="os.kill with 0 ends a process there")
def test_a_task_that_is_cancelled_is_killed() -> None:
    """Its process does not exist any more when the call is over."""
    told: list[str] = []

    async def cancelled() -> None:
        with anyio.CancelScope() as scope:

            async def tell(words: str) -> None:
                told.append(words)
                scope.cancel()

            await run(workers.wait_forever, tell=tell)

    asgi.run(cancelled())
    with pytest.raises(ProcessLookupError):
        os.kill(int(told[0]), 0)


@pytest.mark.parametrize(
    ("task", "words"), [(workers.end_at_once, "ended unexpectedly"), (workers.print_and_fail, "ZeroDivisionError")]
)
def test_a_task_that_fails(task: Callable[..., Any], words: str, capfd: pytest.CaptureFixture[str]) -> None:
    """The end of its process and an error in it are told; what it prints does not get into the protocol."""

    async def tell(_: str) -> None:
        raise AssertionError("nothing was to be told")

    with pytest.raises(TaskRefused) as refused:
        asgi.run(run(task, tell=tell))
    assert words in refused.value.document["error"]["message"]
    assert "noise" not in capfd.readouterr().out


def test_the_folder_must_exist(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The command says so before it begins."""
    assert main.main(["mcp", str(tmp_path / "nothing")]) == 2
    assert "a folder that exists" in capsys.readouterr().err
