"""Closed forms that the cases are held against, each by another way to the same number."""

from __future__ import annotations

import math

import pytest

from groundslab.verification.analytic_beams import (
    beam_on_springs,
    lifting_strip_on_pasternak,
    strip_on_pasternak,
    supported_beam_on_springs,
)
from groundslab.verification.analytic_plates import clamped_ellipse, clamped_plate, wood_armer
from groundslab.verification.analytic_rigid import (
    rigid_cap_on_piles,
    rigid_circle_on_pasternak,
    rigid_circle_on_springs,
    rigid_plate_by_its_corner,
    rigid_plate_on_springs,
    rigid_plate_on_yielding_springs,
    rigid_strip,
)
from groundslab.verification.analytic_series import levy_plate, partly_loaded_plate, patch_at_an_edge

PLATE = {"a": 4.0, "b": 3.0, "D": 1e6, "nu": 0.3}


def test_four_hinged_edges_by_levy_are_those_by_navier() -> None:
    """One series with exact functions along y, and two series."""
    ground = {"k0": 2e5, "k1": 1e5}
    levy = levy_plate(0.7, 0.4, q=1e3, bottom="hinged", top="hinged", **PLATE, **ground)
    navier = partly_loaded_plate(0.7, 0.4, q=(1e3, 1e3), load_x=(-2, 2), load_y=(-1.5, 1.5), **PLATE, **ground)
    assert levy == pytest.approx(navier, rel=1e-4)


def test_a_narrow_plate_with_free_edges_is_a_beam() -> None:
    """With nu = 0 a plate with two free edges on springs bends as a simply supported beam."""
    plate = levy_plate(0.0, 0.1, 4.0, 0.5, 1e3, 1e6, 0.0, "free", "free", k0=5e5)
    beam = supported_beam_on_springs(2.0, 4.0, 1e6, 5e5, 1e3)
    assert plate["settlement"] == pytest.approx(beam["settlement"], rel=1e-6)
    assert plate["moment_x"] == pytest.approx(beam["moment"], rel=1e-4)


def test_a_long_ellipse_is_a_clamped_strip_and_a_circle_a_clamped_circle() -> None:
    """Q b^4 / 24 D of a clamped strip of width 2 b; q R^4 / 64 D of a circle."""
    assert clamped_ellipse(0, 0, 1e3, 1.0, 24.0, 1.0, 0.3)["settlement"] == pytest.approx(1.0, rel=1e-5)
    assert clamped_ellipse(0, 0, 2.0, 2.0, 64.0, 1.0, 0.3)["settlement"] == pytest.approx(16.0)


def test_two_clamped_edges_of_a_long_plate_are_those_of_a_clamped_one() -> None:
    """Far from short edges their support does not matter."""
    levy = levy_plate(0.0, 0.0, 20.0, 2.0, 1e3, 1e6, 0.3, "clamped", "clamped", k0=1.0)
    strip = 1e3 * 2.0**4 / (384 * 1e6)
    assert levy["settlement"] == pytest.approx(strip, rel=1e-3)
    assert clamped_plate(0.0, 0.0, 20.0, 2.0, 1e3, 1e6, 0.3)["settlement"] == pytest.approx(strip, rel=0.02)


def test_a_wide_patch_at_an_edge_is_a_beam_with_a_free_end() -> None:
    """Under a load that goes on along the edge for ever nothing varies along it: w = q / k under a deep patch."""
    wide = patch_at_an_edge(0.0, 1e5, 60.0, 40.0, 1e6, 0.0, 1e7)
    assert wide["settlement"] == pytest.approx(0.01, rel=2e-3)
    assert abs(wide["moment"]) < 1.0


def test_a_strip_without_shear_of_the_ground_is_a_beam_on_springs() -> None:
    """As k1 vanishes, glued or lifting."""
    beam = beam_on_springs(3.5, 6.0, 1e5, 3.0, 2e7, 2e7)
    for beyond in (False, True):
        strip = strip_on_pasternak(0.5, 6.0, 1e5, 2e7, 2e7, 1.0, beyond)
        assert {name: strip[name] for name in beam} == pytest.approx(beam, rel=1e-3)
    lifting = lifting_strip_on_pasternak(0.0, 1e5, 2e7, 2e7, 1e-2)
    half = math.pi / 2 * (4 * 2e7 / 2e7) ** 0.25
    assert lifting["contact"] == pytest.approx(half, rel=1e-3)


def test_forces_of_a_strip_on_ground_that_goes_on_are_in_equilibrium() -> None:
    """The pressure under it and what the ground beyond takes add up to the load."""
    k0, k1, P = 2e7, 3e7, 1e5
    n = 4000
    inside = sum(strip_on_pasternak(3 * (i + 0.5) / n, 6.0, P, 2e7, k0, k1, True)["settlement"] for i in range(n))
    edge = strip_on_pasternak(3.0, 6.0, P, 2e7, k0, k1, True)["settlement"]
    assert 2 * (k0 * inside * 3 / n + math.sqrt(k0 * k1) * edge) == pytest.approx(P, rel=1e-5)


def test_rigid_plates_agree_where_their_cases_meet() -> None:
    """A corner contact as wide as the plate, springs that just yield, a margin without end, a circle as a strip."""
    assert rigid_plate_by_its_corner(0, 0, 1e5, 0.5, 0.5, 1e6) == pytest.approx(3e5 / (8 * 0.25) / 1e6)
    elastic = rigid_plate_on_springs(0.3, 9.0, 6e5, 1.0, 2e7)
    assert rigid_plate_on_yielding_springs(0.3, 6e5, 1.0, 2e7, 4e5) == pytest.approx(elastic)
    free, fixed = (rigid_strip(0.5, 4.0, 1e5, 1e7, 4e7, margin=200.0, fixed=each) for each in (False, True))
    assert free == pytest.approx(rigid_strip(0.5, 4.0, 1e5, 1e7, 4e7)) == pytest.approx(fixed)
    wide = rigid_circle_on_pasternak(1.0, 400.0, 1e5 * math.pi * 400.0**2, 1e7, 4e7)
    assert wide == pytest.approx(1e5 / 1e7 * math.exp(-0.5), rel=2e-2)


def test_a_circle_at_the_edge_of_its_kern() -> None:
    """At e = R / 4 the pressure is just zero on the far side and twice the mean on the near one."""
    mean = 1e6 / (math.pi * 4) / 2e7
    near, far = (rigid_circle_on_springs(s, 2.0, 1e6, 0.5 * (1 + 1e-4), 2e7) for s in (2.0, -2.0))
    assert near == pytest.approx(2 * mean, rel=1e-3)
    assert abs(far) < 1e-3 * mean


def test_piles_carry_the_load_where_it_is() -> None:
    """Sum and moments of the piles' forces, elastic and with one that yields."""
    piles = [(2.0, 2.0, 1e8), (-2.0, 2.0, 2e8), (-2.0, -2.0, 1e8), (2.0, -2.0, 1e8)]
    for yielding in ({}, {"1": 1e5}):
        forces = [rigid_cap_on_piles(i, 1e6, (0.5, 0.25), piles, yielding) for i in range(1, 5)]
        assert sum(forces) == pytest.approx(1e6)
        assert sum(f * pile[0] for f, pile in zip(forces, piles, strict=True)) == pytest.approx(5e5)
        assert sum(f * pile[1] for f, pile in zip(forces, piles, strict=True)) == pytest.approx(2.5e5)


def test_bars_for_twist_alone_carry_it_both_ways() -> None:
    """Twist needs as much on each face along both axes."""
    twist = {"bottom_x": 2e4, "bottom_y": 2e4, "top_x": -2e4, "top_y": -2e4}
    assert wood_armer(0.0, 0.0, 2e4) == pytest.approx(twist, rel=1e-3)
