"""Plates that are nearly rigid or nearly without stiffness: right, or named as beyond the computer's digits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.errors import IllConditioned, NoEquilibrium
from groundslab.model.ground import Winkler
from groundslab.model.loads.load_types import PointLoad, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Edges, Plate
from groundslab.model.settings import Mesh

LX, LY, K = 6.0, 4.0, 20e6


def loaded(E: float, thickness: float, **keys: Any) -> Model:
    """Return a plate on springs under 240 kN in its middle and 200 kN at (0.5, 0.25) m."""
    return Model(
        plate=Plate(length_x=LX, length_y=LY, thickness=thickness, E=E, nu=0.2, **keys),
        ground=Winkler(k=K),
        loads=[UniformLoad(q=10e3), PointLoad(P=200e3, x=0.5, y=0.25)],
        mesh=Mesh(counts=(8, 6)),
    )


@pytest.mark.parametrize(("E", "thickness"), [(1e14, 0.25), (1e15, 0.25), (1e16, 0.25), (1e14, 2.0), (1e15, 2.0)])
def test_a_nearly_rigid_plate_settles_as_a_rigid_one(E: float, thickness: float) -> None:
    """A rigid rectangle on springs: w = P / kA + M_x x / k I_x + M_y y / k I_y, to six digits and certified.

    What bending adds is about the moment times length squared over D, given as the tolerance's second part.
    """
    plate = solve(loaded(E, thickness)).plate
    x, y = plate.nodes.T
    rigid = 440e3 / (K * LX * LY) + 100e3 * x / (K * LY * LX**3 / 12) + 50e3 * y / (K * LX * LY**3 / 12)
    bent = 440e3 * LX**2 / (E * thickness**3 / 12) / 50
    np.testing.assert_allclose(plate.settlement, rigid, rtol=0, atol=1e-6 * rigid.max() + bent)


def test_too_rigid_is_named_before_anything_is_solved() -> None:
    """Where 16 digits cannot tell the ground beside the plate the error says so, and no step is taken."""
    steps: list[Any] = []
    with pytest.raises(IllConditioned, match=r"times as stiff as the ground.*plate\.E"):
        solve(loaded(1e18, 1.0), on_step=steps.append)
    assert not steps


def test_a_held_plate_may_be_as_stiff_as_it_likes() -> None:
    """Edges that hold the plate spare the ground: settlements go with 1 / E, however soft the ground is beside it."""
    stiff, stiffer = (
        solve(loaded(E, 1.0, edges=Edges(left="clamped", right="clamped"))).plate.settlement for E in (1e15, 1e18)
    )
    np.testing.assert_allclose(1e3 * stiffer, stiff, rtol=0, atol=1e-3 * stiff.max())


def test_too_thin_is_named_before_anything_is_solved() -> None:
    """A foil of a ten-millionth of its length: the error speaks of thickness."""
    with pytest.raises(IllConditioned, match=r"softer than the ground.*thicker"):
        solve(loaded(30e9, 6e-7))


def test_no_weight_and_balanced_weight_are_refused_alike() -> None:
    """Uplift exactly as large as the weight leaves as little to hold the plate as no load at all."""
    from groundslab.model.loads.load_types import SelfWeight

    balanced = loaded(30e9, 0.25).replace(loads=[SelfWeight(unit_weight=25e3), UniformLoad(q=-6.25e3)])
    with pytest.raises(NoEquilibrium, match=r"their sum is 0 kN"):
        solve(balanced)
