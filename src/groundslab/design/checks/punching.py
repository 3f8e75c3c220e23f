"""Punching by the code of the case: what is judged, what is not, and the calculation of what uses most."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

from groundslab.design.bars.proposal.links import punching_links
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.check import DesignCheck, judge_apart, some
from groundslab.design.rules.design_code import Calculation, PunchingRule
from groundslab.design.rules.punching import (
    CALLED,
    PUNCHING,
    Demands,
    judged,
    punched_names,
    punching_supports,
    with_the_rest,
    with_way,
)
from groundslab.design.rules.punching_beta import check_constants
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.messages import Clause, Message, Name, quantity
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

#: What the check of links that are given is called.
LINKS = "links against punching"
#: What counts as rounding, relative: distances are written to the millimeter.
ROUNDING = 1e-6


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the checks of punching over all ultimate combinations; none without reinforcement, or rules for it."""
    steel = combined.model.reinforcement
    rule = None if steel is None else code_of(steel).punching
    if steel is None or rule is None:
        return
    for support in punching_supports(combined):
        demands = rule.demands_of(combined, support)
        judge = partial(_judged, support, demands, rule, steel)
        names = list(dict.fromkeys([*(name for _, name in demands.found), *demands.missing]))
        yield from judge_apart(names, str, combined.model.checks.off, judge)
    yield from check_constants(combined, steel)
    if steel.links:
        layouts = [layout for layout in punching_links(combined) if steel.links_at(layout.name) is not None]
        yield from judge_apart(layouts, lambda layout: layout.name, combined.model.checks.off, _links)
        punched = punched_names(combined, rule.demands_of)
        if unused := [links.of for links in steel.links if links.of not in punched]:
            words = Message("links are given at {names}, where no punching is judged", names=some(unused))
            yield DesignCheck("links without punching", "attention", words, of=unused[0])


def _links(layouts: list[LinkLayout]) -> Iterator[DesignCheck]:
    """Yield whether links that are given are as the code asks: their distances, their legs, how far out they are.

    Those that the code does not allow fail, whatever they would carry; of others its rules are not known here.
    """
    if not layouts:
        return
    without = sorted((layout for layout in layouts if layout.why), key=lambda layout: layout.unknown)
    if without and not (without[0].unknown and any(layout.limits for layout in layouts)):
        worst = without[0]
        yield DesignCheck(
            LINKS, "attention" if worst.unknown else "fails", Message("{name}: {why}", name=worst.name, why=worst.why),
            of=worst.name, clause=worst.clauses, combination=worst.combination, place=worst.place,
        )  # fmt: skip
        return
    if without:
        yield DesignCheck(LINKS, "attention", Message("{name}: {why}", name=without[0].name, why=without[0].why))
    layout, limit = max(
        ((layout, limit) for layout in layouts for limit in layout.limits), key=lambda limited: limited[1].used
    )
    holds = limit.used <= 1 + ROUNDING
    beyond = [other.name for other in layouts if any(limit.used > 1 + ROUNDING for limit in other.limits)]
    sign = (">=" if holds else "<") if limit.least else ("<=" if holds else ">")
    template = "{name}: {what} {value} {sign} {limit} ({clause})"
    about = {"name": Name(layout.name), "what": limit.what, "sign": sign, "clause": Clause(limit.clause)}
    words: str = Message(template, value=quantity(limit.value, limit.unit), limit=quantity(limit.limit, limit.unit),
                         **about)  # fmt: skip
    if len(beyond) > 1:
        words += Message("; so do not {names}", names=some([name for name in beyond if name != layout.name]))
    yield DesignCheck(
        LINKS, "no failure found" if holds else "fails", words, of=layout.name, demand=limit.value,
        resistance=limit.limit, unit=limit.unit, least=limit.least, clause=layout.clauses,
        combination=layout.combination, place=layout.place,
        steps=tuple(limit.follow()) if math.isfinite(limit.value) and limit.limit > 0 and limit.value > 0 else (),
    )  # fmt: skip


def _judged(
    support: Support, every: Demands[Any], rule: PunchingRule, steel: Reinforcement, names: Collection[str]
) -> Iterator[DesignCheck]:
    """Yield the checks of the worst of some that punch."""
    demands = replace(
        every,
        found={key: demand for key, demand in every.found.items() if key[1] in names},
        missing={name: why for name, why in every.missing.items() if name in names},
    )
    for aspect in rule.aspects(support, demands, steel):
        those, supported = judged(aspect.demands, aspect.used)
        check = with_way(aspect.worst(those), demands.found) if those else None
        if check is None and not supported and demands.missing and not aspect.says_missing:
            continue  # another aspect says why there is none
        missing = demands.missing if aspect.says_missing else {}
        yield from with_the_rest(check, aspect.name, (*CALLED[support], rule.cut), supported, missing)


def calculations(combined: Results) -> Iterator[tuple[str, list[Calculation]]]:
    """Yield the name of each way to punch with the governing combination of what uses most, or of all that punches."""
    steel = combined.model.reinforcement
    rule = None if steel is None else code_of(steel).punching
    if steel is None or rule is None:
        return
    for support in punching_supports(combined):
        governing: dict[str, tuple[float, Any]] = {}
        for demand in rule.demands_of(combined, support).found.values():
            used = rule.used(demand, steel)
            if used > governing.get(demand.name, (0.0,))[0]:
                governing[demand.name] = used, demand
        ranked = sorted(governing.values(), key=lambda governed: -governed[0])
        of_way = [
            Calculation(demand.name, demand.combination, tuple(rule.steps(demand, steel, support)), demand.sketch)
            for _, demand in ranked[: None if combined.model.report.sheets == "all" else 1]
        ]
        yield PUNCHING[support], of_way
