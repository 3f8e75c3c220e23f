"""The commands study and evaluate: what they understand, and what they do."""

from __future__ import annotations

import argparse

from groundslab.cli.console import EXIT_INTERRUPTED, EXIT_NO_RESULT, EXIT_OK, format_issues, print_stderr, print_stdout
from groundslab.errors import CertificateWithdrawn, GroundslabError, InputError


def describe(study: argparse.ArgumentParser) -> None:
    """Add what the command study understands."""
    study.epilog = (
        "Each row is saved as soon as its variant is done. An interrupted study continues with --resume. The exit "
        "code is 1 if variants end up without a row; a variant whose row says why it failed has one."
    )
    study.add_argument("study", help="study file (TOML)")
    study.add_argument(
        "--out", metavar="DIR", help="folder for the rows (default: <study>-study next to the study file)"
    )
    study.add_argument("--resume", action="store_true", help="resume the study in the folder")
    place = study.add_mutually_exclusive_group()
    place.add_argument(
        "--workers",
        type=_count,
        metavar="N",
        help="processes on this machine (default: one for each core; 0: only this one)",
    )
    place.add_argument("--scheduler", metavar="ADDRESS", help="Dask scheduler to use, such as tls://127.0.0.1:8786")
    study.add_argument(
        "--dashboard", action="store_true", help="have Dask show the processes of this machine in the browser"
    )
    study.add_argument("--quiet", action="store_true", help="print no progress")


def describe_evaluation(evaluate: argparse.ArgumentParser) -> None:
    """Add what the command evaluate understands."""
    evaluate.epilog = (
        "Writes report.html and the tables as CSV into the folder evaluation within the study's, as groundslab study "
        "does at its end. A running study can be evaluated as far as it has got."
    )
    evaluate.add_argument("folder", help="folder of a study")
    evaluate.add_argument(
        "--design-points",
        nargs="*",
        metavar="NAME",
        help="find the design point of these limit states, or of all, which solves the case some more times",
    )
    evaluate.add_argument(
        "--level", type=_level, default=0.95, metavar="P", help="confidence of the intervals (default: 0.95)"
    )


def run(options: argparse.Namespace) -> int:
    """Run a study, and say what became of its variants; interrupted or not, rows that are there are kept."""
    from groundslab.study import evaluate, resume_hint, study_folder, summarize
    from groundslab.study import run as run_study

    folder = study_folder(options.study, options.out)
    again = f"groundslab study {options.study}" + (f" --out {options.out}" if options.out is not None else "")
    _end_on_sigterm()
    try:
        finished = run_study(
            options.study,
            out=folder,
            workers=options.workers,
            scheduler=options.scheduler,
            dashboard=options.dashboard,
            resume=options.resume,
            quiet=options.quiet,
        )
    except (InputError, CertificateWithdrawn):
        raise
    except (KeyboardInterrupt, GroundslabError) as error:
        print_stderr("interrupted" if isinstance(error, KeyboardInterrupt) else f"error: {error}")
        print_stderr(resume_hint(folder, again))
        return EXIT_INTERRUPTED if isinstance(error, KeyboardInterrupt) else EXIT_NO_RESULT
    print_stdout("\n".join(summarize(finished)))
    if len(finished):
        try:
            print_stdout(f"evaluation: {evaluate(finished)[0]}")
        except InputError as error:
            # the rows are there, only a library that evaluates them is not
            print_stderr(format_issues(error))
    if len(finished) < finished.count:
        print_stderr(resume_hint(folder, again))
        return EXIT_NO_RESULT
    return EXIT_OK


def evaluate(options: argparse.Namespace) -> int:
    """Make page and tables of a study; find design points of its limit states if asked to."""
    from groundslab import study

    opened = study.open_study(options.folder)
    names = options.design_points
    if names is not None and not names:
        names = [limit.name for limit in opened.setup.limits] or [""]
    points = [study.reliability(opened, name) for name in names or ()]
    files = study.evaluate(opened, points, options.level)
    print_stdout("\n\n".join(map(str, points)) + "\n" * 2 * bool(points) + f"evaluation: {files[0]}")
    return EXIT_OK


def _count(text: str) -> int:
    """Return a number of processes that is given as an argument."""
    number = int(text)
    if number < 0:
        raise ValueError
    return number


def _level(text: str) -> float:
    """Return a confidence; argparse says what is wrong with another one."""
    level = float(text)
    if not 0 < level < 1:
        raise argparse.ArgumentTypeError("expected a number between 0 and 1, such as 0.95")
    return level


def _end_on_sigterm() -> None:
    """End as on Ctrl-C when a batch system asks for it."""
    import signal
    import threading

    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGTERM, signal.default_int_handler)
