"""Design moments at supports: means over lines and values at faces, held against integrals and statics."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.design.checks import check_design
from groundslab.design.demands.cuts.section_cuts import strip
from groundslab.design.demands.design_moments import design_moments
from groundslab.design.demands.support_moments import (
    averaging_lines,
    bar_moments,
    moments_at_supports,
    support_areas,
)
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult
from helpers.solve_once import solve_once

STEEL = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.05, 0.07), "top": (0.05, 0.07)}
#: Mean effective depth of 0.5 m with these axes.
D = 0.44


def slab(averaging: dict[str, Any] | None = None, **changes: Any) -> Model:
    """Return a slab of 6 m by 4 m by 0.5 m under a column of 0.4 m by 0.3 m in its middle."""
    return Model(
        **{
            "plate": {"length_x": 6.0, "length_y": 4.0, "thickness": 0.5, "E": 33e9, "nu": 0.2},
            "ground": {"kind": "winkler", "k": 40e6},
            "columns": [{"name": "C", "x": 0, "y": 0, "width_x": 0.4, "width_y": 0.3}],
            "cases": [{"name": "G"}],
            "loads": [{"kind": "point", "case": "G", "column": "C", "P": 1e6}],
            "combinations": [{"name": "U", "factors": {"G": 1.35}}],
            "reinforcement": STEEL | {"averaging": averaging or {}},
            "mesh": {"size": 0.2},
        }
        | changes
    )


def only(model: Model) -> CombinationResult:
    """Return the results of the only combination."""
    return solve_once(model).results["U"]


def test_means_are_those_of_strips() -> None:
    """Every line of a column has the mean that a cut of a design strip has there, which is integrated exactly."""
    result = only(slab())
    steel = result.model.reinforcement
    assert steel is not None
    moments = design_moments(result.plate)
    for axis, lines in enumerate(averaging_lines(result, steel)):
        assert lines is not None
        layer = ("bottom_x", "bottom_y")[axis]
        means = lines.means @ getattr(moments, layer)
        step = 1e-6 * np.eye(2)[axis]
        exact = [
            strip(result.plate, middle - step, middle + step, float(length), 2).bottom[0]
            for middle, length in zip(lines.middle, lines.length, strict=True)
        ]
        assert len(exact) == 10
        np.testing.assert_allclose(means, exact, rtol=3e-3)


@pytest.mark.parametrize(("width", "expected"), [("c + 2 d", 2 * D), ("c + 3 h", 1.5), (0.9, None)])
def test_widths(width: str | float, expected: float | None) -> None:
    """Lines are as long as the case says: for bars along x across the column's side along y, and the other way."""
    result = only(slab({"width": width}))
    steel = result.model.reinforcement
    assert steel is not None
    (area,) = support_areas(result, steel)
    along_x, along_y = averaging_lines(result, steel)
    assert along_x is not None
    assert along_y is not None
    for lines, side in ((along_x, 0.3), (along_y, 0.4)):
        assert lines.length == pytest.approx(side + expected if expected is not None else 0.9)
    assert area.sides == (0.4, 0.3)


def test_a_pad_bears_its_statics() -> None:
    """Over a pad narrower than the width, the mean times the pad is the moment of the pressure beyond the face.

    Wood's moments add the twist's: by no more than 5 %. Bars along x bear what is beyond the face x = 0.2 m.
    """
    pad = slab(plate={"length_x": 3.0, "length_y": 1.0, "thickness": 0.5, "E": 33e9, "nu": 0.2}, mesh={"size": 0.1})
    result = only(pad)
    steel = result.model.reinforcement
    assert steel is not None
    plate = result.plate
    beyond = plate.nodes[:, 0] - 0.2
    statics = float((plate.contact_force * np.maximum(beyond, 0.0)).sum())
    of_x = next(one for one in moments_at_supports([result], steel) if one.layer == "bottom_x")
    assert of_x.width == pytest.approx(1.0, abs=0.01)
    assert of_x.place == pytest.approx((0.2, 0.0), abs=1e-6) or of_x.place == pytest.approx((-0.2, 0.0), abs=1e-6)
    assert statics < of_x.moment < 1.05 * statics
    assert of_x.peak > 1.2 * of_x.moment


def test_under_the_column_there_is_what_its_faces_have() -> None:
    """The larger of both faces counts at the nodes between them; beyond the width all is left as it is."""
    result = only(slab())
    steel = result.model.reinforcement
    assert steel is not None
    means, peaks, nodes = bar_moments(result, steel), design_moments(result.plate), result.plate.nodes
    face = next(one for one in moments_at_supports([result], steel) if one.layer == "bottom_x")
    under = (abs(nodes[:, 0]) < 0.2) & (abs(nodes[:, 1]) < 0.15)
    assert under.any()
    np.testing.assert_allclose(means.bottom_x[under], face.moment, rtol=1e-9)
    outside = (abs(nodes[:, 0]) > 0.2 + D + 1e-6) | (abs(nodes[:, 1]) > 0.15 + D + 1e-6)
    np.testing.assert_array_equal(means.bottom_x[outside], peaks.bottom_x[outside])
    assert means.bottom_x.max() < 0.8 * peaks.bottom_x.max()


def test_moments_at_the_face_alone() -> None:
    """Without a width the moments beside the face stay, and those under the column are those at its faces."""
    result = only(slab({"at_columns": "face"}))
    steel = result.model.reinforcement
    assert steel is not None
    means, peaks, nodes = bar_moments(result, steel), design_moments(result.plate), result.plate.nodes
    inside = (abs(nodes) <= np.array([0.2, 0.15])).all(axis=1)
    np.testing.assert_array_equal(means.bottom_x[~inside], peaks.bottom_x[~inside])
    middle = int(np.argmin((nodes**2).sum(axis=1)))
    at_face = strip(result.plate, (0.2 - 1e-6, 0.0), (0.2 + 1e-6, 0.0), 1e-3, 2).bottom[0]
    assert means.bottom_x[middle] == pytest.approx(at_face, rel=1e-3)
    assert means.bottom_x[middle] < 0.95 * peaks.bottom_x[middle]


def test_peaks_are_those_of_nodes() -> None:
    """With peaks asked for nothing is changed, and no table compares them."""
    result = only(slab({"at_columns": "peak", "at_walls": "peak"}))
    steel = result.model.reinforcement
    assert steel is not None
    means, peaks = bar_moments(result, steel), design_moments(result.plate)
    np.testing.assert_array_equal(means.bottom_x, peaks.bottom_x)
    names = [table.name for table in gs.tables_of(solve_once(result.model))]
    assert "support_moments" not in names
    assert "reinforcement" in names


OPENING = {"kind": "rectangle", "x": (-0.5, 0.5), "y": (0.35, 0.6)}
ZONE = {"thickness": 0.8, "shape": {"kind": "rectangle", "x": (-1.0, 1.0), "y": (-0.3, 1.0)}}


@pytest.mark.parametrize(
    ("changes", "length"),
    [
        ({"columns": [{"name": "C", "x": 0, "y": 1.8, "width_x": 0.4, "width_y": 0.3}]}, 0.2 + 0.15 + D),
        ({"plate": {"length_x": 6.0, "length_y": 4.0, "thickness": 0.5, "E": 33e9, "nu": 0.2, "openings": [OPENING]}},
         0.35 + 0.15 + D),
        ({"plate": {"length_x": 6.0, "length_y": 4.0, "thickness": 0.5, "E": 33e9, "nu": 0.2, "zones": [ZONE]}},
         0.3 + 0.15 + D + 0.3),
    ],
    ids=["edge", "opening", "step"],
)  # fmt: skip
def test_lines_end(changes: dict[str, Any], length: float) -> None:
    """At an edge, at an opening and at a step lines end, to within one of 32 parts of their half."""
    result = only(slab(**changes))
    steel = result.model.reinforcement
    assert steel is not None
    (area,) = support_areas(result, steel)
    lines = averaging_lines(result, steel)[0]
    assert lines is not None
    face = np.argmin(abs(lines.middle[:, 0] - 0.2))
    assert lines.length[face] == pytest.approx(length, abs=area.width[1] / 64)


def test_lines_end_at_a_joint() -> None:
    """What lies on the other plate is none of a column's line."""
    sides = {"thickness": 0.5, "E": 33e9, "nu": 0.2}
    model = slab(
        plate={"name": "A", "outline": {"kind": "rectangle", "x": (-3, 3), "y": (-2, 0.4)}, **sides},
        plates=[{"name": "B", "outline": {"kind": "rectangle", "x": (-3, 3), "y": (0.4, 2)}, **sides}],
        joints=[{"kind": "hinge", "between": ("A", "B")}],
        loads=[{"kind": "point", "case": "G", "column": "C", "P": 1e6}, {"kind": "uniform", "case": "G", "q": 5e4}],
    )
    result = only(model)
    steel = result.model.reinforcement
    assert steel is not None
    lines = averaging_lines(result, steel)[0]
    assert lines is not None
    assert lines.length.max() == pytest.approx(0.4 + 0.15 + D, abs=0.02)


@pytest.mark.parametrize(("at_walls", "far"), [("face", 0.15), ("quarter", 0.075)])
def test_moments_across_a_wall(at_walls: str, far: float) -> None:
    """Under a wall along y bars along x have the moment of its face, or half way to it; bars along y what they had."""
    wall = {"name": "W", "thickness": 0.3, "points": [(0, -2), (0, 2)]}
    loads = [{"kind": "line", "case": "G", "wall": "W", "q": 3e5}]
    result = only(slab({"at_walls": at_walls, "at_columns": "peak"}, columns=[], walls=[wall], loads=loads))
    steel = result.model.reinforcement
    assert steel is not None
    means, peaks, nodes = bar_moments(result, steel), design_moments(result.plate), result.plate.nodes
    on_axis = (abs(nodes[:, 0]) < 1e-9) & (abs(nodes[:, 1]) < 1.5)
    assert on_axis.any()
    for node in np.flatnonzero(on_axis)[::7]:
        y = float(nodes[node, 1])
        at_face = strip(result.plate, (far - 1e-6, y), (far + 1e-6, y), 1e-3, 2).bottom[0]
        assert means.bottom_x[node] == pytest.approx(at_face, rel=2e-3)
        assert means.bottom_x[node] < 0.99 * peaks.bottom_x[node]
    np.testing.assert_array_equal(means.bottom_y, peaks.bottom_y)


def test_a_moment_of_the_other_face_is_left() -> None:
    """Beside a column the top is in tension somewhere else: there is no peak that bars could share."""
    result = only(slab())
    steel = result.model.reinforcement
    assert steel is not None
    means, peaks = bar_moments(result, steel), design_moments(result.plate)
    np.testing.assert_array_equal(means.top_x, peaks.top_x)
    assert peaks.top_x.min() < 0


def test_bars_by_strips() -> None:
    """Bars along a strip have the mean over its width, that of the table of strips; those across what they had."""
    output = {"strips": [{"name": "S", "start": (-3, 0), "end": (3, 0), "width": 4.0, "stations": 13}]}
    result = only(slab({"by": "strip"}, output=output))
    steel = result.model.reinforcement
    assert steel is not None
    means, nodes = bar_moments(result, steel), result.plate.nodes
    cuts = strip(result.plate, (-3.0, 0.0), (3.0, 0.0), 4.0, 13)
    for x, bottom in zip(cuts.x[2:11], cuts.bottom[2:11], strict=True):
        across = abs(nodes[:, 0] - x) < 1e-6
        if across.any() and abs(x) > 0.2:
            np.testing.assert_allclose(means.bottom_x[across], bottom, rtol=1e-2)
    by_places = bar_moments(result, steel.replace(averaging={}))
    np.testing.assert_array_equal(means.bottom_y, by_places.bottom_y)


@pytest.mark.parametrize(
    ("averaging", "output", "where"),
    [
        ({"at_columns": "face", "width": 1.0}, {}, "reinforcement.averaging.width"),
        ({"by": "strip"}, {}, "reinforcement.averaging.by"),
        (
            {"by": "strip"},
            {"strips": [{"name": "S", "start": (0, 0), "end": (1, 1), "width": 1.0}]},
            "output.strips[1]",
        ),
    ],
)
def test_what_cannot_be_is_refused(averaging: dict[str, Any], output: dict[str, Any], where: str) -> None:
    """A width that nothing has a use for, strips that are missing or at an angle to the bars."""
    with pytest.raises(InputError) as refused:
        slab(averaging, output=output)
    assert [issue.location for issue in refused.value.issues] == [where]


def test_bars_pass_by_their_mean() -> None:
    """Bars for the mean moment pass, which the peak lets fail; the check names both, and its error is known."""
    bars = {key: {"diameter": 0.016, "spacing": 0.125} for key in ("bottom_x", "bottom_y", "top_x", "top_y")}
    peak = {"at_columns": "peak"}
    found = {}
    for name, averaging in (("mean", {}), ("peak", peak)):
        model = slab(averaging, reinforcement=STEEL | bars | {"averaging": averaging})
        found[name] = {check.name: check for check in check_design(solve_once(model)).checks}["bars at the bottom x"]
    assert (found["mean"].status, found["peak"].status) == ("no failure found", "fails")
    assert ", not averaged " in found["mean"].words
    assert "averaged" not in found["peak"].words
    assert found["mean"].error is not None
