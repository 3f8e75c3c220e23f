"""Probability distributions: as a study file describes them, and as scipy.stats knows them.

Most are given by mean and cov or std, or by their ends, not by parameters that only one library knows; parameters
follow from the moments (Johnson, Kotz and Balakrishnan 1994, Johnson, Kotz and Balakrishnan 1995).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Factors, Number, Text
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import ByKind, Table
from groundslab.schema.wording import describe, quote, suggestion
from groundslab.study.definition.field_types import Amount, Raw
from groundslab.study.definition.issues import issues_below, require_one

#: Reads an amount as a float in SI units; raises FieldError.
Read = Callable[[Raw], float]

#: Keys that hold an amount.
AMOUNTS = ("mean", "std", "low", "mode", "high")

Low = Annotated[Raw, Amount("a", "smallest value")]
High = Annotated[Raw, Amount("b", "largest value")]


class _Moments(Section):
    """A distribution by its mean and its standard deviation or coefficient of variation."""

    constraints: ClassVar[tuple[Check, ...]] = (require_one("cov", "std"),)

    kind: str
    mean: Annotated[Raw, Amount("mu", "mean")]
    cov: Annotated[float | None, Number("V", "standard deviation over the mean's size", Range(above=0))] = None
    std: Annotated[Raw | None, Amount("sigma", "standard deviation, instead of cov")] = None


class Normal(_Moments):
    """The normal distribution."""

    kind: Annotated[Literal["normal"], Table("the normal distribution")] = "normal"


class TruncatedNormal(_Moments):
    """The normal distribution between two ends."""

    kind: Annotated[
        Literal["truncated normal"],
        Table("the normal distribution cut off at one end or both; mean, cov and std are those before the cut"),
    ] = "truncated normal"
    low: Annotated[Raw | None, Amount("a", "smallest value; no end by default")] = None
    high: Annotated[Raw | None, Amount("b", "largest value; no end by default")] = None


class Lognormal(_Moments):
    """The lognormal distribution."""

    kind: Annotated[Literal["lognormal"], Table("the lognormal distribution from zero on")] = "lognormal"


class Gamma(_Moments):
    """The gamma distribution."""

    kind: Annotated[Literal["gamma"], Table("the gamma distribution from zero on")] = "gamma"


class Weibull(_Moments):
    """Weibull's distribution of smallest values."""

    kind: Annotated[Literal["weibull"], Table("Weibull's distribution of smallest values, from zero on")] = "weibull"


class Gumbel(_Moments):
    """Gumbel's distribution of largest values."""

    kind: Annotated[Literal["gumbel"], Table("Gumbel's distribution of largest values")] = "gumbel"


class Uniform(Section):
    """The uniform distribution."""

    kind: Annotated[Literal["uniform"], Table("the uniform distribution")] = "uniform"
    low: Low
    high: High


class Triangular(Section):
    """The triangular distribution."""

    kind: Annotated[Literal["triangular"], Table("the triangular distribution")] = "triangular"
    low: Low
    mode: Annotated[Raw, Amount("c", "value at the top of the triangle")]
    high: High


class Beta(_Moments):
    """The beta distribution between two ends."""

    kind: Annotated[Literal["beta"], Table("the beta distribution between two ends")] = "beta"
    low: Low
    high: High


class Scipy(Section):
    """Any continuous distribution of scipy.stats by its name and parameters."""

    kind: Annotated[Literal["scipy"], Table("any continuous distribution of scipy.stats")] = "scipy"
    name: Annotated[str, Text("its name in scipy.stats")]
    parameters: Annotated[
        tuple[tuple[str, float], ...],
        Factors("", "its parameters by their names there, loc and scale in SI units"),
    ]


AnyDistribution = Normal | TruncatedNormal | Lognormal | Gamma | Weibull | Gumbel | Uniform | Triangular | Beta | Scipy
DistributionOf = Annotated[AnyDistribution, ByKind()]


def distribution_of(part: AnyDistribution, read: Read) -> Any:
    """Return SciPy's frozen distribution of a section, its amounts in SI units read by `read`; raises FieldError."""
    from scipy import stats

    if isinstance(part, Scipy):
        return _from_scipy(part)
    amounts = _read_amounts(part, read)
    mean, low, high = (amounts.get(*amount) for amount in (("mean", 0.0), ("low", -math.inf), ("high", math.inf)))
    if not low < high:
        raise FieldError(RelativeIssue(("high",), f"{high:g}, where low is {low:g}", "more than low"))
    if isinstance(part, Uniform):
        return stats.uniform(loc=low, scale=high - low)
    if isinstance(part, Triangular):
        mode = amounts["mode"]
        if not low <= mode <= high:
            raise FieldError(RelativeIssue(("mode",), f"{mode:g}", f"a value from {low:g} to {high:g}"))
        return stats.triang(c=(mode - low) / (high - low), loc=low, scale=high - low)
    if part.cov is not None and mean == 0:
        raise FieldError(RelativeIssue(("cov",), repr(part.cov), "std, as the mean is 0"))
    std = part.cov * abs(mean) if part.cov is not None else amounts["std"]
    if not std > 0:
        raise FieldError(RelativeIssue(("std",), f"{std:g}", "more than 0"))
    if isinstance(part, Normal):
        return stats.norm(loc=mean, scale=std)
    if isinstance(part, TruncatedNormal):
        return stats.truncnorm(a=(low - mean) / std, b=(high - mean) / std, loc=mean, scale=std)
    if isinstance(part, Gumbel):
        scale = std * math.sqrt(6) / math.pi
        return stats.gumbel_r(loc=mean - np.euler_gamma * scale, scale=scale)
    if isinstance(part, Beta):
        return _beta(mean, std, low, high)
    if not mean > 0:
        raise FieldError(RelativeIssue(("mean",), f"{mean:g}", f"more than 0, as kind is {quote(part.kind)}"))
    return _positive(part, mean, std / mean)


def _read_amounts(part: AnyDistribution, read: Read) -> dict[str, float]:
    """Return all amounts of a section that are given, by their names, in SI units."""
    amounts: dict[str, float] = {}
    issues: list[RelativeIssue] = []
    for name in AMOUNTS:
        if (raw := getattr(part, name, None)) is not None:
            with issues_below(name, collected=issues):
                amounts[name] = read(raw)
    if issues:
        raise FieldError(*issues)
    return amounts


def _beta(mean: float, std: float, low: float, high: float) -> Any:
    """Return the beta distribution with given moments on (low, high) (Johnson, Kotz and Balakrishnan 1995, 25)."""
    from scipy import stats

    if not low < mean < high:
        raise FieldError(RelativeIssue(("mean",), f"{mean:g}", f"a value between {low:g} and {high:g}"))
    m, v = (mean - low) / (high - low), (std / (high - low)) ** 2
    if v >= m * (1 - m):
        most = math.sqrt(m * (1 - m)) * (high - low)
        raise FieldError(
            RelativeIssue((), f"a standard deviation of {std:g}", f"less than {most:g} with this mean and ends")
        )
    nu = m * (1 - m) / v - 1
    return stats.beta(a=m * nu, b=(1 - m) * nu, loc=low, scale=high - low)


def _positive(part: AnyDistribution, mean: float, cov: float) -> Any:
    """Return a distribution on the positive numbers by its mean and its coefficient of variation."""
    from scipy import stats

    if isinstance(part, Lognormal):
        variance = math.log1p(cov**2)
        return stats.lognorm(s=math.sqrt(variance), scale=mean * math.exp(-variance / 2))
    if isinstance(part, Gamma):
        return stats.gamma(a=cov**-2, scale=mean * cov**2)
    shape = _weibull_shape(cov)
    return stats.weibull_min(c=shape, scale=mean / math.gamma(1 + 1 / shape))


def _weibull_shape(cov: float) -> float:
    """Return c with 1 + cov^2 = Gamma(1 + 2/c) / Gamma(1 + 1/c)^2 (Johnson, Kotz and Balakrishnan 1994, 21)."""
    from scipy import optimize

    def off(log_c: float) -> float:
        c = math.exp(log_c)
        return math.lgamma(1 + 2 / c) - 2 * math.lgamma(1 + 1 / c) - math.log1p(cov**2)

    # the left side falls with c from far above any cov of soil or load to almost none
    low, high = math.log(0.05), math.log(1e4)
    if off(low) < 0 or off(high) > 0:
        raise FieldError(
            RelativeIssue((), f"a cov of {cov:g}", "one between 0.0002 and 1000 for Weibull's distribution")
        )
    return math.exp(float(optimize.brentq(off, low, high, xtol=1e-14)))


def _from_scipy(part: Scipy) -> Any:
    """Return a distribution of scipy.stats by its own name and parameters."""
    from scipy import stats

    continuous = [name for name in dir(stats) if isinstance(getattr(stats, name), stats.rv_continuous)]
    if part.name not in continuous:
        expected = "a continuous distribution of scipy.stats"
        raise FieldError(RelativeIssue(("name",), describe(part.name), expected, suggestion(part.name, continuous)))
    family = getattr(stats, part.name)
    shapes = family.shapes
    names = [*(shapes.split(", ") if shapes else []), "loc", "scale"]
    for name, _ in part.parameters:
        if name not in names:
            expected = f"one of {', '.join(names)}"
            raise FieldError(
                RelativeIssue(("parameters", name), "an unknown parameter", expected, suggestion(name, names))
            )
    missing = [name for name in names[:-2] if name not in dict(part.parameters)]
    if missing:
        raise FieldError(RelativeIssue(("parameters",), f"none called {missing[0]}", f"all of {', '.join(names[:-2])}"))
    distribution = family(**dict(part.parameters))
    if not math.isfinite(float(distribution.ppf(0.5))):
        raise FieldError(
            RelativeIssue(("parameters",), "parameters outside their range", "those that scipy.stats takes")
        )
    return distribution
