"""What contradicts a file's unit of length: a slab, or columns, of a size that none has."""

from __future__ import annotations

from collections.abc import Sequence

from groundslab import units
from groundslab.schema.wording import listed

#: The longer side of a slab, and the widest of its columns, are hardly ever smaller or larger [m].
SLABS, COLUMNS = (2.0, 500.0), (0.05, 3.0)
#: Units that a file may be in.
OTHERS = ("mm", "cm", "m", "in", "ft")


def remark_on_size(sides: tuple[float, float], widths: Sequence[float], unit: str, scale: float) -> str:
    """Return that a slab or its columns have no usual size in a file's unit, and which units would give one.

    Nothing if they have.

    Parameters
    ----------
    sides : tuple of float
        Extent of the slab along x and y [m].
    widths : sequence of float
        Widths of its columns [m].
    unit : str
        Name of the file's unit of length.
    scale : float
        Size of that unit [m].
    """
    if _usual(sides, widths, 1.0):
        return ""
    fitting = []
    for other in OTHERS:
        factor = units.parse(f"1 {other}", "length") / scale
        if _usual(sides, widths, factor):
            fitting.append(f"{factor * sides[0]:.3g} m x {factor * sides[1]:.3g} m in {other}")
    columns = f" with columns up to {max(widths):.3g} m wide" if widths else ""
    would = f"; it would be {listed(fitting)}" if fitting else ""
    return f"the unit is {unit}, which makes it a slab of {sides[0]:.3g} m x {sides[1]:.3g} m{columns}{would}"


def _usual(sides: tuple[float, float], widths: Sequence[float], factor: float) -> bool:
    """Return whether sides and widths [m] times a factor are those of slabs and columns."""
    slab = SLABS[0] <= factor * max(sides) <= SLABS[1]
    return slab and (not widths or COLUMNS[0] <= factor * max(widths) <= COLUMNS[1])
