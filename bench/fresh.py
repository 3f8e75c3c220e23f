"""groundslab as one of the programs of the bench: one job in a fresh process, printed as the peers print theirs.

python bench/fresh.py 25000
python bench/fresh.py accuracy 0.01      # on the mesh that is made for it
"""

from __future__ import annotations

import json
import resource
import sys
import time
from pathlib import Path

from job import model_of, settlements

import groundslab
from groundslab.accuracy.judgment import judge
from groundslab.analysis import driver

sys.path.append(str(Path(__file__).parent / "peers"))
from first_plate import LOADED, Q


def main(unknowns: int, accuracy: float | None = None) -> None:
    """Solve the plate and print the figures."""
    start = time.perf_counter()
    square = {"kind": "patch", "q": Q, "x": (-LOADED, LOADED), "y": (-LOADED, LOADED)}
    model = model_of("winkler", unknowns).replace(loads=[square])
    if accuracy is not None:
        model = model.replace(mesh={"accuracy": accuracy})
    results = driver.solve(model).only
    x, y = results.plate.nodes.T
    figures = {
        "program": "groundslab",
        "version": groundslab.__version__,
        "element": "nine nodes, MITC9, gaps as unknowns",
        "solver": results.solver,
        "unknowns": results.unknowns,
        "total [s]": time.perf_counter() - start,
        "iterations": max(step.iteration for step in results.steps if step.finest),
        **settlements(results),
        "moment at the centre [N]": float(results.plate.moment_x[(x**2 + y**2).argmin()]),
        "largest error told": max((each.share for each in judge(results)), default=None),
        "peak memory [MiB]": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    }
    print(json.dumps(figures))


if __name__ == "__main__":
    if sys.argv[1] == "accuracy":
        main(6734, float(sys.argv[2]))
    else:
        main(int(sys.argv[1]))
