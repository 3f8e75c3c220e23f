"""The loads of one load case in plan, each with its value; without factors."""

from __future__ import annotations

from typing import TYPE_CHECKING

from groundslab.views.plots import style, symbols
from groundslab.views.report.case_plan import MOST_LABELS, PLACED, Labels, middle, nearby, upper_left
from groundslab.views.scene.plan import load_parts, plan_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.figure import Figure

    from groundslab.model.loads.load_cases import LoadCase
    from groundslab.model.loads.load_types import AnyLoad
    from groundslab.model.model import Model

#: Width of a plan of loads, the largest height of what is drawn, and what stays free around it [mm].
WIDTH, HEIGHT, FREE = 88.0, 88.0, 6.0


def takes_part(case: LoadCase | None) -> Callable[[AnyLoad], bool]:
    """Return whether a load belongs to a case; all do without one."""
    return symbols.load_filter(() if case is None else ((case.name, 1.0),))


def draw_load_plan(model: Model, case: LoadCase | None) -> Figure:
    """Return the plan of the loads of a case as a figure; of more than MOST_LABELS places none has its value."""
    near, belongs = nearby(plan_of(model)), takes_part(case)
    (x0, y0), (x1, y1) = near.min(axis=0), near.max(axis=0)
    per_meter = min((WIDTH - 2 * FREE) / (x1 - x0), HEIGHT / (y1 - y0))
    width, height = (x1 - x0) * per_meter, (y1 - y0) * per_meter
    page = style.Page(WIDTH)
    axes = page.add_axes((WIDTH - width) / 2, FREE, width, height)
    axes.set(xlim=(x0, x1), ylim=(y0, y1))
    axes.set_axis_off()
    symbols.draw_plate(axes, model, fill=style.PANEL)
    symbols.draw_columns(axes, model, belongs)
    symbols.draw_loads(axes, model, lambda load: belongs(load) and load.kind != "uniform")
    texts = _values(model, case)
    if len(texts) <= MOST_LABELS:
        labels = Labels(axes, per_meter, (x0, x1, y0, y1))
        for place in texts:
            labels.reserve(place, 1.3)
        for place, values in texts.items():
            labels.add(place, ", ".join(values), style.LOAD)
    return page.finish(FREE + height + FREE / 2, signed=False)


def describe_loads(model: Model, case: LoadCase | None) -> str:
    """Return the name of a case, its action, what of it acts everywhere, and whether values are missing."""
    belongs = takes_part(case)
    everywhere = [f"{load.kind} {load_text(load)}" for load in model.loads if belongs(load) and load.kind not in PLACED]
    forces = [] if case is None else [("H_x", case.H_x), ("H_y", case.H_y)]
    everywhere += [f"{symbol.replace('_', '')} {value / 1e3:.5g} kN" for symbol, value in forces if value]
    name = "All loads" if case is None else f"{case.name}, {case.action}"
    hidden = " Values are listed under loads." if len(_values(model, case)) > MOST_LABELS else ""
    return f"{name}{': ' if everywhere else ''}{'; '.join(everywhere)}.{hidden}"


def load_text(load: AnyLoad) -> str:
    """Return how large a load is, without factors, such as "321 kN" or "10 to 20 kN/m"."""
    parts = load_parts(load)
    if load.kind == "line":
        return f"{' to '.join(dict.fromkeys(f'{value:.5g}' for _, value, _ in parts))} kN/m"
    # a force or a pressure needs no symbol, moments do
    named = [
        (f"{symbol.replace('_', '')} " if symbol.startswith("M") else "", f"{value:.5g} {unit.replace('^3', '³')}")
        for symbol, value, unit in parts
        if value
    ]
    return ", ".join(map("".join, named)) or "0"


def _values(model: Model, case: LoadCase | None) -> dict[tuple[float, float], list[str]]:
    """Return how large the loads of a case are, by the places at which that is written."""
    found: dict[tuple[float, float], list[str]] = {}
    for load, about in zip(model.loads, plan_of(model)["loads"], strict=True):
        if takes_part(case)(load) and load.kind in PLACED:
            place = upper_left(about["ring"]) if "ring" in about else middle(about["points"])
            found.setdefault(place, []).append(load_text(load))
    return found
