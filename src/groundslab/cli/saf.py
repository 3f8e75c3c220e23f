"""The commands import-saf and export-saf: what they understand, and what they do."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.cli.case import write_or_print
from groundslab.cli.console import EXIT_OK, print_stderr

if TYPE_CHECKING:
    import argparse


def describe_import(parser: argparse.ArgumentParser) -> None:
    """Add what the command import-saf understands."""
    parser.epilog = "The report on standard error says what was taken, in which way, and what was left out."
    parser.add_argument("file", metavar="FILE", help="file in the Structural Analysis Format (XLSX)")
    parser.add_argument(
        "--slab",
        default="",
        metavar="NAME",
        help="name of the slab (default: the only one on ground, or the only one at the lowest height)",
    )
    parser.add_argument("--out", metavar="CASE", help="case file to write (default: print the text)")


def import_file(options: argparse.Namespace) -> int:
    """Make a case file from a slab of a file; an existing file is left alone."""
    from groundslab.exchange.saf import read_saf

    read = read_saf(options.file, options.slab)
    write_or_print(read.text, options.out)
    print_stderr(read.report_text().rstrip("\n"))
    if options.out is not None:
        print_stderr(f"\nwrote {options.out}; next: groundslab check {options.out}")
    return EXIT_OK


def describe_export(parser: argparse.ArgumentParser) -> None:
    """Add what the command export-saf understands."""
    parser.epilog = (
        "Results give section forces along the slab's edges, and soil of Vlasov's kind the k0 and k1 that they found. "
        "What the format has no place for is listed on standard error. An existing file is left alone."
    )
    parser.add_argument("case", metavar="CASE", help="case file (TOML), or results folder written by groundslab solve")
    parser.add_argument("--out", metavar="FILE", help="file to write (default: <CASE>-saf.xlsx next to the case)")


def export_file(options: argparse.Namespace) -> int:
    """Write a case, or the case of results, to a new file."""
    from groundslab.case import casefile
    from groundslab.optional import import_optional
    from groundslab.views.files import results_folder
    from groundslab.views.files.saf import write_saf

    import_optional("openpyxl", "which reads and writes workbooks", "exchange")
    source = Path(options.case)
    target = Path(options.out) if options.out is not None else source.with_name(f"{source.stem}-saf.xlsx")
    left = write_saf(results_folder.load_results(source) if source.is_dir() else casefile.load(source), target)
    for line in left:
        print_stderr(f"  {line}")
    print_stderr(f"wrote {target}")
    return EXIT_OK
