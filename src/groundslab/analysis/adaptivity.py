"""Adaptive meshes: elements as small as the largest errors need, the same for all combinations."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from typing import TypeVar

import numpy as np

from groundslab.accuracy.governing import find_governing
from groundslab.accuracy.judgment import AGAINST, JudgedValue, judge, judge_together
from groundslab.accuracy.values import OF_THE_WHOLE
from groundslab.arrays import Array
from groundslab.discretize.local_sizes import local_sizes
from groundslab.discretize.plan_layout import Meshes
from groundslab.fem.mesh import Mesh
from groundslab.fem.shape_functions import areas
from groundslab.meshing.sizing import Sources, join
from groundslab.model.combinations import list_combinations
from groundslab.model.model import Model
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.results import CombinationResult, Results

Kept = TypeVar("Kept")
#: Solves the combinations of some names on one mesh, and returns the results of all that were solved on it.
Analysis = Callable[[Collection[str]], Results]

#: So many meshes are made at most,
MOST_MESHES = 5
#: of at most about so many unknowns each, and so many together, each counted once for every combination that is solved
#: on its mesh; one with more than a share of what is left is not followed by another.
MOST_UNKNOWNS = 300_000
MOST_WORK = 4_000_000
MOST_SHARE = 0.8
#: Errors aimed at, as a share of what is asked for: estimates are no bounds.
AIM = 0.8
#: Elements that may stay as they are may become so many times larger: where meshes are made for the sizes that they
#: have, sides come out smaller, on short edges half as long.
KEPT = 1.25
#: An error in energy is to fall by no more than this from one mesh to the next: one that is large says little.
MOST_REDUCTION = 3.0
#: Around a value they become at least so many times smaller: meshes hardly follow smaller changes.
LEAST_REDUCTION = 1.5
#: Elements become at most so many times smaller from one mesh to the next.
SMALLER = 8.0
#: An error that is left with more than this share of itself by smaller elements falls no more.
PROGRESS = 0.8
#: Errors of these come from the elements around their places.
LOCAL = {PLATE_FIELDS[name].label for name in AGAINST if name not in OF_THE_WHOLE}
#: Smaller elements at the places of a value reach so many of their present sides around these.
AROUND = 6.0
#: Orders of convergence between which the one found is believed.
ORDERS = (1.0, 2.0)


def solve_adaptively(
    model: Model,
    begin: Callable[[Meshes], tuple[Analysis, Kept]],
    share: float = 1.0,
    on_mesh: Callable[[Results], None] | None = None,
) -> tuple[Results, Kept]:
    """Return the results of a model on meshes that are refined until the judged errors are within mesh.accuracy.

    Or within a share of it. Or until those that are not fall no more, another mesh would have too many unknowns, or
    MOST_MESHES were made: then the accuracy is missed. Where the mesh is not adaptive, the first one is the only one.
    `begin` returns what solves combinations on some meshes; what it returns beside that is returned with the last ones.

    On the first mesh all combinations are solved, on further ones those that govern. Where these end the refinement,
    the others are solved on the same mesh; if one of them is off, it goes on. on_mesh is called with the results on
    each mesh on which all are solved before the next one is made.
    """
    start, names = local_sizes(model), [combination.name for combination in list_combinations(model)]
    course = _Course(share * model.mesh.largest_error, len(names))
    analysis, kept = begin(Meshes(local=start))
    results = analysis(names)
    while model.mesh.adaptive:
        complete, off = len(results.combinations) == len(names), course.judge(results)
        finer = course.next_sizes(results, off)
        if finer is None:
            if complete:
                break
            results = analysis(names)
            continue
        if complete:
            governing = find_governing(results, off)
            if on_mesh is not None:
                on_mesh(results)
        course.end_mesh(results)
        analysis, kept = begin(Meshes(local=join(finer, start)))
        results = analysis(governing)
    return results, kept


@dataclass(slots=True)
class _Course:
    """What the meshes so far tell, and how much was solved on them."""

    accuracy: float
    combinations: int
    meshes: int = 1
    spent: int = 0  # unknowns, times the combinations that were solved for them, on the meshes before
    latest: dict[str, CombinationResult] = field(default_factory=dict)  # of every combination, on the last mesh it had
    before: dict[str, dict[str, float]] = field(default_factory=dict)  # errors there, on the meshes before

    def judge(self, results: Results) -> dict[str, list[JudgedValue]]:
        """Return the errors on a mesh that are too large and may still fall, the largest first, by the combination."""
        self.latest |= results
        together = judge_together(self.latest)
        found = {name: [each for each in judge(together[name]) if self._may_fall(name, each)] for name in results}
        return {name: errors for name, errors in found.items() if errors}

    def _may_fall(self, name: str, value: JudgedValue) -> bool:
        """Return whether an error is too large and fell from one mesh to the next.

        On the first mesh, which may be coarser than footprints, no error says how it falls.
        """
        before = self.before.get(name, {}).get(value.label, np.inf)
        return value.share > self.accuracy and (self.meshes < 3 or value.share <= PROGRESS * before)

    def end_mesh(self, results: Results) -> None:
        """Note that another mesh is made."""
        together = judge_together(self.latest)
        self.before |= {name: {each.label: each.share for each in reversed(judge(together[name]))} for name in results}
        self.spent += next(iter(results.values())).unknowns * len(results.combinations)
        self.meshes += 1

    def next_sizes(self, results: Results, off: dict[str, list[JudgedValue]]) -> Sources | None:
        """Return places and extents of elements of the next mesh, None if there is to be none."""
        if not off or self.meshes == MOST_MESHES:
            return None
        demands = [_demand(results[name], found, self.accuracy) for name, found in off.items()]
        first = next(iter(results.values()))
        mesh = Mesh(first.plate.nodes, first.plate.elements)
        area, sizes = areas(mesh.xy), np.min(demands, axis=0)
        unknowns = first.unknowns * float((area / sizes**2).sum()) / len(area)
        spent = self.spent + first.unknowns * len(results.combinations)
        left = min(MOST_UNKNOWNS, (MOST_WORK - spent) / self.combinations)
        if unknowns > left:
            if first.unknowns > MOST_SHARE * left:
                return None
            sizes = sizes * np.sqrt(unknowns / left)
        ratio = sizes / np.sqrt(area)
        return mesh.xy[:, 8], np.maximum(ratio, KEPT * ratio**2)[:, None] * extents_of(mesh)


def extents_of(mesh: Mesh) -> Array:
    """Return the elements' extents along x and y (m, 2) [m]: sides of rectangles, else those of squares as large."""
    sides, area = np.ptp(mesh.xy[:, :4], axis=1), areas(mesh.xy)
    rectangle = np.isclose(sides.prod(axis=1), area, atol=0.0)
    return np.where(rectangle[:, None], sides, np.sqrt(area)[:, None])


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
            near = KDTree(each.around).query(mesh.xy[:, 8])[0] <= AROUND * h
            found[near] = np.minimum(found[near], h[near] / max(_reduction(each.share, accuracy), LEAST_REDUCTION))
    return found
