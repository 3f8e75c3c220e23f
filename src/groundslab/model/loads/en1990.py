"""Combinations of actions by EN 1990, each as factors of the load cases.

    ultimate           sum gamma_G G + gamma_Q,1 Q_1 + sum gamma_Q,i psi_0,i Q_i     expression 6.10,  6.4.3.2(3)
    characteristic     sum G + Q_1 + sum psi_0,i Q_i                                 expression 6.14b, 6.5.3(2)a
    frequent           sum G + psi_1,1 Q_1 + sum psi_2,i Q_i                         expression 6.15b, 6.5.3(2)b
    quasi-permanent    sum G + sum psi_2,i Q_i                                       expression 6.16b, 6.5.3(2)c

On ground that takes no tension effects do not add up, and less load can be worse than more. So every variable action
that accompanies is once there and once not, and every combination has to be analysed on its own.

All permanent actions of an ultimate combination are unfavourable together or favourable together, as if they came from
one source (EN 1990, Table A1.2(B), note 3). That is not enough where the result is very sensitive to permanent actions
that differ from place to place, as in static equilibrium: there 6.4.3.1(4) wants their parts as actions of their own,
and the combinations have to be written by hand.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Literal, get_args

from groundslab.errors import InputError, Issue

Kind = Literal["permanent", "variable"]
LimitState = Literal["ultimate", "characteristic", "frequent", "quasi-permanent"]

#: More combinations than this are no longer looked at by anyone, and each of them is an analysis.
MOST_COMBINATIONS = 500

#: How the combinations of a limit state are called, before their number.
_TITLES: dict[LimitState, str] = {
    "ultimate": "ULS",
    "characteristic": "characteristic",
    "frequent": "frequent",
    "quasi-permanent": "quasi-permanent",
}


@dataclass(frozen=True, slots=True)
class Action:
    """A load case and how it combines: psi_0, psi_1, psi_2 of a variable action (EN 1990 4.1.3, Table A1.1).

    Variable actions of one group that is not empty exclude each other, as wind from the left and from the right.
    """

    name: str
    kind: Kind
    psi_0: float = 1.0
    psi_1: float = 1.0
    psi_2: float = 1.0
    group: str = ""


@dataclass(frozen=True, slots=True)
class Factors:
    """Partial factors, unfavourable and favourable (EN 1990, Table A1.2(B)); favourable variable actions have none."""

    permanent: tuple[float, float] = (1.35, 1.0)
    variable: tuple[float, float] = (1.5, 0.0)


@dataclass(frozen=True, slots=True)
class Combination:
    """A name, the limit state, and the factors that are not zero, in the order of the actions."""

    name: str
    limit_state: LimitState
    factors: tuple[tuple[str, float], ...]

    @property
    def description(self) -> str:
        """Return the combination as a sum, such as "1.35 G + 1.5 Q + 0.9 W"."""
        return " + ".join(f"{factor:.10g} {name}" for name, factor in self.factors)


def combinations(
    actions: Sequence[Action], sets: Sequence[LimitState], factors: Factors | None = None
) -> tuple[Combination, ...]:
    """Return the combinations of the limit states in ``sets``, in their order, none twice within a limit state.

    Each variable action leads in turn, and none of them; every subset of the others that do not exclude it or each
    other accompanies it (EN 1990 6.4.3.2, 6.5.3). The fullest combination of a leading action comes first. Raises
    InputError where there would be more than MOST_COMBINATIONS.
    """
    factors = factors or Factors()
    issues = [*_faults_of_actions(actions), *_faults_of_factors(factors)]
    known = get_args(LimitState)
    issues += [Issue("sets", repr(each), f"one of {', '.join(known)}") for each in sets if each not in known]
    if issues:
        raise InputError(issues)
    found: list[Combination] = []
    for limit_state in dict.fromkeys(sets):
        seen: set[tuple[tuple[str, float], ...]] = set()
        for terms in _terms(actions, limit_state, factors):
            if not terms or terms in seen:
                continue
            seen.add(terms)
            found.append(Combination(f"{_TITLES[limit_state]} {len(seen)}", limit_state, terms))
            if len(found) > MOST_COMBINATIONS:
                variable = sum(action.kind == "variable" for action in actions)
                expected = f"at most {MOST_COMBINATIONS} combinations"
                hint = "write the combinations that matter by hand, or put actions that exclude each other in a group"
                raise InputError([Issue("actions", f"{variable} variable actions", expected, hint)])
    return tuple(found)


def _terms(
    actions: Sequence[Action], limit_state: LimitState, factors: Factors
) -> Iterator[tuple[tuple[str, float], ...]]:
    """Yield the factors of each combination of a limit state; some of them may come twice."""
    variable = [action for action in actions if action.kind == "variable"]
    ultimate = limit_state == "ultimate"
    gamma_q = factors.variable[0] if ultimate else 1.0
    leaders = [None] if limit_state == "quasi-permanent" else [*variable, None]
    for gamma_g in factors.permanent if ultimate else (1.0,):
        for leader in leaders:
            # without a leading action nothing accompanies it, but quasi-permanent values need no leader
            follow = limit_state == "quasi-permanent" or leader is not None
            others = [action for action in variable if follow and _may_join(action, leader)]
            for company in _subsets([action for action in others if _accompanying(action, limit_state) > 0]):
                chosen = {action.name: gamma_q * _accompanying(action, limit_state) for action in company}
                if leader is not None:
                    chosen[leader.name] = gamma_q * _leading(leader, limit_state)
                chosen |= {action.name: gamma_g for action in actions if action.kind == "permanent"}
                # ten digits, so that 1.5 * 0.6 is 0.9 and not 0.8999999999999999
                rounded = ((action.name, float(f"{chosen.get(action.name, 0.0):.10g}")) for action in actions)
                yield tuple((name, factor) for name, factor in rounded if factor)


def _leading(action: Action, limit_state: LimitState) -> float:
    """Return what the leading action's characteristic value is multiplied by, beside gamma."""
    return action.psi_1 if limit_state == "frequent" else 1.0


def _accompanying(action: Action, limit_state: LimitState) -> float:
    """Return what an accompanying action's characteristic value is multiplied by, beside gamma."""
    return action.psi_0 if limit_state in ("ultimate", "characteristic") else action.psi_2


def _may_join(action: Action, leader: Action | None) -> bool:
    """Return whether an action can accompany the leading one."""
    return leader is None or (action.name != leader.name and not (action.group and action.group == leader.group))


def _subsets(actions: Sequence[Action]) -> Iterator[tuple[Action, ...]]:
    """Yield all subsets with at most one action of each group, the fullest first."""
    groups: dict[tuple[str, str], list[Action]] = {}
    for action in actions:
        # an action without a group is a group of its own
        groups.setdefault((action.group, "" if action.group else action.name), []).append(action)
    for choice in product(*([*group, None] for group in groups.values())):
        yield tuple(action for action in choice if action is not None)


def _faults_of_actions(actions: Sequence[Action]) -> list[Issue]:
    """Return what is wrong with the actions."""
    issues: list[Issue] = []
    names = [action.name for action in actions]
    for i, action in enumerate(actions):
        where = f"action[{i}]"
        if not action.name or action.name != " ".join(action.name.split()) or "+" in action.name.split():
            hint = "give it a name without outer or double blanks and without a + standing alone"
            issues.append(Issue(f"{where}.name", repr(action.name), "a name that can stand in a sum", hint))
        if action.name in names[:i]:
            issues.append(Issue(f"{where}.name", repr(action.name), "a name that no other action has"))
        if action.kind not in get_args(Kind):
            issues.append(Issue(f"{where}.kind", repr(action.kind), f"one of {', '.join(get_args(Kind))}"))
        values = {psi: getattr(action, psi) for psi in ("psi_0", "psi_1", "psi_2")}
        outside = {psi: value for psi, value in values.items() if not 0 <= value <= 1}
        issues += [Issue(f"{where}.{psi}", f"{value:g}", "a number from 0 to 1") for psi, value in outside.items()]
        if action.psi_2 > action.psi_1:
            found = f"psi_2 = {action.psi_2:g}, psi_1 = {action.psi_1:g}"
            hint = "the quasi-permanent value is exceeded more often than the frequent one (EN 1990 4.1.3)"
            issues.append(Issue(where, found, "psi_2 not larger than psi_1", hint))
    return issues


def _faults_of_factors(factors: Factors) -> list[Issue]:
    """Return what is wrong with the partial factors."""
    issues: list[Issue] = []
    for name in ("permanent", "variable"):
        unfavourable, favourable = getattr(factors, name)
        if not 0 <= favourable <= unfavourable < float("inf"):
            found = f"{unfavourable:g} and {favourable:g}"
            issues.append(
                Issue(f"factors.{name}", found, "first the larger one, unfavourable; neither of them negative")
            )
    if factors.variable[1] != 0:
        hint = "favourable variable actions are left out (EN 1990, Table A1.2(B))"
        issues.append(Issue("factors.variable", f"{factors.variable[1]:g} where favourable", "0", hint))
    return issues
