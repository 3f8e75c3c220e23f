"""Beams and strips on springs and on Pasternak ground, and infinite plates on it, in closed form.

Mindlin plates with the shear stiffness S obey Q = S grad w - S beta, div m = Q; beta is the gradient of a potential psi
where the rotation has no curl, and w = psi - D / S lap psi. With the ground's pressure k0 w - k1 lap w this is
D lap lap psi + (k0 - k1 lap)(psi - D / S lap psi) = q.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from groundslab.arrays import Array


def beam_on_two_supports(x: float, length: float, q: float) -> dict[str, float]:
    """Return moment [N m] and shear force [N] at x [m] of a beam on a support at either end under a load q [N/m]."""
    return {"moment": q * x * (length - x) / 2, "shear": q * (length / 2 - x)}


def beam_on_springs(x: float, length: float, P: float, at: float, EI: float, k: float) -> dict[str, float]:
    """Return settlement [m] and moment [N m] at x of a free beam on springs k [N/m2] under a force P [N].

    Bernoulli's beam of stiffness EI [N m2], x and `at` from its left end. The solution for an infinite beam, and waves
    that die out from both ends, such that there is neither moment nor shear force there (Hetenyi 1946).
    """
    wave = (-1 + 1j) * (k / (4 * EI)) ** 0.25

    def waves(n: int, x: float) -> list[float]:
        left, right = wave**n * cmath.exp(wave * x), (-wave) ** n * cmath.exp(wave * (length - x))
        return [left.real, left.imag, right.real, right.imag]

    def infinite(n: int, x: float) -> float:
        # w = P b / 2 k exp(-b s) (cos b s + sin b s), s = |x - at|
        turned = (-1.0) ** n if x < at else 1.0
        amplitude = P * wave.imag / (2 * k) * (1 - 1j)
        return turned * float((amplitude * wave**n * cmath.exp(wave * abs(x - at))).real)

    ends = [(2, 0.0), (3, 0.0), (2, length), (3, length)]
    c = np.linalg.solve([waves(*end) for end in ends], [-infinite(*end) for end in ends])
    w, bent = (float(np.dot(waves(n, x), c)) + infinite(n, x) for n in (0, 2))
    return {"settlement": w, "moment": -EI * bent}


def joined_beams(x: float, P: float, a: float, EI: float, k: float, s: float = math.inf) -> dict[str, float]:
    """Return settlement [m], moment [N m] at x and the force [N] of a joint at x = 0 between two beams on springs.

    Two semi-infinite Bernoulli beams of stiffness EI [N m2] on springs k [N/m2], a force P [N] at x = -a. The joint
    hands on V = s (w_left - w_right) [N] without a moment; a hinge has s = inf. With b = (k / 4 EI)^(1/4) a force F at
    the end settles a semi-infinite beam by 2 F b / k exp(-b x) cos(b x), and its moment is -F / b exp(-b x) sin(b x)
    (Hetenyi 1946). By reciprocity P alone settles the end by 2 P b / k D, D = exp(-b a) cos(b a), so that

        V / s = 2 b / k (P D - 2 V),   V = P D / (2 + k / (2 b s)).

    The left beam follows from one under P with a free end, so long that its other end is not felt, less V at its end.
    """
    b = (k / (4 * EI)) ** 0.25
    V = P * math.exp(-b * a) * math.cos(b * a) / (2 + k / (2 * b * s))
    far = 20 / b
    beam = beam_on_springs(-x, far, P, a, EI, k) if x < 0 else {"settlement": 0.0, "moment": 0.0}
    sign = -1.0 if x < 0 else 1.0
    wave = math.exp(-b * abs(x))
    return {
        "settlement": beam["settlement"] + sign * 2 * V * b / k * wave * math.cos(b * x),
        "moment": beam["moment"] - sign * V / b * wave * math.sin(b * abs(x)),
        "force": V,
    }


def disk_on_infinite_plate(r: float, a: float, q: float, D: float, nu: float, k0: float, k1: float) -> dict[str, float]:
    """Return settlement [m] and radial moment [N m/m] of an infinite thin plate on Pasternak ground under a disk.

    A pressure q [Pa] within a radius a [m], at r [m] from its middle. With D s^4 + k1 s^2 + k0 = D (s^2 + y^2)(s^2 +
    z^2) the Hankel integral of J1(a s) J0(r s) over that is one of Bessel functions (Sneddon 1951).
    """
    from scipy.special import iv, kv

    root = cmath.sqrt(complex(k1**2 - 4 * D * k0))
    y, z = (cmath.sqrt((k1 + sign * root) / (2 * D)) for sign in (1, -1))

    def integrals(z: complex) -> tuple[complex, complex, complex]:
        # of J1(a s) J0(r s) / (s^2 + z^2), its slope over r, and its second derivative
        if r >= a:
            outside = iv(1, a * z)
            slope = -outside * kv(1, r * z)
            return outside * kv(0, r * z) / z, slope / r, outside * kv(0, r * z) * z - slope / r
        inside = -kv(1, a * z)
        slope_over_r = inside * z * (iv(1, r * z) / (r * z) if r else 0.5)
        return 1 / (a * z**2) + inside * iv(0, r * z) / z, slope_over_r, inside * z * iv(0, r * z) - slope_over_r

    w, slope_over_r, bent = (
        float((q * a / (D * (z**2 - y**2)) * (y_part - z_part)).real)
        for y_part, z_part in zip(integrals(y), integrals(z), strict=True)
    )
    return {"settlement": w, "moment": -D * (bent + nu * slope_over_r)}


def supported_beam_on_springs(
    x: float, length: float, EI: float, k: float, q: float, P: float = 0.0
) -> dict[str, float]:
    """Return settlement [m] and moment [N m] at x of a beam on springs k [N/m2] that is simply supported at both ends.

    Bernoulli's beam under q [N/m] and a force P [N] in its middle, x from its left end: a sine series (Hetenyi 1946).
    """
    n = np.arange(1, 4000, 2)
    wave = n * math.pi / length
    load = 4 * q / (n * math.pi) + 2 * P / length * np.sin(n * math.pi / 2)
    amplitude = load / (EI * wave**4 + k) * np.sin(wave * x)
    return {"settlement": float(amplitude.sum()), "moment": float((EI * wave**2 * amplitude).sum())}


def strip_on_pasternak(
    x: float, length: float, P: float, EI: float, k0: float, k1: float, beyond: bool
) -> dict[str, float]:
    """Return settlement [m] and moment [N m/m] of a free strip on Pasternak ground under a line load in its middle.

    A thin strip of stiffness EI [N m] under P [N/m], x from its middle. EI w'''' - k1 w'' + k0 w = 0 on each half; at
    the end there is no moment, and -EI w''' + k1 w' is what ground that goes on takes, -sqrt(k0 k1) w, or nothing
    (Hetenyi 1946, with the shear of the ground).
    """
    taken = math.sqrt(k0 * k1) if beyond else 0.0
    end = [(EI, 2), (-EI, 3, k1, 1, taken, 0)]
    return _half_strip(abs(x), length / 2, P, EI, k0, k1, end)


def lifting_strip_on_pasternak(x: float, P: float, EI: float, k0: float, k1: float) -> dict[str, float]:
    """Return settlement [m], moment [N m/m] and half the contact length [m] of a strip lifting from Pasternak ground.

    A long thin strip without weight under a line load P [N/m] at x = 0. Where it has lifted it is straight and free of
    forces: w'' = w''' = 0 at the end of contact, where the ground goes on with its slope, w' = -sqrt(k0 / k1) w, as
    exp(-sqrt(k0 / k1) s). Contact ends where all three hold (Weitsman 1970 has the strip on springs).
    """
    from scipy.optimize import brentq

    end = [(EI, 2), (EI, 3)]

    def misfit(c: float) -> float:
        edge = _half_strip(c, c, P, EI, k0, k1, end)
        return edge["slope"] + math.sqrt(k0 / k1) * edge["settlement"]

    length = (4 * EI / k0) ** 0.25
    c = float(brentq(misfit, 0.2 * length, math.pi / 2 * length, xtol=1e-12))
    x = abs(x)
    if x <= c:
        return {**_half_strip(x, c, P, EI, k0, k1, end), "contact": c}
    edge = _half_strip(c, c, P, EI, k0, k1, end)
    return {"settlement": edge["settlement"] + edge["slope"] * (x - c), "moment": 0.0, "contact": c}


def _half_strip(
    x: float, c: float, P: float, EI: float, k0: float, k1: float, end: Sequence[Sequence[float]]
) -> dict[str, float]:
    """Return settlement, slope and moment at 0 <= x <= c, half of P at x = 0; `end` has factors, derivatives at c."""
    root = cmath.sqrt(complex(k1**2 - 4 * EI * k0))
    r = [sign * cmath.sqrt((k1 + other * root) / (2 * EI)) for sign in (1, -1) for other in (1, -1)]

    def waves(n: int, x: float) -> np.ndarray:
        # those that grow with x are of size 1 at c
        return np.array([root**n * cmath.exp(root * (x - c if root.real > 0 else x)) for root in r])

    lines = [waves(1, 0.0), EI * waves(3, 0.0)]
    for terms in end:
        pairs = zip(terms[::2], terms[1::2], strict=True)
        lines.append(np.sum([factor * waves(int(n), c) for factor, n in pairs], axis=0))
    a = np.linalg.solve(np.array(lines), [0.0, P / 2, 0.0, 0.0])
    w, slope, bent = (float((waves(n, x) @ a).real) for n in range(3))
    return {"settlement": w, "slope": slope, "moment": -EI * bent}


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
        matrix = expm(A * x)
        return matrix[:4, :4], matrix[:4, 4]

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
                grown, vector = self._ends(part, part.length)
                A[line : line + 4, 4 * i : 4 * i + 4] = -grown
                A[line : line + 4, 4 * i + 4 : 4 * i + 8] = np.eye(4)
                b[line : line + 4] = vector
                b[line + 3] -= self.parts[i + 1].P
                line += 4
        grown, vector = self._ends(self.parts[-1], self.parts[-1].length)
        A[line, 4 * n - 4 :], b[line] = grown[2], -vector[2]
        A[line + 1, 4 * n - 4 :] = grown[3] + self.right * grown[0]
        b[line + 1] = -vector[3] - self.right * vector[0]
        scale = np.tile([1.0, 1.0, self.D, self.D], n)
        size = np.abs(A * scale).max(axis=1)
        states = scale * np.linalg.solve(A * scale / size[:, None], b / size)
        return list(states.reshape(n, 4))

    def at(self, x: float) -> dict[str, float]:
        """Return settlement, rotation, moment, shear and ground pressure at x from the left end, right of a line."""
        number, last = 0, len(self.parts) - 1
        while x > self.parts[number].length and number < last:
            x -= self.parts[number].length
            number += 1
        start = self.starts[number]
        part = self.parts[number]
        grown, vector = self._ends(part, x)
        w, beta, M, T = grown @ start + vector
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
        psi, slope = ((c * (y_part - z_part)).real for y_part, z_part in zip(of_y, of_z, strict=True))
        # of psi, as the load cancels in the difference
        laplacian, steep = ((c * (y2 * y_part - z2 * z_part)).real for y_part, z_part in zip(of_y, of_z, strict=True))
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
    values = Strip(E * t**3 / 12, factor * E / 2 * t, parts, ground, ground).at(x)
    return {name: values[name] for name in ("settlement", "moment", "shear")}
