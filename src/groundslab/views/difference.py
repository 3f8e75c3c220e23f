"""One set of results minus another: which combinations belong together, and values on the mesh of the first one."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

import numpy as np

from groundslab.errors import InputError, Issue
from groundslab.fem.mesh import Mesh, interpolate, locate_within
from groundslab.results.results import CombinationResult, Results, results_of
from groundslab.schema.wording import one_of, quote
from groundslab.views.summary.combinations import Entry, entries

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.results.plate_result import PlateResult

#: What is subtracted: all results, or those of one combination.
Subtracted = Results | CombinationResult


def choose_subtracted(other: Results, combination: str | None, location: str = "minus") -> Subtracted:
    """Return what is subtracted of other results: all, or the combination that is named.

    Raises InputError at the location if there is no such combination.
    """
    if combination is None:
        return other
    if combination not in other.results:
        raise InputError([Issue(location, quote(combination), one_of(list(other.results)))])
    return other[combination]


def find_subtracted(names: Iterable[str], minus: Subtracted) -> tuple[dict[str, Entry], list[str]]:
    """Return what is subtracted from each combination, and the names of all that could be.

    It is the combination of the same name, or the only one; combinations without any are left out.
    """
    others = {entry.combination.name: entry for entry in entries(results_of(minus)) if entry.results is not None}
    only = next(iter(others.values())) if len(others) == 1 else None
    matches = {name: others.get(name, only) for name in names}
    return {name: other for name, other in matches.items() if other is not None}, list(others)


def transfer(source: PlateResult, target: PlateResult) -> Callable[[Array], Array]:
    """Return what interpolates values at the nodes of a plate (n,) at those of another one (m,).

    Raises InputError if nodes lie beyond the plate of the values.
    """
    if np.array_equal(source.nodes, target.nodes) and np.array_equal(source.elements, target.elements):
        return lambda values: values
    mesh = Mesh(source.nodes, source.elements)
    places = locate_within(mesh, target.nodes, "the plate to be subtracted")
    return lambda values: interpolate(mesh, values, places)
