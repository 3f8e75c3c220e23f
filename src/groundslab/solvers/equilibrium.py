"""Existence and uniqueness of the equilibrium of a plate on one-sided bearings.

Existence is decided before anything is solved, uniqueness once the bearings that touch are known.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.errors import NeutralEquilibrium, NoEquilibrium
from groundslab.fem.bearings import CLOSED, Contact
from groundslab.fem.problem import (
    BETA_X,
    BETA_Y,
    TOP,
    Problem,
    W,
    free_motions,
    joined_plates,
    mirror_motion,
    motion_rows,
    move_plates,
    single_plates,
)
from groundslab.geometry.plan import Place, format_place
from groundslab.units import format_coordinate

#: How far, relative to the plate's size, the resultant must stay inside the hull of the plate.
MARGIN = 1e-9
#: The same for bearings with limits: the share of its capacity by which each must be able to stay off both ends.
LIMIT_MARGIN = 1e-6
#: What touches holds a rigid motion if the mean square of that motion over its forces is this share of the largest
#: over the plate: forces that are rounding, or that all act on one line, do not.
NEUTRAL = 1e-9


def require_equilibrium(problem: Problem) -> None:
    """Raise NoEquilibrium, saying why, unless contact pressure and supports can balance the load with a margin.

    The load's work on the rigid motions that the supports leave free must lie inside the cone of what single upward
    forces under the plate do on them (docs/theory.md, equilibrium). A plate glued to the ground is always held. Of
    plates under one building nothing is decided here, as it may hold what the loads on one of them would topple.
    """
    if not problem.contact.tensionless or (problem.building is not None and len(problem.plate.names) > 1):
        return
    for plates, _ in joined_plates(problem):
        _require_balance(plates, _prefix(problem, plates))


def _prefix(problem: Problem, plates: Problem) -> str:
    """Return which of several plates a sentence is about."""
    return f"{' and '.join(plates.plate.names)}: " if len(problem.plate.names) > 1 else ""


def _require_balance(problem: Problem, prefix: str) -> None:
    """Raise NoEquilibrium unless pressure and supports can balance the load of a plate, or of joined ones."""
    free = free_motions(problem)
    if free.shape[1] == 0:
        return
    if len(problem.plate.names) > 1:
        _require_joint_balance(problem, free, prefix)
        return
    corners = _extreme_points(problem)
    scale = _scale(corners)
    motions = np.linalg.qr(scale[:, None] ** -1 * free)[0]
    work = (_resultant(problem) * scale) @ motions
    if _only_pushed(problem):
        generators = np.column_stack([np.ones(len(corners)), corners * scale[1:]]) @ motions
        worst = min((float(n @ work) for n in _faces(generators)), default=np.inf)
        possible = worst > MARGIN * problem.loading.size.sum()
    else:
        possible = _share_balanced(problem, motions, scale, work, LIMIT_MARGIN)[0] >= 1
    if not possible:
        raise NoEquilibrium(prefix + _reason(problem, corners, motions, scale, work))


def _require_joint_balance(problem: Problem, free: Array, prefix: str) -> None:
    """Raise NoEquilibrium unless pressure and supports can balance the load on the free motions of joined plates."""
    corners = _extreme_points(problem)
    scale = np.tile(_scale(corners), len(problem.plate.names))
    motions = np.linalg.qr(scale[:, None] ** -1 * free)[0]
    work = (np.concatenate([_resultant(plate) for plate, _ in single_plates(problem)]) * scale) @ motions
    if _share_balanced(problem, motions, scale, work, LIMIT_MARGIN)[0] < 1:
        raise NoEquilibrium(
            f"{prefix}the loads on these joined plates cannot be balanced: ground that cannot pull, supports and what "
            "joints carry from one plate to another do not hold them; add the missing load (self weight?), move the "
            "loads inwards, or support the plates"
        )


def rigid_motions(problem: Problem) -> Array:
    """Return the plate's rigid motions against which only one-sided bearings hold it, as unknowns (size, m)."""
    if not problem.contact.tensionless:
        return np.zeros((problem.unknown.max(initial=-1) + 1, 0))
    nodes, unknown, moved = problem.plate.nodes, problem.unknown, move_plates(problem, free_motions(problem))
    # where the plate goes the ground does not go with it
    moved = np.concatenate([moved, -moved[:, [W]]], axis=1)[nodes]
    motions = np.zeros((unknown.max(initial=-1) + 1, moved.shape[2]))
    mask = unknown[nodes, : TOP + 1] >= 0
    motions[unknown[nodes, : TOP + 1][mask]] = moved[mask]
    return motions


def require_hold(problem: Problem, contact: Contact, pressing: Array | None = None) -> None:
    """Raise NeutralEquilibrium if the plate can still move as a rigid body against what touches it with some force.

    The solution would then be one of many. Bearings that have reached their limit give way and hold nothing. pressing
    (c,) are the forces of an elastic continuum's cells.
    """
    if not problem.contact.tensionless:
        return
    elastic = problem.elastic
    for plates, mask in joined_plates(problem):
        pressed = None
        if elastic is not None and pressing is not None:
            numbers = [problem.plate.names.index(name) for name in plates.plate.names]
            pressed = pressing[np.isin(elastic.cells.plate, numbers)]
        _require_plates_held(plates, contact.state[mask], contact.force[mask], pressed, _prefix(problem, plates))


def _require_plates_held(problem: Problem, state: Integers, force: Array, pressing: Array | None, prefix: str) -> None:
    """Raise NeutralEquilibrium if plates can move against bearings in states (c,) with forces (c,).

    pressing (k,) are the forces of the cells under them.
    """
    free = free_motions(problem, mirrored=True)
    if free.shape[1] == 0:
        return
    b = problem.contact.bearing
    touching = np.flatnonzero((state == CLOSED) & ~b.law.bilateral & (b.field <= TOP))
    force = np.maximum(force[touching], 0.0)
    rows = motion_rows(problem, b.node[touching], b.field[touching])
    for axis in (0, 1):
        if problem.symmetry[axis]:
            rows, force = np.vstack([rows, rows * mirror_motion(axis)]), np.tile(force, 2)
    if pressing is not None and problem.elastic is not None:
        holding = np.where(pressing < problem.elastic.limit_force, pressing, 0.0)
        rows, force = np.vstack([rows, _rows_of_cells(problem)]), np.append(force, holding)
    corners = _extreme_points(problem)
    scale = _scale(corners)
    centre = corners.mean(axis=0)
    # motions about the plate's middle, as large at its ends as it is when it settles
    about = np.array([[1.0, -centre[0] * scale[1], -centre[1] * scale[2]], [0, scale[1], 0], [0, 0, scale[2]]])
    about = np.kron(np.eye(len(problem.plate.names)), about)
    motions = np.linalg.qr(np.linalg.solve(about, free))[0]
    size = max(force.sum(), problem.loading.size.sum(), np.finfo(float).tiny)
    resisted = rows @ about @ motions
    shares, directions = np.linalg.eigh(resisted.T @ (force[:, None] / size * resisted))
    loose = about @ motions @ directions[:, shares < NEUTRAL]
    if loose.shape[1]:
        if len(problem.plate.names) == 1:
            moves = f"the plate {_movement(loose, 1 / scale[1], problem.origin)}"
        else:
            moves = "the joined plates can move"
        raise NeutralEquilibrium(
            f"{prefix}the equilibrium is neutral: {moves} without any resistance, so that the settlement is one of "
            "many; support it there, or add the load that decides where it comes to rest"
        )


def _movement(motions: Array, size: float, origin: Place) -> str:
    """Return in words how a plate of some size [m] can move; motions w = a + b x + c y as columns (3, 1 to 3).

    The origin of x and y lies there in the plan that was given [m].
    """
    if motions.shape[1] == 3:
        return "can move up and down and rock in every direction"
    if motions.shape[1] == 2:
        # what both leave where it is lies on the line through their zeros
        x, y, z = np.cross(motions[:, 0], motions[:, 1])[[1, 2, 0]]
        if abs(z) > 1e-6 * max(abs(x), abs(y)) / size:
            return f"can rock about the point {format_place((x / z, y / z), origin)} m in every direction"
        return "can move up and down and rock"
    a, b, c = motions[:, 0]
    if max(abs(b), abs(c)) * size < 1e-6 * abs(a):
        return "can move up and down"
    a -= b * origin[0] + c * origin[1]
    if abs(b) < 1e-6 * abs(c):
        return f"can rock about the line y = {format_coordinate(-a / c)} m"
    if abs(c) < 1e-6 * abs(b):
        return f"can rock about the line x = {format_coordinate(-a / b)} m"
    return f"can rock about the line y = {format_coordinate(-a / c)} m {'-' if b / c > 0 else '+'} {abs(b / c):.4g} x"


def _scale(corners: Array) -> Array:
    """Return what makes settlement and slopes of a plate alike: 1, and 1 over its size [1/m] twice."""
    size = np.ptp(corners, axis=0).max()
    return np.array([1.0, 1 / size, 1 / size])


@dataclass(frozen=True, slots=True)
class _OneWay:
    """What acts on plates one way: the ground, at nodes or in cells, and supports."""

    up: Array  # (c,): 1.0 if it pushes up, -1.0 if it holds down
    row: Array  # (c, 3 plates): what rigid motions settle there
    limit_force: Array  # (c,) [N]
    support: Integers  # (c,): number of the support, -1 for the ground


def _one_way(problem: Problem) -> _OneWay:
    """Return all that acts on plates one way."""
    b, elastic = problem.contact.bearing, problem.elastic
    law = b.law
    mask = ~law.bilateral & (b.field <= TOP)
    up = np.where(b.support[mask] < 0, 1.0, -law.sign[mask])
    row, limit_force, support = (
        motion_rows(problem, b.node[mask], b.field[mask]),
        law.limit_force[mask],
        b.support[mask],
    )
    if elastic is not None:
        cells = len(elastic.gap)
        up, support = np.append(up, np.ones(cells)), np.append(support, np.full(cells, -1))
        row, limit_force = np.vstack([row, _rows_of_cells(problem)]), np.append(limit_force, elastic.limit_force)
    return _OneWay(up, row, limit_force, support)


def _rows_of_cells(problem: Problem) -> Array:
    """Return what rigid motions settle at the cells of an elastic continuum, (c, 3 plates)."""
    assert problem.elastic is not None
    cells = problem.elastic.cells
    rows = np.zeros((len(cells.area), len(problem.plate.names), 3))
    rows[np.arange(len(rows)), cells.plate] = np.column_stack([np.ones(len(rows)), cells.center])
    return rows.reshape(len(rows), -1)


def _only_pushed(problem: Problem) -> bool:
    """Return whether all that bears one way pushes up, without limit, on the plate that the ground pushes everywhere.

    Supports that push up then add nothing to the ground.
    """
    b = _one_way(problem)
    return not ((b.up < 0).any() or np.isfinite(b.limit_force).any())


def _share_balanced(problem: Problem, motions: Array, scale: Array, work: Array, margin: float) -> tuple[float, Flags]:
    """Return which share of the load bearings with limits can balance, 1 at most, and which are then at their limit.

    A linear program: how large a share of the load's work on the free motions can forces do, each a little off zero
    and off its limit force? Also which of what acts one way (c,) is at its limit.
    """
    from scipy.optimize import linprog

    b = _one_way(problem)
    full = np.zeros(len(b.up), dtype=bool)
    use = np.flatnonzero(b.limit_force > 0)
    # forced curvature, as by temperature, presses supports that pull against the ground without any force from outside
    size = float(problem.loading.size.sum()) or float(np.abs(problem.load[:, BETA_X : BETA_Y + 1]).sum() * scale[1])
    if not len(use) or size == 0:
        return 0.0, full
    generators = b.up[use, None] * ((b.row[use] * scale) @ motions)
    capacity = b.limit_force[use] / size
    little = margin * np.minimum(capacity, 1 / len(use))
    bounds = [(low, None if np.isinf(high) else high - low) for low, high in zip(little, capacity, strict=True)]
    optimum = linprog(
        np.append(np.zeros(len(use)), -1.0),
        A_eq=np.column_stack([generators.T, -work / size]),
        b_eq=np.zeros(len(work)),
        bounds=[*bounds, (0.0, 1.0)],
        method="highs",
    )
    if optimum.status != 0:
        return 0.0, full
    full[use] = optimum.x[:-1] >= capacity - 2 * little
    return float(optimum.x[-1]), full


def _extreme_points(problem: Problem) -> Array:
    """Return the corners (c, 2) of the convex hull of the plate [m], in their order around it."""
    from shapely import get_coordinates, linestrings

    # a line through all nodes has their hull, and is one object instead of one a node
    corners: Array = get_coordinates(linestrings(problem.mesh.nodes[problem.plate.nodes]).convex_hull)[:-1]
    return corners


def _resultant(problem: Problem) -> Array:
    """Return the force on the plate and its moments (sum F, sum F x, sum F y) [N, N m], moments at nodes included."""
    x, y = problem.mesh.nodes.T
    F = problem.plate_load
    return np.array([F[:, W].sum(), (F[:, W] * x + F[:, BETA_X]).sum(), (F[:, W] * y + F[:, BETA_Y]).sum()])


def _faces(generators: Array) -> list[Array]:
    """Return the inward normals of the faces of the cone that the rows of generators (c, d), d <= 3, span.

    The rows stand in their order around the plate, so that with d = 3 each two neighbors span a face.
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


def _reason(problem: Problem, corners: Array, motions: Array, scale: Array, work: Array) -> str:
    """Return a sentence that says where the load goes and where it would have to go."""
    F, Fx, Fy = _resultant(problem)
    F = 0.0 if abs(F) <= MARGIN * problem.loading.size.sum() else F
    share = 2.0 ** sum(problem.symmetry)
    b = _one_way(problem)
    pushing, pulling = b.up > 0, b.up < 0
    most, least = b.limit_force[pushing].sum(), b.limit_force[pulling].sum()
    if most <= F * (1 + LIMIT_MARGIN):
        return (
            f"the loads of {F * share / 1e3:.6g} kN are more than ground and supports can carry at their limits, "
            f"{most * share / 1e3:.6g} kN; enlarge the plate, or look at {_limits(b, pushing)}"
        )
    if 0 < least <= -F * (1 + LIMIT_MARGIN):
        return (
            f"the loads lift the plate by {-F * share / 1e3:.6g} kN, more than the supports can hold down at their "
            f"limits, {least * share / 1e3:.6g} kN; look at {_limits(b, pulling)}, or add weight"
        )
    balanced, full = _share_balanced(problem, motions, scale, work, 0.0)
    if MARGIN < balanced < 1 and full.any():
        return (
            f"the loads, {F * share / 1e3:.6g} kN in all (downwards positive), are more than ground and supports can "
            f"balance where they act: {100 * balanced:.4g} % of them bring {_limits(b, full)} to the limit; move "
            "the loads, or add to what carries them"
        )
    if MARGIN * problem.loading.size.sum() >= F:
        return (
            f"the loads do not press the plate down: their sum is {F * share / 1e3:.6g} kN (downwards positive), and "
            "ground that cannot pull holds nothing against it; add the missing load (self weight?), or supports "
            "that hold it down"
        )
    place = [0.0 if mirrored else value / F for value, mirrored in zip((Fx, Fy), problem.symmetry, strict=True)]
    x, y = (format_coordinate(value + start) for value, start in zip(place, problem.origin, strict=True))
    if _within(corners, np.array(place), problem.symmetry):
        return (
            f"the loads cannot be balanced: their resultant of {F * share / 1e3:.6g} kN acts on the plate, at "
            f"x = {x} m, y = {y} m, but ground and supports cannot carry it there; move the load "
            "inwards, enlarge the plate, or look at contact.limit_pressure, at voids without depth and at the limits "
            "of the supports"
        )
    (x0, y0), (x1, y1) = corners.min(axis=0), corners.max(axis=0)
    x0, y0 = (-x1 if problem.symmetry[0] else x0), (-y1 if problem.symmetry[1] else y0)
    left, right = (format_coordinate(value + problem.origin[0]) for value in (x0, x1))
    low, high = (format_coordinate(value + problem.origin[1]) for value in (y0, y1))
    return (
        f"the loads topple the plate: their resultant of {F * share / 1e3:.6g} kN acts at x = {x} m, y = {y} m, on or "
        f"outside the edge of the plate (x {left} .. {right} m, y {low} .. {high} m), where pressure alone "
        "cannot balance it; move the load inwards, enlarge the plate or support it"
    )


def _limits(b: _OneWay, which: Flags) -> str:
    """Return the names of the limits that some of what acts one way (c,) has, as the file calls them."""
    limited = which & np.isfinite(b.limit_force)
    supports = b.support[limited]
    names = [f"supports[{number + 1}].limit" for number in np.unique(supports[supports >= 0])]
    if (supports < 0).any():
        lasting = b.limit_force[limited][supports < 0] > 0
        names += ["contact.limit_pressure"] * bool(lasting.any()) + ["voids without depth"] * bool((~lasting).any())
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)
