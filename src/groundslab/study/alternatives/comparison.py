"""Alternatives to a design side by side: each is solved, given bars, checked and measured like any other case."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NamedTuple

from groundslab.analysis.driver import solve
from groundslab.case import casefile
from groundslab.case.editing.case_text import CaseText
from groundslab.case.editing.reinforcement import with_reinforcement
from groundslab.design.bars.proposal.links import punching_links
from groundslab.design.checks import Design, check_design
from groundslab.design.proposal import propose_bars
from groundslab.errors import GroundslabError
from groundslab.fem.shape_functions import areas
from groundslab.messages import Message, Name
from groundslab.model.model import Model
from groundslab.model.settings import ACCURACIES
from groundslab.results.results import Results
from groundslab.study.alternatives.proposals import Proposal, drop_panels, other_thicknesses
from groundslab.views.tables.bar_quantities import bars

AS_DRAWN = Proposal("as drawn", "The slab as it is drawn")
BARS = Proposal("bars proposed", "The slab with bars that are proposed in place of its own")


@dataclass(frozen=True, slots=True)
class DesignAlternative:
    """A slab that was tried.

    Attributes
    ----------
    name, words : str
        What it is called, and what it changes.
    text : str
        The case with its changes and its bars, to be saved and solved.
    concrete : float
        Volume of plates and zones [m3].
    bars : float or None
        Mass of the bars [kg], with laps as far as the case has detailing; None without bars.
    links : float or None
        Mass of the links against punching that are needed [kg]; None where no layout bears punching.
    places_of_links : int
        Number of columns, piles, thicker zones and ends of walls that need links.
    utilizations : dict of str to float
        The largest utilization of each kind of check.
    settlement : float
        The largest settlement over all combinations [m].
    status : str
        The worst status of any check.
    notes : tuple of str
        What a reader must know about it.
    within_error : dict of str to float
        Of each kind of check whose verdict hangs on the discretization error, the largest utilization within it.
    """

    name: str
    words: str
    text: str
    concrete: float
    bars: float | None
    links: float | None
    places_of_links: int
    utilizations: dict[str, float]
    settlement: float
    status: str
    notes: tuple[str, ...] = ()
    within_error: dict[str, float] = field(default_factory=dict)

    @property
    def verdict(self) -> str:
        """Return the status, and whether it hangs on the discretization error that nothing exceeds its limit."""
        if self.status == "fails" or not self.within_error:
            return self.status
        return Message("{status}, but within the error", status=self.status)


@dataclass(frozen=True, slots=True)
class DesignComparison:
    """Alternatives to a design side by side.

    Attributes
    ----------
    model : Model
        The model that was given.
    alternatives : tuple of DesignAlternative
        The slab as it is drawn and what was tried in its place.
    notes : tuple of str
        What was tried but has no result, and why.
    """

    model: Model
    alternatives: tuple[DesignAlternative, ...]
    notes: tuple[str, ...] = ()

    def __getitem__(self, name: str) -> DesignAlternative:
        """Return an alternative by its name; KeyError if there is none."""
        for alternative in self.alternatives:
            if alternative.name == name:
                return alternative
        raise KeyError(name)


def compare_designs(case: str | Path | Model, on_begin: Callable[[str, int], None] | None = None) -> DesignComparison:
    """Try other thicknesses, drop panels and bars for a slab, and compare utilizations and quantities.

    Tried are the slab as it is drawn; with bars that are proposed; thinner and thicker by about a tenth, a multiple of
    50 mm or 2 in; and, if columns need links against punching, with drop panels there. Each but the first has bars
    proposed for it where the case has reinforcement, and each has the links that it needs. Loads stay; self-weight
    follows the thickness. All are solved to the accuracy "draft" unless the case has elements of a given size.

    Parameters
    ----------
    case : str or Path or Model
        The case file, or the model.
    on_begin : callable, optional
        Called with the name of each alternative before it is solved, and with how many come after it at most.

    Returns
    -------
    DesignComparison
        The alternatives, each with the text of a case to go on with.

    Raises
    ------
    InputError
        If the case cannot be read.
    GroundslabError
        If there is no certified result for the slab as it is drawn; see `solve`.

    Examples
    --------
    >>> import groundslab
    >>> comparison = groundslab.compare_designs("raft.toml")
    >>> for alternative in comparison.alternatives:
    ...     print(alternative.name, alternative.status, alternative.concrete)
    """
    if isinstance(case, Model):
        return compare_texts(casefile.to_toml(case), None, on_begin)
    return compare_texts(casefile.read(case), Path(case).parent, on_begin)


def compare_texts(
    text: str, folder: Path | None, on_begin: Callable[[str, int], None] | None = None
) -> DesignComparison:
    """Return the comparison of the case that a text describes; names of files in it are those in a folder."""
    report = on_begin or (lambda _name, _left: None)
    data = casefile.tables(text)
    model = casefile.from_table(data, folder)
    others = list(other_thicknesses(model, data))
    report(AS_DRAWN.name, len(others) + 2)
    drawn = _solve(model)
    if not drawn.results:
        raise next(iter(drawn.refused.values()))
    alternatives = [_measure(AS_DRAWN, text, drawn)]
    notes = list[str]()
    if model.reinforcement is not None:
        report(BARS.name, len(others) + 1)
        with_bars = _propose(BARS, text, drawn, folder, notes)
        alternatives += [] if with_bars is None else [with_bars.alternative]
        panels = drop_panels(drawn if with_bars is None else with_bars.results, data)
        others += [] if panels is None else [panels]
    for left, proposal in zip(reversed(range(len(others))), others, strict=True):
        report(proposal.name, left)
        alternatives += _try(proposal, text, data, folder, notes)
    return DesignComparison(model, tuple(alternatives), (*notes, *_common_notes(model)))


class WithBars(NamedTuple):
    """An alternative with bars that are proposed, and the results with which they are checked."""

    alternative: DesignAlternative
    results: Results


def _try(
    proposal: Proposal, text: str, data: dict[str, Any], folder: Path | None, notes: list[str]
) -> Iterator[DesignAlternative]:
    """Yield an alternative if it can be solved; note why not."""
    document = CaseText(text, data)
    try:
        for path, value in proposal.edits:
            document.set(path, value)
        results = _solve(casefile.from_table(document.data, folder))
        if not results.results:
            raise next(iter(results.refused.values()))
    except GroundslabError as error:
        notes.append(Message("Without a result: {words}: {error}", words=proposal.words, error=str(error)))
        return
    if results.model.reinforcement is None:
        yield _measure(proposal, document.text, results)
    elif with_bars := _propose(proposal, document.text, results, folder, notes):
        yield with_bars.alternative


def _propose(proposal: Proposal, text: str, results: Results, folder: Path | None, notes: list[str]) -> WithBars | None:
    """Return an alternative with the bars that are proposed for it; None and a note if none are enough."""
    try:
        proposed = propose_bars(results)
    except GroundslabError as error:
        notes.append(Message("No bars can be proposed: {words}: {error}", words=proposal.words, error=str(error)))
        return None
    written = with_reinforcement(text, proposed.reinforcement, folder or Path())
    # where concrete cracks, bars change how stiff the slab is
    checked = replace(results, model=proposed.model) if results.model.cracking is None else _solve(proposed.model)
    return WithBars(_measure(proposal, written, checked, proposed.remarks), checked)


def _solve(model: Model) -> Results:
    """Return the results of a model to the accuracy of a draft, unless it has elements of a given size."""
    if model.mesh.size is None and model.mesh.counts is None:
        model = model.replace(mesh=model.mesh.replace(accuracy=ACCURACIES["draft"]))
    return solve(model)


def _measure(proposal: Proposal, text: str, results: Results, remarks: tuple[str, ...] = ()) -> DesignAlternative:
    """Return an alternative with the utilizations and quantities of its results."""
    layouts = punching_links(results)
    borne = all(layout.perimeters for layout in layouts)
    masses = bars(results.model)["mass"] if results.model.reinforcement is not None else ()
    design = check_design(results)
    elements = next(iter(results.results.values()))
    area = areas(elements.plate.nodes[elements.plate.elements])
    return DesignAlternative(
        name=proposal.name,
        words=proposal.words,
        text=text,
        concrete=float(area @ elements.elements.thickness),
        bars=float(masses[-1] or 0) if masses else None,
        links=sum(layout.mass for layout in layouts) if borne else None,
        places_of_links=len(layouts),
        utilizations=_utilizations(design),
        settlement=max(float(result.plate.settlement.max()) for result in results.results.values()),
        status=design.status,
        notes=(
            *remarks,
            *(
                Message("no links at {name}: {why}", name=Name(layout.name), why=layout.why)
                for layout in layouts
                if not layout.perimeters
            ),
        ),
        within_error=_within_error(design),
    )


def _utilizations(design: Design) -> dict[str, float]:
    """Return the largest utilization of each kind of check that is not switched off, in the order of their list."""
    largest = dict[str, float]()
    for check in design.checks:
        if check.utilization is not None and check.off is None:
            largest[check.name] = max(check.utilization, largest.get(check.name, 0.0))
    return largest


def _within_error(design: Design) -> dict[str, float]:
    """Return the largest utilization within the error of each kind of check whose verdict hangs on it."""
    largest = dict[str, float]()
    for check in design.hanging:
        if check.between is not None:
            largest[check.name] = max(check.between[1], largest.get(check.name, 0.0))
    return largest


def _common_notes(model: Model) -> Iterator[str]:
    """Yield what holds for all alternatives."""
    if model.mesh.size is None and model.mesh.counts is None:
        yield "All are solved to the accuracy of a draft, which is 15 %; solve the one that is taken again."
    if model.reinforcement is None:
        yield "Without [reinforcement] neither bars nor links are counted."
