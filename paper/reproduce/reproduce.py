"""Repeats the figure and every number of paper.md, and fails if one differs.

    python paper/reproduce/reproduce.py            # compares; some minutes
    python paper/reproduce/reproduce.py --write    # writes the numbers into paper.md, and the figure beside it
    python paper/reproduce/reproduce.py --stored   # takes what needs solutions from numbers.json; a second

A number of the paper is followed by its name in a comment: `11.2<!-- own seconds -->`. Times and errors of the
benchmark come from bench/results.json; everything else is computed here.
"""

from __future__ import annotations

import argparse
import itertools
import json
import re
import sys
import tempfile
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import groundslab

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PAPER, FIGURE, STORED = HERE.parent / "paper.md", HERE.parent / "figure.png", HERE / "numbers.json"
BENCH = ROOT / "bench"
sys.path.insert(0, str(BENCH))
import report  # noqa: E402

#: A number, and its name in a comment behind it.
NUMBER = re.compile(r"(\d[\d,]*(?:\.\d+)?)<!-- ([a-z ]+) -->")
#: Where digits are no figures of ours: the YAML head, the table, code, sources, names.
OTHERS = (r"\A---.*?\n---\n", r"<!-- begin \w+ -->.*?<!-- end \w+ -->", r"`[^`]*`", r"@\w+", r"\bMITC9\b", r"EBBEF2p")
STATED = {"3.11", "250,000", "5"}  # Python's version, the size that jobs aim at, the default of mesh.accuracy
SIZE, LARGEST = "250k", "1M"


def verification() -> dict[str, str]:
    """Return how many cases and rows `groundslab verify` has, and with which verdicts."""
    from groundslab.verification import runner

    cases = [runner.load(name) for name in runner.case_names()]
    missing = [case.name for case in cases if not runner.can_run(case)]
    if missing:
        raise SystemExit(f"{', '.join(missing)}: needs Gmsh or Netgen (the extra mesh or netgen)")
    outcomes = [outcome for case in cases for outcome in runner.outcomes_of(case)]
    failed = [outcome.label for outcome in outcomes if not outcome.ok]
    if failed:
        raise SystemExit(f"rows of the verification fail: {', '.join(failed)}")
    verdicts = Counter(outcome.verdict for outcome in outcomes)
    return {
        "cases": str(len(cases)),
        "rows": str(len(outcomes)),
        "agree": str(verdicts["agrees"]),
        "differ": str(verdicts["differs, as explained"]),
        "refuted": str(verdicts["cannot be right"]),
    }


def example(figure: Path | None) -> dict[str, str]:
    """Return the figures of the paper's first example; draw it if a file is given."""
    results = groundslab.solve(groundslab.load(ROOT / "examples" / "table1.toml")).only
    plate = results.plate
    if figure is not None:
        with tempfile.TemporaryDirectory() as folder:
            drawn = Path(folder) / "figure.png"
            results.plot("settlement", "pressure", to=drawn)
            with Image.open(drawn) as picture:
                picture.convert("RGB").quantize(64).save(figure, optimize=True)
    touching = float(plate.area[plate.in_contact].sum() / plate.area.sum())
    return {
        "example settlement": f"{1e3 * plate.value_at('settlement', 0.0, 0.0):.1f}",
        "example uplift": f"{-1e3 * plate.settlement.min():.1f}",
        "example contact": f"{100 * touching:.0f}",
        "example unknowns": f"{results.unknowns:,}",
    }


def random_slabs() -> dict[str, str]:
    """Return what bench/random_slabs.py has found."""
    by_accuracy = json.loads((BENCH / "random_slabs.json").read_text(encoding="utf-8"))
    asked, found = next(iter(by_accuracy.items()))
    accuracy = float(asked.removesuffix(" %")) / 100
    true, told = (np.array(list(itertools.chain(*(row[name] for row in found)))) for name in ("true", "told"))
    return {
        "slabs": str(len(found)),
        "asked": f"{100 * accuracy:g}",
        "values": f"{true.size:,}",
        "within": f"{100 * (true <= accuracy).mean():.1f}",
        "false": f"{100 * ((told <= accuracy) & (true > accuracy)).mean():.1f}",
    }


def benchmark() -> dict[str, str]:
    """Return figures of bench/results.json, and of the scripts that solve the plate in other programs."""
    results = json.loads((BENCH / "results.json").read_text(encoding="utf-8"))
    own, small = results["own"]["winkler"][LARGEST], results["small"]
    iterations = report.worst("iterations on the finest mesh", report.TENSIONLESS)(results)
    others = [
        row["median"]
        for name, row in small.items()
        if "median" in row and not name.startswith((report.OWN, report.NUMPY))
    ]
    lengths = [len(file.read_text(encoding="utf-8").splitlines()) for file in (BENCH / "peers").glob("*.py")]
    return {
        "shortest": str(min(lengths)),
        "longest": str(max(lengths)),
        "own unknowns": f"{own['unknowns']:,}",
        "own seconds": report.figure(own["total [s]"]),
        "own ratio": report.figure(own["total / bare"]),
        "iterations": report.figure(iterations.value),
        "small": report.figure(small[report.OWN]["median"] / min(others)),
    }


def peers() -> str:
    """Return the table that compares programs at one size."""
    results = json.loads((BENCH / "results.json").read_text(encoding="utf-8"))
    to, rows = report.reference(results), []
    ours = results["peers"][report.OWN][SIZE]["total [s]"]
    for name, sizes in results["peers"].items():
        row: Mapping[str, Any] = sizes[SIZE]
        if "unknowns" not in row:
            rows.append([name, "", report.missing(row, results), "", "", ""])
            continue
        errors = [report.scientific(report.error(row, place, to), to, place) for place in report.PLACES]
        time = row["total [s]"]
        rows.append([name, f"{row['unknowns']:,}", report.figure(time), report.figure(time / ours), *errors])
    head = ["program", "unknowns", "seconds", "times ours", "error in the middle", "error at a corner"]
    cpu, cores = results["machine"]["CPU"], results["machine"]["cores"]
    caption = f"Table: Seconds from mesh to solution on {cores} cores ({cpu}), and relative errors of two settlements."
    return f"{report.table(head, rows)}\n\n{caption} \\label{{tab:peers}}"


def filled(text: str, numbers: Mapping[str, str], table: str) -> str:
    """Return the paper with these numbers and this table; raises KeyError if it names a number that is none."""
    text = NUMBER.sub(lambda found: f"{numbers[found[2]]}<!-- {found[2]} -->", text)
    return report.filled(text, {"peers": table})


def problems(text: str, numbers: Mapping[str, str], table: str) -> list[str]:
    """Return what is wrong with the paper: numbers that differ, are not used, or have no name."""
    printed = NUMBER.findall(text)
    found = [f"{name}: {number} is printed, {numbers.get(name)} found" for number, name in printed]
    found = [line for line, (number, name) in zip(found, printed, strict=True) if numbers.get(name) != number]
    found += [f"{name} is not printed" for name in sorted(numbers.keys() - {name for _, name in printed})]
    if report.filled(text, {"peers": table}) != text:
        found.append("the table differs")
    prose = NUMBER.sub("", text)
    for pattern in OTHERS:
        prose = re.sub(pattern, "", prose, flags=re.DOTALL)
    unnamed = set(re.findall(r"\d[\d.,]*\d|\d", prose)) - STATED
    return found + [f"{number} has no name" for number in sorted(unnamed)]


def main() -> int:
    """Compare or write; return 1 if the paper differs."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="write numbers, table and figure")
    parser.add_argument("--stored", action="store_true", help="take what needs solutions from numbers.json")
    given = parser.parse_args()
    solved = json.loads(STORED.read_text(encoding="utf-8")) if STORED.exists() else {}
    if not given.stored:
        before, solved = solved, {**verification(), **example(FIGURE if given.write else None)}
        if given.write:
            STORED.write_text(json.dumps(solved, indent=2) + "\n", encoding="utf-8")
        elif solved != before:
            print(f"{STORED.name} differs")
            return 1
    numbers, table = {**solved, **random_slabs(), **benchmark()}, peers()
    text = PAPER.read_text(encoding="utf-8")
    if given.write:
        text = filled(text, numbers, table)
        PAPER.write_text(text, encoding="utf-8")
    wrong = problems(text, numbers, table)
    print("\n".join(wrong) if wrong else f"all {len(numbers)} numbers and the table hold")
    return 1 if wrong else 0


if __name__ == "__main__":
    raise SystemExit(main())
