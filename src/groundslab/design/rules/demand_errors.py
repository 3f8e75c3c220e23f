"""Discretization errors of what checks demand: the same demand, at the same place, of the results on a coarser mesh."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import isfinite

import numpy as np

from groundslab.accuracy.values import (
    EXACT,
    SLOWEST_AROUND,
    error_of_largest,
    estimate_error,
    estimate_errors,
)
from groundslab.arrays import Array, Flags
from groundslab.design.demands.design_moments import DesignMoments
from groundslab.design.demands.support_moments import bar_moments
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS
from groundslab.results.results import CombinationResult

#: Design moments and stresses have errors as moments have.
MOMENT = "moment_x"
MOMENTS = ("moment_x", "moment_y")


def scaled(error: float | None, scale: float) -> float | None:
    """Return an error in another unit."""
    return None if error is None else error * scale


def error_of(results: CombinationResult, value: Callable[[CombinationResult], float]) -> float | None:
    """Return the estimated error of a value of the whole slab; None without a coarser mesh, or of no number."""
    coarser, comparison = results.coarser, results.comparison
    if coarser is None or comparison is None:
        return None
    now, before = value(results), value(coarser)
    return estimate_error(now, before, comparison) if isfinite(now) and isfinite(before) else None


def error_at_nodes(
    results: CombinationResult,
    field: str,
    values: Callable[[CombinationResult], Array],
    nodes: Flags | None = None,
) -> float | None:
    """Return the estimated error of the largest of values (k,) at some nodes (n,), or at all, as a field's errors are.

    None without a coarser mesh.
    """
    if results.coarser is None or results.comparison is None:
        return None
    return error_of_largest(results, field, values(results), values(results.coarser), nodes)


def error_of_greatest(
    results: CombinationResult, values: Callable[[CombinationResult], Array], reduction: Callable[[], Array]
) -> float | None:
    """Return the estimated error of the largest of values (k,) between nodes, whose errors decide where it may lie.

    Each has the reduction (k,) of its place. None without a coarser mesh, or where there are none.
    """
    coarser, comparison = results.coarser, results.comparison
    if coarser is None or comparison is None:
        return None
    now, before = values(results), values(coarser)
    if not (len(now) and np.isfinite(now).all() and np.isfinite(before).all()):
        return None
    q = reduction()
    most = now + np.abs(now - before) * q / (1 - q)
    return float((most.clip(max=0) if max(now.max(), before.max()) <= 0 else most).max() - now.max())


def error_along(
    results: CombinationResult, course: Callable[[CombinationResult], tuple[Array, Array]], reach: float
) -> float | None:
    """Return the estimated error of the largest of values along a beam or wall, given by ways (k,) [m] and values (k,).

    Each place has the largest change within a reach [m], as both meshes may agree at one place by accident, and the
    slowest reduction that section forces of the plate have. None without a coarser mesh, or of no numbers.
    """
    coarser, comparison = results.coarser, results.comparison
    if coarser is None or comparison is None:
        return None
    (way, now), (way_before, before) = course(results), course(coarser)
    if not (np.isfinite(now).all() and np.isfinite(before).all()):
        return None
    change = np.abs(now - np.interp(way, way_before, before))
    first, after = np.searchsorted(way, way - reach), np.searchsorted(way, way + reach, side="right")
    around = np.array([change[low:high].max() for low, high in zip(first, after, strict=True)])
    q = SLOWEST_AROUND if comparison.energy_error >= EXACT else 0.0
    return float((now + around * q / (1 - q)).max() - now.max())


def error_of_ratio(judged: Iterable[tuple[float, float, Callable[[], float | None]]]) -> float | None:
    """Return the estimated error of the largest of demands over resistances, each demand with its error."""
    ratios = [(demand / resistance, error(), resistance) for demand, resistance, error in judged]
    most = [used + error / resistance for used, error, resistance in ratios if error is not None]
    return max(most) - max(used for used, _, _ in ratios) if len(most) == len(ratios) else None


def moment_errors(results: CombinationResult) -> dict[str, Array]:
    """Return the estimated errors (n,) [N m/m] of m_x and m_y, each with the twist's; 0 without a coarser mesh."""
    now, coarser = results.plate, results.coarser
    if coarser is None or results.comparison is None:
        return dict.fromkeys(MOMENTS, np.zeros(len(now.nodes)))
    before = coarser.plate
    twist = estimate_errors(results, MOMENT, now.moment_xy, before.moment_xy)
    return {
        name: twist + estimate_errors(results, MOMENT, getattr(now, name), getattr(before, name)) for name in MOMENTS
    }


def greatest_moments(results: CombinationResult, steel: Reinforcement) -> DesignMoments | None:
    """Return the moments (n,) that bars are for, as large as their errors allow; None without a coarser mesh."""
    if results.coarser is None or results.comparison is None:
        return None
    now, before = bar_moments(results, steel), bar_moments(results.coarser, steel)
    moments = dict[str, Array]()
    for layer in LAYERS:
        m, other = getattr(now, layer), getattr(before, layer)
        sign = 1 if layer.startswith("bottom") else -1
        moments[layer] = m + sign * estimate_errors(results, MOMENT, m, other)
    return DesignMoments(**moments)
