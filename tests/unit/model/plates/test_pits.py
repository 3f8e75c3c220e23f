"""Pits: which are refused, what their walls weigh by their solid, and what is remarked on them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from shapely import Polygon, box

from groundslab import InputError, Model
from groundslab.model.combinations import list_combinations
from groundslab.model.plates.pits import pits_of
from groundslab.model.plates.region import PlateRegion
from groundslab.model.remarks.remarks import find_remarks
from groundslab.model.remarks.resultants import case_resultants

LAYERS = {
    "kind": "vlasov",
    "layers": [{"E": 20e6, "nu": 0.3, "thickness": 1.2}, {"E": 40e6, "nu": 0.3, "thickness": 3}],
}


def rectangle(x: tuple[float, float], y: tuple[float, float]) -> dict[str, Any]:
    """Return a rectangle."""
    return {"kind": "rectangle", "x": x, "y": y}


PIT: dict[str, Any] = {"shape": rectangle((1, 3.5), (-1, 2)), "level": -1.2, "wall": 0.3, "thickness": 0.4}


def model(zones: list[dict[str, Any]], plate: dict[str, Any] | None = None, **parts: Any) -> Model:
    """Return a raft of 12 m x 10 m, 0.5 m thick, with zones, under its own weight."""
    usual = {
        "plate": {"length_x": 12, "length_y": 10, "thickness": 0.5, "E": 30e9, "nu": 0.2, "zones": zones}
        | (plate or {}),
        "ground": {"kind": "winkler", "k": 20e6},
        "cases": [{"name": "G"}],
        "loads": [{"kind": "self weight", "unit_weight": 25e3, "case": "G"}],
    }
    return Model.model_validate(usual | parts)


OPENING = {"openings": [rectangle((3.6, 4.5), (0, 1))]}
BEAM = {"name": "B", "points": [(-5, 0), (5, 0)], "section": {"kind": "rectangle", "width": 0.3, "height": 0.8}}
STRIP = {"name": "S", "start": (-5, -3), "end": (5, 3), "width": 1.0, "design": "beam"}
REFUSED: dict[str, tuple[Any, str, str]] = {
    "no wall": (([PIT | {"wall": None}],), "plate.zones[1].wall", "nothing, with a level"),
    "no level": (([PIT | {"level": None}],), "plate.zones[1].wall", "walls without a level"),
    "upwards": (([PIT | {"level": 0.2}],), "plate.zones[1].level", "0.2"),
    "recess": (([PIT | {"level": -0.1}],), "plate.zones[1].level", "a floor 400 mm thick"),
    "at the edge": (([PIT | {"shape": rectangle((4, 5.9), (-1, 2))}],), "plate.zones[1].shape", "leave the plate"),
    "beside an opening": (([PIT], OPENING), "plate.zones[1].shape", "meet an opening"),
    "walls alone": (([PIT | {"wall": 1.8}],), "plate.zones[1].wall", "hardly wider"),
    "beside a zone": (
        ([{"shape": rectangle((3.6, 5), (-1, 1)), "thickness": 0.8}, PIT],), "plate.zones[2].shape", "meets zones[1]",
    ),
    "under a zone": (
        ([PIT, {"shape": rectangle((0, 5), (-2, 3)), "thickness": 0.8}],), "plate.zones[1].shape", "meets zones[2]",
    ),
    "pit in a pit": (
        ([PIT, PIT | {"shape": rectangle((1.5, 3), (0, 1)), "level": -2.0}],), "plate.zones[1].shape", "meets zones[2]",
    ),
    "beam": (([PIT], {}, {"beams": [BEAM]}), "beams[1]", "a beam across a pit"),
    "strip": (([PIT], {}, {"output": {"strips": [STRIP]}}), "output.strips[1].design", "across a pit"),
    "too deep": (([PIT | {"level": -3.95}], {}, {"ground": LAYERS}), "plate.zones[1].level", "in layers of 4.2 m"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_no_pit_can_be_is_refused(case: str) -> None:
    """Each is named with its place and what was found there."""
    (zones, *rest), place, found = REFUSED[case]
    zones = [{key: value for key, value in zone.items() if value is not None} for zone in zones]
    plate, parts = [*rest, {}, {}][:2]
    with pytest.raises(InputError) as error:
        model(zones, plate, **parts)
    said = [(issue.location, issue.found) for issue in error.value.issues]
    assert any(location == place and found in words for location, words in said), said


def test_a_zone_before_a_pit_may_lie_around_it() -> None:
    """Under a core the slab is thicker, and the pit's walls join that."""
    (pit,) = pits_of(model([{"shape": rectangle((0, 5), (-2, 3)), "thickness": 0.9}, PIT]).plate)
    assert (pit.number, pit.around) == (2, 0.9)
    assert pit.deeper == pytest.approx(1.2 + 0.4 - 0.9)


def solid(pit: Polygon, level: float, floor: float, slab: float, wall: float) -> np.ndarray[Any, Any]:
    """Return the volume of concrete beside floor and slab [m3], and its first moments along x and y [m4].

    The wall's inner half stands on the floor, -level high, its outer half hangs under the slab, down to the floor's
    underside.
    """
    outer, inner = (pit.buffer(side * wall / 2, join_style="mitre") for side in (1, -1))
    parts = ((outer.difference(pit), -level + floor - slab), (pit.difference(inner), -level))
    return sum(h * part.area * np.array([1.0, part.centroid.x, part.centroid.y]) for part, h in parts)  # type: ignore[return-value]


def test_walls_weigh_what_their_solid_weighs() -> None:
    """Force and moments are those of a wall drawn as a solid, of a rectangle away from the middle of the plan.

    Without it: 25 kN/m3 over 120 m2 of 0.5 m, of which 7.5 m2 are 0.4 m thick.
    """
    sums = case_resultants(model([PIT]))["G"]
    V = solid(box(1, -1, 3.5, 2), -1.2, 0.4, 0.5, 0.3)
    assert V[0] == pytest.approx(0.15 * 11 * 1.2 + 0.15 * 11 * 1.1 + 4 * 0.15**2 * (1.1 - 1.2))
    floor = -0.1 * 7.5 * np.array([1.0, 2.25, 0.5])
    wanted = 25e3 * (V + floor + np.array([60.0, 0.0, 0.0]))
    assert (sums.F, sums.M_x, sums.M_y) == pytest.approx(tuple(wanted))


def test_walls_of_a_pit_of_any_shape_weigh_what_their_solid_weighs() -> None:
    """On a triangle corners are sharp: what is missing outside is double inside, so that the force is exact."""
    corners = [(0.0, 0.0), (4.0, 0.0), (0.0, 3.0)]
    sums = case_resultants(model([PIT | {"shape": {"kind": "polygon", "points": corners}, "thickness": 0.5}]))["G"]
    V = solid(Polygon(corners), -1.2, 0.5, 0.5, 0.3)
    assert pytest.approx(25e3 * (60.0 + V[0])) == sums.F
    assert V[0] == pytest.approx(0.3 * 12 * 1.2)


def test_what_lies_at_one_level() -> None:
    """The slab has a hole where the pit is, and a place has the level that it lies at."""
    region = PlateRegion(model([PIT]).plate)
    around, pit = region.levels
    assert (around.area, pit.area) == pytest.approx((120 - 7.5, 7.5))
    assert region.level_at((2, 0)) is pit
    assert region.level_at((0, 0)) is around
    assert region.steps is not None
    assert region.steps.length == pytest.approx(11)
    assert PlateRegion(model([]).plate).steps is None


def said(**parts: Any) -> list[tuple[str, bool]]:
    """Return the remarks on a raft with a pit, and whether they leave a design in doubt."""
    case = model([PIT], **parts)
    return [(str(remark.words), remark.doubtful) for remark in find_remarks(case, list_combinations(case))]


WATER = {"kind": "uniform", "q": -30e3, "case": "G"}
DEAD = {"kind": "self weight", "unit_weight": 25e3, "case": "G"}


def test_water_presses_more_under_a_pit() -> None:
    """The underside lies 1.2 + 0.4 - 0.5 = 1.1 m deeper, where water presses 11 kPa more, unless a load says so."""
    doubts = [words for words, doubtful in said(loads=[DEAD, WATER]) if doubtful]
    assert len(doubts) == 1
    assert "11 kPa" in doubts[0]
    assert "1.1 m deeper" in doubts[0]
    more = {"kind": "area", "q": -11e3, "case": "G", "shape": PIT["shape"]}
    assert not [words for words, doubtful in said(loads=[DEAD, WATER, more]) if doubtful]


def test_ground_by_constants_does_not_know_how_deep_it_is() -> None:
    """Springs are remarked on; layers, which begin at the underside of a pit, are not."""
    springs = "the ground is the same under pits"
    assert any(words.startswith(springs) for words, _ in said())
    assert not any(words.startswith(springs) for words, _ in said(ground=LAYERS))
    assert any(words.startswith("pits are analyzed as if") for words, _ in said(ground=LAYERS))
