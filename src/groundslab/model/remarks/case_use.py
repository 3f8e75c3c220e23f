"""What acts where: the limit states, combinations and factors with which each load case takes part."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from groundslab.messages import Message, counted, joined
from groundslab.model.loads.load_cases import Combination, LimitState, LoadCase
from groundslab.model.loads.patterns import position_names

if TYPE_CHECKING:
    from groundslab.model.model import Model


@dataclass(frozen=True, slots=True)
class Acting:
    """The combinations of one limit state in which a case acts, of all there are, and its factors in them."""

    limit_state: LimitState
    combinations: int
    total: int
    least: float
    greatest: float

    def words(self) -> str:
        """Return it in words, such as "ultimate 1 to 1.35 (4 of 6)"."""
        return Message("{limit_state} {factors}", limit_state=self.limit_state, factors=self.factors())

    def factors(self) -> str:
        """Return the factors alone in words, such as "1 to 1.35 (4 of 6)"."""
        template = "{least:.6g} to {greatest:.6g} ({combinations} of {total})"
        if self.least == self.greatest:
            template = "{least:.6g} ({combinations} of {total})"
        return Message(
            template, least=self.least, greatest=self.greatest, combinations=self.combinations, total=self.total
        )


@dataclass(frozen=True, slots=True)
class CaseUse:
    """A load case as written: how many loads it has, and where it acts.

    A case that moves acts where any of its positions does. ``named`` says whether any combination names the case, be it
    with the factor 0.
    """

    case: LoadCase
    loads: int
    acting: tuple[Acting, ...]
    named: bool

    @property
    def empty(self) -> bool:
        """Return whether nothing is in the case, horizontal forces included."""
        return not self.loads and not self.case.H_x and not self.case.H_y

    def about(self) -> str:
        """Return action and number of loads in words."""
        return counted(self.loads, "{action}, {count} load", "{action}, {count} loads", action=self.case.action)

    def words(self) -> str:
        """Return in words where the case acts."""
        return joined((acting.words() for acting in self.acting), "; ") or "in no combination"


def case_uses(model: Model, combinations: Sequence[Combination]) -> tuple[CaseUse, ...]:
    """Return where each load case of a model acts, among these combinations of it."""
    positions = position_names(model.moves)
    written = {name: moving for moving, names in positions.items() for name in names}
    loads = Counter(load.case for load in (*model.loads, *model.moves))
    totals = Counter(combination.limit_state for combination in combinations)
    factors: dict[tuple[str, LimitState], dict[str, float]] = {}
    named: set[str] = set()
    for combination in combinations:
        for name, factor in combination.factors:
            of = written.get(name, name)
            named.add(of)
            if factor:
                factors.setdefault((of, combination.limit_state), {})[combination.name] = factor
    uses = []
    for case in model.cases:
        by_state = {state: factors[case.name, state] for state in totals if (case.name, state) in factors}
        acting = tuple(
            Acting(state, len(of_state), totals[state], min(of_state.values()), max(of_state.values()))
            for state, of_state in by_state.items()
        )
        uses.append(CaseUse(case, loads[case.name], acting, case.name in named))
    return tuple(uses)
