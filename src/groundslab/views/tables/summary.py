"""Tables of the combinations: what was solved, what acts where, extremes of all fields, tilt."""

from __future__ import annotations

import numpy as np

from groundslab.design.demands.by_plate import results_by_plate
from groundslab.design.demands.tilt import tilt
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Message, Name, joined
from groundslab.model.loads.load_cases import Combination
from groundslab.model.remarks.resultants import case_forces
from groundslab.model.remarks.singular_places import notes_on_singular_places
from groundslab.results.contact_zone import EDGE_NOTE, has_line_force
from groundslab.results.fields import extreme
from groundslab.results.results import CombinationResult, Results, refusal_words
from groundslab.views.tables.quantities import ranged_fields, ranged_values
from groundslab.views.tables.table import Cell, Table, table_of


def combinations(combined: Results) -> Table:
    """Return the composition and the main figures of each combination, or why it has none."""
    heads = [
        ("combination", ""), ("limit state", ""), ("rule", ""), ("loads", ""), ("outcome", ""),
        ("sum of loads", "kN"), ("reaction", "kN"), ("largest settlement", "mm"), ("largest uplift", "mm"),
        ("area in contact", "%"), ("largest pressure", "kPa"), ("largest edge line force", "kN/m"),
        ("worst figure of the certificate", ""), ("which figure", ""),
    ]  # fmt: skip
    rows = []
    for combination in combined.combinations:
        words: list[Cell] = [
            combination.name,
            combination.limit_state,
            combination.rule or None,
            factors(combined, combination),
        ]
        if combination.name in combined.results:
            rows.append([*words, "solved", *_figures(combined.results[combination.name])])
        else:
            rows.append([*words, refusal_words(combined.refused[combination.name]), *[None] * (len(heads) - 5)])
    notes = [
        "The figures of the certificate are ratios; a result counts if none is above 1e-6, and margin_effect not above "
        "0.01, section_law not above 0.001."
    ]
    if any(has_line_force(result) for result in combined.results.values()):
        notes.append(EDGE_NOTE)
    return table_of("combinations", "Combinations", heads, rows, notes)


def acting_cases(combined: Results) -> Table:
    """Return the factor of each case as solved in each combination in which it acts; one that acts nowhere has a row.

    The forces are those of all vertical loads of the case on the plate.
    """
    heads = [
        ("case", ""), ("action", ""), ("combination", ""), ("limit state", ""), ("factor", ""),
        ("force of the case", "kN"), ("force with the factor", "kN"),
    ]  # fmt: skip
    forces = case_forces(combined.solved_model)
    rows: list[list[Cell]] = []
    for case in combined.solved_model.cases:
        force = forces.get(case.name, 0.0) / 1e3
        acting = [(combination, dict(combination.factors).get(case.name, 0.0)) for combination in combined.combinations]
        acting = [(combination, factor) for combination, factor in acting if factor]
        rows += [
            [case.name, case.action, combination.name, combination.limit_state, factor, force, factor * force]
            for combination, factor in acting
        ]
        if not acting:
            rows.append([case.name, case.action, None, None, 0.0, force, 0.0])
    notes = ["A case that moves is a case at each of its positions. A row without a combination acts nowhere."]
    return table_of("acting", "What acts where", heads, rows, notes)


def factors(combined: Results, combination: Combination) -> str:
    """Return the load factors of a combination as a sum, as in "1.35 G + 1.5 Q"."""
    if not combined.model.cases:
        return "all loads"
    terms: list[str] = []
    for name, factor in combination.factors:
        if factor != 0:
            size = abs(factor) if terms else factor
            terms += [" - " if factor < 0 else " + "] if terms else []
            terms.append(Message("{factor:g} {name}", factor=size, name=Name(name)))
    return joined(terms, "")


def _figures(results: CombinationResult) -> list[Cell]:
    """Return the figures of one combination, in the order of the table."""
    plate, certificate = results.plate, results.certificate
    on_edge = plate.edge_length > 0
    line_force = float(plate.line_force[on_edge].max() / 1e3) if has_line_force(results) else None
    limits = certificate.limits()
    which, worst = max(certificate.limited().items(), key=lambda figure: figure[1] / limits[figure[0]])
    return [
        certificate.load / 1e3,
        certificate.reaction / 1e3,
        float(plate.settlement.max() * 1e3),
        max(0.0, float(-plate.settlement.min() * 1e3)),
        100 * plate.contact_share,
        float(plate.pressure.max() / 1e3),
        line_force,
        worst,
        which,
    ]


def extremes(combined: Results) -> Table:
    """Return the least and the greatest value of every quantity in each combination, with their places."""
    heads = [
        ("combination", ""), ("quantity", ""), ("unit", ""),
        ("least", ""), ("x of the least", "m"), ("y of the least", "m"),
        ("greatest", ""), ("x of the greatest", "m"), ("y of the greatest", "m"),
    ]  # fmt: skip
    rows = []
    for results in solved_results(combined):
        at_nodes = ranged_values(results)
        for about, name, where in ranged_fields(results):
            nodes, values = results.plate.nodes[where], at_nodes[name][where]
            row: list[Cell] = [results.combination, about.label, about.unit]
            for sign in (-1, 1):
                value, place = extreme(nodes, values, sign)
                row += [value, *place]
            rows.append(row)
    notes = [
        "Of nodal values. Of several places with the same value, the one nearest to the origin is named.",
        *notes_on_singular_places(combined.solved_model),
    ]
    if any(has_line_force(result) for result in combined.results.values()):
        notes.append(EDGE_NOTE)
    return table_of("extremes", "Extremes of each combination", heads, rows, notes, ("least", "greatest"))


def tilts(combined: Results) -> Table:
    """Return the plane that fits the settlement of each combination best, and how far the plate is off it."""
    heads = [
        ("combination", ""), ("plate", ""), ("mean settlement", "mm"),
        ("tilt along x", "mm/m"), ("tilt along y", "mm/m"),
        ("tilt", "mm/m"), ("direction of the tilt from x", "deg"),
        ("largest deflection", "mm"), ("x of the deflection", "m"), ("y of the deflection", "m"),
    ]  # fmt: skip
    rows = []
    for results in solved_results(combined):
        for name, plate in results_by_plate(results).items():
            t = tilt(plate)
            slopes = [t.tilt_x * 1e3, t.tilt_y * 1e3, t.tilt * 1e3, float(np.degrees(t.direction))]
            rows.append([results.combination, name, t.settlement * 1e3, *slopes, t.deflection * 1e3, *t.place])
    if not combined.model.plates:  # no names to tell plates apart
        heads, rows = [heads[0], *heads[2:]], [[row[0], *row[2:]] for row in rows]
    notes = [
        "Of the plane that fits best, weighed by area. The plate goes down in the direction of the tilt.",
        "Deflections are settlements less the plane's.",
    ]
    return table_of("tilt", "Tilt of the plate as a whole", heads, rows, notes)
