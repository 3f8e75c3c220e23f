"""Whether a plate that the ground can only push can be in equilibrium at all: decided before anything is solved."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from groundslab.errors import NoEquilibrium
from groundslab.problem import BETA_X, BETA_Y, TOP, Problem, W
from groundslab.shape import Array
from groundslab.units import coordinate

#: How far, relative to the plate's size, the resultant must stay inside the hull of the plate.
MARGIN = 1e-9
#: The same for bearings with limits: the share of its capacity by which each must be able to stay off both ends.
ROOM = 1e-6


def require_equilibrium(problem: Problem) -> None:
    """Raise NoEquilibrium, saying why, unless contact pressure and supports can balance the load with room to spare.

    The load's work on the rigid motions that the supports leave free must lie inside the cone of what single upward
    forces under the plate do on them (docs/theory.md, equilibrium). A plate glued to the ground is always held.
    """
    if not problem.tensionless:
        return
    free = _free_motions(problem)
    if free.shape[1] == 0:
        return
    corners = _extreme_points(problem)
    size = np.ptp(corners, axis=0).max()
    scale = np.array([1.0, 1 / size, 1 / size])
    motions = np.linalg.qr(scale[:, None] ** -1 * free)[0]
    work = (_resultant(problem) * scale) @ motions
    if _only_pushed(problem):
        generators = np.column_stack([np.ones(len(corners)), corners * scale[1:]]) @ motions
        worst = min((float(n @ work) for n in _faces(generators)), default=np.inf)
        possible = worst > MARGIN * np.abs(problem.load[:, W]).sum()
    else:
        possible = _can_balance(problem, motions, scale, work)
    if not possible:
        raise NoEquilibrium(_reason(problem, corners))


def _only_pushed(problem: Problem) -> bool:
    """Return whether all that bears one way pushes up, without limit, on the plate that the ground pushes everywhere.

    Supports that push up then add nothing to the ground.
    """
    b = problem.bearing
    pulls = (b.law.sign > 0) & (b.support >= 0) & ~b.law.both_ways
    return not (pulls.any() or np.isfinite(b.law.capacity).any())


def _can_balance(problem: Problem, motions: Array, scale: Array, work: Array) -> bool:
    """Return whether bearings with limits, or that pull, can balance the load with room to spare.

    A linear programme: are there forces, each a little off zero and off its capacity, that do the load's work on the
    free motions?
    """
    from scipy.optimize import linprog

    b, law = problem.bearing, problem.bearing.law
    use = np.flatnonzero(~law.both_ways & (law.capacity > 0))
    if not len(use):
        return False
    length = np.ptp(problem.mesh.nodes[problem.plate_nodes], axis=0).max()
    size = (np.abs(problem.load[:, W]).sum() + np.abs(problem.load[:, BETA_X:TOP]).sum() / length) or 1.0
    up = np.where(b.support[use] < 0, 1.0, -law.sign[use])
    places = problem.mesh.nodes[b.node[use]]
    generators = up[:, None] * (np.column_stack([np.ones(len(use)), places * scale[1:]]) @ motions)
    capacity = law.capacity[use] / size
    little = ROOM * np.minimum(capacity, 1 / len(use))
    bounds = [(low, None if np.isinf(high) else high - low) for low, high in zip(little, capacity, strict=True)]
    found = linprog(np.zeros(len(use)), A_eq=generators.T, b_eq=work / size, bounds=bounds, method="highs")
    return bool(found.status == 0)


def _free_motions(problem: Problem) -> Array:
    """Return the rigid motions w = a + b x + c y that the supports which act both ways allow, as columns (3, d)."""
    nodes, b = problem.plate_nodes, problem.bearing
    held = problem.unknown[:, : BETA_Y + 1] < 0
    both = b.law.both_ways
    held[b.node[both], b.field[both]] = True
    held = held[nodes]
    x, y = problem.mesh.nodes[nodes].T
    one, zero = np.ones_like(x), np.zeros_like(x)
    own_w = np.ones(len(nodes), dtype=bool)
    if not problem.element.centre_w:
        own_w[np.isin(nodes, problem.mesh.elements[problem.plate_elements, 8])] = False
    rows = [
        np.column_stack([one, x, y])[held[:, W] & own_w],
        np.column_stack([zero, one, zero])[held[:, BETA_X]],
        np.column_stack([zero, zero, one])[held[:, BETA_Y]],
    ]
    constraints = np.vstack(rows)
    _, sizes, V = np.linalg.svd(np.linalg.qr(np.vstack([constraints, np.zeros((3, 3))]), mode="r"))
    rank = int((sizes > 1e-10 * max(sizes.max(), 1e-300)).sum())
    return V[rank:].T


def _extreme_points(problem: Problem) -> Array:
    """Return the corners (c, 2) of the convex hull of the plate [m], in their order around it."""
    from shapely import get_coordinates, linestrings

    # a line through all nodes has their hull, and is one object instead of one a node
    corners: Array = get_coordinates(linestrings(problem.mesh.nodes[problem.plate_nodes]).convex_hull)[:-1]
    return corners


def _resultant(problem: Problem) -> Array:
    """Return the load's force and its moments (sum F, sum F x, sum F y) [N, N m], moments at nodes included."""
    x, y = problem.mesh.nodes.T
    F = problem.load[:, : TOP + 1]
    return np.array([F[:, W].sum(), (F[:, W] * x + F[:, BETA_X]).sum(), (F[:, W] * y + F[:, BETA_Y]).sum()])


def _faces(generators: Array) -> list[Array]:
    """Return the inward normals of the faces of the cone that the rows of generators (c, d), d <= 3, span.

    The rows stand in their order around the plate, so that with d = 3 each two neighbours span a face.
    """
    d = generators.shape[1]
    if d == 3:
        normals = np.cross(generators, np.roll(generators, -1, axis=0))
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        return list(normals * np.sign(normals @ generators.sum(axis=0))[:, None])
    faces = []
    for subset in combinations(generators, d - 1):
        _, sizes, V = np.linalg.svd(np.reshape(subset, (d - 1, d)), full_matrices=True)
        if len(sizes) and sizes.min() < 1e-12:
            continue
        faces += [n for n in (V[-1], -V[-1]) if (generators @ n >= -1e-12).all()]
    return faces


def _within(corners: Array, place: Array, symmetry: tuple[bool, bool]) -> bool:
    """Return whether a place (2,) lies clear inside the hull of the corners (c, 2) and their images [m]."""
    from shapely import MultiPoint, Point

    for axis in (0, 1):
        if symmetry[axis]:
            corners = np.vstack([corners, corners * np.where(np.arange(2) == axis, -1.0, 1.0)])
    hull = MultiPoint(corners).convex_hull
    return bool(hull.contains(Point(place)) and hull.exterior.distance(Point(place)) > MARGIN * np.ptp(corners))


def _reason(problem: Problem, corners: Array) -> str:
    """Return a sentence that says where the load goes and where it would have to go."""
    F, Fx, Fy = _resultant(problem)
    share = 2.0 ** sum(problem.symmetry)
    law = problem.bearing.law
    most = law.capacity[~law.both_ways & ((problem.bearing.support < 0) | (law.sign < 0))].sum()
    if most <= F * (1 + ROOM):
        return (
            f"the loads of {F * share / 1e3:.6g} kN are more than ground and supports can carry at their limits, "
            f"{most * share / 1e3:.6g} kN; enlarge the plate, or look at contact.limit_pressure and at the limits of "
            "the supports"
        )
    size = np.abs(problem.load[:, W]).sum()
    if MARGIN * size >= F:
        return (
            f"the loads do not press the plate down: their sum is {F * share / 1e3:.6g} kN (downwards positive), and "
            "ground that cannot pull holds nothing against it; add the missing load (self weight?), or glue the plate "
            "to the ground with contact.tensionless = false"
        )
    place = [0.0 if mirrored else value / F for value, mirrored in zip((Fx, Fy), problem.symmetry, strict=True)]
    place = [coordinate(value) for value in place]
    if _within(corners, np.array(place), problem.symmetry):
        return (
            f"the loads cannot be balanced: their resultant of {F * share / 1e3:.6g} kN acts on the plate, at "
            f"x = {place[0]:.6g} m, y = {place[1]:.6g} m, but ground and supports cannot carry it there; move the load "
            "inwards, enlarge the plate, or look at contact.limit_pressure, at voids without depth and at the limits "
            "of the supports"
        )
    (x0, y0), (x1, y1) = corners.min(axis=0), corners.max(axis=0)
    x0, y0 = (-x1 if problem.symmetry[0] else x0), (-y1 if problem.symmetry[1] else y0)
    return (
        f"the loads topple the plate: their resultant of {F * share / 1e3:.6g} kN acts at x = {place[0]:.6g} m, "
        f"y = {place[1]:.6g} m, on or outside the edge of the plate (x {x0:.6g} .. {x1:.6g} m, "
        f"y {y0:.6g} .. {y1:.6g} m), where pressure alone cannot balance it; move the load inwards, enlarge the plate "
        "or support it"
    )
