"""Plans: filled contours of a plate's amounts with all that lies on it, largest and smallest values marked."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from groundslab.envelope import envelope
from groundslab.plots import marks
from groundslab.plots.amounts import NOT_ABOVE, NOT_BELOW, Amount
from groundslab.plots.filled import bar, fill, triangulation
from groundslab.plots.paper import PAGE_HEIGHT, PAGE_WIDTH, WIDE, Paper
from groundslab.plots.scale import OVER, Scale, scale_of
from groundslab.plots.spots import Spot, Spots
from groundslab.plots.style import BASE, FOOT, GREY, INK, PT, SMALL, at, free, number, width_of
from groundslab.readings import contact_function, goes_below_zero, holds_line_force
from groundslab.tables.quantities import extreme, nodal, place

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.actions import AnyLoad
    from groundslab.model import Model
    from groundslab.plots.wish import Drawn, Wish
    from groundslab.results import Array, Flags, Integers, Results

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
#: More columns than this are not named.
MOST_NAMES = 60
#: Where the name of a column stands beside it, and the thickness of a zone within it; the better places first.
BESIDE: tuple[Spot, ...] = ((1, 1), (-1, 1), (1, -1), (-1, -1))
INSIDE: tuple[Spot, ...] = ((-1, -1), (1, -1), (-1, 1), (1, 1), (0, -1), (0, 1), (-1, 0), (1, 0), (0, 0))
NOT_CERTIFIED = "NOT CERTIFIED: the result does not fulfil the equations and must not be used"


@dataclass(frozen=True, slots=True)
class View:
    """One panel: an amount of one combination, or an extreme of it over several."""

    amount: Amount
    of: str  # the combination, or what the extreme is taken over
    values: Array  # (n,), in units of display
    nodes: Array
    elements: Integers
    counts: Flags  # (n,): whether a value takes part in scale and extremes
    contact: Array | None  # (n,): below zero in contact
    share: float | None  # of the plate's area that is in contact
    takes_part: Callable[[AnyLoad], bool]
    certified: bool
    governs: tuple[tuple[str, ...], Integers] | None = None  # combinations, and the one that each value comes from


class Words(NamedTuple):
    """A line of words and how it is written."""

    text: str
    size: float
    colour: str
    weight: str


def views_of(wish: Wish) -> list[View]:
    """Return the panels that are asked for: by combination, then by amount."""
    if wish.envelope:
        return [view for amount in wish.amounts for view in _enveloped(amount, wish.drawn, wish.envelope)]
    return [view_of(amount, each, wish.several) for each in wish.drawn for amount in wish.amounts]


def view_of(amount: Amount, drawn: Drawn, several: bool) -> View:
    """Return the panel of an amount in one combination."""
    results = drawn.results
    plate = results.plate
    return View(
        amount,
        f"{drawn.name} ({drawn.limit_state})" if several else "",
        nodal(results, amount.name),
        plate.nodes,
        plate.elements,
        _counting(amount, results),
        contact_function(results),
        float(plate.area[plate.in_contact].sum() / plate.area.sum()),
        marks.in_combination(results.factors),
        drawn.certified,
    )


def _counting(amount: Amount, results: Results) -> Flags:
    """Return which nodes count (n,): of the pressure those without a line force, if there are any."""
    plate = results.plate
    if amount.name == "pressure" and holds_line_force(results) and not plate.on_edge.all():
        return ~plate.on_edge
    return np.ones(len(plate.nodes), dtype=bool)


def _enveloped(amount: Amount, drawn: Sequence[Drawn], state: str) -> Iterator[View]:
    """Yield the largest and the smallest values of an amount over combinations, as far as they tell anything."""
    found = envelope({each.name: nodal(each.results, amount.name) for each in drawn})
    counts = np.all([_counting(amount, each.results) for each in drawn], axis=0)
    factors = [pair for each in drawn for pair in each.results.factors if pair[1]]
    plate = drawn[0].results.plate
    takes_part = marks.in_combination(factors)
    for word, values, by, nothing in (
        ("Largest", found.greatest, found.greatest_by, amount.name in NOT_ABOVE),
        ("Smallest", found.least, found.least_by, amount.name in NOT_BELOW),
    ):
        if not nothing:
            of = f"{word} of the {len(drawn)} {state} combination{'s' if len(drawn) > 1 else ''}"
            yield View(
                amount, of, values, plate.nodes, plate.elements, counts, None, None, takes_part, True, (found.names, by)
            )


def scales_of(views: Sequence[View]) -> dict[str, Scale]:
    """Return the scale of each amount, the same in all panels, by the amount's name."""
    found = {}
    for name in dict.fromkeys(view.amount.name for view in views):
        own = [view for view in views if view.amount.name == name]
        inside = None if all(view.counts.all() for view in own) else [view.values[view.counts] for view in own]
        found[name] = scale_of([view.values for view in own], signed=own[0].amount.signed, inside=inside)
    return found


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
    from matplotlib.patches import Patch
    from matplotlib.ticker import MaxNLocator

    x0, x1, y0, y1 = _limits(model)
    triangles = triangulation(view.nodes, view.elements)
    fill(axes, triangles, view.values, scale)
    legend: dict[str, Any] = {}
    if view.amount.name == "pressure":
        legend |= marks.lifted(axes, triangles, view.contact)
    legend = marks.contact_boundary(axes, triangles, view.contact) | legend
    legend |= marks.plate(axes, model)
    legend |= marks.voids(axes, model)
    legend |= marks.columns(axes, model, view.takes_part)
    legend |= marks.supports(axes, model)
    legend |= marks.loads(axes, model, view.takes_part)
    if (view.values > scale.levels[-1]).any() and scale.above:
        legend["above the scale (edge line force)"] = Patch(color=OVER)
    axes.set(xlim=(x0, x1), ylim=(y0, y1), aspect="equal", xlabel="x [m]", ylabel="y [m]")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(nbins=8 if width > 80 else 5, steps=[1, 2, 2.5, 5, 10]))
    axes.tick_params(which="both", length=2)
    for spine in axes.spines.values():
        spine.set(linewidth=0.4, color=GREY)
    height = width * _ratio(model)
    bar(axes, scale, view.amount.label, (1 + GAP / width, 0.0, BAR / width, 1.0), height)
    _label(axes, model, view, width / (x1 - x0))
    return legend


class Extreme(NamedTuple):
    """The largest or the smallest value that is drawn."""

    word: str  # "largest" or "smallest"
    value: float
    place: tuple[float, float]  # [m]
    whose: str  # the combination that it comes from, where there are several


def extremes_of(view: View) -> list[Extreme]:
    """Return the largest and the smallest value with their places, as far as they are not plain zeros."""
    found = []
    where = np.flatnonzero(view.counts)
    nodes, values = view.nodes[where], view.values[where]
    size = np.abs(values).max()
    for word, sign in (("largest", 1), ("smallest", -1)):
        node = extreme(nodes, values, sign)
        if abs(values[node]) > 1e-9 * size:
            whose = "" if view.governs is None else view.governs[0][view.governs[1][where[node]]]
            found.append(Extreme(word, float(values[node]), place(nodes, node), whose))
    if len(found) == 2 and found[0].value - found[1].value <= 1e-9 * size:
        del found[1]
    return found


def head_of(view: View, width: float, *, tell: bool) -> list[Words]:
    """Return the lines above a plan: of what it is if that is to be told, what it shows, its extremes, the contact."""
    inside = "" if view.counts.all() else " inside"
    uplift = view.amount.name == "settlement" and goes_below_zero(view.values)
    told = []
    for word, value, where, whose in extremes_of(view):
        called, shown = ("uplift", -value) if uplift and word == "smallest" else (f"{word}{inside}", value)
        governs = f" ({free(whose, 40)})" if whose else ""
        told.append(f"{called} {number(shown)} {view.amount.unit} at {at(where)}{governs}")
    if not told:
        told.append("zero everywhere")
    if view.amount.name in ("pressure", "gap") and view.share is not None:
        told.append(f"{number(100 * view.share)} % of the plate in contact")
    title = view.amount.meaning[0].upper() + view.amount.meaning[1:]
    lines = [Words(each, BASE, GREY, "bold") for each in (_wrapped(view.of, width) if tell else [])]
    lines += [Words(each, BASE, INK, "bold") for each in _wrapped(title, width)]
    return [*lines, *(Words(each, SMALL, GREY, "normal") for each in _joined(told, width))]


def room_above(head: Sequence[Words]) -> float:
    """Return how much room [mm] lines above a plan take."""
    return 3.0 + sum(1.3 * line.size * PT for line in head)


def write_above(axes: Axes, head: Sequence[Words]) -> None:
    """Write lines above a plan."""
    height = 1.6
    for line in reversed(head):
        axes.annotate(
            line.text, (0, 1), xycoords="axes fraction", xytext=(0, height / PT), textcoords="offset points",
            fontsize=line.size, color=line.colour, fontweight=line.weight, va="baseline", parse_math=False,
        )  # fmt: skip
        height += 1.3 * line.size * PT


def _wrapped(words: str, width: float) -> list[str]:
    """Return bold words in at most two lines that are not wider than a width [mm]."""
    clean = free(words, 500)
    letters = int(len(clean) * min(1.0, width / max(width_of(clean, BASE, "bold"), 1e-9))) + 1
    lines = clean.splitlines()
    while letters > 8 and any(width_of(line, BASE, "bold") > width for line in lines):
        lines = free(clean, letters, 2).splitlines()
        letters -= 1
    return lines


def _joined(parts: Sequence[str], width: float) -> list[str]:
    """Return parts joined on as few lines as they need in a width [mm]."""
    lines = [parts[0]]
    for part in parts[1:]:
        longer = f"{lines[-1]};  {part}"
        if width_of(longer, SMALL) <= width:
            lines[-1] = longer
        else:
            lines.append(part)
    return lines


def _label(axes: Axes, model: Model, view: View, per_metre: float) -> None:
    """Name the columns, tell the thickness of zones, mark the extremes by rings with their values.

    The words cover neither each other nor the columns, as far as there is room.
    """
    x0, x1, y0, y1 = (per_metre * bound for bound in model.plate.bounds)
    spots = Spots((x0, x1, y0, y1))
    extremes = extremes_of(view)
    for each in extremes:
        spots.take((each.place[0] * per_metre, each.place[1] * per_metre), (1.0, 1.0))
    named = model.columns if per_metre >= 2 and len(model.columns) <= MOST_NAMES else ()
    for column in model.columns:
        (x, y), half = _middle(np.array(column.ring().flat(np.inf)) * per_metre)
        spots.take((x, y), half)
    for word, value, (x, y), _ in extremes:
        axes.plot(
            x, y, "o", markersize=3.6, markerfacecolor="white", markeredgecolor=INK, markeredgewidth=0.9, zorder=7,
            clip_on=False,
        )  # fmt: skip
        words = f"{'max' if word == 'largest' else 'min'} {number(value)}"
        half = width_of(words, SMALL - 0.5) / 2 + 0.5, 0.6 * SMALL * PT
        middle = spots.beside((x * per_metre, y * per_metre), half, 1.6)
        _put(axes, words, middle, per_metre, SMALL - 0.5, boxed=True)
    for column in named:
        (x, y), half = _middle(np.array(column.ring().flat(np.inf)) * per_metre)
        words = free(column.name, 12)
        own = width_of(words, FOOT) / 2 + 0.2, 0.55 * FOOT * PT
        corners = [(x + i * (half[0] + own[0]), y + j * (half[1] + own[1])) for i, j in BESIDE]
        _put(axes, words, spots.best(corners, own), per_metre, FOOT, boxed=False)
    for zone in model.plate.zones:
        if zone.thickness is not None:
            words = f"t = {zone.thickness:g} m"
            own = width_of(words, FOOT + 0.5) / 2 + 0.4, 0.6 * (FOOT + 0.5) * PT
            (x, y), half = _middle(np.array(zone.shape.ring().flat(np.inf)) * per_metre)
            inner = half[0] - own[0] - 0.6, half[1] - own[1] - 0.6
            corners = [(x + i * inner[0], y + j * inner[1]) for i, j in INSIDE]
            _put(axes, words, spots.best(corners, own), per_metre, FOOT + 0.5, boxed=False)


def _middle(places: Array) -> tuple[Spot, Spot]:
    """Return middle and half sides of the box around places (k, 2)."""
    low, high = places.min(axis=0), places.max(axis=0)
    (x, y), (wide, high_) = (low + high) / 2, (high - low) / 2
    return (float(x), float(y)), (float(wide), float(high_))


def _put(axes: Axes, words: str, middle: Spot, per_metre: float, size: float, *, boxed: bool) -> None:
    """Write words about a place [mm]."""
    look: dict[str, Any] = {"path_effects": marks.white_edge(1.5)}
    if boxed:
        look = {"bbox": {"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 0.6}}
    axes.text(
        middle[0] / per_metre, middle[1] / per_metre, words, fontsize=size, ha="center", va="center", color=INK,
        parse_math=False, zorder=8, **look,
    )  # fmt: skip
