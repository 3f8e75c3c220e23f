"""Links of beams, and of strips that are beams, that are proposed: even along each of them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from groundslab.design.bars.beam_bars import MemberCourse, courses
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.design_code import BeamRule
from groundslab.messages import Message, Name
from groundslab.model.design.beam_links import BeamLinks
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

#: Links are multiples of this apart, and at least so far [m].
STEP, NEAREST = 0.025, 0.075
#: No link has more legs.
MOST_LEGS = 12
#: What counts as rounding, relative.
ROUNDING = 1e-9


def beam_links(combined: Results, diameters: Sequence[float]) -> Iterator[BeamLinks | Message]:
    """Yield the links with the least steel along each member, of some diameters [m], or why there are none."""
    steel = combined.model.reinforcement
    if steel is None or (rule := code_of(steel).beams) is None:
        return
    states = {name: results.limit_state for name, results in combined.results.items()}
    every = courses(combined, steel)
    for name in dict.fromkeys(course.member.name for course in every):
        of_member = [course for course in every if course.member.name == name]
        options = [
            BeamLinks(of=name, diameter=diameter, legs=legs, spacing=round(spacing, 6))
            for diameter in diameters
            for legs in range(2, MOST_LEGS + 1)
            if (spacing := _spacing(of_member, states, steel, rule, diameter, legs)) >= NEAREST
        ]
        if options:
            yield min(options, key=lambda links: (links.area, links.legs, -links.spacing))
        else:
            yield Message("no links that are allowed are enough along {name}", name=Name(name))


def _spacing(
    of_member: list[MemberCourse],
    states: dict[str, str],
    steel: Reinforcement,
    rule: BeamRule,
    diameter: float,
    legs: int,
) -> float:
    """Return how far links of a diameter [m] with some legs may be from each other [m]; 0 where they are not enough."""
    area = BeamLinks(of="", diameter=diameter, legs=legs, spacing=1.0).area
    least = math.inf
    for course in of_member:
        apart = area / course.web.links_of(np.full(len(course.used), legs))
        if rule.link_distances is not None:
            along, across = rule.link_distances(steel, states[course.combination], course.webs, course.used)
            apart = np.where(course.legs_apart(steel, diameter, legs) <= across, np.minimum(apart, along), 0.0)
        least = min(least, float(apart.min()))
    return STEP * math.floor(least / STEP + ROUNDING)
