"""Random bearings and dense matrices of nine unknowns, to test contact with."""

from __future__ import annotations

import numpy as np

from groundslab.fem.assembly import Pattern, build_pattern
from groundslab.fem.bearings import Bearings
from groundslab.fem.sparse.symmetric import Symmetric

NODES = np.arange(9)


def one_element(fields: int = 1) -> Pattern:
    """Return the pattern of nine nodes that all see each other."""
    return build_pattern(NODES[None], NODES, np.arange(9 * fields).reshape(9, fields))


def entries(p: Pattern, A: np.ndarray) -> Symmetric:
    """Return A in the pattern."""
    row = np.repeat(np.arange(p.size), np.diff(p.indptr))
    return Symmetric(p.indptr, p.indices, A[row, p.indices])


def positive(rng: np.random.Generator, n: int, condition: float) -> np.ndarray:
    """Return a random positive definite matrix."""
    Q = np.linalg.qr(rng.standard_normal((n, n)))[0]
    return (Q * np.geomspace(1, condition, n)) @ Q.T


def any_bearings(rng: np.random.Generator, n: int, count: int) -> Bearings:
    """Return bearings of every kind on different unknowns: rigid, elastic, yielding, one-sided, bilateral."""

    def some(value: float) -> np.ndarray:
        return np.where(rng.random(count) < 0.5, value, rng.uniform(0.05, 2.0, count))

    stiffness, bilateral = some(np.inf), rng.random(count) < 0.2
    limit_force = np.where(bilateral, np.inf, some(np.inf))
    unknown = rng.permutation(n)[:count]
    sign = rng.choice([-1.0, 1.0], count)
    return Bearings(unknown, sign, rng.normal(0, 0.3, count), stiffness, limit_force, bilateral)
