"""Static equilibrium (EN 1990 6.4.2, EQU) and uplift by water or other actions (EN 1997-1 2.4.7.4, UPL).

The analysis decides: a combination that neither ground nor supports can balance has no equilibrium. Without supports
uplift is a comparison of vertical forces, too: of the load cases upwards against those downwards (expression 2.8).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from groundslab.design.checks.check import DesignCheck
from groundslab.design.perimeters import outline
from groundslab.design.tables import column_loads
from groundslab.design.tables.quantities import solved_results
from groundslab.errors import NoEquilibrium
from groundslab.model.loads.load_cases import Combination
from groundslab.results.results import Results

#: Name and clause of the check of each limit state.
_CHECKS = {
    "equilibrium": ("static equilibrium", "EN 1990 6.4.2"),
    "uplift": ("uplift by actions", "EN 1997-1 2.4.7.4"),
}


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the check of each of the two limit states that has combinations."""
    for state, (name, clause) in _CHECKS.items():
        made = [each for each in combined.combinations if each.limit_state == state]
        if made:
            numbers = _uplift(combined, made) if state == "uplift" else {}
            yield _check(combined, made, name, {"clause": clause, **numbers})


def _check(combined: Results, made: list[Combination], name: str, numbers: dict[str, Any]) -> DesignCheck:
    """Return whether all of some combinations are in equilibrium."""
    refused = {each.name: combined.refused[each.name] for each in made if each.name in combined.refused}
    lost = [name for name, error in refused.items() if isinstance(error, NoEquilibrium)]
    if lost:
        words = f"{len(lost)} of {len(made)} combinations have no equilibrium: {_some(lost)}"
        return DesignCheck(name, "fails", words, **({"combination": lost[0]} | numbers))
    if refused:
        return DesignCheck(name, "attention", f"without a certified result: {_some(list(refused))}", **numbers)
    count = f"all {len(made)} combinations are" if len(made) > 1 else "the combination is"
    return DesignCheck(name, "no failure found", f"{count} in equilibrium", **numbers)


def _uplift(combined: Results, made: list[Combination]) -> dict[str, Any]:
    """Return the forces upwards and downwards [kN] of the worst combination; nothing of several plates or supports."""
    solved = solved_results(combined)
    if combined.model.supports or combined.model.plates or not solved:
        return {}
    forces = column_loads.sum_of_others(solved[0], outline(solved[0].plate), "")
    found = []
    for each in made:
        parts = [factor * forces.get(case, 0.0) for case, factor in each.factors]
        up, down = -sum(part for part in parts if part < 0), sum(part for part in parts if part > 0)
        found.append((up / down if down else float("inf"), up / 1e3, down / 1e3, each.name))
    _, up, down, combination = max(found)
    return {"demand": up, "resistance": down, "unit": "kN", "combination": combination}


def _some(names: list[str]) -> str:
    """Return the first of some names."""
    return ", ".join(f'"{each}"' for each in names[:5]) + (" ..." if len(names) > 5 else "")
