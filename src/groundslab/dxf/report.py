"""The report for people: what was taken, what was ignored, and why."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from groundslab import units
from groundslab.dxf.curves import Curve, Point, edges_of
from groundslab.dxf.drawing import Drawing, ReportLine
from groundslab.dxf.words import safe


def report_text(drawing: Drawing) -> str:
    """Return what was taken and what was ignored, and why, for people: counts per layer first."""
    notes = [line for line in drawing.report if line.entity in {"LAYER", "HEADER"}]
    lines = [line for line in drawing.report if line not in notes]
    counts = {layer: Counter(line.taken for line in lines if line.layer == layer) for layer in _layers_of(lines)}
    width, depth = (max(values) - min(values) for values in zip(*_reach(drawing.outline), strict=True))
    loads = sum(mark.value or 0.0 for mark in drawing.point_loads)
    text = [
        f"unit: {drawing.unit} ({drawing.scale:.6g} m)",
        f"outline: {width:.6g} m x {depth:.6g} m, {drawing.outline.area:.6g} m^2, {len(drawing.outline.points)} edges",
        f"openings: {len(drawing.openings)}, zones: {len(drawing.zones)}, columns: {len(drawing.columns)}, "
        f"point loads: {len(drawing.point_loads)} (sum {units.show(loads, 'force')})",
        "",
        *_table(
            ("layer", "taken", "ignored"),
            [(layer, str(count[True]), str(count[False])) for layer, count in counts.items()],
        ),
    ]
    if notes:
        text += ["", *(f"{f'layer {safe(note.layer)}' if note.layer else 'header'}: {note.why}" for note in notes)]
    for heading, taken in (("ignored", False), ("taken", True)):
        rows = [(line.layer, line.entity, line.handle, line.why) for line in lines if line.taken is taken]
        if rows:
            text += ["", f"{heading}:", *_table(("layer", "entity", "handle", "why" if not taken else "as"), rows)]
    return "\n".join(text) + "\n"


def _layers_of(lines: Iterable[ReportLine]) -> list[str]:
    return list(dict.fromkeys(line.layer for line in lines))


def _reach(curve: Curve) -> list[Point]:
    """Return points that reach as far as a curve does, arcs included."""
    points = list(curve.points)
    for edge in edges_of(curve):
        if edge.bulge:
            (x, y), r = edge.circle()
            far = [(x + r, y), (x - r, y), (x, y + r), (x, y - r)]
            points += [point for point in far if edge.side(point) * edge.bulge < 0]
    return points


def _table(heading: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> list[str]:
    """Return the lines of a table, its columns as wide as they need be."""
    cells = [heading, *((*map(safe, row[:-1]), row[-1]) for row in rows)]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return [
        "  " + "  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip() for row in cells
    ]
