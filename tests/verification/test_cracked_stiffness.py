"""Slabs that crack: a strip against a boundary value problem, the limits of no and of full cracking, what stays."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from groundslab.analysis.driver import Variants, solve
from groundslab.case import casefile
from groundslab.discretize.cracking import cracked_sections
from groundslab.errors import InputError
from groundslab.fem.cracked_section import CrackedSections
from groundslab.model.model import Model
from groundslab.results.fields import LAYERS
from groundslab.results.results import CombinationResult

STRIP = """
[plate]
length_x = "12 m"
length_y = "1 m"
thickness = "0.3 m"
E = "33 GPa"
nu = 0.0
[ground]
kind = "winkler"
k = "8 MPa/m"
[contact]
tensionless = false
[[cases]]
name = "G"
[[loads]]
kind = "patch"
case = "G"
q = "300 kPa"
x = ["-0.75 m", "0.75 m"]
y = ["-0.5 m", "0.5 m"]
[[combinations]]
name = "Ed"
factors = { G = 1.35 }
[[combinations]]
name = "qp"
limit_state = "quasi-permanent"
factors = { G = 1.0 }
[reinforcement]
concrete = "C30/37"
steel = "B500B"
bottom = ["50 mm", "62 mm"]
top = ["45 mm", "57 mm"]
bottom_x = { diameter = "12 mm", spacing = "125 mm" }
bottom_y = { diameter = "12 mm", spacing = "125 mm" }
top_x = { diameter = "10 mm", spacing = "150 mm" }
top_y = { diameter = "10 mm", spacing = "150 mm" }
[cracking]
creep = 1.5
duration = "short"
[mesh]
counts = [96, 4]
"""


def _model(text: str = STRIP, **sections: dict[str, Any]) -> Model:
    """Return the model of a text with some keys of its sections replaced, in SI units."""
    model = casefile.loads(text)
    return model.replace(**{name: getattr(model, name).replace(**keys) for name, keys in sections.items()})


def section_law(model: Model) -> CrackedSections:
    """Return how the plate cracks outside of zones."""
    law = cracked_sections(model, np.zeros(1, dtype=int), np.zeros((1, 2)))
    assert law is not None
    return law


def _strip_by_integration(model: Model, k: float, q: float, a: float) -> tuple[float, float, float, float]:
    """Return w in the middle and at the end [m], the moment in the middle and its smallest [N m/m] of the strip.

    w' = beta + Q / S, beta' = -chi(M), M' = Q, Q' = k w - q on half the strip; the section bends by 7.18 and 7.19,
    whose jump at M_cr, if beta is below 1, is spread over 1 % of M_cr.
    """
    law = section_law(model)
    B_I, S, half = law.B_I[0, 0], law.shear[0], model.plate.sides[0] / 2

    def chi(M: np.ndarray) -> np.ndarray:
        found = []
        for face, sign in ((0, 1), (1, -1)):
            B_II, M_cr = law.B_II[0, 0, face], law.M_cr[0, 0, face]
            over = np.clip((sign * M / M_cr - 0.995) / 0.01, 0, 1)
            zeta = np.clip(over * (1 - law.beta[0] * np.minimum(M_cr / np.maximum(sign * M, 1e-9), 1) ** 2), 0, 1)
            by_shrinkage = sign * zeta * law.shrinkage[0, 0, face]
            found.append(M * (zeta / B_II + (1 - zeta) / B_I) + by_shrinkage)
        return law.shrinkage_I[0, 0] + np.where(M > 0, *found)

    def slopes(load: float, y: np.ndarray) -> np.ndarray:
        w, beta, M, Q = y
        return np.array([beta + Q / S, -chi(M), Q, k * w - load])

    # two parts, with the load and without, on a common unit interval
    def both(_: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.vstack([a * slopes(q, y[:4]), (half - a) * slopes(0.0, y[4:])])

    def ends(left: np.ndarray, right: np.ndarray) -> np.ndarray:
        return np.concatenate([left[[1, 3]], right[:4] - left[4:], right[[6, 7]]])

    s = np.linspace(0, 1, 401)
    start = np.zeros((8, len(s)))
    found = solve_bvp(both, ends, s, start, tol=1e-5, max_nodes=100_000)
    assert found.success
    y = found.sol(np.linspace(0, 1, 4001))
    return y[0, 0], y[4, -1], y[2, 0], min(y[2].min(), y[6].min())


def _strip_of(results: CombinationResult, half: float) -> tuple[float, float, float, float]:
    """Return the same four of the slab's results."""
    plate = results.plate
    middle, end = (plate.value_at("settlement", x, 0.0) for x in (0.0, half))
    return middle, end, plate.value_at("moment_x", 0.0, 0.0), float(plate.moment_x.min())


def test_strip_is_that_of_an_integrated_beam() -> None:
    """Settlements are within 0.1 % and moments within 0.2 % of the beam's, which differ from uncracked ones by more."""
    model = _model()
    found = solve(model)["qp"]
    expected = _strip_by_integration(model, 8e6, 300e3, 0.75)
    uncracked = _strip_of(solve(_model(cracking={"f_ct": 1e12}))["qp"], 6.0)
    got = _strip_of(found, 6.0)
    largest = expected[0]
    np.testing.assert_allclose(got[:2], expected[:2], atol=1e-3 * largest)
    np.testing.assert_allclose(got[2:], expected[2:], rtol=2e-3)
    assert got[0] > 1.1 * uncracked[0]
    assert got[2] < 0.9 * uncracked[2]
    assert found.certificate.section_law is not None
    assert found.certificate.section_law <= found.certificate.LAW_TOLERANCE


def test_strip_that_shrinks() -> None:
    """With shrinkage, which bends cracked sections more than others, the strip is that of the beam, and sags more."""
    model = _model(cracking={"shrinkage": 3e-4})
    expected = _strip_by_integration(model, 8e6, 300e3, 0.75)
    got = _strip_of(solve(model)["qp"], 6.0)
    np.testing.assert_allclose(got[:2], expected[:2], atol=2e-3 * expected[0])
    np.testing.assert_allclose(got[2:], expected[2:], rtol=5e-3)
    without = _strip_of(solve(_model())["qp"], 6.0)
    assert got[0] - got[1] > 1.005 * (without[0] - without[1])


def test_strip_under_lasting_loads() -> None:
    """With beta 0.5, whose law has a jump, the strip still is that of the beam within 0.5 %."""
    model = _model(cracking={"duration": "long"})
    expected = _strip_by_integration(model, 8e6, 300e3, 0.75)
    got = _strip_of(solve(model)["qp"], 6.0)
    np.testing.assert_allclose(got[:2], expected[:2], atol=5e-3 * expected[0])
    np.testing.assert_allclose(got[2:], expected[2:], rtol=2e-2)


def test_moments_satisfy_the_clause_in_every_element() -> None:
    """Each element of the strip has the stiffness of 7.18 for its own moment, worked out here from its bars."""
    e = solve(_model())["qp"].elements
    E, h, a, b = 33e9 / 2.5, 0.3, 0.05, 0.045
    below, above = np.pi * 0.012**2 / 4 / 0.125, np.pi * 0.010**2 / 4 / 0.15
    n, d = 200e9 / E, h - a
    z = (h * h / 2 + (n - 1) * (below * d + above * b)) / (h + (n - 1) * (below + above))
    I_I = h**3 / 12 + h * (h / 2 - z) ** 2 + (n - 1) * (below * (d - z) ** 2 + above * (z - b) ** 2)
    depths = np.linspace(0.01, 0.2, 2_000_001)
    m = np.where(depths > b, n - 1, n)
    x = depths[np.argmin(np.abs(depths**2 / 2 + m * above * (depths - b) - n * below * (d - depths)))]
    I_II = x**3 / 3 + (n - (x > b)) * above * (x - b) ** 2 + n * below * (d - x) ** 2
    M_cr = 0.3 * 30 ** (2 / 3) * 1e6 * I_I / (h - z)
    sags = e.moment_x > 0
    cracked = e.moment_x > M_cr
    assert 0.05 < cracked.mean() < 0.5
    zeta = np.where(cracked, 1 - (M_cr / e.moment_x) ** 2, 0.0)
    wanted = 1 / (zeta * I_I / I_II + 1 - zeta)
    assert e.stiffness_ratio is not None
    assert e.stiffness_ratio[sags].min() < 0.4
    # as exact as the iteration, whose error counts the more the nearer a moment is to M_cr
    np.testing.assert_allclose(e.stiffness_ratio[sags], wanted[sags], rtol=0.02)


def test_without_cracks_it_is_the_elastic_slab() -> None:
    """Concrete that never cracks, with hardly any bars, settles as the elastic slab of E_cm / (1 + phi)."""
    layers = {layer: {"diameter": 4e-3, "spacing": 100.0} for layer in LAYERS}
    sections = {"plate": {"nu": 0.2}, "reinforcement": layers, "cracking": {"f_ct": 1e12, "creep": 1.5}}
    found = solve(_model(**sections))["qp"].plate
    elastic = solve(_model(plate={"nu": 0.2, "E": 33e9 / 2.5}).replace(cracking=None))["qp"].plate
    np.testing.assert_allclose(found.settlement, elastic.settlement, rtol=1e-5, atol=1e-5 * elastic.settlement.max())
    np.testing.assert_allclose(found.moment_x, elastic.moment_x, rtol=1e-4, atol=1e-4 * elastic.moment_x.max())


def test_with_all_cracks_it_is_the_slab_of_the_cracked_sections() -> None:
    """Concrete without strength, reinforced alike everywhere, settles as an elastic slab of B_II without nu."""
    alike = {layer: {"diameter": 0.012, "spacing": 0.125} for layer in LAYERS}
    model = _model(reinforcement=alike | {"bottom": (0.05, 0.05), "top": (0.05, 0.05)}, cracking={"f_ct": 1.0})
    law = section_law(model)
    assert np.ptp(law.B_II) < 1e-6 * law.B_II.max()
    found = solve(model)["qp"].plate
    # shear, which the cracked slab has of its concrete, is next to nothing in either
    softer = {"E": law.B_II[0, 0, 0] * 12 / 0.3**3, "shear_factor": 1.0}
    expected = solve(_model(plate=softer).replace(cracking=None))["qp"].plate
    np.testing.assert_allclose(found.settlement, expected.settlement, atol=5e-3 * expected.settlement.max())


def test_bars_of_zones_are_bars_of_the_slab() -> None:
    """A zone over half of the strip: it is bent less there; over all of it, it is the strip with all bars at first."""
    bars = {"diameter": 0.012, "spacing": 0.125}
    more, base = {"layers": list(LAYERS)} | bars, dict.fromkeys(LAYERS, bars)

    def strip(*zones: tuple[float, float], **layers: object) -> CombinationResult:
        shapes = [{"kind": "rectangle", "x": each, "y": (-0.5, 0.5)} for each in zones]
        of_zones = [more | {"name": f"zone {n}", "shape": shape} for n, shape in enumerate(shapes)]
        return solve(_model(reinforcement=base | layers | {"zones": of_zones}))["qp"]

    all_over, doubled = strip((-6.0, 6.0)), strip(**dict.fromkeys(LAYERS, bars | {"spacing": 0.0625}))
    np.testing.assert_allclose(all_over.plate.moment_x, doubled.plate.moment_x, rtol=1e-9, atol=1e-6)
    one_side, without = strip((0.0, 6.0)), strip()
    ratio, x = one_side.elements.stiffness_ratio, one_side.plate.nodes[one_side.plate.elements[:, 8], 0]
    assert ratio is not None
    assert ratio[(x > 0) & (x < 0.75)].min() > ratio[(x < 0) & (x > -0.75)].min()
    sag = [each.plate.value_at("settlement", 0.0, 0.0) for each in (without, one_side, all_over)]
    assert sag[0] > sag[1] > sag[2]


def test_ultimate_combinations_stay_elastic() -> None:
    """What strength is checked with is the elastic slab, whatever cracks in serviceability."""
    with_it, without = solve(_model())["Ed"], solve(_model().replace(cracking=None))["Ed"]
    np.testing.assert_array_equal(with_it.plate.moment_x, without.plate.moment_x)
    assert with_it.certificate.section_law is None
    assert with_it.elements.stiffness_ratio is not None
    assert (with_it.elements.stiffness_ratio == 1).all()


def test_shrinkage_bends_the_slab_to_its_curvature() -> None:
    """An unloaded strip on soft springs with more bars at the bottom sags by eps_cs alpha_e S / I (7.21)."""
    model = _model(plate={"length_x": 6.0}, cracking={"shrinkage": 3e-4, "f_ct": 1e12}, ground={"k": 1e3})
    light = [model.loads[0].replace(q=1e-3, x=(-0.5, 0.5))]
    model = model.replace(loads=light)
    law = section_law(model)
    results = solve(model)["qp"]
    sag = results.plate.value_at("settlement", 0.0, 0.0) - results.plate.value_at("settlement", 3.0, 0.0)
    assert law.shrinkage_I[0, 0] > 0
    assert sag == pytest.approx(law.shrinkage_I[0, 0] * 3.0**2 / 2, rel=1e-3)
    assert np.abs(results.plate.moment_x).max() < 1e-3 * law.B_I[0, 0] * law.shrinkage_I[0, 0]


SLAB = STRIP.replace('length_y = "1 m"', 'length_y = "8 m"').replace('length_x = "12 m"', 'length_x = "8 m"').replace(
    "nu = 0.0", "nu = 0.2").replace("counts = [96, 4]", "counts = [16, 16]").replace(
    'y = ["-0.5 m", "0.5 m"]', 'y = ["-0.75 m", "0.75 m"]').replace("300 kPa", "700 kPa")  # fmt: skip


def test_symmetry_and_direction_change_nothing() -> None:
    """A quarter is the full slab; a slab alike along x and y has the same moments along both."""
    alike = {"bottom": (0.05, 0.05), "top": (0.05, 0.05)}
    model = _model(SLAB, reinforcement=alike)
    quarter = solve(model)["qp"]
    full = solve(model.replace(mesh=model.mesh.replace(symmetry="off")))["qp"]
    assert quarter.elements.stiffness_ratio is not None
    assert quarter.elements.stiffness_ratio.min() < 0.6
    scale = quarter.plate.settlement.max()
    np.testing.assert_allclose(quarter.plate.settlement, full.plate.settlement, atol=2e-3 * scale)
    x = quarter.plate.value_at("moment_x", 1.0, 0.5)
    assert quarter.plate.value_at("moment_y", 0.5, 1.0) == pytest.approx(x, rel=5e-3)


@pytest.mark.parametrize("ground", ["vlasov", "tensionless"])
def test_gamma_and_contact_go_with_the_cracks(ground: str) -> None:
    """On ground whose gamma is iterated, and where the slab lifts off, the result is certified and softer."""
    text = SLAB
    if ground == "vlasov":
        soil = 'kind = "vlasov"\n[[ground.layers]]\nE = "30 MPa"\nnu = 0.3\nthickness = "5 m"'
        text = text.replace('kind = "winkler"\nk = "8 MPa/m"', soil)
    text = text.replace("tensionless = false", "tensionless = true")
    results = solve(_model(text))
    elastic = solve(_model(text).replace(cracking=None))
    assert set(results.results) == {"Ed", "qp"}
    assert results["qp"].certificate.holds
    assert results["qp"].plate.settlement.max() > elastic["qp"].plate.settlement.max()
    assert results["qp"].coarser is not None
    if ground == "vlasov":
        assert results["qp"].constants.gamma != elastic["qp"].constants.gamma


def test_variants_crack_as_if_alone() -> None:
    """A variant of a study has the settlement that it has by itself on the same mesh."""
    model = _model(SLAB)
    softer = model.replace(ground=model.ground.replace(k=6e6))
    alone = solve(softer)["qp"].plate.settlement.max()
    assert Variants(model).solve_combinations(softer)["qp"].plate.settlement.max() == pytest.approx(alone, rel=1e-3)


def test_what_is_missing_is_said() -> None:
    """Cracking without bars, and with increments of the load, is refused with where and why."""
    no_bars = STRIP[: STRIP.index("bottom_x")] + STRIP[STRIP.index("[cracking]") :]
    with pytest.raises(InputError) as error:
        casefile.loads(no_bars + "[analysis]\nincrements = 2\n")
    found = {issue.location: issue for issue in error.value.issues}
    assert "bars provided in all four layers" in found["cracking"].expected
    assert "analysis.increments" in found
