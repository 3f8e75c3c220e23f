"""How many links of beams and against one-way shear a case lays, of which length, in the table and the drawing."""

from __future__ import annotations

import math

import pytest

from groundslab.design.bars.further_links import further_links
from groundslab.model.plate import Zone
from groundslab.views.drawing.bars import draw
from groundslab.views.drawing.shapes import Text
from groundslab.views.tables.bar_quantities import bars
from helpers.linked_slab import LINKS, model


def test_numbers_and_lengths_by_hand() -> None:
    """Closed links around what the covers leave of the section; legs where the slab is, not beside it."""
    east, strip, rib = further_links(model(**LINKS))
    assert (east.number, east.length) == (round(2.0 / (0.2 * 0.25)), pytest.approx(0.5))
    assert (strip.number, strip.length) == (41, pytest.approx(2 * 0.9 + 4 * 0.5))
    assert (rib.number, rib.length) == (9, pytest.approx(2 * 0.3 + 2 * 1.0))
    assert strip.mass == pytest.approx(41 * 3.8 * 7850 * math.pi * 0.006**2)


def test_lengths_follow_the_thickness_there() -> None:
    """In a thicker zone links are longer by what it is thicker; a later zone counts, and so do thicker bars there."""
    zone = {"shape": {"kind": "rectangle", "x": (3.0, 4.0), "y": (-0.5, 0.5)}, "thickness": 0.8}
    of = model(**LINKS)
    thick = of.replace(plate=of.plate.model_copy(update={"zones": (Zone.model_validate(zone),)}))
    zoned, plain, *beams = further_links(thick)
    assert (zoned.number, zoned.length, zoned.corners) == (20, pytest.approx(0.7), (3.0, -0.5, 4.0, 0.5))
    assert (plain.number, plain.length, plain.corners) == (20, pytest.approx(0.5), (2.0, -0.5, 3.0, 0.5))
    strips = [(each.number, each.length) for each in beams if each.name == "S"]
    # links at 0, 0.2, ... 8 m, those from 7 m on in the zone
    assert strips == [(35, pytest.approx(2 * 0.9 + 4 * 0.5)), (6, pytest.approx(2 * 0.9 + 4 * 0.7))]
    bars = {"name": "Z", "shape": zone["shape"], "layers": ["top_x"], "diameter": 0.032, "spacing": 0.15}
    axes = {"cover": None, "bottom": (0.06, 0.08), "top": (0.06, 0.08)}
    zoned, plain, *_ = further_links(model(**LINKS, **axes, zones=[bars]).replace(plate=thick.plate))
    assert plain.length == pytest.approx(0.6 - 2 * (0.06 - 0.016 / 2))
    assert zoned.length == pytest.approx(0.8 - (0.06 - 0.016 / 2) - (0.06 - 0.032 / 2))


def test_table_and_drawing_have_them() -> None:
    """Each with the same mark; the sum has their mass with the hooks of Figure 8.5.

    Those are 5 d or 50 mm at 135 degrees, 10 d or 70 mm at 90, each with half of the mandrel of 4 d and the bar itself:
    96 and 156 mm of 12 mm, 80 mm of 10 mm, 74 and 104 mm of 8 mm. Of four legs two are single ones.
    """
    of = model(**LINKS)
    table, without = bars(of), bars(model())
    assert list(table["zone"])[-4:-1] == ["east", "S", "R"]
    lengths = {
        0.008: 40 * (0.074 + 0.5 + 0.104),
        0.010: 9 * (2 * 0.3 + 2 * 1.0 + 2 * 0.08),
        0.012: 41 * (2 * 0.9 + 2 * 0.5 + 2 * 0.096) + 82 * (0.096 + 0.5 + 0.156),
    }
    more = sum(7850 * math.pi / 4 * diameter**2 * length for diameter, length in lengths.items())
    assert list(table["mass"])[-4:-1] == pytest.approx(
        [7850 * math.pi / 4 * size**2 * lengths[size] for size in (0.008, 0.012, 0.010)]
    )
    assert float(table["mass"][-1]) == pytest.approx(float(without["mass"][-1]) + more)
    labels = [str(shape.words) for shape in draw(of) if isinstance(shape, Text) and shape.layer == "LINKS"]
    marks = [f"({mark})" for mark in list(table["mark"])[-4:-1]]
    assert [label.split()[0] for label in labels] == marks
