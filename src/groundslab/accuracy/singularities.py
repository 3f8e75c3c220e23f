"""Where shear forces and pressures are not judged: they have no meaning in design there, no limit, or they jump."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags, made_once_by
from groundslab.geometry.nearest import nearest_distance
from groundslab.geometry.plan import Segment, numbers_within
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.acting import LineForce, PointForce, borders_of
from groundslab.model.remarks.singular_places import corners_of, near_places, near_singular

if TYPE_CHECKING:
    from groundslab.model.model import Model
    from groundslab.results.plate_result import PlateResult

#: Values are judged so many thicknesses away from there.
AWAY = 1.0
#: Shear forces are judged so many thicknesses away from a wall's faces: in all but thin slabs nearer than d, where they
#: are read with errors of their own.
FROM_FACES = 0.75


@dataclass(frozen=True, slots=True)
class Limits:
    """At which nodes values are judged, (n,) each."""

    shear_forces: Flags
    pressures: Flags


def find_limits(model: Model, plate: PlateResult) -> Limits:
    """Return at which nodes of the plate (n,) shear forces and pressures are judged.

    Shear forces over the webs of beams are the beams'. Those under walls and next to their faces grow from one side to
    the other, and are read at d from the faces. Those around footprints and where they are singular, at the plate's
    corners too if ground with shear goes on beyond them, have no meaning in design, where punching is checked instead;
    what is singular at an end of a beam is as wide as its web. Nor have those within a thickness of the
    plate's edges, a quarter of the width of a narrow plate, where they are what the twisting moment has become.
    Pressures on ground without shear follow the settlement; with shear they have no limit where section forces have
    none, and jump at beams and where loads, lines, zones and voids begin, and around where the plate has lifted off.
    There they are zero, but may not be so on a coarser mesh. So they do along edges at which the ground would pull: a
    strip lifts off there, narrower than any element.
    On an elastic continuum they have no limit along the edges of the plate.
    """
    limits = limits_without_contact(model, plate.nodes)
    if not model.ground_carries_shear or not model.contact.tensionless:
        return limits
    pulled = plate.in_contact & (plate.edge_length > 0) & (plate.line_force <= 0)
    lifted = ~plate.in_contact | (pulled & (not isinstance(model.ground, ContinuousGround)))
    if not lifted.any():
        return limits
    reach = AWAY * max(sheet.thickness for sheet in model.every_plate)
    near = limits.pressures & plate.in_contact
    pressures = limits.pressures.copy()
    pressures[near] = nearest_distance(plate.nodes[near], plate.nodes[lifted], 1.001 * reach) > reach
    return Limits(limits.shear_forces, pressures)


@made_once_by(lambda model, nodes: (nodes, model))
def limits_without_contact(model: Model, nodes: Array) -> Limits:
    """Return at which nodes (n, 2) shear forces and pressures are judged where nothing has lifted off."""
    reach = AWAY * max(plate.thickness for plate in model.every_plate)
    footprints = [edge for _, shape in model.acting if isinstance(shape, PointForce) for edge in borders_of(shape)]
    within = np.full(len(nodes), reach)
    singular = near_singular(model, nodes, within)
    for beam in model.beams:
        # what ends is as wide as its web
        singular |= near_places(beam.ends, nodes, within + beam.width / 2)
    if model.ground_reaches:
        singular |= near_places(
            [place for plate in model.every_plate for place in corners_of(plate.ring(), None)], nodes, within
        )
    edges = [edge for plate in model.every_plate for ring in plate.rings() for edge in ring.segments()]
    narrowest = min(min(plate.sides) for plate in model.every_plate)
    shear_forces = ~(singular | _near(nodes, footprints, reach) | _near(nodes, edges, min(reach, narrowest / 4)))
    thinnest = min(plate.thickness for plate in model.every_plate)
    for _, shape in model.acting:
        if isinstance(shape, LineForce) and shape.width:
            shear_forces &= ~_near(nodes, [*shape.edges], shape.width / 2 + FROM_FACES * thinnest)
    for beam in model.beams:
        shear_forces &= ~_near(nodes, [*beam.edges], beam.width / 2)
    if not model.ground_carries_shear:
        return Limits(shear_forces, np.ones(len(nodes), dtype=bool))
    return Limits(shear_forces, ~(singular | _near(nodes, [*_creases(model)], reach)))


def _near(nodes: Array, edges: list[Segment], reach: float) -> Flags:
    """Return which nodes (n, 2) are within reach [m] of edges."""
    is_near = np.zeros(len(nodes), dtype=bool)
    for edge in edges:
        x0, x1, y0, y1 = edge.bounds
        inside = numbers_within(nodes, (x0 - reach, x1 + reach, y0 - reach, y1 + reach))
        is_near[inside[edge.distance(nodes[inside]) <= reach]] = True
    return is_near


def _creases(model: Model) -> Iterator[Segment]:
    """Yield the lines along which the pressure of ground with shear jumps or has no limit."""
    for _, shape in model.acting:
        yield from borders_of(shape)
    for line in (*model.supports, *model.members):
        yield from line.edges
    zones = [zone for plate in model.every_plate for zone in plate.zones]
    soil, voids = model.soil_zones, model.contact.voids
    # under the edges of a plate the pressure of an elastic continuum has no limit
    edges = [ring for plate in model.every_plate for ring in plate.rings()]
    for ring in (
        *(edges if isinstance(model.ground, ContinuousGround) else ()),
        *(zone.shape.ring() for zone in zones),
        *(zone.shape.ring() for zone in soil),
        *(v.ring() for v in voids),
    ):
        yield from ring.segments()
