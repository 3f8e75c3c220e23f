"""The deformed plate in space: settlements exaggerated, colored by any quantity, with the level that it came from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.fem.mesh import Mesh, interpolate, locate_nearest
from groundslab.fem.shape_functions import q9_values
from groundslab.geometry.plan import DRAWN_CHORD
from groundslab.messages import Message, capitalized, joined, quantity
from groundslab.unit_systems import in_system
from groundslab.units import UNITS
from groundslab.views.plots.annotations import draw_title, panel_title, title_height
from groundslab.views.plots.contours import draw_color_bar, triangulation
from groundslab.views.plots.panels import NOT_CERTIFIED, Panel, build_panel, shared_scales
from groundslab.views.plots.style import (
    GREY,
    INK,
    PAGE_HEIGHT,
    PAGE_WIDTH,
    PT,
    SMALL,
    WIDE,
    Page,
    batch,
    label_of_axis,
)
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from groundslab.arrays import Array, Integers
    from groundslab.model.model import Model
    from groundslab.views.plots.contours import ColorScale
    from groundslab.views.plots.request import PlotRequest

#: The largest settlement or uplift is drawn about so large, relative to the plate's longer side.
DEPTH = 0.14
#: Facets that look smooth; each element is cut into so many that there are about as many, but at least 2 x 2.
FACETS = 16_000
#: With more elements than this their sides are drawn only if they are asked for, as pixels.
MOST_SIDES = 1_200
#: From tick to tick along x and y at least [mm].
TICK = 13.0
#: From where one looks [degrees].
ELEVATION, AZIMUTH = 28.0, -62.0
#: Space on the right of a panel, for the bar [mm].
RIGHT = 36.0
#: How much of the box the plate may take, the rest being left for the words at the axes.
PART_WIDE, PART_HIGH = 0.82, 0.74
#: Light from the upper left, and how much of the color a face turned away from it keeps.
LIGHT, SHADE = np.array([-0.35, -0.45, 0.82]), 0.55


@dataclass(frozen=True, slots=True)
class Surface:
    """A panel, and the settlement that shapes it [m]."""

    panel: Panel
    settlement: Array  # (n,)


def draw_sheet(request: PlotRequest) -> Figure:
    """Return all panels on one sheet."""
    surfaces = _surfaces(request)
    columns, width = (1, PAGE_WIDTH) if len(surfaces) == 1 else (2, WIDE)
    return _figure(request.combined.model, surfaces, surfaces, columns, width)


def draw_pages(request: PlotRequest) -> list[Figure]:
    """Return the panels on pages, two on each, a combination never on the page of another."""
    surfaces = _surfaces(request)
    groups: dict[str, list[Surface]] = {}
    for surface in surfaces:
        groups.setdefault(surface.panel.source, []).append(surface)
    pages = [part for group in groups.values() for part in batch(group, 2)]
    return [_figure(request.combined.model, part, surfaces, 1, PAGE_WIDTH) for part in pages]


def _surfaces(request: PlotRequest) -> list[Surface]:
    return [
        Surface(
            build_panel(quantity, combination, request.names_combinations, request.mesh),
            combination.results.plate.settlement,
        )
        for combination in request.combinations
        for quantity in request.quantities
    ]


def find_exaggeration(settlements: Sequence[Array], longest: float) -> float:
    """Return by what settlements [m] are multiplied to be seen beside a length [m]: 1, 2 or 5 times a power of ten."""
    largest = max(float(np.abs(settlement).max()) for settlement in settlements)
    if largest == 0.0:
        return 1.0
    wanted = DEPTH * longest / largest
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(max(step * power for step in (1, 2, 5) if step * power <= wanted * (1 + 1e-9)))


def _figure(model: Model, surfaces: Sequence[Surface], among: Sequence[Surface], columns: int, width: float) -> Figure:
    """Return some panels on one sheet of some width [mm], in columns, with one exaggeration and the scales of all."""
    page = Page(width, words_of(model))
    scales = shared_scales([surface.panel for surface in among])
    panels = [surface.panel for surface in surfaces]
    alike = len({panel.source for panel in panels}) == 1
    factor = find_exaggeration([surface.settlement for surface in surfaces], max(model.sides))
    caption: str = Message(
        "deformed plate, settlements exaggerated {factor:number} times; dashed: level before loading", factor=factor
    )
    source = panels[0].source
    lines = [joined((source, caption), ": ") if alike and source else capitalized(caption)]
    top = page.write_heading(model.title, lines, "" if all(panel.certified for panel in panels) else NOT_CERTIFIED)
    column_width = width / columns
    box_width = column_width - RIGHT - 4
    wide, high = _projected_size(_sides(model, [surface.settlement for surface in surfaces], factor)[0])
    box_height = min(PART_WIDE * box_width / wide * high / PART_HIGH, PAGE_HEIGHT / 2 - 35)
    legend: dict[str, Any] = {}
    for row in batch(surfaces, columns):
        heads = [panel_title(surface.panel, model, box_width + RIGHT, with_source=not alike) for surface in row]
        top += max(map(title_height, heads))
        for column, (surface, head) in enumerate(zip(row, heads, strict=True)):
            left = column * column_width + 4
            frame = page.add_axes(left, top, box_width, box_height)
            frame.set_axis_off()
            draw_title(frame, head)
            axes: Any = page.add_axes(left, top, box_width, box_height, projection="3d")
            scale = scales[surface.panel.quantity.name]
            legend |= _draw_surface(axes, model, surface, scale, factor, (box_width, box_height))
            place = (1 + 12 / box_width, 0.1, 3 / box_width, 0.8)
            draw_color_bar(frame, scale, surface.panel.quantity.label, place, 0.8 * box_height)
        top += box_height + 3
    return page.finish(top, legend)


def facets(nodes: Array, elements: Integers, values: Sequence[Array], parts: int) -> tuple[Array, list[Array]]:
    """Return elements cut into parts x parts facets, by their shape functions.

    Corners (f, 4, 2) of the facets in plan, and of each field (n,) the values at them (f, 4).
    """
    t = np.linspace(-1, 1, parts + 1)
    xi = np.column_stack([np.tile(t, parts + 1), np.repeat(t, parts + 1)])
    N = q9_values(xi)
    first = (np.arange(parts)[:, None] * (parts + 1) + np.arange(parts)).ravel()
    corner = first[:, None] + np.array([0, 1, parts + 2, parts + 1])

    def at_corners(field: Array) -> Array:
        values: Array = np.einsum("pa,ea...->ep...", N, field[elements])
        return values[:, corner].reshape(-1, 4, *field.shape[1:])

    return at_corners(nodes), [at_corners(value) for value in values]


def _draw_surface(
    axes: Any, model: Model, surface: Surface, scale: ColorScale, factor: float, box: tuple[float, float]
) -> dict[str, Any]:
    """Draw a deformed plate into axes in space; return the entries in the legend."""
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    panel = surface.panel
    parts = max(2, round(np.sqrt(FACETS / len(panel.elements))))
    xy, (w, values) = facets(panel.nodes, panel.elements, [surface.settlement, panel.values], parts)
    corners = np.concatenate([xy, -factor * w[..., None]], axis=2)
    colors = scale.colors_at(values.mean(axis=1))
    colors[:, :3] *= _brightness(corners)[:, None]
    axes.computed_zorder = False
    drawn = Poly3DCollection(corners, facecolors=colors, edgecolors=colors, linewidths=0.2, zorder=2, clip_on=False)
    drawn.set_rasterized(True)  # so many facets are smaller as pixels
    axes.add_collection3d(drawn)
    few = len(panel.elements) <= MOST_SIDES
    if panel.mesh or few:
        ring = panel.elements[:, [0, 4, 1, 5, 2, 6, 3, 7, 0]]
        sides = np.concatenate([panel.nodes[ring], -factor * surface.settlement[ring][..., None]], axis=2)
        lines = Line3DCollection(sides, colors=INK, linewidths=0.15, alpha=0.5, zorder=3, clip_on=False)
        lines.set_rasterized(not few)
        axes.add_collection3d(lines)
    entries = _draw_contact_border(axes, surface, factor)
    chord = DRAWN_CHORD * max(model.sides)
    for ring_ in (curve for plate in model.every_plate for curve in plate.rings()):
        flat = ring_.flat(chord)
        x, y = np.vstack([flat, flat[:1]]).T
        (line,) = axes.plot(x, y, np.zeros(len(x)), color=GREY, linewidth=0.7, linestyle=(0, (5, 3)), zorder=4)
        line.set_clip_on(False)
        entries["level before loading"] = line
    _set_axes(axes, model, surface.settlement, factor, box)
    return entries


def _brightness(corners: Array) -> Array:
    """Return how bright facets (f, 4, 3) are by their slope against the light, (f,)."""
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    light = LIGHT / np.linalg.norm(LIGHT)
    level = light[2]
    brightness: Array = np.clip(1 + (1 - SHADE) * (normal @ light - level) / level, SHADE, 1.0)
    return brightness


def _draw_contact_border(axes: Any, surface: Surface, factor: float) -> dict[str, Any]:
    """Draw the border of contact on the deformed plate."""
    from matplotlib.figure import Figure

    contact = surface.panel.contact
    if contact is None or not (contact > 0).any() or not (contact < 0).any():
        return {}
    triangles = triangulation(surface.panel.nodes, surface.panel.elements)
    mesh = Mesh(surface.panel.nodes, surface.panel.elements)
    entries = {}
    border = Figure().add_subplot().tricontour(triangles, contact, levels=[0.0])
    for path in border.get_paths():
        for places in path.to_polygons(closed_only=False):
            w = interpolate(mesh, surface.settlement, locate_nearest(mesh, np.asarray(places)))
            (line,) = axes.plot(*np.asarray(places).T, -factor * w, color=INK, linewidth=1.2, zorder=5, clip_on=False)
            entries["contact boundary"] = line
    return entries


def _projected_size(sides: tuple[float, float, float]) -> tuple[float, float]:
    """Return width and height of a brick of some sides, as it is seen."""
    x, y, z = sides
    up, turn = np.radians([ELEVATION, AZIMUTH])
    wide = x * abs(np.sin(turn)) + y * abs(np.cos(turn))
    high = (x * abs(np.cos(turn)) + y * abs(np.sin(turn))) * np.sin(up) + z * np.cos(up)
    return float(wide), float(high)


def _zoom(sides: tuple[float, float, float], width: float, height: float) -> float:
    """Return the zoom with which a brick of some sides fills a box [mm].

    Without zoom Matplotlib draws the brick's diagonal about as long as the box's shorter side.
    """
    wide, high = (side / float(np.linalg.norm(sides)) * min(width, height) for side in _projected_size(sides))
    return min(PART_WIDE * width / wide, PART_HIGH * height / high)


def _sides(model: Model, settlements: Sequence[Array], factor: float) -> tuple[tuple[float, float, float], float]:
    """Return the sides of the brick around deformed plates, and how far down it begins [m]."""
    x, y = model.sides
    low = min(0.0, *(-factor * float(settlement.max()) for settlement in settlements))
    high = max(0.0, *(-factor * float(settlement.min()) for settlement in settlements))
    if high - low <= 0.02 * max(x, y):
        low, high = low - 0.05 * max(x, y), high + 0.05 * max(x, y)
    return (x, y, high - low), low


def _set_axes(axes: Any, model: Model, settlement: Array, factor: float, box: tuple[float, float]) -> None:
    """Give axes in space their limits, equal in all directions, and their words."""
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    x0, x1, y0, y1 = model.bounds
    sides, low = _sides(model, [settlement], factor)
    high = low + sides[2]
    axes.set(xlim=(x0, x1), ylim=(y0, y1), zlim=(low, high))
    axes.set_box_aspect(sides, zoom=_zoom(sides, *box))
    axes.set_proj_type("ortho")
    axes.view_init(elev=ELEVATION, azim=AZIMUTH)
    steps = [1, 2, 2.5, 5, 10]
    per_meter = PART_WIDE * box[0] / _projected_size(sides)[0]
    for axis, side in ((axes.xaxis, sides[0]), (axes.yaxis, sides[1])):
        axis.set_major_locator(MaxNLocator(nbins=max(1, min(8, int(side * per_meter / TICK))), steps=steps))
    # labels as far apart as they are high, and a half more
    space = per_meter * sides[2] * np.cos(np.radians(ELEVATION)) / (1.5 * SMALL * PT)
    unit = in_system(UNITS["mm"], model.units)
    locator, scale = MaxNLocator(nbins=max(1, min(5, int(space))), steps=steps), -unit.scale / factor
    heights = [tick / scale for tick in locator.tick_values(high * scale, low * scale)]
    axes.set_zticks([z for z in heights if low - 1e-9 <= z <= high + 1e-9])
    axes.zaxis.set_major_formatter(FuncFormatter(lambda z, _: quantity(round(z * scale, 9), unit.name, "number")))
    axes.set_xlabel(label_of_axis(axes.xaxis, "x", x0), labelpad=3)
    axes.set_ylabel(label_of_axis(axes.yaxis, "y", y0), labelpad=3)
    axes.patch.set_alpha(0.0)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.set_pane_color((1.0, 1.0, 1.0, 0.0))
        axis.line.set_linewidth(0.5)
        axis.set_tick_params(pad=3 if axis is axes.zaxis else -1)
        axis._axinfo["grid"].update({"color": "#d8d8d8", "linewidth": 0.4})
