"""Load groups, cases and combinations of a file."""

from __future__ import annotations

import itertools
import math
import re
from typing import Any, get_args

from groundslab.exchange.saf.reading.context import ReadContext, RowFault, text, word
from groundslab.exchange.saf.reading.workbook import Row
from groundslab.model.loads.load_cases import Category, Combination, Combine, Expression, Kind, LimitState, LoadCase
from groundslab.schema.wording import describe, listed

#: Categories of EN 1990 by the load type of a load group, as the format names them.
CATEGORIES: dict[str, Category] = {
    "domestic": "A", "offices": "B", "congregation": "C", "shopping": "D", "storage": "E", "vehicle < 30kn": "F",
    "vehicle > 30kn": "G", "roofs": "H", "snow": "snow", "wind": "wind", "temperature": "temperature",
}  # fmt: skip
#: Kinds of actions that a word may mean, the usual one first, by what it is said of. Seismic cases are variable or
#: accidental ones in the format, whose pages on load cases and load groups say which types go together.
_KINDS: dict[str, dict[str, tuple[Kind, ...]]] = {
    "action type": {"permanent": ("permanent",), "variable": ("variable", "seismic"),
                    "accidental": ("accidental", "seismic")},
    "group of type": {"permanent": ("permanent",), "variable": ("variable", "seismic"), "moving": ("variable",),
                      "accidental": ("accidental", "seismic"), "seismic": ("seismic",)},
    "load type": {
        "self weight": ("permanent",), "prestress": ("permanent",), "seismic": ("seismic",),
        **dict.fromkeys(("static", "dynamic", "temperature", "wind", "snow", "maintenance", "moving", "fire"),
                        ("variable", "accidental", "seismic")),
    },
}  # fmt: skip
#: Limit states by the category of a combination.
_STATES: dict[str, LimitState] = {"uls": "ultimate", "sls": "characteristic", "als": "accidental"}
_SERVICE = ("characteristic", "frequent", "quasi-permanent")
#: Limit states by the national standard of a combination; those of IBC are combined by ACI 318 and ASCE 7.
_STANDARDS: dict[str, LimitState] = {
    "enulsstrgeosetb": "ultimate", "enulsstrgeosetc": "ultimate", "enaccidental1": "accidental",
    "enaccidental2": "accidental", "enseismic": "seismic", "enslscharacteristic": "characteristic",
    "enslsfrequent": "frequent", "enslsquasipermanent": "quasi-permanent", "ibclrfdultimate": "ultimate",
    "ibcasdultimate": "characteristic", "ibclrfdseismic": "seismic",
}  # fmt: skip
#: Combinations that one envelope may become.
MOST_CHOICES = 100


def read_cases(context: ReadContext) -> list[LoadCase]:
    """Return the load cases, of the kind that their groups say."""
    groups = {row.name: row for row in context.rows("StructuralLoadGroup")}
    cases = list[LoadCase]()
    for row in context.rows("StructuralLoadCase"):
        with context.reading(row):
            group = groups.get(text(row, "loadgroup"))
            cases.append(LoadCase(name=row.name, **_read_action(context, row, group)))
            context.take(row, "load case")
    for row in groups.values():
        context.take(row, "kind of its load cases")
    return cases


def _read_action(context: ReadContext, row: Row, group: Row | None) -> dict[str, Any]:
    """Return kind, category and group of a case."""
    action = _read_kind(context, row, group)
    if action != "variable":
        return {"action": action}
    values: dict[str, Any] = {"action": "variable"}
    types = [text(source, "loadtype") for source in (group, row) if source is not None]
    categories = {name: match for name in types if (match := CATEGORIES.get(" ".join(name.lower().split())))}
    if len(set(categories.values())) > 1:
        found_types = listed(map(describe, categories), "and")
        raise RowFault("loadtype", f"load types of group and case that differ: {found_types}", "one category of loads")
    category = next(iter(categories.values()), None)
    if category is not None:
        values["category"] = category
    else:
        context.note(row, "no known category: psi of offices and dwellings until others are given")
    if group is not None and word(group, "relation") == "exclusive":
        values["group"] = group.name
    return values


def _read_kind(context: ReadContext, row: Row, group: Row | None) -> Kind:
    """Return the kind of a case by all columns that speak of it; raises RowFault where they contradict each other.

    A case that is permanent by one and variable by another is variable, which has the larger factor, with a note.
    """
    word(row, "actiontype", ("permanent", "variable", "accidental"), "permanent")
    columns = [("action type", row, "actiontype"), ("load type", row, "loadtype")]
    columns += [] if group is None else [("group of type", group, "loadgrouptype")]
    said = {(what, text(source, key)): _KINDS[what].get(word(source, key), ()) for what, source, key in columns}
    possible = [kinds for kinds in said.values() if kinds]
    words = " and ".join(f"{what} {describe(name)}" for (what, name), kinds in said.items() if kinds)
    usual = {kinds[0] for kinds in possible}
    common = [kind for kind in get_args(Kind) if kind in usual and all(kind in kinds for kinds in possible)]
    kind: Kind = common[0] if common else "variable" if possible else "permanent"
    if possible and not common and not usual <= {"permanent", "variable"}:
        hint = "say in all of these columns what kind of load case it is"
        raise RowFault("actiontype", f"{words}, which contradict each other", "one kind of action", hint)
    (_, name), of_group = list(said.items())[-1] if group is not None else (("", ""), ())
    if (possible and not common) or (of_group and of_group[0] != kind):
        context.note(row, f"{words}, taken as {kind}")
    if name and not of_group:
        context.note(row, f"a group of type {describe(name)}, taken as {kind}")
    return kind


def read_combinations(context: ReadContext, cases: list[LoadCase]) -> tuple[list[Combination], Combine | None]:
    """Return the combinations with their factors, and those that a standard is to make."""
    combinations, sets = list[Combination](), list[tuple[LimitState, Expression]]()
    for row in context.rows("StructuralLoadCombination"):
        with context.reading(row):
            if word(row, "category").startswith("according"):
                sets += _read_standard(context, row, {case.name for case in cases})
            else:
                combinations += _read_combination(context, row, cases)
    return combinations, _make_combine(context, sets) if sets and cases else None


def _read_combination(context: ReadContext, row: Row, cases: list[LoadCase]) -> list[Combination]:
    """Return the combination of a row, of an envelope one for each choice of cases that exclude each other."""
    factors, category = _read_factors(context, row, {case.name for case in cases}), word(row, "category")
    if not any(factors.values()):
        context.leave(row, "no factor that is not 0")
        return []
    choices = [factors]
    if (kind := word(row, "type")) == "envelope":
        choices = _choose(factors, cases)
        if len(choices) > MOST_CHOICES:
            context.leave(row, f"an envelope of {len(choices):,} combinations, one for each choice of exclusive cases")
            return []
        of_them = (
            f"{len(choices)} combinations, each with one of the exclusive cases and" if choices[1:] else "one with"
        )
        context.note(row, f"an envelope, taken as {of_them} all others; of those with fewer cases give them by hand")
    elif kind == "nonlinear":
        context.note(row, "nonlinear, taken as a combination like the others")
    state = _read_state(row, category)
    if category[:3] not in _STATES and "rule" not in state:
        context.note(row, f"the category {describe(category or 'nothing')}, taken as ultimate")
    names = [row.name] if len(choices) == 1 else [f"{row.name} ({n})" for n in range(1, len(choices) + 1)]
    context.take(row, f"combination, {state['limit_state']}")
    return [Combination(name=name, factors=choice, **state) for name, choice in zip(names, choices, strict=True)]


def _choose(factors: dict[str, float], cases: list[LoadCase]) -> list[dict[str, float]]:
    """Return the factors for each choice of one case of every group of exclusive ones."""
    groups: dict[str, list[str]] = {}
    for case in cases:
        if case.group and factors.get(case.name):
            groups.setdefault(case.group, []).append(case.name)
    if math.prod(map(len, groups.values())) > MOST_CHOICES:
        return [factors] * math.prod(map(len, groups.values()))
    exclusive = {name for names in groups.values() for name in names}
    return [
        {name: factor for name, factor in factors.items() if name in chosen or name not in exclusive}
        for chosen in itertools.product(*groups.values())
    ]


def _make_combine(context: ReadContext, sets: list[tuple[LimitState, Expression]]) -> Combine:
    """Return the combinations of the first code; those of another one are noted."""
    expression = sets[0][1]
    states = dict.fromkeys(state for state, code in sets if code == expression)
    if others := [state for state, code in sets if code != expression]:
        context.note(
            None, f"{', '.join(others)} of a second code, left out: a case has one", "StructuralLoadCombination"
        )
    return Combine(sets=tuple(states), expression=expression)


def _read_state(row: Row, category: str) -> dict[str, Any]:
    """Return the limit state of a combination: that with which its description starts, or that of its category."""
    description = text(row, "description")
    for state in get_args(LimitState):
        if description == state or description.startswith(f"{state}, "):
            if category[:3] in _STATES and (category[:3] == "sls") != (state in _SERVICE):
                statements = f"category {describe(category)} and description {describe(description)}"
                raise RowFault("category", f"{statements}, which contradict each other", "one limit state")
            return {"limit_state": state, "rule": description[len(state) + 2 :]}
    return {"limit_state": _STATES.get(category[:3], "ultimate")}


def _read_standard(context: ReadContext, row: Row, names: set[str]) -> list[tuple[LimitState, Expression]]:
    """Return the limit state and the code by which a standard combines, nothing if they are not known."""
    standard = text(row, "nationalstandard")
    key = re.sub(r"[^a-z0-9]", "", standard.lower())
    state = _STANDARDS.get(key)
    if state is None:
        context.leave(row, f"combinations by the standard {describe(standard)}")
        return []
    expression: Expression
    code, expression = ("ACI 318 and ASCE 7", "ACI 318") if key.startswith("ibc") else ("EN 1990", "6.10")
    context.take(row, f"combine by {code}, {state}; factors are those of the standard, not of the file")
    listed = {value for name, value in _cases_of(row)}
    if left := names - listed:
        context.note(row, f"all cases are combined, also those that it does not list: {', '.join(sorted(left)[:12])}")
    return [(state, expression)]


def _cases_of(row: Row) -> list[tuple[str, str]]:
    """Return the numbers and names of the cases of a combination."""
    numbers = ((key, re.fullmatch(r"loadcasename(\d+)", key)) for key in row.cells)
    return [(number[1], text(row, key)) for key, number in numbers if number and text(row, key)]


def _read_factors(context: ReadContext, row: Row, names: set[str]) -> dict[str, float]:
    """Return the factor of each case of a combination; raises RowFault."""
    factors: dict[str, float] = {}
    for n, name in _cases_of(row):
        if name not in names:
            raise RowFault(f"loadcasename{n}", f"the case {describe(name)}", "one of sheet StructuralLoadCase")
        spellings = (f"multiplier{n}", f"loadmultiplier{n}")
        multipliers = {context.number(row, key, "number", 1.0) for key in spellings if key in row.cells} or {1.0}
        values = [context.number(row, f"loadfactor{n}", "number", 1.0) * scale for scale in sorted(multipliers)]
        factor = float(f"{values[0]:.12g}")
        if len(values) > 1 or name in factors:
            both = listed([f"{value:g}" for value in (factors.get(name, values[-1]), factor)], "and")
            raise RowFault(f"loadcasename{n}", f"the case {describe(name)} with the factors {both}", "one factor")
        factors[name] = factor
    return factors
