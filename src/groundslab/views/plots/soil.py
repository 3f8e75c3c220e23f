"""The ground in section: layers to scale with their moduli, the mode over the depth, constants; boreholes in a row."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.views.plots.paper import MARGIN, PAGE_WIDTH, Paper
from groundslab.views.plots.profile import Profile, Stratum, profiles_of
from groundslab.views.plots.style import BASE, CYCLE, FAINT, GREY, INK, SMALL, STROKES, at, free, number, symbol

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.views.plots.request import Wish

#: So many profiles stand side by side.
SIDE_BY_SIDE = 2
#: Heights of the boxes of one row of profiles, and of several rows [mm].
HIGH, LOW = 90.0, 62.0
#: Room for the depths, width of the column of layers, gap before a diagram [mm].
LEFT, COLUMN, GAP = 13.0, 15.0, 3.5
#: From row to row of a table, and where its columns end [mm].
ROW = 3.9
ENDS = (8.0, 20.0, 38.0, 49.0, 66.0, 84.0)
ENDS_FOUND = (30.0, 44.0, 64.0, 84.0)
#: Fillings of the layers, light enough for black words.
FILLS = ("#ece3d0", "#dfd3bb", "#f3eee2", "#d6c8ab")
#: Of more combinations than this only the range is listed.
MOST = len(CYCLE)


def sheet(wish: Wish) -> Figure:
    """Return all profiles on one sheet."""
    return _figure(wish, profiles_of(wish.combined.model, wish.drawn))


def pages(wish: Wish) -> list[Figure]:
    """Return the profiles on pages, two rows on each."""
    profiles = profiles_of(wish.combined.model, wish.drawn)
    each = 2 * SIDE_BY_SIDE
    return [_figure(wish, profiles[first : first + each]) for first in range(0, len(profiles), each)]


def _figure(wish: Wish, profiles: Sequence[Profile]) -> Figure:
    """Return rows of profiles."""
    model = wish.combined.model
    paper = Paper(PAGE_WIDTH)
    kind = model.ground.kind
    coupling = getattr(model.ground, "coupling", "")
    top = paper.head(model.title, [f"Ground: {kind}{', ' + coupling if coupling else ''}"])
    high = HIGH if len(profiles) <= SIDE_BY_SIDE else LOW
    each = PAGE_WIDTH / min(len(profiles), SIDE_BY_SIDE)
    legend: dict[str, Any] = {}
    places = {hole.name or f"borehole {n}": (hole.x, hole.y) for n, hole in enumerate(model.boreholes, 1)}
    for first in range(0, len(profiles), SIDE_BY_SIDE):
        row = profiles[first : first + SIDE_BY_SIDE]
        bottoms = []
        for column, profile in enumerate(row):
            left = column * each
            where = f" at {at(places[profile.name])}" if profile.name in places else ""
            words = free(profile.name, 30) + where
            paper.text(left + MARGIN, top, words, fontsize=BASE, fontweight="bold", color=INK)
            legend |= _profile(paper, profile, profiles, (left, top + 12.0), (each, high), wish.several)
            bottoms.append(_tables(paper, profile, (left + MARGIN, top + 12.0 + high + 6.0), each))
        top = max(bottoms) + 6.0
    return paper.finish(top, legend if len(legend) > 1 else {})


def _profile(
    paper: Paper,
    profile: Profile,
    alike: Sequence[Profile],
    corner: tuple[float, float],
    size: tuple[float, float],
    several: bool,
) -> dict[str, Any]:
    """Draw layers, moduli and mode of a profile below a corner, of some size [mm]; return the entries in the legend."""
    (left, top), (wide, high) = corner, size
    deepest = max((each.depth or 0.0 for each in alike), default=0.0)
    to_scale = profile.depth is not None
    depth = deepest if to_scale else float(len(profile.strata))
    column = COLUMN * wide * SIDE_BY_SIDE / PAGE_WIDTH
    axes = paper.axes(left + LEFT, top, column, high)
    _layers(axes, profile, depth, to_scale=to_scale)
    room = wide - LEFT - column - 3 * GAP
    with_mode = any(each.psi is not None for each in profile.found)
    width = room / 2 if with_mode else 0.7 * room
    entries: dict[str, Any] = {}
    if to_scale and any(stratum.E for stratum in profile.strata):
        most = max(float(s.E[1].max()) for each in alike for s in each.strata if s.E is not None)
        _moduli(paper.axes(left + LEFT + column + GAP, top, width - GAP, high), profile, depth, most)
    if with_mode:
        box = paper.axes(left + LEFT + column + GAP + width, top, width - GAP, high)
        entries = _modes(box, profile, depth, named=several)
    return entries


def _tops(profile: Profile, *, to_scale: bool) -> list[float]:
    """Return the depths of the layers' tops and of the base [m]; one apart where thicknesses are not known."""
    thickness = [stratum.thickness if to_scale and stratum.thickness else 1.0 for stratum in profile.strata]
    return [0.0, *np.cumsum(thickness).tolist()]


def _layers(axes: Axes, profile: Profile, depth: float, *, to_scale: bool) -> None:
    """Draw the layers one below the other, numbered, on a hatched base."""
    from matplotlib.patches import Rectangle

    tops = _tops(profile, to_scale=to_scale)
    for index, (upper, lower) in enumerate(pairwise(tops)):
        fill = FILLS[index % len(FILLS)]
        axes.add_patch(Rectangle((0, upper), 1, lower - upper, facecolor=fill, edgecolor=INK, linewidth=0.6))
        axes.text(0.5, (upper + lower) / 2, str(index + 1), fontsize=SMALL, ha="center", va="center", color=INK)
    base = Rectangle((0, tops[-1]), 1, 0.035 * depth, facecolor="white", edgecolor=GREY, hatch="//////", linewidth=0.0)
    base.set_clip_on(False)
    axes.add_patch(base)
    axes.plot([0, 1], [tops[-1]] * 2, color=INK, linewidth=1.2, clip_on=False)
    axes.set(xlim=(0, 1), ylim=(depth, 0), xticks=[])
    for spine in axes.spines.values():
        spine.set_visible(False)
    if to_scale:
        axes.spines["left"].set_visible(True)
        axes.set_ylabel("depth z [m]", labelpad=1)
    else:
        axes.set_yticks([])
        axes.set_ylabel("not to scale", labelpad=1)


def _diagram(axes: Axes, depth: float, label: str) -> None:
    """Give a diagram over the depth its axes: values above, depth downwards."""
    axes.set_ylim(depth, 0)
    axes.xaxis.set_ticks_position("top")
    axes.xaxis.set_label_position("top")
    axes.set_xlabel(label)
    axes.tick_params(labelleft=False)
    axes.grid(color=FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    for spine in ("right", "bottom"):
        axes.spines[spine].set_visible(False)


def _moduli(axes: Axes, profile: Profile, depth: float, most: float) -> None:
    """Draw E over the depth, as it varies within the layers."""
    from matplotlib.ticker import MaxNLocator

    tops = _tops(profile, to_scale=True)
    z, E = [], []
    for (upper, lower), stratum in zip(pairwise(tops), profile.strata, strict=True):
        if stratum.E is not None:
            z.append(upper + stratum.E[0] * (lower - upper))
            E.append(stratum.E[1] / 1e6)
    depths, moduli = np.concatenate(z), np.concatenate(E)
    axes.fill_betweenx(depths, 0, moduli, color=FILLS[0], linewidth=0)
    axes.plot(moduli, depths, color=INK, linewidth=1.2)
    axes.set_xlim(0, 1.08 * most / 1e6)
    axes.xaxis.set_major_locator(MaxNLocator(nbins=4, steps=[1, 2, 2.5, 5, 10]))
    _diagram(axes, depth, "$E$ [MPa]")


def _modes(axes: Axes, profile: Profile, depth: float, *, named: bool) -> dict[str, Any]:
    """Draw the mode of each combination over the depth; of many the range."""
    entries: dict[str, Any] = {}
    found = [(each.name, each.z, each.psi) for each in profile.found if each.psi is not None and each.z is not None]
    if len(found) > MOST:
        z = np.linspace(0, depth, 200)
        rows = np.stack([np.interp(z, depths, psi) for _, depths, psi in found])
        axes.fill_betweenx(z, rows.min(axis=0), rows.max(axis=0), color=FAINT, linewidth=0.6, edgecolor=INK)
    else:
        for index, (name, depths, psi) in enumerate(found):
            (line,) = axes.plot(psi, depths, color=CYCLE[index], linestyle=STROKES[index], linewidth=1.1)
            if named:
                entries[free(name, 60)] = line
    axes.set(xlim=(0, 1.05), xticks=[0, 0.5, 1], xticklabels=["0", "0.5", "1"])
    _diagram(axes, depth, rf"{symbol('psi')} [-]")
    return entries


def _tables(paper: Paper, profile: Profile, corner: tuple[float, float], wide: float) -> float:
    """Write the layers and what the combinations found below a corner [mm]; return how far down that reaches."""
    (left, top), stretch = corner, (wide * SIDE_BY_SIDE / PAGE_WIDTH) ** 0.5
    own = any(stratum.k0 for stratum in profile.strata)
    heads = ["layer", "h [m]", "E [MPa]", "\N{GREEK SMALL LETTER NU} [-]"]
    heads += ["k0 [MPa/m]", "k1 [MPa m]"] if own else []
    rows = [_row(index, stratum, own=own) for index, stratum in enumerate(profile.strata, start=1)]
    top = _table(paper, left, top, heads, rows, [stretch * end for end in ENDS])
    if not profile.found:
        return top
    whole = profile.found[0].psi is not None
    heads = ["combination", "\N{GREEK SMALL LETTER GAMMA} [-]"]
    heads += ["k0 [MPa/m]", "k1 [MPa m]"] if whole else []
    lines: list[tuple[Any, ...]] = [
        (each.name, each.gamma, *((float(each.k0[0]) / 1e6, float(each.k1[0]) / 1e6) if whole else ()))
        for each in profile.found
    ]
    if len(lines) > MOST:
        values = list(zip(*(line[1:] for line in lines), strict=True))
        shown = [[f"{len(lines)} combinations", *(_range(each) for each in values)]]
    else:
        shown = [[free(name, 24), *(f"{value:#.4g}" for value in values)] for name, *values in lines]
    ends = [stretch * end for end in ENDS_FOUND]
    return _table(paper, left, top + 2.5, heads, shown, ends, first_left=True)


def _row(index: int, stratum: Stratum, *, own: bool) -> list[str]:
    """Return a layer as a row of the table."""
    none = "\N{EN DASH}"
    row = [
        str(index),
        none if stratum.thickness is None else number(stratum.thickness),
        none if stratum.E is None else _range(stratum.E[1][[0, -1]] / 1e6),
        none if stratum.nu is None else number(stratum.nu),
    ]
    if own:
        row += [_range([k / 1e6 for k in values]) if values else none for values in (stratum.k0, stratum.k1)]
    return row


def _range(values: Sequence[float] | np.ndarray[Any, Any]) -> str:
    """Return one number, or the first and the last of those that differ, in words."""
    first, last = (number(float(each)) for each in (values[0], values[-1]))
    if len(values) > 2:
        first, last = number(float(np.min(values))), number(float(np.max(values)))
    return first if first == last else f"{first} \N{EN DASH} {last}"


def _table(
    paper: Paper,
    left: float,
    top: float,
    heads: Sequence[str],
    rows: Sequence[Sequence[str]],
    ends: Sequence[float],
    *,
    first_left: bool = False,
) -> float:
    """Write a table whose columns end at some distances [mm] from its left; return how far down [mm] it reaches."""
    for index, row in enumerate([heads, *rows]):
        for column, (words, end) in enumerate(zip(row, ends, strict=False)):
            to_left = first_left and column == 0
            paper.text(
                left + (0.0 if to_left else end), top + index * ROW, words, fontsize=SMALL,
                color=INK if index else GREY, ha="left" if to_left else "right",
            )  # fmt: skip
    return top + (1 + len(rows)) * ROW
