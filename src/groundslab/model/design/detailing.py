"""How laid bars are cut, lapped and held at edges, and which bars may be proposed."""

from __future__ import annotations

from typing import Annotated

from groundslab.model.design.bars import APART, BAR
from groundslab.schema.base import Section
from groundslab.schema.fields import Boolean, Integer, ListOf, Number, Quantity
from groundslab.schema.ranges import Range

#: Lengths that bars are delivered in, and by which zones are rounded [m].
STOCK, STEP = Range(at_least=1.0, at_most=30.0), Range(at_least=0.01, at_most=10.0)
#: Zones of one layer at most.
MOST_ZONES = 50


class Detailing(Section):
    """Laps, covers at ends and U-shaped bars at free edges, which the quantities and the drawing then have."""

    bar_length: Annotated[
        float, Quantity("length", "", "of bars as they are delivered; longer ones are lapped", STOCK)
    ] = 12.0
    edge_bars: Annotated[
        bool, Boolean("whether U-shaped bars hold the edges and openings, one at each end of a bar there")
    ] = True


class AllowedBars(Section):
    """What bars may be proposed: a base over the slab in each layer, zones of additional bars, and links."""

    diameters: Annotated[
        tuple[float, ...],
        ListOf(Quantity("length", "phi", "", BAR), "phi", "diameters of the bars", rising=True),
    ] = (0.010, 0.012, 0.014, 0.016, 0.020, 0.025)
    spacings: Annotated[
        tuple[float, ...],
        ListOf(
            Quantity("length", "s", "", APART),
            "s",
            "spacings of the base; zones have the same, half or twice of it",
            rising=True,
        ),
    ] = (0.100, 0.125, 0.150, 0.175, 0.200, 0.225, 0.250)
    most_zones: Annotated[int, Integer("zones of additional bars in a layer", at_least=0, at_most=MOST_ZONES)] = 6
    least_saving: Annotated[
        float,
        Number("", "share of a layer's steel that each zone must save", Range(at_least=0, at_most=1)),
    ] = 0.02
    rounding: Annotated[
        float, Quantity("length", "", "zones' borders lie at multiples of it from the slab's lower left corner", STEP)
    ] = 0.25
    link_diameters: Annotated[
        tuple[float, ...],
        ListOf(Quantity("length", "phi_w", "", BAR), "phi_w", "diameters of links against punching", rising=True),
    ] = (0.008, 0.010, 0.012, 0.014, 0.016)
    least_size: Annotated[float, Quantity("length", "", "least length and width of a zone", STEP)] = 1.0
