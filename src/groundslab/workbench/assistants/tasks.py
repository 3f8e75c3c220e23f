"""What the tools do, each in a process of its own: from names in a folder to a document, or a figure.

Each task is called with a function that tells how it goes on, the folder, and the tool's arguments.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.case import casefile
from groundslab.errors import EditedFilesKept, GroundslabError, InputError, Issue, NotCertified
from groundslab.study.check import check_case, refuse_file
from groundslab.views.interface import documents
from groundslab.workbench.assistants.confinement import (
    require_below,
    require_same,
    resolve,
    resolve_case,
    resolve_results,
)

if TYPE_CHECKING:
    from groundslab.model.loads.load_cases import Combination
    from groundslab.model.model import Model
    from groundslab.results.records import Step

#: Tells how a task goes on, in words.
Tell = Callable[[str], None]
#: Largest picture that is sent [bytes].
MAX_PICTURE = 5_000_000


def check(_: Tell, root: Path, case: str) -> dict[str, Any]:
    """Return the check of a case file."""
    path = resolve_case(root, case)
    try:
        return check_case(_read(root, path, case), case)
    except InputError as error:
        return refuse_file(error, case)


def solve(tell: Tell, root: Path, case: str, out: str, full: bool) -> dict[str, Any]:
    """Solve a case, write its results into a folder, and return their summary, short unless all of it is asked for."""
    from groundslab.analysis.driver import solve_combinations
    from groundslab.model.combinations import list_combinations
    from groundslab.views.files import results_folder
    from groundslab.views.summary.json_summary import to_json
    from groundslab.views.summary.progress import CombinationCount, line

    path = resolve_case(root, case)
    model = _read(root, path, case)
    target = resolve(root, out, "out") if out else path.with_name(f"{path.stem}-results")
    require_below(root, target, "out")
    if target in path.parents:
        raise InputError([Issue("out", "the folder that holds the case file", "another folder")])
    results_folder.check(target)
    count = CombinationCount(len(list_combinations(model)), mesh=1 if model.mesh.adaptive else None)

    def on_combination(combination: Combination) -> None:
        count.begin(combination.name)
        tell(f"{count.words()}begins")

    def on_step(step: Step) -> None:
        tell(count.words() + line(step))

    results = solve_combinations(model, on_step, on_combination, lambda _: count.begin_mesh())
    summary = to_json(results)
    if results.results or results.without_equilibrium or any(map(_is_inspected, results.unsolved.values())):
        tell("results are written")
        require_same(root, target, "out")
        with warnings.catch_warnings(record=True, action="always", category=EditedFilesKept) as kept:
            results_folder.save_results(results, target)
        summary["remarks"] += [str(warning.message) for warning in kept]
    return summary if full else _shorten(summary)


def checks(_: Tell, root: Path, results: str, full: bool) -> dict[str, Any]:
    """Return the design checks of a folder of results, with calculations if all is asked for."""
    from groundslab.views.files.results_folder import load_results

    document = documents.design_to_json(load_results(resolve_results(root, results)))
    return document if full else _without_steps(document)


def tables(_: Tell, root: Path, results: str, names: Sequence[str]) -> dict[str, Any]:
    """Return tables of a folder of results."""
    from groundslab.views.files.results_folder import load_results

    return documents.tables_to_json(load_results(resolve_results(root, results)), names)


def plot(_: Tell, root: Path, results: str, file: str, request: dict[str, Any]) -> tuple[str, bytes]:
    """Draw a figure into a file; return its path in the folder, and its content if it is a picture that can be sent."""
    from groundslab.views import plots
    from groundslab.views.files.results_folder import load_results
    from groundslab.views.plots import export
    from groundslab.views.plots.request import parse_request

    folder, target = resolve_results(root, results), resolve(root, file, "file")
    if folder in target.parents:
        raise InputError([Issue("file", "a place inside the folder of results", "a place outside it")])
    export.check(target)
    parsed = parse_request(load_results(folder), **request)
    require_same(root, target, "file")
    plots.write(parsed, target)
    content = target.read_bytes() if target.suffix.lower() == ".png" else b""
    return target.relative_to(root).as_posix(), content if len(content) <= MAX_PICTURE else b""


def _is_inspected(error: GroundslabError) -> bool:
    """Return whether results that are refused are written all the same, to be inspected."""
    return isinstance(error, NotCertified)


def _read(root: Path, path: Path, name: str) -> Model:
    """Return the model of a case file, whose building may name a file beside it; raises InputError."""
    data = casefile.tables(casefile.read(path), name)
    building = data.get("building")
    if isinstance(building, dict) and isinstance(building.get("file"), str):
        resolve(root, os.path.join(path.parent, building["file"]), "building.file")  # noqa: PTH118, as it may hold \0
    return casefile.from_table(data, path.parent)


def _shorten(summary: dict[str, Any]) -> dict[str, Any]:
    """Return a summary without calculations, and of several combinations without the figures and steps of each."""
    kept = ("name", "limit_state", "factors", "certified", "refused", "folder")
    short = {key: value for key, value in _without_steps(summary).items() if key != "history"}
    if "combinations" in short:
        short["combinations"] = [
            {key: combination[key] for key in kept if key in combination} for combination in short["combinations"]
        ]
    return short


def _without_steps(document: dict[str, Any]) -> dict[str, Any]:
    """Return a document whose checks have no calculation."""
    design = document["design"]
    return document | {"design": design | {"checks": [check | {"steps": []} for check in design["checks"]]}}
