"""Dowels across joints: the largest force that one carries in ultimate combinations, against its resistance by TR34."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.design.codes.en1992_2004.materials import CONCRETE_CLASSES
from groundslab.design.codes.floors import dowels as tr34
from groundslab.design.codes.floors.dowels import FORMULAS, GAMMA_S, Dowel
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.check import NO_COMBINATION, NO_CONCRETE, DesignCheck, not_judged, some
from groundslab.design.rules.combinations import ultimate_results, why_none
from groundslab.design.rules.demand_errors import error_of, scaled
from groundslab.messages import Message, Name
from groundslab.model.design.floors import TR34Floor
from groundslab.model.loads.load_cases import STRENGTH
from groundslab.model.model import Model
from groundslab.model.plates.joints import Dowels
from groundslab.results.records import JointResult
from groundslab.results.results import CombinationResult, Results

DOWELS, TRANSFER, BURSTING = "dowels", "load transfer", "bursting at dowels"
_CLAUSE = "TR34 6.5"
#: Partial factor of concrete where no floor by TR34 and no [reinforcement] has one.
GAMMA_C = 1.5


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the check of the dowels of each joint, and which joints have none."""
    joints, results = combined.model.joints, ultimate_results(combined)
    bare = [joint.title for joint in joints if joint.dowels is None]
    if bare:
        words: str = Message("what the joints {names} carry is not checked, as they have no dowels", names=some(bare))
        yield DesignCheck(TRANSFER, "not checked", words)
    if len(bare) == len(joints):
        return
    strength = _concrete(combined.model)
    if strength is None or not results:
        why = NO_COMBINATION if strength else NO_CONCRETE
        words = "neither [floor] by TR34 nor [reinforcement] gives the concrete"
        if strength:
            words = why_none(combined, STRENGTH, "ultimate combination")
        yield not_judged(DOWELS, why, words, clause=_CLAUSE)
        return
    yield DesignCheck(BURSTING, "not checked", "bursting of the concrete at dowels is not checked")
    for number, joint in enumerate(joints):
        if joint.dowels is not None:
            yield _check(number, joint.title, joint.dowels, strength, results)


def _concrete(model: Model) -> tuple[float, float] | None:
    """Return f_ck [Pa] and its partial factor, of the floor or the reinforcement; None without both."""
    floor, steel = model.floor, model.reinforcement
    if isinstance(floor, TR34Floor):
        gamma, f_ck, concrete = floor.gamma_c, floor.f_ck, floor.concrete
    elif steel is not None:
        gamma, f_ck, concrete = steel.gamma_c or GAMMA_C, steel.f_ck, steel.concrete
    else:
        return None
    f_ck = f_ck if concrete is None else CONCRETE_CLASSES[concrete] * MEGA
    assert f_ck is not None
    return f_ck, gamma


def _check(
    number: int, title: str, dowels: Dowels, strength: tuple[float, float], results: list[CombinationResult]
) -> DesignCheck:
    """Return the check of a joint's dowels where one carries most."""
    governing = max(results, key=lambda result: _largest(result.joints[number]))
    joint = governing.joints[number]
    x, y = joint.nodes[int(np.argmax(np.abs(joint.force / joint.length)))]
    q = _largest(joint)
    by_symbol = {step.symbol: step for step in _steps(dowels, q, *strength)}
    force, R, used = (by_symbol[symbol].value for symbol in ("P", "P_R", "eta"))
    what = "shear" if by_symbol["P_sh"].value <= by_symbol["P_b"].value else "bending"
    error = error_of(governing, lambda mesh: _largest(mesh.joints[number]))
    words = Message(
        "{title}: {force:.4g kN} on a dowel at {place:.3f m} is {used:.3g} times {R:.4g kN}, by {what}, "
        'in "{combination}"',
        title=title,
        force=force * 1e3,
        place=(x, y),
        used=used,
        R=R * 1e3,
        what=what,
        combination=Name(governing.combination),
    )
    return DesignCheck(
        DOWELS, "fails" if used > 1 else "no failure found", words, of=title, demand=force * 1e3, resistance=R * 1e3,
        unit="kN", clause=_CLAUSE, combination=governing.combination, place=(float(x), float(y)),
        error=scaled(error, dowels.spacing / 1e3), steps=tuple(by_symbol.values()),
    )  # fmt: skip


def _largest(joint: JointResult) -> float:
    """Return the largest force per length of a joint [N/m]."""
    return float(np.abs(joint.force / joint.length).max())


def _steps(dowels: Dowels, q: float, f_ck: float, gamma_c: float) -> Iterator[Step]:
    """Yield the calculation of a dowel under a force per length q [N/m]."""
    width = dowels.diameter or dowels.width or 0.0
    dowel, kind = Dowel(width, dowels.height, dowels.f_yk / GAMMA_S), "round" if dowels.height is None else "plate"
    f_cd, e = f_ck / gamma_c, dowels.opening / 2
    yield Step("largest force per length of the joint", "q", q / MEGA, "MN/m")
    yield Step("distance of the dowels", "s", dowels.spacing, "m")
    yield Step("force on a dowel", "P", q * dowels.spacing / MEGA, "MN", "q * s")
    yield Step("width of the dowel", "W", width, "m")
    if dowels.height is not None:
        yield Step("thickness of the dowel", "T", dowels.height, "m")
    yield Step("section of the dowel", "A", dowel.area, "m2", FORMULAS[f"A {kind}"])
    yield Step("strength of its steel", "f_yk", dowels.f_yk / MEGA, "MPa")
    yield Step("design strength of its steel", "f_yd", dowel.f_yd / MEGA, "MPa", f"f_yk / {GAMMA_S:g}")
    yield Step("strength of the concrete", "f_ck", f_ck / MEGA, "MPa")
    yield Step("partial factor", "gamma_C", gamma_c)
    yield Step("design strength of the concrete", "f_cd", f_cd / MEGA, "MPa", "f_ck / gamma_C")
    yield Step("opening of the joint", "x", dowels.opening, "m")
    yield Step("from the face of the concrete to the middle", "e", e, "m", "x / 2", _CLAUSE)
    shear, bending = tr34.shear_resistance(dowel), tr34.bending_resistance(dowel, f_cd, e)
    yield Step("resistance to shear", "P_sh", shear / MEGA, "MN", FORMULAS["P_sh"], _CLAUSE)
    yield Step("plastic moment", "M_p", dowel.plastic_moment / MEGA, "MNm", FORMULAS[f"M_p {kind}"], _CLAUSE)
    yield Step("resistance to bearing and bending", "P_b", bending / MEGA, "MN", FORMULAS["P_b"], _CLAUSE)
    yield Step("resistance", "P_R", min(shear, bending) / MEGA, "MN", "min(P_sh, P_b)", _CLAUSE)
    yield Step("share used", "eta", q * dowels.spacing / min(shear, bending), "", "P / P_R")
