"""The command line: what goes where, and which exit code comes back."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import tomllib
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import ezdxf
import pytest

import groundslab
from groundslab.analysis import adaptivity, driver
from groundslab.case import casefile
from groundslab.cli import console, main
from groundslab.errors import InputError, Issue, NoEquilibrium, NotCertified, NotConverged, SingularMatrix
from groundslab.model.combinations import as_solved, list_combinations
from groundslab.model.settings import Mesh
from groundslab.model.structure.columns import Column
from groundslab.model.supports import LineSupport, PointSupport
from groundslab.results.records import MeshHistory
from groundslab.results.results import Results, results_of
from groundslab.views.files import npz, results_folder
from groundslab.views.summary import progress
from helpers import synthetic

#: A slab whose first mesh is too coarse for what is asked.
WHEEL = """
[plate]
length_x = "8 m"
length_y = "6 m"
thickness = "0.15 m"
E = "30 GPa"
nu = 0.2

[ground]
kind = "winkler"
k = "20 MN/m^3"

[[loads]]
kind = "point"
P = "400 kN"
x = "0.9 m"
y = "0.4 m"
width_x = "0.3 m"
width_y = "0.3 m"

[mesh]
accuracy = "1 %"
"""


def fake(monkeypatch: pytest.MonkeyPatch, name: str, **contents: Any) -> None:
    """Put a module of made-up contents in the place of one of the package's."""
    module = ModuleType(f"groundslab.{name}")
    vars(module).update(contents)
    monkeypatch.setitem(sys.modules, f"groundslab.{name}", module)
    parent, _, leaf = name.rpartition(".")
    monkeypatch.setattr(import_module(f"groundslab.{parent}"), leaf, module, raising=False)


def solver(outcome: Any) -> Any:
    """Return a stand-in for the analysis, which reports one step and then returns or raises the outcome."""

    def solve(model: Any, on_step: Any = None, on_combination: Any = None, *_: Any) -> Any:
        (combination,) = list_combinations(model)
        if on_combination is not None:
            on_combination(combination)
        if on_step is not None:
            on_step(synthetic.results().steps[0])
        if isinstance(outcome, BaseException):
            raise outcome
        results = replace(outcome, model=model, solved_model=as_solved(model))
        if not results.certificate.holds:
            raise NotCertified(results)
        return results_of(results)

    return solve


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """Return a case file."""
    path = tmp_path / "raft.toml"
    path.write_text(casefile.to_toml(synthetic.model()), encoding="utf-8")
    return path


@pytest.fixture
def solved(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the analysis return made-up results."""
    fake(monkeypatch, "analysis.driver", solve=solver(synthetic.results()))


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    """Run the command line in a process of its own."""
    return subprocess.run([sys.executable, "-m", "groundslab", *arguments], capture_output=True, text=True, check=False)


@pytest.mark.usefixtures("solved")
class TestSolve:
    """groundslab solve."""

    def test_keeps_results_beside_the_case(self, case: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """Without --out the folder is named after the case; the summary goes to standard output."""
        assert main.main(["solve", str(case)]) == 0
        out, err = capsys.readouterr()
        assert "largest settlement" in out
        assert "raft-results" in err
        read = npz.load(case.with_name("raft-results") / "results.npz")
        synthetic.assert_same(read, synthetic.results())

    @pytest.mark.slow
    def test_json_is_alone_on_standard_output(self, case: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """Standard output is one JSON document, and standard error is silent without a terminal."""
        assert main.main(["solve", str(case), "--json", "--out", str(case.parent / "o"), "--plot"]) == 0
        out, err = capsys.readouterr()
        assert json.loads(out)["certified"] is True
        assert err == ""
        assert (case.parent / "o" / "picture.png").exists()

    def test_a_design_that_fails_has_the_last_word(
        self, case: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """A design that fails ends with 3; that it does is the last word, and among the first lines."""
        model = synthetic.model().replace(
            cases=[{"name": "G"}],
            loads=[{"kind": "uniform", "q": 1e3, "case": "G"}],
            combinations=[{"name": "ULS", "factors": {"G": 1.35}}],
            reinforcement={"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)},
        )
        case.write_text(casefile.to_toml(model), encoding="utf-8")
        made = synthetic.results(combination="ULS", limit_state="ultimate", factors=(("G", 1.35),))
        made = replace(made, plate=replace(made.plate, moment_x=made.plate.moment_x + 20e6))
        fake(monkeypatch, "analysis.driver", solve=solver(made))
        assert main.main(["solve", str(case)]) == 3
        out, err = capsys.readouterr()
        assert out.splitlines()[0].startswith("DESIGN FAILS: bending; 1 of")
        assert err.splitlines()[-1].startswith("DESIGN FAILS: bending; 1 of")
        assert "exit code 3" in err.splitlines()[-1]

    def test_quiet_says_nothing(self, case: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """Results are kept, nothing is printed."""
        assert main.main(["solve", str(case), "--quiet"]) == 0
        assert capsys.readouterr() == ("", "")
        assert (case.parent / "raft-results" / "summary.json").exists()

    def test_an_uncertified_result_is_no_success(
        self, case: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """A certificate that fails gives exit code 1, a message, and results that say so."""
        bad = replace(synthetic.CERTIFICATE, residual=1.0)
        fake(monkeypatch, "analysis.driver", solve=solver(synthetic.results(certificate=bad)))
        assert main.main(["solve", str(case)]) == 1
        out, err = capsys.readouterr()
        assert "FAILED" in out
        assert "it must not be used" in err
        assert json.loads((case.parent / "raft-results" / "summary.json").read_text())["certified"] is False

    @pytest.mark.parametrize(
        ("outcome", "code", "words"),
        [
            (NotConverged("contact", list(synthetic.results().steps), {}), 1, "Convergence history"),
            (NotConverged("gamma", [1.1, 1.2], {}), 1, "gamma did not converge in 2 steps"),
            (NotConverged("contact", [{"iteration": 1, "changed": 61}], {}), 1, "  iteration 1, changed 61"),
            (InputError([Issue("mesh", "a", "b")]), 2, "mesh"),
            (MemoryError(), 1, "memory"),
            (KeyboardInterrupt(), 130, "interrupted"),
        ],
    )
    def test_what_the_analysis_raises(
        self,
        case: Path,
        monkeypatch: pytest.MonkeyPatch,
        capsys: pytest.CaptureFixture[str],
        outcome: BaseException,
        code: int,
        words: str,
    ) -> None:
        """Each failure has its exit code and a message on standard error; nothing is written."""
        fake(monkeypatch, "analysis.driver", solve=solver(outcome))
        assert main.main(["solve", str(case)]) == code
        out, err = capsys.readouterr()
        assert out == ""
        assert words in err
        assert [path.name for path in case.parent.iterdir()] == ["raft.toml"]

    def test_asks_for_the_folder_before_the_analysis(self, case: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """A folder with foreign files is refused before any time is spent."""
        fake(monkeypatch, "analysis.driver", solve=solver(AssertionError("solved in vain")))
        (case.parent / "out").mkdir()
        (case.parent / "out" / "notes.txt").touch()
        assert main.main(["solve", str(case), "--out", str(case.parent / "out")]) == 2

    def test_the_case_file_is_never_replaced(self, case: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """A case inside the folder of its results is refused, since the folder is replaced as a whole."""
        assert main.main(["solve", str(case), "--quiet"]) == 0
        inner = case.parent / "raft-results" / "case.toml"
        assert main.main(["solve", str(inner), "--out", str(inner.parent)]) == 2
        assert "holds the case file" in capsys.readouterr().err

    def test_the_summary_survives_a_full_disk(
        self, case: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """If the results cannot be written they are at least shown."""

        def full(*_: Any, **__: Any) -> None:
            raise InputError([Issue("disk", "no room", "room")])

        monkeypatch.setattr(results_folder, "save_results", full)
        assert main.main(["solve", str(case)]) == 2
        out, err = capsys.readouterr()
        assert "largest settlement" in out
        assert "no room" in err

    def test_results_are_kept_elsewhere(
        self, case: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """If somebody puts a file into the folder during the analysis, the results are kept beside it."""
        driver = sys.modules["groundslab.analysis.driver"]
        solve = driver.solve
        folder = case.with_name("raft-results")

        def disturbed(*arguments: Any) -> Any:
            folder.mkdir()
            (folder / "notes.txt").write_text("mine")
            return solve(*arguments)

        monkeypatch.setattr(driver, "solve", disturbed)
        assert main.main(["solve", str(case)]) == 2
        out, err = capsys.readouterr()
        assert "largest settlement" in out
        assert "notes.txt" in err
        assert f"the results are kept in {case.with_name('raft-results-2')}" in err
        assert [path.name for path in folder.iterdir()] == ["notes.txt"]
        synthetic.assert_same(npz.load(case.with_name("raft-results-2") / "results.npz"), synthetic.results())

    def test_progress_is_told_on_terminals_and_in_files(
        self, case: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """On one line of a terminal, else as lines on standard error; with --quiet nowhere."""
        found = []

        def solve(model: Any, on_step: Any = None, on_combination: Any = None, *_: Any) -> Any:
            assert (on_step is None) == (on_combination is None)
            found.append(on_step)
            if on_step is not None:
                on_step(synthetic.results().steps[0])
            return results_of(replace(synthetic.results(), model=model, solved_model=as_solved(model)))

        fake(monkeypatch, "analysis.driver", solve=solve)
        words = "340 unknowns, load 1, contact 1: 25 closed, 8 changed"
        main.main(["solve", str(case)])
        assert words not in capsys.readouterr().err
        monkeypatch.setattr(progress, "INTERVAL", 0.0)
        main.main(["solve", str(case), "--json"])
        out, err = capsys.readouterr()
        assert f"0 s: mesh 1: {words}\n" in err
        assert json.loads(out)["certified"]
        monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
        main.main(["solve", str(case)])
        assert f"0 s: mesh 1: {words}\n" not in capsys.readouterr().err
        main.main(["solve", str(case), "--quiet"])
        assert [callback is not None for callback in found] == [True, True, True, False]


@pytest.fixture
def cases(tmp_path: Path) -> Path:
    """Return a case file of four combinations."""
    path = tmp_path / "raft.toml"
    path.write_text(casefile.to_toml(synthetic.combined().model), encoding="utf-8")
    return path


class TestSeveral:
    """groundslab solve, with several combinations."""

    def certified(self) -> Results:
        """Return the combinations that have certified results alone."""
        combined = synthetic.combined()
        return replace(combined, combinations=combined.combinations[:2], refused={})

    def test_all_solved(self, cases: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
        """If all have certified results the exit code is 0, and a folder for each is kept."""
        fake(monkeypatch, "analysis.driver", solve=lambda *_: self.certified())
        assert main.main(["solve", str(cases)]) == 0
        out, err = capsys.readouterr()
        assert "1.35 dead + 1.5 wind" in out
        assert "FAILED" not in out
        assert "error" not in err
        assert (
            results_folder.load_results(cases.with_name("raft-results")).results.keys()
            == self.certified().results.keys()
        )

    def test_refused_ones_are_told_and_the_others_kept(
        self, cases: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """Of one that the program cannot solve and one that lifts off the latter gives the code; both are told."""
        fake(monkeypatch, "analysis.driver", solve=lambda *_: synthetic.combined())
        assert main.main(["solve", str(cases)]) == 3
        out, err = capsys.readouterr()
        assert out.startswith("FOUNDATION FAILS (1 of 3 checks fails): static equilibrium: none in ")
        assert "FOUNDATION FAILS: the loads pull the plate off" in out
        assert "not solved: the result does not satisfy the equations" in out
        assert 'error: combination "uncertified": the result does not satisfy the equations' in err
        assert "error: 1 of 4 combinations have no certified result" in err
        assert 'none in "wind alone": the loads pull the plate off. Not judged: 2 of 3 (unsolved ' in err
        assert "combinations, edges that hold down). Exit code 3." in err
        assert len(results_folder.load_results(cases.with_name("raft-results")).results) == 2

    def test_json_and_quiet(
        self, cases: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """One JSON document holds all combinations; with --quiet only what was refused is reported."""
        fake(monkeypatch, "analysis.driver", solve=lambda *_: synthetic.combined())
        assert main.main(["solve", str(cases), "--json"]) == 3
        document = json.loads(capsys.readouterr().out)
        assert document["certified"] is False
        assert [each["certified"] for each in document["combinations"]] == [True, True, False, False]
        assert main.main(["solve", str(cases), "--quiet"]) == 3
        out, err = capsys.readouterr()
        assert out == ""
        assert err.count("error") == 2
        assert 'FOUNDATION FAILS: combination "wind alone": the loads pull the plate off' in err

    def test_none_solved(
        self, cases: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """Where the program solves nothing, nothing is written, and earlier results stay."""
        refused = {each.name: SingularMatrix("up it goes") for each in synthetic.combined().combinations}
        nothing = replace(synthetic.combined(), results={}, refused=refused)
        fake(monkeypatch, "analysis.driver", solve=lambda *_: nothing)
        assert main.main(["solve", str(cases)]) == 1
        out, err = capsys.readouterr()
        assert out == ""
        assert err.count("up it goes") == 4
        assert not cases.with_name("raft-results").exists()

    def test_a_real_one(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """Cases by themselves: the one that lifts the plate off has no equilibrium, the other is solved and kept."""
        model = synthetic.combined().model.replace(combinations=(), mesh=Mesh(counts=(4, 4)))
        (tmp_path / "raft.toml").write_text(casefile.to_toml(model), encoding="utf-8")
        assert main.main(["solve", str(tmp_path / "raft.toml")]) == 3
        assert "each load case is solved by itself" in capsys.readouterr().err
        found = results_folder.load_results(tmp_path / "raft-results")
        assert list(found.results) == ["dead"]
        assert isinstance(found.refused["wind"], NoEquilibrium)
        assert found["dead"].certificate.load == pytest.approx(1e3 * 9.6 * 7.2)


class TestInput:
    """Wrong input."""

    def test_faults_are_blocks(self) -> None:
        """Each issue shows where, found, expected and a hint, one below the other."""
        text = console.format_issues(
            InputError([Issue("plate.E", "30", "a pressure", 'say "30 GPa"'), Issue("a", "b", "c")])
        )
        assert text.splitlines() == [
            "error: 2 issues in the input",
            "",
            "  plate.E",
            "    found     30",
            "    expected  a pressure",
            '    hint      say "30 GPa"',
            "",
            "  a",
            "    found     b",
            "    expected  c",
        ]

    @pytest.mark.parametrize("command", ["solve", "check"])
    def test_all_faults_of_a_file_come_at_once(
        self, tmp_path: Path, capsys: pytest.CaptureFixture[str], command: str
    ) -> None:
        """Exit code 2 and every issue on standard error, no traceback."""
        (tmp_path / "bad.toml").write_text("[plate]\nlength_x = 3\nthick = 1\n")
        assert main.main([command, str(tmp_path / "bad.toml")]) == 2
        out, err = capsys.readouterr()
        assert out == ""
        assert "plate.length_x" in err
        assert "plate.thick" in err
        assert "Traceback" not in err

    def test_a_missing_file(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """A case file that is not there gives exit code 2 and its name."""
        assert main.main(["solve", str(tmp_path / "none.toml")]) == 2
        assert "none.toml" in capsys.readouterr().err

    @pytest.mark.parametrize("arguments", [[], ["fly"], ["solve"], ["solve", "a", "--fast"]])
    def test_wrong_usage(self, arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
        """Unknown commands and options and missing arguments end with exit code 2."""
        with pytest.raises(SystemExit) as caught:
            main.main(arguments)
        assert caught.value.code == 2
        assert "usage" in capsys.readouterr().err


class TestOthers:
    """check, new, verify, schema and the bare program."""

    def test_check_names_what_it_read(self, case: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """A file without issues is called fine."""
        assert main.main(["check", str(case)]) == 0
        assert "fine (9.6 m x 7.2 m plate, winkler ground, 3 loads)" in capsys.readouterr().out

    def test_check_names_the_structure_supports_and_combinations(
        self, tmp_path: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """Each column, wall, beam, support, case and combination has its line, with sizes, places and factors."""
        model = synthetic.combined().model.replace(
            columns=[Column(name="A1", x=1, y=2, width_x=0.3, width_y=0.4), Column(name="B", x=0, y=0, diameter=0.5)],
            supports=[
                PointSupport(name="pile", x=-2, y=-1, stiffness=5e7, acts="in compression"),
                LineSupport(points=[(-3, 1), (-1, 1)]),
            ],
            walls=[
                {"name": "W", "thickness": 0.3, "points": [(-2, 0), (2, 0)]},
                {"name": "V", "thickness": 0.3, "points": [(0, -2), (0, 2)], "height": 3.0, "stiffness": 0.5,
                 "openings": [{"start": 1.0, "end": 2.0, "height": 2.2}]},
            ],
            beams=[
                {"name": "R", "points": [(-2, 3), (2, 3)], "stiffness": 0.7,
                 "section": {"kind": "rib", "width": 0.4, "height": 0.6, "eccentric": True}},
                {"name": "S", "points": [(-2, -3), (2, -3)],
                 "section": {"kind": "properties", "second_moment": 2e-4, "shear_area": 3e-3}},
            ],
        )  # fmt: skip
        (tmp_path / "raft.toml").write_text(casefile.to_toml(model), encoding="utf-8")
        assert main.main(["check", str(tmp_path / "raft.toml")]) == 0
        assert capsys.readouterr().out.splitlines()[1:] == [
            "  column A1: 0.3 m x 0.4 m at (1, 2) m",
            "  column B: diameter 0.5 m at (0, 0) m",
            "  wall W: 0.3 m thick, 4 m long",
            "  wall V: 0.3 m thick, 4 m long, a deep beam 3 m high, 50 % of its stiffness, an opening 2.2 m high "
            "from 1 m to 2 m",
            "  beam R: rib of 0.4 m x 0.6 m, eccentric, 4 m long, 70 % of its stiffness",
            "  beam S: a section by its properties, 4 m long",
            "  support pile: point, elastic, acts in compression, at (-2, -1) m",
            "  support 2: line, rigid, acts both ways, at (-3, 1) to (-1, 1) m",
            "  case dead: permanent, 1 load; ultimate 1 to 2 (3 of 4)",
            "  case wind: variable, 1 load; ultimate 1 to 1.5 (2 of 4)",
            "  sum of case dead: F = 69.12 kN, M_x = 0 kNm, M_y = 0 kNm about (0, 0) m",
            "  sum of case wind: F = -100 kN, M_x = -300 kNm, M_y = -200 kNm about (0, 0) m",
            "  combination Größe 1/2: dead + wind (ultimate): 1.35 dead + 1.5 wind",
            "  combination NUL (ultimate): 2 dead",
            "  combination uncertified (ultimate): 1 dead",
            "  combination wind alone (ultimate): 1 wind",
        ]

    def test_new_prints_a_case_that_can_be_read(self, capsys: pytest.CaptureFixture[str]) -> None:
        """Without a file name the text goes to standard output, and it is a valid case."""
        assert main.main(["new"]) == 0
        assert casefile.loads(capsys.readouterr().out) == casefile.loads(casefile.starter())

    def test_new_never_overwrites(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """A file is made where there is none; a second time it is left alone."""
        path = tmp_path / "new.toml"
        assert main.main(["new", str(path)]) == 0
        path.write_text("mine")
        assert main.main(["new", str(path)]) == 2
        assert path.read_text() == "mine"
        assert main.main(["new", str(tmp_path / "no" / "folder.toml")]) == 2
        assert "Traceback" not in capsys.readouterr().err

    @pytest.mark.parametrize(("passes", "code"), [(True, 0), (False, 1)])
    def test_verify_runs_what_is_asked(self, monkeypatch: pytest.MonkeyPatch, passes: bool, code: int) -> None:
        """The named cases run, or all; a case that fails gives exit code 1."""
        asked = []

        def check(names: list[str], _: Any) -> bool:
            asked.append(names)
            return passes

        fake(monkeypatch, "verification.runner", names=lambda: ["a", "b"], run=check)
        assert main.main(["verify", "b"]) == code
        assert main.main(["verify"]) == code
        assert asked == [["b"], ["a", "b"]]

    def test_verify_lists_and_refuses(
        self, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """The names can be listed; an unknown one is wrong input and nothing runs."""
        fake(monkeypatch, "verification.runner", names=lambda: ["a", "b"], run=None)
        assert main.main(["verify", "--list"]) == 0
        assert capsys.readouterr().out == "a\nb\n"
        assert main.main(["verify", "a", "x"]) == 2
        assert '"x"' in capsys.readouterr().err

    def test_schema_is_json(self, capsys: pytest.CaptureFixture[str]) -> None:
        """The schema of a case file is printed as JSON."""
        assert main.main(["schema"]) == 0
        assert "plate" in json.loads(capsys.readouterr().out)["properties"]

    def test_as_a_module(self) -> None:
        """``python -m groundslab`` is the same program."""
        version = run("--version")
        assert version.stdout == f"groundslab {groundslab.__version__}\n"
        assert version.returncode == 0
        assert "solve" in run("--help").stdout

    @pytest.mark.slow
    def test_a_reader_that_goes_away_is_no_failure(self) -> None:
        """A pipe that is closed early gives no traceback and no failure."""
        command = [sys.executable, "-m", "groundslab", "schema"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            assert process.stdout is not None
            assert process.stderr is not None
            process.stdout.close()
            assert process.stderr.read() == ""
        assert process.returncode == 0


#: Runs the program in a process that is interrupted as a module is imported; what comes of the interrupt is turned into
#: an error of another kind if asked for, as libraries with parts in C do. A shell that starts a process in the
#: background has it ignore interrupts; whether this one does is its third argument.
INTERRUPTED = """
import os, signal, sys
module, turned = sys.argv[1], sys.argv[2] == "True"
signal.signal(signal.SIGINT, signal.SIG_IGN if sys.argv[3] == "True" else signal.default_int_handler)
class Interrupting:
    def find_spec(self, name, *_):
        if name != module:
            return None
        try:
            os.kill(os.getpid(), signal.SIGINT)
            for _ in range(10**6):
                pass
        except KeyboardInterrupt:
            if not turned:
                raise
            try:
                raise ValueError("Traceback")
            except ValueError:
                sys.excepthook(*sys.exc_info())
            raise ImportError("half imported") from None
sys.meta_path.insert(0, Interrupting())
sys.argv[1:] = sys.argv[4:]
from groundslab.__main__ import main
sys.exit(main())
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of this kind are POSIX")
class TestProgram:
    """The program as the system sees it: streams and signals."""

    @pytest.mark.slow
    @pytest.mark.parametrize(
        ("module", "turned"), [("groundslab.cli.main", False), ("argparse", True), ("numpy", False)]
    )
    def test_an_interrupt_while_something_is_imported(self, case: Path, module: str, turned: bool) -> None:
        """The program ends with 130, or by the signal, which a shell calls so; one line says it, with no traceback."""
        ended = self.interrupt(module, turned, False, "solve", str(case), "--quiet")
        assert ended.returncode in (130, -signal.SIGINT), ended.stderr
        assert ended.stderr.split("\n")[-2:] == ["interrupted", ""] or (turned and ended.stderr)
        assert "Traceback" not in ended.stderr

    @pytest.mark.slow
    def test_a_program_in_the_background_is_not_interrupted(self) -> None:
        """Started by a shell that has it ignore Ctrl-C, which is meant for another program, it goes on to its end."""
        ended = self.interrupt("groundslab.cli.main", False, True, "--version")
        assert (ended.returncode, ended.stderr) == (0, "")
        assert ended.stdout == f"groundslab {groundslab.__version__}\n"

    @staticmethod
    def interrupt(module: str, turned: bool, ignoring: bool, *arguments: str) -> subprocess.CompletedProcess[str]:
        """Return what became of the program with these arguments, interrupted as it imports a module."""
        command = [sys.executable, "-c", INTERRUPTED, module, str(turned), str(ignoring), *arguments]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    @pytest.mark.slow
    @pytest.mark.parametrize(
        ("closed", "commands"),
        [
            (">&-", ["solve"]),
            ("2>&-", ["missing"]),
            ("2>&- >&- <&-", ["fly"]),
            ("2>/dev/full", ["solve", "missing"]),
        ],
    )
    def test_closed_streams(self, case: Path, closed: str, commands: list[str]) -> None:
        """What cannot be said changes neither the exit code nor the results; closed streams are opened in one place."""
        if "full" in closed and not Path("/dev/full").exists():
            pytest.skip("needs a device that is full")
        arguments = {"solve": ["solve", str(case)], "missing": ["solve", f"{case}.none"], "fly": ["fly"]}
        for name in commands:
            command = ["sh", "-c", f'exec "$0" -m groundslab "$@" {closed}', sys.executable, *arguments[name]]
            ended = subprocess.run(command, capture_output=True, check=False)
            assert ended.returncode == (0 if name == "solve" else 2), name
        if "solve" in commands:
            assert len(results_folder.load_results(case.with_name("raft-results")).results) == 1

    @pytest.mark.slow
    def test_an_answer_that_cannot_be_given(self, case: Path) -> None:
        """Where the answer itself cannot be written the exit code says so; the results are in their folder."""
        if not Path("/dev/full").exists():
            pytest.skip("needs a device that is full")
        command = ["sh", "-c", 'exec "$0" -m groundslab "$@" > /dev/full', sys.executable, "solve", str(case)]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        assert ended.returncode == 2
        assert ended.stderr.splitlines()[-1].startswith("error: ")
        assert "Traceback" not in ended.stderr
        assert len(results_folder.load_results(case.with_name("raft-results")).results) == 1


@pytest.fixture
def drawing(tmp_path: Path) -> Path:
    """Return a drawing of a square plate of 4 m, a hole in it, and a load."""
    document = ezdxf.new("R2010", units=6)
    space = document.modelspace()
    document.layers.add("SLAB")
    for layer, x0, x1 in (("SLAB", 0, 4), ("OPENINGS", 1, 2)):
        corners = [(x0, x0), (x1, x0), (x1, x1), (x0, x1)]
        space.add_lwpolyline(corners, close=True, dxfattribs={"layer": layer})
    space.add_point((3, 3), {"layer": "LOADS"})
    space.add_text("50 kN", height=0.1, dxfattribs={"layer": "LOADS", "insert": (3.1, 3)})
    document.saveas(tmp_path / "plan.dxf")
    return tmp_path / "plan.dxf"


class TestDxf:
    """groundslab dxf."""

    def test_case_and_report_go_apart(self, drawing: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """The case alone is on standard output, named after the drawing; the report is on standard error."""
        assert main.main(["dxf", str(drawing), "--layers", "outline=slab"]) == 0
        out, err = capsys.readouterr()
        case = tomllib.loads(out)
        assert case["title"] == "plan"
        assert case["plate"]["outline"]["points"][2] == ["4 m", "4 m"]
        assert len(case["plate"]["openings"]) == 1
        assert case["loads"][0]["P"] == "50 kN"
        assert "outline: 4 m x 4 m" in err

    @pytest.mark.slow
    def test_layers_and_unit_count(self, drawing: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """Layers given together or apart are followed, an empty name takes none; the given unit wins."""
        arguments = ["--layers", "outline=SLAB", "openings=", "--unit", "ft", "--layers", "point_loads="]
        assert main.main(["dxf", str(drawing), *arguments]) == 0
        out, err = capsys.readouterr()
        case = tomllib.loads(out)
        assert case["plate"].keys() == {"outline"}
        assert "loads" not in case
        assert case["plate"]["outline"]["points"][1] == ["1.2192 m", "0 m"]
        assert "unit: ft" in err

    def test_gaps_that_are_closed(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """--close-gaps closes wider gaps, and the report names them; a width without a unit is refused."""
        document = ezdxf.new(units=6)
        for start, end in (((0, 0), (4, 0.003)), ((4, 0), (4, 3)), ((4, 3), (0, 0))):
            document.modelspace().add_line(start, end, {"layer": "OUTLINE"})
        path = str(tmp_path / "plan.dxf")
        document.saveas(path)
        assert main.main(["dxf", path]) == 2
        assert "a gap of 0.003 m" in capsys.readouterr().err
        assert main.main(["dxf", path, "--close-gaps", "5 mm"]) == 0
        assert "layer OUTLINE: a gap of 0.003 m was closed at (4, 0.003) m" in capsys.readouterr().err
        assert main.main(["dxf", path, "--close-gaps", "5"]) == 2
        assert 'a length such as "1 mm"' in capsys.readouterr().err

    def test_never_overwrites(self, drawing: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """A file is made where there is none; a second time it is left alone."""
        path = drawing.with_name("case.toml")
        arguments = ["dxf", str(drawing), "--layers", "outline=SLAB", "--out", str(path)]
        assert main.main(arguments) == 0
        out, err = capsys.readouterr()
        assert out == ""
        assert err.splitlines()[-1].startswith(f"wrote {path}; next:")
        assert tomllib.loads(path.read_text(encoding="utf-8"))["title"] == "plan"
        path.write_text("mine")
        assert main.main(arguments) == 2
        assert path.read_text() == "mine"
        assert "a file that exists" in capsys.readouterr().err

    def test_wrong_words_for_layers(self, drawing: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """All that cannot be understood comes at once, with the words that there are."""
        layers = ["outlines=SLAB", "SLAB", "zones=A", "zones=B"]
        assert main.main(["dxf", str(drawing), "--layers", *layers]) == 2
        out, err = capsys.readouterr()
        assert out == ""
        for words in ("3 issues", '"outlines=SLAB"', 'did you mean "outline"?', '"SLAB"', "zones twice", "point_loads"):
            assert words in err

    def test_a_wrong_drawing(self, drawing: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """A drawing without an outline ends with code 2 and the layers that it has; no file is made."""
        assert main.main(["dxf", str(drawing), "--out", str(drawing.with_name("case.toml"))]) == 2
        assert '"SLAB"' in capsys.readouterr().err
        assert not drawing.with_name("case.toml").exists()

    def test_without_ezdxf(
        self, drawing: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """A missing ezdxf is reported with the command that installs it."""
        for name in [name for name in sys.modules if name.partition(".")[0] == "ezdxf"]:
            monkeypatch.setitem(sys.modules, name, None)
        assert main.main(["dxf", str(drawing)]) == 2
        assert "pip install groundslab[dxf]" in capsys.readouterr().err


class TestPackage:
    """import groundslab."""

    def test_is_cheap(self) -> None:
        """Neither the package nor its command line loads anything but the standard library."""
        code = (
            "import sys; before = set(sys.modules); import groundslab.cli.main; import groundslab; "
            "heavy = {'numpy', 'scipy', 'pint', 'pydantic', 'rich', 'matplotlib'}; "
            "assert not heavy & (set(sys.modules) - before)"
        )
        subprocess.run([sys.executable, "-c", code], check=True)

    def test_public_names_lead_home(self) -> None:
        """Every public name can be had, is what its module calls so, and is listed by dir()."""
        for name in groundslab.__all__:
            assert getattr(groundslab, name) is not None
        assert groundslab.load is casefile.load
        assert groundslab.InputError is InputError
        assert set(groundslab.__all__) <= set(dir(groundslab))

    def test_other_names_do_not_exist(self) -> None:
        """A name that is not public is an AttributeError, as in any module."""
        with pytest.raises(AttributeError, match="nothing"):
            _ = groundslab.nothing


@pytest.mark.slow
def test_a_run_that_is_interrupted_leaves_the_last_finished_mesh(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Next to the folder; a run that ends removes it, unless a file in it was edited."""
    case = tmp_path / "wheel.toml"
    case.write_text(WHEEL, encoding="utf-8")
    refine = adaptivity.join

    def interrupt(*_: Any) -> Any:
        raise KeyboardInterrupt

    monkeypatch.setattr(adaptivity, "join", interrupt)
    assert main.main(["solve", str(case)]) == 130
    kept = tmp_path / "wheel-results-provisional"
    told = capsys.readouterr().err
    assert told.startswith("Provisional: mesh 1 (")
    assert "1 % asked for" in told
    assert str(kept) in told
    assert not (tmp_path / "wheel-results").exists()
    first = groundslab.load_results(kept).only
    assert first.provisional
    monkeypatch.setattr(adaptivity, "join", refine)
    assert main.main(["solve", str(case), "--quiet"]) == 0
    assert not kept.exists()
    last = groundslab.load_results(tmp_path / "wheel-results").only
    assert not last.provisional
    assert last.unknowns > first.unknowns


#: The program, which does nothing more once it has results on its first mesh.
STUCK = """
import sys, threading
from groundslab.analysis import adaptivity
from groundslab.cli import main
adaptivity.join = lambda *_: threading.Event().wait()
sys.exit(main.main(sys.argv[1:]))
"""


@pytest.mark.slow
def test_a_run_that_is_killed_is_resumed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Killed on its second mesh without a chance to clean up, it leaves results on the first one, marked as such.

    Resumed, it goes on from there, solves no mesh again, and ends as if it had never stopped.
    """
    case, kept = tmp_path / "wheel.toml", tmp_path / "wheel-results-provisional"
    case.write_text(WHEEL.replace("1 %", "0.3 %"), encoding="utf-8")
    command = ["solve", str(case), "--resume"]
    with subprocess.Popen([sys.executable, "-c", STUCK, *command], stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        assert process.stderr.readline().startswith("nothing to resume: found no summary.json that names its files")
        assert process.stderr.readline().startswith("Provisional: mesh 1 (")
        process.kill()
    assert process.returncode == (-signal.SIGKILL if hasattr(signal, "SIGKILL") else 1)
    assert not (tmp_path / "wheel-results").exists()
    found = groundslab.load_results(kept)
    assert found.provisional
    assert found.only.certificate.holds
    assert found.only.mesh_history is not None
    assert found.only.mesh_history.unknowns == (found.only.unknowns,)
    assert json.loads((kept / "summary.json").read_text())["provisional"] is True
    assert main.main(["report", str(kept), "--out", str(tmp_path / "report.html")]) == 0
    assert "Provisional: mesh 1 (" in (tmp_path / "report.html").read_text(encoding="utf-8")
    capsys.readouterr()
    assert main.main(command) == 0
    assert capsys.readouterr().err.startswith("Provisional: mesh 1 (")
    assert not kept.exists()
    resumed = groundslab.load_results(tmp_path / "wheel-results").only
    assert main.main(["solve", str(case), "--quiet", "--out", str(tmp_path / "whole")]) == 0
    assert not (tmp_path / "whole-provisional").exists()
    whole = groundslab.load_results(tmp_path / "whole").only
    assert resumed.mesh_history is not None
    assert whole.mesh_history is not None
    assert resumed.mesh_history.unknowns == whole.mesh_history.unknowns
    assert resumed.mesh_history.end == whole.mesh_history.end
    assert dict(resumed.mesh_history.before) == pytest.approx(dict(whole.mesh_history.before), rel=1e-6)
    assert len(whole.mesh_history.unknowns) > 2
    assert (resumed.plate.nodes == whole.plate.nodes).all()
    assert resumed.plate.moment_x == pytest.approx(whole.plate.moment_x, rel=1e-9, abs=1e-6)


class TestResume:
    """groundslab solve --resume, where an interrupted run has left results."""

    @pytest.fixture
    def left(self, case: Path) -> Path:
        """Return the folder with provisional results of the case."""
        results = replace(synthetic.results(), mesh_history=MeshHistory((1234,)))
        path = results_folder.save_provisional(results_of(results), case.with_name("raft-results"))
        assert path is not None
        return path

    @pytest.fixture
    def started(self, monkeypatch: pytest.MonkeyPatch) -> list[Results | None]:
        """Return what each analysis starts from; it returns made-up results."""
        starts: list[Results | None] = []

        def solve(model: Any, _step: Any, _combination: Any, _mesh: Any, start: Results | None) -> Any:
            starts.append(start)
            return results_of(replace(synthetic.results(), model=model, solved_model=as_solved(model)))

        monkeypatch.setattr(driver, "solve", solve)
        return starts

    def test_starts_from_what_is_left(self, case: Path, left: Path, started: list[Results | None]) -> None:
        """And removes it at the end."""
        assert main.main(["solve", str(case), "--resume"]) == 0
        assert started[0] is not None
        assert started[0].only.mesh_history == MeshHistory((1234,))
        assert not left.exists()

    def test_is_offered(
        self, case: Path, left: Path, started: list[Results | None], capsys: pytest.CaptureFixture[str]
    ) -> None:
        """Without the option nothing is taken from there, but it is said that it could be."""
        assert main.main(["solve", str(case)]) == 0
        assert started == [None]
        assert f"{left} is of a run that was interrupted; with --resume" in capsys.readouterr().err
        assert not left.exists()

    def test_of_another_case_starts_anew(
        self, case: Path, left: Path, started: list[Results | None], capsys: pytest.CaptureFixture[str]
    ) -> None:
        """A case that has changed is another one; that is said."""
        text = case.read_text(encoding="utf-8")
        case.write_text(text.replace("thickness", "thickness = '0.45 m' #"), encoding="utf-8")
        assert main.main(["solve", str(case), "--resume"]) == 0
        assert started == [None]
        assert (
            f"nothing to resume: found results of another case in {left}; the run starts anew"
            in capsys.readouterr().err
        )

    def test_of_damaged_results_starts_anew(
        self, case: Path, left: Path, started: list[Results | None], capsys: pytest.CaptureFixture[str]
    ) -> None:
        """What cannot be read is no reason not to solve."""
        (left / "results.npz").write_bytes(b"nothing")
        assert main.main(["solve", str(case), "--resume"]) == 0
        assert started == [None]
        assert "nothing to resume: found " in capsys.readouterr().err


@pytest.mark.slow
def test_the_results_on_each_mesh_can_be_viewed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is kept after each mesh opens as any results do, and says how far that mesh is off."""
    view = pytest.importorskip("groundslab.workbench.server.view")
    case = tmp_path / "wheel.toml"
    case.write_text(WHEEL.replace("1 %", "0.3 %"), encoding="utf-8")
    save, shown = results_folder.save_provisional, []

    def save_and_view(results: Results, folder: Path) -> Path | None:
        path = save(results, folder)
        assert path is not None
        shown.append(view.ResultsView.read(path))
        return path

    monkeypatch.setattr(results_folder, "save_provisional", save_and_view)
    assert main.main(["solve", str(case), "--quiet"]) == 0
    assert len(shown) >= 2
    for number, each in enumerate(shown, start=1):
        ((_, about),) = each.get_current_events()
        assert about["provisional"].startswith(f"Provisional: mesh {number} (")
        assert each.summary["coarse"] == about["provisional"]
        assert each.scene
