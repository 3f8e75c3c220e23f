"""Start and end of the workbench's server, which is reachable from this machine only."""

from __future__ import annotations

import http.client
import json
import os
import secrets
import signal
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

from groundslab.errors import InputError, Issue
from groundslab.workbench.events import Hub
from groundslab.workbench.persistence import files
from groundslab.workbench.server.security import Tickets

if TYPE_CHECKING:
    from groundslab.workbench.server.security import Guard

ADDRESS = "127.0.0.1"


def serve(case: Path | None, port: int = 0, browser: bool = True) -> None:
    """Serve the workbench until it is interrupted; raises InputError if it cannot start or the case is not valid.

    Port 0 stands for any free one. If another workbench has the case open, its address is printed instead.
    """
    _require_packages()
    from groundslab.workbench.server.case_file import OpenElsewhere
    from groundslab.workbench.server.routes import create_app
    from groundslab.workbench.server.session import Session
    from groundslab.workbench.solver.thread import Solver

    state = files.create_state_folder()
    with _bind(port) as listener:
        port = listener.getsockname()[1]
        token = secrets.token_urlsafe(32)
        url = f"http://{ADDRESS}:{port}/?token={token}"
        hub, tickets = Hub(), Tickets()
        session = Session(hub, Solver(hub.publish), state, url)
        try:
            if case is not None:
                session.open(str(case.absolute()))
        except OpenElsewhere as elsewhere:
            session.close()
            _print_message(f"{case} is open already, in process {elsewhere.pid}")
            print(elsewhere.url, flush=True)
            if browser:
                _open_browser(elsewhere.url, _request_ticket(elsewhere.url))
            return
        except InputError:
            session.close()
            raise
        try:
            _run(create_app(session, tickets, port, token), tickets, hub, listener, url, browser)
        finally:
            unsaved = session.close()
            if unsaved:
                _print_message(f"unsaved work is kept in {unsaved}; the next start offers it")


def serve_results(path: Path, port: int = 0, browser: bool = True) -> None:
    """Serve the results in a folder or an archive, read-only, until interrupted; raises InputError."""
    _require_packages()
    from groundslab.workbench.server.view import ResultsView, create_view_app

    view = ResultsView.read(path)
    with _bind(port) as listener:
        port, token, tickets = listener.getsockname()[1], secrets.token_urlsafe(32), Tickets()
        url = f"http://{ADDRESS}:{port}/?token={token}"
        _run(create_view_app(view, tickets, port, token), tickets, view.hub, listener, url, browser)


def _run(app: Guard, tickets: Tickets, hub: Hub, listener: socket.socket, url: str, browser: bool) -> None:
    """Run a server until it is interrupted; its address is printed when it can be used, and opened if wanted."""
    import uvicorn

    config = uvicorn.Config(
        app,
        log_level="warning",
        access_log=False,
        server_header=False,
        lifespan="off",
        loop="asyncio",
        http="h11",
        ws="none",
        timeout_graceful_shutdown=2,
    )

    def on_start() -> None:
        print(url, flush=True)
        if browser:
            threading.Thread(target=_open_browser, args=(url, tickets.issue()), daemon=True).start()

    with suppress(KeyboardInterrupt):  # the usual end
        _create_server(config, hub, on_start).run([listener])


def _require_packages() -> None:
    """Raise InputError if the packages of a server are missing."""
    try:
        for name in ("fastapi", "filelock", "platformdirs", "uvicorn"):
            import_module(name)
    except ImportError as error:
        hint = 'pip install ".[app]"'
        issue = Issue("groundslab app", f"no package {error.name}", "the packages of the workbench", hint)
        raise InputError([issue]) from None


def _bind(port: int) -> socket.socket:
    """Return a socket bound to this machine's loopback address; raises InputError if the port is taken."""
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    try:
        if sys.platform == "win32":
            # otherwise another program could bind the same port and receive our requests
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
        else:
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((ADDRESS, port))
    except (OSError, OverflowError) as error:
        listener.close()
        busy_port = f"{port} ({files.describe_error(error)})"
        raise InputError([Issue("--port", busy_port, "a port that is free", "leave it out for any")]) from None
    return listener


def _create_server(config: Any, hub: Hub, on_start: Callable[[], None]) -> Any:
    """Return a server that calls ``on_start``, and closes the hub when it ends so that no page delays it."""
    import uvicorn

    class Server(uvicorn.Server):
        async def startup(self, sockets: list[socket.socket] | None = None) -> None:
            await super().startup(sockets)
            on_start()

        def handle_exit(self, sig: int, frame: FrameType | None) -> None:
            hub.close()
            super().handle_exit(sig, frame)

    signal.signal(signal.SIGTERM, signal.default_int_handler)  # ends like Ctrl-C
    return Server(config)


def _open_browser(url: str, ticket: str) -> None:
    """Open a server's page in the browser; other users may see the address, so it has a ticket instead of the token."""
    if ticket and _has_display():
        parts = urlsplit(url)
        webbrowser.open(f"{parts.scheme}://{parts.netloc}/open?ticket={ticket}")


def _has_display() -> bool:
    """Whether a graphical browser can be opened; a text browser would block the terminal."""
    graphical = any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER", "WSL_DISTRO_NAME"))
    return sys.platform in ("win32", "darwin") or graphical


def _request_ticket(url: str) -> str:
    """Return a ticket of the server at a URL, empty if it does not answer."""
    parts = urlsplit(url)
    connection = http.client.HTTPConnection(parts.netloc, timeout=5)
    headers = {"X-Groundslab-Token": parts.query.partition("=")[2], "Content-Type": "application/json"}
    try:
        connection.request("POST", "/api/ticket", "{}", headers)
        return str(json.loads(connection.getresponse().read())["ticket"])
    except (OSError, http.client.HTTPException, ValueError, KeyError):
        return ""
    finally:
        connection.close()


def _print_message(text: str) -> None:
    print(text, file=sys.stderr, flush=True)
