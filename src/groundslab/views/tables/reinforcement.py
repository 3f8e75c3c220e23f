"""The table of reinforcement: what each layer of bars needs over all ultimate combinations, where, and why."""

from __future__ import annotations

from groundslab.design.bars.required_bars import Need, governing_needs, section_name
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.combinations import UNFACTORED, without_partial_factors
from groundslab.messages import Message, Name
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results
from groundslab.views.tables.table import Cell, Table, table_of

#: From m2/m to cm2/m.
CM2 = 1e4


def reinforcement(combined: Results, steel: Reinforcement) -> Table:
    """Return the largest required area of each layer of bars in each section, over all ultimate combinations."""
    heads = [
        ("layer", ""), ("section", ""), ("required area", "cm2/m"), ("governed by", ""), ("x", "m"), ("y", "m"),
        ("combination", ""), ("design moment", "kNm/m"), ("thickness", "m"), ("minimum area", "cm2/m"),
        ("part of the plate that fails", "%"), ("part of the plate that needs links", "%"),
    ]  # fmt: skip
    rows = [_row(need) for need in governing_needs(combined, steel)]
    code = code_of(steel)
    least, held = code.clauses.least_bars, code.clauses.held_bars
    notes = [
        Message(
            "By {name} for Wood's design moments of each node in each ultimate combination, not of averages. "
            "The required area is not less than the minimum of {least} where there is a moment.",
            name=Name(code.name),
            least=least,
        ),
        "Place, combination and design moment are those that govern the area; where it is governed by the minimum, "
        "those of the largest moment. The design moment is positive with tension at the bottom: for bars in "
        "compression it is that of the other face.",
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


def _row(need: Need) -> list[Cell]:
    """Return a row of the table."""
    x, y = need.place or (None, None)
    moment = None if need.moment is None else need.moment / 1e3
    return [
        need.layer.replace("_", " "), section_name(need.section), need.area * CM2, need.governed_by or None, x, y,
        need.combination, moment, need.thickness, need.minimum * CM2, need.fails * 100, need.links * 100,
    ]  # fmt: skip
