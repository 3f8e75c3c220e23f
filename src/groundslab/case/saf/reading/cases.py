"""Load groups, cases and combinations of a file."""

from __future__ import annotations

import re
from typing import Any, get_args

from groundslab.case.saf.reading.context import ReadContext, RowFault, text, word
from groundslab.case.saf.reading.workbook import Row
from groundslab.model.loads.load_cases import Category, Combination, Combine, Kind, LimitState, LoadCase
from groundslab.schema.wording import describe

#: Categories of EN 1990 by the load type of a load group, as the format names them.
CATEGORIES: dict[str, Category] = {
    "domestic": "A", "offices": "B", "congregation": "C", "shopping": "D", "storage": "E", "vehicle < 30kn": "F",
    "vehicle > 30kn": "G", "roofs": "H", "snow": "snow", "wind": "wind", "temperature": "temperature",
}  # fmt: skip
#: Limit states by the category of a combination.
_STATES: dict[str, LimitState] = {"uls": "ultimate", "sls": "characteristic", "als": "accidental"}
#: Limit states by the national standard of a combination.
_STANDARDS: dict[str, LimitState] = {
    "enulsstrgeosetb": "ultimate", "enulsstrgeosetc": "ultimate", "enaccidental1": "accidental",
    "enaccidental2": "accidental", "enseismic": "seismic", "enslscharacteristic": "characteristic",
    "enslsfrequent": "frequent", "enslsquasipermanent": "quasi-permanent", "ibclrfdultimate": "ultimate",
    "ibcasdserviceability": "characteristic", "ibclrfdseismic": "seismic",
}  # fmt: skip


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
    action = word(row, "actiontype", ("permanent", "variable", "accidental"), "permanent")
    kind = word(group, "loadgrouptype") if group is not None else ""
    if "seismic" in (kind, word(row, "loadtype")):
        return {"action": "seismic"}
    if kind in get_args(Kind):
        action = kind
    elif kind:
        context.note(row, f"a group of type {kind}, taken as {action}")
    if action != "variable":
        return {"action": action}
    found: dict[str, Any] = {"action": "variable"}
    category = CATEGORIES.get(" ".join(text(group, "loadtype").lower().split())) if group is not None else None
    if category is not None:
        found["category"] = category
    else:
        context.note(row, "no known category: psi of offices and dwellings until others are given")
    if group is not None and word(group, "relation") == "exclusive":
        found["group"] = group.name
    return found


def read_combinations(context: ReadContext, cases: list[LoadCase]) -> tuple[list[Combination], Combine | None]:
    """Return the combinations with their factors, and those that a standard is to make."""
    known = {case.name for case in cases}
    combinations, sets = list[Combination](), list[LimitState]()
    for row in context.rows("StructuralLoadCombination"):
        with context.reading(row):
            category = word(row, "category")
            if category.startswith("according"):
                sets += _read_standard(context, row)
                continue
            factors = _read_factors(context, row, known)
            if not any(factors.values()):
                context.leave(row, "no factor that is not 0")
                continue
            kind = word(row, "type")
            if kind in ("envelope", "nonlinear"):
                context.note(row, f"{kind}, taken as the one combination of all its cases")
            combinations.append(Combination(name=row.name, factors=factors, **_read_state(row, category)))
            context.take(row, f"combination, {combinations[-1].limit_state}")
    return combinations, Combine(sets=tuple(dict.fromkeys(sets))) if sets and cases else None


def _read_state(row: Row, category: str) -> dict[str, Any]:
    """Return the limit state of a combination: that with which its description starts, or that of its category."""
    description = text(row, "description")
    for state in get_args(LimitState):
        if description == state or description.startswith(f"{state}, "):
            return {"limit_state": state, "rule": description[len(state) + 2 :]}
    return {"limit_state": _STATES.get(category[:3], "ultimate")}


def _read_standard(context: ReadContext, row: Row) -> list[LimitState]:
    """Return the limit state that a standard combines, none if it is not known."""
    standard = text(row, "nationalstandard")
    state = _STANDARDS.get(re.sub(r"[^a-z0-9]", "", standard.lower()))
    if state is None:
        context.leave(row, f"combinations by the standard {describe(standard)}")
        return []
    context.take(row, f"combine by EN 1990, {state}; factors are those of the standard, not of the file")
    return [state]


def _read_factors(context: ReadContext, row: Row, known: set[str]) -> dict[str, float]:
    """Return the factor of each case of a combination; raises RowFault."""
    factors: dict[str, float] = {}
    for key in row.cells:
        number = re.fullmatch(r"loadcasename(\d+)", key)
        if not number or not text(row, key):
            continue
        name, n = text(row, key), number[1]
        if name not in known:
            raise RowFault(key, f"the case {describe(name)}", "one of sheet StructuralLoadCase")
        multiplier = f"multiplier{n}" if f"multiplier{n}" in row.cells else f"loadmultiplier{n}"
        factor = context.number(row, f"loadfactor{n}", "number", 1.0) * context.number(row, multiplier, "number", 1.0)
        factors[name] = float(f"{factors.get(name, 0.0) + factor:.12g}")
    return factors
