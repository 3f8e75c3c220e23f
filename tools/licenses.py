"""Lists what an installation brings along, with versions and licenses, and writes the table of docs/licenses.md.

    python tools/licenses.py            # prints the list
    python tools/licenses.py --write    # and writes the table, which has no versions

Both hold for the packages that are installed beside groundslab, on this system. `make licenses` runs it where nothing
but groundslab with all extras is installed, and adds a bill of materials (CycloneDX).
"""

from __future__ import annotations

import re
import sys
from collections import defaultdict
from importlib import metadata
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

PAGE = Path(__file__).resolve().parent.parent / "docs" / "licenses.md"
PACKAGE = "groundslab"
#: What brings a package along that is no extra's.
REQUIRED = "groundslab itself"
#: What the packages' metadata leave out: cvxopt's names no license, its file LICENSE does.
STATED = {"cvxopt": "GPL-3.0-or-later"}
GPL = re.compile(r"(?<!Lesser )General Public License|(?<![A-Z])GPL")


def brought_along(extra: str = "") -> set[str]:
    """Return the packages that groundslab, or one of its extras, needs on this system, directly or not."""
    # A requirement of the extra has a marker that only the extra fulfills.
    found: dict[str, set[str]] = {PACKAGE: {extra}}
    todo = [PACKAGE]
    while todo:
        name = todo.pop()
        for each in map(Requirement, metadata.requires(name) or []):
            wanted = [each.marker is None or each.marker.evaluate({"extra": part}) for part in found[name]]
            needed = canonicalize_name(each.name)
            if any(wanted) and needed != PACKAGE and not {"", *each.extras} <= found.get(needed, set()):
                found.setdefault(needed, set()).update({"", *each.extras})
                todo.append(needed)
    return set(found) - {PACKAGE}


def license_of(name: str) -> str:
    """Return the license of an installed package: its SPDX expression, else its classifiers, else its first words."""
    about = metadata.metadata(name)
    classifiers = [line.split(" :: ")[-1] for line in about.get_all("Classifier") or [] if line.startswith("License")]
    words = (about.get("License") or "").strip().splitlines() or ["not stated"]
    if STATED.get(name) or about.get("License-Expression"):
        return STATED.get(name) or about["License-Expression"]
    vague = not classifiers or classifiers == ["Other/Proprietary License"]
    return words[0] if vague else ", ".join(classifiers)


def is_gpl(name: str) -> bool:
    """Return whether an installed package is under the GPL, which the LGPL is not."""
    return bool(GPL.search(license_of(name)))


def origins() -> dict[str, list[str]]:
    """Return each package with what brings it along: groundslab itself, or else the extras that do."""
    found: dict[str, list[str]] = defaultdict(list)
    required = brought_along()
    for name in required:
        found[name].append(REQUIRED)
    extras = set(metadata.metadata(PACKAGE).get_all("Provides-Extra") or []) - {"all"}
    for extra in sorted(extras):
        for name in brought_along(extra) - required:
            found[name].append(f"`{extra}`")
    return dict(found)


def table() -> str:
    """Return the table of docs/licenses.md: a row for each origin and license."""
    rows: dict[tuple[str, str], list[str]] = defaultdict(list)
    for name, origin in sorted(origins().items()):
        rows[", ".join(origin), license_of(name)].append(name)
    ordered = sorted(rows.items(), key=lambda row: (row[0][0] != REQUIRED, row[0]))
    lines = [f"| {origin} | {stated} | {', '.join(names)} |" for (origin, stated), names in ordered]
    return "\n".join(["| comes with | license | packages |", "|---|---|---|", *lines])


def main(write: bool) -> None:
    """Print the list, and write the table if asked to."""
    for name, origin in sorted(origins().items()):
        print(f"{name:24}{metadata.version(name):14}{license_of(name):56} {', '.join(origin)}")
    if write:
        begin, end = "<!-- licenses: begin -->", "<!-- licenses: end -->"
        text = PAGE.read_text(encoding="utf-8")
        before, after = text.split(begin)[0], text.split(end)[1]
        PAGE.write_text(f"{before}{begin}\n\n{table()}\n\n{end}{after}", encoding="utf-8")


if __name__ == "__main__":
    main("--write" in sys.argv[1:])
