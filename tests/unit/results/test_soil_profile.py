"""Columns of soil in depth: their layers as described, their mode as the analysis took it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.discretize.ground import grounds_of
from groundslab.fem.vlasov import Soil
from groundslab.model.model import Model
from groundslab.results.records import Constants
from groundslab.results.results import CombinationResult
from groundslab.results.soil_profile import Profile, Stratum, profiles_of
from helpers import synthetic

SOFT = {"E": 10e6, "E_bottom": 20e6, "nu": 0.3, "thickness": 2.0}
FIRM = {"E": 60e6, "nu": 0.25, "thickness": 3.0}


def solved(gamma: float | None, ground: dict[str, Any], **parts: Any) -> CombinationResult:
    """Return made-up results on a ground, whose analysis is said to have ended with a gamma of the first column."""
    model = Model(
        plate={"length_x": synthetic.LENGTH_X, "length_y": synthetic.LENGTH_Y, "thickness": 0.2, "E": 23e9, "nu": 0.2},
        ground=ground,
        loads=[{"kind": "uniform", "q": 1e4}],
        **parts,
    )
    first = grounds_of(model)[0]
    decay = gamma / first.gamma_of(1.0) if gamma is not None and isinstance(first, Soil) else None
    return synthetic.results(4, model=model, constants=Constants((2e7,), (1e6,), gamma, 3, decay))


def one(results: CombinationResult) -> Profile:
    """Return the only column."""
    (found,) = profiles_of(results)
    return found


def test_layers_stand_one_below_the_other() -> None:
    """Depths add up; a modulus without E_bottom stays the same."""
    found = one(solved(2.0, {"kind": "vlasov", "layers": [SOFT, FIRM]}))
    assert found.name == "ground"
    assert found.strata == (
        Stratum(0, 2, 10e6, 20e6, "linear", 0.3),
        Stratum(2, 5, 60e6, 60e6, "linear", 0.25),
    )


@pytest.mark.parametrize("gamma", [1e-9, 1.3, 40.0, 800.0])
def test_one_layer_has_the_sinh_mode_and_its_integrals(gamma: float) -> None:
    """Psi is sinh(gamma (1 - z/h)) / sinh gamma, and k0 and k1 are its integrals, done here by the trapezoidal rule."""
    h, E, nu = 5.0, 42e6, 0.3
    layer = {"E": E, "nu": nu, "thickness": h}
    found = one(solved(gamma, {"kind": "vlasov", "layers": [layer]}))
    assert found.gamma == pytest.approx(gamma)
    assert (found.z[0], found.z[-1], found.psi[0], found.psi[-1]) == (0, h, 1, 0)
    if gamma > 700:  # sinh itself is too large for a float there
        assert found.psi == pytest.approx(np.exp(-gamma * found.z / h), abs=1e-12)
        return
    assert found.psi == pytest.approx(np.sinh(gamma * (1 - found.z / h)) / np.sinh(gamma), abs=1e-12)
    z = np.linspace(0, h, 400_001)
    psi = np.sinh(gamma * (1 - z / h)) / np.sinh(gamma)
    slope = -gamma / h * np.cosh(gamma * (1 - z / h)) / np.sinh(gamma)
    constrained, shear = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))
    assert found.k0 == pytest.approx([constrained * np.trapezoid(slope**2, z)], rel=1e-6)
    assert found.k1 == pytest.approx([shear * np.trapezoid(psi**2, z)], rel=1e-6)


def test_several_layers_have_the_mode_of_the_profile() -> None:
    """Of two layers that are alike the mode is that of one of both thicknesses."""
    halves = [FIRM, FIRM]
    whole = one(solved(1.7, {"kind": "vlasov", "layers": [FIRM | {"thickness": 6.0}]}))
    parted = one(solved(1.7, {"kind": "vlasov", "layers": halves}))
    assert parted.gamma == pytest.approx(1.7)
    assert np.interp(whole.z, parted.z, parted.psi) == pytest.approx(whole.psi, abs=1e-4)
    assert (parted.k0, parted.k1) == (pytest.approx(whole.k0, rel=1e-6), pytest.approx(whole.k1, rel=1e-6))


def test_columns_of_varying_ground_share_one_decay() -> None:
    """A zone on a quarter of the plate: the gammas go with h sqrt(G / Ec) and their mean by area is that found."""
    thick = {"kind": "vlasov", "layers": [FIRM | {"thickness": 6.0}]}
    zone = {"shape": {"kind": "rectangle", "x": (0.0, 9.0), "y": (0.0, 9.0)}, "ground": thick}
    results = groundslab.solve(
        Model(
            plate={"length_x": 8.0, "length_y": 6.0, "thickness": 0.3, "E": 30e9, "nu": 0.2},
            ground={"kind": "vlasov", "layers": [FIRM]},
            soil_zones=[zone],
            loads=[{"kind": "uniform", "q": 1e4}],
            mesh={"counts": (4, 4)},
        )
    ).only
    ground, other = profiles_of(results)
    assert (ground.name, other.name) == ("ground", "zone of soil 1")
    assert ground.gamma is not None
    assert other.gamma == pytest.approx(2 * ground.gamma)
    assert 0.75 * ground.gamma + 0.25 * other.gamma == pytest.approx(results.constants.gamma)


def test_boreholes_are_the_columns() -> None:
    """With boreholes each of them is reported, by its name or number; a given gamma is that of all."""
    holes = [
        {"name": "B1", "x": -4, "y": 0, "layers": [FIRM]},
        {"x": 4, "y": 0, "layers": [FIRM | {"thickness": 4.0}]},
    ]
    ground = {"kind": "vlasov", "layers": [SOFT], "gamma": 1.2}
    found = profiles_of(solved(1.2, ground, boreholes=holes))
    assert [each.name for each in found] == ["B1", "borehole 2"]
    assert [each.gamma for each in found] == [1.2, 1.2]
    assert [each.strata[-1].bottom for each in found] == [3, 4]


def test_interface_layers_have_no_common_mode() -> None:
    """Each layer of a stack has k0 and k1 of its own, from the gamma found; there is no psi over the depth."""
    ground = {"kind": "layered", "coupling": "interface", "layers": [FIRM, FIRM]}
    found = one(solved(1.5, ground))
    assert len(found.k0) == len(found.k1) == 2
    assert len(found.z) == len(found.psi) == 0


def test_ground_without_layers() -> None:
    """Springs have constants and nothing in depth."""
    found = one(solved(None, {"kind": "pasternak", "k0": 2e7, "k1": 1e6}))
    assert (found.strata, found.gamma, found.k0, found.k1) == ((), None, (2e7,), (1e6,))
