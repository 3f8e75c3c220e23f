"""Plans: filled contours of a plate's amounts with all that lies on it, largest and smallest values marked."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from groundslab.views.plots import symbols
from groundslab.views.plots.contours import bar, fill, triangulation
from groundslab.views.plots.heads import head_of, room_above, write_above
from groundslab.views.plots.labels import label
from groundslab.views.plots.panels import NOT_CERTIFIED, View, scales_of, views_of
from groundslab.views.plots.paper import PAGE_HEIGHT, PAGE_WIDTH, WIDE, Paper
from groundslab.views.plots.scale import Scale
from groundslab.views.plots.style import BASE, GREY, PT

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.model.model import Model
    from groundslab.views.plots.request import Wish

#: Room around the box of a plan [mm]: axis on the left, bar on the right, axis below.
LEFT, RIGHT, BELOW = 13.0, 22.0, 10.5
#: Usual room above it, for two lines of words [mm].
ABOVE = 10.0
#: A plan so high relative to its width, or less, has no other beside it.
FLAT = 0.35
#: About so high are plans side by side, and so wide is a sheet with one upright plan at least [mm].
UPRIGHT, NARROW = 125.0, 110.0
#: Colour bar: distance from the box, and width [mm].
GAP, BAR = 2.5, 3.0
#: A plan is not drawn smaller on a page than with this longer side, if fewer on it can be larger [mm].
LEAST = 90.0
#: Around the plate, relative to its longer side.
PADDING = 0.02


def figure_of(
    model: Model, views: Sequence[View], scales: dict[str, Scale], columns: int, width: float, rows: int = 1
) -> Figure:
    """Return panels on one sheet of some width [mm], in columns; so small that some rows have room on a page."""
    paper = Paper(width)
    alike = len({view.of for view in views}) == 1
    certified = all(view.certified for view in views)
    top = paper.head(model.title, [views[0].of] if alike else [], "" if certified else NOT_CERTIFIED)
    ratio = _ratio(model)
    each = width / columns
    tell = 0.0 if alike else 1.3 * BASE * PT
    box_width = min(each - LEFT - RIGHT, ((PAGE_HEIGHT - top) / rows - ABOVE - tell - BELOW) / ratio)
    box_height = box_width * ratio
    legend: dict[str, Any] = {}
    for first in range(0, len(views), columns):
        row = views[first : first + columns]
        heads = [head_of(view, box_width + RIGHT, tell=not alike) for view in row]
        top += max(map(room_above, heads))
        for column, (view, head) in enumerate(zip(row, heads, strict=True)):
            axes = paper.axes(column * each + LEFT, top, box_width, box_height)
            legend |= panel(axes, model, view, scales[view.amount.name], box_width)
            write_above(axes, head)
        top += box_height + BELOW
    return paper.finish(top, legend)


def sheet(wish: Wish) -> Figure:
    """Return all panels on one sheet, side by side on a page that lies on its side unless they are flat."""
    views = views_of(wish)
    ratio = _ratio(wish.combined.model)
    columns, width = 1, PAGE_WIDTH
    if len(views) == 1:
        box = (PAGE_HEIGHT - 20 - ABOVE - BELOW) / ratio
        width = min(width, max(LEFT + box + RIGHT, NARROW))
    elif ratio >= FLAT:
        fitting = int(WIDE / (LEFT + RIGHT + min(WIDE / 2 - LEFT - RIGHT, UPRIGHT / ratio)))
        columns = min(len(views), fitting)
        width = WIDE * columns / fitting
    return figure_of(wish.combined.model, views, scales_of(views), columns, width)


def pages(wish: Wish) -> list[Figure]:
    """Return the panels on pages that fit on A4: each combination, or each amount of an envelope, has its own."""
    views = views_of(wish)
    model, scales = wish.combined.model, scales_of(views)
    columns, rows = per_page(_ratio(model))
    found = []
    groups: dict[str, list[View]] = {}
    for view in views:
        groups.setdefault(view.amount.name if wish.envelope else view.of, []).append(view)
    for own in groups.values():
        for first in range(0, len(own), columns * rows):
            part = own[first : first + columns * rows]
            found.append(figure_of(model, part, scales, min(columns, len(part)), PAGE_WIDTH, rows))
    return found


def per_page(ratio: float) -> tuple[int, int]:
    """Return how many columns and rows of plans, so high relative to their width, a page of A4 holds."""
    room = PAGE_HEIGHT - 30
    best = 1, 1
    for columns in (1, 2):
        for rows in (1, 2, 3, 4):
            width = min(PAGE_WIDTH / columns - LEFT - RIGHT, (room / rows - ABOVE - BELOW) / ratio)
            if columns * rows > best[0] * best[1] and width * max(1.0, ratio) >= LEAST:
                best = columns, rows
    return best


def _limits(model: Model) -> tuple[float, float, float, float]:
    """Return what a plan shows, x0, x1, y0, y1 [m]."""
    x0, x1, y0, y1 = model.plate.bounds
    around = PADDING * max(x1 - x0, y1 - y0)
    return x0 - around, x1 + around, y0 - around, y1 + around


def _ratio(model: Model) -> float:
    """Return height by width of a plan."""
    x0, x1, y0, y1 = _limits(model)
    return (y1 - y0) / (x1 - x0)


def panel(axes: Axes, model: Model, view: View, scale: Scale, width: float) -> dict[str, Any]:
    """Draw one plan into axes whose box is so wide [mm]; return its entries in the legend."""
    from matplotlib.ticker import MaxNLocator

    x0, x1, y0, y1 = _limits(model)
    triangles = triangulation(view.nodes, view.elements)
    fill(axes, triangles, view.values, scale)
    legend: dict[str, Any] = {}
    if view.amount.name == "pressure":
        legend |= symbols.lifted(axes, triangles, view.contact)
    legend = symbols.contact_boundary(axes, triangles, view.contact) | legend
    legend |= symbols.plate(axes, model)
    legend |= symbols.voids(axes, model)
    legend |= symbols.columns(axes, model, view.takes_part)
    legend |= symbols.supports(axes, model)
    legend |= symbols.loads(axes, model, view.takes_part)
    axes.set(xlim=(x0, x1), ylim=(y0, y1), aspect="equal", xlabel="x [m]", ylabel="y [m]")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(nbins=8 if width > 80 else 5, steps=[1, 2, 2.5, 5, 10]))
    axes.tick_params(which="both", length=2)
    for spine in axes.spines.values():
        spine.set(linewidth=0.4, color=GREY)
    height = width * _ratio(model)
    bar(axes, scale, view.amount.label, (1 + GAP / width, 0.0, BAR / width, 1.0), height)
    label(axes, model, view, width / (x1 - x0))
    return legend
