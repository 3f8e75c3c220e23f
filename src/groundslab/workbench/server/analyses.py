"""What is solved of the document, and the files about it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from threading import RLock
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.messages import Message, Name
from groundslab.model.settings import ACCURACIES
from groundslab.views.report.changes import CHANGED
from groundslab.workbench.checking.parsing import CheckResult
from groundslab.workbench.checking.revision import Revision
from groundslab.workbench.checking.work import WorkCounter
from groundslab.workbench.events import Hub
from groundslab.workbench.exports.case_writer import CaseWriter
from groundslab.workbench.exports.files import SAF, Exported, Wanted
from groundslab.workbench.exports.reference import KeptReferences
from groundslab.workbench.solver.comparer import Comparer
from groundslab.workbench.solver.cost import find_work, list_costs
from groundslab.workbench.solver.process import OUTDATED
from groundslab.workbench.solver.thread import DELAY, Solver


class Analyses:
    """Solves revisions of the document, each when it has been checked or only on request."""

    _revision: Revision

    def __init__(self, lock: RLock, hub: Hub, solver: Solver) -> None:
        self.solver = solver
        self.comparer = Comparer(hub.publish)
        self._counter = WorkCounter()
        self._lock, self._hub = lock, hub
        self._autosolve = True
        self._case_writer = CaseWriter()
        self._references = KeptReferences()

    def to_json(self) -> dict[str, Any]:
        """Return the run in progress as data for the page."""
        job = self.solver.schedule.current
        about = {"autosolve": self._autosolve, "accuracy": self.solver.accuracy}
        return about | {"run": None if job is None else job.to_json()}

    def follow(self, revision: Revision) -> None:
        """Take the present revision, and solve it if it is to be and has been checked."""
        with self._lock:
            self._revision = revision
            if self._autosolve:
                self._submit_valid(DELAY)

    def set_autosolve(self, on: bool) -> None:
        """Solve after every change, or only on request."""
        with self._lock:
            self._autosolve = on
            if on:
                self._submit_valid(0.0)
            self._hub.publish(*self._revision.event)

    def set_accuracy(self, accuracy: str) -> None:
        """Ask for an accuracy in place of that of the case, "" for that, in all runs from now on."""
        with self._lock:
            self.solver.accuracy = accuracy
            if self._autosolve:
                self._submit_valid(0.0)
            self._hub.publish("accuracy", {"accuracy": accuracy})

    def list_costs(self) -> dict[str, Any]:
        """Return what solving the present revision takes by the accuracy, nothing if that is not known."""
        with self._lock:
            revision, schedule = self._revision, self.solver.schedule
            fingerprint = "" if revision.result is None else revision.result.fingerprint
            latest, accuracies = schedule.results.latest, ("", *ACCURACIES)
            solved = [accuracy for accuracy in accuracies if latest and latest.fingerprint == (fingerprint, accuracy)]
            last = (solved[0], latest.answer) if solved and latest and not latest.is_provisional else None
        if last is not None and last[0] == "" and last[1].unknowns:
            return list_costs(find_work(last[1]), schedule.rate, last)
        work = self._counter.count(fingerprint, revision.text) if fingerprint else None
        return {} if work is None else list_costs(work, schedule.rate, last)

    def solve(self) -> int:
        """Solve the present revision at once and return the run; raises InputError with its issues if it has any."""
        with self._lock:
            return self._submit(self._require_checked(), 0.0, force=True)

    def reset(self) -> None:
        """Stop, and drop all results, references and the accuracy asked for, which belong to another document."""
        self.comparer.cancel()
        self.solver.accuracy = ""
        self._references.clear()
        self.solver.reset()

    def close(self) -> None:
        """Stop for good."""
        self.comparer.cancel()
        self._counter.close()
        self.solver.close()
        self._references.clear()

    def write_report(self, run: int, case: Path) -> tuple[str, bytes]:
        """Return a name for the report on a run of a case, and its content."""
        kind = OUTDATED if self._is_outdated(run) else "report"
        return f"{case.stem}-report.html", self.solver.make_view((kind, run, case.name))

    def write_archive(self, run: int, case: Path) -> tuple[str, bytes]:
        """Return a name for the archive of case, results and report of a run, and its content."""
        return f"{case.stem}-results.zip", self.solver.make_view(("archive", run, case.name))

    def keep_reference(self, run: int) -> None:
        """Keep the results of a run, from which later ones may be subtracted; raises InputError."""
        self._references.keep(run, lambda file: self.solver.make_view(("reference", run, file)))

    def write_difference(self, run: int, wanted: Wanted, reference: int | None) -> bytes:
        """Return the packed scene of the results of a run minus what is wanted; raises InputError."""
        wanted = replace(wanted, reference=self._references.find(reference))
        return self.solver.make_view(("difference", run, wanted))

    def export(self, run: int, wanted: Wanted, reference: int | None = None) -> tuple[str, Exported]:
        """Return a name for a file that is made of the results of a run, and the file; raises InputError.

        A plan is of the difference to the reference of a run, if there is one.
        """
        wanted = replace(wanted, reference=self._references.find(reference))
        if wanted.file == "report.pdf" and self._is_outdated(run):
            wanted = replace(wanted, remark=Message(CHANGED, file=Name(wanted.case)))
        return wanted.name, Exported.from_bytes(self.solver.make_view(("export", run, wanted)))

    def write_saf(self, case: Path) -> tuple[str, Exported]:
        """Return a name for the present case in the Structural Analysis Format, and the file; raises InputError.

        It has the results if the latest ones are those of the case as it is now.
        """
        wanted = Wanted(SAF, case.name)
        with self._lock:
            self._require_checked()
            latest, text = self.solver.schedule.results.latest, self._revision.text
        if latest is not None and not self._is_outdated(latest.run):
            return self.export(latest.run, wanted)
        return wanted.name, self._case_writer.write_saf(text)

    def propose_bars(self, run: int, case: Path) -> bytes:
        """Return the text of a case with bars that the results of a run ask for."""
        return self.solver.make_view(("bars", run, str(case.parent)))

    def _is_outdated(self, run: int) -> bool:
        """Return whether the document describes another model by now than that of a run."""
        solved, present = self.solver.schedule.results.get(run), self._revision
        if solved is None or solved.text == present.text:
            return False
        fingerprint = None if present.result is None else present.result.fingerprint
        return solved.fingerprint not in [(fingerprint, accuracy) for accuracy in ("", *ACCURACIES)]

    def _require_checked(self) -> CheckResult:
        """Return what was found in the present revision; raises InputError with its issues if it has any."""
        result = self._revision.result
        if result is None:
            unchecked, hint = "a case that is still being checked", "wait until it has been checked"
            raise InputError([Issue("the description", unchecked, "a checked one", hint)])
        if result.issues:
            raise InputError(result.issues)
        return result

    def _submit_valid(self, delay: float) -> None:
        """Have the present revision solved if it has been checked and describes a model."""
        result = self._revision.result
        if result is not None and result.fingerprint:
            self._submit(result, delay)

    def _submit(self, result: CheckResult, delay: float, force: bool = False) -> int:
        revision, fingerprint = self._revision, (result.fingerprint, self.solver.accuracy)
        return self.solver.submit(revision.text, revision.version, fingerprint, delay, force)
