"""The loads of one load case in plan, each with its value; without factors. What moves stands where it begins.

A case as written is `model`, the case as solved `placed`: there patterns are loads at their places.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from groundslab.messages import Message, Name, counted, joined, quantity
from groundslab.model.loads.patterns import position_names
from groundslab.views.plots import style, symbols
from groundslab.views.plots.annotations import LabelPlacement, Point
from groundslab.views.report.drawings.case_plan import SIDES, middle, nearby, stands_in_plan, upper_left
from groundslab.views.scene.plan import load_parts, plan_of
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.figure import Figure

    from groundslab.model.loads.load_cases import LoadCase
    from groundslab.model.loads.load_types import AnyLoad
    from groundslab.model.model import Model

#: Width of a plan of loads, the largest height of what is drawn, and what stays free around it [mm].
WIDTH, HEIGHT, FREE = 88.0, 88.0, 6.0
#: A value keeps so far off lines, and stands so far beside its load, the nearest place that is free [mm].
NEAR, DISTANCES = 0.4, (1.2, 2.5, 4.0, 6.0, 8.5)
#: From farther than this a line leads to the load; half the size of the mark of a point load [mm].
LED, MARK = 3.0, 0.8
#: Below a plan stand the values without space, of which at most so many in rows so far apart [mm].
MOST_LISTED, ROW = 120, 3.0
#: A value that stands at more places than this is written once, below the plan.
MOST_EQUAL = 12


def takes_part(model: Model, case: LoadCase | None) -> Callable[[AnyLoad], bool]:
    """Return whether a load of the placed model belongs to a case, of a moving one at its first position.

    All loads do without a case.
    """
    names = () if case is None else (case.name, *position_names(model.moves).get(case.name, ())[:1])
    return symbols.load_filter((name, 1.0) for name in names)


class LoadPlan:
    """The plan of the loads of one load case, or of all loads where there are no cases."""

    def __init__(self, base: PlanBase, case: LoadCase | None) -> None:
        self._base, self._case = base, case
        self._belongs = takes_part(base.model, case)
        pairs = zip(base.placed.loads, base.plan["loads"], strict=True)
        self._loads = [(load, about) for load, about in pairs if self._belongs(load)]
        self._paths = [
            move for move in base.model.moves if move.travels and case is not None and move.case == case.name
        ]
        values, self._repeated = _split_repeated(_values(self._loads))
        self._texts, self._missing = _place_values(base, self._loads, values)

    @property
    def has_loads(self) -> bool:
        """Return whether any load belongs to the case."""
        return bool(self._loads)

    def draw(self) -> Figure:
        """Return the plan as a figure, with the values that there is space for."""
        (x0, x1, y0, y1), per_meter, model, placed, _ = self._base
        width, height = (x1 - x0) * per_meter, (y1 - y0) * per_meter
        page = style.Page(WIDTH, words_of(model))
        axes = page.add_axes((WIDTH - width) / 2, FREE, width, height)
        axes.set(xlim=(x0, x1), ylim=(y0, y1))
        axes.set_axis_off()
        symbols.draw_plate(axes, model, fill=style.PANEL)
        symbols.draw_columns(axes, placed, self._belongs)
        symbols.draw_walls(axes, placed, self._belongs)
        symbols.draw_beams(axes, model)
        symbols.draw_axes(axes, model)
        for path in self._paths:
            axes.plot(*zip(*path.points, strict=True), color=style.LOAD, linewidth=0.6, linestyle=(0, (6, 3)))
        symbols.draw_loads(axes, placed, self._belongs, everywhere=False)
        for text, (x, y), led in self._texts:
            if led is not None:
                axes.plot(*(np.array([led, (x, y)]) / per_meter).T, color=style.LOAD, linewidth=0.35, zorder=7.5)
            axes.text(
                x / per_meter, y / per_meter, text, fontsize=style.SMALL, ha="center", va="center", color=style.LOAD,
                parse_math=False, zorder=8,
                bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.2},
            )  # fmt: skip
        return page.finish(self._list_values(page, FREE + height + (FREE if self._missing else FREE / 2)), signed=False)

    def _list_values(self, page: style.Page, top: float) -> float:
        """Write the values that there is no space for below the plan [mm]; return how far down they reach."""
        lines = [
            page.say(Message("{place:place m}: {text}", place=place, text=text))
            for place, text in self._missing[:MOST_LISTED]
        ]
        wide = max((style.text_width(line, style.FOOT) + 3.0 for line in lines), default=0.0)
        columns = max(1, int((WIDTH - 2 * FREE) / wide)) if lines else 1
        rows = -(-len(lines) // columns)
        for number, line in enumerate(lines):
            left = FREE + number // rows * (WIDTH - 2 * FREE) / columns
            page.write(left, top + number % rows * ROW, line, fontsize=style.FOOT, color=style.LOAD)
        return top + rows * ROW

    def describe(self) -> str:
        """Return the name of the case, its action, what of it acts everywhere or often, whether values are missing."""
        case = self._case
        everywhere = [_on_plate(load) for load, about in self._loads if not stands_in_plan(about)]
        forces = [] if case is None else [("Hx", case.H_x), ("Hy", case.H_y)]
        everywhere += [Message(f"{name} {{force:.5g kN}}", force=value / 1e3) for name, value in forces if value]
        everywhere += [
            Message("{count} \N{MULTIPLICATION SIGN} {text}", count=count, text=text)
            for text, count in self._repeated.items()
        ]
        name = "All loads" if case is None else joined((Name(case.name), case.action))
        sentences: list[str] = [
            Message("{about}.", about=joined((name, joined(everywhere, "; ")), ": ") if everywhere else name)
        ]
        if unlisted := len(self._missing[MOST_LISTED:]):
            one, many = (
                f"For {values} there is no space; the case lists all." for values in ("one value", "{count} values")
            )
            sentences.append(counted(unlisted, one, many))
        if self._paths:
            sentences.append("It moves along the dashed path; drawn at the first position.")
        return joined(sentences, " ")


class PlanBase(NamedTuple):
    """What the plans of all load cases share."""

    limits: tuple[float, float, float, float]  # x0, x1, y0, y1 [m]
    per_meter: float  # [mm/m]
    model: Model
    placed: Model
    plan: dict[str, Any]  # of the case as solved


def plan_base(model: Model, placed: Model) -> PlanBase:
    """Return where and how large plans of loads are drawn."""
    near = nearby(plan_of(model))
    (x0, y0), (x1, y1) = near.min(axis=0), near.max(axis=0)
    per_meter = min((WIDTH - 2 * FREE) / (x1 - x0), HEIGHT / (y1 - y0))
    return PlanBase((x0, x1, y0, y1), per_meter, model, placed, plan_of(placed))


#: A load, and what the plan says of it.
Loads = list[tuple["AnyLoad", dict[str, Any]]]


def _place_values(
    base: PlanBase, loads: Loads, values: dict[tuple[float, float], list[str]]
) -> tuple[list[tuple[str, Point, Point | None]], list[tuple[Point, str]]]:
    """Return the values of loads with the middle of each [mm], and what lacks space with its place [m].

    Of values that stand farther off there is the place, too, that a line leads to.

    They stand on no line of the plan, nor on each other.
    """
    per_meter, plan, say = base.per_meter, base.plan, words_of(base.model)
    x0, x1, y0, y1 = (limit * per_meter for limit in base.limits)
    placement = LabelPlacement((x0 - FREE, x1 + FREE, y0 - FREE, y1 + FREE))
    parts = (*plan["plates"], *plan["openings"], *plan["zones"], *plan["columns"])
    lines = [plan["outline"], *(part["ring"] for part in parts)]
    lines += [about.get("ring") or about["points"] for _, about in loads if stands_in_plan(about)]
    marks = [about["points"][0] for _, about in loads if stands_in_plan(about) and len(about.get("points", ())) == 1]
    for x, y in marks:
        placement.reserve((x * per_meter, y * per_meter), (MARK, MARK))
    for line in lines:
        closed = np.array([*line, line[0]] if len(line) > 2 else line, dtype=float)
        placement.reserve_line(per_meter * closed, NEAR)
    shown: list[tuple[str, Point, Point | None]] = []
    missing: list[tuple[Point, str]] = []
    for place, texts in values.items():
        text = style.plain_text(say(joined(texts)))
        half = style.text_width(text, style.SMALL) / 2, 0.5 * style.SMALL * style.PT
        at = (place[0] * per_meter, place[1] * per_meter)
        free = ((placement.place_free(at, half, far, SIDES), far) for far in DISTANCES)
        middle, far = next((placed for placed in free if placed[0] is not None), (None, 0.0))
        if middle is None:
            missing.append((place, text))
        else:
            shown.append((text, middle, at if far > LED else None))
    return shown, missing


def _on_plate(load: AnyLoad) -> str:
    """Return the text of a load on the entire plate, such as "uniform 5 kPa", with the plate that it names."""
    name = getattr(load, "plate", "")
    text = Message("{kind} {text}", kind=load.kind, text=load_text(load))
    return Message("{text} on {plate}", text=text, plate=Name(name)) if name else text


def load_text(load: AnyLoad) -> str:
    """Return how large a load is, without factors, such as "321 kN" or "10 to 20 kN/m"."""
    parts = load_parts(load, "SI")
    if parts[-1][0].endswith("_end"):
        (_, first, unit), *_, (_, last, _) = parts
        if f"{first:.5g}" == f"{last:.5g}":
            return quantity(first, unit, ".5g")
        return Message(f"{{first:.5g ({unit})}} to {{last:.5g {unit}}}", first=first, last=last)
    # a force or a pressure needs no symbol, moments do
    named = [
        Message(f"{symbol.replace('_', '')} {{value:.5g {unit}}}", value=value)
        if symbol.startswith("M")
        else quantity(value, unit.replace("^3", "³"), ".5g")
        for symbol, value, unit in parts
        if value
    ]
    return joined(named) or "0"


def _split_repeated(
    values: dict[tuple[float, float], list[str]],
) -> tuple[dict[tuple[float, float], list[str]], dict[str, int]]:
    """Return the values at their places without those that more than MOST_EQUAL of them have, and these with counts."""
    counts = Counter(text for texts in values.values() for text in texts)
    repeated = {text: count for text, count in counts.items() if count > MOST_EQUAL}
    kept = {place: [text for text in texts if text not in repeated] for place, texts in values.items()}
    return {place: texts for place, texts in kept.items() if texts}, repeated


def _values(loads: Loads) -> dict[tuple[float, float], list[str]]:
    """Return how large loads are, by the places at which that is written."""
    texts: dict[tuple[float, float], list[str]] = {}
    for load, about in loads:
        if stands_in_plan(about):
            texts.setdefault(_place_of(load, about), []).append(load_text(load))
    return texts


def _place_of(load: AnyLoad, about: dict[str, Any]) -> tuple[float, float]:
    """Return the place at which the value of a load is written: of a core amid its walls."""
    if "ring" in about:
        return upper_left(about["ring"])
    if load.kind == "core" and "pieces" in about:
        x, y = np.mean([middle(piece) for piece in about["pieces"]], axis=0)
        return float(x), float(y)
    return middle(about["points"])
