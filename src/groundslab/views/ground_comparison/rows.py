"""The rows of a comparison of grounds: a quantity of each ground, and how far it is from the continuum's."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from groundslab.analysis.ground_comparison.figures import COMPARED_FIELDS, FIGURES
from groundslab.messages import Message, Name, words_in
from groundslab.results.fields import PLATE_FIELDS
from groundslab.unit_systems import in_system, unit_in
from groundslab.units import UNITS, format_number
from groundslab.views.tables.table import Table, in_units, table_of

if TYPE_CHECKING:
    from groundslab.analysis.ground_comparison.comparison import GroundComparison

#: Units of display of the grounds' constants.
CONSTANTS = {"k": "MPa/m", "k0": "MPa/m", "k1": "MPa m", "gamma": ""}
#: Values below this share of the largest in their row are rounding.
ROUNDING = 1e-6


@dataclass(frozen=True, slots=True)
class ComparisonRow:
    """One quantity: its name in files, what it is called, its unit of display, and for each ground its value in it.

    A difference is that to the continuum in percent of it; None where there is none to tell.
    """

    name: str
    label: str
    unit: str
    values: tuple[float | None, ...]
    differences: tuple[float | None, ...]

    def texts(self) -> Iterator[tuple[str, str]]:
        """Yield value and difference of each ground as texts."""
        nothing = ROUNDING * max(abs(value) for value in self.values if value is not None)
        for value, difference in zip(self.values, self.differences, strict=True):
            shown = 0.0 if value is not None and abs(value) < nothing else value
            yield (
                "" if shown is None else format_number(shown, 4, trim=True),
                "" if difference is None else f"{round(difference, 1) + 0.0:+.1f} %",
            )


def headings(comparison: GroundComparison) -> tuple[str, ...]:
    """Return the name of each ground, and whether its constants were fitted."""
    return tuple(
        Message("{ground}, fitted", ground=ground.name) if ground.fitted else ground.name
        for ground in comparison.grounds
    )


def source_of(comparison: GroundComparison) -> str:
    """Return the combination and its limit state."""
    return Message("{combination} ({state})", combination=Name(comparison.combination), state=comparison.limit_state)


def figure_rows(comparison: GroundComparison) -> list[ComparisonRow]:
    """Return the figures of the plate, and then the differences over all of it."""
    rows = []
    for name, figure in FIGURES.items():
        shown, scale = figure.unit
        unit, factor = unit_in(shown, comparison.model.units)
        of_grounds = tuple(ground.figures[name] * scale * factor for ground in comparison.grounds)
        others = [comparison.difference(ground.name, name) for ground in comparison.grounds[1:]]
        differences = (None, *(None if other is None else 100 * other for other in others))
        rows.append(ComparisonRow(name, figure.label, unit, of_grounds, differences))
    for field in COMPARED_FIELDS:
        label = Message("rms difference of {symbol}", symbol=Name(PLATE_FIELDS[field].symbol))
        values: tuple[float | None, ...] = (None, *(100 * ground.rms[field] for ground in comparison.grounds[1:]))
        rows.append(ComparisonRow(f"rms_{field}", label, "%", values, (None,) * len(comparison.grounds)))
    return rows


def constant_rows(comparison: GroundComparison) -> list[ComparisonRow]:
    """Return the constants of the grounds that have them."""
    rows = []
    for name, unit in CONSTANTS.items():
        shown = in_system(UNITS[unit], comparison.model.units) if unit else None
        scale = 1.0 if shown is None else shown.scale
        values = tuple(
            ground.constants[name] * scale if name in ground.constants else None for ground in comparison.grounds
        )
        rows.append(ComparisonRow(name, name, "" if shown is None else shown.name, values, (None,) * len(values)))
    return [row for row in rows if any(value is not None for value in row.values)]


RMS_NOTE = (
    "rms difference: root of the mean square, over the plate, of the difference to the continuum, in percent of the "
    "continuum's largest value."
)


def notes(comparison: GroundComparison) -> tuple[str, ...]:
    """Return the notes on a comparison."""
    about = Message(
        'Combination "{combination}" ({state}).', combination=Name(comparison.combination), state=comparison.limit_state
    )
    others = tuple(words_in(note, comparison.model.units) for note in comparison.notes)
    return (about, "Differences are those to the continuum, in percent of its value.", RMS_NOTE, *others)


def comparison_table(comparison: GroundComparison) -> Table:
    """Return the comparison as a table of numbers: a column for each ground, then one for each difference."""
    names = [ground.name for ground in comparison.grounds]
    heads = [("quantity", ""), ("unit", ""), *((name, "") for name in names)]
    heads += [(Message("difference of {ground}", ground=name), "%") for name in names[1:]]
    rows = [
        (row.name, row.unit, *row.values, *row.differences[1:])
        for row in (*figure_rows(comparison), *constant_rows(comparison))
    ]
    return table_of("ground_comparison", "Ground models compared", heads, rows, notes(comparison))


def curve_table(comparison: GroundComparison) -> Table:
    """Return the fields along both lines as a table of numbers, a row for each sample."""
    x, y = comparison.place
    fields = {field: PLATE_FIELDS[field] for field in next(iter(comparison.grounds[0].curves.values()))}
    heads = [("line", ""), ("x", "m"), ("y", "m")]
    heads += [
        (Message("{label} on {ground}", label=about.label, ground=ground.name), about.unit)
        for about in fields.values()
        for ground in comparison.grounds
    ]
    rows = []
    for axis, along in comparison.lines.items():
        columns = [ground.curves[axis][field] for field in fields for ground in comparison.grounds]
        scales = [about.scale for about in fields.values() for _ in comparison.grounds]
        for s, *values in zip(along, *columns, strict=True):
            place = (s, y) if axis == "x" else (x, s)
            shown = (None if value is None else value * scale for value, scale in zip(values, scales, strict=True))
            rows.append((Message("along {axis}", axis=axis), *place, *shown))
    title = "Fields along the lines through the largest settlement"
    return in_units(table_of("ground_curves", title, heads, rows), comparison.model.units)
