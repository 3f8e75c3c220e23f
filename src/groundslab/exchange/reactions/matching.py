"""What the supports and load cases of a table of reactions stand for in a case."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from typing import get_args

from groundslab import units
from groundslab.case.numbers import format_number
from groundslab.errors import Issue
from groundslab.exchange.reactions.table import Reaction, ReactionTable, cases_of
from groundslab.geometry.plan import Place, format_place
from groundslab.model.loads.load_cases import Category, Kind
from groundslab.model.model import Model
from groundslab.model.reactions import Reactions
from groundslab.model.structure.columns import Column
from groundslab.model.structure.walls import Wall
from groundslab.schema.wording import describe, listed, quote, suggestion

#: Digits of places that are computed: nanometers [m].
DIGITS = 9
#: Arcs of walls as chords so far off [m], to find the nearest one.
CHORD = 1e-3
#: Supports that are listed one by one in a remark.
LISTED = 10


@dataclass(frozen=True, slots=True)
class Frame:
    """Where places of a table lie in the plan: its unit [m], its origin [m], and which way its y points (1 or -1)."""

    unit: str
    size: float
    origin: Place
    y: int

    def place(self, reaction: Reaction) -> Place | None:
        """Return the place of a support in the plan [m]."""
        if reaction.place is None:
            return None
        x, y = (float(coordinate) * self.size for coordinate in reaction.place)
        return round(self.origin[0] + x, DIGITS), round(self.origin[1] + self.y * y, DIGITS)

    def texts(self, reaction: Reaction) -> tuple[str, str]:
        """Return the coordinates as they are written into a case: those of the table, if nothing moves them."""
        place = self.place(reaction)
        assert place is not None
        assert reaction.place is not None
        if self.origin != (0.0, 0.0):
            return f"{place[0]:.9g} m", f"{place[1]:.9g} m"
        x, y = reaction.place
        return f"{format_number(x)} {self.unit}", f"{format_number(self.y * y)} {self.unit}"


@dataclass(frozen=True, slots=True)
class Moved:
    """A column or wall that is not where the table has its support [m]."""

    support: str
    name: str
    before: Place
    after: Place
    texts: tuple[str, str]


@dataclass(frozen=True, slots=True)
class Matched:
    """What supports stand for, by their names in the table.

    Attributes
    ----------
    on : mapping of str to str
        Name of the column or wall of each support.
    new_columns : tuple of dict
        Columns to be made, as tables of a case.
    moved : tuple of Moved
        Those that the table has at another place.
    issues : tuple of Issue
        Supports that stand for nothing.
    """

    on: Mapping[str, str]
    new_columns: tuple[dict[str, str], ...]
    moved: tuple[Moved, ...]
    issues: tuple[Issue, ...]


def frame_of(table: ReactionTable, reading: Reactions) -> Frame:
    """Return how places of a table lie in the plan."""
    size = units.parse(f"1 {table.length}", "length") if table.length else 1.0
    return Frame(table.length or "m", size, reading.origin, -1 if reading.mirrored else 1)


def match_supports(reactions: Sequence[Reaction], table: ReactionTable, model: Model, reading: Reactions) -> Matched:
    """Return what the supports of reactions stand for: as it was said, by name, or by place.

    Parameters
    ----------
    reactions : sequence of Reaction
        Those that are taken.
    table : ReactionTable
        The table.
    model : Model
        The case with its columns and walls.
    reading : Reactions
        What was said of supports; the tolerance [m]; the footprint of new columns [m].
    """
    frame = frame_of(table, reading)
    bases: dict[str, Column | Wall] = {wall.name: wall for wall in model.placed_walls}
    bases |= {column.name: column for column in model.columns}
    said = {pair.table: pair.on for pair in reading.supports}
    on: dict[str, str] = {}
    columns, moved, issues = list[dict[str, str]](), list[Moved](), list[Issue]()
    for support, reaction in {entry.support: entry for entry in reversed(reactions)}.items():
        place = frame.place(reaction)
        name = said.get(support) or _same_name(support, bases)
        if name in bases:
            on[support] = name
            off = 0.0 if place is None else _distance(place, bases[name])
            if place is not None and off > _reach(bases[name], reading):
                moved.append(Moved(support, name, _middle(bases[name]), place, frame.texts(reaction)))
            continue
        if support in said:
            unknown_base = f"{quote(said[support])} for support {quote(support)}"
            issues.append(Issue("supports", unknown_base, "a column or wall", suggestion(said[support], bases)))
            continue
        near = _nearest(place, bases.values())
        if near is not None and near[1] <= _reach(near[0], reading):
            on[support] = near[0].name
        elif place is not None and reading.footprint is not None:
            on[support] = support
            columns.append(_new_column(support, frame.texts(reaction), reading.footprint))
        else:
            issues.append(_unmatched(table, reaction, place, near))
    return Matched(on, tuple(reversed(columns)), tuple(reversed(moved)), tuple(reversed(issues)))


def _same_name(name: str, candidates: Iterable[str]) -> str:
    """Return the known name that a name is, or is but for capital letters and spaces if only one is."""
    names = list(candidates)
    if name in names:
        return name
    alike = [candidate for candidate in names if _letters(candidate) == _letters(name)]
    return alike[0] if len(alike) == 1 else ""


def _letters(name: str) -> str:
    return "".join(name.split()).casefold()


def _reach(base: Column | Wall, reading: Reactions) -> float:
    """Return how far from a column's center or a wall's axis a support may lie [m]."""
    return max(reading.tolerance, base.thickness / 2) if isinstance(base, Wall) else reading.tolerance


def _distance(place: Place, base: Column | Wall) -> float:
    """Return the distance of a place to the center of a column or the axis of a wall [m]."""
    if isinstance(base, Column):
        return math.dist(place, (base.x, base.y))
    from shapely import Point

    return float(base.to_shapely(CHORD).distance(Point(place)))


def _middle(base: Column | Wall) -> Place:
    """Return the center of a column, or the middle of a wall's axis [m]."""
    if isinstance(base, Column):
        return base.x, base.y
    middle = base.to_shapely(CHORD).interpolate(0.5, normalized=True)
    return round(middle.x, DIGITS), round(middle.y, DIGITS)


def _nearest(place: Place | None, bases: Iterable[Column | Wall]) -> tuple[Column | Wall, float] | None:
    """Return the column or wall that is nearest to a place, and its distance [m]."""
    if place is None:
        return None
    distances = ((base, _distance(place, base)) for base in bases)
    return min(distances, key=lambda pair: (pair[1], isinstance(pair[0], Wall)), default=None)


def _new_column(name: str, place: tuple[str, str], footprint: tuple[float, float]) -> dict[str, str]:
    widths = [f"{width:.9g} m" for width in footprint]
    return {"name": name, "x": place[0], "y": place[1], "width_x": widths[0], "width_y": widths[1]}


def _unmatched(
    table: ReactionTable, reaction: Reaction, place: Place | None, near: tuple[Column | Wall, float] | None
) -> Issue:
    where = "" if place is None else f" at {format_place(place)} m"
    words = f"support {quote(reaction.support)}{where}, F_z = {format_number(reaction.F_z)} {table.force}"
    words += f" in {quote(reaction.case)}"
    nearest = "" if near is None else f", the nearest one is {near[0].name}, {near[1]:.3g} m off"
    hint = "say which one it is, give the footprint of a new column, or leave it out"
    if place is None:
        hint = "say which one it is, or leave it out; a new column needs a table with places"
    return Issue(f"{table.name}, row {reaction.row}", words, f"a column or wall of that name or place{nearest}", hint)


@dataclass(frozen=True, slots=True)
class MatchedCases:
    """What load cases stand for by their names in the table, those to be made as tables of a case, those left out."""

    names: Mapping[str, str]
    new: tuple[dict[str, str], ...]
    left: tuple[str, ...]
    issues: tuple[Issue, ...]


def match_cases(table: ReactionTable, model: Model, reading: Reactions, new_cases: Mapping[str, str]) -> MatchedCases:
    """Return what the load cases of a table stand for.

    Parameters
    ----------
    table : ReactionTable
        The table.
    model : Model
        The case with its load cases.
    reading : Reactions
        Names that differ, and load cases that are left out.
    new_cases : mapping of str to str
        Action, or category of a variable one, of each load case that is new.
    """
    said = {pair.table: pair.case for pair in reading.cases}
    cases = [case.name for case in model.cases]
    names: dict[str, str] = {}
    tables, left, issues = list[dict[str, str]](), list[str](), list[Issue]()
    for case in cases_of(table.reactions):
        same = said.get(case) or _same_name(case, cases)
        if case in reading.without_cases:
            continue
        if case in table.unsigned and (same or case in new_cases):
            unsigned_case = (
                f"load case {quote(case)} ({table.unsigned[case]}), whose values are the largest ones, without signs"
            )
            hint = "take forces of one direction that act together, such as equivalent static ones, or leave it out"
            issues.append(Issue(table.name, unsigned_case, "forces and moments that act together", hint))
        elif same:
            names[case] = same
        elif case in new_cases:
            names[case] = case
            tables += _new_case(case, new_cases[case], issues)
        elif case in table.combined:
            left.append(case)
        else:
            expected = f"one of {listed(map(quote, cases))}" if cases else "a load case of the case file"
            hint = "say which one it is, give its action if it is new, or leave it out"
            issues.append(Issue(table.name, f"load case {quote(case)}", expected, hint))
    for case in (case for case in new_cases if case not in cases_of(table.reactions)):
        issues.append(Issue(table.name, f"no load case {quote(case)}", f"one of {listed(cases_of(table.reactions))}"))
    return MatchedCases(names, tuple(tables), tuple(left), tuple(issues))


def remarks_on_cases(
    reactions: Sequence[Reaction], matched: MatchedCases, table: ReactionTable, model: Model
) -> list[str]:
    """Return what contradicts the actions of cases: their types in the table; no negative value of a seismic one."""
    actions = {case.name: case.action for case in model.cases} | {case["name"]: case["action"] for case in matched.new}
    values: dict[str, list[Decimal]] = {}
    for row in reactions:
        values.setdefault(row.case, []).extend(value for value in (row.F_z, row.M_x, row.M_y) if value)
    remarks = []
    for case, numbers in values.items():
        action, said = actions[matched.names[case]], table.types.get(case, "")
        kinds = {kind for word, kind in _TYPES.items() if re.search(word, said, re.IGNORECASE)}
        if kinds and action not in kinds:
            remarks.append(f"load case {quote(case)} has the type {describe(said)} in the table and is {action} here")
        if action == "seismic" and len(numbers) > 1 and min(numbers) > 0:
            why = "if they are of a response spectrum, they have no signs and are no load"
            remarks.append(f"load case {quote(case)} is seismic and none of its values is negative: {why}")
    return remarks


#: Actions by words in the types of load cases.
_TYPES: Mapping[str, Kind] = {
    r"\bdead|permanent": "permanent", r"\blive|imposed|variable|wind|snow|temperature": "variable",
    r"seismic|quake": "seismic", r"accidental": "accidental",
}  # fmt: skip


def _new_case(name: str, action: str, issues: list[Issue]) -> list[dict[str, str]]:
    """Return a new load case of an action, or of a category of variable actions."""
    if action in get_args(Kind):
        return [{"name": name, "action": action}]
    if action in get_args(Category):
        return [{"name": name, "action": "variable", "category": action}]
    expected = f"{listed(get_args(Kind))}, or a category of variable actions: {listed(get_args(Category))}"
    issues.append(Issue(f"load case {quote(name)}", describe(action), expected))
    return []


def repeated(reactions: Iterable[Reaction], table: ReactionTable) -> list[Issue]:
    """Return issues of supports with two rows of one load case."""
    first: dict[tuple[str, str], Reaction] = {}
    issues = []
    for reaction in reactions:
        before = first.setdefault((reaction.support, reaction.case), reaction)
        if before is not reaction:
            twice = f"{quote(reaction.support)} in {quote(reaction.case)} again, as in row {before.row}"
            hint = "of several stories or steps, save only the one that stands on the slab"
            issues.append(Issue(f"{table.name}, row {reaction.row}", twice, "each support once in each case", hint))
    return issues


def with_resultants(
    reactions: Sequence[Reaction], matched: Matched, table: ReactionTable, model: Model, issues: list[Issue]
) -> list[Reaction]:
    """Return reactions whose forces per length of a line support are those of the whole wall on which it stands.

    They act about the wall's middle. Only walls have a length, and each one that of one support; `issues` gets others.
    """
    walls = {wall.name: wall for wall in model.placed_walls}
    supports: dict[str, dict[str, None]] = {}
    for reaction in reactions:
        supports.setdefault(matched.on[reaction.support], {})[reaction.support] = None
    for base, names in supports.items():
        if base not in walls or len(names) > 1:
            what = f"forces per {table.per} of {listed(map(quote, list(names)[:LISTED]), 'and')} on {base}"
            hint = "export the resultants"
            issues.append(Issue(table.name, what, "one line support on each wall, whose length counts", hint))
    if issues:
        return list(reactions)
    size = units.parse(f"1 {table.per}", "length")
    totals = []
    for reaction in reactions:
        length = Decimal(f"{walls[matched.on[reaction.support]].length / size:.15g}")
        forces = {name: getattr(reaction, name) * length for name in ("F_x", "F_y", "F_z", "M_x", "M_y")}
        totals.append(replace(reaction, place=None, **forces))
    return totals


def sideways(reactions: Iterable[Reaction], names: Mapping[str, str], reading: Reactions) -> dict[str, list[Decimal]]:
    """Return the sums of horizontal forces by load case along x and y, on what the table says."""
    sums: dict[str, list[Decimal]] = {}
    sign = -1 if reading.horizontal == "on the structure" else 1
    for reaction in reactions:
        total = sums.setdefault(names[reaction.case], [Decimal(0), Decimal(0)])
        total[0] += sign * reaction.F_x
        total[1] += sign * (-1 if reading.mirrored else 1) * reaction.F_y
    return sums


def words_of_sideways(sums: Mapping[str, Sequence[Decimal]], unit: str) -> list[str]:
    """Return a remark on horizontal forces that are not taken."""
    words = [f"{case} {format_number(x)} and {format_number(y)}" for case, (x, y) in sums.items() if x or y]
    if not words:
        return []
    more = f" and {len(words) - LISTED} more" if len(words) > LISTED else ""
    return [
        f"horizontal forces are not taken; their sums F_x and F_y [{unit}]: {', '.join(words[:LISTED])}{more}; "
        'say what they act on to have them as H_x and H_y: horizontal = "on the slab" or "on the structure"'
    ]
