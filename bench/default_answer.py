"""The answer without a described mesh: how large meshes become, what they cost, and what error is told.

    python bench/default_answer.py CASE.toml ...        # by default all of bench/slabs

Size, counts and refinements are taken out of each case, its accuracy stays. A line for each case: the unknowns of the
first and of the last mesh, how many meshes, combinations, seconds of the processor, these over the seconds that the
same combinations take on the last mesh alone, the largest judged error, and what it is of.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import groundslab
from groundslab.accuracy.judgment import judge
from groundslab.results.results import Results

SLABS = Path(__file__).parent / "slabs"


def largest_error(results: Results) -> tuple[float, str]:
    """Return the largest judged error of all combinations, and what it is of."""
    judged = [value for combination in results.values() for value in judge(combination)]
    worst = max(judged, key=lambda value: value.share, default=None)
    return (float("nan"), "unknown") if worst is None else (worst.share, worst.label)


def examine(path: Path) -> str:
    """Return the line of one case."""
    model = groundslab.load(path)
    mesh = model.mesh.model_copy(update={"size": None, "counts": None, "refine": ()})
    model = model.model_copy(update={"mesh": mesh})
    meshes: list[int] = []
    ended: list[float] = [time.process_time()]

    def on_mesh(results: Results) -> None:
        meshes.append(next(iter(results.values())).unknowns)
        ended.append(time.process_time())

    results = groundslab.solve(model, on_mesh=on_mesh)
    now = time.process_time()
    on_mesh(results)
    seconds = now - ended[0]
    error, label = largest_error(results)
    return (
        f"{path.stem:28} {meshes[0]:>8,} {meshes[-1]:>8,} {len(meshes):>2} {len(results.combinations):>3} "
        f"{seconds:7.1f} s {seconds / (now - ended[-2]):5.1f} {100 * error:6.2g} % {label}"
    )


def main() -> None:
    """Examine the cases that are named, or all of the folder."""
    for path in map(Path, sys.argv[1:] or sorted(SLABS.glob("*.toml"))):
        print(examine(path), flush=True)


if __name__ == "__main__":
    main()
