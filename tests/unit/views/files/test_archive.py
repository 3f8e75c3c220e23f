"""Results as one file: what is packed is read back, and what is no such file is refused."""

from __future__ import annotations

import io
import tracemalloc
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import groundslab
from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.fem.parts.mesh_plan import MeshPlan
from groundslab.results.results import Results
from groundslab.views.files import archive, folder_summary, npz, results_folder
from helpers import synthetic
from helpers.small_case import TEXT


@pytest.fixture(scope="module")
def combined() -> Results:
    """Results of a small slab."""
    return groundslab.solve(casefile.loads(TEXT))


def test_an_archive_is_read_back(combined: Results, tmp_path: Path) -> None:
    """It holds the case to the byte, the report and the results, which are the same; so are its bytes each time."""
    content = archive.pack_results(combined, TEXT, "<p>report</p>")
    assert content == archive.pack_results(combined, TEXT, "<p>report</p>")
    (tmp_path / "slab.zip").write_bytes(content)
    folder = tmp_path / "unpacked"
    archive.unpack_results(tmp_path / "slab.zip", folder)
    assert (folder / "case.toml").read_text() == TEXT
    assert not list(folder.rglob("*.vtu"))
    read, written = (next(iter(each.results.values())) for each in (results_folder.load_results(folder), combined))
    np.testing.assert_array_equal(read.plate.settlement, written.plate.settlement)
    with zipfile.ZipFile(io.BytesIO(content)) as packed:
        assert packed.read("report.html") == b"<p>report</p>"
        assert packed.testzip() is None


def test_the_plan_of_the_mesh_is_read_back(tmp_path: Path) -> None:
    """What the mesher decided comes back as it was; numbers of zones that the case does not have are refused."""
    plan = MeshPlan((False, True), followed_zones=(), followed_voids=(0,), has_coarser=False)
    case = synthetic.model()
    voids = case.contact.replace(voids=[{"x": (-1.0, 1.0), "y": (-0.5, 0.5)}])
    found = synthetic.results(model=case.replace(contact=voids), mesh_plan=plan)
    npz.write(found, tmp_path / "results.npz")
    assert npz.load(tmp_path / "results.npz").mesh_plan == plan
    npz.write(replace(found, mesh_plan=replace(plan, followed_zones=(0,))), tmp_path / "results.npz")
    with pytest.raises(InputError, match="followed_zones"):
        npz.load(tmp_path / "results.npz")


def write_zip(path: Path, *files: tuple[str, bytes]) -> Path:
    """Write an archive of files."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, content in files:
            packed.writestr(name, content)
    return path


@pytest.mark.parametrize(
    "name",
    ["../case.toml", "/etc/case.toml", "a/../../case.toml", "..\\case.toml", "C:case.toml", "run.sh", "01/x.npz"],
)
def test_no_file_is_written_elsewhere(tmp_path: Path, name: str) -> None:
    """A file of any other path is refused before one is written."""
    path = write_zip(tmp_path / "x.zip", ("case.toml", b""), (name, b"x"))
    with pytest.raises(InputError, match="not a results file"):
        archive.unpack_results(path, tmp_path / "inner" / "folder")
    assert [each.name for each in tmp_path.iterdir()] == ["x.zip"]


def test_bombs_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither more bytes than allowed, by what the archive says or by what it holds, nor more files are unpacked."""
    path = write_zip(tmp_path / "x.zip", ("case.toml", b"#" * 3_000_000), ("summary.json", b"{}"))
    monkeypatch.setattr(archive, "MAX_SIZE", 2_900_000)
    with pytest.raises(InputError, match="bytes unpacked"):
        archive.unpack_results(path, tmp_path / "folder")
    monkeypatch.setattr(archive, "MAX_SIZE", 4_000_000)
    monkeypatch.setattr(archive, "MAX_FILES", 1)
    with pytest.raises(InputError, match="at most 1"):
        archive.unpack_results(path, tmp_path / "folder")
    monkeypatch.setattr(archive, "MAX_FILES", 2)
    lie = path.read_bytes().replace((3_000_000).to_bytes(4, "little"), (5).to_bytes(4, "little"))
    path.write_bytes(lie)
    with pytest.raises(InputError, match=r"x\.zip"):
        archive.unpack_results(path, tmp_path / "folder")
    assert not (tmp_path / "folder" / "case.toml").exists() or (tmp_path / "folder" / "case.toml").stat().st_size <= 5


@pytest.mark.filterwarnings("ignore:Duplicate name")
def test_what_is_no_archive_is_refused(tmp_path: Path) -> None:
    """Another file, a damaged one, and two files of one name are refused with words."""
    path = tmp_path / "x.zip"
    path.write_bytes(b"no archive")
    with pytest.raises(InputError, match="not a zip file"):
        archive.unpack_results(path, tmp_path)
    write_zip(path, ("case.toml", b"title = 1\n" * 50))
    content = bytearray(path.read_bytes())
    content[45] ^= 0xFF
    path.write_bytes(content)
    with pytest.raises(InputError, match="something else"):
        archive.unpack_results(path, tmp_path)
    write_zip(path, ("case.toml", b"1"), ("case.toml", b"2"))
    with pytest.raises(InputError, match="same name"):
        archive.unpack_results(path, tmp_path)


BLANKS = b" " * 2**20


def zipped(path: Path, name: str, megabytes: int, say: int | None = None) -> Path:
    """Return an archive with a file of so many megabytes of blanks, which its directory may say to be another size."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        with archive.open(name, "w") as file:
            for _ in range(megabytes):
                file.write(BLANKS)
        if say is not None:
            archive.infolist()[0].file_size = say
    return path


@pytest.mark.parametrize("name", ["summary.json", "case.toml", "ground-comparison.json", "01/results.npz"])
@pytest.mark.parametrize("lies", [False, True])
def test_each_file_has_a_size_by_its_role(name: str, lies: bool, tmp_path: Path) -> None:
    """A file of 60 MB of blanks in 60 kB is refused before it lies on the disk, also if it says to be small."""
    path = zipped(tmp_path / "x.zip", name, 60, 1000 if lies else None)
    assert path.stat().st_size < 2**20
    target = tmp_path / "unpacked"
    tracemalloc.start()
    with pytest.raises(InputError, match="CRC" if lies else "at most .* bytes in it"):
        archive.unpack_results(path, target)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 20e6
    assert sum(each.stat().st_size for each in target.rglob("*") if each.is_file()) < 2 * 2**20


def test_a_large_summary_in_a_folder_is_not_read(tmp_path: Path) -> None:
    """A summary larger than any is refused by its size, without its memory."""
    with (tmp_path / "summary.json").open("wb") as file:
        file.truncate(folder_summary.LARGEST + 1)
    tracemalloc.start()
    with pytest.raises(InputError, match=r"no summary\.json"):
        results_folder.load_results(tmp_path)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 20e6


def test_a_large_description_of_results_is_not_read(tmp_path: Path) -> None:
    """A text among the arrays that is larger than any is refused before it is read."""
    path = tmp_path / "results.npz"
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("about.npy", bytes(npz.TEXTS["about.npy"] + 1))
    tracemalloc.start()
    with pytest.raises(InputError, match="a description that is larger than any"):
        npz.load(path)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 20e6
