"""Checks of industrial floors: what stands together and where, each demand and resistance by hand."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.checks.one_way_shear import shear
from groundslab.design.codes.floors import yield_lines
from groundslab.design.codes.floors.acting_loads import Borders, forces, groups
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult, Results
from groundslab.views.tables.result_tables import tables_of
from helpers import synthetic
from helpers.calculations import follow_steps
from helpers.synthetic import LENGTH_X, LENGTH_Y

E, H, NU, K = 31e9, 0.2, 0.2, 50e6
L = (E * H**3 / (12 * (1 - NU**2) * K)) ** 0.25
LAM = (3 * K / (E * H**3)) ** 0.25
F_CTM = 0.30 * 30 ** (2 / 3) * 1e6
M_N = F_CTM * 1.4 / 1.5 * H**2 / 6
TR34 = {"kind": "TR34", "concrete": "C30/37"}
FIBERS = {**TR34, "f_R1": 2.5e6, "f_R4": 2e6}
M_P = H**2 / 1.5 * (0.29 * 0.37 * 2e6 + 0.16 * 0.45 * 2.5e6)
ACI = {"kind": "ACI 360", "f_r": 4e6, "safety_factor": 2.0}


def leg(x: float, y: float, P: float = 50e3, **keys: Any) -> dict[str, Any]:
    """Return the leg of a rack on a square plate of 0.1 m."""
    return {"kind": "point", "case": "Q", "P": P, "x": x, "y": y, "width_x": 0.1, "width_y": 0.1} | keys


def model_with(floor: dict[str, Any], loads: list[dict[str, Any]], **changes: Any) -> Model:
    """Return a floor of 9.6 m x 7.2 m x 0.2 m with one ultimate combination, and one of serviceability."""
    return Model(
        **{
            "plate": {"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": H, "E": E, "nu": NU},
            "ground": {"kind": "winkler", "k": K},
            "cases": [{"name": "Q", "action": "variable"}],
            "loads": loads,
            "combinations": [
                {"name": "ULS", "factors": {"Q": 1.5}},
                {"name": "SLS", "limit_state": "characteristic", "factors": {"Q": 1.0}},
            ],
            "floor": floor,
        }
        | changes
    )


def solved(model: Model, **moments: float) -> Results:
    """Return made-up results with even moments [N m/m]."""
    made = {}
    for each in model.combinations:
        one = synthetic.results(6, model=model, combination=each.name, limit_state=each.limit_state,
                                factors=each.factors)  # fmt: skip
        flat = np.zeros(len(one.plate.nodes))
        own = {name: flat + moments.get(name, 0.0) for name in ("moment_x", "moment_y", "moment_xy")}
        thickness = np.full_like(one.elements.thickness, H)
        made[each.name] = replace(
            one, plate=replace(one.plate, **own), elements=replace(one.elements, thickness=thickness)
        )
    return Results(model, model.combinations, made, {})


def checks(model: Model, **moments: float) -> dict[tuple[str, str], DesignCheck]:
    """Return the checks of the floor by name and what they are of."""
    return {(each.name, each.of): each for each in check_design(solved(model, **moments)).checks}


def ultimate(model: Model) -> CombinationResult:
    """Return the made-up results of the ultimate combination."""
    return solved(model)["ULS"]


def test_a_force_inside_against_the_yield_lines_by_hand() -> None:
    """75 kN on a circle as large as 0.1 m x 0.1 m, a / l = 0.077: between 2 pi and 4 pi (M_p + M_n) / (1 - a / 3 l)."""
    check = checks(model_with(FIBERS, [leg(0, 0)]))["point load", "internal"]
    ratio = math.sqrt(0.01 / math.pi) / L
    none, large = 2 * math.pi * (M_P + M_N), 4 * math.pi * (M_P + M_N) / (1 - 0.2 / 3)
    assert check.demand == pytest.approx(75.0)
    assert check.resistance == pytest.approx((none + ratio / 0.2 * (large - none)) / 1e3)
    assert check.combination == "ULS"
    assert check.place == pytest.approx((0.0, 0.0))


def test_plain_concrete_has_no_sagging_moment_and_a_mesh_its_own() -> None:
    """Inside the loads are as M_p + M_n: of 393 mm2/m at d = 0.15 m 0.95 x 393 x 435 x 0.15."""
    plain, mesh, fibers = (
        checks(model_with(floor, [leg(0, 0)]))["point load", "internal"].resistance
        for floor in (TR34, {**TR34, "mesh_area": 393e-6, "mesh_axis": 0.05}, FIBERS)
    )
    assert plain is not None
    assert mesh == pytest.approx(plain * (0.95 * 393e-6 * 500e6 / 1.15 * 0.15 + M_N) / M_N)
    assert fibers == pytest.approx(plain * (M_P + M_N) / M_N)


@pytest.mark.parametrize(
    ("x", "y", "location"),
    [(0, 0, "internal"), (LENGTH_X / 2 - 0.1, 0, "edge"), (LENGTH_X / 2 - 0.1, 3.5, "corner"), (0, -3.5, "edge")],
)
def test_where_a_force_stands_decides_how_it_fails(x: float, y: float, location: str) -> None:
    """Nearer than l + a to an edge or a corner, where joints carry 20 % over to the next bay."""
    check = checks(model_with({**FIBERS, "joint_transfer": 0.2}, [leg(x, y)]))["point load", location]
    slab = yield_lines.YieldSlab(L, M_P, M_N)
    wanted = yield_lines.single(slab, math.sqrt(0.01 / math.pi), location)  # type: ignore[arg-type]
    assert check.resistance == pytest.approx(wanted / 1e3)
    assert check.demand == pytest.approx(75.0 if location == "internal" else 60.0)


def test_an_opening_has_edges_over_which_nothing_is_carried() -> None:
    """A force beside an opening is at an edge, and all of it."""
    opening = {"kind": "rectangle", "x": (0.2, 1.2), "y": (-0.5, 0.5)}
    plate = {"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": H, "E": E, "nu": NU, "openings": [opening]}
    floor = {**FIBERS, "joint_transfer": 0.2}
    assert checks(model_with(floor, [leg(0, 0)], plate=plate))["point load", "edge"].demand == pytest.approx(75.0)


def test_forces_nearer_than_two_thicknesses_are_one() -> None:
    """Two legs 0.3 m apart act on 0.4 m x 0.1 m with twice the force, in the middle; at 0.41 m they are two."""
    result = ultimate(model_with(FIBERS, [leg(0, 0), leg(0.3, 0)]))
    (one,) = forces(result, Borders(result.model), H, L, 0.0)
    assert pytest.approx(150e3) == one.P
    assert one.a == pytest.approx(math.sqrt(0.04 / math.pi))
    assert one.place == pytest.approx((0.15, 0.0))
    apart = ultimate(model_with(FIBERS, [leg(0, 0), leg(0.41, 0)]))
    assert len(forces(apart, Borders(apart.model), H, L, 0.0)) == 2


def test_groups_of_two_and_four_by_hand() -> None:
    """Four legs 1 m x 1.4 m apart: two 1 m apart, and four with 2.4 m, (2 pi + 1.8 x 2.4 / l) for none and so on."""
    legs = [leg(x, y) for x in (0.0, 1.4) for y in (0.0, 1.0)]
    found = checks(model_with(FIBERS, legs))
    a = math.sqrt(0.01 / math.pi)

    def by_hand(distances: float) -> float:
        none = 2 * math.pi + 1.8 * distances / L
        large = 4 * math.pi / (1 - 0.2 / 3) + 1.8 * distances / (0.9 * L)
        return (none + a / L / 0.2 * (large - none)) * (M_P + M_N)

    assert found["dual point load", "internal"].demand == pytest.approx(150.0)
    assert found["dual point load", "internal"].resistance == pytest.approx(by_hand(1.0) / 1e3)
    assert found["quadruple point load", "internal"].demand == pytest.approx(300.0)
    assert found["quadruple point load", "internal"].resistance == pytest.approx(by_hand(2.4) / 1e3)
    assert found["quadruple point load", "internal"].place == pytest.approx((0.7, 0.5))


def test_forces_far_apart_fail_by_themselves() -> None:
    """Two legs 5 l apart bear together no more than each by itself."""
    found = checks(model_with(FIBERS, [leg(-2.5 * L, 0), leg(2.5 * L, 0)]))
    alone = found["point load", "internal"].resistance
    assert alone is not None
    assert found["dual point load", "internal"].resistance == pytest.approx(2 * alone)


def test_groups_are_all_rectangles_by_brute_force() -> None:
    """Of a turned raster of 3 x 4 forces the smallest rectangles and pairs are found once each."""
    turn = np.array([[math.cos(0.4), -math.sin(0.4)], [math.sin(0.4), math.cos(0.4)]])
    places = [turn @ (1.0 * i, 1.3 * j) for i in range(-1, 2) for j in range(-1, 3)]
    result = ultimate(model_with(FIBERS, [leg(*place) for place in places]))
    loads = forces(result, Borders(result.model), H, L, 0.0)
    found = [[round(distance, 6), len(members)] for members, distance in groups(loads, 1.4)]
    assert found.count([2.3, 4]) == 2 * 3
    assert found.count([1.0, 2]) == 2 * 4
    assert found.count([1.3, 2]) == 3 * 3


def test_punching_by_hand() -> None:
    """600 kN on 0.1 m x 0.1 m, d = 0.15 m: u_0 = 0.4 m, u_1 = 0.4 m + 4 pi d, less 20 MN/m3 x 28 mm on what is inside.

    C30/37: v_Rd,max = 0.4 x 0.528 x 20 MPa; without bars 0.035 x 2^(3/2) x 30^(1/2) = 0.542 MPa.
    """
    found = checks(model_with(FIBERS, [leg(0, 0, P=400e3)]))
    face, around = found["punching at the footprint", "internal"], found["punching", "internal"]
    assert face.demand == pytest.approx(600e3 / (0.4 * 0.15) / 1e6)
    assert face.resistance == pytest.approx(4.224)
    assert around.resistance == pytest.approx(0.5422, rel=1e-3)
    u, area = 0.4 + 4 * math.pi * 0.15, 0.01 + 0.4 * 0.3 + math.pi * 0.09
    pressure = solved(model_with(FIBERS, [leg(0, 0, P=400e3)]))["ULS"].plate.pressure.max()
    assert around.demand == pytest.approx((600e3 - pressure * area) / (u * 0.15) / 1e6, rel=0.01)
    mesh = checks(model_with({**TR34, "mesh_area": 1e-3, "mesh_axis": 0.04}, [leg(0, 0, P=400e3)]))[
        "punching", "internal"
    ]
    rho, k = 1e-3 / 0.16, 2.0
    assert mesh.resistance == pytest.approx(0.12 * k * (100 * rho * 30) ** (1 / 3))


def test_the_footprint_that_uses_most_punches_and_not_the_largest_force() -> None:
    """1.5 x 115 kN on 0.05 m x 0.05 m, 5.75 MPa, are worse than 1.5 x 120 kN on 1 m x 1 m; both sheets are its own."""
    wide, small = leg(-2, 0, P=120e3, width_x=1.0, width_y=1.0), leg(2, 0, P=115e3, width_x=0.05, width_y=0.05)
    both, alone = (checks(model_with(FIBERS, loads)) for loads in ([wide, small], [small]))
    for name in ("punching at the footprint", "punching"):
        found = both[name, "internal"]
        assert found.place == (2.0, 0.0)
        assert found.demand == pytest.approx(alone[name, "internal"].demand)
        assert follow_steps(found.steps)
    assert both["punching at the footprint", "internal"].demand == pytest.approx(1.5 * 115e3 / (0.2 * 0.15) / 1e6)
    assert both["punching at the footprint", "internal"].status == "fails"


def test_friction_that_takes_all_of_the_allowed_stress_leaves_nothing_for_pressures() -> None:
    """Mu gamma L / 2 = 1.5 x 25 kN/m3 x 120 m / 2 = 2.25 MPa of f_r / SF = 2 MPa: no pressure may stand there."""
    friction = {"friction": 1.5, "unit_weight": 25e3, "joint_spacing": 120.0}
    goods = {"kind": "patch", "case": "Q", "q": 30e3, "x": (-3, -1), "y": (-2, 2)}
    found = checks(model_with({**ACI, **friction}, [goods]))["pressure beside aisles", ""]
    assert (found.status, found.resistance, found.utilization) == ("fails", 0.0, math.inf)
    assert follow_steps(found.steps)["q_R"] == 0.0


def test_a_footprint_at_an_angle_punches_as_one_along_x_and_y() -> None:
    """A rectangle keeps its sides, perimeters and demand at any angle; a circle of its area would have others."""
    flat, askew = (
        checks(model_with(FIBERS, [leg(0, 0, P=400e3) | {"width_y": 0.3, "angle": angle}])) for angle in (0.0, 30.0)
    )
    for name, of in (("punching at the footprint", "internal"), ("punching", "internal")):
        assert askew[name, of].demand == pytest.approx(flat[name, of].demand, rel=1e-3)
        assert askew[name, of].resistance == pytest.approx(flat[name, of].resistance)


def test_one_way_shear_is_that_beyond_2_d_of_forces_whose_punching_is_checked() -> None:
    """Beside a leg the shear force of a floor by ACI 360 is one-way shear from d on; by TR34 it is punching up to 2 d.

    d = 0.2 m - 0.045 m = 0.155 m, the leg is 0.1 m wide: 0.205 m from its middle, and 2 d = 0.31 m from its face. A leg
    that does not act in the combination has no such part around it.
    """
    bars = {"concrete": "C30/37", "steel": "B500B", "bottom": (0.04, 0.05), "top": (0.04, 0.05)}
    cases = [{"name": "Q", "action": "variable"}, {"name": "R", "action": "variable"}]
    at = (1.6, 0.0)

    def place(floor: dict[str, Any], case: str) -> tuple[float, float]:
        loads = [leg(*at, case=case), leg(-3.2, 2.4)]
        model = model_with(floor, loads, cases=cases, reinforcement=bars)
        results = solved(model)["ULS"]
        peak = 1e3 / (0.1 + np.hypot(*(results.plate.nodes - at).T))
        none = dict.fromkeys(("shear_x", "shear_y"), 0 * results.elements.shear_x)
        plate = replace(results.plate, shear_x=peak, shear_y=0 * peak)
        peaked = replace(results, plate=plate, elements=replace(results.elements, **none))
        [found] = shear.checks(Results(model, model.combinations, {"ULS": peaked}, {}))
        assert found.place is not None
        return found.place

    assert math.dist(place(ACI, "Q"), at) == pytest.approx(0.205)
    assert place(TR34, "R") == pytest.approx(at)
    assert math.dist(place(TR34, "Q"), at) > 0.31


def test_line_loads_and_aisles_by_hand() -> None:
    """4 lambda M_n inside, 3 lambda M_n near an edge, 5.95 lambda^2 M_n beside an aisle; permanent goods stay."""
    line = {"kind": "line", "case": "Q", "q": 20e3, "points": [(-1, 0), (1, 0)]}
    goods = {"kind": "patch", "case": "Q", "q": 30e3, "x": (-3, -1), "y": (-2, 2)}
    everywhere = {"kind": "uniform", "case": "Q", "q": 10e3}
    found = checks(model_with(TR34, [line, goods, everywhere]))
    assert found["line load", ""].demand == pytest.approx(30.0)
    assert found["line load", ""].resistance == pytest.approx(4 * LAM * M_N / 1e3)
    assert found["pressure beside aisles", ""].demand == pytest.approx(60.0)
    assert found["pressure beside aisles", ""].resistance == pytest.approx(5.95 * LAM**2 * M_N / 1e3, rel=2e-3)
    at_edge = {**line, "points": [(-1, 3.5), (1, 3.5)]}
    assert checks(model_with(TR34, [at_edge]))["line load", ""].resistance == pytest.approx(3 * LAM * M_N / 1e3)
    permanent = model_with(TR34, [everywhere], cases=[{"name": "Q"}])
    assert ("pressure beside aisles", "") not in checks(permanent)


def test_stresses_by_aci_360_in_combinations_of_serviceability() -> None:
    """m_1 = 12 kNm/m makes 6 m / h^2 = 1.8 MPa below, m_2 = -4 kNm/m 0.6 MPa above, against 4 MPa over 2."""
    model = model_with(ACI, [leg(0, 0)])
    found = checks(model, moment_x=4e3, moment_y=4e3, moment_xy=8e3)
    for face, stress in (("bottom", 1.8), ("top", 0.6)):
        check = found["flexural stress", face]
        assert (check.demand, check.resistance) == pytest.approx((stress, 2.0))
        assert check.combination == "SLS"
    assert not any(name == "point load" for name, _ in found)


def test_friction_adds_to_stresses_and_repetitions_take_from_what_is_allowed() -> None:
    """0.5 x 24 kN/m3 x 15 m = 0.18 MPa; a stress that is repeated 124,523 times may have 0.55 f_r, 1e9 times 0.45."""
    floor = {**ACI, "safety_factor": 1.4, "friction": 0.5, "joint_spacing": 30.0, "repetitions": 124_523}
    found = checks(model_with(floor, [leg(0, 0)]), moment_x=12e3)
    assert found["flexural stress", "bottom"].demand == pytest.approx(1.98)
    assert found["flexural stress", "bottom"].resistance == pytest.approx(0.55 * 4, rel=1e-3)
    assert found["restraint of shrinkage", ""].demand == pytest.approx(0.18)
    often = checks(model_with({**floor, "repetitions": 10**9}, [leg(0, 0)]), moment_x=12e3)
    assert often["flexural stress", "bottom"].resistance == pytest.approx(0.45 * 4)


def test_fiber_concrete_by_aci_360_has_yield_lines() -> None:
    """6 (1 + 2 a / l) f_r (1 + R_e,3) h^2 / 6 over the factor of safety, against the force without partial factors."""
    check = checks(model_with({**ACI, "R_e3": 0.4}, [leg(0, 0)]))["point load", "internal"]
    a = math.sqrt(0.01 / math.pi)
    assert check.demand == pytest.approx(50.0)
    assert check.resistance == pytest.approx(6 * (1 + 2 * a / L) * 4e6 * 1.4 * H**2 / 6 / 2 / 1e3)


def test_a_continuum_has_an_equivalent_modulus_and_the_clauses_say_so() -> None:
    """Yield lines on a continuum take k = D / l^4 with T(1 / l) = l^4 / D; of springs nothing is said."""
    ground = {"kind": "continuum", "half_space": {"E": 40e6, "nu": 0.3}}
    loads = [leg(0.0, 0.0)]
    of_springs = checks(model_with(FIBERS, loads))["point load", "internal"]
    assert "equivalent" not in of_springs.words
    found = checks(model_with(FIBERS, loads, ground=ground))["point load", "internal"]
    D = E * H**3 / (12 * (1 - NU**2))
    # of a half-space T(k) = 2 (1 - nu^2) / (E k), so that l^3 = 2 (1 - nu^2) D / E
    length = (2 * (1 - 0.3**2) * D / 40e6) ** (1 / 3)
    assert f"k = {D / length**4 / 1e6:.3g} MPa/m equivalent to the continuum" in found.words


def test_what_joints_are_relied_on_for_is_told_as_not_checked() -> None:
    """Of 75 kN at an edge joints carry over 15 %, 11.25 kN; inside and without a share, nothing."""
    wide = {"width_x": 1.0, "width_y": 1.0}  # which the mesh resolves
    inside, edge = leg(0, 0, **wide), leg(0, LENGTH_Y / 2 - 0.55, **wide)
    relied = "anchorage is not checked; the transfer of up to 11.25 kN of a force across joints is not checked."
    bars = {"concrete": "C30/37", "steel": "B500B", "bottom": (0.04, 0.05), "top": (0.04, 0.05)}

    def headline(loads: list[dict[str, Any]], floor: dict[str, Any], **changes: Any) -> str:
        results = solved(model_with(floor, loads, **changes))
        calm = {}
        for name, each in results.results.items():
            zero = np.zeros(len(each.plate.nodes))
            calm[name] = replace(each, plate=replace(each.plate, shear_x=zero, shear_y=zero))
        return check_design(replace(results, results=calm)).headline

    assert headline([inside, edge], {**FIBERS, "joint_transfer": 0.15}, reinforcement=bars).endswith(relied)
    for floor in ({**FIBERS, "joint_transfer": 0.15}, {**ACI, "R_e3": 0.5, "joint_transfer": 0.15}):
        words = headline([inside, edge], floor)
        assert "[reinforcement]; the transfer of up to " in words
        assert "anchorage" not in words
        assert "joints" not in headline([inside], floor)
    assert "joints" not in headline([inside, edge], FIBERS)


def test_a_floor_that_fails_says_so_first() -> None:
    """A corner load of 75 kN on plain concrete."""
    design = check_design(solved(model_with(TR34, [leg(4.75, 3.55)])))
    assert design.status == "fails"
    assert design.headline.startswith("DESIGN FAILS: punching, 1.37 times its limit; 2 of 3")


@pytest.mark.parametrize(
    ("floor", "found"),
    [
        ({"kind": "TR34"}, "neither concrete nor f_ck"),
        ({**TR34, "f_R1": 2e6}, "nothing"),
        ({**FIBERS, "mesh_area": 4e-4, "mesh_axis": 0.05}, "a mesh together with fibers"),
        ({**TR34, "mesh_area": 4e-4, "mesh_axis": 0.15}, "0.15 m"),
        ({**ACI, "friction": 0.5}, "nothing"),
        ({**ACI, "joint_transfer": 0.2}, "none without R_e3"),
        ({**TR34, "unit_weight": 25e3}, "no weight without friction"),
        ({**FIBERS, "f_yk": 460e6}, "no f_yk without a mesh"),
    ],
)
def test_faults_of_a_floor_are_told(floor: dict[str, Any], found: str) -> None:
    """Keys that need each other, that exclude each other, and a mesh in the upper half."""
    with pytest.raises(InputError, match=found):
        model_with(floor, [leg(0, 0)])


def test_a_mesh_has_to_lie_in_the_thinnest_zone() -> None:
    """40 mm from the top is below the middle of a zone of 60 mm."""
    zone = {"shape": {"kind": "rectangle", "x": (0, 1), "y": (0, 1)}, "thickness": 0.06}
    plate = {"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": H, "E": E, "nu": NU, "zones": [zone]}
    with pytest.raises(InputError, match=r"less than half of the thickness, 0\.03 m"):
        model_with({**TR34, "mesh_area": 4e-4, "mesh_axis": 0.04}, [leg(0, 0)], plate=plate)


def test_tr34_needs_an_ultimate_combination() -> None:
    """Yield lines are a state of failure."""
    given = {"name": "SLS", "limit_state": "characteristic", "factors": {"Q": 1.0}}
    with pytest.raises(InputError, match="no ultimate combination of loads"):
        model_with(TR34, [leg(0, 0)], combinations=[given])


def bays(floor: dict[str, Any], loads: list[dict[str, Any]]) -> Results:
    """Return a floor of two bays, 6 m x 6 m x 0.2 m and 6 m x 6 m x 0.3 m, joined by a hinge along x = 3 m."""
    second = {"kind": "rectangle", "x": (3.0, 9.0), "y": (-3.0, 3.0)}
    return solve(
        model_with(
            floor,
            loads,
            plate={"name": "A", "length_x": 6.0, "length_y": 6.0, "thickness": H, "E": E, "nu": NU},
            plates=[{"name": "B", "outline": second, "thickness": 0.3, "E": E, "nu": NU}],
            joints=[{"kind": "hinge", "between": ("A", "B")}],
            mesh={"size": 1.0},
        )
    )


def test_each_bay_of_several_has_its_own_checks() -> None:
    """A force at the joint is at the edge of its bay; each bay resists with its own thickness, by hand; joints once."""
    floor = {**FIBERS, "joint_transfer": 0.2, "friction": 1.5, "joint_spacing": 6.0}
    loads = [leg(2.9, 0), leg(6, 0, P=40e3), {"kind": "uniform", "case": "Q", "q": 1e4, "plate": "A"}]
    results = bays(floor, loads)
    found = {(each.name, each.of): each for each in check_design(results).checks}
    a = math.sqrt(0.01 / math.pi)
    edge = yield_lines.single(yield_lines.YieldSlab(L, M_P, M_N), a, "edge")
    assert found["point load", "A, edge"].resistance == pytest.approx(edge / 1e3)
    assert found["point load", "A, edge"].demand == pytest.approx(0.8 * 75)
    assert found["point load", "A, edge"].words.startswith("A, edge: ")
    l = L * 1.5**0.75  # noqa: E741
    thick = yield_lines.YieldSlab(l, M_P * 2.25, M_N * 2.25 * (1.3 / 1.4))  # k_h = 1.6 - h, EN 1992-1-1 (3.23)
    assert found["point load", "B, internal"].resistance == pytest.approx(
        yield_lines.single(thick, a, "internal") / 1e3
    )
    assert found["point load", "B, internal"].demand == pytest.approx(60.0)
    assert ("point load", "A, internal") not in found
    assert ("pressure beside aisles", "A") in found
    assert ("pressure beside aisles", "B") not in found
    assert [of for name, of in found if name == "restraint of shrinkage"] == [""]
    assert check_design(results).headline.count("transfer of up to 15 kN of a force across joints") == 1
    (table,) = (each for each in tables_of(results) if each.name == "checks")
    assert "B, internal" in table["of"]


def test_stresses_of_each_bay() -> None:
    """By ACI 360R each bay has the largest stress of its own nodes, 6 m / h^2 with its own thickness."""
    results = bays(ACI, [leg(0, 0), leg(6, 0)])
    found = {(each.name, each.of): each for each in check_design(results).checks}
    stresses = {}
    for name in ("A", "B"):
        x, _ = found["flexural stress", f"{name}, bottom"].place or (0.0, 0.0)
        assert (x < 3) == (name == "A")
        stresses[name] = found["flexural stress", f"{name}, bottom"].demand
    assert stresses["A"] is not None
    assert stresses["B"] is not None
    assert 1 < stresses["A"] / stresses["B"] < 2.25  # moments grow with l, less than h^2


def test_a_pressure_over_a_joint_is_on_both_bays() -> None:
    """20 kPa over the joint counts in each bay, at a place in it."""
    patch = {"kind": "patch", "case": "Q", "q": 2e4, "x": (2.0, 4.0), "y": (-1.0, 1.0)}
    found = {
        each.of: each for each in check_design(bays(TR34, [patch])).checks if each.name == "pressure beside aisles"
    }
    assert {of: each.demand for of, each in found.items()} == pytest.approx({"A": 30.0, "B": 30.0})
    (x_A, _), (x_B, _) = (found[of].place or (0.0, 0.0) for of in ("A", "B"))
    assert 2 < x_A < 3 < x_B < 4


LINE = {"kind": "line", "case": "Q", "q": 20e3, "points": [(-1, 0), (1, 0)]}
AT_EDGE = {**LINE, "points": [(-1, 3.5), (1, 3.5)]}
GOODS = {"kind": "patch", "case": "Q", "q": 30e3, "x": (-3, -1), "y": (-2, 2)}
EVERYWHERE = {"kind": "uniform", "case": "Q", "q": 10e3}
TWINS = [leg(-3.0, 0.0), leg(-2.7, 0.0), leg(-3.0, 1.2)]
SQUARE = [leg(x, y) for x in (0.0, 1.4) for y in (0.0, 1.0)]
WIDE = [leg(3.0, 0, P=200e3) | {"width_x": 0.5, "width_y": 0.4}, leg(3.0, 1.5) | {"width_x": 0.6, "width_y": 0.6}]
EDGES = [leg(4.7, 0.5), leg(4.7, -0.4), leg(4.7, 3.5), leg(4.7, 2.8) | {"width_x": 0.14}]
SHEETS: dict[str, tuple[dict[str, Any], list[dict[str, Any]]]] = {
    "of fibers": (FIBERS | {"joint_transfer": 0.2}, [*TWINS, *SQUARE, *EDGES, LINE]),
    "with a mesh": (TR34 | {"mesh_area": 5e-4, "mesh_axis": 0.05}, [*WIDE, AT_EDGE, GOODS, EVERYWHERE]),
    "plain": (TR34 | {"friction": 0.5, "joint_spacing": 8.0}, [leg(0, 0), GOODS, {**GOODS, "x": (-2, 0)}]),
    "of strong concrete": ({"kind": "TR34", "f_ck": 60e6}, [leg(0, 3.4) | {"width_x": 0.3, "angle": 90.0}, EVERYWHERE]),
    "ACI": (ACI | {"friction": 0.5, "joint_spacing": 8.0}, [leg(0, 0), GOODS]),
    "ACI, often": (ACI | {"repetitions": 1e6, "R_e3": 0.4, "joint_transfer": 0.2}, [leg(4.7, 3.5), leg(0, 0), GOODS]),
    "ACI, a few times": (ACI | {"repetitions": 5e3, "safety_factor": 1.1}, [leg(4.7, 0), EVERYWHERE]),
}


@pytest.mark.parametrize("name", list(SHEETS))
def test_each_check_has_a_sheet_that_is_followed_by_hand(name: str) -> None:
    """Every check with a share used; its last step is that share, and each value follows from the numbers above it."""
    floor, loads = SHEETS[name]
    found = [
        check
        for check in check_design(solved(model_with(floor, loads), moment_x=9e3, moment_xy=-4e3)).checks
        if check.utilization is not None
    ]
    assert {"point load", "punching"} <= {check.name for check in found} or floor["kind"] == "ACI 360"
    for check in found:
        if check.name in ("equilibrium", "uplift"):
            continue
        values = follow_steps(check.steps)
        assert len(values) == len(check.steps)  # no symbol has two meanings
        assert list(values.values())[-1] == pytest.approx(check.utilization, rel=1e-9), check.name


def test_sheets_tell_which_forces_are_equal_and_where_they_stand() -> None:
    """Four equal forces are one kind; of two that differ each has its own symbols, and the smaller radius counts."""
    floor, loads = SHEETS["of fibers"]
    found = {
        (each.name, each.of): follow_steps(each.steps) for each in check_design(solved(model_with(floor, loads))).checks
    }
    four, two = found["quadruple point load", "internal"], found["dual point load", "corner"]
    assert (four["P"], four["P_s"], four["x"]) == pytest.approx((0.075, 0.3, 2.4))
    assert (two["n_1"], two["n_2"], two["x"]) == pytest.approx((1, 1, 0.7))
    assert two["P_0"] == pytest.approx(two["P_u,1"] + two["P_u,2"])
    assert two["a"] == pytest.approx(min(two["a_1"], two["a_2"])) == pytest.approx(math.sqrt(0.01 / math.pi))
    assert two["P_s"] == pytest.approx(2 * 0.8 * 0.075)
    assert two["e"] == pytest.approx(math.hypot(0.1, 0.1))
    assert two["e"] < two["e_lim"]
    alone = found["point load", "internal"]
    assert alone["F_1"] == pytest.approx(0.1)  # of the twins, which are less than two thicknesses apart
    assert alone["A"] == pytest.approx(0.4 * 0.1)
    assert alone["e"] > alone["e_lim"]
