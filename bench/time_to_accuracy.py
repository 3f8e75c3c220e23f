"""Seconds to an accuracy: the paper's first plate, under its load and under a small one, here and in other programs.

    python3 bench/time_to_accuracy.py            # half an hour; writes bench/time_to_accuracy.json
    bench/.env/own/bin/python bench/report.py    # and docs/performance.md

The moment m_x and the settlement at the centre, and the uplift of the corner. groundslab makes its mesh from
mesh.accuracy, and its time is that of all meshes on the way. The other programs, and groundslab once more, get a row of
uniform meshes that follow the edge of the load: the first counts from which on errors stay within the accuracy, with
hindsight, as none of these programs tells its error. Errors are taken against the mean of two fine uniform meshes, one
by groundslab and one by NGSolve. Each run has a fresh process, the median of several counts.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import sys
from pathlib import Path
from typing import Any

import run

sys.path.append(str(Path(__file__).parent / "peers"))
from first_plate import PAPERS, unknowns_of

RESULTS = Path(__file__).parent / "time_to_accuracy.json"
#: Sides of the loaded square [m], accuracies, and what is compared.
LOADED = (2.4, 0.3)
LIMITS = (0.01, 0.001)
VALUES = {
    "moment": "moment at the centre [N]",
    "settlement": "settlement at the centre [m]",
    "uplift": "settlement at the corner [m]",
}
#: The programs with the order of their elements; the fine meshes of the reference have about so many unknowns.
ORDERS = {run.OWN: 2, "NGSolve, order 2": 2, "NGSolve, order 4": 4, "scikit-fem, PARDISO": 2, "OpenSeesPy": 1}
FINE = ((run.OWN, 700_000), ("NGSolve, order 4", 500_000))
#: Whole elements along the edge of the load of each mesh of a row; no mesh has more unknowns.
ROW = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96)
MOST_UNKNOWNS = 600_000


def command(name: str, m: int) -> list[str]:
    """Return the words after Python that run a program on 4 m by 3 m elements."""
    # job.py counts by its quarter of 24 x 18 elements
    unknowns = round(6734 * (m / 6) ** 2) if name == run.OWN else unknowns_of(m, ORDERS[name])
    script, _, *options = run.PEERS[name].command("6k")
    return [script, str(unknowns), *options]


def solve(name: str, words: list[str], times: int) -> dict[str, Any]:
    """Return the figures of a program's runs, of times the medians."""
    found = run.repeated(run.PEERS[name].environment, words, times)
    run.tell(found)
    return found


def fine(name: str, unknowns: int, step: int) -> dict[str, Any]:
    """Return the figures on a fine mesh."""
    m = step
    while unknowns_of(m + step, ORDERS[name]) < unknowns:
        m += step
    return solve(name, command(name, m), 1)


def errors(figures: dict[str, Any], reference: dict[str, float]) -> dict[str, float]:
    """Return the relative errors of all values."""
    return {value: abs(figures[key] / reference[value] - 1) for value, key in VALUES.items()}


def uniform(name: str, reference: dict[str, float], step: int, times: int) -> list[dict[str, Any]]:
    """Return the figures of a row of meshes, up to the second in turn that is as accurate as any limit."""
    row: list[dict[str, Any]] = []
    for m in (step * each for each in ROW):
        if unknowns_of(m, ORDERS[name]) > MOST_UNKNOWNS:
            break
        run.say(f"{name}, {4 * m} x {3 * m}")
        figures = solve(name, command(name, m), times)
        if "total [s]" not in figures:
            break
        row.append({**figures, "errors": errors(figures, reference)})
        if all(max(each["errors"].values()) <= min(LIMITS) for each in row[-2:]) and len(row) > 1:
            break
    return row


def examine(side: float, names: list[str], times: int) -> dict[str, Any]:
    """Return what came out for one load."""
    os.environ["LOADED"] = str(side / 2)
    step = round(2 * PAPERS / side)
    run.say(f"square of {side} m: reference")
    finest = [fine(name, unknowns, step) for name, unknowns in FINE]
    reference = {value: statistics.mean(each[key] for each in finest) for value, key in VALUES.items()}
    adaptive = []
    for limit in LIMITS:
        run.say(f"{run.OWN}, mesh.accuracy = {limit}")
        figures = solve(run.OWN, ["bench/fresh.py", "accuracy", str(limit)], times)
        adaptive.append({**figures, "errors": errors(figures, reference)})
    return {
        "reference": reference,
        "apart": {value: abs(finest[0][key] / finest[1][key] - 1) for value, key in VALUES.items()},
        "adaptive": adaptive,
        "uniform": {name: uniform(name, reference, step, times) for name in names},
    }


def main() -> None:
    """Run everything and keep it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--times", type=int, default=3, help="how often each job runs (3)")
    given = parser.parse_args()
    run.ENVIRONMENTS.mkdir(exist_ok=True)
    for environment in dict.fromkeys(run.PEERS[name].environment for name in ORDERS):
        run.prepare(environment)
    found = {str(side): examine(side, list(ORDERS), given.times) for side in LOADED}
    results = {**run.circumstances(), "limits": LIMITS, "loads": found}
    RESULTS.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
