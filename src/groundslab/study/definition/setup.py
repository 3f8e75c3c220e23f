"""Resolves a study file against its case: paths, units, distributions; all issues at once."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, TypeVar

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.errors import InputError
from groundslab.model.combinations import list_combinations
from groundslab.model.ground import ContinuousGround, Continuum
from groundslab.model.loads.placement import on_plate
from groundslab.model.model import Model
from groundslab.model.outputs import OutputPoint
from groundslab.model.plates.region import PlateRegion
from groundslab.schema.fields import FieldType, ListOf, Number, Quantity
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.wording import describe, one_of, quote, suggestion
from groundslab.study.definition import schema
from groundslab.study.definition.case_paths import Place, place_of
from groundslab.study.definition.distributions import AnyDistribution, distribution_of
from groundslab.study.definition.field_types import Raw
from groundslab.study.definition.issues import issues_below
from groundslab.study.definition.outputs import CONSTANTS, FIELDS, SCALARS, SOIL, RequestedOutput

T = TypeVar("T")

#: More would take years; a typographical error would fill the disk.
MAX_VARIANTS = 10_000_000

#: Expected number of values outside a key's range above which a study warns.
MAX_OUTSIDE = 0.5

#: A constant of the ground that a random field can multiply, by the kind of ground.
_GROUND_CONSTANTS = {"winkler": "ground.k", "pasternak": "ground.k0"} | dict.fromkeys(
    ("vlasov", "layered"), "ground.layers[1].E"
)


@dataclass(frozen=True, slots=True)
class Variable:
    """A quantity of the case that varies: its values, or their distribution, in SI units.

    With `times` these are factors on the value in the case.
    """

    name: str
    place: Place
    values: tuple[Any, ...] | None
    distribution: Any  # one of scipy.stats, frozen; None for listed values
    times: bool
    chosen: bool  # by the designer, out of the values; not drawn

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
        ends = [
            next((end for end in pair if end is not None), missing)
            for pair, missing in (((limits.above, limits.at_least), -np.inf), ((limits.below, limits.at_most), np.inf))
        ]
        if self.times:
            if self.place.value == 0:
                return 0.0
            # a negative number turns the range around
            ends = sorted(end / self.place.value for end in ends)
        low, high = self.distribution.cdf(ends)
        return float(low + (1 - high))

    def value_in_case(self, value: Any) -> Any:
        """Return the value in the case for a value of the variable."""
        return value * self.place.value if self.times else value


@dataclass(frozen=True, slots=True)
class Field:
    """A random field: a factor over the plan on a constant of the ground."""

    name: str
    path: str
    distribution: Any  # one of scipy.stats, frozen
    lengths: tuple[float, float]  # [m]
    model: str


@dataclass(frozen=True, slots=True)
class Limit:
    """A limit state: an output that must be at most, or at least, a bound (SI); the target probability, if any."""

    name: str
    output: str
    sense: Literal["at most", "at least"]
    bound: float
    target: float | None = None

    def margin(self, value: Any) -> Any:
        """Return how far values are on the safe side, negative where they fail."""
        return self.bound - value if self.sense == "at most" else value - self.bound

    def fails(self, values: Array) -> Flags:
        """Return which values (n,) are beyond the bound; a missing one is not."""
        failed: Flags = self.margin(values) < 0
        return failed


@dataclass(frozen=True, eq=False)
class Setup:
    """What all variants of a study have in common."""

    title: str
    model: Model
    seed: int
    sampling: schema.Sampling
    variables: tuple[Variable, ...]
    correlation: Array  # (d, d), of the normal scores
    fields: tuple[Field, ...]
    outputs: tuple[RequestedOutput, ...]
    limits: tuple[Limit, ...]

    @property
    def scalar_outputs(self) -> tuple[RequestedOutput, ...]:
        """Return the outputs that are one number."""
        return tuple(output for output in self.outputs if not output.everywhere)

    @property
    def nodal_outputs(self) -> tuple[RequestedOutput, ...]:
        """Return the outputs that are a value at each node."""
        return tuple(output for output in self.outputs if output.everywhere)

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
        designs = math.prod(
            len(variable.values) for variable in self.variables if variable.chosen and variable.values is not None
        )
        blocks = len(self.variables) + len(self.fields) + 2 if self.sampling.kind == "saltelli" else 1
        return self.sampling.count * blocks * designs


def setup_of(file: schema.StudyFile, model: Model, from_file: bool = True) -> Setup:
    """Return a study with its case; raises InputError with all issues. Without `from_file` numbers are in SI units."""
    issues: list[RelativeIssue] = []

    def resolve_each(key: str, parts: Sequence[Any], resolve: Callable[..., T], *context: Any) -> list[T | None]:
        """Resolve the parts below a key; None where one has issues."""
        resolved: list[T | None] = [None] * len(parts)
        for position, part in enumerate(parts):
            with issues_below(key, position, collected=issues):
                resolved[position] = resolve(part, *context)
        return resolved

    variables = resolve_each("vary", file.vary, _variable, model, from_file)
    paths: set[tuple[str | int, ...]] = set()
    for position, variable in enumerate(variables):
        if variable is not None:
            if variable.place.steps in paths:
                place = ("vary", position, "path")
                issues.append(RelativeIssue(place, describe(variable.path), "a key that no other variable has"))
            paths.add(variable.place.steps)
    fields = resolve_each("random_field", file.random_field, _field, model)
    outputs = resolve_each("keep", file.keep, _output, model)
    limits = resolve_each("limit_state", file.limit_state, _limit, outputs, from_file)
    correlation = np.eye(len(file.vary))
    with issues_below("correlation", collected=issues):
        correlation = _correlation([quantity.column for quantity in file.vary], file.correlation)
    if not issues:
        setup = Setup(
            file.title, model, file.seed, file.sampling, _all(variables), correlation, _all(fields), _all(outputs),
            _all(limits),
        )  # fmt: skip
        if setup.count <= MAX_VARIANTS:
            return setup
        issues.append(RelativeIssue(("sampling",), f"{setup.count:.3g} variants", f"at most {MAX_VARIANTS:,}"))
    raise InputError([issue.issue(schema.StudyFile.root()) for issue in issues])


def _all(parts: Sequence[T | None]) -> tuple[T, ...]:
    return tuple(part for part in parts if part is not None)


def _variable(vary: schema.VariedQuantity, model: Model, from_file: bool) -> Variable:
    """Return a variable; raises FieldError."""
    with issues_below("path"):
        place = place_of(model, vary.path)
    continuous = isinstance(place.key, Quantity | Number)
    if vary.times and not (continuous and isinstance(place.value, float)):
        expected = "a key that holds a number in the case"
        raise FieldError(RelativeIssue(("times",), f"{vary.path}, which is {describe(place.value)}", expected))
    if vary.distribution is not None and not continuous:
        raise FieldError(RelativeIssue(("distribution",), "a distribution", "values, as the key takes no real numbers"))
    key: FieldType = Number("", "factor") if vary.times else place.key
    distribution = None if vary.distribution is None else _distribution(vary.distribution, key, from_file)
    with issues_below("values"):
        values = None if vary.values is None else ListOf(key, "", "").read(vary.values, from_file)
    return Variable(vary.column, place, values, distribution, vary.times, vary.choose)


def _distribution(part: AnyDistribution, key: FieldType, from_file: bool) -> Any:
    """Return a distribution of values of a key; raises FieldError. Its ends need not lie in the key's range."""
    key = Quantity(key.dimension, key.symbol, key.meaning) if isinstance(key, Quantity) else Number("", "")

    def read(raw: Raw) -> float:
        return float(key.read(raw, from_file))

    with issues_below("distribution"):
        return distribution_of(part, read)


def _field(field: schema.RandomField, model: Model) -> Field:
    """Return a random field; raises FieldError."""
    if isinstance(model.ground, ContinuousGround):
        found = f"a random field on {quote(model.ground.kind)} ground, whose layers are the same everywhere"
        hint = "vary its moduli under [[vary]], or let them vary over the plan on vlasov or layered ground"
        raise FieldError(RelativeIssue(("path",), found, "ground of columns, each with its own constants", hint))
    expected = f"a constant of the ground such as {_GROUND_CONSTANTS[model.ground.kind]}"
    with issues_below("path"):
        place = place_of(model, field.path)
    last = place.steps[-1]
    if place.steps[0] != "ground" or last not in ("k", "k0", "k1", "E") or "selvadurai" in place.steps:
        raise FieldError(RelativeIssue(("path",), describe(field.path), expected))
    if place.value is None:
        raise FieldError(RelativeIssue(("path",), f"{field.path}, which the case does not give", expected))
    distribution = _distribution(field.distribution, Number("", ""), from_file=False)
    return Field(field.column, field.path, distribution, field.correlation_length, field.model)


def _output(keep: RequestedOutput, model: Model) -> RequestedOutput:
    """Return an output with its name; raises FieldError."""
    of = keep.of.replace("_", " ")
    issues = list(_output_issues(keep, of, model))
    if issues:
        raise FieldError(*issues)
    return keep.replace(name=keep.column, of=of)


def _output_issues(keep: RequestedOutput, of: str, model: Model) -> Iterator[RelativeIssue]:
    """Find why a result cannot be kept."""
    if of not in FIELDS and of not in SCALARS:
        names = [*FIELDS, *SCALARS]
        hint = suggestion(of, names) or f"among {one_of(names)}"
        yield RelativeIssue(("of",), describe(keep.of), "a field or a figure", hint)
        return
    if of in FIELDS and keep.take is None:
        yield RelativeIssue(("take",), "nothing", "what to take of a field", "figures of the whole plate need none")
    if of in SCALARS and keep.take is not None:
        yield RelativeIssue(("take",), describe(keep.take), f"nothing, as {of} is one figure")
    if keep.take == "at" and None in (keep.x, keep.y):
        yield RelativeIssue(("take",), '"at"', "x and y that say where")
    if of in SOIL:
        yield from _soil_issues(keep, of, model)
        return
    if keep.z is not None:
        yield RelativeIssue(("z",), "a depth", f"none, as of is not {one_of(SOIL)}")
    if of in CONSTANTS and isinstance(model.ground, ContinuousGround):
        found = f"{of} of {quote(model.ground.kind)} ground"
        yield RelativeIssue(("of",), found, "a figure that the ground of the case has")
    if keep.take != "at" and (keep.x is not None or keep.y is not None):
        yield RelativeIssue(("x" if keep.x is not None else "y",), "a place", 'none, as take is not "at"')
    if keep.x is not None and keep.y is not None:
        yield from on_plate(PlateRegion(model.plate, model.plates), OutputPoint(name="", x=keep.x, y=keep.y), ())
    supports = [support.name for support in model.supports if support.name]
    if of == "support force" and keep.support not in supports:
        expected = one_of(supports) if supports else "a case with a support that has a name"
        yield RelativeIssue(("support",), describe(keep.support or None), expected, suggestion(keep.support, supports))
    if of != "support force" and keep.support:
        yield RelativeIssue(("support",), describe(keep.support), 'none, as of is not "support force"')
    if of not in ("k0", "k1") and keep.layer is not None:
        yield RelativeIssue(("layer",), str(keep.layer), "none, as of is neither k0 nor k1")
    combinations = {combination.name: combination.limit_state for combination in list_combinations(model)}
    if keep.combination and keep.combination not in combinations:
        hint = suggestion(keep.combination, combinations)
        yield RelativeIssue(("combination",), describe(keep.combination), one_of(list(combinations)), hint)
    if of.startswith("reinforcement") and model.reinforcement is None:
        yield RelativeIssue(("of",), describe(keep.of), "a case with [reinforcement]")
    elif of.startswith("reinforcement") and combinations.get(keep.combination, "ultimate") != "ultimate":
        found = f"{describe(keep.combination)}, which is not for the ultimate limit state"
        ultimate = [name for name, limit_state in combinations.items() if limit_state == "ultimate"]
        yield RelativeIssue(("combination",), found, one_of(ultimate))


def _soil_issues(keep: RequestedOutput, of: str, model: Model) -> Iterator[RelativeIssue]:
    """Find why a result in the depth of the ground cannot be kept."""
    ground = model.ground
    if not isinstance(ground, ContinuousGround) or (of == "soil settlement" and model.boreholes):
        expected = 'a case whose ground.kind is "continuum" or "constrained modulus", for settlements without boreholes'
        yield RelativeIssue(("of",), describe(keep.of), expected)
    if any(support.kind == "pile" for support in model.supports):
        yield RelativeIssue(
            ("of",), f"{of} below a slab on piles", "a slab without, as they carry loads into the depth"
        )
    for name in ("x", "y", "z"):
        if getattr(keep, name) is None:
            yield RelativeIssue((name,), "nothing", f"where in the ground the {of} is")
    if keep.z is None or not isinstance(ground, Continuum) or ground.half_space is not None:
        return
    base = sum(layer.thickness for layer in ground.layers)
    if keep.z > base:
        yield RelativeIssue(("z",), f"{keep.z:g} m", f"at most {base:g} m, the depth of the rigid base")


def _limit(limit: schema.LimitState, outputs: list[RequestedOutput | None], from_file: bool) -> Limit | None:
    """Return a limit state, None if its output has issues; raises FieldError."""
    output = next((output for output in outputs if output is not None and output.name == limit.keep), None)
    if output is None:
        return None
    name, raw = ("at_most", limit.at_most) if limit.at_most is not None else ("at_least", limit.at_least)
    with issues_below(name):
        bound = output.key.read(raw, from_file)
    sense: Literal["at most", "at least"] = "at most" if name == "at_most" else "at least"
    return Limit(limit.name, limit.keep, sense, float(bound), limit.target)


def _correlation(names: list[str], correlation: tuple[schema.Correlation, ...]) -> Array:
    """Return the correlation matrix (d, d); raises FieldError if it is not positive definite."""
    matrix = np.eye(len(names))
    for entry in correlation:
        for a, b in itertools.permutations([names.index(name) for name in entry.between], 2):
            matrix[a, b] = entry.rho
    least = float(np.linalg.eigvalsh(matrix).min()) if names else 1.0
    if least < 1e-10:
        contradiction = f"correlations that cannot hold together (least eigenvalue {least:.2g})"
        raise FieldError(RelativeIssue((), contradiction, "a positive definite matrix of them", "smaller correlations"))
    return matrix


def warnings_of(setup: Setup) -> list[str]:
    """Return warnings before a study is run, a line each."""
    return [
        f"{variable.name}: about {variable.outside * setup.count:.2g} of {setup.count} values will lie outside the "
        f"range of {variable.path} ({variable.place.key.range_text()}); these variants will fail"
        for variable in setup.variables
        if variable.outside * setup.count > MAX_OUTSIDE
    ]


def column_units(setup: Setup) -> Mapping[str, str]:
    """Return the SI unit of each column of inputs and outputs, in the order of the table; empty where there is none."""
    units = {variable.name: variable.unit for variable in setup.variables}
    units |= {field.name: "" for field in setup.fields}
    return units | {output.name: output.unit for output in setup.outputs}
