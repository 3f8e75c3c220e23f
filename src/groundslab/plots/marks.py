"""Marks on a plan: border of contact, loads, columns, supports; each gives its entries in the legend."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.readings import contact_function

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.tri import Triangulation

    from groundslab.results import Results

INK, LIFTED, LOAD, SUPPORT = "black", "0.45", "#d81b60", "#1b7f3b"


def contact_boundary(axes: Axes, triangles: Triangulation, results: Results) -> dict[str, Any]:
    """Draw the line between contact and gap, if there is one; return its entry in the legend."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch
    from matplotlib.patheffects import withStroke

    if results.plate.in_contact.all():
        return {}
    line = axes.tricontour(triangles, contact_function(results), levels=[0.0], colors=INK, linewidths=1.8)
    line.set(path_effects=[withStroke(linewidth=3.6, foreground="white")])
    return {
        "contact boundary": Line2D([], [], color=INK, linewidth=1.8),
        "no contact": Patch(facecolor="white", edgecolor=LIFTED, hatch="////", linewidth=0.0),
    }


def loads(axes: Axes, results: Results) -> dict[str, Any]:
    """Outline the loaded areas and mark the point loads that take part; return their entries in the legend."""
    from matplotlib.patches import Polygon

    entries: dict[str, Any] = {}
    plate = results.model.plate
    chord = 1e-3 * max(plate.sides)
    factors = dict(results.factors)
    for given in results.model.loads:
        if factors and not factors.get(given.case):
            continue
        load = given.on(results.model.columns) if given.kind == "point" else given
        if load.kind == "point" and load.x is not None and load.y is not None:
            (mark,) = axes.plot(load.x, load.y, "v", color=LOAD, markeredgecolor="white", markersize=9, clip_on=False)
            mark.set_linestyle("none")
            entries["point load"] = mark
        elif load.kind == "line":
            (entries["line load"],) = axes.plot(
                *zip(*load.points, strict=True), color=LOAD, linewidth=2.4, clip_on=False
            )
        elif load.kind == "uniform" or load.kind == "patch" or load.kind == "area":
            around = plate.ring().flat(chord) if load.kind == "uniform" else load.drawn(chord).exterior.coords
            outline = Polygon(np.array(around), fill=False, edgecolor=LOAD, linewidth=1.8)
            outline.set(linestyle=(0, (4, 2)), clip_on=False, zorder=3)
            axes.add_patch(outline)
            entries["loaded area"] = outline
    return entries


def columns(axes: Axes, results: Results) -> dict[str, Any]:
    """Outline the columns; return their entry in the legend."""
    from matplotlib.patches import Polygon

    entries: dict[str, Any] = {}
    chord = 1e-3 * max(results.model.plate.sides)
    for column in results.model.columns:
        around = np.array(column.ring().flat(chord))
        outline = Polygon(around, fill=False, edgecolor=INK, linewidth=1.2, zorder=3)
        outline.set(clip_on=False)
        axes.add_patch(outline)
        entries["column"] = outline
    return entries


def supports(axes: Axes, results: Results) -> dict[str, Any]:
    """Mark supports at points by triangles and those along lines by thick lines; return their entries in the legend."""
    from matplotlib.patheffects import withStroke

    entries: dict[str, Any] = {}
    for support in results.model.supports:
        if support.kind == "point":
            (mark,) = axes.plot(support.x, support.y, "^", color=SUPPORT, markeredgecolor="white", markersize=9)
            mark.set(linestyle="none", clip_on=False)
            entries["support"] = mark
        else:
            (line,) = axes.plot(*zip(*support.points, strict=True), color=SUPPORT, linewidth=4.0, clip_on=False)
            line.set(path_effects=[withStroke(linewidth=6.0, foreground="white")])
            entries["line support"] = line
    return entries
