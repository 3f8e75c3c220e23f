"""A folder of results as one file: a ZIP archive with the case, the results and the report."""

from __future__ import annotations

import io
import shutil
import tempfile
import zipfile
import zlib
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.views.files import folder_summary, manifest, results_folder

if TYPE_CHECKING:
    from groundslab.results.results import Results

REPORT = "report.html"
#: Largest archive that is read, as it is and with its files unpacked [bytes].
MAX_SIZE = 8 * 2**30
#: Bytes of an array for each packed one, at most, and bytes that may always be there; numbers of results, of which many
#: are zero, pack into a tenth.
RATIO, FREE = 100, 2**20
#: Largest number of files in an archive that is read.
MAX_FILES = 20_000
#: Every file gets this date, so that the same results give the same bytes.
_DATE = (1980, 1, 1, 0, 0, 0)
_CHUNK = 2**20


def pack_results(combined: Results, text: str, report: str) -> bytes:
    """Return an archive of results: their folder, with the text of the case as it was written, and the report."""
    with tempfile.TemporaryDirectory(prefix="groundslab-") as parent:
        folder = results_folder.save_results(combined, Path(parent) / "results")
        (folder / "case.toml").write_bytes(text.encode())
        folder_summary.write_summary(folder, folder_summary.read_document(folder), ["case.toml"])
        buffer = io.BytesIO()
        with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(_describe(REPORT), report.encode())
            for path in sorted(filter(Path.is_file, folder.rglob("*"))):
                with path.open("rb") as source, archive.open(_describe(path.relative_to(folder).as_posix()), "w") as to:
                    shutil.copyfileobj(source, to, _CHUNK)
    return buffer.getvalue()


def _describe(name: str) -> zipfile.ZipInfo:
    """Return the entry of a file."""
    entry = zipfile.ZipInfo(name, _DATE)
    entry.compress_type = zipfile.ZIP_DEFLATED
    return entry


def unpack_results(path: Path, folder: Path) -> None:
    """Write what is needed to read results from an archive into a folder.

    Only files of a folder of results are accepted, by their exact paths, so that nothing is written elsewhere. Raises
    InputError if there is any other file, or if they are too large.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            entries = archive.infolist()
            issues = _check_entries(path, entries)
            if issues:
                raise InputError(issues)
            left = MAX_SIZE
            for entry in filter(_is_needed, entries):
                left -= _write_entry(archive, entry, folder / entry.filename, min(left, _most(entry)))
    except (zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError, EOFError, ValueError) as error:
        raise _refusal(path, f"something else ({' '.join(str(error).split())[:200]})") from error


def _check_entries(path: Path, entries: list[zipfile.ZipInfo]) -> list[Issue]:
    """Return the issues with the entries of an archive."""
    expected = "an archive that the workbench has saved"
    issues = []
    names = [entry.filename for entry in entries if not entry.is_dir()]
    if len(entries) > MAX_FILES:
        issues.append(Issue(str(path), f"{len(entries)} files", f"at most {MAX_FILES}"))
    if len(set(names)) < len(names):
        issues.append(Issue(str(path), "two files of the same name", expected))
    foreign = [name for name in names if name != REPORT and not manifest.is_path(name)]
    if foreign:
        hint = "the files of the folder must lie at the top of the archive"
        issues.append(Issue(str(path), f"{foreign[0][:80]!r}, which is not a results file", expected, hint))
    for entry in filter(_is_needed, entries):
        if entry.file_size > (most := _most(entry)):
            large_entry = f"{entry.filename} of {entry.file_size:,} bytes"
            issues.append(Issue(str(path), large_entry, f"at most {most:,} bytes in it", "nothing was unpacked"))
    if sum(entry.file_size for entry in entries) > MAX_SIZE:
        issues.append(Issue(str(path), f"more than {MAX_SIZE:,} bytes unpacked", "fewer"))
    return issues


def _is_needed(entry: zipfile.ZipInfo) -> bool:
    """Return whether a file is needed to read the results."""
    return entry.filename.endswith((".npz", ".toml", ".json"))


def _most(entry: zipfile.ZipInfo) -> int:
    """Return how many bytes a file of an archive may have: its role says so, of numbers also how well they pack."""
    by_ending = {".toml": casefile.LARGEST, ".json": folder_summary.LARGEST}
    packed = RATIO * entry.compress_size + FREE
    return by_ending.get(Path(entry.filename).suffix, min(MAX_SIZE, packed))


def _write_entry(archive: zipfile.ZipFile, entry: zipfile.ZipInfo, path: Path, limit: int) -> int:
    """Write a file of an archive and return its size; raises ValueError if it is larger than it says or allowed."""
    path.parent.mkdir(parents=True, exist_ok=True)
    size, most = 0, min(entry.file_size, limit)
    with archive.open(entry) as source, path.open("wb") as target:
        while chunk := source.read(_CHUNK):
            size += len(chunk)
            if size > most:
                raise ValueError(f"{entry.filename} is larger than it says")
            target.write(chunk)
    return size


def _refusal(path: Path, found: str) -> InputError:
    """Return the error for what is no such archive."""
    return InputError([Issue(str(path), found, "a ZIP archive of results that the workbench has saved")])
