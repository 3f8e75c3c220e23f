"""How laid bars are cut, lapped and held at edges, and which bars may be proposed."""

from __future__ import annotations

from typing import Annotated

from groundslab.model.design.bars import APART, Diameter
from groundslab.schema.base import Section
from groundslab.schema.fields import Boolean, Integer, ListOf, Number, Quantity
from groundslab.schema.ranges import Range
from groundslab.unit_systems import FOOT, INCH, System

#: Lengths that bars are delivered in, and by which zones are rounded [m].
STOCK, STEP = Range(at_least=1.0, at_most=30.0), Range(at_least=0.01, at_most=10.0)
#: Zones of one layer at most.
MOST_ZONES = 50


class Detailing(Section):
    """Laps, covers at ends and U-shaped bars at free edges, which the quantities and the drawing then have."""

    bar_length: Annotated[
        float, Quantity("length", "", "of bars as they are delivered; longer ones are lapped", STOCK, example="12 m")
    ] = 12.0
    edge_bars: Annotated[
        bool, Boolean("whether U-shaped bars hold the edges and openings, one at each end of a bar there")
    ] = True


class AllowedBars(Section):
    """What bars may be proposed: a base over the slab in each layer, zones of additional bars, and links."""

    diameters: Annotated[
        tuple[float, ...],
        ListOf(
            Diameter(),
            "phi",
            "diameters of the bars; with US units by default #4 to #8",
            rising=True,
        ),
    ] = (0.008, 0.010, 0.012, 0.014, 0.016, 0.020, 0.025)
    spacings: Annotated[
        tuple[float, ...],
        ListOf(
            Quantity("length", "s", "", APART, example="150 mm"),
            "s",
            "spacings of the base; zones have the same, half or twice of it; with US units by default 4 in to 12 in",
            rising=True,
        ),
    ] = (0.100, 0.125, 0.150, 0.175, 0.200, 0.225, 0.250)
    most_zones: Annotated[int, Integer("zones of additional bars in a layer", at_least=0, at_most=MOST_ZONES)] = 12
    least_saving: Annotated[
        float,
        Number("", "share of a layer's steel that each zone must save", Range(at_least=0, at_most=1)),
    ] = 0.01
    rounding: Annotated[
        float,
        Quantity(
            "length",
            "",
            "zones' borders lie at multiples of it from the slab's lower left corner, or from its middle where the "
            "zones are symmetric; with US units by default 1 ft",
            STEP,
            example="50 mm",
        ),
    ] = 0.25
    link_diameters: Annotated[
        tuple[float, ...],
        ListOf(
            Diameter(symbol="phi_w"),
            "phi_w",
            "diameters of links against punching; with US units by default #3 to #5",
            rising=True,
        ),
    ] = (0.008, 0.010, 0.012, 0.014, 0.016)
    least_size: Annotated[
        float,
        Quantity("length", "", "least length and width of a zone; with US units by default 4 ft", STEP, example="1 m"),
    ] = 1.0


#: What may be proposed by default where results are shown in US units.
_US = AllowedBars(
    diameters=("#4", "#5", "#6", "#7", "#8"),
    spacings=tuple(round(inches * INCH, 6) for inches in (4, 5, 6, 8, 9, 10, 12)),
    link_diameters=("#3", "#4", "#5"),
    rounding=FOOT,
    least_size=4 * FOOT,
)


def allowed_bars(proposal: AllowedBars, units: System) -> AllowedBars:
    """Return what may be proposed: as given, the rest by default in sizes that are usual where the units are."""
    if units == "SI":
        return proposal
    return proposal.replace(**{name: getattr(_US, name) for name in _US.model_fields_set - proposal.model_fields_set})
