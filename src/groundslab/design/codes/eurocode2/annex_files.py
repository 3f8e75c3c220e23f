"""Files of national parameters: each has a value, the clause that leaves it to nations, and where it was looked up."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

#: Parameters by name, each with its value, clause and sources; those recommended also with what they are, and tests.
Table = dict[str, dict[str, Any]]


@dataclass(frozen=True, slots=True)
class AnnexFile:
    """What a file of the folder annexes says.

    Attributes
    ----------
    title : str
        The document.
    parameters : dict
        What differs from the recommended values; all of these in their own file.
    left_out : tuple of str
        Rules of the annex that are not followed, by clause.
    complete : bool
        Whether all of the annex was looked for, and not only what the file has.
    """

    title: str
    parameters: Table
    left_out: tuple[str, ...] = ()
    complete: bool = True


def read_file(package: str, name: str) -> AnnexFile:
    """Return a file of the folder annexes of a package."""
    content = _content(package, name)
    return AnnexFile(
        content["title"], content["parameters"], tuple(content.get("left_out", ())), content.get("complete", True)
    )


def _content(package: str, name: str) -> dict[str, Any]:
    """Return what a file of the folder annexes has."""
    return tomllib.loads((files(package) / "annexes" / f"{name}.toml").read_text(encoding="utf-8"))


def values_of(parameters: Table) -> dict[str, Any]:
    """Return the values, lists as tuples."""
    return {key: _frozen(parameter["value"]) for key, parameter in parameters.items()}


def _frozen(value: Any) -> Any:
    """Return a list of a file as a tuple, anything else as it is."""
    return tuple(map(_frozen, value)) if isinstance(value, list) else value
