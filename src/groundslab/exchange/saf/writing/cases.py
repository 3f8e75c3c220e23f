"""Load groups, cases and combinations as rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, get_args

from groundslab.exchange.saf.reading.cases import CATEGORIES
from groundslab.exchange.saf.writing.sheets import Sheets
from groundslab.model.loads.load_cases import PSI, Category, Combination, LoadCase
from groundslab.model.loads.load_types import SelfWeight

if TYPE_CHECKING:
    from groundslab.model.model import Model

#: The case of loads that have none.
ALL_LOADS = "loads"
#: Cases of a combination, at most: so many columns has the format.
MOST_CASES = 99

_CATEGORY_TYPES = {category: name for name, category in CATEGORIES.items()}
#: Load types of groups as the format writes them.
_SPELLED = {"vehicle < 30kn": "Vehicle < 30kN", "vehicle > 30kn": "Vehicle > 30kN"}
_COMBINATION_CATEGORIES = {
    "characteristic": "SLS (Serviceability Limit State)",
    "accidental": "ALS (Accidental Limit State)",
    "frequent": "SLS (Serviceability Limit State)",
    "quasi-permanent": "SLS (Serviceability Limit State)",
}
_ULTIMATE = "ULS (Ultimate Limit State)"


def write_cases(sheets: Sheets, model: Model) -> dict[str, str]:
    """Write groups and cases; return the names of the cases of self-weight by those of the cases they belong to."""
    alone: dict[str, str] = {}
    for case in model.cases or (LoadCase(name=ALL_LOADS),):
        of_case = [load for load in model.loads if load.case == (case.name if model.cases else "")]
        weights = [load for load in of_case if isinstance(load, SelfWeight) and by_material(model, load)]
        only = bool(weights) and len(weights) == len(of_case) and not (case.H_x or case.H_y)
        name = _write_case(sheets, case, "Self weight" if only else "")
        alone[case.name] = name
        if weights and not only:
            alone[case.name] = _write_case(
                sheets, case.model_copy(update={"name": f"{case.name} self weight"}), "Self weight"
            )
            sheets.leave(f"case {case.name}", f"its self-weight is in a case of its own, {alone[case.name]}")
    if not model.cases:
        sheets.leave("loads", f"without cases: they are in the case {ALL_LOADS}")
    return alone


def by_material(model: Model, load: SelfWeight) -> bool:
    """Return whether a self-weight is that of all plates by the mass of their material, which a file gives once."""
    first = next(
        (acting.unit_weight for acting in model.loads if isinstance(acting, SelfWeight) and not acting.plate), None
    )
    return not load.plate and load.unit_weight == first


def _write_case(sheets: Sheets, case: LoadCase, load_type: str) -> str:
    """Write a case with its group and return its name."""
    kind, psi = "", (case.psi_0, case.psi_1, case.psi_2)
    if case.action == "variable":
        category = case.category or _category_of(psi)
        kind = "others" if category is None else _CATEGORY_TYPES.get(category, "snow")
        if PSI[category or "A"] != psi or (category is not None and category not in _CATEGORY_TYPES):
            sheets.leave(f"case {case.name}", f"its psi {psi} are not written")
    action = {"seismic": "variable"}.get(case.action, case.action).capitalize()
    group = _write_group(sheets, case, _SPELLED.get(kind, kind.capitalize()))
    of_seismic = "Seismic" if case.action == "seismic" else ""
    special = kind.capitalize() if kind in ("wind", "snow", "temperature") else ""
    return sheets.add(
        "StructuralLoadCase",
        case.name,
        "LC",
        actiontype=action,
        loadgroup=group,
        loadtype=load_type or of_seismic or special or ("Static" if case.action == "variable" else "Others"),
        duration="Short" if action == "Variable" else None,
    )


def _category_of(psi: tuple[float, float, float]) -> Category | None:
    """Return the first category with such psi, None for those that a case has by default."""
    matching: list[Category] = [category for category in get_args(Category) if PSI[category] == psi]
    return matching[0] if matching and psi != PSI["A"] else None


def _write_group(sheets: Sheets, case: LoadCase, kind: str) -> str:
    """Return the group of a case: that of the cases that exclude it, or one of its own."""
    if case.group and case.group in sheets.names["StructuralLoadGroup"]:
        return case.group
    relation = "Exclusive" if case.group else "Standard"
    return sheets.add(
        "StructuralLoadGroup",
        case.group,
        "LG",
        loadgrouptype=case.action.capitalize(),
        relation=relation,
        loadtype=kind or None,
    )


def write_combinations(
    sheets: Sheets, combinations: Sequence[Combination], weights: Mapping[str, str]
) -> dict[str, str]:
    """Write combinations with their factors and return their names in the file; limit states start descriptions."""
    names: dict[str, str] = {}
    for combination in combinations:
        factors = {name or ALL_LOADS: factor for name, factor in combination.factors if factor}
        for name, factor in list(factors.items()):
            if weights.get(name, name) != name:
                factors[weights[name]] = factor
        if len(factors) > MOST_CASES:
            sheets.leave(f"combination {combination.name}", f"more than {MOST_CASES} cases")
            continue
        cells: dict[str, Any] = {}
        for n, (name, factor) in enumerate(factors.items(), start=1):
            cells |= {f"loadfactor{n}": factor, f"multiplier{n}": 1, f"loadcasename{n}": name}
        rule = f", {combination.rule}" if combination.rule else ""
        names[combination.name] = sheets.add(
            "StructuralLoadCombination",
            combination.name,
            "CO",
            description=f"{combination.limit_state}{rule}",
            category=_COMBINATION_CATEGORIES.get(combination.limit_state, _ULTIMATE),
            type=None if combination.limit_state == "accidental" else "Linear",
            **cells,
        )
    return names
