"""Digests, the state folder, and listings for the file dialog."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue


def compute_digest(content: bytes) -> str:
    """Return the SHA-256 digest of a file's content."""
    return hashlib.sha256(content).hexdigest()


def create_state_folder() -> Path:
    """Return the user's folder for the state of this program, created if it is missing; raises InputError."""
    import platformdirs

    try:
        folder = platformdirs.user_state_path("groundslab", appauthor=False)
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    except (OSError, RuntimeError) as error:
        location = str(getattr(error, "filename", None) or "home")
        raise InputError([Issue(location, describe_error(error), "a folder for unsaved work")]) from None
    return folder


def list_folder(folder: Path) -> dict[str, Any]:
    """Return folders, case files, drawings, buildings and tables in a folder, none hidden; raises InputError."""
    folder = folder.expanduser().absolute()
    try:
        entries = [entry for entry in os.scandir(folder) if _is_listed(entry.name)]
        folders = sorted((entry.name for entry in entries if try_check(entry.is_dir)), key=str.casefold)
        names = {
            suffix: sorted(
                (entry.name for entry in entries if entry.name.lower().endswith(suffix) and try_check(entry.is_file)),
                key=str.casefold,
            )
            for suffix in (".toml", ".dxf", ".ifc", (".csv", ".xlsx"))
        }
    except OSError as error:
        raise InputError([Issue(str(folder), describe_error(error), "a folder that can be read")]) from None
    parent = None if folder.parent == folder else str(folder.parent)
    files = {
        "files": names[".toml"],
        "drawings": names[".dxf"],
        "buildings": names[".ifc"],
        "tables": names[".csv", ".xlsx"],
    }
    return {"folder": str(folder), "parent": parent, "folders": folders, **files}


def try_check(check: Callable[[], bool]) -> bool:
    """Return the result of a check of the file system, False if it raises an error."""
    try:
        return check()
    except (OSError, ValueError):
        return False


def _is_listed(name: str) -> bool:
    """Whether a name is neither hidden nor invalid Unicode."""
    return not name.startswith(".") and not any("\ud800" <= letter <= "\udfff" for letter in name)


def describe_error(error: Exception) -> str:
    """Return the message of an error, in lower case if it is one of the operating system."""
    return (error.strerror or str(error)).lower() if isinstance(error, OSError) else str(error)
