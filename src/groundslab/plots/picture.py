"""A picture of a result in plan: settlement and contact pressure, with contact boundary, loads and what bears."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab import __version__
from groundslab.plots import marks
from groundslab.plots.filled import OVER, filled, triangulate
from groundslab.readings import contact_function, goes_below_zero, holds_line_force, require_finite
from groundslab.results import PLATE_FIELDS

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.tri import Triangulation

    from groundslab.results import Results


def write(results: Results, path: Path) -> None:
    """Write the picture as a PNG file."""
    draw(results).savefig(path, format="png", metadata={"Software": f"groundslab {__version__}"})


def draw(results: Results) -> Figure:
    """Return the picture as a Matplotlib figure that needs no display."""
    from matplotlib.figure import Figure
    from matplotlib.tri import Triangulation

    require_finite(results)
    plate = results.plate
    width, height = np.ptp(plate.nodes, axis=0)
    wide = width > 1.6 * height
    size = (8.5, 2.0 + 2 * min(7.0 * height / width, 4.0)) if wide else (12.0, 1.7 + min(4.3 * height / width, 9.0))
    figure = Figure(figsize=size, dpi=150, layout="constrained")
    rows, columns = (2, 1) if wide else (1, 2)
    panels = figure.subplots(rows, columns, sharex=True, sharey=True)
    triangles = Triangulation(plate.nodes[:, 0], plate.nodes[:, 1], triangulate(plate.elements))
    _settlement(panels[0], triangles, results)
    above = _pressure(panels[1], triangles, results)
    legend: dict[str, Any] = {}
    for axes in panels:
        legend |= marks.contact_boundary(axes, triangles, results)
        legend |= marks.loads(axes, results)
        legend |= marks.columns(axes, results)
        legend |= marks.supports(axes, results)
        axes.set_aspect("equal")
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
    legend |= above
    titles = [results.model.title, results.combination if results.model.cases else ""]
    if any(titles):
        # A title is free text: a dollar sign in it is no formula.
        figure.suptitle("\n".join(filter(None, titles)), parse_math=False, wrap=True)
    if legend:
        figure.legend(legend.values(), legend.keys(), loc="outside lower center", ncols=5, frameon=False)
    return figure


def _settlement(axes: Axes, triangles: Triangulation, results: Results) -> None:
    """Draw the settlement; where the plate lifts, the colours part at zero."""
    field = PLATE_FIELDS["settlement"]
    values = results.plate.settlement * field.scale
    filled(axes, triangles, values, (values.min(), values.max()), f"{field.symbol} [{field.unit}]")
    low = f"uplift {-values.min():.4g}" if goes_below_zero(values) else f"smallest {values.min():.4g}"
    axes.set_title(f"Settlement: largest {values.max():.4g} {field.unit}, {low} {field.unit}", fontsize="medium")


def _pressure(axes: Axes, triangles: Triangulation, results: Results) -> dict[str, Any]:
    """Draw the contact pressure; edge nodes that also hold a line force do not stretch the scale.

    Returns the entry in the legend for what lies above the scale, if anything does.
    """
    from matplotlib.patches import Patch

    field, plate = PLATE_FIELDS["pressure"], results.plate
    values = plate.pressure * field.scale
    line_force = holds_line_force(results)
    inside = values[~plate.on_edge] if line_force else values
    span = (values.min() if goes_below_zero(values) else 0.0, inside.max())
    above = bool(values.max() > span[1] * (1 + 1e-9))
    filled(axes, triangles, values, span, f"{field.symbol} [{field.unit}]", above=above)
    if not plate.in_contact.all():
        lifted = axes.tricontourf(triangles, contact_function(results), levels=[0.0, np.inf], colors=["white"])
        lifted.set(hatch="////", edgecolor=marks.LIFTED, linewidth=0.0)
    share = 100 * plate.area[plate.in_contact].sum() / plate.area.sum()
    where = " inside" if line_force else ""
    axes.set_title(
        f"Pressure: largest{where} {inside.max():.4g} {field.unit}; {share:.4g} % of the plate in contact",
        fontsize="medium",
    )
    return {"above the scale (edge line force)": Patch(color=OVER)} if above else {}
