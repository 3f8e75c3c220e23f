"""Draws which folder of the package imports which, as a Mermaid diagram for docs/architecture.md."""

from __future__ import annotations

import grimp

PACKAGE = "groundslab"
#: The only import that goes up: a method for convenience.
UP = ("results", "views")
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


def diagram() -> str:
    """Return the diagram: an arrow from each folder to those that it imports, unless a longer way leads there."""
    below = imports()
    below[UP[0]].discard(UP[1])
    reached: dict[str, set[str]] = {}
    for top, _ in sorted(levels(below).items(), key=lambda each: each[1]):
        reached[top] = below[top].union(*(reached[each] for each in below[top]))
    lines = ["```mermaid", "graph TD"]
    for top, _ in sorted(levels(below).items(), key=lambda each: (-each[1], each[0])):
        if top in COMMON:
            continue
        direct = below[top] - set().union(*(reached[each] for each in below[top])) - set(COMMON)
        lines += [f"    {top} --> {each}" for each in sorted(direct)] or [f"    {top}"]
    lines += [f"    {UP[0]} -. Results.plot .-> {UP[1]}", "```"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    found = imports()
    found[UP[0]].discard(UP[1])
    arrows = sum(map(len, found.values()))
    print(
        diagram(), f"{len(found)} folders and modules, {max(levels(found).values())} levels, {arrows} arrows", sep="\n"
    )
