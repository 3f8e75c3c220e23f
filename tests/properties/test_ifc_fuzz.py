"""Damaged IFC files: each is read, or refused with issues, never with a traceback, and within bounds."""

from __future__ import annotations

import random
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest

import groundslab as gs
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.errors import Issue
from groundslab.workbench.checking import file_reader
from groundslab.workbench.checking.bounded_process import BoundedProcess
from groundslab.workbench.checking.buildings import BuildingReader
from groundslab.workbench.checking.file_reader import load_libraries

pytest.importorskip("ifcopenshell")

from helpers.examples import examples
from helpers.ifc_files import Building, turned

#: What may stand in a file by mistake.
ODD = ["$", "*", "0.", "-1.", "1.E300", "1.E-300", "NAN", "#1", "#9999", "()", "((0.,0.),(1.,1.))", "'x'", ".T.", "."]


def house() -> str:
    """Return a file with a slab, an opening, columns and a wall."""
    building = Building("mm", storey=turned(30, 5, 0, 1))
    slab = building.slab()
    building.add("IfcOpeningElement", "Shaft", building.polygon([(1, 1), (2, 1), (2, 2)]), 0.3, voids=slab)
    building.add("IfcColumn", "K1", building.profile("IfcCircleProfileDef", Radius=0.2), 3, turned(0, 3, 2))
    building.add("IfcColumn", "K2", building.profile("IfcRectangleProfileDef", XDim=0.4, YDim=0.3), 3, turned(0, 4, 2))
    building.add("IfcWall", "W", building.polygon([(0, 0), (3, 0), (3, 0.25), (0, 0.25)]), 3, turned(0, 1, 3))
    return str(building.file.to_string())


def damage(text: str, chance: random.Random) -> str:
    """Return a file with some values, lines or letters changed, lost or twice."""
    lines = text.splitlines()
    for _ in range(chance.randint(1, 5)):
        n = chance.randrange(6, len(lines) - 2)
        what = chance.random()
        if what < 0.15:
            del lines[n]
        elif what < 0.25:
            lines.insert(n, lines[chance.randrange(6, len(lines) - 2)])
        elif what < 0.35:
            lines[n] = lines[n][: chance.randrange(len(lines[n]) + 1)]
        elif what < 0.45:
            k = chance.randrange(len(lines[n]) + 1)
            lines[n] = lines[n][:k] + chance.choice("(),#$;'\0\xff9") + lines[n][k + 1 :]
        else:
            head, _, values = lines[n].partition("(")
            parts = values.rstrip(");").split(",")
            parts[chance.randrange(len(parts))] = chance.choice(ODD)
            lines[n] = f"{head}({','.join(parts)});"
    text = "\n".join(lines)
    return text if chance.random() < 0.95 else text[: chance.randrange(len(text))]


def attempt(reader: BuildingReader, path: Path) -> bool:
    """Return whether a file is read, else it is refused with issues; a text that is made is a case file."""
    issues: tuple[Issue, ...] = ()
    try:
        case = reader.convert(path, "", "own")
    except gs.InputError as error:
        issues = error.issues
    if issues:
        assert all(issue.found and issue.expected for issue in issues)
        return False
    assert case.report_text()
    casefile.tables(case.text)
    return True


@pytest.mark.slow
@pytest.mark.parametrize("batch", range(examples(6)))
def test_damaged_files(batch: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Damaged files, in processes that go on until one of them ends: a good part of them can still be read."""
    process = BoundedProcess(partial(load_libraries, BuildingReader.kind.libraries), BuildingReader.kind.memory)
    # to start one takes longer than to read the file
    monkeypatch.setattr(
        file_reader, "BoundedProcess", lambda *_: SimpleNamespace(call=process.call, close=lambda: None)
    )
    text, reader = house(), BuildingReader(seconds=30)
    path, read = tmp_path / "house.ifc", 0
    for number in range(20):
        path.write_text(damage(text, random.Random(1000 * batch + number)), encoding="latin-1")
        read += attempt(reader, path)
    process.close()
    assert 2 <= read <= 18


def test_a_building_that_takes_too_long_or_too_much(tmp_path: Path) -> None:
    """Time and memory are bounded, and the message says which of them ran out."""
    building = Building()
    building.slab()
    round_one = building.profile("IfcCircleProfileDef", Radius=0.1)
    for number in range(300):
        building.add("IfcColumn", f"K{number}", round_one, 3, turned(0, 1 + number / 100, 2))
    path = building.write(tmp_path / "house.ifc")
    with pytest.raises(gs.InputError, match=r"takes longer than 0.01 s to read"):
        BuildingReader(seconds=0.01).convert(path, "", "own")
    with pytest.raises(gs.InputError, match="takes too much memory to read"):
        BuildingReader(memory=1_000_000).convert(path, "", "own")


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The command writes the case and reports; damaged files end with issues and exit code 2."""
    path = tmp_path / "house.ifc"
    path.write_text(house(), encoding="utf-8")
    assert main.main(["import-ifc", str(path), "--origin", "center", "-o", str(tmp_path / "case.toml")]) == 0
    assert "IfcColumn          2" in capsys.readouterr().err
    assert casefile.tables((tmp_path / "case.toml").read_text(encoding="utf-8"))["title"] == "Raft"
    assert main.main(["import-ifc", str(path), "-o", str(tmp_path / "case.toml")]) == 2
    path.write_text(house()[:700], encoding="utf-8")
    assert main.main(["import-ifc", str(path)]) == 2
    assert "Traceback" not in capsys.readouterr().err
