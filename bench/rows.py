"""How many rows a second Dask's scheduler, the transport and the store take, whatever the variants cost.

    python bench/rows.py                       # 50 workers whose variants sleep 5, 20, 100 and 300 ms
    python bench/rows.py --workers 50 --sleep 0.005 --rows 200000

Variants are replaced by sleeps on threads of five processes, so that two cores can play many workers; scheduler and
store run as in a study on a cluster. The pace is that from the first rows to the last.
"""

from __future__ import annotations

import argparse
import resource
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

import dask
import distributed
from job import model_of, scattering

from groundslab.study.execution import dask_plugin, runner
from groundslab.study.execution.dask_cluster import SETTINGS
from groundslab.study.execution.variant import SOLVED, Row
from groundslab.study.sampling.designs import Variant

PROCESSES = 5
#: Dask's configuration, less what is for processes that a study starts itself.
SCHEDULING = {name: value for name, value in SETTINGS.items() if not name.endswith(("routes", "preload"))}
#: Seconds that variants sleep, and about how long each pace is measured [s].
SLEEPS, DURATION = (0.005, 0.02, 0.1, 0.3), 10


def sleeping(seconds: float) -> type[dask_plugin.Plugin]:
    """Return the plugin of workers that sleep instead of solving a variant."""

    class Sleeping(dask_plugin.Plugin):
        def row(self, variant: Variant, known_meshes: Sequence[str]) -> Row:  # noqa: ARG002
            time.sleep(seconds)
            return Row(variant.number, SOLVED, "", "", seconds, (*variant.values, *variant.seeds), (1.0,))

    return Sleeping


def pace(workers: int, seconds: float, count: int) -> str:
    """Return the rows a second of a study, and what the process that keeps them needed."""
    dask_plugin.Plugin = sleeping(seconds)  # type: ignore[misc]
    seen: list[tuple[float, int]] = []
    threads = workers // PROCESSES
    with (
        dask.config.set(SCHEDULING),
        distributed.LocalCluster(
            n_workers=PROCESSES, threads_per_worker=threads, host="127.0.0.1", dashboard_address=None
        ) as cluster,
        tempfile.TemporaryDirectory() as folder,
    ):
        study = scattering(model_of("pasternak", 6734), count)
        where = runner.Resources(scheduler=cluster.scheduler_address)
        runner.run(
            study, Path(folder) / "study", where, False,
            lambda progress: seen.append((time.perf_counter(), progress.rows)),
        )  # fmt: skip
        size = (Path(folder) / "study" / "rows.sqlite").stat().st_size / count
    (begin, first), (end, last) = next(each for each in seen if each[1]), seen[-1]
    assert last == count
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return (
        f"{threads * PROCESSES} workers, variants of {seconds} s: {(last - first) / (end - begin):.0f} rows/s of "
        f"{threads * PROCESSES / seconds:.0f}, {size:.0f} bytes a row, at most {memory:.0f} MiB"
    )


def main() -> None:
    """Print the pace for each duration of a variant."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--workers", type=int, default=50, help="threads that sleep (50)")
    parser.add_argument("--sleep", type=float, help="seconds that a variant sleeps (5, 20, 100 and 300 ms)")
    parser.add_argument("--rows", type=int, help="how many variants (as many as take about ten seconds)")
    given = parser.parse_args()
    for seconds in SLEEPS if given.sleep is None else (given.sleep,):
        print(pace(given.workers, seconds, given.rows or int(DURATION * given.workers / seconds)), flush=True)


if __name__ == "__main__":
    main()
