"""Combinations of actions by EN 1990, each as factors of the load cases.

    ultimate           sum gamma_G G + gamma_Q,1 Q_1 + sum gamma_Q,i psi_0,i Q_i     expression 6.10,  6.4.3.2(3)
      or the two of    sum gamma_G G + gamma_Q,1 psi_0,1 Q_1 + sum gamma_Q,i psi_0,i Q_i         6.10a
                       sum xi gamma_G G + gamma_Q,1 Q_1 + sum gamma_Q,i psi_0,i Q_i              6.10b
    characteristic     sum G + Q_1 + sum psi_0,i Q_i                                 expression 6.14b, 6.5.3(2)a
    frequent           sum G + psi_1,1 Q_1 + sum psi_2,i Q_i                         expression 6.15b, 6.5.3(2)b
    quasi-permanent    sum G + sum psi_2,i Q_i                                       expression 6.16b, 6.5.3(2)c

On ground without tension effects do not add up, and less load can be worse than more. So every accompanying variable
action is once present and once absent, and every combination is analyzed by itself.

All permanent actions of an ultimate combination are unfavourable together or favourable together, as if they came from
one source (EN 1990, Table A1.2(B), note 3), unless they are wanted separately. Where the result is very sensitive to
permanent actions that differ from place to place, as in static equilibrium, 6.4.3.1(4) requires their parts as separate
actions. xi multiplies unfavourable permanent actions only (Table A1.2(B), note 2).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

from groundslab.errors import InputError, Issue
from groundslab.model.loads.load_cases import Combination, Combine, LimitState, LoadCase
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.wording import describe

#: Nobody looks at more combinations than this, and each of them is an analysis.
MOST_COMBINATIONS = 500

#: Names of the combinations of a limit state, before their number.
_TITLES: dict[LimitState, str] = {
    "ultimate": "ULS",
    "characteristic": "characteristic",
    "frequent": "frequent",
    "quasi-permanent": "quasi-permanent",
}


#: The expressions of limit states that are not ultimate (EN 1990 6.5.3(2)).
_RULES: dict[LimitState, str] = {"characteristic": "6.14b", "frequent": "6.15b", "quasi-permanent": "6.16b"}

#: Factors of the cases that take part.
Terms = tuple[tuple[str, float], ...]


def make_combinations(combine: Combine, cases: Sequence[LoadCase]) -> tuple[Combination, ...]:
    """Return the combinations of the limit states in ``combine``, in their order, none twice within a limit state.

    Each variable action leads in turn, and none of them; every subset of the others that do not exclude it or each
    other accompanies it (EN 1990 6.4.3.2, 6.5.3). The fullest combination of a leading action comes first. Raises
    InputError where there would be more than MOST_COMBINATIONS.
    """
    found: list[Combination] = []
    for limit_state in combine.sets:
        seen: set[Terms] = set()
        for rule, terms in _all_terms(combine, cases, limit_state):
            if not terms or terms in seen:
                continue
            seen.add(terms)
            name = f"{_TITLES[limit_state]} {len(seen)}"
            found.append(Combination(name=name, limit_state=limit_state, factors=terms, rule=f"EN 1990 {rule}"))
            if len(found) > MOST_COMBINATIONS:
                variable = sum(case.action == "variable" for case in cases)
                expected = f"at most {MOST_COMBINATIONS} combinations"
                hint = "write the combinations that matter by hand, or put actions that exclude each other in a group"
                raise InputError([Issue("combine", f"{variable} variable actions", expected, hint)])
    return tuple(found)


def _all_terms(combine: Combine, cases: Sequence[LoadCase], limit_state: LimitState) -> Iterator[tuple[str, Terms]]:
    """Yield the factors of each combination of a limit state with its expression; some of them may come twice."""
    permanent = [case.name for case in cases if case.action == "permanent"]
    if limit_state != "ultimate":
        for terms in _terms(cases, limit_state, dict.fromkeys(permanent, 1.0), 1.0, leads=True):
            yield _RULES[limit_state], terms
        return
    most, least = combine.permanent
    reduced = {"6.10": (("6.10", 1.0),), "6.10a and 6.10b": (("6.10a", 1.0), ("6.10b", combine.xi))}
    for rule, xi in reduced[combine.expression]:
        for gammas in _partial_factors(len(permanent), (xi * most, least), combine.separate):
            factors = dict(zip(permanent, gammas, strict=True))
            for terms in _terms(cases, limit_state, factors, combine.variable[0], leads=rule != "6.10a"):
                yield rule, terms


def _partial_factors(count: int, gammas: tuple[float, float], separate: bool) -> Iterator[tuple[float, ...]]:
    """Yield the partial factors of so many permanent actions: all alike, or each with either."""
    if separate:
        yield from product(gammas, repeat=count)
    else:
        yield from ((gamma,) * count for gamma in gammas)


def _terms(
    actions: Sequence[LoadCase], limit_state: LimitState, permanent: dict[str, float], gamma_q: float, leads: bool
) -> Iterator[Terms]:
    """Yield the factors of each combination that are not zero, with those of the permanent actions.

    Without a leader, as in 6.10a and quasi-permanent combinations, all variable actions accompany.
    """
    variable = [case for case in actions if case.action == "variable"]
    leaders = [*variable, None] if leads and limit_state != "quasi-permanent" else [None]
    for leader in leaders:
        # where one action leads in turn, nothing accompanies none
        follow = len(leaders) == 1 or leader is not None
        others = [action for action in variable if follow and _may_join(action, leader)]
        for company in _subsets([action for action in others if _accompanying(action, limit_state) > 0]):
            chosen = permanent | {action.name: gamma_q * _accompanying(action, limit_state) for action in company}
            if leader is not None:
                chosen[leader.name] = gamma_q * _leading(leader, limit_state)
            # ten digits, so that 1.5 * 0.6 is 0.9 and not 0.8999999999999999
            rounded = ((action.name, float(f"{chosen.get(action.name, 0.0):.10g}")) for action in actions)
            yield tuple((name, factor) for name, factor in rounded if factor)


def _leading(action: LoadCase, limit_state: LimitState) -> float:
    """Return what the leading action's characteristic value is multiplied by, beside gamma."""
    return action.psi_1 if limit_state == "frequent" else 1.0


def _accompanying(action: LoadCase, limit_state: LimitState) -> float:
    """Return what an accompanying action's characteristic value is multiplied by, beside gamma."""
    return action.psi_0 if limit_state in ("ultimate", "characteristic") else action.psi_2


def _may_join(action: LoadCase, leader: LoadCase | None) -> bool:
    """Return whether an action can accompany the leading one."""
    return leader is None or (action.name != leader.name and not (action.group and action.group == leader.group))


def _subsets(actions: Sequence[LoadCase]) -> Iterator[tuple[LoadCase, ...]]:
    """Yield all subsets with at most one action of each group, the fullest first."""
    groups: dict[tuple[str, str], list[LoadCase]] = {}
    for action in actions:
        # an action without a group is a group of its own
        groups.setdefault((action.group, "" if action.group else action.name), []).append(action)
    for choice in product(*([*group, None] for group in groups.values())):
        yield tuple(action for action in choice if action is not None)


def check_combine(
    combine: Combine | None, cases: tuple[LoadCase, ...], combinations: tuple[Combination, ...]
) -> Iterator[RelativeIssue]:
    """Find automatic combinations that cannot be made, are too many or none, or share the name of another one."""
    if combine is None:
        return
    if not cases:
        yield RelativeIssue(("combine",), "automatic combinations", "[[cases]] to combine")
        return
    named_well = [bool(case.name) and case.name == " ".join(case.name.split()) and "+" not in case.name.split()
                  for case in cases]  # fmt: skip
    for position, case in enumerate(cases):
        if case.name and not named_well[position]:
            hint = "without outer or double blanks and without a + standing alone"
            yield RelativeIssue(
                ("cases", position, "name"), describe(case.name), "a name that can stand in a sum", hint
            )
    if not all(named_well) or len({case.name for case in cases}) < len(cases):
        return
    try:
        made = {each.name for each in make_combinations(combine, cases)}
    except InputError as error:
        for issue in error.issues:
            yield RelativeIssue(("combine",), issue.found, issue.expected, issue.hint)
        return
    if not made:
        yield RelativeIssue(("combine",), "no combination that is not nothing", "factors and shares that are not all 0")
    for position, combination in enumerate(combinations):
        if combination.name in made:
            found = f"{describe(combination.name)}, which combine makes as well"
            yield RelativeIssue(("combinations", position, "name"), found, "a name of its own")
