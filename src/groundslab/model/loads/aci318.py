"""Combinations of loads by ACI 318-19 5.3.1, strength design, each as factors of the load cases.

    1.4 D                                   5.3.1a        1.2 D + 1.0 W + 1.0 L + 0.5 (L_r or S)          5.3.1d
    1.2 D + 1.6 L + 0.5 (L_r or S)          5.3.1b        1.2 D + 1.0 E + 1.0 L + 0.2 S                   5.3.1e
    1.2 D + 1.6 (L_r or S)                  5.3.1c        0.9 D + 1.0 W                                   5.3.1f
          + (1.0 L or 0.5 W)                              0.9 D + 1.0 E                                   5.3.1g

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
#: Loads of the categories that are no live load.
_KINDS = {"H": "L_r", "snow": "S", "snow above 1000 m": "S", "wind": "W"}


def combine(
    cases: Sequence[LoadCase],
    seismic: bool,
    beside: Iterable[Mapping[str, float]],
    subsets: Callable[[Sequence[LoadCase]], Iterator[tuple[LoadCase, ...]]],
) -> Iterator[tuple[str, dict[str, float]]]:
    """Yield rules and factors by case: of the strength combinations without an earthquake, or of those with one.

    ``beside`` are the earthquakes, with their factors; ``subsets`` gives the variable cases that may act together.
    """
    dead = [case.name for case in cases if case.action == "permanent"]
    variable = [case for case in cases if case.action == "variable"]
    if any(case.category == "temperature" for case in variable):
        expected = "dead, live, roof live, snow and wind loads"
        raise InputError([Issue("combine", "a case of temperature", expected, "write those with it by hand (5.3.6)")])
    for quake in beside:
        for equation, of_dead, factors in SEISMIC if seismic else ULTIMATE:
            own = {case.name: factors.get(_KINDS.get(case.category or "", "L"), 0.0) for case in variable}
            for together in subsets([case for case in variable if own[case.name]]):
                live = {case.name: own[case.name] for case in together}
                yield f"ACI 318-19 {equation}", dict.fromkeys(dead, of_dead) | live | dict(quake)
