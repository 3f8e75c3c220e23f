"""Bars and links that beams of concrete need in the ultimate combinations, by the code of the case.

A rectangle takes its own moment. A rib acts as a T with its flange: the slab's moment over the flange's width adds to
the rib's, and the shear force is the slope of both. Where the flange is compressed it counts with its effective width,
as long as the neutral axis lies in it; else the rib's width counts alone, which is on the safe side. All torsion that a
beam has in the analysis is designed for; one that compatibility alone twists can be released from it (EN 1992-1-1
6.3.1(2), ACI 318-19 22.7.3.2). Bars of the slab do not count.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once
from groundslab.design.codes.eurocode2.struts import LEVER
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.beam_supports import faces_on, shear_forces
from groundslab.design.demands.section_cuts import length_across, moments_across
from groundslab.design.rules.bending import Reinforcement as Bending
from groundslab.design.rules.bending_steps import BarsNeeded
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.demand_errors import error_along
from groundslab.design.rules.design_code import TensionZone
from groundslab.design.rules.webs import Flange, Web
from groundslab.fem.mesh import Mesh, locate
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.structure.beams import Beam, GivenSection, RibSection
from groundslab.results.records import BeamResult
from groundslab.results.results import CombinationResult, Results

#: What is looked for: bars at both faces, links, bars along for torsion, those across a rib between web and flange;
#: how much of its concrete the web uses.
WHAT = ("bottom", "top", "links", "torsion", "flange", "struts")
#: So much of a piece's length beside its middle the plate's thickness is looked up.
BESIDE = 1e-2
#: Such a share of the way to the next place cuts across the flange move off the ends of a beam and places of jumps.
INSIDE = 1e-6
#: Places so close, relative to a beam's length, are one.
SAME = 1e-9
#: Of places that need as much, the one with the largest force counts.
TIE = 1e-15


@dataclass(frozen=True, slots=True)
class BeamNeed:
    """What a beam needs of bars at a face or for torsion [m2], of links or bars across it [m2/m], at its worst place.

    Of "struts", the area is the share used of what the concrete of its web bears.
    """

    beam: str
    what: str  # one of WHAT
    area: float  # inf where the concrete is too weak
    least: float  # least bars where there is a moment or torsion, or least links
    force: float  # design moment [N m], sagging positive, or shear force [N]
    way: float  # where, from the beam's start [m]
    place: tuple[float, float]  # [m]
    combination: str
    stress: float = 0.0  # shear between web and flange [Pa]
    limit: float = 0.0  # of that what struts bear [Pa]
    bars: BarsNeeded | None = None  # of a face without bars in compression: per meter of the width in compression
    width: float = 0.0  # of these that width [m]
    zone: TensionZone | None = None  # of a face: what is in tension before it cracks
    flange: Flange | None = None  # of a flange: the shear between web and flange
    web: Web | None = None  # of links, torsion and struts: the section there with both forces
    torsion: float = 0.0  # of these the torsional moment that counts, >= 0 [N m]
    #: of struts and flanges: ways (k,) [m], and the shares used or the stresses [Pa] there (k,)
    course: tuple[Array, Array] | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class _Section:
    """A concrete section at k places along a beam, as the code needs it."""

    h: Array  # (k,): height [m]
    b: float  # of the web [m]
    compressed: tuple[float, float]  # width where the beam sags, where it hogs [m]
    flange: Array  # (k,): thickness of the flange [m]; infinite without one
    d: tuple[Array, Array]  # (k,) each: effective depth where it sags, where it hogs [m]
    diameter: float  # of its bars [m]

    def webs(self, part: BeamResult, V: Array, *, released: bool) -> Web:
        """Return the webs at the places, with the shear forces V (k,) [N] that they carry."""
        d = np.minimum(*self.d)
        return Web(V, np.abs(part.torsion), self.b, self.h, d, float((self.h - d).max()), released)

    def tension(self, face: int) -> TensionZone:
        """Return the zone in tension before it cracks, at the bottom where it sags (face 0) or at the top (1)."""
        h, b, wide, width = self.h, self.b, max(self.compressed), self.compressed[1 - face]
        t = np.minimum(self.flange, h)
        A, web = wide * t + b * (h - t), b * (h - t)
        y = (wide * t**2 / 2 + web * (h + t) / 2) / A  # of the centroid from the flange's face
        inertia = (
            wide * t**3 / 12 + wide * t * (y - t / 2) ** 2 + web * (h - t) ** 2 / 12 + web * ((h + t) / 2 - y) ** 2
        )
        of_flange = width > b
        inside = np.minimum(t, y)
        mean = (wide * inside + b * (y - inside)) / y if of_flange else np.full(len(h), b)
        depth = y if of_flange else h - y
        return TensionZone(self.d[face], inertia / depth, mean, b, width, h, depth, self.flange, self.diameter)


@made_once
def beam_needs(combined: Results, steel: Reinforcement) -> list[BeamNeed]:
    """Return what each beam of concrete needs, of all ultimate combinations the most."""
    governing: list[BeamNeed] = []
    for number, beam in enumerate(combined.model.beams):
        if isinstance(beam.section, GivenSection):
            continue
        needs = [need for result in ultimate_results(combined) for need in _needs(result, number, beam, steel)]
        governing += [max(of_kind, key=lambda need: need.area) for what in WHAT
                  if (of_kind := [need for need in needs if need.what == what])]  # fmt: skip
    return governing


def error_of_need(combined: Results, steel: Reinforcement, need: BeamNeed) -> float | None:
    """Return the estimated error of what a beam's "struts" use, or of the stress of its "flange" [Pa].

    None without a coarser mesh, or where the concrete is too weak for any number.
    """
    number = next(number for number, beam in enumerate(combined.model.beams) if beam.name == need.beam)

    def course(mesh: CombinationResult) -> tuple[Array, Array]:
        needs = _needs(mesh, number, combined.model.beams[number], steel)
        found = next(each.course for each in needs if each.what == need.what)
        assert found is not None
        return found

    results = combined.results[need.combination]
    half_an_element = float(np.diff(results.beams[number].way).max())  # its places are ends and middles of sides
    return error_along(results, course, half_an_element)


def section_forces(results: CombinationResult, beam: Beam, own: BeamResult) -> BeamResult:
    """Return a beam with M and V of its section: of a rib with what the slab carries over the flange's width."""
    if not isinstance(beam.section, RibSection):
        return own
    middle, left = _across(own, beam.section.flange_width / 2)
    M, T = moments_across(results.plate, np.stack([middle - left, middle + left], axis=1))
    V = np.zeros(len(M))
    for run in _runs(own):
        turn = _slope(np.unwrap(np.arctan2(left[run, 1], left[run, 0])), own.way[run])
        V[run] = _slope(M[run], own.way[run]) - turn * T[run]
    return replace(own, moment=own.moment + M, shear=own.shear + V)


def _runs(own: BeamResult) -> list[Integers]:
    """Return the places between which section forces are smooth."""
    return np.split(np.arange(len(own.way)), np.flatnonzero(np.diff(own.way) <= SAME * own.way[-1]) + 1)


def _across(own: BeamResult, distance: float) -> tuple[Array, Array]:
    """Return places along a beam (k, 2) [m], and vectors so long [m] to its left (k, 2).

    They are off the lines at which what the slab carries may jump.
    """
    middle, left = own.nodes.copy(), np.zeros_like(own.nodes)
    for run in _runs(own):
        along = _slope(own.nodes[run], own.way[run])
        left[run] = distance * np.column_stack([-along[:, 1], along[:, 0]]) / np.linalg.norm(along, axis=1)[:, None]
        middle[run[[0, -1]]] += INSIDE * (middle[run[[1, -2]]] - middle[run[[0, -1]]])
    return middle, left


def _slope(values: Array, way: Array) -> Array:
    """Return the derivative of values (k,) or (k, 2) along k places."""
    slope: Array = np.gradient(values, way, axis=0, edge_order=2 if len(way) > 2 else 1)
    return slope


def _needs(results: CombinationResult, number: int, beam: Beam, steel: Reinforcement) -> Iterator[BeamNeed]:
    """Yield what a beam needs at both faces and of links in a combination, each at the place of the most."""
    forces = section_forces(results, beam, results.beams[number])
    section = _section(results, beam, forces, steel)
    code, state = code_of(steel), results.limit_state
    assert code.beams is not None
    required = code.bending(steel, state).required
    M = forces.moment

    def need(what: str, area: Array, least: Array, force: Array, ways: Array) -> tuple[BeamNeed, int]:
        wanted = np.maximum(area, least)
        most = int(np.argmax(wanted + TIE * np.abs(force)))
        way = float(ways[most])
        return BeamNeed(forces.name, what, float(wanted[most]), float(least[most]), float(force[most]), way,
                        _place(forces, way), results.combination), most  # fmt: skip

    for face, (what, sign) in enumerate((("bottom", 1.0), ("top", -1.0))):
        m = np.maximum(sign * M, 0.0)
        area, width, alone = _bars(required, m, section, face)
        zone = section.tension(face)
        least = code.beams.minimum(steel, state, zone)
        most, place = need(what, area, np.where(m > 0, least, 0.0), np.where(m > 0, M, 0.0), forces.way)
        b, h = float(width[place]), float(section.h[place])
        per = BarsNeeded(most.force / b, h, h - float(section.d[face][place]), most.area / b, most.least / b)
        followed = per if m[place] > 0 and alone[place] else None
        yield replace(most, bars=followed, width=b, zone=zone.at(place))
    part = forces.between_ends(float(np.minimum(*section.d).min()))
    section = _section(results, beam, part, steel)
    faces = faces_on(results.model, beam, float(forces.way[-1]))
    V, at_faces = shear_forces(forces, part, faces, float(np.minimum(*section.d).max()))
    webs = section.webs(part, V, released=beam.torsion == "released")
    web = code.beams.web(steel, state, webs)
    # the shear force at a support must not exceed V_Rd,max (6.2.1(8))
    strained = webs._replace(V=at_faces) if code.beams.struts_at_faces else webs
    used = code.beams.web(steel, state, strained).used
    for what, area, least, carried in (
        ("links", web.links, web.least_links, webs),
        ("torsion", web.along, web.least_along, webs),
        ("struts", used, np.zeros(len(used)), strained),
    ):
        most, place = need(what, area, least, np.copysign(carried.V, part.shear), part.way)
        course = (part.way, used) if what == "struts" else None
        yield replace(most, web=carried.at(place), torsion=float(web.torsion[place]), course=course)
    if isinstance(beam.section, RibSection):
        share = np.interp(part.way, forces.way, _larger_side(results, forces, section))
        yield _flange_need(results, part, section, share, steel)


def _place(own: BeamResult, way: float) -> tuple[float, float]:
    """Return the place so far along a beam [m]."""
    x, y = (float(np.interp(way, own.way, column)) for column in own.nodes.T)
    return x, y


def _flange_need(
    results: CombinationResult, part: BeamResult, section: _Section, share: Array, steel: Reinforcement
) -> BeamNeed:
    """Return what a rib needs across it for v = V / z times the share (k,) of the flange on its larger side."""
    code, state = code_of(steel), results.limit_state
    assert code.beams is not None
    rule = code.beams.flange
    sags = part.moment > 0
    compressed = sags == (section.compressed[0] > section.b)
    flange = Flange(np.abs(part.shear), LEVER * np.where(sags, *section.d), share, section.flange, compressed)
    stress = flange.stress
    area = rule.bars(steel, state, stress, compressed) * section.flange
    most = int(np.argmax(area + TIE * stress))
    force, way = float(part.shear[most]), float(part.way[most])
    limit = rule.limit(steel, state)
    return BeamNeed(part.name, "flange", float(area[most]), 0.0, force, way, _place(part, way), results.combination,
                    float(stress[most]), limit, flange=flange.at(most), course=(part.way, stress))  # fmt: skip


def _larger_side(results: CombinationResult, own: BeamResult, section: _Section) -> Array:
    """Return the share (k,) of the flange's width on the plate that lies on the side on which it reaches further."""
    near, far = section.b / 2, max(section.compressed) / 2
    if far <= near:
        return np.zeros(len(own.way))
    middle, left = _across(own, 1.0)
    sides = [
        length_across(results.plate, np.stack([middle + sign * near * left, middle + sign * far * left], axis=1))
        for sign in (1.0, -1.0)
    ]
    return np.asarray(np.maximum(*sides) / (sides[0] + sides[1] + section.b))


def _bars(required: Callable[..., Bending], m: Array, section: _Section, face: int) -> tuple[Array, Array, Flags]:
    """Return the bars in tension (k,) [m2] at a face for moments m >= 0 (k,) [N m].

    Also the width that counts in compression (k,) [m], and where concrete alone bears it (k,).
    """
    d, d_2 = section.d[face], section.h - section.d[1 - face]
    by_web = required(m / section.b, d, d_2=d_2, thickness=section.h)
    width = section.compressed[face]
    wide = required(m / width, d, thickness=section.h)
    by_flange = (width > section.b) & (wide.neutral_axis * d <= section.flange)
    area = np.where(by_flange, wide.tension * width, by_web.tension * section.b)
    alone = by_flange | ((by_web.compression == 0) & ~by_web.fails)
    return area, np.where(by_flange, width, section.b), alone


def _section(results: CombinationResult, beam: Beam, own: BeamResult, steel: Reinforcement) -> _Section:
    """Return the section of a beam of concrete along it; of the plate on both sides the thinner one is its flange."""
    section = beam.section
    assert not isinstance(section, GivenSection)
    axes = beam.bar_axis or max(steel.bottom_axes), beam.bar_axis or max(steel.top_axes)
    b = section.width
    if not isinstance(section, RibSection):
        h = np.full(len(own.way), section.height)
        return _Section(h, b, (b, b), np.inf * h, (h - axes[0], h - axes[1]), beam.bar_diameter)
    t = _flange(results, own)
    width = section.flange_width
    h = section.height + t
    wide = (width, b) if section.side == "below" else (b, width)
    return _Section(h, b, wide, t, (h - axes[0], h - axes[1]), beam.bar_diameter)


def _flange(results: CombinationResult, own: BeamResult) -> Array:
    """Return the thickness of the plate along a beam (k,) [m], of both sides the less.

    Where it jumps, the first of the two places there belongs to what comes before.
    """
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    way = np.diff(own.nodes, axis=0)
    length = np.linalg.norm(way, axis=1)
    between = np.flatnonzero(length > 0)
    middle = (own.nodes[between] + own.nodes[between + 1]) / 2
    beside = BESIDE * np.stack([-way[between, 1], way[between, 0]], axis=1)
    thinnest = np.full(len(length), np.inf)
    for places in (middle + beside, middle - beside):
        element = locate(mesh, places)[0]
        on_mesh = element >= 0
        own_t = np.where(on_mesh, results.elements.thickness[element], np.inf)
        thinnest[between] = np.minimum(thinnest[between], own_t)
    goes_on = np.append(length > 0, False)
    after, before = np.append(thinnest, np.inf), np.insert(thinnest, 0, np.inf)
    return np.where(goes_on, after, before)
