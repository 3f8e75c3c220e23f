"""Static equilibrium (EN 1990 6.4.2, EQU) and uplift by water or other actions (EN 1997-1 2.4.7.4, UPL).

The analysis decides: where neither ground nor supports can balance a combination, of whatever limit state, the
foundation fails. Without supports uplift is a comparison of vertical forces, too: of the load cases upwards against
those downwards (expression 2.8). Combinations for which the program found no result are no failure, but a gap.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.by_plate import results_by_plate
from groundslab.design.demands.loads import column_loads
from groundslab.design.demands.perimeters import outline
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.check import GLUED, ROUNDING, UNSOLVED, DesignCheck, Status, not_judged, some
from groundslab.design.rules.combinations import solved_results, ultimate_results
from groundslab.messages import Message, Name, joined
from groundslab.model.loads.load_cases import Combination
from groundslab.results.fields import place_of
from groundslab.results.results import CombinationResult, Results

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Name and clause of the check of each limit state that is about equilibrium alone.
_CHECKS = {
    "equilibrium": ("static equilibrium", "EN 1990 6.4.2"),
    "uplift": ("uplift by actions", "EN 1997-1 2.4.7.4"),
}
#: The same of any other limit state, in which only a failure is worth a line.
_ANY = ("static equilibrium", "")


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the combinations without equilibrium, the two limit states about it, and what the program could not do."""
    lost = [combination for combination in combined.combinations if combination.name in combined.without_equilibrium]
    for combination in lost:
        yield _failure(combined, combination)
    failed = {combination.limit_state for combination in lost}
    for state in _CHECKS:
        of_state = [combination for combination in combined.combinations if combination.limit_state == state]
        if of_state and state not in failed and any(combination.name in combined.results for combination in of_state):
            yield _balanced(combined, of_state)
    if not combined.model.contact.tensionless:
        yield from _pulling_ground(combined)
    if combined.unsolved:
        yield not_judged(
            "unsolved combinations",
            UNSOLVED,
            Message("no certified result of {names}", names=some(list(combined.unsolved))),
        )


def _failure(combined: Results, combination: Combination) -> DesignCheck:
    """Return the check that a combination without equilibrium fails, with the reason."""
    name, clause = _CHECKS.get(combination.limit_state, _ANY)
    model = combined.model
    words = Message(
        'none in "{name}": {refused}', name=Name(combination.name), refused=str(combined.refused[combination.name])
    )
    if model.cases and not model.combinations and model.combine is None:
        words += "; each load case is solved by itself, as there are neither [[combinations]] nor [combine]"
    numbers = _uplift(combined, [combination]) if combination.limit_state == "uplift" else {}
    about = {"combination": combination.name} | numbers
    return DesignCheck(name, "fails", words, clause=clause, foundation=True, **about)


def _balanced(combined: Results, combinations: list[Combination]) -> DesignCheck:
    """Return the check that no combination lacks equilibrium, in which ground that pulls counts for nothing."""
    name, clause = _CHECKS[combinations[0].limit_state]
    solved = [combination for combination in combinations if combination.name in combined.results]
    numbers = _uplift(combined, solved) if combinations[0].limit_state == "uplift" else {}
    names = [combination.name for combination in solved]
    words: str = Message("all {number} combinations are in equilibrium", number=len(combinations))
    if len(combinations) == 1:
        words = "the combination is in equilibrium"
    if len(solved) < len(combinations):
        words = Message(
            "{solved} of {number} combinations are in equilibrium, the others have no certified result",
            solved=len(solved),
            number=len(combinations),
        )
    status: Status = "no failure found"
    if numbers and numbers["demand"] > numbers["resistance"] * (1 + ROUNDING):
        status, words = "fails", "actions upwards exceed those downwards"
    elif lost := [result.combination for result in _glued(combined) if result.combination in names and _lost(result)]:
        words = Message("only ground that pulls at the plate, to which it is glued, balances {names}", names=some(lost))
        if combined.model.supports or combined.model.plates:
            return not_judged(name, GLUED, words, clause=clause, foundation=True)
        status, numbers = "fails", numbers or {"combination": lost[0]}
    return DesignCheck(name, status, words, clause=clause, foundation=True, **numbers)


def _glued(combined: Results) -> list[CombinationResult]:
    """Return the results of a plate that is glued to the ground, none where the ground only presses."""
    return [] if combined.model.contact.tensionless else solved_results(combined)


def _lost(results: CombinationResult) -> bool:
    """Return whether the ground's force under any plate has no place under it, so that pressure alone is none.

    What the supports carry is taken as it is: other forces of theirs might do without ground that pulls.
    """
    for plate in results_by_plate(results).values():
        f = plate.contact_force
        sums = np.array([f.sum(), *(f @ plate.nodes)])
        if not lies_under(outline(plate).convex_hull, sums, float(np.abs(f).sum())):
            return True
    return False


def lies_under(hull: BaseGeometry, sums: Array, size: float) -> bool:
    """Return whether pressure under a convex hull has a resultant of force [N] and first moments [N m] (3,).

    The size [N] of what adds up to it says what is rounding.
    """
    from shapely import Point

    force, length = float(sums[0]), math.sqrt(hull.area)
    if abs(force) <= ROUNDING * size:
        return bool(np.abs(sums[1:]).max() <= ROUNDING * size * length)
    return force > 0 and bool(hull.buffer(ROUNDING * length).contains(Point(sums[1:] / force)))


def _pulling_ground(combined: Results) -> Iterator[DesignCheck]:
    """Yield where glued ground pulls most in what is designed for, or in any combination that only it balances."""
    results = [result for result in _glued(combined) if result.limit_state not in _CHECKS]
    lost = [result for result in results if _lost(result)]
    pulled = [
        result for result in lost or ultimate_results(combined) if _pull(result) > ROUNDING * result.certificate.load
    ]
    if not pulled:
        return
    worst = max(pulled, key=_pull)
    plate = worst.plate
    k = int(np.argmin(plate.pressure))
    share = float(plate.area[plate.contact_force < 0].sum() / plate.area.sum())
    words = Message(
        'in "{combination}" the ground pulls at {share:.3g} % of the area, with up to {pressure:.4g kPa} '
        "at {place:.3f m}",
        combination=Name(worst.combination),
        share=100 * share,
        pressure=-plate.pressure[k] / 1e3,
        place=plate.nodes[k],
    )
    held = combined.model.supports or combined.model.plates
    status: Status = "fails" if lost and not held else "attention"
    more = "only that balances the loads" if status == "fails" else GLUED.do
    yield DesignCheck(
        "ground in tension", status, joined((words, more), "; "), combination=worst.combination,
        place=place_of(plate.nodes, k), foundation=True,
    )  # fmt: skip


def _pull(results: CombinationResult) -> float:
    """Return the force with which the ground pulls [N]."""
    return -float(np.minimum(results.plate.contact_force, 0.0).sum())


def _uplift(combined: Results, combinations: list[Combination]) -> dict[str, Any]:
    """Return the forces upwards and downwards [kN] of the worst combination; nothing of several plates or supports."""
    solved = solved_results(combined)
    if combined.model.supports or combined.model.plates or not solved:
        return {}
    forces = column_loads.sum_of_others(solved[0], outline(solved[0].plate), ())
    ratios = []
    for combination in combinations:
        parts = [_Part(case, factor, forces.get(case, 0.0)) for case, factor in combination.factors]
        up, down = -sum(part.design for part in parts if part.up), sum(part.design for part in parts if not part.up)
        ratios.append((up / down if down else float("inf"), up / 1e3, down / 1e3, combination.name, parts))
    _, up, down, worst, parts = max(ratios, key=lambda ratio: ratio[0])
    steps = tuple(_steps(parts, up / 1e3, down / 1e3))
    return {"demand": up, "resistance": down, "unit": "kN", "combination": worst, "steps": steps}


class _Part(NamedTuple):
    """The vertical force of a load case [N], downwards positive, and its factor in a combination."""

    case: str
    factor: float
    force: float

    @property
    def design(self) -> float:
        """Return the force with its factor [N]."""
        return self.factor * self.force

    @property
    def up(self) -> bool:
        """Return whether it acts upwards."""
        return self.design < 0


def _steps(parts: Sequence[_Part], up: float, down: float) -> Iterator[Step]:
    """Yield how forces upwards and downwards [MN] come about, by expression 2.8 with no resistance but weights."""
    terms = dict[bool, list[str]]({True: [], False: []})
    for number, part in enumerate((part for part in parts if part.design), start=1):
        way, letter = ("upwards", "U") if part.up else ("downwards", "G")
        force = abs(part.force) / MEGA
        yield Step(
            Message('vertical force of "{case}", {way}', case=Name(part.case), way=way),
            f"{letter}_{number}",
            force,
            "MN",
        )
        yield Step("its factor", f"gamma_{number}", abs(part.factor), clause="2.4.7.4")
        terms[part.up].append(f"gamma_{number} * {letter}_{number}")
    for is_up, symbol, words, value in (
        (True, "V_dst", "destabilizing force", up),
        (False, "G_stb", "stabilizing force", down),
    ):
        yield Step(
            words,
            symbol,
            value,
            "MN",
            " + ".join(terms[is_up]) or "0",
            "2.4.7.4(1), 2.8",
        )
    if down:
        yield Step("share used", "eta", up / down, "", "V_dst / G_stb", "2.4.7.4(1), 2.8")
