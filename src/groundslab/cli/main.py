"""The command line: groundslab solve, compare-ground, study, plot, report, tables, bars, app, view, check, new, ...

Exit codes: 0 fine; 1 no certified result (of one combination of loads at least), or a verification case that fails;
2 wrong input or usage; 3 a foundation without equilibrium, or a design that fails a check; 130 interrupted.
What a command returns goes to standard output, everything else to standard error.
"""

from __future__ import annotations

import argparse
import os
import sys
import warnings
from collections.abc import Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.cli import (
    case,
    compare,
    console,
    ifc,
    import_reactions,
    mcp,
    plot,
    propose_bars,
    saf,
    solve,
    study,
)
from groundslab.errors import EditedFilesKept, GroundslabError, InputError, Issue, NoEquilibrium, NotConverged

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code; errors raised on purpose end without a traceback."""
    for stream in (sys.stdout, sys.stderr):
        # A title may hold letters that the terminal's encoding lacks.
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")
    options = _options(sys.argv[1:] if arguments is None else arguments)
    try:
        with _kept_files_told():
            return int(options.run(options))
    except BrokenPipeError:
        console.close_output()
        return console.EXIT_OK
    except KeyboardInterrupt:
        console.print_stderr("interrupted")
        return console.EXIT_INTERRUPTED
    except (OSError, GroundslabError, MemoryError) as error:
        if getattr(options, "json", False):
            from groundslab.views.interface.documents import error_to_json, to_text

            console.print_stdout(to_text(error_to_json(error)))
        return _print_error(error)


def _print_error(error: Exception) -> int:
    """Print an error that was raised on purpose, or by the system, and return its exit code."""
    if isinstance(error, InputError):
        console.print_stderr(console.format_issues(error))
        return console.EXIT_WRONG_INPUT
    if isinstance(error, OSError):
        console.print_stderr(f"error: {error}")
        return console.EXIT_WRONG_INPUT
    if isinstance(error, NoEquilibrium):
        console.print_stderr(f"FOUNDATION FAILS: {error}")
        return console.EXIT_DESIGN_FAILS
    if isinstance(error, NotConverged):
        _print_history(error)
    elif isinstance(error, MemoryError):
        console.print_stderr("error: not enough memory for this analysis; a coarser mesh needs less")
    else:
        console.print_stderr(f"error: {error}")
    return console.EXIT_NO_RESULT


@contextmanager
def _kept_files_told() -> Iterator[None]:
    """Print as a note that files were kept which somebody had edited; other warnings are shown as ever."""
    with warnings.catch_warnings():
        warnings.simplefilter("always", EditedFilesKept)
        show = warnings.showwarning

        def tell(
            message: Warning | str, category: type[Warning], filename: str, lineno: int, *more: Any, **options: Any
        ) -> None:
            if issubclass(category, EditedFilesKept):
                console.print_stderr(f"note: {message}")
            else:
                show(message, category, filename, lineno, *more, **options)

        warnings.showwarning = tell
        yield


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    """Return the arguments by name; fields may stand behind options, and coordinates may begin with a minus."""
    joined: list[str] = []
    for argument in arguments:
        if joined and joined[-1] == "--line":
            joined[-1] = f"--line={argument}"
        else:
            joined.append(argument)
    parser = _parser()
    options, left = parser.parse_known_args(joined)
    if left:
        if not hasattr(options, "fields") or any(word.startswith("-") for word in left):
            parser.error(f"unrecognized arguments: {' '.join(left)}")
        options.fields += left
    return options


def _parser() -> argparse.ArgumentParser:
    """Return the description of the command line."""
    parser = argparse.ArgumentParser(
        prog="groundslab",
        description="Thick plates on layered, two-parameter, tensionless ground.",
        epilog="Exit codes: 0 success (not a design approval); 1 no certified result; 2 wrong input or usage; "
        "3 a foundation without equilibrium, or a design that fails a check; 130 interrupted.",
    )
    parser.add_argument("--version", action="version", version=f"groundslab {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)

    solve.describe(_command(commands, "solve", solve.run, "analyze a case and keep the results"))
    meaning = "compare the ground of a case with an elastic continuum, and fit springs to it"
    compare.describe_grounds(_command(commands, "compare-ground", compare.compare_grounds, meaning))
    meaning = "compare thicknesses, drop panels and bars for a slab: utilizations and quantities"
    compare.describe_designs(_command(commands, "compare-designs", compare.compare_designs, meaning))
    plot.describe(_command(commands, "plot", plot.run, "draw figures of results: PDF, SVG or PNG"))
    _add_pages(commands)
    study.describe(_command(commands, "study", study.run, "solve many variants of a case and save one row per variant"))
    study.describe_evaluation(
        _command(commands, "evaluate", study.evaluate, "make the report and the tables of a study from its rows")
    )

    meaning = "read a case or study file and list all its issues"
    case.describe_check(_command(commands, "check", case.check_case, meaning))

    new = _command(commands, "new", case.write_starter, "write a case file to start from")
    new.add_argument("file", nargs="?", metavar="FILE", help="file to write (default: print the text)")

    dxf = _command(commands, "dxf", case.convert_drawing, "make a case file from a drawing and report what was read")
    case.describe_dxf(dxf)

    _add_exchange(commands)
    _describe_report(_command(commands, "report", _report, "make a report of results: one HTML file, or a PDF"))

    _describe_tables(_command(commands, "tables", _tables, "write the tables of results into a workbook (XLSX)"))

    bars = _command(commands, "bars", plot.run_bars, "draw the bars provided in a case, with quantities: SVG and DXF")
    plot.describe_bars(bars)

    meaning = "propose bars for a case: a base and zones in each layer, with little steel"
    propose_bars.describe(_command(commands, "propose-bars", propose_bars.run, meaning))

    verify = _command(commands, "verify", _verify, "solve cases with known answers and compare")
    verify.add_argument("names", nargs="*", metavar="NAME", help="cases to run (default: all)")
    verify.add_argument("--list", action="store_true", help="print the names of the cases and stop")

    meaning = "let assistants check, solve and read cases in one folder (Model Context Protocol)"
    mcp.describe(_command(commands, "mcp", mcp.run, meaning))

    _command(commands, "schema", case.print_schema, "print the JSON schema of a case file")
    return parser


def _add_pages(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the commands that serve a page."""
    app = _command(commands, "app", _app, "edit a case in the browser and see its results immediately")
    app.epilog = "The page is served on this machine only, until Ctrl-C. Unsaved work is kept and offered next time."
    app.add_argument("case", nargs="?", help="case file (TOML; default: a new one)")
    app.add_argument("--port", type=int, default=0, metavar="N", help="port of the server (default: any free port)")
    app.add_argument("--no-browser", action="store_true", help="print the address only")
    view = _command(commands, "view", _view, "view saved results in the browser, read-only")
    view.epilog = "The page is served on this machine only, until Ctrl-C. Nothing is written."
    view.add_argument("results", metavar="RESULTS", help="folder written by groundslab solve, or a saved ZIP file")
    view.add_argument("--port", type=int, default=0, metavar="N", help="port of the server (default: any free port)")
    view.add_argument("--no-browser", action="store_true", help="print the address only")


def _add_exchange(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the commands that read and write files of other programs."""
    meaning = "take column and wall reactions of another program as loads, and show what they change"
    import_reactions.describe(_command(commands, "import-reactions", import_reactions.run, meaning))
    meaning = "make a case file from a slab in a file of the Structural Analysis Format (XLSX) and report what was read"
    saf.describe_import(_command(commands, "import-saf", saf.import_file, meaning))
    meaning = "write a case to a file of the Structural Analysis Format (XLSX)"
    saf.describe_export(_command(commands, "export-saf", saf.export_file, meaning))
    meaning = (
        "make a case file from a slab in a building model (IFC 2x3 or IFC 4) and report what was read: geometry alone"
    )
    ifc.describe(_command(commands, "import-ifc", ifc.run, meaning))


def _describe_tables(tables: argparse.ArgumentParser) -> None:
    """Add what the command tables understands."""
    tables.epilog = "An existing file is replaced only if it is such a workbook. The folder also has each table as CSV."
    tables.add_argument("results", metavar="RESULTS", help="results folder written by groundslab solve")
    tables.add_argument("--out", metavar="FILE", help="file to write (default: RESULTS.xlsx next to the folder)")
    tables.add_argument("--json", action="store_true", help="print the tables as JSON, and write no workbook")
    tables.add_argument(
        "--only", nargs="+", metavar="NAME", default=[], help="tables to print as JSON, such as checks (default: all)"
    )


def _describe_report(report: argparse.ArgumentParser) -> None:
    """Add what the command report understands."""
    report.epilog = (
        "The file holds case, drawings, certificate, tables, pictures and a viewer; it opens in any browser without a "
        "network. An existing file is replaced only if it is such a report."
    )
    report.add_argument("results", metavar="RESULTS", help="results folder written by groundslab solve")
    report.add_argument("--out", metavar="FILE", help="file to write, a PDF if it ends in .pdf (default: RESULTS.html)")
    report.add_argument("--pdf", action="store_true", help="make RESULTS.pdf, typeset to be printed and archived")
    report.add_argument(
        "--length", choices=["short", "full"], help="how much it holds (default: short on paper, full on the page)"
    )
    report.add_argument(
        "--chapters",
        nargs="+",
        metavar="NAME",
        help="chapters to include, such as extremes pictures tables (default: those of report.chapters in the case)",
    )


def _command(
    commands: argparse._SubParsersAction[argparse.ArgumentParser],
    name: str,
    run: Callable[[argparse.Namespace], int],
    meaning: str,
) -> argparse.ArgumentParser:
    """Add a command to the command line and return its own parser."""
    command = commands.add_parser(name, help=meaning, description=f"{meaning[0].upper()}{meaning[1:]}.")
    command.set_defaults(run=run)
    return command


def _app(options: argparse.Namespace) -> int:
    """Serve the workbench until it is interrupted."""
    from groundslab.workbench.server.main import serve

    serve(None if options.case is None else Path(options.case), options.port, not options.no_browser)
    return console.EXIT_OK


def _view(options: argparse.Namespace) -> int:
    """Serve kept results until interrupted."""
    from groundslab.workbench.server.main import serve_results

    serve_results(Path(options.results), options.port, not options.no_browser)
    return console.EXIT_OK


def _report(options: argparse.Namespace) -> int:
    """Make a report of a folder of results."""
    from groundslab.views import report
    from groundslab.views.files import results_folder
    from groundslab.views.ground_comparison.files import load_comparison

    folder, suffix = Path(options.results), ".pdf" if options.pdf else ".html"
    target = Path(options.out) if options.out is not None else report.default_path(folder, suffix)
    if options.pdf and target.suffix.lower() != ".pdf":
        raise InputError([Issue("--out", str(target), "a name that ends in .pdf, because of --pdf")])
    if Path(os.path.realpath(folder)) in Path(os.path.realpath(target)).parents:
        place, hint = f"{target}, which is in the folder of the results", "groundslab solve would not replace it then"
        raise InputError([Issue("--out", place, "another folder", hint)])
    report.check(target)
    combined = results_folder.load_results(folder)
    text, comparison = report.text_of(folder, combined.model), load_comparison(folder)
    remark, chapters = report.changes_since(folder, combined.model), options.chapters
    report.write_report(
        combined, target, text=text, chapters=chapters, comparison=comparison, remark=remark, length=options.length
    )
    console.print_stderr(f"wrote {target}")
    if remark:
        console.print_stderr(f"note: {remark}")
    count = len(combined.combinations)
    if combined.without_equilibrium:
        lost = len(combined.without_equilibrium)
        console.print_stderr(f"note: the foundation fails, without equilibrium in {lost} of {count} combinations")
    if combined.unsolved:
        console.print_stderr(f"note: {len(combined.unsolved)} of {count} combinations have no certified result")
    return console.EXIT_OK


def _tables(options: argparse.Namespace) -> int:
    """Write the tables of a folder of results into a workbook, or print them as JSON."""
    from groundslab.views.files import results_folder, xlsx

    if options.json:
        from groundslab.views.interface.documents import tables_to_json, to_text

        if options.out is not None:
            raise InputError([Issue("--out", options.out, "no file, as JSON is printed", "leave out one of the two")])
        console.print_stdout(to_text(tables_to_json(results_folder.load_results(options.results), options.only)))
        return console.EXIT_OK
    if options.only:
        raise InputError([Issue("--only", " ".join(options.only), "--json with it", "a workbook has all tables")])
    target = Path(options.out) if options.out is not None else xlsx.default_path(options.results)
    xlsx.check(target)
    xlsx.write_workbook(results_folder.load_results(options.results), target)
    console.print_stderr(f"wrote {target}")
    return console.EXIT_OK


def _verify(options: argparse.Namespace) -> int:
    """Run the verification cases, or list them."""
    from groundslab.verification import runner

    cases = list(runner.names())
    if options.list:
        console.print_stdout("\n".join(cases))
        return console.EXIT_OK
    expected = "a case that `groundslab verify --list` names"
    issues = [Issue("verify", f'"{name}"', expected) for name in options.names if name not in cases]
    if issues:
        raise InputError(issues)
    from rich.console import Console

    return console.EXIT_OK if runner.run(options.names or cases, Console()) else console.EXIT_NO_RESULT


def _print_history(error: NotConverged) -> None:
    """Print what did not converge, and how."""
    from groundslab.results.records import Step

    steps = [step for step in error.history if isinstance(step, Step)]
    console.print_stderr(f"error: {error.what} did not converge in {len(error.history)} steps; the last of them:")
    if steps and len(steps) == len(error.history):
        from rich.console import Console

        from groundslab.views.summary.terminal import print_history

        print_history(steps[-20:], Console(stderr=True))
    else:
        for entry in error.history[-20:]:
            pairs = entry.items() if isinstance(entry, Mapping) else None
            console.print_stderr(
                "  " + (", ".join(f"{name} {value}" for name, value in pairs) if pairs else str(entry))
            )
