"""The report for people: what was taken from a file, what was taken in another way, what was left out, and why."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from groundslab.schema.wording import printable

#: Names that are listed for one reason, at most.
MOST_NAMES = 12


@dataclass(frozen=True, slots=True)
class ReportLine:
    """What became of one object: its kind (sheet or class) and name, whether it was taken, and as what or why not.

    A note on something that was taken in another way than it says has ``taken`` None.
    """

    kind: str
    name: str
    taken: bool | None
    why: str


def report_lines(report: Sequence[ReportLine], heading: str) -> Iterator[str]:
    """Yield the lines of a report: counts by kind, notes, then the objects left out and taken by reason."""
    counts: dict[str, Counter[bool]] = {}
    for line in report:
        if line.taken is not None:
            counts.setdefault(line.kind, Counter())[line.taken] += 1
    rows = [(heading, "taken", "left out")]
    rows += [(printable(kind), str(count[True]), str(count[False])) for kind, count in counts.items()]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        yield "  " + "  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip()
    for title, taken in (("taken in another way, or to be known", None), ("left out", False), ("taken", True)):
        chosen = [line for line in report if line.taken is taken]
        if chosen:
            yield ""
            yield f"{title}:"
            yield from _by_reason(chosen)


def _by_reason(lines: Sequence[ReportLine]) -> Iterator[str]:
    """Yield a line for each kind and reason, with the names that it is for."""
    names: dict[tuple[str, str], list[str]] = {}
    for line in lines:
        names.setdefault((line.kind, line.why), []).append(line.name)
    for (kind, why), group in names.items():
        shown = [printable(name) for name in group[:MOST_NAMES] if name]
        more = [f"{len(group) - MOST_NAMES} more"] if len(group) > MOST_NAMES else []
        which = f" {', '.join([*shown, *more])}" if shown else ""
        yield f"  {printable(kind)}{which}: {printable(why)}"
