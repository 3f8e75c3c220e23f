"""A folder of results, written completely or not at all.

An only combination has its files in the folder itself; of several each has a folder in it, beside the files of all of
them. The names of all files are listed in summary.json. Only such files are ever removed, if groundslab can have
written files of these names and they hold what belongs there.
"""

from __future__ import annotations

import json
import os
import shutil
import tempfile
from collections.abc import Collection, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path

from groundslab import errors
from groundslab.errors import GroundslabError, InputError, Issue, NotCertified, NotConverged
from groundslab.results.results import CombinationResult, Results, results_of
from groundslab.storage import atomic, checksums, ownership
from groundslab.views.files import manifest, npz
from groundslab.views.files.folder_summary import (
    FILE,
    ListedCombination,
    RefusedCombination,
    find_edited,
    read_document,
    read_summary,
    require_unchanged,
    write_summary,
)

#: Files that are written on several threads: what takes long there, zlib, leaves the others their turn.
PACKED = (".vtu", ".npz")


def save_results(results: CombinationResult | Results, folder: str | Path, *, plot: bool = False) -> Path:
    """Write results into a folder, in place of earlier results there.

    Results that are not certified are written too, marked as such; combinations without any are listed with the reason.
    The folder holds VTU files for ParaView, tables as CSV, summary.json, the case file, and NumPy archives from which
    `load_results` reads the same results back. Files of earlier results that were edited are kept in a folder beside
    it, named in a warning (EditedFilesKept).

    Parameters
    ----------
    results : Results or CombinationResult
        The results.
    folder : str or pathlib.Path
        The folder. It may be missing, empty, or hold only what groundslab wrote.
    plot : bool, default: False
        Whether to add a picture, picture.png, to each combination.

    Returns
    -------
    pathlib.Path
        The folder's full path.

    Raises
    ------
    InputError
        If the folder cannot be written or holds other files.
    GroundslabError
        If the results hold a number that is not finite.

    Examples
    --------
    >>> import groundslab
    >>> path = groundslab.save_results(results, folder / "raft-results")
    >>> sorted(file.name for file in path.glob("*.vtu"))
    ['ground.vtu', 'plate.vtu']
    """
    target = check(folder)
    combined = results_of(results)
    try:
        fill = partial(_fill, combined, plot=plot)
        atomic.write_folder(target, fill, manifest.is_path, partial(_make_way, target))
    except OSError as error:
        raise _unwritable(target, error) from error
    return target


def add_files(folder: str | Path, writers: Mapping[str, manifest.Writer]) -> Path:
    """Write further files into a folder of results, whose others stay, or into a new one; completely or not at all.

    `writers` are those of the files by their paths, which `manifest.is_path` must know. Raises InputError.
    """
    target = check(folder)
    try:
        fill = partial(_fill_further, target, writers)
        atomic.write_folder(target, fill, manifest.is_path, partial(_make_way, target, writers))
    except OSError as error:
        raise _unwritable(target, error) from error
    return target


def provisional(folder: str | Path) -> Path:
    """Return where results of meshes that are not the last are kept until those of the last one are in the folder."""
    target = _resolve(folder)
    return target.with_name(f"{target.name}-provisional")


def save_provisional(results: Results, folder: str | Path) -> Path | None:
    """Write results of a mesh that is not the last next to the folder; return where, None if they cannot be written."""
    try:
        return save_results(results, provisional(folder))
    except (GroundslabError, OSError, MemoryError):
        return None


def remove_provisional(folder: str | Path) -> None:
    """Remove the results of meshes that were not the last, unless somebody has changed them."""
    target = provisional(folder)
    with suppress(OSError):
        if target.is_dir() and not _foreign(target) and not find_edited(target):
            shutil.rmtree(target)


def write_elsewhere(results: CombinationResult | Results, folder: str | Path) -> Path | None:
    """Write results into another folder than the one that they were meant for, and return it.

    It is a new one beside that folder, or one among the system's temporary files; None if neither can be written.
    """
    target = Path(os.path.realpath(folder))
    name = target.name[:40]
    beside = (target.with_name(f"{name}-{number}") for number in range(2, 1000))
    with suppress(GroundslabError, OSError, MemoryError):
        return save_results(results, next(path for path in beside if not os.path.lexists(path)))
    with suppress(GroundslabError, OSError, MemoryError):
        parent = Path(tempfile.mkdtemp(prefix="groundslab-"))
        try:
            return save_results(results, parent / name)
        finally:
            if not any(parent.iterdir()):
                parent.rmdir()
    return None


def check(folder: str | Path) -> Path:
    """Return the folder's full path if results may be written there; else raise InputError saying why not.

    Puts back earlier results first if a crash has left them aside. Touches nothing else, so that it can be
    asked before a long analysis.
    """
    target = _resolve(folder)
    recover(target)
    try:
        _require_free(target)
    except OSError as error:
        raise _unwritable(target, error) from error
    return target


def _require_free(target: Path) -> None:
    """Raise InputError with all that speaks against writing results into the folder."""
    issues = _in_the_way(target)
    if issues:
        raise InputError(issues)


def _make_way(target: Path, replaced: Collection[str] | None = None) -> None:
    """Keep what somebody has edited of the files that will be replaced, all by default; raises InputError, OSError."""
    _require_free(target)
    edited = find_edited(target) if target.is_dir() else []
    checksums.keep_files(target, [name for name in edited if replaced is None or name in replaced])


def recover(folder: str | Path) -> bool:
    """Put back the results that a crash has left aside; return whether there were any to put back.

    If the newer results are in place, the older ones are removed.
    """
    target = _resolve(folder)
    try:
        return atomic.recover_folder(target, _foreign)
    except OSError as error:
        raise _unwritable(target, error) from error


def load_results(folder: str | Path) -> Results:
    """Read the results that `save_results` or ``groundslab solve`` wrote into a folder.

    Parameters
    ----------
    folder : str or pathlib.Path
        The folder.

    Returns
    -------
    Results
        The results of all combinations. Of an iteration that did not converge only the history is there, not the last
        iterate.

    Raises
    ------
    InputError
        If the folder holds no results of groundslab, or damaged ones.
    CertificateWithdrawn
        If any file that groundslab wrote there was changed since, by its SHA-256 in summary.json.

    Examples
    --------
    >>> import groundslab
    >>> path = groundslab.save_results(results, folder / "raft-results")
    >>> groundslab.load_results(path).certificate.holds
    True
    """
    path = Path(folder)
    summary = read_summary(path)
    if summary is None or not summary.files:
        raise _not_ours(path, "no summary.json that names its files")
    try:
        results = _one(path) if summary.combinations is None else _several(path, summary.combinations)
    except (KeyError, ValueError) as error:
        raise _not_ours(path, f"a summary.json with something else ({type(error).__name__}: {error})") from error
    require_unchanged(path)
    return results


def _one(path: Path) -> Results:
    """Return the only combination of a folder; raises InputError."""
    archived = path / "results.npz"
    try:
        return results_of(npz.load(archived))
    except npz.OtherLayout:
        raise
    except InputError as error:
        raise _not_ours(archived, f"a combination that is wrong ({error.issues[0]})") from error


def _several(path: Path, listed: Sequence[ListedCombination]) -> Results:
    """Return the combinations that a summary lists, read from their folders; raises InputError or ValueError.

    The case is the one that was solved, which results hold.
    """
    from groundslab.case import casefile
    from groundslab.model.loads.load_cases import Combination

    results = _archived(path, listed)
    model = next(iter(results.values())).model if results else casefile.load(path / "case.toml")
    solved_model = Results(model, (), results, {}).solved_model
    rules = {entry.name: entry.rule for entry in solved_model.combinations}
    combinations, refused = [], dict[str, GroundslabError]()
    for entry in listed:
        about = {"limit_state": entry.limit_state, "factors": entry.factors, "rule": rules.get(entry.name, "")}
        combinations.append(Combination(name=entry.name, **about))
        if entry.refused is not None:
            refused[entry.name] = _refused(entry.refused, results.pop(entry.name, None))
    names = {entry.name for entry in listed}
    if not names or len(names) < len(listed) or results.keys() | refused.keys() != names:
        raise ValueError("combinations that have neither results nor a reason, or the same name")
    return Results(model, tuple(combinations), results, refused)


def _archived(path: Path, listed: Sequence[ListedCombination]) -> dict[str, CombinationResult]:
    """Return the results of those combinations that have a folder, by their names; all of the same case."""
    results: dict[str, CombinationResult] = {}
    for number, entry in enumerate(listed, 1):
        if entry.folder is None:
            continue
        if entry.folder != manifest.folder_name(number, entry.name, len(listed)):
            raise ValueError(f'folder "{entry.folder}" of combination "{entry.name}"')
        archived = path / entry.folder / "results.npz"
        archive = npz.load(archived, next(iter(results.values()), None))
        first = next(iter(results.values()), archive)
        model, solved_model = first.model, first.solved_model
        if (archive.model, archive.solved_model, archive.combination) != (model, solved_model, entry.name):
            raise _not_ours(archived, "results of another case or combination")
        results[entry.name] = replace(archive, model=model, solved_model=solved_model)
    return results


def _refused(why: RefusedCombination, results: CombinationResult | None) -> GroundslabError:
    """Return the error that a summary tells of."""
    if results is not None:
        return NotCertified(results)
    if why.error == "NotConverged":
        return NotConverged(why.what, list(why.history), {})
    error_names = ("IllConditioned", "NeutralEquilibrium", "NoEquilibrium", "SingularMatrix")
    kind: type[GroundslabError] = getattr(errors, why.error if why.error in error_names else "GroundslabError")
    return kind(why.reason)


def _not_ours(path: Path, found: str) -> InputError:
    """Return the error for what is no folder of results."""
    return InputError([Issue(str(path), found, "a folder of results that groundslab wrote")])


def _in_the_way(target: Path) -> list[Issue]:
    """Return the issues that prevent writing results into the folder."""
    atomic.check_name(target, manifest.DEEPEST)
    previous = atomic.previous_path(target)
    if os.path.lexists(previous):
        return [Issue(str(previous), "something that is in the way", "a name that is free", "move it away")]
    parent = next(parent for parent in target.parents if os.path.lexists(parent))
    if not parent.is_dir():
        return [Issue(str(target), f"{parent}, which is a file", "a place where a folder can be made")]
    if not os.access(parent, os.W_OK | os.X_OK):
        return [Issue(str(parent), "a folder without leave to write", "one that can be written to")]
    if not os.path.lexists(target):
        return []
    if not target.is_dir():
        return [Issue(str(target), "a file", "a folder, or a name that is free", "choose another")]
    # Replacing it would leave the shell standing in a folder that is gone.
    with suppress(OSError):
        here = Path.cwd()
        if target.samefile(here):
            return [Issue(str(target), "the current folder", "another one", "name a folder inside it")]
        if any(target.samefile(above) for above in here.parents):
            return [Issue(str(target), "a folder above the current one", "another one", "leave it first")]
    expected = "a folder that is missing, empty, or holds only results of groundslab"
    hint = "move it away or choose another folder; nothing was changed"
    return [
        Issue(str(target / name), "something that groundslab did not write", expected, hint)
        for name in _foreign(target)
    ]


def _fill(combined: Results, folder: Path, *, plot: bool) -> None:
    """Write every file; the summary, which names them all, comes last."""
    from groundslab.case import casefile
    from groundslab.views.summary.json_summary import json_text

    writers, folders = manifest.files_of(combined, plot)
    writers["case.toml"] = lambda path: manifest.write_text(path, casefile.to_toml(combined.model))
    if combined.results or combined.without_equilibrium:
        writers |= manifest.of_all(combined)
    # A summary that cannot be made stops everything before the large files are written.
    document = json.loads(json_text(combined, folders, [*writers, FILE], indent=None))
    for name in writers:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor() as threads:
        packed = [threads.submit(writers[name], folder / name) for name in writers if name.endswith(PACKED)]
        for name, writer in writers.items():
            if not name.endswith(PACKED):
                writer(folder / name)
        for future in packed:
            future.result()
    write_summary(folder, document, writers)


def _fill_further(target: Path, writers: Mapping[str, manifest.Writer], folder: Path) -> None:
    """Write what a folder of results holds, and further files; its summary names them all."""
    if target.is_dir():
        shutil.copytree(target, folder, dirs_exist_ok=True)
    for name, writer in writers.items():
        (folder / name).unlink(missing_ok=True)
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        writer(folder / name)
    document = read_document(folder)
    document["files"] = list(dict.fromkeys([*document["files"], *writers, FILE]))
    write_summary(folder, document, writers)


def _foreign(folder: Path) -> list[str]:
    """Return the paths in a folder, and in the folders within it, that are not ours according to its summary."""
    summary = read_summary(folder)
    return ownership.strangers(folder, set() if summary is None else set(filter(manifest.is_path, summary.files)))


def _resolve(folder: str | Path) -> Path:
    """Return the full path without links, so that the folder itself is replaced and not a link to it."""
    target = Path(os.path.realpath(folder))
    if any(map(os.path.islink, (target, *target.parents))):
        raise InputError([Issue(str(folder), "a link that leads back to itself", "a folder, or a name that is free")])
    if not target.name:
        raise InputError([Issue(str(folder), "the root of the file system", "a separate folder for the results")])
    return target


def _unwritable(target: Path, error: OSError) -> InputError:
    """Return the error for a folder that cannot be written; earlier results there are untouched."""
    reason = error.strerror or str(error)
    hint = "close programs that use the folder, free space, or choose another; earlier results are unchanged"
    return InputError([Issue(str(target), reason, "a folder that can be written", hint)])
