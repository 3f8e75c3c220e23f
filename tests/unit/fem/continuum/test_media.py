"""Media as compliances by wave numbers and as kernels, against closed forms of the half-space under a rectangle."""

import numpy as np
import pytest

from groundslab.fem.continuum.kernels import cell_means
from groundslab.fem.continuum.media import BondedLayers, StressedLayers, elastic_length
from groundslab.fem.continuum.transfer import ElasticLayer
from groundslab.verification.analytic_half_space import compression, surface_settlement

SIDES = 0.5, 0.4
X, Y = (each.ravel() for each in np.meshgrid(SIDES[0] * np.arange(9), SIDES[1] * np.arange(9), indexing="ij"))


@pytest.mark.parametrize("thickness", [(3.0, 6.0), (0.3, 2.0), (0.1, 0.2, 8.0)])
def test_stressed_layers_settle_by_the_stresses_of_a_rectangle(thickness: tuple[float, ...]) -> None:
    """Cell by cell: the sum over layers of the mean compression over the constrained modulus."""
    moduli = (10e6, 40e6, 25e6)[: len(thickness)]
    bottoms = np.cumsum(thickness)
    expected = sum(
        compression(X, Y, bottom - h, bottom, SIDES, mean=True) / M
        for h, bottom, M in zip(thickness, bottoms, moduli, strict=True)
    ) / np.prod(SIDES)
    found = cell_means(StressedLayers(moduli, thickness).kernel(), X, Y, *SIDES)
    np.testing.assert_allclose(found, expected, atol=2e-5 * expected.max())


def test_a_half_space_settles_as_love_found() -> None:
    """One layer without an end."""
    soil = ElasticLayer(20e6, 0.35, np.inf)
    found = cell_means(BondedLayers((soil,)).kernel(), X, Y, *SIDES)
    expected = surface_settlement(X, Y, SIDES, soil.E, soil.nu, mean=True) / np.prod(SIDES)
    np.testing.assert_allclose(found, expected, rtol=1e-8)


@pytest.mark.parametrize("k", [1e-6, 1e-3, 0.1, 1.0, 30.0])
def test_stressed_layers_by_wave_numbers(k: float) -> None:
    """The stress (1 + k z) exp(-k z) of a wave, integrated by quadrature over each layer."""
    from scipy.integrate import quad

    moduli, thickness = (10e6, 40e6), (1.5, 4.0)
    tops = 0.0, 1.5
    expected = sum(
        quad(lambda z: (1 + k * z) * np.exp(-k * z), top, top + h, epsabs=0, epsrel=1e-11)[0] / M
        for top, h, M in zip(tops, thickness, moduli, strict=True)
    )
    assert StressedLayers(moduli, thickness).compliance(np.array([k]))[0] == pytest.approx(expected, rel=1e-9)


def test_elastic_length_of_a_plate_on_a_half_space() -> None:
    """l^3 = D 2 (1 - nu^2) / E: from 1 / T(1 / l) = D / l^4."""
    soil, D = ElasticLayer(30e6, 0.2, np.inf), 50e6
    assert elastic_length(BondedLayers((soil,)), D) == pytest.approx((D * 2 * (1 - 0.2**2) / 30e6) ** (1 / 3), rel=1e-4)
