"""First-order reliability of a limit state: the nearest failure in the space of standard normal scores."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.errors import GroundslabError, InputError, Issue, NotConverged
from groundslab.optional import import_optional
from groundslab.schema.wording import describe, one_of, suggestion
from groundslab.study.evaluation.samples import Input, Output, condition, read_samples, show_value
from groundslab.views.tables.table import table_of

if TYPE_CHECKING:
    from pathlib import Path

    from groundslab.arrays import Array
    from groundslab.study.definition.setup import Limit, Setup
    from groundslab.study.evaluation.statistics import Estimate
    from groundslab.study.evaluation.study import Study
    from groundslab.views.tables.table import Cell, Head, Table

#: Step of the central differences, in standard deviations: large against the noise of a solution, small against what
#: bends a limit state.
STEP = 1e-2
#: The search ends when a step moves the design point by less than this, in standard deviations.
TOLERANCE = 1e-3
#: A result is accepted if the limit state lies no farther from it, and the origin no farther from its normal, as a
#: share of the distance or of one standard deviation.
ACCEPTED = 1e-2
MAX_ITERATIONS = 40


@dataclass(frozen=True, slots=True)
class DesignPoint:
    """The most probable failure in the space of normal scores (Hasofer and Lind 1974)."""

    beta: float  # its distance from the origin; negative if the medians fail already
    probability: float  # Phi(-beta)
    scores: Array  # (d,): the normal scores there, correlated as the inputs are
    importance: Array  # (d,): shares that sum to one
    solves: int


def design_point(g: Callable[[Array], float], correlation: Array) -> DesignPoint:
    """Return the design point of a limit state g(z) < 0 over standard normal scores z (d,) with a correlation (d, d).

    beta is the distance of the nearest point with g = 0 from the origin of uncorrelated scores u, z = L u (Hasofer and
    Lind 1974), found by the iteration of Rackwitz and Fiessler 1978 with a line search. The importance of an input is
    the square of its score there over the sum of all. Raises NotConverged, and InputError where OpenTURNS is missing.
    """
    from scipy.special import ndtr

    ot = import_optional("openturns", "which finds the design point", "study")
    d = len(correlation)
    values = dict[tuple[float, ...], float]()
    raised = list[GroundslabError]()

    def raw(z: Iterable[float]) -> float:
        at = tuple(float(score) for score in z)
        # each point costs a solution of the plate
        if at not in values:
            try:
                values[at] = float(g(np.array(at)))
            except GroundslabError as error:
                # OpenTURNS replaces it by an error of its own
                raised.append(error)
                raise
        return values[at]

    def slope(z: Iterable[float]) -> Array:
        at = np.array([float(score) for score in z])
        return np.array([raw(at + step) - raw(at - step) for step in STEP * np.eye(d)]) / (2 * STEP)

    L = np.linalg.cholesky(correlation)
    # scaled to its own standard deviations, whatever its unit
    scale = float(np.linalg.norm(L.T @ slope(np.zeros(d))))
    if not 0 < scale < np.inf:
        raise GroundslabError("the limit state does not depend on any of the inputs near their medians")
    function = ot.Function(
        ot.PythonFunction(
            d, 1, func=lambda z: [raw(z) / scale], gradient=lambda z: [[float(s) / scale] for s in slope(z)]
        )
    )
    scores = ot.Normal([0.0] * d, [1.0] * d, ot.CorrelationMatrix(d, [float(entry) for entry in correlation.ravel()]))
    event = ot.ThresholdEvent(ot.CompositeRandomVector(function, ot.RandomVector(scores)), ot.Less(), 0.0)
    algorithm = ot.FORM(_search_algorithm(ot, d), event)
    try:
        algorithm.run()
    except Exception as error:
        if raised:
            raise raised[0] from None
        raise NotConverged("the search for the design point", _history(values), {}) from error
    z = np.array(algorithm.getResult().getPhysicalSpaceDesignPoint())
    u = np.linalg.solve(L, z)
    steepest = L.T @ slope(z) / scale
    if _distance_from_solution(u, raw(z) / scale, steepest) > ACCEPTED:
        raise NotConverged("the search for the design point", _history(values), {"scores": z})
    # one more step, without a solution: to the foot of the tangent plane
    size = float(np.linalg.norm(steepest))
    beta = (raw(z) / scale - float(steepest @ u)) / size
    z = L @ (-beta * steepest / size)
    importance = z**2 / float(z @ z) if z.any() else np.full(d, np.nan)
    return DesignPoint(beta, float(ndtr(-beta)), z, importance, len(values))


@dataclass(frozen=True, slots=True)
class Reliability:
    """First-order reliability of a limit state, beside the probability by the study's own sample."""

    limit: Limit
    inputs: tuple[Input, ...]  # with one value each: that at the design point, SI
    output: Output  # with one value: the bound, SI
    point: DesignPoint
    sampled: Estimate | None  # probability of failure by the sample, if it is one of chance

    @property
    def condition(self) -> str:
        """Return the limit state in words: "largest settlement at most 25 mm"."""
        return condition(self.limit, self.output)

    def __str__(self) -> str:
        """Return a summary in a few lines."""
        point, p = self.point, self.sampled
        beside = "" if p is None else f"; by sampling {p.value:.4g} ({p.low:.4g} to {p.high:.4g})"
        lines = [
            f"{self.limit.name}: {self.condition}",
            f"beta {point.beta:.4g}, probability of failure {point.probability:.4g}{beside}",
            f"design point, after {point.solves} solutions:",
        ]
        for input_, z, share in zip(self.inputs, point.scores, point.importance, strict=True):
            value = show_value(input_.values[0], input_.unit, 5)
            lines.append(f"  {input_.name} = {value}, normal score {z:+.3f}, importance {share:.1%}")
        return "\n".join(lines)


def reliability(study: Study | str | Path, limit_state: str = "") -> Reliability:
    """First-order reliability of a limit state of a study.

    Solves the case at points between the medians and the design point, in this process: about 2 d + 1 times per step
    of the search, with d variables.

    Parameters
    ----------
    study : Study or str or Path
        A study or its folder.
    limit_state : str
        Name of the limit state; may be left out if the study has only one.

    Returns
    -------
    Reliability
        Reliability index, probability of failure, design point and importance of the inputs; beside them the
        probability of failure by the study's own sample, if that is random.

    Raises
    ------
    InputError
        If the study has no such limit state, has random fields or listed values, which have no normal scores, or if
        OpenTURNS is not installed.
    NotConverged
        If no design point is found.

    References
    ----------
    Hasofer and Lind 1974; Rackwitz and Fiessler 1978.

    Examples
    --------
    >>> found = groundslab.study.reliability("slab-study", "settles too much")  # doctest: +SKIP
    >>> found.point.beta  # doctest: +SKIP
    1.72
    """
    from groundslab.study.evaluation import tables as evaluation
    from groundslab.study.evaluation.study import as_study

    study = as_study(study)
    setup = study.setup
    limit = _limit(setup, limit_state)
    point = design_point(margin_of(setup, limit), setup.correlation)
    sample = read_samples(study)
    inputs = tuple(
        Input(input_.name, input_.unit, np.array([value]))
        for input_, value in zip(sample.inputs, values_of(setup, point.scores), strict=True)
    )
    sampled = (
        evaluation.failure_probability(sample, sample.groups[0], limit)
        if sample.random and len(sample.number)
        else None
    )
    output = sample.output(limit.output)
    return Reliability(limit, inputs, Output(output.name, output.unit, np.array([limit.bound])), point, sampled)


def margin_of(setup: Setup, limit: Limit) -> Callable[[Array], float]:
    """Return the margin of a study's limit state as a function of dependent normal scores (d,).

    Each call solves the case; it raises GroundslabError where there is no result.
    """
    from groundslab.study.execution.variant import Worker
    from groundslab.study.sampling.designs import Variant

    worker = Worker(setup)
    index = [output.name for output in setup.scalar_outputs].index(limit.output)

    def margin(scores: Array) -> float:
        values = values_of(setup, scores)
        row = worker.row(Variant(0, values, ()))
        result = row.results[index]
        if result is None:
            at = ", ".join(
                f"{variable.name} = {value:g}" for variable, value in zip(setup.variables, values, strict=True)
            )
            raise GroundslabError(
                f"no result during the search for the design point, at {at}: {row.reason} {row.message}"
            )
        return float(limit.margin(result))

    return margin


def values_of(setup: Setup, scores: Array) -> tuple[float, ...]:
    """Return the values (SI) of a study's variables at dependent standard normal scores (d,): of equal probability."""
    from scipy.special import ndtr

    # the smaller of both probabilities has all its digits
    return tuple(
        float(variable.distribution.ppf(ndtr(z)) if z < 0 else variable.distribution.isf(ndtr(-z)))
        for variable, z in zip(setup.variables, scores, strict=True)
    )


def _limit(setup: Setup, name: str) -> Limit:
    """Return the limit state of a name, or the only one; raises InputError, also if the study has no scores."""
    issues = []
    if setup.fields:
        expected = "variables only: a random field is too many of them for a design point"
        issues.append(Issue("random_field", f"{len(setup.fields)} of them", expected))
    issues += [
        Issue(f"vary[{place}]", f"{variable.name}, which has listed values", "variables with distributions")
        for place, variable in enumerate(setup.variables, 1)
        if variable.distribution is None
    ]
    names = [limit.name for limit in setup.limits]
    chosen = [limit for limit in setup.limits if limit.name == name or (not name and len(names) == 1)]
    if not chosen:
        expected = one_of(names) if names else "a study with a limit state"
        issues.append(Issue("limit_state", describe(name or None), expected, suggestion(name, names)))
    if issues:
        raise InputError(issues)
    return chosen[0]


def tables(reliabilities: Sequence[Reliability]) -> tuple[Table, Table]:
    """Return the tables of first-order reliability: one row a limit state; one row an input of each."""
    rows: list[list[Cell]] = []
    points: list[list[Cell]] = []
    for result in reliabilities:
        point = result.point
        p = result.sampled
        beside = [p.value, p.low, p.high] if p is not None else [None] * 3
        rows.append([result.limit.name, result.condition, point.beta, point.probability, *beside, point.solves])
        for entry, z, share in zip(result.inputs, point.scores, point.importance, strict=True):
            points.append(
                [result.limit.name, entry.name, float(entry.values[0] * entry.unit.scale), entry.unit.name, z, share]
            )
    heads: list[Head] = [("limit state", ""), ("condition", ""), ("beta", ""), ("probability of failure", "")]
    heads += [("by sampling", ""), ("by sampling, low", ""), ("by sampling, high", ""), ("solutions", "")]
    notes = [
        "beta is the distance of the design point from the origin of uncorrelated normal scores (Hasofer and Lind "
        "1974), the probability Phi(-beta): first order, exact if the limit state is a plane there. Beside it the "
        "share of the study's variants that failed, with its interval (Wilson 1927).",
    ]
    first = table_of("reliability", "First-order reliability", heads, rows, notes)
    heads = [("limit state", ""), ("input", ""), ("at the design point", ""), ("unit", ""), ("normal score", "")]
    notes = ["The importance is the square of an input's normal score over the sum of all squares."]
    return first, table_of("design_points", "Design points", [*heads, ("importance", "")], points, notes)


def _search_algorithm(ot: Any, d: int) -> Any:
    """Return the iteration of Rackwitz and Fiessler 1978 from the medians."""
    search = ot.AbdoRackwitz()
    search.setStartingPoint([0.0] * d)
    search.setMaximumIterationNumber(MAX_ITERATIONS)
    search.setMaximumAbsoluteError(TOLERANCE)
    search.setMaximumRelativeError(TOLERANCE)
    search.setMaximumResidualError(TOLERANCE)
    search.setMaximumConstraintError(TOLERANCE)
    return search


def _distance_from_solution(u: Array, g: float, steepest: Array) -> float:
    """Return how far a point u (d,) is from being the nearest one with g = 0: along the normal, and across it.

    g and its gradient (d,) are those at u. The distance along is in standard deviations, that across a share of |u|.
    """
    size = float(np.linalg.norm(steepest))
    if not size > 0:
        return np.inf
    normal = steepest / size
    across = u - (u @ normal) * normal
    return max(abs(g) / size, float(np.linalg.norm(across)) / max(float(np.linalg.norm(u)), 1.0))


def _history(values: dict[tuple[float, ...], float]) -> list[dict[str, Any]]:
    """Return the points at which the limit state was evaluated, in their order."""
    return [{"scores": [round(score, 4) for score in at], "margin": value} for at, value in values.items()]
