"""Square plates from thick to vanishingly thin, against series and a Ritz solution: nothing may lock.

Uniform pressure, nu = 0.3, shear factor 5/6, unit side. References: Navier's double series for the simply supported
plate with tangential rotations held (hard), which is exact at every thickness; for the clamped plate a Ritz solution
with polynomials, made here, held to the thin limit 0.00126532 q L^4 / D (Taylor and Govindjee 2004).
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.polynomial import legendre

from groundslab.analysis.driver import solve
from groundslab.errors import NotCertified
from groundslab.fem import plate
from groundslab.model.ground import Winkler
from groundslab.model.loads.load_types import UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Edges, Plate
from groundslab.model.settings import Contact, Mesh
from helpers import quads

THICKNESSES = [0.2, 0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6]
NU = 0.3
THIN_CLAMPED = 0.00126532  # Taylor and Govindjee 2004; Timoshenko has 0.00126
THIN_SUPPORTED = 0.00406235  # Timoshenko and Woinowsky-Krieger, Table 8: 0.00406


def shear_compliance(t: float) -> float:
    """Return D / S L^2 = t^2 / (6 (1 - nu) 5/6 L^2) for unit side."""
    return t**2 / (6 * (1 - NU) * 5 / 6)


@cache
def navier(t: float) -> float:
    """Return the settlement of the centre of the hard simply supported plate over q L^4 / D, by a double series."""
    m = np.arange(1, 400, 2)
    M, N = np.meshgrid(m, m)
    k2 = np.pi**2 * (M**2 + N**2)
    sign = (-1.0) ** ((M - 1) // 2 + (N - 1) // 2)
    terms = 16 / (np.pi**2 * M * N) * sign * (1 / k2**2 + shear_compliance(t) / k2)
    # the series alternates: the mean of two partial sums has far less of a tail than either
    return float((terms.sum() + terms[:-1, :-1].sum()) / 2)


@cache
def ritz(t: float, n: int = 9) -> float:
    """Return the settlement of the centre of the clamped plate over q L^4 / D, by polynomials of degree 2 n each way.

    w and both rotations are (1 - x^2)(1 - y^2) times even or odd Legendre polynomials on (-1, 1); the shear strain is
    an unknown of its own, which keeps the equations as well conditioned for t = 0 as for thick plates:

        a(beta, beta) / 2 + (gamma, grad w - beta) - c (gamma, gamma) / 2 - (q, w)  stationary,  c = D / S.
    """
    x, weight = legendre.leggauss(2 * n + 8)

    def bubble(first: int) -> tuple[np.ndarray, np.ndarray]:
        columns = []
        for k in range(first, first + 2 * n, 2):
            p = legendre.legmul(legendre.poly2leg([1, 0, -1]), np.eye(first + 2 * n)[k] * np.sqrt(2 * k + 1))
            p = p / np.sqrt((k + 1) * (k + 2))
            columns.append((legendre.legval(x, p), legendre.legval(x, legendre.legder(p))))
        return np.array([c[0] for c in columns]), np.array([c[1] for c in columns])

    (even, d_even), (odd, d_odd) = bubble(0), bubble(1)
    degrees = np.arange(2 * n + 2)
    P = np.array([legendre.legval(x, np.eye(2 * n + 2)[k]) * np.sqrt(k + 0.5) for k in degrees])
    P_even, P_odd = P[::2], P[1::2]

    def inner(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        return (u * weight) @ v.T

    size = n * n
    # half the side is the unit of length here
    c = 4 * shear_compliance(t)
    D_x = np.kron(inner(d_odd, d_odd), inner(even, even)) + (1 - NU) / 2 * np.kron(
        inner(odd, odd), inner(d_even, d_even)
    )
    D_y = np.kron(inner(even, even), inner(d_odd, d_odd)) + (1 - NU) / 2 * np.kron(
        inner(d_even, d_even), inner(odd, odd)
    )
    D_xy = NU * np.kron(inner(d_odd, even), inner(even, d_odd)) + (1 - NU) / 2 * np.kron(
        inner(odd, d_even), inner(d_even, odd)
    )
    # gamma_x odd in x and even in y, gamma_y the other way round
    Gx_w, Gy_w = np.kron(inner(P_odd, d_even), inner(P_even, even)), np.kron(inner(P_even, even), inner(P_odd, d_even))
    Gx_b, Gy_b = np.kron(inner(P_odd, odd), inner(P_even, even)), np.kron(inner(P_even, even), inner(P_odd, odd))
    g = len(Gx_w)
    zero, zero_g = np.zeros((size, size)), np.zeros((g, size))
    K = np.block([[zero, zero, zero], [zero, D_x, D_xy], [zero, D_xy.T, D_y]])
    G = np.block([[Gx_w, -Gx_b, zero_g], [Gy_w, zero_g, -Gy_b]])
    A = np.block([[K, G.T], [G, -c * np.eye(2 * g)]])
    f = np.zeros(len(A))
    f[:size] = np.kron((even * weight).sum(axis=1), (even * weight).sum(axis=1))
    scale = 1 / np.sqrt(np.abs(A).max(axis=1))
    w = (scale * np.linalg.lstsq(scale[:, None] * A * scale, scale * f, rcond=1e-15)[0])[:size]
    at_centre = []
    for k in range(0, 2 * n, 2):
        p = legendre.legmul(legendre.poly2leg([1, 0, -1]), np.eye(2 * n)[k] * np.sqrt(2 * k + 1))
        at_centre.append(legendre.legval(0.0, p) / np.sqrt((k + 1) * (k + 2)))
    return float(w @ np.kron(at_centre, at_centre)) / 16


def quarter(name: str, n: int, t: float, clamped: bool, amount: float = 0.0) -> float:
    """Return the settlement of the centre over q L^4 / D, from n x n elements on the quarter 0 .. 1/2."""
    nodes, elements = quads.mesh(n, n, 0.5, 0.5, amount)
    xy, N = nodes[elements], len(nodes)
    x, y = nodes.T
    right, top = np.isclose(x, 0.5), np.isclose(y, 0.5)
    held = np.zeros((3, N), dtype=bool)
    held[0] = right | top
    held[1] = np.isclose(x, 0) | top | (right & clamped)
    held[2] = np.isclose(y, 0) | right | (top & clamped)
    A = quads.assemble(quads.stiffness(name, xy, t), elements, N)
    f = quads.load(name, xy, elements, N, lambda a, b: 1.0 + 0 * a * b)
    u = quads.solve(A, f, held.ravel() | quads.centres(name, elements, N), np.zeros(3 * N))
    return float(u[np.argmin(x + y)] * plate.bending_rigidity(1.0, NU, t)[0, 0])


def test_the_series_has_the_known_thin_limit() -> None:
    """Navier's series gives Timoshenko's number for the thin plate."""
    assert navier(1e-6) == pytest.approx(THIN_SUPPORTED, abs=2e-8)


def test_the_ritz_solution_has_the_known_thin_limit() -> None:
    """The independent reference for the clamped plate agrees with the literature where the literature has a number."""
    assert ritz(1e-6) == pytest.approx(THIN_CLAMPED, abs=5e-9)
    assert ritz(1e-4) == pytest.approx(THIN_CLAMPED, abs=5e-9)


@pytest.mark.slow
@pytest.mark.parametrize("t", THICKNESSES)
def test_the_ritz_solution_has_converged(t: float) -> None:
    """Two fewer polynomials each way change the reference by less than a hundredth of what is tested with it."""
    assert ritz(t, 7) == pytest.approx(ritz(t), rel=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("amount", [0.0, 0.3], ids=["regular", "distorted"])
@pytest.mark.parametrize("clamped", [False, True], ids=["supported", "clamped"])
@pytest.mark.parametrize("t", THICKNESSES)
def test_default_element_does_not_lock(t: float, clamped: bool, amount: float) -> None:
    """Below 1 % from thick to t/L = 1e-6 with 8 x 8 elements on a quarter, on straight and on crooked meshes."""
    reference = ritz(t) if clamped else navier(t)
    name = Plate.model_fields["element"].default
    assert quarter(name, 8, t, clamped, amount) == pytest.approx(reference, rel=0.01)


@pytest.mark.parametrize("t", THICKNESSES[:-1])
def test_error_of_the_default_element_does_not_grow_as_plates_get_thin(t: float) -> None:
    """On 8 x 8 elements the clamped plate's error is below 0.1 % at any thickness that rounding does not blur."""
    assert quarter("mitc9", 8, t, True) == pytest.approx(ritz(t), rel=1e-3)


@pytest.mark.parametrize(("n", "percent"), [(2, 22.0), (4, 5.6), (8, 1.4)])
def test_the_papers_element_is_too_stiff(n: int, percent: float) -> None:
    """Q9 with full integration: 22 %, 5.6 % and 1.4 % too stiff on a clamped plate with t/L = 1e-5."""
    w = quarter("q9", n, 1e-5, True)
    too_stiff = 100 * (1 - w / ritz(1e-5))
    assert too_stiff == pytest.approx(percent, abs=0.5 if n == 2 else 0.05)


def square_plate(kind: str, t: float) -> Model:
    """Return the plate of unit side under q = D, on all but no ground."""
    D = 30e9 * t**3 / (12 * (1 - NU**2))
    edges = Edges(left=kind, right=kind, bottom=kind, top=kind)
    return Model(
        plate=Plate(length_x=1.0, length_y=1.0, thickness=t, E=30e9, nu=NU, edges=edges),
        ground=Winkler(k=max(1e-6 * D, 1e-6)),
        contact=Contact(tensionless=False),
        loads=[UniformLoad(q=D)],
        mesh=Mesh(counts=(16, 16)),
    )


@pytest.mark.parametrize("kind", ["hinged", "clamped"])
@pytest.mark.parametrize("t", [0.2, 0.01, 1e-3, 1e-4])
def test_the_whole_program_does_not_lock(kind: str, t: float) -> None:
    """The same plates through model, contact solver and recovery, on ground too soft to matter."""
    result = solve(square_plate(kind, t))
    reference = ritz(t) if kind == "clamped" else navier(t)
    assert result.plate.settlement.max() == pytest.approx(reference, rel=2e-3)
    assert result.certificate.force_balance < 1e-6


def test_a_plate_too_thin_for_double_precision_is_refused() -> None:
    """At t/L = 1e-6 rounding leaves forces over that are no longer small: the program says so instead of answering."""
    with pytest.raises(NotCertified, match="residual"):
        solve(square_plate("clamped", 1e-6))
