"""Plans of results as drawings: contours on their levels, layers, files read back by ezdxf and by groundslab."""

from __future__ import annotations

from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.exchange import dxf
from groundslab.geometry.plan import Ring
from groundslab.model.model import Model
from groundslab.views.files import results_folder
from helpers import synthetic

ezdxf = pytest.importorskip("ezdxf")

#: Contours of the bowl w = 28 mm (1 - 2 r^2) by chords of its values at nodes: with n by n elements, whose nodes are at
#: most R / n apart for R^2 = (L_x^2 + L_y^2) / 4, a chord is below the bowl by up to (R / n)^2 w'' / 8, and w'' is
#: 112 mm / R^2.
N, OFF = 20, 14.0 / 20**2


def drawn(path: Path) -> Any:
    """Return a drawing, in which ezdxf finds nothing wrong."""
    document = ezdxf.readfile(path)
    auditor = document.audit()
    assert not auditor.errors
    assert not auditor.fixes
    return document


def lines(document: Any, layer: str) -> list[tuple[float, np.ndarray]]:
    """Return the contours on a layer: their values, and their places."""
    found = document.modelspace().query(f'LWPOLYLINE[layer=="{layer}"]')
    return [(line.get_xdata("GROUNDSLAB")[1].value, np.array(line.get_points("xy"))) for line in found]


def bowl(places: np.ndarray) -> np.ndarray:
    """Return the settlement of the made-up results [mm]."""
    return 28 * (1 - 2 * (places**2).sum(axis=1) / (synthetic.LENGTH_X**2 / 4 + synthetic.LENGTH_Y**2 / 4))


def test_contours_are_on_their_levels(tmp_path: Path) -> None:
    """Each place of a contour has the value that its data say, within the bound of chords."""
    groundslab.plot(synthetic.results(N), "settlement", to=tmp_path / "plan.dxf")
    document = drawn(tmp_path / "plan.dxf")
    assert document.units == 6
    contours = lines(document, "SETTLEMENT")
    assert {value for value, _ in contours} == {-25, -20, -15, -10, -5, 0, 5, 10, 15, 20, 25}
    for value, places in contours:
        above = bowl(places) - value
        assert above.min() > -1e-9
        assert above.max() < OFF
    (tags,) = {
        tuple(tag.value for tag in line.get_xdata("GROUNDSLAB") if tag.code == 1000)
        for line in document.modelspace().query('LWPOLYLINE[layer=="SETTLEMENT"]')
    }
    assert tags == ("settlement", "mm")


def test_words_beside_contours_are_their_values(tmp_path: Path) -> None:
    """Each label is beside a contour of that value, not upside down; small closed contours stay one line."""
    groundslab.plot(synthetic.results(N), "settlement", to=tmp_path / "plan.dxf")
    document = drawn(tmp_path / "plan.dxf")
    contours = lines(document, "SETTLEMENT")
    h = max(synthetic.LENGTH_X, synthetic.LENGTH_Y) / 90
    texts = list(document.modelspace().query('TEXT[layer=="SETTLEMENT VALUES"]'))
    assert len(texts) >= len({value for value, _ in contours})
    for text in texts:
        value = float(text.dxf.text.replace("\N{MINUS SIGN}", "-"))
        _, at, _ = text.get_placement()
        distances = [np.hypot(*(places - (at.x, at.y)).T).min() for level, places in contours if level == value]
        assert min(distances) < 1.5 * h
        assert -90 < text.dxf.rotation <= 90
    closed = [line for line in document.modelspace().query('LWPOLYLINE[layer=="SETTLEMENT"]') if line.closed]
    # the bowl is at most 7.84 mm deep at the edge
    assert [line.get_xdata("GROUNDSLAB")[1].value for line in closed] == [10, 15, 20, 25]


def test_extremes_are_marked(tmp_path: Path) -> None:
    """Rings are at the largest and the smallest value, which words beside them say."""
    groundslab.plot(synthetic.results(N), "settlement", to=tmp_path / "plan.dxf")
    space = drawn(tmp_path / "plan.dxf").modelspace()
    rings = [(ring.dxf.center.x, ring.dxf.center.y) for ring in space.query('CIRCLE[layer=="SETTLEMENT EXTREMES"]')]
    words = sorted(text.dxf.text for text in space.query('TEXT[layer=="SETTLEMENT EXTREMES"]'))
    assert words == ["max 28", "min \N{MINUS SIGN}28"]
    assert rings[0] == pytest.approx((0, 0))
    assert np.abs(rings[1]) == pytest.approx([synthetic.LENGTH_X / 2, synthetic.LENGTH_Y / 2])


def test_contours_go_on_where_elements_of_different_size_meet(tmp_path: Path) -> None:
    """On large elements beside small ones, half as large, the contours of a moment are whole."""
    coarse, fine = (synthetic.grid(n, 2 * n, synthetic.LENGTH_X / 2, synthetic.LENGTH_Y) for n in (5, 10))
    shift = np.array([synthetic.LENGTH_X / 4, 0])
    nodes = np.vstack([coarse[0] - shift, fine[0] + shift])
    elements = np.vstack([coarse[1], fine[1] + len(coarse[0])])
    base = synthetic.results(2)
    values = {f.name: np.zeros(len(nodes), dtype=getattr(base.plate, f.name).dtype) for f in fields(base.plate)
              if isinstance(getattr(base.plate, f.name), np.ndarray)}  # fmt: skip
    moment = 1e4 * (nodes[:, 0] ** 2 + 2 * nodes[:, 1] ** 2)
    plate = replace(base.plate, **values | {"nodes": nodes, "elements": elements, "moment_x": moment})
    plate = replace(plate, in_contact=np.ones(len(nodes), dtype=bool), area=np.ones(len(nodes)))
    results = replace(base, plate=plate, elements=synthetic.elements_of(plate, base.model))
    groundslab.plot(results, "moment_x", to=tmp_path / "plan.dxf")
    document = drawn(tmp_path / "plan.dxf")
    inside = 10 * (synthetic.LENGTH_X / 2) ** 2  # [kNm/m] ellipses below it are whole
    levels = [value for value, _ in lines(document, "MOMENT_X") if value < inside]
    assert len(levels) > 3
    assert len(levels) == len(set(levels))
    closed = {line.get_xdata("GROUNDSLAB")[1].value: line.closed
              for line in document.modelspace().query('LWPOLYLINE[layer=="MOMENT_X"]')}  # fmt: skip
    assert all(closed[level] for level in levels)


def test_each_field_of_each_combination_has_layers_of_its_own(tmp_path: Path) -> None:
    """Those of the first one are shown; names of combinations lose what no layer's name may have."""
    groundslab.plot(synthetic.combined(), "w", "m_x", to=tmp_path / "plan.dxf")
    document = drawn(tmp_path / "plan.dxf")
    shown = {layer.dxf.name: not layer.is_off() for layer in document.layers}
    first, second = "Größe 1_2_ dead + wind (ultimate)", "NUL (ultimate)"
    assert {f"{field} {whose}" for field in ("SETTLEMENT", "MOMENT_X") for whose in (first, second)} <= set(shown)
    assert [name for name, on in shown.items() if on and name.endswith("(ultimate)")] == [f"SETTLEMENT {first}"]
    assert not shown[f"SETTLEMENT {first} NUMBERS"]


ARCS = {
    "thickness": 0.2, "E": 23e9, "nu": 0.17,
    "outline": {"kind": "polygon", "points": [(-4.8, -3.6), (4.8, -3.6), (4.8, 3.6), (-4.8, 3.6)],
                "bulges": [0.0, 0.25, 0.0, 0.0]},
    "openings": [{"kind": "circle", "centre": (2.0, 1.0), "radius": 0.5},
                 {"kind": "polygon", "points": [(-3, -3), (-2, -3), (-2, -2)]}],
}  # fmt: skip
COLUMNS = [
    {"name": "C1", "x": 0.5, "y": -1.25, "width_x": 0.4, "width_y": 0.3},
    {"name": "C2", "x": -2.0, "y": 1.0, "diameter": 0.5},
]


@pytest.mark.parametrize("system", ["SI", "US"])
def test_groundslab_reads_the_plan_back(system: str, tmp_path: Path) -> None:
    """Outline with its arc, openings and columns are the same, in meters and in feet; no loads are read."""
    parts: dict[str, Any] = {"plate": ARCS, "columns": COLUMNS, "project": {"units": system}}
    model = Model(**{name: getattr(synthetic.model(), name) for name in ("ground", "loads")} | parts)
    groundslab.plot(synthetic.results(4, model=model), "w", to=tmp_path / "plan.dxf")
    assert drawn(tmp_path / "plan.dxf").units == (6 if system == "SI" else 2)
    read = dxf.read(tmp_path / "plan.dxf")

    def assert_same(found: Ring, expected: Ring) -> None:
        np.testing.assert_allclose(found.points, expected.points, rtol=0, atol=1e-12)
        bulges = [*expected.bulges, *[0.0] * (len(expected.points) - len(expected.bulges))]
        np.testing.assert_allclose(found.bulges, bulges, rtol=0, atol=1e-12)

    assert_same(read.outline, model.plate.ring())
    for found, opening in zip(read.openings, model.plate.openings, strict=True):
        assert_same(found, opening.ring())
    for ring, column in zip(read.columns, model.columns, strict=True):
        assert isinstance(ring, Ring)
        assert_same(ring, column.ring())
    assert not read.point_loads
    assert not read.walls


def test_plans_far_away_keep_their_coordinates(tmp_path: Path) -> None:
    """At coordinates of a national grid the outline is where the case has it, to a micrometer."""
    origin = np.array([691_000.25, 5_334_000.5])
    corners = (np.array([(-4.8, -3.6), (4.8, -3.6), (4.8, 3.6), (-4.8, 3.6)]) + origin).tolist()
    plate = {"thickness": 0.2, "E": 23e9, "nu": 0.17, "outline": {"kind": "polygon", "points": corners}}
    base = synthetic.model()
    far = Model(plate=plate, ground=base.ground, loads=[{"kind": "uniform", "q": 1e3}])
    results = synthetic.results(4, model=far)
    results = replace(results, plate=replace(results.plate, nodes=results.plate.nodes + origin))
    groundslab.plot(results, "w", to=tmp_path / "plan.dxf")
    read = dxf.read(tmp_path / "plan.dxf")
    np.testing.assert_allclose(read.outline.points, corners, rtol=0, atol=1e-6)
    centered = dxf.center(read)
    np.testing.assert_allclose(centered.outline.points, np.array(corners) - origin, rtol=0, atol=1e-6)


def test_the_same_results_give_the_same_bytes_and_other_files_stay(tmp_path: Path) -> None:
    """A drawing of groundslab is replaced by the next one, that of another program is not."""
    results = synthetic.results(3)
    groundslab.plot(results, "w", to=tmp_path / "a.dxf")
    groundslab.plot(results, "w", to=tmp_path / "b.dxf")
    assert (tmp_path / "a.dxf").read_bytes() == (tmp_path / "b.dxf").read_bytes()
    groundslab.plot(results, "p", to=tmp_path / "a.dxf")
    assert (tmp_path / "a.dxf").read_bytes() != (tmp_path / "b.dxf").read_bytes()
    ezdxf.new().saveas(tmp_path / "other.dxf")
    with pytest.raises(InputError, match="a file that groundslab did not write"):
        groundslab.plot(results, "w", to=tmp_path / "other.dxf")


def test_only_plans_are_drawings(tmp_path: Path) -> None:
    """Another kind of figure is refused, and nothing is written."""
    with pytest.raises(InputError, match='"plan" as a drawing'):
        groundslab.plot(synthetic.results(), kind="deformed", to=tmp_path / "plan.dxf")
    assert not list(tmp_path.iterdir())


def test_the_command_writes_a_drawing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """`groundslab plot --out` with a name that ends in .dxf."""
    results_folder.save_results(synthetic.results(3), tmp_path / "slab")
    assert main.main(["plot", str(tmp_path / "slab"), "m_x", "--out", str(tmp_path / "plan.dxf")]) == 0
    assert "plan.dxf" in capsys.readouterr().err
    assert lines(drawn(tmp_path / "plan.dxf"), "MOMENT_X")
