"""The routes of files that are made of results."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Annotated
from urllib.parse import quote

from fastapi import FastAPI, Query
from fastapi.responses import Response

from groundslab.messages import Label
from groundslab.workbench.exports.files import Exported, ExportName, Wanted
from groundslab.workbench.saying import present_translator, say

#: Carries what is said of a file, as JSON whose letters are escaped as in addresses.
NOTES = "X-Groundslab-Notes"
Name = Annotated[str, Query(max_length=1000)]


#: Returns a name for a file made of the results of a run, and the file; of a difference to a kept run, if one is given.
Export = Callable[[int, Wanted, int | None], tuple[str, Exported]]


def add_export_route(app: FastAPI, export: Export) -> None:
    """Add the route of the files made of the results of a run."""

    @app.get("/api/results/{run}/exports/{file}")
    def get_export(
        run: int, file: ExportName, field: Name = "", combination: Name = "", envelope: Name = "", minus: Name = "",
        reference: int | None = None,
    ) -> Response:  # fmt: skip
        wanted = Wanted(file, field=field, combination=combination, envelope=envelope, minus=minus)
        return respond_export(*export(run, wanted, reference))


def add_difference_route(app: FastAPI, write: Callable[[int, Wanted, int | None], bytes]) -> None:
    """Add the route of the scene of the results of a run minus a combination of them, or minus a reference."""

    @app.get("/api/results/{run}/difference")
    def get_difference(run: int, minus: Name = "", reference: int | None = None) -> Response:
        wanted = Wanted("plan.pdf", minus=minus)
        return Response(write(run, wanted, reference), media_type="application/octet-stream")


def respond_export(name: str, exported: Exported) -> Response:
    """Return a file with what is said of it."""
    response = respond_download(name, exported.content, "application/octet-stream")
    response.headers[NOTES] = quote(
        json.dumps(say([Label(note) for note in exported.notes], present_translator())), safe=""
    )
    return response


def respond_download(name: str, content: bytes, kind: str) -> Response:
    """Return a file that the browser saves under a name."""
    headers = {"Content-Disposition": f"attachment; filename*=UTF-8''{quote(name, safe='')}"}
    return Response(content, media_type=kind, headers=headers)
