"""Tables of results for calculations: all combinations, and envelopes at the plate's nodes."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial

from groundslab.design.bars.bending import bent_bars
from groundslab.design.bars.members import members_of
from groundslab.design.bars.proposal.links import punching_links
from groundslab.design.checks import check_design
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.perimeter_loads import punching_piles
from groundslab.design.demands.support_moments import has_support_areas
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.rules.wall_ends import loaded_ends
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.ground import ContinuousGround
from groundslab.results.results import Results
from groundslab.schema.issues import require
from groundslab.unit_systems import System
from groundslab.views.tables import errors
from groundslab.views.tables.bar_quantities import bars
from groundslab.views.tables.bending_schedule import NAME as SCHEDULE
from groundslab.views.tables.bending_schedule import bending_schedule
from groundslab.views.tables.calculations import calculations
from groundslab.views.tables.checks_table import checks_table
from groundslab.views.tables.envelopes import envelopes, fields_of_envelope
from groundslab.views.tables.locations import lines, points, soil, strips
from groundslab.views.tables.punching import pile_punching, shear_reinforcement, wall_punching, zone_punching
from groundslab.views.tables.reinforcement import reinforcement, support_moments
from groundslab.views.tables.structure.beams import beam_reinforcement, beam_table
from groundslab.views.tables.structure.building import building_table, storey_table
from groundslab.views.tables.structure.columns import column_envelope, column_table
from groundslab.views.tables.structure.cores import core_load_table, core_table
from groundslab.views.tables.structure.walls import wall_limit_table, wall_reinforcement, wall_table
from groundslab.views.tables.summary import acting_cases, combinations, extremes, tilts
from groundslab.views.tables.supports import joint_table, support_table
from groundslab.views.tables.table import Column, Table, in_units

__all__ = ["Column", "Table", "fields_of_envelope", "table_makers", "tables_of"]


def tables_of(combined: Results) -> tuple[Table, ...]:
    """Return the tables of results: combinations, extremes, envelopes and tilt, and those that the model asks for.

    Load cases have a table of what acts where. Points, section lines, design strips, supports, joints, walls and their
    limits, beams, the building above with its storeys, columns, piles and ends of walls that punch the plate,
    reinforcement and laid bars have a table each if the model names any, and so have checks; on a continuum, the soil
    below the points too. Links against punching have one where they are needed.
    Discretization errors stand in columns at the right. docs/results.md explains every column.

    Parameters
    ----------
    combined : Results
        The results of all combinations.

    Returns
    -------
    tuple of Table
        The tables. `Table.csv` returns one as text, `Table.frame` as a pandas.DataFrame.

    Raises
    ------
    InputError
        If EN 1992-1-1 does not cover the concrete or the steel.

    References
    ----------
    EN 1992-1-1, Design of concrete structures: 6.1, 6.4 and 9.2.1; Wood 1968 and Armer 1968 (docs/bibliography.md).

    Examples
    --------
    >>> import groundslab
    >>> tables = {table.name: table for table in groundslab.tables_of(results)}
    >>> tables["combinations"]["outcome"]
    ('solved',)
    >>> tables["extremes"].columns[3].header
    'least'
    """
    require(combined, Results, name="results")
    return tuple(make() for make in table_makers(combined).values())


def _knows_storeys(combined: Results) -> bool:
    """Return whether results say what fewer storeys of a building would do."""
    return any(base.by_storeys.size for results in combined.values() for base in results.bases)


def table_makers(combined: Results) -> dict[str, Callable[[], Table]]:
    """Return the function for each table of `tables_of` by the table's name, in the units that the case asks for."""
    units = combined.model.units
    return {name: partial(_in_units, make, units) for name, make in _makers(combined).items()}


def _in_units(make: Callable[[], Table], units: System) -> Table:
    """Make a table in some units."""
    return in_units(make(), units)


def _makers(combined: Results) -> dict[str, Callable[[], Table]]:
    """Return the function for each table in SI units by the table's name; tables that others use are made once."""
    model = combined.model
    checks: dict[str, Callable[[], Table]] = {}
    design = check_design(combined)
    if design.checks:
        checks["checks"] = lambda: checks_table(combined)
    followed = model.reinforcement is not None or any(check.steps for check in design.checks)
    if followed and model.report.sheets != "none":
        checks["calculations"] = lambda: calculations(combined)
    acting: dict[str, Callable[[], Table]] = {"acting": lambda: acting_cases(combined)} if model.cases else {}
    extremes_with_errors = cache(lambda: errors.with_errors_of_extremes(extremes(combined), combined))
    columns = cache(lambda: errors.with_errors(column_table, combined))
    makers: dict[str, Callable[[], Table]] = {
        "combinations": lambda: errors.with_errors_of_figures(
            errors.with_errors(combinations, combined), extremes_with_errors()
        ),
        **acting,
        "extremes": extremes_with_errors,
        "envelope": lambda: errors.with_errors_of_envelope(envelopes(combined), extremes_with_errors()),
        "tilt": lambda: errors.with_errors(tilts, combined),
        **checks,
    }
    wanted = {
        "points": (model.output.points, points),
        "soil": (isinstance(model.ground, ContinuousGround) and model.output.points, soil),
        "lines": (model.output.lines, lines),
        "strips": (model.output.strips, strips),
        "supports": (model.supports, support_table),
        "joints": (model.joints, joint_table),
        "walls": (model.walls, wall_table),
        "beams": (model.members or model.output.beams, beam_table),
        "building": (model.building, building_table),
    }
    makers |= {name: partial(errors.with_errors, make, combined) for name, (asked, make) in wanted.items() if asked}
    if any(results.wall_limits for results in combined.values()):
        makers["wall_limits"] = lambda: wall_limit_table(combined)
    if model.cores:
        makers["cores"] = lambda: core_table(combined)
    if any(load.kind == "core" for load in model.loads):
        makers["core_loads"] = lambda: core_load_table(combined)
    if _knows_storeys(combined):
        makers["storeys"] = lambda: storey_table(combined)
    if model.columns:
        makers |= {"columns": columns, "column_envelope": lambda: column_envelope(combined, columns())}
    if model.reinforcement is not None:
        makers |= _of_reinforcement(combined, model.reinforcement)
    return makers


def _of_reinforcement(combined: Results, steel: Reinforcement) -> dict[str, Callable[[], Table]]:
    """Return the functions for tables of a design with bars."""
    model = combined.model
    makers: dict[str, Callable[[], Table]] = {}
    if punching_piles(model):
        makers["pile_punching"] = lambda: errors.with_errors(pile_punching, combined)
    if zone_forces(combined):
        makers["zone_punching"] = lambda: errors.with_errors(zone_punching, combined)
    if loaded_ends(model):
        makers["wall_punching"] = lambda: errors.with_errors(wall_punching, combined)
    wanted = {
        "reinforcement": (True, reinforcement),
        "support_moments": (steel.averaging.at_columns != "peak" and has_support_areas(model), support_moments),
        "beam_reinforcement": (bool(members_of(model)), beam_reinforcement),
        "wall_reinforcement": (
            code_of(steel).walls and any(wall.height is not None for wall in model.walls), wall_reinforcement,
        ),
    }  # fmt: skip
    for name, (asked, make) in wanted.items():
        if asked:
            makers[name] = partial(errors.with_errors_of_governing, partial(make, steel=steel), combined)
    links = punching_links(combined)
    if links:
        makers["shear_reinforcement"] = lambda: shear_reinforcement(combined)
    if steel.laid:
        makers["bars"] = lambda: bars(model, links)
        if bent_bars(model, links):
            makers[SCHEDULE] = lambda: bending_schedule(model, links)
    return makers
