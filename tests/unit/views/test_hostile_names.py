"""One set of hostile names goes through every output: none obeys it, hides it, turns it around or breaks by it."""

from __future__ import annotations

import csv
import json
import re
import unicodedata
import xml.etree.ElementTree as ElementTree
import zipfile
from html.parser import HTMLParser
from pathlib import Path

import pytest

import groundslab
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.results.results import Results
from groundslab.schema.toml_writer import value

HOSTILE = [
    "\x1b[31mred\x1b[8m\x1b]0;title\x07",
    "a\rNo failure found",
    "b\nNo failure found\u2028on\u2029.",
    "load \u202e84.04\u202c",
    "\u2066isolated\u2069",
    "A\u200b",
    "A\u2060",
    "A\ufeff",
    "A\u3164",
    "A\ufe0f",
    "A\U000e0041",
    "\x08\x0b\x0c\x7f\x9b31m",
    "\ue000\ufffe",
    "=HYPERLINK(1)",
    "@SUM(1)",
    "+1+1",
    "-2+cmd",
    "</script><b>&amp;\"'",
    "שלום",
    "long " * 26 + "one",
    "long " * 26 + "two",
]
COUNT = len(HOSTILE)
#: Those of combinations, by their numbers here.
COMBINED = (0, 3, 5, 13, 16, 18, 19, 20)


def case_text() -> str:
    """Return a case whose title, project, axes, cases, combinations, columns, supports and outputs have these names."""
    names = [value(name) for name in HOSTILE]
    axes = [name for name in names if "/" not in name]  # which stands between axes that cross
    each = range(COUNT)
    x = [f"{-4.5 + 9 * n / COUNT:.2f} m" for n in each]
    parts = [
        f"title = {names[3]}\n[project]\nname = {names[0]}\nclient = {names[18]}\nauthor = {names[4]}\n[plate]",
        'length_x = "10 m"\nlength_y = "4 m"\nthickness = "0.3 m"\nE = "30 GPa"\nnu = 0.2\n[mesh]\nsize = "1 m"',
        '[ground]\nkind = "winkler"\nk = "20 MN/m3"',
        f'[[axes]]\nkind = "straight"\nnames = [{", ".join(axes)}]\ndistances = "{len(axes) - 1} x 0.4 m"\n'
        'origin = ["-4 m", "-1 m"]\nangle = 0',
    ]
    parts += [f'[[cases]]\nname = {name}\naction = "permanent"' for name in names]
    parts += [f'[[loads]]\nkind = "uniform"\ncase = {name}\nq = "{n + 1} kPa"' for n, name in enumerate(names)]
    parts += [
        f"[[combinations]]\nname = {names[n]}\nfactors = {{ {names[n]} = 1.0, {names[n - 1]} = 1.2 }}" for n in COMBINED
    ]
    parts += [
        f'[[columns]]\nname = {name}\nx = "{x[n]}"\ny = "0 m"\ndiameter = "0.1 m"' for n, name in enumerate(names)
    ]
    parts += [
        f'[[supports]]\nkind = "point"\nname = {name}\nx = "{x[n]}"\ny = "1.5 m"\nstiffness = "1 MN/m"'
        for n, name in enumerate(names)
    ]
    parts += [f'[[output.points]]\nname = {name}\nx = "{x[n]}"\ny = "-1.5 m"' for n, name in enumerate(names)]
    parts += [
        f'[[output.lines]]\nname = {name}\nstart = ["-4 m", "0.1 m"]\nend = ["4 m", "0.1 m"]' for name in names[:3]
    ]
    return "\n".join(parts) + "\n"


def unseen(text: str) -> set[str]:
    """Return what of a text is obeyed or not seen, by Unicode's categories and its list of ignorable letters."""
    letters = set(text)
    odd = {
        letter for letter in letters if unicodedata.category(letter) in ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp")
    } | set("\u3164\ufe0f") & letters
    return {f"{ord(letter):04x}" for letter in odd - set("\n\t")}


@pytest.fixture(scope="module")
def case(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a case file with hostile names."""
    path = tmp_path_factory.mktemp("hostile") / "slab.toml"
    path.write_text(case_text(), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def folder(case: Path) -> Path:
    """Return the results of that case in a folder."""
    return groundslab.save_results(groundslab.solve(groundslab.load(case)), case.with_name("slab-results"))


@pytest.fixture(scope="module")
def results(folder: Path) -> Results:
    """Return the results that are read back."""
    return groundslab.load_results(folder)


def test_names_differ_as_they_are_shown(results: Results) -> None:
    """A name with a letter that nobody sees is shown with its number; the case and the results read back agree."""
    columns = [column.name for column in results.model.columns]
    assert len(set(columns)) == COUNT
    assert list(results) == [columns[n] for n in COMBINED]
    assert unseen("".join(columns)) == set()
    assert columns[3] == "load \\u202e84.04\\u202c"
    assert columns[5:8] == ["A\\u200b", "A\\u2060", "A\\ufeff"]
    assert casefile.loads(casefile.to_toml(results.model)) == results.model


@pytest.mark.slow
def test_terminal(case: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """`check`, `solve` and an import report print no escape, no return and nothing unseen."""
    assert main.main(["check", str(case)]) == 0
    assert main.main(["solve", str(case), "--out", str(tmp_path / "out")]) == 0
    saf = tmp_path / "case.xlsx"
    assert main.main(["export-saf", str(case), "--out", str(saf)]) == 0
    assert main.main(["import-saf", str(saf), "--out", str(tmp_path / "back.toml")]) == 0
    shown = capsys.readouterr()
    assert unseen(shown.out) == set()
    assert unseen(shown.err) == set()
    assert not re.search(r"^No failure found", shown.out + shown.err, re.MULTILINE)


class _Texts(HTMLParser):
    """The texts of a page, and those in elements that isolate them."""

    def __init__(self) -> None:
        super().__init__()
        self.inside: list[str] = []
        self.isolated: list[str] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: object) -> None:  # noqa: ARG002
        self.inside.append(tag)

    def handle_endtag(self, tag: str) -> None:
        self.inside = self.inside[: len(self.inside) - 1 - self.inside[::-1].index(tag)] if tag in self.inside else []

    def handle_data(self, data: str) -> None:
        if "שלום" in data and not {"script", "svg", "pre", "title"} & set(self.inside):
            (self.isolated if self.inside[-1] == "bdi" else self.open).append(data)


@pytest.mark.slow
def test_pages(folder: Path, tmp_path: Path) -> None:
    """A report holds nothing unseen but in its own script, and isolates words that run to the left."""
    page = tmp_path / "report.html"
    assert main.main(["report", str(folder), "--out", str(page)]) == 0
    html = page.read_text(encoding="utf-8")
    assert unseen(re.sub(r"<script>.*?</script>", "", html, flags=re.DOTALL)) == set()
    texts = _Texts()
    texts.feed(html)
    assert len(texts.isolated) > 3
    assert texts.open == []


@pytest.mark.slow
def test_drawings_and_files_for_paraview_are_xml(folder: Path, tmp_path: Path) -> None:
    """SVG files of plans, lines and bars, VTU and PVD files are read by an XML parser; PDF and DXF are written."""
    names = ["--combination", "A\\u200b"]
    for number, options in enumerate(([], ["--kind", "lines"], ["--kind", "convergence"])):
        out = tmp_path / f"{number}.svg"
        assert main.main(["plot", str(folder), *names, *options, "--out", str(out)]) == 0
        text = out.read_text(encoding="utf-8")
        ElementTree.fromstring(text)
        assert unseen(text) == set()
    assert main.main(["plot", str(folder), *names, "--out", str(tmp_path / "a.pdf")]) == 0
    assert main.main(["plot", str(folder), *names, "--out", str(tmp_path / "a.dxf")]) == 0
    assert unseen((tmp_path / "a.dxf").read_text(encoding="utf-8")) == set()
    for path in (*folder.rglob("*.vtu"), *folder.rglob("*.pvd")):
        if path.suffix == ".pvd" or path.parent.name.startswith("01"):
            ElementTree.fromstring(re.sub(rb"<AppendedData.*?</AppendedData>", b"", path.read_bytes(), flags=re.DOTALL))


@pytest.mark.slow
def test_tables(folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """No cell of a CSV file or of a workbook is a formula; JSON has the names as they are shown."""
    begun = set()
    for path in folder.rglob("*.csv"):
        text = path.read_text(encoding="utf-8")
        assert unseen(text) == set()
        for cell in (cell for row in csv.reader(text.splitlines()) for cell in row):
            assert not re.match(r"[=@]|[+-](?![0-9.]*(e[+-][0-9]+)?$)", cell), f"{path.name}: {cell}"
            begun |= {cell[:2]} & {"'=", "'@", "'+", "'-"}
    assert begun == {"'=", "'@", "'+", "'-"}
    book = tmp_path / "tables.xlsx"
    assert main.main(["tables", str(folder), "--out", str(book)]) == 0
    with zipfile.ZipFile(book) as parts:
        for name in parts.namelist():
            text = parts.read(name).decode()
            ElementTree.fromstring(text)
            assert "<f>" not in text
            assert unseen(text) - {"000d"} == set()
    capsys.readouterr()
    assert main.main(["tables", str(folder), "--json", "--only", "supports"]) == 0
    (table,) = json.loads(capsys.readouterr().out)["tables"]
    values = [value for column in table["columns"] for value in column["values"] if isinstance(value, str)]
    assert "A\\u200b" in values
    assert unseen("".join(values)) == set()


@pytest.mark.slow
def test_long_names_in_a_file_for_other_programs(case: Path, tmp_path: Path) -> None:
    """Names above 100 letters are shortened alike where things are named and where they are meant, and stay apart."""
    openpyxl = pytest.importorskip("openpyxl")
    saf = tmp_path / "case.xlsx"
    assert main.main(["export-saf", str(case), "--out", str(saf)]) == 0
    book = openpyxl.load_workbook(saf)
    sheets = {sheet.title: list(sheet.iter_rows(values_only=True)) for sheet in book.worksheets}
    cases = [row[0] for row in sheets["StructuralLoadCase"][1:]]
    assert len(set(cases)) == len(cases) >= COUNT
    assert max(map(len, cases)) <= 100
    head, *combinations = sheets["StructuralLoadCombination"]
    columns = [number for number, name in enumerate(head) if str(name).startswith("Load case name")]
    used = {row[number] for row in combinations for number in columns if row[number]}
    assert used <= set(cases)
    assert len([name for name in used if len(name) == 100]) == 2
    assert all(len(row[0]) <= 100 for row in combinations)
    for sheet in ("StructuralSurfaceAction", "StructuralSurfaceActionFree"):
        for row in sheets.get(sheet, [])[1:]:
            assert row[list(sheets[sheet][0]).index("Load case")] in cases
