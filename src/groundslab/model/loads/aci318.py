"""Combinations of loads by ACI 318-19 5.3.1, and for soil pressures by ASCE 7-16 2.4, as factors of the load cases.

Strength design:

    1.4 D                                   5.3.1a        1.2 D + 1.0 W + 1.0 L + 0.5 (L_r or S)          5.3.1d
    1.2 D + 1.6 L + 0.5 (L_r or S)          5.3.1b        1.2 D + 1.0 E + 1.0 L + 0.2 S                   5.3.1e
    1.2 D + 1.6 (L_r or S)                  5.3.1c        0.9 D + 1.0 W                                   5.3.1f
          + (1.0 L or 0.5 W)                              0.9 D + 1.0 E                                   5.3.1g

Allowable stress design of the ground (ASCE 7-16 2.4.1, and 2.4.5 with earthquakes), from memory; digests of 2.4.1
agree. ACI 318-19 13.3.1.1 sizes foundations by such loads.

    D                                 1       D + 0.75 L + 0.75 (0.6 W) + 0.75 (L_r or S)             6
    D + L                             2       0.6 D + 0.6 W                                           7
    D + (L_r or S)                    3       D + 0.7 E                                               8
    D + 0.75 L + 0.75 (L_r or S)      4       D + 0.525 E + 0.75 L + 0.75 S                           9
    D + 0.6 W                         5       0.6 D + 0.7 E                                          10

Snow, wind and earthquakes are those of ASCE 7-16, which ACI 318-19 5.3.1 goes with; by ASCE 7-22 snow is larger, and
has other factors in both.

D are permanent cases, E seismic ones, in both directions; of variable cases W are those of the category "wind", S of
snow, L_r of roofs ("H"), and L all others. L keeps its factor 1.0 (5.3.3 would let it be 0.5). As on ground without
tension less load can be worse than more, every variable case of a combination is once present and once absent.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from groundslab.errors import InputError, Issue
from groundslab.model.loads.load_cases import LoadCase

#: By equation: the factor of D, and those of other loads; alternatives stand one after the other.
ULTIMATE: tuple[tuple[str, float, Mapping[str, float]], ...] = (
    ("5.3.1a", 1.4, {}),
    ("5.3.1b", 1.2, {"L": 1.6, "L_r": 0.5}),
    ("5.3.1b", 1.2, {"L": 1.6, "S": 0.5}),
    ("5.3.1c", 1.2, {"L_r": 1.6, "L": 1.0}),
    ("5.3.1c", 1.2, {"L_r": 1.6, "W": 0.5}),
    ("5.3.1c", 1.2, {"S": 1.6, "L": 1.0}),
    ("5.3.1c", 1.2, {"S": 1.6, "W": 0.5}),
    ("5.3.1d", 1.2, {"W": 1.0, "L": 1.0, "L_r": 0.5}),
    ("5.3.1d", 1.2, {"W": 1.0, "L": 1.0, "S": 0.5}),
    ("5.3.1f", 0.9, {"W": 1.0}),
)
#: Those with an earthquake.
SEISMIC: tuple[tuple[str, float, Mapping[str, float]], ...] = (
    ("5.3.1e", 1.2, {"L": 1.0, "S": 0.2}),
    ("5.3.1g", 0.9, {}),
)
#: Those of ASCE 7-16 2.4.1, and of 2.4.5 with an earthquake, whose own factor is "E".
ALLOWABLE_STRESS: tuple[tuple[str, float, Mapping[str, float]], ...] = (
    ("2.4.1, 1", 1.0, {}),
    ("2.4.1, 2", 1.0, {"L": 1.0}),
    ("2.4.1, 3", 1.0, {"L_r": 1.0}),
    ("2.4.1, 3", 1.0, {"S": 1.0}),
    ("2.4.1, 4", 1.0, {"L": 0.75, "L_r": 0.75}),
    ("2.4.1, 4", 1.0, {"L": 0.75, "S": 0.75}),
    ("2.4.1, 5", 1.0, {"W": 0.6}),
    ("2.4.1, 6", 1.0, {"L": 0.75, "W": 0.45, "L_r": 0.75}),
    ("2.4.1, 6", 1.0, {"L": 0.75, "W": 0.45, "S": 0.75}),
    ("2.4.1, 7", 0.6, {"W": 0.6}),
)
ALLOWABLE_STRESS_SEISMIC: tuple[tuple[str, float, Mapping[str, float]], ...] = (
    ("2.4.5, 8", 1.0, {"E": 0.7}),
    ("2.4.5, 9", 1.0, {"E": 0.525, "L": 0.75, "S": 0.75}),
    ("2.4.5, 10", 0.6, {"E": 0.7}),
)
#: Loads of the categories that are no live load.
_KINDS = {"H": "L_r", "snow": "S", "snow above 1000 m": "S", "wind": "W"}


#: Factors of variable cases that may act together.
Subsets = Callable[[Sequence[LoadCase]], Iterator[tuple[LoadCase, ...]]]


def combine(
    cases: Sequence[LoadCase], limit_state: str, quakes: Sequence[Mapping[str, float]], subsets: Subsets
) -> Iterator[tuple[str, dict[str, float]]]:
    """Yield rules and factors by case: of strength without an earthquake or with one, of allowable stresses with both.

    The limit states are "ultimate", "seismic" and "characteristic". ``quakes`` are the earthquakes in both directions,
    with factors 1 and -1; ``subsets`` gives the variable cases that may act together.
    """
    if any(case.category == "temperature" for case in cases if case.action == "variable"):
        expected = "dead, live, roof live, snow and wind loads"
        raise InputError([Issue("combine", "a case of temperature", expected, "write those with it by hand (5.3.6)")])
    if limit_state != "seismic":
        code, table = ("ACI 318-19", ULTIMATE) if limit_state == "ultimate" else ("ASCE 7-16", ALLOWABLE_STRESS)
        yield from _by_table(cases, code, table, [{}], subsets)
    if limit_state != "ultimate":
        seismic = limit_state == "seismic"
        code, table = ("ACI 318-19", SEISMIC) if seismic else ("ASCE 7-16", ALLOWABLE_STRESS_SEISMIC)
        yield from _by_table(cases, code, table, quakes, subsets)


def _by_table(
    cases: Sequence[LoadCase],
    code: str,
    table: Iterable[tuple[str, float, Mapping[str, float]]],
    quakes: Iterable[Mapping[str, float]],
    subsets: Subsets,
) -> Iterator[tuple[str, dict[str, float]]]:
    """Yield rules and factors by case of the equations of a table, with each earthquake."""
    dead = [case.name for case in cases if case.action == "permanent"]
    variable = [case for case in cases if case.action == "variable"]
    for quake in quakes:
        for equation, of_dead, factors in table:
            live_factors = {case.name: factors.get(_KINDS.get(case.category or "", "L"), 0.0) for case in variable}
            shaken = {name: factors.get("E", 1.0) * factor for name, factor in quake.items()}
            for together in subsets([case for case in variable if live_factors[case.name]]):
                live = {case.name: live_factors[case.name] for case in together}
                yield f"{code} {equation}", dict.fromkeys(dead, of_dead) | live | shaken
