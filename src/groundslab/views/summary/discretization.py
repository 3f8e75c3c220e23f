"""What the summary says of discretization errors: of each figure, and whether the mesh is too coarse."""

from __future__ import annotations

from dataclasses import replace
from operator import attrgetter
from typing import TYPE_CHECKING

from groundslab.accuracy.judgment import JudgedValue, judge
from groundslab.accuracy.values import error_of_contact_share, error_of_largest, estimate_error
from groundslab.messages import Message, capitalized, counted, joined, words_in
from groundslab.units import UNITS
from groundslab.views.summary.rows import Row, SummarySection

if TYPE_CHECKING:
    from groundslab.results.results import CombinationResult, Results

#: Above this error, as a share of what governs, a certified result has no value that could be used.
UNKNOWN = 0.5


def with_error(row: Row, coarser: Row | None, results: CombinationResult) -> Row:
    """Return a figure with its discretization error, if the next coarser mesh has one to compare."""
    if coarser is None or isinstance(row.value, int | str) or isinstance(coarser.value, int | str):
        return row
    assert results.comparison is not None
    if row.label == "plate's area in contact":
        return replace(row, error=error_of_contact_share(results))
    if row.values is None or coarser.values is None:
        return replace(row, error=estimate_error(row.value, coarser.value, results.comparison))
    error = error_of_largest(results, row.of, row.values, coarser.values)
    return replace(row, error=error, values=None)


def discretization_section(results: CombinationResult) -> SummarySection:
    """Return the discretization error in energy, and the largest of the values that are judged."""
    assert results.comparison is not None
    rows = [Row("energy", "error in energy norm", results.comparison.energy_error, UNITS["%"])]
    judged = judge(results)
    if judged:
        rows.append(
            Row(
                "largest_error",
                joined(("largest error", judged[0].label)),
                judged[0].share,
                UNITS["%"],
                "",
                judged[0].place,
            )
        )
    notes = _not_judged(results)
    if judged and judged[0].share > results.model.mesh.largest_error:
        notes = (
            *notes,
            Message(
                "The mesh is too coarse for errors of {asked:g} % (mesh.accuracy): {remedy} Errors are estimated from "
                "the same analysis on elements twice as large.",
                asked=100 * results.model.mesh.largest_error,
                remedy=_remedy(results),
            ),
        )
    return SummarySection("discretization", "Discretization error", tuple(rows), notes)


def unknown_words(results: CombinationResult) -> str:
    """Return in words that the discretization error is not known, and why, or "" where it is."""
    if results.coarser is not None:
        return ""
    if not results.mesh_plan.has_coarser:
        reason = "the mesh has too few elements to compare with elements twice as large"
    elif results.ground.cells is None:
        reason = "there is no solution on elements twice as large"
    else:
        reason = (
            "there is no solution on elements twice as large; the slab may bend within one of these, or within one of "
            "the cells through which it presses on the ground"
        )
    return Message("The discretization error is not known: {reason}. Reduce mesh.size and compare.", reason=reason)


def _not_judged(results: CombinationResult) -> tuple[str, ...]:
    """Return in words which values are not among those that are judged, nothing where all are."""
    from groundslab.accuracy.singularities import find_limits

    limits = find_limits(results.solved_model, results.plate)
    words = {
        "shear forces along edges, around footprints, over webs of beams, next to walls and where they are singular": (
            limits.shear_forces
        ),
        "pressures where they jump or have no limit": limits.pressures | ~limits.shear_forces,
    }
    left_out = [text for text, judged in words.items() if not judged.all()]
    return (Message("Not judged within a thickness: {values}.", values=joined(left_out, "; ")),) if left_out else ()


def _remedy(results: CombinationResult) -> str:
    """Return the advice that makes the errors smaller, or why the mesh was not refined further."""
    history = results.mesh_history
    if not results.model.mesh.adaptive:
        return "reduce mesh.size, or omit it and set mesh.accuracy."
    if history is None:
        return "it was made for another case, and mesh.accuracy there makes it finer."
    if history.end == "provisional":
        return Message("it is mesh {number} and still to be refined.", number=len(history.unknowns))
    if history.end == "max_unknowns":
        most = results.model.mesh.max_unknowns
        return Message(
            "it was not refined further because of mesh.max_unknowns = {most}; the next mesh takes "
            "mesh.max_unknowns = {needed}.",
            most=most,
            needed=round_up(history.needed or most),
        )
    if history.end == "no progress":
        return "it was refined until this error fell no more."
    if history.end == "accurate":
        return "it was fine enough for all that is judged; [[mesh.refine]] makes elements smaller."
    return Message("{count} meshes were made, and no more are.", count=len(history.unknowns))


def round_up(count: int) -> int:
    """Return a count rounded up to two digits."""
    step = int(10 ** max(len(str(count)) - 2, 0))
    return -(-count // step) * step


def _worst(combined: Results) -> JudgedValue | None:
    """Return the judged value of all combinations with the largest error, None where no error is known."""
    judged = [judgment for results in combined.values() for judgment in judge(results)[:1]]
    return max(judged, key=attrgetter("share"), default=None)


def provisional_words(combined: Results) -> str:
    """Return in words that provisional results are so, how far they are off and what is asked for, "" for others."""
    if not combined.provisional:
        return ""
    first, worst = next(iter(combined.values())), _worst(combined)
    assert first.mesh_history is not None
    error: str = "; its errors come then"
    if worst:
        error = Message(
            ": largest error {share:.2g} % ({label}), {asked:g} % asked for",
            share=100 * worst.share, label=worst.label, asked=100 * combined.model.mesh.largest_error,
        )  # fmt: skip
    return Message(
        "Provisional: mesh {number} ({unknowns:,} unknowns) is still to be refined{error}.",
        number=len(first.mesh_history.unknowns), unknowns=first.unknowns, error=error,
    )  # fmt: skip


def is_unknown(combined: Results) -> bool:
    """Return whether an error is so large that the values of a certified result are still not known."""
    worst = _worst(combined)
    return worst is not None and worst.share > UNKNOWN and not combined.provisional


def coarse_words(combined: Results) -> str:
    """Return in words that the mesh is too coarse for the accuracy asked for or provisional, or its error not known.

    "" where none of these is true.
    """
    return words_in(_coarse_words(combined), combined.model.units)


def _coarse_words(combined: Results) -> str:
    """Return `coarse_words` in SI units."""
    from groundslab.accuracy.resolution import find_unresolved

    if combined.provisional:
        return provisional_words(combined)
    worst = _worst(combined)
    if worst is not None and is_unknown(combined):
        return Message(
            "Do not use these results: they satisfy equilibrium and contact conditions on a mesh that is far too "
            "coarse to tell values. The largest discretization error is {share:.2g} % ({label}). {remedy}",
            share=100 * worst.share, label=worst.label, remedy=capitalized(_remedy(next(iter(combined.values())))),
        )  # fmt: skip
    for results in combined.values():
        small = find_unresolved(results)
        if small is not None:
            return Message(
                "The mesh is too coarse for the footprint of {forces}: {footprint:.3g m} in elements of "
                "{element:.3g m}. Moments and shear forces there are too small. {remedy}",
                forces=counted(small.count, "a force", "{count} forces"),
                footprint=small.footprint, element=small.element, remedy=capitalized(_remedy(results)),
            )  # fmt: skip
    if worst is None or worst.share <= combined.model.mesh.largest_error:
        return _hanging_words(combined) or next(filter(None, map(unknown_words, combined.values())), "")
    return Message(
        "The mesh is too coarse: the largest discretization error is {share:.2g} % ({label}), more than {asked:g} %. "
        "{remedy}",
        share=100 * worst.share, label=worst.label, asked=100 * combined.model.mesh.largest_error,
        remedy=capitalized(_remedy(next(iter(combined.values())))),
    )  # fmt: skip


def _hanging_words(combined: Results) -> str:
    """Return in words that the verdict of a check hangs on an error above the accuracy asked for, else ""."""
    from groundslab.design.checks import check_design

    for check in check_design(combined).hanging:
        error = check.utilization_error or 0.0
        if error > combined.model.mesh.largest_error:
            return Message(
                "The mesh is too coarse for a check: {name} is {used:.2f} +- {error:.2g} times its limit. {remedy}",
                name=check.name, used=check.utilization or 0.0, error=error,
                remedy=capitalized(_remedy(next(iter(combined.values())))),
            )  # fmt: skip
    return ""


def largest_error(results: CombinationResult) -> tuple[Row, ...]:
    """Return the largest discretization error beside the accuracy asked for, nothing where there is none to tell."""
    judged, accuracy = judge(results), results.model.mesh.largest_error
    if not judged:
        return ()
    worst, words = judged[0], "largest discretization error"
    ok = True if worst.share <= accuracy else None
    return (Row("discretization_error", words, worst.share, UNITS["%"], "", worst.place, tolerance=accuracy, ok=ok),)
