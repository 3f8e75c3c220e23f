"""The command import-ifc: what it understands, and what it does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from groundslab.cli.case import describe_place, write_or_print
from groundslab.cli.console import EXIT_OK, print_stderr

if TYPE_CHECKING:
    import argparse


def describe(parser: argparse.ArgumentParser) -> None:
    """Add what the command import-ifc understands."""
    parser.epilog = (
        "Geometry alone: outline, openings and thickness of one slab, and the columns and walls that stand on it. The "
        "report on standard error says what was taken, in which way, and what was left out."
    )
    parser.add_argument("file", metavar="FILE", help="building model (IFC 2x3 or IFC 4, STEP format)")
    parser.add_argument(
        "--slab", default="", metavar="NAME", help="name or GlobalId of the slab (default: the only one of the file)"
    )
    describe_place(parser, "building")
    parser.add_argument("-o", "--out", metavar="CASE", help="case file to write (default: print the text)")


def run(options: argparse.Namespace) -> int:
    """Make a case file from a slab of a building model; an existing file is left alone."""
    from groundslab.optional import import_optional
    from groundslab.workbench.checking.buildings import BuildingReader

    import_optional("ifcopenshell", "which reads building models", "ifc")
    case = BuildingReader().convert(options.file, options.slab, options.origin, options.align)
    write_or_print(case.text, options.out)
    print_stderr(case.report_text().rstrip("\n"))
    if options.out is not None:
        print_stderr(f"\nwrote {options.out}; next: fill in the missing values, then groundslab check {options.out}")
    return EXIT_OK
