"""Plans: filled contours of a plate's amounts with all that lies on it, largest and smallest values marked."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from groundslab.accuracy.mesh_statistics import mesh_statistics
from groundslab.messages import Message, quantity
from groundslab.model.axes.drawn import limits_with_axes
from groundslab.model.loads.load_types import presses_ground
from groundslab.results.fields import BAR_FIELDS
from groundslab.views.plots import symbols
from groundslab.views.plots.annotations import draw_labels, draw_title, panel_title, title_height
from groundslab.views.plots.contours import ColorScale, draw_color_bar, draw_contours, triangulation
from groundslab.views.plots.panels import NOT_CERTIFIED, Panel, build_panels, shared_scales
from groundslab.views.plots.style import (
    BASE,
    GREY,
    INK,
    PAGE_HEIGHT,
    PAGE_WIDTH,
    PT,
    WIDE,
    Page,
    batch,
    label_of_axis,
    show_in,
)
from groundslab.views.plots.symbols import load_filter
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.model.loads.load_types import AnyLoad
    from groundslab.model.model import Model
    from groundslab.results.results import CombinationResult
    from groundslab.views.plots.request import PlotRequest

#: Space around the box of a plan [mm]: axis on the left, bar on the right, axis below.
LEFT, RIGHT, BELOW = 13.0, 22.0, 10.5
#: Space on the right of a plan without a bar [mm].
EDGE = 4.0
#: Usual space above it, for two lines of words [mm].
ABOVE = 10.0
#: A plan so high relative to its width, or less, has no other beside it.
FLAT = 0.35
#: About so high are plans side by side, and so wide is a sheet with one upright plan at least [mm].
UPRIGHT, NARROW = 125.0, 110.0
#: Color bar: distance from the box, and width [mm].
GAP, BAR = 2.5, 3.0
#: A plan is not drawn smaller on a page than with this longer side, if fewer on it can be larger [mm].
LEAST = 90.0
#: Space around the box of a map on the left, right, above and below [mm].
MAP_LEFT, MAP_RIGHT, MAP_TOP, MAP_BELOW = 7.0, 14.0, 1.5, 1.5
#: Around the plate, relative to its longer side.
PADDING = 0.02


def draw_panels(
    model: Model, panels: Sequence[Panel], scales: dict[str, ColorScale], columns: int, width: float, rows: int = 1
) -> Figure:
    """Return panels on one sheet of some width [mm], in columns; so small that some rows fit on a page."""
    page = Page(width, words_of(model))
    alike = len({panel.source for panel in panels}) == 1
    certified = all(panel.certified for panel in panels)
    top = page.write_heading(model.title, [panels[0].source] if alike else [], "" if certified else NOT_CERTIFIED)
    ratio = _ratio(model)
    column_width = width / columns
    source_height = 0.0 if alike else 1.3 * BASE * PT
    box_width = min(column_width - LEFT - RIGHT, ((PAGE_HEIGHT - top) / rows - ABOVE - source_height - BELOW) / ratio)
    box_height = box_width * ratio
    legend: dict[str, Any] = {}
    for row in batch(panels, columns):
        heads = [panel_title(panel, model, box_width + RIGHT, with_source=not alike) for panel in row]
        top += max(map(title_height, heads))
        for column, (panel, head) in enumerate(zip(row, heads, strict=True)):
            axes = page.add_axes(column * column_width + LEFT, top, box_width, box_height)
            legend |= draw_panel(axes, model, panel, scales[panel.quantity.name], box_width)
            draw_title(axes, head)
        top += box_height + BELOW
    return page.finish(top, legend)


class MapFrame(NamedTuple):
    """What lies on the plate and the axes around it, without a field, and where [mm]."""

    figure: Figure
    left: float  # of the box, from the left of the figure
    top: float
    width: float
    height: float
    limits: tuple[float, float, float, float]  # x0, x1, y0, y1 [m]


def draw_frame(model: Model, width: float, height: float) -> MapFrame:
    """Return the frame of a map without loads, so small that width and height [mm] hold it."""
    page, ratio = Page(width), _ratio(model)
    box_width = min(width - MAP_LEFT - MAP_RIGHT, (height - MAP_TOP - MAP_BELOW) / ratio)
    axes = page.add_axes(MAP_LEFT, MAP_TOP, box_width, box_width * ratio)
    _draw_case(axes, model, lambda _: False, box_width)
    show_in(page.figure, model.units)
    axes.set(xlabel="", ylabel="", facecolor="none")
    figure = page.finish(MAP_TOP + box_width * ratio + MAP_BELOW, signed=False)
    figure.patch.set_visible(False)
    return MapFrame(figure, MAP_LEFT, MAP_TOP, box_width, box_width * ratio, _limits(model))


def draw_sheet(request: PlotRequest) -> Figure:
    """Return all panels on one sheet, side by side on a page that lies on its side unless they are flat."""
    if request.kind == "mesh":
        return draw_mesh(request.combinations[0].results)
    panels = build_panels(request)
    ratio = _ratio(request.combined.model)
    columns, width = 1, PAGE_WIDTH
    if len(panels) == 1:
        box = (PAGE_HEIGHT - 20 - ABOVE - BELOW) / ratio
        width = min(width, max(LEFT + box + RIGHT, NARROW))
    elif ratio >= FLAT:
        fitting = int(WIDE / (LEFT + RIGHT + min(WIDE / 2 - LEFT - RIGHT, UPRIGHT / ratio)))
        columns = min(len(panels), fitting)
        width = WIDE * columns / fitting
    return draw_panels(request.combined.solved_model, panels, shared_scales(panels), columns, width)


def draw_pages(request: PlotRequest) -> list[Figure]:
    """Return the panels on pages that fit on A4: each combination, or each quantity of an envelope, has its own."""
    if request.kind == "mesh":
        return [draw_mesh(request.combinations[0].results)]
    panels = build_panels(request)
    model = request.combined.solved_model
    scales = shared_scales(panels)
    columns, rows = panels_per_page(_ratio(model))
    groups: dict[str, list[Panel]] = {}
    for panel in panels:
        groups.setdefault(panel.quantity.name if request.envelope else panel.source, []).append(panel)
    parts = [part for group in groups.values() for part in batch(group, columns * rows)]
    return [draw_panels(model, part, scales, min(columns, len(part)), PAGE_WIDTH, rows) for part in parts]


def draw_mesh(results: CombinationResult, *, titled: bool = True) -> Figure:
    """Return a plan of the elements, which all combinations share, with their number, sizes and quality if titled."""
    model, plate = results.solved_model, results.plate
    ratio = _ratio(model)
    width = min(PAGE_WIDTH, max(LEFT + (PAGE_HEIGHT - 20 - ABOVE - BELOW) / ratio + EDGE, NARROW))
    page = Page(width, words_of(model))
    top = 2.0 + (page.write_heading(model.title, describe_mesh(results)) if titled else 0.0)
    box_width = min(width - LEFT - EDGE, (PAGE_HEIGHT - top - BELOW) / ratio)
    axes = page.add_axes(LEFT, top, box_width, box_width * ratio)
    x0, x1, *_ = _limits(model)
    legend = symbols.draw_elements(axes, plate.nodes, plate.elements, box_width / (x1 - x0))
    legend |= _draw_case(axes, model, load_filter(results.factors), box_width)
    return page.finish(top + box_width * ratio + BELOW, legend)


def describe_mesh(results: CombinationResult) -> tuple[str, str]:
    """Return in words how many elements there are, how large and how good."""
    about = mesh_statistics(results)
    sizes = quantity(about.largest, "m", "number")
    if about.largest_place is not None:
        sizes = Message("{smallest:number (m)} to {largest:number m}", smallest=about.smallest, largest=about.largest)
    quality = Message(
        "scaled Jacobian {mean:number} on average, at worst {worst:number}",
        mean=about.mean_quality, worst=about.worst_quality,
    )  # fmt: skip
    if about.worst_place is not None:
        quality += Message(" at {place:place m}", place=about.worst_place)
    return Message("Mesh: {count} elements of {sizes} (root of the area)", count=about.elements, sizes=sizes), quality


def panels_per_page(ratio: float) -> tuple[int, int]:
    """Return how many columns and rows of plans, so high relative to their width, a page of A4 holds."""
    space = PAGE_HEIGHT - 30
    best = 1, 1
    for columns in (1, 2):
        for rows in (1, 2, 3, 4):
            width = min(PAGE_WIDTH / columns - LEFT - RIGHT, (space / rows - ABOVE - BELOW) / ratio)
            if columns * rows > best[0] * best[1] and width * max(1.0, ratio) >= LEAST:
                best = columns, rows
    return best


def _limits(model: Model) -> tuple[float, float, float, float]:
    """Return the limits of a plan, x0, x1, y0, y1 [m]."""
    x0, x1, y0, y1 = model.bounds
    around = PADDING * max(x1 - x0, y1 - y0)
    limits = x0 - around, x1 + around, y0 - around, y1 + around
    return limits_with_axes(limits, model.axes, model.bounds)


def _ratio(model: Model) -> float:
    """Return height by width of a plan."""
    x0, x1, y0, y1 = _limits(model)
    return (y1 - y0) / (x1 - x0)


def draw_panel(axes: Axes, model: Model, panel: Panel, scale: ColorScale, width: float) -> dict[str, Any]:
    """Draw one plan into axes whose box is so wide [mm]; return its entries in the legend."""
    x0, x1, *_ = _limits(model)
    triangles = triangulation(panel.nodes, panel.elements)
    draw_contours(axes, triangles, panel.values, scale)
    hatched = symbols.hatch_uplift(axes, triangles, panel.contact) if panel.quantity.name == "pressure" else {}
    legend = symbols.draw_contact_boundary(axes, triangles, panel.contact) | hatched
    if panel.quantity.name in BAR_FIELDS:
        legend |= symbols.draw_bar_zones(axes, model, panel.quantity.name.split("_", 1)[1])
    if panel.mesh:
        color = INK if scale.parts_at is not None else "white"
        symbols.draw_elements(axes, panel.nodes, panel.elements, width / (x1 - x0), color)
    legend |= _draw_case(axes, model, panel.takes_part, width)
    height = width * _ratio(model)
    draw_color_bar(axes, scale, panel.quantity.label, (1 + GAP / width, 0.0, BAR / width, 1.0), height)
    draw_labels(axes, model, panel, width / (x1 - x0))
    return legend


def _draw_case(axes: Axes, model: Model, takes_part: Callable[[AnyLoad], bool], width: float) -> dict[str, Any]:
    """Draw what lies on the plate, and axes around it, into a box so wide [mm]; return its entries in the legend."""
    from matplotlib.ticker import MaxNLocator

    x0, x1, y0, y1 = _limits(model)
    legend = symbols.draw_plate(axes, model)
    legend |= symbols.draw_voids(axes, model)
    legend |= symbols.draw_columns(axes, model, takes_part) | symbols.draw_walls(axes, model, takes_part)
    legend |= symbols.draw_beams(axes, model) | symbols.draw_building(axes, model)
    symbols.draw_axes(axes, model)
    legend |= symbols.draw_supports(axes, model)
    legend |= symbols.draw_loads(axes, model, lambda load: takes_part(load) and not presses_ground(load))
    axes.set(xlim=(x0, x1), ylim=(y0, y1), aspect="equal")
    for axis, name, low in ((axes.xaxis, "x", x0), (axes.yaxis, "y", y0)):
        axis.set_label_text(label_of_axis(axis, name, low))
        axis.set_major_locator(MaxNLocator(nbins=8 if width > 80 else 5, steps=[1, 2, 2.5, 5, 10]))
    axes.tick_params(which="both", length=2)
    axes.spines[:].set(linewidth=0.4, color=GREY)
    return legend
