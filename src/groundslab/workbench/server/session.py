"""One document on the workbench: edited by one at a time, kept on the disk, solved, shown in any number of pages."""

from __future__ import annotations

import os
import threading
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.storage import atomic
from groundslab.workbench.checking.bounded_process import Caller
from groundslab.workbench.checking.parsing import Reading
from groundslab.workbench.checking.thread import Reader
from groundslab.workbench.editing.document import Document, Edit
from groundslab.workbench.editing.undo import History
from groundslab.workbench.events import Event, Hub
from groundslab.workbench.persistence import autosave, files
from groundslab.workbench.persistence.autosave import Keeper, Kept
from groundslab.workbench.persistence.lock import Lock
from groundslab.workbench.solver.thread import Solver

State = dict[str, Any]
#: An answer waits so long for what the document means; pages ask again for what takes longer [s].
PATIENCE = 0.5
#: The same for its data alone, which form and drawing cannot do without [s].
PATIENCE_FOR_DATA = 2.0


class Conflict(Exception):
    """What is asked for goes against what others did meanwhile; ``kind`` names it, ``faults`` say what to do."""

    def __init__(self, kind: str, issues: Sequence[Issue] = ()) -> None:
        super().__init__(kind)
        self.kind = kind
        self.issues = tuple(issues)


class OpenElsewhere(Conflict):
    """The file is open in another workbench, whose address is ``url``."""

    def __init__(self, path: Path, about: Mapping[str, Any]) -> None:
        self.url = str(about.get("url", ""))
        self.pid = about.get("pid")
        found = f"a file that another workbench has open (process {self.pid})"
        super().__init__("open", [Issue(str(path), found, "a file that is free", self.url and f"go to {self.url}")])


class Session:
    """The document, its history, its place on the disk, and the solver that follows it."""

    def __init__(self, hub: Hub, solver: Solver, state: Path, url: str, caller: Caller | None = None) -> None:
        """Begin with a new document; state is the user's folder for unsaved work and locks; caller reads texts."""
        self.hub = hub
        self.solver = solver
        self._reader = Reader(self._take_data, self._take_reading, caller)
        self._data: dict[str, Any] | None = None
        self._reading: Reading | None = None  # None while the document is being read
        self._plan: dict[str, Any] | None = None  # the one before, while the document is being read
        self._state = state
        self._url = url
        self._lock = threading.RLock()
        self._version = 0
        self._autosolve = True
        self._file_lock: Lock | None = None
        self._file: Path | None = None
        self._base: str | None  # digest of the file's content that the document builds on
        self._saved: bytes | None  # content of the file, as it was read or saved last
        self._stamp: tuple[int, int, int] | None
        self._keeper: Keeper
        self._begin(None, Document(casefile.starter()), None)

    def state(self) -> State:
        """Return all that a page shows of the document; waits a moment for what it means."""
        self._reader.wait(self._version, PATIENCE, PATIENCE_FOR_DATA)
        with self._lock:
            document, history, offer = self._document, self._history, self._offer
            running, found = self.solver.running, self._reading
            return {
                "version": self._version,
                "text": document.text,
                "data": self._data,
                "checking": found is None,
                "faults": [] if found is None else found.listed,
                "plan": self._plan,
                "file": None if self._file is None else str(self._file),
                "dirty": self._dirty,
                "can_undo": history.can_undo,
                "can_redo": history.can_redo,
                "undo_text": history.undo_words,
                "redo_text": history.redo_words,
                "offer": None if offer is None else self._told(offer),
                "autosolve": self._autosolve,
                "run": None if running is None else dict(zip(("run", "version"), running, strict=True)),
                "unkept": self._unkept,
                "outside": self._changed_outside(),
            }

    def present(self) -> list[Event]:
        """Return the events that say how things stand."""
        with self._lock:
            return [("state", {"version": self._version}), *self.solver.status()]

    def edit(self, edits: Sequence[Edit], words: str, base: int | None, merges: bool = False) -> State:
        """Change the document, by all edits or none; raises Conflict on an old version, InputError for wrong edits."""
        while True:
            with self._lock:
                if base is not None and base != self._version:
                    raise Conflict("version")
                before, version = self._document, self._version
            after = self._reader.edited(before, edits)
            with self._lock:
                if version != self._version:
                    continue  # another edit was quicker
                if after.text != before.text:
                    self._history.record(before.text, words or "Edit", merges)
                    self._adopt(after)
            return self.state()

    def undo(self) -> State:
        """Take back the latest step, if there is one."""
        with self._lock:
            self._step(self._history.undo(self._document.text))
        return self.state()

    def redo(self) -> State:
        """Do again what was taken back last, if there is anything."""
        with self._lock:
            self._step(self._history.redo(self._document.text))
        return self.state()

    def save(self, file: str | None, over: bool) -> State:
        """Write the document to its file or another one.

        Raises Conflict if that changed meanwhile, is there already or is open elsewhere, InputError if it cannot be
        written. The first two are overwritten if the user says so.
        """
        with self._lock:
            target = self._target(file)
            own = self._file is not None and target == self._file
            there = _content(target)
            if there is not None and not over:
                if not own:
                    raise Conflict("exists", [Issue(str(target), "a file that exists", "a name that is free")])
                if files.digest(there) != self._base and there != self._document.content():
                    hint = "save it under another name, open it anew, or save over it"
                    found = "a file that another program has changed since it was read"
                    raise Conflict("changed", [Issue(str(target), found, "the file as it was read", hint)])
            lock = None if own else self._take(target)
            content = self._document.content()
            try:
                atomic.write(target, content)
            except OSError as error:
                if lock is not None:
                    lock.release()
                raise _unwritable(target, error) from None
            self._keeper.drop()
            if lock is not None:
                self._leave_file()
                self._file, self._file_lock = target, lock
                self._keeper = Keeper(target, self._state)
                self._offers = self._keeper.offers()
            self._history.settle()
            self._base, self._saved, self._unkept = files.digest(content), content, ""
            self._stamp = _stamp(target)
            self.hub.tell("saved", {"file": str(target)})
            self._tell()
        return self.state()

    def open(self, file: str) -> State:
        """Open a file in place of the document, whose unsaved work stays kept; raises InputError and Conflict."""
        with self._lock:
            target = _absolute(file, self._folder())
            own = self._file is not None and target == self._file
            keeper = Keeper(target, self._state)
            there, offers = _content(target), keeper.offers()
            if there is None and not offers:
                hint = f"groundslab new {target.name} makes one" if files.holds(target.parent.is_dir) else ""
                raise InputError([Issue(str(target), "no file of that name", "a case file", hint)])
            # unsaved work whose file is gone is taken up where it was
            document = Document.read(there, str(target)) if there is not None else offers[0].document
            lock = None if own else self._take(target)
            self._keeper.release()
            if lock is not None:
                self._leave_file()
                self._file_lock = lock
            self._begin(target, document, there)
        return self.state()

    def new(self) -> State:
        """Begin a new document; the unsaved work on the one before stays kept."""
        with self._lock:
            self._keeper.release()
            self._leave_file()
            self._begin(None, Document(casefile.starter()), None)
        return self.state()

    def restore(self, take: bool) -> State:
        """Take up unsaved work of an earlier run, as a step that can be undone, or put it aside."""
        with self._lock:
            if self._offer is not None:
                self._answer_offer(self._offer, take)
        return self.state()

    def solve(self) -> int:
        """Solve the document as it is, now; raises InputError with its faults if it cannot be."""
        self._reader.wait(self._version, PATIENCE)
        with self._lock:
            if self._reading is None:
                hint = "wait until it has been checked"
                raise InputError(
                    [Issue("the description", "a case that is still being checked", "a checked one", hint)]
                )
            if self._reading.issues:
                raise InputError(self._reading.issues)
            return self._want(self._reading, delay=0.0, again=True)

    def cancel(self) -> None:
        """Stop solving."""
        self.solver.cancel()

    def autosolve(self, on: bool) -> None:
        """Solve after every change, or only when asked to."""
        with self._lock:
            self._autosolve = on
            if on and self._reading is not None and self._reading.meaning:
                self._want(self._reading, delay=0.0)
            self._tell()

    def listing(self, folder: str | None) -> dict[str, Any]:
        """Return what can be opened in a folder, by default that of the document."""
        with self._lock:
            return files.listing(self._folder() if not folder else _absolute(folder, self._folder()))

    def report(self, run: int) -> tuple[str, bytes]:
        """Return the report on a run and a name for its file."""
        name = "case.toml" if self._file is None else self._file.name
        return f"{Path(name).stem}-report.html", self.solver.report(run, name)

    def close(self) -> str:
        """End; return where unsaved work is kept, empty if there is none."""
        self._reader.close()
        with self._lock:
            self.hub.close()
            self.solver.close()
            self._keeper.release()
            self._leave_file()
            return "" if self._keeper.path is None else str(self._keeper.path)

    def _begin(self, file: Path | None, document: Document, content: bytes | None) -> None:
        """Take a document up, without a past."""
        self.solver.forget()
        self._file = file
        self._saved = content
        self._base = None if content is None else files.digest(content)
        self._stamp = None if file is None else _stamp(file)
        self._start = document.content()  # of a document without a file
        self._history = History()
        self._keeper = Keeper(file, self._state)
        self._offers = self._keeper.offers()
        for kept in list(self._offers):
            if kept.document.content() == self._start and content is not None:
                autosave.remove(kept)  # it was saved in the end
                self._offers.remove(kept)
        self._unkept = ""
        self._plan = None
        self._adopt(document)

    def _answer_offer(self, offer: Kept, take: bool) -> None:
        """Take up unsaved work, or put it aside."""
        if take:
            before = self._document
            # what it builds on counts: a file that was changed since is not to be overwritten unawares
            self._base = offer.base
            if offer.document.text != before.text:
                self._history.record(before.text, "Restore unsaved work")
            self._adopt(offer.document)
            if not self._unkept:
                autosave.remove(offer)
        else:
            autosave.decline(offer)
        self._offers = [each for each in self._offers if each.path != offer.path]
        self._tell()

    def _adopt(self, document: Document) -> None:
        """Make a document the present one: kept, told of, read; solved when it has been read."""
        self._document = document
        self._version += 1
        self._data = self._reading = None
        self._reader.want(self._version, document)
        self._keep()
        self._tell()

    def _take_data(self, version: int, data: dict[str, Any] | None) -> None:
        """Take what a version's text says."""
        with self._lock:
            if version == self._version:
                self._data = data

    def _take_reading(self, version: int, found: Reading) -> None:
        """Take what a version means; have it solved."""
        with self._lock:
            if version == self._version:
                self._reading, self._plan = found, found.plan
                if self._autosolve and found.meaning:
                    self._want(found)

    def _keep(self) -> None:
        """Write the document down if it differs from its file."""
        if not self._dirty:
            self._keeper.drop()
            self._unkept = ""
            return
        try:
            self._keeper.keep(self._document, self._base)
            self._unkept = ""
        except OSError as error:
            self._unkept = f"unsaved work cannot be kept: {files.reason(error)}"

    def _step(self, text: str | None) -> None:
        """Go to another text of the history."""
        if text is not None:
            self._adopt(replace(self._document, text=text))

    def _want(self, found: Reading, delay: float | None = None, again: bool = False) -> int:
        """Have the document solved."""
        waits = {} if delay is None else {"delay": delay}
        return self.solver.want(self._document.text, self._version, found.meaning, again=again, **waits)

    def _tell(self) -> None:
        self.hub.tell("state", {"version": self._version})

    def _told(self, offer: Kept) -> dict[str, Any]:
        """Return unsaved work as data; it is on a changed file if that is not the one it builds on."""
        changed = offer.base != self._base
        return {"file": offer.file, "when": offer.when, "kept": str(offer.path), "changed": changed}

    @property
    def _dirty(self) -> bool:
        """Whether the document differs from its file, or from how it began."""
        there = self._start if self._file is None else self._saved
        return there is None or self._document.content() != there

    @property
    def _offer(self) -> Kept | None:
        return self._offers[0] if self._offers else None

    def _changed_outside(self) -> bool:
        """Whether the file is no longer what was read or saved."""
        if self._file is None or _stamp(self._file) == self._stamp:
            return False
        try:
            there = _content(self._file)
        except InputError:
            return True  # it cannot even be read any more
        changed = there is None or files.digest(there) != self._base
        if not changed:
            self._stamp = _stamp(self._file)
        return changed

    def _folder(self) -> Path:
        return Path.cwd() if self._file is None else self._file.parent

    def _target(self, file: str | None) -> Path:
        """Return where to save."""
        if file is None:
            if self._file is None:
                raise InputError([Issue("file", "no name", "a name for the file", "choose one")])
            return self._file
        target = _absolute(file, self._folder())
        if target == self._file:
            return target
        if not target.suffix and not os.path.lexists(target):
            target = target.with_suffix(".toml")
        if files.holds(target.is_dir):
            raise InputError([Issue(str(target), "a folder", "a name for a file")])
        if target.suffix.lower() != ".toml":
            raise InputError([Issue(str(target), f'"{target.suffix}"', 'a name that ends with ".toml"')])
        return target

    def _take(self, target: Path) -> Lock:
        """Return the lock on a file; raises OpenElsewhere if another workbench has it."""
        name = files.digest(os.fsencode(os.path.normcase(os.path.realpath(target))))[:32]
        about = {"pid": os.getpid(), "url": self._url, "file": str(target)}
        try:
            lock, holder = Lock.take(self._state / "open" / f"{name}.lock", about)
        except OSError as error:
            found = f"no place to note which case is open ({files.reason(error)})"
            raise InputError([Issue(str(self._state), found, "a folder that can be written")]) from None
        if lock is None:
            raise OpenElsewhere(target, holder)
        return lock

    def _leave_file(self) -> None:
        if self._file_lock is not None:
            self._file_lock.release()
            self._file_lock = None


def _absolute(file: str, folder: Path) -> Path:
    """Return the full path of what a user names; links are followed, so that one file has one name."""
    if "\0" in file:
        raise InputError([Issue("file", "a name with a zero character", "the name of a file")])
    try:
        path = Path(file).expanduser()
    except RuntimeError:
        path = Path(file)
    return Path(os.path.realpath(folder / path))


def _content(path: Path) -> bytes | None:
    """Return the bytes of a file, None if it is not there; raises InputError if it cannot be read."""
    try:
        return files.read(path, casefile.LARGEST + 1)
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        why = files.reason(error) if isinstance(error, OSError) else str(error)
        raise InputError([Issue(str(path), why, "a file that can be read")]) from None


def _stamp(path: Path) -> tuple[int, int, int] | None:
    """Return what changes when a file does: time, size, and which file it is."""
    try:
        about = path.stat()
    except OSError:
        return None
    return about.st_mtime_ns, about.st_size, about.st_ino


def _unwritable(path: Path, error: OSError) -> InputError:
    hint = "choose another place; nothing is lost"
    return InputError([Issue(str(path), files.reason(error), "a file that can be written", hint)])
