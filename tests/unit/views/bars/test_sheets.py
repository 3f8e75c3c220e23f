"""Bars on sheets of paper: scales, what stands where, labels apart from each other, PDF and DXF read back."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.cli import main, plot
from groundslab.design.bars.positions import positions
from groundslab.design.rules.punching_links.layout import LinkLayout, LinkPerimeter
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.drawing.shapes import Circle, Line, Text
from groundslab.views.drawing.sheets.dimensions import chain, levels_of, points_of, written
from groundslab.views.drawing.sheets.draw import LAYERS, TITLES, draw_sheets
from groundslab.views.drawing.sheets.paper import PAPERS, Margins, Sheet, choose_scale
from groundslab.views.drawing.sheets.placing import box_of
from groundslab.views.files import results_folder
from helpers import linked_slab, synthetic
from helpers.laid_slab import model_of

COLUMNS = [{"name": name, "x": x, "y": y, "width_x": 0.4, "width_y": 0.4} for name, x, y in (
    ("A", -3.0, -2.0), ("B", 0.5, -2.0), ("C", 3.0, 2.0), ("D", -3.0, 2.0))]  # fmt: skip
#: Zones over each other and side by side, at columns and at an edge.
ZONES = [
    {"name": name, "shape": {"kind": "rectangle", "x": x, "y": y}, "diameter": 0.014, "spacing": 0.2,
     "layers": ["bottom_x", "bottom_y"]}
    for name, x, y in (
        ("one", (-4.0, -2.0), (-3.0, -1.0)), ("two", (-3.5, -2.5), (-2.5, -1.5)), ("three", (-0.5, 1.5), (-3.0, -1.0)),
        ("four", (2.0, 4.8), (1.0, 3.0)), ("five", (-4.8, -2.0), (1.2, 2.8)), ("six", (1.75, 3.25), (-3.0, -1.5)),
    )
]  # fmt: skip


def slab(**changes: Any) -> Model:
    """Return a slab of 9.6 m by 7.2 m with four columns and six zones of bars at the bottom."""
    steel: dict[str, Any] = {"zones": ZONES, "detailing": {"bar_length": 6.0}} | changes
    project = {"name": "Office", "part": "Raft", "number": "17", "revision": "b", "date": "1 May"}
    return model_of(**steel).replace(title="Raft", columns=COLUMNS, project=project)


def links() -> list[LinkLayout]:
    """Return links around column A: two perimeters of eight legs."""
    turns = np.linspace(0.0, 2 * np.pi, 8, endpoint=False)
    around = np.stack([np.cos(turns), np.sin(turns)], axis=1)
    rows = [LinkPerimeter(r - 0.2, 6.3 * r, 1e-4, 1e-4, 0.3, 0.4, (-3.0, -2.0) + r * around) for r in (0.3, 0.5)]
    return [LinkLayout("column", "A", (-3.0, -2.0), "ULS", "by hand", 0.010, 0.22, tuple(rows))]


@cache
def drawn(paper: Any) -> Sequence[Sheet]:
    """Return the sheets of the slab with links on a paper."""
    return tuple(draw_sheets(slab(), links(), paper))


def texts_of(sheet: Sheet) -> list[Text]:
    """Return the texts of a sheet."""
    return [shape for shape in sheet.shapes if isinstance(shape, Text)]


def of_layer(sheet: Sheet, layer: str) -> list[Line]:
    """Return the lines of a layer."""
    return [shape for shape in sheet.shapes if isinstance(shape, Line) and shape.layer == layer]


def test_the_largest_scale_that_fits() -> None:
    """On A3 250 mm by 277 mm are for the plan: 10 m by 8 m with 20 mm around fit at 1:50, not at 1:25."""

    def around(_: float) -> Margins:
        return Margins(20.0, 20.0, 20.0, 20.0)

    scale, origin = choose_scale("a3", (0.0, 10.0, 0.0, 8.0), around)
    assert scale == 50
    # in the middle of what is left
    assert origin == pytest.approx((20 + (260 - 200) / 2, 10 + (277 - 160) / 2))
    assert choose_scale("a1", (0.0, 22.0, 0.0, 8.0), around)[0] == 50
    assert choose_scale("a3", (0.0, 10.0, 0.0, 8.0), around, 75)[0] == 75
    with pytest.raises(InputError, match="fits on A3 at 1:200"):
        choose_scale("a3", (0.0, 60.0, 0.0, 8.0), around)


def test_a_sheet_for_each_layer_for_edges_and_for_links() -> None:
    """All at one scale, numbered, with the plan to scale; the list has the marks of the layer alone."""
    of = slab()
    sheets = drawn("a2")
    assert [sheet.title for sheet in sheets] == list(TITLES.values())
    assert len({sheet.scale for sheet in sheets}) == 1
    marks = []
    for number, sheet in enumerate(sheets, start=1):
        (outline,) = of_layer(sheet, "OUTLINE")
        assert np.ptp(outline.points, axis=0) == pytest.approx([9600 / sheet.scale, 7200 / sheet.scale])
        words = [text.words for text in texts_of(sheet) if text.layer == "TITLE"]
        assert {"Office", "Raft", "17", "b", "1 May", f"{number} / 7", f"1 : {sheet.scale}", "A2"} <= set(words)
        assert words.count(sheet.title) == 2
        rows = [text for text in texts_of(sheet) if text.layer == "TABLE"][6::6]
        marks += [row.words.partition("-")[0] for row in rows]
    assert sorted(set(map(int, marks))) == list(range(1, len(positions(of)) + 2))


@pytest.mark.parametrize("paper", ["a1", "a2", "a3"])
def test_no_text_covers_another(paper: Any) -> None:
    """On none of the sheets, with six zones of which one lies in another; all texts are within the frame."""
    for sheet in drawn(paper):
        texts = texts_of(sheet)
        boxes = {id(text): np.array(box_of(text)).reshape(2, 2) for text in texts}
        for one, other in combinations(texts, 2):
            low = np.maximum(boxes[id(one)][0], boxes[id(other)][0]) + 0.5
            high = np.minimum(boxes[id(one)][1], boxes[id(other)][1]) - 0.5
            assert not (high - low > 0.0).all(), (sheet.title, one.words, other.words)
        every = np.concatenate(list(boxes.values()))
        (frame, *_) = sorted(of_layer(sheet, "FRAME"), key=lambda line: -np.ptp(line.points[:, 0]))
        assert (every.min(axis=0) > frame.points.min(axis=0)).all()
        assert (every.max(axis=0) < frame.points.max(axis=0)).all()


def test_each_set_has_a_bar_its_extent_and_its_label() -> None:
    """Of zone three along x: 2 m bars over 2 m at 200 mm, ten of them, the line across from the first to the last."""
    of = slab(detailing=None)
    sheet = draw_sheets(of, (), "a2")[0]
    place = [
        (np.array(line.points) - sheet.origin) / sheet.per_meter
        for line in of_layer(sheet, "BARS_BOTTOM_X")
        if not line.closed
    ]
    inside = [points for points in place if (points > [-0.51, -3.01]).all() and (points < [1.51, -0.99]).all()]
    flat = [points for points in inside if np.ptp(points[:, 1]) < 1e-9]
    upright = [points for points in inside if np.ptp(points[:, 0]) < 1e-9]
    assert sum(np.ptp(points[:, 0]) for points in flat) <= 2.0 + 1e-9
    assert any(points[:, 1] == pytest.approx([-2.9, -1.1]) for points in upright)
    words = [text.words for text in texts_of(sheet)]
    assert words.count("10 \N{LATIN SMALL LETTER O WITH STROKE}14 / 200") >= 2
    assert "2.00 \N{MULTIPLICATION SIGN} 2.00" in words


def test_pieces_that_lap_are_drawn_and_said() -> None:
    """9.6 m less two covers of 40 mm in two pieces of (9.52 + lap) / 2."""
    of = slab(zones=[])
    base = positions(of)[0]
    sheet = draw_sheets(of, (), "a2")[0]
    lines = [line for line in of_layer(sheet, "BARS_BOTTOM_X") if np.ptp(line.points[:, 1]) < 1e-9]
    ends = np.array([line.points[:, 0] for line in lines])
    assert len({round(float(line.points[0, 1]), 6) for line in lines}) == 2
    assert np.ptp(ends) == pytest.approx(9.52 * sheet.per_meter)
    assert base.lap is not None
    assert f"lap {base.lap:.2f} m" in [text.words for text in texts_of(sheet)]


def test_sheets_in_customary_units() -> None:
    """A slab of 31 ft 6 in by 23 ft 7 1/2 in: feet and inches, and inches of paper for a foot, 1/4 in at 1 : 48."""
    of = slab(zones=[])
    plate = of.plate.model_copy(update={"length_x": 31.5 * 0.3048, "length_y": (23 * 12 + 7.5) * 0.0254})
    project = {"name": "Office", "units": "US"}
    sheet = draw_sheets(of.replace(plate=plate, project=project), (), "a2")[0]
    words = {text.words for text in texts_of(sheet)}
    assert {"31'-6\"", "23'-7 1/2\""} <= words
    assert {24: '1/2" = 1\'-0"', 32: '3/8" = 1\'-0"', 48: '1/4" = 1\'-0"'}[sheet.scale] in words
    (outline,) = of_layer(sheet, "OUTLINE")
    assert np.ptp(outline.points[:, 0]) == pytest.approx(31.5 * 304.8 / sheet.scale)
    inch = 0.0254
    assert [written(length * inch, "US") for length in (11.97, 0.125, 150)] == ["1'-0\"", "0'-0 1/8\"", "12'-6\""]


def test_wires_of_meshes_are_listed() -> None:
    """Q335A on both faces: 7.2 m / 150 mm wires of 9.6 m along x, 9.6 m / 150 mm of 7.2 m along y, of 8 mm."""
    meshes: dict[str, Any] = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"))
    of = slab(zones=[], detailing=None, **meshes, bottom_mesh="Q335A", top_mesh="Q335A")
    sheets = draw_sheets(of, (), "a2")
    assert len(sheets) == 4
    for sheet, number, length in zip(sheets, (48, 64, 48, 64), (9.6, 7.2, 9.6, 7.2), strict=True):
        row = [text.words for text in texts_of(sheet) if text.layer == "TABLE"][6:12]
        mass = number * length * np.pi * 0.008**2 / 4 * 7850
        assert row[1:] == ["8", f"{number}", f"{length:.3f}", f"{number * length:.3f}", f"{mass:.1f}"]


def test_links_of_beams_have_the_line_along_which_they_stand() -> None:
    """A strip of 8 m has 41 links over 8 m; of the rib those from 1 m to 3 m of its way lie over 2 m of it."""
    sheet = draw_sheets(linked_slab.model(**linked_slab.LINKS), (), "a3")[-1]
    lines = [(line.points - sheet.origin) / sheet.per_meter for line in of_layer(sheet, "LINKS") if not line.closed]
    flat = [line[:, 0].tolist() for line in lines if np.ptp(line[:, 1]) < 1e-9 and np.ptp(line[:, 0]) > 1.0]
    assert flat == [pytest.approx([-4.0, 4.0]), pytest.approx([-3.0, -1.0])]
    assert {"over 8.00 m", "over 2.00 m"} <= {text.words for text in texts_of(sheet)}


def test_chains_of_dimensions() -> None:
    """Points that are alike are one; numbers that have no space stand higher; their sum is the whole."""
    assert points_of([0.0, 2.0, 2.0004, 5.0, 1.0]) == [0.0, 1.0, 2.0, 5.0]
    assert [written(length) for length in (2.0, 0.125, 12.3)] == ["2.00", "0.125", "12.30"]
    assert levels_of([0.0, 0.05, 0.1, 5.0], 20.0, "SI") == [0, 1, 0]
    shapes = list(chain([-1.0, 0.5, 3.0], 0, 10.0, (100.0, 50.0), 20.0, "SI", str))
    lines = [shape.points for shape in shapes if isinstance(shape, Line)]
    assert lines[0].tolist() == [[80.0, 10.0], [160.0, 10.0]]
    assert [shape.words for shape in shapes if isinstance(shape, Text)] == ["1.50", "2.50"]
    upright = list(chain([-1.0, 0.5, 3.0], 1, 10.0, (100.0, 50.0), 20.0, "SI", str))
    assert isinstance(upright[0], Line)
    assert upright[0].points.tolist() == [[10.0, 30.0], [10.0, 110.0]]


def test_links_are_dots_with_marks() -> None:
    """Each leg where it is; the label says perimeters and distances."""
    sheet = drawn("a2")[-1]
    dots = [shape for shape in sheet.shapes if isinstance(shape, Circle) and shape.layer == "LINKS"]
    places = np.concatenate([row.places for row in links()[0].perimeters]) * sheet.per_meter + sheet.origin
    assert np.array([dot.center for dot in dots[: len(places)]]) == pytest.approx(places)
    words = [text.words for text in texts_of(sheet) if text.layer == "LINKS"]
    assert words[1:] == ["2 x 8 links \N{LATIN SMALL LETTER O WITH STROKE}10", "s_0 100, s_r 200"]


def test_pdf_read_back(tmp_path: Path) -> None:
    """A page of A3 for each sheet with its texts, the same bytes each time, in German with commas."""
    pypdf = pytest.importorskip("pypdf")
    project = {"name": "Büro", "language": "de"}
    path = groundslab.write_bars(slab().replace(project=project), tmp_path / "bars.pdf", paper="a3")
    content = path.read_bytes()
    pages = pypdf.PdfReader(path).pages
    assert len(pages) == 6
    for page, words in zip(pages, ("Untere Bewehrung in x", "Untere Bewehrung in y"), strict=False):
        size = (float(page.mediabox.width), float(page.mediabox.height))
        assert size == pytest.approx((420 / 25.4 * 72, 297 / 25.4 * 72), abs=0.1)
        text = page.extract_text()
        assert all(part in text for part in (words, "Büro", "9,60"))
    assert groundslab.write_bars(slab().replace(project=project), path, paper="a3").read_bytes() == content
    path.write_bytes(b"%PDF-1.7 of somebody else")
    with pytest.raises(InputError, match="did not write"):
        groundslab.write_bars(slab(), path, paper="a3")


def test_dxf_read_back(tmp_path: Path) -> None:
    """Without faults, on layers of these names; the first plan lies where the case has it, in meters."""
    ezdxf = pytest.importorskip("ezdxf")
    path = groundslab.write_bars(slab(), tmp_path / "bars.dxf", paper="a2")
    document = ezdxf.readfile(path)
    assert not document.audit().errors
    assert {layer.dxf.name for layer in document.layers} >= set(LAYERS)
    outlines = [np.array(line.get_points("xy")) for line in document.modelspace().query('LWPOLYLINE[layer=="OUTLINE"]')]
    assert len(outlines) == 6
    first = min(outlines, key=lambda points: float(points[:, 0].min()))
    assert first.min(axis=0) == pytest.approx([-4.8, -3.6])
    assert first.max(axis=0) == pytest.approx([4.8, 3.6])
    assert not document.modelspace().query("*[layer=='0']")


def test_what_is_refused(tmp_path: Path) -> None:
    """Other endings and sizes of paper."""
    with pytest.raises(InputError, match=r"\.pdf or \.dxf"):
        groundslab.write_bars(slab(), tmp_path / "bars.svg", paper="a1")
    with pytest.raises(InputError, match="one of"):
        groundslab.write_bars(slab(), tmp_path / "bars.pdf", paper="a4")  # type: ignore[arg-type]


def test_hostile_names_are_shown(tmp_path: Path) -> None:
    """Control characters, marks and letters that the font lacks neither break files nor warn; long names are cut."""
    ezdxf = pytest.importorskip("ezdxf")
    names = ["\x1b[31mred\x07", "\u202e84.04\u202c", "\u4e2d\u6587", "long " * 26, "</text><b>&amp;"]
    columns = [
        {"name": name, "x": -4.0 + 2 * n, "y": 1.0, "width_x": 0.4, "width_y": 0.4} for n, name in enumerate(names)
    ]
    of = slab(zones=[], detailing=None).replace(columns=columns, title=names[0], project={"name": names[1]})
    path = groundslab.write_bars(of, tmp_path / "bars.pdf", paper="a2")
    assert path.read_bytes().startswith(b"%PDF-")
    document = ezdxf.readfile(groundslab.write_bars(of, tmp_path / "bars.dxf", paper="a2"))
    assert not document.audit().errors
    words = {text.dxf.text for text in document.modelspace().query("TEXT")}
    assert all(text.isprintable() and len(text) < 60 for text in words)
    assert "</text><b>&amp;" in words


def test_command(tmp_path: Path) -> None:
    """RESULTS-bars-a2.pdf beside the folder, or the file that --out names; the command knows all sizes."""
    assert plot.PAPERS == PAPERS
    of = slab(zones=[], detailing=None)
    of = of.replace(combinations=of.combinations[:1])
    each = synthetic.results(model=of, combination="ULS", limit_state="ultimate", factors=(("G", 1.35),))
    folder = tmp_path / "slab-results"
    results_folder.save_results(Results(of, of.combinations, {"ULS": each}, {}), folder)
    assert main.main(["bars", str(folder), "--paper", "a2"]) == 0
    assert (tmp_path / "slab-results-bars-a2.pdf").read_bytes().startswith(b"%PDF-")
    assert main.main(["bars", str(folder), "--paper", "a2", "--out", str(tmp_path / "bars.svg")]) == 2
