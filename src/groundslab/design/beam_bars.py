"""Bars and links that beams of concrete need in the ultimate combinations, by the code of the case.

A rectangle takes its own moment. A rib acts as a T with its flange: the slab's moment over the flange's width, of the
same curvature, adds to the rib's. Where the flange is compressed it counts with its effective width, as long as the
neutral axis lies in it; else the rib's width counts alone, which is on the safe side. Torsion by compatibility needs no
design (EN 1992-1-1 6.3.1(2), ACI 318-19 22.7.3.2); none other is looked at. Bars of the slab do not count.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.design.basis.combinations import ultimate_results
from groundslab.design.bending import Reinforcement as Bending
from groundslab.design.codes import code_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.plates.region import PlateRegion
from groundslab.model.structure.beams import Beam, GivenSection, RibSection
from groundslab.results.record import BeamResult
from groundslab.results.results import CombinationResult, Results

#: What is looked for: bars at both faces, and links.
WHAT = ("bottom", "top", "links")
#: Of places that need as much, the one with the largest force counts.
TIE = 1e-15


@dataclass(frozen=True, slots=True)
class BeamNeed:
    """What a beam needs of bars at a face [m2], or of links [m2/m], where it needs most of them."""

    beam: str
    what: str  # one of WHAT
    area: float  # inf where the concrete is too weak
    least: float  # least bars where there is a moment, or least links
    force: float  # design moment [N m], sagging positive, or shear force [N]
    way: float  # where, from the beam's start [m]
    combination: str


@dataclass(frozen=True, slots=True)
class _Section:
    """A concrete section, as the code needs it."""

    share: float  # of the section's moments and shear forces over those of the beam
    h: float  # height [m]
    b: float  # of the web [m]
    compressed: tuple[float, float]  # width where the beam sags, where it hogs [m]
    flange: float  # thickness of the flange [m]; infinite without one
    d: tuple[float, float]  # effective depth where it sags, where it hogs [m]


def beam_needs(combined: Results, steel: Reinforcement) -> list[BeamNeed]:
    """Return what each beam of concrete needs, of all ultimate combinations the most."""
    found: list[BeamNeed] = []
    for number, beam in enumerate(combined.model.beams):
        if isinstance(beam.section, GivenSection):
            continue
        needs = [need for result in ultimate_results(combined) for need in _needs(result, number, beam, steel)]
        found += [max(own, key=lambda need: need.area) for what in WHAT
                  if (own := [need for need in needs if need.what == what])]  # fmt: skip
    return found


def _needs(results: CombinationResult, number: int, beam: Beam, steel: Reinforcement) -> Iterator[BeamNeed]:
    """Yield what a beam needs at both faces and of links in a combination, each at the place of the most."""
    own = results.beams[number]
    section = _section(results, beam, own, steel)
    code, state = code_of(steel), results.limit_state
    assert code.beams is not None
    required = code.bending(steel, state).required
    M, V = section.share * own.moment, section.share * own.shear

    def need(what: str, area: Array, least: float, force: Array, places: Integers) -> BeamNeed:
        most = int(np.argmax(area + TIE * np.abs(force)))
        wanted = max(float(area[most]), least)
        at = int(places[most])
        return BeamNeed(own.name, what, wanted, least, float(force[most]), float(own.way[at]), results.combination)

    everywhere = np.arange(len(M))
    for face, (what, sign) in enumerate((("bottom", 1.0), ("top", -1.0))):
        d, d_2 = section.d[face], section.h - section.d[1 - face]
        area = _bars(required, np.maximum(sign * M, 0.0), section, face, d, d_2)
        least = code.beams.minimum(steel, state, d, section.h) * section.b if area.any() else 0.0
        yield need(what, area, least, np.where(sign * M > 0, M, 0.0), everywhere)
    away, d = np.flatnonzero(own.away_from_ends(section.h)), min(section.d)
    links = code.beams.links(steel, state, np.abs(V[away]) / section.b, d) * section.b
    yield need("links", links, float(code.beams.links(steel, state, np.zeros(1), d)[0]) * section.b, V[away], away)


def _bars(required: Callable[..., Bending], m: Array, section: _Section, face: int, d: float, d_2: float) -> Array:
    """Return the bars in tension (n,) [m2] at a face for moments m >= 0 (n,) [N m]."""
    narrow = required(m / section.b, d, d_2=d_2, thickness=section.h).tension * section.b
    width = section.compressed[face]
    if width == section.b:
        return np.asarray(narrow)
    wide = required(m / width, d, thickness=section.h)
    return np.where(wide.neutral_axis * d <= section.flange, wide.tension * width, narrow)


def _section(results: CombinationResult, beam: Beam, own: BeamResult, steel: Reinforcement) -> _Section:
    """Return the section of a beam of concrete on the slab, whose least thickness along it counts."""
    section = beam.section
    assert not isinstance(section, GivenSection)
    axes = beam.bar_axis or max(steel.bottom_axes), beam.bar_axis or max(steel.top_axes)
    b = section.width
    if not isinstance(section, RibSection):
        h = section.height
        return _Section(1.0, h, b, (b, b), np.inf, (h - axes[0], h - axes[1]))
    model = results.model
    t = float(results.elements.thickness[results.plate.element_at(*own.nodes.T)].min())
    x, y = own.nodes[len(own.nodes) // 2]
    plate = model.every_plate[PlateRegion(model.plate, model.plates).plate_at((float(x), float(y)))]
    share = 1 + plate.E * section.effective_width * t**3 / 12 / beam.rigidities(plate.E, plate.nu, t)[0]
    h = section.height + t
    wide = (section.effective_width, b) if section.side == "below" else (b, section.effective_width)
    return _Section(share, h, b, wide, t, (h - axes[0], h - axes[1]))
