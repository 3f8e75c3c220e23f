"""What groundslab wrote is recognised by what it holds; all else is somebody's and stays."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import groundslab
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.storage import ownership
from groundslab.views.files import results_folder
from groundslab.views.plots import export
from helpers import synthetic


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder of results of several combinations, with pictures."""
    return results_folder.save_results(synthetic.combined(), tmp_path_factory.mktemp("results") / "raft", plot=True)


@pytest.fixture(scope="module")
def figures(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder of a figure in each format."""
    folder = tmp_path_factory.mktemp("figures")
    for ending in export.FORMATS:
        groundslab.plot(synthetic.results(), "w", to=folder / f"a{ending}")
    return folder


@pytest.mark.slow
def test_every_file_of_results_is_recognised(results: Path) -> None:
    """Each file of a folder of results is of the kind that belongs to its name, and none is a stranger."""
    names = {path.relative_to(results).as_posix() for path in results.rglob("*") if path.is_file()}
    assert all(ownership.has_expected_content(results / name) for name in names)
    assert ownership.strangers(results, names) == []


@pytest.mark.slow
@pytest.mark.parametrize("ending", export.FORMATS)
def test_figures_are_recognised_and_replaced(figures: Path, ending: str) -> None:
    """An earlier figure gives way to a new one; nothing is left beside it."""
    target, before = figures / f"a{ending}", sorted(figures.iterdir())
    assert ownership.is_figure(target)
    groundslab.plot(synthetic.results(), "m_x", to=target)
    assert ownership.is_figure(target)
    assert sorted(figures.iterdir()) == before


@pytest.mark.parametrize("ending", export.FORMATS)
def test_figures_of_others_are_never_replaced(tmp_path: Path, ending: str) -> None:
    """A figure that Matplotlib drew for somebody else, a text and an empty file stay, byte by byte."""
    from matplotlib.figure import Figure

    target = tmp_path / f"mine{ending}"
    Figure().savefig(target)
    for content in (target.read_bytes(), b"groundslab 0.1.0", b""):
        target.write_bytes(content)
        with pytest.raises(InputError, match="a figure that groundslab drew"):
            groundslab.plot(synthetic.results(), "w", to=target)
        assert target.read_bytes() == content
        assert os.listdir(tmp_path) == [target.name]  # noqa: PTH208


@pytest.mark.slow
def test_a_figure_that_somebody_wrote_notes_on_is_theirs(figures: Path, tmp_path: Path) -> None:
    """Readers append notes to a PDF; such a file is groundslab's no more."""
    target = tmp_path / "a.pdf"
    target.write_bytes((figures / "a.pdf").read_bytes() + b"9 0 obj\n<< /Type /Annot >>\nendobj\n%%EOF\n")
    assert not ownership.is_figure(target)


@pytest.mark.slow
@pytest.mark.parametrize("ending", export.FORMATS)
def test_a_full_disk_leaves_the_earlier_figure(figures: Path, ending: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The earlier file is as it was, nothing lies beside it, and the error says so."""

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    before = {path.name: path.read_bytes() for path in figures.iterdir()}
    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(InputError, match="No space left"):
        groundslab.plot(synthetic.results(), "p", to=figures / f"a{ending}")
    assert {path.name: path.read_bytes() for path in figures.iterdir()} == before


@pytest.mark.slow
def test_commands_ask_before_they_draw(
    results: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Both plot and report refuse a place before any results are read: foreign files, folders, pipes, long names."""
    monkeypatch.setattr(results_folder, "load_results", None)
    places = ["folder", "text", "none/x", "x" * 256]
    (tmp_path / "text").write_text("mine")
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "pipe")
        places.append("pipe")
    for command, ending in (("plot", "pdf"), ("report", "html")):
        for place in places:
            target = tmp_path / f"{place}.{ending}"
            if place in ("text", "pipe"):
                (tmp_path / place).rename(target)
            if place == "folder":
                target.mkdir()
            assert main.main([command, str(results), "--out", str(target)]) == 2
            assert place in capsys.readouterr().err
            if place in ("text", "pipe"):
                target.rename(tmp_path / place)
    assert (tmp_path / "text").read_text() == "mine"


#: What a user may have under names that groundslab uses as well.
OTHERS = {
    "plate.vtu": b'<VTKFile type="PolyData">', "plate.pvd": b'<VTKFile type="UnstructuredGrid">',
    "results.npz": b"PK\x03\x04" + b"\0" * 26 + b"holiday.jpg", "case.toml": b'[tool]\nname = "mine"\n',
    "combinations.csv": b"PK\x03\x04", "summary.json": b'{"author": "me"}', "picture.png": b"\x89PNG\r\n\x1a\n",
    "report.html": b"<h1>mine</h1>", "notes.txt": b"mine",
}  # fmt: skip


@pytest.mark.parametrize("name", OTHERS)
def test_a_name_alone_makes_no_file_ours(tmp_path: Path, name: str) -> None:
    """A file of another kind, or a link to one of the right kind, is a stranger even under one of our names."""
    (tmp_path / name).write_bytes(OTHERS[name])
    assert ownership.strangers(tmp_path, {name}) == [name]


def test_a_link_is_a_stranger(results: Path, tmp_path: Path) -> None:
    """A link to a file of ours, or to a folder of such, is not ours."""
    (tmp_path / "case.toml").symlink_to(results / "case.toml")
    (tmp_path / "tables").symlink_to(results / "tables")
    assert ownership.strangers(tmp_path, {"case.toml", "tables/tilt.csv"}) == ["case.toml", "tables"]


def test_every_starter_is_a_case(tmp_path: Path) -> None:
    """A case file that groundslab writes counts as one."""
    (tmp_path / "case.toml").write_text(casefile.starter(), encoding="utf-8")
    assert ownership.has_expected_content(tmp_path / "case.toml")
