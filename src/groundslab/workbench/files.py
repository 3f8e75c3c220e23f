"""Fingerprints of files, folders of the user, and what can be chosen in a folder."""

from __future__ import annotations

import hashlib
import os
import sys
from pathlib import Path
from typing import Any

from groundslab.errors import Fault, InputError


def digest(content: bytes) -> str:
    """Return a fingerprint of a file's bytes."""
    return hashlib.sha256(content).hexdigest()


def state_folder() -> Path:
    """Return the folder in which a program keeps what it must remember for the user, made if it is missing."""
    home = Path.home()
    if sys.platform == "win32":
        above = Path(os.environ.get("LOCALAPPDATA") or home / "AppData" / "Local")
    elif sys.platform == "darwin":
        above = home / "Library" / "Application Support"
    else:
        above = Path(os.environ.get("XDG_STATE_HOME") or home / ".local" / "state")
    folder = above / "groundslab"
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    return folder


def listing(folder: Path) -> dict[str, Any]:
    """Return the folders and case files in a folder, hidden ones left out; raises InputError."""
    folder = folder.expanduser().absolute()
    try:
        entries = [entry for entry in os.scandir(folder) if not entry.name.startswith(".")]
        folders = sorted((entry.name for entry in entries if entry.is_dir()), key=str.casefold)
        files = [entry.name for entry in entries if entry.name.lower().endswith(".toml") and entry.is_file()]
    except OSError as error:
        raise InputError([Fault(str(folder), reason(error), "a folder that can be read")]) from None
    parent = None if folder.parent == folder else str(folder.parent)
    return {"folder": str(folder), "parent": parent, "folders": folders, "files": sorted(files, key=str.casefold)}


def reason(error: OSError) -> str:
    """Return in words why the system said no."""
    return (error.strerror or str(error)).lower()
