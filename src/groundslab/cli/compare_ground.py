"""The command compare-ground: what it understands, and what it does."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.cli.console import EXIT_DESIGN_FAILS, EXIT_OK, print_stderr, print_stdout

if TYPE_CHECKING:
    import argparse

    from groundslab.analysis.ground_comparison.comparison import GroundComparison


def describe(compare: argparse.ArgumentParser) -> None:
    """Add what the command compare-ground understands."""
    compare.epilog = (
        "The ground of the case needs layers given by E, nu and thickness. Bonded, they form a continuum. It is "
        "compared with constrained moduli and Vlasov's ground of the same layers, and with the Pasternak ground and "
        "the springs whose constants best fit the continuum under this slab. If nothing balances the loads of a "
        "combination, the foundation fails, and the exit code is 3."
    )
    compare.add_argument("case", help="case file (TOML)")
    compare.add_argument(
        "--combination",
        metavar="NAME",
        help="combination to compare (default: the one with the largest settlement on the continuum)",
    )
    compare.add_argument(
        "--out",
        metavar="DIR",
        help="folder for JSON, CSV and a figure: a new one, or the results folder of this case, whose report then has "
        "the comparison as a chapter (default: none)",
    )
    compare.add_argument("--json", action="store_true", help="print only the comparison, as JSON")


def run(options: argparse.Namespace) -> int:
    """Compare the grounds of a case, print and keep the comparison."""
    from groundslab.analysis.ground_comparison.comparison import compare_grounds
    from groundslab.case import casefile
    from groundslab.views.ground_comparison import files

    model = casefile.load(Path(options.case))
    if options.out is not None:
        files.check(options.out, model)
    shows = sys.stderr.isatty() and not options.json
    comparison = compare_grounds(model, options.combination, _print_ground if shows else None)
    _print(comparison, options.json)
    if options.out is not None:
        files.save_comparison(comparison, options.out)
        if not options.json:
            print_stderr(f"comparison in {options.out}")
    return EXIT_DESIGN_FAILS if comparison.without_equilibrium else EXIT_OK


def _print_ground(kind: str) -> None:
    print_stderr(f"{kind} ...")


def _print(comparison: GroundComparison, as_json: bool) -> None:
    """Print a comparison to standard output, as text or as JSON."""
    if as_json:
        from groundslab.views.ground_comparison.files import json_text

        print_stdout(json_text(comparison))
        return
    from rich.console import Console

    from groundslab.views.ground_comparison.terminal import print_comparison

    console = Console()
    # captured, since rich ends the program when a pipe breaks
    with console.capture() as captured:
        print_comparison(comparison, console)
    print_stdout(captured.get().rstrip("\n"))
