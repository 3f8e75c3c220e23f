"""The symmetric matrix as a value, against its full form."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csr_array, triu

from groundslab.fem.sparse.symmetric import Symmetric
from helpers.examples import examples


def sparse(seed: int, n: int = 12) -> tuple[Symmetric, np.ndarray]:
    """Return a random symmetric matrix with holes and a full diagonal, as a value and in full."""
    rng = np.random.default_rng(seed)
    A = rng.standard_normal((n, n)) * (rng.random((n, n)) < 0.3)
    A = A + A.T + np.diag(rng.random(n) + 1)
    upper = csr_array(triu(A))
    return Symmetric(upper.indptr, upper.indices, upper.data), A


def full(A: Symmetric) -> np.ndarray:
    """Return the full matrix."""
    upper = csr_array((A.data, A.indices, A.indptr), shape=(A.size, A.size)).toarray()
    return upper + np.triu(upper, 1).T


@settings(max_examples=examples(20), derandomize=True, deadline=None)
@given(seed=st.integers(0, 10_000), share=st.sampled_from([0.0, 0.3, 1.0]))
def test_products_parts_and_held_unknowns_are_those_of_the_full_matrix(seed: int, share: float) -> None:
    """The upper half knows the whole: product, diagonal, the part of some unknowns, rows and columns that are held."""
    A, wanted = sparse(seed)
    rng = np.random.default_rng(seed)
    u, some, added = rng.standard_normal(A.size), rng.random(A.size) < share, rng.random(A.size)
    np.testing.assert_allclose(A @ u, wanted @ u, atol=1e-12)
    np.testing.assert_array_equal(A.diagonal, np.diag(wanted))
    if some.any():
        np.testing.assert_array_equal(full(A.submatrix(np.flatnonzero(some))), wanted[np.ix_(some, some)])

    held = full(Symmetric(A.indptr, A.indices, A.constrain(some, added)))
    wanted = wanted + np.diag(added)
    wanted[some] = wanted[:, some] = 0.0
    wanted[some, some] = A.diagonal[some]
    np.testing.assert_allclose(held, wanted, atol=1e-15)


def test_holding_unknowns_leaves_the_matrix_as_it_was() -> None:
    """What is made of a matrix shares no numbers with it."""
    A, before = sparse(3)
    A.constrain(np.arange(A.size) < 4, np.ones(A.size))[:] = np.nan
    np.testing.assert_array_equal(full(A), before)


def test_the_value_cannot_be_changed() -> None:
    """A matrix that has been handed on stays what it is."""
    A, _ = sparse(1)
    with pytest.raises(AttributeError):
        A.data = np.zeros(3)  # type: ignore[misc]
