"""Pieces of design strips are in equilibrium: of fields that are exactly, by hand, and of slabs that are solved."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from groundslab.design.demands.cuts.section_cuts import strip
from groundslab.design.demands.cuts.strip_balance import StripBalance, strip_balance
from groundslab.model.model import Model
from groundslab.model.outputs import OutputStrip
from groundslab.results.results import CombinationResult
from groundslab.views.tables.result_tables import tables_of
from helpers.solve_once import solve_once

Q = 10e3
STRIPS = {
    "along x": OutputStrip(name="a", start=(-3, 0.5), end=(2, 0.5), width=1.5, stations=6),
    "at an angle": OutputStrip(name="b", start=(-2, -1), end=(2, 1), width=1.0, stations=4),
}


def model(**changes: Any) -> Model:
    """Return a slab of 8 m by 5 m on springs under an even load."""
    given: dict[str, Any] = {
        "plate": {"length_x": 8, "length_y": 5, "thickness": 0.4, "E": 33e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 25e6}, "loads": [{"kind": "uniform", "q": Q}], "mesh": {"size": 1.0},
    }  # fmt: skip
    return Model(**given | changes)


def balance(results: CombinationResult, of: OutputStrip) -> StripBalance:
    """Return the balance of a strip."""
    cuts = strip(results.plate, of.start, of.end, of.width, of.stations)
    found = strip_balance(results, of, cuts)
    assert found is not None
    return found


def by_hand(more_pressure: float = 0.0) -> CombinationResult:
    """Return m_x = c x^2 / 2, m_y = e y^2 / 2, m_xy = g x y, with q and p in equilibrium but for more pressure.

    q_x = (c + g) x and q_y = (e + g) y, so that p = q + c + e + 2 g.
    """
    (results,) = solve_once(model()).results.values()
    x, y = results.plate.nodes.T
    c, e, g = 3e3, -2e3, 1.5e3
    pressure = np.full(len(x), Q + c + e + 2 * g + more_pressure)
    fields = {
        "moment_x": c * x**2 / 2, "moment_y": e * y**2 / 2, "moment_xy": g * x * y, "shear_x": (c + g) * x,
        "shear_y": (e + g) * y, "pressure": pressure, "line_force": np.zeros(len(x)),
    }  # fmt: skip
    return replace(results, plate=replace(results.plate, **fields))


@pytest.mark.parametrize("of", STRIPS.values(), ids=STRIPS)
def test_what_is_in_equilibrium_has_no_imbalance(of: OutputStrip) -> None:
    """Loads, pressure, both cuts and both sides add up to nothing, and pressure alone to itself and its lever."""
    length = float(np.hypot(*np.subtract(of.end, of.start)))
    piece = length / (of.stations - 1)
    area = piece * of.width
    found = balance(by_hand(), of)
    assert found.loads[1:] == pytest.approx(Q * area)
    assert found.reactions[1:] == pytest.approx((Q + 3e3 - 2e3 + 2 * 1.5e3) * area)
    assert np.abs(found.shear).max() < 1e-3 * Q * area
    assert np.abs(found.moment).max() < 1e-3 * Q * area * piece
    more = balance(by_hand(1e3), of)
    assert (more.shear - found.shear)[1:] == pytest.approx(1e3 * area)
    # from its middle, about the cut before
    assert (more.moment - found.moment)[1:] == pytest.approx(-1e3 * area * piece / 2)


def test_all_of_a_slab_has_all_loads_and_reactions_once() -> None:
    """A column and a support that stand at cuts are counted once; what is left falls with the element's size."""
    columns = [{"name": "A", "x": 0.0, "y": 0.5, "width_x": 0.4, "width_y": 0.4}]
    loads = [{"kind": "uniform", "q": Q}, {"kind": "point", "column": "A", "P": 400e3, "M_x": 30e3},
             {"kind": "point", "x": 2.0, "y": 0.0, "P": 100e3}]  # fmt: skip
    supports = [{"kind": "point", "x": -2.0, "y": 0.0, "stiffness": 50e6}]
    left = []
    for size in (1.0, 0.5):
        solved = solve_once(model(columns=columns, loads=loads, supports=supports, mesh={"size": size}))
        (results,) = solved.results.values()
        whole = balance(results, OutputStrip(name="w", start=(-4, 0), end=(4, 0), width=5.0, stations=5))
        assert whole.loads.sum() == pytest.approx(Q * 40 + 500e3)
        assert whole.reactions.sum() == pytest.approx(Q * 40 + 500e3, rel=1e-3)
        parts = OutputStrip(name="p", start=(-3.5, 1), end=(3.5, 1), width=1.0, stations=3)
        left.append(np.abs(balance(results, parts).shear).max())
    assert left[1] < left[0] / 2


def test_the_table_has_it_where_no_beams_carry() -> None:
    """Beside the section forces; with beams there is none, as their forces are theirs."""
    output = {"strips": [{"name": "a", "start": (-3, 0), "end": (3, 0), "width": 1.0, "stations": 4}]}
    beams = [{"name": "B", "points": [(-4, 0), (4, 0)], "section": {"kind": "rectangle", "width": 0.3, "height": 0.8}}]
    with_it, without = (
        next(each for each in tables_of(solve_once(model(output=output, **more))) if each.name == "strips")
        for more in ({}, {"beams": beams})
    )
    # even load, even pressure: nothing bends
    assert list(with_it["loads before"]) == pytest.approx([0.0, *[Q * 2.0 / 1e3] * 3])
    assert list(with_it["reactions before"]) == pytest.approx([0.0, *[Q * 2.0 / 1e3] * 3])
    assert list(with_it["imbalance of shear"]) == pytest.approx([0.0] * 4, abs=1e-6)
    assert all(value is None or np.isnan(value) for value in without["loads before"])
