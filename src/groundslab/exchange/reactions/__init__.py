"""Reactions of other programs as loads: read from a table, matched to columns and walls, compared, and taken."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path
from typing import Any

from groundslab.case import casefile
from groundslab.case.numbers import format_number
from groundslab.errors import InputError, Issue
from groundslab.exchange.reactions.changes import (
    THRESHOLD,
    CaseSum,
    ReactionChange,
    find_changes,
    find_pushes,
    sum_cases,
)
from groundslab.exchange.reactions.forces import Transfer, make_loads, middles, resultants, signs_in_words
from groundslab.exchange.reactions.headings import unit_of
from groundslab.exchange.reactions.matching import (
    Moved,
    frame_of,
    match_cases,
    match_supports,
    remarks_on_cases,
    repeated,
    sideways,
    with_resultants,
    words_of_sideways,
)
from groundslab.exchange.reactions.table import read_table
from groundslab.exchange.reactions.text import LoadsText
from groundslab.model.model import Model
from groundslab.model.reactions import Reactions
from groundslab.schema.fields import MOST_ISSUES
from groundslab.schema.wording import describe, listed

#: Keys of [reactions] that are units.
UNITS = ("force", "moment", "length")


@dataclass(frozen=True, slots=True)
class ImportedReactions:
    """A case with the loads of a table of reactions, and what that changes.

    Attributes
    ----------
    model : Model
        The case with these loads, and with `reactions` that say how they were read.
    text : str
        The case file, edited in place: comments and everything else are kept.
    changes : tuple of ReactionChange
        What is new, gone, moved or changed; empty if the table has what the case has.
    sums : tuple of CaseSum
        Sums of the imported loads by case, before and after.
    remarks : tuple of str
        What was left out, and what the signs mean.
    """

    model: Model
    text: str
    changes: tuple[ReactionChange, ...]
    sums: tuple[CaseSum, ...]
    remarks: tuple[str, ...]


def read_reactions(
    table: str | Path,
    case: str | Path | Model,
    *,
    new_cases: Mapping[str, str] | None = None,
    cases: Mapping[str, str] | None = None,
    supports: Mapping[str, str] | None = None,
    move_columns: bool = False,
    threshold: float = THRESHOLD,
    **reading: Any,
) -> ImportedReactions:
    """Read column and wall reactions of another program as loads of a case; nothing is written.

    Loads that an earlier import made are replaced, all others are left alone. How the table is read is kept in the
    case, so that the next import needs no more than the file.

    Parameters
    ----------
    table : str or pathlib.Path
        CSV file or workbook (XLSX), one row for each support and load case, or one column for each case.
    case : str, pathlib.Path or Model
        The case, best its file, whose comments are then kept.
    new_cases : mapping of str to str, optional
        Action of each load case that is new, such as ``"permanent"``, or the category of a variable one.
    cases : mapping of str to str, optional
        Names of load cases here by their names in the table, where they differ.
    supports : mapping of str to str, optional
        Columns and walls by the names of supports, where neither name nor place tells.
    move_columns : bool, optional
        Whether columns that the table has elsewhere are moved there.
    threshold : float, optional
        Share by which a force or moment must change to be called changed.
    **reading
        Keys of ``[reactions]``, such as ``positive="lifts"``; what is not given is as in the case.

    Returns
    -------
    ImportedReactions
        The case with these loads, what changes, and sums by case.

    Raises
    ------
    InputError
        If the table cannot be read, or a support or load case stands for nothing; it lists all issues.
    """
    text = casefile.to_toml(case) if isinstance(case, Model) else casefile.read(case)
    folder = None if isinstance(case, Model) else Path(case).parent
    choices = Choices(new_cases or {}, cases or {}, supports or {}, move_columns, reading)
    return import_into(text, folder, Path(table), choices, threshold)


@dataclass(frozen=True, slots=True)
class Choices:
    """What is said of an import: new load cases, names that differ, columns that move, keys of [reactions]."""

    new_cases: Mapping[str, str]
    cases: Mapping[str, str]
    supports: Mapping[str, str]
    move_columns: bool
    reading: Mapping[str, Any]


def import_into(
    text: str, folder: Path | None, table: Path, choices: Choices, threshold: float = THRESHOLD
) -> ImportedReactions:
    """Return the case of a text, whose folder may be known, with the loads of a table; raises InputError."""
    # line ends of Windows come back afterwards
    windows = "\r\n" in text and text.count("\r\n") == text.count("\n")
    text = text.replace("\r\n", "\n") if windows else text
    data = casefile.tables(text, "the case")
    before = _model_before(data, folder)
    document = LoadsText(text, data)
    remarks, moved = _take(document, table, before, _reading(before, table.name, choices), choices)
    after = casefile.from_table(document.data, folder)
    old, new = resultants(before), resultants(after)
    return ImportedReactions(
        after,
        document.text.replace("\n", "\r\n") if windows else document.text,
        (*find_changes(old, new, moved, threshold), *find_pushes(before, after, threshold)),
        sum_cases(old, new, middles(before), middles(after)),
        tuple(remarks),
    )


def _model_before(data: dict[str, Any], folder: Path | None) -> Model:
    """Return the case as it is, one that has no loads yet with one that counts for nothing here."""
    if data.get("loads"):
        return casefile.from_table(data, folder)
    cases = data.get("cases") or [{}]
    named = {"case": cases[0]["name"]} if isinstance(cases[0], dict) and "name" in cases[0] else {}
    return casefile.from_table({**data, "loads": [{"kind": "uniform", "q": "1 kPa", **named}]}, folder)


def _reading(model: Model, file: str, choices: Choices) -> Reactions:
    """Return how a table is to be read: as the last one, but for what is given now."""
    last, reading = model.reactions or Reactions(), choices.reading
    unknown = [key for key in reading if key not in Reactions.model_fields]
    if unknown:
        keys = ", ".join(Reactions.model_fields)
        raise InputError([Issue("reactions", f"{describe(key)}", f"one of {keys}") for key in unknown])
    pairs = {pair.table: pair.case for pair in last.cases} | dict(choices.cases)
    named = {pair.table: pair.on for pair in last.supports} | dict(choices.supports)
    reading = {**reading} | {
        key: unit_of(reading[key]) or reading[key] for key in UNITS if isinstance(reading.get(key), str)
    }
    headings = reading.get("headings", {})
    if isinstance(headings, Mapping):
        reading = {**reading, "headings": last.headings.replace(**headings)}
    changes = {
        **reading,
        "file": file,
        "cases": tuple({"table": name, "case": case} for name, case in pairs.items()),
        "supports": tuple({"table": name, "on": base} for name, base in named.items()),
    }
    return last.replace(**changes)


def _take(
    document: LoadsText, path: Path, model: Model, reading: Reactions, choices: Choices
) -> tuple[list[str], tuple[Moved, ...]]:
    """Put the loads of a table into a case; return remarks, and what the table has elsewhere."""
    table = read_table(path, reading)
    cases = match_cases(table, model, reading, choices.new_cases)
    left = {*cases.left, *reading.without_cases}
    taken = [row for row in table.reactions if row.case not in left and row.support not in reading.without_supports]
    matched = match_supports(taken, table, model, reading)
    issues = [*cases.issues, *matched.issues, *repeated(taken, table)]
    if table.per and not issues:
        taken = with_resultants(taken, matched, table, model, issues)
    if not taken and not issues:
        issues.append(Issue(table.name, "no load case that is not left out", "at least one"))
    if issues:
        raise InputError(issues[:MOST_ISSUES])
    transfer = Transfer(taken, matched, cases.names, table, frame_of(table, reading), reading)
    loads, remarks = make_loads(transfer, model)
    if cases.new:
        document.set(("cases",), [*document.data.get("cases", []), *cases.new])
    if matched.new_columns:
        document.set(("columns",), [*document.data.get("columns", []), *matched.new_columns])
    if choices.move_columns:
        _move(document, matched.moved)
    sums = sideways(taken, cases.names, reading)
    if reading.horizontal != "left out":
        _push(document, sums, table.force)
    document.set_loads(loads)
    document.set_reactions(reading, model.reactions)
    said = [f"signs: {signs_in_words(reading)}", *table.remarks, *remarks]
    said += remarks_on_cases(taken, cases, table, model)
    combined = [case for case in cases.left if case not in table.unsigned]
    if combined:
        said.append(f"combinations are left out, as only load cases are loads: {listed(combined, 'and')}")
    if unsigned := [f"{case} ({table.unsigned[case]})" for case in cases.left if case in table.unsigned]:
        said.append(f"cases of largest values without signs are left out: {listed(unsigned, 'and')}")
    left_out = words_of_sideways(sums, table.force) if reading.horizontal == "left out" else []
    return [*said, *left_out], matched.moved


def _push(document: LoadsText, sums: Mapping[str, Sequence[Decimal]], unit: str) -> None:
    """Set the horizontal forces of load cases; of 0 only where they were not."""
    for position, case in enumerate(document.data.get("cases", [])):
        for key, force in zip(("H_x", "H_y"), sums.get(case["name"], ()), strict=False):
            if force or key in case:
                document.set(("cases", position, key), f"{format_number(force)} {unit}")


def _move(document: LoadsText, moved: tuple[Moved, ...]) -> None:
    """Move columns to where a table has them."""
    positions = {column["name"]: n for n, column in enumerate(document.data.get("columns", []))}
    for move in moved:
        if move.name in positions:
            for axis, text in zip(("x", "y"), move.texts, strict=True):
                document.set(("columns", positions[move.name], axis), text)
