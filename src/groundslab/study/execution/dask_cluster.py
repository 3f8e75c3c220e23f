"""Solves variants on Dask: on the cores of this machine, or on an existing cluster.

The setup of a study is sent to each worker once, as a plugin that new and restarted workers get, too; tasks are small.
Only a few more tasks than there are threads are submitted at a time. Dask's scheduler reports the tasks of a worker
that died, here at once, elsewhere when several have died; `tasks` finds out which variant it was.

The processes of this machine talk to each other over TLS with keys that are made for the run and stay in their memory:
no other process can have them run anything.
"""

from __future__ import annotations

import functools
import gc
import itertools
import logging
import secrets
import socket
import time
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from groundslab.errors import GroundslabError, InputError, Issue
from groundslab.optional import import_optional
from groundslab.study.execution import versions
from groundslab.study.execution.tasks import Loss, Outcome, Tasks, describe_exit
from groundslab.study.execution.variant import WorkerFailure, describe_error

if TYPE_CHECKING:
    from groundslab.study.definition.setup import Setup
    from groundslab.study.execution.dask_plugin import ExitCodes
    from groundslab.study.execution.variant import Row
    from groundslab.study.sampling.designs import Variant

#: Tasks submitted for each thread: one runs, the others wait at the scheduler so that no thread idles. More are
#: submitted when half of them are done, as each submission costs the scheduler milliseconds, however many tasks it has.
TASKS_PER_THREAD = 16
#: Time limit of a connection [s].
CONNECT_TIMEOUT = 10.0
#: Time limit for the first worker of a cluster [s].
WORKER_TIMEOUT = 60.0
#: Interval at which the number of threads is updated, and missing workers are started [s].
UPDATE_INTERVAL = 2.0
#: Keeps a worker's libraries from starting threads that compete with the other workers.
ONE_THREAD = {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
#: Dask's configuration of the local cluster.
SETTINGS: dict[str, Any] = {
    "distributed.nanny.pre-spawn-environ": ONE_THREAD,
    # no task waits at a worker, where it would be lost if the worker died of another one
    "distributed.scheduler.worker-saturation": 1.0,
    # the first death is reported, and `tasks` finds out what it was of
    "distributed.scheduler.allowed-failures": 0,
    # profiling every few milliseconds makes small cases take a fifth longer
    "distributed.worker.profile.enabled": False,
    # each process would serve pages over HTTP
    "distributed.worker.http.routes": [],
    "distributed.worker.preload": ["groundslab.study.execution.dask_plugin"],
    # on a busy machine a process takes longer than Dask's 15 s to start anew; Dask would then stop it in the midst of a
    # variant, which would be blamed for it
    "distributed.deploy.lost-worker-timeout": "10 minutes",
}
INSTEAD = "--workers 0 does without it"
LOOPBACK = "127.0.0.1"
DASHBOARD = 8787  # port, where it is free


class LostScheduler(GroundslabError):
    """The connection to the cluster's scheduler is lost; rows written before are kept."""


@dataclass(frozen=True, slots=True)
class Cluster:
    """A connection to Dask's scheduler."""

    client: Any
    dashboard: str
    exit_codes: ExitCodes | None = None  # of the processes of a cluster that was made for the study

    @property
    def own(self) -> bool:
        """Whether the cluster was made for the study, and is closed with it."""
        return self.exit_codes is not None

    @property
    def threads(self) -> int:
        """Return the number of threads of all current workers; raises LostScheduler."""
        try:
            return sum(self.client.nthreads().values())
        except Exception as error:
            raise _lost(error) from error


@contextmanager
def start_local(workers: int | None, most: int, dashboard: bool = False) -> Iterator[Cluster]:
    """Start a cluster on this machine, of processes with one thread: one for each core by default, at most `most`.

    Connections need the keys made here. Dask's dashboard is optional.
    """
    distributed = _import_distributed()
    import dask.config
    import dask.system

    from groundslab.study.execution.dask_plugin import ExitCodes, Nanny

    # a forgotten client that is collected while an event loop starts would wait for the lock of that start
    gc.collect()
    exit_codes = ExitCodes()
    port = _free_port(DASHBOARD) if dashboard else 0
    pages: dict[str, list[str]] = {"distributed.scheduler.http.routes": []}
    if dashboard:
        # connections from its own pages only
        origins = [f"{LOOPBACK}:{port}", f"localhost:{port}"]
        pages = {"distributed.scheduler.dashboard.bokeh-application.allow_websocket_origin": origins}
    with dask.config.set(SETTINGS | pages):
        try:
            cluster = distributed.LocalCluster(
                n_workers=min(workers or dask.system.CPU_COUNT, most),
                threads_per_worker=1,
                worker_class=Nanny,
                exit_codes=exit_codes,
                host=LOOPBACK,
                protocol="tls://",
                # keys for this run alone, kept in memory
                security=distributed.Security.temporary(),
                dashboard_address=f"{LOOPBACK}:{port}",
                scheduler_kwargs={"dashboard": dashboard},
                silence_logs=logging.CRITICAL,
            )
        except RuntimeError as error:
            # each process imports the calling program, and runs it again if nothing guards it
            hint = 'call groundslab.study in a file, below if __name__ == "__main__":, or with workers=0'
            raise InputError([Issue("workers", f"none that start ({error})", "processes of Python", hint)]) from error
        with cluster, distributed.Client(cluster) as client, _all_workers(cluster):
            _restrict_pages(cluster.scheduler, dashboard)
            yield Cluster(client, cluster.dashboard_link if dashboard else "", exit_codes)


@contextmanager
def _all_workers(cluster: Any) -> Iterator[None]:
    """Start workers anew that Dask has given up: it does not restart one that could not start."""
    from tornado.ioloop import PeriodicCallback

    count = len(cluster.worker_spec)

    def restore() -> None:
        for name, nanny in list(cluster.workers.items()):
            if nanny.status.name in ("closed", "failed"):
                del cluster.workers[name]
        cluster.scale(count)

    again = PeriodicCallback(restore, 1e3 * UPDATE_INTERVAL)
    cluster.loop.add_callback(again.start)
    try:
        yield
    finally:
        cluster.loop.add_callback(again.stop)


def _restrict_pages(scheduler: Any, dashboard: bool) -> None:
    """Close the scheduler's HTTP port, or answer only requests for a name of the loopback."""
    if not dashboard:
        scheduler.http_server.stop()
        return
    from tornado.routing import HostMatches, Rule, RuleRouter

    here = HostMatches(r"^(127\.0\.0\.1|localhost)$")
    scheduler.http_server.request_callback = RuleRouter([Rule(here, scheduler.http_application)])


def _free_port(port: int) -> int:
    """Return a free port of the loopback, this one if possible."""
    with socket.socket() as tried:
        try:
            tried.bind((LOOPBACK, port))
        except OSError:
            return _free_port(0)
        free: int = tried.getsockname()[1]
        return free


@contextmanager
def connect(scheduler: str, setup: Setup) -> Iterator[Cluster]:
    """Connect to the cluster of a running scheduler; raises InputError if it cannot be used.

    For an address that begins with tls:// the keys are those that Dask's configuration names.
    """
    distributed = _import_distributed()
    # problems of the connection are reported in our own words
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)
    try:
        client = distributed.Client(scheduler, timeout=CONNECT_TIMEOUT)
    except (OSError, ValueError, TypeError, RuntimeError) as error:
        hint = ""
        if scheduler.startswith("tls:"):
            hint = "keys are those that distributed.comm.tls names in Dask's configuration; see docs/study.md"
        expected = 'a Dask scheduler such as "tcp://127.0.0.1:8786"'
        raise InputError([Issue("scheduler", f"{scheduler}: {error}", expected, hint)]) from None
    try:
        with suppress(TimeoutError):
            client.wait_for_workers(1, timeout=WORKER_TIMEOUT)
        if not client.nthreads():
            raise InputError([Issue("scheduler", f"{scheduler}, without workers", "at least one worker")])
        _require_same_versions(client, packages_of(setup))
        yield Cluster(client, client.dashboard_link)
    finally:
        with suppress(Exception):
            client.close(timeout=CONNECT_TIMEOUT if client.status == "running" else 0.1)


def rows(
    cluster: Cluster, name: str, setup: Setup, variants: Sequence[Variant], known_meshes: Callable[[], Sequence[str]]
) -> Generator[list[Row | WorkerFailure]]:
    """Yield the rows of variants as they are solved, in any order, several at a time if they come together.

    `name` is the study's on the cluster. Raises LostScheduler. Closing the generator early cancels pending tasks.
    """
    import distributed

    from groundslab.study.execution.dask_plugin import Plugin, solve

    client = cluster.client
    packages = packages_of(setup)
    client.register_plugin(
        Plugin(name, _for_workers(setup), packages, versions.versions(packages), cluster.own), name=name
    )
    run, serial, tasks = secrets.token_hex(4), itertools.count(), Tasks(variants)
    pending: dict[Any, Sequence[Variant]] = {}
    updated, threads = -UPDATE_INTERVAL, 1
    pool = distributed.as_completed([])
    try:
        while True:
            if time.monotonic() - updated > UPDATE_INTERVAL:
                updated, threads = time.monotonic(), max(1, cluster.threads)
            limit = TASKS_PER_THREAD * threads
            room = limit - len(pending) if len(pending) <= limit // 2 else 0
            if more := tasks.next(room, threads, idle=not pending):
                rows_of = functools.partial(solve, name, known_meshes=known_meshes())
                # a name that was used before may still stand for how that task ended
                keys = [f"{name}-{run}-{task[0].number}-{next(serial)}" for task in more]
                futures = client.map(rows_of, more, key=keys, pure=False)
                pending |= zip(futures, more, strict=True)
                pool.update(futures)
            if not pending:
                return
            ended = [future for future in next(pool.batches()) if future in pending]
            done: list[Row | WorkerFailure] = []
            for future, outcome in _outcomes(cluster, ended):
                if outcome is None:
                    pool.update([future])
                    continue
                task = pending.pop(future)
                if isinstance(outcome, str):
                    outcome = [WorkerFailure(variant.number, outcome) for variant in task]
                done += tasks.finish(task, outcome)
            if done:
                yield done
    finally:
        # a lost scheduler cannot cancel anything
        if client.status == "running":
            with suppress(Exception):
                client.cancel(list(pending), force=True)
                client.unregister_worker_plugin(name)


def _for_workers(setup: Setup) -> Setup:
    """Return a study without the distributions of its variables, whose values are drawn: importing them takes long."""
    return replace(setup, variables=tuple(replace(variable, distribution=None) for variable in setup.variables))


def _outcomes(cluster: Cluster, ended: Sequence[Any]) -> Iterator[tuple[Any, Outcome | str | None]]:
    """Yield each task that has ended with its rows, fetched together, or why it has none; raises LostScheduler.

    None: its rows are lost, as the worker died before they were fetched, and the scheduler has it solved again.
    """
    fetched = _fetch(cluster.client, [future for future in ended if future.status == "finished"])
    yield from fetched.items()
    for future in ended:
        if future not in fetched:
            status = future.status
            if status == "cancelled":
                raise _lost(None)
            yield future, _loss(cluster, future.exception()) if status == "error" else None


def _fetch(client: Any, finished: Sequence[Any]) -> dict[Any, Sequence[Row | WorkerFailure]]:
    """Return the rows of tasks by task, without those that failed after all; raises LostScheduler.

    The results of a worker that dies before they are fetched are made anew, beside other tasks, one of which may kill
    the worker that does it.
    """
    while finished:
        try:
            return dict(zip(finished, client.gather(finished), strict=True))
        except Exception as error:
            left = [future for future in finished if future.status != "error"]
            if len(left) == len(finished):
                raise _lost(error) from error
            finished = left
    return {}


def _loss(cluster: Cluster, error: BaseException) -> Loss | str:
    """Return why a task has no rows; as text, if trying again is of no use."""
    if type(error).__name__ == "KilledWorker":
        dead: Any = error
        code = cluster.exit_codes.wait(dead.last_worker.address) if cluster.exit_codes else None
        return Loss(describe_exit(code, dead.last_worker.memory_limit), dead.allowed_failures + 1)
    message = describe_error(error)
    return Loss(message) if isinstance(error, MemoryError) else message


def _lost(error: Exception | None) -> LostScheduler:
    why = f" ({error})" if error is not None and str(error) else ""
    return LostScheduler(f"the connection to Dask's scheduler is lost{why}")


def packages_of(setup: Setup) -> tuple[str, ...]:
    """Return the packages that must have the same versions everywhere for the same rows."""
    model = setup.model
    on_grids = model.plain and not model.soil_zones and not model.contact.voids
    return versions.MUST_AGREE if on_grids else (*versions.MUST_AGREE, *versions.MESHERS)


def _require_same_versions(client: Any, packages: tuple[str, ...]) -> None:
    """Raise InputError if a process of the cluster has other versions of packages than this one."""
    import cloudpickle

    # sent by value, as groundslab itself may be missing there
    cloudpickle.register_pickle_by_value(versions)
    try:
        others = {
            f"worker {address}": worker_versions
            for address, worker_versions in client.run(versions.versions, packages).items()
        }
        others["scheduler"] = client.run_on_scheduler(versions.versions, packages)
    finally:
        cloudpickle.unregister_pickle_by_value(versions)
    issues = version_differences(packages, versions.versions(packages), others)
    if issues:
        raise InputError(issues)


def version_differences(
    packages: Sequence[str], here: Mapping[str, str], elsewhere: Mapping[str, Mapping[str, str]]
) -> list[Issue]:
    """Return the packages that differ from those here, for each process."""
    return [
        Issue(
            where,
            f"{package} {installed[package]}" if package in installed else f"no {package}",
            f"{package} {here[package]}, as here" if package in here else f"no {package}, as here",
            "rows would differ; install the same versions everywhere",
        )
        for where, installed in elsewhere.items()
        for package in packages
        if here.get(package) != installed.get(package)
    ]


def require_packages() -> None:
    """Raise InputError where a package that a cluster needs is missing."""
    _import_distributed()
    import_optional("cryptography", "which makes the keys of a run", "study", INSTEAD)


def _import_distributed() -> Any:
    """Return Dask's package for several processes; raises InputError where it is not installed."""
    return import_optional("distributed", "Dask's package for several processes", "study", INSTEAD)
