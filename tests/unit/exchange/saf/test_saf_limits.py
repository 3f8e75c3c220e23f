"""Files in the Structural Analysis Format that unfold to far more than they say are refused unread."""

from __future__ import annotations

import time
import zipfile
from pathlib import Path

import pytest

import groundslab as gs
from groundslab.cli import main
from groundslab.exchange.saf.reading import workbook
from helpers import saf_files

pytest.importorskip("openpyxl")


@pytest.fixture
def house(tmp_path: Path) -> Path:
    """Return a file."""
    return saf_files.write(tmp_path / "house.xlsx", saf_files.house())


def changed(house: Path, part: str, old: bytes, new: bytes) -> Path:
    """Return a file with other XML in one of its parts."""
    path = house.with_name("changed.xlsx")
    with zipfile.ZipFile(house) as parts, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as others:
        for name in parts.namelist():
            text = parts.read(name)
            if name == part:
                assert old in text
                text = text.replace(old, new, 1)
            others.writestr(name, text)
    return path


def part_of(sheet: str) -> str:
    """Return the part that holds a sheet."""
    return f"xl/worksheets/sheet{list(saf_files.house()).index(sheet) + 1}.xml"


def refuse(path: Path, match: str) -> None:
    """Expect that a file is refused within seconds."""
    start = time.monotonic()
    with pytest.raises(gs.InputError, match=match):
        gs.read_saf(path)
    assert time.monotonic() - start < 10


def test_parts_that_unfold_to_far_more_are_refused(tmp_path: Path) -> None:
    """300 MB of blanks take 300 kB in the archive, and nothing of them is unfolded."""
    path = tmp_path / "bomb.xlsx"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as parts, parts.open("xl/workbook.xml", "w") as part:
        for _ in range(300):
            part.write(b" " * 1_000_000)
    refuse(path, "unfold to 300,000,000 bytes")


def test_many_parts_are_refused(tmp_path: Path) -> None:
    """No workbook has thousands of parts."""
    path = tmp_path / "parts.xlsx"
    with zipfile.ZipFile(path, "w") as parts:
        for number in range(workbook.MOST_PARTS + 1):
            parts.writestr(f"{number}.xml", "")
    refuse(path, "2,001 parts")


@pytest.mark.parametrize("coding", ["utf-8", "utf-16-le", "utf-16-be"])
def test_entities_are_refused(tmp_path: Path, coding: str) -> None:
    """A document type definition, by which a line of XML can stand for gigabytes, is not even parsed."""
    path = tmp_path / "entities.xlsx"
    with zipfile.ZipFile(path, "w") as parts:
        parts.writestr(
            "xl/workbook.xml", '<?xml version="1.0"?><!DOCTYPE a [<!ENTITY b "c">]><a>&b;</a>'.encode(coding)
        )
    refuse(path, "document type definition")


def test_rows_and_cells_far_away_are_limited(house: Path) -> None:
    """A row of number 1,048,576, and a cell in column XFD, cost no more than their letters say."""
    part = part_of("StructuralPointConnection")
    far = b'<row r="1048576"><c r="XFD1048576" t="inlineStr"><is><t>N99</t></is></c></row></sheetData>'
    start = time.monotonic()
    assert gs.read_saf(changed(house, part, b"</sheetData>", far)).slab == "S6"
    near = b'<row r="1048576"><c r="A1048576" t="inlineStr"><is><t>N99</t></is></c></row></sheetData>'
    gs.read_saf(changed(house, part, b"</sheetData>", near))
    assert time.monotonic() - start < 20


def test_more_rows_than_the_limit_are_refused(house: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """So are more cells in all sheets together."""
    monkeypatch.setattr(workbook, "MOST_ROWS", 20)
    refuse(house, "more than 20 rows")
    monkeypatch.undo()
    monkeypatch.setattr(workbook, "MOST_CELLS", 500)
    refuse(house, "more than 500 cells")


def test_formulas_and_links_are_not_followed(house: Path) -> None:
    """A formula counts with the value that is stored beside it, without one it is nothing."""
    part = part_of("StructuralSurfaceConnection")
    stored = changed(house, part, b"<v>160</v>", b"<f>[1]other!A1*2</f><v>170</v>")
    ground = gs.read_saf(stored).model.ground
    assert isinstance(ground, gs.Pasternak)
    assert ground.k0 == 170e6
    refuse(changed(house, part, b"<v>160</v>", b"<f>1+1</f>"), "c1z: found nothing")


@pytest.mark.parametrize(
    ("content", "match"), [(b"", "no workbook"), (b"PK\x03\x04 and more", "no workbook"), (b"text", "no")]
)
def test_other_files_are_refused(tmp_path: Path, content: bytes, match: str) -> None:
    """What is no archive is no workbook."""
    path = tmp_path / "some.xlsx"
    path.write_bytes(content)
    refuse(path, match)


def test_files_that_are_not_there(tmp_path: Path) -> None:
    """Neither is a folder, nor a workbook of other sheets."""
    refuse(tmp_path / "none.xlsx", "no file of that name")
    refuse(tmp_path, "no plain file")
    refuse(saf_files.write(tmp_path / "tables.xlsx", {"Sheet1": [["a"], [1]]}), "no sheet Model")
    assert main.main(["import-saf", str(tmp_path / "none.xlsx")]) == 2
