"""States under shares of the load: the same as under a load of that size, kept in files, certified with the last."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from pathlib import Path
from unittest.mock import patch

import meshio
import numpy as np
import pytest

from groundslab.analysis import driver
from groundslab.analysis.tasks import task
from groundslab.errors import NotCertified
from groundslab.model.model import Model
from groundslab.results.records import Certificate
from groundslab.results.results import CombinationResult
from groundslab.views.files import npz, results_folder

FIELDS = ("settlement", "gap", "penetration", "pressure", "moment_x", "shear_y")


def model(share: float = 1.0, increments: int = 1, **changes: object) -> Model:
    """Return a plate that lifts at its corners, bent by a load and by temperature, on ground that yields."""
    given: dict[str, object] = {
        "plate": {"length_x": 6.0, "length_y": 4.0, "thickness": 0.2, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 30e6},
        "contact": {"limit_pressure": 110e3},
        "loads": [
            {"kind": "patch", "q": share * 900e3, "x": (-0.8, 0.8), "y": (-0.8, 0.8)},
            {"kind": "temperature", "difference": share * -10.0},
        ],
        "mesh": {"counts": (12, 8)},
        "analysis": {"increments": increments},
    }
    return Model(**{**given, **changes})


@pytest.fixture(scope="module")
def in_four() -> CombinationResult:
    """Return the results of four increments."""
    return driver.solve(model(increments=4)).only


def test_each_state_is_that_of_a_load_of_its_size(in_four: CombinationResult) -> None:
    """The ground yields more with every increment, and thermal moments grow with it, too."""
    assert [each.share for each in in_four.increments] == [0.25, 0.5, 0.75]
    sunk = []
    for each in in_four.increments:
        wanted = driver.solve(model(each.share))
        for name in FIELDS:
            one, other = getattr(each.plate, name), getattr(wanted.plate, name)
            np.testing.assert_allclose(one, other, rtol=0, atol=1e-8 * max(np.abs(other).max(), 1e-6), err_msg=name)
        np.testing.assert_allclose(each.elements.moment_y, wanted.elements.moment_y, rtol=0, atol=1e-4)
        np.testing.assert_allclose(each.ground.settlement, wanted.ground.settlement, rtol=0, atol=1e-10)
        sunk.append(each.plate.penetration.max())
    assert sunk[0] == 0
    assert 0 < sunk[1] < sunk[2] < in_four.plate.penetration.max()


def test_one_increment_has_no_states_on_the_way() -> None:
    """The usual analysis keeps the last state alone."""
    assert driver.solve(model()).increments == ()


def test_the_worst_certificate_of_all_increments_counts() -> None:
    """If the state under a share of the load is bad the results are not certified, however good the last one is."""
    certificate, made = task.certificate, list[Certificate]()

    def second_is_bad(solution: object, effect: float | None) -> Certificate:
        proof = certificate(solution, effect)  # type: ignore[arg-type]
        made.append(proof)
        return replace(proof, residual=0.125) if len(made) == 2 else proof

    with patch.object(task, "certificate", second_is_bad), pytest.raises(NotCertified) as caught:
        driver.solve(model(increments=3))
    assert len(made) == 3
    assert caught.value.results.certificate.residual == 0.125
    assert caught.value.results.certificate.load == made[0].load


def test_states_stand_in_files_and_come_back(in_four: CombinationResult, tmp_path: Path) -> None:
    """ParaView's collection names a file for each share of the load; the archive gives the same states back."""
    folder = results_folder.save_results(in_four, tmp_path / "results")
    for part in ("plate", "ground"):
        sets = ElementTree.parse(folder / f"{part}-increments.pvd").getroot().iter("DataSet")
        files = {float(each.attrib["timestep"]): each.attrib["file"] for each in sets}
        assert list(files) == [0.25, 0.5, 0.75, 1.0]
        assert all((folder / file).is_file() for file in files.values())
    half = meshio.read(folder / "increments" / "02-plate.vtu").point_data["settlement w [mm]"]
    np.testing.assert_allclose(half, 1e3 * in_four.increments[1].plate.settlement, rtol=1e-12)
    found = npz.load(folder / "results.npz")
    for one, other in zip(found.increments, in_four.increments, strict=True):
        assert one.share == other.share
        np.testing.assert_array_equal(one.plate.nodes, other.plate.nodes)
        np.testing.assert_array_equal(one.plate.moment_xy, other.plate.moment_xy)
        np.testing.assert_array_equal(one.elements.pressure, other.elements.pressure)
        np.testing.assert_array_equal(one.ground.settlement, other.ground.settlement)
    (again,) = results_folder.load_results(folder).results.values()
    assert len(again.increments) == 3
