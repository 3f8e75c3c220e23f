"""The routes of files that are made of results."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Annotated
from urllib.parse import quote

from fastapi import FastAPI, Query
from fastapi.responses import Response

from groundslab.workbench.exports.files import Exported, ExportName, Wanted

#: Carries what is said of a file, as JSON whose letters are escaped as in addresses.
NOTES = "X-Groundslab-Notes"
Name = Annotated[str, Query(max_length=1000)]


def add_export_route(app: FastAPI, export: Callable[[int, Wanted], tuple[str, Exported]]) -> None:
    """Add the route of the files made of the results of a run; ``export`` returns a name for one, and the file."""

    @app.get("/api/results/{run}/exports/{file}")
    def get_export(
        run: int, file: ExportName, field: Name = "", combination: Name = "", envelope: Name = ""
    ) -> Response:
        wanted = Wanted(file, field=field, combination=combination, envelope=envelope)
        return respond_export(*export(run, wanted))


def respond_export(name: str, made: Exported) -> Response:
    """Return a file with what is said of it."""
    response = respond_download(name, made.content, "application/octet-stream")
    response.headers[NOTES] = quote(json.dumps(made.notes), safe="")
    return response


def respond_download(name: str, content: bytes, kind: str) -> Response:
    """Return a file that the browser saves under a name."""
    headers = {"Content-Disposition": f"attachment; filename*=UTF-8''{quote(name, safe='')}"}
    return Response(content, media_type=kind, headers=headers)
