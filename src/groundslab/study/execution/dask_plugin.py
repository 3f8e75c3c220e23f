"""Plugin of Dask's workers that solves variants of a study, and what looks after them; imported only where Dask is."""

from __future__ import annotations

import signal
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import distributed
from distributed import WorkerPlugin, get_worker

from groundslab.study.definition.setup import Setup
from groundslab.study.execution import versions as package_versions
from groundslab.study.execution.variant import Row, Worker, WorkerFailure
from groundslab.study.sampling.designs import Variant

#: Time limit for the exit code of a worker that is known to be dead [s].
EXIT_TIMEOUT = 30.0


def dask_setup(worker: Any) -> None:
    """Close a worker's port for HTTP; Dask calls this when it starts a worker of the local cluster."""
    worker.http_server.stop()


class ExitCodes:
    """How the processes of workers ended, by their addresses."""

    def __init__(self) -> None:
        self._codes: dict[str | None, int] = {}
        self._added = threading.Condition()

    def add(self, address: str | None, code: int) -> None:
        """Note how a process ended."""
        with self._added:
            self._codes[address] = code
            self._added.notify_all()

    def wait(self, address: str) -> int | None:
        """Return how the process of a worker that is known to be dead ended, None if nobody can tell."""
        with self._added:
            self._added.wait_for(lambda: address in self._codes, EXIT_TIMEOUT)
            return self._codes.get(address)


class Nanny(distributed.Nanny):  # type: ignore[misc]
    """Starts a worker's process, again when it dies, and notes how it ended."""

    def __init__(self, *arguments: Any, exit_codes: ExitCodes, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._exit_codes = exit_codes
        self._took_too_much = False  # whether Dask ended the process for its memory

    def log_event(self, topic: Any, msg: Any) -> None:
        """Note that the process takes too much memory: Dask ends it by SIGTERM, a busy machine soon by SIGKILL."""
        self._took_too_much |= topic == "worker-restart-memory"
        super().log_event(topic, msg)

    def _on_worker_exit_sync(self, exitcode: int) -> None:
        """Note how the process ended, and start another one."""
        self._exit_codes.add(self.worker_address, -signal.SIGTERM if self._took_too_much else exitcode)
        self._took_too_much = False
        super()._on_worker_exit_sync(exitcode)


@dataclass(eq=False)
class Plugin(WorkerPlugin):  # type: ignore[misc]
    """The setup of a study, and a `Worker` for each thread of a Dask worker."""

    name: str
    study: Setup
    packages: tuple[str, ...]
    versions: Mapping[str, str]
    ignore_interrupt: bool
    own: threading.local | None = None

    def setup(self, worker: Any) -> None:
        """Start on a worker; raises RuntimeError if its versions differ, also for workers that join late."""
        here = package_versions.versions(self.packages)
        if here != self.versions:
            raise RuntimeError(f"{worker.address} has {here}, the study is run with {self.versions}")
        if self.ignore_interrupt and threading.current_thread() is threading.main_thread():
            # Ctrl-C reaches all processes of a terminal; the one that runs the study stops the others
            signal.signal(signal.SIGINT, signal.SIG_IGN)
        self.own = threading.local()

    def teardown(self, worker: Any) -> None:  # noqa: ARG002
        """End on a worker, and release the study."""
        self.own = None

    def outcome(self, variant: Variant, known_meshes: Sequence[str]) -> Row | WorkerFailure:
        """Return the row of a variant, or why it has none."""
        if self.own is None:
            raise RuntimeError("the study ended on this worker")
        if not hasattr(self.own, "worker"):
            self.own.worker = Worker(self.study)
        outcome: Row | WorkerFailure = self.own.worker.outcome(variant, known_meshes)
        return outcome


def solve(name: str, variants: Sequence[Variant], known_meshes: Sequence[str]) -> list[Row | WorkerFailure]:
    """Return the rows of variants, or why they have none, on a worker that has the plugin of that name."""
    plugin: Plugin = get_worker().plugins[name]
    outcomes: list[Row | WorkerFailure] = []
    for variant in variants:
        meshes = (row.mesh for row in outcomes if isinstance(row, Row))
        outcomes.append(plugin.outcome(variant, (*known_meshes, *meshes)))
    return outcomes
