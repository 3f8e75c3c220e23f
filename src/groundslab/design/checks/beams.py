"""Links of beams that are given, and the slab's bars along strips that are beams, against what these need."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars import given_steps
from groundslab.design.bars.beam_bars import MemberCourse, course_of, courses
from groundslab.design.bars.members import StripMember, members_of
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import DesignCheck, judge_apart
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.demand_errors import error_along, scaled
from groundslab.design.rules.design_code import BeamRule
from groundslab.design.rules.punching_links.demand import LinkLimit
from groundslab.messages import Clause, Message, Name, quantity
from groundslab.model.design.beam_links import BeamLinks
from groundslab.model.design.laid_bars import laid_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import place_of
from groundslab.results.results import CombinationResult, Results

LINKS, BARS = "links of beams", "bars of strips"
CM2 = 1e4
#: The slab's bars are read at so many places over the width of a strip.
ACROSS = 16
#: What counts as rounding, relative.
ROUNDING = 1e-9


class Judged(NamedTuple):
    """What a member needs or keeps to at its worst place, and what it has."""

    member: str
    limit: LinkLimit
    way: float  # from its start [m]
    place: tuple[float, float]  # [m]
    combination: str
    along: tuple[Array, Array]  # ways (k,) [m], and what is used there (k,)
    steps: Callable[[], Iterator[Step]]  # its calculation


#: What finds what a member needs in a combination.
Find = Callable[[CombinationResult, MemberCourse, Reinforcement, BeamRule], Iterator[Judged]]


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the checks of links that are given, and of bars of the slab along strips that are beams."""
    steel, members = combined.model.reinforcement, members_of(combined.model)
    results = ultimate_results(combined)
    if steel is None or not results or not members:
        return
    code = code_of(steel)
    if code.beams is None:
        return
    rule, off = code.beams, combined.model.checks.off
    every = courses(combined, steel)
    links = [judgment for course in every if steel.links_along(course.member.name) or (steel.laid and _is_strip(course))
             for judgment in _links(combined.results[course.combination], course, steel, rule)]  # fmt: skip
    bars = [judgment for course in every if steel.laid and _is_strip(course)
            for judgment in _bars(combined.results[course.combination], course, steel, rule)]  # fmt: skip
    unknown = "" if rule.link_distances is not None else "how far they may be from each other is not known here"
    for name, judged, find, clauses, doubt in (
        (LINKS, links, _links, f"{rule.web_clauses}, {rule.distance_clauses}".rstrip(", "), unknown),
        (BARS, bars, _bars, f"{rule.clauses}, {rule.web_clauses}", ""),
    ):
        if judged:
            error = partial(_error, combined, steel, rule, find)
            judge = partial(_worst, name, f"{code.name} {clauses}", doubt, error)
            yield from judge_apart(judged, lambda judgment: judgment.member, off, judge)


def _is_strip(course: MemberCourse) -> bool:
    """Return whether a member is a strip of the plate."""
    return isinstance(course.member, StripMember)


def _error(combined: Results, steel: Reinforcement, rule: BeamRule, find: Find, worst: Judged) -> float | None:
    """Return the estimated error of the share used by what is used most."""
    member = next(member for member in members_of(combined.model) if member.name == worst.member)

    def along(mesh: CombinationResult) -> tuple[Array, Array]:
        judged = find(mesh, course_of(mesh, member, steel), steel, rule)
        return next(judgment.along for judgment in judged if judgment.limit.what == worst.limit.what)

    results = combined.results[worst.combination]
    return error_along(results, along, float(np.diff(worst.along[0]).max()))


def _worst(
    name: str, clauses: str, doubt: str, error_of: Callable[[Judged], float | None], judged: list[Judged]
) -> Iterator[DesignCheck]:
    """Yield the check of what is used most."""
    worst = max(judged, key=lambda judgment: judgment.limit.used)
    limit = worst.limit
    holds = limit.used <= 1 + ROUNDING
    template = "{name}, {way:.2f m} from its start: {what} {value} {sign} {limit} ({clause})"
    words: str = Message(
        template, name=Name(worst.member), way=worst.way, what=limit.what,
        value=quantity(limit.value, limit.unit), sign="<=" if holds else ">",
        limit=quantity(limit.limit, limit.unit), clause=Clause(limit.clause),
    )  # fmt: skip
    if doubt:
        words += Message("; {doubt}", doubt=doubt)
    finite = limit.limit > 0 and np.isfinite(limit.value)
    yield DesignCheck(
        name, "fails" if not holds else "attention" if doubt else "no failure found", words, of=worst.member,
        demand=limit.value if finite else None, resistance=limit.limit if finite else None, unit=limit.unit,
        combination=worst.combination, place=worst.place, clause=clauses,
        error=scaled(error_of(worst), limit.limit) if finite else None, steps=tuple(worst.steps()) if finite else (),
    )  # fmt: skip


def _judged(
    course: MemberCourse, ways: Array, what: str, values: tuple[Array, Array], units: tuple[str, str],
    steps: Callable[[int], Iterator[Step]],
) -> Judged:  # fmt: skip
    """Return values (k,) against their limits (k,) at the ways (k,) [m] where most is used.

    With both come their unit and the clause, and the steps of a place.
    """
    (value, limit), (unit, clause) = values, units
    used = np.divide(value, limit, out=np.where(value > 0, np.inf, 0.0), where=limit > 0)
    most = int(np.argmax(used))
    nodes = course.forces.nodes
    xy = np.column_stack([np.interp(ways, course.forces.way, column) for column in nodes.T])
    worst = LinkLimit(what, float(value[most]), float(limit[most]), unit, clause)
    return Judged(course.member.name, worst, float(ways[most]), place_of(xy, most), course.combination, (ways, used),
                  partial(steps, most))  # fmt: skip


def _links(results: CombinationResult, course: MemberCourse, steel: Reinforcement, rule: BeamRule) -> Iterator[Judged]:
    """Yield the links of a member in a combination, and how far they and their legs are from each other."""
    way = course.part.way
    area, legs = np.zeros(len(way)), np.full(len(way), 2)
    apart, across = np.zeros(len(way)), np.zeros(len(way))
    given: list[BeamLinks | None] = [None] * len(way)
    for links in steel.links_along(course.member.name):
        within = (way >= links.start) & (way <= (np.inf if links.end is None else links.end))
        area[within], legs[within], apart[within] = links.area, links.legs, links.spacing
        across[within] = course.legs_apart(steel, links.diameter, links.legs)
        given = [links if here else before for here, before in zip(within, given, strict=True)]

    def followed(
        by: Callable[[MemberCourse, int, BeamLinks, Reinforcement, BeamRule, str], Iterator[Step]], place: int
    ) -> Iterator[Step]:
        laid = given[place]
        assert laid is not None  # where there are none, nothing is compared
        return by(course, place, laid, steel, rule, results.limit_state)

    needed = course.web.links_of(legs)
    of_links, clause = ("cm2/m", rule.web_clauses), rule.distance_clauses
    yield _judged(course, way, "links", (needed * CM2, area * CM2), of_links, partial(followed, given_steps.links))
    if rule.link_distances is not None and area.any():
        along, most = rule.link_distances(steel, results.limit_state, course.webs, course.used)
        steps = partial(followed, given_steps.distance_of_links)
        yield _judged(course, way, "distance of links", (apart * 1e3, along * 1e3), ("mm", clause), steps)
        steps = partial(followed, given_steps.distance_of_legs)
        yield _judged(course, way, "distance of legs", (across * 1e3, most * 1e3), ("mm", clause), steps)


def _bars(results: CombinationResult, course: MemberCourse, steel: Reinforcement, rule: BeamRule) -> Iterator[Judged]:
    """Yield the slab's bars along a strip at both faces in a combination, half of those for torsion at each."""
    member = course.member
    assert isinstance(member, StripMember)
    forces, b = course.forces, course.section.b
    offsets = ((np.arange(ACROSS) + 0.5) / ACROSS - 0.5) * b
    for face, layer in enumerate(member.layers):
        places = np.repeat(forces.nodes, ACROSS, axis=0)
        places[:, 1 - "xy".index(member.axis)] += np.tile(offsets, len(forces.way))
        laid = laid_bars(steel, layer, places).area.reshape(-1, ACROSS).mean(axis=1) * b
        needed = course.faces[face]
        what = f"bars at the {('bottom', 'top')[face]}"
        units = "cm2", f"{rule.clauses}, {rule.web_clauses}"

        def followed(place: int, face: int = face, laid: Array = laid) -> Iterator[Step]:
            return given_steps.bars_of_strip(course, face, place, float(laid[place]), steel, rule, results.limit_state)

        yield _judged(course, forces.way, what, (needed * CM2, laid * CM2), units, followed)
