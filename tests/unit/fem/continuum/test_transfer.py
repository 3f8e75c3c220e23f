"""Transfer functions of layered ground against exact arithmetic, closed forms and their limits."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.fem.continuum.transfer import ElasticLayer, carry_down, compliances, surface_compliance
from helpers.examples import examples
from helpers.layered_ground import Layer, burmister, on_rigid_base, settlement

SOFT, STIFF = ElasticLayer(10e6, 0.3, 2.0), ElasticLayer(80e6, 0.2, 5.0)
BELOW = ElasticLayer(200e6, 0.25, math.inf)
K = np.geomspace(1e-4, 1e3, 29)


def layers_of(given: list[Layer]) -> list[ElasticLayer]:
    """Return the layers of numbers."""
    return [ElasticLayer(*each) for each in given]


moduli = st.floats(-3, 3).map(lambda exponent: 10.0**exponent)
ratios = st.sampled_from([0.0, 0.2, 0.3, 0.45, 0.499])
thicknesses = st.floats(-3, 0).map(lambda exponent: 10.0**exponent)
stacks = st.builds(
    lambda layers, below: [*layers, *below],
    st.lists(st.tuples(moduli, ratios, thicknesses), min_size=1, max_size=4),
    st.lists(st.tuples(moduli, ratios, st.just(math.inf)), max_size=1),
)


@settings(max_examples=examples(40), deadline=None, derandomize=True)
@given(stacks, st.floats(-4, 1.7).map(lambda exponent: 10.0**exponent))
def test_any_stack_settles_as_in_exact_arithmetic(stack, k):
    """With a contrast up to a million and layers down to a thousandth, T(k) loses no more than a few digits."""
    assert surface_compliance(layers_of(stack), np.array([k]))[0] == pytest.approx(settlement(stack, k), rel=1e-12)


def test_half_space():
    """T = 2 (1 - nu^2) / (E k) (Boussinesq)."""
    assert surface_compliance([BELOW], K) == pytest.approx(2 * (1 - 0.25**2) / (200e6 * K), rel=1e-14)


def test_one_layer_on_a_rigid_base():
    """The closed form of a layer bonded to a rigid base, from thin to deep."""
    k = np.geomspace(1e-4, 50, 20)
    exact = [on_rigid_base(10e6, 0.3, 2.0, each) for each in k]
    assert surface_compliance([SOFT], k) == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize("ratio", [0.01, 0.1, 1.0, 10.0, 100.0])
def test_two_layers_by_burmister(ratio):
    """Burmister's closed form for nu = 1/2, which his layers approach as 1 - 2 nu."""
    nu = 0.5 - 1e-8
    pair = [ElasticLayer(1.0, nu, 2.0), ElasticLayer(1.0 / ratio, nu, math.inf)]
    k = np.geomspace(1e-3, 50, 30)
    assert surface_compliance(pair, k) == pytest.approx(burmister(ratio, 1.0, 2.0)(k), rel=1e-6)


@pytest.mark.parametrize("cut", [1e-6, 0.01, 1.0, 1.99])
def test_a_layer_cut_in_two_is_the_same(cut):
    """A bond within one soil is none."""
    parts = [ElasticLayer(10e6, 0.3, cut), ElasticLayer(10e6, 0.3, 2.0 - cut)]
    for below in ([], [STIFF], [STIFF, BELOW]):
        assert surface_compliance([*parts, *below], K) == pytest.approx(
            surface_compliance([SOFT, *below], K), rel=1e-11
        )


def test_long_waves_compress_layers_one_by_one():
    """On a rigid base k -> 0 gives the sum of h (1 + nu)(1 - 2 nu) / (E (1 - nu)), to order k^2."""
    expected = 2.0 * 1.3 * 0.4 / (10e6 * 0.7) + 5.0 * 1.2 * 0.6 / (80e6 * 0.8)
    assert surface_compliance([SOFT, STIFF], np.array([1e-6]))[0] == pytest.approx(expected, rel=1e-9)


def test_long_waves_find_the_half_space_alone():
    """Above a half-space k -> 0 gives k T of the half-space, to order k."""
    k = np.array([1e-7])
    assert k * surface_compliance([SOFT, STIFF, BELOW], k) == pytest.approx(BELOW.half_space, rel=1e-5)


def test_short_waves_find_the_top_layer_alone():
    """At k h = 40, k T is that of a half-space of the top layer's soil, up to exp(-80)."""
    k = np.array([20.0, 400.0])
    assert k * surface_compliance([SOFT, STIFF], k) == pytest.approx(SOFT.half_space, rel=1e-13)


def test_stress_in_a_half_space():
    """Stress (1 + k z) exp(-k z), settlement (1 + nu) / (E k) (2 (1 - nu) + k z) exp(-k z), however it is cut."""
    depths = np.array([0.0, 0.003, 0.4, 1.0, 4.0])
    cut = [*(ElasticLayer(3e6, 0.3, float(h)) for h in np.diff(depths)), ElasticLayer(3e6, 0.3, math.inf)]
    k = np.array([1e-3, 0.02, 0.3, 2.0, 7.0])
    settled, stress = carry_down(cut, k)
    kz = k * depths[:, None]
    assert stress == pytest.approx((1 + kz) * np.exp(-kz), rel=1e-11)
    assert settled == pytest.approx(1.3 / (3e6 * k) * (1.4 + kz) * np.exp(-kz), rel=1e-11)


def test_settlement_in_depth_is_that_of_the_surface_below():
    """Loaded by what arrives there, the layers below would settle so, but for the shear; long waves have none."""
    k = np.array([1e-7])
    settled, stress = carry_down([SOFT, STIFF], k)
    assert stress[1] == pytest.approx(1.0, rel=1e-9)
    assert settled[1] == pytest.approx(surface_compliance([STIFF], k), rel=1e-9)


@settings(max_examples=examples(30), deadline=None, derandomize=True)
@given(stacks)
def test_tractions_and_displacements_are_reciprocal(stack):
    """Every compliance is symmetric (Betti) and positive definite, at the top of every layer."""
    k = np.geomspace(1e-2, 1e2, 9)
    for C in compliances(layers_of(stack), k):
        scale = np.sqrt(C[:, 0, 0] * C[:, 1, 1])
        assert C[:, 0, 1] / scale == pytest.approx(C[:, 1, 0] / scale, abs=1e-11)
        assert np.linalg.det(C / scale[:, None, None]).min() > 0
        assert C[:, 0, 0].min() > 0
