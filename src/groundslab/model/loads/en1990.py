"""Combinations of actions by EN 1990, as factors of the load cases; by ACI 318 and ASCE 7 if those are wanted.

    ultimate           sum gamma_G G + gamma_Q,1 Q_1 + sum gamma_Q,i psi_0,i Q_i     expression 6.10,  6.4.3.2(3)
      or the two of    sum gamma_G G + gamma_Q,1 psi_0,1 Q_1 + sum gamma_Q,i psi_0,i Q_i         6.10a
                       sum xi gamma_G G + gamma_Q,1 Q_1 + sum gamma_Q,i psi_0,i Q_i              6.10b
    accidental         sum G + A_d + (psi_1,1 or psi_2,1) Q_1 + sum psi_2,i Q_i                6.11b, 6.4.3.3(2)
    seismic            sum G + A_Ed + sum psi_2,i Q_i                                          6.12b, 6.4.3.4(2)
    equilibrium        as 6.10 with the factors of Table A1.2(A): EQU                          6.7, 6.4.2(1)
    uplift             as 6.10 with the factors of EN 1997-1 Table A.15: UPL                   EN 1997-1 2.4.7.4
    characteristic     sum G + Q_1 + sum psi_0,i Q_i                                 expression 6.14b, 6.5.3(2)a
    frequent           sum G + psi_1,1 Q_1 + sum psi_2,i Q_i                         expression 6.15b, 6.5.3(2)b
    quasi-permanent    sum G + sum psi_2,i Q_i                                       expression 6.16b, 6.5.3(2)c

On ground without tension effects do not add up, and less load can be worse than more. So every accompanying variable
action is once present and once absent, and every combination is analyzed by itself.

All permanent actions of an ultimate combination are unfavourable together or favourable together, as if they came from
one source (EN 1990, Table A1.2(B), note 3), unless they are wanted separately. Where the result is very sensitive to
permanent actions that differ from place to place, as in static equilibrium and uplift, 6.4.3.1(4) requires their parts
as separate actions: there each is so by itself. xi multiplies unfavourable permanent actions only (Table A1.2(B), note
2). Each accidental action acts alone, each seismic one alone and in both directions.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Literal

from groundslab.errors import InputError, Issue
from groundslab.model.loads import aci318
from groundslab.model.loads.annexes import document_of
from groundslab.model.loads.load_cases import Combination, Combine, LimitState, LoadCase
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.wording import describe

#: Nobody looks at more combinations than this, and each of them is an analysis.
MOST_COMBINATIONS = 500

#: Names of the combinations of a limit state, before their number.
_TITLES: dict[LimitState, str] = {
    "ultimate": "ULS",
    "accidental": "accidental",
    "seismic": "seismic",
    "equilibrium": "EQU",
    "uplift": "UPL",
    "characteristic": "characteristic",
    "frequent": "frequent",
    "quasi-permanent": "quasi-permanent",
}


@dataclass(frozen=True, slots=True)
class _Rule:
    """How a rule combines actions: partial factors, and the factors psi of variable actions by their keys."""

    name: str
    permanent: tuple[float, float]  # unfavourable, favourable
    variable: float
    leading: Literal["", "psi_1", "psi_2"] | None = ""  # "" is the characteristic value; None where no action leads
    accompanying: Literal["psi_0", "psi_2"] = "psi_2"
    separate: bool = False  # each permanent action is unfavourable or favourable by itself


#: Factors of the cases that take part.
Terms = tuple[tuple[str, float], ...]


def make_combinations(combine: Combine, cases: Sequence[LoadCase]) -> tuple[Combination, ...]:
    """Return the combinations of the limit states in ``combine``, in their order, none twice within a limit state.

    Each variable action leads in turn, and none of them; every subset of the others that do not exclude it or each
    other accompanies it (EN 1990 6.4.3.2, 6.5.3). The fullest combination of a leading action comes first. Raises
    InputError where there would be more than MOST_COMBINATIONS.
    """
    combinations: list[Combination] = []
    document = combine.annex is not None and combine.expression != "ACI 318" and document_of(combine.annex)
    national = f", {combine.annex}" if document else ""
    for limit_state in combine.sets:
        seen: set[Terms] = set()
        for rule, terms in _all_terms(combine, cases, limit_state):
            if not terms or terms in seen:
                continue
            seen.add(terms)
            name = f"{_TITLES[limit_state]} {len(seen)}"
            combinations.append(Combination(name=name, limit_state=limit_state, factors=terms, rule=rule + national))
            if len(combinations) > MOST_COMBINATIONS:
                variable = sum(case.action == "variable" for case in cases)
                expected = f"at most {MOST_COMBINATIONS} combinations"
                hint = "write the combinations that matter by hand, or put actions that exclude each other in a group"
                raise InputError([Issue("combine", f"{variable} variable actions", expected, hint)])
    return tuple(combinations)


def _all_terms(combine: Combine, cases: Sequence[LoadCase], limit_state: LimitState) -> Iterator[tuple[str, Terms]]:
    """Yield the factors of each combination of a limit state with its rule; some of them may come twice."""
    if combine.expression == "ACI 318" and limit_state in ("ultimate", "seismic", "characteristic"):
        for name, factors in aci318.combine(cases, limit_state, [*_beside(cases, "seismic")], _subsets):
            yield name, _in_order(cases, factors)
        return
    permanent = [case.name for case in cases if case.action == "permanent"]
    for rule in _rules(combine, limit_state):
        for gammas in _partial_factors(len(permanent), rule.permanent, rule.separate):
            for beside in _beside(cases, limit_state):
                factors = dict(zip(permanent, gammas, strict=True)) | beside
                for terms in _terms(cases, rule, factors):
                    yield rule.name, terms


def _rules(combine: Combine, limit_state: LimitState) -> Iterator[_Rule]:
    """Yield the rules of a limit state."""
    (most, least), gamma_q, ones = combine.permanent, combine.variable[0], (1.0, 1.0)
    if limit_state == "ultimate" and combine.expression == "6.10":
        yield _Rule("EN 1990 6.10", (most, least), gamma_q, "", "psi_0", combine.separate)
    elif limit_state == "ultimate":
        yield _Rule("EN 1990 6.10a", (most, least), gamma_q, None, "psi_0", combine.separate)
        yield _Rule("EN 1990 6.10b", (combine.xi * most, least), gamma_q, "", "psi_0", combine.separate)
    elif limit_state == "accidental":
        yield _Rule("EN 1990 6.11b", ones, 1.0, combine.accidental_leader)
    elif limit_state == "seismic":
        yield _Rule("EN 1990 6.12b", ones, 1.0, None)
    elif limit_state == "equilibrium":
        yield _Rule("EN 1990 6.10, EQU", combine.equilibrium[:2], combine.equilibrium[2], "", "psi_0", separate=True)
    elif limit_state == "uplift":
        yield _Rule("EN 1997-1 2.4.7.4, UPL", combine.uplift[:2], combine.uplift[2], "", "psi_0", separate=True)
    elif limit_state == "characteristic":
        yield _Rule("EN 1990 6.14b", ones, 1.0, "", "psi_0")
    elif limit_state == "frequent":
        yield _Rule("EN 1990 6.15b", ones, 1.0, "psi_1")
    else:
        yield _Rule("EN 1990 6.16b", ones, 1.0, None)


def _beside(cases: Sequence[LoadCase], limit_state: LimitState) -> Iterator[dict[str, float]]:
    """Yield the accidental or seismic action of each combination, with its factor; nothing in other limit states."""
    if limit_state not in ("accidental", "seismic"):
        yield {}
        return
    for case in cases:
        if case.action == limit_state:
            yield {case.name: 1.0}
            if limit_state == "seismic":
                yield {case.name: -1.0}


def _partial_factors(count: int, gammas: tuple[float, float], separate: bool) -> Iterator[tuple[float, ...]]:
    """Yield the partial factors of so many permanent actions: all alike, or each with either."""
    if separate:
        yield from product(gammas, repeat=count)
    else:
        yield from ((gamma,) * count for gamma in gammas)


def _terms(actions: Sequence[LoadCase], rule: _Rule, factors: dict[str, float]) -> Iterator[Terms]:
    """Yield the factors of each combination that are not zero, with those given of other than variable actions.

    Without a leader, as in 6.10a and quasi-permanent combinations, all variable actions accompany.
    """
    variable = [case for case in actions if case.action == "variable"]
    leaders = [None] if rule.leading is None else [*variable, None]
    for leader in leaders:
        # where one action leads in turn, nothing accompanies none
        follow = len(leaders) == 1 or leader is not None
        others = [action for action in variable if follow and _may_join(action, leader)]
        psi: dict[str, float] = {action.name: getattr(action, rule.accompanying) for action in others}
        for company in _subsets([action for action in others if psi[action.name] > 0]):
            chosen = factors | {action.name: rule.variable * psi[action.name] for action in company}
            if leader is not None:
                chosen[leader.name] = rule.variable * (getattr(leader, rule.leading) if rule.leading else 1.0)
            yield _in_order(actions, chosen)


def _in_order(actions: Sequence[LoadCase], factors: Mapping[str, float]) -> Terms:
    """Return factors by case in the order of the cases, those that are not zero."""
    # ten digits, so that 1.5 * 0.6 is 0.9 and not 0.8999999999999999
    rounded = ((action.name, float(f"{factors.get(action.name, 0.0):.10g}")) for action in actions)
    return tuple((name, factor) for name, factor in rounded if factor)


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
                ("cases", position, "name"), describe(case.name), "a name that can be used in a sum", hint
            )
    if not all(named_well) or len({case.name for case in cases}) < len(cases):
        return
    actions = {case.action for case in cases}
    missing = [state for state in ("accidental", "seismic") if state in combine.sets and state not in actions]
    for state in missing:
        yield RelativeIssue(("combine", "sets"), f'"{state}"', f'a case whose action is "{state}"')
    if missing:
        return
    try:
        generated = {combination.name for combination in make_combinations(combine, cases)}
    except InputError as error:
        for issue in error.issues:
            yield RelativeIssue(("combine",), issue.found, issue.expected, issue.hint)
        return
    if not generated:
        yield RelativeIssue(("combine",), "no combination that is not nothing", "factors and shares that are not all 0")
    for position, combination in enumerate(combinations):
        if combination.name in generated:
            generated_name = f"{describe(combination.name)}, which combine makes as well"
            yield RelativeIssue(("combinations", position, "name"), generated_name, "a unique name")
