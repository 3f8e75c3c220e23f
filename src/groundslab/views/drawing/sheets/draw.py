"""All sheets of a model: one for each layer of bars, one for bars at edges each way, one for links."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from groundslab.design.bars.bar_layout import bar_sets
from groundslab.design.bars.bending import marked_further_links, marked_links
from groundslab.design.bars.positions import Position, positions
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.languages import Translator, translator
from groundslab.model.model import Model
from groundslab.model.names import names_of
from groundslab.results.fields import LAYERS as FACES
from groundslab.schema.wording import printable
from groundslab.views.drawing.bars import LAYERS as BARS
from groundslab.views.drawing.shapes import Layer, Shape, Text, scaled
from groundslab.views.drawing.sheets.bars import draw_bars
from groundslab.views.drawing.sheets.edges import draw_edges
from groundslab.views.drawing.sheets.links import draw_links
from groundslab.views.drawing.sheets.paper import SIZES, Paper, Sheet, choose_scale
from groundslab.views.drawing.sheets.placing import Taken
from groundslab.views.drawing.sheets.plan import chains_of, draw_plan, margins_of
from groundslab.views.drawing.sheets.title_block import draw_frame, draw_list, paper_box
from groundslab.views.tables.bending_schedule import HEADS, bending_schedule
from groundslab.views.tables.table import Cell, Table, in_units, table_of

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Layers of drawings on sheets.
LAYERS = BARS | {"DIMENSIONS": Layer(7), "FRAME": Layer(7), "TITLE": Layer(7)}
#: What sheets are called.
TITLES = {
    "bottom_x": "Bottom bars along x", "bottom_y": "Bottom bars along y", "top_x": "Top bars along x",
    "top_y": "Top bars along y", "edges_x": "Bars at edges along x", "edges_y": "Bars at edges along y",
    "links": "Links",
}  # fmt: skip
#: Between sheets in a drawing of all of them [mm of paper].
BETWEEN = 30.0

#: Wires that differ by less have one length [m].
SAME_LENGTH = 1e-3

#: Adds what a sheet is of.
Draw = Callable[[Sheet, Taken], None]


def draw_sheets(model: Model, links: Sequence[LinkLayout], paper: Paper) -> list[Sheet]:
    """Return the sheets of all bars and links of a model, at one scale; raises InputError where none fits."""
    say = translator(model.language, [model.title, *names_of(model)])
    listed = positions(model)
    wanted = list(_wanted(model, links, listed, say))
    chains = {title: chains_of(model, zones) for title, zones, _, _ in wanted}
    fit = partial(choose_scale, paper, model.bounds, units=model.units)
    coarsest = max(scale for scale, _ in (fit(partial(margins_of, model, chain)) for chain in chains.values()))
    table = in_units(_list_of(model, links, listed), model.units)
    sheets = []
    for number, (title, _, marks, draw) in enumerate(wanted, start=1):
        scale, origin = fit(partial(margins_of, model, chains[title]), least=coarsest)
        sheet = Sheet(title, paper, scale, origin)
        draw(sheet, draw_plan(model, sheet, chains[title], say))
        draw_list(model, sheet, table, marks, say)
        draw_frame(model, sheet, number, len(wanted), say)
        sheets.append(replace(sheet, shapes=[_shown(shape) for shape in sheet.shapes]))
    return sheets


def _list_of(model: Model, links: Sequence[LinkLayout], listed: Sequence[Position]) -> Table:
    """Return the bending schedule with the wires of welded meshes, which are not bent, before it."""
    schedule = bending_schedule(model, links)
    wires: list[list[Cell]] = []
    for wire in (position for position in listed if position.mesh):
        length = wire.total / len(wire.lengths) if np.ptp(wire.lengths) < SAME_LENGTH else None
        about: list[Cell] = [f"{wire.mark}", wire.layer.replace("_", " "), wire.mesh, wire.bars.diameter * 1e3]
        wires.append([*about, len(wire.lengths), *[None] * 6, length, wire.total, wire.mass])
    return table_of(schedule.name, schedule.title, HEADS, [*wires, *schedule.rows()])


def _shown(shape: Shape) -> Shape:
    """Return a shape, a text without letters that files could not hold or nobody sees."""
    return replace(shape, words=printable(shape.words)) if isinstance(shape, Text) else shape


def _wanted(
    model: Model, links: Sequence[LinkLayout], listed: Sequence[Position], say: Translator
) -> Iterator[tuple[str, list[BaseGeometry], list[str], Draw]]:
    """Yield the title of each sheet, the zones that it dimensions, the marks on it, and what draws it."""
    sets = bar_sets(model)
    for layer in FACES:
        laid = [bar_set for bar_set in sets if bar_set.layer == layer]
        bars = [bar for bar in listed if bar.layer == layer]
        if bars:
            zones = [bar_set.region for bar_set in laid if bar_set.zone]
            draw = partial(draw_bars, model, sets=laid, listed=bars, say=say)
            yield TITLES[layer], zones, [f"{bar.mark}" for bar in bars], draw
    for layer in ("edges_x", "edges_y"):
        bars = [bar for bar in listed if bar.layer == layer]
        if bars:
            yield TITLES[layer], [], [f"{bar.mark}" for bar in bars], partial(draw_edges, model, listed=bars, say=say)
    marks = [f"{mark}" for mark in (*marked_links(links, listed), *marked_further_links(model, links, listed))]
    if marks:
        yield TITLES["links"], [], marks, partial(draw_links, model, links=links, listed=listed, say=say)


def in_one_drawing(sheets: Sequence[Sheet]) -> list[Shape]:
    """Return all sheets beside each other in meters, the plan of the first where the case has it."""
    shapes: list[Shape] = []
    for number, sheet in enumerate(sheets):
        factor = 1.0 / sheet.per_meter
        right = number * (SIZES[sheet.paper][0] + BETWEEN) * factor
        by = (right - sheets[0].origin[0] * factor, -sheets[0].origin[1] * factor)
        shapes += [scaled(shape, factor, by) for shape in (paper_box(sheet.paper), *sheet.shapes)]
    return shapes
