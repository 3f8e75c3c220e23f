"""Tables and pictures of docs/performance.md from bench/results.json and the other stored figures.

    bench/.env/own/bin/python bench/report.py

Only what stands between the markers of the page is written, so that its prose stays. The same results give the same
bytes. The pictures need matplotlib; the tables need nothing.
"""

from __future__ import annotations

import itertools
import json
import math
import re
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import told_report

HERE = Path(__file__).parent
DOCS = HERE.parent / "docs"
PAGE, PICTURE, TOLD = DOCS / "performance.md", DOCS / "performance.svg", DOCS / "told_errors.svg"
RESULTS, ACCURACIES = HERE / "results.json", HERE / "time_to_accuracy.json"
DEFAULTS, FIRST = HERE / "default_answer.json", HERE / "first_figures.json"

OWN = "groundslab"
#: What no program in Python with arrays can do without: our commands are measured by it.
NUMPY = "import numpy"
PLACES = ("centre", "corner")
#: The program that the reference settlements come from, beside our own.
OTHER = "NGSolve, order 4"
#: Names of what job.py solves.
NAMES = {
    "linear": "Winkler, glued",
    "winkler": "Winkler, tensionless",
    "pasternak": "Pasternak, tensionless",
    "raft": "L-shaped raft, tensionless",
    "gamma": "Vlasov, tensionless, gamma iterated",
    "combinations": "several combinations of loads",
    "continuum": "elastic continuum, tensionless, five combinations",
    "variants": "variants of the ground",
    "study": "a study of such variants, two workers",
    "solvers": "a further factorization, on one thread",
    "threads": "Winkler, tensionless, on one thread and on all",
    "l_raft": "the README's raft, 8 combinations",
    "house_raft": "house raft, 17 combinations",
    "warehouse": "warehouse floor, 75 combinations",
}
#: Okabe and Ito's colours, which the colour-blind can tell apart, a grey, and marks that tell the same.
COLOURS = {
    "linear": ("#666666", "s"),
    "winkler": ("#000000", "o"),
    "pasternak": ("#56B4E9", "D"),
    "NGSolve, order 2": ("#0072B2", "^"),
    "NGSolve, order 4": ("#0072B2", "v"),
    "scikit-fem, PARDISO": ("#009E73", "<"),
    "scikit-fem, SuperLU": ("#009E73", ">"),
    "OpenSeesPy": ("#D55E00", "P"),
    "Kratos": ("#CC79A7", "X"),
    "PyNite": ("#E69F00", "*"),
}

CombinationResult = Mapping[str, Any]


@dataclass(frozen=True)
class Reference:
    """Settlements [m] that all errors are taken against, and by how much their two sources differ, relative."""

    value: dict[str, float]
    apart: dict[str, float]
    sources: tuple[str, ...]


@dataclass(frozen=True)
class Measured:
    """What a target is held against; at_least says that the true figure is this or more, as a job was cut off."""

    value: float
    at_least: bool = False


@dataclass(frozen=True)
class Target:
    """What was asked for, how it is measured, and whether less is better."""

    what: str
    least: float
    aim: float
    measured: Callable[[CombinationResult], Measured | None]
    less: bool = True

    def verdict(self, found: Measured | None) -> str:
        """Return which of the two is reached."""
        if found is None:
            return "not measured"
        if self.reached(found, self.aim):
            return "aim"
        return "at least" if self.reached(found, self.least) else "missed"

    def reached(self, found: Measured, limit: float) -> bool:
        """Return whether a figure is on the right side of a limit."""
        return found.value <= limit if self.less else found.value >= limit


def own(kind: str, size: str, key: str) -> Callable[[CombinationResult], Measured | None]:
    """Return what looks up a figure of ours."""

    def look(results: CombinationResult) -> Measured | None:
        value = results["own"].get(kind, {}).get(size, {}).get(key)
        return None if value is None else Measured(value)

    return look


def worst(key: str, kinds: Sequence[str], sizes: Sequence[str] = ()) -> Callable[[CombinationResult], Measured | None]:
    """Return what looks up the largest of a figure of ours over kinds and sizes (all, if none is named)."""

    def look(results: CombinationResult) -> Measured | None:
        found = [
            row[key]
            for kind in kinds
            for size, row in results["own"].get(kind, {}).items()
            if key in row and (not sizes or size in sizes)
        ]
        return Measured(max(found)) if found else None

    return look


def small_job(name: str, beside: str = "") -> Callable[[CombinationResult], Measured | None]:
    """Return what looks up the time of a command over that of another, or over the fastest peer's small job."""

    def look(results: CombinationResult) -> Measured | None:
        medians = {name: row["median"] for name, row in results["small"].items() if "median" in row}
        others = [
            median
            for other, median in medians.items()
            if (other == beside if beside else not other.startswith((OWN, NUMPY)))
        ]
        if name not in medians or not others:
            return None
        return Measured(medians[name] / min(others))

    return look


def against_every_peer(results: CombinationResult) -> Measured | None:
    """Return how many times our time the fastest peer takes at 250k, tensionless."""
    mine = results["peers"].get(OWN, {}).get("250k", {}).get("total [s]")
    if mine is None:
        return None
    found = []
    for name, sizes in results["peers"].items():
        row = sizes.get("250k", {}) if name != OWN else {}
        if "total [s]" in row:
            found.append(Measured(row["total [s]"] / mine))
        elif "not reached" in row:
            found.append(Measured(results["cap [s]"] / mine, at_least=True))
    return min(found, key=lambda each: each.value, default=None)


STUDIES = ("variant / cold", "efficiency on two workers")
CASES = ("solving / bare", "direct solver / solving", "whole process [s]", "whole process / bare")
SOLVERS = ("cholmod / pardiso", "superlu / pardiso", "one thread / all")
TENSIONLESS = ("winkler", "pasternak", "raft")
PLATES = ("linear", "winkler", "pasternak")
AS_IT_IS = "as it is"
TARGETS = [
    Target("the README's raft: solving / (8 bare solves)", 3, 2, own("l_raft", AS_IT_IS, "solving / bare")),
    Target(
        "the same: time in the direct solver / solving", 0.5, 0.7,
        own("l_raft", AS_IT_IS, "direct solver / solving"), less=False,
    ),
    Target(
        "house raft: whole process with files / (17 bare solves)", 4, 2.5,
        own("house_raft", AS_IT_IS, "whole process / bare"),
    ),
    Target("report of the house raft / import numpy", 12, 6, small_job(f"{OWN} report, house raft", NUMPY)),
    Target("warehouse floor, whole process / import numpy", 25, 12, small_job(f"{OWN} solve, warehouse", NUMPY)),
    Target("table 1, solved with files / import numpy", 5, 3.5, small_job(f"{OWN} solve, table 1", NUMPY)),
    Target("L-shaped raft, 100k: total / bare", 3.5, 2.5, own("raft", "100k", "total / bare")),
    Target("the same: assembly / bare", 0.3, 0.15, own("raft", "100k", "assembly / bare")),
    Target("tensionless rectangle, 6k: total / bare", 3, 2, own("winkler", "6k", "total / bare")),
    Target("linear, 1M: total / bare", 1.6, 1.25, own("linear", "1M", "total / bare")),
    Target("tensionless Winkler, 1M: total / bare", 2.5, 1.9, own("winkler", "1M", "total / bare")),
    Target("tensionless Pasternak, 1M: total / bare", 2.2, 1.7, own("pasternak", "1M", "total / bare")),
    Target("continuum, 6k: total / bare", 5, 3, own("continuum", "6k", "total / bare")),
    Target("continuum, 100k: total / bare", 2, 1.6, own("continuum", "100k", "total / bare")),
    Target("iterations on the finest mesh, any size", 5, 3, worst("iterations on the finest mesh", TENSIONLESS)),
    Target("gamma iterated / known, tensionless, 250k", 1.4, 1.2, own("gamma", "250k", "iterated / known")),
    Target("peak memory / the factor's memory, 1M", 1.6, 1.3, worst("peak / factor", PLATES, ["1M"])),
    Target("assembly of 1M unknowns / bare solve", 0.25, 0.1, own("linear", "1M", "assembly / bare")),
    *(
        Target(
            f"each further load combination / the first, {size}", least, aim,
            own("combinations", size, "further / first"),
        )
        for size, least, aim in (("25k", 0.4, 0.25), ("250k", 0.35, 0.2))
    ),
    Target("small job, whole process / the fastest peer's", 1.0, 0.7, small_job(OWN)),
    Target("the same with files, by command / the fastest peer's", 1.4, 1.0, small_job(f"{OWN} solve, files written")),
    Target("groundslab --help / import numpy", 1.0, 0.7, small_job(f"{OWN} --help", NUMPY)),
    Target("groundslab check / import numpy", 2, 1.3, small_job(f"{OWN} check", NUMPY)),
    Target("variant of the ground / cold one, 7k, one thread", 0.25, 0.15, own("variants", "6k", "variant / cold")),
    *(
        Target(
            f"study on two workers, {size}: pace / twice that of one", 0.93, 0.97,
            own("study", size, "efficiency on two workers"), less=False,
        )
        for size in ("6k", "25k")
    ),
    Target("250k, tensionless: every peer's total / ours", 3, 5, against_every_peer, less=False),
    Target("further factorization, 250k, one thread: CHOLMOD / PARDISO", 1.5, 1.0, own("solvers", "250k", SOLVERS[0])),
    Target("1M, tensionless: one thread / two", 1.5, 1.8, own("threads", "1M", "one thread / all"), less=False),
]  # fmt: skip


def reference(results: CombinationResult) -> Reference | None:
    """Return the mean of our finest mesh's settlements and of NGSolve's, and how far the two are apart."""
    sources, found = [], []
    for name in (OWN, OTHER):
        rows = [row for row in results["peers"].get(name, {}).values() if at(row, "corner") is not None]
        if rows:
            finest = max(rows, key=lambda row: row["unknowns"])
            sources.append(f"{name}, {finest['unknowns']:,} unknowns")
            found.append(finest)
    if len(found) < 2:
        return None
    value, apart = {}, {}
    for place in PLACES:
        one, other = (at(row, place) for row in found)
        value[place] = (one + other) / 2
        apart[place] = abs(one - other) / abs(value[place])
    return Reference(value, apart, tuple(sources))


def at(row: Mapping[str, Any], place: str) -> Any:
    """Return a row's settlement [m] at a place, or None."""
    return row.get(f"settlement at the {place} [m]")


def error(row: Mapping[str, Any], place: str, to: Reference | None) -> float | None:
    """Return a row's relative error at a place; none without a reference or a settlement."""
    value = at(row, place)
    return None if to is None or value is None else abs(value - to.value[place]) / abs(to.value[place])


def tables(results: CombinationResult, accuracies: CombinationResult | None = None) -> dict[str, str]:
    """Return all tables by the names of their markers."""
    return {
        "accuracy": "Not measured yet." if accuracies is None else accuracy_rows(accuracies),
        "told": told_rows(),
        "default": default_rows(),
        "first": first_rows(),
        "targets": targets(results),
        "picture": picture(results),
        "own": own_rows(results),
        "phases": phase_rows(results),
        "small": small_rows(results),
        "peers": peer_rows(results),
        "reference": reference_rows(results),
        "machine": machine_rows(results),
    }


def default_rows() -> str:
    """Return the table of default answers."""
    head = [
        "slab", "combinations", "unknowns of each mesh", "seconds, one thread", "over those of the last mesh",
        "largest told error", "asked",
    ]  # fmt: skip
    rows = []
    for row in json.loads(DEFAULTS.read_text(encoding="utf-8")):
        if "unknowns" not in row:
            rows.append([row["slab"], "", "", "none in the time that is given", "", "", ""])
            continue
        told, asked = (f"{100 * row[name]:.2g} %" for name in ("error", "accuracy"))
        made = ", ".join(f"{count:,}" for count in row["unknowns"])
        rows.append(
            [row["slab"], str(row["combinations"]), made, f"{row['seconds']:g}", f"{row['ratio']:g}",
             f"{told} ({row['of']})", asked]
        )  # fmt: skip
    return table(head, rows)


def first_rows() -> str:
    """Return the table of what the workbench shows, and when."""
    names = ("picture", "first", "figures", "checks", "end")
    rows = [
        [row["slab"], *("" if row[name] is None else f"{row[name]:g}" for name in names)]
        for row in json.loads(FIRST.read_text(encoding="utf-8"))
    ]
    head = ["slab", "first picture [s]", "first figures", "figures of the first mesh", "checks", "mesh refined no more"]
    return table(head, rows)


def told_rows() -> str:
    """Return the table of told errors over true ones, and the picture."""
    rows = [each.row() for each in told_report.all_told()]
    return f"{table(told_report.HEAD, rows)}\n\n![Histograms of told over true errors]({TOLD.name})"


def targets(results: CombinationResult) -> str:
    """Return the targets and what was measured."""
    rows = []
    for target in TARGETS:
        found = target.measured(results)
        sign = "at most" if target.less else "at least"
        value = "-" if found is None else (">= " if found.at_least else "") + figure(found.value)
        rows.append([target.what, sign, figure(target.least), figure(target.aim), value, target.verdict(found)])
    return table(["what", "", "at least", "aim", "measured", "reached"], rows)


def picture(results: CombinationResult) -> str:
    """Return the link to the picture, if there is anything to draw."""
    drawn = any(points for _, _, points in lines(results))
    return f"![Time against unknowns]({PICTURE.name})" if drawn else "Not measured yet."


def own_rows(results: CombinationResult) -> str:
    """Return our own jobs."""
    to = reference(results)
    rows = []
    for kind, name in NAMES.items():
        for row in results["own"].get(kind, {}).values():
            if "unknowns" not in row:
                rows.append([name, row.get("size", ""), missing(row, results), *[""] * 7])
                continue
            keys = ("total [s]", "bare solve [s]", "total / bare", "iterations on the finest mesh", "peak memory [MiB]")
            errors = [scientific(error(row, place, to) if kind == "winkler" else None, to, place) for place in PLACES]
            others = ", ".join(
                f"{key} {figure(row[key])}"
                for key in (
                    "assembly / bare",
                    "estimates / analysis",
                    "peak / factor",
                    "iterated / known",
                    "further / first",
                    *STUDIES,
                    *CASES,
                    *SOLVERS,
                )
                if key in row
            )
            rows.append([name, f"{row['unknowns']:,}", *(figure(row.get(key)) for key in keys), *errors, others])
    head = ["job", "unknowns", "total [s]", "bare [s]", "total / bare", "iterations", "peak [MiB]"]
    return table([*head, "error, centre", "error, corner", "further ratios"], rows)


#: Parts of an analysis and the phases of job.py that make them up; the last is what is left.
PARTS = {
    "factorizations": ("of which analysis and factorisations",),
    "solutions": ("of which solutions with the factor",),
    "mesh, loads, supports": ("mesh, loads, supports",),
    "assembly": ("assembly",),
    "certificate": ("certificate",),
}


def phase_rows(results: CombinationResult) -> str:
    """Return the shares [%] of the parts of an analysis, from the mesh to results with their errors."""
    rows = []
    for kind, size in itertools.product(TENSIONLESS, ("100k", "1M")):
        row = results["own"].get(kind, {}).get(size, {})
        if "phases [s]" in row:
            spent = [sum(row["phases [s]"].get(phase, 0.0) for phase in phases) for phases in PARTS.values()]
            shares = [*spent, row["total [s]"] - sum(spent)]
            rows.append([NAMES[kind], f"{row['unknowns']:,}", *(f"{100 * s / row['total [s]']:.0f}" for s in shares)])
    return table(["job", "unknowns", *PARTS, "all else"], rows)


def small_rows(results: CombinationResult) -> str:
    """Return the whole processes of the small job, the fastest first."""
    medians = {name: row["median"] for name, row in results["small"].items() if "median" in row}
    one = medians.get(OWN)
    rows = [
        [name, figure(median), figure(median / one if one else None)]
        for name, median in sorted(medians.items(), key=lambda each: each[1])
    ]
    return table(["program", "whole process [s]", f"times {OWN}'s"], rows)


def peer_rows(results: CombinationResult) -> str:
    """Return all programs by sizes, ours among them."""
    to = reference(results)
    mine = results["peers"].get(OWN, {})
    rows = []
    for name, sizes in results["peers"].items():
        for size, row in sizes.items():
            if "unknowns" not in row:
                rows.append([name, size, missing(row, results), *[""] * 6])
                continue
            ours = mine.get(size, {}).get("total [s]")
            rows.append(_row(name, row, row["total [s]"] / ours if ours else None, to))
    head = ["program", "unknowns", "total [s]", "times ours", "whole process [s]", "iterations", "peak [MiB]"]
    return table([*head, "error, centre", "error, corner"], rows)


def _row(name: str, row: Mapping[str, Any], slower: float | None, to: Reference | None) -> list[str]:
    keys = (row["total [s]"], slower, row["whole process [s]"], row["iterations"], row["peak memory [MiB]"])
    errors = [scientific(error(row, place, to), to, place) for place in PLACES]
    return [name, f"{row['unknowns']:,}", *(figure(value) for value in keys), *errors]


def accuracy_rows(accuracies: CombinationResult) -> str:
    """Return the shortest time in which each program comes within accuracies, by load and value."""
    limits, parts = accuracies["limits"], []
    for side, found in accuracies["loads"].items():
        values = list(found["reference"])
        rows = [[f"{OWN}, mesh.accuracy", *_made_for(found["adaptive"], limits, values)]]
        for name, row in found["uniform"].items():
            cells = [_first_within(row, limit, value) for limit in limits for value in values]
            rows.append([f"{name}, uniform", *cells])
        head = [f"{value} to {100 * limit:g} %" for limit in limits for value in values]
        apart = max(found["apart"].values())
        parts.append(f"Load on {side} m x {side} m, references apart by at most {apart:.0e}:")
        parts.append(table(["program", *head], rows))
    return "\n\n".join([*parts, f"Measured on {accuracies['date']} at commit {accuracies['commit']}."])


def _made_for(adaptive: Sequence[Mapping[str, Any]], limits: Sequence[float], values: Sequence[str]) -> Iterator[str]:
    """Yield time, unknowns and true error of the meshes that were made for accuracies."""
    for limit, row in zip(limits, adaptive, strict=True):
        for value in values:
            off = row["errors"][value]
            missed = f", off by {100 * off:.2g} %" if off > limit else ""
            yield f"{figure(row['total [s]'])} ({row['unknowns']:,}{missed})"


def _first_within(row: Sequence[Mapping[str, Any]], limit: float, value: str) -> str:
    """Return time and unknowns of the first mesh from which on a value's errors are within a limit."""
    best = None
    for figures in reversed(row):
        if figures["errors"][value] > limit:
            break
        best = figures
    return "-" if best is None else f"{figure(best['total [s]'])} ({best['unknowns']:,})"


def reference_rows(results: CombinationResult) -> str:
    """Return the reference settlements, their sources and how far these are apart."""
    to = reference(results)
    if to is None:
        return "Not measured yet."
    rows = [[place, f"{1e3 * to.value[place]:.6f}", f"{to.apart[place]:.1e}"] for place in PLACES]
    return "Sources: " + "; ".join(to.sources) + ".\n\n" + table(["place", "settlement [mm]", "sources apart"], rows)


def machine_rows(results: CombinationResult) -> str:
    """Return machine, date, commit and the versions of all programs."""
    rows = [[key, str(value)] for key, value in results["machine"].items()]
    rows += [["date", results["date"]], ["commit", results["commit"]]]
    packages = results["packages"].get("own", {})
    rows += [[name, packages[name]] for name in ("numpy", "scipy", "pypardiso", "mkl", "gmsh") if name in packages]
    for name, sizes in results["peers"].items():
        row = next((row for row in sizes.values() if "version" in row), None)
        if row is not None:
            rows.append([name, f"{row['program']} {row['version']}; {row['element']}; {row['solver']}"])
    return table(["", ""], rows)


def missing(row: Mapping[str, Any], results: CombinationResult) -> str:
    """Return why a job has no figures."""
    if "not reached" not in row:
        return "out of memory" if "memory" in row.get("error", "") else "failed"
    foreseen = row.get("predicted [s]")
    return f"not reached in {results['cap [s]'] / 60:.0f} min" + (f" ({foreseen:.0f} s foreseen)" if foreseen else "")


def figure(value: float | None) -> str:
    """Return a figure with three digits, whole numbers in full."""
    if value is None:
        return ""
    if value == round(value) or abs(value) >= 1000:
        return f"{value:,.0f}"
    digits = max(0, 2 - math.floor(math.log10(abs(value))))
    return f"{value:.{digits}f}"


def scientific(value: float | None, to: Reference | None, place: str) -> str:
    """Return an error; where the reference is no better than that, what it is surely below."""
    if value is None or to is None:
        return ""
    apart = to.apart[place]
    return f"< {2 * apart:.0e}" if value <= apart else f"{value:.0e}"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table as Markdown, its columns aligned."""
    if not rows:
        return "Not measured yet."
    every = [list(head), *(list(row) for row in rows)]
    widths = [max(3, *(len(row[i]) for row in every)) for i in range(len(head))]
    lines = ["| " + " | ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)) + " |" for row in every]
    lines.insert(1, "|" + "|".join("-" * (w + 2) for w in widths) + "|")
    return "\n".join(lines)


def filled(page: str, parts: Mapping[str, str]) -> str:
    """Return a page with each part between its markers; ValueError if a part has no place or a marker no part."""
    seen = set()

    def put(match: re.Match[str]) -> str:
        name = match[1]
        if name not in parts:
            raise ValueError(f"the page has a marker {name!r} for which there is no table")
        seen.add(name)
        return f"<!-- begin {name} -->\n\n{parts[name]}\n\n<!-- end {name} -->"

    out = re.sub(r"<!-- begin ([\w-]+) -->.*?<!-- end \1 -->", put, page, flags=re.DOTALL)
    if seen != set(parts):
        raise ValueError(f"the page has no markers for {', '.join(sorted(set(parts) - seen))}")
    return out


def lines(results: CombinationResult) -> Iterator[tuple[str, str, list[tuple[float, float]]]]:
    """Yield key, label and pairs of unknowns and time [s] of each line of the picture.

    What others are compared with is ours in a fresh process, as theirs is.
    """
    for kind in PLATES:
        sizes = results["peers"].get(OWN, {}) if kind == "winkler" else results["own"].get(kind, {})
        yield kind, f"{OWN}, {NAMES[kind]}", _points(sizes)
    for name, sizes in results["peers"].items():
        if name != OWN:
            yield name, name, _points(sizes)


def _points(sizes: Mapping[str, Any]) -> list[tuple[float, float]]:
    return sorted((row["unknowns"], row["total [s]"]) for row in sizes.values() if "total [s]" in row)


def spread(places: Sequence[float], gap: float) -> list[float]:
    """Return places moved apart to at least a gap, in the same order, about where they were."""
    order = sorted(range(len(places)), key=lambda i: places[i])
    out = list(places)
    for _ in range(200):
        for low, high in itertools.pairwise(order):
            short = gap - (out[high] - out[low])
            if short > 1e-9:
                out[low] -= short / 2
                out[high] += short / 2
    return out


def draw(results: CombinationResult, path: Path) -> None:
    """Draw time against unknowns, each line named at its end."""
    import matplotlib

    matplotlib.use("svg")
    import matplotlib.pyplot as plt

    matplotlib.rcParams["svg.hashsalt"] = "groundslab"  # the same names inside the file each time
    every = [(key, label, points) for key, label, points in lines(results) if points]
    if not every:
        return
    figure_, axes = plt.subplots(figsize=(9, 6), layout="constrained")
    for key, _, points in every:
        colour, mark = COLOURS[key]
        ours = key in PLATES
        axes.loglog(*zip(*points, strict=True), color=colour, marker=mark, lw=2.2 if ours else 1.2, ms=6)
    last = max(points[-1][0] for _, _, points in every)
    low, high = axes.get_ylim()
    decades = math.log10(high / low)
    places = spread([math.log10(points[-1][1]) for _, _, points in every], 0.045 * decades)
    for (key, label, points), place in zip(every, places, strict=True):
        x, y = points[-1]
        axes.annotate(
            label, xy=(x, y), xytext=(1.25 * last, 10**place), color=COLOURS[key][0], va="center", fontsize=9,
            fontweight="bold" if key in PLATES else "normal",
            arrowprops={"arrowstyle": "-", "color": COLOURS[key][0], "lw": 0.5, "shrinkB": 3, "relpos": (0, 0.5)},
            annotation_clip=False,
        )  # fmt: skip
    axes.set_xlabel("unknowns")
    axes.set_ylabel("time from mesh to solution [s]")
    axes.set_xlim(right=1.15 * last)
    axes.grid(which="major", alpha=0.3)
    axes.spines[["top", "right"]].set_visible(False)
    figure_.savefig(path, metadata={"Date": None, "Creator": None})
    plt.close(figure_)


def main(words: Sequence[str]) -> None:
    """Write tables and picture."""
    results = json.loads(Path(words[0] if words else RESULTS).read_text(encoding="utf-8"))
    accuracies = json.loads(ACCURACIES.read_text(encoding="utf-8"))
    PAGE.write_text(filled(PAGE.read_text(encoding="utf-8"), tables(results, accuracies)), encoding="utf-8")
    draw(results, PICTURE)
    told_report.draw(told_report.all_told(), TOLD)


if __name__ == "__main__":
    main(sys.argv[1:])
