"""Studies: many variants of one case, their results kept row by row.

    import groundslab

    study = groundslab.study("study.toml")
    study.table()

The package can be called: ``groundslab.study(...)`` runs a study, ``groundslab.study.open_study`` opens one,
``groundslab.study.evaluate`` writes its page and tables, ``groundslab.study.reliability`` finds a design point.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import lazy_loader

from groundslab.study.call import CallableModule

if TYPE_CHECKING:
    from groundslab.model.model import Model
    from groundslab.study.definition.schema import StudyFile
    from groundslab.study.definition.setup import Variable
    from groundslab.study.evaluation.form import reliability
    from groundslab.study.evaluation.study import Study, open_study
    from groundslab.study.report.writer import evaluate

__all__ = ["Study", "StudyFile", "evaluate", "open_study", "reliability", "run"]

#: Failures of workers that are listed.
MAX_FAILURES = 10

__getattr__, __dir__, _ = lazy_loader.attach(
    __name__,
    submod_attrs={
        "definition.schema": ["StudyFile"],
        "evaluation.form": ["reliability"],
        "evaluation.study": ["Study", "open_study"],
        "report.writer": ["evaluate"],
    },
)


def run(
    study: str | Path | StudyFile,
    *,
    case: str | Path | Model | None = None,
    out: str | Path | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    dashboard: bool = False,
    resume: bool = False,
    quiet: bool = False,
) -> Study:
    """Run a study: solve all variants of a case and keep a row of each, on the disk as soon as it is solved.

    Parameters
    ----------
    study : str or Path or StudyFile
        A study file, or a study described in Python.
    case : str or Path or Model, optional
        Takes the place of the case that the study names.
    out : str or Path, optional
        Folder for the rows; by default `<study>-study` beside the file.
    workers : int, optional
        Number of processes on this machine, by default one for each core; 0 solves in this process.
    scheduler : str, optional
        Address of a Dask scheduler, such as "tcp://127.0.0.1:8786", whose cluster is used instead.
    dashboard : bool
        Whether to serve Dask's dashboard for the processes of this machine.
    resume : bool
        Continue the study in the folder, if there is one.
    quiet : bool
        Show no progress on standard error.

    Returns
    -------
    Study
        The study in its folder, with the rows of all variants but those whose workers failed.

    Raises
    ------
    InputError
        If the study cannot begin: issues in the files, a folder that is taken, missing packages.
    GroundslabError
        If rows cannot be written or the scheduler is lost; earlier rows are kept.

    Examples
    --------
    >>> study = groundslab.study("slab.study.toml", workers=4)  # doctest: +SKIP
    """
    from groundslab.errors import InputError, Issue
    from groundslab.study.definition import files
    from groundslab.study.evaluation.study import Study
    from groundslab.study.execution import progress, runner

    if workers is not None and scheduler is not None:
        raise InputError([Issue("workers", "workers and a scheduler", "one of them", "a cluster has its own workers")])
    resolved = files.read(study, case) if isinstance(study, str | Path) else files.resolve(study, case)
    folder = study_folder(study, out)
    with progress.show_progress(quiet) as on_progress:
        runner.run(resolved, folder, runner.Resources(workers, scheduler, dashboard), resume, on_progress)
    return Study(folder)


def study_folder(study: str | Path | StudyFile, out: str | Path | None) -> Path:
    """Return the folder of a study: `out`, or by default one beside the study's file."""
    if out is not None:
        return Path(out)
    return Path(study).with_name(f"{Path(study).stem}-study") if isinstance(study, str | Path) else Path("study")


def describe_file(path: Path) -> list[str]:
    """Return a summary of a study file, line by line; raises InputError with all its issues."""
    from groundslab.study.definition import files, setup

    study = files.read(path).setup
    lines = [f"{path}: fine ({study.count} variants, {study.sampling.kind})"]
    lines += [f"  varies {variable.name}: {_describe_variable(variable)}" for variable in study.variables]
    lines += [f"  random field {field.name}: a factor on {field.path}" for field in study.fields]
    lines += [f"  keeps {output.name}" + (f" [{output.unit}]" if output.unit else "") for output in study.outputs]
    return lines + [f"warning: {line}" for line in setup.warnings_of(study)]


def _describe_variable(variable: Variable) -> str:
    """Return in words how a quantity varies."""
    parts = [variable.path if variable.name != variable.path else "", "a factor" if variable.times else ""]
    if variable.distribution is None:
        parts.append(f"{len(variable.values or ())} values")
    else:
        distribution = variable.distribution
        parts.append(f"{distribution.dist.name}, mean {distribution.mean():.5g} {variable.unit}".strip())
        parts.append(f"standard deviation {distribution.std():.5g} {variable.unit}".strip())
    return ", ".join(filter(None, parts))


def summarize(study: Study) -> list[str]:
    """Return a summary of a study's variants, line by line."""
    counts = study.counts()
    lines = [f"{study.folder}: {len(study)} of {study.count} variants have a row, {counts.pop('solved', 0)} solved"]
    lines += [f"  {number} {_failure_words(reason)}" for reason, number in counts.items()]
    failures = study.worker_failures()
    lines += [f"  variant {number} has none: {message}" for number, message in list(failures.items())[:MAX_FAILURES]]
    if len(failures) > MAX_FAILURES:
        lines.append(f"  and {len(failures) - MAX_FAILURES} more")
    return lines


def _failure_words(reason: str) -> str:
    """Return how variants ended that are not solved."""
    from groundslab.study.execution.variant import WITHOUT_EQUILIBRIUM

    return f"have a foundation that fails: {reason}" if reason in WITHOUT_EQUILIBRIUM else f"failed: {reason}"


def resume_hint(folder: Path, command: str) -> str:
    """Return how many rows an incomplete study has, and the command that continues it."""
    from groundslab.study.evaluation.study import Study
    from groundslab.study.execution import store

    if not store.is_store(folder):
        return f"no rows yet; start again with: {command}"
    study = Study(folder)
    return f"{len(study)} of {study.count} rows are kept in {folder}; continue with: {command} --resume"


sys.modules[__name__].__class__ = CallableModule
