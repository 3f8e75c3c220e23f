"""Bars and links that beams of concrete need in the ultimate combinations, by the code of the case.

A rectangle takes its own moment. A rib acts as a T with its flange: the slab's moment over the flange's width adds to
the rib's, and the shear force is the slope of both. Where the flange is compressed it counts with its effective width,
as long as the neutral axis lies in it; else the rib's width counts alone, which is on the safe side. Torsion by
compatibility needs no design (EN 1992-1-1 6.3.1(2), ACI 318-19 22.7.3.2); none other is looked at. Bars of the slab do
not count.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from groundslab.arrays import Array
from groundslab.design.basis.combinations import ultimate_results
from groundslab.design.bending import Reinforcement as Bending
from groundslab.design.codes import code_of
from groundslab.design.demands.section_cuts import moments_across
from groundslab.fem.mesh import Mesh, locate
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.structure.beams import Beam, GivenSection, RibSection
from groundslab.results.record import BeamResult
from groundslab.results.results import CombinationResult, Results

#: What is looked for: bars at both faces, and links.
WHAT = ("bottom", "top", "links")
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
    """A concrete section at k places along a beam, as the code needs it."""

    h: Array  # (k,): height [m]
    b: float  # of the web [m]
    compressed: tuple[float, float]  # width where the beam sags, where it hogs [m]
    flange: Array  # (k,): thickness of the flange [m]; infinite without one
    d: tuple[Array, Array]  # (k,) each: effective depth where it sags, where it hogs [m]


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


def section_forces(results: CombinationResult, beam: Beam, own: BeamResult) -> BeamResult:
    """Return a beam with M and V of its section: of a rib with what the slab carries over the flange's width."""
    if not isinstance(beam.section, RibSection):
        return own
    runs = np.split(np.arange(len(own.way)), np.flatnonzero(np.diff(own.way) <= SAME * own.way[-1]) + 1)
    runs = [run for run in runs if len(run) > 1]
    along, turn = np.zeros_like(own.nodes), np.zeros(len(own.way))
    for run in runs:
        way = _slope(own.nodes[run], own.way[run])
        along[run] = way / np.linalg.norm(way, axis=1, keepdims=True)
        turn[run] = _slope(np.unwrap(np.arctan2(along[run, 1], along[run, 0])), own.way[run])
    middle = own.nodes.copy()
    for run in runs:  # off the lines at which the slab's moments may jump
        middle[run[[0, -1]]] += INSIDE * (middle[run[[1, -2]]] - middle[run[[0, -1]]])
    left = beam.section.flange_width / 2 * np.stack([-along[:, 1], along[:, 0]], axis=1)
    M, T = moments_across(results.plate, np.stack([middle - left, middle + left], axis=1))
    V = -turn * T
    for run in runs:
        V[run] += _slope(M[run], own.way[run])
    return replace(own, moment=own.moment + M, shear=own.shear + V)


def _slope(values: Array, way: Array) -> Array:
    """Return the derivative of values (k,) or (k, 2) along k places."""
    found: Array = np.gradient(values, way, axis=0, edge_order=2 if len(way) > 2 else 1)
    return found


def _needs(results: CombinationResult, number: int, beam: Beam, steel: Reinforcement) -> Iterator[BeamNeed]:
    """Yield what a beam needs at both faces and of links in a combination, each at the place of the most."""
    own = section_forces(results, beam, results.beams[number])
    section = _section(results, beam, own, steel)
    code, state = code_of(steel), results.limit_state
    assert code.beams is not None
    required = code.bending(steel, state).required
    M = own.moment

    def need(what: str, area: Array, least: Array, force: Array, ways: Array) -> BeamNeed:
        wanted = np.maximum(area, least)
        most = int(np.argmax(wanted + TIE * np.abs(force)))
        return BeamNeed(own.name, what, float(wanted[most]), float(least[most]), float(force[most]),
                        float(ways[most]), results.combination)  # fmt: skip

    for face, (what, sign) in enumerate((("bottom", 1.0), ("top", -1.0))):
        m = np.maximum(sign * M, 0.0)
        area = _bars(required, m, section, face)
        least = _at_each(partial(code.beams.minimum, steel, state), section.d[face], section.h) * section.b
        yield need(what, area, np.where(m > 0, least, 0.0), np.where(m > 0, M, 0.0), own.way)
    part = own.between_ends(float(np.minimum(*section.d).min()))
    section = _section(results, beam, part, steel)
    V, d = part.shear, np.minimum(*section.d)
    v = np.abs(V) / section.b
    links, least = np.empty(len(v)), np.empty(len(v))
    for depth in np.unique(d):
        some = d == depth
        links[some] = code.beams.links(steel, state, v[some], float(depth)) * section.b
        least[some] = code.beams.links(steel, state, np.zeros(1), float(depth)) * section.b
    yield need("links", links, least, V, part.way)


def _at_each(rule: Callable[[float, float], float], d: Array, h: Array) -> Array:
    """Return what a rule gives for depths (k,) and heights (k,) [m]."""
    pairs, which = np.unique(np.column_stack([d, h]), axis=0, return_inverse=True)
    return np.array([rule(float(depth), float(height)) for depth, height in pairs])[which.reshape(-1)]


def _bars(required: Callable[..., Bending], m: Array, section: _Section, face: int) -> Array:
    """Return the bars in tension (k,) [m2] at a face for moments m >= 0 (k,) [N m]."""
    d, d_2 = section.d[face], section.h - section.d[1 - face]
    narrow = required(m / section.b, d, d_2=d_2, thickness=section.h).tension * section.b
    width = section.compressed[face]
    if width == section.b:
        return np.asarray(narrow)
    wide = required(m / width, d, thickness=section.h)
    return np.where(wide.neutral_axis * d <= section.flange, wide.tension * width, narrow)


def _section(results: CombinationResult, beam: Beam, own: BeamResult, steel: Reinforcement) -> _Section:
    """Return the section of a beam of concrete along it; of the plate on both sides the thinner one is its flange."""
    section = beam.section
    assert not isinstance(section, GivenSection)
    axes = beam.bar_axis or max(steel.bottom_axes), beam.bar_axis or max(steel.top_axes)
    b = section.width
    if not isinstance(section, RibSection):
        h = np.full(len(own.way), section.height)
        return _Section(h, b, (b, b), np.inf * h, (h - axes[0], h - axes[1]))
    t = _flange(results, own)
    width = section.flange_width
    h = section.height + t
    wide = (width, b) if section.side == "below" else (b, width)
    return _Section(h, b, wide, t, (h - axes[0], h - axes[1]))


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
        there = element >= 0
        own_t = np.where(there, results.elements.thickness[element], np.inf)
        thinnest[between] = np.minimum(thinnest[between], own_t)
    goes_on = np.append(length > 0, False)
    after, before = np.append(thinnest, np.inf), np.insert(thinnest, 0, np.inf)
    return np.where(goes_on, after, before)
