"""What is made of a study, as files: one page, and each table as CSV, in a folder beside the rows."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.errors import InputError, Issue
from groundslab.storage import atomic, bounded, checksums, ownership
from groundslab.study.evaluation import tables as evaluation
from groundslab.study.evaluation.samples import choose_unit, read_samples
from groundslab.study.evaluation.statistics import LEVEL
from groundslab.study.report import page
from groundslab.units import UNITS

if TYPE_CHECKING:
    from groundslab.study.evaluation.form import Reliability
    from groundslab.study.evaluation.study import Study
    from groundslab.views.tables.table import Table

#: The folder within the study's, and the page in it.
FOLDER, PAGE = "evaluation", "report.html"
#: By what files that somebody has edited are known, and the most bytes that are read of it.
CHECKSUMS, LARGEST = "checksums.json", 1_000_000
#: All names of files that an evaluation can have.
NAMES = frozenset({PAGE, CHECKSUMS} | {f"{name}.csv" for name in (*evaluation.NAMES, "reliability", "design_points")})


def evaluate(
    study: Study | str | Path, reliability: Sequence[Reliability] = (), level: float = LEVEL
) -> tuple[Path, ...]:
    """Write the report and the tables of a study into its folder `evaluation`.

    Parameters
    ----------
    study : Study or str or Path
        A study with at least one row, or its folder.
    reliability : sequence of Reliability, optional
        First-order reliability of limit states, which the report and two tables then show.
    level : float, default 0.95
        Confidence level of the intervals, between 0 and 1.

    Returns
    -------
    tuple of Path
        The paths of report.html and of the tables as CSV files.

    Raises
    ------
    InputError
        If the study has no row, or the folder cannot be written or holds files that groundslab did not write.

    Notes
    -----
    An earlier evaluation is replaced completely or, if writing fails, left as it was. Files of it that were edited are
    kept in `evaluation-edited` beside it, with a warning (EditedFilesKept).
    """
    from groundslab.study.evaluation import form
    from groundslab.study.evaluation.study import as_study

    study = as_study(study)
    folder = check(study)
    sample = read_samples(study)
    if len(sample.number) == 0:
        raise InputError([Issue(str(study.folder), "a study without a row", "a study with rows to evaluate")])
    tables = [*evaluation.tables_of(sample, level), *(form.tables(reliability) if reliability else ())]
    texts = {f"{table.name}.csv": table.csv() for table in tables}
    texts[PAGE] = page.html(sample, origin(study), list(maps(study)), reliability, level)

    def fill(staging: Path) -> None:
        for name, text in texts.items():
            (staging / name).write_text(text, encoding="utf-8", newline="\n")
        about = {"program": "groundslab", "checksums": checksums.checksums_of(staging, texts)}
        (staging / CHECKSUMS).write_text(json.dumps(about, indent=2) + "\n", encoding="utf-8", newline="\n")

    try:
        atomic.write_folder(folder, fill, NAMES.__contains__, lambda: _make_way(folder))
    except OSError as error:
        raise _unwritable(folder, error) from error
    return tuple(folder / name for name in (PAGE, *(name for name in texts if name != PAGE)))


def check(study: Study) -> Path:
    """Return the folder of a study's evaluation if it may be written; else raise InputError saying why not.

    Puts back an earlier evaluation first if a crash has left it aside.
    """
    folder = study.folder / FOLDER
    try:
        atomic.recover_folder(folder, _foreign)
        _require_free(folder)
    except OSError as error:
        raise _unwritable(folder, error) from error
    return folder


def _require_free(folder: Path) -> None:
    """Raise InputError if there is anything in an evaluation's place that groundslab did not write."""
    if not os.path.lexists(folder):
        return
    expected, hint = "an evaluation of groundslab, or nothing", "move it away; nothing was changed"
    if folder.is_symlink() or not folder.is_dir():
        raise InputError([Issue(str(folder), "something that is not a folder", expected, hint)])
    strangers = _foreign(folder)
    if strangers:
        given = "something that groundslab did not write"
        raise InputError([Issue(str(folder / name), given, expected, hint) for name in strangers])


def _make_way(folder: Path) -> None:
    """Keep what somebody has edited of an earlier evaluation; raises InputError if anything else is in the way."""
    _require_free(folder)
    path = folder / CHECKSUMS
    if not path.is_file():
        return
    try:
        sums = dict(json.loads(bounded.read_whole(path, LARGEST))["checksums"])
    except (ValueError, KeyError, TypeError, RecursionError):
        sums = {}
    checksums.keep_files(folder, checksums.find_edited(folder, {name: sums[name] for name in sums if name in NAMES}))


def _foreign(folder: Path) -> list[str]:
    """Return the paths in a folder that no evaluation has."""
    return ownership.strangers(folder, NAMES)


def _unwritable(folder: Path, error: OSError) -> InputError:
    """Return the error for a folder that cannot be written; an earlier evaluation there is untouched."""
    hint = "free some space; an earlier evaluation is unchanged"
    return InputError([Issue(str(folder), error.strerror or str(error), "a folder that can be written", hint)])


def tables_of(study: Study, level: float = LEVEL) -> tuple[Table, ...]:
    """Return the tables that are made of a study's rows; level is the confidence of the intervals."""
    return evaluation.tables_of(read_samples(study), level)


def maps(study: Study) -> Iterator[page.Map]:
    """Yield maps of each field kept everywhere: mean, standard deviation, of the settlement where the plate lifts.

    There are none if the variants differ in their mesh.
    """
    for output in study.setup.outputs:
        if not output.everywhere:
            continue
        try:
            by_statistic = {"mean": study.map(output.name, "mean")}
        except InputError:
            return
        by_statistic["standard deviation"] = study.map(output.name, "std")
        if output.of == "settlement":
            by_statistic["probability of uplift"] = study.map(output.name, "probability of uplift")
        for what, statistic in by_statistic.items():
            probability = what == "probability of uplift"
            unit = UNITS["%"] if probability else choose_unit(output.dimension or None, statistic.values)
            title = f"{output.name}: {what}"
            yield page.Map(title, statistic.mesh.nodes, statistic.mesh.elements, statistic.values * unit.scale, unit)


def origin(study: Study) -> page.Origin:
    """Return the facts that make a study repeatable: its seed, versions and checksums, for the page."""
    about = study.about
    facts = [(name, str(about[name])) for name in ("seed", "variants", "made")]
    facts += [(f"SHA-256 of the {name} file", about[f"{name}_sha256"]) for name in ("study", "case")]
    facts += [(f"version of {name}", str(version)) for name, version in about["versions"].items()]
    return page.Origin(study.title, tuple(facts))
