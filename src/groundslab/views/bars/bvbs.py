"""The bar list as benders read it: records of the BVBS guideline "Data exchange of reinforcement data" (BF2D).

A record is a line of blocks: H, the header (project j, drawing r, index i, position p, cut length l [mm], number n,
mass of one e [kg], diameter d [mm], steel g, mandrel s [mm], and v, which is reserved), G, the geometry (length l of
each leg, outer sides [mm], and the angle w to the next), and C, the checksum: 96 less the sum of all characters up to
it, modulo 32. This is version 3.1 of the guideline.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from typing import TYPE_CHECKING

from groundslab.design.bars.bending import STUD, BentBar, bent_bars, grade_of

if TYPE_CHECKING:
    from groundslab.design.rules.punching_links.layout import LinkLayout
    from groundslab.model.model import Model

#: What a record begins with, and its parts between blocks.
KIND, SEPARATOR = "BF2D", "@"
_RECORD = re.compile(rf"{KIND}{SEPARATOR}H.*{SEPARATOR}C(\d+){SEPARATOR}")


def to_bvbs(model: Model, links: Sequence[LinkLayout] = ()) -> str:
    """Return the records of all bars and links that are cut and bent: neither of meshes nor of studs."""
    bent = (bar for bar in bent_bars(model, links) if bar.shape != STUD)
    return "".join(f"{_record(model, bar)}\r\n" for bar in bent)


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


def _record(model: Model, bar: BentBar) -> str:
    """Return one record; every block of the header is there, empty where there is nothing to say."""
    project, steel = model.project, model.reinforcement
    assert steel is not None
    legs = [round(leg * 1e3) for leg in bar.legs]
    about = {
        "j": _plain((project.number or project.name) if project else ""),
        "r": "",  # drawings have no numbers here
        "i": _plain(project.revision if project else ""),
        "p": bar.mark,
        "l": f"{sum(legs)}",
        "n": f"{bar.number}",
        "e": f"{bar.one_mass:.3f}",
        "d": f"{bar.diameter * 1e3:g}",
        "g": _plain(grade_of(steel)),
        "s": "" if bar.mandrel is None else f"{bar.mandrel * 1e3:g}",
        "v": "",  # reserved
    }
    header = SEPARATOR.join(f"{key}{value}" for key, value in about.items())
    geometry = SEPARATOR.join(f"l{leg}{SEPARATOR}w{angle}" for leg, angle in zip(legs, (*bar.bends, 0), strict=True))
    body = f"{KIND}{SEPARATOR}H{header}{SEPARATOR}G{geometry}{SEPARATOR}C"
    return f"{body}{checksum(body)}{SEPARATOR}"


def _plain(text: str) -> str:
    """Return a text in ASCII without what separates blocks."""
    letters = unicodedata.normalize("NFKD", text.replace("ß", "ss")).encode("ascii", "ignore").decode()
    return " ".join(letters.replace(SEPARATOR, " ").split())
