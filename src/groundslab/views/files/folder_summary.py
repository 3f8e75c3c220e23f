"""What summary.json says of a folder of results: its files, their checksums, its combinations."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from groundslab.errors import CertificateWithdrawn
from groundslab.storage import bounded, checksums
from groundslab.views.files import manifest

if TYPE_CHECKING:
    from collections.abc import Iterable

    from pydantic import TypeAdapter

FILE = "summary.json"
#: Largest summary that is read [bytes]; that of thousands of combinations is smaller.
LARGEST = 50_000_000


@dataclass(frozen=True, slots=True)
class RefusedCombination:
    """Why a combination has no certified result, as a summary says it."""

    error: str
    reason: str = ""
    what: str = ""
    history: tuple[Any, ...] = ()


@dataclass(frozen=True, slots=True)
class ListedCombination:
    """One combination, as a summary says it."""

    name: str
    limit_state: str
    factors: dict[str, float]
    folder: str | None = None
    refused: RefusedCombination | None = None


@dataclass(frozen=True, slots=True)
class Summary:
    """What a folder's summary says of the folder; its JSON text is held to these types."""

    program: Literal["groundslab"]
    files: tuple[str, ...]
    checksums: dict[str, str] = field(default_factory=dict)  # of the files as they were written
    combinations: tuple[ListedCombination, ...] | None = None


@cache
def _adapter() -> TypeAdapter[Summary]:
    """Return the type adapter that reads summary.json."""
    from pydantic import TypeAdapter

    return TypeAdapter(Summary)


def read_summary(folder: Path) -> Summary | None:
    """Return the summary in a folder, None if there is none that groundslab wrote."""
    path = folder / FILE
    try:
        return _adapter().validate_json(bounded.read_whole(path, LARGEST), strict=True) if path.is_file() else None
    except (OSError, ValueError):
        return None


def find_edited(folder: Path) -> list[str]:
    """Return the files of a folder that somebody has edited, as far as its summary knows them; raises OSError."""
    summary = read_summary(folder)
    if summary is None:
        return []
    others = {name: checksum for name, checksum in summary.checksums.items() if name != FILE and manifest.is_path(name)}
    edited = checksums.find_edited(folder, others)
    checksum = summary.checksums.get(FILE)
    return [*edited, FILE] if checksum is not None and checksum != _own_checksum(read_document(folder)) else edited


def require_unchanged(folder: Path) -> None:
    """Raise CertificateWithdrawn if files of a folder are not those whose checksums its summary has.

    Every reader asks this before it uses a number. A file that has no checksum there was put there by somebody else.
    """
    summary = read_summary(folder)
    recorded = {} if summary is None else summary.checksums
    present = (path.relative_to(folder).as_posix() for path in sorted(folder.rglob("*")) if path.is_file())
    changed = [*find_edited(folder), *(name for name in present if manifest.is_path(name) and name not in recorded)]
    if changed:
        raise CertificateWithdrawn(str(folder), changed)


def read_document(folder: Path) -> dict[str, Any]:
    """Return the summary in a folder as data, that of no files if there is none; raises OSError or ValueError."""
    path = folder / FILE
    if not path.is_file():
        return {"program": "groundslab", "files": []}
    return dict(json.loads(bounded.read_whole(path, LARGEST)))


def write_summary(folder: Path, document: dict[str, Any], written: Iterable[str]) -> None:
    """Write a summary with the checksums of files just written, its own, and those that it has of others."""
    recorded = document.pop("checksums", {}) | checksums.checksums_of(folder, written)
    document["checksums"] = recorded | {FILE: _own_checksum(document)}
    manifest.write_text(folder / FILE, json.dumps(document, indent=2, allow_nan=False) + "\n")


def _own_checksum(document: dict[str, Any]) -> str:
    """Return the checksum of what a summary says beside checksums, however it is laid out."""
    said = {name: value for name, value in document.items() if name != "checksums"}
    return sha256(json.dumps(said, sort_keys=True).encode()).hexdigest()
