"""A picture of a result in plan: settlement and contact pressure, with contact boundary, loads and what bears."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab import __version__
from groundslab.results import PLATE_FIELDS
from groundslab.views.summary import edge_carries_line_force, goes_below_zero, require_finite

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.tri import Triangulation

    from groundslab.results import Array, Integers, Results

#: The eight triangles of a nine-node quadrilateral: all meet in its centre, two along each side.
TRIANGLES = np.array(
    [[0, 4, 8], [4, 1, 8], [1, 5, 8], [5, 2, 8], [2, 6, 8], [6, 3, 8], [3, 7, 8], [7, 0, 8]]
)  # fmt: skip
INK, LIFTED, OVER, LOAD, SUPPORT = "black", "0.45", "#b30000", "#d81b60", "#1b7f3b"


def write(results: Results, path: Path) -> None:
    """Write the picture as a PNG file."""
    draw(results).savefig(path, format="png", metadata={"Software": f"groundslab {__version__}"})


def draw(results: Results) -> Figure:
    """Return the picture as a Matplotlib figure that needs no display."""
    from matplotlib.figure import Figure
    from matplotlib.tri import Triangulation

    require_finite(results)
    plate = results.plate
    width, height = np.ptp(plate.nodes, axis=0)
    wide = width > 1.6 * height
    size = (8.5, 2.0 + 2 * min(7.0 * height / width, 4.0)) if wide else (12.0, 1.7 + min(4.3 * height / width, 9.0))
    figure = Figure(figsize=size, dpi=150, layout="constrained")
    rows, columns = (2, 1) if wide else (1, 2)
    panels = figure.subplots(rows, columns, sharex=True, sharey=True)
    triangles = Triangulation(plate.nodes[:, 0], plate.nodes[:, 1], triangulate(plate.elements))
    _settlement(panels[0], triangles, results)
    above = _pressure(panels[1], triangles, results)
    legend: dict[str, Any] = {}
    for axes in panels:
        legend |= _contact_boundary(axes, triangles, results)
        legend |= _loads(axes, results)
        legend |= _columns(axes, results)
        legend |= _supports(axes, results)
        axes.set_aspect("equal")
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
    legend |= above
    titles = [results.model.title, results.combination if results.model.cases else ""]
    if any(titles):
        # A title is free text: a dollar sign in it is no formula.
        figure.suptitle("\n".join(filter(None, titles)), parse_math=False, wrap=True)
    if legend:
        figure.legend(legend.values(), legend.keys(), loc="outside lower center", ncols=5, frameon=False)
    return figure


def triangulate(elements: Integers) -> Integers:
    """Return the triangles (8 m, 3) that split nine-node quadrilaterals (m, 9) and use every node."""
    return elements[:, TRIANGLES].reshape(-1, 3)


def contact_function(results: Results) -> Array:
    """Return a field (n,) that is negative at nodes in contact, positive elsewhere, zero on the boundary.

    Without shear in the ground it is k0 g - p, with k0 of all layers in series: on Winkler ground it crosses
    zero linearly. With shear the pressure jumps to zero at the boundary and the gap grows as the square of the
    distance, so its root stands for the distance on the open side, and half a usual first step on the other.
    """
    plate = results.plate
    closed = plate.in_contact
    if any(k1 > 0 for k1 in results.constants.k1):
        outside = np.sqrt(np.maximum(plate.gap, 0.0))
        mixed = closed[plate.elements].any(axis=1) & ~closed[plate.elements].all(axis=1)
        front = np.setdiff1d(plate.elements[mixed], np.flatnonzero(closed))
        inside = np.full(len(closed), np.median(outside[front]) / 2 if len(front) else 1.0)
    else:
        stiffness = 1 / sum(1 / k0 for k0 in results.constants.k0)
        outside, inside = stiffness * plate.gap, plate.pressure
    small = 1e-9 * max(float(np.abs(outside).max()), float(np.abs(inside).max()), 1e-300)
    return np.where(closed, -np.maximum(inside, small), np.maximum(outside, small))


def _settlement(axes: Axes, triangles: Triangulation, results: Results) -> None:
    """Draw the settlement; where the plate lifts, the colours part at zero."""
    field = PLATE_FIELDS["settlement"]
    values = results.plate.settlement * field.scale
    _filled(axes, triangles, values, (values.min(), values.max()), f"{field.symbol} [{field.unit}]")
    low = f"uplift {-values.min():.4g}" if goes_below_zero(values) else f"smallest {values.min():.4g}"
    axes.set_title(f"Settlement: largest {values.max():.4g} {field.unit}, {low} {field.unit}", fontsize="medium")


def _pressure(axes: Axes, triangles: Triangulation, results: Results) -> dict[str, Any]:
    """Draw the contact pressure; edge nodes that also hold a line force do not stretch the scale.

    Returns the entry in the legend for what lies above the scale, if anything does.
    """
    from matplotlib.patches import Patch

    field, plate = PLATE_FIELDS["pressure"], results.plate
    values = plate.pressure * field.scale
    line_force = edge_carries_line_force(results)
    inside = values[~plate.on_edge] if line_force else values
    span = (values.min() if goes_below_zero(values) else 0.0, inside.max())
    above = bool(values.max() > span[1] * (1 + 1e-9))
    _filled(axes, triangles, values, span, f"{field.symbol} [{field.unit}]", above=above)
    if not plate.in_contact.all():
        lifted = axes.tricontourf(triangles, contact_function(results), levels=[0.0, np.inf], colors=["white"])
        lifted.set(hatch="////", edgecolor=LIFTED, linewidth=0.0)
    share = 100 * plate.area[plate.in_contact].sum() / plate.area.sum()
    where = " inside" if line_force else ""
    axes.set_title(
        f"Pressure: largest{where} {inside.max():.4g} {field.unit}; {share:.4g} % of the plate in contact",
        fontsize="medium",
    )
    return {"above the scale (edge line force)": Patch(color=OVER)} if above else {}


def _filled(
    axes: Axes,
    triangles: Triangulation,
    values: Array,
    span: tuple[float, float],
    label: str,
    *,
    above: bool = False,
) -> None:
    """Draw filled contours with a colour bar; colours are centred on zero if the span crosses it."""
    from matplotlib import colormaps
    from matplotlib.colors import CenteredNorm, Normalize
    from matplotlib.ticker import MaxNLocator

    low, high = span
    if high - low <= 1e-12 * max(abs(low), abs(high), 1e-300):
        low, high = low - 0.5 * abs(low) - 1e-12, high + 0.5 * abs(high) + 1e-12
    levels = np.asarray(MaxNLocator(nbins=14, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high))
    if above:
        # The scale ends at the largest value inside, not at the next round number.
        levels = np.append(levels[levels < high], high)
    norm: Normalize
    if goes_below_zero(values):
        colours, norm = colormaps["RdBu"], CenteredNorm(0.0, float(np.abs(levels).max()))
    else:
        colours, norm = colormaps["viridis"], Normalize(float(levels[0]), float(levels[-1]))
    if above:
        colours = colours.with_extremes(over=OVER)
    drawn = axes.tricontourf(
        triangles, values, levels=levels, cmap=colours, norm=norm, extend="max" if above else "neither"
    )
    # Beside the panel in its own coordinates, so that the bar is as high as the plate.
    figure = axes.get_figure(root=True)
    assert figure is not None
    length, height = np.ptp(triangles.x), np.ptp(triangles.y)
    every = 1 if height > 0.4 * length else 2
    first = int(np.argmin(np.abs(levels))) % every
    bar = axes.inset_axes((1.03, 0.0, 0.04, 1.0))
    figure.colorbar(drawn, cax=bar, label=label, ticks=levels[first::every])


def _contact_boundary(axes: Axes, triangles: Triangulation, results: Results) -> dict[str, Any]:
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


def _loads(axes: Axes, results: Results) -> dict[str, Any]:
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


def _columns(axes: Axes, results: Results) -> dict[str, Any]:
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


def _supports(axes: Axes, results: Results) -> dict[str, Any]:
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
