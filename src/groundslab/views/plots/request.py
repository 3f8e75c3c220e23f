"""What is to be drawn: kind of figure, amounts, combinations, lines; with everything that is wrong with a wish."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np

from groundslab.errors import GroundslabError, InputError, Issue, NotCertified, NotConverged
from groundslab.model.loads.load_cases import LimitState
from groundslab.results.contact_zone import require_finite
from groundslab.results.record import Step
from groundslab.results.results import Combined, Results
from groundslab.schema.wording import describe, listed, one_of, quote, suggestion
from groundslab.views.plots.amounts import Amount, chosen

Kind = Literal["plan", "deformed", "lines", "soil", "convergence"]
KINDS: tuple[Kind, ...] = get_args(Kind)
#: What is drawn if no amount is named.
USUAL: dict[str, tuple[str, ...]] = {
    "plan": ("settlement", "pressure"),
    "deformed": ("settlement",),
    "lines": ("settlement", "moment_x", "moment_y"),
}
Line = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Drawn:
    """One combination that is drawn: its results, whether they are certified."""

    name: str
    limit_state: str
    results: Results
    certified: bool


@dataclass(frozen=True, slots=True)
class Way:
    """How the iteration for one combination went, up to its end or to where it was given up."""

    name: str
    steps: tuple[Step, ...]
    outcome: str  # empty if it converged and is certified


@dataclass(frozen=True, slots=True)
class Cut:
    """A section line: its name, which may be empty, and its two ends [m]."""

    name: str
    start: tuple[float, float]
    end: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Wish:
    """What is drawn of the results of a model."""

    combined: Combined
    kind: Kind
    amounts: tuple[Amount, ...]
    drawn: tuple[Drawn, ...]
    ways: tuple[Way, ...]  # convergence only
    cuts: tuple[Cut, ...]  # lines only
    envelope: str  # a limit state, or empty

    @property
    def several(self) -> bool:
        """Return whether it must be said which combination is drawn."""
        return bool(self.combined.model.cases) or len(self.combined.combinations) > 1

    @property
    def panels(self) -> int:
        """Return about how many panels there are."""
        if self.kind == "convergence":
            return len(self.ways)
        if self.kind == "soil":
            return len(self.combined.model.boreholes) + len(self.combined.model.soil_zones) + 1
        if self.kind == "lines":
            return len(self.amounts) * len(self.cuts)
        return len(self.amounts) * (2 if self.envelope else len(self.drawn))


def wish_of(
    combined: Combined,
    fields: Sequence[str],
    kind: str | None,
    combination: str | Sequence[str] | None,
    envelope: str | None,
    line: Sequence[Any] | None,
) -> Wish:
    """Return what is asked for; raises InputError with all that is wrong with it.

    A combination without a certified result is drawn if it is named, or if there is no other.
    """
    lines = _lines(line)
    asked = kind or ("lines" if lines else "plan")
    names = (combination,) if isinstance(combination, str) else tuple(dict.fromkeys(combination or ()))
    issues = _misfits(asked, fields, names, envelope, bool(lines))
    known = [each.name for each in combined.combinations]
    issues += [
        Issue("combination", describe(name), one_of(known), suggestion(name, known))
        for name in names
        if name not in known
    ]
    amounts: tuple[Amount, ...] = ()
    try:
        amounts = chosen(fields or USUAL.get(asked, ()))
    except InputError as error:
        issues += error.issues
    cuts = tuple(Cut(each.name, each.start, each.end) for each in combined.model.output.lines)
    if lines:
        cuts = tuple(Cut("", (a, b), (c, d)) for a, b, c, d in lines)
    elif asked == "lines" and not cuts:
        hint = "give one as x1,y1,x2,y2 in metres, or name it under [[output.lines]] in the case"
        issues.append(Issue("line", "no section line", "at least one", hint))
    if issues:
        raise InputError(issues)
    assert asked in KINDS
    if asked == "convergence":
        return Wish(combined, asked, (), (), _ways(combined, names), (), "")
    drawn = _drawn(combined, names, envelope)
    for each in drawn:
        require_finite(each.results)
    return Wish(combined, asked, amounts, drawn, (), cuts, envelope or "")


def _lines(line: Sequence[Any] | None) -> tuple[Line, ...]:
    """Return section lines of four coordinates [m] each, or of two places, given as one or as several."""
    if line is None:
        return ()
    try:
        values = np.asarray(line, dtype=float)
    except (TypeError, ValueError):
        values = np.empty((0, 4))
    if values.shape in ((4,), (2, 2)):
        values = values.reshape(1, 4)
    elif values.ndim == 3:
        values = values.reshape(len(values), -1)
    good = values.ndim == 2 and len(values) > 0 and values.shape[1:] == (4,) and bool(np.isfinite(values).all())
    if not good or (values[:, :2] == values[:, 2:]).all(axis=1).any():
        found = "two ends at one place" if good else describe(line)
        raise InputError([Issue("line", found, "x1, y1, x2, y2 of two different places, in metres")])
    return tuple((a, b, c, d) for a, b, c, d in values.tolist())


def _misfits(
    kind: str, fields: Sequence[str], combinations: tuple[str, ...], envelope: str | None, lines: bool
) -> list[Issue]:
    """Return what does not go together."""
    if kind not in KINDS:
        return [Issue("kind", quote(kind), f"one of {listed(KINDS)}", suggestion(kind, KINDS))]
    issues = []
    if fields and kind not in USUAL:
        issues.append(Issue("FIELD", quote(fields[0]), f"none, as kind is {quote(kind)}"))
    if lines and kind != "lines":
        issues.append(Issue("line", "a line", f"none, as kind is {quote(kind)}"))
    if envelope is None:
        return issues
    states = get_args(LimitState)
    if envelope not in states:
        issues.append(Issue("envelope", quote(envelope), f"one of {listed(states)}", suggestion(envelope, states)))
    if kind not in ("plan", "lines"):
        issues.append(Issue("envelope", "an envelope", f"none, as kind is {quote(kind)}"))
    if combinations:
        issues.append(Issue("envelope", "an envelope of named combinations", "one of the two"))
    return issues


def _drawn(combined: Combined, names: tuple[str, ...], envelope: str | None) -> tuple[Drawn, ...]:
    """Return the combinations to draw: those named, those of an envelope, or all that are certified."""
    found = {}
    for each in combined.combinations:
        refused = combined.refused.get(each.name)
        results = refused.results if isinstance(refused, NotCertified) else combined.results.get(each.name)
        if results is not None:
            found[each.name] = Drawn(each.name, each.limit_state, results, refused is None)
    missing = [name for name in names if name not in found]
    if missing:
        raise _without_results(combined, missing)
    if names:
        return tuple(found[name] for name in names)
    certified = tuple(each for each in found.values() if each.certified)
    if envelope is not None:
        wanted = tuple(each for each in certified if each.limit_state == envelope)
        if not wanted:
            raise InputError([Issue("envelope", quote(envelope), "a limit state with a certified result")])
        return wanted
    if not found:
        raise _without_results(combined, list(combined.refused))
    return certified or tuple(found.values())


def _without_results(combined: Combined, names: Sequence[str]) -> InputError:
    """Return the error for combinations that were refused, with the reason."""
    reasons = [" ".join(str(combined.refused[name]).split()) for name in names]
    return InputError(
        [
            Issue("combination", f"{describe(name)}, which was refused: {reason}", "one that has results")
            for name, reason in zip(names, reasons, strict=True)
        ]
    )


def _ways(combined: Combined, names: tuple[str, ...]) -> tuple[Way, ...]:
    """Return how the iteration went for the combinations named, or for all that have a history."""
    ways = []
    for each in combined.combinations:
        if names and each.name not in names:
            continue
        refused: GroundslabError | None = combined.refused.get(each.name)
        results = refused.results if isinstance(refused, NotCertified) else combined.results.get(each.name)
        if results is not None:
            ways.append(Way(each.name, results.steps, "" if refused is None else "not certified"))
        elif isinstance(refused, NotConverged):
            steps = _steps(refused.history)
            if steps:
                ways.append(Way(each.name, steps, "did not converge"))
    if not ways:
        raise InputError([Issue("combination", "no history of an iteration", "a combination with steps to draw")])
    return tuple(ways)


def _steps(history: Sequence[Any]) -> tuple[Step, ...]:
    """Return the steps of an iteration that did not converge, as far as they tell of the contact zone."""
    steps = []
    for entry in history:
        told = entry if isinstance(entry, dict) else {}
        if {"iteration", "closed", "changed"} <= told.keys():
            steps.append(Step(0, 1, None, told["iteration"], told["closed"], told["changed"], finest=False))
    return tuple(steps)
