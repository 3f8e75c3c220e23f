"""The part of the interface that other programs may rely on: its routes and their description by OpenAPI.

The description is written into docs/interface/openapi.json and not served. Requests need the token of the address that
the command prints, and come from this machine only (``security``).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, Literal, NotRequired

from fastapi import FastAPI
from fastapi import Path as PathParameter
from fastapi.openapi.utils import get_openapi
from fastapi.responses import Response
from fastapi.routing import APIRoute
from typing_extensions import TypedDict  # comes with pydantic, which asks for it before Python 3.12

from groundslab.views.interface import shapes
from groundslab.views.summary.json_summary import FORMAT

#: The mark of a public route.
PUBLIC = "public"
#: Where a response of a route names its shape; FastAPI would look for it under "model".
SHAPE = "shape"
#: Documents about a run, by their names.
DocumentName = Literal["summary", "design", "tables"]
Run = Annotated[int, PathParameter(description="number of the run, as solve returns it")]

_ABOUT = """\
What `groundslab app` and `groundslab view` answer to programs on the same machine. The commands print an address such
as `http://127.0.0.1:PORT/?token=TOKEN`. Every request has that token in the header `X-Groundslab-Token`, the host of
that address, and, if it is a POST, a body of JSON with its length. Requests of web pages elsewhere are refused.
`groundslab view` has state, schema, events, documents and report alone, of the run 1. What is not listed here belongs
to the pages and changes without notice."""


class Explanation(TypedDict):
    """What is wrong, in words, and each issue by itself."""

    message: NotRequired[str]
    issues: NotRequired[list[shapes.InputIssue]]


class Refused(TypedDict):
    """Why a request is refused."""

    error: Explanation


def describe(summary: str, answer: Any = None, kind: str = "application/json") -> dict[str, Any]:
    """Return the options of a public route: a summary, and the shape or the type of what it answers.

    Shapes are named only: what FastAPI makes of them, which takes long, is needed where routes are described.
    """
    content: dict[str, Any] = {"content": {kind: {}}} if answer is None else {SHAPE: answer}
    refused = {"description": "Refused; the message says why", SHAPE: Refused}
    responses = {200: {"description": "OK"} | content, 403: refused, 404: refused, 409: refused, 422: refused}
    return {"tags": [PUBLIC], "summary": summary, "responses": responses}


def add_document_route(app: FastAPI, get_document: Callable[[int, str], Response]) -> None:
    """Add the documents about a run, which are those that the commands print with --json."""
    about = describe(
        "Summary, design checks or tables of a run; 404 while there are none",
        shapes.Summary | shapes.DesignOfResults | shapes.Tables,
    )

    @app.get("/api/results/{run}/documents/{name}", **about)
    def get(run: Run, name: DocumentName) -> Response:
        return get_document(run, name)


def openapi(app: FastAPI) -> dict[str, Any]:
    """Return the description of an application's public routes."""
    routes = [_with_shapes(route) for route in app.routes if isinstance(route, APIRoute) and PUBLIC in route.tags]
    description = get_openapi(title="groundslab", version=str(FORMAT), description=_ABOUT, routes=routes)
    token = {"type": "apiKey", "in": "header", "name": "X-Groundslab-Token"}
    description.setdefault("components", {})["securitySchemes"] = {"token": token}
    return description | {"security": [{"token": []}]}


def _with_shapes(route: APIRoute) -> APIRoute:
    """Return a public route that knows the shapes of its responses."""
    responses = {
        status: {"model" if key == SHAPE else key: part for key, part in response.items()}
        for status, response in route.responses.items()
    }
    return APIRoute(
        route.path,
        route.endpoint,
        methods=sorted(route.methods or ()),
        tags=route.tags,
        summary=route.summary,
        responses=responses,
    )
