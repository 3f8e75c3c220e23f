"""Load cases and their factored combinations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set
from typing import Annotated, Any, ClassVar, Literal, Self

from groundslab.errors import Repair
from groundslab.model.loads.annexes import AnnexName, factors_of, psi_of
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Boolean, Choice, Factors, ListOf, Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.repairs import add_item, remove, rename_key, use_nearest
from groundslab.schema.wording import describe, find_nearest, one_of, suggestion

Kind = Literal["permanent", "variable", "accidental", "seismic"]
LimitState = Literal[
    "ultimate", "accidental", "seismic", "equilibrium", "uplift", "characteristic", "frequent", "quasi-permanent"
]
#: Limit states in which strength is checked, of the slab and of the ground, and those of serviceability.
STRENGTH: tuple[LimitState, ...] = ("ultimate", "accidental", "seismic")
SERVICEABILITY: tuple[LimitState, ...] = ("characteristic", "frequent", "quasi-permanent")
Expression = Literal["6.10", "6.10a and 6.10b", "ACI 318"]

Category = Literal[
    "A", "B", "C", "D", "E", "F", "G", "H", "snow", "snow above 1000 m", "wind", "temperature", "settlement"
]  # fmt: skip
#: psi_0, psi_1 and psi_2 by category of action, the recommended values of EN 1990 Table A1.1; settlements of the ground
#: have those of DIN EN 1990/NA, as they stay.
PSI: Mapping[str, tuple[float, float, float]] = {
    "A": (0.7, 0.5, 0.3), "B": (0.7, 0.5, 0.3), "C": (0.7, 0.7, 0.6), "D": (0.7, 0.7, 0.6), "E": (1.0, 0.9, 0.8),
    "F": (0.7, 0.7, 0.6), "G": (0.7, 0.5, 0.3), "H": (0.0, 0.0, 0.0), "snow": (0.5, 0.2, 0.0),
    "snow above 1000 m": (0.7, 0.5, 0.2), "wind": (0.6, 0.2, 0.0), "temperature": (0.6, 0.5, 0.0),
    "settlement": (1.0, 1.0, 1.0),
}  # fmt: skip

SHARE = Range(at_least=0, at_most=1)
PARTIAL = Range(at_least=0, at_most=100)


def _check_psi(action: str, psi_1: float, psi_2: float) -> Iterator[RelativeIssue]:
    if action == "variable" and psi_2 > psi_1:
        hint = "the quasi-permanent value is exceeded more often than the frequent one (EN 1990, 4.1.3)"
        yield RelativeIssue(("psi_2",), repr(psi_2), f"at most psi_1, {psi_1!r}", hint)


class LoadCase(Section):
    """Loads that always act together."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_psi,)
    only_if: ClassVar[Mapping[tuple[str, str], tuple[str, ...]]] = {
        ("action", "variable"): ("category", "psi_0", "psi_1", "psi_2", "group")
    }

    name: Annotated[str, Text("name of the case, used by loads and combinations")]
    action: Annotated[Kind, Choice(Kind, "kind of action, for automatic combinations")] = "permanent"
    category: Annotated[
        Category | None,
        Choice(
            Category,
            "category of a variable action, for psi of EN 1990 Table A1.1 unless given",
            "give psi_0, psi_1 and psi_2 of any other action",
        ),
    ] = None
    psi_0: Annotated[float, Number("psi_0", "factor of its combination value, if variable", SHARE)] = 0.7
    psi_1: Annotated[float, Number("psi_1", "factor of its frequent value, if variable", SHARE)] = 0.5
    psi_2: Annotated[float, Number("psi_2", "factor of its quasi-permanent value, if variable", SHARE)] = 0.3
    group: Annotated[
        str, Text("variable cases of one group never act together, such as wind from the left and from the right")
    ] = ""
    H_x: Annotated[
        float,
        Quantity("force", "H_x", "horizontal force on the slab along x, for sliding and bearing", example="100 kN"),
    ] = 0.0
    H_y: Annotated[float, Quantity("force", "H_y", "horizontal force on the slab along y", example="100 kN")] = 0.0

    @classmethod
    def derive(cls, values: dict[str, Any], named: Set[Any]) -> dict[str, Any]:
        """Fill in the psi that are not given, by the category."""
        psi = _psi_of_category(values.get("category"))
        return {**values, **{name: value for name, value in psi.items() if name not in named}}

    def by_annex(self, annex: str) -> Self:
        """Return the case with the psi of a national annex, but for those that it gives itself."""
        return self.with_derived(_psi_of_category(self.category, annex))

    def replace(self, **changes: Any) -> Self:
        """Return a copy with some fields changed, validated again; another category brings its psi.

        Parameters
        ----------
        **changes
            New values by field name; None resets a field to its default.
        """
        reset = dict.fromkeys(("psi_0", "psi_1", "psi_2")) if "category" in changes else {}
        return super().replace(**{**reset, **changes})


def _psi_of_category(category: str | None, annex: str = "recommended") -> dict[str, float]:
    """Return the psi of a category by an annex, by their keys; none without category."""
    values = () if category is None else psi_of(annex).get(category, PSI[category])
    return dict(zip(("psi_0", "psi_1", "psi_2"), values, strict=False))


def _check_factors(factors: tuple[tuple[str, float], ...]) -> Iterator[RelativeIssue]:
    if not any(value for _, value in factors):
        yield RelativeIssue(("factors",), "no factor that is not 0", "a factor for at least one case")


class Combination(Section):
    """Load cases that act together, each with a factor."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_factors,)

    name: Annotated[str, Text("name of the combination")]
    limit_state: Annotated[LimitState, Choice(LimitState, "its limit state", "")] = "ultimate"
    factors: Annotated[
        tuple[tuple[str, float], ...], Factors("", "factor of each case that takes part, by the case's name")
    ]
    rule: Annotated[str, Text("rule that it follows, for reference, such as EN 1990 6.10")] = ""


#: Keys of automatic combinations that are national parameters.
NATIONAL = ("expression", "xi", "permanent", "variable", "equilibrium", "uplift")


def _check_partial_factors(
    permanent: tuple[float, float],
    variable: tuple[float, float],
    equilibrium: tuple[float, float, float],
    uplift: tuple[float, float, float],
) -> Iterator[RelativeIssue]:
    pairs = {"permanent": permanent, "variable": variable, "equilibrium": equilibrium[:2], "uplift": uplift[:2]}
    for name, (most, least) in pairs.items():
        if least > most:
            yield RelativeIssue((name,), f"[{most!r}, {least!r}]", "the unfavourable factor first, the larger one")
    if variable[1] != 0:
        hint = "variable actions that are favourable are left out (EN 1990, Table A1.2(B))"
        yield RelativeIssue(("variable", 1), repr(variable[1]), "0", hint)


def _partial_factors(symbol: str, kind: Kind) -> ListOf:
    meaning = f"partial factors of {kind} actions, unfavourable and favourable; ultimate only"
    return ListOf(Number(symbol, "", PARTIAL), symbol, meaning, 2, members=("unfavourable", "favourable"))


def _three_factors(symbol: str, state: str) -> ListOf:
    meaning = f"partial factors of {state}: permanent actions unfavourable and favourable, variable actions"
    return ListOf(Number(symbol, "", PARTIAL), symbol, meaning, 3, members=("unfavourable", "favourable", "variable"))


def _check_expression(expression: str, given: set[str]) -> Iterator[RelativeIssue]:
    for key in ("permanent", "variable", "xi", "separate"):
        if expression == "ACI 318" and key in given:
            hint, repairs = "the factors are those of ACI 318-19 5.3.1", (remove((key,)),)
            yield RelativeIssue((key,), f"{key} with ACI 318", f"no {key}", hint, repairs)


class Combine(Section):
    """Automatic combinations of the load cases by EN 1990, or by ACI 318 and ASCE 7."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_partial_factors, _check_expression)

    sets: Annotated[
        tuple[LimitState, ...],
        ListOf(Choice(LimitState, "", ""), "", "limit states to generate combinations for", unique=True),
    ]
    expression: Annotated[
        Expression,
        Choice(
            Expression,
            "expressions of EN 1990 6.4.3.2(3), or ACI 318-19 5.3.1 for ultimate and seismic sets with the "
            "allowable-stress ones of ASCE 7-16 2.4 for characteristic sets",
            "",
        ),
    ] = "6.10"
    xi: Annotated[float, Number("xi", "reduction of unfavourable permanent actions in 6.10b", SHARE)] = 0.85
    separate: Annotated[
        bool,
        Boolean("whether each permanent action is unfavourable or favourable by itself; otherwise all are together"),
    ] = False
    permanent: Annotated[tuple[float, float], _partial_factors("gamma_G", "permanent")] = (1.35, 1.0)
    variable: Annotated[tuple[float, float], _partial_factors("gamma_Q", "variable")] = (1.5, 0.0)
    equilibrium: Annotated[
        tuple[float, float, float], _three_factors("gamma", "equilibrium (EN 1990 Table A1.2(A))")
    ] = (1.1, 0.9, 1.5)
    uplift: Annotated[tuple[float, float, float], _three_factors("gamma", "uplift (EN 1997-1 Table A.15)")] = (
        1.0, 0.9, 1.5
    )  # fmt: skip
    accidental_leader: Annotated[
        Literal["psi_1", "psi_2"],
        Choice(Literal["psi_1", "psi_2"], "value of the leading variable action with an accidental one (6.11b)"),
    ] = "psi_1"
    annex: Annotated[
        AnnexName | None,
        Choice(
            AnnexName,
            "national parameters of EN 1990 and EN 1997-1; by default those of reinforcement.annex",
            "",
        ),
    ] = None

    def by_annex(self, annex: str) -> Self:
        """Return the rules with the factors of a national annex, but for those given, and for rules of ACI 318."""
        defaults = {name: type(self).model_fields[name].default for name in NATIONAL}
        of_annex = {} if self.expression == "ACI 318" else factors_of(annex)
        return self.with_derived({**defaults, **of_annex, "annex": None if annex == "recommended" else annex})


def _add_case(name: str) -> tuple[Repair, ...]:
    """Return the repairs that add a load case of a name; its action, on which combinations depend, is to be chosen."""
    actions: tuple[Kind, ...] = ("permanent", "variable")
    return tuple(
        add_item(("cases",), {"name": name, "action": action}, f"add {action} load case {describe(name)}")
        for action in actions
    )


def check_case_names(
    part: str, key: str, named: list[str | None], cases: tuple[LoadCase, ...]
) -> Iterator[RelativeIssue]:
    """Find items of a list without a case although there are cases, or with an unknown one."""
    names = [case.name for case in cases]
    known_names = set(names)
    for position, name in enumerate(named):
        if name is None or (not name and not names):
            continue
        if name not in known_names:
            expected = one_of(names) if names else "no case, as there are no [[cases]]"
            named_case = describe(name) if name else "no case"
            place, hint = (part, position, key), suggestion(name, names)
            repairs = use_nearest(place, name, names)
            repairs += _add_case(name) if name else ()
            repairs += () if names else (remove(place),)
            yield RelativeIssue(place, named_case, expected, hint, repairs)


def check_factors(combinations: tuple[Combination, ...], cases: tuple[LoadCase, ...]) -> Iterator[RelativeIssue]:
    """Find factors of unknown cases, and combinations without any cases."""
    names = [case.name for case in cases]
    if combinations and not names:
        expected, repairs = "none, as there are no [[cases]] to combine", (remove(("combinations",)),)
        yield RelativeIssue(("combinations",), describe(combinations), expected, repairs=repairs)
        return
    known_names = set(names)
    for position, combination in enumerate(combinations):
        for name, _ in combination.factors:
            if name not in known_names:
                place = ("combinations", position, "factors", name)
                hint, nearest = suggestion(name, names), find_nearest(name, names)
                free = nearest is not None and nearest not in dict(combination.factors)
                renames = (rename_key(place, str(nearest)),) if free else ()
                repairs = (*renames, *_add_case(name), remove(place, label="remove the factor"))
                yield RelativeIssue(place, "a case that is not there", one_of(names), hint, repairs)


def has_ultimate_combination(combinations: tuple[Combination, ...], combine: Combine | None) -> bool:
    """Return whether any combination given or made is for the ultimate limit state."""
    return any(combination.limit_state == "ultimate" for combination in combinations) or (
        combine is not None and "ultimate" in combine.sets
    )


def check_design_combinations(
    reinforcement: object, cases: tuple[LoadCase, ...], combinations: tuple[Combination, ...], combine: Combine | None
) -> Iterator[RelativeIssue]:
    """Find reinforcement without an ultimate combination to design for."""
    if reinforcement is None or has_ultimate_combination(combinations, combine):
        return
    add = '[[combinations]] with limit_state = "ultimate" and factors, or "ultimate" in the sets of [combine]'
    cased = "" if cases else "[[cases]], the case of each load, and then "
    hint = f"add {cased}{add}; loads that already include partial factors take the factor 1"
    yield RelativeIssue(("reinforcement",), "no ultimate combination of loads", "at least one to design for", hint)
