"""What tables have of punching, by the code of the case: at columns, over piles, around zones, and at walls' ends."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass

from groundslab.design.bars.proposal.links import punching_links
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.perimeter_loads import punching_piles
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.punching import Demand, Heads
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.design.rules.wall_ends import loaded_ends
from groundslab.messages import Clause, Message, joined
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results
from groundslab.views.tables.table import Cell, Table, table_of

#: What becomes of what pulls.
_PULLED = (
    "Where a column or zone pulls up, or a pile down, it punches the other way: what acts inside has the opposite "
    "sign, and d is less the mean distance of the bars' axes at the other face. It is taken as tied to the far face."
)
#: What beams do to it.
_BEAMS = "Other loads inside include the shear forces of beams across the perimeter, upwards negative."
#: What counts of a perimeter that leaves a thicker zone.
_THINNER = "Where the slab is thinner than that, a length of a perimeter counts by the share that it resists there."
#: The effective depth of columns, of piles and around thicker zones.
_DEPTH = {
    "column": "d is the least thickness under the column less the mean distance of the bottom bars' axes.",
    "pile": "d is the least thickness over the pile less the mean distance of the top bars' axes.",
    "zone": "d is the largest thickness at the border of the zone less the mean distance of the bottom bars' axes.",
}
#: What is around a zone.
_AROUND = "Perimeters run around the zone, or around its hull if it has reentrant corners, by their distance from it."
_ONE_EDGE = (
    "The line force of the ground along the plate's edge inside is not a pressure: it does not relieve punching, "
    "unless the case sets line_force_relieves; where it pulls, it is added."
)
_RELIEVES = (
    "The line force of the ground along the plate's edge inside is subtracted like the pressure inside, as the case "
    "sets line_force_relieves."
)
_LINKS = "Links that are given are not in what resists here; checks and calculations of punching have them."
_OVER_EDGE = (
    "The line force of the ground along the plate's edge inside adds to the punching force, as the pressure does."
)


@dataclass(frozen=True, slots=True)
class PunchingColumns:
    """The columns that a table has of punching, their cells by combination and name, and what a reader must know."""

    heads: Heads
    cells: Callable[[str, str], list[float | None]]
    notes: tuple[str, ...]


def punching_of(combined: Results, support: Support) -> PunchingColumns:
    """Return the columns of what punches in one way; none without reinforcement, or rules for it."""
    steel = combined.model.reinforcement
    rule = code_of(steel).punching if steel is not None else None
    if steel is None or rule is None:
        return PunchingColumns((), lambda _, __: [], ())
    demands, heads = rule.demands_of(combined, support), rule.heads(support)

    def cells(combination: str, name: str) -> list[float | None]:
        demand = demands.found.get((combination, name))
        return [None] * len(heads) if demand is None else rule.cells(demand, steel, support)

    notes = rule.notes(support, steel)
    if steel.links:
        notes += (_LINKS,)
    if support != "wall end":
        of_depth = _DEPTH[support].replace("d is", f"{rule.depth} is")
        notes += (_edge_note(steel, support), joined((of_depth, _THINNER), " "), *_pulled_notes(demands.found.values()))
        notes += (*((_AROUND,) if support == "zone" else ()), *((_BEAMS,) if combined.model.beams else ()))
        notes += _missing_notes(demands.missing, support)
    return PunchingColumns(heads, cells, notes)


def _edge_note(steel: Reinforcement, support: str) -> str:
    """Return the effect of the line force along the plate's edge in words, at a "column", "pile" or "zone"."""
    if support == "pile":
        return _OVER_EDGE
    return _RELIEVES if steel.line_force_relieves else _ONE_EDGE


def _pulled_notes(demands: Iterable[Demand]) -> tuple[str, ...]:
    """Return what becomes of columns, piles or zones that pull as a note, if any does."""
    return (_PULLED,) if any(demand.pulls for demand in demands) else ()


def _missing_notes(missing: Mapping[str, str], support: str) -> tuple[str, ...]:
    """Return why some have no perimeter, by their names, as notes."""
    if support == "zone":
        return tuple(Message("no punching around {name}: {why}", name=name, why=why) for name, why in missing.items())
    return tuple(
        Message("no punching of {support} {name}: {why}", support=support, name=name, why=why)
        for name, why in missing.items()
    )


def extremes_of_punching(combined: Results) -> Heads:
    """Return those columns of punching whose extremes are wanted, with their units."""
    steel = combined.model.reinforcement
    rule = code_of(steel).punching if steel is not None else None
    return rule.extremes if rule is not None else ()


def pile_punching(combined: Results) -> Table:
    """Return each pile's force and the demand of punching of the plate over it in each ultimate combination."""
    punched = punching_of(combined, "pile")
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
    punched = punching_of(combined, "zone")
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
            "Vertical legs in perimeters around what punches, by {clauses}: those of reinforcement.links, and where "
            "the case gives none proposed ones, of the diameter of reinforcement.proposal.link_diameters that needs "
            "the least steel.",
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
            layout.leg, number * layout.leg, number * layout.leg_mass, *end, "given" if layout.limits else "proposed",
        ]  # fmt: skip


def wall_punching(combined: Results) -> Table:
    """Return the demand of punching at each end and corner of walls that press in each ultimate combination."""
    punched = punching_of(combined, "wall end")
    ends = loaded_ends(combined.model)
    rows: list[list[Cell]] = []
    for result in ultimate_results(combined):
        for end in ends:
            cells = punched.cells(result.combination, end.name)
            if any(cell is not None for cell in cells):
                rows.append([result.combination, end.walls, end.label, *end.place, *cells])
    heads = [("combination", ""), ("wall", ""), ("place", ""), ("x", "m"), ("y", "m"), *punched.heads]
    return table_of("wall_punching", "Punching at walls' ends", heads, rows, punched.notes)
