"""A comparison of grounds as files in a folder: JSON, from which it is read back, CSV and a figure."""

from __future__ import annotations

import json
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.analysis.ground_comparison.comparison import GroundComparison
from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.storage import bounded
from groundslab.views.files import manifest, results_folder
from groundslab.views.ground_comparison.figure import plot_comparison
from groundslab.views.ground_comparison.rows import comparison_table, curve_table

if TYPE_CHECKING:
    from pydantic import TypeAdapter

    from groundslab.model.model import Model

#: The file that holds all of a comparison, and the version of its layout.
FILE, FORMAT = "ground-comparison.json", 1
#: Largest file that is read [bytes].
LARGEST = 50_000_000


def save_comparison(comparison: GroundComparison, folder: str | Path) -> Path:
    """Write a comparison of grounds into a new folder, or beside the results of the same model.

    The folder gets ``ground-comparison.json`` and ``ground-comparison.svg``, and ``ground_comparison.csv`` and
    ``ground_curves.csv`` among its tables. A report of results that have a comparison has it as a chapter.

    Parameters
    ----------
    comparison : GroundComparison
        The comparison.
    folder : str or pathlib.Path
        The folder. It may be missing, empty, or hold only what groundslab wrote.

    Returns
    -------
    pathlib.Path
        The folder's full path.

    Raises
    ------
    InputError
        If the folder cannot be written, holds other files, or results of another model.

    Examples
    --------
    >>> import groundslab
    >>> comparison = groundslab.compare_grounds(groundslab.load("case.toml"))
    >>> path = groundslab.save_comparison(comparison, "raft-results")
    """
    check(folder, comparison.model)
    tables = (comparison_table(comparison), curve_table(comparison))
    writers: dict[str, manifest.Writer] = {FILE: partial(manifest.write_text, text=json_text(comparison) + "\n")}
    writers |= {f"tables/{table.name}.csv": partial(manifest.write_text, text=table.csv()) for table in tables}
    writers["ground-comparison.svg"] = partial(plot_comparison, comparison)
    return results_folder.add_files(folder, writers)


def check(folder: str | Path, model: Model) -> Path:
    """Return the folder's full path if a comparison of a model may be written there; else raise InputError."""
    target = results_folder.check(folder)
    case = target / "case.toml"
    if case.is_file() and casefile.load(case) != model:
        hint = "solve this case into the folder first, or choose another folder; nothing was changed"
        raise InputError([Issue(str(folder), "results of another case", "results of the case compared", hint)])
    return target


def load_comparison(folder: str | Path) -> GroundComparison | None:
    """Return the comparison in a folder, None if there is none; raises InputError if it is damaged."""
    path = Path(folder) / FILE
    if not path.is_file():
        return None
    try:
        document = json.loads(bounded.read_whole(path, LARGEST))
        if document["format"] != FORMAT:
            raise ValueError(f"layout {document['format']}, while this version reads {FORMAT}")
        return _adapter().validate_python(document["comparison"] | {"model": casefile.loads(document["model"])})
    except (OSError, ValueError, KeyError, TypeError, RecursionError, InputError) as error:
        damage = f"something else ({' '.join(str(error).split())[:200]})"
        raise InputError([Issue(str(path), damage, "a comparison of grounds that groundslab wrote")]) from error


def json_text(comparison: GroundComparison) -> str:
    """Return a comparison as the text of a JSON file, in SI units; the model is there as TOML."""
    document: dict[str, Any] = {
        "program": "groundslab",
        "version": __version__,
        "format": FORMAT,
        "model": casefile.to_toml(comparison.model),
        "comparison": _adapter().dump_python(comparison, mode="json", exclude={"model"}),
    }
    return json.dumps(document, allow_nan=False)


@cache
def _adapter() -> TypeAdapter[GroundComparison]:
    """Return the type adapter that writes and reads a comparison."""
    from pydantic import TypeAdapter

    return TypeAdapter(GroundComparison)
