"""What contradicts a file's unit of length: a slab, or columns, of a size that none has."""

from __future__ import annotations

from groundslab import units
from groundslab.case.dxf.drawing import Drawing
from groundslab.geometry.plan import Ring
from groundslab.schema.wording import listed

#: The longer side of a slab, and the widest of its columns, are hardly ever smaller or larger [m].
SLABS, COLUMNS = (2.0, 500.0), (0.05, 3.0)
#: Units that a drawing may be in.
OTHERS = ("mm", "cm", "m", "in", "ft")


def remark_on_size(drawing: Drawing) -> str:
    """Return that a slab or its columns have no usual size in the drawing's unit, and which units would give one."""
    x0, x1, y0, y1 = drawing.outline.bounds
    sides = x1 - x0, y1 - y0
    widths = [max(column.sides) for column in drawing.columns if isinstance(column, Ring)]
    if _usual(sides, widths, 1.0):
        return ""
    fitting = []
    for unit in OTHERS:
        factor = units.parse(f"1 {unit}", "length") / drawing.scale
        if _usual(sides, widths, factor):
            fitting.append(f"{factor * sides[0]:.3g} m x {factor * sides[1]:.3g} m in {unit}")
    columns = f" with columns up to {max(widths):.3g} m wide" if widths else ""
    would = f"; it would be {listed(fitting)}" if fitting else ""
    return f"the unit is {drawing.unit}, which makes it a slab of {sides[0]:.3g} m x {sides[1]:.3g} m{columns}{would}"


def _usual(sides: tuple[float, float], widths: list[float], factor: float) -> bool:
    """Return whether sides and widths [m] times a factor are those of slabs and columns."""
    slab = SLABS[0] <= factor * max(sides) <= SLABS[1]
    return slab and (not widths or COLUMNS[0] <= factor * max(widths) <= COLUMNS[1])
