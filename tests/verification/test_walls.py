"""A wall of some thickness on a strip: settlement and moment under it by Fourier's integral of a beam on springs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad

import groundslab as gs
from groundslab.views.tables.result_tables import tables_of

#: Thickness of the strip [m], modulus of its springs [Pa/m], load per length of the wall [N/m], its thickness [m].
H, K, Q, T = 0.5, 30e6, 200e3, 0.8
E = 30e9
LENGTH, WIDTH = 24.0, 3.0


def solve(**load: Any) -> gs.Results:
    """Return the results of a strip under a load across its middle, on springs that pull, too."""
    across = [(0.0, -WIDTH / 2), (0.0, WIDTH / 2)]
    return gs.solve(
        gs.Model(
            plate={"length_x": LENGTH, "length_y": WIDTH, "thickness": H, "E": E, "nu": 0.0},
            ground={"kind": "winkler", "k": K},
            contact={"tensionless": False},
            walls=[{"name": "W", "thickness": T, "points": across}],
            loads=[load or {"kind": "line", "q": Q, "wall": "W"}],
            mesh={"size": 0.1},
        )
    )


def under_the_wall(width: float) -> tuple[float, float]:
    """Return settlement [m] and moment [N m/m] under a load over a width, of an endless beam with shear strains.

    The transform of the equations: D xi^4 w / (1 + D xi^2 / S) + k w = q, M = D xi^2 w / (1 + D xi^2 / S).
    """
    D, S = E * H**3 / 12, 5 / 6 * E / 2 * H

    def bent(xi: float) -> float:
        return D * xi**2 / (1 + D * xi**2 / S)

    def settlement(xi: float) -> float:
        return float(Q * np.sinc(xi * width / (2 * np.pi)) / (bent(xi) * xi**2 + K))

    w, moment = (
        quad(transform, 0, 400, limit=2000)[0] / np.pi
        for transform in (settlement, lambda xi: bent(xi) * settlement(xi))
    )
    return w, moment


def test_a_wall_spreads_its_load_over_its_thickness() -> None:
    """Settlement and moment on the axis to a thousandth; without the thickness the moment is a fifth larger."""
    w, moment = under_the_wall(T)
    results = solve().only
    assert results.plate.value_at("settlement", 0.0, 0.0) == pytest.approx(w, rel=1e-3)
    assert results.plate.value_at("moment_x", 0.0, 0.0) == pytest.approx(moment, rel=1e-3)
    assert under_the_wall(1e-6)[1] > 1.15 * moment


def test_its_row_says_what_it_carries_and_how_it_settles() -> None:
    """The whole load stands in it, the settlement is the same along the wall, which does not bend."""
    results = solve()
    table = next(table for table in tables_of(results) if table.name == "walls")
    (row,) = [dict(zip([column.name for column in table.columns], row, strict=True)) for row in table.rows()]
    assert (row["wall"], row["length"], row["load"]) == ("W", pytest.approx(WIDTH), pytest.approx(WIDTH * Q / 1e3))
    assert row["least load per length"] == row["greatest load per length"] == pytest.approx(Q / 1e3)
    for where in ("settlement at the start", "settlement at the end", "least settlement", "greatest settlement"):
        assert row[where] == pytest.approx(under_the_wall(T)[0] * 1e3, rel=1e-3)
    assert abs(row["deflection"]) < 1e-6
