"""The tables of beams: extremes of their section forces, how the plate settles along them; the bars they need."""

from __future__ import annotations

import numpy as np

from groundslab.design.bars.beam_bars import BeamNeed, beam_needs
from groundslab.design.bars.members import member_forces
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Clause, Message, Name
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.records import BeamResult
from groundslab.results.results import Results
from groundslab.views.tables.table import Cell, Table, table_of

_HEADS = (
    ("combination", ""), ("beam", ""), ("length", "m"),
    ("greatest moment", "kNm"), ("from the start to it", "m"), ("least moment", "kNm"), ("from the start to that", "m"),
    ("largest shear force", "kN"), ("from the start to this", "m"), ("largest torsional moment", "kNm"),
    ("least settlement", "mm"), ("greatest settlement", "mm"),
)  # fmt: skip
_NOTES = (
    "Moments are positive where the beam sags. That of a rib includes the couple of the axial forces in rib and "
    "flange; the plate's own moment, times the flange's width, adds to it.",
    "Shear forces and torsional moments are the largest in size one thickness of the plate away from the beam's ends, "
    "where forces pass from the beam into the plate.",
    "Right beside forces and supports without a footprint the shear force of a beam grows as elements become smaller: "
    "it is judged a thickness away from them.",
)
_NOTE_ON_STRIPS = (
    "Those of strips that are designed as beams are the plate's own over their width, without beams and walls on them."
)
_STRIPS_NEED = (
    "Bars of strips that are beams are the slab's own, over the strip's width: those along it bear its moments, within "
    "the faces of columns those at the faces, and half of the bars for torsion at each face; links stand across it. "
    "Where strips cross, torsion counts up to the other one's edge."
)
#: Of eccentric beams.
_OF_AXIAL = (("greatest axial force", "kN"), ("least axial force", "kN"))
_NOTE_ON_AXIAL = (
    "Moments of eccentric beams are about the plate's middle plane; about the beam's own axis, e below it, they are "
    "less by e times the axial force, of which tension is positive. What balances it are the plate's membrane forces."
)


def beam_table(combined: Results) -> Table:
    """Return the extremes of moment, shear force, torsion and settlement of each beam in each combination."""
    away = max(plate.thickness for plate in combined.model.every_plate)
    rows = [
        [results.combination, beam.name, float(beam.way[-1]), *_figures(beam, away)]
        for results in solved_results(combined)
        for beam in member_forces(results)
    ]
    notes = (*_NOTES, _NOTE_ON_STRIPS) if combined.model.output.beams else _NOTES
    if not any(beam.eccentric for beam in combined.model.members):
        return table_of("beams", "Beams", _HEADS, rows, notes)
    axial = [
        [beam.axial.max() / 1e3, beam.axial.min() / 1e3]
        for results in solved_results(combined)
        for beam in (forces.between_ends(0.0) for forces in member_forces(results))
    ]
    rows = [[*row, *extremes] for row, extremes in zip(rows, axial, strict=True)]
    return table_of("beams", "Beams", (*_HEADS, *_OF_AXIAL), rows, (*notes, _NOTE_ON_AXIAL))


def _figures(beam: BeamResult, away: float) -> list[Cell]:
    """Return the figures of a beam, in the order of the table; shear and torsion so far [m] from its ends."""
    whole, part = beam.between_ends(0.0), beam.between_ends(away)
    top, low = int(np.argmax(whole.moment)), int(np.argmin(whole.moment))
    V, T = int(np.argmax(np.abs(part.shear))), int(np.argmax(np.abs(part.torsion)))
    w = whole.settlement * 1e3
    moments: list[Cell] = [whole.moment[top] / 1e3, whole.way[top], whole.moment[low] / 1e3, whole.way[low]]
    return [*moments, part.shear[V] / 1e3, part.way[V], part.torsion[T] / 1e3, w.min(), w.max()]


def beam_reinforcement(combined: Results, steel: Reinforcement) -> Table:
    """Return the bars at both faces and the links that each beam of concrete needs over all ultimate combinations."""
    heads = (
        ("beam", ""), ("bars", ""), ("required area", "cm2"), ("required links", "cm2/m"), ("least", ""),
        ("from the start", "m"), ("combination", ""), ("moment", "kNm"), ("shear force", "kN"),
        ("torsional moment", "kNm"),
    )  # fmt: skip
    code = code_of(steel)
    assert code.beams is not None
    notes = (
        Message(
            "By {name} {clauses}, {web_clauses}, over all ultimate combinations, in addition to the slab's "
            "bars. Moments and shear forces of ribs are those of the T or L: with the slab's own over the "
            "effective width.",
            name=Name(code.name),
            clauses=Clause(code.beams.clauses),
            web_clauses=Clause(code.beams.web_clauses),
        ),
        "Links carry the shear force at d from the faces of columns and supports that press on a rib from the side "
        "away from the slab, and at all others up to the face. Torsional moments count from d from the beam's ends.",
        "Bars of a flange are those across the rib, at both faces together, that carry the shear between web and "
        "flange, V / z times the share of one side. Those that the slab has there count.",
        "Links are closed where there is torsion, and are for it and shear together; bars for torsion lie along the "
        "beam, spread over its circumference, in addition to those at both faces. A beam can be released from the "
        "torsion that compatibility alone makes (EN 1992-1-1 6.3.1(2), ACI 318-19 22.7.3.2).",
        "The least bars or links are in the unit of the required ones. inf: the concrete is too weak for any "
        "reinforcement.",
    )
    words = code.beams.cracks(steel)
    of_cracks = (f"{words[:1].upper()}{words[1:]}.",) if words else ()
    of_strips = (_STRIPS_NEED,) if combined.model.output.beams else ()
    rows = [_need(need) for need in beam_needs(combined, steel) if need.what != "struts"]
    return table_of("beam_reinforcement", "Reinforcement of beams", heads, rows, (*notes, *of_cracks, *of_strips))


def _need(need: BeamNeed) -> list[Cell]:
    """Return a row of the table of reinforcement."""
    area, force = need.area * 1e4, need.force / 1e3
    about: list[Cell] = [need.beam, need.what]
    rest: list[Cell] = [need.least * 1e4, need.way, need.combination]
    if need.what == "flange":
        return [*about, None, area, *rest, None, force, None]
    if need.web is None:
        return [*about, area, None, *rest, force, None, None]
    if need.what == "links":
        return [*about, None, area, *rest, None, force, need.torsion / 1e3]
    return [*about, area, None, *rest, None, force, need.torsion / 1e3]
