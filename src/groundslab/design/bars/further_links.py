"""Links of beams and links against one-way shear that a case lays: how many of which length, and where."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.geometry.plan import FLAT
from groundslab.model.design.beam_links import BeamLinks
from groundslab.model.design.laid_bars import DENSITY, axis_of, covers_of, laid_bars, polygon_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.model.plates.region import get_plate_region
from groundslab.model.structure.beams import GivenSection, RibSection

if TYPE_CHECKING:
    from shapely import LineString, Point
    from shapely.geometry.base import BaseGeometry


class StandingLink(NamedTuple):
    """Where a link of a beam stands."""

    place: tuple[float, float]  # of its middle in plan [m]
    along: tuple[float, float]  # the beam's direction, a unit vector
    top: float  # height of the section's upper side, that of the slab at 0 [m]
    cover: float  # of the link at the upper side [m]


@dataclass(frozen=True, slots=True)
class LaidLinks:
    """Links of one kind in one part of a slab, or along one beam."""

    name: str  # of the beam or of the links
    shape: str  # "leg" or "link"
    diameter: float  # [m]
    spacing: float  # [m]
    number: int
    length: float  # of each, without hooks [m]
    place: tuple[float, float]  # of their middle [m]
    corners: tuple[float, float, float, float] | None = None  # x0, y0, x1, y1 of the part of a slab [m]
    sides: tuple[float, float] | None = None  # of closed links, across and upright, outside [m]
    legs: int = 1  # upright, of each
    standing: tuple[StandingLink, ...] = ()  # of those of beams, each

    @property
    def total(self) -> float:
        """Return the length of all of them [m]."""
        return self.number * self.length

    @property
    def mass(self) -> float:
        """Return what they weigh [kg]."""
        return DENSITY * math.pi * self.diameter**2 / 4 * self.total


def further_links(model: Model) -> Iterator[LaidLinks]:
    """Yield the links of beams and against one-way shear that a case lays, as long as covers leave of the section.

    Where a slab is of several thicknesses, there are links of several lengths.
    """
    steel = model.reinforcement
    if steel is None:
        return
    for legs in steel.shear_links:
        ring = polygon_of(legs.shape.ring())
        for part, thickness in _by_thickness(model, ring):
            number = round(part.area / (legs.spacing_x * legs.spacing_y))
            middle = part.representative_point()
            place = middle.x, middle.y
            length = thickness - sum(_covers(steel, place))
            if number:
                yield LaidLinks(legs.name, "leg", legs.diameter, legs.apart, number, length, place, part.bounds)
    for links in steel.beam_links:
        yield from _of_beam(model, steel, links)


def _by_thickness(model: Model, shape: BaseGeometry) -> Iterator[tuple[BaseGeometry, float]]:
    """Yield what of a shape lies on a slab, in parts of one thickness [m] each."""
    from shapely import union_all

    region = get_plate_region(model.plate, model.plates)
    parts: dict[float, list[BaseGeometry]] = {}
    for plate, area in zip(region.every, region.areas, strict=True):
        rest = area.intersection(shape)
        for zone in reversed(plate.zones):
            ring = polygon_of(zone.shape.ring())
            parts.setdefault(zone.thickness or plate.thickness, []).append(rest.intersection(ring))
            rest = rest.difference(ring)
        parts.setdefault(plate.thickness, []).append(rest)
    for thickness, pieces in parts.items():
        part = union_all(pieces)
        if part.area > 0:
            yield part, thickness


def _covers(steel: Reinforcement, place: tuple[float, float]) -> tuple[float, float]:
    """Return the covers [m] of the outermost bars at a place, at the bottom and the top."""
    if steel.cover is not None or not steel.laid:
        return covers_of(steel)
    below, above = (
        min(
            axis_of(steel, layer) - float(laid_bars(steel, layer, np.array([place])).thickest[0]) / 2
            for layer in (f"{face}_x", f"{face}_y")
        )
        for face in ("bottom", "top")
    )
    return below, above


def _of_beam(model: Model, steel: Reinforcement, links: BeamLinks) -> Iterator[LaidLinks]:
    """Yield the closed links of a beam, or of a strip that is one, those of one height together."""
    member = _member(model, links.of)
    end = member.length if links.end is None else links.end
    number = math.floor((end - links.start) / links.spacing + 1e-9) + 1
    alike = dict[float, list[tuple[tuple[float, float], tuple[float, float], float]]]()
    for way in (links.start + links.spacing * np.arange(number)).tolist():
        part = min(way / member.length, 1.0)
        point = member.axis.interpolate(part, normalized=True)
        thickness, level = _slab_at(model, point)
        h = member.height + (thickness if member.with_slab else 0.0)
        place = (point.x, point.y), _direction(member.axis, part), level + member.top + member.middle * thickness
        alike.setdefault(h, []).append(place)
    for h, places in alike.items():
        middle, _, _ = places[len(places) // 2]
        covers = _covers(steel, middle)
        across, upright = member.width - 2 * min(covers), h - sum(covers)
        link_length = 2 * across + links.legs * upright
        yield LaidLinks(
            links.of, "link", links.diameter, links.spacing, len(places), link_length, middle, None, (across, upright),
            links.legs, tuple(StandingLink(*place, covers[1]) for place in places),
        )  # fmt: skip


def _direction(axis: LineString, part: float) -> tuple[float, float]:
    """Return the direction of an axis at a part of its length, a unit vector."""
    before, after = (axis.interpolate(float(np.clip(part + step, 0, 1)), normalized=True) for step in (-1e-6, 1e-6))
    along = np.array([after.x - before.x, after.y - before.y])
    x, y = (along / np.linalg.norm(along)).tolist()
    return x, y


def _slab_at(model: Model, point: Point) -> tuple[float, float]:
    """Return thickness of the slab at a place and the height of its upper side [m]: of its last zone, else its own."""
    plate = model.every_plate[get_plate_region(model.plate, model.plates).plate_at((point.x, point.y))]
    zones = [zone for zone in plate.zones if polygon_of(zone.shape.ring()).covers(point)]
    if not zones:
        return plate.thickness, 0.0
    return zones[-1].thickness or plate.thickness, zones[-1].level or 0.0


class _Member(NamedTuple):
    """A beam, or a strip that is one."""

    axis: LineString
    length: float  # [m]
    width: float  # [m]
    height: float  # of its section, beside the slab if that belongs to it [m]
    with_slab: bool
    top: float = 0.0  # height of its upper side above that of the slab [m]
    middle: float = 0.0  # and beside it so many times the slab's thickness


def _member(model: Model, name: str) -> _Member:
    """Return a beam, or a strip that is one."""
    from shapely import LineString

    for strip in model.output.beams:
        if strip.name == name:
            return _Member(
                LineString([strip.start, strip.end]), math.dist(strip.start, strip.end), strip.width, 0.0, True
            )
    beam = next(beam for beam in model.beams if beam.name == name)
    section = beam.section
    assert not isinstance(section, GivenSection)
    axis = beam.to_shapely(FLAT * max(model.sides))
    width, height = section.width, section.height
    if isinstance(section, RibSection):
        return _Member(axis, beam.length, width, height, True, height if section.side == "above" else 0.0)
    # a rectangle lies about the middle of the slab
    return _Member(axis, beam.length, width, height, False, height / 2, -0.5)
