"""Columns, piles and zones that do not push: punching by what pulls at the plate, or only turns it, is not judged."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from groundslab.arrays import Array
from groundslab.design.basis.check import PULLS, DesignCheck, not_judged
from groundslab.design.basis.combinations import ultimate_results
from groundslab.design.demands.perimeter_loads import PunchingForce, punching_columns, punching_piles
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.results.results import CombinationResult, Results

#: Forces and moments below this share of the largest of a kind are rounding.
ROUNDING = 1e-9
#: So many columns or piles are named.
MOST_NAMED = 5


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield which columns, piles and zones pull at the plate, or only turn it, in any ultimate combination."""
    results = ultimate_results(combined)
    yield from _checks(punching_columns(combined.model), results, "column", "columns that do not push down")
    yield from _checks(punching_piles(combined.model), results, "pile", "piles that do not push up")
    yield from _checks(zone_forces(combined), results, "thicker zone", "thicker zones that do not push down")


def _checks(
    forces: Sequence[PunchingForce], results: list[CombinationResult], one: str, which: str
) -> Iterator[DesignCheck]:
    """Yield that some do not push, with the combination in which each pulls most."""
    if not forces or not results:
        return
    pushing = np.array([[force.pushing(result) for result in results] for force in forces])
    least = ROUNDING * max(float(np.abs(pushing).max()), np.finfo(float).tiny)
    words, governing = [], ""
    for force, by_combination in zip(forces, pushing, strict=True):
        number = _worst(by_combination, least)
        if number is not None:
            governing = governing or results[number].combination
            words.append(f'{force.name} {_loads(by_combination[number])} in "{results[number].combination}"')
    if words:
        more = f"; and {len(words) - MOST_NAMED} more" if len(words) > MOST_NAMED else ""
        listed = "; ".join(words[:MOST_NAMED])
        text = f"{which}: {listed}{more}"
        yield not_judged(f"punching by {one}s that pull", PULLS, text, combination=governing)


def _worst(pushing: Array, least: float) -> int | None:
    """Return the combination (of c) whose force (c, 3) pulls most, or turns most without pushing, if any does."""
    force, moment = pushing[:, 0], np.hypot(pushing[:, 1], pushing[:, 2])
    open_ones = (force < -least) | ((force <= least) & (moment > least))
    if not open_ones.any():
        return None
    order = np.lexsort((-moment, force))
    return int(next(number for number in order if open_ones[number]))


def _loads(pushing: Array) -> str:
    """Return a force that pulls, and its moment, in words."""
    pull, moment = -float(pushing[0]) / 1e3, float(np.hypot(pushing[1], pushing[2])) / 1e3
    if not pull:
        return f"only turns the slab with {moment:.4g} kNm"
    return f"pulls with {pull:.4g} kN" + (f" and {moment:.4g} kNm" if moment else "")
