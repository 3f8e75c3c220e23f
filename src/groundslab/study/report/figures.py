"""Figures of a study's page, as inline SVG."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from groundslab.study.evaluation import statistics, tables
from groundslab.study.evaluation.statistics import LEVEL
from groundslab.views.plots.contours import make_scale, triangulation
from groundslab.views.plots.export import to_inline_svg
from groundslab.views.plots.style import ACCENT, BAD, FAINT, INK, SECOND, plain_text

if TYPE_CHECKING:
    from markupsafe import Markup
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.arrays import Array, Integers
    from groundslab.study.evaluation.samples import Input, Output, Samples
    from groundslab.units import Unit

#: Figures are drawn so wide [in]; the page gives them what space there is.
WIDTH = 7.2
#: What differs from the style of plots: charts with a grid and without a frame, and no formulas.
CHARTS: dict[str, Any] = {
    "text.parse_math": False,
    "axes.formatter.use_mathtext": False,
    "font.size": 8.5,
    "axes.labelsize": "medium",
    "axes.titlesize": 8.5,
    "axes.titlelocation": "left",
    "axes.facecolor": "none",
    "axes.edgecolor": FAINT,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": FAINT,
    "grid.linewidth": 0.5,
    "figure.facecolor": "none",
}
#: Letters of a name beside an axis.
NARROW = 18
#: Panels beside each other.
ABREAST = 3
#: Of more points than these a scatter plot shows the first.
MOST_POINTS = 500
#: Of more inputs or outputs than these scatter plots show the first.
MOST_PANELS = 8


def inputs(sample: Samples) -> Markup:
    """Return histograms of the inputs that vary by chance, with the densities that they were drawn from."""

    def draw() -> Figure:
        figure, panels = _panels(len(sample.varied))
        for axes, entry in zip(panels, sample.varied, strict=False):
            x = entry.values[sample.by_chance] * entry.unit.scale
            _histogram(axes, x, named(entry.name, entry.unit))
            if entry.density is not None and np.ptp(x) > 0:
                _density(axes, entry, x)
        return figure

    return _render("inputs", "Histograms of the inputs", draw)


def outputs(sample: Samples) -> Markup:
    """Return histograms of the outputs, those of several designs over each other, with the bounds of limit states."""

    def draw() -> Figure:
        figure, panels = _panels(len(sample.outputs))
        for axes, output in zip(panels, sample.outputs, strict=False):
            for number, group in enumerate(sample.groups):
                x = sample.of(output, group) * output.unit.scale
                if len(x):
                    _histogram(axes, x, named(output.name, output.unit), number, len(sample.groups), short(group.label))
            _bounds(axes, sample, output)
        _legend(figure, sample)
        return figure

    return _render("outputs", "Histograms of the outputs", draw)


def exceedance(sample: Samples, level: float = LEVEL) -> Markup:
    """Return the curves of exceedance of each output with their intervals and the bounds of limit states."""

    def draw() -> Figure:
        figure, panels = _panels(len(sample.outputs))
        for axes, output in zip(panels, sample.outputs, strict=False):
            for number, group in enumerate(sample.groups):
                curve = tables.exceedance_curve(sample, output, group, level)
                color = _color(number, len(sample.groups))
                _curve(axes, curve, color, short(group.label), "pre" if sample.falls(output) else "post")
            axes.set_xlabel(named(output.name, output.unit))
            axes.set_ylabel("probability of less" if sample.falls(output) else "probability of more")
            _bounds(axes, sample, output)
        _legend(figure, sample)
        return figure

    return _render("exceedance", "Curves of exceedance", draw)


def scatter(sample: Samples) -> Markup:
    """Return each output over each input, at most MOST_POINTS points a panel and MOST_PANELS panels a side."""
    across, down = sample.varied[:MOST_PANELS], sample.outputs[:MOST_PANELS]

    def draw() -> Figure:
        figure = _figure(0.5 + 0.85 * WIDTH / max(len(across), 3) * len(down), WIDTH)
        panels = figure.subplots(len(down), len(across), sharex="col", sharey="row", squeeze=False)
        rows = np.flatnonzero(sample.by_chance)[:MOST_POINTS]
        size = 2.2 if len(rows) > 300 else 4.0
        for i, output in enumerate(down):
            for j, entry in enumerate(across):
                axes = panels[i, j]
                x, y = entry.values[rows] * entry.unit.scale, output.values[rows] * output.unit.scale
                axes.plot(x, y, ".", color=ACCENT, markersize=size, markeredgewidth=0, alpha=0.6)
                axes.locator_params(nbins=4)
                if i == len(down) - 1:
                    axes.set_xlabel(named(entry.name, entry.unit))
                if j == 0:
                    axes.set_ylabel(named(output.name, output.unit))
        return figure

    return _render("scatter", "Outputs over inputs", draw)


def sobol(sample: Samples, level: float = LEVEL) -> Markup:
    """Return bars of Sobol's first-order and total indices with their intervals, a panel an output."""

    def draw() -> Figure:
        figure, panels = _panels(len(sample.outputs), 1.0 + 0.32 * len(sample.inputs), 2)
        places = np.arange(len(sample.inputs))
        for axes, output in zip(panels, sample.outputs, strict=False):
            indices = tables.compute_sobol_indices(sample, output, level)
            axes.set_title(short(output.name))
            axes.set_yticks(places, [short(entry.name, NARROW) for entry in sample.inputs])
            axes.invert_yaxis()
            if indices is None:
                continue
            for values, shift, color, label in (
                (indices.first, -0.19, ACCENT, "first order"),
                (indices.total, 0.19, SECOND, "total"),
            ):
                middle, _ = _intervals(values)
                axes.barh(places + shift, middle, 0.36, color=color, label=label)
                _draw_intervals(axes, places + shift, values)
            axes.set_xlabel("share of the variance")
            axes.set_xlim(left=min(0.0, axes.get_xlim()[0]))
            axes.grid(axis="y", visible=False)
        _legend(figure, None)
        return figure

    return _render("sobol", "Sobol indices", draw)


def tornado(sample: Samples, level: float = LEVEL) -> Markup:
    """Return tornado charts, a panel an output: swings of one input at a time, or rank correlations."""

    def draw() -> Figure:
        inputs = len(sample.varied)
        figure, panels = _panels(len(sample.outputs), 0.9 + 0.24 * inputs, 2)
        for axes, output in zip(panels, sample.outputs, strict=False):
            if sample.kind == "tornado":
                _swings(axes, sample, output)
            else:
                _ranked(axes, sample, output, level)
            axes.set_title(short(output.name))
            axes.invert_yaxis()
            axes.grid(axis="y", visible=False)
        _legend(figure, None)
        return figure

    return _render("tornado", "Influence of the inputs", draw)


def designs(sample: Samples, level: float = LEVEL) -> Markup:
    """Return the probability of each limit state over what the designer chose, with targets.

    Over the quantity if it is one number; several of them, and words, are named side by side.
    """
    chosen = [entry for entry in sample.inputs if entry.chosen]
    number = len(chosen) == 1 and not chosen[0].labels

    def draw() -> Figure:
        figure, panels = _panels(len(sample.limits))
        for axes, limit in zip(panels, sample.limits, strict=False):
            if number:
                x = [dict(group.chosen)[chosen[0].name] * chosen[0].unit.scale for group in sample.groups]
                axes.set_xlabel(named(chosen[0].name, chosen[0].unit))
            else:
                x = [float(place) for place in range(len(sample.groups))]
                axes.set_xticks(x, [short(group.label, NARROW) for group in sample.groups], rotation=60, ha="right")
            p = [tables.failure_probability(sample, group, limit, level) for group in sample.groups]
            middle, half = _intervals(p)
            axes.errorbar(x, middle, yerr=half, fmt="o", color=ACCENT, markersize=3.5, capsize=3, elinewidth=1.0)
            axes.set_yscale("symlog", linthresh=_smallest(p))
            _plain(axes)
            axes.set_ylim(bottom=0)
            if limit.target is not None:
                axes.axhline(limit.target, color=BAD, linewidth=1.0, linestyle="--")
            axes.set_title(short(limit.name))
            axes.set_ylabel("probability of failure")
        return figure

    return _render("designs", "Probability of failure over the design", draw)


def _intervals(estimates: Sequence[statistics.Estimate]) -> tuple[Array, Array]:
    """Return estimates (n,), and how far their intervals reach below and above them (2, n)."""
    value, low, high = np.array([(estimate.value, estimate.low, estimate.high) for estimate in estimates]).T
    return value, np.array([value - low, high - value])


def _draw_intervals(axes: Axes, places: Any, estimates: Sequence[statistics.Estimate]) -> None:
    """Draw the intervals of estimates over bars at some places."""
    value, reach = _intervals(estimates)
    axes.errorbar(value, places, xerr=reach, fmt="none", ecolor=INK, elinewidth=0.8, capsize=2)


def _smallest(p: list[statistics.Estimate]) -> float:
    """Return where a logarithmic scale of probabilities that may be zero begins."""
    return min(max(min(estimate.high for estimate in p), 1e-9), 0.1)


def plan_map(name: str, title: str, nodes: Array, elements: Integers, values: Array, label: str) -> Markup:
    """Return a field over the plan: nodes (k, 2), elements (m, 9), values (k,) in units of display.

    Colors part at zero if the values do.
    """

    def draw() -> Figure:
        width, height = np.ptp(nodes, axis=0)
        figure = _figure(min(max(WIDTH * 0.78 * height / width, 1.2), 6.0) + 0.7)
        axes = figure.subplots()
        scale = make_scale([values], signed=False)
        colors, norm = scale.color_map()
        # what lies on the last level would leave a hole
        shown = np.minimum(values, scale.levels[-1] - 1e-9 * np.ptp(scale.levels))
        drawn = axes.tricontourf(triangulation(nodes, elements), shown, levels=scale.levels, cmap=colors, norm=norm)
        axes.set_aspect("equal")
        axes.grid(visible=False)
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
        axes.set_title(short(title, 80))
        figure.colorbar(drawn, ax=axes, label=label, shrink=0.9)
        return figure

    return _render(name, title, draw)


def _render(name: str, label: str, draw: Callable[[], Figure]) -> Markup:
    """Return the figure made by `draw` as an SVG element for the page."""
    return to_inline_svg(draw, name, label, CHARTS)


def _figure(height: float, width: float = WIDTH) -> Figure:
    """Return an empty figure of a height and a width [in] that needs no display."""
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


def named(name: str, unit: Unit) -> str:
    """Return the label of an axis: "E1 [MPa]"."""
    return f"{short(name)} [{unit.name}]" if unit.name else short(name)


def short(name: str, most: int = 32) -> str:
    """Return a name that a figure has space for: of a long one the beginning and the end."""
    name = plain_text(name)
    if len(name) > most:
        name = f"{name[: most - most // 3 - 1]}\u2026{name[-(most // 3) :]}"
    # Matplotlib leaves labels out of legends that begin so
    return f"\u2060{name}" if name.startswith("_") else name


def _panels(count: int, height: float = 2.1, abreast: int = ABREAST) -> tuple[Figure, list[Axes]]:
    """Return a figure with a number of panels, each of a height [in]."""
    columns = 2 if count == 4 else min(max(count, 2), abreast)
    rows = -(-count // columns)
    figure = _figure(height * rows + 0.25)
    axes: list[Axes] = list(figure.subplots(rows, columns, squeeze=False).ravel())
    for spare in axes[count:]:
        spare.remove()
    return figure, axes[:count]


def _histogram(axes: Axes, x: Array, label: str, number: int = 0, of: int = 1, name: str = "") -> None:
    """Draw the density of samples (n,) as steps or bars; its bins by the square root of n, at most 40."""
    bins = int(np.clip(np.sqrt(len(x)), 5, 40))
    how: dict[str, Any] = {"histtype": "stepfilled", "alpha": 0.55} if of == 1 else {"histtype": "step"}
    axes.hist(x, bins=bins, density=True, color=_color(number, of), label=name, **how)
    axes.set_xlabel(label)
    axes.set_yticks([])
    axes.locator_params(axis="x", nbins=4)
    axes.grid(axis="y", visible=False)


def _density(axes: Axes, entry: Input, x: Array) -> None:
    """Draw the density that an input was drawn from, over the range of its samples."""
    assert entry.density is not None
    at = np.linspace(x.min(), x.max(), 200)
    axes.plot(at, entry.density(at / entry.unit.scale) / entry.unit.scale, color=INK, linewidth=1.0)


def _curve(
    axes: Axes, curve: tuple[Array, Array, Array, Array], color: Any, name: str, step: Literal["pre", "post"]
) -> None:
    """Draw a curve of exceedance with its intervals; logarithmic if the samples reach to one in a hundred.

    A step's height is that of its left end (post) or of its right one (pre).
    """
    value, p, low, high = curve
    n = len(value)
    if n == 0:
        return
    at = tables.thin_out(n, 2 * tables.MOST_POINTS)
    axes.step(value[at], p[at], where=step, color=color, linewidth=1.2, label=name)
    axes.fill_between(value[at], low[at], high[at], step=step, color=color, alpha=0.2, linewidth=0)
    if n >= 100:
        axes.set_yscale("log")
        _plain(axes)
        axes.set_ylim(0.5 / n, 1.3)
    axes.locator_params(axis="x", nbins=4)


def _plain(axes: Axes) -> None:
    """Write the ticks of a logarithmic scale as plain numbers, as a page does not know Matplotlib's formulas."""
    from matplotlib.ticker import NullFormatter, StrMethodFormatter

    axes.yaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())


def _bounds(axes: Axes, sample: Samples, output: Output) -> None:
    """Draw the bounds of the limit states of an output."""
    for limit in sample.limits:
        if limit.output == output.name:
            axes.axvline(limit.bound * output.unit.scale, color=BAD, linewidth=1.0, linestyle="--")


def _swings(axes: Axes, sample: Samples, output: Output) -> None:
    """Draw the swings of one output, the widest on top."""
    base, swings = tables.compute_swings(sample, output)
    scale = output.unit.scale
    for place, bar in enumerate(swings):
        for value, color, label in ((bar.low, ACCENT, "input low"), (bar.high, SECOND, "input high")):
            if np.isfinite(value) and np.isfinite(base):
                axes.barh(place, (value - base) * scale, 0.6, left=base * scale, color=color, label=label)
    if np.isfinite(base):
        axes.axvline(base * scale, color=INK, linewidth=0.8)
    axes.set_yticks(range(len(swings)), [short(swing.input, NARROW) for swing in swings])
    axes.set_xlabel(named(output.name, output.unit))


def _ranked(axes: Axes, sample: Samples, output: Output, level: float) -> None:
    """Draw the rank correlations of one output with their intervals, the strongest on top; of the first design."""
    ranked = tables.rank_inputs(sample, sample.groups[0], output, level)
    for place, (_, r) in enumerate(ranked):
        if np.isfinite(r.value):
            axes.barh(place, r.value, 0.6, color=ACCENT if r.value >= 0 else SECOND)
            _draw_intervals(axes, [place], [r])
    axes.axvline(0.0, color=INK, linewidth=0.8)
    axes.set_yticks(range(len(ranked)), [short(name, NARROW) for name, _ in ranked])
    axes.set_xlim(-1.05, 1.05)
    axes.set_xlabel("rank correlation")


def _color(number: int, of: int) -> Any:
    """Return the color of a design: the accent if there is one only, else from light to dark."""
    from matplotlib import colormaps

    return ACCENT if of == 1 else colormaps["viridis"](0.25 + 0.6 * number / (of - 1))


def _legend(figure: Figure, sample: Samples | None) -> None:
    """Put one legend below the panels: the designs, or whatever bears a label; none for a single design."""
    if sample is not None and len(sample.groups) == 1:
        return
    entries: dict[str, Any] = {}
    for axes in figure.axes:
        handles, labels = axes.get_legend_handles_labels()
        entries |= {label: handle for handle, label in zip(handles, labels, strict=True) if label}
    if entries:
        figure.legend(entries.values(), entries.keys(), loc="outside lower center", ncols=3)
