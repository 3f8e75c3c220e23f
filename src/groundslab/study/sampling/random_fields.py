"""Random fields over the plan: factors with a given distribution at each place and a given correlation length.

A Gaussian field with mean 0 and variance 1 is drawn by the randomization method (Kraichnan 1970), as a sum of waves
that is a function of the place alone: the same field on every mesh. At each place it is mapped to the given
distribution, value for value of the same probability (a translation field, Grigoriu 1998).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.optional import import_optional

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.study.definition.setup import Field

#: Waves of a field. Their number affects how well one field has the correlation, not the distribution at a place.
WAVES = 1000


def scores(field: Field, seed: int) -> Callable[[Array, Array], Array]:
    """Return a Gaussian field with mean 0 and variance 1, a function of x (n,) and y (n,) [m]."""
    field_of_seed = import_gstools().SRF(correlation_model(field), seed=seed, mode_no=WAVES)
    return lambda x, y: field_of_seed((np.asarray(x, dtype=float), np.asarray(y, dtype=float)), store=False)


def correlation_model(field: Field) -> Any:
    """Return the library's model of a field's correlation, with the lengths of the study file.

    With r the distance over the correlation length: exp(-r^2), exp(-r), or (1 + sqrt(3) r) exp(-sqrt(3) r), that of
    Matern with nu = 3/2.
    """
    return _correlation_model(field.model, tuple(field.lengths))


@lru_cache(maxsize=8)
def _correlation_model(name: str, lengths: tuple[float, ...]) -> Any:
    """Return the library's model of that name; making it takes longer than to draw a field by it."""
    gstools = import_gstools()
    if name == "matern32":
        return _matern32(gstools)(dim=2, var=1.0, len_scale=list(lengths))
    make = gstools.Gaussian if name == "gaussian" else gstools.Exponential
    # the library scales lengths otherwise
    return make(dim=2, var=1.0, len_scale=list(lengths), rescale=1.0)


def _matern32(gstools: Any) -> Any:
    """Return the model of correlation (1 + sqrt(3) r) exp(-sqrt(3) r) with its spectrum in closed form.

    The library's own Matern has none for the plane and draws wave numbers by a Markov chain, which takes a hundred
    times as long. The spectral density is that of Matern 1960, proportional to (3 + k^2)^(-5/2) in the plane; the part
    of its waves that is shorter than k is its integral over a circle.
    """
    root = math.sqrt(3)

    class Matern32(gstools.CovModel):  # type: ignore[misc]
        def cor(self, h: Array) -> Array:
            return (1 + root * h) * np.exp(-root * h)

        def spectral_rad_cdf(self, k: Array) -> Array:
            probability: Array = 1 - (1 + (k * self.len_rescaled) ** 2 / 3) ** -1.5
            return probability

        def spectral_rad_ppf(self, u: Array) -> Array:
            wave_number: Array = root / self.len_rescaled * np.sqrt((1 - u) ** (-2 / 3) - 1)
            return wave_number

    return Matern32


def factors(field: Field, seed: int) -> Callable[[Array, Array], Array]:
    """Return the field's factors, a function of x (n,) and y (n,) [m]."""
    from scipy.special import ndtr

    gaussian = scores(field, seed)
    return lambda x, y: field.distribution.ppf(ndtr(gaussian(x, y)))


def import_gstools() -> Any:
    """Return the library of random fields; raises InputError where it is not installed."""
    return import_optional("gstools", "which draws random fields", "study")
