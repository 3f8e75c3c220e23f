"""Files that somebody has edited are known by their checksums, and kept before they are replaced."""

from __future__ import annotations

import json
from pathlib import Path

import ezdxf
import pytest
from xlsxwriter import Workbook

import groundslab
from groundslab.cli import main
from groundslab.errors import EditedFilesKept
from groundslab.storage import checksums
from groundslab.study.execution import store
from groundslab.study.report import writer
from groundslab.views.files import folder_summary, results_folder, xlsx
from groundslab.views.plots import export
from helpers import synthetic

CASE = """
[plate]
length_x = "4 m"
length_y = "3 m"
thickness = "0.3 m"
E = "30 GPa"
nu = 0.2
[ground]
kind = "winkler"
k = "50 MPa/m"
[[loads]]
kind = "uniform"
q = "10 kPa"
[mesh]
size = "1 m"
"""


def append(path: Path, text: str) -> bytes:
    """Add a text at the end of a file, and return what it holds then."""
    with path.open("a", encoding="utf-8") as file:
        file.write(text)
    return path.read_bytes()


class TestResultsFolder:
    """`groundslab solve` and `save_results`."""

    @pytest.mark.slow
    def test_edited_files_are_kept_and_named(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """A note in case.toml and a cell of a table survive the next solve, beside the folder; the rest is replaced."""
        case, folder = tmp_path / "raft.toml", tmp_path / "raft-results"
        case.write_text(CASE, encoding="utf-8")
        assert main.main(["solve", str(case), "--quiet"]) == 0
        assert "edited" not in capsys.readouterr().err
        noted = append(folder / "case.toml", "# ask for the borehole\n")
        table = append(folder / "tables" / "extremes.csv", "mine,1\n")
        assert main.main(["solve", str(case), "--quiet"]) == 0
        kept = tmp_path / "raft-results-edited"
        message = capsys.readouterr().err
        assert f"kept in {kept}: case.toml, tables/extremes.csv" in message
        assert message.startswith("note: ")
        assert {path.relative_to(kept).as_posix() for path in kept.rglob("*") if path.is_file()} == {
            "case.toml",
            "tables/extremes.csv",
        }
        assert (kept / "case.toml").read_bytes() == noted
        assert (kept / "tables" / "extremes.csv").read_bytes() == table
        assert b"borehole" not in (folder / "case.toml").read_bytes()
        # nothing is edited now, and what was kept is never touched
        assert main.main(["solve", str(case), "--quiet"]) == 0
        assert capsys.readouterr().err == ""
        results = results_folder.load_results(folder)
        append(folder / "case.toml", "# another note\n")
        with pytest.warns(EditedFilesKept, match="raft-results-edited-2: case.toml"):
            groundslab.save_results(results, folder)
        assert (kept / "case.toml").read_bytes() == noted

    def test_a_value_of_the_summary(self, tmp_path: Path) -> None:
        """A value edited in summary.json is known, another layout of the same is no edit."""
        folder = results_folder.save_results(synthetic.results(), tmp_path / "slab")
        summary = folder / "summary.json"
        document = json.loads(summary.read_bytes())
        summary.write_text(json.dumps(document), encoding="utf-8")
        assert folder_summary.find_edited(folder) == []
        summary.write_text(json.dumps(document | {"title": "mine"}), encoding="utf-8")
        assert folder_summary.find_edited(folder) == ["summary.json"]

    def test_all_files_have_checksums(self, tmp_path: Path) -> None:
        """The summary has the SHA-256 of every file of the folder, as other programs compute it."""
        import hashlib

        folder = results_folder.save_results(synthetic.results(), tmp_path / "slab")
        document = json.loads((folder / "summary.json").read_bytes())
        assert set(document["checksums"]) == set(document["files"])
        digest = hashlib.sha256((folder / "plate.vtu").read_bytes()).hexdigest()
        assert document["checksums"]["plate.vtu"] == digest

    def test_files_that_stay(self, tmp_path: Path) -> None:
        """Further files in the folder leave an edited one where it is, and known as edited."""
        folder = results_folder.save_results(synthetic.results(), tmp_path / "slab")
        append(folder / "case.toml", "# a note\n")
        results_folder.add_files(folder, {"tables/ground_curves.csv": lambda path: path.write_text("a,b\n1,2\n")})
        assert folder_summary.find_edited(folder) == ["case.toml"]
        append(folder / "tables" / "ground_curves.csv", "3,4\n")
        with pytest.warns(EditedFilesKept, match="slab-edited: tables/ground_curves.csv"):
            results_folder.add_files(folder, {"tables/ground_curves.csv": lambda path: path.write_text("a,b\n")})
        assert (tmp_path / "slab-edited" / "tables" / "ground_curves.csv").read_text() == "a,b\n1,2\n3,4\n"

    def test_of_many_files_some_are_named(self, tmp_path: Path) -> None:
        """Of a dozen files ten are named."""
        names = [f"{n}.csv" for n in range(12)]
        (tmp_path / "slab").mkdir()
        for name in names:
            (tmp_path / "slab" / name).write_text(name)
        with pytest.warns(EditedFilesKept, match=r"9\.csv, 2 more"):
            checksums.keep_files(tmp_path / "slab", names)
        assert len(list((tmp_path / "slab-edited").iterdir())) == 12


class TestSingleFiles:
    """Reports, figures, drawings and workbooks, which stand alone."""

    @pytest.mark.slow
    def test_a_report(self, tmp_path: Path) -> None:
        """A report with a note in it is kept under another name, an unchanged one is replaced without a word."""
        path, results = tmp_path / "slab.html", synthetic.results()
        groundslab.write_report(results, path, chapters=["certificate"])
        first = path.read_bytes()
        groundslab.write_report(results, path, chapters=["certificate"])
        assert path.read_bytes() == first
        path.write_bytes(first.replace(b"</body>", b"<p>mine</p></body>", 1))
        with pytest.warns(EditedFilesKept, match=r"slab-edited\.html"):
            groundslab.write_report(results, path, chapters=["certificate"])
        assert b"<p>mine</p>" in (tmp_path / "slab-edited.html").read_bytes()
        assert path.read_bytes() == first

    def test_a_figure(self, tmp_path: Path) -> None:
        """A figure as SVG that was edited is kept."""
        from matplotlib.figure import Figure

        path = tmp_path / "plan.svg"
        export.save([Figure()], path)
        export.save([Figure()], path)
        path.write_bytes(path.read_bytes().replace(b"</svg>", b"<text>mine</text></svg>"))
        with pytest.warns(EditedFilesKept, match=r"plan-edited\.svg"):
            export.save([Figure()], path)
        assert b"mine" in (tmp_path / "plan-edited.svg").read_bytes()

    def test_a_drawing_of_bars(self, tmp_path: Path) -> None:
        """A drawing that a CAD program has saved again is kept."""
        mesh = {"bottom_mesh": "Q257A", "top_mesh": "Q257A", "cover": (0.03, 0.03)}
        model = groundslab.Model(
            plate={"length_x": 4, "length_y": 3, "thickness": 0.3, "E": 30e9, "nu": 0.2},
            ground={"kind": "winkler", "k": 50e6},
            cases=[{"name": "G"}],
            loads=[{"kind": "uniform", "q": 1e4, "case": "G"}],
            combinations=[{"name": "U", "factors": {"G": 1.35}}],
            reinforcement={"concrete": "C30/37", "steel": "B500B", **mesh},
        )
        path = tmp_path / "bars.dxf"
        groundslab.write_bars(model, path)
        groundslab.write_bars(model, path)
        document = ezdxf.readfile(path)
        document.modelspace().add_text("mine")
        document.save()
        with pytest.warns(EditedFilesKept, match=r"bars-edited\.dxf"):
            groundslab.write_bars(model, path)
        assert b"mine" in (tmp_path / "bars-edited.dxf").read_bytes()

    def test_a_workbook(self, tmp_path: Path) -> None:
        """A workbook that a program has saved again, with its date, is kept."""
        path, results = tmp_path / "slab.xlsx", synthetic.results()
        groundslab.write_workbook(results, path)
        groundslab.write_workbook(results, path)
        with Workbook(path) as book:  # of today
            book.set_properties({"comments": f"{xlsx.MARK} 0"})
            book.add_worksheet("mine")
        edited = path.read_bytes()
        with pytest.warns(EditedFilesKept, match=r"slab-edited\.xlsx"):
            groundslab.write_workbook(results, path)
        assert (tmp_path / "slab-edited.xlsx").read_bytes() == edited


@pytest.mark.slow
def test_the_evaluation_of_a_study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A table of an evaluation that was edited is kept beside the evaluation; the study can be read as before."""
    from helpers import studies

    monkeypatch.setattr("groundslab.study.report.figures.to_inline_svg", lambda *_, **__: "")
    study = groundslab.study(studies.write(tmp_path), out=tmp_path / "rows", workers=0, quiet=True)
    writer.evaluate(study)
    writer.evaluate(study)
    table = next(path for path in (study.folder / writer.FOLDER).glob("*.csv"))
    append(table, "mine\n")
    with pytest.warns(EditedFilesKept, match=f"evaluation-edited: {table.name}"):
        writer.evaluate(study)
    assert (study.folder / "evaluation-edited" / table.name).read_text(encoding="utf-8").endswith("mine\n")
    assert store.about(study.folder)
