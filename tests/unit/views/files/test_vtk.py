"""Files for ParaView, read back by VTK itself, on which ParaView is built."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from groundslab.fem.shape_functions import q9
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import ELEMENT_FIELDS, ERROR, MEMBRANE, PLATE_FIELDS, STIFFNESS
from groundslab.results.results import CombinationResult, Results
from groundslab.views.files import results_folder, vtk
from groundslab.views.tables.envelopes import fields_of_envelope
from helpers import synthetic

pytest.importorskip("vtkmodules", reason="VTK IS NOT INSTALLED: no file for ParaView was read by it")

#: Arrays that are flags or numbers of something, which have no unit.
WITHOUT_UNIT = re.compile(
    r"in contact|edge node|under the plate|section|reinforcement (fails|needs links)|"
    r"\w+ combination of (greatest|least) .+"
)


def read(path: Path) -> Any:
    """Return a VTU file as VTK has it; what VTK complains about is an error."""
    from vtkmodules.vtkCommonCore import vtkStringOutputWindow
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    window = vtkStringOutputWindow()
    window.SetInstance(window)
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert window.GetOutput() == ""
    return reader.GetOutput()


def arrays(data: Any) -> dict[str, np.ndarray]:
    """Return the arrays of points or cells by name."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    return {data.GetArrayName(n): vtk_to_numpy(data.GetArray(n)) for n in range(data.GetNumberOfArrays())}


def curved(n: int = 3) -> CombinationResult:
    """Return made-up results on a mesh whose elements have curved sides and no symmetry."""
    flat = synthetic.results(n, shear=True)
    x, y = flat.plate.nodes.T
    bent = np.column_stack([x + 0.05 * y**2 + 0.02 * x * y, y + 0.15 * np.sin(0.6 * x) + 0.03 * y**2])
    return replace(flat, plate=replace(flat.plate, nodes=bent))


def weights_at(cell: Any, place: tuple[float, float]) -> tuple[np.ndarray, np.ndarray]:
    """Return where VTK finds parametric coordinates of a cell, and the weights of its nodes."""
    from vtkmodules.vtkCommonCore import reference

    found, weights = [0.0] * 3, [0.0] * cell.GetNumberOfPoints()
    cell.EvaluateLocation(reference(0), [*place, 0.0], found, weights)
    return np.array(found[:2]), np.array(weights)


class TestCells:
    """The nine-node cells."""

    @pytest.mark.slow
    def test_vtk_has_our_shape_functions_in_our_order(self, tmp_path: Path) -> None:
        """At any place VTK weighs a cell's nodes as our shape functions weigh the element's, and finds the same point.

        VTK counts from 0 to 1 where we count from -1 to 1. A wrong order of nodes would exchange two weights.
        """
        results = curved()
        vtk.write_plate(results, tmp_path / "plate.vtu")
        grid = read(tmp_path / "plate.vtu")
        assert grid.GetNumberOfCells() == len(results.plate.elements)
        for number in (0, 4, 8):
            cell, element = grid.GetCell(number), results.plate.elements[number]
            assert cell.GetClassName() == "vtkBiQuadraticQuad"
            assert [cell.GetPointId(n) for n in range(9)] == element.tolist()
            for place in ((0.1, 0.2), (0.9, 0.3), (0.4, 0.75)):
                N = q9(2 * np.array([place]) - 1)[0][0]
                found, weights = weights_at(cell, place)
                assert np.allclose(weights, N, atol=1e-13)
                assert np.allclose(found, N @ results.plate.nodes[element], atol=1e-12)

    def test_a_field_between_nodes_is_what_we_say_it_is(self, tmp_path: Path) -> None:
        """VTK's probe gives, at points inside elements, the value that `value_at` gives, in its unit.

        On rectangles, since in curved elements VTK finds a point's place by four straight quadrilaterals only.
        """
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkPolyData
        from vtkmodules.vtkFiltersCore import vtkProbeFilter

        results = synthetic.results(3, shear=True)
        vtk.write_plate(results, tmp_path / "plate.vtu")
        wanted = np.random.default_rng(1).uniform((-3, -2), (3, 2), (20, 2))
        points, where, probe = vtkPoints(), vtkPolyData(), vtkProbeFilter()
        points.SetDataTypeToDouble()
        for x, y in wanted:
            points.InsertNextPoint(x, y, 0.0)
        where.SetPoints(points)
        probe.SetInputData(where)
        probe.SetSourceData(read(tmp_path / "plate.vtu"))
        probe.ComputeToleranceOff()
        probe.SetTolerance(1e-6)
        probe.Update()
        assert probe.GetValidPoints().GetNumberOfValues() == len(wanted)
        data = probe.GetOutput().GetPointData()
        for name in ("settlement", "moment_xy", "shear_x"):
            found = vtk_to_numpy(data.GetArray(PLATE_FIELDS[name].name))
            expected = [results.plate.value_at(name, x, y) * PLATE_FIELDS[name].scale for x, y in wanted]
            assert np.allclose(found, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())

    def test_gradients_by_vtk_are_those_of_the_field(self, tmp_path: Path) -> None:
        """On rectangles VTK's Jacobian gives the exact slopes of a settlement that is quadratic in x and y."""
        results = synthetic.results(3)
        vtk.write_plate(results, tmp_path / "plate.vtu")
        grid = read(tmp_path / "plate.vtu")
        values = arrays(grid.GetPointData())["settlement w [mm]"]
        for number in range(grid.GetNumberOfCells()):
            cell = grid.GetCell(number)
            (x, y), _ = weights_at(cell, (0.3, 0.8))
            slopes = [0.0] * 3
            cell.Derivatives(0, [0.3, 0.8, 0.0], values[results.plate.elements[number]].tolist(), 1, slopes)
            assert np.allclose(slopes[:2], -4 * 28 / 36 * np.array([x, y]), atol=1e-9)


class TestArrays:
    """Names and values of the arrays."""

    @pytest.fixture
    def folder(self, tmp_path: Path) -> Path:
        """Return a folder of several combinations, with reinforcement, of which two are certified."""
        combined = synthetic.combined()
        model = combined.model.replace(
            reinforcement=Reinforcement(f_ck=30e6, f_yk=500e6, bottom=(0.04, 0.05), top=(0.04, 0.05))
        )
        refused = {"wind alone": combined.refused["wind alone"]}
        left = tuple(each for each in combined.combinations if each.name in {*combined.results, *refused})
        given = model.replace(combinations=left)
        results = {name: replace(each, model=given, solved_model=given) for name, each in combined.results.items()}
        return results_folder.save_results(Results(given, left, results, refused), tmp_path / "out")

    def test_every_name_carries_its_unit(self, folder: Path) -> None:
        """Arrays of points and cells name their unit in brackets, but for flags and counts; no number is missing."""
        paths = sorted(folder.rglob("*.vtu"))
        assert {path.name for path in paths} == {"plate.vtu", "ground.vtu", "envelope.vtu"}
        for path in paths:
            grid = read(path)
            for data in (grid.GetPointData(), grid.GetCellData()):
                for name, values in arrays(data).items():
                    assert re.search(r"\[[^\]]+\]( \(.+\))?$", name) or WITHOUT_UNIT.fullmatch(name), name
                    assert np.isfinite(values).all() or name.startswith("reinforcement")

    def test_plate_holds_all_fields(self, folder: Path) -> None:
        """Every field at nodes and for elements comes back as it is, in its unit of display."""
        results = results_folder.load_results(folder)["NUL"]
        grid = read(next(folder.glob("02-*/plate.vtu")))
        nodal, cells = arrays(grid.GetPointData()), arrays(grid.GetCellData())
        for name, about in PLATE_FIELDS.items():
            assert np.allclose(nodal[PLATE_FIELDS[name].name], getattr(results.plate, name) * about.scale, rtol=1e-15)
        for name, about in ELEMENT_FIELDS.items():
            given, key = getattr(results.elements, name), f"{about.name} (centre, {about.averaged})"
            assert (given is None) == (name in (ERROR, STIFFNESS, *MEMBRANE)) == (key not in cells)
            if given is not None:
                assert np.allclose(cells[key], given * about.scale, rtol=1e-15)

    def test_ground_holds_each_surface(self, tmp_path: Path) -> None:
        """The settlement of every surface comes back at the ground's nodes."""
        results = synthetic.results(2, shear=True)
        vtk.write_ground(results, tmp_path / "ground.vtu")
        grid = read(tmp_path / "ground.vtu")
        found = arrays(grid.GetPointData())
        assert grid.GetNumberOfPoints() == len(results.ground.nodes)
        for surface, settlement in enumerate(results.ground.settlement):
            assert np.allclose(found[f"settlement w_{surface} [mm]"], 1e3 * settlement, rtol=1e-15)

    def test_envelope_holds_extremes_and_who_governs(self, folder: Path) -> None:
        """All arrays of the envelope come back by name, and the required areas with them."""
        wanted = fields_of_envelope(results_folder.load_results(folder))
        found = arrays(read(folder / "envelope.vtu").GetPointData())
        assert found.keys() == wanted.keys()
        assert any(name.startswith("reinforcement bottom x [cm2/m]") for name in found)
        for name, values in wanted.items():
            finite = np.isfinite(values)
            assert np.allclose(found[name][finite], values[finite], rtol=1e-15), name
            assert np.isnan(found[name][~finite]).all()

    @pytest.mark.parametrize("name", ["plate", "ground"])
    def test_collections_lead_to_files_that_vtk_reads(self, folder: Path, name: str) -> None:
        """A PVD file has the number of each certified combination as its time, and a file of that combination."""
        root = ElementTree.parse(folder / f"{name}.pvd").getroot()
        assert root.attrib["type"] == "Collection"
        sets = root.findall("Collection/DataSet")
        assert [float(each.attrib["timestep"]) for each in sets] == [1.0, 2.0]
        largest = [arrays(read(folder / each.attrib["file"]).GetPointData()) for each in sets]
        if name == "plate":
            peaks = [values["settlement w [mm]"].max() for values in largest]
            assert peaks == pytest.approx([28.0, 56.0])
