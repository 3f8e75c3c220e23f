"""Lines through meshes: the pieces fill what lies on the mesh, each in its element, curved sides included."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import LineString, Polygon, box

from groundslab.design.demands.cuts.line_traversal import is_continuous, pieces
from groundslab.fem.mesh import Mesh, local_coordinates
from helpers.examples import examples
from helpers.plates import crooked, parted, straight, without

PLACES = st.tuples(st.floats(-1, 7).map(lambda v: round(v, 2)), st.floats(-1, 5).map(lambda v: round(v, 2)))


@pytest.mark.slow
@settings(max_examples=examples(80), deadline=None, derandomize=True)
@given(a=PLACES, b=PLACES, seed=st.integers(0, 5))
def test_pieces_fill_the_line_on_the_mesh(a: tuple, b: tuple, seed: int) -> None:
    """On crooked elements the pieces of a line add up to its length inside the outline, and lie in their elements."""
    if np.hypot(a[0] - b[0], a[1] - b[1]) < 0.1:
        return
    mesh = crooked(seed=seed)
    line = pieces(mesh, np.array([[a, b]]))
    on_mesh = LineString([a, b]).intersection(box(0, 0, 6, 4))
    assert line.length.sum() == pytest.approx(on_mesh.length, abs=1e-7)
    if len(line.low):
        assert (np.diff(line.low) > 0).all()
        piece, s, ds = line.gauss()
        local = local_coordinates(mesh, line.element[piece], line.points(piece, s))
        assert np.abs(local).max() <= 1 + 1e-7
        assert ds.sum() == pytest.approx(line.length.sum())


@pytest.mark.parametrize("y", [0.0, 1.0, 4.0])
def test_a_line_along_element_sides(y: float) -> None:
    """A line along common sides, or along the edge, is cut at the elements' corners and lies in one element each."""
    line = pieces(straight(), np.array([[[-1.0, y], [7.0, y]]]))
    np.testing.assert_allclose(line.low, np.arange(1.0, 7.0))
    np.testing.assert_allclose(line.high, np.arange(2.0, 8.0))
    assert is_continuous(straight(), line)[1:].all()


def test_a_slanted_edge() -> None:
    """A line along an edge that is parallel to no axis finds the elements there, in spite of rounding."""
    turn = np.array([[np.cos(0.3), np.sin(0.3)], [-np.sin(0.3), np.cos(0.3)]])
    mesh = straight()
    turned = Mesh(mesh.nodes @ turn + [100.0, -30.0], mesh.elements)
    for y in (0.0, 2.0, 4.0):
        ends = np.array([[[-1.0, y], [7.0, y]]]) @ turn + [100.0, -30.0]
        line = pieces(turned, ends)
        np.testing.assert_allclose(line.length, np.ones(6), atol=1e-9)


def test_a_curved_side_is_met_where_it_is() -> None:
    """One element whose lower side is the parabola y = (x - 1)^2 / 2 - 1 / 2: lines meet it at the parabola's roots."""
    nodes = np.array([[0, 0], [2, 0], [2, 1], [0, 1], [1, -0.5], [2, 0.5], [1, 1], [0, 0.5], [1, 0.25]])
    mesh = Mesh(nodes, np.arange(9)[None])
    across = pieces(mesh, np.array([[[-1.0, -0.3], [3.0, -0.3]]]))
    half = np.sqrt(2 * (0.5 - 0.3))
    np.testing.assert_allclose([across.low[0], across.high[-1]], [2 - half, 2 + half], rtol=1e-12)
    upwards = pieces(mesh, np.array([[[0.4, -2.0], [0.4, 2.0]]]))
    np.testing.assert_allclose([upwards.low[0], upwards.high[-1]], [2 + 0.36 / 2 - 0.5, 3.0], rtol=1e-12)


def test_what_lies_off_the_mesh_is_left_out() -> None:
    """An opening parts a line; a line beside the mesh has no pieces at all."""
    mesh = without(straight(), (2, 4), (1, 3))
    line = pieces(mesh, np.array([[[0.0, 2.5], [6.0, 2.5]]]))
    np.testing.assert_allclose(line.low, [0, 1, 4, 5])
    assert is_continuous(mesh, line).tolist() == [False, True, False, True]
    assert len(pieces(mesh, np.array([[[0.0, 9.0], [6.0, 9.0]]])).low) == 0


def test_the_border_of_two_sections_ends_a_region() -> None:
    """Where nodes stand twice the line does not go on in the same region, though there is nothing between."""
    mesh, _ = parted(straight(), 2.0)
    line = pieces(mesh, np.array([[[0.0, 0.3], [6.0, 2.5]]]))
    broken = np.flatnonzero(~is_continuous(mesh, line))
    assert len(broken) == 2
    assert line.points(broken, line.low[broken])[:, 0] == pytest.approx([0.0, 2.0])


def test_legs_count_on() -> None:
    """The place s counts along the whole polyline, so that pieces of the second leg begin where the first ended."""
    line = pieces(straight(), np.array([[[0.5, 0.5], [3.5, 0.5]], [[3.5, 0.5], [3.5, 3.5]]]))
    assert line.low[line.leg == 1].min() == pytest.approx(3.0)
    assert line.high.max() == pytest.approx(6.0)
    assert Polygon([(0.5, 0.5), (3.5, 0.5), (3.5, 3.5)]).covers(LineString(line.points(*line.gauss()[:2])))
