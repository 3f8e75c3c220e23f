"""Which section of the plate elements and nodes belong to, and how thick it is there."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.discretize.nodal_loads import materials
from groundslab.geometry.plan import sections
from groundslab.model.model import Model
from groundslab.model.supports import plan_of_plate
from groundslab.results.mesh_results import PlateResult


def section_of_elements(model: Model, plate: PlateResult) -> Integers:
    """Return the number of the zone that each element lies in (m,), from 1; 0 outside all zones."""
    if not model.plate.zones:
        return np.zeros(len(plate.elements), dtype=np.int64)
    centres = plate.nodes[plate.elements[:, 8]]
    # elements follow the zones' borders; a centre that lies in none is one of the plate's own section
    found: Integers = np.maximum(sections(plan_of_plate(model.plate, ()), centres), 0)
    return found


def section_of_nodes(model: Model, plate: PlateResult) -> Integers:
    """Return the number of the zone that each node lies in (n,): a node belongs to one section only."""
    section = np.zeros(len(plate.nodes), dtype=np.int64)
    section[plate.elements] = section_of_elements(model, plate)[:, None]
    return section


def of_sections(model: Model) -> Array:
    """Return the thickness [m] of each section: outside all zones, then of each zone in turn."""
    return np.array([thickness for _, _, thickness in materials(model)])


def of_elements(model: Model, plate: PlateResult) -> Array:
    """Return the thickness (m,) [m] of each element, by the zone that its centre lies in."""
    t: Array = of_sections(model)[section_of_elements(model, plate)]
    return t


def of_nodes(model: Model, plate: PlateResult) -> Array:
    """Return the thickness (n,) [m] at each node, which belongs to one section only."""
    t: Array = of_sections(model)[section_of_nodes(model, plate)]
    return t
