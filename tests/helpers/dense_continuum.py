"""A Mindlin plate on an elastic continuum by polynomials and full matrices, with none of the package's own methods."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from scipy.interpolate import CubicSpline

from helpers.layered_ground import by_distance


@dataclass(frozen=True)
class Raft:
    """A rectangle a x b about the origin, n x n polynomials for each field, nx x ny cells of constant pressure."""

    a: float
    b: float
    t: float
    E: float
    nu: float
    cells: tuple[int, int]
    n: int = 17

    @property
    def size(self) -> tuple[float, float]:
        """Return the sides of a cell."""
        return self.a / self.cells[0], self.b / self.cells[1]

    @property
    def centers(self) -> tuple[np.ndarray, np.ndarray]:
        """Return x and y of the centers of all cells, number along y first."""
        x, y = ((np.arange(m) + 0.5) * d - m * d / 2 for m, d in zip(self.cells, self.size, strict=True))
        X, Y = np.meshgrid(x, y, indexing="ij")
        return X.ravel(), Y.ravel()

    def stiffness(self) -> np.ndarray:
        """Return the plate's matrix for the fields w, beta_x, beta_y, by exact integration."""
        s, weight = legendre.leggauss(self.n + 1)
        P = legendre.legvander(s, self.n - 1)
        dP = np.array([legendre.legval(s, legendre.legder(unit)) for unit in np.eye(self.n)]).T
        mass, mixed, slope = (A.T @ (weight[:, None] * B) for A, B in ((P, P), (dP, P), (dP, dP)))
        jacobian, hx, hy = self.a * self.b / 4, 2 / self.a, 2 / self.b
        NN, XX, YY = np.kron(mass, mass), hx**2 * np.kron(slope, mass), hy**2 * np.kron(mass, slope)
        XN, YN = hx * np.kron(mixed, mass), hy * np.kron(mass, mixed)  # of w,x beta and w,y beta
        XY = hx * hy * np.kron(mixed, mixed.T)  # of u,x v,y
        D = self.E * self.t**3 / (12 * (1 - self.nu**2))
        S = 5 / 6 * self.E / (2 * (1 + self.nu)) * self.t
        twist = D * (1 - self.nu) / 2
        K = np.block([
            [S * (XX + YY), -S * XN, -S * YN],
            [-S * XN.T, D * XX + twist * YY + S * NN, D * self.nu * XY + twist * XY.T],
            [-S * YN.T, D * self.nu * XY.T + twist * XY, D * YY + twist * XX + S * NN],
        ])  # fmt: skip
        return jacobian * K

    def means(self, x: tuple[np.ndarray, np.ndarray], y: tuple[np.ndarray, np.ndarray]) -> np.ndarray:
        """Return the means of w over rectangles between x and between y, (rectangles, fields' polynomials)."""
        s, weight = legendre.leggauss(self.n)

        def along(low: np.ndarray, high: np.ndarray, side: float) -> np.ndarray:
            at = (low + high)[:, None] / 2 + (high - low)[:, None] / 2 * s
            return np.einsum("q,rqn->rn", weight / 2, legendre.legvander(2 * at / side, self.n - 1))

        of_w = np.einsum("rm,rn->rmn", along(*x, self.a), along(*y, self.b)).reshape(len(x[0]), -1)
        return np.hstack([of_w, np.zeros((len(of_w), 2 * self.n**2))])

    def at(self, x: float, y: float) -> np.ndarray:
        """Return what takes w at a place from the polynomials."""
        values = (legendre.legvander(np.array([2 * p / side]), self.n - 1)[0] for p, side in ((x, self.a), (y, self.b)))
        return np.concatenate([np.kron(*values), np.zeros(2 * self.n**2)])


def half_space(raft: Raft, E: float, nu: float) -> np.ndarray:
    """Return the mean settlement of cells by unit forces, by Love at three by three Gauss points."""
    dx, dy = raft.size
    s, weight = legendre.leggauss(3)
    X, Y = raft.centers
    x, y = X[:, None] - X, Y[:, None] - Y
    found = np.zeros(x.shape)

    def corner(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        return u * np.arcsinh(v / np.abs(u)) + v * np.arcsinh(u / np.abs(v))

    for p, wp in zip(s, weight / 2, strict=True):
        for q, wq in zip(s, weight / 2, strict=True):
            u, v = x + p * dx / 2, y + q * dy / 2
            found += wp * wq * sum(corner(dx / 2 + i * u, dy / 2 + j * v) for i in (-1, 1) for j in (-1, 1))
    return (1 - nu**2) / (math.pi * E * dx * dy) * found


def layered(raft: Raft, E: float, nu: float, T: Callable[[np.ndarray], np.ndarray], h: float) -> np.ndarray:
    """Return the same for ground whose top layer has E, nu and a thickness, and a transfer function T."""
    c = 2 * (1 - nu**2) / E
    r = np.concatenate([np.linspace(1e-4, 3 * h, 300), np.linspace(3 * h, math.hypot(raft.a, raft.b) + 3 * h, 200)[1:]])
    rK = by_distance(T, c, h)
    rest = CubicSpline(r, [(rK(each) - c / (2 * math.pi)) / each for each in r])
    X, Y = raft.centers
    return half_space(raft, E, nu) + rest(np.hypot(X[:, None] - X, Y[:, None] - Y).clip(1e-4))


def press(raft: Raft, F: np.ndarray, f: np.ndarray, tensionless: bool = True) -> tuple[np.ndarray, np.ndarray]:
    """Return polynomials' coefficients and forces of cells under loads f: sets of cells in contact, one after another.

    Cells whose force is below zero leave the set, cells that would be below the plate join it, until none do.
    """
    dx, dy = raft.size
    X, Y = raft.centers
    B = raft.means((X - dx / 2, X + dx / 2), (Y - dy / 2, Y + dy / 2)).T
    K, touching = raft.stiffness(), np.ones(len(X), dtype=bool)
    for _ in range(60):
        A = np.flatnonzero(touching)
        both = np.block([[K, B[:, A]], [B[:, A].T, -F[np.ix_(A, A)]]])
        found = np.linalg.solve(both, np.concatenate([f, np.zeros(len(A))]))
        x = np.zeros(len(X))
        u, x[A] = found[: len(f)], found[len(f) :]
        below = B.T @ u - F @ x
        after = np.where(touching, x > 0, below > 0) if tensionless else touching
        if (after == touching).all():
            return u, x
        touching = after
    raise RuntimeError("no set of cells in contact was found")
