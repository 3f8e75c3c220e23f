"""The table of beams: extremes of their section forces, and how the plate settles along them."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.basis.combinations import solved_results
from groundslab.design.tables.table import Cell, Table, table_of
from groundslab.results.record import BeamResult
from groundslab.results.results import Results

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
)


def beam_table(combined: Results) -> Table:
    """Return the extremes of moment, shear force, torsion and settlement of each beam in each combination."""
    away = max(plate.thickness for plate in combined.model.every_plate)
    rows = [
        [results.combination, beam.name, float(beam.way[-1]), *_figures(beam, away)]
        for results in solved_results(combined)
        for beam in results.beams
    ]
    return table_of("beams", "Beams", _HEADS, rows, _NOTES)


def _figures(beam: BeamResult, away: float) -> list[Cell]:
    """Return the figures of a beam, in the order of the table; shear and torsion so far [m] from its ends."""
    there = beam.away_from_ends(away)

    def largest(values: Array) -> int:
        return int(np.argmax(np.where(there, np.abs(values), -1.0)))

    top, low = int(np.argmax(beam.moment)), int(np.argmin(beam.moment))
    V, T, w = largest(beam.shear), largest(beam.torsion), beam.settlement * 1e3
    moments: list[Cell] = [beam.moment[top] / 1e3, beam.way[top], beam.moment[low] / 1e3, beam.way[low]]
    return [*moments, beam.shear[V] / 1e3, beam.way[V], beam.torsion[T] / 1e3, w.min(), w.max()]
