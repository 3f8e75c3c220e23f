"""The least cover of bars by EN 1992-1-1 4.4.1, step by step, as it can be followed by hand."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.en1992_2004.annex import Annex
from groundslab.design.codes.en1992_2004.materials_of_case import deviation
from groundslab.design.rules.calculation import Step
from groundslab.messages import Message

_MM = 1e3


def cover_steps(diameter: float, exposure: str | None, annex: Annex) -> Iterator[Step]:
    """Yield c_nom [mm] of a bar [m], of an exposure class or, without one, as bond asks for it."""
    phi, durable = diameter * _MM, 0.0
    yield Step("least cover for bond", "c_min,b", phi, "mm", "phi", "4.4.1.2(3)")
    formula = "max(c_min,b, 10)"
    if exposure is not None:
        durable, formula = annex.c_min_dur[exposure] * _MM, "max(c_min,b, c_min,dur, 10)"
        words = Message("least cover for durability, {exposure}, structural class S4", exposure=exposure)
        yield Step(words, "c_min,dur", durable, "mm", clause="4.4.1.2(5)")
    more, of_bond = deviation(annex, exposure) * _MM, deviation(annex, None) * _MM
    clause = "4.4.1.1(2), 4.1"
    if more != of_bond:
        yield Step("allowance for deviations", "Delta_c,dev", more, "mm", clause="4.4.1.3(1)")
        yield Step("allowance for deviations, for bond", "Delta_c,dev,b", of_bond, "mm", clause="4.4.1.3(1)")
        c_nom = max(durable + more, max(phi, 10.0) + of_bond)
        formula = "max(c_min,dur + Delta_c,dev, max(c_min,b, 10) + Delta_c,dev,b)"
        yield Step("nominal cover", "c_nom", c_nom, "mm", formula, clause)
        return
    c_min = max(phi, durable, 10.0)
    yield Step("least cover", "c_min", c_min, "mm", formula, "4.4.1.2(2), 4.2")
    yield Step("allowance for deviations", "Delta_c,dev", more, "mm", clause="4.4.1.3(1)")
    yield Step("nominal cover", "c_nom", c_min + more, "mm", "c_min + Delta_c,dev", clause)
