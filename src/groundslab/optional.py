"""Imports packages that not every installation has; where work is long, they are asked for before it."""

from __future__ import annotations

import importlib
import os
import sys
from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue


def import_optional(module: str, purpose: str, extra: str, instead: str = "") -> Any:
    """Return a module; raises InputError with the extra that installs its package if it is missing.

    ``purpose`` says what the package does, ``instead`` what does without it.
    """
    try:
        return importlib.import_module(module)
    except ImportError:
        package = module.partition(".")[0]
        hint = f"pip install groundslab[{extra}]" + (f"; {instead}" if instead else "")
        raise InputError([Issue(package, "nothing that can be imported", f"{package}, {purpose}", hint)]) from None


def import_pardiso() -> Any:
    """Import pypardiso with MKL's path set: its own search, done for every solver, takes longer than solving."""
    if "PYPARDISO_MKL_RT" not in os.environ:
        places = ("lib/libmkl_rt.so*", "Library/bin/mkl_rt*.dll")
        found = [path for place in places for path in sorted(Path(sys.prefix).glob(place))]
        if found:
            os.environ["PYPARDISO_MKL_RT"] = str(found[0])
    from pypardiso import pardiso_wrapper

    return pardiso_wrapper
