"""Groundslab as a library: NumPy's values, SI units, arguments of the wrong kind, types, what wrote the results."""

from __future__ import annotations

import json
import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.errors import InputError
from groundslab.views.summary import environment
from groundslab.views.tables.table import table_of
from helpers import synthetic
from helpers.paths import ROOT

PLATE = gs.Plate(length_x=4, length_y=4, thickness=0.3, E=30e9, nu=0.2)


@pytest.mark.parametrize("kind", [np.float32, np.float64, np.float16, np.int64, np.int32, np.array])
def test_numbers_of_numpy(kind: Any) -> None:
    """A number of any of NumPy's kinds is that number, without a warning: 3e7 of float32 overflowed when compared."""
    value = kind(3e4 if kind is np.float16 else 3e7)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        k = gs.Winkler(k=value).k
    assert (type(k), k) == (float, float(value))


def test_arrays_of_numpy() -> None:
    """Arrays are lists: of pairs, in lists, of distances, flags; what is wrong in them is refused at its place."""
    square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]
    expected = gs.Polygon(points=square)
    assert gs.Polygon(points=np.array(square)) == expected
    assert gs.Polygon(points=[np.array(point, dtype=np.float32) for point in square]) == expected
    assert gs.StraightAxes(first="A", distances=np.array([4.0, 3.5], dtype=np.float32)).distances == (4.0, 3.5)
    assert gs.Contact(tensionless=np.bool_(False)).tensionless is False
    with pytest.raises(InputError, match=r"Polygon.points\[2\]"):
        gs.Polygon(points=np.array([[0.0, 0.0], [np.nan, 0.0], [4.0, 4.0]]))
    with pytest.raises(InputError, match="k0"):
        gs.Pasternak(k0=np.array([1.0, 2.0]), k1=1e6)


def test_values_without_names() -> None:
    """The error tells how it is written with names, in the order of the keys."""
    with pytest.raises(InputError) as error:
        gs.Pasternak(20e6, 10e6)  # type: ignore[call-arg]
    assert str(error.value) == (
        "Pasternak: found 2 values without names, expected values by name; "
        "write Pasternak(k0=20000000.0, k1=10000000.0), if that is what is meant"
    )


WRONG: dict[str, tuple[Any, str]] = {
    "solve": (
        lambda: gs.solve("x.toml"),
        'model: found "x.toml", expected a Model; groundslab.load("x.toml") reads it',
    ),
    "path": (lambda: gs.solve(Path("x.toml")), 'groundslab.load("x.toml") reads it'),
    "compare": (lambda: gs.compare_grounds("x.toml"), 'groundslab.load("x.toml") reads it'),
    "check": (lambda: gs.check(PLATE), "model: found a Plate, expected a Model"),
    "tables": (
        lambda: gs.tables_of(synthetic.results()),
        "found a CombinationResult, expected Results; give the results of all combinations, as groundslab.solve",
    ),
    "design": (
        lambda: gs.check_design(synthetic.results().plate),
        "found a PlateResult, expected Results; it is a part",
    ),
    "bars": (lambda: gs.propose_bars("folder"), 'groundslab.load_results("folder") reads it'),
    "save": (
        lambda: gs.save_results(synthetic.results().plate, "folder"),
        "results: found a PlateResult, expected Results or a CombinationResult; it is a part of results",
    ),
    "plot": (lambda: gs.plot("folder", "settlement"), 'groundslab.load_results("folder") reads it'),
    "evaluate": (lambda: gs.study.evaluate(3), "study: found 3, expected a Study or the name of its folder"),
    "folder": (lambda: gs.study.evaluate("no such folder"), "no such folder"),
}


@pytest.mark.parametrize("name", WRONG)
def test_arguments_of_another_kind(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each is refused in words that say what was given, what is needed and how to get it; nothing is written."""
    monkeypatch.chdir(tmp_path)
    call, words = WRONG[name]
    with pytest.raises(InputError) as error:
        call()
    assert words in str(error.value)
    assert not list(tmp_path.iterdir())


def test_point_data_is_in_si_units() -> None:
    """Names have the SI unit, values are those of the attributes: settlements in m, moments in N m/m."""
    plate = synthetic.results().plate
    data = plate.point_data()
    for name, values in (
        ("settlement w [m]", plate.settlement), ("pressure p [Pa]", plate.pressure),
        ("moment m_x [N m/m]", plate.moment_x), ("rotation beta_x [rad]", plate.rotation_x),
        ("line force f [N/m]", plate.line_force),
    ):  # fmt: skip
        assert np.array_equal(data[name], values), name
    assert not [name for name in data if any(unit in name for unit in ("[mm]", "[k", "[mrad]"))]


def test_frames_say_their_units() -> None:
    """A frame has the table's units in its headings, and by these in attrs."""
    pytest.importorskip("pandas", reason="pandas, the extra tables, is not installed")
    frame = table_of("t", "T", [("settlement", "mm"), ("plate", "")], [(1.5, "A")]).frame()
    assert frame.attrs["units"] == {"settlement [mm]": "mm", "plate": ""}


def test_summary_says_what_wrote_it() -> None:
    """Versions of Python, NumPy, SciPy, and MKL where it is; threads; the commit of the repository it is run from."""
    about = environment.environment(gs.Model(plate=PLATE, ground=gs.Winkler(k=20e6), loads=[gs.UniformLoad(q=1e3)]))
    assert about["versions"]["numpy"] == np.__version__
    assert about["versions"]["python"] == ".".join(map(str, sys.version_info[:3]))
    assert {"scipy"} <= set(about["versions"]) <= {"python", "numpy", "scipy", "mkl"}
    assert about["threads"] >= 1
    head = subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], capture_output=True, text=True, check=False)
    known = head.stdout.strip() if head.returncode == 0 else None
    assert known is None or about["commit"].removesuffix("-dirty") == known


def test_commit_of_an_installed_package(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is that of the address it was installed from; without one it is not known."""
    texts = [json.dumps({"url": "https://example.org", "vcs_info": {"vcs": "git", "commit_id": "abc"}}), "{}", None]

    class Distribution:
        def read_text(self, _: str) -> str | None:
            return texts.pop(0)

    monkeypatch.setattr(environment, "_ROOT", Path("/nowhere"))
    monkeypatch.setattr(environment.metadata, "distribution", lambda _: Distribution())
    assert [environment.commit.__wrapped__() for _ in range(3)] == ["abc", None, None]


@pytest.mark.slow
def test_studies_are_typed(tmp_path: Path) -> None:
    """For a type checker `groundslab.study` is called as documented, and a wrong keyword is an error."""
    pytest.importorskip("mypy", reason="mypy is not installed")
    lines = [
        "import groundslab as gs", "from groundslab.study import StudyFile",
        'found = gs.study("study.toml", workers=4)', "reveal_type(found)", "gs.study.evaluate(found)",
        'gs.study.evaluate("folder")', "print(gs.study.StudyFile, StudyFile)", 'gs.study("study.toml", worker=4)',
    ]  # fmt: skip
    (tmp_path / "user.py").write_text("\n".join(lines), encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file", ROOT / "pyproject.toml", tmp_path / "user.py"]
    output = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT).stdout
    assert 'Revealed type is "groundslab.study.evaluation.study.Study"' in output
    errors = [line for line in output.splitlines() if "error:" in line]
    assert len(errors) == 1, output
    assert "user.py:8" in errors[0]
    assert "worker" in errors[0]
