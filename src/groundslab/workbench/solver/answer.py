"""What a run comes to, apart from its scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Answer:
    """The outcome of a run without its scene: seconds, reasons of refused combinations, summary, names of tables.

    `provisional` says in words that the mesh is still to be refined, "" where it is not. `first` is how long it took to
    the first results of the run, provisional ones among them [s]. `unknowns` are those of the last of `meshes`, and
    `accuracy` is what was asked for, None where the case gives the mesh.
    """

    seconds: float
    refused: dict[str, str]
    summary: dict[str, Any]
    tables: tuple[str, ...] = ()
    provisional: str = ""
    first: float = 0.0
    unknowns: int = 0
    meshes: int = 1
    accuracy: float | None = None
