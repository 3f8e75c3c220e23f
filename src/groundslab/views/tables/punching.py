"""What tables have of punching, by the code of the case: at columns, over piles, around zones, and at walls' ends."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.bars.proposal.links import punching_links
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.perimeter_loads import punching_piles
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.punching import NO_COLUMNS, Heads, PunchingColumns
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.design.rules.wall_ends import loaded_ends
from groundslab.messages import Clause, Message
from groundslab.results.results import Results
from groundslab.views.tables.table import Cell, Table, table_of


def punching_at_columns(combined: Results) -> PunchingColumns:
    """Return the punching columns of the table of columns; none without reinforcement, or rules for it."""
    steel = combined.model.reinforcement
    rule = code_of(steel).punching if steel is not None else None
    return NO_COLUMNS if steel is None or rule is None else rule.at_columns(combined, steel)


def extremes_of_punching(combined: Results) -> Heads:
    """Return those columns of punching whose extremes are wanted, with their units."""
    steel = combined.model.reinforcement
    rule = code_of(steel).punching if steel is not None else None
    return rule.extremes if rule is not None else ()


def pile_punching(combined: Results) -> Table:
    """Return each pile's force and the demand of punching of the plate over it in each ultimate combination."""
    steel = combined.model.reinforcement
    assert steel is not None
    rule = code_of(steel).punching
    punched = NO_COLUMNS if rule is None else rule.over_piles(combined, steel)
    rows = [
        [
            result.combination,
            pile.name,
            float(pile.pushing(result)[0]) / 1e3,
            *punched.cells(result.combination, pile.name),
        ]
        for result in ultimate_results(combined)
        for pile in punching_piles(combined.model)
    ]
    heads = [("combination", ""), ("pile", ""), ("force", "kN"), *punched.heads]
    return table_of("pile_punching", "Punching over piles", heads, rows, punched.notes)


def zone_punching(combined: Results) -> Table:
    """Return the demand of punching around each thicker zone with columns on it in each ultimate combination."""
    steel = combined.model.reinforcement
    assert steel is not None
    rule = code_of(steel).punching
    punched = NO_COLUMNS if rule is None else rule.around_zones(combined, steel)
    rows: list[list[Cell]] = [
        [
            result.combination,
            zone.name,
            ", ".join(zone.columns),
            *zone.place,
            float(zone.pushing(result)[0]) / 1e3,
            *punched.cells(result.combination, zone.name),
        ]
        for result in ultimate_results(combined)
        for zone in zone_forces(combined)
    ]
    heads = [
        ("combination", ""), ("zone", ""), ("columns", ""), ("x", "m"), ("y", "m"), ("load", "kN"), *punched.heads,
    ]  # fmt: skip
    return table_of("zone_punching", "Punching around thicker zones", heads, rows, punched.notes)


def shear_reinforcement(combined: Results) -> Table:
    """Return the links around each column, pile, zone and end of a wall that needs them, perimeter by perimeter."""
    layouts = punching_links(combined)
    heads = [
        ("support", ""), ("name", ""), ("perimeter", ""), ("distance from face", "m"), ("length", "m"), ("legs", ""),
        ("diameter", "mm"), ("required area", "cm2"), ("provided area", "cm2"), ("spacing", "mm"),
        ("largest spacing", "mm"), ("length of a leg", "m"), ("total length", "m"), ("mass", "kg"), ("x", "m"),
        ("y", "m"), ("combination", ""), ("remark", ""),
    ]  # fmt: skip
    rows: list[list[Cell]] = [row for layout in layouts for row in _link_rows(layout)]
    laid = [layout for layout in layouts if layout.perimeters]
    if laid:
        number, total, mass = (sum(getattr(layout, name) for layout in laid) for name in ("number", "total", "mass"))
        rows.append([None, "all", *[None] * 3, number, *[None] * 6, total, mass, *[None] * 4])
    clauses = ", ".join(dict.fromkeys(layout.clauses for layout in layouts))
    notes = [
        Message(
            "Vertical legs in perimeters around what punches, by {clauses}, of the diameter of "
            "reinforcement.proposal.link_diameters that needs the least steel. They are proposed: the case "
            "has no links.",
            clauses=Clause(clauses),
        ),
        "Legs are as long as the covers of both faces leave of the thickness, without hooks, and keep off edges and "
        "openings by the larger cover. Steel of 7850 kg/m3 (EN 1992-1-1 3.2.7(3)).",
    ]
    return table_of("shear_reinforcement", "Links against punching", heads, rows, notes)


def _link_rows(layout: LinkLayout) -> Iterator[list[Cell]]:
    """Yield the rows of what links a column, pile, zone or end of a wall has, or the one that says why it has none."""
    start: list[Cell] = [layout.support, layout.name]
    end: list[Cell] = [*layout.place, layout.combination]
    if not layout.perimeters:
        yield [*start, *[None] * 12, *end, layout.why]
    for position, perimeter in enumerate(layout.perimeters, start=1):
        number = len(perimeter.places)
        yield [
            *start, position, perimeter.distance, perimeter.length, number, layout.diameter * 1e3,
            perimeter.required * 1e4, perimeter.provided * 1e4, perimeter.spacing * 1e3, perimeter.most_spacing * 1e3,
            layout.leg, number * layout.leg, number * layout.leg_mass, *end, None,
        ]  # fmt: skip


def wall_punching(combined: Results) -> Table:
    """Return the demand of punching at each end and corner of walls that press in each ultimate combination."""
    steel = combined.model.reinforcement
    assert steel is not None
    rule = code_of(steel).punching
    punched = NO_COLUMNS if rule is None else rule.at_walls(combined, steel)
    ends = loaded_ends(combined.model)
    rows: list[list[Cell]] = []
    for result in ultimate_results(combined):
        for end in ends:
            cells = punched.cells(result.combination, end.name)
            if any(cell is not None for cell in cells):
                rows.append([result.combination, end.walls, end.label, *end.place, *cells])
    heads = [("combination", ""), ("wall", ""), ("place", ""), ("x", "m"), ("y", "m"), *punched.heads]
    return table_of("wall_punching", "Punching at walls' ends", heads, rows, punched.notes)
