"""The command solve: what it understands, and what it does."""

from __future__ import annotations

import os
import sys
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.cli.console import EXIT_DESIGN_FAILS, EXIT_NO_RESULT, EXIT_OK, print_stderr, print_stdout
from groundslab.errors import GroundslabError, InputError, Issue, NoEquilibrium, NotCertified

if TYPE_CHECKING:
    import argparse
    from contextlib import AbstractContextManager

    from groundslab.model.model import Model
    from groundslab.results.results import Results
    from groundslab.views.summary.progress import StatusLine


def describe(solve: argparse.ArgumentParser) -> None:
    """Add what the command solve understands."""
    solve.epilog = (
        "Every combination of loads is solved: those that the case lists, those that it has made by EN 1990, or, with "
        "neither, each load case by itself. If ground and supports cannot balance one of them, the foundation fails; "
        "if that or any check of the design fails, the exit code is 3. If nothing fails and one has no certified "
        "result, it is 1. The reasons are printed, and the results of the others are kept."
    )
    solve.add_argument("case", help="case file (TOML)")
    solve.add_argument("--out", metavar="DIR", help="folder for the results (default: <case>-results beside the case)")
    solve.add_argument("--json", action="store_true", help="print the summary as JSON, and nothing else")
    solve.add_argument("--plot", action="store_true", help="add picture.png to the results of each combination")
    solve.add_argument("--quiet", action="store_true", help="print neither summary nor progress")


def run(options: argparse.Namespace) -> int:
    """Analyze a case, keep the results in a folder, print the summary."""
    from groundslab.case import casefile
    from groundslab.views.files import results_folder

    case = Path(options.case)
    model = casefile.load(case)
    folder = Path(options.out) if options.out is not None else case.with_name(f"{case.stem}-results")
    # Checked now, since an analysis may take long and its results would be lost.
    target = results_folder.check(folder)
    if target in Path(os.path.realpath(case)).parents:
        found = f"{folder}, which holds the case file"
        raise InputError([Issue("--out", found, "another folder", "it would be replaced")])
    helper = _is_helper(model)
    results = _solve(model, quiet=options.quiet or helper)
    if helper:
        return EXIT_OK
    uncertified = any(isinstance(error, NotCertified) for error in results.unsolved.values())
    if results.results or results.without_equilibrium or uncertified:
        _save(results, folder, options)
    _print_unsolved(results)
    return _judge_design(results, options.quiet)


def _solve(model: Model, quiet: bool) -> Results:
    """Return the results, those of an only combination that fails or is not certified among them."""
    from groundslab.analysis.driver import solve
    from groundslab.model.combinations import list_combinations
    from groundslab.results.results import Results, results_of

    combinations = list_combinations(model)
    with _progress(quiet, len(combinations)) as status:
        try:
            return solve(model, status, status.begin if status is not None else None)
        except NotCertified as error:
            return results_of(error.results)
        except NoEquilibrium as error:
            return Results(model, combinations, {}, {combinations[0].name: error})


def _is_helper(model: Model) -> bool:
    """Return whether this process only helps another one to solve, which prints and writes for all of an MPI run."""
    if model.analysis.solver != "mumps":
        return False
    from groundslab.solvers import factorization

    factorization.choose("mumps")
    from groundslab.solvers.direct import mumps

    return not mumps.is_root_process()


def _save(results: Results, folder: Path, options: argparse.Namespace) -> None:
    """Write results into the folder and print their summary; if the folder cannot be written, keep them elsewhere."""
    from groundslab.views.files import results_folder

    try:
        results_folder.save_results(results, folder, plot=options.plot)
    except (GroundslabError, OSError, MemoryError):
        # The disk is no reason to lose the answer.
        _print_summary(results, options)
        kept = results_folder.write_elsewhere(results, folder)
        print_stderr(f"{folder} cannot be written" + (f"; the results are kept in {kept}" if kept is not None else ""))
        raise
    _print_summary(results, options)
    if not (options.quiet or options.json):
        names = ", ".join(sorted(path.name for path in folder.iterdir()))
        print_stderr(f"results in {folder}: {names}")


def _print_summary(results: Results, options: argparse.Namespace) -> None:
    """Print the summary to standard output, as text or as JSON."""
    if options.json:
        from groundslab.views.summary.json_summary import json_text

        print_stdout(json_text(results))
    elif not options.quiet:
        from rich.console import Console

        from groundslab.views.summary.terminal import print_summary

        console = Console()
        # Captured, since rich ends the program when a pipe breaks.
        with console.capture() as captured:
            print_summary(results, console)
        print_stdout(captured.get().rstrip("\n"))


def _judge_design(results: Results, quiet: bool) -> int:
    """Print what fails or needs attention, the combinations without equilibrium among it; return the exit code.

    A design or foundation that fails counts more than what the program could not solve.
    """
    from groundslab.design.checks import check_design

    design = check_design(results)
    code = EXIT_DESIGN_FAILS if design.status == "fails" else EXIT_NO_RESULT if results.unsolved else EXIT_OK
    lost = results.without_equilibrium
    for name, error in lost.items() if quiet or len(lost) > 1 else ():
        print_stderr(f'FOUNDATION FAILS: combination "{name}": {error}')
    if design.open and not quiet:
        end = f"Exit code {code}." if results.refused else f"The analysis itself is certified (exit code {code})."
        print_stderr(f"{design.headline} {end}")
    return code


def _print_unsolved(results: Results) -> None:
    """Print why combinations have no certified result, and which if there are several."""
    if not results.unsolved:
        return
    if len(results.combinations) == 1:
        print_stderr(f"error: {next(iter(results.unsolved.values()))}")
        return
    for name, error in results.unsolved.items():
        print_stderr(f'error: combination "{name}": {error}')
    count = len(results.combinations)
    print_stderr(f"error: {len(results.unsolved)} of {count} combinations have no certified result")


def _progress(quiet: bool, count: int) -> AbstractContextManager[StatusLine | None]:
    """Return a context whose value shows each step on a terminal; without a terminal it does nothing."""
    if quiet or not sys.stderr.isatty():
        return nullcontext()
    from groundslab.views.summary.progress import progress

    return progress(count=count)
