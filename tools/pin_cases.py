"""Pins our own values of verification cases, so that a later change within the tolerance of a row is seen, too.

    python tools/pin_cases.py                   # all cases
    python tools/pin_cases.py table1 beam       # some

Prints each value that was pinned and has changed. Pin again only what a change was meant to move, and say why in its
commit.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from importlib.resources import files
from pathlib import Path

from groundslab.verification import runner

HEAD = "# Our own values of all rows, in their units. Written by tools/pin_cases.py; they prove nothing but a change.\n"


def main(names: Sequence[str]) -> None:
    """Solve cases, all if none is named, and write their values."""
    before = runner.pinned()
    pins = {name: dict(before.get(name, {})) for name in runner.case_names()}
    for name in names or pins:
        case = runner.load(name)
        if not runner.can_run(case):
            print(f"{name}: kept, it needs {case.needs}")
            continue
        outcomes = zip(case.rows, runner.outcomes_of(case), strict=True)
        pins[name] = {each.label: float(f"{each.computed:.9g}") for row, each in outcomes if "judged" not in row}
        for label, value in pins[name].items():
            was = before.get(name, {}).get(label)
            if was is not None and was != value:
                print(f"{name}, {label}: {value!r}, was {was!r}")
    path = Path(str(files("groundslab.verification") / "pinned.toml"))
    tables = (_table(name, values) for name, values in pins.items() if values)
    path.write_text(HEAD + "".join(tables), encoding="utf-8")


def _table(name: str, values: Mapping[str, float]) -> str:
    """Return a case's values as a table of TOML."""
    return f"\n[{name}]\n" + "".join(
        f"{json.dumps(label, ensure_ascii=False)} = {value!r}\n" for label, value in values.items()
    )


if __name__ == "__main__":
    main(sys.argv[1:])
