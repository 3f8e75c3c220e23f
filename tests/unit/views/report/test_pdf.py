"""The report on paper: standards, bookmarks, the same bytes."""

from __future__ import annotations

import io
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from pypdf import PdfReader

import groundslab
from groundslab.cli import main as cli
from groundslab.errors import GroundslabError
from groundslab.languages import Language
from groundslab.results.results import results_of
from groundslab.views.files import results_folder
from groundslab.views.report.content import build_report
from groundslab.views.report.document import Figures
from groundslab.views.report.pdf import _Writer
from helpers import synthetic
from helpers.languages import in_language


def test_standards_and_bookmarks(tmp_path: Path) -> None:
    """It can be read aloud and archived, says its language, and has a bookmark for each chapter, in their order."""
    results = in_language(results_of(synthetic.results()), "de")
    reader = PdfReader(groundslab.write_report(results, tmp_path / "report.pdf"))
    metadata = reader.xmp_metadata
    assert metadata is not None
    about = metadata.stream.get_data().decode()
    assert re.search(r"pdfaid:part>2<.*pdfaid:conformance>A<", about, re.DOTALL)
    assert "pdfuaid:part>1<" in about
    root: Any = reader.trailer["/Root"]
    assert (root["/Lang"], root["/MarkInfo"]["/Marked"]) == ("de", True)
    outline = [each.title for each in reader.outline if not isinstance(each, list)]
    assert outline == ["Zeichnungen", "Lasten", "Extremwerte", "Bilder", "Annahmen und Vorzeichen", "Tabellen"]


@pytest.mark.parametrize(("given", "size"), [({}, (595, 842)), ({"units": "US"}, (612, 792))])
def test_paper_is_that_of_the_units(given: dict[str, str], size: tuple[int, int], tmp_path: Path) -> None:
    """A4, letter where units are those of the United States, and what the case asks for."""
    model = synthetic.model().replace(project={"name": "slab", **given})
    reader = PdfReader(groundslab.write_report(synthetic.results(model=model), tmp_path / "a.pdf", chapters=["loads"]))
    assert (round(reader.pages[0].mediabox.width), round(reader.pages[0].mediabox.height)) == size
    letter = synthetic.model().replace(report={"paper": "letter"})
    reader = PdfReader(groundslab.write_report(synthetic.results(model=letter), tmp_path / "b.pdf", chapters=["loads"]))
    assert round(reader.pages[0].mediabox.width) == 612


def test_every_map_has_its_frame() -> None:
    """On the page maps refer to what the first one has; on paper, where each is a file, each has it."""
    results = results_of(synthetic.results())
    writer = _Writer("en", str)
    report = build_report(results, length="short", chapters=["pictures"])
    blocks = [block for chapter in report.chapters for block in chapter.blocks]
    drawings = [drawing for block in blocks if isinstance(block, Figures) for drawing in block.drawings]
    for drawing in drawings:
        writer._of_drawing(drawing)
    assert len(drawings) > 1
    assert "<use" in drawings[1].svg
    assert [svg.count(b'id="frame-of-maps"') for svg in writer.drawings.values()] == [1] * len(drawings)
    assert not any(b'<use href="#frame-of-maps"/>' in svg for svg in writer.drawings.values())


def test_is_replaced_and_the_same(tmp_path: Path) -> None:
    """The command writes the same bytes each time, and replaces no PDF that is not its own."""
    folder = results_folder.save_results(synthetic.results(), tmp_path / "slab")
    made = []
    for _ in range(2):
        assert cli.main(["report", str(folder), "--pdf"]) == 0
        made.append((tmp_path / "slab.pdf").read_bytes())
    assert made[0] == made[1]
    assert len(PdfReader(io.BytesIO(made[0])).pages) > 2
    (tmp_path / "slab.pdf").write_bytes(b"%PDF-1.7 of another program")
    assert cli.main(["report", str(folder), "--pdf"]) == 2


def test_with_another_ending(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A name that contradicts --pdf is refused."""
    folder = results_folder.save_results(synthetic.results(), tmp_path / "slab")
    assert cli.main(["report", str(folder), "--pdf", "--out", str(tmp_path / "slab.html")]) == 2
    assert "ends in .pdf" in capsys.readouterr().err


def test_long_words_and_titles_stay_on_the_page(tmp_path: Path) -> None:
    """What is too long for its line is broken, at the head of pages cut with an ellipsis; nothing runs off the page."""
    name = "#$\\<\"'@*_`" + "9" * 290
    model = synthetic.model().replace(title=f"A title {name}", project={"number": name, "client": "X" * 300})
    reader = PdfReader(groundslab.write_report(synthetic.results(model=model), tmp_path / "a.pdf", chapters=["loads"]))
    right: list[float] = []

    def visit(text: str, _: Any, matrix: list[float], *__: Any) -> None:
        if text.strip():
            right.append(matrix[4])

    text = reader.pages[0].extract_text(visitor_text=visit)
    assert max(right) < 595 - 40  # each piece of text begins before the margin of 15 mm
    assert "…" in text
    assert text.replace("\u200b", "").replace("\n", "").count("9" * 290) == 2  # in full as title and as number


@pytest.mark.parametrize(
    ("language", "said"), [("en", "Strength was not checked"), ("de", "Festigkeit wurde nicht nachgewiesen")]
)
def test_what_is_not_checked_is_said(language: Language, said: str, tmp_path: Path) -> None:
    """The first page says what no check looks at, also where the design fails."""
    model = synthetic.model().replace(limits={"settlement": "1 mm"})  # it settles by 28 mm
    results = in_language(results_of(synthetic.results(model=model)), language)
    text = PdfReader(groundslab.write_report(results, tmp_path / "a.pdf", chapters=["loads"])).pages[0].extract_text()
    assert groundslab.check_design(results).status == "fails"
    assert said in " ".join(text.split())


def test_without_results(tmp_path: Path) -> None:
    """Where no combination has a result, all chapters are made, and the first page says where the reasons are."""
    results = replace(results_of(synthetic.results()), results={}, refused={"all loads": GroundslabError("too soft")})
    text = PdfReader(groundslab.write_report(results, tmp_path / "a.pdf", length="full")).pages[0].extract_text()
    assert "Why: see combinations without results." in " ".join(text.split())
