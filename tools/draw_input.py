"""Draws a slab in plan and in section with the names of the input file's keys beside what they mean.

python tools/draw_input.py docs/images/input.svg
"""

from __future__ import annotations

import sys

import matplotlib as mpl
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon, Rectangle

GROUND, CONCRETE, LOAD, GREY = "#d8c9a8", "#c8ccd0", "#b03a2e", "#555555"


def arrow(
    axes: Axes, start: tuple[float, float], end: tuple[float, float], colour: str = GREY, both: bool = False
) -> None:
    """Draw an arrow."""
    axes.annotate("", end, start, arrowprops={"arrowstyle": "<|-|>" if both else "-|>", "color": colour, "lw": 1})


def key(axes: Axes, x: float, y: float, text: str, colour: str = "black", **options: str) -> None:
    """Write the name of a key."""
    axes.text(x, y, text, color=colour, fontsize=7, family="monospace", **{"ha": "left", "va": "center", **options})


def plan(axes: Axes) -> None:
    """Draw the plan: what lies where."""
    axes.set_title("plan", fontsize=9)
    axes.add_patch(Rectangle((-6.2, -4.7), 12.4, 9.4, facecolor=GROUND, alpha=0.5, edgecolor=GREY, linestyle="--"))
    axes.add_patch(Rectangle((-5, -3.5), 10, 7, facecolor=CONCRETE, edgecolor="black"))
    axes.add_patch(Rectangle((-4.2, 1.2), 1.6, 1.4, facecolor="white", edgecolor="black"))
    axes.add_patch(Rectangle((-4.4, -3), 2.6, 2, facecolor="#aab0b6", edgecolor="black"))
    axes.add_patch(Rectangle((1.5, 1), 2.2, 1.5, facecolor=LOAD, alpha=0.3, edgecolor=LOAD))
    axes.add_patch(Rectangle((2.6, -2.8), 0.5, 0.5, facecolor="black"))
    axes.add_patch(Circle((0.9, -2.3), 0.7, facecolor="none", edgecolor=GREY, linestyle=":"))
    axes.plot([-1, -1], [-3.2, 3.2], color=LOAD, lw=2)
    axes.plot([5.6], [3.9], "v", color="black")
    axes.plot([4.2], [-0.2], "^", color="black")
    arrow(axes, (0, 0), (1.6, 0), "black")
    arrow(axes, (0, 0), (0, 1.6), "black")
    key(axes, 1.65, -0.25, "x")
    key(axes, 0.12, 1.6, "y")
    arrow(axes, (-5, -5.2), (5, -5.2), both=True)
    key(axes, 0, -5.5, "plate.length_x", ha="center")
    arrow(axes, (-6.6, -3.5), (-6.6, 3.5), both=True)
    key(axes, -6.85, 0, "plate.length_y", ha="center", rotation="vertical")
    arrow(axes, (5, 0.6), (6.2, 0.6), both=True)
    key(axes, 6.3, 0.6, "beyond.width")
    key(axes, -3.4, 1.9, "plate\n.openings", ha="center")
    key(axes, -3.1, -2, "plate.zones", ha="center")
    key(axes, 2.6, 1.75, 'loads "patch"\nx, y, q', LOAD, ha="center")
    key(axes, -0.9, 2.9, 'loads "line"\npoints, q', LOAD)
    key(axes, 3.2, -2.55, "columns")
    key(axes, 0.9, -2.3, "contact\n.voids", ha="center")
    key(axes, 5.4, 4.3, "boreholes", ha="right")
    key(axes, 4.05, -0.55, "supports", ha="center")
    axes.set_xlim(-7.3, 8.6)
    axes.set_ylim(-5.9, 5.1)


def section(axes: Axes) -> None:
    """Draw the section: what is above what, and which way is positive."""
    axes.set_title("section: loads and settlements are positive downwards", fontsize=9)
    axes.add_patch(Rectangle((-6.2, -2.2), 12.4, 2.2, facecolor=GROUND, alpha=0.5, edgecolor=GREY))
    axes.add_patch(Rectangle((-6.2, -4.4), 12.4, 2.2, facecolor=GROUND, edgecolor=GREY))
    axes.add_patch(Polygon([(-6.2, -4.4), (6.2, -4.4), (6.2, -4.7), (-6.2, -4.7)], facecolor=GREY, hatch="///"))
    axes.add_patch(Rectangle((-5, 0), 10, 0.8, facecolor=CONCRETE, edgecolor="black"))
    axes.plot([3, 3], [-3.9, 0], color="black", lw=3)
    for x in (-4.8, -4.2, -3.6, -3.0, -2.4):
        arrow(axes, (x, 1.7), (x, 0.82), LOAD)
    axes.plot([-4.8, -2.4], [1.7, 1.7], color=LOAD, lw=1)
    key(axes, -3.6, 2.0, 'loads "uniform": q', LOAD, ha="center")
    arrow(axes, (0, 2.6), (0, 0.82), LOAD)
    key(axes, 0.1, 2.5, 'loads "point": P', LOAD)
    axes.annotate("", (1.0, 1.1), (-1.0, 1.1), arrowprops={
        "arrowstyle": "-|>", "color": LOAD, "connectionstyle": "arc3,rad=-0.6"})  # fmt: skip
    key(axes, 1.1, 1.4, "M_x, presses the\nside of larger x down", LOAD)
    arrow(axes, (5.4, 0), (5.4, 0.8), both=True)
    key(axes, 5.6, 0.4, "plate.thickness")
    arrow(axes, (-5.6, 0.4), (-5.6, -0.8), "black")
    key(axes, -5.7, -0.2, "w", ha="right")
    arrow(axes, (6.5, 0), (6.5, -2.2), both=True)
    key(axes, 6.6, -1.1, "ground.layers[0]\n.thickness")
    key(axes, -2.5, -1.1, "ground.layers[0]: E, nu", ha="center")
    key(axes, -2.5, -3.3, "ground.layers[1]: E, nu", ha="center")
    key(axes, 3.15, -1.5, "supports\n.stiffness")
    key(axes, -4.9, 0.4, 'loads "temperature": difference > 0 is a warmer bottom')
    axes.set_xlim(-7.3, 8.6)
    axes.set_ylim(-5, 3)


def main(path: str) -> None:
    """Draw both into a file."""
    mpl.rcParams["svg.hashsalt"] = "input"
    figure, both = plt.subplots(2, 1, figsize=(7.5, 8.2), gridspec_kw={"height_ratios": [11, 8]}, layout="constrained")
    for axes, draw in zip(both, (plan, section), strict=True):
        draw(axes)
        axes.set_aspect("equal")
        axes.axis("off")
    figure.savefig(path, metadata={"Date": None, "Creator": None})


if __name__ == "__main__":
    main(*sys.argv[1:])
