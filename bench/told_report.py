"""The part of docs/performance.md on told errors: shares and histograms of told over true ones.

From bench/told_errors.json (slabs in closed form) and bench/random_slabs.json; bench/report.py writes it.
"""

from __future__ import annotations

import itertools
import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
CLOSED, RANDOM = HERE / "told_errors.json", HERE / "random_slabs.json"
#: Of smaller true errors no ratio is taken. Ratios aimed at for nine values of ten, and the least one where the true
#: error is above this share of what is asked for.
SEEN, LOW, HIGH, LEAST, OF_ASKED = 1e-3, 0.7, 8.0, 0.5, 1 / 3
#: Borders of the bars: powers of two.
BARS = [2.0**n for n in range(-4, 7)]
COLOUR, OUTSIDE = "#0072B2", "#D55E00"


@dataclass(frozen=True)
class Told:
    """True and told errors of values, as shares of what governs, and what was asked for."""

    name: str
    errors: tuple[tuple[float, float, float], ...]

    @property
    def ratios(self) -> list[float]:
        """Return told over true errors that are large enough, in ascending order."""
        return sorted(told / true for true, told, _ in self.errors if true > SEEN)

    def row(self) -> list[str]:
        """Return the line of the table."""
        ratios, n = self.ratios, len(self.ratios)
        within = sum(LOW <= ratio <= HIGH for ratio in ratios)
        small = sum(true > OF_ASKED * asked and told < LEAST * true for true, told, asked in self.errors)
        false = sum(told <= asked < true for true, told, asked in self.errors)
        tenths = [f"{ratios[min(int(share * n), n - 1)]:.2g}" for share in (0.05, 0.5, 0.95)]
        return [self.name, str(len(self.errors)), str(n), f"{100 * within / n:.0f} %", *tenths, str(small), str(false)]


HEAD = [
    "slabs", "values", "true error above 0.1 %", f"told / true {LOW:g} to {HIGH:g}", "one in twenty", "median",
    "nineteen in twenty", f"below {LEAST:g} of a true error above a third of what is asked", "false greens",
]  # fmt: skip


def all_told() -> list[Told]:
    """Return what is stored."""
    rows: list[dict[str, Any]] = json.loads(CLOSED.read_text(encoding="utf-8"))
    slabs: dict[str, list[dict[str, Any]]] = json.loads(RANDOM.read_text(encoding="utf-8"))

    def errors(key: str) -> tuple[tuple[float, float, float], ...]:
        return tuple((row["true"], row["told"], row.get("accuracy", 0.05)) for row in rows if key in row)

    def of_slabs(asked: str) -> tuple[tuple[float, float, float], ...]:
        accuracy = float(asked.removesuffix(" %")) / 100
        pairs = (zip(slab["true"], slab["told"], strict=True) for slab in slabs[asked])
        return tuple((true, told, accuracy) for true, told in itertools.chain(*pairs))

    return [
        Told("closed forms, meshes for 5 % and 2 %", errors("accuracy")),
        Told("closed forms, given sizes", errors("size")),
        *(Told(f"{len(slabs[asked])} random slabs, meshes for {asked}", of_slabs(asked)) for asked in slabs),
    ]


def draw(told: Sequence[Told], path: Path) -> None:
    """Draw a histogram of told over true errors for each."""
    import matplotlib

    matplotlib.use("svg")
    import matplotlib.pyplot as plt

    matplotlib.rcParams["svg.hashsalt"] = "groundslab"
    figure, all_axes = plt.subplots(1, len(told), figsize=(3 * len(told), 2.8), layout="constrained", sharey=True)
    for axes, each in zip(all_axes, told, strict=True):
        clipped = [min(max(ratio, BARS[0]), 0.999 * BARS[-1]) for ratio in each.ratios]
        weights = [100 / len(clipped)] * len(clipped)
        _, _, bars = axes.hist(clipped, bins=BARS, weights=weights, color=COLOUR, edgecolor="white", lw=0.5)
        for bar in bars:
            if bar.get_x() + bar.get_width() <= LOW or bar.get_x() >= HIGH:
                bar.set_color(OUTSIDE)
        axes.axvline(1.0, color="black", lw=0.8)
        axes.set_xscale("log", base=2)
        axes.set_xticks([1 / 8, 1 / 2, 1, 2, 8, 32], ["1/8", "1/2", "1", "2", "8", "32"])
        axes.set_title(each.name, fontsize=9)
        axes.set_xlabel("told / true")
        axes.spines[["top", "right"]].set_visible(False)
    all_axes[0].set_ylabel("% of the values")
    figure.savefig(path, metadata={"Date": None, "Creator": None})
    plt.close(figure)
