"""The server: its tools with typed arguments, their answers, and their errors."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import anyio
from mcp.server.lowlevel.server import Server
from mcp.server.mcpserver import Context, Image, MCPServer
from mcp.server.stdio import stdio_server
from mcp.shared.message import SessionMessage
from mcp_types import PARSE_ERROR, CallToolResult, ErrorData, JSONRPCError, TextContent, ToolAnnotations
from pydantic import Field, ValidationError

from groundslab._version import __version__
from groundslab.model.loads.load_cases import LimitState
from groundslab.views.interface import shapes
from groundslab.views.plots.request import Kind
from groundslab.workbench.assistants import tasks
from groundslab.workbench.assistants.process import TaskRefused, run

INSTRUCTIONS = """\
groundslab analyzes plates on the ground: rafts, pads, industrial floors. A case is a TOML file in this server's folder.
Check it, solve it, then read checks, tables and figures of the results. A result is to be used only if it is certified,
and a certificate is no approval of a design. Forces, moments and pressures have units; those in documents are SI."""

#: So many processes run at once; further calls wait.
MOST_PROCESSES = 4

Case = Annotated[str, Field(description="case file (TOML), relative to the server's folder")]
Results = Annotated[str, Field(description="folder of results that solve has written, relative to the server's folder")]
Full = Annotated[bool, Field(description="whether to return every figure and calculation, which may be very long")]
Line = Annotated[list[float], Field(min_length=4, max_length=4, description="x1, y1, x2, y2 in meters")]


class Tools:
    """The tools for one folder; one case is solved at a time, and few processes are there at once."""

    def __init__(self, root: Path) -> None:
        self._root = root
        self._solving = anyio.Lock()
        self._processes = anyio.CapacityLimiter(MOST_PROCESSES)

    async def check(self, case: Case, context: Context) -> Annotated[CallToolResult, shapes.CheckedFile]:
        """Read a case file and list all its issues, each with what was found, what is expected, and a hint.

        Combinations of loads that nothing balances are named. Nothing is solved or written.
        """
        return await self._answer(context, tasks.check, case)

    async def solve(
        self,
        case: Case,
        context: Context,
        out: Annotated[str, Field(description="folder for the results (default: CASE-results next to the case)")] = "",
        full: Full = False,
    ) -> Annotated[CallToolResult, shapes.Summary]:
        """Solve all combinations of a case, write the results into a folder, and return their summary.

        The summary has extremes with their discretization errors, the certificate, and all design checks. Earlier
        results in the folder are replaced; other files never are.
        """
        async with self._solving:
            return await self._answer(context, tasks.solve, case, out, full)

    async def checks(
        self, results: Results, context: Context, full: Full = False
    ) -> Annotated[CallToolResult, shapes.DesignOfResults]:
        """Return the design checks of results, the worst first: demand, resistance, utilization, clause and place."""
        return await self._answer(context, tasks.checks, results, full)

    async def tables(
        self,
        results: Results,
        names: Annotated[list[str], Field(min_length=1, description="such as extremes, tilt, reinforcement, columns")],
        context: Context,
    ) -> Annotated[CallToolResult, shapes.Tables]:
        """Return tables of results by their names; a name that there is not is answered with those that there are."""
        return await self._answer(context, tasks.tables, results, names)

    async def plot(
        self,
        results: Results,
        file: Annotated[str, Field(description="file to write, ending in .png, .svg or .pdf; a PNG is shown, too")],
        context: Context,
        fields: Annotated[list[str], Field(description="such as settlement, pressure, moment_x, bottom_x")] = [],  # noqa: B006
        kind: Kind | None = None,
        combination: Annotated[list[str], Field(description="combinations to draw (default: all certified)")] = [],  # noqa: B006
        envelope: Annotated[LimitState | None, Field(description="limit state whose envelope is drawn")] = None,
        line: Annotated[list[Line], Field(description="section lines")] = [],  # noqa: B006
        mesh: Annotated[bool, Field(description="whether to draw the elements, too")] = False,
    ) -> CallToolResult:
        """Draw a figure of results into a file, which is replaced only if groundslab drew it."""
        request = {
            "fields": fields, "kind": kind, "combination": combination, "envelope": envelope, "line": line or None,
            "mesh": mesh,
        }  # fmt: skip
        try:
            name, content = await self._run(context, tasks.plot, results, file, request)
        except TaskRefused as refused:
            return _refuse(refused.document)
        picture = [Image(data=content, format="png").to_image_content()] if content else []
        return CallToolResult(content=[TextContent(type="text", text=f"wrote {name}"), *picture])

    async def _answer(self, context: Context, task: Callable[..., Any], *arguments: Any) -> CallToolResult:
        """Return the document of a task, or that of its error."""
        try:
            document = await self._run(context, task, *arguments)
        except TaskRefused as refused:
            return _refuse(refused.document)
        text = _to_text(document)
        return CallToolResult(content=[TextContent(type="text", text=text)], structured_content=json.loads(text))

    async def _run(self, context: Context, task: Callable[..., Any], *arguments: Any) -> Any:
        """Return what a task returns; it waits until there are fewer processes than the most."""
        async with self._processes:
            return await run(task, self._root, *arguments, tell=_telling(context))


def create_server(root: Path) -> MCPServer:
    """Return the server for a folder, given by its full path without links."""
    server = MCPServer("groundslab", instructions=INSTRUCTIONS, version=__version__, log_level="WARNING")
    tools = Tools(root)
    reads = ToolAnnotations(read_only_hint=True, open_world_hint=False)
    writes = ToolAnnotations(read_only_hint=False, destructive_hint=False, idempotent_hint=True, open_world_hint=False)
    server.add_tool(tools.check, annotations=reads)
    server.add_tool(tools.solve, annotations=writes)
    server.add_tool(tools.checks, annotations=reads)
    server.add_tool(tools.tables, annotations=reads)
    server.add_tool(tools.plot, annotations=writes)
    return server


def serve(root: Path) -> None:
    """Serve a folder on standard input and output until the input ends."""
    anyio.run(_serve, create_server(root)._lowlevel_server)


async def _serve(server: Server[Any]) -> None:
    """Serve on standard input and output; a request that cannot be read, as by a lone surrogate, is answered, too."""
    async with stdio_server() as (requests, answers), anyio.create_task_group() as group:
        readable_in, readable = anyio.create_memory_object_stream[SessionMessage | Exception]()

        async def sort_out() -> None:
            async with readable_in:
                async for request in requests:
                    refusal = _unreadable(request) if isinstance(request, Exception) else None
                    await (readable_in.send(request) if refusal is None else answers.send(refusal))

        group.start_soon(sort_out)
        await server.run(readable, answers, server.create_initialization_options())


def _unreadable(error: Exception) -> SessionMessage | None:
    """Return the answer to a request that is no JSON as the protocol has it, None where it has no identifier."""
    lines = [fault["input"] for fault in error.errors()] if isinstance(error, ValidationError) else []
    try:
        number = json.loads(lines[0])["id"]
    except (IndexError, KeyError, TypeError, ValueError, RecursionError):
        return None
    if not isinstance(number, int | str) or (isinstance(number, str) and not number.isascii()):
        return None
    said = ErrorData(
        code=PARSE_ERROR, message="the request cannot be read: found text that is no Unicode, such as half of a letter"
    )
    return SessionMessage(JSONRPCError(jsonrpc="2.0", id=number, error=said))


def _telling(context: Context) -> Callable[[str], Any]:
    """Return what tells the client how a task goes on."""
    count = 0

    async def tell(words: str) -> None:
        nonlocal count
        count += 1
        await context.report_progress(count, message=words)

    return tell


def _refuse(document: dict[str, Any]) -> CallToolResult:
    """Return an error of a tool, with its document as text."""
    return CallToolResult(content=[TextContent(type="text", text=_to_text(document))], is_error=True)


def _to_text(document: dict[str, Any]) -> str:
    """Return a document as text on one line; numbers of NumPy become Python's."""
    return json.dumps(document, allow_nan=False, default=lambda number: number.item())
