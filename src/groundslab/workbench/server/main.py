"""Starting and ending the workbench's server, on this machine alone."""

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
from pathlib import Path
from types import FrameType
from typing import Any
from urllib.parse import urlsplit

from groundslab.errors import InputError, Issue
from groundslab.workbench.events import Hub
from groundslab.workbench.persistence import files

ADDRESS = "127.0.0.1"


def serve(case: Path | None, port: int = 0, browser: bool = True) -> None:
    """Serve the workbench until it is interrupted; raises InputError if it cannot be, or for a case that is none.

    A port of 0 stands for any that is free. If another workbench has the case open, its address is told instead.
    """
    _require_packages()
    import uvicorn

    from groundslab.workbench.server.routes import Tickets, application
    from groundslab.workbench.server.session import OpenElsewhere, Session
    from groundslab.workbench.solver.thread import Solver

    state = _state_folder()
    with _bound(port) as door:
        port = door.getsockname()[1]
        token = secrets.token_urlsafe(32)
        url = f"http://{ADDRESS}:{port}/?token={token}"
        hub = Hub()
        session = Session(hub, Solver(hub.tell), state, url)
        try:
            if case is not None:
                session.open(str(case.absolute()))
        except OpenElsewhere as elsewhere:
            session.close()
            _say(f"{case} is open already, in process {elsewhere.pid}")
            _print(elsewhere.url)
            if browser:
                _show(elsewhere.url, _ticket_of(elsewhere.url))
            return
        except InputError:
            session.close()
            raise
        tickets = Tickets()
        config = uvicorn.Config(
            application(session, tickets, port, token),
            log_level="warning",
            access_log=False,
            server_header=False,
            lifespan="off",
            loop="asyncio",
            http="h11",
            ws="none",
            timeout_graceful_shutdown=2,
        )

        def started() -> None:
            _print(url)
            if browser:
                threading.Thread(target=_show, args=(url, tickets.issue()), daemon=True).start()

        try:
            _server(config, hub, started).run([door])
        except KeyboardInterrupt:
            pass  # the usual way to end it
        finally:
            kept = session.close()
            if kept:
                _say(f"unsaved work is kept in {kept}; the next start offers it")


def _require_packages() -> None:
    """Raise InputError if the packages of a server are missing."""
    try:
        import fastapi  # noqa: F401
        import uvicorn  # noqa: F401
    except ImportError as error:
        hint = 'pip install ".[app]"'
        issue = Issue("groundslab app", f"no package {error.name}", "the packages of the workbench", hint)
        raise InputError([issue]) from None


def _state_folder() -> Path:
    try:
        return files.state_folder()
    except (OSError, RuntimeError) as error:
        found = files.reason(error) if isinstance(error, OSError) else str(error)
        where = str(getattr(error, "filename", None) or "home")
        raise InputError([Issue(where, found, "a folder for unsaved work")]) from None


def _bound(port: int) -> socket.socket:
    """Return a socket on this machine's own address; raises InputError if the port is taken."""
    door = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    try:
        if sys.platform == "win32":
            # else another program could take the same port and be asked in our place
            door.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
        else:
            door.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        door.bind((ADDRESS, port))
    except (OSError, OverflowError) as error:
        door.close()
        found = f"{port} ({files.reason(error) if isinstance(error, OSError) else error})"
        raise InputError([Issue("--port", found, "a port that is free", "leave it out for any")]) from None
    return door


def _server(config: Any, hub: Hub, started: Callable[[], None]) -> Any:
    """Return a server that says when it has started, and lets pages that listen go when it ends."""
    import uvicorn

    class Server(uvicorn.Server):
        async def startup(self, sockets: list[socket.socket] | None = None) -> None:
            await super().startup(sockets)
            started()

        def handle_exit(self, sig: int, frame: FrameType | None) -> None:
            hub.close()
            super().handle_exit(sig, frame)

    signal.signal(signal.SIGTERM, signal.default_int_handler)  # it ends as by Ctrl-C
    return Server(config)


def _show(url: str, ticket: str) -> None:
    """Open a server's page in the browser, with a ticket in place of the token, as other users may see the address."""
    if ticket and _has_a_screen():
        parts = urlsplit(url)
        webbrowser.open(f"{parts.scheme}://{parts.netloc}/open?ticket={ticket}")


def _has_a_screen() -> bool:
    """Whether a browser would have a window; one for the terminal would be in the way."""
    graphical = any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER", "WSL_DISTRO_NAME"))
    return sys.platform in ("win32", "darwin") or graphical


def _ticket_of(url: str) -> str:
    """Return a ticket from the server that has this address, empty if it does not answer."""
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


def _print(url: str) -> None:
    print(url, flush=True)


def _say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)
