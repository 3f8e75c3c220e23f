"""Studies: many variants of one case, their results kept row by row.

    import groundslab

    study = groundslab.study("study.toml")
    study.table()

The package can be called: ``groundslab.study(...)`` runs a study, ``groundslab.study.open_study`` opens one.
"""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from groundslab.model import Model
    from groundslab.study.description import StudyFile
    from groundslab.study.opened import Study, open_study

__all__ = ["Study", "StudyFile", "open_study", "run"]

#: Where the names live that load when they are first used.
_HOME = {"Study": "opened", "open_study": "opened", "StudyFile": "description"}


def run(
    study: str | Path | StudyFile,
    *,
    case: str | Path | Model | None = None,
    out: str | Path | None = None,
    resume: bool = False,
) -> Study:
    """Run a study and return it with all its rows; raises InputError if it cannot be run.

    study is a file or a StudyFile; case takes the place of the case that it names. Rows are kept in the folder out, by
    default `<study>-study` beside the file.
    """
    from groundslab.study import files, running

    if isinstance(study, str | Path):
        path = Path(study)
        read = files.read(path, case)  # type: ignore[arg-type]
        folder = path.with_name(f"{path.stem}-study") if out is None else Path(out)
    else:
        read = files.made(study, case)
        folder = Path("study") if out is None else Path(out)
    return running.run(read, folder, resume)


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
