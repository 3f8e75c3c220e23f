"""Thin plates on supports: a clamped rectangle by Ritz's method, rings in closed form."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import Legendre, Polynomial

#: Polynomials along each side; the method converges faster than any power of their number.
TERMS = 10


def clamped_plate(x: float, y: float, a: float, b: float, q: float, D: float, nu: float) -> dict[str, float]:
    """Return settlement [m] and moment m_x [N m/m] of a thin clamped plate a x b, x and y from its middle.

    Under a pressure q [Pa]. Legendre's polynomials of even degree times (1 - s^2)^2 along both sides; the energy of a
    clamped plate is D / 2 times the integral of the squared Laplacian (Timoshenko and Woinowsky-Krieger 1959, section
    82).
    """
    shapes = [Polynomial([1, 0, -2, 0, 1]) * Legendre.basis(2 * i).convert(kind=Polynomial) for i in range(TERMS)]
    s, weight = np.polynomial.legendre.leggauss(2 * TERMS + 8)
    at = [np.array([shape.deriv(n)(s) if n else shape(s) for shape in shapes]) for n in range(3)]
    value, slope, bent = ((each * weight) @ each.T for each in at)
    u, v = 2 / a, 2 / b  # derivatives over x and y
    K = D * (u**4 * np.kron(bent, value) + 2 * u**2 * v**2 * np.kron(slope, slope) + v**4 * np.kron(value, bent))
    mean = at[0] @ weight
    c = np.linalg.solve(K, q * np.kron(mean, mean))

    def field(i: int, j: int) -> float:
        along_x = [shape.deriv(i)(u * x) if i else shape(u * x) for shape in shapes]
        along_y = [shape.deriv(j)(v * y) if j else shape(v * y) for shape in shapes]
        return float(u**i * v**j * np.kron(along_x, along_y) @ c)

    return {"settlement": field(0, 0), "moment": -D * (field(2, 0) + nu * field(0, 2))}


def rings(r: float, radii: list[float], D: list[float], nu: float, q: float) -> dict[str, float]:
    """Return settlement [m] and radial moment [N m/m] of a thin circular plate made of rings, under a pressure q [Pa].

    radii (n + 1,) [m] bound the rings from inside out, the first being 0 or that of a free hole; D (n,) [N m] are their
    stiffnesses. The outer edge is simply supported. In each ring w = A + B ln r + C r^2 + E r^2 ln r + q r^4 / 64 D,
    with E = -q r0^2 / 8 D, as a hole of radius r0 carries no load (Timoshenko and Woinowsky-Krieger 1959, section 17).
    """
    n, hole = len(D), radii[0]
    A, f = np.zeros((3 * n, 3 * n)), np.zeros(3 * n)

    def terms(i: int, r: float, what: int) -> tuple[list[float], float]:
        # factors of A, B and C, and what is known, of: settlement, slope, moment
        E, log, p = -q * hole**2 / (8 * D[i]), np.log(r) if r else 0.0, q / (64 * D[i])
        w = [1.0, log, r**2], E * r**2 * log + p * r**4
        slope = [0.0, 1 / r if r else 0.0, 2 * r], E * r * (2 * log + 1) + 4 * p * r**3
        turned = [0.0, 1 / r**2 if r else 0.0, 2.0], E * (2 * log + 1) + 4 * p * r**2  # slope over r
        bent = [0.0, -1 / r**2 if r else 0.0, 2.0], E * (2 * log + 3) + 12 * p * r**2
        moment = [-D[i] * (b + nu * t) for b, t in zip(bent[0], turned[0], strict=True)]
        return (w, slope, (moment, -D[i] * (bent[1] + nu * turned[1])))[what]

    def state(line: int, i: int, r: float, what: int, sign: float = 1.0) -> None:
        factors, known = terms(i, r, what)
        A[line, 3 * i : 3 * i + 3] += sign * np.array(factors)
        f[line] -= sign * known

    for i in range(n - 1):
        for what in range(3):
            state(3 * i + what, i, radii[i + 1], what)
            state(3 * i + what, i + 1, radii[i + 1], what, -1.0)
    if hole:
        state(3 * n - 3, 0, hole, 2)
    else:
        A[3 * n - 3, 1] = 1.0  # nothing is singular in the middle
    state(3 * n - 2, n - 1, radii[-1], 0)
    state(3 * n - 1, n - 1, radii[-1], 2)
    c = np.linalg.solve(A, f)
    i = min(int(np.searchsorted(radii, r, side="right")) - 1, n - 1)
    w, moment = (float(np.dot(terms(i, r, what)[0], c[3 * i : 3 * i + 3]) + terms(i, r, what)[1]) for what in (0, 2))
    return {"settlement": w, "moment": moment}
