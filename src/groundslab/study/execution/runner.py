"""Runs a study: solves the variants without a row, in this process or on Dask, and writes each row as it comes."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, field
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.errors import InputError, Issue
from groundslab.study.definition import files
from groundslab.study.definition.setup import column_units, warnings_of
from groundslab.study.execution import dask_cluster, store, versions
from groundslab.study.execution.variant import SOLVED, Row, Worker, WorkerFailure, describe_error
from groundslab.study.sampling import random_fields
from groundslab.study.sampling.designs import VariantList, list_variants

if TYPE_CHECKING:
    from groundslab.study.sampling.designs import Variant

#: Packages whose versions are recorded in a study's folder, also those that may differ between processes.
RECORDED = (*versions.MUST_AGREE, *versions.MESHERS, "mkl")


@dataclass(frozen=True, slots=True)
class Resources:
    """Where variants are solved: in a number of processes of this machine, on a cluster, or (0) in this process."""

    workers: int | None = None  # None: one for each core
    scheduler: str | None = None
    dashboard: bool = False  # Dask's, of the processes of this machine


@dataclass(slots=True)
class Progress:
    """Progress of a study."""

    folder: Path
    total: int
    there: int  # rows of earlier runs
    failed: int  # rows there now that say failed, those of earlier runs too
    solved: int
    where: str = ""
    dashboard: str = ""
    warnings: tuple[str, ...] = ()
    failures: list[WorkerFailure] = field(default_factory=list)

    @property
    def rows(self) -> int:
        """Return the number of rows that are there."""
        return self.solved + self.failed


#: Called with the progress at the start, when workers are ready, and after rows were written.
OnProgress = Callable[[Progress], None]


def run(study: files.StudyInput, folder: Path, resources: Resources, resume: bool, on_progress: OnProgress) -> Progress:
    """Run a study in its folder and return its progress: complete, unless workers failed.

    Raises InputError if it cannot begin, StoreFull or LostScheduler if it cannot continue; then, and if it is
    interrupted, all finished rows are on the disk.
    """
    if study.setup.fields:
        random_fields.import_gstools()
    if resources.scheduler is not None or resources.workers != 0:
        dask_cluster.require_packages()
    prepare(study, folder, resume)
    with store.lock(folder), store.Store(folder, study.setup) as rows:
        variants = list_variants(study.setup)
        _require_same_inputs(rows, variants)
        existing = rows.count()
        solved = rows.counts().get(SOLVED, 0)
        progress = Progress(
            folder, len(variants), existing, existing - solved, solved, warnings=tuple(warnings_of(study.setup))
        )
        rows.add_killer()
        done = rows.numbers()
        failures = rows.failure_counts()
        # what ended a run before must not keep the others from being solved
        numbers = sorted(range(1, len(variants) + 1), key=failures.__getitem__)
        todo = [variants[number] for number in numbers if number not in done]
        on_progress(progress)
        if not todo:
            return progress
        rows.add_run(versions.versions(RECORDED))
        with closing(_solve(study, resources, todo, rows, progress)) as outcomes:
            for batch in outcomes:
                new_rows = [outcome for outcome in batch if isinstance(outcome, Row)]
                failed = [outcome for outcome in batch if isinstance(outcome, WorkerFailure)]
                rows.add(*new_rows)
                for failure in failed:
                    rows.add_failure(failure.number, failure.message)
                progress.solved += sum(row.status == SOLVED for row in new_rows)
                progress.failed += sum(row.status != SOLVED for row in new_rows)
                progress.failures += failed
                on_progress(progress)
    return progress


def _solve(
    study: files.StudyInput, resources: Resources, todo: Sequence[Variant], rows: store.Store, progress: Progress
) -> Generator[list[Row | WorkerFailure]]:
    """Yield the rows of variants, wherever they are solved; first none, when it is known where."""
    if resources.scheduler is None and resources.workers == 0:
        progress.where = "in this process"
        yield []
        worker = Worker(study.setup)
        for variant in todo:
            with rows.solving(variant.number):
                try:
                    outcome = worker.outcome(variant, rows.mesh_keys())
                except MemoryError as error:
                    outcome = WorkerFailure(variant.number, describe_error(error))
            yield [outcome]
        return
    if resources.scheduler is None:
        cluster = dask_cluster.start_local(resources.workers, len(todo), resources.dashboard)
    else:
        cluster = dask_cluster.connect(resources.scheduler, study.setup)
    with cluster as connected:
        count = connected.threads
        progress.where, progress.dashboard = f"on {count} worker{'s' if count != 1 else ''}", connected.dashboard
        yield []
        # of a folder that is locked no other run can have the same name
        mark = sha256(f"{rows.folder.resolve()} {' '.join(study.checksums.values())}".encode()).hexdigest()[:12]
        with closing(dask_cluster.rows(connected, f"groundslab-{mark}", study.setup, todo, rows.mesh_keys)) as outcomes:
            yield from outcomes


def prepare(study: files.StudyInput, folder: Path, resume: bool) -> None:
    """Make the folder of a study, or check that an existing one is of this study; raises InputError."""
    if resume and folder.is_dir():
        issues = _differences(store.about(folder), study)
        if issues:
            raise InputError(issues)
        store.read_unchanged(folder)
        return
    if store.is_store(folder):
        hint = "--resume continues it; --out names another folder"
        raise InputError([Issue(str(folder), "a study that is there already", "a name that is free", hint)])
    store.create(folder, study.study_text, study.case_text, _about(study), study.setup)


def _require_same_inputs(rows: store.Store, variants: VariantList) -> None:
    """Raise InputError if rows that are there have other values than the study has now."""
    for number, *inputs in rows.rows(["number", *rows.columns.inputs]):
        variant = variants[number]
        if tuple(inputs) != tuple(store.plain(value) for value in (*variant.values, *variant.seeds)):
            found = "another version of numpy or scipy, which draws other numbers"
            expected = f"that of {store.ABOUT} there"
            raise InputError(
                [Issue(f"{rows.folder}, row {number}", found, expected, "choose another folder with --out")]
            )


def _about(study: files.StudyInput) -> dict[str, Any]:
    """Return the contents of about.json."""
    return {
        "program": "groundslab study",
        "title": study.setup.title,
        "made": datetime.now(UTC).isoformat(timespec="seconds"),
        "seed": study.setup.seed,
        "variants": study.setup.count,
        **study.checksums,
        "versions": versions.versions(RECORDED),
        "units": dict(column_units(study.setup)),
    }


def _differences(about: Mapping[str, Any], study: files.StudyInput) -> list[Issue]:
    """Return the differences between the study in a folder and this one."""
    hint = "restore it, or choose another folder with --out"
    expected = "the one that the rows in the folder are of"
    issues = [
        Issue(name.replace("_sha256", " file"), "a file that was changed", expected, hint)
        for name, now in study.checksums.items()
        if about[name] != now
    ]
    before = about["versions"].get("groundslab")
    if before != __version__:
        expected = f"version {before}, which the rows in the folder are of"
        issues.append(Issue("groundslab", f"version {__version__}", expected, "choose another folder with --out"))
    return issues
