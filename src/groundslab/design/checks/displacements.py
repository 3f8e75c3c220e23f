"""Whether displacements are as small as the analysis takes them to be.

Small displacements leave out what membrane forces carry. Timoshenko and Woinowsky-Krieger (1959, section 13) take
deflections as small that are small beside the thickness; what exceeds a half of it, or slopes above 0.05, whose squares
are no longer nothing beside 1, is said. It is no failure, but no number then holds.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.by_plate import split_by_plate
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Message, Name
from groundslab.results.results import CombinationResult, Results

NAME = "small displacements"
#: The largest deflection from a plane, as a share of the thickness, and the largest slope.
OF_THICKNESS, SLOPE = 0.5, 0.05


@dataclass(frozen=True, slots=True)
class _Largest:
    """A displacement over its limit, where it is, and in words how large it is."""

    share: float
    place: tuple[float, float]
    combination: str
    words: str


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the largest deflection and slope of all combinations that are too large for small displacements."""
    displacements = [
        largest for result in solved_results(combined) for part in split_by_plate(result).values()
        for largest in (_deflection(part), _slope(part))
    ]  # fmt: skip
    worst = max(displacements, key=lambda largest: largest.share, default=None)
    if worst is None or worst.share <= 1:
        return
    yield DesignCheck(NAME, "attention", worst.words, combination=worst.combination, place=worst.place)


def _deflection(result: CombinationResult) -> _Largest:
    """Return how far a plate is bent off the plane that fits it best, beside a half of its thickness."""
    plate = result.plate
    h, _ = result.elements.at_nodes(plate)
    off = np.abs(_off_plane(plate.nodes, plate.settlement, plate.area))
    node = int(np.argmax(off / h))
    words = Message(
        '"{combination}" bends the slab off a plane by {off:.3g mm}, more than half its thickness of '
        "{h:.3g mm}: membrane forces, which are left out, carry a part of the loads",
        combination=Name(result.combination),
        off=1e3 * off[node],
        h=1e3 * h[node],
    )
    return _Largest(float(off[node] / (OF_THICKNESS * h[node])), _place(plate.nodes[node]), result.combination, words)


def _slope(result: CombinationResult) -> _Largest:
    """Return the largest slope of a plate beside its limit."""
    plate = result.plate
    slope = np.hypot(plate.rotation_x, plate.rotation_y)
    node = int(np.argmax(slope))
    words = Message(
        '"{combination}" gives the slab a slope of {slope:.3g}, more than {slope_2:g}: membrane forces, '
        "which are left out, carry a part of the loads",
        combination=Name(result.combination),
        slope=slope[node],
        slope_2=SLOPE,
    )
    return _Largest(float(slope[node] / SLOPE), _place(plate.nodes[node]), result.combination, words)


def _off_plane(nodes: Array, w: Array, area: Array) -> Array:
    """Return by how much settlements (n,) differ from the plane that fits them best, by the areas of the nodes."""
    columns = np.column_stack([np.ones(len(nodes)), nodes - nodes.mean(axis=0)])
    weights = np.sqrt(area)
    plane = np.linalg.lstsq(columns * weights[:, None], w * weights, rcond=None)[0]
    off: Array = w - columns @ plane
    return off


def _place(node: Array) -> tuple[float, float]:
    """Return a place of a check."""
    return float(node[0]), float(node[1])
