"""Walls of pits, bars and perimeters at their steps, by closed formulas and by hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from shapely import box

from groundslab import Model, Results
from groundslab.design.bars.bar_layout import bar_sets
from groundslab.design.bars.pit_walls import pit_wall_needs
from groundslab.design.checks import check_design
from groundslab.design.checks.anchorage import _to_ends
from groundslab.design.demands.by_plate import nodes_at, plate_under
from groundslab.design.demands.perimeters import Openings, RectangularColumn, perimeter
from groundslab.design.demands.support_moments import _parts
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.model.design.laid_bars import mean_area
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.plates.region import PlateRegion
from helpers.calculations import follow_steps
from helpers.solve_once import solve_once

STEEL = {"concrete": "C30/37", "steel": "B500B", "bottom": (0.05, 0.06), "top": (0.05, 0.06)}
BARS = {"diameter": 0.012, "spacing": 0.2}
LAID = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), BARS)
ULS = [{"name": "ULS", "factors": {"G": 1.0}, "limit_state": "ultimate"}]
q, a, b, nu = 20e3, 4.0, 1.5, 0.2


def disc(**zone: Any) -> Model:
    """Return a disc of 8 m on a soft support all around with a round pit of 3 m, as thick, on next to no ground."""
    pit = {"shape": {"kind": "circle", "radius": b}, "level": -1.0, "wall": 0.25} | zone
    return Model.model_validate(
        {
            "plate": {"outline": {"kind": "circle", "radius": a}, "thickness": 0.4, "E": 30e9, "nu": nu,
                      "support": "soft", "zones": [pit]},
            "ground": {"kind": "winkler", "k": 1.0},
            "cases": [{"name": "G"}],
            "loads": [{"kind": "uniform", "q": q, "case": "G"}],
            "combinations": ULS,
            "reinforcement": STEEL,
            "mesh": {"size": 0.5},
        }
    )  # fmt: skip


def test_what_a_round_pit_hands_over_is_the_moment_of_a_disc() -> None:
    """Its walls bend with m_r = q (3 + nu) (a^2 - b^2) / 16, and its floor hangs on them with q b / 2.

    Moments of a plate on a simple support (Timoshenko and Woinowsky-Krieger 1959, section 16) are also those of a thick
    one: by symmetry shear does not change them. d = 250 - 60 mm; bars by z = d - a / 2 of the stress block.
    """
    (need,) = pit_wall_needs(solve_once(disc()), Model.model_validate(disc()).reinforcement)  # type: ignore[arg-type]
    m_r, d = q * (3 + nu) * (a**2 - b**2) / 16, 0.19
    assert need.moment == pytest.approx(m_r, rel=0.02)
    assert abs(need.twist) < 0.02 * m_r
    assert need.pull == pytest.approx(q * b / 2, rel=0.1)
    assert need.d == pytest.approx(d)
    m_Ed = m_r + q * b / 2 * d / 2
    assert need.design_moment == pytest.approx(m_Ed, rel=0.03)
    f_cd, f_yd = 0.85 * 30e6 / 1.5, 500e6 / 1.15
    depth = d - np.sqrt(d**2 - 2 * need.design_moment / f_cd)
    assert need.area == pytest.approx(depth * f_cd / f_yd, rel=0.01)


@pytest.mark.parametrize("code", ["EN 1992-1-1", "EN 1992-1-1:2023", "ACI 318"])
def test_the_calculation_can_be_followed(code: str) -> None:
    """From the moment that is handed over to the bars, by each code; the last one is what the check says."""
    steel = STEEL | {"code": code}
    if code == "ACI 318":
        steel = {key: value for key, value in steel.items() if key not in ("concrete", "steel")}
        steel |= {"f_ck": 30e6, "f_yk": 420e6}
    model = disc().replace(reinforcement=steel)
    (check,) = [each for each in check_design(solve_once(model)).checks if each.name == "walls of pits"]
    known = follow_steps(check.steps)
    assert known["m"] == pytest.approx(known["m_Ed"])
    assert known["d"] == pytest.approx(0.25 - 0.06)
    assert f"{known['A_req']:.3g} cm2/m" in check.words


def test_walls_of_pits_are_never_green() -> None:
    """They need attention where they can be reinforced, and fail where their concrete is too weak or too thin."""
    checks = {check.name: check for check in check_design(solve_once(disc())).checks}
    assert checks["walls of pits"].status == "attention"
    assert "pressure of earth and water" in checks["walls of pits"].words
    thin = {check.name: check for check in check_design(solve_once(disc(wall=0.04))).checks}
    assert thin["walls of pits"].status == "fails"
    assert "thinner than their bars lie deep" in thin["walls of pits"].words
    assert "concrete is too weak" not in thin["walls of pits"].words
    assert check_design(solve_once(disc(wall=0.07))).status == "fails"


PIT = {"shape": {"kind": "rectangle", "x": (1, 3.5), "y": (-1, 2)}, "level": -1.2, "wall": 0.3}


def raft(**zone: Any) -> Model:
    """Return a raft of 12 m x 10 m with a pit and two columns, one 0.6 m beside it and one in it."""
    size = {"width_x": 0.4, "width_y": 0.4}
    zone = {key: value for key, value in (PIT | zone).items() if value is not None}
    return Model.model_validate(
        {
            "plate": {"length_x": 12, "length_y": 10, "thickness": 0.5, "E": 30e9, "nu": 0.2, "zones": [zone]},
            "ground": {"kind": "winkler", "k": 20e6},
            "columns": [{"name": "beside", "x": 0.2, "y": 0.5, **size}, {"name": "in it", "x": 2.2, "y": 0.5, **size}],
            "cases": [{"name": "G"}],
            "loads": [{"kind": "point", "column": name, "P": 5e5, "case": "G"} for name in ("beside", "in it")],
            "combinations": ULS,
            "reinforcement": STEEL | LAID,
            "mesh": {"size": 1.0},
        }
    )


@pytest.fixture(scope="module")
def solved() -> Results:
    """Return the results of the raft with a floor as thick as the raft."""
    return solve_once(raft())


def test_a_perimeter_beside_a_pit_ends_there_as_at_an_opening(solved: Results) -> None:
    """2 d = 0.86 m from a column of 0.4 m, what lies between tangents from its center to the pit does not count.

    They go to (1, -1) and (1, 2), 0.8 m away and 1.5 m to both sides, and meet the arcs around its corners at
    s = 1.1267 m from the center, 67.42 degrees up these arcs: of 1.6 m + 2 pi 0.86 m, 0.4 m and two such arcs go.
    """
    result = solved.results["ULS"]
    column = RectangularColumn(0.2, 0.5, 0.4, 0.4)
    u = perimeter(plate_under(result, 0.2, 0.5), column, 0.86, Openings(6 * 0.43)).u
    gone = 0.4 + 2 * 0.86 * np.radians(67.42)
    assert u == pytest.approx(1.6 + 2 * np.pi * 0.86 - gone, rel=1e-3)


def test_a_perimeter_in_a_pit_ends_at_its_walls(solved: Results) -> None:
    """At 0.5 m it goes around the column, at 1.2 m it lies on the floor only above and below the walls' borders."""
    floor = plate_under(solved.results["ULS"], 2.2, 0.5)
    column = RectangularColumn(2.2, 0.5, 0.4, 0.4)
    assert perimeter(floor, column, 0.5).u == pytest.approx(1.6 + np.pi, rel=1e-3)
    far = perimeter(floor, column, 1.2)
    x, y = far.legs.reshape(-1, 2).T
    assert (x.min(), x.max()) == pytest.approx((1.0, 3.5), abs=1e-9)
    assert y.min() >= -1.0
    assert y.max() <= 2.0


def test_bars_end_at_the_steps(solved: Results) -> None:
    """Along x, 12 m are 7 m to the pit, 2.5 m in it and 2.5 m beyond, over 3 m of its width; none is lost."""
    (base,) = [each for each in bar_sets(solved.model) if each.layer == "bottom_x" and not each.zone]
    assert sorted(set(base.lengths.round(9).tolist())) == pytest.approx([2.5, 7.0, 12.0])
    assert base.lengths.sum() == pytest.approx(50 * 12.0)
    cut = base.ends[base.lengths < 11][:, :, 1]
    assert cut.min() >= -1.0
    assert cut.max() <= 2.0


def test_means_across_columns_do_not_cross_a_step_of_the_level_alone(solved: Results) -> None:
    """The floor is as thick as the raft, and yet no line over which moments are averaged reads both."""
    plate = solved.results["ULS"].plate
    part = _parts(plate.elements, len(plate.nodes))
    x, y = plate.nodes[plate.elements[:, -1]].T
    inside = (x > 1) & (x < 3.5) & (y > -1) & (y < 2)
    of_element = part[plate.elements[:, 0]]
    assert not set(of_element[inside]) & set(of_element[~inside])


def test_a_thick_floor_of_a_pit_is_no_thicker_zone_of_the_raft() -> None:
    """A column in a pit of 0.8 m punches its floor; perimeters around the pit itself are none."""
    assert zone_forces(solve_once(raft(thickness=0.8))) == ()
    flat = raft(thickness=0.8, level=None, wall=None)
    assert len(zone_forces(solve_once(flat))) == 1


def test_bars_of_a_zone_end_at_the_step_for_their_anchorage(solved: Results) -> None:
    """A zone of bars from 1 m before the step to 1 m behind it: to its own end 0.4 m, to the step 0.6 m, an edge there.

    Nodes at the step stand once on either side, and bars of the other side are none of theirs.
    """
    result, region = solved.results["ULS"], box(0.0, 0.0, 2.0, 1.0)
    around, pit = PlateRegion(solved.model.plate).levels
    nodes = np.array([(0.4, 0.5), (1.0, 0.5), (1.0, 0.5), (1.6, 0.5)])
    for level, there, before, after in (
        (around, [True, True, False, False], [0.4, 1.0], [0.6, 0.0]),
        (pit, [False, False, True, True], [0.0, 0.6], [1.0, 0.4]),
    ):
        inside, low, high = _to_ends(level, region.intersection(level), "bottom_x", nodes, np.array(there))
        assert inside.tolist() == np.flatnonzero(there).tolist()
        assert low[0] == pytest.approx(before)
        assert high[0] == pytest.approx(after)
        at_edge = high[1] if level is around else low[1]
        assert at_edge.all()
    both = [nodes_at(result, level) for level in (around, pit)]
    assert (both[0] ^ both[1]).all()


def test_bars_in_a_pit_do_not_count_for_punching_beside_it() -> None:
    """Further bars of the floor alone leave the column beside it with those all over; one in the pit has both."""
    steel = Reinforcement.model_validate(
        STEEL | LAID | {"zones": [{"name": "floor", "layers": ["bottom_y"], **BARS, "shape": PIT["shape"]}]}
    )
    plate, one = raft().plate, np.pi / 4 * 0.012**2 / 0.2
    beside, in_it = raft().columns
    assert mean_area(plate, steel, "bottom_y", beside, 0.43) == pytest.approx(one)
    assert mean_area(plate, steel, "bottom_y", in_it, 0.33) == pytest.approx(2 * one)


def test_a_column_on_a_wall_is_not_judged() -> None:
    """No perimeter lies at one level there: the check says so, and is not green."""
    model = raft()
    moved = tuple(column.model_copy(update={"x": 1.0}) for column in model.columns[:1])
    moved = model.model_copy(update={"columns": (*moved, *model.columns[1:])})
    checks = [check for check in check_design(solve_once(moved)).checks if "without a perimeter" in check.name]
    assert [check.status for check in checks] == ["attention"]
    assert "on one level" in checks[0].words
