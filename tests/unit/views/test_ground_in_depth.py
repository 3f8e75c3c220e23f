"""A continuum in all views: what is written comes back, and summary, tables, drawings and report show its depth."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.model.supports import Pile
from groundslab.results.contact_zone import contact_function
from groundslab.results.results import CombinationResult, Results
from groundslab.results.soil_profile import profile_depths
from groundslab.views.files import npz, results_folder
from groundslab.views.files.validation import require_sound
from groundslab.views.plots.ground.soil import soil_columns
from groundslab.views.plots.ground.stress import sample_section
from groundslab.views.plots.request import parse_request
from groundslab.views.report.html import render_report
from groundslab.views.summary import json_summary, sections
from helpers import synthetic

LAYERS = [
    groundslab.SoilLayer(E=10e6, nu=0.3, thickness=1.0),
    groundslab.SoilLayer(E=20e6, E_bottom=40e6, nu=0.3, thickness=3.0),
]
BONDED = groundslab.Continuum(layers=LAYERS, half_space=groundslab.HalfSpace(E=60e6, nu=0.3))
LOAD = groundslab.UniformLoad(q=10e3)
STRESSED = groundslab.ConstrainedModulus(layers=LAYERS)


def solve(ground: Any, **parts: Any) -> Results:
    """Return the results of a slab of 6 by 4 m under a force beside its middle."""
    force = groundslab.PointLoad(P=800e3, x=1, y=0.5, width_x=0.4, width_y=0.4)
    common = {
        "plate": groundslab.Plate(length_x=6, length_y=4, thickness=0.4, E=30e9, nu=0.2),
        "loads": [force, LOAD],
        "mesh": groundslab.Mesh(size=0.5),
        "output": groundslab.Output(points=[groundslab.OutputPoint(name="A", x=1.1, y=0.6)]),
    }
    return groundslab.solve(Model(ground=ground, **common | parts))


def test_stresses_below_an_opening_and_beside_the_plate() -> None:
    """Points of a case file there: by Boussinesq, sigma_z = 3 F z^3 / (2 pi R^5) of the force F of each cell.

    On 20 m2 of 6 m x 4 m with an opening of 2 m x 2 m act 50 kPa, 1000 kN; on other ground such points are refused.
    """
    text = """
plate = { length_x = "6 m", length_y = "4 m", thickness = "0.4 m", E = "30 GPa", nu = 0.2, openings = [
  { kind = "rectangle", x = ["-1 m", "1 m"], y = ["-1 m", "1 m"] } ] }
ground = { kind = "continuum", layers = [], half_space = { E = "60 MPa", nu = 0.3 } }
loads = [{ kind = "uniform", q = "50 kPa" }]
mesh = { size = "0.5 m" }
output = { points = [{ name = "hole", x = "0 m", y = "0 m" }, { name = "beside", x = "8 m", y = "0 m" }] }
"""
    results = groundslab.solve(casefile.loads(text))
    tables = {table.name: table for table in groundslab.tables_of(results)}
    soil, points = tables["soil"], tables["points"]
    cells = results.ground.cells
    assert cells is not None
    assert cells.force.sum() == pytest.approx(1000e3, rel=1e-6)
    deep = [row for row in zip(soil["point"], soil["depth z"], soil["vertical stress sigma_z"], strict=True)
            if isinstance(row[1], float) and row[1] >= 2]  # fmt: skip
    assert {name for name, *_ in deep} == {"hole", "beside"}
    for name, z, stress in deep:
        R = np.hypot(np.hypot(cells.center[:, 0] - (8 if name == "beside" else 0), cells.center[:, 1]), z)
        assert stress == pytest.approx((3 * cells.force * z**3 / (2 * np.pi * R**5)).sum() / 1e3, rel=0.01)
    assert set(points["settlement w"]) == {None}
    springs = text.replace("continuum", "winkler")
    springs = springs.replace('layers = [], half_space = { E = "60 MPa", nu = 0.3 }', 'k = "9 MPa/m"')
    with pytest.raises(InputError, match="not in an opening"):
        casefile.loads(springs)


@pytest.fixture(scope="module")
def bonded() -> Results:
    """Return results on bonded layers over a half-space, in two increments."""
    return solve(BONDED, analysis=groundslab.Analysis(increments=2))


@pytest.fixture(scope="module")
def stressed() -> Results:
    """Return results on layers that differ between two boreholes, compressed by the stresses of a half-space."""
    other = [groundslab.SoilLayer(E=5e6, nu=0.3, thickness=1.0), LAYERS[1]]
    holes = [groundslab.Borehole(x=-3, y=0, layers=LAYERS), groundslab.Borehole(x=3, y=0, layers=other)]
    return solve(STRESSED, boreholes=holes)


def cells_of(results: CombinationResult) -> Any:
    """Return the cells of results on a continuum."""
    assert results.ground.cells is not None
    return results.ground.cells


def test_cells_come_back_from_a_folder(bonded: Results, stressed: Results, tmp_path: Path) -> None:
    """All their arrays, of each increment and of the coarser mesh too, and so do settlements and stresses in depth."""
    for name, results in (("bonded", bonded), ("stressed", stressed)):
        found = results_folder.load_results(results_folder.save_results(results, tmp_path / name)).only
        wanted = results.only
        assert np.array_equal(found.ground.settlement, wanted.ground.settlement)
        assert found.comparison is not None
        assert wanted.comparison is not None
        pairs = [(found, wanted), (found.comparison, wanted.comparison)]
        pairs += list(zip(found.increments, wanted.increments, strict=True))
        for one, other in pairs:
            for part in ("center", "size", "force", "settling", "layers", "bonded", "beside", "piled"):
                assert np.array_equal(getattr(one.ground.cells, part), getattr(other.ground.cells, part))
        at = 1.0, 0.5, [0.0, 0.7, 3.0, 9.0]
        assert np.array_equal(found.ground.stress_at(*at), wanted.ground.stress_at(*at))


@pytest.mark.parametrize(
    "changes",
    [
        {"force": np.zeros((0,))},
        {"size": np.array([0.25, 0.0])},
        {"layers": np.array([[10e6, 0.5, np.inf]])},
        {"layers": np.array([[10e6, 0.3, np.inf], [10e6, 0.3, 1.0]])},
        {"center": np.zeros((3, 2))},
    ],
)
def test_damaged_cells_are_refused(bonded: Results, changes: dict[str, Any]) -> None:
    """Cells that none can have, layers below a half-space and arrays that do not fit are found before they are used."""
    whole = bonded.only
    require_sound(whole)
    ground = replace(whole.ground, cells=replace(cells_of(whole), **changes))
    with pytest.raises(ValueError, match=r"ground\.cells"):
        require_sound(replace(whole, ground=ground))


def test_cells_belong_to_a_continuum_and_to_no_other_ground(bonded: Results) -> None:
    """Results on a continuum without cells are refused, and so are cells on springs."""
    whole = bonded.only
    with pytest.raises(ValueError, match="none on it"):
        require_sound(replace(whole, ground=replace(whole.ground, cells=None)))
    springs = synthetic.results()
    with pytest.raises(ValueError, match="on other ground"):
        require_sound(replace(springs, ground=replace(springs.ground, cells=cells_of(whole))))


def test_summary_says_what_the_ground_is(bonded: Results, stressed: Results) -> None:
    """Layers, what lies below, the cells; sizes have no discretization error; the certificate names the cells."""
    rows = {row.key: row for row in sections.description_of_ground(bonded.only).rows}
    assert (rows["layers"].value, rows["depth"].value, rows["below"].value) == (2, 4.0, "half-space")
    assert (rows["cells"].value, rows["cell_x"].value, rows["cell_x"].error) == (24 * 16, 0.25, None)
    assert json.loads(json_summary.json_text(bonded))["ground"]["cell_y"] == {"value": 0.25, "unit": "m"}
    words = [row.label for row in sections.certificate_section(bonded.only).rows]
    assert "cells' forces against the plate's" in words
    rows = {row.key: row for row in sections.description_of_ground(stressed.only).rows}
    assert rows["below"].value == "nothing settles"


def test_settlement_and_stress_below_points_are_a_table(bonded: Results) -> None:
    """Each point has a row for each depth, those of layers' borders too, from the surface to 2 B."""
    table = {each.name: each for each in groundslab.tables_of(bonded)}["soil"]
    z, ground = np.array(table["depth z"], dtype=float), bonded.ground
    assert {0.0, 1.0, 4.0, 8.0} <= set(z)
    assert set(table["point"]) == {"A"}
    np.testing.assert_allclose(table["settlement w"], 1e3 * ground.settlement_at(1.1, 0.6, z), rtol=1e-4)
    np.testing.assert_allclose(table["vertical stress sigma_z"], ground.stress_at(1.1, 0.6, z) / 1e3, rtol=1e-4)
    # the point lies in the cell from (1, 0.5) to (1.25, 0.75)
    cells = cells_of(bonded.only)
    (own,) = np.flatnonzero(np.abs(cells.center - [1.125, 0.625]).max(axis=1) < 1e-9)
    assert table["vertical stress sigma_z"][0] == pytest.approx(cells.force[own] / 0.25**2 / 1e3)


def test_where_layers_differ_stresses_are_known_but_not_settlements(stressed: Results) -> None:
    """Boussinesq's stresses do not depend on the layers; the table leaves the settlements out and says why."""
    ground = stressed.ground
    with pytest.raises(InputError, match="from place to place"):
        ground.settlement_at(0, 0, 1)
    far = 50.0
    stress = 3 * cells_of(stressed.only).force.sum() / (2 * np.pi * far**2)
    # a force at the resultant's place, seen from 50 m below
    assert ground.stress_at(0.7, 0.3, far) == pytest.approx(stress, rel=0.01)
    table = {each.name: each for each in groundslab.tables_of(stressed)}["soil"]
    assert set(table["settlement w"]) == {None}
    assert "where layers differ from place to place" in table.notes[-1]


def test_loads_beside_the_plate_press_on_the_ground_too() -> None:
    """A surcharge beside the slab has its stresses in the depth beside those of the slab."""
    patch = groundslab.PatchLoad(q=50e3, x=(4, 8), y=(-2, 2), on="ground")
    beside = solve(STRESSED, beyond=groundslab.Beyond(kind="infinite"), loads=[LOAD, patch])
    far = 40.0
    stress = 3 / (2 * np.pi * far**2) * (50e3 * 16 + 10e3 * 24 * (1 + (6 / far) ** 2) ** -2.5)
    # Boussinesq's forces, as areas of 4 m are seen from so deep
    assert beside.ground.stress_at(6.0, 0.0, far) == pytest.approx(stress, rel=0.01)


def test_nothing_is_said_of_the_depth_below_piles() -> None:
    """Piles carry loads into the depth: points, table and section are refused, or say why they are empty."""
    pile = Pile(name="P", x=1, y=0.5, diameter=0.6, length=3.0)
    piled = solve(BONDED, supports=[pile])
    with pytest.raises(InputError, match="piles"):
        piled.ground.stress_at(0, 0, 1)
    with pytest.raises(InputError, match="without piles"):
        groundslab.plot(piled, kind="stress")
    table = {each.name: each for each in groundslab.tables_of(piled)}["soil"]
    assert len(table) == 0
    assert "Piles" in table.notes[-1]


def test_other_ground_has_no_depth() -> None:
    """Springs have neither settlements in a depth nor sections through it, and say which ground has."""
    springs = synthetic.results()
    with pytest.raises(InputError, match="continuum"):
        springs.ground.settlement_at(0, 0, 1)
    with pytest.raises(InputError, match="whose stresses in the depth are known"):
        groundslab.plot(springs, kind="stress")


def test_drawings_of_the_ground(bonded: Results) -> None:
    """The column ends with the half-space; a section has the ground's stresses, by default through the middle."""
    request = parse_request(bonded, (), "stress", None, None, None)
    (column,) = soil_columns(bonded.model, request.combinations)
    assert [layer.endless for layer in column.layers] == [False, False, True]
    assert column.depth == pytest.approx(1.25 * 4.0)
    (line,) = request.lines
    assert (line.start, line.end) == ((-3.0, 0.0), (3.0, 0.0))
    s, z, stress = sample_section(request.combinations[0], line)
    assert (s[0], s[-1], z[-1]) == (-3.0, 9.0, profile_depths(bonded.model)[-1])
    np.testing.assert_allclose(stress[48, 10], bonded.ground.stress_at(0.0, 0.0, z[10]), rtol=1e-4)
    assert len(groundslab.plot(bonded, kind="stress").axes) >= 1
    assert len(groundslab.plot(bonded, kind="soil").axes) >= 2


def test_the_contact_boundary_is_that_of_the_cells(bonded: Results) -> None:
    """The contact function is negative where a node touches, and zero where half of the cells around it do."""
    plate = bonded.plate
    assert 0 < plate.in_contact.mean() < 1
    found = contact_function(bonded.only)
    assert np.array_equal(found < 0, plate.in_contact)
    np.testing.assert_allclose(found, 0.5 - plate.contact_area / plate.area, atol=1e-6)


@pytest.mark.slow
def test_report_shows_the_ground(bonded: Results) -> None:
    """Its layers and cells as analyzed, the stresses as a picture and a table; no constants, which it has not."""
    page = render_report(bonded)
    for words in ("cells of pressure under the plate", "Soil below points", "Vertical stress in the ground"):
        assert words in page
    assert "Constants of the ground" not in page


def test_archives_of_other_ground_have_no_cells(tmp_path: Path) -> None:
    """An archive of results on springs is as it was."""
    npz.write(synthetic.results(), tmp_path / "results.npz")
    with np.load(tmp_path / "results.npz") as archive:
        assert not [name for name in archive.files if "cells" in name]
