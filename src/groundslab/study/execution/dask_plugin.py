"""Plugin of Dask's workers that solves variants of a study; imported only where Dask is."""

from __future__ import annotations

import signal
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from distributed import WorkerPlugin, get_worker

from groundslab.study.definition.setup import Setup
from groundslab.study.execution import versions as package_versions
from groundslab.study.execution.variant import Row, Worker
from groundslab.study.sampling.designs import Variant


def dask_setup(worker: Any) -> None:
    """Close a worker's port for HTTP; Dask calls this when it starts a worker of the local cluster."""
    worker.http_server.stop()


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

    def row(self, variant: Variant, known_meshes: Sequence[str]) -> Row:
        """Return the row of a variant."""
        if self.own is None:
            raise RuntimeError("the study ended on this worker")
        if not hasattr(self.own, "worker"):
            self.own.worker = Worker(self.study)
        found: Row = self.own.worker.row(variant, known_meshes)
        return found


def solve(name: str, variants: Sequence[Variant], known_meshes: Sequence[str]) -> list[Row]:
    """Return the rows of variants, on a worker that has the plugin of that name."""
    plugin: Plugin = get_worker().plugins[name]
    found: list[Row] = []
    for variant in variants:
        found.append(plugin.row(variant, (*known_meshes, *(row.mesh for row in found))))
    return found
