"""How well a mesh meets soil zones and voids: their areas as drawn and as meshed, and elements across their borders."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.discretize.borders import shares, zone_rings
from groundslab.discretize.plan_layout import followed
from groundslab.discretize.voids import Taken, taken
from groundslab.fem.shape_functions import areas
from groundslab.results.results import Results

#: An element of which a region takes all or nothing but for this share is not across its border.
WHOLE = 1e-3


@dataclass(frozen=True, slots=True)
class Coverage:
    """The area of a soil zone or void that counts, where others lie over it not counted [m2]."""

    name: str  # as in the file: "soil_zones[1]"
    drawn: float
    meshed: float  # what the elements take for it
    crossed: float  # of elements that lie in it in part


def crossed_borders(results: Results) -> tuple[Coverage, ...]:
    """Return the soil zones and voids of which elements take a part, as their borders are no lines of the mesh."""
    model, ground, plate = results.model, results.ground, results.plate
    if not model.soil_zones and not model.contact.voids:
        return ()
    x0, x1, y0, y1 = model.plate.bounds
    (low_x, low_y), (high_x, high_y) = ground.nodes.min(axis=0), ground.nodes.max(axis=0)
    width = float(max(x0 - low_x, high_x - x1, y0 - low_y, high_y - y1))
    size = max(model.plate.sides)
    met = followed(model, width if width > 1e-9 * size else 0.0)
    xy = ground.nodes[ground.elements]
    by_zone = shares(xy, zone_rings(model), met, size)
    found = [_coverage("soil_zones", k, part, part, areas(xy)) for k, part in enumerate(by_zone.T[1:])]
    xy = plate.nodes[plate.elements]
    k1 = results.constants.k1
    voids = taken(model, xy, met, steps=len(k1) == 1 and k1[0] == 0)
    found += [
        _coverage("contact.voids", k, drawn, meshed, areas(xy))
        for k, (drawn, meshed) in enumerate(zip(voids.drawn.T, _meshed(voids).T, strict=True))
    ]
    return tuple(each for each in found if each.crossed > 0)


def _meshed(voids: Taken) -> Array:
    """Return the share (mp, v) of each element that it takes for each void, those of one depth by their areas."""
    together = np.stack([voids.drawn[:, voids.of == k].sum(axis=1) for k in range(len(voids.depth))], axis=1)
    part = np.divide(voids.share, together, out=np.zeros_like(together), where=together > 0)
    meshed: Array = voids.drawn * part[:, voids.of]
    return meshed


def _coverage(section: str, number: int, drawn: Array, meshed: Array, area: Array) -> Coverage:
    across: Flags = (drawn > WHOLE) & (drawn < 1 - WHOLE)
    figures = (float(part @ area) for part in (drawn, meshed, across.astype(float)))
    return Coverage(f"{section}[{number + 1}]", *figures)
