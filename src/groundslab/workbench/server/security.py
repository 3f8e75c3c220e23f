"""Access control: only the server's own pages, with its token and under its own host name, may send requests.

Any web page can send requests to 127.0.0.1, but the browser writes the headers Host, Origin and Sec-Fetch-Site. After
DNS rebinding the foreign host name is still in Host. (Starlette's TrustedHostMiddleware ignores the port.)
"""

from __future__ import annotations

import hmac
import secrets
from collections.abc import Mapping
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from groundslab.workbench.saying import take_language

#: Largest body of a request [bytes]; fits the largest case file with every character escaped.
MAX_BODY = 64_000_000
API = "/api/"
TOKEN = "x-groundslab-token"

#: Sent with every response: nothing is loaded from elsewhere or cached, and no other page may frame or read it.
HEADERS: Mapping[str, str] = {
    "content-security-policy": (
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; "
        "connect-src 'self'; worker-src 'self' blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    ),
    "cache-control": "no-store",
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
}


def check_request(scope: Scope, port: int, token: str) -> tuple[int, str] | None:
    """Return the status and message with which a request is refused, None if it is accepted."""
    method, path, headers = scope["method"], scope["path"], Headers(scope=scope)
    hosts = [f"127.0.0.1:{port}", f"localhost:{port}"]
    origins = headers.getlist("origin")
    if [value.lower() for value in headers.getlist("host")] not in [[host] for host in hosts]:
        return 403, "the host is not this server's"
    if origins and origins not in [[f"http://{host}"] for host in hosts]:
        return 403, "the page is not this server's"
    if not {"same-origin", "none"}.issuperset(headers.getlist("sec-fetch-site")):
        return 403, "the page is not this server's"
    if path.startswith(API):
        tokens = headers.getlist(TOKEN)
        if not tokens:
            try:
                query = parse_qs(scope["query_string"].decode("latin-1"), keep_blank_values=True, max_num_fields=20)
            except ValueError:
                return 403, "the request cannot be read"
            tokens = query.get("token", [])
        if len(tokens) != 1 or not hmac.compare_digest(tokens[0].encode(), token.encode()):
            return 403, "the token is missing or wrong"
    elif method not in ("GET", "HEAD"):
        return 403, "nothing can be sent there"
    return _check_body(headers) if method == "POST" else None


def _check_body(headers: Headers) -> tuple[int, str] | None:
    """Return the status and message with which a body is refused, None if it is accepted."""
    if headers.get("content-type", "").split(";")[0].strip().lower() != "application/json":
        return 415, "only JSON is accepted"
    length = headers.get("content-length", "")
    if not length.isdecimal():
        return 411, "the length is missing"
    if len(length) > 12 or int(length) > MAX_BODY:
        return 413, f"more than {MAX_BODY:,} bytes"
    return None


class Guard:
    """Middleware that refuses requests of others and puts HEADERS on every response."""

    def __init__(self, app: ASGIApp, port: int, token: str) -> None:
        self.app = app
        self.port = port
        self.token = token

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request or pass it on."""

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                MutableHeaders(scope=message).update(HEADERS)
            await send(message)

        if scope["type"] != "http":
            raise ValueError(f"no {scope['type']} here")
        take_language(scope)
        refused = check_request(scope, self.port, self.token)
        app = self.app
        if refused is not None:
            status, message = refused
            app = JSONResponse({"error": {"message": message}}, status)
        await app(scope, receive, send_with_headers)


class Tickets:
    """Secrets that are valid once, for addresses that other users of the machine may see."""

    def __init__(self) -> None:
        self._valid: set[str] = set()

    def issue(self) -> str:
        """Return a new ticket."""
        ticket = secrets.token_urlsafe(32)
        self._valid.add(ticket)
        return ticket

    def redeem(self, ticket: str) -> bool:
        """Invalidate a ticket and return whether it was valid."""
        try:
            self._valid.remove(ticket)
        except KeyError:
            return False
        return True
