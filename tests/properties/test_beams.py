"""Beams of every kind: mirrored, turned and scaled slabs have such results."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from groundslab.analysis.driver import solve
from groundslab.arrays import Array
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.structure.beams import Beam
from groundslab.results.results import CombinationResult
from helpers.examples import examples
from helpers.similar import rescale
from helpers.strategies import beams

PLATE = Plate(length_x=6.0, length_y=4.0, thickness=0.25, E=30e9, nu=0.2)
FEW = settings(derandomize=True, deadline=None, database=None, suppress_health_check=list(HealthCheck))
SAME = 1e-6  # of the largest value


def solved(ribs: list[Beam], force: tuple[float, float] = (1.0, 0.5), plate: Plate = PLATE) -> CombinationResult:
    """Return the results of a slab with beams under a force, and under a weight that holds it down in part."""
    model = Model(
        plate=plate,
        ground={"kind": "pasternak", "k0": 30e6, "k1": 20e6},
        beams=ribs,
        loads=[
            {"kind": "uniform", "q": 2e3},
            {"kind": "point", "x": force[0], "y": force[1], "P": 200e3, "width_x": 0.4, "width_y": 0.4},
        ],
        mesh={"size": 0.6},
    )
    found = solve(model).only
    assert found.certificate.holds
    return found


ribs = st.integers(1, 3).flatmap(lambda count: beams(PLATE, ["A", "B", "C"][:count]))


def placed(ribs: list[Beam], turn: Array) -> list[Beam]:
    """Return beams at other places: their points times a matrix (2, 2)."""
    return [rib.replace(points=[tuple((turn @ point).tolist()) for point in rib.points or ()]) for rib in ribs]


def assert_same(one: Array, other: Array, scale: float) -> None:
    """Hold values to each other, measured by the largest of a kind."""
    np.testing.assert_allclose(one, other, rtol=0, atol=SAME * max(scale, 1e-12))


def compare(one: CombinationResult, image: CombinationResult, turn: Array, sign: float, factor: float = 1.0) -> None:
    """Hold the settlements of a slab and its image to each other, and the section forces of beams."""
    there = one.plate.nodes @ turn.T
    distance, w = np.full(len(there), np.inf), np.zeros(len(there))
    for node, place in enumerate(there):
        off = np.linalg.norm(image.plate.nodes - place, axis=1)
        distance[node], w[node] = off.min(), image.plate.settlement[off.argmin()]
    assert distance.max() < 1e-9
    assert_same(one.plate.settlement, w, float(np.abs(w).max()))
    for name, turned in (("moment", 1.0), ("shear", 1.0), ("axial", 1.0), ("torsion", sign)):
        values = [np.abs(getattr(beam, name)) for beam in one.beams]
        scale = max(float(each.max()) for each in (*values, *(np.abs(beam.moment) for beam in one.beams)))
        for beam, other in zip(one.beams, image.beams, strict=True):
            assert_same(factor * getattr(beam, name), turned * getattr(other, name), factor * scale)


@pytest.mark.slow
@settings(FEW, max_examples=examples(10))
@given(ribs)
def test_mirror_image(ribs: list[Beam]) -> None:
    """The mirror image of beams and loads has the mirror image as solution; torsion turns the other way."""
    turn = np.diag([-1.0, 1.0])
    compare(solved(ribs), solved(placed(ribs, turn), (-1.0, 0.5)), turn, -1.0)


@pytest.mark.slow
@settings(FEW, max_examples=examples(10))
@given(ribs)
def test_quarter_turn(ribs: list[Beam]) -> None:
    """Turned by 90 degrees, everything has the turned solution; section forces stay as they are."""
    turn = np.array([[0.0, -1.0], [1.0, 0.0]])
    plate = PLATE.model_copy(update={"length_x": 4.0, "length_y": 6.0})
    compare(solved(ribs), solved(placed(ribs, turn), (-0.5, 1.0), plate), turn, 1.0)


@pytest.mark.slow
@settings(FEW, max_examples=examples(5))
@given(ribs, st.sampled_from([0.1, 30.0]), st.sampled_from([0.01, 1e3]))
def test_other_units(ribs: list[Beam], lengths: float, forces: float) -> None:
    """Lengths and forces times numbers give moments times that of both."""
    one = solved(ribs)
    other = solve(rescale(one.model, lengths, forces)).only
    assert_same(lengths * one.plate.settlement, other.plate.settlement, float(np.abs(other.plate.settlement).max()))
    for beam, scaled in zip(one.beams, other.beams, strict=True):
        scale = float(np.abs(scaled.moment).max())
        assert_same(lengths * forces * beam.moment, scaled.moment, scale)
        assert_same(forces * beam.shear, scaled.shear, max(float(np.abs(scaled.shear).max()), scale / lengths))
        assert_same(forces * beam.axial, scaled.axial, max(float(np.abs(scaled.axial).max()), scale / lengths))
