"""Fields at the centres of elements: exact where they can be, mirrored with their signs, whole in the VTU file."""

from __future__ import annotations

from dataclasses import fields, replace
from pathlib import Path

import meshio
import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.discretize.discretize import discretize
from groundslab.fem.load_vectors import nodal_area
from groundslab.fem.problem import BETA_X, BETA_Y
from groundslab.fem.shape_functions import gauss
from groundslab.model.ground import Pasternak, Winkler
from groundslab.model.loads.load_types import PatchLoad, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Plate, Zone
from groundslab.model.settings import Beyond, Mesh
from groundslab.model.shapes import Rectangle
from groundslab.results import recovery
from groundslab.results.fields import ELEMENT_FIELDS, PLATE_FIELDS
from groundslab.results.mirroring import make_result_mesh
from groundslab.results.plate_result import ElementResult
from groundslab.results.results import CombinationResult
from groundslab.views.files import vtk

E, NU, T = 30e9, 0.2, 0.25


def model(symmetry: str = "auto", **changes: object) -> Model:
    """Return a plate of 4 x 3 m that lifts at its corners under a load in its middle."""
    parts = {
        "plate": Plate(length_x=4.0, length_y=3.0, thickness=T, E=E, nu=NU),
        "ground": Pasternak(k0=60e6, k1=2e6),
        "beyond": Beyond(kind="margin", width=1.0),
        "loads": [PatchLoad(q=1e6, x=(-0.4, 0.4), y=(-0.3, 0.3))],
        "mesh": Mesh(counts=(8, 6), symmetry=symmetry),
    }
    return Model(**parts | changes)


def cells(results: CombinationResult, folder: Path) -> tuple[meshio.Mesh, dict[str, np.ndarray]]:
    """Return the VTU file of the plate, read back, with its cell arrays."""
    vtk.write_plate(results, folder / "plate.vtu")
    mesh = meshio.read(folder / "plate.vtu")
    return mesh, {name: values[0] for name, values in mesh.cell_data.items()}


def test_linear_moments_are_exact_at_centres(tmp_path: Path) -> None:
    """Rotations that are squares have linear moments; the file's cell at each centre has the exact value there.

    D (kappa_x + nu kappa_y) by hand, with another D in a zone of twice the thickness; its section is 1.
    """
    zone = Zone(thickness=2 * T, shape=Rectangle(x=(0.5, 1.5), y=(-1.0, 0.5)))
    plate = Plate(length_x=4.0, length_y=3.0, thickness=T, E=E, nu=NU, zones=[zone])
    results = solve(model(plate=plate, ground=Winkler(k=1e8), beyond=Beyond(), mesh=Mesh(size=0.5))).only
    problem = discretize(results.model, 0, 1.0)
    x, y = problem.mesh.nodes.T
    U = np.zeros(problem.unknown.shape)
    U[:, BETA_X], U[:, BETA_Y] = 1e-3 * x * x, 2e-3 * x * y
    own = make_result_mesh(results.model, problem)
    pressure = (own.mean * (1e4 + 2e3 * own.mesh.nodes[own.mesh.elements, 0])).sum(axis=1)
    of_part = recovery._element_fields(problem, recovery.own_forces(problem, U, gauss(2)[0])) | {"pressure": pressure}
    found = {name: own.plate.by_element(name, field) for name, field in of_part.items()}
    section = found.pop("section").astype(np.int64)
    read, data = cells(replace(results, elements=ElementResult(**found, section=section)), tmp_path)

    x, y = read.points[read.cells[0].data[:, 8], :2].T
    inside = (x > 0.5) & (x < 1.5) & (y > -1.0) & (y < 0.5)
    assert 0 < inside.sum() < len(x)
    assert np.array_equal(data["section"], inside)
    thickness = np.where(inside, 2 * T, T)
    np.testing.assert_allclose(data["thickness t [mm] (centre, not averaged)"], 1e3 * thickness)
    D = E * thickness**3 / (12 * (1 - NU**2)) / 1e3
    wanted = {
        "moment m_x": -D * (2e-3 * x + NU * 2e-3 * x),
        "moment m_y": -D * (2e-3 * x + NU * 2e-3 * x),
        "moment m_xy": -D * (1 - NU) / 2 * 2e-3 * y,
    }
    for name, values in wanted.items():
        given = data[f"{name} [kNm/m] (centre, not averaged)"]
        np.testing.assert_allclose(given, values, atol=1e-9 * np.abs(values).max())
    np.testing.assert_allclose(data["pressure p [kPa] (centre, mean over the element)"], 10 + 2 * x, rtol=1e-12)


@pytest.mark.parametrize(
    ("y", "symmetry"), [((-0.3, 0.3), (True, True)), ((0.2, 0.8), (True, False))], ids=["quarter", "half"]
)
def test_a_part_is_the_whole_cell_by_cell(tmp_path: Path, y: tuple[float, float], symmetry: tuple[bool, bool]) -> None:
    """Mirrored from a part, every cell array is that of the whole plate solved as such, signs and order included."""
    loads = [PatchLoad(q=1e6, x=(-0.4, 0.4), y=y)]
    one, other = solve(model(loads=loads)).only, solve(model("off", loads=loads)).only
    assert one.symmetry == symmetry
    assert other.symmetry == (False, False)
    mesh, data = cells(one, tmp_path)
    mesh_of_whole, data_of_whole = cells(other, tmp_path)
    centres, wanted = (each.points[each.cells[0].data[:, 8]] for each in (mesh, mesh_of_whole))
    np.testing.assert_allclose(centres, wanted, atol=1e-9)
    assert data.keys() == data_of_whole.keys()
    for name, values in data_of_whole.items():
        np.testing.assert_allclose(data[name], values, atol=1e-7 * np.abs(values).max(), err_msg=name)
    odd = data["moment m_xy [kNm/m] (centre, not averaged)"]
    assert odd.min() < -0.1 * np.abs(odd).max() < 0 < odd.max()


def test_pressure_of_all_elements_is_the_whole_contact_force() -> None:
    """The means times the elements' areas and the line force add up to the certificate's reaction, zones and all."""
    zone = Zone(thickness=2 * T, shape=Rectangle(x=(-0.5, 0.5), y=(-0.5, 0.5)))
    plate = Plate(length_x=4.0, length_y=3.0, thickness=T, E=E, nu=NU, zones=[zone])
    results = solve(model(plate=plate, mesh=Mesh(size=0.5), loads=[UniformLoad(q=5e4)])).only
    xy = results.plate.nodes[results.plate.elements[:, :4]]
    x, y = xy[..., 0], xy[..., 1]
    area = (x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1) / 2
    along_edge = (results.plate.line_force * results.plate.edge_length).sum()
    assert along_edge > 0.01 * results.certificate.reaction
    assert (results.elements.pressure * area).sum() + along_edge == pytest.approx(
        results.certificate.reaction, rel=1e-9
    )
    assert set(results.elements.section) == {0, 1}


def test_every_field_says_how_it_is_averaged() -> None:
    """Each field of nodes and elements has words for it; those of elements are never recovered across elements."""
    assert all(field.averaged for field in (*PLATE_FIELDS.values(), *ELEMENT_FIELDS.values()))
    assert {field.name for field in fields(ElementResult)} == {*ELEMENT_FIELDS, "section"}
    assert {field.averaged for field in ELEMENT_FIELDS.values()} == {"not averaged", "mean over the element"}


def test_area_shares_and_means_agree() -> None:
    """A nodal pressure that is one everywhere has the mean one in every element."""
    problem = discretize(model(), 0, 1.0)
    own = make_result_mesh(model(), problem)
    np.testing.assert_allclose(own.mean.sum(axis=1), 1.0, rtol=1e-14)
    assert nodal_area(own.mesh, np.arange(len(own.mesh.elements))).sum() == pytest.approx(3.0)
