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

from groundslab.errors import InputError, Issue

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.study.definition.setup import Field

#: Waves of which a field is made. Their number matters for how well one field keeps the correlation, not for the
#: distribution at a place.
WAVES = 1000


def scores(field: Field, seed: int) -> Callable[[Array, Array], Array]:
    """Return a Gaussian field with mean 0 and variance 1, a function of x (n,) and y (n,) [m]."""
    drawn = generators().SRF(waves(field), seed=seed, mode_no=WAVES)

    def at(x: Array, y: Array) -> Array:
        found: Array = drawn((np.asarray(x, dtype=float), np.asarray(y, dtype=float)), store=False)
        return found

    return at


def waves(field: Field) -> Any:
    """Return the library's model of a field's correlation, its lengths as `description` tells them.

    With r the distance over the correlation length: exp(-r^2), exp(-r), or (1 + sqrt(3) r) exp(-sqrt(3) r), that of
    Matern with nu = 3/2.
    """
    gstools = generators()
    lengths = list(field.lengths)
    if field.model == "matern32":
        return _matern32(gstools)(dim=2, var=1.0, len_scale=lengths)
    make = gstools.Gaussian if field.model == "gaussian" else gstools.Exponential
    # the library scales lengths otherwise
    return make(dim=2, var=1.0, len_scale=lengths, rescale=1.0)


def _matern32(gstools: Any) -> Any:
    """Return the model of correlation (1 + sqrt(3) r) exp(-sqrt(3) r) with its spectrum in closed form.

    The library's own Matern knows none for the plane and draws wave numbers by a Markov chain, which takes a hundred
    times as long. The spectral density is that of Matern 1960, proportional to (3 + k^2)^(-5/2) in the plane; the part
    of its waves that is shorter than k is its integral over a circle.
    """
    root = math.sqrt(3)

    class Matern32(gstools.CovModel):  # type: ignore[misc]
        def cor(self, h: Array) -> Array:
            return (1 + root * h) * np.exp(-root * h)

        def spectral_rad_cdf(self, k: Array) -> Array:
            found: Array = 1 - (1 + (k * self.len_rescaled) ** 2 / 3) ** -1.5
            return found

        def spectral_rad_ppf(self, u: Array) -> Array:
            found: Array = root / self.len_rescaled * np.sqrt((1 - u) ** (-2 / 3) - 1)
            return found

    return Matern32


def factors(field: Field, seed: int) -> Callable[[Array, Array], Array]:
    """Return the field's factors, a function of x (n,) and y (n,) [m]."""
    drawn = scores(field, seed)

    def at(x: Array, y: Array) -> Array:
        from scipy.special import ndtr

        return field.distribution.at(ndtr(drawn(x, y)))

    return at


def generators() -> Any:
    """Return the library of random fields; raises InputError where it is not installed."""
    try:
        import gstools
    except ImportError:
        expected = "gstools, which draws random fields"
        raise InputError(
            [Issue("gstools", "nothing that can be imported", expected, "pip install groundslab[study]")]
        ) from None
    return gstools
