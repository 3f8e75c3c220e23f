"""How a table of reactions of another program is read: what its columns, units and signs mean, for the next import."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from groundslab import units
from groundslab.model.ground import POSITIVE
from groundslab.model.loads.load_cases import LoadCase
from groundslab.model.structure.columns import Column
from groundslab.model.structure.walls import Wall
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Boolean, Choice, ListOf, Quantity, Text, list_quantities
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.places import place_in_plan
from groundslab.schema.ranges import Range
from groundslab.schema.repairs import use_nearest
from groundslab.schema.section_fields import Table
from groundslab.schema.wording import describe, one_of, quote, suggestion

Positive = Literal["presses", "lifts"]
Moments = Literal["about axes", "about axes, left-handed", "as here"]
Decimals = Literal["point", "comma"]
Horizontal = Literal["left out", "on the slab", "on the structure"]


class ReactionHeadings(Section):
    """Headings of the table's columns, where they are not found by the names that programs usually give them."""

    support: Annotated[str, Text("column with the names or numbers of the supports")] = ""
    case: Annotated[str, Text("column with the load cases")] = ""
    x: Annotated[str, Text("column with the coordinate along x")] = ""
    y: Annotated[str, Text("column with the coordinate along y")] = ""
    F_x: Annotated[str, Text("column with the horizontal forces along x")] = ""
    F_y: Annotated[str, Text("column with the horizontal forces along y")] = ""
    F_z: Annotated[str, Text("column with the vertical forces")] = ""
    M_x: Annotated[str, Text("column with the moments that the table names after x")] = ""
    M_y: Annotated[str, Text("column with the moments that the table names after y")] = ""


class ReactionCase(Section):
    """A load case of the table that has another name here."""

    table: Annotated[str, Text("its name in the table")]
    case: Annotated[str, Text("its name here, one of [[cases]]")]


class ReactionSupport(Section):
    """A support of the table that stands for a column or a wall of another name."""

    table: Annotated[str, Text("its name in the table")]
    on: Annotated[str, Text("the column or wall, one of [[columns]] or [[walls]]")]


def _check_units(force: str, moment: str, length: str) -> Iterator[RelativeIssue]:
    for name, unit, dimension in (
        ("force", force, "force"),
        ("moment", moment, "moment"),
        ("length", length, "length"),
    ):
        kinds = (dimension,) if dimension == "length" else (dimension, f"{dimension} per length")
        reasons = [_why_no_unit(unit, kind) for kind in kinds]
        if unit and all(reasons):
            yield RelativeIssue((name,), quote(unit), f"a unit of {units.DIMENSIONS[dimension].phrase}", reasons[0])


def _why_no_unit(unit: str, dimension: str) -> str:
    """Return why a text is no unit of a dimension, nothing if it is one."""
    try:
        units.parse(f"1 {unit}", dimension)
    except units.QuantityError as error:
        return error.reason or "another unit"
    return ""


def _check_names(cases: tuple[ReactionCase, ...], supports: tuple[ReactionSupport, ...]) -> Iterator[RelativeIssue]:
    for key, names in (("cases", [pair.table for pair in cases]), ("supports", [pair.table for pair in supports])):
        count = Counter(names)
        for position, name in enumerate(names):
            if count[name] > 1:
                yield RelativeIssue((key, position, "table"), f"{describe(name)} twice", "each name once")


class Reactions(Section):
    """How the last table of reactions was read, so that the next one needs no more than its file.

    The analysis doesn't use it. The loads that came from the table have a `source`.
    """

    constraints: ClassVar[tuple[Check, ...]] = (_check_units, _check_names)

    file: Annotated[str, Text("name of the file that was imported last, for reference")] = ""
    sheet: Annotated[str, Text("sheet of a workbook, where several have reactions")] = ""
    case: Annotated[str, Text("load case of a table that names none")] = ""
    force: Annotated[str, Text("unit of forces, where the table states none, such as kN, or kN/m along walls")] = ""
    moment: Annotated[str, Text("unit of moments, where the table states none, such as kNm")] = ""
    length: Annotated[str, Text("unit of coordinates, where the table states none, such as m")] = ""
    decimals: Annotated[
        Decimals | None, Choice(Decimals, "what stands before decimals, where the numbers leave it open", "")
    ] = None
    positive: Annotated[
        Positive, Choice(Positive, "what a support with a positive vertical force does to the slab", "")
    ] = "presses"
    moments: Annotated[
        Moments,
        Choice(
            Moments,
            "what moments mean: named after the axis that they turn about, by the right-hand rule together with the "
            "forces, or by the left-hand rule, or as M_x and M_y of loads here",
            "",
        ),
    ] = "about axes"
    horizontal: Annotated[
        Horizontal,
        Choice(
            Horizontal,
            "what F_x and F_y of the table act on, whose sums become H_x and H_y of load cases; or that they do not",
            "",
        ),
    ] = "left out"
    mirrored: Annotated[
        bool, Boolean("whether y of the table points the other way than here, as it may where its z points down")
    ] = False
    origin: Annotated[tuple[float, float], place_in_plan("place of the table's origin in the plan here")] = (0.0, 0.0)
    tolerance: Annotated[
        float,
        Quantity(
            "length",
            "",
            "distance up to which a support stands for the nearest column or wall",
            Range(at_least=0),
            example="0.1 m",
        ),
    ] = 0.1
    footprint: Annotated[
        tuple[float, float] | None,
        list_quantities(
            "length",
            "c_x, c_y",
            "widths of the columns made for supports that nothing else stands for",
            ("c_x", "c_y"),
            POSITIVE,
            example="0.4 m",
        ),
    ] = None
    without_cases: Annotated[
        tuple[str, ...], ListOf(Text(""), "", "load cases of the table that are left out", unique=True, least=0)
    ] = ()
    without_supports: Annotated[
        tuple[str, ...], ListOf(Text(""), "", "supports of the table that are left out", unique=True, least=0)
    ] = ()
    headings: Annotated[ReactionHeadings, Table("headings of the table's columns")] = ReactionHeadings()
    cases: Annotated[tuple[ReactionCase, ...], Table("load cases that have another name here")] = ()
    supports: Annotated[
        tuple[ReactionSupport, ...], Table("supports that stand for a column or wall of another name", 10_000)
    ] = ()


def check_reactions(
    reactions: Reactions | None, cases: tuple[LoadCase, ...], columns: tuple[Column, ...], walls: tuple[Wall, ...]
) -> Iterator[RelativeIssue]:
    """Find cases, columns and walls that a table of reactions stands for and that are not there."""
    if reactions is None:
        return
    known_cases = [case.name for case in cases]
    bases = [column.name for column in columns] + [wall.name for wall in walls]
    pairs = [(("cases", n, "case"), pair.case, known_cases) for n, pair in enumerate(reactions.cases)]
    pairs += [(("supports", n, "on"), pair.on, bases) for n, pair in enumerate(reactions.supports)]
    for place, name, names in pairs:
        if name not in names:
            expected = one_of(names) if names else f"[[{place[0]}]] that have it"
            path = ("reactions", *place)
            yield RelativeIssue(path, describe(name), expected, suggestion(name, names), use_nearest(path, name, names))
