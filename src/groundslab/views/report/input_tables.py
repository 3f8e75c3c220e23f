"""The case as a reader checks it: every key with its symbol, its value in a fitting unit, and what it means.

All of it is derived from what ``model`` states of each key, so that a new key appears without a change here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from groundslab.messages import words_in
from groundslab.model.loads.annexes import document_of
from groundslab.model.names import names_of
from groundslab.model.remarks.case_use import case_uses
from groundslab.model.remarks.remarks import find_remarks
from groundslab.model.shapes import Circle, Polygon, Rectangle
from groundslab.schema.base import Section
from groundslab.schema.distances import Distances
from groundslab.schema.fields import Boolean, Factors, FieldType, Integer, ListOf, Number, Quantity
from groundslab.schema.section_fields import Field
from groundslab.unit_systems import System, together, unit_in
from groundslab.units import format_coordinate
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
            f"Remark: {words_in(remark.words, model.units, names_of(model))}."
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
    return [f"psi and factors that the case does not give are those of {document}."] if document else []


def format_value(key: FieldType, value: Any, units: System) -> str:
    """Return a value as people write it: quantities with five digits and a fitting unit, numbers with six."""
    if isinstance(value, str):
        return value
    if isinstance(key, Quantity):
        (text,), unit = together([value], key.dimension, units)
        return f"{text} {unit}"
    if isinstance(key, ListOf):
        return _several(key, value, units)
    if isinstance(key, Distances):
        texts, unit = together(value, "length", units)
        return f"{', '.join(texts)} {unit}"
    if isinstance(key, Boolean):
        return "yes" if value else "no"
    if isinstance(key, Number):
        return f"{value:.6g}"
    if isinstance(key, Factors):
        return ", ".join(f"{number:.6g} {name}" for name, number in value)
    assert isinstance(key, Integer)
    return str(value)


def describe_shape(shape: Section, units: System) -> str:
    """Return a shape in words, its places in meters or feet."""
    unit, per_meter = unit_in("m", units)
    if isinstance(shape, Circle):
        return f"circle about {_places([shape.centre], units)} {unit}, radius {shape.radius * per_meter:.6g} {unit}"
    if isinstance(shape, Rectangle):
        return f"rectangle, x = {_span(shape.x, units)} {unit}, y = {_span(shape.y, units)} {unit}"
    assert isinstance(shape, Polygon)
    bulges = f"; bulges {', '.join(f'{bulge:.6g}' for bulge in shape.bulges)}" if any(shape.bulges) else ""
    return f"polygon {_places(shape.points, units)} {unit}{bulges}"


def _span(ends: tuple[float, float], units: System) -> str:
    """Return two lengths [m] in meters or feet."""
    _, per_meter = unit_in("m", units)
    return " to ".join(format_coordinate(end * per_meter) for end in ends)


def _places(places: Sequence[Sequence[float]], units: System) -> str:
    """Return places [m] in meters or feet."""
    _, per_meter = unit_in("m", units)
    return " ".join(f"({', '.join(format_coordinate(x * per_meter) for x in place)})" for place in places)


def _several(key: ListOf, values: Sequence[Any], units: System) -> str:
    """Return a list of values; those with one unit share it."""
    item = key.each
    if isinstance(item, ListOf):
        return f"{_places(values, units)} {unit_in('m', units)[0]}"
    if isinstance(item, Quantity):
        texts, unit = together(values, item.dimension, units)
        is_range = key.rising and len(texts) == 2
        return f"{' to '.join(texts)} {unit}" if is_range else f"({', '.join(texts)}) {unit}"
    return ", ".join(format_value(item, value, units) for value in values)


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
    meaning = f"{key.meaning} (default)" if default and "by default" not in key.meaning else key.meaning
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
    for kind, numbered in kinds.items():
        tag = kind.model_fields.get("kind")
        meaning = f"{tag.default}, {tag.meaning}" if tag is not None and tag.type is None else ""
        yield _columns(kind, numbered, ": ".join(filter(None, (title, meaning))), units, hidden)
    for number, part in enumerate(parts, 1):
        called = ", ".join(filter(None, (f"{ONE.get(name, _words(name))} {number}", getattr(part, "name", ""))))
        for inner, field in type(part).model_fields.items():
            value = getattr(part, inner)
            if field.sections.many and value:
                yield from _list(value, inner, f"{called}: {inner}", units)
            elif isinstance(value, Section) and not isinstance(value, Rectangle | Polygon | Circle):
                yield from _part(value, f"{called}: {inner}", units)


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
        for acting in use.acting:
            words = acting.words().removeprefix(acting.limit_state).strip()
            rows.append((*about, Cell(acting.limit_state), Cell(words)))
        if not use.acting:
            rows.append((*about, Cell("-"), Cell("-")))
    notes = ("Factors, and the number of combinations in which the case acts.",)
    return TableLayout("what acts where", heads, tuple(rows), notes)


def _words(name: str) -> str:
    """Return a key's name as words."""
    return name.replace("_", " ").capitalize()
