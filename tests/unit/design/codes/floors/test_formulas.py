"""Formulas of floors: yield lines by virtual work, strips by Hetenyi's influence line, fatigue by a printed table."""

from __future__ import annotations

import math

import numpy as np
import pytest

from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.floors import resistance, strips, yield_lines
from groundslab.design.codes.floors.yield_lines import YieldSlab

SLAB = YieldSlab(l=0.8, M_p=7e3, M_n=11e3)


def virtual_work(sides: int, sector: float) -> float:
    """Return the load over M_p + M_n of a pyramid of so many triangles over a sector [rad], of any size.

    The slab sinks by 1 at its tip; each triangle turns by 1 / R about its base 2 R tan(half), where it hogs, and the
    components of the turning across the ridges are the same again for sagging.
    """
    half = sector / sides / 2
    return sides * 2 * math.tan(half)


def test_a_force_inside_makes_a_fan_all_around() -> None:
    """Of very many triangles the work is 2 pi (M_p + M_n)."""
    load = virtual_work(100_000, 2 * math.pi) * (SLAB.M_p + SLAB.M_n)
    assert yield_lines.single(SLAB, 0.0, "internal") == pytest.approx(load, rel=1e-6)


def test_a_force_at_a_corner_makes_one_hogging_line_across_it() -> None:
    """At 45 degrees and any distance r, 2 r long, it turns by 1 / r: 2 M_n."""
    r = 1.7
    assert yield_lines.single(SLAB, 0.0, "corner") == pytest.approx(2 * r / r * SLAB.M_n)


def test_a_force_at_an_edge_by_hand() -> None:
    """As TR34 has it: pi / 2 (7 + 11) + 2 x 11 kN for none, (pi (7 + 11) + 4 x 11) / (1 - 2 / 3 x 0.3) for 0.3 l."""
    assert yield_lines.single(SLAB, 0.0, "edge") == pytest.approx(50.274e3, rel=1e-4)
    assert yield_lines.single(SLAB, 0.3 * SLAB.l, "edge") == pytest.approx(125.686e3, rel=1e-4)


@pytest.mark.parametrize("location", ["internal", "edge", "corner"])
def test_loads_grow_with_their_area_without_a_jump(location: yield_lines.Location) -> None:
    """Linear up to a / l = 0.2 and on from there; a wide footprint bears more."""
    loads = [yield_lines.single(SLAB, ratio * SLAB.l, location) for ratio in (0.0, 0.1, 0.2 - 1e-12, 0.2, 0.3)]
    assert loads == sorted(loads)
    assert loads[1] == pytest.approx((loads[0] + loads[3]) / 2)
    assert loads[2] == pytest.approx(loads[3])


def test_two_forces_at_one_place_are_one_and_four_are_two_pairs() -> None:
    """The formula of groups meets that of single forces at no distance, and grows with the sum of the distances."""
    for location in ("internal", "edge", "corner"):
        assert yield_lines.group(SLAB, 0.1, 0.0, location) == pytest.approx(yield_lines.single(SLAB, 0.1, location))
    one, two = (yield_lines.group(SLAB, 0.0, x, "internal") for x in (0.5, 1.0))
    assert two - one == pytest.approx(1.8 * 0.5 / SLAB.l * (SLAB.M_p + SLAB.M_n))


def test_meyerhof_by_the_example_of_aci_360() -> None:
    """Appendix 6: 15 kip on 4 x 6 in need 3.13 in-kip/in inside, with 20 % transfer 3.97 at a joint, at SF 1.5."""
    a, L = math.sqrt(24 / math.pi), 28.5
    assert 1.5 * 15 / yield_lines.meyerhof(1.0, a, L, "internal") == pytest.approx(3.13, rel=4e-3)
    assert 1.5 * 0.8 * 15 / yield_lines.meyerhof(1.0, a, L, "edge") == pytest.approx(3.97, rel=4e-3)


def moment(lam: float, x: float, at: float) -> float:
    """Return the moment at a place of an endless beam on springs under a unit force at x (Hetenyi 1946)."""
    s = lam * abs(x - at)
    return math.exp(-s) * (math.cos(s) - math.sin(s)) / (4 * lam)


def test_the_worst_aisle_by_summing_up_forces() -> None:
    """Any aisle with any widths of load beside it, added up force by force, bends no more; the worst one as much."""
    lam, n = 1.3, 4000
    x = (np.arange(n) + 0.5) / n * 6 / lam
    bent = np.array([moment(lam, each, 0.0) for each in x]) * (x[1] - x[0])
    total = np.concatenate([[0.0], np.cumsum(bent)])
    most = 2 * (total.max() - total.min())  # from the zero that sags least to the one that hogs most, both sides
    worst = max(-2 * (total[j] - total[i]) for i in range(0, n, 40) for j in range(i, n, 40))
    assert strips.aisle_load(1.0, lam) * worst == pytest.approx(1.0, rel=2e-3)
    assert worst <= most


def test_line_loads_by_hetenyi() -> None:
    """P / (4 lambda) inside; at the end of a beam 0.3224 P / lambda, for which TR34 has a third."""
    lam = 1.3
    assert strips.line_load(moment(lam, 0.0, 0.0), lam, at_edge=False) == pytest.approx(1.0)
    x = np.linspace(0, 5 / lam, 10_001)
    end = (np.exp(-lam * x) * np.sin(lam * x)).max() / lam
    assert strips.line_load(end, lam, at_edge=True) == pytest.approx(1.0, rel=0.04)
    assert strips.line_load(end, lam, at_edge=True) < 1


#: Table 5.3 of ACI 360R-10, after PCA 1984: stress over modulus of rupture, allowed repetitions.
FATIGUE = {0.46: 14_335_236, 0.50: 762_043, 0.54: 166_533, 0.55: 124_523, 0.60: 30_927, 0.70: 1917, 0.80: 119}


def test_fatigue_by_the_table_of_aci_360() -> None:
    """Its repetitions come out within half a per cent, and back; stresses below 0.45 may be repeated for ever."""
    for ratio, count in FATIGUE.items():
        assert resistance.allowed_repetitions(ratio) == pytest.approx(count, rel=0.005, abs=0.5)
        assert resistance.allowed_ratio(resistance.allowed_repetitions(ratio)) == pytest.approx(ratio, abs=1e-9)
    assert resistance.allowed_repetitions(0.449) == math.inf
    assert resistance.allowed_ratio(1e12) == 0.45


def test_moments_of_sections_by_hand() -> None:
    """150 mm of C25/30 with a mesh A193 at d = 93 mm, as a public calculation sheet by TR34 prints: 9.3, 7.4 kNm/m."""
    concrete = Concrete(25e6)
    assert resistance.plain_moment(concrete, 0.15) == pytest.approx(9.3e3, abs=50)
    assert resistance.mesh_moment(193e-6, 0.093, Steel(500e6)) == pytest.approx(7.4e3, abs=50)
    assert resistance.flexural_strength(concrete, 0.8) == pytest.approx(concrete.f_ctm / 1.5)


def test_fibers_that_keep_the_strength_bear_a_plastic_block() -> None:
    """With one stress s from tip to face, 0.9 h high, half of h below the resultant of pressure: 0.45 s h^2."""
    s, h = 1e6, 0.2
    M = resistance.fiber_moment(s / 0.45, s / 0.37, h, 1.0)
    assert pytest.approx(s * 0.9 * h * 0.5 * h) == M


def test_restraint_by_hand() -> None:
    """Half of 30 m of concrete 0.2 m thick, 24 kN/m3, at mu = 0.5 pulls 36 kN/m: 0.18 MPa on 0.2 m."""
    assert resistance.restraint_stress(0.5, 24e3, 30.0) == pytest.approx(0.5 * 24e3 * 0.2 * 15 / 0.2)
