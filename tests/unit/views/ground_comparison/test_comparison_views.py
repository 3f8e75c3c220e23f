"""A comparison of grounds as rows, tables, a figure, and on the terminal."""

from __future__ import annotations

from io import StringIO
from pathlib import Path

import pytest
from rich.console import Console

from groundslab.views.ground_comparison.figure import draw_comparison, plot_comparison
from groundslab.views.ground_comparison.rows import comparison_table, constant_rows, curve_table, figure_rows
from groundslab.views.ground_comparison.terminal import print_comparison
from groundslab.views.plots.style import apply_style
from helpers import grounds


def test_differences_are_those_to_the_continuum() -> None:
    """Figures 10, 20 and 30 % larger say so; one that is next to nothing on the continuum has no difference."""
    rows = {row.name: row for row in figure_rows(grounds.comparison())}
    assert rows["largest_settlement"].values == pytest.approx((500, 550, 600, 650))
    assert rows["largest_settlement"].differences[0] is None
    assert rows["largest_settlement"].differences[1:] == pytest.approx((10, 20, 30))
    assert rows["smallest_moment_y"].differences == (None,) * 4
    assert rows["rms_moment_x"].values == (None, 10, 20, pytest.approx(30))
    assert [difference for _, difference in rows["contact_share"].texts()] == ["", "+10.0 %", "+20.0 %", "+30.0 %"]


def test_constants_stand_where_a_ground_has_them() -> None:
    """Springs have k, the two others k0 and k1, in units of display."""
    rows = {row.name: row.values for row in constant_rows(grounds.comparison())}
    assert rows["k"] == (None, None, None, 8)
    assert rows["k0"] == (None, 7, 5, None)
    assert rows["k1"] == (None, 20, 30, None)
    assert rows["gamma"] == (None, 1.5, None, None)


def test_tables() -> None:
    """Every ground has a column, every difference another; curves have a row for each sample, and gaps."""
    table = comparison_table(grounds.comparison())
    assert [column.header for column in table.columns[2:7]] == [
        "continuum", "vlasov", "pasternak", "winkler", "difference of vlasov [%]",
    ]  # fmt: skip
    assert table["quantity"][0] == "largest_settlement"
    curves = curve_table(grounds.comparison())
    assert curves["x"] == (-4.8, 0.0, 4.8, 0.0, 0.0, 0.0)
    assert curves["y"] == (1.0, 1.0, 1.0, -3.6, 0.0, 3.6)
    assert curves["settlement w on vlasov"] == (1100, None, 2200, 1100, 1100, 2200)


def test_terminal_shows_values_and_differences() -> None:
    """Each line fits into 80 columns."""
    console = Console(width=80, record=True, file=StringIO())
    print_comparison(grounds.comparison(), console)
    text = console.export_text()
    assert "+30.0 %" in text
    assert "A note." in text
    assert max(map(len, text.splitlines())) <= 80


def test_figure_draws_all_grounds_along_both_axes() -> None:
    """Six boxes with a curve of each ground and the line of zero; settlements point downwards; one legend."""
    with apply_style():
        figure = draw_comparison(grounds.comparison())
    assert [len(axes.lines) for axes in figure.axes] == [5] * 6
    assert figure.axes[0].yaxis_inverted()
    assert not figure.axes[1].yaxis_inverted()
    (legend,) = figure.legends
    assert [text.get_text() for text in legend.get_texts()] == [
        "continuum", "vlasov", "pasternak, fitted", "winkler, fitted",
    ]  # fmt: skip


def test_figure_is_written(tmp_path: Path) -> None:
    """The same comparison gives the same bytes."""
    for name in ("a.svg", "b.svg"):
        plot_comparison(grounds.comparison(), tmp_path / name)
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()
