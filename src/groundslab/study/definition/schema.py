"""A study as its file says it: which case, what varies and how, what is kept of each variant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from groundslab.schema import reference
from groundslab.schema.base import Check, Section, Table
from groundslab.schema.fields import Boolean, Choice, Integer, ListOf, Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.wording import describe, one_of, quote, suggestion
from groundslab.study.definition.distributions import DistributionOf
from groundslab.study.definition.field_types import Amount, OneOrTwo, Raw
from groundslab.study.definition.outputs import Take

SamplingKind = Literal["grid", "list", "latin hypercube", "sobol", "saltelli", "monte carlo", "tornado"]
Correlogram = Literal["gaussian", "exponential", "matern32"]

#: What is counted through, not drawn.
COUNTED = ("grid", "list")
#: What says by itself how many variants there are.
UNCOUNTED = (*COUNTED, "tornado")


def _count_fits(kind: str, count: int | None) -> Iterator[RelativeIssue]:
    if kind in UNCOUNTED and count is not None:
        hint = "the values say how many there are" if kind in COUNTED else "two for each variable, and one more"
        yield RelativeIssue(("count",), str(count), f"no count, as kind is {quote(kind)}", hint)
    if kind not in UNCOUNTED and count is None:
        yield RelativeIssue(("count",), "nothing", "a whole number of variants", f"kind is {quote(kind)}")


class Sampling(Section):
    """How variants are made of what varies."""

    checks: ClassVar[tuple[Check, ...]] = (_count_fits,)

    kind: Annotated[
        SamplingKind,
        Choice(
            SamplingKind,
            "grid: all values with all others; list: the first of each, the second of each, ...; tornado: all medians, "
            "then each variable by itself at its 10 % and its 90 % quantile; the others draw from the distributions",
        ),
    ]
    count: Annotated[
        int | None, Integer("variants to draw; of saltelli those of each of the two samples that are mixed")
    ] = None


def _choice_of_values(values: tuple[Raw, ...] | None, choose: bool) -> Iterator[RelativeIssue]:
    if choose and values is None:
        yield RelativeIssue(("choose",), "true", "values to choose from")


def _values_or_distribution(values: tuple[Raw, ...] | None, distribution: Section | None) -> Iterator[RelativeIssue]:
    if (values is None) == (distribution is None):
        found = "neither values nor distribution" if values is None else "both values and distribution"
        yield RelativeIssue((), found, "exactly one of values and distribution")


class Vary(Section):
    """A quantity of the case that varies."""

    checks: ClassVar[tuple[Check, ...]] = (_values_or_distribution, _choice_of_values)

    path: Annotated[str, Text("key of the case; positions count from 1, as in ground.layers[1].E")]
    name: Annotated[str, Text("its name in the study; the path by default")] = ""
    values: Annotated[tuple[Raw, ...] | None, ListOf(Amount("", ""), "", "values; drawn ones are equally likely")] = (
        None
    )
    distribution: Annotated[DistributionOf | None, Table("distribution of the values, instead of values")] = None
    choose: Annotated[
        bool, Boolean("whether values are for the designer to choose from: not drawn, each is solved with all that is")
    ] = False
    times: Annotated[bool, Boolean("whether values are pure numbers that the value in the case is multiplied by")] = (
        False
    )


class Correlation(Section):
    """Variables that depend on each other."""

    between: Annotated[tuple[str, ...], ListOf(Text(""), "", "names of two or more variables", unique=True, least=2)]
    rho: Annotated[float, Number("rho", "correlation of each two of them, in normal scores", Range(above=-1, below=1))]


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


class Keep(Section):
    """A result to be kept of each variant."""

    name: Annotated[str, Text("its name; made of what it is by default")] = ""
    of: Annotated[str, Text("a field of the plate or a figure, see below")]
    take: Annotated[
        Take | None,
        Choice(Take, "what to take of a field: its largest or smallest value, its mean over the area, the value at a "
               "place, or the whole field"),
    ] = None  # fmt: skip
    x: Annotated[float | None, Quantity("length", "x", "place, for at")] = None
    y: Annotated[float | None, Quantity("length", "y", "place, for at")] = None
    combination: Annotated[
        str, Text("combination that it is of; by default all of them, and of these the worst one's")
    ] = ""
    support: Annotated[str, Text("name of the support, for support force")] = ""
    layer: Annotated[int | None, Integer("layer of the ground from the top, for k0 and k1")] = None


def _one_limit(at_most: Raw | None, at_least: Raw | None) -> Iterator[RelativeIssue]:
    if (at_most is None) == (at_least is None):
        found = "neither at_most nor at_least" if at_most is None else "both at_most and at_least"
        yield RelativeIssue((), found, "exactly one of at_most and at_least")


class LimitState(Section):
    """A limit that a kept result should not pass."""

    checks: ClassVar[tuple[Check, ...]] = (_one_limit,)

    name: Annotated[str, Text("its name")]
    keep: Annotated[str, Text("name of the kept result")]
    at_most: Annotated[Raw | None, Amount("", "largest value that is fine", "as the kept result")] = None
    at_least: Annotated[Raw | None, Amount("", "smallest value that is fine", "as the kept result")] = None
    target: Annotated[
        float | None, Number("", "probability of failure that is aimed at, for the evaluation", Range(above=0, below=1))
    ] = None


def _something_varies(vary: tuple[Vary, ...], random_field: tuple[RandomField, ...]) -> Iterator[RelativeIssue]:
    if not vary and not random_field:
        yield RelativeIssue((), "nothing that varies", "[[vary]] or [[random_field]]")


def _choices_fit(
    sampling: Sampling, vary: tuple[Vary, ...], correlation: tuple[Correlation, ...]
) -> Iterator[RelativeIssue]:
    """Find choices where nothing is drawn, and choices that are said to hang together with chance."""
    for position, each in enumerate(vary):
        if each.choose and sampling.kind in (*UNCOUNTED, "saltelli"):
            expected = f"no choice, as sampling.kind is {quote(sampling.kind)}"
            yield RelativeIssue(("vary", position, "choose"), "true", expected)
        if each.choose and any((each.name or each.path) in pair.between for pair in correlation):
            yield RelativeIssue(("vary", position, "choose"), "true", "no choice, as [[correlation]] names it")


def _kinds_fit(sampling: Sampling, vary: tuple[Vary, ...]) -> Iterator[RelativeIssue]:
    if sampling.kind == "tornado":
        for position, each in enumerate(vary):
            if each.values is not None:
                yield RelativeIssue(
                    ("vary", position, "values"), "values", 'a distribution, as sampling.kind is "tornado"'
                )
    if sampling.kind not in COUNTED:
        return
    for position, each in enumerate(vary):
        if each.distribution is not None:
            expected = f"values, as sampling.kind is {quote(sampling.kind)}"
            yield RelativeIssue(("vary", position, "distribution"), "a distribution", expected)
    lengths = {len(each.values) for each in vary if each.values is not None}
    if sampling.kind == "list" and len(lengths) > 1:
        expected = 'as many values for each, as sampling.kind is "list"'
        yield RelativeIssue(("vary",), f"lists of {one_of_numbers(lengths)} values", expected)


def one_of_numbers(numbers: set[int]) -> str:
    """Return numbers in words: ``2, 3 or 5``."""
    from groundslab.schema.wording import listed

    return listed(map(str, sorted(numbers)), "and")


def _fields_fit(
    sampling: Sampling, vary: tuple[Vary, ...], random_field: tuple[RandomField, ...]
) -> Iterator[RelativeIssue]:
    if sampling.kind in ("grid", "tornado") and random_field:
        yield RelativeIssue(
            ("random_field",), describe(random_field), f"none, as sampling.kind is {quote(sampling.kind)}"
        )
    if sampling.kind == "list" and not vary:
        yield RelativeIssue(("vary",), "nothing", 'at least one variable with a list, as sampling.kind is "list"')


def _known_keeps(keep: tuple[Keep, ...], limit_state: tuple[LimitState, ...]) -> Iterator[RelativeIssue]:
    names = [name_of_keep(each) for each in keep]
    for position, each in enumerate(limit_state):
        if each.keep not in names:
            hint = suggestion(each.keep, names)
            yield RelativeIssue(("limit_state", position, "keep"), describe(each.keep), one_of(names), hint)
        elif keep[names.index(each.keep)].take == "everywhere":
            yield RelativeIssue(("limit_state", position, "keep"), describe(each.keep), "a result that is one number")


def _names_once(
    vary: tuple[Vary, ...],
    random_field: tuple[RandomField, ...],
    keep: tuple[Keep, ...],
    limit_state: tuple[LimitState, ...],
) -> Iterator[RelativeIssue]:
    """Find names that stand twice; those of columns also if only capitals tell them apart, which a table cannot."""
    seen: set[str] = set(RESERVED)
    for part, names in (
        ("vary", [each.name or each.path for each in vary]),
        ("random_field", [name_of_field(each) for each in random_field]),
        ("keep", [name_of_keep(each) for each in keep]),
    ):
        for position, name in enumerate(names):
            if name.casefold() in seen:
                expected = "a name that no other column of the study has"
                yield RelativeIssue((part, position, "name"), describe(name), expected, "capitals make no difference")
            if not name.isprintable() or len(name) > LONGEST_NAME:
                expected = f"one line of at most {LONGEST_NAME} characters"
                yield RelativeIssue((part, position, "name"), describe(name), expected)
            seen.add(name.casefold())
    limits: set[str] = set()
    for position, each in enumerate(limit_state):
        if each.name in limits:
            yield RelativeIssue(("limit_state", position, "name"), describe(each.name), "a name that no other one has")
        limits.add(each.name)


def _few_columns(
    vary: tuple[Vary, ...], random_field: tuple[RandomField, ...], keep: tuple[Keep, ...]
) -> Iterator[RelativeIssue]:
    total = len(vary) + len(random_field) + len(keep)
    if total > MOST_COLUMNS:
        yield RelativeIssue((), f"{total} variables and results", f"at most {MOST_COLUMNS} together")


def _known_correlations(vary: tuple[Vary, ...], correlation: tuple[Correlation, ...]) -> Iterator[RelativeIssue]:
    names = [each.name or each.path for each in vary]
    pairs: set[frozenset[str]] = set()
    for position, each in enumerate(correlation):
        for number, name in enumerate(each.between):
            if name not in names:
                hint = suggestion(name, names)
                expected = one_of(names) if names else "a variable"
                yield RelativeIssue(("correlation", position, "between", number), describe(name), expected, hint)
        own = {frozenset((a, b)) for a in each.between for b in each.between if a != b}
        if own & pairs:
            yield RelativeIssue(("correlation", position, "between"), "a pair that stands above", "each pair once")
        pairs |= own


def _correlation_fits(sampling: Sampling, correlation: tuple[Correlation, ...]) -> Iterator[RelativeIssue]:
    if correlation and sampling.kind in (*UNCOUNTED, "saltelli"):
        why = "Sobol's indices are for independent variables" if sampling.kind == "saltelli" else "nothing is drawn"
        yield RelativeIssue(
            ("correlation",), describe(correlation), f"none, as sampling.kind is {quote(sampling.kind)}", why
        )


#: Columns that every study has.
RESERVED = ("number", "status", "reason", "message", "seconds", "mesh", "rowid", "oid", "_rowid_")
LONGEST_NAME = 200
#: SQLite takes 2000 columns.
MOST_COLUMNS = 1000


def name_of_field(field: RandomField) -> str:
    """Return the name of a random field in the study, also that of the column with its seed."""
    return field.name or f"{field.path} field"


def name_of_keep(keep: Keep) -> str:
    """Return the name of a kept result."""
    if keep.name:
        return keep.name
    words = [keep.take or "", keep.of]
    if keep.take == "at":
        words = [keep.of, f"at ({keep.x:g}, {keep.y:g}) m" if None not in (keep.x, keep.y) else ""]
    if keep.take == "everywhere":
        words = [keep.of, "everywhere"]
    words += [f"of {keep.support}" if keep.support else "", f"of layer {keep.layer}" if keep.layer else ""]
    words.append(f"under {keep.combination}" if keep.combination else "")
    return " ".join(filter(None, words))


class StudyFile(Section):
    """The whole description of a study."""

    checks: ClassVar[tuple[Check, ...]] = (
        _something_varies,
        _kinds_fit,
        _choices_fit,
        _fields_fit,
        _names_once,
        _few_columns,
        _known_correlations,
        _correlation_fits,
        _known_keeps,
    )

    title: Annotated[str, Text("title of the study")] = ""
    case: Annotated[str, Text("case file, from the folder of this file on")]
    seed: Annotated[int, Integer("seed of all that is drawn", at_least=0)] = 1
    sampling: Annotated[Sampling, Table("how variants are made of what varies")]
    vary: Annotated[tuple[Vary, ...], Table("quantities of the case that vary")] = ()
    correlation: Annotated[tuple[Correlation, ...], Table("variables that depend on each other")] = ()
    random_field: Annotated[tuple[RandomField, ...], Table("ground that varies from place to place by chance")] = ()
    keep: Annotated[tuple[Keep, ...], Field(min_length=1), Table("results to be kept of each variant")]
    limit_state: Annotated[tuple[LimitState, ...], Table("limits that kept results should not pass")] = ()

    @classmethod
    def root(cls) -> str:
        """Return nothing: paths of faults start with the section."""
        return ""


def json_schema() -> dict[str, Any]:
    """Return the JSON schema of a study file, for editors."""
    return reference.json_schema(StudyFile, "groundslab study file")


def docs_table() -> str:
    """Return all keys of a study file as Markdown, one table per section and kind; distributions once."""
    sections = reference.docs_table(StudyFile).split("\n### ")
    return "\n### ".join(each for each in sections if not each.startswith("`[random_field.distribution]`"))


def kept_table() -> str:
    """Return all that can be kept of a variant as Markdown."""
    from groundslab.study.definition.outputs import FIELDS, FIGURES

    lines = []
    for title, kept in (("fields: `take` says what of them", FIELDS), ("figures: without `take`", FIGURES)):
        lines += [f"| {title} | dimension | meaning |", "|---|---|---|"]
        lines += [f"| `{each.name}` | {each.dimension or 'pure number'} | {each.meaning} |" for each in kept.values()]
        lines.append("")
    return "\n".join(lines).strip() + "\n"
