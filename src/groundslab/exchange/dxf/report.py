"""The report for people: what was taken, what was ignored, and why."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from groundslab import units
from groundslab.exchange.dxf.drawing import Drawing
from groundslab.schema.wording import printable


def report_text(drawing: Drawing) -> str:
    """Return the report on a drawing: counts per layer, then each entity ignored or taken, with the reason."""
    notes = [line for line in drawing.report if line.entity in {"LAYER", "HEADER"}]
    lines = [line for line in drawing.report if line.entity not in {"LAYER", "HEADER"}]
    counts: dict[str, Counter[bool]] = {}
    for line in lines:
        counts.setdefault(line.layer, Counter())[line.taken] += 1
    outline = drawing.outline
    x0, x1, y0, y1 = outline.bounds
    loads = sum(mark.value or 0.0 for mark in drawing.point_loads)
    text = [
        f"unit: {drawing.unit} ({drawing.scale:.6g} m)",
        f"outline: {x1 - x0:.6g} m x {y1 - y0:.6g} m, {outline.area:.6g} m^2, {len(outline.points)} edges",
        f"openings: {len(drawing.openings)}, zones: {len(drawing.zones)}, columns: {len(drawing.columns)}, "
        f"walls: {len(drawing.walls)}, beams: {len(drawing.beams)}, "
        f"point loads: {len(drawing.point_loads)} (sum {units.show(loads, 'force')})",
        *_distributed_totals(drawing),
        "",
        *_table(
            ("layer", "taken", "ignored"),
            [(layer, str(count[True]), str(count[False])) for layer, count in counts.items()],
        ),
    ]
    if notes:
        text += ["", *(f"{f'layer {printable(note.layer)}' if note.layer else 'header'}: {note.why}" for note in notes)]
    for heading, taken in (("ignored", False), ("taken", True)):
        rows = [(line.layer, line.entity, line.handle, line.why) for line in lines if line.taken is taken]
        if rows:
            text += ["", f"{heading}:", *_table(("layer", "entity", "handle", "why" if not taken else "as"), rows)]
    return "\n".join(text) + "\n"


def _distributed_totals(drawing: Drawing) -> Iterator[str]:
    """Yield the counts of line and area loads with what they come to, if there are any."""
    lines = [(line.value, sum(edge.length for edge in line.segments())) for line in drawing.line_loads]
    areas = [(area.value, area.curve.area - sum(hole.area for hole in area.holes)) for area in drawing.area_loads]
    for what, loads in (("line loads", lines), ("area loads", areas)):
        if loads:
            total = sum((value or 0.0) * size for value, size in loads)
            missing = sum(value is None for value, _ in loads)
            without = f", {missing} without a value" if missing else ""
            yield f"{what}: {len(loads)} (sum {units.show(total, 'force')}{without})"


def _table(heading: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> list[str]:
    """Return the lines of a table, its columns as wide as they need be."""
    cells = [heading, *((*map(printable, row[:-1]), row[-1]) for row in rows)]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return [
        "  " + "  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip() for row in cells
    ]
