"""Remarks on pits: what of the ground, of water and of members an analysis at one level does not know of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from groundslab.messages import Message, Name
from groundslab.model.ground import ConstrainedModulus, Continuum, InterfaceLayer, Pasternak, Winkler
from groundslab.model.loads.acting import AreaPressure, PlateAction
from groundslab.model.plates.pits import Pit, chord_of, pits_of
from groundslab.model.supports import Pile
from groundslab.schema.wording import quote
from groundslab.units import show

if TYPE_CHECKING:
    from shapely import Polygon

    from groundslab.model.model import Model
    from groundslab.model.plates.other_plates import AnyPlate

#: Unit weight of water [N/m3] (EN 1991-1-1 Table A.10).
WATER = 10e3

#: A path, the remark on it, and whether no design should pass before somebody has looked at it.
PitRemark = tuple[tuple[str | int, ...], str, bool]


def pit_remarks(model: Model) -> Iterator[PitRemark]:
    """Yield where remarks on pits stand, their words, and whether they leave a design in doubt."""
    pits = [(plate, pit) for plate in model.every_plate for pit in pits_of(plate)]
    if not pits:
        return
    words = (
        "pits are analyzed as if their floors were at the level of the slab around, without forces in its plane; their "
        "walls hand over moments"
    )
    yield ("plate", "zones"), words, False
    yield from _on_ground(model)
    for plate, pit in pits:
        yield from _on_water(model, plate, pit)
        yield from _on_members(model, plate, pit)
    if model.soil_strength is not None:
        words = "bearing resistance and sliding are those of a plane base at the level of the slab around pits"
        yield ("soil_strength",), words, False
    if model.floor is not None:
        words = "checks of the floor do not know that it ends at pits: check loads beside them as loads at an edge"
        yield ("floor",), words, True


def _on_ground(model: Model) -> Iterator[PitRemark]:
    """Yield what of the ground does not know how deep pits are."""
    ground = model.ground
    interfaces = any(isinstance(layer, InterfaceLayer) for layer in getattr(ground, "layers", ()))
    if isinstance(ground, Winkler | Pasternak | Continuum) or interfaces:
        words: str = "the ground is the same under pits as under the slab around them, which lies higher"
        if not isinstance(ground, Continuum):
            words = Message("{text}; soil_zones may give pits constants of their own", text=words)
        yield ("ground",), words, False
    elif isinstance(ground, ConstrainedModulus) and ground.relief > 0 and ground.unit_weight is None:
        words = "relief is the same under pits: without unit_weight the soil that they take off is not known"
        yield ("ground", "relief"), words, False


def _on_water(model: Model, plate: AnyPlate, pit: Pit) -> Iterator[PitRemark]:
    """Yield that water which presses up all over the plate presses more under a pit, where no load says so."""
    wide = pit.outer(chord_of(plate)).buffer(pit.wall)
    more = show(WATER * pit.deeper, "pressure")
    for name in dict.fromkeys(load.case for load in model.loads):
        shapes = [shape for load, shape in model.acting if load.case == name]
        all_over = [shape for shape in shapes if _presses_up(shape, plate, wide, around=True)]
        if all_over and not any(_presses_up(shape, plate, wide, around=False) for shape in shapes):
            words = Message(
                "what presses up all over in case {name} does so under the pit zones[{number}], too, {deeper} deeper: "
                "if it is water, {more} more, as a load on the pit",
                name=quote(name), number=pit.number, deeper=show(pit.deeper, "length"), more=more,
            )  # fmt: skip
            yield ("loads",), words, True


def _presses_up(shape: object, plate: AnyPlate, wide: Polygon, *, around: bool) -> bool:
    """Return whether a shape presses a pit up, and all around it (wide), or the pit alone."""
    if isinstance(shape, PlateAction):
        return around and shape.plate in ("", plate.name) and shape.pressure.q < 0
    if not isinstance(shape, AreaPressure) or shape.on == "ground" or shape.pressure.q >= 0:
        return False
    area = shape.to_shapely()
    return bool(area.intersects(wide)) and bool(area.covers(wide)) == around


def _on_members(model: Model, plate: AnyPlate, pit: Pit) -> Iterator[PitRemark]:
    """Yield walls with a height and piles that do not know how deep a pit is."""
    from shapely import Point

    chord = chord_of(plate)
    inner = pit.area(chord).buffer(-2 * chord)
    for number, wall in enumerate(model.placed_walls):
        if wall.height is not None and wall.to_shapely(chord).intersects(inner):
            words = Message("wall {name} crosses a pit as if it stood on one level", name=Name(quote(wall.name)))
            yield ("walls", number), words, True
    for number, support in enumerate(model.supports):
        if isinstance(support, Pile) and inner.contains(Point(support.x, support.y)):
            counts = "a pile under a pit, whose length counts from the underside of the slab around it"
            yield ("supports", number), counts, False
