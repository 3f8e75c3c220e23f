"""Who may talk to the server: pages of its own, with its token; nobody from another site, nor through another name.

A web page of anybody's can send requests to 127.0.0.1. It cannot choose the headers Host, Origin and Sec-Fetch-Site,
which the browser writes; a name that was pointed at this machine after it was looked up (DNS rebinding) still stands
in Host.
"""

from __future__ import annotations

import hmac
import json
from collections.abc import Mapping
from typing import TYPE_CHECKING
from urllib.parse import parse_qs

if TYPE_CHECKING:
    from starlette.types import ASGIApp, Message, Receive, Scope, Send

#: Bytes of a request's body; a case file of the largest size, with every character escaped, fits.
LARGEST = 64_000_000
API = "/api/"
TOKEN = "x-groundslab-token"

#: Sent with every answer: nothing from elsewhere is loaded, nothing is kept, no other page may frame or read it.
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


def refusal(method: str, path: str, query: str, headers: list[tuple[str, str]], port: int, token: str) -> str | None:
    """Return why a request is refused, None if it is not; names of headers in small letters."""
    names = [f"127.0.0.1:{port}", f"localhost:{port}"]
    if [value.lower() for name, value in headers if name == "host"] not in [[name] for name in names]:
        return "the host is not this server's"
    origins = [value for name, value in headers if name == "origin"]
    if origins and origins not in [[f"http://{name}"] for name in names]:
        return "the page is not this server's"
    if any(name == "sec-fetch-site" and value not in ("same-origin", "none") for name, value in headers):
        return "the page is not this server's"
    if not path.startswith(API):
        return None if method in ("GET", "HEAD") else "nothing can be sent there"
    tokens = [value for name, value in headers if name == TOKEN]
    given = tokens or parse_qs(query, keep_blank_values=True, max_num_fields=20).get("token", [])
    if len(given) != 1 or not hmac.compare_digest(given[0].encode(), token.encode()):
        return "the token is missing or wrong"
    return None


class Guard:
    """Stands before an application, refuses what may not come in, and puts HEADERS on every answer."""

    def __init__(self, app: ASGIApp, port: int, token: str) -> None:
        self.app = app
        self.port = port
        self.token = token

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request, or hand it on."""
        if scope["type"] != "http":
            raise ValueError(f"no {scope['type']} here")
        headers = [(name.decode("latin-1").lower(), value.decode("latin-1")) for name, value in scope["headers"]]
        query = scope["query_string"].decode("latin-1")
        try:
            why = refusal(scope["method"], scope["path"], query, headers, self.port, self.token)
        except ValueError:
            why = "the request cannot be read"
        if why is not None:
            await _say(send, 403, why)
            return
        if scope["method"] == "POST":
            wrong = _wrong_body(dict(headers))
            if wrong is not None:
                await _say(send, *wrong)
                return
        await self.app(scope, receive, _with_headers(send))


def _wrong_body(headers: Mapping[str, str]) -> tuple[int, str] | None:
    """Return status and words for a body that is not taken, None for one that is."""
    if headers.get("content-type", "").split(";")[0].strip().lower() != "application/json":
        return 415, "only JSON is taken"
    length = headers.get("content-length", "")
    if not length.isdecimal():
        return 411, "the length must be told"
    if len(length) > 12 or int(length) > LARGEST:
        return 413, f"more than {LARGEST:,} bytes"
    return None


def _with_headers(send: Send) -> Send:
    """Return what sends an answer with HEADERS."""

    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            own = [(name, value) for name, value in message.get("headers", []) if name.decode() not in HEADERS]
            message = {**message, "headers": [*own, *((k.encode(), v.encode()) for k, v in HEADERS.items())]}
        await send(message)

    return sending


async def _say(send: Send, status: int, why: str) -> None:
    """Answer that a request is refused."""
    body = json.dumps({"error": {"message": why}}).encode()
    headers = {"content-type": "application/json", "content-length": str(len(body)), **HEADERS}
    start = {"type": "http.response.start", "status": status}
    await send({**start, "headers": [(name.encode(), value.encode()) for name, value in headers.items()]})
    await send({"type": "http.response.body", "body": body})
