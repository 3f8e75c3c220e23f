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
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from groundslab.model.model import Model
    from groundslab.study.definition.schema import StudyFile
    from groundslab.study.definition.setup import Variable
    from groundslab.study.evaluation.form import reliability
    from groundslab.study.evaluation.study import Study, open_study
    from groundslab.study.report.writer import evaluate

__all__ = ["Study", "StudyFile", "evaluate", "open_study", "reliability", "run"]

#: Mishaps that are told of.
MOST_MISHAPS = 10
#: Where the names live that load when they are first used.
_HOME = {
    "Study": "evaluation.study",
    "open_study": "evaluation.study",
    "StudyFile": "definition.schema",
    "evaluate": "report.writer",
    "reliability": "evaluation.form",
}


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
    """Run a study and return it; raises InputError if it cannot begin.

    study is a file or a StudyFile; case takes the place of the case that it names. Variants are solved in so many
    processes of this machine (workers, one for each core by default; 0 for none but this), or on the cluster of a Dask
    scheduler such as "tcp://127.0.0.1:8786". With dashboard the processes of this machine can be watched in a
    browser. Rows are kept in the folder out, by default `<study>-study` beside the file; with resume a study that is
    there goes on. Progress is shown on standard error unless quiet.

    Where rows cannot be written, or the scheduler is lost, GroundslabError is raised; rows that were there are kept.
    """
    from groundslab.errors import InputError, Issue
    from groundslab.study.definition import files
    from groundslab.study.evaluation import study as opened
    from groundslab.study.execution import progress, runner

    if workers is not None and scheduler is not None:
        raise InputError([Issue("workers", "workers and a scheduler", "one of them", "a cluster has its own workers")])
    read = files.read(study, case) if isinstance(study, str | Path) else files.made(study, case)
    folder = folder_of(study, out)
    where = runner.Where(workers, scheduler, dashboard)
    with progress.shown(quiet) as on_progress:
        runner.run(read, folder, where, resume, on_progress)
    return opened.Study(folder)


def folder_of(study: str | Path | StudyFile, out: str | Path | None) -> Path:
    """Return the folder of a study: the one that is named, or one beside the study's file."""
    if out is not None:
        return Path(out)
    return Path(study).with_name(f"{Path(study).stem}-study") if isinstance(study, str | Path) else Path("study")


def described(path: Path) -> list[str]:
    """Return what a study file describes, a line each; raises InputError with all that is wrong with it."""
    from groundslab.study.definition import files, setup

    found = files.read(path).setup
    lines = [f"{path}: fine ({found.count} variants, {found.sampling.kind})"]
    lines += [f"  varies {each.name}: {_how(each)}" for each in found.variables]
    lines += [f"  random field {each.name}: a factor on {each.path}" for each in found.fields]
    lines += [f"  keeps {output.name}" + (f" [{output.unit}]" if output.unit else "") for output in found.outputs]
    return lines + [f"warning: {line}" for line in setup.warnings_of(found)]


def _how(variable: Variable) -> str:
    """Return in words how a quantity varies."""
    parts = [variable.path if variable.name != variable.path else "", "a factor" if variable.times else ""]
    drawn = variable.distribution
    if drawn is None:
        parts.append(f"{len(variable.values or ())} values")
    else:
        parts.append(f"{drawn.name}, mean {drawn.mean:.5g} {variable.unit}".strip())
        parts.append(f"standard deviation {drawn.std:.5g} {variable.unit}".strip())
    return ", ".join(filter(None, parts))


def outcome(study: Study) -> list[str]:
    """Return what became of a study's variants, a line each."""
    counts = study.counts()
    lines = [f"{study.folder}: {len(study)} of {study.count} variants have a row, {counts.pop('solved', 0)} solved"]
    lines += [f"  {number} failed: {reason}" for reason, number in counts.items()]
    mishaps = study.mishaps()
    lines += [f"  variant {number} has none: {message}" for number, message in list(mishaps.items())[:MOST_MISHAPS]]
    if len(mishaps) > MOST_MISHAPS:
        lines.append(f"  and {len(mishaps) - MOST_MISHAPS} more")
    return lines


def how_to_go_on(folder: Path, command: str) -> str:
    """Return what is kept of a study that is not at its end, and the command by which it goes on."""
    from groundslab.study.evaluation import study as opened
    from groundslab.study.execution import store

    if not store.is_store(folder):
        return f"nothing was begun; again: {command}"
    study = opened.Study(folder)
    return f"{len(study)} of {study.count} rows are kept in {folder}; go on with: {command} --resume"


def __getattr__(name: str) -> object:
    """Return a public name from the module that it lives in, which is imported now."""
    if name not in _HOME:
        raise AttributeError(f"module 'groundslab.study' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"groundslab.study.{_HOME[name]}"), name)


class _Callable(ModuleType):
    """A module that runs a study when it is called."""

    def __call__(self, *arguments: Any, **options: Any) -> Study:
        return run(*arguments, **options)


sys.modules[__name__].__class__ = _Callable
