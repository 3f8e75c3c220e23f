"""What can be made large without effect has none: no tolerance is scaled by it.

An input file takes no gap above 1e7 m; copies of its parts, which are not checked again, have larger ones.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.model.ground import Pasternak, Winkler
from groundslab.model.loads.load_types import PointLoad, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.settings import Contact, Mesh
from groundslab.model.supports import PointSupport
from groundslab.model.varying_ground import GapPoint, Void
from groundslab.results.results import CombinationResult
from helpers.solve_once import solve_once

FACTORS = [1e3, 1e6, 1e12]
#: The loads press all but a corner of the plate down, so that a tolerance that is too wide can be seen.
LOADS = [UniformLoad(q=10e3), PointLoad(P=100e3, x=0.0, y=0.0), PointLoad(P=80e3, x=2.5, y=1.5)]


def solved(ground: str = "winkler", **keys: Any) -> CombinationResult:
    """Return the results of a plate of 6 x 4 m on springs."""
    k = {"winkler": Winkler(k=20e6), "pasternak": Pasternak(k0=20e6, k1=10e6)}[ground]
    plate = Plate(length_x=6, length_y=4, thickness=0.25, E=30e9, nu=0.2)
    return solve_once(
        Model(plate=plate, ground=k, mesh=Mesh(size=0.5, symmetry="off"), **{"loads": LOADS, **keys})
    ).only


def assert_same(a: CombinationResult, b: CombinationResult) -> None:
    """Hold settlement, moments, contact and pressure of two results to each other, to 1e-6 of the largest value."""
    assert b.certificate.holds
    for name in ("settlement", "moment_x", "shear_y", "pressure"):
        one, other = getattr(a.plate, name), getattr(b.plate, name)
        np.testing.assert_allclose(other, one, rtol=0, atol=1e-6 * np.abs(one).max())
    np.testing.assert_array_equal(b.plate.in_contact, a.plate.in_contact)


VOID = Void(x=(-3, -1), y=(-2, 0), depth=1.0)


@pytest.mark.slow
@pytest.mark.parametrize("ground", ["winkler", "pasternak"])
@pytest.mark.parametrize("factor", FACTORS)
def test_depth_of_a_void_that_stays_open(factor: float, ground: str) -> None:
    """A void of 1 m is never reached; nor is one of a million kilometres."""
    one, other = (
        solved(ground, contact=Contact(voids=[VOID.model_copy(update={"depth": depth})])) for depth in (1.0, factor)
    )
    assert 0.5 < one.plate.area[one.plate.in_contact].sum() / 24 < 0.95
    assert_same(one, other)


@pytest.mark.slow
@pytest.mark.parametrize("factor", FACTORS)
def test_measured_gaps_that_stay_open(factor: float) -> None:
    """A plate on four piles above ground that it never touches, 1 m below it and much deeper."""
    keys = {"supports": [PointSupport(x=x, y=y) for x in (-3, 3) for y in (-2, 2)]}
    points = [GapPoint(x=x, y=y, gap=1.0) for x in (-3, 3) for y in (-2, 2)]
    gaps = [[point.model_copy(update={"gap": size}) for point in points] for size in (1.0, factor)]
    one, other = (solved(contact=Contact(gaps=each), **keys) for each in gaps)
    assert not one.plate.in_contact.any()
    assert_same(one, other)


@pytest.mark.slow
@pytest.mark.parametrize("ground", ["winkler", "pasternak"])
@pytest.mark.parametrize("factor", FACTORS)
@pytest.mark.parametrize("acts", ["in compression", "in tension"])
def test_gap_of_a_support_that_is_not_reached(acts: str, factor: float, ground: str) -> None:
    """A pile 1 m below the plate, and one much deeper; the same for an anchor with slack."""
    support = PointSupport(x=2, y=1, acts=acts, gap=1.0, stiffness=1e8)
    one, other = (solved(ground, supports=[support.model_copy(update={"gap": gap})]) for gap in (1.0, factor))
    assert one.supports[0].total == other.supports[0].total == 0.0
    assert_same(one, other)


@pytest.mark.slow
@pytest.mark.parametrize("factor", FACTORS)
def test_limits_that_are_not_reached(factor: float) -> None:
    """Ground and pile that could carry far more than they must."""
    one, other = (
        solved(
            contact=Contact(limit_pressure=size * 1e6),
            supports=[PointSupport(x=2, y=1, acts="in compression", stiffness=1e7, limit=size * 1e6)],
        )
        for size in (1.0, factor)
    )
    assert one.supports[0].total > 1e3
    assert_same(one, other)


@pytest.mark.slow
@pytest.mark.parametrize("factor", FACTORS[:2])
def test_load_that_a_rigid_support_takes_at_once(factor: float) -> None:
    """A column right above a rigid pile: however large its force, plate and certificate know nothing of it."""
    supports = [PointSupport(x=1.0, y=1.0)]
    one, other = (
        solved(supports=supports, loads=[*LOADS, PointLoad(P=size, x=1.0, y=1.0)]) for size in (1e5, factor * 1e5)
    )
    assert one.certificate.residual < 1e-9
    assert_same(one, other)
