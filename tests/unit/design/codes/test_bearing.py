"""Bearing resistance and sliding by EN 1997-1, against numbers by hand and other forms of the same."""

from __future__ import annotations

import math

import pytest
from shapely import Polygon, box

import groundslab as gs
from groundslab.case import casefile
from groundslab.design.checks import check_design
from groundslab.design.codes.en1997.bearing import Soil, bearing_resistance, effective_area, sliding_resistance
from groundslab.design.codes.en1997.bearing_steps import bearing_steps
from groundslab.model.design.limits import SoilStrength
from helpers.calculations import follow_steps


def soil(phi: float = 30.0, c: float = 0.0, c_u: float | None = None) -> Soil:
    """Return a soil of 18 kN/m3 under 9 kPa."""
    return Soil(math.radians(phi), c, c_u, 18e3, 9e3)


def test_the_effective_area_of_an_eccentric_rectangle_is_meyerhof_s() -> None:
    """B' = B - 2 e of each side; outside the base there is none."""
    found = effective_area(box(-1.5, -1, 1.5, 1), 0.5, 0.2)
    assert found is not None
    assert (found.area, found.width, found.length) == pytest.approx((2 * 1.6, 1.6, 2.0))
    assert effective_area(box(-1, -1, 1, 1), 1.1, 0.0) is None


def test_an_opening_takes_off_itself_and_its_image() -> None:
    """Of 4 m x 2 m with the resultant at x = 2.4 m the part 1.6 m wide either way counts, 6.4 m2.

    An opening of 0.2 m x 0.5 m next to it takes off 0.1 m2 and as much opposite, one beyond the part nothing.
    """
    base = box(0, 0, 4, 2).difference(box(2.5, 0.5, 2.7, 1.0)).difference(box(0.1, 1.0, 0.3, 1.5))
    found = effective_area(base, 2.4, 1.0)
    assert found is not None
    assert (found.area, found.openings) == pytest.approx((6.4 - 2 * 0.1, 0.2))
    strength = SoilStrength(phi=30.0, unit_weight=18e3)
    known = follow_steps(bearing_steps(strength, found, soil(), 1e6, 0.0))
    assert (known["A_f"], known["A_o"], known["A'"]) == pytest.approx((6.4, 0.2, 6.2))
    whole = effective_area(box(0, 0, 4, 2), 2.4, 1.0)
    assert whole is not None
    assert whole.openings == 0


def test_the_effective_area_of_a_circle() -> None:
    """The lens of two circles, 2 e apart: R^2 (pi - 2 asin(e / R)) - 2 e sqrt(R^2 - e^2)."""
    R, e = 2.0, 0.5
    circle = Polygon([(R * math.cos(a * math.pi / 180), R * math.sin(a * math.pi / 180)) for a in range(360)])
    found = effective_area(circle, e, 0.0)
    assert found is not None
    assert found.area == pytest.approx(
        R**2 * (math.pi - 2 * math.asin(e / R)) - 2 * e * math.sqrt(R**2 - e**2), rel=1e-3
    )


def test_drained_resistance_by_hand() -> None:
    """Phi 30: N_q 18.401, N_gamma 20.093, on 2 m x 4 m: q N_q s_q + 0.5 gamma B N_gamma s_gamma."""
    base = effective_area(box(0, 0, 4, 2), 2.0, 1.0)
    assert base is not None
    by_hand = 8 * (9e3 * 18.401 * 1.25 + 0.5 * 18e3 * 2 * 20.093 * 0.85)
    assert bearing_resistance(base, soil(), 1e6, 0.0) == pytest.approx(by_hand, rel=1e-4)
    # with cohesion, and N_c 30.140 with s_c (1.25 x 18.401 - 1) / 17.401
    with_c = by_hand + 8 * 10e3 * 30.140 * (1.25 * 18.401 - 1) / 17.401
    assert bearing_resistance(base, soil(c=10e3), 1e6, 0.0) == pytest.approx(with_c, rel=1e-4)


def test_a_horizontal_force_takes_resistance_away_until_the_base_slides() -> None:
    """It falls with H, and nothing is left where H reaches V."""
    base = effective_area(box(0, 0, 4, 2), 2.0, 1.0)
    assert base is not None
    falling = [bearing_resistance(base, soil(), 1e6, H) for H in (0.0, 1e5, 3e5, 9.9e5, 1e6)]
    assert falling == sorted(falling, reverse=True)
    assert falling[-1] == 0.0


def test_undrained_resistance_by_hand() -> None:
    """(pi + 2) c_u (1 + 0.2 B / L) + q; half of the first where H is A' c_u; none beyond."""
    base = effective_area(box(0, 0, 4, 2), 2.0, 1.0)
    assert base is not None
    clay = soil(c_u=50e3)
    shear = 8 * (math.pi + 2) * 50e3 * 1.1
    assert bearing_resistance(base, clay, 1e6, 0.0) == pytest.approx(shear + 8 * 9e3)
    assert bearing_resistance(base, clay, 1e6, 8 * 50e3) == pytest.approx(shear / 2 + 8 * 9e3)
    assert bearing_resistance(base, clay, 1e6, 8 * 51e3) == 0.0
    assert sliding_resistance(base, 50e3, 0.0, 1e6) == pytest.approx(400e3)
    assert sliding_resistance(base, None, math.radians(30), 1e6) == pytest.approx(1e6 / math.sqrt(3))


def test_a_pad_with_a_horizontal_force_is_checked_for_both() -> None:
    """The resultant is where moment and force put it; the check names demand, resistance, clause and combination."""
    pad = gs.Model(
        plate=gs.Plate(length_x=3, length_y=2, thickness=0.5, E=33e9, nu=0.2),
        ground=gs.Winkler(k=50e6),
        cases=[gs.LoadCase(name="G"), gs.LoadCase(name="wind", action="variable", H_x=60e3)],
        loads=[
            gs.PointLoad(P=600e3, x=0, y=0, width_x=0.4, width_y=0.4, case="G"),
            gs.PointLoad(P=0, M_x=120e3, x=0, y=0, width_x=0.4, width_y=0.4, case="wind"),
        ],
        combinations=[gs.Combination(name="ULS", factors={"G": 1.0, "wind": 1.5})],
        soil_strength=gs.SoilStrength(phi=30, unit_weight=18e3, overburden=9e3),
        mesh=gs.Mesh(size=0.25),
    )
    found = {check.name: check for check in check_design(gs.solve(pad)).checks}
    bearing, sliding = found["bearing resistance"], found["sliding"]
    base = effective_area(box(-1.5, -1, 1.5, 1), 180 / 600, 0.0)
    assert base is not None
    assert bearing.demand == pytest.approx(600)
    assert bearing.resistance == pytest.approx(bearing_resistance(base, soil(), 600e3, 90e3) / 1.4e3, rel=1e-6)
    assert bearing.place == pytest.approx((0.3, 0.0), abs=1e-9)
    assert (sliding.demand, sliding.resistance) == pytest.approx((90, 600 * math.tan(math.radians(30)) / 1.1))
    assert bearing.combination == sliding.combination == "ULS"


def test_sliding_without_the_soils_strength_is_not_passed_over() -> None:
    """1.5 x 60 kN act, and nothing is known of what resists: not judged; without a horizontal force there is no row."""

    def checked(H_x: float) -> list[tuple[str, str]]:
        pad = gs.Model(
            plate=gs.Plate(length_x=3, length_y=2, thickness=0.5, E=33e9, nu=0.2),
            ground=gs.Winkler(k=50e6),
            cases=[gs.LoadCase(name="W", action="variable", H_x=H_x)],
            loads=[gs.UniformLoad(q=30e3, case="W")],
            combinations=[gs.Combination(name="ULS", factors={"W": 1.5})],
            mesh=gs.Mesh(size=1.0),
        )
        return [(check.status, check.words) for check in check_design(gs.solve(pad)).checks]

    words = 'not judged: 90 kN act horizontally in "ULS", and the case has no [soil_strength]; give it in the case'
    assert checked(60e3) == [("attention", words)]
    assert not checked(0.0)


@pytest.mark.parametrize("tensionless", [True, False])
@pytest.mark.parametrize(("water", "moment"), [(0.0, 480e3), (80e3, 48e3), (120e3, 0.0)])
def test_glue_hides_no_sliding(water: float, moment: float, *, tensionless: bool) -> None:
    """R = V tan 30 / 1.1 of what actions leave, 600 kN less 6 m2 of water, also where glued ground pulls: e = 1.2 m.

    90 kN slide where 120 kN are left, R = 63 kN, and nothing resists where the water lifts more than there is.
    """
    V = 600 - 6 * water / 1e3
    if tensionless and V < 0:
        pytest.skip("nothing balances it")
    pad = gs.Model(
        plate=gs.Plate(length_x=3, length_y=2, thickness=0.5, E=33e9, nu=0.2),
        ground=gs.Winkler(k=50e6),
        contact=gs.Contact(tensionless=tensionless),
        cases=[gs.LoadCase(name="G"), gs.LoadCase(name="wind", action="variable", H_x=60e3)],
        loads=[
            gs.PointLoad(P=600e3, x=0, y=0, width_x=0.4, width_y=0.4, case="G"),
            gs.UniformLoad(q=-water, case="G"),
            gs.PointLoad(P=0, M_x=moment, x=0, y=0, width_x=0.4, width_y=0.4, case="wind"),
        ],
        combinations=[gs.Combination(name="ULS", factors={"G": 1.0, "wind": 1.5})],
        soil_strength=gs.SoilStrength(phi=30, unit_weight=18e3, overburden=9e3),
        mesh=gs.Mesh(size=0.25),
    )
    (sliding,) = (check for check in check_design(gs.solve(pad)).checks if check.name == "sliding")
    R = max(V, 0.0) * math.tan(math.radians(30)) / 1.1
    assert (sliding.demand, sliding.resistance) == pytest.approx((90, R), rel=1e-6)
    assert sliding.status == ("fails" if R < 90 else "no failure found")
    assert sliding.foundation


@pytest.mark.parametrize(
    ("given", "where"),
    [
        ({}, "soil_strength.phi"),
        ({"phi": 30, "c_u": 50e3}, "soil_strength.phi"),
        ({"c_u": 50e3, "c": 5e3}, "soil_strength.c"),
        ({"phi": 30, "delta": 35}, "soil_strength.delta"),
    ],
)
def test_a_strength_that_is_none_is_refused(given: dict[str, float], where: str) -> None:
    """Drained or undrained, not both; friction under the base at most that of the soil."""
    with pytest.raises(gs.InputError) as refused:
        gs.SoilStrength(unit_weight=18e3, **given)
    assert where.rpartition(".")[2] in str(refused.value)


SOIL_ONLY = """
[plate]
length_x = "4 m"
length_y = "3 m"
thickness = "1 m"
E = "30 GPa"
nu = 0.2
[ground]
kind = "winkler"
k = "50 MPa/m"
[[cases]]
name = "a"
[[combinations]]
name = "U"
limit_state = "LIMIT STATE"
factors = {a = 1.0}
[soil_strength]
phi = 30
unit_weight = "10 kN/m^3"
[[loads]]
kind = "point"
P = "3000 kN"
x = "0.1 m"
y = "0.1 m"
case = "a"
[mesh]
size = "0.5 m"
"""


def test_strength_of_the_soil_alone_has_a_table_of_checks() -> None:
    """A case whose only section of design is [soil_strength] has its checks in the tables, as on the terminal."""
    results = gs.solve(casefile.loads(SOIL_ONLY.replace("LIMIT STATE", "ultimate")))
    tables = {table.name: table for table in gs.tables_of(results)}
    assert tables["checks"]["check"] == tuple(each.name for each in check_design(results).checks)
    assert "bearing resistance" in tables["checks"]["check"]


def test_strength_of_the_soil_without_an_ultimate_combination_is_not_passed_over() -> None:
    """Without an ultimate combination the bearing resistance is not checked, which needs attention."""
    design = check_design(gs.solve(casefile.loads(SOIL_ONLY.replace("LIMIT STATE", "characteristic"))))
    assert [(each.name, each.status) for each in design.checks] == [("bearing resistance", "attention")]
    assert "no ultimate combination" in design.checks[0].words
