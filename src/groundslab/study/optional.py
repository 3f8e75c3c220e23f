"""Imports packages that only studies need."""

from __future__ import annotations

import importlib
from typing import Any

from groundslab.errors import InputError, Issue


def import_optional(module: str, purpose: str, hint: str = "pip install groundslab[study]") -> Any:
    """Return a module; raises InputError with how to install its package if it is missing."""
    try:
        return importlib.import_module(module)
    except ImportError:
        package = module.partition(".")[0]
        raise InputError([Issue(package, "nothing that can be imported", f"{package}, {purpose}", hint)]) from None
