"""Adaptive meshes: elements as small as the largest errors need, the same for all combinations."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection
from dataclasses import dataclass, field, replace
from typing import TypeVar

import numpy as np

from groundslab.accuracy.governing import find_governing
from groundslab.accuracy.judgment import AGAINST, BEAM_SHEAR, CONTACT, JudgedValue, judge, judge_together
from groundslab.accuracy.values import OF_THE_WHOLE
from groundslab.arrays import Array
from groundslab.discretize.plan.local_sizes import local_sizes
from groundslab.discretize.plan_layout import Meshes, has_coarser
from groundslab.discretize.symmetry import symmetries
from groundslab.fem.mesh import Mesh
from groundslab.fem.shape_functions import areas
from groundslab.geometry.nearest import nearest_distance
from groundslab.meshing.sizing import Sources, join
from groundslab.model.combinations import list_combinations
from groundslab.model.ground import ContinuousGround
from groundslab.model.model import Model
from groundslab.model.settings import Mesh as Wanted
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.records import MeshEnd, MeshHistory
from groundslab.results.results import CombinationResult, Results

Kept = TypeVar("Kept")

#: Solves the combinations of some names on one mesh, and returns the results of all that were solved on it; or, as a
#: draft, on the next coarser one alone.
Analysis = Callable[[Collection[str], bool], Results]

#: So many meshes are made at most,
MOST_MESHES = 5
#: of at most about mesh.max_unknowns each, and so many times that over the number of combinations; one with more than
#: a share of what is allowed is not followed by another.
MOST_WORK = 100 / 3
MOST_SHARE = 0.8
#: Errors aimed at, as a share of what is asked for: estimates are no bounds.
AIM = 0.8
#: An error in energy is to fall by no more than this from one mesh to the next: one that is large says little.
MOST_REDUCTION = 4.0
#: Around a value elements become at least so many times smaller: they are cut in halves.
LEAST_REDUCTION = 2.0
#: Elements become at most so many times smaller from one mesh to the next.
SMALLER = 8.0
#: An error that is left with more than this share of itself by smaller elements falls no more.
PROGRESS = 0.8
#: Errors of these come from the elements around their places.
LOCAL = {PLATE_FIELDS[name].label for name in AGAINST if name not in OF_THE_WHOLE} | {BEAM_SHEAR, CONTACT}
#: Smaller elements at the places of a value reach so many of their present sides around these; those along the line of
#: lift-off, on which the area in contact depends, so many.
AROUND, ALONG = 3.0, 1.0
#: Orders of convergence between which the one found is believed.
ORDERS = (1.0, 2.0)


def solve_adaptively(
    model: Model,
    begin: Callable[[Meshes], tuple[Analysis, Kept]],
    share: float = 1.0,
    on_mesh: Callable[[Results], None] | None = None,
    start: tuple[Results, Kept] | None = None,
) -> tuple[Results, Kept]:
    """Return the results of a model on meshes that are refined until the judged errors are within mesh.accuracy.

    Or within a share of it. Or until those that are not fall no more, another mesh would have more unknowns than
    mesh.max_unknowns, or MOST_MESHES were made: then the accuracy is missed. Where the mesh is not adaptive, the first
    one is the only one. `begin` returns what solves combinations on some meshes; what it returns beside that is
    returned with the last results.

    Of several combinations all are solved on a coarse mesh first, whose errors nothing tells; on further ones those
    that govern. Where these end the refinement, the others are solved on the same mesh; if one of them is off, it goes
    on. on_mesh is called with the results on each mesh on which all are solved before the next one is made; another
    call may start from them.
    """
    sizes_given, names = local_sizes(model), [combination.name for combination in list_combinations(model)]
    drafted = _has_draft(model, len(names))
    if start is None:
        analysis, kept = begin(Meshes(local=sizes_given))
        results = analysis(names, drafted)
    else:
        results, kept = start
    if not model.mesh.adaptive:
        return results, kept
    course = _follow(results, model.mesh, share, len(names), int(drafted))
    if drafted and not any(result.comparison for result in results.values()):
        course.latest |= results
        if start is not None:
            analysis, kept = begin(Meshes(local=sizes_given))
        elif on_mesh is not None:
            on_mesh(course.label(results))
        governing = find_governing(results, {}) or tuple(names)
        results = analysis(governing, False)
        course.count(results)
    while True:
        complete, off = len(results.combinations) == len(names), course.judge(results)
        finer = course.next_sizes(results, off)
        if finer is None and complete:
            return course.label(results), kept
        if finer is None:
            results = analysis(names, False)
            continue
        if complete:
            governing = find_governing(results, off)
            if on_mesh is not None:
                on_mesh(course.label(results))
        course.before |= course.now
        analysis, kept = begin(Meshes(local=join(finer, sizes_given)))
        results = analysis(governing, False)
        course.count(results)


def _has_draft(model: Model, combinations: int) -> bool:
    """Return whether so many combinations are solved on a coarse mesh first; those on a continuum have one anyway."""
    several = model.mesh.adaptive and combinations > 1 and not isinstance(model.ground, ContinuousGround)
    return several and has_coarser(model, symmetries(model))


@dataclass(slots=True)
class _Course:
    """What the meshes so far tell."""

    wanted: Wanted
    accuracy: float
    combinations: int
    drafts: int  # how many of the meshes were made without errors
    made: tuple[int, ...]  # unknowns of the meshes
    before: dict[str, dict[str, float]]  # errors on the meshes before the last that each combination had
    now: dict[str, dict[str, float]] = field(default_factory=dict)  # errors on the last one
    latest: dict[str, CombinationResult] = field(default_factory=dict)  # of every combination, on the last mesh it had
    end: MeshEnd = "provisional"
    needed: int | None = None

    def count(self, results: Results) -> None:
        """Count another mesh, that of some results."""
        self.made = (*self.made, *(result.unknowns for result in list(results.values())[:1]))

    def judge(self, results: Results) -> dict[str, list[JudgedValue]]:
        """Return the errors on a mesh that are too large and may still fall, the largest first, by the combination."""
        self.latest |= results
        together = judge_together(self.latest)
        judged = {name: judge(together[name]) for name in results}
        self.now = {name: {value.label: value.share for value in reversed(values)} for name, values in judged.items()}
        off = {name: [value for value in values if self._may_fall(name, value)] for name, values in judged.items()}
        largest = max((value.share for values in judged.values() for value in values), default=0.0)
        self.end = "accurate" if largest <= self.accuracy else "no progress"
        return {name: errors for name, errors in off.items() if errors}

    def _may_fall(self, name: str, value: JudgedValue) -> bool:
        """Return whether an error is too large and fell from one mesh to the next, or was not too large before.

        On the first mesh, which may be coarser than footprints, no error says how it falls.
        """
        before = self.before.get(name, {}).get(value.label, np.inf)
        falls = value.share <= PROGRESS * before or before <= self.accuracy
        return value.share > self.accuracy and (len(self.made) < 3 + self.drafts or falls)

    def next_sizes(self, results: Results, off: dict[str, list[JudgedValue]]) -> Sources | None:
        """Return places and sizes of elements of the next mesh, None if there is to be none."""
        if not off:
            return None
        if len(self.made) == MOST_MESHES + self.drafts:
            self.end = "most meshes"
            return None
        demands = [_demand(results[name], off_values, self.accuracy) for name, off_values in off.items()]
        first = next(iter(results.values()))
        mesh = Mesh(first.plate.nodes, first.plate.elements)
        area, sizes = areas(mesh.xy), np.min(demands, axis=0)
        unknowns = first.unknowns * float((area / sizes**2).sum()) / len(area)
        share = min(1.0, MOST_WORK / self.combinations)
        if unknowns > share * self.wanted.max_unknowns:
            if first.unknowns > MOST_SHARE * share * self.wanted.max_unknowns:
                self.end, self.needed = "max_unknowns", math.ceil(unknowns / share)
                return None
            sizes = sizes * np.sqrt(unknowns / (share * self.wanted.max_unknowns))
        self.end = "provisional"
        return mesh.xy[:, 8], sizes

    def label(self, results: Results) -> Results:
        """Return results with the history of their mesh."""
        history = MeshHistory(self.made, self.end, self.needed)
        labels = {
            name: replace(result, mesh_history=replace(history, before=tuple(self.before.get(name, {}).items())))
            for name, result in results.items()
        }
        return replace(results, results=labels)


def _follow(results: Results, wanted: Wanted, share: float, combinations: int, drafts: int) -> _Course:
    """Return the course of the meshes up to that of results, which may be the first."""
    histories = {name: result.mesh_history or MeshHistory((result.unknowns,)) for name, result in results.items()}
    unknowns = next((history.unknowns for history in histories.values()), ())
    before = {name: dict(history.before) for name, history in histories.items()}
    return _Course(wanted, share * wanted.largest_error, combinations, drafts, unknowns, before)


def _demand(results: CombinationResult, judged: list[JudgedValue], accuracy: float) -> Array:
    """Return the sizes (m,) [m] that elements should have; judged are errors above the accuracy, the largest first."""
    density = results.elements.discretization_error
    assert results.comparison is not None
    assert density is not None
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    h, p = np.sqrt(areas(mesh.xy)), float(np.clip(-np.log2(max(results.comparison.reduction, 1e-3)), *ORDERS))
    spread = next((value.share for value in judged if value.label not in LOCAL), 0.0)
    sizes = h if not spread else _equidistributed(h, density, p, _reduction(spread, accuracy))
    sizes = np.minimum(sizes, _near_values(mesh, h, judged, accuracy))
    demand: Array = np.clip(sizes, h / SMALLER, h)
    return demand


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
    sizes: Array = wanted * (squared.sum() / ratio**2 / left) ** (1 / (2 * p))
    return sizes


def _reduction(share: float, accuracy: float) -> float:
    """Return by what the error in energy is to fall, of which that of a value is a square."""
    return float(min((share / (AIM * accuracy)) ** 0.5, MOST_REDUCTION))


def _near_values(mesh: Mesh, h: Array, judged: list[JudgedValue], accuracy: float) -> Array:
    """Return sizes (m,) [m] with which errors at the places of values fall to the accuracy; no limit elsewhere."""
    sizes = np.full(len(h), np.inf)
    for value in judged:
        places = value.coarse if len(value.coarse) else value.around
        if len(places):
            away = nearest_distance(mesh.xy[:, 8], places, np.inf) / h
            reduction = max(_reduction(value.share, accuracy), LEAST_REDUCTION)
            around = ALONG if value.label == CONTACT else AROUND
            for reach, less in ((around, LEAST_REDUCTION), (around / 2, reduction)):
                near = away <= reach
                sizes[near] = np.minimum(sizes[near], h[near] / less)
    return sizes
