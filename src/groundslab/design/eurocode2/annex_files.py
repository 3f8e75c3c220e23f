"""Files of national parameters: each has a value, the clause that leaves it to nations, and where it was looked up."""

from __future__ import annotations

import tomllib
from importlib.resources import files
from typing import Any

#: Parameters by name, each with its value, clause and source.
Table = dict[str, dict[str, Any]]


def read_table(package: str, name: str) -> Table:
    """Return the parameters in a file of the folder annexes of a package."""
    path = files(package) / "annexes" / f"{name}.toml"
    parameters: Table = tomllib.loads(path.read_text(encoding="utf-8"))["parameters"]
    return parameters


def values_of(parameters: Table) -> dict[str, Any]:
    """Return the values, lists as tuples."""
    return {key: _frozen(parameter["value"]) for key, parameter in parameters.items()}


def unconfirmed_clauses(parameters: Table) -> list[str]:
    """Return the clauses whose values were found in no source that could be read."""
    return list(dict.fromkeys(parameter["clause"] for parameter in parameters.values() if not parameter["source"]))


def _frozen(value: Any) -> Any:
    """Return a list of a file as a tuple, anything else as it is."""
    return tuple(value) if isinstance(value, list) else value
