"""Checks that are switched off: counted and named, never failing, while all others are judged by their own worst."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import groundslab as gs
from groundslab.case.casefile import loads, to_toml
from groundslab.cli.main import main
from groundslab.design.checks import Design, check_design
from groundslab.errors import InputError
from groundslab.results.results import Results
from helpers.combinations import few
from helpers.documents import validate
from helpers.paths import EXAMPLES

#: Two footings' worth of load on one slab: the heavier column punches it, the lighter does not.
CASE = """
title = "Two columns"
plate = { length_x = "8 m", length_y = "4 m", thickness = "0.35 m", E = "33 GPa", nu = 0.2 }
ground = { kind = "winkler", k = "40 MPa/m" }
mesh = { size = "0.5 m" }
columns = [
    { name = "heavy", x = "-2 m", y = "0 m", width_x = "0.3 m", width_y = "0.3 m" },
    { name = "light", x = "2 m", y = "0 m", width_x = "0.3 m", width_y = "0.3 m" },
]
cases = [{ name = "G" }]
loads = [
    { kind = "point", case = "G", P = "1800 kN", column = "heavy" },
    { kind = "point", case = "G", P = "500 kN", column = "light" },
]
combinations = [
    { name = "ULS", limit_state = "ultimate", factors = { G = 1.35 } },
    { name = "SLS", limit_state = "characteristic", factors = { G = 1 } },
]
limits = { settlement = "1 mm", angular_distortion = 0.01 }

[reinforcement]
concrete = "C30/37"
steel = "B500B"
bottom = ["50 mm", "62 mm"]
top = ["50 mm", "62 mm"]
"""
PUNCHING = {"check": "punching", "of": "heavy", "reason": "steel head"}
SETTLEMENT = {"check": "settlement", "reason": "nothing stands beside"}


@pytest.fixture(scope="module")
def solved(tmp_path_factory: pytest.TempPathFactory) -> Results:
    """Return the results of both columns."""
    path = tmp_path_factory.mktemp("off") / "case.toml"
    path.write_text(CASE, encoding="utf-8")
    return gs.solve(gs.load(path))


MADE: dict[str, tuple[Results, Design]] = {}


def design(solved: Results, *off: dict[str, Any]) -> Design:
    """Return the design with some checks switched off, made once."""
    of, made = MADE.get(repr(off), (None, None))
    if made is None or of is not solved:
        made = check_design(replace(solved, model=solved.model.replace(checks={"off": off})))
        MADE[repr(off)] = solved, made
    return made


def test_without_it_both_fail(solved: Results) -> None:
    """The heavy column governs punching, the settlement is too large."""
    before = design(solved)
    assert before.status == "fails"
    failing = {(str(check.name), check.of) for check in before.checks if check.status == "fails"}
    assert ("settlement", "") in failing
    assert any(name.startswith("punching") and of == "heavy" for name, of in failing)
    assert not any(check.off for check in before.checks)


def test_it_is_named_and_does_not_fail(solved: Results) -> None:
    """The rows stay with their numbers, reason, and how they would have ended; the headline counts them."""
    before, after = design(solved), design(solved, PUNCHING, SETTLEMENT)
    off = {(str(check.name), check.of): check for check in after.checks if check.off is not None}
    assert after.status != "fails"
    assert ("settlement", "") in off
    assert {of for name, of in off if name.startswith("punching")} == {"heavy"}
    for key, check in off.items():
        (same,) = (each for each in before.checks if (str(each.name), each.of) == key)
        assert (check.demand, check.resistance) == (same.demand, same.resistance)
        assert check.status == check.verdict == "switched off"
        assert check.off is not None
        assert check.off.status == same.status
        assert check.off.reason in check.words
        assert same.status in check.words
    failing = sum(check.off is not None and check.off.status == "fails" for check in off.values())
    assert failing >= 2
    assert f"Switched off: {len(off)} of {len(after.checks)}, of which {failing} would fail" in after.headline
    assert "(heavy)" in after.headline


def test_the_others_are_judged_by_their_own_worst(solved: Results) -> None:
    """Punching at the light column has the check that it has where it is the only one."""
    light = [check for check in design(solved, PUNCHING).checks if check.of == "light" and "punching" in check.name]
    turned = {**PUNCHING, "of": "light"}
    assert light
    assert all(check.off is None and check.utilization is not None for check in light)
    switched = [check for check in design(solved, turned).checks if check.of == "light" and "punching" in check.name]
    assert [check.demand for check in switched] == [check.demand for check in light]
    assert all(check.off is not None for check in switched)
    assert design(solved, turned).status == "fails"


def test_first_words_and_all(solved: Results) -> None:
    """Punching is every check that begins so, of all columns; half a word is none."""
    every = design(solved, {"check": "Punching", "reason": "by another program"})
    assert all((check.off is not None) == check.name.startswith("punching") for check in every.checks)
    assert sum(check.off is not None for check in every.checks) >= 2


@pytest.mark.parametrize("wrong", [{"check": "punch"}, {"check": "punching", "of": "heavier"}])
def test_in_vain(solved: Results, wrong: dict[str, str]) -> None:
    """An entry that fits no check is told, with what there is."""
    after = design(solved, SETTLEMENT, {**wrong, "reason": "none"})
    (told,) = (check for check in after.checks if check.name == "input")
    assert told.status == "attention"
    assert "checks.off[2] switches nothing off" in told.words
    assert ("heavy" if "of" in wrong else "bending") in told.words


def test_the_worst_of_several_is_no_one(solved: Results) -> None:
    """The pair that governs cannot be switched off, as nobody would look at the next; a layer can."""
    pair = next(check.of for check in design(solved).checks if check.name == "angular distortion")
    after = design(solved, {"check": "angular distortion", "of": pair, "reason": "none"})
    assert not any(check.off for check in after.checks)
    (told,) = (check for check in after.checks if check.name == "input")
    assert "is of the worst of several" in told.words


def test_the_worst_layer_is_no_one(solved: Results) -> None:
    """What is checked of all layers is switched off as a whole; bars of a layer have a check of their own by name."""
    bars = {name: {"diameter": 0.012, "spacing": 0.15} for name in ("bottom_x", "bottom_y", "top_x", "top_y")}
    laid = replace(solved, model=solved.model.replace(reinforcement=solved.model.reinforcement.replace(**bars)))
    worst = next(check for check in design(laid).checks if check.name == "distance of bars")
    assert worst.of
    of_layer = design(laid, {"check": "distance of bars", "of": worst.of, "reason": "none"})
    assert not any(check.off for check in of_layer.checks)
    by_name = design(laid, {"check": "bars at the bottom x", "reason": "none"})
    assert [(str(check.name), check.of) for check in by_name.checks if check.off] == [
        ("bars at the bottom x", "bottom x")
    ]


#: Examples by other codes, and of another thing that can be switched off alone.
OF_ONE = {
    "second_generation": "punching",
    "us_mat": "two-way shear",
    "ribbed_raft": "webs of beams",
}


@pytest.mark.slow
@pytest.mark.parametrize(("example", "check"), OF_ONE.items())
def test_nothing_else_changes(example: str, check: str) -> None:
    """Of the same check the others are judged, none worse than the one that is off; all other checks stay."""
    model = few(gs.load(EXAMPLES / f"{example}.toml"))
    nothing_else_changes(gs.solve(model.replace(mesh={"size": max(model.sides) / 8})), check)


def test_nothing_else_changes_at_columns(solved: Results) -> None:
    """The same of two columns by EN 1992-1-1."""
    nothing_else_changes(solved, "punching")


@pytest.mark.parametrize("check", ["walls", "punching at walls' ends"])
def test_nothing_else_changes_at_walls(check: str) -> None:
    """The same of walls with a height, and of their ends."""
    ends = {"west": [(-3.0, -1.0), (-3.0, 1.0)], "east": [(3.0, -1.0), (3.0, 1.0)]}
    walls = [{"name": name, "points": points, "thickness": 0.25, "height": 2.5} for name, points in ends.items()]
    lines = [
        {"kind": "line", "case": "G", "q": 2e5, "q_end": 4e5, "wall": "west"},
        {"kind": "line", "case": "G", "q": 1e5, "wall": "east"},
    ]
    model = loads(CASE)
    nothing_else_changes(gs.solve(model.replace(walls=walls, loads=[*model.loads, *lines])), check)


def nothing_else_changes(results: Results, check: str) -> None:
    """Fail if switching off the worst of a check changes more than that."""
    before = design(results).checks
    worst = next(each for each in before if each.name.startswith(check) and each.of)
    after = design(results, {"check": check, "of": worst.of, "reason": "by hand"}).checks
    off = [each for each in after if each.off is not None]
    assert {each.of for each in off} == {worst.of}
    assert (worst.name, worst.demand, worst.resistance) in [(each.name, each.demand, each.resistance) for each in off]
    rest = [each for each in after if each.off is None and each.name == worst.name]
    assert rest
    assert all(each.of != worst.of and (each.utilization or 0) <= (worst.utilization or 0) for each in rest)
    others = [[each for each in checks if not each.name.startswith(check)] for checks in (before, after)]
    assert [each.words for each in others[0]] == [each.words for each in others[1]]


def test_it_comes_back_from_a_file(solved: Results, tmp_path: Path) -> None:
    """A case is written with what is switched off, and read as it was."""
    model = solved.model.replace(checks={"off": [PUNCHING, SETTLEMENT]})
    (tmp_path / "again.toml").write_text(to_toml(model), encoding="utf-8")
    assert gs.load(tmp_path / "again.toml").checks == model.checks


def test_a_reason_is_needed() -> None:
    """Without one the case is refused, at its place."""
    with pytest.raises(InputError, match=r"off\[1\]\.reason"):
        gs.Checks(off=[{"check": "punching"}])


def test_by_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """From a file: exit code 3 without, 0 with the failing ones off; documents have the reason and their shapes."""
    off = "".join(
        f'\n[[checks.off]]\ncheck = "{check}"\nreason = "checked by hand"\n'
        for check in ("punching", "settlement", "one-way shear", "bending", "edge line force", "size of elements")
    )
    codes = {}
    for name, text in {"on": CASE, "off": CASE + off}.items():
        (tmp_path / f"{name}.toml").write_text(text, encoding="utf-8")
        codes[name] = main(["solve", str(tmp_path / f"{name}.toml"), "--json"])
        document = json.loads(capsys.readouterr().out)
        validate(document, "summary")
    reasons = {check["off"]["reason"] for check in document["design"]["checks"] if check["off"]}
    assert codes == {"on": 3, "off": 0}
    assert reasons == {"checked by hand"}
    assert "Switched off" in document["design"]["headline"]
