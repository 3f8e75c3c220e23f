"""Folders of results that something has damaged: arrays, JSON, archives, for tests of who reads them."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

#: What may become of an array; each makes it one that no analysis gives.
ARRAYS: dict[str, Callable[[Any], Any]] = {
    "short": lambda a: a[:-1],
    "empty": lambda a: a[:0],
    "a number": lambda _: np.float64(1.0),
    "longer": lambda a: np.concatenate([a, a]),
    "another dimension": lambda a: a[..., None],
    "not a number": lambda a: a * np.nan,
    "infinite": lambda a: a + np.inf,
    "huge": lambda a: 1e300 * (1 + np.abs(a.astype(float))),
    "text": lambda a: a.astype(str),
    "complex": lambda a: a.astype(complex),
    "single precision": lambda a: a.astype(np.float32),
    "objects": lambda a: a.astype(object),
}
#: What may stand in place of a value in JSON.
VALUES: tuple[Any, ...] = ("text", None, [], {}, -1, float("nan"), float("inf"), 10**400, 10**30, [1, 2, 3], True)


def arrays(archive: Path) -> dict[str, Any]:
    """Return the arrays of an archive."""
    with np.load(archive) as stored:
        return {name: stored[name] for name in stored.files}


def store(archive: Path, found: dict[str, Any]) -> None:
    """Write arrays into an archive."""
    with archive.open("wb") as file:
        np.savez(file, **found)


def places(value: Any, above: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the paths of all values within data of JSON."""
    if above:
        yield above
    pairs = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for name, each in pairs:
        yield from places(each, (*above, name))


def put(data: Any, place: tuple[Any, ...], value: Any) -> None:
    """Put a value at a place within data of JSON."""
    for name in place[:-1]:
        data = data[name]
    data[place[-1]] = value


def with_array(archive: Path, name: str, change: Callable[[Any], Any]) -> None:
    """Change one array of an archive."""
    found = arrays(archive)
    store(archive, found | {name: change(found[name])})


def with_about(archive: Path, place: tuple[Any, ...], value: Any) -> None:
    """Change one value of an archive's JSON text."""

    def change(text: Any) -> Any:
        about = json.loads(str(text))
        put(about, place, value)
        return np.array(json.dumps(about))

    with_array(archive, "about", change)


def bomb(archive: Path) -> None:
    """Write an archive of few bytes that says it holds terabytes."""
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed, packed.open("about.npy", "w") as file:
        np.lib.format.write_array_header_1_0(file, {"descr": "<f8", "fortran_order": False, "shape": (10**12,)})  # type: ignore[no-untyped-call]
        file.write(bytes(50_000_000))


def boast(archive: Path) -> None:
    """Let the header of one array of an archive say that it is much longer than its bytes."""
    content = archive.read_bytes()
    long = content.replace(b"'shape': (25,), }           ", b"'shape': (25000000000,), }  ", 1)
    assert long != content
    archive.write_bytes(long)


#: What may become of the files of a folder of one combination.
FILES: dict[str, Callable[[Path], object]] = {
    "cut": lambda folder: (folder / "results.npz").write_bytes((folder / "results.npz").read_bytes()[:5000]),
    "empty": lambda folder: (folder / "results.npz").write_bytes(b""),
    "one bit": lambda folder: _flip(folder / "results.npz"),
    "bomb": lambda folder: bomb(folder / "results.npz"),
    "boast": lambda folder: boast(folder / "results.npz"),
    "no archive": lambda folder: (folder / "results.npz").unlink(),
    "a folder": lambda folder: ((folder / "results.npz").unlink(), (folder / "results.npz").mkdir()),
    "deep": lambda folder: with_array(folder / "results.npz", "about", lambda _: np.array("[" * 100_000)),
    "deep description": lambda folder: with_array(
        folder / "results.npz", "model", lambda _: np.array("x = " + "[" * 100_000)
    ),
    "another plate": lambda folder: with_array(
        folder / "results.npz", "model", lambda text: np.array(str(text).replace('"9.6 m"', '"9.7 km"'))
    ),
    "deep summary": lambda folder: (folder / "summary.json").write_text('{"a":' * 100_000),
    "no summary": lambda folder: (folder / "summary.json").unlink(),
    "a list": lambda folder: (folder / "summary.json").write_text("[1]"),
    "not UTF-8": lambda folder: (folder / "summary.json").write_bytes(b"\xff\xfe\0"),
}


def _flip(archive: Path) -> None:
    """Change one bit of one number."""
    content = bytearray(archive.read_bytes())
    content[300] ^= 1
    archive.write_bytes(bytes(content))
