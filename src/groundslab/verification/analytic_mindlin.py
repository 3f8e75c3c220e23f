"""Mindlin plates on Pasternak ground in closed form: strips of several parts, and infinite plates.

With the shear stiffness S the plate's equations are Q = S grad w - S beta, m = -D (...beta), div m = Q; beta is the
gradient of a potential psi where the rotation has no curl, and w = psi - D / S lap psi. Of the ground's pressure k0 w -
k1 lap w the plate feels D lap lap psi + (k0 - k1 lap)(psi - D / S lap psi) = q.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from groundslab.arrays import Array


@dataclass(frozen=True)
class Part:
    """A part of a strip: its length [m], the load on it [Pa] and the ground under it, k0 [Pa/m] and k1 [Pa m].

    P [N/m] is the line load at its beginning.
    """

    length: float
    q: float = 0.0
    k0: float = 0.0
    k1: float = 0.0
    P: float = 0.0


@dataclass(frozen=True)
class Strip:
    """A free strip with nu = 0 of D [N m] and S [N/m], of parts from left to right, and what the ends are held by.

    Ground that goes on takes sqrt(k0 k1) w beyond either end: left and right [N/m^2].
    """

    D: float
    S: float
    parts: tuple[Part, ...]
    left: float = 0.0
    right: float = 0.0

    def _ends(self, part: Part, x: float) -> tuple[Array, Array]:
        """Return the state w, beta, M, T = Q + k1 w' at x of a part as matrix and vector of that at its beginning."""
        from scipy.linalg import expm

        stiffness = self.S + part.k1
        A = np.zeros((5, 5))
        A[0, [1, 3]] = self.S / stiffness, 1 / stiffness
        A[1, 2] = -1 / self.D
        A[2, [1, 3]] = -self.S * part.k1 / stiffness, self.S / stiffness
        A[3, [0, 4]] = part.k0, -part.q
        found = expm(A * x)
        return found[:4, :4], found[:4, 4]

    @cached_property
    def starts(self) -> list[Array]:
        """Return the state at the beginning of each part, the line load there applied."""
        n = len(self.parts)
        A, b = np.zeros((4 * n, 4 * n)), np.zeros(4 * n)
        line = 0
        for i, part in enumerate(self.parts):
            if i == 0:
                A[0, 2], A[1, [3, 0]] = 1.0, (1.0, -self.left)
                b[1] = -part.P
                line = 2
            if i + 1 < n:
                grown, known = self._ends(part, part.length)
                A[line : line + 4, 4 * i : 4 * i + 4] = -grown
                A[line : line + 4, 4 * i + 4 : 4 * i + 8] = np.eye(4)
                b[line : line + 4] = known
                b[line + 3] -= self.parts[i + 1].P
                line += 4
        grown, known = self._ends(self.parts[-1], self.parts[-1].length)
        A[line, 4 * n - 4 :], b[line] = grown[2], -known[2]
        A[line + 1, 4 * n - 4 :] = grown[3] + self.right * grown[0]
        b[line + 1] = -known[3] - self.right * known[0]
        scale = np.tile([1.0, 1.0, self.D, self.D], n)
        size = np.abs(A * scale).max(axis=1)
        found = scale * np.linalg.solve(A * scale / size[:, None], b / size)
        return list(found.reshape(n, 4))

    def at(self, x: float) -> dict[str, float]:
        """Return settlement, rotation, moment, shear and ground pressure at x from the left end, right of a line."""
        number, last = 0, len(self.parts) - 1
        while x > self.parts[number].length and number < last:
            x -= self.parts[number].length
            number += 1
        start = self.starts[number]
        part = self.parts[number]
        grown, known = self._ends(part, x)
        w, beta, M, T = grown @ start + known
        slope = (T + self.S * beta) / (self.S + part.k1)
        Q = T - part.k1 * slope
        return {"settlement": w, "rotation": beta, "moment": M, "shear": Q, "slope": slope}


@dataclass(frozen=True)
class InfinitePlate:
    """A plate without end of D [N m], S [N/m] and nu on Pasternak ground k0 [Pa/m], k1 [Pa m]."""

    D: float
    S: float
    nu: float
    k0: float
    k1: float = 0.0

    def under_disk(self, r: Array, a: float, q: float) -> dict[str, Array]:
        """Return the fields at r [m] > 0 from the middle of a pressure q [Pa] within a radius a [m].

        Hankel's integral of J1(a s) J0(r s) / (s^2 + z^2) is one of Bessel functions (Sneddon 1951).
        """
        from scipy.special import iv, kv

        def integral(z: complex) -> tuple[Array, Array]:
            near = np.minimum(r, a)
            inside = 1 / (a * z**2) - kv(1, a * z) * iv(0, near * z) / z
            outside = iv(1, a * z) * kv(0, np.maximum(r, a) * z) / z
            slope = np.where(r < a, -kv(1, a * z) * iv(1, near * z), -iv(1, a * z) * kv(1, np.maximum(r, a) * z))
            return np.where(r < a, inside, outside), slope

        return self._fields(r, q * a, integral)

    def under_ring(self, r: Array, a: float, q: float) -> dict[str, Array]:
        """Return the fields at r [m] > 0 from the middle of a line load q [N/m] along a circle of radius a [m]."""
        from scipy.special import iv, kv

        def integral(z: complex) -> tuple[Array, Array]:
            near, far = np.minimum(r, a), np.maximum(r, a)
            slope = np.where(r < a, iv(1, near * z) * kv(0, a * z), -iv(0, a * z) * kv(1, far * z)) * z
            return iv(0, near * z) * kv(0, far * z), slope

        return self._fields(r, q * a, integral)

    def _fields(self, r: Array, size: float, integral: Callable[[complex], tuple[Array, Array]]) -> dict[str, Array]:
        """Return settlement, radial and tangential moment and shear force, of a potential in two integrals."""
        D, k1 = self.D * (1 + self.k1 / self.S), self.k1 + self.k0 * self.D / self.S
        root = cmath.sqrt(complex(k1**2 - 4 * D * self.k0))
        y2, z2 = (k1 + root) / (2 * D), (k1 - root) / (2 * D)
        of_y, of_z = (integral(cmath.sqrt(square)) for square in (y2, z2))
        c = size / (D * (z2 - y2))
        psi, slope = ((c * (one - other)).real for one, other in zip(of_y, of_z, strict=True))
        # of psi, as the load cancels in the difference
        laplacian, steep = ((c * (y2 * one - z2 * other)).real for one, other in zip(of_y, of_z, strict=True))
        bent = laplacian - slope / r
        return {
            "settlement": psi - self.D / self.S * laplacian,
            "moment_r": -self.D * (bent + self.nu * slope / r),
            "moment_t": -self.D * (slope / r + self.nu * bent),
            "shear": -self.D * steep,
        }


def load_on_mindlin_plate(
    r: float,
    a: float,
    t: float,
    E: float,
    nu: float,
    factor: float,
    k0: float,
    k1: float,
    q: float = 0.0,
    ring: float = 0.0,
) -> dict[str, float]:
    """Return settlement [m], radial moment [N m/m] and shear force [N/m] of an infinite plate, r [m] from the middle.

    It carries the pressure q [Pa] within a radius a [m] and the line load ring [N/m] on that circle.
    """
    plate = InfinitePlate(E * t**3 / (12 * (1 - nu**2)), factor * E / (2 * (1 + nu)) * t, nu, k0, k1)
    at = np.array([max(r, 1e-9 * a)])
    parts = plate.under_disk(at, a, q), plate.under_ring(at, a, ring)
    fields = {"settlement": "settlement", "moment": "moment_r", "shear": "shear"}
    return {name: float(sum(part[field][0] for part in parts)) for name, field in fields.items()}


def line_on_mindlin_strip(
    x: float, length: float, at: float, P: float, t: float, E: float, factor: float, k0: float, k1: float, beyond: bool
) -> dict[str, float]:
    """Return settlement [m], moment [N m/m] and shear force [N/m] of a free strip with nu = 0, x [m] from its left end.

    A line load P [N/m] acts at a place; k1 [Pa m] goes on beyond both ends or ends with them.
    """
    ground = math.sqrt(k0 * k1) if beyond else 0.0
    parts = (Part(at, k0=k0, k1=k1), Part(length - at, k0=k0, k1=k1, P=P))
    found = Strip(E * t**3 / 12, factor * E / 2 * t, parts, ground, ground).at(x)
    return {name: found[name] for name in ("settlement", "moment", "shear")}
