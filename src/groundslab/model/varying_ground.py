"""Ground that varies over the plan: zones of other soil, boreholes, gaps and voids under the plate."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar

from groundslab.geometry.plan import Ring, rectangle
from groundslab.model.ground import (
    POSITIVE,
    AnyGround,
    ConstrainedModulus,
    ContinuousGround,
    Continuum,
    Ground,
    InterfaceLayer,
    Layered,
    SoilLayer,
    Vlasov,
)
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import FurtherPlate, list_plates
from groundslab.model.plates.pits import pits_of
from groundslab.model.shapes import AnyShape, Shape
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.places import coordinate, extent
from groundslab.schema.repairs import remove, set_value
from groundslab.schema.section_fields import Table
from groundslab.schema.wording import quote

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry


#: Zones of soil reach no further from the plate, in lengths of its longer side.
FARTHEST = 1000
#: The base lies no deeper than so many lengths of the plate's longer side: modes have an element for each decay.
DEEPEST = 2000
#: Pits cut off no larger share of the layers of soil.
DEEPEST_PIT = 0.9


class SoilZone(Section):
    """A part of the plan with ground of its own; the last zone that covers a place counts."""

    shape: Annotated[Shape, Table("where, under the plate or beyond it")]
    ground: Annotated[Ground, Table("the ground there, of the same kind and with as many layers")]


def _check_depth(layers: tuple[SoilLayer, ...]) -> Iterator[RelativeIssue]:
    if layers and not any(layer.thickness for layer in layers):
        yield RelativeIssue(("layers",), "layers of 0 m", "at least one that is thicker")


class Borehole(Section):
    """A place where the layers are known; between boreholes they are interpolated."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_depth,)

    name: Annotated[str, Text("name of the borehole, for reference")] = ""
    x: Annotated[float, coordinate(0, "position, on or off the plate")]
    y: Annotated[float, coordinate(1, "position, on or off the plate")]
    layers: Annotated[
        tuple[SoilLayer, ...],
        Table("the layers there, from the top downwards, as many as the ground has; their thickness, E, E_bottom and "
              "nu are interpolated; one that is missing there, as it pinches out, has a thickness of 0 m"),
    ]  # fmt: skip


def _signature(ground: AnyGround) -> tuple[object, ...]:
    """Return the features that all the ground must share: kind, rule, number and kind of layers."""
    if isinstance(ground, Vlasov):
        return ground.kind, ground.gamma, ground.formulas, ground.mode, len(ground.layers)
    if isinstance(ground, Layered):
        kinds = tuple(type(layer).__name__ for layer in ground.layers)
        sublayers = tuple(layer.sublayers for layer in ground.layers if isinstance(layer, SoilLayer))
        return ground.kind, ground.coupling, ground.gamma, ground.formulas, kinds, sublayers
    return (ground.kind,)


def check_soil_zone_types(ground: AnyGround, soil_zones: tuple[SoilZone, ...]) -> Iterator[RelativeIssue]:
    """Find soil zones of another kind than the rest of the ground."""
    for position, zone in enumerate(soil_zones):
        if _signature(zone.ground) != _signature(ground):
            expected = f"ground like the rest: {quote(ground.kind)} with the same rules and as many layers"
            yield RelativeIssue(("soil_zones", position, "ground"), "ground of another kind", expected)


def check_soil_zone_extent(plate: Plate, soil_zones: tuple[SoilZone, ...]) -> Iterator[RelativeIssue]:
    """Find zones of soil that reach too far off the plate for their edge near it to be resolved."""
    p0, p1, r0, r1 = plate.bounds
    far = FARTHEST * max(p1 - p0, r1 - r0)
    for position, zone in enumerate(soil_zones):
        x0, x1, y0, y1 = zone.shape.ring().bounds
        reach = max(p0 - x0, x1 - p1, r0 - y0, y1 - r1)
        if reach > far:
            expected = f"at most {far:g} m, {FARTHEST} times the plate's longer side"
            hint = "end it where the ground beyond the plate has no effect any more"
            yield RelativeIssue(
                ("soil_zones", position, "shape"), f"a zone that reaches {reach:g} m from the plate", expected, hint
            )


def check_soil_depth(plate: Plate, ground: AnyGround, boreholes: tuple[Borehole, ...]) -> Iterator[RelativeIssue]:
    """Find soil too deep, compared to the plate, for its base to matter."""
    most = DEEPEST * max(plate.sides)
    described: dict[tuple[str | int, ...], tuple[SoilLayer | InterfaceLayer, ...]] = {}
    for position, hole in enumerate(boreholes):
        described["boreholes", position, "layers"] = hole.layers
    if isinstance(ground, Vlasov | Layered | ContinuousGround):
        described["ground", "layers"] = ground.layers
    for place, layers in described.items():
        depth = sum(layer.thickness for layer in layers if isinstance(layer, SoilLayer))
        if depth > most:
            expected = f"at most {most:g} m, {DEEPEST} times the plate's longer side"
            yield RelativeIssue(place, f"layers of {depth:g} m", expected, "leave out what lies too deep to matter")


def check_pit_depth(
    plate: Plate,
    plates: tuple[FurtherPlate, ...],
    ground: AnyGround,
    soil_zones: tuple[SoilZone, ...],
    boreholes: tuple[Borehole, ...],
) -> Iterator[RelativeIssue]:
    """Find pits that reach the base of the layers of soil, at some place at which these are described."""
    described = [getattr(soil, "layers", ()) for soil in (ground, *(zone.ground for zone in soil_zones))]
    described = [hole.layers for hole in boreholes] or described
    if getattr(ground, "half_space", None) is not None:
        return
    depths = [
        sum(layer.thickness for layer in layers)
        for layers in described
        if layers and all(isinstance(layer, SoilLayer) for layer in layers)
    ]
    for position, slab in enumerate(list_plates(plate, plates), start=-1):
        path = ("plate",) if position < 0 else ("plates", position)
        for pit in pits_of(slab):
            if depths and pit.deeper >= DEEPEST_PIT * min(depths):
                deep_pit = f"an underside {pit.deeper:g} m deeper than the slab's, in layers of {min(depths):g} m"
                expected = f"at most {DEEPEST_PIT * min(depths):g} m, so that soil is left below it"
                yield RelativeIssue((*path, "zones", pit.number - 1, "level"), deep_pit, expected)


def check_boreholes(
    ground: AnyGround, soil_zones: tuple[SoilZone, ...], boreholes: tuple[Borehole, ...]
) -> Iterator[RelativeIssue]:
    """Find boreholes that do not match the ground or each other."""
    if not boreholes or isinstance(ground, Continuum):
        return
    layers = ground.layers if isinstance(ground, Vlasov | Layered | ConstrainedModulus) else ()
    if not layers or any(isinstance(layer, InterfaceLayer) for layer in layers):
        expected = "ground of layers given by E, nu and thickness"
        no_layers, repairs = f"boreholes in {quote(ground.kind)} ground without soil layers", (remove(("boreholes",)),)
        yield RelativeIssue(("boreholes",), no_layers, expected, repairs=repairs)
        return
    if soil_zones:
        hint, either = "a borehole says what the soil is there", (remove(("soil_zones",)), remove(("boreholes",)))
        yield RelativeIssue(("soil_zones",), "zones together with boreholes", "one of them", hint, either)
    if isinstance(ground, Vlasov) and ground.formulas == "as printed":
        repairs = (set_value(("ground", "formulas"), "exact"),)
        yield RelativeIssue(("ground", "formulas"), '"as printed" with boreholes', '"exact"', repairs=repairs)
    seen: dict[tuple[float, float], int] = {}
    for position, hole in enumerate(boreholes):
        if len(hole.layers) != len(layers):
            layer_count = f"{len(hole.layers)} layers"
            expected = f"{len(layers)}, as many as the ground has"
            hint = "a layer that is missing there has a thickness of 0 m"
            yield RelativeIssue(("boreholes", position, "layers"), layer_count, expected, hint)
        for number, (layer, wanted) in enumerate(zip(hole.layers, layers, strict=False)):
            assert isinstance(wanted, SoilLayer)
            if layer.sublayers not in (1, wanted.sublayers):
                place = ("boreholes", position, "layers", number, "sublayers")
                yield RelativeIssue(place, str(layer.sublayers), "none, as those of the ground's layer count")
            if layer.variation != wanted.variation:
                place = ("boreholes", position, "layers", number, "variation")
                yield RelativeIssue(
                    place, quote(layer.variation), f"{quote(wanted.variation)}, as the ground's layer has"
                )
        first = seen.setdefault((hole.x, hole.y), position)
        if first != position:
            yield RelativeIssue(("boreholes", position), f"the place of boreholes[{first + 1}]", "a different place")


def check_gap_points(gaps: tuple[GapPoint, ...]) -> Iterator[RelativeIssue]:
    """Find places with two gaps."""
    seen: dict[tuple[float, float], int] = {}
    for position, point in enumerate(gaps):
        first = seen.setdefault((point.x, point.y), position)
        if first != position:
            yield RelativeIssue(("gaps", position), f"the place of gaps[{first + 1}]", "a different place")


class GapPoint(Section):
    """A place where the gap under the plate has been measured; between such places it is interpolated."""

    x: Annotated[float, coordinate(0, "position")]
    y: Annotated[float, coordinate(1, "position")]
    gap: Annotated[float, Quantity("length", "g_0", "gap there; below 0 the ground is higher", example="5 mm")]


def _check_extent(
    x: tuple[float, float] | None, y: tuple[float, float] | None, shape: AnyShape | None
) -> Iterator[RelativeIssue]:
    if shape is None:
        for name, value in (("x", x), ("y", y)):
            if value is None:
                yield RelativeIssue((name,), "nothing", "x and y, or a shape")
    elif x is not None or y is not None:
        yield RelativeIssue(("shape",), "a shape together with x or y", "one of them")


class Void(Section):
    """A part of the plan where the ground lies deeper, or is missing."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_extent,)

    depth: Annotated[
        float | None,
        Quantity(
            "length",
            "d",
            "initial gap there; if omitted a cavity, whose bottom is never reached",
            POSITIVE,
            example="20 mm",
        ),
    ] = None
    x: Annotated[
        tuple[float, float] | None,
        extent(0, "extent along x of a rectangle"),
    ] = None
    y: Annotated[
        tuple[float, float] | None,
        extent(1, "extent along y of a rectangle"),
    ] = None
    shape: Annotated[Shape | None, Table("any other shape, instead of x and y")] = None

    def ring(self) -> Ring:
        """Return the curve around it."""
        if self.shape is not None:
            return self.shape.ring()
        assert self.x is not None
        assert self.y is not None
        return rectangle(*self.x, *self.y)

    def to_shapely(self, chord: float) -> BaseGeometry:
        """Return the area, arcs as chords at most so far off [m]."""
        return self.ring().polygon(chord)
