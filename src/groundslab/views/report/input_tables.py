"""The case as a reader checks it: every key with its symbol, its value in a fitting unit, and what it means.

All of it is derived from what ``model`` states of each key, so that a new key appears without a change here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from groundslab.messages import Clause, Message, Name, joined, words_in
from groundslab.model.loads.annexes import document_of
from groundslab.model.remarks.case_use import case_uses
from groundslab.model.remarks.remarks import find_remarks
from groundslab.model.shapes import Circle, Polygon, Rectangle
from groundslab.schema.base import Section
from groundslab.schema.distances import Distances
from groundslab.schema.fields import Boolean, Factors, FieldType, Integer, ListOf, Number, Quantity
from groundslab.schema.section_fields import Field
from groundslab.unit_systems import System, together
from groundslab.views.report.applicable_keys import keys_without_use
from groundslab.views.report.table_layout import (
    GREEK,
    Cell,
    Kind,
    TableHeader,
    TableLayout,
    drop_empty_columns,
    headers,
)
from groundslab.views.summary.combinations import factors_text

if TYPE_CHECKING:
    from groundslab.model.loads.load_cases import Combination
    from groundslab.model.model import Model

#: Titles of the sections of a case, in the order of the report.
SECTIONS = {
    "plate": "Plate",
    "plates": "Further plates",
    "joints": "Joints",
    "axes": "Axes of the building",
    "ground": "Ground",
    "soil_zones": "Zones of soil",
    "boreholes": "Boreholes",
    "beyond": "Ground beyond the plate",
    "contact": "Contact",
    "columns": "Columns",
    "walls": "Walls",
    "cores": "Cores",
    "beams": "Beams",
    "building": "Building above",
    "supports": "Supports",
    "cases": "Load cases",
    "loads": "Loads",
    "reactions": "Table of reactions",
    "patterns": "Vehicles and racks",
    "moves": "Places and paths",
    "combinations": "Combinations",
    "combine": "Automatic combinations",
    "reinforcement": "Reinforcement",
    "cracking": "Cracked stiffness",
    "long_term": "Ground under lasting loads",
    "limits": "Limits",
    "checks": "Checks that are switched off",
    "soil_strength": "Strength of the soil",
    "floor": "Industrial floor",
    "output": "Points, lines and strips",
    "mesh": "Mesh",
    "analysis": "Analysis",
}
#: What one of a list is called, by the name of the list.
ONE = {"soil_zones": "Zone of soil", "boreholes": "Borehole", "zones": "Zone", "gaps": "Measured gap"}
#: Keys that are listed even if all of a list have what a case has that says nothing; and what nothing then means.
ALWAYS = {"psi_0": "", "psi_1": "", "psi_2": "", "stiffness": "rigid"}
_ITEM = headers("key", "symbol", "value", "meaning")


@dataclass(frozen=True, slots=True)
class InputTable:
    """One section of a case: its grids under one heading."""

    key: str
    title: str
    grids: tuple[TableLayout, ...]


def input_tables(model: Model, combinations: Sequence[Combination]) -> list[InputTable]:
    """Return all of a case, section by section, with what was solved; what is not there is left out."""
    tables = []
    remarks = find_remarks(model, combinations)
    without_use = keys_without_use(model)
    for name, title in SECTIONS.items():
        value = getattr(model, name)
        hidden = without_use.get(name, frozenset())
        if name == "combinations":
            grids = [_combinations(combinations)] if model.cases else []
        elif isinstance(value, Section):
            grids = list(_part(value, "", model.units, hidden))
        else:
            grids = list(_list(value or (), name, "", model.units, hidden))
        if name == "cases" and model.cases:
            grids.append(_acting(model, combinations))
        notes = [
            words_in(Message("Remark: {words}.", words=remark.words), model.units)
            for remark in remarks
            if remark.path[0] == name
        ]
        if name == "combine":
            notes += _national(model)
        if notes and grids:
            grids[-1] = replace(grids[-1], notes=(*grids[-1].notes, *notes))
        if grids:
            tables.append(InputTable(name, title, tuple(grids)))
    return tables


def _national(model: Model) -> list[str]:
    """Return whose psi and partial factors combinations have, where an annex differs from what is recommended."""
    annex = None if model.combine is None else model.combine.annex
    document = "" if annex is None else document_of(annex)
    template = "psi and factors that the case does not give are those of {document}."
    return [Message(template, document=Clause(document))] if document else []


def format_value(key: FieldType, value: Any, units: System) -> str:
    """Return a value as people write it: quantities with five digits and a fitting unit, numbers with six."""
    if isinstance(value, str):
        return value
    if isinstance(key, Quantity):
        (text,), unit = together([value], key.dimension, units)
        return Message("{number} {unit}", number=text, unit=Name(unit))
    if isinstance(key, ListOf):
        return _several(key, value, units)
    if isinstance(key, Distances):
        texts, unit = together(value, "length", units)
        return Message("{numbers} {unit}", numbers=", ".join(texts), unit=Name(unit))
    if isinstance(key, Boolean):
        return "yes" if value else "no"
    if isinstance(key, Number):
        return f"{value:.6g}"
    if isinstance(key, Factors):
        return joined(Message("{factor:.6g} {name}", factor=number, name=Name(name)) for name, number in value)
    assert isinstance(key, Integer)
    return str(value)


def describe_shape(shape: Section, units: System) -> str:
    """Return a shape in words, its places in meters or feet."""
    return words_in(_shape(shape), units)


def _shape(shape: Section) -> str:
    """Return a shape in words."""
    if isinstance(shape, Circle):
        return Message("circle about {center:at m}, radius {radius:.6g m}", center=shape.centre, radius=shape.radius)
    if isinstance(shape, Rectangle):
        (x0, x1), (y0, y1) = shape.x, shape.y
        template = "rectangle, x = {x0:at (m)} to {x1:at m}, y = {y0:at (m)} to {y1:at m}"
        return Message(template, x0=x0, x1=x1, y0=y0, y1=y1)
    assert isinstance(shape, Polygon)
    if not any(shape.bulges):
        return Message("polygon {corners}", corners=_places(shape.points))
    bulges = ", ".join(f"{bulge:.6g}" for bulge in shape.bulges)
    return Message("polygon {corners}; bulges {bulges}", corners=_places(shape.points), bulges=bulges)


def _places(places: Sequence[Sequence[float]]) -> str:
    """Return places [m], which share their unit."""
    last = len(places) - 1
    return joined(
        (Message("{at:at (m)}" if number < last else "{at:at m}", at=place) for number, place in enumerate(places)), " "
    )


def _several(key: ListOf, values: Sequence[Any], units: System) -> str:
    """Return a list of values; those with one unit share it."""
    item = key.each
    if isinstance(item, ListOf):
        return words_in(_places(values), units)
    if isinstance(item, Quantity):
        texts, unit = together(values, item.dimension, units)
        if key.rising and len(texts) == 2:
            return Message("{low} to {high} {unit}", low=texts[0], high=texts[1], unit=Name(unit))
        return Message("{numbers} {unit}", numbers=f"({', '.join(texts)})", unit=Name(unit))
    return joined(format_value(item, value, units) for value in values)


def _part(part: Section, title: str, units: System, hidden: Set[str] = frozenset()) -> Iterator[TableLayout]:
    """Yield what a part says itself, then the parts in it; hidden keys stand there only if they are given."""
    rows: list[tuple[Cell, ...]] = []
    below: list[TableLayout] = []
    for name, field in type(part).model_fields.items():
        value, key = getattr(part, name), field.type
        if name in hidden and name not in part.model_fields_set:
            continue
        if key is not None:
            if value is not None and value != ():
                rows.append(_row(name, key, value, field, units))
        elif isinstance(value, Rectangle | Polygon | Circle):
            rows.append((Cell(name), Cell(""), Cell(describe_shape(value, units)), Cell(field.meaning, "muted")))
        elif isinstance(value, Section):
            below += _part(value, _words(name), units)
        elif isinstance(value, tuple):
            below += _list(value, name, _words(name), units)
        elif value is not None:
            rows.append((Cell("kind"), Cell(""), Cell(str(value)), Cell(field.meaning, "muted")))
    if rows:
        yield drop_empty_columns(TableLayout(title, _ITEM, tuple(rows)))
    yield from below


def _row(name: str, key: FieldType, value: Any, field: Field, units: System) -> tuple[Cell, ...]:
    """Return the row of a key; what a case has that does not say it is called default."""
    default = not field.required and value == field.default
    said = default and "by default" not in key.meaning
    meaning = Message("{meaning} (default)", meaning=key.meaning) if said else key.meaning
    words = name if name == key.symbol else name.replace("_", " ")
    symbol = Cell("" if name == key.symbol and name not in GREEK else key.symbol, "symbol")
    return (Cell(words, "words"), symbol, Cell(format_value(key, value, units)), Cell(meaning, "muted"))


def _list(
    parts: Sequence[Section], name: str, title: str, units: System, hidden: Set[str] = frozenset()
) -> Iterator[TableLayout]:
    """Yield a list of parts, those of one kind in one grid, numbered as in the case; lists in them stand below."""
    kinds: dict[type[Section], list[tuple[int, Section]]] = {}
    for number, part in enumerate(parts, 1):
        kinds.setdefault(type(part), []).append((number, part))
    for kind, members in kinds.items():
        tag = kind.model_fields.get("kind")
        meaning = joined((tag.default, tag.meaning)) if tag is not None and tag.type is None else ""
        yield _columns(kind, members, joined(filter(None, (title, meaning)), ": "), units, hidden)
    for number, part in enumerate(parts, 1):
        numbered = Message("{what} {number}", what=ONE.get(name, _words(name)), number=number)
        called = joined(filter(None, (numbered, getattr(part, "name", ""))))
        for inner, field in type(part).model_fields.items():
            value = getattr(part, inner)
            if field.sections.many and value:
                yield from _list(value, inner, joined((called, inner), ": "), units)
            elif isinstance(value, Section) and not isinstance(value, Rectangle | Polygon | Circle):
                yield from _part(value, joined((called, inner), ": "), units)


def _columns(
    kind: type[Section], numbered: list[tuple[int, Section]], title: str, units: System, hidden: Set[str] = frozenset()
) -> TableLayout:
    """Return parts of one kind, one a row; keys that are nowhere given have no column, nor have hidden defaults."""
    heads, columns = ([TableHeader("no.", number=True)], [[Cell(str(number), "number") for number, _ in numbered]])
    for name, field in kind.model_fields.items():
        values = [getattr(part, name) for _, part in numbered]
        key, default = field.type, field.default
        said = any(value not in (None, "", ()) and (field.required or value != default) for value in values)
        if not said and (name not in ALWAYS or name in hidden or key is None):
            continue
        if key is not None:
            head, cells = _column(name, key, values, units)
        elif isinstance(next(value for value in values if value is not None), Rectangle | Polygon | Circle):
            head = TableHeader(_words(name).lower())
            cells = [Cell("" if value is None else describe_shape(value, units)) for value in values]
        else:
            continue
        heads.append(head)
        columns.append(cells)
    return TableLayout(title, tuple(heads), tuple(zip(*columns, strict=True)))


def _column(name: str, key: FieldType, values: list[Any], units: System) -> tuple[TableHeader, list[Cell]]:
    """Return the column of a key; its quantities have one unit."""
    words, symbol = name.replace("_", " "), key.symbol
    if symbol == name:
        words, symbol = ("", symbol) if symbol in GREEK else (name, "")
    nothing = Cell(ALWAYS.get(name, ""))
    if not isinstance(key, Quantity):
        kind: Kind = "number" if isinstance(key, Number | Integer) else ""
        cells = [nothing if value is None else Cell(format_value(key, value, units), kind) for value in values]
        return TableHeader(words, "", bool(kind), symbol), cells
    texts, unit = together([value for value in values if value is not None], key.dimension, units)
    left = iter(texts)
    cells = [nothing if value is None else Cell(next(left), "number") for value in values]
    return TableHeader(words, unit if texts else "", number=True, symbol=symbol), cells


def _combinations(combinations: Sequence[Combination]) -> TableLayout:
    """Return the table of solved combinations: those of the case and those made by EN 1990, or each load case."""
    heads = headers("#no.", "name", "limit state", "loads that act together")
    rows = tuple(
        (
            Cell(str(number), "number"),
            Cell(combination.name),
            Cell(combination.limit_state),
            Cell(factors_text(combination)),
        )
        for number, combination in enumerate(combinations, 1)
    )
    return TableLayout("", heads, rows, ("Each is solved by itself, with all its loads growing together.",))


def _acting(model: Model, combinations: Sequence[Combination]) -> TableLayout:
    """Return with which factors each case acts in the combinations of each limit state, and in how many of them."""
    heads = headers("case", "#loads", "limit state", "factors")
    rows = []
    for use in case_uses(model, combinations):
        about = (Cell(use.case.name), Cell(str(use.loads), "number"))
        rows += [(*about, Cell(acting.limit_state), Cell(acting.factors())) for acting in use.acting]
        if not use.acting:
            rows.append((*about, Cell("-"), Cell("-")))
    notes = ("Factors, and the number of combinations in which the case acts.",)
    return TableLayout("what acts where", heads, tuple(rows), notes)


def _words(name: str) -> str:
    """Return a key's name as words."""
    return name.replace("_", " ").capitalize()
