"""Envelopes: the extremes of each entry, and the combination that each comes from."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from groundslab.design.demands.envelope import envelope
from groundslab.errors import InputError
from helpers.examples import examples

VALUES = st.floats(-1e6, 1e6)


@pytest.mark.slow
@settings(max_examples=examples(60), deadline=None, derandomize=True)
@given(st.lists(arrays(float, (4, 2), elements=VALUES), min_size=1, max_size=5))
def test_no_combination_leaves_the_envelope(values: list[np.ndarray]) -> None:
    """All combinations lie between least and greatest, and those named are the ones that touch them."""
    found = envelope({f"c{i}": array for i, array in enumerate(values)})
    for array in values:
        assert (found.least <= array).all()
        assert (array <= found.greatest).all()
    for at in np.ndindex(4, 2):
        assert values[found.greatest_by[at]][at] == found.greatest[at]
        assert values[found.least_by[at]][at] == found.least[at]


def test_names_and_ties() -> None:
    """Names keep their order; of combinations with the same value the first is named."""
    found = envelope({"wind": np.array([1.0, 5.0, 2.0]), "snow": np.array([3.0, -1.0, 2.0])})
    assert found.names == ("wind", "snow")
    assert [found.names[i] for i in found.greatest_by] == ["snow", "wind", "wind"]
    assert [found.names[i] for i in found.least_by] == ["wind", "snow", "wind"]
    assert found.greatest.tolist() == [3.0, 5.0, 2.0]
    assert found.least.tolist() == [1.0, -1.0, 2.0]


@pytest.mark.parametrize(
    ("combinations", "places"),
    [
        ({}, ["combinations"]),
        ({"a": np.zeros(3), "b": np.zeros(4)}, ["combinations['b']"]),
        (
            {"a": np.zeros(2), "b": np.array([0.0, np.nan]), "c": np.zeros(1)},
            ["combinations['c']", "combinations['b']"],
        ),
    ],
)
def test_faults(combinations: dict, places: list[str]) -> None:
    """No combination, other shapes, and values that are no numbers are refused."""
    with pytest.raises(InputError) as caught:
        envelope(combinations)
    assert [issue.location for issue in caught.value.issues] == places
