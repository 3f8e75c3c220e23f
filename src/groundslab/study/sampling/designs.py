"""Designs of experiments: the values of all variants, from the seed of a study.

Normal scores: a variable's value is that of the same probability as a standard normal number's. Scores are made
dependent by the Cholesky factor of their correlations (Gaussian copula; Nataf 1962, but with the
correlations given for the scores, not for the values).
"""

from __future__ import annotations

import itertools
import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.study.definition.setup import Setup, Variable

#: Probabilities are kept this far from 0 and 1, where distributions may be infinite.
_END = 2.0**-53
#: Streams of random numbers.
_VALUES, _FIELDS = 0, 1
_MAX_SEED = 2**31
#: How far from the median the variables of a tornado go, as a probability: to the 10 % and the 90 % quantile.
SWING = 0.4


@dataclass(frozen=True, slots=True)
class Variant:
    """One variant: its number from 1, the values of the variables in their order, the seeds of the random fields."""

    number: int
    values: tuple[Any, ...]
    seeds: tuple[int, ...]


@dataclass(frozen=True, eq=False)
class VariantList:
    """All variants of a study: columns of values (n,) in SI units, one for each variable; seeds (n, f)."""

    values: tuple[list[Any], ...]
    seeds: Integers

    def __len__(self) -> int:
        """Return the number of variants."""
        return len(self.seeds)

    def __getitem__(self, number: int) -> Variant:
        """Return a variant by its number, from 1."""
        row = number - 1
        seeds = tuple(int(seed) for seed in self.seeds[row])
        return Variant(number, tuple(column[row] for column in self.values), seeds)


def list_variants(setup: Setup) -> VariantList:
    """Return all variants of a study; the same for the same study, at any time and on any machine."""
    kind, n = setup.sampling.kind, setup.count
    if kind in ("grid", "list"):
        lists = [list(variable.values or ()) for variable in setup.variables]
        if kind == "grid":
            # the last variable changes fastest
            mesh = np.indices([len(values) for values in lists]).reshape(len(lists), -1)
            lists = [[values[i] for i in indices] for values, indices in zip(lists, mesh, strict=True)]
        return VariantList(tuple(lists), _seeds(setup, n, 0))
    if kind == "saltelli":
        return _saltelli(setup)
    if kind == "tornado":
        return VariantList(_columns(setup, _one_at_a_time(len(setup.variables))), _seeds(setup, n, 0))
    return _designs(setup)


def _one_at_a_time(d: int) -> Array:
    """Return points (1 + 2 d, d) in the unit cube: the middle, then two for each variable, SWING below and above."""
    points = np.full((1 + 2 * d, d), 0.5)
    points[1::2] -= SWING * np.eye(d)
    points[2::2] += SWING * np.eye(d)
    return points


def _designs(setup: Setup) -> VariantList:
    """Return the drawn variants once for each design, always the same ones, and one design after the other.

    Of the variables that the designer chooses the last one changes first; without any there is one design.
    """
    chosen = np.array([variable.chosen for variable in setup.variables], dtype=bool)
    count = setup.sampling.count
    assert count is not None
    points = np.full((count, len(chosen)), 0.5)
    points[:, ~chosen] = unit_points(setup, int((~chosen).sum()))
    designs = list(itertools.product(*(variable.values or () for variable in setup.variables if variable.chosen)))
    picked = iter(zip(*designs, strict=True))
    values = [
        [value for value in next(picked) for _ in range(count)] if chosen[place] else column * len(designs)
        for place, column in enumerate(_columns(setup, points))
    ]
    return VariantList(tuple(values), np.tile(_seeds(setup, count, 0), (len(designs), 1)))


def unit_points(setup: Setup, dimensions: int) -> Array:
    """Return the drawn points (count, d) in the unit cube, independent of each other from column to column."""
    from scipy.stats import qmc

    kind, n = setup.sampling.kind, setup.sampling.count
    assert n is not None
    rng = np.random.default_rng(np.random.SeedSequence(setup.seed, spawn_key=(_VALUES,)))
    if dimensions == 0:
        return np.zeros((n, 0))
    if kind == "monte carlo":
        return rng.random((n, dimensions))
    if kind == "latin hypercube":
        drawn: Array = qmc.LatinHypercube(dimensions, rng=rng).random(n)
        return drawn
    with warnings.catch_warnings():
        # the sequence's balance asks for powers of 2; other counts are a little less even, and not wrong
        warnings.simplefilter("ignore", UserWarning)
        points: Array = qmc.Sobol(dimensions, scramble=True, rng=rng).random(n)
    return points


def _columns(setup: Setup, points: Array) -> tuple[list[Any], ...]:
    """Return the columns of values of independent points (n, d) in the unit cube, made dependent by normal scores."""
    from scipy.special import ndtr, ndtri

    points = np.clip(points, _END, 1 - _END)
    # without dependence the detour over the scores would only round
    if (setup.correlation != np.eye(len(setup.variables))).any():
        points = ndtr(ndtri(points) @ np.linalg.cholesky(setup.correlation).T)
    return tuple(quantiles(variable, column) for variable, column in zip(setup.variables, points.T, strict=True))


def quantiles(variable: Variable, probability: Array) -> list[Any]:
    """Return the values (n,) of a variable with the given probabilities of not being exceeded; listed ones alike."""
    probability = np.clip(probability, _END, 1 - _END)
    if variable.distribution is not None:
        values: list[Any] = variable.distribution.ppf(probability).tolist()
        return values
    assert variable.values is not None
    return [variable.values[i] for i in (probability * len(variable.values)).astype(int)]


def _seeds(setup: Setup, n: int, stream: int) -> Integers:
    """Return a seed for each random field of each variant, (n, f)."""
    rng = np.random.default_rng(np.random.SeedSequence(setup.seed, spawn_key=(_FIELDS, stream)))
    return rng.integers(0, _MAX_SEED, size=(n, len(setup.fields)))


def _saltelli(setup: Setup) -> VariantList:
    """Return Saltelli's design: A, B, then A with one variable or field after the other from B (Saltelli 2010).

    The blocks stand one after the other, each with `sampling.count` rows.
    """
    d, f, n = len(setup.variables), len(setup.fields), setup.sampling.count
    assert n is not None
    points = unit_points(setup, 2 * d)
    a, b = points[:, :d], points[:, d:]
    seeds_a, seeds_b = _seeds(setup, n, 0), _seeds(setup, n, 1)
    blocks, seeds = [a, b], [seeds_a, seeds_b]
    for i in range(d + f):
        # the inputs are the variables, then the fields
        blocks.append(np.where(np.arange(d) == i, b, a))
        seeds.append(np.where(np.arange(f) == i - d, seeds_b, seeds_a))
    return VariantList(_columns(setup, np.concatenate(blocks)), np.concatenate(seeds))
