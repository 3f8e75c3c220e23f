"""Patterns of loads: where they stand, what their combinations are called, and what is refused."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from shapely import box
from shapely.affinity import rotate, translate

from groundslab.case.casefile import loads, to_toml
from groundslab.errors import InputError
from groundslab.model.combinations import list_combinations, place_patterns
from groundslab.model.loads.load_types import PointLoad
from groundslab.model.loads.patterns import Move, Rack, Station, Vehicle, absent_forces, point_loads, stations
from groundslab.model.model import Model

WHEEL = {"P": "20 kN", "x": "1 m", "y": "0.5 m", "width_x": "0.3 m", "width_y": "0.2 m"}
VEHICLE: dict[str, Any] = {"kind": "vehicle", "name": "truck", "wheels": [WHEEL, {"P": "5 kN"}]}
RACK: dict[str, Any] = {"kind": "rack", "name": "rack", "P": "60 kN", "frames": 3, "rows": ["0 m", "1.1 m"]}
PATH: dict[str, Any] = {"pattern": "truck", "case": "live", "points": [["-2 m", "0 m"], ["2 m", "0 m"]], "step": "1 m"}
PLACE: dict[str, Any] = {"pattern": "rack", "case": "live", "points": [["-2 m", "-1 m"]]}


def described(**parts: Any) -> dict[str, Any]:
    """Return what a file of a slab of 8 m x 6 m with a truck on a path holds, with changes."""
    return {
        "plate": {"length_x": "8 m", "length_y": "6 m", "thickness": "0.2 m", "E": "30 GPa", "nu": 0.2},
        "ground": {"kind": "winkler", "k": "50 MPa/m"},
        "cases": [{"name": "G"}, {"name": "live", "action": "variable"}],
        "loads": [{"kind": "self weight", "case": "G", "unit_weight": "25 kN/m^3"}],
        "patterns": [VEHICLE, RACK],
        "moves": [PATH],
        **parts,
    }


def read(**parts: Any) -> Model:
    """Return the model of such a file."""
    return Model.model_validate(described(**parts), from_file=True)


def test_positions_are_at_each_step_and_at_the_end() -> None:
    """Along a path with a corner, 3 m and then 2.5 m, by hand; the direction is that of the piece that follows."""
    move = Move(pattern="truck", case="live", points=[(0, 0), (3, 0), (3, 2.5)], step=1.5)
    found = stations(move)
    assert [each.distance for each in found] == [0.0, 1.5, 3.0, 4.5, 5.5]
    assert [each.origin for each in found] == [(0, 0), (1.5, 0), (3, 0), (3, 1.5), (3, 2.5)]
    assert [round(math.degrees(each.angle)) for each in found] == [0, 0, 90, 90, 90]


def test_a_remainder_that_nobody_sees_is_no_position_of_its_own() -> None:
    """A path of 2.004 m in steps of 1 m ends with its third position, told apart from the others by its name."""
    found = stations(Move(pattern="truck", case="live", points=[(0, 0), (2.004, 0)], step=1.0))
    assert [each.distance for each in found] == [0.0, 1.0, 2.004]


def test_forces_turn_with_the_direction() -> None:
    """A wheel 1 m ahead and 0.5 m to the left, of a vehicle that drives towards +y: by hand."""
    vehicle = Vehicle.model_validate(VEHICLE, from_file=True)
    ahead, own = point_loads(vehicle, Station(0.0, (10.0, 20.0), math.pi / 2), "live")
    assert (ahead.x, ahead.y) == pytest.approx((9.5, 21.0))
    assert (ahead.width_x, ahead.width_y) == (0.2, 0.3)
    assert (own.x, own.y, own.width_x) == (10.0, 20.0, None)


@pytest.mark.parametrize("degrees", [0.0, 30.0, 90.0, 135.0, -20.0, 180.0, 215.0, 270.0])
def test_footprints_turn_with_the_direction(degrees: float) -> None:
    """A wheel of 0.3 m x 0.2 m at (1 m, 0.5 m) covers what shapely makes of it by a rotation about the origin."""
    vehicle = Vehicle.model_validate(VEHICLE, from_file=True)
    wheel, _ = point_loads(vehicle, Station(0.0, (10.0, 20.0), math.radians(degrees)), "live")
    expected = translate(rotate(box(0.85, 0.4, 1.15, 0.6), degrees, origin=(0, 0)), 10.0, 20.0)
    assert wheel.to_shapely(1e-3).symmetric_difference(expected).area < 1e-12
    assert -90 <= wheel.angle <= 90


def test_a_path_at_an_angle_turns_footprints() -> None:
    """A truck on a path along (3, 4), at both ends: places and angle by hand."""
    path = {**PATH, "points": [["-0.9 m", "-1.2 m"], ["0.9 m", "1.2 m"]], "step": "3 m"}
    placed = [load for load in place_patterns(read(moves=[path])).loads if isinstance(load, PointLoad)]
    wheels = [(load.x, load.y, load.width_x, load.width_y, load.angle) for load in placed if load.P == 20e3]
    angle = math.degrees(math.asin(0.8))
    assert np.array(wheels) == pytest.approx(np.array([(-0.7, -0.1, 0.3, 0.2, angle), (1.1, 2.3, 0.3, 0.2, angle)]))


def test_a_rack_has_its_legs_frame_by_frame() -> None:
    """Three frames 2.7 m apart with two legs each, turned by a right angle."""
    rack = Rack.model_validate(RACK, from_file=True)
    legs = point_loads(rack, Station(0, (0, 0), math.pi / 2), "live")
    found = [(round(leg.x, 9), round(leg.y, 9)) for leg in legs]
    assert found == [(0, 0), (-1.1, 0), (0, 2.7), (-1.1, 2.7), (0, 5.4), (-1.1, 5.4)]


def test_combinations_are_named_by_their_positions() -> None:
    """Each with the moving case is there at each position, each without it once; the file comes back as it was."""
    model = read(
        combinations=[
            {"name": "ULS live", "factors": {"G": 1.35, "live": 1.5}},
            {"name": "dead", "limit_state": "characteristic", "factors": {"G": 1.0}},
        ]
    )
    found = {each.name: dict(each.factors) for each in list_combinations(model)}
    assert list(found) == [*(f"ULS live, live at {way:.2f} m" for way in range(5)), "dead"]
    assert found["ULS live, live at 3.00 m"] == {"G": 1.35, "live at 3.00 m": 1.5}
    assert loads(to_toml(model)) == model
    assert list_combinations(place_patterns(model)) == list_combinations(model)
    assert loads(to_toml(place_patterns(model))) == place_patterns(model)


def test_each_case_by_itself_is_called_by_its_position() -> None:
    """Where nothing is combined the position says it all."""
    assert [each.name for each in list_combinations(read())][:2] == ["G", "live at 0.00 m"]


def test_what_stands_in_a_case_that_moves_is_there_at_every_position() -> None:
    """A rack at a fixed place and a load of the case beside the vehicle keep the case; its horizontal force, too."""
    load = {"kind": "point", "P": "1 kN", "case": "live", "x": "0 m", "y": "2 m"}
    cases = [{"name": "G"}, {"name": "live", "H_x": "3 kN"}]
    model = read(loads=[*described()["loads"], load], moves=[PATH, PLACE], cases=cases)
    placed = place_patterns(model)
    positions = [f"live at {way:.2f} m" for way in range(5)]
    assert [case.name for case in placed.cases] == ["G", "live", *positions]
    assert [case.H_x for case in placed.cases] == [0, 3e3, *[0] * 5]
    for case in placed.cases[1:]:
        forces = [each.P for each in placed.loads if isinstance(each, PointLoad) and each.case == case.name]
        assert sorted(forces) == ([1e3, *[60e3] * 6] if case.name == "live" else [5e3, 20e3])
    assert dict(list_combinations(model)[2].factors) == {"live": 1.0, positions[1]: 1.0}
    alone = place_patterns(read(cases=cases))
    assert [case.H_x for case in alone.cases] == [0, *[3e3] * 5]


def test_a_case_moves_along_one_of_its_paths_at_a_time() -> None:
    """Two paths of one case are alternatives; two cases that move are at all pairs of positions."""
    other = {**PATH, "name": "north", "points": [["-2 m", "2 m"], ["0 m", "2 m"]]}
    assert len(list_combinations(read(moves=[PATH, other]))) == 1 + 5 + 3
    cases = [{"name": "G"}, {"name": "live"}, {"name": "second"}]
    mix = [{"name": "both", "factors": {"live": 1.0, "second": 1.0}}]
    both = read(cases=cases, moves=[PATH, {**other, "name": "", "case": "second"}], combinations=mix)
    names = [each.name for each in list_combinations(both)]
    assert len(names) == 5 * 3
    assert names[0] == "both, live at 0.00 m, second at 0.00 m"


def test_forces_beside_the_plate_do_not_act_on_a_path() -> None:
    """At the right edge the wheel ahead has left the plate, which is told."""
    model = read(moves=[{**PATH, "points": [["0 m", "0 m"], ["4 m", "0 m"]]}])
    last = [load for load in place_patterns(model).loads if load.case == "live at 4.00 m"]
    assert [load.P for load in last] == [5e3]
    remark = "moves[1]: up to 1 of 2 forces are off the plate at 2 of 5 positions"
    assert list(absent_forces(model.plate, model.patterns, model.moves)) == [(0, remark)]


FAULTS: list[tuple[dict[str, Any], str, str]] = [
    ({"moves": [{**PATH, "pattern": "trck"}]}, "moves[1].pattern", '"trck"'),
    ({"moves": [{**PATH, "case": "live 2"}]}, "moves[1].case", '"live 2"'),
    ({"moves": [{**PATH, "step": None}]}, "moves[1].step", "nothing"),
    ({"moves": [{**PLACE, "step": "1 m"}]}, "moves[1].step", "1.0 m"),
    ({"moves": [{**PLACE, "points": [["0 m", "0 m"]]}]}, "moves[1].points", "2 of 6 forces off the plate at its place"),
    ({"moves": [{**PATH, "points": [["-2 m", "0 m"], ["9 m", "0 m"]]}]}, "moves[1].points",
     "2 of 2 forces off the plate at 7.00 m of the path"),
    ({"moves": [PATH, PATH]}, "moves[1].name", 'several paths of "live"'),
    ({"moves": [{**PATH, "points": [["0 m", "0 m"], ["0 m", "0 m"]]}]}, "moves[1].points[2]", "(0.0, 0.0) m twice"),
    ({"patterns": [VEHICLE, VEHICLE]}, "patterns[2].name", '"truck" again'),
    ({"patterns": [{**VEHICLE, "wheels": []}, RACK]}, "patterns[1].wheels", "an empty list"),
    ({"moves": [{**PATH, "points": [["-2 m", "0 m"], ["2 m", "0 m"], ["-2 m", "0 m"]] , "step": "0.01 m"}]},
     "moves[1].step", "0.01 m"),
]  # fmt: skip


@pytest.mark.parametrize(("parts", "where", "found"), FAULTS)
def test_faults_are_told_where_they_are(parts: dict[str, Any], where: str, found: str) -> None:
    """Each is an issue at its place."""
    given = described(**parts)
    given["moves"] = [{key: value for key, value in move.items() if value is not None} for move in given["moves"]]
    with pytest.raises(InputError) as error:
        Model.model_validate(given, from_file=True)
    told = {issue.location: issue.found for issue in error.value.issues}
    assert where in told
    assert found in told[where]


def test_positions_times_combinations_are_bounded() -> None:
    """41 positions in 13 combinations are more than 500, and so is a path with too many positions alone."""
    mixes = [{"name": f"K{n}", "factors": {"live": 1.0 + n / 10}} for n in range(13)]
    with pytest.raises(InputError, match="533 combinations at all positions") as error:
        read(moves=[{**PATH, "step": "0.1 m"}], combinations=mixes)
    assert error.value.issues[0].location == "moves"
    there_and_back = [["-2 m", "0 m"], ["2 m", "0 m"]] * 10
    with pytest.raises(InputError, match="a path with more positions than that"):
        read(moves=[{**PATH, "points": there_and_back, "step": "0.1 m"}])


def test_forces_times_positions_are_bounded() -> None:
    """200 frames with five legs at 401 positions are 401,000 forces, refused before any of them is made."""
    train = {**RACK, "frames": 200, "bay": "10 mm", "rows": [f"{n / 10} m" for n in range(5)]}
    long = {**PATH, "pattern": "rack", "points": [["-2 m", "0 m"], ["2 m", "0 m"]] * 5, "step": "0.09 m"}
    with pytest.raises(InputError, match="forces at all positions"):
        read(patterns=[train], moves=[long])


def test_a_path_needs_a_case() -> None:
    """Without cases all loads act together, and nothing can be at one position after the other."""
    given = described(loads=[{"kind": "uniform", "q": "1 kPa"}], moves=[{**PATH, "case": ""}], cases=[])
    with pytest.raises(InputError, match="a path without a case"):
        Model.model_validate(given, from_file=True)
    fixed = described(loads=[{"kind": "uniform", "q": "1 kPa"}], moves=[{**PLACE, "case": ""}], cases=[])
    placed = place_patterns(Model.model_validate(fixed, from_file=True))
    assert sum(isinstance(load, PointLoad) for load in placed.loads) == 6
