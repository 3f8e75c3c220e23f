"""Records for machines that bend bars: checksums, straight and U-shaped bars, what stands in an existing file."""

from __future__ import annotations

from pathlib import Path

import pytest

import groundslab
from groundslab.design.bars.positions import positions
from groundslab.errors import InputError
from groundslab.views.bars.bvbs import checksum, is_bvbs, to_bvbs
from helpers.laid_slab import model_of

#: Another bar at the top.
THICK = {"diameter": 0.020, "spacing": 0.2}


def blocks(record: str) -> list[str]:
    """Return the parts of a record."""
    return record.removesuffix("@").split("@")


def test_the_checksum_is_that_of_the_guideline() -> None:
    """Letters a to e: 495, @ 64, C 67; 626 leaves 18 of 32, and 96 - 18 = 78."""
    assert checksum("abcde@C") == 78


def test_the_checksum_of_printed_records() -> None:
    """Two records that version 3.1 of the guideline prints, of an angle and of a bar with hooks of 180 degrees."""
    start = "BF2D@HjTestPDF@r417@ia@p1@"
    assert checksum(f"{start}l1000@n10@e0.888@d12@gB500A@s48@v@Gl400@w90@l600@w0@C") == 72
    assert checksum(f"{start}l800@n10@e0.710@d12@gB500A@s48@v@Gl100@w180@l600@w180@l100@w0@C") == 71


def test_straight_bars() -> None:
    """One record for each position: number, length, mass and steel as in the bar list, the mandrel by the code."""
    project = {"name": "Halle @ Süd", "part": "Bodenplatte", "revision": "B"}
    slab = model_of(top_x=THICK, top_y=THICK).replace(project=project)
    records = to_bvbs(slab).splitlines()
    listed = positions(slab)
    assert len(records) == len(listed) == 4
    for record, position in zip(records, listed, strict=True):
        *about, mark, length, number, mass, diameter, steel, mandrel, reserved, leg, angle, _ = blocks(record)
        assert (about, steel, reserved) == (["BF2D", "HjHalle Sud", "r", "iB"], "g500", "v")
        millimeters = round(float(position.lengths[0]) * 1000)
        assert (mark, length, leg, angle) == (f"p{position.mark}", f"l{millimeters}", f"Gl{millimeters}", "w0")
        assert number == f"n{len(position.lengths)}"
        # 7850 kg/m3 of a round bar
        size = position.bars.diameter
        assert float(mass[1:]) == pytest.approx(7850 * 3.14159265 * size**2 / 4 * millimeters / 1000, abs=6e-4)
        assert diameter == f"d{size * 1000:g}"
        assert mandrel == ("s48" if size == 0.012 else "s140")


def test_bars_around_edges_have_three_legs() -> None:
    """Of U shape: leg, back and leg make the cut length, with right angles between them."""
    slab = model_of(detailing={"bar_length": 12.0})
    bent = [position for position in positions(slab) if position.shape == "U"]
    assert bent
    records = {blocks(record)[4]: blocks(record) for record in to_bvbs(slab).splitlines()}
    for position in bent:
        *_, first, turn, back, again, last, end, _ = records[f"p{position.mark}"]
        assert (turn, again, end) == ("w90", "w90", "w0")
        legs = [int(part.removeprefix("G")[1:]) for part in (first, back, last)]
        assert legs[0] == legs[2] == round(1000 * (position.lap or 0))
        assert sum(legs) == round(1000 * position.lengths[0])
        # what covers of 40 mm, along y of 52 mm, leave of 300 mm
        assert legs[1] == pytest.approx(220 if position.layer == "edges_x" else 196, abs=1)


def test_meshes_alone_have_no_records(tmp_path: Path) -> None:
    """Meshes are delivered as sheets; a file without a record is not written."""
    meshes = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"))
    slab = model_of(**meshes, bottom_mesh="Q335A", top_mesh="Q335A")
    with pytest.raises(InputError, match="welded meshes alone"):
        groundslab.write_bars(slab, tmp_path / "bars.abs")
    assert not (tmp_path / "bars.abs").exists()


def test_only_records_are_replaced(tmp_path: Path) -> None:
    """What it wrote is replaced; a file with another line, or a wrong checksum, is not."""
    path = groundslab.write_bars(model_of(), tmp_path / "bars.abs")
    content = path.read_bytes()
    assert is_bvbs(content.decode())
    assert groundslab.write_bars(model_of(), path).read_bytes() == content
    for damaged in (content + b"notes\r\n", content.replace(b"@n", b"@m", 1)):
        path.write_bytes(damaged)
        with pytest.raises(InputError, match="records of BVBS"):
            groundslab.write_bars(model_of(), path)
