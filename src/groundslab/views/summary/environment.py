"""What wrote results: versions of what computes, number of threads, and commit of groundslab where it is known."""

from __future__ import annotations

import json
import subprocess
import sys
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import Any

from groundslab.errors import GroundslabError
from groundslab.model.model import Model
from groundslab.solvers import factorization

#: Packages whose versions may change the last digits; MKL is not everywhere.
_PACKAGES = ("numpy", "scipy", "mkl")
#: Where groundslab is run from its own repository: the folder above its sources.
_ROOT = Path(__file__).parents[4]


def environment(model: Model) -> dict[str, Any]:
    """Return the versions of Python, NumPy, SciPy and MKL, the threads of the model's solver, and the commit."""
    versions = {"python": ".".join(map(str, sys.version_info[:3]))}
    for name in _PACKAGES:
        try:
            versions[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            continue
    origin = {} if (commit_id := commit()) is None else {"commit": commit_id}
    return {"versions": versions, "threads": _threads(model.analysis.solver), **origin}


def _threads(name: str) -> int:
    """Return the number of threads of a solver; 1 where its library is not there, as of results from elsewhere."""
    try:
        return factorization.threads(factorization.choose(name)[1])
    except (ImportError, GroundslabError):
        return 1


@cache
def commit() -> str | None:
    """Return the commit of groundslab with "-dirty" if files were changed since, None where it is not known.

    It is that of the repository from which it runs, or of the address from which it was installed.
    """
    if (_ROOT / ".git").exists() and (_ROOT / "src" / "groundslab").is_dir():
        command = ["git", "-C", str(_ROOT), "describe", "--always", "--dirty", "--abbrev=40", "--exclude=*"]
        try:
            asked = subprocess.run(command, capture_output=True, text=True, timeout=10, check=True)
        except (OSError, subprocess.SubprocessError):
            return None
        return asked.stdout.strip() or None
    try:
        address = metadata.distribution("groundslab").read_text("direct_url.json")
    except metadata.PackageNotFoundError:
        return None
    commit_id = json.loads(address or "{}").get("vcs_info", {}).get("commit_id")
    return commit_id if isinstance(commit_id, str) else None
