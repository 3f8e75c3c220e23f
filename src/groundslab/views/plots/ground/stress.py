"""Vertical stress in the depth of a continuum: sections through the ground along lines, with filled contours."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.messages import Message, Name, joined
from groundslab.results.soil_profile import profile_depths
from groundslab.unit_systems import in_system
from groundslab.units import UNITS, Unit
from groundslab.views.plots import style
from groundslab.views.plots.annotations import TitleLine, draw_title
from groundslab.views.plots.contours import draw_color_bar, draw_contours, make_scale
from groundslab.views.plots.panels import NOT_CERTIFIED
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.arrays import Array
    from groundslab.views.plots.contours import ColorScale
    from groundslab.views.plots.request import PlotRequest, PlottedCombination, SectionLine

    Panel = tuple[PlottedCombination, SectionLine]

#: Places along a section, and rows in its depth; a section reaches beyond the line's ends by this share of its length.
ALONG, DOWN, BEYOND = 97, 33, 0.5
#: Left and above a section, width of its bar with labels, most height [mm].
LEFT, ABOVE, BAR, HIGH = 15.0, 10.0, 22.0, 95.0
#: Tension beside the plate of less than this share of the largest stress is drawn as none.
SLIGHT = 0.01


def draw_sheet(request: PlotRequest) -> Figure:
    """Return all sections on one sheet."""
    return _figure(request, [(combination, line) for line in request.lines for combination in request.combinations])


def draw_pages(request: PlotRequest) -> list[Figure]:
    """Return the sections on pages, two on each."""
    panels = [(combination, line) for line in request.lines for combination in request.combinations]
    return [_figure(request, part) for part in style.batch(panels, 2)]


def sample_section(results: PlottedCombination, line: SectionLine) -> tuple[Array, Array, Array]:
    """Return distances along a line (s,) [m], depths (z,) [m] and the vertical stress there (s, z) [Pa]."""
    cells = results.results.ground.cells
    assert cells is not None
    start, end = np.array(line.start), np.array(line.end)
    length = float(np.linalg.norm(end - start))
    s = length * np.linspace(-BEYOND, 1 + BEYOND, ALONG)
    deepest = float(profile_depths(results.results.model)[-1])
    z = deepest * np.linspace(0.0, 1.0, DOWN) ** 1.5
    stress = cells.below(start + s[:, None] / length * (end - start), z)[1]
    return s, z, stress if stress.min() < -SLIGHT * stress.max() else np.maximum(stress, 0.0)


def _figure(request: PlotRequest, panels: Sequence[Panel]) -> Figure:
    """Return sections one below the other, all with one scale."""
    page = style.Page(style.PAGE_WIDTH, words_of(request.combined.model))
    certified = all(combination.certified for combination, _ in panels)
    words = ["Vertical stress below the plate, without the soil's own weight"]
    top = page.write_heading(request.combined.model.title, words, "" if certified else NOT_CERTIFIED)
    sampled = [sample_section(*panel) for panel in panels]
    unit = in_system(UNITS["kPa"], request.combined.model.units)
    scale = make_scale([stress * unit.scale for *_, stress in sampled], signed=False)
    wide = style.PAGE_WIDTH - LEFT - BAR - style.MARGIN
    for (combination, line), section in zip(panels, sampled, strict=True):
        s, z, _ = section
        high = min(HIGH, wide * float(z[-1] / np.ptp(s)))
        axes = page.add_axes(LEFT, top + ABOVE, wide, high)
        name = combination.words if request.names_combinations else ""
        _draw_section(axes, section, scale, line, name, unit)
        draw_color_bar(axes, scale, rf"$\sigma_z$ [{unit.name}]", (1.03, 0.0, 0.02, 1.0), high)
        _draw_borders(axes, request, line, float(z[-1]))
        top += ABOVE + high + 11.0
    return page.finish(top)


def _draw_section(
    axes: Axes, section: tuple[Array, Array, Array], scale: ColorScale, line: SectionLine, name: str, unit: Unit
) -> None:
    """Fill the contours of a section and write which one it is."""
    from matplotlib.tri import Triangulation

    s, z, stress = section
    S, Z = np.meshgrid(s, z, indexing="ij")
    draw_contours(axes, Triangulation(S.ravel(), Z.ravel()), stress.ravel() * unit.scale, scale)
    along, depth = map(style.label_of_length, ("distance s along the line", "depth z"))
    axes.set(xlim=(s[0], s[-1]), ylim=(z[-1], 0.0), xlabel=along, ylabel=depth)
    i, j = np.unravel_index(int(stress.argmax()), stress.shape)
    ends = Message("from {start:place m} to {end:place m}", start=line.start, end=line.end)
    most = Message(
        f"largest {{value:number {unit.name}}} at s = {{s:number m}}, z = {{z:number m}}",
        value=stress[i, j] * unit.scale, s=s[i], z=z[j],
    )  # fmt: skip
    title = joined(filter(None, (style.plain_text(Name(line.name), 60) or "Section", style.plain_text(name, 60))))
    draw_title(
        axes,
        [
            TitleLine(title, style.BASE, style.INK, "bold"),
            TitleLine(joined((ends, most), ";  "), style.SMALL, style.GREY, "normal"),
        ],
    )


def _draw_borders(axes: Axes, request: PlotRequest, section: SectionLine, deepest: float) -> None:
    """Draw the line's ends at the surface, and the borders of the layers."""
    length = float(np.hypot(*np.subtract(section.end, section.start)))
    axes.plot([0.0, length], [0.0, 0.0], color=style.INK, linewidth=2.6, solid_capstyle="butt", clip_on=False)
    if request.combined.model.boreholes:
        return
    for depth in np.cumsum([layer.thickness for layer in getattr(request.combined.model.ground, "layers", ())]):
        if depth < deepest:
            line = axes.axhline(depth, color=style.INK, linewidth=0.8, linestyle=(0, (6, 3)), zorder=3)
            line.set_path_effects(style.white_outline(1.8))
