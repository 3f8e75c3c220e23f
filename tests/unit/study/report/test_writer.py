"""A small study from its rows on the disk to its page, its tables and its design points, with answers known by hand."""

from __future__ import annotations

import csv
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy import stats

pytest.importorskip("jinja2")
pytest.importorskip("openturns")

import groundslab
from groundslab import Mesh, Model, Plate, UniformLoad, Winkler
from groundslab.case import casefile
from groundslab.cli.main import main
from groundslab.errors import InputError
from groundslab.study.definition.schema import StudyFile
from groundslab.study.evaluation.form import reliability
from groundslab.study.evaluation.samples import read_samples
from groundslab.study.evaluation.study import Study
from groundslab.study.report import writer
from groundslab.study.report.writer import evaluate, tables_of

pytestmark = pytest.mark.slow

#: Under an even load on even springs the plate settles by q / k, whatever its stiffness.
CASE = Model(
    title="Even load <b>",
    plate=Plate(length_x=4.0, length_y=2.0, thickness=0.3, E=30e9, nu=0.2),
    ground=Winkler(k=20e6),
    loads=[UniformLoad(q=50e3)],
    mesh=Mesh(size=2.0),
)
#: Lognormal load over lognormal spring: ln w = ln q - ln k is normal.
COV_Q, COV_K = 0.2, 0.3
Q = {"path": "loads[1].q", "name": "q", "distribution": {"kind": "lognormal", "mean": 50e3, "cov": COV_Q}}
K = {"path": "ground.k", "name": "k", "distribution": {"kind": "lognormal", "mean": 20e6, "cov": COV_K}}
T = {"path": "plate.thickness", "name": "t", "values": [0.2, 0.4], "choose": True}
SOFT = {"name": "w", "of": "settlement", "take": "largest"}
MAP = {"name": "all w", "of": "settlement", "take": "everywhere"}
LIMIT = {"name": "too soft", "keep": "w", "at_most": 5e-3, "target": 0.05}


def run(folder: Path, kind: str, count: int | None, vary: list[Any], **more: Any) -> Study:
    """Run a study of the case."""
    sampling: dict[str, Any] = {"kind": kind} | ({} if count is None else {"count": count})
    keep = more.pop("keep", [SOFT, MAP])
    limits = more.pop("limit_state", [LIMIT])
    file = StudyFile(case="", seed=5, sampling=sampling, vary=vary, keep=keep, limit_state=limits, **more)
    study: Study = groundslab.study.run(file, case=CASE, out=folder / "study", workers=0, quiet=True)
    return study


def logs() -> tuple[float, float, float]:
    """Return mean of ln w, and the standard deviations of ln q and ln k."""
    s_q, s_k = np.sqrt(np.log1p(COV_Q**2)), np.sqrt(np.log1p(COV_K**2))
    return float(np.log(50e3) - s_q**2 / 2 - np.log(20e6) + s_k**2 / 2), float(s_q), float(s_k)


def exact_beta(rho: float = 0.0) -> float:
    """Return the reliability index of w <= 5 mm: the distance of ln 5 mm from the mean of ln w."""
    mean, s_q, s_k = logs()
    return float((np.log(5e-3) - mean) / np.sqrt(s_q**2 + s_k**2 - 2 * rho * s_q * s_k))


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Study:
    """Return a study of load and springs drawn at random."""
    return run(tmp_path_factory.mktemp("drawn"), "monte carlo", 50, [Q, K])


@pytest.fixture
def short_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let pages have no pictures, where only their files are judged."""
    monkeypatch.setattr("groundslab.study.report.figures.to_inline_svg", lambda *_, **__: "")


def test_monte_carlo_of_an_even_load(study: Study) -> None:
    """Each row is q / k; the probability's interval holds the exact one; page and tables stand in the folder."""
    sample = read_samples(study)
    q, k = (each.values for each in sample.inputs)
    assert sample.outputs[0].values == pytest.approx(q / k, rel=1e-9)
    assert [each.unit.name for each in sample.inputs] == ["kPa", "MPa/m"]
    assert sample.outputs[0].unit.name == "mm"
    files = evaluate(study)
    assert files[0] == study.folder / "evaluation" / "report.html"
    names = {each.name for each in files} | {"checksums.json"}
    assert names == {each.name for each in (study.folder / "evaluation").iterdir()}
    with (study.folder / "evaluation" / "limit_states.csv").open(encoding="utf-8", newline="") as opened:
        (row,) = csv.DictReader(opened)
    low, high = (float(row[f"probability of failure, {end}"]) for end in ("low", "high"))
    assert low < stats.norm.sf(exact_beta()) < high
    page = files[0].read_text(encoding="utf-8")
    assert "Even load &lt;b&gt;" in page
    assert study.about["case_sha256"] in page
    assert "all w: probability of uplift" in page


def test_maps_are_the_rows(study: Study) -> None:
    """Under an even load mean and deviation of the settlement at every node are those of the largest settlement."""
    w = study.table()["w"].to_numpy()
    mean, std = study.map("settlement", "mean"), study.map("settlement", "std")
    # fields are kept with seven digits
    assert mean.values == pytest.approx(np.full(len(mean.mesh.nodes), w.mean()), rel=1e-6)
    assert std.values == pytest.approx(np.full(len(mean.mesh.nodes), w.std(ddof=1)), rel=1e-5)
    assert not study.map("settlement", "probability of uplift").values.any()


@pytest.mark.usefixtures("short_page")
def test_evaluating_again_replaces_the_old_evaluation(tmp_path: Path) -> None:
    """An evaluation takes the place of the one before, with nothing left of it and nothing left beside it."""
    study = run(tmp_path, "latin hypercube", 4, [Q, K])
    first = evaluate(study)
    older = study.folder / "evaluation" / "sobol.csv"  # which only another kind of sample has
    older.write_text("input,unit\nq,kPa\n", encoding="utf-8")
    assert evaluate(study) == first
    assert not older.exists()
    assert not [each for each in study.folder.iterdir() if each.name.startswith(".")]


@pytest.mark.usefixtures("short_page")
@pytest.mark.parametrize("name", ["notes.txt", "variants-mine.csv", "statistics.csv", "folder"])
def test_evaluations_hold_nothing_of_the_users(study: Study, name: str) -> None:
    """What the user has put among the tables, or in the place of one, is named, and all stays as it is."""
    evaluate(study)
    foreign = study.folder / "evaluation" / name
    before = foreign.read_bytes() if foreign.is_file() else None
    if name == "folder":
        foreign.mkdir()
    else:
        foreign.write_bytes(b"\0 mine")
    try:
        with pytest.raises(InputError, match=name):
            evaluate(study)
        assert foreign.is_dir() or foreign.read_bytes() == b"\0 mine"
    finally:
        if name == "folder":
            foreign.rmdir()
        elif before is None:
            foreign.unlink()
        else:
            foreign.write_bytes(before)


@pytest.mark.usefixtures("short_page")
@pytest.mark.parametrize("failing", ["fsync", "second rename"])
def test_an_evaluation_that_fails_leaves_the_earlier_one(
    study: Study, monkeypatch: pytest.MonkeyPatch, failing: str
) -> None:
    """On a full disk, or where the new folder cannot be put in place, all files of the old one are as they were."""
    folder = evaluate(study)[0].parent
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    rename, calls = os.rename, []

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    def once(*arguments: Any, **options: Any) -> None:
        calls.append(arguments)
        if len(calls) == 2:
            raise OSError(28, "No space left on device")
        rename(*arguments, **options)

    with monkeypatch.context() as patch:
        patch.setattr(os, *("fsync", full) if failing == "fsync" else ("rename", once))
        with pytest.raises(InputError, match="No space left"):
            evaluate(study)
    assert {path.name: path.read_bytes() for path in (study.folder / "evaluation").iterdir()} == before
    assert not [each for each in study.folder.iterdir() if each.name.startswith(".")]


@pytest.mark.usefixtures("short_page")
def test_an_evaluation_that_a_crash_left_aside_comes_back(study: Study) -> None:
    """Between the two renames the old evaluation lies aside, whole; the next one begins from it."""
    folder = evaluate(study)[0].parent
    folder.rename(folder.with_name(".evaluation.previous"))
    assert writer.check(study) == folder
    assert (folder / "report.html").is_file()
    assert not [each for each in study.folder.iterdir() if each.name.startswith(".")]


def test_every_file_of_an_evaluation_is_known(study: Study) -> None:
    """Each name that an evaluation writes is among those that it may replace, design points too."""
    names = {path.name for path in evaluate(study, [reliability(study)])}
    assert {"reliability.csv", "design_points.csv"} <= names <= writer.NAMES


def test_saltellis_sample_of_the_engine_fits_the_analysis(tmp_path: Path) -> None:
    """From the engine's own sample come the indices of ln w = ln q - ln k's parts, and k's field has none.

    w = q x with x = 1 / k: V_q = Var(q) E(x)^2, V_x = Var(x) E(q)^2, Var(q) Var(x) together.
    """
    study = run(tmp_path, "saltelli", 32, [Q, K], keep=[SOFT], limit_state=[])
    v_q, v_x = COV_Q**2, COV_K**2  # squares of the coefficients of variation; 1 / k has that of k
    parts = np.array([v_q, v_x]) / (v_q + v_x + v_q * v_x)
    (table,) = [each for each in tables_of(study) if each.name == "sobol"]
    for place in range(2):
        for name, exact in (("first-order", parts[place]), ("total", 1 - parts[1 - place])):
            low, high = (table[f"{name} index, {end}"][place] for end in ("low", "high"))
            assert low < exact < high  # type: ignore[operator]
    first = [table["first-order index"][place] for place in range(2)]
    assert first == pytest.approx(parts, abs=0.15)


def test_the_design_point_of_an_even_load(study: Study) -> None:
    """beta, design point and importance of lognormal load over lognormal spring are exact; sampling agrees."""
    found = reliability(study)
    _, s_q, s_k = logs()
    beta, s = exact_beta(), np.hypot(s_q, s_k)
    assert found.point.beta == pytest.approx(beta, rel=1e-6)
    assert found.point.importance == pytest.approx([s_q**2 / s**2, s_k**2 / s**2], rel=1e-3)
    q, k = (float(each.values[0]) for each in found.inputs)
    assert q / k == pytest.approx(5e-3, rel=1e-3)
    median_q, median_k = (50e3 * np.exp(-(s_q**2) / 2), 20e6 * np.exp(-(s_k**2) / 2))
    assert q == pytest.approx(median_q * np.exp(beta * s_q**2 / s), rel=1e-3)
    assert k == pytest.approx(median_k * np.exp(-beta * s_k**2 / s), rel=1e-3)
    assert found.sampled is not None
    assert found.sampled.low < found.point.probability < found.sampled.high
    assert f"too soft: w at most 5 mm\nbeta {beta:.4g}, probability" in str(found)
    page = evaluate(study, [found])[0].read_text(encoding="utf-8")
    assert "First-order reliability" in page
    assert (study.folder / "evaluation" / "design_points.csv").exists()


def test_the_design_point_with_correlation(tmp_path: Path) -> None:
    """With correlated logarithms beta is that of their difference."""
    correlation = [{"between": ["q", "k"], "rho": -0.5}]
    study = run(tmp_path, "monte carlo", 4, [Q, K], correlation=correlation, keep=[SOFT])
    assert reliability(study, "too soft").point.beta == pytest.approx(exact_beta(-0.5), rel=1e-6)


def test_designs_have_maps_and_probabilities_of_their_own(tmp_path: Path) -> None:
    """An even load settles the plate alike for each thickness: both designs have the same figures."""
    study = run(tmp_path, "sobol", 4, [Q, T, K])
    (table,) = [each for each in tables_of(study) if each.name == "statistics"]
    assert table["design"] == ("t = 200 mm", "t = 400 mm")
    assert table["mean"][0] == pytest.approx(table["mean"][1], rel=1e-9)
    assert "t = 400 mm" in evaluate(study)[0].read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("vary", "more", "name", "where"),
    [
        ([Q, T], {}, "", r"vary\[2\]"),
        ([Q], {"random_field": [{"path": "ground.k", "correlation_length": 2.0,
                                 "distribution": {"kind": "lognormal", "mean": 1.0, "cov": 0.1}}]}, "", "random_field"),
        ([Q], {}, "too sofd", "limit_state"),
        ([Q], {"limit_state": []}, "", "limit_state"),
    ],
)  # fmt: skip
def test_studies_without_a_design_point_are_refused(
    tmp_path: Path, vary: Any, more: dict[str, Any], name: str, where: str
) -> None:
    """Listed values, random fields and unknown limit states have no design point; the issue says so."""
    if "random_field" in more:
        pytest.importorskip("gstools")
    study = run(tmp_path, "monte carlo", 1, vary, keep=[SOFT], **more)
    with pytest.raises(InputError, match=where):
        reliability(study, name)


def test_a_study_without_rows_is_no_study_to_evaluate(tmp_path: Path) -> None:
    """Where no row is there yet, nothing is written and the issue says so."""
    import sqlite3

    study = run(tmp_path, "monte carlo", 1, [Q])
    with sqlite3.connect(study.folder / "rows.sqlite") as rows:
        rows.execute("DELETE FROM rows")
    rows.close()
    with pytest.raises(InputError, match="without a row"):
        evaluate(study)
    assert not (study.folder / "evaluation").exists()


STUDY = """
case = "case.toml"
[sampling]
kind = "monte carlo"
count = 3
[[vary]]
path = "loads[1].q"
name = "q"
distribution = {kind = "lognormal", mean = "50 kPa", cov = 0.2}
[[keep]]
name = "w"
of = "settlement"
take = "largest"
[[limit_state]]
name = "too soft"
keep = "w"
at_most = "4 mm"
"""


def test_commands_evaluate_a_study(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A study is evaluated at its end, and again by a command of its own, which finds the exact design point."""
    (tmp_path / "case.toml").write_text(casefile.to_toml(CASE), encoding="utf-8")
    (tmp_path / "soft.toml").write_text(STUDY, encoding="utf-8")
    assert main(["study", str(tmp_path / "soft.toml"), "--workers", "0", "--quiet"]) == 0
    page = tmp_path / "soft-study" / "evaluation" / "report.html"
    assert f"evaluation: {page}" in capsys.readouterr().out
    page.unlink()
    assert main(["evaluate", str(tmp_path / "soft-study"), "--design-points", "--level", "0.9"]) == 0
    out = capsys.readouterr().out
    s = np.sqrt(np.log1p(0.2**2))
    beta = (np.log(4e-3 * 20e6 / 50e3) + s**2 / 2) / s
    assert f"beta {beta:.4g}, probability of failure {stats.norm.sf(beta):.4g}" in out
    assert "Intervals of 90% confidence" in page.read_text(encoding="utf-8")


def test_commands_refuse_what_they_cannot_evaluate(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A folder that is no study, and a level that is no confidence, end with exit code 2 and a word why."""
    assert main(["evaluate", str(tmp_path)]) == 2
    assert "a folder that groundslab study made" in capsys.readouterr().err
    with pytest.raises(SystemExit) as caught:
        main(["evaluate", str(tmp_path), "--level", "95"])
    assert caught.value.code == 2
    assert "between 0 and 1" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["rows.sqlite", "about.json", "case.toml"])
@pytest.mark.parametrize("content", [b"", b"\0" * 5000, b"[" * 100_000])
def test_damaged_studies_are_told_as_such(
    study: Study, tmp_path: Path, name: str, content: bytes, capsys: pytest.CaptureFixture[str]
) -> None:
    """Whatever has become of a file in its folder, a study is read or refused with exit code 2, with no traceback."""
    import shutil

    folder = tmp_path / "study"
    shutil.copytree(study.folder, folder)
    whole = (folder / name).read_bytes()
    # an SQLite file that begins well, too
    (folder / name).write_bytes(whole[:1000] + content if name == "rows.sqlite" else content)
    assert main(["evaluate", str(folder)]) == 2
    assert "in the input" in capsys.readouterr().err
