"""The table of reinforcement: what each layer of bars needs over all ultimate combinations, where, and why."""

from __future__ import annotations

from groundslab.design.bars.required_bars import Need, governing_needs, section_name
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.support_moments import moments_at_supports
from groundslab.design.rules.combinations import UNFACTORED, ultimate_results, without_partial_factors
from groundslab.messages import Clause, Message, Name
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results
from groundslab.views.tables.table import Cell, Table, table_of

#: From m2/m to cm2/m.
CM2 = 1e4


def reinforcement(combined: Results, steel: Reinforcement) -> Table:
    """Return the largest required area of each layer of bars in each section, over all ultimate combinations."""
    heads = [
        ("layer", ""), ("section", ""), ("required area", "cm2/m"), ("governed by", ""), ("x", "m"), ("y", "m"),
        ("combination", ""), ("design moment", "kNm/m"), ("peak moment", "kNm/m"), ("thickness", "m"),
        ("minimum area", "cm2/m"), ("part of the plate that fails", "%"), ("part of the plate that needs links", "%"),
    ]  # fmt: skip
    rows = [_row(need) for need in governing_needs(combined, steel)]
    code = code_of(steel)
    least, held = code.clauses.least_bars, code.clauses.held_bars
    notes = [
        Message(
            "By {name} for Wood's design moments in each ultimate combination, {supports}. "
            "The required area is not less than the minimum of {least} where there is a moment.",
            name=Name(code.name),
            supports=averages(steel),
            least=least,
        ),
        "Place, combination and design moment are those that govern the area; where it is governed by the minimum, "
        "those of the largest moment. The design moment is positive with tension at the bottom: for bars in "
        "compression it is that of the other face. The peak moment is the largest at a node of the section, which is "
        "not averaged.",
        Message(
            "inf: the concrete is too weak in bending for any reinforcement. Links must hold bars in "
            "compression ({held}) where these are counted on.",
            held=held,
        ),
        Message(
            "Minimum area of tension bars by {least} for the section. Crack widths, shear and punching are not in it.",
            least=least,
        ),
    ]
    if not rows:
        notes.insert(0, "No ultimate combination has a result.")
    if without_partial_factors(combined):
        notes.append(UNFACTORED)
    return table_of("reinforcement", "Reinforcement", heads, rows, notes)


def averages(steel: Reinforcement) -> str:
    """Return what moments at supports are, in words."""
    rule = steel.averaging
    width = (
        Message("the mean over {width:g m} of those at the face", width=rule.width)
        if isinstance(rule.width, float)
        else Message("the mean over {width} of those at the face", width=Clause(rule.width))
    )
    columns = {"width": width, "face": "those at the face", "peak": "those at nodes"}[rule.at_columns]
    walls = {"face": "those at the face", "quarter": "those half way from the axis to the face",
             "peak": "those at nodes"}[rule.at_walls]  # fmt: skip
    words = Message("at columns, piles and ends of walls {columns}, across walls {walls}", columns=columns, walls=walls)
    if rule.by == "strip":
        words += Message(", in design strips the mean over their width")
    return words


def support_moments(combined: Results, steel: Reinforcement) -> Table:
    """Return the largest design moment at each support, as it counts and at the nodes near it."""
    heads = [
        ("support", ""), ("bars", ""), ("moment at the support", "kNm/m"), ("width", "m"), ("x", "m"), ("y", "m"),
        ("combination", ""), ("peak moment", "kNm/m"), ("x of the peak", "m"), ("y of the peak", "m"),
        ("part of the peak", "%"),
    ]  # fmt: skip
    rows = [
        [
            line.support, line.layer.replace("_", " "), line.moment / 1e3, line.width or None, *line.place,
            line.combination, line.peak / 1e3, *line.peak_place, 100 * line.moment / line.peak if line.peak else None,
        ]
        for line in moments_at_supports(ultimate_results(combined), steel)
    ]  # fmt: skip
    notes = [
        Message("Wood's design moments, {supports}.", supports=averages(steel)),
        "Of bars along x and along y, at the top or at the bottom, the larger one over all ultimate combinations. "
        "Lines run across the bars, from the face of the support to where its width ends, and end at edges, openings, "
        "joints and steps; the place is the middle of the line that governs. The peak is the largest at the nodes "
        "beside it in that combination.",
    ]
    return table_of("support_moments", "Design moments at supports", heads, rows, notes)


def _row(need: Need) -> list[Cell]:
    """Return a row of the table."""
    x, y = need.place or (None, None)
    moment, peak = (None if value is None else value / 1e3 for value in (need.moment, need.peak))
    return [
        need.layer.replace("_", " "), section_name(need.section), need.area * CM2, need.governed_by or None, x, y,
        need.combination, moment, peak, need.thickness, need.minimum * CM2, need.fails * 100, need.links * 100,
    ]  # fmt: skip
