"""Bars and links that beams of concrete, and strips that are beams, need in the ultimate combinations, by the code.

A rectangle takes its own moment. A rib acts as a T with its flange: the slab's moment over the flange's width adds to
the rib's, and the shear force is the slope of both. Where the flange is compressed it counts with its effective width,
as long as the neutral axis lies in it; else the rib's width counts alone, which is on the safe side. All torsion that a
beam has in the analysis is designed for; one that compatibility alone twists can be released from it (EN 1992-1-1
6.3.1(2), ACI 318-19 22.7.3.2). Bars of the slab do not count.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from groundslab.arrays import Array, Flags, made_once
from groundslab.design.bars.members import Member, Section, StripMember, across, members_of
from groundslab.design.codes.eurocode2.struts import LEVER
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.beam_supports import shear_forces
from groundslab.design.demands.cuts.section_cuts import length_across
from groundslab.design.rules.bending import Reinforcement as Bending
from groundslab.design.rules.bending_steps import BarsNeeded
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.demand_errors import error_along
from groundslab.design.rules.design_code import TensionZone
from groundslab.design.rules.webs import Flange, Web, WebNeed
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS
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


@made_once
def courses(combined: Results, steel: Reinforcement) -> list[MemberCourse]:
    """Return what each beam of concrete, and each strip that is one, needs along it in all ultimate combinations.

    None where the code has no rule for beams.
    """
    if code_of(steel).beams is None:
        return []
    return [
        course_of(results, member, steel)
        for member in members_of(combined.model)
        for results in ultimate_results(combined)
    ]


@made_once
def beam_needs(combined: Results, steel: Reinforcement) -> list[BeamNeed]:
    """Return what each beam of concrete, and each strip that is one, needs, of all ultimate combinations the most."""
    governing: list[BeamNeed] = []
    for member in members_of(combined.model):
        needs = [
            need
            for course in courses(combined, steel)
            if course.member.name == member.name
            for need in _needs(combined.results[course.combination], course, steel)
        ]
        governing += [max(of_kind, key=lambda need: need.area) for what in WHAT
                  if (of_kind := [need for need in needs if need.what == what])]  # fmt: skip
    return governing


def strip_areas(combined: Results, steel: Reinforcement, nodes: Array) -> dict[str, Array]:
    """Return the bars that strips that are beams need over their width at the plate's nodes (n,) [m2/m], by layer.

    At both faces half of those for torsion is among them. A node has the most of what is needed up to the next ones, so
    that bars that are enough at nodes are so between them. Elsewhere strips need none.
    """
    from scipy.ndimage import maximum_filter1d

    needs = {layer: np.zeros(len(nodes)) for layer in LAYERS}
    for course in courses(combined, steel):
        if isinstance(course.member, StripMember):
            within, way = course.member.nodes(nodes)
            ways = course.forces.way
            reach = np.diff(np.unique(np.round(way, 9))).max(initial=0.0)
            size = 2 * math.ceil(reach / np.diff(ways).min()) + 1
            for layer, area in zip(course.member.layers, course.faces, strict=True):
                needed = np.interp(way, ways, maximum_filter1d(area / course.section.b, size, mode="nearest"))
                needs[layer][within] = np.maximum(needs[layer][within], needed)
    return needs


def error_of_need(combined: Results, steel: Reinforcement, need: BeamNeed) -> float | None:
    """Return the estimated error of what a beam's "struts" use, or of the stress of its "flange" [Pa].

    None without a coarser mesh, or where the concrete is too weak for any number.
    """
    member = next(member for member in members_of(combined.model) if member.name == need.beam)

    def course(mesh: CombinationResult) -> tuple[Array, Array]:
        needs = _needs(mesh, course_of(mesh, member, steel), steel)
        along = next(candidate.course for candidate in needs if candidate.what == need.what)
        assert along is not None
        return along

    results = combined.results[need.combination]
    half_an_element = float(np.diff(member.forces(results).way).max())  # its places are ends and middles of sides
    return error_along(results, course, half_an_element)


@dataclass(frozen=True, slots=True)
class MemberCourse:
    """What a member needs all along it in a combination: of bars at places (k,), of links and for torsion at (p,)."""

    member: Member
    combination: str
    forces: BeamResult  # at k places
    section: Section
    bars: tuple[Array, Array]  # (k,) each: at the bottom and the top [m2]
    least: tuple[Array, Array]  # (k,) each: where there is a moment of that face
    width: tuple[Array, Array]  # (k,) each: in compression [m]
    alone: tuple[Flags, Flags]  # (k,) each: where concrete bears it without bars in compression
    part: BeamResult  # at p places, between d from its ends
    at_d: Section  # there
    webs: Web  # what links carry
    strained: Web  # what struts bear
    web: WebNeed
    used: Array  # (p,): of what struts bear

    def legs_apart(self, steel: Reinforcement, diameter: float, legs: float | Array) -> Array:
        """Return how far legs of links are from each other [m], the outer ones within the lesser cover."""
        side = 0.0 if steel.cover is None else min(steel.cover)
        return np.asarray((self.at_d.b - 2 * side - diameter) / (np.asarray(legs) - 1))

    @property
    def faces(self) -> tuple[Array, Array]:
        """Return the bars (k,) [m2] at the bottom and the top with half of those for torsion at each."""
        of_torsion = np.interp(self.forces.way, self.part.way, self.web.along) / 2
        return self.bars[0] + of_torsion, self.bars[1] + of_torsion


def course_of(results: CombinationResult, member: Member, steel: Reinforcement) -> MemberCourse:
    """Return what a member needs all along it in a combination."""
    forces = member.forces(results)
    section = member.section(results, forces, steel)
    code, state = code_of(steel), results.limit_state
    assert code.beams is not None
    required = code.bending(steel, state).required
    moments = [np.maximum(sign * forces.moment, 0.0) for sign in (1.0, -1.0)]
    least = [np.where(m > 0, code.beams.minimum(steel, state, section.tension(face)), 0.0)
             for face, m in enumerate(moments)]  # fmt: skip
    bars = [_bars(required, m, section, face) for face, m in enumerate(moments)]
    area, width, alone = zip(*bars, strict=True)
    part = forces.between_ends(float(np.minimum(*section.d).min()))
    at_d = member.section(results, part, steel)
    faces = member.faces(results.model, float(forces.way[-1]))
    V, at_faces = shear_forces(forces, part, faces, float(np.minimum(*at_d.d).max()))
    twisted = member.twisted(results.model, part.way)
    webs = at_d.webs(V, part.torsion * twisted, released=member.released)
    web = code.beams.web(steel, state, webs)
    # the shear force at a support must not exceed V_Rd,max (6.2.1(8))
    strained = webs._replace(V=at_faces) if code.beams.struts_at_faces else webs
    used = code.beams.web(steel, state, strained).used
    wanted = tuple(np.maximum(of_face, at_least) for of_face, at_least in zip(area, least, strict=True))
    return MemberCourse(
        member,
        results.combination,
        forces,
        section,
        bars=(wanted[0], wanted[1]),
        least=(least[0], least[1]),
        width=width,
        alone=alone,
        part=part,
        at_d=at_d,
        webs=webs,
        strained=strained,
        web=web,
        used=used,
    )


def _needs(results: CombinationResult, course: MemberCourse, steel: Reinforcement) -> Iterator[BeamNeed]:
    """Yield what a member needs at both faces and of links in a combination, each at the place of the most."""
    forces, part, web = course.forces, course.part, course.web

    def need(what: str, area: Array, least: Array, force: Array, ways: Array) -> tuple[BeamNeed, int]:
        wanted = np.maximum(area, least)
        most = int(np.argmax(wanted + TIE * np.abs(force)))
        way = float(ways[most])
        return BeamNeed(forces.name, what, float(wanted[most]), float(least[most]), float(force[most]), way,
                        _place(forces, way), results.combination), most  # fmt: skip

    for face, (what, sign) in enumerate((("bottom", 1.0), ("top", -1.0))):
        bent = np.where(sign * forces.moment > 0, forces.moment, 0.0)
        _, place = need(what, course.bars[face], course.least[face], bent, forces.way)
        yield face_need(course, face, place)
    for what, area, least, carried in (
        ("links", web.links, web.least_links, course.webs),
        ("torsion", web.along, web.least_along, course.webs),
        ("struts", course.used, np.zeros(len(course.used)), course.strained),
    ):
        most, place = need(what, area, least, np.copysign(carried.V, part.shear), part.way)
        values = (part.way, course.used) if what == "struts" else None
        yield replace(most, web=carried.at(place), torsion=float(web.torsion[place]), course=values)
    if course.member.rib:
        share = np.interp(part.way, forces.way, _larger_side(results, forces, course.section))
        yield _flange_need(results, part, course.at_d, share, steel)


def face_need(course: MemberCourse, face: int, place: int) -> BeamNeed:
    """Return what a member needs at a face, 0 the bottom, at one place."""
    forces, section = course.forces, course.section
    m = max((1.0, -1.0)[face] * float(forces.moment[place]), 0.0)
    force, way = (float(forces.moment[place]) if m > 0 else 0.0), float(forces.way[place])
    area, least = float(course.bars[face][place]), float(course.least[face][place])
    b, h = float(course.width[face][place]), float(section.h[place])
    per = BarsNeeded(force / b, h, h - float(section.d[face][place]), area / b, least / b)
    return BeamNeed(
        forces.name, WHAT[face], area, least, force, way, _place(forces, way), course.combination,
        bars=per if m > 0 and course.alone[face][place] else None, width=b, zone=section.tension(face).at(place),
    )  # fmt: skip


def _place(beam: BeamResult, way: float) -> tuple[float, float]:
    """Return the place so far along a beam [m]."""
    x, y = (float(np.interp(way, beam.way, column)) for column in beam.nodes.T)
    return x, y


def _flange_need(
    results: CombinationResult, part: BeamResult, section: Section, share: Array, steel: Reinforcement
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


def _larger_side(results: CombinationResult, beam: BeamResult, section: Section) -> Array:
    """Return the share (k,) of the flange's width on the plate that lies on the side on which it reaches further."""
    near, far = section.b / 2, max(section.compressed) / 2
    if far <= near:
        return np.zeros(len(beam.way))
    middle, left = across(beam, 1.0)
    sides = [
        length_across(results.plate, np.stack([middle + sign * near * left, middle + sign * far * left], axis=1))
        for sign in (1.0, -1.0)
    ]
    return np.asarray(np.maximum(*sides) / (sides[0] + sides[1] + section.b))


def _bars(required: Callable[..., Bending], m: Array, section: Section, face: int) -> tuple[Array, Array, Flags]:
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
