"""Methods of results that draw them: attached here, as results know nothing of views."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from groundslab.results.results import CombinationResult, Results

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def plot_results(self: CombinationResult | Results, *fields: str, **options: Any) -> Figure:  # noqa: D417
    """Draw the results, see `groundslab.plot`.

    Parameters
    ----------
    *fields : str
        Names or symbols of fields, such as "settlement".
    **options
        Options of `groundslab.plot`.

    Returns
    -------
    matplotlib.figure.Figure
        The figure.
    """
    from groundslab.views.plots import plot

    return plot(self, *fields, **options)


CombinationResult.plot = plot_results  # type: ignore[method-assign]
Results.plot = plot_results  # type: ignore[method-assign]
