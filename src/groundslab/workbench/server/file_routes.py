"""The routes of a file that another program has changed, of the accuracy of runs, and of differences of results."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated, Any, Literal

from fastapi import FastAPI
from pydantic import BaseModel, ConfigDict, Field

from groundslab.workbench.exports.routes import add_difference_route
from groundslab.workbench.server.analyses import Analyses
from groundslab.workbench.server.session import Session, State


class Take(BaseModel):
    """Which text counts from now on: that of the file, that of the page, or both merged; the digest of the file."""

    model_config = ConfigDict(extra="forbid")

    which: Literal["theirs", "mine", "merged"]
    digest: Annotated[str, Field(max_length=100)]


class Accuracy(BaseModel):
    """The accuracy that runs ask for, that of the case if empty."""

    model_config = ConfigDict(extra="forbid")

    accuracy: Literal["", "draft", "normal", "strict"]


def add_accuracy_routes(app: FastAPI, analyses: Analyses) -> None:
    """Add the routes that choose an accuracy and tell what it costs."""

    @app.post("/api/accuracy")
    def set_accuracy(body: Accuracy) -> dict[str, Any]:
        analyses.set_accuracy(body.accuracy)
        return {}

    @app.get("/api/cost")
    def get_cost() -> dict[str, Any]:
        return analyses.list_costs()


def add_difference_routes(app: FastAPI, analyses: Analyses) -> None:
    """Add the routes that keep results as a reference, and subtract it, or a combination, from those of a run."""
    add_difference_route(app, analyses.write_difference)

    @app.post("/api/results/{run}/reference")
    def keep_reference(run: int) -> dict[str, Any]:
        analyses.keep_reference(run)
        return {}


def add_changed_file_routes(app: FastAPI, session: Session) -> None:
    """Add the routes that tell whether and how the file has changed, and settle which text counts."""

    @app.get("/api/file")
    def look_at_file() -> dict[str, bool]:
        return {"outside": session.file.has_changed()}

    @app.get("/api/file/changes")
    def compare_file() -> dict[str, Any]:
        digest, comparison = session.compare_file()
        return {"digest": digest, **asdict(comparison)}

    @app.post("/api/file")
    def take_file(body: Take) -> State:
        session.take_file(body.which, body.digest)
        return session.get_state()
