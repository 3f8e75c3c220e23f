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
from groundslab.design.bars.positions import STRAIGHT, U_SHAPE, Position, positions
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.detailing_rule import BendRule
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.model.design.laid_bars import DENSITY
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model

#: A link: closed, a single leg, and a stud with heads, which nobody bends.
CLOSED: Literal["link"] = "link"
LEG: Literal["leg"] = "leg"
STUD: Literal["stud"] = "stud"
Shape = Literal["straight", "U", "link", "leg", "stud"]
#: What the layer of links is called.
LINKS = "links"
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
    """Return all bars that a model lays as they are cut and bent, to the millimeter, and of results the links."""
    steel = model.reinforcement
    if steel is None or not steel.laid:
        return []
    rule = None if (detailing := code_of(steel).detailing) is None else detailing.bends
    listed = positions(model)
    bars = [bar for position in listed if not position.mesh for bar in _of_position(position, rule)]
    for mark, layout in marked_links(links, listed).items():
        bars.append(_of_layout(steel, layout, mark, rule))
    for mark, laid in marked_further_links(model, links, listed).items():
        bars += _of_links(laid, mark, rule)
    return bars


def marked_links(links: Sequence[LinkLayout], listed: Sequence[Position]) -> dict[int, LinkLayout]:
    """Return the links that are laid by their marks, which follow those of the bars."""
    laid = (layout for layout in links if layout.perimeters)
    return dict(enumerate(laid, start=len(listed) + 1))


def marked_further_links(model: Model, links: Sequence[LinkLayout], listed: Sequence[Position]) -> dict[int, LaidLinks]:
    """Return the links of beams and against one-way shear by their marks, which follow those against punching."""
    first = len(listed) + len(marked_links(links, listed)) + 1
    return dict(enumerate(further_links(model), start=first))


def _of_position(position: Position, rule: BendRule | None) -> Iterator[BentBar]:
    """Yield the bars of a position, those of each length by themselves, the longest first."""
    lengths, numbers = np.unique(np.rint(position.lengths * 1e3), return_counts=True)
    diameter, layer = position.bars.diameter, position.layer.replace("_", " ")
    mandrel = None if rule is None else rule.mandrel(diameter)
    for part, (length, number) in enumerate(zip(lengths[::-1] / 1e3, numbers[::-1].tolist(), strict=True), 1):
        mark = f"{position.mark}" if len(lengths) == 1 else f"{position.mark}-{part}"
        if position.shape == U_SHAPE:
            leg = round(position.lap or 0.0, 3)
            sides = (leg, round(float(length) - 2 * leg, 3), leg)
            yield BentBar(mark, layer, U_SHAPE, diameter, number, sides, (), mandrel)
        else:
            yield BentBar(mark, layer, STRAIGHT, diameter, number, (float(length),), (), mandrel)


def _of_layout(steel: Reinforcement, layout: LinkLayout, mark: int, rule: BendRule | None) -> BentBar:
    """Return the legs against punching around one column, pile, zone or end of a wall."""
    laid = steel.links_at(layout.name)
    if laid is not None and laid.kind == "studs":
        return BentBar(f"{mark}", LINKS, STUD, layout.diameter, layout.number, (round(layout.leg, 3),))
    return _leg(f"{mark}", layout.diameter, layout.number, layout.leg, rule)


def _of_links(laid: LaidLinks, mark: int, rule: BendRule | None) -> Iterator[BentBar]:
    """Yield the closed links of a beam and their inner legs, or the legs in a part of a slab."""
    if laid.sides is None:
        yield _leg(f"{mark}", laid.diameter, laid.number, laid.length, rule)
        return
    across, upright = (round(side, 3) for side in laid.sides)
    inner = laid.legs - 2
    hooks: tuple[float, ...] = ()
    mandrel = None
    if rule is not None:
        hooks, mandrel = 2 * (_hook(rule, laid.diameter, HOOK),), rule.link_mandrel(laid.diameter)
    first = f"{mark}-1" if inner else f"{mark}"
    yield BentBar(first, LINKS, CLOSED, laid.diameter, laid.number, (across, upright), hooks, mandrel)
    if inner:
        yield _leg(f"{mark}-2", laid.diameter, inner * laid.number, upright, rule)


def _leg(mark: str, diameter: float, number: int, length: float, rule: BendRule | None) -> BentBar:
    """Return single legs of links."""
    hooks: tuple[float, ...] = ()
    mandrel = None
    if rule is not None:
        hooks = (_hook(rule, diameter, HOOK), _hook(rule, diameter, RIGHT))
        mandrel = rule.link_mandrel(diameter)
    return BentBar(mark, LINKS, LEG, diameter, number, (round(length, 3),), hooks, mandrel)


def _hook(rule: BendRule, diameter: float, angle: float) -> float:
    """Return the length of a hook [m], rounded up to whole millimeters."""
    return math.ceil(rule.hook_side(diameter, angle) * 1e3 - 1e-6) / 1e3
