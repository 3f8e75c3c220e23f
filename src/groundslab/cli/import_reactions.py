"""The command import-reactions: reactions of another program as loads of a case."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.cli.case import write_or_print
from groundslab.cli.console import EXIT_OK, print_stderr, print_stdout
from groundslab.errors import InputError, Issue

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator, Sequence

    from groundslab.exchange.reactions import ImportedReactions

#: Changes of one kind that are listed one by one.
LISTED = 50


def describe(command: argparse.ArgumentParser) -> None:
    """Add what the command import-reactions understands."""
    command.epilog = (
        "What changes is printed; nothing is written without -o or --yes. Loads of an earlier import are replaced, all "
        "others stay, and so do comments. How the table is read is kept in [reactions] of the case, so that the next "
        "import needs no more than the file."
    )
    command.add_argument("table", metavar="TABLE", help="reactions by support and load case (CSV or XLSX)")
    command.add_argument("case", metavar="CASE", help="case file (TOML)")
    command.add_argument("-o", "--out", metavar="FILE", help="case file to write, a new one")
    command.add_argument("--yes", action="store_true", help="take the loads: replace CASE itself")
    _describe_matching(command)
    _describe_signs(command)
    _describe_table(command)


def _describe_matching(command: argparse.ArgumentParser) -> None:
    """Add what says which load cases, columns and walls are meant."""
    meaning = "load cases that are new: permanent, variable, accidental, seismic, or the category of a variable one"
    _add_several(command, "--new-case", "NAME=ACTION", meaning)
    _add_several(command, "--same-case", "NAME=HERE", "load cases that have another name here")
    _add_several(command, "--without-case", "NAME", "load cases that are left out")
    _add_several(command, "--support", "NAME=HERE", "supports that stand for a column or wall of another name")
    _add_several(command, "--without-support", "NAME", "supports that are left out")
    command.add_argument(
        "--footprint", nargs=2, metavar="WIDTH", help="make columns so wide along x and y of the others"
    )
    command.add_argument("--tolerance", metavar="LENGTH", help='distance at which places are the same, such as "0.1 m"')
    command.add_argument("--move-columns", action="store_true", help="move columns to where the table has them")
    meaning = "share by which values must change to be listed one by one (default: 0.01)"
    command.add_argument("--threshold", type=float, default=0.01, metavar="SHARE", help=meaning)


def _describe_signs(command: argparse.ArgumentParser) -> None:
    """Add what says which way forces and moments act, and where places are."""
    meaning = "what a positive vertical force does to the slab: presses (default) or lifts"
    command.add_argument("--positive", metavar="WORD", help=meaning)
    meaning = 'what moments mean: "about axes" (default), "about axes, left-handed" or "as here"'
    command.add_argument("--moments", metavar="WORDS", help=meaning)
    meaning = 'what F_x and F_y act on, to have H_x and H_y of load cases: "on the slab" or "on the structure"'
    command.add_argument("--horizontal", metavar="WORDS", help=meaning)
    command.add_argument("--mirrored", action="store_true", default=None, help="y of the table points the other way")
    command.add_argument("--origin", nargs=2, metavar="LENGTH", help="x and y of the table's origin in the case")


def _describe_table(command: argparse.ArgumentParser) -> None:
    """Add what a table may leave open."""
    command.add_argument("--sheet", metavar="NAME", help="sheet of a workbook")
    command.add_argument("--force", metavar="UNIT", help="unit of forces, where the table states none")
    command.add_argument("--moment", metavar="UNIT", help="unit of moments, where the table states none")
    command.add_argument("--length", metavar="UNIT", help="unit of coordinates, where the table states none")
    command.add_argument("--decimals", metavar="WORD", help="what stands before decimals: point or comma")
    command.add_argument("--only-case", metavar="NAME", help="load case of a table that names none")
    meaning = "headings of columns with unusual names; WHAT is support, case, x, y, F_x, F_y, F_z, M_x or M_y"
    _add_several(command, "--heading", "WHAT=NAME", meaning)


def _add_several(command: argparse.ArgumentParser, option: str, metavar: str, meaning: str) -> None:
    """Add an option that takes several values, also one after the other."""
    command.add_argument(option, nargs="+", action="extend", default=[], metavar=metavar, help=meaning)


def run(options: argparse.Namespace) -> int:
    """Print what a table of reactions changes in a case, and write the case if it was asked for."""
    from groundslab.exchange.reactions import read_reactions

    imported = read_reactions(
        options.table,
        options.case,
        new_cases=_pairs("--new-case", options.new_case),
        cases=_pairs("--same-case", options.same_case),
        supports=_pairs("--support", options.support),
        move_columns=options.move_columns,
        threshold=options.threshold,
        **_reading(options),
    )
    print_stdout("\n".join(_words(imported)))
    if options.out is not None:
        write_or_print(imported.text, options.out)
        print_stderr(f"wrote {options.out}; next: groundslab check {options.out}")
    elif options.yes:
        from groundslab.storage import atomic

        atomic.write(Path(options.case), imported.text.encode())
        print_stderr(f"wrote {options.case}; next: groundslab check {options.case}")
    else:
        print_stderr("nothing was written: --yes replaces the case, -o FILE writes another one")
    return EXIT_OK


def _reading(options: argparse.Namespace) -> dict[str, Any]:
    """Return the keys of [reactions] that were given."""
    signs = ("positive", "moments", "horizontal", "mirrored", "origin")
    same = ("tolerance", "sheet", "force", "moment", "length", "decimals", "footprint")
    keys = {name: getattr(options, name) for name in (*signs, *same)}
    keys["case"] = options.only_case
    keys["without_cases"] = options.without_case or None
    keys["without_supports"] = options.without_support or None
    keys["headings"] = _pairs("--heading", options.heading) or None
    return {name: value for name, value in keys.items() if value is not None}


def _pairs(option: str, texts: Sequence[str]) -> dict[str, str]:
    """Return the names on the left of "=" with what is on the right."""
    wrong = [text for text in texts if "=" not in text]
    if wrong:
        raise InputError([Issue(option, f'"{text}"', "two names with = between them") for text in wrong])
    pairs = (text.rpartition("=") for text in texts)
    return {name.strip(): value.strip() for name, _, value in pairs}


def _words(imported: ImportedReactions) -> Iterator[str]:
    """Yield what changes, sums by case, and remarks."""
    listed = [change for change in imported.changes if change.kind != "less"]
    for kind in dict.fromkeys(change.kind for change in listed):
        lines = [f"  {change}" for change in listed if change.kind == kind]
        yield from lines[:LISTED]
        if len(lines) > LISTED:
            yield f"  {kind}: {len(lines) - LISTED} more"
    less = len(imported.changes) - len(listed)
    if less:
        yield f"  {less} change{'s' * (less > 1)} by less"
    if not imported.changes:
        yield "  no changes"
    yield "sums of imported loads, moments about x = y = 0:"
    yield from (f"  {line}" for line in imported.sums)
    yield from (f"note: {remark}" for remark in imported.remarks)
