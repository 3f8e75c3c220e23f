"""How the iteration went: nodes, or cells, that changed and are in contact at each step, mesh by mesh, and gamma."""

from __future__ import annotations

from itertools import groupby, pairwise
from typing import TYPE_CHECKING

import numpy as np

from groundslab.messages import Message, Name, counted, joined
from groundslab.units import format_drawn
from groundslab.views.plots import style
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.results.records import Step
    from groundslab.views.plots.request import IterationHistory, PlotRequest

#: Boxes of the curves [mm].
LEFT, HIGH, BETWEEN, ABOVE, BELOW = 17.0, 32.0, 4.0, 12.0, 12.0
#: Background of every other mesh.
STRIPE = "#f1f1ee"


def draw_sheet(request: PlotRequest) -> Figure:
    """Return the histories of all combinations on one sheet."""
    return _figure(request, request.histories)


def draw_pages(request: PlotRequest) -> list[Figure]:
    """Return the histories on pages, two on each."""
    return [_figure(request, part) for part in style.batch(request.histories, 2)]


def _figure(request: PlotRequest, histories: Sequence[IterationHistory]) -> Figure:
    """Return histories one below the other."""
    page = style.Page(style.PAGE_WIDTH, words_of(request.combined.model))
    top = page.write_heading(request.combined.model.title, ["Convergence"])
    for history in histories:
        top += ABOVE
        rows = [_changed, _in_contact] + ([_gamma] if any(step.gamma is not None for step in history.steps) else [])
        boxes = []
        for draw in rows:
            axes = page.add_axes(LEFT, top, style.PAGE_WIDTH - LEFT - style.MARGIN - 3, HIGH)
            draw(axes, history.steps)
            boxes.append(axes)
            top += HIGH + BETWEEN
        _share_axis(boxes, history, name=history.name if request.names_combinations else "")
        top += BELOW - BETWEEN
    return page.finish(top)


def meshes_of(steps: Sequence[Step]) -> list[tuple[int, slice]]:
    """Return the unknowns of each mesh and its part of the steps, in their order."""
    meshes, first = [], 0
    for unknowns, group in groupby(steps, key=lambda step: step.unknowns):
        count = len(list(group))
        meshes.append((unknowns, slice(first, first + count)))
        first += count
    return meshes


def _numbers(part: slice) -> range:
    """Return the numbers of steps, from 1."""
    return range(part.start + 1, part.stop + 1)


def _changed(axes: Axes, steps: Sequence[Step]) -> None:
    """Draw how many change sides after each step, to a logarithmic scale that has a place for none."""
    changed, color = [step.changed for step in steps], style.CYCLE[2]
    for _, part in meshes_of(steps):
        fill = color if steps[part.start].finest else "white"
        axes.plot(_numbers(part), changed[part], "o-", color=color, markersize=3, markerfacecolor=fill)
    axes.set_yscale("symlog", linthresh=1, linscale=0.5)
    axes.set(ylim=(-0.15, 2 * max(*changed, 1)), ylabel="changed [-]")
    axes.yaxis.set_major_formatter(lambda value, _: format_drawn(value))


def _in_contact(axes: Axes, steps: Sequence[Step]) -> None:
    """Draw how many are in contact at each step."""
    touching = [step.in_contact for step in steps]
    for _, part in meshes_of(steps):
        axes.plot(_numbers(part), touching[part], "s-", color=style.CYCLE[1], markersize=2.6)
    axes.set(ylim=(0, 1.1 * max(*touching, 1)), ylabel="in contact [-]")


def _gamma(axes: Axes, steps: Sequence[Step]) -> None:
    """Draw the gamma of each step."""
    gammas = np.array([np.nan if step.gamma is None else step.gamma for step in steps])
    for _, part in meshes_of(steps):
        axes.plot(_numbers(part), gammas[part], "^-", color=style.CYCLE[3], markersize=3)
    axes.set_ylabel(f"{style.math_symbol('gamma')} [-]")
    axes.margins(y=0.15)


def _share_axis(boxes: Sequence[Axes], history: IterationHistory, name: str) -> None:
    """Share the axis of steps, shade the meshes and name their unknowns, mark load increments."""
    from matplotlib.ticker import MaxNLocator

    count = len(history.steps)
    for axes in boxes:
        for index, (_, part) in enumerate(meshes_of(history.steps)):
            if index % 2:
                axes.axvspan(part.start + 0.5, part.stop + 0.5, color=STRIPE, linewidth=0, zorder=0)
        for number, (step, following) in enumerate(pairwise(history.steps), 1):
            if following.increment > step.increment:
                axes.axvline(number + 0.5, color=style.GREY, linewidth=0.5, linestyle=(0, (1, 2)))
        axes.set_xlim(0.5, count + 0.5)
        axes.xaxis.set_major_locator(MaxNLocator(nbins=12, integer=True, min_n_ticks=1))
        axes.grid(axis="y", color=style.FAINT, linewidth=0.4)
        axes.set_axisbelow(True)
        axes.tick_params(labelbottom=axes is boxes[-1])
        axes.spines[["top", "right"]].set_visible(False)
    boxes[-1].set_xlabel("step")
    head = boxes[0]
    for unknowns, part in meshes_of(history.steps):
        if unknowns and (part.stop - part.start) * 12 > count:
            head.annotate(
                Message("{unknowns} unknowns", unknowns=unknowns),
                ((part.start + part.stop + 1) / 2, 1), xycoords=("data", "axes fraction"),
                xytext=(0, 1.2 / style.PT), textcoords="offset points", fontsize=style.SMALL - 1, ha="center",
                color=style.GREY,
            )  # fmt: skip
    last = history.steps[-1]
    outcome = history.outcome or counted(count, "converged in {count} step", "converged in {count} steps")
    words: str = joined(filter(None, [style.plain_text(Name(name), 80), outcome]), ": ")
    if last.gamma is not None:
        words += Message("; gamma = {gamma:.5g}", gamma=last.gamma)
    head.annotate(
        words, (0, 1), xycoords="axes fraction", xytext=(0, 5 / style.PT), textcoords="offset points",
        fontsize=style.BASE, fontweight="bold", color=style.BAD if history.outcome else style.INK, parse_math=False,
    )  # fmt: skip
