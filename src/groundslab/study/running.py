"""Running a study: variants without a row are solved, here or on Dask, and each row is written as it comes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from groundslab import __version__
from groundslab.errors import Fault, InputError
from groundslab.study import files, store
from groundslab.study.opened import Study, columns_in
from groundslab.study.sampling import Sample, sample_of
from groundslab.study.setup import columns_of
from groundslab.study.variant import Row, Worker

#: Packages whose versions a study's folder tells.
TOLD = ("numpy", "scipy", "pypardiso", "gstools", "dask", "distributed")

OnRow = Callable[[Row], None]


def versions() -> dict[str, str]:
    """Return the versions of groundslab, Python and what the rows hang on; packages that are not there are left out."""
    import platform

    found = {"groundslab": __version__, "python": platform.python_version()}
    for package in TOLD:
        try:
            found[package] = version(package)
        except PackageNotFoundError:
            continue
    return found


def run(read: files.Read, folder: Path, resume: bool, on_row: OnRow | None = None) -> Study:
    """Run a study in this process and return it, all rows there."""
    prepare(read, folder, resume)
    sample = sample_of(read.setup)
    with closing(store.Store(folder, columns_in(read.setup))) as rows:
        worker = Worker(read.setup)
        for number in missing(rows, sample):
            row = worker.row(sample[number], rows.mesh_keys())
            rows.add(row)
            if on_row is not None:
                on_row(row)
    return Study(folder)


def prepare(read: files.Read, folder: Path, resume: bool) -> None:
    """Make the folder of a study, or make sure that the one which is there is of this study; raises InputError."""
    if resume and folder.is_dir():
        about = store.about(folder)
        faults = _other(about, read)
        if faults:
            raise InputError(faults)
        return
    if store.is_store(folder):
        mend = "--resume goes on with it; --out names another folder"
        raise InputError([Fault(str(folder), "a study that is there already", "a name that is free", mend)])
    store.create(folder, read.study_text, read.case_text, _about(read), columns_in(read.setup))


def missing(rows: store.Store, sample: Sample) -> Iterator[int]:
    """Yield the numbers of the variants that have no row."""
    there = rows.numbers()
    return (number for number in range(1, len(sample) + 1) if number not in there)


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
        "versions": versions(),
        "units": dict(columns_of(read.setup)),
    }


def _other(about: Mapping[str, Any], read: files.Read) -> list[Fault]:
    """Return what tells the study in a folder from the one that is asked for."""
    faults = []
    mend = "take it back, or choose another folder with --out"
    for key, now, what in (
        ("study_sha256", read.study_sha256, "study file"),
        ("case_sha256", read.case_sha256, "case file"),
    ):
        if about[key] != now:
            faults.append(Fault(what, "a file that was changed", "the one that the rows in the folder are of", mend))
    before = about["versions"].get("groundslab")
    if before != __version__:
        expected = f"version {before}, which the rows in the folder are of"
        faults.append(Fault("groundslab", f"version {__version__}", expected, "choose another folder with --out"))
    return faults
