"""The bars as they are cut and bent, mark by mark: their sides, hooks, mandrels and numbers.

Sides are those of the outside: from corner to corner, and at a bend of more than 90 degrees to its outer tangent. The
cut length is their sum: bends take nothing off. Links of beams are closed, with hooks of 135 degrees at one corner,
their inner legs single; single legs, against punching too, have a hook of 135 degrees at one end and one of 90 at the
other. Where the rules of the code are not known here, links have no hooks. Welded meshes are
delivered as sheets, and are not in it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from groundslab.design.bars.further_links import LaidLinks, further_links
from groundslab.design.bars.positions import STRAIGHT, U_SHAPE, Position, positions, to_cut
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.detailing_rule import BendRule
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.model.design.laid_bars import DENSITY
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.unit_systems import INCH, KIP, System

#: A link: closed, a single leg, and a stud with heads, which nobody bends.
CLOSED: Literal["link"] = "link"
LEG: Literal["leg"] = "leg"
STUD: Literal["stud"] = "stud"
Shape = Literal["straight", "U", "link", "leg", "stud"]
#: What the layer of links is called.
LINKS = "links"
#: Grades of ASTM A615 and A706, and f_y of each [Pa]: in ksi, and in MPa as the metric standards have it.
GRADES = {
    grade: (grade * KIP / INCH**2, metric * 1e6)
    for grade, metric in ((40, 280), (60, 420), (75, 520), (80, 550), (100, 690))
}
#: How far bars are turned at corners, and at the hooks of links [deg].
RIGHT, HOOK = 90, 135


@dataclass(frozen=True, slots=True)
class BentBar:
    """Bars that are cut to one length and bent alike.

    Attributes
    ----------
    mark : str
        That of the position, with a number behind it where that has several lengths or shapes.
    layer : str
        The set of bars that they belong to, or LINKS.
    shape : str
        STRAIGHT, U_SHAPE, CLOSED, LEG or STUD.
    diameter : float
        [m].
    number : int
        Of bars.
    sides : tuple of float
        The outer sides that differ, without hooks [m]: of a U leg, back and leg, of a closed link across and upright.
    hooks : tuple of float
        Of a closed link both hooks of 135 degrees, of a leg that of 135 and that of 90 [m]; empty without hooks.
    mandrel : float or None
        The least diameter of the mandrel [m]; None where the code's is not known here.
    """

    mark: str
    layer: str
    shape: Shape
    diameter: float
    number: int
    sides: tuple[float, ...]
    hooks: tuple[float, ...] = ()
    mandrel: float | None = None

    @property
    def legs(self) -> tuple[float, ...]:
        """Return all sides one after another [m], hooks at the ends."""
        sides = 2 * self.sides if self.shape == CLOSED else self.sides
        return (*self.hooks[:1], *sides, *self.hooks[1:])

    @property
    def bends(self) -> tuple[int, ...]:
        """Return the angles between the legs [deg]."""
        inner = (RIGHT,) * (len(self.legs) - 1 - len(self.hooks))
        if not self.hooks:
            return inner
        return (HOOK, *inner, HOOK if self.shape == CLOSED else RIGHT)

    @property
    def length(self) -> float:
        """Return the cut length of one [m]."""
        return sum(self.legs)

    @property
    def total(self) -> float:
        """Return the length of all [m]."""
        return self.number * self.length

    @property
    def one_mass(self) -> float:
        """Return the mass of one [kg]."""
        return DENSITY * math.pi * self.diameter**2 / 4 * self.length

    @property
    def mass(self) -> float:
        """Return the mass of all [kg]."""
        return self.number * self.one_mass


def bent_bars(model: Model, links: Sequence[LinkLayout] = ()) -> list[BentBar]:
    """Return all bars that a model lays as they are cut and bent, and of results the links.

    Lengths are as `to_cut` rounds them in the units of the case.
    """
    steel = model.reinforcement
    if steel is None or not steel.laid:
        return []
    rule, listed = _bend_rule(steel), positions(model)
    bars = [bar for position in listed if not position.mesh for bar in _of_position(position, rule, model.units)]
    return bars + [bar for of_mark in bent_links(model, links, listed).values() for bar in of_mark]


def bent_links(model: Model, links: Sequence[LinkLayout], listed: Sequence[Position]) -> dict[int, list[BentBar]]:
    """Return all links as they are bent, with their hooks, by their marks."""
    steel = model.reinforcement
    if steel is None:
        return {}
    rule, units = _bend_rule(steel), model.units
    bent = {
        mark: [_of_layout(steel, layout, mark, rule, units)] for mark, layout in marked_links(links, listed).items()
    }
    further = marked_further_links(model, links, listed)
    return bent | {mark: list(_of_links(laid, mark, rule, units)) for mark, laid in further.items()}


def grade_of(steel: Reinforcement) -> str:
    """Return the steel of bars as orders name it: its class, of ACI 318 the grade of ASTM, else f_yk [MPa]."""
    strength = steel.f_yk or 0.0
    if steel.steel is None and steel.code == "ACI 318":
        for grade, sizes in GRADES.items():
            if any(abs(strength - size) <= 1e6 for size in sizes):
                return f"Grade {grade}"
    return steel.steel or f"{strength / 1e6:g}"


def _bend_rule(steel: Reinforcement) -> BendRule | None:
    """Return the rules for bends of the code of a case, None where they are not known here."""
    return None if (detailing := code_of(steel).detailing) is None else detailing.bends


def marked_links(links: Sequence[LinkLayout], listed: Sequence[Position]) -> dict[int, LinkLayout]:
    """Return the links that are laid by their marks, which follow those of the bars."""
    laid = (layout for layout in links if layout.perimeters)
    return dict(enumerate(laid, start=len(listed) + 1))


def marked_further_links(model: Model, links: Sequence[LinkLayout], listed: Sequence[Position]) -> dict[int, LaidLinks]:
    """Return the links of beams and against one-way shear by their marks, which follow those against punching."""
    first = len(listed) + len(marked_links(links, listed)) + 1
    return dict(enumerate(further_links(model), start=first))


def _of_position(position: Position, rule: BendRule | None, units: System) -> Iterator[BentBar]:
    """Yield the bars of a position, those of each length by themselves, the longest first."""
    lengths, numbers = np.unique(to_cut(position.lengths, units), return_counts=True)
    diameter, layer = position.bars.diameter, position.layer.replace("_", " ")
    mandrel = None if rule is None else rule.mandrel(diameter)
    for part, (length, number) in enumerate(zip(lengths[::-1], numbers[::-1].tolist(), strict=True), 1):
        mark = f"{position.mark}" if len(lengths) == 1 else f"{position.mark}-{part}"
        if position.shape == U_SHAPE:
            whole, leg = _to_bend((float(position.lengths[0]), position.lap or 0.0), units)
            sides = (leg, *_to_bend((whole - 2 * leg,), units), leg)
            yield BentBar(mark, layer, U_SHAPE, diameter, number, sides, (), mandrel)
        else:
            yield BentBar(mark, layer, STRAIGHT, diameter, number, (float(length),), (), mandrel)


def _of_layout(steel: Reinforcement, layout: LinkLayout, mark: int, rule: BendRule | None, units: System) -> BentBar:
    """Return the legs against punching around one column, pile, zone or end of a wall."""
    laid = steel.links_at(layout.name)
    if laid is not None and laid.kind == "studs":
        return BentBar(f"{mark}", LINKS, STUD, layout.diameter, layout.number, _to_bend((layout.leg,), units))
    return _leg(f"{mark}", layout.diameter, layout.number, layout.leg, rule, units)


def _of_links(laid: LaidLinks, mark: int, rule: BendRule | None, units: System) -> Iterator[BentBar]:
    """Yield the closed links of a beam and their inner legs, or the legs in a part of a slab."""
    if laid.sides is None:
        yield _leg(f"{mark}", laid.diameter, laid.number, laid.length, rule, units)
        return
    across, upright = _to_bend(laid.sides, units)
    inner = laid.legs - 2
    hooks: tuple[float, ...] = ()
    mandrel = None
    if rule is not None:
        hooks, mandrel = 2 * (_hook(rule, laid.diameter, HOOK, units),), rule.link_mandrel(laid.diameter)
    first = f"{mark}-1" if inner else f"{mark}"
    yield BentBar(first, LINKS, CLOSED, laid.diameter, laid.number, (across, upright), hooks, mandrel)
    if inner:
        yield _leg(f"{mark}-2", laid.diameter, inner * laid.number, upright, rule, units)


def _leg(mark: str, diameter: float, number: int, length: float, rule: BendRule | None, units: System) -> BentBar:
    """Return single legs of links."""
    hooks: tuple[float, ...] = ()
    mandrel = None
    if rule is not None:
        hooks = (_hook(rule, diameter, HOOK, units), _hook(rule, diameter, RIGHT, units))
        mandrel = rule.link_mandrel(diameter)
    return BentBar(mark, LINKS, LEG, diameter, number, _to_bend((length,), units), hooks, mandrel)


def _to_bend(sides: Sequence[float], units: System) -> tuple[float, ...]:
    """Return sides [m] as they are bent."""
    return tuple(to_cut(np.array(sides), units, bent=True).tolist())


def _hook(rule: BendRule, diameter: float, angle: float, units: System) -> float:
    """Return the length of a hook [m], rounded up to whole millimeters, or to quarters of an inch."""
    per_meter = 1e3 if units == "SI" else 4 / INCH
    return math.ceil(rule.hook_side(diameter, angle) * per_meter - 1e-6) / per_meter
