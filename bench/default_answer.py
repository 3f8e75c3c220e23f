"""The answer without a described mesh: how large meshes become, what they cost, and what error is told.

    python bench/default_answer.py                      # all of bench/slabs, into bench/default_answer.json
    python bench/default_answer.py CASE.toml ...        # some cases, printed alone

Size, counts and refinements are taken out of each case, its accuracy stays. Each case is solved by a process of its
own on one thread, which is given up after some minutes. A line for each: the unknowns of the first and of the last
mesh, how many meshes, combinations, seconds of the processor, these over the seconds that the last mesh takes, the
largest judged error, what it is of, and the accuracy.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
SLABS, RESULTS = HERE / "slabs", HERE / "default_answer.json"
#: A case is given up after so many seconds.
LIMIT = 500.0

Row = dict[str, Any]


def examine(path: Path) -> Row:
    """Return what came out for one case."""
    import groundslab
    from groundslab.accuracy.judgment import judge
    from groundslab.results.results import Results

    model = groundslab.load(path)
    mesh = model.mesh.model_copy(update={"size": None, "counts": None, "refine": ()})
    model = model.model_copy(update={"mesh": mesh})
    ended = [time.process_time()]

    def on_mesh(_: Results) -> None:
        ended.append(time.process_time())

    results = groundslab.solve(model, on_mesh=on_mesh)
    ended.append(time.process_time())
    judged = (value for combination in results.values() for value in judge(combination))
    worst = max(judged, key=lambda value: value.share)
    history = next(iter(results.values())).mesh_history
    assert history is not None
    return {
        "slab": path.stem, "unknowns": history.unknowns, "combinations": len(results.combinations),
        "seconds": round(ended[-1] - ended[0], 1), "ratio": round((ended[-1] - ended[0]) / (ended[-1] - ended[-2]), 1),
        "error": worst.share, "of": worst.label, "accuracy": mesh.largest_error,
    }  # fmt: skip


def run(path: Path) -> Row:
    """Return what came out for one case in a process of its own, its name alone if that took too long."""
    environment = os.environ | dict.fromkeys(("OMP_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    command = [sys.executable, __file__, "--here", str(path)]
    try:
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True, timeout=LIMIT, check=True)
    except subprocess.TimeoutExpired:
        return {"slab": path.stem}
    row: Row = json.loads(done.stdout)
    return row


def line(row: Row) -> str:
    """Return the line of a case."""
    if "unknowns" not in row:
        return f"{row['slab']:28} none in {LIMIT:g} s"
    made = row["unknowns"]
    told = f"{100 * row['error']:6.2g} % {row['of']} ({100 * row['accuracy']:g} %)"
    return (
        f"{row['slab']:28} {made[0]:>8,} {made[-1]:>8,} {len(made):>2} {row['combinations']:>3} "
        f"{row['seconds']:7.1f} s {row['ratio']:5.1f} {told}"
    )


def main(arguments: list[str]) -> None:
    """Examine the cases that are named, or all of the folder and store what came out."""
    if arguments[:1] == ["--here"]:
        print(json.dumps(examine(Path(arguments[1]))))
        return
    rows = []
    for path in map(Path, arguments or sorted(SLABS.glob("*.toml"))):
        rows.append(run(path))
        print(line(rows[-1]), flush=True)
    if not arguments:
        RESULTS.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
