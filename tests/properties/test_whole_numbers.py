"""Whole numbers are numbers like any others: where Python callers pass integers, floats give the same."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import groundslab as g
from groundslab.analysis.driver import Variants
from groundslab.design.codes.en1992_2004 import bending, materials, perimeter_demand
from groundslab.design.demands import design_moments, tilt
from groundslab.design.demands.cuts import section_cuts
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.results import CombinationResult
from groundslab.verification import analytic
from helpers.examples import examples

pytestmark = pytest.mark.slow


def model(number: Callable[[int], float]) -> g.Model:
    """Return a slab on layered ground with margin, zone, void and loads of all shapes, built of one kind of number."""
    n = number
    corners = [(n(-2), n(-1)), (n(-1), n(-1)), (n(-1), n(1))]
    return g.Model(
        plate=g.Plate(
            length_x=n(6), length_y=n(4), thickness=n(1), E=n(30_000_000_000), nu=n(0),
            zones=[g.Zone(shape=g.Rectangle(x=[n(1), n(3)], y=[n(-1), n(1)]), thickness=n(2))],
        ),
        ground=g.Pasternak(k0=n(20_000_000), k1=n(1_000_000)),
        beyond=g.Beyond(kind="margin", width=n(2)),
        contact=g.Contact(voids=[g.Void(x=[n(-3), n(-2)], y=[n(1), n(2)], depth=n(1))]),
        loads=[
            g.UniformLoad(q=n(1000)),
            g.PointLoad(P=n(200_000), x=n(1), y=n(1), width_x=n(1), width_y=n(1)),
            g.PatchLoad(x=[n(-1), n(0)], y=[n(0), n(2)], q=n(5000)),
            g.AreaLoad(shape=g.Polygon(points=corners), q=n(3000)),
            g.LineLoad(points=[(n(-2), n(1)), (n(2), n(1))], q=n(7000)),
        ],
        mesh=g.Mesh(size=n(1)),
    )  # fmt: skip


@cache
def solved() -> CombinationResult:
    """Return the results of the model built of floats."""
    return g.solve(model(float))


def assert_same(one: Any, other: Any) -> None:
    """Hold two values against each other, in their numbers and in the kind of their arrays."""
    if is_dataclass(one):
        for field in fields(one):
            assert_same(getattr(one, field.name), getattr(other, field.name))
    elif isinstance(one, np.ndarray):
        assert one.dtype == other.dtype
        np.testing.assert_array_equal(one, other)
    elif isinstance(one, tuple | list):
        for own, its in zip(one, other, strict=True):
            assert_same(own, its)
    elif isinstance(one, dict):
        assert_same(tuple(one.values()), tuple(other.values()))
    else:
        assert one == other or one is other or str(one) == str(other)


def test_a_model_of_whole_numbers_has_the_results_of_one_of_floats() -> None:
    """Plate, zone, ground, margin, void and every kind of load given as int and as float."""
    assert_same(g.solve(model(int)).plate, solved().plate)


WHOLE_X, WHOLE_Y = st.lists(st.integers(-3, 3), min_size=1, max_size=6), st.integers(-2, 2)


@settings(max_examples=examples(100), deadline=None, derandomize=True)
@given(WHOLE_X, WHOLE_Y, st.sampled_from(sorted(PLATE_FIELDS)))
def test_values_at_whole_numbers(x: list[int], y: int, field: str) -> None:
    """Values of plate and ground at integers, alone and in arrays, are those at the same floats."""
    plate, ground = solved().plate, solved().ground
    for of in (np.array(x), x, x[0]):
        floats: Any = np.asarray(of, dtype=float) if not isinstance(of, int) else float(of)
        assert_same(plate.value_at(field, of, y), plate.value_at(field, floats, float(y)))
        assert_same(ground.value_at(of, y), ground.value_at(floats, float(y)))
        assert_same(plate.element_at(of, y), plate.element_at(floats, float(y)))


def as_floats(value: Any) -> Any:
    """Return arguments with every whole number as a float."""
    if isinstance(value, np.ndarray):
        return value.astype(float)
    if isinstance(value, tuple | list):
        return type(value)(as_floats(each) for each in value)
    if isinstance(value, dict):
        return {name: as_floats(each) for name, each in value.items()}
    return float(value) if type(value) is int else value


def _punching(x: float, y: float, width: float, d: float, force: float) -> perimeter_demand.Punching:
    column = perimeter_demand.RectangularColumn(x, y, width, width)
    return perimeter_demand.demand(solved().plate, column, d, force, 1000, 1)


def _required(m: Any, d: Any, d_2: Any, t: Any) -> bending.Reinforcement:
    concrete, steel = materials.Concrete(30_000_000, 1, 1), materials.Steel(500_000_000, 1)
    return bending.required(m, d, concrete, steel, d_2=d_2, thickness=t)


CALLS: dict[str, tuple[Callable[..., Any], tuple[Any, ...]]] = {
    "section line": (lambda *a: section_cuts.cut_along(solved().plate, *a), (np.array([[-3, 0], [3, 1]]), 1)),
    "strip": (lambda *a: section_cuts.strip(solved().plate, *a, 5), ((-3, 0), (3, 0), 2)),
    "differences": (lambda a: tilt.settlement_differences(solved().plate, a), ({"A": (1, 1), "B": (-2, 1)},)),
    "punching": (_punching, (0, 0, 1, 1, 100_000)),
    "principal moments": (design_moments.principal_moments, (np.array([1, 2]), np.array([4, -5]), np.array([1, 0]))),
    "design moments": (design_moments.wood_armer, (np.array([1, -3]), np.array([-5, 0]), np.array([1, 2]))),
    "reinforcement": (_required, (np.array([100_000, 90_000_000, 0]), 3, 1, 4)),
    "Navier": (analytic.navier, (1, 1, 6, 4, 1, 30_000_000_000, 0, 1, 1000, 20_000_000, 1_000_000)),
    "circular plate": (analytic.circular_plate, (1, 3, 1, 30_000_000_000, 0, 1, 1000, True)),
    "strip on two springs": (
        analytic.strip_on_two_springs, (1, 1, 30_000_000_000, 1, 1000, 20_000_000, 10_000_000),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CALLS)
def test_functions_take_whole_numbers(name: str) -> None:
    """What a function makes of integers is what it makes of the same floats."""
    call, arguments = CALLS[name]
    assert_same(call(*arguments), call(*as_floats(arguments)))


def test_factors_of_the_ground_may_be_whole_numbers() -> None:
    """Factors from place to place as integers, or one for all places, act as floats do."""
    base = g.Model(
        plate=g.Plate(length_x=6, length_y=4, thickness=1, E=30e9, nu=0.2),
        ground=g.Winkler(k=20e6),
        loads=[g.UniformLoad(q=1e3)],
        mesh=g.Mesh(size=1),
    )
    variants = Variants(base)

    def plate(factor: Callable[..., Any]) -> Any:
        (results,) = variants.solve_combinations(base, {"ground.k": factor}).results.values()
        return results.plate

    assert_same(plate(lambda x, y: np.where(x > y, 2, 1)), plate(lambda x, y: np.where(x > y, 2.0, 1.0)))
    assert_same(plate(lambda x, y: 2), plate(lambda x, y: 2.0 + 0 * x))  # noqa: ARG005
