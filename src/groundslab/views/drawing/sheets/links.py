"""Links on a sheet: the legs at columns, piles and ends of walls, those in parts of the slab, and those of beams."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.bending import marked_further_links, marked_links
from groundslab.design.bars.further_links import LaidLinks
from groundslab.design.bars.positions import Position
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.languages import Translator
from groundslab.messages import Message, Name
from groundslab.model.model import Model
from groundslab.unit_systems import System, bar_size, bars_at, in_system
from groundslab.units import UNITS, format_number
from groundslab.views.drawing.shapes import Circle, Line, Shape, moved
from groundslab.views.drawing.sheets.dimensions import written
from groundslab.views.drawing.sheets.marks import label
from groundslab.views.drawing.sheets.paper import Box, Sheet
from groundslab.views.drawing.sheets.placing import Candidate, Taken, shortened, thin_box

LAYER = "LINKS"
#: Radius of a leg on paper, at least [mm], and from what is labelled to its label [mm].
DOT, OFF = 0.4, 2.0
#: Half of the tick at the ends of a stretch of links [mm].
TICK = 1.3


def draw_links(
    model: Model, sheet: Sheet, taken: Taken, links: Sequence[LinkLayout], listed: Sequence[Position], say: Translator
) -> None:
    """Add all links to a sheet, each leg against punching as a dot."""
    for mark, layout in marked_links(links, listed).items():
        places = np.concatenate([perimeter.places for perimeter in layout.perimeters])
        at = places * sheet.per_meter + sheet.origin
        radius = max(DOT, layout.diameter / 2 * sheet.per_meter)
        sheet.shapes.extend([Circle(LAYER, (float(x), float(y)), radius) for x, y in at])
        around = (*(at.min(axis=0) - radius).tolist(), *(at.max(axis=0) + radius).tolist())
        taken.lines.append(around)
        above, below = _words(layout, model.units)
        sheet.shapes.extend(taken.place(_beside(around, label(LAYER, f"{mark}", [say(above)], [say(below)]))))
    for mark, laid in marked_further_links(model, links, listed).items():
        around = _around(laid, sheet)
        if laid.corners is not None:
            x0, y0, x1, y1 = around
            sheet.shapes.append(Line(LAYER, np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]), closed=True))
        words = Message(
            "{count} links {bars}", count=laid.number, bars=Name(bars_at(laid.diameter, laid.spacing, model.units))
        )
        beside = [shortened(laid.name)]
        if len(laid.standing) > 1:
            places = np.array([link.place for link in (laid.standing[0], laid.standing[-1])])
            ends = places * sheet.per_meter + sheet.origin
            sheet.shapes.extend(_stretch(ends))
            taken.lines.append(thin_box(ends))
            long = written((len(laid.standing) - 1) * laid.spacing, model.units)
            unit = "" if model.units == "US" else Name(" m")
            beside.append(say(Message("over {long}{unit}", long=long, unit=unit)))
        shown = label(LAYER, f"{mark}", [say(words)], beside)
        sheet.shapes.extend(taken.place(_beside(around, shown)))


def _stretch(ends: Array) -> Iterator[Line]:
    """Yield the line from the first to the last link of a beam, with a tick at each end [mm]."""
    yield Line(LAYER, ends)
    for end in ends:
        yield Line(LAYER, np.array([end - TICK, end + TICK]))


def _around(laid: LaidLinks, sheet: Sheet) -> Box:
    """Return the box of a part of a slab with links, or the middle of those of a beam [mm]."""
    x, y = laid.place
    corners = np.array(laid.corners or (x, y, x, y)).reshape(2, 2) * sheet.per_meter + sheet.origin
    x0, y0, x1, y1 = corners.ravel().tolist()
    return (x0, y0, x1, y1)


def _words(layout: LinkLayout, units: System) -> tuple[str, str]:
    """Return how many legs of which diameter there are by perimeters, and the distances of these [mm, in]."""
    unit = in_system(UNITS["mm"], units)
    first = format_number(unit.scale * layout.perimeters[0].distance, 4, trim=True)
    apart = "" if layout.radial is None else f", s_r {format_number(unit.scale * layout.radial, 4, trim=True)}"
    size = Name(bar_size(layout.diameter, units))
    return Message("{counts} links {size}", counts=str(layout.counts), size=size), Name(f"s_0 {first}{apart}")


def _beside(around: Box, shown: tuple[list[Shape], Box]) -> list[Candidate]:
    """Return where a label may stand: beside something, above or below it, at its corners; farther off last."""
    return list(_places(around, shown))


def _places(around: Box, shown: tuple[list[Shape], Box]) -> Iterator[Candidate]:
    """Yield the candidates of labels around a box."""
    shapes, (left, low, right, high) = shown
    x0, y0, x1, y1 = around
    for far, off in enumerate((OFF, 4 * OFF, 8 * OFF)):
        centered_x, centered_y = (x0 + x1 - left - right) / 2, (y0 + y1 - low - high) / 2
        xs = {-1: x0 - off - right, 0: centered_x, 1: x1 + off - left}
        ys = {-1: y0 - off - high, 0: centered_y, 1: y1 + off - low}
        for number, (i, j) in enumerate(((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1))):
            by = (xs[i], ys[j])
            box = (left + by[0], low + by[1], right + by[0], high + by[1])
            yield Candidate(tuple(moved(shape, by) for shape in shapes), box, (), 10.0 * far + 0.1 * number)
