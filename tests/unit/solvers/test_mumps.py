"""MUMPS on two processes of MPI: the same answer on both, one of them speaks, both refuse together."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

import groundslab
from helpers.paths import EXAMPLES

NEEDED = {"petsc4py": find_spec("petsc4py"), "mpirun": shutil.which("mpirun")}
MISSING = [name for name, there in NEEDED.items() if not there]
pytestmark = pytest.mark.skipif(bool(MISSING), reason=f"MUMPS WAS NOT TESTED: no {' and no '.join(MISSING)}")

CASE = EXAMPLES / "table1.toml"
PATIENCE = 120.0
PROGRAM = """
import json, sys
from groundslab import load, solve
from groundslab.solvers.direct import mumps
from groundslab.errors import SingularMatrix
from groundslab.solvers.factorization import choose
import numpy as np

model = load(sys.argv[1])
own = solve(model.replace(analysis={"solver": "mumps"}))
other = solve(model.replace(analysis={"solver": "superlu"}))
off = np.abs(own.plate.settlement - other.plate.settlement).max() / other.plate.settlement.max()
try:
    # the second pivot is 1 - 2^2
    choose("mumps")[1](np.array([0, 2, 3]), np.array([0, 1, 1])).factor(np.array([1.0, 2.0, 1.0]))
except SingularMatrix:
    refused = True
total = float(own.plate.settlement.sum())
print(json.dumps([mumps.is_root_process(), own.solver, off, own.certificate.holds, refused, total]))
"""


def on_two(*arguments: str) -> subprocess.CompletedProcess[str]:
    """Run Python on two processes of MPI, which find the package where this one does."""
    places = os.pathsep.join([str(Path(groundslab.__file__).parents[1]), *filter(None, [os.environ.get("PYTHONPATH")])])
    variables = {
        "PYTHONPATH": places, "OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
    }  # fmt: skip
    return subprocess.run(
        ["mpirun", "-n", "2", sys.executable, *arguments],
        env={**os.environ, **variables}, capture_output=True, text=True, timeout=PATIENCE, check=False,
    )  # fmt: skip


def test_two_processes_have_the_answer_of_another_program() -> None:
    """Both have it whole, and the same to the last bit; a matrix that is not positive is refused on both."""
    ended = on_two("-c", PROGRAM, str(CASE))
    assert ended.returncode == 0, ended.stderr
    one, other = (json.loads(line) for line in ended.stdout.splitlines() if line.startswith("["))
    assert {one[0], other[0]} == {True, False}
    assert one[1:] == other[1:]
    _, solver, off, holds, refused, _ = one
    assert solver == "mumps"
    assert off < 1e-10
    assert holds
    assert refused


def test_one_process_speaks_and_writes_for_both(tmp_path: Path) -> None:
    """The command prints one summary and writes one folder; a wrong case ends both."""
    case = tmp_path / "case.toml"
    case.write_text(CASE.read_text(encoding="utf-8") + '\n[analysis]\nsolver = "mumps"\n', encoding="utf-8")
    ended = on_two("-m", "groundslab", "solve", str(case), "--json")
    assert ended.returncode == 0, ended.stderr
    assert json.loads(ended.stdout)["certified"]
    assert (tmp_path / "case-results" / "summary.json").exists()
    again = on_two("-m", "groundslab", "solve", str(tmp_path / "nothing.toml"))
    assert again.returncode == 2
