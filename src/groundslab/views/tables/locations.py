"""Tables of the places that a model's output names: points and the soil below them, section lines, design strips."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.cuts.section_cuts import carried_across, cut_along, strip
from groundslab.design.demands.cuts.strip_balance import strip_balance
from groundslab.design.demands.design_moments import fields_of
from groundslab.design.rules.combinations import solved_results
from groundslab.errors import InputError
from groundslab.fem.mesh import Mesh, locate
from groundslab.fem.shape_functions import q9_values
from groundslab.messages import Message, Name
from groundslab.model.outputs import OutputStrip
from groundslab.model.plates.pits import pits_of
from groundslab.results.fields import POINT_FIELDS
from groundslab.results.results import CombinationResult, Results
from groundslab.results.soil_profile import profile_depths
from groundslab.views.tables.quantities import point_values
from groundslab.views.tables.table import Cell, Table, table_of

SETTLEMENT, STRESS = ("settlement w", "mm"), ("vertical stress sigma_z", "kPa")
#: What of the table of strips shows that the forces on the pieces between cuts are in equilibrium.
BALANCE = [
    ("loads before", "kN"), ("reactions before", "kN"), ("shear of sides before", "kN"),
    ("imbalance of shear", "kN"), ("imbalance of moment", "kNm"),
]  # fmt: skip
BALANCE_NOTE = (
    "Before a cut are the loads, the forces of ground and supports, and the shear beyond both sides, on the piece from "
    "the cut before; what is left of the change of shear and moment between both is the error of the section forces."
)
_HEADS = [about.head for about in POINT_FIELDS.values()]
_RECOVERED = (
    "Moments and shear forces are nodal values recovered from patches within one section of the plate, in between by "
    "the elements' shape functions; nothing is averaged across a change of thickness or material."
)


def points(combined: Results) -> Table:
    """Return all quantities at each output point in each combination."""
    wanted = combined.model.output.points
    rows: list[list[Cell]] = []
    for results in solved_results(combined):
        plate = results.plate
        mesh = Mesh(plate.nodes, plate.elements)
        # a point on a curved edge may lie outside the elements' sides by a little
        element, local = locate(mesh, np.array([(point.x, point.y) for point in wanted]), reach=1e-3)
        N, nodes = q9_values(local), mesh.elements[element]
        fields = {name: np.einsum("pa,pa->p", N, field[nodes]) for name, field in fields_of(plate).items()}
        values = np.column_stack(point_values(fields))
        for point, on, row in zip(wanted, element >= 0, values, strict=True):
            rows.append([results.combination, point.name, point.x, point.y, *(row if on else [None] * len(row))])
    notes = [_RECOVERED, "A point where fields have two sides, such as on a wall, has the values of one of them."]
    heads = [("combination", ""), ("point", ""), ("x", "m"), ("y", "m"), *_HEADS]
    return table_of("points", "Points", heads, rows, notes)


def soil(combined: Results) -> Table:
    """Return settlement and vertical stress in the depth of a continuum below each output point in each combination."""
    model = combined.model
    wanted, depths = model.output.points, profile_depths(model)
    rows: list[list[Cell]] = []
    for results in solved_results(combined):
        cells = results.ground.cells
        if cells is None or cells.piled:
            continue
        w, sigma = cells.below(np.array([(point.x, point.y) for point in wanted]), depths)
        for point, of_point, stresses in zip(wanted, w, sigma, strict=True):
            head: list[Cell] = [results.combination, point.name, point.x, point.y]
            for z, settlement, stress in zip(depths, of_point, stresses, strict=True):
                rows.append([*head, z, 1e3 * settlement if np.isfinite(settlement) else None, stress / 1e3])
    heads = [("combination", ""), ("point", ""), ("x", "m"), ("y", "m"), ("depth z", "m"), SETTLEMENT, STRESS]
    notes = [
        "Depths from the base of the plate. Vertical stresses are those by the pressure of the plate, compression "
        "positive, without the soil's own weight; at z = 0 they are the pressure of the cell there.",
    ]
    if not rows:
        notes.append("Piles carry loads into the depth, of which nothing is known then.")
    if model.boreholes or any(map(pits_of, model.every_plate)):
        notes.append("Settlements in the depth are not known where layers differ from place to place.")
    return table_of("soil", "Soil below points", heads, rows, notes)


def lines(combined: Results) -> Table:
    """Return all quantities along each output line in each combination."""
    rows: list[list[Cell]] = []
    missed: list[str] = []
    for results in solved_results(combined):
        for line in combined.model.output.lines:
            try:
                section = cut_along(results.plate, np.array([line.start, line.end]))
            except InputError:
                missed.append(line.name)
                continue
            values = np.column_stack([section.s, section.x, section.y, *point_values(section.values)])
            for part, (s, x, y, *rest) in zip(section.part, values, strict=True):
                rows.append([results.combination, line.name, s, x, y, int(part), *rest])
    notes = [
        _RECOVERED,
        "Values of one part can be joined by a curve; a new part begins after an opening and where the section "
        "changes, where one place appears twice.",
        "A line along which fields have two sides, such as a wall, has the values of one of them.",
        *_not_met("line", missed),
    ]
    heads = [("combination", ""), ("line", ""), ("s", "m"), ("x", "m"), ("y", "m"), ("part", ""), *_HEADS]
    return table_of("lines", "Section lines", heads, rows, notes)


def strips(combined: Results) -> Table:
    """Return the forces on the cuts across each design strip in each combination."""
    heads = [
        ("combination", ""), ("strip", ""), ("s", "m"), ("x", "m"), ("y", "m"), ("width on the plate", "m"),
        ("moment", "kNm"), ("shear", "kN"), ("torsional moment", "kNm"),
        ("mean moment", "kNm/m"), ("mean shear", "kN/m"),
        ("greatest moment", "kNm/m"), ("least moment", "kNm/m"),
        ("design moment bottom along", "kNm/m"), ("design moment top along", "kNm/m"),
        ("design moment bottom across", "kNm/m"), ("design moment top across", "kNm/m"),
    ]  # fmt: skip
    members = bool(combined.model.members)
    heads += [("moment of beams", "kNm"), ("shear of beams", "kN")] if members else []
    heads += BALANCE
    rows: list[list[Cell]] = []
    missed: list[str] = []
    for results in solved_results(combined):
        for output in combined.model.output.strips:
            try:
                f = strip(results.plate, output.start, output.end, output.width, output.stations)
            except InputError:
                missed.append(output.name)
                continue
            forces = [f.moment, f.shear, f.torsion, f.mean_moment, f.mean_shear, f.largest, f.least]
            design = [f.bottom, f.top, f.bottom_across, f.top_across]
            beams = _of_beams(results, output, f.s).T if members else ()
            fields = (*forces, *design, *beams)
            values = np.column_stack([f.s, f.x, f.y, f.length, *(field / 1e3 for field in fields)])
            balance = strip_balance(results, output, f)
            left = (
                np.full((len(f.s), len(BALANCE)), None) if balance is None else np.column_stack(balance.columns) / 1e3
            )
            rows += [[results.combination, output.name, *row, *rest] for row, rest in zip(values, left, strict=True)]
    notes = [
        "Moments bend the strip along its axis, sagging positive; moment and shear are integrals over the width that "
        "lies on the plate, mean ones are these by that width.",
        "Design moments (Wood and Armer) are means over the cut of the values at its points, for bars along the strip "
        "and across it.",
        *(
            ["Forces are those of the plate, beside which stand those of beams and walls with a height across the cut."]
            if members
            else []
        ),
        BALANCE_NOTE,
        *_not_met("strip", missed),
    ]
    return table_of("strips", "Design strips", heads, rows, notes)


def _of_beams(results: CombinationResult, output: OutputStrip, s: Array) -> Array:
    """Return moments [N m] and shear forces [N] of beams across the cuts of a strip at distances s (k,), (k, 2)."""
    start, end = np.array(output.start), np.array(output.end)
    along = (end - start) / np.linalg.norm(end - start)
    half = output.width / 2 * np.array([along[1], -along[0]])
    places = start + s[:, None] * along
    return carried_across(results, places - half, places + half)


def _not_met(kind: str, missed: list[str]) -> list[str]:
    """Return a note for each line or strip that does not cross the plate."""
    return [
        Message("{kind} {name}: it does not cross the plate", kind=kind, name=Name(name))
        for name in dict.fromkeys(missed)
    ]
