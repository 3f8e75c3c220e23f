"""Bars and links as they are cut and bent: sides, hooks and mandrels by the clauses, by hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.design.bars.bending import BentBar, bent_bars, grade_of
from groundslab.design.bars.positions import positions
from groundslab.design.codes.aci318 import detailing as aci318
from groundslab.design.codes.en1992_2004 import detailing as en1992
from groundslab.design.rules.punching_links.layout import LinkLayout, LinkPerimeter
from helpers import linked_slab
from helpers.laid_slab import model_of


def links_of(**steel: Any) -> dict[str, BentBar]:
    """Return the links of the footing by their marks, counted from the first one."""
    slab = linked_slab.model(**linked_slab.LINKS, **steel)
    first = len(positions(slab)) + 1
    bars = [bar for bar in bent_bars(slab) if bar.layer == "links"]
    names = [bar.mark.partition("-") for bar in bars]
    return {f"{int(mark) - first}{dash}{part}": bar for (mark, dash, part), bar in zip(names, bars, strict=True)}


def test_mandrels() -> None:
    """4 and 7 diameters by EN 1992-1-1 Table 8.1N; 6, 8 and 10 by ACI 318-19 Table 25.3.1, of stirrups 4 and 6."""
    assert [en1992.RULE.bends.mandrel(size) for size in (0.016, 0.02)] == [0.064, pytest.approx(0.14)]
    bends = aci318.RULE.bends
    found = [bends.mandrel(size) for size in (0.0254, 0.0358, 0.043)]
    assert found == pytest.approx([6 * 0.0254, 8 * 0.0358, 10 * 0.043])
    found = [bends.link_mandrel(size) for size in (0.015875, 0.01905)]
    assert found == pytest.approx([4 * 0.015875, 6 * 0.01905])


def test_hooks() -> None:
    """EN 1992-1-1 Figure 8.5: 5 d and 50 mm, 10 d and 70 mm; ACI 318-19 Table 25.3.2: 6 d and 3 in, thick ones 12 d."""
    hook = en1992.RULE.bends.hook
    assert [hook(size, 135) for size in (0.008, 0.012)] == pytest.approx([0.050, 0.060])
    assert [hook(size, 90) for size in (0.006, 0.012)] == pytest.approx([0.070, 0.120])
    hook = aci318.RULE.bends.hook
    assert [hook(size, 135) for size in (0.009525, 0.01905)] == pytest.approx([0.0762, 6 * 0.01905])
    assert [hook(size, 90) for size in (0.009525, 0.01905)] == pytest.approx([0.0762, 12 * 0.01905])


def test_links_of_beams_are_closed_and_their_inner_legs_single() -> None:
    """A strip of 1 m by 0.6 m with covers of 50 mm: 0.9 m across, 0.5 m upright; two of four legs are inner ones."""
    links = links_of()
    assert list(links) == ["0", "1-1", "1-2", "2"]
    closed, inner, rib = links["1-1"], links["1-2"], links["2"]
    hook = 0.060 + 0.024 + 0.012  # 5 d, half of the mandrel of 4 d, and d
    assert closed.legs == pytest.approx((hook, 0.9, 0.5, 0.9, 0.5, hook))
    assert closed.bends == (135, 90, 90, 90, 135)
    assert (closed.number, closed.mandrel) == (41, pytest.approx(0.048))
    assert closed.length == pytest.approx(2 * 0.9 + 2 * 0.5 + 2 * hook)
    assert inner.legs == pytest.approx((hook, 0.5, 0.120 + 0.024 + 0.012))
    assert (inner.number, inner.bends) == (82, (135, 90))
    # a rib 0.4 m wide, 0.5 m below a slab of 0.6 m; 10 mm: 50 + 20 + 10 mm
    assert rib.legs == pytest.approx((0.08, 0.3, 1.0, 0.3, 1.0, 0.08))
    assert rib.number == 9


def test_legs_in_the_slab_have_a_hook_at_each_end() -> None:
    """8 mm: the least straight parts, 50 and 80 mm, with half of the mandrel and the bar itself."""
    leg = links_of()["0"]
    assert leg.legs == pytest.approx((0.050 + 0.024, 0.5, 0.080 + 0.024))
    assert (leg.number, leg.shape) == (40, "leg")


def test_links_of_a_code_without_known_rules_have_no_hooks() -> None:
    """By EN 1992-1-1:2023 a closed link is its four sides."""
    links = links_of(code="EN 1992-1-1:2023")
    assert (links["1-1"].legs, links["1-1"].bends) == ((0.9, 0.5, 0.9, 0.5), (90, 90, 90))
    assert (links["0"].legs, links["0"].bends, links["0"].mandrel) == ((0.5,), (), None)


def test_studs_are_not_bent() -> None:
    """By ACI 318 studs around a column are as long as the layout says, whatever the code says of hooks."""
    row = LinkPerimeter(0.15, 1.2, 1e-4, 1.01e-4, 0.6, 0.7, np.zeros((3, 2)))
    layout = LinkLayout("column", "C", (0.0, 0.0), "ULS", "by hand", 0.0127, 0.2, (row,))
    given = {"of": "C", "diameter": 0.0127, "distances": (0.15,), "legs": (3,), "kind": "studs"}
    slab = model_of(code="ACI 318").replace(columns=[{"name": "C", "x": 0, "y": 0, "width_x": 0.4, "width_y": 0.4}])
    assert slab.reinforcement is not None
    slab = slab.replace(reinforcement=slab.reinforcement.replace(links=[given]))
    stud = bent_bars(slab, [layout])[-1]
    assert (stud.shape, stud.legs, stud.number) == ("stud", (0.2,), 3)
    leg = bent_bars(model_of(code="ACI 318"), [layout])[-1]
    hook = 0.0762 + 2 * 0.0127 + 0.0127  # 6 d = 3 in
    assert leg.legs == pytest.approx((hook, 0.2, hook), abs=1e-3)


def test_bars_are_those_of_the_positions() -> None:
    """Every bar once, as long as there to half a millimeter; U-shaped ones have equal legs."""
    slab = model_of(detailing={"bar_length": 12.0})
    bars = bent_bars(slab)
    for position in positions(slab):
        own = [bar for bar in bars if bar.mark.split("-")[0] == str(position.mark)]
        assert sum(bar.number for bar in own) == len(position.lengths)
        assert sum(bar.total for bar in own) == pytest.approx(position.total, abs=5e-4 * len(position.lengths))
        if position.shape == "U":
            assert {(bar.bends, bar.sides[0] == bar.sides[2]) for bar in own} == {((90, 90), True)}


def test_bars_are_cut_to_inches_where_these_are_the_units() -> None:
    """A slab of 44 ft by 24 ft 1/4 in has bars of 44 ft and of 24 ft; hooks and sides are whole quarters of an inch."""
    slab = model_of(code="ACI 318", f_yk=60 * 6.894757e6)
    plate = slab.plate.model_copy(update={"length_x": 44 * 0.3048, "length_y": (24 * 12 + 0.25) * 0.0254})
    slab = slab.replace(plate=plate, project={"units": "US"})
    lengths = {round(bar.length / 0.0254, 9) for bar in bent_bars(slab)}
    assert lengths == {44 * 12, 24 * 12}
    detailed = slab.replace(reinforcement=slab.reinforcement.replace(detailing={"bar_length": 18.0}))  # type: ignore[union-attr]
    around = [bar for bar in bent_bars(detailed) if bar.shape == "U"]
    quarters = np.array([side for bar in around for side in bar.sides]) / (0.0254 / 4)
    assert len(around)
    assert quarters == pytest.approx(np.rint(quarters), abs=1e-9)
    row = LinkPerimeter(0.15, 1.2, 1e-4, 1.01e-4, 0.6, 0.7, np.zeros((3, 2)))
    leg = bent_bars(slab, [LinkLayout("column", "C", (0.0, 0.0), "ULS", "by hand", 0.0127, 0.2032, (row,))])[-1]
    # #4: 3 in, half of the mandrel of 4 d, and d: 4.5 in; between covers 8 in
    assert leg.legs == pytest.approx((4.5 * 0.0254, 8 * 0.0254, 4.5 * 0.0254))


def test_grades_by_their_names() -> None:
    """Grade 60 of ASTM A615 is 60 ksi, or 420 MPa by its metric sister; by EN 1992-1-1 a class, or f_yk in MPa."""
    ksi = 6.894757293168e6
    for strength, name in ((60 * ksi, "Grade 60"), (420e6, "Grade 60"), (80 * ksi, "Grade 80"), (500e6, "500")):
        slab = model_of(code="ACI 318", f_yk=strength)
        assert slab.reinforcement is not None
        assert grade_of(slab.reinforcement) == name
    assert grade_of(model_of(f_yk=500e6).reinforcement) == "500"  # type: ignore[arg-type]
