"""Axes of coordinates: ticks that can be read where numbers are long."""

from __future__ import annotations

from matplotlib.figure import Figure

from groundslab.views.plots.style import label_of_axis


def test_ticks_in_a_national_grid_count_from_a_kilometer() -> None:
    """Far from x = y = 0 the label says what ticks count from; near it they are the coordinates."""
    axes = Figure().subplots()
    axes.set(xlim=(32_450_001, 32_450_004), ylim=(-2, 2))
    assert label_of_axis(axes.xaxis, "x", 32_450_001) == "x \N{MINUS SIGN} 32450000 [m]"
    assert axes.xaxis.get_major_formatter()(32_450_001.5) == "1.5"
    assert label_of_axis(axes.yaxis, "y", -2) == "y [m]"
