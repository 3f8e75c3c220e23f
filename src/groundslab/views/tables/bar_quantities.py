"""The table of bars that are laid: how many of which length, and what they weigh, position by position."""

from __future__ import annotations

from collections.abc import Sequence

from groundslab.design.bars.bending import LINKS, BentBar, bent_links, marked_further_links, marked_links
from groundslab.design.bars.further_links import LaidLinks
from groundslab.design.bars.positions import MOST_LENGTHS, Position, positions
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.messages import Message, joined
from groundslab.model.model import Model
from groundslab.model.plates.region import PlateRegion
from groundslab.views.tables.table import Cell, Table, table_of

MM = 1e3
#: What a reader must know of links.
LINKS_NOTE = "Links are those of the table shear_reinforcement, here with the hooks that the bending schedule has."
FURTHER_NOTE = "Links of beams are closed, with their inner legs and hooks; legs in the slab have hooks too."


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
    bent, further = bent_links(model, links, listed), marked_further_links(model, links, listed)
    for mark, layout in marked_links(links, listed).items():
        rows.append([mark, LINKS, layout.where, None, "leg", *_of_links(layout, None, bent[mark], area)])
    for mark, laid in further.items():
        rows.append([mark, LINKS, laid.name, None, laid.shape, *_of_links(laid, laid.spacing, bent[mark], area)])
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


def _of_links(links: LaidLinks | LinkLayout, spacing: float | None, bent: Sequence[BentBar], area: float) -> list[Cell]:
    """Return the row of links from their diameter on, by what they are bent to; inner legs belong to their link."""
    total, mass = (sum(getattr(bar, of) for bar in bent) for of in ("total", "mass"))
    length = total / links.number
    apart = None if spacing is None else spacing * MM
    return [links.diameter * MM, apart, links.number, length, length, None, total, mass, mass / area]


def _row(position: Position, area: float) -> list[Cell]:
    """Return the row of a position on a slab of some area [m2]."""
    lengths = position.lengths
    return [
        position.mark, position.layer.replace("_", " "), position.zone or None, position.mesh or None, position.shape,
        position.bars.diameter * MM, position.bars.spacing * MM, len(lengths), float(lengths.min()),
        float(lengths.max()), position.lap, position.total, position.mass, position.mass / area,
    ]  # fmt: skip
