"""The bending schedule: bars and links as they are cut and bent, with their masses by diameter and altogether."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from groundslab.design.bars.bending import CLOSED, LINKS, BentBar, bent_bars
from groundslab.design.bars.positions import positions
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.messages import Clause, Message
from groundslab.model.model import Model
from groundslab.views.tables.table import Cell, Head, Table, table_of

NAME, TITLE = "bending_schedule", "Bending schedule"
MM = 1e3
#: How bars are measured, by units.
MEASURED = {
    "SI": "Lengths to the millimeter, the sum of the outer sides: bends take nothing off, and hooks end at the outer "
    "tangent of their bend. Of U-shaped bars a and c are the legs, of closed links a is across and b upright. "
    "Steel of 7850 kg/m3 (EN 1992-1-1 3.2.7(3)).",
    "US": "Straight bars to the inch, sides of bent ones and their hooks to a quarter of an inch; lengths are the sum "
    "of the outer sides: bends take nothing off, and hooks end at the outer tangent of their bend. Of U-shaped bars a "
    "and c are the legs, of closed links a is across and b upright. Steel of 7850 kg/m3 (EN 1992-1-1 3.2.7(3)).",
}
#: What bars are where a case says nothing of laps and edges.
NO_DETAILING = "Without reinforcement.detailing there are no laps in it, no bars around edges, and bars end at edges."
#: What rows of sums say where others have a layer.
SUM = "all bars"
HEADS: tuple[Head, ...] = (
    ("mark", ""), ("layer", ""), ("shape", ""), ("diameter", "mm"), ("number", ""), ("a", "mm"), ("b", "mm"),
    ("c", "mm"), ("hook", "mm"), ("right-angled hook", "mm"), ("mandrel", "mm"), ("length", "m"),
    ("total length", "m"), ("mass", "kg"),
)  # fmt: skip


def bending_schedule(model: Model, links: Sequence[LinkLayout] = ()) -> Table:
    """Return the bars and links that are cut and bent, then what bars of each diameter weigh, and all of them."""
    listed = bent_bars(model, links)
    rows = [_row(bar) for bar in listed]
    sizes = sorted({bar.diameter for bar in listed})
    rows += [_sum([bar for bar in listed if bar.diameter == size], size) for size in sizes]
    if rows:
        rows.append(_sum(listed, None))
    return table_of(NAME, TITLE, HEADS, rows, list(_notes(model, listed)))


def _row(bar: BentBar) -> list[Cell]:
    """Return the row of bars that are alike."""
    sides: list[Cell] = [side * MM for side in bar.sides]
    hooks: list[Cell] = [hook * MM for hook in bar.hooks[: 1 if bar.shape == CLOSED else None]]
    return [
        bar.mark, bar.layer, bar.shape, bar.diameter * MM, bar.number, *_filled(sides, 3), *_filled(hooks, 2),
        None if bar.mandrel is None else bar.mandrel * MM, bar.length, bar.total, bar.mass,
    ]  # fmt: skip


def _filled(cells: list[Cell], count: int) -> list[Cell]:
    """Return cells, with empty ones behind them."""
    return [*cells, *[None] * (count - len(cells))]


def _sum(bars: Sequence[BentBar], diameter: float | None) -> list[Cell]:
    """Return the row of what bars are and weigh together."""
    size = None if diameter is None else diameter * MM
    number = sum(bar.number for bar in bars)
    total, mass = (sum(getattr(bar, of) for bar in bars) for of in ("total", "mass"))
    return [None, SUM, None, size, number, *[None] * 7, total, mass]


def _notes(model: Model, listed: Sequence[BentBar]) -> Iterator[str]:
    """Yield what a reader must know."""
    yield MEASURED[model.units]
    steel = model.reinforcement
    if steel is None or not steel.laid:
        return
    detailing = code_of(steel).detailing
    if detailing is None:
        yield "Mandrels, and hooks of links, are not in it: the code's rules for them are not known here."
    elif any(bar.layer == LINKS for bar in listed):
        yield Message(
            "Mandrels and hooks of links are the least ones ({clauses}).", clauses=Clause(detailing.bends.clauses)
        )
    else:
        yield Message("Mandrels are the least ones ({clauses}).", clauses=Clause(detailing.bends.clauses))
    if steel.detailing is None:
        yield NO_DETAILING
    if mass := sum(position.mass for position in positions(model) if position.mesh):
        yield Message(
            "Welded meshes are delivered as sheets and are not in it: their wires, {mass:.5g kg}, are in the table "
            "bars.",
            mass=mass,
        )
