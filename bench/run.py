"""The whole bench: our own jobs, the same plate in other programs, one job at a time, in environments of their own.

    make bench                                    # everything; hours
    python3 bench/run.py --quick                  # the two smallest sizes, each job once
    python3 bench/run.py --resume                 # go on where an interrupted run stopped
    python3 bench/run.py --kinds winkler --peers NGSolve --sizes 6k 25k --times 3

Needs only Python's standard library; the environments are made under bench/.env when they are missing. A finished job
is written at once to bench/.env/work.jsonl, all of them at the end to bench/results.json, from which bench/report.py
makes docs/performance.md. The machine must have nothing else to do.
"""

from __future__ import annotations

import argparse
import contextlib
import datetime
import hashlib
import json
import math
import os
import platform
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import report

HERE = Path(__file__).parent
ROOT = HERE.parent
ENVIRONMENTS = HERE / ".env"
WORK = ENVIRONMENTS / "work.jsonl"
RESULTS = HERE / "results.json"
#: No run of a peer may take longer [s]; our own jobs, which run several times in one process, have longer.
CAP, OWN_CAP = 600.0, 3600.0
#: A peer's job that takes longer [s] runs once, others as often as asked.
LONG = 20.0

#: Label of a size: the number that job.py takes (whole elements along the edges of the load), the peers' number.
SIZES = {
    "6k": (6734, 6700),
    "25k": (26936, 26400),
    "100k": (98951, 96200),
    "250k": (256079, 248000),
    "1M": (1024316, 986000),
}
#: The glued plate has no gaps among its unknowns: what job.py takes for it.
GLUED = {"6k": 9166, "25k": 36663, "100k": 136364, "250k": 345868, "1M": 1383471}
#: What job.py is asked for: the kind, and its sizes.
KINDS = {
    "linear": tuple(SIZES),
    "winkler": tuple(SIZES),
    "pasternak": tuple(SIZES),
    "raft": ("100k",),
    "gamma": ("100k", "250k"),
    "combinations": ("25k", "250k"),
    "continuum": ("6k", "100k"),
    "variants": ("6k",),
    "study": ("6k", "25k"),
    "solvers": ("250k",),
    "threads": ("1M",),
}
#: Slabs as engineers have them, each solved as it is.
CASES = ("examples/l_raft.toml", "bench/slabs/house_raft.toml", "bench/slabs/warehouse.toml")


@dataclass(frozen=True)
class Peer:
    """A program: its environment, what its script gets besides the size, and the script if its name is another."""

    environment: str
    options: tuple[str, ...] = ()
    other: str = ""

    def command(self, size: str) -> list[str]:
        """Return the words after Python that run a job of some size."""
        ours = self.environment == "own"
        script = self.other or f"bench/peers/{self.environment}.py"
        return [script, str(SIZES[size][0 if ours else 1]), *self.options]


OWN = "groundslab"
PEERS = {
    OWN: Peer("own", other="bench/fresh.py"),
    "NGSolve, order 2": Peer("ngs", ("2",)),
    "NGSolve, order 4": Peer("ngs", ("4",)),
    "scikit-fem, PARDISO": Peer("scikit_fem", ("pardiso",)),
    "scikit-fem, SuperLU": Peer("scikit_fem", ("superlu",)),
    "OpenSeesPy": Peer("opensees"),
    "Kratos": Peer("kratos", ("amgcl",)),
    "PyNite": Peer("pynite"),
}


@dataclass
class Ledger:
    """What is finished, by key; each new entry goes to the work file at once."""

    path: Path
    entries: dict[str, Any] = field(default_factory=dict)

    @classmethod
    def opened(cls, path: Path, resume: bool) -> Ledger:
        """Return the ledger of a run that goes on, or an empty one."""
        if not resume:
            path.unlink(missing_ok=True)
        lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
        ledger = cls(path)
        for line in lines:
            # the last line of an interrupted run may be torn
            with contextlib.suppress(json.JSONDecodeError):
                entry = json.loads(line)
                ledger.entries[entry["key"]] = entry
        path.write_text("".join(json.dumps(entry) + "\n" for entry in ledger.entries.values()), encoding="utf-8")
        return ledger

    def add(self, key: str, figures: dict[str, Any]) -> dict[str, Any]:
        """Keep a finished job and return it."""
        entry = {**figures, "key": key}
        self.entries[key] = entry
        with self.path.open("a", encoding="utf-8") as file:
            file.write(json.dumps(entry) + "\n")
        return entry


def python_of(name: str) -> Path:
    """Return the Python of an environment."""
    return ENVIRONMENTS / name / ("Scripts" if os.name == "nt" else "bin") / "python"


def prepare(name: str) -> None:
    """Make an environment unless it is there with the same requirements."""
    own = name == "own"
    requirements = ROOT / "lock" / "dev.txt" if own else HERE / "peers" / f"{name}.txt"
    stamp = ENVIRONMENTS / name / "bench.stamp"
    wanted = hashlib.sha256(requirements.read_bytes()).hexdigest() + " " + platform.python_version()
    if stamp.exists() and stamp.read_text() == wanted:
        return
    say(f"environment {name}")
    subprocess.run([sys.executable, "-m", "venv", "--clear", str(ENVIRONMENTS / name)], check=True)
    pip = [str(python_of(name)), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*pip, *(["--require-hashes"] if own else ["--no-deps"]), "-r", str(requirements)], check=True)
    if own:
        subprocess.run([*pip, "--no-deps", "--editable", str(ROOT)], check=True)
    stamp.write_text(wanted)


def surroundings(name: str) -> dict[str, str]:
    """Return the variables a job runs with: those of this process, less what would change threads or imports."""
    # what pip installs is compiled once; ours would be by each process where nothing may be written beside it
    left_out = {"OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS", "PYTHONPATH", "PYTHONHOME"}
    left_out |= {"PYTHONDONTWRITEBYTECODE"}
    variables = {key: value for key, value in os.environ.items() if key not in left_out}
    if name == "opensees":
        found = sorted((ENVIRONMENTS / name).glob("lib/python*/site-packages/openseespylinux/lib"))
        variables["LD_LIBRARY_PATH"] = os.pathsep.join(
            [*(str(path) for path in found), *filter(None, [os.environ.get("LD_LIBRARY_PATH")])]
        )
    return variables


def once(environment: str, command: Sequence[str], cap: float) -> dict[str, Any]:
    """Run a job; return its figures and the time of its process, or why there are none."""
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else math.nan
    start = time.perf_counter()
    try:
        done = subprocess.run(
            [str(python_of(environment)), *command],
            cwd=ROOT, env=surroundings(environment), timeout=cap, capture_output=True, text=True, check=False,
            preexec_fn=_first_to_go if sys.platform == "linux" else None,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return {"not reached": True, "whole process [s]": cap}
    spent = time.perf_counter() - start
    about = {"whole process [s]": spent, "load before": load}
    if done.returncode == -signal.SIGKILL:
        return {**about, "error": "killed, probably out of memory"}
    # 3: a design that fails a check
    if done.returncode not in ((0, 3) if environment == "own" else (0,)):
        return {
            **about,
            "error": (done.stderr.strip() or done.stdout.strip() or f"ended with {done.returncode}")[-500:],
        }
    return {**about, **last_figures(done.stdout)}


def _first_to_go() -> None:
    """Let the system end this process before any other if memory runs out."""
    Path("/proc/self/oom_score_adj").write_text("1000")


def last_figures(text: str) -> dict[str, Any]:
    """Return the last line of a job's output that is a JSON object; none is an empty one."""
    for line in reversed(text.splitlines()):
        if line.startswith("{"):
            with contextlib.suppress(json.JSONDecodeError):
                found: dict[str, Any] = json.loads(line)
                return found
    return {}


def predicted(done: Sequence[tuple[float, float]], unknowns: float) -> float:
    """Return the time [s] to expect from pairs of unknowns and time: it grows on as it grew last, at least linearly."""
    n, t = done[-1]
    power = 1.0
    if len(done) > 1:
        before, earlier = done[-2]
        power = max(power, math.log(t / earlier) / math.log(n / before))
    return t * (unknowns / n) ** power


def own_jobs(ledger: Ledger, kinds: Sequence[str], sizes: Sequence[str], times: int) -> None:
    """Run our own jobs; the medians are theirs."""
    for kind in (kind for kind in KINDS if kind in kinds):
        for size in sizes:
            key = f"own/{kind}/{size}"
            if size not in KINDS[kind] or finished(ledger, key):
                continue
            say(f"{OWN}, {kind}, {size}")
            unknowns = GLUED[size] if kind == "linear" else SIZES[size][0]
            figures = once("own", ["bench/job.py", kind, str(unknowns), str(times)], OWN_CAP)
            ledger.add(key, {**figures, "size": size, "times": times})
            tell(figures)


def case_jobs(ledger: Ledger, times: int) -> None:
    """Run the slabs as engineers have them."""
    for path in CASES:
        name = Path(path).stem
        key = f"own/{name}/as it is"
        if not finished(ledger, key):
            say(f"{OWN}, {name}")
            figures = once("own", ["bench/job.py", "case", path, str(times)], OWN_CAP)
            ledger.add(key, {**figures, "times": times})
            tell(figures)


def peer_jobs(ledger: Ledger, names: Sequence[str], sizes: Sequence[str], times: int) -> None:
    """Run all programs, ours too, from the smallest size upwards as far as each comes within the cap.

    Each run has a fresh process.
    """
    for name in names:
        peer = PEERS[name]
        done: list[tuple[float, float]] = []
        over = 0.0
        for size in sizes:
            key, unknowns = f"peer/{name}/{size}", SIZES[size][1]
            entry = ledger.entries.get(key)
            if not finished(ledger, key):
                say(f"{name}, {size}")
                expected = over * unknowns if over else predicted(done, unknowns) if done else 0.0
                if expected > CAP:
                    figures: dict[str, Any] = {"not reached": True, "predicted [s]": expected}
                else:
                    figures = repeated(peer.environment, peer.command(size), times)
                entry = ledger.add(key, {**figures, "size": size})
                tell(entry)
            assert entry is not None
            if "not reached" in entry:
                # it cannot take less for more unknowns
                over = max(over, max(CAP, entry.get("predicted [s]", 0.0)) / unknowns * 1.0001)
            elif "total [s]" in entry:
                done.append((entry["unknowns"], entry["whole process [s]"]))


def repeated(environment: str, command: Sequence[str], times: int) -> dict[str, Any]:
    """Run a peer's job as often as asked, or once if it takes long; return the first's figures with median times."""
    runs = [once(environment, command, CAP)]
    while len(runs) < times and "total [s]" in runs[-1] and runs[0]["whole process [s]"] < LONG:
        runs.append(once(environment, command, CAP))
    figures = runs[0]
    if all("total [s]" in run for run in runs):
        medians = {key: statistics.median(run[key] for run in runs) for key in ("total [s]", "whole process [s]")}
        figures = {**figures, **medians, "times": len(runs)}
    return figures


def small_jobs(ledger: Ledger, names: Sequence[str], times: int) -> None:
    """Time whole processes, the smallest job and commands, all in turn, so that a busy moment meets them all."""
    solve = "import sys, groundslab; groundslab.solve(groundslab.load(sys.argv[1]))"
    case, house = "bench/first_plate.toml", "bench/slabs/house_raft.toml"
    with tempfile.TemporaryDirectory() as folder:

        def solved(path: str) -> tuple[str, list[str]]:
            out = str(Path(folder) / Path(path).stem)
            return "own", ["-m", "groundslab", "solve", path, "--out", out, "--quiet"]

        every: dict[str, tuple[str, list[str]]] = {
            OWN: ("own", ["-c", solve, case]),
            f"{OWN} solve, files written": solved(case),
            f"{OWN} check": ("own", ["-m", "groundslab", "check", case]),
            f"{OWN} --help": ("own", ["-m", "groundslab", "--help"]),
            report.NUMPY: ("own", ["-c", report.NUMPY]),
            f"{OWN} solve, table 1": solved("examples/table1.toml"),
            f"{OWN} solve, house raft": solved(house),
            f"{OWN} solve, warehouse": solved("bench/slabs/warehouse.toml"),
            f"{OWN} report, house raft": (
                "own",
                ["-m", "groundslab", "report", f"{folder}/house_raft", "--out", f"{folder}/report.html"],
            ),
        }
        for name in names:
            if name != OWN:
                every[name] = PEERS[name].environment, PEERS[name].command("6k")
        left = {name: job for name, job in every.items() if not finished(ledger, f"small/{name}")}
        spent: dict[str, list[float]] = {name: [] for name in left}
        issues: dict[str, str] = {}
        # one round more than is counted: the first reads every program from the disk
        for turn in range(times + 1):
            for name, (environment, command) in left.items():
                if name in issues:
                    continue
                say(f"small job {turn} of {times}, {name}")
                figures = once(environment, command, CAP)
                if "error" in figures or "not reached" in figures:
                    issues[name] = figures.get("error", "not reached")
                elif turn:
                    spent[name].append(figures["whole process [s]"])
        for name in left:
            if name in issues:
                ledger.add(f"small/{name}", {"error": issues[name]})
            else:
                ledger.add(f"small/{name}", {"runs": spent[name], "median": statistics.median(spent[name])})


def finished(ledger: Ledger, key: str) -> bool:
    """Return whether a job is done; one that failed is tried again."""
    return key in ledger.entries and "error" not in ledger.entries[key]


def machine() -> dict[str, Any]:
    """Return what the figures depend on beside the code."""
    return {
        "CPU": "".join(_after("/proc/cpuinfo", "model name")) or platform.processor(),
        "cores": len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count(),
        "memory [GiB]": round(int((list(_after("/proc/meminfo", "MemTotal")) or ["0"])[0].split()[0]) / 2**20, 1),
        "system": "".join(_after("/etc/os-release", "PRETTY_NAME", "=")).strip('"') or platform.platform(),
        "kernel": platform.release(),
        "Python": platform.python_version(),
    }


def _after(path: str, word: str, sign: str = ":") -> Iterator[str]:
    """Yield what follows a word in the first line of a file that begins with it."""
    with contextlib.suppress(OSError):
        for line in Path(path).read_text(encoding="utf-8").splitlines():
            name, found, value = line.partition(sign)
            if found and name.strip() == word:
                yield value.strip()
                return


def versions(name: str) -> dict[str, str]:
    """Return the packages of an environment and their versions."""
    if not python_of(name).exists():
        return {}
    command = [str(python_of(name)), "-m", "pip", "list", "--format", "json", "--disable-pip-version-check"]
    found = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    return {package["name"]: package["version"] for package in found}


def commit() -> str:
    """Return the commit of the checkout, and whether something in it was changed."""

    def git(*words: str) -> str:
        return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=False).stdout.strip()

    changed = git("status", "--porcelain", "--untracked-files=no", "--", ".", ":!bench/results.json", ":!docs")
    return git("rev-parse", "HEAD") + (" and changes" if changed else "")


def circumstances() -> dict[str, Any]:
    """Return what figures were taken from, on and when."""
    return {"date": datetime.datetime.now(datetime.UTC).date().isoformat(), "commit": commit(), "machine": machine()}


def collect(ledger: Ledger) -> dict[str, Any]:
    """Return all finished jobs with what they depend on, as bench/results.json holds them."""
    results: dict[str, Any] = {
        **circumstances(),
        "packages": {name: versions(name) for name in sorted({peer.environment for peer in PEERS.values()})},
        "cap [s]": CAP,
        "own": {},
        "peers": {},
        "small": {},
    }
    order = {name: i for i, name in enumerate([*KINDS, *PEERS, *SIZES])}
    for key in sorted(ledger.entries, key=lambda key: [order.get(word, -1) for word in key.split("/")]):
        entry = ledger.entries[key]
        part, name, *rest = key.split("/")
        figures = {k: v for k, v in entry.items() if k != "key"}
        if part == "small":
            results["small"][name] = figures
        else:
            results["own" if part == "own" else "peers"].setdefault(name, {})[rest[0]] = figures
    return results


def say(text: str) -> None:
    """Print what is being done."""
    print(text, flush=True)


def tell(figures: dict[str, Any]) -> None:
    """Print the outcome of a job in a line."""
    if "error" in figures:
        say(f"    failed: {figures['error'].splitlines()[-1]}")
    elif "not reached" in figures:
        say(f"    not reached in {CAP:.0f} s")
    elif "total [s]" in figures:
        say(f"    {figures['unknowns']} unknowns, {figures['total [s]']:.3g} s")


def main(words: Sequence[str] | None = None) -> None:
    """Run what is asked for, keep it, and print it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="sizes 6k and 25k, each job once")
    parser.add_argument("--resume", action="store_true", help="keep what is finished, run the rest")
    parser.add_argument("--sizes", nargs="*", choices=SIZES, default=list(SIZES))
    parser.add_argument("--kinds", nargs="*", choices=KINDS, default=list(KINDS))
    parser.add_argument("--peers", nargs="*", default=[""], help="those whose names begin so; none without a name")
    parser.add_argument("--times", type=int, default=5, help="how often each job runs")
    parser.add_argument("--no-small", action="store_true", help="without the whole processes of the small job")
    parser.add_argument("--no-cases", action="store_true", help="without the slabs as engineers have them")
    parser.add_argument("--results", type=Path, default=RESULTS, help="where the figures go")
    given = parser.parse_args(words)
    sizes = [size for size in SIZES if size in given.sizes and not (given.quick and size not in ("6k", "25k"))]
    times = 1 if given.quick else given.times
    peers = [name for name in PEERS if any(name.startswith(begin) for begin in given.peers)]

    ENVIRONMENTS.mkdir(exist_ok=True)
    for name in dict.fromkeys(["own", *(PEERS[peer].environment for peer in peers)]):
        prepare(name)
    ledger = Ledger.opened(WORK, given.resume)
    if not given.no_small:
        small_jobs(ledger, peers, times)
    own_jobs(ledger, given.kinds, sizes, times)
    if not given.no_cases:
        case_jobs(ledger, times)
    peer_jobs(ledger, peers, sizes, min(times, 3))
    results = collect(ledger)
    given.results.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    for title, text in report.tables(results).items():
        if title not in ("picture", "accuracy"):
            say(f"\n{title}\n{text}")


if __name__ == "__main__":
    main()
