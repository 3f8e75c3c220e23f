"""The drawing of bars: what stands in it, read back by ezdxf; files of others stay as they are."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from groundslab.cli import main
from groundslab.design.bars.bar_layout import BarSet, bar_sets
from groundslab.design.bars.positions import Position, positions
from groundslab.design.rules.punching_links.layout import LinkLayout, LinkPerimeter
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.bars import write_bars
from groundslab.views.drawing.bars import LAYERS, draw, label_of
from groundslab.views.drawing.shapes import Circle, Line, Text
from groundslab.views.files import results_folder
from groundslab.views.tables.bar_quantities import bars
from helpers import synthetic

BASE = {"diameter": 0.012, "spacing": 0.15}
ZONE = {"name": "under C", "shape": {"kind": "circle", "centre": (-2, -1), "radius": 1}, "diameter": 0.016,
        "spacing": 0.2, "layers": ["bottom_x", "bottom_y"]}  # fmt: skip


def model(**changes: Any) -> Model:
    """Return a slab with an opening, a column, bars in all layers and a zone at the bottom."""
    parts: dict[str, Any] = {
        "title": "A slab",
        "plate": {"length_x": synthetic.LENGTH_X, "length_y": synthetic.LENGTH_Y, "thickness": 0.2, "E": 23e9,
                  "nu": 0.17, "openings": [{"kind": "rectangle", "x": (1, 2), "y": (1, 2)}]},
        "ground": {"kind": "winkler", "k": 20e6},
        "columns": [{"name": "C", "x": -2, "y": -1, "width_x": 0.4, "width_y": 0.4}],
        "cases": [{"name": "G"}],
        "loads": [{"kind": "uniform", "q": 1e4, "case": "G"}],
        "combinations": [{"name": "ULS", "factors": {"G": 1.35}}],
        "reinforcement": {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05), "bottom_x": BASE,
                          "bottom_y": BASE, "top_mesh": "Q335A", "zones": [ZONE]},
    }  # fmt: skip
    return Model(**parts | changes)


def test_legs_of_links_are_dots_with_a_label_on_a_layer_of_their_own() -> None:
    """One dot for each leg in the plan of the bottom, the label within the slab, a row with the mark in the table."""
    places = np.array([[3.4, 0.0], [3.6, 0.2]])
    row = LinkPerimeter(0.15, 1.2, 1e-4, 1.01e-4, 0.6, 0.7, places)
    end = LinkPerimeter(0.3, 1.2, 1e-4, 1.01e-4, 0.6, 0.7, places + 0.1)
    links = LinkLayout("column", "C", (3.3, 0.0), "ULS", "by hand", 0.008, 0.12, (row, end))
    shapes = draw(model(), [links, LinkLayout("column", "D", (0.0, 0.0), "ULS", "by hand", why="too thin")])
    mark = len(positions(model())) + 1
    dots = [shape for shape in shapes if isinstance(shape, Circle) and shape.layer == "LINKS"]
    assert np.array([dot.center for dot in dots]) == pytest.approx(np.vstack([places, places + 0.1]))
    (label,) = (shape for shape in shapes if isinstance(shape, Text) and shape.layer == "LINKS")
    assert label.words == f"({mark}) 2 x 2 links \N{LATIN SMALL LETTER O WITH STROKE}8, s_0 150, s_r 150"
    table = bars(model(), [links])
    assert table.rows()[-2][:3] == (mark, "links", "column C")
    assert any("shear_reinforcement" in note for note in table.notes)
    assert {shape.layer for shape in draw(model())} <= set(LAYERS) - {"LINKS"}


def test_dxf_read_back(tmp_path: Path) -> None:
    """In meters, on layers of these names: outline and opening of both faces, column, a bar of each set, labels."""
    ezdxf = pytest.importorskip("ezdxf")
    path = write_bars(model(), tmp_path / "bars.dxf")
    document = ezdxf.readfile(path)
    assert document.header["$INSUNITS"] == 6
    assert {layer.dxf.name for layer in document.layers} >= set(LAYERS)
    assert not document.audit().errors
    space = document.modelspace()

    def lines(layer: str) -> list[np.ndarray]:
        return [np.array(line.get_points("xy")) for line in space.query(f'LWPOLYLINE[layer=="{layer}"]')]

    outlines = lines("OUTLINE")
    assert len(outlines) == 2
    for each in outlines:
        assert np.ptp(each, axis=0) == pytest.approx([synthetic.LENGTH_X, synthetic.LENGTH_Y])
    bottom, top = (each.min(axis=0) for each in outlines)
    assert bottom == pytest.approx([-synthetic.LENGTH_X / 2, -synthetic.LENGTH_Y / 2])
    assert top[0] == pytest.approx(bottom[0])
    assert top[1] < bottom[1] - synthetic.LENGTH_Y
    assert lines("OPENINGS")[0].min(axis=0) == pytest.approx([1, 1])
    assert len(lines("COLUMNS")) == 2
    assert len(lines("BAR_ZONES")) == 1
    sets = bar_sets(model())
    for layer in ("bottom_x", "bottom_y", "top_x", "top_y"):
        own = [each for each in sets if each.layer == layer]
        # a bar, a line across and its two ends, for each set
        assert len(lines(f"BARS_{layer.upper()}")) == 4 * len(own)
        words = [text.dxf.text for text in space.query(f'TEXT[layer=="BARS_{layer.upper()}"]')]
        assert words == [label_of(of_set(each), "SI") for each in own]


def of_set(one: BarSet) -> list[Position]:
    """Return the positions of a set of the model's bars."""
    return [position for position in positions(model()) if (position.layer, position.zone) == (one.layer, one.zone)]


def test_labels_and_table_say_what_the_table_of_results_says() -> None:
    """7.2 m hold 48 bars along x at 150 mm, 6 of them cut in two by the opening: 54 pieces; the sum stands below."""
    one = bar_sets(model())[0]
    assert label_of(of_set(one), "SI") == "(1-3) 54 ø12 / 150, l = 2.80 to 9.60 m"
    shapes = draw(model())
    written = [shape.words for shape in shapes if isinstance(shape, Text) and shape.layer == "TABLE"]
    table = bars(model())
    numbers = [float(words) for words in written if words.replace(".", "", 1).isdigit()]
    assert any(number == pytest.approx(table["mass"][-1], rel=5e-4) for number in numbers)
    assert any("Laps" in words for words in written)
    mesh = of_set(bar_sets(model())[-1])
    assert label_of(mesh, "SI").startswith(f"({mesh[0].mark}-{mesh[-1].mark}) Q335A: ")


def test_a_bar_that_is_drawn_is_one_of_its_set() -> None:
    """Of each set one bar is drawn, no short piece; the line across ends at the first and the last bar there."""
    for each in (one for one in bar_sets(model()) if one.layer.startswith("bottom")):
        layer = f"BARS_{each.layer.upper()}"
        own = [shape.points for shape in draw(model()) if isinstance(shape, Line) and shape.layer == layer]
        bar, across = own[4:6] if each.zone else own[:2]
        (found,) = [number for number, ends in enumerate(each.ends) if np.allclose(bar, ends)]
        assert each.lengths[found] > each.lengths.max() / 2
        place, side = across[0, each.axis], 1 - each.axis
        met = [ends[0, side] for ends in each.ends if ends[0, each.axis] <= place <= ends[1, each.axis]]
        assert across[:, side] == pytest.approx([min(met), max(met)])


def test_same_bytes_and_no_file_of_others(tmp_path: Path) -> None:
    """A second drawing replaces the first with the same bytes; a file of others, or of another kind, is refused."""
    pytest.importorskip("ezdxf")
    for ending in ("dxf", "svg"):
        path = tmp_path / f"bars.{ending}"
        first = write_bars(model(), path).read_bytes()
        assert write_bars(model(), path).read_bytes() == first
        path.write_bytes(b"0\nSECTION\n<svg></svg>")
        with pytest.raises(InputError, match="did not write"):
            write_bars(model(), path)
    assert b"12 / 150" in first
    with pytest.raises(InputError, match="ends with"):
        write_bars(model(), tmp_path / "bars.doc")


def test_no_bars_to_draw(tmp_path: Path) -> None:
    """Without bars that are laid there is nothing to draw, and no file."""
    steel = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)}
    for given in (None, steel):
        with pytest.raises(InputError, match="bars in all four layers"):
            write_bars(model(reinforcement=given), tmp_path / "bars.svg")
    assert not list(tmp_path.iterdir())


def test_command(tmp_path: Path) -> None:
    """RESULTS-bars.svg and .dxf beside the folder, or one file where --out says."""
    pytest.importorskip("ezdxf")
    each = synthetic.results(model=model(), combination="ULS", limit_state="ultimate", factors=(("G", 1.35),))
    folder = tmp_path / "slab-results"
    results_folder.save_results(Results(model(), model().combinations, {"ULS": each}, {}), folder)
    assert (folder / "tables" / "bars.csv").exists()
    assert main.main(["bars", str(folder)]) == 0
    assert main.main(["bars", str(folder), "--out", str(tmp_path / "other.dxf")]) == 0
    assert (tmp_path / "slab-results-bars.dxf").read_bytes() == (tmp_path / "other.dxf").read_bytes()
    assert (tmp_path / "slab-results-bars.svg").exists()
    assert main.main(["bars", str(folder), "--out", str(tmp_path / "other.doc")]) == 2
