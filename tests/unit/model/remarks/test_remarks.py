"""Remarks on cases that are right: every load that acts nowhere is named, and so is what combines it wrongly."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from groundslab import units
from groundslab.case import casefile
from groundslab.cli.main import main
from groundslab.model.combinations import list_combinations
from groundslab.model.model import Model
from groundslab.model.remarks.case_use import case_uses
from groundslab.model.remarks.remarks import Remark, find_remarks
from groundslab.model.remarks.unusual import USUAL
from groundslab.schema.fields import Quantity

PLATE: dict[str, Any] = {
    "plate": {"length_x": 6, "length_y": 4, "thickness": 0.4, "E": 33e9, "nu": 0.2},
    "ground": {"kind": "winkler", "k": 20e6},
}
G, Q = {"name": "G"}, {"name": "Q", "action": "variable"}
ULS = {"name": "U", "factors": {"Q": 1.5}}
BOTH = {"name": "both", "factors": {"G": 1.35, "Q": 1.5}}


def uniform(case: str, q: float = 5e3) -> dict[str, Any]:
    """Return a pressure on the whole plate in a case."""
    return {"kind": "uniform", "case": case, "q": q}


def remarks(**parts: Any) -> list[Remark]:
    """Return the remarks on a slab with G and Q."""
    model = Model(**PLATE | {"cases": [G, Q], "loads": [uniform("G"), uniform("Q")]} | parts)
    return list(find_remarks(model, list_combinations(model)))


def only(**parts: Any) -> tuple[str, str, bool]:
    """Return place, words and doubt of the only remark on a slab with G and Q."""
    (remark,) = remarks(**parts)
    return remark.location, remark.words, remark.doubtful


def test_a_case_in_no_combination() -> None:
    """The column of 600 kN in G is never used; an H alone is a load, too."""
    point = {"kind": "point", "case": "G", "P": 600e3, "x": 1, "y": 0}
    words = 'case "G" acts in no combination: its load is left out (600 kN)'
    assert only(loads=[point, uniform("Q")], combinations=[ULS]) == ("cases[1]", words, True)
    words = 'case "G" acts in no combination: its horizontal force is left out'
    assert only(cases=[G | {"H_x": 1e3}, Q], loads=[uniform("Q")], combinations=[ULS])[1] == words


def test_a_factor_of_zero_everywhere() -> None:
    """A case that is named with the factor 0 is left out just so."""
    words = 'case "G" has the factor 0 wherever it is named: its 2 loads are left out (240 kN)'
    loads = [uniform("G"), uniform("G"), uniform("Q")]
    assert only(loads=loads, combinations=[{"name": "U", "factors": {"G": 0, "Q": 1.5}}])[1:] == (words, True)


def test_a_case_without_loads() -> None:
    """What was to be in it may have gone to another case."""
    assert only(loads=[uniform("G")], combinations=[BOTH]) == ("cases[2]", 'case "Q" has no loads', True)


def test_an_accidental_case_without_its_set() -> None:
    """[combine] takes accidental actions in accidental combinations alone."""
    flood = {"name": "flood", "action": "accidental"}
    words = 'case "flood" acts in no combination: its load is left out (120 kN)'
    loads = [uniform("G"), uniform("Q"), uniform("flood")]
    combine = {"sets": ["ultimate", "characteristic"]}
    assert only(cases=[G, Q, flood], loads=loads, combine=combine)[1:] == (words, True)


def test_a_case_without_part_in_strength_or_serviceability() -> None:
    """Strength without Q is in doubt; serviceability without it may be meant, as where psi_2 is 0."""
    dead = {"name": "dead", "factors": {"G": 1.35}}
    serviceable = {"name": "SLS", "limit_state": "characteristic", "factors": {"G": 1, "Q": 1}}
    words = 'case "Q" acts in no ultimate combination'
    assert only(combinations=[dead, serviceable]) == ("cases[2]", words, True)
    words = 'case "Q" acts in no serviceability combination'
    assert only(combinations=[BOTH, serviceable | {"factors": {"G": 1}}]) == ("cases[2]", words, False)
    words = 'case "G" acts in no serviceability combination'
    assert only(combinations=[BOTH, serviceable | {"factors": {"Q": 1}}]) == ("cases[1]", words, True)


def test_no_variable_case() -> None:
    """1.35 G + 1.35 Q is in doubt in ultimate combinations, not where water lifts a dead weight."""
    parts = {"cases": [G, {"name": "Q"}]}
    words = 'no case is variable: "G" and "Q" are combined as permanent; a live load needs action = "variable"'
    assert only(**parts, combine={"sets": ["ultimate", "characteristic"]}) == ("combine", words, True)
    assert only(**parts, combine={"sets": ["ultimate"], "expression": "ACI 318"})[2]
    assert not only(**parts, combine={"sets": ["quasi-permanent"]})[2]
    assert remarks(**parts, loads=[uniform("G"), uniform("Q", -1e3)], combine={"sets": ["uplift"]}) == []


@pytest.mark.parametrize("name", ["Q", "q2", "Live load", "imposed", "wind", "SNOW_1"])
def test_a_permanent_case_with_the_name_of_a_live_load(name: str) -> None:
    """Beside a variable case one that is typed without its action would have the factor of dead loads."""
    cases = [G, {"name": name}, {"name": "R", "action": "variable"}]
    loads = [uniform(case["name"]) for case in cases]
    words = f'case "{name}" is permanent, the default; a live load is "variable"'
    assert only(cases=cases, loads=loads, combine={"sets": ["ultimate"]}) == ("cases[2]", words, True)
    assert remarks(cases=cases, loads=loads, combinations=[{"name": "U", "factors": {"G": 1, name: 1, "R": 1}}]) == []


@pytest.mark.parametrize("name", ["G", "wind turbine", "equipment", "wall"])
def test_names_of_dead_loads(name: str) -> None:
    """What may as well be a weight is not remarked on."""
    cases = [{"name": name}, {"name": "R", "action": "variable"}]
    assert remarks(cases=cases, loads=[uniform(name), uniform("R")], combine={"sets": ["ultimate"]}) == []


def test_self_weight_in_a_case_that_is_not_permanent() -> None:
    """Combined as a live load, the slab's weight has 1.5 and is absent without it; listed factors are the user's."""
    weight = {"kind": "self weight", "case": "Q", "unit_weight": 25e3}
    loads = [uniform("G"), weight]
    words = 'self-weight is permanent, but acts in case "Q", which is variable'
    assert only(loads=loads, combine={"sets": ["ultimate"]}) == ("loads[2]", words, True)
    assert remarks(loads=loads, combinations=[BOTH]) == []
    assert remarks(loads=[weight | {"case": "G"}, uniform("Q")], combine={"sets": ["ultimate"]}) == []


def test_a_set_without_combinations() -> None:
    """Of psi_2 = 0 alone no quasi-permanent combination is made."""
    wind = Q | {"category": "wind"}
    found = remarks(cases=[wind], loads=[uniform("Q")], combine={"sets": ["ultimate", "quasi-permanent"]})
    words = '"quasi-permanent" yields no combination: all its factors are 0'
    assert [(each.location, each.words, each.doubtful) for each in found] == [("combine.sets", words, True)]


def test_uplift_without_water() -> None:
    """An accidental flood takes no part in UPL, so that nothing lifts there: both are told."""
    flood = {"name": "flood", "action": "accidental"}
    loads = [uniform("G"), uniform("Q"), uniform("flood", -20e3)]
    nothing, without = remarks(cases=[G, Q, flood], loads=loads, combine={"sets": ["accidental", "uplift"]})
    assert nothing.words == (
        "nothing acts upwards in the uplift combinations; water pressure from below is a load with q below 0"
    )
    assert without.words == (
        'case "flood" acts upwards, but in no uplift combination; [combine] makes none with accidental actions, '
        "[[combinations]] can list one"
    )
    assert nothing.doubtful
    assert without.doubtful
    listed = {"name": "UPL flood", "limit_state": "uplift", "factors": {"G": 0.9, "flood": 1}}
    both = {"sets": ["accidental", "uplift", "ultimate"]}
    assert remarks(cases=[G, Q, flood], loads=loads, combine=both, combinations=[listed]) == []


@pytest.mark.parametrize(
    "lifting",
    [
        {"kind": "point", "P": -1e3, "x": 0, "y": 0},
        {"kind": "line", "q": 1e3, "q_end": -1.1e3, "points": [(-1, 0), (1, 0)]},
        {"kind": "patch", "q": -1e3, "x": (-1, 1), "y": (-1, 1)},
        {"kind": "area", "q": -1e3, "shape": {"kind": "circle", "centre": (0, 0), "radius": 1}},
    ],
)
def test_what_lifts(lifting: dict[str, Any]) -> None:
    """Forces, lines and pressures upwards lift, whatever their kind."""
    loads = [uniform("G"), lifting | {"case": "Q"}]
    assert remarks(loads=loads, combine={"sets": ["ultimate", "uplift"]}) == []


def test_what_lifts_nothing_in_sum() -> None:
    """A couple of two forces is no uplift, nor is a pressure that changes its sign over the plate."""
    for couple in (
        [{"kind": "point", "P": sign * 1e3, "x": sign, "y": 0, "case": "Q"} for sign in (-1, 1)],
        [{"kind": "uniform", "q": 0, "slope": (1e3, 0), "case": "Q"}],
    ):
        loads = [uniform("G"), *couple]
        (remark,) = remarks(loads=loads, combine={"sets": ["ultimate", "uplift"]})
        assert remark.words.startswith("nothing acts upwards")


def test_combinations_that_repeat_others() -> None:
    """Only the same factors of the same limit state repeat; less of everything may govern, as the slab may lift."""
    again, less = {"name": "again", "factors": {"Q": 1.5, "G": 1.35}}, {"name": "less", "factors": {"G": 1, "Q": 1}}
    words = 'combinations with the same factors: "again" is the same as "both"'
    assert only(combinations=[BOTH, less, again]) == ("combinations", words, False)
    assert remarks(combinations=[BOTH, less, again | {"limit_state": "accidental"}]) == []


def test_each_case_by_itself() -> None:
    """Without combinations no cases act together: in doubt where limits are checked."""
    words = "each case is solved by itself: without [[combinations]] or [combine] no two of them act together"
    assert only() == ("cases", words, False)
    assert only(limits={"settlement": 0.02})[2]
    assert remarks(cases=[G], loads=[uniform("G")]) == []


def test_a_pattern_that_no_move_places() -> None:
    """A rack that is described and stands nowhere is left out."""
    rack = {"kind": "rack", "name": "rack", "P": 60e3}
    words = 'pattern "rack" is not placed by any move: its forces are left out'
    assert only(patterns=[rack], combinations=[BOTH]) == ("patterns[1]", words, True)


def test_a_case_that_moves_acts_at_its_positions() -> None:
    """Its combinations are those at the positions; nothing but the path need be in it."""
    axle = {"kind": "vehicle", "name": "axle", "wheels": [{"P": 45e3}]}
    move = {"pattern": "axle", "case": "Q", "points": [(-2, 0), (2, 0)], "step": 1.0}
    model = Model(
        **PLATE, cases=[G, Q], loads=[uniform("G")], patterns=[axle], moves=[move],
        combine={"sets": ["ultimate", "characteristic"]},
    )  # fmt: skip
    combinations = list_combinations(model)
    assert find_remarks(model, combinations) == ()
    dead, live = case_uses(model, combinations)
    assert dead.words() == "ultimate 1 to 1.35 (12 of 12); characteristic 1 (6 of 6)"
    assert (live.loads, live.words()) == (1, "ultimate 1.5 (10 of 12); characteristic 1 (5 of 6)")


def test_a_vehicle_in_a_permanent_case() -> None:
    """It would have 1.35 and stand everywhere; as does a vehicle at one place, but not a rack there."""
    axle = {"kind": "vehicle", "name": "axle", "wheels": [{"P": 45e3}]}
    rack = {"kind": "rack", "name": "rack", "P": 60e3}
    path = {"points": [(-2, 0), (2, 0)], "step": 1.0}
    sets = {"sets": ["ultimate", "characteristic"]}
    words = 'pattern "axle" moves in case "G", which is permanent; a moving load is "variable"'
    for move in (path, {"points": [(1, 0)]}):
        parts: dict[str, Any] = {"patterns": [axle], "moves": [{"pattern": "axle", "case": "G"} | move]}
        assert only(**parts, combine=sets) == ("moves[1]", words, True)
        assert only(**parts, combine={"sets": ["characteristic"]})[1:] == (words, False)
        # without [combine] nothing asks whether a case is permanent; in a variable one all is well
        assert remarks(**parts, combinations=[BOTH]) == []
        parts["moves"][0]["case"] = "Q"
        assert remarks(**parts, combine=sets) == []
    assert remarks(patterns=[rack], moves=[{"pattern": "rack", "case": "G", "points": [(1, 0)]}], combine=sets) == []


def thick(plate: float, zone: float) -> dict[str, Any]:
    """Return the plate with a thickness, and another one in its middle."""
    zone_table = {"thickness": zone, "shape": {"kind": "rectangle", "x": (-1, 1), "y": (-1, 1)}}
    return PLATE["plate"] | {"thickness": plate, "zones": [zone_table]}


def test_quantities_far_off_what_is_usual() -> None:
    """1 mm for 1 m, 25 N/m^3 for 25 kN/m^3; said once for each key, and no design passes before it is looked at."""
    words = "plate.zones[1].thickness: 1 mm is far below the usual 100 mm to 3 m; is the unit right?"
    assert only(plate=thick(1.05, 1e-3), combinations=[BOTH]) == ("plate.zones[1].thickness", words, True)
    weight = {"kind": "self weight", "case": "G", "unit_weight": 25.0}
    words = "loads[1].unit_weight: 25 N/m^3 is far below the usual 10 kN/m^3 to 30 kN/m^3; is the unit right?"
    assert only(loads=[weight, uniform("Q")], combinations=[BOTH]) == ("loads[1].unit_weight", words, True)
    loads = [uniform("G", 5e6 * 1.01), uniform("Q", -6e6)]
    words = "loads[1].q, one of 2: 5.05 MPa is far above the usual 500 Pa to 500 kPa; is the unit right?"
    assert only(loads=loads, combinations=[BOTH])[1] == words
    assert only(ground={"kind": "winkler", "k": 20e3}, combinations=[BOTH])[0] == "ground.k"
    # what is far too stiff may be so on purpose
    words = "plate.E: 30000 GPa is far above the usual 5 GPa to 50 GPa; is the unit right?"
    assert only(plate=PLATE["plate"] | {"E": 30e12}, combinations=[BOTH]) == ("plate.E", words, False)


def test_a_zone_far_from_its_plate() -> None:
    """50 mm on a plate of 1050 mm is usual by itself; ten times as thick or a tenth is not far."""
    words = "plate.zones[1].thickness: 50 mm in a plate of 1.05 m; is the unit right?"
    assert only(plate=thick(1.05, 0.05), combinations=[BOTH]) == ("plate.zones[1].thickness", words, True)
    for ratio in (0.1, 10.0):
        assert remarks(plate=thick(0.3, 0.3 * ratio), combinations=[BOTH]) == []


def test_ranges_are_of_keys_that_there_are() -> None:
    """Each range is one of a quantity of the model, around an example of its key."""
    keys, seen = dict[tuple[str, str], Quantity](), set[type]()

    def walk(section: Any) -> None:
        if section in seen:
            return
        seen.add(section)
        for key, field in section.model_fields.items():
            if isinstance(field.type, Quantity):
                keys[section.__name__, key] = field.type
            for part in field.sections.parts:
                walk(part)

    walk(Model)
    for name, ranges in USUAL.items():
        for key, (low, high) in ranges.items():
            quantity = keys[name, key]
            assert low <= units.parse(quantity.usual, quantity.dimension) <= high, (name, key)


def test_a_borehole_far_off_the_plate() -> None:
    """One beside the building is usual: a tenth of its longer side, 0.6 m, is not far."""
    layers = [{"E": 20e6, "nu": 0.3, "thickness": 3.0}]
    holes = [{"name": name, "x": x, "y": 0, "layers": layers} for name, x in (("near", 3.6), ("far", 53.0))]
    found = only(ground={"kind": "vlasov", "layers": layers}, boreholes=holes, combinations=[BOTH])
    assert found == ("boreholes[2]", 'borehole "far" is 50 m off the plate', False)


def test_check_prints_them(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """`groundslab check` calls the case fine, and says what is left out."""
    model = Model(**PLATE, cases=[G, Q], loads=[uniform("G"), uniform("Q")], combinations=[ULS])
    (tmp_path / "case.toml").write_text(casefile.to_toml(model), encoding="utf-8")
    assert main(["check", str(tmp_path / "case.toml")]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "  case G: permanent, 1 load; in no combination" in lines
    assert '  remark: case "G" acts in no combination: its load is left out (120 kN)' in lines
