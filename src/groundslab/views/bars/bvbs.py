"""The bar list as benders read it: records of the BVBS guideline "Data exchange of reinforcement data" (BF2D).

A record is a line of blocks: H, the header (project j, drawing r, index i, position p, cut length l [mm], number n,
mass of one e [kg], diameter d [mm], steel g, mandrel s [mm]), G, the geometry (length l of each leg, outer sides [mm],
and the angle w to the next), and C, the checksum: 96 less the sum of all characters up to it, modulo 32.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from groundslab.design.bars.positions import U_SHAPE, Position, positions

if TYPE_CHECKING:
    from groundslab.model.model import Model

#: What a record begins with, and its parts between blocks.
KIND, SEPARATOR = "BF2D", "@"
_RECORD = re.compile(rf"{KIND}{SEPARATOR}H.*{SEPARATOR}C(\d+){SEPARATOR}")
#: A right angle between two legs [deg].
RIGHT = 90


def to_bvbs(model: Model) -> str:
    """Return the records of all straight and U-shaped bars that a model lays, without meshes and links."""
    listed = (position for position in positions(model) if not position.mesh)
    return "".join(f"{record}\r\n" for position in listed for record in _records(model, position))


def is_bvbs(text: str) -> bool:
    """Return whether a text holds records alone, each with its checksum."""
    lines = text.splitlines()
    matches = [_RECORD.fullmatch(line) for line in lines]
    return bool(lines) and all(
        match is not None and int(match[1]) == checksum(line[: match.start(1)])
        for match, line in zip(matches, lines, strict=True)
    )


def checksum(record: str) -> int:
    """Return the checksum of a record up to the letter C of its last block.

    Examples
    --------
    >>> checksum("abcde@C")
    78
    """
    return 96 - sum(record.encode("ascii")) % 32


def _records(model: Model, position: Position) -> Iterator[str]:
    """Yield the records of a position: one for each length, to the millimeter, numbered where there are several."""
    lengths, numbers = np.unique(np.rint(position.lengths * 1e3).astype(int), return_counts=True)
    for part, (length, number) in enumerate(zip(lengths[::-1].tolist(), numbers[::-1].tolist(), strict=True), 1):
        mark = f"{position.mark}" if len(lengths) == 1 else f"{position.mark}-{part}"
        yield _record(model, position, mark, int(length), int(number))


def _record(model: Model, position: Position, mark: str, length: int, number: int) -> str:
    """Return one record."""
    project, steel, diameter = model.project, model.reinforcement, position.bars.diameter
    assert steel is not None
    about = {
        "j": _plain((project.number or project.name) if project else ""),
        "r": "",  # drawings have no numbers here
        "i": _plain(project.revision if project else ""),
        "p": mark,
        "l": f"{length}",
        "n": f"{number}",
        "e": f"{position.mass / position.total * length / 1e3:.3f}",
        "d": f"{diameter * 1e3:g}",
        "g": steel.steel or f"{(steel.f_yk or 0.0) / 1e6:g}",
        "s": "" if (mandrel := least_mandrel(diameter, steel.code)) is None else f"{mandrel * 1e3:g}",
    }
    header = SEPARATOR.join(f"{key}{value}" for key, value in about.items())
    legs = [length]
    if position.shape == U_SHAPE:
        leg = round((position.lap or 0.0) * 1e3)
        legs = [leg, length - 2 * leg, leg]
    angles = [RIGHT] * (len(legs) - 1) + [0]
    geometry = SEPARATOR.join(f"l{leg}{SEPARATOR}w{angle}" for leg, angle in zip(legs, angles, strict=True))
    body = f"{KIND}{SEPARATOR}H{header}{SEPARATOR}G{geometry}{SEPARATOR}C"
    return f"{body}{checksum(body)}{SEPARATOR}"


def least_mandrel(diameter: float, code: str) -> float | None:
    """Return the least diameter of the mandrel [m] for a bar of some diameter [m], if it is known of a code here.

    EN 1992-1-1 (2004) Table 8.1N: 4 of bars up to 16 mm, else 7; ACI 318-19 Table 25.3.1: 6 up to No. 8, 8 up to
    No. 11, else 10.
    """
    if code == "EN 1992-1-1":
        return diameter * (4 if diameter <= 0.016 else 7)
    if code == "ACI 318":
        return diameter * (6 if diameter < 0.026 else 8 if diameter < 0.037 else 10)
    return None


def _plain(text: str) -> str:
    """Return a text in ASCII without what separates blocks."""
    letters = unicodedata.normalize("NFKD", text.replace("ß", "ss")).encode("ascii", "ignore").decode()
    return " ".join(letters.replace(SEPARATOR, " ").split())
