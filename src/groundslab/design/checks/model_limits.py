"""What stands at a limit of the model: supports and piles, joints with play, ground that yields, loads cut off.

In the analysis a limit is a law: a pile at its limit carries no more, and what it leaves goes elsewhere. That all is in
equilibrium then does not say that it may be so. A pile keeps F_c;d <= R_c;d (EN 1997-1 7.6.2.1, in tension 7.6.3.1):
its limit is R_d, or a characteristic resistance, at which it yields, over a partial factor in ultimate combinations.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import pairwise

import numpy as np

from groundslab.design.demands.support_forces import (
    NOTHING,
    REACHED,
    Utilization,
    idle,
    limits_of,
    pull_in_part,
    thirds,
    utilization,
)
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.check import NO_LIMIT, DesignCheck, Status, not_judged, some
from groundslab.design.rules.combinations import solved_results
from groundslab.design.rules.demand_errors import error_of, scaled
from groundslab.messages import Message, Name, joined, quantity
from groundslab.model.loads.clipping import Clipped, find_clipped_loads
from groundslab.model.loads.load_cases import SERVICEABILITY, STRENGTH
from groundslab.model.plates.joints import ElasticJoint
from groundslab.model.supports import AnySupport, LineSupport, Pile
from groundslab.results.fields import places_of
from groundslab.results.records import JointResult
from groundslab.results.results import CombinationResult, Results

PILE, SUPPORT, WITHOUT = "pile force / resistance", "support force / limit", "resistance of piles"
ONE_SIDED, PLAY, GROUND, CUT_OFF = "one-sided support", "play of a joint", "limit pressure", "loads cut off"
ANCHORED = "supports that hold down"
#: Ground has sunk in if by more than this share of the largest settlement.
SUNK = 1e-6
#: Of loads that are cut off so many are named.
MOST_CUT = 5
#: So many piles without a resistance are named.
MOST_NAMED = 5


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield what has a limit in the model, and whether it stands there in any combination."""
    results = solved_results(combined)
    # where limits are reached at the same share, combinations of strength are named first
    results.sort(key=lambda result: result.limit_state not in STRENGTH)
    if results:
        yield from _supports(results)
        yield from _without_resistance(results)
        yield from _holding_down([result for result in results if result.limit_state not in SERVICEABILITY])
        yield from _joints(results)
        yield from _ground(results)
    yield from _cut_off(combined)


def _supports(results: list[CombinationResult]) -> Iterator[DesignCheck]:
    """Yield what each support carries against its limits, and which one-sided supports carry nothing."""
    for number, (described, support) in enumerate(zip(results[0].model.supports, results[0].supports, strict=False)):
        name = support.name
        used = {
            result.combination: utilization(described, result.supports[number], result.limit_state)
            for result in results
        }
        limited = {combination: share for combination, share in used.items() if share is not None}
        if limited:
            check = _resistance(described, name, limited)
            governing = next(result for result in results if result.combination == check.combination)
            yield replace(check, error=_error(described, number, governing, limited[check.combination].limit))
        if described.acts != "both ways":
            yield from _one_sided(described, name, number, results)


def _resistance(described: AnySupport, name: str, used: Mapping[str, Utilization]) -> DesignCheck:
    """Return the check of a support against its limits, in the combination that governs."""
    reached = [combination for combination, share in used.items() if share.reached]
    characteristic = described.limit_is == "characteristic resistance"
    most_used = max(used, key=lambda combination: used[combination].share)
    governing = reached[0] if reached and not characteristic else most_used
    share = used[governing]
    unit = "kN/m" if isinstance(described, LineSupport) else "kN"
    force, limit = share.force / 1e3, share.limit / 1e3
    limit_words = Message("{kind} of {limit}", kind=described.limit_is, limit=quantity(limit * share.factor, unit))
    most = (
        Message("its {given}", given=limit_words)
        if share.factor == 1
        else Message(
            "{limit}, its {given} over {factor:g},",
            limit=quantity(limit, unit, ".4g"),
            given=limit_words,
            factor=share.factor,
        )
    )
    status: Status = "no failure found"
    words = Message(
        '{name}: {force} is {share:.3g} times {most} in "{governing}"',
        name=Name(name),
        force=quantity(force, unit, ".4g"),
        share=share.share,
        most=most,
        governing=Name(governing),
    )
    if reached:
        status = "attention" if described.limit_is == "ultimate resistance" else "fails"
        if not characteristic:
            words = Message(
                "{name}: {force} reaches {most} in {names}",
                name=Name(name),
                force=quantity(force, unit, ".4g"),
                most=most,
                names=some(reached),
            )
    pile = isinstance(described, Pile)
    return DesignCheck(
        PILE if pile else SUPPORT,
        status,
        words,
        of=name,
        demand=force,
        resistance=limit,
        unit=unit,
        clause="EN 1997-1 7.6.2.1, 7.6.3.1" if pile and described.limit_is != "ultimate resistance" else "",
        combination=governing,
        place=share.place,
        foundation=True,
        steps=tuple(_steps(described, share, unit.replace("k", "M"))),
    )


def _steps(described: AnySupport, use: Utilization, unit: str) -> Iterator[Step]:
    """Yield what a support carries over what it can."""
    clause = "EN 1997-1 7.6.2, 7.6.3" if isinstance(described, Pile) else ""
    yield Step("force of the support", "F", use.force / MEGA, unit)
    if described.limit_is == "characteristic resistance":
        yield Step("characteristic resistance", "R_k", use.limit * use.factor / MEGA, unit)
        yield Step("its partial factor", "gamma_R", use.factor, clause="EN 1997-1 Tables A.6 to A.8, A.16")
        yield Step("design resistance", "R", use.limit / MEGA, unit, "R_k / gamma_R", clause)
    else:
        yield Step(described.limit_is, "R", use.limit / MEGA, unit)
    yield Step("share used", "eta", use.share, "", "F / R", clause)


def _without_resistance(results: list[CombinationResult]) -> Iterator[DesignCheck]:
    """Yield which piles have no resistance that their force could be compared with, at all or the way they are loaded.

    Other supports with a diameter count as piles, as they do for punching.
    """
    bare, half = [], []
    for number, described in enumerate(results[0].model.supports):
        if isinstance(described, LineSupport) or described.diameter is None:
            continue
        name = results[0].supports[number].name
        limits = limits_of(described)
        if min(limits) == np.inf:
            bare.append(name)
            continue
        for way, sign, limit in zip(("compression", "tension"), (1, -1), limits, strict=True):
            force, combination = max((sign * result.supports[number].total, result.combination) for result in results)
            if limit == np.inf and force > NOTHING * max(abs(result.certificate.load) for result in results):
                half.append(
                    (
                        Message(
                            '{name} {force:.4g kN} in {way} in "{combination}"',
                            name=Name(name),
                            force=force / 1e3,
                            way=way,
                            combination=Name(combination),
                        ),
                        combination,
                    )
                )
    if bare:
        words = Message(
            "the resistance of {names} in the ground is not checked, as they have no limit", names=some(bare)
        )
        yield DesignCheck(WITHOUT, "not checked", words, clause="EN 1997-1 7.6.2, 7.6.3")
    if half:
        listed = joined((words for words, _ in half[:MOST_NAMED]), "; ") + (" ..." if len(half) > MOST_NAMED else "")
        words = Message("without a limit that way, {forces}", forces=listed)
        yield not_judged(WITHOUT, NO_LIMIT, words, clause="EN 1997-1 7.6.2, 7.6.3", combination=half[0][1])


def _holding_down(results: list[CombinationResult]) -> Iterator[DesignCheck]:
    """Yield which supports that are no piles hold the plate down by more than nothing, without a limit of that."""
    pulls = []
    for number, described in enumerate(results[0].model.supports if results else ()):
        pile = not isinstance(described, LineSupport) and described.diameter is not None
        if pile or limits_of(described)[1] < np.inf:
            continue
        force, worst = max(((_pull(described, result, number), result) for result in results), key=lambda pull: pull[0])
        if force > NOTHING * max(abs(result.certificate.load) for result in results):
            pulls.append(
                (
                    force,
                    Message(
                        '{name} {force:.4g kN} in "{combination}"',
                        name=Name(worst.supports[number].name),
                        force=force / 1e3,
                        combination=Name(worst.combination),
                    ),
                )
            )
    if pulls:
        words = [text for _, text in sorted(pulls, reverse=True)]
        listed = joined(words[:MOST_NAMED], "; ") + (" ..." if len(words) > MOST_NAMED else "")
        yield not_judged(ANCHORED, NO_LIMIT, Message("what holds the plate down has no limit, {forces}", forces=listed))


def _pull(described: AnySupport, results: CombinationResult, number: int) -> float:
    """Return the force [N] by which a support holds the plate down, a line in all or in part."""
    support = results.supports[number]
    if not isinstance(described, LineSupport):
        return -support.total
    parts = thirds(np.array(list(pairwise(described.points))))
    return max(-support.total, pull_in_part(parts, support.nodes, support.force))


def _error(described: AnySupport, number: int, results: CombinationResult, limit: float) -> float | None:
    """Return the error of what a support carries against a limit [N], in the unit of its check."""

    def used(mesh: CombinationResult) -> float:
        share = utilization(described, mesh.supports[number], results.limit_state)
        return 0.0 if share is None else share.share

    return scaled(error_of(results, used), limit / 1e3)


def _one_sided(
    described: AnySupport, name: str, number: int, results: list[CombinationResult]
) -> Iterator[DesignCheck]:
    """Yield where a support that acts one way carries nothing, if it does so in any combination.

    The plate that lifts off a support needs attention; an anchor that is slack, or a gap that stays open, does not.
    """
    shares = {result.combination: _idle_share(result, number) for result in results}
    lifted = [combination for combination, share in shares.items() if share > 0]
    if not lifted:
        return
    most = max(lifted, key=lambda combination: shares[combination])
    part = (
        Message("over {share:.3g} % of its length ", share=100 * shares[most])
        if isinstance(described, LineSupport)
        else ""
    )
    gap = getattr(described, "gap", 0.0)
    slack = described.acts == "in tension"
    what = "its gap does not close" if gap else "it is slack" if slack else "the plate lifts off"
    lifted.sort(key=lambda combination: combination != most)
    words = Message("{name}: {what} {part}in {names}", name=Name(name), what=what, part=part, names=some(lifted))
    status: Status = "no failure found" if gap or slack else "attention"
    yield DesignCheck(ONE_SIDED, status, words, of=name, combination=most)


def _idle_share(results: CombinationResult, number: int) -> float:
    """Return the share of a support that carries nothing, by length along lines."""
    support = results.supports[number]
    if not len(support.nodes):
        return 0.0
    weight = support.length if support.length.any() else np.ones(len(support.nodes))
    return float(weight @ idle(results, support) / weight.sum())


def _joints(results: list[CombinationResult]) -> Iterator[DesignCheck]:
    """Yield of each joint with play whether it closes, and what the joint carries then."""
    for number, joint in enumerate(results[0].model.joints):
        if not isinstance(joint, ElasticJoint) or joint.gap == 0:
            continue
        forces = {result.combination: result.joints[number] for result in results}
        governing = max(forces, key=lambda combination: float(np.abs(forces[combination].step).max()))
        closed = [combination for combination, force in forces.items() if (np.abs(force.step) > joint.gap).any()]
        words = Message("{title}: {play}", title=joint.title, play=_play(forces[governing], joint.gap, closed))
        yield DesignCheck(PLAY, "no failure found", words, of=joint.title, combination=governing)


def _play(forces: JointResult, gap: float, closed: list[str]) -> str:
    """Return the state of a joint's play in words, from its forces where the step across it is largest."""
    play, step = (
        Message("its play of {gap:.4g mm}", gap=gap * 1e3),
        Message("the largest step is {value:.4g mm}", value=np.abs(forces.step).max() * 1e3),
    )
    if not closed:
        return Message("{play} does not close, {step}", play=play, step=step)
    share = float(forces.length @ (np.abs(forces.step) > gap) / forces.length.sum())
    q = np.abs(forces.force / forces.length).max() / 1e3
    return Message(
        "{play} closes over {share:.3g} % of its length in {names}; {step}, with {q:.4g kN/m}",
        play=play,
        share=100 * share,
        names=some(closed),
        step=step,
        q=q,
    )


def _ground(results: list[CombinationResult]) -> Iterator[DesignCheck]:
    """Yield how much of the ground yields at its limit pressure."""
    limit = results[0].model.contact.limit_pressure
    if limit is None:
        return
    shares = {result.combination: _yielding_share(result, limit) for result in results}
    yielding = [combination for combination, share in shares.items() if share > 0]
    governing = max(results, key=lambda result: (shares[result.combination], float(result.plate.pressure.max())))
    largest = min(float(governing.plate.pressure.max()), limit) if not yielding else limit
    words = Message(
        '{largest:.4g kPa} is {largest_2:.3g} times the limit pressure in "{combination}"',
        largest=largest / 1e3,
        largest_2=largest / limit,
        combination=Name(governing.combination),
    )
    if yielding:
        share = shares[governing.combination]
        words = Message(
            "the ground yields at {limit:.4g kPa} under {share:.3g} % of the plate's area in "
            '"{combination}"; it yields in {names}',
            limit=limit / 1e3,
            share=100 * share,
            combination=Name(governing.combination),
            names=some(yielding),
        )
    yield DesignCheck(
        GROUND,
        "attention" if yielding else "no failure found",
        words,
        demand=largest / 1e3,
        resistance=limit / 1e3,
        unit="kPa",
        combination=governing.combination,
        foundation=True,
        error=scaled(error_of(governing, lambda mesh: min(float(mesh.plate.pressure.max()), limit)), 1e-3),
        steps=tuple(_ground_steps(governing, largest, limit, shares[governing.combination])),
    )


def _ground_steps(results: CombinationResult, largest: float, limit: float, share: float) -> Iterator[Step]:
    """Yield the largest pressure against that at which the ground yields [Pa], and under which share it does."""
    plate = results.plate
    if share > 0:
        area = float(plate.area.sum())
        yield Step("area of the plate", "A", area, "m2")
        yield Step("area under which the ground yields, by its pressure or its penetration", "A_y", share * area, "m2")
        yield Step("share of it", "a_y", 100 * share, "%", "100 * A_y / A")
        yield Step("pressure where it yields", "p", largest / 1e3, "kPa")
    else:
        x, y = places_of(plate.nodes[int(np.argmax(plate.pressure))]).tolist()
        yield Step(Message("largest pressure, at {place:.3f m}", place=(x, y)), "p", largest / 1e3, "kPa")
    yield Step("limit pressure of the ground", "p_lim", limit / 1e3, "kPa")
    yield Step("share used", "eta", largest / limit, "", "p / p_lim")


def _yielding_share(results: CombinationResult, limit: float) -> float:
    """Return under which share of the plate's area the ground stands at its limit pressure, or has sunk in."""
    plate = results.plate
    sunk = plate.penetration > SUNK * max(float(np.abs(plate.settlement).max()), np.finfo(float).tiny)
    yields = sunk | (plate.pressure >= REACHED * limit)
    return float(plate.area @ yields / plate.area.sum())


def _cut_off(combined: Results) -> Iterator[DesignCheck]:
    """Yield what of the loads does not act, as it lies beside the plate, or under it if it presses on the ground."""
    model = combined.solved_model
    clipped = find_clipped_loads(model.plate, model.loads, model.plates, model.walls, model.spans)
    for where in dict.fromkeys(part.where for part in clipped):
        yield _cut_off_there([part for part in clipped if part.where == where])


def _cut_off_there(clipped: list[Clipped]) -> DesignCheck:
    """Return that parts of some loads do not act, all for the same reason."""
    more = Message("; and {number} more loads", number=len(clipped) - MOST_CUT) if len(clipped) > MOST_CUT else ""
    return DesignCheck(CUT_OFF, "attention", joined((part.words() for part in clipped[:MOST_CUT]), "; ") + more)
