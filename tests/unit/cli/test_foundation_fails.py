"""groundslab solve where the foundation fails: exit code 3 and the first line; what was not solved ends with 1."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import groundslab
from groundslab.analysis import check
from groundslab.analysis.tasks import run
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.design.checks import DesignCheck
from groundslab.errors import GroundslabError, IllConditioned, NotCertified, NotConverged, SingularMatrix
from groundslab.model.loads.load_cases import LimitState
from groundslab.views.files.results_folder import load_results
from groundslab.views.report.html import render_report
from groundslab.views.summary import json_summary
from groundslab.workbench.solver import process

#: A pad of 3 x 2 x 0.5 m, 75 kN, and a force of 100 kN with 300 kNm: with a factor f of it the resultant leaves the pad
#: where 300 f > 1.5 (75 + 100 f), f > 0.75.
PAD = """title = "Pad"
plate = { length_x = "3 m", length_y = "2 m", thickness = "0.5 m", E = "33 GPa", nu = 0.2 }
ground = { kind = "winkler", k = "30 MPa/m" }
mesh = { size = "0.5 m" }
cases = [{ name = "G" }, { name = "W", action = "variable" }]
loads = [
    { kind = "self weight", case = "G", unit_weight = "25 kN/m^3" },
    { kind = "point", case = "W", P = "100 kN", M_x = "300 kNm", x = "0 m", y = "0 m" },
]
"""
#: ASCE 7-16 2.3.1, 0.9 D + 1.0 W: 0.9 (150 pcf 2 ft 64 ft2 + 30 kip) - 50 kip = 0.9 x 49.2 - 50 = -5.72 kip, -25.44 kN.
WIND = """title = "Pad with wind uplift, ACI combinations"
plate = { length_x = "8 ft", length_y = "8 ft", thickness = "24 in", E = "3605 ksi", nu = 0.2 }
ground = { kind = "winkler", k = "150 pci" }
columns = [{ name = "C1", x = "0 ft", y = "0 ft", width_x = "18 in", width_y = "18 in" }]
cases = [
    { name = "D" },
    { name = "L", action = "variable", category = "B" },
    { name = "W", action = "variable", category = "wind" },
]
loads = [
    { kind = "self weight", case = "D", unit_weight = "150 pcf" },
    { kind = "point", case = "D", column = "C1", P = "30 kip" },
    { kind = "point", case = "L", column = "C1", P = "20 kip" },
    { kind = "point", case = "W", column = "C1", P = "-50 kip" },
]
combine = { sets = ["ultimate"], expression = "ACI 318" }
mesh = { size = "1 ft" }
[reinforcement]
code = "ACI 318"
f_ck = "4 ksi"
f_yk = "60 ksi"
bottom = ["3.5 in", "4.25 in"]
top = ["2.5 in", "3.25 in"]
"""


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """Return the path of a case file that is still to be written."""
    return tmp_path / "pad.toml"


def combinations(*given: tuple[str, str, float]) -> str:
    """Return combinations of G and so much of W, by name and limit state."""
    return "".join(
        f'[[combinations]]\nname = "{name}"\nlimit_state = "{state}"\nfactors = {{ G = 1.0, W = {factor} }}\n'
        for name, state, factor in given
    )


def solved(path: Path, text: str) -> int:
    """Return the exit code of the command for a case."""
    path.write_text(text, encoding="utf-8")
    return main.main(["solve", str(path)])


def test_wind_that_lifts_a_pad_by_aci(case: Path) -> None:
    """0.9 D + W = -25.44 kN: the process ends with 3, and its first line says that the foundation fails, and why."""
    case.write_text(WIND, encoding="utf-8")
    command = [sys.executable, "-m", "groundslab", "solve", str(case)]
    ended = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False)
    assert ended.returncode == 3
    first = " ".join(ended.stdout.splitlines()[:3])
    assert first.startswith(
        'FOUNDATION FAILS (1 of 5 checks fails): static equilibrium: none in "ULS 8": the loads do not'
    )
    assert "their sum is -25.4438 kN (downwards positive)" in first
    assert "ATTENTION" not in ended.stdout
    assert "error" not in ended.stderr


@pytest.mark.parametrize(
    "state",
    ["ultimate", "accidental", "seismic", "equilibrium", "uplift", "characteristic", "frequent", "quasi-permanent"],
)
def test_a_topple_in_any_limit_state(case: Path, capsys: pytest.CaptureFixture[str], state: LimitState) -> None:
    """A pad that topples in one combination of two fails, whatever the limit state; the other is kept."""
    assert solved(case, PAD + combinations(("stands", state, 0.5), ("falls", state, 1.0))) == 3
    first = capsys.readouterr().out.partition("\n")[0]
    assert first.startswith("FOUNDATION FAILS (1 of ")
    kept = load_results(case.with_name("pad-results"))
    assert list(kept) == ["stands"]
    assert list(kept.without_equilibrium) == ["falls"]
    design = json.loads((case.with_name("pad-results") / "summary.json").read_text(encoding="utf-8"))["design"]
    assert [check["combination"] for check in design["checks"] if check["status"] == "fails"] == ["falls"]
    assert "x = 1.71429 m" in design["checks"][0]["words"]  # 300 / 175
    assert design["checks"][0]["foundation"] is True


def test_an_only_combination_that_topples(case: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Without any result there is a summary, a folder with the checks, and a report whose first page says it."""
    assert solved(case, PAD + combinations(("falls", "ultimate", 1.0))) == 3
    out, err = capsys.readouterr()
    assert out.startswith('FOUNDATION FAILS (1 of 1 check fails): static equilibrium: none in "falls"')
    assert err.endswith("Exit code 3.\n")
    folder = case.with_name("pad-results")
    assert "static equilibrium,,,fails" in (folder / "tables" / "checks.csv").read_text(encoding="utf-8")
    page = render_report(load_results(folder))
    assert page.index("FOUNDATION FAILS") < page.index('<nav class="contents')


@pytest.mark.parametrize(
    ("soil", "name"),
    [
        # V = 125 kN at 150 / 125 = 1.2 m: A' = 0.6 x 2 m; 5.14 x 10 kPa x 1.2 m2 are 62 kN even without H
        ('c_u = "10 kPa"', "bearing resistance"),
        # H = 30 kN against 125 tan 10 deg = 22 kN
        ("phi = 35\ndelta = 10", "sliding"),
    ],
)
def test_ground_that_fails(case: Path, capsys: pytest.CaptureFixture[str], soil: str, name: str) -> None:
    """Bearing and sliding by EN 1997-1 are failures of the foundation, too."""
    pad = PAD.replace('"variable"', '"variable", H_x = "60 kN"')
    text = pad + combinations(("ULS", "ultimate", 0.5)) + f'[soil_strength]\nunit_weight = "18 kN/m^3"\n{soil}\n'
    assert solved(case, text) == 3
    assert capsys.readouterr().out.startswith("FOUNDATION FAILS")
    (folder,) = case.parent.glob("pad-results")
    checks = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["design"]["checks"]
    assert name in [check["name"] for check in checks if check["status"] == "fails"]


def refuse(monkeypatch: pytest.MonkeyPatch, reasons: dict[str, GroundslabError]) -> None:
    """Let the analysis give up on combinations, by name, with an error."""
    solve_task = run.solve_task

    def give_up(task: Any, model: Any, combination: Any, *rest: Any) -> Any:
        return reasons.get(combination.name) or solve_task(task, model, combination, *rest)

    monkeypatch.setattr(run, "solve_task", give_up)


def test_several_reasons(case: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """A failure counts more than what was not solved; all are listed, and what was not solved needs attention."""
    refuse(monkeypatch, {"slow": NotConverged("the contact zone", [1, 2], {}), "odd": IllConditioned("too stiff")})
    text = PAD + combinations(
        ("stands", "ultimate", 0.5), ("slow", "ultimate", 0.4), ("falls", "accidental", 1.0),
        ("odd", "characteristic", 0.3), ("falls more", "seismic", 2.0),
    )  # fmt: skip
    assert solved(case, text) == 3
    out, err = capsys.readouterr()
    assert out.startswith('FOUNDATION FAILS (2 of 3 checks fail): static equilibrium: none in "falls"')
    assert 'static equilibrium: none in "falls more"' in " ".join(out.split())
    assert 'no certified result of "slow", "odd"' in " ".join(out.split())
    assert "FOUNDATION FAILS: no equilibrium in 2 of 5 combinations, number 3, 5." in out
    assert "FAILED: no certified result in 2 of 5 combinations, number 2, 4." in out
    unsolved = 'error: combination "slow": the contact zone did not converge', 'error: combination "odd": too stiff'
    lost = 'FOUNDATION FAILS: combination "falls": ', 'FOUNDATION FAILS: combination "falls more": '
    assert all(words in err for words in (*unsolved, *lost))


def test_what_the_program_cannot_do(
    case: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Without a failure, what was not solved ends with 1; the foundation is not said to fail."""
    refuse(monkeypatch, {"odd": SingularMatrix("no stiffness")})
    assert solved(case, PAD + combinations(("stands", "ultimate", 0.5), ("odd", "ultimate", 0.4))) == 1
    out, err = capsys.readouterr()
    assert out.startswith("DESIGN NEEDS ATTENTION: 1 of 1 check needs it.")
    assert "FOUNDATION" not in out + err
    assert 'error: combination "odd": no stiffness' in err


def test_a_foundation_that_stands(case: Path) -> None:
    """Below the factor by hand the pad stands: exit code 0."""
    assert solved(case, PAD + combinations(("ULS", "ultimate", 0.74))) == 0


def test_a_check_that_is_not_judged_is_no_success_alone(case: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Without the soil's strength sliding is not judged: exit code 0, as nothing fails, and the first line tells it."""
    text = PAD.replace('"variable"', '"variable", H_x = "60 kN"')
    assert solved(case, text + combinations(("ULS", "ultimate", 0.5))) == 0
    first = " ".join(capsys.readouterr().out.splitlines()[:2])
    assert first.startswith("DESIGN NEEDS ATTENTION: 1 of 1 check needs it. Not judged: 1 of 1 (sliding).")


def test_check_says_it_before_anything_is_solved(case: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Groundslab check ends with 3 as well, and names each combination that nothing balances; 0 if there is none."""
    case.write_text(WIND, encoding="utf-8")
    assert main.main(["check", str(case)]) == 3
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith(f"{case}: FOUNDATION FAILS (2.4384 m x 2.4384 m plate")
    assert lines[1].startswith(
        '  no equilibrium in "ULS 8": the loads do not press the plate down: their sum is -25.4438'
    )
    assert sum("no equilibrium" in line for line in lines) == 1
    case.write_text(PAD + combinations(("ULS", "ultimate", 0.74)), encoding="utf-8")
    assert main.main(["check", str(case)]) == 0
    assert capsys.readouterr().out.startswith(f"{case}: fine (")


def test_check_leaves_many_loads_to_the_solver(case: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Equilibrium is looked for among so many loads that it takes no time."""
    monkeypatch.setattr(check, "MAX_COMPARED_LOADS", 1)
    case.write_text(PAD + combinations(("ULS", "ultimate", 2.0)), encoding="utf-8")
    assert main.main(["check", str(case)]) == 0


@pytest.mark.slow
def test_grounds_are_compared_of_what_stands(case: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """compare-ground ends with 3 where a combination topples on the continuum, which a note says; with all, at once."""
    soil = 'ground = { kind = "continuum", layers = [{ E = "20 MPa", nu = 0.3, thickness = "4 m" }] }'
    pad = PAD.replace('ground = { kind = "winkler", k = "30 MPa/m" }', soil)
    case.write_text(pad + combinations(("stands", "ultimate", 0.3), ("falls", "ultimate", 1.0)), encoding="utf-8")
    assert main.main(["compare-ground", str(case)]) == 3
    assert 'FOUNDATION FAILS: no equilibrium on the continuum in "falls".' in " ".join(capsys.readouterr().out.split())
    case.write_text(pad + combinations(("falls", "ultimate", 1.0)), encoding="utf-8")
    assert main.main(["compare-ground", str(case)]) == 3
    assert capsys.readouterr().err.startswith("FOUNDATION FAILS: the loads topple the plate")


def test_python_raises_what_is_a_failure_and_what_is_a_gap() -> None:
    """NoEquilibrium is a failure of the foundation; what was not computed is a NoResult."""
    gaps = (IllConditioned, NotConverged, NotCertified, SingularMatrix)
    assert all(issubclass(each, groundslab.NoResult) for each in gaps)
    assert not any(issubclass(each, groundslab.NoEquilibrium) for each in gaps)
    assert issubclass(groundslab.NeutralEquilibrium, groundslab.NoEquilibrium)
    assert not issubclass(groundslab.NoEquilibrium, groundslab.NoResult)
    model = casefile.loads(PAD + combinations(("falls", "ultimate", 1.0)))
    with pytest.raises(groundslab.NoEquilibrium, match="topple"):
        groundslab.solve(model)


def test_the_workbench_says_it() -> None:
    """The status line, the summary and the combination call it a failure of the foundation."""
    text = PAD + combinations(("stands", "ultimate", 0.5), ("falls", "ultimate", 1.0))
    answer, _, _ = process.solve(text, process.Progress(lambda *_: None))
    assert answer.refused["falls"].startswith("FOUNDATION FAILS: the loads topple the plate")
    assert answer.summary["design"]["status"] == "fails"
    assert answer.summary["design"]["headline"].startswith("FOUNDATION FAILS")
    assert answer.summary["combinations"][1]["refused"] == answer.refused["falls"]
    answer, _, _ = process.solve(PAD + combinations(("falls", "ultimate", 1.0)), process.Progress(lambda *_: None))
    assert answer.summary["design"]["headline"].startswith("FOUNDATION FAILS")
    assert {"combinations", "checks"} <= set(answer.tables)


def test_ground_that_yields_under_all_of_the_slab(case: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """75 kN on 6 m2 are more than a limit pressure of 12 kPa carries, 72 kN: bearing fails, whatever else."""
    text = PAD + combinations(("ULS", "ultimate", 0.0)) + '[contact]\nlimit_pressure = "12 kPa"\n'
    assert solved(case, text) == 3
    first = " ".join(capsys.readouterr().out.splitlines()[:3])
    assert "the loads of 75 kN are more than ground and supports can carry at their limits, 72 kN" in first


def test_json_of_a_check_that_nothing_resists() -> None:
    """An infinite utilization is no number of JSON; the row is written all the same."""
    check_of = json_summary._check(DesignCheck("sliding", "fails", "30 kN against 0", demand=30.0, resistance=0.0))
    assert check_of["utilization"] is None
    assert json.loads(json.dumps(check_of, allow_nan=False))["demand"] == 30.0
