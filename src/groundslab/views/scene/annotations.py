"""What a scene writes beside fields: what supports and walls do to the plate, and the bars that are laid."""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.design.bars.bar_layout import BarSet, bar_sets
from groundslab.unit_systems import bars_at
from groundslab.views.reactions import support_reactions, wall_reactions

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

    from groundslab.model.model import Model
    from groundslab.results.results import CombinationResult
    from groundslab.unit_systems import System

#: Digits after the point of a length in meters.
DIGITS = 6


def reactions_of(results: CombinationResult) -> list[dict[str, Any]]:
    """Return where each support and each wall is [m], and its force with an arrow in its sense."""
    units = results.model.units
    return [
        {
            "at": [*np.round(reaction.place, DIGITS)],
            "text": f"{reaction.arrow} {reaction.words(units, signed=False)}".strip(),
        }
        for reaction in chain(support_reactions(results), wall_reactions(results))
    ]


def bars_of(model: Model) -> list[dict[str, Any]]:
    """Return each set of bars that is laid: its layer, its zone, where it lies, a place for its words [m], these."""
    from shapely import unary_union

    sets = bar_sets(model)
    zones = {
        layer: [bar_set.region for bar_set in sets if bar_set.layer == layer and bar_set.zone]
        for layer in {bar_set.layer for bar_set in sets}
    }
    described = []
    for bar_set in (bar_set for bar_set in sets if not bar_set.region.is_empty):
        free = bar_set.region if bar_set.zone else bar_set.region.difference(unary_union(zones[bar_set.layer]))
        place = (bar_set.region if free.is_empty else free).representative_point()
        described.append(
            {
                "layer": bar_set.layer,
                "zone": bar_set.zone,
                "rings": _rings(bar_set.region) if bar_set.zone else [],
                "at": [*np.round((place.x, place.y), DIGITS)],
                "text": _words(bar_set, model.units),
            }
        )
    return described


def _words(bars: BarSet, units: System) -> str:
    """Return what bars are: diameter and spacing, of welded mesh its name before."""
    words = bars_at(bars.bars.diameter, bars.bars.spacing, units)
    return f"{bars.mesh}: {words}" if bars.mesh else words


def _rings(region: BaseGeometry) -> list[list[list[float]]]:
    """Return the outer borders of a region [m]."""
    pieces = [piece for piece in getattr(region, "geoms", [region]) if piece.geom_type == "Polygon"]
    return [np.round(np.asarray(piece.exterior.coords)[:-1], DIGITS).tolist() for piece in pieces]
