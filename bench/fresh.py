"""groundslab as one of the programs of the bench: one job in a fresh process, printed as the peers print theirs.

python bench/fresh.py 25000
"""

from __future__ import annotations

import json
import resource
import sys
import time

from job import model_of, settlements

import groundslab
from groundslab.analysis import driver


def main(unknowns: int) -> None:
    """Solve the plate and print the figures."""
    start = time.perf_counter()
    results = driver.solve(model_of("winkler", unknowns)).only
    figures = {
        "program": "groundslab",
        "version": groundslab.__version__,
        "element": "nine nodes, MITC9, gaps as unknowns",
        "solver": results.solver,
        "unknowns": results.unknowns,
        "total [s]": time.perf_counter() - start,
        "iterations": max(step.iteration for step in results.steps if step.finest),
        **settlements(results),
        "peak memory [MiB]": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    }
    print(json.dumps(figures))


if __name__ == "__main__":
    main(int(sys.argv[1]))
