"""Section forces along the edges of the slab as rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from groundslab.exchange.saf.units import from_si
from groundslab.exchange.saf.writing.cases import ALL_LOADS
from groundslab.exchange.saf.writing.sheets import Sheets

SHEET = "ResultInternalForce2DEdge"
#: Forces of a section: bending and twisting moments, shear forces, forces in the slab's plane, with their quantities.
FORCES: dict[str, str] = {
    "mx": "line moment", "my": "line moment", "mxy": "line moment", "vx": "line force", "vy": "line force",
    "nx": "line force", "ny": "line force", "nxy": "line force",
}  # fmt: skip
#: What the signs of a file mean, of which the format's documentation has a picture alone.
SIGNS = (
    "in the slab's local axes, x and y as in the case and z up: mx and my are positive with tension below, mxy where "
    "tau_xy is positive below, vx = d mx/dx + d mxy/dy, vy = d my/dy + d mxy/dx"
)


@dataclass(frozen=True, slots=True)
class EdgeForces:
    """Section forces along one edge of the slab in one combination.

    Attributes
    ----------
    combination : str
        The combination of the case.
    edge : int
        Number of the edge in the slab's outline, from 1.
    s : sequence of float
        Distances from the edge's start, in its direction [m]; twice the same where forces jump.
    values : mapping of str to sequence of float
        Moments [N m/m] and forces [N/m] by the names of `FORCES`, as many as there are distances.
    """

    combination: str
    edge: int
    s: Sequence[float]
    values: Mapping[str, Sequence[float]]


def write_forces(sheets: Sheets, slab: str, forces: Sequence[EdgeForces], names: Mapping[str, str]) -> None:
    """Write section forces along edges.

    ``names`` are those of combinations in the file; without any, a combination is a load case of its own name, or all
    loads.
    """
    cases = sheets.names["StructuralLoadCase"]
    for along in forces:
        case = along.combination if along.combination in cases else ALL_LOADS
        of: dict[str, object] = {"resultfor": "Load case", "loadcase": case}
        if names:
            of = {"resultfor": "Load combination", "loadcombination": names.get(along.combination)}
        if None in of.values():
            sheets.leave(f"combination {along.combination}", "its section forces are not written")
            continue
        for position, s in enumerate(along.s):
            values = {name: from_si(along.values[name][position], kind) + 0.0 for name, kind in FORCES.items()}
            where = {"resulton": "On edge", "2dmember": slab, "edge": along.edge, **of}
            sheets.rows[SHEET].append({**where, "sectionat": from_si(s, "length"), "index": position + 1, **values})
    if forces:
        sheets.leave("section forces along edges", SIGNS)
