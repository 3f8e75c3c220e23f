"""How thick the plate is, element by element and node by node."""

from __future__ import annotations

import numpy as np

from groundslab.loading import materials
from groundslab.model import Model, plan_of_plate
from groundslab.plan import sections
from groundslab.results import PlateResult
from groundslab.shape import Array


def of_elements(model: Model, plate: PlateResult) -> Array:
    """Return the thickness (m,) [m] of each element, by the zone that its centre lies in."""
    t = np.array([thickness for _, _, thickness in materials(model)])
    if len(t) == 1:
        return np.full(len(plate.elements), t[0])
    centres = plate.nodes[plate.elements[:, 8]]
    # elements follow the zones' borders; a centre that lies in none is one of the plate's own section
    found: Array = t[np.maximum(sections(plan_of_plate(model.plate, ()), centres), 0)]
    return found


def of_nodes(model: Model, plate: PlateResult) -> Array:
    """Return the thickness (n,) [m] at each node, which belongs to one section only."""
    t = np.zeros(len(plate.nodes))
    t[plate.elements] = of_elements(model, plate)[:, None]
    return t
