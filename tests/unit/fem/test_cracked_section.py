"""Sections, uncracked and cracked, against fibres; 7.18 and 7.19 against their own words; the slab's two directions."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from groundslab.fem import cracked_section as cs

E_C, E_S = 11e9, 200e9
SECTIONS = {
    "thin bars": (0.25, cs.Bars((5e-4, 5e-4), (0.04, 0.04))),
    "more at the bottom": (0.30, cs.Bars((20e-4, 5e-4), (0.05, 0.06))),
    "more at the top": (0.60, cs.Bars((8e-4, 30e-4), (0.07, 0.05))),
    "nothing at the bottom": (0.20, cs.Bars((0.0, 6e-4), (0.04, 0.1))),
    "much": (0.40, cs.Bars((60e-4, 40e-4), (0.06, 0.06))),
}


def _fibres(h: float, bars: cs.Bars, chi: float, tension: bool, shrinkage: float = 0.0) -> tuple[float, float]:
    """Return moment and the strain of the middle for a sagging curvature without normal force, by many fibres.

    z runs down from the middle, strains are positive in tension; shrinkage shortens the concrete alone.
    """
    n = 200_000
    z = (np.arange(n) + 0.5) / n * h - h / 2
    steel = list(zip(bars.area, (h / 2 - bars.distance[0], bars.distance[1] - h / 2), strict=True))

    def concrete(strain: np.ndarray | float) -> np.ndarray:
        stress = E_C * (np.asarray(strain) + shrinkage)
        return stress if tension else np.minimum(stress, 0.0)

    def forces(middle: float) -> tuple[float, float]:
        stress = concrete(middle + chi * z)
        N, M = stress.sum() * h / n, (stress * z).sum() * h / n
        for area, place in steel:
            strain = middle + chi * place
            own = area * (E_S * strain - float(concrete(strain)))  # the bar takes the place of concrete
            N, M = N + own, M + own * place
        return N, M

    middle = brentq(lambda strain: forces(strain)[0], -abs(chi) * h - 1e-3, abs(chi) * h + 1e-3, xtol=1e-16, rtol=1e-13)
    return forces(middle)[1], middle


@pytest.mark.parametrize("name", SECTIONS)
def test_sections_are_those_of_fibres(name: str) -> None:
    """I_I, I_II, z and x are those of 200,000 fibres without tension in the cracked concrete, both ways up."""
    h, bars = SECTIONS[name]
    chi, n = 1e-3, np.array([E_S / E_C])
    thickness = np.array([h])
    z, second, _ = cs.uncracked_section(thickness, bars, n)
    M, middle = _fibres(h, bars, chi, tension=True)
    assert E_C * second[0] * chi == pytest.approx(M, rel=1e-6)
    assert z[0] == pytest.approx(h / 2 - middle / chi, rel=1e-6)
    for top, sign in ((False, 1), (True, -1)):
        if not bars.area[top]:
            continue
        x, second, _ = cs.cracked_section(thickness, bars, n, top)
        M, middle = _fibres(h, bars, sign * chi, tension=False)
        assert E_C * second[0] * chi == pytest.approx(sign * M, rel=1e-5)
        assert x[0] == pytest.approx(h / 2 - middle / chi, rel=1e-5)


@pytest.mark.parametrize("name", ["more at the bottom", "more at the top", "much"])
def test_shrinkage_curvature_is_that_of_fibres(name: str) -> None:
    """7.21 of the uncracked section is the curvature at which fibres that shrink carry no moment."""
    h, bars = SECTIONS[name]
    n, eps = np.array([E_S / E_C]), 4e-4
    _, second, first = cs.uncracked_section(np.array([h]), bars, n)
    free = brentq(lambda chi: _fibres(h, bars, chi, tension=True, shrinkage=eps)[0], -1e-2, 1e-2, xtol=1e-12)
    assert (eps * n * first / second)[0] == pytest.approx(free, rel=1e-4)


def test_interpolation_is_that_of_the_clause() -> None:
    """At twice the stress that cracks the section zeta is 0.875 under lasting loads, 0.75 under short ones (7.19)."""
    B_I, B_II, M_cr = np.array([40e6]), np.array([10e6]), np.array([50e3])
    for beta, zeta in ((0.5, 0.875), (1.0, 0.75)):
        B = cs.effective_stiffness(np.array([100e3]), B_I, B_II, M_cr, np.array([beta]), np.array([2e-3]))
        assert 100e3 / B[0] == pytest.approx(zeta * (100e3 / 10e6 + 2e-3) + (1 - zeta) * 100e3 / 40e6, rel=1e-14)
    assert cs.effective_stiffness(M_cr, B_I, B_II, M_cr, np.array([0.5]), np.array([2e-3]))[0] == B_I[0]


@pytest.mark.parametrize("shrinkage", [0.0, 2e-3])
@pytest.mark.parametrize("beta", [0.5, 1.0])
def test_moment_of_a_curvature_is_the_inverse(beta: float, shrinkage: float) -> None:
    """The moment found for the curvature M / B(M) is M, and between the branches the section bends under M_cr."""
    given = np.array([40e6]), np.array([10e6]), np.array([50e3]), np.array([beta]), np.array([shrinkage])
    M = np.concatenate([np.linspace(0.0, 50e3, 11), np.linspace(50.001e3, 4000e3, 50)])
    chi = M / cs.effective_stiffness(M, *given)
    np.testing.assert_allclose(cs.resisted_moment(chi, *given), M, rtol=1e-12, atol=1e-9)
    between = np.linspace(chi[10], chi[11], 5)[1:-1]
    np.testing.assert_allclose(cs.resisted_moment(between, *given), 50e3, rtol=1e-4)
    assert (np.diff(cs.resisted_moment(np.linspace(0, 0.05, 500), *given)) >= 0).all()


def test_decisive_moments_are_bounded_by_directions_of_the_concrete() -> None:
    """No less than the normal moment of the bars' own direction, no more than the largest of all; both along bars."""
    m = np.random.default_rng(4).normal(size=(200, 3))
    angle = np.linspace(0, np.pi, 721)
    c, s = np.cos(angle), np.sin(angle)
    normal = m[:, :1] * c**2 + m[:, 1:2] * s**2 + 2 * m[:, 2:] * c * s
    found = cs.decisive_moments(m)
    for face, sign in ((0, 1), (1, -1)):
        largest = (sign * normal).max(axis=1)
        assert (found[:, :, face] <= np.maximum(largest, 0)[:, None] + 1e-4).all()
        assert (found[:, :, face] >= sign * m[:, :2] - 1e-12).all()
    np.testing.assert_allclose(cs.decisive_moments(np.array([[3.0, -1.0, 0.0]])), [[[3.0, 0.0], [0.0, 1.0]]])
    np.testing.assert_allclose(cs.decisive_moments(np.array([[0.0, 0.0, 2.0]])), np.full((1, 2, 2), 2.0))


def test_rigidity_of_equal_directions_is_isotropic() -> None:
    """With the same stiffness along x and y the slab bends alike in all directions; uncracked it has D (1, nu, ...)."""
    B_I, nu = np.full((2, 2), 40e6), np.full(2, 0.2)
    D = cs.orthotropic_rigidity(np.array([[40e6, 40e6], [9e6, 9e6]]), B_I, nu)
    full = 40e6 / (1 - 0.04)
    np.testing.assert_allclose(D[0], full * np.array([[1, 0.2, 0], [0.2, 1, 0], [0, 0, 0.4]]), rtol=1e-14)
    c, s = np.cos(0.7), np.sin(0.7)
    # curvatures (x, y, 2 xy) in turned axes
    T = np.array([[c * c, s * s, c * s], [s * s, c * c, -c * s], [-2 * c * s, 2 * c * s, c * c - s * s]])
    np.testing.assert_allclose(T.T @ D[1] @ T, D[1], rtol=1e-12, atol=1e-6)
    C = np.linalg.inv(cs.orthotropic_rigidity(np.array([[40e6, 9e6]]), B_I[:1], nu[:1])[0])
    np.testing.assert_allclose(C[:2, :2], [[1 / 40e6, -0.2 / 40e6], [-0.2 / 40e6, 1 / 9e6]], rtol=1e-12)


def test_a_stiffness_by_the_law_stays() -> None:
    """A stiffness that satisfies 7.18 at its moments is returned as it is, and has no error; another one has."""
    k = 5
    law = cs.CrackedSections(
        B_I=np.full((k, 2), 40e6), B_II=np.full((k, 2, 2), 10e6), M_cr=np.full((k, 2, 2), 50e3),
        shrinkage_I=np.zeros((k, 2)), shrinkage=np.full((k, 2, 2), 1e-3), nu=np.zeros(k), shear=np.ones(k),
        beta=np.ones(k),
    )  # fmt: skip
    m = np.array([[0, 0, 0], [40e3, 0, 0], [90e3, -120e3, 0], [60e3, 60e3, 30e3], [0, 0, -70e3]], dtype=float)
    M = cs.decisive_moments(m)
    B = cs.effective_stiffness(M, *law.curve).min(axis=2)
    found, moments = cs.secant_stiffness(law, B, m)
    np.testing.assert_allclose(found, B, rtol=1e-12)
    assert cs.law_error(found, moments, B) < 1e-12
    found, moments = cs.secant_stiffness(law, law.B_I, m)
    assert cs.law_error(found, moments, law.B_I) > 0.1
