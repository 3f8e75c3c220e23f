"""Random fields over the plan: factors with a given distribution at each place and a given correlation length.

A Gaussian field with mean 0 and variance 1 is drawn by the randomization method
(Kraichnan 1970), as a sum of waves
that is a function of the place alone: the same field on every mesh. At each place it is carried over to the
distribution asked for, value for value of the same probability (a translation field, Grigoriu 1998).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.errors import Fault, InputError

if TYPE_CHECKING:
    from groundslab.shape import Array
    from groundslab.study.setup import Field

#: Waves of which a field is made. Their number matters for how well one field keeps the correlation, not for the
#: distribution at a place.
WAVES = 1000


def correlation(model: str, r: Array) -> Array:
    """Return the correlation (n,) over scaled distances r (n,): distances over the correlation length."""
    if model == "gaussian":
        return np.exp(-(r**2))
    if model == "exponential":
        return np.exp(-r)
    return (1 + math.sqrt(3) * r) * np.exp(-math.sqrt(3) * r)


def scores(field: Field, seed: int) -> Callable[[Array, Array], Array]:
    """Return a Gaussian field with mean 0 and variance 1, a function of x (n,) and y (n,) [m]."""
    gstools = library()
    # so that the library's correlations are those of `correlation`; its own are scaled to a length integral of one
    kinds = {
        "gaussian": (gstools.Gaussian, {"rescale": 1.0}),
        "exponential": (gstools.Exponential, {"rescale": 1.0}),
        "matern32": (gstools.Matern, {"nu": 1.5, "rescale": math.sqrt(2)}),
    }
    make, options = kinds[field.model]
    drawn = gstools.SRF(make(dim=2, var=1.0, len_scale=list(field.lengths), **options), seed=seed, mode_no=WAVES)

    def at(x: Array, y: Array) -> Array:
        found: Array = drawn((np.asarray(x, dtype=float), np.asarray(y, dtype=float)), store=False)
        return found

    return at


def factors(field: Field, seed: int) -> Callable[[Array, Array], Array]:
    """Return the field's factors, a function of x (n,) and y (n,) [m]."""
    drawn = scores(field, seed)

    def at(x: Array, y: Array) -> Array:
        from scipy.special import ndtr

        return field.distribution.at(ndtr(drawn(x, y)))

    return at


def library() -> Any:
    """Return the library of random fields; raises InputError where it is not installed."""
    try:
        import gstools
    except ImportError:
        expected = "gstools, which draws random fields"
        raise InputError(
            [Fault("gstools", "nothing that can be imported", expected, "pip install groundslab[study]")]
        ) from None
    return gstools
