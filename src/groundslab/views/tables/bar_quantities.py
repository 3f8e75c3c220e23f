"""The table of bars that are laid: how many of which length, and what they weigh, position by position."""

from __future__ import annotations

from collections.abc import Sequence

from groundslab.design.bars.bending import LINKS, marked_further_links, marked_links
from groundslab.design.bars.further_links import LaidLinks
from groundslab.design.bars.positions import MOST_LENGTHS, Position, positions
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.messages import Message, joined
from groundslab.model.model import Model
from groundslab.model.plates.region import PlateRegion
from groundslab.views.tables.table import Cell, Table, table_of

MM = 1e3
#: What a reader must know of links.
LINKS_NOTE = "Links are those of the table shear_reinforcement: proposed, vertical legs without hooks."
FURTHER_NOTE = "Links of beams are closed, with their inner legs; of them and of legs in the slab hooks are not in it."


def bars(model: Model, links: Sequence[LinkLayout] = ()) -> Table:
    """Return the quantities of the bars provided, and of links against punching, with their sum in the last row."""
    heads = [
        ("mark", ""), ("layer", ""), ("zone", ""), ("welded mesh", ""), ("shape", ""), ("diameter", "mm"),
        ("spacing", "mm"), ("number", ""), ("least length", "m"), ("greatest length", "m"), ("lap", "m"),
        ("total length", "m"), ("mass", "kg"), ("mass per area", "kg/m2"),
    ]  # fmt: skip
    area = PlateRegion(model.plate, model.plates).area.area
    listed = positions(model)
    rows = [_row(position, area) for position in listed]
    rows += [_link_row(layout, mark, area) for mark, layout in marked_links(links, listed).items()]
    further = marked_further_links(model, links, listed)
    rows += [_further_row(laid, mark, area) for mark, laid in further.items()]
    if rows:
        number, length, mass, share = (sum(float(row[i] or 0) for row in rows) for i in (7, 11, 12, 13))
        rows.append([None, "all layers", *[None] * 5, round(number), None, None, None, length, mass, share])
    detailing = None if model.reinforcement is None else model.reinforcement.detailing
    cut = "Straight bars, cut by the outline, by openings and by the borders of zones; of meshes their wires."
    rest = (
        "Laps, hooks, bars around edges and openings, spacers and waste are not in it, and the cover at the ends "
        "of bars is not taken off."
        if detailing is None
        else Message(
            "They end the cover before edges, and lap where they are longer than {bar_length:g m}, all in "
            "one section; bars of U shape, whose laps are the legs, hold the ends at edges. Trimmers of "
            "openings, spacers and waste are not in it, nor laps of meshes.",
            bar_length=detailing.bar_length,
        )
    )
    notes = [
        Message(
            "{cut} Steel of 7850 kg/m3 (EN 1992-1-1 3.2.7(3)); the mass per area is over all of the slab.",
            cut=joined((cut, rest), " "),
        ),
        *([LINKS_NOTE] if any(layout.perimeters for layout in links) else []),
        *([FURTHER_NOTE] if further else []),
        Message(
            "Of a set with more than {most_lengths} different lengths there is one row.", most_lengths=MOST_LENGTHS
        ),
    ]
    return table_of("bars", "Bars provided", heads, rows, notes)


def _further_row(laid: LaidLinks, mark: int, area: float) -> list[Cell]:
    """Return the row of the links of one beam, or of one part of the slab."""
    return [
        mark, LINKS, laid.name, None, laid.shape, laid.diameter * MM, laid.spacing * MM, laid.number,
        laid.length, laid.length, None, laid.total, laid.mass, laid.mass / area,
    ]  # fmt: skip


def _link_row(layout: LinkLayout, mark: int, area: float) -> list[Cell]:
    """Return the row of the links around one column, pile or end of a wall."""
    return [
        mark, LINKS, layout.where, None, "leg", layout.diameter * MM, None, layout.number,
        layout.leg, layout.leg, None, layout.total, layout.mass, layout.mass / area,
    ]  # fmt: skip


def _row(position: Position, area: float) -> list[Cell]:
    """Return the row of a position on a slab of some area [m2]."""
    lengths = position.lengths
    return [
        position.mark, position.layer.replace("_", " "), position.zone or None, position.mesh or None, position.shape,
        position.bars.diameter * MM, position.bars.spacing * MM, len(lengths), float(lengths.min()),
        float(lengths.max()), position.lap, position.total, position.mass, position.mass / area,
    ]  # fmt: skip
