"""Links of beams and links against one-way shear that a case lays: how many of which length, and where."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from groundslab.model.design.beam_links import BeamLinks
from groundslab.model.design.laid_bars import covers_of, polygon_of
from groundslab.model.model import Model
from groundslab.model.plates.region import get_plate_region
from groundslab.model.structure.beams import GivenSection, RibSection

#: Mass of steel [kg/m3] (EN 1992-1-1 3.2.7(3)).
STEEL = 7850.0


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

    @property
    def total(self) -> float:
        """Return the length of all of them [m]."""
        return self.number * self.length

    @property
    def mass(self) -> float:
        """Return what they weigh [kg]."""
        return STEEL * math.pi * self.diameter**2 / 4 * self.total


def further_links(model: Model) -> Iterator[LaidLinks]:
    """Yield the links of beams and against one-way shear that a case lays, as long as covers leave of the section.

    That is of the first plate's thickness; zones of another one are not looked at.
    """
    steel = model.reinforcement
    if steel is None:
        return
    covers = covers_of(steel)
    region = get_plate_region(model.plate, model.plates).area
    for legs in steel.shear_links:
        part = region.intersection(polygon_of(legs.shape.ring()))
        number = round(part.area / (legs.spacing_x * legs.spacing_y))
        middle = part.representative_point()
        yield LaidLinks(
            legs.name, "leg", legs.diameter, legs.apart, number, model.plate.thickness - sum(covers),
            (middle.x, middle.y), part.bounds,
        )  # fmt: skip
    for links in steel.beam_links:
        yield _of_beam(model, links, covers)


def _of_beam(model: Model, links: BeamLinks, covers: tuple[float, float]) -> LaidLinks:
    """Return the closed links of a beam, or of a strip that is one."""
    length, b, h, middle = _size(model, links.of)
    end = length if links.end is None else links.end
    high, wide = h - sum(covers), b - 2 * min(covers)
    number = math.floor((end - links.start) / links.spacing + 1e-9) + 1
    each = 2 * wide + links.legs * high
    return LaidLinks(links.of, "link", links.diameter, links.spacing, number, each, middle)


def _size(model: Model, name: str) -> tuple[float, float, float, tuple[float, float]]:
    """Return length, width and height of a beam [m], and its middle."""
    t = model.plate.thickness
    for strip in model.output.beams:
        if strip.name == name:
            (x0, y0), (x1, y1) = strip.start, strip.end
            return math.dist(strip.start, strip.end), strip.width, t, ((x0 + x1) / 2, (y0 + y1) / 2)
    beam = next(beam for beam in model.beams if beam.name == name)
    section = beam.section
    assert not isinstance(section, GivenSection)
    edge = beam.edges[len(beam.edges) // 2]
    x, y = ((a + b) / 2 for a, b in zip(edge.start, edge.end, strict=True))
    return beam.length, section.width, section.height + (t if isinstance(section, RibSection) else 0.0), (x, y)
