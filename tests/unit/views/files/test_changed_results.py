"""Results that somebody has changed since groundslab wrote them are used by no reader."""

from __future__ import annotations

import json
import shutil
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

import groundslab
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.errors import CertificateWithdrawn
from groundslab.views.files import archive
from groundslab.workbench.server.view import ResultsView
from helpers import damage, small_case


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder of results, beside which nothing lies."""
    results = groundslab.solve(casefile.loads(small_case.TEXT))
    return groundslab.save_results(results, tmp_path_factory.mktemp("written") / "slab-results")


@pytest.fixture
def folder(written: Path, tmp_path: Path) -> Path:
    """Return a copy of it, to be changed."""
    return Path(shutil.copytree(written, tmp_path / "slab-results"))


def _reduce_moments(folder: Path) -> None:
    for name in ("plate.moment_x", "elements.moment_x"):
        damage.with_array(folder / "results.npz", name, lambda a: 0.2 * a)


def _edit(name: str, old: str, new: str) -> Callable[[Path], None]:
    """Return what replaces a text in a file."""

    def change(folder: Path) -> None:
        text = (folder / name).read_text(encoding="utf-8")
        assert old in text
        (folder / name).write_text(text.replace(old, new, 1), encoding="utf-8", newline="\n")

    return change


def _forget_checksum(folder: Path) -> None:
    document = json.loads((folder / "summary.json").read_bytes())
    del document["checksums"]["results.npz"]
    (folder / "summary.json").write_text(json.dumps(document), encoding="utf-8")


#: Changes, by the file that is named then.
CHANGES: dict[str, Callable[[Path], None]] = {
    "results.npz": _reduce_moments,
    "case.toml": _edit("case.toml", "[", "# a note\n["),
    "tables/extremes.csv": _edit("tables/extremes.csv", "\n", "\n\n"),
    "summary.json": _edit("summary.json", '"title": "', '"title": "another '),
    "results.npz ": _forget_checksum,
}


@pytest.mark.parametrize("name", CHANGES)
def test_no_reader_uses_changed_results(folder: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Each command ends with 1, its first line names the file, and nothing is written; Python and the page raise."""
    assert main.main(["tables", str(folder), "--json", "--only", "extremes"]) == 0
    capsys.readouterr()
    CHANGES[name](folder)
    name = name.strip()
    out = folder.parent / "out"
    commands = {
        "tables": ["--out", f"{out}.xlsx"], "report": ["--out", f"{out}.html"], "plot": ["--out", f"{out}.png"],
        "bars": ["--out", f"{out}.svg"], "propose-bars": ["--out", f"{out}.toml"],
        "export-saf": ["--out", f"{out}.xlsx"], "view": ["--no-browser"],
    }  # fmt: skip
    for command, options in commands.items():
        assert main.main([command, str(folder), *options]) == 1, command
        first = capsys.readouterr().err.splitlines()[0]
        assert first.startswith(f"error: certificate withdrawn: {name} in {folder} changed"), command
    assert main.main(["tables", str(folder), "--json"]) == 1
    told = json.loads(capsys.readouterr().out)["error"]
    assert told["kind"] == "CertificateWithdrawn"
    assert name in told["message"]
    assert [path.name for path in folder.parent.iterdir()] == ["slab-results"]
    for read in (groundslab.load_results, ResultsView.read):
        with pytest.raises(CertificateWithdrawn) as caught:
            read(folder)
        assert caught.value.changed == (name,)


def test_changed_numbers_in_an_archive(folder: Path, tmp_path: Path) -> None:
    """The viewer reads what the workbench saved, with the text of its case, and nothing whose numbers were changed."""
    text = small_case.TEXT + "\n# as it was written\n"
    saved = tmp_path / "slab.zip"
    saved.write_bytes(archive.pack_results(groundslab.load_results(folder), text, "<p>report</p>"))
    assert ResultsView.read(saved).get_state()["text"] == text
    archive.unpack_results(saved, tmp_path / "unpacked")
    _reduce_moments(tmp_path / "unpacked")
    with zipfile.ZipFile(tmp_path / "changed.zip", "w") as packed:
        for path in sorted(filter(Path.is_file, (tmp_path / "unpacked").rglob("*"))):
            packed.write(path, path.relative_to(tmp_path / "unpacked").as_posix())
    with pytest.raises(CertificateWithdrawn, match=r"results\.npz"):
        ResultsView.read(tmp_path / "changed.zip")


def test_changed_results_are_not_resumed(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A run does not go on from provisional results that somebody has changed; it says so and starts anew."""
    case = folder.with_name("slab.toml")
    case.write_text(small_case.TEXT, encoding="utf-8")
    left = folder.rename(folder.with_name("slab-results-provisional"))
    _reduce_moments(left)
    assert main.main(["solve", str(case), "--resume"]) == 0
    assert "nothing to resume: found changed files (results.npz)" in capsys.readouterr().err
