"""Which combinations govern: those of the largest values and of the largest errors, of each quantity at each place.

The mesh that these need serves the others, whose values at the same places are smaller, and less off. That is a
forecast: with contact no combination follows from others. So all are solved once on the last mesh, and judged there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.accuracy.judgment import JudgedValue, guess, judge
from groundslab.arrays import Array
from groundslab.fem.shape_functions import areas

if TYPE_CHECKING:
    from groundslab.results.plate_result import PlateResult
    from groundslab.results.results import CombinationResult

#: So many combinations govern at most, those with the largest errors first.
MOST_GOVERNING = 12
#: Places of extremes are the same within so many sides of the elements there.
SAME_PLACE = 3.0


@dataclass(frozen=True, slots=True)
class _Candidate:
    """A judged value of a combination."""

    combination: str
    quantity: tuple[str, int]  # label and sign
    value: JudgedValue


def find_governing(
    results: Mapping[str, CombinationResult], off: Mapping[str, Sequence[JudgedValue]]
) -> tuple[str, ...]:
    """Return the names of the combinations that govern, in the order of the results.

    Of each quantity at each place where values are `off`, the combination with the largest error governs. So do those
    whose value may be the largest over all combinations if it is off by its error, one for each place: against these
    errors are judged. Where nothing tells errors they are guessed. `off` are the values whose errors are above the
    accuracy, the largest first, by the combination.
    """
    if not results:
        return ()
    reach = _Reach(next(iter(results.values())).plate)
    candidates: list[_Candidate] = []
    for candidate in (*_by_error(off), *_by_size(results)):
        chosen = {kept.combination for kept in candidates}
        if len(chosen) == MOST_GOVERNING and candidate.combination not in chosen:
            continue
        if not any(reach.same_place(candidate, other) for other in candidates if other.quantity == candidate.quantity):
            candidates.append(candidate)
    governing = {kept.combination for kept in candidates}
    return tuple(name for name in results if name in governing)


def _by_error(off: Mapping[str, Sequence[JudgedValue]]) -> list[_Candidate]:
    """Return the values that are off, the largest error first."""
    candidates = [
        _Candidate(name, (value.label, value.sign), value) for name, values in off.items() for value in values
    ]
    return sorted(candidates, key=lambda candidate: -candidate.value.share)


def _by_size(results: Mapping[str, CombinationResult]) -> Iterator[_Candidate]:
    """Yield the values that may be the largest of all combinations, the one that may be largest first."""
    by_quantity: dict[tuple[str, int], list[tuple[float, float, _Candidate]]] = {}
    for name, result in results.items():
        for value in judge(result) or guess(result):
            size, error = _digits(value.sign * value.value), _digits(value.error)
            candidate = _Candidate(name, (value.label, value.sign), value)
            by_quantity.setdefault(candidate.quantity, []).append((size + error, size, candidate))
    for several in by_quantity.values():
        largest = max(size for _, size, _ in several)
        for most, _, candidate in sorted(several, key=lambda entry: -entry[0]):
            if most >= largest:
                yield candidate


def _digits(value: float) -> float:
    """Return a value to six digits, so that of two that differ by rounding the first one comes first."""
    return float(f"{value:.6g}")


class _Reach:
    """Tells whether two values lie at the same place of a plate."""

    def __init__(self, plate: PlateResult) -> None:
        from scipy.spatial import KDTree

        xy = plate.nodes[plate.elements]
        self.sides = np.sqrt(areas(xy))
        self.centers = KDTree(xy[:, 8])

    def same_place(self, candidate: _Candidate, other: _Candidate) -> bool:
        """Return whether the extreme of one value lies where that of another is, or may be; of the whole, it does."""
        place = candidate.value.place
        if place is None or other.value.place is None:
            return True
        side = self.sides[self.centers.query(place)[1]]
        around: Array = np.vstack([other.value.around, other.value.place])
        return bool(np.hypot(*(around - place).T).min() <= SAME_PLACE * side)
