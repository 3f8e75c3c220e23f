"""Headings of tables of reactions: which column is which, and in which unit."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import Literal

from groundslab import units
from groundslab.errors import InputError, Issue
from groundslab.exchange.reactions.cells import Cell, Grid
from groundslab.model.reactions import ReactionHeadings
from groundslab.schema.wording import describe, listed, quote

Role = Literal["support", "case", "support and case", "type", "step", "x", "y", "F_x", "F_y", "F_z", "M_x", "M_y"]

#: What programs call their columns, in small letters without spaces and signs; of two of a role the first one counts.
USUAL: Mapping[Role, tuple[str, ...]] = {
    "support": (
        "support", "supportname", "column", "wall", "pier", "uniquename", "jointlabel", "label", "joint", "jointname",
        "node", "nodeno", "nodename", "no", "nr", "point", "pointname", "element", "name", "col", "stütze", "wand",
        "auflager", "lager", "knoten", "knotennr",
    ),
    "case": (
        "case", "loadcase", "outputcase", "casename", "casecombo", "lc", "lcco", "loading", "load", "loadcasename",
        "lastfall", "lf", "lflk",
    ),
    "support and case": ("nodecase", "supportcase", "jointcase"),
    "type": ("casetype", "loadtype", "designtype", "actiontype"),
    "step": ("steptype",),
    "x": ("x", "globalx", "xcoordinate", "xcoord", "coordx", "coordinatex", "xm"),
    "y": ("y", "globaly", "ycoordinate", "ycoord", "coordy", "coordinatey", "ym"),
    "F_x": ("fx", "rx", "px", "f1", "globalfx"),
    "F_y": ("fy", "ry", "py", "f2", "globalfy"),
    "F_z": ("fz", "rz", "pz", "f3", "globalfz", "p", "n", "force", "vertical", "verticalforce"),
    "M_x": ("mx", "m1", "globalmx"),
    "M_y": ("my", "m2", "globalmy"),
}  # fmt: skip
DIMENSIONS: Mapping[Role, str] = {
    "x": "length", "y": "length", "F_x": "force", "F_y": "force", "F_z": "force", "M_x": "moment", "M_y": "moment",
}  # fmt: skip
#: Values that a column may have once for each load case.
BY_CASE: tuple[Role, ...] = ("F_z", "M_x", "M_y")
#: Values that are of no use here, so that their columns are not taken for load cases.
_OTHERS = {
    "fx",
    "rx",
    "px",
    "fy",
    "ry",
    "py",
    "mz",
    "m3",
    "z",
    "globalz",
    "story",
    "storey",
    "level",
    "comment",
    "remark",
}
#: Rows among which headings are looked for.
ABOVE = 60
#: Units that other programs write in words that would mean something else here, in small letters; theirs have any.
_UNITS = {
    "n": "N", "kn": "kN", "kip": "kip", "kips": "kip", "k": "kip", "lb": "lbf", "lbs": "lbf", "lbf": "lbf", "t": "tf",
    "tf": "tf", "tonf": "tf", "kg": "kgf", "kgf": "kgf", "m": "m", "cm": "cm", "mm": "mm", "in": "in", "inch": "in",
    "ft": "ft", "knm": "kNm", "kipft": "kip ft", "kipin": "kip in", "lbft": "lbf ft", "lbin": "lbf in", "tm": "tf m",
    "tfm": "tf m", "tonfm": "tf m", "kgm": "kgf m", "kgfm": "kgf m", "kgfcm": "kgf cm",
}  # fmt: skip
#: What stands for units in a row of them below columns that have none.
_NO_UNITS = ("text", "unitless", "none", "number", "string")
#: What stands between the units of a column that has two.
BOTH = "and below it"
_BRACKETS = re.compile(r"[\[({]([^\[\](){}]{1,40})[\])}]")


@dataclass(frozen=True, slots=True)
class Heading:
    """What a column holds: its role, the unit as we write it if one is stated, and the load case if it is of one."""

    column: int
    role: Role
    unit: str = ""
    case: str = ""


@dataclass(frozen=True, slots=True)
class Headings:
    """The headings of a table, and the row in which its values begin (from 0)."""

    columns: tuple[Heading, ...]
    first: int

    def of(self, *roles: Role) -> tuple[Heading, ...]:
        """Return the columns of some roles."""
        return tuple(heading for heading in self.columns if heading.role in roles)

    def one(self, role: Role) -> Heading | None:
        """Return the column of a role, None if there is none."""
        return next(iter(self.of(role)), None)


def find_headings(grid: Grid, custom: ReactionHeadings, single: str = "") -> Headings | None:
    """Return the headings of a table; None if it has none of reactions.

    Parameters
    ----------
    grid : Grid
        The cells.
    custom : ReactionHeadings
        Headings that are not the usual ones.
    single : str
        The load case of a table that names none.

    Raises
    ------
    InputError
        If the headings are there but leave open what is where.
    """
    ours: dict[Role, str] = {role: getattr(custom, role) for role in USUAL if getattr(custom, role, "")}
    rows = [[str(cell) for cell in row] for row in grid.rows[:ABOVE]]
    scores = [len({role for cell in row if (role := _role(cell, ours)) is not None}) for row in rows]
    if not scores or not max(scores):
        return None
    top = scores.index(max(scores))
    stated = _unit_row(rows[top + 1]) if top + 1 < len(rows) else {}
    upper = _fill(rows[top - 1], len(rows[top])) if top else [""] * len(rows[top])
    first = top + 1 + bool(stated)
    # a heading may stand above, if the cell below it is blank
    above = [*(rows[top - 1] if top else []), *[""] * len(rows[top])]
    names = [cell or (up if _role(up, ours) else "") for cell, up in zip(rows[top], above, strict=False)]
    named = {_role(cell, ours) for cell in names} & {"case", "support and case"}
    columns = tuple(_columns(names, upper, stated, ours, not (named or single)))
    _require_places(columns, names, grid, top)
    headings = Headings(tuple(_preferred(columns, names, grid, first)), first)
    _require_headings(headings, grid, names, top)
    return headings if headings.of("F_z") and headings.of("support", "support and case") else None


def unit_of(text: str, dimension: str = "") -> str:
    """Return a unit of force, moment or length as it is written here, such as "kip ft" of "k-ft"; nothing if none."""
    words = re.split(
        r"[\s·*.-]+", re.sub(r"[A-Za-z]+", lambda word: _UNITS.get(word[0].lower(), word[0]), text.strip())
    )
    unit = " ".join(word for word in words if word)
    unit = re.sub(r"\b(k|M|)N m$", r"\1Nm", unit)
    for kind in (dimension,) if dimension else ("force", "moment", "length", "force per length", "moment per length"):
        try:
            units.parse(f"1 {unit}", kind)
        except units.QuantityError:
            continue
        return unit
    return ""


def _plain(text: str) -> str:
    """Return a heading without unit, spaces and signs, in small letters."""
    return re.sub(r"[\W_]+", "", _without_unit(text)).lower()


def _role(text: str, ours: Mapping[Role, str]) -> Role | None:
    """Return the role of a heading by its own name."""
    plain = _plain(text)
    if not plain:
        return None
    for role, name in ours.items():
        if text.strip() == name.strip() or plain == _plain(name):
            return role
    spelled = {plain, plain.removesuffix("s")}
    return next((role for role, names in USUAL.items() if not spelled.isdisjoint(names) and role not in ours), None)


def _fill(row: Sequence[str], width: int) -> list[str]:
    """Return the headings above, each also over the blank cells to its right, as those of joined cells."""
    filled: list[str] = []
    for cell in [*row, *[""] * width][:width]:
        filled.append(cell or (filled[-1] if filled else ""))
    return filled


def _unit_row(row: Sequence[str]) -> dict[int, str]:
    """Return the units of a row that holds nothing else, by column."""
    said = {column: cell.strip("[](){} -") for column, cell in enumerate(row)}
    by_column = {column: unit_of(text) for column, text in said.items() if text and text.lower() not in _NO_UNITS}
    return by_column if by_column and all(by_column.values()) else {}


def _units_in(text: str, dimension: str) -> str:
    """Return the unit in brackets in a heading."""
    brackets = _BRACKETS.findall(text)
    return next((unit for bracket in brackets if (unit := unit_of(bracket, dimension))), "")


def _columns(
    row: Sequence[str], upper: Sequence[str], stated: Mapping[int, str], ours: Mapping[Role, str], by_case: bool
) -> Iterator[Heading]:
    """Yield what each column is; `by_case` says that columns may be of one load case each."""
    roles = [_role(cell, ours) for cell in row]
    repeated = roles.count("F_z") > 1
    pairs = [_split(cell) if by_case and not roles[column] else None for column, cell in enumerate(row)]
    whole = "F_z" not in roles and not any(pair and pair[0] for pair in pairs)
    for column, cell in enumerate(row):
        role, case = roles[column], ""
        if role in BY_CASE and by_case and repeated:
            case = _without_unit(upper[column])
        elif pair := pairs[column]:
            role, case = ("F_z" if whole else pair[0]), pair[1]
        if role is not None:
            yield Heading(column, role, _unit(role, cell, upper[column], stated.get(column, "")), case)


def _unit(role: Role, heading: str, above: str, stated: str) -> str:
    """Return the unit of a column: that below the heading, in it or above it, both if they differ; also per length."""
    dimension = DIMENSIONS.get(role)
    if dimension is None:
        return ""
    kinds = (dimension,) if dimension == "length" else (dimension, f"{dimension} per length")
    candidates = (_units_in(text, kind) for text in (heading, above) for kind in kinds)
    written = next((unit for unit in candidates if unit), "")
    return listed(dict.fromkeys([written, stated]), BOTH) if written and stated else written or stated


def _without_unit(text: str) -> str:
    """Return a heading without a unit in brackets."""
    return _BRACKETS.sub(lambda match: "" if unit_of(match[1]) else match[0], text).strip()


def _split(text: str) -> tuple[Role | None, str] | None:
    """Return value and case of a heading such as "Fz G", "G (M_x) [kNm]" or "Q"; None if it is of another value."""
    words = re.sub(r"[()\[\]:;/|]", " ", _without_unit(text)).split()
    names = [_plain(word) for word in words]
    if not words or any(name in _OTHERS for name in names):
        return None
    for position, name in enumerate(names):
        role = next((role for role in BY_CASE if name in USUAL[role] and len(name) > 1), None)
        if role is not None and len(words) > 1:
            return role, " ".join(words[:position] + words[position + 1 :])
    return None, " ".join(words)


def _preferred(columns: Sequence[Heading], row: Sequence[str], grid: Grid, first: int) -> Iterator[Heading]:
    """Yield the columns, of several supports, cases or coordinates that with the first of the usual names."""
    for heading in columns:
        if heading.role in BY_CASE:
            # of a load case are numbers; a column without any is a remark
            if not heading.case or _has_numbers(grid, heading.column, first):
                yield heading
            continue
        rivals = [other for other in columns if other.role == heading.role]
        if heading is min(rivals, key=lambda rival: _rank(rival.role, row[rival.column])):
            yield heading


def _require_places(columns: Sequence[Heading], row: Sequence[str], grid: Grid, top: int) -> None:
    """Raise InputError for two columns of one heading that differ, of coordinates or of horizontal forces."""
    issues = []
    for left, right in combinations((heading for heading in columns if heading.role in ("x", "y", "F_x", "F_y")), 2):
        same = left.role == right.role and _rank(left.role, row[left.column]) == _rank(right.role, row[right.column])
        if same and any(a != b for a, b in _pairs(grid, top + 1, left.column, right.column)):
            doubled = f"two columns with {left.role}: {listed([row[left.column], row[right.column]], 'and')}"
            issues.append(Issue(f"{grid.name}, row {top + 1}", doubled, "one", "leave only the one that is meant"))
    if issues:
        raise InputError(issues)


def _pairs(grid: Grid, first: int, left: int, right: int) -> Iterator[tuple[Cell, Cell]]:
    """Yield the cells of two columns below headings."""
    for row in grid.rows[first:]:
        yield row[left] if left < len(row) else "", row[right] if right < len(row) else ""


def _rank(role: Role, text: str) -> int:
    """Return the place of a heading among the usual ones; one that was given is the first."""
    plain = _plain(text)
    return next((USUAL[role].index(form) for form in (plain, plain.removesuffix("s")) if form in USUAL[role]), -1)


def _has_numbers(grid: Grid, column: int, first: int) -> bool:
    """Return whether a column has numbers in its first rows."""
    cells = [row[column] for row in grid.rows[first : first + ABOVE] if column < len(row)]
    return any(isinstance(cell, float) or re.match(r"[-+−]?[.,]?[0-9]", cell) for cell in cells)


def _require_headings(headings: Headings, grid: Grid, row: Sequence[str], top: int) -> None:
    """Raise InputError for forces per length, and for a value that two columns have."""
    issues = []
    for heading in headings.columns:
        where = f"{grid.name}, row {top + 1}, column {heading.column + 1}"
        if f" {BOTH} " in heading.unit:
            issues.append(Issue(where, f"{describe(row[heading.column])} in {heading.unit}", "one unit"))
            continue
        dimension = DIMENSIONS.get(heading.role)
        kinds = (dimension,) if dimension in (None, "length") else (dimension, f"{dimension} per length")
        if heading.unit and dimension and not any(unit_of(heading.unit, kind or "") for kind in kinds):
            expected = f"a unit of {units.DIMENSIONS[dimension].phrase}"
            issues.append(Issue(where, f"{describe(row[heading.column])} in {heading.unit}", expected))
    values = [heading for heading in headings.columns if heading.role in BY_CASE]
    for left, right in pairwise(sorted(values, key=lambda heading: (heading.role, heading.case))):
        if (left.role, left.case) == (right.role, right.case):
            of = f" of {quote(left.case)}" if left.case else ""
            doubled = f"two columns with {left.role}{of}: {listed([row[left.column], row[right.column]], 'and')}"
            hint = f'name the one that is meant: headings = {{{left.role} = "..."}}'
            issues.append(Issue(f"{grid.name}, row {top + 1}", doubled, "one", hint))
    if issues:
        raise InputError(issues)
