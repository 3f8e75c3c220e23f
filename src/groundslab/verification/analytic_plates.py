"""Thin plates on supports: a clamped rectangle by Ritz's method; rings, circles and ellipses in closed form."""

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
    value, slope, bent = ((terms * weight) @ terms.T for terms in at)
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
        factors, constant = terms(i, r, what)
        A[line, 3 * i : 3 * i + 3] += sign * np.array(factors)
        f[line] -= sign * constant

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


def circle_under_linear_pressure(x: float, y: float, radius: float, p: float, D: float, nu: float) -> dict[str, float]:
    """Return settlement [m] and moment m_x [N m/m] of a simply supported thin circle under the pressure p x / radius.

    w = f(r) x / r; D lap lap w = p x / R has the particular solution p x r^4 / (192 D R), and w = m_r = 0 at the edge
    gives f (Timoshenko and Woinowsky-Krieger 1959, section 63).
    """
    C, r2, R2 = p / (192 * D * radius * (3 + nu)), x * x + y * y, radius**2
    A, B, E = C * (7 + nu) * R2**2, -C * (10 + 2 * nu) * R2, C * (3 + nu)
    # w = x (A + B r^2 + E r^4)
    w_xx = x * (6 * B + E * (12 * r2 + 8 * x * x))
    w_yy = x * (2 * B + E * (4 * r2 + 8 * y * y))
    return {"settlement": x * (A + B * r2 + E * r2 * r2), "moment": -D * (w_xx + nu * w_yy)}


def clamped_ellipse(x: float, y: float, a: float, b: float, q: float, D: float, nu: float) -> dict[str, float]:
    """Return settlement [m] and moment m_x [N m/m] of a clamped thin ellipse of half axes a and b [m] under q [Pa].

    w = w0 (1 - x^2 / a^2 - y^2 / b^2)^2 with w0 = q / (D (24 / a^4 + 24 / b^4 + 16 / (a b)^2)) (Timoshenko and
    Woinowsky-Krieger 1959, section 71).
    """
    w0 = q / (D * (24 / a**4 + 24 / b**4 + 16 / (a * b) ** 2))
    s = 1 - x**2 / a**2 - y**2 / b**2
    w_xx = w0 * (-4 * s / a**2 + 8 * x**2 / a**4)
    w_yy = w0 * (-4 * s / b**2 + 8 * y**2 / b**4)
    return {"settlement": w0 * s**2, "moment": -D * (w_xx + nu * w_yy)}


def wood_armer(m_x: float, m_y: float, m_xy: float) -> dict[str, float]:
    """Return the design moments [N m/m] of bars along x and y with the least sum, by a linear programme.

    In every direction, of which there are 7200 here, the bars' moment must reach the plate's: m_bx cos^2 + m_by sin^2
    >= m_n with m_bx, m_by >= 0 at the bottom, the same with -m_n at the top, whose moments count negative (Wood 1968,
    Armer 1968).
    """
    from scipy.optimize import linprog

    angle = np.linspace(0.0, np.pi, 7200, endpoint=False)
    cos, sin = np.cos(angle), np.sin(angle)
    normal = m_x * cos**2 + m_y * sin**2 + 2 * m_xy * sin * cos
    bars = -np.column_stack([cos**2, sin**2])
    bottom, top = (linprog([1.0, 1.0], A_ub=bars, b_ub=-sign * normal).x for sign in (1.0, -1.0))
    named = {"bottom_x": bottom[0], "bottom_y": bottom[1], "top_x": -top[0], "top_y": -top[1]}
    return {name: float(moment) for name, moment in named.items()}
