"""The commands compare-ground and compare-designs: what they understand, and what they do."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.cli.console import EXIT_DESIGN_FAILS, EXIT_OK, print_stderr, print_stdout
from groundslab.errors import InputError, Issue
from groundslab.schema.wording import one_of, quote, suggestion

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable

    from rich.console import Console

    from groundslab.analysis.ground_comparison.comparison import GroundComparison


def describe_grounds(compare: argparse.ArgumentParser) -> None:
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


def compare_grounds(options: argparse.Namespace) -> int:
    """Compare the grounds of a case, print and keep the comparison."""
    from groundslab.analysis.ground_comparison import comparison as analysis
    from groundslab.case import casefile
    from groundslab.views.ground_comparison import files

    model = casefile.load(Path(options.case))
    if options.out is not None:
        files.check(options.out, model)
    shows = sys.stderr.isatty() and not options.json
    comparison = analysis.compare_grounds(model, options.combination, _print_ground if shows else None)
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
    from groundslab.views.ground_comparison.terminal import print_comparison

    _print_captured(lambda console: print_comparison(comparison, console))


def _print_captured(show: Callable[[Console], None]) -> None:
    """Print what is shown on a console; captured, since rich ends the program when a pipe breaks."""
    from rich.console import Console

    console = Console()
    with console.capture() as captured:
        show(console)
    print_stdout(captured.get().rstrip("\n"), styled=True)


def describe_designs(compare: argparse.ArgumentParser) -> None:
    """Add what the command compare-designs understands."""
    compare.epilog = (
        "Tried are the slab as it is drawn; with bars proposed for it; about a tenth thinner and thicker; and with "
        "drop panels at columns that need links against punching. If the case has [reinforcement], all but the first "
        "have bars proposed for them, and each has the links that it needs. They are solved to the accuracy of a draft "
        "unless the case has elements of a given size."
    )
    compare.add_argument("case", help="case file (TOML)")
    compare.add_argument("--take", metavar="NAME", help="write the case with this alternative to the file of -o")
    compare.add_argument("-o", "--out", metavar="FILE", help="case file to write, a new one")
    compare.add_argument("--json", action="store_true", help="print only the comparison, as JSON in SI units")


def compare_designs(options: argparse.Namespace) -> int:
    """Compare alternatives to a design, print them, and write the case with one of them."""
    from groundslab.cli.case import write_or_print
    from groundslab.study.alternatives import comparison as alternatives

    if (options.take is None) != (options.out is None):
        lone_option = "--take without -o" if options.out is None else "-o without --take"
        raise InputError([Issue("the options", lone_option, "both, or neither")])
    shows = sys.stderr.isatty() and not options.json
    comparison = alternatives.compare_designs(options.case, _print_alternative if shows else None)
    if options.json:
        import json

        from groundslab.study.alternatives.rows import to_json

        print_stdout(json.dumps(to_json(comparison), indent=2))
    else:
        from groundslab.study.alternatives.terminal import print_designs

        _print_captured(lambda console: print_designs(comparison, console))
    if options.take is not None:
        names = [alternative.name for alternative in comparison.alternatives]
        if options.take not in names:
            raise InputError([Issue("--take", quote(options.take), one_of(names), suggestion(options.take, names))])
        write_or_print(comparison[options.take].text, options.out)
        print_stderr(f"wrote {options.out}; next: groundslab solve {options.out}")
    return EXIT_OK


def _print_alternative(name: str, left: int) -> None:
    print_stderr(f"{name} ... ({left} left)")
