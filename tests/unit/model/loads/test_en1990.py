"""Combinations of actions: the classic sums of EN 1990, written out by hand, and what never may come together."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.errors import InputError
from groundslab.model.consistency import check_load_cases
from groundslab.model.loads.en1990 import MOST_COMBINATIONS, check_combine, make_combinations
from groundslab.model.loads.load_cases import Combination, Combine, LoadCase
from helpers.examples import examples

SETS = ("ultimate", "characteristic", "frequent", "quasi-permanent")


def action(
    name: str, kind: str, psi_0: float = 1.0, psi_1: float = 1.0, psi_2: float = 1.0, group: str = ""
) -> LoadCase:
    """Return a load case; all psi are 1 by default."""
    return LoadCase(name=name, action=kind, psi_0=psi_0, psi_1=psi_1, psi_2=psi_2, group=group)


G = action("G", "permanent")
#: Offices and wind, with the psi of EN 1990, Table A1.1.
Q = action("Q", "variable", 0.7, 0.5, 0.3)
W = action("W", "variable", 0.6, 0.2, 0.0)


def combinations(cases: list[LoadCase], sets: object, factors: dict[str, tuple[float, float]] | None = None) -> tuple:
    """Return the combinations of some limit states."""
    return make_combinations(Combine(sets=tuple(sets), **(factors or {})), cases)


def description(combination: Combination) -> str:
    """Return a combination as a sum, such as "1.35 G + 1.5 Q"."""
    return " + ".join(f"{factor:.10g} {name}" for name, factor in combination.factors)


def sums(cases: list[LoadCase], *sets: str, factors: dict[str, tuple[float, float]] | None = None) -> list[str]:
    """Return the combinations as sums."""
    return [description(each) for each in combinations(cases, sets, factors)]


def test_ultimate_by_hand() -> None:
    """Expression 6.10 for G, Q and W: each leads in turn, the other joins or not, G unfavourable, then favourable."""
    assert sums([G, Q, W], "ultimate") == [
        "1.35 G + 1.5 Q + 0.9 W",
        "1.35 G + 1.5 Q",
        "1.35 G + 1.05 Q + 1.5 W",
        "1.35 G + 1.5 W",
        "1.35 G",
        "1 G + 1.5 Q + 0.9 W",
        "1 G + 1.5 Q",
        "1 G + 1.05 Q + 1.5 W",
        "1 G + 1.5 W",
        "1 G",
    ]


def test_two_expressions_by_hand() -> None:
    """6.10a: all variable actions accompany; 6.10b: one leads, unfavourable G times xi = 0.85, favourable G not."""
    given = Combine(sets=("ultimate",), expression="6.10a and 6.10b")
    made = make_combinations(given, [G, Q, W])
    assert [(each.rule, description(each)) for each in made] == [
        ("EN 1990 6.10a", "1.35 G + 1.05 Q + 0.9 W"),
        ("EN 1990 6.10a", "1.35 G + 1.05 Q"),
        ("EN 1990 6.10a", "1.35 G + 0.9 W"),
        ("EN 1990 6.10a", "1.35 G"),
        ("EN 1990 6.10a", "1 G + 1.05 Q + 0.9 W"),
        ("EN 1990 6.10a", "1 G + 1.05 Q"),
        ("EN 1990 6.10a", "1 G + 0.9 W"),
        ("EN 1990 6.10a", "1 G"),
        ("EN 1990 6.10b", "1.1475 G + 1.5 Q + 0.9 W"),
        ("EN 1990 6.10b", "1.1475 G + 1.5 Q"),
        ("EN 1990 6.10b", "1.1475 G + 1.05 Q + 1.5 W"),
        ("EN 1990 6.10b", "1.1475 G + 1.5 W"),
        ("EN 1990 6.10b", "1.1475 G"),
        ("EN 1990 6.10b", "1 G + 1.5 Q + 0.9 W"),
        ("EN 1990 6.10b", "1 G + 1.5 Q"),
        ("EN 1990 6.10b", "1 G + 1.05 Q + 1.5 W"),
        ("EN 1990 6.10b", "1 G + 1.5 W"),
    ]


def test_permanent_actions_one_by_one() -> None:
    """Each of two is unfavourable or favourable by itself: four sums, and none of them twice."""
    given = Combine(sets=("ultimate", "characteristic"), separate=True)
    found = [description(each) for each in make_combinations(given, [G, action("B", "permanent")])]
    assert found == ["1.35 G + 1.35 B", "1.35 G + 1 B", "1 G + 1.35 B", "1 G + 1 B", "1 G + 1 B"]


def test_rules_are_told() -> None:
    """Each combination names its expression."""
    rules = [each.rule for each in combinations([G], SETS)]
    assert rules == ["EN 1990 6.10", "EN 1990 6.10", "EN 1990 6.14b", "EN 1990 6.15b", "EN 1990 6.16b"]


def test_serviceability_by_hand() -> None:
    """Expressions 6.14b, 6.15b and 6.16b for G, Q and W; W has psi_2 = 0 and so vanishes where it accompanies."""
    assert sums([G, Q, W], "characteristic") == [
        "1 G + 1 Q + 0.6 W",
        "1 G + 1 Q",
        "1 G + 0.7 Q + 1 W",
        "1 G + 1 W",
        "1 G",
    ]
    assert sums([G, Q, W], "frequent") == ["1 G + 0.5 Q", "1 G + 0.3 Q + 0.2 W", "1 G + 0.2 W", "1 G"]
    assert sums([G, Q, W], "quasi-permanent") == ["1 G + 0.3 Q", "1 G"]


def test_accidental_by_hand() -> None:
    """6.11b: each accidental action alone; the leading variable one with psi_1 or psi_2, the others with psi_2."""
    cases = [G, Q, W, action("A", "accidental"), action("B", "accidental")]
    assert sums(cases, "accidental") == [
        "1 G + 0.5 Q + 1 A",
        "1 G + 0.3 Q + 0.2 W + 1 A",
        "1 G + 0.2 W + 1 A",
        "1 G + 1 A",
        "1 G + 0.5 Q + 1 B",
        "1 G + 0.3 Q + 0.2 W + 1 B",
        "1 G + 0.2 W + 1 B",
        "1 G + 1 B",
    ]
    quasi_permanent = Combine(sets=("accidental",), accidental_leader="psi_2")
    found = [description(each) for each in make_combinations(quasi_permanent, cases[:4])]
    assert found == ["1 G + 0.3 Q + 1 A", "1 G + 1 A"]


def test_seismic_by_hand() -> None:
    """6.12b: all variable actions with psi_2, the seismic one in both directions."""
    found = sums([G, Q, W, action("E", "seismic")], "seismic")
    assert found == ["1 G + 0.3 Q + 1 E", "1 G + 1 E", "1 G + 0.3 Q + -1 E", "1 G + -1 E"]


def test_equilibrium_and_uplift_by_hand() -> None:
    """EQU with 1.1, 0.9 and 1.5, UPL with 1.0, 0.9 and 1.5: each permanent action is unfavourable or favourable."""
    cases = [G, action("water", "permanent"), W]
    assert sums(cases, "equilibrium") == [
        "1.1 G + 1.1 water + 1.5 W", "1.1 G + 1.1 water", "1.1 G + 0.9 water + 1.5 W", "1.1 G + 0.9 water",
        "0.9 G + 1.1 water + 1.5 W", "0.9 G + 1.1 water", "0.9 G + 0.9 water + 1.5 W", "0.9 G + 0.9 water",
    ]  # fmt: skip
    assert sums(cases[:2], "uplift") == ["1 G + 1 water", "1 G + 0.9 water", "0.9 G + 1 water", "0.9 G + 0.9 water"]
    rules = {each.rule for each in combinations(cases, ["equilibrium", "uplift"])}
    assert rules == {"EN 1990 6.10, EQU", "EN 1997-1 2.4.7.4, UPL"}


def test_rare_actions_take_part_in_their_own_combinations_only() -> None:
    """Accidental and seismic actions are in no combination of another limit state."""
    others = ("ultimate", "equilibrium", "uplift", "characteristic", "frequent", "quasi-permanent")
    cases = [G, Q, action("A", "accidental"), action("E", "seismic")]
    assert sums(cases, *others) == sums([G, Q], *others)
    assert not any("E" in each for each in sums(cases, "accidental"))


@pytest.mark.parametrize("state", ["accidental", "seismic"])
def test_no_rare_action(state: str) -> None:
    """A limit state whose action is missing is an error that says which action it needs."""
    (issue,) = check_combine(Combine(sets=("ultimate", state)), (G, Q), ())
    assert issue.place == ("combine", "sets")
    assert issue.expected == f'a case whose action is "{state}"'


def test_names_and_limit_states() -> None:
    """Combinations are numbered within their limit state, limit states come in the given order, each once."""
    with pytest.raises(InputError, match="each value at most once"):
        combinations([G, Q], ["quasi-permanent", "ultimate", "quasi-permanent"])
    found = combinations([G, Q], ["quasi-permanent", "ultimate"])
    assert [each.name for each in found] == [
        "quasi-permanent 1",
        "quasi-permanent 2",
        *(f"ULS {n}" for n in range(1, 5)),
    ]
    assert [each.limit_state for each in found] == ["quasi-permanent"] * 2 + ["ultimate"] * 4


def test_permanent_actions_come_from_one_source() -> None:
    """Several permanent actions are all unfavourable or all favourable, never mixed."""
    found = sums([G, action("walls", "permanent"), Q], "ultimate")
    assert found == [
        "1.35 G + 1.35 walls + 1.5 Q",
        "1.35 G + 1.35 walls",
        "1 G + 1 walls + 1.5 Q",
        "1 G + 1 walls",
    ]


def test_other_partial_factors() -> None:
    """Given factors take the place of the recommended ones, also where a favourable permanent action is left out."""
    found = sums([G, Q], "ultimate", factors={"permanent": (1.1, 0.9), "variable": (1.3, 0.0)})
    assert found == ["1.1 G + 1.3 Q", "1.1 G", "0.9 G + 1.3 Q", "0.9 G"]
    assert sums([G, Q], "ultimate", factors={"permanent": (1.35, 0.0)}) == [
        "1.35 G + 1.5 Q",
        "1.35 G",
        "1.5 Q",
    ]


def test_winds_of_one_group_by_hand() -> None:
    """Wind from the left and from the right never blow at once, whether leading or accompanying."""
    left, right = (action(f"wind {side}", "variable", 0.6, 0.2, 0.0, group="wind") for side in ("left", "right"))
    assert sums([G, Q, left, right], "characteristic") == [
        "1 G + 1 Q + 0.6 wind left",
        "1 G + 1 Q + 0.6 wind right",
        "1 G + 1 Q",
        "1 G + 0.7 Q + 1 wind left",
        "1 G + 1 wind left",
        "1 G + 0.7 Q + 1 wind right",
        "1 G + 1 wind right",
        "1 G",
    ]


def test_same_sums_come_once() -> None:
    """With psi_0 = 1 it does not matter which action leads."""
    found = sums([G, action("A", "variable"), action("B", "variable")], "characteristic")
    assert found == ["1 G + 1 A + 1 B", "1 G + 1 A", "1 G + 1 B", "1 G"]


PSI = st.sampled_from([0.0, 0.2, 0.3, 0.5, 0.6, 0.7, 1.0])


@st.composite
def lists_of_actions(draw) -> list[LoadCase]:
    """Draw up to two permanent and four variable actions, in any order, some of them in groups."""
    actions = [action(f"dead +{n}", "permanent") for n in range(draw(st.integers(0, 2)))]
    for n in range(draw(st.integers(0, 4))):
        psi_2, psi_1 = sorted([draw(PSI), draw(PSI)])
        actions.append(action(f"live {n}", "variable", draw(PSI), psi_1, psi_2, draw(st.sampled_from(["", "a", "b"]))))
    return draw(st.permutations(actions))


def by_brute_force(actions: list[LoadCase], limit_state: str) -> set[frozenset[tuple[str, float]]]:
    """Return all combinations by trying every role (leads, accompanies, absent) of every variable action."""
    variable = [action for action in actions if action.action == "variable"]
    found = set()
    for roles in itertools.product(["leads", "joins", "absent"], repeat=len(variable)):
        present = [action for action, role in zip(variable, roles, strict=True) if role != "absent"]
        groups = [action.group for action in present if action.group]
        leads = roles.count("leads")
        needs_leader = limit_state != "quasi-permanent" and present
        if len(groups) > len(set(groups)) or leads != (1 if needs_leader else 0):
            continue
        for gamma_g, gamma_q in [(1.35, 1.5), (1.0, 1.5)] if limit_state == "ultimate" else [(1.0, 1.0)]:
            sum_ = {action.name: gamma_g for action in actions if action.action == "permanent"}
            for action, role in zip(variable, roles, strict=True):
                psi = {
                    ("ultimate", "leads"): 1.0,
                    ("ultimate", "joins"): action.psi_0,
                    ("characteristic", "leads"): 1.0,
                    ("characteristic", "joins"): action.psi_0,
                    ("frequent", "leads"): action.psi_1,
                    ("frequent", "joins"): action.psi_2,
                    ("quasi-permanent", "joins"): action.psi_2,
                }.get((limit_state, role), 0.0)
                if psi:
                    sum_[action.name] = round(gamma_q * psi, 6)
            if sum_:
                found.add(frozenset(sum_.items()))
    return found


@pytest.mark.slow
@settings(max_examples=examples(100), deadline=None, derandomize=True)
@given(lists_of_actions(), st.sampled_from(SETS))
def test_all_combinations_and_no_others(actions: list[LoadCase], limit_state: str) -> None:
    """Each combination comes exactly once, in the order of the actions."""
    found = combinations(actions, [limit_state])
    order = [action.name for action in actions]
    for each in found:
        names = [name for name, _ in each.factors]
        assert names == sorted(names, key=order.index)
    assert len({each.name for each in found}) == len(found)
    sets = [frozenset(each.factors) for each in found]
    assert len(set(sets)) == len(sets)
    assert set(sets) == by_brute_force(actions, limit_state)


@pytest.mark.slow
def test_too_many_are_refused() -> None:
    """Six variable actions give 2 (1 + 6 * 32) = 386 ultimate combinations, seven 898; sixty are refused at once."""
    many = [action(f"Q{n}", "variable", 0.7, 0.5, 0.3) for n in range(60)]
    assert len(combinations([G, *many[:6]], ["ultimate"])) == 386 <= MOST_COMBINATIONS
    for count in (7, 60):
        with pytest.raises(InputError, match=f"found {count} variable actions, .* by hand"):
            combinations([G, *many[:count]], ["ultimate"])
    with pytest.raises(InputError, match="at most 500"):
        combinations([G, *many[:6]], SETS)


def test_many_that_exclude_each_other_are_allowed() -> None:
    """Sixty places of a crane are one choice: 2 (1 + 60) combinations."""
    places = [action(f"crane at {n}", "variable", 0.7, 0.5, 0.3, group="crane") for n in range(60)]
    assert len(combinations([G, *places], ["ultimate"])) == 122


@pytest.mark.parametrize(
    ("values", "message"),
    [
        (("Q", "snow"), r'action: found "snow", expected "permanent", "variable", "accidental" or "seismic"'),
        (("Q", "variable", 1.2), "psi_0: found 1.2"),
        (("Q", "variable", float("nan")), "psi_0: found nan"),
        (("Q", "variable", 0.7, 0.3, 0.5), "psi_2: found 0.5, expected at most psi_1"),
    ],
)
def test_faulty_actions(values: tuple, message: str) -> None:
    """What cannot be combined is refused and named."""
    with pytest.raises(InputError, match=message):
        action(*values)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("", "a name"),
        ("Q + W", "a name that can be used in a sum"),
        (" Q", "a name that can be used in a sum"),
        ("G", "a unique name"),
    ],
)
def test_faulty_names(name: str, expected: str) -> None:
    """Load cases without a name of their own, or with one that cannot stand in a sum, are not combined."""
    cases = (G, action(name, "variable"))
    found = [*check_combine(Combine(sets=("ultimate",)), cases, ()), *check_load_cases((), cases)]
    assert [(issue.place, issue.expected) for issue in found] == [(("cases", 1, "name"), expected)]


@pytest.mark.parametrize(
    ("factors", "message"),
    [
        ({"permanent": (1.0, 1.35)}, "the unfavourable factor first"),
        ({"variable": (1.5, 0.5)}, "favourable are left out"),
        ({"permanent": (1.35, -1.0)}, "a number at least 0"),
    ],
)
def test_faulty_factors(factors: dict[str, tuple[float, float]], message: str) -> None:
    """Swapped or negative factors are refused, and factors for favourable variable actions."""
    with pytest.raises(InputError, match=message):
        combinations([G, Q], ["ultimate"], factors)


def test_all_faults_come_at_once() -> None:
    """An unknown limit state is named together with the other issues."""
    with pytest.raises(InputError) as error:
        combinations([G, Q], ["ultimate", "final"], {"permanent": (1.0, 1.35), "variable": (1.5, -0.5)})
    assert [issue.location for issue in error.value.issues] == ["Combine.sets[2]", "Combine.variable[2]"]


@pytest.mark.parametrize(
    ("category", "psi"),
    [
        ("A", "0.7 0.5 0.3"), ("B", "0.7 0.5 0.3"), ("C", "0.7 0.7 0.6"), ("D", "0.7 0.7 0.6"), ("E", "1.0 0.9 0.8"),
        ("F", "0.7 0.7 0.6"), ("G", "0.7 0.5 0.3"), ("H", "0 0 0"), ("snow", "0.5 0.2 0"),
        ("snow above 1000 m", "0.7 0.5 0.2"), ("wind", "0.6 0.2 0"), ("temperature", "0.6 0.5 0"),
        ("settlement", "1 1 1"),
    ],
)  # fmt: skip
def test_psi_by_category(category: str, psi: str) -> None:
    """EN 1990 Table A1.1 as printed, settlements by DIN EN 1990/NA.

    A psi that is given comes first, and another category brings its own.
    """
    case = LoadCase(name="Q", action="variable", category=category)
    assert (case.psi_0, case.psi_1, case.psi_2) == tuple(map(float, psi.split()))
    own = LoadCase(name="Q", action="variable", category=category, psi_0=0.95)
    assert (own.psi_0, own.psi_1) == (0.95, case.psi_1)
    assert own.replace(category="wind") == LoadCase(name="Q", action="variable", category="wind")
    assert case.replace(psi_2=0.0).psi_1 == case.psi_1


def test_a_case_without_category_keeps_its_psi() -> None:
    """0.7, 0.5 and 0.3 as ever; a category that is not there is refused."""
    case = LoadCase(name="Q", action="variable")
    assert (case.psi_0, case.psi_1, case.psi_2, case.category) == (0.7, 0.5, 0.3, None)
    with pytest.raises(InputError, match="category"):
        LoadCase(name="Q", category="K")


def aci(*cases: LoadCase, state: str = "ultimate") -> dict[str, set[tuple[tuple[str, float], ...]]]:
    """Return the factors of the combinations by ACI 318, by their equation."""
    found: dict[str, set[tuple[tuple[str, float], ...]]] = {}
    for each in make_combinations(Combine(sets=(state,), expression="ACI 318"), cases):
        found.setdefault(each.rule.removeprefix("ACI 318-19 "), set()).add(each.factors)
    return found


def test_combinations_of_aci_318() -> None:
    """Dead, live, snow and wind: all of ACI 318-19 5.3.1 by hand, every variable load once present and once absent."""
    D, L = LoadCase(name="D"), LoadCase(name="L", action="variable", category="B")
    S = LoadCase(name="S", action="variable", category="snow")
    W = LoadCase(name="W", action="variable", category="wind")
    found = aci(D, L, S, W)
    assert found["5.3.1a"] == {(("D", 1.4),)}
    dead = ("D", 1.2)
    assert found["5.3.1b"] == {(dead, ("L", 1.6), ("S", 0.5)), (dead, ("L", 1.6)), (dead, ("S", 0.5)), (dead,)}
    full = {(dead, ("L", 1.0), ("S", 1.6)), (dead, ("S", 1.6), ("W", 0.5)), (dead, ("S", 1.6)), (dead, ("W", 0.5))}
    assert found["5.3.1c"] == full | {(dead, ("L", 1.0))}
    assert (dead, ("L", 1.0), ("S", 0.5), ("W", 1.0)) in found["5.3.1d"]
    assert found["5.3.1f"] == {(("D", 0.9), ("W", 1.0)), (("D", 0.9),)}


def test_earthquakes_of_aci_318() -> None:
    """1.2 D + E + L + 0.2 S and 0.9 D + E, in both directions; they are a set of their own."""
    D, L = LoadCase(name="D"), LoadCase(name="L", action="variable")
    S, quake = LoadCase(name="S", action="variable", category="snow"), LoadCase(name="E", action="seismic")
    found = aci(D, L, S, quake, state="seismic")
    for sign in (1.0, -1.0):
        assert (("D", 1.2), ("L", 1.0), ("S", 0.2), ("E", sign)) in found["5.3.1e"]
        assert (("D", 0.9), ("E", sign)) in found["5.3.1g"]
    assert not [each for each in aci(D, L, S, quake).values() for factors in each if "E" in dict(factors)]


def asce(*cases: LoadCase) -> dict[str, set[tuple[tuple[str, float], ...]]]:
    """Return the factors of the characteristic combinations with ACI 318, by their equation."""
    found: dict[str, set[tuple[tuple[str, float], ...]]] = {}
    for each in make_combinations(Combine(sets=("characteristic",), expression="ACI 318"), cases):
        assert each.limit_state == "characteristic"
        assert each.rule.startswith("ASCE 7-16 2.4.")
        found.setdefault(each.rule.rpartition(" ")[2], set()).add(each.factors)
    return found


def test_soil_pressures_with_aci_318_are_those_of_allowable_stresses() -> None:
    """ASCE 7-16 2.4.1 by hand: 1 to 7; wind takes 0.6, and 0.45 beside 0.75 of live load and snow. No psi."""
    D, L = LoadCase(name="D"), LoadCase(name="L", action="variable", category="B")
    S = LoadCase(name="S", action="variable", category="snow")
    W = LoadCase(name="W", action="variable", category="wind")
    found = asce(D, L, S, W)
    dead = ("D", 1.0)
    assert found["1"] == {(dead,)}
    assert found["2"] == {(dead, ("L", 1.0))}
    assert found["3"] == {(dead, ("S", 1.0))}
    assert found["4"] == {(dead, ("L", 0.75), ("S", 0.75)), (dead, ("L", 0.75)), (dead, ("S", 0.75))}
    assert found["5"] == {(dead, ("W", 0.6))}
    assert (dead, ("L", 0.75), ("S", 0.75), ("W", 0.45)) in found["6"]
    assert found["7"] == {(("D", 0.6), ("W", 0.6)), (("D", 0.6),)}


def test_earthquakes_with_allowable_stresses() -> None:
    """ASCE 7-16 2.4.5: D + 0.7 E, D + 0.525 E + 0.75 L + 0.75 S and 0.6 D + 0.7 E, in both directions."""
    D, L = LoadCase(name="D"), LoadCase(name="L", action="variable")
    S, quake = LoadCase(name="S", action="variable", category="snow"), LoadCase(name="E", action="seismic")
    found = asce(D, L, S, quake)
    for sign in (1.0, -1.0):
        assert (("D", 1.0), ("E", sign * 0.7)) in found["8"]
        assert (("D", 1.0), ("L", 0.75), ("S", 0.75), ("E", sign * 0.525)) in found["9"]
        assert (("D", 0.6), ("E", sign * 0.7)) in found["10"]


def test_what_aci_318_has_no_combination_for() -> None:
    """Temperature is ruled elsewhere (5.3.6), partial factors of EN 1990 have no part in it."""
    with pytest.raises(InputError, match="temperature"):
        aci(LoadCase(name="D"), LoadCase(name="T", action="variable", category="temperature"))
    with pytest.raises(InputError, match="permanent with ACI 318"):
        Combine(sets=("ultimate",), expression="ACI 318", permanent=(1.2, 0.9))
