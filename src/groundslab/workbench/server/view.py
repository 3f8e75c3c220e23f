"""Results that were kept earlier, shown read-only: no route changes or writes anything."""

from __future__ import annotations

import tempfile
import threading
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from fastapi.responses import Response, StreamingResponse

from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.messages import Message
from groundslab.results.results import refusal_words
from groundslab.views.files import archive, results_folder
from groundslab.workbench.events import Event, Hub
from groundslab.workbench.exports.files import Exported, Wanted, export, write_difference
from groundslab.workbench.exports.routes import add_difference_route, add_export_route, respond_download
from groundslab.workbench.saying import Answer, present_translator, say_refusals
from groundslab.workbench.server.public import add_document_route
from groundslab.workbench.server.routes import (
    STATIC,
    add_error_handlers,
    add_schema_route,
    guard_app,
    make_app,
    respond_not_kept,
)
from groundslab.workbench.server.security import Guard, Tickets

if TYPE_CHECKING:
    from groundslab.analysis.ground_comparison.comparison import GroundComparison
    from groundslab.results.results import Results

#: Version of the only state, and number of the only run.
ONLY = 1


class ResultsView:
    """Results with their summary and scene, as the page of the workbench takes them."""

    def __init__(
        self, name: str, combined: Results, text: str | None, comparison: GroundComparison | None, remark: str = ""
    ) -> None:
        """Begin with results; ``name`` says where they are from, ``text`` is that of their case where it is known.

        ``remark`` is what their report says besides.
        """
        from groundslab.views.scene.binary import pack
        from groundslab.views.scene.fields import scene_of
        from groundslab.workbench.solver.summary import build_summary
        from groundslab.workbench.solver.tables import layout_makers

        self.hub = Hub()
        self.summary = build_summary(combined)
        self.scene = pack(scene_of(combined))
        self.tables = layout_makers(combined)
        self.refused = {name: refusal_words(why, combined.model.units) for name, why in combined.refused.items()}
        self._name, self._results, self._text, self._comparison = name, combined, text, comparison
        self._remark = remark
        self._report: bytes | None = None
        self._lock = threading.Lock()

    @classmethod
    def read(cls, path: Path) -> ResultsView:
        """Read a folder of results, or an archive of one; raises InputError."""
        if path.is_dir():
            return cls._read_folder(path, path)
        if not path.is_file():
            missing, hint = "no folder or file of that name", "groundslab solve CASE writes such a folder"
            raise InputError([Issue(str(path), missing, "a folder of results, or a ZIP archive of one", hint)])
        with tempfile.TemporaryDirectory(prefix="groundslab-") as folder:
            archive.unpack_results(path, Path(folder))
            return cls._read_folder(Path(folder), path)

    @classmethod
    def _read_folder(cls, folder: Path, shown: Path) -> ResultsView:
        """Read a folder of results; ``shown`` is the path that the user gave."""
        from groundslab.views import report
        from groundslab.views.ground_comparison.files import load_comparison

        combined = results_folder.load_results(folder)
        text, remark = report.text_of(folder, combined.model), report.changes_since(folder, combined.model)
        return cls(str(shown.absolute()), combined, text, load_comparison(folder), remark)

    def get_state(self) -> dict[str, Any]:
        """Return the state in the form of a document that nobody changes; ``view`` says where it is from."""
        return {
            "version": ONLY,
            "text": self._text or casefile.to_toml(self._results.model),
            "data": {},
            "issues": [],
            "plan": None,
            "file": self._name,
            "view": self._name,
            "dirty": False,
            "can_undo": False,
            "can_redo": False,
            "undo_text": "",
            "redo_text": "",
            "offer": None,
            "autosolve": False,
        }

    def get_current_events(self) -> list[Event]:
        """Return the events that describe the results."""
        from groundslab.views.summary.discretization import provisional_words

        design = self.summary["design"]
        headline = design["headline"] if design.get("status") in ("fails", "attention") else ""
        about = {"run": ONLY, "version": ONLY, "seconds": None, "design": headline}
        provisional = provisional_words(self._results)
        return [("solved", about | {"refused": self.refused, "provisional": provisional, "update": 0})]

    def write_document(self, name: str) -> str:
        """Return one of the documents for other programs."""
        from groundslab.views.interface.documents import DOCUMENTS, to_text

        return to_text(DOCUMENTS[name](self._results))

    def write_report(self) -> tuple[str, bytes]:
        """Return a name for the report on the results, and its content, which is made once."""
        from groundslab.views import report

        with self._lock:
            if self._report is None:
                page = report.render_report(
                    self._results, text=self._text, comparison=self._comparison, remark=self._remark
                )
                self._report = page.encode()
            return f"{Path(self._name).stem}-report.html", self._report

    def export(self, run: int, wanted: Wanted, reference: int | None = None) -> tuple[str, Exported]:
        """Return a name for a file that is made of the results, and the file; raises InputError."""
        self._require_only(run, reference)
        wanted = replace(wanted, case=f"{Path(self._name).stem}.toml", remark=self._remark)
        with self._lock:
            return wanted.name, export(self._results, wanted, self._text, self._comparison)

    def write_difference(self, run: int, wanted: Wanted, reference: int | None) -> bytes:
        """Return the packed scene of the results minus one of their combinations; raises InputError."""
        self._require_only(run, reference)
        with self._lock:
            return write_difference(self._results, wanted)

    @staticmethod
    def _require_only(run: int, reference: int | None) -> None:
        """Raise InputError of another run, and of a reference, which is never kept here."""
        if run != ONLY:
            raise InputError([Issue("the export", _run(run), _run(ONLY))])
        if reference is not None:
            raise InputError([Issue("the reference", f"run {reference}", "none, as one set of results is shown")])


def _run(number: int) -> Message:
    return Message("run {number}", number=number)


def create_view_app(view: ResultsView, tickets: Tickets, port: int, token: str, static: Path = STATIC) -> Guard:
    """Return the application that shows results."""
    app = make_app()
    add_error_handlers(app)
    add_schema_route(app)
    app.get("/api/state")(view.get_state)

    @app.get("/api/events")
    async def stream_events() -> StreamingResponse:
        return StreamingResponse(
            view.hub.listen(view.get_current_events, present_translator()), media_type="text/event-stream"
        )

    @app.get("/api/results/{run}/scene")
    def get_scene(run: int) -> Response:
        if run != ONLY:
            return respond_not_kept()
        return Response(say_refusals(view.scene, view.refused), media_type="application/octet-stream")

    @app.get("/api/results/{run}/summary")
    def get_summary(run: int) -> Response:
        return Answer(view.summary) if run == ONLY else respond_not_kept()

    @app.get("/api/results/{run}/tables")
    def list_tables(run: int) -> Response:
        return Answer(list(view.tables)) if run == ONLY else respond_not_kept()

    @app.get("/api/results/{run}/tables/{name}")
    def get_table(run: int, name: str) -> Response:
        from groundslab.workbench.solver.tables import table_to_json

        exists = run == ONLY and name in view.tables
        return Answer(table_to_json(name, view.tables[name]())) if exists else respond_not_kept()

    def get_document(run: int, name: str) -> Response:
        if run != ONLY:
            return respond_not_kept()
        return Response(view.write_document(name), media_type="application/json")

    add_document_route(app, get_document)

    @app.get("/api/results/{run}/report")
    def get_report(run: int) -> Response:
        return respond_download(*view.write_report(), "text/html; charset=utf-8") if run == ONLY else respond_not_kept()

    add_export_route(app, view.export)
    add_difference_route(app, view.write_difference)
    return guard_app(app, tickets, port, token, static)
