"""Variants solved on Dask: the cores of this machine, or a cluster that is there already.

The setup of a study goes to each worker once, as a plugin that new and restarted workers are given too; tasks are
small. Only some more tasks than there are threads are under way at a time. A task whose worker dies is given to
another by Dask's scheduler; one that has brought down several workers comes back as a mishap.

The processes of this machine talk to each other over TLS with keys that are made for the run and stay in their memory:
nobody else can have them run anything.
"""

from __future__ import annotations

import functools
import itertools
import logging
import secrets
import socket
import time
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from groundslab.errors import GroundslabError, InputError, Issue
from groundslab.study.execution import versions

if TYPE_CHECKING:
    from groundslab.study.definition.setup import Setup
    from groundslab.study.execution.variant import Row
    from groundslab.study.sampling.designs import Variant

#: Tasks under way for each thread: one at work, the others waiting at the scheduler so that none idles. They are handed
#: over when half of them are done, as every handing over costs the scheduler milliseconds, however many there are.
AHEAD = 16
#: How long a connection may take [s].
CONNECT = 10.0
#: How long the workers of a cluster are waited for [s].
PATIENCE = 60.0
#: How often it is asked how many threads there are [s].
LOOK = 2.0
#: Keeps a worker's libraries from starting threads of their own beside the other workers.
ONE_THREAD = {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
#: Of the local cluster.
SETTINGS = {
    "distributed.nanny.pre-spawn-environ": ONE_THREAD,
    # no task waits at a worker, where it would be blamed for the worker's death
    "distributed.scheduler.worker-saturation": 1.0,
    # workers that look at themselves every few milliseconds take a fifth longer for small cases
    "distributed.worker.profile.enabled": False,
    # each process would serve pages over HTTP
    "distributed.worker.http.routes": [],
    "distributed.worker.preload": ["groundslab.study.execution.dask_plugin"],
}
NO_PAGES: dict[str, Any] = {"distributed.scheduler.http.routes": []}
LOOPBACK = "127.0.0.1"
DASHBOARD = 8787  # port, where it is free


class LostScheduler(GroundslabError):
    """The scheduler of the cluster is gone; rows written before are as they were."""


@dataclass(frozen=True, slots=True)
class Mishap:
    """A variant that has no row for a reason that lies in the machine, not in the variant."""

    number: int
    message: str


@dataclass(frozen=True, slots=True)
class Cluster:
    """A connection to Dask's scheduler."""

    client: Any
    dashboard: str
    own: bool  # made for the study, and gone with it

    @property
    def threads(self) -> int:
        """Return the number of threads of all workers that are there now."""
        return sum(self.client.nthreads().values())


@contextmanager
def local(workers: int | None, most: int, dashboard: bool = False) -> Iterator[Cluster]:
    """Return a cluster on this machine, of processes with one thread: one for each core by default, at most `most`.

    Only who has the keys made here can connect to it. Dask's dashboard is there if it is asked for.
    """
    distributed, dask = _dask()
    security, port = _keys(distributed), _free_port(DASHBOARD) if dashboard else 0
    with dask.config.set(SETTINGS | (_dashboard_settings(port) if dashboard else NO_PAGES)):
        try:
            cluster = distributed.LocalCluster(
                n_workers=min(workers or dask.system.CPU_COUNT, most),
                threads_per_worker=1,
                processes=True,
                host=LOOPBACK,
                protocol="tls://",
                security=security,
                dashboard_address=f"{LOOPBACK}:{port}",
                scheduler_kwargs={"dashboard": dashboard},
                silence_logs=logging.CRITICAL,
            )
        except RuntimeError as error:
            # they load the program that called anew, and run it again if nothing keeps them from it
            hint = 'call groundslab.study in a file, below if __name__ == "__main__":, or with workers=0'
            raise InputError([Issue("workers", f"none that start ({error})", "processes of Python", hint)]) from error
        with cluster, distributed.Client(cluster) as client:
            _guard_pages(cluster.scheduler, dashboard)
            yield Cluster(client, cluster.dashboard_link if dashboard else "", own=True)


def _keys(distributed: Any) -> Any:
    """Return a key and a certificate for this run alone, kept in memory; who connects must have them."""
    try:
        return distributed.Security.temporary()
    except ImportError:
        expected = "cryptography, which makes the keys of a run"
        hint = "pip install groundslab[study]; --workers 0 does without it"
        raise InputError([Issue("cryptography", "nothing that can be imported", expected, hint)]) from None


def _dashboard_settings(port: int) -> dict[str, Any]:
    """Return the settings by which the dashboard talks to its own pages alone."""
    origins = [f"{LOOPBACK}:{port}", f"localhost:{port}"]
    return {"distributed.scheduler.dashboard.bokeh-application.allow_websocket_origin": origins}


def _guard_pages(scheduler: Any, dashboard: bool) -> None:
    """Close the scheduler's port for HTTP, or answer only who asks for this machine by a name of the loopback."""
    if not dashboard:
        scheduler.http_server.stop()
        return
    from tornado.routing import HostMatches, Rule, RuleRouter

    here = HostMatches(r"^(127\.0\.0\.1|localhost)$")
    scheduler.http_server.request_callback = RuleRouter([Rule(here, scheduler.http_application)])


def _free_port(port: int) -> int:
    """Return a port of the loopback that nobody has, this one if possible."""
    with socket.socket() as tried:
        try:
            tried.bind((LOOPBACK, port))
        except OSError:
            return _free_port(0)
        found: int = tried.getsockname()[1]
        return found


@contextmanager
def there(scheduler: str, setup: Setup) -> Iterator[Cluster]:
    """Return the cluster of a scheduler that runs already; InputError if it cannot be used.

    For an address that begins with tls:// the keys are those that Dask's configuration names.
    """
    distributed, _ = _dask()
    # what becomes of the connection is told in our own words
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)
    try:
        client = distributed.Client(scheduler, timeout=CONNECT)
    except (OSError, ValueError, TypeError, RuntimeError) as error:
        hint = ""
        if scheduler.startswith("tls:"):
            hint = "keys are those that distributed.comm.tls names in Dask's configuration; see docs/study.md"
        expected = 'a Dask scheduler such as "tcp://127.0.0.1:8786"'
        raise InputError([Issue("scheduler", f"{scheduler}: {error}", expected, hint)]) from None
    try:
        with suppress(TimeoutError):
            client.wait_for_workers(1, timeout=PATIENCE)
        if not client.nthreads():
            raise InputError([Issue("scheduler", f"{scheduler}, without workers", "at least one worker")])
        _require_same_versions(client, packages_of(setup))
        yield Cluster(client, client.dashboard_link, own=False)
    finally:
        with suppress(Exception):
            client.close(timeout=CONNECT if client.status == "running" else 0.1)


def rows(
    cluster: Cluster, name: str, setup: Setup, variants: Iterable[Variant], known_meshes: Callable[[], Sequence[str]]
) -> Generator[list[Row | Mishap]]:
    """Yield the rows of variants as they come, in whatever order, several at a time if they come together.

    `name` is the study's on the cluster. Raises LostScheduler. When it is closed early it yields nothing more, and what
    is under way is given up.
    """
    from groundslab.study.execution.dask_plugin import Plugin, solve

    client = cluster.client
    packages = packages_of(setup)
    client.register_plugin(Plugin(name, setup, packages, versions.versions(packages), cluster.own), name=name)
    run, left = secrets.token_hex(4), iter(variants)
    under_way: dict[Any, int] = {}
    looked, room = -LOOK, 0
    import distributed

    def handed_over(variants: list[Variant]) -> list[tuple[Any, int]]:
        if not variants:
            return []
        keys = [f"{name}-{run}-{variant.number}" for variant in variants]
        row_of = functools.partial(solve, name, known_meshes=known_meshes())
        futures = client.map(row_of, variants, key=keys, pure=False)
        return [(future, variant.number) for future, variant in zip(futures, variants, strict=True)]

    pool = distributed.as_completed([])
    try:
        while True:
            if time.monotonic() - looked > LOOK:
                looked, room = time.monotonic(), AHEAD * max(1, _asked(cluster))
            if len(under_way) <= room // 2:
                for future, number in handed_over(list(itertools.islice(left, room - len(under_way)))):
                    under_way[future] = number
                    pool.add(future)
            if not under_way:
                return
            done = []
            for future in next(pool.batches()):
                # a worker that dies takes with it what was not fetched; the scheduler has it solved again
                if future.status in ("lost", "pending"):
                    pool.add(future)
                elif future in under_way:
                    done.append(_outcome(future, under_way.pop(future)))
            if done:
                yield done
    finally:
        # else there is nobody to tell that it is over
        if client.status == "running":
            with suppress(Exception):
                client.cancel(list(under_way), force=True)
                client.unregister_worker_plugin(name)


def _asked(cluster: Cluster) -> int:
    """Return the number of threads; raises LostScheduler."""
    try:
        return cluster.threads
    except Exception as error:
        raise _lost(error) from error


def _outcome(future: Any, number: int) -> Row | Mishap:
    """Return what became of a task."""
    if future.status == "finished":
        try:
            row: Row = future.result()
        except Exception as error:
            raise _lost(error) from error
        return row
    if future.status == "error":
        raised = future.exception()
        if type(raised).__name__ == "KilledWorker":
            return Mishap(number, f"{raised.allowed_failures + 1} workers died of it, maybe for want of memory")
        return Mishap(number, f"{type(raised).__name__}: {raised}")
    raise _lost(None)


def _lost(error: Exception | None) -> LostScheduler:
    why = f" ({error})" if error is not None and str(error) else ""
    return LostScheduler(f"the connection to Dask's scheduler is lost{why}")


def packages_of(setup: Setup) -> tuple[str, ...]:
    """Return the packages that must be the same everywhere for the rows of a study to be the same."""
    model = setup.model
    on_grids = model.plain and not model.soil_zones and not model.contact.voids
    return versions.MUST_AGREE if on_grids else (*versions.MUST_AGREE, *versions.MESHERS)


def _require_same_versions(client: Any, packages: tuple[str, ...]) -> None:
    """Raise InputError if a process of the cluster has not the same packages as this one."""
    import cloudpickle

    # sent by value, as groundslab may be what is missing there
    cloudpickle.register_pickle_by_value(versions)
    try:
        found = {f"worker {address}": each for address, each in client.run(versions.versions, packages).items()}
        found["scheduler"] = client.run_on_scheduler(versions.versions, packages)
    finally:
        cloudpickle.unregister_pickle_by_value(versions)
    issues = differences(packages, versions.versions(packages), found)
    if issues:
        raise InputError(issues)


def differences(
    packages: Sequence[str], here: Mapping[str, str], elsewhere: Mapping[str, Mapping[str, str]]
) -> list[Issue]:
    """Return which packages differ from those here, by the process that has others."""
    return [
        Issue(
            where,
            f"{package} {there[package]}" if package in there else f"no {package}",
            f"{package} {here[package]}, as here" if package in here else f"no {package}, as here",
            "rows would differ; install the same versions everywhere",
        )
        for where, there in elsewhere.items()
        for package in packages
        if here.get(package) != there.get(package)
    ]


def _dask() -> tuple[Any, Any]:
    """Return Dask's two packages."""
    try:
        import dask
        import dask.system
        import distributed
    except ImportError:
        expected = "distributed, Dask's package for several processes"
        hint = "pip install groundslab[study]; --workers 0 does without it"
        raise InputError([Issue("distributed", "nothing that can be imported", expected, hint)]) from None
    return distributed, dask
