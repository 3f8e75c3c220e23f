"""Values at places: what results give back for points, one or many."""

from __future__ import annotations

import pickle
import sys
import time
from dataclasses import replace
from functools import cache
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import groundslab as g
from groundslab.errors import InputError, NoEquilibrium, NotCertified
from groundslab.fem.mesh import MOST_NAMED
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.results import Results, results_of
from helpers import synthetic


@cache
def corner_loaded() -> Results:
    """Return a plate of 6 m x 4 m with a load off its middle, on two layers that reach beyond it."""
    layers = [g.SoilLayer(thickness=2, E=20e6, nu=0.3), g.SoilLayer(thickness=4, E=60e6, nu=0.3)]
    return g.solve(
        g.Model(
            plate=g.Plate(length_x=6, length_y=4, thickness=0.25, E=30e9, nu=0.2),
            ground=g.Layered(layers=layers, coupling="interface"),
            beyond=g.Beyond(kind="margin", width=2),
            loads=[g.UniformLoad(q=5e3), g.PointLoad(P=200e3, x=1, y=1, width_x=0.4, width_y=0.4)],
            mesh=g.Mesh(size=0.8),
        )
    )


def test_whole_numbers_are_no_other_places() -> None:
    """A slab under a load at (1, 1): values at whole numbers are those at the same floats, and of the node there."""
    model = g.Model(
        plate=g.Plate(length_x=6, length_y=4, thickness=0.25, E=30e9, nu=0.2),
        ground=g.Winkler(k=20e6),
        loads=[g.PointLoad(P=200e3, x=1, y=1)],
        mesh=g.Mesh(size=0.8),
    )
    plate = g.solve(model).plate
    assert plate.value_at("settlement", -1, 1) == plate.value_at("settlement", -1.0, 1.0)
    assert plate.value_at("settlement", -1, 1) == pytest.approx(4.657e-4, rel=1e-3)


@pytest.mark.parametrize("field", PLATE_FIELDS)
def test_values_at_nodes_are_the_nodal_values(field: str) -> None:
    """All nodes at once, each field: what is found at a node is what stands there."""
    plate = corner_loaded().plate
    values = getattr(plate, field)
    found = plate.value_at(field, *plate.nodes.T)
    np.testing.assert_allclose(found, values, atol=1e-9 * np.abs(values).max())


def test_arrays_of_points_give_arrays_of_their_shape() -> None:
    """X and y broadcast; a float comes back for two numbers, of whatever type, and an array of no points for none."""
    plate = corner_loaded().plate
    x, y = np.linspace(-3, 3, 7)[:, None], np.linspace(-2, 2, 5)
    found = plate.value_at("moment_x", x, y)
    assert found.shape == (7, 5)
    one_by_one = [[plate.value_at("moment_x", float(a), float(b)) for b in y] for a in x[:, 0]]
    np.testing.assert_allclose(found, one_by_one, rtol=1e-13)
    assert plate.value_at("gap", [0, 1, 2], 0).shape == (3,)
    assert plate.value_at("gap", [], []).shape == (0,)
    for number in (1, 1.0, np.int64(1), np.float32(1), np.array(1)):
        assert type(plate.value_at("settlement", number, 1)) is float


def test_every_surface_of_the_ground_has_values_at_points() -> None:
    """On both surfaces, at all nodes at once; whole numbers and floats alike."""
    ground = corner_loaded().ground
    assert len(ground.settlement) == 2
    for surface, values in enumerate(ground.settlement):
        found = ground.value_at(*ground.nodes.T, surface)
        np.testing.assert_allclose(found, values, atol=1e-9 * np.abs(values).max())
        assert ground.value_at(4, -3, surface) == ground.value_at(4.0, -3.0, surface=surface)
    for surface in (2, -1, 0.5):
        with pytest.raises(InputError, match="a whole number from 0 to 1"):
            ground.value_at(0, 0, surface)


def test_points_outside_are_all_named() -> None:
    """One error tells each point that is not on the plate, by its position in the arrays, or itself if it is alone."""
    plate = corner_loaded().plate
    with pytest.raises(InputError) as error:
        plate.value_at("settlement", [[0, 3.2], [4, 1]], [[0, 1], [1, np.nan]])
    assert [(issue.location, issue.found) for issue in error.value.issues] == [
        ("point[0, 1]", "(3.2, 1) m"),
        ("point[1, 0]", "(4, 1) m"),
        ("point[1, 1]", "(1, nan) m"),
    ]
    with pytest.raises(InputError, match=r"^point: found \(7, 0\) m, expected a point on the plate$"):
        plate.value_at("settlement", 7, 0)
    with pytest.raises(InputError, match=r"^point: found \(7, 0\) m, expected a point on the meshed ground$"):
        corner_loaded().ground.value_at(7, 0)
    with pytest.raises(InputError) as error:
        plate.value_at("settlement", np.full(MOST_NAMED + 50, 9.0), 0)
    assert len(error.value.issues) == MOST_NAMED + 1
    assert "50 more points outside" in str(error.value)


def test_what_is_no_field_or_no_place_is_said() -> None:
    """Unknown fields, texts and shapes that do not fit end in an InputError."""
    plate = corner_loaded().plate
    with pytest.raises(InputError, match='did you mean "settlement"'):
        plate.value_at("setlement", 0, 0)
    with pytest.raises(InputError, match="field"):
        plate.value_at("elements", 0, 0)
    with pytest.raises(InputError, match=r'found "1 m" and 0.*broadcast'):
        plate.value_at("settlement", "1 m", 0)
    with pytest.raises(InputError, match=r"found shape \(2,\) and shape \(3,\)"):
        plate.value_at("settlement", [1, 2], [1, 2, 3])


def test_elements_are_found_by_points() -> None:
    """At each element's centre that element is found, one point or many; so fields of elements can be read there."""
    results = corner_loaded()
    centres = results.plate.nodes[results.plate.elements[:, 8]]
    np.testing.assert_array_equal(results.plate.element_at(*centres.T), np.arange(len(centres)))
    assert results.plate.element_at(*centres[7]) == 7
    assert results.plate.element_at(0, np.ones((2, 3))).shape == (2, 3)
    with pytest.raises(InputError, match="a point on the plate"):
        results.plate.element_at(9, 0)


def test_asking_for_values_leaves_results_as_they_are() -> None:
    """Results can be pickled and printed after values were asked for, and the copy gives the same values."""
    results = corner_loaded()
    before = repr(results.plate)
    value = results.plate.value_at("settlement", 1, 1)
    assert repr(results.plate) == before
    copy = pickle.loads(pickle.dumps(results))
    assert copy.plate.value_at("settlement", 1, 1) == value


def test_many_points_are_quick() -> None:
    """10,000 points on a mesh of 5,000 nodes take well below a second, a single one well below 10 ms."""
    mesh = g.Mesh(size=0.14)
    model = g.Model(
        plate=g.Plate(length_x=6, length_y=4, thickness=0.25, E=30e9, nu=0.2),
        ground=g.Winkler(k=20e6),
        loads=[g.UniformLoad(q=5e3)],
        mesh=mesh,
    )
    plate = g.solve(model).plate
    assert len(plate.nodes) > 4500
    x, y = np.random.default_rng(0).uniform([[-3], [-2]], [[3], [2]], (2, 10_000))
    start = time.process_time()
    plate.value_at("settlement", x, y)
    assert time.process_time() - start < 0.5
    start = time.process_time()
    for i in range(50):
        plate.value_at("settlement", x[i], y[i])
    assert time.process_time() - start < 0.5


def test_several_combinations_are_a_mapping_by_name() -> None:
    """Those that were solved are iterated over; a refused one raises its reason, an unknown one names the others."""
    found = synthetic.combined()
    assert list(found) == ["Größe 1/2: dead + wind", "NUL"]
    assert len(found) == 2
    assert found["NUL"] is found.results["NUL"]
    assert "NUL" in found
    assert "wind alone" not in found
    with pytest.raises(NoEquilibrium, match="pull the plate off"):
        found["wind alone"]
    with pytest.raises(KeyError, match=r'no combination "snow"; .*"NUL"'):
        found["snow"]


@pytest.mark.parametrize(
    "name", ["plate", "elements", "ground", "constants", "certificate", "supports", "increments", "steps"]
)
def test_results_of_an_only_combination_are_at_hand(name: str) -> None:
    """Every part is that of the only combination; of several, an error names them and says how to choose one."""
    one = results_of(synthetic.results())
    assert getattr(one, name) is getattr(one.only, name)
    with pytest.raises(InputError, match=r'"NUL".*results\["Größe 1/2: dead \+ wind"\]'):
        getattr(synthetic.combined(), name)


def test_an_only_combination_that_is_not_certified_raises_that() -> None:
    """Its results are within the error."""
    bad = replace(synthetic.CERTIFICATE, residual=1.0)
    with pytest.raises(NotCertified):
        results_of(synthetic.results(certificate=bad)).plate  # noqa: B018


@pytest.mark.parametrize("name", [0, 1.5, None, "ULS 7", ("a", "b")])
def test_an_unknown_name_is_said(name: Any) -> None:
    """Whatever it is: the message says which combinations there are."""
    with pytest.raises(KeyError, match=r"no combination .*; there is"):
        synthetic.combined()[name]


def test_short_text() -> None:
    """One line for each combination: largest settlement, contact, certificate, or why there is no result."""
    lines = repr(synthetic.combined()).splitlines()
    assert lines[0] == 'Results of "A slab of formulas": 4 combinations'
    assert lines[2] == "  NUL (ultimate): w <= 56 mm, 100 % in contact, certified"
    assert lines[4] == "  wind alone: FOUNDATION FAILS: the loads pull the plate off"
    assert len(lines) == 5


def test_table_for_notebooks() -> None:
    """Names are escaped; each combination has a row with its figures or its reason."""
    found = replace(synthetic.combined(), model=synthetic.model(title="<b>slab</b>"))
    root = ElementTree.fromstring(found._repr_html_())
    assert root.findtext("caption") == "<b>slab</b>"
    rows = [[cell.text for cell in row] for row in root.iter("tr")]
    assert rows[2] == ["NUL", "ultimate", "56 mm", "100", "certified"]
    assert rows[4][4] == "FOUNDATION FAILS: the loads pull the plate off"


@pytest.mark.slow
def test_plate_as_a_grid_of_pyvista() -> None:
    """Cells, points and fields are the plate's, in SI units."""
    pytest.importorskip("pyvista", reason="PyVista, the extra viz, is not installed")
    plate = synthetic.results().plate
    grid = plate.to_pyvista()
    assert (grid.n_points, grid.n_cells) == (len(plate.nodes), len(plate.elements))
    np.testing.assert_array_equal(grid.points[:, :2], plate.nodes)
    np.testing.assert_array_equal(grid.get_cell(1).point_ids, plate.elements[1])
    np.testing.assert_allclose(grid.point_data["settlement w [m]"], plate.settlement)


def test_without_pyvista(monkeypatch: pytest.MonkeyPatch) -> None:
    """The error names the command that installs it."""
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(InputError, match=r"pip install groundslab\[viz\]"):
        synthetic.results().plate.to_pyvista()
