"""Meshes of plans, with the checks of what goes into a mesher and what comes out of it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.errors import InputError, Issue
from groundslab.fem.shape_functions import determinants, gauss, q9
from groundslab.geometry.places import same_place_in
from groundslab.geometry.plan import MOST_ELEMENTS, Plan, format_place
from groundslab.geometry.regions import NOTHING
from groundslab.geometry.validity import find_issues
from groundslab.meshing.quality import Quality, quality


@dataclass(frozen=True, slots=True)
class PlanMesh:
    """A mesh of nine-node quadrilaterals on a plan: n nodes [m], m elements, counter-clockwise."""

    nodes: Array  # (n, 2) [m]
    elements: Integers  # (m, 9)
    section: Integers  # (m,): number of the plate's section, -1 where there is only ground
    quality: Quality

    @property
    def xy(self) -> Array:
        """Return the nodes of each element, (m, 9, 2)."""
        xy: Array = self.nodes[self.elements]
        return xy


def check(plan: Plan, size: float) -> None:
    """Raise what is wrong with a plan and a size."""
    issues = find_issues(plan)
    if not (math.isfinite(size) and size > 0):
        issues.append(Issue("mesh.size", f"{size!r}", "a length greater than 0"))
    elif not issues and plan.area / size**2 > MOST_ELEMENTS:
        issues.append(too_many_elements())
    if issues:
        raise InputError(issues)


def too_many_elements() -> Issue:
    """Return the issue of a size that makes more elements than a computer can hold."""
    return Issue("mesh.size", f"more than {MOST_ELEMENTS} elements", "fewer", "make the elements larger")


def finish(plan: Plan, nodes: Array, elements: Integers, section: Integers) -> PlanMesh:
    """Return a mesh of a plan without the nodes that no element uses, and refuse one with elements inverted."""
    if len(elements) > MOST_ELEMENTS:
        raise InputError([too_many_elements()])
    used, number = np.unique(elements, return_inverse=True)
    measured = quality(nodes[elements])
    if not measured.worst > 0:
        inverted = f"a mesh with an element turned inside out at {format_place(measured.worst_place, plan.origin)}"
        raise InputError(
            [Issue("plan", inverted, "elements that can be used", "simplify the plan there or mesh it finer")]
        )
    return PlanMesh(nodes[used], number.reshape(elements.shape).astype(np.int64), section, measured)


def on_bounds(plan: Plan, nodes: Array) -> Array:
    """Return nodes (n, 2), those next to the rectangle around a plan exactly on it: there further ground begins."""
    low, high = np.reshape(plan.bounds, (2, 2))
    near = same_place_in(plan)
    snapped: Array = np.where(np.abs(nodes - low) < near, low, np.where(np.abs(nodes - high) < near, high, nodes))
    return snapped


def check_area(plan: Plan, result: PlanMesh) -> None:
    """Raise if the mesh does not cover the plan: nothing that a mesher leaves out may go unnoticed."""
    points, weights = gauss(3)
    area = determinants(q9(points)[1], result.xy) @ weights
    for what, meshed, expected in (
        ("the plate", float(area[result.section >= 0].sum()), plan.area),
        ("plate and ground", float(area.sum()), plan.area if plan.beyond is None else plan.beyond.area),
    ):
        if abs(meshed - expected) > 1e-3 * expected or (result.section == NOTHING).any():
            said = f"a mesh of {what} with an area of {meshed:.6g} m2 instead of {expected:.6g} m2"
            raise InputError([Issue("plan", said, "one that covers it", "simplify the plan or mesh it finer")])
