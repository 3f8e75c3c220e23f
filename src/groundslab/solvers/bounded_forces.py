"""Forces between bounds that act against gaps: minimize 1/2 x.A x + c.x with lower <= x <= upper and G x = e.

Where a force lies between its bounds its gap y = A x + c + G^T alpha is zero, at the lower bound it is open, y >= 0, at
the upper one it is driven in, y <= 0. An active set follows the signs of forces and gaps (Hintermueller, Ito and
Kunisch 2002). On each set conjugate gradients, projected on G q = 0 and preconditioned (Gould, Hribar and Nocedal
2001), go on until what is left of the gaps of free forces is small beside what is wrong at the bounds: proportioning
(Dostal 1997). Such a sequence of sets can go round in circles. Whenever the energy has not fallen for long, the
iteration returns to the forces of least energy, and from there goes downhill along a projected gradient (More and
Toraldo 1991): it converges. Products with A are what costs.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.errors import NoEquilibrium, NotConverged

#: Conjugate gradients on one set end when the gaps of free forces are below this share of what is wrong at the bounds.
PROPORTION = 0.5
#: So many sets may follow each other without forces of less energy than any before, until first they had to be led.
PATIENCE = 10
#: A step downhill of which the energy allows less than this share is tried again,
SHORT = 0.6
#: but no more often than this.
MAX_SHORTER = 4
#: With an approximate matrix a solution's error is taken down to this share of what it was,
CORRECTED = 0.01
#: as long as that takes no more products with it than this,
MOST_CHEAP = 100
#: and the error with A itself falls below this share each time.
PAYS = 0.5
#: Displacements of less than this share of those at the start are none.
NEGLIGIBLE = 1e-10
#: Given combinations of forces are exact to this share of their parts.
BALANCED = 1e-12
MAX_BALANCING = 200
#: Where hardly a force lies between its bounds steps are those of forces that all do, divided by this.
STIFFER = 1e-3
#: A step is halved beyond which what is missing has more than this share of what was, with the other sign.
TOO_FAR = 0.5
#: What linprog says where no point fulfills all conditions.
INFEASIBLE = 2
#: Combinations of free forces are dependent if one has less than this share of the largest.
DEPENDENT = 1e-12


@dataclass(frozen=True, slots=True)
class BoundedForces:
    """The problem of n forces, of which r combinations are given."""

    gaps: Callable[[Array], tuple[Array, Array]]  # A x + c for x with G x = e, and the size of displacements there
    multiply: Callable[[Array], Array]  # A q for q with G q = 0
    precondition: Callable[[Array], Array]  # about the inverse of A, symmetric positive definite
    G: Array  # (r, n)
    e: Array  # (r,)
    lower: Array  # (n,)
    upper: Array  # (n,)
    weight: Array  # (n,): how forces share a resultant as long as nothing is known
    flexibility: Array  # (n,): about the gap that a unit force of its own opens
    approximate: Callable[[Array], Array] | None = None  # about A q for less, by a symmetric positive definite matrix

    @property
    def can_change(self) -> Flags:
        """Return which forces are not given by equal bounds, (n,)."""
        return self.lower < self.upper

    def clip(self, x: Array) -> Array:
        """Return forces (n,) cut off at their bounds."""
        return np.clip(x, self.lower, self.upper)

    def within(self, x: Array) -> Flags:
        """Return which forces (n,) lie between their bounds."""
        return (x > self.lower) & (x < self.upper)


@dataclass(frozen=True, slots=True)
class BoundedSolution:
    """Forces x (n,) with their gaps y (n,), the multipliers alpha (r,), and how many products with A that took."""

    x: Array
    y: Array
    alpha: Array
    products: int


def solve(
    p: BoundedForces, start: Array, tolerance: float, limit: int, report: Callable[[int, int, int], None]
) -> BoundedSolution:
    """Return the solution from a start (n,), to gaps that are wrong by a share of the displacements at most.

    report takes iteration, forces that are not zero and changes. Raises NotConverged after `limit` products with A,
    and NoEquilibrium if forces between their bounds cannot have the given combinations.
    """
    x = balance(p, start, p.can_change)
    if p.approximate is None:
        return iterate(p, x, tolerance, limit, report)
    x, used = correct(p, p.approximate, x, tolerance, limit)
    solution = iterate(p, x, tolerance, limit - used, report)
    return replace(solution, products=solution.products + used)


def iterate(
    p: BoundedForces, x: Array, tolerance: float, limit: int, report: Callable[[int, int, int], None]
) -> BoundedSolution:
    """Return the solution, as `solve` does, from balanced forces x (n,) by products with A alone."""
    g, size = p.gaps(x)
    free, best, history = p.within(x), (x, g), list[dict[str, int]]()
    products, patience, waited, least = 1, PATIENCE, 0, NEGLIGIBLE * np.maximum(size, np.abs(g).max())
    while True:
        small = tolerance * np.maximum(size, least)
        face, used = relax(p, make_face(p, x, g, free), small, limit - products)
        products += used
        x, wrong = face.x, face.wrong(small)
        changed, bearing = int(wrong.sum()), int((p.clip(x) != 0).sum())
        history.append({"iteration": len(history) + 1, "closed": bearing, "changed": changed, "products": products})
        report(len(history), bearing, changed)
        if not changed and not used and face.residual(small) <= 1:
            return BoundedSolution(x, face.y, face.alpha, products)
        if products >= limit:
            raise NotConverged("the contact pressure", history, {"x": p.clip(x)})
        free = face.free ^ wrong
        if (x != p.clip(x)).any():
            x = balance(p, x, free)
            free |= p.within(x)
        # sums of steps are not as exact as what follows from the forces themselves
        g, size = p.gaps(x)
        products += 1
        waited = waited + 1 if changed and energy_between(*best, x, g) >= 0 else 0
        if waited > patience:
            x, g, used = descend(p, *best, x, g)
            # at a corner of all that is balanced between bounds only the set can change
            free = p.within(x) if (x != best[0]).any() else free | p.within(x)
            products, patience, waited = products + used, 0, 0
        if not waited:
            best = x, g


def correct(
    p: BoundedForces, approximate: Callable[[Array], Array], x: Array, tolerance: float, limit: int
) -> tuple[Array, int]:
    """Return forces (n,) close to the solution, and how many products with A they took.

    The energy is that of A at x and its gradient, with a cheaper matrix for what is beyond. Where that is least the
    step from x ends, unless the energy of A says that it should be shorter; and so on, as long as it pays.
    """
    (g, size), products, last = p.gaps(x), 1, np.inf
    while products < limit - 1:
        face, scale = make_face(p, x, g, p.within(x)), np.maximum(size, NEGLIGIBLE * np.abs(g).max())
        error = tolerance * max(face.residual(tolerance * scale), face.violation(tolerance * scale))
        if error <= tolerance or error > PAYS * last:
            break
        inner = replace(p, gaps=partial(_continue, approximate, x, g, scale), multiply=approximate, approximate=None)
        try:
            solution = iterate(inner, x, max(tolerance / 2, CORRECTED * error), MOST_CHEAP, lambda *_: None)
        except NotConverged:
            break
        s = solution.x - x
        As = p.multiply(s)
        share = _best_share(g, s, As)
        share = 1.0 if share >= SHORT else share
        x, g, products, last = x + share * s, g + share * As, products + 1, error
    return x, products


def _continue(multiply: Callable[[Array], Array], x: Array, g: Array, size: Array, to: Array) -> tuple[Array, Array]:
    """Return the gaps (n,) of forces to (n,) from those g (n,) of forces x (n,), and the sizes of displacements."""
    return g + multiply(to - x), size


@dataclass(frozen=True, slots=True)
class Face:
    """Forces x (n,), of which some are free, with their gaps: g without the multipliers alpha (r,), y with them."""

    p: BoundedForces
    free: Flags  # (n,)
    planes: Array  # (n, r): orthonormal combinations of the rows of G, where forces are free
    to_alpha: Array  # (r, r): makes multipliers of the products of gaps with these
    x: Array
    g: Array
    alpha: Array
    y: Array

    def move(self, x: Array, g: Array) -> Face:
        """Return the face with other forces and gaps (n,); alpha leaves the least of the gaps of free forces."""
        alpha = self.to_alpha @ (self.planes.T @ g)
        return replace(self, x=x, g=g, alpha=alpha, y=g + self.p.G.T @ alpha)

    def project(self, v: Array) -> Array:
        """Return what is left of values (n,) where forces are free, without resultants."""
        v = np.where(self.free, v, 0.0)
        # what is fixed stays so, whatever the rounding of the planes
        return np.where(self.free, v - self.planes @ (self.planes.T @ v), 0.0)

    def residual(self, small: Array) -> float:
        """Return the largest gap of a free force over what is small there (n,)."""
        return _largest(self.y, small, self.free)

    def wrong(self, small: Array) -> Flags:
        """Return the free forces beyond their bounds, and those at bounds that gaps above small ones contradict."""
        p, x, y = self.p, self.x, self.y
        beyond = (x < p.lower) | (x > p.upper)
        contradicted = ((x <= p.lower) & (y < -small) | (x >= p.upper) & (y > small)) & p.can_change
        return np.where(self.free, beyond, contradicted)

    def violation(self, small: Array) -> float:
        """Return the largest gap that contradicts a force at its bound, or that cutting off a free force opens.

        It is over what is small there (n,).
        """
        beyond = self.p.flexibility * np.abs(self.x - self.p.clip(self.x))
        return _largest(np.where(self.free, beyond, self.y), small, self.wrong(small))


def _largest(gaps: Array, small: Array, which: Flags) -> float:
    """Return the largest of some gaps (n,) over small ones (n,), where nothing is small enough infinite."""
    sizes = np.abs(gaps[which])
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = np.where(sizes > 0, sizes / small[which], 0.0)
    return float(shares.max(initial=0.0))


def make_face(p: BoundedForces, x: Array, g: Array, free: Flags) -> Face:
    """Return the face of some free forces (n,) among forces x (n,) with gaps g (n,)."""
    combined = np.where(free, p.G, 0.0).T
    planes, to_alpha = [np.zeros((len(x), 0))], [np.zeros((len(p.G), 0))]
    for group in _apart(p.G):
        acting = p.G[group].any(axis=0)
        columns, size, rows = np.linalg.svd(combined[np.ix_(acting, group)], full_matrices=False)
        independent = size > DEPENDENT * size.max(initial=0.0)
        back = np.zeros((len(x), int(independent.sum())))
        back[acting] = columns[:, independent]
        multipliers = np.zeros((len(p.G), int(independent.sum())))
        multipliers[group] = -(rows[independent].T / size[independent])
        planes.append(back)
        to_alpha.append(multipliers)
    return Face(p, free, np.hstack(planes), np.hstack(to_alpha), x, g, np.zeros(len(p.G)), g).move(x, g)


def _apart(G: Array) -> list[Integers]:
    """Return the combinations (r,) in groups that have no force in common, such as those of plates apart.

    What rounding leaves of the large forces of one is then none of the small forces of another.
    """
    from scipy.sparse.csgraph import connected_components

    if not len(G):
        return []
    acting = G != 0
    count, group = connected_components(acting @ acting.T, directed=False)
    return [np.flatnonzero(group == number) for number in range(count)]


def relax(p: BoundedForces, face: Face, small: Array, limit: int) -> tuple[Face, int]:
    """Return a face after steps of conjugate gradients, and how many.

    They end when the gaps of free forces are small, or no more than PROPORTION of what is wrong at the bounds.
    """
    q, rz = np.zeros_like(face.x), np.inf
    for step in range(limit):
        if face.residual(small) <= max(PROPORTION * face.violation(small), 1.0):
            return face, step
        r = face.project(-face.y)
        z = face.project(p.precondition(r))
        last, rz = rz, float(r @ z)
        if not rz > 0:
            return face, step
        q = z + rz / last * q
        Aq = p.multiply(q)
        curvature = float(q @ Aq)
        if not curvature > 0:
            return face, step + 1
        face = face.move(face.x + rz / curvature * q, face.g + rz / curvature * Aq)
    return face, limit


def energy_between(x: Array, g: Array, x_after: Array, g_after: Array) -> float:
    """Return by how much the energy differs between two sets of forces with gaps, (n,) each, of equal resultants."""
    return float((g + g_after) @ (x_after - x)) / 2


def descend(p: BoundedForces, x: Array, g: Array, other: Array, g_other: Array) -> tuple[Array, Array, int]:
    """Return forces (n,) of less energy than x with gaps g, their gaps, and the products with A that they took.

    They lie towards the others, and from there down the gradient, projected on what is balanced between bounds. A step
    of which the energy allows less than half is tried again, so much shorter.
    """
    share = _best_share(g, other - x, g_other - g)
    x, g = x + share * (other - x), g + share * (g_other - g)
    down = -make_face(p, x, g, p.within(x)).y / p.flexibility
    length = 1.0
    for tried in range(1, MAX_SHORTER + 1):
        s = balance(p, x + length * np.where(p.can_change, down, 0.0), p.can_change, 1 / p.flexibility) - x
        As = p.multiply(s)
        share = _best_share(g, s, As)
        if share >= SHORT:
            return x + s, g + As, tried
        length *= share
    return x + share * s, g + share * As, tried


def _best_share(g: Array, s: Array, As: Array) -> float:
    """Return the share of a step s (n,), one at most, at which the energy is least that has the gradient g (n,)."""
    curvature = float(s @ As)
    return min(1.0, max(0.0, -float(g @ s) / curvature)) if curvature > 0 else 0.0


def balance(p: BoundedForces, x: Array, among: Flags, weight: Array | None = None) -> Array:
    """Return the forces nearest to x (n,) that lie between their bounds and have the given combinations.

    Only those among some (n,) change, if that is enough. They minimize sum (z - x)^2 / weight; p.weight by default.
    Where they are not found so, as hardly a force lies between its bounds, a linear program finds the nearest by
    sum |z - x|, or that there are none: NoEquilibrium.
    """
    weight = p.weight if weight is None else weight
    everywhere = np.where(p.can_change, weight, 0.0)
    for W in (np.where(among, weight, 0.0), everywhere):
        balanced = _project(p, x, W)
        if balanced is not None:
            return _project_again(p, balanced, W)
    return _project_again(p, _balance_by_program(p, p.clip(x)), everywhere)


def _project_again(p: BoundedForces, x: Array, W: Array) -> Array:
    """Return balanced forces x (n,) with the digits that were lost to a start far off."""
    exact = _project(p, x, W)
    return x if exact is None else exact


def _balance_by_program(p: BoundedForces, x: Array) -> Array:
    """Return the balanced forces for which sum |z - x| is least, from x (n,) between the bounds.

    Raises NoEquilibrium if a linear program shows that there are none.
    """
    from scipy.optimize import linprog

    rows = np.abs(p.G).max(axis=1)
    rows[rows == 0] = 1.0
    missing = (p.e - p.G @ x) / rows
    unit = float(np.abs(missing).max()) / np.sqrt(len(x))
    more_or_less = np.concatenate([p.upper - x, x - p.lower]) / unit
    optimum = linprog(
        np.ones(2 * len(x)),
        A_eq=np.hstack([p.G, -p.G]) / rows[:, None],
        b_eq=missing / unit,
        bounds=np.column_stack([np.zeros(2 * len(x)), more_or_less]),
    )
    if optimum.status == INFEASIBLE:
        raise NoEquilibrium("forces between their bounds cannot balance the loads")
    if optimum.status != 0:
        raise NotConverged("the balance of forces between their bounds", [], {"x": x})
    more, less = np.split(unit * optimum.x, 2)
    return p.clip(x + more - less)


def _project(p: BoundedForces, x: Array, W: Array) -> Array | None:
    """Return z = clip(x + W G^T beta) (n,) with G z = e, if Newton's method finds beta.

    What is missing is the gradient of a concave function of beta, the dual one. Steps that go too far are shorter.
    """
    beta, step, before = np.zeros(len(p.G)), np.zeros(len(p.G)), np.zeros(len(p.G))
    whole = (p.G * W) @ p.G.T
    scale = np.sqrt(np.maximum(np.diag(whole), np.finfo(float).tiny))
    for _ in range(MAX_BALANCING):
        moved = x + W * (p.G.T @ beta)
        z = p.clip(moved)
        size = np.maximum(np.abs(z), np.where(W > 0, np.abs(p.clip(x)), 0.0))
        missing = p.e - p.G @ z
        if (np.abs(missing) <= BALANCED * (np.abs(p.G) @ size)).all():
            return z
        if missing @ step < -TOO_FAR * (before @ step):
            beta, step = beta - step / 2, step / 2
            continue
        J = (p.G * np.where(p.within(moved), W, 0.0)) @ p.G.T
        if _rank(J, scale) < _rank(whole, scale):
            J = J + STIFFER * whole
        step, before = np.asarray(np.linalg.lstsq(J, missing, rcond=None)[0]), missing
        beta = beta + step
    return None


def _rank(matrix: Array, scale: Array) -> int:
    """Return the rank of a symmetric matrix (r, r) whose rows and columns have a scale (r,)."""
    return int(np.linalg.matrix_rank(matrix / np.outer(scale, scale), DEPENDENT, hermitian=True)) if len(scale) else 0
