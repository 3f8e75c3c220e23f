"""EN 1992-1-1:2023: hand values of punching and shear, and every resistance once more in plain scalar code."""

from __future__ import annotations

import math
import random
from importlib.resources import files

import numpy as np
import pytest

from groundslab.design.codes.en1992_2023 import bending, cracking, punching, shear
from groundslab.design.codes.en1992_2023.annex import RECOMMENDED, table
from groundslab.design.codes.en1992_2023.materials import Concrete, Steel
from groundslab.design.codes.en1992_2023.materials_of_case import flattest, materials
from groundslab.design.codes.eurocode2.cracked_sections import Bars
from groundslab.errors import InputError
from groundslab.model.design.reinforcement import Reinforcement

B500 = Steel(500e6)
AXES = {"bottom": (0.04, 0.05), "top": (0.04, 0.05)}
#: Square internal columns by hand, gamma_V 1.4, D_lower 16 mm: c, d_v [mm], rho [%], f_ck [MPa]; b_0.5 [mm], k_pb,
#: tau_Rd,c [MPa], V_Rd,c [kN], tau_Rdc,min [MPa] with f_yd 435 MPa.
COLUMNS = [
    ((400, 250, 0.8, 30), (2385.4, 2.0657, 1.287, 767.5, 0.738)),
    ((500, 540, 0.35, 30), (3696.5, 2.4388, 0.892, 1781.1, 0.502)),
    ((300, 200, 1.2, 35), (1828.3, 2.1104, 1.707, 624.1, 0.891)),
]


@pytest.mark.parametrize(("given", "wanted"), COLUMNS)
def test_square_columns_by_hand(given: tuple[float, ...], wanted: tuple[float, ...]) -> None:
    """Perimeter, gradient, stress and force that need no links, and the least stress; digits as printed."""
    c, d, rho, f_ck = given
    concrete, b_0 = Concrete(f_ck * 1e6), 4 * c / 1e3
    b_05 = b_0 + math.pi * d / 1e3
    k_pb = punching.gradient(b_0, b_05)
    tau = punching.resistance_without_links(concrete, k_pb, rho / 100, d / 1e3)
    least = float(shear.minimum_resistance(concrete, Steel(435e6, 1.0), d / 1e3))
    found = b_05 * 1e3, k_pb, tau / 1e6, tau * b_05 * d / 1e6, least / 1e6
    for value, digits, places in zip(found, wanted, (1, 4, 3, 1, 3), strict=True):
        assert round(value, places) == digits


def test_random_columns_in_plain_code() -> None:
    """Twenty of each: by 8.20, 8.27, 8.94, 8.96, 8.104 to 8.106 and 8.111, in mm, N and MPa."""
    draw = random.Random(2023)
    for _ in range(20):
        f_ck, lower, d = draw.uniform(12, 90), draw.uniform(8, 40), draw.uniform(120, 1500)
        rho, c, gamma = draw.uniform(5e-4, 0.03), draw.uniform(150, 1200), draw.uniform(1.15, 1.5)
        concrete = Concrete(f_ck * 1e6, gamma_v=gamma, d_lower=lower / 1e3)
        rough = 16 + lower * (60 / f_ck) ** 2 if f_ck > 60 else 16 + lower
        rough = rough if rough < 40 else 40
        b_0, b_05 = 4 * c, 4 * c + 3.14159265358979 * d
        gradient = 3.6 * (1 - b_0 / b_05) ** 0.5
        gradient = 1 if gradient < 1 else 2.5 if gradient > 2.5 else gradient
        ratio = rho if rho < 0.02 else 0.02
        of_bars = 0.6 / gamma * gradient * (100 * ratio * f_ck * rough / d) ** (1 / 3)
        bound = 0.5 / gamma * f_ck**0.5
        tau = of_bars if of_bars < bound else bound
        assert punching.gradient(b_0 / 1e3, b_05 / 1e3) == pytest.approx(gradient, rel=1e-12)
        found = punching.resistance_without_links(concrete, gradient, rho, d / 1e3)
        assert found == pytest.approx(tau * 1e6, rel=1e-12)
        least = 11 / gamma * (f_ck / (500 / 1.15) * rough / d) ** 0.5
        one_way = 0.66 / gamma * (100 * ratio * f_ck * rough / d) ** (1 / 3)
        force = (one_way if one_way > least else least) * 0.9 * d  # N/mm
        given = concrete, B500, np.array([d / 1e3]), np.array([rho])
        assert shear.resistance_without_links(*given)[0] == pytest.approx(force * 1e3, rel=1e-12)
        demand, phi = tau * draw.uniform(1.05, 1.6), draw.uniform(6, 20)
        eta_c = tau / demand
        eta_s = d / (150 * phi) + (15 * rough / d) ** 0.5 * (1 / (eta_c * gradient)) ** 1.5
        eta_s = eta_s if eta_s < 0.8 else 0.8
        assert punching.links_share(rough, d, phi, eta_c, gradient) == pytest.approx(eta_s, rel=1e-12)
        rho_w = punching.required_links(demand, tau, (eta_c, eta_s), 435.0)
        # the least links that resist: with them the demand is met, with a little less it is not
        resists = [max(eta_c * tau + eta_s * part * rho_w * 435, part * rho_w * 435) for part in (1, 0.999)]
        assert resists[0] == pytest.approx(demand, rel=1e-9)
        assert resists[1] < demand
        system = 0.5 + 0.63 * (b_0 / d) ** 0.25
        assert punching.system_factor(concrete, b_0, d) == pytest.approx(system if system > 1 else 1, rel=1e-12)


def test_the_block_is_a_parabola_rectangle() -> None:
    """The moment that the bars found bear, by stresses integrated over a hundred thousand strips, is the one given."""
    concrete, d = Concrete(35e6), 0.5
    for m in (0.05e6, 0.3e6, 0.9e6):
        area = float(bending.required(np.array([m]), d, concrete, B500, thickness=0.55).tension[0])
        strips = 100_000
        strain = 3.5e-3 * (np.arange(strips) + 0.5) / strips  # from the neutral axis to the compressed face
        stress = concrete.f_cd * np.where(strain < 2e-3, 1 - (1 - strain / 2e-3) ** 2, 1.0)
        x = area * B500.f_yd / stress.mean()
        from_axis = x * float((stress * strain).sum() / stress.sum()) / 3.5e-3
        assert area * B500.f_yd * (d - x + from_axis) == pytest.approx(m, rel=1e-8)
    assert bending.deepest_axis(B500) == pytest.approx(1 - 1 / (1 + 0.7 * 0.0035 * 200e3 / (500 / 1.15)))


def test_least_bars_yield_as_the_section_cracks() -> None:
    """A_s f_yk 0.9 d = f_ctm h^2 / 6."""
    area = float(bending.minimum(np.array(0.26), 0.3, concrete=Concrete(30e6), steel=B500))
    assert area * 500e6 * 0.9 * 0.26 == pytest.approx(0.3 * 30 ** (2 / 3) * 1e6 * 0.3**2 / 6)
    with pytest.raises(InputError, match="thickness"):
        bending.minimum(np.array(0.26), concrete=Concrete(30e6), steel=B500)


@pytest.mark.parametrize(
    ("shape", "along", "across", "e_b"),
    [("closed", 0.3, -0.4, 0.5), ("edge", -0.3, 0.4, 0.5), ("corner", 0.3, -0.4, 0.189)],
)
def test_eccentricities(shape: punching.Shape, along: float, across: float, e_b: float) -> None:
    """By Table 8.3: across the edge half counts; beta_e grows from 1.05 by 1.1 e_b / b_b."""
    assert punching.eccentricity(shape, along, across) == pytest.approx(e_b)
    assert punching.beta(e_b, 0.4, 0.9) == pytest.approx(1 + 1.1 * e_b / 0.6)
    assert punching.beta(0.0, 0.4, 0.9) == 1.05


def test_contraflexure_near_the_support() -> None:
    """a_pd is d_v at a_p = 8 d_v and beyond, and never that of an a_p below d_v."""
    assert punching.depth_by_contraflexure(8.0, 1.0) == punching.depth_by_contraflexure(math.inf, 1.0) == 1.0
    assert punching.depth_by_contraflexure(2.0, 1.0) == 0.5
    assert punching.depth_by_contraflexure(0.1, 1.0) == pytest.approx(8**-0.5)


def test_cracks_open_wider_with_fewer_bars() -> None:
    """Beyond 10 phi apart only 10 phi count, 1.3 (h - x) / k_w is the largest distance, poor bond widens."""
    concrete, h, m = Concrete(30e6), np.array([0.4]), np.array([60e3])
    near, far = Bars(0.016, 0.16, 0.03), Bars(0.016, 0.32, 0.03)
    assert cracking.effective_ratio(np.array(0.1), near) == pytest.approx(math.pi * 0.016**2 / 4 / 0.16 / 0.1)
    assert cracking.effective_ratio(np.array(0.1), far) == pytest.approx(math.pi * 0.016**2 / 4 / 0.16 / 0.1)
    x, rho, k_fl = np.array([0.06]), np.array([1e-3]), np.array([0.7])
    assert cracking.mean_spacing(near, h, x, rho, k_fl, (0.9, 1.7)) == pytest.approx(1.3 * 0.34 / 1.7)
    good, poor = (cracking.crack_width(m, h, near, concrete, B500, k_b)[0] for k_b in (0.9, 1.2))
    assert 0 < good < poor


def test_materials_of_a_case() -> None:
    """Factors by default and as given; those of accidental combinations, with gamma_V among them."""
    case = Reinforcement(code="EN 1992-1-1:2023", concrete="C30/37", steel="B500A", **AXES)
    concrete, bars = materials(case)
    assert (concrete.f_cd, bars.f_yd) == pytest.approx((17e6, 500e6 / 1.15))
    assert (concrete.gamma_v, concrete.d_dg) == (1.4, 0.032)
    assert flattest(case, concrete) == pytest.approx(2.0)
    rare, rare_bars = materials(case, "accidental")
    assert (rare.gamma_c, rare.gamma_v, rare_bars.gamma_s) == (1.15, 1.15, 1.0)
    other = Reinforcement(
        code="EN 1992-1-1:2023", f_ck=80e6, f_yk=500e6, gamma_c=1.4, gamma_s=1.1, gamma_v=1.3, k_tc=1.0,
        d_lower=0.032, **AXES,
    )  # fmt: skip
    concrete, bars = materials(other)
    assert (concrete.gamma_c, concrete.gamma_v, concrete.k_tc, bars.gamma_s) == (1.4, 1.3, 1.0, 1.1)
    assert concrete.f_cd == pytest.approx((40 / 80) ** (1 / 3) * 80e6 / 1.4)
    assert concrete.d_dg == pytest.approx(16e-3 + 32e-3 * (60 / 80) ** 2)
    assert flattest(other, concrete) == 2.5
    with pytest.raises(InputError, match="aggregates of 8 mm"):
        Concrete(30e6, d_lower=0.004)


@pytest.mark.parametrize(
    ("key", "value", "hint"),
    [("annex", "Germany", "no annex to it is known"), ("alpha_cc", 0.85, "k_tc"), ("exposure", "XC2", "w_max"),
     ("size_effect", False, ""), ("detailing", {}, "anchorage and laps"),
     ("proposal", {"most_zones": 3}, "anchorage and laps")],
)  # fmt: skip
def test_keys_of_other_codes_are_refused(key: str, value: object, hint: str) -> None:
    """With what there is instead."""
    given = {"f_ck": 30e6, "f_yk": 500e6, **AXES, key: value}
    with pytest.raises(InputError, match=f"{key} with EN 1992-1-1:2023") as caught:
        Reinforcement(code="EN 1992-1-1:2023", **given)
    assert hint in str(caught.value)


@pytest.mark.parametrize("key", ["gamma_v", "k_tc", "d_lower"])
def test_its_own_keys_are_refused_by_the_first_generation(key: str) -> None:
    """A factor that says nothing must not be given."""
    given = {"f_ck": 30e6, "f_yk": 500e6, **AXES, key: {"d_lower": 0.016}.get(key, 1.0)}
    with pytest.raises(InputError, match=f"{key} with EN 1992-1-1"):
        Reinforcement(**given)


def test_every_parameter_says_where_it_was_read() -> None:
    """All have a clause and a source, and are attributes of the annex."""
    parameters = table()
    assert set(parameters) == set(RECOMMENDED.__slots__)
    assert all(parameter["clause"] and parameter["sources"] for parameter in parameters.values())
    folder = files("groundslab.design.codes.en1992_2023") / "annexes"
    assert [each.name for each in folder.iterdir() if each.name.endswith(".toml")] == ["recommended.toml"]
