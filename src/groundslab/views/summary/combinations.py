"""The main figures of all combinations: each combination, and the extremes over them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from groundslab.errors import NotCertified
from groundslab.messages import Message, Name, joined, words_in
from groundslab.results.contact_zone import require_finite as require_one_finite
from groundslab.views.summary import sections
from groundslab.views.summary.rows import Row, SummarySection

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Iterator, Sequence

    from groundslab.errors import GroundslabError
    from groundslab.model.loads.load_cases import Combination
    from groundslab.results.results import CombinationResult, Results


@dataclass(frozen=True, slots=True)
class Entry:
    """One combination: its number from 1, what came out, and why that must not be used or is not there."""

    number: int
    combination: Combination
    results: CombinationResult | None  # of one that is refused only if it has results that are not certified
    refused: GroundslabError | None


@dataclass(frozen=True, slots=True)
class Extreme:
    """A row of the summary for the combination that governs it, by its number."""

    row: Row
    number: int


def entries(combined: Results) -> list[Entry]:
    """Return all combinations in the order in which they were solved."""
    listed = []
    for number, combination in enumerate(combined.combinations, 1):
        refused = combined.refused.get(combination.name)
        results = refused.results if isinstance(refused, NotCertified) else combined.results.get(combination.name)
        listed.append(Entry(number, combination, results, refused))
    return listed


def only(listed: Sequence[Entry]) -> CombinationResult | None:
    """Return the results of the only combination, certified or not; None if there are several, or no results."""
    return listed[0].results if len(listed) == 1 else None


def require_finite(combined: Results) -> None:
    """Raise GroundslabError if any number of any combination's results is infinite or not a number."""
    for entry in entries(combined):
        if entry.results is not None:
            require_one_finite(entry.results)


def factors_text(combination: Combination) -> str:
    """Return the factors and cases of a combination in words, such as "1.35 dead + 1.5 live"."""
    return joined(
        (
            Message("{factor:.6g} {name}" if name else "{factor:.6g}", factor=factor, name=Name(name))
            for name, factor in combination.factors
        ),
        " + ",
    )


def case_lines(combined: Results) -> list[str]:
    """Return where each load case acts, in words, and the remarks on the case that no other section has."""
    from groundslab.model.remarks.case_use import case_uses
    from groundslab.model.remarks.remarks import find_remarks

    units = combined.model.units
    uses = case_uses(combined.model, combined.combinations)
    remarks = find_remarks(combined.model, combined.combinations)
    return [
        *(
            Message("{name} ({about}): {words}", name=Name(use.case.name), about=use.about(), words=use.words())
            for use in uses
        ),
        *(
            words_in(Message("remark: {words}", words=remark.words), units)
            for remark in remarks
            if not remark.doubtful and remark.path[0] != "loads"
        ),
    ]


def refusal_sentences(combined: Results) -> Iterator[str]:
    """Yield in which combinations the foundation fails, and which the program could not solve."""
    if combined.without_equilibrium:
        which = _some_of(combined, combined.without_equilibrium)
        yield Message("FOUNDATION FAILS: no equilibrium{which}.", which=which)
    if combined.unsolved and len(combined.combinations) == 1:
        yield "FAILED: the certificate does not hold; do not use the result."
    elif combined.unsolved:
        yield Message("FAILED: no certified result{which}.", which=_some_of(combined, combined.unsolved))


def _some_of(combined: Results, names: Collection[str]) -> str:
    """Return which of several combinations are meant, by their numbers; nothing of an only one."""
    count = len(combined.combinations)
    if count == 1:
        return ""
    numbers = [str(number) for number, combination in enumerate(combined.combinations, 1) if combination.name in names]
    template = " in {some} of {count} combinations, number {numbers}"
    return Message(template, some=len(numbers), count=count, numbers=joined(numbers))


def description(combined: Results) -> list[SummarySection]:
    """Return the sections on the model; of the ground only what is the same in all combinations."""
    solved = [entry.results for entry in entries(combined) if entry.results is not None]
    plate, mesh, ground, *cut = sections.description(solved[0])
    others = [sections.description_of_ground(results).rows for results in solved[1:]]
    same = tuple(row for row in ground.rows if all(row in rows for rows in others))
    notes = ground.notes
    if len(same) < len(ground.rows):
        notes += ("The ground's other constants depend on the combination; summary.json has them.",)
    return [plate, mesh, replace(ground, rows=same, notes=notes), *cut]


def extremes(
    combined: Results, limit_states: Sequence[str] | None = None
) -> list[tuple[SummarySection, tuple[Extreme, ...]]]:
    """Return the sections of figures, each with its rows' extremes over certified combinations.

    Those of some limit states, or all by default.

    The largest governs, of a row called smallest and of the share in contact the smallest; the first of equal ones.
    """
    by_section: dict[str, tuple[SummarySection, dict[str, Extreme]]] = {}
    for number, results in _certified(combined):
        if limit_states is not None and results.limit_state not in limit_states:
            continue
        for section in sections.figures(results):
            earlier, rows = by_section.setdefault(section.key, (section, {}))
            notes = tuple(dict.fromkeys((*earlier.notes, *section.notes)))
            by_section[section.key] = replace(earlier, notes=notes), rows
            _collect_extremes(rows, section.rows, number)
    return [(section, tuple(rows.values())) for section, rows in by_section.values()]


def _certified(combined: Results) -> Iterator[tuple[int, CombinationResult]]:
    """Yield the certified results with the numbers of their combinations."""
    for entry in entries(combined):
        if entry.results is not None and entry.refused is None:
            yield entry.number, entry.results


def _collect_extremes(by_key: dict[str, Extreme], rows: Iterable[Row], number: int) -> None:
    """Put the rows of a combination among the extremes by their keys, each that governs the one there."""
    for row in rows:
        if row.key not in by_key or _governs(row, by_key[row.key].row):
            by_key[row.key] = Extreme(row, number)


def _governs(row: Row, other: Row) -> bool:
    """Return whether a row is more extreme than another of the same key."""
    a, b = row.value, other.value
    assert not isinstance(a, str)
    assert not isinstance(b, str)
    return a < b if row.key == "share" or row.key.startswith("smallest") else a > b


def worst(combined: Results) -> tuple[Extreme, ...]:
    """Return of each figure that must vanish, and of the margin's effect, the largest over the certified ones."""
    by_key: dict[str, Extreme] = {}
    for number, results in _certified(combined):
        rows = sections.certificate_section(results).rows
        _collect_extremes(by_key, (row for row in rows if row.key not in ("load", "reaction")), number)
    return tuple(by_key.values())
