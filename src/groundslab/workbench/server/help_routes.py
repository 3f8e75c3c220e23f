"""The routes of help: examples to open, documentation to read."""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import FastAPI
from fastapi.responses import FileResponse, HTMLResponse, Response
from pydantic import BaseModel, ConfigDict, Field

from groundslab.workbench.help import documentation, examples
from groundslab.workbench.server.session import Session, State


class Example(BaseModel):
    """The example to open."""

    model_config = ConfigDict(extra="forbid")

    name: Annotated[str, Field(min_length=1, max_length=100)]


def add_example_routes(app: FastAPI, session: Session) -> None:
    """Add the routes that list the examples and open one of them as a new document."""

    @app.get("/api/examples")
    def list_examples() -> list[dict[str, Any]]:
        return examples.list_examples()

    @app.post("/api/examples")
    def open_example(body: Example) -> State:
        session.new(examples.read_example(body.name))
        return session.get_state()


def add_documentation_routes(app: FastAPI) -> None:
    """Add the pages of the documentation; a name is looked up in the list of pages and files, never in a folder."""

    @app.get("/docs/{name:path}")
    def get_page(name: str) -> Response:
        if (path := documentation.list_files().get(name)) is not None:
            return FileResponse(path)
        page = documentation.render_page(name.strip("/") or "index")
        return HTMLResponse(documentation.render_missing(name), 404) if page is None else HTMLResponse(page)
