"""What sdist and wheel contain, and when the build hook builds the pages for the browser."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path
from types import SimpleNamespace

import pytest

import groundslab

pytest.importorskip("hatchling")
import hatch_build

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def distributions(tmp_path_factory: pytest.TempPathFactory) -> list[set[str]]:
    """Build sdist and wheel; return the names in each, from the package's folder on."""
    if not hatch_build.are_pages_current():
        pytest.skip("the pages are not built (make pages)")
    folder = tmp_path_factory.mktemp("dist")
    command = [sys.executable, "-m", "hatchling", "build", "--directory", str(folder)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    (sdist,), (wheel,) = folder.glob("*.tar.gz"), folder.glob("*.whl")
    with tarfile.open(sdist) as tar, zipfile.ZipFile(wheel) as archive:
        return [{name.partition("/src/")[2] for name in tar.getnames()}, set(archive.namelist())]


@pytest.mark.slow
def test_sdist_and_wheel_contain_the_package(distributions: list[set[str]]) -> None:
    """Both contain every file of the package that git knows, and the marker for type checkers among them."""
    listed = subprocess.run(["git", "ls-files", "src"], cwd=ROOT, capture_output=True, text=True, check=False).stdout
    files = {name.removeprefix("src/") for name in listed.splitlines() if (ROOT / name).is_file()}
    for names in distributions:
        assert not files - names
        assert "groundslab/py.typed" in names


@pytest.mark.slow
def test_sdist_and_wheel_contain_the_pages(distributions: list[set[str]]) -> None:
    """Both contain the report's script, the workbench's page and the messages as they are read, which git ignores."""
    pages = {"report.js", "report.css", "messages.json", "index.html", "index.js", "index.css", "icon.svg"}
    for names in distributions:
        built = {Path(name).name for name in names if Path(name).parent.name == "static"}
        assert built == pages | {"de.json", "es.json", "fr.json", "pl.json"}


@pytest.mark.slow
def test_sdist_and_wheel_contain_the_help(distributions: list[set[str]]) -> None:
    """Both contain the examples and the pages that the workbench shows, with their pictures, in less than 3 MB."""
    folder = "groundslab/workbench/help/static/"
    examples = {f"{folder}examples/{path.name}" for path in (ROOT / "examples").glob("*.toml")}
    pages = {f"{folder}docs/{name}" for name in ("index.md", "input.md", "howto/draw_a_slab.md", "images/input.svg")}
    for names in distributions:
        assert examples | pages <= names
        assert f"{folder}docs/architecture.md" not in names
    copied = (ROOT / "src" / folder).rglob("*.*")
    assert sum(path.stat().st_size for path in copied) < 3_000_000


def test_citation_has_the_version_of_the_package() -> None:
    """CITATION.cff, codemeta.json and the page on citing name it, and a release its date in the changelog."""
    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    version = groundslab.__version__
    dates = re.findall(rf"^## \[{re.escape(version)}\] - (.+)$", changes, re.MULTILINE)
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert re.findall(r"^(?:version|date-released): (.+)$", text, re.MULTILINE) == [version, *dates]
    about = json.loads((ROOT / "codemeta.json").read_text(encoding="utf-8"))
    keywords = re.findall(r"^  - ([^:\n]+)$", text, re.MULTILINE)
    assert (about["version"], about["keywords"]) == (version, keywords)
    page = (ROOT / "docs" / "cite.md").read_text(encoding="utf-8")
    assert re.findall(r"version = \{(.+)\}", page) == [version]


def test_version_is_that_of_the_latest_release_or_tells_the_next() -> None:
    """The version is the changelog's latest if nothing has changed since, or else a later one with .dev0."""
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    release = re.findall(r"^## \[([\d.]+)\]", text, re.MULTILINE)[0]
    changed = re.search(r"^## \[Unreleased\]\s+(?!## )\S", text, re.MULTILINE)
    version, suffix = re.fullmatch(r"([\d.]+)(\.dev0)?", groundslab.__version__).groups()
    if suffix is None:
        assert version == release
        assert not changed
    else:
        assert tuple(map(int, version.split("."))) > tuple(map(int, release.split(".")))


@pytest.fixture
def pages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """Make a repository whose two pages are built after their sources; return source and pages."""
    files = [tmp_path / "web" / "src" / "main.ts"]
    for number in range(2):
        configuration = tmp_path / "web" / f"vite.{number}.config.ts"
        configuration.parent.mkdir(exist_ok=True)
        configuration.write_text(f'outDir: "../src/groundslab/page{number}/static"', encoding="utf-8")
        os.utime(configuration, (1, 1))
        files.append(tmp_path / "src" / "groundslab" / f"page{number}" / "static" / "index.js")
    for seconds, file in enumerate(files, start=2):
        file.parent.mkdir(parents=True)
        file.touch()
        os.utime(file, (seconds, seconds))
    monkeypatch.setattr(hatch_build, "ROOT", tmp_path)
    monkeypatch.setattr(hatch_build, "WEB", tmp_path / "web")
    return files


def test_pages_are_built_when_missing_or_older_than_their_sources(pages: list[Path]) -> None:
    """Each page counts, and each source; in an sdist, which has PKG-INFO, pages are taken as they are."""
    source, _, page = pages
    assert hatch_build.are_pages_current()
    os.utime(source, (10, 10))
    assert not hatch_build.are_pages_current()
    os.utime(source, (1, 1))
    page.unlink()
    assert not hatch_build.are_pages_current()
    (hatch_build.ROOT / "PKG-INFO").touch()
    assert hatch_build.are_pages_current()


def test_node_must_be_one_that_vite_supports(monkeypatch: pytest.MonkeyPatch) -> None:
    """Vite 8 states ^20.19.0 || >=22.12.0."""
    monkeypatch.setattr(hatch_build.shutil, "which", lambda name: name)

    def is_supported(version: str) -> bool:
        monkeypatch.setattr(hatch_build.subprocess, "run", lambda *_, **__: SimpleNamespace(stdout=version))
        return hatch_build.has_node()

    versions = ["", "v18.20.8", "v20.18.3", "v20.19.0", "v21.7.3", "v22.11.0", "v22.12.0", "v24.1.0"]
    assert list(filter(is_supported, versions)) == ["v20.19.0", "v22.12.0", "v24.1.0"]


def test_a_failed_build_says_what_it_needs(pages: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    """Without npm the error names what is missing and where built pages are."""
    pages[1].unlink()
    monkeypatch.setenv("PATH", "")
    assert not hatch_build.has_node()
    with pytest.raises(RuntimeError, match=r"(?s)npm.*Node\.js.*wheel or an sdist"):
        hatch_build.build_pages()
