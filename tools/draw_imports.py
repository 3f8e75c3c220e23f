"""Draws which folder of the package imports which, as a Mermaid diagram for docs/architecture.md or as a picture.

python tools/draw_imports.py                     # Mermaid
python tools/draw_imports.py docs/imports.svg    # a picture, for the site
"""

from __future__ import annotations

import sys

import grimp

PACKAGE = "groundslab"
#: Imported by nearly everything; their arrows would hide the others.
COMMON = ("_version", "arrays", "errors")


def imports() -> dict[str, set[str]]:
    """Return for each folder or module at the top of the package what it imports of the others."""
    graph = grimp.build_graph(PACKAGE)
    tops = {module.removeprefix(f"{PACKAGE}.") for module in graph.find_children(PACKAGE)}
    found: dict[str, set[str]] = {top: set() for top in tops}
    for module in graph.modules - {PACKAGE}:
        importer = module.split(".")[1]
        for imported in graph.find_modules_directly_imported_by(module):
            if imported != PACKAGE and imported.split(".")[1] != importer:
                found[importer].add(imported.split(".")[1])
    return found


def levels(below: dict[str, set[str]]) -> dict[str, int]:
    """Return the level of each folder: one above the highest of those that it imports, 1 for those without imports."""
    found: dict[str, int] = {}
    while len(found) < len(below):
        ready = [top for top, imported in below.items() if top not in found and imported <= found.keys()]
        if not ready:
            raise ValueError(f"imports in a circle among {sorted(below.keys() - found.keys())}")
        found |= {top: 1 + max((found[each] for each in below[top]), default=0) for top in ready}
    return found


def direct_imports() -> tuple[dict[str, int], dict[str, set[str]]]:
    """Return the level of each folder, and what it imports less what a longer way leads to."""
    below = imports()
    level, reached = levels(below), dict[str, set[str]]()
    for top in sorted(level, key=level.__getitem__):
        reached[top] = below[top].union(*(reached[each] for each in below[top]))
    shown = sorted(below.keys() - set(COMMON), key=lambda top: (-level[top], top))
    direct = {top: below[top] - set().union(*(reached[each] for each in below[top])) - set(COMMON) for top in shown}
    return level, direct


def diagram() -> str:
    """Return the diagram: an arrow from each folder to those that it imports, unless a longer way leads there."""
    lines = ["```mermaid", "graph TD"]
    for top, imported in direct_imports()[1].items():
        lines += [f"    {top} --> {each}" for each in sorted(imported)] or [f"    {top}"]
    return "\n".join([*lines, "```"]) + "\n"


def draw(path: str) -> None:
    """Draw the same as a picture, higher levels further up."""
    from matplotlib.figure import Figure

    level, direct = direct_imports()
    rows: dict[int, list[str]] = {}
    for top in direct:
        rows.setdefault(level[top], []).append(top)
    at = {top: (i - (len(row) - 1) / 2, height) for height, row in rows.items() for i, top in enumerate(row)}
    figure = Figure(figsize=(7, 0.55 * max(rows)), layout="constrained")
    axes = figure.add_subplot()
    axes.set(xlim=(-2, 2), ylim=(min(rows) - 0.5, max(rows) + 0.5))
    axes.axis("off")
    for start, end in [(top, below) for top, imported in direct.items() for below in imported]:
        bend = 0.25 if abs(at[start][1] - at[end][1]) > 1 else 0.0
        style = {"arrowstyle": "-|>", "color": "#777777", "shrinkA": 9, "shrinkB": 9}
        axes.annotate("", at[end], at[start], arrowprops={**style, "connectionstyle": f"arc3,rad={bend}"})
    for top, (x, y) in at.items():
        box = {"boxstyle": "round,pad=0.35", "facecolor": "#eef2f7", "edgecolor": "#456"}
        axes.text(x, y, top, ha="center", va="center", family="monospace", fontsize=9, bbox=box)
    figure.savefig(path, metadata={"Date": None})


if __name__ == "__main__" and len(sys.argv) > 1:
    draw(sys.argv[1])
elif __name__ == "__main__":
    below = imports()
    arrows = sum(map(len, below.values()))
    print(
        diagram(), f"{len(below)} folders and modules, {max(levels(below).values())} levels, {arrows} arrows", sep="\n"
    )
