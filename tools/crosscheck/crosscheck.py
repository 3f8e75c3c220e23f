"""Random slabs in groundslab and in NGSolve, whose formulation, mesh and contact have nothing in common with ours.

    python tools/crosscheck/crosscheck.py                       # 32 slabs
    python tools/crosscheck/crosscheck.py --slabs 4 --first 100 --keep out/crosscheck

`make verify` runs it. NGSolve gets an environment of its own, made by uv from bench/peers/ngs.txt. Differences are
those of settlements and moments at points that are clear of edges, openings and loads, relative to the slab's largest
value at those points. Ends with exit code 1 if a median is above its limit: 0.05 % of settlement, 0.3 % of moments.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from slabs import random_slab

from groundslab.analysis import driver
from groundslab.case import casefile
from groundslab.errors import GroundslabError

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
#: Limits of the medians, in per cent.
LIMITS = {"settlement": 0.05, "moments": 0.3}
ACCURACY = "0.5 %"


def main() -> None:
    """Solve all slabs in both programs and print the distribution of differences."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--slabs", type=int, default=32, help="how many slabs")
    parser.add_argument("--first", type=int, default=1, help="number of the first slab")
    parser.add_argument("--keep", type=Path, help="folder in which cases and values are kept")
    given = parser.parse_args()
    differences: dict[str, list[float]] = {name: [] for name in LIMITS}
    with tempfile.TemporaryDirectory() as scratch:
        folder = given.keep or Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for seed in range(given.first, given.first + given.slabs):
            case = random_slab(seed)
            (folder / f"{seed}.json").write_text(json.dumps(case, indent=1), encoding="utf-8")
            found = compare(case, folder / f"{seed}.json")
            for name, values in found.items():
                differences[name] += values
            shown = ", ".join(f"{name} {np.median(v):.3g} %, at most {max(v):.3g} %" for name, v in found.items())
            print(f"slab {seed}: {shown}", flush=True)
    print(f"\n{'':12}{'points':>8}{'median':>10}{'90 %':>10}{'largest':>10}{'limit of the median':>22}")
    for name, values in differences.items():
        middle, most = np.percentile(values, [50, 90])
        print(f"{name:12}{len(values):8}{middle:9.3g}%{most:9.3g}%{max(values):9.3g}%{LIMITS[name]:20} %")
    sys.exit(any(np.median(values) > LIMITS[name] for name, values in differences.items()))


def compare(case: dict[str, Any], path: Path) -> dict[str, list[float]]:
    """Return the differences [%] of a slab's settlements and moments; none of a slab that lies on nothing."""
    table = {**{key: part for key, part in case.items() if key != "points"}, "mesh": {"accuracy": ACCURACY}}
    try:
        plate = driver.solve(casefile.from_table(table)).plate
    except GroundslabError as error:
        sys.exit(f"{case['title']}: {error}")
    names = ("settlement", "moment_x", "moment_y")
    ours = np.array([[plate.value_at(name, *point) for name in names] for point in case["points"]])
    theirs = np.array(ngsolve(path)["values"])
    apart = 100 * np.abs(ours - theirs)
    return {
        "settlement": list(apart[:, 0] / np.abs(theirs[:, 0]).max()),
        "moments": list((apart[:, 1:] / np.abs(theirs[:, 1:]).max()).ravel()),
    }


def ngsolve(path: Path) -> dict[str, Any]:
    """Return what NGSolve finds for the case of a file."""
    uv = Path(sys.executable).with_name("uv")
    packages = ["--with-requirements", str(ROOT / "bench" / "peers" / "ngs.txt")]
    command = [str(uv), "run", "--quiet", "--isolated", "--no-project", "--python", sys.executable, *packages]
    script = ["python", str(HERE / "ngsolve_plate.py"), str(path)]
    done = subprocess.run([*command, *script], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"NGSolve failed on {path}:\n{done.stderr[-3000:]}")
    found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found


if __name__ == "__main__":
    main()
