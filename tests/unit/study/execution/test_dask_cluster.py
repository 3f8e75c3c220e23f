"""Studies on Dask: the same rows on one process or several, whatever of them is killed."""

from __future__ import annotations

import http.client
import os
import signal
import socket
import sqlite3
import ssl
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack, closing, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace

import dask.config
import distributed
import psutil
import pytest
from dask.utils import parse_timedelta

import groundslab
from groundslab.errors import InputError
from groundslab.study.evaluation.study import Study
from groundslab.study.execution import dask_cluster, store, versions
from groundslab.study.execution.tasks import Loss
from helpers import studies
from helpers.studies import STUDY

pytestmark = pytest.mark.slow

#: Enough variants for some of them to share a task.
COUNT = 48
MANY = STUDY.replace("count = 12", f"count = {COUNT}")
COARSE = studies.CASE.replace("counts = [8, 6]", "counts = [4, 3]")
PATIENCE = 300.0  # seconds, on a machine that has other things to do

#: What a worker's process does at its start where this is its sitecustomize: before the variant of a number is
#: solved, something else happens. Other processes start as ever.
HOOK = """
import os, signal, sys, time
from pathlib import Path

def before(number):
    {before}

def row_after(self, variant, known=()):
    before(variant.number)
    return row(self, variant, known)

if any(word in argument for argument in sys.orig_argv for word in ("spawn_main", "dask_worker")):
    from groundslab.study.execution.variant import Worker

    row, Worker.row = Worker.row, row_after
"""
#: Some variants come to their end only when a file is there.
WAIT = """
    while number > {first} and not Path({gate!r}).exists():
        time.sleep(0.01)
"""


def hooked(folder: Path, before: str) -> dict[str, str]:
    """Return the environment of processes in which something happens before variants are solved."""
    hook = folder / "hook"
    hook.mkdir(parents=True)
    (hook / "sitecustomize.py").write_text(HOOK.format(before=before.strip()))
    return {"PYTHONPATH": os.pathsep.join([str(hook), *sys.path])}


def write(folder: Path, study: str = STUDY) -> Path:
    """Write a study of a case that is solved at once into a folder and return its file."""
    return studies.write(folder, study, COARSE)


def wait_for(what: Callable[[], bool]) -> None:
    """Wait until something is so."""
    end = time.monotonic() + PATIENCE
    while not what():
        assert time.monotonic() < end
        time.sleep(0.05)


def count(folder: Path) -> int:
    """Return how many rows a study has so far, 0 if there is none yet."""
    try:
        with closing(sqlite3.connect(f"{(folder / store.ROWS).as_uri()}?mode=ro", uri=True)) as rows:
            return int(rows.execute("SELECT COUNT(*) FROM rows").fetchone()[0])
    except sqlite3.OperationalError:
        return 0


def same(one: Study, other: Study, without: Iterable[int] = ()) -> bool:
    """Return whether a study has the first rows of another but for some, to the last bit but for the time they took."""
    theirs = other.table().loc[: one.count].drop(index=list(without))
    fields = dict(other.fields("settlement"))
    return (
        one.table().drop(columns="seconds").equals(theirs.drop(columns="seconds"))
        and [number for number, _ in one.fields("settlement")] == list(theirs.index)
        and all((field == fields[number]).all() for number, field in one.fields("settlement"))
    )


def started(*arguments: str, **environment: str) -> subprocess.Popen[str]:
    """Return a process of Python that runs a module, in a group of its own."""
    return subprocess.Popen(
        [sys.executable, "-m", *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
        env={**os.environ, **dask_cluster.ONE_THREAD, **environment},
    )  # fmt: skip


@contextmanager
def ended(process: subprocess.Popen[str]) -> Iterator[subprocess.Popen[str]]:
    """Kill a process and all of its group in the end."""
    with process:
        try:
            yield process
        finally:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)


#: Solves the rest of a study one variant after the other, and evaluates nothing.
ALONE = """
import sys, groundslab
groundslab.study(sys.argv[1], out=sys.argv[2], workers=0, resume=True, quiet=True)
"""


def alone(path: Path, folder: Path) -> Study:
    """Return a study, or the rest of one, as one process solves it: a fresh one, where MKL was not used."""
    environment = {**os.environ, **dask_cluster.ONE_THREAD}
    subprocess.run([sys.executable, "-c", ALONE, str(path), str(folder)], env=environment, timeout=PATIENCE, check=True)
    return groundslab.open_study(folder)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Study:
    """Return the study of many variants as one process solves it."""
    folder = tmp_path_factory.mktemp("whole")
    return alone(write(folder, MANY), folder / "study-study")


def test_variants_that_kill_their_workers(tmp_path: Path, whole: Study) -> None:
    """Variants that bring down every worker have no row and are named with what happened; all others have one.

    The same as in one process: that with which a worker was killed once, those that shared a task with them, and those
    whose rows were lost with the worker. One of the killers takes more memory than Dask leaves a worker, which then
    ends it.
    """
    deaths, once = tmp_path / "deaths", tmp_path / "once"
    killers = f"""
    if number == 20 and not Path({str(once)!r}).exists():
        Path({str(once)!r}).touch()
        os.kill(os.getpid(), 9)
    if number in (3, 44):
        with open({str(deaths)!r}, "a") as file:
            file.write(f"{{number}} ")
    if number == 3:
        os._exit(9)
    if number == 44:
        kept = b"x" * 600_000_000
        time.sleep(600)
    if number == 40:
        raise MemoryError("no room")
    if number == 41:
        raise ZeroDivisionError("a defect")
    """
    environment = hooked(tmp_path, killers) | {"DASK_DISTRIBUTED__WORKER__MEMORY__TERMINATE": str(6e8 / memory_share())}
    command = ("groundslab", "study", str(write(tmp_path, MANY)), "--workers", "2", "--quiet")
    with ended(started(*command, **environment)) as process:
        stdout, stderr = process.communicate(timeout=PATIENCE)
    assert process.returncode == 1, stderr
    assert f"{COUNT - 4} of {COUNT} variants have a row" in stdout, stderr
    study = groundslab.open_study(tmp_path / "study-study")
    died = "2 workers died of it with nothing else running: "
    failures = {
        3: f"{died}exit code 9",
        40: "MemoryError: no room",
        41: "ZeroDivisionError: a defect",
        44: f"{died}more memory than a worker's share of {memory_share() / 2**30:.3g} GiB",
    }
    assert study.worker_failures() == failures
    # one beside others, two alone
    assert sorted(deaths.read_text().split()) == ["3"] * 3 + ["44"] * 3
    assert all(f"variant {number} has none: {message}" in stdout for number, message in failures.items())
    assert f"{COUNT - 4} of {COUNT} rows are kept" in stderr
    assert "--resume" in stderr
    assert once.exists()
    assert same(study, whole, without=failures)


def memory_share() -> float:
    """Return how much memory Dask gives a worker of one thread [bytes]."""
    from dask.system import CPU_COUNT
    from distributed.system import MEMORY_LIMIT

    return float(MEMORY_LIMIT / CPU_COUNT)


class Task:
    """What Dask tells of a task."""

    def __init__(self, status: str, error: Exception | None = None) -> None:
        self.status, self.error = status, error

    def exception(self) -> Exception | None:
        """Return why it has failed."""
        return self.error


class KilledWorker(Exception):
    """What Dask raises in place of a result when workers have died."""

    allowed_failures = 3
    last_worker = SimpleNamespace(memory_limit=0)


@dataclass
class Client:
    """Fetches rows; those of one task were lost with their worker, and workers died as they were made anew."""

    lost: Task
    others: list[str]

    def gather(self, tasks: list[Task]) -> list[str]:
        """Return the rows of tasks."""
        if self.lost in tasks:
            self.lost.status, self.lost.error = "error", KilledWorker("Attempted to run task on 4 different workers")
            raise self.lost.error
        return self.others


def test_rows_that_are_lost_before_they_are_fetched() -> None:
    """A task that ended well, and of which workers die when it is done again, is one to be tried alone, not the end."""
    lost, fine, failed = Task("finished"), Task("finished"), Task("error", ValueError("no"))
    again = Task("pending")
    cluster = dask_cluster.Cluster(Client(lost, ["rows"]), "")
    outcomes = dict(dask_cluster._outcomes(cluster, [lost, fine, failed, again]))
    loss = Loss("perhaps out of memory", 4)
    assert outcomes == {fine: "rows", lost: loss, failed: "ValueError: no", again: None}


def test_a_scheduler_that_is_lost_while_rows_are_fetched() -> None:
    """What is no task's fault ends the study."""

    class Lost:
        def gather(self, tasks: list[Task]) -> list[str]:
            raise OSError(f"{len(tasks)} away")

    cluster = dask_cluster.Cluster(Lost(), "")
    with pytest.raises(dask_cluster.LostScheduler, match="1 away"):
        list(dask_cluster._outcomes(cluster, [Task("finished")]))
    with pytest.raises(dask_cluster.LostScheduler):
        list(dask_cluster._outcomes(cluster, [Task("cancelled")]))


@pytest.mark.skipif(sys.platform == "win32", reason="signals of this kind are POSIX")
@pytest.mark.usefixtures("interruptible")
def test_killed_study(tmp_path: Path, whole: Study) -> None:
    """A study that is interrupted, then killed leaves whole rows and no process; it goes on with the rest only."""
    path, folder = write(tmp_path), tmp_path / "study-study"
    before = None
    for how, kept, options in (
        (signal.SIGINT, 4, ("--workers", "2")),
        (signal.SIGKILL, 8, ("--workers", "1", "--resume")),
    ):
        environment = hooked(tmp_path / how.name, WAIT.format(first=kept, gate=str(tmp_path / "never")))
        with ended(started("groundslab", "study", str(path), *options, **environment)) as process:
            wait_for(lambda kept=kept: count(folder) == kept)
            children = psutil.Process(process.pid).children(recursive=True)
            # Ctrl-C reaches every process of the terminal
            os.kill(process.pid, how) if how == signal.SIGKILL else os.killpg(process.pid, how)
            _, stderr = process.communicate(timeout=PATIENCE)
            assert psutil.wait_procs(children, timeout=PATIENCE)[1] == []
        rows = groundslab.open_study(folder).table()
        assert len(rows) == kept
        assert before is None or rows.loc[before.index].equals(before)
        before = rows
        if how == signal.SIGINT:
            assert process.returncode == 130
            assert "4 of 12 rows are kept" in stderr
            assert "Traceback" not in stderr
    study = alone(path, folder)
    assert study.table().loc[before.index].equals(before)
    assert same(study, whole)


def test_program_without_guard(tmp_path: Path) -> None:
    """A program that would run itself again in each process gets an error; only the folder is left behind."""
    path = write(tmp_path)
    program = tmp_path / "program.py"
    program.write_text(f"import groundslab\ngroundslab.study({str(path)!r}, workers=1, quiet=True)\n")
    ended = subprocess.run([sys.executable, str(program)], capture_output=True, text=True, timeout=PATIENCE)
    assert ended.returncode != 0
    assert 'below if __name__ == "__main__":' in ended.stderr


#: A scheduler's address, its process, and what starts a worker for it.
Scheduler = tuple[str, subprocess.Popen[str], Callable[..., None]]


@contextmanager
def scheduler(folder: Path, protocol: str = "tcp", **keys: str) -> Iterator[Scheduler]:
    """Have a scheduler on the loopback."""
    address_file = folder / "scheduler.json"
    with ExitStack() as stack:
        options = ["--host", f"{protocol}://127.0.0.1", "--port", "0", "--no-dashboard"]
        command = ("distributed.cli.dask_scheduler", *options, "--scheduler-file", str(address_file))
        process = stack.enter_context(ended(started(*command, **keys)))
        wait_for(lambda: address_file.exists() and "address" in address_file.read_text())
        address = next(line.split('"')[3] for line in address_file.read_text().splitlines() if '"address"' in line)
        assert address.startswith(f"{protocol}://")

        def worker(**environment: str) -> None:
            options = ["--nthreads", "1", "--no-dashboard", "--no-nanny", "--local-directory", str(folder)]
            command = ("distributed.cli.dask_worker", address, *options)
            stack.enter_context(ended(started(*command, **keys, **environment)))

        yield address, process, worker


def test_other_versions(tmp_path: Path, whole: Study) -> None:
    """A cluster makes the same rows; a worker with another version of groundslab is found out before it gets any."""
    other = tmp_path / "other" / "groundslab"
    other.mkdir(parents=True)
    (other / "__init__.py").write_text('__version__ = "0.0.1"\n')
    path = write(tmp_path)
    with scheduler(tmp_path) as (address, _, worker):
        worker()
        assert same(groundslab.study(path, scheduler=address, out=tmp_path / "first", quiet=True), whole)
        worker(PYTHONPATH=str(tmp_path / "other"))
        with distributed.Client(address) as client:
            client.wait_for_workers(2, timeout=PATIENCE)
        with pytest.raises(InputError) as caught:
            groundslab.study(path, scheduler=address, quiet=True)
    issues = caught.value.issues
    assert all(issue.location.startswith("worker tcp://127.0.0.1:") for issue in issues)
    assert [issue.found for issue in issues] == ["groundslab 0.0.1"]
    assert len(groundslab.open_study(tmp_path / "study-study")) == 0


def test_a_scheduler_with_keys(tmp_path: Path, whole: Study) -> None:
    """It solves with the keys in Dask's configuration only; when it is killed, the rest is done elsewhere."""
    made = distributed.Security.temporary()
    (tmp_path / "ca.pem").write_text(made.tls_ca_file)
    (tmp_path / "pair.pem").write_text(made.tls_client_cert + made.tls_client_key)
    tls = "DASK_DISTRIBUTED__COMM__TLS__"
    keys = {f"{tls}CA_FILE": str(tmp_path / "ca.pem"), "DASK_DISTRIBUTED__COMM__REQUIRE_ENCRYPTION": "true"}
    for role in ("SCHEDULER", "WORKER", "CLIENT"):
        keys |= {f"{tls}{role}__{part}": str(tmp_path / "pair.pem") for part in ("CERT", "KEY")}
    path, folder = write(tmp_path), tmp_path / "study-study"
    environment = hooked(tmp_path, WAIT.format(first=4, gate=str(tmp_path / "never")))
    with scheduler(tmp_path, "tls", **keys) as (address, process, worker):
        worker(**environment)
        command = ("groundslab", "study", str(path), "--scheduler", address, "--quiet")
        with ended(started(*command)) as study:
            _, stderr = study.communicate(timeout=PATIENCE)
        assert study.returncode == 2
        assert "distributed.comm.tls" in stderr
        assert "Traceback" not in stderr
        with ended(started(*command, "--resume", **keys)) as study:
            wait_for(lambda: count(folder) == 4)
            process.kill()
            _, stderr = study.communicate(timeout=PATIENCE)
    assert study.returncode == 1
    assert "lost" in stderr
    assert "--resume" in stderr
    before = groundslab.open_study(folder).table()
    assert len(before) == 4
    after = alone(path, folder)
    assert after.table().loc[before.index].equals(before)
    assert same(after, whole)


def test_no_scheduler(tmp_path: Path) -> None:
    """An address where no scheduler answers is an error of the input."""
    with pytest.raises(InputError, match="Dask scheduler such as"):
        groundslab.study(write(tmp_path), scheduler="nothing at all", quiet=True)


def test_differences() -> None:
    """Packages that differ or are missing are reported process by process; others are not."""
    here = {"python": "3.12", "groundslab": "1", "numpy": "2.1"}
    there = {"a": here, "b": {**here, "numpy": "2.0"}, "c": {"python": "3.12", "numpy": "2.1", "gstools": "1.6"}}
    issues = dask_cluster.version_differences(versions.MUST_AGREE, here, there)
    assert [(issue.location, issue.found) for issue in issues] == [
        ("b", "numpy 2.0"), ("c", "no groundslab"), ("c", "gstools 1.6")
    ]  # fmt: skip
    assert versions.versions(("groundslab", "no_such_package_at_all", "python")).keys() == {"python", "groundslab"}


def listening(process: psutil.Process) -> list[int]:
    """Return the ports on which a process and those that it started listen."""
    found = []
    for each in (process, *process.children(recursive=True)):
        found += [to.laddr for to in each.net_connections("tcp") if to.status == psutil.CONN_LISTEN]
    assert all(place.ip == "127.0.0.1" for place in found)
    return [place.port for place in found]


def refuses_strangers(port: int) -> bool:
    """Return whether a port ends every conversation with who has no key: plain, over HTTP, and over TLS."""
    with socket.create_connection(("127.0.0.1", port), timeout=PATIENCE) as plain:
        plain.sendall(b"GET /status HTTP/1.1\r\nHost: evil.example\r\n\r\n")
        with suppress(ConnectionError):
            if plain.recv(1) != b"":
                return False
    context = ssl.create_default_context()
    context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
    try:
        with (
            socket.create_connection(("127.0.0.1", port), timeout=PATIENCE) as plain,
            context.wrap_socket(plain) as wrapped,
        ):
            return wrapped.recv(1) == b""
    except (ssl.SSLError, ConnectionError):
        return True


def test_strangers_are_kept_out() -> None:
    """Each port of the local cluster, that of its worker too, asks for the run's keys; no page is served."""
    before = set(listening(psutil.Process()))
    with dask_cluster.start_local(1, 1) as found:
        ports = set(listening(psutil.Process())) - before
        assert len(ports) == 3  # scheduler, worker, and what looks after that
        assert all(map(refuses_strangers, ports))
        assert found.dashboard == ""
        address = found.client.scheduler.address
        assert address.startswith("tls://127.0.0.1:")
        for other in (address, address.replace("tls://", "tcp://")):
            keys = distributed.Security.temporary() if other.startswith("tls") else None
            with pytest.raises(OSError, match=r"TLS certificate|TCP|timed out"):
                distributed.Client(other, timeout=1, security=keys)
        assert found.threads == 1


@pytest.fixture(scope="module")
def local() -> Iterator[dask_cluster.Cluster]:
    """Return a cluster of one worker on this machine, with a dashboard."""
    with dask_cluster.start_local(1, 1, dashboard=True) as cluster:
        yield cluster


def test_workers_that_start_anew(local: dask_cluster.Cluster) -> None:
    """A killed process starts anew under the same nanny, for as long as it takes; a nanny that ended is replaced.

    Dask stops a nanny whose process is not back after its time limit, 15 s by default: on a busy machine just when the
    new process has its first task, which then seems to end it with exit code 0.
    """
    assert parse_timedelta(dask.config.get("distributed.deploy.lost-worker-timeout")) >= PATIENCE
    cluster = local.client.cluster
    [nanny] = cluster.workers.values()
    address = nanny.worker_address
    os.kill(nanny.pid, signal.SIGKILL)
    wait_for(lambda: nanny.worker_address not in (None, address))
    local.client.wait_for_workers(1, timeout=PATIENCE)
    assert list(cluster.workers.values()) == [nanny]
    assert local.exit_codes is not None
    assert local.exit_codes.wait(address) == -signal.SIGKILL
    cluster.sync(nanny.close)
    wait_for(lambda: nanny not in cluster.workers.values() and len(local.client.nthreads()) == 1)
    assert local.client.submit(abs, -3).result(timeout=PATIENCE) == 3


def test_dashboard_when_asked_for(local: dask_cluster.Cluster) -> None:
    """The dashboard is there if asked for, on the loopback, and answers no other name than that of the loopback."""
    assert local.dashboard.startswith("http://127.0.0.1:")
    port = int(local.dashboard.split(":")[2].split("/")[0])
    for host, code in (("127.0.0.1", 200), ("localhost", 200), ("evil.example", 404)):
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=PATIENCE)
        with closing(connection):
            connection.request("GET", "/status", headers={"Host": host})
            assert connection.getresponse().status == code


def test_without_cryptography(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the package that makes keys nothing is opened, and the error says what to install."""
    monkeypatch.setitem(sys.modules, "cryptography", None)
    for name in [name for name in sys.modules if name.startswith("cryptography.")]:
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(InputError, match=r"cryptography.*groundslab\[study\]"):
        groundslab.study(write(tmp_path), workers=1, quiet=True)
