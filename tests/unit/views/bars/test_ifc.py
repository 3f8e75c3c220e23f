"""Bars as a building model, read back by IfcOpenShell: each bar with its size and where its solid lies."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.design.bars.bending import bent_bars
from groundslab.design.bars.placed import leg_axis, placed_bars
from groundslab.design.bars.positions import positions
from groundslab.design.rules.punching_links.layout import LinkLayout, LinkPerimeter
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.model.plate import Zone
from groundslab.views.bars import left_out
from groundslab.views.bars.ifc import axis_points, to_bytes
from groundslab.views.tables.bending_schedule import NO_DETAILING
from helpers.laid_slab import model_of
from helpers.linked_slab import LINKS
from helpers.linked_slab import model as linked

ifcopenshell = pytest.importorskip("ifcopenshell")
#: Bars far from each other, so that there are few.
FEW = {layer: {"diameter": 0.012, "spacing": 2.4} for layer in ("bottom_x", "bottom_y", "top_x", "top_y")}


def links(mark: str = "C") -> LinkLayout:
    """Return two legs of 10 mm that are 0.208 m high."""
    row = LinkPerimeter(0.15, 1.2, 1e-4, 1.01e-4, 0.6, 0.7, np.array([[1.0, 0.5], [1.2, 0.5]]))
    return LinkLayout("column", mark, (1.1, 0.5), "ULS", "by hand", 0.010, 0.208, (row,))


def box_of(bar: Any) -> np.ndarray:
    """Return the least and the greatest coordinates (2, 3) of a bar's solid in the world [m]."""
    geom = pytest.importorskip("ifcopenshell.geom")
    settings = geom.settings()
    settings.set("use-world-coords", True)
    verts = np.array(geom.create_shape(settings, bar).geometry.verts).reshape(-1, 3)
    return np.array([verts.min(axis=0), verts.max(axis=0)])


def test_straight_bars_read_back(tmp_path: Path) -> None:
    """9.6 m along x at 46 mm from the underside of 300 mm, 4 along it; grade, diameter and length are attributes."""
    path = groundslab.write_bars(model_of(**FEW), tmp_path / "bars.ifc")
    file = ifcopenshell.open(path)
    bars = file.by_type("IfcReinforcingBar")
    assert len(bars) == 2 * (3 + 4)
    first = [bar for bar in bars if bar.Description == "bottom x"]
    assert len(first) == 3
    for bar, y in zip(first, (-2.4, 0.0, 2.4), strict=True):
        (x0, y0, z0), (x1, y1, z1) = box_of(bar)
        assert (x0, x1) == pytest.approx((-4.8, 4.8))
        assert (y0 + y1) / 2 == pytest.approx(y, abs=1e-6)
        assert (z0, z1) == pytest.approx((-0.3 + 0.046 - 0.006, -0.3 + 0.046 + 0.006), abs=1e-4)
        assert (bar.NominalDiameter, bar.BarLength, bar.SteelGrade) == (0.012, 9.6, "500")
        assert bar.CrossSectionArea == pytest.approx(math.pi * 0.006**2)
        assert bar.PredefinedType == "MAIN"
    top = next(bar for bar in bars if bar.Description == "top y")
    assert box_of(top)[:, 2] == pytest.approx([-0.058 - 0.006, -0.058 + 0.006], abs=1e-4)


def test_groups_are_the_marks(tmp_path: Path) -> None:
    """Each mark is one group, with as many bars as the list has; all of them are in the storey."""
    slab = model_of(**FEW, detailing={"bar_length": 6.0})
    file = ifcopenshell.open(groundslab.write_bars(slab, tmp_path / "bars.ifc"))
    groups = {group.Name: group.IsGroupedBy[0].RelatedObjects for group in file.by_type("IfcGroup")}
    assert {mark: len(bars) for mark, bars in groups.items()} == {
        str(position.mark): len(position.lengths) for position in positions(slab)
    }
    assert all(bar.ContainedInStructure for bar in file.by_type("IfcReinforcingBar"))
    validate = pytest.importorskip("ifcopenshell.validate")
    logger = validate.json_logger()
    validate.validate(file, logger)
    assert logger.statements == []


def test_bars_at_edges_lie_within_the_covers(tmp_path: Path) -> None:
    """U of 12 mm: covers of 40 mm at the edge, the bottom and the top; as long inward as the leg."""
    slab = model_of(**FEW, detailing={"bar_length": 12.0})
    file = ifcopenshell.open(groundslab.write_bars(slab, tmp_path / "bars.ifc"))
    (position,) = (one for one in positions(slab) if one.layer == "edges_x")
    bars = [bar for bar in file.by_type("IfcReinforcingBar") if bar.Description == "edges x"]
    assert {bar.PredefinedType for bar in bars} == {"EDGE"}
    low, high = box_of(min(bars, key=lambda bar: float(box_of(bar)[0, 0])))
    assert position.lap is not None
    assert (low[0], high[0]) == pytest.approx((-4.8 + 0.040, -4.8 + 0.040 + position.lap), abs=2e-3)
    assert (low[2], high[2]) == pytest.approx((-0.3 + 0.040, -0.040), abs=2e-3)


def test_pieces_lap_beside_each_other() -> None:
    """Of 9.52 m in two pieces: they begin and end the cover off the edges, and overlap by the lap."""
    slab = model_of(**FEW, detailing={"bar_length": 6.0, "edge_bars": False})
    (position,) = (one for one in positions(slab) if one.layer == "bottom_x")
    one, other = [placed.corners for placed in placed_bars(slab) if placed.bar.layer == "bottom x"][:2]
    assert (one[0, 0], other[1, 0]) == pytest.approx((-4.76, 4.76))
    assert one[1, 0] - other[0, 0] == pytest.approx(position.lap)
    assert other[0, 1] - one[0, 1] == pytest.approx(0.012)


def test_bars_lie_where_the_slab_is_thin_and_in_pits_lower() -> None:
    """Along a thicker part bars stay at the underside of the thinner one; in it alone they lie deeper."""
    slab = model_of(**FEW)
    thick = {"shape": {"kind": "rectangle", "x": (0.0, 4.8), "y": (-3.6, 3.6)}, "thickness": 0.5}
    thicker = slab.replace(plate=slab.plate.model_copy(update={"zones": (Zone.model_validate(thick),)}))
    found = {(bar.bar.layer, round(float(bar.corners[0, 0]), 3)): bar.corners[0, 2] for bar in placed_bars(thicker)}
    assert found["bottom x", -4.8] == pytest.approx(-0.3 + 0.046)
    assert found["bottom y", 3.6] == pytest.approx(-0.5 + 0.058)
    assert found["bottom y", -3.6] == pytest.approx(-0.3 + 0.058)
    assert found["top y", 3.6] == pytest.approx(-0.058)


def test_legs_have_hooks_at_both_ends(tmp_path: Path) -> None:
    """10 mm: from cover to cover of the slab, the straight parts beyond the bends as Figure 8.5 asks."""
    slab = model_of(**FEW, cover=(0.046, 0.046))
    leg = bent_bars(slab, [links()])[-1]
    corners = leg_axis(leg)
    points, segments = axis_points(corners, (0.040 + 0.010) / 2)
    straight = [np.linalg.norm(points[at[1] - 1] - points[at[0] - 1]) for at in segments if len(at) == 2]
    assert straight[0] == pytest.approx(0.050, abs=1e-3)
    assert straight[-1] == pytest.approx(0.100, abs=1e-3)
    (tmp_path / "bars.ifc").write_bytes(to_bytes(slab, placed_bars(slab, [links()])))
    file = ifcopenshell.open(tmp_path / "bars.ifc")
    bars = [bar for bar in file.by_type("IfcReinforcingBar") if bar.PredefinedType == "PUNCHING"]
    assert len(bars) == 2
    low, high = box_of(bars[0])
    assert (low[2], high[2]) == pytest.approx((-0.3 + 0.046, -0.046), abs=2e-3)


def test_links_of_beams_stand_along_them(tmp_path: Path) -> None:
    """Of a strip of 1 m by 0.6 m and of a rib 0.4 m wide that ends 1.1 m deep, covers of 50 mm all around.

    Links of 12 mm every 200 mm from the start of the strip on, two of four legs inner ones; of 10 mm every 250 mm in
    the rib, from 1 m to 3 m of its way. Hooks of 135 degrees turn inward, so that the box is that of the outer sides.
    """
    slab = linked(**{**LINKS, "shear_links": []})
    file = ifcopenshell.open(groundslab.write_bars(slab, tmp_path / "bars.ifc"))
    links = [bar for bar in file.by_type("IfcReinforcingBar") if bar.PredefinedType == "LIGATURE"]
    strip, inner, rib = ([bar for bar in links if bar.BarLength == pytest.approx(length)] for length in (
        2 * 0.9 + 2 * 0.5 + 2 * 0.096, 0.096 + 0.5 + 0.156, 2 * 0.3 + 2 * 1.0 + 2 * 0.08))  # fmt: skip
    assert (len(links), len(strip), len(inner), len(rib)) == (41 + 82 + 9, 41, 82, 9)
    (x0, y0, z0), (x1, y1, z1) = box_of(strip[1])
    assert (x0, x1) == pytest.approx((-4 + 0.2 - 0.006, -4 + 0.2 + 0.012 + 0.006), abs=1e-3)
    assert (y0, y1) == pytest.approx((-0.45, 0.45), abs=2e-3)
    assert (z0, z1) == pytest.approx((-0.55, -0.05), abs=2e-3)
    (x0, y0, z0), (x1, y1, z1) = box_of(rib[-1])
    assert (x0, y0, y1) == pytest.approx((-1.005, -0.15, 0.15), abs=2e-3)
    assert (z0, z1) == pytest.approx((-1.05, -0.05), abs=2e-3)
    middles = [np.mean(box_of(bar)[:, 1]) for bar in inner[:2]]
    assert middles == pytest.approx([-0.888 / 6, 0.888 / 6], abs=1e-3)
    assert box_of(inner[0])[:, 2] == pytest.approx([-0.55, -0.05], abs=2e-3)
    assert left_out(slab, "bars.ifc") == [NO_DETAILING]
    validate = pytest.importorskip("ifcopenshell.validate")
    logger = validate.json_logger()
    validate.validate(file, logger)
    assert logger.statements == []


def test_arcs_of_a_right_angle() -> None:
    """Tangents are as long as the radius; the middle of the arc is on the bisector."""
    points, segments = axis_points(np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]]), 0.1)
    assert segments == [(1, 2), (2, 3, 4), (4, 5)]
    assert points[1] == pytest.approx([0.1, 0.0, 0.0])
    assert points[3] == pytest.approx([0.0, 0.0, 0.1])
    assert points[2] == pytest.approx([0.1 - 0.1 / math.sqrt(2), 0.0, 0.1 - 0.1 / math.sqrt(2)])


def test_same_bytes_and_no_file_of_others(tmp_path: Path) -> None:
    """A second model replaces the first with the same bytes; others are refused; what is left out is told."""
    path = groundslab.write_bars(model_of(**FEW), tmp_path / "bars.ifc")
    content = path.read_bytes()
    assert groundslab.write_bars(model_of(**FEW), path).read_bytes() == content
    titled = groundslab.write_bars(model_of(**FEW).replace(title="another raft"), tmp_path / "other.ifc").read_text()
    identifiers = re.compile(r"=IFC\w+\('([^']{22})'")
    assert not set(identifiers.findall(titled)) & set(identifiers.findall(content.decode()))
    assert len(identifiers.findall(titled)) > 10
    path.write_bytes(content.replace(b"groundslab bars", b"another program"))
    with pytest.raises(InputError, match="did not write"):
        groundslab.write_bars(model_of(**FEW), path)
    several: Model = linked(**LINKS)
    assert any("one-way shear" in words for words in left_out(several, "bars.ifc"))
    assert left_out(model_of(), "bars.ifc") == [NO_DETAILING]


def test_bars_around_thinner_edges_are_told() -> None:
    """They are as high as the thickest slab at an edge: that is said, of a slab of one thickness it is not."""
    even = model_of(detailing={})
    corner = Zone(shape={"kind": "rectangle", "x": [-4.8, -2.8], "y": [-3.6, -1.6]}, thickness=0.5)
    assert left_out(even, "bars.ifc") == []
    assert len(left_out(even.replace(plate=even.plate.replace(zones=[corner])), "bars.ifc")) == 1
