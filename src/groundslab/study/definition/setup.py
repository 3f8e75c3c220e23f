"""A study with its case: paths looked up, units read, distributions made; all faults at once."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from groundslab.arrays import Array
from groundslab.errors import InputError
from groundslab.model.combinations import combinations_of
from groundslab.model.loads.placement import on_plate
from groundslab.model.model import Model
from groundslab.model.outputs import OutputPoint
from groundslab.schema.fields import FieldType, Number, Quantity
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.wording import describe, one_of, suggestion
from groundslab.study.definition.case_paths import Place, place_of, value_at
from groundslab.study.definition.distributions import AnyDistribution, Distribution, distribution_of
from groundslab.study.definition.field_types import Raw
from groundslab.study.definition.outputs import FIELDS, FIGURES, Output
from groundslab.study.definition.schema import (
    Correlation,
    Keep,
    LimitState,
    RandomField,
    Sampling,
    StudyFile,
    Vary,
    name_of_field,
    name_of_keep,
)

#: Nobody waits for more; a typing error would fill the disk.
MOST_VARIANTS = 10_000_000

#: Fewer values outside a key's range are not worth a word.
MOST_OUTSIDE = 0.5

#: The constants of the ground that a random field can multiply, by the kind of ground.
_OF_GROUND = {
    "winkler": ("ground.k",),
    "pasternak": ("ground.k0", "ground.k1"),
    "vlasov": ("ground.layers[1].E", "..."),
    "layered": ("ground.layers[1].E", "ground.layers[1].k0", "..."),
}


@dataclass(frozen=True, slots=True)
class Variable:
    """A quantity of the case that varies: its values, or their distribution, in SI units.

    With `times` these are factors, and `base` is what they multiply.
    """

    name: str
    place: Place
    values: tuple[Any, ...] | None
    distribution: Distribution | None
    times: bool
    chosen: bool  # by the designer, out of the values; not drawn
    base: Any  # in the case; None if nothing is given there

    @property
    def path(self) -> str:
        """Return the path in the case."""
        return self.place.path

    @property
    def unit(self) -> str:
        """Return the SI unit of what is varied, empty where it has none; factors have none."""
        from groundslab.units import DIMENSIONS

        key = self.place.key
        return DIMENSIONS[key.dimension].si if isinstance(key, Quantity) and not self.times else ""

    @property
    def outside(self) -> float:
        """Return the probability of a value outside the key's range, with which the variant fails."""
        limits = getattr(self.place.key, "range", None)
        if self.distribution is None or limits is None:
            return 0.0
        cdf = self.distribution.frozen().cdf
        low, high = (
            next((each for each in ends if each is not None), None)
            for ends in ((limits.above, limits.at_least), (limits.below, limits.at_most))
        )
        if self.times and self.base == 0:
            return 0.0
        if self.times:
            low, high = (None if end is None else end / self.base for end in (low, high))
            # a negative number turns the range around
            if self.base < 0:
                low, high = high, low
        return (0.0 if low is None else float(cdf(low))) + (0.0 if high is None else float(1 - cdf(high)))

    def put(self, value: Any) -> Any:
        """Return what stands in the case for a value of the variable."""
        return value * self.base if self.times else value


@dataclass(frozen=True, slots=True)
class Field:
    """A random field: a factor over the plan on a constant of the ground."""

    name: str
    path: str
    distribution: Distribution
    lengths: tuple[float, float]  # [m]
    model: str


@dataclass(frozen=True, slots=True)
class Limit:
    """A limit state: the kept result that it is about, and where fine ends, in SI units."""

    name: str
    keep: str
    value: float
    at_most: bool  # else at least
    target: float | None  # probability of failure aimed at

    def margin(self, result: float) -> float:
        """Return how far a result is on the safe side, negative beyond the limit."""
        return self.value - result if self.at_most else result - self.value


@dataclass(frozen=True, eq=False)
class Setup:
    """All that a study's variants have in common."""

    title: str
    model: Model
    seed: int
    sampling: Sampling
    variables: tuple[Variable, ...]
    correlation: Array  # (d, d), of the normal scores
    fields: tuple[Field, ...]
    outputs: tuple[Output, ...]
    limits: tuple[Limit, ...]

    @property
    def count(self) -> int:
        """Return the number of variants."""
        lengths = [len(variable.values) for variable in self.variables if variable.values is not None]
        if self.sampling.kind == "grid":
            return int(np.prod([float(n) for n in lengths]))
        if self.sampling.kind == "list":
            return lengths[0] if lengths else 1
        if self.sampling.kind == "tornado":
            return 1 + 2 * len(self.variables)
        assert self.sampling.count is not None
        designs = math.prod(len(each.values) for each in self.variables if each.chosen and each.values is not None)
        blocks = len(self.variables) + len(self.fields) + 2 if self.sampling.kind == "saltelli" else 1
        return self.sampling.count * blocks * designs


def setup_of(file: StudyFile, model: Model, from_file: bool = True) -> Setup:
    """Return a study with its case; raises InputError with all faults. Without `from_file` numbers are in SI units."""
    relative_issues: list[RelativeIssue] = []

    def tried(make: Any, place: tuple[str | int, ...]) -> Any:
        try:
            return make()
        except FieldError as error:
            relative_issues.extend(relative.below(place) for relative in error.relative_issues)
            return None

    variables = [
        tried(lambda each=each: _variable(each, model, from_file), ("vary", n)) for n, each in enumerate(file.vary)
    ]
    seen: dict[tuple[str | int, ...], str] = {}
    for position, variable in enumerate(variables):
        if variable is not None:
            if variable.place.steps in seen:
                expected = "a key that no other variable has"
                relative_issues.append(RelativeIssue(("vary", position, "path"), describe(variable.path), expected))
            seen[variable.place.steps] = variable.name
    fields = [
        tried(lambda each=each: _field(each, model), ("random_field", n)) for n, each in enumerate(file.random_field)
    ]
    outputs = [tried(lambda each=each: _output(each, model), ("keep", n)) for n, each in enumerate(file.keep)]
    limits = [
        tried(lambda each=each: _limit(each, outputs, from_file), ("limit_state", n))
        for n, each in enumerate(file.limit_state)
    ]
    names = [each.name or each.path for each in file.vary]
    correlation = tried(lambda: _correlation(names, file.correlation), ("correlation",))
    if not relative_issues:
        setup = Setup(
            file.title, model, file.seed, file.sampling, tuple(variables), correlation, tuple(fields), tuple(outputs),
            tuple(limits),
        )  # fmt: skip
        if setup.count <= MOST_VARIANTS:
            return setup
        relative_issues.append(
            RelativeIssue(("sampling",), f"{setup.count:.3g} variants", f"at most {MOST_VARIANTS:,}")
        )
    raise InputError([relative.issue(StudyFile.root()) for relative in relative_issues])


def _variable(vary: Vary, model: Model, from_file: bool) -> Variable:
    """Return a variable; raises Wrong."""
    try:
        place = place_of(model, vary.path)
    except FieldError as error:
        raise FieldError(*(relative.below(("path",)) for relative in error.relative_issues)) from None
    base = value_at(model, place)
    continuous = isinstance(place.key, Quantity | Number)
    if vary.times and not (continuous and isinstance(base, float)):
        expected = "a key that holds a number in the case"
        raise FieldError(RelativeIssue(("times",), f"{vary.path}, which is {describe(base)}", expected))
    if vary.distribution is not None and not continuous:
        raise FieldError(RelativeIssue(("distribution",), "a distribution", "values, as the key takes no real numbers"))
    key: FieldType = Number("", "factor") if vary.times else place.key
    distribution = None if vary.distribution is None else _distribution(vary.distribution, key, from_file)
    values: list[Any] | None = None if vary.values is None else []
    relative_issues: list[RelativeIssue] = []
    for position, raw in enumerate(vary.values or ()):
        assert values is not None
        try:
            values.append(key.read(raw, from_file))
        except FieldError as error:
            relative_issues += [relative.below(("values", position)) for relative in error.relative_issues]
    if relative_issues:
        raise FieldError(*relative_issues)
    name = vary.name or vary.path
    kept = None if values is None else tuple(values)
    return Variable(name, place, kept, distribution, vary.times, vary.choose, base)


def _distribution(part: AnyDistribution, key: FieldType, from_file: bool) -> Distribution:
    """Return a distribution of values of a key; raises Wrong. Its ends need not lie in the key's range."""
    key = Quantity(key.dimension, key.symbol, key.meaning) if isinstance(key, Quantity) else Number("", "")

    def read(raw: Raw) -> float:
        return float(key.read(raw, from_file))

    try:
        return distribution_of(part, read)
    except FieldError as error:
        raise FieldError(*(relative.below(("distribution",)) for relative in error.relative_issues)) from None


def _field(field: RandomField, model: Model) -> Field:
    """Return a random field; raises Wrong."""
    expected = f"a constant of the ground such as {_OF_GROUND[model.ground.kind][0]}"
    try:
        place = place_of(model, field.path)
    except FieldError as error:
        raise FieldError(*(relative.below(("path",)) for relative in error.relative_issues)) from None
    last = place.steps[-1]
    if place.steps[0] != "ground" or last not in ("k", "k0", "k1", "E") or "selvadurai" in place.steps:
        raise FieldError(RelativeIssue(("path",), describe(field.path), expected))
    if value_at(model, place) is None:
        raise FieldError(RelativeIssue(("path",), f"{field.path}, which the case does not give", expected))
    distribution = _distribution(field.distribution, Number("", ""), from_file=False)
    return Field(name_of_field(field), field.path, distribution, field.correlation_length, field.model)


def _output(keep: Keep, model: Model) -> Output:
    """Return what is kept; raises Wrong."""
    of = keep.of.replace("_", " ")
    relative_issues = list(_output_fits(keep, of, model))
    if relative_issues:
        raise FieldError(*relative_issues)
    return Output(name_of_keep(keep), of, keep.take, keep.x, keep.y, keep.combination, keep.support, keep.layer)


def _output_fits(keep: Keep, of: str, model: Model) -> Iterator[RelativeIssue]:
    """Find what speaks against keeping a result."""
    if of not in FIELDS and of not in FIGURES:
        known = [*FIELDS, *FIGURES]
        yield RelativeIssue(
            ("of",), describe(keep.of), "a field or a figure", suggestion(of, known) or f"among {one_of(known)}"
        )
        return
    if of in FIELDS and keep.take is None:
        yield RelativeIssue(("take",), "nothing", "what to take of a field", "figures of the whole need none")
    if of in FIGURES and keep.take is not None:
        yield RelativeIssue(("take",), describe(keep.take), f"nothing, as {of} is one figure")
    if keep.take == "at" and None in (keep.x, keep.y):
        yield RelativeIssue(("take",), '"at"', "x and y that say where")
    if keep.take != "at" and (keep.x is not None or keep.y is not None):
        yield RelativeIssue(("x" if keep.x is not None else "y",), "a place", 'none, as take is not "at"')
    if keep.x is not None and keep.y is not None:
        yield from on_plate(model.plate, OutputPoint(name="", x=keep.x, y=keep.y), ())
    combinations = [each.name for each in combinations_of(model)]
    if keep.combination and keep.combination not in combinations:
        hint = suggestion(keep.combination, combinations)
        yield RelativeIssue(("combination",), describe(keep.combination), one_of(combinations), hint)
    supports = [support.name for support in model.supports if support.name]
    if of == "support force" and keep.support not in supports:
        expected = one_of(supports) if supports else "a case with a support that has a name"
        yield RelativeIssue(("support",), describe(keep.support or None), expected, suggestion(keep.support, supports))
    if of != "support force" and keep.support:
        yield RelativeIssue(("support",), describe(keep.support), 'none, as of is not "support force"')
    if of not in ("k0", "k1") and keep.layer is not None:
        yield RelativeIssue(("layer",), str(keep.layer), "none, as of is neither k0 nor k1")
    if of.startswith("reinforcement"):
        ultimate = [each.name for each in combinations_of(model) if each.limit_state == "ultimate"]
        if model.reinforcement is None:
            yield RelativeIssue(("of",), describe(keep.of), "a case with [reinforcement]")
        elif keep.combination in combinations and keep.combination not in ultimate:
            found = f"{describe(keep.combination)}, which is not for the ultimate limit state"
            yield RelativeIssue(("combination",), found, one_of(ultimate))


def _limit(limit: LimitState, outputs: list[Output | None], from_file: bool) -> Limit | None:
    """Return a limit state, None if what it is about is wrong already; raises Wrong."""
    output = next((each for each in outputs if each is not None and each.name == limit.keep), None)
    if output is None:
        return None
    key: FieldType = Quantity(output.dimension, "", "") if output.dimension else Number("", "")
    name, raw = ("at_most", limit.at_most) if limit.at_most is not None else ("at_least", limit.at_least)
    try:
        value = key.read(raw, from_file)
    except FieldError as error:
        raise FieldError(*(relative.below((name,)) for relative in error.relative_issues)) from None
    return Limit(limit.name, limit.keep, float(value), name == "at_most", limit.target)


def _correlation(names: list[str], correlation: tuple[Correlation, ...]) -> Array:
    """Return the matrix of correlations (d, d); raises Wrong if there are no variables that are correlated so."""
    found = np.eye(len(names))
    for each in correlation:
        positions = [names.index(name) for name in each.between]
        for a in positions:
            for b in positions:
                if a != b:
                    found[a, b] = each.rho
    least = float(np.linalg.eigvalsh(found).min()) if names else 1.0
    if least < 1e-10:
        given = f"correlations that cannot hold together (least eigenvalue {least:.2g})"
        raise FieldError(RelativeIssue((), given, "a positive definite matrix of them", "smaller correlations"))
    return found


def warnings_of(setup: Setup) -> list[str]:
    """Return what a reader should know before a study is run, a line each."""
    found = []
    for variable in setup.variables:
        share = variable.outside
        if share * setup.count > MOST_OUTSIDE:
            words = variable.place.key.range_words()
            found.append(
                f"{variable.name}: about {share * setup.count:.2g} of {setup.count} values will lie outside the range "
                f"of {variable.path} ({words}); these variants will fail"
            )
    return found


def columns_of(setup: Setup) -> Mapping[str, str]:
    """Return the SI unit of each column of inputs and outputs, in the order of the table; empty where there is none."""
    units = {variable.name: variable.unit for variable in setup.variables}
    units |= {field.name: "" for field in setup.fields}
    return units | {output.name: output.unit for output in setup.outputs}
