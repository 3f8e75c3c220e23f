"""Adaptive meshes: elements as small as the largest errors need, the same for all combinations."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TypeVar

import numpy as np

from groundslab.accuracy.judgment import AGAINST, CONTACT, JudgedValue, judge
from groundslab.accuracy.values import OF_THE_WHOLE
from groundslab.arrays import Array
from groundslab.discretize.local_sizes import local_sizes
from groundslab.discretize.plan_layout import Meshes
from groundslab.fem.mesh import Mesh
from groundslab.fem.shape_functions import areas
from groundslab.meshing.sizing import join
from groundslab.model.model import Model
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.record import MeshEnd, MeshHistory
from groundslab.results.results import CombinationResult, Results

Kept = TypeVar("Kept")

#: So many meshes are made at most,
MOST_MESHES = 5
#: of at most about mesh.max_unknowns each, and together so many times that, over the combinations; one with more than
#: a share of what is left is not followed by another.
MOST_WORK = 40 / 3
MOST_SHARE = 0.8
#: Errors aimed at, as a share of what is asked for: estimates are no bounds.
AIM = 0.8
#: An error in energy is to fall by no more than this from one mesh to the next: one that is large says little.
MOST_REDUCTION = 4.0
#: Around a value they become at least so many times smaller: meshes hardly follow smaller changes.
LEAST_REDUCTION = 2.0
#: Elements become at most so many times smaller from one mesh to the next.
SMALLER = 8.0
#: An error that is left with more than this share of itself by smaller elements falls no more.
PROGRESS = 0.8
#: Errors of these come from the elements around their places.
LOCAL = {PLATE_FIELDS[name].label for name in AGAINST if name not in OF_THE_WHOLE} | {CONTACT}
#: Smaller elements at the places of a value reach so many of their present sides around these.
AROUND = 3.0
#: Orders of convergence between which the one found is believed.
ORDERS = (1.0, 2.0)


def solve_adaptively(
    model: Model,
    solve: Callable[[Meshes], tuple[Results, Kept]],
    share: float = 1.0,
    on_mesh: Callable[[Results], None] | None = None,
    start: tuple[Results, Kept] | None = None,
) -> tuple[Results, Kept]:
    """Return the results of a model on meshes that are refined until the judged errors are within mesh.accuracy.

    Or within a share of it. Or until those that are not fall no more, another mesh would have more unknowns than
    mesh.max_unknowns, or MOST_MESHES were made: then the accuracy is missed. Where the mesh is not adaptive, the first
    one is the only one. on_mesh is called with the results on each mesh before the next one is made; another call may
    start from them. What `solve` returns beside the results is returned with the last ones.
    """
    given = local_sizes(model)
    results, kept = start or solve(Meshes(local=given))
    if not model.mesh.adaptive:
        return results, kept
    accuracy = share * model.mesh.largest_error
    made, before = _history_of(results)
    end: MeshEnd = "most meshes"
    needed = None
    while len(made) < MOST_MESHES:
        judged = {name: judge(found) for name, found in results.items()}
        # on the first mesh, which may be coarser than footprints, no error says how it falls
        too_large = {
            name: [
                each
                for each in found
                if each.share > accuracy
                and (len(made) < 3 or each.share <= PROGRESS * before.get(name, {}).get(each.label, np.inf))
            ]
            for name, found in judged.items()
        }
        demands = [_demand(results[name], found, accuracy) for name, found in too_large.items() if found]
        if not demands:
            shares = [each.share for found in judged.values() for each in found]
            end = "accurate" if max(shares, default=0.0) <= accuracy else "no progress"
            break
        first = next(iter(results.values()))
        mesh = Mesh(first.plate.nodes, first.plate.elements)
        area, sizes = areas(mesh.xy), np.min(demands, axis=0)
        unknowns = first.unknowns * float((area / sizes**2).sum()) / len(area)
        work = MOST_WORK / len(results)
        left = min(model.mesh.max_unknowns, work * model.mesh.max_unknowns - sum(made))
        if unknowns > left:
            if first.unknowns > MOST_SHARE * left:
                end, needed = "max_unknowns", math.ceil(max(unknowns, (unknowns + sum(made)) / work))
                break
            sizes = sizes * np.sqrt(unknowns / left)
        if on_mesh is not None:
            on_mesh(_with_history(results, MeshHistory(made), before))
        before = {name: {each.label: each.share for each in reversed(found)} for name, found in judged.items()}
        results, kept = solve(Meshes(local=join((mesh.xy[:, 8], sizes), given)))
        made = (*made, *(found.unknowns for found in list(results.values())[:1]))
    return _with_history(results, MeshHistory(made, end, needed), before), kept


def _history_of(results: Results) -> tuple[tuple[int, ...], dict[str, dict[str, float]]]:
    """Return the unknowns of the meshes up to that of results, and errors on the one before by combination and name."""
    histories = {name: found.mesh_history or MeshHistory((found.unknowns,)) for name, found in results.items()}
    made = next((each.unknowns for each in histories.values()), ())
    return made, {name: dict(each.before) for name, each in histories.items()}


def _with_history(results: Results, history: MeshHistory, before: Mapping[str, Mapping[str, float]]) -> Results:
    """Return results with the history of their mesh; before are errors on the one before, by combination and name."""
    known = {
        name: replace(found, mesh_history=replace(history, before=tuple(before.get(name, {}).items())))
        for name, found in results.items()
    }
    return replace(results, results=known)


def _demand(results: CombinationResult, judged: list[JudgedValue], accuracy: float) -> Array:
    """Return the sizes (m,) [m] that elements should have; judged are errors above the accuracy, the largest first."""
    density = results.elements.discretization_error
    assert results.comparison is not None
    assert density is not None
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    h, p = np.sqrt(areas(mesh.xy)), float(np.clip(-np.log2(max(results.comparison.reduction, 1e-3)), *ORDERS))
    spread = next((each.share for each in judged if each.label not in LOCAL), 0.0)
    sizes = h if not spread else _equidistributed(h, density, p, _reduction(spread, accuracy))
    sizes = np.minimum(sizes, _near_values(mesh, h, judged, accuracy))
    found: Array = np.clip(sizes, h / SMALLER, h)
    return found


def _equidistributed(h: Array, density: Array, p: float, ratio: float) -> Array:
    """Return sizes (m,) [m] with which the error in energy falls by a ratio with the fewest elements.

    An element's error falls with h^p times its side: the fewest elements have equal errors (Zienkiewicz and Zhu 1987).
    h are the sides now, `density` the elements' errors now over their sides, both (m,).
    """
    if not density.any():
        return np.full(len(h), np.inf)
    density = np.maximum(density, 1e-6 * density.max())
    wanted = (h**p / density) ** (1 / (p + 1))
    squared = (density * h) ** 2
    left = (squared * (wanted / h) ** (2 * p)).sum()
    found: Array = wanted * (squared.sum() / ratio**2 / left) ** (1 / (2 * p))
    return found


def _reduction(share: float, accuracy: float) -> float:
    """Return by what the error in energy is to fall, of which that of a value is a square."""
    return float(min((share / (AIM * accuracy)) ** 0.5, MOST_REDUCTION))


def _near_values(mesh: Mesh, h: Array, judged: list[JudgedValue], accuracy: float) -> Array:
    """Return sizes (m,) [m] with which errors at the places of values fall to the accuracy; no limit elsewhere."""
    from scipy.spatial import KDTree

    found = np.full(len(h), np.inf)
    for each in judged:
        if len(each.around):
            away = KDTree(each.around).query(mesh.xy[:, 8])[0] / h
            reduction = max(_reduction(each.share, accuracy), LEAST_REDUCTION)
            around = 1.0 if each.label == CONTACT else AROUND
            for reach, less in ((around, LEAST_REDUCTION), (around / 2, reduction)):
                near = away <= reach
                found[near] = np.minimum(found[near], h[near] / less)
    return found
