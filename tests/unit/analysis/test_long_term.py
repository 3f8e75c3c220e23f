"""Softer ground under lasting loads: of every kind it is the ground that is described with smaller moduli."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.analysis.driver import Variants, solve
from groundslab.case import casefile
from groundslab.results.soil_profile import profiles_of

CASE = """
[plate]
length_x = "4 m"
length_y = "3 m"
thickness = "0.3 m"
E = "30 GPa"
nu = 0.2
{ground}
[[cases]]
name = "G"
[[loads]]
kind = "uniform"
case = "G"
q = "40 kPa"
[[loads]]
kind = "point"
case = "G"
x = "1 m"
y = "0.5 m"
P = "200 kN"
width_x = "0.5 m"
width_y = "0.5 m"
[[combinations]]
name = "short"
limit_state = "characteristic"
factors = {{ G = 1.0 }}
[[combinations]]
name = "lasting"
limit_state = "quasi-permanent"
factors = {{ G = 1.0 }}
[mesh]
size = "0.5 m"
{more}
"""
LONG = "[long_term]\nstiffness = 0.5"
#: Each with its moduli as they are, and halved by hand.
GROUNDS = {
    "winkler": ('[ground]\nkind = "winkler"\nk = "{} MPa/m"', (20,)),
    "pasternak": ('[ground]\nkind = "pasternak"\nk0 = "{} MPa/m"\nk1 = "{} MN/m"', (20, 8)),
    "vlasov": (
        '[ground]\nkind = "vlasov"\n[[ground.layers]]\nE = "{} MPa"\nE_bottom = "{} MPa"\nnu = 0.3\nthickness = "4 m"',
        (20, 44),
    ),
    "layered": (
        '[ground]\nkind = "layered"\ncoupling = "consistent"\n[[ground.layers]]\nE = "{} MPa"\nnu = 0.3\n'
        'thickness = "2 m"\n[[ground.layers]]\nE = "{} MPa"\nnu = 0.2\nthickness = "2 m"',
        (20, 44),
    ),
    "boreholes": (
        '[ground]\nkind = "vlasov"\n[[ground.layers]]\nE = "1 MPa"\nnu = 0.3\nthickness = "4 m"\n'
        '[[boreholes]]\nx = "-2 m"\ny = "0 m"\n[[boreholes.layers]]\nE = "{} MPa"\nnu = 0.3\nthickness = "4 m"\n'
        '[[boreholes]]\nx = "2 m"\ny = "0 m"\n[[boreholes.layers]]\nE = "{} MPa"\nnu = 0.3\nthickness = "5 m"',
        (20, 44),
    ),
    "zones": (
        '[ground]\nkind = "winkler"\nk = "{} MPa/m"\n[[soil_zones]]\nground = {{ kind = "winkler", k = "{} MPa/m" }}\n'
        'shape = {{ kind = "rectangle", x = ["0 m", "3 m"], y = ["-2 m", "2 m"] }}',
        (20, 44),
    ),
}


@pytest.mark.parametrize("kind", GROUNDS)
def test_lasting_ground_is_ground_with_smaller_moduli(kind: str) -> None:
    """Under lasting loads settlements are those of ground described with half its moduli, under others as before."""
    ground, moduli = GROUNDS[kind]
    long = solve(casefile.loads(CASE.format(ground=ground.format(*moduli), more=LONG)))
    stiff = solve(casefile.loads(CASE.format(ground=ground.format(*moduli), more="")))
    soft = solve(casefile.loads(CASE.format(ground=ground.format(*(each / 2 for each in moduli)), more="")))
    np.testing.assert_array_equal(long["short"].plate.settlement, stiff["short"].plate.settlement)
    np.testing.assert_allclose(long["lasting"].plate.settlement, soft["lasting"].plate.settlement, rtol=1e-9)
    np.testing.assert_allclose(long["lasting"].constants.k0, soft["lasting"].constants.k0, rtol=1e-9)
    for mine, wanted in zip(profiles_of(long["lasting"]), profiles_of(soft["lasting"]), strict=True):
        np.testing.assert_allclose(mine.k0, wanted.k0, rtol=1e-6)


def test_variants_have_lasting_ground() -> None:
    """A variant of a study has softer ground in the combinations whose loads last, as it has by itself."""
    ground, moduli = GROUNDS["winkler"]
    base = casefile.loads(CASE.format(ground=ground.format(*moduli), more=LONG))
    variant = base.replace(ground=base.ground.replace(k=15e6))
    alone, found = solve(variant), Variants(base).solve_combinations(variant)
    for name in ("short", "lasting"):
        np.testing.assert_allclose(found[name].plate.settlement, alone[name].plate.settlement, rtol=1e-8)
