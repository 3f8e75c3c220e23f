"""Running a study: variants without a row are solved, here or on Dask, and each row is written as it comes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, closing, contextmanager
from dataclasses import dataclass, field
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.errors import InputError, Issue
from groundslab.study.definition import files
from groundslab.study.definition.setup import columns_of, warnings_of
from groundslab.study.execution import dask_cluster, store, versions
from groundslab.study.execution.dask_cluster import Mishap
from groundslab.study.execution.store import columns_in
from groundslab.study.execution.variant import Row, Worker
from groundslab.study.sampling import random_fields
from groundslab.study.sampling.designs import Sample, sample_of

if TYPE_CHECKING:
    from groundslab.study.definition.setup import Setup
    from groundslab.study.sampling.designs import Variant

#: Packages whose versions a study's folder tells: also those that need not be the same everywhere.
TOLD = (*versions.MUST_AGREE, *versions.MESHERS, "mkl")


@dataclass(frozen=True, slots=True)
class Where:
    """Where variants are solved: in so many processes of this machine, on a cluster, or (0) in this process."""

    workers: int | None = None  # None: one for each core
    scheduler: str | None = None
    dashboard: bool = False  # Dask's, of the processes of this machine


@dataclass(slots=True)
class Progress:
    """How far a study is, for who shows it."""

    folder: Path
    total: int
    there: int  # rows of earlier runs
    failed: int  # rows there now that say failed, those of earlier runs too
    solved: int
    where: str = ""
    dashboard: str = ""
    warnings: tuple[str, ...] = ()
    mishaps: list[Mishap] = field(default_factory=list)

    @property
    def rows(self) -> int:
        """Return the number of rows that are there."""
        return self.solved + self.failed


#: Is told the progress at the start, when workers are there, and after rows were written.
OnProgress = Callable[[Progress], None]


def run(read: files.Read, folder: Path, where: Where, resume: bool, on_progress: OnProgress) -> Progress:
    """Run a study in its folder and return how far it came: to the end, unless there were mishaps.

    Raises InputError if it cannot begin, StoreFull or LostScheduler if it cannot go on; then, and if it is interrupted,
    all rows that were there are on the disk.
    """
    if read.setup.fields:
        random_fields.generators()
    prepare(read, folder, resume)
    with store.locked(folder), store.Store(folder, columns_in(read.setup)) as rows:
        sample = sample_of(read.setup)
        _require_same_inputs(rows, sample)
        there = rows.count()
        failed = rows.count("failed")
        progress = Progress(folder, len(sample), there, failed, there - failed, warnings=tuple(warnings_of(read.setup)))
        todo = [sample[number] for number in _missing(rows, sample)]
        on_progress(progress)
        if not todo:
            return progress
        rows.begin(versions_told())
        with _solving(read, folder, where, todo, rows.mesh_keys, progress) as outcomes:
            on_progress(progress)
            for batch in outcomes:
                made = [each for each in batch if isinstance(each, Row)]
                mishaps = [each for each in batch if isinstance(each, Mishap)]
                rows.add(*made)
                for mishap in mishaps:
                    rows.tell(mishap.number, mishap.message)
                progress.solved += sum(row.status == "solved" for row in made)
                progress.failed += sum(row.status != "solved" for row in made)
                progress.mishaps += mishaps
                on_progress(progress)
    return progress


@contextmanager
def _solving(
    read: files.Read,
    folder: Path,
    where: Where,
    todo: Sequence[Variant],
    known_meshes: Callable[[], Sequence[str]],
    progress: Progress,
) -> Iterator[Iterator[list[Row | Mishap]]]:
    """Return what yields the rows of variants, wherever they are solved."""
    if where.scheduler is None and where.workers == 0:
        progress.where = "in this process"
        yield _here(read.setup, todo, known_meshes)
        return
    with ExitStack() as stack:
        if where.scheduler is None:
            found = stack.enter_context(dask_cluster.local(where.workers, len(todo), where.dashboard))
        else:
            found = stack.enter_context(dask_cluster.there(where.scheduler, read.setup))
        count = found.threads
        progress.where, progress.dashboard = f"on {count} worker{'s' if count != 1 else ''}", found.dashboard
        # of a folder that is locked no other run can have the same name
        mark = sha256(f"{folder.resolve()} {read.study_sha256} {read.case_sha256}".encode()).hexdigest()[:12]
        outcomes = dask_cluster.rows(found, f"groundslab-{mark}", read.setup, todo, known_meshes)
        with closing(outcomes):
            yield outcomes


def _here(
    setup: Setup, todo: Iterable[Variant], known_meshes: Callable[[], Sequence[str]]
) -> Iterator[list[Row | Mishap]]:
    """Yield the rows of variants solved in this process, one after the other."""
    worker = Worker(setup)
    for variant in todo:
        outcome: Row | Mishap
        try:
            outcome = worker.row(variant, known_meshes())
        except Exception as error:
            outcome = Mishap(variant.number, f"{type(error).__name__}: {error}")
        yield [outcome]


def prepare(read: files.Read, folder: Path, resume: bool) -> None:
    """Make the folder of a study, or make sure that the one which is there is of this study; raises InputError."""
    if resume and folder.is_dir():
        issues = _other(store.about(folder), read)
        if issues:
            raise InputError(issues)
        return
    if store.is_store(folder):
        hint = "--resume goes on with it; --out names another folder"
        raise InputError([Issue(str(folder), "a study that is there already", "a name that is free", hint)])
    store.create(folder, read.study_text, read.case_text, _about(read), columns_in(read.setup))


def versions_told() -> dict[str, str]:
    """Return the versions of all that rows hang on."""
    return versions.versions(TOLD)


def _missing(rows: store.Store, sample: Sample) -> Iterator[int]:
    """Yield the numbers of the variants that have no row."""
    there = rows.numbers()
    return (number for number in range(1, len(sample) + 1) if number not in there)


def _require_same_inputs(rows: store.Store, sample: Sample) -> None:
    """Raise InputError if rows that are there have other values than the study has now."""
    for number, *inputs in rows.rows(["number", *rows.columns.inputs]):
        variant = sample[number]
        if tuple(inputs) != tuple(store.plain(value) for value in (*variant.values, *variant.seeds)):
            found = "another version of numpy or scipy, which draws other numbers"
            expected = f"that of {store.ABOUT} there"
            raise InputError(
                [Issue(f"{rows.folder}, row {number}", found, expected, "choose another folder with --out")]
            )


def _about(read: files.Read) -> dict[str, Any]:
    """Return what a study's folder says of itself."""
    return {
        "program": "groundslab study",
        "title": read.setup.title,
        "made": datetime.now(UTC).isoformat(timespec="seconds"),
        "seed": read.setup.seed,
        "variants": read.setup.count,
        "study_sha256": read.study_sha256,
        "case_sha256": read.case_sha256,
        "versions": versions_told(),
        "units": dict(columns_of(read.setup)),
    }


def _other(about: Mapping[str, Any], read: files.Read) -> list[Issue]:
    """Return what tells the study in a folder from the one that is asked for."""
    issues = []
    hint = "take it back, or choose another folder with --out"
    for key, now, what in (
        ("study_sha256", read.study_sha256, "study file"),
        ("case_sha256", read.case_sha256, "case file"),
    ):
        if about[key] != now:
            issues.append(Issue(what, "a file that was changed", "the one that the rows in the folder are of", hint))
    before = about["versions"].get("groundslab")
    if before != __version__:
        expected = f"version {before}, which the rows in the folder are of"
        issues.append(Issue("groundslab", f"version {__version__}", expected, "choose another folder with --out"))
    return issues
