"""The folder of a study: its files and a table of rows, each on the disk as soon as it is solved.

    STUDY-study/
        study.toml, case.toml    copies of the study file and its case
        about.json               seed, versions, SHA-256 of both files and its own, units of the columns
        rows.sqlite              tables of rows, meshes, discretization errors, their SHA-256, runs, mishaps
        lock.sqlite              empty; locked while a study runs
        solving.txt              the variant that a study without workers is solving; stays if that ends the process

A folder is made under another name and renamed when it is complete. Rows are added in transactions that have reached
the disk when `add` returns (SQLite in WAL mode with synchronous = FULL); a row's number is the table's key, so that
none can be there twice.
"""

from __future__ import annotations

import hashlib
import json
import os
import sqlite3
import zlib
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.errors import CertificateWithdrawn, GroundslabError, InputError, Issue
from groundslab.fem.mesh import Mesh
from groundslab.storage import atomic, bounded
from groundslab.study.definition import files
from groundslab.study.execution.variant import key_of

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.study.definition.files import StudyInput
    from groundslab.study.definition.setup import Setup
    from groundslab.study.execution.variant import Row

STUDY, CASE, ABOUT, ROWS, LOCK = "study.toml", "case.toml", "about.json", "rows.sqlite", "lock.sqlite"
SOLVING = "solving.txt"
FORMAT = 2
#: Largest about.json that is read [bytes].
LARGEST_ABOUT = 1_000_000
#: Types of the values in about.json that are read from there.
_TYPES = {
    "seed": int,
    "variants": int,
    "made": str,
    "study_sha256": str,
    "case_sha256": str,
    "versions": dict,
    "sha256": str,
}
#: Columns before those of the study, with their types.
FIXED = {
    "number": "INTEGER PRIMARY KEY", "status": "TEXT NOT NULL", "reason": "TEXT NOT NULL", "message": "TEXT NOT NULL",
    "seconds": "REAL NOT NULL",
}  # fmt: skip
#: Tables whose rows have checksums, by their keys.
_SEALED = {"rows": "number", "meshes": "key", "discretization": "output"}


class StoreFull(GroundslabError):
    """A row could not be written, mostly as the disk is full; rows written before are as they were."""


def create(folder: Path, study: str, case: str, about: Mapping[str, Any], setup: Setup) -> None:
    """Make the folder of a study, completely or not at all; raises InputError if that is impossible."""

    def fill(staging: Path) -> None:
        (staging / STUDY).write_text(study, encoding="utf-8")
        (staging / CASE).write_text(case, encoding="utf-8")
        document = {"format": FORMAT, **about}
        document["sha256"] = _checksum(document)
        (staging / ABOUT).write_text(json.dumps(document, indent=2) + "\n", encoding="utf-8")
        with closing(_connect(staging / ROWS)) as connection, connection:
            for statement in table_columns(setup).statements():
                connection.execute(statement)

    try:
        _require_free(folder)
        atomic.write_folder(folder, fill, {STUDY, CASE, ABOUT, ROWS}.__contains__, lambda: _require_free(folder))
    except (OSError, sqlite3.Error) as error:
        found = getattr(error, "strerror", None) or str(error)
        raise InputError(
            [Issue(str(folder), found, "a folder that can be written", "free some space or choose another")]
        ) from None


def _require_free(folder: Path) -> None:
    """Raise InputError if a name is taken."""
    atomic.check_name(folder, f"{ROWS}-journal")
    if os.path.lexists(folder):
        raise InputError([Issue(str(folder), "a name that is taken", "a name that is free", "choose another folder")])


@dataclass(frozen=True, slots=True)
class Columns:
    """The columns of a study's table of rows, besides those of FIXED."""

    inputs: tuple[str, ...]
    results: tuple[str, ...]  # outputs that are one number
    fields: tuple[str, ...]  # outputs with a value at each node

    @property
    def scalars(self) -> tuple[str, ...]:
        """Return all columns but those of fields and mesh, in the order of the table."""
        return (*FIXED, *self.inputs, *self.results)

    def statements(self) -> list[str]:
        """Return the SQL that creates the tables."""
        fixed = [f"{name} {kind}" for name, kind in FIXED.items()]
        columns = [*map(_quote, self.inputs), *(f"{_quote(name)} REAL" for name in self.results)]
        columns += [f"{_quote(name)} BLOB" for name in self.fields]
        return [
            f"CREATE TABLE rows ({', '.join([*fixed, *columns, 'mesh TEXT NOT NULL'])})",
            "CREATE TABLE meshes (key TEXT PRIMARY KEY, nodes BLOB NOT NULL, elements BLOB NOT NULL) WITHOUT ROWID",
            "CREATE TABLE discretization (output TEXT PRIMARY KEY, value REAL NOT NULL, error REAL NOT NULL)",
            "CREATE TABLE checksums (part TEXT PRIMARY KEY, sha256 TEXT NOT NULL) WITHOUT ROWID",
            "CREATE TABLE mishaps (number INTEGER NOT NULL, at TEXT NOT NULL, message TEXT NOT NULL)",
            "CREATE TABLE runs (at TEXT NOT NULL, versions TEXT NOT NULL)",
        ]


def table_columns(setup: Setup) -> Columns:
    """Return the columns of a study's table of rows."""
    inputs = (*(field.name for field in setup.variables), *(field.name for field in setup.fields))
    return Columns(
        inputs,
        tuple(output.name for output in setup.scalar_outputs),
        tuple(output.name for output in setup.nodal_outputs),
    )


class Store:
    """The rows of a study in its folder, to be read and added to."""

    def __init__(self, folder: str | Path, setup: Setup, read_only: bool = False) -> None:
        self.folder = Path(folder)
        self.columns = table_columns(setup)
        self._read_only = read_only
        self._connection = (_connect_to_read if read_only else _connect)(self.folder / ROWS)

    def close(self) -> None:
        """Close the database; after writing no second file is left behind."""
        if not self._read_only:
            # fails while somebody reads, and on a full disk
            with suppress(sqlite3.Error):
                self._connection.execute("PRAGMA journal_mode = DELETE")
        self._connection.close()

    def __enter__(self) -> Store:
        """Return the store."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close the database."""
        self.close()

    def add(self, *rows: Row) -> int:
        """Write rows to the disk, all or none; return how many were not there yet. Raises StoreFull."""
        new = 0
        with self._writing(f"row {rows[0].number}" if rows else "a row"):
            for row in rows:
                for mesh in row.meshes:
                    self._insert("meshes", key_of(mesh), _bytes(mesh.nodes, "<f8"), _bytes(mesh.elements, "<i8"))
                pairs = zip(self.columns.results, row.base, strict=True) if row.base else ()
                for name, pair in pairs:
                    if pair is not None:
                        self._insert("discretization", name, *pair)
                values = [row.number, row.status, row.reason, row.message, row.seconds]
                values += [*map(plain, row.inputs), *row.results, *map(_pack, row.fields), row.mesh]
                new += self._insert("rows", *values)
        return new

    def _insert(self, table: str, key: object, *values: object) -> int:
        """Add a row to a table of _SEALED with the checksum of what is there then; return 0 if its key was there."""
        marks = ", ".join("?" * (1 + len(values)))
        new = self._connection.execute(f"INSERT OR IGNORE INTO {table} VALUES ({marks})", (key, *values)).rowcount
        if new:
            statement = f"SELECT * FROM {table} WHERE {_SEALED[table]} = ?"
            checksum = _checksum(self._connection.execute(statement, (key,)).fetchone())
            self._connection.execute("INSERT OR REPLACE INTO checksums VALUES (?, ?)", (f"{table} {key}", checksum))
        return new

    def changed_parts(self) -> list[str]:
        """Return which rows of tables are not as `add` wrote them; rows that are missing are only missing."""
        changed = []
        for table, key in _SEALED.items():
            joined = f"{table} LEFT JOIN checksums ON part = '{table} ' || {table}.{key}"
            for checksum, name, *values in self._connection.execute(
                f"SELECT checksums.sha256, {table}.* FROM {joined} ORDER BY {table}.{key}"
            ):
                if checksum != _checksum((name, *values)):
                    changed.append(f"{table} {name}")
        return changed

    def add_run(self, versions: Mapping[str, str]) -> None:
        """Record the begin of a run and its versions; raises StoreFull."""
        with self._writing("the run"):
            self._connection.execute("INSERT INTO runs VALUES (?, ?)", (_now(), json.dumps(dict(versions))))

    def add_failure(self, number: int, message: str) -> None:
        """Record why a worker made no row of a variant; raises StoreFull."""
        with self._writing("the failure of a worker"):
            self._connection.execute("INSERT INTO mishaps VALUES (?, ?, ?)", (number, _now(), message))

    @contextmanager
    def solving(self, number: int) -> Iterator[None]:
        """Note which variant this process solves, for the next run to know if that ends the process."""
        # a disk that is full has no room for the row either, and says so then
        with suppress(OSError):
            (self.folder / SOLVING).write_text(str(number), encoding="utf-8")
        try:
            yield
        finally:
            (self.folder / SOLVING).unlink(missing_ok=True)

    def add_killer(self) -> None:
        """Record as a failure that an earlier run ended while it solved a variant; raises StoreFull."""
        with suppress(OSError, ValueError):
            number = int((self.folder / SOLVING).read_text(encoding="utf-8"))
            self.add_failure(number, "the process ended while it was solved")
            (self.folder / SOLVING).unlink()

    def failure_counts(self) -> Counter[int]:
        """Return how often each variant has failed without a row."""
        return Counter(dict(self._connection.execute("SELECT number, COUNT(*) FROM mishaps GROUP BY number")))

    def worker_failures(self) -> dict[int, str]:
        """Return the last failure of a worker for each variant that has no row."""
        failures = self._connection.execute(
            "SELECT number, message FROM mishaps WHERE number NOT IN (SELECT number FROM rows) ORDER BY at"
        )
        return dict(failures)

    def runs(self) -> list[dict[str, Any]]:
        """Return when the study was run, and with which versions."""
        runs = self._connection.execute("SELECT at, versions FROM runs ORDER BY at")
        return [{"at": at, "versions": json.loads(versions)} for at, versions in runs]

    @contextmanager
    def _writing(self, what: str) -> Iterator[None]:
        """Write within one transaction; raises StoreFull if it fails, with nothing written."""
        try:
            with self._connection:
                yield
        except sqlite3.Error as error:
            raise StoreFull(f"{what} could not be written to {self.folder / ROWS}: {error}") from error

    def numbers(self) -> set[int]:
        """Return the numbers of the rows that are there."""
        return {number for (number,) in self._connection.execute("SELECT number FROM rows")}

    def count(self) -> int:
        """Return how many rows there are."""
        return int(self._connection.execute("SELECT COUNT(*) FROM rows").fetchone()[0])

    def counts(self) -> dict[str, int]:
        """Return how many rows are solved, and how many failed for each reason, the most frequent first."""
        statement = "SELECT CASE reason WHEN '' THEN status ELSE reason END AS what, COUNT(*) FROM rows GROUP BY what"
        return dict(self._connection.execute(f"{statement} ORDER BY 2 DESC, 1"))

    def rows(self, names: Sequence[str]) -> list[tuple[Any, ...]]:
        """Return some columns of all rows, in the order of their numbers."""
        chosen = ", ".join(map(_quote, names))
        return list(self._connection.execute(f"SELECT {chosen} FROM rows ORDER BY number"))

    def fields(self, name: str) -> Iterator[tuple[int, str, Array]]:
        """Yield number, key of the mesh and values (n,) of a field with values at all nodes, row by row."""
        statement = f"SELECT number, mesh, {_quote(name)} FROM rows WHERE {_quote(name)} IS NOT NULL ORDER BY number"
        for number, mesh, blob in self._connection.execute(statement):
            yield number, mesh, np.frombuffer(zlib.decompress(blob), dtype="<f4").astype(float)

    def discretization(self) -> dict[str, tuple[float, float]]:
        """Return by output its value in the case as it is and the discretization error of that, where it has one."""
        values = self._connection.execute("SELECT output, value, error FROM discretization")
        by_output = {name: (value, error) for name, value, error in values}
        return {name: by_output[name] for name in self.columns.results if name in by_output}

    def meshes(self) -> dict[str, Mesh]:
        """Return all meshes by their keys."""
        meshes = {}
        for key, nodes, elements in self._connection.execute("SELECT key, nodes, elements FROM meshes"):
            xy = np.frombuffer(zlib.decompress(nodes), dtype="<f8").reshape(-1, 2)
            meshes[key] = Mesh(xy, np.frombuffer(zlib.decompress(elements), dtype="<i8").reshape(-1, 9))
        return meshes

    def mesh_keys(self) -> tuple[str, ...]:
        """Return the keys of all meshes."""
        return tuple(key for (key,) in self._connection.execute("SELECT key FROM meshes"))


def about(folder: str | Path) -> dict[str, Any]:
    """Return the contents of about.json in a study's folder; raises InputError if it is none."""
    path = Path(folder)
    expected, hint = "a folder that groundslab study made", ""
    try:
        content = json.loads(bounded.read_whole(path / ABOUT, LARGEST_ABOUT))
        if content["program"] == "groundslab study" and (path / ROWS).is_file():
            if content["format"] == FORMAT:
                if all(isinstance(content[name], kind) for name, kind in _TYPES.items()):
                    return dict(content)
            else:
                expected = f"a folder of format {FORMAT}, which this version reads"
                hint = "run its study.toml again into another folder"
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        pass
    raise InputError([Issue(str(folder), "something else", expected, hint)])


def read_unchanged(folder: str | Path) -> tuple[dict[str, Any], StudyInput]:
    """Return the contents of about.json and the study in a folder, whose rows may be used.

    Raises InputError if it is no folder of a study, and CertificateWithdrawn if anything there was changed since.
    """
    path, document = Path(folder), about(folder)
    study = files.read(path / STUDY, path / CASE)
    changed = [
        name for key, name in (("study_sha256", STUDY), ("case_sha256", CASE)) if document[key] != study.checksums[key]
    ]
    if document["sha256"] != _checksum({key: value for key, value in document.items() if key != "sha256"}):
        changed.append(ABOUT)
    with open_rows(path, study.setup) as rows:
        changed += [f"{ROWS} ({part})" for part in rows.changed_parts()]
    if changed:
        raise CertificateWithdrawn(str(folder), changed)
    return document, study


@contextmanager
def open_rows(folder: Path, setup: Setup) -> Iterator[Store]:
    """Open the rows of a study for reading; raises InputError if they are damaged."""
    try:
        with Store(folder, setup, read_only=True) as rows:
            yield rows
    except (sqlite3.Error, zlib.error) as error:
        expected, hint = "the rows that groundslab study wrote", "restore the folder from a backup"
        raise InputError([Issue(str(folder / ROWS), str(error), expected, hint)]) from error


def is_store(folder: str | Path) -> bool:
    """Return whether a folder is that of a study."""
    try:
        about(folder)
    except InputError:
        return False
    return True


@contextmanager
def lock(folder: Path) -> Iterator[None]:
    """Keep other runs out of a study's folder; raises InputError if one is running. A dead process holds no lock."""
    with closing(sqlite3.connect(folder / LOCK, timeout=0, isolation_level=None)) as connection:
        try:
            connection.execute("BEGIN EXCLUSIVE")
        except sqlite3.Error as error:
            found = "a study that runs at this moment" if "locked" in str(error) else str(error)
            raise InputError(
                [Issue(str(folder), found, "one that no other process runs and that can be written")]
            ) from None
        yield


def _connect(path: Path) -> sqlite3.Connection:
    """Return a connection for writing."""
    connection = sqlite3.connect(path)
    # on a disk without shared memory the mode stays as it was, which is as safe
    with suppress(sqlite3.Error):
        connection.execute("PRAGMA journal_mode = WAL")
    connection.execute("PRAGMA synchronous = FULL")
    return connection


def _connect_to_read(path: Path) -> sqlite3.Connection:
    """Return a connection for reading, also while a run writes, and where nothing can be written."""
    place = path.resolve().as_uri()
    connection = sqlite3.connect(f"{place}?mode=ro", uri=True)
    try:
        connection.execute("SELECT COUNT(*) FROM runs")
    except sqlite3.OperationalError:
        connection.close()
        if path.with_name(f"{path.name}-wal").exists():
            hint = "rows of an interrupted run are still in its log; copy the folder to where it can be written"
            raise InputError([Issue(str(path), "a read-only folder", "one that can be written", hint)]) from None
        # a reader's shared memory cannot be made there, and nobody can be writing either
        connection = sqlite3.connect(f"{place}?immutable=1", uri=True)
    return connection


def _checksum(values: object) -> str:
    """Return the SHA-256 of what JSON or SQLite gave, as Python writes it."""
    return hashlib.sha256(repr(values).encode()).hexdigest()


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="milliseconds")


def _quote(name: str) -> str:
    return '"' + name.replace('"', '""') + '"'


def plain(value: Any) -> Any:
    """Return an input as SQLite stores it: numbers, words, lists as text."""
    return json.dumps(value) if isinstance(value, tuple | list) else value


def _pack(values: Array | None) -> bytes | None:
    """Return a field as bytes: numbers of seven digits, one more than a certificate guarantees."""
    return None if values is None else _bytes(values, "<f4")


def _bytes(values: Any, kind: str) -> bytes:
    return zlib.compress(np.ascontiguousarray(values, dtype=kind).tobytes())
