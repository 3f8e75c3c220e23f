"""What national annexes to EN 1990 and EN 1997-1 say otherwise than these recommend, from the file actions.toml."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Any, Literal

#: National annexes: those to EN 1992-1-1, EN 1990 and EN 1997-1 of one country.
AnnexName = Literal[
    "recommended", "Austria", "France", "Germany", "Italy", "Netherlands", "Poland", "Spain", "United Kingdom"
]  # fmt: skip
_CATEGORY = "cases.category "


@cache
def action_parameters() -> Mapping[str, Any]:
    """Return the file: rows of parameters, the documents, and what is left out of them."""
    text = files("groundslab.model.loads.annexes").joinpath("actions.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


@cache
def psi_of(annex: str) -> Mapping[str, tuple[float, float, float]]:
    """Return psi_0, psi_1 and psi_2 of the categories for which an annex has its own."""
    return {key.removeprefix(_CATEGORY): value for key, value in _own(annex).items() if key.startswith(_CATEGORY)}


@cache
def factors_of(annex: str) -> Mapping[str, Any]:
    """Return the keys of automatic combinations for which an annex has its own values."""
    return {key.removeprefix("combine."): value for key, value in _own(annex).items() if key.startswith("combine.")}


def document_of(annex: str) -> str:
    """Return the annex to EN 1990, where any of its values differs from those recommended; nothing otherwise."""
    return str(action_parameters()["documents"][annex]) if _own(annex) else ""


def is_unknown(annex: str | None) -> bool:
    """Return whether it was not found out what an annex to EN 1990 says."""
    return annex in action_parameters()["unknown"]


def _own(annex: str) -> dict[str, Any]:
    """Return the values that an annex has of its own, by their keys."""
    factors = {
        row["key"]: row["national"][annex] for row in action_parameters()["rows"] if annex in row.get("national", {})
    }
    return {key: tuple(value) if isinstance(value, list) else value for key, value in factors.items()}
