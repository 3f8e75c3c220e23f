"""How the iteration went: one table, and of each combination a small drawing."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from groundslab.units import format_number
from groundslab.views.report import svg
from groundslab.views.report.table_layout import MOST_ROWS, Cell, Grid, Head

if TYPE_CHECKING:
    from markupsafe import Markup

    from groundslab.results.record import Step
    from groundslab.views.summary.combinations import Entry

WIDTH, HEIGHT, LEFT, TOP, BOTTOM = 250.0, 118.0, 34.0, 14.0, 24.0
#: Of more combinations than these only the first ones are drawn.
MOST = 12

_HEADS = (
    Head("combination"), Head("unknowns of the mesh", number=True), Head("load increment", number=True),
    Head("gamma", number=True), Head("contact iteration", number=True), Head("nodes in contact", number=True),
    Head("nodes changed", number=True), Head(""),
)  # fmt: skip


def history(found: Sequence[Entry]) -> Grid:
    """Return all steps of all combinations that have results."""
    rows = [
        (
            Cell(entry.combination.name),
            Cell(str(step.unknowns), "number"),
            Cell(str(step.increment), "number"),
            Cell("-" if step.gamma is None else format_number(step.gamma), "number"),
            Cell(str(step.iteration), "number"),
            Cell(str(step.in_contact), "number"),
            Cell(str(step.changed), "number"),
            Cell("*" if step.finest else ""),
        )
        for entry in found
        if entry.results is not None
        for step in entry.results.steps
    ]
    return Grid("", _HEADS, tuple(rows), ("* on the mesh that was asked for.",), folded=len(rows) > MOST_ROWS)


def history_drawing(steps: Sequence[Step]) -> Markup:
    """Return the number of nodes that change sides in each step, full marks on the mesh that was asked for."""
    most = max((step.changed for step in steps), default=0)
    across = (WIDTH - LEFT - 10) / max(len(steps) - 1, 1)
    high = HEIGHT - TOP - BOTTOM

    def at(n: int, changed: int) -> tuple[float, float]:
        return LEFT + 4 + across * n, TOP + high * (1 - math.log1p(changed) / max(math.log1p(most), 1.0))

    points = [at(n, step.changed) for n, step in enumerate(steps)]
    return svg.drawing(
        WIDTH,
        HEIGHT,
        "Nodes that change sides in each step",
        *_axes(most, at(0, 0)[1], at(0, most)[1], len(steps)),
        *([svg.path(points, "d-curve")] if len(points) > 1 else []),
        *(
            svg.element("circle", cx=x, cy=y, r=3.0, class_="d-step" if step.finest else "d-step-coarse")
            for (x, y), step in zip(points, steps, strict=True)
        ),
    )


def _axes(most: int, zero: float, top: float, count: int) -> Iterator[Markup]:
    """Yield both axes with their ends."""
    yield svg.line((LEFT, TOP - 4), (LEFT, zero), "d-thin")
    yield svg.line((LEFT, zero), (WIDTH - 4, zero), "d-thin")
    yield svg.text((LEFT - 4, zero + 4), "0", "d-text d-muted", "end")
    if most:
        yield svg.text((LEFT - 4, top + 4), str(most), "d-text d-muted", "end")
    yield svg.text((LEFT + 4, HEIGHT - 8), "1", "d-text d-muted", "middle")
    yield svg.text((WIDTH - 6, HEIGHT - 8), f"step {count}", "d-text d-muted", "end")
