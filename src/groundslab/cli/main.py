"""The command line: groundslab solve, study, evaluate, plot, report, app, check, new, dxf, verify, schema.

Exit codes: 0 fine, whatever the checks of the design say in words; 1 no certified result (of one combination of loads
at least), or a verification case that fails; 2 wrong input or usage; 130 interrupted.
What a command is asked for goes to standard output, everything else to standard error.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Mapping
from contextlib import nullcontext
from typing import TYPE_CHECKING

from groundslab._version import __version__
from groundslab.cli import plot
from groundslab.cli import study as command_study
from groundslab.cli.console import FINE, INTERRUPTED, NO_RESULT, WRONG_INPUT, answer, close_output, in_blocks, say
from groundslab.errors import GroundslabError, InputError, Issue, NotCertified, NotConverged

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from contextlib import AbstractContextManager

    from rich.console import Console

    from groundslab.case.dxf.layers import Layers
    from groundslab.model.model import Model
    from groundslab.results.results import Combined, Results
    from groundslab.views.summary.progress import Shown


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code; errors raised on purpose end without a traceback."""
    for stream in (sys.stdout, sys.stderr):
        # A title may hold letters that the terminal's encoding lacks.
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")
    options = _options(sys.argv[1:] if arguments is None else arguments)
    try:
        code: int = options.run(options)
    except InputError as error:
        say(in_blocks(error))
        return WRONG_INPUT
    except NotConverged as error:
        _not_converged(error)
        return NO_RESULT
    except GroundslabError as error:
        say(f"error: {error}")
        return NO_RESULT
    except MemoryError:
        say("error: the memory is too small for this analysis; a coarser mesh needs less")
        return NO_RESULT
    except BrokenPipeError:
        close_output()
        return FINE
    except OSError as error:
        say(f"error: {error}")
        return WRONG_INPUT
    except KeyboardInterrupt:
        say("interrupted")
        return INTERRUPTED
    return code


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
    if left and (not hasattr(options, "fields") or any(word.startswith("-") for word in left)):
        parser.error(f"unrecognized arguments: {' '.join(left)}")
    if left:
        options.fields += left
    return options


def _parser() -> argparse.ArgumentParser:
    """Return the description of the command line."""
    parser = argparse.ArgumentParser(
        prog="groundslab",
        description="Thick plates on layered, two-parameter, tensionless ground.",
        epilog="Exit codes: 0 fine, which is no approval of a design; 1 no certified result; 2 wrong input or usage; "
        "130 interrupted.",
    )
    parser.add_argument("--version", action="version", version=f"groundslab {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)

    solve = _command(commands, "solve", _solve, "analyse a case and keep the results")
    solve.epilog = (
        "Every combination of loads is solved: those that the case lists, those that it has made by EN 1990, or, with "
        "neither, each load case by itself. If one of them, listed or not, has no certified result, it is told why, "
        "the results of the others are kept, and the exit code is 1."
    )
    solve.add_argument("case", help="case file (TOML)")
    solve.add_argument("--out", metavar="DIR", help="folder for the results (default: <case>-results beside the case)")
    solve.add_argument("--json", action="store_true", help="print the summary as JSON, and nothing else")
    solve.add_argument("--plot", action="store_true", help="add picture.png to the results of each combination")
    solve.add_argument("--quiet", action="store_true", help="print neither summary nor progress")

    plot.describe(_command(commands, "plot", _plot, "draw figures of results: PDF, SVG or PNG"))
    app = _command(commands, "app", _app, "edit a case in the browser and see its results at once")
    app.epilog = "The page is served on this machine alone, until Ctrl-C. Unsaved work is kept and offered again."
    app.add_argument("case", nargs="?", help="case file (TOML; default: a new one)")
    app.add_argument("--port", type=int, default=0, metavar="N", help="port of the server (default: any that is free)")
    app.add_argument("--no-browser", action="store_true", help="print the address only")
    study = _command(commands, "study", command_study.run, "solve many variants of a case and keep a row of each")
    command_study.describe(study)
    evaluate = _command(
        commands, "evaluate", command_study.evaluate, "make the page and the tables of a study from its rows"
    )
    command_study.describe_evaluation(evaluate)

    check = _command(
        commands, "check", _check, "read a case file, or a study file, and say everything that is wrong with it"
    )
    check.add_argument("case", help="case file or study file (TOML)")

    new = _command(commands, "new", _new, "write a case file to start from")
    new.add_argument("file", nargs="?", metavar="FILE", help="file to make (default: print the text)")

    dxf = _command(commands, "dxf", _dxf, "make a case file from a drawing, and report what was taken from it")
    dxf.add_argument("drawing", metavar="DRAWING", help="drawing (DXF)")
    dxf.add_argument(
        "--layers",
        nargs="+",
        action="extend",
        default=[],
        metavar="WHAT=NAME",
        help="names of layers; WHAT is outline, openings, zones, columns, point_loads, line_loads or area_loads, whose "
        "usual layers are OUTLINE, OPENINGS, ZONES, COLUMNS, LOADS, LOAD_LINE and LOAD_AREA",
    )
    dxf.add_argument("--unit", help='unit of the drawing, such as "mm" (default: the one that it names)')
    dxf.add_argument("--out", metavar="FILE", help="file to make (default: print the text)")

    report = _command(commands, "report", _report, "make a report of results: one HTML file, to read and to print")
    report.epilog = (
        "The file holds case, drawings, certificate, tables, pictures and a viewer; it opens in any browser without a "
        "network. A file that exists is replaced only if it is such a report."
    )
    report.add_argument("results", metavar="RESULTS", help="folder of results that groundslab solve has written")
    report.add_argument("--out", metavar="FILE", help="file to make (default: RESULTS.html beside the folder)")

    verify = _command(commands, "verify", _verify, "solve cases with known answers and compare")
    verify.add_argument("names", nargs="*", metavar="NAME", help="cases to run (default: all)")
    verify.add_argument("--list", action="store_true", help="print the names of the cases and stop")

    _command(commands, "schema", _schema, "print the JSON schema of a case file")
    return parser


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


def _solve(options: argparse.Namespace) -> int:
    """Analyse a case, keep the results in a folder, print the summary."""
    from pathlib import Path

    from groundslab.case import casefile
    from groundslab.views.files import results_folder

    case = Path(options.case)
    model = casefile.load(case)
    folder = Path(options.out) if options.out is not None else case.with_name(f"{case.stem}-results")
    # Asked now, since an analysis may take long and its results would be lost.
    target = results_folder.check(folder)
    if target in Path(os.path.realpath(case)).parents:
        raise InputError(
            [Issue("--out", f"{folder}, which holds the case file", "another folder", "it would be replaced")]
        )
    from groundslab.analysis.driver import solve_combinations
    from groundslab.model.combinations import combinations_of

    follows = _follows(model)
    with _progress(options.quiet or follows, len(combinations_of(model))) as shown:
        combined = solve_combinations(model, shown, shown.begin if shown is not None else None)
    if follows:
        return FINE
    results = _to_keep(combined)
    if results is None:
        _tell_refused(combined)
        return NO_RESULT
    try:
        results_folder.write(results, folder, plot=options.plot)
    except (GroundslabError, OSError, MemoryError):
        # The disk is no reason to lose the answer.
        _show(results, options)
        kept = results_folder.write_elsewhere(results, folder)
        say(f"{folder} cannot be written" + (f"; the results are kept in {kept}" if kept is not None else ""))
        raise
    _show(results, options)
    if not (options.quiet or options.json):
        names = ", ".join(sorted(path.name for path in folder.iterdir()))
        say(f"results in {folder}: {names}")
    if not combined.refused:
        if not options.quiet:
            _tell_design(combined)
        return FINE
    if results is combined:
        _tell_refused(combined)
    else:
        say(f"error: {next(iter(combined.refused.values()))}")
    return NO_RESULT


def _follows(model: Model) -> bool:
    """Return whether this process only helps another to solve, which speaks and writes for all of an MPI run."""
    if model.analysis.solver != "mumps":
        return False
    from groundslab.solvers import factorization

    factorization.choose("mumps")
    from groundslab.solvers import mumps

    return not mumps.leads()


def _to_keep(combined: Combined) -> Results | Combined | None:
    """Return what is kept and shown, None if no combination has results; raises what a single one is refused for.

    Results that are not certified are among it, to be looked at; the exit code says that they are no answer.
    """
    if len(combined.combinations) > 1:
        uncertified = any(isinstance(error, NotCertified) for error in combined.refused.values())
        return combined if combined.results or uncertified else None
    for error in combined.refused.values():
        if not isinstance(error, NotCertified):
            raise error
        found: Results = error.results
        return found
    (only,) = combined.results.values()
    return only


def _tell_design(combined: Combined) -> None:
    """Print what fails in the design of certified results: the exit code is that of the analysis."""
    from groundslab.design.tables.design_checks import design_of

    design = design_of(combined)
    if design.open:
        say(f"{design.headline} The analysis itself is certified (exit code 0).")


def _tell_refused(combined: Combined) -> None:
    """Print which combinations have no certified result, and why."""
    for name, error in combined.refused.items():
        say(f'error: combination "{name}": {error}')
    say(f"error: {len(combined.refused)} of {len(combined.combinations)} combinations have no certified result")


def _show(results: Results | Combined, options: argparse.Namespace) -> None:
    """Print the summary to standard output, as text or as JSON."""
    from groundslab.results.results import Combined

    if options.json:
        from groundslab.views.summary import combinations, single

        text = combinations.json_text(results) if isinstance(results, Combined) else single.json_text(results)
        answer(text)
    elif not options.quiet:
        from rich.console import Console

        from groundslab.views.summary.terminal import print_overview, print_summary

        console = Console()
        # Captured, since rich ends the program when a pipe breaks.
        with console.capture() as captured:
            if isinstance(results, Combined):
                print_overview(results, console)
            else:
                print_summary(results, console)
        answer(captured.get().rstrip("\n"))


def _progress(quiet: bool, count: int) -> AbstractContextManager[Shown | None]:
    """Return a context whose value shows each step on a terminal; without a terminal it does nothing."""
    if quiet or not sys.stderr.isatty():
        return nullcontext()
    from groundslab.views.summary.progress import progress

    return progress(count=count)


def _plot(options: argparse.Namespace) -> int:
    """Draw figures of a folder of results into a file."""
    say(plot.draw(options))
    return FINE


def _app(options: argparse.Namespace) -> int:
    """Serve the workbench until it is interrupted."""
    from pathlib import Path

    from groundslab.workbench.server.main import serve

    serve(None if options.case is None else Path(options.case), options.port, not options.no_browser)
    return FINE


def _check(options: argparse.Namespace) -> int:
    """Read a case file, or a study file with its case; wrong ones raise InputError."""
    from pathlib import Path

    from groundslab.case import casefile

    text = casefile.read(options.case)
    tables = casefile.tables(text, options.case)
    if "sampling" in tables:
        from groundslab import study

        answer("\n".join(study.described(Path(options.case))))
        return FINE
    model = casefile.from_table(tables)
    from groundslab.analysis import driver

    driver.check(model)
    plate = model.plate
    lines = [
        f"{options.case}: fine ({plate.sides[0]:g} m x {plate.sides[1]:g} m plate, "
        f"{model.ground.kind} ground, {len(model.loads)} load{'s' if len(model.loads) > 1 else ''})"
    ]
    lines += _columns_and_supports(model) + _cases_and_combinations(model) + _remarks(model)
    answer("\n".join(lines))
    return FINE


def _columns_and_supports(model: Model) -> list[str]:
    """Return the columns and supports of a model in words, a line each."""
    lines = []
    for column in model.columns:
        if column.diameter is not None:
            size = f"diameter {column.diameter:g} m"
        else:
            size = f"{column.width_x:g} m x {column.width_y:g} m"
        lines.append(f"  column {column.name}: {size} at ({column.x:g}, {column.y:g}) m")
    for number, support in enumerate(model.supports, 1):
        places = [(support.x, support.y)] if support.kind == "point" else support.points
        where = " to ".join(f"({x:g}, {y:g})" for x, y in places)
        firm = "rigid" if support.stiffness is None else "elastic"
        lines.append(f"  support {support.name or number}: {support.kind}, {firm}, acts {support.acts}, at {where} m")
    return lines


def _cases_and_combinations(model: Model) -> list[str]:
    """Return the load cases of a model and what is solved of them in words, a line each."""
    if not model.cases:
        return []
    from groundslab.model.combinations import combinations_of
    from groundslab.views.summary.combinations import factors_text

    lines = []
    for case in model.cases:
        count = sum(load.case == case.name for load in model.loads)
        lines.append(f"  case {case.name}: {case.action}, {count} load{'' if count == 1 else 's'}")
    return lines + [
        f"  combination {each.name} ({each.limit_state}): {factors_text(each)}" for each in combinations_of(model)
    ]


def _remarks(model: Model) -> list[str]:
    """Return what is allowed and yet worth knowing, a line each."""
    from groundslab.model.loads.clipping import clipped_loads

    return [f"  remark: {each.words()}" for each in clipped_loads(model.plate, model.loads)]


def _new(options: argparse.Namespace) -> int:
    """Write a case file to start from; an existing file is left alone."""
    from groundslab.case import casefile

    _hand_over(casefile.starter(), options.file)
    if options.file is not None:
        say(f"wrote {options.file}; next: groundslab solve {options.file}")
    return FINE


def _dxf(options: argparse.Namespace) -> int:
    """Make a case file from a drawing; an existing file is left alone."""
    from pathlib import Path

    from groundslab.case import dxf

    drawing = dxf.read(options.drawing, _layers(options.layers), options.unit)
    _hand_over(dxf.to_case(drawing, Path(options.drawing).stem), options.out)
    say(dxf.report_text(drawing).rstrip("\n"))
    if options.out is not None:
        say(f"\nwrote {options.out}; next: fill in what it asks for, then groundslab check {options.out}")
    return FINE


def _layers(pairs: Sequence[str]) -> Layers:
    """Return the layers that WHAT=NAME name, the others under their usual names."""
    from dataclasses import fields

    from groundslab.case.dxf.layers import Layers
    from groundslab.schema.wording import describe, listed, suggestion

    known = [each.name for each in fields(Layers)]
    names: dict[str, str] = {}
    issues = []
    for pair in pairs:
        what, sign, name = pair.partition("=")
        if not sign or what not in known:
            expected = f"WHAT=NAME, WHAT being {listed(known)}"
            issues.append(Issue("--layers", describe(pair), expected, suggestion(what, known)))
        elif what in names:
            issues.append(Issue("--layers", f"{what} twice", "one layer for it"))
        names[what] = name
    if issues:
        raise InputError(issues)
    return Layers(**names)


def _hand_over(text: str, file: str | None) -> None:
    """Write a text to a new file, or print it if there is none; an existing file is left alone."""
    if file is None:
        answer(text.rstrip("\n"))
        return
    from pathlib import Path

    from groundslab.storage import atomic

    try:
        atomic.write(Path(file), text.encode(), new=True)
    except FileExistsError:
        raise InputError([Issue(file, "a file that exists", "a name that is free", "choose another name")]) from None


def _report(options: argparse.Namespace) -> int:
    """Make a report of a folder of results."""
    from pathlib import Path

    from groundslab.views import report
    from groundslab.views.files import results_folder

    folder = Path(options.results)
    target = Path(options.out) if options.out is not None else report.default_path(folder)
    if Path(os.path.realpath(folder)) in Path(os.path.realpath(target)).parents:
        found, hint = f"{target}, which is in the folder of the results", "groundslab solve would not replace it then"
        raise InputError([Issue("--out", found, "another folder", hint)])
    report.check(target)
    combined = results_folder.load(folder)
    report.write_report(combined, target, text=report.text_of(folder, combined.model))
    say(f"wrote {target}")
    if combined.refused:
        say(f"note: {len(combined.refused)} of {len(combined.combinations)} combinations have no certified result")
    return FINE


def _verify(options: argparse.Namespace) -> int:
    """Run the verification cases, or list them."""
    from groundslab.verification import runner

    known = list(runner.names())
    if options.list:
        answer("\n".join(known))
        return FINE
    expected = "a case that `groundslab verify --list` names"
    issues = [Issue("verify", f'"{name}"', expected) for name in options.names if name not in known]
    if issues:
        raise InputError(issues)
    return FINE if runner.run(options.names or known, _console()) else NO_RESULT


def _console() -> Console:
    """Return rich's console on standard output."""
    from rich.console import Console

    return Console()


def _schema(_: argparse.Namespace) -> int:
    """Print the JSON schema of a case file."""
    import json

    from groundslab.model.model import json_schema

    answer(json.dumps(json_schema(), indent=2))
    return FINE


def _not_converged(error: NotConverged) -> None:
    """Print what did not converge, and how."""
    from groundslab.results.record import Step

    steps = [step for step in error.history if isinstance(step, Step)]
    say(f"error: {error.what} did not converge in {len(error.history)} steps; the last of them:")
    if steps and len(steps) == len(error.history):
        from rich.console import Console

        from groundslab.views.summary.terminal import print_history

        print_history(steps[-20:], Console(stderr=True))
    else:
        for entry in error.history[-20:]:
            pairs = entry.items() if isinstance(entry, Mapping) else None
            say("  " + (", ".join(f"{name} {value}" for name, value in pairs) if pairs else str(entry)))
