"""The ground in section: layers to scale with their moduli, the mode over the depth, constants; boreholes in a row."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.discretize.ground import layer_of, sublayers
from groundslab.fem.foundation import Layer
from groundslab.messages import Message, Name, joined
from groundslab.model.ground import (
    ContinuousGround,
    Continuum,
    InterfaceLayer,
    Layered,
    Pasternak,
    SoilLayer,
    Vlasov,
    Winkler,
)
from groundslab.results.soil_profile import Profile, profiles_of
from groundslab.unit_systems import System, in_system
from groundslab.units import UNITS, format_drawn
from groundslab.views.plots import style
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.arrays import Array
    from groundslab.model.ground import AnyGround
    from groundslab.model.model import Model
    from groundslab.views.plots.request import PlotRequest, PlottedCombination


@dataclass(frozen=True, slots=True)
class PlottedLayer:
    """A layer as it is drawn and listed; what is not known of it is None."""

    thickness: float | None  # [m]
    E: tuple[Array, Array] | None  # relative depths and moduli there [Pa]
    nu: float | None
    k0: tuple[float, ...]  # [Pa/m], of its parts or in different combinations; empty if it has none of its own
    k1: tuple[float, ...]  # [Pa m]
    endless: bool = False  # a half-space, of which a part is drawn, as thick as given


@dataclass(frozen=True, slots=True)
class SoilColumn:
    """The ground at one place: its name, its layers from the top downwards, what the combinations found.

    The constants are the profiles that have a gamma, each under the name of its combination.
    """

    name: str
    layers: tuple[PlottedLayer, ...]
    constants: tuple[Profile, ...]

    @property
    def depth(self) -> float | None:
        """Return the depth of the base, or of what is drawn [m], None if it is not known."""
        thicknesses = [layer.thickness for layer in self.layers if layer.thickness is not None]
        return sum(thicknesses) if len(thicknesses) == len(self.layers) else None


def soil_columns(model: Model, combinations: Sequence[PlottedCombination]) -> list[SoilColumn]:
    """Return the ground of each borehole, of the ground and its zones, or the one that is everywhere."""
    kinds: list[AnyGround] = [model.ground, *(zone.ground for zone in model.soil_zones)]
    if model.boreholes:
        kinds = [model.ground] * len(model.boreholes)
    stacks = [hole.layers for hole in model.boreholes] or [getattr(ground, "layers", ()) for ground in kinds]
    profiles = zip(*(profiles_of(combination.results) for combination in combinations), strict=True)
    columns = []
    for ground, layers, by_combination in zip(kinds, stacks, profiles, strict=True):
        constants = tuple(
            replace(profile, name=combination.name)
            for combination, profile in zip(combinations, by_combination, strict=True)
            if profile.gamma is not None
        )
        if len(constants) > 1 and len({constant.gamma for constant in constants}) == 1:
            constants = (replace(constants[0], name="all combinations"),)
        columns.append(SoilColumn(by_combination[0].name, _plotted_layers(model, ground, layers, constants), constants))
    return columns


def _plotted_layers(
    model: Model, ground: AnyGround, layers: Sequence[SoilLayer | InterfaceLayer], constants: Sequence[Profile]
) -> tuple[PlottedLayer, ...]:
    """Return the layers of a described ground."""
    if isinstance(ground, Winkler):
        soil = ground.selvadurai
        E = None if soil is None else (np.array([0.0, 1.0]), np.array([soil.E, soil.E]))
        k = ground.modulus(max(model.plate.sides))
        return (PlottedLayer(None if soil is None else soil.depth, E, None, (k,), ()),)
    if isinstance(ground, Pasternak):
        return (PlottedLayer(None, None, None, (ground.k0,), (ground.k1,)),)
    assert isinstance(ground, Vlasov | Layered | ContinuousGround)
    plotted = []
    for index, layer in enumerate(layers):
        if isinstance(layer, InterfaceLayer):
            plotted.append(PlottedLayer(None, None, None, (layer.k0,), (layer.k1,)))
            continue
        stack_layer = layer_of(layer)
        k0, k1 = _own_constants(ground, stack_layer, index, constants)
        s = np.linspace(0, 1, 41 if any(stack_layer.moduli[1:]) else 2)
        plotted.append(PlottedLayer(layer.thickness, (s, stack_layer.E(s)), layer.nu, k0, k1))
    below = ground.half_space if isinstance(ground, Continuum) else None
    if below is not None:
        drawn = ENDLESS * (sum(drawn_layer.thickness or 0.0 for drawn_layer in plotted) or max(model.plate.sides))
        plotted.append(PlottedLayer(drawn, (np.array([0.0, 1.0]), np.full(2, below.E)), below.nu, (), (), endless=True))
    return tuple(plotted)


def _own_constants(
    ground: Vlasov | Layered | ContinuousGround, layer: Layer, index: int, constants: Sequence[Profile]
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return k0 and k1 of a layer of a stack: of its sublayers, or in each combination; else nothing."""
    if not isinstance(ground, Layered) or not layer.thickness:
        return (), ()
    if ground.coupling == "interface":
        return tuple(constant.k0[index] for constant in constants), tuple(constant.k1[index] for constant in constants)
    alike = ground.replace(layers=(ground.layers[index],))
    k0, k1 = zip(*(part.stiffnesses for part in sublayers(alike, (layer,))), strict=True)
    return tuple(map(float, k0)), tuple(map(float, k1))


#: So much of a half-space is drawn, of the depth of the layers over it, or of the plate's longer side.
ENDLESS = 0.25
#: So many columns stand side by side; those whose layers have no constants may stand closer.
SIDE_BY_SIDE, CLOSE = 2, 3
#: Marks of the depth are so far apart at least [mm].
APART = 2.8
#: Heights of the boxes of at most two columns, and of more; width of a page with one column [mm].
HIGH, LOW, ALONE = 80.0, 52.0, 115.0
#: Space for the depths, width of the column of layers, gap before a diagram [mm].
LEFT, COLUMN, GAP = 13.0, 15.0, 3.5
#: From row to row of a table, and where its columns end [mm].
ROW = 3.9
ENDS = (8.0, 20.0, 38.0, 49.0, 66.0, 84.0)
ENDS_FOUND = (30.0, 39.0, 62.0, 84.0)
#: How strongly the layers are filled, weakly enough for the words on them.
OPACITIES = (0.14, 0.26, 0.08, 0.34)
#: Of more combinations than this only the range is listed.
MOST = len(style.CYCLE)


def draw_sheet(request: PlotRequest) -> Figure:
    """Return all columns on one sheet."""
    return _figure(request, soil_columns(request.combined.model, request.combinations))


def draw_pages(request: PlotRequest) -> list[Figure]:
    """Return the columns on pages, two rows on each."""
    columns = soil_columns(request.combined.model, request.combinations)
    return [_figure(request, part) for part in style.batch(columns, 2 * SIDE_BY_SIDE)]


def _figure(request: PlotRequest, columns: Sequence[SoilColumn]) -> Figure:
    """Return rows of columns below the title."""
    model = request.combined.model
    kind = joined(filter(None, (model.ground.kind, getattr(model.ground, "coupling", ""))))
    heading = [Message("Ground: {kind}", kind=kind)]
    return draw_columns(model, columns, model.title, heading, named=request.names_combinations)


def draw_columns(
    model: Model, columns: Sequence[SoilColumn], title: str = "", heading: Sequence[str] = (), *, named: bool = False
) -> Figure:
    """Return rows of columns, with a legend of combinations if they are named."""
    page = style.Page(style.PAGE_WIDTH if len(columns) > 1 else ALONE, words_of(model))
    top = page.write_heading(title, heading)
    close = not any(layer.k0 for column in columns for layer in column.layers)
    across = min(len(columns), CLOSE if close else SIDE_BY_SIDE)
    high = HIGH if len(columns) <= SIDE_BY_SIDE else LOW
    width = page.width / across
    legend: dict[str, Any] = {}
    places = {hole.name or f"borehole {n}": (hole.x, hole.y) for n, hole in enumerate(model.boreholes, 1)}
    for row in style.batch(columns, across):
        bottoms = []
        for place, column in enumerate(row):
            left = place * width
            words = style.plain_text(column.name, 30)
            if column.name in places:
                words = Message("{name} at {place:place m}", name=words, place=places[column.name])
            page.write(left + style.MARGIN, top, words, fontsize=style.BASE, fontweight="bold", color=style.INK)
            legend |= _draw_column(page, column, columns, (left, top + 12.0, width, high), named, model.units)
            corner = left + style.MARGIN, top + 12.0 + high + 6.0
            bottoms.append(_write_tables(page, column, corner, width, model.units))
        top = max(bottoms) + 6.0
    return page.finish(top, legend if len(legend) > 1 else {})


def _draw_column(
    page: style.Page,
    column: SoilColumn,
    alike: Sequence[SoilColumn],
    box: tuple[float, ...],
    named: bool,
    units: System,
) -> dict[str, Any]:
    """Draw layers, moduli and mode of a column in a box [mm] (left, top, size); return the entries in the legend."""
    left, top, wide, high = box
    deepest = max((other.depth or 0.0 for other in alike), default=0.0)
    to_scale = column.depth is not None
    depth = deepest if to_scale else float(len(column.layers))
    band = COLUMN * wide * SIDE_BY_SIDE / style.PAGE_WIDTH
    axes = page.add_axes(left + LEFT, top, band, high)
    _draw_layers(axes, column, (depth, high), to_scale=to_scale)
    space = wide - LEFT - band - 3 * GAP
    with_mode = any(len(constant.psi) for constant in column.constants)
    width = space / 2 if with_mode else 0.7 * space
    entries: dict[str, Any] = {}
    if to_scale and any(layer.E for layer in column.layers):
        most = max(float(s.E[1].max()) for other in alike for s in other.layers if s.E is not None)
        beside = page.add_axes(left + LEFT + band + GAP, top, width - GAP, high, sharey=axes)
        _draw_moduli(beside, column, depth, most, units)
    if with_mode:
        sharing = {"sharey": axes} if to_scale else {}
        beside = page.add_axes(left + LEFT + band + GAP + width, top, width - GAP, high, **sharing)
        entries = _draw_modes(beside, column, depth, named=named)
    return entries


def _tops(column: SoilColumn, *, to_scale: bool) -> list[float]:
    """Return the depths of the layers' tops and of the base [m]; one apart where thicknesses are not known."""
    thickness = [layer.thickness if to_scale and layer.thickness else 1.0 for layer in column.layers]
    return [0.0, *np.cumsum(thickness).tolist()]


def _draw_layers(axes: Axes, column: SoilColumn, size: tuple[float, float], *, to_scale: bool) -> None:
    """Draw numbered layers to a depth [m] as so many millimeters, on a hatched base; a half-space goes on below."""
    from matplotlib.patches import Rectangle

    depth, high = size
    tops = _tops(column, to_scale=to_scale)
    for index, (upper, lower) in enumerate(pairwise(tops)):
        corner, height, fill = (0, upper), lower - upper, (style.GROUND, OPACITIES[index % len(OPACITIES)])
        edge = "none" if column.layers[index].endless else style.INK
        axes.add_patch(Rectangle(corner, 1, height, facecolor=fill, edgecolor=edge, linewidth=0.6))
        axes.text(
            0.5, (upper + lower) / 2, str(index + 1), fontsize=style.SMALL, ha="center", va="center", color=style.INK
        )
    if column.layers[-1].endless:
        axes.plot([0, 1], [tops[-1]] * 2, color=style.INK, linewidth=0.8, linestyle=(0, (1, 2)), clip_on=False)
    else:
        hatched: dict[str, Any] = {"facecolor": "white", "edgecolor": style.GREY, "hatch": "//////", "linewidth": 0.0}
        axes.add_patch(Rectangle((0, tops[-1]), 1, 0.035 * depth, clip_on=False, **hatched))
        axes.plot([0, 1], [tops[-1]] * 2, color=style.INK, linewidth=1.2, clip_on=False)
    axes.set(xlim=(0, 1), ylim=(depth, 0), xticks=[])
    axes.spines[:].set_visible(False)
    axes.spines["left"].set_visible(to_scale)
    axes.set_ylabel(style.label_of_length("depth z") if to_scale else "not to scale", labelpad=1)
    axes.set_yticks(_marks(tops, APART * depth / high) if to_scale else [])


def _marks(tops: Sequence[float], least: float) -> list[float]:
    """Return the depths that are marked [m]: of tops of layers and the base those that are so far apart at least."""
    marks = [tops[0], tops[-1]]
    for top in tops[1:-1]:
        if all(abs(top - mark) >= least for mark in marks):
            marks.append(top)
    return sorted(marks)


def _set_depth_axes(axes: Axes, depth: float, label: str) -> None:
    """Give a diagram over the depth its axes: values above, depth downwards."""
    axes.set_ylim(depth, 0)
    axes.xaxis.tick_top()
    axes.xaxis.set_label_position("top")
    axes.set_xlabel(label)
    axes.tick_params(labelleft=False)
    axes.grid(color=style.FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    axes.spines[["right", "bottom"]].set_visible(False)


def _draw_moduli(axes: Axes, column: SoilColumn, depth: float, most: float, units: System) -> None:
    """Draw E over the depth, as it varies within the layers."""
    from matplotlib.ticker import MaxNLocator

    tops = _tops(column, to_scale=True)
    unit = in_system(UNITS["MPa"], units)
    z, E = [], []
    for (upper, lower), layer in zip(pairwise(tops), column.layers, strict=True):
        if layer.E is not None:
            z.append(upper + layer.E[0] * (lower - upper))
            E.append(layer.E[1] * unit.scale)
    depths, moduli = np.concatenate(z), np.concatenate(E)
    axes.fill_betweenx(depths, 0, moduli, color=(style.GROUND, OPACITIES[0]), linewidth=0)
    axes.plot(moduli, depths, color=style.INK, linewidth=1.2)
    axes.set_xlim(0, 1.08 * most * unit.scale)
    axes.xaxis.set_major_locator(MaxNLocator(nbins=4, steps=[1, 2, 2.5, 5, 10]))
    _set_depth_axes(axes, depth, f"$E$ [{unit.name}]")


def _draw_modes(axes: Axes, column: SoilColumn, depth: float, *, named: bool) -> dict[str, Any]:
    """Draw the mode of each combination over the depth; of many the range."""
    entries: dict[str, Any] = {}
    modes = [(constant.name, constant.z, constant.psi) for constant in column.constants if len(constant.psi)]
    if len(modes) > MOST:
        z = np.linspace(0, depth, 200)
        rows = np.stack([np.interp(z, depths, psi) for _, depths, psi in modes])
        axes.fill_betweenx(z, rows.min(axis=0), rows.max(axis=0), color=style.FAINT, linewidth=0.6, edgecolor=style.INK)
    else:
        for index, (name, depths, psi) in enumerate(modes):
            (line,) = axes.plot(psi, depths, color=style.CYCLE[index], linestyle=style.STROKES[index], linewidth=1.1)
            if named:
                entries[style.plain_text(Name(name), 60)] = line
    axes.set(xlim=(0, 1.05), xticks=[0, 0.5, 1], xticklabels=["0", "0.5", "1"])
    _set_depth_axes(axes, depth, rf"{style.math_symbol('psi')} [-]")
    return entries


def _write_tables(
    page: style.Page, column: SoilColumn, corner: tuple[float, float], wide: float, units: System
) -> float:
    """Write the layers and what the combinations found below a corner [mm]; return how far down that reaches."""
    left, top = corner
    stretch = wide * SIDE_BY_SIDE / style.PAGE_WIDTH
    stretch = min(stretch, stretch**0.5)
    has_constants = any(layer.k0 for layer in column.layers)
    h, E, k0, k1 = (in_system(UNITS[name], units) for name in ("m", "MPa", "MPa/m", "MPa m"))
    stiffnesses = [Name(f"k0 [{k0.name}]"), Name(f"k1 [{k1.name}]")]
    heads = ["layer", f"h [{h.name}]", f"E [{E.name}]", "\N{GREEK SMALL LETTER NU} [-]"]
    heads += stiffnesses if has_constants else []
    rows = [
        heads,
        *(
            _row(index, layer, units, with_constants=has_constants)
            for index, layer in enumerate(column.layers, start=1)
        ),
    ]
    top = _write_table(page, left, top, rows, [stretch * end for end in ENDS])
    if not column.constants:
        return top
    heads = ["combination", "\N{GREEK SMALL LETTER GAMMA} [-]"]
    lines: list[tuple[Any, ...]] = [(constant.name, constant.gamma) for constant in column.constants]
    if len(column.constants[0].psi):
        heads += stiffnesses
        lines = [
            (constant.name, constant.gamma, constant.k0[0] * k0.scale, constant.k1[0] * k1.scale)
            for constant in column.constants
        ]
    if len(lines) > MOST:
        values = list(zip(*(line[1:] for line in lines), strict=True))
        shown = [[Message("{count} combinations", count=len(lines)), *(_range(value) for value in values)]]
    else:
        letters = int(24 * min(stretch, 1.0))
        shown = [[style.plain_text(name, letters), *(f"{value:#.4g}" for value in values)] for name, *values in lines]
    ends = [stretch * end for end in ENDS_FOUND]
    return _write_table(page, left, top + 2.5, [heads, *shown], ends, first_left=True)


def _row(index: int, layer: PlottedLayer, units: System, *, with_constants: bool) -> list[str]:
    """Return a layer as a row of the table."""
    length, modulus, *scales = (in_system(UNITS[name], units).scale for name in ("m", "MPa", "MPa/m", "MPa m"))
    h = None if layer.thickness is None else format_drawn(layer.thickness * length)
    nu = None if layer.nu is None else format_drawn(layer.nu)
    h = "\N{INFINITY}" if layer.endless else h
    E = None if layer.E is None else _range(layer.E[1][[0, -1]] * modulus)
    constants = zip((layer.k0, layer.k1), scales, strict=True) if with_constants else ()
    stiffnesses = (_range([k * scale for k in values]) if values else None for values, scale in constants)
    return [str(index), *(text or "\N{EN DASH}" for text in (h, E, nu, *stiffnesses))]


def _range(values: Sequence[float] | np.ndarray[Any, Any]) -> str:
    """Return one number, or the first and the last of those that differ, in words."""
    ends = (np.min(values), np.max(values)) if len(values) > 2 else (values[0], values[-1])
    first, last = (format_drawn(float(end)) for end in ends)
    return first if first == last else f"{first} \N{EN DASH} {last}"


def _write_table(
    page: style.Page, left: float, top: float, rows: list[list[str]], ends: list[float], *, first_left: bool = False
) -> float:
    """Write a table whose columns end at some distances [mm] from its left; return how far down [mm] it reaches."""
    for index, row in enumerate(rows):
        for column, (words, end) in enumerate(zip(row, ends, strict=False)):
            to_left = first_left and column == 0
            page.write(
                left + (0.0 if to_left else end), top + index * ROW, words, fontsize=style.SMALL,
                color=style.INK if index else style.GREY, ha="left" if to_left else "right",
            )  # fmt: skip
    return top + len(rows) * ROW
