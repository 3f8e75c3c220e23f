"""Parse and validate a plot request: kind of figure, quantities, combinations, section lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, get_args

import numpy as np

from groundslab.design.bars.required_bars import bar_fields
from groundslab.errors import InputError, Issue, NotConverged
from groundslab.messages import Message, Name, capitalized
from groundslab.model.loads.load_cases import LimitState
from groundslab.model.model import Model
from groundslab.results.contact_zone import require_finite
from groundslab.results.fields import (
    BAR_FIELDS,
    ERROR,
    LINE_FORCE,
    MEMBRANE,
    RANGED_FIELDS,
    SHOWN_ELEMENT_FIELDS,
    STIFFNESS,
    ResultField,
)
from groundslab.results.records import Step
from groundslab.results.results import CombinationResult, Results
from groundslab.schema.wording import describe, listed, one_of, quote, suggestion
from groundslab.unit_systems import System, unit_in
from groundslab.views.plots.style import math_symbol
from groundslab.views.summary.combinations import entries

#: What is drawn downwards, as it lies.
DOWNWARDS = frozenset({"settlement"})


@dataclass(frozen=True, slots=True)
class PlotQuantity:
    """A quantity of the plate that is drawn: its name and its entry in the table of quantities.

    Values in the usual unit of display are drawn times the factor.
    """

    name: str
    field: ResultField
    factor: float = 1.0

    @property
    def symbol(self) -> str:
        """Return the symbol as a formula."""
        symbol, _, words = self.field.symbol.partition(" ")
        if words:
            return Message("{symbol} {words}", symbol=Name(math_symbol(symbol)), words=words)
        if symbol:
            return Name(math_symbol(symbol))
        face, _, axis = self.name.partition("_")
        return Name(rf"$m^*_{{{axis},\mathrm{{{face}}}}}$")

    @property
    def title(self) -> str:
        """Return the meaning of the quantity as a title."""
        return capitalized(self.field.meaning)

    @property
    def label(self) -> str:
        """Return symbol and unit, for axes and color bars."""
        return Message("{symbol} [{unit}]", symbol=self.symbol, unit=self.field.unit.replace("kNm", "kN m"))

    def in_units(self, system: System) -> PlotQuantity:
        """Return the quantity as it is drawn in the units of a system."""
        unit, factor = unit_in(self.field.unit, system)
        return replace(self, field=replace(self.field, unit=unit), factor=self.factor * factor)


#: A force along the edge is no field over the plate; plans of the pressure name its largest.
QUANTITIES = {
    name: PlotQuantity(name, field)
    for name, field in (RANGED_FIELDS | SHOWN_ELEMENT_FIELDS | BAR_FIELDS).items()
    if name != LINE_FORCE
}
#: Symbols serve as names too.
SYMBOLS = {
    quantity.field.symbol: name
    for name, quantity in QUANTITIES.items()
    if quantity.field.symbol and name not in BAR_FIELDS
}


def resolve(names: Sequence[str]) -> tuple[PlotQuantity, ...]:
    """Return the quantities with some names or symbols, each once; raises InputError for unknown names."""
    issues = [
        Issue("FIELD", quote(name), f"one of {listed(QUANTITIES)}", suggestion(name, [*QUANTITIES, *SYMBOLS]))
        for name in names
        if name not in QUANTITIES and name not in SYMBOLS
    ]
    if issues:
        raise InputError(issues)
    return tuple(QUANTITIES[name] for name in dict.fromkeys(SYMBOLS.get(name, name) for name in names))


Kind = Literal["plan", "deformed", "lines", "beams", "mesh", "soil", "stress", "convergence"]
KINDS: tuple[Kind, ...] = get_args(Kind)
#: What is drawn if no quantity is named.
DEFAULT_QUANTITIES: dict[str, tuple[str, ...]] = {
    "plan": ("settlement", "pressure"),
    "deformed": ("settlement",),
    "lines": ("settlement", "moment_x", "moment_y"),
}


@dataclass(frozen=True, slots=True)
class PlottedCombination:
    """One combination that is drawn: its results, whether they are certified."""

    name: str
    limit_state: str
    results: CombinationResult
    certified: bool

    @property
    def words(self) -> str:
        """Return its name and its limit state, as in "ULS 1 (ultimate)"."""
        return Message("{combination} ({state})", combination=Name(self.name), state=self.limit_state)


@dataclass(frozen=True, slots=True)
class IterationHistory:
    """How the iteration for one combination went, up to its end or to where it was given up."""

    name: str
    steps: tuple[Step, ...]
    outcome: str  # empty if it converged and is certified


@dataclass(frozen=True, slots=True)
class SectionLine:
    """A section line: its name, which may be empty, and its two ends [m]."""

    name: str
    start: tuple[float, float]
    end: tuple[float, float]


@dataclass(frozen=True, slots=True)
class PlotRequest:
    """What is drawn of the results of a model."""

    combined: Results
    kind: Kind
    quantities: tuple[PlotQuantity, ...]
    combinations: tuple[PlottedCombination, ...]
    histories: tuple[IterationHistory, ...]  # convergence only
    lines: tuple[SectionLine, ...]  # lines and stress only
    envelope: str  # a limit state, or empty
    mesh: bool = False  # whether the elements' sides are drawn over fields
    minus: tuple[PlottedCombination, ...] = ()  # what is subtracted from each combination

    @property
    def names_combinations(self) -> bool:
        """Return whether it must be said which combination is drawn."""
        return bool(self.combined.model.cases) or len(self.combined.combinations) > 1

    @property
    def panel_count(self) -> int:
        """Return about how many panels there are."""
        of_bars = sum(quantity.name in BAR_FIELDS for quantity in self.quantities)
        panels = of_bars + (len(self.quantities) - of_bars) * (2 if self.envelope else len(self.combinations))
        return {
            "convergence": len(self.histories),
            "mesh": 1,
            "beams": len(self.combined.model.members) + len(self.combined.model.output.beams),
            "soil": len(self.combined.model.boreholes) + len(self.combined.model.soil_zones) + 1,
            "lines": len(self.quantities) * len(self.lines),
            "stress": len(self.combinations) * len(self.lines),
        }.get(self.kind, panels)


def parse_request(
    combined: Results,
    fields: Sequence[str],
    kind: str | None,
    combination: str | Sequence[str] | None,
    envelope: str | None,
    line: Sequence[Any] | None,
    mesh: bool = False,
) -> PlotRequest:
    """Parse and validate a plot request; raises InputError with all issues.

    A combination without a certified result is drawn if it is named, or if there is no other.
    """
    lines = _parse_lines(line)
    chosen_kind = kind or ("lines" if lines else "plan")
    names = (combination,) if isinstance(combination, str) else tuple(dict.fromkeys(combination or ()))
    issues = _find_conflicts(chosen_kind, fields, names, envelope, bool(lines), mesh)
    available = [combination.name for combination in combined.combinations]
    unknown = [name for name in names if name not in available]
    issues += [Issue("combination", describe(name), one_of(available), suggestion(name, available)) for name in unknown]
    quantities: tuple[PlotQuantity, ...] = ()
    try:
        named = resolve(fields or DEFAULT_QUANTITIES.get(chosen_kind, ()))
        quantities = tuple(quantity.in_units(combined.model.units) for quantity in named)
    except InputError as error:
        issues += error.issues
    listed_lines = tuple(SectionLine(line.name, line.start, line.end) for line in combined.model.output.lines)
    if chosen_kind == "lines" and not (lines or listed_lines):
        hint = "give one as x1,y1,x2,y2 in meters, or name it under [[output.lines]] in the case"
        issues.append(Issue("line", "no section line", "at least one", hint))
    if chosen_kind == "beams" and not (combined.model.members or combined.model.output.beams):
        issues.append(Issue("kind", "a case without beams", "one with beams"))
    if issues:
        raise InputError(issues)
    assert chosen_kind in KINDS
    if chosen_kind == "stress" and not listed_lines:
        listed_lines = (middle_line(combined.model),)
    if chosen_kind == "convergence":
        return PlotRequest(combined, chosen_kind, (), (), _iteration_histories(combined, names), (), "")
    combinations = _select_combinations(combined, names, envelope)
    for plotted in combinations:
        require_finite(plotted.results)
    require_element_fields(quantities, combinations)
    _require_bar_fields(quantities, combined)
    _require_depth(chosen_kind, combinations)
    shown = lines or listed_lines
    return PlotRequest(combined, chosen_kind, quantities, combinations, (), shown, envelope or "", mesh)


def _parse_lines(line: Sequence[Any] | None) -> tuple[SectionLine, ...]:
    """Return section lines without names of four coordinates [m] each, or of two places, given as one or several."""
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
        line_text = "two ends at one place" if good else describe(line)
        raise InputError([Issue("line", line_text, "x1, y1, x2, y2 of two different places, in meters")])
    return tuple(SectionLine("", (a, b), (c, d)) for a, b, c, d in values.tolist())


def require_element_fields(quantities: Sequence[PlotQuantity], combinations: Sequence[PlottedCombination]) -> None:
    """Raise InputError if results lack a field of elements that is to be drawn."""
    hints = {
        ERROR: "it comes from a comparison with a coarser mesh, which these results have not",
        STIFFNESS: "it belongs to cases with [cracking]",
        **dict.fromkeys(MEMBRANE, "it belongs to cases with eccentric beams"),
    }
    issues = [
        Issue("FIELD", quote(quantity.name), f"a field that {quote(combination.name)} has", hints[quantity.name])
        for quantity in quantities
        for combination in combinations
        if quantity.name in SHOWN_ELEMENT_FIELDS and getattr(combination.results.elements, quantity.name) is None
    ]
    if issues:
        raise InputError(issues)


def middle_line(model: Model) -> SectionLine:
    """Return the line through the middle of the plate, along its longer side and from edge to edge."""
    x0, x1, y0, y1 = model.plate.bounds
    if x1 - x0 >= y1 - y0:
        return SectionLine("", (x0, (y0 + y1) / 2), (x1, (y0 + y1) / 2))
    return SectionLine("", ((x0 + x1) / 2, y0), ((x0 + x1) / 2, y1))


def _require_depth(kind: str, combinations: Sequence[PlottedCombination]) -> None:
    """Raise InputError if stresses in the depth of other ground are to be drawn than a continuum."""
    has_stresses = [
        cells is not None and not cells.piled
        for cells in (combination.results.ground.cells for combination in combinations)
    ]
    if kind == "stress" and not all(has_stresses):
        other_ground = f"{quote(kind)} of {quote(combinations[0].results.model.ground.kind)} ground"
        hint = 'ground.kind = "continuum" or "constrained modulus" has them, below a slab without piles'
        raise InputError([Issue("kind", other_ground, "ground whose stresses in the depth are known", hint)])


def _require_bar_fields(quantities: Sequence[PlotQuantity], combined: Results) -> None:
    """Raise InputError if there is none of a field of bars that is to be drawn, or no bars are enough somewhere."""
    wanted = [quantity.name for quantity in quantities if quantity.name in BAR_FIELDS]
    bar_values = bar_fields(combined) if wanted else {}
    issues = []
    for name in wanted:
        if name not in bar_values:
            hint = "it needs [reinforcement] and ultimate combinations; all but the required areas need bars provided"
            issues.append(Issue("FIELD", quote(name), "a field that these results have", hint))
        elif not np.isfinite(bar_values[name]).all():
            hint = "the table reinforcement says where; a thicker slab or a stronger concrete helps"
            issues.append(Issue("FIELD", quote(name), "finite areas; somewhere no reinforcement is enough", hint))
    if issues:
        raise InputError(issues)


def _find_conflicts(
    kind: str, fields: Sequence[str], combinations: tuple[str, ...], envelope: str | None, lines: bool, mesh: bool
) -> list[Issue]:
    """Return an issue for each conflict between options."""
    if kind not in KINDS:
        return [Issue("kind", quote(kind), f"one of {listed(KINDS)}", suggestion(kind, KINDS))]
    issues = []
    if fields and kind not in DEFAULT_QUANTITIES:
        issues.append(Issue("FIELD", quote(fields[0]), f"none, as kind is {quote(kind)}"))
    of_bars = [name for name in fields if name in BAR_FIELDS]
    if of_bars and kind in ("deformed", "lines"):
        issues.append(Issue("FIELD", quote(of_bars[0]), f"a field of combinations, as kind is {quote(kind)}"))
    if of_bars and (combinations or envelope is not None):
        chosen = f"{quote(of_bars[0])} of chosen combinations"
        issues.append(Issue("FIELD", chosen, "none chosen, as it is over all ultimate combinations"))
    of_elements = [name for name in fields if SYMBOLS.get(name, name) in SHOWN_ELEMENT_FIELDS]
    if of_elements and kind == "lines":
        issues.append(Issue("FIELD", quote(of_elements[0]), 'a nodal field, as kind is "lines"'))
    if mesh and kind not in ("plan", "deformed", "mesh"):
        issues.append(Issue("mesh", "the mesh over fields", f"none, as kind is {quote(kind)}"))
    if lines and kind not in ("lines", "stress"):
        issues.append(Issue("line", "a line", f"none, as kind is {quote(kind)}"))
    if envelope is None:
        return issues
    states = get_args(LimitState)
    if envelope not in states:
        issues.append(Issue("envelope", quote(envelope), f"one of {listed(states)}", suggestion(envelope, states)))
    if kind not in ("plan", "lines", "beams"):
        issues.append(Issue("envelope", "an envelope", f"none, as kind is {quote(kind)}"))
    if combinations:
        issues.append(Issue("envelope", "an envelope of named combinations", "one of the two"))
    return issues


def _select_combinations(
    combined: Results, names: tuple[str, ...], envelope: str | None
) -> tuple[PlottedCombination, ...]:
    """Return the combinations to draw: those named, those of an envelope, or all that are certified."""
    by_name = {}
    for entry in entries(combined):
        if entry.results is not None:
            name, state = entry.combination.name, entry.combination.limit_state
            by_name[name] = PlottedCombination(name, state, entry.results, entry.refused is None)
    missing = [name for name in names if name not in by_name]
    if missing:
        raise _without_results(combined, missing)
    if names:
        return tuple(by_name[name] for name in names)
    certified = tuple(combination for combination in by_name.values() if combination.certified)
    if envelope is not None:
        in_state = tuple(combination for combination in certified if combination.limit_state == envelope)
        if not in_state:
            raise InputError([Issue("envelope", quote(envelope), "a limit state with a certified result")])
        return in_state
    if not by_name:
        raise _without_results(combined, list(combined.refused))
    return certified or tuple(by_name.values())


def _without_results(combined: Results, names: Sequence[str]) -> InputError:
    """Return the error for combinations that were refused, with the reason."""
    reasons = {name: " ".join(str(combined.refused[name]).split()) for name in names}
    words = [f"{describe(name)}, which was refused: {reason}" for name, reason in reasons.items()]
    return InputError([Issue("combination", word, "one that has results") for word in words])


def _iteration_histories(combined: Results, names: tuple[str, ...]) -> tuple[IterationHistory, ...]:
    """Return how the iteration went for the combinations named, or for all that have a history."""
    histories = []
    for entry in entries(combined):
        name, refused = entry.combination.name, entry.refused
        if names and name not in names:
            continue
        if entry.results is not None:
            histories.append(IterationHistory(name, entry.results.steps, "not certified" if refused else ""))
        elif isinstance(refused, NotConverged) and (steps := _contact_steps(refused.history)):
            histories.append(IterationHistory(name, steps, "did not converge"))
    if not histories:
        raise InputError([Issue("combination", "no history of an iteration", "a combination with steps to draw")])
    return tuple(histories)


def _contact_steps(history: Sequence[Any]) -> tuple[Step, ...]:
    """Return the steps of an iteration that did not converge, as far as they hold the contact zone."""
    return tuple(
        Step(0, 1, None, step["iteration"], step["closed"], step["changed"], finest=False)
        for step in history
        if isinstance(step, dict) and {"iteration", "closed", "changed"} <= step.keys()
    )
