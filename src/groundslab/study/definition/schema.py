"""The study file: which case, what varies and how, which results are kept of each variant."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from typing import Annotated, Any, ClassVar, Literal

from groundslab.schema import reference
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Boolean, Choice, Integer, ListOf, Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import Table
from groundslab.schema.wording import describe, listed, one_of, quote, suggestion
from groundslab.study.definition.distributions import DistributionOf
from groundslab.study.definition.field_types import Amount, OneOrTwo, Raw
from groundslab.study.definition.issues import require_one
from groundslab.study.definition.outputs import FIELDS, SCALARS, RequestedOutput

SamplingKind = Literal["grid", "list", "latin hypercube", "sobol", "saltelli", "monte carlo", "tornado"]
Correlogram = Literal["gaussian", "exponential", "matern32"]

Place = tuple[str | int, ...]

#: Kinds of sampling that go through listed values.
LISTED = ("grid", "list")
#: Kinds of sampling whose number of variants follows from the variables.
UNCOUNTED = (*LISTED, "tornado")

#: Columns that every study has.
RESERVED = ("number", "status", "reason", "message", "seconds", "mesh", "rowid", "oid", "_rowid_")
MAX_NAME_LENGTH = 200
#: SQLite takes 2000 columns.
MAX_COLUMNS = 1000


def _count_fits(kind: str, count: int | None) -> Iterator[RelativeIssue]:
    if kind in UNCOUNTED and count is not None:
        hint = "the values say how many there are" if kind in LISTED else "two for each variable, and one more"
        yield RelativeIssue(("count",), str(count), f"no count, as kind is {quote(kind)}", hint)
    if kind not in UNCOUNTED and count is None:
        yield RelativeIssue(("count",), "nothing", "a whole number of variants", f"kind is {quote(kind)}")


class Sampling(Section):
    """How variants are sampled."""

    constraints: ClassVar[tuple[Check, ...]] = (_count_fits,)

    kind: Annotated[
        SamplingKind,
        Choice(
            SamplingKind,
            "grid: all combinations of values; list: the first of each, the second of each, ...; tornado: all medians, "
            "then each variable by itself at its 10 % and its 90 % quantile; the others draw from the distributions",
        ),
    ]
    count: Annotated[int | None, Integer("variants to draw; for saltelli, in each of its two samples")] = None


def _choice_of_values(values: tuple[Raw, ...] | None, choose: bool) -> Iterator[RelativeIssue]:
    if choose and values is None:
        yield RelativeIssue(("choose",), "true", "values to choose from")


class VariedQuantity(Section):
    """A quantity of the case that varies."""

    constraints: ClassVar[tuple[Check, ...]] = (require_one("values", "distribution"), _choice_of_values)

    path: Annotated[str, Text("key of the case; positions count from 1, as in ground.layers[1].E")]
    name: Annotated[str, Text("its name in the study; the path by default")] = ""
    values: Annotated[
        tuple[Raw, ...] | None, ListOf(Amount("", ""), "", "values; if sampled, all are equally likely")
    ] = None
    distribution: Annotated[DistributionOf | None, Table("distribution of the values, instead of values")] = None
    choose: Annotated[
        bool, Boolean("whether values are design choices: not sampled, each is solved with all samples")
    ] = False
    times: Annotated[bool, Boolean("whether values are pure numbers that multiply the value in the case")] = False

    @property
    def column(self) -> str:
        """Return its name in the study and its table."""
        return self.name or self.path


class Correlation(Section):
    """Variables that depend on each other."""

    between: Annotated[tuple[str, ...], ListOf(Text(""), "", "names of two or more variables", unique=True, least=2)]
    rho: Annotated[float, Number("rho", "correlation of each pair, in normal scores", Range(above=-1, below=1))]


class RandomField(Section):
    """A factor on a quantity of the ground that varies from place to place."""

    path: Annotated[str, Text("key of the ground: ground.k, ground.k0, ground.k1, ground.layers[1].E and the like")]
    name: Annotated[str, Text("its name in the study; the path and the word field by default")] = ""
    distribution: Annotated[DistributionOf, Table("distribution of the factor at each place; amounts are pure numbers")]
    correlation_length: Annotated[
        tuple[float, float],
        OneOrTwo(Quantity("length", "", "", Range(above=0)), "l", "correlation length, or those along x and along y"),
    ]
    model: Annotated[
        Correlogram,
        Choice(
            Correlogram,
            "correlation over the scaled distance r: exp(-r^2), exp(-r) or (1 + sqrt(3) r) exp(-sqrt(3) r)",
        ),
    ] = "gaussian"

    @property
    def column(self) -> str:
        """Return its name in the study, also that of the column with its seed."""
        return self.name or f"{self.path} field"


class LimitState(Section):
    """A limit that a kept result should not pass."""

    constraints: ClassVar[tuple[Check, ...]] = (require_one("at_most", "at_least"),)

    name: Annotated[str, Text("its name")]
    keep: Annotated[str, Text("name of the kept result")]
    at_most: Annotated[Raw | None, Amount("", "largest acceptable value", "as the kept result")] = None
    at_least: Annotated[Raw | None, Amount("", "smallest acceptable value", "as the kept result")] = None
    target: Annotated[
        float | None, Number("", "target probability of failure, for the evaluation", Range(above=0, below=1))
    ] = None


def _misfit(place: Place, found: str, expected: str, sampling: Sampling, hint: str = "") -> RelativeIssue:
    """Return the issue of something that the kind of sampling excludes."""
    return RelativeIssue(place, found, f"{expected}, as sampling.kind is {quote(sampling.kind)}", hint)


def _choices_fit(
    sampling: Sampling, vary: tuple[VariedQuantity, ...], correlation: tuple[Correlation, ...]
) -> Iterator[RelativeIssue]:
    """Find choices where nothing is drawn, and choices that are correlated with drawn variables."""
    for position, quantity in enumerate(vary):
        if quantity.choose and sampling.kind in (*UNCOUNTED, "saltelli"):
            yield _misfit(("vary", position, "choose"), "true", "no choice", sampling)
        if quantity.choose and any(quantity.column in pair.between for pair in correlation):
            yield RelativeIssue(("vary", position, "choose"), "true", "no choice, as [[correlation]] names it")


def _kinds_fit(sampling: Sampling, vary: tuple[VariedQuantity, ...]) -> Iterator[RelativeIssue]:
    for position, quantity in enumerate(vary):
        if sampling.kind == "tornado" and quantity.values is not None:
            yield _misfit(("vary", position, "values"), "values", "a distribution", sampling)
        if sampling.kind in LISTED and quantity.distribution is not None:
            yield _misfit(("vary", position, "distribution"), "a distribution", "values", sampling)
    lengths = {len(quantity.values) for quantity in vary if quantity.values is not None}
    if sampling.kind == "list" and len(lengths) > 1:
        found = f"lists of {listed(map(str, sorted(lengths)), 'and')} values"
        yield _misfit(("vary",), found, "as many values for each", sampling)


def _fields_fit(
    sampling: Sampling, vary: tuple[VariedQuantity, ...], random_field: tuple[RandomField, ...]
) -> Iterator[RelativeIssue]:
    if sampling.kind in ("grid", "tornado") and random_field:
        yield _misfit(("random_field",), describe(random_field), "none", sampling)
    if sampling.kind == "list" and not vary:
        yield _misfit(("vary",), "nothing", "at least one variable with a list", sampling)


def _correlation_fits(sampling: Sampling, correlation: tuple[Correlation, ...]) -> Iterator[RelativeIssue]:
    if correlation and sampling.kind in (*UNCOUNTED, "saltelli"):
        why = "Sobol's indices are for independent variables" if sampling.kind == "saltelli" else "nothing is drawn"
        yield _misfit(("correlation",), describe(correlation), "none", sampling, why)


def _something_varies(
    vary: tuple[VariedQuantity, ...], random_field: tuple[RandomField, ...]
) -> Iterator[RelativeIssue]:
    if not vary and not random_field:
        yield RelativeIssue((), "nothing that varies", "[[vary]] or [[random_field]]")


def _known_outputs(keep: tuple[RequestedOutput, ...], limit_state: tuple[LimitState, ...]) -> Iterator[RelativeIssue]:
    outputs = {output.column: output for output in reversed(keep)}
    for position, limit in enumerate(limit_state):
        place = ("limit_state", position, "keep")
        if limit.keep not in outputs:
            names = [output.column for output in keep]
            yield RelativeIssue(place, describe(limit.keep), one_of(names), suggestion(limit.keep, names))
        elif outputs[limit.keep].take == "everywhere":
            yield RelativeIssue(place, describe(limit.keep), "a result that is one number")


def _unique_names(
    vary: tuple[VariedQuantity, ...],
    random_field: tuple[RandomField, ...],
    keep: tuple[RequestedOutput, ...],
    limit_state: tuple[LimitState, ...],
) -> Iterator[RelativeIssue]:
    """Find names that occur twice; for SQLite's columns capitals make no difference."""
    columns: dict[str, Sequence[VariedQuantity | RandomField | RequestedOutput]]
    columns = {"vary": vary, "random_field": random_field, "keep": keep}
    seen: set[str] = set(RESERVED)
    for key, parts in columns.items():
        for position, part in enumerate(parts):
            name, place = part.column, (key, position, "name")
            if name.casefold() in seen:
                expected = "a name that no other column of the study has"
                yield RelativeIssue(place, describe(name), expected, "capitals make no difference")
            if not name.isprintable() or len(name) > MAX_NAME_LENGTH:
                yield RelativeIssue(place, describe(name), f"one line of at most {MAX_NAME_LENGTH} characters")
            seen.add(name.casefold())
    total = sum(map(len, columns.values()))
    if total > MAX_COLUMNS:
        yield RelativeIssue((), f"{total} variables and results", f"at most {MAX_COLUMNS} together")
    limits: set[str] = set()
    for position, limit in enumerate(limit_state):
        if limit.name in limits:
            yield RelativeIssue(("limit_state", position, "name"), describe(limit.name), "a name that no other one has")
        limits.add(limit.name)


def _known_correlations(
    vary: tuple[VariedQuantity, ...], correlation: tuple[Correlation, ...]
) -> Iterator[RelativeIssue]:
    names = [quantity.column for quantity in vary]
    pairs: set[frozenset[str]] = set()
    for position, entry in enumerate(correlation):
        for number, name in enumerate(entry.between):
            if name not in names:
                expected = one_of(names) if names else "a variable"
                place = ("correlation", position, "between", number)
                yield RelativeIssue(place, describe(name), expected, suggestion(name, names))
        entry_pairs = {frozenset(pair) for pair in itertools.combinations(entry.between, 2)}
        if entry_pairs & pairs:
            yield RelativeIssue(("correlation", position, "between"), "a pair that is already listed", "each pair once")
        pairs |= entry_pairs


class StudyFile(Section):
    """The description of a study: the contents of a study file.

    Numbers are in SI units; text with a unit, such as ``"30 MPa"``, may stand for any quantity.

    >>> file = StudyFile(
    ...     case="slab.toml",
    ...     sampling={"kind": "monte carlo", "count": 100},
    ...     vary=[{"path": "ground.k", "distribution": {"kind": "lognormal", "mean": 20e6, "cov": 0.3}}],
    ...     keep=[{"of": "settlement", "take": "largest"}],
    ... )
    >>> file.vary[0].column
    'ground.k'
    """

    constraints: ClassVar[tuple[Check, ...]] = (
        _something_varies,
        _kinds_fit,
        _choices_fit,
        _fields_fit,
        _unique_names,
        _known_correlations,
        _correlation_fits,
        _known_outputs,
    )

    title: Annotated[str, Text("title of the study")] = ""
    case: Annotated[str, Text("case file, relative to the folder of this file")]
    seed: Annotated[int, Integer("seed of all random sampling", at_least=0)] = 1
    sampling: Annotated[Sampling, Table("how variants are made")]
    vary: Annotated[tuple[VariedQuantity, ...], Table("quantities of the case that vary")] = ()
    correlation: Annotated[tuple[Correlation, ...], Table("variables that depend on each other")] = ()
    random_field: Annotated[tuple[RandomField, ...], Table("ground that varies from place to place by chance")] = ()
    keep: Annotated[tuple[RequestedOutput, ...], Table("results to be kept of each variant")]
    limit_state: Annotated[tuple[LimitState, ...], Table("limits that kept results should not pass")] = ()

    @classmethod
    def root(cls) -> str:
        """Return nothing: locations of issues start with the section."""
        return ""


def json_schema() -> dict[str, Any]:
    """Return the JSON schema of a study file, for editors."""
    return reference.json_schema(StudyFile, "groundslab study file")


def docs_table() -> str:
    """Return all keys of a study file as Markdown, one table per section and kind; distributions once."""
    sections = reference.docs_table(StudyFile).split("\n### ")
    return "\n### ".join(section for section in sections if not section.startswith("`[random_field.distribution]`"))


def outputs_table() -> str:
    """Return all results that can be kept of a variant as Markdown."""
    lines = []
    for title, kept in (("fields: `take` says what of them", FIELDS), ("figures: without `take`", SCALARS)):
        lines += [f"| {title} | dimension | meaning |", "|---|---|---|"]
        lines += [
            f"| `{name}` | {output.dimension or 'pure number'} | {output.meaning} |" for name, output in kept.items()
        ]
        lines.append("")
    return "\n".join(lines).strip() + "\n"
